/**
 * Makes the pictures of README.md and docs/ with the built studio: `npm run build`, then `npm run media`. `npm run media -- NAME …` makes
 * only these. The same sources give the same files: fixed seeds, fixed times, and SwiftShader's arithmetic.
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium, type Page } from '@playwright/test';
import gifenc from 'gifenc';
import { filmToSrgb } from '../packages/renderer/src/display/srgb.ts';
import type { Camera, Renderer, RendererSettings } from '../packages/renderer/src/index.ts';
import { studioFolder } from './build-studio.mjs';
import { chromiumFlags } from './chromium.mjs';
import { ensureChromium } from './install-chromium.mjs';
import { encodePng, type Picture } from './png.ts';
import { serveFolders } from './static-server.mjs';

const folder = fileURLToPath(new URL('../docs/media', import.meta.url));

type SceneId = 'cube-room' | 'mirror-blocks' | 'moving-shadows' | 'materials';
/** One picture to take. */
interface Shot {
  readonly scene: SceneId;
  readonly width: number;
  readonly height: number;
  /** Seconds of scene time. */
  readonly time: number;
  /** Samples in each pixel. */
  readonly filmSamples: number;
  readonly settings?: Partial<RendererSettings>;
  readonly camera?: Partial<Camera>;
}
type Shooter = (shot: Shot) => Promise<Picture>;

/** 25 points on each light: small highlights in mirrors are discs and not 9 dots. */
const LARGE = { width: 960, height: 600, filmSamples: 16, settings: { lightSamples: 25 } } as const;

const stills: Readonly<Record<string, (shoot: Shooter) => Promise<Picture>>> = {
  'cube-room': (shoot) => shoot({ ...LARGE, scene: 'cube-room', time: 8.2 }),
  'mirror-blocks': (shoot) => shoot({ ...LARGE, scene: 'mirror-blocks', time: 1.3 }),
  'moving-shadows': (shoot) => shoot({ ...LARGE, scene: 'moving-shadows', time: 1.3 }),
  materials,
  reflections,
  penumbra,
};

/** Closer than the scene's own camera, which leaves room for the page. */
function materials(shoot: Shooter): Promise<Picture> {
  return shoot({
    scene: 'materials',
    time: 0,
    width: 640,
    height: 300,
    filmSamples: 64,
    camera: { verticalFov: 30 },
  });
}

/** The same mirrors with 1, 2 and 10 reflections, side by side. */
function reflections(shoot: Shooter): Promise<Picture> {
  const camera = { eye: [2.4, 2.6, 7.6], target: [-0.62, 1.05, -0.6], verticalFov: 21 } as const;
  const view = { scene: 'mirror-blocks', time: 1.3, width: 320, height: 400, filmSamples: 16, camera } as const;
  return sideBySide(
    shoot,
    [1, 2, 10].map((maxReflections) => ({ ...view, settings: { maxReflections } })),
  );
}

/** The same shadow's edge with 1, 9 and 64 points on each light, side by side. */
function penumbra(shoot: Shooter): Promise<Picture> {
  const camera = { eye: [0.4, 1.6, 2.6], target: [1.2, 0.1, 0], verticalFov: 30 } as const;
  const view = { scene: 'moving-shadows', time: 0, width: 320, height: 300, filmSamples: 16, camera } as const;
  return sideBySide(
    shoot,
    [1, 9, 64].map((lightSamples) => ({ ...view, settings: { lightSamples } })),
  );
}

/** Pictures of one size in a row, parted by white lines. */
async function sideBySide(shoot: Shooter, shots: readonly Shot[]): Promise<Picture> {
  const { width, height } = shots[0]!;
  const stride = width * shots.length;
  const rgba = new Uint8Array(stride * height * 4);
  for (const [n, shot] of shots.entries()) {
    const part = await shoot(shot);
    for (let y = 0; y < height; y++) {
      const at = (y * stride + n * width) * 4;
      rgba.set(part.rgba.subarray(y * width * 4, (y + 1) * width * 4), at);
      if (n > 0) rgba.fill(255, at, at + LINE * 4);
    }
  }
  return { width: stride, height, rgba };
}
/** Width of the line between two pictures, pixels. */
const LINE = 2;

/** The three scenes one after another, and the second of scene time that each begins with. */
const REEL = [
  ['cube-room', 7.4],
  ['mirror-blocks', 1.2],
  ['moving-shadows', 0.5],
] as const;
const FRAMES = 24;
/** Milliseconds; GIF counts in hundredths of a second. */
const FRAME_MS = 70;

async function animation(shoot: Shooter): Promise<Uint8Array> {
  const gif = gifenc.GIFEncoder();
  for (const [scene, start] of REEL) {
    const frames: Picture[] = [];
    for (let n = 0; n < FRAMES; n++) {
      const time = start + (n * FRAME_MS) / 1000;
      frames.push(await shoot({ scene, width: 360, height: 225, time, filmSamples: 8 }));
    }
    addFrames(gif, frames);
  }
  gif.finish();
  return gif.bytes();
}

/** How far a pixel, 0 … 255 a channel, may be from what stands there from the frame before and still be left alone. */
const LEAVE_ALONE = 3;

/** Adds the frames of one scene: one palette for all of them, and only the pixels that changed. */
function addFrames(gif: ReturnType<typeof gifenc.GIFEncoder>, frames: readonly Picture[]): void {
  const { width, height } = frames[0]!;
  const some = frames.filter((_, n) => n % 4 === 0).flatMap(({ rgba }) => [...rgba]);
  const palette = gifenc.quantize(Uint8Array.from(some), 255, { format: 'rgb565' });
  const clear = palette.length;
  const shown = new Uint8Array(width * height * 4);
  frames.forEach((frame, n) => {
    const { rgba } = frame;
    const index = gifenc.applyPalette(dithered(frame), palette, 'rgb565');
    for (let p = 0; p < width * height; p++) {
      const off = [0, 1, 2].map((c) => Math.abs(rgba[p * 4 + c]! - shown[p * 4 + c]!));
      if (n > 0 && Math.max(...off) <= LEAVE_ALONE) index[p] = clear;
      else shown.set(rgba.subarray(p * 4, p * 4 + 4), p * 4);
    }
    gif.writeFrame(index, width, height, {
      palette: [...palette, [0, 0, 0]],
      delay: FRAME_MS,
      transparent: n > 0,
      transparentIndex: clear,
      dispose: 1,
      repeat: 0,
    });
  });
}

/** Distance between the darkest and the lightest that dithering makes of one grey, 0 … 255. */
const DITHER = 10;

/** Bayer's ordered dithering, so that 255 colours show no bands. It stands still, so what is at rest stays so. */
function dithered({ width, rgba }: Picture): Uint8ClampedArray {
  return Uint8ClampedArray.from(rgba, (byte, k) => {
    const [x, y] = [(k >> 2) % width, Math.floor((k >> 2) / width)];
    return byte + (bayer(x, y) - 0.5) * DITHER;
  });
}

/** The 8 × 8 matrix of thresholds, 0 … 1: bits of x ^ y and y, in reverse order and interleaved. */
function bayer(x: number, y: number): number {
  let threshold = 0;
  for (let bit = 0; bit < 3; bit++) {
    threshold = (threshold << 2) | ((((x ^ y) >> bit) & 1) << 1) | ((y >> bit) & 1);
  }
  return (threshold + 0.5) / 64;
}

/** Opens the studio without its controls; what it shows is taken from its film. */
function shooter(page: Page, origin: string): Shooter {
  let open = '';
  return async ({ scene, width, height, time, filmSamples, settings, camera }) => {
    const wanted = `${scene} ${width} × ${height}`;
    if (wanted !== open) {
      await page.setViewportSize({ width, height });
      await page.goto(`${origin}/?scene=${scene}&backend=webgl2&ui=0&paused=1&adaptive=0&scale=1&lang=en`);
      await page.waitForFunction(() => window.mirrorball?.renderer != null);
      open = wanted;
    }
    const view = { time, filmSamples, settings: settings ?? {}, camera: camera ?? null };
    const film = await page.evaluate(async ({ time, filmSamples, settings, camera }) => {
      const renderer = window.mirrorball.renderer!;
      renderer.stop();
      const { maxReflections, lightSamples } = renderer.scene!.render;
      renderer.set({ maxReflections, lightSamples, comparison: null, framing: null, ...settings });
      renderer.resetCamera();
      renderer.time = time;
      if (camera) renderer.camera = { ...renderer.camera, ...camera };
      for (let sample = 0; sample < filmSamples; sample++) await renderer.render();
      const { width, height, pixels } = await renderer.readFilm();
      const bytes = new Uint8Array(pixels.buffer);
      let text = '';
      for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
      return { width, height, samples: pixels[3], base64: btoa(text), look: renderer.settings };
    }, view);
    if (film.width !== width || film.height !== height || film.samples !== filmSamples) {
      throw new Error(`A film of ${film.width} × ${film.height} with ${film.samples} samples came for ${wanted}.`);
    }
    const floats = new Float32Array(Uint8Array.from(Buffer.from(film.base64, 'base64')).buffer);
    return { width, height, rgba: filmToSrgb(floats, film.look.exposure, film.look.toneMapping) };
  };
}

declare global {
  interface Window {
    mirrorball: { readonly renderer: Renderer | null };
  }
}

function write(name: string, bytes: Uint8Array): void {
  writeFileSync(join(folder, name), bytes);
  console.log(`docs/media/${name}: ${(bytes.length / 1000).toFixed(0)} KB`);
}

const wanted = process.argv.slice(2);
const names = [...Object.keys(stills), 'animation'];
const unknown = wanted.filter((name) => !names.includes(name));
if (unknown.length > 0) throw new Error(`There is no ${unknown.join(', ')}; there are ${names.join(', ')}.`);
const isWanted = (name: string) => wanted.length === 0 || wanted.includes(name);

mkdirSync(folder, { recursive: true });
const browser = await chromium.launch({ executablePath: await ensureChromium(), args: chromiumFlags });
const server = await serveFolders({ mounts: { '/': studioFolder } });
try {
  const shoot = shooter(await browser.newPage(), `http://127.0.0.1:${server.port}`);
  for (const [name, take] of Object.entries(stills)) {
    if (isWanted(name)) write(`${name}.png`, encodePng(await take(shoot)));
  }
  if (isWanted('animation')) write('mirrorball.gif', await animation(shoot));
} finally {
  await browser.close();
  await server.close();
}
