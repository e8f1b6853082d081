/** PLY, "Polygon File Format" or "Stanford Triangle Format": text, or bytes of either order. */
import { quote } from '../../scene-file/problem.ts';
import { cutPolygons } from '../cut-polygons.ts';
import { type FileProblems, reading, WHOLE } from '../file-problems.ts';
import { finishMesh } from '../finish-mesh.ts';
import type { MeshContent, MeshFile } from '../mesh-file.ts';
import { notesOf } from '../notes.ts';
import { noFaces, type PlyFaces, readFaces } from './faces.ts';
import { readPlyHeader } from './header.ts';
import { valuesOf } from './values.ts';
import { type PlyVertices, readVertices, skipElement } from './vertices.ts';

/** One part, with normals, texture coordinates and colours if its vertices have them. Never throws, whatever the bytes are. */
export const readPly = (bytes: Uint8Array, name: string): MeshFile =>
  reading(name, (problems) => readContent(bytes, problems));

function readContent(bytes: Uint8Array, problems: FileProblems): MeshContent {
  const header = readPlyHeader(bytes, problems);
  const values = valuesOf(bytes, header, problems);
  const { elements } = header;
  // Faces may come first; what they may refer to is known all the same.
  const count = elements.find(({ name }) => name === 'vertex')?.count ?? 0;
  let vertices: PlyVertices | null = null;
  const faces = noFaces();
  const others: string[] = [];
  for (const element of elements) {
    const { name } = element;
    if (name === 'vertex' && vertices === null) vertices = readVertices(element, values, problems);
    else if (name === 'face' || name === 'tristrips') readFaces(element, count, values, problems, faces);
    else {
      if (element.count > 0) others.push(name);
      skipElement(element, values, problems);
    }
  }
  if (vertices === null || vertices.positions.length === 0)
    return problems.fail(WHOLE, 'no vertices', 'an element "vertex"');
  return contentOf(vertices, faces, others, problems);
}

function contentOf(vertices: PlyVertices, faces: PlyFaces, others: string[], problems: FileProblems): MeshContent {
  const { positions, unused, ...rest } = vertices;
  if (!problems.isEmpty) problems.stop();
  if (faces.sizes.length === 0)
    problems.fail(WHOLE, 'no faces: it is a cloud of points', 'an element "face" with faces');
  const indices = cutPolygons(faces.corners.view(), faces.sizes.view(), positions, problems);
  const { mesh, degenerate, mended } = finishMesh({ positions, indices, ...rest });
  if (mesh === null) return problems.fail(WHOLE, `${degenerate} triangles, none of which has an area`, 'triangles');
  const passed = [...others, ...unused, ...faces.unused].map((name) => quote(name)).slice(0, 12).join(', '); // biome-ignore format: short
  const notes = notesOf({ degenerate, mended, tiny: faces.tiny });
  if (passed !== '') notes.push(`Nothing is made of ${passed}.`);
  return { parts: [{ name: '', mesh }], degenerate, materialFiles: [], notes };
}
