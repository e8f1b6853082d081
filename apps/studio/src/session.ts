import { batch, effect } from '@preact/signals';
import { type Backend, type Camera, createRenderer, type FrameStats, focusOf, type Renderer } from 'mirrorball';
import { dismiss, notify, reasonOf } from './notices.ts';
import { createCanvas, describePicture } from './stage.ts';
import {
  cannotCompare,
  compiling,
  integrator,
  isStill,
  lens,
  playing,
  renderer,
  shown,
  speed,
  stats,
  switchingTo,
  time,
  viewMoved,
  wantedSettings,
} from './state.ts';

/** The life of a renderer in this page: opened, followed by the settings, replaced by one on another backend. */

/** Whether the still picture is wished for, so that it is not excused. */
let chosenCpu = false;
let imageSamples = 0;

/** Samples drawn so far for each pixel of the whole canvas; a film of fewer pixels counts by its share. */
export const drawnImageSamples = (): number => imageSamples;

function sampleCounter(): (frame: FrameStats) => void {
  let before = 0;
  return ({ samples, filmWidth, filmHeight, canvasWidth, canvasHeight }) => {
    const fresh = samples > before ? samples - before : samples;
    before = samples;
    imageSamples += (fresh * filmWidth * filmHeight) / (canvasWidth * canvasHeight || 1);
  };
}

/** A renderer on a fresh canvas. Rejects, and leaves no canvas behind, when it cannot be had. */
export async function openRenderer(backend: Backend | 'auto'): Promise<Renderer> {
  const canvas = createCanvas();
  const count = sampleCounter();
  try {
    return await createRenderer(canvas, {
      backend,
      settings: wantedSettings.peek(),
      onFrame(frame) {
        count(frame);
        document.getElementById('loading')?.remove();
      },
      onDevice(event, reason) {
        if (canvas !== renderer.peek()?.canvas) return;
        if (event === 'restored') dismiss('device');
        if (event === 'lost') notify('device', (t) => t.noticeLost);
        if (event === 'failed') void deviceGone(reason);
      },
    });
  } catch (error) {
    canvas.remove();
    throw error;
  }
}

/** What is left to draw with takes over: the other graphics interface, else the CPU. */
async function deviceGone(reason: string): Promise<void> {
  notify('device', (t) => t.noticeFailed(reason));
  const gone = renderer.peek()?.backend;
  for (const backend of ['webgpu', 'webgl2', 'cpu'] as const)
    if (backend !== gone && (await switchBackend(backend))) return;
}

/** Gives `next` all that the page shows now: scene, settings, view and time. It must not be running. */
async function carryOver(next: Renderer, from: Renderer | null): Promise<void> {
  const scene = shown.peek()?.scene;
  if (scene) await next.setScene(scene);
  next.set(wantedSettings.peek());
  if (from && viewMoved.peek()) next.camera = from.camera;
  next.time = from ? from.time : time.peek();
  next.playing = playing.peek();
  next.speed = speed.peek();
}

function discard(unwanted: Renderer): void {
  unwanted.dispose();
  unwanted.canvas.remove();
}

/** A renderer that shows what the page shows, its first picture not yet drawn. */
async function prepare(backend: Backend | 'auto', from: Renderer | null): Promise<Renderer> {
  const next = await openRenderer(backend);
  try {
    await carryOver(next, from);
    return next;
  } catch (error) {
    discard(next);
    throw error;
  }
}

/** Draws the first picture, and once more should another scene have been chosen meanwhile. */
async function drawFirst(next: Renderer, from: Renderer | null): Promise<void> {
  try {
    await next.render();
    if (next.scene === shown.peek()?.scene) return;
    await carryOver(next, from);
    await next.render();
  } catch (error) {
    discard(next);
    throw error;
  }
}

/** Lets another backend draw. The old one goes on until the new one has a picture, and stays, with false, if there is none. */
export async function switchBackend(backend: Backend): Promise<boolean> {
  const old = renderer.peek();
  if (switchingTo.peek() !== null || old?.backend === backend) return false;
  switchingTo.value = backend;
  if (backend === 'cpu') notify('backend', (t) => t.noticeCpuComputes);
  try {
    const next = await prepare(backend, old);
    await drawFirst(next, old);
    dismiss('backend');
    takeOver(next, old);
    return true;
  } catch (error) {
    notify('backend', (t) => t.noticeSwitchFailed(t.backendNames[backend], reasonOf(error)));
    return false;
  } finally {
    switchingTo.value = null;
  }
}

function takeOver(next: Renderer, old: Renderer | null): void {
  const still = next.backend === 'cpu';
  if (old) {
    // The old one drew on while the new one was made ready.
    if (viewMoved.peek()) next.camera = old.camera;
    if (!still) next.time = old.time;
    old.dispose();
    if (document.activeElement === old.canvas) next.canvas.focus();
    old.canvas.remove();
  }
  dismiss('device');
  if (still) playing.value = false;
  if (!document.hidden) next.start();
  renderer.value = next;
}

/** Starts on the wished backend, or on whatever there is; takes up the scene in `shown`. */
export async function openSession(backend: Backend | null): Promise<Renderer> {
  let first: Renderer;
  chosenCpu = backend === 'cpu';
  try {
    first = await prepare(backend ?? 'auto', null);
  } catch (error) {
    if (backend === null) throw error;
    first = await prepare('auto', null);
    notify('backend', (t) => t.noticeStartFailed(t.backendNames[backend], reasonOf(error)));
  }
  takeOver(first, null);
  return first;
}

/** Hands on to the renderer whatever changes in the page's state, and nothing that did not change. */
export function followState(): void {
  effect(() => {
    const settings = wantedSettings.value;
    const current = renderer.value?.settings;
    if (!current) return;
    const changed = Object.entries(settings).filter(([key, value]) => current[key as keyof typeof settings] !== value);
    if (changed.length > 0) renderer.peek()?.set(Object.fromEntries(changed));
  });
  effect(() => {
    if (!renderer.value) return;
    renderer.value.playing = playing.value;
    renderer.value.speed = speed.value;
  });
  effect(() => renderer.value?.canvas.setAttribute('aria-label', describePicture()));
  effect(() => {
    if (renderer.value?.backend !== 'cpu') return dismiss('cpu');
    notify('cpu', (t) => (chosenCpu ? t.noticeCpuChosen : t.noticeCpuAlone));
  });
  effect(() => {
    const paths = integrator.value === 'path';
    if (paths && isStill.value) notify('path', (t) => t.noticeCpuShowsClassic);
    else if (!paths && shown.value?.scene.render.integrator === 'path') notify('path', (t) => t.noticeMadeForPaths);
    else dismiss('path');
  });
  effect(() => {
    if (cannotCompare.value === null) dismiss('compare');
  });
}

export function chooseBackend(backend: Backend): Promise<boolean> {
  chosenCpu = backend === 'cpu';
  return switchBackend(backend);
}

/** Nothing is written when nothing has changed, so that nothing is drawn again. */
function takeLens(camera: Camera): void {
  const { aperture = 0, projection } = camera;
  const next = { aperture, focus: focusOf(camera), panorama: projection === 'equirectangular' };
  if (JSON.stringify(next) !== JSON.stringify(lens.peek())) lens.value = next;
}

/** Takes the figures four times a second, and stops drawing while nobody can see it. */
export function followRenderer(): void {
  setInterval(() => {
    const now = renderer.peek();
    if (!now || document.hidden) return;
    batch(() => {
      stats.value = { ...now.stats };
      compiling.value = now.compiling;
      time.value = now.time;
      if (now.scene) takeLens(now.camera);
    });
  }, 250);
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) renderer.peek()?.stop();
    else renderer.peek()?.start();
  });
}
