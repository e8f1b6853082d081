import { expect, test } from 'vitest';
import type { Material } from '../../scene/scene.ts';
import { parseScene } from '../../scene-file/parse-scene.ts';
import { readMtl } from './read-mtl.ts';

function read(lines: string) {
  const file = readMtl(new TextEncoder().encode(lines), 'it.mtl');
  if (!file.ok) throw new Error(file.problems.map(({ message }) => message).join('\n'));
  return file;
}
const one = (...lines: string[]) => read(['newmtl m', ...lines].join('\n'));
const material = (...lines: string[]) => one(...lines).materials.m;
const problems = (lines: string): string[] => {
  const file = readMtl(new TextEncoder().encode(lines), 'it.mtl');
  return file.ok ? [] : file.problems.map(({ message }) => message);
};

test.each<[string, string[], Partial<Material>]>([
  ['nothing said', [], { baseColor: [0.8, 0.8, 0.8] }],
  ['matte', ['Kd 0.1 0.2 0.3', 'illum 1', 'Ns 50', 'Ks 0.5 0.5 0.5'], { baseColor: [0.1, 0.2, 0.3] }],
  ['one number for all channels', ['Kd 0.4'], { baseColor: [0.4, 0.4, 0.4] }],
  ['too bright', ['Kd 2 0.5 -1'], { baseColor: [1, 0.5, 0] }],
  ['no highlight without Ks', ['Kd 1 1 1', 'Ks 0 0 0', 'Ns 100'], { baseColor: [1, 1, 1] }],
  ['a highlight', ['Kd 1 0 0', 'Ks 0.5 0.5 0.5', 'Ns 6'], { type: 'metallicRoughness', baseColor: [1, 0, 0], specular: 0.5, roughness: 0.25 ** 0.25 }],
  ['a mirror', ['illum 3', 'Kd 0 0 0', 'Ks 0.9 0.9 0.9'], { baseColor: [0, 0, 0], reflectivity: 0.9 }],
  ['Pr and Pm', ['Kd 1 0.8 0.3', 'Pr 0.35', 'Pm 1', 'Ns 200', 'illum 3'], { type: 'metallicRoughness', baseColor: [1, 0.8, 0.3], metallic: 1, roughness: 0.35 }],
  ['Pm alone', ['Pm 0.5', 'Ns 0'], { type: 'metallicRoughness', baseColor: [0.8, 0.8, 0.8], metallic: 0.5, roughness: 1 }],
  ['light', ['Kd 0 0 0', 'Ke 5 4 3'], { baseColor: [0, 0, 0], emission: [5, 4, 3] }],
  ['no light', ['Ke 0 0 0'], { baseColor: [0.8, 0.8, 0.8] }],
  ['opacity', ['d 0.4', 'Kd 1 0 0'], { baseColor: [1, 0, 0], alphaMode: 'blend', opacity: 0.4 }],
  ['glass by illumination', ['illum 7', 'Ni 1.33', 'Kd 1 0 0', 'Tf 0.9 1 1'], { type: 'dielectric', baseColor: [0.9, 1, 1], ior: 1.33 }],
  ['glass by opacity', ['d 0.05', 'Pr 0.2'], { type: 'dielectric', baseColor: [1, 1, 1], roughness: 0.2 }],
  ['glass that refracts too much', ['illum 4', 'Ni 9'], { type: 'dielectric', baseColor: [1, 1, 1], ior: 4 }],
  ['Tr, which is opacity to some programs', ['Tr 1', 'Kd 1 1 1'], { baseColor: [1, 1, 1] }],
])('%s', (_, lines, expected) => {
  const made = material(...lines);
  expect(made).toEqual(expected);
  const shapes = { ball: { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'm' } };
  const camera = { eye: [0, 0, 5], target: [0, 0, 0] };
  expect(parseScene({ version: 1, name: 'm', camera, materials: { m: made }, shapes })).toMatchObject({ ok: true });
}); // biome-ignore format: table

const PLASTIC = { type: 'metallicRoughness', baseColor: [0.8, 0.8, 0.8], roughness: 1 } as const;
test.each<[string, string[], Partial<Material>]>([
  ['a picture of colours', ['map_Kd wood.png'], { ...PLASTIC, baseColorTexture: { texture: 'wood.png' } }],
  ['over a colour and a highlight', ['Kd 1 0.5 0', 'Ks 1 1 1', 'Ns 30', 'map_Kd a b.JPG'], { type: 'metallicRoughness', baseColor: [1, 0.5, 0], specular: 1, roughness: 0.5, baseColorTexture: { texture: 'a b.JPG' } }],
  ['with the folders of another machine', ['map_Kd C:\\tmp\\x\\wood.png'], { ...PLASTIC, baseColorTexture: { texture: 'wood.png' } }],
  ['in a folder', ['map_Kd .\\maps\\wood.png'], { ...PLASTIC, baseColorTexture: { texture: 'maps/wood.png' } }],
  ['more than once', ['map_Kd -s 2 4 1 -o 0.25 0.5 -texres 9 wood.png'], { ...PLASTIC, baseColorTexture: { texture: 'wood.png', scale: [2, 4], offset: [0.25, -3.5] } }],
  ['with holes by its alpha', ['map_Kd leaf.png', 'map_d leaf.png'], { ...PLASTIC, alphaMode: 'blend', opacity: 1, baseColorTexture: { texture: 'leaf.png' } }],
  ['bumps', ['norm -bm 0.5 n.png'], { ...PLASTIC, normalTexture: { texture: 'n.png', normalScale: 0.5 } }],
  ['a picture of light', ['map_Ke glow.png'], { type: 'metallicRoughness', baseColor: [0.8, 0.8, 0.8], emission: [1, 1, 1], emissionTexture: { texture: 'glow.png' } }],
  ['a picture of light over none', ['Ke 0 0 0', 'map_Ke glow.png'], { baseColor: [0.8, 0.8, 0.8] }],
])('textures: %s', (_, lines, expected) => {
  const { materials, notes } = one(...lines);
  expect(materials.m).toEqual(expected);
  expect(notes).toEqual([]);
}); // biome-ignore format: table

test('textures count from the folder of the file; options that are not known are told', () => {
  const file = readMtl(
    new TextEncoder().encode('newmtl m\nmap_Kd -clamp on -mm 0 2 a.png\nmap_d b.png'),
    'parts/it.mtl',
  );
  expect(file).toMatchObject({
    ok: true,
    materials: { m: { baseColorTexture: { texture: 'parts/a.png' } } },
    notes: ['Nothing is made of map_Kd -clamp, map_Kd -mm, map_d of the material "m".'],
  });
});

test('what nothing is made of is told by material', () => {
  const { notes } = one(
    'Kd 1 1 1',
    'Ka 1 1 1',
    'map_Kd wood.tga',
    'bump -bm 0.2 w.png',
    'Ks spectral a.rfl',
    'Ks 1 0.5 0',
    'illum 2',
    'Ns 9',
  );
  expect(notes).toEqual(['Nothing is made of map_Kd, bump, Ks of the material "m".']);
  expect(one('d -halo 0.3').notes).toEqual(['Nothing is made of d -halo of the material "m".']);
  const many = Array.from({ length: 25 }, (_, k) => `newmtl m${k}\nbump a.png`).join('\n');
  expect(read(many).notes).toHaveLength(21);
  expect(read(many).notes.at(-1)).toBe('The same is true of 5 more materials.');
});

test('several materials, names with spaces and of any language, the last of two alike', () => {
  const { materials } = read(
    '# c\nnewmtl red paint\nKd 1 0 0\nnewmtl 木\nKd 0 1 0\r\nnewmtl red paint\nKd 0 0 1\nnewmtl toString',
  );
  expect(Object.keys(materials)).toEqual(['red paint', '木', 'toString']);
  expect(materials['red paint']).toEqual({ baseColor: [0, 0, 1] });
});

test.each([
  ['nothing', '', 'no material'],
  ['a statement before any material', 'Kd 1 1 1\nnewmtl m', 'At line 1 "it.mtl" has "Kd" before any material'],
  ['no name', 'newmtl\nKd 1 1 1', 'At line 1 "it.mtl" has a material without a name'],
  ['a word as number', 'newmtl m\nNs high', 'At line 2 "it.mtl" has "high" as "Ns"; expected a number.'],
  ['two numbers of a colour', 'newmtl m\nKd 1 1', 'At line 2 "it.mtl" has "" as "Kd"'],
  ['no number', 'newmtl m\nd', 'At line 2 "it.mtl" has "" as "d"'],
  ['infinite light', 'newmtl m\nKe inf 0 0', '"inf" as "Ke"'],
])('%s', (_, lines, expected) => expect(problems(lines)[0]).toContain(expected));
