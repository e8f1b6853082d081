/** What the importer is asked and what it answers. */
import type { Scene } from '../scene/scene.ts';
import type { Problem } from '../scene-file/problem.ts';
import type { ReadFile } from '../scene-file/read-file.ts';
import type { ImageDecoder } from './images/decoder.ts';
import type { ImportReport } from './report.ts';

export interface GltfOptions {
  /** What the scene is called when the file does not say. Default: "model". */
  readonly name?: string;
  /** Gives the content of files beside the glTF file: names from its folder on, with "/" between folders, never out of it. */
  readonly readFile?: ReadFile;
  /** Makes pixels of images. Default: what a browser offers; elsewhere PNG alone. */
  readonly decoder?: ImageDecoder;
  /** `file`: the file's first camera, when it has one. `frame`: one that shows everything. Default: `file`. */
  readonly camera?: 'file' | 'frame';
  /** `auto`: a studio when the file has neither lights nor lamps. Default: `auto`. */
  readonly environment?: 'auto' | 'studio' | 'none';
  /** Called now and then. */
  readonly onProgress?: (progress: GltfProgress) => void;
  readonly signal?: AbortSignal;
}

export interface GltfProgress {
  /** `files`: reading them. `numbers`: unpacking arrays. `meshes`, `images`: making these. */
  readonly step: 'files' | 'numbers' | 'meshes' | 'images';
  readonly done: number;
  readonly total: number;
}

export type GltfImport =
  | { readonly ok: true; readonly scene: Scene; readonly report: ImportReport }
  | { readonly ok: false; readonly problems: readonly Problem[] };
