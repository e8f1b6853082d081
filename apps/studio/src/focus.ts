import type { Camera, Renderer } from 'mirrorball';
import { stopMotion } from './camera-motion.ts';
import { loadSceneTools } from './load-scene-tools.ts';
import { dismiss, notify } from './notices.ts';
import { renderer, viewMoved } from './state.ts';

/** The lens of the camera in use: its aperture, and where it is sharp, by a number or by pointing at something. */

/** Where the pointer was last seen over the picture, in shares of its width and height; null: nowhere. */
let pointed: readonly [x: number, y: number] | null = null;

export function pointAt(place: readonly [x: number, y: number] | null): void {
  pointed = place;
}

/** Whether focus makes a difference: only paths go through a lens, and a panorama has none. */
const hasLens = ({ camera, drawnBy }: Renderer): boolean =>
  drawnBy === 'path' && (camera.aperture ?? 0) > 0 && camera.projection !== 'equirectangular';

export function changeLens(change: Pick<Camera, 'aperture' | 'focusDistance'>): void {
  const target = renderer.peek();
  if (!target?.scene) return;
  target.camera = { ...target.camera, ...change };
  viewMoved.value = true;
}

/** Focuses on what is seen at this place; says so when there is nothing. */
export async function focusAt([x, y]: readonly [x: number, y: number]): Promise<void> {
  const target = renderer.peek();
  if (!target?.scene || !hasLens(target)) return;
  stopMotion();
  const { depthAt } = await loadSceneTools();
  const depth = depthAt(target, x, y);
  if (depth === null) {
    notify('focus', (t) => t.noticeNothingInFocus);
    return;
  }
  dismiss('focus');
  changeLens({ focusDistance: depth });
}

/** By the keyboard: where the pointer is, else in the middle of what the page shows of the scene. */
export function focusHere(): Promise<void> {
  return focusAt(pointed ?? renderer.peek()?.settings.framing?.center ?? [0.5, 0.5]);
}
