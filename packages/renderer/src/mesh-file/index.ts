/** Files of triangles, and meshes: pure functions from bytes to what a scene can hold. */
export type { FileProblem, FileRefused } from './file-problems.ts';
export { type MeshContent, type MeshFile, type MeshPart, readMeshFile } from './mesh-file.ts';
export { type MadeImage, makeImage } from './obj/made-images.ts';
export { type MtlContent, type MtlFile, readMtl } from './obj/read-mtl.ts';
export { readObj } from './obj/read-obj.ts';
export { readPly } from './ply/read-ply.ts';
export { writePly } from './ply/write-ply.ts';
export { shadedMesh } from './shaded-mesh.ts';
export { smoothNormals } from './smooth-normals.ts';
export { readStl } from './stl/read-stl.ts';
