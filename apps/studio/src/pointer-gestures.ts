import { pushMove } from './camera-motion.ts';
import { focusAt, pointAt } from './focus.ts';
import { renderer } from './state.ts';

/** Mouse, touch and pen on the picture: drag to orbit, right drag or two fingers to pan, wheel or pinch to dolly. */

/** Degrees for a drag over the whole height of the picture. */
const ORBIT_SPAN = 180;
/** A press that moves less is a click and no drag, pixels. */
const CLICK_SLACK = 4;

interface Point {
  readonly x: number;
  readonly y: number;
}

const between = (a: Point, b: Point): Point => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
const distance = (a: Point, b: Point): number => Math.hypot(a.x - b.x, a.y - b.y);

/** What two fingers do: the middle between them pans, their distance dollies. */
export function pinch(before: readonly [Point, Point], after: readonly [Point, Point], height: number) {
  const [from, to] = [between(...before), between(...after)];
  const ratio = Math.max(distance(...before), 1) / Math.max(distance(...after), 1);
  return { panX: -(to.x - from.x) / height, panY: (to.y - from.y) / height, dolly: Math.log(ratio) };
}

/** What the wheel does: a pinch on a touch pad arrives as a wheel with Ctrl and small steps. */
export function wheelDolly(event: Pick<WheelEvent, 'deltaY' | 'deltaMode' | 'ctrlKey'>): number {
  const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
  return Math.min(Math.max(pixels * (event.ctrlKey ? 0.01 : 0.0015), -0.5), 0.5);
}

/** Where on the stage, in shares of its width and height. */
function placeOn(stage: HTMLElement, { clientX, clientY }: PointerEvent): [x: number, y: number] {
  const { left, top, width, height } = stage.getBoundingClientRect();
  return [(clientX - left) / width, (clientY - top) / height];
}

export function followPointers(stage: HTMLElement): void {
  const pointers = new Map<number, Point>();
  let panning = false;
  /** Where the only finger or button went down, as long as it may become a click. */
  let pressed: Point | null = null;

  stage.addEventListener('pointerdown', (event) => {
    if (pointers.size >= 2) return;
    panning = event.pointerType === 'mouse' && (event.button !== 0 || event.shiftKey);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    pressed = pointers.size === 1 && !panning ? { x: event.clientX, y: event.clientY } : null;
    stage.setPointerCapture(event.pointerId);
    stage.dataset.dragging = panning ? 'pan' : 'orbit';
  });

  stage.addEventListener('pointermove', (event) => {
    pointAt(placeOn(stage, event));
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const after: Point = { x: event.clientX, y: event.clientY };
    if (pressed && distance(pressed, after) > CLICK_SLACK) pressed = null;
    const height = stage.clientHeight;
    const [dx, dy] = [(after.x - before.x) / height, (after.y - before.y) / height];
    // So much of the page is as high as the camera's field of view, which is what shifts are counted in.
    const viewHeight = height * (renderer.peek()?.settings.framing?.height ?? 1);
    const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) pushMove(pinch([before, other], [after, other], viewHeight));
    else if (panning) pushMove({ panX: (-dx * height) / viewHeight, panY: (dy * height) / viewHeight });
    else pushMove({ yaw: -dx * ORBIT_SPAN, pitch: dy * ORBIT_SPAN });
    pointers.set(event.pointerId, after);
  });

  const lift = (event: PointerEvent): void => {
    pointers.delete(event.pointerId);
    if (pointers.size === 0) delete stage.dataset.dragging;
  };
  stage.addEventListener('pointerup', (event) => {
    if (pressed && pointers.has(event.pointerId)) focusAt(placeOn(stage, event));
    pressed = null;
    lift(event);
  });
  stage.addEventListener('pointerleave', () => pointAt(null));
  stage.addEventListener('pointercancel', lift);
  stage.addEventListener('contextmenu', (event) => event.preventDefault());
  stage.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      pushMove({ dolly: wheelDolly(event) });
    },
    { passive: false },
  );
}
