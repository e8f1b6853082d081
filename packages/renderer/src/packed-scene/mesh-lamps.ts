/** The meshes of a scene that shine: their emitters, and the tables by which triangles are chosen, at one time after the other. */
import { AFFINE_LENGTH, isSolid } from '../scene/affine.ts';
import type { Body } from '../scene/bodies.ts';
import { type EmitterValues, NO_EMITTER } from './emitter-values.ts';
import type { MeshGlow } from './lamp-clusters.ts';
import { GEOMETRY_ROW } from './layout.ts';
import { type LampTable, lampTable, meshEmitters } from './pack-lamps.ts';
import type { PackedMesh } from './packed-mesh.ts';

interface LampBody {
  readonly body: Body;
  readonly mesh: PackedMesh;
}

export class MeshLamps {
  /**
   * In the world; those of a body begin where those before end, had all of their instances been there. What is not there has no power.
   */
  emitters: readonly EmitterValues[] = [];
  /** In the order in which their rows follow one another. */
  tables: readonly LampTable[] = [];
  /** Of all tables. */
  rows = 0;

  /** `glows`: of each body, null for one that does not shine. `matrices`: of all instances. `firstRow`: of the scene table. */
  update(
    bodies: readonly LampBody[],
    glows: readonly (MeshGlow | null)[],
    matrices: Float64Array,
    firstRow: number,
  ): void {
    // The usual case stays the same object, so that nobody takes it for other lights.
    if (this.emitters.length === 0 && glows.every((glow) => glow === null)) return;
    const starts = new Map<LampTable, number>();
    const emitters: EmitterValues[] = [];
    this.rows = 0;
    let [slot, end] = [0, 0];
    bodies.forEach(({ body, mesh }, k) => {
      const glow = glows[k] ?? null;
      if (glow) end += glow.instances * glow.clusters;
      for (let i = body.first; i < body.first + body.count; i++) {
        if (!isSolid(matrices, i * AFFINE_LENGTH)) continue;
        const instance = slot++;
        if (!glow) continue;
        const placement = matrices.subarray(i * AFFINE_LENGTH, (i + 1) * AFFINE_LENGTH);
        const table = lampTable(body, mesh, placement, glow);
        emitters.push(...meshEmitters(glow, table, placement, { instance, table: this.#start(starts, table), row: firstRow + k })); // biome-ignore format: one thought
      }
      while (emitters.length < end) emitters.push(NO_EMITTER);
    });
    this.emitters = emitters;
    this.tables = [...starts.keys()];
  }

  #start(starts: Map<LampTable, number>, table: LampTable): number {
    let start = starts.get(table);
    if (start === undefined) {
      starts.set(table, (start = this.rows));
      this.rows += table.words.length / GEOMETRY_ROW;
    }
    return start;
  }
}
