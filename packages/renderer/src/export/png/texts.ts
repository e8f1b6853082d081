/** Texts in PNG: tEXt for Latin-1, which every tool shows, iTXt (UTF-8) for the rest. */
import { ImageError } from '../image-error.ts';
import type { Chunk } from './chunks.ts';

/** Printable Latin-1 and new lines; keys without the latter. */
const LATIN = /^[\n\x20-\x7e\xa1-\xff]*$/;
const KEY = /^[\x20-\x7e\xa1-\xff]{1,79}$/;

export function writeText(key: string, text: string): Chunk {
  if (!KEY.test(key)) throw new ImageError('PNG file to write', 'another name of a text', '1 to 79 printable letters');
  if (LATIN.test(text)) return { type: 'tEXt', data: latinBytes(`${key}\0${text}`) };
  const head = latinBytes(`${key}\0\0\0\0\0`); // not packed, no language, no translated name
  const utf8 = new TextEncoder().encode(text);
  const data = new Uint8Array(head.length + utf8.length);
  data.set(head);
  data.set(utf8, head.length);
  return { type: 'iTXt', data };
}

function latinBytes(text: string): Uint8Array {
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** Null for another chunk, and for packed texts, which are not unfolded. */
export function readText({ type, data }: Chunk): { key: string; text: string } | null {
  if (type !== 'tEXt' && type !== 'iTXt') return null;
  const latin1 = new TextDecoder('latin1');
  const keyEnd = data.indexOf(0);
  if (keyEnd < 1 || keyEnd > 79) throw new ImageError(`PNG chunk ${type}`, 'no name', 'a name of 1 to 79 bytes');
  const key = latin1.decode(data.subarray(0, keyEnd));
  if (type === 'tEXt') return { key, text: latin1.decode(data.subarray(keyEnd + 1)) };
  if (data[keyEnd + 1] !== 0) return null;
  const languageEnd = data.indexOf(0, keyEnd + 3);
  const translatedEnd = languageEnd < 0 ? -1 : data.indexOf(0, languageEnd + 1);
  if (translatedEnd < 0) throw new ImageError('PNG chunk iTXt', 'no text', 'name, language, translated name and text');
  return { key, text: new TextDecoder().decode(data.subarray(translatedEnd + 1)) };
}
