import * as v from 'valibot';
import { SCENE_LIMITS } from '../scene/limits.ts';
import { MESH_ENDINGS, MESH_SHADINGS } from '../scene/mesh.ts';
import { SMALLEST_SCALE } from '../scene/well-formed.ts';
import { choice, direction, factors, fileName, kind, number, numbers, object, point, text, triple } from './values.ts';

/** Shapes, and the meshes that some of them place: the part of the schema that says what there is to see. */

const SMALLEST = 1e-6;
const LARGEST = 1e9;
const LARGEST_SCALE = 1e6;

export const meshFileRule =
  'the name of a file with triangles, .ply, .obj or .stl, from the folder of the scene on, with "/" between folders';
export const mesh = object('a mesh: an object with "file"', {
  file: fileName(meshFileRule, MESH_ENDINGS),
  part: v.optional(text('the name of the part of the file that is meant', 1000)),
  shading: v.optional(choice('how normals come about', MESH_SHADINGS), 'auto'),
});

const materialName = text('the name of a material of this scene', SCENE_LIMITS.nameLength);
const meshName = text('the name of a mesh of this scene', SCENE_LIMITS.nameLength);
const shapeTypes = '"sphere", "box", "plane", "quad" or "mesh"';
export const shape = v.variant(
  'type',
  [
    object('a sphere: an object', {
      type: kind('sphere'),
      center: point('the centre'),
      radius: number('the radius in metres', SMALLEST, LARGEST),
      material: materialName,
    }),
    object('a box: an object', {
      type: kind('box'),
      center: point('the centre'),
      size: triple('the lengths of the three sides, metres', SMALLEST, LARGEST),
      rotation: v.optional(triple('the turn about X, then Y, then Z, degrees', -1e6, 1e6), [0, 0, 0]),
      material: materialName,
    }),
    object('a plane: an object', {
      type: kind('plane'),
      point: point('a point of the plane'),
      normal: direction('the direction across the plane'),
      material: materialName,
    }),
    object('a quad: an object', {
      type: kind('quad'),
      corner: point('one corner'),
      u: point('the way from the corner along one side'),
      v: point('the way from the corner along the other side'),
      material: materialName,
    }),
    object('a mesh that is placed: an object', {
      type: kind('mesh'),
      mesh: meshName,
      material: materialName,
      translation: v.optional(point('where the origin of the mesh goes'), [0, 0, 0]),
      rotation: v.optional(triple('the turn about X, then Y, then Z, degrees', -1e6, 1e6), [0, 0, 0]),
      scale: v.optional(factors('how many times as large it is', SMALLEST_SCALE, LARGEST_SCALE), [1, 1, 1]),
      matrix: v.optional(numbers('the placement, four rows of a matrix', 16, -LARGEST, LARGEST)),
    }),
  ],
  (issue) => (issue.expected === 'Object' ? `a shape: an object whose "type" is ${shapeTypes}` : shapeTypes),
);
