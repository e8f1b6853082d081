/** `mirrorball convert`: a scene in another format. */
import { existsSync } from 'node:fs';
import { mkdir } from 'node:fs/promises';
import { basename, dirname, extname, join, relative, sep } from 'node:path';
import { fromInterleaved, writeExr } from 'mirrorball/picture-files';
import { placedSceneAt, type Scene, type Sky } from 'mirrorball/scene';
import {
  type ExportEntry,
  type ExportPlan,
  type OnExportProgress,
  type PlannedFiles,
  planGlb,
  planMitsuba,
} from 'mirrorball/scene-export';
import { writeScene } from 'mirrorball/scene-file';
import type { ConvertOptions } from '../arguments.ts';
import { usage } from '../exit-codes.ts';
import { startPreparation } from '../progress.ts';
import { chosen } from '../scene-choices.ts';
import { isModel, requireSceneFile } from '../scene-source.ts';
import type { Terminal } from '../terminal.ts';
import { checkWritable, writeAtomically } from '../write-atomically.ts';

export async function convert(
  file: string,
  output: string,
  options: ConvertOptions,
  terminal: Terminal,
): Promise<void> {
  const write = WRITERS[extname(output).toLowerCase()];
  if (write === undefined) throw usage(`${output}: a scene is written as .glb, .xml or .json.`);
  // Files for Mitsuba are many: they may go into a folder of their own, which is made.
  let made = output;
  while (!existsSync(dirname(made))) made = dirname(made);
  await checkWritable(made);
  const scene = await chosen(await requireSceneFile(file, terminal), options, terminal);
  const packing = startPreparation(terminal, output, 'images', 'packing images');
  const { files, report } = write(scene, { file, output, options, onProgress: (share) => packing.update(share) });
  packing.stop();
  await mkdir(dirname(output), { recursive: true });
  const written = [...files.keys()].map((name) => join(dirname(output), name));
  // One after the other, so that no more than one of them takes memory.
  for (const [name, pieces] of files) await writeAtomically(join(dirname(output), name), pieces());
  terminal.event('converted', { output, files: written, report });
  for (const entry of report) terminal.note(told(entry));
  terminal.result(written.join('\n'));
}

/** So many things are named in a line. */
const MOST_TOLD = 6;

function told({ kind, message, things }: ExportEntry): string {
  const more = things.length > MOST_TOLD ? ` and ${things.length - MOST_TOLD} more` : '';
  return `${kind === 'lost' ? 'Lost' : 'Changed'}: ${message} (${things.slice(0, MOST_TOLD).join(', ')}${more})`;
}

interface Request {
  readonly file: string;
  readonly output: string;
  readonly options: ConvertOptions;
  readonly onProgress: OnExportProgress;
}

const nameOf = (output: string): string => basename(output, extname(output));

const WRITERS: Readonly<Record<string, (scene: Scene, request: Request) => ExportPlan>> = {
  '.glb': (scene, { output, onProgress }) => planGlb(scene, { name: nameOf(output), onProgress }),
  '.xml': (scene, { output, options: { time, size, spp } }) =>
    asUsage(() => planMitsuba(scene, { name: nameOf(output), time, ...size, samples: spp })),
  '.json': asJson,
};

/** What a format cannot do at all is told as what was asked for in vain. */
function asUsage<Result>(act: () => Result): Result {
  try {
    return act();
  } catch (error) {
    throw usage((error as Error).message);
  }
}

/** A scene file; a model is named by it and stays in its own file. */
function asJson(scene: Scene, { file, output, options }: Request): ExportPlan {
  const files: PlannedFiles = new Map();
  const beside = (name: string): string =>
    relative(dirname(output), join(dirname(file), name))
      .split(sep)
      .join('/');
  const { image, ...nameless } = scene.sky;
  // A picture that was given beside the scene counts from no folder of a scene.
  const given = options.env === undefined && image !== undefined ? { ...scene.sky, image: beside(image) } : nameless;
  const sky = writtenSky(given, `${nameOf(output)}.sky.exr`, files);
  const { name, description, render, version } = scene;
  const { camera } = placedSceneAt(scene, 0);
  const model = {
    file: beside(basename(file)),
    translation: [0, 0, 0],
    rotation: [0, 0, 0],
    scale: [1, 1, 1],
  } as const;
  const whole: Scene = isModel(file)
    ? { version, name, description, camera, sky, models: { model }, materials: {}, shapes: {}, lights: {}, animation: [], render, ...(scene.clip !== undefined && { clip: `model/${scene.clip}` }) } // biome-ignore format: one thought
    : { ...withFiles(scene, beside), sky };
  const text = asUsage(() => writeScene(whole));
  files.set(basename(output), () => [new TextEncoder().encode(text)]);
  const report: ExportEntry[] = [];
  if (isModel(file) && scene.camera.node !== undefined)
    report.push({ kind: 'changed', message: 'The camera of a node counts from the world there.', things: ['camera'] });
  return { files, report };
}

/** A sky without a file gets one. */
function writtenSky(sky: Sky, name: string, files: PlannedFiles): Sky {
  const { map, image } = sky;
  if (!map || image !== undefined) return sky;
  files.set(name, () => [writeExr(fromInterleaved(map.width, map.height, ['R', 'G', 'B'], map.data))]);
  return { ...sky, image: name };
}

/** Names of files count from another folder now. */
function withFiles(scene: Scene, beside: (name: string) => string): Scene {
  const moved = <Thing extends { readonly file?: string }>(things: Readonly<Record<string, Thing>> | undefined) =>
    things &&
    Object.fromEntries(
      Object.entries(things).map(([name, thing]) => [
        name,
        thing.file === undefined ? thing : { ...thing, file: beside(thing.file) },
      ]),
    );
  const { meshes, images, models } = scene;
  return {
    ...scene,
    ...(meshes && { meshes: moved(meshes)! }),
    ...(images && { images: moved(images)! }),
    ...(models && { models: moved(models)! }),
  };
}
