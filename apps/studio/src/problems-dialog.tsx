import { useSignal } from '@preact/signals';
import type { Problem } from 'mirrorball';
import { refusedFile } from './actions.ts';
import { Dialog } from './controls/dialog.tsx';
import { type Dictionary, dictionary } from './i18n.ts';

const asText = (problems: readonly Problem[], t: Dictionary): string =>
  problems.map((problem) => `${problem.path === '' ? '' : `${problem.path}: `}${t.problem(problem)}`).join('\n');

/** Puts the text on the clipboard; where the browser refuses, it selects the list, ready to be copied by hand. */
async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const list = document.querySelector('.problems');
    if (list) getSelection()?.selectAllChildren(list);
    return false;
  }
}

/** What a file names and what did not come with it; a model may name dozens, and one sentence is enough for all. */
const MISSING = /it is missing: open (.+) together with/;
const missingFile = ({ message }: Problem): string | null => MISSING.exec(message)?.[1] ?? null;

/** Everything that is wrong with a scene file that was refused. */
export function ProblemsDialog() {
  const t = dictionary.value;
  const copied = useSignal(false);
  const file = refusedFile.value;
  const problems = file?.problems ?? [];
  const missing = problems.map(missingFile).filter((name) => name !== null);
  const others = problems.filter((problem) => missingFile(problem) === null);
  const close = (): void => {
    refusedFile.value = null;
    copied.value = false;
  };
  const copy = (
    <button
      id="copy-problems"
      type="button"
      class="button"
      onClick={async () => (copied.value = await copyText(asText(problems, t)))}
    >
      {copied.value ? t.copied : t.copy}
    </button>
  );
  return (
    <Dialog id="problems" title={t.problemsTitle(file?.name ?? '')} open={file} onClose={close} actions={copy}>
      {missing.length > 0 && (
        <>
          <p>{t.missingFiles}</p>
          <ul class="problems missing">
            {[...new Set(missing)].map((name) => (
              <li key={name}>{name}</li>
            ))}
          </ul>
        </>
      )}
      {others.length > 0 && (
        <>
          <p>{t.problemsIntro}</p>
          <ol class="problems">
            {others.map((problem, i) => (
              <ProblemItem key={i} {...problem} />
            ))}
          </ol>
        </>
      )}
    </Dialog>
  );
}

function ProblemItem(problem: Problem) {
  const t = dictionary.value;
  return (
    <li>
      {problem.path !== '' && <code class="path">{problem.path}</code>}
      <p>{t.problem(problem)}</p>
    </li>
  );
}
