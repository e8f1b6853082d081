/**
 * A normal turned towards the geometric one, just as far as the mirrored ray needs to come out of the surface: docs/materials.md, "Normal
 * maps". By bisection of the angle, where the kernels have a closed form.
 */
import type { Vec3 } from '../../scene/scene.ts';
import { add, dot, normalize, scale, subtract } from '../../scene/vec3.ts';

const STEPS = 60;

/** Unit vectors; `towardsEye` is on the side that `geometric` looks to. */
export function bentNormal(geometric: Vec3, towardsEye: Vec3, normal: Vec3): Vec3 {
  const height = dot(geometric, towardsEye);
  const least = Math.min(0.9 * height, 0.01);
  const mirroredHeight = (n: Vec3) => 2 * dot(n, towardsEye) * dot(n, geometric) - height;
  if (mirroredHeight(normal) >= least) return normal;
  const across = normalize(subtract(normal, scale(geometric, dot(normal, geometric))));
  const tilted = (angle: number) => add(scale(geometric, Math.cos(angle)), scale(across, Math.sin(angle)));
  // Upright it is high enough; of all tilts that are, the largest one below that of the normal.
  let low = 0;
  let high = Math.acos(Math.min(Math.max(dot(normal, geometric), -1), 1));
  for (let i = 0; i < STEPS; i++) {
    const middle = (low + high) / 2;
    if (mirroredHeight(tilted(middle)) >= least) low = middle;
    else high = middle;
  }
  return tilted(low);
}
