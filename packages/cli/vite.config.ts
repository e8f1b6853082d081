import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

// dist/mirrorball.mjs: the program as one file. Only what is optional or has machine code of its own stays outside.
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  ssr: { noExternal: true, external: ['webgpu', 'playwright-core'] },
  build: {
    ssr: 'src/main.ts',
    outDir: 'dist',
    emptyOutDir: true,
    target: 'node20',
    rolldownOptions: { output: { entryFileNames: 'mirrorball.mjs', codeSplitting: false } },
  },
});
