/**
 * The second step of reading a scene: files that it names. Who reads a scene says how its files are found, so that nothing is opened
 * or fetched that nobody asked for.
 */
import { readExr } from '../export/exr.ts';
import type { FloatPicture } from '../export/float-picture.ts';
import { readHdr } from '../export/hdr.ts';
import { ImageError } from '../export/image-error.ts';
import { readNpy } from '../export/npy.ts';
import { readPfm } from '../export/pfm.ts';
import { lacksMap } from '../scene/environment.ts';
import type { Scene } from '../scene/scene.ts';
import { environmentFromPicture } from './environment-from-picture.ts';
import { withMap } from './parse-scene.ts';
import { type Problem, ProblemList, quote } from './problem.ts';
import { imageRule } from './schema.ts';

/**
 * Gives the content of a file that a scene names: a path from the scene file's folder on, with "/" between names. It may begin with
 * "../", and never with "/" or "https:". Rejects with an Error whose message says why in a few words, such as "there is no such file".
 */
export type ReadFile = (name: string) => Promise<Uint8Array>;

export type LoadedScene =
  | {
      readonly ok: true;
      readonly scene: Scene;
      /** What was changed in the files' content, as sentences for people. */
      readonly notes: readonly string[];
    }
  | { readonly ok: false; readonly problems: readonly Problem[] };

/** By the name's ending, which `parseScene` has looked at. (The table of all formats would bring their writers into every page.) */
const READERS: Readonly<Record<string, (bytes: Uint8Array) => FloatPicture>> = {
  hdr: readHdr,
  exr: readExr,
  npy: readNpy,
  pfm: readPfm,
};

/** The scene with the content of the files that it names; itself when it names none or has it already. Never rejects. */
export async function loadImages(scene: Scene, readFile: ReadFile): Promise<LoadedScene> {
  const { image } = scene.sky;
  if (image === undefined || !lacksMap(scene.sky)) return { ok: true, scene, notes: [] };
  try {
    const read = READERS[image.slice(image.lastIndexOf('.') + 1).toLowerCase()];
    if (!read) throw new Error('it is no .hdr, .exr, .npy or .pfm file');
    const { map, notes } = environmentFromPicture(read(await readFile(image)));
    return {
      ok: true,
      scene: withMap(scene, map),
      notes: notes.map((note) => `The sky's image ${quote(image)}: ${note}`),
    };
  } catch (error) {
    const problems = new ProblemList();
    const reason = error instanceof Error ? error.message : String(error);
    const broken = error instanceof ImageError;
    const found = `the file ${quote(image)}, which cannot be used (${reason.replace(/\.$/, '')})`;
    const message = `The sky's image ${quote(image)} ${broken ? 'is no picture that can be used. ' : 'cannot be read: '}${sentence(reason)}`;
    problems.add(['sky', 'image'], found, imageRule, message);
    return { ok: false, problems: problems.list() };
  }
}

const sentence = (reason: string): string => (/[.!?]$/.test(reason) ? reason : `${reason}.`);

/** Reads the files that a scene from this address names, from the same server only. */
export function fetchBeside(sceneUrl: string | URL): ReadFile {
  return async (name) => {
    const base = new URL(sceneUrl);
    const url = new URL(name.split('/').map(encodeURIComponent).join('/'), base);
    if (url.origin !== base.origin) throw new Error('it lies on another server than the scene');
    const response = await fetch(url);
    if (!response.ok) throw new Error(`the server answers ${response.status} ${response.statusText}`.trim());
    return new Uint8Array(await response.arrayBuffer());
  };
}
