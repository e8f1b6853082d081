import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { runInNewContext } from 'node:vm';
import { build } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { afterAll, expect, test } from 'vitest';
import type { importGltf } from '../packages/renderer/src/gltf/index.ts';
import { lazyParts } from './lazy-parts.mjs';

const gltf = fileURLToPath(new URL('../packages/renderer/src/gltf/index.ts', import.meta.url));
const models = fileURLToPath(new URL('../tests/fixtures/models/', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'lazy-parts-'));
writeFileSync(join(folder, 'package.json'), '{ "type": "module" }');
afterAll(() => rmSync(folder, { recursive: true }));

async function buildPage(name: string, script: string): Promise<string> {
  const root = join(folder, name);
  mkdirSync(root);
  writeFileSync(join(root, 'main.ts'), script);
  writeFileSync(
    join(root, 'index.html'),
    '<html><body><p id="first"></p><script type="module" src="/main.ts"></script></body></html>',
  );
  await build({
    configFile: false,
    root,
    logLevel: 'error',
    plugins: [viteSingleFile({ removeViteModuleLoader: true }), lazyParts('page')],
    build: { outDir: join(root, 'dist'), target: 'es2022', modulePreload: false },
  });
  return readFileSync(join(root, 'dist/index.html'), 'utf8');
}

test('what a page may need later lies in classic scripts beside it', async () => {
  const page = await buildPage(
    'reader',
    `import { importGltf } from ${JSON.stringify(gltf)};\nconsole.log(importGltf);`,
  );
  expect(page.length).toBeLessThan(60_000);
  expect(page).not.toContain('property-graph');
  const names = ['draco', 'gltf', 'ktx2', 'meshopt', 'tangents'];
  const self: { mirrorballParts?: Record<string, string> } = {};
  for (const name of names)
    runInNewContext(readFileSync(join(folder, `reader/dist/mirrorball-${name}.js`), 'utf8'), { self });
  expect(Object.keys(self.mirrorballParts!).sort()).toEqual(names);
  const ran: { mirrorballPart?: object } = {};
  runInNewContext(self.mirrorballParts!.gltf!, ran);
  expect(Object.keys(ran.mirrorballPart!)).toEqual(['readGltf']);
});

test('a page that reads no models has no parts and stays as it was', async () => {
  const page = await buildPage('bare', `import ${JSON.stringify(gltf)};\nconsole.log(1);`);
  expect(page).not.toContain('mirrorballParts');
  expect(readdirSync(join(folder, 'bare/dist'))).toEqual(['index.html']);
});

test('a library finds them in files beside it', async () => {
  await build({
    configFile: false,
    root: folder,
    logLevel: 'error',
    plugins: [lazyParts('library')],
    build: {
      outDir: join(folder, 'library'),
      target: 'es2022',
      lib: { entry: gltf, formats: ['es'], fileName: 'mirrorball' },
    },
  });
  const library = join(folder, 'library/mirrorball.js');
  expect(readFileSync(library, 'utf8').length).toBeLessThan(100_000);
  const { importGltf: read } = (await import(/* @vite-ignore */ pathToFileURL(library).href)) as {
    importGltf: typeof importGltf;
  };
  for (const name of ['BoxDraco.gltf', 'BoxMeshopt.glb']) {
    const readFile = async (file: string) => Uint8Array.from(readFileSync(join(models, file)));
    const result = await read(await readFile(name), { readFile });
    expect(result.ok && result.report.counts).toMatchObject({ triangles: 12, vertices: 24 });
  }
});
