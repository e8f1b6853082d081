/**
 * Fits E, the share of light that white fibres of KHR_materials_sheen send back, for shading/bsdf/layers/sheen.wesl: the root of E as a
 * polynomial in the fourth root of the cosine and the root of the roughness, by least squares whose weights follow the largest error
 * (Lawson's algorithm). `npx tsx scripts/fits/sheen-albedo.ts` prints the coefficients and how far off they are; tests/fixtures/layers/
 * has E itself, and its test the proof.
 */
import { sheenAlbedo } from '../../tests/fixtures/layers/sheen.ts';

const DEGREE_OF_COSINE = 7;
const DEGREE_OF_ROUGHNESS = 5;
const LEAST_ROUGHNESS = 0.07;
const LEAST_COSINE = 1e-4;
const ROUNDS = 60;

/** −1 … 1 as the variable runs from its least to its greatest. */
const centred = (x: number, least: number): number => (2 * (x - least)) / (1 - least) - 1;
const ofCosine = (cosine: number): number => centred(cosine ** 0.25, LEAST_COSINE ** 0.25);
const ofRoughness = (roughness: number): number => centred(Math.sqrt(roughness), Math.sqrt(LEAST_ROUGHNESS));

interface Point {
  readonly terms: Float64Array;
  readonly albedo: number;
  weight: number;
}

/** Powers of both, the cosine's changing slowest. */
function termsAt(u: number, v: number): Float64Array {
  const terms: number[] = [];
  for (let i = 0; i <= DEGREE_OF_COSINE; i++)
    for (let j = 0; j <= DEGREE_OF_ROUGHNESS; j++) terms.push(u ** i * v ** j);
  return Float64Array.from(terms);
}

/** Places close together towards the ends, as Chebyshev's are. */
const spread = (n: number): number[] =>
  Array.from({ length: n }, (_, i) => (1 - Math.cos((Math.PI * i) / (n - 1))) / 2);

function points(): Point[] {
  const least = [LEAST_COSINE ** 0.25, Math.sqrt(LEAST_ROUGHNESS)] as const;
  return spread(40).flatMap((a) =>
    spread(28).map((b) => {
      const cosine = (least[0] + (1 - least[0]) * a) ** 4;
      const roughness = (least[1] + (1 - least[1]) * b) ** 2;
      const terms = termsAt(ofCosine(cosine), ofRoughness(roughness));
      return { terms, albedo: sheenAlbedo(cosine, roughness), weight: 1 };
    }),
  );
}

/** Where E is beyond 1 the lobe is divided by it: there errors count as shares of it. */
const errorAt = ({ terms, albedo }: Point, c: Float64Array): number =>
  (dot(terms, c) ** 2 - albedo) / Math.max(albedo, 1);
const dot = (a: Float64Array, b: Float64Array): number => a.reduce((sum, x, i) => sum + x * b[i]!, 0);

/** Weighted least squares of the root of E by normal equations and Gauss's elimination. */
function solve(all: readonly Point[]): Float64Array {
  const n = all[0]!.terms.length;
  const rows = Array.from({ length: n }, () => new Float64Array(n + 1));
  for (const { terms, albedo, weight } of all) {
    // An error of the root is worth so much of E.
    const w = weight * ((2 * Math.sqrt(albedo)) / Math.max(albedo, 1) + 1e-3) ** 2;
    for (let i = 0; i < n; i++) {
      for (let j = 0; j < n; j++) rows[i]![j]! += w * terms[i]! * terms[j]!;
      rows[i]![n]! += w * terms[i]! * Math.sqrt(albedo);
    }
  }
  for (let k = 0; k < n; k++) {
    const best = rows.slice(k).reduce((at, row, i) => (Math.abs(row[k]!) > Math.abs(rows[at]![k]!) ? k + i : at), k);
    [rows[k], rows[best]] = [rows[best]!, rows[k]!];
    for (let i = 0; i < n; i++) {
      if (i === k) continue;
      const factor = rows[i]![k]! / rows[k]![k]!;
      for (let j = k; j <= n; j++) rows[i]![j]! -= factor * rows[k]![j]!;
    }
  }
  return Float64Array.from(rows, (row, i) => row[n]! / row[i]!);
}

const all = points();
let best: { worst: number; c: Float64Array } = { worst: Number.POSITIVE_INFINITY, c: new Float64Array() };
for (let round = 0; round < ROUNDS; round++) {
  const c = solve(all);
  const errors = all.map((p) => Math.abs(errorAt(p, c)));
  const worst = Math.max(...errors);
  if (worst < best.worst) best = { worst, c };
  all.forEach((p, i) => {
    p.weight *= 1 + errors[i]! / worst;
  });
  const mean = all.reduce((sum, { weight }) => sum + weight, 0) / all.length;
  for (const p of all) p.weight /= mean;
}
for (let i = 0; i <= DEGREE_OF_COSINE; i++) {
  const row = [...best.c.slice(i * (DEGREE_OF_ROUGHNESS + 1), (i + 1) * (DEGREE_OF_ROUGHNESS + 1))];
  console.log(row.map((x) => Number(x.toPrecision(6))).join(', '));
}
console.log(`At most ${best.worst.toPrecision(3)} off, of E or, where it is above 1, of its value.`);
