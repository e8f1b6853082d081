/** Elements of Mitsuba's scene files: a plugin with parameters and other plugins in it. */

export interface Element {
  readonly tag: string;
  readonly attributes: Readonly<Record<string, string>>;
  readonly children: readonly Element[];
}

const element = (tag: string, attributes: Readonly<Record<string, string>>, ...children: readonly Element[]): Element => ({ tag, attributes, children }); // biome-ignore format: one expression

/** A plugin such as `<bsdf type="diffuse">`; `name`: what the plugin around calls it. */
export const plugin = (tag: string, type: string, children: readonly Element[], more: Readonly<Record<string, string>> = {}): Element => element(tag, { type, ...more }, ...children); // biome-ignore format: one expression

export const scene = (children: readonly Element[]): Element => element('scene', { version: '3.0.0' }, ...children);

/** Enough digits to be the same in 32 bits, and mostly the number as it was written. */
const digits = (x: number): string => String(Number(x.toPrecision(12)));
const list = (numbers: readonly number[]): string => numbers.map(digits).join(', ');
const value = (tag: string, name: string, text: string): Element => element(tag, { name, value: text });

export const float = (name: string, x: number): Element => value('float', name, digits(x));
export const integer = (name: string, x: number): Element => value('integer', name, String(x));
export const boolean = (name: string, x: boolean): Element => value('boolean', name, String(x));
export const string = (name: string, text: string): Element => value('string', name, text);
export const rgb = (name: string, color: readonly number[]): Element => value('rgb', name, list(color));
export const vector = (name: string, v: readonly number[]): Element => value('vector', name, list(v));
export const point = (name: string, v: readonly number[]): Element => value('point', name, list(v));
export const numbers = (name: string, all: readonly number[]): Element => string(name, list(all));
export const reference = (id: string): Element => element('ref', { id });

/** 12 or 16 numbers, row by row. */
export const toWorld = (matrix: ArrayLike<number>): Element =>
  element(
    'transform',
    { name: 'to_world' },
    element('matrix', { value: [...Array.from(matrix).slice(0, 12), 0, 0, 0, 1].map(digits).join(' ') }),
  );

/** Of texture coordinates, u and v and 1, row by row; Mitsuba takes it for a matrix of space, whose third row and column it leaves out. */
export const toUv = ([a, b, x, c, d, y]: readonly number[]): Element =>
  element('transform', { name: 'to_uv' }, element('matrix', { value: [a!, b!, 0, x!, c!, d!, 0, y!, 0, 0, 1, 0, 0, 0, 0, 1].map(digits).join(' ') })); // biome-ignore format: one expression

export const lookAt = (origin: readonly number[], target: readonly number[], up: readonly number[], scale?: number): Element => element('transform', { name: 'to_world' }, ...(scale === undefined ? [] : [element('scale', { x: digits(scale), y: digits(scale) })]), element('lookat', { origin: list(origin), target: list(target), up: list(up) })); // biome-ignore format: one expression

const escaped = (text: string): string =>
  text.replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]!);

export function textOf({ tag, attributes, children }: Element, indent = ''): string {
  const head = [tag, ...Object.entries(attributes).map(([name, text]) => `${name}="${escaped(text)}"`)].join(' ');
  if (children.length === 0) return `${indent}<${head}/>\n`;
  return `${indent}<${head}>\n${children.map((child) => textOf(child, `${indent}  `)).join('')}${indent}</${tag}>\n`;
}
