/** As much of three as the benchmark needs of it: the package has no types of its own. */
declare module 'three' {
  export class BufferAttribute {
    constructor(array: ArrayLike<number>, itemSize: number);
    readonly array: ArrayLike<number>;
  }
  export class BufferGeometry {
    setAttribute(name: string, attribute: BufferAttribute): this;
    setIndex(attribute: BufferAttribute): this;
  }
}
