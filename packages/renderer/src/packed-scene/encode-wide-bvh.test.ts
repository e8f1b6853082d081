import { describe, expect, test } from 'vitest';
import { awkwardMeshes, bumpySphere, landscape, soup } from '../../../../tests/fixtures/meshes.ts';
import { between, pick, randomDirection, seededRandom } from '../../../../tests/fixtures/random.ts';
import { buildBvh } from '../bvh/build-bvh.ts';
import type { Bvh, TriangleMesh } from '../bvh/bvh.ts';
import { triangleBoxes } from '../bvh/primitive-boxes.ts';
import { addChild, type NodeSource, roomForChildren } from '../bvh/trace/node-source.ts';
import { closestByBruteForce, closestHit } from '../bvh/trace/trace.ts';
import { encodeWideBvh, MOST_IN_LEAF } from './encode-wide-bvh.ts';
import { type FieldName, fieldOffset, GEOMETRY_ROW, geometryRows } from './layout.ts';

const word = (field: FieldName<'WideNode'>) => fieldOffset('WideNode', field) / 4;
const FACES = (['minX', 'minY', 'minZ', 'maxX', 'maxY', 'maxZ'] as const).map(word);

/** The words read back as a kernel reads them. */
function wideSource(bvh: Bvh): NodeSource {
  const { words, stackNeed } = encodeWideBvh(bvh);
  const floats = new Float32Array(words.buffer);
  return {
    root: 0,
    order: bvh.order,
    stackSize: stackNeed,
    readChildren(node, into) {
      into.count = 0;
      const at = node * geometryRows('WideNode') * GEOMETRY_ROW;
      for (let k = 0; k < 4; k++) {
        const reference = words[at + word('children') + k]!;
        if (reference === 0) continue;
        const isLeaf = reference >>> 31 === 1;
        const bounds = FACES.map((face) => floats[at + face + k]!);
        addChild(into, bounds, isLeaf ? (reference >>> 28) & 7 : 0, isLeaf ? reference & 0xfffffff : reference);
      }
    },
  };
}

const random = seededRandom(87);
const meshes = Object.entries<TriangleMesh>({
  ...awkwardMeshes(random),
  soup: soup(random, 1000),
  landscape: landscape(random, 20),
  sphere: bumpySphere(random, 15),
});
const options = { maxLeafSize: 4 };

describe.each(meshes)('%s', (_, mesh) => {
  const bvh = buildBvh(mesh, options);
  const source = wideSource(bvh);

  test('every triangle is in one leaf, and in all boxes above it', () => {
    const boxes = triangleBoxes(mesh);
    const below = (node: number): number[] => {
      const children = roomForChildren();
      source.readChildren(node, children);
      return Array.from({ length: children.count }, (_, i) => {
        const [count, index] = [children.primitives[i]!, children.index[i]!];
        const triangles = count > 0 ? [...source.order.subarray(index, index + count)] : below(index);
        for (const triangle of triangles)
          for (let k = 0; k < 6; k++) {
            const [outer, inner] = [children.bounds[6 * i + k]!, boxes[6 * triangle + k]!];
            if (k < 3 ? outer > inner : outer < inner) expect.fail(`${outer} leaves ${inner} of ${triangle} outside`);
          }
        return triangles;
      }).flat();
    };
    const all = below(0).sort((a, b) => a - b);
    expect(all).toEqual(Array.from({ length: mesh.indices.length / 3 }, (_, triangle) => triangle));
  });

  test('a ray finds what brute force finds, with no more on the stack than promised (seed 88)', () => {
    const rays = seededRandom(88);
    const size = mesh.positions.reduce((most, x) => Math.max(most, Math.abs(x)), 1e-30);
    for (let k = 0; k < 100 && mesh.indices.length > 0; k++) {
      const vertex = 3 * pick(rays, [...mesh.indices.subarray(0, 300)]);
      const direction = [...randomDirection(rays)] as [number, number, number];
      const origin = direction.map(
        (d, axis) => mesh.positions[vertex + axis]! - d * size + between(rays, -0.01, 0.01) * size,
      ) as [number, number, number];
      const ray = { origin, direction, tMin: 0, tMax: Number.POSITIVE_INFINITY };
      expect(closestHit(source, mesh, ray)).toEqual(closestByBruteForce(mesh, ray));
    }
  });
});

test('a leaf with more than its reference can count is refused', () => {
  const same = {
    positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
    indices: new Uint32Array(24).map((_, k) => k % 3),
  };
  const tree = buildBvh(same, { leafSize: MOST_IN_LEAF + 1, maxLeafSize: MOST_IN_LEAF + 1 });
  expect(() => encodeWideBvh(tree)).toThrow(RangeError);
});
