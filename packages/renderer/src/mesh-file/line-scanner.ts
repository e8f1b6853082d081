/** Words and numbers of a text, line by line, straight from its bytes: a text of a gigabyte never becomes a string. */

const TAB = 9;
const NEWLINE = 10;
const RETURN = 13;
const SPACE = 32;
const BACKSLASH = 92;

const utf8 = new TextDecoder();
/** Powers of ten that a double holds exactly. */
const POWERS = Float64Array.from({ length: 23 }, (_, k) => Number(`1e${k}`));
/** Whole numbers below are exact, also when one more digit is added. */
const EXACT = 2 ** 53 / 10 - 1;
/** A word of more bytes is no number that anybody wrote. */
const LONGEST_NUMBER = 400;

export class LineScanner {
  readonly bytes: Uint8Array;
  /** Of what was read last; counted from 1. */
  line = 1;
  at: number;
  /** Whether the word that `number` read last was no number at all, not even one written as "nan" or "inf". */
  strange = false;
  readonly #continues: boolean;

  /** `continues`: a backslash before a line's end makes the next line a part of this one. */
  constructor(bytes: Uint8Array, { start = 0, line = 1, continues = false } = {}) {
    this.bytes = bytes;
    // Past the mark of byte order that some editors write.
    this.at = start === 0 && bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf ? 3 : start;
    this.line = line;
    this.#continues = continues;
  }

  /** Goes to the first word of this line, or of the next one that has a word. False at the end of the text. */
  nextWord(): boolean {
    while (!this.more()) {
      if (this.at >= this.bytes.length) return false;
      this.#passLineEnd();
    }
    return true;
  }

  /** Goes past the end of this line. */
  endLine(): void {
    const { bytes } = this;
    for (;;) {
      while (this.at < bytes.length && bytes[this.at] !== NEWLINE && bytes[this.at] !== RETURN) this.at++;
      if (this.at >= bytes.length) return;
      const continued = this.#continues && bytes[this.at - 1] === BACKSLASH;
      this.#passLineEnd();
      if (!continued) return;
    }
  }

  /** Goes to the next word of this line, if there is one. */
  more(): boolean {
    const { bytes } = this;
    for (;;) {
      const byte = bytes[this.at];
      if (byte === SPACE || byte === TAB) this.at++;
      else if (byte === BACKSLASH && this.#continues && isLineEnd(bytes[this.at + 1])) {
        this.at++;
        this.#passLineEnd();
      } else if (byte === undefined || isLineEnd(byte)) return false;
      else return true;
    }
  }

  /** The next word of this line; "" at its end. */
  word(): string {
    if (!this.more()) return '';
    const start = this.at;
    this.#passWord();
    // Keywords are short, and there is one in each line.
    if (this.at === start + 1 && this.bytes[start]! < 128) return String.fromCharCode(this.bytes[start]!);
    return utf8.decode(this.bytes.subarray(start, this.at));
  }

  /** What is left of this line, without spaces at either end. */
  rest(): string {
    if (!this.more()) return '';
    const start = this.at;
    while (this.at < this.bytes.length && !isLineEnd(this.bytes[this.at])) this.at++;
    return utf8.decode(this.bytes.subarray(start, this.at)).trim();
  }

  /** The next word of this line as a number. NaN, with `strange`, for anything else and at the line's end. */
  number(): number {
    this.strange = false;
    if (!this.more()) {
      this.strange = true;
      return Number.NaN;
    }
    const start = this.at;
    const { bytes } = this;
    let at = start;
    const negative = bytes[at] === 45;
    if (negative || bytes[at] === 43) at++;
    // D. Gay's and W. Clinger's easy case: few digits, and a small power of ten, make one rounding.
    let [digits, power, any] = [0, 0, false];
    for (let d = bytes[at]! - 48; d >= 0 && d <= 9 && digits < EXACT; d = bytes[++at]! - 48, any = true)
      digits = 10 * digits + d;
    if (bytes[at] === 46) {
      at++;
      for (let d = bytes[at]! - 48; d >= 0 && d <= 9 && digits < EXACT; d = bytes[++at]! - 48, any = true, power--)
        digits = 10 * digits + d;
    }
    if ((bytes[at] === 101 || bytes[at] === 69) && any) {
      at++;
      const down = bytes[at] === 45;
      if (down || bytes[at] === 43) at++;
      let exponent = 0;
      any = false;
      for (let d = bytes[at]! - 48; d >= 0 && d <= 9 && exponent < 1000; d = bytes[++at]! - 48, any = true)
        exponent = 10 * exponent + d;
      power += down ? -exponent : exponent;
    }
    if (!any || !isWordEnd(bytes[at]) || power < -22 || power > 22) return this.#longNumber(start);
    this.at = at;
    const size = power < 0 ? digits / POWERS[-power]! : digits * POWERS[power]!;
    return negative ? -size : size;
  }

  /** Of this form: digits, perhaps a point among them, perhaps an exponent; or how programs write what is no number. */
  #longNumber(start: number): number {
    this.#passWord();
    const word = utf8.decode(this.bytes.subarray(start, Math.min(this.at, start + LONGEST_NUMBER + 1)));
    if (/^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?$/.test(word) && word.length <= LONGEST_NUMBER) return Number(word);
    const infinite = /^[+-]?(?:inf(?:inity)?|1\.#inf)$/i.test(word);
    if (infinite) return word.startsWith('-') ? -Infinity : Infinity;
    this.strange = !/^[+-]?(?:nan|1\.#(?:qnan|snan|ind))/i.test(word);
    return Number.NaN;
  }

  get atWordEnd(): boolean {
    return isWordEnd(this.bytes[this.at]);
  }

  /** The whole number that begins right here, up to what is no digit; NaN when there is none. */
  whole(): number {
    const { bytes } = this;
    const start = this.at;
    const negative = bytes[start] === 45;
    let at = negative || bytes[start] === 43 ? start + 1 : start;
    const first = at;
    let x = 0;
    for (let d = bytes[at]! - 48; d >= 0 && d <= 9 && x < EXACT; d = bytes[++at]! - 48) x = 10 * x + d;
    if (at === first) return Number.NaN;
    this.at = at;
    return negative ? -x : x;
  }

  #passWord(): void {
    while (this.at < this.bytes.length && !isWordEnd(this.bytes[this.at])) this.at++;
  }

  /** "\r\n" is one end, and so is either of the two alone. */
  #passLineEnd(): void {
    if (this.bytes[this.at] === RETURN && this.bytes[this.at + 1] === NEWLINE) this.at++;
    this.at++;
    this.line++;
  }
}

const isLineEnd = (byte: number | undefined): boolean => byte === NEWLINE || byte === RETURN;
const isWordEnd = (byte: number | undefined): boolean =>
  byte === SPACE || byte === NEWLINE || byte === TAB || byte === RETURN || byte === undefined;
