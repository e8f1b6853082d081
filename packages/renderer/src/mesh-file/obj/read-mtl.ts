/** MTL (Wavefront): the materials of OBJ files. */
import type { Material } from '../../scene/scene.ts';
import type { Texture } from '../../scene/textures.ts';
import { quote } from '../../scene-file/problem.ts';
import { type Read, reading, WHOLE } from '../file-problems.ts';
import { asUtf8 } from '../text-encoding.ts';
import { MapNames } from './convert-maps.ts';
import { convertMtl } from './convert-mtl.ts';
import type { MadeImage } from './made-images.ts';
import { readMtlStatements } from './mtl-statements.ts';

export interface MtlContent {
  /** By their names in the file, "" for one without a name; each as a scene file would have it. */
  readonly materials: Readonly<Record<string, Partial<Material>>>;
  /** Textures that materials name. Other names are those of image files. */
  readonly textures: Readonly<Record<string, Texture>>;
  /** Images that textures name and that are no files: `makeImage` makes them of files. */
  readonly images: Readonly<Record<string, MadeImage>>;
  /** What nothing was made of, as sentences for people. */
  readonly notes: readonly string[];
}
export type MtlFile = Read<MtlContent>;

/** So many materials with something left out are told of by name. */
const MOST_NOTES = 20;

/** Never throws, whatever the bytes are. Textures are named by their files; with `name` in a folder, so are they. */
export const readMtl = (bytes: Uint8Array, name: string): MtlFile =>
  reading(name, (problems) => {
    const read = readMtlStatements(asUtf8(bytes, problems), name.slice(0, name.lastIndexOf('/') + 1), problems);
    if (problems.isEmpty && read.length === 0) problems.fail(WHOLE, 'no material', 'a line "newmtl"');
    const materials: Record<string, Partial<Material>> = Object.create(null);
    const maps = new MapNames(name);
    const notes: string[] = [];
    for (const mtl of read) {
      const { material, unused } = convertMtl(mtl, maps);
      materials[mtl.name] = material;
      if (unused.length > 0) notes.push(`Nothing is made of ${unused.join(', ')} of the material ${quote(mtl.name)}.`);
    }
    const beyond = notes.length - MOST_NOTES;
    if (beyond > 0) notes.splice(MOST_NOTES, beyond, `The same is true of ${beyond} more materials.`);
    return { materials, textures: maps.textures, images: maps.images, notes };
  });
