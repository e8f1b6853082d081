/**
 * The path programs of one device. A page, where scenes come and go and nothing may be compiled while somebody watches, makes three
 * once and for all: for exactly what its first scene needs, which is there soonest, then for most scenes, then for all that have no
 * models. A scene with models, which is opened and not just chosen, gets one for exactly what it needs, unless there is one that fits.
 * Whoever renders without a window makes one for exactly what each scene needs, or, with many small films of many scenes to come, one
 * for everything (and one for all that have no models).
 */
import type { Device, Pass } from '../../gpu/device.ts';
import { COMMON_FEATURES, drawsModels, FEATURES, type Feature, SHAPE_FEATURES } from '../../shading/features.ts';
import { createPathPass } from './path.ts';

export type Features = ReadonlySet<Feature>;

/** Which programs are made: those of a page, one for each set of needs, or only those that have everything. */
export type ProgramPlan = 'three' | 'exact' | 'one';

/** Compiles and runs in a fraction of the time. */
const COMMON: Features = new Set(COMMON_FEATURES);
const ALL_SHAPES: Features = new Set(SHAPE_FEATURES);
const ALL: Features = new Set(FEATURES);

const covers = (has: Features, needs: Features) => [...needs].every((feature) => has.has(feature));
const keyOf = (features: Features) => FEATURES.map((feature) => (features.has(feature) ? 1 : 0)).join('');

export class PathPrograms {
  readonly #device: Device;
  readonly #plan: ProgramPlan;
  readonly #compiling = new Map<string, Promise<Pass>>();
  /** Whether the page's own three are being made. */
  #begun = false;
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
    if (this.#plan === 'exact' || this.#compiling.has(keyOf(needs))) await this.#compile(needs);
    else if (this.#plan === 'one') await this.#compile(drawsModels(needs) ? ALL : ALL_SHAPES);
    else if (drawsModels(needs)) await (this.get(needs) ?? this.#compile(needs));
    else if (!this.#begun) {
      this.#begun = true;
      await this.#compile(needs);
      // One after the other, so that neither delays what the page draws for long. Failures are heard when a scene asks for them.
      this.#compile(COMMON)
        .finally(() => this.#compile(ALL_SHAPES))
        .catch(() => {});
    } else if (!this.get(needs)) await this.#compile(covers(COMMON, needs) ? COMMON : ALL_SHAPES);
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
