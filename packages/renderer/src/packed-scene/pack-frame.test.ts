import { describe, expect, test } from 'vitest';
import { inCube, seededRandom } from '../../../../tests/fixtures/random.ts';
import { testLight, testScene } from '../../../../tests/fixtures/scenes.ts';
import { cameraFrame, rayThrough, sampleOffset } from '../reference/camera.ts';
import { cameraAxes } from '../scene/camera.ts';
import type { Camera, Vec3 } from '../scene/scene.ts';
import { add, addScaled, cross, dot, length, normalize, scale, subtract } from '../scene/vec3.ts';
import { fieldOffset, structSize } from './layout.ts';
import { type FrameSettings, filmJitter, packFrame, viewReach } from './pack-frame.ts';
import { packScene } from './pack-scene.ts';
import { createBlock } from './write-struct.ts';

const film = { width: 160, height: 90 };
const sky = { horizon: [1, 2, 3], zenith: [4, 5, 6] } as const;
const camera: Camera = { eye: [1, 2, 3], target: [4, 2, -1], up: [0, 1, 0], verticalFov: 50 };
const settings: FrameSettings = {
  maxReflections: 5,
  lightSamples: 9,
  maxDepth: -1,
  seed: 2 ** 32 - 1,
  comparison: null,
};
const scene = testScene({}, { a: testLight(), b: testLight() });

function frame(part: Partial<FrameSettings> = {}, sampleIndex = 0, view = camera) {
  const block = createBlock(structSize('Frame'));
  packFrame(block, film, view, packScene({ ...scene, sky }, view.eye), { ...settings, ...part }, sampleIndex);
  const start = (field: Parameters<typeof fieldOffset<'Frame'>>[1]) => fieldOffset('Frame', field) / 4;
  const floats = (field: Parameters<typeof start>[0], n: number) =>
    Array.from(block.f32.subarray(start(field), start(field) + n));
  const wholes = (field: Parameters<typeof start>[0], n: number) =>
    Array.from(block.u32.subarray(start(field), start(field) + n));
  return { floats, wholes };
}

test('camera axes are right-handed, of length 1, and look at the target (seed 61)', () => {
  const random = seededRandom(61);
  for (let k = 0; k < 200; k++) {
    const view: Camera = { eye: inCube(random, 9), target: inCube(random, 9), up: inCube(random, 9), verticalFov: 60 };
    const { forward, right, up } = cameraAxes(view);
    for (const axis of [forward, right, up]) expect(length(axis)).toBeCloseTo(1, 12);
    expect(length(subtract(cross(right, forward), up))).toBeLessThan(1e-12);
    expect(dot(forward, normalize(subtract(view.target, view.eye)))).toBeCloseTo(1, 12);
    expect(dot(up, view.up)).toBeGreaterThan(0);
  }
});

test('a ray through any point of the film is that of the definition (seed 62)', () => {
  const random = seededRandom(62);
  for (let k = 0; k < 50; k++) {
    const view: Camera = { ...camera, eye: inCube(random, 9), verticalFov: 5 + 160 * random() };
    const framing = k % 2 ? { center: [random(), random()] as const, height: 0.1 + random() } : null;
    const { floats } = frame({ framing }, 0, view);
    const [right, up, forward] = (['right', 'up', 'forward'] as const).map((f) => floats(f, 3)) as unknown as Vec3[];
    const [column, row] = [random() * film.width, random() * film.height];
    const x = (2 * column) / film.width - 1;
    const y = 1 - (2 * row) / film.height;
    const direction = normalize(addScaled(add(forward!, scale(right!, x)), up!, y));
    const exact = rayThrough(cameraFrame(view, film.width, film.height, framing), column, row, film.width, film.height);
    expect(length(subtract(direction, exact.direction))).toBeLessThan(1e-6);
  }
});

test('projection, lens and focus; where rays may start', () => {
  const frameOf = (part: Partial<Camera>) => {
    const { floats, wholes } = frame({}, 0, { ...camera, ...part });
    const [right, up] = [floats('right', 3), floats('up', 3)].map((axis) => Math.hypot(...axis));
    return [...wholes('projection', 1), right, up, ...floats('aperture', 1), ...floats('focusDistance', 1)];
  };
  const close = (values: unknown[], expected: number[]) =>
    expected.forEach((value, k) => {
      expect(values[k]).toBeCloseTo(value, 5);
    });
  const half = Math.tan((25 * Math.PI) / 180);
  // The target is 5 m away.
  close(frameOf({ aperture: 0.25 }), [0, (half * 16) / 9, half, 0.25, 5]);
  close(frameOf({ projection: 'orthographic', viewHeight: 9, focusDistance: 2 }), [1, 8, 4.5, 0, 2]);
  close(frameOf({ projection: 'equirectangular', aperture: 1 }), [2, 1, 1, 0, 5]);
  const reach = (part: Partial<Camera>) => {
    const { right, up } = viewReach({ ...camera, ...part }, 2);
    return [length(right), length(up)];
  };
  close(reach({}), [0, 0]);
  close(reach({ aperture: 0.5 }), [0.5, 0.5]);
  close(reach({ projection: 'orthographic', viewHeight: 4 }), [4, 2]);
  close(reach({ projection: 'equirectangular', aperture: 0.5 }), [0, 0]);
});

test('a framing puts what the camera looks at, and its field of view, where it says', () => {
  const framing = { center: [0.3, 0.2], height: 0.4 } as const;
  const { forward, up } = cameraAxes(camera);
  const through = (x: number, y: number) =>
    rayThrough(
      cameraFrame(camera, film.width, film.height, framing),
      x * film.width,
      y * film.height,
      film.width,
      film.height,
    );
  expect(dot(through(0.3, 0.2).direction, forward)).toBeCloseTo(1, 12);
  const edge = normalize(addScaled(forward, up, Math.tan((25 * Math.PI) / 180)));
  expect(dot(through(0.3, 0.2 - 0.4 / 2).direction, edge)).toBeCloseTo(1, 12);
});

test('numbers of the frame', () => {
  const { floats, wholes } = frame({}, 7);
  expect([...floats('width', 1), ...floats('height', 1)]).toEqual([160, 90]);
  expect([...wholes('lightCount', 1), ...wholes('sampleIndex', 1), ...wholes('seed', 1)]).toEqual([2, 7, 2 ** 32 - 1]);
  expect([...floats('horizon', 3), ...floats('zenith', 3)]).toEqual([1, 2, 3, 4, 5, 6]);
});

test('a film that holds a part of a picture says where; all else is as for the whole', () => {
  const blocks = [{}, { origin: [31, 7] as const }].map((held) => {
    const block = createBlock(structSize('Frame'));
    packFrame(block, { ...film, ...held }, camera, packScene({ ...scene, sky }, camera.eye), settings, 0);
    return block.u32;
  });
  const [whole, part] = blocks as [Uint32Array, Uint32Array];
  const at = fieldOffset('Frame', 'origin') / 4;
  expect(Array.from(whole.subarray(at, at + 2))).toEqual([0, 0]);
  expect(Array.from(part.subarray(at, at + 2))).toEqual([31, 7]);
  part.fill(0, at, at + 2);
  expect(part).toEqual(whole);
});

describe('panels', () => {
  test('without a comparison there is one, whichever panel a column is in', () => {
    const { wholes, floats } = frame();
    const panels = wholes('panels', 12);
    for (const first of [0, 4, 8]) expect(panels.slice(first, first + 2)).toEqual([5, 9]);
    expect(Math.min(...floats('dividers', 2))).toBeGreaterThan(film.width);
  });

  test('with one, three of them and dividers in columns', () => {
    const panel = (maxReflections: number, lightSamples: number) => ({ maxReflections, lightSamples });
    const comparison = { panels: [panel(1, 1), panel(2, 9), panel(10, 64)], dividers: [0.25, 0.5] } as const;
    const { wholes, floats } = frame({ comparison });
    expect(wholes('panels', 12)).toEqual([1, 1, 0, 0, 2, 9, 0, 0, 10, 64, 0, 0]);
    expect(floats('dividers', 2)).toEqual([40, 80]);
  });
});

test('film samples start in the middle of the pixel, are those of the reference, and fill it evenly', () => {
  expect(filmJitter(0)).toEqual([0.5, 0.5]);
  const cells = new Set<number>();
  for (let s = 0; s < 256; s++) {
    const [a, b] = filmJitter(s);
    const exact = sampleOffset(s);
    expect(Math.max(Math.abs(a - exact[0]), Math.abs(b - exact[1]))).toBeLessThan(1e-12);
    cells.add(Math.floor(a * 8) * 8 + Math.floor(b * 8));
  }
  expect(cells.size).toBe(64);
});
