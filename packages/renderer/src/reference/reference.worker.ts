/** Draws one still picture and posts copies of its film on the way. It takes one job; ending it is `terminate()`. */
import { isWorthShowing, renderProgressively, type StillJob } from './progressive.ts';

/** What the worker posts. The last one has done = 1. */
export interface StillMessage {
  readonly film: Float32Array<ArrayBuffer>;
  readonly done: number;
}

self.onmessage = (event: MessageEvent<StillJob>) => {
  let shownAt = performance.now();
  for (const progress of renderProgressively(event.data)) {
    if (!isWorthShowing(progress, performance.now() - shownAt)) continue;
    shownAt = performance.now();
    const message: StillMessage = { film: progress.film.slice(), done: progress.done };
    self.postMessage(message, { transfer: [message.film.buffer] });
  }
};
