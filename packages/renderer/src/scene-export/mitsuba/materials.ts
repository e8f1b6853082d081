/** Materials as Mitsuba's BSDFs: its own where one is equal, else those of python.ts. */

import type { Material } from '../../scene/scene.ts';
import type { ExportReport } from '../export-report.ts';
import { lacksLayers } from '../undone-layers.ts';
import { boolean, type Element, float, numbers, plugin, rgb, string } from './xml.ts';

/** Rougher than this is GGX, smoother a mirror, as the kernels have it. */
const SMOOTH = 1e-3;

export interface WrittenMaterial {
  readonly bsdf: Element;
  /** The inside of glass that absorbs, if it does. */
  readonly medium?: Element;
  /** Whether the BSDF is one of python.ts. */
  readonly needsPython: boolean;
}

export function writeMaterial(name: string, material: Material, id: string, report: ExportReport): WrittenMaterial {
  const thing = `material "${name}"`;
  for (const layer of lacksLayers(material)) report.add('lost', `Mitsuba's file has no ${layer}.`, thing);
  if (material.energyCompensation && material.type !== 'diffuse' && material.type !== 'dielectric')
    report.add('lost', 'Light that single scattering loses is not given back ("energyCompensation").', thing);
  const written = material.type === 'dielectric' ? glass(material, id, thing, report) : opaque(material, id);
  return written;
}

/** Seen alike from both sides. */
const twoSided = (bsdf: Element, id: string): WrittenMaterial => ({
  bsdf: plugin('bsdf', 'twosided', [bsdf], { id }),
  needsPython: false,
});

/** Mitsuba's own facets, which are masked one by one. */
const facets = (alpha: number) => [string('distribution', 'ggx'), float('alpha', alpha)];

function opaque(m: Material, id: string): WrittenMaterial {
  const { type, baseColor, roughness, reflectivity, metallic, ior, conductor, masking } = m;
  const alpha = roughness ** 2;
  if (reflectivity === 0 && type === 'diffuse')
    return twoSided(plugin('bsdf', 'diffuse', [rgb('reflectance', baseColor)]), id);
  const measured = [...conductor.eta, ...conductor.k].some((x) => x > 0);
  if (reflectivity === 0 && type === 'conductor' && (alpha < SMOOTH || masking === 'separable')) {
    const fresnel = measured
      ? [rgb('eta', conductor.eta), rgb('k', conductor.k)]
      : [string('material', 'none'), rgb('specular_reflectance', baseColor)];
    const metal = alpha < SMOOTH ? plugin('bsdf', 'conductor', fresnel) : plugin('bsdf', 'roughconductor', [...facets(alpha), ...fresnel]); // biome-ignore format: one expression
    return twoSided(metal, id);
  }
  const kind = type === 'conductor' ? (measured ? 'conductor' : 'tint') : type === 'diffuse' ? 'diffuse' : 'gltf';
  const parameters = [
    string('kind', kind),
    numbers('base_color', baseColor),
    float('alpha', alpha),
    float('metallic', metallic),
    float('ior', ior),
    float('reflectivity', reflectivity),
    numbers('eta', conductor.eta),
    numbers('k', conductor.k),
  ];
  return { bsdf: plugin('bsdf', 'mirrorball_opaque', parameters, { id }), needsPython: true };
}

function glass(m: Material, id: string, thing: string, report: ExportReport): WrittenMaterial {
  const { roughness, ior, thin, reflectivity } = m;
  const alpha = roughness ** 2;
  if (reflectivity > 0) report.add('lost', 'Glass has no mirror layer ("reflectivity") there.', thing);
  const indices = [float('int_ior', ior), float('ext_ior', 1)];
  if (thin || alpha < SMOOTH) {
    if (thin && alpha >= SMOOTH) report.add('changed', 'A thin pane is smooth there.', thing);
    const bsdf = plugin('bsdf', thin ? 'thindielectric' : 'dielectric', indices, { id });
    return { bsdf, needsPython: false, ...inside(m) };
  }
  if (m.masking === 'separable')
    return {
      bsdf: plugin('bsdf', 'roughdielectric', [...facets(alpha), ...indices], { id }),
      needsPython: false,
      ...inside(m),
    };
  const bsdf = plugin('bsdf', 'mirrorball_glass', [float('alpha', alpha), float('ior', ior)], { id });
  return { bsdf, needsPython: true, ...inside(m) };
}

/** Beer and Lambert: what is left after a distance d is attenuationColor ^ (d / attenuationDistance). */
function inside({ attenuationColor, attenuationDistance, thin }: Material): { medium?: Element } {
  if (thin || attenuationDistance === 0 || attenuationColor.every((x) => x === 1)) return {};
  const sigma = attenuationColor.map((x) => -Math.log(Math.max(x, 1e-6)) / attenuationDistance);
  // Mitsuba takes no colour above 1 here, and multiplies by `scale`.
  const most = Math.max(...sigma, 1);
  const medium = plugin('medium', 'homogeneous', [rgb('albedo', [0, 0, 0]), rgb('sigma_t', sigma.map((x) => x / most)), float('scale', most), boolean('sample_emitters', true)], { name: 'interior' }); // biome-ignore format: one expression
  return { medium };
}
