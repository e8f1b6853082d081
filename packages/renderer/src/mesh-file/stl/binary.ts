import { FARTHEST_VERTEX } from '../../scene/mesh-fault.ts';
import { checkCount, type FileProblems, WHOLE } from '../file-problems.ts';
import type { Triangles } from './read-stl.ts';

const HEADER = 84;
/** Twelve floats, the normal's first, and two bytes that some programs keep a colour in. */
const TRIANGLE = 50;

export function readBinaryTriangles(bytes: Uint8Array, problems: FileProblems): Triangles {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < HEADER) problems.fail(WHOLE, `${bytes.length} bytes`, `at least the ${HEADER} of a header`);
  const count = view.getUint32(80, true);
  const there = Math.floor((bytes.length - HEADER) / TRIANGLE);
  if (count > there)
    problems.fail({ byte: 80 }, `${count} as the number of triangles, and bytes for ${there}`, `at most ${there}`);
  checkCount('triangles', count, { byte: 80 }, problems);
  const corners = new Float32Array(9 * count);
  for (let triangle = 0; triangle < count; triangle++) {
    const at = HEADER + TRIANGLE * triangle + 12;
    for (let k = 0; k < 9; k++) {
      const x = view.getFloat32(at + 4 * k, true);
      if (!(Math.abs(x) <= FARTHEST_VERTEX))
        problems.add({ byte: at + 4 * k }, `the coordinate ${x} in triangle ${triangle}`, 'a number from -1e9 to 1e9');
      corners[9 * triangle + k] = x;
    }
  }
  const beyond = bytes.length - HEADER - TRIANGLE * count;
  return { corners, notes: beyond === 0 ? [] : [`Nothing is made of ${beyond} bytes after the last triangle.`] };
}
