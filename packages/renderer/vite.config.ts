import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

// dist/mirrorball.js: the library as one ES module without imports, shaders and worker inside, for pages without a bundler.
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  build: {
    outDir: 'dist',
    emptyOutDir: true,
    target: 'es2022',
    lib: { entry: 'src/index.ts', formats: ['es'], fileName: 'mirrorball' },
  },
});
