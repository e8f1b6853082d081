import { expect, test } from 'vitest';
import { startSavings } from './savings.ts';

test('is due every so many seconds, and seldom enough that a slow disk costs a twentieth of the time', async () => {
  let [now, cost, written] = [100, 0, 0];
  const write = async () => {
    now += cost;
    written++;
  };
  const savings = startSavings(60, write, () => now);
  now = 159;
  expect(savings.due()).toBe(false);
  now = 160;
  expect(savings.due()).toBe(true);
  await savings.save();
  expect([written, savings.due()]).toEqual([1, false]);
  now = 220;
  expect(savings.due()).toBe(true);
  cost = 10;
  await savings.save();
  now = 230 + 199;
  expect(savings.due()).toBe(false);
  now = 230 + 200;
  expect(savings.due()).toBe(true);
});
