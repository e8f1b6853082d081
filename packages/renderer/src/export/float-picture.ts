/** A picture in memory, as every format here reads and writes it. */
import { checkSize, ImageError } from './image-error.ts';

export interface Channel {
  /** "R", "G", "B", "A", "Y" for the picture itself; with a layer before the last point for others: "albedo.R". */
  readonly name: string;
  /** width × height values, row 0 on top. */
  readonly data: Float32Array;
}

/** Named channels of linear floats. */
export interface FloatPicture {
  readonly width: number;
  readonly height: number;
  readonly channels: readonly Channel[];
  /** What is written beside the pixels, as the scene and the settings; EXR and PNG hold it. */
  readonly texts?: Readonly<Record<string, string>>;
}

/** A black picture. */
export function createPicture(width: number, height: number, names: readonly string[]): FloatPicture {
  checkSize('picture', width, height, names.length);
  return { width, height, channels: names.map((name) => ({ name, data: new Float32Array(width * height) })) };
}

/** One array with the channels side by side, pixel by pixel. */
export function interleave(picture: FloatPicture): Float32Array {
  const count = picture.channels.length;
  const values = new Float32Array(picture.width * picture.height * count);
  picture.channels.forEach(({ data }, c) => {
    for (let i = 0, k = c; k < values.length; i++, k += count) values[k] = data[i]!;
  });
  return values;
}

/** The reverse of `interleave`; values beyond those of `names` are left out, so RGB can be taken from a film's RGBA. */
export function fromInterleaved(
  width: number,
  height: number,
  names: readonly string[],
  values: ArrayLike<number>,
  stride = names.length,
): FloatPicture {
  const picture = createPicture(width, height, names);
  if (values.length !== width * height * stride)
    throw new RangeError(`${values.length} values for ${width} × ${height} pixels of ${stride}`);
  picture.channels.forEach(({ data }, c) => {
    for (let i = 0, k = c; i < data.length; i++, k += stride) data[i] = values[k]!;
  });
  return picture;
}

/** "albedo" of "albedo.R"; "" of "R". */
export const layerOf = (channelName: string): string => channelName.slice(0, Math.max(channelName.lastIndexOf('.'), 0));

/** The layers that a picture has, in the order of their first channels; "" is the picture itself. */
export const layersOf = (picture: FloatPicture): string[] => [
  ...new Set(picture.channels.map(({ name }) => layerOf(name))),
];

/** One layer as a picture of its own, sharing the data: "albedo.R" becomes "R". */
export function pickLayer(picture: FloatPicture, layer: string): FloatPicture {
  const channels = picture.channels
    .filter(({ name }) => layerOf(name) === layer)
    .map(({ name, data }) => ({ name: layer === '' ? name : name.slice(layer.length + 1), data }));
  return { ...picture, channels };
}

/** The names of grey or coloured pixels, with or without alpha, by their number. */
export const COLOUR_CHANNELS: Readonly<Record<number, readonly string[]>> = {
  1: ['Y'],
  2: ['Y', 'A'],
  3: ['R', 'G', 'B'],
  4: ['R', 'G', 'B', 'A'],
};

/** Names for `count` channels of a file that has none. */
export const namesFor = (count: number): readonly string[] =>
  COLOUR_CHANNELS[count] ?? Array.from({ length: count }, (_, index) => `c${index}`);

/**
 * The picture with its channels in the order of COLOUR_CHANNELS, for formats whose channels have no names.
 * A sole channel may have any name; nothing is left out in silence.
 */
export function colourOnly(format: string, picture: FloatPicture, counts: readonly number[]): FloatPicture {
  const { width, height, channels } = picture;
  checkPicture(format, picture);
  const wanted = counts.includes(channels.length) ? COLOUR_CHANNELS[channels.length]! : [];
  const ordered = wanted.map((name) => channels.find((channel) => channel.name === name));
  if (wanted.length > 0 && ordered.every((channel) => channel !== undefined))
    return { width, height, channels: ordered };
  if (channels.length === 1 && counts.includes(1)) return { width, height, channels };
  const names = channels.map(({ name }) => name);
  const allowed = counts.map((count) => COLOUR_CHANNELS[count]!.join(' '));
  throw new ImageError(`${format} file to write`, `the channels ${names.slice(0, 8).join(' ')}`, allowed.join(', or '));
}

/** Refuses what no format can hold; a programmer's mistake in the data is thrown as such. */
export function checkPicture(format: string, { width, height, channels }: FloatPicture): void {
  checkSize(`${format} file to write`, width, height, channels.length);
  for (const { name, data } of channels)
    if (data.length !== width * height)
      throw new RangeError(`channel ${name}: ${data.length} values for ${width} × ${height}`);
}

/** Texts by key in an object that inherits nothing, so that no key of a file finds more than the file gave. */
export const noTexts = (): Record<string, string> => Object.create(null) as Record<string, string>;
