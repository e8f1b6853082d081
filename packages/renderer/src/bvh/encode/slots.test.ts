import { expect, test } from 'vitest';
import { seededRandom } from '../../../../../tests/fixtures/random.ts';
import { assignSlots } from './slots.ts';

/** The box of an octant of the cube from −1 to 1. */
const octant = (s: number): number[] => {
  const least = [2, 1, 0].map((bit) => ((s >> bit) & 1 ? 0 : -1));
  return [...least, ...least.map((x) => x + 1)];
};
const all = [0, 1, 2, 3, 4, 5, 6, 7];

test('eight children in the octants lie in the slots of these octants, so a ray meets slots in order of s xor its signs', () => {
  const bounds = Float32Array.from([-1, -1, -1, 1, 1, 1, ...all.flatMap(octant)]);
  const nodes = all.map((s) => s + 1);
  expect(assignSlots(bounds, 0, nodes)).toEqual(all);
  for (let signs = 0; signs < 8; signs++) {
    const direction = [2, 1, 0].map((bit) => ((signs >> bit) & 1 ? -1 : 1));
    const distance = (s: number) => direction.reduce((sum, sign, axis) => sum + sign * octant(s)[axis]!, 0);
    const slots = all.toSorted((a, b) => (a ^ signs) - (b ^ signs));
    expect(distance(slots[0]!)).toBe(Math.min(...slots.map(distance)));
    expect(distance(slots[7]!)).toBe(Math.max(...slots.map(distance)));
  }
});

test('every child gets a slot of its own, however they lie (seed 84)', () => {
  const random = seededRandom(84);
  for (let k = 0; k < 200; k++) {
    const children = all.slice(0, Math.floor(random() * 9));
    const places = [0, ...children].map(() => [random(), random(), Math.round(random())]);
    const slots = assignSlots(
      Float32Array.from(places.flatMap((p) => [...p, ...p])),
      0,
      children.map((c) => c + 1),
    );
    expect(slots.length).toBe(8);
    expect(slots.filter((child) => child >= 0).sort()).toEqual(children);
  }
});
