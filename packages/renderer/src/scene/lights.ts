import type { Light, Scene, SphereLight } from './scene.ts';

const isSphere = (light: Light): light is SphereLight => light.type === 'sphere';

/** The lights that the classic integrator knows, in the order of the file. */
export const sphereLights = (scene: Scene): SphereLight[] => Object.values(scene.lights).filter(isSphere);
