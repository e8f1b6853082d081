import { compileTrack, evaluateTrack } from './keyframes.ts';
import { playingClip } from './node-transforms.ts';
import type { Clip, SampledTrack } from './nodes.ts';
import { clipTime, evaluateSampled, isRotation, widthOf } from './sampled-track.ts';
import type { Camera, Scene, Track, Vec3 } from './scene.ts';
import { type AnimationTarget, resolveClipTarget, resolveTarget, type Section } from './targets.ts';
import { isDirection, mendCamera, mendScale, spansPlane } from './well-formed.ts';

/** A scene with its tracks made ready: gives the scene at any time (seconds, finite). */
export type CompiledAnimation = (time: number) => Scene;

type Item = Record<string, unknown>;
/** Moves one property of a copy that nobody else has. */
type Channel = (now: Item, time: number) => void;

/** All that moves of one thing. */
interface MovingItem {
  readonly section: Section;
  readonly name: string | null;
  readonly rest: Item;
  readonly channels: Channel[];
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
  const move = ({ section, name }: { section: Section; name: string | null }, channel: Channel): void => {
    const key = `${section}/${name ?? ''}`;
    const rest = (name === null ? scene[section] : (scene[section] as Record<string, unknown>)[name]) as Item;
    const item = items.get(key) ?? { section, name, rest, channels: [] };
    item.channels.push(channel);
    items.set(key, item);
  };
  scene.animation.forEach((track, index) => {
    const target = resolveTarget(scene, track.target);
    if (target === null || track.keys.length === 0) {
      throw new Error(`Track ${index} of the scene "${scene.name}" moves nothing: "${track.target}".`);
    }
    move(target, channelOfTrack(track, target));
  });
  const clip = playingClip(scene);
  for (const track of clip?.tracks ?? []) {
    const target = resolveClipTarget(scene, track.target);
    if (target === null || track.times.length === 0) {
      throw new Error(`A track of the clip "${scene.clip}" moves nothing: "${track.target}".`);
    }
    move(target, channelOfSamples(clip!, track, target.path, typeof target.value === 'number'));
  }
  return [...items.values()];
}

function channelOfTrack(track: Track, { property, component }: AnimationTarget): Channel {
  const compiledTrack = compileTrack(track);
  const out: number[] = [0, 0, 0];
  return (now, time) => {
    evaluateTrack(compiledTrack, time, out);
    if (component !== null) {
      const triple = [...(now[property] as Vec3)] as [number, number, number];
      triple[component] = out[0]!;
      now[property] = triple;
    } else now[property] = compiledTrack.components === 1 ? out[0]! : [out[0]!, out[1]!, out[2]!];
  };
}

function channelOfSamples(clip: Clip, track: SampledTrack, path: readonly string[], single: boolean): Channel {
  const [width, rotation] = [widthOf(track), isRotation(track)];
  const [first, ...deeper] = path as [string, ...string[]];
  return (now, time) => {
    const out = zeros(width);
    evaluateSampled(track, width, rotation, clipTime(clip, time), out, 0);
    const value = single ? out[0] : out;
    now[first] = deeper.length === 0 ? value : replaced(now[first], deeper, value);
  };
}

/** A thousand nodes move in a frame: literals are what engines make fastest. */
function zeros(length: number): number[] {
  if (length === 3) return [0, 0, 0];
  return length === 4 ? [0, 0, 0, 0] : new Array<number>(length).fill(0);
}

/** A copy of the group with this value at the end of the path. */
function replaced(group: unknown, [key, ...deeper]: readonly string[], value: unknown): unknown {
  if (key === undefined) return value;
  return { ...(group as Item), [key]: replaced((group as Item)[key], deeper, value) };
}

function itemAt(item: MovingItem, time: number): Item {
  const now: Item = { ...item.rest };
  for (const channel of item.channels) channel(now, time);
  return item.section === 'nodes' ? now : mend(now, item);
}

/** Keys may be good and a moment between them not: a normal through zero, an eye that meets its target. */
function mend(now: Item, { section, rest }: MovingItem): Item {
  if (section === 'camera' || section === 'cameras')
    return mendCamera(now as unknown as Camera, rest as unknown as Camera) as unknown as Item;
  const straight = (direction: unknown) => direction === undefined || isDirection(direction as Vec3);
  if (!straight(now.normal)) return { ...now, normal: rest.normal! };
  if (!straight(now.direction)) return { ...now, direction: rest.direction! };
  if (now.type === 'quad' && !spansPlane(now.u as Vec3, now.v as Vec3)) return { ...now, u: rest.u!, v: rest.v! };
  if (now.type === 'mesh') return { ...now, scale: mendScale(now.scale as Vec3) };
  return now;
}
