/** What of an opened model can be chosen: its view, its motion, its materials, and a floor under it. */
import { computed, signal } from '@preact/signals';
import { type Scene, withCamera, withGround, withParts } from 'mirrorball';
import { changeScene, replaceScene } from './actions.ts';
import { renderer, shown } from './state.ts';

/** The choice that was made last, and of what; of another scene it counts no more. */
const choice = signal<{ of: Scene; camera?: string | null; variant?: string | null; ground?: boolean } | null>(null);
const mine = computed(() => (choice.value?.of === shown.value?.original ? choice.value : null));

/** Null: the one that shows everything, or the file's own. */
export const chosenCamera = computed(() => mine.value?.camera ?? null);
export const chosenVariant = computed(() => mine.value?.variant ?? null);
export const hasGround = computed(() => mine.value?.ground ?? false);

function remember(change: { camera?: string | null; variant?: string | null; ground?: boolean }): void {
  const of = shown.peek()?.original;
  if (of) choice.value = { ...mine.peek(), ...change, of };
}

export function chooseCamera(name: string | null): void {
  const now = shown.peek();
  const current = renderer.peek();
  if (!now || !current?.scene) return;
  remember({ camera: name });
  if (name === null) changeScene({ camera: now.original.camera });
  else replaceScene(current, { ...now, scene: withCamera(current.scene, name) }, { camera: now.original.camera });
}

export function chooseClip(name: string | null): void {
  changeScene({ clip: name });
}

export function chooseVariant(name: string | null): void {
  remember({ variant: name });
  rebuild();
}

export function showGround(ground: boolean): void {
  remember({ ground });
  rebuild();
}

/** Shapes change: they are made anew of the original's, and the rest stays as it was chosen. */
function rebuild(): void {
  const now = shown.peek();
  const current = renderer.peek();
  if (!now || !current?.scene) return;
  const { camera, sky, render, clip } = current.scene;
  const base = hasGround.peek() ? withGround(now.original) : now.original;
  const variant = chosenVariant.peek();
  const scene = withParts(base, { camera, sky, render, clip: clip ?? null, ...(variant !== null && { variant }) });
  replaceScene(current, { ...now, scene });
}
