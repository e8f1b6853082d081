/** Rectangles of a picture's pixels, and pictures put together of such. Pure. */
import type { FilmArea } from 'mirrorball/headless';
import { createPicture, type FloatPicture } from 'mirrorball/picture-files';

/** As people give it to `--region`. */
export const formatRegion = ({ x, y, width, height }: FilmArea): string => [x, y, width, height].join(',');

/** The pixels that both have; null: none. */
function common(a: FilmArea, b: FilmArea): FilmArea | null {
  const [x, y] = [Math.max(a.x, b.x), Math.max(a.y, b.y)];
  const width = Math.min(a.x + a.width, b.x + b.width) - x;
  const height = Math.min(a.y + a.height, b.y + b.height) - y;
  return width > 0 && height > 0 ? { x, y, width, height } : null;
}

export const overlaps = (a: FilmArea, b: FilmArea): boolean => common(a, b) !== null;

/** What is left of `a` without `b`: above and below it in the whole width, then beside it. */
function without(a: FilmArea, b: FilmArea): FilmArea[] {
  const hole = common(a, b);
  if (!hole) return [a];
  const [right, bottom] = [hole.x + hole.width, hole.y + hole.height];
  return [
    { ...a, height: hole.y - a.y },
    { ...hole, x: a.x, width: hole.x - a.x },
    { ...hole, x: right, width: a.x + a.width - right },
    { ...a, y: bottom, height: a.y + a.height - bottom },
  ].filter(({ width, height }) => width > 0 && height > 0);
}

/** The pixels of `whole` that are in none of the regions, as regions. */
export const uncovered = (whole: FilmArea, regions: readonly FilmArea[]): FilmArea[] =>
  regions.reduce<FilmArea[]>((left, region) => left.flatMap((rest) => without(rest, region)), [whole]);

/** Copies the rows of a region into their place in `whole`; `count` values a pixel. */
export function place<Values extends Float32Array | Float64Array>(
  to: Values,
  whole: FilmArea,
  from: Values,
  region: FilmArea,
  count: number,
): void {
  const [width, columns] = [whole.width * count, region.width * count];
  for (let row = 0; row < region.height; row++) {
    const at = (region.y - whole.y + row) * width + (region.x - whole.x) * count;
    to.set(from.subarray(row * columns, (row + 1) * columns), at);
  }
}

/** One picture of `whole`, with the channels of the first one's; 0 where none has a pixel. */
export function assembled(
  whole: FilmArea,
  pictures: readonly { readonly region: FilmArea; readonly picture: FloatPicture }[],
): FloatPicture {
  const [first] = pictures as [(typeof pictures)[0]];
  if (pictures.length === 1 && formatRegion(first.region) === formatRegion(whole)) return first.picture;
  const names = first.picture.channels.map(({ name }) => name);
  const picture = createPicture(whole.width, whole.height, names);
  for (const { region, picture: part } of pictures)
    picture.channels.forEach(({ data }, c) => {
      place(data, whole, part.channels[c]!.data, region, 1);
    });
  return picture;
}
