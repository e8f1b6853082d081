/** Scenes in formats of other programs. */
export type { ExportEntry, ExportedScene } from './export-report.ts';
export { type MitsubaOptions, writeMitsuba } from './mitsuba/write-mitsuba.ts';
