import type { Camera, Vec3 } from 'mirrorball';
import { describe, expect, test } from 'vitest';
import {
  addMoves,
  dolly,
  isNegligible,
  MAX_PITCH,
  moveCamera,
  orbit,
  pan,
  polar,
  scaleMove,
  screenAxes,
  stillMove,
} from './camera-controls.ts';

const camera: Camera = { eye: [3, 2, 5], target: [0.5, 1, -1], up: [0, 1, 0], verticalFov: 50 };

const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const near = (a: Vec3, b: Vec3): void => {
  for (const axis of [0, 1, 2] as const) expect(a[axis]).toBeCloseTo(b[axis], 9);
};

describe('orbit', () => {
  test('by 360° in 36 steps comes back', () => {
    let turned = camera;
    for (let i = 0; i < 36; i++) turned = orbit(turned, 10, 0);
    near(turned.eye, camera.eye);
  });

  test('keeps target and distance', () => {
    const turned = orbit(camera, 33, -20);
    near(turned.target, camera.target);
    expect(polar(turned).distance).toBeCloseTo(polar(camera).distance, 9);
  });

  test('with a positive yaw takes the eye to its right', () => {
    const moved = minus(orbit(camera, 1, 0).eye, camera.eye);
    expect(dot(moved, screenAxes(camera).right)).toBeGreaterThan(0);
  });

  test('stops at the poles, and up stays +Y', () => {
    expect(polar(orbit(camera, 0, 500)).pitch).toBeCloseTo(MAX_PITCH, 6);
    expect(polar(orbit(camera, 0, -500)).pitch).toBeCloseTo(-MAX_PITCH, 6);
    expect(orbit({ ...camera, up: [1, 0, 0] }, 5, 5).up).toEqual([0, 1, 0]);
  });

  test('comes back from a pole with the same yaw', () => {
    const there = orbit(orbit(camera, 0, 500), 0, polar(camera).pitch - MAX_PITCH);
    near(there.eye, camera.eye);
  });
});

test('an orthographic view is enlarged instead of approached, and shifted by its own height', () => {
  const flat: Camera = { ...camera, projection: 'orthographic', viewHeight: 6 };
  expect(dolly(flat, 0.5)).toEqual({ ...flat, viewHeight: 3 });
  const moved = minus(pan(flat, 0, 0.5).eye, flat.eye);
  expect(dot(moved, screenAxes(flat).up)).toBeCloseTo(3, 9);
});

describe('pan', () => {
  test('keeps the direction and the distance', () => {
    const shifted = pan(camera, 0.3, -0.7);
    near(minus(shifted.eye, shifted.target), minus(camera.eye, camera.target));
  });

  test('by one height moves by what the picture is high at the target', () => {
    const moved = minus(pan(camera, 0, 1).target, camera.target);
    expect(Math.sqrt(dot(moved, moved))).toBeCloseTo(2 * Math.tan((25 * Math.PI) / 180) * polar(camera).distance, 9);
    expect(dot(moved, minus(camera.eye, camera.target))).toBeCloseTo(0, 9);
  });

  test('and back is nothing', () => {
    near(pan(pan(camera, 0.4, 0.2), -0.4, -0.2).eye, camera.eye);
  });
});

describe('dolly', () => {
  test('scales the distance and keeps the direction', () => {
    const closer = dolly(camera, 0.5);
    expect(polar(closer).distance).toBeCloseTo(polar(camera).distance / 2, 9);
    expect(polar(closer).yaw).toBeCloseTo(polar(camera).yaw, 9);
  });

  test('never goes through the target', () => {
    let closer = camera;
    for (let i = 0; i < 200; i++) closer = dolly(closer, 0.5);
    expect(polar(closer).distance).toBeGreaterThan(0);
    expect(polar(closer).yaw).toBeCloseTo(polar(camera).yaw, 6);
  });
});

describe('moves', () => {
  test('nothing changes nothing', () => near(moveCamera(camera, stillMove).eye, camera.eye));

  test('taken in shares add up to the whole', () => {
    const move = { yaw: 30, pitch: 10, panX: 0, panY: 0, dolly: -0.5 };
    const rest = addMoves(move, scaleMove(move, -0.25));
    near(moveCamera(moveCamera(camera, scaleMove(move, 0.25)), rest).eye, moveCamera(camera, move).eye);
  });

  test('end when they cannot be seen any more', () => {
    expect(isNegligible(stillMove)).toBe(true);
    expect(isNegligible({ ...stillMove, yaw: 1 })).toBe(false);
    expect(isNegligible({ ...stillMove, dolly: -0.01 })).toBe(false);
  });

  test('a camera in its own target stays finite', () => {
    const moved = moveCamera({ ...camera, eye: camera.target }, { yaw: 5, pitch: 5, panX: 1, panY: 1, dolly: 1 });
    expect(moved.eye.every(Number.isFinite)).toBe(true);
  });
});
