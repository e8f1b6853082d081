/** Where sparse accessors put their values: at elements that there are. */
import type { ProblemList } from '../../scene-file/problem.ts';
import { type Gltf, SIZES } from '../json.ts';
import { addProblem } from '../problems.ts';
import { meshoptOf } from './spans.ts';

/** Spans have been checked. What is compressed is not looked at. */
export function checkSparsePlaces(
  { accessors = [], bufferViews = [] }: Gltf,
  buffers: readonly (Uint8Array | null)[],
  problems: ProblemList,
): void {
  accessors.forEach(({ sparse, count }, index) => {
    if (!sparse) return;
    const { bufferView, byteOffset = 0, componentType } = sparse.indices;
    const view = bufferViews[bufferView]!;
    const buffer = buffers[view.buffer];
    if (!buffer || meshoptOf(view)) return;
    const size = SIZES[componentType]!;
    const start = buffer.byteOffset + (view.byteOffset ?? 0) + byteOffset;
    const data = new DataView(buffer.buffer, start, sparse.count * size);
    for (let i = 0; i < sparse.count; i++) {
      const place =
        size === 1 ? data.getUint8(i) : size === 2 ? data.getUint16(2 * i, true) : data.getUint32(4 * i, true);
      if (place < count) continue;
      addProblem(
        problems,
        ['accessors', index, 'sparse', 'indices'],
        `the place ${place}`,
        `0 to ${count - 1}, as there are ${count} elements`,
      );
      return;
    }
  });
}
