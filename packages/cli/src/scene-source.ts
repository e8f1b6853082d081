/** Scenes from files, or built-in ones by name, with everything that is wrong with them. */
import { readFile, stat } from 'node:fs/promises';
import { basename, dirname, join } from 'node:path';
import { builtInScenes } from 'mirrorball/built-in';
import { nearest } from 'mirrorball/headless';
import type { Scene } from 'mirrorball/scene';
import { loadFiles, parseScene } from 'mirrorball/scene-file';
import { BadFilesError, type BadScene, usage } from './exit-codes.ts';
import type { Terminal } from './terminal.ts';

export interface GoodScene {
  readonly file: string;
  readonly scene: Scene;
  /** What was changed in files that it names, as sentences. */
  readonly notes: readonly string[];
}
export type SceneSource = GoodScene | BadScene;

/** Models by other programs: a scene and notes of all that was not taken as it stands. */
const MODEL = /\.(glb|gltf)$/i;

export const isModel = (file: string): boolean => MODEL.test(file);

async function readModel(file: string): Promise<SceneSource> {
  const bytes = await readFile(file).catch((error: Error) => {
    throw usage(`The model ${file} cannot be read: ${error.message}`);
  });
  const { importGltf } = await import('mirrorball/gltf');
  const { nodeDecoder } = await import('mirrorball/node-images');
  const name = basename(file).replace(MODEL, '');
  const result = await importGltf(bytes, {
    name,
    readFile: (beside) => readBeside(file, beside),
    decoder: nodeDecoder(),
  });
  if (!result.ok) return { file, problems: result.problems };
  return { file, scene: result.scene, notes: result.report.entries.map(({ message }) => message) };
}

/** Rejects only when the file cannot be read at all. A file goes before a built-in scene of its name. */
export async function readScene(file: string): Promise<SceneSource> {
  if (isModel(file)) return readModel(file);
  let text: string;
  try {
    text = file === STDIN ? await readStdin(process.stdin) : await readFile(file, 'utf8');
  } catch (error) {
    const builtIn = builtInScenes.find(({ id }) => id === file);
    if (builtIn) return { file, scene: builtIn.scene, notes: [] };
    throw usage(whyUnreadable(file, error as NodeJS.ErrnoException));
  }
  const parsed = parseScene(text);
  if (!parsed.ok) return { file, problems: parsed.problems };
  const loaded = await loadFiles(parsed.scene, (name) => readBeside(file, name));
  return loaded.ok ? { file, scene: loaded.scene, notes: loaded.notes } : { file, problems: loaded.problems };
}

/** The scene comes on standard input; files that it names are looked for in the working folder. */
const STDIN = '-';

const readStdin = async (stream: NodeJS.ReadableStream): Promise<string> => {
  const chunks: Buffer[] = [];
  for await (const chunk of stream) chunks.push(Buffer.from(chunk));
  return Buffer.concat(chunks).toString('utf8');
};

/** What is neither a file nor the name of a built-in scene may have been meant to be one. */
export function whyUnreadable(file: string, { code, message }: NodeJS.ErrnoException): string {
  if (code !== 'ENOENT') return `The scene ${file} cannot be read: ${message}.`;
  const ids = builtInScenes.map(({ id }) => id);
  const meant = nearest(file, ids);
  const hint = meant === null ? '' : ` Did you mean ${meant}?`;
  return `There is no file ${file}, and no built-in scene of this name: these are ${ids.join(', ')}.${hint}`;
}

/** A file that is larger than this has more texels or triangles than anybody can use, bytes. */
const MOST_FILE_BYTES = 2 ** 30;

/** A file that a scene names, by its path from the scene's folder. */
async function readBeside(sceneFile: string, name: string): Promise<Uint8Array> {
  const path = join(dirname(sceneFile), ...name.split('/'));
  const found = await stat(path).catch((error: NodeJS.ErrnoException) => {
    throw new Error(error.code === 'ENOENT' ? `there is no file ${path}` : error.message);
  });
  if (!found.isFile()) throw new Error(`${path} is no file`);
  if (found.size > MOST_FILE_BYTES)
    throw new Error(`${path} has ${found.size} bytes, where at most ${MOST_FILE_BYTES} are read`);
  return readFile(path);
}

export async function requireSceneFile(file: string, terminal: Terminal): Promise<Scene> {
  const source = await readScene(file);
  if ('problems' in source) throw new BadFilesError([source]);
  for (const note of source.notes) terminal.note(note);
  return source.scene;
}
