/** Films of random scenes by one program, and by the passes of path_relay.wesl. */

import { openWebGl2 } from '../../../packages/renderer/src/gpu/webgl2/webgl2-device.ts';
import { GpuFilmTracer } from '../../../packages/renderer/src/headless/index.ts';
import { randomModelScene } from '../../fixtures/fuzz/random-models.ts';
import { tracerOfAll } from './tracers.ts';

const [WIDTH, HEIGHT] = [13, 11];

/** On a device that says that its compiler is slow. */
async function relayingTracer(): Promise<GpuFilmTracer> {
  const device = await openWebGl2(document.createElement('canvas'));
  (device.relay as { pays: boolean }).pays = true;
  return GpuFilmTracer.create(device, 'one');
}

export interface RelayedFilm {
  readonly index: number;
  /** Sums that are not the same to the bit, of all. */
  readonly different: number;
  readonly sums: number;
  readonly brightest: number;
}

export async function relayedFilms(
  seed: number,
  first: number,
  count: number,
  samples: number,
): Promise<RelayedFilm[]> {
  const films: RelayedFilm[] = [];
  const [whole, relaying] = [await tracerOfAll('webgl2'), await relayingTracer()];
  for (let index = first; index < first + count; index++) {
    const scene = randomModelScene(seed, index);
    const film = async (tracer: GpuFilmTracer) => {
      const settings = { ...scene.render, integrator: 'path', seed } as const;
      const area = { x: 2, y: 1, width: WIDTH, height: HEIGHT };
      await tracer.begin({ scene, settings, width: WIDTH + 4, height: HEIGHT + 3, area, squares: true });
      return tracer.trace(0, samples, null);
    };
    const [a, b] = [await film(whole), await film(relaying)];
    let different = 0;
    let brightest = 0;
    a.forEach((value, i) => {
      if (!Object.is(value, b[i])) different++;
      brightest = Math.max(brightest, value);
    });
    films.push({ index, different, sums: a.length, brightest });
  }
  relaying.dispose();
  return films;
}
