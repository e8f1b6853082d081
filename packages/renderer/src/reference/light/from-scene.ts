/** The lights and shapes of a scene as emitters. */
import { radianceOf, timesColor } from '../../scene/lamps.ts';
import type { Color, LampShape, Light } from '../../scene/scene.ts';
import { normalize, rotate, scale } from '../../scene/vec3.ts';
import type { AreaEmitter, Emitter } from './emitter.ts';

const radians = (degrees: number) => (degrees * Math.PI) / 180;

export function emitterOfLight(light: Light): Emitter {
  switch (light.type) {
    case 'sphere':
      return { kind: 'sphere', center: light.center, radius: light.radius, radiance: radianceOf(light) };
    case 'quad':
      return { ...light, kind: 'quad', radiance: radianceOf(light), oneSided: true };
    case 'point':
      return { kind: 'point', position: light.position, intensity: timesColor(light.intensity, light.color) };
    case 'spot': {
      const cosInner = Math.cos(radians(Math.min(light.innerAngle, light.outerAngle)));
      // As pack-emitters.ts has it: a falloff of no width gets a little.
      const cosOuter = Math.min(Math.cos(radians(light.outerAngle)), cosInner - 1e-6);
      const intensity = timesColor(light.intensity, light.color);
      const direction = normalize(light.direction);
      return { kind: 'spot', position: light.position, intensity, direction, cosInner, cosOuter };
    }
    case 'directional': {
      const irradiance = timesColor(light.irradiance, light.color);
      return {
        kind: 'directional',
        direction: normalize(light.direction),
        irradiance,
        halfAngle: radians(light.angle / 2),
      };
    }
  }
}

export function emitterOfShape(shape: LampShape, radiance: Color): AreaEmitter {
  if (shape.type === 'sphere') return { kind: 'sphere', center: shape.center, radius: shape.radius, radiance };
  if (shape.type === 'quad')
    return { kind: 'quad', corner: shape.corner, u: shape.u, v: shape.v, radiance, oneSided: false };
  const { center, size, rotation } = shape;
  const axes = [rotate([1, 0, 0], rotation), rotate([0, 1, 0], rotation), rotate([0, 0, 1], rotation)] as const;
  return { kind: 'box', center, halfSize: scale(size, 0.5), axes, radiance };
}
