import { expect, test } from 'vitest';
import { duration, figure, frequency } from './status-line.tsx';

test('figures keep three digits', () => {
  expect([0, 0.4249, 4.2, 9.949, 9.96, 42.42, 99.6, 1234.5].map(figure)).toEqual([
    '0',
    '0.42',
    '4.20',
    '9.95',
    '10.0',
    '42.4',
    '100',
    '1235',
  ]);
  expect(figure(Number.NaN)).toBe('–');
});

test('times read like a clock', () => {
  expect([0, 7.9, 60, 725, 3725].map(duration)).toEqual(['0:00', '0:07', '1:00', '12:05', '1:02:05']);
});

test('few frames a second are told in tenths', () =>
  expect([0, 0.438, 9.94, 9.96, 59.9].map(frequency)).toEqual(['0', '0.4', '9.9', '10', '60']));
