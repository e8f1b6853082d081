/**
 * WESL modules → linked WGSL → GLSL ES 3.00, into packages/renderer/src/shading/generated; the tests' own programs into
 * tests/browser/harness/generated, a benchmark's into bench/gpu/traversal/generated. `--check` writes nothing and exits with 1 when a
 * committed file is stale.
 */
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { translate } from 'naga-wasm';
import { link } from 'wesl';
import { bentTableWgsl } from '../packages/renderer/src/packed-scene/bent-layout.ts';
import {
  fetchGeometryWgsl,
  fetchTexturesWgsl,
  fetchWgsl,
  structsWgsl,
} from '../packages/renderer/src/packed-scene/layout.ts';
import { MODEL_FEATURES } from '../packages/renderer/src/shading/features.ts';
import { withoutFeatures } from './without-features.ts';

const repository = resolve(dirname(fileURLToPath(import.meta.url)), '..');
const source = join(repository, 'packages/renderer/src');
const harness = join(repository, 'tests/browser/harness');
const bench = join(repository, 'bench/gpu/traversal');
const RENDERER_OUTPUT = 'packages/renderer/src/shading/generated';
const RELAY_OUTPUT = 'packages/renderer/src/integrator/path/generated';
const TESTS_OUTPUT = 'tests/browser/harness/generated';
const BENCH_OUTPUT = 'bench/gpu/traversal/generated';

interface Program {
  readonly name: string;
  readonly root: string;
  readonly entries: readonly { readonly entry: string; readonly stage: 'vertex' | 'fragment' }[];
  /** Default: RENDERER_OUTPUT. */
  readonly output?: string;
  /** For WebGL2 alone: its WGSL is what the GLSL is made of. */
  readonly webgl2Only?: boolean;
  /** There is a second text of it, `…_models.wgsl` and `…Models.glsl`, with everything; the first has what shapes need. */
  readonly models?: boolean;
}
/** Linked programs: the module that holds the entry points, and which of them WebGL2 needs. */
const PROGRAMS: readonly Program[] = [
  { name: 'classic', root: 'integrator/classic/classic', entries: [{ entry: 'classic', stage: 'fragment' }] },
  {
    name: 'preview',
    root: 'integrator/classic/preview',
    entries: [{ entry: 'preview', stage: 'fragment' }],
  },
  {
    name: 'path',
    root: 'integrator/path/path_entries',
    entries: [{ entry: 'path', stage: 'fragment' }],
    models: true,
  },
  {
    name: 'path_relay',
    root: 'integrator/path/path_relay',
    entries: [
      { entry: 'pathBegin', stage: 'fragment' },
      { entry: 'pathTrace', stage: 'fragment' },
      { entry: 'pathLight', stage: 'fragment' },
      { entry: 'pathScatter', stage: 'fragment' },
      { entry: 'pathEnd', stage: 'fragment' },
    ],
    output: RELAY_OUTPUT,
    webgl2Only: true,
  },
  {
    name: 'aov',
    root: 'integrator/aov/aov',
    entries: [
      { entry: 'aovFeatures', stage: 'fragment' },
      { entry: 'aovData', stage: 'fragment' },
    ],
    models: true,
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
  { name: 'film_error', root: 'film/film_error', entries: [{ entry: 'filmError', stage: 'fragment' }] },
  { name: 'aov_view', root: 'display/aov_view', entries: [{ entry: 'showAov', stage: 'fragment' }] },
  { name: 'bend', root: 'shading/mesh/bend', entries: [] },
  { name: 'trace_rays', root: 'bench/trace_rays', entries: [], output: BENCH_OUTPUT },
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
    name: 'texture_probe',
    root: 'tests/texture-probe',
    entries: [{ entry: 'textureProbe', stage: 'fragment' }],
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
  const written = {
    './shading/layout.wesl': structsWgsl(),
    './shading/scene_table.wesl': fetchWgsl(),
    './shading/mesh/geometry_table.wesl': fetchGeometryWgsl(),
    './shading/mesh/bent_table.wesl': bentTableWgsl(),
    './shading/texture/texture_table.wesl': fetchTexturesWgsl(),
  };
  return { ...modulesIn(source, ''), ...modulesIn(harness, 'tests/'), ...modulesIn(bench, 'bench/'), ...written };
}

/**
 * Switches (`override`) as naga can write them into GLSL: variables first, which `withSwitches` then makes constants. Whoever compiles
 * the program sets one by replacing its value (gpu/webgl2/program.ts).
 */
const SWITCH = /^override (\w+) = (true|false);/gm;
const asVariables = (wgsl: string) => wgsl.replace(SWITCH, 'var<private> $1: bool = $2;');
function withSwitches(glsl: string, wgsl: string): string {
  let text = glsl;
  for (const [, name] of wgsl.matchAll(SWITCH))
    text = text.replaceAll(
      new RegExp(`^( *)(bool (?:${name} = (?:true|false)|_e\\d+ = ${name});)$`, 'gm'),
      '$1const $2',
    );
  return text;
}

/**
 * WGSL's `&`, `|` and `select` evaluate both sides. naga writes them as `&&`, `||` and `?:`, for which a driver may make branches
 * when a side is more than a name: ANGLE does, and a software rasteriser behind it is slow with branches and takes minutes to compile
 * a thousand of them. A function's arguments are names, so it has none. (What WGSL does evaluate by need comes out of naga as an `if`.) naga puts
 * parentheses around every operation.
 */
function withoutShortCircuits(glsl: string): string {
  let text = replaceOperations(glsl, ' && ', (left, right) => `pick(${left}, ${right}, false)`);
  text = replaceOperations(text, ' || ', (left, right) => `pick(${left}, true, ${right})`);
  text = replaceOperations(text, ' ? ', (condition, rest) => {
    const middle = outside(rest, ' : ');
    return `pick(${condition}, ${rest.slice(0, middle)}, ${rest.slice(middle + 3)})`;
  });
  if (!text.includes('pick(')) return text;
  const one = (type: string) => `${type} pick(bool which, ${type} yes, ${type} no) { return which ? yes : no; }`;
  return text.replace(/^(precision .*\n)+/m, (lines) => `${lines}\n${PICKED.map(one).join('\n')}\n`);
}
const PICKED = ['bool', 'int', 'uint', 'float', 'vec2', 'vec3', 'vec4', 'uvec2'];

/** Every `(left operator right)`, parentheses included, by what `write` makes of it. */
function replaceOperations(glsl: string, operator: string, write: (left: string, right: string) => string): string {
  let text = glsl;
  for (let at = text.indexOf(operator); at >= 0; at = text.indexOf(operator)) {
    const open = parenthesisAround(text, at - 1, -1);
    const close = parenthesisAround(text, at + operator.length, 1);
    const written = write(text.slice(open + 1, at), text.slice(at + operator.length, close));
    text = text.slice(0, open) + written + text.slice(close + 1);
  }
  return text;
}

/** Where, seen from `from` in that direction, the parenthesis around it stands. */
function parenthesisAround(text: string, from: number, step: 1 | -1): number {
  const [deeper, out] = step > 0 ? '()' : ')(';
  let depth = 0;
  for (let i = from; i >= 0 && i < text.length; i += step) {
    if (text[i] === out && depth-- === 0) return i;
    if (text[i] === deeper) depth++;
  }
  throw new Error(`No parenthesis around …${text.slice(from - 40, from + 40)}…`);
}

/** The first place of `wanted` that is in no parentheses. */
function outside(text: string, wanted: string): number {
  let depth = 0;
  for (let i = 0; i < text.length; i++) {
    if (text[i] === '(') depth++;
    if (text[i] === ')') depth--;
    if (depth === 0 && text.startsWith(wanted, i)) return i;
  }
  throw new Error(`No "${wanted}" in ${text}`);
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

function glslOf(source: string, wgsl: string, entryPoint: string, stage: 'vertex' | 'fragment'): string {
  const glsl = translate({
    from: 'wgsl',
    to: 'glsl',
    source: asVariables(source),
    options: { version: '300 es', stage, entryPoint, flags: { adjustCoordinateSpace: false } },
  });
  return readableGlsl(withoutShortCircuits(withSwitches(glsl, wgsl)), wgsl);
}

const READS_DATA = /textureSampleLevel\((geometry|texels),/;

async function generate(): Promise<Record<string, string>> {
  const weslSrc = weslModules();
  const files: Record<string, string> = {
    'packages/renderer/src/shading/layout.wesl': structsWgsl(),
    'packages/renderer/src/shading/scene_table.wesl': fetchWgsl(),
    'packages/renderer/src/shading/mesh/geometry_table.wesl': fetchGeometryWgsl(),
    'packages/renderer/src/shading/mesh/bent_table.wesl': bentTableWgsl(),
    'packages/renderer/src/shading/texture/texture_table.wesl': fetchTexturesWgsl(),
  };
  for (const { name, root, entries, output = RENDERER_OUTPUT, models, webgl2Only = false } of PROGRAMS) {
    const linkedFor = async (conditions: Record<string, boolean>) =>
      (await link({ weslSrc, conditions, rootModuleName: `./${root}.wesl` })).dest.trim();
    const computed = await linkedFor({ compute: !webgl2Only, sampled: false });
    const sampled = await linkedFor({ compute: false, sampled: true });
    const drawn = await linkedFor({ compute: false, sampled: false });
    const write = (suffix: string, capital: string, off: readonly string[]) => {
      const head = `// Linked from ${root}.wesl by \`npm run shaders\`. Do not edit.\n`;
      const wgsl = `${head}${withoutFeatures(computed, off)}\n`;
      files[`${output}/${name}${suffix}.wgsl`] = wgsl;
      // Another text where WebGPU draws in software, for what reads data: gpu/device.ts, PassSource.
      const software = withoutFeatures(sampled, off);
      if (entries.length > 0 && !webgl2Only && READS_DATA.test(software))
        files[`${output}/${name}${suffix}_sampled.wgsl`] = `${head}${software}\n`;
      // naga does not write GLSL ES 3.00 of a module in which there is a compute pass.
      const source = withoutFeatures(drawn, off);
      for (const { entry, stage } of entries)
        files[`${output}/${entry}${capital}.glsl`] = glslOf(source, wgsl, entry, stage);
    };
    write('', '', models ? MODEL_FEATURES : []);
    if (models) write('_models', 'Models', []);
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
