/** What of an opened model can be chosen: its view, its motion, its materials, and a floor under it. */
import { computed, signal } from '@preact/signals';
import type { Renderer, Scene } from 'mirrorball';
import { changeScene, replaceScene } from './actions.ts';
import { loadSceneTools } from './load-scene-tools.ts';
import { notify, reasonOf } from './notices.ts';
import type * as SceneTools from './scene-tools.ts';
import type { Shown } from './state.ts';
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

/** The tools come first: what is then read of the scene on show is so when it is changed. */
async function change(
  make: (tools: typeof SceneTools, now: Shown, current: Renderer, scene: Scene) => void,
): Promise<void> {
  try {
    const tools = await loadSceneTools();
    const [now, current] = [shown.peek(), renderer.peek()];
    if (now && current?.scene) make(tools, now, current, current.scene);
  } catch (error) {
    notify('file', (t) => t.noticeSceneFailed(reasonOf(error)));
  }
}

export function chooseCamera(name: string | null): Promise<void> {
  remember({ camera: name });
  return change(({ withCamera, withParts }, now, current, scene) => {
    const { camera } = now.original;
    const next = name === null ? withParts(scene, { camera }) : withCamera(scene, name);
    replaceScene(current, { ...now, scene: next }, { camera });
  });
}

export function chooseClip(name: string | null): Promise<void> {
  return changeScene({ clip: name });
}

export function chooseVariant(name: string | null): Promise<void> {
  remember({ variant: name });
  return rebuild();
}

export function showGround(ground: boolean): Promise<void> {
  remember({ ground });
  return rebuild();
}

/** Shapes change: they are made anew of the original's, and the rest stays as it was chosen. */
function rebuild(): Promise<void> {
  return change(({ withGround, withParts }, now, current, { camera, sky, render, clip }) => {
    const base = hasGround.peek() ? withGround(now.original) : now.original;
    const variant = chosenVariant.peek();
    const scene = withParts(base, { camera, sky, render, clip: clip ?? null, ...(variant !== null && { variant }) });
    replaceScene(current, { ...now, scene });
  });
}
