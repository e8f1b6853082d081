/** Which backend traces: the best that this machine has, or the one that was asked for. */
import { DeviceError, type FilmTracer } from 'mirrorball/headless';
import type { BackendChoice, BackendName } from '../arguments.ts';
import { CommandError, EXIT } from '../exit-codes.ts';
import { openChromium } from './chromium.ts';
import { openCpu } from './cpu.ts';
import { openDawn } from './webgpu.ts';

export interface Backend {
  readonly name: BackendName;
  readonly tracer: FilmTracer;
}

const OPEN: Readonly<Record<BackendName, () => Promise<FilmTracer>>> = {
  webgpu: openDawn,
  chromium: openChromium,
  cpu: async () => openCpu(),
};

/** What was opened and stays so. */
let kept: Map<BackendName, Promise<FilmTracer>> | null = null;

/** From now on a backend is opened once and serves all runs of this process, with the programs that it has compiled. */
export const keepBackends = (): void => void (kept ??= new Map());

/** This one. Rejects with `DeviceError` when it does not work here. */
export async function openNamed(name: BackendName): Promise<FilmTracer> {
  if (kept === null) return OPEN[name]();
  const tracer = await (kept.get(name) ?? kept.set(name, OPEN[name]()).get(name)!);
  return {
    description: tracer.description,
    begin: (...job) => tracer.begin(...job),
    trace: (...samples) => tracer.trace(...samples),
    dispose: () => {},
  };
}

const ADVICE =
  'Install the package "webgpu" (npm install webgpu@0.6.2) and a Vulkan driver for your GPU, or Chromium; ' +
  'or render with --backend cpu, which is slow and needs nothing. `mirrorball doctor` tells more.';

/** Ends with exit code 3 when there is none, and with a sentence that says what to install. */
export async function openBackend(choice: BackendChoice): Promise<Backend> {
  const names: readonly BackendName[] = choice === 'auto' ? ['webgpu', 'chromium'] : [choice];
  const reasons: string[] = [];
  for (const name of names) {
    try {
      return { name, tracer: await openNamed(name) };
    } catch (error) {
      if (!(error instanceof DeviceError)) throw error;
      reasons.push(`${name}: ${error.message}`);
    }
  }
  throw new CommandError(EXIT.noDevice, `Nothing here can render.\n  ${reasons.join('\n  ')}\n${ADVICE}`);
}
