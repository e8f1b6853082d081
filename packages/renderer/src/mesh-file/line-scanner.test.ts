import { expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { LineScanner } from './line-scanner.ts';

const scan = (text: string, options = {}) => new LineScanner(new TextEncoder().encode(text), options);

test('words, line by line, with line ends of all kinds', () => {
  const s = scan('a  bc\r\n\n\t d\re\r\n\r\nf');
  const found: [string, number][] = [];
  while (s.nextWord()) found.push([s.word(), s.line]);
  expect(found).toEqual([['a', 1], ['bc', 1], ['d', 3], ['e', 4], ['f', 6]]); // biome-ignore format: short
  expect(s.word()).toBe('');
});

test('the rest of a line, and past its end', () => {
  const s = scan('usemtl red  paint \nf 1');
  expect([s.word(), s.rest(), s.more()]).toEqual(['usemtl', 'red  paint', false]);
  s.endLine();
  expect([s.line, s.rest()]).toEqual([2, 'f 1']);
});

test('a backslash joins lines where that is the custom', () => {
  const joined = scan('f 1 2 \\\n 3\nv', { continues: true });
  expect([joined.word(), joined.number(), joined.number(), joined.number(), joined.more()]).toEqual([
    'f',
    1,
    2,
    3,
    false,
  ]);
  joined.endLine();
  expect([joined.line, joined.word()]).toEqual([3, 'v']);
  const passed = scan('# a \\\nb\nc', { continues: true });
  passed.endLine();
  expect(passed.word()).toBe('c');
});

test.each([
  ['0', 0],
  ['-0', -0],
  ['+1.5', 1.5],
  ['.25', 0.25],
  ['5.', 5],
  ['1e3', 1000],
  ['1E-3', 0.001],
  ['-1.25e+2', -125],
  ['123456789012345678901234567890', 1.2345678901234568e29],
  ['0.1234567890123456789', 0.12345678901234568],
  ['1e-40', 1e-40],
  ['1e400', Infinity],
  ['9007199254740993', 9007199254740992],
  ['inf', Infinity],
  ['-INF', -Infinity],
  ['nan', Number.NaN],
  ['-1.#IND', Number.NaN],
])('the number %s', (text, value) => {
  const s = scan(text);
  expect(s.number()).toBe(value);
  expect(s.strange).toBe(false);
  expect(s.more()).toBe(false);
});

test.each(['', 'x', '1x', '-', '.', '1e', '1e+', '1,5', '0x10', '1_0', '1.2.3', '١'])('%j is no number', (text) => {
  const s = scan(text);
  expect(s.number()).toBeNaN();
  expect(s.strange).toBe(true);
});

test('every number reads as JavaScript reads it (seed 61)', () => {
  const random = seededRandom(61);
  const float = new Float32Array(new Uint32Array(1).buffer);
  for (let k = 0; k < 20_000; k++) {
    new Uint32Array(float.buffer)[0] = random() * 2 ** 32;
    const x = k % 2 ? (random() - 0.5) * 10 ** Math.floor(30 * random() - 15) : float[0]!;
    if (!Number.isFinite(x)) continue;
    for (const text of [String(x), x.toFixed(6), x.toExponential(8), x.toPrecision(9)])
      if (scan(text).number() !== Number(text)) expect.fail(text);
  }
});

test('whole numbers end where digits end', () => {
  const s = scan('12/-3//x');
  expect([s.whole(), s.bytes[s.at]]).toEqual([12, 47]);
  s.at++;
  expect([s.whole(), s.atWordEnd]).toEqual([-3, false]);
  s.at++;
  expect([s.whole(), s.at]).toEqual([Number.NaN, 6]);
});
