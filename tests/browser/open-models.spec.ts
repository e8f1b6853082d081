import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { decode } from 'fast-png';
import { unzipSync, zipSync } from 'fflate';
import { readExr } from '../../packages/renderer/src/export/exr.ts';
import { fromInterleaved } from '../../packages/renderer/src/export/float-picture.ts';
import { writeHdr } from '../../packages/renderer/src/export/hdr.ts';
import { importGltf } from '../../packages/renderer/src/gltf/index.ts';
import { writePly } from '../../packages/renderer/src/mesh-file/ply/write-ply.ts';
import { triangleFile } from '../fixtures/gltf.ts';
import { cubeMesh } from '../fixtures/meshes/solids.ts';
import { landscape } from '../fixtures/meshes.ts';
import { seededRandom } from '../fixtures/random.ts';
import { seriousProblems } from './axe.ts';
import { backends, expect, test } from './fixtures.ts';
import { coarse, expectPicture, fewSamples, lookAtPicture, rendererState, soon } from './studio.ts';

test.use({ viewport: { width: 960, height: 640 } });

type Content = string | Uint8Array;
type Files = Readonly<Record<string, Content>>;

const models = fileURLToPath(new URL('../fixtures/models/', import.meta.url));
const fixture = (name: string): Uint8Array => readFileSync(`${models}${name}`);
const image = (name: string): Uint8Array => readFileSync(`${models}../images/${name}`);
const text = (content: string) => new TextEncoder().encode(content);

const triangleGlb = () => triangleFile().glb();
/** Numbers beside it, under a name that is escaped and in other letters. */
function gltfFiles(): Files {
  const file = triangleFile();
  file.json.buffers = [{ byteLength: file.buffer.length, uri: 'Data/my%20numbers.bin' }];
  return { 'thing.gltf': JSON.stringify(file.json), 'data/My numbers.bin': file.buffer };
}
/** A textured triangle with this image. */
const textured = (image: Uint8Array): Uint8Array =>
  triangleFile((file) => {
    file.add('images', { name: 'picture', bufferView: file.view(image) });
    file.add('textures', { source: 0 });
    const primitive = file.json.meshes[0].primitives[0];
    primitive.material = file.add('materials', { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } });
    primitive.attributes.TEXCOORD_0 = file.floats('VEC2', 0, 0, 1, 0, 0, 1);
  }).glb();
const OBJ = 'mtllib thing.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n';
const STL =
  'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n';
const SCENE = JSON.stringify({
  version: 1,
  name: 'Cube beside',
  camera: { eye: [0, 1, 4], target: [0, 0, 0] },
  sky: [1, 1, 1],
  materials: { grey: {} },
  meshes: { cube: { file: 'cube.ply' } },
  shapes: { cube: { type: 'mesh', mesh: 'cube', material: 'grey' } },
  render: { integrator: 'path' },
});

/** Drops them as files, as a browser does: without their folders. */
async function drop(page: Page, files: Files): Promise<void> {
  const given = Object.entries(files).map(([path, content]) => ({
    name: path.split('/').at(-1)!,
    base64: Buffer.from(typeof content === 'string' ? text(content) : content).toString('base64'),
  }));
  await page.evaluate((all) => {
    const dataTransfer = new DataTransfer();
    for (const { name, base64 } of all) {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      dataTransfer.items.add(new File([bytes], name));
    }
    dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true }));
  }, given);
}

const scene = (page: Page) => page.evaluate(() => window.mirrorball.renderer?.scene?.name);
const fact = (page: Page, name: string) => page.locator('#model-facts div').filter({ hasText: name }).locator('dd');

/** Waits until the model is the scene on show, and makes one sample all of its picture. */
async function shown(page: Page, name: string): Promise<void> {
  await soon(() => scene(page), `${name} is the scene`).toBe(name);
  await page.evaluate(() => window.mirrorball.renderer!.set({ maxSamples: 1 }));
}

/** Waits for the path tracer's picture. */
const traced = (page: Page) =>
  page.waitForFunction(() => {
    const { renderer } = window.mirrorball;
    return renderer && !renderer.compiling && renderer.stats.samples > 0;
  });

for (const backend of backends)
  test(`every kind of file is opened, framed and traced (${backend})`, async ({ page, openStudio }) => {
    test.setTimeout(240_000);
    await openStudio({ backend, query: { ...coarse, paused: 1 } });
    await fewSamples(page);
    await expectPicture(page);
    const kinds: readonly (readonly [string, Files, string, number])[] = [
      ['a model in one file', { 'one.glb': triangleGlb() }, 'one', 1],
      ['a model with its files', gltfFiles(), 'thing', 1],
      ['an archive', { 'packed.zip': zipSync({ deep: { 'in.gltf': text(gltfFiles()['thing.gltf'] as string), Data: { 'my numbers.bin': gltfFiles()['data/My numbers.bin'] as Uint8Array } } }) }, 'in', 1], // biome-ignore format: one row
      ['Draco', { 'BoxDraco.gltf': fixture('BoxDraco.gltf'), '0.bin': fixture('0.bin') }, 'BoxDraco', 12],
      ['meshoptimizer', { 'BoxMeshopt.glb': fixture('BoxMeshopt.glb') }, 'BoxMeshopt', 12],
      ['KTX2', { 'blocks.glb': textured(image('uastc-alpha.ktx2')) }, 'blocks', 1],
      ['JPEG', { 'photo.glb': textured(image('gradient-progressive.jpg')) }, 'photo', 1],
      ['PLY', { 'cube.ply': writePly(cubeMesh()) }, 'cube', 12],
      ['OBJ', { 'thing.obj': OBJ, 'thing.mtl': 'newmtl red\nKd 1 0 0\n' }, 'thing', 1],
      ['STL', { 'solid.stl': STL }, 'solid', 1],
      ['a scene file', { 'cube.scene.json': SCENE, 'cube.ply': writePly(cubeMesh()) }, 'Cube beside', 12],
    ];
    for (const [kind, files, name, triangles] of kinds)
      await test.step(kind, async () => {
        await drop(page, files);
        await shown(page, name);
        await expect(fact(page, 'Triangles')).toHaveText(String(triangles));
      });
    await traced(page);
    const look = await expectPicture(page);
    expect(look.colours, 'a cube under a white sky').toBeGreaterThan(8);
    await expect(page.locator('#compiling')).toBeHidden();
  });

test('a sketch shows the model before its program is compiled', async ({ page, openStudio }) => {
  await openStudio({ backend: 'webgl2', query: { ...coarse, paused: 1 } });
  await fewSamples(page);
  const before = await expectPicture(page);
  // The program never comes.
  await page.evaluate(() => {
    const device = (window.mirrorball.renderer as unknown as { device: { createPass(source: { label: string }): Promise<unknown> } }).device; // biome-ignore format: one cast
    const createPass = device.createPass.bind(device);
    device.createPass = (source) => (source.label === 'path' ? new Promise(() => {}) : createPass(source));
  });
  await drop(page, { 'land.ply': writePly(landscape(seededRandom(5), 120)) });
  await shown(page, 'land');
  await expect(page.locator('#compiling')).toContainText('sketch');
  await soon(async () => {
    const look = await lookAtPicture(page);
    return Math.max(...look.thumbnail.map((x, i) => Math.abs(x - before.thumbnail[i]!)));
  }, 'another picture').toBeGreaterThan(15);
  const first = await lookAtPicture(page);
  await page.evaluate(() => {
    const renderer = window.mirrorball.renderer!;
    renderer.camera = { ...renderer.camera, eye: [5, 30, 5.1] };
  });
  await soon(async () => {
    const look = await lookAtPicture(page);
    return Math.max(...look.thumbnail.map((x, i) => Math.abs(x - first.thumbnail[i]!)));
  }, 'it follows the view').toBeGreaterThan(5);
});

/** Bytes of JavaScript's heap and of the memory behind its arrays, and what there is on the device. */
async function memory(page: Page) {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  const { usedSize, backingStorageSize = 0 } = (await session.send('Runtime.getHeapUsage')) as { usedSize: number; backingStorageSize?: number }; // biome-ignore format: one cast
  await session.detach();
  const counts = await page.evaluate(() => ({
    ...(window.mirrorball.renderer as unknown as { device: { counts: { buffers: number; textures: number } } }).device.counts, // biome-ignore format: one cast
  }));
  return { bytes: usedSize + backingStorageSize, buffers: counts.buffers, textures: counts.textures };
}

test('broken files tell all that is wrong, the scene stays, and memory is back; also after a large model', async ({
  page,
  openStudio,
}) => {
  test.setTimeout(240_000);
  await openStudio({ backend: 'webgl2', query: { ...coarse, paused: 1 } });
  await fewSamples(page);
  await expectPicture(page);
  const bomb = zipSync({ 'a.glb': new Uint8Array(1000) });
  new DataView(bomb.buffer).setUint32(bomb.length - 22 - 46 - 5 + 24, 2 ** 30, true);
  const broken: readonly (readonly [Files, string | RegExp])[] = [
    [{ 'cut.glb': triangleGlb().slice(0, 400) }, 'cut off'],
    [{ 'noise.glb': new Uint8Array(5000).fill(0xff) }, 'noise.glb'],
    [{ 'alone.gltf': gltfFiles()['thing.gltf']! }, 'my numbers.bin'],
    [{ 'bomb.zip': bomb }, /are read|are unpacked/],
    [{ 'no.zip': 'PK' }, 'no zip archive'],
    [{ 'x.fbx': 'x' }, 'What can be opened is this'],
    [{ 'nan.ply': 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n' }, 'line'], // biome-ignore format: one row
    [{ 'claims.ply': 'ply\nformat ascii 1.0\nelement vertex 1000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n' }, 'claims.ply'], // biome-ignore format: one row
    [{ 'index.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' }, 'line 4'],
    [{ 'broken.json': '{' }, 'JSON'],
  ];
  const dialog = page.locator('#problems');
  const tryAll = async () => {
    for (const [files, message] of broken) {
      await drop(page, files);
      await expect(dialog, Object.keys(files)[0]!).toBeVisible();
      await expect(dialog).toContainText(message);
      await expect(dialog.getByRole('heading')).toContainText(Object.keys(files)[0]!);
      await page.keyboard.press('Escape');
      await expect(dialog).toBeHidden();
    }
  };
  // What opens and draws models is loaded once and stays.
  await drop(page, { 'one.glb': triangleGlb() });
  await shown(page, 'one');
  await traced(page);
  await page.getByRole('radio', { name: 'Cube room' }).check();
  await shown(page, 'Cube room');
  await tryAll();
  const start = await memory(page);
  const held = ({ buffers, textures }: typeof start) => buffers + textures;
  await tryAll();
  expect(await scene(page)).toBe('Cube room');
  await expectPicture(page);
  await soon(async () => held(await memory(page)), 'on the device').toBeLessThanOrEqual(held(start));
  const after = await memory(page);
  expect(after.bytes, 'in the page').toBeLessThan(start.bytes * 1.2);

  await test.step('a large model comes and goes', async () => {
    await page.evaluate(() => {
      // Nothing is to be traced: only what is held counts.
      window.mirrorball.renderer!.set({ maxSamples: 1 });
    });
    await drop(page, { 'land.ply': writePly(landscape(seededRandom(6), 300)) });
    await shown(page, 'land');
    await traced(page);
    const withModel = await memory(page);
    expect(withModel.bytes, 'it takes what it takes').toBeGreaterThan(start.bytes + 5e6);
    await page.getByRole('radio', { name: 'Cube room' }).check();
    await shown(page, 'Cube room');
    await traced(page);
    await soon(async () => (await memory(page)).bytes, 'bytes in the page').toBeLessThan(start.bytes * 1.2);
    await soon(async () => held(await memory(page)), 'on the device').toBeLessThanOrEqual(held(start));
  });
});

test('opening can be cancelled, and the page is alive meanwhile', async ({ page, openStudio }) => {
  await openStudio({ backend: 'webgl2', query: { ...coarse, paused: 1 } });
  await fewSamples(page);
  await expectPicture(page);
  const longest = await page.evaluate(async () => {
    // A text of 40 MB takes a second or more to read.
    const lines = 'v 0.125 0.25 0.5\nv 1.5 0 0\nv 0 1.25 0\nf -3 -2 -1\n'.repeat(700_000);
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([lines], 'large.obj'));
    dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true }));
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    let most = 0;
    for (let i = 0, before = performance.now(); i < 20; i++) {
      await frame();
      const now = performance.now();
      most = Math.max(most, now - before);
      before = now;
    }
    return most;
  });
  console.log(`  ${Math.round(longest)} ms between frames of the page while a file of 40 MB is read`);
  const card = page.locator('#opening');
  await expect(card).toContainText('large.obj');
  await card.getByRole('button', { name: 'Cancel' }).click();
  await expect(card).toBeHidden();
  expect(await scene(page)).toBe('Cube room');
  await expect(page.locator('#problems')).toBeHidden();
  // The next one is opened as ever.
  await drop(page, { 'one.glb': triangleGlb() });
  await shown(page, 'one');
});

test('from a file, a folder is opened, with nothing from the network; the panel has what a model offers', async ({
  page,
  openStudio,
}, testInfo) => {
  const { mkdirSync, writeFileSync } = await import('node:fs');
  const folder = testInfo.outputPath('fox');
  mkdirSync(`${folder}/data`, { recursive: true });
  const file = triangleFile((f) => {
    f.json.cameras = [{ name: 'close', type: 'perspective', perspective: { yfov: 0.5, znear: 0.1 } }];
    f.json.nodes.push({ name: 'eye', camera: 0, translation: [0, 0, 3] });
    f.json.scenes[0].nodes.push(1);
    const times = f.floats('SCALAR', 0, 2);
    const places = f.floats('VEC3', 0, 0, 0, 1, 0, 0);
    f.add('animations', { name: 'slide', channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }], samplers: [{ input: times, output: places }] }); // biome-ignore format: one animation
    f.json.extensionsUsed = ['VENDOR_unknown'];
  });
  file.json.buffers = [{ byteLength: file.buffer.length, uri: 'data/n.bin' }];
  writeFileSync(`${folder}/fox.gltf`, JSON.stringify(file.json));
  writeFileSync(`${folder}/data/n.bin`, file.buffer);
  const foreign: string[] = [];
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) foreign.push(request.url());
  });
  await openStudio({ origin: 'file', backend: 'webgpu', query: { ...coarse, paused: 1 } });
  await fewSamples(page);
  await expectPicture(page);
  await page.locator('#scene-folder').setInputFiles(folder);
  await shown(page, 'fox');
  expect(foreign).toEqual([]);

  await test.step('camera, animation, report', async () => {
    await page.getByLabel('Camera', { exact: true }).selectOption('close');
    await soon(async () => (await rendererState(page)).camera.verticalFov).toBeLessThan(29);
    await page.getByLabel('Camera', { exact: true }).selectOption('Everything in view');
    await soon(async () => (await rendererState(page)).camera.verticalFov).toBe(30);
    await expect(page.getByLabel('Animation', { exact: true })).toHaveValue('=slide');
    await page.keyboard.press('Escape');
    await page.getByLabel('Animation', { exact: true }).selectOption('None');
    await soon(() => page.evaluate(() => window.mirrorball.renderer!.scene!.clip ?? null)).toBeNull();
    await page.getByText('Import report: 1 note').click();
    await expect(page.locator('#import-report')).toContainText('VENDOR_unknown');
  });

  await test.step('the view is framed by key and button, on a floor', async () => {
    await page.locator('main canvas').first().focus();
    await page.keyboard.press('ArrowLeft', { delay: 150 });
    await page.keyboard.press('+', { delay: 400 });
    const distance = async () => {
      const { eye, target } = (await rendererState(page)).camera;
      return Math.hypot(eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]);
    };
    await soon(distance, 'the view has come closer').toBeLessThan(2.6);
    await page.keyboard.press('f');
    await soon(distance, 'and goes back').toBeGreaterThan(2.8);
    await page.getByRole('switch', { name: 'Floor' }).check();
    await soon(() => page.evaluate(() => Object.keys(window.mirrorball.renderer!.scene!.shapes))).toContain('ground');
    await page.getByRole('switch', { name: 'Floor' }).uncheck();
    await soon(() => page.evaluate(() => Object.keys(window.mirrorball.renderer!.scene!.shapes))).not.toContain(
      'ground',
    );
  });

  await test.step('light from all around: sky, studio, and a picture that is dropped', async () => {
    const sky = () =>
      page.evaluate(() => {
        const { map, scale, rotation } = window.mirrorball.renderer!.scene!.sky;
        return { width: map?.width, scale, rotation };
      });
    await page.getByLabel('Light from all around').selectOption('Plain sky');
    await soon(sky).toEqual({});
    await page.getByLabel('Light from all around').selectOption('Studio');
    await soon(async () => (await sky()).width).toBe(128);
    await drop(page, { 'room.hdr': writeHdr(fromInterleaved(4, 2, ['R', 'G', 'B'], new Array(24).fill(0.5))) });
    await soon(async () => (await sky()).width).toBe(4);
    await expect(page.getByLabel('Light from all around')).toHaveValue('file');
    await page.getByRole('slider', { name: 'Rotation' }).fill('90');
    await page.getByRole('slider', { name: 'Strength' }).fill('10');
    await soon(sky).toEqual({ width: 4, scale: 2, rotation: 90 });
    await drop(page, { 'broken.hdr': 'no picture' });
    await expect(page.locator('#problems')).toBeVisible();
    await expect(page.locator('#problems')).toContainText('broken.hdr');
    await page.keyboard.press('Escape');
    await expect(page.locator('#problems')).toBeHidden();
  });

  await test.step('the menu of methods says why there is one only', async () => {
    await expect(page.locator('#integrator')).toContainText('Classic ray tracing draws no triangles');
  });

  await test.step('picture and scene are saved as files', async () => {
    const saved = async (button: string) => {
      const download = page.waitForEvent('download');
      await page.getByRole('button', { name: button }).click();
      const file = await download;
      return [file.suggestedFilename(), readFileSync(await file.path())] as const;
    };
    await page.locator('#section-save summary').click();
    const [name, png] = await saved('Picture (.png)');
    const { width, height, data } = decode(png);
    const { stats } = await rendererState(page);
    // What the panel covers is not in it.
    const seen = Math.round((stats.filmWidth * (960 - 320)) / 960);
    expect([name, width, height]).toEqual(['fox.png', seen, stats.filmHeight]);
    expect(new Set(data).size, 'not of one colour').toBeGreaterThan(10);
    const [, exr] = await saved('Light as floats (.exr)');
    expect(readExr(exr)).toMatchObject({ width, height });
    const [glbName, glb] = await saved('Model (.glb)');
    const again = await importGltf(glb);
    expect([glbName, again.ok && again.report.counts.triangles]).toEqual(['fox.glb', 1]);
    await expect(page.locator('.notice')).toContainText('fox.glb is saved. What its format lacks');
    const [, archive] = await saved('For Mitsuba 3 (.zip)');
    expect(
      Object.keys(unzipSync(archive))
        .filter((file) => /^fox\.(xml|py)$/.test(file))
        .sort(),
    ).toEqual(['fox.py', 'fox.xml']);
  });

  await test.step('a folder from the disk is dropped', async () => {
    const before = await page.evaluateHandle(() => window.mirrorball.renderer!.scene);
    const client = await page.context().newCDPSession(page);
    const data = { items: [], files: [folder], dragOperationsMask: 1 };
    for (const type of ['dragEnter', 'dragOver', 'drop'] as const)
      await client.send('Input.dispatchDragEvent', { type, x: 200, y: 200, data });
    await soon(() => before.evaluate((old) => window.mirrorball.renderer!.scene !== old)).toBe(true);
    await shown(page, 'fox');
    // It stands in the light that was chosen for the one before.
    await soon(() => page.evaluate(() => window.mirrorball.renderer!.scene!.sky.map?.width)).toBe(4);
    await expect(page.getByLabel('Light from all around')).toHaveValue('file');
  });
});

test.describe('on a phone, in Chinese and in the dark', () => {
  test.use({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    locale: 'zh-CN',
    colorScheme: 'dark',
  });

  test('a model is opened, and everything about it fits', async ({ page, openStudio }) => {
    await openStudio({ backend: 'webgl2', query: { ...coarse, paused: 1 } });
    await fewSamples(page);
    await expectPicture(page);
    const room = writeHdr(fromInterleaved(4, 2, ['R', 'G', 'B'], new Array(24).fill(0.5)));
    await page.locator('#scene-file').setInputFiles([
      { name: '三角.glb', mimeType: '', buffer: Buffer.from(triangleGlb()) },
      { name: 'room.hdr', mimeType: '', buffer: Buffer.from(room) },
    ]);
    await shown(page, '三角');
    await page.locator('#panel-toggle').tap();
    await expect(page.getByRole('heading', { name: '模型' })).toBeVisible();
    await expect(page.locator('#environment-kind'), 'what came with the model lights it').toHaveValue('file');
    await page.getByRole('button', { name: '显示全部' }).scrollIntoViewIfNeeded();
    await expect(fact(page, '三角形')).toHaveText('1');
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(wide, 'nothing sticks out').toBeLessThanOrEqual(0);
    expect(await seriousProblems(page)).toEqual([]);
    await page.locator('#scene-file').setInputFiles({
      name: '缺.gltf',
      mimeType: '',
      buffer: Buffer.from(gltfFiles()['thing.gltf']!),
    });
    const dialog = page.getByRole('dialog', { name: '无法打开 缺.gltf' });
    await expect(dialog).toContainText(/还缺少它引用的以下文件.*my numbers\.bin/);
    expect(await seriousProblems(page), 'with the dialog open').toEqual([]);
  });
});

test('by keyboard alone', async ({ page, openStudio }) => {
  await openStudio({ backend: 'webgl2', query: { ...coarse, paused: 1 } });
  await fewSamples(page);
  await expectPicture(page);
  const button = page.getByRole('button', { name: 'Open files…' });
  // A page that is still at work may hear the key late.
  const chosen = async () => {
    const chooser = page.waitForEvent('filechooser', { timeout: 5000 });
    await button.press('Enter');
    return chooser;
  };
  const chooser = await chosen().catch(chosen);
  await chooser.setFiles({ name: 'x.fbx', mimeType: '', buffer: Buffer.from('x') });
  const dialog = page.getByRole('dialog', { name: 'x.fbx could not be opened' });
  await expect(dialog).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(dialog).toBeHidden();
});
