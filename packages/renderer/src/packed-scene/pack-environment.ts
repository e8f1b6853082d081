/**
 * The sky's map → the texture that the kernels look up and sample (shading/light/emitter/environment.wesl). The upper rows are the
 * map: radiance, and in alpha the density of directions times sin θ at the texel's centre. Below lies the alias table of the cells
 * between texel centres, (height + 1) rows of them, two rows of cells in one row of texels: the cell's own share and, when that is
 * not taken, which other cell is. 24 bytes a texel in all: 48 MiB for 2048 × 1024, 192 MiB for 4096 × 2048.
 */
import { type EnvironmentMap, environmentFault } from '../scene/environment.ts';
import { aliasTable, sumOf } from './alias-table.ts';

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

/** Texture rows that a map of this height needs. */
export const environmentRows = (height: number): number => height + Math.ceil((height + 1) / 2);

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
  const rows = environmentRows(height);
  const texels = new Float32Array(width * rows * 4);
  const weights = weightsOf(map);
  const cells = cellsOf(weights, width, height);
  const total = sumOf(cells);
  const cellSize = ((2 * Math.PI) / width) * (Math.PI / height);
  const meanRadiance = (total * cellSize) / (4 * Math.PI);
  // Millions of texels: no calls in here.
  for (let k = 0; k < width * height; k++) {
    texels[4 * k] = data[3 * k]!;
    texels[4 * k + 1] = data[3 * k + 1]!;
    texels[4 * k + 2] = data[3 * k + 2]!;
    texels[4 * k + 3] = total > 0 ? weights[k]! / (total * cellSize) : 0;
  }
  if (total > 0) writeTable(texels, cells, width, height);
  return { width, height, rows, texels, meanRadiance };
}

function writeTable(texels: Float32Array, cells: Float64Array, width: number, height: number): void {
  const { own, other } = aliasTable(cells);
  const firstHalf = width * Math.floor((height + 2) / 2);
  for (let k = 0; k < cells.length; k++) {
    const second = k >= firstHalf;
    const at = 4 * (width * height + k - (second ? firstHalf : 0)) + (second ? 2 : 0);
    texels[at] = own[k]!;
    texels[at + 1] = other[k]!;
  }
}
