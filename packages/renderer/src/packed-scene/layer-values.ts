/** Material → the Layers struct: what glTF's extensions add to a metallicRoughness material (shading/bsdf/layers). */
import { isClear, isSolid } from '../scene/layered.ts';
import type { Material } from '../scene/scene.ts';
import type { StructValues } from './write-struct.ts';

/** Stands for an endless index: what it reflects of light that comes straight, 0.999996, is 1 to the eye. */
const ENDLESS = 1e6;
/** Of a solid: reflects 0.996. Light that is bent by a greater one has a direction without digits in 32-bit floats, and no length 1. */
const ENDLESS_SOLID = 1e3;
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

export function layerValues(m: Material): StructValues<'Layers'> {
  const clear = isClear(m);
  const angle = radians(m.anisotropy?.rotation ?? 0);
  return {
    specularColor: m.specularLobe?.color ?? [1, 1, 1],
    specularWeight: m.specularLobe?.weight ?? 1,
    sheenColor: m.sheen?.color ?? [0, 0, 0],
    sheenRoughness: m.sheen?.roughness ?? 0,
    beyondColor: m.diffuseTransmission?.color ?? [1, 1, 1],
    beyond: clear ? (m.diffuseTransmission?.weight ?? 0) : 0,
    grain: [Math.cos(angle), Math.sin(angle)],
    anisotropy: m.anisotropy?.strength ?? 0,
    transmission: clear ? (m.transmission?.weight ?? 0) : 0,
    coat: m.clearcoat?.weight ?? 0,
    coatRoughness: m.clearcoat?.roughness ?? 0,
    ior: m.ior > 0 ? m.ior : isSolid(m) ? ENDLESS_SOLID : ENDLESS,
    solid: isSolid(m) ? 1 : 0,
    film: m.iridescence?.weight ?? 0,
    filmIor: m.iridescence?.ior ?? 1.3,
    filmThickness: m.iridescence?.thicknessMaximum ?? 400,
    filmLeast: m.iridescence?.thicknessMinimum ?? 100,
    dispersion: m.ior === 0 || !isSolid(m) ? 0 : (m.dispersion ?? 0),
    spare0: 0,
    spare1: 0,
    spare2: 0,
  };
}
