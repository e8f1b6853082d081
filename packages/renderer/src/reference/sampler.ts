/**
 * The sampler of docs/sampler.md, the same bits as shading/sampler/: so that the CPU can trace any pixel again, and so that
 * tests of what it promises need no GPU. Bits are kept as signed 32-bit integers between operations.
 */
import { hashOfSample } from './hash.ts';

export type SamplerKind = 'sobol' | 'independent';

/** See bits.wesl: the sixteen bits of each half in reverse order. */
export function reverseHalves(x: number): number {
  let y = ((x >>> 1) & 0x55555555) | ((x & 0x55555555) << 1);
  y = ((y >>> 2) & 0x33333333) | ((y & 0x33333333) << 2);
  y = ((y >>> 4) & 0x0f0f0f0f) | ((y & 0x0f0f0f0f) << 4);
  return ((y >>> 8) & 0x00ff00ff) | ((y & 0x00ff00ff) << 8);
}

/** C. Wellons, "Prospecting for Hash Functions", 2018, with the constants found by T. Ettinger. */
export function mix(x: number): number {
  let y = Math.imul(x ^ (x >>> 16), 0x21f0aaad);
  y = Math.imul(y ^ (y >>> 15), 0x735a2d97);
  return y ^ (y >>> 15);
}

/** Nested uniform scrambling of a number whose most significant digit is bit 0. */
export function scramble(x: number, seed: number): number {
  let y = x ^ Math.imul(x, 0x3d20adea);
  y = Math.imul(y + seed, (seed >>> 16) | 1);
  y ^= Math.imul(y, 0x05526c56);
  return y ^ Math.imul(y, 0x53a22864);
}

export function pascal(x: number): number {
  let y = x ^ ((x >>> 1) & 0x5555);
  y ^= (y >>> 2) & 0x3333;
  y ^= (y >>> 4) & 0x0f0f;
  return y ^ ((y >>> 8) & 0x00ff);
}

/** Digits of the field of four, two bits each, times its generator w, and times w². */
export const timesW = (x: number): number => ((x ^ (x << 1)) & 0xaaaa) | ((x >>> 1) & 0x5555);
export const timesW2 = (x: number): number => ((x << 1) & 0xaaaa) | ((x ^ (x >>> 1)) & 0x5555);

export function shiftOfPlace(x: number): number {
  let y = x ^ timesW((x >>> 2) & 0x33);
  y ^= timesW2((y >>> 4) & 0x0f);
  return timesW(y) | (y << 8);
}
export function pascalW2(x: number): number {
  let y = x ^ timesW2((x >>> 2) & 0x3333);
  y ^= timesW((y >>> 4) & 0x0f0f);
  return y ^ timesW2((y >>> 8) & 0x00ff);
}

/** Bits 0 to 3 to the even places. */
function spread(x: number): number {
  const y = (x | (x << 2)) & 0x33;
  return (y | (y << 1)) & 0x55;
}
const turnHalf = (x: number): number => (x >>> 16) | (x << 16);
const toUnit = (reversed: number, scrambled: number): number =>
  (((reversed << 8) | (scrambled >>> 24)) >>> 0) * 2 ** -24;

export class Sampler {
  #key: number;
  readonly #salt: number;
  readonly #sample: number;
  readonly #place: number;

  constructor(x: number, y: number, sampleIndex: number, seed: number, kind: SamplerKind = 'sobol') {
    const independent = kind === 'independent';
    this.#key = independent
      ? hashOfSample(x, y, sampleIndex, seed)
      : hashOfSample(x >>> 4, y >>> 4, sampleIndex >>> 16, seed);
    this.#salt = mix(this.#key ^ 0x6a09e667);
    const place = spread(x & 15) | (spread(y & 15) << 1);
    const reversed = independent ? 0 : reverseHalves((sampleIndex & 0xffff) | (place << 24));
    this.#sample = reversed & 0xffff;
    this.#place = reversed >>> 16;
  }

  #nextGroup() {
    this.#key = (this.#key + 1) >>> 0;
    const a = mix(this.#key);
    const half = Math.imul(a ^ this.#salt, 0x9e3779b1);
    const b = half ^ (half >>> 16);
    const place = scramble(this.#place, b);
    // As in sampler.wesl: what the pixels of a tile share, and what is each one's own.
    const mixed = this.#sample ^ Math.imul(this.#sample, (place >>> 7) & ~1);
    const index = reverseHalves(scramble(mixed, a) & 0xffff);
    const shift = shiftOfPlace(place & 0xff);
    return { index, shift, seedA: turnHalf(a), seedB: turnHalf(b) };
  }

  /** Leaves out so many calls. */
  skip(groups: number): this {
    this.#key = (this.#key + groups) >>> 0;
    return this;
  }

  next1d(): number {
    const { index, shift, seedA } = this.#nextGroup();
    const x = scramble(index ^ shift, seedA);
    return toUnit(reverseHalves(x & 0xffff), x);
  }

  next2d(): [number, number] {
    const [x, y] = this.next3d();
    return [x, y];
  }

  next3d(): [number, number, number] {
    const { index, shift, seedA, seedB } = this.#nextGroup();
    const x = scramble(index ^ shift, seedA);
    const y = scramble(pascal(index ^ timesW(shift)), seedB);
    const z = scramble(pascalW2(index ^ timesW2(shift)), seedA ^ Math.imul(seedB, 0x9e3779b1));
    const reversed = reverseHalves((x & 0xffff) | (y << 16));
    return [toUnit(reversed & 0xffff, x), toUnit(reversed >>> 16, y), toUnit(reverseHalves(z & 0xffff), z)];
  }
}
