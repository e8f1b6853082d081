import * as v from 'valibot';
import { SCENE_LIMITS } from '../scene/limits.ts';

/**
 * The kinds of value in a scene file. The message of each schema is a phrase that says what is allowed; it completes
 * "it must be …" in a problem and is what an editor shows.
 */

const FARTHEST = 1e9;

/** 1e9 rather than 1000000000. */
const short = (n: number): string => (Math.abs(n) >= 1e6 ? n.toExponential().replace('+', '') : String(n));

/** A finite number from `min` to `max`. */
export function number(what: string, min: number, max: number) {
  const allowed = `${what}: a number from ${short(min)} to ${short(max)}`;
  return v.pipe(v.number(allowed), v.minValue(min, allowed), v.maxValue(max, allowed), v.description(allowed));
}

/** A whole number from `min` to `max`. */
export function integer(what: string, min: number, max: number) {
  const allowed = `${what}: a whole number from ${short(min)} to ${short(max)}`;
  return v.pipe(
    v.number(allowed),
    v.integer(allowed),
    v.minValue(min, allowed),
    v.maxValue(max, allowed),
    v.description(allowed),
  );
}

type Triple = readonly [number, number, number];

/** A list of three numbers, each from `min` to `max`. */
export function triple(what: string, min: number, max: number) {
  const allowed = `${what}: a list of three numbers, each from ${short(min)} to ${short(max)}`;
  const one = `one number of ${what}: from ${short(min)} to ${short(max)}`;
  const item = v.pipe(v.number(one), v.minValue(min, one), v.maxValue(max, one));
  // Not a tuple: a list of the wrong length is one problem of the list, not one of each number that is missing.
  const schema = v.pipe(v.array(item, allowed), v.length(3, allowed), v.description(allowed));
  return schema as unknown as v.GenericSchema<Triple, Triple>;
}

/** A list of so many numbers, each from `min` to `max`. */
export function numbers(what: string, count: number, min: number, max: number) {
  const allowed = `${what}: a list of ${count} numbers, each from ${short(min)} to ${short(max)}`;
  const one = `one number of ${what}: from ${short(min)} to ${short(max)}`;
  const item = v.pipe(v.number(one), v.minValue(min, one), v.maxValue(max, one));
  return v.pipe(v.array(item, allowed), v.length(count, allowed), v.description(allowed));
}

/** A list of three numbers of either sign, whose size is from `least` to `most`. */
export function factors(what: string, least: number, most: number) {
  const range = `from ${short(-most)} to ${short(most)} and not nearer to 0 than ${short(least)}`;
  const allowed = `${what}: a list of three numbers, each ${range}`;
  const one = `one number of ${what}: ${range}`;
  const far = v.check((x: number) => Math.abs(x) >= least, one);
  const item = v.pipe(v.number(one), v.minValue(-most, one), v.maxValue(most, one), far);
  const schema = v.pipe(v.array(item, allowed), v.length(3, allowed), v.description(allowed));
  return schema as unknown as v.GenericSchema<Triple, Triple>;
}

export const point = (what: string) => triple(`${what}, metres`, -FARTHEST, FARTHEST);
export const direction = (what: string) => triple(what, -FARTHEST, FARTHEST);
export const color = (what: string, max: number) => triple(`${what}, linear [red, green, blue]`, 0, max);
export const share = (what: string) => number(what, 0, 1);

/** A text of at most `max` characters. */
export function text(what: string, max: number) {
  const allowed = `${what}: a text of at most ${short(max)} characters`;
  return v.pipe(v.string(allowed), v.maxLength(max, allowed), v.description(allowed));
}

/** The name of another thing of the same scene. */
export const nameOf = (what: string) => text(`the name of ${what} of this scene`, SCENE_LIMITS.nameLength);

/** A list of two numbers. */
export function pair(what: string, least: number, most: number) {
  return numbers(what, 2, least, most) as unknown as v.GenericSchema<
    readonly [number, number],
    readonly [number, number]
  >;
}

/** A list of at most so many of something. */
export function listOf<Schema extends v.GenericSchema>(what: string, item: Schema, most: number) {
  const allowed = `${what}: a list of at most ${short(most)}`;
  return v.pipe(v.array(item, allowed), v.maxLength(most, allowed), v.description(allowed));
}

/** Recorded numbers, as a plain list or as a list of lists. However many of them are wrong, they are one problem. */
export function manyNumbers(what: string) {
  const allowed = `${what}: a list of numbers, each from ${short(-FARTHEST)} to ${short(FARTHEST)}, or of lists of them`;
  const isGood = (x: unknown) => typeof x === 'number' && Math.abs(x) <= FARTHEST;
  return v.pipe(
    v.array(v.union([v.array(v.unknown()), v.unknown()]), allowed),
    v.check((list) => list.flat().every(isGood), allowed),
    v.description(allowed),
    v.transform((list) => Float32Array.from(list.flat() as number[])),
  );
}

/** Names of files with one of these endings: no address, no path from the root, no control character. */
export function filePattern(endings: readonly string[]): RegExp {
  // JSON Schema has no flag for letters of either size.
  const letters = (ending: string) => ending.replace(/[a-z]/g, (letter) => `[${letter}${letter.toUpperCase()}]`);
  return new RegExp(`^(?!\\/)[^\\\\:\\u0000-\\u001f]+\\.(?:${endings.map(letters).join('|')})$`);
}

/** The name of a file with one of these endings, which the rule tells. */
export const fileName = (rule: string, endings: readonly string[]) =>
  v.pipe(v.string(rule), v.maxLength(1000, rule), v.regex(filePattern(endings), rule), v.description(rule));

/** One of these words. */
export function choice<const Options extends readonly string[]>(what: string, options: Options) {
  const allowed = `${what}: ${options.map((option) => `"${option}"`).join(' or ')}`;
  return v.pipe(v.picklist(options, allowed), v.description(allowed));
}

/** True or false. */
export function flag(what: string) {
  const allowed = `${what}: true or false`;
  return v.pipe(v.boolean(allowed), v.description(allowed));
}

/** Exactly this word, which tells which kind of thing an object is. */
export const kind = <const Word extends string>(word: Word) => v.literal(word, `"${word}"`);

type Message = string | ((issue: { expected: string | null }) => string) | undefined;
interface HasMessage {
  readonly message?: Message;
  readonly wrapped?: HasMessage;
}
const allowedBy = ({ message, wrapped }: HasMessage): string => {
  if (wrapped !== undefined) return allowedBy(wrapped);
  return typeof message === 'function' ? message({ expected: 'Object' }) : (message ?? 'a value');
};

/** An object with these keys and no others. */
export function object<const Entries extends v.ObjectEntries>(what: string, entries: Entries) {
  const message = (issue: { expected: string | null }): string => {
    const missing = issue.expected?.match(/^"(.*)"$/)?.[1];
    const entry = missing === undefined ? undefined : entries[missing];
    return entry === undefined ? what : allowedBy(entry as unknown as HasMessage);
  };
  return v.pipe(v.strictObject(entries, message), v.description(what));
}
