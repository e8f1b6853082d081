/** A layer of what the camera sees first on the canvas. */
import type { Device, FilmTexture, Pass, PassSource, TableTexture, UniformBuffer } from '../gpu/device.ts';
import { aovIds } from '../integrator/aov/aov-ids.ts';
import { structSize } from '../packed-scene/layout.ts';
import { createBlock, writeStruct } from '../packed-scene/write-struct.ts';
import { cameraAxes } from '../scene/camera.ts';
import { SCENE_LIMITS } from '../scene/limits.ts';
import type { Camera, Integrator, Scene } from '../scene/scene.ts';
import aovViewWgsl from '../shading/generated/aov_view.wgsl?raw';
import displayWgsl from '../shading/generated/display.wgsl?raw';
import screenGlsl from '../shading/generated/screen.glsl?raw';
import showAovGlsl from '../shading/generated/showAov.glsl?raw';
import { colorOfName } from './number-colors.ts';
import { AOV_VIEWS, type AovViewName, type AovViewSource } from './views.ts';

const SOURCE: PassSource = {
  label: 'aov view',
  wgsl: { vertex: displayWgsl, fragment: aovViewWgsl },
  entries: { vertex: 'screen', fragment: 'showAov' },
  glsl: { vertex: screenGlsl, fragment: showAovGlsl },
  bindings: [{ block: 'AovView' }, { texture: 'film' }, { texture: 'numberColors' }],
  target: 'canvas',
};

const KINDS: readonly AovViewSource['kind'][] = ['colour', 'normal', 'depth', 'place', 'number'];
/** Shapes that there can be, lamps too, and nothing. */
const MOST_NUMBERS =
  1 + SCENE_LIMITS.sphere + SCENE_LIMITS.box + SCENE_LIMITS.plane + SCENE_LIMITS.quad + SCENE_LIMITS.surfaceLight;

/** What is looked at, and how. */
export interface Sight {
  readonly view: AovViewName;
  readonly scene: Scene;
  readonly camera: Camera;
  readonly integrator: Integrator;
}

export class AovDisplay {
  readonly #device: Device;
  readonly #pass: Pass;
  readonly #uniforms: UniformBuffer;
  readonly #colors: TableTexture;
  readonly #block = createBlock(structSize('AovView'));
  #colored: Sight | null = null;

  static async create(device: Device): Promise<AovDisplay> {
    return new AovDisplay(device, await device.createPass(SOURCE));
  }

  private constructor(device: Device, pass: Pass) {
    this.#device = device;
    this.#pass = pass;
    this.#uniforms = device.createUniforms(structSize('AovView'));
    this.#colors = device.createTable(MOST_NUMBERS, 1);
  }

  /** Fills the canvas with the first width × height pixels of the film, which holds what `sight.view` is taken from. */
  show(film: FilmTexture, width: number, height: number, sight: Sight): void {
    const { kind, layer } = AOV_VIEWS[sight.view];
    if (kind === 'number' && this.#colored !== sight) this.#color(sight);
    const { eye, target, projection } = sight.camera;
    const toTarget = [target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]];
    writeStruct(this.#block, 'AovView', 0, {
      kind: KINDS.indexOf(kind),
      scale: Math.hypot(...toTarget),
      filmSize: [width, height],
      forward: projection === 'equirectangular' ? [0, 0, 0] : cameraAxes(sight.camera).forward,
      middle: toTarget,
    });
    this.#uniforms.write(this.#block.bytes);
    this.#device.draw(this.#pass, 'canvas', [this.#uniforms, film.layers[layer]!, this.#colors]);
  }

  #color(sight: Sight): void {
    const { primitives, materials, materialOf } = aovIds(sight.scene, sight.integrator);
    const texels = new Float32Array(MOST_NUMBERS * 4);
    primitives.forEach((name, id) => {
      const told = sight.view === 'material-id' ? materials[materialOf[id]!] : name;
      if (told) texels.set(colorOfName(told), id * 4);
    });
    this.#colors.write(texels, 1);
    this.#colored = sight;
  }
}
