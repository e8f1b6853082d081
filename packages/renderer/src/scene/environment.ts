/** The sky as a picture of all around: its form, how large it may be, and what direction a place in it has. */
import type { Sky, Vec3 } from './scene.ts';

/**
 * Light from all directions as a latitude-longitude picture, linear Rec.709, row 0 on top. The direction (x, y, z) lies at
 * u = atan2(x, −z) / 2π modulo 1 of its width and v = acos(y) / π of its height: −Z at both sides, +X at a quarter, +Z in the middle.
 * Texel (i, j) has its centre at ((i + ½) / width, (j + ½) / height); between centres the map is bilinear, from side to side without a
 * seam. Data that is in use must not change.
 */
export interface EnvironmentMap {
  readonly width: number;
  readonly height: number;
  /** Radiance, red, green, blue, of one texel after the other. */
  readonly data: Float32Array;
}

/** What every device can be relied on to hold, and what the kernels count with: 16 bytes a texel, and half as much for sampling. */
export const MOST_COLUMNS = 4096;
export const MOST_ROWS = 2048;
/** Largest radiance of a texel: squares of it are still numbers of 32 bits. */
export const MOST_RADIANCE = 1e12;

/** What is wrong with a map, in words that follow "the map has", or null. */
export function environmentFault({ width, height, data }: EnvironmentMap): string | null {
  const isSide = (side: number, most: number) => Number.isInteger(side) && side >= 1 && side <= most;
  if (!isSide(width, MOST_COLUMNS) || !isSide(height, MOST_ROWS))
    return `a size of ${width} × ${height}, where at most ${MOST_COLUMNS} × ${MOST_ROWS} texels are allowed`;
  if (!(data instanceof Float32Array)) return 'data that is no Float32Array';
  if (data.length !== width * height * 3)
    return `${data.length} numbers, where ${width} × ${height} texels need ${width * height * 3}`;
  let strange = 0;
  while (strange < data.length && data[strange]! >= 0 && data[strange]! <= MOST_RADIANCE) strange++;
  if (strange === data.length) return null;
  const texel = Math.floor(strange / 3);
  return `the radiance ${data[strange]} in column ${texel % width} of row ${Math.floor(texel / width)}, where 0 to 1e12 is allowed`;
}

/** Whether the scene names a picture that has not been loaded. */
export const lacksMap = ({ image, map }: Sky): boolean => image !== undefined && map === undefined;

/** The unit direction at (u, v) of a map that is not turned. */
export function environmentDirection(u: number, v: number): Vec3 {
  const [phi, theta] = [2 * Math.PI * u, Math.PI * v];
  return [Math.sin(theta) * Math.sin(phi), Math.cos(theta), -Math.sin(theta) * Math.cos(phi)];
}
