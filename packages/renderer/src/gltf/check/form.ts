/**
 * What a value of a glTF file's JSON must look like. A form adds a problem for what it does not allow; it changes nothing and makes
 * nothing, so that a file is judged before anything is read by its numbers. Keys that no form names are not looked at.
 */
import { type ProblemList, quote } from '../../scene-file/problem.ts';
import { addProblem, describe, type Path } from '../problems.ts';

export interface Check {
  readonly problems: ProblemList;
  /** How many things the file has in one of its lists, such as "accessors". */
  readonly count: (list: string) => number;
}

export type Form = (value: unknown, path: Path, check: Check) => void;

const refuse = ({ problems }: Check, path: Path, value: unknown, allowed: string): void =>
  addProblem(problems, path, describe(value), allowed);

export const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** A finite number. */
export const number = (least = -Number.MAX_VALUE, most = Number.MAX_VALUE): Form => {
  const range = least > -Number.MAX_VALUE || most < Number.MAX_VALUE ? ` from ${least} to ${most}` : '';
  return (value, path, check) => {
    if (typeof value === 'number' && value >= least && value <= most) return;
    refuse(
      check,
      path,
      value,
      `a number${most === Number.MAX_VALUE && least !== -Number.MAX_VALUE ? ` from ${least} on` : range}`,
    );
  };
};

/** A whole number. */
export const integer = (least: number, most = Number.MAX_SAFE_INTEGER): Form => {
  const range = most === Number.MAX_SAFE_INTEGER ? `from ${least} on` : `from ${least} to ${most}`;
  return (value, path, check) => {
    if (Number.isSafeInteger(value) && (value as number) >= least && (value as number) <= most) return;
    refuse(check, path, value, `a whole number ${range}`);
  };
};

/** The place of a thing in one of the file's lists. */
export const index = (list: string): Form => {
  return (value, path, check) => {
    const count = check.count(list);
    if (Number.isSafeInteger(value) && (value as number) >= 0 && (value as number) < count) return;
    const allowed =
      count === 0 ? `nothing, as the file has no ${list}` : `a place among its ${list}, 0 to ${count - 1}`;
    refuse(check, path, value, allowed);
  };
};

export const text: Form = (value, path, check) => {
  if (typeof value !== 'string') refuse(check, path, value, 'a text');
};

export const flag: Form = (value, path, check) => {
  if (typeof value !== 'boolean') refuse(check, path, value, 'true or false');
};

export const choice = (...options: readonly (string | number)[]): Form => {
  const allowed = options.map((option) => (typeof option === 'string' ? quote(option) : option)).join(', ');
  return (value, path, check) => {
    if (!options.includes(value as string | number)) refuse(check, path, value, allowed);
  };
};

/** A list of so many finite numbers. */
export const numbers = (length: number, most = Number.MAX_VALUE): Form => {
  const item = number(-most, most);
  return (value, path, check) => {
    if (!Array.isArray(value) || value.length !== length) refuse(check, path, value, `a list of ${length} numbers`);
    else for (let i = 0; i < length; i++) item(value[i], [...path, i], check);
  };
};

/** A matrix of 4 × 4, column by column, whose last row is 0 0 0 1 but for rounding: nodes carry no perspective. */
export const affine = (most: number): Form => {
  const all = numbers(16, most);
  return (value, path, check) => {
    all(value, path, check);
    if (!Array.isArray(value)) return;
    const row = [3, 7, 11, 15].map((i) => value[i] as unknown);
    const isNear = (x: unknown, i: number): boolean => typeof x !== 'number' || Math.abs(x - (i === 3 ? 1 : 0)) < 1e-3;
    if (!row.every(isNear)) addProblem(check.problems, path, `a matrix whose last row is ${row.join(' ')}`, '0 0 0 1 there'); // biome-ignore format: one line
  };
};

export const list = (item: Form, least = 0): Form => {
  const allowed = least === 0 ? 'a list' : `a list of at least ${least}`;
  return (value, path, check) => {
    if (!Array.isArray(value) || value.length < least) refuse(check, path, value, allowed);
    else for (let i = 0; i < value.length; i++) item(value[i], [...path, i], check);
  };
};

/** An object whose values all have one form. */
export const map = (item: Form, least = 0): Form => {
  return (value, path, check) => {
    const keys = isObject(value) ? Object.keys(value) : [];
    if (!isObject(value) || keys.length < least)
      refuse(check, path, value, least === 0 ? 'an object' : `an object with at least ${least} key`);
    else for (const key of keys) item(value[key], [...path, key], check);
  };
};

/** An object with these fields; those that are named first must be there. */
export const object = (
  required: Readonly<Record<string, Form>>,
  optional: Readonly<Record<string, Form>> = {},
): Form => {
  return (value, path, check) => {
    if (!isObject(value)) {
      refuse(check, path, value, 'an object');
      return;
    }
    for (const [key, form] of Object.entries(required)) form(own(value, key), [...path, key], check);
    for (const [key, form] of Object.entries(optional)) {
      const field = own(value, key);
      if (field !== undefined) form(field, [...path, key], check);
    }
  };
};

/** Both. */
export const both = (...forms: readonly Form[]): Form => {
  return (value, path, check) => {
    for (const form of forms) form(value, path, check);
  };
};

/** JSON may have keys such as "__proto__". */
const own = (value: Record<string, unknown>, key: string): unknown =>
  Object.hasOwn(value, key) ? value[key] : undefined;
