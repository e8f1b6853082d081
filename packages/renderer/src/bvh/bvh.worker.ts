/** Builds one tree and posts how far it is; ending it is `terminate()`. */
import { type BuildJob, type BuildMessage, buildAndTell } from './build-job.ts';

self.onmessage = (event: MessageEvent<BuildJob>) => {
  for (const message of buildAndTell(event.data)) post(message);
};

/** What the worker no longer needs goes over without a copy. */
function post(message: BuildMessage): void {
  const { bvh } = message;
  self.postMessage(message, { transfer: bvh ? [bvh.bounds.buffer, bvh.links.buffer, bvh.order.buffer] : [] });
}
