/** What readers of files tell, in Chinese. The tables for it come when there is something to tell; until then it is in English. */
import { signal } from '@preact/signals';
import type { Problem, ReportEntry } from 'mirrorball';
import type * as Tables from './chinese-tables.ts';

const tables = signal<typeof Tables | null>(null);

async function load(): Promise<void> {
  tables.value = await import('./chinese-tables.ts');
}

/** Called while something is drawn, it draws that again when the tables are there. */
function loaded(): typeof Tables | null {
  if (tables.value === null) void load();
  return tables.value;
}

export const problemText = (problem: Problem): string => loaded()?.problemInChinese(problem) ?? problem.message;
export const reportText = (entry: ReportEntry): string => loaded()?.reportInChinese(entry) ?? entry.message;
