/** Meshes bent by one device: what it is told of them once, and of each pose. The geometry stays where it is and is written over there. */
import type { Compute, DataBuffer, Device, Kernels, Work } from './gpu/device.ts';
import type { Bending } from './packed-scene/bending.ts';
import { MANY_THREADS } from './packed-scene/bent-layout.ts';
import bendWgsl from './shading/generated/bend.wgsl?raw';

/** Threads of the workgroups that do all of a mesh: what devices have, the most first. */
const THREADS = [1024, 512, MANY_THREADS];
const ENTRIES = ['bendMesh', 'bendVertices', 'fitLeaves', 'fitLevel', 'fitLevels', 'weighTree'];
/** Poses from one weighing of the trees to the next: they are slow to become bad ones, and the answer takes some frames. */
const WEIGHED_EVERY = 64;

/** What the device holds for some meshes. */
interface Held {
  readonly bending: Bending;
  readonly geometry: DataBuffer;
  readonly poses: DataBuffer;
  readonly places: DataBuffer;
  readonly bend: Work;
  readonly weigh: Work;
  readonly all: readonly { destroy(): void }[];
  /** Of the poses that it has. */
  revision: number;
  untilWeighed: number;
}

export class Bender {
  readonly #device: Device;
  readonly #compute: Compute;
  readonly #kernels: Kernels;
  #held: Held | null = null;

  /** Rejects with `DeviceError` when the device cannot. */
  static async create(device: Device, compute: Compute): Promise<Bender> {
    const kernelsOf = (manyThreads: number) =>
      compute.createKernels({
        label: 'bend',
        wgsl: bendWgsl,
        entries: ENTRIES,
        constants: { manyThreads },
        data: ['write', 'read', 'read', 'write'],
      });
    const most = THREADS.find((threads) => threads <= compute.maxThreads) ?? MANY_THREADS;
    // Some drivers have fewer for a kernel than they say for all.
    const kernels = await kernelsOf(most).catch(() => kernelsOf(MANY_THREADS));
    return new Bender(device, compute, kernels);
  }

  private constructor(device: Device, compute: Compute, kernels: Kernels) {
    this.#device = device;
    this.#compute = compute;
    this.#kernels = kernels;
  }

  /** Bends the meshes in `geometry` before it is read next. `rewritten`: it has just been given their forms at rest again. */
  hold(bending: Bending, geometry: DataBuffer, rewritten: boolean): void {
    if (this.#held?.bending !== bending || this.#held.geometry !== geometry) {
      this.release();
      this.#held = this.#take(bending, geometry);
    }
    const held = this.#held;
    if (held.revision !== bending.revision) held.poses.write(0, bending.poses.u32);
    else if (!rewritten) return;
    held.revision = bending.revision;
    this.#compute.run(held.bend);
    if (--held.untilWeighed === 0) void this.#weighFor(held);
  }

  #take(bending: Bending, geometry: DataBuffer): Held {
    const { planRows, parts, placeRows, poses } = bending;
    const data = [planRows, poses.u32.length / 4, placeRows].map((rows) =>
      this.#device.createData(rows, 'bent meshes'),
    );
    const [plan, pose, places] = data as [DataBuffer, DataBuffer, DataBuffer];
    for (const { row, words } of parts) plan.write(row, words);
    const inputs = [geometry, plan, pose, places];
    const bend = this.#compute.prepare(this.#kernels, inputs, bending.steps);
    const weigh = this.#compute.prepare(this.#kernels, inputs, [bending.weighing]);
    const all = [bend, weigh, ...data];
    return { bending, geometry, poses: pose, places, bend, weigh, all, revision: -1, untilWeighed: WEIGHED_EVERY };
  }

  /** What the trees cost in the present pose, one after the other; null: nothing is held, or the device is lost, which is heard of elsewhere. */
  async weigh(): Promise<Float32Array | null> {
    const held = this.#held;
    if (!held) return null;
    const { bending, places, weigh } = held;
    this.#compute.run(weigh);
    const rows = bending.placeRows - bending.costRow;
    const words = await this.#compute.read(places, bending.costRow, rows).catch(() => null);
    return words && new Float32Array(words.buffer);
  }

  async #weighFor(held: Held): Promise<void> {
    const costs = await this.weigh();
    if (costs) held.bending.weighed(costs);
    held.untilWeighed = WEIGHED_EVERY;
  }

  /** Gives the memory back. */
  release(): void {
    for (const one of this.#held?.all ?? []) one.destroy();
    this.#held = null;
  }
}
