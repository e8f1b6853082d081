/**
 * A picture of a scene on the CPU within some hundredths of a second: what the camera sees first, lit by the whole sky without shadows. It
 * stands in while the path tracer's program is being compiled, and is no more than that: no mirrors, no glass, no lamps' light.
 */
import type { PackedGeometry } from '../packed-scene/pack-geometry.ts';
import { cameraFrame, rayThrough } from '../reference/camera.ts';
import { intersectBox, intersectPlane, intersectQuad, intersectSphere, outwardNormal } from '../reference/intersect.ts';
import { type PreparedAnalytic, prepareScene } from '../reference/prepare.ts';
import type { Ray } from '../reference/ray.ts';
import type { Framing } from '../renderer-types.ts';
import { isDeformable } from '../scene/deform.ts';
import { emissionOf, lampsAsShapes } from '../scene/lamps.ts';
import type { Mesh } from '../scene/mesh.ts';
import type { Camera, Color, Material, Scene, Shape, Vec3 } from '../scene/scene.ts';
import { addScaled, dot, negate, normalize, subtract } from '../scene/vec3.ts';
import { GeometryWalk } from './geometry-walk.ts';
import { type SketchLight, sketchLight } from './sketch-light.ts';
import { type SketchTexture, sketchTexture } from './sketch-texture.ts';

export interface SketchView {
  /** It stands still: as it is at one time, all but meshes put into the world. */
  readonly scene: Scene;
  /** Of the scene, relative to the camera's eye. */
  readonly geometry: PackedGeometry;
  /** Names of shapes, lamps among them, by row of the scene table. */
  readonly shapeNames: readonly string[];
  readonly camera: Camera;
  readonly framing: Framing | null;
  readonly width: number;
  readonly height: number;
}

/** A light at the eye, for scenes in the dark. */
const EYE_LIGHT = 0.8;

/** Fills RGBA pixels, row 0 first, and pauses after each row. */
export function* sketchInSteps(view: SketchView, pixels: Float32Array): Generator<void, void, void> {
  const { width, height, camera } = view;
  const frame = cameraFrame(camera, width, height, view.framing);
  const tracer = new SketchTracer(view);
  for (let j = 0; j < height; j++) {
    for (let i = 0; i < width; i++) {
      const color = tracer.colorAlong(rayThrough(frame, i + 0.5, j + 0.5, width, height));
      pixels.set([color[0], color[1], color[2], 1], 4 * (j * width + i));
    }
    yield;
  }
}

class SketchTracer {
  readonly #eye: Vec3;
  readonly #light: SketchLight & { readonly isDark: boolean };
  readonly #analytic: readonly PreparedAnalytic[];
  readonly #walk: GeometryWalk;
  /** By row of the scene table. */
  readonly #rows: readonly { readonly material: Material; readonly mesh: Mesh | null; readonly texture: SketchTexture | null }[]; // biome-ignore format: one type

  constructor({ scene, camera, geometry, shapeNames }: SketchView) {
    this.#eye = camera.eye;
    this.#light = sketchLight(scene.sky);
    const lamps = lampsAsShapes(scene).scene;
    const shapes = Object.entries(lamps.shapes) as [string, Shape][];
    const analytic = Object.fromEntries(shapes.filter(([, { type }]) => type !== 'mesh'));
    const prepared = prepareScene({ ...lamps, shapes: analytic });
    this.#analytic = [...prepared.spheres, ...prepared.boxes, ...prepared.planes, ...prepared.quads];
    this.#walk = new GeometryWalk(geometry);
    this.#rows = shapeNames.map((name) => {
      const shape = lamps.shapes[name]!;
      const mesh = shape.type === 'mesh' ? (lamps.meshes?.[shape.mesh]?.data ?? null) : null;
      const material = lamps.materials[shape.material]!;
      return { material, mesh, texture: mesh && sketchTexture(scene, material, mesh) };
    });
  }

  colorAlong(ray: Ray): Color {
    let t = Infinity;
    let met: PreparedAnalytic | null = null;
    for (const shape of this.#analytic) {
      const distance = intersect(shape, ray);
      if (distance < t) [t, met] = [distance, shape];
    }
    if (this.#walk.closest(subtract(ray.origin, this.#eye), ray.direction, t)) return this.#meshColor(ray);
    return met
      ? this.#shade(met.material, [1, 1, 1], outwardNormal(met, ray, t), ray)
      : this.#light.background(ray.direction);
  }

  #meshColor(ray: Ray): Color {
    const { row, mesh: packed, place, u, v } = this.#walk;
    const { material, mesh, texture } = this.#rows[row]!;
    const first = 3 * packed!.order[place]!;
    const { indices, normals, colors } = mesh!;
    const corners = [indices[first]!, indices[first + 1]!, indices[first + 2]!] as const;
    const weights = [1 - u - v, u, v] as const;
    const at = (numbers: Float32Array, stride: number): Vec3 =>
      [0, 1, 2].map((c) => corners.reduce((sum, vertex, k) => sum + weights[k]! * numbers[stride * vertex + c]!, 0)) as unknown as Vec3; // biome-ignore format: one sum
    // What bends has other normals than its mesh.
    const own = normals && !isDeformable(mesh!) ? at(normals, 3) : this.#walk.triangleNormal();
    const tint: Color = colors ? at(colors, 4) : [1, 1, 1];
    const texel = texture?.(corners, weights) ?? [1, 1, 1];
    return this.#shade(
      material,
      [tint[0] * texel[0], tint[1] * texel[1], tint[2] * texel[2]],
      this.#walk.toWorld(own),
      ray,
    );
  }

  #shade(material: Material, tint: Color, outward: Vec3, { direction }: Ray): Color {
    const emission = emissionOf(material);
    if (Math.max(...emission) > 0) return emission;
    const normal = normalize(dot(outward, direction) > 0 ? negate(outward) : outward);
    const eyeLight = this.#light.isDark ? -EYE_LIGHT * dot(normal, direction) : 0;
    const light = this.#light.reflected(normal);
    // Mirrors and glass show what is around, of which the sky is most.
    const shiny = material.type === 'dielectric' || material.reflectivity > 0.5 || material.type === 'conductor';
    const sky = shiny ? this.#light.background(addScaled(direction, normal, -2 * dot(direction, normal))) : null;
    return material.baseColor.map((x, c) => x * tint[c]! * ((sky ? (sky[c]! + light[c]!) / 2 : light[c]!) + eyeLight)) as unknown as Color; // biome-ignore format: one product
  }
}

function intersect(shape: PreparedAnalytic, ray: Ray): number {
  if (shape.type === 'sphere') return intersectSphere(shape, ray);
  if (shape.type === 'box') return intersectBox(shape, ray);
  return shape.type === 'plane' ? intersectPlane(shape, ray) : intersectQuad(shape, ray);
}
