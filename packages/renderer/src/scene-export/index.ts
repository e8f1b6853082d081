/** Scenes in formats of other programs. */
export type { ExportEntry, ExportedScene } from './export-report.ts';
export { type GlbOptions, writeGlb } from './glb/write-glb.ts';
export { type MitsubaOptions, writeMitsuba } from './mitsuba/write-mitsuba.ts';
export { zipped } from './zipped.ts';
