/** Material → the Surface struct: what the path integrator's BSDFs read. */
import { emissionOf } from '../scene/lamps.ts';
import { isClear, isSolid } from '../scene/layered.ts';
import type { Color, Material, MaterialType } from '../scene/scene.ts';
import type { StructValues } from './write-struct.ts';

const KINDS: readonly MaterialType[] = ['diffuse', 'metallicRoughness', 'conductor', 'dielectric'];
const THIN = 4;
const COMPENSATED = 8;
const ONE_SIDED = 16;
const SMOOTH = 32;
/** metals and glass only: glTF's material is correlated. */
const SEPARABLE = 64;
const EMITTER = 128;

/** Narrower than this a highlight is a mirror's: 32-bit floats no longer hold a facet's slope well enough for a density. */
const LEAST_ALPHA = 1e-3;
/** An index closer to 1 bends light by less than a rough boundary can be told from a smooth one in 32-bit floats. */
const LEAST_CONTRAST = 1e-3;

/** What a shape is as a lamp: the emitter that light sampling knows it by, the first one of several. */
export interface Lamp {
  readonly emitter: number;
  readonly oneSided: boolean;
}

/**
 * `lamp`: null for a shape that light sampling does not know as one. `textures`: row among the texels that says which it uses; 0: none.
 * `layers`: row of the table with the material's layers; 0: it has none.
 */
export function surfaceValues(m: Material, lamp: Lamp | null, textures = 0, layers = 0): StructValues<'Surface'> {
  // What single scattering loses is known of correlated masking.
  const separable = m.masking === 'separable' && (m.type === 'conductor' || m.type === 'dielectric');
  const flags =
    (m.thin ? THIN : 0) +
    (m.energyCompensation && !separable ? COMPENSATED : 0) +
    (separable ? SEPARABLE : 0) +
    (lamp?.oneSided ? ONE_SIDED : 0) +
    (isSmooth(m) ? SMOOTH : 0);
  const emitter = lamp ? EMITTER * (lamp.emitter + 1) : 0;
  return {
    baseColor: m.unlit ? [0, 0, 0] : m.baseColor,
    code: KINDS.indexOf(m.unlit ? 'diffuse' : m.type) + flags + emitter,
    emission: emissionOf(m),
    reflectivity: m.unlit ? 0 : m.reflectivity,
    eta: etaOf(m, layers),
    alpha: m.roughness ** 2,
    k: m.conductor.k,
    metallic: m.metallic,
    absorption: absorption(m),
    textures,
  };
}

function etaOf(m: Material, layers: number): Color {
  if (m.type === 'metallicRoughness') return [isClear(m) ? -layers : layers, 0, 0];
  return m.type === 'dielectric' ? [m.ior, m.ior, m.ior] : m.conductor.eta;
}

/** Whether its facets reflect and refract like a mirror. A thin pane's do: its two faces undo each other's bend. */
function isSmooth({ type, roughness, thin, ior }: Material): boolean {
  return roughness ** 2 < LEAST_ALPHA || (type === 'dielectric' && (thin || Math.abs(ior - 1) < LEAST_CONTRAST));
}

/** Beer–Lambert's coefficient, 1 / metre: `attenuationColor` is what is left after `attenuationDistance`. */
function absorption(m: Material): Color {
  const { attenuationColor, attenuationDistance } = m;
  if (attenuationDistance === 0 || (m.type === 'metallicRoughness' && !isSolid(m))) return [0, 0, 0];
  const one = (share: number) =>
    Math.min(-Math.log(Math.max(share, LEAST_SHARE)) / attenuationDistance, MOST_ABSORPTION);
  return [one(attenuationColor[0]), one(attenuationColor[1]), one(attenuationColor[2])];
}
/** A share of nothing would absorb without bounds. */
const LEAST_SHARE = 1e-6;
/** Nothing is left after any length that a shape may have; and infinity, times a length of 0, would be no number. */
const MOST_ABSORPTION = 1e30;
