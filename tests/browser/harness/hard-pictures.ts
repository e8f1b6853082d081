/** Pictures of hard scenes, and what is wrong with them. */
import { traceClassic } from '../../../packages/renderer/src/reference/classic.ts';
import { darkRooms, hardScenes, moved } from './hard-scenes.ts';
import { compareFilms, type GpuBackend, gpuFilm, type PictureSettings } from './parity.ts';

type Film = ArrayLike<number>;

/** Largest difference of a colour channel. */
function difference(a: Film, i: number, b: Film, j: number): number {
  let largest = 0;
  for (let c = 0; c < 3; c++) largest = Math.max(largest, Math.abs(a[4 * i + c]! - b[4 * j + c]!));
  return largest;
}

/** Visible by itself: this much unlike its neighbours and the truth. */
const SPECKLE = 0.02;

/** Pixels that differ from all their neighbours and from the double-precision film, as "x, y". */
function speckles(film: Film, truth: Film, width: number, height: number): string[] {
  const found: string[] = [];
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const at = y * width + x;
      if (difference(film, at, truth, at) <= SPECKLE) continue;
      let alone = true;
      for (let j = Math.max(y - 1, 0); j <= Math.min(y + 1, height - 1); j++)
        for (let i = Math.max(x - 1, 0); i <= Math.min(x + 1, width - 1); i++) {
          const other = j * width + i;
          if (other !== at && difference(film, at, film, other) <= SPECKLE) alone = false;
        }
      if (alone) found.push(`${x}, ${y}`);
    }
  return found;
}

const isGood = (film: Film) => Array.from(film).every((value) => Number.isFinite(value) && value >= 0);

/** Counts of what must not be, in the picture of a hard scene on one backend. */
export async function hardPicture(backend: GpuBackend, name: string, picture: PictureSettings) {
  const scene = hardScenes[name]!;
  const { width, height } = picture;
  const film = await gpuFilm(backend, scene, picture);
  const truth = traceClassic(scene, picture);
  const { mean, shareOff } = compareFilms(film, truth, width, height);
  return { good: isGood(film), speckles: speckles(film, truth, width, height), mean, shareOff };
}

/** A scene against itself, `scale` times as large and moved by `by` along each axis. */
export async function movedPicture(
  backend: GpuBackend,
  name: string,
  place: [number, number],
  picture: PictureSettings,
) {
  const original = hardScenes[name]!;
  const { width, height } = picture;
  const here = await gpuFilm(backend, original, picture);
  const film = await gpuFilm(backend, moved(original, ...place), picture);
  const { shareOff } = compareFilms(film, here, width, height);
  return { good: isGood(film), shareOff, speckles: speckles(film, here, width, height) };
}

/** Light that got into a closed room: the largest value of its picture, and in how many pixels there is any. */
export async function leaks(backend: GpuBackend, name: string, picture: PictureSettings, ambient: number) {
  const room = darkRooms[name]!;
  const lights = Object.fromEntries(
    Object.entries(room.lights).map(([key, light]) => [
      key,
      { ...light, ambient: [ambient, ambient, ambient] as const },
    ]),
  );
  const film = await gpuFilm(backend, { ...room, lights }, picture);
  const values = Array.from(film).filter((_, k) => k % 4 < 3);
  const lit = values.filter((value, k) => k % 3 === 0 && value !== 0).length;
  const spread = [Math.min(...values), Math.max(...values)] as const;
  return { good: isGood(film), lit, spread };
}

export const hardNames = () => ({ scenes: Object.keys(hardScenes), rooms: Object.keys(darkRooms) });
