import type { Page } from '@playwright/test';
import { backends, expect, test } from './fixtures.ts';
import { hookGpu, hooks } from './gpu-hooks.ts';

/** Meshes that skins, morph targets and nodes move. */
const openHarness = async (page: Page) => {
  await hookGpu(page);
  await page.goto(`${process.env.MIRRORBALL_ORIGIN}/tests/index.html`);
  await page.waitForFunction(() => window.harness !== undefined);
};

for (const backend of backends) {
  test(`a scene that has played is the scene at that time, bit for bit, and nothing is made for a frame (${backend})`, async ({
    page,
  }) => {
    await openHarness(page);
    const found = await page.evaluate((b) => window.harness.playedFilms(b, [0, 0.4, 0.8, 3.7, 1.1]), backend);
    for (const [name, { unlikeDirect, changed, counts }] of Object.entries(found)) {
      expect(unlikeDirect, `${name}: values that depend on what was shown before`).toBe(0);
      expect(Math.min(...changed), `${name}: moves`).toBeGreaterThan(0);
      expect(counts[1], `${name}: nothing is made for a frame`).toEqual(counts[0]);
    }
    // Nor by playing.
    for (const name of ['arm', 'dough', 'swarm']) {
      await page.evaluate(([b, n]) => window.harness.playFrames(b, n, 2), [backend, name] as const);
      const { compiled, buffers, textures } = await hooks(page);
      const times = await page.evaluate(([b, n]) => window.harness.playFrames(b, n, 12), [backend, name] as const);
      expect(new Set(times).size).toBe(12);
      expect(times, 'time goes on').toEqual([...times].sort((a, b) => a - b));
      expect(await hooks(page)).toMatchObject({ compiled, buffers, textures });
    }
    // A worker bends meshes of many triangles, and the picture may be of an earlier time; but of one.
    const late = await page.evaluate((b) => window.harness.playedLate(b), backend);
    expect(late).toEqual({ unlike: 0, workers: 1, ended: 1 });
  });

  test(`100 switches of scenes that move leave nothing behind (${backend})`, async ({ page }) => {
    test.setTimeout(300_000);
    await openHarness(page);
    const footprint = async (switches: number) => {
      const counts = await page.evaluate(([b, n]) => window.harness.switchMovingScenes(b, n), [backend, switches] as const); // biome-ignore format: one call
      const devtools = await page.context().newCDPSession(page);
      for (let i = 0; i < 3; i++) await devtools.send('HeapProfiler.collectGarbage');
      const { usedSize: heap } = await devtools.send('Runtime.getHeapUsage');
      await devtools.detach();
      const { buffers, textures, compiled } = await hooks(page);
      return { heap, counts, buffers, textures, compiled };
    };
    // So many that the browser has compiled what it is going to.
    const { heap, ...before } = await footprint(40);
    const after = await footprint(100);
    console.log(`  ${backend}: heap ${heap} → ${after.heap}`);
    expect(after).toMatchObject(before);
    expect(after.heap - heap, 'growth of the JS heap, bytes').toBeLessThan(500_000);
  });
}

/** Half a unit in the last place, relative. */
const ROUNDING = 2 ** -24;
/** How far from a vector its code of two numbers may be, radians: pack-vertices.ts. */
const CODED = 1.4e-4;

test('meshes bent by compute passes are those that the CPU bends, to rounding, in boxes that hold them', async ({
  harness,
}) => {
  const { scenes, films, left } = await harness.evaluate((times) => window.harness.bentByDevice(times), [0, 3.7, 1.1]); // biome-ignore format: one call
  for (const [name, found] of Object.entries(scenes)) {
    // A sum of eight products, four of such products and twelve numbers of targets; two more for magnitudes that cancel out.
    expect(found.places, `${name}: places`).toBeLessThan(2 * 24 * ROUNDING);
    expect(found.directions, `${name}: directions`).toBeLessThan(2 * CODED);
    expect(found.others, `${name}: other words`).toBe(0);
    // Boxes have room for the rounding of rays (PADDING of encode-wide-bvh.ts), and the greatest coordinate is that of a wider box.
    expect(found.outside, `${name}: outside of boxes`).toBeLessThan(-3e-7);
    expect(found.slack, `${name}: room in boxes`).toBeLessThan(4e-6);
    expect(found.cost, `${name}: what the tree costs`).toBeLessThan(1e-3);
    expect(found.unlikeDirect, `${name}: words that depend on what was shown before`).toBe(0);
  }
  expect(films.moves).toBeGreaterThan(0);
  expect(films).toMatchObject({ unlikeDirect: 0, unlikeHere: 0 });
  expect(left, 'buffers left behind').toBe(0);
});
