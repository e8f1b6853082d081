/** What traces random scenes: a headless Chromium on either backend, or the GPU of this machine through Dawn for Node. */
import { chromium } from '@playwright/test';
import { serveHarness } from '../../tests/browser/serve-harness.ts';
import type { BadScene, FuzzKind, FuzzReport } from '../../tests/fixtures/fuzz/fuzz.ts';
import { chromiumFlags } from '../chromium.mjs';
import { ensureChromium } from '../install-chromium.mjs';
import { openDawnFuzzer } from './dawn-fuzzer.ts';

export const FUZZ_BACKENDS = ['webgpu', 'webgl2', 'dawn'] as const;
export type FuzzBackend = (typeof FUZZ_BACKENDS)[number];

export interface Fuzzer {
  readonly description: string;
  fuzz(kind: FuzzKind, seed: number, first: number, count: number): Promise<FuzzReport>;
  least(kind: FuzzKind, seed: number, index: number): Promise<BadScene | null>;
  close(): Promise<void>;
}

/** A call that takes longer hangs, milliseconds: a path without an end, or a device that is gone. */
const LONGEST = 120_000;

function inTime<Result>(what: string, work: Promise<Result>): Promise<Result> {
  let timer: NodeJS.Timeout;
  const late = new Promise<never>((_, reject) => {
    timer = setTimeout(() => reject(new Error(`${what} took longer than ${LONGEST / 1000} s.`)), LONGEST);
  });
  return Promise.race([work, late]).finally(() => clearTimeout(timer));
}

async function openChromiumFuzzer(backend: 'webgpu' | 'webgl2'): Promise<Fuzzer> {
  const browser = await chromium.launch({ executablePath: await ensureChromium(), args: chromiumFlags });
  const server = await serveHarness();
  const page = await browser.newPage();
  await page.goto(`${server.origin}/tests/index.html`);
  await page.waitForFunction(() => window.harness !== undefined);
  return {
    description: `Chromium ${browser.version()}`,
    fuzz: (kind, seed, first, count) =>
      inTime(
        `Scenes ${first} to ${first + count - 1}`,
        page.evaluate(([b, k, s, f, n]) => window.harness.fuzz(b, k, s, f, n), [
          backend,
          kind,
          seed,
          first,
          count,
        ] as const),
      ),
    least: (kind, seed, index) =>
      inTime(
        `Cutting down scene ${index}`,
        page.evaluate(([b, k, s, i]) => window.harness.fuzzLeast(b, k, s, i), [backend, kind, seed, index] as const),
      ),
    close: async () => {
      await browser.close();
      await server.close();
    },
  };
}

export const openFuzzer = (backend: FuzzBackend): Promise<Fuzzer> =>
  backend === 'dawn' ? openDawnFuzzer() : openChromiumFuzzer(backend);
