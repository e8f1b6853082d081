/**
 * What a scene is: plain, immutable data. No GPU, no DOM, no functions.
 *
 * World: right-handed, +Y up, metres, seconds, degrees. Colours are linear Rec.709.
 * Everything that can be pointed at has a name: `shapes`, `meshes`, `materials` and `lights` are maps from name to thing,
 * in the order of the file; those that `parseScene` gives inherit nothing. The file format (`scene-file/`) is this structure with its defaults left out.
 */
import type { EnvironmentMap } from './environment.ts';
import type { MaterialLayers } from './material-layers.ts';
import type { MeshSource } from './mesh.ts';
import type { ModelSource } from './models.ts';
import type { Clip, SceneNode, Skin, Variant } from './nodes.ts';
import type { ImageSource, Texture } from './textures.ts';

export type Vec3 = readonly [x: number, y: number, z: number];
/** Linear Rec.709 red, green, blue. Not limited to 1. */
export type Color = readonly [r: number, g: number, b: number];

export interface Camera {
  readonly eye: Vec3;
  readonly target: Vec3;
  readonly up: Vec3;
  /** `perspective`: full vertical field of view, degrees, 0.01 … 179. */
  readonly verticalFov: number;
  // What follows may be left out, see CAMERA_DEFAULTS; `parseScene` fills it in.
  readonly projection?: Projection;
  /** `orthographic`: metres from the lower to the upper edge of the picture. */
  readonly viewHeight?: number;
  /** Radius of a thin lens, metres; 0 = a pinhole. The classic integrator takes every camera for a pinhole. */
  readonly aperture?: number;
  /** From the eye along the line of sight to the plane that is sharp, metres; 0 = at the target. */
  readonly focusDistance?: number;
  /** Name of a node that carries the camera: `eye`, `target` and `up` then count from there. */
  readonly node?: string;
}
/** `equirectangular`: the whole sphere, 360° across and 180° up and down, the line of sight in the middle. */
export type Projection = 'perspective' | 'orthographic' | 'equirectangular';

/**
 * What a ray sees that hits nothing: `horizon` blends to `zenith` with the ray's height; below the horizon it is `horizon`. A sky
 * with an image has that instead in the path integrator; the classic one sees the two colours all the same.
 */
export interface Sky {
  readonly horizon: Color;
  readonly zenith: Color;
  /** Name of the file that holds `map`; a scene that has been read from a text names it before it is loaded (`loadFiles`). */
  readonly image?: string;
  /** The image's content. A scene made by a program may have it without a file. */
  readonly map?: EnvironmentMap;
  /** Factor on the image's radiance. Default: 1. */
  readonly scale?: number;
  /** Turns the image about +Y, degrees, as `Box.rotation` does. Default: 0. */
  readonly rotation?: number;
}

/**
 * What a surface is made of. The classic integrator sees `baseColor`, `roughness`, `specular` and `reflectivity` only, whatever
 * the type; the path integrator sees everything but `specular`. What else it may have is in `MaterialLayers`.
 */
export interface Material extends MaterialLayers {
  /**
   * `diffuse`: Lambert. `metallicRoughness`: glTF 2.0. `conductor`: metal by its measured constants. `dielectric`: glass,
   * water: a solid body that light goes through.
   */
  readonly type: MaterialType;
  /** Share of light that comes back, per channel (linear). */
  readonly baseColor: Color;
  /**
   * 0 (smooth) … 1 (rough). GGX's alpha is roughness²; the classic integrator's Blinn–Phong exponent is 2 / roughness⁴ − 2.
   * When a file says nothing it is 0 for `conductor` and `dielectric`, else 0.5.
   */
  readonly roughness: number;
  /** Strength of the highlight, 0 … 1. */
  readonly specular: number;
  /** Weight of the mirror ray, 0 … 1; the rest, 1 − reflectivity, is the surface's own colour. */
  readonly reflectivity: number;
  /** `metallicRoughness`: 0 = plastic, 1 = metal. */
  readonly metallic: number;
  /** `dielectric`: index of refraction, 1 … 4. `metallicRoughness`: KHR_materials_ior, where 0 stands for an endless one. */
  readonly ior: number;
  /** `conductor`: complex index of refraction eta + i·k per channel; both black: `baseColor` comes back at every angle. */
  readonly conductor: { readonly eta: Color; readonly k: Color };
  /** `dielectric`: what is left of white light after `attenuationDistance` metres inside. Distance 0: clear. */
  readonly attenuationColor: Color;
  readonly attenuationDistance: number;
  /** `dielectric`: a pane without inside, such as a window or a soap bubble: light goes straight through. */
  readonly thin: boolean;
  /** Radiance that every side sends out, as a lamp. */
  readonly emission: Color;
  /** Rough metals and `metallicRoughness`: give back the light that single scattering loses (Turquin 2019). */
  readonly energyCompensation: boolean;
  /** Rough `conductor` and `dielectric`: which facets are hidden from which direction. Default: `correlated`. */
  readonly masking?: Masking;
}
/** Smith's masking of both directions: by facets of one height (Heitz 2014, equation 99), or of each by itself, G₁(ωi) G₁(ωo) (Walter 2007). */
export type Masking = 'correlated' | 'separable';
export type MaterialType = 'diffuse' | 'metallicRoughness' | 'conductor' | 'dielectric';

/** What a node may carry. */
interface Carried {
  /** Name of a node of the same scene, from which all places and directions then count; its scale changes sizes too. */
  readonly node?: string;
}

interface ShapeBase extends Carried {
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
/**
 * Triangles of `Scene.meshes`, placed. A point of the mesh is first moved by `matrix`, then scaled, turned as a box is, and translated;
 * `placementOf` (placed.ts) has all of it as one matrix.
 */
export interface MeshShape extends ShapeBase {
  readonly type: 'mesh';
  /** Name of a mesh of the same scene. */
  readonly mesh: string;
  readonly translation: Vec3;
  /** Degrees about X, then Y, then Z, as `Box.rotation`. */
  readonly rotation: Vec3;
  /** Along the axes that the mesh has before it is turned; negative = mirrored. */
  readonly scale: Vec3;
  /** Instead of the three, or before them: a 4 × 4 matrix row by row, for column vectors; its last row is 0 0 0 1. */
  readonly matrix?: Matrix4;
  /** Name of a node that carries the mesh: all of the above then counts from there. */
  readonly node?: string;
  /** Name of a skin of the same scene, for a mesh with skin weights. */
  readonly skin?: string;
  /** The mesh many times: 12 numbers each (`Affine`), between the node and the placement above. Left out: once. */
  readonly instances?: Float32Array;
}
/** Sixteen numbers, row by row. */
export type Matrix4 = readonly number[];
/** Shapes that a formula describes. */
export type AnalyticShape = Sphere | Box | Plane | Quad;
export type Shape = AnalyticShape | MeshShape;
export type ShapeType = Shape['type'];
/** Shapes whose light can be sampled. Others that shine are found only by rays that happen to meet them. */
export type LampShape = Sphere | Box | Quad;

/**
 * A spherical light; the one kind that the classic integrator knows. A sample point at distance d lights a surface with
 * w = radiance · radius² / d², which is also exactly what a glowing ball of that radiance gives.
 */
export interface SphereLight extends Carried {
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

/** A rectangle or parallelogram corner + s·u + t·v that shines to the side of u × v. Only the path integrator knows this and the following. */
export interface QuadLight extends Carried {
  readonly type: 'quad';
  readonly corner: Vec3;
  readonly u: Vec3;
  readonly v: Vec3;
  /** Multiplies `color`: radiance, W / (m² sr). */
  readonly radiance: number;
  readonly color: Color;
  /** Whether camera and mirrors see it. */
  readonly visible: boolean;
}
export interface PointLight extends Carried {
  readonly type: 'point';
  readonly position: Vec3;
  /** Multiplies `color`: W / sr. Irradiance is intensity · cos / distance². */
  readonly intensity: number;
  readonly color: Color;
}
export interface SpotLight extends Carried {
  readonly type: 'spot';
  readonly position: Vec3;
  /** Where it shines to; need not have length 1. */
  readonly direction: Vec3;
  readonly intensity: number;
  readonly color: Color;
  /** From the axis, degrees: full light up to the first, none from the second on (glTF's KHR_lights_punctual). */
  readonly innerAngle: number;
  readonly outerAngle: number;
}
export interface DirectionalLight extends Carried {
  readonly type: 'directional';
  /** The way that the light travels; need not have length 1. */
  readonly direction: Vec3;
  /** Multiplies `color`: W / m² on a surface that faces it. */
  readonly irradiance: number;
  readonly color: Color;
  /** Angular diameter, degrees; 0 (and what is below 1e-5) = a point at infinity, not seen by camera and mirrors; 0.53 = the sun. */
  readonly angle: number;
}
export type Light = SphereLight | QuadLight | PointLight | SpotLight | DirectionalLight;

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
  /** `classic`: Whitted's ray tracing with spherical lights, docs/classic.md. `path`: unbiased path tracing, docs/path.md. */
  readonly integrator: Integrator;
  /** Mirror rays that may follow the camera ray, 0 … 64. */
  readonly maxReflections: number;
  /** Points on each light: 1 = its centre, 9 = the course project's fixed grid, any other n ≤ 256 = stratified. */
  readonly lightSamples: number;
  /** `path`: segments of a path from the camera on: 1 = lamps seen directly, 2 = direct light too; −1 = no limit. */
  readonly maxDepth: number;
  /** Stops: the picture is multiplied by 2^exposure. */
  readonly exposure: number;
  /** How bright light is fitted to the screen, after exposure; display/tone-map.ts. */
  readonly toneMapping: ToneMapping;
}

export type Integrator = 'classic' | 'path';
/** `none`: clipped. `aces`: Hill's fit, as bright as in three.js. `agx`: Blender's, base look. `neutral`: Khronos PBR Neutral. */
export type ToneMapping = 'none' | 'aces' | 'agx' | 'neutral';

export interface Scene {
  readonly version: 1;
  readonly name: string;
  readonly description: string;
  readonly camera: Camera;
  readonly sky: Sky;
  readonly materials: Readonly<Record<string, Material>>;
  /** Left out: none. */
  readonly meshes?: Readonly<Record<string, MeshSource>>;
  /** What carries shapes, lights and cameras; see nodes.ts. Left out: none, as with all that follows. */
  readonly nodes?: Readonly<Record<string, SceneNode>>;
  readonly skins?: Readonly<Record<string, Skin>>;
  /** Files of whole models, which stand in the scene; models.ts says how. */
  readonly models?: Readonly<Record<string, ModelSource>>;
  readonly images?: Readonly<Record<string, ImageSource>>;
  readonly textures?: Readonly<Record<string, Texture>>;
  /** Motions, of which one plays at a time beside `animation`. */
  readonly clips?: Readonly<Record<string, Clip>>;
  /** Name of the clip that plays. Left out: none. */
  readonly clip?: string;
  /** Other materials for some shapes, by the name of the choice. */
  readonly variants?: Readonly<Record<string, Variant>>;
  /** Views beside `camera` that can be chosen. */
  readonly cameras?: Readonly<Record<string, Camera>>;
  readonly shapes: Readonly<Record<string, Shape>>;
  readonly lights: Readonly<Record<string, Light>>;
  readonly animation: readonly Track[];
  readonly render: RenderSettings;
}
