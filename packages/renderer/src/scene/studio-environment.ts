/** The light that a model is shown in when its file has none. */
import { type EnvironmentMap, environmentDirection } from './environment.ts';
import type { Vec3 } from './scene.ts';
import { dot, normalize } from './vec3.ts';

interface Softbox {
  readonly direction: Vec3;
  /** Cosine of the angle at which it has half of its light. */
  readonly cosine: number;
  readonly radiance: number;
}

/** A large one overhead from the front left, a weaker one from the right, a thin one from behind that draws an edge. */
const SOFTBOXES: readonly Softbox[] = [
  { direction: normalize([-0.5, 0.9, 0.6]), cosine: Math.cos(0.45), radiance: 3.9 },
  { direction: normalize([0.95, 0.35, 0.35]), cosine: Math.cos(0.3), radiance: 1.6 },
  { direction: normalize([0.3, 0.55, -0.9]), cosine: Math.cos(0.25), radiance: 2.3 },
];
/** How soft the edges are, in cosines. */
const EDGE = 0.02;

function radianceAt(direction: Vec3): number {
  // From a grey floor to a lighter ceiling, so that nothing is black in a mirror.
  const room = 0.2 + 0.14 * direction[1];
  return SOFTBOXES.reduce((sum, { direction: to, cosine, radiance }) => {
    const inside = 1 / (1 + Math.exp((cosine - dot(direction, to)) / EDGE));
    return sum + inside * radiance;
  }, room);
}

/**
 * A room of neutral grey with three soft boxes. White that faces the key light sends back radiance 1. Made by a formula:
 * 128 × 64 texels, the same numbers everywhere.
 */
export function studioEnvironment(): EnvironmentMap {
  const [width, height] = [128, 64];
  const data = new Float32Array(width * height * 3);
  for (let j = 0; j < height; j++)
    for (let i = 0; i < width; i++) {
      const radiance = radianceAt(environmentDirection((i + 0.5) / width, (j + 0.5) / height));
      data.fill(radiance, 3 * (j * width + i), 3 * (j * width + i) + 3);
    }
  return { width, height, data };
}
