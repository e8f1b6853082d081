/** The vertices of a PLY file: places, and whatever else of them a mesh may have. */
import { srgbToLinear } from '../../display/srgb.ts';
import { FARTHEST_VERTEX } from '../../scene/mesh-fault.ts';
import { quote } from '../../scene-file/problem.ts';
import { checkCount, type FileProblems } from '../file-problems.ts';
import type { PlyElement, PlyProperty, PlyType } from './header.ts';
import type { PlyValues } from './values.ts';

export interface PlyVertices {
  readonly positions: Float32Array;
  readonly normals?: Float32Array;
  readonly uvs?: Float32Array;
  readonly colors?: Float32Array;
  /** Names of properties that nothing was made of. */
  readonly unused: readonly string[];
}

/** What programs call the properties; of several names for one thing the first that the file has counts. */
const POSITION = [['x'], ['y'], ['z']];
const NORMAL = [['nx', 'normal_x'], ['ny', 'normal_y'], ['nz', 'normal_z']]; // biome-ignore format: short
const UV = [['s', 'u', 'texture_u', 'texcoord_u'], ['t', 'v', 'texture_v', 'texcoord_v']]; // biome-ignore format: short
const COLOR = [['red', 'r', 'diffuse_red'], ['green', 'g', 'diffuse_green'], ['blue', 'b', 'diffuse_blue']]; // biome-ignore format: short
const ALPHA = [['alpha', 'a']];

/** Where a row's number goes: which array, and at what place of the vertex. */
interface Target {
  readonly to: Float32Array;
  readonly stride: number;
  readonly place: number;
  readonly property: number;
  readonly convert: (x: number) => number;
}

export function readVertices(element: PlyElement, values: PlyValues, problems: FileProblems): PlyVertices {
  const { count, properties, line } = element;
  const find = (names: readonly string[][]) => names.map((some) => indexOf(properties, some));
  const xyz = find(POSITION);
  if (xyz.includes(-1)) problems.fail({ line }, 'vertices without "x", "y" and "z"', 'all three as numbers');
  checkCount('vertices', count, { line }, problems);
  values.expectRows(element);
  const targets: Target[] = [];
  const take = (parts: readonly number[], convert: (type: PlyType) => (x: number) => number = () => same) => {
    if (parts.includes(-1)) return undefined;
    const to = new Float32Array(count * parts.length);
    parts.forEach((property, place) => {
      targets.push({ to, stride: parts.length, place, property, convert: convert(properties[property]!.type) });
    });
    return to;
  };
  const positions = take(xyz)!;
  const normals = take(find(NORMAL));
  const uvs = take(find(UV));
  const rgb = take(find(COLOR), colorOf);
  const alpha = rgb && take(find(ALPHA), shareOf);
  const used = new Set(targets.map(({ property }) => property));
  readRows(element, values, targets, problems);
  // Our images begin in their upper left corner, those of these files in the lower left one.
  for (let k = 1; uvs && k < uvs.length; k += 2) uvs[k] = 1 - uvs[k]!;
  return {
    positions,
    ...(normals ? { normals } : {}),
    ...(uvs ? { uvs } : {}),
    ...(rgb ? { colors: withAlpha(rgb, alpha) } : {}),
    unused: properties.filter((_, k) => !used.has(k)).map(({ name }) => name),
  };
}

const indexOf = (properties: readonly PlyProperty[], names: readonly string[]): number =>
  names.reduce((at, name) => (at >= 0 ? at : properties.findIndex((p) => p.name === name && p.count === null)), -1);

const same = (x: number): number => x;

/** Bytes and the like are what screens show; numbers with a point are light. */
const colorOf = (type: PlyType) => {
  const share = shareOf(type);
  return type === 'f32' || type === 'f64' ? same : (x: number) => srgbToLinear(share(x));
};
const LARGEST: Partial<Record<PlyType, number>> = { i16: 32767, u16: 65535 };
const shareOf = (type: PlyType) => {
  if (type === 'f32' || type === 'f64') return same;
  const most = LARGEST[type] ?? 255;
  return (x: number) => Math.min(Math.max(x / most, 0), 1);
};

function withAlpha(rgb: Float32Array, alpha: Float32Array | undefined): Float32Array {
  const colors = new Float32Array((rgb.length / 3) * 4).fill(1);
  for (let vertex = 0; vertex < rgb.length / 3; vertex++) {
    colors.set(rgb.subarray(3 * vertex, 3 * vertex + 3), 4 * vertex);
    if (alpha) colors[4 * vertex + 3] = alpha[vertex]!;
  }
  return colors;
}

function readRows(
  { count, properties }: PlyElement,
  values: PlyValues,
  targets: readonly Target[],
  problems: FileProblems,
) {
  const row = new Float64Array(properties.length);
  const places = targets.slice(0, 3);
  for (let vertex = 0; vertex < count; vertex++) {
    values.startRow();
    for (let k = 0; k < properties.length; k++) row[k] = nextOf(properties[k]!, values, problems);
    for (const { to, stride, place, property, convert } of targets)
      to[vertex * stride + place] = convert(row[property]!);
    for (const { property } of places) {
      const x = row[property]!;
      if (Math.abs(x) <= FARTHEST_VERTEX) continue;
      const axis = quote(properties[property]!.name);
      problems.add(values.place, `${x} as ${axis} of vertex ${vertex}`, 'a number from -1e9 to 1e9');
    }
  }
}

/** The value of a number; of a list, which nobody asks for here, nothing. */
function nextOf({ type, count }: PlyProperty, values: PlyValues, problems: FileProblems): number {
  if (count === null) return values.next(type);
  const items = itemsOf(count, type, values, problems);
  for (let k = 0; k < items; k++) values.next(type);
  return Number.NaN;
}

/** How many items of a list follow. */
export function itemsOf(count: PlyType, type: PlyType, values: PlyValues, problems: FileProblems): number {
  const items = values.next(count);
  if (!Number.isInteger(items) || items < 0)
    problems.fail(values.place, `${items} as the length of a list`, 'a whole number from 0 on');
  values.expectItems(items, type);
  return items;
}

/** Goes past an element that nobody asks for. */
export function skipElement(element: PlyElement, values: PlyValues, problems: FileProblems): void {
  values.expectRows(element);
  if (values.skipRows(element)) return;
  for (let row = 0; row < element.count; row++) {
    values.startRow();
    for (const property of element.properties) nextOf(property, values, problems);
  }
}
