/** Layered materials as rows of a scene table, packed as scenes are. */

import { pathFeatures } from '../../../../packages/renderer/src/integrator/path/path-features.ts';
import { layerValues } from '../../../../packages/renderer/src/packed-scene/layer-values.ts';
import { TABLE_WIDTH } from '../../../../packages/renderer/src/packed-scene/layout.ts';
import { writeRow } from '../../../../packages/renderer/src/packed-scene/pack-scene.ts';
import { surfaceValues } from '../../../../packages/renderer/src/packed-scene/surface-values.ts';
import { createBlock } from '../../../../packages/renderer/src/packed-scene/write-struct.ts';
import { isLayered } from '../../../../packages/renderer/src/scene/layered.ts';
import type { Shape } from '../../../../packages/renderer/src/scene/scene.ts';
import sheenWesl from '../../../../packages/renderer/src/shading/bsdf/layers/sheen.wesl?raw';
import { switchesFor } from '../../../../packages/renderer/src/shading/features.ts';
import { materialOf } from '../../../fixtures/layers/as-material.ts';
import type { LayeredMaterial } from '../../../fixtures/layers/layered-material.ts';
import { sheenFit } from '../../../fixtures/layers/sheen-fit.ts';
import { testScene } from '../../../fixtures/scenes.ts';
import type { SurfaceTable } from '../bsdf/questions.ts';

export const albedoOfSheen = sheenFit(sheenWesl);

/** The surface of material i lies in row i, its layers, if it has any, below all surfaces. */
export function layerTable(materials: readonly LayeredMaterial[], energyCompensation = false): SurfaceTable {
  const table = createBlock(2 * materials.length * TABLE_WIDTH * 16);
  materials.forEach((given, row) => {
    const material = { ...materialOf(given), energyCompensation };
    const layers = isLayered(material) ? materials.length + row : 0;
    writeRow(table, 'Surface', row, surfaceValues(material, null, 0, layers));
    writeRow(table, 'Layers', materials.length + row, layerValues(material));
  });
  return { rows: table, coats: materials.map(({ coatNormal }) => coatNormal) };
}

/** Of the program that a scene of balls of these is drawn by. */
export function switchesOf(materials: readonly LayeredMaterial[]): Record<string, boolean> {
  const ball = (material: string): Shape => ({ type: 'sphere', center: [0, 0, 0], radius: 1, material });
  const named = Object.fromEntries(materials.map((m, i) => [`m${i}`, materialOf(m)]));
  const shapes = Object.fromEntries(Object.keys(named).map((name) => [name, ball(name)]));
  const scene = testScene(shapes, {}, { materials: named });
  return switchesFor(pathFeatures({ scene, camera: scene.camera, settings: { pixelFilter: 'box' } }));
}
