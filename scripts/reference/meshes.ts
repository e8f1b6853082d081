/** The meshes of a neutral scene, which has them where they are used, as ours, which have names. */
import type { MeshSource } from '../../packages/renderer/src/scene/mesh.ts';

export class Meshes {
  /** File and shading → name. */
  readonly #names = new Map<string, string>();
  readonly #sources: Record<string, MeshSource> = {};

  get isEmpty(): boolean {
    return this.#names.size === 0;
  }

  /** The file's own name, with a number if another has it already. */
  nameOf(file: string, smooth: boolean): string {
    const shading = smooth ? 'smooth' : 'flat';
    const key = `${shading} ${file}`;
    const known = this.#names.get(key);
    if (known !== undefined) return known;
    const base = file
      .split('/')
      .at(-1)!
      .replace(/\.[^.]*$/, '');
    let name = base;
    for (let k = 2; Object.hasOwn(this.#sources, name); k++) name = `${base} ${k}`;
    this.#names.set(key, name);
    this.#sources[name] = { file, shading };
    return name;
  }

  sources(): Readonly<Record<string, MeshSource>> {
    return this.#sources;
  }
}
