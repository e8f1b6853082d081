/** Nodes: those of the scene, and more for whatever stands somewhere by itself. */
import type { SceneNode } from '../../scene/nodes.ts';
import type { Scene, Vec3 } from '../../scene/scene.ts';
import { cross, dot, normalize } from '../../scene/vec3.ts';
import type { GltfFile, Json } from './gltf-file.ts';

export class NodeWriter {
  readonly #file: GltfFile;
  readonly #scene: Scene;
  readonly #places = new Map<string, number>();
  readonly #roots: number[] = [];

  constructor(file: GltfFile, scene: Scene) {
    this.#file = file;
    this.#scene = scene;
    for (const [name, node] of Object.entries(scene.nodes ?? {}))
      this.#places.set(name, file.add('nodes', this.#json(name, node)));
    for (const [name, { parent }] of Object.entries(scene.nodes ?? {})) this.#hang(this.place(name), parent);
  }

  place(name: string): number {
    return this.#places.get(name)!;
  }

  /** As it is in the file; may be changed. */
  json(place: number): Json {
    return this.#file.at('nodes', place);
  }

  /** Of a node of the scene that carries nothing of this kind yet; else of a new one below it (or in the world). */
  carrier(node: string | undefined, kind: string, name: string): Json {
    const own = node === undefined ? undefined : this.json(this.place(node));
    return own && own[kind] === undefined ? own : this.child(node, name);
  }

  /** A new node. `matrix`: 12 numbers, row by row. */
  child(parent: string | undefined, name: string, matrix?: ArrayLike<number>): Json {
    const json: Json = { name, ...(matrix && { matrix: columnsOf(matrix) }) };
    this.#hang(this.#file.add('nodes', json), parent);
    return json;
  }

  roots(): readonly number[] {
    return this.#roots;
  }

  #hang(place: number, parent: string | undefined): void {
    if (parent === undefined) this.#roots.push(place);
    else {
      const json = this.json(this.place(parent));
      json.children ??= [];
      json.children.push(place);
    }
  }

  #json(name: string, { translation, rotation, scale, matrix, weights }: SceneNode): Json {
    const carriesMesh = Object.values(this.#scene.shapes).some(({ node }) => node === name);
    return {
      name,
      ...(matrix
        ? { matrix: columnsOf(matrix) }
        : { ...(translation && { translation }), ...(rotation && { rotation }), ...(scale && { scale }) }),
      ...(weights && carriesMesh && { weights }),
    };
  }
}

/** glTF writes matrices column by column. */
export const columnsOf = (rows: ArrayLike<number>): number[] =>
  Array.from({ length: 16 }, (_, i) => (i % 4 < 3 ? rows[4 * (i % 4) + Math.floor(i / 4)]! : i === 15 ? 1 : 0));

/** The matrix, row by row, of what looks along −Z: cameras and lights of glTF. */
export function lookingAlong(eye: Vec3, forward: Vec3, up: Vec3): number[] {
  const z = normalize(forward).map((x) => -x) as unknown as Vec3;
  const x = normalize(cross(up, z));
  const y = cross(z, x);
  return [0, 1, 2].flatMap((row) => [x[row]!, y[row]!, z[row]!, eye[row]!]);
}

/** A direction that is not along this one. */
export const across = (direction: Vec3): Vec3 =>
  Math.abs(dot(normalize(direction), [0, 1, 0])) < 0.99 ? [0, 1, 0] : [0, 0, 1];

/** Whether the matrix changes nothing. */
export const isIdentity = (matrix: ArrayLike<number>): boolean =>
  Array.from(matrix).every((x, i) => Math.abs(x - (i % 5 === 0 ? 1 : 0)) < 1e-12);
