/** Films of random scenes by one program, and by the passes of path_relay.wesl. */
import type { GlslSource } from '../../../packages/renderer/src/gpu/device.ts';
import { openWebGl2 } from '../../../packages/renderer/src/gpu/webgl2/webgl2-device.ts';
import { type FilmTracer, GpuFilmTracer } from '../../../packages/renderer/src/headless/index.ts';
import type { Scene } from '../../../packages/renderer/src/scene/scene.ts';
import { randomModelScene } from '../../fixtures/fuzz/random-models.ts';
import { tracerOfAll } from './tracers.ts';

/** Part of a picture, of two stripes. */
const AREA = { x: 2, y: 1, width: 13, height: 11 };
const SAMPLES = 3;

export interface RelayedFilms {
  readonly films: readonly {
    readonly index: number;
    /** How many of the sums and sums of squares are not the same to the bit. */
    readonly different: number;
    readonly brightest: number;
  }[];
  /** What the second device was asked to compile for passes that keep words. */
  readonly passes: readonly string[];
}

/** Scenes from number 0 on. The film in passes is given up at once, and begun again. */
export async function relayedFilms(seed: number, count: number): Promise<RelayedFilms> {
  const whole = await tracerOfAll('webgl2');
  const device = await openWebGl2(document.createElement('canvas'));
  const passes: string[] = [];
  const { createPass } = device.relay!;
  Object.assign(device.relay!, {
    createPass: (source: GlslSource) => {
      passes.push(source.label);
      return createPass(source);
    },
  });
  const relaying = await GpuFilmTracer.create(device, 'relay');
  const films = [];
  for (let index = 0; index < count; index++) {
    const scene = randomModelScene(seed, index);
    await begin(whole, scene, seed);
    const one = await whole.trace(0, SAMPLES, null);
    await begin(relaying, scene, seed);
    const stop = new AbortController();
    const givenUp = relaying.trace(0, SAMPLES, null, { signal: stop.signal });
    stop.abort();
    const held = (await givenUp)[3]!;
    const other = await relaying.trace(held, SAMPLES - held, held > 0 ? await givenUp : null);
    const different = one.filter((value, i) => !Object.is(value, other[i])).length;
    films.push({ index, different, brightest: one.reduce((a, b) => Math.max(a, b)) });
  }
  relaying.dispose();
  return { films, passes };
}

function begin(tracer: FilmTracer, scene: Scene, seed: number): Promise<void> {
  const settings = { ...scene.render, integrator: 'path', seed } as const;
  const [width, height] = [AREA.width + 4, AREA.height + 3];
  return tracer.begin({ scene, settings, width, height, area: AREA, squares: true });
}
