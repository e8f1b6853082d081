import { describe, expect, test } from 'vitest';
import { writeScene } from '../../packages/renderer/src/scene-file/index.ts';
import { ConversionError, convertScene } from './convert-scene.ts';

const MESH = { type: 'mesh', file: 'a.ply', smooth: true, material: 'm' };
const PLACED = [
  [0, -2, 0, 5],
  [2, 0, 0, 6],
  [0, 0, 2, 7],
  [0, 0, 0, 1],
];
const PROJECTIVE = [...PLACED.slice(0, 3), [0, 0, 0.1, 1]];
const FLAT = [PLACED[0], PLACED[0], ...PLACED.slice(2)];
const BALL = { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'm' };
const neutral = (part: object = {}) => ({
  format: 'neutral-scene',
  version: 1,
  name: 'test',
  image: { width: 64, height: 32, filter: 'box', view_exposure: 0.5 },
  max_depth: 5,
  camera: { eye: [0, 0, 4], target: [0, 0, 0], up: [0, 1, 0], vfov_deg: 36, aspect: 2 },
  materials: { m: { type: 'diffuse', albedo: [0.1, 0.2, 0.3] } },
  primitives: [BALL],
  lights: [{ type: 'constant', radiance: [1, 2, 3] }],
  ...part,
});
const converted = (part?: object) => convertScene(neutral(part)).scene;
const material = (m: object) => converted({ materials: { m } }).materials.m!;
const light = (l: object) => Object.values(converted({ lights: [l] }).lights)[0];

function problems(part: object): string {
  try {
    converted(part);
  } catch (error) {
    if (error instanceof ConversionError) return error.message;
    throw error;
  }
  return 'none';
}

test('camera, picture, depth, exposure, sky', () => {
  const { scene, width, height } = convertScene(neutral());
  expect([width, height]).toEqual([64, 32]);
  expect(scene.camera).toMatchObject({ eye: [0, 0, 4], target: [0, 0, 0], up: [0, 1, 0], verticalFov: 36 });
  expect(scene.render).toMatchObject({ integrator: 'path', maxDepth: 5, exposure: -1 });
  expect(scene.sky).toEqual({ horizon: [1, 2, 3], zenith: [1, 2, 3] });
  expect(converted({ lights: [] }).sky.horizon).toEqual([0, 0, 0]);
  const envmap = { type: 'envmap', file: '../meshes/sun.npy', scale: 2 };
  expect(converted({ lights: [envmap] })).toMatchObject({ sky: { image: '../meshes/sun.npy', scale: 2 }, lights: {} });
  expect(writeScene(scene)).toContain('"sphere 1": { "type": "sphere"');
});

describe('materials', () => {
  const ggx = { type: 'rough_conductor', distribution: 'ggx', alpha: 0.09, masking: 'height_correlated' };
  const gltf = { type: 'gltf_metallic_roughness', base_color: [0.8, 0.3, 0.1], metallic: 0.5, roughness: 0.3 };
  const mirror = (r: number) => ({ type: 'mirror', reflectance: [r, r, r] });
  const blend = (a: object, b: object) => ({ type: 'blend', weight: 0.6, a, b });
  const red = { type: 'diffuse', albedo: [0.8, 0.2, 0] };

  test('diffuse', () => expect(material(red)).toMatchObject({ type: 'diffuse', baseColor: [0.8, 0.2, 0] }));
  test('a mirror is a smooth metal that gives back the same share at every angle', () => {
    const m = material({ type: 'mirror', reflectance: [0.8, 0.5, 0.2] });
    expect(m).toMatchObject({ type: 'conductor', baseColor: [0.8, 0.5, 0.2], roughness: 0 });
    expect(m.conductor).toEqual({ eta: [0, 0, 0], k: [0, 0, 0] });
  });
  test('roughness is the square root of alpha', () => {
    expect(material({ ...ggx, reflectance: [1, 1, 1] })).toMatchObject({ type: 'conductor', roughness: 0.3 });
    const glass = { type: 'rough_dielectric', ior: 1.5, alpha: 0.09, masking: 'height_correlated' };
    expect(material(glass)).toMatchObject({ type: 'dielectric', ior: 1.5, roughness: 0.3, baseColor: [1, 1, 1] });
  });
  test('separable masking stays', () => {
    const apart = { masking: 'separable', alpha: 0.25 };
    expect(material({ ...ggx, ...apart, reflectance: [1, 1, 1] })).toMatchObject({
      roughness: 0.5,
      masking: 'separable',
    });
    const frosted = material({ type: 'rough_dielectric', ior: 1.5, ...apart });
    expect(frosted).toMatchObject({ roughness: 0.5, masking: 'separable' });
    expect(material({ ...ggx, reflectance: [1, 1, 1] }).masking).toBeUndefined();
  });
  test('eta and k stay, with no tint', () => {
    const m = material({ ...ggx, eta: [0.1, 0.4, 1.4], k: [4, 2.4, 1.6] });
    expect(m.conductor).toEqual({ eta: [0.1, 0.4, 1.4], k: [4, 2.4, 1.6] });
    expect(m.baseColor).toEqual([1, 1, 1]);
  });
  test("Schlick's metal is glTF's", () =>
    expect(material({ ...ggx, f0: [0.9, 0.6, 0.3] })).toMatchObject({
      type: 'metallicRoughness',
      metallic: 1,
      baseColor: [0.9, 0.6, 0.3],
      roughness: 0.3,
    }));
  test('glass', () =>
    expect(material({ type: 'dielectric', ior: 1.8 })).toMatchObject({ type: 'dielectric', ior: 1.8, roughness: 0 }));
  test('a blend with a mirror is a reflectivity', () =>
    expect(material(blend(red, mirror(1)))).toMatchObject({ baseColor: [0.8, 0.2, 0], reflectivity: 0.6 }));
  test('a blend with a grey mirror keeps both shares', () => {
    const { baseColor, reflectivity } = material(blend(red, mirror(0.5)));
    expect(reflectivity).toBeCloseTo(0.3, 12);
    expect((1 - reflectivity) * baseColor[0]).toBeCloseTo(0.4 * 0.8, 12);
  });
  test('glTF', () => {
    const m = material({ ...gltf, form: 'mix' });
    expect(m).toMatchObject({ type: 'metallicRoughness', baseColor: [0.8, 0.3, 0.1], metallic: 0.5, roughness: 0.3 });
    expect(material({ ...gltf, form: 'simplified', metallic: 1 }).metallic).toBe(1);
  });

  test.each([
    ['separable masking of a Schlick metal', { ...ggx, masking: 'separable', f0: [1, 1, 1] }, /separable masking/],
    ['Beckmann', { ...ggx, distribution: 'beckmann', reflectance: [1, 1, 1] }, /beckmann/],
    ['no Fresnel', ggx, /either "reflectance"/],
    ['two kinds of Fresnel', { ...ggx, reflectance: [1, 1, 1], eta: [1, 1, 1], k: [1, 1, 1] }, /either "reflectance"/],
    ['eta without k', { ...ggx, eta: [1, 1, 1] }, /either "reflectance"/],
    ['alpha above 1', { ...ggx, alpha: 1.2, reflectance: [1, 1, 1] }, /alpha 1.2/],
    ["glTF's other reading", { ...gltf, form: 'simplified' }, /simplified/],
    ["Mitsuba's principled", { type: 'mitsuba_principled', whatever: 1 }, /principled/],
    ['a blend of two mirrors', blend(mirror(1), mirror(1)), /blend of mirror and mirror/],
    ['a blend with a coloured mirror', blend(red, { type: 'mirror', reflectance: [1, 1, 0.5] }), /coloured mirror/],
    ['an unknown kind', { type: 'velvet' }, /materials\.m/],
    ['an albedo above 1', { type: 'diffuse', albedo: [2, 0, 0] }, /baseColor/],
  ])('refuses %s', (_, m, message) => expect(problems({ materials: { m } })).toMatch(message));
});

describe('lights: the largest channel, and a colour', () => {
  test('sphere', () =>
    expect(light({ type: 'sphere', center: [1, 2, 3], radius: 0.5, radiance: [8, 4, 2] })).toMatchObject({
      type: 'sphere',
      center: [1, 2, 3],
      radius: 0.5,
      radiance: 8,
      diffuse: [1, 0.5, 0.25],
      ambient: [0, 0, 0],
      specular: [0, 0, 0],
      visible: true,
    }));
  test('quad: it shines to the side of u × v in both formats', () => {
    const quad = { type: 'quad', corner: [0, 1, 0], u: [1, 0, 0], v: [0, 0, 1] };
    expect(light({ ...quad, radiance: [2, 2, 2] })).toEqual({ ...quad, radiance: 2, color: [1, 1, 1], visible: true });
  });
  test('point', () =>
    expect(light({ type: 'point', position: [0, 3, 0], intensity: [16, 8, 4] })).toEqual({
      type: 'point',
      position: [0, 3, 0],
      intensity: 16,
      color: [1, 0.5, 0.25],
    }));
  test('directional', () =>
    expect(light({ type: 'directional', direction: [1, -2, 0], irradiance: [0.5, 1, 0] })).toEqual({
      type: 'directional',
      direction: [1, -2, 0],
      irradiance: 1,
      color: [0.5, 1, 0],
      angle: 0,
    }));
  test('black', () =>
    expect(light({ type: 'point', position: [0, 3, 0], intensity: [0, 0, 0] })).toMatchObject({ intensity: 0 }));
});

describe('meshes', () => {
  test('files get names, and shapes place them by their matrix', () => {
    const scene = converted({ primitives: [BALL, { ...MESH, file: '../meshes/star.ply', smooth: false, transform: PLACED }] }); // biome-ignore format: short
    expect(scene.meshes).toEqual({ star: { file: '../meshes/star.ply', shading: 'flat' } });
    expect(scene.shapes['mesh 1']).toMatchObject({ type: 'mesh', mesh: 'star', material: 'm', matrix: PLACED.flat() });
    expect(converted().meshes).toBeUndefined();
  });
  test('instances are meshes that are placed one by one; each file and shading is one', () => {
    const items = [
      { mesh: 'a', material: 'm', transform: PLACED },
      { mesh: 'b', material: 'm' },
      { mesh: 'a', material: 'm' },
    ];
    const meshes = { a: { file: 'a.ply', smooth: true }, b: { file: 'a.ply', smooth: false } };
    const scene = converted({ primitives: [MESH, { type: 'instances', meshes, items }] });
    expect(scene.meshes).toEqual({
      a: { file: 'a.ply', shading: 'smooth' },
      'a 2': { file: 'a.ply', shading: 'flat' },
    });
    const shapes = Object.entries(scene.shapes).map(([name, shape]) => [name, 'mesh' in shape && shape.mesh]);
    expect(shapes).toEqual([['mesh 1', 'a'], ['mesh 2', 'a'], ['mesh 3', 'a 2'], ['mesh 4', 'a']]); // biome-ignore format: short
    expect(writeScene(scene)).toContain('"mesh 3": { "type": "mesh", "mesh": "a 2", "material": "m" }');
  });
});

describe('boxes with shear', () => {
  const shear = [[1, 0.5, 0, 3], [0, 1, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]]; // biome-ignore format: a matrix
  const box = { type: 'box', min: [0, 0, 0], max: [1, 2, 1], material: 'm', transform: shear };
  test('are six parallelograms', () => {
    const shapes = Object.values(converted({ primitives: [BALL, box] }).shapes).slice(1);
    expect(shapes).toHaveLength(6);
    expect(shapes).toContainEqual({ type: 'quad', corner: [3, 0, 0], u: [1, 2, 0], v: [0, 0, 2], material: 'm' });
    expect(shapes).toContainEqual({ type: 'quad', corner: [4, 0, 0], u: [1, 2, 0], v: [0, 0, 2], material: 'm' });
    expect(shapes).toContainEqual({ type: 'quad', corner: [4, 2, 0], u: [0, 0, 2], v: [1, 0, 0], material: 'm' });
  });
  test('of glass are refused: they have an inside', () =>
    expect(problems({ primitives: [box], materials: { m: { type: 'dielectric', ior: 1.5 } } })).toMatch(/shear/));
});

test.each([
  ['meshes without a file', { primitives: [{ type: 'mesh', smooth: true, material: 'm' }] }, /primitives.0.file/],
  ['meshes of other files', { primitives: [{ ...MESH, file: 'a.off' }] }, /\/meshes\/a\/file/],
  ['meshes from elsewhere', { primitives: [{ ...MESH, file: '/a.ply' }] }, /\/meshes\/a\/file/],
  ['a projective mesh', { primitives: [{ ...MESH, transform: PROJECTIVE }] }, /mesh 1: a projective transform/],
  ['a flat mesh', { primitives: [{ ...MESH, transform: FLAT }] }, /shapes\/mesh 1\/matrix.*makes the mesh flat/],
  [
    'items without a mesh',
    { primitives: [{ type: 'instances', meshes: {}, items: [{ mesh: 'a', material: 'm' }] }] },
    /fault 1: no mesh "a"/,
  ],
  ['an environment map from elsewhere', { lights: [{ type: 'envmap', file: '/a.npy' }] }, /\/sky\/image/],
  [
    'an environment map and a constant light',
    {
      lights: [
        { type: 'envmap', file: 'a.npy' },
        { type: 'constant', radiance: [1, 1, 1] },
      ],
    },
    /one sky/,
  ],
  ['two skies', { lights: [1, 2].map((x) => ({ type: 'constant', radiance: [x, x, x] })) }, /one sky/],
  ['another filter', { image: { width: 64, height: 32, filter: 'tent', view_exposure: 1 } }, /"tent"/],
  ['stretched pixels', { image: { width: 64, height: 64, filter: 'box', view_exposure: 1 } }, /aspect/],
  ['unknown keys', { medium: 'fog' }, /medium/],
  ['another version', { version: 2 }, /version/],
  ['a material that is not there', { primitives: [{ ...BALL, material: 'x' }] }, /"x"/],
])('refuses %s', (_, part, message) => expect(problems(part)).toMatch(message));

test('refuses glass that is a mere quad', () => {
  const quad = { type: 'quad', corner: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0], material: 'm' };
  const part = { materials: { m: { type: 'dielectric', ior: 1.5 } }, primitives: [quad] };
  expect(problems(part)).toMatch(/dielectric quad/);
});

test('tells all problems at once', () => {
  const lines = problems({
    primitives: [{ ...MESH, transform: PROJECTIVE }, BALL, { ...MESH, transform: PROJECTIVE }],
    lights: [
      { type: 'envmap', file: 'a.npy' },
      { type: 'constant', radiance: [1, 1, 1] },
    ],
  }).split('\n');
  expect(lines.map((line) => line.split(':')[0])).toEqual(['lights', 'primitives.mesh 1', 'primitives.mesh 2']);
});
