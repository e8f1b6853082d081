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
