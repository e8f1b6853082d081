/**
 * What a frame of moving meshes costs:
 *
 *     npm run bench:motion -- [--models FOLDER] [--gpu [--width 1280] [--rounds 10]] [--frames 300] [--write]
 *
 * On the CPU: from the time of the scene to the words that the device is given, beside a frame in which the same scene stands still. With
 * `--gpu`, on this machine's GPU through Dawn: whole frames a second of the model that plays, beside the same one that is drawn anew
 * without moving. `--models`: every .glb and .gltf file in the folder that moves, too. `--write` puts the tables into docs/motion.md.
 */
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { Session } from 'node:inspector/promises';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { GeometryBuffer } from '../../packages/renderer/src/geometry-buffer.ts';
import { importGltf } from '../../packages/renderer/src/gltf/index.ts';
import type { Device } from '../../packages/renderer/src/gpu/device.ts';
import { loadGeometryPacker } from '../../packages/renderer/src/packed-scene/geometry-packer.ts';
import { packPathScene } from '../../packages/renderer/src/packed-scene/pack-path-scene.ts';
import type { PackedScene } from '../../packages/renderer/src/packed-scene/pack-scene.ts';
import { hasDeformables } from '../../packages/renderer/src/scene/deform.ts';
import { triangleCount } from '../../packages/renderer/src/scene/mesh.ts';
import { Motion } from '../../packages/renderer/src/scene/motion.ts';
import { meshShapes } from '../../packages/renderer/src/scene/placed.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { arm, carousel, dough, swarm } from '../../tests/fixtures/motion.ts';
import { seededRandom } from '../../tests/fixtures/random.ts';
import { markdownTable, median } from '../statistics.mjs';
import { FRAME_COLUMNS, framesOnGpu } from './frames.ts';
import { instanceTrees, refittedTrees } from './trees.ts';

const { values } = parseArgs({
  options: {
    models: { type: 'string' },
    gpu: { type: 'boolean', default: false },
    frames: { type: 'string', default: '300' },
    width: { type: 'string', default: '1280' },
    rounds: { type: 'string', default: '30' },
    write: { type: 'boolean', default: false },
  },
});
const frames = Number(values.frames);
/** Longest that a scene plays before it is measured, milliseconds: engines take their time to compile. */
const WARM_UP = 3000;
/** Of the scene's time, seconds. */
const STEP = 1 / 60;
/** Rows that a device may have room for. */
const ROOM = 2 ** 26;

async function model(folder: string, name: string): Promise<Scene> {
  const readFile = async (file: string) => Uint8Array.from(readFileSync(join(folder, file)));
  const read = await importGltf(await readFile(name), { name, readFile });
  if (!read.ok) throw new Error(`${name}: ${read.problems.map(({ message }) => message).join('; ')}`);
  return read.scene;
}

const made: Readonly<Record<string, Scene>> = {
  '1,000 meshes on nodes': swarm(seededRandom(1), 1000),
  '1,000 instances of one shape': carousel(seededRandom(1), 1000),
  'skin, 12 k triangles': arm(100, 60),
  'morph targets, 12 k triangles': dough(100, 60),
  'skin, 120 k triangles': arm(1000, 60, 20),
};
const { models } = values;
const files = models === undefined ? [] : readdirSync(models).filter((file) => /\.(glb|gltf)$/i.test(file));
const scenes = new Map(Object.entries(made));
for (const file of files) scenes.set(file, await model(models!, file));

/** Counts what it is given. */
class Counter {
  bytes = 0;
  readonly device = {
    createData: (rows: number) => ({
      rows,
      write: (_row: number, words: Uint32Array) => {
        this.bytes += words.byteLength;
      },
      destroy: () => {},
    }),
  } as unknown as Device;
}

interface HeapNode {
  readonly selfSize: number;
  readonly children: readonly HeapNode[];
}
const sizeOf = ({ selfSize, children }: HeapNode): number =>
  children.reduce((sum, child) => sum + sizeOf(child), selfSize);

/** Bytes of the heap that `work` asks for, whether they are given back at once or not; an estimate from samples. */
async function allocatedBy(work: () => void): Promise<number> {
  const session = new Session();
  session.connect();
  await session.post('HeapProfiler.startSampling', { samplingInterval: 512, includeObjectsCollectedByMajorGC: true, includeObjectsCollectedByMinorGC: true } as object); // biome-ignore format: options
  work();
  const { profile } = await session.post('HeapProfiler.stopSampling');
  session.disconnect();
  return sizeOf(profile.head);
}

interface Cost {
  readonly shortest: number;
  readonly ms: number;
  readonly bytes: number;
  readonly allocated: number;
}

/** Of a frame: shortest, as other programs only ever make one longer, and median. `step`: seconds from frame to frame. */
async function cpuCost(scene: Scene, step: number, deviceRows = 0): Promise<Cost> {
  const motion = new Motion(scene);
  const counter = new Counter();
  const geometry = new GeometryBuffer(counter.device);
  const { eye } = motion.at(0).scene.camera;
  let packed: PackedScene | undefined;
  let poses = -1;
  let time = 0;
  const frame = () => {
    time += step;
    packed = packPathScene(motion.at(time), eye, { reuse: packed, deviceRows });
    geometry.hold(packed.geometry!);
    const { bending } = packed.geometry!;
    if (bending && bending.revision !== poses) counter.bytes += bending.poses.bytes.byteLength;
    poses = bending?.revision ?? -1;
  };
  const warmUntil = performance.now() + WARM_UP;
  for (let i = 0; i < 5 * frames && performance.now() < warmUntil; i++) frame();
  counter.bytes = 0;
  const few = 50;
  const allocated =
    (await allocatedBy(() => {
      for (let i = 0; i < few; i++) frame();
    })) / few;
  const bytes = counter.bytes / few;
  const times = Array.from({ length: frames }, () => {
    const start = performance.now();
    frame();
    return performance.now() - start;
  });
  return { shortest: Math.min(...times), ms: median(times), bytes, allocated };
}

const kilobytes = (bytes: number) => (bytes / 1000).toFixed(1);
const rows: string[][] = [];
for (const [name, scene] of scenes) {
  const shapes = meshShapes(scene).map(([, { mesh, instances }]) => [mesh, (instances?.length ?? 12) / 12] as const);
  const triangles = shapes.reduce((sum, [mesh, n]) => sum + n * triangleCount(scene.meshes![mesh]!.data!), 0);
  await loadGeometryPacker();
  const still = await cpuCost(scene, 0);
  const instances = shapes.reduce((sum, [, n]) => sum + n, 0);
  const ways = hasDeformables(scene) ? ['the device', 'the CPU'] : ['–'];
  for (const way of ways) {
    const moving = await cpuCost(scene, STEP, way === 'the device' ? ROOM : 0);
    const figures = [
      moving.shortest.toFixed(3),
      moving.ms.toFixed(3),
      still.ms.toFixed(3),
      kilobytes(moving.bytes),
      kilobytes(moving.allocated),
    ];
    rows.push([name, String(instances), String(triangles), way, ...figures]);
  }
}
const head = ['scene', 'instances', 'triangles', 'meshes bent by', 'frame that moves, shortest, ms', 'median', 'that stands still, median', 'kB given to the device', 'kB allocated']; // biome-ignore format: one row
const [{ model: processor } = { model: 'unknown' }, ...more] = cpus();
const reports = [
  `${new Date().toISOString().slice(0, 10)} · ${more.length + 1} × ${processor}, Node ${process.version} · ${frames} frames each`,
  markdownTable(head, rows),
  markdownTable(
    ['instances', 'good tree, ms', 'quick tree, ms', 'its cost / that of the good one'],
    [100, 1000, 10_000].map(instanceTrees),
  ),
  markdownTable(
    ['mesh', 'triangles', 'refitted tree, cost / one built anew: mean', 'worst'],
    [...scenes].flatMap(([name, scene]) => refittedTrees(name, scene)),
  ),
];

if (values.gpu) {
  const { description, rows } = await framesOnGpu(scenes, {
    width: Number(values.width),
    rounds: Number(values.rounds),
    step: STEP,
  });
  reports.push(description, markdownTable(FRAME_COLUMNS, rows));
}
const report = reports.join('\n\n');
console.log(report);

if (values.write) {
  const [start, end] = ['<!-- npm run bench:motion -- --write: start -->', '<!-- end -->'];
  const page = readFileSync('docs/motion.md', 'utf8');
  const [before, after] = [page.indexOf(start) + start.length, page.indexOf(end)];
  writeFileSync('docs/motion.md', `${page.slice(0, before)}\n\n${report}\n\n${page.slice(after)}`);
}
// Dawn keeps a process alive.
process.exit(0);
