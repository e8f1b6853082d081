import { expect, test } from 'vitest';
import { workgroupOf } from './workgroup.ts';

test('128 threads, however many samples they share', () => {
  for (const samples of [1, 2, 3, 8, 31, 32, 33, 256]) {
    const { shares, tile } = workgroupOf(samples);
    expect(shares * tile[0] * tile[1]).toBe(128);
    expect(shares).toBeLessThanOrEqual(samples);
    expect([tile[0] / tile[1], shares].join()).toMatch(/^[12],/);
  }
  expect(workgroupOf(1)).toEqual({ shares: 1, tile: [16, 8] });
  expect(workgroupOf(256)).toEqual({ shares: 32, tile: [2, 2] });
});
