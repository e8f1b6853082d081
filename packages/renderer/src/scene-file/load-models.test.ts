import { describe, expect, test } from 'vitest';
import { triangleFile } from '../../../../tests/fixtures/gltf.ts';
import { nodeDecoder } from '../headless/node-images.ts';
import { nodeTransforms, worldOf } from '../scene/node-transforms.ts';
import type { Scene } from '../scene/scene.ts';
import { boundsAt } from '../scene/scene-bounds.ts';
import { loadFiles } from './load-files.ts';
import { parseScene } from './parse-scene.ts';
import { requireScene } from './require-scene.ts';
import { writeScene } from './write-scene.ts';

/** A triangle that walks, in two looks, with a lamp and a camera. */
const animal = triangleFile((f) => {
  const sampler = { input: f.floats('SCALAR', 0, 1), output: f.floats('VEC3', 0, 0, 0, 1, 1, 1) };
  f.add('animations', {
    name: 'walk',
    samplers: [sampler],
    channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }],
  });
  f.add('materials', { name: 'dark' });
  f.add('cameras', { type: 'perspective', name: 'close', perspective: { yfov: 1, znear: 0.1 } });
  f.json.nodes[0].camera = 0;
  f.json.extensions = { KHR_materials_variants: { variants: [{ name: 'night' }] } };
  f.json.meshes[0].primitives[0].extensions = {
    KHR_materials_variants: { mappings: [{ material: 0, variants: [0] }] },
  };
}).glb();

const text = (more: object = {}) =>
  JSON.stringify({
    version: 1,
    name: 'Zoo',
    camera: { eye: [0, 1, 5], target: [0, 1, 0] },
    materials: { grass: {} },
    nodes: { hill: { translation: [0, 10, 0] } },
    shapes: { floor: { type: 'plane', point: [0, 0, 0], normal: [0, 1, 0], material: 'grass' } },
    models: {
      fox: { file: 'animals/fox.glb', translation: [1, 0, 0], scale: [2, 2, 2], node: 'hill' },
      twin: { file: 'animals/fox.glb' },
    },
    clip: 'fox/walk',
    ...more,
  });

async function load(scene: string, read = async (_: string): Promise<Uint8Array> => animal) {
  const parsed = parseScene(scene);
  if (!parsed.ok) throw new Error(parsed.problems[0]!.message);
  return { parsed: parsed.scene, loaded: await loadFiles(parsed.scene, read, { decoder: nodeDecoder() }) };
}
async function good(scene: string): Promise<Scene> {
  const { loaded } = await load(scene);
  if (!loaded.ok) throw new Error(loaded.problems.map(({ message }) => message).join('\n'));
  return loaded.scene;
}

describe('models in a scene', () => {
  test('stand where they are put, with everything under their names', async () => {
    const scene = await good(text());
    expect(requireScene(scene)).toBe(scene);
    expect(Object.keys(scene.shapes)).toEqual(['floor', 'fox/thing', 'twin/thing']);
    expect(scene.shapes['fox/thing']).toMatchObject({
      mesh: 'fox/triangle',
      material: 'fox/default',
      node: 'fox/thing',
    });
    expect(Object.keys(scene.cameras!)).toEqual(['fox/close', 'twin/close']);
    expect(scene.variants!['fox/night']).toEqual({ 'fox/thing': 'fox/dark' });
    expect(scene.clips!['fox/walk']!.tracks[0]!.target).toBe('/nodes/fox~1thing/translation');
    const transforms = nodeTransforms(scene);
    const at = (time: number, node: string) => Array.from(worldOf(transforms, transforms.at(time), node));
    expect(at(0, 'fox/thing')).toEqual([2, 0, 0, 1, 0, 2, 0, 10, 0, 0, 2, 0]);
    // One step of the fox is two metres long, as it is twice as large; the twin rests.
    expect(at(0.5, 'fox/thing').filter((_, i) => i % 4 === 3)).toEqual([2, 11, 1]);
    expect(at(0.5, 'twin/thing').filter((_, i) => i % 4 === 3)).toEqual([0, 0, 0]);
    expect(boundsAt(scene, 0)!.max[1]).toBeGreaterThan(10);
  });

  test('a variant, and what is not there', async () => {
    const models = { fox: { file: 'fox.glb', variant: 'night' } };
    expect((await good(text({ models }))).shapes['fox/thing']!.material).toBe('fox/dark');
    const problems = async (more: object, read?: () => Promise<Uint8Array>) => {
      const { loaded } = await load(text(more), read);
      return loaded.ok ? [] : loaded.problems.map(({ path, message }) => `${path} ${message}`);
    };
    const other = { models: { fox: { file: 'fox.glb', variant: 'nihgt' } } };
    expect(await problems(other)).toEqual([
      '/models/fox/variant The model "fox" has no variant "nihgt"; expected "night". Did you mean "night"?',
      expect.stringContaining('/clip The clip "fox/walk" is to play'),
    ]);
    expect(await problems({ clip: 'fox/wlak' })).toEqual([expect.stringContaining('Did you mean "fox/walk"?')]);
    const gone = await problems({ models: { fox: { file: 'gone.glb' } }, clip: undefined }, () =>
      Promise.reject(new Error('there is no such file')),
    );
    expect(gone).toEqual(['/models/fox/file The model "fox" cannot be read from "gone.glb": there is no such file.']);
    const torn = await problems({ models: { fox: { file: 'torn.glb' } }, clip: undefined }, async () =>
      animal.slice(0, 99),
    );
    expect(torn[0]).toMatch(/^\/models\/fox\/file The model "fox" cannot be used\./);
    const lights = Object.fromEntries(
      Array.from({ length: 16 }, (_, i) => [`lamp ${i}`, { type: 'point', position: [0, i, 0], intensity: 1 }]),
    );
    expect(await problems({ lights })).toEqual([]);
  });

  test('writing gives the file back; what was changed cannot be written', async () => {
    const scene = await good(text());
    const { parsed } = await load(text());
    const again = parseScene(writeScene(scene));
    expect(again.ok && again.scene).toEqual(parsed);
    const painted = {
      ...scene,
      materials: { ...scene.materials, 'fox/default': { ...scene.materials['fox/default']!, metallic: 0 } },
    };
    expect(() => writeScene(painted)).toThrow('The model "fox" has been changed (materials, "fox/default")');
    // As a scene of a program it is as good as any.
    expect(requireScene(painted).materials['fox/default']!.metallic).toBe(0);
  });

  test('a file beside the model is looked for beside it', async () => {
    const asked: string[] = [];
    const file = triangleFile((f) => {
      f.add('images', { uri: 'fur.png' });
      f.add('textures', { source: 0 });
      f.add('materials', { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } });
      f.json.meshes[0].primitives[0].material = 0;
    }).glb();
    await load(text({ clip: undefined }), async (name) => {
      asked.push(name);
      if (name.endsWith('.png')) throw new Error('gone');
      return file;
    });
    expect(asked).toContain('animals/fur.png');
  });
});

describe('mesh files with their own materials', () => {
  const obj = 'mtllib c.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 3\nusemtl cloth\nf 3 2 1\n';
  const files: Record<string, string> = {
    'm/c.obj': obj,
    'm/c.mtl': 'newmtl wood\nKd 1 0 0\nnewmtl cloth\nKd 0 0 1\n',
  };
  const read = async (name: string) => {
    if (files[name] === undefined) throw new Error(`no ${name}`);
    return new TextEncoder().encode(files[name]);
  };
  const scene = (more: object) =>
    JSON.stringify({ version: 1, name: 'Chairs', camera: { eye: [0, 0, 5], target: [0, 0, 0] }, ...more });
  const placed = { translation: [1, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] };

  test('as a model, and as a shape that names no material', async () => {
    const shapes = { b: { type: 'mesh', mesh: 'm/c.obj' }, c: { type: 'mesh', mesh: 'named', translation: [1, 0, 0] } };
    const text = scene({ models: { a: { file: 'm/c.obj' } }, shapes, meshes: { named: { file: 'm/c.obj' } } });
    const { parsed, loaded } = await load(text, read);
    expect(parsed.models!.c).toEqual({ file: 'm/c.obj', ...placed });
    expect(parsed.meshes).toBeUndefined();
    if (!loaded.ok) throw new Error(loaded.problems[0]!.message);
    for (const name of ['a', 'b', 'c']) {
      expect(loaded.scene.materials[`${name}/wood`]!.baseColor).toEqual([1, 0, 0]);
      expect(loaded.scene.shapes[`${name}/cloth`]).toMatchObject({ material: `${name}/cloth`, node: name });
    }
    expect(writeScene(loaded.scene)).not.toContain('wood');
    expect(parseScene(writeScene(loaded.scene))).toEqual({ ok: true, scene: parsed });
  });

  test('the material of a shape goes before those of its file', async () => {
    const shapes = { a: { type: 'mesh', mesh: 'm/c.obj', material: 'grey' }, b: { type: 'mesh', mesh: 'm/c.obj' } };
    const { loaded } = await load(scene({ materials: { grey: {} }, shapes }), read);
    if (!loaded.ok) throw new Error(loaded.problems[0]!.message);
    expect(Object.keys(loaded.scene.shapes)).toEqual(['a', 'b/wood', 'b/cloth']);
    expect(loaded.scene.meshes!['m/c.obj']!.data!.indices).toHaveLength(6);
  });

  test.each([
    ['a part', { meshes: { p: { file: 'm/c.obj', part: 'wood' } }, shapes: { s: { type: 'mesh', mesh: 'p' } } }],
    ['many places', { shapes: { s: { type: 'mesh', mesh: 'm/c.obj', instances: [{}] } } }],
    ['a sphere', { shapes: { s: { type: 'sphere', center: [0, 0, 0], radius: 1 } } }],
  ])('%s without a material is a mistake', (_, more) => {
    const parsed = parseScene(scene(more));
    expect(parsed).toMatchObject({ ok: false, problems: [{ path: '/shapes/s/material' }] });
  });
});
