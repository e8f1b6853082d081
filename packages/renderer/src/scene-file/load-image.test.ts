import { expect, test } from 'vitest';
import { mapOf } from '../../../../tests/fixtures/lights/environments.ts';
import { testScene } from '../../../../tests/fixtures/scenes.ts';
import { fromInterleaved } from '../export/float-picture.ts';
import { formatOf } from '../export/formats.ts';
import { sceneAt } from '../scene/animation.ts';
import type { Scene } from '../scene/scene.ts';
import { environmentFromPicture } from './environment-from-picture.ts';
import { loadFiles } from './load-files.ts';
import { parseScene } from './parse-scene.ts';
import { requireScene } from './require-scene.ts';
import { writeScene } from './write-scene.ts';

const NUMBERS = Array.from({ length: 24 }, (_, k) => k / 4);
const picture = fromInterleaved(4, 2, ['R', 'G', 'B'], NUMBERS);

function sceneWith(sky: unknown, animation: unknown[] = []): Scene {
  const shapes = { ball: { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'grey' } };
  const camera = { eye: [0, 0, 5], target: [0, 0, 0] };
  const parsed = parseScene({ version: 1, name: 'sky', camera, sky, materials: { grey: {} }, shapes, animation });
  if (!parsed.ok) throw new Error(parsed.problems.map(({ message }) => message).join('\n'));
  return parsed.scene;
}

async function load(scene: Scene, bytes: Uint8Array) {
  const asked: string[] = [];
  const loaded = await loadFiles(scene, async (name) => {
    asked.push(name);
    return bytes;
  });
  return { loaded, asked };
}

test.each(['exr', 'hdr', 'npy', 'pfm'])('a sky may be a .%s file; the scene then has its content', async (ending) => {
  const image = `maps/Sky.${ending.toUpperCase()}`;
  const scene = sceneWith({ image, rotation: 90 });
  expect(scene.sky).toEqual({ horizon: [0, 0, 0], zenith: [0, 0, 0], image, scale: 1, rotation: 90 });
  const { loaded, asked } = await load(scene, formatOf(image).write(picture));
  if (!loaded.ok) throw new Error(loaded.problems[0]!.message);
  expect(asked).toEqual([image]);
  expect(loaded.notes).toEqual([]);
  expect(loaded.scene.sky.map).toMatchObject({ width: 4, height: 2 });
  loaded.scene.sky.map!.data.forEach((value, k) => {
    expect(Math.abs(value - NUMBERS[k]!)).toBeLessThan(ending === 'hdr' ? 0.03 : 1e-6);
  });
  // It is as good as any scene that was read, is not loaded again, and is written without its content.
  expect(requireScene(loaded.scene)).toBe(loaded.scene);
  expect((await load(loaded.scene, new Uint8Array())).asked).toEqual([]);
  expect(parseScene(writeScene(loaded.scene))).toEqual({ ok: true, scene });
});

test('nothing is read for a sky of colours', async () => {
  const scene = sceneWith([1, 1, 1]);
  const { loaded, asked } = await load(scene, new Uint8Array());
  expect(loaded).toEqual({ ok: true, scene, notes: [] });
  expect(asked).toEqual([]);
});

test('a file that is not there or is broken is a problem at its place', async () => {
  const scene = sceneWith({ image: 'sky.exr' });
  const missing = await loadFiles(scene, async () => {
    throw new Error('there is no such file');
  });
  expect(missing).toMatchObject({
    problems: [{ path: '/sky/image', message: 'The sky\'s image "sky.exr" cannot be read: there is no such file.' }],
  });
  const { loaded } = await load(scene, new Uint8Array([1, 2, 3]));
  expect(loaded).toMatchObject({ ok: false, problems: [{ path: '/sky/image' }] });
  if (!loaded.ok)
    expect(loaded.problems[0]!.message).toMatch(/^The sky's image "sky.exr" is no picture that can be used\. The EXR/);
  const strange = formatOf('a.npy').write(fromInterleaved(2, 1, ['R', 'G', 'B'], [0, 0, 0, 1, Number.NaN, 0]));
  const nan = await load(sceneWith({ image: 'a.npy' }), strange);
  expect(nan.loaded).toMatchObject({ ok: false });
  if (!nan.loaded.ok) expect(nan.loaded.problems[0]!.message).toContain('the value NaN in column 1 of row 0');
});

test('one channel is grey, negative numbers are 0 with a note', async () => {
  const grey = environmentFromPicture(fromInterleaved(2, 1, ['Y'], [1, -2]));
  expect([...grey.map.data]).toEqual([1, 1, 1, 0, 0, 0]);
  expect(grey.notes[0]).toContain('negative');
  expect(() => environmentFromPicture(fromInterleaved(1, 1, ['R', 'A'], [1, 1]))).toThrow('the channels R A');
});

test('a map that is too large is averaged, and the light stays the same', () => {
  const [width, height] = [6000, 9];
  const large = mapOf(width, height, (i, j) => [i % 7, j, (i * j) % 5]);
  const flat = fromInterleaved(width, height, ['R', 'G', 'B'], large.data);
  const { map, notes } = environmentFromPicture(flat);
  expect([map.width, map.height]).toEqual([4096, 6]);
  expect(notes[0]).toContain('averaged to 4096 × 6');
  const light = ({ width: w, height: h, data }: typeof map) => {
    const sums = [0, 0, 0];
    for (let k = 0; k < data.length; k++) {
      const row = Math.floor(k / 3 / w);
      sums[k % 3]! += ((Math.cos((Math.PI * row) / h) - Math.cos((Math.PI * (row + 1)) / h)) * data[k]!) / w;
    }
    return sums;
  };
  light(map).forEach((sum, c) => {
    expect(sum / light(large)[c]!).toBeCloseTo(1, 6);
  });
});

test('a scene in memory may have a map without a file, which is checked', () => {
  const map = mapOf(4, 2, () => [1, 2, 3]);
  const sky = { horizon: [0, 0, 0], zenith: [0, 0, 0], map, rotation: 45 } as const;
  const ball = { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'white' } as const;
  const scene = requireScene(testScene({ ball }, {}, { sky }));
  expect(scene.sky).toEqual({ ...sky, scale: 1 });
  expect(scene.sky.map).toBe(map);
  expect(requireScene(scene)).toBe(scene);
  expect(() => writeScene(scene)).toThrow('give sky.image the name');
  const short = { ...map, data: map.data.subarray(1) };
  expect(() => requireScene(testScene({ ball }, {}, { sky: { ...sky, map: short } }))).toThrow('4 × 2 texels need 24');
  expect(() => requireScene(testScene({ ball }, {}, { sky: { ...sky, map: 7 as never } }))).toThrow('/sky/map');
});

test('a scene whose image has not been loaded is not shown', () => {
  expect(() => requireScene(sceneWith({ image: 'sky.hdr' }))).toThrow('"sky.hdr" has not been loaded');
});

test('the map keeps its place while its turn and scale move', () => {
  const track = { target: '/sky/rotation', keys: [{ time: 0, value: 0 }, { time: 1, value: 90 }] }; // biome-ignore format: short
  const map = mapOf(2, 1, () => [1, 1, 1]);
  const scene = requireScene({ ...sceneWith({ image: 'a.hdr' }, [track]), sky: { image: 'a.hdr', map } });
  const moved = sceneAt(scene, 0.5);
  expect(moved.sky.rotation).toBe(45);
  expect(moved.sky.map).toBe(map);
});
