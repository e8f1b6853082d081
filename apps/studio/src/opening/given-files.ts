/** What a person dropped or chose → files with their paths. */
import type { PathFile } from './job.ts';

/** A dropped folder may be a whole disk: so many files are listed, so deep. What lies beyond would have to be left out, so it is refused. */
export const MOST_FILES = 10_000;
const DEEPEST = 16;

export class TooManyFiles extends Error {}

/** Of a file or folder picker. Folders come with the paths of their files. */
export const chosenFiles = (files: Iterable<File>): PathFile[] =>
  [...files].map((file) => ({ path: file.webkitRelativePath || file.name, file }));

/** To be called in the event itself, as it forgets what it holds. Rejects with `TooManyFiles`, or when a folder cannot be read. */
export function droppedFiles(dropped: DataTransfer | null): Promise<PathFile[]> {
  const items = [...(dropped?.items ?? [])].filter(({ kind }) => kind === 'file');
  const entries = items.map((item) => ({ entry: item.webkitGetAsEntry?.() ?? null, file: item.getAsFile() }));
  return walk(entries);
}

async function walk(entries: readonly { entry: FileSystemEntry | null; file: File | null }[]): Promise<PathFile[]> {
  const found: PathFile[] = [];
  for (const { entry, file } of entries) {
    if (entry?.isDirectory) await walkFolder(entry as FileSystemDirectoryEntry, '', 0, found);
    else if (file) found.push({ path: file.name, file });
  }
  return found;
}

async function walkFolder(folder: FileSystemDirectoryEntry, above: string, depth: number, found: PathFile[]) {
  const path = `${above}${folder.name}/`;
  if (depth > DEEPEST) throw new TooManyFiles();
  const reader = folder.createReader();
  for (;;) {
    // Browsers give a hundred at a time, and an empty list at the end.
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return;
    for (const entry of some) {
      if (found.length >= MOST_FILES) throw new TooManyFiles();
      if (entry.isDirectory) await walkFolder(entry as FileSystemDirectoryEntry, path, depth + 1, found);
      else found.push({ path: `${path}${entry.name}`, file: await fileOf(entry as FileSystemFileEntry) });
    }
  }
}

const fileOf = (entry: FileSystemFileEntry) => new Promise<File>((resolve, reject) => entry.file(resolve, reject));
