/** `mirrorball schema`: the JSON Schema that editors use. */
import schemaText from '../../../renderer/scene.schema.json?raw';
import { writeAtomically } from '../write-atomically.ts';

export async function schema({ output }: { readonly output?: string }): Promise<void> {
  if (output) await writeAtomically(output, [Buffer.from(schemaText)]);
  else process.stdout.write(schemaText);
}
