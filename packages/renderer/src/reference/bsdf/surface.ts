import type { Color, Masking, MaterialType, Vec3 } from '../../scene/scene.ts';

/** What the BSDFs read of a material: the struct `Surface` of the kernels, in names. */
export interface BsdfSurface {
  readonly type: MaterialType;
  readonly baseColor: Color;
  readonly reflectivity: number;
  readonly metallic: number;
  /** GGX width, roughness². */
  readonly alpha: number;
  /** Of a dielectric. */
  readonly ior: number;
  /** Of a conductor. */
  readonly eta: Color;
  readonly k: Color;
  readonly thin: boolean;
  readonly energyCompensation: boolean;
  /** `metallicRoughness`: correlated. */
  readonly masking: Masking;
}

/** f · |cos wi| and the density, per solid angle, with which the lobe is sampled there. */
export interface Evaluation {
  readonly value: Color;
  readonly pdf: number;
}

/** `weight` = f · |cos| / pdf. Of a delta lobe, `pdf` is the probability with which it is chosen. */
export interface BsdfSample {
  readonly direction: Vec3;
  readonly pdf: number;
  readonly weight: Color;
  readonly delta: boolean;
}

export const DARK: Evaluation = { value: [0, 0, 0], pdf: 0 };

export const mapColor = (c: Color, f: (x: number, channel: 0 | 1 | 2) => number): Color => [
  f(c[0], 0),
  f(c[1], 1),
  f(c[2], 2),
];
export const grey = (x: number): Color => [x, x, x];
