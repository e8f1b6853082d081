import { formatPointer } from '../scene/pointer.ts';
import { describe, type Path, type ProblemList, visible } from '../scene-file/problem.ts';

/** Adds a problem of a glTF file: paths are those of its JSON. */
export function addProblem(problems: ProblemList, path: Path, found: string, allowed: string): void {
  const place = path.length === 0 ? 'In the glTF file' : `In the glTF file, at ${visible(formatPointer(path))}`;
  problems.add(path, found, allowed, `${place}: found ${found}; expected ${allowed}.`);
}

export { describe, type Path };

/** The reading stops: what is wrong stands in the list of problems. */
export class GltfFault extends Error {}
