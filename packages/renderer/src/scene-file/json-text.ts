/**
 * Reads JSON text as `JSON.parse` does, and tells two things that it does not: where exactly text is broken, in the
 * same words in every browser, and which keys stand twice in one object (the first would be lost without a word).
 */
export type JsonText =
  | { readonly ok: true; readonly value: unknown; readonly duplicates: readonly Duplicate[] }
  | { readonly ok: false; readonly at: TextPlace; readonly expected: string };

export interface Duplicate {
  readonly path: readonly (string | number)[];
  readonly at: TextPlace;
}

/** Line and column count from 1. */
export interface TextPlace {
  readonly line: number;
  readonly column: number;
  /** The text at the place, at most 30 characters of its line; empty at the end of the text. */
  readonly excerpt: string;
}

/** Deeper than any scene: what lies there is refused later, so it is not looked through. */
const DEEPEST = 64;
const MOST_DUPLICATES = 20;

export function readJsonText(text: string): JsonText {
  const start = text.charCodeAt(0) === 0xfeff ? 1 : 0; // a byte order mark, which some editors write
  try {
    const value: unknown = JSON.parse(start === 0 ? text : text.slice(start));
    const scan = new Scanner(text, start);
    scan.run();
    return { ok: true, value, duplicates: scan.duplicates };
  } catch {
    const scan = new Scanner(text, start);
    const expected = scan.run() ?? 'JSON text that this browser can read';
    return { ok: false, at: placeOf(text, scan.offset), expected };
  }
}

function placeOf(text: string, offset: number): TextPlace {
  let line = 1;
  let lineStart = 0;
  for (let at = text.indexOf('\n'); at !== -1 && at < offset; at = text.indexOf('\n', at + 1)) {
    line++;
    lineStart = at + 1;
  }
  const excerpt = text
    .slice(offset, offset + 30)
    .split('\n', 1)[0]!
    .trimEnd();
  return { line, column: offset - lineStart + 1, excerpt };
}

interface Level {
  /** The keys so far, or null in a list. */
  readonly keys: Set<string> | null;
  key: string;
  index: number;
}

const SPACE = /[ \t\n\r]*/y;
const SCALAR = /true|false|null|-?(?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?/y;
const ESCAPE = /\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4})/y;

/** Walks through JSON text token by token, without recursion. */
class Scanner {
  readonly duplicates: Duplicate[] = [];
  readonly #levels: Level[] = [];
  readonly #text: string;
  offset: number;

  constructor(text: string, offset: number) {
    this.#text = text;
    this.offset = offset;
  }

  /** Goes to the end, or to the first mistake; then gives what should stand there. */
  run(): string | null {
    for (;;) {
      const wrong = this.#openValue();
      if (wrong === 'opened') continue;
      if (wrong !== null) return wrong;
      const after = this.#closeValues();
      if (after === 'next') continue;
      return after;
    }
  }

  #skip(pattern: RegExp): number {
    pattern.lastIndex = this.offset;
    const length = pattern.exec(this.#text)?.[0].length ?? 0;
    this.offset += length;
    return length;
  }

  #peek(): string {
    this.#skip(SPACE);
    return this.#text[this.offset] ?? '';
  }

  /** One value; 'opened' when it is the first thing in a list or object that has begun. */
  #openValue(): string | null {
    const next = this.#peek();
    if (next === '"') return this.#string();
    if (next !== '{' && next !== '[') return this.#skip(SCALAR) > 0 ? null : 'a value';
    if (this.#levels.length >= DEEPEST) return 'less nesting';
    this.offset++;
    if (this.#peek() === (next === '{' ? '}' : ']')) {
      this.offset++;
      return null;
    }
    this.#levels.push({ keys: next === '{' ? new Set() : null, key: '', index: 0 });
    return (next === '{' ? this.#key() : null) ?? 'opened';
  }

  /** After a value: ends what ends here; 'next' when another value follows; null at the good end of the text. */
  #closeValues(): string | null {
    for (;;) {
      const next = this.#peek();
      const level = this.#levels.at(-1);
      if (level === undefined) return next === '' ? null : 'the end of the file';
      const close = level.keys ? '}' : ']';
      if (next === close) {
        this.#levels.pop();
        this.offset++;
      } else if (next === ',') {
        this.offset++;
        level.index++;
        return (level.keys ? this.#key() : null) ?? 'next';
      } else return `"," or "${close}"`;
    }
  }

  /** A key with its colon. */
  #key(): string | null {
    if (this.#peek() !== '"') return 'a key in double quotes';
    const start = this.offset;
    const wrong = this.#string();
    if (wrong !== null) return wrong;
    const level = this.#levels.at(-1)!;
    level.key = JSON.parse(this.#text.slice(start, this.offset)) as string;
    if (level.keys?.has(level.key) && this.duplicates.length < MOST_DUPLICATES) {
      const path = this.#levels.map(({ keys, key, index }) => (keys ? key : index));
      this.duplicates.push({ path, at: placeOf(this.#text, start) });
    }
    level.keys?.add(level.key);
    if (this.#peek() !== ':') return '":"';
    this.offset++;
    return null;
  }

  /** A text in double quotes. By hand: a regular expression would keep a way back for every character. */
  #string(): string | null {
    const start = this.offset++;
    for (;;) {
      const code = this.#text.charCodeAt(this.offset);
      if (code === 0x22) {
        this.offset++;
        return null;
      }
      if (code === 0x5c) {
        if (this.#skip(ESCAPE) === 0) return 'one of \\" \\\\ \\/ \\b \\f \\n \\r \\t \\u0000';
      } else if (code < 0x20 || Number.isNaN(code)) {
        if (Number.isNaN(code) || code === 0x0a) this.offset = start;
        return 'a text that ends with a double quote on its own line';
      } else this.offset++;
    }
  }
}
