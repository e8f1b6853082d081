import type { Material } from '../../packages/renderer/src/scene/scene.ts';
import type { NeutralMaterial } from './neutral-scene.ts';
import { Refusal } from './transform.ts';

/** Our material for a neutral one, defaults left out. Throws a `Refusal` where the two models differ, however little. */
export function convertMaterial(m: NeutralMaterial): Partial<Material> {
  switch (m.type) {
    case 'diffuse':
      return { type: 'diffuse', baseColor: m.albedo };
    // The mirror layer over a base has one share for all channels, a smooth metal without eta and k one for each.
    case 'mirror':
      return { type: 'conductor', baseColor: m.reflectance, roughness: 0 };
    case 'rough_conductor':
      return roughConductor(m);
    case 'dielectric':
      return { type: 'dielectric', baseColor: WHITE, ior: m.ior, roughness: 0 };
    case 'rough_dielectric':
      return { type: 'dielectric', baseColor: WHITE, ior: m.ior, ...facetsOf(m) };
    case 'blend':
      return blend(m);
    case 'gltf_metallic_roughness':
      return gltf(m);
    case 'mitsuba_principled':
      throw new Refusal("Mitsuba's principled material, which is not glTF's");
  }
}

type Of<Type extends NeutralMaterial['type']> = Extract<NeutralMaterial, { type: Type }>;

const WHITE = [1, 1, 1] as const;

/** glTF's alpha = roughness². */
function facetsOf({ alpha, masking }: { alpha: number; masking: string }): Pick<Material, 'roughness' | 'masking'> {
  if (!(alpha >= 0 && alpha <= 1)) throw new Refusal(`alpha ${alpha}: ours is 0 to 1`);
  return { roughness: Math.sqrt(alpha), ...(masking === 'separable' ? { masking } : {}) };
}

function roughConductor(m: Of<'rough_conductor'>): Partial<Material> {
  if (m.distribution !== 'ggx') throw new Refusal(`the distribution ${m.distribution}: ours is GGX`);
  const facets = facetsOf(m);
  const given = [m.reflectance, m.f0, m.eta && m.k].filter((x) => x !== undefined);
  if (given.length !== 1 || (m.eta === undefined) !== (m.k === undefined))
    throw new Refusal('a rough conductor needs either "reflectance", or "f0", or both "eta" and "k"');
  // Schlick's Fresnel between f0 and 1 is glTF's metal.
  if (m.f0 && facets.masking)
    throw new Refusal("separable masking with Schlick's Fresnel: glTF's metal is height-correlated");
  if (m.f0) return { type: 'metallicRoughness', metallic: 1, baseColor: m.f0, ...facets };
  if (m.reflectance) return { type: 'conductor', baseColor: m.reflectance, ...facets };
  return { type: 'conductor', baseColor: WHITE, ...facets, conductor: { eta: m.eta!, k: m.k! } };
}

/**
 * weight · r mirror + (1 − weight) · diffuse is our layer reflectivity · mirror + (1 − reflectivity) · base with
 * reflectivity = weight · r, if r is grey.
 */
function blend({ weight, a, b }: Of<'blend'>): Partial<Material> {
  if (a.type !== 'diffuse' || b.type !== 'mirror') throw new Refusal(`a blend of ${a.type} and ${b.type}`);
  const [r, ...others] = b.reflectance;
  if (others.some((other) => other !== r)) throw new Refusal('a blend with a coloured mirror');
  const reflectivity = weight * r;
  const rest = r === 1 ? 1 : (1 - weight) / (1 - reflectivity);
  const [red, green, blue] = a.albedo;
  return { type: 'diffuse', baseColor: [red * rest, green * rest, blue * rest], reflectivity };
}

function gltf(m: Of<'gltf_metallic_roughness'>): Partial<Material> {
  // The two readings of the specification agree for pure metals and pure dielectrics.
  if (m.form !== 'mix' && m.metallic !== 0 && m.metallic !== 1)
    throw new Refusal(`glTF's form "${m.form}" at metallic ${m.metallic}: ours mixes the two BRDFs ("mix")`);
  return { type: 'metallicRoughness', baseColor: m.base_color, metallic: m.metallic, roughness: m.roughness };
}
