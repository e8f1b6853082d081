import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { minifiedDeclarations } from './shader-minify.mjs';

/** Where imports of what programs share lead. */
const SHARED = 'virtual:shared-shader-text';
const RESOLVED = `\0${SHARED}`;

/**
 * For Vite: shaders go into what is built in few letters, and what several programs have in common goes into it once. They are text to a
 * bundler, which leaves them as they are, and were half of the page; gzip looks back only 32 KB and finds no copies in them.
 * @returns {import('vite').Plugin}
 */
export function shaderText() {
  /** @type {Map<string, Map<string, string>>} folder → declaration that more than one program has → its name */
  const folders = new Map();
  const sharedIn = (/** @type {string} */ folder) => {
    const shared = folders.get(folder) ?? sharedDeclarations(folder, folders.size);
    folders.set(folder, shared);
    return shared;
  };
  return {
    name: 'shader-text',
    apply: 'build',
    enforce: 'pre',
    resolveId: (id) => (id.startsWith(SHARED) ? `${RESOLVED}${id.slice(SHARED.length)}` : null),
    load(id) {
      if (id.startsWith(RESOLVED)) {
        const constants = [...sharedIn(id.slice(RESOLVED.length + 1))];
        return constants.map(([text, name]) => `export const ${name} = ${JSON.stringify(text)};`).join('\n');
      }
      const [file = '', query] = id.split('?');
      if (query !== 'raw' || !SHADER.test(file)) return null;
      const shared = sharedIn(dirname(file));
      return moduleOf(declarationsOf(file), shared, `${SHARED}:${dirname(file)}`);
    },
  };
}

const SHADER = /\.(wgsl|glsl)$/;

/** @param {string} file */
const declarationsOf = (file) =>
  minifiedDeclarations(readFileSync(file, 'utf8').replaceAll('\r\n', '\n'), file.endsWith('.wgsl') ? 'wgsl' : 'glsl');

/** @param {string} folder @param {number} number of the folder */
function sharedDeclarations(folder, number) {
  /** @type {Map<string, number>} */
  const programs = new Map();
  // WGSL together and GLSL together: what resembles each other stands close.
  const files = readdirSync(folder).filter((name) => SHADER.test(name));
  for (const name of files.sort((a, b) => extension(a).localeCompare(extension(b)) || a.localeCompare(b)))
    for (const text of new Set(declarationsOf(join(folder, name)))) programs.set(text, (programs.get(text) ?? 0) + 1);
  const shared = [...programs].filter(([text, count]) => count > 1 && text.length > WORTH_A_NAME);
  return new Map(shared.map(([text], i) => [text, `shared${number}_${i}`]));
}

/** A shorter text is shorter than to name it. */
const WORTH_A_NAME = 16;
const extension = (/** @type {string} */ name) => name.split('.').at(-1) ?? '';

/**
 * @param {string[]} declarations
 * @param {Map<string, string>} shared
 * @param {string} from
 */
function moduleOf(declarations, shared, from) {
  /** @type {string[]} */
  const terms = [];
  let own = '';
  const names = new Set();
  for (const text of declarations) {
    const name = shared.get(text);
    if (name === undefined) {
      own += text;
      continue;
    }
    if (own) terms.push(JSON.stringify(own));
    own = '';
    names.add(name);
    terms.push(name);
  }
  if (own) terms.push(JSON.stringify(own));
  return `import { ${[...names].join(', ')} } from ${JSON.stringify(from)};\nexport default [${terms.join(', ')}].join('');`;
}
