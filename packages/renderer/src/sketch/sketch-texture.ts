/** The colours of a material's texture for a sketch: the nearest texel, whatever filter the texture asks for. */
import { srgbToLinear } from '../display/srgb.ts';
import type { Mesh } from '../scene/mesh.ts';
import type { Color, Material, Scene } from '../scene/scene.ts';
import { textureTransform, type Wrap } from '../scene/textures.ts';

type Triple = readonly [number, number, number];
/** By the vertices of a triangle and their weights. */
export type SketchTexture = (vertices: Triple, weights: Triple) => Color;

/** Null where the material has none, or the mesh no coordinates for it. */
export function sketchTexture(scene: Scene, { baseColorTexture: use }: Material, mesh: Mesh): SketchTexture | null {
  const texture = use && scene.textures?.[use.texture];
  const image = texture && scene.images?.[texture.image]?.data;
  const uv = use && mesh.uvs?.[use.uvSet ?? 0];
  if (!texture || !image || !uv) return null;
  const transform = textureTransform(use);
  const { width, height, rgba } = image;
  return (vertices, weights) => {
    let [u, v] = [0, 0];
    for (let k = 0; k < 3; k++) {
      u += weights[k]! * uv[2 * vertices[k]!]!;
      v += weights[k]! * uv[2 * vertices[k]! + 1]!;
    }
    [u, v] = transform(u, v);
    const texel = 4 * (placeOf(v, height, texture.wrapV) * width + placeOf(u, width, texture.wrapU));
    return [
      srgbToLinear(rgba[texel]! / 255),
      srgbToLinear(rgba[texel + 1]! / 255),
      srgbToLinear(rgba[texel + 2]! / 255),
    ];
  };
}

function placeOf(x: number, size: number, wrap: Wrap = 'repeat'): number {
  const turns = Math.floor(x);
  const within = wrap === 'mirror' && turns % 2 !== 0 ? 1 - (x - turns) : x - turns;
  const place = Math.floor((wrap === 'clamp' ? x : within) * size);
  return Math.min(Math.max(place, 0), size - 1);
}
