import { expect, test } from './fixtures.ts';

test('a tree built in a worker is the same, comes after a fast one, and can be cancelled', async ({ harness }) => {
  const workers: unknown[] = [];
  harness.on('worker', (worker) => workers.push(worker));
  const { same, fastNodes, shares, kept, cancelled, refused } = await harness.evaluate(
    (side) => window.harness.treesFromWorker(side),
    150,
  );
  expect(workers.length, 'not in slices on the page').toBe(3);
  expect(same).toBe(true);
  expect(fastNodes.length).toBe(1);
  expect(fastNodes[0]).toBeGreaterThan(1000);
  expect(shares.length).toBeGreaterThan(4);
  expect(shares).toEqual(shares.toSorted((a, b) => a - b));
  expect(shares.at(-1)).toBe(1);
  expect(kept, "the mesh stays the caller's").toBe(true);
  expect(cancelled).toBe('enough');
  expect(refused).toMatch(/^RangeError: Triangle 0 has index 1000000000, but there are \d+ positions$/);
});
