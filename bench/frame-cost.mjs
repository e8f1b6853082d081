import { firstPicture, openProbed, SIZE, withBrowser } from './browser.mjs';
import { markdownTable, median, withSpread } from './statistics.mjs';

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {{ name: string, hits: number, page: Page, mirrorball: boolean, times: number[] }} Contestant */

const studio = `/index.html?size=${SIZE}&ui=0&paused=1&adaptive=0&scale=1`;
const HITS = [2, 10];

/**
 * Milliseconds for one picture of the same room, 512 × 512. All pages are open at once in one browser and are stepped
 * in turn in short slices, so that a busy machine slows all of them alike; ratios are taken within each round.
 * @param {{ chromium: string, origin: string, rounds: number, log: (line: string) => void }} options
 * @returns {Promise<string>} a Markdown table
 */
export function measureFrameCost({ chromium, origin, rounds, log }) {
  return withBrowser(chromium, async (browser) => {
    /** @type {Contestant[]} */
    const contestants = [];
    const enter = async (/** @type {string} */ name, /** @type {number} */ hits, /** @type {string} */ path) => {
      const page = await openProbed(browser, origin + path);
      const contestant = { name, hits, page, mirrorball: name.startsWith('Mirrorball'), times: [] };
      const ready = firstPicture(page).then(() => hold(contestant));
      await ready.then(
        () => contestants.push(contestant),
        (/** @type {Error} */ error) => log(`  ${name}: left out (${error.message.split('\n')[0]})`),
      );
    };
    for (const hits of HITS) {
      await enter('course-style page, WebGL2', hits, `/course-style/index.html?size=${SIZE}&hits=${hits}`);
      for (const [name, backend] of /** @type {const} */ ([
        ['WebGL2', 'webgl2'],
        ['WebGPU', 'webgpu'],
      ])) {
        await enter(`Mirrorball, ${name}`, hits, `${studio}&backend=${backend}`);
      }
    }
    const pictures = await readPictures(contestants);
    for (let round = 0; round < rounds; round++) {
      log(`  frame cost ${round + 1}/${rounds}`);
      for (let i = 0; i < contestants.length; i++) {
        const contestant = /** @type {Contestant} */ (contestants[(i + round) % contestants.length]);
        contestant.times.push(await slice(contestant));
      }
    }
    return table(contestants, pictures);
  });
}

/**
 * Stops the page's own frames, and gives Mirrorball the room.
 * @param {Contestant} contestant
 */
async function hold({ page, hits, mirrorball }) {
  if (mirrorball) {
    await page.evaluate(async (mirrorRays) => {
      const { renderer } = /** @type {any} */ (window).mirrorball;
      const room = await (await fetch('/rooms/baseline-room.scene.json')).json();
      await renderer.setScene(room);
      renderer.set({ maxReflections: mirrorRays, lightSamples: 9, exposure: 0, resolutionScale: 1, adaptive: false });
      const { camera } = room;
      let frame = 0;
      // A new view for each frame, as in the course-style page: nothing of the last one can be used again.
      /** @type {any} */ (window).drawFrame = () => {
        renderer.camera = { ...camera, eye: [0.02 * Math.sin(0.1 * frame++), camera.eye[1], camera.eye[2]] };
        return renderer.render();
      };
      renderer.stop();
      await renderer.render();
    }, hits - 1);
  } else await page.evaluate(() => /** @type {any} */ (window).benchProbe.hold());
}

/**
 * Some frames of one page; milliseconds for each whole picture, until the device has finished it.
 * @param {Contestant} contestant
 * @returns {Promise<number>}
 */
function slice({ page }) {
  return page.evaluate(async () => {
    const { benchProbe: probe, drawFrame } = /** @type {any} */ (window);
    const timed = async () => {
      const start = performance.now();
      await drawFrame();
      return performance.now() - start;
    };
    const one = drawFrame ? timed : () => probe.step(() => {});
    await one();
    let frames = 0;
    let elapsed = 0;
    while (frames < 2 || (elapsed < 600 && frames < 100)) {
      elapsed += await one();
      frames++;
    }
    return elapsed / frames;
  });
}

/**
 * The first frame of every page, all from the same place.
 * @param {readonly Contestant[]} contestants
 */
async function readPictures(contestants) {
  /** @type {Map<Contestant, Buffer>} */
  const pictures = new Map();
  for (const contestant of contestants) {
    const text = await contestant.page.evaluate(async (isMirrorball) => {
      const { benchProbe: probe, mirrorball } = /** @type {any} */ (window);
      if (!isMirrorball) {
        // The course-style page has drawn frames already and sways on, so the eye is put back where frame 0 has it.
        /** @type {any} */ (window).restartFrames();
        return probe.stepAndRead(() => {});
      }
      const { renderer } = mirrorball;
      renderer.camera = { ...renderer.scene.camera };
      await renderer.render();
      return probe.encode(await renderer.readFilm());
    }, contestant.mirrorball);
    pictures.set(contestant, Buffer.from(text, 'base64'));
  }
  return pictures;
}

/**
 * How much two pictures differ, in words.
 * @param {Buffer | undefined} a
 * @param {Buffer | undefined} b
 */
function compare(a, b) {
  if (!a || !b || a.length !== b.length || a.length === 0) return '–';
  let off = 0;
  let sum = 0;
  for (let i = 0; i < a.length; i++) {
    const gap = Math.abs(/** @type {number} */ (a[i]) - /** @type {number} */ (b[i]));
    sum += gap;
    if (gap > 2) off++;
  }
  return `mean ${(sum / a.length).toFixed(3)}/255, ${((off / a.length) * 100).toFixed(2)} % off by more than 2/255`;
}

/**
 * @param {readonly Contestant[]} contestants
 * @param {Map<Contestant, Buffer>} pictures
 */
function table(contestants, pictures) {
  const rows = contestants.map((contestant) => {
    const { name, hits, times, mirrorball } = contestant;
    const reference = contestants.find((other) => other.hits === hits && !other.mirrorball);
    const ratios = times.map((time, i) => time / (reference?.times[i] ?? Number.NaN));
    const equal = reference && mirrorball ? compare(pictures.get(contestant), pictures.get(reference)) : '';
    return [String(hits), name, withSpread(times, ' ms', 1), median(ratios).toFixed(2), equal];
  });
  const head = ['reflections', 'page', 'one picture: median (spread)', '÷ course-style', 'difference of the pictures'];
  return markdownTable(head, rows);
}
