/**
 * Choosing one of many in proportion to their weights, so that numbers which lie side by side choose what lies side by side: points
 * that are even stay even. A number's place among the sums of the weights is looked for from where a guide says: Chen & Asau, "On
 * Generating Random Variates from an Empirical Distribution", AIIE Transactions 6, 1974.
 *
 * Entry i is two floats. The first is the share that all weights up to and with i have, in whole steps of 2^-24. The second is a number
 * of 24 bits: the lower 12 are further digits of that share, the upper 12 are of the i-th of n equal parts of [0, 1), which pair of
 * entries, 2 k and 2 k + 1, is the first to be chosen there.
 */
const STEPS = 2 ** 24;
const FINE = 2 ** 12;

/** In a table: times the 24 bits of a number that is what the kernel's products hold. */
export const MOST_ENTRIES = 4096;

/** Floats of a table of n entries: pairs are whole. */
export const inversionTableSize = (n: number): number => 4 * Math.ceil(n / 2);

/** From `at` on. At most `MOST_ENTRIES` weights, finite and not negative; without any weight all is 0. */
export function writeInversionTable(to: Float32Array, at: number, weights: Float64Array): void {
  const n = weights.length;
  let total = 0;
  for (let i = 0; i < n; i++) total += weights[i]!;
  if (total === 0) return;
  let sum = 0;
  let part = 0;
  for (let i = 0; i < n; i++) {
    sum += weights[i]!;
    // Sums in the same order: the last one is the total.
    const share = Math.round((sum / total) * STEPS * FINE);
    const whole = Math.floor(share / FINE);
    to[at + 2 * i] = whole;
    to[at + 2 * i + 1] = to[at + 2 * i + 1]! + share - whole * FINE;
    // The parts that begin before this share ends.
    for (; part < n && part * STEPS * FINE < share * n; part++)
      to[at + 2 * part + 1] = to[at + 2 * part + 1]! + FINE * Math.floor(i / 2);
  }
  // What makes the last pair whole is never chosen.
  if (n % 2 === 1) to[at + 2 * n] = STEPS;
}
