import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';
import type { Fuzzer } from './fuzzers.ts';

/** Vite brings the shaders, which Node alone cannot import. */
export async function openDawnFuzzer(): Promise<Fuzzer> {
  const root = fileURLToPath(new URL('../..', import.meta.url));
  const server = await createServer({
    root,
    configFile: false,
    logLevel: 'warn',
    appType: 'custom',
    server: { middlewareMode: true, ws: false },
    optimizeDeps: { noDiscovery: true },
  });
  const { openDawnTracer } = (await server.ssrLoadModule(
    '/scripts/fuzz/dawn-tracer.ts',
  )) as typeof import('./dawn-tracer.ts');
  const { tracer, fuzzScenes, leastOf } = await openDawnTracer();
  return {
    description: tracer.description,
    fuzz: (seed, first, count) => fuzzScenes(tracer, seed, first, count),
    least: (seed, index) => leastOf(tracer, seed, index),
    close: () => server.close(),
  };
}
