/**
 * The classic integrator as a stage: one call adds one film sample to every pixel. docs/classic.md defines it. `preview` is the
 * same without mirrors and soft shadows, for the first picture while the whole is compiled.
 */
import type {
  Device,
  FilmTexture,
  FloatTexture,
  Pass,
  PassSource,
  Region,
  TableTexture,
  UniformBuffer,
} from '../../gpu/device.ts';
import { SCENE_TABLE } from '../../packed-scene/layout.ts';
import { ALL_SWITCHES } from '../../shading/features.ts';
import classicGlsl from '../../shading/generated/classic.glsl?raw';
import classicWgsl from '../../shading/generated/classic.wgsl?raw';
import fullScreenWgsl from '../../shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../../shading/generated/fullScreen.glsl?raw';
import previewGlsl from '../../shading/generated/preview.glsl?raw';
import previewWgsl from '../../shading/generated/preview.wgsl?raw';

const CLASSIC: PassSource = {
  label: 'classic',
  wgsl: { vertex: fullScreenWgsl, fragment: classicWgsl },
  entries: { vertex: 'fullScreen', fragment: 'classic' },
  glsl: { vertex: fullScreenGlsl, fragment: classicGlsl },
  bindings: [{ block: 'Frame' }, SCENE_TABLE, { texture: 'previousFilm' }],
  target: 'film',
  switches: ALL_SWITCHES,
};
const PREVIEW: PassSource = {
  ...CLASSIC,
  label: 'preview',
  wgsl: { vertex: fullScreenWgsl, fragment: previewWgsl },
  entries: { vertex: 'fullScreen', fragment: 'preview' },
  glsl: { vertex: fullScreenGlsl, fragment: previewGlsl },
};

export interface ClassicInputs {
  readonly frame: UniformBuffer;
  readonly sceneTable: TableTexture;
  /** The layers of the film so far. */
  readonly previous: readonly FloatTexture[];
}

export const createClassicPass = (device: Device): Promise<Pass> => device.createPass(CLASSIC);
export const createPreviewPass = (device: Device): Promise<Pass> => device.createPass(PREVIEW);

export function drawClassic(
  device: Device,
  pass: Pass,
  film: FilmTexture,
  inputs: ClassicInputs,
  region: Region,
): void {
  device.draw(pass, film, [inputs.frame, inputs.sceneTable, ...inputs.previous], region);
}
