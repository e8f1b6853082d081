import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { inflateSync } from 'node:zlib';
import { build } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { afterAll, expect, test } from 'vitest';
import type { importGltf } from '../packages/renderer/src/gltf/index.ts';
import { lazyParts, PARTS_START } from './lazy-parts.mjs';

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
    plugins: [viteSingleFile({ removeViteModuleLoader: true }), lazyParts('text')],
    build: { outDir: join(root, 'dist'), target: 'es2022', modulePreload: false },
  });
  return readFileSync(join(root, 'dist/index.html'), 'utf8');
}

test('in a page the parts are text behind the script, which does not wait for them', async () => {
  const page = await buildPage('page', `import { importGltf } from ${JSON.stringify(gltf)};\nconsole.log(importGltf);`);
  const start = page.slice(0, page.indexOf(PARTS_START));
  expect(start.length).toBeLessThan(60_000);
  expect(start).not.toContain('property-graph');
  expect(start).toMatch(/<p id="first"><\/p>\s*<script type="module" async/);
  const parts = [...page.matchAll(/<script type="text\/plain" id="part-(\w+)">([^<]*)<\/script>/g)];
  expect(parts.map(([, name]) => name).sort()).toEqual(['draco', 'gltf', 'ktx2', 'meshopt', 'tangents']);
  for (const [, , text] of parts) expect(inflateSync(Buffer.from(text!, 'base64')).toString()).toMatch(/export\s*\{/);
});

test('a page that reads no models has no parts and stays as it was', async () => {
  const page = await buildPage('bare', `import ${JSON.stringify(gltf)};\nconsole.log(1);`);
  expect(page).not.toContain(PARTS_START);
  expect(page).not.toContain('part-');
  expect(page).not.toContain('type="module" async');
});

test('a library finds them in files beside it', async () => {
  await build({
    configFile: false,
    root: folder,
    logLevel: 'error',
    plugins: [lazyParts('file')],
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
