/** Material → the Surface struct: what the path integrator's BSDFs read. */
import type { Color, Material, MaterialType } from '../scene/scene.ts';
import type { StructValues } from './write-struct.ts';

const KINDS: readonly MaterialType[] = ['diffuse', 'metallicRoughness', 'conductor', 'dielectric'];
const THIN = 4;
const COMPENSATED = 8;
const ONE_SIDED = 16;

/** What a shape is as a lamp: the emitter that light sampling knows it by. */
export interface Lamp {
  readonly emitter: number;
  readonly oneSided: boolean;
}

/** `lamp`: null for a shape that does not shine. */
export function surfaceValues(m: Material, lamp: Lamp | null): StructValues<'Surface'> {
  const flags = (m.thin ? THIN : 0) + (m.energyCompensation ? COMPENSATED : 0) + (lamp?.oneSided ? ONE_SIDED : 0);
  return {
    baseColor: m.baseColor,
    code: KINDS.indexOf(m.type) + flags,
    emission: m.emission,
    reflectivity: m.reflectivity,
    eta: m.type === 'dielectric' ? [m.ior, m.ior, m.ior] : m.conductor.eta,
    alpha: m.roughness ** 2,
    k: m.conductor.k,
    metallic: m.metallic,
    absorption: absorption(m),
    emitter: lamp?.emitter ?? -1,
  };
}

/** Beer–Lambert's coefficient, 1 / metre: `attenuationColor` is what is left after `attenuationDistance`. */
function absorption({ attenuationColor, attenuationDistance }: Material): Color {
  if (attenuationDistance === 0) return [0, 0, 0];
  const one = (share: number) => -Math.log(Math.max(share, LEAST_SHARE)) / attenuationDistance;
  return [one(attenuationColor[0]), one(attenuationColor[1]), one(attenuationColor[2])];
}
/** A share of nothing would absorb without bounds. */
const LEAST_SHARE = 1e-6;
