/** Meshes, their materials, and the places where nodes put them. */
import type { Mesh, MeshSource } from '../scene/mesh.ts';
import type { Skin, Variant } from '../scene/nodes.ts';
import type { Material, MeshShape } from '../scene/scene.ts';
import { readInstances } from './instances.ts';
import { extensionOf, type PrimitiveJson, variantsOf } from './json.ts';
import { defaultMaterial, hasDirections, readMaterial, tangentUse, withoutDirections } from './materials.ts';
import { PrimitiveReader } from './mesh/primitives.ts';
import { loadTangentMaker, type TangentMaker, withTangents } from './mesh/tangents.ts';
import type { NodesInScene } from './nodes.ts';
import { addProblem, type Path } from './problems.ts';
import { NamedThings, type Reading } from './reading.ts';
import type { TextureReader } from './textures.ts';

export interface Shapes {
  readonly meshes: NamedThings<MeshSource>;
  readonly materials: NamedThings<Material>;
  readonly shapes: NamedThings<MeshShape>;
  readonly variants: Readonly<Record<string, Variant>>;
}

/** Between meshes others may have their turn; the signal's reason is thrown when it is aborted. */
export type Pause = (done: number, total: number) => Promise<void>;

interface Mapping {
  readonly material: number;
  readonly variants: readonly number[];
}
/** The material that primitives have which name none. */
const NO_MATERIAL = -1;

/** Materials that a primitive may have: its own, and those of variants. */
export const materialsOf = (primitive: PrimitiveJson): number[] => [
  primitive.material ?? NO_MATERIAL,
  ...mappingsOf(primitive).map(({ material }) => material),
];
const mappingsOf = (primitive: PrimitiveJson): readonly Mapping[] =>
  extensionOf<{ mappings: Mapping[] }>(primitive, 'KHR_materials_variants')?.mappings ?? [];

/** Places in the file of the meshes that are shown. */
export const meshesShown = ({ json }: Reading, { order, shown }: NodesInScene): number[] => [
  ...new Set(order.filter((node) => shown.has(node)).flatMap((node) => json.nodes![node]!.mesh ?? [])),
];

export class ShapeReader {
  readonly #reading: Reading;
  readonly #textures: TextureReader;
  readonly #primitives: PrimitiveReader;
  readonly #nodes: NodesInScene;
  readonly #skins: NamedThings<Skin>;
  readonly #meshes = new NamedThings<MeshSource>();
  readonly #materials = new NamedThings<Material>();
  readonly #shapes = new NamedThings<MeshShape>();
  /** By place in the file. */
  readonly #variants: readonly Record<string, string>[];
  /** Names of meshes, by what they are made of. */
  readonly #made = new Map<string, string>();
  /** Names of materials without their maps of directions, by those with. */
  readonly #plain = new Map<string, string>();
  #tangents: TangentMaker | null = null;

  constructor(reading: Reading, textures: TextureReader, nodes: NodesInScene, skins: NamedThings<Skin>) {
    this.#reading = reading;
    this.#textures = textures;
    this.#primitives = new PrimitiveReader(reading);
    this.#nodes = nodes;
    this.#skins = skins;
    this.#variants = variantsOf(reading.json).map(() => Object.create(null) as Record<string, string>);
  }

  async read(pause: Pause): Promise<Shapes> {
    const { json } = this.#reading;
    const carriers = this.#nodes.order.filter(
      (node) => this.#nodes.shown.has(node) && json.nodes![node]!.mesh !== undefined,
    );
    for (const [done, node] of carriers.entries()) {
      await pause(done, carriers.length);
      await this.#place(node);
      if (!this.#reading.problems.isEmpty) break;
    }
    const names = new NamedThings<Variant>();
    for (const [i, { name }] of variantsOf(json).entries()) names.add(this.#variants[i]!, name, `variant ${i}`);
    return { meshes: this.#meshes, materials: this.#materials, shapes: this.#shapes, variants: names.things };
  }

  async #place(index: number): Promise<void> {
    const { json } = this.#reading;
    const { mesh, skin } = json.nodes![index]!;
    const instances = readInstances(this.#reading, index);
    const node = this.#nodes.nodes.nameOf(index)!;
    for (const [i, primitive] of json.meshes![mesh!]!.primitives.entries()) {
      const path = ['meshes', mesh!, 'primitives', i];
      const source = await this.#mesh(primitive, path);
      if (source === null) continue;
      const bends = skin !== undefined && this.#checkJoints(source.mesh, skin, index, path);
      const on = (material: number) => this.#materialOn(source.mesh, material);
      const own = on(primitive.material ?? NO_MATERIAL);
      const shape: MeshShape = {
        type: 'mesh',
        mesh: source.name,
        material: own,
        translation: [0, 0, 0],
        rotation: [0, 0, 0],
        scale: [1, 1, 1],
        node,
        ...(bends && { skin: this.#skins.nameOf(skin)! }),
        ...(instances && { instances }),
      };
      const name = this.#shapes.add(shape, node, node);
      for (const { material, variants } of mappingsOf(primitive))
        for (const variant of variants) this.#variants[variant]![name] = on(material);
    }
  }

  /** A skin bends what has joints, and none of these may be beyond the skin's. */
  #checkJoints(mesh: Mesh, skin: number, node: number, path: Path): boolean {
    const { json, report, problems } = this.#reading;
    if (!mesh.skin) {
      report.add(
        'changed',
        'skin',
        ['nodes', node, 'skin'],
        'A node has a skin, but its mesh no joints and weights; the node carries it.',
      );
      return false;
    }
    const joints = json.skins![skin]!.joints.length;
    const wild = mesh.skin.joints.findIndex((joint) => joint >= joints);
    if (wild >= 0)
      addProblem(
        problems,
        [...path, 'attributes', 'JOINTS_0'],
        `the joint ${mesh.skin.joints[wild]}`,
        `0 to ${joints - 1}, as skin ${skin} has ${joints} joints`,
      );
    return wild < 0;
  }

  #material(index: number): string {
    const known = this.#materials.nameOf(index);
    if (known !== undefined) return known;
    if (index === NO_MATERIAL) return this.#materials.add(defaultMaterial(), 'default', 'default', index);
    const json = this.#reading.json.materials![index]!;
    return this.#materials.add(
      readMaterial(this.#reading, this.#textures, json, index),
      json.name,
      `material ${index}`,
      index,
    );
  }

  /** Without its maps of directions on a mesh that has nothing to lay them along, as is told when the mesh is read. */
  #materialOn(mesh: Mesh, index: number): string {
    const name = this.#material(index);
    const material = this.#materials.things[name]!;
    if (mesh.tangents || !hasDirections(material)) return name;
    const known = this.#plain.get(name);
    if (known !== undefined) return known;
    const plain = this.#materials.add(withoutDirections(material), `${name} without directions`, '');
    this.#plain.set(name, plain);
    return plain;
  }

  /** With tangents when one of its materials needs them; without when none does. */
  async #mesh(primitive: PrimitiveJson, path: Path): Promise<{ name: string; mesh: Mesh } | null> {
    const uses = materialsOf(primitive).map((index) => tangentUse(this.#materials.things[this.#material(index)]!));
    const use = uses.find((one) => one !== null) ?? null;
    const mesh = this.#primitives.read(primitive, path);
    if (mesh === null) return null;
    const mustMake = use !== null && mesh.tangents === undefined;
    const key = JSON.stringify([this.#primitives.keyOf(primitive), use === null ? null : mustMake ? use : 'own']);
    const known = this.#made.get(key);
    if (known !== undefined) return { name: known, mesh: this.#meshes.things[known]!.data! };
    const whole = use === null ? without(mesh) : mustMake ? await this.#withTangents(mesh, use, path) : mesh;
    const { name, primitives } = this.#reading.json.meshes![path[1] as number]!;
    const part = primitives.length > 1 && name !== undefined ? `${name} ${Number(path[3]) + 1}` : name;
    const made = this.#meshes.add({ data: whole }, part, `mesh ${path[1]}`);
    this.#made.set(key, made);
    return { name: made, mesh: whole };
  }

  async #withTangents(mesh: Mesh, use: NonNullable<ReturnType<typeof tangentUse>>, path: Path): Promise<Mesh> {
    const which = use === 'any' ? null : use;
    if (mesh.uvs?.[which?.uvSet ?? 0] === undefined) {
      this.#reading.report.add(
        'changed',
        'normalTexture',
        path,
        'A material has a normal map or anisotropy, but the mesh no texture coordinates to lay it along; both have no effect there.',
      );
      return mesh;
    }
    this.#tangents ??= await loadTangentMaker();
    return withTangents(mesh, which, this.#tangents);
  }
}

const without = ({ tangents: _, morphTargets, ...mesh }: Mesh): Mesh => ({
  ...mesh,
  ...(morphTargets && { morphTargets: morphTargets.map(({ tangents: __, ...target }) => target) }),
});
