/** What is told about meshes: how many vertices and triangles, what vertices have, how large they are. */
import { type MeshPart, readMeshFile } from 'mirrorball/mesh-files';
import { type Mesh, type MeshSource, meshBounds, triangleCount, vertexCount } from 'mirrorball/scene';
import { usage } from './exit-codes.ts';

type Facts = Readonly<Record<string, unknown>>;
type Meshes = Readonly<Record<string, MeshSource>>;

export const mapValues = <From, To>(things: Readonly<Record<string, From>>, change: (thing: From) => To) =>
  Object.fromEntries(Object.entries(things).map(([name, thing]) => [name, change(thing)] as const));

/** Of all meshes of a scene, each counted once. */
export function countsOf(meshes: Meshes): { readonly vertices: number; readonly triangles: number } {
  const all = [...new Set(Object.values(meshes).flatMap(({ data }) => data ?? []))];
  const sum = (count: (mesh: Mesh) => number) => all.reduce((total, mesh) => total + count(mesh), 0);
  return { vertices: sum(vertexCount), triangles: sum(triangleCount) };
}

export const meshFacts = ({ file, part, data }: MeshSource): Facts => ({
  ...(file === undefined ? {} : { file }),
  ...(part === undefined ? {} : { part }),
  ...(data ? factsOf(data) : {}),
});

function factsOf(mesh: Mesh): Facts {
  const has = { normals: mesh.normals, 'texture coordinates': mesh.uvs, colours: mesh.colors };
  const { min, max } = meshBounds(mesh);
  return {
    vertices: vertexCount(mesh),
    triangles: triangleCount(mesh),
    has: Object.entries(has).flatMap(([what, numbers]) => (numbers ? [what] : [])),
    from: min,
    to: max,
  };
}

/** Of a file alone, part by part. */
export function meshFileFacts(bytes: Uint8Array, name: string): Facts {
  const file = readMeshFile(bytes, name);
  if (!file.ok) throw usage(file.problems.map(({ message }) => message).join('\n'));
  const { parts, materialFiles, notes } = file;
  const factsOfPart = ({ name: part, mesh }: MeshPart): Facts => ({
    ...(part === '' ? {} : { part }),
    ...factsOf(mesh),
  });
  return {
    kind: 'mesh file',
    vertices: parts.reduce((sum, { mesh }) => sum + vertexCount(mesh), 0),
    triangles: parts.reduce((sum, { mesh }) => sum + triangleCount(mesh), 0),
    parts: parts.map(factsOfPart),
    ...(materialFiles.length > 0 ? { materialFiles } : {}),
    ...(notes.length > 0 ? { notes } : {}),
  };
}
