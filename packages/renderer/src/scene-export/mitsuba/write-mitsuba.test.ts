import { decode } from 'fast-png';
import { describe, expect, test } from 'vitest';
import { cubeMesh } from '../../../../../tests/fixtures/meshes/solids.ts';
import { seededRandom } from '../../../../../tests/fixtures/random.ts';
import { referenceNames, referenceScene } from '../../../../../tests/reference/references.ts';
import { readMeshFile } from '../../mesh-file/mesh-file.ts';
import { builtInScenes } from '../../scene/built-in/index.ts';
import type { EnvironmentMap } from '../../scene/environment.ts';
import type { Mesh } from '../../scene/mesh.ts';
import type { Scene } from '../../scene/scene.ts';
import { requireScene } from '../../scene-file/require-scene.ts';
import type { ExportedScene } from '../export-report.ts';
import { onMitsubasGrid } from './environment.ts';
import { writeMitsuba } from './write-mitsuba.ts';
import { plugin, string, textOf } from './xml.ts';

const textIn = (scene: Scene, options = {}) =>
  new TextDecoder().decode(writeMitsuba(scene, options).files['scene.xml']);
const scene = (more: object = {}): Scene =>
  requireScene({
    version: 1,
    name: 'Test -- scene',
    camera: { eye: [0, 1, 5], target: [0, 1, 0], verticalFov: 40 },
    materials: { m: {} },
    shapes: { ball: { type: 'sphere', center: [0, 1, 0], radius: 1, material: 'm' } },
    render: { integrator: 'path', maxDepth: 7 },
    ...more,
  });
const material = (m: object) => scene({ materials: { m } });
/** Opening and closing tags match, and nothing stands between them. */
function expectWellFormed(xml: string): void {
  const open: string[] = [];
  for (const [, close, tag, self] of xml.matchAll(/<(\/?)([a-z]+)(?: [a-z_]+="[^"<&]*(?:&[a-z]+;[^"<&]*)*")*(\/?)>/g)) {
    if (close) expect(open.pop()).toBe(tag);
    else if (!self) open.push(tag!);
  }
  expect(open).toEqual([]);
  expect(
    xml
      .replace(/<!--.*?-->/s, '')
      .replace(/<[^>]*>/g, '')
      .trim(),
  ).toBe('');
}

test.each(
  [...builtInScenes.map(({ scene: one }) => one), ...referenceNames.map(referenceScene)].map(
    (one) => [one.name, one] as const,
  ),
)('%s is well-formed, and every file that it names is there', (_, one) => {
  const { files } = writeMitsuba(one);
  const xml = new TextDecoder().decode(files['scene.xml']);
  expectWellFormed(xml);
  for (const [, name] of xml.matchAll(/name="filename" value="([^"]*)"/g)) expect(Object.keys(files)).toContain(name);
  const ids = [...xml.matchAll(/<bsdf [^>]*id="([^"]*)"/g)].map(([, id]) => id);
  for (const [, id] of xml.matchAll(/<ref id="([^"]*)"/g))
    expect([...ids, ...[...xml.matchAll(/shapegroup" id="([^"]*)"/g)].map(([, g]) => g)]).toContain(id);
  const python = new TextDecoder().decode(files['scene.py']);
  for (const [, kind, type] of xml.matchAll(/<(\w+) type="(mirrorball_\w+)"/g))
    expect(python).toContain(`mi.register_${kind}('${type}'`);
});

test('camera, film, depth', () => {
  const xml = textIn(scene(), { width: 64, height: 32, samples: 9 });
  for (const part of [
    '<integrator type="path">\n    <integer name="max_depth" value="7"/>',
    '<float name="fov" value="40"/>',
    'name="fov_axis" value="y"',
    'origin="0, 1, 5" target="0, 1, 0" up="0, 1, 0"',
    'name="width" value="64"',
    'name="sample_count" value="9"',
    '<rfilter type="box"/>',
  ])
    expect(xml).toContain(part);
  const lens = { eye: [0, 1, 5], target: [0, 1, 0], aperture: 0.1 };
  expect(textIn(scene({ camera: lens }))).toMatch(
    /type="thinlens"[\s\S]*"aperture_radius" value="0.1"[\s\S]*"focus_distance" value="5"/,
  );
  const flat = { eye: [0, 1, 5], target: [0, 1, 0], projection: 'orthographic', viewHeight: 4 };
  expect(textIn(scene({ camera: flat }), { width: 30, height: 10 })).toContain('<scale x="6" y="6"/>');
  const round = { eye: [0, 1, 5], target: [0, 1, 0], projection: 'equirectangular' };
  expect(() => textIn(scene({ camera: round }))).toThrow('equirectangular');
});

describe('materials', () => {
  test.each([
    ['diffuse', {}, /twosided[\s\S]*<bsdf type="diffuse">[\s\S]*0.8, 0.8, 0.8/, false],
    [
      'a mirror',
      { type: 'conductor' },
      /<bsdf type="conductor">[\s\S]*"material" value="none"[\s\S]*"specular_reflectance"/,
      false,
    ],
    ['gold', { type: 'conductor', conductor: 'gold' }, /<bsdf type="conductor">\s*<rgb name="eta"/, false],
    [
      'rough gold',
      { type: 'conductor', conductor: 'gold', roughness: 0.5 },
      /mirrorball_opaque[\s\S]*"kind" value="conductor"[\s\S]*"alpha" value="0.25"/,
      true,
    ],
    ['plastic', { type: 'metallicRoughness', metallic: 0.5 }, /"kind" value="gltf"[\s\S]*"metallic" value="0.5"/, true],
    ['half a mirror', { reflectivity: 0.5 }, /"kind" value="diffuse"[\s\S]*"reflectivity" value="0.5"/, true],
    ['glass', { type: 'dielectric', ior: 1.8 }, /<bsdf type="dielectric"[\s\S]*"int_ior" value="1.8"/, false],
    ['a pane', { type: 'dielectric', thin: true }, /<bsdf type="thindielectric"/, false],
    ['frosted glass', { type: 'dielectric', roughness: 0.4 }, /mirrorball_glass[\s\S]*"alpha" value="0.16"/, true],
  ])('%s', (_, m, form, python) => {
    const { files, report } = writeMitsuba(material(m));
    expect(new TextDecoder().decode(files['scene.xml'])).toMatch(form);
    expect(report.some(({ message }) => message.includes('scene.py adds it'))).toBe(python);
  });
  test('glass that absorbs has a medium, and an integrator that knows media', () => {
    for (const distance of [2, 0.1]) {
      const xml = textIn(material({ type: 'dielectric', attenuationColor: [0.5, 1, 0.25], attenuationDistance: distance })); // biome-ignore format: one line
      // Without roulette, which is biased there.
      expect(xml).toMatch(/<integrator type="volpathmis">\s*<integer name="max_depth" value="7"\/>\s*<integer name="rr_depth" value="7"\/>/); // biome-ignore format: one form
      const sigma = /"sigma_t" value="([^"]*)"/.exec(xml)![1]!.split(', ').map(Number);
      const scale = Number(/"scale" value="([^"]*)"/.exec(xml)![1]);
      // More it does not take.
      expect(Math.max(...sigma)).toBeLessThanOrEqual(1);
      sigma.forEach((s, c) => {
        expect(Math.exp(-distance * s * scale)).toBeCloseTo([0.5, 1, 0.25][c]!, 9);
      });
    }
  });
  test('what is lost is named', () => {
    const { report } = writeMitsuba(
      material({ type: 'metallicRoughness', clearcoat: {}, sheen: {}, energyCompensation: true }),
    );
    const told = report.filter(({ kind }) => kind === 'lost').map(({ message, things }) => `${message} ${things}`);
    expect(told).toEqual(
      expect.arrayContaining([
        'Mitsuba\'s file has no clearcoat. material "m"',
        'Mitsuba\'s file has no sheen. material "m"',
        expect.stringContaining('energyCompensation'),
      ]),
    );
  });
});

test('lights and the sky', () => {
  const lights = {
    ball: { type: 'sphere', center: [0, 3, 0], radius: 0.5, radiance: 4, diffuse: [1, 0.5, 0] },
    panel: { type: 'quad', corner: [0, 3, 0], u: [2, 0, 0], v: [0, 0, 2], radiance: 3 },
    bulb: { type: 'point', position: [1, 2, 3], intensity: 5 },
    torch: { type: 'spot', position: [1, 2, 3], direction: [0, -1, 0], intensity: 5, outerAngle: 30 },
    sun: { type: 'directional', direction: [0, -1, 0], irradiance: 2 },
  };
  const xml = textIn(scene({ lights, sky: [0.1, 0.2, 0.3] }));
  for (const part of [
    'value="4, 2, 0"',
    'value="3, 3, 3"',
    '<point name="position" value="1, 2, 3"/>',
    '"cutoff_angle" value="30"',
    '"irradiance" value="2, 2, 2"',
    '<emitter type="constant">\n    <rgb name="radiance" value="0.1, 0.2, 0.3"/>',
  ])
    expect(xml).toContain(part);
  expectWellFormed(xml);
});

test('meshes are PLY files; many places are instances of one', () => {
  const mesh = { type: 'mesh', mesh: 'cube', material: 'm' };
  const meshes = { cube: { data: cubeMesh() } };
  const two = { a: mesh, b: { ...mesh, translation: [3, 0, 0] } };
  const { files } = writeMitsuba(scene({ meshes, shapes: two }));
  expect(Object.keys(files).filter((name) => name.endsWith('.ply'))).toHaveLength(1);
  expect(new TextDecoder().decode(files['scene.xml']).match(/<shape type="ply">/g)).toHaveLength(2);
  const places = { a: { ...mesh, instances: [{ translation: [1, 0, 0] }, { translation: [2, 0, 0] }, {}] } };
  const xml = textIn(scene({ meshes, shapes: places }));
  expect(xml.match(/<shape type="instance">/g)).toHaveLength(3);
  expect(xml.match(/<shape type="ply">/g)).toHaveLength(1);
});

describe('what a mesh gives its material', () => {
  const { positions, indices } = cubeMesh();
  const count = positions.length / 3;
  const each = (...numbers: number[]) => Float32Array.from({ length: count * numbers.length }, (_, i) => numbers[i % numbers.length]!); // biome-ignore format: one expression
  const data: Mesh = { positions, indices, normals: each(0, 1, 0), tangents: each(1, 0, 0, -1), uvs: [each(0.25, 0.5), each(0.5, 0.75)], colors: each(0.5, 1, 1, 0.25) }; // biome-ignore format: one mesh
  const rgba = Uint8Array.from([10, 20, 30, 40, 50, 60, 70, 80]);
  const of = (m: object, shape: object = {}, mesh: Mesh = data) =>
    writeMitsuba(
      scene({
        images: { 'a/b.png': { data: { width: 2, height: 1, rgba } } },
        textures: { t: { image: 'a/b.png', wrapU: 'mirror', wrapV: 'mirror', filter: 'nearest' } },
        materials: { m: { type: 'metallicRoughness', ...m } },
        meshes: { cube: { data: mesh } },
        shapes: { cube: { type: 'mesh', mesh: 'cube', material: 'm', ...shape } },
      }),
    );
  const xmlOf = (files: ExportedScene['files']) => new TextDecoder().decode(files['scene.xml']);
  const plain: Mesh = { positions, indices, uvs: data.uvs! };

  test('a texture is a picture beside it, with its wrap, filter, transform and meaning', () => {
    const use = { texture: 't', offset: [0.5, 0.25], rotation: 90, scale: [2, 3] };
    const { files } = of({ baseColor: [1, 1, 1], baseColorTexture: use, metallicRoughnessTexture: { texture: 't' } }, {}, plain); // biome-ignore format: one call
    const xml = xmlOf(files);
    expectWellFormed(xml);
    expect(xml).toMatch(
      /<texture type="bitmap" name="base_color">\s*<string name="filename" value="scene.0-a-b-png.png"\/>\s*<boolean name="raw" value="false"\/>[\s\S]*?"mirror"[\s\S]*?"nearest"[\s\S]*?<matrix value="\S+ 3 0 0.5 -2 \S+ 0 0.25 0 0 1 0 0 0 0 1"/,
    );
    expect(xml).toMatch(/name="metallic_roughness">\s*<string name="filename" value="scene.0-a-b-png.png"\/>\s*<boolean name="raw" value="true"/); // biome-ignore format: one form
    expect([...decode(files['scene.0-a-b-png.png']!).data]).toEqual([10, 20, 30, 50, 60, 70]);
  });

  test('colours of vertices are an attribute, alone or times a colour', () => {
    const { files } = of({ type: 'diffuse', baseColor: [1, 1, 1] });
    expect(xmlOf(files)).toMatch(/<bsdf type="diffuse">\s*<texture type="mesh_attribute" name="reflectance">\s*<string name="name" value="vertex_color"/); // biome-ignore format: one form
    expect(new TextDecoder().decode(files['scene.0-cube.ply'])).toContain('property float red');
    expect(xmlOf(of({ baseColor: [0.5, 1, 1] }).files)).toMatch(
      /mirrorball_product[\s\S]*"factor" value="0.5, 1, 1"[\s\S]*vertex_color/,
    );
  });

  test('what is cut out is masked, and light goes through it', () => {
    const veil = of({ alphaMode: 'blend', baseColorTexture: { texture: 't' } }, {}, plain);
    expect(xmlOf(veil.files)).toMatch(/type="volpath"[\s\S]*<bsdf type="mask" id="material 0">\s*<texture type="bitmap" name="opacity">/); // biome-ignore format: one form
    expect([...decode(veil.files['scene.1-a-b-png-opacity.png']!).data]).toEqual([40, 80]);
    const holes = xmlOf(of({ alphaMode: 'mask', alphaCutoff: 0.3 }).files);
    expect(holes).toMatch(/mirrorball_presence[\s\S]*"cutoff" value="0.3"[\s\S]*vertex_opacity/);
    expect(xmlOf(of({ doubleSided: false }).files)).toMatch(/mirrorball_presence[\s\S]*"one_sided" value="true"/);
    expect(xmlOf(of({}).files)).toContain('<integrator type="path">');
  });

  test('a normal map has its frame; that of many places is lost, and told', () => {
    const m = { normalTexture: { texture: 't', normalScale: 0.5, uvSet: 1 } };
    const { files, report } = of(m, { scale: [1, 2, 1] });
    expect(xmlOf(files)).toMatch(/mirrorball_second_set" name="normal_map"[\s\S]*vertex_uv1[\s\S]*"normal_scale" value="0.5"/); // biome-ignore format: one form
    const rows = /"normals_into_world" value="([^"]*)"/.exec(xmlOf(files))![1]!.split(', ').map(Number);
    expect(rows[4]! / rows[0]!).toBeCloseTo(0.5, 9);
    const ply = new TextDecoder().decode(files['scene.0-cube.ply']);
    for (const column of ['own_normal_z', 'own_tangent_x', 'own_hand_x', 'uv1_y']) expect(ply).toContain(column);
    expect(report.some(({ message }) => message.startsWith('Normal maps'))).toBe(false);
    const places = of(m, { instances: [{ translation: [1, 0, 0] }, {}] });
    expect(places.report.map(({ message }) => message).join()).toContain('Normal maps of meshes at several places');
    expect(xmlOf(places.files)).not.toContain('normal_map');
  });

  test('light is that of a texture, or of what needs none', () => {
    expect(xmlOf(of({ emission: [2, 1, 1], emissionTexture: { texture: 't' } }).files)).toMatch(
      /<emitter type="area">\s*<texture type="mirrorball_product" name="radiance">/,
    );
    const poster = of({ unlit: true, baseColor: [1, 1, 1], baseColorTexture: { texture: 't' } });
    expect(xmlOf(poster.files)).toMatch(
      /<emitter type="area">\s*<texture type="mirrorball_product" name="radiance">[\s\S]*"sampled_by_area" value="true"/,
    );
    expect(poster.report.map(({ message }) => message).join()).toContain('Light does not vary by colours of vertices');
  });
});

test('a mirrored mesh has its corners the other way round, so that its outside stays out', () => {
  const mesh = { type: 'mesh', mesh: 'cube', material: 'm' };
  const mirrored = { ...mesh, scale: [-1, 2, 1], translation: [3, 0, 0] };
  const { files } = writeMitsuba(scene({ meshes: { cube: { data: cubeMesh() } }, shapes: { a: mesh, b: mirrored } }));
  const [straight, turned] = Object.entries(files)
    .filter(([name]) => name.endsWith('.ply'))
    .map(([name, bytes]) => {
      const read = readMeshFile(bytes, name);
      return read.ok ? [...read.parts[0]!.mesh.indices] : [];
    });
  expect(turned).toHaveLength(36);
  for (let i = 0; i < 36; i += 3)
    expect(turned!.slice(i, i + 3)).toEqual([straight![i], straight![i + 2], straight![i + 1]]);
});

test("the sky on Mitsuba's grid is the same function (seed 96)", () => {
  const random = seededRandom(96);
  const [width, height] = [5, 4];
  const map: EnvironmentMap = {
    width,
    height,
    data: Float32Array.from({ length: width * height * 3 }, () => random()),
  };
  const theirs = onMitsubasGrid(map);
  const ours = (u: number, v: number) =>
    bilinear(map, u * width - 0.5, Math.min(Math.max(v * height - 0.5, 0), height - 1));
  for (let k = 0; k < 200; k++) {
    const [u, v] = [random(), random()];
    const other = bilinear(theirs, u * theirs.width - 0.5, v * (theirs.height - 1));
    other.forEach((x, c) => {
      expect(x).toBeCloseTo(ours(u, v)[c]!, 5);
    });
  }
});
function bilinear({ width, height, data }: EnvironmentMap, x: number, y: number): number[] {
  const [left, top] = [Math.floor(x), Math.min(Math.floor(y), height - 2)];
  const at = (i: number, j: number, c: number) => data[(j * width + ((i + width) % width)) * 3 + c]!;
  return [0, 1, 2].map((c) => {
    const line = (j: number) => at(left, j, c) * (1 - (x - left)) + at(left + 1, j, c) * (x - left);
    return line(top) * (1 - (y - top)) + line(top + 1) * (y - top);
  });
}

test('what a clip moves by nodes stands still where it is at the time', () => {
  const moving = scene({
    nodes: { arm: {} },
    shapes: { ball: { type: 'sphere', center: [0, 1, 0], radius: 1, material: 'm', node: 'arm' } },
    clips: { wave: { tracks: [{ target: '/nodes/arm/translation', times: [0, 1], values: [0, 0, 0, 8, 0, 0] }] } },
    clip: 'wave',
  });
  const { files, report } = writeMitsuba(moving, { time: 0.5 });
  expect(new TextDecoder().decode(files['scene.xml'])).toMatch(/name="center" value="4[, ]+1[, ]+0"/);
  expect(report.map(({ message }) => message)).toContain('What moves stands still as it is at 0.5 s.');
});

test('names are escaped', () => {
  expect(textOf(plugin('bsdf', 'a', [string('n', '<&">')]))).toContain('value="&lt;&amp;&quot;&gt;"');
});
