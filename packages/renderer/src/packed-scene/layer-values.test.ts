import { expect, test } from 'vitest';
import { testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import { pathFeatures } from '../integrator/path/path-features.ts';
import { isClear, isLayered, isSolid } from '../scene/layered.ts';
import { stillMoment } from '../scene/motion.ts';
import type { Material, Shape } from '../scene/scene.ts';
import { loadGeometryPacker } from './geometry-packer.ts';
import { layerValues } from './layer-values.ts';
import { fieldOffset, TABLE_WIDTH, tableColumn } from './layout.ts';
import { emittersOf } from './pack-emitters.ts';
import { packPathScene } from './pack-path-scene.ts';
import { surfaceValues } from './surface-values.ts';

const plastic = (part: Partial<Material> = {}) => testMaterial({ type: 'metallicRoughness', ...part });
const ball = (material: string): Shape => ({ type: 'sphere', center: [0, 0, 0], radius: 1, material });
const floor: Shape = { type: 'plane', point: [0, -1, 0], normal: [0, 1, 0], material: 'wall' };
const wall = plastic({ transmission: { weight: 1 } });

test('a material has layers when one of them makes a difference', () => {
  const none = [
    plastic(),
    plastic({ clearcoat: { weight: 0, roughness: 1 }, sheen: { color: [0, 0, 0], roughness: 1 }, dispersion: 3 }),
    plastic({ metallic: 1, transmission: { weight: 1 } }),
    plastic({ specularLobe: { weight: 1, color: [1, 1, 1] }, volume: { thickness: 1 } }),
    plastic({ unlit: true, clearcoat: { weight: 1, roughness: 0 } }),
    testMaterial({ type: 'diffuse', clearcoat: { weight: 1, roughness: 0 } }),
  ];
  for (const material of none) expect(isLayered(material)).toBe(false);
  const some = [
    wall,
    plastic({ ior: 1.33 }),
    plastic({ ior: 0 }),
    plastic({ specularLobe: { weight: 0.5, color: [1, 1, 1] } }),
    plastic({ sheen: { color: [0, 0.1, 0], roughness: 0 } }),
    plastic({ anisotropy: { strength: 0.1, rotation: 0 } }),
  ];
  for (const material of some) expect(isLayered(material)).toBe(true);
});

test('a program has of the layers only what some material of the scene has', () => {
  const LAYERS = ['hasCoats', 'hasSheen', 'hasGrain', 'hasTransmission', 'hasIridescence'] as const;
  const asked = (...list: Material[]) => {
    const named = list.map((material, i) => [`m${i}`, material] as const);
    const shapes = Object.fromEntries(named.map(([name]) => [name, ball(name)]));
    const scene = testScene(shapes, {}, { materials: Object.fromEntries(named) });
    const needs = pathFeatures({ scene, camera: scene.camera, settings: { pixelFilter: 'box' } });
    return [needs.has('hasLayers'), LAYERS.filter((layer) => needs.has(layer))];
  };
  const coated = plastic({ clearcoat: { weight: 0.5, roughness: 0 } });
  const cloth = plastic({ sheen: { color: [0, 0.1, 0], roughness: 0 } });
  const brushed = plastic({ anisotropy: { strength: 0.1, rotation: 0 } });
  const leaf = plastic({ diffuseTransmission: { weight: 0.1, color: [1, 1, 1] } });
  const bubble = plastic({ iridescence: { weight: 0.1, ior: 1.3, thicknessMinimum: 400, thicknessMaximum: 400 } });
  expect(asked(plastic())).toEqual([false, []]);
  expect(asked(plastic({ ior: 1.33 }))).toEqual([true, []]);
  expect(asked(coated)).toEqual([true, ['hasCoats']]);
  expect(asked(cloth)).toEqual([true, ['hasSheen']]);
  expect(asked(brushed)).toEqual([true, ['hasGrain']]);
  expect(asked(wall)).toEqual([true, ['hasTransmission']]);
  expect(asked(leaf, coated)).toEqual([true, ['hasCoats', 'hasTransmission']]);
  expect(asked(bubble)).toEqual([true, ['hasIridescence']]);
});

test('light goes through, and bodies are solid, only where something lets it in', () => {
  expect([isClear(wall), isSolid(wall)]).toEqual([true, false]);
  const volume = { thickness: 1 };
  expect(isSolid({ ...wall, volume })).toBe(true);
  expect(isSolid(plastic({ volume }))).toBe(false);
  expect(isSolid(plastic({ volume, diffuseTransmission: { weight: 0.1, color: [1, 1, 1] } }))).toBe(true);
  const attenuation = { attenuationColor: [0.5, 0.5, 0.5], attenuationDistance: 1 } as const;
  expect(surfaceValues({ ...wall, ...attenuation }, null, 0, 7).absorption).toEqual([0, 0, 0]);
  expect((surfaceValues({ ...wall, ...attenuation, volume }, null, 0, 7).absorption as number[])[0]).toBeCloseTo(
    Math.LN2,
  );
  expect(surfaceValues(wall, null, 0, 7).eta).toEqual([-7, 0, 0]);
  expect(surfaceValues(plastic({ ior: 2 }), null, 0, 7).eta).toEqual([7, 0, 0]);
});

test('layers lie in rows of their own, one for each material that is used', async () => {
  await loadGeometryPacker();
  const materials = {
    wall,
    coated: plastic({ clearcoat: { weight: 0.25, roughness: 0.5 } }),
    spare: wall,
    plain: plastic(),
  };
  const shapes = { a: ball('coated'), b: ball('wall'), c: ball('coated'), d: ball('plain') };
  const scene = testScene(shapes, {}, { materials });
  const { table, rows, shapeNames } = packPathScene(stillMoment(scene), [0, 0, 5]);
  const at = (row: number, struct: 'Surface' | 'Layers', byte: number) =>
    table.f32[row * TABLE_WIDTH * 4 + tableColumn(struct) * 4 + byte / 4]!;
  const layersOf = (name: string) => at(shapeNames.indexOf(name), 'Surface', fieldOffset('Surface', 'eta'));
  expect(layersOf('a')).toBe(layersOf('c'));
  expect(layersOf('b')).toBeLessThan(0);
  expect(layersOf('d')).toBe(0);
  expect(new Set([layersOf('a'), -layersOf('b')])).toEqual(new Set([rows - 2, rows - 1]));
  expect(at(layersOf('a'), 'Layers', fieldOffset('Layers', 'coat'))).toBe(0.25);
  const needs = pathFeatures({ scene, camera: scene.camera, settings: { pixelFilter: 'box' } });
  expect([needs.has('hasLayers'), needs.has('hasIridescence')]).toEqual([true, false]);
});

test('an endless index is a large one, without dispersion; angles of the grain are in degrees', () => {
  const values = layerValues(plastic({ ior: 0, dispersion: 1, anisotropy: { strength: 1, rotation: 90 } }));
  expect([values.ior, values.dispersion]).toEqual([1e6, 0]);
  expect((values.grain as number[])[1]).toBeCloseTo(1, 12);
});

test('what is unlit has no layers; what shines through a coat is not looked for as a lamp, since it is not as bright to all sides', () => {
  const unlit = plastic({
    unlit: true,
    baseColor: [0.5, 0.25, 1],
    emission: [9, 9, 9],
    clearcoat: { weight: 1, roughness: 0 },
  });
  const values = surfaceValues(unlit, null);
  expect([values.emission, values.baseColor, (values.eta as number[])[0]]).toEqual([[0.5, 0.25, 1], [0, 0, 0], 0]);
  const coated = plastic({ emission: [1, 1, 1], clearcoat: { weight: 1, roughness: 0 } });
  const materials = { unlit, coated, lamp: plastic({ emission: [1, 1, 1] }) };
  const scene = testScene(
    { a: ball('unlit'), b: ball('coated'), c: ball('lamp') },
    {},
    { materials, sky: { horizon: [0, 0, 0], zenith: [0, 0, 0] } },
  );
  const { emitterOfShape } = emittersOf({ scene, lightOfShape: new Map() }, [0, 0, 5], () => 0);
  expect([...emitterOfShape.keys()].sort()).toEqual(['a', 'c']);
});

test('a plane that light should go through, and textures of layers, are refused by name', () => {
  expect(() => packPathScene(stillMoment(testScene({ floor }, {}, { materials: { wall } })), [0, 0, 5])).toThrow(
    'a plane lets nothing through',
  );
  const materials = {
    cloth: plastic({ sheen: { color: [1, 1, 1], roughness: 1, colorTexture: { texture: 'weave' } } }),
  };
  expect(() => packPathScene(stillMoment(testScene({ a: ball('cloth') }, {}, { materials })), [0, 0, 5])).toThrow(
    'has sheen, and the shape "a" is a sphere',
  );
});
