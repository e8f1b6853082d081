/** `mirrorball merge`: parts of one picture → the picture, or one part. */
import type { FilmJob } from 'mirrorball/headless';
import { sceneAt } from 'mirrorball/scene';
import { parseScene } from 'mirrorball/scene-file';
import { traceAovs } from '../aov-films.ts';
import { checkAovs, type WithAovs } from '../aov-pictures.ts';
import type { MergeOptions } from '../arguments.ts';
import { openBackend } from '../backends/open-backend.ts';
import { CommandError, EXIT, usage } from '../exit-codes.ts';
import { differences, sceneHash } from '../film-identity.ts';
import { type Part, readPart } from '../part-file.ts';
import { checkOutputName, isPart, writeFilm } from '../picture-file.ts';
import { startProgress } from '../progress.ts';
import { formatRanges, missingFrom, overlap } from '../sample-ranges.ts';
import { percent, type Terminal } from '../terminal.ts';
import { checkWritable } from '../write-atomically.ts';

export async function merge(files: readonly string[], options: MergeOptions, terminal: Terminal): Promise<void> {
  checkOutputName(options.output);
  checkAovs(options.aov, options.output, isPart(options.output));
  await checkWritable(options.output);
  const parts: { file: string; part: Part }[] = [];
  for (const file of files) parts.push({ file, part: await readPart(file) });
  // In the order of their samples, whatever the order of the names: sums of doubles depend on it in the last digit.
  parts.sort((a, b) => (a.part.film.ranges[0]?.first ?? 0) - (b.part.film.ranges[0]?.first ?? 0));
  const [first, ...others] = parts as [(typeof parts)[0], ...typeof parts];
  for (const { file, part } of others) {
    const differ = differences(part.identity, first.part.identity);
    if (differ.length > 0) throw usage(`${file} and ${first.file} are of different pictures: ${differ.join(', ')}.`);
    const twice = overlap(first.part.film.ranges, part.film.ranges);
    if (twice) throw usage(`${file} holds samples ${formatRanges([twice])}, which another part holds too.`);
    first.part.film.merge(part.film);
  }
  if (options.aov?.includes('error') && !first.part.film.standardErrors())
    throw usage(`These parts hold one block of samples; their error is not known, so leave it out of --aov.`);
  const aovs = options.aov ? await aovsOf(first.part, first.file, options, terminal) : null;
  const written = await writeFilm(options.output, first.part, options, aovs);
  const { film } = first.part;
  const { ranges, samples } = film;
  const error = film.error();
  terminal.event('done', { output: options.output, parts: files.length, samples, ranges, error, files: written });
  const gaps = missingFrom({ first: 0, last: ranges.at(-1)?.last ?? 0 }, ranges);
  if (gaps.length > 0) terminal.note(`Samples ${formatRanges(gaps)} are in no part.`);
  terminal.result(`${options.output}: ${samples} samples a pixel (${formatRanges(ranges)}), error ${percent(error)}`);
}

/** A part holds all that its picture was traced from. */
function jobOf({ identity, texts }: Part, file: string): FilmJob {
  const parsed = parseScene(texts.Scene ?? '');
  if (!parsed.ok || sceneHash(parsed.scene) !== identity.scene)
    throw usage(`${file} has no scene in it to trace AOVs of. Render them: mirrorball render … --resume --aov …`);
  const { width, height, region, seed, time, integrator, settings } = identity;
  const [x, y, columns, rows] = region;
  const { maxDepth, maxReflections, lightSamples } = { ...parsed.scene.render, ...settings };
  return {
    scene: sceneAt(parsed.scene, time),
    settings: {
      integrator: integrator as FilmJob['settings']['integrator'],
      maxDepth,
      maxReflections,
      lightSamples,
      seed,
    },
    width,
    height,
    area: { x, y, width: columns, height: rows },
  };
}

async function aovsOf(part: Part, file: string, options: MergeOptions, terminal: Terminal): Promise<WithAovs> {
  const names = options.aov!;
  const job = jobOf(part, file);
  const { name, tracer } = await openBackend(options.backend);
  terminal.event('backend', { backend: name, description: tracer.description });
  const progress = startProgress(terminal, { picture: `${options.output}, AOVs`, held: 0, wanted: part.film.samples });
  try {
    const films = await traceAovs(names, tracer, job, part.film, new AbortController().signal, progress);
    return { names, films: films!, job };
  } catch (error) {
    throw new CommandError(EXIT.failed, `The AOVs of ${options.output} failed: ${(error as Error).message}`);
  } finally {
    progress.stop();
    await tracer.dispose();
  }
}
