import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

// dist/textures.mjs: the benchmark as one file.
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  ssr: { noExternal: true, external: ['webgpu', 'draco3dgltf', 'meshoptimizer'] },
  build: {
    ssr: 'textures.ts',
    outDir: 'dist',
    emptyOutDir: true,
    target: 'node20',
    rolldownOptions: { output: { entryFileNames: 'textures.mjs', codeSplitting: false } },
  },
});
