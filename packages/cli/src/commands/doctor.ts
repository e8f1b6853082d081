/** `mirrorball doctor`: what can render here, what is missing, and how to get it. */
import { existsSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { DeviceError } from 'mirrorball/headless';
import { openChromium } from '../backends/chromium.ts';
import { dawnGpu } from '../backends/webgpu.ts';
import { CommandError, EXIT } from '../exit-codes.ts';
import type { Terminal } from '../terminal.ts';
import { version } from '../version.ts';

interface Finding {
  readonly name: string;
  readonly ok: boolean;
  readonly found: string;
  /** How to get it. */
  readonly advice?: string;
}

export async function doctor(terminal: Terminal): Promise<void> {
  const system = `${process.platform} ${process.arch}, Node.js ${process.versions.node}, ${availableParallelism()} cores`;
  terminal.event('system', {
    mirrorball: version,
    platform: process.platform,
    arch: process.arch,
    node: process.versions.node,
  });
  terminal.result(`Mirrorball ${version} on ${system}\n`);
  const findings = [await dawn(), await chromium(), cpu()];
  for (const finding of findings) {
    const { name, ok, found, advice } = finding;
    terminal.event('finding', { ...finding });
    terminal.result(`${ok ? '✓' : '✗'} ${name.padEnd(9)} ${found}`);
    if (advice) terminal.result(`            ${advice}`);
  }
  const best = findings.find(({ ok, name }) => ok && name !== 'cpu');
  terminal.event('choice', { backend: best?.name ?? null });
  terminal.result(best ? `\nRenders will use ${best.name}.` : '\nOnly --backend cpu works here, and it is slow.');
  if (!best) throw new CommandError(EXIT.noDevice, 'No graphics device was found.');
}

async function dawn(): Promise<Finding> {
  const name = 'webgpu';
  try {
    const adapter = await (await dawnGpu()).requestAdapter({ powerPreference: 'high-performance' });
    if (!adapter) return { name, ok: false, found: 'Dawn for Node runs, but finds no GPU', advice: driverAdvice() };
    const { description, device, vendor, architecture } = adapter.info;
    const words = [device, description, vendor, architecture].filter(Boolean).join(', ');
    const side = adapter.limits.maxTextureDimension2D;
    const slow = /swiftshader|llvmpipe|lavapipe/i.test(words) ? { advice: `This is software. ${driverAdvice()}` } : {};
    return { name, ok: true, found: `${words}; pictures up to ${side} pixels a side`, ...slow };
  } catch (error) {
    if (!(error instanceof DeviceError)) throw error;
    return { name, ok: false, found: error.message, advice: 'npm install webgpu@0.6.2' };
  }
}

function driverAdvice(): string {
  if (process.platform !== 'linux') return 'Update the graphics driver.';
  const hasNvidia = existsSync('/proc/driver/nvidia/version') || existsSync('/dev/nvidia0');
  if (hasNvidia)
    return 'There is an NVIDIA GPU: its Vulkan driver needs libGLX_nvidia (package libnvidia-gl-…; in containers NVIDIA_DRIVER_CAPABILITIES=all) and libvulkan1.';
  return 'Install a Vulkan driver: apt install mesa-vulkan-drivers libvulkan1 (NVIDIA: its own driver).';
}

async function chromium(): Promise<Finding> {
  const name = 'chromium';
  try {
    const tracer = await openChromium();
    const found = tracer.description;
    await tracer.dispose();
    return { name, ok: true, found };
  } catch (error) {
    if (!(error instanceof DeviceError)) throw error;
    const advice =
      process.platform === 'linux'
        ? 'apt install chromium mesa-vulkan-drivers libvulkan1, and npm install playwright-core@1.65.1'
        : 'Install Chrome or Chromium, and npm install playwright-core@1.65.1';
    return { name, ok: false, found: error.message, advice };
  }
}

const cpu = (): Finding => ({
  name: 'cpu',
  ok: true,
  found: `${availableParallelism()} threads of the double-precision reference tracer; only when asked for`,
});
