/**
 * What a scene is: plain, immutable data. No GPU, no DOM, no functions.
 *
 * World: right-handed, +Y up, metres, seconds, degrees. Colours are linear Rec.709.
 * Everything that can be pointed at has a name: `shapes`, `materials` and `lights` are maps from name to thing,
 * in the order of the file; those that `parseScene` gives inherit nothing. The file format (`scene-file/`) is this structure with its defaults left out.
 */

export type Vec3 = readonly [x: number, y: number, z: number];
/** Linear Rec.709 red, green, blue. Not limited to 1. */
export type Color = readonly [r: number, g: number, b: number];

export interface Camera {
  readonly eye: Vec3;
  readonly target: Vec3;
  readonly up: Vec3;
  /** Full vertical field of view, degrees, 0.01 … 179. */
  readonly verticalFov: number;
}

/** What a ray sees that hits nothing: `horizon` blends to `zenith` with the ray's height; below the horizon it is `horizon`. */
export interface Sky {
  readonly horizon: Color;
  readonly zenith: Color;
}

export interface Material {
  /** Share of light that comes back, per channel (linear). */
  readonly baseColor: Color;
  /** Width of the highlight, 0 (a point) … 1 (spread out). The Blinn–Phong exponent is 2 / roughness⁴ − 2. */
  readonly roughness: number;
  /** Strength of the highlight, 0 … 1. */
  readonly specular: number;
  /** Weight of the mirror ray, 0 … 1; the rest, 1 − reflectivity, is the surface's own colour. */
  readonly reflectivity: number;
}

interface ShapeBase {
  /** Name of a material of the same scene. */
  readonly material: string;
}
export interface Sphere extends ShapeBase {
  readonly type: 'sphere';
  readonly center: Vec3;
  readonly radius: number;
}
/** A solid box. `rotation` turns it about its centre: degrees about X, then Y, then Z (world axes; R = Rz·Ry·Rx). */
export interface Box extends ShapeBase {
  readonly type: 'box';
  readonly center: Vec3;
  readonly size: Vec3;
  readonly rotation: Vec3;
}
/** An infinite plane through `point`. Seen from both sides. `normal` need not have length 1. */
export interface Plane extends ShapeBase {
  readonly type: 'plane';
  readonly point: Vec3;
  readonly normal: Vec3;
}
/** The parallelogram corner + s·u + t·v with s, t in 0 … 1. Seen from both sides. */
export interface Quad extends ShapeBase {
  readonly type: 'quad';
  readonly corner: Vec3;
  readonly u: Vec3;
  readonly v: Vec3;
}
export type Shape = Sphere | Box | Plane | Quad;

/**
 * A spherical light of the classic model. A sample point at distance d lights a surface with
 * w = radiance · radius² / d², which is also exactly what a glowing ball of that radiance gives.
 */
export interface Light {
  readonly type: 'sphere';
  readonly center: Vec3;
  readonly radius: number;
  /** w₀: what the glowing ball sends out; multiplies `diffuse`, `specular` and the ball that is seen. */
  readonly radiance: number;
  /** Added everywhere, whatever stands in between. Not multiplied by `radiance`. */
  readonly ambient: Color;
  readonly diffuse: Color;
  readonly specular: Color;
  /** Density of the haze in which the light shows a halo, per metre; 0 = clear air. */
  readonly halo: number;
  /** Whether camera and mirrors see the ball and its halo. */
  readonly visible: boolean;
}

export type Interpolation = 'step' | 'linear' | 'smooth';
export type Repeat = 'once' | 'loop' | 'ping-pong';
export interface Key {
  /** Seconds. */
  readonly time: number;
  readonly value: number | Vec3;
}
/** Moves one property of the scene through its keys. */
export interface Track {
  /** JSON Pointer (RFC 6901) to a number or a triple of numbers, such as "/shapes/red ball/center". */
  readonly target: string;
  readonly interpolation: Interpolation;
  readonly repeat: Repeat;
  /** At least one; times strictly increasing. */
  readonly keys: readonly Key[];
}

export interface RenderSettings {
  readonly integrator: 'classic';
  /** Mirror rays that may follow the camera ray, 0 … 64. */
  readonly maxReflections: number;
  /** Points on each light: 1 = its centre, 9 = the course project's fixed grid, any other n ≤ 256 = stratified. */
  readonly lightSamples: number;
  /** Stops: the picture is multiplied by 2^exposure. */
  readonly exposure: number;
}

export interface Scene {
  readonly version: 1;
  readonly name: string;
  readonly description: string;
  readonly camera: Camera;
  readonly sky: Sky;
  readonly materials: Readonly<Record<string, Material>>;
  readonly shapes: Readonly<Record<string, Shape>>;
  readonly lights: Readonly<Record<string, Light>>;
  readonly animation: readonly Track[];
  readonly render: RenderSettings;
}
