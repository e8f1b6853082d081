import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { serveFolders } from './static-server.mjs';

let folder: string;
let server: Awaited<ReturnType<typeof serveFolders>>;

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'mirrorball-server-'));
  mkdirSync(join(folder, 'site'));
  mkdirSync(join(folder, 'tests'));
  writeFileSync(join(folder, 'secret.txt'), 'secret');
  writeFileSync(join(folder, 'site/index.html'), 'home');
  writeFileSync(join(folder, 'tests/a b.json'), '{}');
  try {
    symlinkSync(join(folder, 'secret.txt'), join(folder, 'site/link.txt'));
  } catch {
    // Windows lets only some people make links; without one there is nothing to leak.
  }
  server = await serveFolders({ mounts: { '/': join(folder, 'site'), '/tests/': join(folder, 'tests') } });
});
afterAll(async () => {
  await server.close();
  rmSync(folder, { recursive: true });
});

/** Asks with exactly this path: fetch would tidy up the dots before sending. */
function ask(path: string, method = 'GET'): Promise<{ status: number; type: string; body: string }> {
  return new Promise((resolve, reject) => {
    const question = request({ host: '127.0.0.1', port: server.port, path, method }, (response) => {
      let body = '';
      response.on('data', (chunk) => (body += chunk));
      response.on('end', () =>
        resolve({ status: response.statusCode ?? 0, type: response.headers['content-type'] ?? '', body }),
      );
    });
    question.on('error', reject).end();
  });
}

describe('static server', () => {
  it('serves a folder at its longest prefix, with its type', async () => {
    expect(await ask('/')).toMatchObject({ status: 200, type: 'text/html; charset=utf-8', body: 'home' });
    expect(await ask('/index.html?scene=x')).toMatchObject({ status: 200, body: 'home' });
    expect(await ask('/tests/a%20b.json')).toMatchObject({ status: 200, type: 'application/json; charset=utf-8' });
  });

  it.each([
    '/../secret.txt',
    '/..%2fsecret.txt',
    '/%2e%2e/secret.txt',
    '/tests/..%2f..%2fsecret.txt',
    '/tests/..\\..\\secret.txt',
    '/link.txt',
    '//etc/passwd',
    '/%00',
    '/%',
    '/nothing.html',
    '/tests/',
  ])('gives nothing for %s', async (path) => {
    expect((await ask(path)).status).toBe(404);
  });

  it('only reads', async () => {
    expect((await ask('/', 'POST')).status).toBe(405);
    expect(await ask('/', 'HEAD')).toMatchObject({ status: 200, body: '' });
  });

  it('takes the next port when one is in use, and answers on this machine only', async () => {
    const next = await serveFolders({ mounts: { '/': join(folder, 'site') }, port: server.port });
    expect(next.port).toBeGreaterThan(server.port);
    await next.close();
    expect(server.origin).toBe(`http://localhost:${server.port}`);
  });
});
