/** The numbers of a file, read by @gltf-transform: interleaved, sparse and compressed ones too. */
import { type Accessor, type GLTF, Logger, Verbosity, WebIO } from '@gltf-transform/core';
import { EXTMeshoptCompression, KHRDracoMeshCompression, KHRMeshQuantization } from '@gltf-transform/extensions';
import type { ProblemList } from '../scene-file/problem.ts';
import { readDracoHead } from './check/draco-head.ts';
import { meshoptOf } from './check/spans.ts';
import { checkSparsePlaces } from './check/sparse-places.ts';
import { loadDraco, loadMeshopt } from './decoders.ts';
import { extensionOf, type Gltf, WIDTHS } from './json.ts';
import { GLTF_LIMITS } from './limits.ts';
import { addProblem } from './problems.ts';

export type Numbers = Float32Array | Int8Array | Uint8Array | Int16Array | Uint16Array | Uint32Array;

/** One accessor's content. */
export interface Column {
  readonly numbers: Numbers;
  /** Of one element. */
  readonly width: number;
  readonly count: number;
  /** Whether whole numbers stand for shares of their range. */
  readonly normalized: boolean;
}

interface DracoJson {
  readonly bufferView: number;
}
const DRACO = 'KHR_draco_mesh_compression';
const MESHOPT = 'EXT_meshopt_compression';

/**
 * The accessors in the order of the file, or null when problems have been added. The library gets a file of its own, with nothing in it
 * but numbers: it has no say in what a scene is, and cannot stumble over the rest.
 */
export async function readAccessors(
  json: Gltf,
  buffers: readonly (Uint8Array | null)[],
  problems: ProblemList,
): Promise<Column[] | null> {
  const meshes = dracoMeshes(json);
  checkDraco(json, buffers, problems);
  checkSparsePlaces(json, buffers, problems);
  if (!problems.isEmpty) return null;
  const io = new WebIO().setLogger(new Logger(Verbosity.SILENT));
  const compressed = (json.bufferViews ?? []).some(meshoptOf);
  const used: string[] = ['KHR_mesh_quantization'];
  io.registerExtensions([KHRMeshQuantization]);
  if (compressed) {
    used.push(MESHOPT);
    io.registerExtensions([EXTMeshoptCompression]).registerDependencies({ 'meshopt.decoder': await loadMeshopt() });
  }
  if (meshes.length > 0) {
    used.push(DRACO);
    io.registerExtensions([KHRDracoMeshCompression]).registerDependencies({ 'draco3d.decoder': await loadDraco() });
  }
  const resources: Record<string, Uint8Array<ArrayBuffer>> = {};
  const named = (json.buffers ?? []).map(({ byteLength, extensions }, i) => {
    resources[`buffer${i}`] = (buffers[i] ?? new Uint8Array()) as Uint8Array<ArrayBuffer>;
    return { byteLength, extensions, uri: `buffer${i}` };
  });
  const bare: GLTF.IGLTF = {
    asset: { version: '2.0' },
    extensionsUsed: used,
    extensionsRequired: compressed ? [MESHOPT] : [],
    buffers: named,
    bufferViews: json.bufferViews ?? [],
    accessors: json.accessors ?? [],
    meshes,
  };
  try {
    const document = await io.readJSON({ json: bare, resources });
    const accessors = document.getRoot().listAccessors();
    return columnsOf(json, accessors, problems);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    addProblem(
      problems,
      ['accessors'],
      `content that cannot be read (${reason.slice(0, 200)})`,
      'what its JSON says, whole and undamaged',
    );
    return null;
  }
}

/** Nothing but the primitives that are compressed by Draco, one mesh for all. */
function dracoMeshes({ meshes = [] }: Gltf): NonNullable<Gltf['meshes']> {
  const primitives = meshes.flatMap((mesh) => mesh.primitives).filter((primitive) => extensionOf(primitive, DRACO));
  return primitives.length === 0 ? [] : [{ primitives: primitives.map(({ attributes, indices, extensions }) => ({ attributes, indices, extensions })) }]; // biome-ignore format: short
}

/** A stream of a few bytes may ask for as many triangles as it likes: it must ask for those of its accessors. */
function checkDraco(json: Gltf, buffers: readonly (Uint8Array | null)[], problems: ProblemList): void {
  (json.meshes ?? []).forEach(({ primitives }, mesh) => {
    primitives.forEach((primitive, i) => {
      const draco = extensionOf<DracoJson>(primitive, DRACO);
      if (!draco) return;
      const view = json.bufferViews![draco.bufferView]!;
      const offset = view.byteOffset ?? 0;
      const head = readDracoHead(buffers[view.buffer]!.subarray(offset, offset + view.byteLength));
      const path = ['meshes', mesh, 'primitives', i, 'extensions', DRACO];
      if (head === null) addProblem(problems, path, 'no Draco mesh', 'a mesh of Draco, bitstream 2');
      if (head === null || head === 'unknown') return;
      const corners = primitive.indices === undefined ? head.faces * 3 : json.accessors![primitive.indices]!.count;
      if (head.faces * 3 !== corners || head.faces > GLTF_LIMITS.triangles || head.points > corners)
        addProblem(problems, path, `a stream of ${head.faces} triangles`, `the ${corners / 3} of its accessor`);
    });
  });
}

function columnsOf(json: Gltf, accessors: readonly Accessor[], problems: ProblemList): Column[] | null {
  const columns = accessors.map((accessor, i): Column => {
    const { type, count, componentType } = json.accessors![i]!;
    const numbers = (accessor.getArray() ?? new Float32Array()) as Numbers;
    const width = WIDTHS[type]!;
    if (numbers.length !== count * width)
      addProblem(
        problems,
        ['accessors', i, 'count'],
        `${count} elements, where the content has ${numbers.length / width}`,
        'as many as there are',
      );
    return { numbers, width, count, normalized: json.accessors![i]!.normalized === true && componentType !== 5126 };
  });
  return problems.isEmpty ? columns : null;
}

/** What a whole number of the largest size stands for, by the array that holds it. */
function shareOf(numbers: Numbers): number {
  if (numbers instanceof Int8Array) return 127;
  if (numbers instanceof Uint8Array) return 255;
  if (numbers instanceof Int16Array) return 32_767;
  return numbers instanceof Uint16Array ? 65_535 : 4_294_967_295;
}

/** As floats: the file's own array where it has such. Nobody may write into what comes back. */
export function floatsOf({ numbers, normalized }: Column): Float32Array {
  if (numbers instanceof Float32Array) return numbers;
  const floats = Float32Array.from(numbers);
  if (!normalized) return floats;
  const most = shareOf(numbers);
  for (let i = 0; i < floats.length; i++) floats[i] = Math.max(floats[i]! / most, -1);
  return floats;
}
