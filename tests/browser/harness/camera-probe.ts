/** Rays of a camera by the kernels' own functions. */
import type { Camera } from 'mirrorball';
import type { PassSource } from '../../../packages/renderer/src/gpu/device.ts';
import { structSize } from '../../../packages/renderer/src/packed-scene/layout.ts';
import { packFrame } from '../../../packages/renderer/src/packed-scene/pack-frame.ts';
import { packScene } from '../../../packages/renderer/src/packed-scene/pack-scene.ts';
import { createBlock } from '../../../packages/renderer/src/packed-scene/write-struct.ts';
import { ALL_SWITCHES } from '../../../packages/renderer/src/shading/features.ts';
import fullScreenWgsl from '../../../packages/renderer/src/shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../../../packages/renderer/src/shading/generated/fullScreen.glsl?raw';
import { testScene } from '../../fixtures/scenes.ts';
import probeWgsl from './generated/camera_probe.wgsl?raw';
import probeGlsl from './generated/cameraProbe.glsl?raw';
import { type GpuBackend, probeDevice, probePass } from './probe-device.ts';

const PROBE: PassSource = {
  label: 'camera probe',
  wgsl: { vertex: fullScreenWgsl, fragment: probeWgsl },
  entries: { vertex: 'fullScreen', fragment: 'cameraProbe' },
  glsl: { vertex: fullScreenGlsl, fragment: probeGlsl },
  bindings: [{ block: 'Frame' }],
  target: 'film',
  switches: ALL_SWITCHES,
};

/** For each pixel four numbers, row 0 first; camera-probe.wesl says of which ray. Positions are relative to the eye. */
export async function cameraRays(backend: GpuBackend, camera: Camera, width: number, height: number) {
  const device = await probeDevice(backend);
  const pass = await probePass(device, PROBE);
  const frame = device.createUniforms(structSize('Frame'));
  const film = device.createFilm(width, height);
  const block = createBlock(structSize('Frame'));
  const scene = testScene({}, {});
  const cast = async (sample: number): Promise<number[]> => {
    const settings = { maxReflections: 0, lightSamples: 1, maxDepth: -1, seed: 0, comparison: null };
    packFrame(block, { width, height }, camera, packScene(scene, camera.eye), settings, sample);
    frame.write(block.bytes);
    device.draw(pass, film, [frame], { width, height, firstRow: 0, rowCount: height });
    return Array.from(await device.read(film.layers[0]!, width, height));
  };
  const rays = { origins: await cast(0), directions: await cast(1) };
  for (const resource of [frame, film]) resource.destroy();
  return rays;
}
