import { afterEach, expect, test, vi } from 'vitest';
import { DeviceError } from './gpu/device.ts';
import { createRenderer } from './renderer.ts';
import type { RendererOptions } from './renderer-types.ts';

afterEach(() => vi.unstubAllGlobals());

/** A canvas that gives nothing. */
const used = { getContext: () => null } as unknown as HTMLCanvasElement;

test.each([
  [null, 'null'],
  [undefined, 'nothing'],
  ['#canvas', 'the text "#canvas"'],
  [{}, 'an object'],
])('%s is no canvas', async (canvas, found) => {
  const opening = createRenderer(canvas as unknown as HTMLCanvasElement);
  await expect(opening).rejects.toThrow(
    new TypeError(`createRenderer draws on a canvas element; it was given ${found}.`),
  );
});

test('a backend that there is not', async () => {
  const options = { backend: 'foo' } as unknown as RendererOptions;
  await expect(createRenderer(used, options)).rejects.toThrow(TypeError);
  await expect(createRenderer(used, options)).rejects.toThrow('The backend is the text "foo"; expected "auto"');
});

test.each([
  [{ getExtension: () => null }, 'This canvas has a context of another kind already'],
  [null, 'This browser gives no WebGL2 context.'],
])('WebGL2 on a canvas in use is not told as a browser without it', async (fresh, told) => {
  vi.stubGlobal('document', { createElement: () => ({ getContext: () => fresh }) });
  const opening = createRenderer(used, { backend: 'webgl2' });
  await expect(opening).rejects.toThrow(DeviceError);
  await expect(opening).rejects.toThrow(told);
});
