import { MATTE } from '../scene/materials.ts';
import type { Mesh } from '../scene/mesh.ts';
import type { Material, MeshShape, Scene } from '../scene/scene.ts';
import { boundsAt } from '../scene/scene-bounds.ts';
import { isParsedScene, trustScene } from './trusted-scenes.ts';

/** How far the floor reaches, in half diagonals of what stands on it. */
const REACH = 12;

/** Plain grey, of a type that models have: a scene with it needs no other program. */
const FLOOR: Material = { ...MATTE, type: 'metallicRoughness', baseColor: [0.4, 0.4, 0.4], roughness: 0.9 };

/**
 * The scene on a plain round floor, which shows where things stand by the shadows that it catches. It lies just below the lowest point that
 * the scene has at time 0. Itself when nothing has an end. Throws a TypeError for what is no scene of this library.
 */
export function withGround(scene: Scene): Scene {
  if (!isParsedScene(scene))
    throw new TypeError('A floor is laid under a scene that parseScene or importGltf has made.');
  const bounds = boundsAt(scene, 0);
  if (bounds === null) return scene;
  const { min, max } = bounds;
  const radius = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]) / 2;
  if (!(radius > 0)) return scene;
  // What lies on it exactly must not fight with it for every ray.
  const height = min[1] - radius * 1e-4;
  const mesh: Mesh = disc((min[0] + max[0]) / 2, height, (min[2] + max[2]) / 2, REACH * radius);
  const [meshName, material, name] = [scene.meshes ?? {}, scene.materials, scene.shapes].map((taken) => unused('ground', taken)); // biome-ignore format: three names
  const shape: MeshShape = {
    type: 'mesh',
    mesh: meshName!,
    material: material!,
    translation: [0, 0, 0],
    rotation: [0, 0, 0],
    scale: [1, 1, 1],
  };
  const whole: Scene = Object.freeze({
    ...scene,
    meshes: added(scene.meshes, meshName!, Object.freeze({ data: mesh })),
    materials: added(scene.materials, material!, FLOOR),
    shapes: added(scene.shapes, name!, Object.freeze(shape)),
  });
  trustScene(whole);
  return whole;
}

const added = <Thing>(things: Readonly<Record<string, Thing>> | undefined, name: string, thing: Thing) =>
  Object.freeze(Object.assign(Object.create(null), things, { [name]: thing })) as Readonly<Record<string, Thing>>;

/** Seen from above counter-clockwise. */
function disc(x: number, y: number, z: number, radius: number): Mesh {
  const corners = 64;
  const positions = new Float32Array(3 * (corners + 1));
  positions.set([x, y, z]);
  const indices = new Uint32Array(3 * corners);
  for (let i = 0; i < corners; i++) {
    const angle = (2 * Math.PI * i) / corners;
    positions.set([x + radius * Math.cos(angle), y, z - radius * Math.sin(angle)], 3 * (i + 1));
    indices.set([0, i + 1, ((i + 1) % corners) + 1], 3 * i);
  }
  return { positions, indices };
}

function unused(name: string, taken: object): string {
  let free = name;
  for (let n = 2; free in taken; n++) free = `${name} ${n}`;
  return free;
}
