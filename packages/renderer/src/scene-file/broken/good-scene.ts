/** A small scene without fault, as a file would give it; each broken scene breaks it in one way. */
// biome-ignore lint/suspicious/noExplicitAny: what breaks it has no type
export type Draft = any;

export const goodScene = (): Draft => ({
  version: 1,
  name: 'Good',
  camera: { eye: [0, 1, 5], target: [0, 1, 0] },
  sky: { horizon: [0.5, 0.5, 0.5], zenith: [0.1, 0.2, 0.4] },
  materials: { clay: { baseColor: [0.7, 0.3, 0.2] }, glossy: { reflectivity: 0.5 } },
  meshes: { rock: { file: 'meshes/rock.ply', shading: 'smooth' }, spare: { file: '../spare.OBJ', part: 'lid' } },
  shapes: {
    ball: { type: 'sphere', center: [0, 1, 0], radius: 1, material: 'clay' },
    block: { type: 'box', center: [2, 0.5, 0], size: [1, 1, 1], material: 'glossy' },
    floor: { type: 'plane', point: [0, 0, 0], normal: [0, 1, 0], material: 'clay' },
    stone: { type: 'mesh', mesh: 'rock', material: 'clay', translation: [1, 0, 2], scale: [-0.5, 0.5, 0.5] },
    slab: { type: 'mesh', mesh: 'rock', material: 'glossy', matrix: [2, 0, 0, 5, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1] },
    panel: { type: 'quad', corner: [-3, 0, -2], u: [1, 0, 0], v: [0, 1, 0], material: 'glossy' },
  },
  lights: { lamp: { type: 'sphere', center: [0, 5, 0], radius: 0.5, radiance: 40 } },
  animation: [
    {
      target: '/shapes/ball/center',
      keys: [
        { time: 0, value: [0, 1, 0] },
        { time: 2, value: [0, 2, 0] },
      ],
    },
  ],
});

/** The same with everything else that a scene may have. */
export function richScene(): Draft {
  const scene = goodScene();
  return {
    ...scene,
    images: { bark: { file: 'textures/bark.jpg' }, 'leaf.png': 'leaf.png' },
    textures: { bark: { image: 'bark', wrapU: 'mirror', filter: 'nearest', mipmaps: false } },
    models: {
      fox: { file: 'models/fox.glb', translation: [3, 0, 0], rotation: [0, 90, 0], node: 'stand', variant: 'winter' },
    },
    nodes: {
      stand: { translation: [0, 0.5, 0], rotation: [0, 45, 0], scale: [2, 2, 2] },
      arm: { parent: 'stand', rotation: [0, 0, 0.6, 0.8], weights: [0, 0.5] },
      fixed: { parent: 'arm', matrix: [1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7] },
    },
    skins: {
      bones: {
        joints: ['stand', 'arm'],
        inverseBindMatrices: [
          [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0],
          [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0],
        ],
      },
    },
    clips: {
      wave: {
        repeat: 'ping-pong',
        tracks: [
          {
            target: '/nodes/arm/rotation',
            times: [0, 0.1],
            values: [
              [0, 0, 0, 1],
              [0, 0, 0.6, 0.8],
            ],
          },
          {
            target: '/materials/coated/clearcoat/weight',
            interpolation: 'cubic',
            times: [0, 2],
            values: [0, 0.5, 0.5, 0.25, 1, -9],
          },
        ],
      },
    },
    clip: 'wave',
    variants: { night: { ball: 'glossy', block: 'coated' } },
    cameras: { close: { eye: [0, 1, 2], target: [0, 1, 0], node: 'stand' } },
    materials: {
      ...scene.materials,
      coated: {
        type: 'metallicRoughness',
        ior: 0,
        baseColorTexture: { texture: 'bark', uvSet: 1, offset: [0.5, 0], rotation: 30, scale: [2, 2] },
        normalTexture: { texture: 'leaf.png', normalScale: 0.5 },
        clearcoat: { roughness: 0.1, weightTexture: 'bark' },
        anisotropy: { texture: 'bumps/grain.webp' },
        specularLobe: { color: [1, 0.5, 0.5] },
        transmission: { weight: 0.5 },
        volume: { thickness: 2 },
        diffuseTransmission: {},
        sheen: {},
        iridescence: { ior: 1.5 },
        alphaMode: 'mask',
        alphaCutoff: 0.25,
        opacity: 0.75,
        doubleSided: false,
        emissionStrength: 4,
        dispersion: 0.1,
      },
    },
    shapes: {
      ...scene.shapes,
      parts: {
        type: 'mesh',
        mesh: 'parts/bolt.stl',
        material: 'clay',
        node: 'arm',
        skin: 'bones',
        instances: [[1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0], { translation: [1, 2, 3], rotation: [0, 90, 0] }],
      },
    },
    lights: {
      ...scene.lights,
      spot: { type: 'spot', position: [0, 0, 0], direction: [0, -1, 0], intensity: 9, node: 'arm' },
    },
    animation: [
      ...scene.animation,
      {
        target: '/nodes/stand/translation/1',
        keys: [
          { time: 0, value: 1 },
          { time: 1, value: 2 },
        ],
      },
    ],
  };
}
