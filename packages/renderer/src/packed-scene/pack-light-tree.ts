/** Emitters that have a place → the tree that chooses among them. */
import type { Vec3 } from '../scene/scene.ts';
import { add, addScaled, cross, length, normalize, scale } from '../scene/vec3.ts';
import { EMITTER_KIND, type EmitterValues } from './emitter-values.ts';
import { buildLightTree, type LightOfTree, type LightTree } from './light-tree.ts';

/** `far`: so many emitters, the first ones, are in no tree. */
export function treeOfEmitters(emitters: readonly EmitterValues[], far: number): LightTree {
  return buildLightTree(emitters.slice(far).map(lightOf), far);
}

/** Light to all sides. */
const ALL_AROUND = { axis: [0, 0, 1], cosWidth: -1, cosEdge: 0, bothSides: false } as const;

export function lightOf(emitter: EmitterValues): LightOfTree {
  const { kind, u, v, position, power, reach, oneSided, radius, cosInner } = emitter as EmitterValues & {
    readonly [Key in 'u' | 'v' | 'position']: Vec3;
  } & { readonly [Key in 'power' | 'reach' | 'radius' | 'cosInner']: number };
  const bothSides = oneSided === 0;
  const ball = { center: position, reach, power };
  if (kind === EMITTER_KIND.quad) {
    const center = addScaled(position, add(u, v), 0.5);
    return { ...ball, center, axis: normalize(cross(u, v)), cosWidth: 1, cosEdge: 0, bothSides };
  }
  if (kind === EMITTER_KIND.spot)
    return {
      ...ball,
      axis: u,
      cosWidth: cosInner,
      cosEdge: Math.cos(Math.acos(radius) - Math.acos(cosInner)),
      bothSides: false,
    };
  const alike = length(v);
  if (kind !== EMITTER_KIND.mesh || alike === 0) return { ...ball, ...ALL_AROUND, bothSides };
  return {
    ...ball,
    // What looks the same way shines like a quad, the rest like a convex body, which shows a quarter of its surface.
    power: (power * (1 + 3 * alike)) / 4,
    axis: scale(v, 1 / alike),
    cosWidth: u[0],
    cosEdge: 0,
    bothSides,
  };
}
