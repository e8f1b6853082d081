/** Traces films on a GPU device with the same stages that draw on a canvas. */
import { FrameController } from '../frame-controller.ts';
import { type Device, DeviceError } from '../gpu/device.ts';
import { MOST_GROUPS, SAMPLES_OF_GROUP } from '../integrator/path/path.ts';
import type { ProgramPlan } from '../integrator/path/path-programs.ts';
import { packHere } from '../packed-scene/geometry-packer.ts';
import { stillMoment } from '../scene/motion.ts';
import { Stages } from '../stages.ts';
import { DEFAULT_SETTINGS, raysPerPixel } from '../view.ts';
import {
  type BeginOptions,
  type FilmJob,
  type FilmSums,
  type FilmTracer,
  samplesIn,
  type TraceOptions,
} from './film-tracer.ts';

/** Films of 16-bit floats sum up fewer samples than this; places and numbers of shapes would not survive in them. */
const LEAST_FILM_SAMPLES = 1024;
/** As long a call may take if a group does not take longer, milliseconds: what is begun of it is lost when the work is to end early. */
const LONGEST_CALL = 500;
/** Calls that may wait on the device: it never idles, and an interruption is heard soon. */
const MOST_IN_FLIGHT = 4;

export class GpuFilmTracer implements FilmTracer {
  readonly #device: Device;
  readonly #stages: Stages;
  readonly #controller = new FrameController();
  /** Rejects when the device is lost: work on a lost device may never end by itself. */
  readonly #lost: Promise<never>;
  #job: FilmJob | null = null;
  #rays = 0;

  /**
   * Takes the device for good. Rejects with `DeviceError` when it cannot run the integrator. `programs`: of the path integrator.
   * `exact` ones trace fastest; `one` for everything suits many small films, each of another scene.
   */
  static async create(device: Device, programs: ProgramPlan = 'exact'): Promise<GpuFilmTracer> {
    const stages = await Stages.open(device, programs);
    return new GpuFilmTracer(device, stages);
  }

  private constructor(device: Device, stages: Stages) {
    this.#device = device;
    this.#stages = stages;
    this.#controller.watched = false;
    this.#lost = device.lost.then((reason) => {
      throw new DeviceError(`The graphics device was lost: ${reason}`);
    });
    this.#lost.catch(() => {}); // heard where something waits
  }

  get description(): string {
    return this.#device.description;
  }

  async begin(job: FilmJob, { onProgress }: BeginOptions = {}): Promise<void> {
    const { scene, settings, width, height, area, content: wanted = 'light' } = job;
    if (wanted !== 'light' && this.#device.maxFilmSamples < LEAST_FILM_SAMPLES)
      throw new DeviceError('This graphics device draws into 16-bit floats only, which cannot hold AOVs.');
    const content = wanted === 'light' ? settings.integrator : wanted;
    const rays = wanted === 'light' ? raysPerPixel(scene, settings) : 1;
    if (this.#rays > 0 && rays > this.#rays) this.#controller.workChanged(rays / this.#rays);
    this.#rays = rays;
    this.#job = job;
    const { film } = this.#stages;
    const subject = { content, scene, camera: scene.camera, settings: { ...DEFAULT_SETTINGS, ...settings } };
    await this.#orLost(this.#stages.ready(subject));
    // What has been packed is not packed again.
    await packHere(scene, onProgress);
    // The area alone: a part of a picture that is too large for the device is none.
    film.reserve(area.width, area.height, this.#stages.layersFor(subject));
    this.#stages.begin({ ...subject, ...stillMoment(scene), raysPerPixel: rays, area }, width, height);
  }

  async trace(first: number, count: number, onto: FilmSums | null, options: TraceOptions = {}): Promise<FilmSums> {
    const { area, squares, content = 'light' } = this.#job!;
    const pixels = area.width * area.height;
    const { film } = this.#stages;
    const counted = content !== 'data';
    const held = onto && counted ? samplesIn(onto, pixels) : 0;
    if (held + count > this.#device.maxFilmSamples)
      throw new RangeError(`This device sums up at most ${this.#device.maxFilmSamples} samples at once.`);
    film.resume(first, held, onto);
    await this.#orLost(this.#addSamples(count, held, options));
    const sums = await this.#orLost(film.readSums(squares || content !== 'light' ? 2 : 1));
    if (counted) samplesIn(sums, pixels, film.samples);
    return sums;
  }

  async #addSamples(count: number, held: number, { signal, onProgress }: TraceOptions): Promise<void> {
    const { film } = this.#stages;
    const inFlight: Promise<boolean>[] = [];
    const stopped = () => signal?.aborted === true;
    while (film.samples < held + count && !stopped()) {
      const most = Math.min(this.#samplesOfCall(film.nextSample), held + count - film.samples);
      const sample = this.#stages.addSamples(most, this.#controller, () => {}, stopped);
      sample.catch(() => {}); // awaited below, or not at all when an earlier one failed
      inFlight.push(sample);
      // A sample that takes several submits, or too many waiting: hear how the first of them went.
      while (inFlight.length > 0 && (this.#stages.pending || inFlight.length > MOST_IN_FLIGHT)) await inFlight.shift();
      onProgress?.(film.samples - held);
    }
    await Promise.all(inFlight);
  }

  /** How many from `next` on, up to the end of a group. */
  #samplesOfCall(next: number): number {
    if (!this.#stages.addsMany) return 1;
    const { width, height } = this.#job!.area;
    const { cost } = this.#controller;
    const samples = cost ? (LONGEST_CALL - cost.fixed) / (cost.perPixel * width * height) : 0;
    const groups = Math.min(Math.max(Math.floor(samples / SAMPLES_OF_GROUP), 1), MOST_GROUPS);
    return groups * SAMPLES_OF_GROUP - (next % SAMPLES_OF_GROUP);
  }

  #orLost<Result>(work: Promise<Result>): Promise<Result> {
    return Promise.race([work, this.#lost]);
  }

  dispose(): void {
    this.#device.destroy();
  }
}
