/**
 * A job goes to a browser as JSON, and its large contents (the sky's map, the triangles of meshes, images) apart from it, once each, their lists of
 * numbers in pieces: as one message they take a browser's memory many times over. There a content stays the same object from job to job,
 * as long as it is wanted, so that what was made of it need not be made again.
 */

export type NumberArray = Float32Array | Uint32Array | Uint16Array | Uint8Array;
const KINDS = { Float32Array, Uint32Array, Uint16Array, Uint8Array };
export type ArrayKind = keyof typeof KINDS;

const isArray = (value: unknown): value is NumberArray => Object.values(KINDS).some((kind) => value instanceof kind);
export const kindOf = (array: NumberArray): ArrayKind =>
  (Object.keys(KINDS) as ArrayKind[]).find((kind) => array instanceof KINDS[kind])!;
export const createArray = (kind: ArrayKind, length: number): NumberArray => new KINDS[kind](length);

/** The key of what stands where something was taken out. Names in scenes do not begin with a space, so it is nobody's. */
const CONTENT = ' content';
interface Detached {
  readonly [CONTENT]: number;
}
const isDetached = (value: object): value is Detached => CONTENT in value;

/** The value with what `numberOf` gives a number for replaced by that number. */
function detach<Value>(value: Value, numberOf: (part: object) => number | null): Value {
  const change = (part: unknown): unknown => {
    if (typeof part !== 'object' || part === null) return part;
    const number = numberOf(part);
    return number === null ? mapParts(part, change) : ({ [CONTENT]: number } satisfies Detached);
  };
  return change(value) as Value;
}

/** The other way: what was taken out, by its number, in its place. */
export function attach<Value>(value: Value, partOf: (number: number) => object): Value {
  const change = (part: unknown): unknown => {
    if (typeof part !== 'object' || part === null) return part;
    return isDetached(part) ? partOf(part[CONTENT]) : mapParts(part, change);
  };
  return change(value) as Value;
}

const mapParts = (value: object, change: (part: unknown) => unknown): object =>
  Array.isArray(value)
    ? value.map(change)
    : Object.fromEntries(Object.entries(value).map(([key, part]) => [key, change(part)] as const));

/** A job without its contents: objects that have a list of numbers. */
export const detachContents = <Job>(job: Job, numberOf: (content: object) => number): Job =>
  detach(job, (part) => (!Array.isArray(part) && Object.values(part).some(isArray) ? numberOf(part) : null));

/** A content without its lists of numbers, and the lists. */
export function detachArrays(content: object): { readonly frame: object; readonly arrays: readonly NumberArray[] } {
  const arrays: NumberArray[] = [];
  const frame = detach(content, (part) => (isArray(part) ? arrays.push(part) - 1 : null));
  return { frame, arrays };
}
