/** What a thread of the CPU backend does: traces the rows that it is told to. The job comes with its start. */
import { parentPort, workerData } from 'node:worker_threads';
import { type FilmJob, referenceRows } from 'mirrorball/headless';

export interface RowsTask {
  readonly run: number;
  readonly sample: number;
  readonly firstRow: number;
  readonly rowCount: number;
}
export interface RowsReply extends RowsTask {
  readonly pixels: Float32Array<ArrayBuffer>;
}

export function serveRows(): void {
  const port = parentPort!;
  const trace = referenceRows(workerData as FilmJob);
  port.on('message', (task: RowsTask) => {
    const pixels = trace(task.sample, task.firstRow, task.rowCount);
    const reply: RowsReply = { ...task, pixels };
    port.postMessage(reply, [pixels.buffer]);
  });
}
