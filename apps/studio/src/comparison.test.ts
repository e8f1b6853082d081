import { expect, test } from 'vitest';
import { comparisonFor, evenDividers, fitDividers, moveDivider } from './comparison.ts';

test('no comparison is null', () => {
  expect(comparisonFor('off', { maxReflections: 3, lightSamples: 9 }, [0.3, 0.6])).toBeNull();
});

test('strips differ in what is compared and in nothing else', () => {
  const reflections = comparisonFor('reflections', { maxReflections: 3, lightSamples: 16 }, [0.3, 0.6]);
  expect(reflections?.panels.map((panel) => panel.maxReflections)).toEqual([1, 2, 10]);
  expect(reflections?.panels.map((panel) => panel.lightSamples)).toEqual([16, 16, 16]);
  const samples = comparisonFor('samples', { maxReflections: 3, lightSamples: 16 }, [0.3, 0.6]);
  expect(samples?.panels.map((panel) => panel.lightSamples)).toEqual([1, 9, 64]);
  expect(samples?.panels.map((panel) => panel.maxReflections)).toEqual([3, 3, 3]);
  expect(samples?.dividers).toEqual([0.3, 0.6]);
});

test('even dividers part what is visible', () => {
  expect(evenDividers(0.75)).toEqual([0.25, 0.5]);
});

test('dividers come out from under a panel, in their order', () => {
  expect(fitDividers([0.3, 0.6], 0.7)).toEqual([0.3, 0.6]);
  expect(fitDividers([0.3, 0.9], 0.7)[1]).toBeCloseTo(0.68);
  const [first, second] = fitDividers([0.8, 0.9], 0.5);
  expect(first).toBeLessThan(second);
  expect(second).toBeLessThan(0.5);
});

test('a divider stops at the other one and at the edges', () => {
  expect(moveDivider([0.3, 0.6], 0, 0.4)).toEqual([0.4, 0.6]);
  expect(moveDivider([0.3, 0.6], 0, 0.9)[0]).toBeCloseTo(0.58);
  expect(moveDivider([0.3, 0.6], 0, -1)[0]).toBeCloseTo(0.02);
  expect(moveDivider([0.3, 0.6], 1, 0.1)[1]).toBeCloseTo(0.32);
  expect(moveDivider([0.3, 0.6], 1, 2)[1]).toBeCloseTo(0.98);
});
