/** The sky's map in double precision, straight from its definition: what shading/light/emitter/environment.wesl is tested against. */
import type { EnvironmentMap } from '../../scene/environment.ts';
import type { Color, Vec3 } from '../../scene/scene.ts';

/** Where a direction lies in the map, in texels from its upper left corner. `rotation`: degrees about +Y. */
export function placeOnMap({ width, height }: EnvironmentMap, [x, y, z]: Vec3, rotation = 0): [number, number] {
  const u = Math.atan2(x, -z) / (2 * Math.PI) + rotation / 360;
  const v = Math.atan2(Math.hypot(x, z), y) / Math.PI;
  return [(u - Math.floor(u)) * width, v * height];
}

type Texel = (column: number, row: number) => number;

/** Bilinear between the centres of texels, of which `texel` may be asked for any column and row. */
function bilinear([x, y]: readonly [number, number], texel: Texel): number {
  const [i, j] = [Math.floor(x - 0.5), Math.floor(y - 0.5)];
  const [s, t] = [x - 0.5 - i, y - 0.5 - j];
  const along = (row: number) => (1 - s) * texel(i, row) + s * texel(i + 1, row);
  return (1 - t) * along(j) + t * along(j + 1);
}

const wrap = (column: number, width: number) => ((column % width) + width) % width;
const clamp = (row: number, height: number) => Math.min(Math.max(row, 0), height - 1);

export function radianceOfMap(map: EnvironmentMap, direction: Vec3, rotation = 0): Color {
  const { width, height, data } = map;
  const place = placeOnMap(map, direction, rotation);
  const channel = (c: number) => bilinear(place, (i, j) => data[3 * (clamp(j, height) * width + wrap(i, width)) + c]!);
  return [channel(0), channel(1), channel(2)];
}

const luminance = ({ width, height, data }: EnvironmentMap, i: number, j: number): number => {
  const at = 3 * (clamp(j, height) * width + wrap(i, width));
  return (data[at]! + data[at + 1]! + data[at + 2]!) / 3;
};
const sineOf = ({ height }: EnvironmentMap, j: number): number => Math.sin((Math.PI * (j + 0.5)) / height);

/** Mean radiance of the texels, each as large as it is in the sky, and the share of all light that is brighter than that. */
function meanAndExcess(map: EnvironmentMap): { mean: number; excess: number } {
  const sumOver = (f: (i: number, j: number) => number) => {
    let sum = 0;
    for (let j = 0; j < map.height; j++) for (let i = 0; i < map.width; i++) sum += f(i, j) * sineOf(map, j);
    return sum;
  };
  const light = sumOver((i, j) => luminance(map, i, j));
  const mean = light / sumOver(() => 1);
  return { mean, excess: sumOver((i, j) => Math.max(luminance(map, i, j) - mean, 0)) / light };
}

const floors = new WeakMap<EnvironmentMap, number>();

/** The radiance that light sampling leaves out: the mean, unless hardly anything is brighter. */
function floorOf(map: EnvironmentMap): number {
  let floor = floors.get(map);
  if (floor === undefined) {
    const { mean, excess } = meanAndExcess(map);
    floors.set(map, (floor = excess > 1e-3 ? mean : 0));
  }
  return floor;
}

/**
 * Density of places on the map, per texel and up to a factor: by how much the radiance is above the mean, times sin θ, bilinear; the sine
 * is odd beyond a pole.
 */
export function placeDensity(map: EnvironmentMap, place: readonly [number, number]): number {
  const floor = floorOf(map);
  return bilinear(place, (i, j) => Math.max(luminance(map, i, j) - floor, 0) * sineOf(map, j));
}

/** The sum over all places of `f`, which is bilinear between lines half a texel apart, times the area in texels: exact. */
export function overMap({ width, height }: EnvironmentMap, f: (place: [number, number]) => number): number {
  let sum = 0;
  for (let j = 0.25; j < height; j += 0.5) for (let i = 0.25; i < width; i += 0.5) sum += f([i, j]) / 4;
  return sum;
}

const totals = new WeakMap<EnvironmentMap, number>();

function totalOf(map: EnvironmentMap): number {
  let total = totals.get(map);
  if (total === undefined) totals.set(map, (total = overMap(map, (place) => placeDensity(map, place))));
  return total;
}

/** The density of directions, per steradian. */
export function densityOnMap(map: EnvironmentMap): (direction: Vec3, rotation?: number) => number {
  const total = totalOf(map);
  const texel = (2 * Math.PI ** 2) / (map.width * map.height);
  return (direction, rotation = 0) => {
    const sine = Math.hypot(direction[0], direction[2]);
    return placeDensity(map, placeOnMap(map, direction, rotation)) / (total * texel * sine);
  };
}
