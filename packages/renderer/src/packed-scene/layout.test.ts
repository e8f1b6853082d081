import { describe, expect, test } from 'vitest';
import { fieldOffset, STRUCTS, type StructName, structSize, TABLE_WIDTH, tableColumn } from './layout.ts';

/** WGSL, 14.4 "Memory layout": bytes and alignment, written down here a second time. */
const RULES: Record<string, [size: number, align: number]> = {
  f32: [4, 4],
  u32: [4, 4],
  vec2u: [8, 8],
  vec2f: [8, 8],
  vec3f: [12, 16],
  vec4f: [16, 16],
  vec4u: [16, 16],
};
const names = Object.keys(STRUCTS) as StructName[];
const fieldsOf = (name: StructName) => Object.entries(STRUCTS[name] as Record<string, { type: unknown }>);
const ruleOf = (type: unknown): [number, number] =>
  typeof type === 'string' ? RULES[type]! : [16 * (type as { length: number }).length, 16];
const offsetOf = (name: StructName, field: string) => fieldOffset(name, field as never);

describe.each(names)('%s', (name) => {
  test('every field is aligned, after the one before it, and as early as it may be', () => {
    let end = 0;
    for (const [field, { type }] of fieldsOf(name)) {
      const [size, align] = ruleOf(type);
      const offset = offsetOf(name, field);
      expect(offset % align, field).toBe(0);
      expect(offset, field).toBeGreaterThanOrEqual(end);
      expect(offset - end, field).toBeLessThan(align);
      end = offset + size;
    }
  });

  test('its size is whole texels of 16 bytes, with less than one of them unused', () => {
    const [field, { type }] = fieldsOf(name).at(-1)!;
    const end = offsetOf(name, field) + ruleOf(type)[0];
    expect(structSize(name) % 16).toBe(0);
    expect(structSize(name) - end).toBeGreaterThanOrEqual(0);
    expect(structSize(name) - end).toBeLessThan(16);
  });
});

test('the structs of the scene table stand side by side, and no field crosses a texel', () => {
  const table = ['Bounds', 'Extent', 'Material', 'Light', 'Surface', 'Emitter'] as const;
  let column = 0;
  for (const name of table) {
    expect(tableColumn(name)).toBe(column);
    column += structSize(name) / 16;
    for (const [field, { type }] of fieldsOf(name)) {
      const first = offsetOf(name, field);
      const last = first + ruleOf(type)[0] - 1;
      expect(Math.floor(first / 16), `${name}.${field}`).toBe(Math.floor(last / 16));
    }
  }
  expect(TABLE_WIDTH).toBe(column);
});
