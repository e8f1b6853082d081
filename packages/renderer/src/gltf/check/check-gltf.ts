/**
 * Looks through a file's JSON before anything is read by it: form, spans, memory, hierarchy, and what things say of each other. The
 * library that reads afterwards throws at the first mistake, or makes what is asked for; after this it finds nothing to throw at.
 */
import { type ProblemList, quote } from '../../scene-file/problem.ts';
import type { Gltf } from '../json.ts';
import { addProblem, describe } from '../problems.ts';
import { isObject } from './form.ts';
import { gltfForm } from './gltf-forms.ts';
import { checkHierarchy } from './hierarchy.ts';
import { checkRelations } from './relations.ts';
import { checkSpans } from './spans.ts';

/** Extensions that may be required. */
export const SUPPORTED_EXTENSIONS: readonly string[] = [
  'EXT_mesh_gpu_instancing',
  'EXT_meshopt_compression',
  'EXT_texture_avif',
  'EXT_texture_webp',
  'KHR_animation_pointer',
  'KHR_draco_mesh_compression',
  'KHR_lights_punctual',
  'KHR_materials_anisotropy',
  'KHR_materials_clearcoat',
  'KHR_materials_diffuse_transmission',
  'KHR_materials_dispersion',
  'KHR_materials_emissive_strength',
  'KHR_materials_ior',
  'KHR_materials_iridescence',
  'KHR_materials_pbrSpecularGlossiness',
  'KHR_materials_sheen',
  'KHR_materials_specular',
  'KHR_materials_transmission',
  'KHR_materials_unlit',
  'KHR_materials_variants',
  'KHR_materials_volume',
  'KHR_mesh_quantization',
  'KHR_node_visibility',
  'KHR_texture_basisu',
  'KHR_texture_transform',
];

/** The JSON with what types say of it, or null when problems have been added. */
export function checkGltf(json: unknown, problems: ProblemList): Gltf | null {
  if (!checkVersion(json, problems)) return null;
  const root = json as Record<string, unknown>;
  const listOf = (list: string): unknown => {
    if (list === 'lights') return at(root, 'extensions', 'KHR_lights_punctual', 'lights');
    if (list === 'variants') return at(root, 'extensions', 'KHR_materials_variants', 'variants');
    return at(root, list);
  };
  const count = (list: string): number => {
    const found = listOf(list);
    return Array.isArray(found) ? found.length : 0;
  };
  gltfForm(json, [], { problems, count });
  if (!problems.isEmpty) return null;
  const gltf = json as Gltf;
  checkRequired(gltf, problems);
  checkSpans(gltf, problems);
  checkHierarchy(gltf, problems);
  checkRelations(gltf, problems);
  return problems.isEmpty ? gltf : null;
}

const at = (value: unknown, ...keys: readonly string[]): unknown =>
  keys.reduce((part, key) => (isObject(part) && Object.hasOwn(part, key) ? part[key] : undefined), value);

function checkVersion(json: unknown, problems: ProblemList): boolean {
  if (!isObject(json)) {
    addProblem(problems, [], describe(json), 'an object');
    return false;
  }
  const version = at(json, 'asset', 'version');
  const least = at(json, 'asset', 'minVersion') ?? '2.0';
  if (typeof version === 'string' && /^2\.\d+$/.test(version) && least === '2.0') return true;
  if (version === undefined) addProblem(problems, ['asset', 'version'], 'no version', 'a glTF file, version "2.0"');
  else if (least !== '2.0') addProblem(problems, ['asset', 'minVersion'], describe(least), '"2.0"');
  else addProblem(problems, ['asset', 'version'], describe(version), '"2.0"');
  return false;
}

function checkRequired({ extensionsRequired = [] }: Gltf, problems: ProblemList): void {
  extensionsRequired.forEach((name, i) => {
    if (SUPPORTED_EXTENSIONS.includes(name)) return;
    addProblem(problems, ['extensionsRequired', i], `the extension ${quote(name)}, without which it cannot be read`, `extensions that Mirrorball knows: ${SUPPORTED_EXTENSIONS.join(', ')}`); // biome-ignore format: one sentence
  });
}
