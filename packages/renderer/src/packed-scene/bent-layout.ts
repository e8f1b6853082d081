/**
 * What kernels that bend meshes are told, all in words of 32 bits; `npm run shaders` writes shading/mesh/bent_table.wesl from it. It comes with
 * the first mesh that bends, so it is not in layout.ts.
 *
 * The plan is made once: what workgroups do, a record of each bent mesh, and lists that these name. The pose is written for each frame.
 */
import { type FieldName, fieldOffset, GEOMETRY_ROW, geometryRows, type StructName } from './layout.ts';

/** A record of the plan. Numbers of words are counted from the start of what holds them. */
export const BENT_MESH = {
  count: 'of its vertices',
  positions: 'word of the plan: x, y, z of each vertex at rest',
  normals: 'likewise; NONE: the mesh has none',
  tangents: 'x, y, z and handedness; NONE: the mesh has none',
  influences: 'joints of a vertex; 0: none moves it',
  joints: 'word of the plan: numbers of joints, two in a word, those of a vertex side by side: four or eight',
  weights: 'word of the plan: as many floats',
  targets:
    'word of the plan: for each morph target where its positions, normals and tangents begin, or NONE; all have x, y, z',
  pose: 'row of the poses: BENT_POSE',
  matrices: 'row of the poses: three rows a joint, as the matrix has them',
  places: 'word of the places: x, y, z of each vertex as it is bent',
  nodes: 'word of the geometry: the root of the tree',
  triangles: 'word of the geometry: the first triangle',
  vertices: 'word of the geometry: the first vertex',
  vertexWords: 'of each vertex',
  slots: 'children of all nodes, four each',
  children: 'word of the plan: two words each, its slot and the reference there: leaves first, then level by level',
  levels: 'word of the plan: where each level begins among `children`, and the last one ends',
  cost: 'word of the places: what the tree costs, once it has been weighed',
} as const;

/** At the start of a pose, a row; behind it pairs: a target and its weight, two in a row. */
export const BENT_POSE = {
  padding: 'float: what boxes grow by',
  isUneven: '1: a joint stretches or mirrors, and normals go by cofactors',
  targets: 'morph targets that count',
  none: '0',
} as const;

/** What a workgroup does, a row of four words. */
export const SHARE = {
  mesh: 'word of the record',
  first: 'vertex, child or level where it begins',
  end: 'and before which it ends',
} as const;
export const SHARE_WORDS = 4;

export const NONE = 0xffffffff;

const numbered = <Field extends string>(fields: Readonly<Record<Field, string>>) =>
  Object.fromEntries(Object.keys(fields).map((name, at) => [name, at])) as Readonly<Record<Field, number>>;

/** Where a field is in its record. */
export const MESH_WORD = numbered(BENT_MESH);
export const POSE_WORD = numbered(BENT_POSE);
export const SHARE_WORD = numbered(SHARE);
export const MESH_WORDS = Object.keys(BENT_MESH).length;
export const POSE_WORDS = Object.keys(BENT_POSE).length;

/** Threads of a workgroup where each does one thing, and where one workgroup does all there is to do of a mesh. */
export const THREADS = 64;
export const MANY_THREADS = 256;

const words = (name: 'WideNode' | 'Triangle') => geometryRows(name) * GEOMETRY_ROW;
const word = <S extends StructName>(name: S, field: FieldName<S>) => fieldOffset(name, field) / 4;

function structOf(name: string, fields: Readonly<Record<string, string>>, load: (k: number) => string): string {
  const names = Object.keys(fields);
  const lines = names.map((field) => `  // ${fields[field]}\n  ${field}: u32,`);
  const loads = names.map((_, k) => load(k));
  return `struct ${name} {\n${lines.join('\n')}\n}\nfn fetch${name}(at: u32) -> ${name} {\n  return ${name}(${loads.join(', ')});\n}\n`;
}

export function bentTableWgsl(): string {
  const constants = {
    none: NONE,
    shareWords: SHARE_WORDS,
    nodeWords: words('WideNode'),
    leastWord: word('WideNode', 'minX'),
    greatestWord: word('WideNode', 'maxX'),
    childrenWord: word('WideNode', 'children'),
    triangleWords: words('Triangle'),
    cornerWords: word('Triangle', 'b') - word('Triangle', 'a'),
    numberWord: word('Triangle', 'vertexA') - word('Triangle', 'a'),
    normalWord: word('Vertex', 'normal'),
    tangentWord: word('Vertex', 'tangent'),
  };
  return [
    '// Written by `npm run shaders` from packed-scene/bent-layout.ts. Do not edit.',
    'import package::shading::mesh::bend_bindings::{plan, poses};\n',
    ...Object.entries(constants).map(([name, value]) => `const ${name} = ${value}u;`),
    '',
    structOf('BentMesh', BENT_MESH, (k) => `plan[at + ${k}u]`),
    structOf('BentPose', BENT_POSE, (k) => `poses[at].${'xyzw'[k]}`),
    structOf('Share', SHARE, (k) => `plan[at + ${k}u]`),
  ].join('\n');
}
