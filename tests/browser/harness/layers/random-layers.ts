/** Layered materials with anything in them, the ends of all ranges above all, as 32-bit floats hold them. */
import type { Color } from '../../../../packages/renderer/src/scene/scene.ts';
import { directionOf } from '../../../fixtures/bsdf-cases.ts';
import { LAYERED, type LayeredMaterial, layered } from '../../../fixtures/layers/layered-material.ts';
import { between, pick, type Random } from '../../../fixtures/random.ts';

const share = (random: Random): number => pick(random, [0, 0, 1, random(), random()]);
const color = (random: Random): Color =>
  pick(random, [
    [random(), random(), random()],
    [1, 1, 1],
    [0, 0, 0],
    [1, 0, 0],
  ]);

function randomLayers(random: Random): LayeredMaterial {
  const some = layered({
    baseColor: color(random),
    metallic: pick(random, [0, 0, 1, random()]),
    roughness: pick(random, [0, 0.03, 0.033, 1, random(), random()]),
    ior: pick(random, [1, 1.0005, 1.0015, 1.5, 4, 1e6, between(random, 1.01, 3)]),
    specular: share(random),
    specularColor: pick(random, [
      [1, 1, 1],
      [random(), 20 * random(), random()],
      [1e6, 0, 1],
    ] as const),
    clearcoat: share(random),
    clearcoatRoughness: pick(random, [0, 0.033, 1, random()]),
    coatNormal: pick(random, [[0, 0, 1], directionOf(between(random, 0.3, 1), between(random, -4, 4))] as const),
    sheenColor: color(random),
    sheenRoughness: pick(random, [0, 1, random(), random()]),
    transmission: share(random),
    diffuseTransmission: share(random),
    diffuseTransmissionColor: color(random),
    solid: random() < 0.5,
    anisotropy: share(random),
    iridescence: pick(random, [0, 0, 0, 1, random()]),
    iridescenceIor: pick(random, [1, 1.3, 3, between(random, 1, 2)]),
    iridescenceThickness: pick(random, [0, 1e6, between(random, 50, 1500)]),
    dispersion: pick(random, [0, 0, 100, 5 * random()]),
  });
  // Metal lets nothing through and is no solid.
  const clear = some.metallic < 1 && some.transmission + some.diffuseTransmission > 0;
  const solid = some.solid && clear;
  // What stands for an endless index, which does not disperse: packed-scene/layer-values.ts.
  const endless = some.ior === 1e6;
  return { ...some, solid, ior: endless && solid ? 1e3 : some.ior, dispersion: endless ? 0 : some.dispersion };
}

/** All numbers as the table holds them. */
function inFloats(m: LayeredMaterial): LayeredMaterial {
  const round = (value: unknown) =>
    typeof value === 'number' ? Math.fround(value) : Array.isArray(value) ? value.map(Math.fround) : value;
  return Object.fromEntries(Object.entries(m).map(([key, value]) => [key, round(value)])) as unknown as LayeredMaterial;
}

export const NAMED: readonly (readonly [name: string, material: LayeredMaterial])[] = Object.entries(LAYERED).map(
  ([name, m]) => [name, inFloats(m)],
);

export const someLayers = (random: Random, count: number): LayeredMaterial[] => [
  ...NAMED.map(([, m]) => m),
  ...Array.from({ length: count }, () => inFloats(randomLayers(random))),
];

/** Layers that a program may know alone. Without any, the dielectric's index and reflectance may still be others than glTF's. */
export const LAYER_KINDS = ['none', 'clearcoat', 'sheenColor', 'anisotropy', 'transmission', 'iridescence'] as const;

/** The material without layers of other kinds. Diffuse transmission goes with transmission. */
export function withOnly(m: LayeredMaterial, kind: (typeof LAYER_KINDS)[number]): LayeredMaterial {
  const clear = kind === 'transmission';
  const solid = clear && m.solid;
  return {
    ...m,
    ior: m.ior === 1e3 && !solid ? 1e6 : m.ior,
    clearcoat: kind === 'clearcoat' ? m.clearcoat : 0,
    // Bent with the base's; coats apart from it have a switch of their own.
    coatNormal: [0, 0, 1],
    sheenColor: kind === 'sheenColor' ? m.sheenColor : [0, 0, 0],
    anisotropy: kind === 'anisotropy' ? m.anisotropy : 0,
    transmission: clear ? m.transmission : 0,
    diffuseTransmission: clear ? m.diffuseTransmission : 0,
    solid,
    iridescence: kind === 'iridescence' ? m.iridescence : 0,
  };
}
