/** Names for a scene's things: those of the file, made such that each is there once and a scene file could hold them. */

/** Names that objects of JavaScript have by nature. */
const RESERVED = ['__proto__', 'constructor', 'prototype'];
/** A little less than SCENE_LIMITS.nameLength, so that a number still fits. */
const LONGEST = 180;

export class Names {
  readonly #taken = new Set<string>();
  /** How often a name has been wanted. */
  readonly #counts = new Map<string, number>();

  /** `wanted`, or `otherwise` when there is none; with a number behind it when that is taken. */
  unique(wanted: string | undefined, otherwise: string): string {
    const base = tidy(wanted ?? '') || tidy(otherwise) || 'thing';
    let count = this.#counts.get(base) ?? 0;
    let name: string;
    do {
      count++;
      name = count === 1 && !RESERVED.includes(base) ? base : `${base} ${Math.max(count, 2)}`;
      if (count === 1 && RESERVED.includes(base)) count = 2;
    } while (this.#taken.has(name.normalize('NFC')));
    this.#counts.set(base, count);
    this.#taken.add(name.normalize('NFC'));
    return name;
  }
}

/** On one line, without space at its ends. */
function tidy(text: string): string {
  const line = text.replace(/[\p{Cc}\p{Cf}\p{Cs}\p{Zl}\p{Zp}\s]+/gu, ' ').trim();
  return line.length > LONGEST
    ? line
        .slice(0, LONGEST)
        .replace(/[\uD800-\uDBFF]$/, '')
        .trimEnd()
    : line;
}
