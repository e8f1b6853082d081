/** The bytes that a file stands on: its binary chunk, data URIs, and files beside it. */

import { type ProblemList, quote } from '../scene-file/problem.ts';
import type { ReadFile } from '../scene-file/read-file.ts';
import { dataUriBytes, isDataUri, readDataUri } from './base64.ts';
import { fileNameOf } from './file-name.ts';
import { extensionOf, type Gltf } from './json.ts';
import { GLTF_LIMITS } from './limits.ts';
import { addProblem, type Path } from './problems.ts';

export interface Sources {
  readonly binary: Uint8Array | null;
  /** Without it, files beside the glTF file are a problem. */
  readonly readFile?: ReadFile | undefined;
  readonly problems: ProblemList;
}

/** The content of a data URI or of a file; null when a problem has been added. */
export async function readUri(uri: string, path: Path, { readFile, problems }: Sources): Promise<Uint8Array | null> {
  const refuse = (found: string, allowed: string): null => {
    addProblem(problems, path, found, allowed);
    return null;
  };
  if (isDataUri(uri)) {
    if (dataUriBytes(uri) > GLTF_LIMITS.geometryBytes) return refuse('a data URI that is too long', 'at most 2 GiB');
    const data = readDataUri(uri);
    return typeof data === 'string' ? refuse(data, 'a data URI in base64') : data.bytes;
  }
  const file = fileNameOf(uri);
  if ('fault' in file)
    return refuse(`${file.fault}, ${quote(uri)}`, 'the name of a file in the folder of the glTF file or below');
  if (!readFile) return refuse(`the file ${quote(file.name)}, which has not been given`, 'files that come together');
  try {
    return await readFile(file.name);
  } catch (error) {
    const reason = (error instanceof Error ? error.message : String(error)).replace(/\.$/, '');
    return refuse(`the file ${quote(file.name)}, which cannot be read (${reason})`, 'a file that can be read');
  }
}

/** The bytes of each buffer; null for those that only stand for what a decoder will make. */
export async function readBuffers(json: Gltf, sources: Sources): Promise<(Uint8Array | null)[]> {
  const buffers = json.buffers ?? [];
  const contents = await Promise.all(buffers.map((buffer, i) => readBuffer(buffer, i, sources)));
  buffers.forEach(({ byteLength }, i) => {
    const length = contents[i]?.length;
    if (length === undefined || length >= byteLength) return;
    addProblem(
      sources.problems,
      ['buffers', i, 'byteLength'],
      `${byteLength} bytes, where there are ${length}`,
      `at most ${length}`,
    );
  });
  return contents;
}

async function readBuffer(
  buffer: NonNullable<Gltf['buffers']>[number],
  i: number,
  sources: Sources,
): Promise<Uint8Array | null> {
  if (buffer.uri !== undefined) return readUri(buffer.uri, ['buffers', i, 'uri'], sources);
  if (i === 0 && sources.binary !== null) return sources.binary;
  const fallback = extensionOf<{ fallback?: boolean }>(buffer, 'EXT_meshopt_compression')?.fallback === true;
  if (!fallback)
    addProblem(sources.problems, ['buffers', i], 'no content', 'a "uri", or, for the first of a GLB, a binary chunk');
  return null;
}
