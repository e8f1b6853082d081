/**
 * @param {readonly number[]} values
 * @returns {number} NaN when there is none
 */
export function median(values) {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  if (sorted.length === 0) return Number.NaN;
  const upper = /** @type {number} */ (sorted[middle]);
  return sorted.length % 2 === 1 ? upper : (upper + /** @type {number} */ (sorted[middle - 1])) / 2;
}

/**
 * "512 ms (480 – 601)": the median and the whole spread.
 * @param {readonly number[]} values
 * @param {string} unit
 * @param {number} [digits]
 */
export function withSpread(values, unit, digits = 0) {
  const known = values.filter(Number.isFinite);
  if (known.length === 0) return '–';
  const [low, high] = [Math.min(...known), Math.max(...known)];
  return `${median(known).toFixed(digits)}${unit} (${low.toFixed(digits)} – ${high.toFixed(digits)})`;
}

/**
 * @param {readonly string[]} head
 * @param {readonly (readonly string[])[]} rows
 */
export function markdownTable(head, rows) {
  const line = (/** @type {readonly string[]} */ cells) => `| ${cells.join(' | ')} |`;
  return [line(head), line(head.map(() => '---')), ...rows.map(line)].join('\n');
}
