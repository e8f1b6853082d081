import { type FieldName, type FieldType, fieldOffset, STRUCTS, type StructName } from './layout.ts';

/** One block of bytes seen as floats and as unsigned integers. */
export interface Block {
  readonly bytes: ArrayBuffer;
  readonly f32: Float32Array<ArrayBuffer>;
  readonly u32: Uint32Array<ArrayBuffer>;
}

export function createBlock(byteLength: number): Block {
  const bytes = new ArrayBuffer(byteLength);
  return { bytes, f32: new Float32Array(bytes), u32: new Uint32Array(bytes) };
}

/** Types of whole numbers; all others are floats. */
const WHOLE: ReadonlySet<FieldType> = new Set<FieldType>(['u32', 'vec2u', 'vec4u']);

/** Numbers for each field: one, or as many as its vector (or array of vectors) has. Fields left out stay as they are. */
export type StructValues<S extends StructName> = { readonly [F in FieldName<S>]?: number | readonly number[] };

/** Places values at the struct that begins `at` bytes into the block. */
export function writeStruct<S extends StructName>(block: Block, name: S, at: number, values: StructValues<S>): void {
  const fields = STRUCTS[name] as Record<string, { type: FieldType }>;
  for (const key in values) {
    const value = values[key as FieldName<S>] as number | readonly number[];
    const type = fields[key]!.type;
    const target = WHOLE.has(typeof type === 'object' ? type.array : type) ? block.u32 : block.f32;
    const start = (at + fieldOffset(name, key as FieldName<S>)) / 4;
    if (typeof value === 'number') target[start] = value;
    else target.set(value, start);
  }
}
