import { expect, test } from 'vitest';
import { seededRandom } from '../../../../../tests/fixtures/random.ts';
import { assignSlots } from './slots.ts';

const octant = (s: number): number[] => {
  const least = [2, 1, 0].map((bit) => ((s >> bit) & 1 ? 0 : -1));
  return [...least, ...least.map((x) => x + 1)];
};

test('eight children in the octants lie in the slots of these octants, so a ray meets slots in order of s xor its signs', () => {
  expect(assignSlots([-1, -1, -1, 1, 1, 1], [0, 1, 2, 3, 4, 5, 6, 7], octant)).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
  for (let signs = 0; signs < 8; signs++) {
    const direction = [2, 1, 0].map((bit) => ((signs >> bit) & 1 ? -1 : 1));
    const distance = (s: number) =>
      octant(s)
        .slice(0, 3)
        .reduce((sum, x, axis) => sum + x * direction[axis]!, 0);
    const slots = [0, 1, 2, 3, 4, 5, 6, 7].sort((a, b) => (a ^ signs) - (b ^ signs));
    expect(distance(slots[0]!)).toBe(Math.min(...slots.map(distance)));
    expect(distance(slots[7]!)).toBe(Math.max(...slots.map(distance)));
  }
});

test('every child gets a slot of its own, however they lie (seed 84)', () => {
  const random = seededRandom(84);
  for (let k = 0; k < 200; k++) {
    const children = Array.from({ length: Math.floor(random() * 9) }, (_, i) => i);
    const boxes = children.map(() => {
      const least = [random(), random(), Math.round(random())];
      return [...least, ...least];
    });
    const slots = assignSlots([0, 0, 0, 1, 1, 1], children, (child) => boxes[child]!);
    expect(slots.length).toBe(8);
    expect(slots.filter((child) => child >= 0).sort()).toEqual(children);
  }
});
