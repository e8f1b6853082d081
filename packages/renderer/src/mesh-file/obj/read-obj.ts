/** OBJ (Wavefront): text with vertices, polygons, and names of materials that an .mtl file describes. */
import { quote } from '../../scene-file/problem.ts';
import { type FileProblems, reading, WHOLE } from '../file-problems.ts';
import { finishMesh } from '../finish-mesh.ts';
import type { MeshContent, MeshFile, MeshFileOptions, MeshPart } from '../mesh-file.ts';
import { notesOf } from '../notes.ts';
import { asUtf8 } from '../text-encoding.ts';
import { type Faces, partOf } from './part.ts';
import { type ObjStatements, readStatements } from './statements.ts';

/** A part for each material, in the order in which they are used, or one of all. Never throws, whatever the bytes are. */
export const readObj = (bytes: Uint8Array, name: string, { asOne = false }: MeshFileOptions = {}): MeshFile =>
  reading(name, (problems) => readContent(bytes, asOne, problems));

function readContent(bytes: Uint8Array, asOne: boolean, problems: FileProblems): MeshContent {
  const obj = readStatements(asUtf8(bytes, problems), problems);
  const firstCorners = firstCornersOf(obj);
  const missing = checkNumbers(obj, firstCorners, problems);
  if (!problems.isEmpty) problems.stop();
  if (obj.sizes.length === 0) problems.fail(WHOLE, 'no faces', 'lines that begin with "f"');
  const parts: MeshPart[] = [];
  const tally = { degenerate: 0, mended: 0, tiny: obj.tiny };
  const groups = asOne ? [[-1, allFaces(firstCorners)] as const] : facesByMaterial(obj, firstCorners);
  for (const [material, faces] of groups) {
    const { mesh, degenerate, mended } = finishMesh(partOf(obj, faces, problems));
    if (mesh) parts.push({ name: obj.materials[material] ?? '', mesh });
    tally.degenerate += degenerate;
    tally.mended += mended;
  }
  if (parts.length === 0) problems.fail(WHOLE, `${tally.degenerate} triangles, none of which has an area`, 'triangles');
  const passed = [...obj.passed].map(([word, count]) => `${quote(word)} (${count})`).join(', ');
  const notes = notesOf(tally);
  for (const kind of missing) notes.push(`Its faces refer to ${kind}s, which it has none of.`);
  if (passed !== '') notes.push(`Nothing is made of its lines ${passed}.`);
  return { parts, degenerate: tally.degenerate, materialFiles: [...new Set(obj.materialFiles)], notes };
}

function firstCornersOf({ sizes }: ObjStatements): Uint32Array {
  const first = new Uint32Array(sizes.length);
  for (let face = 1; face < first.length; face++) first[face] = first[face - 1]! + sizes.at(face - 1);
  return first;
}

/**
 * Numbers may be of what comes later in the file, so that they are looked at when all of it is known. Gives the kinds of things that
 * faces refer to and the file has none of.
 */
function checkNumbers(obj: ObjStatements, firstCorners: Uint32Array, problems: FileProblems): ReadonlySet<string> {
  const missing = new Set<string>();
  const kinds = ['vertex', 'texture coordinate', 'normal'];
  const counts = [obj.positions.length / 3, obj.uvs.length / 2, obj.normals.length / 3];
  for (let face = 0; face < firstCorners.length; face++) {
    const end = 3 * (firstCorners[face]! + obj.sizes.at(face));
    for (let k = 3 * firstCorners[face]!; k < end; k++) {
      const [index, kind] = [obj.corners.at(k), k % 3];
      const count = counts[kind]!;
      if (index < count) continue;
      if (count === 0 && kind > 0) missing.add(kinds[kind]!);
      else
        problems.add({ line: obj.lines.at(face) }, `the number ${index + 1} of a ${kinds[kind]}`, `at most ${count}`);
    }
  }
  return missing;
}

const allFaces = (firstCorners: Uint32Array): Faces => ({ faces: firstCorners.map((_, face) => face), firstCorners });

function facesByMaterial(obj: ObjStatements, firstCorners: Uint32Array): Map<number, Faces> {
  const counts = new Map<number, number>();
  for (const material of obj.faceMaterials.view()) counts.set(material, (counts.get(material) ?? 0) + 1);
  const parts = new Map([...counts].map(([material, count]) => [material, new Uint32Array(count)]));
  const filled = new Map<number, number>();
  obj.faceMaterials.view().forEach((material, face) => {
    const at = filled.get(material) ?? 0;
    parts.get(material)![at] = face;
    filled.set(material, at + 1);
  });
  return new Map([...parts].map(([material, faces]) => [material, { faces, firstCorners }]));
}
