/** The kernels' own way through a mesh, `traverse.wesl`, over the geometry that a renderer would upload. */
import type { TriangleMesh } from '../../../packages/renderer/src/bvh/bvh.ts';
import { type FieldName, structSize } from '../../../packages/renderer/src/packed-scene/layout.ts';
import { packGeometry } from '../../../packages/renderer/src/packed-scene/pack-geometry.ts';
import { wordsOf } from '../../../packages/renderer/src/packed-scene/packed-mesh.ts';
import { createBlock, writeStruct } from '../../../packages/renderer/src/packed-scene/write-struct.ts';
import type { MeshShape } from '../../../packages/renderer/src/scene/scene.ts';
import { testScene } from '../../../tests/fixtures/scenes.ts';
import wgsl from './generated/trace_rays.wgsl?raw';
import type { Contestant } from './race.ts';

const ONCE: MeshShape = {
  type: 'mesh',
  mesh: 'mesh',
  material: 'white',
  translation: [0, 0, 0],
  rotation: [0, 0, 0],
  scale: [1, 1, 1],
};

export interface Ours extends Contestant {
  readonly bytesPerTriangle: number;
  /** Which triangle of the mesh stands at each place. */
  readonly order: Uint32Array;
}

export function ours(mesh: TriangleMesh): Ours {
  const played = testScene({ once: ONCE }, {}, { meshes: { mesh: { data: mesh } } });
  const packed = packGeometry({ played, time: 0 }, { first: 0, covers: [0], glows: [] }, [0, 0, 0]);
  const frame = createBlock(structSize('Frame'));
  const values: { [F in FieldName<'Frame'>]?: number } = {
    instances: packed.instances,
    instanceCount: packed.instanceCount,
  };
  writeStruct(frame, 'Frame', 0, values);
  const geometry = new Uint32Array(packed.rows * 4);
  geometry.set(packed.moving.u32);
  let at = packed.movingRows * 4;
  for (const words of packed.meshes.flatMap(wordsOf)) {
    geometry.set(words, at);
    at += words.length;
  }
  return {
    name: 'Mirrorball',
    wgsl,
    uniforms: { 0: frame.u32 },
    // Textures, of which there are none: the program could look them up.
    buffers: { 5: geometry, 6: new Uint32Array(4) },
    order: packed.meshes[0]!.order,
    bytesPerTriangle: (16 * packed.rows) / (mesh.indices.length / 3),
  };
}
