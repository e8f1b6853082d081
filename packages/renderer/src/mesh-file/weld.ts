/** Which vertices lie at exactly the same place. */

const EMPTY = 0xffffffff;

export interface Welded {
  /** For each vertex the number of its place, counted from 0 in the order in which places come up. */
  readonly placeOf: Uint32Array;
  readonly places: number;
}

/** 0 and −0 are one place. */
export function weld(positions: Float32Array): Welded {
  const vertices = positions.length / 3;
  const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  const placeOf = new Uint32Array(vertices);
  // Of each place a vertex, found by a hash of its bits; half of the slots stay free.
  const slots = new Uint32Array(2 ** Math.ceil(Math.log2(2 * vertices + 1))).fill(EMPTY);
  const mask = slots.length - 1;
  let places = 0;
  for (let vertex = 0; vertex < vertices; vertex++) {
    const at = 3 * vertex;
    const [x, y, z] = [plain(bits[at]!), plain(bits[at + 1]!), plain(bits[at + 2]!)];
    let slot = mixed(x, y, z) & mask;
    for (;;) {
      const other = slots[slot]!;
      if (other === EMPTY) {
        slots[slot] = vertex;
        placeOf[vertex] = places++;
        break;
      }
      const from = 3 * other;
      if (plain(bits[from]!) === x && plain(bits[from + 1]!) === y && plain(bits[from + 2]!) === z) {
        placeOf[vertex] = placeOf[other]!;
        break;
      }
      slot = (slot + 1) & mask;
    }
  }
  return { placeOf, places };
}

/** −0 as 0. */
const plain = (bits: number): number => (bits === 0x80000000 ? 0 : bits);

/** The finalizer of MurmurHash3 over three words (A. Appleby, public domain). */
function mixed(x: number, y: number, z: number): number {
  let h = Math.imul(x, 0x85ebca6b) ^ Math.imul(y, 0xc2b2ae35) ^ Math.imul(z, 0x27d4eb2f);
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}
