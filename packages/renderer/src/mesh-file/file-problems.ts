/** What is wrong with a file of triangles: all of it, each with its place, in sentences for people. */
import { SCENE_LIMITS } from '../scene/limits.ts';
import { quote } from '../scene-file/problem.ts';

/** All texts are short, and safe to show. */
export interface FileProblem {
  /** Of a text: counted from 1. */
  readonly line?: number;
  /** Of a binary file: counted from 0. */
  readonly byte?: number;
  /** What stands there. */
  readonly found: string;
  /** What may stand there. */
  readonly allowed: string;
  /** All of this as an English sentence. */
  readonly message: string;
}

export type Place = Pick<FileProblem, 'line' | 'byte'>;
/** Of what no one place is wrong. */
export const WHOLE: Place = {};

/** So many problems are listed; one more tells how many there are beyond. */
export const MOST_FILE_PROBLEMS = 20;

/** Thrown, and caught by `reading`, where going on makes no sense. */
class Stop extends Error {}

export class FileProblems {
  readonly name: string;
  readonly #kept: FileProblem[] = [];
  #beyond = 0;

  constructor(name: string) {
    this.name = name;
  }

  get isEmpty(): boolean {
    return this.#kept.length === 0;
  }

  add(place: Place, found: string, allowed: string): void {
    if (this.#kept.length >= MOST_FILE_PROBLEMS) {
      this.#beyond++;
      return;
    }
    const where = place.line !== undefined ? `At line ${place.line} ` : place.byte !== undefined ? `At byte ${place.byte} ` : ''; // biome-ignore format: one choice
    const message = `${where}${quote(this.name)} has ${found}; expected ${allowed}.`;
    this.#kept.push({ ...place, found, allowed, message });
  }

  /** The last problem that is told. */
  fail(place: Place, found: string, allowed: string): never {
    this.add(place, found, allowed);
    throw new Stop();
  }

  /** Where nothing more can be told than has been. */
  stop(): never {
    throw new Stop();
  }

  list(): FileProblem[] {
    if (this.#beyond === 0) return [...this.#kept];
    const message = `… and ${this.#beyond} more problems.`;
    return [...this.#kept, { found: `${this.#beyond} more`, allowed: 'none', message }];
  }
}

export type Read<Content> = ({ readonly ok: true } & Content) | FileRefused;
export interface FileRefused {
  readonly ok: false;
  readonly problems: readonly FileProblem[];
}

/** What `read` gives, or all the problems that it told. */
export function reading<Content extends object>(
  name: string,
  read: (problems: FileProblems) => Content,
): Read<Content> {
  const problems = new FileProblems(name);
  try {
    const content = read(problems);
    if (problems.isEmpty) return { ok: true, ...content };
  } catch (error) {
    // Counts are held against the file's size first, so this is a large file on a small machine.
    if (error instanceof RangeError && /alloc|array length|memory/i.test(error.message))
      problems.add(WHOLE, 'more than this machine has memory for', 'fewer triangles');
    else if (!(error instanceof Stop)) throw error;
  }
  return { ok: false, problems: problems.list() };
}

/** Refuses a number of vertices or triangles that is more than a scene may have. */
export function checkCount(what: 'vertices' | 'triangles', count: number, place: Place, problems: FileProblems): void {
  const most = what === 'vertices' ? SCENE_LIMITS.meshVertices : SCENE_LIMITS.meshTriangles;
  if (count > most) problems.fail(place, `${count} ${what}`, `at most ${most} of them`);
}
