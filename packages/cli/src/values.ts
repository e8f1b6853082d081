/** What people write after an option → numbers, each with a sentence that says what is allowed. */
import { InvalidArgumentError } from 'commander';
import type { SampleRange } from './sample-ranges.ts';

type Parse<Value> = (text: string) => Value;

const NUMBER = /^[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?$/;
const WHOLE = /^[+-]?\d+$/;

function refuse(allowed: string): never {
  throw new InvalidArgumentError(`It must be ${allowed}.`);
}

export const whole =
  (least: number, most: number): Parse<number> =>
  (text) => {
    const value = WHOLE.test(text) ? Number(text) : Number.NaN;
    return value >= least && value <= most ? value : refuse(`a whole number from ${least} to ${most}`);
  };

export const real =
  (least: number, most: number, allowed = `a number from ${least} to ${most}`): Parse<number> =>
  (text) => {
    const value = NUMBER.test(text) ? Number(text) : Number.NaN;
    return value >= least && value <= most ? value : refuse(allowed);
  };

export const positive = (most: number): Parse<number> =>
  real(Number.MIN_VALUE, most, `a number above 0, at most ${most}`);

/** "-1" or 1 … most. */
export const depth =
  (most: number): Parse<number> =>
  (text) =>
    text === '-1' ? -1 : Number(whole(1, most)(text));

export const range =
  (most: number): Parse<SampleRange> =>
  (text) => {
    const match = /^(\d+)(?:-(\d+))?$/.exec(text);
    const first = match ? Number(match[1]) : Number.NaN;
    const last = match?.[2] === undefined ? first : Number(match[2]);
    if (first <= last && last <= most) return { first, last };
    return refuse(`one whole number or two as in 0-${Math.min(most, 119)}, rising, at most ${most}`);
  };

/** Whole numbers between these signs. */
function wholes(text: string, pattern: RegExp, most: number): number[] | null {
  const match = pattern.exec(text);
  const values = match ? match.slice(1).map(Number) : [];
  return match && values.every((value) => value <= most) ? values : null;
}

export const size =
  (most: number): Parse<{ width: number; height: number }> =>
  (text) => {
    const [width = 0, height = 0] = wholes(text, /^(\d+)[x×](\d+)$/, most) ?? [];
    return width > 0 && height > 0 ? { width, height } : refuse(`WIDTHxHEIGHT as in 1280x720, each from 1 to ${most}`);
  };

export const region =
  (most: number): Parse<{ x: number; y: number; width: number; height: number }> =>
  (text) => {
    const [x = 0, y = 0, width = 0, height = 0] = wholes(text, /^(\d+),(\d+),(\d+),(\d+)$/, most) ?? [];
    if (width > 0 && height > 0) return { x, y, width, height };
    return refuse('x,y,width,height in pixels from the top left corner, as in 0,0,64,32');
  };

export const pixel =
  (most: number): Parse<{ x: number; y: number }> =>
  (text) => {
    const [x, y] = wholes(text, /^(\d+),(\d+)$/, most) ?? [];
    return x !== undefined && y !== undefined
      ? { x, y }
      : refuse('x,y in pixels from the top left corner, as in 12,34');
  };

/** Some of these, with commas between, each once. */
export const names =
  <Name extends string>(allowed: readonly Name[]): Parse<readonly Name[]> =>
  (text) => {
    const given = text.split(',').map((name) => name.trim());
    const known = allowed.filter((name) => given.includes(name));
    const strange = given.filter((name) => !allowed.some((each) => each === name));
    if (strange.length === 0 && known.length > 0) return known;
    return refuse(`some of ${allowed.join(', ')}, with commas between them, not "${strange.join(', ')}"`);
  };
