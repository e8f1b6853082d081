/**
 * Films without a window: the seam between those who want samples (a command line, a test, a render farm) and what traces them.
 * A tracer adds film samples to sums that its caller keeps, so any range of samples and any part of the picture can be traced
 * anywhere and put together later.
 */
import type { FilmArea } from '../gpu/device.ts';
import type { AovContent } from '../integrator/aov/aov.ts';
import type { RendererSettings } from '../renderer-types.ts';
import type { Integrator, Scene } from '../scene/scene.ts';

export type { FilmArea } from '../gpu/device.ts';

/** `light`: what the integrator finds, the picture. Else what the camera sees first: integrator/aov/aov.ts. */
export type FilmContent = 'light' | AovContent;

/** Settings that a film's values depend on. */
export type FilmSettings = Pick<
  RendererSettings,
  'integrator' | 'maxDepth' | 'maxReflections' | 'lightSamples' | 'seed'
>;

/** What headless tracers can do in this version. */
export const HEADLESS_INTEGRATORS: readonly Integrator[] = ['classic', 'path'];

/** Everything that a film's values depend on, but which samples. Plain data that can be posted to a worker or a page. */
export interface FilmJob {
  /** Already animated to the time that is wanted. */
  readonly scene: Scene;
  readonly settings: FilmSettings;
  /** Of the whole picture, pixels. */
  readonly width: number;
  readonly height: number;
  /** The part of it that is traced; its values are those of the whole picture. */
  readonly area: FilmArea;
  /** Default: `light`. */
  readonly content?: FilmContent;
  /** `path` on a GPU: whether the sums of the samples' squares are wanted too. */
  readonly squares?: boolean;
}

/**
 * Sums of linear red, green, blue and the number of samples, float32, for each pixel of the area, row 0 on top; with
 * `squares` as many again follow: the sums of the samples' squares, and 0. Of `features`, sums of albedo and samples, then of
 * normal and hits; `data` are no sums, and have no number of samples: place and shape, then normal and closeness.
 */
export type FilmSums = Float32Array<ArrayBuffer>;

export interface TraceOptions {
  /** Ends the work early: `trace` then gives the sums of the samples that are whole. */
  readonly signal?: AbortSignal;
  /** Called with the number of samples that are done or on their way, whole ones and parts of one. */
  readonly onProgress?: (samples: number) => void;
}

export interface BeginOptions {
  /** Called with the share of the trees over meshes that are built, 0 … 1, when there are any to build. */
  readonly onProgress?: (built: number) => void;
}

export interface FilmTracer {
  /** What traces, in words. */
  readonly description: string;
  /** What to trace from now on. */
  begin(job: FilmJob, options?: BeginOptions): Promise<void>;
  /**
   * Adds the film samples `first` … `first + count − 1` in this order, in float32, to `onto` (to zero when null). Every pixel of
   * the result (but of `data`) has the same number of samples in its alpha. Traced in one call or several, on top of one another,
   * the sums are the same bit for bit; paths by a GPU that computes, if the calls begin at multiples of 32 samples, else to rounding.
   */
  trace(first: number, count: number, onto: FilmSums | null, options?: TraceOptions): Promise<FilmSums>;
  dispose(): void | Promise<void>;
}

/** The number of samples that the sums hold. Throws when pixels disagree: then the device has not done what it was asked for. */
export function samplesIn(sums: FilmSums, pixels: number, expected?: number): number {
  const samples = expected ?? sums[3]!;
  for (let i = 3; i < 4 * pixels; i += 4) {
    if (sums[i] === samples) continue;
    throw new Error(
      `A pixel holds ${sums[i]} samples where all should have ${samples}: the device has not drawn what it was asked for.`,
    );
  }
  return samples;
}
