/** Lights as Mitsuba's emitters. */
import type { Light, Vec3 } from '../../scene/scene.ts';
import { dot, length } from '../../scene/vec3.ts';
import type { ExportReport } from '../export-report.ts';
import { parallelogram } from './shapes.ts';
import { type Element, float, lookAt, plugin, point, rgb, vector } from './xml.ts';

/** Lights are black bodies: they reflect nothing. */
const BLACK = plugin('bsdf', 'diffuse', [rgb('reflectance', [0, 0, 0])]);
const area = (radiance: readonly number[]): Element => plugin('emitter', 'area', [rgb('radiance', radiance)]);
const times = (color: readonly number[], factor: number): number[] => color.map((x) => x * factor);

export function writeLight(name: string, light: Light, report: ExportReport): Element {
  const thing = `light "${name}"`;
  if ('visible' in light && !light.visible)
    report.add('changed', 'A light that is not to be seen is seen there, and stands in the way of other light.', thing);
  switch (light.type) {
    case 'sphere': {
      if (light.halo > 0 || light.ambient.some((x) => x > 0))
        report.add('lost', 'Halos and ambient light belong to the classic integrator.', thing);
      const radiance = times(light.diffuse, light.radiance);
      return plugin('shape', 'sphere', [point('center', light.center), float('radius', light.radius), BLACK, area(radiance)]); // biome-ignore format: one expression
    }
    case 'quad':
      return parallelogram(light, [BLACK, area(times(light.color, light.radiance))], thing, report);
    case 'point':
      return plugin('emitter', 'point', [
        point('position', light.position),
        rgb('intensity', times(light.color, light.intensity)),
      ]);
    case 'spot':
      report.add('changed', "The edge of a spot fades linearly with the angle there, not by glTF's formula.", thing);
      return plugin('emitter', 'spot', [
        lookAt(light.position, [0, 1, 2].map((c) => light.position[c]! + light.direction[c]!), across(light.direction)), // biome-ignore format: one expression
        rgb('intensity', times(light.color, light.intensity)),
        float('cutoff_angle', Math.min(light.outerAngle, 89.9)),
        float('beam_width', Math.min(light.innerAngle, light.outerAngle, 89.9)),
      ]);
    case 'directional':
      if (light.angle > 1e-5)
        report.add('changed', 'The sun is a point at infinity there: its shadows are hard, and it is not seen.', thing);
      return plugin('emitter', 'directional', [
        vector('direction', light.direction),
        rgb('irradiance', times(light.color, light.irradiance)),
      ]);
  }
}

/** Any direction that is not along this one. */
const across = (direction: Vec3): Vec3 =>
  Math.abs(dot(direction, [0, 1, 0])) < 0.9 * length(direction) ? [0, 1, 0] : [1, 0, 0];
