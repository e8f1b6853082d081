import * as actions from './actions.ts';
import { sceneIds } from './built-in-scenes.ts';
import { type HeldMove, holdMove, releaseMove, stopMotion } from './camera-motion.ts';
import { focusHere } from './focus.ts';
import { helpOpen, panelOpen } from './state.ts';

/** The keyboard. Keys that a control uses itself stay with the control. */

type Press = Pick<KeyboardEvent, 'key' | 'code' | 'shiftKey' | 'ctrlKey' | 'metaKey' | 'altKey'>;

const once: Readonly<Record<string, () => void>> = {
  ' ': actions.togglePlaying,
  '.': actions.stepTime,
  '[': () => actions.changeReflections(-1),
  ']': () => actions.changeReflections(1),
  c: actions.nextComparison,
  f: actions.frameView,
  x: () => void actions.toggleFullScreen(),
  o: focusHere,
  r: actions.resetView,
  p: () => (panelOpen.value = !panelOpen.peek()),
  h: () => (helpOpen.value = !helpOpen.peek()),
  '?': () => (helpOpen.value = !helpOpen.peek()),
};

const arrows: Readonly<Record<string, readonly [HeldMove, HeldMove]>> = {
  ArrowLeft: ['left', 'panLeft'],
  ArrowRight: ['right', 'panRight'],
  ArrowUp: ['up', 'panUp'],
  ArrowDown: ['down', 'panDown'],
};
const dollyKeys: Readonly<Record<string, HeldMove>> = { '+': 'closer', '=': 'closer', '-': 'farther', _: 'farther' };
/** By place on the keyboard, as W A S D is meant. */
const letters: Readonly<Record<string, HeldMove>> = { KeyW: 'closer', KeyS: 'farther', KeyA: 'left', KeyD: 'right' };

/** The move of the view that a key stands for, if any. */
export function heldMoveOf(press: Press): HeldMove | null {
  return arrows[press.key]?.[press.shiftKey ? 1 : 0] ?? dollyKeys[press.key] ?? letters[press.code] ?? null;
}

/** Whether the focused element needs this key for itself. */
export function belongsToControl(
  press: Press,
  element: { tagName: string; type?: string; role?: string | null },
): boolean {
  const { tagName, type } = element;
  if (tagName === 'TEXTAREA' || tagName === 'SELECT') return true;
  if (tagName === 'INPUT' && type !== 'range' && type !== 'radio' && type !== 'checkbox') return true;
  const moves = press.key.startsWith('Arrow') || press.key === 'Home' || press.key === 'End';
  if (tagName === 'INPUT' || element.role === 'separator') return moves || press.key === ' ';
  return (tagName === 'BUTTON' || tagName === 'SUMMARY' || tagName === 'A') && press.key === ' ';
}

function pressed(event: KeyboardEvent): void {
  // AltGr, which types [ and ] on some keyboards, comes as Ctrl and Alt.
  const command = event.metaKey || ((event.ctrlKey || event.altKey) && !event.getModifierState('AltGraph'));
  if (command || event.isComposing) return;
  const element = event.target instanceof HTMLElement ? event.target : document.body;
  const role = element.getAttribute('role');
  if (element.isContentEditable) return;
  if (belongsToControl(event, { tagName: element.tagName, type: (element as HTMLInputElement).type, role })) return;
  if (document.querySelector('dialog[open]')) {
    if (helpOpen.peek() && (event.key === 'h' || event.key === '?')) helpOpen.value = false;
    return;
  }
  const move = heldMoveOf(event);
  const scene = sceneIds[Number(event.key) - 1];
  const act = once[event.key.toLowerCase()];
  if (move) holdMove(move);
  else if (event.repeat && event.key !== '[' && event.key !== ']' && event.key !== '.') return;
  else if (scene !== undefined) actions.chooseScene(scene);
  else if (act) act();
  else return;
  event.preventDefault();
}

export function followKeys(): void {
  addEventListener('keydown', pressed);
  addEventListener('keyup', (event) => {
    // Shift may have been let go before the arrow, so both of its moves end.
    for (const move of arrows[event.key] ?? []) releaseMove(move);
    const move = heldMoveOf(event);
    if (move) releaseMove(move);
  });
  addEventListener('blur', stopMotion);
}
