/** A benchmark's table into docs/benchmarks.md, between the two marks of the command that made it. */
import { readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';

/** `command`: the npm script. Columns are those of all rows; the head, with today's date in front, says what was measured on. */
export function writeTable(command: string, head: string, rows: readonly Record<string, unknown>[]): void {
  const file = resolve('docs/benchmarks.md');
  const keys = [...new Set(rows.flatMap((row) => Object.keys(row)))];
  const line = (cells: readonly unknown[]) => `| ${cells.join(' | ')} |`;
  const table = [
    line(keys),
    line(keys.map(() => '---')),
    ...rows.map((row) => line(keys.map((key) => row[key] ?? ''))),
  ];
  const marked = new RegExp(`(<!-- npm run ${command} -- --write: start -->\\n)[\\s\\S]*?(<!-- end -->)`);
  const text = readFileSync(file, 'utf8');
  if (!marked.test(text)) throw new Error(`${file} has no place for the table.`);
  const dated = `${new Date().toISOString().slice(0, 10)} · ${head}`;
  writeFileSync(
    file,
    text.replace(marked, (_, start, end) => `${start}\n${dated}\n\n${table.join('\n')}\n\n${end}`),
  );
}
