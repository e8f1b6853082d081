/**
 * Loads every model of a folder, when the environment variable MODELS names one: none may be refused, and what comes out must be a scene
 * that can be framed and played. MODELS_REPORT=1 prints what was found.
 */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { deform, isDeformable, jointMatrices, makeDeformed } from '../scene/deform.ts';
import { nodeTransforms } from '../scene/node-transforms.ts';
import { meshShapes } from '../scene/placed.ts';
import type { Scene } from '../scene/scene.ts';
import { boundsAt } from '../scene/scene-bounds.ts';
import { importGltf } from './index.ts';

const folder = process.env.MODELS;
const files =
  folder && existsSync(folder)
    ? readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) => /\.(glb|gltf)$/i.test(name))
    : [];

describe.skipIf(files.length === 0)('models', () => {
  test.each(files.length > 0 ? files : ['none'])('%s', async (name) => {
    const path = join(folder!, name);
    const start = performance.now();
    const result = await importGltf(Uint8Array.from(readFileSync(path)), {
      name,
      readFile: async (file) => Uint8Array.from(readFileSync(join(dirname(path), file))),
    });
    const took = performance.now() - start;
    if (!result.ok) throw new Error(result.problems.map(({ message }) => message).join('\n'));
    const { scene, report } = result;
    expect(Object.keys(scene.shapes).length).toBeGreaterThan(0);
    const times = scene.clip === undefined ? [0] : [0, 0.37, 1.9];
    for (const time of times) {
      const bounds = boundsAt(scene, time)!;
      expect([...bounds.min, ...bounds.max].every(Number.isFinite)).toBe(true);
      for (const form of formsAt(scene, time)) expect(form.every(Number.isFinite)).toBe(true);
    }
    if (process.env.MODELS_REPORT) {
      const entries = report.entries.map(
        ({ kind, what, count, message }) => `    ${kind} ${what} ×${count}: ${message}`,
      );
      console.log(
        `${name}: ${took.toFixed(0)} ms ${JSON.stringify(report.counts)}\n  camera ${JSON.stringify(scene.camera)}\n${entries.join('\n')}`,
      );
    }
  });
});

function formsAt(scene: Scene, time: number): Float32Array[] {
  const transforms = nodeTransforms(scene);
  const world = transforms.at(time);
  return meshShapes(scene).flatMap(([, shape]) => {
    const mesh = scene.meshes![shape.mesh]!.data!;
    if (!isDeformable(mesh)) return [];
    const out = makeDeformed(mesh);
    const joints = shape.skin === undefined ? undefined : jointMatrices(scene.skins![shape.skin]!, transforms, world);
    deform(mesh, { joints, weights: scene.nodes![shape.node!]!.weights }, out);
    return [out.positions, ...(out.normals ? [out.normals] : [])];
  });
}
