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
 * @property {'page'} [only] a library has it in its start anyway, as it exports it
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
    name: 'saving',
    importer: join(studio, 'saving/load-written.ts'),
    asked: './write-in-worker.ts',
    entry: join(studio, 'saving/write-in-worker.ts'),
  },
  {
    name: 'scene-tools',
    importer: join(studio, 'load-scene-tools.ts'),
    asked: './scene-tools.ts',
    entry: join(studio, 'scene-tools.ts'),
  },
  {
    name: 'scene-reader',
    importer: join(source, 'scene-file/usable-scene.ts'),
    asked: './require-scene.ts',
    entry: join(source, 'scene-file/require-scene.ts'),
    only: 'page',
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
    name: 'path-relay',
    importer: join(source, 'integrator/path/path-programs.ts'),
    asked: './path-relay.ts',
    entry: join(source, 'integrator/path/path-relay.ts'),
  },
  {
    name: 'bender',
    importer: join(source, 'stages.ts'),
    asked: './bender.ts',
    entry: join(source, 'bender.ts'),
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
    ...partImports(as, written, LOADER_OF_PAGE),
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

/** Leaves the code as text: the loader runs it, in the page and in its workers. @param {string} name @param {string} code */
const scriptOf = (name, code) => `(self.mirrorballParts ??= {})[${JSON.stringify(name)}] = ${JSON.stringify(code)};\n`;

/**
 * What the page and its parts have in common: imports of parts are replaced, and those that are asked for are built.
 * @param {'page' | 'library'} as
 * @param {Map<string, string>} written
 * @param {string} loader how parts are loaded there, in a page
 * @returns {import('vite').Plugin}
 */
function partImports(as, written, loader) {
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
        if (id === `\0${LOADER}`) return loader;
        if (as === 'page' && id === ANSWERING) return `export { answerParts } from '${LOADER}';`;
        return id.endsWith('.wasm?url&inline') ? byteText(id) : null;
      },
    },
    transform: {
      order: 'pre',
      handler(code, id) {
        const parts = partsAskedBy(id, as);
        if (parts.length === 0) return null;
        const text = parts.reduce((before, part) => replaced(before, part, as), code);
        return { code: as === 'page' ? `import { loadPart } from '${LOADER}';\n${text}` : text, map: null };
      },
    },
    async renderChunk(_, chunk) {
      // Not what tree shaking has left out.
      const used = Object.entries(chunk.modules).filter(([, { renderedLength }]) => renderedLength > 0);
      for (const part of used.flatMap(([id]) => partsAskedBy(id, as))) {
        if (written.has(part.name)) continue;
        written.set(part.name, '');
        written.set(part.name, await buildPart(part, as, written));
      }
      return null;
    },
  };
}

/** @param {string} id @param {'page' | 'library'} as */
function partsAskedBy(id, as) {
  const file = id.split('?')[0]?.replaceAll('\\', '/');
  return PARTS.filter(({ importer, only = as }) => only === as && file === importer.replaceAll('\\', '/'));
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

/**
 * How a part gives what it exports: see the loader below.
 * @type {Record<'page' | 'library', import('vite').Rolldown.OutputOptions>}
 */
const FORMAT = { page: { format: 'iife', name: 'mirrorballPart', exports: 'named' }, library: { format: 'es' } };

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
    plugins: [shaderText(), partImports(as, written, LOADER_OF_PARTS)],
    // A worker in a part is text in it, and a classic one: from a file a browser starts no other.
    worker: {
      format: 'iife',
      plugins: () => [partImports(as, written, LOADER_OF_PARTS)],
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
        output: { ...FORMAT[as], codeSplitting: false, entryFileNames: `${part.name}.js` },
      },
    },
  });
  const output = [result].flat().flatMap((one) => ('output' in one ? one.output : []));
  const chunk = output.find((one) => one.type === 'chunk');
  if (chunk?.type !== 'chunk') throw new Error(`The part ${part.name} has not been built.`);
  return chunk.code;
}

/**
 * In the page. A part is a classic script and no module: a browser keeps modules with all of their text as long as the page, and a script only
 * while something of it is in use. So nothing here holds for good what a part has given.
 */
const PAGE_LOADER = `
const run = (url) => new Promise((resolve) => {
  const script = document.createElement('script');
  script.src = url;
  // Also where the page does not say what it is written in.
  script.charset = 'utf-8';
  script.onload = script.onerror = () => {
    script.remove();
    resolve();
  };
  document.head.append(script);
});
async function ran(blob, run) {
  const url = URL.createObjectURL(blob);
  try {
    await run(url);
  } finally {
    URL.revokeObjectURL(url);
  }
  const part = self.mirrorballPart;
  self.mirrorballPart = null;
  return part;
}
async function beside(name) {
  const codes = (self.mirrorballParts ??= {});
  if (!codes[name]) {
    const file = 'mirrorball-' + name + '.js';
    // A script element's text from a server stays on the heap, for hints about what to compile the next time.
    if (location.protocol === 'file:') await run(file);
    else await fetch(file).then(async (answer) => answer.ok && ran(await answer.blob(), run), () => {});
    if (!codes[name]) throw new Error(file + ' is missing: it belongs into the folder of this page.');
  }
  // As a blob it is no burden on the page's heap.
  return (codes[name] = new Blob([codes[name]], { type: 'text/javascript' }));
}
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
const parts = new Map();
async function inPage(name) {
  const known = parts.get(name);
  let part = known instanceof WeakRef ? known.deref() : known;
  if (!part) {
    part = beside(name).then((code) => ran(code, run));
    parts.set(name, part);
    // What was missing may be there the next time.
    part.then((part) => parts.set(name, new WeakRef(part)), () => parts.delete(name));
  }
  return part;
}
`;

/** In the page's own code. */
const LOADER_OF_PAGE = `${PAGE_LOADER}
export { inPage as loadPart };
`;

/** In parts, as they may need parts, and in workers, which see no page and ask it by a message; they end when they have nothing to do. */
const LOADER_OF_PARTS = `${PAGE_LOADER}
const asked = (name) => new Promise((resolve, reject) => {
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = ({ data }) => {
    port1.close();
    if (data.code) resolve(data.code);
    else reject(new Error(data.problem));
  };
  postMessage({ part: name }, [port2]);
});
async function inWorker(name) {
  if (!parts.has(name)) {
    parts.set(name, asked(name).then((code) => ran(code, importScripts)));
    parts.get(name).catch(() => parts.delete(name));
  }
  return parts.get(name);
}
export const loadPart = typeof document === 'undefined' ? inWorker : inPage;
`;
