import { parsePointer } from './pointer.ts';
import type { Scene, Vec3 } from './scene.ts';

/** Where an animation track points: a number or a triple of numbers that may move. */
export interface AnimationTarget {
  readonly section: Section;
  /** Name of the material, shape, light or node; null in `camera` and `sky`. */
  readonly name: string | null;
  readonly property: string;
  /** 0, 1 or 2 when only one number of a triple moves, else null. */
  readonly component: 0 | 1 | 2 | null;
  /** What stands there when nothing moves. */
  readonly value: number | Vec3;
}

/** What can move: parts of a scene, and of those that are maps from names to things, the things. */
export type Section = 'camera' | 'sky' | 'materials' | 'shapes' | 'lights' | 'nodes' | 'cameras';
const SINGLE = ['camera', 'sky'];
const NAMED = ['materials', 'shapes', 'lights', 'nodes', 'cameras'];
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

/** Where a clip's track points: a number or a list of numbers, which may lie in a group of its thing. */
export interface ClipTarget {
  readonly section: Section;
  readonly name: string | null;
  /** Keys from the thing on. */
  readonly path: readonly string[];
  readonly value: number | readonly number[];
}

const DEEPEST = 3;
const isNumbers = (value: unknown): value is readonly number[] =>
  Array.isArray(value) && value.length > 0 && value.every((item) => typeof item === 'number');

/** As `resolveTarget`, for clips: lists of any length may move, and what lies in groups, such as "/materials/m/clearcoat/weight". */
export function resolveClipTarget(scene: Pick<Scene, Section>, pointer: string): ClipTarget | null {
  const [section = '', ...segments] = parsePointer(pointer) ?? [];
  if (!SINGLE.includes(section) && !NAMED.includes(section)) return null;
  const name = NAMED.includes(section) ? (segments.shift() ?? '') : null;
  if (segments.length === 0 || segments.length > DEEPEST) return null;
  const item = name === null ? own(scene, section) : own(own(scene, section), name);
  const value = segments.reduce(own, item);
  if (typeof value !== 'number' && !isNumbers(value)) return null;
  return { section: section as Section, name, path: segments, value };
}
