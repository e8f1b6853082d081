/** Lists that grow as a file is read: by doubling, so that they never hold more than twice what the file has given. */

class NumberList<Numbers extends Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer> | Int32Array<ArrayBuffer>> {
  length = 0;
  #numbers: Numbers;
  readonly #make: (length: number) => Numbers;

  constructor(make: (length: number) => Numbers) {
    this.#make = make;
    this.#numbers = make(256);
  }

  push(x: number): void {
    if (this.length === this.#numbers.length) this.#grow();
    this.#numbers[this.length++] = x;
  }

  at(index: number): number {
    return this.#numbers[index]!;
  }

  /** The numbers so far: not a copy, and good until the next `push`. */
  view(): Numbers {
    return this.#numbers.subarray(0, this.length) as Numbers;
  }

  /** The numbers in an array that is as long as they are many. */
  take(): Numbers {
    return this.#numbers.slice(0, this.length) as Numbers;
  }

  #grow(): void {
    const larger = this.#make(2 * this.#numbers.length);
    larger.set(this.#numbers);
    this.#numbers = larger;
  }
}

export class FloatList extends NumberList<Float32Array<ArrayBuffer>> {
  constructor() {
    super((length) => new Float32Array(length));
  }
}
export class IndexList extends NumberList<Uint32Array<ArrayBuffer>> {
  constructor() {
    super((length) => new Uint32Array(length));
  }
}
/** Whole numbers of either sign. */
export class WholeList extends NumberList<Int32Array<ArrayBuffer>> {
  constructor() {
    super((length) => new Int32Array(length));
  }
}
