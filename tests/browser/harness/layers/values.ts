/** The kernels' layered BSDF against the double-precision one, which is written from the specifications. */
import type { Device } from '../../../../packages/renderer/src/gpu/device.ts';
import { isLayered } from '../../../../packages/renderer/src/scene/layered.ts';
import type { Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { add, negate } from '../../../../packages/renderer/src/scene/vec3.ts';
import { directionOf } from '../../../fixtures/bsdf-cases.ts';
import { materialOf } from '../../../fixtures/layers/as-material.ts';
import { evaluateLayered } from '../../../fixtures/layers/layered-bsdf.ts';
import type { LayeredMaterial } from '../../../fixtures/layers/layered-material.ts';
import { between, inCube, pick, type Random, seededRandom } from '../../../fixtures/random.ts';
import { randomNumbers } from '../bsdf/cases.ts';
import { type Answer, ASKED, askTable, floatVector, type Question } from '../bsdf/questions.ts';
import { type GpuBackend, probeDevice } from '../probe-device.ts';
import { verdictOn } from '../verdict.ts';
import { albedoOfSheen, layerTable, switchesOf } from './materials.ts';
import { LAYER_KINDS, someLayers, withOnly } from './random-layers.ts';

export interface LayersReport {
  readonly asked: number;
  /** Answers with light in them, and those of them without a film that rounding leaves open to a tenth or more. */
  lit: number;
  open: number;
  faults: number;
  readonly examples: string[];
}

const QUESTIONS = 16_384;
const MATERIALS = 300;
const newReport = (): LayersReport => ({ asked: QUESTIONS, lit: 0, open: 0, faults: 0, examples: [] });

function complain(report: LayersReport, fault: string | null, about: unknown): void {
  if (fault === null) return;
  report.faults++;
  if (report.examples.length < 4) report.examples.push(`${fault} ${JSON.stringify(about)}`);
}

const ROUNDING = 2 ** -24;
/** Rounding on the way to cosines is as if directions were moved by a few units in the last place (harness/bsdf/expectation.ts). */
const MOVED = 6 * ROUNDING;
const TRIES = 8;
/** Products of rounded factors, and powers of the sheen, whose exponents have up to 100 times the error of their base. */
const FACTORS = 1024;
const NOTHING = 1e-8;
/** What drivers promise of a cosine, which the colours of a film are made of, times the matrix that makes colours of it. */
const COSINE = 2 ** -11 * 16;
const SHARE = 8 * ROUNDING;
const WHITE = [1, 1, 1] as const;
const BLACK = [0, 0, 0] as const;

const value = (m: LayeredMaterial, wo: Vec3, wi: Vec3, hero: number) => evaluateLayered(m, wo, wi, hero, albedoOfSheen);
const keepSide = (moved: Vec3, { 2: z }: Vec3): Vec3 => [moved[0], moved[1], Math.sign(z) * Math.max(moved[2] * Math.sign(z), 1e-12)]; // biome-ignore format: one line

function judge(
  report: LayersReport,
  m: LayeredMaterial,
  q: Question,
  wi: Vec3,
  answer: Answer,
  random: Random,
): string | null {
  const { wo, hero = 0 } = q;
  if (!answer.every(Number.isFinite)) return `not finite: ${answer}`;
  if (Math.min(...answer) < 0) return `negative: ${answer}`;
  const expected = value(m, wo, wi, hero);
  const spread: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < TRIES; i++) {
    const nudged = { ...m, ior: 1 + (m.ior - 1) * (1 + 4 * ROUNDING * (2 * random() - 1)) };
    const moved = (w: Vec3) => keepSide(add(w, inCube(random, MOVED)), w);
    value(nudged, moved(wo), moved(wi), hero).forEach((x, c) => {
      spread[c] = Math.max(spread[c]!, Math.abs(x - expected[c]!));
    });
  }
  // Fresnel's shares, 0 … 1, are rounded as 1 is, those of a film as a driver's cosines are.
  const shares = (m.iridescence > 0 ? COSINE : SHARE) * greatestValue(m, wo, wi);
  const tolerance = expected.map((x, c) => 2 * spread[c]! + FACTORS * ROUNDING * x + shares + NOTHING);
  if (Math.max(...expected) > 0) report.lit++;
  if (m.iridescence === 0 && expected.some((x, c) => x > 1e-3 && tolerance[c]! > 0.1 * x)) report.open++;
  const wrong = expected.findIndex((x, c) => !(Math.abs(answer[c]! - x) <= tolerance[c]!));
  return wrong < 0 ? null : `${answer} instead of ${expected} ± ${tolerance[wrong]} in ${wrong}`;
}

/** What gloss and body would give if their Fresnel's shares were 1. */
function greatestValue(m: LayeredMaterial, wo: Vec3, wi: Vec3): number {
  const bare = {
    ...m,
    baseColor: WHITE,
    iridescence: 0,
    clearcoat: 0,
    sheenColor: BLACK,
    specular: 0,
    diffuseTransmission: 0,
  };
  const mirror = value({ ...bare, metallic: 1 }, wo, wi, 0)[0];
  return mirror + 3 * value({ ...bare, metallic: 0 }, wo, wi, 0)[0] + Math.abs(wi[2]);
}

function randomUp(random: Random): Vec3 {
  const kind = random();
  return directionOf(kind < 0.1 ? 1 : kind < 0.4 ? 10 ** between(random, -4, -1) : random(), between(random, -4, 4));
}
const randomDirection = (random: Random): Vec3 => {
  const [x, y, z] = randomUp(random);
  return floatVector(random() < 0.5 ? [x, y, z] : [x, y, -z]);
};
const heroOf = (m: LayeredMaterial, random: Random) => (m.dispersion > 0 && m.solid ? Math.floor(4 * random()) : 0);

/** Directions at random and directions that samples give, at these materials by a program with these switches. */
async function probe(
  device: Device,
  materials: readonly LayeredMaterial[],
  asked: number,
  random: Random,
  switches?: Record<string, boolean>,
): Promise<LayersReport> {
  const table = layerTable(materials);
  const first = Array.from({ length: asked }, (_, k): Question => {
    const surface = k % materials.length;
    const hero = heroOf(materials[surface]!, random);
    return { surface, wo: randomDirection(random), second: randomNumbers(random), asked: ASKED.sampledDirection, hero };
  });
  const sampled = await askTable(device, table, first, switches);
  const questions = first.map((q, k): Question => {
    const [x, y, z, pdf] = sampled[k]!;
    const takesSample = pdf > 0 && Math.abs(z) > 1e-4 && k % 2 === 0;
    return { ...q, asked: ASKED.evaluation, second: takesSample ? [x, y, z] : randomDirection(random) };
  });
  const answers = await askTable(device, table, questions, switches);
  return verdictOn(`layers ${JSON.stringify(switches)}`, [sampled, answers], () => {
    const report = { ...newReport(), asked };
    questions.forEach((q, k) => {
      const m = materials[q.surface]!;
      complain(report, judge(report, m, q, q.second, answers[k]!, random), { m, wo: q.wo, wi: q.second, hero: q.hero });
    });
    return report;
  });
}

/** Materials with all kinds of layers, by a program that knows all. */
export async function probeLayers(backend: GpuBackend, seed: number): Promise<LayersReport> {
  const random = seededRandom(seed);
  const device = await probeDevice(backend);
  return probe(device, someLayers(random, MATERIALS), QUESTIONS, random);
}

/** Kinds of layer, each by the program that a scene with this kind alone is drawn by. */
export async function probeLayersAlone(backend: GpuBackend, seed: number): Promise<LayersReport[]> {
  const random = seededRandom(seed);
  const device = await probeDevice(backend);
  const reports: LayersReport[] = [];
  for (const kind of LAYER_KINDS) {
    const materials = someLayers(random, 40)
      .map((m) => withOnly(m, kind))
      .filter((m) => isLayered(materialOf(m)));
    reports.push(await probe(device, materials, 512, random, switchesOf(materials)));
  }
  return reports;
}

const ALONG: readonly Vec3[] = [[1, 0, 0], [0, -1, 0], floatVector(directionOf(0, 1)), [0, 0, 1], [0, 0, -1], floatVector(directionOf(1e-20, 2))]; // biome-ignore format: one line

/** Where formulas divide by zero: anything finite and not negative will do, and samples that are not too heavy. */
export async function probeLayerEdges(backend: GpuBackend, seed: number): Promise<LayersReport & { heaviest: number }> {
  const random = seededRandom(seed);
  const materials = someLayers(random, MATERIALS);
  const questions = Array.from({ length: QUESTIONS }, (_, k): Question => {
    const surface = k % materials.length;
    const wo = pick(random, [...ALONG, randomDirection(random), randomDirection(random)]);
    const asked = pick(random, Object.values(ASKED));
    const wi = pick(random, [...ALONG, wo, negate(wo), [-wo[0], -wo[1], wo[2]], [wo[0], wo[1], -wo[2]]] as Vec3[]);
    return {
      surface,
      wo,
      asked,
      second: asked === ASKED.evaluation ? wi : randomNumbers(random),
      hero: heroOf(materials[surface]!, random),
    };
  });
  const device = await probeDevice(backend);
  const answers = await askTable(device, layerTable(materials), questions);
  const report = { ...newReport(), heaviest: 0 };
  questions.forEach((q, k) => {
    const answer = answers[k]!;
    const positive = q.asked === ASKED.sampledDirection ? answer.slice(3) : answer;
    if (q.asked === ASKED.sampledWeight) report.heaviest = Math.max(report.heaviest, ...answer.slice(0, 3));
    const fault = answer.every(Number.isFinite) && Math.min(...positive) >= 0 ? null : `${answer}`;
    complain(report, fault, { m: materials[q.surface], ...q });
  });
  return report;
}
