/** glTF 2.0 → scene: the steps, in order. Everything of glTF hangs on this module, so that it can be loaded when it is needed. */
import { countsOf } from '../scene/counts.ts';
import { SCENE_LIMITS } from '../scene/limits.ts';
import type { Scene } from '../scene/scene.ts';
import { boundsAt } from '../scene/scene-bounds.ts';
import { ProblemList } from '../scene-file/problem.ts';
import { readAccessors } from './accessors.ts';
import { assemble } from './assemble.ts';
import { readBuffers, readUri, type Sources } from './buffers.ts';
import { readCameras } from './cameras.ts';
import { checkGltf } from './check/check-gltf.ts';
import { checkClaims } from './check/claims.ts';
import { ClipReader } from './clips.ts';
import { readContainer } from './container.ts';
import { defaultDecoder } from './images/decoder.ts';
import type { Gltf } from './json.ts';
import { readLights } from './lights.ts';
import { GLTF_LIMITS } from './limits.ts';
import { texturesNamedBy } from './materials.ts';
import { readNodes } from './nodes.ts';
import { addProblem } from './problems.ts';
import type { Reading } from './reading.ts';
import { ReportList } from './report.ts';
import { materialsOf, meshesShown, ShapeReader } from './shapes.ts';
import { readSkins } from './skins.ts';
import { reportStrangers } from './strangers.ts';
import { TextureReader } from './textures.ts';
import type { GltfImport, GltfOptions, GltfProgress } from './types.ts';

/** Thrown, and caught here: there are problems, so nothing that follows makes sense. */
class Stopped extends Error {}

/** Never rejects for what a file has; rejects with the signal's reason when that is aborted. */
export async function readGltf(bytes: Uint8Array, options: GltfOptions = {}): Promise<GltfImport> {
  const problems = new ProblemList();
  const report = new ReportList();
  try {
    const scene = await read(bytes, options, problems, report);
    return { ok: true, scene: freeze(scene), report: { entries: report.list(), counts: countsOf(scene) } };
  } catch (error) {
    options.signal?.throwIfAborted();
    if (!(error instanceof Stopped)) {
      const reason = error instanceof Error ? error.message : String(error);
      addProblem(problems, [], `something that cannot be read (${reason.slice(0, 200)})`, 'a glTF 2.0 file');
    }
    return { ok: false, problems: problems.list() };
  }
}

async function read(
  bytes: Uint8Array,
  options: GltfOptions,
  problems: ProblemList,
  report: ReportList,
): Promise<Scene> {
  const go = pacer(options);
  const sure = <Value>(value: Value | null): Value => {
    if (value === null || !problems.isEmpty) throw new Stopped();
    return value;
  };
  const { json: text, binary } = sure(readContainer(bytes, problems));
  const json = sure(checkGltf(text, problems));
  const sources: Sources = { binary, readFile: options.readFile, problems };
  await go('files', 0, 1);
  const buffers = await readBuffers(json, sources);
  // All files that are missing are told at once, not one kind after the other.
  if (!problems.isEmpty) await lookForImages(json, sources);
  sure(json);
  checkClaims(
    json,
    buffers.reduce((sum, buffer) => sum + (buffer?.length ?? 0), bytes.length),
    problems,
  );
  sure(json);
  await go('numbers', 0, 1);
  const columns = sure(await readAccessors(json, buffers, problems));
  const reading: Reading = { json, columns, buffers, problems, report };
  reportStrangers(json, report);

  const nodes = readNodes(reading);
  const textures = new TextureReader(reading, options.decoder ?? defaultDecoder(), sources);
  await textures.open(texturesShown(json, meshesShown(reading, nodes)));
  sure(json);
  const skins = readSkins(reading, nodes);
  const shapes = sure(
    await new ShapeReader(reading, textures, nodes, skins).read((done, total) => go('meshes', done, total)),
  );
  if (shapes.shapes.count === 0)
    report.add('unused', 'scene', [], 'Nothing in the file has a surface: there is nothing to be seen but light.');
  const lights = readLights(reading, nodes);
  const cameras = readCameras(reading, nodes);
  const clips = sure(
    new ClipReader(reading, { nodes: nodes.nodes, materials: shapes.materials, lights, cameras }).read(),
  );
  checkLimits(reading, { lights: lights.count, materials: shapes.materials.count });
  sure(json);
  await textures.load((done, total) => options.onProgress?.({ step: 'images', done, total }));
  sure(json);
  reportUnused(reading, { materials: shapes.materials, skins, meshes: meshesShown(reading, nodes) });
  const name = json.scenes?.[json.scene ?? 0]?.name;
  const scene = assemble(
    {
      ...shapes,
      name: options.name ?? (name || 'model'),
      description: json.asset.copyright ?? '',
      nodes: nodes.nodes,
      skins,
      lights,
      cameras,
      clips,
      textures,
    },
    options,
  );
  checkReach(scene, problems);
  return sure(scene);
}

/** Nodes may enlarge and move what is small and near: farther out than numbers of 32 bits can tell, squared, nothing can be traced. */
function checkReach(scene: Scene, problems: ProblemList): void {
  const bounds = boundsAt(scene, 0);
  const farthest = bounds && Math.max(...[...bounds.min, ...bounds.max].map(Math.abs));
  // What is no number is beyond too.
  if (farthest === null || farthest <= GLTF_LIMITS.farthest) return;
  addProblem(problems, ['nodes'], 'nodes that carry things farther than 1e9 metres from the origin', 'things within 1e9 metres of it'); // biome-ignore format: one problem
}

/** Adds a problem for each file of an image that cannot be read. */
async function lookForImages({ images = [] }: Gltf, sources: Sources): Promise<void> {
  for (const [i, { uri }] of images.entries()) if (uri !== undefined) await readUri(uri, ['images', i, 'uri'], sources);
}

function texturesShown(json: Gltf, meshes: readonly number[]): number[] {
  const materials = new Set(meshes.flatMap((mesh) => json.meshes![mesh]!.primitives.flatMap(materialsOf)));
  return [...materials].filter((index) => index >= 0).flatMap((index) => texturesNamedBy(json.materials![index]!));
}

/** What a scene may have; told in the words of the file. */
function checkLimits({ problems }: Reading, counts: { lights: number; materials: number }): void {
  if (counts.lights > SCENE_LIMITS.light)
    addProblem(problems, ['nodes'], `${counts.lights} lights`, `at most ${SCENE_LIMITS.light}`);
  if (counts.materials > SCENE_LIMITS.material)
    addProblem(
      problems,
      ['materials'],
      `${counts.materials} materials that are used`,
      `at most ${SCENE_LIMITS.material}`,
    );
}

interface Used {
  readonly materials: { nameOf(index: number): string | undefined };
  readonly skins: { nameOf(index: number): string | undefined };
  readonly meshes: readonly number[];
}

function reportUnused({ json, report }: Reading, { materials, skins, meshes }: Used): void {
  const tell = (
    list: string,
    what: string,
    things: readonly unknown[] | undefined,
    isUsed: (index: number) => boolean,
  ): void =>
    (things ?? []).forEach((_, index) => {
      if (!isUsed(index))
        report.add('unused', what, [list, index], `The scene shown uses some of the file's ${list} only.`);
    });
  const shown = new Set(meshes);
  tell('meshes', 'mesh', json.meshes, (index) => shown.has(index));
  tell('materials', 'material', json.materials, (index) => materials.nameOf(index) !== undefined);
  tell('skins', 'skin', json.skins, (index) => skins.nameOf(index) !== undefined);
}

/** After so many milliseconds without a pause the page gets its turn. */
const LONGEST_TURN = 30;

/** Tells progress, gives others their turn, and stops when that is asked for. */
function pacer({ onProgress, signal }: GltfOptions) {
  let start = performance.now();
  return async (step: GltfProgress['step'], done: number, total: number): Promise<void> => {
    signal?.throwIfAborted();
    if (done > 0 && performance.now() - start < LONGEST_TURN) return;
    onProgress?.({ step, done, total });
    await new Promise((resolve) => setTimeout(resolve));
    start = performance.now();
    signal?.throwIfAborted();
  };
}

/** Everything but the arrays of numbers, which cannot be. */
function freeze<Value>(value: Value): Value {
  if (typeof value !== 'object' || value === null || ArrayBuffer.isView(value) || Object.isFrozen(value)) return value;
  Object.freeze(value);
  for (const part of Object.values(value)) freeze(part);
  return value;
}
