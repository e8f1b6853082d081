/** What is seldom said, in Chinese: the list of keys, some notices, and what readers of files tell. It comes when it is asked for; until then it is in English. */
import { signal } from '@preact/signals';
import type { Problem, ReportEntry } from 'mirrorball';
import type * as Tables from './chinese-tables.ts';
import { en } from './en.ts';

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
export const seldom = (): typeof Tables.seldomInChinese => loaded()?.seldomInChinese ?? en;
