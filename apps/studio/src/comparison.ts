import type { Comparison, Panel } from 'mirrorball';

export type ComparisonMode = 'off' | 'reflections' | 'samples';
export const comparisonModes: readonly ComparisonMode[] = ['off', 'reflections', 'samples'];

/** What the three strips show, left to right. */
export const stripValues = { reflections: [1, 2, 10], samples: [1, 9, 64] } as const;

export type Dividers = readonly [number, number];

/** Least share of the width that a strip keeps. */
const MIN_STRIP = 0.02;

/** Parts the share of the picture that no panel covers in three. */
export function evenDividers(visibleShare: number): Dividers {
  return [visibleShare / 3, (visibleShare * 2) / 3];
}

/** The dividers as near to where they were put as what is visible allows: a panel must not hide them. */
export function fitDividers([first, second]: Dividers, visibleShare: number): Dividers {
  const most = Math.max(visibleShare - MIN_STRIP, 2 * MIN_STRIP);
  return [Math.min(first, most - MIN_STRIP), Math.min(second, most)];
}

/** Moves one divider; it stops at the other one and at the edges. */
export function moveDivider(dividers: Dividers, index: 0 | 1, to: number): Dividers {
  const [first, second] = dividers;
  if (index === 0) return [Math.min(Math.max(to, MIN_STRIP), second - MIN_STRIP), second];
  return [first, Math.max(Math.min(to, 1 - MIN_STRIP), first + MIN_STRIP)];
}

/** The renderer's setting for a comparison: what is not compared is the same in all strips. */
export function comparisonFor(mode: ComparisonMode, same: Panel, dividers: Dividers): Comparison | null {
  if (mode === 'off') return null;
  const strip = (value: number): Panel =>
    mode === 'reflections' ? { ...same, maxReflections: value } : { ...same, lightSamples: value };
  const [left, middle, right] = stripValues[mode];
  return { panels: [strip(left), strip(middle), strip(right)], dividers };
}
