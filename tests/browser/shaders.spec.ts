import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from './fixtures.ts';

const FOLDERS = ['../../packages/renderer/src/shading/generated', './harness/generated'];
const filesEnding = (ending: string) =>
  FOLDERS.flatMap((folder) => readdirSync(fileURLToPath(new URL(folder, import.meta.url))))
    .filter((name) => name.endsWith(ending))
    .sort();

test('every generated shader compiles without a word, in WebGL2 and in WebGPU', async ({ harness }) => {
  const said = await harness.evaluate(() => window.harness.compileAll());
  for (const language of ['wgsl', 'glsl'] as const) {
    const names = filesEnding(`.${language}`);
    expect(Object.keys(said[language]).sort(), `all ${language} files are compiled`).toEqual(names);
    for (const name of names) expect.soft(said[language][name], name).toBe('');
  }
});
