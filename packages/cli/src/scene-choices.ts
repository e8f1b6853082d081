/** What options choose of a scene: camera, clip, variant, and the light around it. */
import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import type { FilmSettings } from 'mirrorball/headless';
import { formatOf, ImageError } from 'mirrorball/picture-files';
import { frameScene, type Scene, type Sky } from 'mirrorball/scene';
import { environmentFromPicture, withCamera, withParts } from 'mirrorball/scene-file';
import type { ChoiceOptions } from './arguments.ts';
import { usage } from './exit-codes.ts';
import type { Terminal } from './terminal.ts';

const FRAME = 'frame';
const NONE = 'none';
const BLACK = [0, 0, 0] as const;

export async function chosen(
  scene: Scene,
  options: ChoiceOptions & { readonly time?: number },
  terminal: Terminal,
): Promise<Scene> {
  const { clip, variant, camera, time = 0 } = options;
  if (clip !== undefined && clip !== NONE) requireName('clip', clip, scene.clips, `${NONE}: none plays`);
  if (variant !== undefined) requireName('variant', variant, scene.variants);
  let shown = scene;
  if (clip !== undefined || variant !== undefined)
    shown = withParts(shown, { ...(clip !== undefined && { clip: clip === NONE ? null : clip }), ...(variant !== undefined && { variant }) }); // biome-ignore format: one thought
  if (camera === FRAME) {
    const framed = frameScene(shown, time);
    if (framed === null) throw usage(`--camera ${FRAME}: there is nothing in the scene that has an end.`);
    shown = withParts(shown, { camera: framed });
  } else if (camera !== undefined) {
    requireName('camera', camera, scene.cameras, `${FRAME}: one that shows everything`);
    shown = withCamera(shown, camera);
  }
  const sky = await skyOf(shown.sky, options, terminal);
  return sky ? withParts(shown, { sky }) : shown;
}

/** The path integrator alone sees pictures of all around. */
export function checkChoices({ env }: ChoiceOptions, settings: Pick<FilmSettings, 'integrator'>): void {
  if (env !== undefined && settings.integrator === 'classic')
    throw usage(
      '--env lights scenes by the path integrator only, and this one asks for classic: add --integrator path.',
    );
}

function requireName(kind: string, name: string, things: object = {}, other?: string): void {
  if (Object.hasOwn(things, name)) return;
  const names = Object.keys(things);
  const listed = names.slice(0, 20).join(', ') + (names.length > 20 ? ` and ${names.length - 20} more` : '');
  const has = names.length === 0 ? `The scene has no ${kind}s` : `The scene has no ${kind} "${name}", but ${listed}`;
  throw usage(`${has}${other === undefined ? '' : ` (${other})`}.`);
}

/** Null: the scene's own. */
async function skyOf(sky: Sky, options: ChoiceOptions, terminal: Terminal): Promise<Sky | null> {
  const { env, envRotation, envStrength } = options;
  if (env === undefined && envRotation === undefined && envStrength === undefined) return null;
  if (env === undefined && !sky.map)
    throw usage('--env-rotation and --env-strength change a picture of all around: give one by --env.');
  const own = env === undefined ? sky : await readSky(env, terminal);
  return { ...own, rotation: envRotation ?? own.rotation ?? 0, scale: envStrength ?? own.scale ?? 1 };
}

async function readSky(file: string, terminal: Terminal): Promise<Sky> {
  const bytes = await readFile(file).catch(({ code, message }: NodeJS.ErrnoException) => {
    throw usage(code === 'ENOENT' ? `--env: there is no file ${file}.` : `--env: ${file} cannot be read: ${message}.`);
  });
  try {
    const { map, notes } = environmentFromPicture(formatOf(file).read(bytes));
    for (const note of notes) terminal.note(`${file}: ${note}`);
    return { horizon: BLACK, zenith: BLACK, image: basename(file), map };
  } catch (error) {
    if (error instanceof ImageError) throw usage(`The picture ${file} cannot be used: ${error.message}`);
    throw error;
  }
}
