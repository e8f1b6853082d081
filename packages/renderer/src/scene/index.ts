export { type CompiledAnimation, compileAnimation, sceneAt } from './animation.ts';
export { focusOf } from './camera.ts';
export type { EnvironmentMap } from './environment.ts';
export { SCENE_LIMITS } from './limits.ts';
export { formatPointer, parsePointer } from './pointer.ts';
export type * from './scene.ts';
export { type AnimationTarget, resolveTarget } from './targets.ts';
