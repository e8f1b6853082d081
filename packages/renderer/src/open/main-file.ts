/** Which of several files is the one to open. */
import { endingOf, type GivenFile, nameOf, segments } from './file-set.ts';

/** Files that stand for a whole scene or model, the more telling first: a scene file names meshes, a model brings its own. */
const RANKS: readonly ((path: string) => boolean)[] = [
  (path) => /(^|\.)scene\.json$/i.test(nameOf(path)),
  (path) => ['glb', 'gltf'].includes(endingOf(path)),
  (path) => endingOf(path) === 'json',
  (path) => endingOf(path) === 'obj',
  (path) => endingOf(path) === 'ply',
  (path) => endingOf(path) === 'stl',
];

export interface MainFile<File> {
  readonly main: File;
  /** Others that could have been it. */
  readonly others: readonly File[];
}

/** Of the most telling kind the one nearest to the top, then the largest. Null when none can be opened. */
export function chooseMain<File extends Pick<GivenFile, 'path' | 'size'>>(
  files: readonly File[],
): MainFile<File> | null {
  for (const isOfRank of RANKS) {
    const candidates = files.filter(({ path }) => isOfRank(path) && !nameOf(path).startsWith('._'));
    if (candidates.length === 0) continue;
    const [main, ...others] = candidates.sort(
      (a, b) => segments(a.path).length - segments(b.path).length || b.size - a.size || (a.path < b.path ? -1 : 1),
    );
    return { main: main!, others };
  }
  return null;
}
