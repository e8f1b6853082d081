import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { writeScene } from '../../packages/renderer/src/scene-file/index.ts';
import { referenceNames, referencePicture, referenceScene } from './references.ts';

test('there are references', () => expect(referenceNames).toContain('C1'));

test.each(referenceNames)('%s: scene, means and errors can be read', (name) => {
  const scene = referenceScene(name);
  expect(scene.name).toBe(name);
  expect(scene.render.integrator).toBe('path');
  const { width, height, mean, error } = referencePicture(name);
  expect([width, height, mean.length, error.length]).toEqual([64, 64, 64 * 64 * 3, 64 * 64 * 3]);
  const wrong = Array.from(mean).filter((m, i) => {
    const e = error[i]!;
    return !(m >= 0 && e >= 0 && Number.isFinite(m) && Number.isFinite(e)) || (m > 0 && e === 0);
  });
  expect(wrong).toEqual([]);
});

test.each(referenceNames)('%s: the file is as the scene writer writes it', (name) => {
  const text = readFileSync(new URL(`${name}/scene.json`, import.meta.url), 'utf8');
  expect(text).toBe(writeScene(referenceScene(name), '../../../packages/renderer/scene.schema.json'));
});

test.each(['F1_diffuse', 'F1_glass'])('%s: the furnace is 1 everywhere, within six standard errors', (name) => {
  const { mean, error } = referencePicture(name);
  expect(Array.from(mean).filter((m, i) => !(Math.abs(m - 1) <= 6 * error[i]! + 1e-6))).toEqual([]);
});
