import { expect, test } from 'vitest';
import { formatPointer, parsePointer } from './pointer.ts';

test('the examples of RFC 6901', () => {
  expect(parsePointer('')).toEqual([]);
  expect(parsePointer('/')).toEqual(['']);
  expect(parsePointer('/foo/0')).toEqual(['foo', '0']);
  expect(parsePointer('/a~1b')).toEqual(['a/b']);
  expect(parsePointer('/m~0n')).toEqual(['m~n']);
  expect(parsePointer('/~01')).toEqual(['~1']);
});

test('what is no pointer gives null', () => {
  for (const text of ['a', 'a/b', '/~', '/~2', '/a~']) expect(parsePointer(text)).toBeNull();
});

test('segments survive the way there and back', () => {
  for (const segments of [[], [''], ['a/b', '~1', '~', 'red ball', '0']]) {
    expect(parsePointer(formatPointer(segments))).toEqual(segments);
  }
});
