import { deflateRawSync } from 'node:zlib';
import { expect, test } from 'vitest';
import { readZip } from './npz.ts';
import { reduce } from './reduce.ts';

test('means are averaged, independent errors add in quadrature', () => {
  const rgb = (x: number) => [x, 2 * x, 0];
  const mean = [1, 2, 3, 4, 5, 6, 7, 8].flatMap(rgb);
  const error = [3, 4, 0, 0, 0, 0, 1, 0].flatMap(rgb);
  const small = reduce({ width: 4, height: 2, mean, error }, 2);
  expect([small.width, small.height]).toEqual([2, 1]);
  expect([...(small.mean as Float64Array)]).toEqual([3.5, 7, 0, 5.5, 11, 0]);
  for (const [i, e] of [5 / 4, 10 / 4, 0, 1 / 4, 2 / 4, 0].entries()) expect(small.error[i]).toBeCloseTo(e, 8);
  expect(() => reduce(small, 2)).toThrow('2 × 1 cannot be divided by 2');
});

test('values without noise keep the error of their rounding', () => {
  const { error } = reduce({ width: 1, height: 1, mean: [1, 1, 0], error: [0, 0, 0] }, 1);
  expect(error[0]).toBeGreaterThan(5e-6);
  expect(error[0]).toBeLessThan(2e-5);
  expect(error[2]).toBe(0);
});

test('reads stored and deflated members of an archive', () => {
  const member = (name: string, method: number, content: Buffer, at: number) => {
    const packed = method === 8 ? deflateRawSync(content) : content;
    const local = Buffer.alloc(30);
    local.writeUInt32LE(0x04034b50, 0);
    local.writeUInt16LE(name.length, 26);
    const entry = Buffer.alloc(46);
    entry.writeUInt32LE(0x02014b50, 0);
    entry.writeUInt16LE(method, 10);
    entry.writeUInt32LE(packed.length, 20);
    entry.writeUInt16LE(name.length, 28);
    entry.writeUInt32LE(at, 42);
    const label = Buffer.from(name);
    return { local: Buffer.concat([local, label, packed]), entry: Buffer.concat([entry, label]) };
  };
  const a = member('mean.npy', 8, Buffer.from('x'.repeat(1000)), 0);
  const b = member('se.npy', 0, Buffer.from('yz'), a.local.length);
  const end = Buffer.alloc(22);
  end.writeUInt32LE(0x06054b50, 0);
  end.writeUInt16LE(2, 10);
  end.writeUInt32LE(a.local.length + b.local.length, 16);
  const members = readZip(Buffer.concat([a.local, b.local, a.entry, b.entry, end, Buffer.from('comment')]));
  expect([...members].map(([name, bytes]) => [name, Buffer.from(bytes).toString()])).toEqual([
    ['mean.npy', 'x'.repeat(1000)],
    ['se.npy', 'yz'],
  ]);
  expect(() => readZip(Buffer.alloc(100))).toThrow('no ZIP');
});
