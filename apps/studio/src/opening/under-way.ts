/** What is being opened, at most one thing at a time. */
import { signal } from '@preact/signals';
import type { Phase } from './job.ts';

/** Its name and how far it is; null when nothing is being opened. */
export const opening = signal<{ readonly name: string; readonly phase: Phase; readonly share: number } | null>(null);

let current: AbortController | null = null;

/** Ends what is under way: the newest wish counts. */
export function beginOpening(): AbortController {
  cancelOpening();
  current = new AbortController();
  return current;
}

export function endOpening(mine: AbortController): void {
  if (current !== mine) return;
  current = null;
  opening.value = null;
}

/** What was on show stays. */
export function cancelOpening(): void {
  current?.abort(new DOMException('cancelled', 'AbortError'));
  current = null;
  opening.value = null;
}
