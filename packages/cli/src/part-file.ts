/**
 * Part files: a film with its sums, so that it can go on and be put together with others. Text first, so that a person can see what
 * it is: a magic line, a line of JSON, then little-endian numbers: 3 doubles a pixel of sums, 3 of squares, and, when a block is
 * open, 4 floats of it. The JSON has their SHA-256: half a file is no file.
 */
import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { endianness } from 'node:os';
import { AccumulatedFilm } from './accumulated-film.ts';
import { CommandError, EXIT, usage } from './exit-codes.ts';
import { type FilmIdentity, isIdentity } from './film-identity.ts';
import type { SampleRange } from './sample-ranges.ts';
import { writeAtomically } from './write-atomically.ts';

const MAGIC = 'mirrorball film 1\n';
/** The header's length at most, bytes: nobody has that many ranges. */
const MOST_HEADER = 1 << 20;
const MOST_PIXELS = 2 ** 28;

export interface Part {
  readonly identity: FilmIdentity;
  readonly film: AccumulatedFilm;
  /** What else the picture's file should say: the scene's text, the program. */
  readonly texts: Readonly<Record<string, string>>;
  /** Stops, for pictures that people look at. */
  readonly exposure: number;
}

interface Header extends Omit<Part, 'film'> {
  readonly ranges: readonly SampleRange[];
  readonly blocks: number;
  readonly openFirst: number | null;
  readonly sha256: string;
}

export async function writePart(path: string, { film, ...rest }: Part): Promise<void> {
  if (endianness() !== 'LE')
    throw new CommandError(EXIT.failed, 'Part files are written on little-endian machines only.');
  const { sums, squares, blocks, ranges } = film.closed;
  const numbers = [sums, squares, ...(film.open ? [film.open.sums] : [])].map(
    ({ buffer, byteOffset, byteLength }) => new Uint8Array(buffer, byteOffset, byteLength),
  );
  const header: Header = { ...rest, ranges, blocks, openFirst: film.open?.first ?? null, sha256: hashOf(numbers) };
  await writeAtomically(path, [Buffer.from(`${MAGIC}${JSON.stringify(header)}\n`), ...numbers]);
}

const hashOf = (chunks: readonly Uint8Array[]): string => {
  const hash = createHash('sha256');
  for (const chunk of chunks) hash.update(chunk);
  return hash.digest('hex');
};

export async function readPart(path: string): Promise<Part> {
  const bytes = await readFile(path).catch((error: Error) => {
    throw usage(`The part file ${path} cannot be read: ${error.message}`);
  });
  const refuse = (why: string) => usage(`${path} is no whole part file of Mirrorball: ${why}.`);
  if (!bytes.subarray(0, MAGIC.length).equals(Buffer.from(MAGIC))) throw refuse('it does not begin like one');
  const end = bytes.indexOf('\n', MAGIC.length);
  if (end < 0 || end > MOST_HEADER) throw refuse('its header has no end');
  const header = readHeader(bytes.toString('utf8', MAGIC.length, end));
  if (!header) throw refuse('its header cannot be read');
  const { identity, texts, exposure, ranges, blocks, openFirst } = header;
  const pixels = identity.region[2] * identity.region[3];
  const body = bytes.subarray(end + 1);
  const needed = pixels * (openFirst === null ? 48 : 64);
  if (body.length !== needed) throw refuse(`${body.length} bytes of numbers instead of ${needed}`);
  if (hashOf([body]) !== header.sha256) throw refuse('its numbers have changed since it was written');
  // Copies, since typed arrays must begin at a multiple of their size.
  const floats = (from: number, to: number) => new Uint8Array(body.subarray(from, to)).buffer;
  const closed = {
    sums: new Float64Array(floats(0, pixels * 24)),
    squares: new Float64Array(floats(pixels * 24, pixels * 48)),
    blocks,
    ranges,
  };
  const open = openFirst === null ? null : { first: openFirst, sums: new Float32Array(floats(pixels * 48, needed)) };
  return { identity, texts, exposure, film: new AccumulatedFilm(pixels, closed, open) };
}

const isCount = (value: unknown): value is number => Number.isSafeInteger(value) && (value as number) >= 0;

/** Null when it is not what `writePart` writes. */
function readHeader(text: string): Header | null {
  try {
    const header = JSON.parse(text) as Header;
    const { identity, ranges, blocks, openFirst, texts, exposure, sha256 } = header;
    const good =
      isIdentity(identity) &&
      isCount(blocks) &&
      identity.region[2] * identity.region[3] <= MOST_PIXELS &&
      Array.isArray(ranges) &&
      ranges.every(
        ({ first, last }, i) => isCount(first) && isCount(last) && first <= last && first > (ranges[i - 1]?.last ?? -1),
      ) &&
      (openFirst === null || isCount(openFirst)) &&
      Number.isFinite(exposure) &&
      [sha256, ...Object.values(texts)].every((value) => typeof value === 'string');
    return good ? header : null;
  } catch {
    return null;
  }
}
