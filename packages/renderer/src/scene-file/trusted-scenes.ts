/** Scenes that all later stages can rely on, and others made of them that are as good. */
import type { EnvironmentMap } from '../scene/environment.ts';
import type { MeshSource } from '../scene/mesh.ts';
import type { Scene } from '../scene/scene.ts';

/**
 * One set for a whole realm, found under a name: a part of a page that is loaded later (scripts/lazy-parts.mjs) has its own copy of this
 * module, and a scene that it has looked through is good for the page too. Trusted scenes are frozen, so they stay as they are.
 */
const KEY = Symbol.for('mirrorball trusted scenes');
const realm = globalThis as { [KEY]?: WeakSet<object> };
realm[KEY] ??= new WeakSet();
const trusted = realm[KEY];

/** Whether `parseScene`, or another reader, has looked through it. */
export const isParsedScene = (value: unknown): value is Scene =>
  typeof value === 'object' && value !== null && trusted.has(value);

/** For scenes that another reader has made and looked through, and that nobody changes. */
export const trustScene = (scene: Scene): void => void trusted.add(scene);

/** The scene with the content of its sky's image: as good as the scene is, or, when the caller has looked at it, good. */
export function withMap(scene: Scene, map: EnvironmentMap, checked = isParsedScene(scene)): Scene {
  const whole: Scene = Object.freeze({ ...scene, sky: Object.freeze({ ...scene.sky, map }) });
  if (checked) trustScene(whole);
  return whole;
}

/** The scene with the content of its meshes, as `withMap` of the sky's. */
export const withMeshes = (
  scene: Scene,
  meshes: Readonly<Record<string, MeshSource>>,
  checked = isParsedScene(scene),
): Scene => withThings(scene, { meshes }, checked);

/** What a scene need not have. */
export const OPTIONAL = ['meshes', 'models', 'nodes', 'skins', 'images', 'textures', 'clips', 'variants', 'cameras'] as const; // biome-ignore format: a list

const BY_NAME = [...OPTIONAL, 'shapes', 'materials', 'lights'] as const satisfies readonly (keyof Scene)[];

type Things = Partial<Pick<Scene, (typeof BY_NAME)[number]>>;

/** The scene with other things in some sections, as good as it is, or, when the caller has looked at them, good. */
export function withThings(scene: Scene, things: Things, checked = isParsedScene(scene)): Scene {
  const sections = Object.entries(things).map(([section, all]) => {
    // Arrays of numbers cannot be frozen.
    const frozen = Object.entries(all).map(
      ([name, thing]) => [name, Object.isFrozen(thing) ? thing : Object.freeze({ ...thing })] as const,
    );
    return [section, Object.freeze(names(Object.fromEntries(frozen)))] as const;
  });
  const whole: Scene = Object.freeze({ ...scene, ...Object.fromEntries(sections) });
  if (checked) trustScene(whole);
  return whole;
}

/**
 * A scene that was looked through elsewhere and has come as plain data, by JSON or from a worker: frozen and trusted again. It is changed in
 * place, and is the caller's own. On the way maps from names have become ordinary objects.
 */
export function adoptedScene(scene: Scene): Scene {
  for (const name of BY_NAME) if (scene[name]) Object.setPrototypeOf(scene[name], null);
  trustScene(freeze(scene));
  return scene;
}

/** Things by name in an object that inherits nothing, so that no name finds more than the file gave. */
export function names<Things extends object>(things: Things | undefined): Things {
  const isMap = typeof things === 'object' && things !== null && !Array.isArray(things);
  return Object.assign(Object.create(null), isMap ? things : {}) as Things;
}

/** All of it but arrays of numbers, which cannot be. */
export function freeze<Value>(value: Value): Value {
  if (typeof value === 'object' && value !== null && !ArrayBuffer.isView(value)) {
    Object.freeze(value);
    for (const part of Object.values(value)) freeze(part);
  }
  return value;
}
