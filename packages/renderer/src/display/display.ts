/** The film on the canvas: mean, exposure, tone mapping, sRGB curve. */
import type { Device, FloatTexture, Pass, PassSource, UniformBuffer } from '../gpu/device.ts';
import { structSize } from '../packed-scene/layout.ts';
import { createBlock, writeStruct } from '../packed-scene/write-struct.ts';
import type { RendererSettings } from '../renderer-types.ts';
import { TONE_MAPPINGS } from '../scene/tone-mappings.ts';
import displayWgsl from '../shading/generated/display.wgsl?raw';
import screenGlsl from '../shading/generated/screen.glsl?raw';
import showGlsl from '../shading/generated/show.glsl?raw';
import showMappedGlsl from '../shading/generated/showMapped.glsl?raw';

const SOURCE: PassSource = {
  label: 'display',
  wgsl: { vertex: displayWgsl, fragment: displayWgsl },
  entries: { vertex: 'screen', fragment: 'show' },
  glsl: { vertex: screenGlsl, fragment: showGlsl },
  bindings: [{ block: 'Display' }, { texture: 'film' }],
  target: 'canvas',
};

/** The same with tone mapping: display.wesl says why it is apart. */
const MAPPED: PassSource = {
  ...SOURCE,
  entries: { vertex: 'screen', fragment: 'showMapped' },
  glsl: { vertex: screenGlsl, fragment: showMappedGlsl },
};

/** The settings that only the display uses. */
export type Look = Pick<RendererSettings, 'exposure' | 'toneMapping'>;

export class Display {
  readonly #device: Device;
  readonly #clipped: Pass;
  #mapped: Pass | null = null;
  readonly #uniforms: UniformBuffer;
  readonly #block = createBlock(structSize('Display'));

  static async create(device: Device): Promise<Display> {
    return new Display(device, await device.createPass(SOURCE));
  }

  private constructor(device: Device, clipped: Pass) {
    this.#device = device;
    this.#clipped = clipped;
    this.#uniforms = device.createUniforms(structSize('Display'));
  }

  /** Compiles tone mapping, whether it is wished for now or not. Before that pictures are clipped: those of the preview, at most. */
  async ready(): Promise<void> {
    this.#mapped ??= await this.#device.createPass(MAPPED);
  }

  /** Fills the canvas with the first width × height pixels of the film. */
  show(film: FloatTexture, width: number, height: number, { exposure, toneMapping }: Look): void {
    writeStruct(this.#block, 'Display', 0, {
      exposure: 2 ** exposure,
      toneMapping: TONE_MAPPINGS.indexOf(toneMapping),
      filmSize: [width, height],
    });
    this.#uniforms.write(this.#block.bytes);
    const pass = toneMapping === 'none' ? this.#clipped : (this.#mapped ?? this.#clipped);
    this.#device.draw(pass, 'canvas', [this.#uniforms, film]);
  }
}
