import { expect, test } from './fixtures.ts';
import { choose, coarse, fewSamples, settled, soon } from './studio.ts';

const SEED = 7;
const SCENES = 24;
const PASSES = ['begin', 'trace', 'light', 'scatter', 'end'];

test(`webgl2: paths in several passes make the same films to the bit, in ${SCENES} random scenes (seed ${SEED})`, async ({
  harness,
}) => {
  const { films, passes } = await harness.evaluate(([s, n]) => window.harness.relayedFilms(s, n), [
    SEED,
    SCENES,
  ] as const);
  expect(passes).toEqual(PASSES.map((part) => `path, ${part}`));
  for (const { index, different } of films) expect.soft(different, `sums of scene ${index}`).toBe(0);
  // Sums count samples too.
  const lit = films.filter(({ brightest }) => brightest > 3);
  expect(lit.length, 'scenes with light').toBeGreaterThan(SCENES / 4);
});

test('webgl2: a page whose compiler is slow draws in several passes until the whole program is there, and then goes on with it', async ({
  page,
  openStudio,
}) => {
  await page.addInitScript(slowCompiler);
  await openStudio({ backend: 'webgl2', query: { ...coarse, paused: 1 } });
  await fewSamples(page);
  const asked = () => page.evaluate(() => (window as unknown as SlowPage).asked);
  const film = () => page.evaluate(async () => Array.from((await window.mirrorball.renderer!.readFilm()).pixels));

  await page.evaluate(() => {
    const slow = window as unknown as SlowPage;
    const { device } = window.mirrorball.renderer as unknown as { device: Compiles };
    const createPass = device.createPass.bind(device);
    const released = new Promise<void>((resolve) => (slow.release = resolve));
    device.createPass = async (source) => {
      if (source.label === 'path') await released;
      const pass = await createPass(source);
      if (source.label === 'path') slow.whole++;
      return pass;
    };
  });
  await choose(page, 'Scene', 'Materials');
  await settled(page);
  const inPasses = await film();
  expect(await asked(), 'times that it was asked whether a path is left').toBeGreaterThan(0);

  await page.evaluate(() => (window as unknown as SlowPage).release());
  await soon(() => page.evaluate(() => (window as unknown as SlowPage).whole)).toBeGreaterThan(0);
  const before = await asked();
  await page.evaluate(() => window.mirrorball.renderer!.set({ seed: 8 }));
  await settled(page);
  expect(await asked(), 'and not any more').toBe(before);
  expect(await film()).toEqual(inPasses);
});

interface Compiles {
  createPass(source: { label: string }): Promise<unknown>;
}
interface SlowPage {
  /** Occlusion queries. */
  asked: number;
  /** Lets whole programs be compiled, and how many have been. */
  release: () => void;
  whole: number;
}

/** Runs in the page: it has a driver as on Windows, as far as its name goes. */
function slowCompiler(): void {
  const slow = window as unknown as SlowPage;
  slow.asked = 0;
  slow.whole = 0;
  const { getParameter, beginQuery } = WebGL2RenderingContext.prototype;
  Object.assign(WebGL2RenderingContext.prototype, {
    getParameter(this: WebGL2RenderingContext, name: number) {
      const value = getParameter.call(this, name);
      return typeof value === 'string' ? value.replace('SwiftShader driver', 'SwiftShader Direct3D11') : value;
    },
    beginQuery(this: WebGL2RenderingContext, ...query: Parameters<typeof beginQuery>) {
      slow.asked++;
      beginQuery.apply(this, query);
    },
  });
}
