import * as v from 'valibot';
import { CAMERA_DEFAULTS, PROJECTIONS } from '../scene/camera.ts';
import { SCENE_LIMITS } from '../scene/limits.ts';
import { METALS } from '../scene/metals.ts';
import type { Color, MaterialType, Sky } from '../scene/scene.ts';
import { SHAPE_TYPES } from '../scene/shape-types.ts';
import { TONE_MAPPINGS } from '../scene/tone-mappings.ts';
import { layers } from './layer-schema.ts';
import { clip, model, node, skin, variant } from './node-schema.ts';
import { carrier, mesh, shape } from './shape-schema.ts';
import { image as picture, texture } from './texture-schema.ts';
import {
  choice,
  color,
  direction,
  fileName,
  flag,
  integer,
  kind,
  number,
  object,
  point,
  share,
  text,
  triple,
} from './values.ts';

/** The structure of a scene file, with its defaults: the one source for reading, writing and the editors' JSON Schema. */

const BRIGHTEST = 1e6;
const LIGHT_COLOR = 1e3;
const SMALLEST = 1e-6;
const LARGEST = 1e9;

const nameRule = `a name: 1 to ${SCENE_LIMITS.nameLength} characters on one line, no space at either end`;
const name = v.pipe(
  v.string(nameRule),
  v.maxLength(SCENE_LIMITS.nameLength, nameRule),
  v.regex(/^\S(?:.*\S)?$/, nameRule),
);

function named<Schema extends v.GenericSchema>(what: string, value: Schema, max: number) {
  const allowed = `${what} by name, at most ${max} of them`;
  return v.pipe(v.record(name, value, allowed), v.maxEntries(max, allowed), v.description(allowed));
}

const camera = object('the camera: an object with "eye" and "target"', {
  eye: point('where the camera stands'),
  target: point('where the camera looks'),
  up: v.optional(direction('the direction that is up in the picture'), [0, 1, 0]),
  verticalFov: v.optional(number('the vertical field of view in degrees', 0.01, 179), 45),
  projection: v.optional(choice('how the camera sees', PROJECTIONS), CAMERA_DEFAULTS.projection),
  viewHeight: v.optional(
    number('the height of an orthographic picture in metres', SMALLEST, LARGEST),
    CAMERA_DEFAULTS.viewHeight,
  ),
  aperture: v.optional(number('the radius of the lens in metres, 0 = a pinhole', 0, LARGEST), CAMERA_DEFAULTS.aperture),
  focusDistance: v.optional(
    number('the distance that is sharp in metres, 0 = that of the target', 0, LARGEST),
    CAMERA_DEFAULTS.focusDistance,
  ),
  node: carrier,
});

export const imageRule =
  'the name of a panorama file, .hdr, .exr, .npy or .pfm, relative to the scene\'s folder, with "/" between folders';
const image = fileName(imageRule, ['hdr', 'exr', 'npy', 'pfm']);

const skyRule = 'the sky: one colour [red, green, blue], or an object with "horizon" and "zenith", or with "image"';
const skyFields = {
  horizon: color('the colour of the sky at and below the horizon', BRIGHTEST),
  zenith: color('the colour of the sky overhead', BRIGHTEST),
  image,
  scale: number('the factor on the image', 0, BRIGHTEST),
  rotation: number('the turn of the image about Y, degrees', -1e6, 1e6),
};
const skyObject = object(skyRule, {
  horizon: v.optional(skyFields.horizon),
  zenith: v.optional(skyFields.zenith),
  image: v.optional(skyFields.image),
  scale: v.optional(skyFields.scale),
  rotation: v.optional(skyFields.rotation),
});
type SkyObject = v.InferOutput<typeof skyObject>;

/** Colours are wanted where there is no image, and what belongs to one only where there is. */
const skyWithWhatItNeeds = v.pipe(
  skyObject,
  v.rawCheck(({ dataset, addIssue }) => {
    if (!dataset.typed) return;
    const value = dataset.value;
    const report = (key: keyof SkyObject, message: string) =>
      addIssue({
        message,
        input: value[key],
        path: [{ type: 'object', origin: 'value', input: value, key, value: value[key] }],
      });
    if (value.image !== undefined) return;
    for (const key of ['horizon', 'zenith'] as const) if (value[key] === undefined) report(key, ruleOf(skyFields[key]));
    for (const key of ['scale', 'rotation'] as const)
      if (value[key] !== undefined) report(key, 'nothing, as it belongs to an "image" and the sky has none');
  }),
);
const ruleOf = (schema: object): string => (schema as { readonly message: string }).message;

const sky = v.pipe(
  v.union([color('the colour of the sky', BRIGHTEST), skyWithWhatItNeeds], skyRule),
  v.description(skyRule),
  v.transform((value): Sky => (isColor(value) ? { horizon: value, zenith: value } : completeSky(value))),
);
const isColor = (value: unknown): value is Color => Array.isArray(value);
const BLACK: Color = [0, 0, 0];

function completeSky({ horizon, zenith, image: file, scale, rotation }: SkyObject): Sky {
  const colours = { horizon: horizon ?? zenith ?? BLACK, zenith: zenith ?? horizon ?? BLACK };
  return file === undefined ? colours : { ...colours, image: file, scale: scale ?? 1, rotation: rotation ?? 0 };
}

const eta = color('the index of refraction', 100);
const metals = Object.keys(METALS) as (keyof typeof METALS)[];
const conductorRule = `the metal: ${metals.map((m) => `"${m}"`).join(', ')}, or an object with "eta" and "k"`;
const conductor = v.pipe(
  v.union(
    [v.picklist(metals), object(conductorRule, { eta, k: color('the extinction coefficient', 100) })],
    conductorRule,
  ),
  v.description(conductorRule),
  v.transform((value) => (typeof value === 'string' ? METALS[value] : value)),
);
const iorRule = 'the index of refraction: a number from 1 to 4, or 0 for an infinite one';
const ior = v.pipe(
  v.number(iorRule),
  v.minValue(0, iorRule),
  v.maxValue(4, iorRule),
  v.check((x) => x === 0 || x >= 1, iorRule),
  v.description(iorRule),
);

const MATERIAL_TYPES = ['diffuse', 'metallicRoughness', 'conductor', 'dielectric'] as const;
const materialFields = object('a material: an object', {
  type: v.optional(choice('what the material is', MATERIAL_TYPES), 'diffuse'),
  baseColor: v.optional(color('the share of light that comes back', 1), [0.8, 0.8, 0.8]),
  roughness: v.optional(share('how rough the surface is')),
  specular: v.optional(share('the strength of the highlight'), 0),
  reflectivity: v.optional(share('the weight of the mirror ray'), 0),
  metallic: v.optional(share('how much of a metal it is'), 0),
  ior: v.optional(ior, 1.5),
  conductor: v.optional(conductor, { eta: [0, 0, 0], k: [0, 0, 0] }),
  attenuationColor: v.optional(color('what is left of white light', 1), [1, 1, 1]),
  attenuationDistance: v.optional(number('after how many metres inside, 0 = clear', 0, LARGEST), 0),
  thin: v.optional(flag('whether it is a pane without an inside'), false),
  emission: v.optional(color('the radiance that the surface sends out', BRIGHTEST), [0, 0, 0]),
  energyCompensation: v.optional(flag('whether light lost by single scattering is given back'), false),
  masking: v.optional(choice('how facets hide each other', ['correlated', 'separable'])),
  ...layers,
});
/** What a material has when its file says nothing. */
export const naturalRoughness = (type: MaterialType): number =>
  type === 'conductor' || type === 'dielectric' ? 0 : 0.5;
const material = v.pipe(
  materialFields,
  v.transform((m) => ({ ...m, roughness: m.roughness ?? naturalRoughness(m.type) })),
);

const seen = (what: string) => v.optional(flag(what), true);
const sphereLight = object('a light: an object', {
  type: kind('sphere'),
  center: point('the centre'),
  radius: number('the radius in metres', SMALLEST, 1e6),
  radiance: number('what the ball sends out', 0, BRIGHTEST),
  ambient: v.optional(color('what the light adds everywhere', LIGHT_COLOR), [0, 0, 0]),
  diffuse: v.optional(color('the colour of the light', LIGHT_COLOR), [1, 1, 1]),
  specular: v.optional(color('the colour of the highlights', LIGHT_COLOR), [0, 0, 0]),
  halo: v.optional(number('the density of haze around the light, per metre', 0, LIGHT_COLOR), 0),
  visible: seen('whether camera and mirrors see the ball and its halo'),
  node: carrier,
});
const lightColor = v.optional(color('the colour of the light', LIGHT_COLOR), [1, 1, 1]);
const angle = (what: string, max: number) => number(`${what}, degrees`, 0, max);
const lightTypes = '"sphere", "quad", "point", "spot" or "directional"';
const light = v.variant(
  'type',
  [
    sphereLight,
    object('a quad light: an object', {
      type: kind('quad'),
      corner: point('one corner'),
      u: point('the way from the corner along one side'),
      v: point('the way from the corner along the other side'),
      radiance: number('what the quad sends out', 0, BRIGHTEST),
      color: lightColor,
      visible: seen('whether camera and mirrors see the quad'),
      node: carrier,
    }),
    object('a point light: an object', {
      type: kind('point'),
      position: point('where the light is'),
      intensity: number('the intensity, W / sr', 0, BRIGHTEST),
      color: lightColor,
      node: carrier,
    }),
    object('a spot light: an object', {
      type: kind('spot'),
      position: point('where the light is'),
      direction: direction('where it shines to'),
      intensity: number('the intensity, W / sr', 0, BRIGHTEST),
      color: lightColor,
      innerAngle: v.optional(angle('full light up to this angle from the axis', 90), 0),
      outerAngle: v.optional(angle('no light from this angle on', 90), 45),
      node: carrier,
    }),
    object('a directional light: an object', {
      type: kind('directional'),
      direction: direction('the way that the light travels'),
      irradiance: number('the irradiance of a surface that faces it, W / m²', 0, BRIGHTEST),
      color: lightColor,
      angle: v.optional(angle('the angular diameter', 90), 0),
      node: carrier,
    }),
  ],
  (issue) => (issue.expected === 'Object' ? `a light: an object whose "type" is ${lightTypes}` : lightTypes),
);

const keyValueRule = 'the value at that time: a number or a list of three numbers';
const key = object('a key: an object with "time" and "value"', {
  time: number('the time in seconds', -1e9, 1e9),
  value: v.union([number('the value', -1e9, 1e9), triple('the value', -1e9, 1e9)], keyValueRule),
});
const keysRule = `the keys: a list of 1 to ${SCENE_LIMITS.keysPerTrack} keys`;
export const trackSchema = object('a track: an object with "target" and "keys"', {
  target: text('a JSON Pointer to what moves, such as "/shapes/ball/center"', 1000),
  interpolation: v.optional(choice('the way from key to key', ['step', 'linear', 'smooth']), 'linear'),
  repeat: v.optional(choice('what follows the last key', ['once', 'loop', 'ping-pong']), 'loop'),
  keys: v.pipe(
    v.array(key, keysRule),
    v.minLength(1, keysRule),
    v.maxLength(SCENE_LIMITS.keysPerTrack, keysRule),
    v.description(keysRule),
  ),
});

const depthRule = `segments of a path: -1 for no limit, or a whole number from 1 to ${SCENE_LIMITS.maxDepth}`;
const depth = v.pipe(
  v.number(depthRule),
  v.integer(depthRule),
  v.minValue(-1, depthRule),
  v.maxValue(SCENE_LIMITS.maxDepth, depthRule),
  v.notValue(0, depthRule),
  v.description(depthRule),
);

const renderRule = 'the render settings: an object';
const render = object(renderRule, {
  integrator: v.optional(choice('the way to trace light', ['classic', 'path']), 'classic'),
  maxReflections: v.optional(integer('mirror rays that may follow a ray', 0, SCENE_LIMITS.maxReflections), 5),
  lightSamples: v.optional(integer('sample points on each light', 1, SCENE_LIMITS.lightSamples), 9),
  maxDepth: v.optional(depth, -1),
  exposure: v.optional(number('the exposure in stops', -32, 32), 0),
  toneMapping: v.optional(choice('how bright light is fitted to the screen', TONE_MAPPINGS), 'none'),
});

const versionRule = 'the version of the file format, which is 1';
const shapeCount = SHAPE_TYPES.reduce((sum, type) => sum + SCENE_LIMITS[type], 0);
const tracksRule = `the animation: a list of at most ${SCENE_LIMITS.track} tracks`;
const still = {
  $schema: v.optional(text('the address of the JSON Schema, for editors', 2000)),
  version: v.pipe(v.literal(1, versionRule), v.description(versionRule)),
  name: text('the name of the scene', SCENE_LIMITS.nameLength),
  description: v.optional(text('what the scene shows', 10_000), ''),
  camera,
  sky: v.optional(sky, [0, 0, 0]),
  materials: v.optional(named('the materials', material, SCENE_LIMITS.material), {}),
  meshes: v.optional(named('the meshes', mesh, SCENE_LIMITS.meshSource)),
  models: v.optional(named('the models', model, SCENE_LIMITS.model)),
  nodes: v.optional(named('the nodes', node, SCENE_LIMITS.node)),
  skins: v.optional(named('the skins', skin, SCENE_LIMITS.skin)),
  images: v.optional(named('the images', picture, SCENE_LIMITS.image)),
  textures: v.optional(named('the textures', texture, SCENE_LIMITS.texture)),
  clips: v.optional(named('the clips', clip, SCENE_LIMITS.clip)),
  clip: v.optional(text('the name of the clip that plays', 2 * SCENE_LIMITS.nameLength)),
  variants: v.optional(named('the variants', variant, SCENE_LIMITS.variant)),
  cameras: v.optional(named('the cameras', camera, SCENE_LIMITS.camera)),
  shapes: v.optional(named('the shapes', shape, shapeCount), {}),
  lights: v.optional(named('the lights', light, SCENE_LIMITS.light), {}),
  render: v.optional(render, {}),
};
const tracks = <Schema extends v.GenericSchema>(track: Schema) =>
  v.optional(
    v.pipe(v.array(track, tracksRule), v.maxLength(SCENE_LIMITS.track, tracksRule), v.description(tracksRule)),
    [],
  );
const sceneRule = 'a scene: an object with "version", "name", "camera", "shapes" and "lights"';

/** The whole file. */
export const sceneSchema = object(sceneRule, { ...still, animation: tracks(trackSchema) });
/** The file with its tracks left unread: these are read one by one, so that problems in many keys stay few in memory. */
export const stillSchema = object(sceneRule, { ...still, animation: tracks(v.unknown()) });
