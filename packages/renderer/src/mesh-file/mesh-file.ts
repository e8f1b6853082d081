/** What the readers of this folder give, and which of them reads a file. */
import type { Mesh } from '../scene/mesh.ts';
import { type Read, reading, WHOLE } from './file-problems.ts';
import { readObj } from './obj/read-obj.ts';
import { readPly } from './ply/read-ply.ts';
import { readStl } from './stl/read-stl.ts';

// With the meshes' readers, as both are loaded when they are needed.
export { type MadeImage, makeImage, sizeOf, sourcesOf } from './obj/made-images.ts';
export { readMtl } from './obj/read-mtl.ts';

/** A part of a file with one material. */
export interface MeshPart {
  /** The material's name in the file; "" where it has none. */
  readonly name: string;
  readonly mesh: Mesh;
}
export interface MeshContent {
  /** At least one. */
  readonly parts: readonly MeshPart[];
  /** Triangles without area, which were left out. */
  readonly degenerate: number;
  /** Names of .mtl files that say what the materials are, from the file's own folder on. */
  readonly materialFiles: readonly string[];
  /** What was left out, mended or assumed, as sentences for people. */
  readonly notes: readonly string[];
}
export type MeshFile = Read<MeshContent>;

export interface MeshFileOptions {
  /** Whether all of the file is to be one part, whatever materials it has. Default: false. */
  readonly asOne?: boolean;
}

/** Reads a .ply, .obj or .stl file. `name`: for its ending, and for the problems' sentences. Never throws, whatever the bytes are. */
export function readMeshFile(bytes: Uint8Array, name: string, options: MeshFileOptions = {}): MeshFile {
  const ending = name.slice(name.lastIndexOf('.') + 1).toLowerCase();
  if (ending === 'ply') return readPly(bytes, name);
  if (ending === 'obj') return readObj(bytes, name, options);
  if (ending === 'stl') return readStl(bytes, name);
  return reading(name, (problems) => problems.fail(WHOLE, 'a name of another kind', 'a .ply, .obj or .stl file'));
}
