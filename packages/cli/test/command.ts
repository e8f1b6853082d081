/** Runs the built program in a folder of its own: as a person would, or many times in one process. */
import { type ChildProcess, fork, spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { arrayAsPicture, interleave, readNpyArray } from 'mirrorball/picture-files';

const program = fileURLToPath(new URL('../dist/mirrorball.mjs', import.meta.url));
const serve = fileURLToPath(new URL('serve.mjs', import.meta.url));

/** Chromium's software Vulkan, where it is installed: then the tests need no GPU and give the same numbers everywhere. */
const SWIFTSHADER = ['/usr/lib/chromium/vk_swiftshader_icd.json', '/opt/google/chrome/vk_swiftshader_icd.json'].find(
  (path) => existsSync(path),
);
const env = { ...process.env, ...(SWIFTSHADER ? { VK_ICD_FILENAMES: SWIFTSHADER } : {}), NO_COLOR: '1' };

export const folder = mkdtempSync(join(tmpdir(), 'mirrorball-cli-'));
export const inFolder = (name: string): string => join(folder, name);

export interface Ended {
  readonly code: number | null;
  readonly stdout: string;
  readonly stderr: string;
  /** The lines of standard output as objects. */
  readonly events: readonly { readonly event: string; readonly [key: string]: unknown }[];
}

const parseLines = (text: string) =>
  text
    .split('\n')
    .filter(Boolean)
    .map((line) => JSON.parse(line) as { event: string });

/** A process of its own. `watch` sees standard output as it comes, and may end the program. */
export function started(
  args: string,
  watch: (stdout: string, child: ChildProcess) => void = () => {},
  more: Readonly<Record<string, string>> = {},
): Promise<Ended> {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [program, ...args.split(' ').filter(Boolean)], {
      cwd: folder,
      env: { ...env, ...more },
    });
    let [stdout, stderr] = ['', ''];
    child.stdout.on('data', (chunk) => {
      stdout += chunk;
      watch(stdout, child);
    });
    child.stderr.on('data', (chunk) => {
      stderr += chunk;
    });
    child.on('error', reject);
    child.on('close', (code) => {
      resolve({ code, stdout, stderr, events: args.includes('--json') ? parseLines(stdout) : [] });
    });
  });
}

let server: ChildProcess | null = null;
let runs = 0;

/** In the one process that all such runs share, with the GPU that it has open: for whatever is not about processes. */
export function mirrorball(args: string): Promise<Ended> {
  const child = (server ??= fork(serve, [pathToFileURL(program).href], { cwd: folder, env }).setMaxListeners(0));
  const id = runs++;
  return new Promise((resolve, reject) => {
    const hear = (message: Omit<Ended, 'events'> & { readonly id: number }) => {
      if (message.id !== id) return;
      child.off('message', hear).off('exit', fail);
      resolve({ ...message, events: args.includes('--json') ? parseLines(message.stdout) : [] });
    };
    const fail = () => reject(new Error(`The process ended at: mirrorball ${args}`));
    child.on('message', hear).on('exit', fail);
    child.send({ id, args: args.split(' ').filter(Boolean) });
  });
}

export const stopServer = (): Promise<unknown> =>
  new Promise((resolve) => {
    if (server === null) return resolve(null);
    server.removeAllListeners('exit').once('exit', resolve).disconnect();
    server = null;
  });

/** Ends the program by this signal when it first tells of a whole sample. */
export const killedOnTheWay = (signal: NodeJS.Signals) => (stdout: string, child: ChildProcess) => {
  if (/"progress".*"samples":[1-9]/.test(stdout) && !child.killed) child.kill(signal);
};

export const bytesOf = (name: string): Buffer => readFileSync(inFolder(name));
/** Red, green, blue of each pixel of an NPY file. */
export const pixelsOf = (name: string): Float32Array => interleave(arrayAsPicture(readNpyArray(bytesOf(name))));

/** Relative above 1. */
export function largestDifference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  if (a.length !== b.length) return Number.POSITIVE_INFINITY;
  return Array.from(a).reduce(
    (most, value, i) => Math.max(most, Math.abs(value - b[i]!) / Math.max(Math.abs(value), 1)),
    0,
  );
}

/** Whether Dawn for Node finds a device here. */
export async function hasDawn(): Promise<boolean> {
  const { code } = await mirrorball('render cube-room --pixel 0,0 --size 1x1 --spp 1 --backend webgpu');
  return code === 0;
}
