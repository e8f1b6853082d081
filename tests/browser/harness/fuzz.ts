/** Random scenes by the path integrator: tests/fixtures/fuzz makes them, and says what is wrong with their films. */
import { type BadScene, type FuzzKind, type FuzzReport, fuzzScenes, leastOf } from '../../fixtures/fuzz/fuzz.ts';
import type { GpuBackend } from './parity.ts';
import { tracerOfAll } from './tracers.ts';

/** Traces `count` scenes from number `first` on. */
export async function fuzz(
  backend: GpuBackend,
  kind: FuzzKind,
  seed: number,
  first: number,
  count: number,
): Promise<FuzzReport> {
  return fuzzScenes(await tracerOfAll(backend), kind, seed, first, count);
}

export async function fuzzLeast(
  backend: GpuBackend,
  kind: FuzzKind,
  seed: number,
  index: number,
): Promise<BadScene | null> {
  return leastOf(await tracerOfAll(backend), kind, seed, index);
}
