import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { deflateSync } from 'node:zlib';
import { shaderText } from './shader-text.mjs';

const source = fileURLToPath(new URL('../packages/renderer/src/', import.meta.url));
const modules = fileURLToPath(new URL('../node_modules/', import.meta.url));

/**
 * @typedef {object} Part
 * @property {string} name
 * @property {string} importer the one file that asks for it, from the renderer's sources on
 * @property {string} asked what stands in its `import()`
 * @property {string} entry
 */

/**
 * What a page may need later, or never. Each is built by itself with all that it needs: what it shares with the page it has twice, which
 * costs some kilobytes and saves the page from being cut into chunks.
 * @type {readonly Part[]}
 */
const PARTS = [
  {
    name: 'still',
    importer: 'cpu-renderer.ts',
    asked: './reference/reference-renderer.ts',
    entry: join(source, 'reference/reference-renderer.ts'),
  },
  {
    name: 'meshes',
    importer: 'packed-scene/geometry-packer.ts',
    asked: './pack-geometry.ts',
    entry: join(source, 'packed-scene/pack-geometry.ts'),
  },
  {
    name: 'model-shaders',
    importer: 'shading/program-text.ts',
    asked: './model-shaders.ts',
    entry: join(source, 'shading/model-shaders.ts'),
  },
  {
    name: 'mesh-files',
    importer: 'scene-file/load-meshes.ts',
    asked: '../mesh-file/mesh-file.ts',
    entry: join(source, 'mesh-file/mesh-file.ts'),
  },
  {
    name: 'images',
    importer: 'scene-file/load-files.ts',
    asked: './load-images.ts',
    entry: join(source, 'scene-file/load-images.ts'),
  },
  {
    name: 'models',
    importer: 'scene-file/load-files.ts',
    asked: './load-models.ts',
    entry: join(source, 'scene-file/load-models.ts'),
  },
  { name: 'gltf', importer: 'gltf/index.ts', asked: './read-gltf.ts', entry: join(source, 'gltf/read-gltf.ts') },
  {
    name: 'ktx2',
    importer: 'gltf/images/decoder.ts',
    asked: './ktx2-decoder.ts',
    entry: join(source, 'gltf/images/ktx2-decoder.ts'),
  },
  {
    name: 'draco',
    importer: 'gltf/decoders.ts',
    asked: './draco-decoder.ts',
    entry: join(source, 'gltf/draco-decoder.ts'),
  },
  {
    name: 'meshopt',
    importer: 'gltf/decoders.ts',
    asked: 'meshoptimizer/decoder',
    entry: join(modules, 'meshoptimizer/meshopt_decoder.mjs'),
  },
  {
    name: 'tangents',
    importer: 'gltf/mesh/tangents.ts',
    asked: 'meshoptimizer/tangents',
    entry: join(modules, 'meshoptimizer/meshopt_tangents.js'),
  },
];

/** Where the loader in the page comes from. */
const LOADER = 'virtual:load-part';

/**
 * For Vite. A dynamic import of one of the parts becomes
 *
 * - `text`: text at the end of the one HTML file, compressed, which the browser neither parses nor unpacks before it is asked for, and
 *   for which the page's own script does not wait;
 * - `file`: an import of a file beside the module, mirrorball-gltf.js and so on.
 *
 * Parts that nothing of the page asks for are left out, and so are those named in `without`, which only `ktx2` may be: then the code that
 * asks for it knows.
 * @param {'text' | 'file'} as
 * @param {{ without?: readonly 'ktx2'[] }} [options]
 * @returns {import('vite').Plugin}
 */
export function lazyParts(as, { without = [] } = {}) {
  /** @type {Map<string, string>} name → code of what is written */
  const written = new Map();
  return {
    ...partImports(as, written, without),
    generateBundle: {
      order: 'post',
      handler(_, bundle) {
        if (as === 'file')
          for (const [name, code] of written) this.emitFile({ type: 'asset', fileName: fileOf(name), source: code });
        for (const file of Object.values(bundle))
          if (as === 'text' && file.type === 'asset' && file.fileName.endsWith('.html'))
            file.source = withParts(String(file.source), written);
      },
    },
  };
}

const fileOf = (/** @type {string} */ name) => `mirrorball-${name}.js`;

/**
 * What the page and its parts have in common: imports of parts are replaced, and those that are asked for are built.
 * @param {'text' | 'file'} as
 * @param {Map<string, string>} written
 * @param {readonly string[]} without
 * @returns {import('vite').Plugin}
 */
function partImports(as, written, without) {
  return {
    name: 'lazy-parts',
    apply: 'build',
    enforce: 'post',
    resolveId: {
      order: 'pre',
      handler(id) {
        if (id === LOADER) return `\0${LOADER}`;
        // Files beside the module are found when it runs.
        return PARTS.some(({ name }) => id === `./${fileOf(name)}`) ? { id, external: true } : null;
      },
    },
    load: {
      order: 'pre',
      handler(id) {
        if (id === `\0${LOADER}`) return LOADER_CODE;
        return id.endsWith('.wasm?url&inline') ? byteText(id) : null;
      },
    },
    transform: {
      order: 'pre',
      handler(code, id) {
        const parts = partsAskedBy(id);
        if (parts.length === 0) return null;
        const text = parts.reduce(
          (before, part) => (without.includes(part.name) ? withoutPart(before, part) : replaced(before, part, as)),
          code,
        );
        return { code: as === 'text' ? `import { loadPart } from '${LOADER}';\n${text}` : text, map: null };
      },
    },
    async renderChunk(_, chunk) {
      // Not what tree shaking has left out.
      const used = Object.entries(chunk.modules).filter(([, { renderedLength }]) => renderedLength > 0);
      for (const part of used.flatMap(([id]) => partsAskedBy(id))) {
        if (written.has(part.name) || without.includes(part.name)) continue;
        written.set(part.name, '');
        written.set(part.name, await buildPart(part, as, written, without));
      }
      return null;
    },
  };
}

/** @param {string} id */
function partsAskedBy(id) {
  const file = id.split('?')[0]?.replaceAll('\\', '/');
  return PARTS.filter(({ importer }) => file === `${source.replaceAll('\\', '/')}${importer}`);
}

/** @param {string} code @param {Part} part @param {'text' | 'file'} as */
function replaced(code, part, as) {
  const call = new RegExp(`import\\((['"])${part.asked.replaceAll('.', '\\.')}\\1\\)`);
  if (!call.test(code))
    throw new Error(`${part.importer} has no import('${part.asked}') any more: see scripts/lazy-parts.mjs.`);
  return code.replace(call, as === 'text' ? `loadPart('${part.name}')` : `import('./${fileOf(part.name)}')`);
}

/** The code says by a constant whether the part is at hand. @param {string} code @param {Part} part */
function withoutPart(code, part) {
  const flag = `const HAS_${part.name.toUpperCase()} = true`;
  if (!code.includes(flag)) throw new Error(`${part.importer} has no ${flag} any more: see scripts/lazy-parts.mjs.`);
  return code.replace(flag, flag.replace('true', 'false'));
}

/** A letter for each byte: compression finds what repeats in it, which base64 hides. A third smaller. */
function byteText(/** @type {string} */ id) {
  const bytes = readFileSync(id.split('?')[0] ?? '');
  return `export default ${JSON.stringify(bytes.toString('latin1'))};`;
}

/** @param {Part} part @param {'text' | 'file'} as @param {Map<string, string>} written @param {readonly string[]} without */
async function buildPart(part, as, written, without) {
  // Not above: build-studio.mjs takes a name from here before the packages are installed.
  const { build } = await import('vite');
  const result = await build({
    configFile: false,
    root: dirname(part.entry),
    logLevel: 'error',
    plugins: [shaderText(), partImports(as, written, without)],
    build: {
      write: false,
      target: 'es2022',
      modulePreload: false,
      reportCompressedSize: false,
      rolldownOptions: {
        input: part.entry,
        preserveEntrySignatures: 'strict',
        output: { format: 'es', codeSplitting: false, entryFileNames: `${part.name}.js` },
      },
    },
  });
  const output = [result].flat().flatMap((one) => ('output' in one ? one.output : []));
  const chunk = output.find((one) => one.type === 'chunk');
  if (chunk?.type !== 'chunk') throw new Error(`The part ${part.name} has not been built.`);
  return chunk.code;
}

/** What stands before the first part: build-studio.mjs measures up to here what every visitor waits for. */
export const PARTS_START = '<!-- What comes when it is needed -->';

/**
 * @param {string} html
 * @param {ReadonlyMap<string, string>} parts
 */
function withParts(html, parts) {
  if (parts.size === 0) return html;
  const texts = [...parts].map(([name, code]) => {
    const packed = deflateSync(Buffer.from(code), { level: 9 }).toString('base64');
    return `<script type="text/plain" id="part-${name}">${packed}</script>`;
  });
  const { script, rest } = cutOut(html);
  const end = rest.lastIndexOf('</body>');
  return `${rest.slice(0, end)}${script}\n${PARTS_START}\n${texts.join('\n')}\n${rest.slice(end)}`;
}

/**
 * The page's own script, and the page without it. A module script waits for the end of the page unless it is async; then it has to stand
 * behind what it looks for.
 * @param {string} html
 */
function cutOut(html) {
  const start = html.indexOf('<script type="module"');
  const end = html.indexOf('</script>', start) + '</script>'.length;
  if (start < 0 || html.indexOf('<script type="module"', end) >= 0)
    throw new Error('The page should have one module script.');
  const script = html.slice(start, end).replace('<script type="module"', '<script type="module" async');
  return { script, rest: html.slice(0, start) + html.slice(end) };
}

/** Runs in the page, and, as parts may need parts, in parts. */
const LOADER_CODE = `
const text = (name) => document.getElementById('part-' + name);
const parsed = () => new Promise((resolve) => {
  if (document.readyState !== 'loading') resolve();
  else addEventListener('DOMContentLoaded', resolve, { once: true });
});
async function load(name) {
  if (!text(name)) await parsed();
  const element = text(name);
  if (!element) throw new Error('This page has been cut off: its part "' + name + '" is missing.');
  // The end tag may still be under way.
  if (!element.nextSibling) await parsed();
  const bytes = Uint8Array.from(atob(element.textContent), (letter) => letter.charCodeAt(0));
  const code = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'))).blob();
  const url = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  try {
    return await import(/* @vite-ignore */ url);
  } finally {
    URL.revokeObjectURL(url);
  }
}
const loads = new Map();
export function loadPart(name) {
  if (!loads.has(name)) loads.set(name, load(name));
  return loads.get(name);
}
`;
