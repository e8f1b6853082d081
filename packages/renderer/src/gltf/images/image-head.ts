/** What an image file says of itself in its first bytes: enough to know what decoding it would take. */

export interface ImageHead {
  /** Such as "image/png". */
  readonly type: ImageType;
  readonly width: number;
  readonly height: number;
  /** Whether pixels may be transparent. */
  readonly alpha: boolean;
  /** Bits of a channel. */
  readonly depth: number;
}
export type ImageType = 'image/png' | 'image/jpeg' | 'image/webp' | 'image/avif' | 'image/ktx2';

/** The head, or null for what is no image of a kind that glTF allows, or is cut off within it. */
export function readImageHead(bytes: Uint8Array): ImageHead | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  try {
    if (starts(bytes, 0, [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10])) return pngHead(bytes, view);
    if (starts(bytes, 0, [0xff, 0xd8, 0xff])) return jpegHead(view);
    if (starts(bytes, 0, ascii('RIFF')) && starts(bytes, 8, ascii('WEBP'))) return webpHead(bytes, view);
    if (starts(bytes, 0, [0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 13, 10, 26, 10])) return ktxHead(view);
    if (starts(bytes, 4, ascii('ftypavi'))) return avifHead(bytes, view);
    return null;
  } catch (error) {
    if (error instanceof RangeError) return null; // a DataView's way to say that the file ends
    throw error;
  }
}

export const NO_IMAGE = 'bytes that are no image';

const ascii = (text: string): number[] => [...text].map((letter) => letter.charCodeAt(0));
const starts = (bytes: Uint8Array, at: number, wanted: readonly number[]): boolean =>
  wanted.every((byte, i) => bytes[at + i] === byte);

/** How files of images begin that glTF does not allow. */
const OTHER_KINDS: readonly (readonly [kind: string, start: string])[] = [
  ['BMP', 'BM'],
  ['GIF', 'GIF8'],
  ['DDS', 'DDS '],
  ['PSD', '8BPS'],
  ['TIFF', 'II*\0'],
  ['TIFF', 'MM\0*'],
  ['HDR', '#?RADIANCE'],
  ['HDR', '#?RGBE'],
  ['EXR', 'v/1\x01'],
];
/** Letters by which one knows a kind that glTF does allow, though its head can not be read, and where they stand. */
const ALLOWED_KINDS: readonly (readonly [kind: string, at: number, letters: string])[] = [
  ['JPEG', 0, '\xff\xd8\xff'],
  ['PNG', 1, 'PNG'],
  ['WebP', 0, 'RIFF'],
  ['KTX2', 1, 'KTX'],
];
/** A TGA ends with it. */
const TGA_END = 'TRUEVISION-XFILE';

/** What bytes without a head are, as far as one can tell: such as "a BMP image". */
export function strangeImage(bytes: Uint8Array): string {
  const other = OTHER_KINDS.find(([, start]) => starts(bytes, 0, ascii(start)));
  if (other) return `a ${other[0]} image`;
  if (starts(bytes, bytes.length - 18, ascii(TGA_END))) return 'a TGA image';
  const broken = ALLOWED_KINDS.find(([, at, letters]) => starts(bytes, at, ascii(letters)));
  return broken ? `a ${broken[0]} image that is damaged or cut off in its head` : NO_IMAGE;
}

/** Colour types 4 and 6 have alpha, and so has what comes with a tRNS chunk, which stands before the pixels. */
function pngHead(bytes: Uint8Array, view: DataView): ImageHead {
  const [width, height, depth, colour] = [view.getUint32(16), view.getUint32(20), view.getUint8(24), view.getUint8(25)];
  let alpha = colour === 4 || colour === 6;
  for (
    let at = 33;
    !alpha && at + 8 <= bytes.length && !starts(bytes, at + 4, ascii('IDAT'));
    at += 12 + view.getUint32(at)
  )
    alpha = starts(bytes, at + 4, ascii('tRNS'));
  return { type: 'image/png', width, height, alpha, depth };
}

/** Goes from marker to marker to the start of a frame (ITU T.81, B.2). */
function jpegHead(view: DataView): ImageHead | null {
  for (let at = 2; ; ) {
    if (view.getUint8(at) !== 0xff) return null;
    const marker = view.getUint8(at + 1);
    const isFrame = marker >= 0xc0 && marker <= 0xcf && marker !== 0xc4 && marker !== 0xc8 && marker !== 0xcc;
    if (isFrame) return { type: 'image/jpeg', width: view.getUint16(at + 7), height: view.getUint16(at + 5), alpha: false, depth: view.getUint8(at + 4) }; // biome-ignore format: fields in a row
    if (marker === 0xd9 || marker === 0xda) return null;
    at += marker === 0xff ? 1 : 2 + view.getUint16(at + 2);
  }
}

/** RFC 9649: a lossy frame, a lossless one, or an extended head. */
function webpHead(bytes: Uint8Array, view: DataView): ImageHead | null {
  const uint24 = (at: number): number => view.getUint16(at, true) + view.getUint8(at + 2) * 65_536;
  const head = (width: number, height: number, alpha: boolean): ImageHead => ({
    type: 'image/webp',
    width,
    height,
    alpha,
    depth: 8,
  });
  if (starts(bytes, 12, ascii('VP8X'))) return head(uint24(24) + 1, uint24(27) + 1, (view.getUint8(20) & 16) !== 0);
  if (starts(bytes, 12, ascii('VP8L'))) {
    const bits = view.getUint32(21, true);
    return head((bits & 0x3fff) + 1, ((bits >>> 14) & 0x3fff) + 1, ((bits >>> 28) & 1) === 1);
  }
  if (starts(bytes, 12, ascii('VP8 ')))
    return head(view.getUint16(26, true) & 0x3fff, view.getUint16(28, true) & 0x3fff, false);
  return null;
}

/** Khronos' KTX 2.0, 3: the vkFormat comes first, then the size of an element. */
const ktxHead = (view: DataView): ImageHead => ({ type: 'image/ktx2', width: view.getUint32(20, true), height: Math.max(view.getUint32(24, true), 1), alpha: true, depth: 8 }); // biome-ignore format: fields in a row

/** The largest "ispe" property (ISO/IEC 23008-12, 6.5.3) among the first bytes: those of a grid's tiles are smaller. */
function avifHead(bytes: Uint8Array, view: DataView): ImageHead | null {
  const [tag, stop] = [ascii('ispe'), Math.min(bytes.length - 16, 65_536)];
  let found: ImageHead | null = null;
  for (let at = 4; at < stop; at++) {
    if (!starts(bytes, at, tag)) continue;
    const [width, height] = [view.getUint32(at + 8), view.getUint32(at + 12)];
    if (found === null || width * height > found.width * found.height)
      found = { type: 'image/avif', width, height, alpha: true, depth: 8 };
  }
  return found;
}
