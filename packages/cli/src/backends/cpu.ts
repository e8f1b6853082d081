/** The double-precision reference tracer on all cores: slow, and it needs nothing but Node. */
import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';
import {
  addReferenceSample,
  DeviceError,
  type FilmJob,
  type FilmSums,
  type FilmTracer,
  referenceLayers,
  type TraceOptions,
} from 'mirrorball/headless';
import { workerEntry } from '../entry.ts';
import type { RowsReply, RowsTask } from './cpu-worker.ts';

/** Stripes of a sample for each thread, so that none waits long for the last. */
const STRIPES = 4;

/** A sample whose stripes are coming in. */
interface Sample {
  readonly pixels: FilmSums;
  missing: number;
}

export const openCpu = (threads = availableParallelism()): FilmTracer => new CpuFilmTracer(threads);

/** The classic integrator does not look at the sky's map: no thread needs a copy of it. */
function withoutMap(job: FilmJob): FilmJob {
  const { map: _, image: __, ...sky } = job.scene.sky;
  return { ...job, scene: { ...job.scene, sky } };
}

class CpuFilmTracer implements FilmTracer {
  readonly description: string;
  readonly #threads: number;
  #workers: Worker[] = [];
  #job: FilmJob | null = null;

  constructor(threads: number) {
    this.#threads = threads;
    this.description = `reference tracer, double precision, ${threads} ${threads === 1 ? 'thread' : 'threads'}`;
  }

  async begin(job: FilmJob): Promise<void> {
    if (job.settings.integrator === 'path')
      throw new DeviceError('The CPU traces the classic integrator only; the path integrator needs a GPU or Chromium.');
    await this.dispose();
    this.#job = job;
    this.#workers = Array.from(
      { length: this.#threads },
      () => new Worker(workerEntry(), { workerData: withoutMap(job) }),
    );
  }

  trace(first: number, count: number, onto: FilmSums | null, options: TraceOptions = {}): Promise<FilmSums> {
    const { area } = this.#job!;
    const sums = onto?.slice() ?? new Float32Array(area.width * area.height * 4 * referenceLayers(this.#job!));
    return new Promise((resolve, reject) => {
      const run = new Run(this.#job!, this.#threads, first, count, sums);
      const finish = () => {
        options.signal?.removeEventListener('abort', finish);
        resolve(sums);
      };
      options.signal?.addEventListener('abort', finish);
      const next = (worker: Worker) => {
        const task = options.signal?.aborted ? null : run.nextTask();
        if (task) worker.postMessage(task);
      };
      for (const worker of this.#workers) {
        worker.removeAllListeners();
        worker.on('error', reject);
        worker.on('message', (reply: RowsReply) => {
          if (options.signal?.aborted || !run.owns(reply)) return;
          run.take(reply);
          options.onProgress?.(run.progress);
          if (run.done) finish();
          else next(worker);
        });
        next(worker);
      }
      if (options.signal?.aborted) finish();
    });
  }

  async dispose(): Promise<void> {
    const workers = this.#workers;
    this.#workers = [];
    for (const worker of workers) worker.removeAllListeners();
    await Promise.all(workers.map((worker) => worker.terminate()));
  }
}

/** One call of `trace`: hands out stripes of samples in order, and adds whole samples in order, as float32. */
class Run {
  /** Replies to earlier runs that were given up may still come in. */
  static #runs = 0;
  readonly #run = ++Run.#runs;
  readonly #sums: FilmSums;
  readonly #job: FilmJob;
  readonly #rows: number;
  readonly #stripes: number;
  readonly #first: number;
  readonly #count: number;
  readonly #samples = new Map<number, Sample>();
  #given = 0;
  #added = 0;

  constructor(job: FilmJob, threads: number, first: number, count: number, sums: FilmSums) {
    const { area } = job;
    this.#sums = sums;
    this.#job = job;
    this.#first = first;
    this.#count = count;
    this.#rows = Math.max(Math.ceil(area.height / (threads * STRIPES)), 1);
    this.#stripes = Math.ceil(area.height / this.#rows);
  }

  get done(): boolean {
    return this.#added === this.#count;
  }
  /** Whole samples, and what there is of the next one: others may have come before it, and wait. */
  get progress(): number {
    const next = this.#samples.get(this.#first + this.#added);
    return this.#added + (next ? 1 - next.missing / this.#stripes : 0);
  }
  owns = (reply: RowsReply): boolean => reply.run === this.#run;

  nextTask(): RowsTask | null {
    if (this.#given === this.#count * this.#stripes) return null;
    const sample = this.#first + Math.floor(this.#given / this.#stripes);
    const firstRow = (this.#given % this.#stripes) * this.#rows;
    this.#given++;
    const { y, height } = this.#job.area;
    const rowCount = Math.min(this.#rows, height - firstRow);
    return { run: this.#run, sample, firstRow: y + firstRow, rowCount };
  }

  take({ sample, firstRow, pixels }: RowsReply): void {
    let held = this.#samples.get(sample);
    if (!held) {
      held = { pixels: new Float32Array(this.#sums.length), missing: this.#stripes };
      this.#samples.set(sample, held);
    }
    const { y, width, height } = this.#job.area;
    const layers = referenceLayers(this.#job);
    const [whole, part] = [width * height * 4, pixels.length / layers];
    for (let layer = 0; layer < layers; layer++)
      held.pixels.set(pixels.subarray(layer * part, (layer + 1) * part), layer * whole + (firstRow - y) * width * 4);
    held.missing--;
    for (let next = this.#samples.get(this.#first + this.#added); next?.missing === 0; ) {
      addReferenceSample(this.#sums, next.pixels, this.#job);
      this.#samples.delete(this.#first + this.#added);
      this.#added++;
      next = this.#samples.get(this.#first + this.#added);
    }
  }
}
