/** The sampler's arithmetic against slow versions that follow the definitions bit by bit. */
import { describe, expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { hashOfSample } from './hash.ts';
import { pascal, pascalW2, reverseHalves, Sampler, scramble, shiftOfPlace, timesW, timesW2 } from './sampler.ts';

const range = (n: number) => Array.from({ length: n }, (_, k) => k);
const bit = (x: number, k: number) => (x >>> k) & 1;
const fromBits = (bits: readonly number[]) => bits.reduce((sum, b, k) => sum + b * 2 ** k, 0);
const reversed16 = (x: number) => fromBits(range(16).map((k) => bit(x, 15 - k)));

/** Digits 0, 1, w, w + 1 of the field of four: multiplied as polynomials in w with w² = w + 1. */
function multiply(a: number, b: number): number {
  const high = bit(a, 1) & bit(b, 1);
  const middle = (bit(a, 1) & bit(b, 0)) ^ (bit(a, 0) & bit(b, 1));
  const low = bit(a, 0) & bit(b, 0);
  return ((middle ^ high) << 1) | (low ^ high);
}
const W = 2;
const W2 = 3;
const power = (a: number, n: number): number => (n === 0 ? 1 : multiply(a, power(a, n - 1)));
/** Lucas: binomial(c, r) is odd if and only if r has no bit that c lacks. */
const oddBinomial = (c: number, r: number) => ((r & ~c) === 0 ? 1 : 0);
const digit = (x: number, k: number) => (x >>> (2 * k)) & 3;

/** Row r: the sum over c of binomial(c, r) a^(c − r) x_c, in the field of four. */
function slowPascal(a: number, x: number): number {
  return range(8).reduce((sum, r) => {
    const terms = range(8 - r).map((k) => multiply(oddBinomial(r + k, r) * power(a, k), digit(x, r + k)));
    return sum + terms.reduce((s, t) => s ^ t, 0) * 4 ** r;
  }, 0);
}
/** Sobol's second dimension: direction numbers of the polynomial x + 1, v_k = v_(k−1) xor v_(k−1) / 2. */
function slowSecondSobol(index: number): number {
  let [direction, sum] = [0x8000, 0];
  for (const k of range(16)) {
    if (bit(index, k)) sum ^= direction;
    direction ^= direction >>> 1;
  }
  return sum;
}

/** Owen's scrambling by its definition: a tree, with at each node one flip for all numbers that share the digits before. */
function slowScramble(x: number, seed: number): number {
  let before = 0;
  const bits = range(32).map((k) => {
    const flip = bit(scramble(before, seed), k);
    const digitHere = bit(x, k);
    before = (before | (digitHere << k)) >>> 0;
    return digitHere ^ flip;
  });
  return fromBits(bits);
}

describe('bits', () => {
  test('reversed halves, Sobol directions, products in the field of four', () => {
    const wrong = range(65536).filter((x) => {
      if (reverseHalves(x) !== reversed16(x) || pascal(x) !== reversed16(slowSecondSobol(x))) return true;
      if (x % 31 !== 0) return false;
      const product = (a: number) => range(8).reduce((sum, k) => sum + multiply(a, digit(x, k)) * 4 ** k, 0);
      return pascalW2(x) !== slowPascal(W2, x) || timesW(x) !== product(W) || timesW2(x) !== product(W2);
    });
    expect(wrong).toEqual([]);
    expect(reverseHalves(0x80010003) >>> 0).toBe(0x8001c000);
    for (const x of range(256)) expect(shiftOfPlace(x)).toBe(slowPascal(W, x << 8));
  });

  test('scrambling is nested: each bit is flipped by a function of the bits before it (seed 21)', () => {
    const random = seededRandom(21);
    for (const _ of range(2000)) {
      const [x, seed] = [Math.floor(random() * 2 ** 32), Math.floor(random() * 2 ** 32)];
      expect(scramble(x, seed) >>> 0).toBe(slowScramble(x, seed));
    }
  });

  test('its flips are fair, each and in pairs, down to the fourth bit (seed 22)', () => {
    const random = seededRandom(22);
    const n = 20000;
    const nodes = [0, 1, 2, 3].flatMap((depth) => range(2 ** depth).map((before) => ({ depth, before })));
    const flips = range(n).map(() => {
      const seed = Math.floor(random() * 2 ** 32);
      return nodes.map(({ depth, before }) => 1 - 2 * bit(scramble(before, seed), depth));
    });
    for (const a of nodes.keys())
      for (const b of nodes.keys()) {
        const sum = flips.reduce((s, row) => s + row[a]! * (a === b ? 1 : row[b]!), 0);
        expect(Math.abs(sum) / Math.sqrt(n), `${a}, ${b}`).toBeLessThan(4.5);
      }
  });
});

const cut = (n: bigint) => n & 0xffffffffn;
function slowMix(x: bigint): bigint {
  const first = cut((cut(x) ^ (cut(x) >> 16n)) * 0x21f0aaadn);
  const second = cut((first ^ (first >> 15n)) * 0x735a2d97n);
  return second ^ (second >> 15n);
}

/** next3d by the definitions of docs/sampler.md. */
function slowDraw(x: number, y: number, sample: number, group: number, seed: number): number[] {
  const hash = hashOfSample(Math.floor(x / 16), Math.floor(y / 16), Math.floor(sample / 65536), seed);
  const a = Number(slowMix(BigInt(hash + group + 1)));
  const product = Number(cut((BigInt(a) ^ slowMix(BigInt(hash) ^ 0x6a09e667n)) * 0x9e3779b1n));
  const b = (product ^ (product >>> 16)) >>> 0;
  // Morton order from the coarsest quadrant on: digits y₃x₃, y₂x₂ …
  const quadrants = fromBits(range(8).map((k) => bit(k % 2 === 0 ? y % 16 : x % 16, 3 - (k >> 1))));
  const place = slowScramble(quadrants, b);
  const shift = slowPascal(W, (place % 256) * 256);
  const own = 2 * Math.floor(place / 256);
  const reversed = reversed16(sample % 65536);
  const mixed = (reversed ^ Math.imul(reversed, own)) >>> 0;
  const index = reversed16(slowScramble(mixed, a) % 65536);
  const half = (n: number) => ((n >>> 16) | (n << 16)) >>> 0;
  const times = (factor: number) => range(8).reduce((sum, k) => sum + multiply(factor, digit(shift, k)) * 4 ** k, 0);
  const second = reversed16(slowSecondSobol(index ^ times(W)));
  const third = slowPascal(W2, index ^ times(W2));
  const seeds = [half(a), half(b), (half(a) ^ Math.imul(half(b), 0x9e3779b1)) >>> 0];
  return [index ^ shift, second, third].map((digits, d) => {
    const scrambled = slowScramble(digits, seeds[d]!);
    return (reversed16(scrambled % 65536) * 256 + Math.floor(scrambled / 2 ** 24)) / 2 ** 24;
  });
}

test('a draw is its definition, bit for bit (seed 23)', () => {
  const random = seededRandom(23);
  const below = (n: number) => Math.floor(random() * n);
  for (const _ of range(1000)) {
    const [x, y, sample, group, seed] = [below(4096), below(4096), below(2 ** 18), below(200), below(2 ** 32)] as const;
    expect(new Sampler(x, y, sample, seed).skip(group).next3d()).toEqual(slowDraw(x, y, sample, group, seed));
  }
});
