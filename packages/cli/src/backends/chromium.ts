/**
 * A headless Chromium that holds the renderer in a page: for machines whose GPU Dawn for Node cannot reach, or that have a browser
 * and nothing else. The page is served by interception: an https address gives it WebGPU, and nothing goes to the network.
 */
import { existsSync, readFileSync } from 'node:fs';
import {
  type BeginOptions,
  DeviceError,
  type FilmJob,
  type FilmSums,
  type FilmTracer,
  type TraceOptions,
} from 'mirrorball/headless';
import type { Browser, Page } from 'playwright-core';
import { workerEntry } from '../entry.ts';
import { findChromium, HARDWARE_FLAGS, SOFTWARE_FLAGS } from './find-chromium.ts';
import { detachArrays, detachContents, kindOf } from './job-content.ts';

/** Numbers of a list that are sent at once. */
const PIECE = 2 ** 21;
const ADDRESS = 'https://mirrorball.invalid/';

/** The page's script, which the build puts beside the program. */
const pageScript = (): URL => new URL('chromium-page.js', workerEntry());

async function playwright() {
  try {
    return (await import('playwright-core')).chromium;
  } catch {
    throw new DeviceError('the package "playwright-core", which drives it, is not installed');
  }
}

export async function openChromium(): Promise<FilmTracer> {
  const driver = await playwright();
  const executablePath = findChromium(() => driver.executablePath());
  if (!executablePath) throw new DeviceError('no Chromium or Chrome was found (the variable CHROMIUM can name one)');
  if (!existsSync(pageScript())) throw new DeviceError('the page for it is not built: npm run build');
  const reasons: string[] = [];
  for (const args of [HARDWARE_FLAGS, SOFTWARE_FLAGS]) {
    const options = { executablePath, args, handleSIGINT: false, handleSIGTERM: false, handleSIGHUP: false };
    const browser = await driver.launch(options).catch((error: Error) => {
      throw new DeviceError(`${executablePath} does not start: ${error.message.split('\n')[0]}`);
    });
    try {
      return await openPage(browser);
    } catch (error) {
      await browser.close();
      reasons.push((error as Error).message.replace(/^page\.evaluate: /, '').split('\n')[0]!);
    }
  }
  throw new DeviceError(reasons.join('; '));
}

async function openPage(browser: Browser): Promise<FilmTracer> {
  const page = await browser.newPage();
  await page.route('**/*', (route) =>
    route.fulfill({ contentType: 'text/html', body: '<!doctype html><title>Mirrorball</title>' }),
  );
  await page.goto(ADDRESS);
  await page.evaluate(readFileSync(pageScript(), 'utf8'));
  const description = await page.evaluate(() => window.mirrorballPage.open());
  const tracer = new ChromiumFilmTracer(browser, page, `Chromium ${browser.version()}: ${description}`);
  await page.exposeFunction('mirrorballProgress', (samples: number) => tracer.progress(samples));
  await page.exposeFunction('mirrorballBuilt', (share: number) => tracer.built(share));
  return tracer;
}

class ChromiumFilmTracer implements FilmTracer {
  readonly description: string;
  readonly #browser: Browser;
  readonly #page: Page;
  readonly #gone: Promise<never>;
  /** Large parts of the scene that the page has, and the numbers that it knows them by. */
  #sent: ReadonlyMap<object, number> = new Map();
  #contents = 0;
  progress: (samples: number) => void = () => {};
  built: (share: number) => void = () => {};

  constructor(browser: Browser, page: Page, description: string) {
    this.#browser = browser;
    this.#page = page;
    this.description = description;
    this.#gone = new Promise((_, reject) => {
      page.on('crash', () => reject(new DeviceError('The page in Chromium crashed.')));
      browser.on('disconnected', () => reject(new DeviceError('Chromium ended.')));
    });
    this.#gone.catch(() => {}); // heard where something waits
  }

  async begin(job: FilmJob, { onProgress = () => {} }: BeginOptions = {}): Promise<void> {
    this.built = onProgress;
    const wanted = new Map<object, number>();
    const slim = detachContents(job, (content) => {
      const number = wanted.get(content) ?? this.#sent.get(content) ?? this.#contents++;
      wanted.set(content, number);
      return number;
    });
    const gone = [...this.#sent].filter(([content]) => !wanted.has(content)).map(([, number]) => number);
    await this.#orGone(this.#page.evaluate((given) => window.mirrorballPage.forget(given), gone));
    const before = this.#sent;
    this.#sent = wanted;
    for (const [content, number] of wanted) if (!before.has(content)) await this.#send(content, number);
    await this.#orGone(this.#page.evaluate((given) => window.mirrorballPage.begin(given), slim));
  }

  async #send(content: object, number: number): Promise<void> {
    const { frame, arrays } = detachArrays(content);
    const opened = { frame, number, arrays: arrays.map((array) => ({ kind: kindOf(array), length: array.length })) };
    await this.#orGone(this.#page.evaluate((given) => window.mirrorballPage.openContent(given), opened));
    for (const [index, array] of arrays.entries())
      for (let first = 0; first < array.length; first += PIECE) {
        const piece = { index, first, numbers: base64Of(array.subarray(first, first + PIECE)) };
        await this.#orGone(this.#page.evaluate((given) => window.mirrorballPage.addToContent(given), piece));
      }
  }

  async trace(first: number, count: number, onto: FilmSums | null, options: TraceOptions = {}): Promise<FilmSums> {
    const { signal, onProgress = () => {} } = options;
    this.progress = onProgress;
    const stop = () => void this.#page.evaluate(() => window.mirrorballPage.stop()).catch(() => {});
    signal?.addEventListener('abort', stop, { once: true });
    try {
      const task = { first, count, onto: onto && toBase64(onto), stopped: signal?.aborted === true };
      const sums = await this.#orGone(this.#page.evaluate((given) => window.mirrorballPage.trace(given), task));
      return fromBase64(sums);
    } finally {
      signal?.removeEventListener('abort', stop);
    }
  }

  #orGone<Result>(work: Promise<Result>): Promise<Result> {
    return Promise.race([work, this.#gone]);
  }

  async dispose(): Promise<void> {
    await this.#browser.close();
  }
}

const base64Of = ({ buffer, byteOffset, byteLength }: ArrayBufferView): string =>
  Buffer.from(buffer, byteOffset, byteLength).toString('base64');
const toBase64 = (sums: FilmSums): string => base64Of(sums);

const fromBase64 = (text: string): FilmSums => new Float32Array(new Uint8Array(Buffer.from(text, 'base64')).buffer);
