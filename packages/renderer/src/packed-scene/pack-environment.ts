/**
 * The sky's map → the texture that the kernels look up and sample (shading/light/emitter/environment.wesl). The upper rows are the
 * map: radiance, and in alpha the density of directions times sin θ at the texel's centre. Below, two entries a texel, lie the tables
 * that choose one of the (height + 1) rows of cells between texel centres, and in each row one of its cells. 24 bytes a texel in all:
 * 48 MiB for 2048 × 1024, 192 MiB for 4096 × 2048.
 */
import { type EnvironmentMap, environmentFault } from '../scene/environment.ts';
import { sumOf } from './alias-table.ts';
import { inversionTableSize, writeInversionTable } from './inversion-table.ts';

export interface PackedEnvironment {
  /** Of the map. */
  readonly width: number;
  readonly height: number;
  /** Of the texture, which is as wide as the map. */
  readonly rows: number;
  readonly texels: Float32Array<ArrayBuffer>;
  /** Mean over all directions of the mean of red, green and blue. */
  readonly meanRadiance: number;
}

/** Texture rows that a map of this size needs. */
export const environmentRows = (width: number, height: number): number =>
  height + Math.ceil((inversionTableSize(height + 1) + (height + 1) * inversionTableSize(width)) / (4 * width));

const packed = new WeakMap<EnvironmentMap, PackedEnvironment>();

/** The same for the same map: it is made once. Throws a RangeError for what is no map. */
export function packEnvironment(map: EnvironmentMap): PackedEnvironment {
  let result = packed.get(map);
  if (!result) {
    const fault = environmentFault(map);
    if (fault !== null) throw new RangeError(`The sky's map has ${fault}.`);
    packed.set(map, (result = pack(map)));
  }
  return result;
}

/** A white map: rows enough that the bilinear sine in its density is a sine up to 3e-4. */
const WHITE: EnvironmentMap = { width: 1, height: 64, data: new Float32Array(64 * 3).fill(1) };
/** For skies without a map. */
export const noEnvironment = (): PackedEnvironment => packEnvironment(WHITE);

/** Mean of the channels times sin θ at each texel's centre. */
function weightsOf({ width, height, data }: EnvironmentMap): Float64Array {
  const weights = new Float64Array(width * height);
  for (let j = 0, k = 0; j < height; j++) {
    const sine = Math.sin((Math.PI * (j + 0.5)) / height) / 3;
    for (let i = 0; i < width; i++, k++) weights[k] = sine * (data[3 * k]! + data[3 * k + 1]! + data[3 * k + 2]!);
  }
  return weights;
}

/**
 * The weights of what is brighter than the map in the mean, and by how much: Karlík, Šik, Vévoda, Skřivan & Křivánek, "MIS Compensation:
 * Optimizing Sampling Techniques in Multiple Importance Sampling", SIGGRAPH Asia 2019. What all directions have alike is found by the
 * BSDF anyway; light sampling is for the sun.
 */
function compensated(weights: Float64Array, width: number, height: number): Float64Array {
  const sines = Float64Array.from({ length: height }, (_, j) => Math.sin((Math.PI * (j + 0.5)) / height));
  const mean = sumOf(weights) / (width * sumOf(sines));
  const rest = new Float64Array(weights.length);
  for (let j = 0, k = 0; j < height; j++)
    for (let i = 0; i < width; i++, k++) rest[k] = Math.max(weights[k]! - mean * sines[j]!, 0);
  return rest;
}

/** Of a map that is nearly the same everywhere there is nothing left to compensate but rounding: then it is sampled as it is. */
const LEAST_LEFT = 1e-3;

/**
 * Integrals of the bilinear weights over the cells, in cells of full size. In the half cells at the poles the weight goes from 0 at the
 * pole to that of the first row.
 */
function cellsOf(weights: Float64Array, width: number, height: number): Float64Array {
  const cells = new Float64Array(width * (height + 1));
  for (let j = 0; j <= height; j++) {
    const upper = Math.max(j - 1, 0) * width;
    const lower = Math.min(j, height - 1) * width;
    // At a pole both rows are the same one, and the weight is half of it in the mean, over half a cell.
    const share = j === 0 || j === height ? 1 / 16 : 1 / 4;
    for (let i = 0; i < width; i++) {
      const left = (i + width - 1) % width;
      const sum = weights[upper + left]! + weights[upper + i]! + weights[lower + left]! + weights[lower + i]!;
      cells[j * width + i] = share * sum;
    }
  }
  return cells;
}

function pack(map: EnvironmentMap): PackedEnvironment {
  const { width, height, data } = map;
  const rows = environmentRows(width, height);
  const texels = new Float32Array(width * rows * 4);
  let weights = weightsOf(map);
  let cells = cellsOf(weights, width, height);
  let total = sumOf(cells);
  const cellSize = ((2 * Math.PI) / width) * (Math.PI / height);
  const meanRadiance = (total * cellSize) / (4 * Math.PI);
  const left = compensated(weights, width, height);
  if (sumOf(left) > LEAST_LEFT * sumOf(weights)) {
    weights = left;
    cells = cellsOf(weights, width, height);
    total = sumOf(cells);
  }
  // Millions of texels: no calls in here.
  for (let k = 0; k < width * height; k++) {
    texels[4 * k] = data[3 * k]!;
    texels[4 * k + 1] = data[3 * k + 1]!;
    texels[4 * k + 2] = data[3 * k + 2]!;
    texels[4 * k + 3] = total > 0 ? weights[k]! / (total * cellSize) : 0;
  }
  if (total > 0) writeTables(texels, cells, width, height);
  return { width, height, rows, texels, meanRadiance };
}

/** First which row, then for each row which cell of it. */
function writeTables(texels: Float32Array, cells: Float64Array, width: number, height: number): void {
  const rowOf = (j: number) => cells.subarray(j * width, (j + 1) * width);
  const masses = Float64Array.from({ length: height + 1 }, (_, j) => sumOf(rowOf(j)));
  let at = 4 * width * height;
  writeInversionTable(texels, at, masses);
  at += inversionTableSize(height + 1);
  for (let j = 0; j <= height; j++, at += inversionTableSize(width)) writeInversionTable(texels, at, rowOf(j));
}
