/** Programs that trace the same rays on one GPU, timed in turn. */

export interface Contestant {
  readonly name: string;
  /** With an entry `traceRays` of 64 threads a group and 4 rays a thread, which reads rays from binding 7 and writes hits to binding 8. */
  readonly wgsl: string;
  /** By binding. */
  readonly uniforms: Readonly<Record<number, Uint32Array<ArrayBuffer>>>;
  readonly buffers: Readonly<Record<number, Uint32Array<ArrayBuffer> | Float32Array<ArrayBuffer>>>;
}

/** Two numbers each: a distance, and the bits of a triangle's place. */
export type Hits = Float32Array<ArrayBuffer>;

/** Rays of a group. */
const GROUP = 256;
/** Groups in a row of a dispatch. */
const MOST_GROUPS = 16384;
/** Dispatches of one timing, and timings of which the shortest counts. */
const DISPATCHES = 4;
const ROUNDS = 6;
/** Work before anything is timed, milliseconds: an idle GPU takes its time to clock up. */
const WARM_UP = 500;

export async function openDevice(gpu: GPU): Promise<{ device: GPUDevice; description: string }> {
  const adapter = await gpu.requestAdapter({ powerPreference: 'high-performance' });
  if (!adapter) throw new Error('No GPU.');
  const { maxBufferSize, maxStorageBufferBindingSize } = adapter.limits;
  const device = await adapter.requestDevice({ requiredLimits: { maxBufferSize, maxStorageBufferBindingSize } });
  device.onuncapturederror = ({ error }) => {
    throw error;
  };
  return { device, description: adapter.info.description };
}

function upload(device: GPUDevice, data: Uint32Array<ArrayBuffer> | Float32Array<ArrayBuffer>, usage: number) {
  const buffer = device.createBuffer({ size: data.byteLength, usage: usage | GPUBufferUsage.COPY_DST });
  device.queue.writeBuffer(buffer, 0, data);
  return buffer;
}

export class Racer {
  readonly name: string;
  readonly #device: GPUDevice;
  readonly #pipeline: GPUComputePipeline;
  readonly #inputs: GPUBindGroupEntry[];

  private constructor(device: GPUDevice, name: string, pipeline: GPUComputePipeline, inputs: GPUBindGroupEntry[]) {
    this.name = name;
    this.#device = device;
    this.#pipeline = pipeline;
    this.#inputs = inputs;
  }

  static async create(device: GPUDevice, { name, wgsl, uniforms, buffers }: Contestant): Promise<Racer> {
    const type = { uniform: 'uniform', input: 'read-only-storage', output: 'storage' } as const;
    const entry = (binding: number, kind: keyof typeof type) =>
      ({ binding, visibility: GPUShaderStage.COMPUTE, buffer: { type: type[kind] } }) satisfies GPUBindGroupLayoutEntry;
    const layout = device.createBindGroupLayout({
      entries: [
        ...Object.keys(uniforms).map((binding) => entry(Number(binding), 'uniform')),
        ...Object.keys(buffers).map((binding) => entry(Number(binding), 'input')),
        entry(7, 'input'),
        entry(8, 'output'),
      ],
    });
    const pipeline = await device.createComputePipelineAsync({
      layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
      compute: { module: device.createShaderModule({ code: wgsl }), entryPoint: 'traceRays' },
    });
    const held = (data: typeof uniforms | typeof buffers, usage: number) =>
      Object.entries(data).map(([binding, words]) => ({
        binding: Number(binding),
        resource: { buffer: upload(device, words, usage) },
      }));
    const inputs = [...held(uniforms, GPUBufferUsage.UNIFORM), ...held(buffers, GPUBufferUsage.STORAGE)];
    return new Racer(device, name, pipeline, inputs);
  }

  /** Milliseconds of one dispatch, of some. */
  async run(rays: GPUBuffer, hits: GPUBuffer, dispatches: number): Promise<number> {
    const bindings = this.#device.createBindGroup({
      layout: this.#pipeline.getBindGroupLayout(0),
      entries: [
        ...this.#inputs,
        { binding: 7, resource: { buffer: rays } },
        { binding: 8, resource: { buffer: hits } },
      ],
    });
    const groups = Math.ceil(hits.size / 8 / GROUP);
    const columns = Math.min(groups, MOST_GROUPS);
    const encoder = this.#device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(this.#pipeline);
    pass.setBindGroup(0, bindings);
    for (let i = 0; i < dispatches; i++) pass.dispatchWorkgroups(columns, Math.ceil(groups / columns));
    pass.end();
    const start = performance.now();
    this.#device.queue.submit([encoder.finish()]);
    await this.#device.queue.onSubmittedWorkDone();
    return (performance.now() - start) / dispatches;
  }

  destroy(): void {
    for (const { resource } of this.#inputs) (resource as GPUBufferBinding).buffer.destroy();
  }
}

export interface RaceResult {
  /** Shortest time of each, milliseconds. */
  readonly times: readonly number[];
  readonly hits: readonly Hits[];
}

/** `rays`: eight numbers each, an origin and a direction, each with one to spare. */
export async function race(
  device: GPUDevice,
  racers: readonly Racer[],
  rays: Float32Array<ArrayBuffer>,
): Promise<RaceResult> {
  const { STORAGE, COPY_SRC } = GPUBufferUsage;
  const input = upload(device, rays, STORAGE);
  const output = device.createBuffer({ size: rays.byteLength / 4, usage: STORAGE | COPY_SRC });
  const hits: Hits[] = [];
  for (const racer of racers) {
    await racer.run(input, output, 1);
    hits.push(await readBack(device, output));
  }
  for (const start = performance.now(); performance.now() - start < WARM_UP; )
    for (const racer of racers) await racer.run(input, output, DISPATCHES);
  const times = racers.map(() => Infinity);
  for (let round = 0; round < ROUNDS; round++)
    for (const [i, racer] of racers.entries())
      times[i] = Math.min(times[i]!, await racer.run(input, output, DISPATCHES));
  input.destroy();
  output.destroy();
  return { times, hits };
}

async function readBack(device: GPUDevice, buffer: GPUBuffer): Promise<Hits> {
  const copy = device.createBuffer({ size: buffer.size, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
  const encoder = device.createCommandEncoder();
  encoder.copyBufferToBuffer(buffer, 0, copy, 0, buffer.size);
  device.queue.submit([encoder.finish()]);
  await copy.mapAsync(GPUMapMode.READ);
  const numbers = new Float32Array(copy.getMappedRange().slice(0));
  copy.destroy();
  return numbers;
}
