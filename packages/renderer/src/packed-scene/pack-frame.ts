/** Camera and settings of one film sample, and what the packed scene says of itself → the Frame block. */
import type { Comparison, Framing, Panel } from '../renderer-types.ts';
import { cameraAxes, focusOf, PROJECTIONS, type WholeCamera, wholeCamera } from '../scene/camera.ts';
import type { Camera, Vec3 } from '../scene/scene.ts';
import { add, scale } from '../scene/vec3.ts';
import { type PixelFilter, packFilter } from './pack-filter.ts';
import type { PackedScene, ViewReach } from './pack-scene.ts';
import { workgroupOf } from './workgroup.ts';
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
  /** Default: the whole picture. */
  readonly framing?: Framing | null;
}

const NOWHERE: Vec3 = [0, 0, 0];

/** What a camera sees, as half its height: at a distance of 1, in metres, or (the whole sphere has none) 1. */
function halfHeight({ projection, verticalFov, viewHeight }: WholeCamera): number {
  if (projection === 'perspective') return Math.tan((verticalFov * Math.PI) / 360);
  return projection === 'orthographic' ? viewHeight / 2 : 1;
}

/**
 * Where the camera's rays may start: the parallelogram eye ± right ± up. A pinhole's start at the eye; those of an orthographic
 * camera start on the plane through the eye across the line of sight, those of a lens anywhere on it.
 */
export function viewReach(camera: Camera, aspect: number, framing: Framing | null = null): ViewReach {
  const whole = wholeCamera(camera);
  const { projection, aperture } = whole;
  const axes = cameraAxes(camera);
  if (projection === 'equirectangular') return { right: NOWHERE, up: NOWHERE };
  const half = projection === 'orthographic' ? halfHeight(whole) / (framing?.height ?? 1) : 0;
  return { right: scale(axes.right, half * aspect + aperture), up: scale(axes.up, half + aperture) };
}

/**
 * The film one metre in front of the eye: the way to its middle, and from there to its right and upper edges. A framing makes the
 * film larger and shifts it in its own plane, as a view camera does: what is upright stays upright. An orthographic film is not
 * shifted, and a panorama has no framing.
 */
function filmPlane(camera: Camera, film: { width: number; height: number }, framing: Framing | null) {
  const whole = wholeCamera(camera);
  const axes = cameraAxes(camera);
  if (whole.projection === 'equirectangular') return axes;
  const { center, height } = framing ?? { center: [0.5, 0.5], height: 1 };
  const half = halfHeight(whole) / height;
  const right = scale(axes.right, (half * film.width) / film.height);
  const up = scale(axes.up, half);
  if (whole.projection === 'orthographic') return { right, up, forward: axes.forward };
  const shift = add(scale(right, 1 - 2 * center[0]), scale(up, 2 * center[1] - 1));
  return { right, up, forward: add(axes.forward, shift) };
}

/** Where film sample s lies inside the pixel: Roberts' R2 sequence from the centre, so that any number of samples is even. */
export function filmJitter(s: number): readonly [number, number] {
  return [(0.5 + s * 0.7548776662466927) % 1, (0.5 + s * 0.5698402909980532) % 1];
}

/** What of a picture a film holds: the picture's size, and which of its pixels the first texel is. */
export interface HeldPicture {
  readonly width: number;
  readonly height: number;
  /** Column and row. Default: the first. */
  readonly origin?: readonly [column: number, row: number];
}

export function packFrame(
  block: Block,
  picture: HeldPicture,
  camera: Camera,
  packed: PackedScene,
  settings: FrameSettings,
  sampleIndex: number,
  sampleCount = 1,
): void {
  const whole = wholeCamera(camera);
  const { right, up, forward } = filmPlane(camera, picture, settings.framing ?? null);
  const panels = settings.comparison?.panels ?? [settings, settings, settings];
  const dividers = settings.comparison?.dividers ?? [2, 2];
  writeStruct(block, 'Frame', 0, {
    right,
    width: picture.width,
    up,
    height: picture.height,
    forward,
    lightCount: packed.lightCount,
    horizon: packed.horizon,
    sampleIndex,
    sampleCount,
    ...workgroupOf(sampleCount),
    zenith: packed.zenith,
    seed: settings.seed,
    jitter: filmJitter(sampleIndex),
    dividers: [dividers[0] * picture.width, dividers[1] * picture.width],
    shapeEnds: packed.shapeEnds,
    occluderEnd: packed.occluderEnd,
    ballCount: packed.ballCount,
    emitterCount: packed.emitterCount,
    farEmitters: packed.farEmitters,
    lightTree: packed.lightTree,
    lightTreeDepth: packed.lightTreeDepth,
    lampTables: packed.geometry?.lampTables ?? 0,
    origin: picture.origin ?? [0, 0],
    maxDepth: settings.maxDepth < 0 ? 0xffffffff : settings.maxDepth,
    panels: panels.flatMap((p) => [p.maxReflections, p.lightSamples, 0, 0]),
    filterPieces: packFilter(settings.pixelFilter ?? 'box'),
    independent: settings.independentSamples ? 1 : 0,
    projection: PROJECTIONS.indexOf(whole.projection),
    // No lens looks into all directions at once.
    aperture: whole.projection === 'equirectangular' ? 0 : whole.aperture,
    focusDistance: focusOf(camera),
    planesCutView: packed.planesCutView ? 1 : 0,
    environmentTurn: packed.environmentTurn,
    instances: packed.geometry?.instances ?? 0,
    instanceCount: packed.geometry?.instanceCount ?? 0,
    environmentSize: [packed.environment?.width ?? 0, packed.environment?.height ?? 0],
  });
}
