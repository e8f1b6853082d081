/**
 * Ureña, Fajardo & King, "An Area-Preserving Parametrization for Spherical Rectangles", EGSR 2013, with the paper's names, read off
 * its listing. The shader has the same map in another form.
 */
import type { Vec3 } from '../../scene/scene.ts';
import { add, cross, dot, length, negate, normalize, scale, subtract } from '../../scene/vec3.ts';
import type { Square } from './emitter.ts';

export interface SphericalRectangle {
  readonly x: Vec3;
  readonly y: Vec3;
  readonly z: Vec3;
  readonly x0: number;
  readonly y0: number;
  readonly z0: number;
  readonly x1: number;
  readonly y1: number;
  readonly b0: number;
  readonly b1: number;
  readonly k: number;
  /** Solid angle. */
  readonly S: number;
}

const clamp = (a: number, low: number, high: number) => Math.min(Math.max(a, low), high);

/** The rectangle s + a·ex + b·ey as seen from o. */
export function sphericalRectangle(s: Vec3, ex: Vec3, ey: Vec3, o: Vec3): SphericalRectangle {
  const [x, y] = [normalize(ex), normalize(ey)];
  const d = subtract(s, o);
  const towards = cross(x, y);
  const z = dot(d, towards) > 0 ? negate(towards) : towards;
  const [x0, y0, z0] = [dot(d, x), dot(d, y), dot(d, z)];
  const [x1, y1] = [x0 + length(ex), y0 + length(ey)];
  const corners: Vec3[] = [
    [x0, y0, z0],
    [x1, y0, z0],
    [x1, y1, z0],
    [x0, y1, z0],
  ];
  const n = corners.map((corner, i) => normalize(cross(corner, corners[(i + 1) % 4]!)));
  const g = n.map((normal, i) => Math.acos(clamp(-dot(normal, n[(i + 1) % 4]!), -1, 1)));
  const k = 2 * Math.PI - g[2]! - g[3]!;
  return { x, y, z, x0, y0, z0, x1, y1, b0: n[0]![2], b1: n[2]![2], k, S: g[0]! + g[1]! - k };
}

/** From o to a point of the rectangle, uniform in solid angle. */
export function pointOfRectangle(r: SphericalRectangle, [u, v]: Square): Vec3 {
  const au = u * r.S + r.k;
  const fu = (Math.cos(au) * r.b0 - r.b1) / Math.sin(au);
  const cu = clamp(Math.sign(fu) / Math.sqrt(fu ** 2 + r.b0 ** 2), -1, 1);
  const xu = clamp(-(cu * r.z0) / Math.sqrt(Math.max(1 - cu ** 2, 1e-300)), r.x0, r.x1);
  const d = Math.sqrt(xu ** 2 + r.z0 ** 2);
  const h0 = r.y0 / Math.sqrt(d ** 2 + r.y0 ** 2);
  const h1 = r.y1 / Math.sqrt(d ** 2 + r.y1 ** 2);
  const hv = h0 + v * (h1 - h0);
  const yv = hv ** 2 < 1 - 1e-15 ? (hv * d) / Math.sqrt(1 - hv ** 2) : r.y1;
  return add(add(scale(r.x, xu), scale(r.y, yv)), scale(r.z, r.z0));
}
