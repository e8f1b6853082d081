/**
 * What a device is told that bends meshes, as bent-layout.ts has it: a plan when the meshes come in, poses for each frame, and in which steps
 * it goes about it.
 */
import { keepsAngles, type Pose } from '../scene/deform.ts';
import { type Mesh, vertexCount } from '../scene/mesh.ts';
import { type BendStep, bendSteps } from './bend-steps.ts';
import { MESH_WORD, MESH_WORDS, NONE, POSE_WORD, POSE_WORDS } from './bent-layout.ts';
import type { BentMesh } from './bent-mesh.ts';
import { NODE_WORDS, PADDING, WIDTH } from './encode-wide-bvh.ts';
import { GEOMETRY_ROW } from './layout.ts';
import { type Block, createBlock } from './write-struct.ts';

type Words = Uint32Array<ArrayBuffer>;

/** A mesh, and the row of the geometry where it begins. */
export interface PlacedBent {
  readonly mesh: BentMesh;
  readonly row: number;
}

/** Words that go into the plan at a row. */
export interface PlanPart {
  readonly row: number;
  readonly words: Words;
}

const roundUp = (count: number, to: number): number => Math.ceil(count / to) * to;

/** The same memory, or a copy where it does not begin at a whole word. */
function wordsOf(numbers: Float32Array | Uint16Array | Uint32Array): Words {
  const { buffer, byteOffset, byteLength } = numbers.byteOffset % 4 === 0 ? numbers : numbers.slice();
  return new Uint32Array(buffer as ArrayBuffer, byteOffset, byteLength / 4);
}

/** Arrays laid behind one another; the same one only once. */
class Layout {
  readonly parts: PlanPart[] = [];
  #end: number;
  readonly #places = new Map<object, number>();

  constructor(firstWord: number) {
    this.#end = firstWord;
  }
  get rows(): number {
    return this.#end / GEOMETRY_ROW;
  }

  /** Its first word. */
  place(numbers: Float32Array | Uint16Array | Uint32Array | undefined): number {
    if (!numbers) return NONE;
    let at = this.#places.get(numbers);
    if (at !== undefined) return at;
    at = this.#end;
    this.#places.set(numbers, at);
    this.parts.push({ row: at / GEOMETRY_ROW, words: wordsOf(numbers) });
    this.#end += roundUp(this.parts.at(-1)!.words.length, GEOMETRY_ROW);
    return at;
  }
}

/** Numbers of a mesh's parts that the plan holds, beside records and shares; what meshes share counts each time. */
const restWords = ({ positions, normals, tangents, skin, morphTargets = [] }: Mesh): number =>
  [positions, normals, tangents, skin?.joints, skin?.weights, ...morphTargets.flatMap(Object.values)].reduce(
    (sum: number, numbers: Float32Array | undefined) => sum + roundUp(numbers?.length ?? 0, GEOMETRY_ROW),
    0,
  );

/** Rows that the plan of these meshes needs at most. */
export function mostPlanRows(meshes: readonly Mesh[]): number {
  // A triangle has a leaf at most, and there are fewer inner nodes than leaves; shares are fewer words than vertices and corners; a record,
  // and what fills up rows, is little.
  const each = (mesh: Mesh) => restWords(mesh) + vertexCount(mesh) + 3 * mesh.indices.length + 3 * targetsOf(mesh).length + 256; // biome-ignore format: a sum
  return meshes.reduce((sum, mesh) => sum + each(mesh), 0) / GEOMETRY_ROW;
}

/** Words from the start of a pose to its pairs, and to its matrices: whole rows. */
const firstPairs = (pose: number): number => pose + roundUp(POSE_WORDS, GEOMETRY_ROW);
const firstMatrix = (pose: number, targets: number): number => firstPairs(pose) + roundUp(2 * targets, GEOMETRY_ROW);

export class Bending {
  /** What the plan holds, and in how many rows. */
  readonly parts: readonly PlanPart[];
  readonly planRows: number;
  /** Room for the bent vertices, and for what the trees cost: `costRow` and the rows behind it. */
  readonly placeRows: number;
  readonly costRow: number;
  readonly poses: Block;
  /** Grows when `poses` is written anew. */
  revision = 0;
  /** In this order. */
  readonly steps: readonly BendStep[];
  readonly weighing: BendStep;
  readonly #meshes: readonly BentMesh[];
  /** Word of each mesh's pose, and the revision that it was written of. */
  readonly #poses: readonly number[];
  readonly #written: number[];

  constructor(placed: readonly PlacedBent[]) {
    this.#meshes = placed.map(({ mesh }) => mesh);
    this.#written = placed.map(() => -1);
    const [poses, poseWords] = endToEnd(this.#meshes, poseLength);
    this.#poses = poses;
    this.poses = createBlock(4 * roundUp(poseWords, GEOMETRY_ROW));
    const [places, placeWords] = endToEnd(this.#meshes, ({ mesh }) => mesh.positions.length);
    this.costRow = Math.ceil(placeWords / GEOMETRY_ROW);
    this.placeRows = this.costRow + Math.ceil(placed.length / GEOMETRY_ROW);
    const { shares, steps, weighing } = bendSteps(this.#meshes, (i) => i * MESH_WORDS);
    this.steps = steps;
    this.weighing = weighing;
    // Records first, then the shares, which name them.
    const head = new Uint32Array(roundUp(placed.length * MESH_WORDS + shares.length, GEOMETRY_ROW));
    const layout = new Layout(head.length);
    head.set(shares, placed.length * MESH_WORDS);
    placed.forEach(({ mesh, row }, i) => {
      const cost = this.costRow * GEOMETRY_ROW + i;
      const record = recordOf(mesh, layout, { row, pose: poses[i]!, places: places[i]!, cost });
      for (const [field, value] of Object.entries(record))
        head[i * MESH_WORDS + MESH_WORD[field as keyof typeof MESH_WORD]] = value;
    });
    this.planRows = layout.rows;
    this.parts = [{ row: 0, words: head }, ...layout.parts];
  }

  /** Writes the poses that are other ones. */
  update(): void {
    let changed = false;
    this.#meshes.forEach((mesh, i) => {
      const { pose, poseRevision } = mesh.body;
      if (this.#written[i] === poseRevision) return;
      this.#written[i] = poseRevision;
      changed = true;
      writePose(this.poses, this.#poses[i]!, mesh, pose!);
    });
    if (changed) this.revision++;
  }

  /** What the trees cost, one after the other, some frames ago. */
  weighed(costs: ArrayLike<number>): void {
    this.#meshes.forEach((mesh, i) => {
      mesh.weighed(costs[i]!);
    });
  }
}

function endToEnd(meshes: readonly BentMesh[], lengthOf: (mesh: BentMesh) => number): [begins: number[], end: number] {
  let end = 0;
  const begins = meshes.map((mesh) => {
    end += lengthOf(mesh);
    return end - lengthOf(mesh);
  });
  return [begins, end];
}

const targetsOf = ({ morphTargets = [] }: Mesh) => morphTargets;
const poseLength = ({ mesh, body }: BentMesh): number =>
  firstMatrix(0, targetsOf(mesh).length) + (body.pose?.joints?.length ?? 0);

interface Where {
  readonly row: number;
  readonly pose: number;
  readonly places: number;
  readonly cost: number;
}

function recordOf(bent: BentMesh, layout: Layout, where: Where): Readonly<Record<keyof typeof MESH_WORD, number>> {
  const { mesh, body, nodes, triangles, vertices, levels } = bent;
  const skin = body.pose?.joints ? mesh.skin : undefined;
  const first = where.row * GEOMETRY_ROW;
  const { normals, tangents } = vertices.rows > 0 ? mesh : {};
  return {
    count: vertexCount(mesh),
    positions: layout.place(mesh.positions),
    normals: layout.place(normals),
    tangents: layout.place(tangents),
    influences: skin ? skin.joints.length / vertexCount(mesh) : 0,
    joints: layout.place(skin?.joints),
    weights: layout.place(skin?.weights),
    targets: layout.place(targetTable(mesh, layout)),
    pose: where.pose / GEOMETRY_ROW,
    matrices: firstMatrix(where.pose, targetsOf(mesh).length) / GEOMETRY_ROW,
    places: where.places,
    nodes: first,
    triangles: first + nodes.length,
    vertices: first + nodes.length + triangles.length,
    vertexWords: vertices.rows * GEOMETRY_ROW,
    slots: slotsOf(bent),
    children: layout.place(levels.children),
    levels: layout.place(levels.begins),
    cost: where.cost,
  };
}

const targetTable = (mesh: Mesh, layout: Layout): Uint32Array =>
  Uint32Array.from(
    targetsOf(mesh).flatMap(({ positions, normals, tangents }) => [positions, normals, tangents].map((deltas) => layout.place(deltas))), // biome-ignore format: one thought
  );

/** Children of all nodes. */
const slotsOf = ({ nodes }: BentMesh): number => (nodes.length / NODE_WORDS) * WIDTH;

/** Boxes grow by a share of the greatest coordinate of the box about the mesh. */
function writePose({ f32, u32 }: Block, at: number, { mesh, box }: BentMesh, { weights = [], joints }: Pose): void {
  let most = 0;
  for (let i = 0; i < 6; i++) most = Math.max(most, Math.abs(box[i]!));
  f32[at + POSE_WORD.padding] = PADDING * most;
  u32[at + POSE_WORD.isUneven] = joints && !keepsAngles(joints) ? 1 : 0;
  const targets = targetsOf(mesh).length;
  let end = firstPairs(at);
  for (let target = 0; target < targets; target++) {
    const weight = weights[target] ?? 0;
    if (weight === 0) continue;
    u32[end] = target;
    f32[end + 1] = weight;
    end += 2;
  }
  u32[at + POSE_WORD.targets] = (end - firstPairs(at)) / 2;
  if (joints) f32.set(joints, firstMatrix(at, targets));
}
