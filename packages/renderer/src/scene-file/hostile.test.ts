/**
 * Files that a scene names, cut off, changed, or with heads that claim too much: problems at their places or content that keeps all rules,
 * never anything thrown, and no more memory than a few hundred megabytes.
 */
import { readFileSync } from 'node:fs';
import { encode as encodeJpeg } from 'jpeg-js';
import { describe, expect, test } from 'vitest';
import { triangleFile } from '../../../../tests/fixtures/gltf.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { writeExr } from '../export/exr.ts';
import { fromInterleaved } from '../export/float-picture.ts';
import { writePng } from '../export/png.ts';
import { nodeDecoder } from '../headless/node-images.ts';
import type { Scene } from '../scene/scene.ts';
import { loadFiles } from './load-files.ts';
import { parseScene } from './parse-scene.ts';
import { isParsedScene } from './trusted-scenes.ts';

const fixture = (name: string): Uint8Array =>
  Uint8Array.from(readFileSync(new URL(`../../../../tests/fixtures/images/${name}`, import.meta.url)));
const values = Array.from({ length: 16 * 8 * 3 }, (_, i) => ((i * 37) % 100) / 100);
const floats = fromInterleaved(16, 8, ['R', 'G', 'B'], values);
const jpeg = encodeJpeg({ width: 16, height: 8, data: Buffer.from(values.slice(0, 512 / 3).flatMap((x) => [x * 255, 9, 99])) }, 90); // biome-ignore format: one call

const scene = (more: object): Scene => {
  const base = { version: 1, name: 'x', camera: { eye: [0, 0, 5], target: [0, 0, 0] }, materials: { m: {} }, shapes: { s: { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'm' } } }; // biome-ignore format: one scene
  const parsed = parseScene({ ...base, ...more });
  if (!parsed.ok) throw new Error(parsed.problems[0]!.message);
  return parsed.scene;
};
const model = () =>
  triangleFile((f) => {
    const bufferView = f.view(writePng(floats));
    f.add('images', { bufferView, mimeType: 'image/png' });
    f.add('textures', { source: 0 });
    f.json.meshes[0].primitives[0].material = f.add('materials', {
      pbrMetallicRoughness: { baseColorTexture: { index: 0 } },
    });
    f.json.meshes[0].primitives[0].attributes.TEXCOORD_0 = f.floats('VEC2', 0, 0, 1, 0, 0, 1);
  });

interface Subject {
  readonly name: string;
  readonly file: Uint8Array;
  readonly scene: Scene;
  /** Where its problems lie. */
  readonly place: RegExp;
}
const image = (file: string) => scene({ images: { a: file } });
const SUBJECTS: Subject[] = [
  { name: 'PNG', file: writePng(floats), scene: image('a.png'), place: /^\/images/ },
  { name: 'PNG, interlaced', file: fixture('interlaced-16.png'), scene: image('a.png'), place: /^\/images/ },
  { name: 'JPEG', file: new Uint8Array(jpeg.data), scene: image('a.jpg'), place: /^\/images/ },
  { name: 'JPEG, progressive', file: fixture('gradient-progressive.jpg'), scene: image('a.jpg'), place: /^\/images/ },
  { name: 'KTX2, UASTC', file: fixture('uastc-alpha.ktx2'), scene: image('a.png'), place: /^\/images/ },
  { name: 'KTX2, ETC1S', file: fixture('etc1s-alpha.ktx2'), scene: image('a.png'), place: /^\/images/ },
  { name: 'EXR', file: writeExr(floats), scene: scene({ sky: { image: 'a.exr' } }), place: /^\/sky\/image$/ },
  { name: 'HDR', file: fixture('run-length.hdr'), scene: scene({ sky: { image: 'a.hdr' } }), place: /^\/sky\/image$/ },
  { name: 'GLB', file: model().glb(), scene: scene({ models: { m: { file: 'm.glb' } } }), place: /^\/models/ },
  { name: 'glTF with data URIs', file: model().text(), scene: scene({ models: { m: { file: 'm.gltf' } } }), place: /^\/models/ }, // biome-ignore format: one row
];

async function outcome({ scene: named, place }: Subject, bytes: Uint8Array): Promise<'loaded' | 'problems'> {
  const loaded = await loadFiles(named, async () => bytes, { decoder: nodeDecoder() });
  if (loaded.ok) {
    expect(isParsedScene(loaded.scene)).toBe(true);
    for (const { data } of Object.values(loaded.scene.images ?? {}))
      expect(data!.rgba.length).toBe(data!.width * data!.height * 4);
    return 'loaded';
  }
  expect(loaded.problems.length).toBeGreaterThan(0);
  for (const { path, message } of loaded.problems) {
    expect(path).toMatch(place);
    expect(message.length).toBeLessThan(2000);
    expect(message).not.toContain('something that cannot be read');
  }
  return 'problems';
}

/** Kilobytes that the process has had at most. */
const most = () => process.resourceUsage().maxRSS;

describe.each(SUBJECTS)('$name', (subject) => {
  test('is read as it is', async () => {
    expect(await outcome(subject, subject.file)).toBe('loaded');
  });

  test('300 times with bytes changed (seed 97), 60 times cut off', async () => {
    const random = seededRandom(97);
    const before = most();
    const { length } = subject.file;
    for (let round = 0; round < 300; round++) {
      const bytes = subject.file.slice();
      const reach = round % 2 ? length : Math.min(length, 120); // heads are where mistakes hurt
      for (let k = Math.floor(random() * 4); k >= 0; k--)
        bytes[Math.floor(random() * reach)] = random() < 0.3 ? 255 : random() * 256;
      await outcome(subject, bytes);
    }
    for (let cut = 0; cut < 60; cut++)
      await outcome(subject, subject.file.subarray(0, Math.floor((length * cut) / 60)));
    expect((most() - before) / 1024).toBeLessThan(400);
  });
});

/** The big-endian numbers at these places, changed. */
function withNumbers(file: Uint8Array, numbers: Readonly<Record<number, number>>, bits: 16 | 32 = 32): Uint8Array {
  const bytes = file.slice();
  const view = new DataView(bytes.buffer);
  for (const [at, value] of Object.entries(numbers))
    if (bits === 32) view.setUint32(Number(at), value);
    else view.setUint16(Number(at), value);
  return bytes;
}
const text = (content: string) => new TextEncoder().encode(content);
const frame = (bytes: Uint8Array) =>
  bytes.findIndex((b, i) => b === 0xff && (bytes[i + 1] === 0xc0 || bytes[i + 1] === 0xc2));

describe('heads that claim a billion pixels', () => {
  const jpg = new Uint8Array(jpeg.data);
  const at = frame(jpg);
  const webp = new Uint8Array(40);
  webp.set(text('RIFF    WEBPVP8X'));
  webp.fill(255, 24, 30);
  const ktx = fixture('uastc-alpha.ktx2');
  new DataView(ktx.buffer).setUint32(20, 1 << 30, true);
  test.each([
    ['PNG', image('a.png'), withNumbers(writePng(floats), { 16: 40_000, 20: 30_000 })],
    ['PNG within the limit', image('a.png'), withNumbers(writePng(floats), { 16: 16_384, 20: 16_384 })],
    ['JPEG', image('a.jpg'), withNumbers(jpg, { [at + 5]: 65_535, [at + 7]: 65_535 }, 16)],
    ['JPEG within the limit', image('a.jpg'), withNumbers(jpg, { [at + 5]: 16_384, [at + 7]: 16_384 }, 16)],
    ['WebP', image('a.webp'), webp],
    ['KTX2', image('a.png'), ktx],
    ['HDR', scene({ sky: { image: 'a.hdr' } }), text('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 30000\n')],
    ['PFM', scene({ sky: { image: 'a.pfm' } }), text('PF\n100000 100000\n-1.0\n')],
    ['NPY', scene({ sky: { image: 'a.npy' } }), text("\u0093NUMPY\u0001\0v\0{'descr': '<f4', 'fortran_order': False, 'shape': (100000, 100000, 3), }")], // biome-ignore format: one row
  ])('%s', async (_, named, bytes) => {
    const before = most();
    const subject = { name: '', file: bytes, scene: named, place: /^\/(images|sky)/ };
    expect(await outcome(subject, bytes)).toBe('problems');
    expect((most() - before) / 1024).toBeLessThan(400);
  });
});
