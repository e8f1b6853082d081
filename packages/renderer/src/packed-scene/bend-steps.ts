/**
 * Which workgroups bend meshes, and what each does: one entry of bend.wesl after the other, for all meshes together. High levels of a tree
 * have few nodes, and one workgroup goes through them all by itself: a step of its own for each would leave the device idle in between. A small mesh
 * is the work of one workgroup altogether.
 */
import { vertexCount } from '../scene/mesh.ts';
import { MANY_THREADS, SHARE_WORD, SHARE_WORDS, THREADS } from './bent-layout.ts';
import type { BentMesh } from './bent-mesh.ts';

/** Workgroups of one entry, one behind the other. */
export interface BendStep {
  readonly entry: 'bendMesh' | 'bendVertices' | 'fitLeaves' | 'fitLevel' | 'fitLevels' | 'weighTree';
  /** Word of the plan with the share of the first. */
  readonly first: number;
  readonly groups: number;
}

interface Share {
  readonly mesh: number;
  readonly first: number;
  readonly end: number;
}

/** Children in the largest level that one workgroup does beside others: each thread has four. */
const MOST_AT_ONCE = 4 * MANY_THREADS;

/** Vertices of a mesh that one workgroup bends alone, which saves steps. */
const MOST_IN_SMALL = 2048;
const isSmall = (bent: BentMesh): boolean => vertexCount(bent.mesh) <= MOST_IN_SMALL && largeLevels(bent) === 0;

/** A range cut for workgroups of THREADS. */
function cut(mesh: number, begin: number, end: number): Share[] {
  const count = Math.ceil((end - begin) / THREADS);
  return Array.from({ length: count }, (_, i) => ({ mesh, first: begin + i * THREADS, end }));
}

/** Levels, leaves not among them, that are too large for one workgroup; some above these may be small and count too. */
function largeLevels({ levels: { begins } }: BentMesh): number {
  let count = 0;
  for (let level = 1; level + 1 < begins.length; level++)
    if (begins[level + 1]! - begins[level]! > MOST_AT_ONCE) count = level;
  return count;
}

/** `recordOf`: word of the plan that has a mesh's record; shares lie behind all of them. */
export function bendSteps(meshes: readonly BentMesh[], recordOf: (mesh: number) => number) {
  const large = (of: (mesh: BentMesh, i: number) => Share[]) =>
    meshes.flatMap((mesh, i) => (isSmall(mesh) ? [] : of(mesh, i)));
  const small = meshes.flatMap((mesh, i) =>
    isSmall(mesh) ? [{ mesh: i, first: 0, end: mesh.levels.begins.length }] : [],
  );
  const deepest = meshes.reduce((most, mesh) => Math.max(most, largeLevels(mesh)), 0);
  const level = (k: number) => (mesh: BentMesh, i: number) => {
    const { begins } = mesh.levels;
    return k <= largeLevels(mesh) ? cut(i, begins[k]!, begins[k + 1]!) : [];
  };
  const lists: [BendStep['entry'], Share[]][] = [
    ['bendMesh', small],
    ['bendVertices', large(({ mesh }, i) => cut(i, 0, vertexCount(mesh)))],
    ['fitLeaves', large(level(0))],
    ...Array.from({ length: deepest }, (_, k): [BendStep['entry'], Share[]] => ['fitLevel', large(level(k + 1))]),
    ['fitLevels', large((mesh, i) => rest(mesh, i))],
    ['weighTree', meshes.map((_, mesh) => ({ mesh, first: 0, end: 1 }))],
  ];
  const shares = new Uint32Array(lists.reduce((sum, [, list]) => sum + list.length, 0) * SHARE_WORDS);
  let at = 0;
  const steps = lists.map(([entry, list]): BendStep => {
    const first = recordOf(meshes.length) + at;
    for (const share of list) {
      shares[at + SHARE_WORD.mesh] = recordOf(share.mesh);
      shares[at + SHARE_WORD.first] = share.first;
      shares[at + SHARE_WORD.end] = share.end;
      at += SHARE_WORDS;
    }
    return { entry, first, groups: list.length };
  });
  const weighing = steps.pop()!;
  return { shares, steps: steps.filter(({ groups }) => groups > 0), weighing };
}

/** The levels that are left, for one workgroup. */
function rest(mesh: BentMesh, i: number): Share[] {
  const [first, end] = [largeLevels(mesh) + 1, mesh.levels.begins.length - 1];
  return first < end ? [{ mesh: i, first, end }] : [];
}
