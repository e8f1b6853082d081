import type { Integrator, Material, Scene } from './scene.ts';

const plain = (material: Material): Material => ({ ...material, type: 'diffuse', emission: [0, 0, 0] });

/** The scene without what the integrator knows nothing of: the classic one takes all materials for matte, and all lights are spheres. */
export function sceneSeenBy(integrator: Integrator, scene: Scene): Scene {
  if (integrator === 'path') return scene;
  const lights = Object.entries(scene.lights).filter(([, light]) => light.type === 'sphere');
  const materials = Object.entries(scene.materials).map(([name, material]) => [name, plain(material)] as const);
  return { ...scene, lights: Object.fromEntries(lights), materials: Object.fromEntries(materials) };
}
