import { expect, test } from 'vitest';
import { colorOfName } from './number-colors.ts';

const names = Array.from({ length: 200 }, (_, k) => `/shapes/box ${k}`);

test('each name has a colour on the screen, not black, always the same', () => {
  for (const name of names) {
    const color = colorOfName(name);
    expect(Math.max(...color)).toBeGreaterThan(0.4);
    expect(color.every((x) => x >= 0 && x <= 1)).toBe(true);
    expect(colorOfName(name)).toEqual(color);
  }
});

test('neighbours are told apart', () => {
  const far = names.slice(1).filter((name, k) => {
    const [a, b] = [colorOfName(name), colorOfName(names[k]!)];
    return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > 0.1;
  });
  expect(far.length).toBeGreaterThan(0.9 * names.length);
});
