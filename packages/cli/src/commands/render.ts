/** `mirrorball render`: scene → film → file, one picture or many. */
import { existsSync } from 'node:fs';
import { rm } from 'node:fs/promises';
import { basename } from 'node:path';
import type { FilmArea, FilmJob, FilmSettings, FilmTracer } from 'mirrorball/headless';
import { posedSceneAt, type Scene } from 'mirrorball/scene';
import { writeScene } from 'mirrorball/scene-file';
import { AccumulatedFilm } from '../accumulated-film.ts';
import { type AovFilms, aovSamples, traceAovs } from '../aov-films.ts';
import { checkAovs, checkErrorKnown, type WithAovs } from '../aov-pictures.ts';
import type { RenderOptions } from '../arguments.ts';
import { type Backend, openBackend } from '../backends/open-backend.ts';
import { defaultOutput } from '../default-output.ts';
import { CommandError, EXIT, usage } from '../exit-codes.ts';
import { differences, identityOf } from '../film-identity.ts';
import { checkFinished } from '../finished-picture.ts';
import { type Frame, framesOf } from '../frames.ts';
import { type Interruption, listenForInterruption } from '../interruption.ts';
import { type Part, readPart, writePart } from '../part-file.ts';
import { checkOutputName, isPart, PART, writeFilm } from '../picture-file.ts';
import { startProgress, startTrees } from '../progress.ts';
import { areaOf, inParts, settingsOf, wantedOf } from '../render-request.ts';
import { type Ending, type FilmGoal, runFilm } from '../run-film.ts';
import { countOf, formatRanges, missingFrom } from '../sample-ranges.ts';
import { noSavings, type Savings, startSavings } from '../savings.ts';
import { checkChoices, chosen } from '../scene-choices.ts';
import { isModel, requireSceneFile } from '../scene-source.ts';
import { duration, percent, type Terminal } from '../terminal.ts';
import { software } from '../version.ts';
import { checkWritable } from '../write-atomically.ts';

/** What all pictures of a run share. */
interface Run {
  readonly scene: Scene;
  /** What it was read from. */
  readonly file: string;
  readonly options: RenderOptions;
  readonly settings: FilmSettings;
  readonly area: FilmArea;
  readonly goal: FilmGoal;
  readonly terminal: Terminal;
  readonly interruption: Interruption;
  readonly backend: () => Promise<Backend>;
  /** What --resume finds done, by the name of the frame: what to tell of it. */
  readonly finished: ReadonlyMap<string, string>;
}

export async function render(file: string, given: RenderOptions, terminal: Terminal): Promise<void> {
  const options = given.output === undefined && !needsName(given) ? { ...given, output: defaultOutput(file, existsSync) } : given; // biome-ignore format: one choice
  const area = areaOf(options);
  const frames = framesOf(options);
  await checkOutput(options, frames);
  const scene = await chosen(await requireSceneFile(file, terminal), options, terminal);
  const settings = settingsOf(scene, options);
  checkChoices(options, settings);
  const { untilError, untilTime } = options;
  const goal = { wanted: wantedOf(options), untilError, untilTime };
  checkErrorKnown(options.aov, goal.wanted);
  const wantedPicture = { goal, exposure: options.exposure ?? scene.render.exposure, aov: options.aov };
  const finished = new Map<string, string>();
  // All of them before anything is traced: a refusal must not come after hours.
  for (const frame of options.resume ? frames : [])
    if (isFinished(frame)) {
      const identity = identityOf(scene, frame.time, settings, { ...options.size, area });
      finished.set(frame.name, await checkFinished(frame.output, { identity, ...wantedPicture }));
    }
  const interruption = listenForInterruption();
  let opened: Promise<Backend> | null = null;
  const backend = () => (opened ??= open(options, terminal));
  try {
    const run = { file, scene, options, settings, area, goal, terminal, interruption, backend, finished };
    for (const frame of frames) await renderFrame(run, frame);
  } finally {
    interruption.stop();
    // Also when it was never used, or failed.
    await (opened as Promise<Backend> | null)?.then(({ tracer }) => tracer.dispose()).catch(() => {});
  }
}

async function open(options: RenderOptions, terminal: Terminal): Promise<Backend> {
  const backend = await openBackend(options.backend);
  terminal.event('backend', { backend: backend.name, description: backend.tracer.description });
  terminal.note(`Tracing with ${backend.name}: ${backend.tracer.description}`);
  return backend;
}

/** Where a name is wanted, or no picture at all. */
const needsName = ({ pixel, resume, frames }: RenderOptions): boolean => Boolean(pixel || resume || frames);

async function checkOutput({ output, pixel, resume, aov }: RenderOptions, frames: readonly Frame[]): Promise<void> {
  if (resume && output === undefined) throw usage('--resume needs -o: what was saved lies beside it.');
  if (output === undefined && !pixel) throw usage('Say where the picture goes: -o out.exr (or ask for one --pixel).');
  checkAovs(aov, output, output !== undefined && isPart(output));
  if (output === undefined) return;
  checkOutputName(output);
  for (const { output: file } of frames.slice(0, 1)) await checkWritable(file!);
}

const partFileOf = (output: string): string => (isPart(output) ? output : `${output}${PART}`);

/** Whether there is a picture and nothing that could go on. */
const isFinished = (frame: Frame): frame is Frame & { readonly output: string } =>
  frame.output !== undefined && existsSync(frame.output) && !existsSync(partFileOf(frame.output));

/** Each event of a frame has its number. */
const tellingNumber = (terminal: Terminal, { number }: Frame): Terminal =>
  number === null
    ? terminal
    : { ...terminal, event: (event, fields) => terminal.event(event, { ...fields, frame: number }) };

async function renderFrame(all: Run, frame: Frame): Promise<void> {
  const run = { ...all, terminal: tellingNumber(all.terminal, frame) };
  const { options, terminal, interruption, finished } = run;
  interruption.check('Nothing was begun.');
  const kept = finished.get(frame.name);
  if (kept) {
    terminal.event('kept', { picture: frame.name });
    return terminal.note(kept);
  }
  const partFile = frame.output && partFileOf(frame.output);
  const part = await partFor(run, frame, partFile);
  const held = part.film.samples;
  const job = jobOf(run, frame);
  const savings = savingsOf(run, frame, part, partFile);
  let traced: Traced;
  let aovs: WithAovs | null = null;
  try {
    traced = await trace(run, frame, part, job, savings);
    const films = traced.ending === 'interrupted' ? null : await aovsOf(run, frame, part, job);
    if (films === 'interrupted') traced = { ...traced, ending: films };
    else if (films) aovs = { names: options.aov!, films, job };
  } catch (error) {
    if (error instanceof CommandError) throw error;
    const saved = await save(part, held, partFile);
    throw new CommandError(EXIT.failed, `${frame.name} failed: ${(error as Error).message}${inParts(error)} ${saved}`);
  }
  if (traced.ending === 'interrupted') interruption.check(await save(part, held, partFile));
  const files = frame.output ? await writeFilm(frame.output, part, options, aovs) : [];
  if ((options.resume || savings.wrote) && partFile !== frame.output) await rm(partFile!, { force: true });
  report(run, frame, part, traced, files);
}

function jobOf({ scene, options, settings, area }: Run, frame: Frame): FilmJob {
  return { scene: posedSceneAt(scene, frame.time), settings, ...options.size, area };
}

/** What is held already, when --resume finds it, or an empty film. */
async function partFor(
  { scene, file, options, settings, area, terminal }: Run,
  frame: Frame,
  partFile?: string,
): Promise<Part> {
  const identity = identityOf(scene, frame.time, settings, { ...options.size, area });
  if (partFile && existsSync(partFile)) {
    if (options.resume) {
      const part = await readPart(partFile);
      const differ = differences(part.identity, identity);
      if (differ.length > 0) throw usage(`${partFile} belongs to another picture: it has ${differ.join(', ')}.`);
      const samples = formatRanges(part.film.ranges);
      terminal.event('resumed', { picture: frame.name, part: partFile, samples });
      terminal.note(`Going on from ${partFile}: samples ${samples}.`);
      return part;
    }
    if (partFile !== frame.output)
      terminal.note(
        `${partFile} is there from an interrupted run; --resume would go on from it, and this run replaces it.`,
      );
  }
  const film = new AccumulatedFilm(area.width * area.height);
  // A model's arrays have no place in a text.
  const source = sourceOf(scene, file);
  const texts = { Title: scene.name, Software: software, ...source };
  return { identity, film, texts, exposure: scene.render.exposure };
}

/** The scene as a text, or the name of the model that no text can hold. */
function sourceOf(scene: Scene, file: string): Record<string, string> {
  const model = { Model: basename(file) };
  if (isModel(file)) return model;
  try {
    return { Scene: writeScene(scene) };
  } catch (error) {
    // With models of its own of which it shows a variant.
    if (error instanceof TypeError) return model;
    throw error;
  }
}

/** How a picture got its samples. */
interface Traced {
  readonly ending: Ending;
  readonly seconds: number;
  /** Samples that were there before. */
  readonly held: number;
}

async function trace(
  { goal, terminal, interruption, backend }: Run,
  frame: Frame,
  part: Part,
  job: FilmJob,
  savings: Savings,
): Promise<Traced> {
  const { film } = part;
  const held = film.samples;
  if (missingFrom(goal.wanted, film.ranges).length === 0) return { ending: 'all samples', seconds: 0, held };
  const { name, tracer } = await backend();
  await begin(tracer, job, terminal, frame.name);
  const missing = countOf(missingFrom(goal.wanted, film.ranges));
  const { untilError, untilTime } = goal;
  terminal.event('start', { picture: frame.name, backend: name, time: frame.time, held, wanted: held + missing });
  const started = performance.now();
  const progress = startProgress(terminal, {
    picture: frame.name,
    held,
    wanted: held + missing,
    untilError,
    untilTime,
  });
  try {
    const ending = await runFilm(tracer, film, goal, interruption.signal, progress, savings);
    return { ending, seconds: (performance.now() - started) / 1000, held };
  } finally {
    progress.stop();
  }
}

async function begin(tracer: FilmTracer, job: FilmJob, terminal: Terminal, picture: string): Promise<void> {
  const trees = startTrees(terminal, picture);
  try {
    await tracer.begin(job, { onProgress: trees.update });
  } finally {
    trees.stop();
  }
}

/**
 * Writes the part file now and then. A disk that is full then is told of and does not end the render, which may well be through before
 * anything is needed of it.
 */
function savingsOf(
  { options, terminal }: Run,
  frame: Frame,
  part: Part,
  partFile?: string,
): Savings & { readonly wrote: boolean } {
  if (!partFile || options.saveEvery === 0) return { ...noSavings, wrote: false };
  let wrote = false;
  const savings = startSavings(options.saveEvery, async () => {
    try {
      await writePart(partFile, part);
      wrote = true;
      const samples = formatRanges(part.film.ranges);
      terminal.event('saved', { picture: frame.name, part: partFile, samples });
    } catch (error) {
      terminal.event('not saved', { picture: frame.name, part: partFile, message: (error as Error).message });
      terminal.note(`The samples so far could not be saved: ${(error as Error).message}`);
    }
  });
  return {
    ...savings,
    get wrote() {
      return wrote;
    },
  };
}

/** Null when none are wanted. */
async function aovsOf(
  { options, terminal, interruption, backend }: Run,
  frame: Frame,
  { film }: Part,
  job: FilmJob,
): Promise<AovFilms | 'interrupted' | null> {
  if (!options.aov || !frame.output) return null;
  const { tracer } = await backend();
  const progress = startProgress(terminal, {
    picture: `${frame.name}, AOVs`,
    held: 0,
    wanted: aovSamples(options.aov, film),
  });
  try {
    return (await traceAovs(options.aov, tracer, job, film, interruption.signal, progress)) ?? 'interrupted';
  } finally {
    progress.stop();
  }
}

/** Keeps what has been done; gives the sentence that says so. */
async function save(part: Part, held: number, partFile?: string): Promise<string> {
  const { samples, ranges } = part.film;
  if (!partFile || samples === 0) return 'There was nothing to save.';
  if (samples === held) return `${partFile} still holds samples ${formatRanges(ranges)}.`;
  await writePart(partFile, part);
  return `Samples ${formatRanges(ranges)} are in ${partFile}; --resume goes on.`;
}

function report(
  { options, terminal }: Run,
  frame: Frame,
  part: Part,
  { ending, seconds, held }: Traced,
  files: readonly string[],
): void {
  const { film } = part;
  const { samples, ranges } = film;
  const error = film.error();
  const pixel = options.pixel && { pixel: [options.pixel.x, options.pixel.y], value: Array.from(film.mean()) };
  const time = frame.time;
  terminal.event('done', {
    picture: frame.name,
    output: frame.output ?? null,
    ...(options.aov && { files, aovs: options.aov }),
    time,
    samples,
    ranges,
    error,
    seconds,
    ending,
    ...pixel,
  });
  if (pixel) terminal.result(pixel.value.map((value) => String(Math.fround(value))).join(' '));
  if (!frame.output) return;
  if (files.length > 1) terminal.result(files.slice(1).join(' '));
  const rate = (part.film.pixels * (samples - held)) / Math.max(seconds, 1e-3) / 1e6;
  const told = ending === 'all samples' ? '' : ` (${ending})`;
  terminal.result(
    `${frame.output}: ${samples} ${samples === 1 ? 'sample' : 'samples'} a pixel${told}, error ${percent(error)}, ${duration(seconds)}, ${rate.toPrecision(3)} million samples/s`,
  );
}
