/** What must hold between nodes, and between them and what they carry. */
import { AFFINE_LENGTH } from '../scene/affine.ts';
import { nodeTransforms, worldOf } from '../scene/node-transforms.ts';
import { inOrder } from '../scene/nodes.ts';
import { placedShape } from '../scene/placed.ts';
import { listOfNames } from './check-references.ts';
import type { Sections } from './check-scene.ts';
import type { FaultyPlaces } from './faulty-places.ts';
import { type ProblemList, quote } from './problem.ts';

export function checkNodes(scene: Sections, faulty: FaultyPlaces, problems: ProblemList): void {
  const { nodes = {}, skins = {} } = scene;
  for (const [name, { joints, inverseBindMatrices: matrices }] of Object.entries(skins)) {
    if (faulty.has('skins', name) || matrices === undefined || matrices.length === joints.length * AFFINE_LENGTH)
      continue;
    const wanted = `${joints.length * AFFINE_LENGTH} numbers, 12 for each of its joints`;
    const message = `The matrices of the skin ${quote(name)} are ${matrices.length} numbers; expected ${wanted}.`;
    problems.add(['skins', name, 'inverseBindMatrices'], `${matrices.length} numbers`, wanted, message);
  }
  if (faulty.touches('nodes')) return;
  const { faults } = inOrder(nodes);
  for (const { node, fault } of faults) {
    const parent = nodes[node]!.parent!;
    const ring = `The node ${quote(node)} carries itself, by way of ${quote(parent)}; no node may.`;
    const lost = `The node ${quote(node)} is carried by ${quote(parent)}, which this scene does not have.`;
    const allowed = fault === 'cycle' ? 'a node that it does not carry' : listOfNames(Object.keys(nodes), 'a node');
    problems.add(['nodes', node, 'parent'], `the name ${quote(parent)}`, allowed, fault === 'cycle' ? ring : lost);
  }
  if (faults.length === 0) checkForms(scene, faulty, problems);
}

/** Spheres and boxes stay what they are: their nodes, as they are at rest, must not stretch them. */
function checkForms(scene: Sections, faulty: FaultyPlaces, problems: ProblemList): void {
  const { nodes = {}, shapes } = scene;
  const carried = Object.entries(shapes).filter(
    ([name, { type, node }]) =>
      (type === 'sphere' || type === 'box') &&
      node !== undefined &&
      Object.hasOwn(nodes, node) &&
      !faulty.has('shapes', name),
  );
  if (carried.length === 0) return;
  const transforms = nodeTransforms({ nodes, animation: [] });
  const world = transforms.at(0);
  for (const [name, shape] of carried)
    try {
      placedShape(shape, worldOf(transforms, world, shape.node), name);
    } catch (error) {
      const allowed = 'a node that moves, turns or evenly scales it';
      problems.add(['shapes', name, 'node'], `the name ${quote(shape.node!)}`, allowed, (error as Error).message);
    }
}
