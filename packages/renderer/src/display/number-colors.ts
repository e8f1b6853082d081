/** Colours that tell shapes apart. They come from names, so that a shape keeps its colour when others come and go. */
import type { Color } from '../scene/scene.ts';

/** FNV-1a, 32 bits (Fowler, Noll and Vo), and a mix so that names that differ at their end differ in all bits. */
function hashOf(text: string): number {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  hash = Math.imul(hash ^ (hash >>> 15), 0x2c1b3c6d);
  return (hash ^ (hash >>> 13)) >>> 0;
}

/** Bright enough to be seen on black, which is nothing. Red, green, blue of the screen, 0 … 1. */
export function colorOfName(name: string): Color {
  const hash = hashOf(name);
  const hue = (hash & 0xffff) / 0x10000;
  const lightness = 0.45 + 0.3 * (((hash >>> 16) & 0xff) / 255);
  const chroma = (1 - Math.abs(2 * lightness - 1)) * (0.55 + 0.45 * ((hash >>> 24) / 255));
  const channel = (shift: number) => {
    const x = Math.abs(((hue * 6 + shift) % 6) - 3);
    return lightness + chroma * (Math.min(Math.max(x - 1, 0), 1) - 0.5);
  };
  return [channel(0), channel(4), channel(2)];
}
