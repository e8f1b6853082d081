/**
 * Everything that shines, as the path integrator samples it: lights, shapes of an emissive material, the sky. What is left out
 * (more of them than the scene table should hold) still shines, and is found by rays that happen to meet it.
 */
import { emissionOf, lampsAsShapes, radianceOf, type SceneWithLamps, timesColor } from '../scene/lamps.ts';
import { hasCoat } from '../scene/layered.ts';
import type {
  Color,
  DirectionalLight,
  LampShape,
  Light,
  MeshShape,
  QuadLight,
  Scene,
  Sky,
  SpotLight,
  Vec3,
} from '../scene/scene.ts';
import { add, cross, length, normalize, subtract } from '../scene/vec3.ts';
import { EMITTER_KIND, type EmitterValues, NO_EMITTER as NOTHING } from './emitter-values.ts';
import { clustersOf, glowTextureOf, type MeshGlow } from './lamp-clusters.ts';
import { packEnvironment } from './pack-environment.ts';
import { isOneSided, mayBeMissing } from './texture-slots.ts';

/** What `frame.emitterCount` may be: a table of so many rows is a texture that every device has. */
export const MOST_EMITTERS = 8192;
/** Of more than these, the infinitely far ones not counted, a tree chooses: docs/lights.md. */
export const LISTED_EMITTERS = 16;
/** Triangles of all lamps together: 64 MiB of tables. */
const MOST_LAMP_TRIANGLES = 2 ** 22;

export interface PackedEmitters {
  /** Those that are infinitely far come first. */
  readonly emitters: readonly EmitterValues[];
  readonly far: number;
  /** Index of the emitter that a shape is, by the shape's name; a shape that is none is not in it. */
  readonly emitterOfShape: ReadonlyMap<string, number>;
}

const isFar = ({ kind }: EmitterValues): boolean => kind === EMITTER_KIND.sky || kind === EMITTER_KIND.directional;

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

/** An emitter in the world, and the shape that it is. */
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
    if (hasCoat(material)) continue;
    // A plane has no area to sample; scene files with such a lamp are refused.
    if (shape.type === 'plane' || shape.type === 'mesh' || lightOfShape.has(name) || isBlack(emission)) continue;
    found.push({ values: shapeEmitter(shape, emission), shape: name });
  }
  return found.sort((a, b) => (b.values.power as number) - (a.values.power as number));
}

function emittersWithoutMeshes(lamps: SceneWithLamps): Found[] {
  const lights = lightsOf(lamps);
  const near = [...lights.filter(({ values }) => !isFar(values)), ...emissiveShapes(lamps)];
  return [...lights.filter(({ values }) => isFar(values)), ...near].slice(0, MOST_EMITTERS);
}

/** The meshes whose light is sampled, by the names of their shapes: in the order of the file, as long as there is room. */
export function meshGlows({ scene }: SceneWithLamps, room: number): Map<string, MeshGlow> {
  const glows = new Map<string, MeshGlow>();
  let [emitters, triangles] = [room, MOST_LAMP_TRIANGLES];
  for (const [name, shape] of Object.entries(scene.shapes)) {
    const cut = shape.type === 'mesh' ? clustersOf(scene, shape) : null;
    if (!cut || cut.instances * cut.clusters > emitters || cut.triangles > triangles) continue;
    emitters -= cut.instances * cut.clusters;
    triangles -= cut.triangles;
    const material = scene.materials[shape.material]!;
    glows.set(name, {
      ...cut,
      radiance: emissionOf(material),
      oneSided: isOneSided(material),
      texture: glowTextureOf(scene, material),
      mayBeMissing: mayBeMissing(material, scene.meshes?.[(shape as MeshShape).mesh]?.data),
    });
  }
  return glows;
}

/** What a packed scene's emitters may be at most, without looking at the triangles of meshes. */
export interface EmitterPlan {
  readonly kinds: ReadonlySet<number>;
  readonly far: number;
  readonly near: number;
  readonly glows: ReadonlyMap<string, MeshGlow>;
}

/** A scene does not change. */
const known = new WeakMap<Scene, EmitterPlan>();

export function planEmitters(scene: Scene): EmitterPlan {
  let plan = known.get(scene);
  if (!plan) known.set(scene, (plan = planOf(lampsAsShapes(scene))));
  return plan;
}

function planOf(lamps: SceneWithLamps): EmitterPlan {
  const found = emittersWithoutMeshes(lamps);
  const glows = meshGlows(lamps, MOST_EMITTERS - found.length);
  const far = found.filter(({ values }) => isFar(values)).length;
  let near = found.length - far;
  for (const { instances, clusters } of glows.values()) near += instances * clusters;
  const kinds = new Set(found.map(({ values }) => values.kind as number));
  if (glows.size > 0) kinds.add(EMITTER_KIND.mesh);
  return { kinds, far, near, glows };
}

/** All but meshes. `rowOf`: where in the scene table the shape of that name lies. */
export function emittersOf(lamps: SceneWithLamps, eye: Vec3, rowOf: (shape: string) => number): PackedEmitters {
  const found = emittersWithoutMeshes(lamps);
  const emitters = found.map(({ values, shape }) => ({
    ...seenFrom(eye, values),
    shape: shape === null ? -1 : rowOf(shape),
  }));
  const named = found.flatMap(({ shape }, index) => (shape === null ? [] : [[shape, index] as const]));
  return { emitters, far: found.filter(({ values }) => isFar(values)).length, emitterOfShape: new Map(named) };
}

export const seenFrom = (eye: Vec3, values: EmitterValues): EmitterValues => ({
  ...values,
  position: subtract(values.position as unknown as Vec3, eye),
});
