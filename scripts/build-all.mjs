import { buildCli } from './build-cli.mjs';
import { buildLibrary } from './build-library.mjs';
import { buildStudio } from './build-studio.mjs';

/** The studio beside all else: each of these builds keeps hardly more than one core busy. Gives the exit code. */
export async function buildAll() {
  const others = async () => (await buildLibrary()) || (await buildCli());
  const [studio, rest] = await Promise.all([buildStudio(), others()]);
  return studio || rest;
}
