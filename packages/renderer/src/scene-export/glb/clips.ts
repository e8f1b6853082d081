/** Clips as animations: nodes by channels, all else by KHR_animation_pointer. */
import { MATERIAL_FIELDS } from '../../gltf/pointers.ts';
import type { SampledTrack } from '../../scene/nodes.ts';
import { parsePointer } from '../../scene/pointer.ts';
import type { Scene } from '../../scene/scene.ts';
import type { ExportReport } from '../export-report.ts';
import type { GltfFile, Json } from './gltf-file.ts';
import type { NodeWriter } from './nodes.ts';

const INTERPOLATIONS = { step: 'STEP', linear: 'LINEAR', cubic: 'CUBICSPLINE' } as const;

/** Where things of the scene are in the file. */
export interface Places {
  readonly nodes: NodeWriter;
  readonly materials: ReadonlyMap<string, number>;
  readonly lights: ReadonlyMap<string, number>;
  readonly cameras: ReadonlyMap<string, number>;
}

export function writeClips(file: GltfFile, scene: Scene, places: Places, report: ExportReport): void {
  const { clips = {}, clip: playing } = scene;
  if (scene.animation.length > 0)
    report.add('lost', 'Tracks of keyframes ("animation") stand still as they are at rest.', 'animation');
  // The first one is the one that importers play.
  const names = Object.keys(clips).sort((a, b) => Number(b === playing) - Number(a === playing));
  for (const name of names) {
    const animation: Json = { name, channels: [], samplers: [] };
    for (const track of clips[name]!.tracks) {
      const target = targetOf(file, track, scene, places);
      if (target === null) {
        report.add('lost', `glTF has no way to move ${track.target}.`, `clip "${name}"`);
        continue;
      }
      if (target === 'elsewhere') continue;
      const { factor = 1, ...where } = target;
      const values = factor === 1 ? track.values : track.values.map((x) => x / factor);
      const times = track.times;
      const sampler = animation.samplers.push({
        input: file.accessor(times, 'SCALAR', { min: [times[0]], max: [times.at(-1)] }),
        output: file.accessor(values, typeOf(values.length, track, where)),
        interpolation: INTERPOLATIONS[track.interpolation],
      });
      animation.channels.push({ sampler: sampler - 1, target: where });
    }
    if (animation.channels.length > 0) file.add('animations', animation);
    else report.add('lost', 'A clip that moves nothing of the file is left out.', `clip "${name}"`);
    if (clips[name]!.repeat !== undefined && clips[name]!.repeat !== 'loop')
      report.add('lost', 'glTF leaves it to players whether clips repeat.', `clip "${name}"`);
  }
}

function typeOf(
  length: number,
  { times, interpolation }: SampledTrack,
  where: Json,
): 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4' {
  const width = length / times.length / (interpolation === 'cubic' ? 3 : 1);
  if (where.path === 'weights') return 'SCALAR';
  return ({ 2: 'VEC2', 3: 'VEC3', 4: 'VEC4' } as const)[width] ?? 'SCALAR';
}

/** Null: glTF cannot; 'elsewhere': another track moves the same. */
function targetOf(file: GltfFile, { target }: SampledTrack, scene: Scene, places: Places): Json | null | 'elsewhere' {
  const [section = '', name = '', ...path] = parsePointer(target) ?? [];
  const property = path.join('/');
  if (section === 'nodes' && ['translation', 'rotation', 'scale', 'weights'].includes(property))
    return { node: places.nodes.place(name), path: property };
  // The scene's own camera is a copy of one of the file's.
  if (section === 'camera') return Object.keys(scene.cameras ?? {}).length > 0 ? 'elsewhere' : null;
  const pointed = (pointer: string, factor?: number): Json => {
    const where: Json = { path: 'pointer', ...(factor && { factor }) };
    file.extend(where, 'KHR_animation_pointer').pointer = pointer;
    return where;
  };
  const material = section === 'materials' ? places.materials.get(name) : undefined;
  if (material !== undefined) {
    const field = Object.entries(MATERIAL_FIELDS).find(([, [one]]) => one!.to === property && one!.from === undefined);
    return field ? pointed(`/materials/${material}/${field[0]}`, field[1][0]!.factor) : null;
  }
  const light = section === 'lights' ? places.lights.get(name) : undefined;
  if (light !== undefined && ['intensity', 'irradiance', 'color'].includes(property))
    return pointed(`/extensions/KHR_lights_punctual/lights/${light}/${property === 'color' ? 'color' : 'intensity'}`);
  const camera = section === 'cameras' ? places.cameras.get(name) : undefined;
  if (camera !== undefined && property === 'verticalFov')
    return pointed(`/cameras/${camera}/perspective/yfov`, 180 / Math.PI);
  return null;
}
