/** The text `Render` of EXR and PNG files: what the picture is of, and how far it has come. One line of JSON, written and read here. */
import type { FilmArea } from 'mirrorball/headless';
import { type FilmIdentity, isIdentity, regionOf } from './film-identity.ts';
import type { Part } from './part-file.ts';
import { uncovered } from './regions.ts';
import { formatRanges, readRanges, type SampleRange } from './sample-ranges.ts';
import { errorOf } from './tiles.ts';

/** Of pictures for people, which hold more than the film. */
export interface Look {
  /** Stops. */
  readonly exposure: number;
}

export interface RenderFacts {
  readonly identity: FilmIdentity;
  /** What each of its pixels has at least: the samples of each region, or one list where all have the same. */
  readonly ranges: readonly (readonly SampleRange[])[];
  /** False where some pixels were left black. */
  readonly whole: boolean;
  /** The estimated error; null: not known. */
  readonly error: number | null;
  readonly look: Look | null;
}

/** Where not all pixels have the same samples, they are told region by region. `look` is that of formats for screens. */
export function renderText(parts: readonly Part[], area: FilmArea, look: Look | null): string {
  const regions = parts.map(({ identity, film }) => ({ region: identity.region, samples: formatRanges(film.ranges) }));
  const [{ samples }] = regions as [(typeof regions)[0]];
  const gaps = uncovered(
    area,
    parts.map(({ identity }) => regionOf(identity)),
  );
  const even = gaps.length === 0 && regions.every((each) => each.samples === samples);
  const error = errorOf(parts.map((part) => ({ part })));
  return JSON.stringify({
    ...parts[0]!.identity,
    region: [area.x, area.y, area.width, area.height],
    ...(even ? { samples } : { regions }),
    ...(error === null ? {} : { error }),
    ...look,
  });
}

/** Null when it is not what `renderText` writes. */
export function readRenderText(text: string | undefined): RenderFacts | null {
  try {
    const { samples, regions, error, exposure, ...identity } = JSON.parse(text ?? '');
    if (!isIdentity(identity)) return null;
    const told: readonly { region: FilmIdentity['region']; samples: string }[] =
      samples === undefined ? regions : [{ region: identity.region, samples }];
    const ranges = told.map((each) => readRanges(each.samples));
    const areas = told.map(({ region }) => regionOf({ region }));
    if (ranges.length === 0 || ranges.includes(null)) return null;
    return {
      identity,
      ranges: ranges as SampleRange[][],
      whole: uncovered(regionOf(identity), areas).length === 0,
      error: Number.isFinite(error) ? error : null,
      look: Number.isFinite(exposure) ? { exposure } : null,
    };
  } catch {
    return null;
  }
}
