import { fromInterleaved } from 'mirrorball/picture-files';
import { expect, test } from 'vitest';
import { seededRandom } from '../../../tests/fixtures/random.ts';
import { assembled, formatRegion, overlaps, uncovered } from './regions.ts';

const region = (x: number, y: number, width: number, height: number) => ({ x, y, width, height });
const whole = region(0, 0, 12, 9);

test('regions overlap where they have a pixel in common, not where they touch', () => {
  expect(overlaps(region(0, 0, 4, 4), region(4, 0, 4, 4))).toBe(false);
  expect(overlaps(region(0, 0, 4, 4), region(3, 3, 1, 1))).toBe(true);
  expect(overlaps(region(0, 0, 4, 4), region(0, 4, 4, 1))).toBe(false);
});

test('what is left out is told as regions that can be rendered', () => {
  expect(uncovered(whole, [whole])).toEqual([]);
  expect(uncovered(whole, [])).toEqual([whole]);
  const grid = [0, 4, 8].flatMap((x) => [0, 3, 6].map((y) => region(x, y, 4, 3)));
  for (const missing of grid)
    expect(
      uncovered(
        whole,
        grid.filter((tile) => tile !== missing),
      ),
    ).toEqual([missing]);
});

test('each pixel is in a region or left out, and never twice (seed 1)', () => {
  const random = seededRandom(1);
  const below = (n: number) => Math.floor(random() * n);
  for (let k = 0; k < 200; k++) {
    const regions = Array.from({ length: below(5) }, () => {
      const [x, y] = [below(12), below(9)];
      return region(x, y, 1 + below(12 - x), 1 + below(9 - y));
    });
    const counts = new Uint8Array(12 * 9);
    const gaps = uncovered(whole, regions);
    for (const { x, y, width, height } of gaps)
      for (let j = y; j < y + height; j++) for (let i = x; i < x + width; i++) counts[j * 12 + i]!++;
    for (let j = 0; j < 9; j++)
      for (let i = 0; i < 12; i++) {
        const held = regions.some((each) => overlaps(each, region(i, j, 1, 1)));
        expect(counts[j * 12 + i], `${i},${j} beside ${regions.map(formatRegion).join(' ')}`).toBe(held ? 0 : 1);
      }
  }
});

test('pictures of regions stand where they belong, and what is in none is 0', () => {
  const picture = (width: number, height: number, first: number) =>
    fromInterleaved(
      width,
      height,
      ['R', 'depth.Z'],
      Array.from({ length: width * height * 2 }, (_, i) => first + i),
    );
  const { channels } = assembled(region(1, 1, 3, 2), [
    { region: region(1, 1, 2, 1), picture: picture(2, 1, 10) },
    { region: region(3, 1, 1, 2), picture: picture(1, 2, 20) },
  ]);
  expect(channels.map(({ name, data }) => [name, ...data])).toEqual([
    ['R', 10, 12, 20, 0, 0, 22],
    ['depth.Z', 11, 13, 21, 0, 0, 23],
  ]);
});
