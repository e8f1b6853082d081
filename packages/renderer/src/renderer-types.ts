import type { ViewName } from './display/views.ts';
import type { PixelFilter } from './packed-scene/pack-filter.ts';
import type { Preparation } from './packed-scene/pack-in-worker.ts';
import type { Camera, Integrator, Scene, ToneMapping } from './scene/scene.ts';

/** What draws: a GPU interface, or the double-precision tracer in a worker that makes one still picture. */
export type Backend = 'webgpu' | 'webgl2' | 'cpu';

/** Settings of one strip of the picture. */
export interface Panel {
  /** Mirror rays that may follow the camera ray, 0 … 64. */
  readonly maxReflections: number;
  /** Points on each light, 1 … 256; 1 = centre, 9 = the fixed grid, others stratified. */
  readonly lightSamples: number;
}
/** Three strips of one picture, left to right, parted by two dividers at these shares (0 … 1) of the width. */
export interface Comparison {
  readonly panels: readonly [Panel, Panel, Panel];
  readonly dividers: readonly [number, number];
}

/** Which part of the picture the camera looks into. What lies around that part shows more of the scene, and crops nothing. */
export interface Framing {
  /** Where the line of sight meets the picture, in shares of its width and height from the top left. */
  readonly center: readonly [x: number, y: number];
  /** Share of the picture's height that the camera's field of view spans. */
  readonly height: number;
}

/** Everything that may change from frame to frame without touching the scene. Changing any of it compiles nothing. */
export interface RendererSettings {
  integrator: Integrator;
  /** What is shown: the picture, or what is known of each pixel, docs/aov.md. The CPU shows the picture only. */
  view: ViewName;
  /** `path`: segments of a path from the camera on, 1 … 4096; −1 = no limit. */
  maxDepth: number;
  /** `path`: how the samples of a pixel are weighted about its centre; all but `box` also reach into its neighbours. */
  pixelFilter: PixelFilter;
  /** `path`: plain random numbers instead of the Sobol sequence, to compare with. */
  independentSamples: boolean;
  maxReflections: number;
  lightSamples: number;
  /** Stops. */
  exposure: number;
  /** How bright light is fitted to the screen, after exposure. */
  toneMapping: ToneMapping;
  /** Film pixels per canvas pixel along one side, 0.1 … 1; the controller may go lower in motion, never higher. */
  resolutionScale: number;
  /** Whether the frame-time controller may lower resolution in motion to hold `targetFps`. */
  adaptive: boolean;
  targetFps: 30 | 60;
  /** Film samples a pixel after which a still picture stops to be refined. */
  maxSamples: number;
  seed: number;
  comparison: Comparison | null;
  /** Null: the whole picture, as the camera says. */
  framing: Framing | null;
}

/** Figures of the last drawn frame; what is measured in time is averaged over the frames of the last second. */
export interface FrameStats {
  readonly backend: Backend;
  /** Frames drawn per second. 0 while nothing needs drawing. */
  readonly fps: number;
  /** Milliseconds the device took for a frame. */
  readonly frameMs: number;
  /** Film samples accumulated in each pixel. */
  readonly samples: number;
  /**
   * Estimated error of the picture as a share of its brightness, of a recent number of samples: 0.02 is 2 %. What it means exactly is
   * said in docs/path.md, "The error of a picture". Null where it is not known: without `path`, in other views, before two samples.
   */
  readonly relativeError: number | null;
  /** Seconds that the device has worked on the film so far. */
  readonly filmSeconds: number;
  /** Million rays in a second of the device's work: camera, mirror and shadow rays asked for; an upper bound as rays may end early. */
  readonly mraysPerSecond: number;
  readonly filmWidth: number;
  readonly filmHeight: number;
  readonly canvasWidth: number;
  readonly canvasHeight: number;
  /** Scene time, seconds. */
  readonly time: number;
}

export interface RendererOptions {
  /** 'auto' (default): WebGPU, else WebGL2, else CPU. A named one: that or a `DeviceError`. */
  backend?: Backend | 'auto';
  settings?: Partial<RendererSettings>;
  /** Called after each drawn frame. */
  onFrame?: (stats: FrameStats) => void;
  /** Called when the device is lost ('lost'), back ('restored'), or gone for good ('failed'). */
  onDevice?: (event: 'lost' | 'restored' | 'failed', reason: string) => void;
}

/** What `readFilm` gives. */
export interface ShownFilm {
  /** What it is of. */
  readonly view: ViewName;
  readonly width: number;
  readonly height: number;
  /**
   * Four numbers a pixel, row 0 on top, the last of them the number of samples. Of the picture mean radiance, linear RGB. Of another view
   * its values as docs/aov.md says: three, or one and two zeros; places in metres of the world, normals between −1 and 1.
   */
  readonly pixels: Float32Array;
}

/** The public face of Mirrorball. All units as in `Scene`: metres, seconds, degrees, stops, linear Rec.709. */
export interface Renderer {
  readonly backend: Backend;
  readonly canvas: HTMLCanvasElement;
  readonly settings: Readonly<RendererSettings>;
  /**
   * What really draws the picture: `settings.integrator`, but on the CPU always 'classic', which knows no indirect light, no lens and no
   * materials but matte ones and mirrors.
   */
  readonly drawnBy: Integrator;
  readonly stats: FrameStats;
  /** Whether the picture waits for its program; until then a coarser one, a sketch or the one before is shown. */
  readonly compiling: boolean;
  readonly scene: Scene | null;
  /** The camera in use: the scene's own, possibly animated, until it is set; `resetCamera` goes back to the scene's. */
  camera: Camera;
  resetCamera(): void;
  /**
   * Does ahead what takes long before a scene can be shown: trees over its meshes, in a worker. Rejects as `setScene` would, and with the
   * signal's reason when that is aborted. What was prepared stays so as long as the meshes exist.
   */
  prepare(scene: Scene, preparation?: Preparation): Promise<void>;
  /**
   * Shows this scene from now on, at time 0 with the scene's own render settings. A scene that is not prepared is prepared first, and until then
   * the one before stays. Resolves when its first frame is drawn (or at once when stopped), or when another scene has been given meanwhile.
   */
  setScene(scene: Scene): Promise<void>;
  set(settings: Partial<RendererSettings>): void;
  /** Draws from now on, one frame per animation frame while something changes or refines. */
  start(): void;
  stop(): void;
  readonly running: boolean;
  /** Scene time, seconds. Setting it restarts accumulation. */
  time: number;
  playing: boolean;
  /** Scene seconds per second. */
  speed: number;
  /** Draws one frame now and resolves when the device has finished it. */
  render(): Promise<void>;
  /** The film of `settings.view`, before exposure and tone mapping; draws a frame of it first where there is none. The CPU has the picture only. */
  readFilm(): Promise<ShownFilm>;
  dispose(): void;
}
