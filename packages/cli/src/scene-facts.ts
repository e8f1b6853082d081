/** What is told about a scene: what it has, what moves in it, what it takes of memory, and what was not taken from its file as it stood. */
import type { Clip, Scene } from 'mirrorball/scene';
import { countsOf, mapValues, meshFacts } from './mesh-facts.ts';
import { type GoodScene, isModel } from './scene-source.ts';

type Facts = Readonly<Record<string, unknown>>;

/** More names than these are counted only. */
const MOST_NAMES = 40;

export function sceneFacts({ file, scene, notes }: GoodScene): Facts {
  const { name, description, sky, shapes, meshes, materials, lights, animation, camera, render } = scene;
  const kinds: Record<string, number> = {};
  for (const { type } of Object.values(shapes)) kinds[type] = (kinds[type] ?? 0) + 1;
  const ends = animation.map(({ keys }) => keys.at(-1)!.time);
  const model = isModel(file);
  return {
    kind: model ? 'model' : 'scene',
    name,
    description,
    shapes: kinds,
    materials: Object.keys(materials).length,
    lights: Object.keys(lights).length,
    tracks: animation.length,
    seconds: Math.max(0, ...ends),
    ...(meshes
      ? { meshes: model ? Object.keys(meshes).length : mapValues(meshes, meshFacts), ...countsOf(meshes) }
      : {}),
    ...counted(scene),
    ...(sky.map ? { sky: `${sky.image ?? 'of the model'}, ${sky.map.width} × ${sky.map.height}` } : {}),
    camera,
    render,
    memory: memoryOf(scene),
    ...(notes.length > 0 ? { notes } : {}),
  };
}

function counted({ nodes, skins, images, textures, clips, clip, variants, cameras, models }: Scene): Facts {
  const size = (things: object | undefined) => things && Object.keys(things).length;
  const names = (things: object | undefined) => {
    const all = things && Object.keys(things);
    return all && (all.length > MOST_NAMES ? all.length : all);
  };
  const facts = {
    models: models && mapValues(models, ({ file }) => file),
    nodes: size(nodes),
    skins: size(skins),
    textures: size(textures),
    images: images && mapValues(images, ({ data }) => data && `${data.width} × ${data.height}`),
    clips: clips && mapValues(clips, ({ duration }: Clip) => `${Number(duration.toPrecision(4))} s`),
    clip,
    variants: names(variants),
    cameras: names(cameras),
  };
  return Object.fromEntries(Object.entries(facts).filter(([, value]) => value !== undefined));
}

/** Bytes of arrays, each counted once, by what they are for. */
function memoryOf({ meshes, skins, clips, images, sky, shapes }: Scene): Facts {
  const seen = new Set<ArrayBufferLike>();
  const bytes = (value: unknown): number => {
    if (ArrayBuffer.isView(value)) {
      if (seen.has(value.buffer)) return 0;
      seen.add(value.buffer);
      return value.byteLength;
    }
    if (typeof value !== 'object' || value === null) return 0;
    return Object.values(value).reduce<number>((sum, part) => sum + bytes(part), 0);
  };
  const parts = { geometry: [meshes, shapes], animation: [skins, clips], images, sky: sky.map };
  const all = mapValues(parts as Readonly<Record<string, unknown>>, bytes);
  return mapValues(all, (count) => `${(count / 1e6).toFixed(2)} MB`);
}
