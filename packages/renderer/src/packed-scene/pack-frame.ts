/** Camera, sky and settings of one film sample → the Frame block. */
import type { Comparison, Panel } from '../renderer-types.ts';
import type { Camera, Sky, Vec3 } from '../scene/scene.ts';
import type { PackedScene } from './pack-scene.ts';
import { type Block, writeStruct } from './write-struct.ts';

export interface FrameSettings extends Panel {
  readonly seed: number;
  /** −1: no limit. */
  readonly maxDepth: number;
  readonly comparison: Comparison | null;
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
const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];

/** Right-handed unit axes: forward, right, up. */
export function cameraAxes({ eye, target, up }: Camera): { forward: Vec3; right: Vec3; up: Vec3 } {
  const forward = normalize([target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]]);
  const right = normalize(cross(forward, up));
  return { forward, right, up: cross(right, forward) };
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
  const axes = cameraAxes(camera);
  const tangent = Math.tan((camera.verticalFov * Math.PI) / 360);
  const panels = settings.comparison?.panels ?? [settings, settings, settings];
  const dividers = settings.comparison?.dividers ?? [2, 2];
  writeStruct(block, 'Frame', 0, {
    right: scale(axes.right, (tangent * film.width) / film.height),
    width: film.width,
    up: scale(axes.up, tangent),
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
  });
}
