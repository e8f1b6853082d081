/** Any file that can be shown, in. */
export type { GltfProgress } from '../gltf/types.ts';
export { endingOf, FileSet, type GivenFile, MOST_FILE_BYTES, nameOf } from './file-set.ts';
export { isSkyName, type OpenedSky, openEnvironment } from './open-environment.ts';
export { type OpenedFiles, openFiles } from './open-files.ts';
export { isModelName, type OpenedModel, type OpenOptions, openModel } from './open-model.ts';
