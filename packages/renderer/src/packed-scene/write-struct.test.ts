import { expect, test } from 'vitest';
import { fieldOffset, structSize } from './layout.ts';
import { createBlock, writeStruct } from './write-struct.ts';

test('floats and whole numbers go where the layout says, in their own encoding', () => {
  const size = structSize('Frame');
  const block = createBlock(2 * size);
  const values = { width: 640, lightCount: 3, seed: 2 ** 32 - 1, jitter: [0.25, 0.75], shapeEnds: [1, 2, 3, 4] };
  writeStruct(block, 'Frame', size, values);
  const view = new DataView(block.bytes);
  const at = (field: Parameters<typeof fieldOffset<'Frame'>>[1]) => size + fieldOffset('Frame', field);
  expect(view.getFloat32(at('width'), true)).toBe(640);
  expect(view.getUint32(at('lightCount'), true)).toBe(3);
  expect(view.getUint32(at('seed'), true)).toBe(2 ** 32 - 1);
  expect(view.getFloat32(at('jitter') + 4, true)).toBe(0.75);
  expect([0, 4, 8, 12].map((k) => view.getUint32(at('shapeEnds') + k, true))).toEqual([1, 2, 3, 4]);
  expect(new Uint8Array(block.bytes, 0, size).every((byte) => byte === 0)).toBe(true);
});

test('an array of vectors is written whole; fields left out keep what they had', () => {
  const block = createBlock(structSize('Frame'));
  const panels = Array.from({ length: 12 }, (_, k) => k + 1);
  writeStruct(block, 'Frame', 0, { panels, height: 7 });
  writeStruct(block, 'Frame', 0, { width: 9 });
  const start = fieldOffset('Frame', 'panels') / 4;
  expect(Array.from(block.u32.subarray(start, start + 12))).toEqual(panels);
  expect(block.f32[fieldOffset('Frame', 'height') / 4]).toBe(7);
});

test('a vector does not run over into the field that shares its texel', () => {
  const block = createBlock(structSize('Bounds'));
  writeStruct(block, 'Bounds', 0, { radius: 5 });
  writeStruct(block, 'Bounds', 0, { center: [1, 2, 3] });
  expect(Array.from(block.f32)).toEqual([1, 2, 3, 5]);
});
