/** What must hold between the things of a file that name each other. */
import { type ProblemList, quote } from '../../scene-file/problem.ts';
import { extensionOf, type Gltf, type PrimitiveJson, WIDTHS } from '../json.ts';
import { addProblem, type Path } from '../problems.ts';

/** Components of glTF's accessors; `u` unsigned, `n` as shares of their range. */
const FLOAT = 5126;
const [BYTE, UBYTE, SHORT, USHORT, UINT] = [5120, 5121, 5122, 5123, 5125];
const QUANTIZED = [FLOAT, BYTE, UBYTE, SHORT, USHORT] as const;

interface Kind {
  readonly types: readonly string[];
  readonly components: readonly (number | undefined)[];
}
/** With KHR_mesh_quantization. */
const ATTRIBUTES: Readonly<Record<string, Kind>> = {
  POSITION: { types: ['VEC3'], components: QUANTIZED },
  NORMAL: { types: ['VEC3'], components: [FLOAT, BYTE, SHORT] },
  TANGENT: { types: ['VEC4'], components: [FLOAT, BYTE, SHORT] },
  TEXCOORD: { types: ['VEC2'], components: QUANTIZED },
  COLOR: { types: ['VEC3', 'VEC4'], components: [FLOAT, UBYTE, USHORT] },
  JOINTS: { types: ['VEC4'], components: [UBYTE, USHORT] },
  WEIGHTS: { types: ['VEC4'], components: [FLOAT, UBYTE, USHORT] },
};
/** Deltas of tangents have no handedness. */
const TARGETS: Readonly<Record<string, Kind>> = {
  POSITION: ATTRIBUTES.POSITION!,
  NORMAL: ATTRIBUTES.NORMAL!,
  TANGENT: { types: ['VEC3'], components: [FLOAT, BYTE, SHORT] },
};
const INDICES: Kind = { types: ['SCALAR'], components: [UBYTE, USHORT, UINT] };
const MATRICES: Kind = { types: ['MAT4'], components: [FLOAT] };
const TIMES: Kind = { types: ['SCALAR'], components: [FLOAT] };
const INSTANCES: Readonly<Record<string, Kind>> = {
  TRANSLATION: { types: ['VEC3'], components: [FLOAT] },
  ROTATION: { types: ['VEC4'], components: [FLOAT, BYTE, SHORT] },
  SCALE: { types: ['VEC3'], components: [FLOAT] },
};

/** "TEXCOORD" of "TEXCOORD_1". */
export const kindOf = (attribute: string): string => attribute.replace(/_\d+$/, '');

export function checkRelations(json: Gltf, problems: ProblemList): void {
  const checker = new RelationChecker(json, problems);
  checker.primitives();
  checker.skins();
  checker.animations();
  checker.instances();
  checker.cameras();
}

class RelationChecker {
  readonly #json: Gltf;
  readonly #problems: ProblemList;

  constructor(json: Gltf, problems: ProblemList) {
    this.#json = json;
    this.#problems = problems;
  }

  #add(path: Path, found: string, allowed: string): void {
    addProblem(this.#problems, path, found, allowed);
  }

  #count = (accessor: number): number => this.#json.accessors![accessor]!.count;

  #kind(path: Path, accessor: number, { types, components }: Kind): void {
    const { type, componentType } = this.#json.accessors![accessor]!;
    const wanted = `${types.join(' or ')} of the component types ${components.join(', ')}`;
    if (!types.includes(type) || !components.includes(componentType))
      this.#add(path, `the accessor ${accessor}, which is ${type} of ${componentType}`, wanted);
  }

  primitives(): void {
    (this.#json.meshes ?? []).forEach(({ primitives }, mesh) => {
      const morphs = primitives[0]!.targets?.length ?? 0;
      primitives.forEach((primitive, i) => {
        const path = ['meshes', mesh, 'primitives', i];
        this.#attributes([...path, 'attributes'], primitive.attributes, ATTRIBUTES);
        if (primitive.indices !== undefined) this.#kind([...path, 'indices'], primitive.indices, INDICES);
        const targets = primitive.targets ?? [];
        if (targets.length !== morphs)
          this.#add([...path, 'targets'], `${targets.length} targets`, `the ${morphs} of the first primitive`);
        targets.forEach((target, t) => {
          this.#attributes([...path, 'targets', t], target, TARGETS, primitive.attributes.POSITION);
        });
        this.#draco([...path, 'extensions', 'KHR_draco_mesh_compression', 'attributes'], primitive);
      });
    });
  }

  /** All of one length, that of the positions. */
  #attributes(
    path: Path,
    attributes: PrimitiveJson['attributes'],
    kinds: Readonly<Record<string, Kind>>,
    positions = attributes.POSITION,
  ): void {
    for (const [name, accessor] of Object.entries(attributes)) {
      const kind = Object.hasOwn(kinds, kindOf(name)) ? kinds[kindOf(name)] : undefined;
      if (kind) this.#kind([...path, name], accessor, kind);
      if (kind && positions !== undefined && this.#count(accessor) !== this.#count(positions))
        this.#add(
          [...path, name],
          `${this.#count(accessor)} elements`,
          `as many as there are positions, ${this.#count(positions)}`,
        );
    }
  }

  #draco(path: Path, primitive: PrimitiveJson): void {
    const draco = extensionOf<{ attributes: Record<string, number> }>(primitive, 'KHR_draco_mesh_compression');
    for (const name of Object.keys(draco?.attributes ?? {}))
      if (!Object.hasOwn(primitive.attributes, name))
        this.#add([...path, name], quote(name), 'attributes of the primitive');
  }

  skins(): void {
    (this.#json.skins ?? []).forEach(({ joints, inverseBindMatrices }, skin) => {
      if (inverseBindMatrices === undefined) return;
      const path = ['skins', skin, 'inverseBindMatrices'];
      this.#kind(path, inverseBindMatrices, MATRICES);
      const count = this.#count(inverseBindMatrices);
      if (count < joints.length) this.#add(path, `${count} matrices`, `one for each of the ${joints.length} joints`);
    });
  }

  animations(): void {
    (this.#json.animations ?? []).forEach(({ channels, samplers }, animation) => {
      channels.forEach(({ sampler }, i) => {
        const path = ['animations', animation, 'channels', i, 'sampler'];
        if (sampler >= samplers.length)
          this.#add(path, String(sampler), `a place among the ${samplers.length} samplers, counted from 0`);
      });
      samplers.forEach(({ input, output, interpolation }, i) => {
        const path = ['animations', animation, 'samplers', i];
        this.#kind([...path, 'input'], input, TIMES);
        const keys = this.#count(input) * (interpolation === 'CUBICSPLINE' ? 3 : 1);
        // Weights are lists: so many numbers a key as there are targets.
        if (this.#count(output) % keys !== 0)
          this.#add([...path, 'output'], `${this.#count(output)} values`, `as many for each of ${keys}`);
      });
    });
  }

  instances(): void {
    (this.#json.nodes ?? []).forEach((node, i) => {
      const instancing = extensionOf<{ attributes: Record<string, number> }>(node, 'EXT_mesh_gpu_instancing');
      if (!instancing) return;
      const path = ['nodes', i, 'extensions', 'EXT_mesh_gpu_instancing', 'attributes'];
      const counts = new Set(Object.values(instancing.attributes).map(this.#count));
      if (counts.size > 1) this.#add(path, `${[...counts].join(' and ')} elements`, 'as many of each attribute');
      for (const [name, accessor] of Object.entries(instancing.attributes))
        if (Object.hasOwn(INSTANCES, name)) this.#kind([...path, name], accessor, INSTANCES[name]!);
    });
  }

  cameras(): void {
    (this.#json.cameras ?? []).forEach((camera, i) => {
      if (camera[camera.type] === undefined)
        this.#add(['cameras', i], 'nothing', `an object ${quote(camera.type)}, as its type says`);
    });
  }
}

/** How many numbers an accessor's values have in all. */
export const numbersOf = ({ accessors = [] }: Gltf, accessor: number): number =>
  accessors[accessor]!.count * WIDTHS[accessors[accessor]!.type]!;
