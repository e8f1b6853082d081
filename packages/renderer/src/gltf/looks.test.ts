/** Materials, textures, lights, cameras and variants. */
import { describe, expect, test } from 'vitest';
import { type Draft, type GltfFile, triangleFile } from '../../../../tests/fixtures/gltf.ts';
import { fromInterleaved } from '../export/float-picture.ts';
import { writePng } from '../export/png.ts';
import { refuseUndrawn } from '../packed-scene/refuse-undrawn.ts';
import type { Material, Scene } from '../scene/scene.ts';
import { withVariant } from '../scene/variants.ts';
import { pngDecoder } from './images/decoder.ts';
import { importGltf } from './index.ts';
import type { ImportReport } from './report.ts';
import type { GltfOptions } from './types.ts';

async function imported(file: GltfFile, options: GltfOptions = {}): Promise<{ scene: Scene; report: ImportReport }> {
  const result = await importGltf(file.glb(), { decoder: pngDecoder, ...options });
  if (!result.ok) throw new Error(result.problems.map(({ message }) => message).join('\n'));
  return result;
}
const said = ({ entries }: ImportReport) =>
  entries.map(({ kind, what, places }) => `${kind} ${what} ${places.join(' ')}`);
const primitive = (file: GltfFile): Draft => file.json.meshes[0].primitives[0];

/** A triangle of this material, with coordinates and normals, and a texture of 2 × 1 pixels for every name. */
const painted = (material: Draft, change: (file: GltfFile) => void = () => {}): GltfFile =>
  triangleFile((f) => {
    Object.assign(primitive(f).attributes, {
      NORMAL: f.floats('VEC3', 0, 0, 1, 0, 0, 1, 0, 0, 1),
      TEXCOORD_0: f.floats('VEC2', 0, 0, 1, 0, 0, 1),
      TEXCOORD_1: f.floats('VEC2', 0, 0, 1, 0, 0, 1),
    });
    primitive(f).material = f.add('materials', { name: 'm', ...material });
    for (const name of ['a', 'b']) {
      const source = f.add('images', { name, bufferView: f.view(png(name === 'a' ? 0 : 1)), mimeType: 'image/png' });
      f.add('textures', { source });
    }
    change(f);
  });
const png = (value: number): Uint8Array => writePng(fromInterleaved(2, 1, ['R', 'G', 'B'], [value, 0, 0, 1, 1, 1]));
const materialOf = async (material: Draft, change?: (file: GltfFile) => void): Promise<Material> =>
  (await imported(painted(material, change))).scene.materials.m!;

describe('materials', () => {
  test('say what they are in glTF’s own defaults', async () => {
    expect(await materialOf({})).toMatchObject({ type: 'metallicRoughness', baseColor: [1, 1, 1], metallic: 1, roughness: 1, ior: 1.5, emission: [0, 0, 0], doubleSided: false }); // biome-ignore format: one line
    const plain = await materialOf({
      pbrMetallicRoughness: { baseColorFactor: [0.1, 0.2, 0.3, 0.4], metallicFactor: 0.5, roughnessFactor: 0.6 },
      emissiveFactor: [1, 2, 3],
      alphaMode: 'MASK',
      alphaCutoff: 0.7,
      doubleSided: true,
    });
    expect(plain).toMatchObject({
      baseColor: [0.1, 0.2, 0.3],
      opacity: 0.4,
      metallic: 0.5,
      roughness: 0.6,
      emission: [1, 2, 3],
      alphaMode: 'mask',
      alphaCutoff: 0.7,
      doubleSided: true,
    });
    expect(await materialOf({ alphaMode: 'BLEND' })).toMatchObject({ alphaMode: 'blend' });
  });

  test('extensions become groups', async () => {
    const extensions = {
      KHR_materials_emissive_strength: { emissiveStrength: 5 },
      KHR_materials_ior: { ior: 1.33 },
      KHR_materials_specular: { specularFactor: 0.5, specularColorFactor: [1, 0.5, 2], specularTexture: { index: 0 } },
      KHR_materials_transmission: { transmissionFactor: 0.9, transmissionTexture: { index: 1 } },
      KHR_materials_volume: { thicknessFactor: 2, attenuationDistance: 0.5, attenuationColor: [0.1, 0.2, 0.3] },
      KHR_materials_clearcoat: {
        clearcoatFactor: 1,
        clearcoatRoughnessFactor: 0.2,
        clearcoatNormalTexture: { index: 0, scale: 0.3 },
      },
      KHR_materials_sheen: {
        sheenColorFactor: [0.4, 0.5, 0.6],
        sheenRoughnessFactor: 0.7,
        sheenColorTexture: { index: 1 },
      },
      KHR_materials_anisotropy: { anisotropyStrength: 0.6, anisotropyRotation: Math.PI / 2 },
      KHR_materials_iridescence: { iridescenceFactor: 1 },
      KHR_materials_dispersion: { dispersion: 0.36 },
      KHR_materials_diffuse_transmission: {
        diffuseTransmissionFactor: 0.25,
        diffuseTransmissionColorFactor: [0, 1, 0],
      },
      KHR_materials_unlit: {},
    };
    const material = await materialOf({ extensions }, (f) => {
      f.json.extensionsUsed = Object.keys(extensions);
    });
    expect(material).toMatchObject({
      emissionStrength: 5,
      ior: 1.33,
      specularLobe: { weight: 0.5, color: [1, 0.5, 2], weightTexture: { texture: 'a' } },
      transmission: { weight: 0.9, weightTexture: { texture: 'b' } },
      volume: { thickness: 2 },
      attenuationDistance: 0.5,
      attenuationColor: [0.1, 0.2, 0.3],
      clearcoat: { weight: 1, roughness: 0.2, normalTexture: { texture: 'a', normalScale: 0.3 } },
      sheen: { color: [0.4, 0.5, 0.6], roughness: 0.7, colorTexture: { texture: 'b' } },
      anisotropy: { strength: 0.6, rotation: 90 },
      iridescence: { weight: 1, ior: 1.3, thicknessMinimum: 100, thicknessMaximum: 400 },
      dispersion: 0.36,
      diffuseTransmission: { weight: 0.25, color: [0, 1, 0] },
      unlit: true,
    });
  });

  // Names and places by the extensions' own texts.
  test.each([
    ['specular', 'specularTexture', 'specularLobe', 'weightTexture'],
    ['specular', 'specularColorTexture', 'specularLobe', 'colorTexture'],
    ['transmission', 'transmissionTexture', 'transmission', 'weightTexture'],
    ['volume', 'thicknessTexture', 'volume', 'thicknessTexture'],
    ['diffuse_transmission', 'diffuseTransmissionTexture', 'diffuseTransmission', 'weightTexture'],
    ['diffuse_transmission', 'diffuseTransmissionColorTexture', 'diffuseTransmission', 'colorTexture'],
    ['clearcoat', 'clearcoatTexture', 'clearcoat', 'weightTexture'],
    ['clearcoat', 'clearcoatRoughnessTexture', 'clearcoat', 'roughnessTexture'],
    ['clearcoat', 'clearcoatNormalTexture', 'clearcoat', 'normalTexture'],
    ['sheen', 'sheenColorTexture', 'sheen', 'colorTexture'],
    ['sheen', 'sheenRoughnessTexture', 'sheen', 'roughnessTexture'],
    ['anisotropy', 'anisotropyTexture', 'anisotropy', 'texture'],
    ['iridescence', 'iridescenceTexture', 'iridescence', 'weightTexture'],
    ['iridescence', 'iridescenceThicknessTexture', 'iridescence', 'thicknessTexture'],
  ] as const)(
    'KHR_materials_%s: %s, in the set and place that it says, is a texture of its own',
    async (name, field, group, as) => {
      const extension = `KHR_materials_${name}`;
      const transform = { KHR_texture_transform: { offset: [0.1, 0.2], rotation: Math.PI / 2, scale: [3, 4] } };
      const extensions = { [extension]: { [field]: { index: 1, texCoord: 1, extensions: transform } } };
      const material = await materialOf({ extensions }, (f) => {
        f.json.extensionsUsed = [extension, 'KHR_texture_transform'];
      });
      const { [as]: use, ...others } = material[group] as unknown as Record<string, unknown>;
      expect(use).toEqual({ texture: 'b', uvSet: 1, offset: [0.1, 0.2], rotation: 90, scale: [3, 4] });
      expect(Object.keys(others).filter((key) => /texture$/i.test(key))).toEqual([]);
    },
  );

  test('a coat whose map goes by other coordinates than the base’s is told', async () => {
    const told = async (texCoord: number) => {
      const file = painted({ normalTexture: { index: 0 }, extensions: { KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatNormalTexture: { index: 1, texCoord } } } }); // biome-ignore format: one line
      return (await imported(file)).report.entries
        .map(({ what }) => what)
        .filter((what) => what === 'clearcoatNormalTexture');
    };
    expect(await told(0)).toEqual([]);
    expect(await told(1)).toEqual(['clearcoatNormalTexture']);
  });

  test('empty extensions have the defaults of their texts; a volume without distance is clear', async () => {
    const material = await materialOf({
      extensions: { KHR_materials_specular: {}, KHR_materials_volume: {}, KHR_materials_ior: { ior: 0 } },
    });
    expect(material).toMatchObject({
      specularLobe: { weight: 1, color: [1, 1, 1] },
      volume: { thickness: 0 },
      attenuationDistance: 0,
      ior: 0,
    });
  });

  test('what is beyond its range is cut and named', async () => {
    const { scene, report } = await imported(painted({ pbrMetallicRoughness: { roughnessFactor: 1.5, baseColorFactor: [2, 0, -1, 1] }, extensions: { KHR_materials_ior: { ior: 0.5 } } })); // biome-ignore format: one line
    expect(scene.materials.m).toMatchObject({ roughness: 1, baseColor: [1, 0, 0], ior: 1 });
    expect(said(report)).toEqual([
      'changed baseColorFactor /materials/0/pbrMetallicRoughness/baseColorFactor/0',
      'changed baseColorFactor /materials/0/pbrMetallicRoughness/baseColorFactor/2',
      'changed roughnessFactor /materials/0/pbrMetallicRoughness/roughnessFactor',
      'changed ior /materials/0/extensions/KHR_materials_ior/ior',
    ]);
  });

  test('an extension that nobody reads is named, wherever it stands; one that is required is a problem', async () => {
    const file = painted({ extensions: { ACME_glow: { deeper: { extensions: { ACME_more: {} } } } } }, (f) => {
      f.json.extensionsUsed = ['ACME_glow', 'ACME_elsewhere'];
      f.json.nodes[0].extensions = { ACME_glow: {} };
    });
    expect(said((await imported(file)).report).sort()).toEqual([
      'unsupported ACME_elsewhere /extensionsUsed/1',
      'unsupported ACME_glow /materials/0/extensions/ACME_glow /nodes/0/extensions/ACME_glow',
    ]);
    file.json.extensionsRequired = ['ACME_glow'];
    const refused = await importGltf(file.glb());
    expect(refused.ok || refused.problems[0]).toMatchObject({ path: '/extensionsRequired/0' });
  });
});

describe('textures', () => {
  test('are one for each image and sampler; images are decoded once', async () => {
    const { scene, report } = await imported(
      painted(
        {
          pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicRoughnessTexture: { index: 2, texCoord: 1 } },
          emissiveTexture: {
            index: 0,
            extensions: {
              KHR_texture_transform: { offset: [0.5, 0], rotation: Math.PI / 4, scale: [2, 3], texCoord: 1 },
            },
          },
          occlusionTexture: { index: 1 },
        },
        (f) => {
          f.add('textures', {
            source: 0,
            sampler: f.add('samplers', { wrapS: 33071, wrapT: 33648, magFilter: 9728, minFilter: 9729 }),
          });
        },
      ),
    );
    expect(scene.textures).toEqual({
      a: { image: 'a' },
      'a 2': { image: 'a', wrapU: 'clamp', wrapV: 'mirror', filter: 'nearest', mipmaps: false },
      b: { image: 'b' },
    });
    expect(scene.materials.m).toMatchObject({
      baseColorTexture: { texture: 'a' },
      metallicRoughnessTexture: { texture: 'a 2', uvSet: 1 },
      emissionTexture: { texture: 'a', uvSet: 1, offset: [0.5, 0], scale: [2, 3] },
    });
    expect(scene.materials.m!.emissionTexture!.rotation).toBeCloseTo(45, 10);
    expect(Object.keys(scene.images!)).toEqual(['a', 'b']);
    expect([...scene.images!.b!.data!.rgba]).toEqual([255, 0, 0, 255, 255, 255, 255, 255]);
    expect(said(report)).toEqual(['unused occlusionTexture /materials/0/occlusionTexture']);
  });

  test('a third set of coordinates cannot be had; images that are not used are not decoded', async () => {
    const { scene, report } = await imported(
      painted({ pbrMetallicRoughness: { baseColorTexture: { index: 0, texCoord: 2 } } }, (f) => {
        f.json.images[1] = { uri: 'nowhere.png' };
      }),
    );
    expect(scene.materials.m!.baseColorTexture).toBeUndefined();
    expect(scene.images).toBeUndefined();
    expect(said(report)).toEqual(['unsupported TEXCOORD_2 /materials/0/pbrMetallicRoughness/baseColorTexture']);
  });

  test('WebP is taken where it can be decoded, else the image beside it, else none', async () => {
    const webp = Uint8Array.from(Buffer.from('UklGRhoAAABXRUJQVlA4TA0AAAAvAAAAEAcQERGIiP4HAA==', 'base64'));
    const file = (fallback: boolean): GltfFile =>
      painted({ emissiveTexture: { index: 2 } }, (f) => {
        const source = f.add('images', { name: 'w', bufferView: f.view(webp) });
        f.add('textures', { ...(fallback && { source: 0 }), extensions: { EXT_texture_webp: { source } } });
      });
    const all = { canDecode: () => true, decode: async () => ({ width: 1, height: 1, rgba: new Uint8Array(4) }) };
    expect(Object.keys((await imported(file(true), { decoder: all })).scene.images!)).toEqual(['w']);
    const beside = await imported(file(true));
    expect(Object.keys(beside.scene.images!)).toEqual(['a']);
    expect(said(beside.report)).toEqual(['unsupported EXT_texture_webp /textures/2']);
    const none = await imported(file(false));
    expect(none.scene.materials.m!.emissionTexture).toBeUndefined();
    expect(none.report.entries[0]!.message).toContain('left out');
  });

  test('a normal map asks for tangents; v runs down, so the frame has the left hand here', async () => {
    const { scene } = await imported(painted({ normalTexture: { index: 0, scale: 2 } }));
    const mesh = scene.meshes!.triangle!.data!;
    // u along x; v along y, whose green points against it.
    expect([...mesh.tangents!].map(Math.round)).toEqual([1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1]);
    expect(scene.materials.m!.normalTexture).toEqual({ texture: 'a', normalScale: 2 });
    const turned = await imported(
      painted({ normalTexture: { index: 0, extensions: { KHR_texture_transform: { rotation: Math.PI / 2 } } } }),
    );
    // A turn by a quarter: u' = v, so the tangent runs along y.
    expect([...turned.scene.meshes!.triangle!.data!.tangents!.slice(0, 4)].map(Math.round)).toEqual([0, 1, 0, -1]);
  });

  test('without coordinates a normal map has no effect, and without normals the triangles’ own are taken', async () => {
    const bare = await imported(
      painted({ normalTexture: { index: 0 } }, (f) => {
        primitive(f).attributes = { POSITION: primitive(f).attributes.POSITION };
      }),
    );
    expect(said(bare.report)).toEqual(['changed normalTexture /meshes/0/primitives/0']);
    const flat = await imported(
      painted({ normalTexture: { index: 0 } }, (f) => {
        delete primitive(f).attributes.NORMAL;
      }),
    );
    expect([...flat.scene.meshes!.triangle!.data!.normals!]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
  });
});

describe('variants', () => {
  test('other materials for some shapes (KHR_materials_variants)', async () => {
    const file = painted({}, (f) => {
      f.json.extensions = { KHR_materials_variants: { variants: [{ name: 'day' }, { name: 'night' }] } };
      f.add('materials', { name: 'dark' });
      f.add('materials', { name: 'nobody’s' });
      primitive(f).extensions = {
        KHR_materials_variants: {
          mappings: [
            { material: 1, variants: [1] },
            { material: 0, variants: [0] },
          ],
        },
      };
    });
    const { scene, report } = await imported(file);
    expect(scene.variants).toEqual({ day: { thing: 'm' }, night: { thing: 'dark' } });
    expect(withVariant(scene, 'night').shapes.thing).toMatchObject({ material: 'dark' });
    expect(withVariant(scene, null)).toBe(scene);
    expect(() => withVariant(scene, 'dusk')).toThrow('"dusk"');
    expect(said(report)).toEqual(['unused material /materials/2']);
  });
});

describe('lights and cameras', () => {
  test('lights stand on their nodes (KHR_lights_punctual); a range is told', async () => {
    const lights = [
      { name: 'sun', type: 'directional', intensity: 3, color: [1, 0.5, 0] },
      { type: 'point', range: 5 },
      { type: 'spot', spot: { innerConeAngle: Math.PI / 6, outerConeAngle: Math.PI / 3 } },
    ];
    const file = triangleFile((f) => {
      f.json.extensions = { KHR_lights_punctual: { lights } };
      for (const light of [0, 1, 2, 0])
        f.json.scenes[0].nodes.push(
          f.add('nodes', { name: `on ${light}`, extensions: { KHR_lights_punctual: { light } } }),
        );
    });
    const { scene, report } = await imported(file);
    expect(scene.lights).toMatchObject({
      sun: { type: 'directional', direction: [0, 0, -1], irradiance: 3, color: [1, 0.5, 0], node: 'on 0' },
      'on 1': { type: 'point', position: [0, 0, 0], intensity: 1, node: 'on 1' },
      'on 2': { type: 'spot', node: 'on 2' },
      'sun 2': { node: 'on 0 2' },
    });
    const spot = scene.lights['on 2'] as { innerAngle: number; outerAngle: number };
    expect([spot.innerAngle, spot.outerAngle].map(Math.round)).toEqual([30, 60]);
    expect(said(report)).toEqual(['changed range /extensions/KHR_lights_punctual/lights/1/range']);
    // What has light of its own is not put in a studio.
    expect(scene.sky.map).toBeUndefined();
  });

  test('too many lights are a problem that says so', async () => {
    const file = triangleFile((f) => {
      f.json.extensions = { KHR_lights_punctual: { lights: [{ type: 'point' }] } };
      for (let i = 0; i < 4100; i++)
        f.json.scenes[0].nodes.push(f.add('nodes', { extensions: { KHR_lights_punctual: { light: 0 } } }));
    });
    const result = await importGltf(file.glb());
    expect(result.ok || result.problems[0]!.message).toContain('4100 lights');
  });

  test('the first camera is the scene’s, looking at the middle of things; others can be chosen', async () => {
    const file = triangleFile((f) => {
      f.add('cameras', { name: 'near', type: 'perspective', perspective: { yfov: Math.PI / 3, znear: 0.1 } });
      f.add('cameras', { type: 'orthographic', orthographic: { xmag: 2, ymag: 1.5, znear: 0, zfar: 10 } });
      f.json.scenes[0].nodes.push(
        f.add('nodes', { camera: 0, translation: [0.5, 0.5, 8] }),
        f.add('nodes', { name: 'side', camera: 1 }),
      );
    });
    const { scene } = await imported(file);
    expect(scene.camera.verticalFov).toBeCloseTo(60, 10);
    expect(scene.camera).toMatchObject({ eye: [0, 0, 0], up: [0, 1, 0], node: 'node 1' });
    expect(scene.camera.target[2]).toBeCloseTo(-8, 10);
    expect(Object.keys(scene.cameras!)).toEqual(['near', 'side']);
    expect(scene.cameras!.side).toMatchObject({ projection: 'orthographic', viewHeight: 3 });
    const framed = await imported(file, { camera: 'frame' });
    expect(framed.scene.camera.node).toBeUndefined();
    expect(framed.scene.camera.target).toEqual([0.5, 0.5, 0]);
  });

  test('maps of directions are left out where a mesh has no coordinates for them', async () => {
    const maps = {
      normalTexture: { index: 0, texCoord: 1 },
      extensions: {
        KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatNormalTexture: { index: 0 } },
        KHR_materials_anisotropy: { anisotropyStrength: 0.5, anisotropyTexture: { index: 0 } },
      },
    };
    const file = painted(maps, (f) => {
      const { TEXCOORD_1: _, ...attributes } = primitive(f).attributes;
      f.json.meshes[0].primitives.push({ ...primitive(f), attributes });
    });
    const { scene, report } = await imported(file);
    const materials = Object.values(scene.shapes).map(({ material }) => scene.materials[material]!);
    const maybe = materials.map((m) => [m.normalTexture, m.clearcoat!.normalTexture, m.anisotropy!.texture]);
    expect(maybe.map((list) => list.map((map) => map !== undefined))).toEqual([
      [true, true, true],
      [false, false, false],
    ]);
    expect(materials.map((m) => [m.clearcoat!.weight, m.anisotropy!.strength])).toEqual([[1, 0.5], [1, 0.5]]); // biome-ignore format: short
    expect(said(report)).toContain('changed normalTexture /meshes/0/primitives/1');
    refuseUndrawn(scene);
  });

  test('a file without light is shown in a studio, unless one wants otherwise', async () => {
    expect((await imported(triangleFile())).scene.sky.map).toBeDefined();
    expect((await imported(triangleFile(), { environment: 'none' })).scene.sky.map).toBeUndefined();
    const lamp = painted({ emissiveFactor: [1, 1, 1] });
    expect((await imported(lamp)).scene.sky.map).toBeUndefined();
    expect((await imported(lamp, { environment: 'studio' })).scene.sky.map).toBeDefined();
    const dial = { emissiveFactor: [1, 1, 1], emissiveTexture: { index: 0 } };
    expect((await imported(painted(dial))).scene.sky.map).toBeDefined();
    const extensions = { KHR_materials_emissive_strength: { emissiveStrength: 5 } };
    expect((await imported(painted({ ...dial, extensions }))).scene.sky.map).toBeUndefined();
  });

  test('so is one whose lights and lamps give next to no light, and these stay', async () => {
    // Nobody has it; it has no surface; it is small.
    const unused = triangleFile((f) => f.add('materials', { emissiveFactor: [1, 1, 1] }));
    expect((await imported(unused)).scene.sky.map).toBeDefined();
    const lamp = { emissiveFactor: [1, 1, 1] };
    const shrunk = (scale: number[]) =>
      painted(lamp, (f) => {
        f.add('nodes', { mesh: f.add('meshes', { primitives: [{ ...f.json.meshes[0].primitives[0], material: undefined }] }) }); // biome-ignore format: one line
        f.json.scenes[0].nodes.push(f.json.nodes.length - 1);
        f.json.nodes[0].scale = scale;
      });
    expect((await imported(shrunk([1, 1, 1]))).scene.sky.map).toBeUndefined();
    expect((await imported(shrunk([0.01, 1, 1]))).scene.sky.map).toBeDefined();
    expect((await imported(shrunk([0, 1, 1]))).scene.sky.map).toBeDefined();
    const lit = (intensity: number) =>
      triangleFile((f) => {
        f.json.extensions = { KHR_lights_punctual: { lights: [{ type: 'point', intensity }] } };
        f.json.scenes[0].nodes.push(f.add('nodes', { extensions: { KHR_lights_punctual: { light: 0 } } }));
      });
    expect((await imported(lit(1))).scene.sky.map).toBeUndefined();
    const dark = (await imported(lit(0))).scene;
    expect(dark.sky.map).toBeDefined();
    expect(Object.keys(dark.lights)).toHaveLength(1);
    // Other programs' lights may be a thousand times too strong; the picture is darkened, and the light stays.
    expect((await imported(lit(1))).scene.render.exposure).toBe(0);
    const strong = (await imported(lit(54_000))).scene;
    expect(strong.render.exposure).toBeLessThan(-10);
    expect(Object.values(strong.lights)).toMatchObject([{ intensity: 54_000 }]);
  });
});
