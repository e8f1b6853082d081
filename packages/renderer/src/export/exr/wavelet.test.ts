import { expect, test } from 'vitest';
import { seededRandom } from '../../../../../tests/fixtures/random.ts';
import { restoreWavelet } from './wavelet.ts';

/** The forward transform, written from ImfWav.cpp as it stands there, pointers as indices. */
function wavelet(data: Uint16Array, start: number, nx: number, ox: number, ny: number, oy: number, most: number): void {
  const signed = (word: number): number => (word << 16) >> 16;
  const join = (a: number, b: number): [number, number] => {
    if (most < 1 << 14) return [((signed(a) + signed(b)) >> 1) & 0xffff, (signed(a) - signed(b)) & 0xffff];
    const ao = (a + 0x8000) & 0xffff;
    const d = ao - b;
    const m = (ao + b) >> 1;
    return [d < 0 ? (m + 0x8000) & 0xffff : m, d & 0xffff];
  };
  const n = Math.min(nx, ny);
  for (let p = 1, p2 = 2; p2 <= n; p = p2, p2 *= 2) {
    let py = start;
    for (; py <= start + oy * (ny - p2); py += oy * p2) {
      let px = py;
      for (; px <= py + ox * (nx - p2); px += ox * p2) {
        const [p01, p10, p11] = [px + ox * p, px + oy * p, px + oy * p + ox * p];
        const [i00, i01] = join(data[px]!, data[p01]!);
        const [i10, i11] = join(data[p10]!, data[p11]!);
        [data[px], data[p10]] = join(i00, i10);
        [data[p01], data[p11]] = join(i01, i11);
      }
      if (nx & p) [data[px], data[px + oy * p]] = join(data[px]!, data[px + oy * p]!);
    }
    if (ny & p)
      for (let px = py; px <= py + ox * (nx - p2); px += ox * p2)
        [data[px], data[px + ox * p]] = join(data[px]!, data[px + ox * p]!);
  }
}

test.each([
  [1, 16, 32, 2 ** 14 - 1],
  [2, 33, 7, 2 ** 14 - 1],
  [3, 31, 32, 65535],
  [4, 1, 9, 65535],
  [5, 70, 21, 65535],
])('seed %i: %i × %i words up to %i come back', (seed, nx, ny, most) => {
  const random = seededRandom(seed);
  const data = Uint16Array.from({ length: nx * ny * 2 + 1 }, () => random() * (most + 1));
  const before = data.slice();
  for (const start of [0, 1]) wavelet(data, start, nx, 2, ny, nx * 2, most);
  for (const start of [0, 1]) restoreWavelet(data, start, { nx, ox: 2, ny, oy: nx * 2 }, most);
  expect(data).toEqual(before);
});
