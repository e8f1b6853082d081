/**
 * The path programs of one device. A page, where scenes come and go and nothing may be compiled while somebody watches, makes two
 * once and for all; whoever renders without a window makes one for exactly what a scene needs, or, with many small films of many
 * scenes to come, one for everything.
 */
import type { Device, Pass } from '../../gpu/device.ts';
import { COMMON_FEATURES, FEATURES, type Feature } from '../../shading/features.ts';
import { createPathPass } from './path.ts';

export type Features = ReadonlySet<Feature>;

/** Which programs are made: the two of a page, one for each set of needs, or only the one that has everything. */
export type ProgramPlan = 'two' | 'exact' | 'one';

/** Compiles and runs in a fraction of the time. */
const COMMON: Features = new Set(COMMON_FEATURES);
const ALL: Features = new Set(FEATURES);

const covers = (has: Features, needs: Features) => [...needs].every((feature) => has.has(feature));
const keyOf = (features: Features) => FEATURES.map((feature) => (features.has(feature) ? 1 : 0)).join('');

export class PathPrograms {
  readonly #device: Device;
  readonly #plan: ProgramPlan;
  readonly #compiling = new Map<string, Promise<Pass>>();
  readonly #made: { features: Features; pass: Pass }[] = [];

  constructor(device: Device, plan: ProgramPlan) {
    this.#device = device;
    this.#plan = plan;
  }

  /** The program with the least that draws what these needs ask for; undefined when there is none yet. */
  get(needs: Features): Pass | undefined {
    const fit = this.#made.filter(({ features }) => covers(features, needs));
    return fit.sort((a, b) => a.features.size - b.features.size)[0]?.pass;
  }

  /** Resolves when `get` has a program for these needs. */
  async ready(needs: Features): Promise<void> {
    if (this.#plan === 'exact') await this.#compile(needs);
    else if (this.#plan === 'one') await this.#compile(ALL);
    else {
      const [first, second] = covers(COMMON, needs) ? [COMMON, ALL] : [ALL, COMMON];
      await this.#compile(first);
      this.#compile(second).catch(() => {}); // heard when a scene asks for it
    }
  }

  #compile(features: Features): Promise<Pass> {
    const key = keyOf(features);
    let compiling = this.#compiling.get(key);
    if (!compiling) {
      compiling = createPathPass(this.#device, features);
      this.#compiling.set(key, compiling);
      compiling.then((pass) => this.#made.push({ features, pass })).catch(() => {});
    }
    return compiling;
  }
}
