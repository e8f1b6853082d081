/**
 * The words that say what a field of layout.ts holds are for those who read shaders; `npm run shaders` writes them there. What is built has
 * no use for them.
 */
const FIELD = /\bfield\(\s*('\w+'|\{[^}]*\}),\s*'(?:[^'\\]|\\.)*',?\s*\)/g;

/** @param {string} source of layout.ts */
export const withoutDocs = (source) => source.replaceAll(FIELD, "field($1, '')");

/** @returns {import('vite').Plugin} */
export const layoutWithoutDocs = () => ({
  name: 'layout-without-docs',
  enforce: 'pre',
  transform: (code, id) => (id.endsWith('/packed-scene/layout.ts') ? withoutDocs(code) : null),
});

/**
 * What a built-in scene's file says about itself is for those who open the file; a page shows it nowhere.
 * @returns {import('vite').Plugin}
 */
export const scenesWithoutDocs = () => ({
  name: 'scenes-without-docs',
  enforce: 'pre',
  transform(code, id) {
    if (!id.includes('/scene/built-in/generated/')) return null;
    return JSON.stringify({ ...JSON.parse(code), description: '' });
  },
});
