/** Materials as glTF has them: metallic-roughness and the Khronos extensions. */
import { MATERIAL_FIELDS, TEXTURE_FIELDS } from '../../gltf/pointers.ts';
import { MATTE } from '../../scene/materials.ts';
import type { Material, Scene } from '../../scene/scene.ts';
import type { NormalTextureUse, TextureUse } from '../../scene/textures.ts';
import type { ExportReport } from '../export-report.ts';
import type { GltfFile, Json } from './gltf-file.ts';
import type { TextureWriter } from './textures.ts';

/** What stands at the end of a path of keys, or undefined. */
const valueAt = (thing: unknown, path: string): unknown =>
  path.split('/').reduce<unknown>((part, key) => (part as Record<string, unknown> | undefined)?.[key], thing);

export class MaterialWriter {
  readonly #file: GltfFile;
  readonly #scene: Scene;
  readonly #textures: TextureWriter;
  readonly #report: ExportReport;
  readonly #written = new Map<string, number>();

  constructor(file: GltfFile, scene: Scene, textures: TextureWriter, report: ExportReport) {
    this.#file = file;
    this.#scene = scene;
    this.#textures = textures;
    this.#report = report;
  }

  /** The place in the file of the material with this name, written when it is first asked for. */
  place(name: string): number {
    const known = this.#written.get(name);
    if (known !== undefined) return known;
    const place = this.#file.add('materials', this.#write(name, this.#scene.materials[name]!));
    this.#written.set(name, place);
    return place;
  }

  places(): ReadonlyMap<string, number> {
    return this.#written;
  }

  /** A lamp's: black, and shining. */
  lamp(name: string, radiance: readonly number[]): number {
    return this.#file.add('materials', this.#fields({ ...BLACK, emission: radiance as Material['emission'] }, name));
  }

  #write(name: string, material: Material): Json {
    const thing = `material "${name}"`;
    if (material.reflectivity > 0) this.#report.add('lost', 'glTF has no mirror layer ("reflectivity").', thing);
    if (material.specular > 0)
      this.#report.add('lost', 'glTF has no highlight of the classic integrator ("specular").', thing);
    if (material.energyCompensation)
      this.#report.add('lost', 'glTF leaves to renderers what light is given back ("energyCompensation").', thing);
    if (material.masking === 'separable' && (material.type === 'conductor' || material.type === 'dielectric'))
      this.#report.add('changed', 'Masking is height-correlated there.', thing);
    return this.#fields(this.#asGltf(material, thing), name);
  }

  /** The nearest that metallic-roughness comes. */
  #asGltf(m: Material, thing: string): Material {
    switch (m.type) {
      case 'metallicRoughness':
        return m;
      case 'diffuse':
        // No specular reflection at all: Lambert is left.
        return { ...metallic(m), roughness: 1, specularLobe: { weight: 0, color: [1, 1, 1] } };
      case 'conductor': {
        const { eta, k } = m.conductor;
        const measured = [...eta, ...k].some((x) => x > 0);
        this.#report.add('changed', measured ? "A measured metal has its colour seen head-on, and Schlick's formula beyond." : 'A metal of one colour at every angle is whiter along the surface.', thing); // biome-ignore format: one sentence
        const facing = eta.map((n, c) => ((n - 1) ** 2 + k[c]! ** 2) / ((n + 1) ** 2 + k[c]! ** 2));
        return {
          ...metallic(m),
          metallic: 1,
          ...(measured && { baseColor: facing as unknown as Material['baseColor'] }),
        };
      }
      case 'dielectric':
        this.#report.add('changed', "Glass reflects by Schlick's formula there.", thing);
        return {
          ...metallic(m),
          baseColor: [1, 1, 1],
          transmission: { weight: 1 },
          ...(m.thin ? {} : { volume: { thickness: 1 } }),
        };
    }
  }

  #fields(m: Material, name: string): Json {
    const json: Json = { name, pbrMetallicRoughness: { baseColorFactor: [...m.baseColor, m.opacity ?? 1] } };
    const put = (path: string, value: unknown): void => {
      const extension = /^extensions\/([^/]+)\//.exec(path)?.[1];
      if (extension !== undefined) this.#file.extend(json, extension);
      const keys = path.split('/');
      const last = keys.pop()!;
      keys.reduce((part, key) => (part[key] ??= {}), json)[last] = value;
    };
    // Groups are there even when all they say are defaults.
    for (const [field, to] of Object.entries(TEXTURE_FIELDS)) {
      const use = valueAt(m, to) as NormalTextureUse | undefined;
      if (use) put(field, this.#use(use, field));
    }
    for (const [field, [target]] of Object.entries(MATERIAL_FIELDS)) {
      const { to, from, factor = 1 } = target!;
      const value = valueAt(m, to);
      if (from !== undefined || value === undefined || isDefault(to, value, m)) continue;
      put(field, typeof value === 'number' ? value / factor : value);
    }
    this.#looks(json, m);
    return json;
  }

  #use(use: NormalTextureUse, field: string): Json {
    const json: Json = { index: this.#textures.place(use.texture), ...(use.uvSet && { texCoord: use.uvSet }) };
    const transform = transformOf(use);
    if (transform) Object.assign(this.#file.extend(json, 'KHR_texture_transform'), transform);
    if (use.normalScale !== undefined && /ormalTexture$/.test(field)) json.scale = use.normalScale;
    return json;
  }

  /** What the tables do not have. */
  #looks(json: Json, m: Material): void {
    const brightest = Math.max(...m.emission);
    if (brightest > 1) {
      json.emissiveFactor = m.emission.map((x) => x / brightest);
      this.#file.extend(json, 'KHR_materials_emissive_strength').emissiveStrength =
        brightest * (m.emissionStrength ?? 1);
    }
    if (m.unlit) this.#file.extend(json, 'KHR_materials_unlit');
    if (m.alphaMode && m.alphaMode !== 'opaque') json.alphaMode = m.alphaMode.toUpperCase();
    if (m.doubleSided ?? true) json.doubleSided = true;
  }
}

/** Reflects nothing at all. */
const BLACK: Material = {
  ...MATTE,
  type: 'metallicRoughness',
  baseColor: [0, 0, 0],
  specularLobe: { weight: 0, color: [1, 1, 1] },
};

const metallic = (m: Material): Material => ({ ...m, type: 'metallicRoughness', metallic: 0 });

/** Whether glTF means the same when the field is left out. */
function isDefault(to: string, value: unknown, m: Material): boolean {
  if (to.startsWith('attenuation')) return m.volume === undefined || (to === 'attenuationDistance' && value === 0);
  if (to === 'ior') return value === 1.5;
  if (to === 'emission') return (value as readonly number[]).every((x) => x === 0) || Math.max(...m.emission) > 1;
  if (to === 'emissionStrength') return Math.max(...m.emission) > 1;
  if (to === 'alphaCutoff') return m.alphaMode !== 'mask';
  return to.endsWith('normalScale'); // beside the texture
}

function transformOf({ offset, rotation, scale }: TextureUse): Json | null {
  if (!offset && !rotation && !scale) return null;
  return {
    ...(offset && { offset }),
    ...(rotation && { rotation: (rotation * Math.PI) / 180 }),
    ...(scale && { scale }),
  };
}
