import { expect, test } from './fixtures.ts';
import { expectPicture, expectState, quick } from './studio.ts';

/** What the browser lacks: a script that runs before the page's own, in few words of JavaScript. */
const noWebGpu = `Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });`;
const noWebGl2 = `{
  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
    return kind === 'webgl2' ? null : getContext.call(this, kind, ...more);
  };
}`;
const withoutExtensions = (...names: string[]) => `{
  const getExtension = WebGL2RenderingContext.prototype.getExtension;
  WebGL2RenderingContext.prototype.getExtension = function (name) {
    return ${JSON.stringify(names)}.includes(name) ? null : getExtension.call(this, name);
  };
}`;
/** The nth program and all after it fail to link. */
const refusingPrograms = (nth: number) => `{
  const getProgramParameter = WebGL2RenderingContext.prototype.getProgramParameter;
  let n = 0;
  WebGL2RenderingContext.prototype.getProgramParameter = function (program, name) {
    if (name === this.LINK_STATUS && ++n >= ${nth}) return false;
    return getProgramParameter.call(this, program, name);
  };
}`;
/** The nth pipeline and all after it are refused. */
const refusingPipelines = (nth: number) => `{
  const create = GPUDevice.prototype.createRenderPipelineAsync;
  let n = 0;
  GPUDevice.prototype.createRenderPipelineAsync = function (descriptor) {
    return ++n >= ${nth} ? Promise.reject(new Error('refused')) : create.call(this, descriptor);
  };
}`;
const noDevice = `GPUAdapter.prototype.requestDevice = () => Promise.reject(new Error('no device today'));`;
const noWorker = `delete window.Worker;`;
const float = 'EXT_color_buffer_float';
const halfFloat = 'EXT_color_buffer_half_float';

const alone = 'This browser offers neither WebGPU nor WebGL2';
type Case = [what: string, script: string, drawnBy: 'webgpu' | 'webgl2' | 'cpu', wished?: 'webgpu' | 'webgl2'];
const cases: readonly Case[] = [
  ['no navigator.gpu', noWebGpu, 'webgl2'],
  ['no adapter', `GPU.prototype.requestAdapter = () => Promise.resolve(null);`, 'webgl2'],
  ['an adapter that is refused', `GPU.prototype.requestAdapter = () => Promise.reject(new Error('no'));`, 'webgl2'],
  ['a device that is refused', noDevice, 'webgl2'],
  ['WebGPU wished for and refused', noDevice, 'webgl2', 'webgpu'],
  ['WebGPU refuses the first pipelines', refusingPipelines(1), 'webgl2'],
  ['WebGPU refuses the integrator', refusingPipelines(3), 'webgl2'],
  ['WebGL2 refuses the integrator', refusingPrograms(3), 'webgpu', 'webgl2'],
  ['WebGL2 draws into half floats only', noWebGpu + withoutExtensions(float), 'webgl2'],
  ['WebGL2 draws into no floats', noWebGpu + withoutExtensions(float, halfFloat), 'cpu'],
  ['WebGL2 refuses all programs', noWebGpu + refusingPrograms(1), 'cpu'],
  ['neither WebGPU nor WebGL2', noWebGpu + noWebGl2, 'cpu'],
  ['no worker either', noWebGpu + noWebGl2 + noWorker, 'cpu'],
  [
    'localStorage throws',
    `Object.defineProperty(window, 'localStorage', { get() { throw new DOMException('no', 'SecurityError'); } });`,
    'webgpu',
  ],
];

test.use({ viewport: { width: 480, height: 320 } });
for (const [what, script, drawnBy, wished] of cases)
  test(`${what}: a picture by ${drawnBy}`, async ({ page, openStudio }) => {
    await page.addInitScript({ content: script });
    const query = { ...quick, size: 160, paused: 1 };
    await openStudio(wished ? { query, backend: wished } : { query });
    await expectState(page, (state) => state.backend, drawnBy);
    await expectState(page, (state) => state.stats.samples > 0, true);
    await expectPicture(page);
    const sentence = page.getByText(alone);
    if (drawnBy === 'cpu') await expect(sentence).toBeVisible();
    else await expect(sentence).toBeHidden();
  });

test('half floats sum up no more samples than they can', async ({ page, openStudio }) => {
  await page.addInitScript({ content: noWebGpu + withoutExtensions(float) });
  await openStudio({ query: { ...quick, size: 64, paused: 1 } });
  await expectState(page, (state) => state.stats.samples, 32);
  await page.waitForTimeout(300);
  await expectState(page, (state) => [state.stats.samples, state.stats.fps], [32, 0]);
});
