import {
  checkFilmSize,
  type Device,
  type DeviceCounts,
  DeviceError,
  type FilmTexture,
  type FloatTexture,
  type Pass,
  type PassSource,
  type Region,
  type Resource,
  type TableTexture,
  type UniformBuffer,
} from '../device.ts';

const FILM_FORMAT = 'rgba32float';

interface WebGpuPass extends Pass {
  readonly pipeline: GPURenderPipeline;
  readonly layout: GPUBindGroupLayout;
}
interface GpuResource {
  readonly binding: GPUBindingResource;
}

/** Opens a WebGPU device that presents on the canvas. Throws `DeviceError` when there is none. */
export async function openWebGpu(canvas: HTMLCanvasElement | null): Promise<Device> {
  const gpu = typeof navigator === 'undefined' ? undefined : navigator.gpu;
  if (!gpu) throw new DeviceError('This browser has no WebGPU.');
  const refuse = (what: string) => (error: unknown) => {
    throw new DeviceError(`${what}: ${error instanceof Error ? error.message : error}`);
  };
  const adapter = await gpu
    .requestAdapter({ powerPreference: 'high-performance' })
    .catch(refuse('WebGPU gives no adapter'));
  if (!adapter) throw new DeviceError('WebGPU found no graphics adapter.');
  const device = await adapter.requestDevice().catch(refuse('WebGPU gives no device'));
  return new WebGpuDevice(device, canvas, gpu.getPreferredCanvasFormat(), describe(adapter.info));
}

function describe(info: GPUAdapterInfo): string {
  return [info.description || info.device, info.vendor, info.architecture].filter(Boolean).join(', ') || 'WebGPU';
}

class WebGpuDevice implements Device {
  readonly backend = 'webgpu';
  readonly description: string;
  readonly maxTextureSize: number;
  readonly maxFilmSamples = 2 ** 24;
  readonly counts: DeviceCounts = { buffers: 0, textures: 0, programsMade: 0 };
  readonly lost: Promise<string>;
  readonly #device: GPUDevice;
  #context: GPUCanvasContext | null = null;
  readonly #canvas: HTMLCanvasElement | null;
  readonly #format: GPUTextureFormat;
  readonly #modules = new Map<string, GPUShaderModule>();
  #closed = false;

  constructor(device: GPUDevice, canvas: HTMLCanvasElement | null, format: GPUTextureFormat, description: string) {
    this.#canvas = canvas;
    this.#device = device;
    this.#format = format;
    this.description = description;
    this.maxTextureSize = device.limits.maxTextureDimension2D;
    this.lost = new Promise((resolve) => {
      device.lost.then((info) => {
        if (!this.#closed) resolve(info.message || info.reason);
      });
    });
  }

  async createPass(source: PassSource): Promise<Pass> {
    const layout = this.#device.createBindGroupLayout({
      label: source.label,
      entries: source.bindings.map((b, binding) => ({
        binding,
        visibility: GPUShaderStage.FRAGMENT,
        ...('block' in b ? { buffer: {} } : { texture: { sampleType: 'unfilterable-float' as const } }),
      })),
    });
    this.counts.programsMade++;
    const pipeline = await this.#pipeline(source, layout);
    return { label: source.label, pipeline, layout } as WebGpuPass;
  }

  async #pipeline(source: PassSource, layout: GPUBindGroupLayout): Promise<GPURenderPipeline> {
    const descriptor: GPURenderPipelineDescriptor = {
      label: source.label,
      layout: this.#device.createPipelineLayout({ bindGroupLayouts: [layout] }),
      vertex: { module: this.#module(source.wgsl.vertex), entryPoint: source.entries.vertex },
      fragment: {
        module: this.#module(source.wgsl.fragment),
        entryPoint: source.entries.fragment,
        targets: Array.from({ length: source.layers ?? 1 }, () => ({
          format: source.target === 'film' ? FILM_FORMAT : this.#format,
        })),
      },
    };
    try {
      return await this.#device.createRenderPipelineAsync(descriptor);
    } catch (error) {
      throw new DeviceError(`WebGPU could not make the pipeline "${source.label}": ${(error as Error).message}`);
    }
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

  createFilm(width: number, height: number, count = 1): FilmTexture {
    const { RENDER_ATTACHMENT, TEXTURE_BINDING, COPY_SRC } = GPUTextureUsage;
    const usage = RENDER_ATTACHMENT | TEXTURE_BINDING | COPY_SRC;
    const layers = Array.from({ length: count }, () => this.#texture(width, height, usage));
    const destroy = () => {
      for (const layer of layers) layer.destroy();
    };
    return { width, height, layers, destroy };
  }

  draw(pass: Pass, target: FilmTexture | 'canvas', resources: readonly Resource[], region?: Region): void {
    const { pipeline, layout } = pass as WebGpuPass;
    const views =
      target === 'canvas'
        ? [this.#canvasView()]
        : target.layers.map((layer) => (layer as unknown as { binding: GPUTextureView }).binding);
    const encoder = this.#device.createCommandEncoder({ label: pass.label });
    const clear = region === undefined || region.firstRow === 0;
    const renderPass = encoder.beginRenderPass({
      colorAttachments: views.map((view) => ({ view, loadOp: clear ? 'clear' : 'load', storeOp: 'store' })),
    });
    renderPass.setPipeline(pipeline);
    const entries = resources.map((r, binding) => ({ binding, resource: (r as unknown as GpuResource).binding }));
    renderPass.setBindGroup(0, this.#device.createBindGroup({ layout, entries }));
    if (region) {
      renderPass.setViewport(0, 0, region.width, region.height, 0, 1);
      renderPass.setScissorRect(0, region.firstRow, region.width, region.rowCount);
    }
    renderPass.draw(3);
    renderPass.end();
    this.#device.queue.submit([encoder.finish()]);
  }

  #canvasView(): GPUTextureView {
    if (!this.#context) throw new DeviceError('This device was opened without a canvas.');
    return this.#context.getCurrentTexture().createView();
  }

  finished(): Promise<void> {
    return this.#device.queue.onSubmittedWorkDone();
  }

  async read(layer: FloatTexture, width: number, height: number): Promise<Float32Array<ArrayBuffer>> {
    const { texture } = layer as FloatTexture & { texture: GPUTexture };
    const bytesPerRow = Math.ceil((width * 16) / 256) * 256;
    const usage = GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ;
    const buffer = this.#device.createBuffer({ size: bytesPerRow * height, usage });
    const encoder = this.#device.createCommandEncoder();
    encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow }, [width, height]);
    this.#device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const padded = new Float32Array(buffer.getMappedRange());
    const pixels = new Float32Array(width * height * 4);
    for (let y = 0; y < height; y++) {
      const start = (y * bytesPerRow) / 4;
      pixels.set(padded.subarray(start, start + width * 4), y * width * 4);
    }
    buffer.destroy();
    return pixels;
  }

  reopen(): Promise<Device> {
    // The context keeps its last picture until the new device takes it over.
    this.#closed = true;
    this.#device.destroy();
    return openWebGpu(this.#canvas);
  }

  destroy(): void {
    this.#closed = true;
    this.#context?.unconfigure();
    this.#device.destroy();
  }
}
