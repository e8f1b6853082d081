/**
 * What reading, writing and key checking need to know of a schema: the part of valibot's objects that this folder
 * looks into, in one place.
 */
export interface SchemaTree {
  /** Such as "strict_object", "record", "array", "variant", "union", "optional". */
  readonly type: string;
  /** Of a strict object: its keys. */
  readonly entries?: Readonly<Record<string, SchemaTree>>;
  /** Of an array: its items. */
  readonly item?: SchemaTree;
  /** Of a record: what stands under each name. */
  readonly value?: SchemaTree;
  /** Of a union or variant. */
  readonly options?: readonly SchemaTree[];
  /** Of a literal. */
  readonly literal?: unknown;
  /** Of an optional value: the schema within, and what stands for a value left out. */
  readonly wrapped?: SchemaTree;
  readonly default?: unknown;
  readonly pipe?: readonly { readonly type: string; readonly requirement?: unknown }[];
}

export const treeOf = (schema: object): SchemaTree => schema as SchemaTree;

/** The schema under `optional`. */
export const unwrap = (schema: SchemaTree): SchemaTree => (schema.wrapped ? unwrap(schema.wrapped) : schema);

/** The schema of a key, or undefined; safe for any key. */
export const entryOf = (schema: SchemaTree, key: string): SchemaTree | undefined =>
  schema.entries && Object.hasOwn(schema.entries, key) ? schema.entries[key] : undefined;

/** How many items or names the schema allows. */
export function mostOf(schema: SchemaTree): number {
  const rule = schema.pipe?.find(({ type }) => type === 'max_length' || type === 'max_entries' || type === 'length');
  return typeof rule?.requirement === 'number' ? rule.requirement : Number.POSITIVE_INFINITY;
}

/** Among shapes, the one whose "type" is this. */
export function optionOfType(schema: SchemaTree, type: unknown): SchemaTree | undefined {
  return schema.options?.find((option) => entryOf(option, 'type')?.literal === type);
}

/** Among the forms of a union, the object. */
export const objectOption = (schema: SchemaTree): SchemaTree | undefined =>
  schema.options?.find((option) => option.type === 'strict_object');

/** Among the forms of a union, the list. */
export const arrayOption = (schema: SchemaTree): SchemaTree | undefined =>
  schema.options?.find((option) => option.type === 'array');
