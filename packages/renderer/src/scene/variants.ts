import type { MeshShape, Scene, Shape } from './scene.ts';

/** The scene with the materials of one of its variants, or with its own for null. Throws when it has no such variant. */
export function withVariant(scene: Scene, name: string | null): Scene {
  if (name === null) return scene;
  const variant = scene.variants && Object.hasOwn(scene.variants, name) ? scene.variants[name]! : undefined;
  if (variant === undefined) throw new Error(`The scene has no variant "${name}".`);
  const shapes: Record<string, Shape | MeshShape> = Object.assign(Object.create(null), scene.shapes);
  for (const [shape, material] of Object.entries(variant)) {
    const rest = shapes[shape];
    if (rest !== undefined) shapes[shape] = { ...rest, material };
  }
  return { ...scene, shapes: shapes as Scene['shapes'] };
}
