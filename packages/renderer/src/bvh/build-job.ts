/** A build as a row of messages, so that a worker and a page without workers do the same. */
import { buildInSteps } from './build-bvh.ts';
import type { Bvh, TriangleMesh } from './bvh.ts';
import { buildFastBvh } from './fast-tree.ts';
import type { SahOptions } from './split.ts';

/** Plain data that can be posted to a worker. */
export interface BuildJob {
  readonly mesh: TriangleMesh;
  readonly options?: SahOptions;
  /** Whether a fast tree is wanted first. */
  readonly fastFirst: boolean;
}

export interface BuildMessage {
  /** 0 … 1. */
  readonly done: number;
  /** The fast tree in the first message, the good one in the last, whose `done` is 1. */
  readonly bvh?: Bvh;
  /** What was wrong with the mesh, in the last message; then there is no tree. */
  readonly problem?: string;
}

/** The tree's messages; a RangeError of the builders becomes one too. */
export function* buildAndTell({ mesh, options, fastFirst }: BuildJob): Generator<BuildMessage, void, void> {
  try {
    if (fastFirst) {
      const leafSize = options?.maxLeafSize ?? options?.leafSize;
      yield { done: 0, bvh: buildFastBvh(mesh, leafSize === undefined ? {} : { leafSize }) };
    }
    const steps = buildInSteps(mesh, options);
    for (;;) {
      const { done, value } = steps.next();
      if (done) {
        yield { done: 1, bvh: value };
        return;
      }
      yield { done: value };
    }
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    yield { done: 1, problem: error.message };
  }
}
