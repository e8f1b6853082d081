/**
 * WESL modules → linked WGSL → GLSL ES 3.00, into packages/renderer/src/shading/generated. `--check` writes nothing and
 * exits with 1 when a committed file is stale.
 */
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { translate } from 'naga-wasm';
import { link } from 'wesl';
import { fetchWgsl, structsWgsl } from '../packages/renderer/src/packed-scene/layout.ts';

const source = resolve(dirname(fileURLToPath(import.meta.url)), '../packages/renderer/src');

/** Linked programs: the module that holds the entry points, and what WebGL2 needs of each. */
const PROGRAMS = [
  { name: 'classic', root: 'integrator/classic/classic', entries: [{ entry: 'classic', stage: 'fragment' }] },
  {
    name: 'preview',
    root: 'integrator/classic/preview',
    entries: [{ entry: 'preview', stage: 'fragment' }],
  },
  { name: 'full_screen', root: 'shading/full_screen', entries: [{ entry: 'fullScreen', stage: 'vertex' }] },
  {
    name: 'display',
    root: 'display/display',
    entries: [
      { entry: 'screen', stage: 'vertex' },
      { entry: 'show', stage: 'fragment' },
    ],
  },
] as const;

function weslModules(): Record<string, string> {
  const modules: Record<string, string> = {};
  for (const entry of readdirSync(source, { recursive: true, withFileTypes: true })) {
    if (!entry.isFile() || !entry.name.endsWith('.wesl')) continue;
    const path = join(entry.parentPath, entry.name);
    modules[`./${relative(source, path).replaceAll('\\', '/')}`] = readFileSync(path, 'utf8').replaceAll('\r\n', '\n');
  }
  return { ...modules, './shading/layout.wesl': structsWgsl(), './shading/scene_table.wesl': fetchWgsl() };
}

/** naga names blocks `Frame_block_0Fragment` and samplers `_group_0_binding_4_fs`; give them the WGSL names again. */
function readableGlsl(glsl: string, wgsl: string): string {
  let text = glsl.replace(/\b(\w+)_block_\d+(Fragment|Vertex)\b/g, '$1Block');
  for (const [, group, binding, name] of wgsl.matchAll(
    /@group\((\d+)\)\s*@binding\((\d+)\)\s*var(?:<[^>]*>)?\s+(\w+)/g,
  ))
    text = text.replaceAll(new RegExp(`\\b_group_${group}_binding_${binding}_(fs|vs)\\b`, 'g'), name!);
  return text;
}

async function generate(): Promise<Record<string, string>> {
  const weslSrc = weslModules();
  const files: Record<string, string> = {
    'shading/layout.wesl': structsWgsl(),
    'shading/scene_table.wesl': fetchWgsl(),
  };
  for (const { name, root, entries } of PROGRAMS) {
    const linked = await link({ weslSrc, rootModuleName: `./${root}.wesl` });
    const wgsl = `// Linked from ${root}.wesl by \`npm run shaders\`. Do not edit.\n${linked.dest.trim()}\n`;
    files[`shading/generated/${name}.wgsl`] = wgsl;
    for (const { entry, stage } of entries) {
      const glsl = translate({
        from: 'wgsl',
        to: 'glsl',
        source: wgsl,
        options: { version: '300 es', stage, entryPoint: entry, flags: { adjustCoordinateSpace: false } },
      });
      files[`shading/generated/${entry}.glsl`] = readableGlsl(glsl, wgsl);
    }
  }
  return files;
}

const check = process.argv.includes('--check');
const stale: string[] = [];
for (const [path, text] of Object.entries(await generate())) {
  const file = join(source, path);
  let old = '';
  try {
    old = readFileSync(file, 'utf8').replaceAll('\r\n', '\n');
  } catch {}
  if (old === text) continue;
  stale.push(path);
  if (check) continue;
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, text);
}
if (check && stale.length > 0) {
  console.error(`Stale generated shaders, run \`npm run shaders\`:\n${stale.map((s) => `  ${s}`).join('\n')}`);
  process.exit(1);
}
console.log(stale.length === 0 ? 'Shaders are up to date.' : `Wrote ${stale.join(', ')}`);
