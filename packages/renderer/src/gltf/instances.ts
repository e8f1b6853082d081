/** EXT_mesh_gpu_instancing. */
import { AFFINE_LENGTH, composeAffine } from '../scene/affine.ts';
import { floatsOf } from './accessors.ts';
import { extensionOf } from './json.ts';
import { GLTF_LIMITS } from './limits.ts';
import { addProblem } from './problems.ts';
import type { Reading } from './reading.ts';

const EXTENSION = 'EXT_mesh_gpu_instancing';

/** 12 numbers for each instance of a node's mesh; undefined where there is none. */
export function readInstances(reading: Reading, node: number): Float32Array | undefined {
  const { json, columns, problems, report } = reading;
  const found = extensionOf<{ attributes: Record<string, number> }>(json.nodes![node]!, EXTENSION);
  if (!found) return undefined;
  const path = ['nodes', node, 'extensions', EXTENSION, 'attributes'];
  for (const name of Object.keys(found.attributes))
    if (!['TRANSLATION', 'ROTATION', 'SCALE'].includes(name))
      report.add('unsupported', name, [...path, name], `The attribute ${name} of instances is left out.`);
  const count = columns[Object.values(found.attributes)[0]!]!.count;
  const numbers = (name: string, otherwise: readonly number[]): Float32Array => {
    const accessor = found.attributes[name];
    if (accessor !== undefined) return floatsOf(columns[accessor]!);
    return Float32Array.from({ length: count * otherwise.length }, (_, i) => otherwise[i % otherwise.length]!);
  };
  const [t, r, s] = [numbers('TRANSLATION', [0, 0, 0]), numbers('ROTATION', [0, 0, 0, 1]), numbers('SCALE', [1, 1, 1])];
  const out = new Float32Array(count * AFFINE_LENGTH);
  for (let i = 0; i < count; i++) composeAffine(out, i * AFFINE_LENGTH, t, 3 * i, r, 4 * i, s, 3 * i);
  const bad = out.findIndex((value) => !(Math.abs(value) <= GLTF_LIMITS.farthest));
  if (bad < 0) return out;
  addProblem(
    problems,
    path,
    `the number ${out[bad]} in instance ${Math.floor(bad / AFFINE_LENGTH)}`,
    'places from -1e9 to 1e9',
  );
  return undefined;
}
