/** Parts of one picture, sorted out: those of the same pixels become one film, and no pixel is in two of these. */
import type { FilmArea } from 'mirrorball/headless';
import { AccumulatedFilm } from './accumulated-film.ts';
import { usage } from './exit-codes.ts';
import { differences, regionOf, wholeOf } from './film-identity.ts';
import type { Part } from './part-file.ts';
import { formatRegion, overlaps, place } from './regions.ts';
import { formatRanges, overlap } from './sample-ranges.ts';

/** All that there is of some pixels. */
export interface Tile {
  /** The file that it comes from, or the first of them. */
  readonly file: string;
  readonly region: FilmArea;
  readonly part: Part;
}

/** Adds up the parts, whose films are changed by it. Refuses what does not belong together. */
export function tilesOf(parts: readonly { readonly file: string; readonly part: Part }[]): Tile[] {
  // In the order of their samples, whatever the order of the names: sums of doubles depend on it in the last digit.
  const sorted = [...parts].sort((a, b) => (a.part.film.ranges[0]?.first ?? 0) - (b.part.film.ranges[0]?.first ?? 0));
  const tiles = new Map<string, Tile>();
  for (const { file, part } of sorted) {
    const first = tiles.values().next().value ?? { file, part };
    const differ = differences({ ...part.identity, region: first.part.identity.region }, first.part.identity);
    if (differ.length > 0) throw usage(`${file} and ${first.file} are of different pictures: ${differ.join(', ')}.`);
    const region = regionOf(part.identity);
    const there = tiles.get(formatRegion(region));
    if (!there) {
      checkApart(file, region, [...tiles.values()]);
      tiles.set(formatRegion(region), { file, region, part });
      continue;
    }
    const twice = overlap(there.part.film.ranges, part.film.ranges);
    if (twice) throw usage(`${file} holds samples ${formatRanges([twice])}, which another part holds too.`);
    there.part.film.merge(part.film);
  }
  return [...tiles.values()].sort((a, b) => a.region.y - b.region.y || a.region.x - b.region.x);
}

function checkApart(file: string, region: FilmArea, tiles: readonly Tile[]): void {
  const other = tiles.find((tile) => overlaps(tile.region, region));
  if (!other) return;
  const [here, there] = [region, other.region].map(formatRegion);
  throw usage(
    `${file} and ${other.file} hold some of the same pixels: their regions ${here} and ${there} ` +
      'must be the same, or have no pixel in common.',
  );
}

const samplesOf = ({ part: { film } }: Tile): string => formatRanges(film.ranges);

/** Whether all pixels have the same samples. */
export const isEven = (tiles: readonly Tile[]): boolean =>
  tiles.every((tile) => samplesOf(tile) === samplesOf(tiles[0]!));

/** The tiles as one part, that of all the picture, which they must cover. */
export function onePart(tiles: readonly Tile[]): Part {
  const [first] = tiles as [Tile];
  const { identity } = first.part;
  const whole = wholeOf(identity);
  const film = new AccumulatedFilm(whole.width * whole.height);
  const { sums, squares } = film.closed;
  for (const { part, region } of tiles) {
    part.film.close();
    place(sums, whole, part.film.closed.sums, region, 3);
    place(squares, whole, part.film.closed.squares, region, 3);
  }
  const told = (tile: Tile): string => `samples ${samplesOf(tile)} in ${tile.part.film.closed.blocks} blocks`;
  const other = tiles.find((tile) => told(tile) !== told(first));
  if (other)
    throw usage(
      'A part file holds the same samples of all its pixels, in the same blocks. ' +
        `Here the region ${formatRegion(first.region)} has ${told(first)}, the region ${formatRegion(other.region)} ` +
        `${told(other)}. Write a picture, or render what is missing.`,
    );
  const { blocks, ranges } = first.part.film.closed;
  return {
    ...first.part,
    identity: { ...identity, region: [0, 0, whole.width, whole.height] },
    film: new AccumulatedFilm(film.pixels, { sums, squares, blocks, ranges }),
  };
}

/** The estimated error of all these pixels; null where one of the tiles does not know its own. */
export function errorOf(tiles: readonly Pick<Tile, 'part'>[]): number | null {
  let [squares, pixels] = [0, 0];
  for (const { part } of tiles) {
    const error = part.film.error();
    if (error === null) return null;
    squares += error ** 2 * part.film.pixels;
    pixels += part.film.pixels;
  }
  return Math.sqrt(squares / pixels);
}
