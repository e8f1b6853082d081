/** Which pictures a run makes: one, or the frames of an animation, each with its time and its file. */
import { basename } from 'node:path';
import type { SampleRange } from './sample-ranges.ts';

export interface Frame {
  readonly time: number;
  /** Undefined when nothing is to be written. */
  readonly output: string | undefined;
  /** Null: the one picture of a run without frames. */
  readonly number: number | null;
  /** How messages call it. */
  readonly name: string;
}

/** Digits of a frame's number when the name does not say: enough for the last, and at least four. */
const DIGITS = 4;

/** "out.exr" → "out.0007.exr"; "out-####.exr" and "out-%04d.exr" say themselves where the number goes. Folders keep their names. */
export function frameFile(output: string, frame: number, last: number): string {
  const digits = (width: number) => String(frame).padStart(width, '0');
  const name = basename(output);
  const folder = output.slice(0, output.length - name.length);
  const pattern = /#+|%0?(\d*)d/;
  const match = pattern.exec(name);
  if (match) {
    const width = match[0].startsWith('#') ? match[0].length : Number(match[1] || 1);
    return folder + name.replace(pattern, digits(width));
  }
  const point = output.lastIndexOf('.');
  return `${output.slice(0, point)}.${digits(Math.max(DIGITS, String(last).length))}${output.slice(point)}`;
}

/** Frame f is at time + f / fps. */
export function framesOf(options: {
  readonly time: number;
  readonly fps: number;
  readonly frames?: SampleRange;
  readonly output?: string;
}): Frame[] {
  const { time, fps, frames, output } = options;
  if (!frames) return [{ time, output, number: null, name: output ?? 'picture' }];
  return Array.from({ length: frames.last - frames.first + 1 }, (_, index) => {
    const frame = frames.first + index;
    const file = output && frameFile(output, frame, frames.last);
    return { time: time + frame / fps, output: file, number: frame, name: file ?? `frame ${frame}` };
  });
}
