/** What a glTF file may ask of this machine. Everything is held against these before anything of its size is made. */
export const GLTF_LIMITS = {
  /** Bytes of the JSON part. */
  jsonBytes: 2 ** 28,
  /** Bytes of all arrays together once they are unfolded. */
  geometryBytes: 2 ** 31,
  /** How many times as large as the file they may be, beyond `freeBytes`: compressed meshes grow about a hundredfold, bombs far more. */
  growth: 1100,
  freeBytes: 2 ** 26,
  /** Of all meshes together; later stages count with 32-bit floats. */
  vertices: 2 ** 24,
  triangles: 2 ** 24,
  /** Places at which meshes stand, instances and all. */
  placements: 2 ** 20,
  imageSide: 16_384,
  /** Bytes of all decoded images together. */
  imageBytes: 2 ** 31,
  /** Metres, in any mesh. */
  farthest: 1e9,
} as const;
