/** AOVs as layers of a picture, or as pictures of their own; and which formats can hold which. */
import { AOVS, type Aov, type AovName, aovIds, type FilmJob, firstHitAov, isFirstHit } from 'mirrorball/headless';
import { type Channel, type FloatPicture, formatOf, fromInterleaved, namesFor } from 'mirrorball/picture-files';
import type { AccumulatedFilm } from './accumulated-film.ts';
import type { AovFilms } from './aov-films.ts';
import { blocksIn } from './blocks.ts';
import { usage } from './exit-codes.ts';
import type { SampleRange } from './sample-ranges.ts';

/** A film with everything that its AOVs are made of. */
export interface WithAovs {
  readonly names: readonly AovName[];
  readonly films: AovFilms;
  readonly job: FilmJob;
}

/** "out.png" → "out.albedo.png". */
export function aovFile(output: string, name: AovName): string {
  const point = output.lastIndexOf('.');
  return `${output.slice(0, point)}.${name}${output.slice(point)}`;
}

/** Whether the format keeps all layers in one file. */
export const holdsLayers = (output: string): boolean => formatOf(output).channels === 'named';

/** Refuses, before any work, what cannot be written there. */
export function checkAovs(names: readonly AovName[] | undefined, output: string | undefined, isPart: boolean): void {
  if (!names) return;
  if (output === undefined) throw usage('--aov needs -o: AOVs are written to files.');
  if (isPart)
    throw usage(
      'A part file holds no AOVs: they are traced when the picture is made. ' +
        'Give --aov to `merge … -o out.exr`, or to `render … -o out.exr --resume`.',
    );
  const format = formatOf(output);
  const unfit = names.filter((name) => !fits(AOVS[name], format.name));
  if (unfit.length === 0) return;
  const why = format.forScreens ? 'holds colours from 0 to 1 only' : 'holds colours only, nothing negative';
  const others = unfit.length === 1 ? 'this AOV' : 'these AOVs';
  throw usage(`${format.name} ${why}. Write .exr, .npy or .pfm for ${others}: ${unfit.join(', ')}.`);
}

const fits = ({ kind }: Aov, format: string): boolean => kind === 'colour' || !['PNG', 'HDR'].includes(format);

/** The error is that of blocks of samples, and needs two. */
export function checkErrorKnown(names: readonly AovName[] | undefined, wanted: SampleRange): void {
  if (names?.includes('error') && blocksIn(wanted) < 2)
    throw usage(
      '--aov error needs samples of two blocks at least, --spp 64, say: ' +
        'the first 256 samples are blocks of 32, all others blocks of 256.',
    );
}

/** Channels side by side, pixel by pixel. */
function valuesOf(name: AovName, film: AccumulatedFilm, { films, job }: WithAovs): Float32Array {
  const { scene, settings } = job;
  if (isFirstHit(name)) {
    const sums = AOVS[name].source === 'features' ? films.features! : films.data!;
    return firstHitAov(name, sums, scene, settings.integrator);
  }
  switch (name) {
    case 'samples':
      return new Float32Array(film.pixels).fill(film.samples);
    case 'error':
      // Not known means that it may be anything.
      return film.standardErrors() ?? new Float32Array(film.pixels * 3).fill(Number.POSITIVE_INFINITY);
    case 'direct':
      return films.direct!.mean();
    case 'indirect': {
      const direct = films.direct!.mean();
      // Below 0 by rounding alone.
      return film.mean().map((value, i) => Math.max(value - direct[i]!, 0));
    }
  }
}

function withChannels(name: AovName, channels: readonly string[], film: AccumulatedFilm, aovs: WithAovs): FloatPicture {
  const { width, height } = aovs.job.area;
  return fromInterleaved(width, height, channels, valuesOf(name, film, aovs));
}

/** One AOV as a picture of its own, for formats that know grey and RGB only: X, Y, Z are red, green, blue there. */
export const aovPicture = (name: AovName, film: AccumulatedFilm, aovs: WithAovs): FloatPicture =>
  withChannels(name, namesFor(AOVS[name].channels.length), film, aovs);

/** All of them as layers. */
export const aovChannels = (film: AccumulatedFilm, aovs: WithAovs): Channel[] =>
  aovs.names.flatMap(
    (name) =>
      withChannels(
        name,
        AOVS[name].channels.map((channel) => `${AOVS[name].layer}.${channel}`),
        film,
        aovs,
      ).channels,
  );

/** What the numbers in a file mean, for its texts. */
export function aovTexts({ names, job }: WithAovs): Record<string, string> {
  const { primitives, materials } = aovIds(job.scene, job.settings.integrator);
  return {
    ...(names.includes('primitive-id') ? { PrimitiveIds: JSON.stringify(primitives) } : {}),
    ...(names.includes('material-id') ? { MaterialIds: JSON.stringify(materials) } : {}),
  };
}

/** Layers that 16 bits would spoil: places, distances, numbers. */
const PRECISE = new Set<string>(
  Object.values(AOVS)
    .filter(({ kind, layer }) => kind === 'number' || layer === 'P')
    .map(({ layer }) => layer),
);
export const mayBeHalf = (channel: string): boolean => !PRECISE.has(channel.slice(0, channel.lastIndexOf('.')));
