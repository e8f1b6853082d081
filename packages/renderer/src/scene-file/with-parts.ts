import type { Scene } from '../scene/scene.ts';
import { withVariant } from '../scene/variants.ts';
import { requireScene } from './require-scene.ts';
import { isParsedScene, trustScene } from './trusted-scenes.ts';

/** What of a scene can be replaced while the rest stays as it is. */
export interface SceneParts extends Partial<Pick<Scene, 'name' | 'description' | 'camera' | 'sky' | 'render'>> {
  /** Name of the clip that plays, or null for none. */
  readonly clip?: string | null;
  /** Name of the variant whose materials are shown. */
  readonly variant?: string;
}

/**
 * The scene with other parts, as good as before: what is new is held against the rules of scene files. For scenes that no file can hold,
 * as models are. Throws a TypeError that says what is wrong.
 */
export function withParts(scene: Scene, { clip, variant, ...parts }: SceneParts): Scene {
  if (!isParsedScene(scene))
    throw new TypeError('Parts are replaced in a scene that parseScene or importGltf has made.');
  if (typeof clip === 'string' && !Object.hasOwn(scene.clips ?? {}, clip))
    throw new TypeError(`The scene has no clip "${clip}".`);
  const { node, ...camera } = parts.camera ?? scene.camera;
  if (node !== undefined && !Object.hasOwn(scene.nodes ?? {}, node))
    throw new TypeError(`The scene has no node "${node}", which should carry the camera.`);
  const { name, description, sky, render } = scene;
  const lights = { lamp: { type: 'sphere', center: [0, 0, 0], radius: 1, radiance: 1 } };
  const checked = requireScene({ version: 1, name, description, sky, render, ...parts, camera, lights });
  const { clip: playing, ...rest } = variant === undefined ? scene : withVariant(scene, variant);
  const chosen = clip === undefined ? playing : (clip ?? undefined);
  const whole: Scene = Object.freeze({
    ...rest,
    name: checked.name,
    description: checked.description,
    sky: checked.sky,
    render: checked.render,
    camera: node === undefined ? checked.camera : Object.freeze({ ...checked.camera, node }),
    ...(chosen !== undefined && { clip: chosen }),
  });
  trustScene(whole);
  return whole;
}
