/** `mirrorball merge`: parts of one picture → the picture, or one part. */
import type { FilmArea, FilmJob, FilmTracer } from 'mirrorball/headless';
import { posedSceneAt } from 'mirrorball/scene';
import { parseScene } from 'mirrorball/scene-file';
import { aovSamples, traceAovs } from '../aov-films.ts';
import { checkAovs, type WithAovs } from '../aov-pictures.ts';
import type { MergeOptions } from '../arguments.ts';
import { openBackend } from '../backends/open-backend.ts';
import { CommandError, EXIT, usage } from '../exit-codes.ts';
import { sceneHash, wholeOf } from '../film-identity.ts';
import { type Part, readPart } from '../part-file.ts';
import { checkOutputName, type FilmToWrite, isPart, writeFilm, writePictures } from '../picture-file.ts';
import { startProgress } from '../progress.ts';
import { formatRegion, uncovered } from '../regions.ts';
import { formatRanges, missingFrom } from '../sample-ranges.ts';
import { percent, type Terminal } from '../terminal.ts';
import { errorOf, isEven, onePart, type Tile, tilesOf } from '../tiles.ts';
import { checkWritable } from '../write-atomically.ts';

/** So many of a list are told; more help nobody. */
const TOLD = 8;

export async function merge(files: readonly string[], options: MergeOptions, terminal: Terminal): Promise<void> {
  const { output, allowGaps } = options;
  checkOutputName(output);
  checkAovs(options.aov, output, isPart(output));
  if (allowGaps && isPart(output)) throw usage('--allow-gaps is for pictures: a part file has no gaps.');
  await checkWritable(output);
  const parts: { file: string; part: Part }[] = [];
  for (const file of files) parts.push({ file, part: await readPart(file) });
  const tiles = tilesOf(parts);
  // One region is a picture of its own, as `render` would write it.
  const area = tiles.length === 1 && !allowGaps ? tiles[0]!.region : wholeOf(tiles[0]!.part.identity);
  const gaps = uncovered(
    area,
    tiles.map(({ region }) => region),
  );
  if (gaps.length > 0) tellGaps(gaps, area, options, terminal);
  if (options.aov?.includes('error') && tiles.some(({ part }) => part.film.standardErrors() === null))
    throw usage(`These parts hold one block of samples; their error is not known, so leave it out of --aov.`);
  const written = await write(tiles, area, options, terminal);
  report(tiles, gaps, files.length, written, options, terminal);
}

function tellGaps(
  gaps: readonly FilmArea[],
  { width, height }: FilmArea,
  { allowGaps }: MergeOptions,
  terminal: Terminal,
): void {
  const missing = gaps.reduce((sum, gap) => sum + gap.width * gap.height, 0);
  const told = `${missing} of ${width * height} pixels are in no part: ${listed(gaps.map(formatRegion))}.`;
  if (!allowGaps)
    throw usage(`${told} Render these regions and merge their parts too, or leave them black by --allow-gaps.`);
  terminal.note(told);
}

/** "a; b; c and 5 more". */
function listed(things: readonly string[]): string {
  const rest = things.length - TOLD;
  return `${things.slice(0, TOLD).join('; ')}${rest > 0 ? ` and ${rest} more` : ''}`;
}

async function write(
  tiles: readonly Tile[],
  area: FilmArea,
  options: MergeOptions,
  terminal: Terminal,
): Promise<string[]> {
  const { output } = options;
  if (isPart(output)) return writeFilm(output, tiles.length > 1 ? onePart(tiles) : tiles[0]!.part, options);
  const films = options.aov
    ? await withAovs(tiles, options, terminal)
    : tiles.map(({ part }) => ({ part, aovs: null }));
  return writePictures(output, films, area, options);
}

function report(
  tiles: readonly Tile[],
  gaps: readonly FilmArea[],
  parts: number,
  files: readonly string[],
  { output }: MergeOptions,
  terminal: Terminal,
): void {
  const error = errorOf(tiles);
  const counts = tiles.map(({ part }) => part.film.samples);
  const [least, most] = [Math.min(...counts), Math.max(...counts)];
  const { ranges } = tiles[0]!.part.film;
  const even = isEven(tiles);
  terminal.event('done', {
    output,
    parts,
    // Where there is more than one number, the least.
    samples: least,
    ...(even ? { ranges } : { regions: tiles.map(({ region, part }) => ({ region, ranges: part.film.ranges })) }),
    error,
    files,
    ...(gaps.length > 0 && { gaps }),
  });
  for (const { region, part } of even ? tiles.slice(0, 1) : tiles) {
    const missing = missingFrom({ first: 0, last: part.film.ranges.at(-1)?.last ?? 0 }, part.film.ranges);
    const where = even ? '' : ` of the region ${formatRegion(region)}`;
    if (missing.length > 0) terminal.note(`Samples ${formatRanges(missing)}${where} are in no part.`);
  }
  const regions = tiles.length > 1 ? `${tiles.length} regions, ` : '';
  const samples = even ? `${least} samples a pixel (${formatRanges(ranges)})` : `${least} to ${most} samples a pixel`;
  terminal.result(`${output}: ${regions}${samples}, error ${percent(error)}`);
}

/** A part holds all that its picture was traced from. */
function jobOf({ part: { identity, texts }, region, file }: Tile): FilmJob {
  const parsed = parseScene(texts.Scene ?? '');
  if (!parsed.ok || sceneHash(parsed.scene) !== identity.scene)
    throw usage(`${file} has no scene in it to trace AOVs of. Render them: mirrorball render … --resume --aov …`);
  const { width, height, seed, time, integrator, settings } = identity;
  const { maxDepth, maxReflections, lightSamples } = { ...parsed.scene.render, ...settings };
  return {
    scene: posedSceneAt(parsed.scene, time),
    settings: {
      integrator: integrator as FilmJob['settings']['integrator'],
      maxDepth,
      maxReflections,
      lightSamples,
      seed,
    },
    width,
    height,
    area: region,
  };
}

async function withAovs(tiles: readonly Tile[], options: MergeOptions, terminal: Terminal): Promise<FilmToWrite[]> {
  // Before a backend is opened, which may take its time.
  const jobs = tiles.map(jobOf);
  const { name, tracer } = await openBackend(options.backend);
  terminal.event('backend', { backend: name, description: tracer.description });
  try {
    const films: FilmToWrite[] = [];
    for (const [i, { part }] of tiles.entries())
      films.push({ part, aovs: await aovsOf(part, jobs[i]!, tracer, options, terminal) });
    return films;
  } catch (error) {
    throw new CommandError(EXIT.failed, `The AOVs of ${options.output} failed: ${(error as Error).message}`);
  } finally {
    await tracer.dispose();
  }
}

async function aovsOf(
  { film }: Part,
  job: FilmJob,
  tracer: FilmTracer,
  { output, aov }: MergeOptions,
  terminal: Terminal,
): Promise<WithAovs> {
  const progress = startProgress(terminal, { picture: `${output}, AOVs`, held: 0, wanted: aovSamples(aov!, film) });
  try {
    const films = await traceAovs(aov!, tracer, job, film, new AbortController().signal, progress);
    return { names: aov!, films: films!, job };
  } finally {
    progress.stop();
  }
}
