/** Which of a scene's things came with its models: these are in the models' files, so that no scene file has them. */
import { belongsTo } from '../scene/models.ts';
import type { Scene } from '../scene/scene.ts';

/** Where the things of models go. */
export const MODEL_SECTIONS = ['materials', 'meshes', 'nodes', 'skins', 'images', 'textures', 'clips', 'variants', 'cameras', 'shapes', 'lights'] as const; // biome-ignore format: one list

/**
 * The scene without the things of its models. Throws a TypeError when one of them is not as the model has it: the file could not say so.
 */
export function withoutModels(scene: Scene): Scene {
  const loaded = Object.entries(scene.models ?? {}).filter(([, { things }]) => things);
  if (loaded.length === 0) return scene;
  // What somebody has changed is another object.
  const known = new Set(loaded.flatMap(([, { things }]) => things!));
  const rest: Record<string, unknown> = { ...scene };
  for (const section of MODEL_SECTIONS) {
    const things = scene[section];
    if (things === undefined) continue;
    const own = Object.entries(things).filter(([name, thing]) => {
      const model = loaded.find(([one]) => belongsTo(one, name) && (name !== one || section === 'nodes'));
      if (model && !known.has(thing))
        throw new TypeError(
          `The model "${model[0]}" has been changed (${section}, "${name}"), which its file does not know: write the scene as GLB instead.`,
        );
      return model === undefined;
    });
    if (own.length > 0 || ['materials', 'shapes', 'lights'].includes(section)) rest[section] = Object.fromEntries(own);
    else delete rest[section];
  }
  return rest as unknown as Scene;
}
