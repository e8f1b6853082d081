/**
 * Images that are made of the images that an MTL file names: maps of numbers that go into channels of one image, opacity that lies in
 * a file of its own, and heights, of which normal maps are made.
 */
import { linearToSrgb } from '../../display/srgb.ts';
import type { ImagePixels } from '../../scene/textures.ts';
import type { ImageChannel } from './mtl-textures.ts';

/** A number of each pixel: base + gain · one channel of a file's image, 0 … 1. */
export interface ImageNumbers {
  readonly file: string;
  /** `opacity`: the alpha of an image that has some, else how bright it is. */
  readonly channel: ImageChannel | 'opacity';
  readonly base: number;
  readonly gain: number;
  /** The numbers are shares of this exponent of a highlight; what is made is the roughness (docs/classic.md). */
  readonly exponent?: number;
  /** The channel that is made is looked up as that of a colour. */
  readonly asColor?: boolean;
}
export type MadeImage =
  | {
      readonly kind: 'channels';
      /** Left out: 1. */
      readonly red?: ImageNumbers;
      readonly green?: ImageNumbers;
      readonly blue?: ImageNumbers;
      readonly alpha?: ImageNumbers;
    }
  | {
      readonly kind: 'normals';
      readonly heights: ImageNumbers;
      readonly strength: number;
      /** Whether the image ends at its sides, rather than going on from the other one. */
      readonly clamp: boolean;
    };

/** How far white lies above black where the strength is 1: this part of the image's width. The format does not say. */
export const HEIGHT_OF_WHITE = 0.01;

const CHANNELS = ['red', 'green', 'blue', 'alpha'] as const;

/** Files of the images that it is made of. */
export const sourcesOf = (made: MadeImage): string[] =>
  made.kind === 'normals' ? [made.heights.file] : [...new Set(CHANNELS.flatMap((name) => made[name]?.file ?? []))];

/** The size of the largest image that it is made of; the others are stretched. */
export function sizeOf(made: MadeImage, images: ReadonlyMap<string, Pick<ImagePixels, 'width' | 'height'>>) {
  const all = sourcesOf(made).map((file) => images.get(file)!);
  return all.reduce((most, image) => (image.width * image.height > most.width * most.height ? image : most));
}

/** `images`: by file, each of `sourcesOf`. */
export function makeImage(made: MadeImage, images: ReadonlyMap<string, ImagePixels>): ImagePixels {
  const { width, height } = sizeOf(made, images);
  if (made.kind === 'normals') return normalMap(images.get(made.heights.file)!, made);
  const rgba = new Uint8Array(4 * width * height).fill(255);
  CHANNELS.forEach((name, c) => {
    const source = made[name];
    if (!source) return;
    const image = images.get(source.file)!;
    const number = numbersOf(source, image);
    const [across, down] = [nearest(width, image.width), nearest(height, image.height)];
    for (let y = 0; y < height; y++)
      for (let x = 0; x < width; x++)
        rgba[4 * (y * width + x) + c] = Math.round(255 * number(down[y]! * image.width + across[x]!));
  });
  return { width, height, rgba };
}

/** Of each of so many pixels, the one of another image that lies at the same place. */
const nearest = (count: number, of: number): Uint32Array =>
  Uint32Array.from({ length: count }, (_, k) => Math.floor(((k + 0.5) * of) / count));

/** Of pixels by their number, 0 … 1. */
function numbersOf({ channel, base, gain, exponent, asColor }: ImageNumbers, image: ImagePixels) {
  const read = channelOf(channel, image);
  const table = (byte: number): number => {
    const x = Math.min(Math.max(base + (gain * byte) / 255, 0), 1);
    if (exponent !== undefined) return (2 / (Math.max(exponent, 0) * x + 2)) ** (1 / 4);
    return asColor ? linearToSrgb(x) : x;
  };
  const values = Float32Array.from({ length: 256 }, (_, byte) => table(byte));
  return (pixel: number): number => values[read(pixel)]!;
}

function channelOf(channel: ImageNumbers['channel'], { rgba }: ImagePixels): (pixel: number) => number {
  if (channel === 'opacity') return channelOf(hasAlpha(rgba) ? 'm' : 'l', { rgba, width: 0, height: 0 });
  if (channel === 'l') return (p) => luminance(rgba, 4 * p);
  const c = { r: 0, g: 1, b: 2, m: 3 }[channel];
  return (p) => rgba[4 * p + c]!;
}

/** Of the numbers as they stand (Rec. 709's weights). A grey keeps its number. */
const luminance = (rgba: Uint8Array, at: number): number =>
  Math.round(0.2126 * rgba[at]! + 0.7152 * rgba[at + 1]! + 0.0722 * rgba[at + 2]!);

function hasAlpha(rgba: Uint8Array): boolean {
  for (let at = 3; at < rgba.length; at += 4) if (rgba[at] !== 255) return true;
  return false;
}

/**
 * Slopes by Scharr's operator (2000), which averages across: heights of 8 bits go by steps. Many files name a normal map where heights
 * belong, which its colours show; it is taken for what it is.
 */
function normalMap(image: ImagePixels, { heights, strength, clamp }: MadeImage & { kind: 'normals' }): ImagePixels {
  const { width, height } = image;
  if (isNormalMap(image)) return strengthened(image, strength);
  const number = numbersOf(heights, image);
  const rise = strength * HEIGHT_OF_WHITE * width;
  const within = (k: number, count: number): number =>
    clamp ? Math.min(Math.max(k, 0), count - 1) : (k + count) % count;
  const columns = Int32Array.from({ length: width + 2 }, (_, k) => within(k - 1, width));
  const rgba = new Uint8Array(4 * width * height);
  for (let y = 0; y < height; y++) {
    const rows = [-1, 0, 1].map((k) => within(y + k, height) * width) as [number, number, number];
    for (let x = 0; x < width; x++) {
      const h = (row: number, column: number): number => number(rows[row]! + columns[x + column]!);
      const across = 3 * (h(0, 2) - h(0, 0)) + 10 * (h(1, 2) - h(1, 0)) + 3 * (h(2, 2) - h(2, 0));
      const down = 3 * (h(2, 0) - h(0, 0)) + 10 * (h(2, 1) - h(0, 1)) + 3 * (h(2, 2) - h(0, 2));
      // Rows go down, the second axis of a normal map up.
      writeNormal(rgba, 4 * (y * width + x), (-across / 32) * rise, (down / 32) * rise, 1);
    }
  }
  return { width, height, rgba };
}

function writeNormal(rgba: Uint8Array, at: number, x: number, y: number, z: number): void {
  const length = Math.hypot(x, y, z);
  rgba[at] = Math.round(127.5 * (1 + x / length));
  rgba[at + 1] = Math.round(127.5 * (1 + y / length));
  rgba[at + 2] = Math.round(127.5 * (1 + z / length));
  rgba[at + 3] = 255;
}

/** Most of a surface looks straight up: on average red and green are in the middle, and blue is far above. Heights are grey. */
function isNormalMap({ rgba }: ImagePixels): boolean {
  const sums = [0, 0, 0];
  for (let at = 0; at < rgba.length; at += 4) for (let c = 0; c < 3; c++) sums[c]! += rgba[at + c]!;
  const [r, g, b] = sums.map((sum) => sum / (rgba.length / 4)) as [number, number, number];
  return Math.abs(r - 128) < 24 && Math.abs(g - 128) < 24 && b > 184;
}

function strengthened(image: ImagePixels, strength: number): ImagePixels {
  if (strength === 1) return image;
  const rgba = new Uint8Array(image.rgba.length);
  const part = (byte: number): number => byte / 127.5 - 1;
  for (let at = 0; at < rgba.length; at += 4) {
    const [x, y, z] = [part(image.rgba[at]!), part(image.rgba[at + 1]!), part(image.rgba[at + 2]!)];
    writeNormal(rgba, at, strength * x, strength * y, Math.max(z, 1e-3));
  }
  return { ...image, rgba };
}
