/**
 * Materials and their images → the texels, rows of four words: what each material uses textures for (`MaterialTextures`, and a `TextureUse`
 * for each), then the images, one after the other, four texels to a row. The first part is small and is written again whenever a scene is
 * packed, as animations move numbers there; images go up only when others are to be seen. Row 0 is for materials without any of this.
 */
import type { Material, Scene } from '../scene/scene.ts';
import { type ImagePixels, textureTransform } from '../scene/textures.ts';
import { geometryRows, LOOKUP_FLAGS, MATERIAL_FLAGS, TEXELS_OF_ROW } from './layout.ts';
import { type Slot, slotsOf } from './texture-slots.ts';
import { type Block, createBlock, writeStruct } from './write-struct.ts';

export interface PackedTextures {
  /** What materials use, in the first rows, with room for some more. */
  readonly uses: Block;
  /** Each begins with a row of its own. */
  readonly images: readonly { readonly pixels: ImagePixels; readonly row: number }[];
  /** All rows. */
  readonly rows: number;
}

const ROW_BYTES = 16;
const HEAD_ROWS = geometryRows('MaterialTextures');
const USE_ROWS = geometryRows('TextureUse');

export interface TextureRows {
  readonly textures: PackedTextures;
  /** Where each material's uses stand. */
  readonly rowOf: ReadonlyMap<Material, number>;
}

/** `materials`: those that meshes have. Throws when an image has not been loaded. */
export function packTextures(scene: Scene, materials: Iterable<Material>): TextureRows {
  const slots = new Map([...new Set(materials)].map((material) => [material, slotsOf(material)]));
  const useRows = [...slots.values()].reduce((sum, { length }) => sum + HEAD_ROWS + length * USE_ROWS, HEAD_ROWS);
  // Up to twice the room that is needed, so that a few more uses move no image.
  const room = 2 ** Math.ceil(Math.log2(useRows));
  const images = new ImageRows(scene, room);
  const uses = createBlock(room * ROW_BYTES);
  const rowOf = new Map<Material, number>();
  let row = HEAD_ROWS;
  for (const [material, all] of slots) {
    rowOf.set(material, row);
    const { unlit, baseColorTexture, opacity = 1, alphaMode, alphaCutoff = 0.5 } = material;
    writeStruct(uses, 'MaterialTextures', row * ROW_BYTES, {
      count: all.length,
      flags: (unlit ? MATERIAL_FLAGS.isUnlit : 0) | (baseColorTexture ? MATERIAL_FLAGS.hasOpacityTexture : 0),
      opacity,
      cutoff: alphaMode === 'mask' ? alphaCutoff : -1,
    });
    row += HEAD_ROWS;
    for (const one of all) {
      writeStruct(uses, 'TextureUse', row * ROW_BYTES, useValues(scene, one, images));
      row += USE_ROWS;
    }
  }
  return { textures: { uses, images: images.all, rows: images.end }, rowOf };
}

function useValues(scene: Scene, { slot: number, isColor, use }: Slot, images: ImageRows) {
  const { image, wrapU, wrapV, filter } = scene.textures![use.texture]!;
  const { width, height, row } = images.take(image);
  const transform = textureTransform(use);
  const [offset, alongU, alongV] = [transform(0, 0), transform(1, 0), transform(0, 1)];
  const toAxis = (axis: 0 | 1) => [alongU[axis] - offset[axis], alongV[axis] - offset[axis], offset[axis]];
  const flags =
    (use.uvSet === 1 ? LOOKUP_FLAGS.usesSecondSet : 0) |
    (isColor ? LOOKUP_FLAGS.isColor : 0) |
    (filter === 'nearest' ? LOOKUP_FLAGS.isNearest : 0) |
    { repeat: 0, clamp: LOOKUP_FLAGS.clampsU, mirror: LOOKUP_FLAGS.mirrorsU }[wrapU ?? 'repeat'] |
    { repeat: 0, clamp: LOOKUP_FLAGS.clampsV, mirror: LOOKUP_FLAGS.mirrorsV }[wrapV ?? 'repeat'];
  const { normalScale: scale = 1 } = use;
  return { toU: toAxis(0), toV: toAxis(1), slot: number, flags, first: row * TEXELS_OF_ROW, width, height, scale };
}

/** Images, each once however many uses it has. */
class ImageRows {
  readonly #scene: Scene;
  readonly #rows = new Map<ImagePixels, number>();
  end: number;

  constructor(scene: Scene, firstRow: number) {
    this.#scene = scene;
    this.end = firstRow;
  }

  take(name: string): { width: number; height: number; row: number } {
    const pixels = this.#scene.images?.[name]?.data;
    if (!pixels) throw new TypeError(`The image "${name}" has not been loaded.`);
    const { width, height } = pixels;
    const row = this.#rows.get(pixels) ?? this.end;
    if (row === this.end) {
      this.#rows.set(pixels, row);
      this.end += Math.ceil((width * height) / TEXELS_OF_ROW);
    }
    return { width, height, row };
  }

  get all() {
    return [...this.#rows].map(([pixels, row]) => ({ pixels, row }));
  }
}
