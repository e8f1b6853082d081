/** Compute programs over data, on WebGPU. What is to be run waits for the next thing that is drawn and goes to the device with it. */
import {
  type Compute,
  type DataBuffer,
  type DeviceCounts,
  DeviceError,
  type KernelSource,
  type KernelStep,
  type Kernels,
  type Work,
} from '../device.ts';

interface WebGpuKernels extends Kernels {
  readonly layout: GPUBindGroupLayout;
  readonly pipelines: ReadonlyMap<string, GPUComputePipeline>;
}
/** What the entries of a text have in common. */
interface Shared {
  readonly layout: GPUPipelineLayout;
  readonly module: GPUShaderModule;
  readonly constants: Readonly<Record<string, number>>;
}
interface WebGpuWork extends Work {
  readonly group: GPUBindGroup;
  readonly steps: readonly { readonly pipeline: GPUComputePipeline; readonly groups: readonly [number, number] }[];
}

const bufferOf = (data: DataBuffer): GPUBuffer => (data as DataBuffer & { binding: GPUBufferBinding }).binding.buffer;

export class WebGpuCompute implements Compute {
  readonly #device: GPUDevice;
  readonly #counts: DeviceCounts;
  readonly #waiting = new Set<WebGpuWork>();

  constructor(device: GPUDevice, counts: DeviceCounts) {
    this.#device = device;
    this.#counts = counts;
  }

  get maxRows(): number {
    const { maxStorageBufferBindingSize, maxBufferSize } = this.#device.limits;
    return Math.floor(Math.min(maxStorageBufferBindingSize, maxBufferSize) / 16);
  }

  get maxThreads(): number {
    const { maxComputeInvocationsPerWorkgroup, maxComputeWorkgroupSizeX } = this.#device.limits;
    return Math.min(maxComputeInvocationsPerWorkgroup, maxComputeWorkgroupSizeX);
  }

  async createKernels({ label, wgsl, entries, constants = {}, data }: KernelSource): Promise<Kernels> {
    const buffers: GPUBufferBindingLayout[] = [
      ...data.map((use) => ({ type: use === 'read' ? 'read-only-storage' : 'storage' }) as const),
      { hasDynamicOffset: true },
    ];
    const visibility = GPUShaderStage.COMPUTE;
    const layout = this.#device.createBindGroupLayout({
      label,
      entries: buffers.map((buffer, binding) => ({ binding, visibility, buffer })),
    });
    this.#counts.programsMade++;
    const shared = {
      layout: this.#device.createPipelineLayout({ bindGroupLayouts: [layout] }),
      module: this.#device.createShaderModule({ code: wgsl }),
      constants,
    };
    const pipelines = entries.map(async (entry) => [entry, await this.#pipeline(label, entry, shared)] as const);
    const kernels: WebGpuKernels = { label, layout, pipelines: new Map(await Promise.all(pipelines)) };
    return kernels;
  }

  #pipeline(label: string, entryPoint: string, { layout, ...shared }: Shared) {
    return this.#device
      .createComputePipelineAsync({ label, layout, compute: { ...shared, entryPoint } })
      .catch((error: Error) => {
        throw new DeviceError(`WebGPU could not make the kernel "${entryPoint}": ${error.message}`);
      });
  }

  prepare(kernels: Kernels, data: readonly DataBuffer[], steps: readonly KernelStep[]): Work {
    const { label, layout, pipelines } = kernels as WebGpuKernels;
    const told = this.#told(steps);
    const buffers = [...data.map((one) => ({ buffer: bufferOf(one) })), { buffer: told, size: 16 }];
    const entries = buffers.map((resource, binding) => ({ binding, resource }));
    const most = this.#device.limits.maxComputeWorkgroupsPerDimension;
    this.#counts.buffers++;
    const work: WebGpuWork = {
      group: this.#device.createBindGroup({ label, layout, entries }),
      steps: steps.map(({ entry, groups }) => ({
        pipeline: pipelines.get(entry)!,
        groups: [Math.min(groups, most), Math.ceil(groups / most)],
      })),
      destroy: () => {
        this.#waiting.delete(work);
        this.#counts.buffers--;
        told.destroy();
      },
    };
    return work;
  }

  /** What the steps are told, each as far from the next as this device wants it. */
  #told(steps: readonly KernelStep[]): GPUBuffer {
    const words = this.#apart / 4;
    const all = new Uint32Array(Math.max(steps.length, 1) * words);
    steps.forEach(({ first, groups }, i) => {
      all.set([first, groups], i * words);
    });
    const usage = GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST;
    const buffer = this.#device.createBuffer({ size: all.byteLength, usage });
    this.#device.queue.writeBuffer(buffer, 0, all);
    return buffer;
  }

  get #apart(): number {
    return this.#device.limits.minUniformBufferOffsetAlignment;
  }

  run(work: Work): void {
    this.#waiting.add(work as WebGpuWork);
  }

  /** Puts what is waiting before all else. */
  encode(encoder: GPUCommandEncoder): void {
    if (this.#waiting.size === 0) return;
    const pass = encoder.beginComputePass();
    this.dispatch(pass);
    pass.end();
  }

  dispatch(pass: GPUComputePassEncoder): void {
    for (const { group, steps } of this.#waiting)
      steps.forEach(({ pipeline, groups: [columns, rows] }, i) => {
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group, [i * this.#apart]);
        pass.dispatchWorkgroups(columns, rows);
      });
    this.#waiting.clear();
  }

  async read(data: DataBuffer, firstRow: number, rows: number): Promise<Uint32Array<ArrayBuffer>> {
    const size = rows * 16;
    const buffer = this.#device.createBuffer({ size, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const encoder = this.#device.createCommandEncoder();
    this.encode(encoder);
    encoder.copyBufferToBuffer(bufferOf(data), firstRow * 16, buffer, 0, size);
    this.#device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const words = new Uint32Array(buffer.getMappedRange().slice(0));
    buffer.destroy();
    return words;
  }
}
