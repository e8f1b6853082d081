/** Lights without surface, the choice among lights, and sampling where it could break, on a GPU. */
import { choiceProbabilities } from '../../../../packages/renderer/src/reference/light/choose.ts';
import { type Emitter, sampleEmitter } from '../../../../packages/renderer/src/reference/light/emitter.ts';
import { emitterOfLight, emitterOfShape } from '../../../../packages/renderer/src/reference/light/from-scene.ts';
import { add, addScaled, length, scale, subtract } from '../../../../packages/renderer/src/reference/vec3.ts';
import type { Color, Light, Scene, Shape, Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { between, inCube, type Random, randomDirection, seededRandom } from '../../../fixtures/random.ts';
import { testLight, testMaterial, testScene } from '../../../fixtures/scenes.ts';
import { type Answer, ASK, EmitterProbe, MOST_QUESTIONS, type Question } from './probe.ts';

type Backend = 'webgpu' | 'webgl2';
const ZERO: Vec3 = [0, 0, 0];
const rounded = (v: Vec3): Vec3 => [Math.fround(v[0]), Math.fround(v[1]), Math.fround(v[2])];
const eyeAtOrigin = { camera: { eye: ZERO, target: [0, 0, -1], up: [0, 1, 0], verticalFov: 60 } } as const;

async function withProbe<T>(backend: Backend, work: (probe: EmitterProbe) => Promise<T>): Promise<T> {
  const probe = await EmitterProbe.open(backend);
  try {
    return await work(probe);
  } finally {
    probe.close();
  }
}

const color: Color = [1, 2, 4];
const direction: Vec3 = [1, -2, 0.5];
const position: Vec3 = [0.5, 2, -1];
const spot = { type: 'spot', position, direction, intensity: 3, color } as const;
/** In this order they become emitters, the sky after them. */
const FAR_LIGHTS = {
  point: { type: 'point', position, intensity: 3, color },
  spot: { ...spot, innerAngle: 20, outerAngle: 50 },
  'narrow spot': { ...spot, innerAngle: 2, outerAngle: 5 },
  'hard spot': { ...spot, innerAngle: 30, outerAngle: 30 },
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
export async function probeFarLights(backend: Backend): Promise<FarReport[]> {
  const scene = testScene({}, FAR_LIGHTS, { ...eyeAtOrigin, sky: SKY });
  const sky: Emitter = { kind: 'sky', ...SKY };
  const emitters = [...Object.values(FAR_LIGHTS).map(emitterOfLight), sky];
  const names = [...Object.keys(FAR_LIGHTS), 'sky'];
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

const glow = testMaterial({ emission: [2, 1, 3] });

const named = <T>(things: readonly T[]): Record<string, T> =>
  Object.fromEntries(things.map((t, k) => [`thing ${k}`, t]));

function crowd(random: Random): { scene: Scene; emitters: Emitter[] } {
  const place = () => inCube(random, 4);
  const quad = () => ({ corner: place(), u: inCube(random, 1), v: inCube(random, 1) });
  const lights: Light[] = [
    testLight({ center: place(), radius: 0.3, visible: true }),
    testLight({ center: place(), radius: 0.01, radiance: 500 }),
    { type: 'quad', ...quad(), radiance: 3, color: [1, 1, 0], visible: true },
    { type: 'quad', ...quad(), radiance: 1, color: [1, 1, 1], visible: false },
    { type: 'point', position: place(), intensity: 2, color: [1, 0, 0] },
    {
      type: 'spot',
      position: place(),
      direction: inCube(random, 1),
      intensity: 9,
      color,
      innerAngle: 10,
      outerAngle: 60,
    },
    { type: 'directional', direction: inCube(random, 1), irradiance: 0.1, color, angle: 20 },
  ];
  // Emitters are sorted by power: strongest first.
  const shapes: Exclude<Shape, { type: 'plane' }>[] = [
    { type: 'box', center: place(), size: [1, 2, 0.5], rotation: [10, 20, 30], material: 'glow' },
    { type: 'quad', corner: place(), u: [0.5, 0, 0], v: [0, 0.5, 0.1], material: 'glow' },
    { type: 'sphere', center: place(), radius: 0.1, material: 'glow' },
  ];
  const sky = { horizon: [0.01, 0.02, 0.03], zenith: [0.03, 0.02, 0.01] } as const;
  const scene = testScene(named(shapes), named(lights), { ...eyeAtOrigin, sky, materials: { glow } });
  const emitters = [
    ...lights.map(emitterOfLight),
    { kind: 'sky', ...sky } as const,
    ...shapes.map((shape) => emitterOfShape(shape, glow.emission)),
  ];
  return { scene, emitters };
}

export interface ChoiceReport {
  readonly choices: number;
  /** Choices whose probability is not bit for bit what `choiceProbability` says. */
  readonly different: number;
  /** Largest difference of a probability from the double-precision one. */
  readonly worst: number;
  /** Largest difference between how often a light is chosen and its probability, at one point. */
  readonly worstFrequency: number;
  readonly alone: Answer;
  readonly none: Answer;
}

export async function probeChoices(backend: Backend, seed: number): Promise<ChoiceReport> {
  const random = seededRandom(seed);
  const { scene, emitters } = crowd(random);
  const ask = (k: number, point: Vec3, normal: Vec3, u: number): Question => ({
    ask: ASK.choice,
    emitter: k % emitters.length,
    point,
    u: [u, 0],
    vector: normal,
  });
  const questions = Array.from({ length: MOST_QUESTIONS }, (_, k) => {
    const normal = k % 5 === 0 ? ZERO : randomDirection(random);
    return ask(k, rounded(inCube(random, 5)), rounded(normal), Math.fround(random() * 0.9999999));
  });
  const [point, normal] = [rounded(inCube(random, 2)), rounded(randomDirection(random))];
  const even = questions.map((_, k) => ask(k, point, normal, Math.fround(k / MOST_QUESTIONS)));
  return withProbe(backend, async (probe) => {
    const answers = await probe.ask(scene, questions);
    const worst = answers.reduce((most, answer, k) => {
      const { point: at, vector, emitter } = questions[k]!;
      const facing = vector === undefined || length(vector) === 0 ? null : vector;
      return Math.max(most, Math.abs(answer[3] - choiceProbabilities(emitters, at, facing)[emitter]!));
    }, 0);
    const chosen = await probe.ask(scene, even);
    const frequencies = choiceProbabilities(emitters, point, normal).map((p, k) =>
      Math.abs(chosen.filter(([index]) => index === k).length / chosen.length - p),
    );
    const one = testScene({}, { lamp: testLight() }, eyeAtOrigin);
    const none = testScene({}, {}, eyeAtOrigin);
    return {
      choices: answers.length,
      different: answers.filter(([, probability, asked]) => probability !== asked).length,
      worst,
      worstFrequency: Math.max(...frequencies),
      alone: (await probe.ask(one, [ask(0, [0, 5, 0], [0, 1, 0], 0.7)]))[0]!,
      none: (await probe.ask(none, [ask(0, ZERO, ZERO, 0.7)]))[0]!,
    };
  });
}

/** A length from a micrometre to 1000 km, mostly of the size of a room. */
const anyLength = (random: Random) => (random() < 0.5 ? between(random, 0.1, 4) : 10 ** between(random, -6, 6));

function wildScene(random: Random): Scene {
  const shapes: Record<string, Shape> = {};
  for (let k = 0; k < 60; k++) {
    const center = random() < 0.3 ? ZERO : scale(randomDirection(random), anyLength(random));
    const sides: Vec3 = [anyLength(random), anyLength(random), anyLength(random)];
    const u = scale(randomDirection(random), sides[0]);
    const v = scale(randomDirection(random), sides[1]);
    const kind = k % 3;
    if (kind === 0) shapes[k] = { type: 'sphere', center, radius: sides[0], material: 'glow' };
    else if (kind === 1)
      shapes[k] = { type: 'box', center, size: sides, rotation: inCube(random, 180), material: 'glow' };
    else shapes[k] = { type: 'quad', corner: center, u, v: add(v, scale(u, 0.01)), material: 'glow' };
  }
  return testScene(shapes, {}, { ...eyeAtOrigin, materials: { glow } });
}

/** On the lamp, at its centre, beside it, or anywhere. */
function wildPoint(random: Random, shape: Shape): Vec3 {
  if (shape.type === 'plane') return ZERO;
  const middle = shape.type === 'quad' ? shape.corner : shape.center;
  const choice = random();
  if (choice < 0.1) return middle;
  if (choice < 0.5 && shape.type === 'sphere') return addScaled(middle, randomDirection(random), shape.radius);
  if (choice < 0.5 && shape.type === 'quad')
    return add(middle, add(scale(shape.u, random()), scale(shape.v, random() * 2)));
  if (choice < 0.6) return add(middle, scale(randomDirection(random), anyLength(random)));
  return scale(randomDirection(random), anyLength(random));
}

export interface WildReport {
  readonly asked: number;
  readonly faults: number;
  readonly examples: string[];
}

/** Lamps of all sizes and points in the worst places: every answer is finite, none is negative, all directions have length 1. */
export async function probeWildLamps(backend: Backend, seed: number): Promise<WildReport> {
  const random = seededRandom(seed);
  const scene = wildScene(random);
  // In the order of the emitters, which the packing sorts: any shape's point will do for any.
  const shapes = Object.values(scene.shapes);
  const edge = () => (random() < 0.1 ? 0 : random() < 0.1 ? 1 - 2 ** -24 : Math.fround(random() * 0.9999999));
  const questions: Question[] = Array.from({ length: MOST_QUESTIONS }, (_, k) => ({
    ask: [ASK.directionAndPdf, ASK.radianceAndDistance, ASK.pdfOfSample, ASK.choice][k % 4]!,
    emitter: Math.floor(random() * shapes.length),
    point: rounded(wildPoint(random, shapes[Math.floor(random() * shapes.length)]!)),
    u: [edge(), edge()],
    vector: rounded(randomDirection(random)),
  }));
  const answers = await withProbe(backend, (probe) => probe.ask(scene, questions));
  const wrong = answers.flatMap((answer, k) => {
    const question = questions[k]!;
    const isDirection = question.ask === ASK.directionAndPdf;
    const finite = answer.every(Number.isFinite);
    const positive = (isDirection ? answer.slice(3) : answer).every((x) => x >= 0);
    const unit =
      !isDirection || answer[3] === 0 || Math.abs(length(subtract([answer[0], answer[1], answer[2]], ZERO)) - 1) < 1e-5;
    return finite && positive && unit ? [] : [`${answer} to ${JSON.stringify(question)}`];
  });
  return { asked: answers.length, faults: wrong.length, examples: wrong.slice(0, 4) };
}
