/** Files that come together: dropped on a page, chosen in a dialog, in a zip archive. Known by their paths, of which none may be trusted. */

import { clip, visible } from '../scene-file/problem.ts';

export interface GivenFile {
  /** With "/" or "\" between names; a browser gives no more than the name unless a whole folder comes. */
  readonly path: string;
  /** Bytes. */
  readonly size: number;
  /** Rejects with an Error that says why in a few words. */
  read(): Promise<Uint8Array>;
}

/** A file that is larger than this has more texels or triangles than anybody can use, bytes. */
export const MOST_FILE_BYTES = 2 ** 30;

export class FileSet {
  readonly files: readonly GivenFile[];
  /** By path in one spelling. */
  readonly #byPath = new Map<string, GivenFile>();
  /** By name alone, in one spelling: there may be several. */
  readonly #byName = new Map<string, GivenFile[]>();

  constructor(files: Iterable<GivenFile>) {
    this.files = [...files];
    for (const file of this.files) {
      const path = spelling(segments(file.path).join('/'));
      if (!this.#byPath.has(path)) this.#byPath.set(path, file);
      const name = spelling(nameOf(file.path));
      this.#byName.set(name, [...(this.#byName.get(name) ?? []), file]);
    }
  }

  /**
   * The file that another one names, from that one's folder on. Letter case, composed letters and escapes of URIs need not fit. What is
   * not at its place may be anywhere else if there is only one of its name: a browser does not tell the folders of single files.
   * Throws an Error that says what to do.
   */
  beside(from: string, name: string): GivenFile {
    const folder = segments(from).slice(0, -1);
    for (const wanted of spellingsOf(name)) {
      const exact = this.#byPath.get(spelling(resolve(folder, wanted).join('/')));
      if (exact) return exact;
    }
    const last = nameOf(name);
    for (const wanted of spellingsOf(last)) {
      const [found, ...more] = this.#byName.get(spelling(wanted)) ?? [];
      if (found && more.length === 0) return found;
      if (found) throw new Error(`there are ${more.length + 1} files of this name, and none at this place`);
    }
    throw new Error(
      `it is missing: open ${clip(visible(last), 200)} together with ${clip(visible(nameOf(from)), 200)}`,
    );
  }

  /** `beside`, and its content. */
  async readBeside(from: string, name: string): Promise<Uint8Array> {
    return readGiven(this.beside(from, name));
  }
}

/** Its content, unless it is too large. */
export async function readGiven(file: GivenFile): Promise<Uint8Array> {
  if (file.size > MOST_FILE_BYTES)
    throw new Error(`it has ${file.size} bytes, where at most ${MOST_FILE_BYTES} are read`);
  return file.read();
}

/** The last part of a path. */
export const nameOf = (path: string): string => path.split(/[/\\]/).findLast((part) => part !== '') ?? '';

/** What a name ends in, in small letters, without its dot; "" when it has no ending. */
export const endingOf = (path: string): string => /\.([^./\\]+)$/.exec(nameOf(path))?.[1]?.toLowerCase() ?? '';

/** Folders of a path that is a path from nowhere: ".." leads no further than to the top. */
export const segments = (path: string): string[] => resolve([], path);

function resolve(folder: readonly string[], path: string): string[] {
  const parts = [...folder];
  for (const part of path.split(/[/\\]/)) {
    if (part === '' || part === '.') continue;
    if (part === '..') parts.pop();
    else parts.push(part);
  }
  return parts;
}

/** One spelling for all that a file system may take for the same. */
const spelling = (path: string): string => path.normalize('NFC').toLowerCase();

/** As it stands, and without escapes: exporters write "my%20texture.png" for a file "my texture.png", and the other way round. */
function spellingsOf(name: string): string[] {
  const spellings = [name];
  try {
    spellings.push(decodeURIComponent(name));
  } catch {
    // A % that stands for itself.
  }
  spellings.push(encodeURI(name));
  return [...new Set(spellings)];
}
