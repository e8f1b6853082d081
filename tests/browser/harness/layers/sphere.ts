/** Layered BSDFs over the whole sphere of directions: densities against samples, light that comes back, the same from both ends. */
import type { Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { directionOf } from '../../../fixtures/bsdf-cases.ts';
import { pearson } from '../../../fixtures/chi-square.ts';
import type { LayeredMaterial } from '../../../fixtures/layers/layered-material.ts';
import { seededRandom } from '../../../fixtures/random.ts';
import { type Answer, ASKED, askTable, floatVector, type Question } from '../bsdf/questions.ts';
import { type GpuBackend, probeDevice } from '../probe-device.ts';
import { verdictOn } from '../verdict.ts';
import { layerTable } from './materials.ts';
import { NAMED } from './random-layers.ts';

/** Bins of equal solid angle, the horizon between two rows of them, and midpoints along each side of a bin. */
const ROWS = 16;
const COLUMNS = 12;
const FINE = 9;
const SAMPLES = 4096;

export interface SphereReport {
  readonly name: string;
  /** χ² of the directions that samples give against the density, as standard deviations. */
  readonly z: number;
  /** Integral of the density, and share of the samples that have one. */
  readonly integral: number;
  readonly share: number;
  /** Red light that comes back by the integral of the values, and by the mean of the weights of such samples with its standard error. */
  readonly albedo: number;
  readonly weight: number;
  readonly error: number;
  /** Largest weight of a sample. */
  readonly heaviest: number;
  /** Directions with a value, but without a density: samples would not find their light. */
  readonly unfound: number;
}

function atBin(row: number, column: number): Vec3 {
  const z = 1 - (2 * row) / ROWS;
  const sine = Math.sqrt(Math.max(1 - z * z, 0));
  const phi = (2 * Math.PI * column) / COLUMNS;
  return [sine * Math.cos(phi), sine * Math.sin(phi), z];
}
const binOf = ([x, y, z]: Vec3): number => {
  const row = Math.min(Math.floor(((1 - z) / 2) * ROWS), ROWS - 1);
  const turn = (Math.atan2(y, x) / (2 * Math.PI) + 1) % 1;
  return row * COLUMNS + Math.min(Math.floor(turn * COLUMNS), COLUMNS - 1);
};
const MIDPOINTS: readonly Vec3[] = Array.from({ length: ROWS * COLUMNS * FINE * FINE }, (_, k) => {
  const [bin, at] = [Math.floor(k / FINE ** 2), k % FINE ** 2];
  const row = Math.floor(bin / COLUMNS) + (Math.floor(at / FINE) + 0.5) / FINE;
  return floatVector(atBin(row, (bin % COLUMNS) + ((at % FINE) + 0.5) / FINE));
});
const SOLID_ANGLE = (4 * Math.PI) / MIDPOINTS.length;

interface Case {
  readonly name: string;
  readonly surface: number;
  readonly wo: Vec3;
  readonly hero: number;
}

/** All of the named materials seen at this cosine, solids from inside too, and with each colour where they part. */
function casesAt(cosine: number): Case[] {
  return NAMED.flatMap(([name, m], surface) =>
    (m.solid ? [cosine, -cosine] : [cosine]).map((c) => {
      const hero = m.dispersion > 0 ? 1 : 0;
      return { name: `${name}, cosine ${c}`, surface, wo: floatVector(directionOf(c)), hero };
    }),
  );
}

/** χ² of samples, and light by both estimates, of the kernels' own answers. */
export async function layersOverSphere(backend: GpuBackend, cosine: number, seed: number): Promise<SphereReport[]> {
  const random = seededRandom(seed);
  const number = () => Math.floor(random() * 2 ** 24) / 2 ** 24;
  const cases = casesAt(cosine);
  const table = layerTable(NAMED.map(([, m]) => m));
  const device = await probeDevice(backend);
  const evaluated = await askTable(
    device,
    table,
    cases.flatMap((c) => MIDPOINTS.map((second): Question => ({ ...c, second, asked: ASKED.evaluation }))),
  );
  const drawn = cases.flatMap((c) =>
    Array.from({ length: SAMPLES }, (): Question => {
      return { ...c, second: [number(), number(), number()], asked: ASKED.sampledDirection };
    }),
  );
  const directions = await askTable(device, table, drawn);
  const weights = await askTable(
    device,
    table,
    drawn.map((q) => ({ ...q, asked: ASKED.sampledWeight })),
  );
  const part = (all: readonly Answer[], i: number, n: number) => all.slice(i * n, (i + 1) * n);
  return verdictOn(`sphere ${cosine} ${seed}`, [evaluated, directions, weights], () =>
    cases.map(({ name }, i) => ({
      name,
      ...reportOf(part(evaluated, i, MIDPOINTS.length), part(directions, i, SAMPLES), part(weights, i, SAMPLES)),
    })),
  );
}

function reportOf(values: readonly Answer[], directions: readonly Answer[], weights: readonly Answer[]) {
  const masses = new Float64Array(ROWS * COLUMNS);
  values.forEach(([, , , pdf], k) => {
    masses[Math.floor(k / FINE ** 2)]! += pdf * SOLID_ANGLE;
  });
  const counts = new Float64Array(masses.length);
  const red: number[] = [];
  directions.forEach(([x, y, z, pdf], k) => {
    const [weight, , , delta] = weights[k]!;
    const counted = pdf > 0 && delta === 0;
    red.push(counted ? weight : 0);
    if (counted) counts[binOf([x, y, z])]!++;
  });
  const integral = masses.reduce((a, b) => a + b, 0);
  const found = counts.reduce((a, b) => a + b, 0);
  const elsewhere: [number, number] = [SAMPLES * Math.max(1 - integral, 0), SAMPLES - found];
  const bins = Array.from(masses, (mass, bin): [number, number] => [SAMPLES * mass, counts[bin]!]);
  const weight = red.reduce((a, b) => a + b, 0) / SAMPLES;
  const variance = red.reduce((sum, x) => sum + (x - weight) ** 2, 0) / (SAMPLES - 1);
  return {
    z: pearson([elsewhere, ...bins]).z,
    integral,
    share: found / SAMPLES,
    albedo: values.reduce((sum, [r]) => sum + r * SOLID_ANGLE, 0),
    weight,
    error: Math.sqrt(variance / SAMPLES),
    heaviest: Math.max(...weights.map(([r, g, b]) => Math.max(r, g, b))),
    unfound: values.filter(([r, g, b, pdf]) => Math.max(r, g, b) > 0 && !(pdf > 0)).length,
  };
}

/** Points of [0, 1)³, spread evenly (Roberts' R3 sequence), in 24 bits. */
const EVEN: readonly Vec3[] = Array.from({ length: 2048 }, (_, i) => {
  const g = 1.2207440846057596;
  return [1, 2, 3].map((p) => Math.floor((((i + 1) / g ** p) % 1) * 2 ** 24) / 2 ** 24) as unknown as Vec3;
});

/**
 * Light that comes back, red, green and blue, when radiance 1 comes from everywhere: means of the weights of even samples, for each
 * material at each cosine. Within a solid radiance is n² as much as in air, and counts that much less.
 */
export async function layerFurnaces(
  backend: GpuBackend,
  materials: readonly LayeredMaterial[],
  cosines: readonly number[],
  energyCompensation: boolean,
): Promise<(readonly [number, number, number])[][]> {
  const cases = materials.flatMap((_, surface) => cosines.map((c) => ({ surface, wo: floatVector(directionOf(c)) })));
  const table = layerTable(materials, energyCompensation);
  const ask = (asked: Question['asked']) =>
    cases.flatMap((c) => EVEN.map((second): Question => ({ ...c, second, asked })));
  const device = await probeDevice(backend);
  const directions = await askTable(device, table, ask(ASKED.sampledDirection));
  const weights = await askTable(device, table, ask(ASKED.sampledWeight));
  const means = cases.map(({ surface, wo }, i) => {
    const { solid, ior } = materials[surface]!;
    const sum = [0, 0, 0] as [number, number, number];
    EVEN.forEach((_, k) => {
      const at = i * EVEN.length + k;
      const index2 = (z: number) => (solid && z < 0 ? ior ** 2 : 1);
      const scale = index2(directions[at]![2]) / index2(wo[2]);
      for (const c of [0, 1, 2] as const) sum[c] += (weights[at]![c] * scale) / EVEN.length;
    });
    return sum;
  });
  return materials.map((_, i) => means.slice(i * cosines.length, (i + 1) * cosines.length));
}

export interface EndsReport {
  readonly name: string;
  /** Largest difference between both ends, as a share of the value. */
  readonly difference: number;
  /** How many of the pairs had light. */
  readonly lit: number;
}

/** f from both ends over a grid of directions, down to cosines of 0.002; f / n² in solids. `alike`: only pairs of the same cosine. */
export async function layersFromBothEnds(backend: GpuBackend, alike: boolean): Promise<EndsReport[]> {
  const cosines = [1, 0.7, 0.35, 0.1, 0.02, 0.002];
  const all = cosines.flatMap((c) => [0.7, 1.9, 4].flatMap((turn) => [directionOf(c, turn), directionOf(c, turn)]));
  const grid = all.map((d, i) => floatVector(i % 2 === 0 ? d : [d[0], d[1], -d[2]]));
  const pairs = grid
    .flatMap((a) => grid.map((b) => [a, b] as const))
    .filter(([a, b]) => !alike || Math.abs(a[2]) === Math.abs(b[2]));
  const table = layerTable(NAMED.map(([, m]) => m));
  const ask = (there: boolean) =>
    NAMED.flatMap((_, surface) =>
      pairs.map(([a, b]): Question => ({ surface, wo: there ? a : b, second: there ? b : a, asked: ASKED.evaluation })),
    );
  const device = await probeDevice(backend);
  const there = await askTable(device, table, ask(true));
  const back = await askTable(device, table, ask(false));
  return NAMED.map(([name, { solid, ior }], i) => {
    let difference = 0;
    let lit = 0;
    pairs.forEach(([a, b], k) => {
      const index2 = (w: Vec3) => (solid && w[2] < 0 ? ior ** 2 : 1);
      const at = i * pairs.length + k;
      for (const c of [0, 1, 2] as const) {
        const x = there[at]![c] / Math.abs(b[2]) / index2(a);
        const y = back[at]![c] / Math.abs(a[2]) / index2(b);
        if (x > 1e-4) lit++;
        difference = Math.max(difference, Math.abs(x - y) / (Math.max(x, y) + 1e-4));
      }
    });
    return { name, difference, lit };
  });
}
