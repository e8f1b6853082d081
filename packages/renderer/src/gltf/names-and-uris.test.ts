import { describe, expect, test } from 'vitest';
import { readDataUri } from './base64.ts';
import { fileNameOf } from './file-name.ts';
import { Names } from './names.ts';

describe('names', () => {
  test('are there once, and such as a scene file could hold', () => {
    const names = new Names();
    const make = (wanted?: string) => names.unique(wanted, 'node 7');
    expect([make('a'), make('a'), make('a 2'), make('a'), make(), make(''), make(' b\n\tc ')]).toEqual([
      'a',
      'a 2',
      'a 2 2',
      'a 3',
      'node 7',
      'node 7 2',
      'b c',
    ]);
    expect([make('__proto__'), make('constructor'), make('__proto__')]).toEqual([
      '__proto__ 2',
      'constructor 2',
      '__proto__ 3',
    ]);
    expect(make('x'.repeat(5000))).toHaveLength(180);
    expect(make('\u200b\u202e')).toBe('node 7 3');
    // The same letters in another normal form look the same.
    expect([make('é'), make('e\u0301')]).toEqual(['é', 'e\u0301 2']);
  });

  test('a hundred thousand of one name take no time', () => {
    const names = new Names();
    const start = process.cpuUsage();
    for (let i = 0; i < 100_000; i++) names.unique('same', '');
    // Of this process alone, however busy the machine is; a search from the first number on each time would take minutes.
    expect(process.cpuUsage(start).user).toBeLessThan(2e6);
  });
});

describe('data URIs', () => {
  test('base64 of any length, with breaks in lines, and in the letters of addresses', () => {
    for (let length = 0; length < 12; length++) {
      const bytes = Uint8Array.from({ length }, (_, i) => 250 + i * 37);
      const text = Buffer.from(bytes).toString('base64');
      for (const form of [text, text.replace(/(..)/g, '$1\n'), Buffer.from(bytes).toString('base64url')])
        expect(readDataUri(`data:application/octet-stream;base64,${form}`)).toEqual({
          type: 'application/octet-stream',
          bytes,
        });
    }
  });

  test('text, and what is neither', () => {
    expect(readDataUri('data:text/plain,a%20b')).toEqual({ type: 'text/plain', bytes: Uint8Array.of(97, 32, 98) });
    expect(readDataUri('data:image/PNG;charset=x;base64,')).toEqual({ type: 'image/png', bytes: new Uint8Array() });
    expect(readDataUri('data:;base64,é')).toContain('not base64');
    expect(readDataUri('data:nothing')).toContain('without a comma');
    expect(readDataUri('data:,%')).toContain('% sign');
  });
});

test('names of files beside a file', () => {
  expect(fileNameOf('a.bin')).toEqual({ name: 'a.bin' });
  expect(fileNameOf('./x/../y//z%20z.png')).toEqual({ name: 'y/z z.png' });
  expect(fileNameOf('100%.bin')).toEqual({ name: '100%.bin' });
  for (const uri of ['', '..', 'x/../..', '/x', 'http:x', 'a\\b', 'a\u0000b', '%2Fetc'])
    expect(fileNameOf(uri)).toHaveProperty('fault');
});
