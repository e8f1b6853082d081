/**
 * Everything that shines, as the path integrator samples it: lights, shapes of an emissive material, the sky. What is left out
 * (more emissive shapes than a loop should run over) still shines, and is found by rays that happen to meet it.
 */
import { emissionOf, radianceOf, type SceneWithLamps, timesColor } from '../scene/lamps.ts';
import { isLayered } from '../scene/layered.ts';
import type { Color, DirectionalLight, LampShape, Light, QuadLight, Sky, SpotLight, Vec3 } from '../scene/scene.ts';
import { add, cross, length, normalize, subtract } from '../scene/vec3.ts';
import { packEnvironment } from './pack-environment.ts';
import type { StructValues } from './write-struct.ts';

/** What `frame.emitterCount` may be. */
export const MOST_EMITTERS = 64;

/** The kinds as shading/light/emitter/emitter.wesl numbers them. */
export const EMITTER_KIND = { sphere: 0, quad: 1, box: 2, point: 3, spot: 4, directional: 5, sky: 6 } as const;

/** All fields of the struct. */
export type EmitterValues = Required<StructValues<'Emitter'>>;

export interface PackedEmitters {
  readonly emitters: readonly EmitterValues[];
  /** Index of the emitter that a shape is, by the shape's name; a shape that is none is not in it. */
  readonly emitterOfShape: ReadonlyMap<string, number>;
}

const NOTHING: EmitterValues = {
  position: [0, 0, 0],
  kind: 0,
  u: [0, 0, 0],
  radius: 0,
  v: [0, 0, 0],
  cosInner: 0,
  radiance: [0, 0, 0],
  area: 0,
  shape: -1,
  oneSided: 0,
  power: 0,
  reach: 0,
};

const RADIANS = Math.PI / 180;
/** Where the falloff of a spot has no width its outer cosine is less than the inner by this. */
const NARROWEST_FALLOFF = 1e-6;

/** Degrees. Directions of 32-bit floats do not tell a smaller disc from a point, and its radiance would grow without bounds. */
const NARROWEST_DISC = 1e-5;

const mean = ([r, g, b]: Color) => (r + g + b) / 3;
const isBlack = (color: Color) => Math.max(...color) <= 0;

function sphereEmitter(center: Vec3, radius: number, radiance: Color): EmitterValues {
  const [kind, area] = [EMITTER_KIND.sphere, 4 * Math.PI * radius ** 2];
  return {
    ...NOTHING,
    kind,
    position: center,
    radius,
    radiance,
    area,
    power: (mean(radiance) * area) / 4,
    reach: radius,
  };
}

function quadEmitter({ corner, u, v }: Pick<QuadLight, 'corner' | 'u' | 'v'>, radiance: Color): EmitterValues {
  const area = length(cross(u, v));
  const reach = Math.max(length(add(u, v)), length(subtract(u, v))) / 2;
  return {
    ...NOTHING,
    kind: EMITTER_KIND.quad,
    position: corner,
    u,
    v,
    radiance,
    area,
    power: mean(radiance) * area,
    reach,
  };
}

/** A convex body shows a quarter of its surface on average (Cauchy). */
function boxEmitter(center: Vec3, [x, y, z]: Vec3, radiance: Color): EmitterValues {
  const area = 2 * (x * y + y * z + z * x);
  const u: Vec3 = [x / 2, y / 2, z / 2];
  const power = (mean(radiance) * area) / 4;
  return { ...NOTHING, kind: EMITTER_KIND.box, position: center, u, radiance, area, power, reach: length(u) };
}

function spotEmitter(light: SpotLight): EmitterValues {
  const radiance = timesColor(light.intensity, light.color);
  const cosInner = Math.cos(Math.min(light.innerAngle, light.outerAngle) * RADIANS);
  return {
    ...NOTHING,
    kind: EMITTER_KIND.spot,
    position: light.position,
    u: normalize(light.direction),
    radius: Math.min(Math.cos(light.outerAngle * RADIANS), cosInner - NARROWEST_FALLOFF),
    cosInner,
    radiance,
    power: mean(radiance),
  };
}

/** A disc of half angle a that gives the irradiance E has the radiance E / (π sin² a). */
function directionalEmitter(light: DirectionalLight): EmitterValues {
  const irradiance = timesColor(light.irradiance, light.color);
  const angle = light.angle < NARROWEST_DISC ? 0 : light.angle;
  const half = (angle / 2) * RADIANS;
  const sine = Math.sin(half);
  return {
    ...NOTHING,
    kind: EMITTER_KIND.directional,
    u: normalize(light.direction),
    radius: Math.cos(half),
    radiance: angle === 0 ? irradiance : timesColor(1 / (Math.PI * sine ** 2), irradiance),
    area: 4 * Math.PI * Math.sin(half / 2) ** 2,
    power: mean(irradiance),
    reach: sine,
  };
}

/** π times the mean over all directions: of the map, or of what shading/sky.wesl gives. */
function skyEmitter({ horizon, zenith, map, scale = 1 }: Sky): EmitterValues {
  const radiance = map ? scale * packEnvironment(map).meanRadiance : (3 * mean(horizon) + mean(zenith)) / 4;
  const power = Math.PI * radiance;
  return { ...NOTHING, kind: EMITTER_KIND.sky, power };
}

function lightEmitter(light: Light): EmitterValues {
  switch (light.type) {
    case 'sphere':
      return sphereEmitter(light.center, light.radius, radianceOf(light));
    case 'quad':
      return { ...quadEmitter(light, radianceOf(light)), oneSided: 1 };
    case 'point': {
      const radiance = timesColor(light.intensity, light.color);
      return { ...NOTHING, kind: EMITTER_KIND.point, position: light.position, radiance, power: mean(radiance) };
    }
    case 'spot':
      return spotEmitter(light);
    case 'directional':
      return directionalEmitter(light);
  }
}

function shapeEmitter(shape: LampShape, radiance: Color): EmitterValues {
  if (shape.type === 'sphere') return sphereEmitter(shape.center, shape.radius, radiance);
  return shape.type === 'box' ? boxEmitter(shape.center, shape.size, radiance) : quadEmitter(shape, radiance);
}

interface Found {
  readonly values: EmitterValues;
  readonly shape: string | null;
}

function lightsOf({ scene, lightOfShape }: SceneWithLamps): Found[] {
  const shapeOfLight = new Map([...lightOfShape].map(([shape, light]) => [light, shape]));
  const lights = Object.entries(scene.lights).map(([name, light]) => ({
    values: lightEmitter(light),
    shape: shapeOfLight.get(name) ?? null,
  }));
  const sky = { values: skyEmitter(scene.sky), shape: null };
  return [...lights, sky].filter(({ values }) => (values.power as number) > 0);
}

/** Those that give the most first. */
function emissiveShapes({ scene, lightOfShape }: SceneWithLamps): Found[] {
  const found: Found[] = [];
  for (const [name, shape] of Object.entries(scene.shapes)) {
    const material = scene.materials[shape.material]!;
    const emission = emissionOf(material);
    // What shines through a coat is not as bright to all sides: rays find it by themselves.
    if (isLayered(material) && (material.clearcoat?.weight ?? 0) > 0) continue;
    // A plane has no area to sample; scene files with such a lamp are refused. Rays find the light of meshes by themselves.
    if (shape.type === 'plane' || shape.type === 'mesh' || lightOfShape.has(name) || isBlack(emission)) continue;
    found.push({ values: shapeEmitter(shape, emission), shape: name });
  }
  return found.sort((a, b) => (b.values.power as number) - (a.values.power as number));
}

/** `rowOf`: where in the scene table the shape of that name lies. */
export function emittersOf(lamps: SceneWithLamps, eye: Vec3, rowOf: (shape: string) => number): PackedEmitters {
  const kept = [...lightsOf(lamps), ...emissiveShapes(lamps)].slice(0, MOST_EMITTERS);
  const emitters = kept.map(({ values, shape }) => ({
    ...values,
    position: subtract(values.position as unknown as Vec3, eye),
    shape: shape === null ? -1 : rowOf(shape),
  }));
  const named = kept.flatMap(({ shape }, index) => (shape === null ? [] : [[shape, index] as const]));
  return { emitters, emitterOfShape: new Map(named) };
}
