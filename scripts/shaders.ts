/**
 * WESL modules → linked WGSL → GLSL ES 3.00, into packages/renderer/src/shading/generated, and the tests' own programs into
 * tests/browser/harness/generated. `--check` writes nothing and exits with 1 when a committed file is stale.
 */
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { translate } from 'naga-wasm';
import { link } from 'wesl';
import { fetchWgsl, structsWgsl } from '../packages/renderer/src/packed-scene/layout.ts';

const repository = resolve(dirname(fileURLToPath(import.meta.url)), '..');
const source = join(repository, 'packages/renderer/src');
const harness = join(repository, 'tests/browser/harness');
const RENDERER_OUTPUT = 'packages/renderer/src/shading/generated';
const TESTS_OUTPUT = 'tests/browser/harness/generated';

interface Program {
  readonly name: string;
  readonly root: string;
  readonly entries: readonly { readonly entry: string; readonly stage: 'vertex' | 'fragment' }[];
  /** Default: RENDERER_OUTPUT. */
  readonly output?: string;
}
/** Linked programs: the module that holds the entry points, and what WebGL2 needs of each. */
const PROGRAMS: readonly Program[] = [
  { name: 'classic', root: 'integrator/classic/classic', entries: [{ entry: 'classic', stage: 'fragment' }] },
  {
    name: 'preview',
    root: 'integrator/classic/preview',
    entries: [{ entry: 'preview', stage: 'fragment' }],
  },
  { name: 'path', root: 'integrator/path/path', entries: [{ entry: 'path', stage: 'fragment' }] },
  {
    name: 'aov',
    root: 'integrator/aov/aov',
    entries: [
      { entry: 'aovFeatures', stage: 'fragment' },
      { entry: 'aovData', stage: 'fragment' },
    ],
  },
  { name: 'full_screen', root: 'shading/full_screen', entries: [{ entry: 'fullScreen', stage: 'vertex' }] },
  {
    name: 'display',
    root: 'display/display',
    entries: [
      { entry: 'screen', stage: 'vertex' },
      { entry: 'show', stage: 'fragment' },
      { entry: 'showMapped', stage: 'fragment' },
    ],
  },
  { name: 'aov_view', root: 'display/aov_view', entries: [{ entry: 'showAov', stage: 'fragment' }] },
  {
    name: 'camera_probe',
    root: 'tests/camera-probe',
    entries: [{ entry: 'cameraProbe', stage: 'fragment' }],
    output: TESTS_OUTPUT,
  },
  {
    name: 'shape_probe',
    root: 'tests/shape-probe',
    entries: [{ entry: 'shapeProbe', stage: 'fragment' }],
    output: TESTS_OUTPUT,
  },
  {
    name: 'emitter_probe',
    root: 'tests/emitter-probe',
    entries: [{ entry: 'emitterProbe', stage: 'fragment' }],
    output: TESTS_OUTPUT,
  },
  {
    name: 'bsdf_probe',
    root: 'tests/bsdf-probe',
    entries: [{ entry: 'bsdfProbe', stage: 'fragment' }],
    output: TESTS_OUTPUT,
  },
  {
    name: 'sampler_probe',
    root: 'tests/sampler-probe',
    entries: [{ entry: 'samplerProbe', stage: 'fragment' }],
    output: TESTS_OUTPUT,
  },
];

/** The modules below a folder, by their path from it with `prefix` in front. */
function modulesIn(folder: string, prefix: string): Record<string, string> {
  const modules: Record<string, string> = {};
  for (const entry of readdirSync(folder, { recursive: true, withFileTypes: true })) {
    if (!entry.isFile() || !entry.name.endsWith('.wesl')) continue;
    const path = join(entry.parentPath, entry.name);
    const text = readFileSync(path, 'utf8').replaceAll('\r\n', '\n');
    modules[`./${prefix}${relative(folder, path).replaceAll('\\', '/')}`] = text;
  }
  return modules;
}

function weslModules(): Record<string, string> {
  const written = { './shading/layout.wesl': structsWgsl(), './shading/scene_table.wesl': fetchWgsl() };
  return { ...modulesIn(source, ''), ...modulesIn(harness, 'tests/'), ...written };
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
    'packages/renderer/src/shading/layout.wesl': structsWgsl(),
    'packages/renderer/src/shading/scene_table.wesl': fetchWgsl(),
  };
  for (const { name, root, entries, output = RENDERER_OUTPUT } of PROGRAMS) {
    const linked = await link({ weslSrc, rootModuleName: `./${root}.wesl` });
    const wgsl = `// Linked from ${root}.wesl by \`npm run shaders\`. Do not edit.\n${linked.dest.trim()}\n`;
    files[`${output}/${name}.wgsl`] = wgsl;
    for (const { entry, stage } of entries) {
      const glsl = translate({
        from: 'wgsl',
        to: 'glsl',
        source: wgsl,
        options: { version: '300 es', stage, entryPoint: entry, flags: { adjustCoordinateSpace: false } },
      });
      files[`${output}/${entry}.glsl`] = readableGlsl(glsl, wgsl);
    }
  }
  return files;
}

const check = process.argv.includes('--check');
const stale: string[] = [];
for (const [path, text] of Object.entries(await generate())) {
  const file = join(repository, path);
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
