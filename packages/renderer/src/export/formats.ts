/** Which format a file has, by its name's ending. */
import { readExr, writeExr } from './exr.ts';
import type { FloatPicture } from './float-picture.ts';
import { readHdr, writeHdr } from './hdr.ts';
import { ImageError } from './image-error.ts';
import { readNpy, writeNpy } from './npy.ts';
import { readPfm, writePfm } from './pfm.ts';
import { readPng, writePng } from './png.ts';

export interface WriteOptions {
  /** EXR: 16-bit floats in all channels, or in those that this says. */
  readonly half?: boolean | ((channelName: string) => boolean);
  /** PNG: bits of a channel. */
  readonly bits?: 8 | 16;
}

export interface PictureFormat {
  readonly name: string;
  /** With the point, in small letters. */
  readonly extension: string;
  /** Any channels, with their names kept or lost; or only grey and RGB, in PNG with alpha. */
  readonly channels: 'named' | 'counted' | 'colour';
  /** Keeps `FloatPicture.texts`. */
  readonly texts: boolean;
  /** Values are clipped to 0 … 1, and people expect the sRGB curve in them. */
  readonly forScreens: boolean;
  write(picture: FloatPicture, options?: WriteOptions): Uint8Array<ArrayBuffer>;
  /** Throws an ImageError for everything that is not a whole file of this format. */
  read(bytes: Uint8Array): FloatPicture;
}

const common = { texts: false, forScreens: false };
export const PICTURE_FORMATS: readonly PictureFormat[] = [
  { ...common, name: 'EXR', extension: '.exr', channels: 'named', texts: true, write: writeExr, read: readExr },
  { name: 'PNG', extension: '.png', channels: 'colour', texts: true, forScreens: true, write: writePng, read: readPng },
  { ...common, name: 'PFM', extension: '.pfm', channels: 'colour', write: writePfm, read: readPfm },
  { ...common, name: 'NPY', extension: '.npy', channels: 'counted', write: writeNpy, read: readNpy },
  { ...common, name: 'HDR', extension: '.hdr', channels: 'colour', write: writeHdr, read: readHdr },
];

export function formatOf(fileName: string): PictureFormat {
  const ending = fileName.toLowerCase();
  const format = PICTURE_FORMATS.find(({ extension }) => ending.endsWith(extension));
  if (format) return format;
  const found = /\.\w{1,12}$/.exec(ending)?.[0] ?? 'no known ending';
  throw new ImageError('name of the picture file', found, PICTURE_FORMATS.map(({ extension }) => extension).join(', '));
}
