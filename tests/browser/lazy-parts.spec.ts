import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { lazyParts } from '../../scripts/lazy-parts.mjs';
import { root } from '../documents/documents.ts';
import { expect, test } from './fixtures.ts';

const models = `${root}tests/fixtures/models/`;
const base64 = (name: string): string => readFileSync(`${models}${name}`).toString('base64');

/** What a page of one file does with models, opened without a server, as the studio may be. */
test('a page from file:// unpacks the reading of models when it is asked for', async ({ page }, { outputDir }) => {
  mkdirSync(outputDir, { recursive: true });
  writeFileSync(
    join(outputDir, 'main.ts'),
    `import { importGltf } from ${JSON.stringify(`${root}packages/renderer/src/gltf/index.ts`)};\nObject.assign(window, { importGltf });`,
  );
  writeFileSync(
    join(outputDir, 'index.html'),
    '<html><body><script type="module" src="/main.ts"></script></body></html>',
  );
  await build({
    configFile: false,
    root: outputDir,
    logLevel: 'error',
    plugins: [viteSingleFile({ removeViteModuleLoader: true }), lazyParts('text')],
    build: { outDir: join(outputDir, 'dist'), target: 'es2022', modulePreload: false },
  });
  await page.goto(pathToFileURL(join(outputDir, 'dist/index.html')).href);
  await page.waitForFunction('window.importGltf');
  for (const name of ['BoxDraco.gltf', 'BoxMeshopt.glb', 'SimpleSkin.gltf']) {
    const counts = await page.evaluate(
      async ([model, bin]) => {
        const bytes = (text: string) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
        const { importGltf } = window as unknown as {
          importGltf: typeof import('../../packages/renderer/src/gltf/index.ts').importGltf;
        };
        const result = await importGltf(bytes(model!), { readFile: async () => bytes(bin!) });
        return result.ok ? result.report.counts.triangles : result.problems;
      },
      [base64(name), base64('0.bin')],
    );
    expect(counts, name).toBe(name === 'SimpleSkin.gltf' ? 8 : 12);
  }
});
