/** The sky's image: from the bytes of a file to its map. */
import { readExr } from '../export/exr.ts';
import type { FloatPicture } from '../export/float-picture.ts';
import { readHdr } from '../export/hdr.ts';
import { ImageError } from '../export/image-error.ts';
import { readNpy } from '../export/npy.ts';
import { readPfm } from '../export/pfm.ts';
import type { EnvironmentMap } from '../scene/environment.ts';
import { environmentFromPicture } from './environment-from-picture.ts';
import { type ProblemList, quote, sentence } from './problem.ts';
import type { ReadFile } from './read-file.ts';
import { imageRule } from './schema.ts';

/** By the name's ending, which `parseScene` has looked at. (The table of all formats would bring their writers into every page.) */
const READERS: Readonly<Record<string, (bytes: Uint8Array) => FloatPicture>> = {
  hdr: readHdr,
  exr: readExr,
  npy: readNpy,
  pfm: readPfm,
};

/** Null, and a problem, when it cannot be used. Adds to `notes` what was changed. */
export async function loadImage(
  image: string,
  readFile: ReadFile,
  problems: ProblemList,
  notes: string[],
): Promise<EnvironmentMap | null> {
  try {
    const made = await readPanorama(image, readFile);
    notes.push(...made.notes.map((note) => `The sky's image ${quote(image)}: ${note}`));
    return made.map;
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    const broken = error instanceof ImageError;
    const found = `the file ${quote(image)}, which cannot be used (${reason.replace(/\.$/, '')})`;
    const message = `The sky's image ${quote(image)} ${broken ? 'is no picture that can be used. ' : 'cannot be read: '}${sentence(reason)}`;
    problems.add(['sky', 'image'], found, imageRule, message);
    return null;
  }
}

/** Throws what is wrong with it. */
export async function readPanorama(
  image: string,
  readFile: ReadFile,
): Promise<ReturnType<typeof environmentFromPicture>> {
  const read = READERS[image.slice(image.lastIndexOf('.') + 1).toLowerCase()];
  if (!read) throw new Error('it is no .hdr, .exr, .npy or .pfm file');
  return environmentFromPicture(read(await readFile(image)));
}
