/** `mirrorball validate`: all problems of all files. */
import { lookAtAll } from '../exit-codes.ts';
import { countsOf } from '../mesh-facts.ts';
import { readScene } from '../scene-source.ts';
import type { Terminal } from '../terminal.ts';

export const validate = (files: readonly string[], terminal: Terminal): Promise<void> =>
  lookAtAll(files, async (file) => {
    const source = await readScene(file);
    if ('problems' in source) return source;
    const { name, meshes } = source.scene;
    const counts = meshes && countsOf(meshes);
    terminal.event('valid', { file, name, ...counts });
    terminal.result(
      `${file}: valid${counts ? `, with ${counts.triangles} triangles of ${counts.vertices} vertices` : ''}.`,
    );
    for (const note of source.notes) terminal.note(note);
    return null;
  });
