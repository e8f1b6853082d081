/** How the program ends. docs/command-line.md tells people; scripts rely on the numbers. */
import type { Problem } from 'mirrorball/scene-file';

export const EXIT = { done: 0, failed: 1, usage: 2, noDevice: 3, badScene: 4, sigint: 130, sigterm: 143 } as const;
export type ExitCode = (typeof EXIT)[keyof typeof EXIT];

/** An end with a sentence for a person and a number for a script. What is thrown otherwise is a bug, or a failed render. */
export class CommandError extends Error {
  readonly code: ExitCode;
  constructor(code: ExitCode, message: string) {
    super(message);
    this.code = code;
  }
}

export const usage = (message: string): CommandError => new CommandError(EXIT.usage, message);

/** What is wrong with one scene file, all of it. */
export interface BadScene {
  readonly file: string;
  readonly problems: readonly Problem[];
}

/** Files that are not what a command wants: scenes with problems, and others that cannot be read or are no such file. */
export class BadFilesError extends CommandError {
  readonly scenes: readonly BadScene[];
  /** Why each of the others is refused, with its name. */
  readonly refusals: readonly string[];
  constructor(scenes: readonly BadScene[], refusals: readonly string[] = []) {
    const count = scenes.reduce((sum, { problems }) => sum + problems.length, 0);
    const files = scenes.map(({ file }) => file).join(', ');
    const told = scenes.length > 0 ? [`${count} ${count === 1 ? 'problem' : 'problems'} in ${files}.`] : [];
    if (refusals.length > 0)
      told.push(`${refusals.length} ${refusals.length === 1 ? 'file' : 'files'} cannot be read.`);
    super(scenes.length > 0 ? EXIT.badScene : EXIT.usage, told.join(' '));
    this.scenes = scenes;
    this.refusals = refusals;
  }
}

/** Looks at every file, whatever is wrong with those before; then rejects with all that was wrong. */
export async function lookAtAll(
  files: readonly string[],
  look: (file: string) => Promise<BadScene | null>,
): Promise<void> {
  const scenes: BadScene[] = [];
  const refusals: string[] = [];
  for (const file of files)
    try {
      const bad = await look(file);
      if (bad) scenes.push(bad);
    } catch (error) {
      if (!(error instanceof CommandError) || error.code !== EXIT.usage) throw error;
      // Alone it needs no sum of all.
      if (files.length === 1) throw error;
      refusals.push(error.message);
    }
  if (scenes.length + refusals.length > 0) throw new BadFilesError(scenes, refusals);
}
