/** The files of a scene in another format, each made when it is asked for: a large scene needs memory for one of them at a time. */
import type { ExportEntry, ExportedScene } from './export-report.ts';

/** By name, what makes the bytes, in pieces that follow each other. Pieces may be arrays of the scene itself. */
export type PlannedFiles = Map<string, () => readonly Uint8Array[]>;

export interface ExportPlan {
  readonly files: Readonly<PlannedFiles>;
  readonly report: readonly ExportEntry[];
}

/** Told while files are made; `share` of the work that is done, 0 … 1. */
export type OnExportProgress = (share: number) => void;

export function carriedOut({ files, report }: ExportPlan): ExportedScene {
  return { files: Object.fromEntries([...files].map(([name, make]) => [name, joined(make())])), report };
}

export function joined(pieces: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(pieces.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}
