/** Scenes that look for speckles, dotted faces and light leaks. Each says what it is after. */
import type { Camera, Scene, Shape, SphereLight, Vec3 } from '../../../packages/renderer/src/scene/scene.ts';
import { testLight, testMaterial, testScene } from '../../fixtures/scenes.ts';

const material = 'white';
const UP: Vec3 = [0, 1, 0];
const box = (center: Vec3, size: Vec3, rotation: Vec3 = [0, 0, 0], of = material): Shape => ({
  type: 'box',
  center,
  size,
  rotation,
  material: of,
});
const sphere = (center: Vec3, radius: number, of = material): Shape => ({
  type: 'sphere',
  center,
  radius,
  material: of,
});
const plane = (point: Vec3, normal: Vec3): Shape => ({ type: 'plane', point, normal, material });
const quad = (corner: Vec3, u: Vec3, v: Vec3): Shape => ({ type: 'quad', corner, u, v, material });
const looking = (eye: Vec3, target: Vec3, verticalFov = 60): Camera => ({ eye, target, up: UP, verticalFov });

const materials = {
  white: testMaterial({ baseColor: [0.8, 0.75, 0.7], specular: 0.3, roughness: 0.4 }),
  mirror: testMaterial({ baseColor: [0.9, 0.9, 0.9], reflectivity: 0.8, roughness: 0.3 }),
};
const sky = { horizon: [0.3, 0.4, 0.5], zenith: [0.1, 0.2, 0.5] } as const;
const lamp = testLight({ center: [1.5, 3, 2], radius: 0.3, radiance: 40, ambient: [0.1, 0.1, 0.1] });
const floor = plane([0, 0, 0], UP);

const scene = (shapes: Record<string, Shape>, camera: Camera, light = lamp): Scene =>
  testScene(shapes, { light }, { camera, materials, sky });

const stacked = {
  floor,
  lower: box([0, 0.5, 0], [1, 1, 1]),
  upper: box([0, 1.25, 0], [1, 0.5, 1], [0, 0, 0], 'mirror'),
  turned: box([-1.5, 0.4, 0.2], [0.8, 0.8, 0.8], [0, 33, 0], 'mirror'),
  'on turned': box([-1.5, 1, 0.2], [0.8, 0.4, 0.8], [0, 33, 0]),
  ball: sphere([1.2, 0.4, 0.6], 0.4, 'mirror'),
};

export const hardScenes: Readonly<Record<string, Scene>> = {
  'camera inside a sphere': scene(
    { shell: sphere([0, 1, 0], 2, 'mirror'), inner: sphere([0.4, 0.7, -0.8], 0.3) },
    looking([0.5, 1.2, 0.7], [0, 1, -1]),
    { ...lamp, center: [0.3, 2, 0.3] },
  ),
  'camera inside a turned box': scene(
    { room: box([0, 1, 0], [4, 3, 5], [10, 20, 30], 'mirror'), inner: box([0, 1, -1], [0.5, 0.5, 0.5], [0, 40, 0]) },
    looking([0.3, 1.2, 1.5], [0, 1, -1]),
    { ...lamp, center: [0.3, 1.9, 0.3] },
  ),
  'camera inside a straight box': scene(
    { room: box([0, 1, 0], [4, 2, 4], [0, 0, 0], 'mirror') },
    looking([0.1, 1.03, 1], [0.1, 1.03, -1], 90),
    { ...lamp, center: [0.5, 1.5, 0.5] },
  ),
  'boxes standing on a floor and on each other': scene(stacked, looking([2, 2, 4], [-0.2, 0.6, 0])),
  'a plane to the horizon': scene({ floor, low: box([0, 0.05, -3], [1, 0.1, 1]) }, looking([0, 0.02, 2], [0, 0.02, 0])),
  'planes level with the view, turned away': scene(
    { floor: plane([0, 0, 0], [0, -1, 0]), ceiling: plane([0, 1.2, 0], [0, 1, 0]) },
    looking([0, 0.5, 2], [0, 0.5, 0]),
  ),
  'a row of pixels along the top of a box': scene(
    { floor, top: box([0, 0.5, 0], [1, 1, 1]), side: box([1.5, 0.5, -1], [1, 2, 1]) },
    looking([0, 1, 3], [0, 1, 0]),
  ),
  'a view straight down along faces': scene(
    { floor, a: box([0.5, 0.5, 0.5], [1, 1, 1]), b: box([-0.5, 0.25, -0.5], [1, 0.5, 1], [0, 90, 0]) },
    { eye: [0, 5, 0], target: [0, 0, 0], up: [0, 0, -1], verticalFov: 50 },
  ),
  'boxes as thin as paper': scene(
    {
      floor,
      sheet: box([0, 0.5, 0], [1, 1e-5, 1]),
      wall: box([-0.8, 0.6, -0.5], [1e-5, 1.2, 1.5]),
      turned: box([0.9, 0.6, -0.4], [1, 1e-5, 1], [50, 30, 10], 'mirror'),
    },
    looking([0.5, 1.3, 3], [0, 0.5, 0]),
  ),
  'a small ball far in front of a far light': scene(
    {
      wall: plane([0, 0, 0], [0, 0, 1]),
      ball: sphere([0.3, 0.2, 400], 0.2),
      dot: box([-0.5, 0, 400], [0.3, 0.3, 0.3]),
    },
    looking([2, 0, 4], [-0.2, 0, 0], 40),
    testLight({ center: [0, 0, 1000], radius: 1, radiance: 1e6, ambient: [0.1, 0.1, 0.1] }),
  ),
};

/** The same scene `scale` times as large, then moved: what the camera sees stays, with haze thinner per metre. */
export function moved(original: Scene, scale: number, by: number): Scene {
  const place = (p: Vec3): Vec3 => [p[0] * scale + by, p[1] * scale - by, p[2] * scale + by];
  const stretch = (p: Vec3): Vec3 => [p[0] * scale, p[1] * scale, p[2] * scale];
  const shape = (s: Shape): Shape => {
    if (s.type === 'sphere') return { ...s, center: place(s.center), radius: s.radius * scale };
    if (s.type === 'box') return { ...s, center: place(s.center), size: stretch(s.size) };
    if (s.type === 'plane') return { ...s, point: place(s.point) };
    if (s.type === 'mesh') throw new Error('Meshes are not moved here.');
    return { ...s, corner: place(s.corner), u: stretch(s.u), v: stretch(s.v) };
  };
  const map = <T>(things: Readonly<Record<string, T>>, change: (thing: T) => T): Record<string, T> =>
    Object.fromEntries(Object.entries(things).map(([name, thing]) => [name, change(thing)]));
  const { camera } = original;
  return {
    ...original,
    camera: { ...camera, eye: place(camera.eye), target: place(camera.target) },
    shapes: map(original.shapes, shape),
    lights: map(original.lights as Record<string, SphereLight>, (l) => ({
      ...l,
      center: place(l.center),
      radius: l.radius * scale,
      halo: l.halo / scale,
    })),
  };
}

/** Closed rooms two metres wide about the origin, with every light outside. */
const inside = looking([0.2, 0.1, 0.7], [-0.3, -0.2, -1], 100);
const outside = {
  above: testLight({ center: [0, 4, 0], radius: 1, radiance: 1e4 }),
  aside: testLight({ center: [3, 0.9, 2.5], radius: 1.5, radiance: 1e4 }),
};
const X: Vec3 = [2, 0, 0];
const Y: Vec3 = [0, 2, 0];
const Z: Vec3 = [0, 0, 2];
const rooms: Readonly<Record<string, Readonly<Record<string, Shape>>>> = {
  'six planes': {
    left: plane([-1, 0, 0], [1, 0, 0]),
    right: plane([1, 0, 0], [1, 0, 0]),
    down: plane([0, -1, 0], UP),
    up: plane([0, 1, 0], UP),
    back: plane([0, 0, -1], [0, 0, 1]),
    front: plane([0, 0, 1], [0, 0, 1]),
  },
  'six quads': {
    left: quad([-1, -1, -1], Y, Z),
    right: quad([1, -1, -1], Y, Z),
    down: quad([-1, -1, -1], X, Z),
    up: quad([-1, 1, -1], X, Z),
    back: quad([-1, -1, -1], X, Y),
    front: quad([-1, -1, 1], X, Y),
  },
  'one box': { room: box([0, 0, 0], [2, 2, 2]) },
  'one turned box': { room: box([0, 0, 0], [2.2, 2.1, 2], [20, 30, 40]) },
  'one sphere': { room: sphere([0, 0, 0], 1.3) },
};
/** With mirrors, so that paths come back to the edges many times. */
export const darkRooms: Readonly<Record<string, Scene>> = Object.fromEntries(
  Object.entries(rooms).map(([name, shapes]) => [
    name,
    testScene(shapes, outside, {
      camera: inside,
      materials: { white: testMaterial({ reflectivity: 0.9, baseColor: [1, 1, 1], specular: 1 }) },
      sky: { horizon: [9, 9, 9], zenith: [9, 9, 9] },
    }),
  ]),
);
