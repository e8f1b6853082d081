/** A zip archive of NumPy arrays, stored or deflated; read only. PKWARE's APPNOTE has the format. */
import { ByteReader } from './byte-reader.ts';
import { crc32 } from './crc32.ts';
import { checkBytes, ImageError, MOST_BYTES } from './image-error.ts';
import { inflate } from './inflate.ts';
import { type NpyArray, readNpyArray } from './npy.ts';

/** Arrays by name, without ".npy". Each is unpacked when it is asked for. */
export interface Npz {
  readonly names: readonly string[];
  has(name: string): boolean;
  read(name: string): NpyArray;
}

interface Entry {
  readonly method: number;
  readonly crc: number;
  readonly packedSize: number;
  readonly size: number;
  readonly offset: number;
}

const END = 0x06054b50;
const CENTRAL = 0x02014b50;
const LOCAL = 0x04034b50;
const END_BYTES = 22;
const LONGEST_COMMENT = 65535;
const DIRECTORY = 'NPZ directory';

export function readNpz(bytes: Uint8Array): Npz {
  const entries = readDirectory(bytes);
  return {
    names: [...entries.keys()],
    has: (name) => entries.has(name),
    read(name) {
      const entry = entries.get(name);
      if (!entry) throw new ImageError('NPZ file', `no array ${name}`, [...entries.keys()].slice(0, 8).join(', '));
      return readNpyArray(unpack(bytes, entry));
    },
  };
}

function readDirectory(bytes: Uint8Array): Map<string, Entry> {
  const end = findEnd(bytes);
  const reader = new ByteReader(bytes);
  reader.offset = end + 10;
  const count = reader.u16(DIRECTORY);
  reader.u32(DIRECTORY); // its length, which shows by itself
  const start = reader.u32(DIRECTORY);
  if (start > end || count * 46 > end - start)
    throw new ImageError(DIRECTORY, `${count} entries from byte ${start} on`, `entries before byte ${end}`);
  reader.offset = start;
  const entries = new Map<string, Entry>();
  for (let i = 0; i < count; i++) {
    const [name, entry] = readEntry(reader);
    if (name.endsWith('.npy')) entries.set(name.slice(0, -4), entry);
  }
  return entries;
}

/** The end mark stands before a comment that may be empty. */
function findEnd(bytes: Uint8Array): number {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const first = Math.max(0, bytes.length - END_BYTES - LONGEST_COMMENT);
  for (let at = bytes.length - END_BYTES; at >= first; at--) if (view.getUint32(at, true) === END) return at;
  throw new ImageError('NPZ file', 'no directory at its end', 'a whole zip archive');
}

function readEntry(reader: ByteReader): [name: string, entry: Entry] {
  const u16 = (): number => reader.u16(DIRECTORY);
  const u32 = (): number => reader.u32(DIRECTORY);
  const skip = (count: number): unknown => reader.take(count, DIRECTORY);
  if (u32() !== CENTRAL) throw new ImageError(DIRECTORY, 'another mark', 'the mark of an entry');
  skip(4); // versions
  if (u16() & 1) throw new ImageError(DIRECTORY, 'an encrypted file', 'files that can be read');
  const method = u16();
  skip(4); // time
  const [crc, packedSize, size] = [u32(), u32(), u32()];
  const [nameLength, extraLength, commentLength] = [u16(), u16(), u16()];
  skip(8); // disk, attributes
  const offset = u32();
  const name = new TextDecoder().decode(reader.take(nameLength, DIRECTORY));
  skip(extraLength + commentLength);
  return [name, { method, crc, packedSize, size, offset }];
}

function unpack(bytes: Uint8Array, { method, crc, packedSize, size, offset }: Entry): Uint8Array {
  const part = 'NPZ array';
  const reader = new ByteReader(bytes);
  checkBytes(part, offset, bytes.length);
  reader.offset = offset;
  if (reader.u32(part) !== LOCAL) throw new ImageError(part, 'another mark', 'the mark of a file');
  reader.take(22, part); // what the directory has too
  const skipped = reader.u16(part) + reader.u16(part);
  reader.take(skipped, part);
  const packed = reader.take(packedSize, part);
  if (size > MOST_BYTES) throw new ImageError(part, `${size} bytes`, `at most ${MOST_BYTES} bytes`);
  if (method !== 0 && method !== 8) throw new ImageError(part, `the packing ${method}`, '0 (stored) or 8 (deflated)');
  if (method === 0 && size !== packedSize) throw new ImageError(part, `${packedSize} bytes`, `${size} bytes`);
  const unpacked = method === 0 ? packed : inflate(packed, size, part);
  if (crc32(unpacked) !== crc) throw new ImageError(part, 'bytes that do not fit their check sum', 'unchanged bytes');
  return unpacked;
}
