import { readFileSync } from 'node:fs';
import { convertIndexedToRgb, decode, encode } from 'fast-png';
import { describe, expect, test } from 'vitest';
import { seededRandom } from '../../../../../tests/fixtures/random.ts';
import { ImageError } from '../../export/image-error.ts';
import { type Chunk, joinChunks, readChunks } from '../../export/png/chunks.ts';
import { defaultDecoder, pngDecoder } from './decoder.ts';
import { readImageHead } from './image-head.ts';
import { decodePng } from './png-pixels.ts';
import { unturned } from './unturned.ts';

const bytesOf = (base64: string): Uint8Array => Uint8Array.from(Buffer.from(base64, 'base64'));

describe('PNG', () => {
  test.each([
    [1, 8],
    [2, 8],
    [3, 8],
    [4, 8],
    [1, 16],
    [2, 16],
    [3, 16],
    [4, 16],
  ] as const)('%d channels of %d bits are those that were written, seed 91', (channels, depth) => {
    const random = seededRandom(91);
    const [width, height] = [13, 7];
    const length = width * height * channels;
    const data =
      depth === 8
        ? Uint8Array.from({ length }, () => random() * 256)
        : Uint16Array.from({ length }, () => random() * 65_536);
    const file = encode({ width, height, data, channels, depth });
    const { rgba } = decodePng(file);
    expect(readImageHead(file)).toEqual({ type: 'image/png', width, height, alpha: channels % 2 === 0, depth });
    for (let pixel = 0; pixel < width * height; pixel++) {
      const value = (c: number): number => Math.round(data[pixel * channels + c]! / (depth === 8 ? 1 : 257));
      const color = channels < 3 ? [value(0), value(0), value(0)] : [value(0), value(1), value(2)];
      expect([...rgba.subarray(4 * pixel, 4 * pixel + 4)]).toEqual([
        ...color,
        channels % 2 === 0 ? value(channels - 1) : 255,
      ]);
    }
  });

  test('interlaced, as another decoder has it', () => {
    const file = Uint8Array.from(
      readFileSync(new URL('../../../../../tests/fixtures/images/interlaced-16.png', import.meta.url)),
    );
    const other = decode(file);
    const { rgba, width, height } = decodePng(file);
    expect([width, height]).toEqual([other.width, other.height]);
    for (let pixel = 0; pixel < width * height; pixel++)
      for (let c = 0; c < 3; c++) {
        const value = other.data[pixel * other.channels + (other.channels < 3 ? 0 : c)]!;
        expect(rgba[4 * pixel + c]).toBe(Math.round(value / 257));
      }
  });

  test('palettes of few bits with transparent entries', () => {
    // Four pixels of two bits, 3 2 1 0, with a palette of four colours, of which two have alpha.
    const colors = [10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120];
    const file = pngOf([4, 1, 2, 3], [['PLTE', colors], ['tRNS', [0, 128]]], [0, 0b11100100]); // biome-ignore format: chunks
    expect([...decodePng(file).rgba]).toEqual([100, 110, 120, 255, 70, 80, 90, 255, 40, 50, 60, 128, 10, 20, 30, 0]);
    expect(readImageHead(file)!.alpha).toBe(true);
    const other = decode(file);
    expect(convertIndexedToRgb(other).length).toBeGreaterThan(0);
  });

  test('one grey that stands for nothing', () => {
    const file = pngOf([3, 1, 4, 0], [['tRNS', [0, 7]]], [0, 0x70, 0xf0]);
    expect([...decodePng(file).rgba]).toEqual([119, 119, 119, 0, 0, 0, 0, 255, 255, 255, 255, 255]);
  });

  test('damaged files are refused, and none unfolds to more than its head says', async () => {
    const file = encode({ width: 4, height: 4, data: new Uint8Array(64).fill(9), channels: 4 });
    for (let length = 0; length < file.length; length += 3)
      expect(() => decodePng(file.subarray(0, length))).toThrow(ImageError);
    const large = encode({ width: 1000, height: 1000, data: new Uint8Array(1e6), channels: 1 });
    const lie = readChunks(large).map((chunk) =>
      chunk.type === 'IHDR' ? { ...chunk, data: Uint8Array.of(0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0) } : chunk,
    );
    await expect(pngDecoder.decode(joinChunks(lie), 'image/png')).rejects.toThrow('more bytes');
  });
});

/** Width, height, bits and colour type; chunks before the pixels; lines with their filters, not compressed. */
function pngOf(
  [width, height, bits, colour]: readonly number[],
  chunks: readonly (readonly [string, number[]])[],
  lines: readonly number[],
): Uint8Array {
  // biome-ignore format: one line
  const head: Chunk = { type: 'IHDR', data: Uint8Array.of(0, 0, 0, width!, 0, 0, 0, height!, bits!, colour!, 0, 0, 0) };
  let [a, b] = [1, 0];
  for (const byte of lines) b = (b + (a = (a + byte) % 65521)) % 65521;
  const stored = [0x78, 1, 1, lines.length, 0, lines.length ^ 255, 255, ...lines, b >> 8, b & 255, a >> 8, a & 255];
  return joinChunks([
    head,
    ...chunks.map(([type, data]): Chunk => ({ type, data: Uint8Array.from(data) })),
    { type: 'IDAT', data: Uint8Array.from(stored) },
    { type: 'IEND', data: new Uint8Array() },
  ]);
}

describe('heads of other images', () => {
  test('JPEG: the frame, wherever it stands', () => {
    const head = [0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xc2, 0, 11, 8, 0, 7, 1, 0, 1, 1, 0x11, 0];
    expect(readImageHead(Uint8Array.from(head))).toEqual({
      type: 'image/jpeg',
      width: 256,
      height: 7,
      alpha: false,
      depth: 8,
    });
    expect(readImageHead(Uint8Array.from(head.slice(0, 12)))).toBeNull();
    expect(readImageHead(Uint8Array.of(0xff, 0xd8, 0xff, 0xda, 0, 4))).toBeNull();
  });

  test('JPEG: what would turn the picture is made unknown, and nothing else', () => {
    const exif = [0xff, 0xe1, 0, 10, 0x45, 0x78, 0x69, 0x66, 0, 0, 7, 7];
    const other = [0xff, 0xe1, 0, 4, 1, 2];
    const rest = [0xff, 0xda, 0, 2, ...exif];
    const file = (...segments: number[][]) => Uint8Array.from([0xff, 0xd8, ...segments.flat(), ...rest]);
    const blank = exif.map((byte, i) => (i >= 4 && i < 8 ? 0 : byte));
    expect(unturned(file(other, exif))).toEqual(file(other, blank));
    const plain = file(other);
    expect(unturned(plain)).toBe(plain);
    const cut = file(other, exif).subarray(0, 9);
    expect(unturned(cut)).toBe(cut);
  });

  test('WebP: lossless, lossy, extended', () => {
    expect(readImageHead(bytesOf('UklGRhoAAABXRUJQVlA4TA0AAAAvAAAAEAcQERGIiP4HAA=='))).toMatchObject({
      type: 'image/webp',
      width: 1,
      height: 1,
    });
    expect(readImageHead(bytesOf('UklGRiIAAABXRUJQVlA4IBYAAAAwAQCdASoBAAEADsD+JaQAA3AAAAAA'))).toMatchObject({
      type: 'image/webp',
      width: 1,
      height: 1,
      alpha: false,
    });
    const extended = new Uint8Array(30);
    extended.set(new TextEncoder().encode('RIFF    WEBPVP8X'));
    extended.set([16, 0, 0, 0, 0xff, 1, 0, 0xff, 0, 0], 20);
    expect(readImageHead(extended)).toMatchObject({ width: 512, height: 256, alpha: true });
  });

  test('AVIF by its largest extent, KTX2 by its head', () => {
    const avif = new Uint8Array(100);
    avif.set([0, 0, 0, 20]);
    avif.set(new TextEncoder().encode('ftypavif'), 4);
    for (const [at, side] of [
      [30, 64],
      [60, 300],
    ] as const) {
      // biome-ignore format: short
      avif.set(new TextEncoder().encode('ispe'), at);
      new DataView(avif.buffer).setUint32(at + 8, side);
      new DataView(avif.buffer).setUint32(at + 12, 2);
    }
    expect(readImageHead(avif)).toMatchObject({ type: 'image/avif', width: 300, height: 2 });
    const ktx = new Uint8Array(48);
    ktx.set([0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 13, 10, 26, 10]);
    new DataView(ktx.buffer).setUint32(20, 8, true);
    new DataView(ktx.buffer).setUint32(24, 4, true);
    expect(readImageHead(ktx)).toMatchObject({ type: 'image/ktx2', width: 8, height: 4 });
  });

  test('what is no image, and noise, seed 92', () => {
    const random = seededRandom(92);
    expect(readImageHead(new Uint8Array())).toBeNull();
    const starts = [
      'ffd8ff',
      '89504e470d0a1a0a',
      '52494646000000005745425056503858',
      '0000001466747970617669660000',
      'ab4b5458203230bb0d0a1a0a',
    ];
    for (let round = 0; round < 2000; round++) {
      const start = Buffer.from(starts[round % starts.length]!, 'hex');
      const bytes = Uint8Array.from({ length: Math.floor(random() * 80) }, (_, i) => start[i] ?? random() * 256);
      readImageHead(bytes);
    }
  });
});

describe('KTX2', () => {
  const file = (name: string): Uint8Array =>
    Uint8Array.from(readFileSync(new URL(`../../../../../tests/fixtures/images/${name}`, import.meta.url)));

  test.each([
    ['uastc-alpha.ktx2', 6],
    ['etc1s-alpha.ktx2', 12],
  ])('%s: four fields of colour and alpha come back', async (name, slack) => {
    expect(readImageHead(file(name))).toMatchObject({ type: 'image/ktx2', width: 16, height: 8 });
    const { width, height, rgba } = await defaultDecoder().decode(file(name), 'image/ktx2');
    expect([width, height, rgba.length]).toEqual([16, 8, 512]);
    for (let y = 0; y < 8; y++)
      for (let x = 0; x < 16; x++) {
        const wanted = [x < 8 ? 200 : 20, y < 4 ? 180 : 40, 60, x < 8 ? 255 : 128];
        for (let c = 0; c < 4; c++)
          expect(Math.abs(rgba[4 * (16 * y + x) + c]! - wanted[c]!)).toBeLessThanOrEqual(slack);
      }
  });

  test('damaged files are refused', async () => {
    const whole = file('uastc-alpha.ktx2');
    for (const bytes of [whole.subarray(0, 100), whole.subarray(0, 12), new Uint8Array(200)])
      await expect(defaultDecoder().decode(bytes, 'image/ktx2')).rejects.toThrow(/KTX2|damaged/);
  });
});
