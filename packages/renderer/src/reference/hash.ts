/** The random numbers of docs/classic.md: 32-bit integer hashes, the same bits as on the GPU. */

/** PCG-RXS-M-XS (Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 2020). Takes and gives a uint32. */
export function pcg(x: number): number {
  const s = (Math.imul(x, 747796405) + 2891336453) >>> 0;
  const w = Math.imul((s >>> ((s >>> 28) + 4)) ^ s, 277803737) >>> 0;
  return ((w >>> 22) ^ w) >>> 0;
}

/** h: all randomness of film sample `sample` of pixel (i, j) comes from this number. */
export const hashOfSample = (i: number, j: number, sample: number, seed: number): number =>
  pcg(i + pcg(j + pcg(sample + pcg(seed))));

/** The upper 24 bits as a number in [0, 1): what a float holds exactly. */
const toUnit = (bits: number): number => (bits >>> 8) * 2 ** -24;

/** ξ₁ and ξ₂ for the points on one light seen from one point of the path. */
export function lightRandoms(h: number, light: number, reflection: number): [number, number] {
  const first = pcg(h + 128 * light + reflection);
  return [toUnit(first), toUnit(pcg(first))];
}
