import { describe, expect, test } from 'vitest';
import { bendingScenes } from '../../../../tests/fixtures/bending.ts';
import { dough } from '../../../../tests/fixtures/motion.ts';
import { sahCost } from '../bvh/bvh.ts';
import type { Mesh } from '../scene/mesh.ts';
import { Motion } from '../scene/motion.ts';
import type { Scene, Vec3 } from '../scene/scene.ts';
import { mostPlanRows } from './bending.ts';
import { BentMesh } from './bent-mesh.ts';
import { decodeWideBvh } from './decode-wide-bvh.ts';
import { isLeaf, NODE_WORDS, referenceAt } from './encode-wide-bvh.ts';
import type { MeshGlow } from './lamp-clusters.ts';
import { nodeLevels } from './node-levels.ts';
import { type BodyRows, type PackedGeometry, packGeometry } from './pack-geometry.ts';
import { packMesh } from './pack-mesh.ts';
import { PosedMesh } from './posed-mesh.ts';
import { treeCost } from './tree-cost.ts';

const EYE: Vec3 = [0, 0, 9];
const ROOM = 1e6;
const rowsOf = (scene: Scene, glows: (MeshGlow | null)[] = []): BodyRows => ({ first: 0, covers: Object.keys(scene.shapes).map(() => 0), glows }); // biome-ignore format: short
const scenes = bendingScenes();
const meshesOf = (scene: Scene): Mesh[] => Object.values(scene.meshes!).map(({ data }) => data!);
const packedAt = (scene: Scene, time: number, before: PackedGeometry | null = null, room = ROOM) =>
  packGeometry(new Motion(scene).at(time), rowsOf(scene), EYE, before, room);

describe.each(Object.entries(scenes))('%s', (_, scene) => {
  test('levels have every child once, above all that are in it', () => {
    for (const mesh of meshesOf(scene)) {
      const { nodes } = packMesh(mesh);
      const { children, begins } = nodeLevels(nodes);
      const levelOf = new Map<number, number>();
      for (let level = 0; level + 1 < begins.length; level++)
        for (let i = begins[level]!; i < begins[level + 1]!; i++) levelOf.set(children[2 * i]!, level);
      expect(begins[0]).toBe(0);
      expect(2 * levelOf.size).toBe(children.length);
      for (let slot = 0; slot < (4 * nodes.length) / NODE_WORDS; slot++) {
        const reference = referenceAt(nodes, Math.floor(slot / 4), slot % 4);
        const inside = [0, 1, 2, 3].map((k) => levelOf.get(4 * reference + k) ?? -1);
        const wanted = isLeaf(reference) ? 0 : Math.max(...inside) + 1;
        expect(levelOf.get(slot)).toBe(reference === 0 ? undefined : wanted);
      }
      for (let i = 0; i < children.length; i += 2)
        expect(children[i + 1]).toBe(referenceAt(nodes, Math.floor(children[i]! / 4), children[i]! % 4));
    }
  });

  test('all of the plan finds room where it was said to, and every part has its own', () => {
    const { bending, meshes } = packedAt(scene, 0.3);
    const bent = meshes.filter((mesh) => mesh instanceof BentMesh);
    expect(bent.length).toBe(Object.keys(scene.shapes).length);
    expect(bending!.planRows).toBeLessThanOrEqual(mostPlanRows(bent.map(({ mesh }) => mesh)));
    let end = 0;
    for (const { row, words } of bending!.parts) {
      expect(row).toBe(end);
      end += Math.ceil(words.length / 4);
    }
    expect(end).toBe(bending!.planRows);
  });

  test('boxes of instances hold the meshes that they would have here', () => {
    for (const time of [0, 0.4, 3.7]) {
      const [there, here] = [packedAt(scene, time), packedAt(scene, time, null, 0)];
      here.meshes.forEach((mesh, i) => {
        const [box, wanted] = [(there.meshes[i] as BentMesh).box, (mesh as PosedMesh).box];
        for (let k = 0; k < 3; k++) {
          expect(box[k]).toBeLessThanOrEqual(wanted[k]!);
          expect(box[k + 3]).toBeGreaterThanOrEqual(wanted[k + 3]!);
        }
      });
    }
  });
});

test('the cost of a packed tree grows and shrinks with that of the tree which it was made of', () => {
  const ratios = meshesOf(scenes.large!).map((mesh) => {
    const { nodes, order } = packMesh(mesh);
    const posed = new PosedMesh(mesh);
    expect(decodeWideBvh(nodes, order).bvh.nodeCount).toBe(posed.bvh.nodeCount);
    return treeCost(nodes) / sahCost(posed.bvh);
  });
  // Nodes that wide ones leave out are not counted.
  for (const ratio of ratios) expect(ratio).toSatisfy((x: number) => x > 0.3 && x < 1);
});

test('a pose is written when it is another one, and only then', () => {
  const scene = scenes.even!;
  const motion = new Motion(scene);
  let geometry: PackedGeometry | null = null;
  const revisions = [0, 0, 1, 1, 0].map((time) => {
    geometry = packGeometry(motion.at(time), rowsOf(scene), EYE, geometry, ROOM);
    return geometry.bending!.revision;
  });
  expect(revisions).toEqual([1, 1, 2, 2, 3]);
});

test('meshes that shine, and those that the device has no room for, are bent here', () => {
  const scene = scenes.even!;
  const motion = new Motion(scene);
  const kinds = ({ meshes }: PackedGeometry) => meshes.map((mesh) => mesh.constructor);
  const glow: MeshGlow = { instances: 1, clusters: 1, bits: 20, triangles: 9, radiance: [1, 1, 1], oneSided: false, texture: null, mayBeMissing: false }; // biome-ignore format: one thought
  const dark = packGeometry(motion.at(0), rowsOf(scene), EYE, null, ROOM);
  expect(new Set(kinds(dark))).toEqual(new Set([BentMesh]));
  const { bending } = dark;
  const lit = packGeometry(motion.at(0), rowsOf(scene, [null, glow]), EYE, dark, ROOM);
  expect(lit).toBe(dark);
  expect(kinds(lit)).toEqual([BentMesh, PosedMesh, BentMesh, BentMesh]);
  expect(lit.bending).not.toBe(bending);
  expect(lit.emitters.length).toBe(1);
  const again = packGeometry(motion.at(0), rowsOf(scene), EYE, lit, ROOM);
  expect(new Set(kinds(again))).toEqual(new Set([BentMesh]));
  expect(packedAt(scene, 0, null, mostPlanRows(meshesOf(scene)) / 2).bending).toBeNull();
});

test('a tree that the device finds twice as costly is replaced on the way, by one that stays', () => {
  const base = dough(16, 8);
  const [[name, { data }]] = Object.entries(base.meshes!) as [[string, { data: Mesh }]];
  // All triangles begin at one place, where no tree is better than another.
  const folded = { ...data, positions: new Float32Array(data.positions.length) };
  const morphTargets = [{ positions: data.positions }, { positions: data.positions.map((x, i) => (i % 3 === 1 ? x : 0)) }]; // biome-ignore format: one thought
  const scene = { ...base, meshes: { [name]: { data: { ...folded, morphTargets } } } };
  const motion = new Motion(scene);
  let geometry: PackedGeometry | null = null;
  const meshes: unknown[] = [];
  for (let frame = 0; frame < 40; frame++) {
    const moment = motion.at(0.5 + frame / 60);
    geometry = packGeometry(moment, rowsOf(scene), EYE, geometry, ROOM);
    // What the device would find, as the mesh bent here tells.
    const first = geometry.meshes[0] as BentMesh;
    const here = new PosedMesh(first.mesh, { ...first });
    here.pose(first.body);
    geometry.bending!.weighed([treeCost(here.nodes)]);
    meshes.push(first);
  }
  expect(new Set(meshes).size).toBe(2);
  expect(new Set(meshes.slice(20)).size).toBe(1);
});
