import { expect, test } from 'vitest';
import { whyUnreadable } from './scene-source.ts';

test('a name that is no file: the built-in scenes, and the one that was meant', () => {
  const missing = (file: string) => whyUnreadable(file, Object.assign(new Error('no such file'), { code: 'ENOENT' }));
  expect(missing('cube-rom')).toMatch(
    /no file cube-rom, .*: these are cube-room, .*materials\. Did you mean cube-room\?$/,
  );
  expect(missing('scenes/house.json')).not.toContain('Did you mean');
  expect(whyUnreadable('a', new Error('EACCES: permission denied'))).toBe(
    'The scene a cannot be read: EACCES: permission denied.',
  );
});
