import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

// dist/chromium-page.js: the renderer for the page in headless Chromium, as one script.
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  build: {
    outDir: 'dist',
    emptyOutDir: false,
    target: 'es2022',
    lib: {
      entry: 'src/backends/chromium-page.ts',
      formats: ['iife'],
      name: 'chromiumPage',
      fileName: () => 'chromium-page.js',
    },
  },
});
