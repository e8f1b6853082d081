import { describe, expect, test } from 'vitest';
import { type Draft, type GltfFile, triangleFile } from '../../../../tests/fixtures/gltf.ts';
import type { Mesh } from '../scene/mesh.ts';
import { meshShapes } from '../scene/placed.ts';
import type { Scene } from '../scene/scene.ts';
import { importGltf } from './index.ts';
import type { ImportReport } from './report.ts';

async function imported(file: GltfFile): Promise<{ scene: Scene; report: ImportReport }> {
  const result = await importGltf(file.glb());
  if (!result.ok) throw new Error(result.problems.map(({ message }) => message).join('\n'));
  return result;
}
const meshOf = (scene: Scene, name?: string): Mesh => scene.meshes![name ?? Object.keys(scene.meshes!)[0]!]!.data!;
const said = ({ entries }: ImportReport) =>
  entries.map(({ kind, what, places }) => `${kind} ${what} ${places.join(' ')}`);
const primitive = (file: GltfFile): Draft => file.json.meshes[0].primitives[0];
const close = (found: ArrayLike<number> | undefined, wanted: readonly number[], digits = 5): void => {
  expect(found).toHaveLength(wanted.length);
  wanted.forEach((value, i) => {
    expect(found![i]).toBeCloseTo(value, digits);
  });
};

describe('triangles', () => {
  test('a triangle is a shape on its node, made of glTF’s default material', async () => {
    const { scene, report } = await imported(triangleFile());
    expect(meshOf(scene)).toEqual({
      positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
      indices: Uint32Array.of(0, 1, 2),
    });
    expect(scene.shapes.thing).toMatchObject({ type: 'mesh', mesh: 'triangle', material: 'default', node: 'thing' });
    expect(scene.materials.default).toMatchObject({
      type: 'metallicRoughness',
      baseColor: [1, 1, 1],
      metallic: 1,
      roughness: 1,
      doubleSided: false,
    });
    expect(report.entries).toEqual([]);
    expect(report.counts).toMatchObject({
      triangles: 1,
      vertices: 3,
      meshes: 1,
      placements: 1,
      nodes: 1,
      materials: 1,
    });
  });

  test('without indices every three vertices are one; what is left over is told', async () => {
    const file = triangleFile((f) => {
      delete primitive(f).indices;
      primitive(f).attributes.POSITION = f.floats('VEC3', ...new Array(12).fill(0).map((_, i) => i));
    });
    const { scene, report } = await imported(file);
    expect(meshOf(scene).indices).toEqual(Uint32Array.of(0, 1, 2));
    expect(said(report)).toEqual(['changed indices /meshes/0/primitives/0']);
  });

  test.each([
    ['strip', 5, [0, 1, 2, 1, 3, 2, 2, 3, 4]],
    ['fan', 6, [1, 2, 0, 2, 3, 0, 3, 4, 0]],
  ])('a %s is a list of triangles that all face the same way', async (_, mode, list) => {
    // A zigzag of five vertices for the strip, a pentagon for the fan.
    const positions =
      mode === 5 ? [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0] : [0, 0, 0, 2, 0, 0, 3, 1, 0, 2, 3, 0, 0, 2, 0];
    const file = triangleFile((f) => {
      Object.assign(primitive(f), {
        mode,
        attributes: { POSITION: f.floats('VEC3', ...positions) },
        indices: f.accessor(Uint8Array.of(0, 1, 2, 3, 4)),
      });
    });
    const { positions: p, indices } = meshOf((await imported(file)).scene);
    expect([...indices]).toEqual(list);
    for (let i = 0; i < indices.length; i += 3) {
      const [a, b, c] = [indices[i]!, indices[i + 1]!, indices[i + 2]!];
      const area =
        (p[3 * b]! - p[3 * a]!) * (p[3 * c + 1]! - p[3 * a + 1]!) -
        (p[3 * c]! - p[3 * a]!) * (p[3 * b + 1]! - p[3 * a + 1]!);
      expect(area).toBeGreaterThan(0);
    }
  });

  test('points and lines are named, with all their places', async () => {
    const file = triangleFile((f) => {
      const { attributes } = primitive(f);
      f.add('meshes', {
        primitives: [
          { attributes, mode: 0 },
          { attributes, mode: 3 },
          { attributes, mode: 1 },
          { attributes, mode: 1 },
        ],
      });
      f.json.scenes[0].nodes.push(f.add('nodes', { mesh: 1 }));
    });
    expect(said((await imported(file)).report)).toEqual([
      'unsupported points /meshes/1/primitives/0/mode',
      'unsupported line strips /meshes/1/primitives/1/mode',
      'unsupported lines /meshes/1/primitives/2/mode /meshes/1/primitives/3/mode',
    ]);
  });

  test('what several nodes and primitives share is one mesh', async () => {
    const file = triangleFile((f) => {
      f.add('materials', { name: 'red' });
      f.json.meshes[0].primitives.push({ ...primitive(f), material: 0 });
      f.json.scenes[0].nodes.push(f.add('nodes', { name: 'thing', mesh: 0 }));
    });
    const { scene } = await imported(file);
    expect(Object.keys(scene.meshes!)).toEqual(['triangle 1']);
    expect(meshShapes(scene).map(([name, { node, material }]) => [name, node, material])).toEqual([
      ['thing', 'thing', 'default'],
      ['thing 2', 'thing', 'red'],
      ['thing 2 2', 'thing 2', 'default'],
      ['thing 2 3', 'thing 2', 'red'],
    ]);
  });

  test('a primitive that uses little of a long list takes no more than that', async () => {
    const file = triangleFile((f) => {
      primitive(f).attributes.POSITION = f.floats('VEC3', ...Array.from({ length: 300 }, (_, i) => i));
      primitive(f).indices = f.accessor(Uint16Array.of(90, 7, 50, 7, 90, 99));
    });
    const { positions, indices } = meshOf((await imported(file)).scene);
    expect([...indices]).toEqual([0, 1, 2, 1, 0, 3]);
    expect([...positions]).toEqual([270, 271, 272, 21, 22, 23, 150, 151, 152, 297, 298, 299]);
  });
});

describe('numbers', () => {
  test('quantised positions, normals, coordinates and colours (KHR_mesh_quantization)', async () => {
    const file = triangleFile((f) => {
      f.json.extensionsRequired = f.json.extensionsUsed = ['KHR_mesh_quantization'];
      primitive(f).attributes = {
        POSITION: f.accessor(Int16Array.of(0, 0, 0, 100, 0, 0, 0, -100, 0), 'VEC3'),
        NORMAL: f.accessor(Int8Array.of(0, 0, 127, 0, 0, 127, 0, -90, 90), 'VEC3', { normalized: true }),
        TEXCOORD_0: f.accessor(Uint16Array.of(0, 0, 65535, 0, 0, 32768), 'VEC2', { normalized: true }),
        TEXCOORD_1: f.accessor(Uint8Array.of(0, 1, 2, 3, 4, 5), 'VEC2'),
        COLOR_0: f.accessor(Uint8Array.of(255, 0, 51, 255, 255, 255, 0, 0, 0), 'VEC3', { normalized: true }),
      };
    });
    const { scene, report } = await imported(file);
    const mesh = meshOf(scene);
    close(mesh.positions, [0, 0, 0, 100, 0, 0, 0, -100, 0]);
    close(mesh.normals, [0, 0, 1, 0, 0, 1, 0, -Math.SQRT1_2, Math.SQRT1_2]);
    close(mesh.uvs![0], [0, 0, 1, 0, 0, 32768 / 65535]);
    close(mesh.uvs![1], [0, 1, 2, 3, 4, 5]);
    close(mesh.colors, [1, 0, 0.2, 1, 1, 1, 1, 1, 0, 0, 0, 1]);
    expect(report.entries).toEqual([]);
  });

  test('interleaved and offset', async () => {
    const file = triangleFile((f) => {
      const rows = [0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1];
      const bufferView = f.view(new Uint8Array(Float32Array.from([9, ...rows]).buffer), { byteStride: 24 });
      const accessor = { bufferView, componentType: 5126, count: 3, type: 'VEC3' };
      primitive(f).attributes = {
        POSITION: f.add('accessors', { ...accessor, byteOffset: 4 }),
        NORMAL: f.add('accessors', { ...accessor, byteOffset: 16 }),
      };
    });
    const mesh = meshOf((await imported(file)).scene);
    close(mesh.positions, [0, 0, 0, 1, 0, 0, 0, 1, 0]);
    close(mesh.normals, [0, 0, 1, 0, 0, 1, 0, 0, 1]);
  });

  test('sparse, over numbers and over nothing', async () => {
    const sparse = (f: GltfFile, base: object): object => ({
      ...base,
      componentType: 5126,
      count: 3,
      type: 'VEC3',
      sparse: {
        count: 1,
        indices: { bufferView: f.view(Uint8Array.of(1)), componentType: 5121 },
        values: { bufferView: f.view(new Uint8Array(Float32Array.of(7, 8, 9).buffer)) },
      },
    });
    const over = triangleFile((f) => {
      primitive(f).attributes.POSITION = f.add('accessors', sparse(f, { bufferView: 0 }));
    });
    close(meshOf((await imported(over)).scene).positions, [0, 0, 0, 7, 8, 9, 0, 1, 0]);
    const alone = triangleFile((f) => {
      primitive(f).attributes.POSITION = f.add('accessors', sparse(f, {}));
    });
    close(meshOf((await imported(alone)).scene).positions, [0, 0, 0, 7, 8, 9, 0, 0, 0]);
  });

  test('normals and tangents without direction are replaced, and that is told', async () => {
    const file = triangleFile((f) => {
      f.add('materials', { normalTexture: { index: 0 } });
      f.add('textures', {});
      primitive(f).attributes.NORMAL = f.floats('VEC3', 0, 0, 0, 0, 0, 3, Number.NaN, 0, 0);
    });
    const { scene, report } = await imported(file);
    close(meshOf(scene).normals, [0, 0, 1, 0, 0, 1, 0, 0, 1]);
    expect(said(report)).toContain('changed NORMAL /meshes/0/primitives/0/attributes/NORMAL');
  });

  test('attributes that nobody reads are named', async () => {
    const file = triangleFile((f) => {
      const a = primitive(f).attributes;
      Object.assign(a, {
        _ID: a.POSITION,
        TEXCOORD_2: f.floats('VEC2', 0, 0, 0, 0, 0, 0),
        COLOR_1: f.floats('VEC4', ...new Array(12).fill(1)),
      });
    });
    expect(said((await imported(file)).report)).toEqual([
      'unsupported _ID /meshes/0/primitives/0/attributes/_ID',
      'unsupported TEXCOORD_2 /meshes/0/primitives/0/attributes/TEXCOORD_2',
      'unsupported COLOR_1 /meshes/0/primitives/0/attributes/COLOR_1',
    ]);
  });
});

describe('meshes that change their form', () => {
  test('skin weights: two sets, scaled to 1, with the joints of weight 0 at 0', async () => {
    const file = triangleFile((f) => {
      Object.assign(primitive(f).attributes, {
        JOINTS_0: f.accessor(Uint8Array.of(0, 1, 0, 9, 1, 0, 0, 0, 0, 0, 0, 0), 'VEC4'),
        WEIGHTS_0: f.accessor(Uint8Array.of(255, 255, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0), 'VEC4', { normalized: true }),
        JOINTS_1: f.accessor(Uint16Array.of(1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), 'VEC4'),
        WEIGHTS_1: f.floats('VEC4', 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0),
      });
      f.json.nodes.push({ name: 'a', children: [2], translation: [0, 1, 0] }, { name: 'b' });
      f.json.nodes[0].skin = f.add('skins', {
        joints: [1, 2],
        inverseBindMatrices: f.floats('MAT4', ...identity(), ...identity([0, -1, 0])),
      });
    });
    const { scene, report } = await imported(file);
    const { skin } = meshOf(scene);
    expect([...skin!.joints.slice(0, 8)]).toEqual([0, 1, 0, 0, 1, 0, 0, 0]);
    close(skin!.weights.slice(0, 8), [0.25, 0.25, 0, 0, 0.5, 0, 0, 0]);
    // A vertex without weights hangs on the first joint.
    close(skin!.weights.slice(16, 24), [1, 0, 0, 0, 0, 0, 0, 0]);
    expect(said(report)).toEqual(['changed WEIGHTS_0 /meshes/0/primitives/0/attributes/WEIGHTS_0']);
    // The joints are not in the file's scene; they come along, with what carries them.
    expect(scene.skins).toEqual({ 'skin 0': { joints: ['a', 'b'], inverseBindMatrices: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1, 0) } }); // biome-ignore format: matrices
    expect(scene.nodes!.b).toEqual({ parent: 'a' });
    expect(scene.shapes.thing).toMatchObject({ skin: 'skin 0' });
  });

  test('morph targets and weights', async () => {
    const file = triangleFile((f) => {
      primitive(f).attributes.NORMAL = f.floats('VEC3', 0, 0, 1, 0, 0, 1, 0, 0, 1);
      primitive(f).targets = [
        {
          POSITION: f.floats('VEC3', 0, 0, 1, 0, 0, 0, 0, 0, 0),
          NORMAL: f.accessor(Int8Array.of(127, 0, 0, 0, 0, 0, 0, 0, 0), 'VEC3', { normalized: true }),
        },
        { POSITION: f.floats('VEC3', 0, 0, 0, 0, 0, 2, 0, 0, 0), TEXCOORD_0: f.floats('VEC2', 0, 0, 0, 0, 0, 0) },
      ];
      f.json.meshes[0].weights = [0.5];
      f.json.scenes[0].nodes.push(f.add('nodes', { mesh: 0, weights: [0, 1] }));
    });
    const { scene, report } = await imported(file);
    const { morphTargets } = meshOf(scene);
    expect(morphTargets).toEqual([
      { positions: Float32Array.of(0, 0, 1, 0, 0, 0, 0, 0, 0), normals: Float32Array.of(1, 0, 0, 0, 0, 0, 0, 0, 0) },
      { positions: Float32Array.of(0, 0, 0, 0, 0, 2, 0, 0, 0) },
    ]);
    expect(scene.nodes!.thing!.weights).toEqual([0.5, 0]);
    expect(scene.nodes!['node 1']!.weights).toEqual([0, 1]);
    expect(said(report)).toEqual(['unsupported TEXCOORD_0 /meshes/0/primitives/0/targets/1/TEXCOORD_0']);
  });
});

describe('nodes', () => {
  test('matrices keep their shear; names are told apart; other scenes are named', async () => {
    const file = triangleFile((f) => {
      // Column by column: x' = x + 2y + 5.
      f.json.nodes[0] = {
        name: ' a\nb ',
        mesh: 0,
        matrix: [1, 0, 0, 0, 2, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1],
        children: [1, 2, 3],
      };
      f.json.nodes.push({ name: 'a b' }, { name: '__proto__' }, { rotation: [0, 0, 0, 2] });
      f.json.scenes.push({ name: 'attic', nodes: [] });
    });
    const { scene, report } = await imported(file);
    expect(Object.keys(scene.nodes!)).toEqual(['a b', 'a b 2', '__proto__ 2', 'node 3']);
    expect(scene.nodes!['a b']!.matrix).toEqual([1, 2, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7]);
    expect(scene.nodes!['node 3']).toEqual({ parent: 'a b', rotation: [0, 0, 0, 1] });
    expect(said(report)).toEqual(['unused scene /scenes/1', 'changed rotation /nodes/3/rotation']);
  });

  test('what is pressed flat keeps a little of its extent; what has none is not there', async () => {
    const file = triangleFile((f) => {
      f.json.nodes[0].scale = [-3, 0, 1];
      f.json.scenes[0].nodes.push(f.add('nodes', { mesh: 0, scale: [0, 0, 0] }));
    });
    const { scene, report } = await imported(file);
    close(scene.nodes!.thing!.scale, [-3, 3e-4, 1]);
    expect(scene.nodes!['node 1']!.scale).toEqual([0, 0, 0]);
    expect(said(report)).toEqual(['changed scale /nodes/0/scale']);
  });

  test('a file without a surface says so', async () => {
    const file = triangleFile((f) => delete f.json.nodes[0].mesh);
    expect(said((await imported(file)).report)).toContain('unused scene ');
  });

  test('instances (EXT_mesh_gpu_instancing)', async () => {
    const file = triangleFile((f) => {
      f.json.extensionsUsed = ['EXT_mesh_gpu_instancing'];
      const s = Math.SQRT1_2;
      f.json.nodes[0].extensions = {
        EXT_mesh_gpu_instancing: {
          attributes: {
            TRANSLATION: f.floats('VEC3', 1, 2, 3, 0, 0, 0),
            ROTATION: f.accessor(Int8Array.of(0, 0, 0, 127, 0, 0, Math.round(s * 127), Math.round(s * 127)), 'VEC4', {
              normalized: true,
            }),
            _ID: f.floats('SCALAR', 0, 1),
          },
        },
      };
    });
    const { scene, report } = await imported(file);
    const [, shape] = meshShapes(scene)[0]!;
    close(shape.instances, [1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0]);
    expect(report.counts.placements).toBe(2);
    expect(said(report)).toEqual(['unsupported _ID /nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/_ID']);
  });

  test('what is hidden is left out and named (KHR_node_visibility)', async () => {
    const file = triangleFile((f) => {
      f.json.extensionsUsed = ['KHR_node_visibility'];
      f.json.scenes[0].nodes.push(1);
      f.json.nodes.push({ extensions: { KHR_node_visibility: { visible: false } }, children: [2] }, { mesh: 0 });
    });
    const { scene, report } = await imported(file);
    expect(Object.keys(scene.shapes)).toEqual(['thing']);
    expect(said(report)).toEqual(['unused KHR_node_visibility /nodes/1']);
  });

  test('a root below a node that the scene does not have stands by itself', async () => {
    const file = triangleFile((f) => f.json.nodes.push({ children: [0], translation: [5, 0, 0] }));
    const { scene, report } = await imported(file);
    expect(scene.nodes).toEqual({ thing: {} });
    expect(said(report)).toEqual(['changed node /nodes/0']);
  });

  test('a file without a scene shows all its trees', async () => {
    const file = triangleFile((f) => {
      delete f.json.scenes;
      f.json.nodes.push({ mesh: 0 });
    });
    expect(Object.keys((await imported(file)).scene.shapes)).toEqual(['thing', 'node 1']);
  });
});

function identity(moved: readonly number[] = [0, 0, 0]): number[] {
  return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...moved, 1];
}
