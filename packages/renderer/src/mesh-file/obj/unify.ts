/** Numbers what is the same once: combinations of four whole numbers → 0, 1, 2 … in the order in which they come up. */

const EMPTY = -1;

export class Unifier {
  #keys = new Int32Array(4 * 64);
  #slots = new Int32Array(128).fill(EMPTY);
  length = 0;

  /** The number of this combination. */
  add(a: number, b: number, c: number, d: number): number {
    const keys = this.#keys;
    const mask = this.#slots.length - 1;
    let slot = mixed(a, b, c, d) & mask;
    for (;;) {
      const at = this.#slots[slot]!;
      if (at === EMPTY) break;
      if (keys[4 * at] === a && keys[4 * at + 1] === b && keys[4 * at + 2] === c && keys[4 * at + 3] === d) return at;
      slot = (slot + 1) & mask;
    }
    if (4 * this.length === keys.length) {
      this.#grow();
      return this.add(a, b, c, d);
    }
    this.#slots[slot] = this.length;
    keys[4 * this.length] = a;
    keys[4 * this.length + 1] = b;
    keys[4 * this.length + 2] = c;
    keys[4 * this.length + 3] = d;
    return this.length++;
  }

  /** One of the four numbers of combination `index`. */
  part(index: number, k: 0 | 1 | 2 | 3): number {
    return this.#keys[4 * index + k]!;
  }

  /** Half of the slots stay free. */
  #grow(): void {
    const keys = new Int32Array(2 * this.#keys.length);
    keys.set(this.#keys);
    this.#keys = keys;
    const slots = new Int32Array(2 * this.#slots.length).fill(EMPTY);
    const mask = slots.length - 1;
    for (let k = 0; k < this.length; k++) {
      let slot = mixed(keys[4 * k]!, keys[4 * k + 1]!, keys[4 * k + 2]!, keys[4 * k + 3]!) & mask;
      while (slots[slot] !== EMPTY) slot = (slot + 1) & mask;
      slots[slot] = k;
    }
    this.#slots = slots;
  }
}

/** The finalizer of MurmurHash3 over four words (A. Appleby, public domain). */
function mixed(a: number, b: number, c: number, d: number): number {
  let h = Math.imul(a, 0x85ebca6b) ^ Math.imul(b, 0xc2b2ae35) ^ Math.imul(c, 0x27d4eb2f) ^ Math.imul(d, 0x165667b1);
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}
