/** A model's things among those of a scene: each by the model's name, a slash and its own, and all carried by one node. */
import type { ModelSource } from '../scene/models.ts';
import type { SampledTrack, SceneNode } from '../scene/nodes.ts';
import { formatPointer, parsePointer } from '../scene/pointer.ts';
import type { Scene } from '../scene/scene.ts';
import { quaternionOf } from '../scene/vec3.ts';
import { MODEL_SECTIONS } from './model-things.ts';

type Thing = Readonly<Record<string, unknown>>;

/** Where tracks may point; what moves the model's own camera, of which the scene has another, is left out. */
const MOVABLE = ['materials', 'shapes', 'lights', 'nodes', 'cameras'];

export function mergeModel(scene: Scene, name: string, source: ModelSource, model: Scene): Scene {
  const within = (thing: string): string => `${name}/${thing}`;
  const change = changes(within, name);
  const merged: Record<string, Record<string, object>> = {};
  const things: object[] = [];
  const put = (section: string, thing: string, content: object): void => {
    merged[section] ??= Object.assign(Object.create(null), scene[section as keyof Scene]) as Record<string, object>;
    merged[section][thing] = Object.freeze(content);
    things.push(content);
  };
  for (const section of MODEL_SECTIONS)
    for (const [own, thing] of Object.entries(model[section] ?? {}))
      put(section, within(own), change[section](thing as Thing));
  const { translation, rotation, scale, node } = source;
  const carrier: SceneNode = { translation, rotation: quaternionOf(rotation), scale };
  put('nodes', name, node === undefined ? carrier : { ...carrier, parent: node });
  for (const section of Object.values(merged)) Object.freeze(section);
  const models = Object.freeze({
    ...scene.models,
    [name]: Object.freeze({ ...source, things: Object.freeze(things) }),
  });
  return { ...scene, ...merged, models };
}

/** How the things of each section name others. */
function changes(within: (name: string) => string, carrier: string) {
  const named = <Key extends string>(thing: Thing, ...keys: Key[]): Thing =>
    Object.fromEntries(
      Object.entries(thing).map(([key, value]) => [key, keys.includes(key as Key) ? within(value as string) : value]),
    );
  const carried = (thing: Thing, ...keys: string[]): Thing => ({
    ...named(thing, ...keys),
    node: typeof thing.node === 'string' ? within(thing.node) : carrier,
  });
  const withTextures = (part: unknown): unknown => {
    if (typeof part !== 'object' || part === null || Array.isArray(part)) return part;
    const entries = Object.entries(part).map(([key, value]) =>
      key === 'texture' && typeof value === 'string' ? [key, within(value)] : [key, withTextures(value)],
    );
    return Object.fromEntries(entries);
  };
  const track = ({ target, ...rest }: SampledTrack): SampledTrack[] => {
    const [section = '', thing = '', ...path] = parsePointer(target) ?? [];
    return MOVABLE.includes(section) ? [{ ...rest, target: formatPointer([section, within(thing), ...path]) }] : [];
  };
  const same = (thing: Thing): Thing => ({ ...thing });
  return {
    materials: (thing: Thing) => withTextures(thing) as Thing,
    textures: (thing: Thing) => named(thing, 'image'),
    images: same,
    meshes: same,
    shapes: (thing: Thing) => carried(thing, 'mesh', 'material', 'skin'),
    lights: (thing: Thing) => carried(thing),
    cameras: (thing: Thing) => carried(thing),
    nodes: (thing: Thing) => ({ ...thing, parent: typeof thing.parent === 'string' ? within(thing.parent) : carrier }),
    skins: (thing: Thing) => ({ ...thing, joints: (thing.joints as string[]).map(within) }),
    clips: (thing: Thing) => ({ ...thing, tracks: (thing.tracks as SampledTrack[]).flatMap(track) }),
    variants: (thing: Thing) =>
      Object.fromEntries(Object.entries(thing).map(([shape, material]) => [within(shape), within(material as string)])),
  };
}
