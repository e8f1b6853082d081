/** Random surfaces and directions that try everything, grazing angles and the ends of all ranges above all. */
import { sampleBsdf } from '../../../../packages/renderer/src/reference/bsdf/bsdf.ts';
import type { BsdfSurface } from '../../../../packages/renderer/src/reference/bsdf/surface.ts';
import type { Color, Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { add, normalize, scale } from '../../../../packages/renderer/src/scene/vec3.ts';
import { directionOf, SURFACES, surface } from '../../../fixtures/bsdf-cases.ts';
import { between, inCube, pick, type Random } from '../../../fixtures/random.ts';
import { floatVector, inFloats } from './questions.ts';

const colorOf = (random: Random, most: number): Color => {
  const [r, g, b] = [random(), random(), random()];
  return pick(random, [
    [r, g, b],
    [r, g, b],
    [r, r, 0],
    [1, 1, 1],
    [0, 0, 0],
  ] as const).map((x) => x * most) as never;
};

function randomSurface(random: Random): BsdfSurface {
  const type = pick(random, ['diffuse', 'metallicRoughness', 'conductor', 'dielectric'] as const);
  const s = surface({
    type,
    baseColor: colorOf(random, 1),
    reflectivity: pick(random, [0, 0, 0, random(), 1]),
    metallic: pick(random, [0, 1, random()]),
    alpha: pick(random, [0, 0.0005, 0.001, 1, random() ** 4, random() ** 2, random()]),
    ior: pick(random, [1, 1.0015, 1.5, 4, between(random, 1.01, 4)]),
    eta: colorOf(random, 4),
    k: colorOf(random, 7),
    thin: random() < 0.2,
    energyCompensation: random() < 0.3,
  });
  // By what means nothing there. glTF's material knows one masking only.
  const apart = (type === 'conductor' && s.thin) || (type === 'dielectric' && s.energyCompensation);
  return { ...s, masking: apart ? 'separable' : 'correlated' };
}

export const randomSurfaces = (random: Random, count: number): BsdfSurface[] =>
  [...Object.values(SURFACES), ...Array.from({ length: count }, () => randomSurface(random))].map(inFloats);

/** Every third is grazing, down to a cosine of 1e-5; one in ten is straight up. */
function randomUp(random: Random): Vec3 {
  const kind = random();
  const cosine = kind < 0.1 ? 1 : kind < 0.4 ? 10 ** between(random, -5, -1) : random();
  return directionOf(cosine, between(random, -4, 4));
}

export function randomOutgoing(random: Random, s: BsdfSurface): Vec3 {
  const wo = randomUp(random);
  return floatVector(s.type === 'dielectric' && random() < 0.5 ? [wo[0], wo[1], -wo[2]] : wo);
}

export const randomNumbers = (random: Random): Vec3 => {
  // 24 bits, as the sampler of the kernels gives them; sometimes the ends of the range.
  const one = () =>
    Math.floor(pick(random, [random(), random(), random(), random(), 0, 1 - 2 ** -24]) * 2 ** 24) / 2 ** 24;
  return [one(), one(), one()];
};

/** Anywhere; or in the lobe, or a little beside it; sometimes on the dark side. */
export function randomIncoming(random: Random, s: BsdfSurface, wo: Vec3): Vec3 {
  const sampled = random() < 0.7 ? sampleBsdf(s, wo, [random(), random(), random()]) : null;
  if (!sampled) {
    const up = randomUp(random);
    return floatVector(random() < 0.2 || s.type === 'dielectric' ? scale(up, pick(random, [1, -1])) : up);
  }
  return floatVector(normalize(add(sampled.direction, inCube(random, pick(random, [0, 0, 0.2 * s.alpha])))));
}
