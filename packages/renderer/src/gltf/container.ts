/** The outside of a glTF file: JSON text, or a GLB with JSON and binary chunks. */
import { readJsonText } from '../scene-file/json-text.ts';
import { type ProblemList, quote } from '../scene-file/problem.ts';
import { GLTF_LIMITS } from './limits.ts';
import { addProblem } from './problems.ts';

export interface Container {
  readonly json: unknown;
  /** The binary chunk of a GLB. */
  readonly binary: Uint8Array | null;
}

const MAGIC = 0x46546c67; // "glTF"
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;

/** Whether these bytes begin as a GLB does. */
export const isGlb = (bytes: Uint8Array): boolean => bytes.length >= 4 && viewOf(bytes).getUint32(0, true) === MAGIC;

/** What people give for a model by mistake: what a server or a version control system had in its place. */
function strangerOf(bytes: Uint8Array): string | null {
  if (bytes.length === 0) return 'an empty file';
  const start = new TextDecoder().decode(bytes.subarray(0, 64)).trimStart().toLowerCase();
  if (start.startsWith('version https://git-lfs')) return 'a pointer of Git LFS, not the file that it stands for';
  return start.startsWith('<!doctype html') || start.startsWith('<html') ? 'a web page' : null;
}

const viewOf = (bytes: Uint8Array): DataView => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

export function readContainer(bytes: Uint8Array, problems: ProblemList): Container | null {
  const stranger = strangerOf(bytes);
  if (stranger !== null) {
    addProblem(problems, [], stranger, 'a GLB, which begins with "glTF", or JSON');
    return null;
  }
  if (!isGlb(bytes)) {
    const json = readJson(bytes, problems);
    return json === undefined ? null : { json, binary: null };
  }
  const chunks = readChunks(bytes, problems);
  if (chunks === null) return null;
  const json = readJson(chunks.json, problems);
  return json === undefined ? null : { json, binary: chunks.binary };
}

/** Lengths are held against what is there before anything is read by them. */
function readChunks(bytes: Uint8Array, problems: ProblemList): { json: Uint8Array; binary: Uint8Array | null } | null {
  const refuse = (found: string, allowed: string): null => {
    addProblem(problems, [], found, allowed);
    return null;
  };
  if (bytes.length < 20) return refuse(`${bytes.length} bytes`, 'a GLB of at least 20 bytes');
  const view = viewOf(bytes);
  const [version, length] = [view.getUint32(4, true), view.getUint32(8, true)];
  if (version !== 2) return refuse(`the GLB version ${version}`, 'version 2');
  if (length > bytes.length)
    return refuse(`${bytes.length} bytes, so it is cut off`, `the ${length} bytes that its head tells`);
  let json: Uint8Array | null = null;
  let binary: Uint8Array | null = null;
  for (let at = 12; at + 8 <= length; ) {
    const [size, type] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    const left = length - at - 8;
    if (size > left) return refuse(`a chunk of ${size} bytes where ${left} are left`, 'chunks that end with the file');
    const content = bytes.subarray(at + 8, at + 8 + size);
    if (json === null && type !== JSON_CHUNK)
      return refuse('a GLB that does not begin with JSON', 'a first chunk of type JSON');
    if (type === JSON_CHUNK) json ??= content;
    else if (type === BINARY_CHUNK) binary ??= content;
    at += 8 + size;
  }
  return json === null ? refuse('no chunk', 'a first chunk of type JSON') : { json, binary };
}

function readJson(bytes: Uint8Array, problems: ProblemList): unknown {
  if (bytes.length > GLTF_LIMITS.jsonBytes) {
    addProblem(problems, [], `${bytes.length} bytes of JSON`, `at most ${GLTF_LIMITS.jsonBytes}`);
    return undefined;
  }
  const text = textOf(bytes);
  if (text === null) {
    addProblem(problems, [], 'bytes that are no text', 'a GLB, or JSON as UTF-8');
    return undefined;
  }
  try {
    return JSON.parse(text) as unknown;
  } catch {
    const read = readJsonText(text);
    const { at, expected } = read.ok ? { at: null, expected: 'text that this browser can read' } : read;
    const found = at === null || at.excerpt === '' ? 'nothing more' : quote(at.excerpt);
    const place = at === null ? '' : ` at line ${at.line}, column ${at.column}`;
    addProblem(problems, [], `${found}${place}`, `JSON, here ${expected}`);
    return undefined;
  }
}

function textOf(bytes: Uint8Array): string | null {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return null;
  }
}
