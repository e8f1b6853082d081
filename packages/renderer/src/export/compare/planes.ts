/** Two pictures laid out for comparing: red, green, blue and luminance as planes of doubles. */
import type { MeasuredPicture } from '../compare.ts';
import type { FloatPicture } from '../float-picture.ts';
import { ImageError } from '../image-error.ts';

/** Four planes: R, G, B, luminance. */
type Colours = readonly Float64Array[];

export interface Planes {
  readonly width: number;
  readonly height: number;
  readonly a: Colours;
  readonly reference: Colours;
  /** Standard errors; null where they are not known. */
  readonly errorOfA: Colours | null;
  readonly errorOfReference: Colours | null;
  readonly nonFinite: number;
  readonly negative: number;
  counts(pixel: number): boolean;
}

/** Rec. 709. An error of luminance is made with them too, as if a pixel's channels erred together, which is the worst case. */
const WEIGHTS = [0.2126, 0.7152, 0.0722] as const;

export function createPlanes(a: MeasuredPicture, reference: MeasuredPicture, mask?: ArrayLike<number>): Planes {
  const { width, height } = reference.mean;
  const pictures = [a.mean, a.standardError, reference.standardError].filter((picture) => picture !== undefined);
  for (const picture of pictures)
    if (picture.width !== width || picture.height !== height)
      throw new ImageError('picture to compare', `${picture.width} × ${picture.height} pixels`, `${width} × ${height}`);
  if (mask && mask.length !== width * height) throw new RangeError(`a mask of ${mask.length} pixels`);
  const red = coloursOf(a.mean);
  const { nonFinite, negative } = blacken(red);
  return {
    width,
    height,
    a: withLuminance(red),
    reference: withLuminance(coloursOf(reference.mean)),
    errorOfA: a.standardError ? withLuminance(coloursOf(a.standardError)) : null,
    errorOfReference: reference.standardError ? withLuminance(coloursOf(reference.standardError)) : null,
    nonFinite,
    negative,
    counts: (pixel) => mask?.[pixel] !== 0,
  };
}

/** R, G and B; a sole channel counts as all three. */
function coloursOf({ channels }: FloatPicture): Float64Array[] {
  const found = ['R', 'G', 'B'].map((wanted) => channels.find(({ name }) => name === wanted));
  const colours = found.every((channel) => channel !== undefined)
    ? found
    : channels.length === 1
      ? [channels[0]!, channels[0]!, channels[0]!]
      : null;
  if (!colours)
    throw new ImageError('picture to compare', `the channels ${channels.map(({ name }) => name).join(' ')}`, 'R G B');
  return colours.map(({ data }) => Float64Array.from(data));
}

/** Non-finite pixels become black, so that one does not hide all the others. */
function blacken(colours: readonly Float64Array[]): { nonFinite: number; negative: number } {
  let [nonFinite, negative] = [0, 0];
  for (let i = 0; i < colours[0]!.length; i++) {
    if (!colours.every((plane) => Number.isFinite(plane[i]))) {
      nonFinite++;
      for (const plane of colours) plane[i] = 0;
    } else if (colours.some((plane) => plane[i]! < 0)) negative++;
  }
  return { nonFinite, negative };
}

const withLuminance = (colours: readonly Float64Array[]): Colours => {
  const luminance = colours[0]!.map((_, i) => WEIGHTS.reduce((sum, weight, c) => sum + weight * colours[c]![i]!, 0));
  return [...colours, luminance];
};
