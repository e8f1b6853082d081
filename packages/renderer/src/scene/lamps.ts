/**
 * Lights that rays can meet are shapes: this step gives every visible sphere or quad light a shape of its own, so that later stages
 * know one kind of thing to hit. Only the path integrator wants it; the classic one draws its lights itself.
 */
import { MATTE } from './materials.ts';
import type { Color, Light, Material, QuadLight, Scene, Shape, SphereLight } from './scene.ts';

export interface SceneWithLamps {
  /** The scene with the lamps' shapes and materials after its own. */
  readonly scene: Scene;
  /** Names of shapes that are lamps → names of their lights. The lamp of a quad light shines to the side of u × v only. */
  readonly lightOfShape: ReadonlyMap<string, string>;
}

/** Names in scene files do not begin with a space, so this is nobody's. */
const lampName = (light: string): string => ` ${light}`;

export const timesColor = (radiance: number, [r, g, b]: Color): Color => [radiance * r, radiance * g, radiance * b];

/** What a sphere or quad light sends out. */
export const radianceOf = (light: SphereLight | QuadLight): Color =>
  timesColor(light.radiance, light.type === 'sphere' ? light.diffuse : light.color);

/** What every side of such a surface sends out. An unlit one is a black lamp of its base colour (KHR_materials_unlit). */
export const emissionOf = ({ emission, emissionStrength = 1, unlit = false, baseColor }: Material): Color =>
  unlit ? baseColor : timesColor(emissionStrength, emission);

type LampLight = SphereLight | QuadLight;
const isLamp = (light: Light): light is LampLight =>
  (light.type === 'sphere' || light.type === 'quad') && light.visible;

function lampShape(light: LampLight, material: string): Shape {
  if (light.type === 'sphere') return { type: 'sphere', center: light.center, radius: light.radius, material };
  return { type: 'quad', corner: light.corner, u: light.u, v: light.v, material };
}

/** Gives nothing back of what falls on it. */
const black = (emission: Color): Material => ({ ...MATTE, baseColor: [0, 0, 0], emission });

export function lampsAsShapes(scene: Scene): SceneWithLamps {
  const shapes: Record<string, Shape> = Object.assign(Object.create(null), scene.shapes);
  const materials: Record<string, Material> = Object.assign(Object.create(null), scene.materials);
  const lightOfShape = new Map<string, string>();
  for (const [name, light] of Object.entries(scene.lights)) {
    if (!isLamp(light)) continue;
    const lamp = lampName(name);
    materials[lamp] = black(radianceOf(light));
    shapes[lamp] = lampShape(light, lamp);
    lightOfShape.set(lamp, name);
  }
  return { scene: { ...scene, shapes, materials }, lightOfShape };
}
