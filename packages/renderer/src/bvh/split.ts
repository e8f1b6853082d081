/** One decision: split a node, and where, or make it a leaf. */

import { splitAtBest, weighBins } from './binned-split.ts';
import { DEFAULT_COSTS } from './bvh.ts';
import { splitFewAtBest, weighFew, weighTwo } from './exact-split.ts';
import { areaOfAll, prepareRange, widestSpread } from './split-range.ts';
import type { Workspace } from './workspace.ts';

export interface SahOptions {
  /** Nodes of so many primitives or fewer are not split. Default 1. */
  readonly leafSize?: number;
  /** Nodes of more are always split; between the two the costs decide. Default 4. */
  readonly maxLeafSize?: number;
  /** Default 64. Nodes from which only halving in the middle keeps to it are halved. */
  readonly maxDepth?: number;
  /** As in `TraceCosts`, by default `DEFAULT_COSTS`. */
  readonly nodeCost?: number;
  readonly primitiveCost?: number;
}

export type SplitRules = Required<SahOptions>;

export const splitRules = (options: SahOptions = {}): SplitRules => {
  const {
    leafSize = 1,
    maxDepth = 64,
    nodeCost = DEFAULT_COSTS.node,
    primitiveCost = DEFAULT_COSTS.primitive,
  } = options;
  const { maxLeafSize = Math.max(leafSize, 4) } = options;
  return { leafSize, maxLeafSize, maxDepth, nodeCost, primitiveCost };
};

export const LEAF = -1;

/** The box of the sample may be this much smaller than that of all: else something large or far away was left out. */
const SAMPLE_MISSES = 1.25;

function leafIsCheaper(work: Workspace, rules: SplitRules, primitives: number): boolean {
  const { area, cost } = work.best;
  return primitives > 0 && rules.primitiveCost * (primitives * area - cost) <= rules.nodeCost * area;
}

/**
 * Sorts the items in `order` from begin to end into two parts and returns where the second begins; or LEAF. `primitives` is how
 * many a leaf would have, or 0 when there may be no leaf.
 */
export function split(work: Workspace, begin: number, end: number, rules: SplitRules, primitives: number): number {
  const { best } = work;
  const count = end - begin;
  if (count === 2) {
    if (primitives === 0) return begin + 1;
    weighTwo(work, begin);
    return leafIsCheaper(work, rules, primitives) ? LEAF : begin + 1;
  }
  let stride = prepareRange(work, begin, end, false);
  // All centres are the same: the middle of Morton's order is as good as any place.
  if (widestSpread(work) === 0) return primitives > 0 ? LEAF : (begin + end) >> 1;
  if (count <= work.care.few) {
    weighFew(work, begin, end);
    if (leafIsCheaper(work, rules, primitives)) return LEAF;
    return splitFewAtBest(work, begin, end);
  }
  weighBins(work, begin, end, stride);
  if (stride > 1 && areaOfAll(work, begin, end) > SAMPLE_MISSES * best.area) {
    stride = prepareRange(work, begin, end, true);
    weighBins(work, begin, end, stride);
  }
  if (leafIsCheaper(work, rules, primitives)) return LEAF;
  return splitAtBest(work, begin, end);
}
