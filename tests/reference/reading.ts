/** Reads reference scenes and pictures from a folder like this one. */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { formatOf } from '../../packages/renderer/src/export/formats.ts';
import { readMeshFile, shadedMesh } from '../../packages/renderer/src/mesh-file/index.ts';
import type { MeshSource } from '../../packages/renderer/src/scene/mesh.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { environmentFromPicture } from '../../packages/renderer/src/scene-file/environment-from-picture.ts';
import { parseScene } from '../../packages/renderer/src/scene-file/parse-scene.ts';
import { withMap, withMeshes } from '../../packages/renderer/src/scene-file/trusted-scenes.ts';
import type { Reference } from './blocks.ts';
import { readNpy } from './npy.ts';

/** `folder`: with a slash at its end. */
export const namesIn = (folder: URL): string[] =>
  readdirSync(folder)
    .filter((name) => existsSync(new URL(`${name}/scene.json`, folder)))
    .sort();

export function readScene(folder: URL, name: string): Scene {
  const file = (path: string) => readFileSync(new URL(`${name}/${path}`, folder));
  const parsed = parseScene(file('scene.json').toString('utf8'));
  if (!parsed.ok) throw new Error(`${name}: ${parsed.problems.map(({ message }) => message).join(' ')}`);
  const { image } = parsed.scene.sky;
  const mapped =
    image === undefined
      ? parsed.scene
      : withMap(parsed.scene, environmentFromPicture(formatOf(image).read(file(image))).map);
  return mapped.meshes === undefined ? mapped : withMeshes(mapped, mapValues(mapped.meshes, file));
}

const mapValues = (meshes: Readonly<Record<string, MeshSource>>, file: (path: string) => Uint8Array) =>
  Object.fromEntries(Object.entries(meshes).map(([name, source]) => [name, loadedMesh(source, file)]));

function loadedMesh(source: MeshSource, file: (path: string) => Uint8Array): MeshSource {
  const content = readMeshFile(file(source.file!), source.file!);
  if (!content.ok) throw new Error(content.problems.map(({ message }) => message).join(' '));
  return { ...source, data: shadedMesh(content.parts[0]!.mesh, source.shading) };
}

export function readPicture(folder: URL, name: string): Reference {
  const array = (file: string) => readNpy(readFileSync(new URL(`${name}/${file}.npy`, folder)));
  const [mean, error] = [array('mean'), array('error')];
  const [height, width, channels] = mean.shape;
  if (channels !== 3 || String(mean.shape) !== String(error.shape)) throw new Error(`${name}: odd shapes of arrays.`);
  return { width: width!, height: height!, mean: mean.data, error: error.data };
}
