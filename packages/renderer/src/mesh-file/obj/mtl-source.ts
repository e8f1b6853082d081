/** What an MTL file says of a material, with account of what was asked for: the rest is told. */
import type { MtlMaterial, NumberWord, Rgb } from './mtl-statements.ts';
import type { MtlTexture, TextureWord } from './mtl-textures.ts';

export class MtlSource {
  readonly #mtl: MtlMaterial;
  readonly #left: Set<string>;

  constructor(mtl: MtlMaterial) {
    this.#mtl = mtl;
    this.#left = new Set([...mtl.colors.keys(), ...mtl.numbers.keys(), ...mtl.textures.keys(), ...mtl.others]);
    // Light from everywhere, which an integrator works out or a light of a scene says.
    this.#left.delete('Ka');
    this.#left.delete('map_Ka');
  }
  has(word: TextureWord): boolean {
    return this.#mtl.textures.has(word);
  }
  color(word: 'Kd' | 'Ks' | 'Ke' | 'Tf'): Rgb | undefined {
    const color = this.#mtl.colors.get(word);
    if (color) this.#left.delete(word);
    return color;
  }
  texture(word: TextureWord): MtlTexture | undefined {
    const texture = this.#mtl.textures.get(word);
    if (texture) this.#left.delete(word);
    for (const option of texture?.ignored ?? []) this.leave(`${word} ${option}`);
    return texture;
  }
  number(word: NumberWord): number | undefined {
    this.#left.delete(word);
    return this.#mtl.numbers.get(word);
  }
  /** Says that nothing was made of it after all. */
  leave(word: string): void {
    this.#left.add(word);
  }
  unused(): string[] {
    return [...this.#left];
  }
}
