import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { serveFolders } from '../../scripts/static-server.mjs';

const folder = (path: string) => fileURLToPath(new URL(path, import.meta.url));
export const studioPage = folder('../../apps/studio/dist/index.html');

/** Builds the harness and serves it under /tests/ beside the built studio, on any free port, until all tests are done. */
export default async function globalSetup(): Promise<() => Promise<void>> {
  if (!existsSync(studioPage)) console.warn('The studio is not built: run `npm run build`, or its tests will fail.');
  await build({
    root: folder('harness'),
    base: './',
    configFile: false,
    logLevel: 'warn',
    build: { outDir: folder('dist'), emptyOutDir: true, target: 'esnext', minify: false, sourcemap: 'inline' },
  });
  const server = await serveFolders({
    mounts: { '/': folder('../../apps/studio/dist'), '/tests/': folder('dist') },
  });
  // The workers are started after this and inherit it; a fixed port could be in use.
  process.env.MIRRORBALL_ORIGIN = server.origin;
  return server.close;
}
