/** Mirrorball: ray tracing in the browser. `createRenderer(canvas)`, `renderer.setScene(scene)`, `renderer.start()`. */

export { depthAt } from './depth-at.ts';
export type { ViewName } from './display/views.ts';
export * from './gltf/index.ts';
export { DeviceError } from './gpu/device.ts';
export * from './open/index.ts';
export { adoptScene, buffersOf, type PreparedScene, prepareScene } from './packed-scene/prepared-scene.ts';
export { UntraceableSceneError } from './packed-scene/refuse-meshes.ts';
export { createRenderer } from './renderer.ts';
export type * from './renderer-types.ts';
export { builtInScenes } from './scene/built-in/index.ts';
export * from './scene/index.ts';
export * from './scene-file/index.ts';
