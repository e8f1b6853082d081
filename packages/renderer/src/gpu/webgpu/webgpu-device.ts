import {
  checkFilmSize,
  DATA_COLUMNS,
  type DataBuffer,
  type Device,
  type DeviceCounts,
  DeviceError,
  type FilmTexture,
  type FloatTexture,
  noRoom,
  type Pass,
  type PassBinding,
  type PassSource,
  type Region,
  type Resource,
  type TableTexture,
  type UniformBuffer,
  writeLines,
} from '../device.ts';
import { wgslForSoftware } from '../software-lookups.ts';
import { WebGpuCompute } from './webgpu-compute.ts';

const FILM_FORMAT = 'rgba32float';

/** Without the program's text, which may be long and is of no use any more. */
interface WebGpuPass extends Pass {
  readonly bindings: readonly PassBinding[];
  readonly pipeline: GPURenderPipeline | GPUComputePipeline;
  readonly layout: GPUBindGroupLayout;
  /** Comes after it, if it computes. */
  readonly adding: GPUComputePipeline | null;
}
interface GpuResource {
  readonly binding: GPUBindingResource;
}

/** Film samples of one dispatch, bytes, where the device grants so much: it keeps the largest GPU busy. */
const HANDED_BYTES = 256 * 1024 * 1024;

/** Limits that are asked for as high as the adapter goes. */
const LIMITS = [
  'maxTextureDimension2D',
  'maxStorageBufferBindingSize',
  'maxBufferSize',
  'maxComputeInvocationsPerWorkgroup',
  'maxComputeWorkgroupSizeX',
] as const;

/** Texels of a film that are read at once, bytes: far below the largest buffer that a device must grant. */
const READ_BYTES = 64 * 1024 * 1024;

export interface WebGpuOptions {
  /** Default: the browser's; another such as Dawn's in Node. */
  readonly gpu?: GPU | undefined;
  /** Whether passes compute that could draw too. Default: on GPUs; an adapter that is software draws as fast. */
  readonly computes?: boolean | undefined;
  /**
   * Whether data lie in textures of floats instead of storage buffers, for passes that draw. Default: on SwiftShader, which reads them faster
   * and hands every bit through; other software may take small numbers for 0.
   */
  readonly samplesData?: boolean | undefined;
}

/** Opens a WebGPU device that presents on the canvas; null: on none. Throws `DeviceError` when there is none. */
export async function openWebGpu(canvas: HTMLCanvasElement | null, options: WebGpuOptions = {}): Promise<Device> {
  const { gpu = browserGpu() } = options;
  if (!gpu) throw new DeviceError('This browser has no WebGPU.');
  const refuse = (what: string) => (error: unknown) => {
    throw new DeviceError(`${what}: ${error instanceof Error ? error.message : error}`);
  };
  const adapter = await gpu
    .requestAdapter({ powerPreference: 'high-performance' })
    .catch(refuse('WebGPU gives no adapter'));
  if (!adapter) throw new DeviceError('WebGPU found no graphics adapter.');
  // Else 8192 texels, 128 MiB and 256 threads, whatever the GPU can do.
  const requiredLimits = Object.fromEntries(LIMITS.map((name) => [name, adapter.limits[name]]));
  const device = await adapter.requestDevice({ requiredLimits }).catch(refuse('WebGPU gives no device'));
  const { computes = !adapter.info.isFallbackAdapter } = options;
  const { samplesData = !computes && adapter.info.architecture === 'swiftshader' } = options;
  return new WebGpuDevice(device, canvas, describe(adapter.info), { gpu, computes, samplesData });
}

const browserGpu = (): GPU | undefined => (typeof navigator === 'undefined' ? undefined : navigator.gpu);

function describe(info: GPUAdapterInfo): string {
  return [info.description || info.device, info.vendor, info.architecture].filter(Boolean).join(', ') || 'WebGPU';
}

function switchesIn(wgsl: string, { switches = {} }: PassSource): Record<string, number> {
  const there = Object.entries(switches).filter(([name]) => new RegExp(`\\boverride ${name} ?=`).test(wgsl));
  return Object.fromEntries(there.map(([name, on]) => [name, on ? 1 : 0]));
}

/** `inBuffers`: whether data lie in storage buffers. */
function layoutOf(
  { label, bindings, compute, layers = 1 }: PassSource,
  inBuffers: boolean,
): GPUBindGroupLayoutDescriptor {
  const visibility = compute ? GPUShaderStage.COMPUTE : GPUShaderStage.FRAGMENT;
  const inputs: Omit<GPUBindGroupLayoutEntry, 'binding' | 'visibility'>[] = bindings.map((b) => {
    if ('block' in b) return { buffer: {} };
    if ('data' in b && inBuffers) return { buffer: { type: 'read-only-storage' } };
    return { texture: { sampleType: 'unfilterable-float' } };
  });
  if (compute) {
    inputs.push({ buffer: {} });
    for (let i = 0; i < layers; i++) inputs.push({ storageTexture: { format: FILM_FORMAT } });
    inputs.push({ buffer: { type: 'storage' } });
  }
  const entries: GPUBindGroupLayoutEntry[] = inputs.map((entry, binding) => ({ binding, visibility, ...entry }));
  for (const binding of samplersOf(bindings, inBuffers))
    entries.push({ binding, visibility, sampler: { type: 'non-filtering' } });
  return { label, entries };
}

function samplersOf(bindings: readonly PassBinding[], inBuffers: boolean): ReadonlySet<number> {
  const read = bindings.filter((b) => 'texture' in b || ('data' in b && !inBuffers));
  return new Set(read.flatMap((b) => ('nearest' in b && b.nearest !== undefined ? [b.nearest] : [])));
}

const viewsOf = (film: FilmTexture): GPUTextureView[] =>
  film.layers.map((layer) => (layer as unknown as { binding: GPUTextureView }).binding);

const asSampled = (source: PassSource): PassSource => ({
  ...source,
  wgsl: { ...source.wgsl, fragment: wgslForSoftware(source.wgsl.sampled ?? source.wgsl.fragment) },
});

class WebGpuDevice implements Device {
  readonly backend = 'webgpu';
  readonly description: string;
  readonly maxTextureSize: number;
  readonly maxFilmSamples = 2 ** 24;
  readonly counts: DeviceCounts = { buffers: 0, textures: 0, programsMade: 0 };
  readonly compute: WebGpuCompute | null;
  readonly relay = null;
  readonly lost: Promise<string>;
  readonly #options: Required<WebGpuOptions>;
  readonly #device: GPUDevice;
  #context: GPUCanvasContext | null = null;
  readonly #canvas: HTMLCanvasElement | null;
  readonly #format: GPUTextureFormat;
  readonly #modules = new Map<string, GPUShaderModule>();
  /** For compute passes: which part of the film is theirs. */
  #region: UniformBuffer | null = null;
  #handed: GPUBuffer | null = null;
  #nearest: GPUSampler | null = null;
  #closed = false;

  constructor(
    device: GPUDevice,
    canvas: HTMLCanvasElement | null,
    description: string,
    options: { gpu: GPU; computes: boolean; samplesData: boolean },
  ) {
    this.#options = options;
    this.#canvas = canvas;
    this.#device = device;
    this.#format = options.gpu.getPreferredCanvasFormat();
    this.description = description;
    this.compute = options.computes ? new WebGpuCompute(device, this.counts) : null;
    this.maxTextureSize = device.limits.maxTextureDimension2D;
    this.lost = new Promise((resolve) => {
      device.lost.then((info) => {
        if (!this.#closed) resolve(info.message || info.reason);
      });
    });
  }

  async createPass(given: PassSource): Promise<Pass> {
    const { computes, samplesData } = this.#options;
    const drawn = computes ? given : { ...given, compute: undefined };
    const source = samplesData ? asSampled(drawn) : drawn;
    const layout = this.#device.createBindGroupLayout(layoutOf(source, !samplesData));
    this.counts.programsMade++;
    try {
      const { compute } = source;
      const [pipeline, adding] = await Promise.all([
        compute ? this.#computePipeline(source, compute.entry, layout) : this.#renderPipeline(source, layout),
        compute ? this.#computePipeline(source, compute.adding, layout) : null,
      ]);
      const pass: WebGpuPass = {
        label: source.label,
        addsMany: source.compute !== undefined,
        bindings: source.bindings,
        pipeline,
        adding,
        layout,
      };
      return pass;
    } catch (error) {
      throw new DeviceError(`WebGPU could not make the pipeline "${source.label}": ${(error as Error).message}`);
    }
  }

  #computePipeline(source: PassSource, entry: string, layout: GPUBindGroupLayout): Promise<GPUComputePipeline> {
    const { wgsl } = source.compute!;
    return this.#device.createComputePipelineAsync({
      label: source.label,
      layout: this.#device.createPipelineLayout({ bindGroupLayouts: [layout] }),
      compute: { module: this.#module(wgsl), entryPoint: entry, constants: switchesIn(wgsl, source) },
    });
  }

  #renderPipeline(source: PassSource, layout: GPUBindGroupLayout): Promise<GPURenderPipeline> {
    return this.#device.createRenderPipelineAsync({
      label: source.label,
      layout: this.#device.createPipelineLayout({ bindGroupLayouts: [layout] }),
      vertex: { module: this.#module(source.wgsl.vertex), entryPoint: source.entries.vertex },
      fragment: {
        module: this.#module(source.wgsl.fragment),
        entryPoint: source.entries.fragment,
        constants: switchesIn(source.wgsl.fragment, source),
        targets: Array.from({ length: source.layers ?? 1 }, () => ({
          format: source.target === 'film' ? FILM_FORMAT : this.#format,
        })),
      },
    });
  }

  attach(): void {
    if (!this.#canvas) return;
    this.#context = this.#canvas.getContext('webgpu');
    if (!this.#context)
      throw new DeviceError('The canvas gives no WebGPU context; it may have been used with another one before.');
    this.#context.configure({ device: this.#device, format: this.#format, alphaMode: 'opaque' });
  }

  #module(code: string): GPUShaderModule {
    let module = this.#modules.get(code);
    if (!module) this.#modules.set(code, (module = this.#device.createShaderModule({ code })));
    return module;
  }

  createUniforms(byteLength: number): UniformBuffer {
    const usage = GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST;
    const buffer = this.#device.createBuffer({ size: byteLength, usage });
    this.counts.buffers++;
    const uniforms: UniformBuffer & GpuResource = {
      binding: { buffer },
      write: (bytes) => this.#device.queue.writeBuffer(buffer, 0, bytes),
      destroy: () => {
        this.counts.buffers--;
        buffer.destroy();
      },
    };
    return uniforms;
  }

  #texture(width: number, height: number, usage: number) {
    checkFilmSize(this, width, height);
    const texture = this.#device.createTexture({ size: [width, height], format: FILM_FORMAT, usage });
    this.counts.textures++;
    const destroy = () => {
      this.counts.textures--;
      texture.destroy();
    };
    return { texture, binding: texture.createView(), width, height, destroy };
  }

  createTable(width: number, height: number): TableTexture {
    const base = this.#texture(width, height, GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST);
    const write = (texels: Float32Array<ArrayBuffer>, rows: number) =>
      this.#device.queue.writeTexture({ texture: base.texture }, texels, { bytesPerRow: width * 16 }, [width, rows]);
    return { ...base, write } as TableTexture;
  }

  checkData(rows: number, what: string): void {
    const size = rows * 16;
    if (this.#options.samplesData) {
      const most = this.maxTextureSize * DATA_COLUMNS * 16;
      if (size > most) throw noRoom(what, 'maxTextureSize', most, size);
      return;
    }
    for (const limit of ['maxStorageBufferBindingSize', 'maxBufferSize'] as const)
      if (size > this.#device.limits[limit]) throw noRoom(what, limit, this.#device.limits[limit], size);
  }

  createData(rows: number, what: string): DataBuffer {
    this.checkData(rows, what);
    if (this.#options.samplesData) return this.#dataTexture(rows);
    const size = rows * 16;
    const { STORAGE, COPY_SRC, COPY_DST } = GPUBufferUsage;
    const buffer = this.#device.createBuffer({ size, usage: STORAGE | COPY_SRC | COPY_DST });
    this.counts.buffers++;
    const data: DataBuffer & GpuResource = {
      rows,
      binding: { buffer },
      write: (firstRow, words) => this.#device.queue.writeBuffer(buffer, firstRow * 16, words),
      destroy: () => {
        this.counts.buffers--;
        buffer.destroy();
      },
    };
    return data;
  }

  #dataTexture(rows: number): DataBuffer {
    const lines = Math.ceil(rows / DATA_COLUMNS);
    const base = this.#texture(DATA_COLUMNS, lines, GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST);
    const { texture, binding, destroy } = base;
    const data: DataBuffer & GpuResource = {
      rows,
      binding,
      write: (firstRow, words) =>
        writeLines(firstRow, words, (x, y, width, height, part) =>
          this.#device.queue.writeTexture({ texture, origin: [x, y] }, part, { bytesPerRow: width * 16 }, [
            width,
            height,
          ]),
        ),
      destroy,
    };
    return data;
  }

  createFilm(width: number, height: number, count = 1): FilmTexture {
    const { RENDER_ATTACHMENT, TEXTURE_BINDING, COPY_SRC, COPY_DST } = GPUTextureUsage;
    const usage = RENDER_ATTACHMENT | TEXTURE_BINDING | GPUTextureUsage.STORAGE_BINDING | COPY_SRC | COPY_DST;
    const layers = Array.from({ length: count }, () => this.#texture(width, height, usage));
    const destroy = () => {
      for (const layer of layers) layer.destroy();
    };
    return { width, height, layers, destroy };
  }

  draw(pass: Pass, target: FilmTexture | 'canvas', resources: readonly Resource[], region?: Region): void {
    const { addsMany, pipeline } = pass as WebGpuPass;
    if (addsMany) {
      this.#dispatch(pass as WebGpuPass, target as FilmTexture, resources, region!);
      return;
    }
    const views = target === 'canvas' ? [this.#canvasView()] : viewsOf(target);
    const encoder = this.#device.createCommandEncoder({ label: pass.label });
    this.compute?.encode(encoder);
    const clear = region === undefined || region.firstRow === 0;
    const renderPass = encoder.beginRenderPass({
      colorAttachments: views.map((view) => ({ view, loadOp: clear ? 'clear' : 'load', storeOp: 'store' })),
    });
    renderPass.setPipeline(pipeline as GPURenderPipeline);
    const inputs = resources.map((resource) => (resource as unknown as GpuResource).binding);
    renderPass.setBindGroup(0, this.#group(pass as WebGpuPass, inputs));
    if (region) {
      renderPass.setViewport(0, 0, region.width, region.height, 0, 1);
      renderPass.setScissorRect(0, region.firstRow, region.width, region.rowCount);
    }
    renderPass.draw(3);
    renderPass.end();
    this.#device.queue.submit([encoder.finish()]);
  }

  #dispatch(pass: WebGpuPass, film: FilmTexture, resources: readonly Resource[], region: Region): void {
    const { width, firstRow, rowCount, tile = [8, 8], samples = 1 } = region;
    const rowBytes = width * samples * 16;
    const room = Math.min(HANDED_BYTES, this.#device.limits.maxStorageBufferBindingSize);
    // Whole rows of workgroups.
    const most = Math.max(Math.floor(room / rowBytes / tile[1]), 1) * tile[1];
    for (let row = 0; row < rowCount; row += most) {
      const rows = Math.min(most, rowCount - row);
      const inputs = [...resources, this.#regionOf(firstRow + row, width, rows)];
      const bound = inputs.map((resource) => (resource as unknown as GpuResource).binding);
      const handed = { buffer: this.#roomFor(rowBytes * rows) };
      const encoder = this.#device.createCommandEncoder({ label: pass.label });
      const computePass = encoder.beginComputePass();
      this.compute?.dispatch(computePass);
      computePass.setPipeline(pass.pipeline as GPUComputePipeline);
      computePass.setBindGroup(0, this.#group(pass, [...bound, ...viewsOf(film), handed]));
      computePass.dispatchWorkgroups(Math.ceil(width / tile[0]), Math.ceil(rows / tile[1]));
      computePass.setPipeline(pass.adding!);
      computePass.dispatchWorkgroups(Math.ceil(width / 8), Math.ceil(rows / 8));
      computePass.end();
      this.#device.queue.submit([encoder.finish()]);
    }
  }

  #regionOf(firstRow: number, width: number, rowCount: number): UniformBuffer {
    this.#region ??= this.createUniforms(16);
    this.#region.write(new Uint32Array([firstRow, width, rowCount]).buffer);
    return this.#region;
  }

  /** Grows with what is asked for. */
  #roomFor(bytes: number): GPUBuffer {
    if (this.#handed && this.#handed.size >= bytes) return this.#handed;
    if (this.#handed) this.#handed.destroy();
    else this.counts.buffers++;
    this.#handed = this.#device.createBuffer({
      label: 'handed',
      size: bytes,
      usage: GPUBufferUsage.STORAGE,
    });
    return this.#handed;
  }

  #group({ label, bindings, layout }: WebGpuPass, inputs: readonly GPUBindingResource[]): GPUBindGroup {
    const entries = inputs.map((resource, binding) => ({ binding, resource }));
    for (const binding of samplersOf(bindings, !this.#options.samplesData)) {
      this.#nearest ??= this.#device.createSampler({ label: 'nearest' });
      entries.push({ binding, resource: this.#nearest });
    }
    return this.#device.createBindGroup({ label, layout, entries });
  }

  #canvasView(): GPUTextureView {
    if (!this.#context) throw new DeviceError('This device was opened without a canvas.');
    return this.#context.getCurrentTexture().createView();
  }

  finished(): Promise<void> {
    return this.#device.queue.onSubmittedWorkDone();
  }

  async read(layer: FloatTexture, width: number, height: number): Promise<Float32Array<ArrayBuffer>> {
    const pixels = new Float32Array(width * height * 4);
    const most = Math.max(Math.floor(READ_BYTES / (width * 16 + 256)), 1);
    for (let row = 0; row < height; row += most) {
      const rows = Math.min(most, height - row);
      await this.#readRows(layer, width, row, rows, pixels.subarray(row * width * 4));
    }
    return pixels;
  }

  async #readRows(layer: FloatTexture, width: number, first: number, count: number, into: Float32Array): Promise<void> {
    const { texture } = layer as FloatTexture & { texture: GPUTexture };
    const bytesPerRow = Math.ceil((width * 16) / 256) * 256;
    const usage = GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ;
    const buffer = this.#device.createBuffer({ size: bytesPerRow * count, usage });
    const encoder = this.#device.createCommandEncoder();
    encoder.copyTextureToBuffer({ texture, origin: [0, first] }, { buffer, bytesPerRow }, [width, count]);
    this.#device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const padded = new Float32Array(buffer.getMappedRange());
    for (let row = 0; row < count; row++) {
      const start = (row * bytesPerRow) / 4;
      into.set(padded.subarray(start, start + width * 4), row * width * 4);
    }
    buffer.destroy();
  }

  write(layer: FloatTexture, texels: Float32Array<ArrayBuffer>, width: number, height: number): void {
    const { texture } = layer as FloatTexture & { texture: GPUTexture };
    this.#device.queue.writeTexture({ texture }, texels, { bytesPerRow: width * 16 }, [width, height]);
  }

  clear(film: FilmTexture): void {
    const encoder = this.#device.createCommandEncoder({ label: 'clear' });
    encoder
      .beginRenderPass({ colorAttachments: viewsOf(film).map((view) => ({ view, loadOp: 'clear', storeOp: 'store' })) })
      .end();
    this.#device.queue.submit([encoder.finish()]);
  }

  reopen(): Promise<Device> {
    // The context keeps its last picture until the new device takes it over.
    this.#closed = true;
    this.#device.destroy();
    return openWebGpu(this.#canvas, this.#options);
  }

  destroy(): void {
    this.#closed = true;
    this.#context?.unconfigure();
    this.#device.destroy();
  }
}
