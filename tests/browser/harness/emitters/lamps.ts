/** Sampling of lamps on a GPU, judged by the double-precision one and by closed forms. */
import { type AreaEmitter, emitterPdf } from '../../../../packages/renderer/src/reference/light/emitter.ts';
import type { Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import {
  add,
  addScaled,
  cross,
  dot,
  length,
  normalize,
  subtract,
} from '../../../../packages/renderer/src/scene/vec3.ts';
import { LIGHT_CASES, type LightCase, RADIANCE } from '../../../fixtures/lights/cases.ts';
import { exactIrradiance } from '../../../fixtures/lights/closed-forms.ts';
import { chiSquareZ, countBins, densityOfBins } from '../../../fixtures/lights/histogram.ts';
import { surroundingsOf } from '../../../fixtures/lights/surroundings.ts';
import { seededRandom } from '../../../fixtures/random.ts';
import { verdictOn } from '../verdict.ts';
import { type Answer, ASK, type EmitterProbe, type GpuBackend, type Question, rounded, withProbe } from './probe.ts';

export interface LampReport {
  readonly name: string;
  /** Of the samples' mean from the closed form, relative. */
  readonly error: number;
  /** Of the directions' distribution, see `chiSquareZ`. */
  readonly z: number;
  readonly samples: number;
  /** Samples whose ray passes the lamp by, at its edge. */
  readonly missed: number;
  readonly faults: number;
  /** The first few, in words. */
  readonly examples: string[];
}

const SIDE = 128;
const vector = ([x, y, z]: Answer): Vec3 => [x, y, z];
const near = (a: number, b: number, relative: number) => Math.abs(a - b) <= relative * Math.abs(b);

/** How far a place is from the lamp's surface. */
function offSurface(e: AreaEmitter, place: Vec3): number {
  if (e.kind === 'sphere') return Math.abs(length(subtract(place, e.center)) - e.radius);
  if (e.kind === 'box') {
    const beyond = e.axes.map((axis, k) => Math.abs(dot(axis, subtract(place, e.center))) - e.halfSize[k]!);
    return Math.abs(Math.max(...beyond));
  }
  const across = cross(e.u, e.v);
  const inside = subtract(place, e.corner);
  const s = dot(cross(inside, e.v), across) / dot(across, across);
  const t = dot(cross(e.u, inside), across) / dot(across, across);
  const beside = Math.max(Math.abs(s - 0.5) - 0.5, Math.abs(t - 0.5) - 0.5, 0) * (length(e.u) + length(e.v));
  return Math.max(Math.abs(dot(inside, normalize(across))), beside);
}

interface Sampled {
  readonly pdf: Answer;
  readonly light: Answer;
  readonly ray: Answer;
}

/** What is wrong with one sample, or null. */
function faultOf({ emitter: e, point }: LightCase, { pdf: sample, light, ray }: Sampled): string | null {
  const [direction, pdf, distance] = [vector(sample), sample[3], light[3]];
  if (![...sample, ...light, ...ray].every(Number.isFinite)) return 'is not a number';
  if (pdf < 0 || distance < 0 || Math.min(...light) < 0) return 'is negative';
  if (Math.abs(length(direction) - 1) > 1e-5) return 'has a direction that is not of length 1';
  if (!vector(light).every((c, k) => near(c, RADIANCE[k]!, 1e-6))) return 'has another radiance';
  const size = length(point) + distance + length(subtract(point, e.kind === 'quad' ? e.corner : e.center));
  if (offSurface(e, addScaled(point, direction, distance)) > 4e-6 * size) return 'is not on the lamp';
  const exact = emitterPdf(e, point, normalize(direction));
  // 0: at the lamp's edge, which doubles put elsewhere.
  if (exact > 0 && !near(pdf, exact, 2e-3)) return `has another density than ${exact}`;
  if (ray[1] < 1e30 && !near(ray[0], pdf, 2e-3)) return 'has another density when a ray meets it';
  return null;
}

async function judge(probe: EmitterProbe, light: LightCase): Promise<LampReport> {
  const random = seededRandom(51);
  const { eye } = light.scene.camera;
  const point = rounded(subtract(light.point, eye));
  const rested = { ...light, point: add(eye, point) };
  const cells = Array.from({ length: SIDE * SIDE }, (_, k) => {
    // Not 1 when rounded to 32 bits.
    const at = (cell: number) => Math.min((cell + random()) / SIDE, 1 - 2 ** -24);
    return [at(k % SIDE), at(Math.floor(k / SIDE))] as const;
  });
  const ask = (what: Question['ask']) =>
    probe.ask(
      light.scene,
      cells.map((u) => ({ ask: what, emitter: 0, point, u })),
    );
  const [pdfs, lights, rays] = [
    await ask(ASK.directionAndPdf),
    await ask(ASK.radianceAndDistance),
    await ask(ASK.pdfOfSample),
  ];
  return verdictOn(`lamp ${light.name}`, [pdfs, lights, rays], () => verdict(rested, pdfs, lights, rays));
}

type Answers = readonly Answer[];

function verdict(light: LightCase, pdfs: Answers, lights: Answers, rays: Answers): LampReport {
  const lit = pdfs.map((_, k) => k).filter((k) => pdfs[k]![3] > 0);
  const faults = lit.flatMap((k) => {
    const fault = faultOf(light, { pdf: pdfs[k]!, light: lights[k]!, ray: rays[k]! });
    return fault === null ? [] : [`sample ${k} ${fault}: ${pdfs[k]}; ${lights[k]}; ${rays[k]}`];
  });
  const directions = lit.map((k) => vector(pdfs[k]!));
  return {
    name: light.name,
    error: irradianceError(light, pdfs),
    z: lit.length === 0 ? 0 : distributionZ(light, directions),
    samples: lit.length,
    missed: lit.filter((k) => rays[k]![1] >= 1e30).length,
    faults: faults.length,
    examples: faults.slice(0, 3),
  };
}

function irradianceError({ emitter, point, normal }: LightCase, answers: readonly Answer[]): number {
  const sum = answers.reduce(
    (total, answer) => (answer[3] > 0 ? total + Math.max(dot(vector(answer), normal), 0) / answer[3] : total),
    0,
  );
  const exact = exactIrradiance(emitter, point, normal);
  return exact === 0 ? sum : sum / answers.length / exact - 1;
}

function distributionZ({ emitter, point }: LightCase, directions: readonly Vec3[]): number {
  const around = surroundingsOf(emitter, point);
  const bins = densityOfBins(around, (direction) => emitterPdf(emitter, point, direction));
  return chiSquareZ(countBins(around, directions), times(bins, directions.length));
}
const times = (values: readonly number[], by: number) => values.map((x) => x * by);

export function probeLamps(backend: GpuBackend): Promise<LampReport[]> {
  return withProbe(backend, async (probe) => {
    const reports: LampReport[] = [];
    for (const light of LIGHT_CASES) reports.push(await judge(probe, light));
    return reports;
  });
}
