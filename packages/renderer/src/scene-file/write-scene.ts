import { AFFINE_LENGTH } from '../scene/affine.ts';
import type { MeshSource } from '../scene/mesh.ts';
import type { Clip, SceneNode } from '../scene/nodes.ts';
import type { Scene, Shape, Sky } from '../scene/scene.ts';
import type { ImageSource } from '../scene/textures.ts';
import { withoutModels } from './model-things.ts';
import { lengthOf } from './node-schema.ts';
import { naturalRoughness, sceneSchema } from './schema.ts';
import { entryOf, optionOfType, type SchemaTree, treeOf, unwrap } from './schema-tree.ts';

/**
 * The text of a scene file for this scene: defaults left out, and what fits on a line in one line, so that a person can
 * read it. `parseScene` reads it back to an equal scene. `schema` is the address of the JSON Schema, for editors.
 */
export function writeScene(scene: Scene, schema?: string): string {
  const sky = writtenSky(scene.sky);
  const own = withoutModels(scene);
  const materials = Object.entries(own.materials).map(([name, { roughness, ...rest }]) => {
    const natural = roughness === naturalRoughness(rest.type);
    return [name, withShortUses(natural ? rest : { ...rest, roughness })] as const;
  });
  const file = {
    ...(schema === undefined ? {} : { $schema: schema }),
    ...own,
    sky,
    materials: Object.fromEntries(materials),
    ...(own.meshes ? { meshes: writtenFiles('mesh', own.meshes) } : {}),
    ...(own.images ? { images: writtenFiles('image', own.images) } : {}),
    ...(own.nodes ? { nodes: mapValues(own.nodes, writtenNode) } : {}),
    ...(own.clips ? { clips: mapValues(own.clips, writtenClip) } : {}),
    ...(own.models ? { models: mapValues(own.models, ({ things: _, ...model }) => model) } : {}),
    shapes: mapValues(own.shapes, writtenShape),
  };
  return `${format(withoutDefaults(treeOf(sceneSchema), file), '', 0)}\n`;
}

const mapValues = <From, To>(things: Readonly<Record<string, From>>, change: (thing: From) => To) =>
  Object.fromEntries(Object.entries(things).map(([name, thing]) => [name, change(thing)] as const));

/** A use with nothing but a name is that name. */
function withShortUses(part: unknown): unknown {
  if (typeof part !== 'object' || part === null || Array.isArray(part)) return part;
  const keys = Object.keys(part);
  const { texture } = part as { texture?: unknown };
  if (keys.length === 1 && typeof texture === 'string') return texture;
  return mapValues(part as Readonly<Record<string, unknown>>, withShortUses);
}

const AT_REST = { translation: [0, 0, 0], rotation: [0, 0, 0, 1], scale: [1, 1, 1] } as const;

const writtenNode = (node: SceneNode): object =>
  Object.fromEntries(
    Object.entries(node).filter(([key, value]) => !equal(value, AT_REST[key as keyof typeof AT_REST])),
  );

/** As long as its tracks, when it does not say. */
const writtenClip = ({ duration, ...clip }: Clip): object =>
  duration === lengthOf(clip.tracks) ? clip : { duration, ...clip };

/** Instances one by one. */
function writtenShape(shape: Shape): object {
  if (shape.type !== 'mesh' || !shape.instances) return shape;
  const { instances, ...rest } = shape;
  const count = instances.length / AFFINE_LENGTH;
  const rows = Array.from({ length: count }, (_, i) => instances.slice(i * AFFINE_LENGTH, (i + 1) * AFFINE_LENGTH));
  return { ...rest, instances: rows };
}

/** Throws a TypeError when what it shows is in no file. */
function writtenSky({ horizon, zenith, image, map, scale = 1, rotation = 0 }: Sky): object {
  if (map && image === undefined)
    throw new TypeError('The sky has a map without a file: give sky.image the name that the file will have.');
  const same = equal(horizon, zenith);
  if (image === undefined) return same ? horizon : { horizon, zenith };
  const colours = same && Math.max(...horizon) === 0 ? {} : { horizon, zenith };
  return { ...colours, image, ...(scale === 1 ? {} : { scale }), ...(rotation === 0 ? {} : { rotation }) };
}

/** As `writtenSky`, of triangles and pixels. */
function writtenFiles(what: string, sources: Readonly<Record<string, MeshSource | ImageSource>>): object {
  const written = Object.entries(sources).map(([name, { data: _, ...source }]) => {
    if (source.file === undefined)
      throw new TypeError(`The ${what} "${name}" has no file: give it the name that the file will have.`);
    return [name, source] as const;
  });
  return Object.fromEntries(written);
}

function withoutDefaults(schema: SchemaTree, value: unknown): unknown {
  if (value instanceof Float32Array) return Array.from(value, shortest);
  const form = unwrap(schema);
  if (Array.isArray(value)) return form.item ? value.map((item) => withoutDefaults(form.item!, item)) : value;
  if (typeof value !== 'object' || value === null) return value;
  const kind = form.type === 'variant' ? optionOfType(form, (value as { type?: unknown }).type) : form;
  const kept = Object.entries(value).flatMap(([key, part]): [string, unknown][] => {
    const entry = (kind && entryOf(kind, key)) ?? kind?.value;
    if (entry === undefined) return [[key, part]];
    const slim = withoutDefaults(entry, part);
    return entry.type === 'optional' && equal(slim, entry.default) ? [] : [[key, slim]];
  });
  return Object.fromEntries(kept);
}

/** The number of the fewest digits that is the same in 32 bits. */
function shortest(x: number): number {
  for (let digits = 6; digits < 9; digits++) {
    const short = Number(x.toPrecision(digits));
    if (Math.fround(short) === x) return short;
  }
  return x;
}

/** Whether two plain values are the same in content and order. */
const equal = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);

const LINE = 100;

/** JSON with every value on one line that fits there; what lies directly in the file or a section gets its own lines. */
function format(value: unknown, indent: string, depth: number): string {
  const line = inline(value);
  const numbers = Array.isArray(value) && typeof value[0] === 'number';
  const short = depth > 1 && indent.length + line.length <= LINE;
  if (typeof value !== 'object' || value === null || short || numbers) return line;
  const inner = `${indent}  `;
  const isList = Array.isArray(value);
  const parts = isList
    ? value.map((item) => inner + format(item, inner, depth + 1))
    : Object.entries(value).map(([key, part]) => `${inner}${JSON.stringify(key)}: ${format(part, inner, depth + 1)}`);
  const [open, close] = isList ? '[]' : '{}';
  return parts.length === 0 ? `${open}${close}` : `${open}\n${parts.join(',\n')}\n${indent}${close}`;
}

function inline(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(inline).join(', ')}]`;
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const parts = Object.entries(value).map(([key, part]) => `${JSON.stringify(key)}: ${inline(part)}`);
  return parts.length === 0 ? '{}' : `{ ${parts.join(', ')} }`;
}
