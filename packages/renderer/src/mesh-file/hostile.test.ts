/** Files that are cut off or changed: problems or meshes that keep all rules, and nothing else. */
import { expect, test } from 'vitest';
import { displacedSphere } from '../../../../tests/fixtures/meshes/landscapes.ts';
import { PLY_FORMS, plyColumns, plyFile } from '../../../../tests/fixtures/meshes/ply-files.ts';
import { cubeMesh } from '../../../../tests/fixtures/meshes/solids.ts';
import { stlBinary, stlText } from '../../../../tests/fixtures/meshes/stl-files.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import type { Mesh } from '../scene/mesh.ts';
import { meshFault } from '../scene/mesh-fault.ts';
import { parseScene } from '../scene-file/parse-scene.ts';
import { MOST_FILE_PROBLEMS } from './file-problems.ts';
import { readMeshFile } from './mesh-file.ts';
import { readMtl } from './obj/read-mtl.ts';
import { writePly } from './ply/write-ply.ts';

const encode = (text: string) => new TextEncoder().encode(text);
const ball = displacedSphere({ triangles: 60 });
const cube = cubeMesh();
const quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]; // biome-ignore format: short
const plyTables = [
  { name: 'vertex', columns: [...plyColumns(['x', 'y', 'z'], 'f32', cube.positions), ...plyColumns(['red', 'green', 'blue'], 'u8', new Array(24).fill(200))] },
  { name: 'face', columns: [{ name: 'vertex_indices', count: 'u8' as const, type: 'i32' as const, rows: quads }] },
]; // biome-ignore format: short

function objText({ positions, normals, indices }: Mesh): string {
  const lines = (word: string, numbers: Float32Array) =>
    Array.from({ length: numbers.length / 3 }, (_, k) => `${word} ${numbers.subarray(3 * k, 3 * k + 3).join(' ')}\n`);
  const corner = (k: number) => `${indices[k]! + 1}//${indices[k]! + 1}`;
  const faces = Array.from({ length: indices.length / 3 }, (_, k) =>
    `${k % 5 === 0 ? `usemtl m${k % 3}\ns ${k % 2}\n` : ''}f ${corner(3 * k)} ${corner(3 * k + 1)} ${corner(3 * k + 2)}\n`); // biome-ignore format: short
  return `mtllib a.mtl\n${lines('v', positions).join('')}${lines('vn', normals!).join('')}${faces.join('')}`;
}

interface Subject {
  readonly name: string;
  readonly file: Uint8Array;
  /** Whether any beginning of it lacks something that can be seen. */
  readonly hasEnd: boolean;
}
const SUBJECTS: Subject[] = [
  ...PLY_FORMS.map((form) => ({ name: `${form}.ply`, file: plyFile(form, plyTables), hasEnd: form !== 'ascii' })),
  { name: 'written.ply', file: writePly(ball), hasEnd: true },
  { name: 'text.stl', file: stlText(cube), hasEnd: true },
  { name: 'bytes.stl', file: stlBinary(ball), hasEnd: true },
  { name: 'ball.obj', file: encode(objText(ball)), hasEnd: false },
];

/** "problems", or "meshes", or what is wrong with them. Plain conditions: it is asked a hundred thousand times. */
function outcomeOf(name: string, bytes: Uint8Array): string {
  const file = readMeshFile(bytes, name);
  if (file.ok) {
    for (const { mesh } of file.parts) {
      const fault = meshFault(mesh);
      if (fault !== null) return `meshes with a fault: ${JSON.stringify(fault)}`;
      // Nothing is larger than what the bytes can tell of: a vertex takes a byte or more.
      const numbers = mesh.positions.length + mesh.indices.length;
      if (!(numbers <= 9 * bytes.length)) return `${numbers} numbers of ${bytes.length} bytes`;
    }
    return 'meshes';
  }
  const count = file.problems.length;
  if (!(count > 0 && count <= MOST_FILE_PROBLEMS + 1)) return `${count} problems in a list`;
  const strange = file.problems.find(({ message }) => !(message.length < 500 && /\.$/.test(message)) || message.includes('memory')); // biome-ignore format: one question
  return strange ? `a problem that says ${JSON.stringify(strange.message)}` : 'problems';
}

/** Anything but "problems" or "meshes" fails the test. */
function outcome(name: string, bytes: Uint8Array): string {
  const found = outcomeOf(name, bytes);
  if (found !== 'problems' && found !== 'meshes') expect.unreachable(`${name}: ${found}`);
  return found;
}

test.each(SUBJECTS)('$name: cut off after each of its bytes', ({ name, file, hasEnd }) => {
  expect(outcome(name, file)).toBe('meshes');
  const whole =
    name.endsWith('.stl') && name.startsWith('text')
      ? encode(new TextDecoder().decode(file).trimEnd()).length - 5
      : file.length;
  for (let length = 0; length < file.length; length++) {
    const found = outcome(name, file.subarray(0, length));
    if (hasEnd && length < whole && found !== 'problems') expect(`${length} ${found}`).toBe(`${length} problems`);
  }
});

test.each(SUBJECTS)('$name: bytes changed at random (seed 81)', ({ name, file }) => {
  const random = seededRandom(81);
  for (let round = 0; round < 1500; round++) {
    const bytes = file.slice();
    const reach = round % 2 ? file.length : Math.min(file.length, 250); // heads are where mistakes hurt
    for (let k = Math.floor(random() * 4); k >= 0; k--)
      bytes[Math.floor(random() * reach)] = random() < 0.3 ? 255 : random() * 256;
    outcome(name, bytes);
  }
});

test.each(SUBJECTS)('$name: digits changed, so that counts and numbers are others (seed 82)', ({ name, file }) => {
  const random = seededRandom(82);
  const digits = [...file.keys()].filter((k) => file[k]! >= 48 && file[k]! <= 57);
  for (let round = 0; round < 800; round++) {
    const bytes = file.slice();
    for (let k = 0; k < 3; k++) bytes[digits[Math.floor(random() * digits.length)]!] = 48 + random() * 10;
    outcome(name, bytes);
  }
});

test.each(SUBJECTS)('$name: its beginning, then noise, and pieces of it twice (seed 83)', ({ name, file }) => {
  const random = seededRandom(83);
  for (let round = 0; round < 200; round++) {
    const kept = Math.floor(random() * file.length);
    outcome(name, file.map((byte, i) => (i < kept ? byte : random() * 256))); // biome-ignore format: one call
    const from = Math.floor(random() * file.length);
    outcome(name, Uint8Array.of(...file.subarray(0, kept), ...file.subarray(from)));
  }
});

test('what no reader knows, by name or by what is in it', () => {
  for (const name of ['a.ply', 'a.obj', 'a.stl', 'a', 'a.fbx', '']) {
    expect(outcome(name, new Uint8Array())).toBe('problems');
    expect(outcome(name, new Uint8Array(5000))).toBe('problems');
    expect(outcome(name, encode('<!doctype html><title>404</title>'))).toBe('problems');
  }
});

const MTL = encode('newmtl a\nKd 0.5 0.25 0.1\nKs 0.5 0.5 0.5\nNs 100\nd 1\nillum 2\nnewmtl b\nPr 0.3\nPm 1\nKe 1 2 3\nNi 1.5\nTf 1 1 1\nmap_Kd -s 1 1 1 a.png\nmap_d b.png\nbump -bm 0.5 -mm 0 1 -clamp on c.png\nmap_Pm -imfchan r d.png\n'); // biome-ignore format: long
test('materials, cut off and changed: what is read of them a scene can have (seed 84)', () => {
  const random = seededRandom(84);
  const camera = { eye: [0, 0, 5], target: [0, 0, 0] };
  const lights = { lamp: { type: 'sphere', center: [0, 0, 0], radius: 1, radiance: 1 } };
  let good = 0;
  for (let round = 0; round < 2000; round++) {
    const bytes = round < MTL.length ? MTL.slice(0, round) : MTL.slice();
    if (round >= MTL.length)
      for (let k = 0; k < 3; k++)
        bytes[Math.floor(random() * MTL.length)] = random() < 0.7 ? 45 + random() * 13 : random() * 256;
    const file = readMtl(bytes, 'a.mtl');
    if (!file.ok) continue;
    good++;
    // Names are the file's; what a scene may call its materials is another matter.
    const materials = Object.fromEntries(Object.values(file.materials).map((material, k) => [`m${k}`, material]));
    const images = Object.fromEntries(Object.keys(file.images).map((name) => [name, { file: 'a.png' }]));
    const { textures } = file;
    const scene = { version: 1, name: 'm', camera, lights, materials, textures, images };
    expect(parseScene(scene)).toMatchObject({ ok: true });
  }
  expect(good).toBeGreaterThan(200);
});
