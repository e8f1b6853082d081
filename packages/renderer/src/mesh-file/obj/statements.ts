/** The lines of an OBJ file (Wavefront, "Advanced Visualizer" appendix B1), as far as they are polygons: read, and nothing made of them yet. */
import { srgbToLinear } from '../../display/srgb.ts';
import { SCENE_LIMITS } from '../../scene/limits.ts';
import { FARTHEST_VERTEX } from '../../scene/mesh-fault.ts';
import { quote } from '../../scene-file/problem.ts';
import { checkCount, type FileProblems } from '../file-problems.ts';
import { LineScanner } from '../line-scanner.ts';
import { FloatList, IndexList, WholeList } from '../number-lists.ts';
import { plainPath } from './mtl-textures.ts';

export interface ObjStatements {
  readonly positions: FloatList;
  /** Of each position, linear red, green and blue; empty when no vertex has one. */
  readonly colors: FloatList;
  readonly uvs: FloatList;
  readonly normals: FloatList;
  /** Three numbers a corner: position, texture coordinate and normal, counted from 0; −1 = none. */
  readonly corners: WholeList;
  /** Of each face: corners, material, smoothing group (0 = none), line. */
  readonly sizes: IndexList;
  readonly faceMaterials: IndexList;
  readonly groups: IndexList;
  readonly lines: IndexList;
  /** "" is that of faces before any. */
  readonly materials: string[];
  readonly materialFiles: string[];
  /** Faces of fewer than three corners. */
  tiny: number;
  /** Statements that nothing is made of, and how many there are. */
  readonly passed: Map<string, number>;
}

interface State {
  readonly scan: LineScanner;
  readonly to: ObjStatements;
  readonly problems: FileProblems;
  material: number;
  group: number;
}

/** What names and groups things, and is no loss. */
const SILENT: readonly string[] = ['g', 'o', 'mg'];
/** Of different words so many are told. */
const MOST_PASSED = 40;
const MOST_MATERIALS = 4096;

export function readStatements(bytes: Uint8Array, problems: FileProblems): ObjStatements {
  const to: ObjStatements = {
    positions: new FloatList(),
    colors: new FloatList(),
    uvs: new FloatList(),
    normals: new FloatList(),
    corners: new WholeList(),
    sizes: new IndexList(),
    faceMaterials: new IndexList(),
    groups: new IndexList(),
    lines: new IndexList(),
    materials: [],
    materialFiles: [],
    tiny: 0,
    passed: new Map(),
  };
  const state: State = { scan: new LineScanner(bytes, { continues: true }), to, problems, material: -1, group: 0 };
  while (state.scan.nextWord()) {
    const { line } = state.scan;
    const word = state.scan.word();
    if (!word.startsWith('#')) readStatement(word, line, state);
    state.scan.endLine();
  }
  return to;
}

function readStatement(word: string, line: number, state: State): void {
  const { scan, to, problems } = state;
  switch (word) {
    case 'v':
      readPosition(line, state);
      break;
    case 'vt':
      readNumbers(2, to.uvs, line, state);
      break;
    case 'vn':
      readNumbers(3, to.normals, line, state);
      break;
    case 'f':
    case 'fo': // as old files have it
      readFace(line, state);
      break;
    case 'usemtl':
      state.material = materialNumber(scan.rest(), line, state);
      break;
    case 'mtllib':
      to.materialFiles.push(...fileNames(scan.rest()));
      break;
    case 's':
      state.group = groupOf(scan.word());
      break;
    default:
      passOver(word, line, to, problems);
  }
}

function passOver(word: string, line: number, { passed }: ObjStatements, problems: FileProblems): void {
  if (SILENT.includes(word)) return;
  if (!/^[a-z_]\w{0,40}$/i.test(word)) problems.add({ line }, `the word ${quote(word)}`, 'a word such as "v" or "f"');
  else if (passed.size < MOST_PASSED || passed.has(word)) passed.set(word, (passed.get(word) ?? 0) + 1);
}

/** `s off` is `s 0`. */
function groupOf(word: string): number {
  const group = Number(word);
  return Number.isInteger(group) && group > 0 && group < 2 ** 31 ? group : 0;
}

function materialNumber(name: string, line: number, { to: { materials }, problems }: State): number {
  const known = materials.indexOf(name);
  if (known >= 0) return known;
  if (materials.length >= MOST_MATERIALS) problems.fail({ line }, 'one material more', `at most ${MOST_MATERIALS}`);
  return materials.push(name) - 1;
}

/** Several names may stand in one line; a name may have spaces, then its ending or quotes tell where it ends. */
function fileNames(rest: string): string[] {
  const names = /\.mtl(?=["\s]|$)/i.test(rest) ? rest.split(/(?<=\.mtl"?)\s+/i) : rest.split(/\s+/);
  return names.map(plainPath).filter(Boolean);
}

/** Of one line; kept, as a file has millions of them. */
const row = new Float64Array(6);

/** x y z, perhaps w, or with three numbers of a colour, which are those of a screen. */
function readPosition(line: number, { scan, to, problems }: State): void {
  const { positions, colors } = to;
  row.fill(Number.NaN);
  let count = 0;
  for (; count < 6 && scan.more(); count++) row[count] = scan.number();
  for (let c = 0; c < 3; c++) {
    positions.push(row[c]!);
    if (Math.abs(row[c]!) <= FARTHEST_VERTEX) continue;
    problems.add({ line }, `the vertex ${row.subarray(0, 3).join(' ')}`, 'three numbers from -1e9 to 1e9');
    while (positions.length % 3 !== 0) positions.push(0);
    break;
  }
  if (positions.length > 3 * SCENE_LIMITS.meshVertices)
    checkCount('vertices', positions.length / 3, { line }, problems);
  if (count === 6 || colors.length > 0) readColor(count === 6, to);
}

/** Into the place of the last vertex; those before it that have none are white. */
function readColor(given: boolean, { positions, colors }: ObjStatements): void {
  while (colors.length < positions.length - 3) colors.push(1);
  for (let c = 3; c < 6; c++) colors.push(given ? srgbToLinear(Math.min(Math.max(row[c]!, 0), 1)) : 1);
}

function readNumbers(count: number, to: FloatList, line: number, { scan, problems }: State): void {
  for (let k = 0; k < count; k++) {
    // Texture coordinates may have one number alone.
    const x = k > 0 && count === 2 && !scan.more() ? 0 : scan.number();
    if (scan.strange && !(k > 0 && count === 2))
      problems.add({ line }, 'too few numbers, or others', `${count} numbers`);
    to.push(x);
  }
}

const SLASH = 47;

/** Corners such as 3, 3/1, 3//2 or 3/1/2. Whether what they count from the start is there is seen at the end of the file. */
function readFace(line: number, state: State): void {
  const { scan, to, problems } = state;
  const before = to.corners.length;
  let size = 0;
  for (; scan.more(); size++)
    if (!readCorner(line, size, state)) {
      to.corners.length = before;
      return;
    }
  if (size < 3) {
    to.corners.length = before;
    to.tiny++;
    return;
  }
  to.sizes.push(size);
  const triangles = to.corners.length / 3 - 2 * to.sizes.length;
  if (triangles > SCENE_LIMITS.meshTriangles) checkCount('triangles', triangles, { line }, problems);
  to.faceMaterials.push(state.material < 0 ? (state.material = materialNumber('', line, state)) : state.material);
  to.groups.push(state.group);
  to.lines.push(line);
}

/** Numbers of three kinds of things, 0 = none was given. */
const given = { vertex: 0, uv: 0, normal: 0 };

/** False when it is none, which is told. */
function readCorner(line: number, corner: number, { scan, to, problems }: State): boolean {
  const { at } = scan;
  const whole = readNumbersOfCorner(scan);
  const vertex = indexOf(given.vertex, to.positions.length / 3);
  const uv = indexOf(given.uv, to.uvs.length / 2);
  const normal = indexOf(given.normal, to.normals.length / 3);
  if (whole && vertex >= 0 && uv >= NONE && normal >= NONE) {
    to.corners.push(vertex);
    to.corners.push(uv);
    to.corners.push(normal);
    return true;
  }
  scan.at = at;
  const found = `${quote(scan.word())} as corner ${corner + 1} of a face`;
  problems.add({ line }, found, 'numbers of what stands in the file, such as 3, 3/1, 3//2 or 3/1/2');
  return false;
}

/** Into `given`. False when something else stands there. */
function readNumbersOfCorner(scan: LineScanner): boolean {
  const { bytes } = scan;
  given.vertex = scan.whole();
  given.uv = 0;
  given.normal = 0;
  if (Number.isNaN(given.vertex)) return false;
  if (bytes[scan.at] === SLASH) {
    scan.at++;
    given.uv = scan.whole() || 0;
    if (bytes[scan.at] === SLASH) {
      scan.at++;
      given.normal = scan.whole() || 0;
    }
  }
  return scan.atWordEnd;
}

export const NONE = -1;
const BAD = -2;

/** Counted from 0. What is given counts from 1, or back from the last one with a minus; 0: none. */
function indexOf(number: number, count: number): number {
  if (number > 0) return number <= MOST_NUMBER ? number - 1 : BAD;
  if (number === 0) return NONE;
  return count + number >= 0 ? count + number : BAD;
}
/** More than any file has of anything. */
const MOST_NUMBER = 2 ** 31 - 1;
