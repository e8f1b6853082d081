/**
 * How much a scene may hold: the same everywhere, so that a scene that parses can be drawn. What is named like a type of shapes counts
 * shapes of this type. Those of a formula are tested one after another, so that more of them than these would be slow; meshes have trees.
 */
export const SCENE_LIMITS = {
  sphere: 512,
  box: 512,
  plane: 64,
  quad: 512,
  mesh: 32_768,
  light: 4096,
  /** Of lights those with a surface, spheres and quads: they are shapes too, and the classic integrator looks at each. */
  surfaceLight: 64,
  material: 4096,
  /** Meshes that shapes may name. */
  meshSource: 4096,
  /** Of all meshes of a scene together: whole numbers up to here are exact in the 32-bit floats of kernels' tables. */
  meshVertices: 2 ** 24,
  meshTriangles: 2 ** 24,
  node: 65_536,
  skin: 1024,
  jointsPerSkin: 1024,
  image: 1024,
  texture: 4096,
  clip: 1024,
  tracksPerClip: 4096,
  variant: 1024,
  camera: 1024,
  /** Files of models. */
  model: 64,
  /** Of one mesh shape in a scene file. */
  instances: 65_536,
  /** Pixels of an image on a side, and bytes of all images of a scene. */
  imageSide: 16_384,
  imageBytes: 2 ** 31,
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
