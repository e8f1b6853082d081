import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Page } from '@playwright/test';
import { encode } from 'fast-png';
import { build } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { lazyParts } from '../../scripts/lazy-parts.mjs';
import { root } from '../documents/documents.ts';
import { triangleFile } from '../fixtures/gltf.ts';
import { expect, test } from './fixtures.ts';

const models = `${root}tests/fixtures/models/`;
const base64 = (name: string): string => readFileSync(`${models}${name}`).toString('base64');

type Importer = { importGltf: typeof import('../../packages/renderer/src/gltf/index.ts').importGltf };

/** A page of one file that can read models, opened without a server, as the studio may be. */
async function openPage(page: Page, folder: string): Promise<void> {
  mkdirSync(folder, { recursive: true });
  const gltf = JSON.stringify(`${root}packages/renderer/src/gltf/index.ts`);
  writeFileSync(join(folder, 'main.ts'), `import { importGltf } from ${gltf};\nObject.assign(window, { importGltf });`);
  writeFileSync(join(folder, 'index.html'), '<html><body><script type="module" src="/main.ts"></script></body></html>');
  await build({
    configFile: false,
    root: folder,
    logLevel: 'error',
    plugins: [viteSingleFile({ removeViteModuleLoader: true }), lazyParts('page')],
    build: { outDir: join(folder, 'dist'), target: 'es2022', modulePreload: false },
  });
  await page.goto(pathToFileURL(join(folder, 'dist/index.html')).href);
  await page.waitForFunction('window.importGltf');
}

test('a page from file:// unpacks the reading of models when it is asked for', async ({ page }, { outputDir }) => {
  await openPage(page, outputDir);
  for (const name of ['BoxDraco.gltf', 'BoxMeshopt.glb', 'SimpleSkin.gltf']) {
    const counts = await page.evaluate(
      async ([model, bin]) => {
        const bytes = (text: string) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
        const { importGltf } = window as unknown as Importer;
        const result = await importGltf(bytes(model!), { readFile: async () => bytes(bin!) });
        return result.ok ? result.report.counts.triangles : result.problems;
      },
      [base64(name), base64('0.bin')],
    );
    expect(counts, name).toBe(name === 'SimpleSkin.gltf' ? 8 : 12);
  }
});

test('a part is run once for all who ask at a time, and collected when nobody uses it', async ({ page }, {
  outputDir,
}) => {
  await openPage(page, outputDir);
  const session = await page.context().newCDPSession(page);
  const runsForTwo = () =>
    page.evaluate(async (model) => {
      const { createObjectURL } = URL;
      let runs = 0;
      URL.createObjectURL = (code) => {
        runs++;
        return createObjectURL(code);
      };
      const bytes = Uint8Array.from(atob(model), (letter) => letter.charCodeAt(0));
      const { importGltf } = window as unknown as Importer;
      const results = await Promise.all([importGltf(bytes), importGltf(bytes)]);
      URL.createObjectURL = createObjectURL;
      return results.every(({ ok }) => ok) ? runs : Number.NaN;
    }, Buffer.from(triangleFile().glb()).toString('base64'));
  expect(await runsForTwo()).toBe(1);
  await session.send('HeapProfiler.collectGarbage');
  expect(await runsForTwo()).toBe(1);
});

/** A textured triangle whose image has these bytes. */
const textured = (image: Uint8Array): string =>
  Buffer.from(
    triangleFile((file) => {
      file.add('images', { name: 'picture', bufferView: file.view(image) });
      file.add('textures', { source: 0 });
      const primitive = file.json.meshes[0].primitives[0];
      primitive.material = file.add('materials', { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } });
      primitive.attributes.TEXCOORD_0 = file.floats('VEC2', 0, 0, 1, 0, 0, 1);
    }).glb(),
  ).toString('base64');

test('a browser gives the pixels of images as they are, also under transparent ones', async ({ page }, {
  outputDir,
}) => {
  await openPage(page, outputDir);
  const data = Uint8Array.of(200, 100, 50, 0, 10, 20, 30, 1, 255, 128, 0, 128, 1, 2, 3, 255);
  const opaque = Uint8Array.of(9, 8, 7, 250, 251, 252, 1, 128, 200, 60, 61, 62);
  const ktx = readFileSync(`${root}tests/fixtures/images/uastc-alpha.ktx2`);
  const files = [encode({ width: 2, height: 2, data, channels: 4 }), encode({ width: 2, height: 2, data: opaque, channels: 3 }), ktx]; // biome-ignore format: short
  const [alpha, plain, blocks] = await Promise.all(
    files.map((file) =>
      page.evaluate(async (model) => {
        const bytes = Uint8Array.from(atob(model), (letter) => letter.charCodeAt(0));
        const result = await (window as unknown as Importer).importGltf(bytes);
        return result.ok ? [...result.scene.images!.picture!.data!.rgba] : [JSON.stringify(result.problems)];
      }, textured(file)),
    ),
  );
  expect(alpha).toEqual([...data]);
  expect(plain!.filter((_, i) => i % 4 !== 3)).toEqual([...opaque]);
  expect(blocks).toHaveLength(16 * 8 * 4);
});
