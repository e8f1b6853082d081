import { createReadStream } from 'node:fs';
import { realpath, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, relative, resolve, sep } from 'node:path';

/** @type {Record<string, string>} */
const MIME = {
  '.css': 'text/css; charset=utf-8',
  '.glsl': 'text/plain; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.map': 'application/json; charset=utf-8',
  '.md': 'text/plain; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.mp4': 'video/mp4',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webm': 'video/webm',
  '.webp': 'image/webp',
  '.wgsl': 'text/plain; charset=utf-8',
};

/**
 * The file that an address means, or null. `..`, encoded `..` and links never lead out of the mounted folder.
 * @param {Record<string, string>} mounts
 * @param {string} url
 */
async function fileFor(mounts, url) {
  let path;
  try {
    path = decodeURIComponent(new URL(url, 'http://localhost').pathname);
  } catch {
    return null;
  }
  const prefix = Object.keys(mounts)
    .filter((mount) => path.startsWith(mount))
    .sort((a, b) => b.length - a.length)[0];
  if (prefix === undefined || path.includes('\0')) return null;
  try {
    const folder = await realpath(/** @type {string} */ (mounts[prefix]));
    let file = await realpath(resolve(folder, `.${sep}${path.slice(prefix.length)}`));
    if ((await stat(file)).isDirectory()) file = await realpath(join(file, 'index.html'));
    const inside = relative(folder, file);
    return inside === '..' || inside.startsWith(`..${sep}`) || resolve(inside) === inside ? null : file;
  } catch {
    return null;
  }
}

/**
 * @param {Record<string, string>} mounts
 * @returns {import('node:http').RequestListener}
 */
function answer(mounts) {
  return async (request, response) => {
    if (request.method !== 'GET' && request.method !== 'HEAD') return void response.writeHead(405).end();
    // Browsers ask for an icon unbidden; "none" instead of "not found" keeps their consoles quiet.
    if (request.url === '/favicon.ico') return void response.writeHead(204).end();
    const file = await fileFor(mounts, request.url ?? '/');
    if (!file) return void response.writeHead(404, { 'content-type': 'text/plain' }).end('Not found\n');
    response.writeHead(200, {
      'content-type': MIME[extname(file).toLowerCase()] ?? 'application/octet-stream',
      'content-length': (await stat(file)).size,
      'cache-control': 'no-store',
      'x-content-type-options': 'nosniff',
    });
    if (request.method === 'HEAD') return void response.end();
    createReadStream(file)
      .on('error', () => response.destroy())
      .pipe(response);
  };
}

/**
 * Serves folders on 127.0.0.1 only, so that nothing is shown to the network.
 * @param {{ mounts: Record<string, string>, port?: number, tries?: number }} options
 *   mounts: address prefix (ending in "/") to folder, the longest prefix wins; port: the first to try, 0 = any free one
 * @returns {Promise<{ origin: string, port: number, close: () => Promise<void> }>}
 */
export async function serveFolders({ mounts, port = 0, tries = 20 }) {
  const server = createServer(answer(mounts));
  const taken = await listenOnFreePort(server, port, port === 0 ? 1 : tries);
  const close = () =>
    new Promise((/** @type {(value?: undefined) => void} */ done) => {
      server.close(() => done());
      server.closeAllConnections();
    });
  return { origin: `http://localhost:${taken}`, port: taken, close };
}

/**
 * @param {import('node:http').Server} server
 * @param {number} port
 * @param {number} tries
 * @returns {Promise<number>}
 */
async function listenOnFreePort(server, port, tries) {
  for (let attempt = port; ; attempt++) {
    try {
      await new Promise((/** @type {(value?: undefined) => void} */ listening, reject) => {
        server.once('error', reject);
        server.listen(attempt, '127.0.0.1', () => {
          server.off('error', reject);
          listening();
        });
      });
      const address = server.address();
      return typeof address === 'object' && address ? address.port : attempt;
    } catch (error) {
      const inUse = /** @type {NodeJS.ErrnoException} */ (error).code === 'EADDRINUSE';
      if (!inUse || attempt + 1 >= port + tries || attempt >= 65535) throw error;
    }
  }
}
