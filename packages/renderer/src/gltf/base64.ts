/** Data URIs. */

const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
const VALUES = new Uint8Array(128).fill(255);
for (let i = 0; i < LETTERS.length; i++) VALUES[LETTERS.charCodeAt(i)] = i;
VALUES['-'.charCodeAt(0)] = 62;
VALUES['_'.charCodeAt(0)] = 63;

export const isDataUri = (uri: string): boolean => /^data:/i.test(uri);

/** How many bytes a data URI stands for, told by its length alone; too many rather than too few. */
export const dataUriBytes = (uri: string): number => Math.floor((uri.length * 3) / 4);

export interface DataUri {
  /** Such as "image/png"; may be empty. */
  readonly type: string;
  readonly bytes: Uint8Array;
}

/** The content, or in words what is wrong with it. */
export function readDataUri(uri: string): DataUri | string {
  const comma = uri.indexOf(',');
  if (comma < 0) return 'a data URI without a comma';
  const head = uri.slice(5, comma);
  const type = head.split(';')[0]!.trim().toLowerCase();
  if (!/;\s*base64\s*$/i.test(head)) return textContent(uri.slice(comma + 1), type);
  const bytes = decodeBase64(uri, comma + 1);
  return bytes === null ? 'a data URI that is not base64' : { type, bytes };
}

function textContent(text: string, type: string): DataUri | string {
  try {
    return { type, bytes: new TextEncoder().encode(decodeURIComponent(text)) };
  } catch {
    return 'a data URI with a broken % sign';
  }
}

/** A program in a module: a data URI, or, as scripts/lazy-parts.mjs packs it, a letter for each byte. */
export function inlinedBytes(text: string): Uint8Array {
  if (!text.startsWith('data:')) return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const program = readDataUri(text);
  if (typeof program === 'string') throw new Error(`A program in this module is damaged: ${program}.`);
  return program.bytes;
}

/** Ends with the text or its padding. */
function decodeBase64(text: string, start: number): Uint8Array | null {
  let end = text.length;
  while (end > start && text.charCodeAt(end - 1) === 0x3d) end--;
  const bytes = new Uint8Array(Math.floor(((end - start) * 3) / 4));
  let [at, bits, held] = [0, 0, 0];
  for (let i = start; i < end; i++) {
    const code = text.charCodeAt(i);
    const value = code < 128 ? VALUES[code]! : 255;
    if (value === 255) {
      if (code <= 0x20 || code === 0x3d) continue; // line breaks, as some write them, also within the padding
      return null;
    }
    held = ((held << 6) | value) & 0xffff;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes[at++] = (held >> bits) & 255;
  }
  return bytes.subarray(0, at);
}
