/** MTL (Wavefront): the materials of OBJ files. */
import type { Material } from '../../scene/scene.ts';
import { quote } from '../../scene-file/problem.ts';
import { type Read, reading, WHOLE } from '../file-problems.ts';
import { convertMtl } from './convert-mtl.ts';
import { readMtlStatements } from './mtl-statements.ts';

export interface MtlContent {
  /** By their names in the file; each as a scene file would have it. */
  readonly materials: Readonly<Record<string, Partial<Material>>>;
  /** What nothing was made of, as sentences for people. */
  readonly notes: readonly string[];
}
export type MtlFile = Read<MtlContent>;

/** So many materials with something left out are told of by name. */
const MOST_NOTES = 20;

/** Never throws, whatever the bytes are. Textures are named by their files; with `name` in a folder, so are they. */
export const readMtl = (bytes: Uint8Array, name: string): MtlFile =>
  reading(name, (problems) => {
    const read = readMtlStatements(bytes, problems);
    if (problems.isEmpty && read.length === 0) problems.fail(WHOLE, 'no material', 'a line "newmtl"');
    const materials: Record<string, Partial<Material>> = Object.create(null);
    const notes: string[] = [];
    for (const mtl of read) {
      const { material, unused } = convertMtl(mtl, name.slice(0, name.lastIndexOf('/') + 1));
      materials[mtl.name] = material;
      if (unused.length > 0) notes.push(`Nothing is made of ${unused.join(', ')} of the material ${quote(mtl.name)}.`);
    }
    const beyond = notes.length - MOST_NOTES;
    if (beyond > 0) notes.splice(MOST_NOTES, beyond, `The same is true of ${beyond} more materials.`);
    return { materials, notes };
  });
