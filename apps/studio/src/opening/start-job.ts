/** The worker and what speaks with it. All of this comes with the first file that is opened. */
import { answerParts } from './answer-parts.ts';
import type { OpeningJob, OpeningMessage } from './job.ts';
import OpeningWorker from './opening.worker.ts?worker&inline';

/** A worker that has answered waits so long for the next file, milliseconds; then its memory is given back. */
const WAITS = 3000;

let idle: { readonly worker: Worker; readonly timer: ReturnType<typeof setTimeout> } | null = null;

function takeWorker(): Worker {
  if (idle) {
    const { worker, timer } = idle;
    clearTimeout(timer);
    idle = null;
    return worker;
  }
  const worker = new OpeningWorker();
  answerParts(worker);
  return worker;
}

function keepWorker(worker: Worker): void {
  const end = (): void => {
    idle = null;
    worker.terminate();
  };
  idle = { worker, timer: setTimeout(end, WAITS) };
}

/**
 * Gives the worker's messages to `hear` until there is an answer, which it resolves with. Rejects with the signal's reason when that is
 * aborted, and with an Error when the worker fails, as it does without memory. One job at a time.
 */
export async function startJob<Answer>(
  job: OpeningJob,
  hear: (message: OpeningMessage) => Answer | undefined,
  signal: AbortSignal,
): Promise<Answer> {
  const worker = takeWorker();
  const done = new AbortController();
  try {
    const answer = await new Promise<Answer>((resolve, reject) => {
      const until = { signal: done.signal };
      signal.addEventListener('abort', () => reject(signal.reason), until);
      const heard = ({ data }: MessageEvent<OpeningMessage | { readonly part: string }>): void => {
        if ('part' in data) return;
        if ('failed' in data) reject(new Error(data.failed));
        const last = hear(data);
        if (last !== undefined) resolve(last);
      };
      const failed = (event: ErrorEvent): void => {
        event.preventDefault();
        reject(new Error(event.message || 'the worker that opens files could not be started'));
      };
      const lost = (): void => reject(new Error('the answer is larger than this browser can take'));
      worker.addEventListener('message', heard, until);
      worker.addEventListener('error', failed, until);
      worker.addEventListener('messageerror', lost, until);
      worker.postMessage(job);
    });
    keepWorker(worker);
    return answer;
  } catch (error) {
    worker.terminate();
    throw error;
  } finally {
    done.abort();
  }
}
