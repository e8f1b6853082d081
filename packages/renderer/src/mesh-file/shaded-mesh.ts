import type { Mesh, MeshShading } from '../scene/mesh.ts';
import { smoothNormals } from './smooth-normals.ts';

/** What was made of a mesh by a shading that it does not have by itself; a mesh does not change. */
const known = { smooth: new WeakMap<Mesh, Mesh>(), flat: new WeakMap<Mesh, Mesh>() };

/** The mesh with the normals that its shading asks for. */
export function shadedMesh(mesh: Mesh, shading: MeshShading = 'auto'): Mesh {
  if (shading === 'auto' || (shading === 'smooth') === (mesh.normals !== undefined)) return mesh;
  const before = known[shading].get(mesh);
  if (before) return before;
  const { normals: _, tangents: __, ...flat } = mesh;
  const made = shading === 'flat' ? flat : { ...mesh, normals: smoothNormals(mesh.positions, mesh.indices) };
  known[shading].set(mesh, made);
  return made;
}
