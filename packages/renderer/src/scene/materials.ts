/** The plainest material, from which programs make others: white, matte, nothing else to it. (A file's own defaults stand in its schema.) */
import type { MaterialLayers } from './material-layers.ts';
import type { Material } from './scene.ts';

export const MATTE: Omit<Material, keyof MaterialLayers> = {
  type: 'diffuse',
  baseColor: [1, 1, 1],
  roughness: 1,
  specular: 0,
  reflectivity: 0,
  metallic: 0,
  ior: 1.5,
  conductor: { eta: [0, 0, 0], k: [0, 0, 0] },
  attenuationColor: [1, 1, 1],
  attenuationDistance: 0,
  thin: false,
  emission: [0, 0, 0],
  energyCompensation: false,
};
