import { parsePointer } from './pointer.ts';
import type { Scene, Vec3 } from './scene.ts';

/** Where an animation track points: a number or a triple of numbers that may move. */
export interface AnimationTarget {
  readonly section: 'camera' | 'sky' | 'materials' | 'shapes' | 'lights';
  /** Name of the material, shape or light; null in `camera` and `sky`. */
  readonly name: string | null;
  readonly property: string;
  /** 0, 1 or 2 when only one number of a triple moves, else null. */
  readonly component: 0 | 1 | 2 | null;
  /** What stands there when nothing moves. */
  readonly value: number | Vec3;
}

const SINGLE = ['camera', 'sky'];
const NAMED = ['materials', 'shapes', 'lights'];
const COMPONENTS: Readonly<Record<string, 0 | 1 | 2>> = { '0': 0, '1': 1, '2': 2 };

/** What stands at that own key, or undefined; safe for any key of any value. */
function own(value: unknown, key: string): unknown {
  return typeof value === 'object' && value !== null && Object.hasOwn(value, key)
    ? (value as Record<string, unknown>)[key]
    : undefined;
}

const isTriple = (value: unknown): value is Vec3 => Array.isArray(value) && value.length === 3;

/**
 * Finds what a track points at. Names, types, `visible`, `render` and `version` cannot move.
 * Returns null when the pointer leads to nothing that may move.
 */
export function resolveTarget(scene: Pick<Scene, AnimationTarget['section']>, pointer: string): AnimationTarget | null {
  const segments = parsePointer(pointer);
  if (segments === null) return null;
  const section = segments.shift() ?? '';
  if (!SINGLE.includes(section) && !NAMED.includes(section)) return null;
  const name = NAMED.includes(section) ? (segments.shift() ?? '') : null;
  const item = name === null ? own(scene, section) : own(own(scene, section), name);
  const property = segments.shift() ?? '';
  const whole = own(item, property);
  const at = { section: section as AnimationTarget['section'], name, property };
  const last = segments.shift();
  if (segments.length > 0) return null;
  if (last === undefined) {
    return typeof whole === 'number' || isTriple(whole) ? { ...at, component: null, value: whole } : null;
  }
  const component = Object.hasOwn(COMPONENTS, last) ? COMPONENTS[last] : undefined;
  return isTriple(whole) && component !== undefined ? { ...at, component, value: whole[component] } : null;
}
