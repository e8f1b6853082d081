/** A file of any kind that can be shown → a scene to show, or everything that is wrong with it: what the command line and the page share. */
import { importGltf } from '../gltf/index.ts';
import type { ImportReport, ReportEntry } from '../gltf/report.ts';
import type { GltfOptions } from '../gltf/types.ts';
import { meshScene } from '../mesh-model/mesh-scene.ts';
import { countsOf } from '../scene/counts.ts';
import { MESH_ENDINGS } from '../scene/mesh.ts';
import type { Scene } from '../scene/scene.ts';
import { loadFiles } from '../scene-file/load-files.ts';
import { parseScene } from '../scene-file/parse-scene.ts';
import type { Problem } from '../scene-file/problem.ts';
import { endingOf, nameOf } from './file-set.ts';

/** What `readFile` is given: paths from the folder of the file on. */
export type OpenOptions = Omit<GltfOptions, 'name'>;

export type OpenedModel =
  | { readonly ok: true; readonly scene: Scene; readonly report: ImportReport }
  | { readonly ok: false; readonly problems: readonly Problem[] };

const GLTF_ENDINGS: readonly string[] = ['glb', 'gltf'];

/** Whether its content is a model by itself; anything else is taken for a scene file. */
export const isModelName = (path: string): boolean =>
  GLTF_ENDINGS.includes(endingOf(path)) || (MESH_ENDINGS as readonly string[]).includes(endingOf(path));

/** Rejects with the signal's reason when that is aborted, and never for what files have. */
export async function openModel(bytes: Uint8Array, path: string, options: OpenOptions = {}): Promise<OpenedModel> {
  const ending = endingOf(path);
  options.onProgress?.({ step: 'files', done: 0, total: 1 });
  if (GLTF_ENDINGS.includes(ending))
    return importGltf(bytes, { ...options, name: nameOf(path).replace(/\.[^.]*$/, '') });
  options.onProgress?.({ step: 'meshes', done: 0, total: 1 });
  if ((MESH_ENDINGS as readonly string[]).includes(ending))
    return withReport(await meshScene(bytes, path, options.readFile, options.decoder));
  return openScene(new TextDecoder().decode(bytes), options);
}

async function openScene(text: string, { readFile, decoder }: OpenOptions): Promise<OpenedModel> {
  const parsed = parseScene(text);
  if (!parsed.ok) return parsed;
  const missing = async (): Promise<never> => {
    throw new Error('it has not been given');
  };
  return withReport(await loadFiles(parsed.scene, readFile ?? missing, { decoder }));
}

type Read =
  | { readonly ok: true; readonly scene: Scene; readonly notes: readonly string[] }
  | { readonly ok: false; readonly problems: readonly Problem[] };

function withReport(read: Read): OpenedModel {
  if (!read.ok) return read;
  const entries = read.notes.map(
    (message): ReportEntry => ({ kind: 'changed', what: 'file', message, places: [], count: 1 }),
  );
  return { ok: true, scene: read.scene, report: { entries, counts: countsOf(read.scene) } };
}
