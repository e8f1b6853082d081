/** What the worker that makes files is asked, and what it answers. */
import type { Scene, ShownFilm } from 'mirrorball';
import type { ExportEntry } from 'mirrorball/scene-export';

export type SavedAs = 'png' | 'exr' | 'glb' | 'mitsuba';

/** Pictures are made of the film; it has no more than can be seen beside the panel. */
export type SavingJob =
  | {
      readonly as: 'png' | 'exr';
      readonly film: ShownFilm;
      /** Of a .png. */
      readonly exposure: number;
      readonly toneMapping: Scene['render']['toneMapping'];
    }
  | {
      readonly as: 'glb' | 'mitsuba';
      readonly name: string;
      readonly scene: Scene;
      /** For Mitsuba. */
      readonly time: number;
      readonly width: number;
      readonly height: number;
    };

export interface Written {
  /** Its ending, such as ".png". */
  readonly ending: string;
  readonly blob: Blob;
  /** What the format lacks. */
  readonly report: readonly ExportEntry[];
}

/** What the worker posts; what is written or failed is the last. `share` of the work that is done, 0 … 1. */
export type SavingMessage = { readonly share: number } | { readonly written: Written } | { readonly failed: string };
