import { formatPointer } from '../scene/pointer.ts';
import type { Path } from './problem.ts';

/**
 * Which parts of a scene failed the schema: a whole section such as "camera" or "shapes", or one thing in it. Later
 * checks pass over them, so that one mistake is one problem.
 */
export class FaultyPlaces {
  readonly #sections = new Set<string>();
  readonly #things = new Set<string>();
  readonly #places = new Set<string>();

  add(path: Path): void {
    const [section, name] = path;
    this.#places.add(formatPointer(path));
    if (section === undefined) return;
    if (name === undefined) this.#sections.add(String(section));
    else this.#things.add(this.#key(section, name));
  }

  /** Whether this section could not be read at all, or, with a name, whether this thing of it could not. */
  has(section: string, name?: string): boolean {
    return this.#sections.has(section) || (name !== undefined && this.#things.has(this.#key(section, name)));
  }

  /** Whether anything in the section failed. */
  touches(section: string): boolean {
    return this.has(section) || [...this.#things].some((thing) => thing.startsWith(`${section}/`));
  }

  /** Whether just this place failed. */
  isAt(path: Path): boolean {
    return this.#places.has(formatPointer(path));
  }

  #key(section: string | number, name: string | number): string {
    return `${section}/${name}`;
  }
}
