/** The last step of every reader: what a file gave → a mesh that all later stages can rely on, and what was changed. */

import type { Mesh } from '../scene/mesh.ts';
import { FARTHEST_VERTEX } from '../scene/mesh-fault.ts';
import { smoothNormals } from './smooth-normals.ts';

/** Vertices as files have them: normals of any length, or none at all where all three numbers are 0 or no numbers. */
export interface RawMesh {
  /** Checked: finite, and not too far away. */
  readonly positions: Float32Array;
  /** Checked: in range. */
  readonly indices: Uint32Array;
  readonly normals?: Float32Array | undefined;
  readonly uvs?: Float32Array | undefined;
  readonly colors?: Float32Array | undefined;
}

export interface FinishedMesh {
  /** Null: no triangle is left. */
  readonly mesh: Mesh | null;
  /** Triangles without area, which are left out: nothing can hit them, and they have no normal. */
  readonly degenerate: number;
  /** Vertices whose normals had no direction, and got one from the triangles around. */
  readonly mended: number;
}

export function finishMesh({ positions, indices: given, normals, uvs, colors }: RawMesh): FinishedMesh {
  const indices = withArea(positions, given);
  const degenerate = (given.length - indices.length) / 3;
  if (indices.length === 0) return { mesh: null, degenerate, mended: 0 };
  const unit = normals && unitNormals(positions, indices, normals);
  const mesh: Mesh = {
    positions,
    indices,
    ...(unit ? { normals: unit.normals } : {}),
    ...(uvs ? { uvs: [uvs.map(orZero)] } : {}),
    ...(colors ? { colors: colors.map((x) => Math.max(orZero(x), 0)) } : {}),
  };
  return { mesh, degenerate, mended: unit?.mended ?? 0 };
}

const orZero = (x: number): number => (Math.abs(x) <= FARTHEST_VERTEX ? x : 0);

/** The given indices themselves when all triangles have an area. */
function withArea(p: Float32Array, indices: Uint32Array): Uint32Array {
  let kept: Uint32Array | null = null;
  let count = 0;
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [3 * indices[k]!, 3 * indices[k + 1]!, 3 * indices[k + 2]!];
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    const flat = uy * vz === uz * vy && uz * vx === ux * vz && ux * vy === uy * vx;
    if (flat && kept === null) kept = indices.slice();
    if (flat) continue;
    if (kept !== null) kept.set(indices.subarray(k, k + 3), count);
    count += 3;
  }
  return kept === null ? indices : kept.slice(0, count);
}

function unitNormals(positions: Float32Array, indices: Uint32Array, given: Float32Array) {
  const normals = new Float32Array(given.length);
  let blended: Float32Array | null = null;
  let mended = 0;
  for (let k = 0; k < given.length; k += 3) {
    const length = Math.hypot(given[k]!, given[k + 1]!, given[k + 2]!);
    if (length > 0 && length < Infinity) {
      for (let c = 0; c < 3; c++) normals[k + c] = given[k + c]! / length;
      continue;
    }
    mended++;
    blended ??= smoothNormals(positions, indices);
    normals.set(blended.subarray(k, k + 3), k);
  }
  return { normals, mended };
}
