/** What can be shown of a scene: the picture, or one thing that is known of each pixel. docs/aov.md says what they are. */
import type { AovContent } from '../integrator/aov/aov.ts';

/** Where a view is taken from, and how its numbers become colours (`AovView.kind`). */
export interface AovViewSource {
  readonly content: AovContent;
  /** Of the film. */
  readonly layer: 0 | 1;
  readonly kind: 'colour' | 'normal' | 'depth' | 'place' | 'number';
}

export const AOV_VIEWS = {
  albedo: { content: 'features', layer: 0, kind: 'colour' },
  normal: { content: 'features', layer: 1, kind: 'normal' },
  'geometric-normal': { content: 'data', layer: 1, kind: 'normal' },
  depth: { content: 'data', layer: 0, kind: 'depth' },
  position: { content: 'data', layer: 0, kind: 'place' },
  'primitive-id': { content: 'data', layer: 0, kind: 'number' },
  'material-id': { content: 'data', layer: 0, kind: 'number' },
} as const satisfies Readonly<Record<string, AovViewSource>>;

export type AovViewName = keyof typeof AOV_VIEWS;
export type ViewName = 'picture' | AovViewName;
export const VIEW_NAMES = ['picture', ...Object.keys(AOV_VIEWS)] as readonly ViewName[];
