import { describe, expect, test } from 'vitest';
import { type Draft, type GltfFile, triangleFile } from '../../../../../tests/fixtures/gltf.ts';
import { fromInterleaved } from '../../export/float-picture.ts';
import { writePng } from '../../export/png.ts';
import { importGltf } from '../../gltf/index.ts';
import { builtInScenes } from '../../scene/built-in/index.ts';
import type { Mesh } from '../../scene/mesh.ts';
import type { Scene } from '../../scene/scene.ts';
import { boundsAt } from '../../scene/scene-bounds.ts';
import { richScene } from '../../scene-file/broken/good-scene.ts';
import { loadFiles } from '../../scene-file/load-files.ts';
import { parseScene } from '../../scene-file/parse-scene.ts';
import { unitBox, unitQuad, unitSphere } from './tessellate.ts';
import { writeGlb } from './write-glb.ts';

async function read(bytes: Uint8Array): Promise<Scene> {
  const result = await importGltf(bytes, { name: 'm' });
  if (!result.ok) throw new Error(result.problems.map(({ message }) => message).join('\n'));
  return result.scene;
}
const written = (scene: Scene) => writeGlb(scene).files['scene.glb']!;

/** Numbers to six digits: degrees go out as radians. */
const rounded = (value: unknown): unknown => {
  if (typeof value === 'number') return Number(value.toPrecision(6));
  if (ArrayBuffer.isView(value)) return Array.from(value as Float32Array, (x) => Number(x.toPrecision(6)));
  if (Array.isArray(value)) return value.map(rounded);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, part]) => [key, rounded(part)]));
};
async function expectEqualAgain(file: GltfFile): Promise<void> {
  const first = await read(file.glb());
  expect(rounded(await read(written(first)))).toEqual(rounded(first));
}
const primitive = (file: GltfFile): Draft => file.json.meshes[0].primitives[0];
const png = writePng(fromInterleaved(2, 1, ['R', 'G', 'B'], [0.5, 0, 0, 1, 1, 1]));

/** With coordinates, normals and a texture. */
const painted = (material: Draft): GltfFile =>
  triangleFile((f) => {
    Object.assign(primitive(f).attributes, {
      NORMAL: f.floats('VEC3', 0, 0, 1, 0, 0, 1, 0, 0, 1),
      TANGENT: f.floats('VEC4', 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1),
      TEXCOORD_0: f.floats('VEC2', 0, 0, 1, 0, 0, 1),
      TEXCOORD_1: f.floats('VEC2', 0, 0, 1, 0, 0, 1),
      COLOR_0: f.floats('VEC4', 1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1),
    });
    primitive(f).material = f.add('materials', { name: 'm', ...material });
    const source = f.add('images', { name: 'a', bufferView: f.view(png), mimeType: 'image/png' });
    const sampler = f.add('samplers', { wrapS: 33071, wrapT: 33648, magFilter: 9728, minFilter: 9728 });
    f.add('textures', { name: 'a', source, sampler });
  });
const map = { index: 0 };
const moved = {
  index: 0,
  texCoord: 1,
  extensions: { KHR_texture_transform: { offset: [0.5, 0], rotation: 1, scale: [2, 3] } },
};

describe('a model comes back equal', () => {
  test.each([
    ['plain', {}],
    ['all of the base', { pbrMetallicRoughness: { baseColorFactor: [0.1, 0.2, 0.3, 0.4], metallicFactor: 0.5, roughnessFactor: 0.6, baseColorTexture: map, metallicRoughnessTexture: moved }, emissiveFactor: [0.1, 0.2, 1], emissiveTexture: map, occlusionTexture: map, normalTexture: { index: 0, scale: 0.5 }, alphaMode: 'MASK', alphaCutoff: 0.7, doubleSided: true }],
    ['blend', { alphaMode: 'BLEND' }],
    ['ior', { extensions: { KHR_materials_ior: { ior: 0 } } }],
    ['strength, dispersion', { emissiveFactor: [0.5, 0.5, 0.5], extensions: { KHR_materials_emissive_strength: { emissiveStrength: 7 }, KHR_materials_dispersion: { dispersion: 0.2 } } }],
    ['unlit', { extensions: { KHR_materials_unlit: {} } }],
    ['specular', { extensions: { KHR_materials_specular: { specularFactor: 0.5, specularColorFactor: [1, 2, 0.5], specularTexture: map, specularColorTexture: moved } } }],
    ['glass', { extensions: { KHR_materials_transmission: { transmissionFactor: 0.9, transmissionTexture: map }, KHR_materials_volume: { thicknessFactor: 0.5, thicknessTexture: map, attenuationDistance: 2, attenuationColor: [0.5, 1, 1] } } }],
    ['clear glass', { extensions: { KHR_materials_transmission: { transmissionFactor: 1 }, KHR_materials_volume: { thicknessFactor: 1 } } }],
    ['leaf', { extensions: { KHR_materials_diffuse_transmission: { diffuseTransmissionFactor: 0.5, diffuseTransmissionColorFactor: [0, 1, 0], diffuseTransmissionTexture: map, diffuseTransmissionColorTexture: map } } }],
    ['coat', { extensions: { KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatRoughnessFactor: 0.3, clearcoatTexture: map, clearcoatRoughnessTexture: map, clearcoatNormalTexture: { index: 0, scale: 2 } } } }],
    ['cloth', { extensions: { KHR_materials_sheen: { sheenColorFactor: [1, 0.5, 0], sheenRoughnessFactor: 0.4, sheenColorTexture: map, sheenRoughnessTexture: map } } }],
    ['brushed', { extensions: { KHR_materials_anisotropy: { anisotropyStrength: 0.6, anisotropyRotation: 1, anisotropyTexture: map } } }],
    ['soap', { extensions: { KHR_materials_iridescence: { iridescenceFactor: 1, iridescenceIor: 1.5, iridescenceThicknessMinimum: 150, iridescenceThicknessMaximum: 600, iridescenceTexture: map, iridescenceThicknessTexture: map } } }],
  ])('material: %s', async (_, material) => {
    await expectEqualAgain(painted(material));
  }); // biome-ignore format: a table

  test('hierarchy, skins, morph targets, variants, clips', async () => {
    await expectEqualAgain(
      triangleFile((f) => {
        const { json } = f;
        primitive(f).attributes.JOINTS_0 = f.accessor(Uint16Array.of(0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0), 'VEC4');
        primitive(f).attributes.WEIGHTS_0 = f.floats('VEC4', 0.5, 0.5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0);
        primitive(f).targets = [{ POSITION: f.floats('VEC3', 0, 0, 1, 0, 0, 1, 0, 0, 1) }];
        json.meshes[0].primitives.push({ ...primitive(f), material: f.add('materials', { name: 'other' }) });
        const joints = [f.add('nodes', { name: 'hip', children: [2], rotation: [0, 0, 0.6, 0.8] }), f.add('nodes', { name: 'knee', translation: [0, 1, 0], scale: [1, 2, 1] })];
        json.scenes[0].nodes.push(joints[0]);
        const inverseBindMatrices = f.floats('MAT4', ...[0, 1].flatMap((k) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -k, 0, 1]));
        Object.assign(json.nodes[0], { weights: [0.25], skin: f.add('skins', { name: 'bones', joints, inverseBindMatrices }) });
        json.extensions = { KHR_materials_variants: { variants: [{ name: 'day' }, { name: 'night' }] } };
        primitive(f).extensions = { KHR_materials_variants: { mappings: [{ material: f.add('materials', { name: 'dark' }), variants: [1] }] } };
        const input = f.floats('SCALAR', 0, 1);
        const sampler = (type: string, values: number[], interpolation = 'LINEAR') => ({ input, output: f.floats(type, ...values), interpolation });
        f.add('animations', {
          name: 'walk',
          samplers: [sampler('VEC3', [0, 0, 0, 1, 1, 1]), sampler('SCALAR', [0, 1]), sampler('VEC4', [...new Array(24)].map((_, i) => Number(i % 4 === 3)), 'CUBICSPLINE'), sampler('SCALAR', [0, 1], 'STEP')],
          channels: [
            { sampler: 0, target: { node: 2, path: 'translation' } },
            { sampler: 1, target: { node: 0, path: 'weights' } },
            { sampler: 2, target: { node: 1, path: 'rotation' } },
            { sampler: 3, target: { path: 'pointer', extensions: { KHR_animation_pointer: { pointer: '/materials/0/pbrMetallicRoughness/metallicFactor' } } } },
          ],
        });
      }),
    );
  }); // biome-ignore format: a file

  test('lights and cameras', async () => {
    await expectEqualAgain(
      triangleFile((f) => {
        f.json.extensions = { KHR_lights_punctual: { lights: [{ type: 'point', name: 'bulb', color: [1, 0.5, 0], intensity: 3 }, { type: 'spot', name: 'torch', intensity: 9, spot: { innerConeAngle: 0.1, outerConeAngle: 0.5 } }, { type: 'directional', name: 'sun', intensity: 2 }] } };
        for (const light of [0, 1, 2]) f.json.scenes[0].nodes.push(f.add('nodes', { name: `n${light}`, translation: [light, 1, 2], extensions: { KHR_lights_punctual: { light } } }));
        f.add('cameras', { name: 'wide', type: 'perspective', perspective: { yfov: 1, znear: 0.1 } });
        f.add('cameras', { name: 'plan', type: 'orthographic', orthographic: { xmag: 3, ymag: 2, znear: 0, zfar: 9 } });
        for (const camera of [0, 1]) f.json.scenes[0].nodes.push(f.add('nodes', { name: `c${camera}`, translation: [0, 0, 5], camera }));
      }),
    );
  }); // biome-ignore format: a file
});

test('instances and placements become nodes, at the same places', async () => {
  const scene = await read(triangleFile((f) => {
    f.json.nodes[0].extensions = { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION: f.floats('VEC3', 0, 0, 0, 5, 0, 0, 0, 7, 0) } } };
  }).glb()); // biome-ignore format: a file
  const again = await read(written(scene));
  expect(Object.keys(again.shapes)).toHaveLength(3);
  expect(boundsAt(again, 0)).toEqual(boundsAt(scene, 0));
});

describe('scenes of formulas', () => {
  test.each(builtInScenes.map(({ id, scene }) => [id, scene] as const))(
    '%s: everything is there or told',
    async (_, scene) => {
      const { files, report } = writeGlb(scene);
      const again = await read(files['scene.glb']!);
      const lamps = Object.keys(scene.lights).length;
      expect(Object.keys(again.shapes)).toHaveLength(Object.keys(scene.shapes).length + lamps);
      const told = report.flatMap(({ things }) => things);
      for (const [name, shape] of Object.entries(scene.shapes))
        if (shape.type !== 'mesh') expect(told).toContain(`shape "${name}"`);
      for (const name of Object.keys(scene.lights)) expect(told).toContain(`light "${name}"`);
      expect(Object.keys(again.cameras!)).toEqual(['camera']);
    },
  );

  test('everything that a scene may have', async () => {
    const rich = richScene();
    for (const section of ['models', 'meshes', 'images']) delete rich[section];
    Object.assign(rich, {
      clip: undefined,
      meshes: {},
      shapes: { ...rich.shapes, stone: rich.shapes.ball, slab: rich.shapes.ball, parts: rich.shapes.ball },
    });
    for (const key of Object.keys(rich.materials.coated)) if (/exture/.test(key)) delete rich.materials.coated[key];
    delete rich.materials.coated.clearcoat.weightTexture;
    delete rich.materials.coated.anisotropy;
    delete rich.textures;
    const parsed = parseScene(rich);
    if (!parsed.ok) throw new Error(parsed.problems[0]!.message);
    const loaded = await loadFiles(parsed.scene, () => Promise.reject(new Error('none')));
    if (!loaded.ok) throw new Error('');
    const { files, report } = writeGlb(loaded.scene);
    const again = await read(files['scene.glb']!);
    expect(Object.keys(again.nodes!)).toEqual(expect.arrayContaining(['stand', 'arm', 'fixed', 'ball', 'close']));
    expect(Object.keys(again.variants!)).toEqual(['night']);
    expect(again.lights.spot).toMatchObject({ type: 'spot', intensity: 9 });
    expect(report.map(({ message }) => message)).toContain(
      'Tracks of keyframes ("animation") stand still as they are at rest.',
    );
  });
});

test('a lamp is black whatever materials are called', async () => {
  const parsed = parseScene({ version: 1, name: 'x', camera: { eye: [0, 0, 5], target: [0, 0, 0] }, materials: { lamp: { baseColor: [1, 0, 0] } }, lights: { lamp: { type: 'sphere', center: [0, 0, 0], radius: 2, radiance: 8, diffuse: [1, 0.5, 0] } } }); // biome-ignore format: one scene
  if (!parsed.ok) throw new Error(parsed.problems[0]!.message);
  const again = await read(written(parsed.scene));
  const lamp = again.materials[again.shapes.lamp!.material]!;
  expect(lamp).toMatchObject({ baseColor: [0, 0, 0], specularLobe: { weight: 0 } });
  expect(lamp.emission.map((x) => x * lamp.emissionStrength!)).toEqual([8, 4, 0]);
  expect(boundsAt(again, 0)!.max[1]).toBeCloseTo(2, 5);
});

/** By the divergence theorem; of what is seen from outside it is positive. */
function volume({ positions, indices }: Mesh): number {
  let sum = 0;
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => positions.subarray(3 * indices[t + k]!, 3 * indices[t + k]! + 3)) as [Float32Array, Float32Array, Float32Array]; // biome-ignore format: three corners
    sum += a[0]! * (b[1]! * c[2]! - b[2]! * c[1]!) + a[1]! * (b[2]! * c[0]! - b[0]! * c[2]!) + a[2]! * (b[0]! * c[1]! - b[1]! * c[0]!); // biome-ignore format: a determinant
  }
  return sum / 6;
}

test('forms are closed and seen from outside', () => {
  expect(volume(unitBox())).toBeCloseTo(1, 6);
  expect(volume(unitSphere()) / ((4 / 3) * Math.PI)).toBeGreaterThan(0.99);
  expect(volume(unitSphere()) / ((4 / 3) * Math.PI)).toBeLessThan(1);
  // Its error falls with the square of the rows.
  const miss = (rows: number) => 1 - volume(unitSphere(rows)) / ((4 / 3) * Math.PI);
  expect(miss(32) / miss(64)).toBeCloseTo(4, 1);
  expect(unitQuad().indices).toHaveLength(6);
});
