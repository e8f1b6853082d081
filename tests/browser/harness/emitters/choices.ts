/** The choice among lights on a GPU, judged by the double-precision one and by how often each is chosen. */
import { choiceProbabilities } from '../../../../packages/renderer/src/reference/light/choose.ts';
import type { Emitter } from '../../../../packages/renderer/src/reference/light/emitter.ts';
import { emitterOfLight, emitterOfShape } from '../../../../packages/renderer/src/reference/light/from-scene.ts';
import type { Color, LampShape, Light, Scene, Shape, Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { add, length } from '../../../../packages/renderer/src/scene/vec3.ts';
import { meshLamp } from '../../../fixtures/lights/mesh-cases.ts';
import { cubeMesh } from '../../../fixtures/meshes/solids.ts';
import { between, inCube, type Random, randomDirection, seededRandom } from '../../../fixtures/random.ts';
import { testLight, testMaterial, testScene } from '../../../fixtures/scenes.ts';
import {
  type Answer,
  ASK,
  eyeAtOrigin,
  type GpuBackend,
  MOST_QUESTIONS,
  type Question,
  rounded,
  withProbe,
} from './probe.ts';

const ZERO: Vec3 = [0, 0, 0];
const color: Color = [1, 2, 4];
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
  // What is infinitely far comes first, and shapes are sorted by power: strongest first.
  const shapes: LampShape[] = [
    { type: 'box', center: place(), size: [1, 2, 0.5], rotation: [10, 20, 30], material: 'glow' },
    { type: 'quad', corner: place(), u: [0.5, 0, 0], v: [0, 0.5, 0.1], material: 'glow' },
    { type: 'sphere', center: place(), radius: 0.1, material: 'glow' },
  ];
  const sky = { horizon: [0.01, 0.02, 0.03], zenith: [0.03, 0.02, 0.01] } as const;
  const scene = testScene(named(shapes), named(lights), { ...eyeAtOrigin, sky, materials: { glow } });
  const shining = lights.map(emitterOfLight);
  const emitters = [
    ...shining.filter(({ kind }) => kind === 'directional'),
    { kind: 'sky', ...sky } as const,
    ...shining.filter(({ kind }) => kind !== 'directional'),
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

export async function probeChoices(backend: GpuBackend, seed: number): Promise<ChoiceReport> {
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

/** Many lights of all kinds, in clumps, among them meshes and such as are infinitely far. */
function throng(random: Random): { scene: Scene; count: number } {
  const lights: Light[] = [
    { type: 'directional', direction: inCube(random, 1), irradiance: 0.1, color, angle: 20 },
    { type: 'directional', direction: inCube(random, 1), irradiance: 0.2, color, angle: 0 },
  ];
  const shapes: Shape[] = [];
  for (let clump = 0; clump < 8; clump++) {
    const middle = inCube(random, 10);
    const place = () => add(middle, inCube(random, 0.5));
    for (let k = 0; k < 12; k++) {
      const intensity = 10 ** between(random, -2, 2);
      lights.push({ type: 'point', position: place(), intensity, color });
      lights.push({ type: 'spot', position: place(), direction: inCube(random, 1), intensity, color, innerAngle: 5, outerAngle: 40 }); // biome-ignore format: a light
    }
    shapes.push({ type: 'box', center: place(), size: [1, 2, 0.5], rotation: [10, 20, 30], material: 'glow' });
    shapes.push({ type: 'quad', corner: place(), u: [0.5, 0, 0], v: [0, 0.5, 0.1], material: 'glow' });
    shapes.push({ type: 'sphere', center: place(), radius: 0.1, material: 'glow' });
    shapes.push(meshLamp({ translation: place(), rotation: inCube(random, 180), scale: [1, -0.3, 2] }));
  }
  const sky = { horizon: [0.01, 0.02, 0.03], zenith: [0.03, 0.02, 0.01] } as const;
  const scene = testScene(named(shapes), named(lights), {
    ...eyeAtOrigin,
    sky,
    materials: { glow },
    meshes: { lamp: { data: cubeMesh() } },
  });
  return { scene, count: lights.length + 1 + shapes.length };
}

export interface TreeReport {
  readonly emitters: number;
  /** Choices whose probability is not bit for bit what is told of the one chosen. */
  readonly different: number;
  /** The sum of all lights' probabilities, over the points. */
  readonly leastSum: number;
  readonly mostSum: number;
  /** Largest difference between how often a light is chosen and its probability, at the points. */
  readonly worstFrequency: number;
}

/** Where a tree chooses: at some points, near and far, every light is asked for. */
export async function probeTree(backend: GpuBackend, seed: number): Promise<TreeReport> {
  const random = seededRandom(seed);
  const { scene, count } = throng(random);
  const report = { emitters: count, different: 0, leastSum: 1, mostSum: 0, worstFrequency: 0 };
  await withProbe(backend, async (probe) => {
    for (const size of [1, 8, 12, 200]) {
      const [point, normal] = [rounded(inCube(random, size)), size === 8 ? ZERO : rounded(randomDirection(random))];
      const asked = await probe.ask(
        scene,
        Array.from({ length: MOST_QUESTIONS }, (_, k) => ({
          ask: ASK.choice,
          emitter: k % count,
          point,
          u: [Math.fround(k / MOST_QUESTIONS), 0] as const,
          vector: normal,
        })),
      );
      const told = asked.slice(0, count).map((answer) => answer[3]);
      const chosen = new Array<number>(count).fill(0);
      for (const [index, probability] of asked) if (probability > 0) chosen[index]! += 1 / MOST_QUESTIONS;
      const sum = told.reduce((all, p) => all + p, 0);
      report.different += asked.filter(([, probability, own]) => probability !== own).length;
      report.leastSum = Math.min(report.leastSum, sum);
      report.mostSum = Math.max(report.mostSum, sum);
      report.worstFrequency = Math.max(report.worstFrequency, ...told.map((p, k) => Math.abs(p - chosen[k]!)));
    }
  });
  return report;
}
