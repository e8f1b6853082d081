import * as v from 'valibot';
import { SCENE_LIMITS } from '../scene/limits.ts';
import { formatPointer, parsePointer } from '../scene/pointer.ts';
import type { Track } from '../scene/scene.ts';
import { type AnimationTarget, resolveClipTarget, resolveTarget } from '../scene/targets.ts';
import type { Sections } from './check-scene.ts';
import type { FaultyPlaces } from './faulty-places.ts';
import { describe, nearest, type Path, type ProblemList, quote } from './problem.ts';
import { sceneSchema } from './schema.ts';
import { entryOf, objectOption, optionOfType, type SchemaTree, treeOf, unwrap } from './schema-tree.ts';

/** Shortest time between two keys, seconds. */
const SHORTEST_STEP = 1e-6;
const MOVABLE =
  'a pointer to a number or a triple of numbers under "/camera", "/sky", "/materials", "/shapes", "/lights", "/nodes" or "/cameras"';

/** Checks tracks one after another: targets, the form and range of every key, times, and that no two move the same. */
export class TrackChecker {
  readonly #scene: Sections;
  readonly #faulty: FaultyPlaces;
  readonly #problems: ProblemList;
  /** Target → index of the track that moves it. */
  readonly #taken = new Map<string, number>();

  constructor(scene: Sections, faulty: FaultyPlaces, problems: ProblemList) {
    this.#scene = scene;
    this.#faulty = faulty;
    this.#problems = problems;
  }

  check(track: Track, index: number): void {
    const path: Path = ['animation', index];
    this.#checkTimes(track, path);
    const [section = '', name] = parsePointer(track.target) ?? [];
    if (this.#faulty.has(section, name)) return; // told already
    const target = resolveTarget(this.#scene, track.target);
    if (target === null) {
      this.#reportTarget(track.target, path);
      return;
    }
    this.#checkTaken(target, track.target, index);
    const schema = schemaOf(target, this.#scene);
    if (schema === undefined) return;
    track.keys.forEach((key, k) => {
      const result = v.safeParse(schema, key.value);
      if (result.success) return;
      const issue = result.issues[0];
      this.#problems.add([...path, 'keys', k, 'value'], describe(key.value), issue.message);
    });
    if (target.section === 'materials' && target.property === 'emission') this.#checkDark(track, target.name, path);
  }

  /** What a plane is made of stays dark, as check-scene.ts has it for the scene at rest. */
  #checkDark({ keys }: Track, material: string | null, path: Path): void {
    const planes = Object.entries(this.#scene.shapes).filter(
      ([name, shape]) => !this.#faulty.has('shapes', name) && shape.type === 'plane' && shape.material === material,
    );
    const bright = keys.findIndex(({ value }) => [value].flat().some((channel) => channel > 0));
    if (planes.length === 0 || bright < 0) return;
    const plane = quote(planes[0]![0]);
    const message = `Track ${path[1]} lets the plane ${plane} shine, but a lamp must have an end; please use a quad.`;
    this.#problems.add([...path, 'keys', bright, 'value'], describe(keys[bright]!.value), '0 for a plane', message);
  }

  #checkTimes({ keys }: Track, path: Path): void {
    for (let k = 1; k < keys.length; k++) {
      const [before, time] = [keys[k - 1]!.time, keys[k]!.time];
      if (time - before >= SHORTEST_STEP) continue;
      const message = `The keys of track ${path[1]} must be in order of time: ${time} s comes after ${before} s.`;
      this.#problems.add([...path, 'keys', k, 'time'], `${time} after ${before}`, `a time after ${before}`, message);
    }
  }

  #checkTaken(target: AnimationTarget, pointer: string, index: number): void {
    const path = ['animation', index, 'target'];
    const segments = parsePointer(pointer) ?? [];
    const whole = target.component === null ? segments : segments.slice(0, -1);
    // A triple clashes with itself and with each of its numbers; two different numbers of it do not clash.
    const own = formatPointer(segments);
    const others =
      target.component === null ? [0, 1, 2].map((c) => formatPointer([...segments, c])) : [formatPointer(whole)];
    const other = [own, ...others].map((name) => this.#taken.get(name)).find((taken) => taken !== undefined);
    if (other === undefined) this.#taken.set(own, index);
    else this.#problems.add(path, `${quote(pointer, 80)}, which track ${other} moves already`, 'a target of its own');
  }

  #reportTarget(pointer: string, path: Path): void {
    const meant = nearestTarget(this.#scene, pointer);
    const hint = meant === null ? '' : ` Did you mean ${quote(meant, 80)}?`;
    const found = `the target ${quote(pointer, 80)}`;
    const message = `Nothing at ${quote(pointer, 80)} can be animated; a target is ${MOVABLE}.${hint}`;
    this.#problems.add([...path, 'target'], found, MOVABLE, message);
  }
}

/** The schema that a key's value must keep at this target: the same that the value itself keeps. */
function schemaOf({ section, name, property, component }: AnimationTarget, scene: Sections) {
  return schemaAt(scene, section, name, component === null ? [property] : [property, String(component)]);
}

/** Of what stands at a path in a section, or of the thing with this name in it; undefined when none is known. */
export function schemaAt(
  scene: Sections,
  section: string,
  name: string | null,
  path: readonly string[],
): v.GenericSchema | undefined {
  const whole = unwrap(entryOf(treeOf(sceneSchema), section)!);
  let thing: SchemaTree | undefined = name === null ? whole : whole.value;
  const things = scene[section as keyof Sections] as Readonly<Record<string, { readonly type?: string }>>;
  if (thing?.type === 'variant') thing = optionOfType(thing, things[name!]?.type);
  for (const key of path) {
    if (thing?.type === 'union') thing = objectOption(thing);
    thing = thing && (thing.item ?? entryOf(thing, key));
    thing = thing && unwrap(thing);
  }
  return thing as unknown as v.GenericSchema | undefined;
}

/** For a pointer with one wrong segment: the pointer with what may have been meant there. */
export function nearestTarget(scene: Sections, pointer: string): string | null {
  const segments = parsePointer(pointer);
  if (segments === null || segments.length > 4 || pointer.length > 2 * SCENE_LIMITS.nameLength) return null;
  let here: unknown = scene;
  const corrected: string[] = [];
  for (const segment of segments) {
    if (typeof here !== 'object' || here === null) return null;
    const meant = Object.hasOwn(here, segment) ? segment : nearest(segment, Object.keys(here));
    if (meant === null) return null;
    corrected.push(meant);
    here = (here as Record<string, unknown>)[meant];
  }
  const result = formatPointer(corrected);
  return resolveClipTarget(scene, result) === null ? null : result;
}
