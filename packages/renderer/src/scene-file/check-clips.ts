/** What must hold in clips: targets, times, and as many values as the target has numbers. */
import * as v from 'valibot';
import { belongsTo } from '../scene/models.ts';
import type { SampledTrack } from '../scene/nodes.ts';
import { parsePointer } from '../scene/pointer.ts';
import { resolveClipTarget } from '../scene/targets.ts';
import { listOfNames } from './check-references.ts';
import type { Sections } from './check-scene.ts';
import { nearestTarget, schemaAt } from './check-track.ts';
import type { FaultyPlaces } from './faulty-places.ts';
import { describe, nearest, type Path, type ProblemList, quote } from './problem.ts';

const MOVABLE =
  'a pointer to numbers under "/camera", "/sky", "/materials", "/shapes", "/lights", "/nodes" or "/cameras"';

export function checkClips(scene: Sections, faulty: FaultyPlaces, problems: ProblemList): void {
  for (const [name, { tracks }] of Object.entries(scene.clips ?? {}))
    if (!faulty.has('clips', name))
      tracks.forEach((track, i) => {
        checkTrack(scene, track, ['clips', name, 'tracks', i], faulty, problems);
      });
  checkPlaying(scene, faulty, problems);
}

/** Whether the clip that plays is there. Those of models come with them. */
export function checkPlaying(
  { clip, clips = {}, models }: Sections,
  faulty: FaultyPlaces,
  problems: ProblemList,
  loaded = false,
): void {
  if (clip === undefined || faulty.has('clip') || faulty.has('clips') || Object.hasOwn(clips, clip)) return;
  if (!loaded && Object.keys(models ?? {}).some((model) => belongsTo(model, clip))) return;
  const names = Object.keys(clips);
  const meant = nearest(clip, names);
  const listed = listOfNames(names, 'a clip');
  const message = `The clip ${quote(clip)} is to play, but this scene does not have it; expected ${listed}.${meant === null ? '' : ` Did you mean ${quote(meant)}?`}`;
  problems.add(['clip'], `the name ${quote(clip)}`, listed, message);
}

function checkTrack(
  scene: Sections,
  { target: pointer, interpolation, times, values }: SampledTrack,
  path: Path,
  faulty: FaultyPlaces,
  problems: ProblemList,
): void {
  const late = times.findIndex((time, i) => i > 0 && time < times[i - 1]!);
  if (late > 0)
    problems.add([...path, 'times'], `${times[late]} after ${times[late - 1]}`, 'times that never decrease');
  const [section = '', name] = parsePointer(pointer) ?? [];
  if (faulty.has(section, name)) return;
  const target = resolveClipTarget(scene, pointer);
  if (target === null) {
    const meant = nearestTarget(scene, pointer);
    const message = `Nothing at ${quote(pointer, 80)} can be animated; a target is ${MOVABLE}.${meant === null ? '' : ` Did you mean ${quote(meant, 80)}?`}`;
    problems.add([...path, 'target'], `the target ${quote(pointer, 80)}`, MOVABLE, message);
    return;
  }
  const width = typeof target.value === 'number' ? 1 : target.value.length;
  const wanted = times.length * width * (interpolation === 'cubic' ? 3 : 1);
  if (values.length !== wanted || wanted === 0) {
    const allowed = `${wanted === 0 ? 'at least one key and ' : ''}${width} numbers for each of ${times.length} times${interpolation === 'cubic' ? ', three times over' : ''}`;
    problems.add([...path, 'values'], `${values.length} numbers`, allowed);
    return;
  }
  // What nodes do needs no more than to be finite.
  const schema = section === 'nodes' ? undefined : schemaAt(scene, section, target.name, target.path);
  if (schema === undefined) return;
  for (const point of controlPoints(interpolation, width, times, values)) {
    const value = width === 1 ? point[0] : point;
    const result = v.safeParse(schema, value);
    if (result.success) continue;
    problems.add([...path, 'values'], describe(value), result.issues[0].message);
    return;
  }
}

/** Values whose hull holds all that the track passes through: those of the keys, and of cubic curves the two others that Bézier has between. */
function* controlPoints(
  interpolation: SampledTrack['interpolation'],
  width: number,
  times: Float32Array,
  values: Float32Array,
): Generator<number[]> {
  const at = (place: number) => Array.from(values.subarray(place * width, (place + 1) * width));
  for (let k = 0; k < times.length; k++) {
    if (interpolation !== 'cubic') {
      yield at(k);
      continue;
    }
    const [into, value, out] = [at(3 * k), at(3 * k + 1), at(3 * k + 2)];
    yield value;
    if (k > 0) yield value.map((x, i) => x - (into[i]! * (times[k]! - times[k - 1]!)) / 3);
    if (k + 1 < times.length) yield value.map((x, i) => x + (out[i]! * (times[k + 1]! - times[k]!)) / 3);
  }
}
