/** What of a file was not taken as it stands: nothing is left out in silence. */
import type { SceneCounts } from '../scene/counts.ts';
import { formatPointer } from '../scene/pointer.ts';

import { clip, type Path, visible } from '../scene-file/problem.ts';

export interface ReportEntry {
  /** `unsupported`: left out. `changed`: taken in another form. `unused`: in the file, but nothing of the scene shown uses it. */
  readonly kind: 'unsupported' | 'changed' | 'unused';
  /** What it is called, such as "KHR_materials_x" or "points". */
  readonly what: string;
  /** An English sentence. */
  readonly message: string;
  /** JSON Pointers into the glTF file, at most `MOST_PLACES`. */
  readonly places: readonly string[];
  /** How many places there are in all. */
  readonly count: number;
}

export interface ImportReport {
  readonly entries: readonly ReportEntry[];
  /** What the scene has. */
  readonly counts: SceneCounts;
}

export const MOST_PLACES = 20;
const MOST_LETTERS = 1000;

/** Collects entries; what is said of several places is one entry. */
export class ReportList {
  readonly #entries = new Map<
    string,
    { kind: ReportEntry['kind']; what: string; message: string; places: string[]; count: number }
  >();

  /** `said`: may have names of the file in it as they are. */
  add(kind: ReportEntry['kind'], what: string, path: Path, said: string): void {
    const message = clip(visible(said), MOST_LETTERS);
    const key = `${kind} ${what} ${message}`;
    let entry = this.#entries.get(key);
    if (entry === undefined) {
      entry = { kind, what, message, places: [], count: 0 };
      this.#entries.set(key, entry);
    }
    const place = formatPointer(path);
    if (entry.places.includes(place)) return; // several nodes may have one mesh
    entry.count++;
    if (entry.places.length < MOST_PLACES) entry.places.push(place);
  }

  list(): ReportEntry[] {
    return [...this.#entries.values()];
  }
}
