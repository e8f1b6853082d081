import { expect, test } from 'vitest';
import { factLines } from './fact-lines.ts';

test('facts are lines; things have a line for each part, lists stand in one', () => {
  const camera = { eye: [0, 1.33580546498, 4], up: [0, 1, 0], projection: 'perspective' };
  expect(factLines({ kind: 'scene', shapes: { sphere: 2, box: 1 }, cameras: ['near', 'far'], camera })).toEqual([
    'kind         scene',
    'shapes       sphere         2',
    '             box            1',
    'cameras      near, far',
    'camera       eye            0, 1.33581, 4',
    '             up             0, 1, 0',
    '             projection     perspective',
  ]);
});

test('what is written as JSON is opened, what is long is told by its length, notes have lines', () => {
  const notes = ['Occlusion textures are kept but not used: paths find out.', 'Short.'];
  expect(factLines({ Render: '{"seed":7,"region":[0,0,4,4]}', Scene: 'x'.repeat(1000), notes, empty: '' })).toEqual([
    'Render       seed           7',
    '             region         0, 0, 4, 4',
    'Scene        1000 characters, whole with --json',
    `notes        ${notes[0]}`,
    '             Short.',
    'empty',
  ]);
  const scene = JSON.stringify({ a: 'y'.repeat(4000) });
  expect(factLines({ Scene: scene, broken: '{no' })).toEqual([
    'Scene        1 entries, whole with --json',
    'broken       {no',
  ]);
  expect(factLines({ channels: { R: { least: 0, most: 1.5 } } })).toEqual([
    'channels     R              least 0, most 1.5',
  ]);
});
