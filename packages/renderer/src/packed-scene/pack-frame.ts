/** Camera, sky and settings of one film sample → the Frame block. */
import type { Comparison, Panel } from '../renderer-types.ts';
import { cameraAxes, focusOf, PROJECTIONS, wholeCamera } from '../scene/camera.ts';
import type { Camera, Sky, Vec3 } from '../scene/scene.ts';
import { type PixelFilter, packFilter } from './pack-filter.ts';
import type { PackedScene, ViewReach } from './pack-scene.ts';
import { type Block, writeStruct } from './write-struct.ts';

export interface FrameSettings extends Panel {
  readonly seed: number;
  /** −1: no limit. */
  readonly maxDepth: number;
  readonly comparison: Comparison | null;
  /** Default: box. */
  readonly pixelFilter?: PixelFilter;
  /** Independent random numbers instead of the Sobol sequence. Default: false. */
  readonly independentSamples?: boolean;
}

const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
const NOWHERE: Vec3 = [0, 0, 0];

/** What a camera sees, as half its height: at a distance of 1, in metres, or (the whole sphere has none) 1. */
function halfHeight({ projection, verticalFov, viewHeight }: Required<Camera>): number {
  if (projection === 'perspective') return Math.tan((verticalFov * Math.PI) / 360);
  return projection === 'orthographic' ? viewHeight / 2 : 1;
}

/**
 * Where the camera's rays may start: the parallelogram eye ± right ± up. A pinhole's start at the eye; those of an orthographic
 * camera start on the plane through the eye across the line of sight, those of a lens anywhere on it.
 */
export function viewReach(camera: Camera, aspect: number): ViewReach {
  const whole = wholeCamera(camera);
  const { projection, aperture } = whole;
  const axes = cameraAxes(camera);
  if (projection === 'equirectangular') return { right: NOWHERE, up: NOWHERE };
  const half = projection === 'orthographic' ? halfHeight(whole) : 0;
  return { right: scale(axes.right, half * aspect + aperture), up: scale(axes.up, half + aperture) };
}

/** Where film sample s lies inside the pixel: Roberts' R2 sequence from the centre, so that any number of samples is even. */
export function filmJitter(s: number): readonly [number, number] {
  return [(0.5 + s * 0.7548776662466927) % 1, (0.5 + s * 0.5698402909980532) % 1];
}

export function packFrame(
  block: Block,
  film: { width: number; height: number },
  camera: Camera,
  sky: Sky,
  packed: PackedScene,
  settings: FrameSettings,
  sampleIndex: number,
): void {
  const whole = wholeCamera(camera);
  const axes = cameraAxes(camera);
  const half = halfHeight(whole);
  const aspect = whole.projection === 'equirectangular' ? 1 : film.width / film.height;
  const panels = settings.comparison?.panels ?? [settings, settings, settings];
  const dividers = settings.comparison?.dividers ?? [2, 2];
  writeStruct(block, 'Frame', 0, {
    right: scale(axes.right, half * aspect),
    width: film.width,
    up: scale(axes.up, half),
    height: film.height,
    forward: axes.forward,
    lightCount: packed.lightCount,
    horizon: sky.horizon,
    sampleIndex,
    zenith: sky.zenith,
    seed: settings.seed,
    jitter: filmJitter(sampleIndex),
    dividers: [dividers[0] * film.width, dividers[1] * film.width],
    shapeEnds: packed.shapeEnds,
    occluderEnd: packed.occluderEnd,
    seenLightEnd: packed.seenLightEnd,
    emitterCount: packed.emitterCount,
    maxDepth: settings.maxDepth < 0 ? 0xffffffff : settings.maxDepth,
    panels: panels.flatMap((p) => [p.maxReflections, p.lightSamples, 0, 0]),
    filterPieces: packFilter(settings.pixelFilter ?? 'box'),
    independent: settings.independentSamples ? 1 : 0,
    projection: PROJECTIONS.indexOf(whole.projection),
    // No lens looks into all directions at once.
    aperture: whole.projection === 'equirectangular' ? 0 : whole.aperture,
    focusDistance: focusOf(camera),
    planesCutView: packed.planesCutView ? 1 : 0,
  });
}
