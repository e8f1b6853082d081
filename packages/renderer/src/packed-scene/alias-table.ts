/**
 * Choosing one of many in proportion to their weights with one look into a table: Walker, "An Efficient Method for Generating
 * Discrete Random Variables with General Distributions", 1977, built in one pass as in Vose, "A Linear Algorithm for Generating
 * Random Numbers with a Given Distribution", 1991. Column i is taken with probability 1 / n and gives i itself with probability
 * `own[i]`, else `other[i]`.
 */
export interface AliasTable {
  readonly own: Float64Array;
  readonly other: Uint32Array;
}

export function sumOf(values: Float64Array): number {
  let sum = 0;
  for (let i = 0; i < values.length; i++) sum += values[i]!;
  return sum;
}

/** Weights are finite and not negative, and at least one is positive. */
export function aliasTable(weights: Float64Array): AliasTable {
  const n = weights.length;
  const scale = n / sumOf(weights);
  const own = new Float64Array(n);
  const other = new Uint32Array(n);
  let heaviest = 0;
  for (let i = 0; i < n; i++) {
    own[i] = weights[i]! * scale;
    other[i] = i;
    if (weights[i]! > weights[heaviest]!) heaviest = i;
  }
  // Two stacks in one array, poor columns from its start and rich ones from its end.
  const stacks = new Uint32Array(n);
  let [poor, rich] = [0, n];
  for (let i = 0; i < n; i++) stacks[own[i]! < 1 ? poor++ : --rich] = i;
  while (poor > 0 && rich < n) {
    const low = stacks[--poor]!;
    const high = stacks[rich]!;
    other[low] = high;
    own[high] = own[high]! + own[low]! - 1;
    if (own[high]! >= 1) continue;
    rich++;
    stacks[poor++] = high;
  }
  // What is left over is full, up to rounding; a weight of 0 stays out.
  const settle = (i: number) => {
    if (weights[i]! > 0) own[i] = 1;
    else [own[i], other[i]] = [0, heaviest];
  };
  for (let k = 0; k < poor; k++) settle(stacks[k]!);
  for (let k = rich; k < n; k++) settle(stacks[k]!);
  return { own, other };
}
