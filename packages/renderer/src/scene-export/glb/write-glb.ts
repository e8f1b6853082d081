/** A scene as one .glb file: glTF 2.0 with the extensions that it needs. */
import { frameScene } from '../../scene/framing.ts';
import type { Scene } from '../../scene/scene.ts';
import { boundsAt } from '../../scene/scene-bounds.ts';
import { carriedOut, type ExportPlan, type OnExportProgress } from '../export-plan.ts';
import { type ExportedScene, ExportReport } from '../export-report.ts';
import { writeClips } from './clips.ts';
import { GltfFile, type Json } from './gltf-file.ts';
import { MaterialWriter } from './materials.ts';
import { NodeWriter } from './nodes.ts';
import { fromColumns, quadMatrix, ShapeWriter } from './shapes.ts';
import { TextureWriter } from './textures.ts';
import { LightWriter, writeCamera } from './views.ts';

export interface GlbOptions {
  /** What the file is called, without ending. Default: "scene". */
  readonly name?: string;
  readonly onProgress?: OnExportProgress;
}

/**
 * The scene as `NAME.glb`: hierarchy, meshes with all they have, skins, clips, materials with their layers, textures as PNG, variants,
 * cameras, lights. What glTF has otherwise or not at all is in the report. Everything must have its data.
 */
export const writeGlb = (scene: Scene, options: GlbOptions = {}): ExportedScene => carriedOut(planGlb(scene, options));

/** The same in pieces: numbers of meshes are not copied. Images are packed at once, as the file begins with where they lie. */
export function planGlb(scene: Scene, { name = 'scene', onProgress }: GlbOptions = {}): ExportPlan {
  const file = new GltfFile();
  const report = new ExportReport();
  const nodes = new NodeWriter(file, scene);
  const materials = new MaterialWriter(file, scene, new TextureWriter(file, scene, onProgress), report);
  const bounds = boundsAt(scene, 0);
  const extent = bounds ? Math.max(...[...bounds.min, ...bounds.max].map(Math.abs)) : 1;
  const shapes = new ShapeWriter(file, scene, nodes, materials, extent, report);
  shapes.write();
  const lights = writeLights(file, scene, nodes, shapes, materials, report);
  const cameras = writeCameras(file, scene, nodes, report);
  writeClips(file, scene, { nodes, materials: materials.places(), lights: lights.places, cameras }, report);
  reportRest(scene, report);
  const root: Json = { scene: 0 };
  if (scene.description !== '') root.asset = { version: '2.0', generator: 'Mirrorball', copyright: scene.description };
  if (lights.list.length > 0) file.extend(root, 'KHR_lights_punctual').lights = lights.list;
  const variants = Object.keys(scene.variants ?? {});
  if (variants.length > 0)
    file.extend(root, 'KHR_materials_variants').variants = variants.map((one) => ({ name: one }));
  file.add('scenes', { name: scene.name, nodes: nodes.roots() });
  const pieces = file.glb(root);
  return { files: new Map([[`${name}.glb`, () => pieces]]), report: report.list() };
}

function writeLights(
  file: GltfFile,
  scene: Scene,
  nodes: NodeWriter,
  shapes: ShapeWriter,
  materials: MaterialWriter,
  report: ExportReport,
): LightWriter {
  const lights = new LightWriter(file, nodes, report);
  for (const [name, light] of Object.entries(scene.lights)) {
    if (light.type !== 'sphere' && light.type !== 'quad') {
      lights.write(name, light);
      continue;
    }
    const thing = `light "${name}"`;
    report.add('changed', 'A lamp with an area is a black body that shines there.', thing);
    if (!light.visible) report.add('changed', 'A light that is not to be seen is seen there.', thing);
    const color = light.type === 'sphere' ? light.diffuse : light.color;
    const material = materials.lamp(
      name,
      color.map((x) => x * light.radiance),
    );
    if (light.type === 'quad') {
      report.add('changed', 'A quad light shines to both sides there.', thing);
      shapes.form(name, 'quad', quadMatrix(light), material, light.node);
    } else {
      const r = light.radius;
      if (light.halo > 0 || light.ambient.some((x) => x > 0))
        report.add('lost', 'Halos and ambient light belong to the classic integrator.', thing);
      shapes.form(name, 'sphere', fromColumns([r, 0, 0], [0, r, 0], [0, 0, r], light.center), material, light.node);
    }
  }
  return lights;
}

/** The scene's own comes first, as importers take the first one; it may be one of the others. */
function writeCameras(file: GltfFile, scene: Scene, nodes: NodeWriter, report: ExportReport): Map<string, number> {
  const { camera, cameras = {} } = scene;
  const places = new Map<string, number>();
  const same = Object.entries(cameras).find(([, one]) => JSON.stringify(one) === JSON.stringify(camera));
  const rest = Object.entries(cameras).filter(([key]) => key !== same?.[0]);
  // A view that importers find by themselves is left to them.
  const found = same === undefined && rest.length === 0 && JSON.stringify(frameScene(scene)) === JSON.stringify(camera);
  const all = found ? [] : [same ?? (['camera', camera] as const), ...rest];
  for (const [name, one] of all) {
    const place = writeCamera(file, nodes, name, one, report);
    if (place !== null) places.set(name, place);
  }
  return places;
}

function reportRest({ sky, render, shapes, materials }: Scene, report: ExportReport): void {
  if (sky.map || [...sky.horizon, ...sky.zenith].some((x) => x > 0))
    report.add('lost', 'glTF has no sky: viewers light models with one of theirs.', 'sky');
  if (render.exposure !== 0 || render.toneMapping !== 'none' || render.maxDepth !== -1)
    report.add('lost', 'glTF has no render settings.', 'render settings');
  const used = new Set(Object.values(shapes).map(({ material }) => material));
  for (const name of Object.keys(materials))
    if (!used.has(name)) report.add('lost', 'A material that no shape has is left out, unless a variant has it.', `material "${name}"`); // biome-ignore format: one sentence
}
