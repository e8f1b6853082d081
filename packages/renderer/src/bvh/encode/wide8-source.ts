/** Reads what wide8.ts writes. */
import { addChild, type Children, type NodeSource } from '../trace/node-source.ts';
import { decodePlane, type Grid, gridAt } from './quantise.ts';
import { WIDTH, type Wide8Nodes, WORDS } from './wide8.ts';

const bitsIn = (n: number): number => (n === 0 ? 0 : (n & 1) + bitsIn(n >>> 1));

export function wide8Source({ words, order, stackSize }: Wide8Nodes): NodeSource {
  const bytes = new Uint8Array(words.buffer);
  const floats = new Float32Array(words.buffer);

  function addSlot(node: number, slot: number, grids: readonly Grid[], into: Children): void {
    const at = 4 * node * WORDS;
    const meta = bytes[at + 24 + slot]!;
    if (meta === 0) return;
    const plane = (k: number) => decodePlane(grids[k % 3]!, bytes[at + 32 + 8 * k + slot]!);
    const bounds = [0, 1, 2, 3, 4, 5].map(plane);
    const innerSlots = bytes[at + 15]!;
    if ((innerSlots >> slot) & 1) {
      const before = bitsIn(innerSlots & ((1 << ((meta & 31) - 24)) - 1));
      addChild(into, bounds, 0, words[node * WORDS + 4]! + before);
    } else addChild(into, bounds, bitsIn(meta >>> 5), words[node * WORDS + 5]! + (meta & 31));
  }

  return {
    root: 0,
    order,
    stackSize,
    readChildren(node, into) {
      const grids = [0, 1, 2].map((axis) =>
        gridAt(floats[node * WORDS + axis]!, bytes[4 * node * WORDS + 12 + axis]! - 127),
      );
      into.count = 0;
      for (let slot = 0; slot < WIDTH; slot++) addSlot(node, slot, grids, into);
    },
  };
}
