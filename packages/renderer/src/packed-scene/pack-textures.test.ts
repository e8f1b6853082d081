import { expect, test } from 'vitest';
import { testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import type { Scene } from '../scene/scene.ts';
import type { ImagePixels, TextureUse } from '../scene/textures.ts';
import { fieldOffset, LOOKUP_FLAGS, MATERIAL_FLAGS, structSize, TEXELS_OF_ROW, TEXTURE_SLOTS } from './layout.ts';
import { packTextures } from './pack-textures.ts';
import { isOneSided, mayBeMissing, slotsOf } from './texture-slots.ts';

const image = (width: number, height: number): ImagePixels => ({
  width,
  height,
  rgba: new Uint8Array(4 * width * height).fill(200),
});
const [small, large] = [image(3, 3), image(8, 4)];
const scene: Scene = {
  ...testScene({}, {}),
  images: { small: { data: small }, again: { data: small }, large: { data: large }, far: { file: 'far.png' } },
  textures: {
    small: { image: 'small' },
    again: { image: 'again', wrapU: 'clamp', wrapV: 'mirror', filter: 'nearest' },
    large: { image: 'large' },
    far: { image: 'far' },
  },
};
const use = (texture: string, part: Partial<TextureUse> = {}): TextureUse => ({ texture, ...part });
const layered = testMaterial({
  type: 'metallicRoughness',
  opacity: 0.5,
  alphaMode: 'mask',
  alphaCutoff: 0.25,
  baseColorTexture: use('small', { offset: [0.1, 0.2], rotation: 90, scale: [2, 3] }),
  metallicRoughnessTexture: use('again', { uvSet: 1 }),
  normalTexture: { ...use('large'), normalScale: 0.5 },
});

/** A field of the struct in this row. */
function reader({ uses }: ReturnType<typeof packTextures>['textures'], row: number) {
  return <Name extends 'MaterialTextures' | 'TextureUse'>(
    name: Name,
    field: Parameters<typeof fieldOffset<Name>>[1],
    kind: 'f32' | 'u32',
    count = 1,
  ) => Array.from(uses[kind].subarray(row * 4 + fieldOffset(name, field) / 4).subarray(0, count));
}

test('a material names its uses, and each use its image, which is there once', () => {
  const plain = testMaterial();
  const { textures, rowOf } = packTextures(scene, [plain, layered]);
  const row = rowOf.get(layered)!;
  const head = reader(textures, row);
  expect(head('MaterialTextures', 'count', 'u32')).toEqual([3]);
  expect(head('MaterialTextures', 'flags', 'u32')).toEqual([MATERIAL_FLAGS.hasOpacityTexture]);
  expect(head('MaterialTextures', 'opacity', 'f32', 2)).toEqual([0.5, 0.25]);
  const uses = [0, 1, 2].map((i) =>
    reader(textures, row + (structSize('MaterialTextures') + i * structSize('TextureUse')) / 16),
  );
  const [base, rough, normal] = uses as [(typeof uses)[0], (typeof uses)[0], (typeof uses)[0]];
  // KHR_texture_transform's example of a quarter turn: u′ = 0.1 + 3 v, v′ = 0.2 − 2 u.
  const rows = [base('TextureUse', 'toU', 'f32', 3), base('TextureUse', 'toV', 'f32', 3)].flat();
  [0, 3, 0.1, -2, 0, 0.2].forEach((x, i) => {
    expect(rows[i]).toBeCloseTo(x, 6);
  });
  expect(uses.map((one) => one('TextureUse', 'slot', 'u32')[0])).toEqual([
    TEXTURE_SLOTS.baseColorSlot,
    TEXTURE_SLOTS.metallicRoughnessSlot,
    TEXTURE_SLOTS.normalSlot,
  ]);
  const { isColor, usesSecondSet, isNearest, clampsU, mirrorsV } = LOOKUP_FLAGS;
  expect(base('TextureUse', 'flags', 'u32')).toEqual([isColor]);
  expect(rough('TextureUse', 'flags', 'u32')).toEqual([usesSecondSet | isNearest | clampsU | mirrorsV]);
  expect(normal('TextureUse', 'scale', 'f32')).toEqual([0.5]);
  expect(normal('TextureUse', 'width', 'u32', 2)).toEqual([8, 4]);
  // One image under two names; 9 texels take three rows.
  expect(textures.images.map(({ pixels }) => pixels)).toEqual([small, large]);
  const first = textures.images[0]!.row;
  expect(base('TextureUse', 'first', 'u32')).toEqual(rough('TextureUse', 'first', 'u32'));
  expect(base('TextureUse', 'first', 'u32')).toEqual([first * TEXELS_OF_ROW]);
  expect(textures.images[1]!.row).toBe(first + 3);
  expect(textures.rows).toBe(first + 3 + 8);
});

test('another number moves no image; one that has not been loaded is named', () => {
  const first = packTextures(scene, [layered]).textures;
  const moved = packTextures(scene, [{ ...layered, baseColorTexture: use('small', { offset: [0.7, 0] }) }]).textures;
  expect(moved.images).toEqual(first.images);
  expect(moved.rows).toBe(first.rows);
  expect(() => packTextures(scene, [testMaterial({ baseColorTexture: use('far') })])).toThrow(
    'The image "far" has not been loaded.',
  );
});

test('what makes no difference is not looked up', () => {
  const emissionTexture = use('small');
  const slots = (part: Parameters<typeof testMaterial>[0]) => slotsOf(testMaterial(part)).map(({ slot }) => slot);
  expect(slots({ emissionTexture })).toEqual([]);
  expect(slots({ emissionTexture, emission: [0, 1, 0] })).toEqual([TEXTURE_SLOTS.emissionSlot]);
  const baseColorTexture = use('small');
  expect(slots({ unlit: true, baseColorTexture, normalTexture: use('large') })).toEqual([TEXTURE_SLOTS.emissionSlot]);
});

test('which materials may not be there', () => {
  const missing = (part: Parameters<typeof testMaterial>[0]) => mayBeMissing(testMaterial(part), undefined);
  const baseColorTexture = use('small');
  expect(missing({ opacity: 0.2, baseColorTexture })).toBe(false);
  expect([missing({ alphaMode: 'blend' }), missing({ alphaMode: 'blend', opacity: 0.9 })]).toEqual([false, true]);
  expect(missing({ alphaMode: 'mask', opacity: 0.6 })).toBe(false);
  expect(missing({ alphaMode: 'mask', opacity: 0.6, alphaCutoff: 0.7 })).toBe(true);
  expect(missing({ alphaMode: 'blend', baseColorTexture })).toBe(true);
  const mesh = { positions: new Float32Array(9), indices: Uint32Array.of(0, 1, 2), colors: new Float32Array(12) };
  expect(mayBeMissing(testMaterial({ alphaMode: 'blend' }), mesh)).toBe(true);
  expect([isOneSided(testMaterial()), isOneSided(testMaterial({ doubleSided: false }))]).toEqual([false, true]);
  expect(isOneSided(testMaterial({ doubleSided: false, transmission: { weight: 1 } }))).toBe(false);
});
