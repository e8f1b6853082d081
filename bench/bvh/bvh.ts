/**
 * How fast trees are built, and how good they are, beside three-mesh-bvh in the same run: `npm run bench:bvh -- [--rounds 7]
 * [--write]`. Everything is timed in turn, round after round, by the time that processors spend on it, and the shortest of each counts:
 * other programs only ever make one longer. Both trees' costs come from the same function over the same rule for leaves.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { parseArgs } from 'node:util';
import { buildBvh } from '../../packages/renderer/src/bvh/build-bvh.ts';
import { sahCost, type TriangleMesh } from '../../packages/renderer/src/bvh/bvh.ts';
import { InstanceTree } from '../../packages/renderer/src/bvh/instance-tree.ts';
import { planRefit, refit } from '../../packages/renderer/src/bvh/refit.ts';
import { bumpySphere, landscape, shuffled, soup } from '../../tests/fixtures/meshes.ts';
import { seededRandom } from '../../tests/fixtures/random.ts';
import { markdownTable } from '../statistics.mjs';
import { buildPeer, neutral, peerGeometry } from './peer.ts';

const { values } = parseArgs({
  options: { rounds: { type: 'string', default: '7' }, write: { type: 'boolean', default: false } },
});
const rounds = Number(values.rounds);

const meshes: Readonly<Record<string, () => TriangleMesh>> = {
  'sphere, 70 k': () => bumpySphere(seededRandom(1), 132),
  'sphere, 262 k': () => bumpySphere(seededRandom(1), 256),
  'landscape, 262 k': () => landscape(seededRandom(2), 362),
  'shuffled sphere, 262 k': () => shuffled(seededRandom(3), bumpySphere(seededRandom(1), 256)),
  'soup, 262 k': () => soup(seededRandom(4), 262_144),
  'landscape, 1.1 M': () => landscape(seededRandom(2), 742),
};
/** three-mesh-bvh's own default, then what suits GPUs, then as deep as costs allow. */
const LEAF_SIZES = [10, 4, 1];

/** Of this process, milliseconds: what waits for other programs takes none. */
function processorTime(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

/** Shortest time of each, milliseconds, taken in turn. `prepare` is not timed. */
function race(contestants: readonly { prepare?: () => unknown; run: (prepared: unknown) => unknown }[]): number[] {
  const best = contestants.map(() => Infinity);
  for (let round = 0; round < rounds; round++) {
    contestants.forEach(({ prepare, run }, k) => {
      const prepared = prepare?.();
      const start = processorTime();
      run(prepared);
      best[k] = Math.min(best[k]!, processorTime() - start);
    });
  }
  return best;
}

const speed = (triangles: number, ms: number) => (triangles / ms / 1000).toFixed(2);

function builders(name: string, mesh: TriangleMesh): string[][] {
  const count = mesh.indices.length / 3;
  return LEAF_SIZES.map((leafSize) => {
    const options = { leafSize, maxLeafSize: Math.max(4, leafSize) };
    const [peer, ours] = race([
      { prepare: () => peerGeometry(mesh), run: (geometry) => buildPeer(geometry as never, leafSize) },
      { run: () => buildBvh(mesh, options) },
    ]) as [number, number];
    const tree = buildBvh(mesh, options);
    const other = neutral(buildPeer(peerGeometry(mesh), leafSize), count);
    return [
      name,
      String(leafSize),
      speed(count, peer),
      speed(count, ours),
      (peer / ours).toFixed(2),
      sahCost(other).toFixed(2),
      sahCost(tree).toFixed(2),
      (sahCost(tree) / sahCost(other)).toFixed(4),
      `${other.depth}, ${tree.depth}`,
    ];
  });
}

function refitting(name: string, mesh: TriangleMesh): string[] {
  const count = mesh.indices.length / 3;
  const tree = buildBvh(mesh);
  const plan = planRefit(tree, mesh);
  const [fitted] = race([{ run: () => refit(tree, mesh.positions, plan) }]) as [number];
  return [name, speed(count, fitted)];
}

/** Boxes of many sizes in a world that moves a little each frame. Milliseconds of the best and the median frame. */
function instances(count: number): string[] {
  const random = seededRandom(5);
  const boxes = Float32Array.from({ length: 6 * count }, () => 0);
  const tree = new InstanceTree();
  const times: number[] = [];
  for (let frame = 0; frame < 300; frame++) {
    for (let i = 0; i < count; i++) {
      for (let axis = 0; axis < 3; axis++) {
        const [place, size] = [100 * random(), random() ** 4 * 10];
        boxes.set([place - size], 6 * i + axis);
        boxes.set([place + size], 6 * i + axis + 3);
      }
    }
    const start = performance.now();
    tree.build(boxes, count);
    times.push(performance.now() - start);
  }
  times.sort((a, b) => a - b);
  return [String(count), times[0]!.toFixed(3), times[150]!.toFixed(3)];
}

const rows: string[][] = [];
const rest: string[][] = [];
for (const [name, make] of Object.entries(meshes)) {
  const mesh = make();
  rows.push(...builders(name, mesh));
  rest.push(refitting(name, mesh));
  console.error(`${name} done`);
}
const versions = ['three', 'three-mesh-bvh'].map((name) => {
  const { version } = JSON.parse(readFileSync(`node_modules/${name}/package.json`, 'utf8'));
  return `${name} ${version}`;
});
const processors = cpus();
const report = [
  `${new Date().toISOString().slice(0, 10)} · ${processors.length} × ${processors[0]?.model}, Node ${process.version} · ${versions.join(', ')} · shortest of ${rounds}`,
  markdownTable(
    ['mesh', 'leaf size', 'three-mesh-bvh, Mtri/s', 'ours, Mtri/s', 'ratio', 'its cost', 'our cost', 'ratio', 'depths'],
    rows,
  ),
  markdownTable(['mesh', 'refit, Mtri/s'], rest),
  markdownTable(['instances', 'shortest, ms', 'median, ms'], [100, 1000, 10_000].map(instances)),
].join('\n\n');
console.log(report);

if (values.write) {
  const [start, end] = ['<!-- npm run bench:bvh -- --write: start -->', '<!-- end -->'];
  const page = readFileSync('docs/bvh.md', 'utf8');
  const [before, after] = [page.indexOf(start) + start.length, page.indexOf(end)];
  writeFileSync('docs/bvh.md', `${page.slice(0, before)}\n\n${report}\n\n${page.slice(after)}`);
}
