/** One row of emitters as the path integrator samples them. */
import type { StructValues } from './write-struct.ts';

/** The kinds as shading/light/emitter/emitter.wesl numbers them. */
export const EMITTER_KIND = { sphere: 0, quad: 1, box: 2, point: 3, spot: 4, directional: 5, sky: 6, mesh: 7 } as const;

/** All fields of the struct. */
export type EmitterValues = Required<StructValues<'Emitter'>>;

export const NO_EMITTER: EmitterValues = {
  position: [0, 0, 0],
  kind: 0,
  u: [0, 0, 0],
  radius: 0,
  v: [0, 0, 0],
  cosInner: 0,
  radiance: [0, 0, 0],
  area: 0,
  shape: -1,
  oneSided: 0,
  power: 0,
  reach: 0,
  leaf: -1,
  table: 0,
  triangles: 0,
  instance: 0,
};
