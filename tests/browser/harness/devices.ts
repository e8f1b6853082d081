export interface Devices {
  readonly webgpu: { readonly adapter: string; readonly compute: boolean } | null;
  readonly webgl2: { readonly renderer: string } | null;
}

async function describeWebGpu(): Promise<Devices['webgpu']> {
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter) return null;
  const device = await adapter.requestDevice();
  const compute = device.limits.maxComputeInvocationsPerWorkgroup >= 64;
  device.destroy();
  const { vendor, architecture, device: name, description } = adapter.info;
  return { adapter: [vendor, architecture, name, description].filter(Boolean).join(' '), compute };
}

function describeWebGl2(): Devices['webgl2'] {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return null;
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  const renderer = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return { renderer };
}

/** Names the GPU interfaces of this browser; null for one that it lacks. */
export async function describeDevices(): Promise<Devices> {
  return { webgpu: await describeWebGpu(), webgl2: describeWebGl2() };
}
