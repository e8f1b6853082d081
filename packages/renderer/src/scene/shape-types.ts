import type { ShapeType } from './scene.ts';

/** All types of shapes. */
export const SHAPE_TYPES = ['sphere', 'box', 'plane', 'quad', 'mesh'] as const satisfies readonly ShapeType[];
