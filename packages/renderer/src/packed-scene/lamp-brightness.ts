/**
 * How bright the triangles of a mesh are whose emission a texture varies: the mean of the image over what each shows of it. It need not be
 * exact, as it only says how often a triangle is chosen: docs/lights.md.
 */
import { type Mesh, triangleCount } from '../scene/mesh.ts';
import { type ImagePixels, type TextureUse, textureTransform, type Vec2, type Wrap } from '../scene/textures.ts';
import { SummedImage } from './summed-image.ts';

/** What shines. */
export interface GlowTexture {
  readonly pixels: ImagePixels;
  readonly use: TextureUse;
  readonly wrapU: Wrap;
  readonly wrapV: Wrap;
}

/** Sums of images, and brightness by where and how they are used; all of it goes with them. */
const summed = new WeakMap<ImagePixels, SummedImage>();
const known = new WeakMap<Mesh, WeakMap<ImagePixels, { readonly key: string; readonly brightness: Float64Array }>>();

/** Where a triangle shows more than a few texels, it is cut into up to 4^this, as long as all of them are not more than MOST_PARTS. */
const DEEPEST = 3;
const MOST_PARTS = 2 ** 16;
const FEW_TEXELS = 2;

/** Of each triangle, as a share of a white one's. The same array for the same use of it. */
export function brightnessOf(mesh: Mesh, texture: GlowTexture): Float64Array {
  const { pixels, use, wrapU, wrapV } = texture;
  const key = JSON.stringify([use, wrapU, wrapV]);
  let ofMesh = known.get(mesh);
  if (!ofMesh) known.set(mesh, (ofMesh = new WeakMap()));
  const before = ofMesh.get(pixels);
  if (before?.key === key) return before.brightness;
  let image = summed.get(pixels);
  if (!image) summed.set(pixels, (image = new SummedImage(pixels)));
  const brightness = measure(mesh, texture, image);
  ofMesh.set(pixels, { key, brightness });
  return brightness;
}

function measure(mesh: Mesh, { use, wrapU, wrapV }: GlowTexture, image: SummedImage): Float64Array {
  const triangles = triangleCount(mesh);
  const deepest = Math.min(DEEPEST, Math.max(Math.floor(Math.log2(MOST_PARTS / triangles) / 2), 0));
  const uvs = mesh.uvs?.[use.uvSet ?? 0];
  const transform = textureTransform(use);
  // Without coordinates everything shows the texel at their origin, as in shading/mesh/mesh_surface.wesl.
  const at = (corner: number): Vec2 => {
    const vertex = 2 * mesh.indices[corner]!;
    return uvs ? transform(uvs[vertex]!, uvs[vertex + 1]!) : transform(0, 0);
  };
  const mean = (a: Vec2, b: Vec2, c: Vec2, depth: number): number => {
    const [u0, u1] = [Math.min(a[0], b[0], c[0]), Math.max(a[0], b[0], c[0])];
    const [v0, v1] = [Math.min(a[1], b[1], c[1]), Math.max(a[1], b[1], c[1])];
    const isSmall = (u1 - u0) * image.columns < FEW_TEXELS && (v1 - v0) * image.rows < FEW_TEXELS;
    if (depth === 0 || isSmall) return image.mean(u0, v0, u1, v1, wrapU, wrapV);
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    const d = depth - 1;
    return (mean(a, ab, ca, d) + mean(ab, b, bc, d) + mean(ca, bc, c, d) + mean(ab, bc, ca, d)) / 4;
  };
  return Float64Array.from({ length: triangles }, (_, k) => mean(at(3 * k), at(3 * k + 1), at(3 * k + 2), deepest));
}

const middle = (a: Vec2, b: Vec2): Vec2 => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
