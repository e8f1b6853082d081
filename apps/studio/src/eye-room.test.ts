import type { Camera, Plane, Scene, Vec3 } from 'mirrorball';
import { builtInScenes } from 'mirrorball/built-in';
import { describe, expect, test } from 'vitest';
import { between, seededRandom } from '../../../tests/fixtures/random.ts';
import { moveCamera, polar, stillMove } from './camera-controls.ts';
import { wallsAbout } from './eye-room.ts';

const { scene } = builtInScenes.find(({ id }) => id === 'cube-room')!;
const move = (camera: Camera, part: Partial<typeof stillMove>, within: Scene = scene): Camera =>
  moveCamera(camera, { ...stillMove, ...part }, wallsAbout(within, camera.eye, camera.target));
/** Metres from the nearest plane; negative beyond one. The room's normals point inwards. */
const clearance = ({ eye }: Camera): number =>
  Math.min(
    ...Object.values(scene.shapes)
      .filter((shape): shape is Plane => shape.type === 'plane')
      .map(({ point, normal }) => normal.reduce((sum, n, c) => sum + n * (eye[c]! - point[c]!), 0)),
  );
const direction = ({ eye, target }: Camera): Vec3 => {
  const length = Math.hypot(...eye.map((x, c) => target[c]! - x));
  return eye.map((x, c) => (target[c]! - x) / length) as unknown as Vec3;
};

describe('in the closed room', () => {
  test('the wheel outwards stops before the wall, and looks the same way', () => {
    let camera = scene.camera;
    for (let notch = 0; notch < 20; notch++) camera = move(camera, { dolly: 0.15 });
    expect(clearance(camera)).toBeGreaterThan(0.01);
    expect(clearance(camera)).toBeLessThan(0.1);
    for (const axis of [0, 1, 2]) expect(direction(camera)[axis]!).toBeCloseTo(direction(scene.camera)[axis]!, 9);
  });

  test('a drag all around never leaves it, and needs no wall to', () => {
    let camera = scene.camera;
    for (let step = 0; step < 72; step++) {
      camera = move(camera, { yaw: 5 });
      expect(clearance(camera)).toBeGreaterThan(0.05);
    }
    expect(polar(camera).distance).toBeCloseTo(polar(scene.camera).distance, 6);
  });

  test('a drag downwards stops at the floor, and turning goes on there', () => {
    let camera = scene.camera;
    for (let step = 0; step < 30; step++) camera = move(camera, { pitch: -5 });
    expect(clearance(camera)).toBeGreaterThan(0.01);
    const turned = move(camera, { yaw: 10 });
    expect(polar(turned).yaw - polar(camera).yaw).toBeCloseTo(10, 0);
  });

  test('a shift stops at the wall and keeps the direction', () => {
    let camera = scene.camera;
    for (let step = 0; step < 50; step++) camera = move(camera, { panX: -0.1 });
    expect(clearance(camera)).toBeGreaterThan(0.01);
    for (const axis of [0, 1, 2]) expect(direction(camera)[axis]!).toBeCloseTo(direction(scene.camera)[axis]!, 6);
  });

  test('no row of moves leaves it (seed 81)', () => {
    const random = seededRandom(81);
    for (let row = 0; row < 50; row++) {
      let camera = scene.camera;
      for (let step = 0; step < 60; step++) {
        const [yaw, pitch] = [between(random, -90, 90), between(random, -60, 60)];
        const [panX, panY] = [between(random, -1, 1), between(random, -1, 1)];
        camera = move(camera, { yaw, pitch, panX, panY, dolly: between(random, -1, 1) });
        expect(clearance(camera)).toBeGreaterThan(0);
        expect([...camera.eye, ...camera.target].every(Number.isFinite)).toBe(true);
      }
    }
  });
});

test('an eye that starts closer than the margin is not pushed away', () => {
  const camera: Camera = { ...scene.camera, eye: [0, 1, 1.9999], target: [0, 1, -2] };
  expect(move(camera, {}).eye).toEqual(camera.eye);
  expect(move(camera, { dolly: 0.5 }).eye[2]).toBeCloseTo(1.9999, 9);
});

test('a plane is minded where it is at the time, from whichever side', () => {
  const shifted = (height: number): Scene => ({
    ...scene,
    shapes: { ground: { type: 'plane', point: [0, height, 0], normal: [0, 5, 0], material: 'oak' } },
  });
  const camera: Camera = { eye: [0, 2, 5], target: [0, 2, 0], up: [0, 1, 0], verticalFov: 40 };
  expect(move(camera, { pitch: -80 }, shifted(0)).eye[1]).toBeCloseTo(0.1, 6);
  expect(move(camera, { pitch: -80 }, shifted(1)).eye[1]).toBeCloseTo(1.1, 6);
  expect(move(camera, { pitch: 80 }, shifted(3)).eye[1]).toBeCloseTo(2.9, 6);
  expect(move(camera, { pitch: 10 }, shifted(2))).toEqual(move(camera, { pitch: 10 }, { ...scene, shapes: {} }));
});
