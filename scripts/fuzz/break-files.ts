/**
 * Good files, broken at random and opened: a scene or problems may come of it, within a time and a memory, and nothing else. It happens in
 * another process, which is stopped when it hangs and begun again behind the file on which it did. What is bad is kept with all its files.
 */
import { fork } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { fileSubjects } from '../../tests/fixtures/fuzz/file-subjects.ts';
import { brokenFiles } from '../../tests/fixtures/fuzz/mutations.ts';
import type { Broken, Task } from './break-files.process.ts';

/** A small file takes some milliseconds; a machine may be busy. */
const LONGEST = 30_000;
/** Of its heap, MiB; arrays of numbers lie elsewhere and are told by it. */
const HEAP = 1024;

type Ended = { readonly done: true } | { readonly done: false; readonly index: number; readonly why: string };

export async function breakFiles(count: number, first: number, seed: number, keep: string): Promise<number> {
  const subjects = fileSubjects();
  const outcomes = new Map<string, number>();
  const begun = performance.now();
  let [bad, seen, slowest, largest] = [0, 0, 0, 0];
  const tell = (index: number, why: string) => {
    bad++;
    const { subject, files } = brokenFiles(subjects, seed, index);
    const folder = join(keep, `${seed}-${index}`);
    for (const [path, bytes] of Object.entries(files)) {
      mkdirSync(dirname(join(folder, path)), { recursive: true });
      writeFileSync(join(folder, path), bytes);
    }
    console.log(`  file ${index}, ${subject.name}: ${why}\n    kept in ${folder}`);
  };
  const take = ({ index, outcome, bad: why, milliseconds, bytes }: Broken) => {
    seen++;
    slowest = Math.max(slowest, milliseconds);
    largest = Math.max(largest, bytes);
    if (why !== null) tell(index, why);
    else outcomes.set(outcome!, (outcomes.get(outcome!) ?? 0) + 1);
    if (seen % 2000 === 0) console.log(`  ${seen} files, ${bad} bad, slowest ${slowest.toFixed(0)} ms`);
  };
  for (let at = first; at < first + count; ) {
    const ended = await work({ seed, first: at, end: first + count }, take);
    if (ended.done) break;
    tell(ended.index, ended.why);
    at = ended.index + 1;
  }
  const told = [...outcomes].map(([what, number]) => `${what} ${number}`).join(', ');
  const seconds = ((performance.now() - begun) / 1000).toFixed(0);
  console.log(`files: ${count} (seed ${seed}, from ${first}) of ${subjects.length} kinds: ${told}, bad ${bad}. ${seconds} s, slowest ${slowest.toFixed(0)} ms, largest ${(largest / 2 ** 20).toFixed(0)} MiB.`); // biome-ignore format: one sentence
  return bad;
}

function work(task: Task, take: (broken: Broken) => void): Promise<Ended> {
  return new Promise((resolve) => {
    const child = fork(fileURLToPath(new URL('./break-files.process.ts', import.meta.url)), [JSON.stringify(task)], {
      execArgv: ['--import', 'tsx', `--max-old-space-size=${HEAP}`],
    });
    let index = task.first;
    const end = (ended: Ended) => {
      clearTimeout(timer);
      child.kill('SIGKILL');
      resolve(ended);
    };
    const late = () => end({ done: false, index, why: `took longer than ${LONGEST / 1000} s` });
    let timer = setTimeout(late, 2 * LONGEST);
    child.on('message', (broken: Broken) => {
      clearTimeout(timer);
      timer = setTimeout(late, LONGEST);
      take(broken);
      index = broken.index + 1;
    });
    child.on('error', (error: Error) => end({ done: false, index, why: `its process failed: ${error.message}` }));
    child.on('exit', (code) =>
      end(index >= task.end ? { done: true } : { done: false, index, why: `its process ended with ${code}` }),
    );
  });
}
