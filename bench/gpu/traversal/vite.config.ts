import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

// dist/traversal.mjs: the whole benchmark as one file, for a machine that has Node, Dawn's module and nothing else.
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  ssr: { noExternal: true, external: ['webgpu'] },
  build: {
    ssr: 'traversal.ts',
    outDir: 'dist',
    emptyOutDir: true,
    target: 'node20',
    rolldownOptions: { output: { entryFileNames: 'traversal.mjs', codeSplitting: false } },
  },
});
