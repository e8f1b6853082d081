/**
 * What the camera sees first, as a stage of two kinds, for both integrators: `features` are means over the film samples, `data` is of
 * one sample of each pixel. docs/aov.md says what is in them; `headless/aovs.ts` takes them out.
 */
import type {
  DataBuffer,
  Device,
  FilmTexture,
  FloatTexture,
  Pass,
  PassSource,
  Region,
  TableTexture,
  UniformBuffer,
} from '../../gpu/device.ts';
import { FILTER_PIECES, GEOMETRY, SCENE_TABLE, TEXELS } from '../../packed-scene/layout.ts';
import type { StructValues } from '../../packed-scene/write-struct.ts';
import type { Integrator } from '../../scene/scene.ts';
import { type Feature, SHAPE_FEATURES } from '../../shading/features.ts';
import aovWgsl from '../../shading/generated/aov.wgsl?raw';
import aovDataGlsl from '../../shading/generated/aovData.glsl?raw';
import aovFeaturesGlsl from '../../shading/generated/aovFeatures.glsl?raw';
import fullScreenWgsl from '../../shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../../shading/generated/fullScreen.glsl?raw';
import { sourceFor } from '../../shading/program-text.ts';

/** Sums of albedo and samples, and of shading normal and hits; or place and shape, and geometric normal and closeness. */
export type AovContent = 'features' | 'data';

/** Layers of the film that each needs. */
export const AOV_LAYERS = 2;

const FEATURES: PassSource = {
  label: 'aov features',
  wgsl: { vertex: fullScreenWgsl, fragment: aovWgsl },
  entries: { vertex: 'fullScreen', fragment: 'aovFeatures' },
  glsl: { vertex: fullScreenGlsl, fragment: aovFeaturesGlsl },
  bindings: [
    { block: 'Frame' },
    SCENE_TABLE,
    { texture: 'previousFirst' },
    { texture: 'previousSecond' },
    { texture: 'environment' },
    GEOMETRY,
    TEXELS,
  ],
  target: 'film',
  layers: AOV_LAYERS,
};
const DATA: PassSource = {
  ...FEATURES,
  label: 'aov data',
  entries: { vertex: 'fullScreen', fragment: 'aovData' },
  glsl: { vertex: fullScreenGlsl, fragment: aovDataGlsl },
};

export interface AovInputs {
  readonly frame: UniformBuffer;
  readonly sceneTable: TableTexture;
  /** The layers of the film so far. */
  readonly previous: readonly FloatTexture[];
  readonly environment: TableTexture;
  readonly geometry: DataBuffer;
  readonly texels: DataBuffer;
}

/** Of a camera and a filter, which change while somebody watches: every program has them. */
const ASKED_OF_RAYS: readonly Feature[] = ['hasLens', 'hasOtherProjections', 'hasFilter'];
/** What of a scene with models is seen in AOVs: not its lights, and of layers only whether light goes through, on which normals turn. */
const SEEN: readonly Feature[] = [
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
  'hasMetallicRoughness',
  'hasGlass',
  'hasTransmission',
];

/** Of what paths need for a scene, what a program for its AOVs does. One program has all that scenes without models may need. */
export function aovFeatures(needs: ReadonlySet<Feature>): ReadonlySet<Feature> {
  if (!needs.has('hasMeshes')) return new Set(SHAPE_FEATURES);
  const features = new Set([...ASKED_OF_RAYS, ...SEEN.filter((feature) => needs.has(feature))]);
  return needs.has('hasTransmission') ? features.add('hasLayers') : features;
}

/** A program for scenes that ask for no more than these features. */
export async function createAovPass(
  device: Device,
  content: AovContent,
  features: ReadonlySet<Feature>,
): Promise<Pass> {
  const source = content === 'features' ? FEATURES : DATA;
  return device.createPass(await sourceFor(source, content, features));
}

export function drawAov(device: Device, pass: Pass, film: FilmTexture, inputs: AovInputs, region: Region): void {
  device.draw(
    pass,
    film,
    [inputs.frame, inputs.sceneTable, ...inputs.previous, inputs.environment, inputs.geometry, inputs.texels],
    region,
  );
}

/**
 * What the Frame block has for this stage, so that its rays are the integrator's. The path integrator's samples lie about the centre
 * of the pixel as its filter says; the classic one's where `jitter` says, and its camera is a pinhole.
 */
export const aovFrame = (integrator: Integrator): StructValues<'Frame'> =>
  integrator === 'path' ? { jitter: [0.5, 0.5] } : { filterPieces: new Array(4 * FILTER_PIECES).fill(0), aperture: 0 };
