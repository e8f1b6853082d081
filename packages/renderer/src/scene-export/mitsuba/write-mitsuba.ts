/** A scene as Mitsuba 3 reads it, for a second opinion. */
import { focusOf, wholeCamera } from '../../scene/camera.ts';
import { posedSceneAt } from '../../scene/posed.ts';
import type { Camera, Scene, Shape } from '../../scene/scene.ts';
import { boundsAt } from '../../scene/scene-bounds.ts';
import { carriedOut, type ExportPlan, type PlannedFiles } from '../export-plan.ts';
import { type ExportedScene, ExportReport } from '../export-report.ts';
import { type Carried, carriedBy, NOTHING } from './carried.ts';
import { writeSky } from './environment.ts';
import { writeLight } from './lights.ts';
import { MaterialWriter, type WrittenMaterial } from './materials.ts';
import { pythonProgram } from './python.ts';
import { loadedMesh, ShapeWriter } from './shapes.ts';
import { TextureWriter } from './textures.ts';
import { boolean, type Element, float, integer, lookAt, plugin, reference, scene as sceneElement, string, textOf } from './xml.ts'; // biome-ignore format: one list

export interface MitsubaOptions {
  /** What the files are called, without ending. Default: "scene". */
  readonly name?: string;
  /** Of the animation, seconds. Default: 0. */
  readonly time?: number;
  /** Pixels. Default: 1280 × 720. */
  readonly width?: number;
  readonly height?: number;
  /** Samples a pixel. Default: 64. */
  readonly samples?: number;
}

/**
 * The scene at a time as `NAME.xml`, with the meshes as PLY files, the sky's map as EXR, and `NAME.py`, which renders it and has the BSDFs
 * that Mitsuba lacks. Every mesh must have its data. Throws an Error for a camera that Mitsuba has not.
 */
export const writeMitsuba = (scene: Scene, options: MitsubaOptions = {}): ExportedScene =>
  carriedOut(planMitsuba(scene, options));

/** The same one file at a time. */
export function planMitsuba(scene: Scene, options: MitsubaOptions = {}): ExportPlan {
  const { name = 'scene', time = 0 } = options;
  const report = new ExportReport();
  const files: PlannedFiles = new Map();
  // It stands still from here on; its tracks would move nodes that are no more.
  const { clip: _, ...posed } = { ...posedSceneAt(scene, time), animation: [] };
  if (scene.animation.length > 0 || scene.clip !== undefined)
    report.add('changed', `What moves stands still as it is at ${time} s.`, 'animation');
  if (scene.render.integrator === 'classic')
    report.add('changed', 'The classic integrator has other light: Mitsuba traces paths.', 'render settings');
  if (posed.render.toneMapping !== 'none' || posed.render.exposure !== 0)
    report.add(
      'lost',
      'The file has linear light: exposure and tone mapping are left to who shows it.',
      'render settings',
    );
  const { min, max } = boundsAt(posed, 0) ?? { min: [1, 1, 1], max: [1, 1, 1] };
  const extent = Math.max(...[...min, ...max].map(Math.abs));
  const shapes = new ShapeWriter(posed, name, extent, files, report);
  const materials = new Materials(posed, new TextureWriter(posed, name, files, report), report);
  const content = Object.entries(posed.shapes).flatMap(([key, shape]) => {
    const carried = shape.type === 'mesh' ? carriedBy(shape, loadedMesh(posed, shape), posed.materials[shape.material]!) : NOTHING; // biome-ignore format: one choice
    return shapes.write(key, shape, carried, contentOf(key, shape, materials.of(shape.material, carried), report));
  });
  const lights = Object.entries(posed.lights).map(([key, light]) => writeLight(key, light, report));
  const file = sceneElement([
    integratorFor(materials.all(), posed.render.maxDepth),
    sensor(posed.camera, options),
    ...materials.all().map(({ bsdf }) => bsdf),
    ...content,
    ...lights,
    ...writeSky(posed.sky, name, files, report),
  ]);
  const encode = (text: string) => new TextEncoder().encode(text);
  const text = textOf(file);
  if (text.includes('type="mirrorball_'))
    report.add('changed', `Mitsuba has not all of this by itself: ${name}.py adds it, so render by "python ${name}.py".`, 'materials'); // biome-ignore format: one sentence
  const xml = `<!-- ${posed.name.replaceAll('--', '- -')}, by Mirrorball -->\n${text}`;
  files.set(`${name}.xml`, () => [encode(xml)]);
  files.set(`${name}.py`, () => [encode(pythonProgram(name))]);
  return { files, report: report.list() };
}

/** Each material once for all meshes that give it the same. */
class Materials {
  readonly #scene: Scene;
  readonly #textures: TextureWriter;
  readonly #report: ExportReport;
  readonly #written = new Map<string, WrittenMaterial>();

  constructor(scene: Scene, textures: TextureWriter, report: ExportReport) {
    this.#scene = scene;
    this.#textures = textures;
    this.#report = report;
  }

  of(name: string, carried: Carried): WrittenMaterial {
    const key = JSON.stringify([name, carried]);
    const known = this.#written.get(key);
    if (known !== undefined) return known;
    const writer = new MaterialWriter(name, this.#scene.materials[name]!, carried, this.#textures, this.#report);
    const written = writer.write(`material ${this.#written.size}`);
    this.#written.set(key, written);
    return written;
  }

  all(): WrittenMaterial[] {
    return [...this.#written.values()];
  }
}

/**
 * Only paths that know media see light through what is cut out, and do not count it as a segment. `volpathmis` loses light by Russian
 * roulette, in 3.9.1 at least: of the two weights of its multiple importance sampling only one knows of the path's chance to go on, so that
 * they add up to less than 1. It must not play.
 */
function integratorFor(materials: readonly WrittenMaterial[], maxDepth: number): Element {
  const depth = integer('max_depth', maxDepth);
  if (materials.some(({ medium }) => medium !== undefined))
    return plugin('integrator', 'volpathmis', [depth, integer('rr_depth', maxDepth)]);
  return plugin('integrator', materials.some(({ isCut }) => isCut) ? 'volpath' : 'path', [depth]);
}

/** What a shape has in it: its BSDF, what is inside of it, and its light. */
function contentOf(name: string, { type }: Shape, written: WrittenMaterial, report: ExportReport): Element[] {
  const { bsdf, medium, emitter } = written;
  if (emitter && (type === 'quad' || type === 'mesh'))
    report.add('changed', 'It shines to its front side only there.', `shape "${name}"`);
  return [reference(bsdf.attributes.id!), ...(medium ? [medium] : []), ...(emitter ? [emitter] : [])];
}

function sensor(given: Camera, { width = 1280, height = 720, samples = 64 }: MitsubaOptions): Element {
  const camera = wholeCamera(given);
  const { eye, target, up, projection, verticalFov, viewHeight, aperture } = camera;
  const film = plugin('film', 'hdrfilm', [
    integer('width', width),
    integer('height', height),
    string('pixel_format', 'rgb'),
    string('component_format', 'float32'),
    boolean('sample_border', false),
    plugin('rfilter', 'box', []),
  ]);
  const parts = [film, plugin('sampler', 'independent', [integer('sample_count', samples)])];
  // Rays begin at the eye: nothing is too near, and nothing too far.
  const clips = [float('near_clip', 1e-3), float('far_clip', 1e6)];
  if (projection === 'orthographic')
    return plugin('sensor', 'orthographic', [lookAt(eye, target, up, (viewHeight / 2) * (width / height)), ...clips, ...parts]); // biome-ignore format: one expression
  if (projection === 'equirectangular') throw new Error('Mitsuba has no equirectangular camera: choose another.');
  const place = [lookAt(eye, target, up), float('fov', verticalFov), string('fov_axis', 'y'), ...clips];
  if (aperture === 0) return plugin('sensor', 'perspective', [...place, ...parts]);
  const lens = [float('aperture_radius', aperture), float('focus_distance', focusOf(camera))];
  return plugin('sensor', 'thinlens', [...place, ...lens, ...parts]);
}
