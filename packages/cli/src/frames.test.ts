import { expect, test } from 'vitest';
import { frameFile, framesOf } from './frames.ts';

test("a frame's number goes where the name says, or before the ending", () => {
  expect(frameFile('out.exr', 7, 119)).toBe('out.0007.exr');
  expect(frameFile('a.b/out.exr', 12345, 99999)).toBe('a.b/out.12345.exr');
  expect(frameFile('out-###.png', 7, 9)).toBe('out-007.png');
  expect(frameFile('out-%05d.png', 7, 9)).toBe('out-00007.png');
  expect(frameFile('out-%d.png', 7, 9)).toBe('out-7.png');
  expect(frameFile('C#/out.png', 7, 9)).toBe('C#/out.0007.png');
  expect(frameFile('#%d/out##.png', 7, 9)).toBe('#%d/out07.png');
});

test('times', () => {
  expect(framesOf({ time: 1.5, fps: 24, output: 'x.exr' })).toEqual([
    { time: 1.5, output: 'x.exr', number: null, name: 'x.exr' },
  ]);
  const frames = framesOf({ time: 1, fps: 4, frames: { first: 2, last: 4 }, output: 'x.exr' });
  expect(frames.map(({ time, output, number }) => [time, output, number])).toEqual([
    [1.5, 'x.0002.exr', 2],
    [1.75, 'x.0003.exr', 3],
    [2, 'x.0004.exr', 4],
  ]);
});
