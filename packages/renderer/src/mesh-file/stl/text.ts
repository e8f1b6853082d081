import { FARTHEST_VERTEX } from '../../scene/mesh-fault.ts';
import { quote } from '../../scene-file/problem.ts';
import { checkCount, type FileProblems } from '../file-problems.ts';
import { LineScanner } from '../line-scanner.ts';
import { FloatList } from '../number-lists.ts';
import type { Triangles } from './read-stl.ts';

const WORDS = '"solid", "facet", "outer loop", "vertex", or the end of one';

/** What has been begun and not ended. A loop is the list of its corners. */
interface Open {
  solid: boolean;
  facet: boolean;
  loop: number[] | null;
}

/** All solids together. Spaces and line ends part words alike, as some programs write a facet in one line. */
export function readTextTriangles(bytes: Uint8Array, problems: FileProblems): Triangles {
  const scan = new LineScanner(bytes);
  const corners = new FloatList();
  const open: Open = { solid: false, facet: false, loop: null };
  while (scan.nextWord()) take(scan, open, corners, problems);
  const unended = open.loop ? 'a loop' : open.facet ? 'a facet' : open.solid ? 'a solid' : null;
  if (unended) problems.add({ line: scan.line }, `its end within ${unended}`, 'the end of that first');
  return { corners: corners.take(), notes: [] };
}

function take(scan: LineScanner, open: Open, corners: FloatList, problems: FileProblems): void {
  const { line } = scan;
  const word = scan.word();
  switch (word.toLowerCase()) {
    case 'solid':
      open.solid = true;
      scan.endLine(); // its name, which may be anything
      break;
    case 'endsolid':
      open.solid = false;
      scan.endLine();
      break;
    case 'facet':
      open.facet = true;
      // "normal" and the normal, which the corners tell too.
      for (let k = 0; k < 4; k++) scan.word();
      break;
    case 'endfacet':
      open.facet = false;
      break;
    case 'outer':
      scan.word();
      open.loop = [];
      break;
    case 'vertex':
      takeCorner(scan, line, open, problems);
      break;
    case 'endloop':
      endLoop(line, open, corners, problems);
      break;
    default:
      problems.add({ line }, `the word ${quote(word)}`, WORDS);
      scan.endLine();
  }
}

function endLoop(line: number, open: Open, corners: FloatList, problems: FileProblems): void {
  const loop = open.loop ?? [];
  open.loop = null;
  if (loop.length < 9) problems.add({ line }, `a loop of ${loop.length / 3} vertices`, 'three of them');
  addFan(loop, corners);
  checkCount('triangles', corners.length / 9, { line }, problems);
}

function takeCorner(scan: LineScanner, line: number, { loop }: Open, problems: FileProblems): void {
  const place = [scan.number(), scan.number(), scan.number()];
  if (loop === null) problems.add({ line }, 'a vertex outside of any loop', '"outer loop" before it');
  else if (place.every((x) => Math.abs(x) <= FARTHEST_VERTEX)) loop.push(...place);
  else {
    problems.add({ line }, `the corner ${place.join(' ')}`, 'three numbers from -1e9 to 1e9');
    loop.push(0, 0, 0);
  }
}

/** Nobody writes more than three corners; if somebody does, they are a convex polygon's. */
function addFan(loop: readonly number[], corners: FloatList): void {
  for (let k = 6; k < loop.length; k += 3)
    for (const first of [0, k - 3, k]) for (let c = 0; c < 3; c++) corners.push(loop[first + c]!);
}
