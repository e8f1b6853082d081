/** A picture of all around, .hdr, .exr, .npy or .pfm → the map of a sky. */
import type { EnvironmentMap } from '../scene/environment.ts';
import { loadImage } from '../scene-file/load-image.ts';
import { type Problem, ProblemList } from '../scene-file/problem.ts';
import { endingOf, type GivenFile, nameOf, readGiven } from './file-set.ts';

export type OpenedSky =
  | { readonly ok: true; readonly map: EnvironmentMap; readonly notes: readonly string[] }
  | { readonly ok: false; readonly problems: readonly Problem[] };

/** Whether the file's name says that it is such a picture. */
export const isSkyName = (path: string): boolean => ['hdr', 'exr', 'npy', 'pfm'].includes(endingOf(path));

/** Never rejects. */
export async function openEnvironment(file: GivenFile): Promise<OpenedSky> {
  const problems = new ProblemList();
  const notes: string[] = [];
  const map = await loadImage(nameOf(file.path), () => readGiven(file), problems, notes);
  return map ? { ok: true, map, notes } : { ok: false, problems: problems.list() };
}
