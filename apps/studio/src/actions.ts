import { batch, signal } from '@preact/signals';
import type { Problem, Scene } from 'mirrorball';
import { stopMotion } from './camera-motion.ts';
import { comparisonModes } from './comparison.ts';
import { dismiss, notify, reasonOf } from './notices.ts';
import { builtInScene, readSceneFile, sortFiles } from './scene-files.ts';
import * as state from './state.ts';

/** What a person can do, whether by the panel, the keys or a dropped file. */

/** The file that could not be opened, and all that is wrong with it. */
export const refusedFile = signal<{ name: string; problems: readonly Problem[] } | null>(null);

/** Makes a scene the one on show, with its own render settings, view and start. */
export function takeScene(next: { id: string; scene: Scene; fileName?: string }): void {
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

function show(next: { id: string; scene: Scene; fileName?: string }): void {
  stopMotion();
  const renderer = state.renderer.peek();
  const shownNow = renderer?.setScene(next.scene);
  renderer?.resetCamera();
  takeScene(next);
  dismiss('file');
  shownNow?.catch((error: unknown) => notify('file', (t) => t.noticeSceneFailed(reasonOf(error))));
}

export function chooseScene(id: string): void {
  show(builtInScene(id));
}

/** Opens a scene file, with those that it names; when it is broken, says all that is wrong and leaves the scene as it is. */
export async function openSceneFiles(files: readonly File[]): Promise<void> {
  const { scene: file, others } = sortFiles(files);
  if (!file) return;
  try {
    const read = await readSceneFile(file, others);
    if (read.ok) {
      show({ id: 'file', scene: read.scene, fileName: file.name });
      if (read.notes.length > 0) notify('file', () => read.notes.join(' '));
    } else refusedFile.value = { name: file.name, problems: read.problems };
  } catch (error) {
    notify('file', (t) => t.fileUnreadable(file.name, reasonOf(error)));
  }
}

export function changeReflections(by: number): void {
  if (state.integrator.peek() !== 'classic' || state.comparing.peek() === 'reflections') return;
  state.reflections.value = Math.min(Math.max(state.reflections.peek() + by, 0), 64);
}

export function nextComparison(): void {
  if (state.integrator.peek() !== 'classic') return;
  const at = comparisonModes.indexOf(state.comparisonMode.peek());
  state.comparisonMode.value = comparisonModes[(at + 1) % comparisonModes.length]!;
}

export function togglePlaying(): void {
  if (state.isStill.peek()) return;
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
  return Math.max(...ends, 0) || 10;
}
