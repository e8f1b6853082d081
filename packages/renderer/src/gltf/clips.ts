/** Animations. */
import type { Clip, SampledTrack, SceneNode } from '../scene/nodes.ts';
import { formatPointer } from '../scene/pointer.ts';
import type { Camera, Light, Material } from '../scene/scene.ts';
import { quote } from '../scene-file/problem.ts';
import { floatsOf } from './accessors.ts';
import { extensionOf, lightsOf } from './json.ts';
import { GLTF_LIMITS } from './limits.ts';
import {
  cameraTargets,
  DEFAULTS,
  lightTargets,
  materialTargets,
  type PointerTarget,
  USE_DEFAULTS,
} from './pointers.ts';
import { addProblem, type Path } from './problems.ts';
import { NamedThings, type Reading } from './reading.ts';

/** The things that animations may move. Where one says nothing of a property that moves, its default is written there. */
export interface Movable {
  readonly nodes: NamedThings<SceneNode>;
  readonly materials: NamedThings<Material>;
  readonly lights: NamedThings<Light> & { readonly byLight: ReadonlyMap<number, readonly string[]> };
  readonly cameras: NamedThings<Camera> & { readonly byCamera: ReadonlyMap<number, readonly string[]> };
}

const INTERPOLATIONS = { LINEAR: 'linear', STEP: 'step', CUBICSPLINE: 'cubic' } as const;
const WIDTHS: Readonly<Record<string, number>> = { translation: 3, rotation: 4, scale: 3 };

/** A property of a thing of the scene. */
interface Target extends PointerTarget {
  readonly section: 'nodes' | 'materials' | 'lights' | 'cameras';
  readonly name: string;
}

export class ClipReader {
  readonly #reading: Reading;
  readonly #movable: Movable;
  readonly #floats = new Map<number, Float32Array | null>();

  constructor(reading: Reading, movable: Movable) {
    this.#reading = reading;
    this.#movable = movable;
  }

  read(): NamedThings<Clip> {
    const clips = new NamedThings<Clip>();
    (this.#reading.json.animations ?? []).forEach(({ name, channels }, animation) => {
      const tracks = new Map<string, SampledTrack>();
      channels.forEach((_, channel) => {
        for (const track of this.#tracks(animation, channel)) {
          if (!tracks.has(track.target)) tracks.set(track.target, track);
          else
            this.#tell(
              'changed',
              'animation',
              animation,
              channel,
              'Two channels of an animation move the same; the first one counts.',
            );
        }
      });
      const ends = [...tracks.values()].map(({ times }) => times[times.length - 1]!);
      if (ends.length > 0)
        clips.add(
          { duration: Math.max(...ends), tracks: [...tracks.values()] },
          name,
          `animation ${animation}`,
          animation,
        );
      else
        this.#reading.report.add(
          'unused',
          'animation',
          ['animations', animation],
          'An animation moves nothing of the scene; it is left out.',
        );
    });
    return clips;
  }

  #tell(
    kind: 'unsupported' | 'changed' | 'unused',
    what: string,
    animation: number,
    channel: number,
    message: string,
  ): void {
    this.#reading.report.add(kind, what, ['animations', animation, 'channels', channel], message);
  }

  #tracks(animation: number, channel: number): SampledTrack[] {
    const { sampler, target } = this.#reading.json.animations![animation]!.channels[channel]!;
    const targets = this.#targets(target, animation, channel);
    return targets.flatMap((one) => this.#track(one, animation, sampler));
  }

  #targets(
    target: { node?: number; path: string; extensions?: unknown },
    animation: number,
    channel: number,
  ): Target[] {
    const unused = (what: string) =>
      this.#tell('unused', what, animation, channel, 'A channel moves what the scene does not show.');
    if (target.path === 'pointer') {
      const pointer = extensionOf<{ pointer: string }>(target, 'KHR_animation_pointer')?.pointer ?? '';
      const targets = this.#pointerTargets(pointer);
      if (targets === null)
        this.#tell(
          'unsupported',
          'KHR_animation_pointer',
          animation,
          channel,
          `Nothing of a scene that can move stands for ${quote(pointer, 100)}.`,
        );
      else if (targets.length === 0) unused('KHR_animation_pointer');
      return targets ?? [];
    }
    if (target.node === undefined) {
      unused('animation');
      return [];
    }
    const found = this.#nodeTargets(target.node, target.path);
    if (found === null)
      this.#tell('unsupported', 'animation', animation, channel, `A node cannot move by ${quote(target.path)}.`);
    else if (found.length === 0) unused('animation');
    return found ?? [];
  }

  #nodeTargets(node: number, path: string): Target[] | null {
    const name = this.#movable.nodes.nameOf(node);
    if (!Object.hasOwn(WIDTHS, path) && path !== 'weights') return null;
    if (name === undefined) return [];
    const { matrix, weights } = this.#movable.nodes.things[name]!;
    if (path === 'weights' ? weights === undefined : matrix !== undefined) return null;
    return [{ section: 'nodes', name, to: path }];
  }

  /** null: nothing stands for it; empty: what it moves is not in the scene. */
  #pointerTargets(pointer: string): Target[] | null {
    const { json } = this.#reading;
    const { materials, lights, cameras, nodes } = this.#movable;
    const node = /^\/nodes\/(\d+)\/(translation|rotation|scale|weights)$/.exec(pointer);
    if (node) return this.#nodeTargets(Number(node[1]), node[2]!);
    const mesh = /^\/meshes\/(\d+)\/weights$/.exec(pointer);
    if (mesh) {
      const users = (json.nodes ?? []).flatMap((one, i) =>
        one.mesh === Number(mesh[1]) && !one.weights && nodes.nameOf(i) !== undefined ? [i] : [],
      );
      return users.flatMap((user) => this.#nodeTargets(user, 'weights') ?? []);
    }
    const light = /^\/extensions\/KHR_lights_punctual\/lights\/(\d+)\/(.+)$/.exec(pointer);
    const other = /^\/(materials|cameras)\/(\d+)\/(.+)$/.exec(pointer);
    const [section, index, rest] = light ? (['lights', light[1], light[2]!] as const) : [other?.[1] as 'materials' | 'cameras' | undefined, other?.[2], other?.[3] ?? '']; // biome-ignore format: one choice
    if (section === undefined) return null;
    const place = Number(index);
    const type = lightsOf(json)[place]?.type ?? '';
    const targets =
      section === 'materials'
        ? materialTargets(rest)
        : section === 'cameras'
          ? cameraTargets(rest)
          : lightTargets(rest, type);
    if (targets === null) return null;
    const single = materials.nameOf(place);
    const names = section === 'lights' ? lights.byLight.get(place) : section === 'cameras' ? cameras.byCamera.get(place) : single === undefined ? [] : [single]; // biome-ignore format: one choice
    const all = (names ?? []).flatMap((name) => targets.map((target): Target => ({ ...target, section, name })));
    return all.every((target) => this.#exists(target)) ? all : null;
  }

  /** Sees to it that there is something to move; false when the thing has no such group. */
  #exists({ section, name, to }: Target): boolean {
    const things = this.#movable[section].things as Record<string, object>;
    const whole = withDefault(things[name]!, to.split('/'), to.includes('Texture/') || to.includes('texture/'));
    if (whole === null) return false;
    things[name] = whole;
    return true;
  }

  #track(target: Target, animation: number, index: number): SampledTrack[] {
    const { section, name, to } = target;
    if (section === 'nodes') this.#exists(target);
    const { input, output, interpolation = 'LINEAR' } = this.#reading.json.animations![animation]!.samplers[index]!;
    const path = ['animations', animation, 'samplers', index];
    const times = this.#numbers(input);
    const all = this.#numbers(output);
    if (times === null || all === null || !this.#checkTimes(times, [...path, 'input'])) return [];
    const width = all.length / times.length / (interpolation === 'CUBICSPLINE' ? 3 : 1);
    const [start, count] = target.from ?? [0, width];
    const wanted = this.#widthOf(target);
    if (count !== wanted || start + count > width) {
      const allowed = target.from ? 4 : wanted;
      addProblem(
        this.#reading.problems,
        [...path, 'output'],
        `values of ${width} numbers for ${quote(to)}`,
        `${allowed} numbers a value`,
      );
      return [];
    }
    const values = picked(all, width, start, count, target.factor ?? 1);
    const pointer = formatPointer([section, name, ...to.split('/')]);
    return [{ target: pointer, interpolation: INTERPOLATIONS[interpolation], times, values }];
  }

  #widthOf({ section, name, to }: Target): number {
    const thing: unknown = (this.#movable[section].things as Record<string, object>)[name];
    const value = to.split('/').reduce<unknown>((part, key) => (part as Record<string, unknown>)[key], thing);
    return Array.isArray(value) ? value.length : 1;
  }

  #numbers(accessor: number): Float32Array | null {
    const known = this.#floats.get(accessor);
    if (known !== undefined) return known;
    const floats = floatsOf(this.#reading.columns[accessor]!);
    const bad = floats.findIndex((value) => !(Math.abs(value) <= GLTF_LIMITS.farthest));
    if (bad >= 0)
      addProblem(
        this.#reading.problems,
        ['accessors', accessor],
        `the number ${floats[bad]}`,
        'numbers from -1e9 to 1e9',
      );
    this.#floats.set(accessor, bad >= 0 ? null : floats);
    return bad >= 0 ? null : floats;
  }

  #checkTimes(times: Float32Array, path: Path): boolean {
    const bad = times.findIndex((time, i) => i > 0 && time < times[i - 1]!);
    if (bad < 0) return true;
    addProblem(this.#reading.problems, path, `the time ${times[bad]} after ${times[bad - 1]}`, 'times that rise');
    return false;
  }
}

/** Some numbers of each value; the file's own array where that is all. */
function picked(all: Float32Array, width: number, start: number, count: number, factor: number): Float32Array {
  if (count === width && factor === 1) return all;
  const out = new Float32Array((all.length / width) * count);
  for (let i = 0; i < out.length; i++) out[i] = factor * all[Math.floor(i / count) * width + start + (i % count)]!;
  return out;
}

/** The thing with the default at the end of the path when nothing stands there; null when it has no such group. */
function withDefault(thing: object, [key, ...deeper]: readonly string[], isUse: boolean): object | null {
  const part = (thing as Record<string, unknown>)[key!];
  if (deeper.length > 0) {
    const whole = typeof part === 'object' && part !== null ? withDefault(part, deeper, isUse) : null;
    return whole && { ...thing, [key!]: whole };
  }
  const value = part ?? (isUse ? USE_DEFAULTS : DEFAULTS)[key!];
  return value === undefined ? null : { ...thing, [key!]: value };
}
