/** Programs that draw models too; loaded when a scene has some: see scripts/lazy-parts.mjs. */
import aovWgsl from './generated/aov_models.wgsl?raw';
import aovDataGlsl from './generated/aovDataModels.glsl?raw';
import aovFeaturesGlsl from './generated/aovFeaturesModels.glsl?raw';
import pathWgsl from './generated/path_models.wgsl?raw';
import pathGlsl from './generated/pathModels.glsl?raw';

export const MODEL_SHADERS = {
  path: { wgsl: pathWgsl, glsl: pathGlsl },
  features: { wgsl: aovWgsl, glsl: aovFeaturesGlsl },
  data: { wgsl: aovWgsl, glsl: aovDataGlsl },
} as const;
