/** Models of other programs that stand in a scene: a file each, with all that it holds. */
import { MESH_ENDINGS } from './mesh.ts';
import type { Vec3 } from './scene.ts';

/** What the names of files with models end in. */
export const MODEL_ENDINGS = ['glb', 'gltf', ...MESH_ENDINGS] as const;

/**
 * A .glb, .gltf or mesh file and where it stands. Loading puts what the file has among the scene's own things: nodes, meshes, shapes, materials
 * and so on by the name of the model, a slash, and their names in the file ("fox/Walk"); a node of the model's own name carries all of it.
 */
export interface ModelSource {
  /** Name of the file, from the scene file's folder on. */
  readonly file: string;
  readonly translation: Vec3;
  /** Degrees about X, then Y, then Z, as `Box.rotation`. */
  readonly rotation: Vec3;
  readonly scale: Vec3;
  /** Name of a node of the scene that carries the model. */
  readonly node?: string;
  /** Which of the file's variants is shown. Left out: its first materials. */
  readonly variant?: string;
  /** What the file has, each also under its name among the scene's things. Left out: not loaded yet. */
  readonly things?: readonly object[];
}

/** Whether it has not been loaded. */
export const lacksModel = ({ things }: ModelSource): boolean => things === undefined;

/** Whether a name is one of the model's things, or of the node that carries them. */
export const belongsTo = (model: string, name: string): boolean => name === model || name.startsWith(`${model}/`);
