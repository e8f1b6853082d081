import type { Fuzzer } from './fuzzers.ts';
import { viteServer } from './vite-server.ts';

export async function openDawnFuzzer(): Promise<Fuzzer> {
  const server = await viteServer();
  const { openDawnTracer } = (await server.ssrLoadModule(
    '/scripts/fuzz/dawn-tracer.ts',
  )) as typeof import('./dawn-tracer.ts');
  const { tracer, fuzzScenes, leastOf } = await openDawnTracer();
  return {
    description: tracer.description,
    fuzz: (kind, seed, first, count) => fuzzScenes(tracer, kind, seed, first, count),
    least: (kind, seed, index) => leastOf(tracer, kind, seed, index),
    close: () => server.close(),
  };
}
