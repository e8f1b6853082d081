/** How materials name textures. */
import { type Form, index, integer, number, numbers, object } from './form.ts';

const transform = object({}, { offset: numbers(2), rotation: number(), scale: numbers(2), texCoord: integer(0) });
const fields = { index: index('textures') };
const optional = { texCoord: integer(0), extensions: object({}, { KHR_texture_transform: transform }) };

export const textureInfo: Form = object(fields, optional);
export const normalTexture: Form = object(fields, { ...optional, scale: number() });
export const occlusionTexture: Form = object(fields, { ...optional, strength: number() });
