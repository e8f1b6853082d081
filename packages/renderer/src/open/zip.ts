/**
 * Zip archives (PKWARE's APPNOTE 6.3): their lists of files, and single files out of them. Nothing is unpacked before it is asked for, and
 * nothing is made that the archive only claims: counts, sizes and growth are held against limits first, contents against their check sums.
 */
import { inflateSync } from 'fflate';
import { crc32 } from '../export/crc32.ts';
import { quote } from '../scene-file/problem.ts';
import { type GivenFile, MOST_FILE_BYTES } from './file-set.ts';

export const ZIP_LIMITS = {
  entries: 10_000,
  /** Of all files together, unpacked, bytes. */
  bytes: 2 ** 31,
  /** How many times as large as the archive they may be, beyond `freeBytes`. Models shrink by two to twenty. */
  growth: 200,
  freeBytes: 2 ** 26,
  pathLength: 1024,
} as const;

/** Why an archive cannot be used; a sentence without its full stop. */
export class ZipError extends Error {
  override readonly name = 'ZipError';
}

const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
const END_BYTES = 22;
const CENTRAL_BYTES = 46;
const LOCAL_BYTES = 30;
const [STORED, DEFLATED] = [0, 8];
/** What a 32-bit field says when the number stands in a Zip64 record, which only archives beyond 4 GiB need. */
const ELSEWHERE = 0xffffffff;

export const isZip = (bytes: Uint8Array): boolean =>
  bytes.length >= END_BYTES && [LOCAL, END].includes(viewOf(bytes).getUint32(0, true));

const viewOf = (bytes: Uint8Array) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

interface Entry {
  readonly path: string;
  readonly method: number;
  readonly crc: number;
  readonly packedSize: number;
  readonly size: number;
  /** Of its local head. */
  readonly start: number;
}

/** The files of an archive, folders and the notes of operating systems left out. Throws a ZipError. */
export function readZip(bytes: Uint8Array): GivenFile[] {
  const entries = readEntries(bytes).filter(({ path }) => !path.endsWith('/') && !isNote(path));
  const size = entries.reduce((sum, entry) => sum + entry.size, 0);
  const most = Math.min(ZIP_LIMITS.bytes, ZIP_LIMITS.freeBytes + ZIP_LIMITS.growth * bytes.length);
  if (size > most)
    throw new ZipError(`it would grow from ${bytes.length} to ${size} bytes, where at most ${most} are unpacked`);
  return entries.map((entry) => ({
    path: entry.path,
    size: entry.size,
    read: async () => contentOf(bytes, entry),
  }));
}

const isNote = (path: string): boolean => /(^|\/)(__MACOSX\/|\.DS_Store$|Thumbs\.db$)/.test(path);

function readEntries(bytes: Uint8Array): Entry[] {
  const view = viewOf(bytes);
  const end = findEnd(view);
  const [count, size, start] = [view.getUint16(end + 10, true), view.getUint32(end + 12, true), view.getUint32(end + 16, true)]; // biome-ignore format: three fields
  if (count === 0xffff || start === ELSEWHERE)
    throw new ZipError('it is a Zip64 archive, which only files beyond 4 GiB need');
  if (count > ZIP_LIMITS.entries)
    throw new ZipError(`it has ${count} files, where at most ${ZIP_LIMITS.entries} are read`);
  if (start + size > end) throw new ZipError('its list of files lies outside of it');
  const entries: Entry[] = [];
  let at = start;
  for (let i = 0; i < count; i++) {
    if (at + CENTRAL_BYTES > end || view.getUint32(at, true) !== CENTRAL)
      throw new ZipError(`its list of files ends after ${i} of ${count}`);
    const [name, extra, comment] = [view.getUint16(at + 28, true), view.getUint16(at + 30, true), view.getUint16(at + 32, true)]; // biome-ignore format: three fields
    const next = at + CENTRAL_BYTES + name + extra + comment;
    if (next > end) throw new ZipError(`its list of files ends after ${i} of ${count}`);
    entries.push(readEntry(view, bytes, at, name));
    at = next;
  }
  return entries;
}

/** From the back: what ends an archive may be followed by a comment of up to 64 KiB. */
function findEnd(view: DataView): number {
  const last = view.byteLength - END_BYTES;
  for (let at = last; at >= Math.max(last - 0xffff, 0); at--)
    if (view.getUint32(at, true) === END && at + END_BYTES + view.getUint16(at + 20, true) <= view.byteLength)
      return at;
  throw new ZipError('it has no end, so it is cut off or no zip archive');
}

function readEntry(view: DataView, bytes: Uint8Array, at: number, nameLength: number): Entry {
  const flags = view.getUint16(at + 8, true);
  const path = pathOf(bytes.subarray(at + CENTRAL_BYTES, at + CENTRAL_BYTES + nameLength), (flags & 0x800) !== 0);
  const entry: Entry = {
    path,
    method: view.getUint16(at + 10, true),
    crc: view.getUint32(at + 16, true),
    packedSize: view.getUint32(at + 20, true),
    size: view.getUint32(at + 24, true),
    start: view.getUint32(at + 42, true),
  };
  if (flags & 1) throw new ZipError(`its file ${quote(path)} is encrypted`);
  if (entry.method !== STORED && entry.method !== DEFLATED)
    throw new ZipError(
      `its file ${quote(path)} is packed by method ${entry.method}, where only deflate can be unpacked`,
    );
  if (entry.start + LOCAL_BYTES + entry.packedSize > bytes.length)
    throw new ZipError(`its file ${quote(path)} lies outside of it`);
  if (entry.size > MOST_FILE_BYTES)
    throw new ZipError(`its file ${quote(path)} has ${entry.size} bytes, where at most ${MOST_FILE_BYTES} are read`);
  return entry;
}

/** UTF-8 where the archive says so or where it can be; else a letter a byte. Only such paths as lead nowhere but into the archive. */
function pathOf(name: Uint8Array, isUtf8: boolean): string {
  if (name.length > ZIP_LIMITS.pathLength) throw new ZipError(`one of its files has a path of ${name.length} bytes`);
  let path: string;
  try {
    path = new TextDecoder('utf-8', { fatal: !isUtf8 }).decode(name);
  } catch {
    path = new TextDecoder('latin1').decode(name);
  }
  const parts = path.split(/[/\\]/);
  if (/^([/\\]|[a-z]:)/i.test(path) || parts.includes('..'))
    throw new ZipError(`its file ${quote(path)} has a path that leads out of the archive`);
  return path.replaceAll('\\', '/');
}

function contentOf(bytes: Uint8Array, { method, crc, packedSize, size, start }: Entry): Uint8Array {
  const view = viewOf(bytes);
  const damaged = (how: string) => new Error(`it is damaged in the archive: ${how}`);
  if (view.getUint32(start, true) !== LOCAL) throw damaged('its head is missing');
  const from = start + LOCAL_BYTES + view.getUint16(start + 26, true) + view.getUint16(start + 28, true);
  if (from + packedSize > bytes.length) throw damaged('its end is missing');
  const packed = bytes.subarray(from, from + packedSize);
  const content = method === STORED ? packed.slice() : inflated(packed, size, damaged);
  if (content.length !== size) throw damaged(`it has ${content.length} bytes and not ${size}`);
  if (crc32(content) !== crc) throw damaged('its content does not fit its check sum');
  return content;
}

function inflated(packed: Uint8Array, size: number, damaged: (how: string) => Error): Uint8Array {
  try {
    // With `out` fflate makes nothing larger; what does not fit is dropped. The byte too many shows that.
    return inflateSync(packed, { out: new Uint8Array(size + 1) });
  } catch {
    throw damaged('it cannot be unpacked');
  }
}
