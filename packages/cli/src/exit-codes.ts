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

export class BadSceneError extends CommandError {
  readonly scenes: readonly BadScene[];
  constructor(scenes: readonly BadScene[]) {
    const count = scenes.reduce((sum, { problems }) => sum + problems.length, 0);
    const files = scenes.map(({ file }) => file).join(', ');
    super(EXIT.badScene, `${count} ${count === 1 ? 'problem' : 'problems'} in ${files}.`);
    this.scenes = scenes;
  }
}
