/** How much memory a file asks for, before any is given. */
import type { ProblemList } from '../../scene-file/problem.ts';
import { extensionOf, type Gltf, type PrimitiveJson, SIZES, WIDTHS } from '../json.ts';
import { GLTF_LIMITS } from '../limits.ts';
import { addProblem } from '../problems.ts';
import { meshoptOf } from './spans.ts';

/** `fileBytes`: of the file and all buffers that it names. */
export function checkClaims(json: Gltf, fileBytes: number, problems: ProblemList): void {
  const { accessors = [], bufferViews = [], meshes = [] } = json;
  const most = Math.min(GLTF_LIMITS.geometryBytes, GLTF_LIMITS.freeBytes + fileBytes * GLTF_LIMITS.growth);
  const total = (list: string, bytes: readonly number[]): void => {
    const sum = bytes.reduce((a, b) => a + b, 0);
    if (sum <= most) return;
    const largest = bytes.indexOf(Math.max(...bytes.slice(0, 100_000)));
    addProblem(
      problems,
      [list, largest],
      `what unfolds to ${sum} bytes with all other ${list}`,
      `at most ${most} bytes for a file of ${fileBytes}`,
    );
  };
  total(
    'accessors',
    accessors.map(({ count, type, componentType }) => count * WIDTHS[type]! * Math.max(SIZES[componentType]!, 4)),
  );
  total(
    'bufferViews',
    bufferViews.map((view) => (meshoptOf(view) ? view.byteLength : 0)),
  );
  checkPlaces(json, problems);
  checkSums(problems, meshes.flatMap(({ primitives }) => primitives), json); // biome-ignore format: one thought
}

/** What meshes will have in the scene: a primitive takes no more vertices than its indices name, and what is the same is there once. */
function checkSums(problems: ProblemList, primitives: readonly PrimitiveJson[], { accessors = [] }: Gltf): void {
  const seen = new Set<string>();
  let [vertices, corners] = [0, 0];
  for (const { attributes, indices, targets } of primitives) {
    const key = JSON.stringify([attributes, indices, targets]);
    const position = attributes.POSITION;
    if (position === undefined || seen.has(key)) continue;
    seen.add(key);
    const there = accessors[position]!.count;
    const named = indices === undefined ? there : accessors[indices]!.count;
    vertices += Math.min(there, named);
    corners += named;
  }
  const tell = (found: number, what: string, most: number): void => {
    if (found > most) addProblem(problems, ['meshes'], `${found} ${what} together`, `at most ${most}`);
  };
  tell(vertices, 'vertices', GLTF_LIMITS.vertices);
  tell(Math.floor(corners / 3), 'triangles', GLTF_LIMITS.triangles);
}

/** How often meshes are placed. */
function checkPlaces({ nodes = [], accessors = [], meshes = [] }: Gltf, problems: ProblemList): void {
  let places = 0;
  for (const node of nodes) {
    if (node.mesh === undefined) continue;
    const instancing = extensionOf<{ attributes: Record<string, number> }>(node, 'EXT_mesh_gpu_instancing');
    const counts = Object.values(instancing?.attributes ?? {}).map((accessor) => accessors[accessor]!.count);
    places += (counts.length > 0 ? Math.max(...counts) : 1) * meshes[node.mesh]!.primitives.length;
  }
  const most = GLTF_LIMITS.placements;
  if (places > most) addProblem(problems, ['nodes'], `${places} places of meshes`, `at most ${most}`);
}
