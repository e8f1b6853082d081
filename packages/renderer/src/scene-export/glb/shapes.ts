/** Shapes: meshes as they are, all else as triangles. */
import { AFFINE_LENGTH } from '../../scene/affine.ts';
import type { Mesh } from '../../scene/mesh.ts';
import { placementOf } from '../../scene/placed.ts';
import type { AnalyticShape, MeshShape, Scene, Shape, Vec3 } from '../../scene/scene.ts';
import { cross, length, normalize, rotate, scale } from '../../scene/vec3.ts';
import type { ExportReport } from '../export-report.ts';
import type { GltfFile, Json } from './gltf-file.ts';
import type { MaterialWriter } from './materials.ts';
import { primitiveOf } from './meshes.ts';
import { isIdentity, type NodeWriter } from './nodes.ts';
import { unitBox, unitQuad, unitSphere } from './tessellate.ts';

/** A mesh of the file: which of the scene's, of what, and with which variants. */
interface Part {
  readonly name: string;
  readonly shape: MeshShape;
}

export class ShapeWriter {
  readonly #file: GltfFile;
  readonly #scene: Scene;
  readonly #nodes: NodeWriter;
  readonly #materials: MaterialWriter;
  readonly #report: ExportReport;
  readonly #extent: number;
  readonly #meshes = new Map<string, number>();
  readonly #forms = { sphere: unitSphere(), box: unitBox(), quad: unitQuad() };
  readonly #skins = new Map<string, number>();
  readonly #variants: readonly string[];

  constructor(
    file: GltfFile,
    scene: Scene,
    nodes: NodeWriter,
    materials: MaterialWriter,
    extent: number,
    report: ExportReport,
  ) {
    this.#file = file;
    this.#scene = scene;
    this.#nodes = nodes;
    this.#materials = materials;
    this.#extent = extent;
    this.#report = report;
    this.#variants = Object.keys(scene.variants ?? {});
  }

  /** Meshes that stand on one node without more ado are parts of one mesh of the file. */
  write(): void {
    const together = new Map<string, Part[]>();
    for (const [name, shape] of Object.entries(this.#scene.shapes as Readonly<Record<string, Shape>>)) {
      if (shape.type !== 'mesh') {
        this.#analytic(name, shape);
        continue;
      }
      const simple = shape.node !== undefined && isIdentity(placementOf(shape)) && !shape.instances;
      const key = simple ? `${shape.node} ${shape.skin ?? ''}` : `alone ${name}`;
      together.set(key, [...(together.get(key) ?? []), { name, shape }]);
    }
    for (const parts of together.values()) this.#mesh(parts);
  }

  #mesh(parts: readonly Part[]): void {
    const { name, shape } = parts[0]!;
    const matrix = placementOf(shape);
    const { node: carrier, instances, skin } = shape;
    const json = isIdentity(matrix) && carrier !== undefined ? this.#nodes.carrier(carrier, 'mesh', name) : this.#nodes.child(carrier, name, instances ? undefined : matrix); // biome-ignore format: one choice
    json.mesh = this.#meshOf(parts);
    if (skin !== undefined) json.skin = this.#skin(skin);
    if (!instances) return;
    // Instances come between the node and the shape's own placement, which glTF has none of.
    for (let at = 0; at < instances.length; at += AFFINE_LENGTH) {
      const place = product(instances.subarray(at, at + AFFINE_LENGTH), matrix);
      if (at === 0 && !json.matrix && json.name === name) json.matrix = columns(place);
      else this.#nodes.child(carrier, name, place).mesh = json.mesh;
    }
  }

  #meshOf(parts: readonly Part[]): number {
    const key = JSON.stringify(parts.map(({ name, shape }) => [shape.mesh, shape.material, this.#mappingsOf(name)]));
    const known = this.#meshes.get(key);
    if (known !== undefined) return known;
    const primitives = parts.map(({ name, shape }) => this.#primitive(name, shape));
    const first = parts[0]!.shape.mesh;
    const place = this.#file.add('meshes', { name: parts.length > 1 ? first.replace(/ 1$/, '') : first, primitives });
    this.#meshes.set(key, place);
    return place;
  }

  #primitive(name: string, shape: MeshShape): Json {
    const mesh = this.#scene.meshes?.[shape.mesh]?.data;
    if (mesh === undefined) throw new TypeError(`The mesh "${shape.mesh}" has not been loaded.`);
    const json = { ...primitiveOf(this.#file, mesh), material: this.#materials.place(shape.material) };
    const mappings = this.#mappingsOf(name);
    if (mappings.length > 0) this.#file.extend(json, 'KHR_materials_variants').mappings = mappings;
    return json;
  }

  #mappingsOf(shape: string): Json[] {
    return this.#variants.flatMap((variant, i) => {
      const material = this.#scene.variants![variant]![shape];
      return material === undefined ? [] : [{ material: this.#materials.place(material), variants: [i] }];
    });
  }

  #skin(name: string): number {
    const known = this.#skins.get(name);
    if (known !== undefined) return known;
    const { joints, inverseBindMatrices: matrices } = this.#scene.skins![name]!;
    const all = matrices && Float32Array.from(joints.flatMap((_, i) => columns(matrices.subarray(i * AFFINE_LENGTH))));
    const place = this.#file.add('skins', {
      name,
      joints: joints.map((joint) => this.#nodes.place(joint)),
      ...(all && { inverseBindMatrices: this.#file.accessor(all, 'MAT4') }),
    });
    this.#skins.set(name, place);
    return place;
  }

  #analytic(name: string, shape: AnalyticShape): void {
    const thing = `shape "${name}"`;
    const what = shape.type === 'plane' ? 'An infinite plane ends there, a thousand times as far away as all else.' : `A ${shape.type} is triangles there.`; // biome-ignore format: one choice
    this.#report.add('changed', what, thing);
    const [form, matrix] = formOf(shape, this.#extent);
    this.form(name, form, matrix, this.#materials.place(shape.material), shape.node);
  }

  /** One of the unit forms, placed. */
  form(
    name: string,
    form: 'sphere' | 'box' | 'quad',
    matrix: readonly number[],
    material: number,
    node?: string,
  ): void {
    const key = `${form} ${material}`;
    const place = this.#meshes.get(key) ?? this.#file.add('meshes', { name: form, primitives: [{ ...primitiveOf(this.#file, this.#forms[form] as Mesh), material }] }); // biome-ignore format: one choice
    this.#meshes.set(key, place);
    this.#nodes.child(node, name, matrix).mesh = place;
  }
}

const columns = (rows: ArrayLike<number>): number[] =>
  Array.from({ length: 16 }, (_, i) => (i % 4 < 3 ? rows[4 * (i % 4) + Math.floor(i / 4)]! : i === 15 ? 1 : 0));

function product(a: ArrayLike<number>, b: ArrayLike<number>): number[] {
  return Array.from({ length: AFFINE_LENGTH }, (_, i) => {
    const [row, column] = [4 * Math.floor(i / 4), i % 4];
    return [0, 1, 2].reduce((sum, k) => sum + a[row + k]! * b[4 * k + column]!, column === 3 ? a[row + 3]! : 0);
  });
}

/** Rows of the matrix whose columns these are. */
export const fromColumns = (x: Vec3, y: Vec3, z: Vec3, origin: Vec3): number[] =>
  [0, 1, 2].flatMap((row) => [x[row]!, y[row]!, z[row]!, origin[row]!]);

export const quadMatrix = ({ corner, u, v }: { readonly corner: Vec3; readonly u: Vec3; readonly v: Vec3 }): number[] =>
  fromColumns(u, v, normalize(cross(u, v)), corner);

function formOf(shape: AnalyticShape, extent: number): ['sphere' | 'box' | 'quad', number[]] {
  switch (shape.type) {
    case 'sphere': {
      const r = shape.radius;
      return ['sphere', fromColumns([r, 0, 0], [0, r, 0], [0, 0, r], shape.center)];
    }
    case 'box': {
      const [a, b, c] = shape.size;
      const axis = (v: Vec3): Vec3 => rotate(v, shape.rotation);
      return ['box', fromColumns(axis([a, 0, 0]), axis([0, b, 0]), axis([0, 0, c]), shape.center)];
    }
    case 'quad':
      return ['quad', quadMatrix(shape)];
    case 'plane': {
      const z = normalize(shape.normal);
      const side = normalize(cross(z, Math.abs(z[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
      const reach = 1000 * Math.max(extent, length(shape.point));
      const [u, v] = [scale(side, 2 * reach), scale(cross(z, side), 2 * reach)];
      const corner = [0, 1, 2].map((k) => shape.point[k]! - (u[k]! + v[k]!) / 2) as unknown as Vec3;
      return ['quad', quadMatrix({ corner, u, v })];
    }
  }
}
