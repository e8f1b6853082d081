import * as v from 'valibot';
import { AFFINE_LENGTH, composeAffine, type Numbers, toQuaternion } from '../scene/affine.ts';
import { SCENE_LIMITS } from '../scene/limits.ts';
import { MODEL_ENDINGS } from '../scene/models.ts';
import type { Quaternion } from '../scene/nodes.ts';
import type { Vec3 } from '../scene/scene.ts';
import { quaternionOf } from '../scene/vec3.ts';
import { SMALLEST_SCALE } from '../scene/well-formed.ts';
import {
  choice,
  factors,
  fileName,
  listOf,
  manyNumbers,
  nameOf,
  number,
  numbers,
  object,
  point,
  text,
  triple,
} from './values.ts';

/** Nodes, and what moves or hangs on them: skins, clips, variants, models, instances. */

const LARGEST = 1e9;
const LARGEST_SCALE = 1e6;

export const placement = {
  translation: v.optional(point('where its origin goes'), [0, 0, 0]),
  rotation: v.optional(triple('the turn about X, then Y, then Z, degrees', -1e6, 1e6), [0, 0, 0]),
  scale: v.optional(factors('how many times as large it is', SMALLEST_SCALE, LARGEST_SCALE), [1, 1, 1]),
};

const turnRule = 'the turn: three angles about X, then Y, then Z, degrees, or the four numbers of a quaternion';
const oneNumber = 'one number of the turn: from -1e6 to 1e6';
const turn = v.pipe(
  v.array(v.pipe(v.number(oneNumber), v.minValue(-1e6, oneNumber), v.maxValue(1e6, oneNumber)), turnRule),
  v.check((list) => list.length === 3 || (list.length === 4 && Math.hypot(...list) >= 1e-6), turnRule),
  v.description(turnRule),
  v.transform((list) => asQuaternion(list) as Quaternion & number[]),
);

/** Of length 1; one that has it already stays as it is, digit for digit. */
function asQuaternion(list: readonly number[]): Quaternion {
  if (list.length === 3) return quaternionOf(list as unknown as Vec3);
  const square = list.reduce((sum, x) => sum + x * x, 0);
  return Math.abs(square - 1) < 1e-12
    ? (list as unknown as Quaternion)
    : toQuaternion(...(list as unknown as Quaternion));
}

const matrix = numbers('the placement, three rows of a matrix', 12, -LARGEST, LARGEST);
const nodeFields = {
  parent: v.optional(nameOf('a node')),
  translation: v.optional(point('where its origin goes')),
  rotation: v.optional(turn),
  scale: v.optional(triple('how many times as large it is', -LARGEST_SCALE, LARGEST_SCALE)),
  matrix: v.optional(matrix),
  weights: v.optional(listOf('how much of each morph target', number('a weight', -1e6, 1e6), 1024)),
};
const PARTS = ['translation', 'rotation', 'scale'] as const;
const besideMatrix = 'nothing, as "matrix" says where the node is';
export const node = v.pipe(
  object('a node: an object', nodeFields),
  v.rawCheck(({ dataset, addIssue }) => {
    if (!dataset.typed || dataset.value.matrix === undefined) return;
    const { value } = dataset;
    for (const key of PARTS)
      if (value[key] !== undefined)
        addIssue({
          message: besideMatrix,
          input: value[key],
          path: [{ type: 'object', origin: 'value', input: value, key, value: value[key] }],
        });
  }),
  // Written out, so that tracks can move them.
  v.transform((given) =>
    given.matrix
      ? given
      : {
          ...given,
          translation: given.translation ?? ([0, 0, 0] as const),
          rotation: given.rotation ?? ([0, 0, 0, 1] as const),
          scale: given.scale ?? ([1, 1, 1] as const),
        },
  ),
);

export const skin = object('a skin: an object with "joints"', {
  joints: v.pipe(
    listOf('the joints', nameOf('a node'), SCENE_LIMITS.jointsPerSkin),
    v.minLength(1, 'the joints: a list of at least 1'),
  ),
  inverseBindMatrices: v.optional(manyNumbers('from the mesh to each joint, 12 numbers a joint')),
});

const clipFields = object('a clip: an object with "tracks"', {
  duration: v.optional(number('the seconds until it repeats', 0, LARGEST)),
  repeat: v.optional(choice('what follows the end', ['once', 'loop', 'ping-pong'])),
  tracks: listOf(
    'the tracks',
    object('a track of a clip: an object with "target", "times" and "values"', {
      target: text('a JSON Pointer to what moves, such as "/nodes/arm/rotation"', 1000),
      interpolation: v.optional(choice('the way from key to key', ['step', 'linear', 'cubic']), 'linear'),
      times: manyNumbers('the times of the keys, seconds'),
      values: manyNumbers('the values at these times'),
    }),
    SCENE_LIMITS.tracksPerClip,
  ),
});
export const clip = v.pipe(
  clipFields,
  // As long as its tracks, when it does not say.
  v.transform(({ duration, ...given }) => ({ duration: duration ?? lengthOf(given.tracks), ...given })),
);
export const lengthOf = (tracks: readonly { readonly times: Float32Array }[]): number =>
  Math.max(0, ...tracks.map(({ times }) => times.at(-1) ?? 0));

const name = text('the name of a material of this scene', SCENE_LIMITS.nameLength);
export const variant = v.record(v.string(), name, 'a variant: an object with materials by the names of shapes');

export const modelFileRule =
  'the name of a file with a model, .glb, .gltf, .obj, .ply or .stl, relative to the scene\'s folder, with "/" between folders';
export const model = object('a model: an object with "file"', {
  file: fileName(modelFileRule, MODEL_ENDINGS),
  ...placement,
  node: v.optional(nameOf('a node')),
  variant: v.optional(text('the name of one of the variants of the file', SCENE_LIMITS.nameLength)),
});

const instanceRule =
  'a place: 12 numbers, three rows of a matrix, or an object with "translation", "rotation" or "scale"';
const instance = v.union(
  [matrix, object(instanceRule, { ...placement, rotation: v.optional(turn) }), number('one number', -LARGEST, LARGEST)],
  instanceRule,
);
const placesRule = `the places of the mesh: a list of 1 to ${SCENE_LIMITS.instances}`;
export const instances = v.pipe(
  v.array(instance, placesRule),
  v.maxLength(SCENE_LIMITS.instances * AFFINE_LENGTH, placesRule),
  v.check((places) => isWhole(places), placesRule),
  v.description(placesRule),
  v.transform((places) => {
    if (isFlat(places)) return Float32Array.from(places);
    const all = new Float32Array(places.length * AFFINE_LENGTH);
    places.forEach((place, i) => {
      const at = i * AFFINE_LENGTH;
      if (typeof place === 'number') return;
      if (isList(place)) all.set(place, at);
      else composeAffine(all, at, place.translation, 0, (place.rotation ?? NO_TURN) as Numbers, 0, place.scale, 0);
    });
    return all;
  }),
);
const NO_TURN = [0, 0, 0, 1] as const;
const isList = (place: object): place is readonly number[] => Array.isArray(place);
/** Numbers of all places one after the other, as programs have them. */
const isFlat = (places: readonly unknown[]): places is readonly number[] => places.every((x) => typeof x === 'number');
const isWhole = (places: readonly unknown[]): boolean =>
  places.length > 0 &&
  (isFlat(places)
    ? places.length % AFFINE_LENGTH === 0
    : places.length <= SCENE_LIMITS.instances && !places.some((x) => typeof x === 'number'));
