import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { lazyParts } from '../../scripts/lazy-parts.mjs';
import { shaderText } from '../../scripts/shader-text.mjs';
import { layoutWithoutDocs, scenesWithoutDocs } from '../../scripts/without-docs.mjs';

// One file comes out: apps/studio/dist/index.html, which works from file:// and asks the network for nothing.
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  plugins: [
    layoutWithoutDocs(),
    scenesWithoutDocs(),
    shaderText(),
    viteSingleFile({ removeViteModuleLoader: true }),
    lazyParts('page'),
  ],
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  build: { outDir: 'dist', emptyOutDir: true, target: 'es2022', modulePreload: false, reportCompressedSize: true },
});
