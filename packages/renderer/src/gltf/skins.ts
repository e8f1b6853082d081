/** Skeletons. */

import { AFFINE_LENGTH } from '../scene/affine.ts';
import type { Skin } from '../scene/nodes.ts';
import { GLTF_LIMITS } from './limits.ts';
import { type NodesInScene, rowsOf } from './nodes.ts';
import { addProblem } from './problems.ts';
import { NamedThings, type Reading } from './reading.ts';

/** The skins of nodes that are shown. */
export function readSkins(reading: Reading, { nodes, shown }: NodesInScene): NamedThings<Skin> {
  const { json } = reading;
  const skins = new NamedThings<Skin>();
  const used = new Set([...shown].map((node) => json.nodes![node]!.skin).filter((skin) => skin !== undefined));
  for (const index of used) {
    const { joints, inverseBindMatrices, name } = json.skins![index]!;
    const matrices =
      inverseBindMatrices === undefined ? null : readMatrices(reading, inverseBindMatrices, joints.length);
    const skin: Skin = {
      joints: joints.map((joint) => nodes.nameOf(joint)!),
      ...(matrices && { inverseBindMatrices: matrices }),
    };
    skins.add(skin, name, `skin ${index}`, index);
  }
  return skins;
}

function readMatrices({ columns, problems }: Reading, accessor: number, count: number): Float32Array | null {
  const { numbers } = columns[accessor]!;
  const matrices = new Float32Array(count * AFFINE_LENGTH);
  for (let joint = 0; joint < count; joint++) matrices.set(rowsOf(numbers, joint * 16), joint * AFFINE_LENGTH);
  const bad = matrices.findIndex((value) => !(Math.abs(value) <= GLTF_LIMITS.farthest));
  if (bad < 0) return matrices;
  addProblem(
    problems,
    ['accessors', accessor],
    `the number ${matrices[bad]} in element ${Math.floor(bad / AFFINE_LENGTH)}`,
    'numbers from -1e9 to 1e9',
  );
  return null;
}
