/**
 * For developers: writes the scene of a reference renderer, a "neutral scene" JSON, as a scene file of ours.
 *
 *     npx tsx scripts/convert-reference.ts NEUTRAL.json [scene.json]
 *
 * Without a second name the scene goes to standard output. A map of the sky and meshes stay where they are and are named from the new
 * file's folder on (or from the old one's). What our format cannot say exactly is an error; all of them are told, with exit code 4.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, sep } from 'node:path';
import type { Scene } from '../packages/renderer/src/scene/scene.ts';
import { writeScene } from '../packages/renderer/src/scene-file/index.ts';
import { ConversionError, convertScene } from './reference/convert-scene.ts';

function withFilesFrom(scene: Scene, folder: string): Scene {
  const { sky, meshes } = scene;
  const there = (name: string) =>
    relative(folder, join(dirname(from!), name))
      .split(sep)
      .join('/');
  const moved = Object.entries(meshes ?? {}).map(([name, mesh]) => [name, { ...mesh, file: there(mesh.file!) }]);
  return {
    ...scene,
    sky: sky.image === undefined ? sky : { ...sky, image: there(sky.image) },
    ...(meshes ? { meshes: Object.fromEntries(moved) } : {}),
  };
}

const [from, to] = process.argv.slice(2);
if (!from) {
  console.error('Which file? npx tsx scripts/convert-reference.ts NEUTRAL.json [scene.json]');
  process.exit(2);
}
try {
  const { scene, width, height } = convertScene(JSON.parse(readFileSync(from, 'utf8')));
  const text = writeScene(to ? withFilesFrom(scene, dirname(to)) : scene);
  if (to) writeFileSync(to, text);
  else process.stdout.write(text);
  console.error(`${scene.name}: a picture of ${width} × ${height}.`);
} catch (error) {
  if (!(error instanceof ConversionError || error instanceof SyntaxError)) throw error;
  console.error(`${from} cannot be converted:\n${error.message}`);
  process.exit(4);
}
