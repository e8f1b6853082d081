/** The text of a program that draws paths or AOVs: a short one for scenes of shapes, and one with everything for scenes with models. */
import type { PassSource } from '../gpu/device.ts';
import { drawsModels, type Feature, switchesFor } from './features.ts';
import type { MODEL_SHADERS } from './model-shaders.ts';

export type Program = keyof typeof MODEL_SHADERS;

/** `source`, which has the text for shapes, as a program for films that ask for no more than these features. */
export async function sourceFor(
  source: PassSource,
  program: Program,
  features: ReadonlySet<Feature>,
): Promise<PassSource> {
  const switches = switchesFor(features);
  if (!drawsModels(features)) return { ...source, switches };
  const { wgsl, sampled, glsl } = (await import('./model-shaders.ts')).MODEL_SHADERS[program];
  return {
    ...source,
    switches,
    wgsl: { ...source.wgsl, fragment: wgsl, sampled },
    glsl: { ...source.glsl, fragment: glsl },
    compute: source.compute && { ...source.compute, wgsl },
  };
}
