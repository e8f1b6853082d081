/**
 * A signal that comes when the time is over, and with every interruption. By hand, since in Node 20 what `AbortSignal.any` makes of a
 * timeout may be collected as garbage before it fires.
 */
export function startClock(
  seconds: number | undefined,
  interrupted: AbortSignal,
): { signal: AbortSignal; stop: () => void } {
  const controller = new AbortController();
  const abort = () => controller.abort();
  interrupted.addEventListener('abort', abort);
  if (interrupted.aborted) abort();
  // Timers cannot wait longer than 2^31 - 1 milliseconds.
  const timer = seconds === undefined ? undefined : setTimeout(abort, Math.min(seconds * 1000, 2 ** 31 - 1));
  const stop = () => {
    clearTimeout(timer);
    interrupted.removeEventListener('abort', abort);
  };
  return { signal: controller.signal, stop };
}
