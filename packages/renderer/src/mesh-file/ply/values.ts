/** The numbers after a PLY header, one after another, whether they are text or bytes. */
import { quote } from '../../scene-file/problem.ts';
import type { FileProblems, Place } from '../file-problems.ts';
import { LineScanner } from '../line-scanner.ts';
import { type PlyElement, type PlyHeader, type PlyType, TYPE_BYTES } from './header.ts';

export interface PlyValues {
  /** Makes ready for an element's next row. */
  startRow(): void;
  next(type: PlyType): number;
  /** Where the row began. */
  readonly place: Place;
  /** Refuses so many items of a list when there is no room for them in what is left of the file. */
  expectItems(count: number, type: PlyType): void;
  /** Refuses an element of more rows than there is room for in what is left of the file. */
  expectRows(element: PlyElement): void;
  /** Goes past rows that nobody asks for, if they need not be looked at. */
  skipRows(element: PlyElement): boolean;
}

export const valuesOf = (bytes: Uint8Array, header: PlyHeader, problems: FileProblems): PlyValues =>
  header.format === 'ascii' ? new TextValues(bytes, header, problems) : new BinaryValues(bytes, header, problems);

const sizeText = (bytes: number): string => (bytes === 1 ? '1 byte' : `${bytes} bytes`);

/** At least so many bytes are there for `count` rows: what `least` gives for a property. */
function needed({ count, properties }: PlyElement, least: (type: PlyType, isList: boolean) => number): number {
  return count * properties.reduce((sum, p) => sum + least(p.count ?? p.type, p.count !== null), 0);
}

function refuse(element: PlyElement, bytes: number, left: number, problems: FileProblems): void {
  const { name, count, line } = element;
  if (bytes <= left) return;
  problems.fail(
    { line },
    `${count} × ${quote(name)}, which take at least ${sizeText(bytes)}, and ${sizeText(left)} left for them`,
    'as many as there are in the file',
  );
}

class BinaryValues implements PlyValues {
  readonly #view: DataView;
  readonly #little: boolean;
  readonly #problems: FileProblems;
  #at: number;
  #row: number;

  constructor(bytes: Uint8Array, { start, format }: PlyHeader, problems: FileProblems) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.#little = format === 'binary_little_endian';
    this.#problems = problems;
    this.#at = start;
    this.#row = start;
  }

  get place(): Place {
    return { byte: this.#row };
  }

  startRow(): void {
    this.#row = this.#at;
  }

  next(type: PlyType): number {
    const at = this.#at;
    const end = at + TYPE_BYTES[type];
    if (end > this.#view.byteLength)
      this.#problems.fail({ byte: at }, 'its end in the middle of a row', 'all the rows that its header tells of');
    this.#at = end;
    const [view, little] = [this.#view, this.#little];
    switch (type) {
      case 'i8':
        return view.getInt8(at);
      case 'u8':
        return view.getUint8(at);
      case 'i16':
        return view.getInt16(at, little);
      case 'u16':
        return view.getUint16(at, little);
      case 'i32':
        return view.getInt32(at, little);
      case 'u32':
        return view.getUint32(at, little);
      case 'f32':
        return view.getFloat32(at, little);
      case 'f64':
        return view.getFloat64(at, little);
    }
  }

  get #left(): number {
    return this.#view.byteLength - this.#at;
  }

  expectItems(count: number, type: PlyType): void {
    if (count * TYPE_BYTES[type] <= this.#left) return;
    this.#problems.fail(
      { byte: this.#row },
      `a list of ${count} items, and ${sizeText(this.#left)} left`,
      'the whole list',
    );
  }

  expectRows(element: PlyElement): void {
    refuse(
      element,
      needed(element, (type) => TYPE_BYTES[type]),
      this.#left,
      this.#problems,
    );
  }

  skipRows(element: PlyElement): boolean {
    if (element.properties.some(({ count }) => count !== null)) return false;
    this.#at += needed(element, (type) => TYPE_BYTES[type]);
    return true;
  }
}

/** Each row is a line. */
class TextValues implements PlyValues {
  readonly #scan: LineScanner;
  readonly #problems: FileProblems;

  constructor(bytes: Uint8Array, { start, line }: PlyHeader, problems: FileProblems) {
    // What is left of the header's last line is passed over by the first row.
    this.#scan = new LineScanner(bytes, { start, line: line - 1 });
    this.#problems = problems;
  }

  get place(): Place {
    return { line: this.#scan.line };
  }

  startRow(): void {
    this.#scan.endLine();
    if (!this.#scan.nextWord()) this.#problems.fail(this.place, 'its end', 'all the rows that its header tells of');
  }

  next(type: PlyType): number {
    const { at } = this.#scan;
    const x = this.#scan.number();
    const fractional = type === 'f32' || type === 'f64';
    if (this.#scan.strange || !(fractional || Number.isInteger(x))) {
      this.#scan.at = at;
      const word = this.#scan.word();
      const allowed = fractional ? 'a number' : 'a whole number';
      this.#problems.fail(this.place, word === '' ? 'too few numbers in a row' : quote(word), allowed);
    }
    return x;
  }

  get #left(): number {
    return this.#scan.bytes.length - this.#scan.at;
  }

  /** A digit and a space each, but after the last. */
  expectItems(count: number): void {
    if (2 * count - 1 <= this.#left) return;
    this.#problems.fail(this.place, `a list of ${count} items, and ${sizeText(this.#left)} left`, 'the whole list');
  }

  expectRows(element: PlyElement): void {
    const least =
      Math.max(
        element.count,
        needed(element, () => 2),
      ) - 1;
    refuse(element, least, this.#left, this.#problems);
  }

  skipRows({ count, properties }: PlyElement): boolean {
    if (properties.length === 0) return true;
    for (let row = 0; row < count; row++) this.startRow();
    return true;
  }
}
