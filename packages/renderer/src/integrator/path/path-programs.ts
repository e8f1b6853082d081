/**
 * The path programs of one device. A page, where scenes come and go and nothing may be compiled while somebody watches, makes three
 * once and for all: for exactly what its first scene needs, which is there soonest, then for most scenes, then for all that have no
 * models. A scene with models, which is opened and not just chosen, gets one for exactly what it needs, unless there is one that fits.
 * Whoever renders without a window makes one for exactly what each scene needs, or, with many small films of many scenes to come, one
 * for everything (and one for all that have no models).
 *
 * Where the driver's compiler takes seconds over a long program, a page draws by one of several passes (path-relay.ts) until it is there.
 */
import { type Device, DeviceError, type Pass } from '../../gpu/device.ts';
import {
  COMMON_FEATURES,
  drawsModels,
  FEATURES,
  type Feature,
  PLAIN_MODEL_FEATURES,
  SHAPE_FEATURES,
} from '../../shading/features.ts';
import { createPathPass, isRelay } from './path.ts';

export type Features = ReadonlySet<Feature>;

/**
 * Which programs are made: those of a page, one for each set of needs, or only those that have everything; `relay`, for tests: one that has
 * everything, in several passes.
 */
export type ProgramPlan = 'three' | 'exact' | 'one' | 'relay';

/** Compiles and runs in a fraction of the time. */
const COMMON: Features = new Set(COMMON_FEATURES);
const ALL_SHAPES: Features = new Set(SHAPE_FEATURES);
const ALL: Features = new Set(FEATURES);
/** Programs that every compiler is soon done with have no more than one of these: docs/path.md, "In several passes". */
const SHORT: readonly Features[] = [COMMON, new Set(PLAIN_MODEL_FEATURES)];

const covers = (has: Features, needs: Features) => [...needs].every((feature) => has.has(feature));
const keyOf = (features: Features) => FEATURES.map((feature) => (features.has(feature) ? 1 : 0)).join('');

export class PathPrograms {
  readonly #device: Device;
  readonly #plan: ProgramPlan;
  readonly #compiling = new Map<string, Promise<Pass>>();
  /** Whether the page's own three are being made. */
  #begun = false;
  /** Programs that nobody waits for, one after the other, so that none delays what the page draws for long. */
  #later: Promise<unknown> = Promise.resolve();
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
    else if (this.#plan !== 'three') await this.#compile(drawsModels(needs) ? ALL : ALL_SHAPES);
    else if (drawsModels(needs)) await (this.get(needs) ?? this.#compile(needs));
    else if (!this.#begun) {
      this.#begun = true;
      await this.#compile(needs);
      this.#compileLater(() => this.#compile(COMMON));
      this.#compileLater(() => this.#compile(ALL_SHAPES));
    } else if (!this.get(needs)) await this.#compile(covers(COMMON, needs) ? COMMON : ALL_SHAPES);
  }

  /** Failures are heard when a scene asks for what has failed. */
  #compileLater(compile: () => Promise<unknown>): void {
    this.#later = this.#later.then(compile).catch(() => {});
  }

  #compile(features: Features): Promise<Pass> {
    const key = keyOf(features);
    let compiling = this.#compiling.get(key);
    if (!compiling) {
      compiling = this.#create(features);
      this.#compiling.set(key, compiling);
      compiling.then((pass) => this.#take(features, pass)).catch(() => {});
    }
    return compiling;
  }

  async #create(features: Features): Promise<Pass> {
    const { relay } = this.#device;
    const isLong = !SHORT.some((short) => covers(short, features));
    const wanted = this.#plan === 'relay' || (this.#plan === 'three' && relay?.pays && isLong);
    const whole = () => createPathPass(this.#device, features);
    if (!relay || !wanted) return whole();
    const { createPathRelay } = await import('./path-relay.ts');
    return createPathRelay(this.#device, relay, features).catch((error: unknown) => {
      if (error instanceof DeviceError && this.#plan === 'three') return whole();
      throw error;
    });
  }

  #take(features: Features, pass: Pass): void {
    const made = { features, pass };
    this.#made.push(made);
    if (this.#plan === 'three' && isRelay(pass))
      this.#compileLater(async () => {
        made.pass = await createPathPass(this.#device, features);
      });
  }
}
