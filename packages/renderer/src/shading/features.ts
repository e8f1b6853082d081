/** The switches of features.wesl: what a program can do. */
export const FEATURES = [
  'hasSpheres',
  'hasBoxes',
  'hasTurnedBoxes',
  'hasQuads',
  'hasPlanes',
  'hasMeshes',
  'hasTextures',
  'hasNormalMaps',
  'hasVertexMore',
  'hasOtherLookups',
  'hasOneSided',
  'hasCutouts',
  'hasSphereLights',
  'hasQuadLights',
  'hasBoxLights',
  'hasPointLights',
  'hasSuns',
  'hasSky',
  'hasEnvironment',
  'hasManyLights',
  'hasMeshLamps',
  'hasLightTree',
  'hasVariedLamps',
  'hasMirrorLayers',
  'hasMetallicRoughness',
  'hasConductors',
  'hasGlass',
  'hasCompensation',
  'hasLayers',
  'hasCoats',
  'hasSheen',
  'hasGrain',
  'hasTransmission',
  'hasIridescence',
  'hasCoatNormals',
  'hasLens',
  'hasOtherProjections',
  'hasFilter',
] as const;
export type Feature = (typeof FEATURES)[number];

/**
 * What only scenes with models ask for: meshes, glTF's materials, and lights by the hundred. Their programs are twice as long; so there are two texts of each, one
 * that knows nothing of these, and one of everything, which a page loads when such a scene comes (model-shaders.ts).
 */
export const MODEL_FEATURES: readonly Feature[] = [
  'hasMeshes',
  'hasTextures',
  'hasNormalMaps',
  'hasVertexMore',
  'hasOtherLookups',
  'hasOneSided',
  'hasCutouts',
  'hasLayers',
  'hasCoats',
  'hasSheen',
  'hasGrain',
  'hasTransmission',
  'hasIridescence',
  'hasCoatNormals',
  'hasMeshLamps',
  'hasLightTree',
  'hasVariedLamps',
];

export const drawsModels = (features: ReadonlySet<Feature>): boolean =>
  MODEL_FEATURES.some((feature) => features.has(feature));

/** Enough for meshes with one colour each under a sky. */
export const PLAIN_MODEL_FEATURES: readonly Feature[] = ['hasMeshes', 'hasSky', 'hasMetallicRoughness'];

/** Of a program that draws all but models. */
export const SHAPE_FEATURES: readonly Feature[] = FEATURES.filter((feature) => !MODEL_FEATURES.includes(feature));

/** What features.wesl has switched on: enough for most scenes made of shapes and lights. */
export const COMMON_FEATURES: readonly Feature[] = [
  'hasSpheres',
  'hasBoxes',
  'hasTurnedBoxes',
  'hasPlanes',
  'hasSphereLights',
  'hasSky',
  'hasManyLights',
  'hasMirrorLayers',
];

/** The switches of a program with these features and no others. */
export const switchesFor = (features: Iterable<Feature>): Record<string, boolean> => {
  const on = new Set(features);
  return Object.fromEntries(FEATURES.map((feature) => [feature, on.has(feature)]));
};
/** Of a program that can do everything. */
export const ALL_SWITCHES = switchesFor(FEATURES);
