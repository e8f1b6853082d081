/** Scenes from files, or built-in ones by name, with everything that is wrong with them. */
import { readFile, stat } from 'node:fs/promises';
import { basename, dirname } from 'node:path';
import { builtInScenes } from 'mirrorball/built-in';
import { nearest } from 'mirrorball/headless';
import { type GltfProgress, MOST_FILE_BYTES, type OpenedModel, openFiles, openModel } from 'mirrorball/open';
import type { Scene } from 'mirrorball/scene';
import { BadFilesError, type BadScene, usage } from './exit-codes.ts';
import { filesIn, pathBeside } from './given-files.ts';
import type { Terminal } from './terminal.ts';

export interface GoodScene {
  readonly file: string;
  readonly scene: Scene;
  /** What was changed in files that it names, as sentences. */
  readonly notes: readonly string[];
}
export type SceneSource = GoodScene | BadScene;

/** Models that say all of a scene, and that scene files can name. */
export const isModel = (file: string): boolean => /\.(glb|gltf|obj|ply|stl)$/i.test(file);

/** What the file holds, whatever kind it is of; null when it is no file. */
async function bytesOf(file: string): Promise<Uint8Array | null> {
  try {
    return file === STDIN ? await readStdin(process.stdin) : await readFile(file);
  } catch (error) {
    if (builtInScenes.some(({ id }) => id === file)) return null;
    throw usage(whyUnreadable(file, error as NodeJS.ErrnoException));
  }
}

/** The scene comes on standard input; files that it names are looked for in the working folder. */
const STDIN = '-';

async function readStdin(stream: NodeJS.ReadableStream): Promise<Uint8Array> {
  const chunks: Buffer[] = [];
  for await (const chunk of stream) chunks.push(Buffer.from(chunk));
  return Buffer.concat(chunks);
}

/** What is neither a file nor the name of a built-in scene may have been meant to be one. */
export function whyUnreadable(file: string, { code, message }: NodeJS.ErrnoException): string {
  if (/^https?:/i.test(file)) return `${file} is an address, and only files are opened: download it first.`;
  if (code !== 'ENOENT') return `The scene ${file} cannot be read: ${message}.`;
  const ids = builtInScenes.map(({ id }) => id);
  const meant = nearest(file, ids);
  const hint = meant === null ? '' : ` Did you mean ${meant}?`;
  return `There is no file ${file}, and no built-in scene of this name: these are ${ids.join(', ')}.${hint}`;
}

/**
 * Rejects only when the file cannot be read at all. A file goes before a built-in scene of its name; a folder and a .zip archive are the
 * model or scene in them. With `terminal` it tells the phase when that takes a while.
 */
export async function readScene(file: string, terminal?: Terminal): Promise<SceneSource> {
  const onProgress = terminal && tellPhases(file, terminal);
  const { nodeDecoder } = await import('mirrorball/node-images');
  const decoder = nodeDecoder();
  const given = await filesIn(file);
  if (given) return sourceOf(file, await openFiles(given, { decoder, ...(onProgress && { onProgress }) }));
  const bytes = await bytesOf(file);
  if (bytes === null) return { file, scene: builtInScenes.find(({ id }) => id === file)!.scene, notes: [] };
  const opened = await openModel(bytes, file === STDIN ? 'scene.json' : basename(file), {
    readFile: (name) => readBeside(file, name),
    decoder,
    ...(onProgress && { onProgress }),
  });
  return sourceOf(file, opened);
}

const sourceOf = (file: string, opened: OpenedModel): SceneSource =>
  opened.ok
    ? { file, scene: opened.scene, notes: opened.report.entries.map(({ message }) => message) }
    : { file, problems: opened.problems };

const PHASES = {
  files: 'reading',
  numbers: 'unpacking',
  meshes: 'making triangles',
  images: 'decoding images',
} as const;

/** Phases that begin within this after the last one was told are passed over, milliseconds. */
const QUICK = 1500;

function tellPhases(file: string, terminal: Terminal): (progress: GltfProgress) => void {
  let told = performance.now();
  let last = '';
  return ({ step }) => {
    if (step === last || performance.now() - told < QUICK) return;
    [last, told] = [step, performance.now()];
    terminal.note(`${file}: ${PHASES[step]} …`);
  };
}

/** A file that a scene names, by its path from the scene's folder. */
async function readBeside(sceneFile: string, name: string): Promise<Uint8Array> {
  const path = await pathBeside(dirname(sceneFile), name);
  const found = await stat(path).catch((error: NodeJS.ErrnoException) => {
    throw new Error(error.code === 'ENOENT' ? `there is no file ${path}` : error.message);
  });
  if (!found.isFile()) throw new Error(`${path} is no file`);
  if (found.size > MOST_FILE_BYTES)
    throw new Error(`${path} has ${found.size} bytes, where at most ${MOST_FILE_BYTES} are read`);
  return readFile(path);
}

export async function requireSceneFile(file: string, terminal: Terminal): Promise<Scene> {
  const source = await readScene(file, terminal);
  if ('problems' in source) throw new BadFilesError([source]);
  for (const note of source.notes) terminal.note(note);
  return source.scene;
}
