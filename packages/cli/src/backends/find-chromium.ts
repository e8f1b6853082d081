/** Where a Chromium or Chrome is, and how it is started. */
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { usage } from '../exit-codes.ts';

/** Where one that can be driven usually is. Ubuntu's chromium-browser is a snap, which cannot. */
function usualPlaces(): string[] {
  if (process.platform === 'darwin')
    return ['Google Chrome', 'Chromium'].map((name) => `/Applications/${name}.app/Contents/MacOS/${name}`);
  if (process.platform === 'win32')
    return ['PROGRAMFILES', 'PROGRAMFILES(X86)', 'LOCALAPPDATA']
      .map((variable) => process.env[variable])
      .filter((folder) => folder !== undefined)
      .map((folder) => join(folder, 'Google/Chrome/Application/chrome.exe'));
  return ['/usr/bin/chromium', '/usr/bin/google-chrome', '/usr/bin/google-chrome-stable'];
}

/** The path, or null. The variable CHROMIUM goes before everything and must be right. */
export function findChromium(playwrightsOwn: () => string = () => ''): string | null {
  const named = process.env.CHROMIUM;
  if (named) {
    if (existsSync(named)) return named;
    throw usage(`The environment variable CHROMIUM says ${named}, but there is no such file.`);
  }
  return [...usualPlaces(), playwrightsOwn()].find((place) => place !== '' && existsSync(place)) ?? null;
}

const COMMON = ['--enable-unsafe-webgpu', '--disable-background-networking', '--disable-component-update'];

/** The machine's GPU. */
export const HARDWARE_FLAGS: string[] = [
  ...COMMON,
  '--ignore-gpu-blocklist',
  ...(process.platform === 'linux' ? ['--enable-features=Vulkan', '--use-angle=vulkan'] : []),
  // Without this a browser without GPU would draw in software by itself, and worse than when told to.
  '--disable-software-rasterizer',
];

/** SwiftShader, Chromium's own software: works everywhere. */
export const SOFTWARE_FLAGS: string[] = [
  ...COMMON,
  '--use-angle=swiftshader',
  ...(process.platform === 'linux'
    ? ['--enable-features=Vulkan', '--use-vulkan=swiftshader']
    : ['--enable-unsafe-swiftshader', '--use-webgpu-adapter=swiftshader']),
];
