import { describe, expect, test } from 'vitest';
import { arm, carousel, dough, swarm } from '../../../../tests/fixtures/motion.ts';
import { between, randomDirection, seededRandom } from '../../../../tests/fixtures/random.ts';
import { wideSource } from '../../../../tests/fixtures/wide-source.ts';
import { type NodeSource, roomForChildren } from '../bvh/trace/node-source.ts';
import { closestByBruteForce, closestHit } from '../bvh/trace/trace.ts';
import { AFFINE_LENGTH, transformPoint } from '../scene/affine.ts';
import type { Mesh } from '../scene/mesh.ts';
import { Motion } from '../scene/motion.ts';
import { meshMatrices, meshShapes } from '../scene/placed.ts';
import { posedSceneAt } from '../scene/posed.ts';
import type { Scene, Vec3 } from '../scene/scene.ts';
import { fieldOffset, GEOMETRY_ROW, geometryRows, structSize } from './layout.ts';
import { type BodyRows, type PackedGeometry, packGeometry } from './pack-geometry.ts';
import { packVertices } from './pack-vertices.ts';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

const rowsFrom = (first: number): BodyRows => ({ first, covers: new Array<number>(40).fill(0), glows: [] });

interface Wanted {
  readonly mesh: Mesh;
  readonly matrix: Float64Array;
}
/** What should be there, from plain data that knows nothing of frames. */
function instancesAt(scene: Scene, time: number): Wanted[] {
  const posed = posedSceneAt(scene, time);
  return meshShapes(posed).flatMap(([, shape]) => {
    const matrices = meshMatrices(shape, IDENTITY);
    return Array.from({ length: matrices.length / AFFINE_LENGTH }, (_, i) => ({
      mesh: posed.meshes![shape.mesh]!.data!,
      matrix: matrices.subarray(12 * i, 12 * i + 12),
    }));
  });
}

/** All words as the device gets them. */
function wordsOf({ moving, movingRows, meshes, rows }: PackedGeometry): Uint32Array<ArrayBuffer> {
  const all = new Uint32Array(rows * GEOMETRY_ROW);
  all.set(moving.u32);
  let at = movingRows * GEOMETRY_ROW;
  for (const { nodes, triangles, vertices } of meshes)
    for (const words of [nodes, triangles, vertices.words]) {
      all.set(words, at);
      at += words.length;
    }
  return all;
}

const fieldAt = (words: Uint32Array, row: number, field: Parameters<typeof fieldOffset<'Instance'>>[1]): number =>
  words[row * GEOMETRY_ROW + fieldOffset('Instance', field) / 4]!;

/** Throws when what is below a child of a node leaves the child's box; gives what is below. */
function checkBoxes(
  source: NodeSource,
  node: number,
  pointsOf: (primitive: number) => Vec3[],
  slack: number,
): number[] {
  const children = roomForChildren();
  source.readChildren(node, children);
  return Array.from({ length: children.count }, (_, i) => {
    const [count, index] = [children.primitives[i]!, children.index[i]!];
    const bounds = children.bounds.slice(6 * i, 6 * i + 6);
    const below =
      count > 0
        ? Array.from({ length: count }, (_, k) => source.order[index + k]!)
        : checkBoxes(source, index, pointsOf, slack);
    for (const primitive of below)
      for (const point of pointsOf(primitive))
        point.forEach((x, axis) => {
          if (x < bounds[axis]! - slack || x > bounds[axis + 3]! + slack)
            expect.fail(`${x} is outside of ${bounds[axis]} … ${bounds[axis + 3]}`);
        });
    return below;
  }).flat();
}

const pointAt = (mesh: Mesh, vertex: number): Vec3 =>
  [...mesh.positions.subarray(3 * vertex, 3 * vertex + 3)] as unknown as Vec3;
const cornersOf = (mesh: Mesh, triangle: number): Vec3[] =>
  [0, 1, 2].map((corner) => pointAt(mesh, mesh.indices[3 * triangle + corner]!));

/** Everything that a kernel reads, held against what should be there. */
function check(scene: Scene, time: number, eye: Vec3, geometry: PackedGeometry): void {
  const wanted = instancesAt(scene, time);
  const words = wordsOf(geometry);
  const floats = new Float32Array(words.buffer);
  expect(geometry.instanceCount).toBe(wanted.length);
  const numbers = Uint32Array.from(wanted, (_, i) => i);
  const inWorld = wanted.map(({ mesh, matrix }) =>
    Array.from({ length: mesh.positions.length / 3 }, (_, v) => {
      const [x, y, z] = transformPoint(matrix, 0, pointAt(mesh, v));
      return [x - eye[0], y - eye[1], z - eye[2]] as const;
    }),
  );
  // Kernels go down no tree over one instance.
  if (wanted.length > 1) {
    const tree = wideSource(words, numbers, 64);
    const found = checkBoxes(tree, 0, (instance) => inWorld[instance]! as Vec3[], 1e-5);
    expect(found.sort((a, b) => a - b)).toEqual([...numbers]);
  }
  const checked = new Set<number>();
  wanted.forEach(({ mesh }, i) => {
    const row = geometry.instances + i * geometryRows('Instance');
    // Each of some vertices goes back into the mesh.
    for (let v = 0; v < mesh.positions.length / 3; v += 7)
      pointAt(mesh, v).forEach((wantedPlace, axis) => {
        const at = row * GEOMETRY_ROW + axis * 4;
        const [x, y, z] = inWorld[i]![v]!;
        const place = floats[at]! * x + floats[at + 1]! * y + floats[at + 2]! * z + floats[at + 3]!;
        expect(Math.abs(place - wantedPlace)).toBeLessThan(1e-4);
      });
    const nodes = fieldAt(words, row, 'nodes');
    if (checked.has(nodes)) return;
    checked.add(nodes);
    checkMesh(mesh, words, nodes, fieldAt(words, row, 'triangles'), fieldAt(words, row, 'vertices'));
  });
}

function checkMesh(
  mesh: Mesh,
  words: Uint32Array<ArrayBuffer>,
  nodes: number,
  triangles: number,
  vertices: number,
): void {
  const floats = new Float32Array(words.buffer);
  const count = mesh.indices.length / 3;
  const corner = (place: number, field: 'a' | 'b' | 'c'): number[] => {
    const at = triangles * GEOMETRY_ROW + (place * structSize('Triangle') + fieldOffset('Triangle', field)) / 4;
    return [...floats.subarray(at, at + 3)];
  };
  // Which triangle of the mesh stands at a place: the one that it is equal to.
  const key = (corners: readonly (readonly number[])[]) => corners.flat().join(' ');
  const numberOf = new Map(Array.from({ length: count }, (_, t) => [key(cornersOf(mesh, t)), t]));
  const order = Uint32Array.from({ length: count }, (_, place) => {
    const triangle = numberOf.get(key([corner(place, 'a'), corner(place, 'b'), corner(place, 'c')]));
    if (triangle === undefined) expect.fail(`no triangle of the mesh is at place ${place}`);
    return triangle;
  });
  expect(new Set(order).size).toBe(numberOf.size);
  const source = wideSource(words.subarray(nodes * GEOMETRY_ROW) as Uint32Array<ArrayBuffer>, order, 64);
  checkBoxes(source, 0, (triangle) => cornersOf(mesh, triangle), 0);
  const packed = packVertices(mesh);
  const at = vertices * GEOMETRY_ROW;
  expect(words.subarray(at, at + packed.words.length)).toEqual(packed.words);
  const rays = seededRandom(95);
  for (let k = 0; k < 20; k++) {
    const direction = [...randomDirection(rays)] as [number, number, number];
    const middle = cornersOf(mesh, Math.floor(rays() * count))[0]!;
    const origin = middle.map((x, axis) => x - 9 * direction[axis]! + between(rays, -0.1, 0.1)) as [
      number,
      number,
      number,
    ];
    const ray = { origin, direction, tMin: 0, tMax: Number.POSITIVE_INFINITY };
    expect(closestHit(source, mesh, ray)).toEqual(closestByBruteForce(mesh, ray));
  }
}

const scenes = {
  swarm: swarm(seededRandom(1), 40),
  carousel: carousel(seededRandom(2), 30),
  arm: arm(16, 8),
  dough: dough(16, 8),
};

describe.each(Object.entries(scenes))('%s', (_, scene) => {
  test('played in any order, all words are what brute force says (seed 94)', () => {
    const random = seededRandom(94);
    const motion = new Motion(scene);
    let geometry: PackedGeometry | null = null;
    for (const time of [0, 0, between(random, 0, 4), between(random, -2, 9), 1, 0]) {
      for (const eye of [
        [0, 0, 10],
        [0, 0, 10],
        [3, 2, 1],
      ] as Vec3[]) {
        geometry = packGeometry(motion.at(time), rowsFrom(5), eye, geometry);
        check(scene, time, eye, geometry);
      }
    }
  });

  test('meshes and instances at a time are the same words whatever was shown before', () => {
    const eye: Vec3 = [1, 2, 3];
    const motion = new Motion(scene);
    let played = packGeometry(motion.at(0), rowsFrom(0), eye);
    for (const time of [0.3, 0.6, 2.2, 1.5]) played = packGeometry(motion.at(time), rowsFrom(0), eye, played);
    const direct = packGeometry(new Motion(scene).at(1.5), rowsFrom(0), eye);
    const after = (geometry: PackedGeometry) => wordsOf(geometry).subarray(geometry.instances * GEOMETRY_ROW);
    expect(after(played)).toEqual(after(direct));
  });

  test('arrays are kept from frame to frame', () => {
    const motion = new Motion(scene);
    const first = packGeometry(motion.at(0), rowsFrom(0), [0, 0, 9]);
    const { moving, meshes } = first;
    const words = meshes.map(({ nodes, triangles, vertices }) => [nodes, triangles, vertices.words]);
    const next = packGeometry(motion.at(1), rowsFrom(0), [0, 0, 9], first);
    expect(next).toBe(first);
    expect(next.moving).toBe(moving);
    const kept = next.meshes.map((mesh, i) => mesh.nodes === words[i]![0] && mesh.triangles === words[i]![1]);
    expect(kept).toEqual(kept.map(() => true));
    expect(next.meshes.every((mesh, i) => mesh.vertices.words === words[i]![2])).toBe(true);
  });
});

test('only instances that have moved are written', () => {
  const { swarm: scene } = scenes;
  const { clips } = scene;
  const tracks = clips!.play!.tracks.filter(({ target }) => /node (7|9)\//.test(target));
  const motion = new Motion({ ...scene, clips: { play: { ...clips!.play!, tracks } } });
  const eye: Vec3 = [0, 0, 9];
  const geometry = packGeometry(motion.at(0), rowsFrom(0), eye);
  const row = (instance: number) => geometry.instances + instance * geometryRows('Instance');
  const { revision } = geometry;
  packGeometry(motion.at(0), rowsFrom(0), eye, geometry);
  expect(geometry.revision).toBe(revision);
  packGeometry(motion.at(0.7), rowsFrom(0), eye, geometry);
  expect(geometry.changedInstances).toEqual([row(7), row(10)]);
  packGeometry(motion.at(0.7), rowsFrom(0), [0, 0, 8], geometry);
  expect(geometry.changedInstances).toEqual([row(0), row(40)]);
});

test('a tree follows instances that move, until it has become a worse one', () => {
  const { swarm: base } = scenes;
  const homes = Object.values(base.nodes!).map(({ translation }) => translation!);
  // Each goes straight to another one's place.
  const tracks = homes.map((home, i) => ({
    target: `/nodes/node ${i}/translation`,
    interpolation: 'linear' as const,
    times: Float32Array.of(0, 4),
    values: Float32Array.of(...home, ...homes[(i * 7 + 3) % homes.length]!),
  }));
  const scene = { ...base, clips: { play: { duration: 4, tracks } } };
  const motion = new Motion(scene);
  const eye: Vec3 = [0, 0, 9];
  let geometry: PackedGeometry | null = null;
  let trees = 0;
  let links = '';
  for (let frame = 0; frame < 60; frame++) {
    geometry = packGeometry(motion.at(frame / 15), rowsFrom(0), eye, geometry);
    const { moving, treeRows } = geometry;
    const nodes = moving.u32.subarray(0, treeRows * GEOMETRY_ROW);
    const words = structSize('WideNode') / 4;
    const now = nodes.filter((_, i) => i % words >= fieldOffset('WideNode', 'children') / 4).join(' ');
    if (now !== links) trees++;
    links = now;
    if (frame % 6 === 5) check(scene, frame / 15, eye, geometry);
  }
  expect(trees).toBeGreaterThan(1);
  expect(trees).toBeLessThan(20);
});

test('what is scaled to nothing is not there, and comes back', () => {
  const { swarm: scene } = scenes;
  const times = Float32Array.of(0, 1, 2);
  const values = Float32Array.of(1, 1, 1, 0, 0, 0, 1, 1, 1);
  const track = { target: '/nodes/node 3/scale', interpolation: 'linear', times, values } as const;
  const clips = { play: { duration: 2, tracks: [track] } };
  const motion = new Motion({ ...scene, clips });
  let geometry: PackedGeometry | null = null;
  const counts = [0, 0.5, 1, 1.5].map((time) => {
    geometry = packGeometry(motion.at(time), rowsFrom(0), [0, 0, 9], geometry);
    return geometry.instanceCount;
  });
  expect(counts).toEqual([40, 40, 39, 40]);
  check({ ...scene, clips }, 1.5, [0, 0, 9], geometry!);
});

test('another scene gets a geometry of its own; what meshes are made of may change', () => {
  const { swarm: scene } = scenes;
  const [a, b] = [new Motion(scene).at(0), new Motion({ ...scene }).at(0)];
  const first = packGeometry(a, rowsFrom(0), [0, 0, 9]);
  expect(packGeometry(b, rowsFrom(0), [0, 0, 9], first)).not.toBe(first);
  const { revision } = first;
  const covers = rowsFrom(3).covers.map((_, i) => (i === 8 ? 5 : 0));
  expect(packGeometry(a, { first: 3, covers, glows: [] }, [0, 0, 9], first)).toBe(first);
  expect(first.revision).toBe(revision + 1);
  const words = wordsOf(first);
  const row = (i: number) => first.instances + i * geometryRows('Instance');
  expect([7, 8].map((i) => [fieldAt(words, row(i), 'row'), fieldAt(words, row(i), 'cover')])).toEqual([
    [10, 0],
    [11, 5],
  ]);
});

/** All triangles begin at one place, where no tree is better than another. */
function unfolding(): Scene {
  const { dough: scene } = scenes;
  const [[name, { data }]] = Object.entries(scene.meshes!) as [[string, { data: Mesh }]];
  const folded = { ...data, positions: new Float32Array(data.positions.length) };
  const morphTargets = [
    { positions: data.positions },
    { positions: data.positions.map((x, i) => (i % 3 === 1 ? x : 0)) },
  ];
  return { ...scene, meshes: { [name]: { data: { ...folded, morphTargets } } } };
}

test('a tree that has become a bad one is replaced on the way, by one that stays', () => {
  const scene = unfolding();
  const motion = new Motion(scene);
  const eye: Vec3 = [0, 0, 9];
  let geometry: PackedGeometry | null = null;
  const meshes: unknown[] = [];
  for (let frame = 0; frame < 40; frame++) {
    const time = 0.5 + frame / 60;
    geometry = packGeometry(motion.at(time), rowsFrom(0), eye, geometry);
    meshes.push(geometry.meshes[0]);
    if (frame % 8 === 7) check(scene, time, eye, geometry);
  }
  expect(new Set(meshes).size).toBe(2);
  expect(new Set(meshes.slice(20)).size).toBe(1);
});

test('meshes that bend without being torn keep the trees that they have', () => {
  for (const scene of [scenes.arm, scenes.dough]) {
    const motion = new Motion(scene);
    const geometry = packGeometry(motion.at(0), rowsFrom(0), [0, 0, 9]);
    const [mesh] = geometry.meshes;
    for (let frame = 0; frame < 60; frame++) packGeometry(motion.at(frame / 15), rowsFrom(0), [0, 0, 9], geometry);
    expect(geometry.meshes[0]).toBe(mesh);
  }
});
