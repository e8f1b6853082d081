/**
 * AOVs ("arbitrary output variables"): what a renderer knows of a pixel beside its colour. docs/aov.md says what each one means. This
 * takes those of the first hit out of films of `features` and `data`, and gives all of them the names that other programs know.
 */
import { aovIds } from '../integrator/aov/aov-ids.ts';
import { cameraAxes, wholeCamera } from '../scene/camera.ts';
import type { Integrator, Scene, Vec3 } from '../scene/scene.ts';
import { dot, length } from '../scene/vec3.ts';
import type { FilmContent, FilmSettings, FilmSums } from './film-tracer.ts';

/** How one is written down. */
export interface Aov {
  /** The film that it is taken from; `light`: that of the picture; `direct`: one more, see `directSettings`. */
  readonly source: FilmContent | 'direct';
  /** In files of many layers. */
  readonly layer: string;
  readonly channels: readonly string[];
  /** `colour`: linear light or shares of it, never negative, to be looked at. `vector`: any three numbers. `number`: one. */
  readonly kind: 'colour' | 'vector' | 'number';
}

const RGB = ['R', 'G', 'B'];
const XYZ = ['X', 'Y', 'Z'];
const one = { channels: ['Y'], kind: 'number' } as const;

export const AOVS = {
  albedo: { source: 'features', layer: 'albedo', channels: RGB, kind: 'colour' },
  normal: { source: 'features', layer: 'N', channels: XYZ, kind: 'vector' },
  'geometric-normal': { source: 'data', layer: 'Ng', channels: XYZ, kind: 'vector' },
  depth: { source: 'data', layer: 'depth', channels: ['Z'], kind: 'number' },
  position: { source: 'data', layer: 'P', channels: XYZ, kind: 'vector' },
  'primitive-id': { source: 'data', layer: 'primitiveId', ...one },
  'material-id': { source: 'data', layer: 'materialId', ...one },
  coverage: { source: 'features', layer: 'coverage', ...one },
  direct: { source: 'direct', layer: 'direct', channels: RGB, kind: 'colour' },
  indirect: { source: 'direct', layer: 'indirect', channels: RGB, kind: 'colour' },
  samples: { source: 'light', layer: 'samples', ...one },
  error: { source: 'light', layer: 'error', channels: RGB, kind: 'vector' },
} as const satisfies Readonly<Record<string, Aov>>;

export type AovName = keyof typeof AOVS;
export const AOV_NAMES = Object.keys(AOVS) as readonly AovName[];

/** Those that `firstHitAov` gives. */
export type FirstHitAov = {
  [Name in AovName]: (typeof AOVS)[Name]['source'] extends 'features' | 'data' ? Name : never;
}[AovName];
export const isFirstHit = (name: AovName): name is FirstHitAov =>
  AOVS[name].source === 'features' || AOVS[name].source === 'data';

/** The depth where nothing is met, as in Cycles: far, and a number that every program can work with. */
export const FAR = 1e10;

/** Writes one pixel's values, of four numbers of each of the film's two layers. */
type Resolve = (first: Float32Array, second: Float32Array, to: Float32Array, at: number) => void;

/** `scene` as it was traced, animated to its time. */
function resolverOf(name: FirstHitAov, scene: Scene, integrator: Integrator): Resolve {
  const { eye, projection } = wholeCamera(scene.camera);
  switch (name) {
    case 'albedo':
      return (first, _, to, at) => put(to, at, first, 1 / Math.max(first[3]!, 1));
    case 'normal':
      return (first, second, to, at) => put(to, at, second, 1 / Math.max(first[3]!, 1));
    case 'coverage':
      return (first, second, to, at) => void (to[at] = second[3]! / Math.max(first[3]!, 1));
    case 'geometric-normal':
      return (_, second, to, at) => put(to, at, second, 1);
    case 'position':
      return ([x, y, z, id], _, to, at) => {
        if (id !== 0) to.set([x! + eye[0], y! + eye[1], z! + eye[2]], at);
      };
    case 'depth': {
      const { forward } = cameraAxes(scene.camera);
      const far = projection === 'equirectangular' ? length : (p: Vec3) => dot(p, forward);
      return ([x, y, z, id], _, to, at) => void (to[at] = id === 0 ? FAR : far([x!, y!, z!]));
    }
    case 'primitive-id':
      return ([, , , id], _, to, at) => void (to[at] = id!);
    case 'material-id': {
      const { materialOf } = aovIds(scene, integrator);
      return ([, , , id], _, to, at) => void (to[at] = materialOf[id!]!);
    }
  }
}

function put(to: Float32Array, at: number, from: Float32Array, factor: number): void {
  for (let c = 0; c < 3; c++) to[at + c] = from[c]! * factor;
}

/**
 * An AOV of the first hit out of the film that it is taken from: its channels side by side, pixel by pixel. Places become the world's
 * here, in double precision, so that they have all the digits of float32 however far the scene is from the origin.
 */
export function firstHitAov(
  name: FirstHitAov,
  sums: FilmSums,
  scene: Scene,
  integrator: Integrator,
): Float32Array<ArrayBuffer> {
  const resolve = resolverOf(name, scene, integrator);
  const count = AOVS[name].channels.length;
  const texels = sums.length / 2;
  const values = new Float32Array((texels / 4) * count);
  for (let i = 0, at = 0; i < texels; i += 4, at += count)
    resolve(sums.subarray(i, i + 4), sums.subarray(texels + i, texels + i + 4), values, at);
  return values;
}

/** Segments of a path that lead straight from a light over one surface to the camera. */
const DIRECT_DEPTH = 2;

/**
 * Settings of a film with only the direct part of the light, by the same random numbers: what is seen of lamps, and their light on
 * what the camera sees. The rest of a film with the whole settings is the indirect part. A path's first segments do not depend on
 * where it ends, and chance ends none before `maxDepth` does; nor does what the classic integrator sees depend on its mirrors.
 */
export function directSettings(settings: FilmSettings): FilmSettings {
  if (settings.integrator === 'classic') return { ...settings, maxReflections: 0 };
  const { maxDepth } = settings;
  return { ...settings, maxDepth: maxDepth < 0 ? DIRECT_DEPTH : Math.min(maxDepth, DIRECT_DEPTH) };
}
