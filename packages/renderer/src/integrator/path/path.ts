/** The path integrator as a stage: one call adds one film sample to every pixel, to the sums and to the sums of squares. */
import type {
  DataBuffer,
  Device,
  FilmTexture,
  FloatTexture,
  Pass,
  PassSource,
  Region,
  TableTexture,
  UniformBuffer,
} from '../../gpu/device.ts';
import { GEOMETRY, SCENE_TABLE, TEXELS } from '../../packed-scene/layout.ts';
import type { Feature } from '../../shading/features.ts';
import fullScreenWgsl from '../../shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../../shading/generated/fullScreen.glsl?raw';
import pathGlsl from '../../shading/generated/path.glsl?raw';
import pathWgsl from '../../shading/generated/path.wgsl?raw';
import { sourceFor } from '../../shading/program-text.ts';
import type { RelayWords } from './relay-room.ts';

/** Layers of the film that it needs. */
export const PATH_LAYERS = 2;

/**
 * Where a call may add many samples, groups of so many are rounded together, and it may touch so many groups at most, since all samples
 * are kept until they are added (path_entries.wesl). The film is the same however many it touches, but where one is cut.
 */
export const SAMPLES_OF_GROUP = 32;
export const MOST_GROUPS = 8;

/** How many groups these samples touch. */
export const groupsOf = (first: number, count: number): number =>
  Math.floor((first + count - 1) / SAMPLES_OF_GROUP) - Math.floor(first / SAMPLES_OF_GROUP) + 1;

const PATH: PassSource = {
  label: 'path',
  wgsl: { vertex: fullScreenWgsl, fragment: pathWgsl },
  entries: { vertex: 'fullScreen', fragment: 'path' },
  glsl: { vertex: fullScreenGlsl, fragment: pathGlsl },
  bindings: [
    { block: 'Frame' },
    SCENE_TABLE,
    { texture: 'previousFilm' },
    { texture: 'previousSquares' },
    { texture: 'environment' },
    GEOMETRY,
    TEXELS,
  ],
  target: 'film',
  compute: { wgsl: pathWgsl, entry: 'pathCompute', adding: 'addHanded' },
  layers: PATH_LAYERS,
};

export interface PathInputs {
  readonly frame: UniformBuffer;
  readonly sceneTable: TableTexture;
  /** The layers of the film so far. */
  readonly previous: readonly FloatTexture[];
  readonly environment: TableTexture;
  readonly geometry: DataBuffer;
  readonly texels: DataBuffer;
}

/** One film sample, as a program of several passes adds it. */
export interface RelaySample {
  readonly film: FilmTexture;
  readonly inputs: PathInputs;
  readonly words: RelayWords;
  readonly width: number;
  readonly height: number;
  /** Infinity: no limit. */
  readonly maxDepth: number;
  readonly rowsPerSubmit: () => number;
  /** Writes `frame.relayRow` for what is drawn next. */
  readonly takeRow: (row: number) => void;
  readonly unwanted: () => boolean;
  /** Called with the pixels of a submit that is done, and when it was begun. */
  readonly measured: (pixels: number, begun: number) => void;
}
/** A program of several passes, which sees itself to its draws. */
export interface RelayPass extends Pass {
  /** Resolves when the device is done: to false when it was given up, since `unwanted` said so. */
  addSample(sample: RelaySample): Promise<boolean>;
}
export const isRelay = (pass: Pass): pass is RelayPass => 'addSample' in pass;

/** A program for films that ask for no more than these features. */
export async function createPathPass(device: Device, features: ReadonlySet<Feature>): Promise<Pass> {
  return device.createPass(await sourceFor(PATH, 'path', features));
}

export function drawPath(device: Device, pass: Pass, film: FilmTexture, inputs: PathInputs, region: Region): void {
  device.draw(
    pass,
    film,
    [inputs.frame, inputs.sceneTable, ...inputs.previous, inputs.environment, inputs.geometry, inputs.texels],
    region,
  );
}
