/** Camera, sky and settings of one film sample → the Frame block. */
import type { Comparison, Framing, Panel } from '../renderer-types.ts';
import type { Camera, Sky, Vec3 } from '../scene/scene.ts';
import type { PackedScene } from './pack-scene.ts';
import { type Block, writeStruct } from './write-struct.ts';

export interface FrameSettings extends Panel {
  readonly seed: number;
  readonly comparison: Comparison | null;
  /** Default: the whole picture. */
  readonly framing?: Framing | null;
}

const normalize = (a: Vec3): Vec3 => {
  const l = Math.hypot(...a);
  return [a[0] / l, a[1] / l, a[2] / l];
};
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];

/** Right-handed unit axes: forward, right, up. */
export function cameraAxes({ eye, target, up }: Camera): { forward: Vec3; right: Vec3; up: Vec3 } {
  const forward = normalize([target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]]);
  const right = normalize(cross(forward, up));
  return { forward, right, up: cross(right, forward) };
}

/**
 * The film one metre in front of the eye: the way to its middle, and from there to its right and upper edges. A framing makes the
 * film larger and shifts it in its own plane, as a view camera does: what is upright stays upright.
 */
function filmPlane(camera: Camera, film: { width: number; height: number }, framing: Framing | null) {
  const axes = cameraAxes(camera);
  const { center, height } = framing ?? { center: [0.5, 0.5], height: 1 };
  const tangent = Math.tan((camera.verticalFov * Math.PI) / 360) / height;
  const right = scale(axes.right, (tangent * film.width) / film.height);
  const up = scale(axes.up, tangent);
  const shift = add(scale(right, 1 - 2 * center[0]), scale(up, 2 * center[1] - 1));
  return { right, up, forward: add(axes.forward, shift) };
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
  const { right, up, forward } = filmPlane(camera, film, settings.framing ?? null);
  const panels = settings.comparison?.panels ?? [settings, settings, settings];
  const dividers = settings.comparison?.dividers ?? [2, 2];
  writeStruct(block, 'Frame', 0, {
    right,
    width: film.width,
    up,
    height: film.height,
    forward,
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
    panels: panels.flatMap((p) => [p.maxReflections, p.lightSamples, 0, 0]),
  });
}
