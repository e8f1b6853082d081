import { toJsonSchema } from '@valibot/to-json-schema';
import { sceneSchema } from './schema.ts';

/** The text of `scene.schema.json`, which editors use to complete and check scene files. Not part of the library. */
export function jsonSchemaText(): string {
  const schema = toJsonSchema(sceneSchema, {
    target: 'draft-07',
    typeMode: 'input',
    // `transform` (one sky colour → two) changes nothing of what may be written; `raw_check` and `check` are told when the file is read.
    ignoreActions: ['transform', 'raw_check', 'check'],
  });
  return `${JSON.stringify({ title: 'Mirrorball scene', ...schema }, null, 2)}\n`;
}
