import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { builtInScenes } from '../scene/built-in/index.ts';
import { sceneAt } from '../scene/index.ts';
import type { Scene } from '../scene/scene.ts';
import { goodScene, richScene } from './broken/good-scene.ts';
import { jsonSchemaText } from './json-schema.ts';
import { parseScene } from './parse-scene.ts';
import { writeScene } from './write-scene.ts';

function parsed(input: unknown): Scene {
  const result = parseScene(input);
  if (!result.ok) throw new Error(result.problems.map(({ message }) => message).join('\n'));
  return result.scene;
}
const scenes = [
  ...builtInScenes.map(({ scene }) => scene),
  parsed(goodScene()),
  parsed({ ...richScene(), name: 'Rich' }),
];

test('the committed JSON Schema is fresh (else: npm run schema)', () => {
  const file = new URL('../../scene.schema.json', import.meta.url);
  expect(readFileSync(file, 'utf8')).toBe(jsonSchemaText());
});

describe.each(scenes.map((scene) => [scene.name, scene] as const))('%s', (_, scene) => {
  test('survives writing and reading', () => {
    const text = writeScene(scene);
    expect(parsed(text)).toEqual(scene);
    expect(writeScene(parsed(text))).toBe(text);
  });
  test('is frozen through and through', () => {
    expect(Object.isFrozen(scene.shapes)).toBe(true);
    expect(Object.isFrozen(scene.camera.eye)).toBe(true);
    expect(Object.isFrozen(scene.animation[0]?.keys[0]?.value)).toBe(true);
  });
});

test('defaults are left out and a vector takes one line', () => {
  const text = writeScene(parsed({ ...goodScene(), sky: [0.1, 0.1, 0.1] }), 'scene.schema.json');
  expect(text).toContain('"$schema": "scene.schema.json"');
  expect(text).toContain('"sky": [0.1, 0.1, 0.1]');
  expect(text).toContain('"ball": { "type": "sphere", "center": [0, 1, 0], "radius": 1, "material": "clay" }');
  expect(text).not.toMatch(/verticalFov|roughness|rotation|maxReflections|interpolation|description/);
});

test('names that objects inherit are ordinary names', () => {
  const scene = goodScene();
  scene.materials.toString = { reflectivity: 1 };
  scene.shapes.valueOf = { ...scene.shapes.ball, material: 'toString' };
  scene.animation[0].target = '/shapes/valueOf/center';
  const read = parsed(JSON.stringify(scene));
  expect(Object.keys(read.materials)).toContain('toString');
  expect(parsed(writeScene(read))).toEqual(read);
  expect(sceneAt(read, 1).shapes.valueOf).toMatchObject({ center: [0, 1.5, 0] });
  expect((read.shapes as Record<string, unknown>).hasOwnProperty).toBeUndefined();
});

const ODD_VALUES: readonly unknown[] = [
  null,
  true,
  '',
  'clay',
  0,
  -0,
  -1,
  0.5,
  1e-7,
  1e9,
  1e300,
  Number.NaN,
  Number.POSITIVE_INFINITY,
  [],
  [0, 0, 0],
  [1, 2],
  [1, 1, 1],
  {},
  { type: 'sphere' },
  undefined,
  7n,
  '/shapes/ball/center',
  'smooth',
  'ping-pong',
];

/** Changes, removes or swaps values at random places. */
function mutate(value: unknown, random: () => number): unknown {
  const pick = <Item>(items: readonly Item[]): Item => items[Math.floor(random() * items.length)]!;
  if (typeof value !== 'object' || value === null || random() < 0.06) {
    if (typeof value === 'number' && random() < 0.8) return value * (random() * 4 - 1);
    return pick(ODD_VALUES);
  }
  const copy = (Array.isArray(value) ? [...value] : { ...value }) as Record<string, unknown>;
  const keys = Object.keys(copy);
  if (keys.length === 0) return pick(ODD_VALUES);
  const key = pick(keys);
  if (random() < 0.05) delete copy[key];
  else copy[key] = random() < 0.05 ? copy[pick(keys)] : mutate(copy[key], random);
  return copy;
}

function expectFinite(value: unknown): void {
  if (typeof value === 'number' && !(Math.abs(value) <= 2e9)) throw new Error(`${value} in a scene`);
  if (typeof value === 'object' && value !== null) Object.values(value).forEach(expectFinite);
}

test('2,000 mutated scenes (seeds 0 … 1999): none throws, and what is accepted stays valid at any time', () => {
  let accepted = 0;
  for (let seed = 0; seed < 2000; seed++) {
    const random = seededRandom(seed);
    let draft: unknown = structuredClone([goodScene(), richScene(), scenes[seed % 3]][Math.floor(seed / 3) % 3]);
    for (let n = 0; n <= seed % 3; n++) draft = mutate(draft, random);
    const result = parseScene(draft);
    if (!result.ok) {
      expect(result.problems.length).toBeGreaterThan(0);
      continue;
    }
    accepted++;
    for (const time of [0, 0.7, -3.3, 1e9, 4 * random()]) {
      const scene = sceneAt(result.scene, time);
      expectFinite(scene);
      // A moment of a scene is a scene: without its tracks it passes all checks again.
      expect(parseScene({ ...scene, animation: [] }), `seed ${seed} at ${time} s`).toMatchObject({ ok: true });
    }
  }
  expect(accepted).toBeGreaterThan(200);
});

test('500 mutated texts (seeds 0 … 499): none throws, and none is worth more than a hundred problems', () => {
  const text = writeScene(scenes[0]!);
  for (let seed = 0; seed < 500; seed++) {
    const random = seededRandom(seed);
    const at = Math.floor(random() * text.length);
    const piece = ['', ',', '}', ']', '"', '\\', '-', '1e999', 'null', '\u0000', '{"', '[['][
      Math.floor(random() * 12)
    ]!;
    const result = parseScene(text.slice(0, at) + piece + text.slice(at + Math.floor(random() * 3)));
    if (!result.ok) expect(result.problems.length).toBeLessThanOrEqual(101);
  }
});
