import { type Mesh, triangleCount, vertexCount } from '../../scene/mesh.ts';

/** So many numbers a vertex, and what they are called. */
export interface PlyColumn {
  readonly names: readonly string[];
  readonly numbers: Float32Array;
}

/**
 * A mesh as a binary PLY file, little endian: positions, normals, the first texture coordinates and colours, all as 32-bit floats, so that
 * `readPly` gives back the very same numbers (of v, which such files count from below, to the last bit or so). The rest stays out, but for columns that are
 * given beside.
 */
export function writePly(mesh: Mesh, more: readonly PlyColumn[] = []): Uint8Array<ArrayBuffer> {
  const { positions, indices, normals, uvs, colors } = mesh;
  const columns: PlyColumn[] = [{ names: ['x', 'y', 'z'], numbers: positions }];
  if (normals) columns.push({ names: ['nx', 'ny', 'nz'], numbers: normals });
  if (uvs?.[0]) columns.push({ names: ['s', 't'], numbers: uvs[0].map((x, k) => (k % 2 ? 1 - x : x)) });
  if (colors) columns.push({ names: ['red', 'green', 'blue', 'alpha'], numbers: colors });
  columns.push(...more);
  const [vertices, triangles] = [vertexCount(mesh), triangleCount(mesh)];
  const properties = columns.flatMap(({ names }) => names);
  const head = new TextEncoder().encode(
    [
      'ply',
      'format binary_little_endian 1.0',
      `element vertex ${vertices}`,
      ...properties.map((name) => `property float ${name}`),
      `element face ${triangles}`,
      'property list uchar int vertex_indices',
      'end_header',
      '',
    ].join('\n'),
  );
  const bytes = new Uint8Array(head.length + vertices * properties.length * 4 + triangles * 13);
  bytes.set(head);
  const view = new DataView(bytes.buffer);
  let at = head.length;
  for (let vertex = 0; vertex < vertices; vertex++)
    for (const { names, numbers } of columns)
      for (let k = 0; k < names.length; k++, at += 4) view.setFloat32(at, numbers[vertex * names.length + k]!, true);
  for (let k = 0; k < indices.length; k++) {
    if (k % 3 === 0) view.setUint8(at++, 3);
    view.setInt32(at, indices[k]!, true);
    at += 4;
  }
  return bytes;
}
