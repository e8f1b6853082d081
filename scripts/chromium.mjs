// Which Chromium the tests and benchmarks use, and how it is started. Nothing here is installed; see install-chromium.mjs.
import { existsSync } from 'node:fs';
import { join } from 'node:path';

/** Where a Chromium or Chrome that Playwright can drive usually is. Ubuntu's chromium-browser is a snap, which cannot. */
function usualPlaces() {
  if (process.platform === 'darwin') {
    return ['Google Chrome', 'Chromium'].map((name) => `/Applications/${name}.app/Contents/MacOS/${name}`);
  }
  if (process.platform === 'win32') {
    return ['PROGRAMFILES', 'PROGRAMFILES(X86)', 'LOCALAPPDATA']
      .map((variable) => process.env[variable])
      .filter((folder) => folder !== undefined)
      .map((folder) => join(folder, 'Google/Chrome/Application/chrome.exe'));
  }
  return ['/usr/bin/chromium', '/usr/bin/google-chrome', '/usr/bin/google-chrome-stable'];
}

/** Playwright's own download, if its package and its browser are both there. */
async function playwrightsOwn() {
  try {
    const { chromium } = await import('@playwright/test');
    return chromium.executablePath();
  } catch {
    return '';
  }
}

/**
 * The path of a Chromium, or null. The environment variable CHROMIUM goes before everything,
 * and must be right when it is set: silently testing another browser would help nobody.
 * @returns {Promise<string | null>}
 */
export async function findChromium() {
  const named = process.env.CHROMIUM;
  if (named) {
    if (existsSync(named)) return named;
    throw new Error(`The environment variable CHROMIUM says ${named}, but there is no such file.`);
  }
  const places = [...usualPlaces(), await playwrightsOwn()];
  return places.find((place) => place !== '' && existsSync(place)) ?? null;
}

/**
 * Switches that give WebGPU and WebGL2 together without a GPU, drawn by SwiftShader, so that every machine tests the
 * same arithmetic. --no-sandbox because containers and root cannot have the sandbox; only our own pages are opened.
 */
export const chromiumFlags = [
  '--no-sandbox',
  '--enable-unsafe-webgpu',
  '--use-angle=swiftshader',
  '--disable-background-networking',
  '--disable-component-update',
  // Dawn reaches SwiftShader through Vulkan on Linux only; elsewhere it has to be asked for by name.
  ...(process.platform === 'linux'
    ? ['--enable-features=Vulkan', '--use-vulkan=swiftshader']
    : ['--enable-unsafe-swiftshader', '--use-webgpu-adapter=swiftshader']),
];
