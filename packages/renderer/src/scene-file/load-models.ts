/** The models of a scene: what their files have becomes part of it. */
import { importGltf } from '../gltf/index.ts';
import type { GltfOptions } from '../gltf/types.ts';
import { SCENE_LIMITS } from '../scene/limits.ts';
import { type LoadedMesh, MESH_ENDINGS } from '../scene/mesh.ts';
import { crowdFault } from '../scene/mesh-fault.ts';
import { lacksModel, type ModelSource } from '../scene/models.ts';
import type { Scene } from '../scene/scene.ts';
import { withVariant } from '../scene/variants.ts';
import { listOfNames } from './check-references.ts';
import { mergeModel } from './merge-model.ts';
import { nearest, type Problem, type ProblemList, quote, sentence } from './problem.ts';
import type { ReadFile } from './read-file.ts';

type ImportedModel =
  | { readonly ok: true; readonly scene: Scene; readonly notes: readonly string[] }
  | { readonly ok: false; readonly problems: readonly Problem[] };

/** By the ending of the file's name. */
async function importModel(bytes: Uint8Array, file: string, options: GltfOptions): Promise<ImportedModel> {
  if (MESH_FILE.test(file)) {
    const { meshScene } = await import('../mesh-model/mesh-scene.ts');
    return meshScene(bytes, file, options.readFile, options.decoder);
  }
  const imported = await importGltf(bytes, options);
  return imported.ok ? { ...imported, notes: imported.report.entries.map(({ message }) => message) } : imported;
}
const MESH_FILE = new RegExp(`\\.(${MESH_ENDINGS.join('|')})$`, 'i');

/** The scene with all that its models have; those that cannot be had are left out, with problems. Adds to `notes` what was changed. */
export async function loadModels(
  scene: Scene,
  readFile: ReadFile,
  problems: ProblemList,
  notes: string[],
  options: Pick<GltfOptions, 'decoder'> = {},
): Promise<Scene> {
  let whole = scene;
  for (const [name, source] of Object.entries(scene.models ?? {})) {
    if (!lacksModel(source)) continue;
    const model = await readModel(name, source, readFile, problems, notes, options);
    if (model) whole = mergeModel(whole, name, source, model);
  }
  checkCrowd(whole, problems);
  return whole;
}

async function readModel(
  name: string,
  { file, variant }: ModelSource,
  readFile: ReadFile,
  problems: ProblemList,
  notes: string[],
  options: Pick<GltfOptions, 'decoder'>,
): Promise<Scene | null> {
  const refuse = (reason: string, message: string) =>
    problems.add(['models', name, 'file'], `the file ${quote(file)}, which cannot be used (${reason.replace(/\.$/, '')})`, 'a model that can be read', message); // biome-ignore format: one sentence
  try {
    const result = await importModel(await readFile(file), file, {
      ...options,
      name,
      camera: 'frame',
      environment: 'none',
      readFile: (beside) => readFile(`${file.slice(0, file.lastIndexOf('/') + 1)}${beside}`),
    });
    if (!result.ok) {
      for (const { path, found, message } of result.problems)
        refuse(`${path === '' ? '' : `${path}: `}${found}`, `The model ${quote(name)} cannot be used. ${message}`);
      return null;
    }
    notes.push(...result.notes.map((message) => `The model ${quote(name)}: ${message}`));
    return variant === undefined ? result.scene : chooseVariant(name, result.scene, variant, problems);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    refuse(reason, `The model ${quote(name)} cannot be read from ${quote(file)}: ${sentence(reason)}`);
    return null;
  }
}

function chooseVariant(name: string, model: Scene, variant: string, problems: ProblemList): Scene | null {
  const names = Object.keys(model.variants ?? {});
  if (names.includes(variant)) return withVariant(model, variant);
  const listed = names.length === 0 ? 'no "variant", as the file has none' : listOfNames(names, '');
  const meant = nearest(variant, names);
  const hint = meant === null ? '' : ` Did you mean ${quote(meant)}?`;
  const message = `The model ${quote(name)} has no variant ${quote(variant)}; expected ${listed}.${hint}`;
  problems.add(['models', name, 'variant'], `the name ${quote(variant)}`, listed, message);
  return null;
}

/** What a scene may have in all. */
function checkCrowd({ lights, shapes, meshes = {} }: Scene, problems: ProblemList): void {
  const count = (what: string, number: number, most: number) => {
    if (number > most)
      problems.add(['models'], `${number} ${what} together with those of the scene`, `at most ${most}`);
  };
  count('lights', Object.keys(lights).length, SCENE_LIMITS.light);
  count('placed meshes', Object.keys(shapes).length, SCENE_LIMITS.mesh);
  const fault = crowdFault(Object.values(meshes).filter((mesh): mesh is LoadedMesh => mesh.data !== undefined));
  if (fault !== null) problems.add(['models'], fault, 'fewer of them', `The meshes have ${fault}.`);
}
