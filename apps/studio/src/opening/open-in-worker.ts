/** The page's door to what opens files, which it does not wait for at its start. */
import type { Opened, OpenedEnvironment, OpeningMessage, PathFile, Phase } from './job.ts';

export type OnPhase = (phase: Phase, share: number) => void;

/** Rejects with the signal's reason when that is aborted. */
export async function openInWorker(files: readonly PathFile[], onPhase: OnPhase, signal: AbortSignal): Promise<Opened> {
  const { startJob } = await import('./start-job.ts');
  signal.throwIfAborted();
  const hear = (message: OpeningMessage): Opened | undefined => ('opened' in message ? message.opened : tell(message, onPhase)); // biome-ignore format: short
  return startJob({ kind: 'model', files }, hear, signal);
}

/** A picture of all around, .hdr or .exr. */
export async function openSkyInWorker(file: File, onPhase: OnPhase, signal: AbortSignal): Promise<OpenedEnvironment> {
  const { startJob } = await import('./start-job.ts');
  signal.throwIfAborted();
  const hear = (message: OpeningMessage): OpenedEnvironment | undefined => ('environment' in message ? message.environment : tell(message, onPhase)); // biome-ignore format: short
  return startJob({ kind: 'environment', file }, hear, signal);
}

function tell(message: OpeningMessage, onPhase: OnPhase): undefined {
  if ('phase' in message) onPhase(message.phase, message.share);
}
