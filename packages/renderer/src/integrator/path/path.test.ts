import { expect, test } from 'vitest';
import { groupsOf } from './path.ts';

test('groups that some samples touch', () => {
  const touched = [
    groupsOf(0, 1),
    groupsOf(0, 32),
    groupsOf(31, 2),
    groupsOf(0, 256),
    groupsOf(20, 250),
    groupsOf(256, 256),
  ];
  expect(touched).toEqual([1, 1, 2, 8, 9, 8]);
});
