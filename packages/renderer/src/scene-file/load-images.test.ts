import { encode } from 'fast-png';
import { expect, test } from 'vitest';
import { nodeDecoder } from '../headless/node-images.ts';
import { loadFiles } from './load-files.ts';
import { parseScene } from './parse-scene.ts';
import { requireScene } from './require-scene.ts';
import { writeScene } from './write-scene.ts';

const png = (depth: 8 | 16 = 8) => {
  const Pixels = depth === 8 ? Uint8Array : Uint16Array;
  return encode({ width: 2, height: 1, channels: 4, depth, data: Pixels.of(1, 2, 3, 4, 5, 6, 7, 8) });
};
/** The size that the head claims. */
const claiming = (width: number, height: number): Uint8Array => {
  const bytes = png().slice();
  new DataView(bytes.buffer).setUint32(16, width);
  new DataView(bytes.buffer).setUint32(20, height);
  return bytes;
};

const scene = {
  version: 1,
  name: 'Painted',
  camera: { eye: [0, 0, 5], target: [0, 0, 0] },
  materials: {
    bark: {
      type: 'metallicRoughness',
      baseColorTexture: 'maps/bark.png',
      clearcoat: { weightTexture: { texture: 'maps/bark.png', scale: [2, 2] } },
    },
  },
  meshes: { log: { file: 'log.ply' } },
  shapes: { log: { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'bark' } },
};

async function load(bytes: Uint8Array, more: object = {}) {
  const parsed = parseScene({ ...scene, meshes: undefined, ...more });
  if (!parsed.ok) throw new Error(parsed.problems[0]!.message);
  return { parsed: parsed.scene, loaded: await loadFiles(parsed.scene, async () => bytes, { decoder: nodeDecoder() }) };
}

test('a file named by a material is an image and a texture, read once', async () => {
  const { parsed, loaded } = await load(png());
  expect(parsed.images).toEqual({ 'maps/bark.png': { file: 'maps/bark.png' } });
  expect(parsed.textures).toEqual({ 'maps/bark.png': { image: 'maps/bark.png' } });
  expect(() => requireScene(parsed)).toThrow('The image "maps/bark.png"');
  if (!loaded.ok) throw new Error(loaded.problems[0]!.message);
  expect(loaded.scene.images!['maps/bark.png']!.data).toEqual({
    width: 2,
    height: 1,
    rgba: Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8),
  });
  expect(requireScene(loaded.scene)).toBe(loaded.scene);
  // A copy by a program keeps its pixels.
  expect(requireScene({ ...loaded.scene }).images).toEqual(loaded.scene.images);
  const again = parseScene(writeScene(loaded.scene));
  expect(again.ok && again.scene).toEqual(parsed);
});

test('16 bits are told of', async () => {
  const { loaded } = await load(png(16));
  expect(loaded.ok && loaded.notes).toEqual([expect.stringContaining('channels of 16 bits are rounded to 8')]);
});

test.each([
  ['no image', new Uint8Array(40), 'it is no image'],
  ['an image of another kind', new TextEncoder().encode('BM and more'), 'it is a BMP image; PNG, JPEG'],
  ['an empty file', new Uint8Array(0), 'it is no image'],
  ['a billion pixels', claiming(50_000, 50_000), '50000 × 50000 pixels'],
  ['no pixel', claiming(0, 1), '0 × 1 pixels'],
  ['cut off', png().slice(0, 45), ''],
  ['more than 2 GiB in all', claiming(16_384, 16_384), ''],
])('%s is a problem at its place', async (_, bytes, reason) => {
  const two = { images: { a: 'a.png', b: 'b.png', c: 'c.png' }, textures: { a: { image: 'a' } } };
  const { loaded } = await load(bytes, two);
  const problems = loaded.ok ? [] : loaded.problems;
  expect(problems.length).toBeGreaterThan(0);
  expect(problems[0]!.path).toMatch(/^\/images(\/a\/file)?$/);
  expect(problems[0]!.message).toContain(reason);
});
