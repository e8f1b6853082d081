import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, test } from 'vitest';
import { AccumulatedFilm } from './accumulated-film.ts';
import { checkFinished, type WantedPicture, whyNot } from './finished-picture.ts';
import { writeFilm } from './picture-file.ts';
import type { RenderFacts } from './render-text.ts';

const folder = mkdtempSync(join(tmpdir(), 'mirrorball-finished-'));
afterAll(() => rmSync(folder, { recursive: true }));

const settings = { maxDepth: 5 };
const identity = { scene: 'a', time: 0, width: 2, height: 1, region: [0, 0, 2, 1], integrator: 'path', seed: 0, settings } as const; // biome-ignore format: one thing
const range = (first: number, last: number) => ({ first, last });
const facts: RenderFacts = { identity, ranges: [[range(0, 63)]], whole: true, error: 0.02, look: { exposure: 0 } };
const wanted = (last: number, more: Partial<WantedPicture> = {}): WantedPicture => ({
  identity,
  goal: { wanted: range(0, last) },
  exposure: 0,
  ...more,
});

test('a picture with at least the wanted samples is kept', () => {
  expect([whyNot(facts, wanted(63)), whyNot(facts, wanted(7))]).toEqual([null, null]);
  expect(whyNot(facts, wanted(64))).toContain('only the samples 0-63 of 0-64');
  const uneven = { ...facts, ranges: [[range(0, 63)], [range(0, 31)]] };
  expect([whyNot(uneven, wanted(31)), whyNot(uneven, wanted(63))]).toEqual([null, expect.stringContaining('0-31 of')]);
});

test('so is one whose time was over, or whose error was reached', () => {
  const until = (goal: Partial<WantedPicture['goal']>) =>
    whyNot(facts, wanted(0, { goal: { wanted: range(0, 2 ** 20), ...goal } }));
  expect([until({ untilTime: 5 }), until({ untilError: 0.02 })]).toEqual([null, null]);
  expect(until({ untilError: 0.01 })).toContain('the error 0.02, which is not below 0.01');
});

test('one of another scene, of other settings or with gaps is not', () => {
  const other = whyNot({ ...facts, identity: { ...identity, scene: 'b', seed: 3 } }, wanted(7));
  expect(other).toBe('belongs to another picture: it has another scene, seed 3 instead of 0');
  expect(whyNot(facts, wanted(7, { exposure: 1 }))).toContain('exposure 0 instead of 1');
  expect(whyNot({ ...facts, whole: false }, wanted(7))).toContain('not whole');
});

test.each(['exr', 'png', 'npy', 'pfm', 'hdr'])('files: .%s', async (ending) => {
  const path = join(folder, `a.${ending}`);
  const film = new AccumulatedFilm(2);
  film.put(0, Float32Array.of(1, 2, 3, 4, 4, 3, 2, 4));
  await writeFilm(path, { identity, film, texts: {}, exposure: 0 }, { bits: '8' });
  const before = readFileSync(path);
  const told = await checkFinished(path, wanted(3));
  const hasTexts = ['exr', 'png'].includes(ending);
  expect(told.endsWith(hasTexts ? 'is there already.' : 'does not say of which scene, settings and samples.')).toBe(true); // biome-ignore format: one thing
  const larger = { ...identity, height: 2, region: [0, 0, 2, 2] } as const;
  await expect(checkFinished(path, wanted(3, { identity: larger }))).rejects.toThrow('belongs to another picture');
  if (hasTexts) await expect(checkFinished(path, wanted(4))).rejects.toThrow('only the samples 0-3 of 0-4');
  await expect(checkFinished(path, wanted(3, { aov: ['albedo'] }))).rejects.toThrow('without the AOVs albedo');
  expect(readFileSync(path).equals(before)).toBe(true);
  writeFileSync(path, 'nothing of the kind');
  await expect(checkFinished(path, wanted(3))).rejects.toThrow('cannot be read');
});
