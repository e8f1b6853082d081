/** `mirrorball schema`: the JSON Schema that editors use. */
import schemaText from '../../../renderer/scene.schema.json?raw';
import type { Stream } from '../terminal.ts';
import { writeAtomically } from '../write-atomically.ts';

export async function schema({ output }: { readonly output?: string }, stdout: Stream): Promise<void> {
  if (output) await writeAtomically(output, [Buffer.from(schemaText)]);
  else stdout.write(schemaText);
}
