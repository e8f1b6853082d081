import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { root, runNode, tools } from './run-command.mjs';

const folder = 'packages/renderer/dist';

/**
 * Builds the library for pages without our build: packages/renderer/dist/mirrorball.js, one ES module that imports nothing at its start,
 * with its types and the parts that it may load later beside it. Gives the exit code.
 */
export async function buildLibrary() {
  const bundled = await runNode(tools.vite, ['build', 'packages/renderer', '--logLevel', 'warn']);
  if (bundled !== 0) return bundled;
  const typed = await runNode(tools.typescript, ['-p', 'packages/renderer']);
  if (typed !== 0) return typed;
  writeFileSync(join(root, folder, 'mirrorball.d.ts'), "export * from './types/index.ts';\n");
  const parts = readdirSync(join(root, folder)).filter((name) => /^mirrorball(-\w+)?\.js$/.test(name));
  for (const name of parts.sort((a, b) => a.length - b.length)) {
    const raw = readFileSync(join(root, folder, name));
    const zipped = gzipSync(raw, { level: 9 }).length;
    console.log(`${folder}/${name}: ${(raw.length / 1000).toFixed(1)} KB, gzipped ${(zipped / 1000).toFixed(1)} KB`);
  }
  return 0;
}
