import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { builtInScenes } from 'mirrorball/built-in';
import { afterAll, expect, test } from 'vitest';
import { AccumulatedFilm } from './accumulated-film.ts';
import { differences, identityOf, sceneHash } from './film-identity.ts';
import { readPart, writePart } from './part-file.ts';

const folder = mkdtempSync(join(tmpdir(), 'mirrorball-part-'));
afterAll(() => rmSync(folder, { recursive: true }));

const scene = builtInScenes[0]!.scene;
const settings = { integrator: 'classic', maxDepth: -1, maxReflections: 5, lightSamples: 9, seed: 1 } as const;
const size = { width: 4, height: 3, area: { x: 1, y: 0, width: 2, height: 3 } };
const identity = identityOf(scene, 0.5, settings, size);

function aFilm(): AccumulatedFilm {
  const film = new AccumulatedFilm(6);
  const sums = (n: number) => Float32Array.from({ length: 24 }, (_, i) => (i % 4 === 3 ? n : i / 7));
  film.put(0, sums(32));
  film.put(32, sums(5));
  return film;
}

test('comes back as it was, with its open block', async () => {
  const path = join(folder, 'a.part');
  const film = aFilm();
  await writePart(path, { identity, film, texts: { Title: '球' }, exposure: 1 });
  const part = await readPart(path);
  expect(part).toMatchObject({ identity, texts: { Title: '球' }, exposure: 1 });
  expect(part.film.closed).toEqual(film.closed);
  expect(part.film.open).toEqual(film.open);
  expect(part.film.ranges).toEqual([{ first: 0, last: 36 }]);
  expect(readdirSync(folder)).toEqual(['a.part']);
});

test('half a file, a changed number, another file: refused, with the reason', async () => {
  const path = join(folder, 'b.part');
  await writePart(path, { identity, film: aFilm(), texts: {}, exposure: 0 });
  const bytes = readFileSync(path);
  const broken = async (change: (b: Buffer<ArrayBuffer>) => Buffer) => {
    writeFileSync(path, change(Buffer.from(bytes)));
    await expect(readPart(path)).rejects.toThrow(`${path} is no whole part file of Mirrorball`);
  };
  for (const length of [0, 5, 30, 200, bytes.length - 1]) await broken((b) => b.subarray(0, length));
  await broken((b) => Buffer.concat([b, Buffer.from([0])]));
  await broken((b) => {
    b[b.length - 3]! ^= 1;
    return b;
  });
  await broken((b) => Buffer.from(b.toString('latin1').replace('"blocks":1', '"blocks":-1'), 'latin1'));
  await broken((b) => Buffer.from(b.toString('latin1').replace('"region":[1,0,2,3]', '"region":[1,0,2]'), 'latin1'));
  await expect(readPart(join(folder, 'none.part'))).rejects.toThrow('cannot be read');
});

test('the fingerprint counts what the picture depends on, and nothing else', () => {
  const { render, materials } = scene;
  expect(sceneHash({ ...scene, name: 'x', description: 'y', render: { ...render, maxReflections: 1 } })).toBe(
    sceneHash(scene),
  );
  const [[first, material]] = Object.entries(materials) as [[string, (typeof materials)[string]]];
  const reversed = Object.fromEntries(Object.entries(material).reverse()) as unknown as typeof material;
  expect(sceneHash({ ...scene, materials: { ...materials, [first]: reversed } })).toBe(sceneHash(scene));
  const changed = { ...material, roughness: material.roughness / 2 };
  expect(sceneHash({ ...scene, materials: { ...materials, [first]: changed } })).not.toBe(sceneHash(scene));
  const lights = Object.fromEntries([...Object.entries(scene.lights), ['b', {}], ['a', {}]]);
  const otherOrder = Object.fromEntries([...Object.entries(scene.lights), ['a', {}], ['b', {}]]);
  expect(sceneHash({ ...scene, lights } as never)).not.toBe(sceneHash({ ...scene, lights: otherOrder } as never));
});

test('differences are told by name', () => {
  expect(differences(identity, identity)).toEqual([]);
  const other = identityOf(scene, 0.5, { ...settings, seed: 2, lightSamples: 4 }, { ...size, width: 8 });
  expect(differences(other, identity)).toEqual([
    'width 8 instead of 4',
    'seed 2 instead of 1',
    'lightSamples 4 instead of 9',
  ]);
});
