/** One decision: split a node, and where, or make it a leaf. */

import { splitAtBest, weighBins } from './binned-split.ts';
import { DEFAULT_COSTS } from './bvh.ts';
import { splitFewAtBest, weighFew } from './exact-split.ts';
import { areaOfAll, prepareRange, widestSpread } from './split-range.ts';
import { FEW, type Workspace } from './workspace.ts';

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

const leafIsCheaper = (rules: SplitRules, count: number, area: number, splitCost: number): boolean =>
  count <= rules.maxLeafSize && rules.primitiveCost * (count * area - splitCost) <= rules.nodeCost * area;

/** All centres are the same: the middle of Morton's order is as good as any place. */
const halves = (rules: SplitRules, begin: number, end: number): number =>
  end - begin <= rules.maxLeafSize ? LEAF : (begin + end) >> 1;

/** Sorts `order` between begin and end into two parts and returns where the second begins; or LEAF. */
export function split(work: Workspace, boxes: Float32Array, begin: number, end: number, rules: SplitRules): number {
  const { best } = work;
  const count = end - begin;
  let stride = prepareRange(work, boxes, begin, end, false);
  if (count <= FEW) {
    weighFew(work, begin, end);
    if (leafIsCheaper(rules, count, best.area, best.cost)) return LEAF;
    return splitFewAtBest(work, begin, end);
  }
  if (widestSpread(work) === 0) return halves(rules, begin, end);
  weighBins(work, begin, end, stride);
  if (stride > 1 && areaOfAll(work, begin, end) > SAMPLE_MISSES * best.area) {
    stride = prepareRange(work, boxes, begin, end, true);
    weighBins(work, begin, end, stride);
  }
  if (leafIsCheaper(rules, count, best.area, best.cost)) return LEAF;
  return splitAtBest(work, begin, end);
}
