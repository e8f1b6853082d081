/**
 * How encodings name a child in 32 bits. Inner node: its number, which is never 0, as the root is nobody's child. Leaf: bit 31,
 * then four bits with the number of its primitives − 1, then 27 bits with its first place in the order. No child at all: 0.
 */
export const NO_CHILD = 0;

const MOST_PRIMITIVES = 16;
const PLACES = 2 ** 27;

export function leafReference(first: number, count: number): number {
  if (count < 1 || count > MOST_PRIMITIVES) {
    throw new RangeError(`A leaf has ${count} primitives; this encoding holds 1 to ${MOST_PRIMITIVES}`);
  }
  if (first >= PLACES) throw new RangeError(`A leaf begins at place ${first}; this encoding ends at ${PLACES - 1}`);
  return (0x80000000 | ((count - 1) << 27) | first) >>> 0;
}

export const isLeafReference = (reference: number): boolean => reference >>> 31 === 1;
export const placesOf = (reference: number): number => reference & (PLACES - 1);
/** 0 for an inner node. */
export const primitivesOf = (reference: number): number =>
  isLeafReference(reference) ? ((reference >>> 27) & (MOST_PRIMITIVES - 1)) + 1 : 0;
export const indexOf = (reference: number): number => (isLeafReference(reference) ? placesOf(reference) : reference);

/** Nodes as words, for a buffer of the GPU. */
export interface EncodedNodes {
  /** Floats are the bits of `new Float32Array(words.buffer)`. */
  readonly words: Uint32Array<ArrayBuffer>;
  /** At least 1: without primitives there is a root without children. */
  readonly nodeCount: number;
  /** Most nodes that wait while one child is entered: entries of a stack that keeps each child by itself. */
  readonly stackSize: number;
  /** Nodes from the root down to the deepest, both counted: entries of a stack that keeps what is left of a node in one. */
  readonly depth: number;
}
