import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../../', import.meta.url));

/** The documents that people read first. Paths from the root. */
export const documents = [
  'README.md',
  'README.zh-CN.md',
  'ARCHITECTURE.md',
  'CONTRIBUTING.md',
  'CHANGELOG.md',
  'docs/aov.md',
  'docs/classic.md',
  'docs/materials.md',
  'docs/path.md',
  'docs/picture-files.md',
  'docs/sampler.md',
  'docs/scene-file.md',
  'docs/command-line.md',
  'docs/gltf.md',
  'docs/benchmarks.md',
];

export const readDocument = (path: string): string => readFileSync(`${root}${path}`, 'utf8').replaceAll('\r\n', '\n');

/** The contents of a document's code blocks that begin with ``` and exactly this. */
export function codeBlocks(path: string, kind: string): string[] {
  const blocks = readDocument(path).matchAll(/^```(.*)\n([\s\S]*?)^```$/gm);
  return [...blocks].filter(([, info]) => info === kind).map(([, , content]) => content!);
}
