/** Primitives of a file as meshes of a scene. */
import type { Mesh, MorphTarget, SkinWeights } from '../../scene/mesh.ts';
import { floatsOf } from '../accessors.ts';
import type { PrimitiveJson } from '../json.ts';
import { GLTF_LIMITS } from '../limits.ts';
import { addProblem, type Path } from '../problems.ts';
import type { Reading } from '../reading.ts';
import { across, blendedNormals, unitVectors } from './normals.ts';
import { picked, usedVertices } from './rearrange.ts';
import { MODE_NAMES, triangleList } from './triangles.ts';

const TRIANGLES = 4;
/** The content of an accessor for the vertices that are taken. */
type Take = (accessor: number, most?: number | null) => Float32Array | null;
/** Attributes that are taken; others are told. */
const KNOWN = /^(POSITION|NORMAL|TANGENT|TEXCOORD_[01]|COLOR_0|JOINTS_[01]|WEIGHTS_[01])$/;

export class PrimitiveReader {
  readonly #reading: Reading;
  /** Of accessors that are used: one array, whatever uses them. */
  readonly #floats = new Map<number, Float32Array>();
  /** By accessor and the most that it may hold. */
  readonly #isGood = new Map<string, boolean>();
  readonly #indices = new Map<string, Uint32Array | null>();
  readonly #cache = new Map<string, Mesh>();

  constructor(reading: Reading) {
    this.#reading = reading;
  }

  /** Which primitives have the same mesh. */
  keyOf({ attributes, indices, mode, targets }: PrimitiveJson): string {
    return JSON.stringify([Object.entries(attributes).sort(), indices, mode ?? TRIANGLES, targets]);
  }

  /** The mesh, or null when there is none to be had: a problem or an entry of the report says why. */
  read(primitive: PrimitiveJson, path: Path): Mesh | null {
    const key = this.keyOf(primitive);
    const known = this.#cache.get(key);
    if (known !== undefined) return known;
    const mesh = this.#make(primitive, path);
    if (mesh !== null) this.#cache.set(key, mesh); // why there is none is told at each place
    return mesh;
  }

  #make(primitive: PrimitiveJson, path: Path): Mesh | null {
    const { report } = this.#reading;
    const { attributes, mode = TRIANGLES } = primitive;
    if (mode < TRIANGLES) {
      const what = MODE_NAMES[mode]!;
      report.add('unsupported', what, [...path, 'mode'], `Light meets surfaces only: ${what} are left out.`);
      return null;
    }
    if (attributes.POSITION === undefined) {
      report.add('unsupported', 'POSITION', [...path, 'attributes'], 'A primitive has no positions; it is left out.');
      return null;
    }
    const all = this.#triangles(primitive, path);
    if (all === null) return null;
    if (all.length === 0) {
      report.add(
        'unsupported',
        'triangles',
        path,
        'A primitive has not enough vertices for a triangle; it is left out.',
      );
      return null;
    }
    this.#tellStrangers(primitive, path);
    const used = usedVertices(all, this.#reading.columns[attributes.POSITION]!.count);
    return this.#assemble(primitive, used?.indices ?? all, used?.source ?? null, path);
  }

  /** `source`: the vertices that are taken, or null for all. */
  #assemble(primitive: PrimitiveJson, indices: Uint32Array, source: Uint32Array | null, path: Path): Mesh | null {
    const { attributes } = primitive;
    const take: Take = (accessor, most = GLTF_LIMITS.farthest) => {
      const floats = this.#numbers(accessor, most);
      return floats && source ? picked(floats, this.#reading.columns[accessor]!.width, source) : floats;
    };
    const positions = take(attributes.POSITION!);
    if (positions === null) return null;
    const normals = this.#normals(attributes.NORMAL, take, positions, indices, path);
    const mesh: Mesh = {
      positions,
      indices,
      ...(normals && { normals }),
      ...(normals && this.#tangents(attributes.TANGENT, take, normals, path)),
      ...uvs(attributes, take, positions.length / 3),
      ...this.#colors(attributes.COLOR_0, take, path),
      ...this.#skin(attributes, take, path),
      ...this.#targets(primitive, take, normals !== undefined, path),
    };
    return this.#reading.problems.isEmpty ? mesh : null;
  }

  /** An accessor as floats; null when a problem has been added, as some are larger than `most`. null as `most` allows what is no number. */
  #numbers(accessor: number, most: number | null): Float32Array | null {
    const key = `${accessor} ${most}`;
    const floats = this.#floats.get(accessor) ?? floatsOf(this.#reading.columns[accessor]!);
    this.#floats.set(accessor, floats);
    const known = this.#isGood.get(key);
    if (known !== undefined) return known ? floats : null;
    const bad = most === null ? -1 : floats.findIndex((value) => !(Math.abs(value) <= most));
    this.#isGood.set(key, bad < 0);
    if (bad < 0) return floats;
    const element = Math.floor(bad / this.#reading.columns[accessor]!.width);
    const allowed = most === GLTF_LIMITS.farthest ? 'coordinates from -1e9 to 1e9' : 'finite numbers';
    addProblem(
      this.#reading.problems,
      ['accessors', accessor],
      `the number ${floats[bad]} in element ${element}`,
      allowed,
    );
    return null;
  }

  #triangles({ indices, mode = TRIANGLES, attributes }: PrimitiveJson, path: Path): Uint32Array | null {
    const vertices = this.#reading.columns[attributes.POSITION!]!.count;
    const key = `${indices ?? `all ${vertices}`} ${mode}`;
    const known = this.#indices.get(key);
    let list = known ?? null;
    if (known === undefined) {
      const numbers = indices === undefined ? null : this.#reading.columns[indices]!.numbers;
      list = triangleList(mode, numbers, vertices);
      const count = numbers?.length ?? vertices;
      if (mode === TRIANGLES && count % 3 !== 0)
        this.#reading.report.add(
          'changed',
          'indices',
          path,
          `${count} indices make no whole triangles; the last ones are left out.`,
        );
      this.#indices.set(key, list);
    }
    const wild = list!.findIndex((index) => index >= vertices);
    if (wild < 0) return list;
    addProblem(
      this.#reading.problems,
      [...path, 'indices'],
      `the index ${list![wild]} in triangle ${Math.floor(wild / 3)}`,
      `0 to ${vertices - 1}, as there are ${vertices} vertices`,
    );
    return null;
  }

  #tellStrangers({ attributes, targets = [] }: PrimitiveJson, path: Path): void {
    const tell = (name: string, place: Path): void =>
      this.#reading.report.add('unsupported', name, place, `The attribute ${name} is left out.`);
    for (const name of Object.keys(attributes)) if (!KNOWN.test(name)) tell(name, [...path, 'attributes', name]);
    targets.forEach((target, i) => {
      for (const name of Object.keys(target))
        if (!['POSITION', 'NORMAL', 'TANGENT'].includes(name)) tell(name, [...path, 'targets', i, name]);
    });
  }

  #normals(
    accessor: number | undefined,
    take: Take,
    positions: Float32Array,
    indices: Uint32Array,
    path: Path,
  ): Float32Array | undefined {
    const given = accessor === undefined ? null : take(accessor, null);
    if (given === null) return undefined;
    let blended: Float32Array | null = null;
    const replace = (vertex: number): Float32Array => {
      blended ??= blendedNormals(positions, indices);
      return blended.subarray(3 * vertex, 3 * vertex + 3);
    };
    const { vectors, replaced } = unitVectors(given, 3, replace);
    if (replaced > 0)
      this.#reading.report.add(
        'changed',
        'NORMAL',
        [...path, 'attributes', 'NORMAL'],
        `${replaced} normals have no direction; those of the triangles around stand for them.`,
      );
    return vectors;
  }

  #tangents(accessor: number | undefined, take: Take, normals: Float32Array, path: Path): { tangents?: Float32Array } {
    const given = accessor === undefined ? null : take(accessor, null);
    if (given === null) return {};
    const { vectors, replaced } = unitVectors(given, 4, (vertex) => across(normals, vertex));
    let tangents = vectors;
    let unhanded = 0;
    for (let at = 3; at < vectors.length; at += 4) {
      if (Math.abs(vectors[at]!) === 1) continue;
      if (unhanded++ === 0) tangents = vectors.slice();
      tangents[at] = vectors[at]! < 0 ? -1 : 1;
    }
    const count = Math.max(replaced, unhanded);
    if (count > 0)
      this.#reading.report.add(
        'changed',
        'TANGENT',
        [...path, 'attributes', 'TANGENT'],
        `${count} tangents have no direction or no hand; others stand for them.`,
      );
    return { tangents };
  }

  /** Always with opacity, 0 … 1; colours that are white all over are left out. */
  #colors(accessor: number | undefined, take: Take, path: Path): { colors?: Float32Array } {
    const floats = accessor === undefined ? null : take(accessor);
    if (floats === null || accessor === undefined) return {};
    const { width } = this.#reading.columns[accessor]!;
    const colors = new Float32Array((floats.length / width) * 4).fill(1);
    let [changed, coloured] = [0, 0];
    for (let i = 0; i < floats.length; i++) {
      const value = Math.min(Math.max(floats[i]!, 0), 1);
      if (value !== floats[i]) changed++;
      if (value !== 1) coloured++;
      colors[Math.floor(i / width) * 4 + (i % width)] = value;
    }
    if (changed > 0)
      this.#reading.report.add(
        'changed',
        'COLOR_0',
        [...path, 'attributes', 'COLOR_0'],
        `${changed} numbers of vertex colours are cut to 0 … 1.`,
      );
    return coloured > 0 ? { colors } : {};
  }

  #skin(attributes: PrimitiveJson['attributes'], take: Take, path: Path): { skin?: SkinWeights } {
    const sets = [0, 1].filter(
      (set) => attributes[`JOINTS_${set}`] !== undefined && attributes[`WEIGHTS_${set}`] !== undefined,
    );
    if (sets[0] !== 0) return {};
    const joints = sets.map((set) => take(attributes[`JOINTS_${set}`]!));
    const weights = sets.map((set) => take(attributes[`WEIGHTS_${set}`]!));
    if (weights.includes(null) || joints.includes(null)) return {};
    const vertices = joints[0]!.length / 4;
    const width = 4 * sets.length;
    const skin = { joints: new Uint16Array(vertices * width), weights: new Float32Array(vertices * width) };
    for (let i = 0; i < vertices * width; i++) {
      const [vertex, slot] = [Math.floor(i / width), i % width];
      const from = 4 * vertex + (slot % 4);
      skin.weights[i] = Math.max(weights[slot >> 2]![from]!, 0);
      // A weight of 0 may stand beside any joint.
      skin.joints[i] = skin.weights[i] === 0 ? 0 : joints[slot >> 2]![from]!;
    }
    const changed = evenOut(skin.weights, width);
    if (changed > 0)
      this.#reading.report.add(
        'changed',
        'WEIGHTS_0',
        [...path, 'attributes', 'WEIGHTS_0'],
        `The weights of ${changed} vertices do not add up to 1; they are scaled.`,
      );
    return { skin };
  }

  #targets({ targets }: PrimitiveJson, take: Take, normals: boolean, path: Path): { morphTargets?: MorphTarget[] } {
    if (!targets || targets.length === 0) return {};
    const floats = (accessor: number | undefined) =>
      accessor === undefined ? undefined : (take(accessor) ?? undefined);
    const morphTargets = targets.map(({ POSITION, NORMAL, TANGENT }, i) => {
      const [p, n, t] = [floats(POSITION), normals ? floats(NORMAL) : undefined, normals ? floats(TANGENT) : undefined];
      if (!normals && NORMAL !== undefined)
        this.#reading.report.add(
          'unused',
          'NORMAL',
          [...path, 'targets', i, 'NORMAL'],
          'A morph target bends normals that its mesh does not have.',
        );
      return { ...(p && { positions: p }), ...(n && { normals: n }), ...(t && { tangents: t }) };
    });
    return { morphTargets };
  }
}

function uvs(attributes: PrimitiveJson['attributes'], take: Take, vertices: number): { uvs?: Float32Array[] } {
  const { TEXCOORD_0: first, TEXCOORD_1: second } = attributes;
  const set = (accessor: number | undefined): Float32Array =>
    (accessor === undefined ? null : take(accessor)) ?? new Float32Array(2 * vertices);
  if (second !== undefined) return { uvs: [set(first), set(second)] };
  return first === undefined ? {} : { uvs: [set(first)] };
}

/** Makes the weights of each vertex add up to 1; gives how many vertices were farther from that than rounding of bytes explains. */
function evenOut(weights: Float32Array, width: number): number {
  let changed = 0;
  for (let at = 0; at < weights.length; at += width) {
    let sum = 0;
    for (let i = at; i < at + width; i++) sum += weights[i]!;
    if (Math.abs(sum - 1) > 0.01) changed++;
    if (sum > 0) for (let i = at; i < at + width; i++) weights[i] = weights[i]! / sum;
    else weights[at] = 1;
  }
  return changed;
}
