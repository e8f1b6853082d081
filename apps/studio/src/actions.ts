import { batch, effect, signal } from '@preact/signals';
import type { Problem, Renderer, Scene, SceneParts } from 'mirrorball';
import { builtInScene } from './built-in-scenes.ts';
import { polar } from './camera-controls.ts';
import { stopMotion } from './camera-motion.ts';
import { comparisonModes } from './comparison.ts';
import { loadSceneTools } from './load-scene-tools.ts';
import { dismiss, notify, reasonOf } from './notices.ts';
import { cancelOpening } from './opening/under-way.ts';
import type { Shown } from './state.ts';
import * as state from './state.ts';

/** What a person can do, whether by the panel, the keys or a dropped file. */

/** The file that could not be opened, and all that is wrong with it. */
export const refusedFile = signal<{ name: string; problems: readonly Problem[] } | null>(null);

/** Makes a scene the one on show, with its own render settings, view and start. */
export function takeScene(next: Shown): void {
  batch(() => {
    state.shown.value = next;
    state.reflections.value = next.scene.render.maxReflections;
    state.lightSamples.value = next.scene.render.lightSamples;
    state.exposure.value = next.scene.render.exposure;
    state.integrator.value = next.scene.render.integrator;
    state.maxDepth.value = next.scene.render.maxDepth;
    state.toneMapping.value = next.scene.render.toneMapping;
    state.viewMoved.value = false;
    state.time.value = 0;
  });
}

/** Rejects, and leaves everything as it is, when the scene cannot be drawn. */
export async function show(next: Shown): Promise<void> {
  const renderer = await firstRenderer();
  await renderer.prepare(next.scene);
  stopMotion();
  const drawn = renderer.setScene(next.scene);
  // What it does not take it refuses at once.
  if (renderer.scene !== next.scene) return drawn;
  takeScene(next);
  dismiss('file');
  drawn.catch((error: unknown) => notify('file', (t) => t.noticeSceneFailed(reasonOf(error))));
}

/** At its start the page may be without one for a moment. */
function firstRenderer(): Promise<Renderer> {
  return new Promise((resolve) => {
    const stop = effect(() => {
      const renderer = state.renderer.value;
      if (renderer) queueMicrotask(() => stop());
      if (renderer) resolve(renderer);
    });
  });
}

export function chooseScene(id: string): void {
  cancelOpening();
  const { scene } = builtInScene(id);
  show({ id, scene, original: scene }).catch((error: unknown) => notify('file', (t) => t.noticeSceneFailed(reasonOf(error)))); // biome-ignore format: one line
}

/** Another choice of what the scene on show has: the view, the time and the settings stay as they are. */
export async function changeScene(parts: SceneParts): Promise<void> {
  try {
    const { withParts } = await loadSceneTools();
    const now = state.shown.peek();
    const renderer = state.renderer.peek();
    if (!now || !renderer?.scene) return;
    replaceScene(renderer, { ...now, scene: withParts(renderer.scene, parts) }, parts);
  } catch (error) {
    notify('file', (t) => t.noticeSceneFailed(reasonOf(error)));
  }
}

/** As `changeScene`, for a scene that has been made of the one on show. */
export function replaceScene(renderer: Renderer, next: Shown, parts: SceneParts = {}): void {
  const { camera, time } = renderer;
  const keepsView = state.viewMoved.peek() && parts.camera === undefined;
  const drawn = renderer.setScene(next.scene);
  drawn.catch((error: unknown) => notify('file', (t) => t.noticeSceneFailed(reasonOf(error))));
  if (renderer.scene !== next.scene) return;
  renderer.set(state.wantedSettings.peek());
  if (keepsView) renderer.camera = camera;
  else state.viewMoved.value = false;
  renderer.time = parts.clip === undefined ? time : 0;
  state.shown.value = next;
}

export function changeReflections(by: number): void {
  if (state.integrator.peek() !== 'classic' || state.comparing.peek() === 'reflections') return;
  state.reflections.value = Math.min(Math.max(state.reflections.peek() + by, 0), 64);
}

/** Whether nothing can be compared now; then it is told why. */
export function tellCannotCompare(): boolean {
  const why = state.cannotCompare.peek();
  if (why) notify('compare', (t) => t[why]);
  return why !== null;
}

export function nextComparison(): void {
  if (tellCannotCompare()) return;
  const at = comparisonModes.indexOf(state.comparisonMode.peek());
  state.comparisonMode.value = comparisonModes[(at + 1) % comparisonModes.length]!;
}

export function togglePlaying(): void {
  if (state.isStill.peek() || !state.moves.peek()) return;
  state.playing.value = !state.playing.peek();
}

export function goToTime(seconds: number): void {
  const renderer = state.renderer.peek();
  if (renderer) renderer.time = seconds;
  state.time.value = seconds;
}

/** One sixtieth of a second of scene time, and then rest. */
export function stepTime(): void {
  state.playing.value = false;
  goToTime((state.renderer.peek()?.time ?? state.time.peek()) + 1 / 60);
}

export function resetView(): void {
  stopMotion();
  state.renderer.peek()?.resetCamera();
  state.viewMoved.value = false;
}

/** Everything into the picture, from the side from which it is seen now. */
export async function frameView(): Promise<void> {
  const { frameScene } = await loadSceneTools();
  const renderer = state.renderer.peek();
  if (!renderer?.scene) return;
  stopMotion();
  const { camera } = renderer;
  const { yaw, pitch } = polar(camera);
  const perspective = (camera.projection ?? 'perspective') === 'perspective';
  const framed = frameScene(renderer.scene, renderer.time, {
    azimuth: yaw,
    elevation: pitch,
    ...(perspective && { verticalFov: Math.min(camera.verticalFov, 120) }),
  });
  if (framed === null) return;
  const { aperture = 0 } = camera;
  renderer.camera = perspective ? { ...framed, aperture } : framed;
  state.viewMoved.value = true;
}

export async function toggleFullScreen(): Promise<void> {
  try {
    if (document.fullscreenElement) await document.exitFullscreen();
    else await document.documentElement.requestFullscreen();
  } catch (error) {
    notify('error', (t) => t.noticeError(reasonOf(error)));
  }
}

/** Seconds after which the scene's slowest track starts over: how far the time slider reaches. */
export function sceneDuration(scene: Scene): number {
  const ends = scene.animation.map(({ keys, repeat }) => (keys.at(-1)?.time ?? 0) * (repeat === 'ping-pong' ? 2 : 1));
  if (scene.clip !== undefined) ends.push(scene.clips?.[scene.clip]?.duration ?? 0);
  return Math.max(...ends, 0) || 10;
}
