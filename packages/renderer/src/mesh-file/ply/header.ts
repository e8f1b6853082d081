/** The head of a PLY file (G. Turk, "The PLY Polygon File Format", 1994): which numbers follow, in which order and form. */
import { quote } from '../../scene-file/problem.ts';
import type { FileProblems } from '../file-problems.ts';
import { LineScanner } from '../line-scanner.ts';

export type PlyType = 'i8' | 'u8' | 'i16' | 'u16' | 'i32' | 'u32' | 'f32' | 'f64';
export const TYPE_BYTES: Readonly<Record<PlyType, number>> = {
  i8: 1,
  u8: 1,
  i16: 2,
  u16: 2,
  i32: 4,
  u32: 4,
  f32: 4,
  f64: 8,
};

export interface PlyProperty {
  readonly name: string;
  readonly type: PlyType;
  /** Of a list: the type of the number of items, which stands before them. */
  readonly count: PlyType | null;
}
export interface PlyElement {
  readonly name: string;
  readonly count: number;
  readonly properties: PlyProperty[];
  /** Of its line in the header. */
  readonly line: number;
}
export type PlyFormat = 'ascii' | 'binary_little_endian' | 'binary_big_endian';

export interface PlyHeader {
  readonly format: PlyFormat;
  readonly elements: readonly PlyElement[];
  /** Where the numbers begin: the byte, and the line. */
  readonly start: number;
  readonly line: number;
}

const FORMATS: readonly string[] = ['ascii', 'binary_little_endian', 'binary_big_endian'] satisfies PlyFormat[];
const TYPES: Readonly<Record<string, PlyType>> = {
  char: 'i8',
  int8: 'i8',
  uchar: 'u8',
  uint8: 'u8',
  short: 'i16',
  int16: 'i16',
  ushort: 'u16',
  uint16: 'u16',
  int: 'i32',
  int32: 'i32',
  uint: 'u32',
  uint32: 'u32',
  float: 'f32',
  float32: 'f32',
  double: 'f64',
  float64: 'f64',
};
const TYPE_RULE = `one of the types ${Object.keys(TYPES).join(', ')}`;

/** Lines of a header, elements and properties of one: more than any file has. */
const MOST_LINES = 10_000;
const MOST_ELEMENTS = 100;
const MOST_PROPERTIES = 1000;

export function readPlyHeader(bytes: Uint8Array, problems: FileProblems): PlyHeader {
  // A header is a text; what follows may be none, and then holds line ends anywhere.
  const scan = new LineScanner(bytes);
  const magic = scan.word();
  if (magic !== 'ply') problems.fail({ line: 1 }, `${describe(magic)} at its start`, 'the word "ply"');
  let format: PlyFormat | null = null;
  const elements: PlyElement[] = [];
  for (let lines = 0; ; lines++) {
    scan.endLine();
    if (!scan.nextWord() || lines > MOST_LINES)
      problems.fail({ line: scan.line }, 'no end of the header', 'the line "end_header"');
    const { line } = scan;
    const keyword = scan.word();
    if (keyword === 'end_header') break;
    if (keyword === 'format') format = readFormat(scan, problems);
    else if (keyword === 'element') elements.push(readElement(scan, elements.length, problems));
    else if (keyword === 'property') readProperty(scan, elements.at(-1), problems);
    else if (keyword !== 'comment' && keyword !== 'obj_info')
      problems.add(
        { line },
        `the word ${describe(keyword)} in its header`,
        '"format", "element", "property", "comment" or "end_header"',
      );
  }
  if (format === null)
    problems.add({ line: scan.line }, 'no line "format" in its header', `one of ${FORMATS.join(', ')}`);
  if (!problems.isEmpty || format === null) return problems.stop();
  const start = afterLine(bytes, scan.at, format);
  return { format, elements, start, line: scan.line + 1 };
}

const describe = (word: string): string => (word === '' ? 'nothing' : quote(word));

function readFormat(scan: LineScanner, problems: FileProblems): PlyFormat | null {
  const { line } = scan;
  const [word, version] = [scan.word(), scan.word()];
  if (!FORMATS.includes(word)) problems.add({ line }, `the format ${describe(word)}`, `one of ${FORMATS.join(', ')}`);
  if (version !== '1.0') problems.add({ line }, `the version ${describe(version)}`, '1.0');
  return FORMATS.includes(word) ? (word as PlyFormat) : null;
}

function readElement(scan: LineScanner, before: number, problems: FileProblems): PlyElement {
  const { line } = scan;
  const [name, count] = [scan.word(), scan.word()];
  if (before >= MOST_ELEMENTS) problems.fail({ line }, 'too many elements', `at most ${MOST_ELEMENTS} of them`);
  if (!/^\d{1,15}$/.test(count))
    problems.add({ line }, `${describe(count)} as the number of ${describe(name)}`, 'a whole number from 0 on');
  return { name, count: Number(count) || 0, properties: [], line };
}

function readProperty(scan: LineScanner, element: PlyElement | undefined, problems: FileProblems): void {
  const { line } = scan;
  const first = scan.word();
  const [count, type] = first === 'list' ? [scan.word(), scan.word()] : [null, first];
  const name = scan.word();
  const bad = [count, type].find((word) => word !== null && !Object.hasOwn(TYPES, word));
  if (!element) problems.add({ line }, 'a property before any element', 'an element first');
  else if (bad !== undefined) problems.add({ line }, `the type ${describe(bad ?? '')}`, TYPE_RULE);
  else if (name === '') problems.add({ line }, 'a property without a name', 'a type and a name');
  else if (element.properties.length >= MOST_PROPERTIES)
    problems.fail({ line }, 'too many properties', `at most ${MOST_PROPERTIES}`);
  else element.properties.push({ name, type: TYPES[type]!, count: count === null ? null : TYPES[count]! });
}

/** Where the line of "end_header" ends. In binary files a "\r" alone ends it only if others end so: the next byte may be anything. */
function afterLine(bytes: Uint8Array, at: number, format: PlyFormat): number {
  const [newline, carriage] = [10, 13];
  let end = at;
  if (format === 'ascii') return end;
  while (end < bytes.length && bytes[end] !== newline && bytes[end] !== carriage) end++;
  if (bytes[end] !== carriage) return Math.min(end + 1, bytes.length);
  const first = bytes.indexOf(carriage);
  return end + (bytes[first + 1] === newline ? 2 : 1);
}
