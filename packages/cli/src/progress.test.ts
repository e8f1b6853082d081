import { expect, test } from 'vitest';
import { secondsLeft, startProgress, startTrees } from './progress.ts';
import { duration, openTerminal, type Terminal } from './terminal.ts';

const goal = { picture: 'a.exr', held: 0, wanted: 100 };

test('time left follows the samples, the error and the time, whichever ends first', () => {
  expect(secondsLeft(goal, 25, null, 10)).toBe(30);
  expect(secondsLeft({ ...goal, held: 20 }, 60, null, 10)).toBe(10);
  // Half the error needs four times the samples: 40 in all, 30 more at 0.5 s.
  expect(secondsLeft({ ...goal, untilError: 0.01 }, 10, 0.02, 5)).toBe(15);
  expect(secondsLeft({ ...goal, untilTime: 12 }, 25, null, 10)).toBe(2);
  expect(secondsLeft(goal, 0, null, 10)).toBe(Number.POSITIVE_INFINITY);
});

test('plain lines now and then where nothing can be drawn over itself', () => {
  const notes: string[] = [];
  const events: unknown[] = [];
  const silent = { json: false, live: false, result: () => {}, error: () => {} };
  const terminal: Terminal = { ...silent, note: (text) => notes.push(text), event: (...e) => events.push(e) };
  let now = 0;
  const progress = startProgress(terminal, goal, () => now);
  for (let samples = 1; samples <= 30; samples++) {
    now = samples;
    progress.update(samples, samples > 20 ? 0.0123 : null);
  }
  expect(notes[0]).toBe('a.exr: 5 of 100 samples, error –, 1 min 35 s left');
  expect(notes.at(-1)).toBe('a.exr: 30 of 100 samples, error 1.2 %, 1 min 10 s left');
  expect(notes).toHaveLength(6);
});

test('trees: a line now and then when they take long, else none; numbers for programs', () => {
  const toldAt = (seconds: number, json: boolean) => {
    const notes: string[] = [];
    const events: unknown[] = [];
    const silent = { json, live: false, result: () => {}, error: () => {} };
    const terminal: Terminal = { ...silent, note: (text) => notes.push(text), event: (...e) => events.push(e) };
    let now = 0;
    const trees = startTrees(terminal, 'a.exr', () => now);
    for (let k = 0; k < 100; k++) {
      now = (seconds * k) / 100;
      trees.update(k / 100);
    }
    trees.stop();
    return { notes, events };
  };
  expect(toldAt(4, false).notes).toEqual([]);
  expect(toldAt(12, false).notes).toEqual(['a.exr: building trees, 42 %', 'a.exr: building trees, 84 %']);
  expect(toldAt(1, true).events).toEqual([['preparing', { picture: 'a.exr', step: 'trees', done: 0.5 }]]);
});

test('durations as people say them', () => {
  expect([0.04, 9.96, 59, 61, 3599, 7500, Number.POSITIVE_INFINITY].map(duration)).toEqual([
    '0.0 s',
    '10.0 s',
    '59 s',
    '1 min 1 s',
    '59 min 59 s',
    '2 h 5 min',
    '–',
  ]);
});

/** A stream that keeps what it is given. */
const stream = (isTTY: boolean) => {
  const kept = { isTTY, text: '', write: (text: string) => Boolean((kept.text += text)) };
  return kept;
};

test('colour on a terminal only, and not under NO_COLOR', () => {
  const said = (isTTY: boolean, env: Record<string, string>) => {
    const [stdout, stderr] = [stream(isTTY), stream(isTTY)];
    openTerminal(false, env, { stdout, stderr }).error('no');
    return stderr.text;
  };
  expect(said(true, {})).toBe('\u001b[31mno\u001b[39m\n');
  expect(said(true, { NO_COLOR: '1' })).toBe('no\n');
  expect(said(true, { TERM: 'dumb' })).toBe('no\n');
  expect(said(false, {})).toBe('no\n');
});

test('with --json standard output has objects only, without it none', () => {
  for (const json of [true, false]) {
    const [stdout, stderr] = [stream(false), stream(false)];
    const terminal = openTerminal(json, {}, { stdout, stderr });
    terminal.event('done', { samples: 3 });
    terminal.result('finished');
    terminal.note('going on');
    expect(stdout.text).toBe(json ? '{"event":"done","samples":3}\n' : 'finished\n');
    expect(stderr.text).toBe(json ? '' : 'going on\n');
  }
});
