/** `mirrorball bench`: how fast this machine traces, backend by backend. */
import { availableParallelism, cpus } from 'node:os';
import { builtInScenes } from 'mirrorball/built-in';
import { DeviceError, type FilmJob, type FilmTracer, raysPerPixel } from 'mirrorball/headless';
import { posedSceneAt, type Scene } from 'mirrorball/scene';
import { BACKENDS, type BackendName, type BenchOptions } from '../arguments.ts';
import { openNamed } from '../backends/open-backend.ts';
import { startClock } from '../clock.ts';
import { CommandError, EXIT } from '../exit-codes.ts';
import { listenForInterruption } from '../interruption.ts';
import type { Terminal } from '../terminal.ts';
import { version } from '../version.ts';

/** What is measured when no scene is named: closed room with mirrors, and all kinds of material. */
const USUAL_SCENES = ['cube-room', 'materials'];
const INTEGRATORS = ['classic', 'path'] as const;

/** One line of the table. */
interface Measurement {
  readonly backend: BackendName;
  readonly scene: string;
  readonly integrator: FilmJob['settings']['integrator'];
  /** A pixel, in the measured time. */
  readonly samples: number;
  readonly seconds: number;
  /** Of whole pixels. */
  readonly samplesPerSecond: number;
  /** Camera, mirror and shadow rays asked for; an upper bound, known of the classic integrator. */
  readonly raysPerSecond: number | null;
  /** From the order to the first sample in hand: programs that were not there yet are compiled in it. */
  readonly firstSampleSeconds: number;
}

export async function bench(options: BenchOptions, terminal: Terminal): Promise<void> {
  const names = options.backend === 'auto' ? BACKENDS.filter((name) => name !== 'cpu') : [options.backend];
  const cpu = cpus()[0]?.model.trim() ?? process.arch;
  const cores = availableParallelism();
  const { width, height } = options.size;
  terminal.event('system', { mirrorball: version, cpu, cores, platform: process.platform, width, height });
  terminal.result(`Mirrorball ${version} on ${cpu}, ${cores} cores; ${width} × ${height} pixels\n`);
  const interruption = listenForInterruption();
  const missing: string[] = [];
  let measured = 0;
  for (const name of names) {
    const tracer = await openNamed(name).catch((error: unknown) => {
      if (!(error instanceof DeviceError)) throw error;
      missing.push(`${name}: ${error.message}`);
      terminal.event('missing', { backend: name, reason: error.message });
      terminal.result(`${name}: ${error.message}\n`);
    });
    if (!tracer) continue;
    try {
      measured += await benchBackend(name, tracer, options, terminal, interruption.signal);
    } finally {
      await tracer.dispose();
    }
    interruption.check('What was measured stands above.');
  }
  if (measured === 0) throw new CommandError(EXIT.noDevice, `Nothing here can be measured. ${missing.join('; ')}`);
}

/** Gives the number of measurements. */
async function benchBackend(
  backend: BackendName,
  tracer: FilmTracer,
  options: BenchOptions,
  terminal: Terminal,
  interrupted: AbortSignal,
): Promise<number> {
  terminal.event('backend', { backend, description: tracer.description });
  terminal.result(`${backend}: ${tracer.description}`);
  terminal.result(
    row(['scene', 'integrator', 'samples a pixel', 'million samples/s', 'million rays/s', 'first sample']),
  );
  let measured = 0;
  for (const scene of options.scene ?? USUAL_SCENES)
    for (const integrator of INTEGRATORS) {
      // What the CPU cannot trace is no news.
      if (interrupted.aborted || (backend === 'cpu' && integrator === 'path')) continue;
      const found = await measure(tracer, jobOf(scene, integrator, options), options, interrupted);
      if (interrupted.aborted) continue;
      const measurement: Measurement = { backend, scene, integrator, ...found };
      terminal.event('measured', { ...measurement });
      terminal.result(told(measurement));
      measured++;
    }
  terminal.result('');
  return measured;
}

function jobOf(id: string, integrator: Measurement['integrator'], { size }: BenchOptions): FilmJob {
  const scene: Scene = builtInScenes.find((each) => each.id === id)!.scene;
  const { maxDepth, maxReflections, lightSamples } = scene.render;
  const settings = { integrator, maxDepth, maxReflections, lightSamples, seed: 0 };
  return { scene: posedSceneAt(scene, 0), settings, ...size, area: { x: 0, y: 0, ...size } };
}

type Found = Omit<Measurement, 'backend' | 'scene' | 'integrator'>;

/** The first sample apart, then as many as the time or `spp` allow. */
async function measure(
  tracer: FilmTracer,
  job: FilmJob,
  { spp, seconds: limit }: BenchOptions,
  interrupted: AbortSignal,
): Promise<Found> {
  const now = () => performance.now() / 1000;
  const ordered = now();
  await tracer.begin(job);
  const begun = now();
  await tracer.trace(0, 1, null, { signal: interrupted });
  const first = now();
  const clock = startClock(limit, interrupted);
  const sums = spp > 1 ? await tracer.trace(1, spp - 1, null, clock).finally(clock.stop) : null;
  const more = sums?.[3] ?? 0;
  // So slow that no second sample was ready in time: then the first one counts.
  const [samples, seconds] = more > 0 ? [more, now() - first] : [1, first - begun];
  const samplesPerSecond = (samples * job.width * job.height) / Math.max(seconds, 1e-6);
  const rays = job.settings.integrator === 'classic' ? raysPerPixel(job.scene, job.settings) : null;
  return {
    samples,
    seconds,
    samplesPerSecond,
    raysPerSecond: rays === null ? null : rays * samplesPerSecond,
    firstSampleSeconds: first - ordered,
  };
}

const WIDTHS = [16, 11, 16, 18, 15, 13];
/** Names to the left, numbers to the right. */
const row = (cells: readonly string[]): string =>
  `  ${cells.map((cell, i) => (i < 2 ? cell.padEnd(WIDTHS[i]!) : cell.padStart(WIDTHS[i]!))).join(' ')}`;

const told = ({ scene, integrator, samples, samplesPerSecond, raysPerSecond, firstSampleSeconds }: Measurement) =>
  row([
    scene,
    integrator,
    String(samples),
    (samplesPerSecond / 1e6).toPrecision(3),
    raysPerSecond === null ? '–' : `≤ ${(raysPerSecond / 1e6).toPrecision(3)}`,
    `${firstSampleSeconds.toFixed(2)} s`,
  ]);
