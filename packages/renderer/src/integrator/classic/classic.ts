/** The classic integrator as a stage: one call adds one film sample to every pixel. docs/classic.md defines it. */
import type { Device, FilmTexture, Pass, PassSource, Rows, TableTexture, UniformBuffer } from '../../gpu/device.ts';
import classicGlsl from '../../shading/generated/classic.glsl?raw';
import classicWgsl from '../../shading/generated/classic.wgsl?raw';
import fullScreenWgsl from '../../shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../../shading/generated/fullScreen.glsl?raw';

const SOURCE: PassSource = {
  label: 'classic',
  wgsl: { vertex: fullScreenWgsl, fragment: classicWgsl },
  entries: { vertex: 'fullScreen', fragment: 'classic' },
  glsl: { vertex: fullScreenGlsl, fragment: classicGlsl },
  bindings: [{ block: 'Frame' }, { texture: 'sceneTable' }, { texture: 'previousFilm' }],
  target: 'film',
};

export interface ClassicInputs {
  readonly frame: UniformBuffer;
  readonly sceneTable: TableTexture;
  readonly previousFilm: FilmTexture;
}

export function createClassicPass(device: Device): Promise<Pass> {
  return device.createPass(SOURCE);
}

export function drawClassic(device: Device, pass: Pass, film: FilmTexture, inputs: ClassicInputs, rows?: Rows): void {
  device.draw(pass, film, [inputs.frame, inputs.sceneTable, inputs.previousFilm], rows);
}
