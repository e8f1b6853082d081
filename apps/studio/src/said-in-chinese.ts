/** What readers and writers of files tell, in Chinese. It comes with the first file; without it they stay in English. */
import { signal } from '@preact/signals';
import type { Problem, ReportEntry } from 'mirrorball';
import type { ExportEntry } from 'mirrorball/scene-export';
import type * as Tables from './chinese-tables.ts';

const tables = signal<typeof Tables | null>(null);

/** To be waited for before such a text is shown, so that nothing flashes up in English. Never rejects. */
export async function loadTables(): Promise<void> {
  try {
    tables.value ??= await import('./chinese-tables.ts');
  } catch {
    // It stays in English.
  }
}

/** Called while something is drawn, it draws that again when the tables are there. */
function loaded(): typeof Tables | null {
  if (tables.value === null) void loadTables();
  return tables.value;
}

export const problemText = (problem: Problem): string => loaded()?.problemInChinese(problem) ?? problem.message;
export const reportText = (entry: ReportEntry): string => loaded()?.reportInChinese(entry) ?? entry.message;
export const savedText = (entry: ExportEntry): string => loaded()?.savedInChinese(entry) ?? entry.message;
