/** Everything that shines, in double precision: what the shader modules of shading/light/emitter are tested against. */
import type { Color, Vec3 } from '../../scene/scene.ts';
import { dot, length, negate, scale, subtract } from '../../scene/vec3.ts';
import { boxPdf, metBox, sampleBox } from './box.ts';
import { coneDirection, inCone, wholeSphere } from './cone.ts';
import { metQuad, quadPdf, sampleQuad } from './quad.ts';
import { metSphere, sampleSphere, spherePdf } from './sphere.ts';

interface Shining {
  readonly radiance: Color;
}
export interface SphereEmitter extends Shining {
  readonly kind: 'sphere';
  readonly center: Vec3;
  readonly radius: number;
}
export interface QuadEmitter extends Shining {
  readonly kind: 'quad';
  readonly corner: Vec3;
  readonly u: Vec3;
  readonly v: Vec3;
  /** Shines to the side of u × v only. */
  readonly oneSided: boolean;
}
export interface BoxEmitter extends Shining {
  readonly kind: 'box';
  readonly center: Vec3;
  readonly halfSize: Vec3;
  /** The box's own directions in the world. */
  readonly axes: readonly [Vec3, Vec3, Vec3];
}
export interface PointEmitter {
  readonly kind: 'point';
  readonly position: Vec3;
  readonly intensity: Color;
}
export interface SpotEmitter {
  readonly kind: 'spot';
  readonly position: Vec3;
  readonly intensity: Color;
  /** Unit, where it shines to. */
  readonly direction: Vec3;
  readonly cosInner: number;
  readonly cosOuter: number;
}
export interface DirectionalEmitter {
  readonly kind: 'directional';
  /** Unit, the way that the light travels. */
  readonly direction: Vec3;
  readonly irradiance: Color;
  /** Half the angular diameter, radians. */
  readonly halfAngle: number;
}
export interface SkyEmitter {
  readonly kind: 'sky';
  readonly horizon: Color;
  readonly zenith: Color;
}
/** Those that have a surface. */
export type AreaEmitter = SphereEmitter | QuadEmitter | BoxEmitter;
export type Emitter = AreaEmitter | PointEmitter | SpotEmitter | DirectionalEmitter | SkyEmitter;

export interface LightSample {
  /** Unit, from the point to the light. */
  readonly direction: Vec3;
  readonly distance: number;
  /** Of a light without size: its irradiance on a surface that faces it. */
  readonly radiance: Color;
  /** Per solid angle; 1 for a light without size. */
  readonly pdf: number;
  readonly delta: boolean;
}

/** Where a ray meets the surface of an emitter. */
export interface Meeting {
  readonly distance: number;
  /** Unit, outwards or along u × v. */
  readonly normal: Vec3;
}

/** Two numbers in [0, 1). */
export type Square = readonly [number, number];

export const skyRadiance = ({ horizon, zenith }: SkyEmitter, direction: Vec3): Color => {
  const height = Math.max(direction[1], 0);
  return [0, 1, 2].map((c) => horizon[c]! + (zenith[c]! - horizon[c]!) * height) as unknown as Color;
};

/** A disc of half angle a that gives the irradiance E has the radiance E / (π sin² a). */
export const discRadiance = (e: DirectionalEmitter): Color =>
  scale(e.irradiance, 1 / (Math.PI * Math.sin(e.halfAngle) ** 2));

/** KHR_lights_punctual: full within the inner cone, none outside of the outer. */
export function spotFalloff(e: SpotEmitter, toLight: Vec3): number {
  const share = (dot(negate(toLight), e.direction) - e.cosOuter) / (e.cosInner - e.cosOuter);
  return Math.min(Math.max(share, 0), 1) ** 2;
}

function samplePlace(position: Vec3, intensity: Color, point: Vec3): LightSample | null {
  const toLight = subtract(position, point);
  const distance = length(toLight);
  if (distance === 0) return null;
  const radiance = scale(intensity, 1 / distance ** 2);
  return { direction: scale(toLight, 1 / distance), distance, radiance, pdf: 1, delta: true };
}

function sampleSpot(e: SpotEmitter, point: Vec3): LightSample | null {
  const sample = samplePlace(e.position, e.intensity, point);
  const falloff = sample === null ? 0 : spotFalloff(e, sample.direction);
  return sample === null || falloff === 0 ? null : { ...sample, radiance: scale(sample.radiance, falloff) };
}

function sampleDirectional(e: DirectionalEmitter, u: Square): LightSample {
  const toLight = negate(e.direction);
  if (e.halfAngle === 0) return { direction: toLight, distance: Infinity, radiance: e.irradiance, pdf: 1, delta: true };
  const { direction, pdf } = coneDirection(inCone(toLight, e.halfAngle), u);
  return { direction, distance: Infinity, radiance: discRadiance(e), pdf, delta: false };
}

function sampleSky(e: SkyEmitter, u: Square): LightSample {
  const { direction, pdf } = coneDirection(wholeSphere, u);
  return { direction, distance: Infinity, radiance: skyRadiance(e, direction), pdf, delta: false };
}

/** null: no light from there. */
export function sampleEmitter(e: Emitter, point: Vec3, u: Square): LightSample | null {
  switch (e.kind) {
    case 'sphere':
      return sampleSphere(e, point, u);
    case 'quad':
      return sampleQuad(e, point, u);
    case 'box':
      return sampleBox(e, point, u);
    case 'point':
      return samplePlace(e.position, e.intensity, point);
    case 'spot':
      return sampleSpot(e, point);
    case 'directional':
      return sampleDirectional(e, u);
    case 'sky':
      return sampleSky(e, u);
  }
}

/** Where a ray meets the emitter's surface; null when it does not, or when it has none. */
export function metEmitter(e: Emitter, origin: Vec3, direction: Vec3): Meeting | null {
  if (e.kind === 'sphere') return metSphere(e, origin, direction);
  if (e.kind === 'quad') return metQuad(e, origin, direction);
  return e.kind === 'box' ? metBox(e, origin, direction) : null;
}

/** The density with which `sampleEmitter` gives a direction, 0 where the emitter is not. */
export function emitterPdf(e: Emitter, point: Vec3, direction: Vec3): number {
  if (e.kind === 'sky') return 1 / (4 * Math.PI);
  if (e.kind === 'directional') return discPdf(e, direction);
  const met = metEmitter(e, point, direction);
  if (met === null) return 0;
  if (e.kind === 'sphere') return spherePdf(e, point);
  if (e.kind === 'quad') return quadPdf(e, point, met.distance);
  return e.kind === 'box' ? boxPdf(e, point, direction, met) : 0;
}

function discPdf({ direction, halfAngle }: DirectionalEmitter, toLight: Vec3): number {
  const cone = inCone(negate(direction), halfAngle);
  const off = 2 * Math.asin(Math.min(length(subtract(toLight, cone.axis)) / 2, 1));
  return halfAngle > 0 && off < halfAngle ? 1 / (2 * Math.PI * cone.width) : 0;
}
