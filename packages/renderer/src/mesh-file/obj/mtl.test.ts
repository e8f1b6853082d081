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
  ['with its options behind', ['map_Kd wood.png -s 2 2 -o 0 0'], { ...PLASTIC, baseColorTexture: { texture: 'wood.png', scale: [2, 2], offset: [0, -1] } }],
  ['with spaces as in a shell', ['map_Kd my\\ wood.png', 'Tf 1 1 1'], { ...PLASTIC, baseColorTexture: { texture: 'my wood.png' } }],
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

const mapped = (...lines: string[]) => {
  const { materials, textures, images, notes } = one(...lines);
  return { made: materials.m!, textures, images, notes };
};
const whole = (file: string, channel: string) => ({ file, channel, base: 0, gain: 1 });

test('textures count from the folder of the file; what is there once has a texture of its own', () => {
  const file = readMtl(new TextEncoder().encode('newmtl m\nmap_Kd -clamp on a.png\nmap_Ke b.png'), 'parts/it.mtl');
  expect(file).toMatchObject({
    ok: true,
    materials: {
      m: { baseColorTexture: { texture: 'parts/a.png, clamped' }, emissionTexture: { texture: 'parts/b.png' } },
    },
    textures: { 'parts/a.png, clamped': { image: 'parts/a.png', wrapU: 'clamp', wrapV: 'clamp' } },
    images: {},
    notes: [],
  });
});

test('words for normal maps and heights, in letters of either size; a normal map goes before heights', () => {
  for (const word of ['norm', 'map_norm', 'map_Kn', 'map_kn'])
    expect(mapped(`${word} n.png`).made.normalTexture).toEqual({ texture: 'n.png', normalScale: 1 });
  for (const word of ['bump', 'map_Bump', 'map_bump']) {
    const { made, images } = mapped(`${word} -bm 0.3 -mm 0 2 -imfchan r -clamp on h.png`);
    expect(made.normalTexture).toEqual({ texture: 'it.mtl: 1, clamped' });
    expect(images).toEqual({
      'it.mtl: 1': { kind: 'normals', heights: { file: 'h.png', channel: 'r', base: 0, gain: 2 }, strength: 0.3, clamp: true },
    });
  }
  const { made, notes } = mapped('norm n.png', 'bump h.png');
  expect(made.normalTexture!.texture).toBe('n.png');
  expect(notes).toEqual(['Nothing is made of bump of the material "m".']);
}); // biome-ignore format: long rows

test('opacity of its own lies in the alpha of the image of colours; alone it has white ones', () => {
  const { made, textures, images } = mapped('d 0', 'map_Kd c.png', 'map_d -imfchan m a.png');
  expect(made).toEqual({ ...PLASTIC, alphaMode: 'blend', opacity: 1, baseColorTexture: { texture: 'it.mtl: 1' } });
  expect(textures).toEqual({ 'it.mtl: 1': { image: 'it.mtl: 1' } });
  expect(images['it.mtl: 1']).toEqual({
    kind: 'channels',
    red: whole('c.png', 'r'),
    green: whole('c.png', 'g'),
    blue: whole('c.png', 'b'),
    alpha: whole('a.png', 'm'),
  });
  expect(mapped('map_d a.png').images['it.mtl: 1']).toEqual({ kind: 'channels', alpha: whole('a.png', 'opacity') });
  expect(mapped('map_Kd -s 2 2 c.png', 'map_d a.png').notes[0]).toContain('map_d (it lies in another way than map_Kd)');
});

test('roughness and metallic are channels of one image; a map of exponents is one of roughness', () => {
  const { made, images } = mapped('map_Pr r.png', 'map_Pm -imfchan b m.png', 'Pm 0.5');
  expect(made).toMatchObject({ roughness: 1, metallic: 0.5, metallicRoughnessTexture: { texture: 'it.mtl: 1' } });
  expect(images['it.mtl: 1']).toEqual({ kind: 'channels', green: whole('r.png', 'l'), blue: whole('m.png', 'b') });
  const shiny = mapped('Ks 1 1 1', 'Ns 62', 'map_Ns n.png');
  expect(shiny.made).toMatchObject({ roughness: 1, metallicRoughnessTexture: { texture: 'it.mtl: 1' } });
  expect(shiny.images['it.mtl: 1']).toEqual({ kind: 'channels', green: { ...whole('n.png', 'l'), exponent: 62 } });
  expect(mapped('illum 1', 'map_Ns n.png').notes).toEqual(['Nothing is made of map_Ns of the material "m".']);
});

test('the hue of a highlight, its picture, sheen, clear coat and anisotropy are groups of layers', () => {
  expect(mapped('Ks 1 0.5 0').made).toMatchObject({ specular: 1, specularLobe: { weight: 1, color: [1, 0.5, 0] } });
  expect(mapped('map_Ks k.png').made.specularLobe).toEqual({ weight: 1, color: [1, 1, 1], colorTexture: { texture: 'k.png' } });
  expect(mapped('Ks 0 0 0', 'map_Ks k.png')).toMatchObject({ made: { baseColor: [0.8, 0.8, 0.8] }, notes: [] });
  expect(mapped('Pr 0.4', 'Ps 0.3').made.sheen).toEqual({ color: [0.3, 0.3, 0.3], roughness: 0.4 });
  expect(mapped('map_Ps s.png').made.sheen).toEqual({ color: [1, 1, 1], roughness: 0.5, colorTexture: { texture: 'it.mtl: 1' } });
  expect(mapped('Pc 0.9', 'Pcr 0.1').made.clearcoat).toEqual({ weight: 0.9, roughness: 0.1 });
  expect(mapped('map_Pcr c.png', 'Pc 1').made.clearcoat).toEqual({ weight: 1, roughness: 1, roughnessTexture: { texture: 'it.mtl: 1' } });
  expect(mapped('aniso 0.5', 'anisor 0.25').made.anisotropy).toEqual({ strength: 0.5, rotation: 90 });
}); // biome-ignore format: long rows

test('what nothing is made of is told by material', () => {
  const { notes } = one('Kd 1 1 1', 'Ka 1 1 1', 'map_Ka x.png', 'map_Kd wood.tga', 'disp d.png', 'refl -type sphere s.png', 'Ks spectral a.rfl', 'Ns 9', 'map_Ke -cc on -t 1 0 0 e.png'); // biome-ignore format: long
  expect(notes).toEqual([
    'Nothing is made of map_Kd ("wood.tga" is no image of a kind that is read), disp, refl, Ks, map_Ke -cc, map_Ke -t of the material "m".',
  ]);
  expect(one('d -halo 0.3').notes).toEqual(['Nothing is made of d -halo of the material "m".']);
  const many = Array.from({ length: 25 }, (_, k) => `newmtl m${k}\ndisp a.png`).join('\n');
  expect(read(many).notes).toHaveLength(21);
  expect(read(many).notes.at(-1)).toBe('The same is true of 5 more materials.');
});

test('a material without a name is that of faces that name none', () => {
  expect(read('newmtl\nKd 1 0 0\nnewmtl b').materials).toMatchObject({ '': { baseColor: [1, 0, 0] } });
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
  ['a word as number', 'newmtl m\nNs high', 'At line 2 "it.mtl" has "high" as "Ns"; expected a number.'],
  ['two numbers of a colour', 'newmtl m\nKd 1 1', 'At line 2 "it.mtl" has "" as "Kd"'],
  ['no number', 'newmtl m\nd', 'At line 2 "it.mtl" has "" as "d"'],
  ['infinite light', 'newmtl m\nKe inf 0 0', '"inf" as "Ke"'],
])('%s', (_, lines, expected) => expect(problems(lines)[0]).toContain(expected));
