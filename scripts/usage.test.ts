import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';

const run = (script: string, ...options: string[]) =>
  spawnSync(process.execPath, [fileURLToPath(new URL(script, import.meta.url)), ...options], { encoding: 'utf8' });

for (const [command, script] of [
  ['npm start', 'start.mjs'],
  ['npm run bench', '../bench/run.mjs'],
] as const) {
  test(`${command} -- --help tells how it is used`, () => {
    for (const option of ['--help', '-h']) {
      const { status, stdout, stderr } = run(script, option);
      expect([status, stderr]).toEqual([0, '']);
      // The first line can be typed as it stands: one "--", then the options.
      const [, example] = stdout.split('\n')[0]!.split('such as: ');
      expect(example).toMatch(new RegExp(`^${command} -- --(?!.* -- )`));
    }
  });

  test(`${command} refuses an option that there is not`, () => {
    const { status, stderr } = run(script, '--colour');
    expect(status).toBe(2);
    expect(stderr).toContain(`${command} -- `);
  });
}
