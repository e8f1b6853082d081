/** What two films must have in common to be parts of one picture, and the scene's fingerprint in it. */
import { createHash } from 'node:crypto';
import type { FilmArea, FilmSettings } from 'mirrorball/headless';
import type { MeshSource, Scene, Sky } from 'mirrorball/scene';

/** Plain JSON; what is not in it does not change the film. */
export interface FilmIdentity {
  /** SHA-256 of the scene, less its name, description and render settings. */
  readonly scene: string;
  readonly time: number;
  readonly width: number;
  readonly height: number;
  readonly region: readonly [x: number, y: number, width: number, height: number];
  readonly integrator: string;
  readonly seed: number;
  /** Those that the integrator uses. */
  readonly settings: Readonly<Record<string, number>>;
}

/** Order counts among named things (random numbers come from a light's place in the file), not inside a thing. */
function canonical(value: unknown, ordered: boolean): unknown {
  if (Array.isArray(value)) return value.map((item) => canonical(item, false));
  if (typeof value !== 'object' || value === null) return value;
  const entries = Object.entries(value).map(([key, part]) => [key, canonical(part, false)] as const);
  return ordered ? entries : entries.sort(([a], [b]) => (a < b ? -1 : 1));
}

/** A sky with an image by what is in it, whatever its file is called. */
function hashedSky({ map, image: _, ...sky }: Sky): object {
  if (!map) return sky;
  return { ...sky, map: [map.width, map.height, hashOf(map.data)] };
}

const hashOf = ({ buffer, byteOffset, byteLength }: ArrayBufferView): string =>
  createHash('sha256')
    .update(new Uint8Array(buffer, byteOffset, byteLength))
    .digest('hex');

/** Meshes by what is in them, whatever their files are called. */
function hashedMeshes(meshes: Readonly<Record<string, MeshSource>>): object {
  const hashed = Object.entries(meshes).map(([name, { data, ...source }]) => [
    name,
    data ? hashedArrays(data) : source,
  ]);
  return Object.fromEntries(hashed);
}

/** The same with a hash for each list of numbers. */
function hashedArrays(value: unknown): unknown {
  if (ArrayBuffer.isView(value)) return hashOf(value);
  if (Array.isArray(value)) return value.map(hashedArrays);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, part]) => [key, hashedArrays(part)]));
}

/** What only models have; not in the fingerprints of scenes without it. */
function hashedModel({ nodes, skins, clips, clip, images, textures, shapes }: Scene): object[] {
  if (!nodes && !images && !clips) return [];
  const pictures = images && Object.fromEntries(Object.entries(images).map(([name, { data }]) => [name, { data }]));
  return [hashedArrays([nodes, skins, clips, clip, pictures, textures, shapes]) as object];
}

export function sceneHash(scene: Scene): string {
  const { camera, sky, materials, meshes, shapes, lights, animation } = scene;
  const moving = [camera, hashedSky(sky), animation, ...(meshes ? [hashedMeshes(meshes)] : []), ...hashedModel(scene)];
  const parts = moving.map((part) => canonical(part, false));
  const named = [materials, shapes, lights].map((things) => canonical(things, true));
  return createHash('sha256')
    .update(JSON.stringify([parts, named]))
    .digest('hex');
}

export function identityOf(
  scene: Scene,
  time: number,
  { integrator, seed, maxDepth, maxReflections, lightSamples }: FilmSettings,
  size: { width: number; height: number; area: FilmArea },
): FilmIdentity {
  const { width, height, area } = size;
  const region = [area.x, area.y, area.width, area.height] as const;
  const settings: Record<string, number> = integrator === 'classic' ? { maxReflections, lightSamples } : { maxDepth };
  return { scene: sceneHash(scene), time, width, height, region, integrator, seed, settings };
}

export const regionOf = ({ region: [x, y, width, height] }: Pick<FilmIdentity, 'region'>): FilmArea => ({
  x,
  y,
  width,
  height,
});
/** All pixels of the picture. */
export const wholeOf = ({ width, height }: FilmIdentity): FilmArea => ({ x: 0, y: 0, width, height });

const isCount = (value: unknown): value is number => Number.isSafeInteger(value) && (value as number) >= 0;

/** Whether a file says one: its region lies in its picture, and all else has its type. */
export function isIdentity(value: FilmIdentity): boolean {
  const { scene, time, width, height, region, integrator, seed, settings } = value;
  return (
    [width, height, seed, ...region].every(isCount) &&
    region.length === 4 &&
    region[2] * region[3] > 0 &&
    region[0] + region[2] <= width &&
    region[1] + region[3] <= height &&
    Number.isFinite(time) &&
    [scene, integrator].every((text) => typeof text === 'string') &&
    Object.values(settings).every(Number.isFinite)
  );
}

/** In what two differ, each as a phrase for people; empty: they are parts of one picture. */
export function differences(there: FilmIdentity, here: FilmIdentity): string[] {
  const flat = ({ settings, ...rest }: FilmIdentity): Record<string, unknown> => ({ ...rest, ...settings });
  const [a, b] = [flat(there), flat(here)];
  const keys = [...new Set([...Object.keys(a), ...Object.keys(b)])];
  return keys
    .filter((key) => JSON.stringify(a[key]) !== JSON.stringify(b[key]))
    .map((key) => (key === 'scene' ? 'another scene' : `${key} ${told(a[key])} instead of ${told(b[key])}`));
}

const told = (value: unknown): string => (value === undefined ? 'none' : JSON.stringify(value));
