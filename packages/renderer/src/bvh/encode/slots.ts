/** Which child lies in which of eight slots: Ylitie, Karras and Laine (2017), section 3.3, with a greedy assignment. */

/** Twice the centre of a box of six numbers from `at` on. */
const centre = (bounds: Float32Array, at: number, axis: number): number => bounds[at + axis]! + bounds[at + axis + 3]!;

/** How far each child lies from the node's middle in the direction of each slot, whose bits 2, 1, 0 are set for positive x, y, z. */
function reaches(bounds: Float32Array, node: number, children: readonly number[], table: Float64Array): void {
  for (let c = 0; c < children.length; c++) {
    const dx = centre(bounds, 6 * children[c]!, 0) - centre(bounds, 6 * node, 0);
    const dy = centre(bounds, 6 * children[c]!, 1) - centre(bounds, 6 * node, 1);
    const dz = centre(bounds, 6 * children[c]!, 2) - centre(bounds, 6 * node, 2);
    for (let slot = 0; slot < 8; slot++) {
      table[8 * c + slot] = (slot & 4 ? dx : -dx) + (slot & 2 ? dy : -dy) + (slot & 1 ? dz : -dz);
    }
  }
}

/** The place in the table of the best pair of a child and a slot that are both free. */
function bestFree(table: Float64Array, children: number, freeChildren: number, freeSlots: number): number {
  let best = -1;
  for (let place = 0; place < 8 * children; place++) {
    if (((freeChildren >> (place >> 3)) & (freeSlots >> (place & 7)) & 1) === 0) continue;
    if (best < 0 || table[place]! > table[best]!) best = place;
  }
  return best;
}

const table = new Float64Array(64);

/**
 * `children`: up to eight nodes below `node`, with boxes in `bounds`. Returns for each of eight slots which of them it has, −1 for none. The
 * pair of child and slot that fits best is taken first.
 */
export function assignSlots(bounds: Float32Array, node: number, children: readonly number[]): number[] {
  const slots = [-1, -1, -1, -1, -1, -1, -1, -1];
  reaches(bounds, node, children, table);
  let [freeChildren, freeSlots] = [(1 << children.length) - 1, 255];
  while (freeChildren !== 0) {
    const place = bestFree(table, children.length, freeChildren, freeSlots);
    slots[place & 7] = place >> 3;
    freeChildren &= ~(1 << (place >> 3));
    freeSlots &= ~(1 << (place & 7));
  }
  return slots;
}
