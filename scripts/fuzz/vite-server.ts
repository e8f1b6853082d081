import { fileURLToPath } from 'node:url';
import { createServer, type ViteDevServer } from 'vite';

/** Vite brings shaders and workers, which Node alone cannot import: `ssrLoadModule('/path/from/the/root.ts')`. */
export const viteServer = (): Promise<ViteDevServer> =>
  createServer({
    root: fileURLToPath(new URL('../..', import.meta.url)),
    configFile: false,
    logLevel: 'warn',
    appType: 'custom',
    server: { middlewareMode: true, ws: false, watch: null },
    optimizeDeps: { noDiscovery: true },
  });
