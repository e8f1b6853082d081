import { encode } from 'fast-png';
import type { ImagePixels } from '../scene/textures.ts';

/** An image as a PNG file with its alpha. */
export const pngOf = ({ width, height, rgba }: ImagePixels): Uint8Array =>
  encode({ width, height, channels: 4, depth: 8, data: rgba });
