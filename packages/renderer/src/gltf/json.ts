/** The JSON of a glTF file that has been looked through (check/): what types say of it is true. */
import type { GLTF } from '@gltf-transform/core';

export type Gltf = GLTF.IGLTF;
export type AccessorJson = GLTF.IAccessor;
export type MaterialJson = GLTF.IMaterial;
export type PrimitiveJson = GLTF.IMeshPrimitive;
export type NodeJson = GLTF.INode;

/** A thing's extension of that name, or undefined. */
export function extensionOf<Extension = Record<string, unknown>>(
  thing: { readonly extensions?: unknown },
  name: string,
): Extension | undefined {
  const { extensions } = thing as { extensions?: Record<string, unknown> };
  return extensions && Object.hasOwn(extensions, name) ? (extensions[name] as Extension) : undefined;
}

export interface LightJson {
  readonly name?: string;
  readonly type: 'directional' | 'point' | 'spot';
  readonly color?: [number, number, number];
  readonly intensity?: number;
  readonly range?: number;
  readonly spot?: { readonly innerConeAngle?: number; readonly outerConeAngle?: number };
}

export const lightsOf = (json: Gltf): readonly LightJson[] =>
  extensionOf<{ lights: LightJson[] }>(json as object, 'KHR_lights_punctual')?.lights ?? [];

export const variantsOf = (json: Gltf): readonly { readonly name: string }[] =>
  extensionOf<{ variants: { name: string }[] }>(json as object, 'KHR_materials_variants')?.variants ?? [];

/** How many numbers an element has, by an accessor's type. */
export const WIDTHS: Readonly<Record<string, number>> = {
  SCALAR: 1,
  VEC2: 2,
  VEC3: 3,
  VEC4: 4,
  MAT2: 4,
  MAT3: 9,
  MAT4: 16,
};
/** Bytes of a number, by its component type. */
export const SIZES: Readonly<Record<number, number>> = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 };
