/** What a person dropped or chose → files with their paths. */
import type { PathFile } from './job.ts';

/** A dropped folder may be a whole disk: so many files are listed, so deep. What lies beyond would have to be left out, so it is refused. */
export const MOST_FILES = 10_000;
const DEEPEST = 16;

export class TooManyFiles extends Error {}
export class UnreadableFolder extends Error {}

/** As much of the File System Access API as is used; not all browsers have it. */
interface FolderHandle {
  readonly kind: 'directory';
  entries(): AsyncIterable<[string, FolderHandle | FileHandle]>;
}
interface FileHandle {
  readonly kind: 'file';
  getFile(): Promise<File>;
}
interface Item extends DataTransferItem {
  getAsFileSystemHandle?(): Promise<FolderHandle | FileHandle | null>;
}

/** What was dropped, by all the names under which browsers give it. */
interface Dropped {
  readonly entry: FileSystemEntry | null;
  readonly file: File | null;
  readonly handle: Promise<FolderHandle | FileHandle | null> | null;
}

/** Of a file or folder picker. Folders come with the paths of their files. */
export const chosenFiles = (files: Iterable<File>): PathFile[] =>
  [...files].map((file) => ({ path: file.webkitRelativePath || file.name, file }));

/** To be called in the event itself, as it forgets what it holds. Rejects with `TooManyFiles` or `UnreadableFolder`. */
export function droppedFiles(dropped: DataTransfer | null): Promise<PathFile[]> {
  const items: readonly Item[] = [...(dropped?.items ?? [])].filter(({ kind }) => kind === 'file');
  return walk(items.map(everyName));
}

function everyName(item: Item): Dropped {
  const entry = item.webkitGetAsEntry?.() ?? null;
  const handle = (entry?.isDirectory && item.getAsFileSystemHandle?.().catch(() => null)) || null;
  return { entry, file: item.getAsFile(), handle };
}

async function walk(dropped: readonly Dropped[]): Promise<PathFile[]> {
  const found: PathFile[] = [];
  for (const one of dropped) {
    if (one.entry?.isDirectory) found.push(...(await filesOfFolder(one)));
    else if (one.file) found.push({ path: one.file.name, file: one.file });
    if (found.length > MOST_FILES) throw new TooManyFiles();
  }
  return found;
}

/** Chromium lists a folder dropped on a page from the disk and then gives none of its files; its handle does. */
async function filesOfFolder({ entry, handle }: Dropped): Promise<PathFile[]> {
  const found: PathFile[] = [];
  try {
    await walkFolder(entry as FileSystemDirectoryEntry, '', 0, found);
    return found;
  } catch (error) {
    if (error instanceof TooManyFiles) throw error;
  }
  const folder = await handle;
  if (folder?.kind !== 'directory') throw new UnreadableFolder();
  const again: PathFile[] = [];
  try {
    await walkHandle(folder, `${entry!.name}/`, 0, again);
  } catch (error) {
    throw error instanceof TooManyFiles ? error : new UnreadableFolder();
  }
  return again;
}

async function walkHandle(folder: FolderHandle, path: string, depth: number, found: PathFile[]): Promise<void> {
  if (depth > DEEPEST) throw new TooManyFiles();
  for await (const [name, inner] of folder.entries()) {
    if (found.length >= MOST_FILES) throw new TooManyFiles();
    if (inner.kind === 'directory') await walkHandle(inner, `${path}${name}/`, depth + 1, found);
    else found.push({ path: `${path}${name}`, file: await inner.getFile() });
  }
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
