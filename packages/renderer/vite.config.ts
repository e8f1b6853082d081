import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { lazyParts } from '../../scripts/lazy-parts.mjs';

// dist/mirrorball.js: the library as one ES module, shaders and worker inside, for pages without a bundler. It imports nothing at its
// start; mirrorball-gltf.js and others beside it come when a model needs them.
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  plugins: [lazyParts('library')],
  build: {
    outDir: 'dist',
    emptyOutDir: true,
    target: 'es2022',
    // The reader of scenes, which the library exports, is there already when a renderer asks for it.
    rolldownOptions: { checks: { ineffectiveDynamicImport: false } },
    lib: { entry: 'src/index.ts', formats: ['es'], fileName: 'mirrorball' },
  },
});
