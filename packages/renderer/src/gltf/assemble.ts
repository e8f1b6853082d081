/** The parts of a file as one scene. */
import { type Frame, frameOf } from '../scene/framing.ts';
import { MODEL_RENDER, roomLights, studioSky } from '../scene/model-view.ts';
import { nodeTransforms, worldOf } from '../scene/node-transforms.ts';
import type { Clip, SampledTrack, SceneNode, Skin } from '../scene/nodes.ts';
import { placedCamera } from '../scene/placed.ts';
import type { Camera, Light, Scene, Sky, Vec3 } from '../scene/scene.ts';
import { addScaled, dot, length, subtract } from '../scene/vec3.ts';
import type { Cameras } from './cameras.ts';
import { exposureFor, isEnough, ownLight } from './own-light.ts';
import type { NamedThings } from './reading.ts';
import type { Shapes } from './shapes.ts';
import type { TextureReader } from './textures.ts';
import type { GltfOptions } from './types.ts';

export interface Parts extends Shapes {
  readonly name: string;
  readonly description: string;
  readonly nodes: NamedThings<SceneNode>;
  readonly skins: NamedThings<Skin>;
  readonly lights: NamedThings<Light>;
  readonly cameras: Cameras;
  readonly clips: NamedThings<Clip>;
  readonly textures: TextureReader;
}

/** Where nothing has an end: a metre around the origin. */
const ANYWHERE: Camera = { eye: [0, 1, 4], target: [0, 0, 0], up: [0, 1, 0], verticalFov: 30 };
const BLACK: Sky = { horizon: [0, 0, 0], zenith: [0, 0, 0] };

export function assemble(parts: Parts, options: GltfOptions): Scene {
  const { nodes, skins, materials, meshes, shapes, lights, cameras, clips, textures, variants } = parts;
  const [firstClip] = Object.keys(clips.things);
  const some = <Things extends object>(key: string, things: Things) =>
    Object.keys(things).length > 0 ? { [key]: things } : {};
  const scene: Scene = {
    version: 1,
    name: parts.name,
    description: parts.description,
    camera: ANYWHERE,
    sky: BLACK,
    materials: materials.things,
    ...some('meshes', meshes.things),
    ...some('nodes', nodes.things),
    ...some('skins', skins.things),
    ...some('images', textures.images.things),
    ...some('textures', textures.textures.things),
    ...some('clips', clips.things),
    ...(firstClip !== undefined && { clip: firstClip }),
    ...some('variants', variants),
    ...some('cameras', cameras.things),
    shapes: shapes.things as unknown as Scene['shapes'],
    lights: lights.things,
    animation: [],
    render: MODEL_RENDER,
  };
  const frame = frameOf(scene);
  return withView(withLight(scene, frame, options), frame?.camera ?? null, options);
}

function withView(scene: Scene, framed: Camera | null, { camera = 'file' }: GltfOptions): Scene {
  const cameras = Object.entries(scene.cameras ?? {}).map(([name, one]) => [name, aimed(scene, one, framed)] as const);
  const views = cameras.length > 0 ? { cameras: Object.fromEntries(cameras) } : {};
  const chosen = camera === 'file' ? cameras[0] : undefined;
  if (chosen === undefined) return { ...scene, ...views, camera: framed ?? ANYWHERE };
  return { ...scene, ...views, camera: chosen[1], ...(scene.clips && { clips: doubled(scene.clips, chosen[0]) }) };
}

/** A camera of a file knows where it looks, not how far: it gets the middle of things for a target, as near as its line of sight comes. */
function aimed(scene: Scene, camera: Camera, framed: Camera | null): Camera {
  if (framed === null) return camera;
  const transforms = nodeTransforms(scene);
  const world = placedCamera(camera, worldOf(transforms, transforms.at(0), camera.node));
  const sight = subtract(world.target, world.eye);
  const perMetre = dot(sight, sight);
  if (!(perMetre > 0)) return camera;
  const share = dot(subtract(framed.target, world.eye), sight) / perMetre;
  const least = length(subtract(framed.target, framed.eye)) / Math.sqrt(perMetre) / 100;
  const target: Vec3 = addScaled(camera.eye, subtract(camera.target, camera.eye), Math.max(share, least));
  return { ...camera, target };
}

/** What moves the camera of this name moves the scene's own too. */
function doubled(clips: Readonly<Record<string, Clip>>, camera: string): Record<string, Clip> {
  const start = `/cameras/${camera.replaceAll('~', '~0').replaceAll('/', '~1')}/`;
  const double = (track: SampledTrack): SampledTrack[] =>
    track.target.startsWith(start)
      ? [track, { ...track, target: `/camera/${track.target.slice(start.length)}` }]
      : [track];
  return Object.fromEntries(
    Object.entries(clips).map(([name, clip]) => [name, { ...clip, tracks: clip.tracks.flatMap(double) }]),
  );
}

/** A file without light enough of its own is shown in a studio; of too much of it less is shown. */
function withLight(scene: Scene, frame: Frame | null, { environment = 'auto' }: GltfOptions): Scene {
  const light = ownLight(scene);
  const shown = { ...scene, render: { ...scene.render, exposure: exposureFor(light) } };
  if (environment === 'none' || (environment === 'auto' && isEnough(light))) return shown;
  const lit = { ...shown, sky: studioSky() };
  return isEnough(light) ? lit : { ...lit, lights: { ...scene.lights, ...roomLights(frame?.room ?? null) } };
}
