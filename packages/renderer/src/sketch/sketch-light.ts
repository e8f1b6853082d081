/** The light of a sketch: what falls on a surface from the whole sky, with nothing in the way. */

import { radianceOfMap } from '../reference/light/environment.ts';
import type { Color, Sky, Vec3 } from '../scene/scene.ts';

/** Columns and rows of directions that are looked into. */
const [COLUMNS, ROWS] = [32, 16];

export interface SketchLight {
  /** Radiance of the sky. */
  background(direction: Vec3): Color;
  /** What a white matte surface with this unit normal sends back. */
  reflected(normal: Vec3): Color;
}

/**
 * By an ambient cube (McTaggart, "Half-Life 2 / Valve Source Shading", GDC 2004): irradiance from six sides, blended by the squares of the
 * normal's components. `isDark`: the sky gives no light, so that a lamp at the eye does.
 */
export function sketchLight(sky: Sky): SketchLight & { readonly isDark: boolean } {
  const background = (direction: Vec3): Color => radianceOf(sky, direction);
  const sides = new Float64Array(18);
  for (let j = 0; j < ROWS; j++)
    for (let i = 0; i < COLUMNS; i++) {
      const [phi, theta] = [(2 * Math.PI * (i + 0.5)) / COLUMNS, (Math.PI * (j + 0.5)) / ROWS];
      const direction: Vec3 = [Math.sin(theta) * Math.sin(phi), Math.cos(theta), -Math.sin(theta) * Math.cos(phi)];
      // Solid angle over π: irradiance of a white matte surface as radiance.
      const weight = (Math.sin(theta) * 2 * Math.PI) / (COLUMNS * ROWS);
      const radiance = background(direction);
      for (let side = 0; side < 6; side++) {
        const cosine = (side & 1 ? -1 : 1) * direction[side >> 1]!;
        if (cosine > 0)
          for (let c = 0; c < 3; c++) sides[3 * side + c] = sides[3 * side + c]! + weight * cosine * radiance[c]!;
      }
    }
  const reflected = (normal: Vec3): Color => {
    const color: [number, number, number] = [0, 0, 0];
    for (let axis = 0; axis < 3; axis++) {
      const side = 2 * axis + (normal[axis]! < 0 ? 1 : 0);
      for (let c = 0; c < 3; c++) color[c] = color[c]! + normal[axis]! ** 2 * sides[3 * side + c]!;
    }
    return color;
  };
  return { background, reflected, isDark: sides.every((x) => x < 0.02) };
}

function radianceOf({ horizon, zenith, map, scale = 1, rotation = 0 }: Sky, direction: Vec3): Color {
  if (map) return radianceOfMap(map, direction, rotation).map((x) => x * scale) as unknown as Color;
  const share = Math.max(direction[1], 0);
  return [0, 1, 2].map((c) => horizon[c]! + (zenith[c]! - horizon[c]!) * share) as unknown as Color;
}
