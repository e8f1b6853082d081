export * from '../mesh-file/index.ts';
export { environmentFromPicture } from './environment-from-picture.ts';
export { type LoadedScene, type LoadOptions, loadFiles } from './load-files.ts';
export { type ParsedScene, parseScene } from './parse-scene.ts';
export type { Problem } from './problem.ts';
export { fetchBeside, type ReadFile } from './read-file.ts';
export { withCamera } from './with-camera.ts';
export { type SceneParts, withParts } from './with-parts.ts';
export { writeScene } from './write-scene.ts';
