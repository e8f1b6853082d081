/** Light sampling of meshes on a GPU, judged by Lambert's formula and by the triangles themselves in double precision. */
import type { Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { addScaled, dot, length, normalize, subtract } from '../../../../packages/renderer/src/scene/vec3.ts';
import { chiSquareZ, countBins, densityOfBins, type Surroundings } from '../../../fixtures/lights/histogram.ts';
import {
  MESH_LAMP_CASES,
  type MeshLampCase,
  meetings,
  unshadowedIrradiance,
} from '../../../fixtures/lights/mesh-cases.ts';
import { seededRandom } from '../../../fixtures/random.ts';
import { verdictOn } from '../verdict.ts';
import type { LampReport } from './lamps.ts';
import { type Answer, ASK, type EmitterProbe, type GpuBackend, type Question, rounded, withProbe } from './probe.ts';

const SIDE = 128;
/** Samples that are looked at one by one. */
const LOOKED_AT = 1500;
const vector = ([x, y, z]: Answer): Vec3 => [x, y, z];
const near = (a: number, b: number, relative: number) => Math.abs(a - b) <= relative * Math.abs(b);

interface Sampled {
  readonly sample: Answer;
  readonly light: Answer;
  readonly ray: Answer;
}

/** What is wrong with one sample, or null. */
function faultOf(light: MeshLampCase, { sample, light: seen, ray }: Sampled): string | null {
  const [direction, pdf, distance] = [vector(sample), sample[3], seen[3]];
  if (![...sample, ...seen, ...ray].every(Number.isFinite)) return 'is not a number';
  if (pdf < 0 || distance < 0) return 'is negative';
  if (Math.abs(length(direction) - 1) > 1e-5) return 'has a direction that is not of length 1';
  if (!light.radiance.every((c, k) => near(seen[k]!, c, 1e-6))) return 'has another radiance';
  const met = meetings(light, normalize(direction));
  // Shadow rays end a little before the light: ray.wesl, relativeTMin.
  const slack = 2.5e-5 * (length(subtract(light.point, light.scene.camera.eye)) + distance);
  const isAt = (one: { distance: number }, told: number) => Math.abs(one.distance - told) <= slack;
  const wanted = met.filter((one) => isAt(one, distance));
  // None at all: at an edge, which doubles put elsewhere.
  if (met.length > 0 && !wanted.some((one) => near(pdf, one.density, 2e-3)))
    return `has another density than ${wanted.map(({ density }) => density)}`;
  const nearest = met.sort((a, b) => a.distance - b.distance)[0];
  const seenByRay = nearest && isAt(nearest, ray[1]);
  if (seenByRay && !near(ray[0], nearest.density, 2e-3)) return `has another density than ${nearest.density} for a ray`;
  return null;
}

async function judge(probe: EmitterProbe, light: MeshLampCase): Promise<MeshLampReport> {
  const random = seededRandom(52);
  const { eye } = light.scene.camera;
  const point = rounded(subtract(light.point, eye));
  const rested = { ...light, point: addScaled(eye, point, 1) };
  const cells = Array.from({ length: SIDE * SIDE }, (_, k) => {
    const at = (cell: number) => Math.min((cell + random()) / SIDE, 1 - 2 ** -24);
    return [at(k % SIDE), at(Math.floor(k / SIDE))] as const;
  });
  const ask = (what: Question['ask']) =>
    probe.ask(
      light.scene,
      cells.map((u) => ({ ask: what, emitter: 0, point, u })),
    );
  const [samples, lights, rays] = [
    await ask(ASK.directionAndPdf),
    await ask(ASK.radianceAndDistance),
    await ask(ASK.pdfOfSample),
  ];
  return verdictOn(`mesh lamp ${light.name}`, [samples, lights, rays], () => verdict(rested, samples, lights, rays));
}

type Answers = readonly Answer[];

function verdict(light: MeshLampCase, samples: Answers, lights: Answers, rays: Answers): MeshLampReport {
  const lit = samples.map((_, k) => k).filter((k) => samples[k]![3] > 0);
  const step = Math.max(Math.floor(lit.length / LOOKED_AT), 1);
  const faults = lit.flatMap((k, n) => {
    if (n % step !== 0) return [];
    const fault = faultOf(light, { sample: samples[k]!, light: lights[k]!, ray: rays[k]! });
    return fault === null ? [] : [`sample ${k} ${fault}: ${samples[k]}; ${lights[k]}; ${rays[k]}`];
  });
  return {
    name: light.name,
    ...irradianceError(light, samples),
    z: distributionZ(light, lit.map((k) => vector(samples[k]!))), // biome-ignore format: one thought
    samples: lit.length,
    missed: lit.filter((k) => rays[k]![1] >= 1e30).length,
    faults: faults.length,
    examples: faults.slice(0, 3),
  };
}

/** The samples' mean of cos / density from Lambert's, and its standard error as if they were independent; relative to Lambert's. */
function irradianceError(light: MeshLampCase, samples: readonly Answer[]): { error: number; noise: number } {
  const exact = unshadowedIrradiance(light);
  const values = samples.map((s) => (s[3] > 0 ? Math.max(dot(vector(s), light.normal), 0) / s[3] / exact : 0));
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const variance = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length ** 2;
  return { error: mean - 1, noise: Math.sqrt(variance) };
}

/** In a cone that holds all corners. */
function surroundings({ triangles, point }: MeshLampCase): Surroundings {
  const corners = triangles.flat().map((corner) => normalize(subtract(corner, point)));
  const sum = corners.reduce((all, corner) => addScaled(all, corner, 1), [0, 0, 0] as Vec3);
  if (length(sum) < 0.3 * corners.length) return { axis: normalize([0.3, 0.5, 0.8]), halfAngle: Math.PI };
  const axis = normalize(sum);
  const cosine = Math.min(...corners.map((corner) => dot(axis, corner)));
  return { axis, halfAngle: Math.min(1.001 * Math.acos(Math.min(cosine, 1)) + 1e-4, Math.PI) };
}

function distributionZ(light: MeshLampCase, directions: readonly Vec3[]): number {
  const around = surroundings(light);
  const bins = densityOfBins(around, (direction) =>
    meetings(light, direction).reduce((sum, { density }) => sum + density, 0),
  );
  return chiSquareZ(countBins(around, directions), bins.map((x) => x * SIDE * SIDE)); // biome-ignore format: one thought
}

export interface MeshLampReport extends LampReport {
  /** Standard error of the mean that `error` is of, relative, as if samples were independent. */
  readonly noise: number;
}

export function probeMeshLamps(backend: GpuBackend): Promise<MeshLampReport[]> {
  return withProbe(backend, async (probe) => {
    const reports: MeshLampReport[] = [];
    for (const light of MESH_LAMP_CASES) reports.push(await judge(probe, light));
    return reports;
  });
}
