/** Writes packages/renderer/scene.schema.json from the schema that the scene reader uses. Run by `npm run schema`. */
import { writeFileSync } from 'node:fs';
import { jsonSchemaText } from '../packages/renderer/src/scene-file/json-schema.ts';

const file = new URL('../packages/renderer/scene.schema.json', import.meta.url);
writeFileSync(file, jsonSchemaText());
console.log('Wrote packages/renderer/scene.schema.json.');
