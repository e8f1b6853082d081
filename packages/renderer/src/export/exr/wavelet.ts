/** The inverse of OpenEXR's two-dimensional Haar wavelet (ImfWav.cpp), in place. */

/** nx × ny values, `ox` apart in a row, rows `oy` apart. */
export interface Grid {
  readonly nx: number;
  readonly ox: number;
  readonly ny: number;
  readonly oy: number;
}

/** What came of a pair: its mean-like and its difference-like value are kept here, since JavaScript gives but one back. */
let low = 0;
let high = 0;

/** For values below 2^14, which leave room for a sign. */
function split14(l: number, h: number): void {
  const difference = (h << 16) >> 16;
  const a = ((l << 16) >> 16) + (difference & 1) + (difference >> 1);
  low = a & 0xffff;
  high = (a - difference) & 0xffff;
}

/** For all 16 bits, modulo 2^16. */
function split16(l: number, h: number): void {
  high = (l - (h >> 1)) & 0xffff;
  low = (h + high - 0x8000) & 0xffff;
}

/** `most`: the largest value that the data had before. */
export function restoreWavelet(data: Uint16Array, start: number, { nx, ox, ny, oy }: Grid, most: number): void {
  const split = most < 1 << 14 ? split14 : split16;
  const pair = (a: number, b: number): void => {
    split(data[a]!, data[b]!);
    data[a] = low;
    data[b] = high;
  };
  let step = 1;
  while (step * 2 <= Math.min(nx, ny)) step *= 2;
  for (let p = step >> 1; p >= 1; p >>= 1) {
    const p2 = p * 2;
    const [right, down] = [p * ox, p * oy];
    for (let y = 0; y + p2 <= ny; y += p2) {
      const row = start + y * oy;
      for (let x = 0; x + p2 <= nx; x += p2) {
        const at = row + x * ox;
        pair(at, at + down);
        pair(at + right, at + right + down);
        pair(at, at + right);
        pair(at + down, at + right + down);
      }
      // A column and a row may be left over on each scale.
      if (nx & p) pair(row + (nx - (nx % p2)) * ox, row + (nx - (nx % p2)) * ox + down);
    }
    if (ny & p) {
      const row = start + (ny - (ny % p2)) * oy;
      for (let x = 0; x + p2 <= nx; x += p2) pair(row + x * ox, row + x * ox + right);
    }
  }
}
