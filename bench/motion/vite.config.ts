import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

// dist/motion.mjs: the benchmark as one file, as bench/gpu has it.
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  ssr: { noExternal: true, external: ['webgpu', 'draco3dgltf', 'meshoptimizer'] },
  build: {
    ssr: 'motion.ts',
    outDir: 'dist',
    emptyOutDir: true,
    target: 'node20',
    rolldownOptions: { output: { entryFileNames: 'motion.mjs', codeSplitting: false } },
  },
});
