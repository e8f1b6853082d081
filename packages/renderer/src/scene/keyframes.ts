import type { Track } from './scene.ts';

/** One track made ready for fast evaluation. Row i of `values` and `tangents` belongs to key i. */
export interface CompiledTrack {
  readonly interpolation: Track['interpolation'];
  readonly repeat: Track['repeat'];
  /** Numbers per key: 1 or 3. */
  readonly components: number;
  readonly times: Float64Array;
  readonly values: Float64Array;
  /** Slopes per second at the keys; empty unless `smooth`. */
  readonly tangents: Float64Array;
}

/** Compiles a track whose keys all have the same form and strictly increasing times. */
export function compileTrack(track: Track): CompiledTrack {
  const first = track.keys[0]?.value;
  const components = typeof first === 'number' ? 1 : 3;
  const times = Float64Array.from(track.keys, (key) => key.time);
  const values = Float64Array.from(track.keys.flatMap((key) => key.value));
  const tangents =
    track.interpolation === 'smooth' ? monotoneTangents(times, values, components, track.repeat) : new Float64Array();
  return { interpolation: track.interpolation, repeat: track.repeat, components, times, values, tangents };
}

/** Writes the track's value at `time` (seconds, any finite number) into `out[0 … components − 1]`. */
export function evaluateTrack(track: CompiledTrack, time: number, out: number[]): void {
  const { times, values, components } = track;
  const last = times.length - 1;
  const t = phase(track, time);
  const left = lastKeyNotAfter(times, t);
  if (left >= last || track.interpolation === 'step' || t <= times[left]!) {
    for (let c = 0; c < components; c++) out[c] = values[left * components + c]!;
    return;
  }
  const span = times[left + 1]! - times[left]!;
  const u = (t - times[left]!) / span;
  for (let c = 0; c < components; c++) {
    const k = left * components + c;
    const a = values[k]!;
    const b = values[k + components]!;
    const value =
      track.tangents.length === 0
        ? a + (b - a) * u
        : hermite(u, a, b, track.tangents[k]! * span, track.tangents[k + components]! * span);
    // Both curves stay between their keys by construction; this takes away the last rounding error.
    out[c] = Math.min(Math.max(value, Math.min(a, b)), Math.max(a, b));
  }
}

/** The time within the keys that stands for `time`, by the track's way to repeat. */
function phase(track: CompiledTrack, time: number): number {
  const start = track.times[0]!;
  const end = track.times[track.times.length - 1]!;
  const duration = end - start;
  if (duration === 0) return start;
  switch (track.repeat) {
    case 'once':
      return Math.min(Math.max(time, start), end);
    case 'loop':
      return start + remainder(time - start, duration);
    case 'ping-pong': {
      const there = remainder(time - start, 2 * duration);
      return start + (there <= duration ? there : 2 * duration - there);
    }
  }
}

/** a modulo m in [0, m), for negative a too. */
const remainder = (a: number, m: number): number => ((a % m) + m) % m;

/** Binary search: the last index with times[index] ≤ t, or 0. */
function lastKeyNotAfter(times: Float64Array, t: number): number {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle]! <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** The cubic from a to b over u = 0 … 1 with these slopes per unit of u. */
function hermite(u: number, a: number, b: number, slopeA: number, slopeB: number): number {
  const v = 1 - u;
  return a + u * u * (3 - 2 * u) * (b - a) + u * v * (v * slopeA - u * slopeB);
}

/**
 * Slopes that keep every piece monotone: F. N. Fritsch and R. E. Carlson, "Monotone piecewise cubic interpolation",
 * SIAM J. Numer. Anal. 17 (1980). What comes before the first and after the last key is the track's own continuation
 * (held, mirrored, or wrapped around when the ends meet), so the motion has no kink at any time.
 */
function monotoneTangents(
  times: Float64Array,
  values: Float64Array,
  components: number,
  repeat: Track['repeat'],
): Float64Array {
  const tangents = new Float64Array(values.length);
  const last = times.length - 1;
  for (let c = 0; c < components && last > 0; c++) {
    const value = (key: number) => values[key * components + c]!;
    const secant = (key: number) => (value(key + 1) - value(key)) / (times[key + 1]! - times[key]!);
    const step = (key: number) => times[key + 1]! - times[key]!;
    const set = (key: number, slope: number) => {
      tangents[key * components + c] = slope;
    };
    for (let key = 1; key < last; key++) set(key, meeting(secant(key - 1), secant(key), step(key - 1), step(key)));
    const closed = repeat === 'loop' && value(0) === value(last);
    if (repeat === 'loop') {
      const around = meeting(secant(last - 1), secant(0), step(last - 1), step(0));
      set(0, closed ? around : secant(0));
      set(last, closed ? around : secant(last - 1));
    }
    // Held before and after ('once') or mirrored ('ping-pong'): the slope at both ends is 0, as it stands.
    for (let key = 0; key < last; key++) limit(tangents, key * components + c, components, secant(key));
    if (closed) {
      const [start, end] = [tangents[c]!, tangents[last * components + c]!];
      const gentler = Math.abs(start) < Math.abs(end) ? start : end;
      set(0, gentler);
      set(last, gentler);
    }
  }
  return tangents;
}

/** The slope where two pieces meet: the parabola's through the three keys, or 0 at a peak. */
function meeting(before: number, after: number, stepBefore: number, stepAfter: number): number {
  if (before * after <= 0) return 0;
  return (before * stepAfter + after * stepBefore) / (stepBefore + stepAfter);
}

/** Draws both slopes of a piece into the circle of radius 3 times its secant, which makes the piece monotone. */
function limit(tangents: Float64Array, at: number, stride: number, secant: number): void {
  if (secant === 0) {
    tangents[at] = 0;
    tangents[at + stride] = 0;
    return;
  }
  const steepness = Math.hypot(tangents[at]! / secant, tangents[at + stride]! / secant);
  if (steepness <= 3) return;
  tangents[at] = (tangents[at]! * 3) / steepness;
  tangents[at + stride] = (tangents[at + stride]! * 3) / steepness;
}
