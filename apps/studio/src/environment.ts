/** The light around the scene, chosen beside what the scene itself has. */
import { batch, computed, effect, signal } from '@preact/signals';
import { type EnvironmentMap, type Scene, type Sky, studioSky } from 'mirrorball';
import { changeScene } from './actions.ts';
import { shown } from './state.ts';

/** `scene`: its own. `file`: a picture that somebody has opened. */
export type EnvironmentKind = 'scene' | 'studio' | 'sky' | 'file';

export const environmentKind = signal<EnvironmentKind>('scene');
/** Degrees about the vertical. */
export const environmentTurn = signal(0);
/** Factor on its light. */
export const environmentStrength = signal(1);
/** The picture that was opened last. */
export const skyFile = signal<{ readonly name: string; readonly map: EnvironmentMap } | null>(null);

/** Whether there is a picture of all around, which can be turned. */
export const hasPicture = computed(() => chosenSky().map !== undefined);

/** A clear day, as bright as a studio. */
const PLAIN: Sky = { horizon: [0.9, 0.95, 1], zenith: [0.35, 0.55, 0.95] };
let studio: Sky | null = null;

function chosenSky(): Sky {
  const own = shown.value?.original.sky ?? PLAIN;
  const file = skyFile.value;
  switch (environmentKind.value) {
    case 'studio':
      return (studio ??= studioSky());
    case 'sky':
      return PLAIN;
    case 'file':
      return file ? { ...(studio ??= studioSky()), map: file.map } : own;
    case 'scene':
      return own;
  }
}

function apply(): void {
  const sky = chosenSky();
  const [strength, turn] = [environmentStrength.peek(), environmentTurn.peek()];
  const times = (color: Sky['horizon']) => color.map((x) => x * strength) as unknown as Sky['horizon'];
  const next: Sky =
    sky.map === undefined
      ? { ...sky, horizon: times(sky.horizon), zenith: times(sky.zenith) }
      : { ...sky, scale: (sky.scale ?? 1) * strength, rotation: (((sky.rotation ?? 0) + turn + 540) % 360) - 180 };
  changeScene({ sky: next });
}

let choiceFor: Scene | null = null;

/** A model that is opened stands in the light that was chosen for the one before; the page's own scenes come with theirs. */
export function followScene(): void {
  effect(() => {
    const now = shown.value;
    if (!now || now.original === choiceFor) return;
    choiceFor = now.original;
    const chosen = [environmentKind.peek(), environmentStrength.peek(), environmentTurn.peek()];
    if (chosen.join() === 'scene,1,0') return;
    if (now.id === 'file') queueMicrotask(apply);
    else
      batch(() => {
        environmentKind.value = 'scene';
        environmentStrength.value = 1;
        environmentTurn.value = 0;
      });
  });
}

export function chooseEnvironment(kind: EnvironmentKind): void {
  environmentKind.value = kind;
  apply();
}

export function turnEnvironment(degrees: number): void {
  environmentTurn.value = degrees;
  apply();
}

export function strengthenEnvironment(factor: number): void {
  environmentStrength.value = factor;
  apply();
}

export function takeSkyFile(name: string, map: EnvironmentMap): void {
  skyFile.value = { name, map };
  chooseEnvironment('file');
}
