/** Files are there whole or not at all: written beside their place and then moved there in one step. */
import { type FileHandle, open, rename, rm, stat } from 'node:fs/promises';
import { basename, dirname, join } from 'node:path';
import { CommandError, EXIT, usage } from './exit-codes.ts';

const reasonOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Says at once, before hours of work, that a file cannot be written there. */
export async function checkWritable(path: string): Promise<void> {
  const folder = dirname(path);
  const found = await stat(folder).catch(() => null);
  if (!found) throw usage(`${path} cannot be written: there is no folder ${folder}.`);
  if (!found.isDirectory()) throw usage(`${path} cannot be written: ${folder} is no folder.`);
  if ((await stat(path).catch(() => null))?.isDirectory()) throw usage(`${path} cannot be written: it is a folder.`);
  const trial = temporaryFor(path);
  try {
    await (await open(trial, 'w')).close();
    await rm(trial, { force: true });
  } catch (error) {
    throw usage(`${path} cannot be written: ${reasonOf(error)}`);
  }
}

const temporaryFor = (path: string): string => join(dirname(path), `.${basename(path)}.${process.pid}.tmp`);

export async function writeAtomically(path: string, chunks: readonly Uint8Array[]): Promise<void> {
  const temporary = temporaryFor(path);
  try {
    const file = await open(temporary, 'w');
    try {
      for (const chunk of chunks) await writeAll(file, chunk);
      await file.sync();
    } finally {
      await file.close();
    }
    await rename(temporary, path);
  } catch (error) {
    await rm(temporary, { force: true });
    throw new CommandError(EXIT.failed, `${path} could not be written: ${reasonOf(error)}`);
  }
}

/** One call may write less than it was given. */
async function writeAll(file: FileHandle, chunk: Uint8Array): Promise<void> {
  for (let at = 0; at < chunk.length; ) at += (await file.write(chunk, at, chunk.length - at)).bytesWritten;
}
