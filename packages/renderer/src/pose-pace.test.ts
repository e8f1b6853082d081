import { expect, test } from 'vitest';
import { testScene } from '../../../tests/fixtures/scenes.ts';
import { PosePace } from './pose-pace.ts';
import type { Moment } from './scene/motion.ts';

const scene = testScene({}, {});
const at = (time: number, played = scene): Moment => ({ scene, played, time });

test('a quick device: what was asked for with the frame before is drawn, and the next is asked for at once', () => {
  const pace = new PosePace();
  const [first, second] = [at(0), at(0.016)];
  expect(pace.wants(first, false)).toBe(first);
  expect(pace.drawn(false)).toBe(true);
  pace.asked(first);
  expect(pace.wants(second, true)).toBe(first);
  expect(pace.drawn(true)).toBe(true);
  pace.asked(second);
  expect(pace.wants(at(0.032), true)).toBe(second);
});

test('a slow device: what is old when a frame can be begun is asked for anew, once, and then one pose a frame is enough', () => {
  const pace = new PosePace();
  pace.asked(at(0));
  const [second, third] = [at(0.2), at(0.4)];
  expect(pace.wants(second, true)).toBe(second);
  expect(pace.wants(at(0.3), true)).toBe(second);
  expect(pace.drawn(true)).toBe(false);
  expect(pace.wants(third, true)).toBe(third);
  // It has nothing to do, so it has become quick.
  expect(pace.drawn(false)).toBe(true);
});

test('what is old is drawn where the device waits for it; what is of another scene never', () => {
  const pace = new PosePace();
  const old = at(0);
  pace.asked(old);
  expect(pace.wants(at(9), false)).toBe(old);
  const other = at(9, { ...scene });
  expect(pace.wants(other, false)).toBe(other);
});
