/** `mirrorball validate`: all problems of all files. */
import { type BadScene, BadSceneError } from '../exit-codes.ts';
import { countsOf } from '../mesh-facts.ts';
import { readScene } from '../scene-source.ts';
import type { Terminal } from '../terminal.ts';

export async function validate(files: readonly string[], terminal: Terminal): Promise<void> {
  const bad: BadScene[] = [];
  for (const file of files) {
    const source = await readScene(file);
    if ('problems' in source) bad.push(source);
    else {
      const { name, meshes } = source.scene;
      const counts = meshes && countsOf(meshes);
      terminal.event('valid', { file, name, ...counts });
      terminal.result(
        `${file}: good${counts ? `, with ${counts.triangles} triangles of ${counts.vertices} vertices` : ''}.`,
      );
      for (const note of source.notes) terminal.note(note);
    }
  }
  if (bad.length > 0) throw new BadSceneError(bad);
}
