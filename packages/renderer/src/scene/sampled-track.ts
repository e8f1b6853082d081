/** The value of a sampled track at a time: glTF 2.0, appendix C. */
import { normalizeQuaternion, slerp, type WritableNumbers } from './affine.ts';
import type { Clip, SampledTrack } from './nodes.ts';

/** How many numbers a value has. */
export const widthOf = ({ times, values, interpolation }: SampledTrack): number =>
  times.length === 0 ? 0 : values.length / times.length / (interpolation === 'cubic' ? 3 : 1);

/** Whether the track turns a node, so that its values are quaternions. */
export const isRotation = ({ target }: SampledTrack): boolean => /^\/nodes\/[^/]+\/rotation$/.test(target);

/** The time within a clip that stands for `time`, seconds, any finite number. */
export function clipTime({ duration, repeat = 'loop' }: Clip, time: number): number {
  if (!(duration > 0)) return 0;
  if (repeat === 'once') return Math.min(Math.max(time, 0), duration);
  const period = repeat === 'loop' ? duration : 2 * duration;
  const within = ((time % period) + period) % period;
  return within <= duration ? within : period - within;
}

/** Writes the track's value at `time` into `out` from `at` on. `width` and `rotation` are what the functions above give. */
export function evaluateSampled(
  track: SampledTrack,
  width: number,
  rotation: boolean,
  time: number,
  out: WritableNumbers,
  at: number,
): void {
  const { times, values, interpolation } = track;
  const last = times.length - 1;
  const key = lastKeyNotAfter(times, time);
  const stride = interpolation === 'cubic' ? 3 * width : width;
  const middle = interpolation === 'cubic' ? width : 0;
  const a = key * stride + middle;
  const b = a + stride;
  if (key >= last || interpolation === 'step' || !(time > times[key]!)) {
    for (let i = 0; i < width; i++) out[at + i] = values[a + i]!;
  } else {
    const span = times[key + 1]! - times[key]!;
    const u = (time - times[key]!) / span;
    if (rotation && interpolation === 'linear') {
      slerp(out, at, values, a, values, b, u); // of length 1 already
      return;
    }
    if (interpolation === 'cubic') hermite(values, a, b, width, span, u, out, at);
    else for (let i = 0; i < width; i++) out[at + i] = values[a + i]! + (values[b + i]! - values[a + i]!) * u;
  }
  if (rotation) normalizeQuaternion(out, at);
}

/** Between the values at a and b; the slope out of a key stands after its value, the slope into it before. */
function hermite(
  values: Float32Array,
  a: number,
  b: number,
  width: number,
  span: number,
  u: number,
  out: WritableNumbers,
  at: number,
): void {
  const [u2, u3] = [u * u, u * u * u];
  const [fromA, slopeA] = [2 * u3 - 3 * u2 + 1, (u3 - 2 * u2 + u) * span];
  const [fromB, slopeB] = [3 * u2 - 2 * u3, (u3 - u2) * span];
  for (let i = 0; i < width; i++)
    out[at + i] =
      fromA * values[a + i]! +
      slopeA * values[a + width + i]! +
      fromB * values[b + i]! +
      slopeB * values[b - width + i]!;
}

/** The last index with times[index] ≤ t, or 0. */
function lastKeyNotAfter(times: Float32Array, t: number): number {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle]! <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}
