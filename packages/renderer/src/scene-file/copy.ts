import { SCENE_LIMITS } from '../scene/limits.ts';
import { clip, describe, nearest, type Path, type ProblemList, quote } from './problem.ts';
import { arrayOption, entryOf, mostOf, objectOption, optionOfType, type SchemaTree, unwrap } from './schema-tree.ts';

/**
 * Copies what the schema knows out of a value of which nothing is known: it may be cyclic, endless, a proxy, or have
 * getters that throw. The copy is plain, at most as deep as the schema, and at most as large as the limits allow; what
 * cannot be copied is replaced by a symbol whose description says what was there, so that the schema refuses it at
 * its place. Unknown keys and reserved names are reported here.
 */
export function copyBySchema(schema: SchemaTree, value: unknown, path: Path, problems: ProblemList): unknown {
  return copy(schema, value, path, { problems, left: SCENE_LIMITS.fileValues });
}

/** Thrown, and caught by the reader, when a file holds more values than one may. */
export class TooManyValues extends Error {}

interface Progress {
  readonly problems: ProblemList;
  left: number;
}

/** Names that objects of JavaScript have by nature. */
const RESERVED = ['__proto__', 'constructor', 'prototype'];
const MOST_UNKNOWN_KEYS = 1000;

function copy(schema: SchemaTree, value: unknown, path: Path, progress: Progress): unknown {
  if (--progress.left < 0) throw new TooManyValues();
  if (typeof value === 'number') return value === 0 ? 0 : value; // −0 is 0: JSON writes it so
  if (typeof value === 'string' || typeof value === 'boolean' || value === null || value === undefined) return value;
  if (typeof value !== 'object') return foreign(value);
  const form = formFor(unwrap(schema), value);
  try {
    if (isList(value)) return form?.type === 'array' ? copyList(form, value, path, progress) : foreign(value);
    if (Object.prototype.toString.call(value) !== '[object Object]') return foreign(value);
    if (form?.type === 'strict_object') return copyObject(form, value, path, progress);
    if (form?.type === 'record') return copyNamed(form, value, path, progress);
  } catch (error) {
    if (error instanceof TooManyValues) throw error;
    return Symbol('something that throws when it is read');
  }
  return foreign(value);
}

const foreign = (value: unknown): symbol => Symbol(describe(value));

/** Which of the forms that the schema allows this object or list has. */
function formFor(schema: SchemaTree, value: object): SchemaTree | undefined {
  if (schema.type === 'union') return isList(value) ? arrayOption(schema) : objectOption(schema);
  if (schema.type !== 'variant') return schema;
  // Of an unknown type: still an object, whose keys cannot be judged.
  return isList(value) ? undefined : (optionOfType(schema, read(value, 'type')) ?? { type: 'strict_object' });
}

function isList(value: object): value is readonly unknown[] {
  try {
    return Array.isArray(value) || value instanceof Float32Array; // a program may have its numbers so
  } catch {
    return false;
  }
}

function read(value: object, key: string): unknown {
  try {
    return Object.hasOwn(value, key) ? (value as Record<string, unknown>)[key] : undefined;
  } catch {
    return Symbol('something that throws when it is read');
  }
}

function copyList(schema: SchemaTree, list: readonly unknown[], path: Path, progress: Progress): unknown {
  const length = list.length;
  if (length > mostOf(schema)) return Symbol(`a list of ${length} items`);
  const result: unknown[] = [];
  for (let index = 0; index < length; index++) {
    const item = read(list, String(index));
    result.push(schema.item ? copy(schema.item, item, [...path, index], progress) : item);
  }
  return result;
}

function copyObject(schema: SchemaTree, object: object, path: Path, progress: Progress): object {
  const result: Record<string, unknown> = Object.create(null);
  if (schema.entries === undefined) return { type: describeType(object) };
  const known = Object.keys(schema.entries);
  for (const key of known) {
    const value = read(object, key);
    if (value !== undefined) result[key] = copy(schema.entries[key]!, value, [...path, key], progress);
  }
  let unknown = 0;
  for (const key in object) {
    if (entryOf(schema, key) || !Object.hasOwn(object, key)) continue;
    if (++unknown > MOST_UNKNOWN_KEYS) break;
    reportUnknownKey(key, known, path, progress.problems);
  }
  return result;
}

/** What stands as the type of a shape whose type is not one. */
function describeType(object: object): unknown {
  const type = read(object, 'type');
  return typeof type === 'object' && type !== null ? foreign(type) : type;
}

function reportUnknownKey(key: string, known: readonly string[], path: Path, problems: ProblemList): void {
  const meant = nearest(key, known);
  const hint = meant === null ? '' : ` Did you mean "${meant}"?`;
  const allowed = `the keys ${known.map((name) => `"${name}"`).join(', ')}.${hint}`.replace(/\.$/, '');
  const message = `The key ${quote(key)} is not known here; ${allowed.replace('the keys', 'known are')}${hint === '' ? '.' : ''}`;
  problems.add([...path, key], `the unknown key ${quote(key)}`, allowed, message);
}

function copyNamed(schema: SchemaTree, object: object, path: Path, progress: Progress): unknown {
  const most = mostOf(schema);
  const result: Record<string, unknown> = Object.create(null);
  const normalized = new Map<string, string>();
  let count = 0;
  for (const name in object) {
    if (!Object.hasOwn(object, name)) continue;
    if (++count > most) return Symbol(`more than ${most} names`);
    const value = read(object, name);
    if (value === undefined) continue;
    if (RESERVED.includes(name)) {
      const allowed = 'another name';
      progress.problems.add(
        [...path, name],
        `the reserved name "${name}"`,
        allowed,
        `"${name}" cannot be a name, as JavaScript uses it for itself; please choose another.`,
      );
      continue;
    }
    const alike = clip(name, SCENE_LIMITS.nameLength + 1).normalize('NFC');
    const twin = normalized.get(alike);
    if (twin !== undefined) {
      progress.problems.add(
        [...path, name],
        `a name that looks the same as another, ${quote(name)}`,
        'names that can be told apart',
      );
      continue;
    }
    normalized.set(alike, name);
    result[name] = copy(schema.value!, value, [...path, name], progress);
  }
  return result;
}
