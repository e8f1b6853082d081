/** KHR_lights_punctual. */
import type { Light } from '../scene/scene.ts';
import { extensionOf, type LightJson, lightsOf } from './json.ts';
import type { NodesInScene } from './nodes.ts';
import type { Path } from './problems.ts';
import { NamedThings, type Reading, within } from './reading.ts';

const BRIGHTEST = 1e6;
const degrees = (radians: number): number => (radians * 180) / Math.PI;

/** The lights of nodes that are shown; one that several nodes carry is there as often. */
export function readLights(
  reading: Reading,
  { nodes, order, shown }: NodesInScene,
): NamedThings<Light> & { byLight: Map<number, string[]> } {
  const lights = Object.assign(new NamedThings<Light>(), { byLight: new Map<number, string[]>() });
  const all = lightsOf(reading.json);
  for (const index of order) {
    if (!shown.has(index)) continue;
    const light = extensionOf<{ light: number }>(reading.json.nodes![index]!, 'KHR_lights_punctual')?.light;
    if (light === undefined) continue;
    const node = nodes.nameOf(index)!;
    const made = readLight(reading, all[light]!, ['extensions', 'KHR_lights_punctual', 'lights', light], node);
    const name = lights.add(made, all[light]!.name, node);
    lights.byLight.set(light, [...(lights.byLight.get(light) ?? []), name]);
  }
  return lights;
}

/** A candela counts as a watt a steradian, a lux as a watt a square metre. Lights shine along −Z of their nodes. */
function readLight(reading: Reading, json: LightJson, path: Path, node: string): Light {
  const strength = within(reading, json.intensity ?? 1, 0, BRIGHTEST, [...path, 'intensity']);
  const given = json.color ?? [1, 1, 1];
  const channel = (i: 0 | 1 | 2): number => within(reading, given[i], 0, 1000, [...path, 'color', i]);
  const color = [channel(0), channel(1), channel(2)] as const;
  if (json.range !== undefined)
    reading.report.add(
      'changed',
      'range',
      [...path, 'range'],
      'The range of a light is not used: its light goes on, ever weaker, as real light does.',
    );
  switch (json.type) {
    case 'directional':
      return { type: 'directional', direction: [0, 0, -1], irradiance: strength, color, angle: 0, node };
    case 'point':
      return { type: 'point', position: [0, 0, 0], intensity: strength, color, node };
    case 'spot': {
      const { innerConeAngle = 0, outerConeAngle = Math.PI / 4 } = json.spot ?? {};
      const outerAngle = within(reading, degrees(outerConeAngle), 0, 90, [...path, 'spot', 'outerConeAngle']);
      const innerAngle = within(reading, degrees(innerConeAngle), 0, outerAngle, [...path, 'spot', 'innerConeAngle']);
      return {
        type: 'spot',
        position: [0, 0, 0],
        direction: [0, 0, -1],
        intensity: strength,
        color,
        innerAngle,
        outerAngle,
        node,
      };
    }
  }
}
