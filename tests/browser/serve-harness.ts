import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { serveFolders } from '../../scripts/static-server.mjs';

const folder = (path: string) => fileURLToPath(new URL(path, import.meta.url));
export const studioPage = folder('../../apps/studio/dist/index.html');

/**
 * Builds the harness, unless the environment says that it has just been built, and serves it under /tests/ beside the built studio, on
 * any free port, until it is closed.
 */
export async function serveHarness() {
  if (!process.env.MIRRORBALL_HARNESS_BUILT)
    await build({
      root: folder('harness'),
      base: './',
      configFile: false,
      logLevel: 'warn',
      build: { outDir: folder('dist'), emptyOutDir: true, target: 'esnext', minify: false, sourcemap: 'inline' },
    });
  return serveFolders({ mounts: { '/': folder('../../apps/studio/dist'), '/tests/': folder('dist') } });
}
