import { expect, test } from 'vitest';
import { testLight, testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import { lampsAsShapes } from '../scene/lamps.ts';
import type { Light, Shape, Vec3 } from '../scene/scene.ts';
import type { EmitterValues } from './emitter-values.ts';
import { emittersOf } from './pack-emitters.ts';

const EYE: Vec3 = [10, 20, 30];
const COLOR = [0.5, 1, 2] as const;
const quad = { type: 'quad', corner: [0, 0, 0], u: [2, 0, 0], v: [0, 0, 3] } as const;

const lights = {
  ball: testLight({ center: [1, 2, 3], radius: 0.5, radiance: 2, diffuse: COLOR, visible: true }),
  'unseen ball': testLight({ center: [1, 2, 3], radius: 0.5, radiance: 2 }),
  panel: { ...quad, radiance: 3, color: COLOR, visible: true },
  dark: testLight({ radiance: 0, visible: true }),
  bulb: { type: 'point', position: [0, 1, 0], intensity: 6, color: COLOR },
  spot: {
    type: 'spot',
    position: [0, 1, 0],
    direction: [0, -3, 0],
    intensity: 6,
    color: COLOR,
    innerAngle: 30,
    outerAngle: 60,
  },
  sun: { type: 'directional', direction: [0, -2, 0], irradiance: 5, color: COLOR, angle: 0 },
  'wide sun': { type: 'directional', direction: [0, -2, 0], irradiance: 5, color: COLOR, angle: 1 },
} as const satisfies Record<string, Light>;
const shapes = {
  plain: { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'white' },
  lantern: { type: 'box', center: [1, 1, 1], size: [2, 4, 6], rotation: [0, 45, 0], material: 'glow' },
  sheet: { ...quad, material: 'glow' },
} as const satisfies Record<string, Shape>;
const materials = { white: testMaterial(), glow: testMaterial({ emission: [1, 0, 2] }) };

const lampScene = () => lampsAsShapes(testScene(shapes, lights, { materials }));
const rowOf = (name: string) => 100 + Object.keys(lampScene().scene.shapes).indexOf(name);

test('visible sphere and quad lights get black shapes of their radiance, under names that no file has', () => {
  const { scene, lightOfShape } = lampScene();
  expect([...lightOfShape]).toEqual([
    [' ball', 'ball'],
    [' panel', 'panel'],
    [' dark', 'dark'],
  ]);
  expect(Object.keys(scene.shapes)).toEqual(['plain', 'lantern', 'sheet', ' ball', ' panel', ' dark']);
  expect(scene.shapes[' ball']).toEqual({ type: 'sphere', center: [1, 2, 3], radius: 0.5, material: ' ball' });
  expect(scene.shapes[' panel']).toEqual({ ...quad, material: ' panel' });
  expect(scene.materials[' ball']).toMatchObject({ baseColor: [0, 0, 0], reflectivity: 0, emission: [1, 2, 4] });
  expect(scene.materials[' panel']!.emission).toEqual([1.5, 3, 6]);
});

test('a light may be named like a shape or like anything that objects inherit', () => {
  const ball = lights.ball;
  const { scene } = lampsAsShapes(testScene({ ball: shapes.plain }, { ball, ' ball': ball, toString: ball } as never));
  expect(Object.keys(scene.shapes)).toEqual(['ball', ' ball', '  ball', ' toString']);
});

test('everything that shines becomes an emitter, relative to the eye, with the row of its shape', () => {
  const { emitters, emitterOfShape, far } = emittersOf(lampScene(), EYE, rowOf);
  const [sun, wideSun, ball, unseen, panel, bulb, spot, lantern, sheet] = emitters as EmitterValues[];
  expect(emitters).toHaveLength(9);
  expect(far).toBe(2);
  expect(ball).toMatchObject({
    kind: 0,
    position: [-9, -18, -27],
    radius: 0.5,
    radiance: [1, 2, 4],
    shape: 103,
    reach: 0.5,
  });
  expect(ball!.power).toBeCloseTo((7 / 3) * Math.PI * 0.25, 12);
  expect(unseen).toMatchObject({ kind: 0, shape: -1 });
  expect(panel).toMatchObject({
    kind: 1,
    u: [2, 0, 0],
    v: [0, 0, 3],
    area: 6,
    oneSided: 1,
    shape: 104,
    radiance: [1.5, 3, 6],
  });
  expect(bulb).toMatchObject({ kind: 3, radiance: [3, 6, 12], power: 7, shape: -1 });
  expect(spot).toMatchObject({ kind: 4, u: [0, -1, 0], shape: -1 });
  expect([spot!.cosInner, spot!.radius]).toEqual([Math.cos(Math.PI / 6), Math.cos(Math.PI / 3)]);
  expect(sun).toMatchObject({ kind: 5, u: [0, -1, 0], radius: 1, area: 0, radiance: [2.5, 5, 10] });
  const solidAngle = 2 * Math.PI * (1 - Math.cos(Math.PI / 360));
  expect(wideSun!.area).toBeCloseTo(solidAngle, 12);
  // Small enough that all of its cosines are 1 up to 4e-5.
  expect((wideSun!.radiance as number[])[1]! * solidAngle).toBeCloseTo(5, 3);
  expect(lantern).toMatchObject({ kind: 2, u: [1, 2, 3], area: 88, shape: 101, radiance: [1, 0, 2] });
  expect(sheet).toMatchObject({ kind: 1, oneSided: 0, shape: 102 });
  expect([...emitterOfShape]).toEqual([
    [' ball', 2],
    [' panel', 4],
    ['lantern', 7],
    ['sheet', 8],
  ]);
});

test('a sky is an emitter unless it is black', () => {
  const sky = { horizon: [0, 0, 0], zenith: [0, 0, 3] } as const;
  const { emitters } = emittersOf(lampsAsShapes(testScene({}, {}, { sky })), EYE, rowOf);
  expect(emitters).toHaveLength(1);
  expect(emitters[0]).toMatchObject({ kind: 6, shape: -1 });
  expect(emitters[0]!.power).toBeCloseTo(Math.PI / 4, 12);
});

test('a spot whose angles are equal or the wrong way round keeps a falloff', () => {
  for (const innerAngle of [20, 60]) {
    const spot = { ...lights.spot, innerAngle, outerAngle: 20 };
    const { emitters } = emittersOf(lampsAsShapes(testScene({}, { spot })), EYE, rowOf);
    const { cosInner, radius } = emitters[0]!;
    expect(Math.fround(cosInner as number)).toBeGreaterThan(Math.fround(radius as number));
  }
});

test('lights come first, then shapes, the strongest first', () => {
  const many = Object.fromEntries(
    Array.from({ length: 80 }, (_, k) => [`s${k}`, { ...shapes.plain, radius: 1 + k, material: 'glow' }]),
  );
  const scene = testScene(many, { bulb: lights.bulb }, { materials });
  const { emitters, emitterOfShape } = emittersOf(lampsAsShapes(scene), EYE, () => 0);
  expect(emitters).toHaveLength(81);
  expect(emitters[0]!.kind).toBe(3);
  expect(emitterOfShape.get('s79')).toBe(1);
  expect(emitterOfShape.get('s0')).toBe(80);
});

test('a sun too small to be a disc is a point at infinity; any other has a radiance in 32 bits', () => {
  const sun = (angle: number) => {
    const light = {
      type: 'directional',
      direction: [0, -1, 0],
      irradiance: 1e6,
      color: [1e3, 1e3, 1e3],
      angle,
    } as const;
    const { emitters } = emittersOf(lampsAsShapes(testScene({}, { light })), EYE, () => 0);
    return { area: emitters[0]!.area as number, radiance: (emitters[0]!.radiance as readonly number[])[0]! };
  };
  for (const angle of [0, 5e-324, 1e-20, 0.99e-5]) expect(sun(angle)).toEqual({ area: 0, radiance: 1e9 });
  for (const angle of [1e-5, 1e-3, 90]) {
    expect(sun(angle).area).toBeGreaterThan(0);
    expect(Math.fround(sun(angle).radiance)).toBeLessThan(1e30);
  }
});
