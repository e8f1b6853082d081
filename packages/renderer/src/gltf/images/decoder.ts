/** Who makes pixels of image files. */
import type { ImagePixels } from '../../scene/textures.ts';
import { browserDecoder } from './browser-decoder.ts';
import { decodePng } from './png-pixels.ts';

/** Given to the importer, which itself knows no canvas. */
export interface ImageDecoder {
  /** Whether files of this kind, such as "image/webp", can be decoded. */
  canDecode(type: string): boolean;
  /** 8-bit RGBA, not multiplied with alpha, no colour profile applied. Rejects with an Error that says why in a few words. */
  decode(bytes: Uint8Array, type: string): Promise<ImagePixels>;
}

/** PNG alone, by code of our own: the same pixels on every machine. */
export const pngDecoder: ImageDecoder = {
  canDecode: (type) => type === 'image/png',
  decode: async (bytes) => decodePng(bytes),
};

/** What the machine offers: a browser's decoders, or PNG. */
export const defaultDecoder = (): ImageDecoder => browserDecoder() ?? pngDecoder;
