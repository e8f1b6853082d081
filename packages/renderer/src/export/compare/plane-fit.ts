/** The variance that is left of values on points of a plane after the best a + b x + c y is taken off. */
export function residualVariance(
  points: readonly { readonly x: number; readonly y: number }[],
  values: readonly number[],
): number {
  const count = points.length;
  if (count < 8) return 0;
  const mean = (value: (index: number) => number): number => {
    let sum = 0;
    for (let i = 0; i < count; i++) sum += value(i);
    return sum / count;
  };
  // About the points' middle the constant separates, and two equations are left.
  const [mx, my, mv] = [mean((i) => points[i]!.x), mean((i) => points[i]!.y), mean((i) => values[i]!)];
  const dx = (i: number): number => points[i]!.x - mx;
  const dy = (i: number): number => points[i]!.y - my;
  const dv = (i: number): number => values[i]! - mv;
  const [xx, xy, yy] = [mean((i) => dx(i) ** 2), mean((i) => dx(i) * dy(i)), mean((i) => dy(i) ** 2)];
  const [xv, yv] = [mean((i) => dx(i) * dv(i)), mean((i) => dy(i) * dv(i))];
  const determinant = xx * yy - xy * xy;
  const isFlat = determinant > 1e-9 * xx * yy;
  const b = isFlat ? (xv * yy - yv * xy) / determinant : 0;
  const c = isFlat ? (yv * xx - xv * xy) / determinant : 0;
  return (mean((i) => (dv(i) - b * dx(i) - c * dy(i)) ** 2) * count) / (count - 3);
}
