/** The programs that fill a film, each compiled when it is first asked for and kept as long as the device. */
import { AOV_VIEWS } from './display/views.ts';
import type { Device, Pass } from './gpu/device.ts';
import { AOV_LAYERS, type AovContent, aovFeatures, createAovPass } from './integrator/aov/aov.ts';
import { createClassicPass } from './integrator/classic/classic.ts';
import { PATH_LAYERS } from './integrator/path/path.ts';
import { pathFeatures } from './integrator/path/path-features.ts';
import { PathPrograms, type ProgramPlan } from './integrator/path/path-programs.ts';
import { hasMeshes } from './packed-scene/refuse-meshes.ts';
import type { RendererSettings } from './renderer-types.ts';
import type { Camera, Integrator, Scene } from './scene/scene.ts';
import { FEATURES, type Feature } from './shading/features.ts';

/** What a film can hold: the light that an integrator finds, or what the camera sees first. */
export type Content = Integrator | AovContent;

/** What the film holds for such settings. */
export const contentOf = ({ view, integrator }: Pick<RendererSettings, 'view' | 'integrator'>): Content =>
  view === 'picture' ? integrator : AOV_VIEWS[view].content;

export const isAov = (content: Content | null): content is AovContent => content === 'features' || content === 'data';

/** What a program is needed for. */
export interface Subject {
  /** Default: what `settings` want to see. */
  readonly content?: Content;
  readonly scene: Scene;
  readonly camera: Camera;
  readonly settings: Readonly<RendererSettings>;
}

export const contentOfSubject = (subject: Subject): Content => subject.content ?? contentOf(subject.settings);

/** Layers of a film with this content. */
export function layersOf(content: Content): number {
  if (content === 'classic') return 1;
  return content === 'path' ? PATH_LAYERS : AOV_LAYERS;
}

export class Programs {
  readonly #device: Device;
  readonly #plan: ProgramPlan;
  readonly #paths: PathPrograms;
  /** Of all but paths, by `#keyOf`. */
  readonly #passes = new Map<string, Pass>();
  readonly #compiling = new Map<string, Promise<void>>();

  /** `plan`: which path programs are made. */
  constructor(device: Device, plan: ProgramPlan) {
    this.#device = device;
    this.#plan = plan;
    this.#paths = new PathPrograms(device, plan);
  }

  /** The program for this subject; undefined when it is not compiled yet. */
  get(subject: Subject): Pass | undefined {
    if (contentOfSubject(subject) === 'path') return this.#paths.get(pathFeatures(subject));
    return this.#passes.get(this.#keyOf(subject));
  }

  /** Resolves when `get` has the subject's program. */
  ready(subject: Subject): Promise<void> {
    const content = contentOfSubject(subject);
    if (content === 'path') return this.#paths.ready(pathFeatures(subject));
    const key = this.#keyOf(subject);
    let compiling = this.#compiling.get(key);
    if (!compiling) {
      const create = isAov(content)
        ? createAovPass(this.#device, content, this.#aovFeatures(subject))
        : createClassicPass(this.#device);
      compiling = create.then((pass) => {
        this.#passes.set(key, pass);
      });
      this.#compiling.set(key, compiling);
    }
    return compiling;
  }

  #aovFeatures(subject: Subject): ReadonlySet<Feature> {
    const all = this.#plan === 'one' && hasMeshes(subject.scene);
    return aovFeatures(all ? new Set(FEATURES) : pathFeatures(subject));
  }

  /** What tells apart the programs for AOVs and the classic integrator, which draws no models. */
  #keyOf(subject: Subject): string {
    const content = contentOfSubject(subject);
    return isAov(content) ? [content, ...this.#aovFeatures(subject)].join(' ') : content;
  }
}
