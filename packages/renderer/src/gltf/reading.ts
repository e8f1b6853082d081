/** What all parts of the reading share. */
import type { ProblemList } from '../scene-file/problem.ts';
import type { Column } from './accessors.ts';
import type { Gltf } from './json.ts';
import { Names } from './names.ts';
import type { ReportList } from './report.ts';

export interface Reading {
  readonly json: Gltf;
  readonly columns: readonly Column[];
  readonly buffers: readonly (Uint8Array | null)[];
  readonly problems: ProblemList;
  readonly report: ReportList;
}

/** Things of the scene by name, and the name of each by its place in the file. */
export class NamedThings<Thing> {
  readonly #names = new Names();
  readonly #byIndex = new Map<number, string>();
  readonly things: Record<string, Thing> = Object.create(null);

  /** Takes up a thing; `index` is its place in the file, when it has one. */
  add(thing: Thing, wanted: string | undefined, otherwise: string, index?: number): string {
    const name = this.reserve(wanted, otherwise, index);
    this.things[name] = thing;
    return name;
  }

  /** A name for a thing that is made later. */
  reserve(wanted: string | undefined, otherwise: string, index?: number): string {
    const name = this.#names.unique(wanted, otherwise);
    if (index !== undefined) this.#byIndex.set(index, name);
    return name;
  }

  nameOf(index: number): string | undefined {
    return this.#byIndex.get(index);
  }

  get count(): number {
    return Object.keys(this.things).length;
  }
}

/** A number of the file kept in its range; what is beyond is told. */
export function within(
  reading: Reading,
  value: number,
  least: number,
  most: number,
  path: readonly (string | number)[],
): number {
  const kept = Math.min(Math.max(value, least), most);
  if (kept !== value) {
    const what = String(path.findLast((segment) => typeof segment === 'string'));
    reading.report.add(
      'changed',
      what,
      path,
      `${what} is ${value} where ${least} to ${most} is allowed; it counts as ${kept}.`,
    );
  }
  return kept;
}
