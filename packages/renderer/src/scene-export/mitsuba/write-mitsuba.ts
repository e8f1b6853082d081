/** A scene as Mitsuba 3 reads it, for a second opinion. */
import { focusOf, wholeCamera } from '../../scene/camera.ts';
import { posedSceneAt } from '../../scene/posed.ts';
import type { Camera, Scene } from '../../scene/scene.ts';
import { boundsAt } from '../../scene/scene-bounds.ts';
import { carriedOut, type ExportPlan, type PlannedFiles } from '../export-plan.ts';
import { type ExportedScene, ExportReport } from '../export-report.ts';
import { writeSky } from './environment.ts';
import { writeLight } from './lights.ts';
import { type WrittenMaterial, writeMaterial } from './materials.ts';
import { pythonProgram } from './python.ts';
import { ShapeWriter } from './shapes.ts';
import { boolean, type Element, float, integer, lookAt, plugin, reference, rgb, scene as sceneElement, string, textOf } from './xml.ts'; // biome-ignore format: one list

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
  const materials = writeMaterials(posed, report);
  const { min, max } = boundsAt(posed, 0) ?? { min: [1, 1, 1], max: [1, 1, 1] };
  const extent = Math.max(...[...min, ...max].map(Math.abs));
  const shapes = new ShapeWriter(posed, name, extent, files, report);
  const content = Object.entries(posed.shapes).flatMap(([key, shape]) =>
    shapes.write(key, shape, contentOf(posed, key, shape.material, materials, report)),
  );
  const lights = Object.entries(posed.lights).map(([key, light]) => writeLight(key, light, report));
  const absorbs = [...materials.values()].some(({ medium }) => medium !== undefined);
  const file = sceneElement([
    plugin('integrator', absorbs ? 'volpathmis' : 'path', [integer('max_depth', posed.render.maxDepth)]),
    sensor(posed.camera, options),
    ...[...materials.values()].map(({ bsdf }) => bsdf),
    ...content,
    ...lights,
    ...writeSky(posed.sky, name, files, report),
  ]);
  const encode = (text: string) => new TextEncoder().encode(text);
  const python = [...materials].filter(([, { needsPython }]) => needsPython).map(([key]) => key);
  for (const key of python)
    report.add('changed', `Mitsuba has no such BSDF of its own: ${name}.py adds it, so render by "python ${name}.py".`, `material "${key}"`); // biome-ignore format: one sentence
  const xml = `<!-- ${posed.name.replaceAll('--', '- -')}, by Mirrorball -->\n${textOf(file)}`;
  files.set(`${name}.xml`, () => [encode(xml)]);
  files.set(`${name}.py`, () => [encode(pythonProgram(name))]);
  return { files, report: report.list() };
}

function writeMaterials({ materials, shapes }: Scene, report: ExportReport): Map<string, WrittenMaterial> {
  const used = [...new Set(Object.values(shapes).map(({ material }) => material))];
  return new Map(used.map((name, i) => [name, writeMaterial(name, materials[name]!, `material ${i}`, report)]));
}

/** What a shape has in it: its BSDF, what is inside of it, and its light. */
function contentOf(
  scene: Scene,
  shape: string,
  material: string,
  materials: ReadonlyMap<string, WrittenMaterial>,
  report: ExportReport,
): Element[] {
  const { bsdf, medium } = materials.get(material)!;
  const { emission, emissionStrength = 1 } = scene.materials[material]!;
  const content = [reference(bsdf.attributes.id!), ...(medium ? [medium] : [])];
  if (emission.every((x) => x * emissionStrength === 0)) return content;
  const { type } = scene.shapes[shape]!;
  if (type === 'quad' || type === 'mesh')
    report.add('changed', 'It shines to its front side only there.', `shape "${shape}"`);
  const radiance = emission.map((x) => x * emissionStrength);
  return [...content, plugin('emitter', 'area', [rgb('radiance', radiance)])];
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
