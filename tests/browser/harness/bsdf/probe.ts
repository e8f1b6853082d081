/** Holds the kernels' BSDF, run on a GPU, against the double-precision one. */
import { evaluateBsdf, isDelta, sampleBsdf } from '../../../../packages/renderer/src/reference/bsdf/bsdf.ts';
import type { BsdfSurface } from '../../../../packages/renderer/src/reference/bsdf/surface.ts';
import type { Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { negate } from '../../../../packages/renderer/src/scene/vec3.ts';
import { directionOf, hasInside, SURFACES } from '../../../fixtures/bsdf-cases.ts';
import { chartsOf } from '../../../fixtures/bsdf-charts.ts';
import { chiSquare } from '../../../fixtures/chi-square.ts';
import { pick, type Random, seededRandom } from '../../../fixtures/random.ts';
import { type GpuBackend, probeDevice } from '../probe-device.ts';
import { randomIncoming, randomNumbers, randomOutgoing, randomSurfaces } from './cases.ts';
import { expectation } from './expectation.ts';
import { type Answer, ASKED, ask, floatVector, inFloats, type Question } from './questions.ts';

export interface BsdfReport {
  readonly asked: number;
  /** Answers with light in them, and those of them that rounding leaves open to a tenth or more. */
  lit: number;
  open: number;
  faults: number;
  /** Largest weight of a sample. */
  heaviest: number;
  readonly examples: string[];
}

const QUESTIONS = 32_768;
const newReport = (): BsdfReport => ({ asked: QUESTIONS, lit: 0, open: 0, faults: 0, heaviest: 0, examples: [] });

function complain(report: BsdfReport, fault: string | null, about: unknown): void {
  if (fault === null) return;
  report.faults++;
  if (report.examples.length < 4) report.examples.push(`${fault} ${JSON.stringify(about)}`);
}

const finite = (answer: Answer) => answer.every(Number.isFinite);

/** Whether an evaluation is what rounding allows; counts it. */
function judge(report: BsdfReport, s: BsdfSurface, wo: Vec3, wi: Vec3, answer: Answer, random: Random): string | null {
  if (!finite(answer)) return `not finite: ${answer}`;
  if (Math.min(...answer) < 0) return `negative: ${answer}`;
  const { expected, tolerance } = expectation(s, wo, wi, random);
  if (expected[3] > 0) report.lit++;
  if (expected[3] > 0 && tolerance[3] > 0.1 * expected[3]) report.open++;
  const wrong = answer.findIndex((x, c) => !(Math.abs(x - expected[c]!) <= tolerance[c]!));
  return wrong < 0 ? null : `${answer} instead of ${expected} ± ${tolerance[wrong]} in ${wrong}`;
}

/** evaluateBsdf at random surfaces and directions. */
export async function probeEvaluation(backend: GpuBackend, seed: number): Promise<BsdfReport> {
  const random = seededRandom(seed);
  const surfaces = randomSurfaces(random, 400);
  const questions = Array.from({ length: QUESTIONS }, (_, k): Question => {
    const surface = k % surfaces.length;
    const wo = randomOutgoing(random, surfaces[surface]!);
    return { surface, wo, second: randomIncoming(random, surfaces[surface]!, wo), asked: ASKED.evaluation };
  });
  const device = await probeDevice(backend);
  const answers = await ask(device, surfaces, questions);
  const report = newReport();
  questions.forEach(({ surface, wo, second }, k) => {
    const s = surfaces[surface]!;
    complain(report, judge(report, s, wo, second, answers[k]!, random), { s, wo, wi: second });
  });
  return report;
}

/** Where formulas divide by zero: along the surface, straight back, straight on. Anything finite and not negative will do. */
export async function probeEdges(backend: GpuBackend, seed: number): Promise<BsdfReport> {
  const random = seededRandom(seed);
  const surfaces = randomSurfaces(random, 400);
  const along: Vec3[] = [
    [1, 0, 0],
    [0, -1, 0],
    floatVector(directionOf(0, 1)),
    [0, 0, 1],
    floatVector(directionOf(1e-20, 2)),
  ];
  const questions = Array.from({ length: QUESTIONS }, (_, k): Question => {
    const surface = k % surfaces.length;
    const s = surfaces[surface]!;
    const wo = pick(random, [...along, randomOutgoing(random, s)]);
    const asked = pick(random, Object.values(ASKED));
    const wi = pick(random, [...along, wo, negate(wo), [-wo[0], -wo[1], wo[2]], [wo[0], wo[1], -wo[2]]] as Vec3[]);
    return { surface, wo, second: asked === ASKED.evaluation ? wi : randomNumbers(random), asked };
  });
  const device = await probeDevice(backend);
  const answers = await ask(device, surfaces, questions);
  const report = newReport();
  questions.forEach((question, k) => {
    const answer = answers[k]!;
    const positive = question.asked === ASKED.sampledDirection ? answer.slice(3) : answer;
    const fault = finite(answer) && Math.min(...positive) >= 0 ? null : `${answer}`;
    complain(report, fault, { s: surfaces[question.surface], ...question });
  });
  return report;
}

interface Sampled {
  readonly direction: Vec3;
  readonly pdf: number;
  readonly weight: Vec3;
  readonly delta: boolean;
}

/** A mirror's or pane's sample against the reference's with the same random numbers; near a choice either will do. */
function judgeDelta(s: BsdfSurface, wo: Vec3, u: Vec3, sampled: Sampled): string | null {
  const near = [0, 1e-5, -1e-5].map((d) => sampleBsdf(s, wo, [u[0], u[1], Math.min(Math.max(u[2] + d, 0), 1 - 1e-9)]));
  const said = [...sampled.direction, sampled.pdf, ...sampled.weight];
  // 2^-12 is the root of a rounding.
  const agrees = near.some((d) => {
    if (!d?.delta) return false;
    const expected = [...d.direction, d.pdf, ...d.weight];
    return said.every(
      (x, i) =>
        Math.abs(x - expected[i]!) <= 2 ** -17 * Math.abs(expected[i]!) + (isSteep(s, wo) ? 2 ** -10 : 2 ** -18),
    );
  });
  return agrees ? null : `delta: ${said} instead of ${JSON.stringify(near[0])}`;
}

/** Where total reflection begins, and at the horizon of a weak index: the refracted cosine is a root, steep there. */
function isSteep(s: BsdfSurface, wo: Vec3): boolean {
  const sine = Math.hypot(wo[0], wo[1]) * (wo[2] < 0 && !s.thin ? s.ior : 1 / s.ior);
  return s.type === 'dielectric' && (Math.abs(sine - 1) < 1e-3 || Math.abs(s.ior - 1) < 0.01);
}

function judgeSample(report: BsdfReport, s: BsdfSurface, q: Question, sampled: Sampled, random: Random): string | null {
  const { direction, pdf, weight, delta } = sampled;
  if (![...direction, pdf, ...weight].every(Number.isFinite)) return `not finite: ${JSON.stringify(sampled)}`;
  if (pdf === 0) return weight.every((w) => w === 0) ? null : 'weight without density';
  report.heaviest = Math.max(report.heaviest, ...weight);
  if (Math.abs(Math.hypot(...direction) - 1) > 2 ** -18) return `length: ${direction}`;
  if (delta) return judgeDelta(s, q.wo, q.second, sampled);
  const [r, g, b] = weight;
  return judge(report, s, q.wo, direction, [r * pdf, g * pdf, b * pdf, pdf], random);
}

/** sampleBsdf at random surfaces, directions and numbers: what it says of its own samples. */
export async function probeSamples(backend: GpuBackend, seed: number): Promise<BsdfReport> {
  const random = seededRandom(seed);
  const surfaces = randomSurfaces(random, 400);
  const questions = Array.from({ length: QUESTIONS }, (_, k): Question => {
    const surface = k % surfaces.length;
    const wo = randomOutgoing(random, surfaces[surface]!);
    return { surface, wo, second: randomNumbers(random), asked: ASKED.sampledDirection };
  });
  const device = await probeDevice(backend);
  const directions = await ask(device, surfaces, questions);
  const weights = await ask(
    device,
    surfaces,
    questions.map((q) => ({ ...q, asked: ASKED.sampledWeight })),
  );
  const report = newReport();
  questions.forEach((q, k) => {
    const s = surfaces[q.surface]!;
    const [x, y, z, pdf] = directions[k]!;
    const [r, g, b, flags] = weights[k]!;
    const sampled = { direction: [x, y, z], pdf, weight: [r, g, b], delta: flags === 1 } as const;
    complain(report, judgeSample(report, s, q, sampled, random), { s, ...q });
  });
  return report;
}

export interface ChiSquareReport {
  readonly name: string;
  readonly z: number;
  readonly degrees: number;
  readonly integral: number;
  readonly share: number;
}

const SAMPLES = 4096;

/** χ² of the GPU's samples against the reference's density, for all surfaces seen at this cosine, glass from inside too. */
export async function chiSquareSamples(backend: GpuBackend, cosine: number, seed: number): Promise<ChiSquareReport[]> {
  const random = seededRandom(seed);
  const cases = Object.entries(SURFACES).flatMap(([name, given]) => {
    const s = inFloats(given);
    const cosines = isDelta(s) ? [] : hasInside(s) ? [cosine, -cosine] : [cosine];
    return cosines.map((c) => ({ name: `${name}, cosine ${c}`, s, wo: floatVector(directionOf(c)) }));
  });
  const number = () => Math.floor(random() * 2 ** 24) / 2 ** 24;
  const questions = cases.flatMap(({ wo }, surface) =>
    Array.from({ length: SAMPLES }, (): Question => {
      return { surface, wo, second: [number(), number(), number()], asked: ASKED.sampledDirection };
    }),
  );
  const surfaces = cases.map((c) => c.s);
  const device = await probeDevice(backend);
  const directions = await ask(device, surfaces, questions);
  const weights = await ask(
    device,
    surfaces,
    questions.map((q) => ({ ...q, asked: ASKED.sampledWeight })),
  );
  return cases.flatMap(({ name, s, wo }, i) => {
    const drawn = directions.slice(i * SAMPLES, (i + 1) * SAMPLES).map(([x, y, z, pdf], k): Vec3 | null => {
      const delta = weights[i * SAMPLES + k]![3] % 2 === 1;
      return pdf > 0 && !delta ? [x, y, z] : null;
    });
    return chartsOf(s, wo).map((chart) => ({ name, ...chiSquare(chart, drawn, (wi) => evaluateBsdf(s, wo, wi).pdf) }));
  });
}
