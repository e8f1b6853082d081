/** A scene made ready to be played: what frames are made of, at any time. */
import { type CompiledAnimation, compileAnimation } from './animation.ts';
import { type NodeTransforms, nodeTransforms, worldOf } from './node-transforms.ts';
import { placedScene } from './placed.ts';
import { isOfWeights, placementTarget, withTracks } from './placement-target.ts';
import type { Scene } from './scene.ts';

/** The scene at one time. */
export interface Moment {
  /**
   * Everything put into the world but the meshes: their shapes stand there as the scene has them. The same object as before when nothing
   * but meshes has moved.
   */
  readonly scene: Scene;
  /** The scene that plays, and the time, seconds: what `Bodies` say of meshes. */
  readonly played: Scene;
  readonly time: number;
}

/** Of a scene that is animated already, as `posedSceneAt` gives it. */
export function stillMoment(scene: Scene): Moment {
  const { clips: _, clip: __, ...still } = scene;
  return new Motion({ ...still, animation: [] }).at(0);
}

/** Throws as `posedSceneAt` does. */
export class Motion {
  readonly #scene: Scene;
  readonly #transforms: NodeTransforms;
  /** All but placements of nodes and meshes, and the forms of these. */
  readonly #rest: CompiledAnimation;
  /** Whether a node that moves carries anything but meshes. */
  readonly #carries: boolean;
  #before: { readonly now: Scene; readonly placed: Scene } | null = null;

  constructor(scene: Scene) {
    compileAnimation(scene); // or throws when a track points at nothing
    this.#scene = scene;
    this.#transforms = nodeTransforms(scene);
    const movesMore = (track: { readonly target: string }) =>
      placementTarget(scene, track.target) === null && !isOfWeights(track);
    this.#rest = compileAnimation(withTracks(scene, movesMore));
    const { names, moving } = this.#transforms;
    const moves = new Set(Array.from(moving, (node) => names[node]!));
    this.#carries = carried(scene).some((node) => moves.has(node));
  }

  /** `time`: seconds, finite. */
  at(time: number): Moment {
    return { scene: this.#placed(this.#rest(time), time), played: this.#scene, time };
  }

  #placed(now: Scene, time: number): Scene {
    if (now.nodes === undefined) return now;
    if (this.#before?.now === now && !this.#carries) return this.#before.placed;
    const world = this.#transforms.at(time);
    const placed = placedScene(now, (node) => worldOf(this.#transforms, world, node), false);
    this.#before = { now, placed };
    return placed;
  }
}

/** Names of nodes that carry something else than a mesh. */
function carried({ camera, cameras = {}, lights, shapes }: Scene): string[] {
  const others = Object.values(shapes).filter(({ type }) => type !== 'mesh');
  const things = [camera, ...Object.values(cameras), ...Object.values(lights), ...others];
  return things.flatMap(({ node }) => (node === undefined ? [] : [node]));
}
