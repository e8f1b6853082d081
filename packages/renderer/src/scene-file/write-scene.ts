import type { MeshSource } from '../scene/mesh.ts';
import type { Scene, Sky } from '../scene/scene.ts';
import { naturalRoughness, sceneSchema } from './schema.ts';
import { entryOf, optionOfType, type SchemaTree, treeOf, unwrap } from './schema-tree.ts';

/**
 * The text of a scene file for this scene: defaults left out, and what fits on a line in one line, so that a person can
 * read it. `parseScene` reads it back to an equal scene. `schema` is the address of the JSON Schema, for editors.
 */
export function writeScene(scene: Scene, schema?: string): string {
  const sky = writtenSky(scene.sky);
  const materials = Object.entries(scene.materials).map(([name, { roughness, ...rest }]) => {
    const natural = roughness === naturalRoughness(rest.type);
    return [name, natural ? rest : { ...rest, roughness }] as const;
  });
  const file = {
    ...(schema === undefined ? {} : { $schema: schema }),
    ...scene,
    sky,
    materials: Object.fromEntries(materials),
    ...(scene.meshes ? { meshes: writtenMeshes(scene.meshes) } : {}),
  };
  return `${format(withoutDefaults(treeOf(sceneSchema), file), '', 0)}\n`;
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

/** As `writtenSky`, of triangles. */
function writtenMeshes(meshes: Readonly<Record<string, MeshSource>>): object {
  const written = Object.entries(meshes).map(([name, { data: _, ...source }]) => {
    if (source.file === undefined)
      throw new TypeError(`The mesh "${name}" has no file: give it the name that the file will have.`);
    return [name, source] as const;
  });
  return Object.fromEntries(written);
}

function withoutDefaults(schema: SchemaTree, value: unknown): unknown {
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
