/** The JSON of glTF 2.0: chapter 5 of its specification, less what nobody here reads. */
import { GLTF_LIMITS } from '../limits.ts';
import { bufferViewExtensions, materialExtensions, meshExtensions, nodeExtensions, primitiveExtensions, rootExtensions, textureExtensions } from './extension-forms.ts'; // biome-ignore format: one list
import {
  affine,
  both,
  choice,
  type Form,
  flag,
  index,
  integer,
  list,
  map,
  number,
  numbers,
  object,
  text,
} from './form.ts';
import { normalTexture, occlusionTexture, textureInfo } from './texture-forms.ts';

/** Everything may have a name and data of the application. */
const named = { name: text };

const asset = object({ version: text }, { minVersion: text });

const buffer = object({ byteLength: integer(1) }, { ...named, uri: text });

const bufferView = object(
  { buffer: index('buffers'), byteLength: integer(1) },
  { ...named, byteOffset: integer(0), byteStride: integer(1, 255), extensions: bufferViewExtensions },
);

const INDEX_TYPES = [5121, 5123, 5125] as const;
const COMPONENT_TYPES = [5120, 5121, 5122, 5123, 5125, 5126] as const;

const sparse = object({
  count: integer(1),
  indices: object(
    { bufferView: index('bufferViews'), componentType: choice(...INDEX_TYPES) },
    { byteOffset: integer(0) },
  ),
  values: object({ bufferView: index('bufferViews') }, { byteOffset: integer(0) }),
});

const accessor = object(
  {
    componentType: choice(...COMPONENT_TYPES),
    count: integer(1),
    type: choice('SCALAR', 'VEC2', 'VEC3', 'VEC4', 'MAT2', 'MAT3', 'MAT4'),
  },
  { ...named, bufferView: index('bufferViews'), byteOffset: integer(0), normalized: flag, sparse },
);

const image = object({}, { ...named, uri: text, mimeType: text, bufferView: index('bufferViews') });

const sampler = object(
  {},
  {
    ...named,
    magFilter: choice(9728, 9729),
    minFilter: choice(9728, 9729, 9984, 9985, 9986, 9987),
    wrapS: choice(33071, 33648, 10497),
    wrapT: choice(33071, 33648, 10497),
  },
);

const texture = object(
  {},
  { ...named, source: index('images'), sampler: index('samplers'), extensions: textureExtensions },
);

const material = object(
  {},
  {
    ...named,
    pbrMetallicRoughness: object(
      {},
      {
        baseColorFactor: numbers(4),
        baseColorTexture: textureInfo,
        metallicFactor: number(),
        roughnessFactor: number(),
        metallicRoughnessTexture: textureInfo,
      },
    ),
    normalTexture,
    occlusionTexture,
    emissiveTexture: textureInfo,
    emissiveFactor: numbers(3),
    alphaMode: choice('OPAQUE', 'MASK', 'BLEND'),
    alphaCutoff: number(0),
    doubleSided: flag,
    extensions: materialExtensions,
  },
);

const attributes = map(index('accessors'));
const primitive = object(
  { attributes },
  {
    indices: index('accessors'),
    material: index('materials'),
    mode: integer(0, 6),
    targets: list(attributes),
    extensions: primitiveExtensions,
  },
);

const mesh = object(
  { primitives: list(primitive, 1) },
  { ...named, weights: list(number()), extensions: meshExtensions },
);

const node = object(
  {},
  {
    ...named,
    camera: index('cameras'),
    children: list(index('nodes')),
    skin: index('skins'),
    matrix: affine(GLTF_LIMITS.farthest),
    mesh: index('meshes'),
    rotation: numbers(4),
    scale: numbers(3, GLTF_LIMITS.farthest),
    translation: numbers(3, GLTF_LIMITS.farthest),
    weights: list(number()),
    extensions: nodeExtensions,
  },
);

const skin = object(
  { joints: list(index('nodes'), 1) },
  { ...named, inverseBindMatrices: index('accessors'), skeleton: index('nodes') },
);

const channelTarget = object(
  { path: text },
  { node: index('nodes'), extensions: object({}, { KHR_animation_pointer: object({ pointer: text }) }) },
);

const animation: Form = both(
  object({
    channels: list(object({ sampler: integer(0), target: channelTarget })),
    samplers: list(
      object(
        { input: index('accessors'), output: index('accessors') },
        { interpolation: choice('LINEAR', 'STEP', 'CUBICSPLINE') },
      ),
    ),
  }),
  object({}, named),
);

const camera = object(
  { type: choice('perspective', 'orthographic') },
  {
    ...named,
    perspective: object({ yfov: number(0), znear: number(0) }, { aspectRatio: number(0), zfar: number(0) }),
    orthographic: object({ xmag: number(), ymag: number(), zfar: number(), znear: number() }),
  },
);

const scene = object({}, { ...named, nodes: list(index('nodes')) });

export const gltfForm = object(
  { asset },
  {
    extensionsUsed: list(text),
    extensionsRequired: list(text),
    buffers: list(buffer),
    bufferViews: list(bufferView),
    accessors: list(accessor),
    images: list(image),
    samplers: list(sampler),
    textures: list(texture),
    materials: list(material),
    meshes: list(mesh),
    nodes: list(node),
    skins: list(skin),
    animations: list(animation),
    cameras: list(camera),
    scenes: list(scene),
    scene: index('scenes'),
    extensions: rootExtensions,
  },
);
