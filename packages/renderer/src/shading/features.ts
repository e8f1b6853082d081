/** The switches of features.wesl: what a program can do. */
export const FEATURES = [
  'hasSpheres',
  'hasBoxes',
  'hasTurnedBoxes',
  'hasQuads',
  'hasPlanes',
  'hasMeshes',
  'hasSphereLights',
  'hasQuadLights',
  'hasBoxLights',
  'hasPointLights',
  'hasSuns',
  'hasSky',
  'hasEnvironment',
  'hasManyLights',
  'hasMirrorLayers',
  'hasMetallicRoughness',
  'hasConductors',
  'hasGlass',
  'hasCompensation',
  'hasLayers',
  'hasIridescence',
  'hasLens',
  'hasOtherProjections',
  'hasFilter',
] as const;
export type Feature = (typeof FEATURES)[number];

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
