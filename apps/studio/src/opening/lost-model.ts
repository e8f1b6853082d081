/** A page that is loaded again has no files any more. It remembers which model was on show, to say what to open once more. */
import { effect } from '@preact/signals';
import { notify } from '../notices.ts';
import { shown } from '../state.ts';

const KEY = 'mirrorball.model';

export function followModel(): void {
  try {
    const lost = sessionStorage.getItem(KEY);
    if (lost !== null) notify('file', (t) => t.modelLost(lost));
    effect(() => {
      const { id, fileName = '' } = shown.value ?? {};
      if (id === 'file') sessionStorage.setItem(KEY, fileName);
      else sessionStorage.removeItem(KEY);
    });
  } catch {
    // A browser that remembers nothing has nothing to say.
  }
}
