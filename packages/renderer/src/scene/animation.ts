import { type CompiledTrack, compileTrack, evaluateTrack } from './keyframes.ts';
import type { Camera, Scene, Vec3 } from './scene.ts';
import { type AnimationTarget, resolveTarget } from './targets.ts';
import { isDirection, mendCamera, mendScale, spansPlane } from './well-formed.ts';

/** A scene with its tracks made ready: gives the scene at any time (seconds, finite). */
export type CompiledAnimation = (time: number) => Scene;

type Item = Record<string, number | Vec3 | string | boolean>;

/** All that moves of one thing. */
interface MovingItem {
  readonly section: AnimationTarget['section'];
  readonly name: string | null;
  readonly rest: Item;
  readonly channels: { readonly target: AnimationTarget; readonly track: CompiledTrack }[];
}

const compiled = new WeakMap<Scene, CompiledAnimation>();

/**
 * The scene at a time, seconds: the same kind of plain data with every track at its value. Pure; what does not move is
 * shared with `scene` (same object), and a scene without tracks is returned as it is. A scene is immutable: its tracks
 * are compiled at the first call and remembered.
 *
 * Throws a RangeError when the time is not finite, and an Error when a track points at nothing that can move
 * (`parseScene` lets no such scene through).
 */
export function sceneAt(scene: Scene, time: number): Scene {
  let animation = compiled.get(scene);
  if (animation === undefined) {
    animation = compileAnimation(scene);
    compiled.set(scene, animation);
  }
  return animation(time);
}

/** As `sceneAt`, for callers who keep the compiled form themselves. */
export function compileAnimation(scene: Scene): CompiledAnimation {
  const items = movingItems(scene);
  return (time) => {
    if (!Number.isFinite(time))
      throw new RangeError(`The scene's time must be a finite number of seconds, not ${time}.`);
    if (items.length === 0) return scene;
    const moved: Record<string, unknown> = { ...scene };
    for (const item of items) {
      const now = itemAt(item, time);
      if (item.name === null) {
        moved[item.section] = now;
        continue;
      }
      if (moved[item.section] === scene[item.section]) {
        moved[item.section] = Object.assign(Object.create(null), scene[item.section]);
      }
      (moved[item.section] as Record<string, Item>)[item.name] = now;
    }
    return moved as unknown as Scene;
  };
}

function movingItems(scene: Scene): MovingItem[] {
  const items = new Map<string, MovingItem>();
  scene.animation.forEach((track, index) => {
    const target = resolveTarget(scene, track.target);
    if (target === null || track.keys.length === 0) {
      throw new Error(`Track ${index} of the scene "${scene.name}" moves nothing: "${track.target}".`);
    }
    const { section, name } = target;
    const key = `${section}/${name ?? ''}`;
    const rest = (name === null ? scene[section] : (scene[section] as Record<string, unknown>)[name]) as Item;
    const item = items.get(key) ?? { section, name, rest, channels: [] };
    item.channels.push({ target, track: compileTrack(track) });
    items.set(key, item);
  });
  return [...items.values()];
}

function itemAt(item: MovingItem, time: number): Item {
  const now: Item = { ...item.rest };
  const out: number[] = [0, 0, 0];
  for (const { target, track } of item.channels) {
    evaluateTrack(track, time, out);
    const { property, component } = target;
    if (component !== null) {
      const triple = [...(now[property] as Vec3)] as [number, number, number];
      triple[component] = out[0]!;
      now[property] = triple;
    } else now[property] = track.components === 1 ? out[0]! : [out[0]!, out[1]!, out[2]!];
  }
  return mend(now, item);
}

/** Keys may be good and a moment between them not: a normal through zero, an eye that meets its target. */
function mend(now: Item, { section, rest }: MovingItem): Item {
  if (section === 'camera') return mendCamera(now as unknown as Camera, rest as unknown as Camera) as unknown as Item;
  const straight = (direction: unknown) => direction === undefined || isDirection(direction as Vec3);
  if (!straight(now.normal)) return { ...now, normal: rest.normal! };
  if (!straight(now.direction)) return { ...now, direction: rest.direction! };
  if (now.type === 'quad' && !spansPlane(now.u as Vec3, now.v as Vec3)) return { ...now, u: rest.u!, v: rest.v! };
  if (now.type === 'mesh') return { ...now, scale: mendScale(now.scale as Vec3) };
  return now;
}
