import {
  checkFilmSize,
  DATA_COLUMNS,
  type DataBuffer,
  type Device,
  type DeviceCounts,
  DeviceError,
  type FilmTexture,
  type FloatTexture,
  type GlslSource,
  noRoom,
  type Pass,
  type Region,
  type Relay,
  type Resource,
  type TableTexture,
  type UniformBuffer,
  writeLines,
} from '../device.ts';
import { glslForSoftware, stepOf } from '../software-lookups.ts';
import { compileProgram } from './program.ts';

/** How long a lost context may take to come back before the device counts as gone. */
const RESTORE_TIMEOUT_MS = 3000;
const RESTORE_PAUSE_MS = 50;

interface GlPass extends Pass {
  readonly program: WebGLProgram;
  /** Of each binding: where its texels' step goes; null where the program does not ask. */
  readonly steps: readonly (WebGLUniformLocation | null)[];
}
interface GlTexture {
  readonly texture: WebGLTexture;
  readonly width: number;
  readonly height: number;
}
interface GlFilm extends FilmTexture {
  readonly framebuffer: WebGLFramebuffer;
}
interface GlUniforms extends UniformBuffer {
  readonly buffer: WebGLBuffer;
}

/** Layers that passes draw into at once where they keep words: more than WebGL2 promises. */
const RELAY_LAYERS = 8;
/** What Windows' shader compiler stands behind: it takes the square of a program's length, and more for loops. */
const COMPILES_SLOWLY = /Direct3D11/;

/** Samples that a film of half floats sums up before rounding shows. */
const MOST_HALF_FLOAT_SAMPLES = 32;

/**
 * Opens a WebGL2 device that presents on the canvas, waiting for a lost context to be restored. Rejects with `DeviceError` when
 * there is none.
 */
export async function openWebGl2(canvas: HTMLCanvasElement): Promise<Device> {
  const gl = await webGl2Context(canvas);
  if (!gl)
    throw new DeviceError(
      givesContexts()
        ? 'This canvas has a context of another kind already, so that it gives none for WebGL2; please give a fresh canvas.'
        : 'This browser gives no WebGL2 context.',
    );
  if (gl.getExtension('EXT_color_buffer_float')) return new WebGl2Device(gl, canvas, gl.RGBA32F);
  if (gl.getExtension('EXT_color_buffer_half_float')) return new WebGl2Device(gl, canvas, gl.RGBA16F);
  throw new DeviceError('This WebGL2 cannot draw into float textures (EXT_color_buffer_float).');
}

/** Whether a canvas that nobody has used gets a WebGL2 context. */
function givesContexts(): boolean {
  const gl = document.createElement('canvas').getContext('webgl2');
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return gl !== null;
}

/** The canvas's context, restored if it was lost; null where there is none. Rejects with `DeviceError` when it stays lost. */
export async function webGl2Context(canvas: HTMLCanvasElement): Promise<WebGL2RenderingContext | null> {
  const gl = canvas.getContext('webgl2', {
    alpha: false,
    antialias: false,
    depth: false,
    powerPreference: 'high-performance',
  });
  if (gl?.isContextLost()) await restored(canvas);
  return gl;
}

/** For each canvas what loses and restores its context; a lost context would not give it. */
const loseContext = new WeakMap<HTMLCanvasElement, WEBGL_lose_context>();

/** Resolves when the lost context is there again. */
function restored(canvas: HTMLCanvasElement): Promise<void> {
  return new Promise((resolve, reject) => {
    const done = (error?: DeviceError) => {
      clearTimeout(timer);
      clearInterval(asking);
      canvas.removeEventListener('webglcontextrestored', back);
      if (error) reject(error);
      else resolve();
    };
    const back = () => done();
    canvas.addEventListener('webglcontextrestored', back);
    const timer = setTimeout(() => done(new DeviceError('The WebGL2 context did not come back.')), RESTORE_TIMEOUT_MS);
    // A context lost by this very extension waits to be asked, once its event is over; one that the browser took comes by itself.
    const asking = setInterval(() => loseContext.get(canvas)?.restoreContext(), RESTORE_PAUSE_MS);
  });
}

const keepRestorable = (event: Event) => event.preventDefault();

class WebGl2Device implements Device {
  readonly backend = 'webgl2';
  readonly description: string;
  readonly maxTextureSize: number;
  readonly maxFilmSamples: number;
  readonly counts: DeviceCounts = { buffers: 0, textures: 0, programsMade: 0 };
  readonly compute = null;
  readonly relay: Relay | null;
  readonly lost: Promise<string>;
  readonly #gl: WebGL2RenderingContext;
  readonly #canvas: HTMLCanvasElement;
  readonly #filmFormat: number;
  readonly #isSoftware: boolean;
  readonly #onLost: (event: Event) => void;
  #closed = false;
  /** The last answer that `finished` owes. */
  #finishing: Promise<unknown> = Promise.resolve();

  constructor(gl: WebGL2RenderingContext, canvas: HTMLCanvasElement, filmFormat: number) {
    this.#gl = gl;
    this.#canvas = canvas;
    this.#filmFormat = filmFormat;
    const info = gl.getExtension('WEBGL_debug_renderer_info');
    this.description = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    this.#isSoftware = this.description.includes('SwiftShader');
    this.maxTextureSize = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    this.maxFilmSamples = filmFormat === gl.RGBA32F ? 2 ** 24 : MOST_HALF_FLOAT_SAMPLES;
    this.relay = gl.getParameter(gl.MAX_DRAW_BUFFERS) < RELAY_LAYERS ? null : this.#relay();
    const losing = gl.getExtension('WEBGL_lose_context');
    if (losing) loseContext.set(canvas, losing);
    let report: (reason: string) => void = () => {};
    this.lost = new Promise((resolve) => {
      report = resolve;
    });
    this.#onLost = (event) => {
      keepRestorable(event); // without this the browser never restores the context
      if (!this.#closed) report('The browser took the WebGL2 context away.');
    };
    canvas.addEventListener('webglcontextlost', this.#onLost);
    gl.bindVertexArray(gl.createVertexArray());
    gl.disable(gl.DITHER);
  }

  #relay(): Relay {
    return {
      pays: COMPILES_SLOWLY.test(this.description),
      createPass: (source) => this.createPass(source),
      createWords: (width, height, layers) => this.#film(width, height, layers, this.#gl.RGBA32UI),
      drawAsking: (pass, target, resources, region) => this.#drawAsking(pass, target, resources, region),
    };
  }

  async createPass(source: GlslSource): Promise<Pass> {
    const gl = this.#gl;
    this.counts.programsMade++;
    const textures = source.bindings.map((b) => ('block' in b ? '' : 'data' in b ? b.data : b.texture));
    const { fragment } = source.glsl;
    const program = await compileProgram(gl, source, this.#isSoftware ? glslForSoftware(fragment, textures) : fragment);
    gl.useProgram(program);
    source.bindings.forEach((b, binding) => {
      if ('block' in b) {
        const index = gl.getUniformBlockIndex(program, `${b.block}Block`);
        if (index !== gl.INVALID_INDEX) gl.uniformBlockBinding(program, index, binding);
      } else gl.uniform1i(gl.getUniformLocation(program, textures[binding]!), binding);
    });
    const steps = textures.map((texture) => gl.getUniformLocation(program, stepOf(texture)));
    return { label: source.label, addsMany: false, program, steps } as GlPass;
  }

  /** The context was the canvas's from the start. */
  attach(): void {}

  createUniforms(byteLength: number): UniformBuffer {
    const gl = this.#gl;
    const buffer = gl.createBuffer()!;
    gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
    gl.bufferData(gl.UNIFORM_BUFFER, byteLength, gl.DYNAMIC_DRAW);
    this.counts.buffers++;
    const uniforms: GlUniforms = {
      buffer,
      write: (bytes) => {
        gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
        gl.bufferSubData(gl.UNIFORM_BUFFER, 0, new Uint8Array(bytes));
      },
      destroy: () => {
        this.counts.buffers--;
        gl.deleteBuffer(buffer);
      },
    };
    return uniforms;
  }

  #texture(width: number, height: number, format: number) {
    checkFilmSize(this, width, height);
    const gl = this.#gl;
    const texture = gl.createTexture()!;
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
    this.counts.textures++;
    return { texture, width, height };
  }

  createTable(width: number, height: number): TableTexture {
    const gl = this.#gl;
    const base = this.#texture(width, height, gl.RGBA32F);
    const write = (texels: Float32Array, rows: number) => {
      gl.bindTexture(gl.TEXTURE_2D, base.texture);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, rows, gl.RGBA, gl.FLOAT, texels);
    };
    const destroy = () => {
      this.counts.textures--;
      gl.deleteTexture(base.texture);
    };
    return { ...base, write, destroy } as TableTexture;
  }

  checkData(rows: number, what: string): void {
    if (Math.ceil(rows / DATA_COLUMNS) > this.maxTextureSize)
      throw noRoom(what, 'maxTextureSize', this.maxTextureSize * DATA_COLUMNS * 16, rows * 16);
  }

  createData(rows: number, what: string): DataBuffer {
    this.checkData(rows, what);
    const gl = this.#gl;
    const lines = Math.ceil(rows / DATA_COLUMNS);
    const base = this.#texture(DATA_COLUMNS, lines, gl.RGBA32UI);
    const data: DataBuffer & GlTexture = {
      ...base,
      rows,
      write: (firstRow, words) => {
        gl.bindTexture(gl.TEXTURE_2D, base.texture);
        writeLines(firstRow, words, (x, y, width, height, part) =>
          gl.texSubImage2D(gl.TEXTURE_2D, 0, x, y, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, part),
        );
      },
      destroy: () => {
        this.counts.textures--;
        gl.deleteTexture(base.texture);
      },
    };
    return data;
  }

  createFilm(width: number, height: number, count = 1): FilmTexture {
    return this.#film(width, height, count, this.#filmFormat);
  }

  #film(width: number, height: number, count: number, format: number): FilmTexture {
    const gl = this.#gl;
    const layers = Array.from({ length: count }, () => this.#texture(width, height, format));
    const framebuffer = this.#framebuffer(layers);
    const destroy = () => {
      this.counts.textures -= count;
      gl.deleteFramebuffer(framebuffer);
      for (const { texture } of layers) gl.deleteTexture(texture);
    };
    return { width, height, layers, framebuffer, destroy } as unknown as GlFilm;
  }

  #framebuffer(layers: readonly { texture: WebGLTexture }[]): WebGLFramebuffer {
    const gl = this.#gl;
    const framebuffer = gl.createFramebuffer()!;
    const attachments = layers.map((_, i) => gl.COLOR_ATTACHMENT0 + i);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    layers.forEach(({ texture }, i) => {
      gl.framebufferTexture2D(gl.FRAMEBUFFER, attachments[i]!, gl.TEXTURE_2D, texture, 0);
    });
    gl.drawBuffers(attachments);
    return framebuffer;
  }

  draw(pass: Pass, target: FilmTexture | 'canvas', resources: readonly Resource[], region?: Region): void {
    const gl = this.#gl;
    const { program, steps } = pass as GlPass;
    const { width, height } = region ?? (target === 'canvas' ? this.#canvas : target);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target === 'canvas' ? null : (target as GlFilm).framebuffer);
    gl.viewport(0, 0, width, height);
    gl.useProgram(program);
    resources.forEach((r, binding) => {
      if ('buffer' in r) gl.bindBufferBase(gl.UNIFORM_BUFFER, binding, (r as GlUniforms).buffer);
      else {
        const { texture, width: columns, height: rows } = r as unknown as GlTexture;
        gl.activeTexture(gl.TEXTURE0 + binding);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        const step = steps[binding];
        if (step) gl.uniform2f(step, 1 / columns, 1 / rows);
      }
    });
    if (region) {
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(0, region.firstRow, width, region.rowCount);
    }
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    if (region) gl.disable(gl.SCISSOR_TEST);
    gl.flush();
  }

  async #drawAsking(pass: Pass, target: FilmTexture, resources: readonly Resource[], region: Region): Promise<boolean> {
    const gl = this.#gl;
    const query = gl.createQuery();
    if (!query) return false; // lost
    gl.beginQuery(gl.ANY_SAMPLES_PASSED, query);
    this.draw(pass, target, resources, region);
    gl.endQuery(gl.ANY_SAMPLES_PASSED);
    await this.finished();
    while (!gl.isContextLost() && !gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)) await nextTask();
    const drew = gl.getQueryParameter(query, gl.QUERY_RESULT);
    gl.deleteQuery(query);
    return Boolean(drew);
  }

  /** Fences are asked in turn, so a later one may be seen to have been passed before the one in front of it is asked again. */
  finished(): Promise<void> {
    const finishing = Promise.all([this.#finishing, this.#passed()]).then(() => {});
    this.#finishing = finishing;
    return finishing;
  }

  async #passed(): Promise<void> {
    const gl = this.#gl;
    const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    if (!sync) return; // lost
    while (!gl.isContextLost() && gl.getSyncParameter(sync, gl.SYNC_STATUS) === gl.UNSIGNALED) await nextTask();
    gl.deleteSync(sync);
  }

  async read(layer: FloatTexture, width: number, height: number): Promise<Float32Array<ArrayBuffer>> {
    const gl = this.#gl;
    const pixels = new Float32Array(width * height * 4);
    // By way of a buffer, which is read when it is ready: to read at once would stall the page until all that was drawn is done.
    const buffer = gl.createBuffer();
    const framebuffer = this.#framebuffer([layer as unknown as GlTexture]);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.bufferData(gl.PIXEL_PACK_BUFFER, pixels.byteLength, gl.STREAM_READ);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.deleteFramebuffer(framebuffer);
    await this.finished();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, pixels);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.deleteBuffer(buffer);
    return pixels;
  }

  write(layer: FloatTexture, texels: Float32Array<ArrayBuffer>, width: number, height: number): void {
    const gl = this.#gl;
    gl.bindTexture(gl.TEXTURE_2D, (layer as unknown as GlTexture).texture);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.FLOAT, texels);
  }

  clear(film: FilmTexture): void {
    const gl = this.#gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, (film as GlFilm).framebuffer);
    film.layers.forEach((_, i) => {
      gl.clearBufferfv(gl.COLOR, i, [0, 0, 0, 0]);
    });
  }

  /** Browsers keep few contexts alive, and free one only when its canvas is garbage: so the context is let go here. */
  destroy(): void {
    if (this.#closed) return;
    this.#close();
    // Another renderer may want this canvas later and have the context restored.
    this.#canvas.addEventListener('webglcontextlost', keepRestorable, { once: true });
    if (!this.#gl.isContextLost()) loseContext.get(this.#canvas)?.loseContext();
  }

  #close(): void {
    this.#closed = true;
    this.#canvas.removeEventListener('webglcontextlost', this.#onLost);
  }

  reopen(): Promise<Device> {
    this.#close();
    return openWebGl2(this.#canvas);
  }
}

function nextTask(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, 1));
}
