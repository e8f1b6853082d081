/** A texture looked up in double precision: what tests hold shading/texture/lookup.wesl against, and what draws without a GPU. */
import type { Scene } from '../scene/scene.ts';
import {
  type ImagePixels,
  type NormalTextureUse,
  type Texture,
  type TextureUse,
  textureTransform,
  type Vec2,
  type Wrap,
} from '../scene/textures.ts';

/** Linear red, green, blue, and alpha. */
export type Texel = readonly [number, number, number, number];

export interface PreparedTexture {
  readonly use: NormalTextureUse;
  readonly texture: Texture;
  readonly pixels: ImagePixels;
  /** Whether its channels but alpha are sRGB. */
  readonly isColor: boolean;
}

/** Throws when its image has not been loaded. */
export function prepareTexture(scene: Scene, use: TextureUse, isColor: boolean): PreparedTexture {
  const texture = scene.textures![use.texture]!;
  const pixels = scene.images?.[texture.image]?.data;
  if (!pixels) throw new TypeError(`The image "${texture.image}" has not been loaded.`);
  return { use, texture, pixels, isColor };
}

/** IEC 61966-2-1. */
const linearFromSrgb = (c: number): number => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);

/** The texel at whole numbers, which may lie outside of the image. */
function texelAt({ texture: { wrapU, wrapV }, pixels, isColor }: PreparedTexture, x: number, y: number): Texel {
  const { width, height, rgba } = pixels;
  const at = 4 * (wrapped(y, height, wrapV) * width + wrapped(x, width, wrapU));
  const [r, g, b] = [0, 1, 2].map((c) => {
    const share = rgba[at + c]! / 255;
    return isColor ? linearFromSrgb(share) : share;
  }) as [number, number, number];
  return [r, g, b, rgba[at + 3]! / 255];
}

const modulo = (a: number, n: number): number => ((a % n) + n) % n;

function wrapped(i: number, size: number, wrap: Wrap = 'repeat'): number {
  if (wrap === 'clamp') return Math.min(Math.max(i, 0), size - 1);
  if (wrap === 'repeat') return modulo(i, size);
  const there = modulo(i, 2 * size);
  return there < size ? there : 2 * size - 1 - there;
}

/** At these coordinates of the mesh. */
export function lookUp(prepared: PreparedTexture, [s, t]: Vec2): Texel {
  const { use, texture, pixels } = prepared;
  const [u, v] = textureTransform(use)(s, t);
  const [x, y] = [u * pixels.width, v * pixels.height];
  if (texture.filter === 'nearest') return texelAt(prepared, Math.floor(x), Math.floor(y));
  const [left, top] = [Math.floor(x - 0.5), Math.floor(y - 0.5)];
  const [fx, fy] = [x - 0.5 - left, y - 0.5 - top];
  const shares = [
    [(1 - fx) * (1 - fy), texelAt(prepared, left, top)],
    [fx * (1 - fy), texelAt(prepared, left + 1, top)],
    [(1 - fx) * fy, texelAt(prepared, left, top + 1)],
    [fx * fy, texelAt(prepared, left + 1, top + 1)],
  ] as const;
  const mean = (c: number) => shares.reduce((sum, [share, texel]) => sum + share * texel[c]!, 0);
  return [mean(0), mean(1), mean(2), mean(3)];
}
