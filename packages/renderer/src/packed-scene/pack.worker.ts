/** Packs meshes, one after the other, and posts how far it is; ending it is `terminate()`. */
import type { Mesh } from '../scene/mesh.ts';
import { packInSteps } from './pack-mesh.ts';
import { type PackedMesh, wordsOf } from './packed-mesh.ts';

/** What the worker posts. */
export type PackMessage =
  | { readonly done: number }
  | { readonly packed: PackedMesh }
  /** What was wrong with a mesh; nothing follows. */
  | { readonly problem: string };

self.onmessage = (event: MessageEvent<readonly Mesh[]>) => {
  try {
    for (const mesh of event.data) post(mesh);
  } catch (error) {
    const message: PackMessage = { problem: error instanceof Error ? error.message : String(error) };
    self.postMessage(message);
  }
};

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
