/** A process of its own: opens broken files one after the other and tells what came of each. */
import { fileSubjects } from '../../tests/fixtures/fuzz/file-subjects.ts';
import { brokenFiles } from '../../tests/fixtures/fuzz/mutations.ts';
import { viteServer } from './vite-server.ts';

export interface Task {
  readonly seed: number;
  readonly first: number;
  readonly end: number;
}
export interface Broken {
  readonly index: number;
  readonly outcome: string | null;
  /** Why it is bad; null when it is not. */
  readonly bad: string | null;
  readonly milliseconds: number;
  /** Of arrays that it left behind or still had, as far as that can be seen. */
  readonly bytes: number;
}

/** Arrays of numbers that a small file may make: images claim most. */
const MOST_BYTES = 2 ** 30;

const { seed, first, end } = JSON.parse(process.argv[2]!) as Task;
const server = await viteServer();
const { outcomeOf } = (await server.ssrLoadModule(
  '/tests/fixtures/fuzz/fuzz-files.ts',
)) as typeof import('../../tests/fixtures/fuzz/fuzz-files.ts');
const subjects = fileSubjects();
for (let index = first; index < end; index++) {
  const { subject, files } = brokenFiles(subjects, seed, index);
  const [begun, before] = [performance.now(), process.memoryUsage().arrayBuffers];
  let [outcome, bad]: [string | null, string | null] = [null, null];
  try {
    outcome = await outcomeOf(files, subject.broken);
  } catch (error) {
    bad = error instanceof Error ? (error.stack ?? error.message) : String(error);
  }
  const bytes = process.memoryUsage().arrayBuffers - before;
  if (bad === null && bytes > MOST_BYTES) bad = `made ${bytes} bytes of arrays`;
  process.send!({ index, outcome, bad, milliseconds: performance.now() - begun, bytes } satisfies Broken);
}
await server.close();
process.disconnect();
