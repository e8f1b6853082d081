/**
 * Does one of two things, as the first message says: packs meshes, one after the other, and posts how far it is; or bends meshes, a pose of some
 * of them with each message after the first. Both need what builds trees, so it is one worker's text. Ending it is `terminate()`.
 */
import type { Mesh } from '../scene/mesh.ts';
import { packInSteps } from './pack-mesh.ts';
import { type PackedMesh, wordsOf } from './packed-mesh.ts';
import { type BentSource, type PosedWords, PoseJob, type PoseOrder } from './pose-job.ts';

/** What the worker posts. */
export type PackMessage =
  | { readonly done: number }
  | { readonly packed: PackedMesh }
  /** What was wrong with a mesh; nothing follows. */
  | { readonly problem: string };
/** The same of one that bends. */
export type PosesMessage = { readonly posed: readonly PosedWords[] } | { readonly problem: string };

type FirstMessage = readonly Mesh[] | { readonly bend: readonly BentSource[] };

const tried = (work: () => void): void => {
  try {
    work();
  } catch (error) {
    self.postMessage({ problem: error instanceof Error ? error.message : String(error) } satisfies PackMessage);
  }
};

self.onmessage = ({ data }: MessageEvent<FirstMessage>) => {
  tried(() => {
    if ('bend' in data) bendFor(new PoseJob(data.bend));
    else for (const mesh of data) post(mesh);
  });
};

function bendFor(job: PoseJob): void {
  self.onmessage = ({ data }: MessageEvent<readonly PoseOrder[]>) => {
    tried(() => {
      const posed = data.map((order) => job.bend(order));
      self.postMessage({ posed } satisfies PosesMessage, { transfer: posed.map(({ words }) => words.buffer) });
    });
  };
}

/** What the worker no longer needs goes over without a copy. */
function post(mesh: Mesh): void {
  const steps = packInSteps(mesh);
  for (;;) {
    const { done, value } = steps.next();
    if (!done) {
      self.postMessage({ done: value } satisfies PackMessage);
      continue;
    }
    const transfer = [...wordsOf(value).map(({ buffer }) => buffer), value.order.buffer];
    self.postMessage({ packed: value } satisfies PackMessage, { transfer });
    return;
  }
}
