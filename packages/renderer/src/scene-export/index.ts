/** Scenes in formats of other programs. */
export type { ExportPlan, OnExportProgress, PlannedFiles } from './export-plan.ts';
export type { ExportEntry, ExportedScene } from './export-report.ts';
export { type GlbOptions, planGlb, writeGlb } from './glb/write-glb.ts';
export { type MitsubaOptions, planMitsuba, writeMitsuba } from './mitsuba/write-mitsuba.ts';
export { zipped, zippedPlan } from './zipped.ts';
