/** Shapes of formulas as triangles, for formats that know nothing else. */
import type { Mesh } from '../../scene/mesh.ts';

const SPHERE_ROWS = 32;

/** Radius 1 about the origin, with the sphere's own normals. Vertices lie on the sphere, so the solid is a little smaller. */
export function unitSphere(rows = SPHERE_ROWS): Mesh {
  const columns = 2 * rows;
  const positions: number[] = [];
  for (let row = 0; row <= rows; row++)
    for (let column = 0; column < columns; column++) {
      const [theta, phi] = [(Math.PI * row) / rows, (2 * Math.PI * column) / columns];
      positions.push(Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi));
    }
  const indices: number[] = [];
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const [a, b] = [row * columns + column, row * columns + ((column + 1) % columns)];
      const [c, d] = [a + columns, b + columns];
      if (row > 0) indices.push(a, d, b);
      if (row < rows - 1) indices.push(a, c, d);
    }
  const points = Float32Array.from(positions);
  return { positions: points, normals: points, indices: Uint32Array.from(indices) };
}

/** From −½ to ½, flat, seen from outside. */
export function unitBox(): Mesh {
  const positions = Float32Array.from({ length: 24 }, (_, i) => ((Math.floor(i / 3) >> (i % 3)) & 1) - 0.5);
  const faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]; // biome-ignore format: six faces
  return { positions, indices: Uint32Array.from(faces.flatMap(([a, b, c, d]) => [a!, b!, c!, a!, c!, d!])) };
}

/** x and y from 0 to 1, seen from +z. */
export const unitQuad = (): Mesh => ({
  positions: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0),
  indices: Uint32Array.of(0, 1, 2, 0, 2, 3),
});
