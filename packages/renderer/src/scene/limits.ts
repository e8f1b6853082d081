/**
 * How much a scene may hold: the same everywhere, so that a scene that parses can be drawn. What is named like a type of shapes counts
 * shapes of this type.
 */
export const SCENE_LIMITS = {
  sphere: 128,
  box: 128,
  plane: 32,
  quad: 64,
  mesh: 32_768,
  light: 16,
  material: 352,
  /** Meshes that shapes may name. */
  meshSource: 4096,
  /** Of all meshes of a scene together: whole numbers up to here are exact in the 32-bit floats of kernels' tables. */
  meshVertices: 2 ** 24,
  meshTriangles: 2 ** 24,
  track: 1024,
  keysPerTrack: 4096,
  nameLength: 200,
  maxReflections: 64,
  lightSamples: 256,
  maxDepth: 4096,
  /** Characters of a scene file, and values (numbers, texts, objects, lists) in it: what reading one may cost. */
  fileCharacters: 32 * 1024 * 1024,
  fileValues: 1_000_000,
} as const;
