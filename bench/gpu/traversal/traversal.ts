/**
 * How fast this machine's GPU finds where rays meet a mesh, by the kernels' traverse.wesl and by three-mesh-bvh, over the same rays:
 *
 *     npm run bench:traversal -- [--triangles 70000,262000,1100000] [--write]
 *
 * Both must find the same; what differs is counted. `--write` puts the table into docs/benchmarks.md. dist/traversal.mjs is one file, as
 * dist/gpu.mjs is.
 */
import { parseArgs } from 'node:util';
import { dawnGpu } from '../../../packages/cli/src/backends/webgpu.ts';
import { writeTable } from '../write-table.ts';
import { ours } from './ours.ts';
import { peer } from './peer.ts';
import { type Hits, openDevice, Racer, race } from './race.ts';
import { cave, diffuseRays, primaryRays, RAYS } from './rays.ts';

const { values } = parseArgs({
  options: {
    triangles: { type: 'string', default: '70000,262000,1100000' },
    write: { type: 'boolean', default: false },
  },
});
/** Distances that differ by less, relatively, are the same: the other test of a triangle rounds otherwise. */
const SAME = 1e-3;

function differing(a: Hits, b: Hits): number {
  let count = 0;
  for (let i = 0; i < a.length; i += 2) if (Math.abs(a[i]! - b[i]!) > SAME * Math.min(a[i]!, b[i]!)) count++;
  return count;
}

const { device, description } = await openDevice(await dawnGpu());
console.log(description);
const rows: Record<string, unknown>[] = [];
for (const size of values.triangles.split(',').map(Number)) {
  const mesh = cave(size);
  const mine = ours(mesh);
  const racers = [await Racer.create(device, mine), await Racer.create(device, peer(mesh))];
  const primary = primaryRays();
  let rays = primary;
  for (const kind of ['primary', 'diffuse']) {
    const { times, hits } = await race(device, racers, rays);
    const [own, other] = times as [number, number];
    const speed = (ms: number) => (RAYS / ms / 1e6).toFixed(2);
    rows.push({
      triangles: mesh.indices.length / 3,
      'bytes a triangle': mine.bytesPerTriangle.toFixed(1),
      rays: kind,
      'Mirrorball, Grays/s': speed(own),
      'three-mesh-bvh, Grays/s': speed(other),
      ratio: (other / own).toFixed(2),
      'hits that differ': `${((100 * differing(hits[0]!, hits[1]!)) / RAYS).toFixed(4)} %`,
    });
    console.log(rows.at(-1));
    rays = diffuseRays(primary, hits[0]!, mesh, mine.order);
  }
  for (const racer of racers) racer.destroy();
}
console.table(rows);
if (values.write) writeTable('bench:traversal', `${description} · ${RAYS / 1e6} million rays`, rows);
process.exit(0);
