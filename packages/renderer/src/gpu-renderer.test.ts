import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { cubeMesh } from '../../../tests/fixtures/meshes/solids.ts';
import { arm } from '../../../tests/fixtures/motion.ts';
import { PoseWorker } from '../../../tests/fixtures/pose-worker.ts';
import { testScene } from '../../../tests/fixtures/scenes.ts';
import {
  type Compute,
  type Device,
  DeviceError,
  type FilmTexture,
  type Pass,
  type PassSource,
  type Region,
} from './gpu/device.ts';
import { GpuRenderer } from './gpu-renderer.ts';
import { UntraceableSceneError } from './packed-scene/refuse-meshes.ts';
import type { RendererOptions } from './renderer-types.ts';
import { builtInScenes } from './scene/built-in/index.ts';
import type { Scene } from './scene/scene.ts';

/** A device that draws nothing and remembers what it was asked for. Its work is finished when the test says so. */
class FakeDevice implements Device {
  readonly backend = 'webgl2';
  readonly description = 'fake';
  compute: Compute | null = null;
  readonly relay = null;
  readonly maxTextureSize = 4096;
  readonly maxFilmSamples = 2 ** 24;
  readonly counts = { buffers: 0, textures: 0, programsMade: 0 };
  readonly drawn: { pass: string; rows: number; firstRow: number }[] = [];
  destroyed = false;
  /** Milliseconds that each submit takes. */
  submitMs = 1;
  /** And each row of it. */
  rowMs = 0;
  compileMs: Record<string, number> = {};
  /** Whether one call may add many samples. */
  addsMany = false;
  lose: (reason: string) => void = () => {};
  readonly lost = new Promise<string>((resolve) => {
    this.lose = resolve;
  });
  next: FakeDevice | null = null;

  async createPass({ label }: PassSource): Promise<Pass> {
    this.counts.programsMade++;
    await pause(this.compileMs[label] ?? 0);
    return { label, addsMany: this.addsMany };
  }
  attach(): void {}
  createUniforms() {
    this.counts.buffers++;
    return { write: () => {}, destroy: () => this.counts.buffers-- };
  }
  createTable(width: number, height: number) {
    this.counts.textures++;
    return { width, height, write: () => {}, destroy: () => this.counts.textures-- };
  }
  checkData() {}
  createData(rows: number) {
    this.counts.buffers++;
    return { rows, write: () => {}, destroy: () => this.counts.buffers-- };
  }
  createFilm(width: number, height: number, count = 1): FilmTexture {
    this.counts.textures++;
    const destroy = () => this.counts.textures--;
    return { width, height, layers: Array.from({ length: count }, () => ({ width, height, destroy })), destroy };
  }
  draw(pass: Pass, _target: unknown, _resources: unknown, region?: Region): void {
    if (this.destroyed) throw new Error('drawn with a destroyed device');
    this.drawn.push({ pass: pass.label, rows: region?.rowCount ?? 0, firstRow: region?.firstRow ?? 0 });
  }
  finished = () => pause(this.submitMs + this.rowMs * (this.drawn.findLast(({ rows }) => rows > 0)?.rows ?? 0));
  read = async (_film: unknown, width: number, height: number) => new Float32Array(width * height * 4).fill(1);
  write(): void {}
  clear(): void {}
  async reopen(): Promise<Device> {
    if (!this.next) throw new DeviceError('There is none.');
    return this.next;
  }
  destroy(): void {
    this.destroyed = true;
  }
  /** How often this pass was begun. */
  count = (label: string) => this.drawn.filter(({ pass, firstRow }) => pass === label && firstRow === 0).length;
}

const pause = (ms: number) => new Promise<void>((resolve) => setTimeout(resolve, ms));
const scenes = builtInScenes.map(({ scene }) => scene);

async function open(device: FakeDevice, options: RendererOptions = {}, size = 64) {
  const canvas = { width: size, height: size } as HTMLCanvasElement;
  const settings = { adaptive: false, maxSamples: 3, ...options.settings };
  const renderer = await GpuRenderer.create(canvas, device, { ...options, settings });
  renderer.playing = false;
  return renderer;
}
/** Lets time pass in small steps, for promises between timers. */
const pass = (ms: number) => vi.advanceTimersByTimeAsync(ms);

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
  vi.stubGlobal('requestAnimationFrame', (tick: (now: number) => void) =>
    setTimeout(() => tick(performance.now()), 16),
  );
  vi.stubGlobal('cancelAnimationFrame', (request: ReturnType<typeof setTimeout>) => clearTimeout(request));
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

async function started(device: FakeDevice, options: RendererOptions = {}, size = 64) {
  const opening = open(device, options, size);
  await pass(1);
  const renderer = await opening;
  void renderer.setScene(scenes[0]!);
  renderer.start();
  return renderer;
}

describe('a still picture', () => {
  test('the preview counts as no sample, and is replaced by the whole one though nothing moves', async () => {
    const device = new FakeDevice();
    device.compileMs.classic = 200;
    const samples: number[] = [];
    const renderer = await started(device, { onFrame: (stats) => samples.push(stats.samples) });
    await pass(150);
    expect([device.count('preview'), device.count('classic'), samples]).toEqual([1, 0, [0]]);
    await pass(500);
    expect([device.count('preview'), device.count('classic'), samples]).toEqual([1, 3, [0, 1, 2, 3]]);
    expect(renderer.stats.samples).toBe(3);
  });

  test('when it is finished nothing is drawn; exposure and a new canvas size only show it again', async () => {
    const device = new FakeDevice();
    const renderer = await started(device);
    await pass(500);
    const before = device.drawn.length;
    await pass(500);
    expect(device.drawn.length).toBe(before);
    expect(renderer.stats.fps).toBe(0);
    renderer.set({ exposure: 1 });
    await pass(100);
    expect(device.drawn.slice(before).map((draw) => draw.pass)).toEqual(['display']);
    renderer.set({ toneMapping: 'agx' });
    await pass(100);
    expect(device.drawn.slice(before).map((draw) => draw.pass)).toEqual(['display', 'display']);
  });

  test('where a call may add many samples, a frame adds as many as it has time for, and a film at most doubles', async () => {
    const samplesAfterEachFrame = async (submitMs: number, maxSamples: number) => {
      const device = new FakeDevice();
      device.addsMany = true;
      device.submitMs = submitMs;
      const samples: number[] = [];
      const renderer = await started(device, {
        settings: { maxSamples },
        onFrame: (stats) => samples.push(stats.samples),
      });
      await pass(1500);
      renderer.dispose();
      return samples;
    };
    const fast = await samplesAfterEachFrame(1, 300);
    expect(fast.slice(0, 6)).toEqual([0, 1, 2, 4, 8, 16]);
    expect(fast.at(-1)).toBe(300);
    const steps = fast.slice(1).map((count, k) => count - fast[k]!);
    expect(Math.max(...steps)).toBeLessThanOrEqual(64);
    const slow = await samplesAfterEachFrame(40, 300);
    expect(slow.slice(0, 6)).toEqual([0, 1, 2, 3, 4, 5]);
  });

  test('exposure takes hold while samples are still added', async () => {
    const device = new FakeDevice();
    device.submitMs = 400;
    const renderer = await started(device, { settings: { maxSamples: 1000 } });
    await pass(3000);
    const shown = device.count('display');
    renderer.set({ exposure: 1 });
    await pass(20);
    expect(device.count('display')).toBe(shown + 1);
  });

  test('a device whose work takes no time by the clock is no trap for the controller', async () => {
    const device = new FakeDevice();
    device.finished = () => Promise.resolve();
    const renderer = await started(device, { settings: { adaptive: true } });
    for (let i = 0; i < 20; i++) {
      renderer.time += 0.1;
      await pass(20);
    }
    await pass(500);
    expect([renderer.stats.samples, renderer.stats.filmWidth]).toEqual([3, 64]);
  });

  test('the film that is read is the integrator’s, or nobody’s', async () => {
    const device = new FakeDevice();
    device.compileMs.classic = 200;
    const renderer = await started(device);
    await pass(50);
    const reading = renderer.readFilm();
    await pass(500);
    expect((await reading).pixels.length).toBe(64 * 64 * 4);
    expect(device.count('classic')).toBeGreaterThan(0);
    const other = open(new FakeDevice());
    await pass(1);
    await expect((await other).readFilm()).rejects.toThrow('Nothing has been rendered yet.');
  });
});

describe('a sample of many submits', () => {
  const heavy = { settings: { maxReflections: 64, lightSamples: 256 } };
  async function heavyStarted(device: FakeDevice) {
    device.rowMs = 4;
    const renderer = await started(device, {}, 256);
    renderer.set(heavy.settings);
    await pass(1000);
    return renderer;
  }

  test('no frame begins within another', async () => {
    const device = new FakeDevice();
    const renderer = await heavyStarted(device);
    for (let i = 0; i < 20; i++) {
      renderer.time += 0.1;
      void renderer.render();
      await pass(70);
    }
    let row = 0;
    for (const { pass: label, firstRow, rows } of device.drawn) {
      if (label !== 'classic') continue;
      expect([row, 0], 'the next rows, or a new sample').toContain(firstRow);
      row = (firstRow + rows) % 256;
    }
  });

  test('another scene interrupts it; many changes in a row do not starve the picture', async () => {
    const device = new FakeDevice();
    const renderer = await heavyStarted(device);
    void renderer.setScene(scenes[1]!);
    renderer.set({ maxReflections: 0, lightSamples: 1 });
    await pass(400);
    expect(renderer.scene).toBe(scenes[1]);
    const shown = new Set([renderer.stats]);
    renderer.set(heavy.settings);
    for (let i = 0; i < 400; i++) {
      renderer.time += 0.01;
      await pass(20);
      shown.add(renderer.stats);
    }
    expect(shown.size, 'frames in eight seconds of changes').toBeGreaterThan(2);
  });

  test('before the speed is known, submits are small when the settings are heavy', async () => {
    const device = new FakeDevice();
    const opening = open(device, {}, 512);
    await pass(1);
    const renderer = await opening;
    void renderer.setScene(scenes[0]!);
    renderer.set(heavy.settings);
    renderer.start();
    await pass(60);
    const first = device.drawn.find((draw) => draw.pass === 'classic')!;
    expect(first.rows).toBeLessThan(16);
  });
});

describe('models', () => {
  const place = { translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] } as const;
  const cubes = (count: number) => {
    const cube = { type: 'mesh', mesh: 'cube', material: 'white', ...place } as const;
    const shapes = Object.fromEntries(Array.from({ length: count }, (_, i) => [`cube ${i}`, cube]));
    const scene = testScene(shapes, {}, { meshes: { cube: { data: cubeMesh() } } });
    return { ...scene, render: { ...scene.render, integrator: 'path' as const } };
  };
  async function settled(renderer: GpuRenderer, scene: Scene): Promise<void> {
    let drawn = false;
    const work = renderer.setScene(scene).then(() => renderer.set({ integrator: scene.render.integrator }));
    void work.then(() => renderer.render()).then(() => (drawn = true));
    // Parts are loaded in time of their own.
    for (; !drawn; await new Promise((resolve) => setImmediate(resolve))) await pass(10);
  }

  test('what only a model used is given back when it is left, though nothing is drawn', async () => {
    const device = new FakeDevice();
    const renderer = await started(device);
    renderer.stop();
    await settled(renderer, cubes(1));
    const { buffers } = device.counts;
    void renderer.setScene(scenes[0]!);
    await pass(0);
    // Of triangles and of textures.
    expect(device.counts.buffers).toBe(buffers - 2);
    await settled(renderer, scenes[0]!);
    expect(device.counts.buffers).toBe(buffers - 2);
    await settled(renderer, cubes(1));
    expect(device.counts.buffers).toBe(buffers);
  });

  /** Kernels that do nothing and note when they would; or none, where the driver refuses them. */
  function computing(device: FakeDevice, refuses: boolean): void {
    device.compute = {
      maxRows: 1e6,
      maxThreads: 256,
      createKernels: async ({ label }) => {
        if (refuses) throw new DeviceError('refused');
        return { label };
      },
      prepare: () => {
        device.counts.buffers++;
        return { destroy: () => device.counts.buffers-- };
      },
      run: () => void device.drawn.push({ pass: 'bend', rows: 0, firstRow: 0 }),
      read: async (_data, _row, rows) => new Uint32Array(4 * rows),
    };
  }

  test('meshes are bent before they are drawn where the device can, and what that takes is given back', async () => {
    const device = new FakeDevice();
    computing(device, false);
    const renderer = await started(device);
    renderer.stop();
    await settled(renderer, cubes(1));
    const { buffers } = device.counts;
    await settled(renderer, arm(8, 6));
    const order = device.drawn.map(({ pass }) => pass).filter((pass) => pass === 'bend' || pass === 'path');
    expect(order.slice(-2)).toEqual(['bend', 'path']);
    expect(device.count('bend')).toBe(1);
    renderer.time = 1;
    await Promise.all([renderer.render(), pass(50)]);
    expect(device.count('bend')).toBe(2);
    await settled(renderer, cubes(1));
    expect([device.count('bend'), device.counts.buffers]).toEqual([2, buffers]);
  });

  test('where a driver refuses the kernels, meshes are bent on this thread', async () => {
    const device = new FakeDevice();
    computing(device, true);
    const renderer = await started(device);
    renderer.stop();
    await settled(renderer, arm(8, 6));
    expect(device.count('path')).toBe(1);
    expect(device.count('bend')).toBe(0);
  });

  test('a worker bends large meshes that move; pictures are of a time that it has come to, stills of theirs; it is ended with its scene', async () => {
    PoseWorker.all.length = 0;
    vi.stubGlobal('Worker', PoseWorker);
    const device = new FakeDevice();
    device.next = new FakeDevice();
    const renderer = await started(device);
    const model = arm(64, 36);
    await settled(renderer, model);
    renderer.playing = true;
    await pass(100);
    const [worker] = PoseWorker.all as [PoseWorker];
    // Until it is up, pictures are not held up, and what it was asked for first is too old.
    expect(renderer.time - renderer.stats.time).toBeLessThan(0.05);
    worker.work();
    await pass(100);
    for (let i = 0; i < 5; i++) {
      const { time } = renderer.stats;
      worker.work();
      await pass(100);
      expect(renderer.stats.time).toBeGreaterThan(time);
      expect(renderer.stats.time).toBeLessThan(renderer.time);
    }
    renderer.playing = false;
    const { time } = renderer;
    await pass(100);
    expect(renderer.stats.time).toBeLessThan(time);
    for (let i = 0; i < 2; i++) {
      worker.work();
      await pass(100);
    }
    expect(renderer.stats).toMatchObject({ time, samples: 3 });
    // Nothing waits for the worker that is asked for by hand.
    renderer.stop();
    renderer.time = 1.5;
    await Promise.all([renderer.render(), pass(50)]);
    expect(renderer.stats.time).toBe(1.5);
    // The device is lost while the worker is at something, the scene is another one, the end comes.
    renderer.playing = true;
    renderer.start();
    await pass(100);
    device.lose('test');
    await pass(500);
    expect(PoseWorker.all.map(({ ended }) => ended)).toEqual([true, false]);
    await settled(renderer, cubes(1));
    expect(PoseWorker.all.map(({ ended }) => ended)).toEqual([true, true]);
    await settled(renderer, { ...model });
    await pass(100);
    renderer.dispose();
    await pass(100);
    expect(PoseWorker.all.map(({ ended }) => ended)).toEqual([true, true, true]);
  });

  test('more shapes than its tables have rows for are refused, and the scene before stays', async () => {
    const device = new FakeDevice();
    const renderer = await started(device);
    await pass(50);
    const many = cubes(device.maxTextureSize + 1);
    const refused = await renderer.setScene(many).catch((error: unknown) => error);
    expect(refused).toBeInstanceOf(DeviceError);
    expect((refused as DeviceError).message).toMatch(
      /a table of 4097 rows; this device has at most 4096 \(maxTextureSize\)/,
    );
    expect(renderer.scene).toBe(scenes[0]);
  });
});

describe('loss and the end', () => {
  test('a lost device is replaced; scene, time and settings stay; an interrupted frame blocks nothing', async () => {
    const device = new FakeDevice();
    device.submitMs = 1e9;
    device.next = new FakeDevice();
    const events: string[] = [];
    const renderer = await started(device, { onDevice: (event) => events.push(event) });
    renderer.time = 2;
    await pass(100);
    device.lose('test');
    await pass(500);
    expect(events).toEqual(['lost', 'restored']);
    expect(renderer.device).toBe(device.next);
    expect([renderer.time, renderer.scene, renderer.stats.samples]).toEqual([2, scenes[0], 3]);
  });

  test('work that fails just before the loss is told is not the end', async () => {
    const device = new FakeDevice();
    device.next = new FakeDevice();
    device.finished = () => Promise.reject(new Error('lost'));
    const events: string[] = [];
    await started(device, { onDevice: (event) => events.push(event) });
    await pass(40);
    device.lose('test');
    await pass(500);
    expect(events).toEqual(['lost', 'restored']);
  });

  test('no device left: it says so once, and who waits is told', async () => {
    const device = new FakeDevice();
    const events: string[] = [];
    const renderer = await started(device, { onDevice: (event, reason) => events.push(`${event}: ${reason}`) });
    await pass(100);
    device.lose('test');
    await pass(1);
    const rendering = expect(renderer.render()).rejects.toThrow(DeviceError);
    await pass(5000);
    await rendering;
    expect(events).toEqual(['lost: test', 'failed: There is none.']);
    expect(renderer.running).toBe(false);
  });

  test('disposed of while it comes back: the new device goes too', async () => {
    const device = new FakeDevice();
    const next = new FakeDevice();
    device.next = next;
    next.compileMs = { display: 100, preview: 100 };
    const renderer = await started(device);
    await pass(100);
    device.lose('test');
    await pass(10);
    renderer.dispose();
    await pass(500);
    expect(next.destroyed).toBe(true);
    await expect(renderer.render()).rejects.toThrow('disposed');
  });

  test('disposed of while compiling and in a frame: nothing is thrown', async () => {
    const device = new FakeDevice();
    device.compileMs.classic = 100;
    const events: string[] = [];
    const renderer = await started(device, { onDevice: (event) => events.push(event) });
    await pass(40);
    renderer.dispose();
    renderer.dispose();
    await pass(1000);
    expect(events).toEqual([]);
  });
});

describe('a long picture by paths', () => {
  const long = async (device: FakeDevice) => {
    const renderer = await started(device, { settings: { maxSamples: 8 } });
    renderer.set({ integrator: 'path' });
    await pass(1000);
    return renderer;
  };

  test('its error is measured as samples double, once more at the end, and heard of when nothing is drawn any more', async () => {
    const device = new FakeDevice();
    const renderer = await long(device);
    expect([device.count('path'), device.count('film error')]).toEqual([8, 3]);
    const { relativeError, filmSeconds, fps } = renderer.stats;
    expect([relativeError, fps]).toEqual([1, 0]);
    expect(filmSeconds).toBeGreaterThan(0);
    renderer.set({ integrator: 'classic', maxSamples: 2 });
    await pass(500);
    expect([renderer.stats.relativeError, device.count('film error')]).toEqual([null, 3]);
  });

  test('has its own figures when it is back, though a frame of the other view is finished after that', async () => {
    const device = new FakeDevice();
    const renderer = await long(device);
    const { samples, relativeError } = renderer.stats;
    device.submitMs = 100;
    renderer.set({ view: 'depth' });
    await pass(40);
    renderer.set({ view: 'picture' });
    await pass(500);
    expect(renderer.stats).toMatchObject({ samples, relativeError, fps: 0 });
  });

  test('outlasts a look at another view, and goes on where it was', async () => {
    const device = new FakeDevice();
    const renderer = await long(device);
    const { textures } = device.counts;
    for (const view of ['depth', 'normal', 'picture'] as const) {
      renderer.set({ view });
      await pass(500);
    }
    expect([device.count('path'), renderer.stats.samples, renderer.stats.relativeError]).toEqual([8, 8, 1]);
    expect(device.drawn.at(-1)!.pass).toBe('display');
    renderer.set({ maxSamples: 10 });
    await pass(500);
    expect([device.count('path'), renderer.stats.samples]).toEqual([10, 10]);
    // The table of colours for numbers stays.
    expect(device.counts.textures).toBe(textures + 1);
  });

  test('begins anew when the world has changed meanwhile', async () => {
    const device = new FakeDevice();
    const renderer = await long(device);
    const { textures } = device.counts;
    renderer.set({ view: 'depth' });
    await pass(500);
    renderer.time = 1;
    await pass(500);
    renderer.set({ view: 'picture' });
    await pass(500);
    expect([device.count('path'), renderer.stats.samples]).toEqual([16, 8]);
    expect(device.counts.textures).toBe(textures + 1);
  });
});

test('a scene with meshes, which the classic kernels cannot trace, is refused, and the one before stays', async () => {
  const renderer = await started(new FakeDevice());
  const at = { translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] } as const;
  const cube = { type: 'mesh', mesh: 'cube', material: 'white', ...at } as const;
  const scene = testScene({ cube }, {}, { meshes: { cube: { data: cubeMesh() } } });
  await expect(renderer.setScene(scene)).rejects.toThrow(UntraceableSceneError);
  expect(renderer.scene).toBe(scenes[0]);
});
