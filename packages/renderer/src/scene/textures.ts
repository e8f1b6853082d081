/** Pictures on surfaces: what is held once (image), how it is looked up (texture), and where a material uses it. */

export type Vec2 = readonly [x: number, y: number];

/**
 * Pixels of 8 bits, as a file has them. Whether they stand for sRGB colours or for plain numbers is for the place to say that uses them:
 * colours (`baseColor`, `emission`, the colours of layers) are sRGB with a linear alpha, everything else is linear.
 * One that has been read from a text names its file; loading adds the content.
 */
export interface ImageSource {
  /** Name of the file, from the scene file's folder on. */
  readonly file?: string;
  readonly data?: ImagePixels;
}

/** Data that is in use must not change. */
export interface ImagePixels {
  readonly width: number;
  readonly height: number;
  /** Red, green, blue and alpha of one pixel after the other, row 0 on top; colours are not multiplied with alpha. */
  readonly rgba: Uint8Array;
}

/** How an image is looked up. */
export interface Texture {
  /** Name of an image of the same scene. */
  readonly image: string;
  /** What lies to the left and right of the image, 0 … 1 of u. Default: `repeat`. */
  readonly wrapU?: Wrap;
  /** What lies above and below. Default: `repeat`. */
  readonly wrapV?: Wrap;
  /** Between the centres of pixels. Default: `linear`. */
  readonly filter?: 'linear' | 'nearest';
  /** Whether far away a smaller copy of the image is used, so that nothing flickers. Default: true. */
  readonly mipmaps?: boolean;
}
export type Wrap = 'repeat' | 'clamp' | 'mirror';

/** What the names of files that hold images end in. */
export const IMAGE_ENDINGS = ['png', 'jpg', 'jpeg', 'webp'] as const;

/** Whether it has not been loaded. */
export const lacksPixels = ({ data }: ImageSource): boolean => data === undefined;

/**
 * A texture used by a material. A point's coordinates (u, v) of the set are scaled, then turned, then moved
 * (KHR_texture_transform):
 *
 *     u′ = offset.x + cos r · scale.x · u + sin r · scale.y · v
 *     v′ = offset.y − sin r · scale.x · u + cos r · scale.y · v
 */
export interface TextureUse {
  /** Name of a texture of the same scene. */
  readonly texture: string;
  /** Which of the mesh's sets of coordinates. Default: 0. */
  readonly uvSet?: 0 | 1;
  /** Default: [0, 0]. */
  readonly offset?: Vec2;
  /** r in degrees; seen on the screen, the coordinates turn counter-clockwise. Default: 0. */
  readonly rotation?: number;
  /** Default: [1, 1]. */
  readonly scale?: Vec2;
}

/** Directions in the frame of tangent, bitangent and normal: each channel 0 … 1 stands for −1 … 1. */
export interface NormalTextureUse extends TextureUse {
  /** Factor on the first two components before the vector is given length 1. Default: 1. */
  readonly normalScale?: number;
}

/** The coordinates that a use of a texture makes of those of a mesh. */
export function textureTransform(use: TextureUse): (u: number, v: number) => Vec2 {
  const { offset = [0, 0], rotation = 0, scale = [1, 1] } = use;
  const [c, s] = [Math.cos((rotation * Math.PI) / 180), Math.sin((rotation * Math.PI) / 180)];
  return (u, v) => [offset[0] + c * scale[0] * u + s * scale[1] * v, offset[1] - s * scale[0] * u + c * scale[1] * v];
}
