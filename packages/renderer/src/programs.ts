/** The programs that fill a film, each compiled when it is first asked for and kept as long as the device. */
import { AOV_VIEWS } from './display/views.ts';
import type { Device, Pass } from './gpu/device.ts';
import { AOV_LAYERS, type AovContent, createAovPass } from './integrator/aov/aov.ts';
import { createClassicPass } from './integrator/classic/classic.ts';
import { PATH_LAYERS } from './integrator/path/path.ts';
import { pathFeatures } from './integrator/path/path-features.ts';
import { PathPrograms, type ProgramPlan } from './integrator/path/path-programs.ts';
import type { RendererSettings } from './renderer-types.ts';
import type { Camera, Integrator, Scene } from './scene/scene.ts';

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
  readonly #paths: PathPrograms;
  readonly #passes = new Map<Content, Pass>();
  readonly #compiling = new Map<Content, Promise<void>>();

  /** `plan`: which path programs are made. */
  constructor(device: Device, plan: ProgramPlan) {
    this.#device = device;
    this.#paths = new PathPrograms(device, plan);
  }

  /** The program for this subject; undefined when it is not compiled yet. */
  get(subject: Subject): Pass | undefined {
    const content = contentOfSubject(subject);
    return content === 'path' ? this.#paths.get(pathFeatures(subject)) : this.#passes.get(content);
  }

  /** Resolves when `get` has the subject's program. */
  ready(subject: Subject): Promise<void> {
    const content = contentOfSubject(subject);
    if (content === 'path') return this.#paths.ready(pathFeatures(subject));
    let compiling = this.#compiling.get(content);
    if (!compiling) {
      const create = isAov(content) ? createAovPass(this.#device, content) : createClassicPass(this.#device);
      compiling = create.then((pass) => {
        this.#passes.set(content, pass);
      });
      this.#compiling.set(content, compiling);
    }
    return compiling;
  }
}
