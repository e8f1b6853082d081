/** The worker that makes files, and what speaks with it. All of this comes with the first file that is saved. */
import type { SavingJob, SavingMessage, Written } from './job.ts';
import SavingWorker from './saving.worker.ts?worker&inline';

/** Rejects with the signal's reason when that is aborted, and with an Error that says why there is no file. */
export async function writeInWorker(
  job: SavingJob,
  onProgress: (share: number) => void,
  signal: AbortSignal,
): Promise<Written> {
  signal.throwIfAborted();
  const worker = new SavingWorker();
  try {
    return await new Promise<Written>((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      worker.onmessage = ({ data }: MessageEvent<SavingMessage>) => {
        if ('share' in data) onProgress(data.share);
        else if ('failed' in data) reject(new Error(data.failed));
        else resolve(data.written);
      };
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error(event.message || 'the worker that makes files could not be started'));
      };
      worker.onmessageerror = () => reject(new Error('the file is larger than this browser can take'));
      // The page goes on with its scene, so that the worker has a copy; a film is nobody else's.
      worker.postMessage(job, 'film' in job ? [job.film.pixels.buffer] : []);
    });
  } finally {
    worker.terminate();
  }
}
