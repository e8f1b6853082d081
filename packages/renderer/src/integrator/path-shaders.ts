/**
 * The programs of paths and of what the camera sees first, which have most of their functions in common. They are half of all the shaders,
 * and a page that begins with the classic integrator does not wait for them: scripts/lazy-parts.mjs.
 */
export { default as aovWgsl } from '../shading/generated/aov.wgsl?raw';
export { default as aovDataGlsl } from '../shading/generated/aovData.glsl?raw';
export { default as aovFeaturesGlsl } from '../shading/generated/aovFeatures.glsl?raw';
export { default as pathGlsl } from '../shading/generated/path.glsl?raw';
export { default as pathWgsl } from '../shading/generated/path.wgsl?raw';
