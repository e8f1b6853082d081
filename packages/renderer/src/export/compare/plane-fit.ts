/** The variance that is left of values on a grid's points after the best a + b x + c y is taken off (least squares). */
export function residualVariance(x: readonly number[], y: readonly number[], values: readonly number[]): number {
  const count = values.length;
  if (count < 8) return 0;
  // About the points' middle the constant separates, and two equations are left.
  const [middleX, middleY, middle] = [meanOf(x), meanOf(y), meanOf(values)];
  let [xx, xy, yy, xv, yv, vv] = [0, 0, 0, 0, 0, 0];
  for (let i = 0; i < count; i++) {
    const [dx, dy, dv] = [x[i]! - middleX, y[i]! - middleY, values[i]! - middle];
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
    xv += dx * dv;
    yv += dy * dv;
    vv += dv * dv;
  }
  const determinant = xx * yy - xy * xy;
  const isPlane = determinant > 1e-9 * xx * yy; // else all points lie on a line
  const b = isPlane ? (xv * yy - yv * xy) / determinant : 0;
  const c = isPlane ? (yv * xx - xv * xy) / determinant : 0;
  return Math.max(0, vv - b * xv - c * yv) / (count - 3);
}

function meanOf(values: readonly number[]): number {
  let sum = 0;
  for (let i = 0; i < values.length; i++) sum += values[i]!;
  return sum / values.length;
}
