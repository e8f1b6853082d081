import * as v from 'valibot';
import { IMAGE_ENDINGS } from '../scene/textures.ts';
import { pictureRule } from './picture-rule.ts';
import { choice, fileName, flag, nameOf, number, object, pair } from './values.ts';

/** Images, textures and their uses: the part of the schema that says what is drawn on surfaces. */

const file = fileName(pictureRule, IMAGE_ENDINGS);
const imageRule = 'an image: the name of its file, or an object with "file"';
export const image = v.pipe(
  v.union([file, object(imageRule, { file })], imageRule),
  v.description(imageRule),
  v.transform((given) => (typeof given === 'string' ? { file: given } : given)),
);

const wrap = (what: string) => v.optional(choice(what, ['repeat', 'clamp', 'mirror']));
export const texture = object('a texture: an object with "image"', {
  image: nameOf('an image'),
  wrapU: wrap('what lies to the left and right of the image'),
  wrapV: wrap('what lies above and below the image'),
  filter: v.optional(choice('what lies between the centres of pixels', ['linear', 'nearest'])),
  mipmaps: v.optional(flag('whether a smaller copy is used far away')),
});

const useRule = 'a texture: its name, the name of an image or of its file, or an object with "texture"';
const fields = {
  texture: nameOf('a texture'),
  uvSet: v.optional(v.picklist([0, 1], 'which set of coordinates: 0 or 1')),
  offset: v.optional(pair('the offset of the coordinates', -1e6, 1e6)),
  rotation: v.optional(number('the turn of the coordinates, degrees', -1e6, 1e6)),
  scale: v.optional(pair('the factors of the coordinates', -1e6, 1e6)),
};
const asUse = <Entries extends v.ObjectEntries>(entries: Entries) =>
  v.optional(
    v.pipe(
      v.union([nameOf('a texture'), object(useRule, entries)], useRule),
      v.description(useRule),
      v.transform((given) => (typeof given === 'string' ? { texture: given } : given)),
    ),
  );
export const textureUse = asUse(fields);
export const normalTextureUse = asUse({
  ...fields,
  normalScale: v.optional(number('the strength of the bumps', -1e3, 1e3)),
});
