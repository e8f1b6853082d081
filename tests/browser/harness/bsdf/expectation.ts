/**
 * What 32-bit floats may answer. All rounding on the way to the half vector and the cosines is as if wo and wi were moved by
 * a few units in the last place, the index of refraction by one for its reciprocal; what follows are products of fewer than
 * 256 rounded factors. So the answer lies within what the double-precision BSDF gives for directions and indices moved at
 * random by that much, and 256 roundings. The share of the matte lobe is 1 minus that of the gloss: rounded as 1 is.
 */
import { evaluateBsdf } from '../../../../packages/renderer/src/reference/bsdf/bsdf.ts';
import type { BsdfSurface } from '../../../../packages/renderer/src/reference/bsdf/surface.ts';
import type { Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { add } from '../../../../packages/renderer/src/scene/vec3.ts';
import { inCube, type Random } from '../../../fixtures/random.ts';
import type { Answer } from './questions.ts';

const ROUNDING = 2 ** -24;
const MOVED = 6 * ROUNDING;
const FACTORS = 256;
/** So many moved directions; their spread counts twice, since none of them need be the worst. */
const TRIES = 16;
/** Less than any value or density of a lobe that matters. */
const NOTHING = 1e-9;
const SHARE = 4 * ROUNDING;

export interface Bounds {
  readonly expected: Answer;
  readonly tolerance: Answer;
}

const evaluation = (s: BsdfSurface, wo: Vec3, wi: Vec3): Answer => {
  const { value, pdf } = evaluateBsdf(s, wo, wi);
  return [...value, pdf];
};

export function expectation(s: BsdfSurface, wo: Vec3, wi: Vec3, random: Random): Bounds {
  const expected = evaluation(s, wo, wi);
  const spread = [0, 0, 0, 0];
  for (let i = 0; i < TRIES; i++) {
    const index = { ...s, ior: s.ior * (1 + ROUNDING * (4 * random() - 2)) };
    const movedWo = keepSide(add(wo, inCube(random, MOVED)), wo);
    const moved = evaluation(index, movedWo, keepSide(add(wi, inCube(random, MOVED)), wi));
    moved.forEach((x, c) => {
      spread[c] = Math.max(spread[c]!, Math.abs(x - expected[c]!));
    });
  }
  const tolerance = spread.map(
    (x, c) =>
      2 * x +
      FACTORS * ROUNDING * Math.abs(expected[c]!) +
      (c === 3 && s.type === 'metallicRoughness' ? SHARE : NOTHING),
  );
  return { expected, tolerance: tolerance as unknown as Answer };
}

/** The kernel reads the side of the surface off the direction itself: no rounding changes it. */
function keepSide(moved: Vec3, original: Vec3): Vec3 {
  const least = 1e-12;
  const z = original[2] < 0 ? Math.min(moved[2], -least) : Math.max(moved[2], least);
  return [moved[0], moved[1], z];
}
