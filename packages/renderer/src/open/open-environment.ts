/** A picture of all around, .hdr, .exr, .npy or .pfm → the map of a sky. */
import type { EnvironmentMap } from '../scene/environment.ts';
import { readPanorama } from '../scene-file/load-image.ts';
import { type Problem, quote, sentence } from '../scene-file/problem.ts';
import { endingOf, type GivenFile, nameOf, readGiven } from './file-set.ts';

export type OpenedSky =
  | { readonly ok: true; readonly map: EnvironmentMap; readonly notes: readonly string[] }
  | { readonly ok: false; readonly problems: readonly Problem[] };

/** Whether the file's name says that it is such a picture. */
export const isSkyName = (path: string): boolean => ['hdr', 'exr', 'npy', 'pfm'].includes(endingOf(path));

/** Never rejects. */
export async function openEnvironment(file: GivenFile): Promise<OpenedSky> {
  const name = nameOf(file.path);
  try {
    return { ok: true, ...(await readPanorama(name, () => readGiven(file))) };
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    const found = `a panorama that cannot be used (${reason.replace(/\.$/, '')})`;
    const message = `${quote(name)} is no panorama that can be used. ${sentence(reason)}`;
    return { ok: false, problems: [{ path: '', found, allowed: 'a whole .hdr, .exr, .npy or .pfm picture', message }] };
  }
}
