import type { Clip, SampledTrack } from '../scene/nodes.ts';
import { formatPointer } from '../scene/pointer.ts';
import type { Scene } from '../scene/scene.ts';
import { isParsedScene, trustScene } from './trusted-scenes.ts';

/**
 * The scene as one of its other cameras (`Scene.cameras`) sees it, with what moves that one in clips. Throws a TypeError when there is none
 * of the name.
 */
export function withCamera(scene: Scene, name: string): Scene {
  const { cameras = {}, clips } = scene;
  if (!Object.hasOwn(cameras, name)) throw new TypeError(`The scene has no camera "${name}".`);
  const whole: Scene = Object.freeze({
    ...scene,
    camera: cameras[name]!,
    // Tracks of /camera move the camera that was seen by before.
    animation: scene.animation.filter(({ target }) => !target.startsWith('/camera/')),
    ...(clips && { clips: Object.freeze(mapValues(clips, (clip) => movedFor(clip, name))) }),
  });
  if (isParsedScene(scene)) trustScene(whole);
  return whole;
}

function movedFor(clip: Clip, name: string): Clip {
  const start = `${formatPointer(['cameras', name])}/`;
  const tracks = clip.tracks.flatMap((track): SampledTrack[] => {
    if (track.target.startsWith('/camera/')) return [];
    return track.target.startsWith(start)
      ? [track, { ...track, target: `/camera/${track.target.slice(start.length)}` }]
      : [track];
  });
  return tracks.length === clip.tracks.length && tracks.every((track, i) => track === clip.tracks[i])
    ? clip
    : { ...clip, tracks };
}

const mapValues = <From, To>(things: Readonly<Record<string, From>>, change: (thing: From) => To) =>
  Object.assign(
    Object.create(null),
    Object.fromEntries(Object.entries(things).map(([key, thing]) => [key, change(thing)] as const)),
  ) as Record<string, To>;
