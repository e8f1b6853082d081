import { expect, test } from 'vitest';
import type { Device, FilmTexture } from '../gpu/device.ts';
import { Film } from './film.ts';

/** A device that only makes films, and knows which are there. */
function filmDevice(content: readonly number[] = []) {
  const alive = new Set<FilmTexture>();
  const device: Pick<Device, 'createFilm' | 'read'> = {
    createFilm(width, height, layers = 1) {
      const texture: FilmTexture = {
        width,
        height,
        layers: Array.from({ length: layers }, () => ({ width, height, destroy: () => {} })),
        destroy: () => {
          if (!alive.delete(texture)) throw new Error('destroyed twice');
        },
      };
      alive.add(texture);
      return texture;
    },
    read: async () => Float32Array.from(content),
  };
  return { film: new Film(device as Device), device, alive };
}

test('a layer of a film can be read, a film as a whole cannot', () => {
  const { film, device } = filmDevice();
  film.reserve(8, 4);
  const whole = film.current;
  void device.read(whole.layers[0]!, 8, 4);
  // @ts-expect-error what cannot be read is no texture to TypeScript
  void device.read(whole, 8, 4);
});

test('two textures take turns', () => {
  const { film, alive } = filmDevice();
  film.reserve(8, 4);
  film.restart(8, 4);
  const [a, b] = [film.current, film.next];
  expect(a).not.toBe(b);
  film.swap();
  expect([film.current, film.next, film.samples]).toEqual([b, a, 1]);
  film.swap();
  expect([film.current, film.next, film.samples]).toEqual([a, b, 2]);
  expect(alive.size).toBe(2);
});

test('a smaller picture allocates nothing, another reserve does, and nothing is left behind', () => {
  const { film, alive } = filmDevice();
  film.reserve(8, 4);
  const texture = film.current;
  film.restart(3, 2);
  film.reserve(8, 4);
  expect(film.current).toBe(texture);
  expect([film.width, film.height, film.samples]).toEqual([3, 2, 0]);
  film.reserve(16, 9);
  expect(alive.size).toBe(2);
  expect(film.current.width).toBe(16);
  film.destroy();
  expect(alive.size).toBe(0);
});

test('the last whole picture stays until the next one is complete', () => {
  const { film, alive } = filmDevice();
  film.reserve(8, 4);
  film.restart(8, 4);
  expect(film.picture).toBeNull();
  film.swap();
  const shown = film.picture!;
  expect(shown.film).toBe(film.current);
  for (const side of [5, 6, 7]) film.reserve(side, side);
  expect(film.picture).toBe(shown);
  expect(alive.has(shown.film)).toBe(true);
  expect(alive.size).toBe(3);
  film.restart(7, 7);
  film.swap();
  expect(alive.has(shown.film)).toBe(false);
  expect(film.picture).toEqual({ film: film.current, width: 7, height: 7 });
  film.destroy();
  expect(alive.size).toBe(0);
});

test('what is read is the mean, and an empty pixel is black', async () => {
  const { film } = filmDevice([2, 4, 6, 2, 0, 0, 0, 0]);
  film.reserve(2, 1);
  film.restart(2, 1);
  expect(Array.from(await film.read())).toEqual([1, 2, 3, 2, 0, 0, 0, 0]);
});
