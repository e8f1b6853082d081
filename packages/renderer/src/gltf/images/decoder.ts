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

/** The decoder, and KTX2 beside what it decodes. */
export const withKtx2 = (decoder: ImageDecoder): ImageDecoder => ({
  canDecode: (type) => type === 'image/ktx2' || decoder.canDecode(type),
  decode: async (bytes, type) => {
    if (type !== 'image/ktx2') return decoder.decode(bytes, type);
    const { decodeKtx2 } = await import('./ktx2-decoder.ts');
    return decodeKtx2(bytes);
  },
});

/** What the machine offers: a browser's decoders, or PNG; and KTX2. */
export const defaultDecoder = (): ImageDecoder => withKtx2(browserDecoder() ?? pngDecoder);
