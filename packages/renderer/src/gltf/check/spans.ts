/** Whether the parts of buffers that a file names lie in them. Numbers are safe integers, so that sums are exact. */
import type { ProblemList } from '../../scene-file/problem.ts';
import { type AccessorJson, extensionOf, type Gltf, SIZES, WIDTHS } from '../json.ts';
import { addProblem, type Path } from '../problems.ts';

export interface MeshoptJson {
  readonly buffer: number;
  readonly byteOffset?: number;
  readonly byteLength: number;
  readonly byteStride: number;
  readonly count: number;
  readonly mode: 'ATTRIBUTES' | 'TRIANGLES' | 'INDICES';
}

/** Buffer views that have been compressed stand for what comes out. */
export const meshoptOf = (view: object): MeshoptJson | undefined =>
  extensionOf<MeshoptJson>(view, 'EXT_meshopt_compression');

/** Whether a buffer only stands for what a decoder will make. */
const isFallback = (buffer: object): boolean =>
  extensionOf<{ fallback?: boolean }>(buffer, 'EXT_meshopt_compression')?.fallback === true;

export function checkSpans(json: Gltf, problems: ProblemList): void {
  const { buffers = [], bufferViews = [], accessors = [] } = json;
  bufferViews.forEach((view, i) => {
    const meshopt = meshoptOf(view);
    const path = ['bufferViews', i];
    if (!meshopt || !isFallback(buffers[view.buffer]!))
      checkEnd(
        problems,
        [...path, 'byteLength'],
        view.byteOffset ?? 0,
        view.byteLength,
        buffers[view.buffer]!.byteLength,
        `buffer ${view.buffer}`,
      );
    if (meshopt)
      checkMeshopt(problems, [...path, 'extensions', 'EXT_meshopt_compression'], meshopt, view.byteLength, json);
  });
  accessors.forEach((accessor, i) => {
    checkAccessor(problems, ['accessors', i], accessor, json);
  });
}

function checkEnd(
  problems: ProblemList,
  path: Path,
  offset: number,
  length: number,
  there: number,
  whose: string,
): void {
  if (offset + length <= there) return;
  addProblem(problems, path, `bytes ${offset} to ${offset + length} of ${whose}`, `bytes up to its end at ${there}`);
}

/** What meshoptimizer's formats need at least: a byte an index or triangle, two bits for sixteen equal bytes of vertices. */
function leastBytes({ mode, count, byteStride }: MeshoptJson): number {
  if (mode === 'TRIANGLES') return count / 3;
  if (mode === 'INDICES') return count;
  return (count * byteStride) / 1024;
}

function checkMeshopt(problems: ProblemList, path: Path, meshopt: MeshoptJson, byteLength: number, json: Gltf): void {
  const { buffer, byteOffset = 0, count, byteStride, mode } = meshopt;
  const there = json.buffers![buffer]!.byteLength;
  checkEnd(problems, [...path, 'byteLength'], byteOffset, meshopt.byteLength, there, `buffer ${buffer}`);
  if (count * byteStride !== byteLength)
    addProblem(
      problems,
      [...path, 'count'],
      `${count} elements of ${byteStride} bytes`,
      `the ${byteLength} bytes of the buffer view`,
    );
  if (leastBytes(meshopt) > meshopt.byteLength)
    addProblem(
      problems,
      [...path, 'count'],
      `${count} elements in ${meshopt.byteLength} bytes`,
      'what compression can hold in so many bytes',
    );
  const strides = mode === 'ATTRIBUTES' ? byteStride % 4 === 0 : byteStride === 2 || byteStride === 4;
  if (!strides)
    addProblem(
      problems,
      [...path, 'byteStride'],
      String(byteStride),
      mode === 'ATTRIBUTES' ? 'a multiple of 4' : '2 or 4',
    );
  if (mode === 'TRIANGLES' && count % 3 !== 0)
    addProblem(problems, [...path, 'count'], String(count), 'a multiple of 3');
}

function checkAccessor(problems: ProblemList, path: Path, accessor: AccessorJson, json: Gltf): void {
  const { bufferView, byteOffset = 0, count, sparse } = accessor;
  const size = WIDTHS[accessor.type]! * SIZES[accessor.componentType]!;
  if (bufferView !== undefined) {
    const { byteLength, byteStride } = json.bufferViews![bufferView]!;
    const stride = byteStride ?? size;
    if (stride < size) addProblem(problems, ['bufferViews', bufferView, 'byteStride'], String(stride), `at least the ${size} bytes of an element of accessor ${path[1]}`); // biome-ignore format: short
    checkEnd(
      problems,
      [...path, 'count'],
      byteOffset,
      stride * (count - 1) + size,
      byteLength,
      `buffer view ${bufferView}`,
    );
  }
  if (sparse) checkSparse(problems, [...path, 'sparse'], accessor, size, json);
}

function checkSparse(
  problems: ProblemList,
  path: Path,
  { sparse, count }: AccessorJson,
  size: number,
  json: Gltf,
): void {
  const { indices, values } = sparse!;
  if (sparse!.count > count)
    addProblem(problems, [...path, 'count'], String(sparse!.count), `at most the ${count} of the accessor`);
  const span = (
    part: 'indices' | 'values',
    { bufferView, byteOffset = 0 }: { bufferView: number; byteOffset?: number },
    bytes: number,
  ) => {
    const view = json.bufferViews![bufferView]!;
    checkEnd(
      problems,
      [...path, part],
      byteOffset,
      bytes * sparse!.count,
      view.byteLength,
      `buffer view ${bufferView}`,
    );
  };
  span('indices', indices, SIZES[indices.componentType]!);
  span('values', values, size);
}
