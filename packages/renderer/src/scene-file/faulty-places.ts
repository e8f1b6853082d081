import type { Path } from './problem.ts';

/**
 * Which parts of a scene failed the schema: a whole section such as "camera" or "shapes", or one thing in it. Later
 * checks pass over them, so that one mistake is one problem.
 */
export class FaultyPlaces {
  readonly #sections = new Set<string>();
  readonly #things = new Set<string>();

  add([section, name]: Path): void {
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

  #key(section: string | number, name: string | number): string {
    return `${section}/${name}`;
  }
}
