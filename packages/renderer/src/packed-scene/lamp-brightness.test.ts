import { expect, test } from 'vitest';
import { unevenSquare } from '../../../../tests/fixtures/lights/mesh-cases.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { lookUp } from '../reference/texture.ts';
import type { Mesh } from '../scene/mesh.ts';
import type { ImagePixels, TextureUse, Wrap } from '../scene/textures.ts';
import { brightnessOf } from './lamp-brightness.ts';
import { SummedImage } from './summed-image.ts';

const WRAPS: readonly Wrap[] = ['repeat', 'clamp', 'mirror'];
const random = seededRandom(71);
const image = (width: number, height: number, byte: (x: number, y: number, c: number) => number): ImagePixels => ({
  width,
  height,
  rgba: Uint8Array.from({ length: 4 * width * height }, (_, i) =>
    byte((i >> 2) % width, Math.floor((i >> 2) / width), i % 4),
  ),
});
const noise = image(7, 5, () => Math.floor(256 * random()));

/** By looking up many points, each the texel that it lies in. */
function meanByPoints(pixels: ImagePixels, box: readonly number[], wrapU: Wrap, wrapV: Wrap): number {
  const prepared = {
    use: { texture: '' },
    texture: { image: '', wrapU, wrapV, filter: 'nearest' as const },
    pixels,
    isColor: true,
  };
  const [u0, v0, u1, v1] = box as [number, number, number, number];
  const n = 120;
  let sum = 0;
  for (let k = 0; k < n * n; k++) {
    const [r, g, b] = lookUp(prepared, [
      u0 + (((k % n) + 0.5) / n) * (u1 - u0),
      v0 + ((Math.floor(k / n) + 0.5) / n) * (v1 - v0),
    ]);
    sum += (r + g + b) / 3;
  }
  return sum / (n * n);
}

test('means over rectangles, also beyond the image, are those of its texels (seed 71)', () => {
  const sums = new SummedImage(noise);
  for (const wrapU of WRAPS)
    for (const wrapV of WRAPS)
      for (let k = 0; k < 3; k++) {
        const [u, v, width, height] = [6 * random() - 3, 6 * random() - 3, 3 * random(), 2 * random()];
        const around = [u - 0.5 / 7, v - 0.5 / 5, u + width + 0.5 / 7, v + height + 0.5 / 5];
        const mean = sums.mean(u, v, u + width, v + height, wrapU, wrapV);
        expect(
          Math.abs(mean - meanByPoints(noise, around, wrapU, wrapV)),
          `${wrapU}, ${wrapV}, ${around}`,
        ).toBeLessThan(0.015);
      }
});

test('a large image is summed in few texels, and loses no light', () => {
  const large = image(1300, 3, (x, _, c) => (c === 3 ? 0 : x % 13 === 0 ? 255 : 0));
  const sums = new SummedImage(large);
  expect([sums.columns, sums.rows]).toEqual([512, 3]);
  expect(sums.mean(0.5, 0.5, 3.5, 4.5)).toBeCloseTo(1 / 13, 3);
});

const withUvs = (mesh: Mesh): Mesh => ({
  ...mesh,
  uvs: [
    Float32Array.from({ length: (2 * mesh.positions.length) / 3 }, (_, i) => mesh.positions[3 * (i >> 1) + (i % 2)]!),
  ],
});

test('triangles are as bright as what they show: bright in proportion, black not at all', () => {
  const half = image(64, 4, (x, _, c) => (c === 3 || x < 32 ? 0 : 255));
  const use: TextureUse = { texture: 't' };
  const mesh = withUvs(unevenSquare(6));
  const brightness = brightnessOf(mesh, { pixels: half, use, wrapU: 'clamp', wrapV: 'clamp' });
  expect(brightness.length).toBe(72);
  const share = (k: number) => {
    const xs = [0, 1, 2].map((c) => mesh.positions[3 * mesh.indices[3 * k + c]!]!);
    return [Math.min(...xs), Math.max(...xs)] as const;
  };
  brightness.forEach((value, k) => {
    const [least, most] = share(k);
    if (most < 0.48) expect(value).toBe(0);
    else if (least > 0.52) expect(value).toBeCloseTo(1, 9);
    else expect(value).toBeGreaterThan(0);
  });
  expect(brightnessOf(mesh, { pixels: half, use, wrapU: 'clamp', wrapV: 'clamp' })).toBe(brightness);
  const turned = brightnessOf(mesh, {
    pixels: half,
    use: { ...use, offset: [0.55, 0] },
    wrapU: 'clamp',
    wrapV: 'clamp',
  });
  expect(Math.min(...turned)).toBeCloseTo(1, 1);
});
