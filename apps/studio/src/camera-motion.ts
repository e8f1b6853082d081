import { type Renderer, sceneAt } from 'mirrorball';
import { addMoves, type CameraMove, isNegligible, moveCamera, scaleMove, stillMove } from './camera-controls.ts';
import { type Wall, wallsAbout } from './eye-room.ts';
import { renderer, viewMoved } from './state.ts';
import { prefersReducedMotion } from './theme.ts';

/** Moves the view smoothly: moves are gathered, and each frame carries out a share of what is left. */

/** Seconds in which about two thirds of a move are done. */
const SMOOTHING = 0.06;
/** Moves a second while a key is held. */
export const heldRates = {
  left: { ...stillMove, yaw: -80 },
  right: { ...stillMove, yaw: 80 },
  up: { ...stillMove, pitch: 60 },
  down: { ...stillMove, pitch: -60 },
  panLeft: { ...stillMove, panX: -0.6 },
  panRight: { ...stillMove, panX: 0.6 },
  panUp: { ...stillMove, panY: 0.6 },
  panDown: { ...stillMove, panY: -0.6 },
  closer: { ...stillMove, dolly: -1.2 },
  farther: { ...stillMove, dolly: 1.2 },
} satisfies Record<string, CameraMove>;
export type HeldMove = keyof typeof heldRates;

let pending: CameraMove = stillMove;
const held = new Set<HeldMove>();
let frame = 0;
let lastTime = 0;

export function pushMove(move: Partial<CameraMove>): void {
  pending = addMoves(pending, { ...stillMove, ...move });
  wake();
}

/** Moves on while it is held; a short press gives a tenth of a second's worth at once. */
export function holdMove(name: HeldMove): void {
  if (held.has(name)) return;
  held.add(name);
  pushMove(scaleMove(heldRates[name], 0.1));
}

export const releaseMove = (name: HeldMove): boolean => held.delete(name);

export function stopMotion(): void {
  held.clear();
  pending = stillMove;
}

function wake(): void {
  if (frame !== 0) return;
  lastTime = performance.now();
  frame = requestAnimationFrame(advance);
}

function advance(now: number): void {
  const seconds = Math.min(Math.max((now - lastTime) / 1000, 0.004), 0.1);
  lastTime = now;
  frame = 0;
  if (held.size === 0 && pending === stillMove) return;
  for (const name of held) pending = addMoves(pending, scaleMove(heldRates[name], seconds));
  const share = prefersReducedMotion() || isNegligible(pending) ? 1 : 1 - Math.exp(-seconds / SMOOTHING);
  const target = renderer.peek();
  if (target?.scene) {
    target.camera = moveCamera(target.camera, scaleMove(pending, share), wallsNow(target));
    viewMoved.value = true;
  }
  pending = share === 1 ? stillMove : scaleMove(pending, 1 - share);
  if (held.size > 0 || pending !== stillMove) frame = requestAnimationFrame(advance);
}

/** The walls that the renderer's eye has about it at this moment. They may move. */
const wallsNow = ({ scene, time, camera }: Renderer): Wall[] =>
  scene ? wallsAbout(sceneAt(scene, time), camera.eye, camera.target) : [];
