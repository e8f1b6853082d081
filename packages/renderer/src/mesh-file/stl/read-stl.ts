/** STL ("stereolithography", 3D Systems 1988): triangles that share nothing, as text or as bytes. */
import { SCENE_LIMITS } from '../../scene/limits.ts';
import { type FileProblems, reading, WHOLE } from '../file-problems.ts';
import { finishMesh } from '../finish-mesh.ts';
import type { MeshContent, MeshFile } from '../mesh-file.ts';
import { notesOf } from '../notes.ts';
import { weld } from '../weld.ts';
import { readBinaryTriangles } from './binary.ts';
import { readTextTriangles } from './text.ts';

/** Three corners of each triangle, x, y, z each. */
export interface Triangles {
  readonly corners: Float32Array;
  readonly notes: string[];
}

/**
 * One part without normals: those in the file are of whole triangles, which their corners have too. Corners at exactly the same place
 * become one vertex. Never throws, whatever the bytes are.
 */
export const readStl = (bytes: Uint8Array, name: string): MeshFile =>
  reading(name, (problems) => readContent(bytes, problems));

function readContent(bytes: Uint8Array, problems: FileProblems): MeshContent {
  const { corners, notes } = isText(bytes) ? readTextTriangles(bytes, problems) : readBinaryTriangles(bytes, problems);
  if (!problems.isEmpty) problems.stop();
  if (corners.length === 0) problems.fail(WHOLE, 'no triangles', 'triangles');
  const { positions, indices } = welded(corners);
  // Corners are checked by their number; vertices are never more.
  const { mesh, degenerate } = finishMesh({ positions, indices });
  if (mesh === null) return problems.fail(WHOLE, `${degenerate} triangles, none of which has an area`, 'triangles');
  if (mesh.positions.length / 3 > SCENE_LIMITS.meshVertices)
    problems.fail(WHOLE, `${mesh.positions.length / 3} vertices`, `at most ${SCENE_LIMITS.meshVertices} of them`);
  const all = [...notes, ...notesOf({ degenerate, mended: 0, tiny: 0 })];
  return { parts: [{ name: '', mesh }], degenerate, materialFiles: [], notes: all };
}

const HEADER = 84;
const TRIANGLE = 50;

/**
 * A text begins with "solid"; alas, so do many files of bytes, whose first 80 may be anything. Those are as long as they say, and what
 * follows "solid" there is no text with a facet in it.
 */
function isText(bytes: Uint8Array): boolean {
  const start = new TextDecoder('latin1').decode(bytes.subarray(0, 1024)).trimStart();
  if (!/^solid/i.test(start)) return false;
  if (bytes.length >= HEADER) {
    const count = new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
    if (bytes.length === HEADER + TRIANGLE * count) return false;
  }
  // biome-ignore lint/suspicious/noControlCharactersInRegex: what no text holds
  return /facet|endsolid/i.test(start) || !/[\u0000-\u0008\u000e-\u001f]/.test(start);
}

function welded(corners: Float32Array): { positions: Float32Array; indices: Uint32Array } {
  const { placeOf, places } = weld(corners);
  const positions = new Float32Array(3 * places);
  for (let corner = placeOf.length - 1; corner >= 0; corner--)
    for (let c = 0; c < 3; c++) positions[3 * placeOf[corner]! + c] = corners[3 * corner + c]!;
  return { positions, indices: placeOf };
}
