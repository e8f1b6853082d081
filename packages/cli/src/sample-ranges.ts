/** Which samples a film holds: ranges of sample indices, both ends included, in rising order and apart. Pure. */
export interface SampleRange {
  readonly first: number;
  readonly last: number;
}

export const countOf = (ranges: readonly SampleRange[]): number =>
  ranges.reduce((sum, { first, last }) => sum + last - first + 1, 0);

/** The samples in both; null: none. */
export function overlap(a: readonly SampleRange[], b: readonly SampleRange[]): SampleRange | null {
  for (const p of a)
    for (const q of b) {
      const [first, last] = [Math.max(p.first, q.first), Math.min(p.last, q.last)];
      if (first <= last) return { first, last };
    }
  return null;
}

/** All samples of both, neighbours joined. They must not overlap: adding a sample twice would give a wrong picture. */
export function joinRanges(a: readonly SampleRange[], b: readonly SampleRange[]): SampleRange[] {
  const twice = overlap(a, b);
  if (twice) throw new RangeError(`Samples ${formatRanges([twice])} are there twice.`);
  const joined: SampleRange[] = [];
  for (const range of [...a, ...b].sort((p, q) => p.first - q.first)) {
    const before = joined.at(-1);
    if (before && before.last + 1 === range.first)
      joined[joined.length - 1] = { first: before.first, last: range.last };
    else joined.push(range);
  }
  return joined;
}

/** What is missing of `wanted`. */
export function missingFrom(wanted: SampleRange, held: readonly SampleRange[]): SampleRange[] {
  const missing: SampleRange[] = [];
  let next = wanted.first;
  for (const { first, last } of held) {
    if (first > next) missing.push({ first: next, last: Math.min(first - 1, wanted.last) });
    next = Math.max(next, last + 1);
    if (next > wanted.last) return missing;
  }
  missing.push({ first: next, last: wanted.last });
  return missing.filter(({ first, last }) => first <= last);
}

export const formatRanges = (ranges: readonly SampleRange[]): string =>
  ranges.map(({ first, last }) => (first === last ? `${first}` : `${first}-${last}`)).join(', ') || 'none';

/** What `formatRanges` writes; null when it is something else. */
export function readRanges(text: string): SampleRange[] | null {
  const ranges = text === 'none' ? [] : text.split(', ').map(readRange);
  const inOrder = ranges.every((range, i) => range !== null && range.first > (ranges[i - 1]?.last ?? -1));
  return inOrder ? (ranges as SampleRange[]) : null;
}

function readRange(text: string): SampleRange | null {
  const match = /^(\d{1,15})(?:-(\d{1,15}))?$/.exec(text);
  if (!match) return null;
  const [first, last] = [Number(match[1]), Number(match[2] ?? match[1])];
  return first <= last ? { first, last } : null;
}
