/**
 * How uncertain a film with sums of squares still is, in one number: docs/path.md, "The error of a picture". A pass sums up a few
 * thousand cells of the film on the device, and only those are read back, by and by: no frame waits for them.
 */
import type { Device, FilmTexture, Pass, PassSource, UniformBuffer } from '../gpu/device.ts';
import { structSize } from '../packed-scene/layout.ts';
import { createBlock, writeStruct } from '../packed-scene/write-struct.ts';
import filmErrorWgsl from '../shading/generated/film_error.wgsl?raw';
import filmErrorGlsl from '../shading/generated/filmError.glsl?raw';
import fullScreenWgsl from '../shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../shading/generated/fullScreen.glsl?raw';

/** Along a side; as in film_error.wesl. */
const CELLS = 64;

const SOURCE: PassSource = {
  label: 'film error',
  wgsl: { vertex: fullScreenWgsl, fragment: filmErrorWgsl },
  entries: { vertex: 'fullScreen', fragment: 'filmError' },
  glsl: { vertex: fullScreenGlsl, fragment: filmErrorGlsl },
  bindings: [{ block: 'Display' }, { texture: 'film' }, { texture: 'filmSquares' }],
  target: 'film',
};

export class FilmError {
  readonly #device: Device;
  readonly #pass: Pass;
  readonly #uniforms: UniformBuffer;
  readonly #cells: FilmTexture;
  readonly #block = createBlock(structSize('Display'));

  static async create(device: Device): Promise<FilmError> {
    return new FilmError(device, await device.createPass(SOURCE));
  }

  private constructor(device: Device, pass: Pass) {
    this.#device = device;
    this.#pass = pass;
    this.#uniforms = device.createUniforms(structSize('Display'));
    this.#cells = device.createFilm(CELLS, CELLS);
  }

  /** Of the first width × height pixels of the film as it is now, at least two samples in each. */
  async measure({ layers }: FilmTexture, width: number, height: number): Promise<number | null> {
    writeStruct(this.#block, 'Display', 0, { filmSize: [width, height] });
    this.#uniforms.write(this.#block.bytes);
    const all = { width: CELLS, height: CELLS, firstRow: 0, rowCount: CELLS };
    this.#device.draw(this.#pass, this.#cells, [this.#uniforms, layers[0]!, layers[1]!], all);
    return relativeError(await this.#device.read(this.#cells.layers[0]!, CELLS, CELLS));
  }
}

/**
 * The root of the mean squared standard error, as a share of the mean radiance. Null for a black picture, and when light too bright
 * for the film's floats leaves no number.
 */
export function relativeError(cells: Float32Array): number | null {
  let [mean, squaredError, pixels] = [0, 0, 0];
  for (let i = 0; i < cells.length; i += 4) {
    mean += cells[i]!;
    squaredError += cells[i + 1]!;
    pixels += cells[i + 2]!;
  }
  const error = Math.sqrt(squaredError / pixels) / (mean / pixels);
  return Number.isFinite(mean) && Number.isFinite(error) ? error : null;
}
