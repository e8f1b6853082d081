/** The part of gifenc, which brings no types, that `media.ts` uses. */
declare module 'gifenc' {
  type Rgb = readonly number[];
  interface Encoder {
    writeFrame(
      index: Uint8Array,
      width: number,
      height: number,
      options: {
        palette: readonly Rgb[];
        /** Milliseconds. */
        delay: number;
        transparent: boolean;
        transparentIndex: number;
        dispose: number;
        /** 0: for ever. */
        repeat: number;
      },
    ): void;
    finish(): void;
    bytes(): Uint8Array;
  }
  const gifenc: {
    GIFEncoder(): Encoder;
    quantize(rgba: Uint8Array | Uint8ClampedArray, mostColors: number, options: { format: 'rgb565' }): Rgb[];
    applyPalette(rgba: Uint8Array | Uint8ClampedArray, palette: readonly Rgb[], format: 'rgb565'): Uint8Array;
  };
  export default gifenc;
}
