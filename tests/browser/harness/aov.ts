/** Films of what the camera sees first, on a GPU and in double precision, compared. */
import { addReferenceSample, type FilmContent, type FilmJob, type FilmSums, referenceRows } from 'mirrorball/headless';
import type { Integrator, Projection } from '../../../packages/renderer/src/scene/scene.ts';
import { aovScene } from '../../fixtures/aov-scene.ts';
import type { GpuBackend } from './parity.ts';
import { tracerOn } from './tracers.ts';

const WIDTH = 48;
const HEIGHT = 32;
const AREA = { x: 7, y: 3, width: 37, height: 26 };
const SAMPLES = 5;
/** Relative to values of about 1, such as a normal's, and beyond that to the value. */
const TOLERANCE = 1e-4;

export interface AovReport {
  readonly pixels: number;
  /** Pixels that lie off by more: where a ray just meets, or just misses, something. */
  readonly off: number;
  readonly examples: string[];
  /** Numbers of the shapes that the film has. */
  readonly ids: number[];
}

function reference(job: FilmJob): FilmSums {
  const rows = referenceRows(job);
  const film = new Float32Array(job.area.width * job.area.height * 8);
  for (let s = 0; s < SAMPLES; s++) addReferenceSample(film, rows(s, job.area.y, job.area.height), job);
  return film;
}

/** Which pictures. An equirectangular camera's rays are as exact as the GPU's sine: camera.spec.ts looks at them. */
const PICTURES: readonly (readonly [Integrator, Projection])[] = [
  ['path', 'perspective'],
  ['classic', 'perspective'],
  ['path', 'orthographic'],
];

/** Each film in two calls, the second one on top of the first. */
export async function aovFilms(backend: GpuBackend) {
  const tracer = await tracerOn(backend);
  const reports: Record<string, AovReport> = {};
  for (const [integrator, projection] of PICTURES)
    for (const content of ['features', 'data'] as const) {
      const scene = { ...aovScene, camera: { ...aovScene.camera, projection, viewHeight: 4 } };
      const settings = { integrator, maxDepth: -1, maxReflections: 3, lightSamples: 1, seed: 7 };
      const job: FilmJob = { scene, settings, width: WIDTH, height: HEIGHT, area: AREA, content };
      await tracer.begin(job);
      const film = await tracer.trace(2, SAMPLES - 2, await tracer.trace(0, 2, null));
      reports[`${integrator} ${projection} ${content}`] = report(film, reference(job), content);
    }
  return reports;
}

function report(film: FilmSums, expected: FilmSums, content: FilmContent): AovReport {
  const pixels = AREA.width * AREA.height;
  const examples: string[] = [];
  const ids = new Set<number>();
  let off = 0;
  for (let p = 0; p < pixels; p++) {
    const both = [film, expected].map((sums) =>
      [0, 1].flatMap((layer) => Array.from(sums.subarray((layer * pixels + p) * 4, (layer * pixels + p + 1) * 4))),
    );
    const [got, wanted] = both as [number[], number[]];
    if (content === 'data') ids.add(got[3]!);
    if (got.every((value, k) => Math.abs(value - wanted[k]!) <= TOLERANCE * Math.max(1, Math.abs(wanted[k]!))))
      continue;
    off++;
    if (examples.length < 3) examples.push(`pixel ${p}: ${got} instead of ${wanted}`);
  }
  return { pixels, off, examples, ids: [...ids].sort((a, b) => a - b) };
}
