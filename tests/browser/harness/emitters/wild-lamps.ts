/** Light sampling where it could break, on a GPU. */

import type { LampShape, Scene, Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { add, addScaled, length, scale } from '../../../../packages/renderer/src/scene/vec3.ts';
import { between, inCube, type Random, randomDirection, seededRandom } from '../../../fixtures/random.ts';
import { testMaterial, testScene } from '../../../fixtures/scenes.ts';
import { ASK, eyeAtOrigin, type GpuBackend, MOST_QUESTIONS, type Question, rounded, withProbe } from './probe.ts';

const ZERO: Vec3 = [0, 0, 0];
const glow = testMaterial({ emission: [2, 1, 3] });

/** A length from a micrometre to 1000 km, mostly of the size of a room. */
const anyLength = (random: Random) => (random() < 0.5 ? between(random, 0.1, 4) : 10 ** between(random, -6, 6));

function wildScene(random: Random): { scene: Scene; lamps: LampShape[] } {
  const shapes: Record<string, LampShape> = {};
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
  return { scene: testScene(shapes, {}, { ...eyeAtOrigin, materials: { glow } }), lamps: Object.values(shapes) };
}

/** On the lamp, at its centre, beside it, or anywhere. */
function wildPoint(random: Random, shape: LampShape): Vec3 {
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
export async function probeWildLamps(backend: GpuBackend, seed: number): Promise<WildReport> {
  const random = seededRandom(seed);
  const { scene, lamps: shapes } = wildScene(random);
  // In the order of the emitters, which the packing sorts: any shape's point will do for any.
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
    const unit = !isDirection || answer[3] === 0 || Math.abs(length([answer[0], answer[1], answer[2]]) - 1) < 1e-5;
    return finite && positive && unit ? [] : [`${answer} to ${JSON.stringify(question)}`];
  });
  return { asked: answers.length, faults: wrong.length, examples: wrong.slice(0, 4) };
}
