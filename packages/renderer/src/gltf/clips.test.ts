import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { type Draft, type GltfFile, triangleFile } from '../../../../tests/fixtures/gltf.ts';
import { sceneAt } from '../scene/animation.ts';
import { deform, jointMatrices, makeDeformed } from '../scene/deform.ts';
import { nodeTransforms } from '../scene/node-transforms.ts';
import type { Scene, SpotLight } from '../scene/scene.ts';
import { importGltf } from './index.ts';
import type { ImportReport } from './report.ts';

async function imported(file: GltfFile | Uint8Array): Promise<{ scene: Scene; report: ImportReport }> {
  const result = await importGltf(file instanceof Uint8Array ? file : file.glb());
  if (!result.ok) throw new Error(result.problems.map(({ message }) => message).join('\n'));
  return result;
}
const said = ({ entries }: ImportReport) =>
  entries.map(({ kind, what, places }) => `${kind} ${what} ${places.join(' ')}`);

/** One animation with a channel for each target and its sampler. */
const animated = (
  channels: (file: GltfFile) => readonly { target: Draft; sampler: Draft }[],
  more: (file: GltfFile) => void = () => {},
): GltfFile =>
  triangleFile((f) => {
    more(f);
    const made = channels(f);
    f.add('animations', {
      name: 'go',
      channels: made.map(({ target }, sampler) => ({ target, sampler })),
      samplers: made.map(({ sampler }) => sampler),
    });
  });
const pointer = (text: string): Draft => ({
  path: 'pointer',
  extensions: { KHR_animation_pointer: { pointer: text } },
});

describe('animations', () => {
  test('move nodes as the file says: step, linear, cubic', async () => {
    const { scene, report } = await imported(
      animated((f) => {
        const input = f.floats('SCALAR', 0, 2);
        return [
          {
            target: { node: 0, path: 'translation' },
            sampler: { input, output: f.floats('VEC3', 0, 0, 0, 4, 0, 0), interpolation: 'STEP' },
          },
          {
            target: { node: 0, path: 'rotation' },
            sampler: {
              input,
              output: f.accessor(Int8Array.of(0, 0, 0, 127, 0, 0, 127, 0), 'VEC4', { normalized: true }),
            },
          },
          {
            target: { node: 0, path: 'scale' },
            sampler: {
              input,
              output: f.floats('VEC3', 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 3, 3, 3, 0, 0, 0),
              interpolation: 'CUBICSPLINE',
            },
          },
        ];
      }),
    );
    expect(report.entries).toEqual([]);
    expect(scene.clip).toBe('go');
    expect(scene.clips!.go!.duration).toBe(2);
    const { translation, rotation, scale } = sceneAt(scene, 1).nodes!.thing!;
    expect(translation).toEqual([0, 0, 0]);
    expect(rotation![2]).toBeCloseTo(Math.SQRT1_2, 6);
    expect(rotation![3]).toBeCloseTo(Math.SQRT1_2, 6);
    expect(scale).toEqual([2, 2, 2]);
  });

  test('what moves nothing of the scene is named', async () => {
    const { scene, report } = await imported(
      animated(
        (f) => {
          const sampler = { input: f.floats('SCALAR', 0), output: f.floats('VEC3', 0, 0, 0) };
          return [
            { target: { node: 1, path: 'translation' }, sampler },
            { target: { path: 'translation' }, sampler },
            { target: { node: 0, path: 'weights' }, sampler },
            { target: { node: 0, path: 'translation' }, sampler },
            { target: { node: 0, path: 'translation' }, sampler },
            { target: pointer('/materials/7/emissiveFactor'), sampler },
            { target: pointer('/nodes/0/extensions/ACME_x/y'), sampler },
          ];
        },
        (f) => {
          f.add('nodes', { name: 'elsewhere' });
          f.add('animations', { channels: [], samplers: [] });
        },
      ),
    );
    expect(Object.keys(scene.clips!)).toEqual(['go']);
    expect(scene.clips!.go!.tracks.map(({ target }) => target)).toEqual(['/nodes/thing/translation']);
    expect(said(report)).toEqual([
      'unused animation /animations/0',
      'unused animation /animations/1/channels/0 /animations/1/channels/1',
      'unsupported animation /animations/1/channels/2',
      'changed animation /animations/1/channels/4',
      'unused KHR_animation_pointer /animations/1/channels/5',
      'unsupported KHR_animation_pointer /animations/1/channels/6',
    ]);
  });

  test('pointers move materials, textures, lights and cameras, in the units of scenes (KHR_animation_pointer)', async () => {
    const file = animated(
      (f) => {
        const input = f.floats('SCALAR', 0, 2);
        const track = (text: string, output: number): { target: Draft; sampler: Draft } => ({
          target: pointer(text),
          sampler: { input, output },
        });
        return [
          track('/materials/0/pbrMetallicRoughness/baseColorFactor', f.floats('VEC4', 0, 0, 0, 0, 1, 0.5, 0, 1)),
          track('/materials/0/extensions/KHR_materials_clearcoat/clearcoatFactor', f.floats('SCALAR', 0, 1)),
          track('/materials/0/emissiveTexture/extensions/KHR_texture_transform/offset', f.floats('VEC2', 0, 0, 1, 1)),
          track(
            '/materials/0/emissiveTexture/extensions/KHR_texture_transform/rotation',
            f.floats('SCALAR', 0, Math.PI),
          ),
          track('/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle', f.floats('SCALAR', 0, Math.PI / 2)),
          track('/cameras/0/perspective/yfov', f.floats('SCALAR', Math.PI / 6, Math.PI / 3)),
          track('/nodes/1/translation', f.floats('VEC3', 0, 0, 0, 2, 0, 0)),
          track('/materials/0/extensions/KHR_materials_sheen/sheenRoughnessFactor', f.floats('SCALAR', 0, 1)),
        ];
      },
      (f) => {
        const image = Uint8Array.from(
          readFileSync(new URL('../../../../tests/fixtures/images/interlaced-16.png', import.meta.url)),
        );
        f.add('textures', { source: f.add('images', { bufferView: f.view(image) }) });
        f.json.meshes[0].primitives[0].attributes.TEXCOORD_0 = f.floats('VEC2', 0, 0, 1, 0, 0, 1);
        f.json.meshes[0].primitives[0].material = f.add('materials', {
          emissiveTexture: { index: 0 },
          extensions: { KHR_materials_clearcoat: {} },
        });
        f.json.extensions = { KHR_lights_punctual: { lights: [{ type: 'spot' }] } };
        f.add('cameras', { name: 'eye', type: 'perspective', perspective: { yfov: 1, znear: 1 } });
        f.json.scenes[0].nodes.push(
          f.add('nodes', { name: 'rig', camera: 0, extensions: { KHR_lights_punctual: { light: 0 } } }),
        );
      },
    );
    const { scene, report } = await imported(file);
    const now = sceneAt(scene, 1);
    const material = now.materials['material 0']!;
    expect(material).toMatchObject({
      baseColor: [0.5, 0.25, 0],
      opacity: 0.5,
      clearcoat: { weight: 0.5, roughness: 0 },
    });
    expect(material.emissionTexture!.offset).toEqual([0.5, 0.5]);
    expect(material.emissionTexture!.rotation).toBeCloseTo(90, 4);
    expect((now.lights.rig as SpotLight).outerAngle).toBeCloseTo(45, 4);
    expect(now.camera.verticalFov).toBeCloseTo(45, 4);
    expect(now.cameras!.eye!.verticalFov).toBeCloseTo(45, 4);
    expect(now.nodes!.rig!.translation).toEqual([1, 0, 0]);
    // The material has no sheen that could move.
    expect(said(report)).toContain('unsupported KHR_animation_pointer /animations/0/channels/7');
  });

  test('weights of morph targets, by the node and by the mesh', async () => {
    const file = animated(
      (f) => {
        const input = f.floats('SCALAR', 0, 1);
        return [
          { target: { node: 0, path: 'weights' }, sampler: { input, output: f.floats('SCALAR', 0, 0, 1, 2) } },
          { target: pointer('/meshes/0/weights'), sampler: { input, output: f.floats('SCALAR', 0, 0, 4, 8) } },
        ];
      },
      (f) => {
        const POSITION = f.floats('VEC3', 0, 0, 1, 0, 0, 0, 0, 0, 0);
        f.json.meshes[0].primitives[0].targets = [{ POSITION }, { POSITION }];
        f.json.nodes[0].weights = [0, 0];
        f.json.scenes[0].nodes.push(f.add('nodes', { name: 'other', mesh: 0 }));
      },
    );
    const now = sceneAt((await imported(file)).scene, 0.5);
    expect(now.nodes!.thing!.weights).toEqual([0.5, 1]);
    expect(now.nodes!.other!.weights).toEqual([2, 4]);
  });

  test('Khronos’ SimpleSkin bends as its text says: the upper half turns about (0, 1, 0)', async () => {
    const path = new URL('../../../../tests/fixtures/models/SimpleSkin.gltf', import.meta.url);
    const { scene } = await imported(Uint8Array.from(readFileSync(path)));
    const mesh = Object.values(scene.meshes!)[0]!.data!;
    const out = makeDeformed(mesh);
    const pose = (time: number): Float32Array => {
      const transforms = nodeTransforms(scene);
      deform(mesh, { joints: jointMatrices(scene.skins!['skin 0']!, transforms, transforms.at(time)) }, out);
      return out.positions;
    };
    // In the pose of binding the mesh stands about the origin: the inverse bind matrices move it by half its width.
    const rest = pose(0).slice();
    for (let i = 0; i < rest.length; i++) expect(rest[i]).toBeCloseTo(mesh.positions[i]! - (i % 3 === 0 ? 0.5 : 0), 5);
    const bent = pose(1); // a quarter turn by then
    expect([bent[0], bent[1]]).toEqual([rest[0], rest[1]]);
    // The upper right corner is the second joint's alone: (0.5, 1) from its joint turns to (−1, 0.5).
    expect(bent[27]).toBeCloseTo(-1, 3);
    expect(bent[28]).toBeCloseTo(1.5, 3);
  });
});

describe('animations that are refused', () => {
  const refused = async (sampler: (f: GltfFile) => Draft): Promise<string> => {
    const result = await importGltf(
      animated((f) => [{ target: { node: 0, path: 'rotation' }, sampler: sampler(f) }]).glb(),
    );
    return result.ok ? 'ok' : result.problems[0]!.path;
  };
  test.each<[string, (f: GltfFile) => Draft, string]>([
    [
      'times that fall',
      (f) => ({ input: f.floats('SCALAR', 1, 0), output: f.floats('VEC4', 0, 0, 0, 1, 0, 0, 0, 1) }),
      '/animations/0/samplers/0/input',
    ],
    [
      'a time that is no number',
      (f) => ({ input: f.floats('SCALAR', Number.NaN), output: f.floats('VEC4', 0, 0, 0, 1) }),
      '/accessors/2',
    ],
    [
      'values of another form',
      (f) => ({ input: f.floats('SCALAR', 0), output: f.floats('VEC3', 0, 0, 0) }),
      '/animations/0/samplers/0/output',
    ],
    [
      'too few values',
      (f) => ({ input: f.floats('SCALAR', 0, 1), output: f.floats('VEC4', 0, 0, 0, 1) }),
      '/animations/0/samplers/0/output',
    ],
  ])('%s', async (_, sampler, path) => {
    expect(await refused(sampler)).toBe(path);
  });
});
