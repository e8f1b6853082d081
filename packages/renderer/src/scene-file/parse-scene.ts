import * as v from 'valibot';
import { SCENE_LIMITS } from '../scene/limits.ts';
import type { Scene, Track } from '../scene/scene.ts';
import { checkScene, type Sections } from './check-scene.ts';
import { TrackChecker } from './check-track.ts';
import { completeNames } from './complete-names.ts';
import { copyBySchema, TooManyValues } from './copy.ts';
import { FaultyPlaces } from './faulty-places.ts';
import { readJsonText } from './json-text.ts';
import { describe, type Path, type Problem, ProblemList, quote } from './problem.ts';
import { sceneSchema, stillSchema, trackSchema } from './schema.ts';
import { treeOf } from './schema-tree.ts';
import { freeze, names, OPTIONAL, trustScene } from './trusted-scenes.ts';

export type ParsedScene =
  | { readonly ok: true; readonly scene: Scene }
  | { readonly ok: false; readonly problems: readonly Problem[] };

/**
 * Reads a scene: the text of a scene file, or the value that such a text stands for. Gives the scene with its defaults
 * filled in (a new, deeply frozen copy), or everything that is wrong with it. Never throws, whatever comes in.
 * A scene that is given back keeps all that later stages rely on, now and at every time of its animation.
 */
export function parseScene(input: unknown): ParsedScene {
  const problems = new ProblemList();
  let scene: Scene | null = null;
  try {
    const value = typeof input === 'string' ? readText(input, problems) : { read: input };
    if (value) scene = readScene(value.read, problems);
  } catch (error) {
    reportFailure(error, problems);
  }
  if (!scene || !problems.isEmpty) return { ok: false, problems: problems.list() };
  trustScene(freeze(scene));
  return { ok: true, scene };
}

function reportFailure(error: unknown, problems: ProblemList): void {
  if (error instanceof TooManyValues) {
    const most = `at most ${SCENE_LIMITS.fileValues} values`;
    problems.add([], 'too many values', most, `The file is too large: a scene may hold ${most}.`);
  } else problems.add([], 'something that cannot be read', 'a scene', 'The scene cannot be read at all.');
}

function readText(text: string, problems: ProblemList): { read: unknown } | null {
  if (text.length > SCENE_LIMITS.fileCharacters) {
    const most = `at most ${SCENE_LIMITS.fileCharacters} characters`;
    problems.add([], `${text.length} characters`, most, `The file is too large: a scene file may have ${most}.`);
    return null;
  }
  const json = readJsonText(text);
  if (!json.ok) {
    const { line, column, excerpt } = json.at;
    const found = excerpt === '' ? 'nothing more' : quote(excerpt);
    const message = `The file is not JSON: line ${line}, column ${column} has ${found}; expected ${json.expected}.`;
    problems.add([], `${found} at line ${line}, column ${column}`, json.expected, message);
    return null;
  }
  for (const { path, at } of json.duplicates) {
    const message = `The key ${at.excerpt === '' ? '' : quote(String(path.at(-1)))} stands twice in the same place, again in line ${at.line}; please rename one.`;
    problems.add(path, `the same key again, in line ${at.line}`, 'each key once', message);
  }
  return { read: json.value };
}

function readScene(input: unknown, problems: ProblemList): Scene | null {
  const copy = copyBySchema(treeOf(sceneSchema), input, [], problems);
  const tracks: unknown[] = isObject(copy) && Array.isArray(copy.animation) ? copy.animation : [];
  const result = v.safeParse(stillSchema, tracks.length > 0 ? { ...(copy as object), animation: [] } : copy);
  const faulty = new FaultyPlaces();
  for (const issue of result.issues ?? []) faulty.add(reportIssue(issue, [], problems));
  if (!isObject(result.output)) return null;
  const still = result.output as unknown as Scene;
  const sections = completeNames(sectionsOf(still));
  checkScene(sections, faulty, problems);
  const animation = readTracks(tracks, new TrackChecker(sections, faulty, problems), problems);
  const { version, name, description, render } = still;
  return { version, name, description, ...sections, animation, render };
}

function sectionsOf(still: Scene): Sections {
  const optional = OPTIONAL.filter((section) => still[section] !== undefined);
  return {
    camera: still.camera,
    sky: still.sky,
    materials: names(still.materials),
    ...Object.fromEntries(optional.map((section) => [section, names(still[section])])),
    ...(still.clip === undefined ? {} : { clip: still.clip }),
    shapes: names(still.shapes),
    lights: names(still.lights),
  };
}

function readTracks(tracks: readonly unknown[], checker: TrackChecker, problems: ProblemList): Track[] {
  const read: Track[] = [];
  tracks.forEach((track, index) => {
    const result = v.safeParse(trackSchema, track);
    for (const issue of result.issues ?? []) reportIssue(issue, ['animation', index], problems);
    if (!result.success) return;
    checker.check(result.output, index);
    read.push(result.output);
  });
  return read;
}

/** Adds what the schema found wrong; gives the path of the place. */
function reportIssue(issue: v.BaseIssue<unknown>, prefix: Path, problems: ProblemList): Path {
  const path = [...prefix, ...(issue.path ?? []).map(({ key }) => key as string | number)];
  // A union whose parts failed deeper down: those say more than "none of these".
  const deeper = issue.type === 'union' ? (issue.issues ?? []).filter((part) => part.path) : [];
  for (const part of deeper) reportIssue(part, path, problems);
  if (deeper.length === 0) problems.add(path, describe(issue.input), issue.message);
  return path;
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
