import { formatPointer } from '../scene/pointer.ts';

/** One thing that is wrong with a scene file. All texts are short, and safe to show. */
export interface Problem {
  /** JSON Pointer to the place; "" is the whole file. */
  readonly path: string;
  /** What stands there. */
  readonly found: string;
  /** What may stand there. */
  readonly allowed: string;
  /** All of this as an English sentence. */
  readonly message: string;
}

/** So many problems are listed; one more line tells how many there are beyond. */
export const MOST_PROBLEMS = 100;

export type Path = readonly (string | number)[];

/** Collects problems; keeps the first `MOST_PROBLEMS` and counts the rest. */
export class ProblemList {
  #kept: Problem[] = [];
  #beyond = 0;

  get isEmpty(): boolean {
    return this.#kept.length === 0;
  }

  /** `message` is made of the other parts when left out. */
  add(path: Path, found: string, allowed: string, message?: string): void {
    const pointer = formatPointer(path.map((segment) => (typeof segment === 'string' ? clip(segment, 200) : segment)));
    const last = this.#kept.at(-1);
    // Two rules of one phrase, as "whole" and "from 0".
    if (last?.path === pointer && last.allowed === allowed && last.found === found) return;
    if (this.#kept.length >= MOST_PROBLEMS) {
      this.#beyond++;
      return;
    }
    const place = pointer === '' ? 'In the scene' : `At ${visible(pointer)}`;
    this.#kept.push({
      path: pointer,
      found,
      allowed,
      message: message ?? `${place}: found ${found}; expected ${allowed}.`,
    });
  }

  list(): Problem[] {
    if (this.#beyond === 0) return [...this.#kept];
    const found = `${this.#beyond} more`;
    const allowed = 'none';
    return [...this.#kept, { path: '', found, allowed, message: `… and ${this.#beyond} more problems.` }];
  }
}

/** The text cut to `most` characters. */
export const clip = (text: string, most: number): string => (text.length > most ? `${text.slice(0, most - 1)}…` : text);

/** Writes out what an eye cannot see or what would turn the line around. */
export const visible = (text: string): string =>
  text.replace(/[\p{Cc}\p{Cf}\p{Cs}\p{Zl}\p{Zp}]/gu, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`);

/** With a full stop, if it has none. */
export const sentence = (text: string): string => (/[.!?]$/.test(text) ? text : `${text}.`);

/** A text in quotes, clipped and made visible. */
export const quote = (text: string, most = 40): string => `"${visible(clip(text, most))}"`;

/** A short excerpt of any value. Never throws and never runs through a large one. */
export function describe(value: unknown): string {
  try {
    if (value === undefined) return 'nothing';
    if (typeof value === 'symbol') return value.description ?? 'a symbol';
    if (typeof value === 'string') return `the text ${quote(value)}`;
    if (typeof value === 'number' || typeof value === 'boolean' || value === null) return String(value);
    if (typeof value === 'bigint') return 'a BigInt';
    if (typeof value === 'function') return 'a function';
    if (!Array.isArray(value))
      return Object.prototype.toString
        .call(value)
        .replace(/^\[object (.*)\]$/, 'an object ($1)')
        .replace(' (Object)', '');
    if (value.length > 4) return `a list of ${value.length} items`;
    return `[${value.map((item) => (typeof item === 'object' ? '…' : describe(item))).join(', ')}]`;
  } catch {
    return 'something that cannot be read';
  }
}

/** The name among `candidates` that `name` may have been meant to be, or null. */
export function nearest(name: string, candidates: readonly string[]): string | null {
  const wanted = clip(name, 40).toLowerCase();
  let best: string | null = null;
  let least = wanted.length < 4 ? 2 : Math.max(2, Math.floor(wanted.length / 3)) + 1;
  for (const candidate of candidates) {
    const distance = editDistance(wanted, clip(candidate, 40).toLowerCase());
    if (distance < least) [best, least] = [candidate, distance];
  }
  return best;
}

/** Levenshtein's distance, one row at a time. */
function editDistance(a: string, b: string): number {
  let row = Array.from({ length: b.length + 1 }, (_, index) => index);
  for (let i = 1; i <= a.length; i++) {
    const next = [i];
    for (let j = 1; j <= b.length; j++) {
      const replaced = row[j - 1]! + (a[i - 1] === b[j - 1] ? 0 : 1);
      next.push(Math.min(replaced, row[j]! + 1, next[j - 1]! + 1));
    }
    row = next;
  }
  return row[b.length]!;
}
