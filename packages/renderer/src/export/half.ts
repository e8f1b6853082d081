/** IEEE 754 binary16: 1 sign bit, 5 of exponent, 10 of fraction. */

const float = new Float32Array(1);
const bits = new Uint32Array(float.buffer);

/** The nearest half of a float32, ties to even; from 65520 on infinity; NaN stays NaN. */
export function floatToHalf(value: number): number {
  float[0] = value;
  const all = bits[0]!;
  const sign = (all >>> 16) & 0x8000;
  const magnitude = all & 0x7fffffff;
  if (magnitude > 0x7f800000) return sign | 0x7e00;
  if (magnitude >= 0x477ff000) return sign | 0x7c00;
  if (magnitude < 0x38800000) return sign | roundToEven(Math.abs(float[0]!) * 2 ** 24); // below 2^-14: subnormal
  const rounded = magnitude + 0xfff + ((magnitude >>> 13) & 1);
  return sign | ((rounded - 0x38000000) >>> 13); // the exponent's bias is 127 there, 15 here; a carry runs into it
}

function roundToEven(value: number): number {
  const below = Math.floor(value);
  const rest = value - below;
  return rest > 0.5 || (rest === 0.5 && below % 2 === 1) ? below + 1 : below;
}

export function halfToFloat(half: number): number {
  const sign = half & 0x8000 ? -1 : 1;
  const exponent = (half >>> 10) & 31;
  const fraction = half & 1023;
  if (exponent === 0) return sign * fraction * 2 ** -24;
  if (exponent === 31) return fraction === 0 ? sign * Infinity : NaN;
  return sign * (1024 + fraction) * 2 ** (exponent - 25);
}

let table: Float32Array | null = null;

/** All halves as floats, made when first needed: a lookup is much faster than the arithmetic. */
export function halfTable(): Float32Array {
  if (!table) {
    table = new Float32Array(65536);
    for (let half = 0; half < 65536; half++) table[half] = halfToFloat(half);
  }
  return table;
}
