/** three-mesh-bvh beside ours: its SAH builder through its public interface, and its tree as a neutral one. */
import { BufferAttribute, BufferGeometry } from 'three';
import { MeshBVH, SAH } from 'three-mesh-bvh';
import type { Bvh, TriangleMesh } from '../../packages/renderer/src/bvh/bvh.ts';

/** Copies, as its builder sorts the index. */
export function peerGeometry({ positions, indices }: TriangleMesh): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions.slice(), 3));
  return geometry.setIndex(new BufferAttribute(indices.slice(), 1));
}

export const buildPeer = (geometry: BufferGeometry, leafSize: number): MeshBVH =>
  new MeshBVH(geometry, { strategy: SAH, targetLeafSize: leafSize });

/** Bounds and leaves, which is all that a cost needs. */
export function neutral(peer: MeshBVH, primitiveCount: number): Bvh {
  const bounds: number[] = [];
  const links: number[] = [];
  let depth = 0;
  peer.traverse((level, isLeaf, box, first, count) => {
    for (let k = 0; k < 6; k++) bounds.push(box[k]!);
    links.push(isLeaf ? first : 0, isLeaf ? count : 0);
    depth = Math.max(depth, level);
  });
  return {
    nodeCount: links.length / 2,
    bounds: Float32Array.from(bounds),
    links: Uint32Array.from(links),
    primitiveCount,
    order: new Uint32Array(0),
    depth,
  };
}
