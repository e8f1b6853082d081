/** Texts whose bytes are not UTF-8. */
import type { FileProblems } from './file-problems.ts';

/** Bytes that are decoded at a time. */
const PIECE = 1 << 20;

/**
 * A text that begins with the mark of UTF-16 (Windows' editors and PowerShell write it), as UTF-8; any other as it is. UTF-8 takes at
 * most 3 bytes for 2 of UTF-16.
 */
export function asUtf8(bytes: Uint8Array, problems: FileProblems): Uint8Array {
  const [first, second] = bytes;
  const encoding =
    first === 0xff && second === 0xfe ? 'utf-16le' : first === 0xfe && second === 0xff ? 'utf-16be' : null;
  if (encoding === null) return bytes;
  if (bytes.length % 2 !== 0)
    problems.fail({ byte: bytes.length - 1 }, 'half a letter of UTF-16', 'two bytes a letter');
  const decoder = new TextDecoder(encoding);
  const encoder = new TextEncoder();
  const text = new Uint8Array((bytes.length >> 1) * 3);
  let length = 0;
  for (let at = 0; at < bytes.length; at += PIECE) {
    const piece = decoder.decode(bytes.subarray(at, at + PIECE), { stream: at + PIECE < bytes.length });
    length += encoder.encodeInto(piece, text.subarray(length)).written;
  }
  return text.subarray(0, length);
}
