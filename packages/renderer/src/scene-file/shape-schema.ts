import * as v from 'valibot';
import { MESH_ENDINGS, MESH_SHADINGS } from '../scene/mesh.ts';
import { instances, placement } from './node-schema.ts';
import { choice, direction, fileName, kind, nameOf, number, numbers, object, point, text, triple } from './values.ts';

/** Shapes, and the meshes that some of them place: the part of the schema that says what there is to see. */

const SMALLEST = 1e-6;
const LARGEST = 1e9;

export const meshFileRule =
  'the name of a file with triangles, .ply, .obj or .stl, relative to the scene\'s folder, with "/" between folders (.glb and .gltf belong to "models")';
export const mesh = object('a mesh: an object with "file"', {
  file: fileName(meshFileRule, MESH_ENDINGS),
  part: v.optional(text('the name of the part of the file that is meant', 1000)),
  shading: v.optional(choice('where normals come from', MESH_SHADINGS), 'auto'),
});

const materialName = nameOf('a material');
/** Of whatever a node may carry. */
export const carrier = v.optional(nameOf('a node'));
const meshName = nameOf('a mesh');
const shapeTypes = '"sphere", "box", "plane", "quad" or "mesh"';
export const shape = v.variant(
  'type',
  [
    object('a sphere: an object', {
      type: kind('sphere'),
      center: point('the centre'),
      radius: number('the radius in metres', SMALLEST, LARGEST),
      material: materialName,
      node: carrier,
    }),
    object('a box: an object', {
      type: kind('box'),
      center: point('the centre'),
      size: triple('the lengths of the three sides, metres', SMALLEST, LARGEST),
      rotation: v.optional(triple('the turn about X, then Y, then Z, degrees', -1e6, 1e6), [0, 0, 0]),
      material: materialName,
      node: carrier,
    }),
    object('a plane: an object', {
      type: kind('plane'),
      point: point('a point of the plane'),
      normal: direction('the direction across the plane'),
      material: materialName,
      node: carrier,
    }),
    object('a quad: an object', {
      type: kind('quad'),
      corner: point('one corner'),
      u: point('the way from the corner along one side'),
      v: point('the way from the corner along the other side'),
      material: materialName,
      node: carrier,
    }),
    object('a mesh that is placed: an object', {
      type: kind('mesh'),
      mesh: meshName,
      // Without one a mesh file's own count: `completeNames` makes a model of such a shape.
      material: v.optional(materialName),
      ...placement,
      matrix: v.optional(numbers('the placement, four rows of a matrix', 16, -LARGEST, LARGEST)),
      skin: v.optional(nameOf('a skin')),
      instances: v.optional(instances),
      node: carrier,
    }),
  ],
  (issue) => (issue.expected === 'Object' ? `a shape: an object whose "type" is ${shapeTypes}` : shapeTypes),
);
