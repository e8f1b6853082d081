/** What readers of files tell, in Chinese. The tables for it come when there is something to tell; until then it is in English. */
import { signal } from '@preact/signals';
import type { Problem, ReportEntry } from 'mirrorball';
import type * as Tables from './chinese-tables.ts';

const tables = signal<typeof Tables | null>(null);
let loading: Promise<void> | null = null;

/** Called while something is drawn, it draws that again when the tables are there. */
function loaded(): typeof Tables | null {
  if (tables.value === null)
    loading ??= import('./chinese-tables.ts').then((module) => {
      tables.value = module;
    });
  return tables.value;
}

export const problemText = (problem: Problem): string => loaded()?.problemInChinese(problem) ?? problem.message;
export const reportText = (entry: ReportEntry): string => loaded()?.reportInChinese(entry) ?? entry.message;
