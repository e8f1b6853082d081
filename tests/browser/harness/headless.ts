import { addReferenceSample, type FilmJob, type FilmSums, referenceRows } from 'mirrorball/headless';
import type { GpuBackend } from './parity.ts';
import { sceneNamed } from './scenes.ts';
import { tracerOn } from './tracers.ts';

const WIDTH = 40;
const HEIGHT = 24;
const AREA = { x: 9, y: 5, width: 17, height: 11 };

/** More pixels than any device holds, and a part of them in a soft shadow, where each pixel has its own numbers. */
const HUGE = { width: 40_000, height: 30_000 };
const PENUMBRA = { x: 20_011, y: 25_007, width: 17, height: 11 };

/** How many values of two films differ, and by how much at most. */
function difference(a: FilmSums, b: FilmSums) {
  const all = Array.from(a, (value, i) => Math.abs(value - b[i]!));
  return { count: a.length === b.length ? all.filter((d) => d !== 0).length : -1, largest: Math.max(...all) };
}

function cut(film: FilmSums): FilmSums {
  const rows = Array.from({ length: AREA.height }, (_, row) => {
    const at = ((AREA.y + row) * WIDTH + AREA.x) * 4;
    return Array.from(film.subarray(at, at + AREA.width * 4));
  });
  return Float32Array.from(rows.flat());
}

/** Six samples of a picture traced at once, in two calls, for a part of it, and in two ranges apart. */
export async function headlessFilms(backend: GpuBackend) {
  const tracer = await tracerOn(backend);
  const settings = { integrator: 'classic', maxDepth: -1, maxReflections: 3, lightSamples: 4, seed: 5 } as const;
  const job = { scene: sceneNamed('cube-room'), settings, width: WIDTH, height: HEIGHT };
  await tracer.begin({ ...job, area: { x: 0, y: 0, width: WIDTH, height: HEIGHT } });
  const whole = await tracer.trace(0, 6, null);
  const resumed = await tracer.trace(2, 4, await tracer.trace(0, 2, null));
  const [first, last] = [await tracer.trace(0, 3, null), await tracer.trace(3, 3, null)];
  await tracer.begin({ ...job, area: AREA });
  const part = await tracer.trace(2, 4, await tracer.trace(0, 2, null));
  const huge = { ...job, ...HUGE, area: PENUMBRA };
  await tracer.begin(huge);
  const partOfHuge = await tracer.trace(0, 6, null);
  return {
    samples: whole[3],
    brightest: Math.max(...whole),
    resumed: difference(resumed, whole),
    part: difference(part, cut(whole)),
    ranges: difference(
      first.map((value, i) => value + last[i]!),
      whole,
    ),
    huge: { ...difference(partOfHuge, reference(huge, 6)), values: new Set(partOfHuge).size },
  };
}

function reference(job: FilmJob, samples: number): FilmSums {
  const rows = referenceRows(job);
  const film = new Float32Array(job.area.width * job.area.height * 4);
  for (let s = 0; s < samples; s++) addReferenceSample(film, rows(s, job.area.y, job.area.height), job);
  return film;
}
