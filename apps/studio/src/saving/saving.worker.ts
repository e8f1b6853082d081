/** Makes one file away from the page, which stays alive; then it is ended, as also when nobody wants the file any more. */
import type { SavingJob, SavingMessage } from './job.ts';
import { written } from './written.ts';

const post = (message: SavingMessage) => self.postMessage(message);

self.onmessage = ({ data }: MessageEvent<SavingJob>) => {
  written(data, (share) => post({ share })).then(
    (file) => post({ written: file }),
    (error: unknown) => post({ failed: error instanceof Error ? error.message : String(error) }),
  );
};
