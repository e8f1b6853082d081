import { aovFilms } from './aov.ts';
import { bentByDevice } from './bending.ts';
import { chiSquareSamples, probeEdges, probeEvaluation, probeSamples } from './bsdf/probe.ts';
import { cameraRays } from './camera-probe.ts';
import { compileAll } from './compile.ts';
import { describeDevices } from './devices.ts';
import { displayed } from './displayed.ts';
import { displayedView } from './displayed-views.ts';
import { probeChoices, probeTree } from './emitters/choices.ts';
import { probeEnvironments } from './emitters/environments.ts';
import { probeFarLights } from './emitters/far-lights.ts';
import { probeLamps } from './emitters/lamps.ts';
import { probeMeshLamps } from './emitters/mesh-lamps.ts';
import { probeWildLamps } from './emitters/wild-lamps.ts';
import { fuzz, fuzzLeast } from './fuzz.ts';
import { hardNames, hardPicture, leaks, movedPicture } from './hard-pictures.ts';
import { headlessFilms } from './headless.ts';
import { layerFurnaces, layersFromBothEnds, layersOverSphere } from './layers/sphere.ts';
import { probeLayerEdges, probeLayers, probeLayersAlone } from './layers/values.ts';
import { playedFilms, playedLate, playFrames, switchMovingScenes } from './motion.ts';
import { orderAndParts } from './order-and-parts.ts';
import { parity, pictureOf } from './parity.ts';
import { pathFilms } from './path.ts';
import { relayedFilms } from './relay.ts';
import { probeSampler } from './sampler/probe.ts';
import { shadeMean } from './shade-mean.ts';
import { probeShapes } from './shapes/probe.ts';
import { layerTextures } from './textures/layers.ts';
import { lightCases, tiltedLight } from './textures/light.ts';
import { probeLookups } from './textures/lookups.ts';
import { texturedSights } from './textures/sights.ts';

/**
 * What specs call inside the browser: `page.evaluate((size) => window.harness.something(size), 64)`.
 * Arguments and results go through JSON-like copying, so results are plain objects and ordinary arrays.
 */
export const harness = {
  aovFilms,
  bentByDevice,
  cameraRays,
  describeDevices,
  displayed,
  displayedView,
  fuzz,
  fuzzLeast,
  hardNames,
  hardPicture,
  headlessFilms,
  layerFurnaces,
  layersFromBothEnds,
  layersOverSphere,
  layerTextures,
  leaks,
  movedPicture,
  orderAndParts,
  parity,
  pathFilms,
  pictureOf,
  playedFilms,
  playedLate,
  playFrames,
  probeSampler,
  relayedFilms,
  probeChoices,
  probeTree,
  probeEnvironments,
  probeFarLights,
  probeLamps,
  probeLayerEdges,
  probeLayers,
  probeLayersAlone,
  probeMeshLamps,
  probeLookups,
  probeShapes,
  probeWildLamps,
  lightCases,
  shadeMean,
  switchMovingScenes,
  texturedSights,
  tiltedLight,
  compileAll,
  chiSquareSamples,
  probeEdges,
  probeEvaluation,
  probeSamples,
};

declare global {
  interface Window {
    harness: typeof harness;
  }
}
window.harness = harness;
