import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

// dist/gpu.mjs: the whole benchmark as one file, for a machine that has Node, Dawn's module and nothing else.
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  ssr: { noExternal: true, external: ['webgpu'] },
  build: {
    ssr: 'gpu.ts',
    outDir: 'dist',
    emptyOutDir: true,
    target: 'node20',
    rolldownOptions: { output: { entryFileNames: 'gpu.mjs', codeSplitting: false } },
  },
});
