/** Nodes must make trees: no node carries itself, and none is carried twice. */
import type { ProblemList } from '../../scene-file/problem.ts';
import type { Gltf } from '../json.ts';
import { addProblem } from '../problems.ts';

/** The parent of each node, −1 where it has none; adds problems where there would be more. */
export function checkHierarchy({ nodes = [], scenes = [] }: Gltf, problems: ProblemList): Int32Array {
  const parents = new Int32Array(nodes.length).fill(-1);
  nodes.forEach(({ children = [] }, parent) => {
    children.forEach((child, i) => {
      const known = parents[child]!;
      const path = ['nodes', parent, 'children', i];
      if (known >= 0)
        addProblem(
          problems,
          path,
          `the node ${child}, which node ${known} carries already`,
          'a node that nothing else carries',
        );
      else parents[child] = parent;
    });
  });
  const rings = ringsOf(parents);
  for (const node of rings)
    addProblem(
      problems,
      ['nodes', node, 'children'],
      'a way back to the node itself',
      'nodes that do not carry each other in a ring',
    );
  if (rings.length > 0) return parents;
  scenes.forEach(({ nodes: roots = [] }, scene) => {
    const inScene = new Set(roots);
    roots.forEach((node, i) => {
      let above = parents[node]!;
      while (above >= 0 && !inScene.has(above)) above = parents[above]!;
      if (above >= 0) addProblem(problems, ['scenes', scene, 'nodes', i], `the node ${node}, which node ${above} of the scene carries already`, 'a node that nothing else carries'); // biome-ignore format: short
    });
  });
  return parents;
}

/** One node of each ring. */
function ringsOf(parents: Int32Array): number[] {
  const rings: number[] = [];
  /** The walk in which a node was met first, from 1 on. */
  const walks = new Int32Array(parents.length);
  for (let start = 0; start < parents.length; start++) {
    let at = start;
    while (at >= 0 && walks[at] === 0) {
      walks[at] = start + 1;
      at = parents[at]!;
    }
    if (at >= 0 && walks[at] === start + 1) rings.push(at);
  }
  return rings;
}
