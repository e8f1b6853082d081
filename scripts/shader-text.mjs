/**
 * For Vite: shaders go into what is built without comments, empty lines and indentation. They are text to a bundler, which leaves them
 * as they are, and half of the page.
 * @returns {import('vite').Plugin}
 */
export function shaderText() {
  return {
    name: 'shader-text',
    apply: 'build',
    enforce: 'pre',
    async load(id) {
      const [file = '', query] = id.split('?');
      if (query !== 'raw' || !/\.(wgsl|glsl)$/.test(file)) return null;
      const { readFile } = await import('node:fs/promises');
      return `export default ${JSON.stringify(withoutComments(await readFile(file, 'utf8')))};`;
    },
  };
}

/** @param {string} text */
export const withoutComments = (text) =>
  text
    .replace(/\/\/.*$/gm, '')
    .replace(/^\s+/gm, '')
    .replace(/[ \t]+$/gm, '');
