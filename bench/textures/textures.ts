/**
 * What a level of detail for textures could win at most: `npm run bench:textures -- [--width 1280] [--write]`, on this machine's GPU through
 * Dawn. A plain of 400 m is seen from the height of a person, its texture repeated every metre, so that nearly all of it is smaller than
 * a pixel. Images of more and more texels stand beside one of a single texel, their mean: no choice of levels can be faster to look up, or
 * less noisy.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { dawnGpu } from '../../packages/cli/src/backends/webgpu.ts';
import { FrameController } from '../../packages/renderer/src/frame-controller.ts';
import { DEFAULT_SETTINGS, openWebGpu, raysPerPixel } from '../../packages/renderer/src/headless/index.ts';
import { Motion } from '../../packages/renderer/src/scene/motion.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { Stages } from '../../packages/renderer/src/stages.ts';
import { seededRandom } from '../../tests/fixtures/random.ts';
import { testMaterial, testScene } from '../../tests/fixtures/scenes.ts';
import { markdownTable } from '../statistics.mjs';

const { values } = parseArgs({
  options: {
    width: { type: 'string', default: '1280' },
    largest: { type: 'string', default: '8192' },
    reference: { type: 'string', default: '4096' },
    write: { type: 'boolean', default: false },
  },
});
const width = Number(values.width);
const height = Math.round((width * 9) / 16);
const SIDES = [1, 64, 1024, 2048, 4096, 8192].filter((side) => side <= Number(values.largest));
/** Samples of a picture that is judged. */
const COUNTS = [1, 16, 64];
const AT_ONCE = 64;

/** Bytes of any size, each texel its own; the mean where there is but one texel. */
function noise(side: number): Uint8Array {
  const random = seededRandom(3);
  return Uint8Array.from({ length: 4 * side * side }, (_, i) =>
    i % 4 === 3 ? 255 : side === 1 ? 188 : 256 * random(),
  );
}

function plain(side: number): Scene {
  const far = 200;
  const positions = Float32Array.of(-far, 0, far, far, 0, far, far, 0, -far, -far, 0, -far);
  const uvs = [positions.filter((_, i) => i % 3 !== 1)];
  const mesh = { positions, indices: Uint32Array.of(0, 1, 2, 0, 2, 3), uvs };
  const none = [0, 0, 0] as const;
  const shape = {
    type: 'mesh',
    mesh: 'plain',
    material: 'ground',
    translation: none,
    rotation: none,
    scale: [1, 1, 1],
  } as const;
  const scene = testScene(
    { plain: shape },
    {},
    {
      sky: { horizon: [1, 1, 1], zenith: [1, 1, 1] },
      materials: { ground: testMaterial({ baseColor: [0.8, 0.8, 0.8], baseColorTexture: { texture: 'noise' } }) },
      meshes: { plain: { data: mesh } },
      images: { noise: { data: { width: side, height: side, rgba: noise(side) } } },
      textures: { noise: { image: 'noise' } },
    },
  );
  const camera = { ...scene.camera, eye: [0, 1.7, 0] as const, target: [0, 0, -6] as const };
  return { ...scene, camera, render: { ...scene.render, integrator: 'path', maxDepth: 2 } };
}

/** Mean of (a − r)² / (r² + 0.01), as in docs/benchmarks.md, of what is no sky. */
function relativeError(a: Float32Array, r: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < r.length; i++) if (i % 4 !== 3) sum += (a[i]! - r[i]!) ** 2 / (r[i]! ** 2 + 0.01);
  return sum / ((r.length * 3) / 4);
}

async function measure(stages: Stages, side: number): Promise<string[]> {
  const scene = plain(side);
  const moment = new Motion(scene).at(0);
  const settings = { ...DEFAULT_SETTINGS, ...scene.render };
  const shot = { ...moment, camera: scene.camera, settings, raysPerPixel: raysPerPixel(scene, settings) };
  const controller = new FrameController();
  controller.watched = false;
  await stages.ready(shot);
  stages.film.reserve(width, height, stages.layersFor(shot));
  const add = async (count: number) => {
    // A software rasteriser draws, one sample a call.
    const each = stages.addsMany ? count : 1;
    for (let n = 0; n < count; n += each) await stages.addSamples(each, controller, () => {}, () => false); // biome-ignore format: one call
  };
  stages.begin(shot, width, height);
  let shortest = Infinity;
  for (let samples = 0; samples < Number(values.reference); samples += AT_ONCE) {
    const start = performance.now();
    await add(AT_ONCE);
    shortest = Math.min(shortest, performance.now() - start);
  }
  const reference = await stages.film.read();
  const errors: string[] = [];
  for (const count of COUNTS) {
    stages.begin({ ...shot, settings: { ...settings, seed: 1 } }, width, height);
    await add(count);
    errors.push(relativeError(await stages.film.read(), reference).toExponential(2));
  }
  const speed = (width * height * AT_ONCE) / shortest / 1000;
  return [`${side} × ${side}`, ((4 * side * side) / 1e6).toFixed(1), speed.toFixed(0), ...errors];
}

const device = await openWebGpu(null, { gpu: await dawnGpu() });
const stages = await Stages.open(device, 'exact');
const rows: string[][] = [];
for (const side of SIDES) rows.push(await measure(stages, side));
const head = ['image', 'MB', 'Msamples/s', ...COUNTS.map((count) => `relMSE, ${count}`)];
const report = `${new Date().toISOString().slice(0, 10)} · ${device.description} · ${width} × ${height}\n\n${markdownTable(head, rows)}`;
console.log(report);
if (values.write) {
  const [start, end] = ['<!-- npm run bench:textures -- --write: start -->', '<!-- end -->'];
  const page = readFileSync('docs/benchmarks.md', 'utf8');
  const from = page.indexOf(start) + start.length;
  writeFileSync('docs/benchmarks.md', `${page.slice(0, from)}\n\n${report}\n\n${page.slice(page.indexOf(end, from))}`);
}
// Dawn keeps a process alive.
process.exit(0);
