/** Lights without surface on a GPU, judged by the double-precision ones. */
import { type Emitter, sampleEmitter } from '../../../../packages/renderer/src/reference/light/emitter.ts';
import { emitterOfLight } from '../../../../packages/renderer/src/reference/light/from-scene.ts';
import type { Color, Light, Scene, Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { addScaled } from '../../../../packages/renderer/src/scene/vec3.ts';
import { between, seededRandom } from '../../../fixtures/random.ts';
import { testScene } from '../../../fixtures/scenes.ts';
import { ASK, type EmitterProbe, eyeAtOrigin, type GpuBackend, type Question, rounded, withProbe } from './probe.ts';

const color: Color = [1, 2, 4];
const direction: Vec3 = [1, -2, 0.5];
const position: Vec3 = [0.5, 2, -1];
const spot = { type: 'spot', position, direction, intensity: 3, color } as const;
const NEAR_LIGHTS = {
  point: { type: 'point', position, intensity: 3, color },
  spot: { ...spot, innerAngle: 20, outerAngle: 50 },
  'narrow spot': { ...spot, innerAngle: 2, outerAngle: 5 },
  'hard spot': { ...spot, innerAngle: 30, outerAngle: 30 },
} as const satisfies Record<string, Light>;
const FAR_LIGHTS = {
  star: { type: 'directional', direction, irradiance: 3, color, angle: 0 },
  sun: { type: 'directional', direction, irradiance: 3, color, angle: 0.53 },
  'small disc': { type: 'directional', direction, irradiance: 3, color, angle: 0.01 },
  'wide disc': { type: 'directional', direction, irradiance: 3, color, angle: 60 },
} as const satisfies Record<string, Light>;
const SKY = { horizon: [1, 2, 3], zenith: [3, 2, 1] } as const;

export interface FarReport {
  readonly name: string;
  /** Largest relative difference of radiance · 1 / pdf from the double-precision one, over points around the light. */
  readonly worst: number;
  /** Of the mean irradiance on a surface that faces the light; 0 for lights without size. */
  readonly meanError: number;
  readonly faults: number;
}

/** Points below the light; the red irradiance of each on what faces the light. */
export async function probeFarLights(backend: GpuBackend): Promise<FarReport[]> {
  const scene = testScene({}, { ...NEAR_LIGHTS, ...FAR_LIGHTS }, { ...eyeAtOrigin, sky: SKY });
  const sky: Emitter = { kind: 'sky', ...SKY };
  // The order in which they become emitters.
  const emitters = [
    ...Object.values(FAR_LIGHTS).map(emitterOfLight),
    sky,
    ...Object.values(NEAR_LIGHTS).map(emitterOfLight),
  ];
  const names = [...Object.keys(FAR_LIGHTS), 'sky', ...Object.keys(NEAR_LIGHTS)];
  return withProbe(backend, async (probe) => {
    const reports: FarReport[] = [];
    for (const [index, e] of emitters.entries()) reports.push(await judgeFar(probe, scene, e, index, names[index]!));
    return reports;
  });
}

async function judgeFar(
  probe: EmitterProbe,
  scene: Scene,
  e: Emitter,
  index: number,
  name: string,
): Promise<FarReport> {
  const random = seededRandom(61);
  const questions: Question[] = Array.from({ length: 4096 }, (_, k) => ({
    ask: ASK.directionAndPdf,
    emitter: index,
    point: rounded(
      addScaled(position, direction, between(random, 0.1, 3)).map((c) => c + between(random, -1, 1)) as unknown as Vec3,
    ),
    u: [Math.fround((k + 0.5) / 4096), Math.fround((k * 0.6180339887498949) % 1)] as const,
  }));
  const samples = await probe.ask(scene, questions);
  const lights = await probe.ask(
    scene,
    questions.map((q) => ({ ...q, ask: ASK.radianceAndDistance })),
  );
  const rays = await probe.ask(
    scene,
    questions.map((q) => ({ ...q, ask: ASK.pdfOfSample })),
  );
  let [worst, sum, exactSum, faults] = [0, 0, 0, 0];
  questions.forEach(({ point, u }, k) => {
    const [sample, light, ray] = [samples[k]!, lights[k]!, rays[k]!];
    const exact = sampleEmitter(e, point, u);
    if (![...sample, ...light, ...ray].every((x) => Number.isFinite(x) && x >= -1)) faults++;
    const got = sample[3] > 0 ? light[0] / sample[3] : 0;
    const wanted = exact === null ? 0 : exact.radiance[0] / exact.pdf;
    const largest = exact === null || e.kind !== 'spot' ? wanted : 3 / exact.distance ** 2;
    if (e.kind !== 'sky' && got !== wanted) worst = Math.max(worst, Math.abs(got - wanted) / (largest || 1));
    sum += got;
    exactSum += wanted;
    const delta = ray[3] === 1;
    if (delta !== (exact?.delta ?? delta)) faults++;
    // What a ray in that direction would be told: the same density, and the radiance; discs end within rounding.
    const rim = e.kind === 'directional' && u[0] > 0.99;
    const told = delta ? ray[0] === 0 : Math.abs(ray[0] / sample[3] - 1) < 1e-4 && ray[2] > 0;
    if (!told && !rim && sample[3] > 0) faults++;
  });
  return { name, worst, meanError: sum / exactSum - 1, faults };
}
