/** The worker and what speaks with it. All of this comes with the first file that is opened. */
import { answerParts } from './answer-parts.ts';
import type { OpeningJob, OpeningMessage } from './job.ts';
import OpeningWorker from './opening.worker.ts?worker&inline';

/**
 * Gives the worker's messages to `hear` until there is an answer, which it resolves with. Rejects with the signal's reason when that is
 * aborted, and with an Error when the worker fails, as it does without memory.
 */
export function startJob<Answer>(
  job: OpeningJob,
  hear: (message: OpeningMessage) => Answer | undefined,
  signal: AbortSignal,
): Promise<Answer> {
  const worker = new OpeningWorker();
  answerParts(worker);
  return new Promise<Answer>((resolve, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason), { once: true });
    worker.addEventListener('message', ({ data }: MessageEvent<OpeningMessage | { readonly part: string }>) => {
      if (signal.aborted || 'part' in data) return;
      if ('failed' in data) return reject(new Error(data.failed));
      const answer = hear(data);
      if (answer !== undefined) resolve(answer);
    });
    worker.addEventListener('error', (event) => {
      event.preventDefault();
      reject(new Error(event.message || 'the worker that opens files could not be started'));
    });
    worker.addEventListener('messageerror', () => reject(new Error('the answer is larger than this browser can take')));
    worker.postMessage(job);
  }).finally(() => worker.terminate());
}
