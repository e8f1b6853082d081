/** A scene made ready to be played: what frames are made of, at any time. */
import { type CompiledAnimation, compileAnimation } from './animation.ts';
import { type Bodies, BodiesInMotion } from './bodies.ts';
import { type NodeTransforms, nodeTransforms, worldOf } from './node-transforms.ts';
import { placedScene } from './placed.ts';
import { placementTarget } from './placement-target.ts';
import type { Scene } from './scene.ts';

/** The scene at one time. */
export interface Moment {
  /**
   * Everything put into the world but the meshes: their shapes stand there as the scene has them. The same object as before when nothing
   * but meshes has moved.
   */
  readonly scene: Scene;
  /** The meshes. Going to another time writes them again. */
  readonly bodies: Bodies;
}

/** Of a scene that is animated already, as `posedSceneAt` gives it. */
export function stillMoment(scene: Scene): Moment {
  const { clips: _, clip: __, ...still } = scene;
  return new Motion({ ...still, animation: [] }).at(0);
}

/** Throws as `posedSceneAt` does. */
export class Motion {
  readonly #transforms: NodeTransforms;
  readonly #world: Float64Array;
  readonly #bodies: BodiesInMotion;
  /** All but placements of nodes and meshes. */
  readonly #rest: CompiledAnimation;
  /** Whether a node that moves carries anything but meshes. */
  readonly #carries: boolean;
  #before: { readonly now: Scene; readonly placed: Scene } | null = null;

  constructor(scene: Scene) {
    compileAnimation(scene); // or throws when a track points at nothing
    this.#transforms = nodeTransforms(scene);
    this.#world = this.#transforms.at(0);
    this.#bodies = new BodiesInMotion(scene, this.#transforms);
    this.#rest = compileAnimation(withoutPlacements(scene));
    const { names, moving } = this.#transforms;
    const moves = new Set(Array.from(moving, (node) => names[node]!));
    this.#carries = carried(scene).some((node) => moves.has(node));
  }

  /** `time`: seconds, finite. */
  at(time: number): Moment {
    const now = this.#rest(time);
    const world = this.#transforms.at(time, this.#world);
    this.#bodies.pose(time, world, now);
    return { scene: this.#placed(now, world), bodies: this.#bodies };
  }

  #placed(now: Scene, world: Float64Array): Scene {
    if (now.nodes === undefined) return now;
    if (this.#before?.now === now && !this.#carries) return this.#before.placed;
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

function withoutPlacements(scene: Scene): Scene {
  const { animation, clips, clip } = scene;
  const others = ({ target }: { readonly target: string }) => placementTarget(scene, target) === null;
  const playing = clip === undefined ? undefined : clips?.[clip];
  return {
    ...scene,
    animation: animation.filter(others),
    ...(playing && { clips: { [clip!]: { ...playing, tracks: playing.tracks.filter(others) } } }),
  };
}
