import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { shaderText } from './shader-text.mjs';

const source = fileURLToPath(new URL('../packages/renderer/src/', import.meta.url));
const studio = fileURLToPath(new URL('../apps/studio/src/', import.meta.url));
const modules = fileURLToPath(new URL('../node_modules/', import.meta.url));

/**
 * @typedef {object} Part
 * @property {string} name
 * @property {string} importer the file that asks for it
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
    name: 'chinese',
    importer: join(studio, 'said-in-chinese.ts'),
    asked: './chinese-tables.ts',
    entry: join(studio, 'chinese-tables.ts'),
  },
  {
    name: 'opening',
    importer: join(studio, 'opening/open-in-worker.ts'),
    asked: './start-job.ts',
    entry: join(studio, 'opening/start-job.ts'),
  },
  {
    name: 'still',
    importer: join(source, 'cpu-renderer.ts'),
    asked: './reference/reference-renderer.ts',
    entry: join(source, 'reference/reference-renderer.ts'),
  },
  {
    name: 'meshes',
    importer: join(source, 'packed-scene/geometry-packer.ts'),
    asked: './pack-geometry.ts',
    entry: join(source, 'packed-scene/pack-geometry.ts'),
  },
  {
    name: 'model-shaders',
    importer: join(source, 'shading/program-text.ts'),
    asked: './model-shaders.ts',
    entry: join(source, 'shading/model-shaders.ts'),
  },
  {
    name: 'mesh-files',
    importer: join(source, 'scene-file/load-meshes.ts'),
    asked: '../mesh-file/mesh-file.ts',
    entry: join(source, 'mesh-file/mesh-file.ts'),
  },
  {
    name: 'images',
    importer: join(source, 'scene-file/load-files.ts'),
    asked: './load-images.ts',
    entry: join(source, 'scene-file/load-images.ts'),
  },
  {
    name: 'models',
    importer: join(source, 'scene-file/load-files.ts'),
    asked: './load-models.ts',
    entry: join(source, 'scene-file/load-models.ts'),
  },
  {
    name: 'mesh-files',
    importer: join(source, 'mesh-model/mesh-scene.ts'),
    asked: '../mesh-file/mesh-file.ts',
    entry: join(source, 'mesh-file/mesh-file.ts'),
  },
  {
    name: 'mesh-models',
    importer: join(source, 'scene-file/load-models.ts'),
    asked: '../mesh-model/mesh-scene.ts',
    entry: join(source, 'mesh-model/mesh-scene.ts'),
  },
  {
    name: 'gltf',
    importer: join(source, 'gltf/index.ts'),
    asked: './read-gltf.ts',
    entry: join(source, 'gltf/read-gltf.ts'),
  },
  {
    name: 'ktx2',
    importer: join(source, 'gltf/images/decoder.ts'),
    asked: './ktx2-decoder.ts',
    entry: join(source, 'gltf/images/ktx2-decoder.ts'),
  },
  {
    name: 'draco',
    importer: join(source, 'gltf/decoders.ts'),
    asked: './draco-decoder.ts',
    entry: join(source, 'gltf/draco-decoder.ts'),
  },
  {
    name: 'meshopt',
    importer: join(source, 'gltf/decoders.ts'),
    asked: 'meshoptimizer/decoder',
    entry: join(modules, 'meshoptimizer/meshopt_decoder.mjs'),
  },
  {
    name: 'tangents',
    importer: join(source, 'gltf/mesh/tangents.ts'),
    asked: 'meshoptimizer/tangents',
    entry: join(modules, 'meshoptimizer/meshopt_tangents.js'),
  },
];

/** What answers workers that ask for parts, which there are in a page of one file only. */
const ANSWERING = join(studio, 'opening/answer-parts.ts').replaceAll('\\', '/');

/** Where the loader in the page comes from. */
const LOADER = 'virtual:load-part';

/**
 * For Vite. A dynamic import of one of the parts becomes
 *
 * - `page`: a classic script beside the page, which a browser loads from a folder on the disk too, as it does no module;
 * - `library`: an import of a file beside the module, mirrorball-gltf.js and so on.
 *
 * Parts that nothing of the page asks for are left out. Workers ask the page for parts: see `answerParts` in the loader below.
 * @param {'page' | 'library'} as
 * @returns {import('vite').Plugin}
 */
export function lazyParts(as) {
  /** @type {Map<string, string>} name → code of what is written */
  const written = new Map();
  return {
    ...partImports(as, written),
    generateBundle: {
      order: 'post',
      handler() {
        for (const [name, code] of written)
          this.emitFile({ type: 'asset', fileName: fileOf(name), source: as === 'page' ? scriptOf(name, code) : code });
      },
    },
  };
}

const fileOf = (/** @type {string} */ name) => `mirrorball-${name}.js`;

/** Leaves the code as text: the loader makes modules of it, in the page and in its workers. @param {string} name @param {string} code */
const scriptOf = (name, code) => `(self.mirrorballParts ??= {})[${JSON.stringify(name)}] = ${JSON.stringify(code)};\n`;

/**
 * What the page and its parts have in common: imports of parts are replaced, and those that are asked for are built.
 * @param {'page' | 'library'} as
 * @param {Map<string, string>} written
 * @returns {import('vite').Plugin}
 */
function partImports(as, written) {
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
        if (as === 'page' && id === ANSWERING) return `export { answerParts } from '${LOADER}';`;
        return id.endsWith('.wasm?url&inline') ? byteText(id) : null;
      },
    },
    transform: {
      order: 'pre',
      handler(code, id) {
        const parts = partsAskedBy(id);
        if (parts.length === 0) return null;
        const text = parts.reduce((before, part) => replaced(before, part, as), code);
        return { code: as === 'page' ? `import { loadPart } from '${LOADER}';\n${text}` : text, map: null };
      },
    },
    async renderChunk(_, chunk) {
      // Not what tree shaking has left out.
      const used = Object.entries(chunk.modules).filter(([, { renderedLength }]) => renderedLength > 0);
      for (const part of used.flatMap(([id]) => partsAskedBy(id))) {
        if (written.has(part.name)) continue;
        written.set(part.name, '');
        written.set(part.name, await buildPart(part, as, written));
      }
      return null;
    },
  };
}

/** @param {string} id */
function partsAskedBy(id) {
  const file = id.split('?')[0]?.replaceAll('\\', '/');
  return PARTS.filter(({ importer }) => file === importer.replaceAll('\\', '/'));
}

/** What asks for it. @param {Part} part */
const callOf = (part) => new RegExp(`import\\((['"])${part.asked.replaceAll('.', '\\.')}\\1\\)`, 'g');

/** @param {string} code @param {Part} part @param {'page' | 'library'} as */
function replaced(code, part, as) {
  const call = callOf(part);
  if (!call.test(code))
    throw new Error(`${part.importer} has no import('${part.asked}') any more: see scripts/lazy-parts.mjs.`);
  return code.replace(call, as === 'page' ? `loadPart('${part.name}')` : `import('./${fileOf(part.name)}')`);
}

/** A letter for each byte: compression finds what repeats in it, which base64 hides. A third smaller. */
function byteText(/** @type {string} */ id) {
  const bytes = readFileSync(id.split('?')[0] ?? '');
  return `export default ${JSON.stringify(bytes.toString('latin1'))};`;
}

/** @param {Part} part @param {'page' | 'library'} as @param {Map<string, string>} written */
async function buildPart(part, as, written) {
  // Not above: build-studio.mjs takes a name from here before the packages are installed.
  const { build } = await import('vite');
  const result = await build({
    configFile: false,
    root: dirname(part.entry),
    logLevel: 'error',
    plugins: [shaderText(), partImports(as, written)],
    // A worker in a part is text in it, and a classic one: from a file a browser starts no other.
    worker: {
      format: 'iife',
      plugins: () => [partImports(as, written)],
      rolldownOptions: { output: { codeSplitting: false } },
    },
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

/** Runs in the page, in parts, as they may need parts, and in workers, which see no page and ask it by a message. */
const LOADER_CODE = `
const beside = (name) => new Promise((resolve, reject) => {
  const code = () => self.mirrorballParts?.[name];
  const missing = 'mirrorball-' + name + '.js is missing: it belongs into the folder of this page.';
  const end = () => {
    if (code() === undefined) return reject(new Error(missing));
    // As a blob it is no burden on the page's heap any more.
    if (typeof code() === 'string') self.mirrorballParts[name] = new Blob([code()]);
    resolve(code());
  };
  if (code() !== undefined) return end();
  const script = document.createElement('script');
  script.src = 'mirrorball-' + name + '.js';
  script.onload = script.onerror = () => {
    script.remove();
    end();
  };
  document.head.append(script);
});
const asked = (name) => new Promise((resolve, reject) => {
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = ({ data }) => {
    port1.close();
    if (data.code) resolve(data.code);
    else reject(new Error(data.problem));
  };
  postMessage({ part: name }, [port2]);
});
export function answerParts(worker) {
  worker.addEventListener('message', async ({ data, ports }) => {
    if (!data || typeof data.part !== 'string') return;
    try {
      ports[0].postMessage({ code: await beside(data.part) });
    } catch (error) {
      ports[0].postMessage({ problem: error.message });
    }
  });
}
async function load(name) {
  const code = await (typeof document === 'undefined' ? asked(name) : beside(name));
  const url = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  try {
    return await import(/* @vite-ignore */ url);
  } finally {
    URL.revokeObjectURL(url);
  }
}
const loads = new Map();
export function loadPart(name) {
  if (!loads.has(name)) {
    loads.set(name, load(name));
    // What was missing may be there the next time.
    loads.get(name).catch(() => loads.delete(name));
  }
  return loads.get(name);
}
`;
