export { fetchBeside, type LoadedScene, loadImages, type ReadFile } from './load-images.ts';
export { type ParsedScene, parseScene } from './parse-scene.ts';
export type { Problem } from './problem.ts';
export { type SceneParts, withParts } from './with-parts.ts';
export { writeScene } from './write-scene.ts';
