/** three-mesh-bvh's first hit on the GPU: its own WGSL, its own tree and its own buffers, in an entry that reads and writes as ours does. */
import type { BufferGeometry } from 'three';
import functions from '../../../node_modules/three-mesh-bvh/src/webgpu/bvh_ray_functions.wgsl.js?raw';
import common from '../../../node_modules/three-mesh-bvh/src/webgpu/common_functions.wgsl.js?raw';
import type { TriangleMesh } from '../../../packages/renderer/src/bvh/bvh.ts';
import { buildPeer, peerGeometry } from '../../bvh/peer.ts';
import type { Contestant } from './race.ts';

/** The package gives its functions as nodes of three's own shader language; the text inside is WGSL. */
function wgslOf(name: string): string {
  const found = new RegExp(`export const ${name} = wgsl(?:Fn)?\\(\\s*/\\* wgsl \\*/\\s*\`([^\`]*)\``).exec(
    common + functions,
  );
  if (!found) throw new Error(`three-mesh-bvh has no ${name} any more.`);
  return found[1]!;
}

const FUNCTIONS = [
  'constants',
  'intersectionResultStruct',
  'intersectsBounds',
  'intersectsTriangle',
  'intersectTriangles',
  'bvhIntersectFirstHit',
];

const program = (): string => `
struct Ray { origin: vec3f, direction: vec3f }
struct BVHBoundingBox { min: array<f32, 3>, max: array<f32, 3> }
struct BVHNode { bounds: BVHBoundingBox, rightChildOrTriangleOffset: u32, splitAxisOrTriangleCount: u32 }
${FUNCTIONS.map(wgslOf).join('\n')}
@group(0) @binding(0) var<storage, read> bvh: array<BVHNode>;
@group(0) @binding(1) var<storage, read> bvh_index: array<vec3u>;
@group(0) @binding(2) var<storage, read> bvh_position: array<vec3f>;
@group(0) @binding(7) var<storage, read> rays: array<vec4f>;
@group(0) @binding(8) var<storage, read_write> hits: array<vec2f>;
@compute @workgroup_size(64) fn traceRays(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) thread: u32) {
  let first = (group.y * groups.x + group.x) * 256u + thread;
  for (var k = 0u; k < 4u; k++) {
    let i = first + k * 64u;
    if (i >= arrayLength(&hits)) { return; }
    let hit = bvhIntersectFirstHit(&bvh_index, &bvh_position, &bvh, Ray(rays[2u * i].xyz, rays[2u * i + 1u].xyz));
    hits[i] = vec2f(select(1e30, hit.dist, hit.didHit), bitcast<f32>(select(0xffffffffu, hit.indices.w, hit.didHit)));
  }
}`;

/** Rows of three, with room for a fourth as arrays of vectors have it in WGSL. */
function padded<T extends Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>>(
  numbers: ArrayLike<number>,
  into: T,
): T {
  for (let i = 0; i < numbers.length; i++) into[4 * Math.floor(i / 3) + (i % 3)] = numbers[i]!;
  return into;
}

/** With the tree that it builds by itself under the strategy that ours has too: the surface area heuristic. */
export function peer({ positions, indices }: TriangleMesh): Contestant {
  const geometry: BufferGeometry = peerGeometry({ positions, indices });
  const tree = buildPeer(geometry, 10) as unknown as {
    _roots: ArrayBuffer[];
    geometry: { index: { array: Uint32Array } };
  };
  const index = tree.geometry.index.array;
  return {
    name: 'three-mesh-bvh',
    wgsl: program(),
    uniforms: {},
    buffers: {
      0: new Uint32Array(tree._roots[0]!),
      1: padded(index, new Uint32Array((index.length / 3) * 4)),
      2: padded(positions, new Float32Array((positions.length / 3) * 4)),
    },
  };
}
