/** Tracks that move no more than where things stand: nodes, and shapes that are meshes. Frames follow these without making a scene. */
import { parsePointer } from './pointer.ts';
import type { Scene } from './scene.ts';

export interface PlacementTarget {
  readonly section: 'nodes' | 'shapes';
  readonly name: string;
  readonly part: 'translation' | 'rotation' | 'scale';
  /** When only one number of the part moves. */
  readonly component: number | null;
}

const PARTS: readonly string[] = ['translation', 'rotation', 'scale'];

/** Where a track points, when that is a placement; null for all else that may move. */
export function placementTarget(
  { nodes = {}, shapes }: Pick<Scene, 'nodes' | 'shapes'>,
  pointer: string,
): PlacementTarget | null {
  const [section, name = '', part = '', component, ...more] = parsePointer(pointer) ?? [];
  const isNode = section === 'nodes' && Object.hasOwn(nodes, name);
  const isMesh = section === 'shapes' && Object.hasOwn(shapes, name) && shapes[name]!.type === 'mesh';
  if (!(isNode || isMesh) || !PARTS.includes(part) || more.length > 0) return null;
  return {
    section: section as PlacementTarget['section'],
    name,
    part: part as PlacementTarget['part'],
    component: component === undefined ? null : Number(component),
  };
}

/** Whether a track moves the weights of a node: what its meshes look like. */
export function isOfWeights({ target }: { readonly target: string }): boolean {
  const [section, , part] = parsePointer(target) ?? [];
  return section === 'nodes' && part === 'weights';
}

/** The scene with no other tracks than these. */
export function withTracks(scene: Scene, isMeant: (track: { readonly target: string }) => boolean): Scene {
  const { animation, clips, clip } = scene;
  const playing = clip === undefined ? undefined : clips?.[clip];
  return {
    ...scene,
    animation: animation.filter(isMeant),
    ...(playing && { clips: { [clip!]: { ...playing, tracks: playing.tracks.filter(isMeant) } } }),
  };
}
