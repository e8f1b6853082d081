/** Shapes as Mitsuba's; triangles in PLY files beside the scene. */
import { writePly } from '../../mesh-file/ply/write-ply.ts';
import { AFFINE_LENGTH, determinant, IDENTITY } from '../../scene/affine.ts';
import type { Mesh } from '../../scene/mesh.ts';
import { meshMatrices } from '../../scene/placed.ts';
import type { Box, MeshShape, Plane, Scene, Shape, Vec3 } from '../../scene/scene.ts';
import { add, addScaled, cross, dot, length, normalize, rotate, scale } from '../../scene/vec3.ts';
import type { PlannedFiles } from '../export-plan.ts';
import type { ExportReport } from '../export-report.ts';
import { type Carried, columnsOf } from './carried.ts';
import { boolean, type Element, float, plugin, point, reference, string, toWorld } from './xml.ts';

/** Columns of a matrix: x, y, z and where the origin goes. */
const fromColumns = (x: Vec3, y: Vec3, z: Vec3, origin: Vec3): number[] =>
  [0, 1, 2].flatMap((row) => [x[row]!, y[row]!, z[row]!, origin[row]!]);

/** Mitsuba's rectangle goes from −1 to 1 along x and y and looks along z, as u × v does. */
export function parallelogram(
  { corner, u, v }: { readonly corner: Vec3; readonly u: Vec3; readonly v: Vec3 },
  content: readonly Element[],
  thing: string,
  report: ExportReport,
): Element {
  if (Math.abs(dot(u, v)) > 1e-5 * length(u) * length(v))
    report.add(
      'changed',
      'Mitsuba warns of a rectangle that is no right-angled one, and may light it otherwise.',
      thing,
    );
  const middle = addScaled(addScaled(corner, u, 0.5), v, 0.5);
  const matrix = fromColumns(scale(u, 0.5), scale(v, 0.5), normalize(cross(u, v)), middle);
  return plugin('shape', 'rectangle', [toWorld(matrix), ...content]);
}

/** How far a plane goes, as a multiple of the greatest coordinate of the rest. */
const PLANE_REACH = 1000;

export class ShapeWriter {
  readonly #scene: Scene;
  readonly #name: string;
  readonly #files: PlannedFiles;
  readonly #report: ExportReport;
  readonly #extent: number;
  /** Names of files, by mesh and what else is in them. */
  readonly #written = new Map<Mesh, Map<string, string>>();
  #count = 0;
  #groups = 0;

  /** `extent`: the greatest coordinate of what has an end. */
  constructor(scene: Scene, name: string, extent: number, files: PlannedFiles, report: ExportReport) {
    this.#scene = scene;
    this.#name = name;
    this.#extent = extent;
    this.#files = files;
    this.#report = report;
  }

  /** `carried`: what a mesh gives its material. `content`: what it is made of, and the emitter if it shines. */
  write(name: string, shape: Shape, carried: Carried, content: readonly Element[]): Element[] {
    const thing = `shape "${name}"`;
    switch (shape.type) {
      case 'sphere':
        return [plugin('shape', 'sphere', [point('center', shape.center), float('radius', shape.radius), ...content])];
      case 'box':
        return [plugin('shape', 'cube', [toWorld(boxMatrix(shape)), ...content])];
      case 'quad':
        return [parallelogram(shape, content, thing, this.#report)];
      case 'plane':
        this.#report.add(
          'changed',
          `An infinite plane ends there, ${PLANE_REACH} times as far away as all else.`,
          thing,
        );
        return [plugin('shape', 'rectangle', [toWorld(this.#planeMatrix(shape)), ...content])];
      case 'mesh':
        return this.#mesh(shape, carried, content);
    }
  }

  #planeMatrix({ point: at, normal }: Plane): number[] {
    const z = normalize(normal);
    const x = normalize(cross(z, Math.abs(z[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
    const reach = PLANE_REACH * Math.max(this.#extent, length(at));
    return fromColumns(scale(x, reach), scale(cross(z, x), reach), z, at);
  }

  #mesh(shape: MeshShape, carried: Carried, content: readonly Element[]): Element[] {
    const mesh = loadedMesh(this.#scene, shape);
    const matrices = meshMatrices(shape, IDENTITY);
    // Mitsuba takes the outside of a placed mesh from the order of its corners in the world, which a mirror image turns round; that of an
    // instance from the mesh's own.
    const isTurned = matrices.length === AFFINE_LENGTH && determinant(matrices) < 0;
    const parts = [
      string('filename', this.#fileOf(mesh, shape.mesh, isTurned, carried)),
      // Such files count v from below.
      boolean('flip_tex_coords', true),
      boolean('face_normals', mesh.normals === undefined),
    ];
    const at = (i: number) => toWorld(matrices.subarray(i, i + AFFINE_LENGTH));
    if (matrices.length === AFFINE_LENGTH) return [plugin('shape', 'ply', [...parts, at(0), ...content])];
    const id = `group ${this.#groups++}`;
    const group = plugin('shape', 'shapegroup', [plugin('shape', 'ply', [...parts, ...content])], { id });
    const places: Element[] = [];
    for (let i = 0; i < matrices.length; i += AFFINE_LENGTH)
      places.push(plugin('shape', 'instance', [at(i), reference(id)]));
    return [group, ...places];
  }

  #fileOf(mesh: Mesh, name: string, isTurned: boolean, carried: Carried): string {
    const files = this.#written.get(mesh) ?? new Map<string, string>();
    this.#written.set(mesh, files);
    const key = JSON.stringify([isTurned, { ...carried, frame: carried.frame !== null }]);
    const known = files.get(key);
    if (known !== undefined) return known;
    const safe = name.replace(/[^\p{L}\p{N}]+/gu, '-').slice(0, 60);
    const file = `${this.#name}.${this.#count++} ${safe}.ply`.replace(/ /g, '-');
    const { positions, normals, uvs } = mesh;
    this.#files.set(file, () => {
      const indices = isTurned ? turned(mesh.indices) : mesh.indices;
      // Without any Mitsuba takes the place in each triangle.
      const coordinates = uvs?.[0] ? uvs : [new Float32Array((positions.length / 3) * 2)];
      const plain = { positions, indices, ...(normals && { normals }), uvs: coordinates };
      return [writePly(plain, columnsOf(mesh, carried))];
    });
    files.set(key, file);
    return file;
  }
}

export function loadedMesh(scene: Scene, shape: MeshShape): Mesh {
  const mesh = scene.meshes?.[shape.mesh]?.data;
  if (mesh === undefined) throw new TypeError(`The mesh "${shape.mesh}" has not been loaded.`);
  return mesh;
}

const turned = (indices: Uint32Array): Uint32Array => indices.map((_, i) => indices[i - (i % 3) + [0, 2, 1][i % 3]!]!);

function boxMatrix({ center, size, rotation }: Box): number[] {
  const axis = (v: Vec3): Vec3 => rotate(v, rotation);
  return fromColumns(axis([size[0] / 2, 0, 0]), axis([0, size[1] / 2, 0]), axis([0, 0, size[2] / 2]), add(center, [0, 0, 0])); // biome-ignore format: one expression
}
