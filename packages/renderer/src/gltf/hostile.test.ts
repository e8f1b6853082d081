/** Files that are broken, by mistake or on purpose: a list of problems that says where, what and what else, soon and without much memory. */
import { readFileSync } from 'node:fs';
import { Document, WebIO } from '@gltf-transform/core';
import { describe, expect, test } from 'vitest';
import { type Draft, type GltfFile, glbOf, triangleFile } from '../../../../tests/fixtures/gltf.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import type { Problem } from '../scene-file/problem.ts';
import { importGltf } from './index.ts';
import type { GltfImport, GltfOptions } from './types.ts';

const model = (name: string): Uint8Array =>
  Uint8Array.from(readFileSync(new URL(`../../../../tests/fixtures/models/${name}`, import.meta.url)));
const readFile = async (name: string): Promise<Uint8Array> => model(name);

/** The problems, each a whole sentence; fails when there are none. */
async function problemsOf(bytes: Uint8Array, options: GltfOptions = {}): Promise<readonly Problem[]> {
  const result = await importGltf(bytes, options);
  if (result.ok) throw new Error('The file was read.');
  for (const { message, found, allowed } of result.problems) {
    expect(message.endsWith('.')).toBe(true);
    expect(message.length).toBeLessThan(2000);
    expect(found).not.toBe('');
    expect(allowed).not.toBe('');
  }
  return result.problems;
}
const primitive = (file: GltfFile): Draft => file.json.meshes[0].primitives[0];

/** What is done to a good file, the place of the first problem, and words of its message. */
const BROKEN: readonly (readonly [string, (file: GltfFile) => void, string, string])[] = [
  ['no version', (f) => delete f.json.asset.version, '/asset/version', 'no version'],
  ['version 1', (f) => Object.assign(f.json.asset, { version: '1.0' }), '/asset/version', '"1.0"'],
  ['a list that is none', (f) => Object.assign(f.json, { nodes: 7 }), '/nodes', 'found 7'],
  [
    'an index beyond its list',
    (f) => Object.assign(f.json.nodes[0], { mesh: 5 }),
    '/nodes/0/mesh',
    'a place among its meshes, 0 to 0',
  ],
  [
    'an index that is negative',
    (f) => Object.assign(primitive(f), { indices: -1 }),
    '/meshes/0/primitives/0/indices',
    '-1',
  ],
  [
    'an index that is no number',
    (f) => Object.assign(primitive(f), { indices: '0' }),
    '/meshes/0/primitives/0/indices',
    'the text "0"',
  ],
  ['a node that carries itself', (f) => Object.assign(f.json.nodes[0], { children: [0] }), '/nodes/0/children', 'ring'],
  [
    'nodes in a ring',
    (f) => {
      f.json.nodes.push({ children: [2] }, { children: [3] }, { children: [1] });
    },
    '/nodes/1/children',
    'do not carry each other',
  ],
  [
    'a node carried twice',
    (f) => f.json.nodes.push({ children: [3] }, { children: [3] }, {}),
    '/nodes/2/children/0',
    'which node 1 carries already',
  ],
  [
    'a root that the scene carries already',
    (f) => {
      f.json.nodes.push({ children: [0] }, { children: [1] });
      f.json.scenes[0].nodes.push(2);
    },
    '/scenes/0/nodes/0',
    'which node 2 of the scene carries',
  ],
  [
    'an index of a vertex beyond',
    (f) => Object.assign(primitive(f), { indices: f.accessor(Uint16Array.of(0, 1, 3)) }),
    '/meshes/0/primitives/0/indices',
    'the index 3',
  ],
  [
    'positions that are no numbers',
    (f) => Object.assign(primitive(f).attributes, { POSITION: f.floats('VEC3', 0, 0, 0, 1, Number.NaN, 0, 0, 1, 0) }),
    '/accessors/2',
    'NaN in element 1',
  ],
  [
    'positions without end',
    (f) => Object.assign(primitive(f).attributes, { POSITION: f.floats('VEC3', 0, 0, 0, 1, Infinity, 0, 0, 1, 0) }),
    '/accessors/2',
    'Infinity',
  ],
  [
    'positions farther than any scene',
    (f) => Object.assign(primitive(f).attributes, { POSITION: f.floats('VEC3', 0, 0, 0, 1, 2e9, 0, 0, 1, 0) }),
    '/accessors/2',
    '1e9',
  ],
  [
    'a node farther than any scene',
    (f) => Object.assign(f.json.nodes[0], { translation: [0, 1e300, 0] }),
    '/nodes/0/translation/1',
    'from -1000000000 to 1000000000',
  ],
  [
    'nodes that enlarge each other',
    (f) => {
      Object.assign(f.json.nodes[0], { scale: [1e9, 1e9, 1e9], children: [1] });
      f.json.nodes.push({ scale: [1e9, 1e9, 1e9], mesh: 0 });
    },
    '/nodes',
    'farther than 1e9 metres',
  ],
  [
    'texture coordinates without end',
    (f) => Object.assign(primitive(f).attributes, { TEXCOORD_0: f.floats('VEC2', 0, 0, 1e30, 0, 0, 1) }),
    '/accessors/2',
    '1e9',
  ],
  [
    'a thousand million vertices without content',
    (f) =>
      Object.assign(primitive(f).attributes, {
        POSITION: f.add('accessors', { componentType: 5126, count: 1e9, type: 'VEC3' }),
      }),
    '/accessors/2',
    'at most',
  ],
  [
    'a thousand million vertices in a small buffer',
    (f) => Object.assign(f.json.accessors[0], { count: 1e9 }),
    '/accessors/0/count',
    'buffer view 0',
  ],
  [
    'more vertices than numbers can count',
    (f) => Object.assign(f.json.accessors[0], { count: 1e300 }),
    '/accessors/0/count',
    'whole number',
  ],
  [
    'a buffer view beyond its buffer',
    (f) => Object.assign(f.json.bufferViews[0], { byteLength: 4096 }),
    '/bufferViews/0/byteLength',
    'up to its end',
  ],
  [
    'an offset beyond all numbers',
    (f) => Object.assign(f.json.bufferViews[0], { byteOffset: Number.MAX_SAFE_INTEGER }),
    '/bufferViews/0/byteLength',
    'bytes',
  ],
  [
    'a stride that is too short',
    (f) => Object.assign(f.json.bufferViews[0], { byteStride: 4 }),
    '/bufferViews/0/byteStride',
    'at least the 12 bytes',
  ],
  [
    'a buffer longer than its content',
    (f) => Object.assign(f.json, { buffers: [{ byteLength: 5000 }] }),
    '/buffers/0/byteLength',
    '5000',
  ],
  [
    'a buffer without content',
    (f) => Object.assign(f.json, { buffers: [{ byteLength: 44 }, { byteLength: 10 }] }),
    '/buffers/1',
    'no content',
  ],
  [
    'positions of another type',
    (f) => Object.assign(primitive(f).attributes, { POSITION: f.floats('VEC2', 0, 0, 1, 0, 0, 1) }),
    '/meshes/0/primitives/0/attributes/POSITION',
    'VEC2',
  ],
  [
    'attributes of different lengths',
    (f) => Object.assign(primitive(f).attributes, { NORMAL: f.floats('VEC3', 0, 0, 1) }),
    '/meshes/0/primitives/0/attributes/NORMAL',
    'as many as there are positions',
  ],
  [
    'sparse places beyond',
    (f) =>
      Object.assign(f.json.accessors[0], {
        sparse: { count: 9, indices: { bufferView: 0, componentType: 5125 }, values: { bufferView: 0 } },
      }),
    '/accessors/0/sparse/count',
    'at most the 3',
  ],
  [
    'a sparse place beyond the elements',
    (f) => {
      const [places, values] = [f.view(Uint8Array.of(1, 7, 0, 0)), f.view(new Uint8Array(24))];
      Object.assign(f.json.accessors[0], {
        sparse: { count: 2, indices: { bufferView: places, componentType: 5121 }, values: { bufferView: values } },
      });
    },
    '/accessors/0/sparse/indices',
    'the place 7; expected 0 to 2',
  ],
  [
    'a matrix with perspective',
    (f) => Object.assign(f.json.nodes[0], { matrix: [1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] }),
    '/nodes/0/matrix',
    'last row is 0.5 0 0 1',
  ],
  ['joints beyond the skin', (f) => {
    Object.assign(primitive(f).attributes, { JOINTS_0: f.accessor(Uint8Array.of(0, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0), 'VEC4'), WEIGHTS_0: f.floats('VEC4', 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0) });
    Object.assign(f.json.nodes[0], { skin: f.add('skins', { joints: [0] }) });
  }, '/meshes/0/primitives/0/attributes/JOINTS_0', 'the joint 9'], // biome-ignore format: a row
  [
    'too few matrices for the joints',
    (f) => f.add('skins', { joints: [0, 0], inverseBindMatrices: f.floats('MAT4', ...new Array(16).fill(0)) }),
    '/skins/0/inverseBindMatrices',
    'one for each',
  ],
  ['an image that is none', (f) => withImage(f, Uint8Array.of(1, 2, 3, 4)), '/images/0', 'no image'],
  ['an image of a thousand million pixels', (f) => withImage(f, pngHead(60_000, 60_000)), '/images/0', '60000'],
  ['an image that is cut off', (f) => withImage(f, pngHead(4, 4)), '/images/0', 'cannot be decoded'],
  ['a mode that is none', (f) => Object.assign(primitive(f), { mode: 9 }), '/meshes/0/primitives/0/mode', '0 to 6'],
  [
    'a matrix of 15 numbers',
    (f) => Object.assign(f.json.nodes[0], { matrix: new Array(15).fill(0) }),
    '/nodes/0/matrix',
    '16 numbers',
  ],
  [
    'a translation beyond all numbers',
    (f) => Object.assign(f.json.nodes[0], { translation: [0, 'far', 0] }),
    '/nodes/0/translation/1',
    'the text "far"',
  ],
  [
    'an extension that must be known',
    (f) => Object.assign(f.json, { extensionsRequired: ['ACME_all'] }),
    '/extensionsRequired/0',
    '"ACME_all"',
  ],
  [
    'a light that is not there',
    (f) => Object.assign(f.json.nodes[0], { extensions: { KHR_lights_punctual: { light: 0 } } }),
    '/nodes/0/extensions/KHR_lights_punctual/light',
    'no lights',
  ],
  [
    'instances of different numbers',
    (f) =>
      Object.assign(f.json.nodes[0], {
        extensions: {
          EXT_mesh_gpu_instancing: {
            attributes: { TRANSLATION: f.floats('VEC3', 0, 0, 0), SCALE: f.floats('VEC3', 1, 1, 1, 1, 1, 1) },
          },
        },
      }),
    '/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes',
    'as many',
  ],
];

function withImage(file: GltfFile, bytes: Uint8Array): void {
  file.add('images', { bufferView: file.view(bytes) });
  file.add('textures', { source: 0 });
  primitive(file).material = file.add('materials', { emissiveTexture: { index: 0 } });
}

function pngHead(width: number, height: number): Uint8Array {
  const bytes = Uint8Array.of(
    137,
    80,
    78,
    71,
    13,
    10,
    26,
    10,
    0,
    0,
    0,
    13,
    73,
    72,
    68,
    82,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
    8,
    6,
    0,
    0,
    0,
    0,
    0,
    0,
    0,
  );
  const view = new DataView(bytes.buffer);
  view.setUint32(16, width);
  view.setUint32(20, height);
  return bytes;
}

describe('broken files', () => {
  test.each(BROKEN)('%s', async (_, spoil, path, words) => {
    const start = process.cpuUsage();
    const [first] = await problemsOf(triangleFile(spoil).glb());
    expect(first).toMatchObject({ path });
    expect(first!.message).toContain(words);
    // Microseconds of this process alone, however busy the machine is.
    expect(process.cpuUsage(start).user).toBeLessThan(5e6);
  });

  test('all mistakes are told, not the first alone', async () => {
    const file = triangleFile((f) => {
      f.json.nodes[0].mesh = 3;
      f.json.accessors[0].count = -1;
      f.json.materials = [{ alphaMode: 'HALF' }, { emissiveFactor: [1, 2] }];
    });
    expect((await problemsOf(file.glb())).map(({ path }) => path)).toEqual(['/accessors/0/count', '/materials/0/alphaMode', '/materials/1/emissiveFactor', '/nodes/0/mesh']); // biome-ignore format: one line
  });

  test('a hundred thousand mistakes are a hundred and a number', async () => {
    const file = triangleFile((f) => {
      f.json.nodes = Array.from({ length: 100_000 }, () => ({ mesh: 9 }));
    });
    const problems = await problemsOf(file.glb());
    expect(problems).toHaveLength(101);
    expect(problems.at(-1)!.message).toContain('99900 more');
  });

  test('what is no glTF file at all', async () => {
    const text = (content: string): Uint8Array => new TextEncoder().encode(content);
    expect((await problemsOf(new Uint8Array()))[0]!.message).toContain('JSON');
    expect((await problemsOf(text('{ "asset": ')))[0]!.message).toContain('line 1');
    expect((await problemsOf(text('[]')))[0]!.message).toContain('an object');
    expect((await problemsOf(text('{}')))[0]!.path).toBe('/asset/version');
    expect((await problemsOf(Uint8Array.of(0xff, 0xfe, 0, 1)))[0]!.message).toContain('no text');
    expect((await problemsOf(text(`${'['.repeat(1e6)}`)))[0]!.message).toContain('JSON');
    expect((await problemsOf(text('{"__proto__": {"asset": {"version": "2.0"}}}')))[0]!.path).toBe('/asset/version');
  });
});

describe('containers', () => {
  test('a GLB that is cut off anywhere is refused, with what its head tells', async () => {
    const whole = triangleFile().glb();
    for (let length = 0; length < whole.length; length += 7) {
      const [first] = await problemsOf(whole.subarray(0, length));
      if (length >= 20) expect(first!.message).toContain(`the ${whole.length} bytes that its head tells`);
    }
  });

  test('chunks that lie about their length, other versions, no JSON', async () => {
    const change = (at: number, word: number): Uint8Array => {
      const bytes = triangleFile().glb();
      new DataView(bytes.buffer).setUint32(at, word, true);
      return bytes;
    };
    expect((await problemsOf(change(12, 0xffffffff)))[0]!.message).toContain('a chunk of 4294967295 bytes');
    expect((await problemsOf(change(4, 1)))[0]!.message).toContain('version 1');
    expect((await problemsOf(change(16, 0)))[0]!.message).toContain('JSON');
    expect((await problemsOf(change(8, 0xfffffff0)))[0]!.message).toContain('cut off');
    expect((await problemsOf(glbOf({ asset: { version: '2.0' }, buffers: [{ byteLength: 4 }] }, null)))[0]!.path).toBe(
      '/buffers/0',
    );
  });
});

describe('files that a file names', () => {
  const naming = (uri: string): Uint8Array => {
    const file = triangleFile();
    file.json.buffers = [{ byteLength: 42, uri }];
    return new TextEncoder().encode(JSON.stringify(file.json));
  };
  test.each([
    '../secret.bin',
    'a/../../secret.bin',
    '/etc/passwd',
    'C:\\secret',
    'https://example.com/x.bin',
    'file:///etc/passwd',
    '..%2f..%2fsecret',
    '%2e%2e/secret',
    'javascript:alert(1)',
    '',
    '.',
  ])(
    // biome-ignore format: one list
    '%j is not asked for',
    async (uri) => {
      const asked: string[] = [];
      const read = async (name: string): Promise<Uint8Array> => {
        asked.push(name);
        return new Uint8Array(42);
      };
      const [first] = await problemsOf(naming(uri), { readFile: read });
      expect(first!.path).toBe('/buffers/0/uri');
      expect(asked).toEqual([]);
    },
  );

  test('names are decoded, and reasons are passed on', async () => {
    const file = triangleFile();
    const asked: string[] = [];
    const result = await importGltf(naming('my%20mesh/./100%.bin'), {
      readFile: async (name) => {
        asked.push(name);
        return file.buffer;
      },
    });
    expect(result.ok).toBe(true);
    expect(asked).toEqual(['my%20mesh/./100%.bin'.replace('./', '')]);
    const missing = await problemsOf(naming('x.bin'), {
      readFile: async () => {
        throw new Error('there is no such file.');
      },
    });
    expect(missing[0]!.message).toContain('(there is no such file)');
    expect((await problemsOf(naming('x.bin')))[0]!.message).toContain('has not been given');
    expect((await problemsOf(naming('x.bin'), { readFile: async () => new Uint8Array(3) }))[0]!.message).toContain(
      'there are 3',
    );
  });

  test('data URIs: whole, broken, cut off', async () => {
    expect((await importGltf(triangleFile().text())).ok).toBe(true);
    for (const uri of [
      'data:',
      'data:application/octet-stream;base64,@@@@',
      'data:application/octet-stream;base64,AAAA',
      'data:text/plain,%E0%A4%A',
    ])
      expect((await problemsOf(naming(uri)))[0]!.path).toMatch(/^\/buffers\/0/);
  });
});

describe('compression', () => {
  const jsonOf = (name: string): Draft => {
    const bytes = model(name);
    const text = name.endsWith('.glb')
      ? bytes.subarray(20, 20 + new DataView(bytes.buffer).getUint32(12, true))
      : bytes;
    return JSON.parse(new TextDecoder().decode(text));
  };
  const changedMeshopt = (change: (json: Draft) => void): Uint8Array => {
    const bytes = model('BoxMeshopt.glb');
    const json = jsonOf('BoxMeshopt.glb');
    change(json);
    return glbOf(json, bytes.subarray(20 + new DataView(bytes.buffer).getUint32(12, true) + 8));
  };

  test('meshoptimizer: streams that promise more than they can hold', async () => {
    const bomb = await problemsOf(
      changedMeshopt((json) => {
        const view = json.bufferViews[0];
        const meshopt = view.extensions.EXT_meshopt_compression;
        meshopt.count = 1e8;
        view.byteLength = 1e8 * meshopt.byteStride;
        json.buffers[1].byteLength = view.byteLength * 2;
      }),
    );
    expect(bomb[0]!.message).toContain('compression can hold');
    expect((await problemsOf(changedMeshopt((json) => (json.bufferViews[0].extensions.EXT_meshopt_compression.count = 7))))[0]!.message).toContain('7 elements'); // biome-ignore format: one line
    expect((await problemsOf(changedMeshopt((json) => (json.bufferViews[0].extensions.EXT_meshopt_compression.byteOffset = 500))))[0]!.path).toContain('EXT_meshopt_compression'); // biome-ignore format: one line
  });

  test('Draco: other counts than the accessors, and streams that are none', async () => {
    const changed = async (change: (json: Draft) => void, stream = model('0.bin')): Promise<readonly Problem[]> => {
      const json = jsonOf('BoxDraco.gltf');
      change(json);
      return problemsOf(new TextEncoder().encode(JSON.stringify(json)), { readFile: async () => stream });
    };
    const counts = await changed((json) => {
      const { indices } = json.meshes[0].primitives[0];
      json.accessors[indices].count = 300_000;
    });
    expect(counts[0]!.message).toContain('12 triangles');
    expect((await changed(() => {}, new Uint8Array(118)))[0]!.message).toContain('no Draco mesh');
    const spoilt = model('0.bin');
    spoilt.fill(255, 40);
    expect((await changed(() => {}, spoilt))[0]!.message).toContain('cannot be read');
  });
});

describe('at random', () => {
  /** A good file with a little of everything, by another writer. */
  async function rich(): Promise<Uint8Array> {
    const document = new Document();
    const buffer = document.createBuffer();
    const accessor = (type: 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4', array: Float32Array | Uint16Array) => document.createAccessor().setType(type).setArray(array as Float32Array<ArrayBuffer>).setBuffer(buffer); // biome-ignore format: one call
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', accessor('VEC3', Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0)))
      .setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.of(0, 0, 1, 0, 0, 1)))
      .setIndices(accessor('SCALAR', Uint16Array.of(0, 1, 2)))
      .setMaterial(document.createMaterial('red').setBaseColorFactor([1, 0, 0, 0.5]).setAlphaMode('BLEND'));
    const node = document.createNode('thing').setMesh(document.createMesh('mesh').addPrimitive(primitive));
    const sampler = document.createAnimationSampler().setInput(accessor('SCALAR', Float32Array.of(0, 1))).setOutput(accessor('VEC3', Float32Array.of(0, 0, 0, 1, 1, 1))); // biome-ignore format: one call
    document.createAnimation('go').addSampler(sampler).addChannel(document.createAnimationChannel().setTargetNode(node).setTargetPath('translation').setSampler(sampler)); // biome-ignore format: one call
    document.createScene('scene').addChild(node).addChild(document.createNode('eye').setCamera(document.createCamera().setType('perspective').setYFov(1))); // biome-ignore format: one call
    return new WebIO().writeBinary(document);
  }
  const outcome = async (bytes: Uint8Array): Promise<GltfImport> => {
    const result = await importGltf(bytes, { readFile });
    for (const { message } of result.ok ? [] : result.problems) {
      expect(message.length).toBeLessThan(2000);
      // What is thrown somewhere has no place: everything should be found before.
      expect(message).not.toContain('something that cannot be read');
    }
    return result;
  };

  test('the rich file itself is read, with nothing to tell', async () => {
    const result = await outcome(await rich());
    expect(result.ok && result.report.entries).toEqual([]);
  });

  test.each(['rich', 'BoxMeshopt.glb', 'BoxDraco.gltf', 'SimpleSkin.gltf'])(
    'bytes of %s changed, seed 81',
    async (name) => {
      const file = name === 'rich' ? await rich() : model(name);
      const random = seededRandom(81);
      for (let round = 0; round < 150; round++) {
        const bytes = file.slice();
        for (let k = Math.floor(random() * 6); k >= 0; k--)
          bytes[Math.floor(random() * bytes.length)] = random() < 0.3 ? 48 + random() * 10 : random() * 256;
        await outcome(bytes);
      }
    },
  );

  test('values of the JSON replaced by others, seed 82', async () => {
    const random = seededRandom(82);
    const WILD = [
      -1,
      0,
      1,
      2,
      7,
      1e9,
      1e300,
      0.5,
      null,
      '',
      'x',
      true,
      [],
      {},
      [0],
      [1e9],
      { 0: 1 },
      5126,
      'VEC3',
      'data:,',
    ];
    const file = await rich();
    const end = 20 + new DataView(file.buffer, file.byteOffset).getUint32(12, true);
    const binary = file.subarray(end + 8);
    for (let round = 0; round < 600; round++) {
      const json: Draft = JSON.parse(new TextDecoder().decode(file.subarray(20, end)));
      for (let k = Math.floor(random() * 2); k >= 0; k--) {
        let here: Draft = json;
        for (;;) {
          const keys = Object.keys(here);
          if (keys.length === 0) break;
          const key = keys[Math.floor(random() * keys.length)]!;
          if (typeof here[key] === 'object' && here[key] !== null && random() < 0.8) here = here[key];
          else {
            here[key] = structuredClone(WILD[Math.floor(random() * WILD.length)]);
            break;
          }
        }
      }
      await outcome(glbOf(json, binary));
    }
  });
});

test('whoever asks for it stops it', async () => {
  const stop = new AbortController();
  stop.abort(new Error('enough'));
  await expect(importGltf(triangleFile().glb(), { signal: stop.signal })).rejects.toThrow('enough');
});

const letters = (text: string): Uint8Array => new TextEncoder().encode(text);
test.each([
  [new Uint8Array(), 'an empty file'],
  [letters('version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 7\n'), 'a pointer of Git LFS'],
  [letters('\n<!DOCTYPE html>\n<title>404</title>'), 'a web page'],
])('what is no model at all is named (%#)', async (bytes, words) => {
  const [problem] = await problemsOf(bytes);
  expect(problem!.message).toContain(words);
});

test.each([
  [letters('BM......'), 'a BMP image'],
  [letters('GIF89a..'), 'a GIF image'],
  [letters(`${'.'.repeat(30)}TRUEVISION-XFILE.\0`), 'a TGA image'],
  [Uint8Array.of(0xff, 0xd8, 0xff, 0xe0, 0, 16), 'a JPEG image that is damaged or cut off'],
  [letters('.........'), 'bytes that are no image'],
])('an image that is not read is called by its name (%#)', async (bytes, words) => {
  const file = triangleFile((f) => {
    f.add('images', { bufferView: f.view(bytes), mimeType: 'image/png' });
    f.add('textures', { source: 0 });
    Object.assign(primitive(f), { material: f.add('materials', { emissiveTexture: { index: 0 } }) });
    primitive(f).attributes.TEXCOORD_0 = f.floats('VEC2', 0, 0, 1, 0, 0, 1);
  });
  const [problem] = await problemsOf(file.glb());
  expect(problem!.message).toContain(words);
});
