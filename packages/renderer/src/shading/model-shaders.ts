/** Programs that draw models too; loaded when a scene has some: see scripts/lazy-parts.mjs. */
import aovWgsl from './generated/aov_models.wgsl?raw';
import aovSampled from './generated/aov_models_sampled.wgsl?raw';
import aovDataGlsl from './generated/aovDataModels.glsl?raw';
import aovFeaturesGlsl from './generated/aovFeaturesModels.glsl?raw';
import pathWgsl from './generated/path_models.wgsl?raw';
import pathSampled from './generated/path_models_sampled.wgsl?raw';
import pathGlsl from './generated/pathModels.glsl?raw';

export const MODEL_SHADERS = {
  path: { wgsl: pathWgsl, sampled: pathSampled, glsl: pathGlsl },
  features: { wgsl: aovWgsl, sampled: aovSampled, glsl: aovFeaturesGlsl },
  data: { wgsl: aovWgsl, sampled: aovSampled, glsl: aovDataGlsl },
} as const;
