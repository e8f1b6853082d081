/** Neutral scenes in our format: exactly, or not at all. */
import * as v from 'valibot';
import type { Color, Scene } from '../../packages/renderer/src/scene/scene.ts';
import { parseScene } from '../../packages/renderer/src/scene-file/index.ts';
import { convertMaterial } from './convert-material.ts';
import { Meshes } from './meshes.ts';
import {
  type NeutralLight,
  type NeutralPrimitive,
  type NeutralScene,
  neutralScene,
  type Triple,
} from './neutral-scene.ts';
import { isSheared, matrixOf, placeBox, placeQuad, placeSphere, Refusal } from './transform.ts';

export interface Converted {
  readonly scene: Scene;
  /** Size of the picture, which a scene of ours does not say. */
  readonly width: number;
  readonly height: number;
}

/** Everything that stands in the way of a conversion, each with its place in the file. */
export class ConversionError extends Error {
  readonly problems: readonly string[];
  constructor(problems: readonly string[]) {
    super(problems.join('\n'));
    this.problems = problems;
  }
}

/** Throws a `ConversionError` if `json` is no neutral scene or one that our format cannot say exactly. */
export function convertScene(json: unknown): Converted {
  const read = v.safeParse(neutralScene, json);
  if (!read.success) throw new ConversionError(read.issues.map((i) => `${v.getDotPath(i) ?? '(file)'}: ${i.message}`));
  const neutral = read.output;
  const problems = new Problems();
  checkCamera(neutral, problems);
  const sky = skyOf(neutral.lights, problems);
  // Shapes say which meshes there are.
  const meshes = new Meshes();
  const shapes = shapesOf(neutral, meshes, problems);
  const file = {
    version: 1,
    name: neutral.name,
    description: neutral.description,
    camera: cameraOf(neutral.camera),
    sky,
    materials: convertAll(Object.entries(neutral.materials), 'materials', convertMaterial, problems),
    ...(meshes.isEmpty ? {} : { meshes: meshes.sources() }),
    shapes,
    lights: lightsOf(neutral.lights, problems),
    render: {
      integrator: 'path',
      maxDepth: neutral.max_depth,
      exposure: Math.log2(neutral.image.view_exposure),
    },
  };
  problems.throwIfAny();
  const parsed = parseScene(file);
  if (!parsed.ok) throw new ConversionError(parsed.problems.map(({ path, message }) => `${path}: ${message}`));
  return { scene: parsed.scene, width: neutral.image.width, height: neutral.image.height };
}

class Problems {
  readonly #list: string[] = [];
  add(place: string, message: string): void {
    this.#list.push(`${place}: ${message}`);
  }
  /** What `make` gives, or nothing, and a problem at this place, when it refuses. */
  attempt<Result>(place: string, make: () => Result): Result | undefined {
    try {
      return make();
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      this.add(place, error.message);
    }
  }
  throwIfAny(): void {
    if (this.#list.length > 0) throw new ConversionError(this.#list);
  }
}

/** A map of what becomes of each; keys stay, in order. */
function convertAll<From, To>(
  entries: readonly (readonly [string, From])[],
  place: string,
  convert: (from: From) => To,
  problems: Problems,
): Record<string, To> {
  const made = entries.map(
    ([name, from]) => [name, problems.attempt(`${place}.${name}`, () => convert(from))] as const,
  );
  return Object.fromEntries(made.filter((entry): entry is [string, To & {}] => entry[1] !== undefined));
}

const cameraOf = ({ eye, target, up, vfov_deg }: NeutralScene['camera']) => ({
  eye,
  target,
  up,
  verticalFov: vfov_deg,
});

function checkCamera({ camera, image }: NeutralScene, problems: Problems): void {
  const { width, height, filter } = image;
  if (filter !== 'box') problems.add('image.filter', `"${filter}": only "box", one pixel wide, is known`);
  if (Math.abs(camera.aspect - width / height) > 1e-6)
    problems.add('camera.aspect', `${camera.aspect} where the picture is ${width} × ${height}: ours has square pixels`);
}

type SkyLight = Extract<NeutralLight, { type: 'constant' | 'envmap' }>;
const isSky = (light: NeutralLight): light is SkyLight => light.type === 'constant' || light.type === 'envmap';

function skyOf(lights: readonly NeutralLight[], problems: Problems): Color | { image: string; scale: number } {
  const skies = lights.filter(isSky);
  if (skies.length > 1) problems.add('lights', 'more than one constant light or envmap: ours has one sky');
  const [sky] = skies;
  if (sky?.type === 'envmap') return { image: sky.file, scale: sky.scale };
  return sky?.radiance ?? [0, 0, 0];
}

/** Names such as "box 2": neutral primitives have none. */
function numbered<Thing extends { readonly type: string }>(things: readonly Thing[], suffix = ''): [string, Thing][] {
  const count = new Map<string, number>();
  return things.map((thing) => {
    const n = (count.get(thing.type) ?? 0) + 1;
    count.set(thing.type, n);
    return [`${thing.type}${suffix} ${n}`, thing];
  });
}

function shapesOf({ primitives, materials }: NeutralScene, meshes: Meshes, problems: Problems) {
  const transparent = (name: string) => ['dielectric', 'rough_dielectric'].includes(materials[name]?.type ?? '');
  const convert = (p: SinglePrimitive) => {
    if (p.type === 'quad' && transparent(p.material))
      throw new Refusal('a dielectric quad: a solid body has an inside');
    return convertShape(p, meshes);
  };
  const single = primitives.flatMap(withoutInstances);
  const placed = single.flatMap((p) => (p.type === 'box' && isSheared(p) && !transparent(p.material) ? sidesOf(p) : p));
  return convertAll(numbered(placed), 'primitives', convert, problems);
}

type NeutralBox = Extract<NeutralPrimitive, { type: 'box' }>;
type SinglePrimitive =
  | Exclude<NeutralPrimitive, { type: 'instances' }>
  | { readonly type: 'fault'; readonly why: string };

/** Six parallelograms, which stay such under any transform. What has no inside may be made of them. */
function sidesOf({ min, max, material, transform }: NeutralBox): SinglePrimitive[] {
  return [0, 1, 2].flatMap((across) =>
    [min, max].map((end): SinglePrimitive => {
      const side = (axis: number) => min.map((low, c) => (c === axis ? max[c]! - low : 0)) as Triple;
      const corner = min.map((low, c) => (c === across ? end[c]! : low)) as Triple;
      return { type: 'quad', corner, u: side((across + 1) % 3), v: side((across + 2) % 3), material, transform };
    }),
  );
}

/** Each item as a mesh of its own, in their order. */
function withoutInstances(p: NeutralPrimitive): SinglePrimitive | SinglePrimitive[] {
  if (p.type !== 'instances') return p;
  return p.items.map(({ mesh, material, transform }): SinglePrimitive => {
    const source = Object.hasOwn(p.meshes, mesh) ? p.meshes[mesh] : undefined;
    return source ? { type: 'mesh', ...source, material, transform } : { type: 'fault', why: `no mesh "${mesh}"` };
  });
}

function convertShape(p: SinglePrimitive, meshes: Meshes) {
  switch (p.type) {
    case 'sphere':
      return { type: p.type, ...placeSphere(p.center, p.radius, p.transform), material: p.material };
    case 'box':
      return { type: p.type, ...placeBox(p.min, p.max, p.transform), material: p.material };
    case 'quad':
      return { type: p.type, ...placeQuad(p.corner, p.u, p.v, p.transform), material: p.material };
    case 'mesh':
      return { type: p.type, mesh: meshes.nameOf(p.file, p.smooth), material: p.material, ...matrixOf(p.transform) };
    case 'fault':
      throw new Refusal(p.why);
  }
}

function lightsOf(lights: readonly NeutralLight[], problems: Problems) {
  const others = lights.filter((light): light is Exclude<NeutralLight, SkyLight> => !isSky(light));
  return convertAll(numbered(others, ' light'), 'lights', convertLight, problems);
}

function convertLight(light: Exclude<NeutralLight, SkyLight>) {
  switch (light.type) {
    case 'sphere': {
      const { strength, color } = brightness(light.radiance);
      return { type: 'sphere', center: light.center, radius: light.radius, radiance: strength, diffuse: color };
    }
    case 'quad': {
      const { corner, u, v: side, radiance } = light;
      const { strength, color } = brightness(radiance);
      return { type: 'quad', corner, u, v: side, radiance: strength, color };
    }
    case 'point': {
      const { strength, color } = brightness(light.intensity);
      return { type: 'point', position: light.position, intensity: strength, color };
    }
    case 'directional': {
      const { strength, color } = brightness(light.irradiance);
      return { type: 'directional', direction: light.direction, irradiance: strength, color };
    }
  }
}

/** The largest channel, and the colour as shares of it. */
function brightness(radiance: Color): { strength: number; color: Color } {
  const strength = Math.max(...radiance);
  if (strength <= 0) return { strength: 0, color: [1, 1, 1] };
  const [r, g, b] = radiance;
  return { strength, color: [r / strength, g / strength, b / strength] };
}
