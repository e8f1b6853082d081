import type { Page } from '@playwright/test';

/** What the page asks of WebGPU and WebGL2, counted from outside, and the means to take both away. */
export interface GpuHooks {
  /** Shader modules, pipelines and programs ever made. */
  compiled: number;
  /** Buffers and textures that exist. */
  buffers: number;
  textures: number;
  /** Draw calls so far, and the most pixels of one, into anything but the canvas. */
  draws: number;
  largestDraw: number;
  /** Pixels of the first draw since this was set to 0. */
  firstDraw: number;
  /** How often a canvas was drawn. */
  presented: number;
  /** Frames that the page waits for now, and the most that it ever waited for at once. */
  waiting: number;
  mostWaiting: number;
  /** Loses the newest device or context. */
  lose: () => void;
  /** Loses it when this many more pipelines or programs are asked for. 0: never. */
  loseAtCompile: number;
  /** Loses it and resolves with the milliseconds until the canvas is given a picture again. */
  loseAndTime: () => Promise<number>;
}
declare global {
  interface Window {
    gpuHooks: GpuHooks;
  }
}

/** Counts from now on, in every page that `page` opens. */
export async function hookGpu(page: Page): Promise<void> {
  await page.addInitScript(installGpuHooks);
}

export const hooks = (page: Page) =>
  page.evaluate(() => {
    const { compiled, buffers, textures, draws, largestDraw, firstDraw, waiting, mostWaiting } = window.gpuHooks;
    return { compiled, buffers, textures, draws, largestDraw, firstDraw, waiting, mostWaiting };
  });

/** Frames of the page without a draw after which nothing more comes. */
const RESTING_FRAMES = 12;

/** How much was drawn by now, once a row of frames has passed without more. */
export async function drawsAtRest(page: Page): Promise<number> {
  let [before, { draws }] = [-1, await hooks(page)];
  while (draws !== before) {
    before = draws;
    await page.evaluate(async (frames) => {
      for (let i = 0; i < frames; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
    }, RESTING_FRAMES);
    draws = (await hooks(page)).draws;
  }
  return draws;
}

/** Runs in the page, before its own scripts, and so holds all that it needs. */
function installGpuHooks(): void {
  let loseNow = () => {};
  let presented = (_canvas: HTMLCanvasElement) => {};
  // biome-ignore lint/suspicious/noExplicitAny: any method of any prototype
  type AnyMethod = (this: any, ...args: any[]) => any;
  /** Calls `after` when the method has been called, with its object, its result and its arguments. */
  function follow<Owner extends object>(
    owner: { prototype: Owner } | undefined,
    names: string,
    after: (self: Owner, result: unknown, args: unknown[]) => void,
  ): void {
    if (!owner) return;
    const methods = owner.prototype as unknown as Record<string, AnyMethod>;
    for (const name of names.split(' ')) {
      const original = methods[name]!;
      methods[name] = function (...args) {
        const result = original.apply(this, args);
        after(this, result, args);
        return result;
      };
    }
  }

  const hooks: GpuHooks = {
    compiled: 0,
    buffers: 0,
    textures: 0,
    draws: 0,
    largestDraw: 0,
    firstDraw: 0,
    presented: 0,
    waiting: 0,
    mostWaiting: 0,
    loseAtCompile: 0,
    lose: () => loseNow(),
    loseAndTime: () =>
      new Promise((resolve) => {
        const start = performance.now();
        loseNow();
        presented = (canvas) => {
          if (!isPicture(canvas)) return;
          presented = () => {};
          resolve(performance.now() - start);
        };
      }),
  };
  window.gpuHooks = hooks;

  function isPicture(canvas: HTMLCanvasElement): boolean {
    const small = new OffscreenCanvas(64, 48).getContext('2d', { willReadFrequently: true })!;
    small.drawImage(canvas, 0, 0, 64, 48);
    const bytes = small.getImageData(0, 0, 64, 48).data;
    const colours = new Set<number>();
    for (let i = 0; i < bytes.length; i += 4) colours.add((bytes[i]! << 16) | (bytes[i + 1]! << 8) | bytes[i + 2]!);
    return colours.size >= 8;
  }

  const compiling = () => {
    if (hooks.loseAtCompile > 0 && --hooks.loseAtCompile === 0) loseNow();
  };
  const wait = (by: 1 | -1) => {
    hooks.waiting += by;
    hooks.mostWaiting = Math.max(hooks.mostWaiting, hooks.waiting);
  };
  const present = (canvas: HTMLCanvasElement) => {
    hooks.presented++;
    presented(canvas);
  };
  const drawn = (pixels: number) => {
    hooks.draws++;
    hooks.firstDraw ||= pixels;
    hooks.largestDraw = Math.max(hooks.largestDraw, pixels);
  };

  function hookWebGpu(): void {
    const alive = new WeakSet<object>();
    const gone = (kind: 'buffers' | 'textures') => (self: object) => {
      if (alive.delete(self)) hooks[kind]--;
    };
    const made = (kind: 'buffers' | 'textures') => (_: unknown, result: unknown) => {
      alive.add(result as object);
      hooks[kind]++;
    };
    follow(window.GPUAdapter, 'requestDevice', (_, result) => {
      (result as Promise<GPUDevice>).then((device) => {
        loseNow = () => device.destroy();
      });
    });
    follow(window.GPUDevice, 'createShaderModule createRenderPipeline createComputePipeline', () => hooks.compiled++);
    follow(window.GPUDevice, 'createRenderPipelineAsync createComputePipelineAsync', () => {
      hooks.compiled++;
      compiling();
    });
    follow(window.GPUDevice, 'createBuffer', made('buffers'));
    follow(window.GPUDevice, 'createTexture', made('textures'));
    follow(window.GPUBuffer, 'destroy', gone('buffers'));
    follow(window.GPUTexture, 'destroy', gone('textures'));
    let canvas: HTMLCanvasElement | null = null;
    follow(window.GPUCanvasContext, 'getCurrentTexture', (context) => {
      canvas = context.canvas as HTMLCanvasElement;
    });
    follow(window.GPURenderPassEncoder, 'setScissorRect', (_, __, args) => drawn(Number(args[2]) * Number(args[3])));
    follow(window.GPUQueue, 'submit', () => {
      if (canvas) present(canvas);
      canvas = null;
    });
    follow(window.GPUQueue, 'onSubmittedWorkDone', (_, result) => {
      wait(1);
      const done = () => wait(-1);
      (result as Promise<void>).then(done, done);
    });
  }

  function hookWebGl2(): void {
    const gl2 = window.WebGL2RenderingContext;
    follow(HTMLCanvasElement, 'getContext', (_, context) => {
      if (!(context instanceof gl2)) return;
      const extension = context.getExtension('WEBGL_lose_context');
      if (extension) loseNow = () => extension.loseContext();
    });
    follow(gl2, 'createProgram', () => hooks.compiled++);
    follow(gl2, 'linkProgram', () => {
      hooks.compiled++;
      compiling();
    });
    follow(gl2, 'createBuffer', () => hooks.buffers++);
    follow(gl2, 'createTexture', () => hooks.textures++);
    follow(gl2, 'deleteBuffer', () => hooks.buffers--);
    follow(gl2, 'deleteTexture', () => hooks.textures--);
    follow(gl2, 'fenceSync', (_, result) => result && wait(1));
    follow(gl2, 'deleteSync', () => wait(-1));
    follow(gl2, 'drawArrays', (gl) => {
      if (gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) === null) return present(gl.canvas as HTMLCanvasElement);
      const [, , width, height] = gl.getParameter(gl.SCISSOR_BOX) as Int32Array;
      drawn(width! * height!);
    });
  }

  hookWebGpu();
  hookWebGl2();
}
