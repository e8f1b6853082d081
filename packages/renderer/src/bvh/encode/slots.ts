/** Which child lies in which of eight slots: Ylitie, Karras and Laine (2017), section 3.3, with a greedy assignment. */

const centre = (box: readonly number[], axis: number): number => (box[axis]! + box[axis + 3]!) / 2;

/** How far a child lies from the node's middle in the direction of a slot, whose bits 2, 1, 0 are set for positive x, y, z. */
function reach(node: readonly number[], child: readonly number[], slot: number): number {
  let sum = 0;
  for (let axis = 0; axis < 3; axis++) {
    const sign = (slot >> (2 - axis)) & 1 ? 1 : -1;
    sum += sign * (centre(child, axis) - centre(node, axis));
  }
  return sum;
}

/** Returns eight children, −1 where there is none. The pair of child and free slot that fits best is taken first. */
export function assignSlots(
  node: readonly number[],
  children: readonly number[],
  boxOf: (child: number) => readonly number[],
): number[] {
  const slots = new Array<number>(8).fill(-1);
  const pairs = children.flatMap((child) => {
    const box = boxOf(child);
    return slots.map((_, slot) => ({ child, slot, reach: reach(node, box, slot) }));
  });
  pairs.sort((a, b) => b.reach - a.reach || a.child - b.child || a.slot - b.slot);
  const placed = new Set<number>();
  for (const { child, slot } of pairs) {
    if (placed.has(child) || slots[slot]! >= 0) continue;
    slots[slot] = child;
    placed.add(child);
  }
  return slots;
}
