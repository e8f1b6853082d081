/** Cameras: they look along −Z of their nodes. */
import type { Camera } from '../scene/scene.ts';
import type { NodesInScene } from './nodes.ts';
import type { Path } from './problems.ts';
import { NamedThings, type Reading, within } from './reading.ts';

const degrees = (radians: number): number => (radians * 180) / Math.PI;

export type Cameras = NamedThings<Camera> & { byCamera: Map<number, string[]> };

export function readCameras(reading: Reading, { nodes, order, shown }: NodesInScene): Cameras {
  const cameras = Object.assign(new NamedThings<Camera>(), { byCamera: new Map<number, string[]>() });
  for (const index of order) {
    const camera = reading.json.nodes![index]!.camera;
    if (camera === undefined || !shown.has(index)) continue;
    const node = nodes.nameOf(index)!;
    const made = readCamera(reading, camera, node);
    const name = cameras.add(
      made,
      reading.json.cameras![camera]!.name ?? reading.json.nodes![index]!.name,
      `camera ${camera}`,
    );
    cameras.byCamera.set(camera, [...(cameras.byCamera.get(camera) ?? []), name]);
  }
  return cameras;
}

/** What lies nearer than `znear` or beyond `zfar` is seen too: rays need no such planes. */
function readCamera(reading: Reading, index: number, node: string): Camera {
  const { type, perspective, orthographic } = reading.json.cameras![index]!;
  const path: Path = ['cameras', index, type];
  const place = { eye: [0, 0, 0], target: [0, 0, -1], up: [0, 1, 0], node } as const;
  if (type === 'perspective')
    return { ...place, verticalFov: within(reading, degrees(perspective!.yfov), 0.01, 179, [...path, 'yfov']) };
  const height = within(reading, 2 * Math.abs(orthographic!.ymag), 1e-6, 1e9, [...path, 'ymag']);
  return { ...place, verticalFov: 45, projection: 'orthographic', viewHeight: height };
}
