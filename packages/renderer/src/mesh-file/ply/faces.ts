/** The faces of a PLY file, polygons of any number of corners, or strips of triangles. */
import type { FileProblems } from '../file-problems.ts';
import { IndexList } from '../number-lists.ts';
import type { PlyElement, PlyType } from './header.ts';
import type { PlyValues } from './values.ts';
import { itemsOf } from './vertices.ts';

export interface PlyFaces {
  /** Vertices of one polygon after the other. */
  readonly corners: IndexList;
  /** How many corners each has. */
  readonly sizes: IndexList;
  /** Faces of fewer than three corners, which are left out. */
  tiny: number;
  /** Names of properties that nothing was made of. */
  readonly unused: Set<string>;
}

export const noFaces = (): PlyFaces => ({
  corners: new IndexList(),
  sizes: new IndexList(),
  tiny: 0,
  unused: new Set(),
});

const LIST_NAMES: readonly string[] = ['vertex_indices', 'vertex_index'];

/** Adds the element's faces; `vertices`: how many there are to refer to. */
export function readFaces(
  element: PlyElement,
  vertices: number,
  values: PlyValues,
  problems: FileProblems,
  faces: PlyFaces,
): void {
  const { name, count, properties, line } = element;
  const list = properties.findIndex((property) => LIST_NAMES.includes(property.name) && property.count !== null);
  if (list < 0) problems.fail({ line }, `"${name}" without a list "vertex_indices"`, 'this list');
  for (const [k, property] of properties.entries()) if (k !== list) faces.unused.add(`${name}.${property.name}`);
  values.expectRows(element);
  const reader = { vertices, values, problems, faces };
  const isStrip = name === 'tristrips';
  for (let face = 0; face < count; face++) {
    values.startRow();
    for (let k = 0; k < properties.length; k++) {
      const { type, count: lengthType } = properties[k]!;
      const items = lengthType === null ? 1 : itemsOf(lengthType, type, values, problems);
      if (k !== list) for (let item = 0; item < items; item++) values.next(type);
      else if (isStrip) readStrip(face, items, type, reader);
      else readPolygon(face, items, type, reader);
    }
  }
}

interface Reader {
  readonly vertices: number;
  readonly values: PlyValues;
  readonly problems: FileProblems;
  readonly faces: PlyFaces;
}

function readPolygon(face: number, size: number, type: PlyType, reader: Reader): void {
  const { corners, sizes } = reader.faces;
  const before = corners.length;
  let good = true;
  for (let k = 0; k < size; k++) {
    const corner = reader.values.next(type);
    if (good) good = isVertex(corner, face, reader);
    corners.push(corner);
  }
  if (good && size >= 3) sizes.push(size);
  else corners.length = before;
  if (size < 3) reader.faces.tiny++;
}

function isVertex(corner: number, face: number, { vertices, values, problems }: Reader): boolean {
  if (corner >= 0 && corner < vertices && Number.isInteger(corner)) return true;
  const allowed = vertices === 0 ? 'no faces, as there are no vertices' : `a whole number from 0 to ${vertices - 1}`;
  problems.add(values.place, `the vertex ${corner} in face ${face}`, allowed);
  return false;
}

/** Each vertex makes a triangle with the two before, every other one turned over; −1 begins a new strip. */
function readStrip(face: number, size: number, type: PlyType, reader: Reader): void {
  const { corners, sizes } = reader.faces;
  let [a, b, run] = [-1, -1, 0];
  for (let k = 0; k < size; k++) {
    const next = reader.values.next(type);
    if (next === -1 || !isVertex(next, face, reader)) {
      run = 0;
      continue;
    }
    if (run >= 2) {
      corners.push(run % 2 ? b : a);
      corners.push(run % 2 ? a : b);
      corners.push(next);
      sizes.push(3);
    }
    [a, b] = [b, next];
    run++;
  }
}
