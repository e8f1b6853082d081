import { existsSync } from 'node:fs';
import { serveHarness, studioPage } from './serve-harness.ts';

/** Serves the harness and the built studio until all tests are done. */
export default async function globalSetup(): Promise<() => Promise<void>> {
  if (!existsSync(studioPage)) console.warn('The studio is not built: run `npm run build`, or its tests will fail.');
  const server = await serveHarness();
  // The workers are started after this and inherit it; a fixed port could be in use.
  process.env.MIRRORBALL_ORIGIN = server.origin;
  return server.close;
}
