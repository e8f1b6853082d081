import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { nodeDecoder } from './node-images.ts';

const file = Uint8Array.from(
  readFileSync(new URL('../../../../tests/fixtures/images/gradient-progressive.jpg', import.meta.url)),
);

test('a progressive JPEG is the gradient that was written', async () => {
  const { width, height, rgba } = await nodeDecoder().decode(file, 'image/jpeg');
  expect([width, height]).toEqual([19, 11]);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const [r, g, b, a] = rgba.subarray(4 * (y * width + x));
      expect(Math.hypot(r! - 13 * x, g! - 20 * y, b! - 128)).toBeLessThan(40);
      expect(a).toBe(255);
    }
});

test('a damaged one is refused; WebP is not claimed', async () => {
  await expect(nodeDecoder().decode(file.subarray(0, 100), 'image/jpeg')).rejects.toThrow();
  expect(['image/png', 'image/jpeg', 'image/ktx2', 'image/webp'].map(nodeDecoder().canDecode)).toEqual([
    true,
    true,
    true,
    false,
  ]);
});
