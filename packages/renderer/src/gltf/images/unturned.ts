/**
 * A photograph says in its Exif data which side of it was up, and browsers turn it, whatever they are asked for. Texture coordinates are made
 * for the pixels as they lie in the file: Blender and other programs do not turn them.
 */

const EXIF = [0x45, 0x78, 0x69, 0x66]; // Exif

/** The same JPEG file, its Exif data made unknown; anything else as it is. */
export function unturned(bytes: Uint8Array): Uint8Array {
  if (bytes[0] !== 0xff || bytes[1] !== 0xd8) return bytes;
  for (let at = 2; bytes[at] === 0xff; ) {
    const marker = bytes[at + 1]!;
    // Where the picture begins no head is left.
    if (marker === 0xda || marker === 0xd9) break;
    if (marker === 0xe1 && EXIF.every((letter, i) => bytes[at + 4 + i] === letter)) {
      const copy = bytes.slice();
      copy.fill(0, at + 4, at + 8);
      return copy;
    }
    at += marker === 0xff ? 1 : 2 + bytes[at + 2]! * 256 + bytes[at + 3]!;
  }
  return bytes;
}
