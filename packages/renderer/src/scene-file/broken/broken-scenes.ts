import type { Draft } from './good-scene.ts';

/** One defect each: what it is, how to bring it about, and the paths of exactly the problems it gives. */
export type BrokenScene = readonly [defect: string, breakIt: (scene: Draft) => void, paths: readonly string[]];

const key = (time: unknown, value: unknown) => ({ time, value });
const track = (target: unknown, ...keys: unknown[]) => ({ target, keys });
const many = (count: number, thing: unknown) =>
  Object.fromEntries(Array.from({ length: count }, (_, index) => [`thing ${index}`, thing]));
const ball = { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'clay' };
const own = (object: object, name: string, value: unknown) =>
  Object.defineProperty(object, name, { value, enumerable: true, configurable: true });

export const brokenParts: readonly BrokenScene[] = [
  ['no version', (s) => delete s.version, ['/version']],
  ['another version', (s) => (s.version = 2), ['/version']],
  ['version as a text', (s) => (s.version = '1'), ['/version']],
  ['no name', (s) => delete s.name, ['/name']],
  ['a number as name', (s) => (s.name = 7), ['/name']],
  ['an endless name', (s) => (s.name = 'x'.repeat(201)), ['/name']],
  ['an unknown key', (s) => (s.shape = {}), ['/shape']],
  ['an unknown key in a material', (s) => (s.materials.clay.colour = [1, 0, 0]), ['/materials/clay/colour']],
  ['no camera', (s) => delete s.camera, ['/camera']],
  ['a list as camera', (s) => (s.camera = [0, 1, 5]), ['/camera']],
  ['null as camera', (s) => (s.camera = null), ['/camera']],
  ['an eye of two numbers', (s) => (s.camera.eye = [0, 1]), ['/camera/eye']],
  ['an eye of four numbers', (s) => (s.camera.eye = [0, 1, 2, 3]), ['/camera/eye']],
  ['a text in the eye', (s) => (s.camera.eye[1] = '1'), ['/camera/eye/1']],
  ['an eye too far away', (s) => (s.camera.eye[2] = 2e9), ['/camera/eye/2']],
  ['an eye at its target', (s) => (s.camera.target = [0, 1, 5]), ['/camera/target']],
  ['an up along the view', (s) => (s.camera.up = [0, 0, -2]), ['/camera/up']],
  ['an up of zero', (s) => (s.camera.up = [0, 0, 0]), ['/camera/up']],
  ['a field of view of 180°', (s) => (s.camera.verticalFov = 180), ['/camera/verticalFov']],
  ['a field of view of 0°', (s) => (s.camera.verticalFov = 0), ['/camera/verticalFov']],
  ['an unknown projection', (s) => (s.camera.projection = 'fisheye'), ['/camera/projection']],
  ['a number as projection', (s) => (s.camera.projection = 1), ['/camera/projection']],
  ['a view without height', (s) => (s.camera.viewHeight = 0), ['/camera/viewHeight']],
  ['a negative aperture', (s) => (s.camera.aperture = -0.01), ['/camera/aperture']],
  ['a text as aperture', (s) => (s.camera.aperture = 'f/2'), ['/camera/aperture']],
  ['a focus behind the camera', (s) => (s.camera.focusDistance = -1), ['/camera/focusDistance']],
  ['an infinite focus', (s) => (s.camera.focusDistance = Number.POSITIVE_INFINITY), ['/camera/focusDistance']],
  ['a sky without zenith', (s) => delete s.sky.zenith, ['/sky/zenith']],
  ['a sky with nothing', (s) => (s.sky = {}), ['/sky/horizon', '/sky/zenith']],
  ['a scale without an image', (s) => (s.sky.scale = 2), ['/sky/scale']],
  ['a rotation without an image', (s) => (s.sky.rotation = 2), ['/sky/rotation']],
  ['an image that is a number', (s) => (s.sky.image = 7), ['/sky/image']],
  ['an image of another kind', (s) => (s.sky.image = 'sky.jpg'), ['/sky/image']],
  ['an image without a name', (s) => (s.sky.image = '.hdr'), ['/sky/image']],
  ['an image from a server', (s) => (s.sky.image = 'https://example.org/sky.hdr'), ['/sky/image']],
  ['an image from any folder', (s) => (s.sky.image = '/home/sky.hdr'), ['/sky/image']],
  ['an image from a drive', (s) => (s.sky.image = 'C:\\sky.hdr'), ['/sky/image']],
  ['an image with a line break', (s) => (s.sky.image = 'sky\n.hdr'), ['/sky/image']],
  ['a negative scale', (s) => (s.sky = { image: 'sky.hdr', scale: -1 }), ['/sky/scale']],
  ['a text as rotation', (s) => (s.sky = { image: 'sky.hdr', rotation: '90' }), ['/sky/rotation']],
  ['a map in a file', (s) => (s.sky = { image: 'sky.hdr', map: {} }), ['/sky/map']],
  ['a sky of two numbers', (s) => (s.sky = [1, 1]), ['/sky']],
  ['a text as sky', (s) => (s.sky = 'blue'), ['/sky']],
  ['a negative sky', (s) => (s.sky.horizon[0] = -0.1), ['/sky/horizon/0']],
  ['a list of materials', (s) => (s.materials = [{}]), ['/materials']],
  ['a base colour over 1', (s) => (s.materials.clay.baseColor[0] = 1.1), ['/materials/clay/baseColor/0']],
  ['a reflectivity over 1', (s) => (s.materials.glossy.reflectivity = 1.01), ['/materials/glossy/reflectivity']],
  ['a negative roughness', (s) => (s.materials.clay.roughness = -0.1), ['/materials/clay/roughness']],
  ['true as specular', (s) => (s.materials.clay.specular = true), ['/materials/clay/specular']],
  ['too many materials', (s) => Object.assign(s.materials, many(4096, {})), ['/materials']],
  ['an empty material name', (s) => (s.materials[''] = {}), ['/materials/']],
  ['a name with a space at its end', (s) => (s.materials['clay '] = {}), ['/materials/clay ']],
  ['a name with a line break', (s) => (s.materials['a\nb'] = {}), ['/materials/a\nb']],
  ['names that look alike', (s) => Object.assign(s.materials, { é: {}, 'e\u0301': {} }), ['/materials/e\u0301']],
  ['a shape named __proto__', (s) => own(s.shapes, '__proto__', ball), ['/shapes/__proto__']],
  ['a material named constructor', (s) => own(s.materials, 'constructor', {}), ['/materials/constructor']],
  ['a material named prototype', (s) => own(s.materials, 'prototype', {}), ['/materials/prototype']],
  ['a __proto__ key in a shape', (s) => own(s.shapes.ball, '__proto__', {}), ['/shapes/ball/__proto__']],
];

export const brokenShapes: readonly BrokenScene[] = [
  ['no type', (s) => delete s.shapes.ball.type, ['/shapes/ball/type']],
  ['an unknown type', (s) => (s.shapes.ball.type = 'cone'), ['/shapes/ball/type']],
  ['a list as type', (s) => (s.shapes.ball.type = ['sphere']), ['/shapes/ball/type']],
  ['a number as shape', (s) => (s.shapes.ball = 5), ['/shapes/ball']],
  ['a list as shape', (s) => (s.shapes.ball = [1, 2, 3]), ['/shapes/ball']],
  ['a missing material name', (s) => delete s.shapes.ball.material, ['/shapes/ball/material']],
  ['an unknown material', (s) => (s.shapes.ball.material = 'Clay'), ['/shapes/ball/material']],
  ['a material that objects inherit', (s) => (s.shapes.ball.material = 'toString'), ['/shapes/ball/material']],
  ['a negative radius', (s) => (s.shapes.ball.radius = -1), ['/shapes/ball/radius']],
  [
    'a negative radius and an unknown material',
    (s) => Object.assign(s.shapes.ball, { radius: -1, material: 'nope' }),
    ['/shapes/ball/radius', '/shapes/ball/material'],
  ],
  ['a material without a name', (s) => (s.shapes.ball.material = ''), ['/shapes/ball/material']],
  [
    'a scale of zero and an unknown mesh',
    (s) => Object.assign(s.shapes.stone, { scale: 0, mesh: 'nope' }),
    ['/shapes/stone/scale', '/shapes/stone/mesh'],
  ],
  [
    'a lamp without radius on an unknown node',
    (s) => Object.assign(s.lights.lamp, { radius: 0, node: 'nope' }),
    ['/lights/lamp/radius', '/lights/lamp/node'],
  ],
  [
    'a camera without height on an unknown node',
    (s) => Object.assign(s.camera, { viewHeight: 0, node: 'nope' }),
    ['/camera/viewHeight', '/camera/node'],
  ],
  [
    'a material with two mistakes',
    (s) => Object.assign(s.materials.clay, { roughness: 7, baseColorTexture: { texture: 'nope' } }),
    ['/materials/clay/roughness', '/materials/clay/baseColorTexture'],
  ],
  ['a radius of zero', (s) => (s.shapes.ball.radius = 0), ['/shapes/ball/radius']],
  ['NaN as radius', (s) => (s.shapes.ball.radius = Number.NaN), ['/shapes/ball/radius']],
  ['an infinite radius', (s) => (s.shapes.ball.radius = Number.POSITIVE_INFINITY), ['/shapes/ball/radius']],
  ['a BigInt as radius', (s) => (s.shapes.ball.radius = 1n), ['/shapes/ball/radius']],
  ['a function as radius', (s) => (s.shapes.ball.radius = () => 1), ['/shapes/ball/radius']],
  ['a symbol as radius', (s) => (s.shapes.ball.radius = Symbol('one')), ['/shapes/ball/radius']],
  ['a typed array as centre', (s) => (s.shapes.ball.center = new Uint8Array(3)), ['/shapes/ball/center']],
  // biome-ignore lint/suspicious/noSparseArray: a hole is what is tried
  ['a hole in a list', (s) => (s.shapes.ball.center = [0, , 0]), ['/shapes/ball/center/1']],
  ['a huge list as centre', (s) => (s.shapes.ball.center = new Array(4e9)), ['/shapes/ball/center']],
  ['a Map of shapes', (s) => (s.shapes = new Map()), ['/shapes']],
  ['a box without depth', (s) => (s.shapes.block.size[2] = 0), ['/shapes/block/size/2']],
  ['a rotation of one number', (s) => (s.shapes.block.rotation = 45), ['/shapes/block/rotation']],
  ['a normal of zero', (s) => (s.shapes.floor.normal = [0, 0, 0]), ['/shapes/floor/normal']],
  ['a plane that shines', (s) => (s.materials.clay.emission = [0, 0, 2]), ['/shapes/floor/material']],
  ['a plane of glass', (s) => (s.materials.clay.type = 'dielectric'), ['/shapes/floor/material']],
  [
    'a plane that lets light through',
    (s) => Object.assign(s.materials.clay, { type: 'metallicRoughness', transmission: { weight: 1 } }),
    ['/shapes/floor/material'],
  ],
  [
    'a plane of a material that is faulty itself',
    (s) => Object.assign(s.materials.clay, { type: 'dielectric', emission: [0, -1, 2] }),
    ['/materials/clay/emission/1'],
  ],
  ['a quad without area', (s) => (s.shapes.panel.v = [-2, 0, 0]), ['/shapes/panel/v']],
  ['a quad with a side of zero', (s) => (s.shapes.panel.u = [0, 0, 0]), ['/shapes/panel/v']],
  ['a list of meshes', (s) => (s.meshes = [{ file: 'rock.ply' }]), ['/meshes']],
  ['a mesh without file', (s) => delete s.meshes.rock.file, ['/meshes/rock/file']],
  ['a mesh that is a text', (s) => (s.meshes.rock = 'rock.ply'), ['/meshes/rock']],
  ['a mesh of another kind of file', (s) => (s.meshes.rock.file = 'rock.blend'), ['/meshes/rock/file']],
  ['a mesh from a server', (s) => (s.meshes.rock.file = 'https://example.org/rock.ply'), ['/meshes/rock/file']],
  ['a mesh from any folder', (s) => (s.meshes.rock.file = '/home/rock.ply'), ['/meshes/rock/file']],
  ['a mesh with its triangles in the text', (s) => (s.meshes.rock.data = { positions: [] }), ['/meshes/rock/data']],
  ['a number as part', (s) => (s.meshes.rock.part = 1), ['/meshes/rock/part']],
  ['an unknown shading', (s) => (s.meshes.rock.shading = 'phong'), ['/meshes/rock/shading']],
  ['too many meshes', (s) => Object.assign(s.meshes, many(4096, { file: 'rock.ply' })), ['/meshes']],
  ['a shape without a mesh', (s) => delete s.shapes.stone.mesh, ['/shapes/stone/mesh']],
  ['a shape of an unknown mesh', (s) => (s.shapes.stone.mesh = 'rcok'), ['/shapes/stone/mesh']],
  ['a mesh that objects inherit', (s) => (s.shapes.stone.mesh = 'valueOf'), ['/shapes/stone/mesh']],
  ['shapes of meshes where there are none', (s) => delete s.meshes, ['/shapes/stone/mesh', '/shapes/slab/mesh']],
  ['a file in a shape', (s) => (s.shapes.stone.file = 'rock.ply'), ['/shapes/stone/file']],
  ['a node, of which there are none', (s) => (s.shapes.stone.node = 'arm'), ['/shapes/stone/node']],
  ['a scale of one number', (s) => (s.shapes.stone.scale = 2), ['/shapes/stone/scale']],
  ['a scale of zero', (s) => (s.shapes.stone.scale[1] = 0), ['/shapes/stone/scale/1']],
  ['a scale that is too large', (s) => (s.shapes.stone.scale[2] = -2e6), ['/shapes/stone/scale/2']],
  ['a translation of two numbers', (s) => (s.shapes.stone.translation = [0, 1]), ['/shapes/stone/translation']],
  ['a matrix of twelve numbers', (s) => (s.shapes.slab.matrix.length = 12), ['/shapes/slab/matrix']],
  ['a matrix of rows', (s) => (s.shapes.slab.matrix = [[1, 0, 0, 0]]), ['/shapes/slab/matrix/0']],
  ['NaN in a matrix', (s) => (s.shapes.slab.matrix[3] = Number.NaN), ['/shapes/slab/matrix/3']],
  ['a matrix that is given column by column', (s) => (s.shapes.slab.matrix[12] = 3), ['/shapes/slab/matrix']],
  ['a matrix that makes flat', (s) => (s.shapes.slab.matrix[0] = 0), ['/shapes/slab/matrix']],
  ['a projective matrix', (s) => (s.shapes.slab.matrix[15] = 2), ['/shapes/slab/matrix']],
  [
    'too many shapes of meshes',
    (s) => Object.assign(s.shapes, many(32_768, { type: 'mesh', mesh: 'rock', material: 'clay' })),
    ['/shapes'],
  ],
  ['no shapes and no lights', (s) => Object.assign(s, { shapes: {}, lights: {}, animation: [] }), ['/shapes']],
  [
    'no shapes and only an unseen light',
    (s) => Object.assign(s, { shapes: {}, animation: [] }) && (s.lights.lamp.visible = false),
    ['/shapes'],
  ],
  ['too many spheres', (s) => Object.assign(s.shapes, many(512, ball)), ['/shapes']],
  ['too many shapes of all', (s) => Object.assign(s.shapes, many(40_000, ball)), ['/shapes']],
  ['a light without radius', (s) => delete s.lights.lamp.radius, ['/lights/lamp/radius']],
  ['a negative radiance', (s) => (s.lights.lamp.radiance = -1), ['/lights/lamp/radiance']],
  ['a light that is a box', (s) => (s.lights.lamp.type = 'box'), ['/lights/lamp/type']],
  [
    'a quad light without area',
    (s) => (s.lights.panel = { type: 'quad', corner: [0, 3, 0], u: [1, 0, 0], v: [2, 0, 0], radiance: 1 }),
    ['/lights/panel/v'],
  ],
  [
    'a sun that shines nowhere',
    (s) => (s.lights.sun = { type: 'directional', direction: [0, 0, 0], irradiance: 1 }),
    ['/lights/sun/direction'],
  ],
  [
    'a spot that shines nowhere',
    (s) => (s.lights.spot = { type: 'spot', position: [0, 3, 0], direction: [0, 1e-7, 0], intensity: 1 }),
    ['/lights/spot/direction'],
  ],
  ['1 as visible', (s) => (s.lights.lamp.visible = 1), ['/lights/lamp/visible']],
  [
    'too many lights',
    (s) => Object.assign(s.lights, many(4096, { type: 'point', position: [0, 9, 0], intensity: 1 })),
    ['/lights'],
  ],
  ['too many lights with a surface', (s) => Object.assign(s.lights, many(64, s.lights.lamp)), ['/lights']],
  ['null as lights', (s) => (s.lights = null), ['/lights']],
  ['too many reflections', (s) => (s.render = { maxReflections: 65 }), ['/render/maxReflections']],
  ['paths without a segment', (s) => (s.render = { maxDepth: 0 }), ['/render/maxDepth']],
  ['half a path segment', (s) => (s.render = { maxDepth: 1.5 }), ['/render/maxDepth']],
  ['half a light sample', (s) => (s.render = { lightSamples: 1.5 }), ['/render/lightSamples']],
  ['an unknown tone mapping', (s) => (s.render = { toneMapping: 'ACES' }), ['/render/toneMapping']],
  ['an unknown integrator', (s) => (s.render = { integrator: 'magic' }), ['/render/integrator']],
];

const BALL = '/shapes/ball/center';
export const brokenAnimation: readonly BrokenScene[] = [
  ['an object as animation', (s) => (s.animation = {}), ['/animation']],
  ['a text as track', (s) => (s.animation = ['up']), ['/animation/0']],
  ['a track without keys', (s) => (s.animation = [{ target: BALL }]), ['/animation/0/keys']],
  ['a track of no keys', (s) => (s.animation = [track(BALL)]), ['/animation/0/keys']],
  [
    'too many keys',
    (s) => (s.animation = [track(BALL, ...Array.from({ length: 4097 }, (_, t) => key(t, [0, 0, 0])))]),
    ['/animation/0/keys'],
  ],
  ['too many tracks', (s) => (s.animation = new Array(1025).fill(track(BALL))), ['/animation']],
  [
    'a target that is no pointer',
    (s) => (s.animation = [track('shapes/ball/center', key(0, [0, 0, 0]))]),
    ['/animation/0/target'],
  ],
  ['a target that is not there', (s) => (s.animation[0].target = '/shapes/bal/center'), ['/animation/0/target']],
  [
    'a target that is a name',
    (s) => (s.animation = [track('/shapes/ball/material', key(0, 1))]),
    ['/animation/0/target'],
  ],
  [
    'a target that is a setting',
    (s) => (s.animation = [track('/render/exposure', key(0, 1))]),
    ['/animation/0/target'],
  ],
  [
    'a target in the prototype',
    (s) => (s.animation = [track('/shapes/__proto__/x', key(0, 1))]),
    ['/animation/0/target'],
  ],
  ['a target past a number', (s) => (s.animation = [track(`${BALL}/0/0`, key(0, 1))]), ['/animation/0/target']],
  ['a component that is not there', (s) => (s.animation = [track(`${BALL}/3`, key(0, 1))]), ['/animation/0/target']],
  [
    'an aperture that becomes negative',
    (s) => s.animation.push(track('/camera/aperture', key(0, 0), key(1, -1))),
    ['/animation/1/keys/1/value'],
  ],
  ['a projection that moves', (s) => s.animation.push(track('/camera/projection', key(0, 0))), ['/animation/1/target']],
  ['times that stand still', (s) => (s.animation[0].keys[1].time = 0), ['/animation/0/keys/1/time']],
  ['times that go back', (s) => (s.animation[0].keys[1].time = -1), ['/animation/0/keys/1/time']],
  ['NaN as time', (s) => (s.animation[0].keys[1].time = Number.NaN), ['/animation/0/keys/1/time']],
  ['a number for a triple', (s) => (s.animation[0].keys[1].value = 3), ['/animation/0/keys/1/value']],
  [
    'a triple for a number',
    (s) => (s.animation[0].target = '/shapes/ball/radius'),
    ['/animation/0/keys/0/value', '/animation/0/keys/1/value'],
  ],
  [
    'a key out of range',
    (s) => (s.animation = [track('/shapes/ball/radius', key(0, 1), key(1, -1))]),
    ['/animation/0/keys/1/value'],
  ],
  [
    'a plane that begins to shine',
    (s) => (s.animation = [track('/materials/clay/emission', key(0, [0, 0, 0]), key(1, [0, 1, 0]))]),
    ['/animation/0/keys/1/value'],
  ],
  [
    'a plane that begins to shine red',
    (s) => (s.animation = [track('/materials/clay/emission/0', key(0, 0), key(1, 2))]),
    ['/animation/0/keys/1/value'],
  ],
  [
    'a scale that goes through zero',
    (s) => (s.animation = [track('/shapes/stone/scale', key(0, [1, 1, 1]), key(1, [1, 0, 1]))]),
    ['/animation/0/keys/1/value'],
  ],
  ['a matrix that moves', (s) => (s.animation = [track('/shapes/slab/matrix/3', key(0, 1))]), ['/animation/0/target']],
  ['a mesh that is exchanged', (s) => (s.animation = [track('/shapes/slab/mesh', key(0, 1))]), ['/animation/0/target']],
  ['a file that moves', (s) => (s.animation = [track('/meshes/rock/file', key(0, 1))]), ['/animation/0/target']],
  ['two tracks for one thing', (s) => s.animation.push(s.animation[0]), ['/animation/1/target']],
  [
    'a track for a triple and one for its part',
    (s) => s.animation.push(track(`${BALL}/1`, key(0, 1))),
    ['/animation/1/target'],
  ],
  ['an unknown way to repeat', (s) => (s.animation[0].repeat = 'forever'), ['/animation/0/repeat']],
  ['an unknown interpolation', (s) => (s.animation[0].interpolation = 'bezier'), ['/animation/0/interpolation']],
];

/** Values that no JSON text can hold. */
export const brokenObjects: readonly BrokenScene[] = [
  ['a scene within itself', (s) => (s.shapes.again = s), ['/shapes/again/type']],
  ['shapes within themselves', (s) => (s.shapes.again = s.shapes), ['/shapes/again/type']],
  [
    'a getter that throws',
    (s) =>
      Object.defineProperty(s.shapes.ball, 'radius', {
        enumerable: true,
        get: () => {
          throw new Error('no');
        },
      }),
    ['/shapes/ball/radius'],
  ],
  [
    'a proxy whose every trap throws',
    (s) => {
      const throwing = new Proxy(
        {},
        {
          get: () => () => {
            throw new Error('trap');
          },
        },
      );
      s.shapes.ball = new Proxy({}, throwing);
    },
    ['/shapes/ball'],
  ],
  [
    'a revoked proxy',
    (s) => {
      const { proxy, revoke } = Proxy.revocable([], {});
      revoke();
      s.camera.eye = proxy;
    },
    ['/camera/eye'],
  ],
];

/** Of the scene with everything (`richScene`). */
export const brokenRich: readonly BrokenScene[] = [
  ['an image of another kind', (s) => (s.images.bark.file = 'bark.tga'), ['/images/bark/file']],
  ['an image without a file', (s) => (s.images.bark = {}), ['/images/bark/file']],
  ['an image that is a number', (s) => (s.images.bark = 3), ['/images/bark']],
  ['a texture without an image', (s) => delete s.textures.bark.image, ['/textures/bark/image']],
  ['a texture of no image', (s) => (s.textures.bark.image = 'brak'), ['/textures/bark/image']],
  ['an unknown wrap', (s) => (s.textures.bark.wrapU = 'tile'), ['/textures/bark/wrapU']],
  ['mipmaps as a text', (s) => (s.textures.bark.mipmaps = 'yes'), ['/textures/bark/mipmaps']],
  [
    'a material with no texture of the name',
    (s) => (s.materials.coated.clearcoat.weightTexture = 'brak'),
    ['/materials/coated/clearcoat/weightTexture'],
  ],
  [
    'a third set of coordinates',
    (s) => (s.materials.coated.baseColorTexture.uvSet = 2),
    ['/materials/coated/baseColorTexture/uvSet'],
  ],
  [
    'an unknown key in a use',
    (s) => (s.materials.coated.baseColorTexture.tile = 2),
    ['/materials/coated/baseColorTexture/tile'],
  ],
  ['a number as use', (s) => (s.materials.coated.emissionTexture = 2), ['/materials/coated/emissionTexture']],
  ['a coat over 1', (s) => (s.materials.coated.clearcoat.weight = 2), ['/materials/coated/clearcoat/weight']],
  ['an index between 0 and 1', (s) => (s.materials.coated.ior = 0.5), ['/materials/coated/ior']],
  ['a film without an index', (s) => (s.materials.coated.iridescence.ior = 0), ['/materials/coated/iridescence/ior']],
  ['an unknown alpha mode', (s) => (s.materials.coated.alphaMode = 'add'), ['/materials/coated/alphaMode']],
  ['a coat that is a number', (s) => (s.materials.coated.clearcoat = 1), ['/materials/coated/clearcoat']],
  [
    'an unknown key in a coat',
    (s) => (s.materials.coated.clearcoat.strength = 1),
    ['/materials/coated/clearcoat/strength'],
  ],
  ['a node of five numbers', (s) => (s.nodes.arm.rotation = [0, 0, 0, 0, 1]), ['/nodes/arm/rotation']],
  ['a turn of no length', (s) => (s.nodes.arm.rotation = [0, 0, 0, 0]), ['/nodes/arm/rotation']],
  ['a matrix and a scale', (s) => (s.nodes.fixed.scale = [1, 1, 1]), ['/nodes/fixed/scale']],
  ['a matrix of nine numbers', (s) => (s.nodes.fixed.matrix = [1, 0, 0, 0, 1, 0, 0, 0, 1]), ['/nodes/fixed/matrix']],
  ['a node carried by none', (s) => (s.nodes.arm.parent = 'stnad'), ['/nodes/arm/parent']],
  ['nodes in a ring', (s) => (s.nodes.stand.parent = 'arm'), ['/nodes/stand/parent']],
  ['a node that carries itself', (s) => (s.nodes.stand.parent = 'stand'), ['/nodes/stand/parent']],
  ['a shape on no node', (s) => (s.shapes.ball.node = 'leg'), ['/shapes/ball/node']],
  ['a light on no node', (s) => (s.lights.spot.node = 'leg'), ['/lights/spot/node']],
  ['a camera on no node', (s) => (s.camera.node = 'leg'), ['/camera/node']],
  ['another camera on no node', (s) => (s.cameras.close.node = 'leg'), ['/cameras/close/node']],
  ['another camera at its target', (s) => (s.cameras.close.eye = [0, 1, 0]), ['/cameras/close/target']],
  [
    'a ball on a node that stretches it',
    (s) => {
      s.nodes.stand.scale = [1, 2, 1];
      s.shapes.ball.node = 'stand';
    },
    ['/shapes/ball/node'],
  ],
  ['a joint that is no node', (s) => (s.skins.bones.joints[1] = 'amr'), ['/skins/bones/joints/1']],
  ['a skin without joints', (s) => (s.skins.bones.joints = []), ['/skins/bones/joints']],
  ['a matrix too few', (s) => s.skins.bones.inverseBindMatrices.pop(), ['/skins/bones/inverseBindMatrices']],
  ['a mesh with no skin of the name', (s) => (s.shapes.parts.skin = 'bone'), ['/shapes/parts/skin']],
  ['no places', (s) => (s.shapes.parts.instances = []), ['/shapes/parts/instances']],
  ['a place of three numbers', (s) => (s.shapes.parts.instances[0] = [1, 2, 3]), ['/shapes/parts/instances/0']],
  ['a place and a number', (s) => (s.shapes.parts.instances[0] = 1), ['/shapes/parts/instances']],
  [
    'a clip that moves nothing',
    (s) => (s.clips.wave.tracks[0].target = '/nodes/amr/rotation'),
    ['/clips/wave/tracks/0/target'],
  ],
  ['values too few', (s) => s.clips.wave.tracks[0].values.pop(), ['/clips/wave/tracks/0/values']],
  ['a text among values', (s) => (s.clips.wave.tracks[0].values[0][1] = '1'), ['/clips/wave/tracks/0/values']],
  ['times that fall', (s) => (s.clips.wave.tracks[0].times = [1, 0]), ['/clips/wave/tracks/0/times']],
  ['no keys', (s) => Object.assign(s.clips.wave.tracks[0], { times: [], values: [] }), ['/clips/wave/tracks/0/values']],
  ['a coat that grows beyond 1', (s) => (s.clips.wave.tracks[1].values[4] = 1.5), ['/clips/wave/tracks/1/values']],
  ['a clip without tracks', (s) => delete s.clips.wave.tracks, ['/clips/wave/tracks']],
  ['no clip of the name', (s) => (s.clip = 'wvae'), ['/clip']],
  ['a variant of no shape', (s) => (s.variants.night.bell = 'clay'), ['/variants/night/bell']],
  ['a variant of no material', (s) => (s.variants.night.ball = 'caly'), ['/variants/night/ball']],
  ['a model of another kind', (s) => (s.models.fox.file = 'fox.fbx'), ['/models/fox/file']],
  ['a model from a server', (s) => (s.models.fox.file = 'https://example.org/fox.glb'), ['/models/fox/file']],
  ['a model on no node', (s) => (s.models.fox.node = 'stnad'), ['/models/fox/node']],
  ['a flat model', (s) => (s.models.fox.scale = [1, 0, 1]), ['/models/fox/scale/1']],
  ['a mesh from a model', (s) => (s.meshes.rock.file = 'fox.glb'), ['/meshes/rock/file']],
  ['a node with the name of a model', (s) => (s.nodes.fox = {}), ['/nodes/fox']],
  ['a material with the name of one of the model', (s) => (s.materials['fox/fur'] = {}), ['/materials/fox~1fur']],
];
