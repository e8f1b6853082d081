/** What the worker that opens files is asked, and what it answers. */
import type { EnvironmentMap, ImportReport, PreparedScene, Problem } from 'mirrorball';

/** A file, and where it lay in the folder that came. */
export interface PathFile {
  readonly path: string;
  readonly file: File;
}

export type OpeningJob =
  | { readonly kind: 'model'; readonly files: readonly PathFile[] }
  | { readonly kind: 'environment'; readonly file: File };

/** In the order in which they come, though a file may need only some of them. */
export const PHASES = ['reading', 'geometry', 'images', 'trees'] as const;
export type Phase = (typeof PHASES)[number];

export type Opened =
  | {
      readonly ok: true;
      readonly file: string;
      readonly prepared: PreparedScene;
      readonly report: ImportReport;
      readonly bytes: number;
    }
  | { readonly ok: false; readonly file: string; readonly problems: readonly Problem[] };

export type OpenedEnvironment =
  | { readonly ok: true; readonly file: string; readonly map: EnvironmentMap; readonly notes: readonly string[] }
  | { readonly ok: false; readonly file: string; readonly problems: readonly Problem[] };

/** What the worker posts; the answer is the last. `share` of the phase that is done, 0 … 1. */
export type OpeningMessage =
  | { readonly phase: Phase; readonly share: number }
  | { readonly opened: Opened }
  | { readonly environment: OpenedEnvironment }
  | { readonly failed: string };
