/** Materials as Mitsuba's BSDFs: its own where one is equal, else those of python.ts. */

import type { Color, Material } from '../../scene/scene.ts';
import type { TextureUse } from '../../scene/textures.ts';
import type { ExportReport } from '../export-report.ts';
import { lacksLayers } from '../undone-layers.ts';
import { ATTRIBUTES, type Carried, isCut } from './carried.ts';
import type { Meaning, TextureWriter } from './textures.ts';
import { boolean, type Element, float, numbers, plugin, rgb, string } from './xml.ts';

/** Rougher than this is GGX, smoother a mirror, as the kernels have it. */
const SMOOTH = 1e-3;

export interface WrittenMaterial {
  readonly bsdf: Element;
  /** The inside of glass that absorbs, if it does. */
  readonly medium?: Element;
  /** The light that it sends out, if it does. */
  readonly emitter?: Element;
  /** Whether rays may go through as if nothing were there. */
  readonly isCut: boolean;
}

/** Of one material on meshes that carry the same. */
export class MaterialWriter {
  readonly #m: Material;
  readonly #carried: Carried;
  readonly #textures: TextureWriter;
  readonly #report: ExportReport;
  readonly #thing: string;

  constructor(name: string, material: Material, carried: Carried, textures: TextureWriter, report: ExportReport) {
    this.#m = material;
    this.#carried = carried;
    this.#textures = textures;
    this.#report = report;
    this.#thing = `material "${name}"`;
  }

  write(id: string): WrittenMaterial {
    const m = this.#m;
    for (const layer of lacksLayers(m)) this.#lost(`Mitsuba's file has no ${layer}.`);
    if (m.energyCompensation && m.type !== 'diffuse' && m.type !== 'dielectric')
      this.#lost('Light that single scattering loses is not given back ("energyCompensation").');
    if (m.normalTexture && this.#carried.frame === null) this.#lost('Normal maps of meshes at several places, or without tangents, are left out.'); // biome-ignore format: one sentence
    const whole = m.unlit ? twoSided(BLACK) : m.type === 'dielectric' ? this.#glass() : this.#opaque();
    const presence = this.#presence();
    const emitter = this.#emitter();
    if (presence && emitter) this.#report.add('changed', 'What is cut out of a lamp shines there.', this.#thing);
    const cut = presence ? plugin('bsdf', 'mask', [presence, whole]) : whole;
    return {
      bsdf: { ...cut, attributes: { ...cut.attributes, id } },
      ...(m.type === 'dielectric' && !m.unlit && inside(m)),
      ...(emitter && { emitter }),
      isCut: presence !== null,
    };
  }

  #lost(message: string): void {
    this.#report.add('lost', message, this.#thing);
  }

  #opaque(): Element {
    const { type, roughness, reflectivity, conductor, masking } = this.#m;
    const alpha = roughness ** 2;
    const bends = this.#carried.frame !== null;
    const isPlain = reflectivity === 0 && !bends;
    if (isPlain && type === 'diffuse') return twoSided(plugin('bsdf', 'diffuse', [this.#base('reflectance', rgb)]));
    const measured = [...conductor.eta, ...conductor.k].some((x) => x > 0);
    const varies = this.#m.metallicRoughnessTexture !== undefined;
    if (isPlain && !varies && type === 'conductor' && (alpha < SMOOTH || masking === 'separable')) {
      const fresnel = measured
        ? [rgb('eta', conductor.eta), rgb('k', conductor.k)]
        : [string('material', 'none'), this.#base('specular_reflectance', rgb)];
      return twoSided(alpha < SMOOTH ? plugin('bsdf', 'conductor', fresnel) : plugin('bsdf', 'roughconductor', [...facets(alpha), ...fresnel])); // biome-ignore format: one expression
    }
    if (type === 'conductor' && masking === 'separable' && alpha >= SMOOTH)
      this.#report.add('changed', 'Masking is height-correlated there.', this.#thing);
    const kind = type === 'conductor' ? (measured ? 'conductor' : 'tint') : type === 'diffuse' ? 'diffuse' : 'gltf';
    return plugin('bsdf', 'mirrorball_opaque', [
      string('kind', kind),
      this.#base('base_color', numbers),
      float('alpha', alpha),
      float('metallic', this.#m.metallic),
      float('ior', this.#m.ior),
      float('reflectivity', reflectivity),
      numbers('eta', conductor.eta),
      numbers('k', conductor.k),
      ...this.#highlights(kind),
      ...this.#bumps(),
    ]);
  }

  /** What varies in reflections. */
  #highlights(kind: string): Element[] {
    const { metallicRoughnessTexture, specularLobe } = this.#m;
    const rough = metallicRoughnessTexture ? [this.#texture('metallic_roughness', metallicRoughnessTexture, 'numbers')] : []; // biome-ignore format: one line
    if (kind !== 'gltf' || !specularLobe) return rough;
    const { weight, color, weightTexture, colorTexture } = specularLobe;
    return [
      ...rough,
      float('specular_weight', weight),
      numbers('specular_color', color),
      ...(weightTexture ? [this.#texture('specular_weight_map', weightTexture, 'opacity')] : []),
      ...(colorTexture ? [this.#texture('specular_color_map', colorTexture, 'color')] : []),
    ];
  }

  #bumps(): Element[] {
    const { normalTexture } = this.#m;
    const { frame } = this.#carried;
    if (frame === null || !normalTexture) return [];
    return [
      this.#texture('normal_map', normalTexture, 'numbers'),
      float('normal_scale', normalTexture.normalScale ?? 1),
      numbers('normals_into_world', frame),
      attribute('own_normal', ATTRIBUTES.normal),
      attribute('own_tangent', ATTRIBUTES.tangent),
      attribute('own_hand', ATTRIBUTES.hand),
    ];
  }

  #glass(): Element {
    const { roughness, ior, thin, reflectivity, masking, normalTexture, metallicRoughnessTexture } = this.#m;
    const alpha = roughness ** 2;
    if (reflectivity > 0) this.#lost('Glass has no mirror layer ("reflectivity") there.');
    if (normalTexture ?? metallicRoughnessTexture) this.#lost('Glass has no textures there.');
    const indices = [float('int_ior', ior), float('ext_ior', 1)];
    if (thin || alpha < SMOOTH) {
      if (thin && alpha >= SMOOTH) this.#report.add('changed', 'A thin pane is smooth there.', this.#thing);
      return plugin('bsdf', thin ? 'thindielectric' : 'dielectric', indices);
    }
    if (masking === 'separable') return plugin('bsdf', 'roughdielectric', [...facets(alpha), ...indices]);
    return plugin('bsdf', 'mirrorball_glass', [float('alpha', alpha), float('ior', ior)]);
  }

  /** The base colour: as a constant by `plain`, else a texture. */
  #base(name: string, plain: (name: string, color: Color) => Element): Element {
    const { baseColor, baseColorTexture } = this.#m;
    return this.#product(name, baseColor, baseColorTexture, this.#carried.colors) ?? plain(name, baseColor);
  }

  /** A colour times a texture times the colours of vertices; Mitsuba's own where there is one of these alone. Null: it is the colour. */
  #product(name: string, factor: Color, use: TextureUse | undefined, colored: boolean): Element | null {
    if (!use && !colored) return null;
    const isAlone = factor.every((x) => x === 1);
    if (isAlone && !use) return attribute(name, ATTRIBUTES.colors);
    if (isAlone && !colored) return this.#texture(name, use!, 'color');
    return plugin('texture', 'mirrorball_product', [
      numbers('factor', factor),
      ...(use ? [this.#texture('map', use, 'color')] : []),
      ...(colored ? [attribute('colors', ATTRIBUTES.colors)] : []),
    ], { name }); // biome-ignore format: one list
  }

  #texture(name: string, use: TextureUse, meaning: Meaning): Element {
    if (use.uvSet !== 1) return this.#textures.bitmap(name, use, meaning);
    const parts = [this.#textures.bitmap('map', use, meaning), attribute('place', ATTRIBUTES.secondSet)];
    return plugin('texture', 'mirrorball_second_set', parts, { name });
  }

  /** How much of the surface is there; null: all of it. */
  #presence(): Element | null {
    const m = this.#m;
    const { opacity = 1, alphaMode, alphaCutoff = 0.5, baseColorTexture, doubleSided = true } = m;
    if (!isCut(m) && doubleSided) return null;
    const map = isCut(m) && baseColorTexture ? [this.#texture('map', baseColorTexture, 'opacity')] : [];
    const colors = isCut(m) && this.#carried.opacity ? [attribute('colors', ATTRIBUTES.opacity)] : [];
    if (alphaMode === 'blend' && doubleSided) {
      if (map.length + colors.length === 0) return float('opacity', opacity);
      if (opacity === 1 && colors.length === 0) return this.#texture('opacity', baseColorTexture!, 'opacity');
      if (opacity === 1 && map.length === 0) return attribute('opacity', ATTRIBUTES.opacity);
    }
    return plugin('texture', 'mirrorball_presence', [
      float('factor', isCut(m) ? opacity : 1),
      float('cutoff', alphaMode === 'mask' ? alphaCutoff : -1),
      boolean('one_sided', !doubleSided),
      ...map,
      ...colors,
    ], { name: 'opacity' }); // biome-ignore format: one list
  }

  #emitter(): Element | null {
    const { unlit, baseColor, baseColorTexture, emission, emissionStrength = 1, emissionTexture } = this.#m;
    const radiance = (unlit ? baseColor : emission.map((x) => x * emissionStrength)) as unknown as Color;
    if (radiance.every((x) => x === 0)) return null;
    const use = unlit ? baseColorTexture : emissionTexture;
    // Mitsuba asks for the light of a place without saying which triangle it is on, which attributes need.
    const varies = (unlit && this.#carried.colors) || use?.uvSet === 1;
    if (varies) this.#lost('Light does not vary by colours of vertices, nor by a second set of coordinates.');
    const map = use && use.uvSet !== 1 ? [this.#texture('map', use, 'color')] : [];
    // What varies Mitsuba samples by texture coordinates, which must cover the shape once; this one it samples by area.
    const light = plugin('texture', 'mirrorball_product', [numbers('factor', radiance), ...map, boolean('sampled_by_area', true)], { name: 'radiance' }); // biome-ignore format: one expression
    return plugin('emitter', 'area', [map.length > 0 ? light : rgb('radiance', radiance)]);
  }
}

const attribute = (name: string, of: string): Element => plugin('texture', 'mesh_attribute', [string('name', of)], { name }); // biome-ignore format: one expression

const BLACK = plugin('bsdf', 'diffuse', [rgb('reflectance', [0, 0, 0])]);

/** Seen alike from both sides. */
const twoSided = (bsdf: Element): Element => plugin('bsdf', 'twosided', [bsdf]);

/** Mitsuba's own facets, which are masked one by one. */
const facets = (alpha: number) => [string('distribution', 'ggx'), float('alpha', alpha)];

/** Beer and Lambert: what is left after a distance d is attenuationColor ^ (d / attenuationDistance). */
function inside({ attenuationColor, attenuationDistance, thin }: Material): { medium?: Element } {
  if (thin || attenuationDistance === 0 || attenuationColor.every((x) => x === 1)) return {};
  const sigma = attenuationColor.map((x) => -Math.log(Math.max(x, 1e-6)) / attenuationDistance);
  // Mitsuba takes no colour above 1 here, and multiplies by `scale`.
  const most = Math.max(...sigma, 1);
  const medium = plugin('medium', 'homogeneous', [rgb('albedo', [0, 0, 0]), rgb('sigma_t', sigma.map((x) => x / most)), float('scale', most), boolean('sample_emitters', true)], { name: 'interior' }); // biome-ignore format: one expression
  return { medium };
}
