/** Files of the disk, as the library wants to be given them: those of a folder or an archive, and those that others name. */
import { readdir, readFile, stat } from 'node:fs/promises';
import { basename, join, relative } from 'node:path';
import type { GivenFile } from 'mirrorball/open';
import { usage } from './exit-codes.ts';

/** A folder with more files than this is no model's. */
const MOST_FILES = 10_000;

/** The files of a folder, or a .zip archive alone; null for anything else. */
export async function filesIn(path: string): Promise<GivenFile[] | null> {
  const found = await stat(path).catch(() => null);
  if (found?.isFile() && /\.zip$/i.test(path)) return [givenFile(path, basename(path), found.size)];
  if (!found?.isDirectory()) return null;
  const files: GivenFile[] = [];
  for (const folders = [path]; folders.length > 0; ) {
    const folder = folders.pop()!;
    for (const entry of await readdir(folder, { withFileTypes: true })) {
      if (entry.name.startsWith('.')) continue;
      const inner = join(folder, entry.name);
      if (entry.isDirectory()) folders.push(inner);
      else if (entry.isFile()) files.push(givenFile(inner, relative(path, inner), (await stat(inner)).size));
      if (files.length > MOST_FILES)
        throw usage(`The folder ${path} has more than ${MOST_FILES} files: name the file in it that is to be opened.`);
    }
  }
  return files;
}

const givenFile = (path: string, name: string, size: number): GivenFile => ({
  path: name,
  size,
  read: async () => new Uint8Array(await readFile(path)),
});

/**
 * Where a file is that another one names from this folder on. Exporters write back slashes, other letter case and the escapes of
 * addresses: when nothing is at its place, a name that differs in these alone will do.
 */
export async function pathBeside(folder: string, name: string): Promise<string> {
  let path = folder;
  for (const part of name.split(/[/\\]/)) {
    if (part === '' || part === '.') continue;
    const inner = join(path, part);
    path = part === '..' || (await stat(inner).catch(() => null)) ? inner : await alike(path, part);
  }
  return path;
}

async function alike(folder: string, name: string): Promise<string> {
  const names = await readdir(folder).catch((): string[] => []);
  const wanted = spelling(name);
  const found = names.filter((one) => spelling(one) === wanted);
  return join(folder, found.length === 1 ? found[0]! : name);
}

function spelling(name: string): string {
  let plain = name;
  try {
    plain = decodeURIComponent(name);
  } catch {
    // A % that stands for itself.
  }
  return plain.normalize('NFC').toLowerCase();
}
