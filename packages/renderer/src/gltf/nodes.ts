/** The nodes of the scene that is shown. */
import { toQuaternion } from '../scene/affine.ts';
import type { Affine, Quaternion, SceneNode } from '../scene/nodes.ts';
import type { Vec3 } from '../scene/scene.ts';
import { extensionOf, type Gltf, type NodeJson } from './json.ts';
import { NamedThings, type Reading } from './reading.ts';

export interface NodesInScene {
  readonly nodes: NamedThings<SceneNode>;
  /** Places in the file of the nodes that are taken, parents first. */
  readonly order: readonly number[];
  /** Those that are shown: in the scene, and neither they nor a parent hidden. */
  readonly shown: ReadonlySet<number>;
}

/** Everything that the file's scene carries, and the joints that its skins name, wherever they are. */
export function readNodes(reading: Reading): NodesInScene {
  const { json } = reading;
  const parents = parentsOf(json);
  const order: number[] = [];
  const taken = new Set<number>();
  const shown = new Set<number>();
  const walk = (roots: readonly number[], inScene: boolean): void => {
    const stack = [...roots].reverse().map((node) => ({ node, visible: inScene }));
    for (let next = stack.pop(); next !== undefined; next = stack.pop()) {
      const { node } = next;
      if (taken.has(node)) continue;
      taken.add(node);
      order.push(node);
      const visible = next.visible && isVisible(reading, node);
      if (visible) shown.add(node);
      const children = json.nodes![node]!.children ?? [];
      for (let i = children.length - 1; i >= 0; i--) stack.push({ node: children[i]!, visible });
    }
  };
  const roots = rootsOf(reading, parents);
  setApart(reading, roots, parents);
  walk(roots, true);
  for (const node of [...shown]) {
    const skin = json.nodes![node]!.skin;
    // A joint elsewhere comes with all that carries it, and with all that these carry, which is not shown.
    if (skin !== undefined)
      walk(
        json.skins![skin]!.joints.map((joint) => rootOf(joint, parents)),
        false,
      );
  }
  return { nodes: named(reading, order, parents), order, shown };
}

/** UniGLTF and others leave a node above those of the scene that the scene does not have: these stand by themselves. */
function setApart({ report }: Reading, roots: readonly number[], parents: Int32Array): void {
  for (const root of roots) {
    if (parents[root]! >= 0)
      report.add(
        'changed',
        'node',
        ['nodes', root],
        'A node of the scene is carried by one that is not in the scene; it stands by itself.',
      );
    parents[root] = -1;
  }
}

function parentsOf({ nodes = [] }: Gltf): Int32Array {
  const parents = new Int32Array(nodes.length).fill(-1);
  nodes.forEach(({ children = [] }, parent) => {
    for (const child of children) parents[child] = parent;
  });
  return parents;
}

function rootOf(node: number, parents: Int32Array): number {
  let root = node;
  while (parents[root]! >= 0) root = parents[root]!;
  return root;
}

/** Of the scene that the file calls its own, else of its first, else all nodes that nothing carries. */
function rootsOf({ json, report }: Reading, parents: Int32Array): number[] {
  const { scenes = [], nodes = [] } = json;
  if (scenes.length === 0) return [...nodes.keys()].filter((node) => parents[node]! < 0);
  const chosen = json.scene ?? 0;
  scenes.forEach((scene, i) => {
    const name = scene.name === undefined ? '' : ` "${scene.name}"`;
    if (i !== chosen)
      report.add(
        'unused',
        'scene',
        ['scenes', i],
        `The file has more scenes than one; scene ${i}${name} is not shown.`,
      );
  });
  return scenes[chosen]!.nodes ?? [];
}

function isVisible({ json, report }: Reading, node: number): boolean {
  const visibility = extensionOf<{ visible?: boolean }>(json.nodes![node]!, 'KHR_node_visibility');
  if (visibility?.visible !== false) return true;
  report.add(
    'unused',
    'KHR_node_visibility',
    ['nodes', node],
    'A node says that it and all that it carries are not visible; they are left out.',
  );
  return false;
}

function named(reading: Reading, order: readonly number[], parents: Int32Array): NamedThings<SceneNode> {
  const { json } = reading;
  const nodes = new NamedThings<SceneNode>();
  for (const index of order) nodes.reserve(json.nodes![index]!.name, `node ${index}`, index);
  for (const index of order) {
    const parent = parents[index]!;
    const node = json.nodes![index]!;
    nodes.things[nodes.nameOf(index)!] = {
      ...(parent >= 0 && { parent: nodes.nameOf(parent)! }),
      ...(node.matrix ? { matrix: rowsOf(node.matrix) } : partsOf(reading, index)),
      ...weightsOf(json, node),
    };
  }
  return nodes;
}

function partsOf(reading: Reading, index: number): SceneNode {
  const { translation, rotation, scale } = reading.json.nodes![index]! as {
    translation?: Vec3;
    rotation?: Quaternion;
    scale?: Vec3;
  };
  const turn = rotation && toQuaternion(...rotation);
  if (rotation && Math.abs(Math.hypot(...rotation) - 1) > 0.01)
    reading.report.add(
      'changed',
      'rotation',
      ['nodes', index, 'rotation'],
      'A rotation is no unit quaternion; it is brought to length 1.',
    );
  return { ...(translation && { translation }), ...(turn && { rotation: turn }), ...(scale && { scale: thick(reading, index, scale) }) }; // biome-ignore format: one line
}

/** What is pressed quite flat, as painted shadows are, keeps this part of its extent: without any it has no normals. All zero: not there. */
const THINNEST = 1e-4;

function thick({ report }: Reading, index: number, scale: Vec3): Vec3 {
  const least = THINNEST * Math.max(...scale.map(Math.abs));
  if (least === 0 || !scale.includes(0)) return scale;
  report.add(
    'changed',
    'scale',
    ['nodes', index, 'scale'],
    'A scale is 0 along some axes; it counts as a ten-thousandth of the greatest.',
  );
  return scale.map((x) => (x === 0 ? least : x)) as unknown as Vec3;
}

/** A node's own weights of its mesh's morph targets, or those of the mesh, or 0 for each. */
function weightsOf({ meshes }: Gltf, { mesh, weights }: NodeJson): { weights?: readonly number[] } {
  if (mesh === undefined) return {};
  const count = meshes![mesh]!.primitives[0]!.targets?.length ?? 0;
  if (count === 0) return {};
  const given = weights ?? meshes![mesh]!.weights ?? [];
  return { weights: Array.from({ length: count }, (_, i) => given[i] ?? 0) };
}

/** glTF writes matrices column by column. */
export const rowsOf = (columns: ArrayLike<number>, at = 0): Affine =>
  Array.from({ length: 12 }, (_, i) => columns[at + (i % 4) * 4 + Math.floor(i / 4)]!);
