import { batch } from '@preact/signals';
import { dictionary, sceneName } from './i18n.ts';
import { pageHeight, pageWidth, renderer, shown, stageHeight, stageWidth } from './state.ts';

/**
 * The stage: the element that the picture fills. A canvas belongs to one backend for life, so another backend gets a
 * fresh canvas under the old one, which leaves when the new picture is there.
 */
const stage = (): HTMLElement => document.getElementById('stage')!;

let fixedSize: number | null = null;

function pixelSize(): { width: number; height: number } {
  if (fixedSize !== null) return { width: fixedSize, height: fixedSize };
  const box = stage().getBoundingClientRect();
  const ratio = devicePixelRatio || 1;
  return { width: Math.max(Math.round(box.width * ratio), 1), height: Math.max(Math.round(box.height * ratio), 1) };
}

export function createCanvas(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, pixelSize());
  canvas.tabIndex = 0;
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', describePicture());
  const current = stage().querySelector('canvas');
  stage().insertBefore(canvas, current);
  return canvas;
}

export function describePicture(): string {
  const at = shown.value;
  return dictionary.value.pictureOf(at ? sceneName(at.id, at.scene.name) : '…');
}

function measure(): void {
  batch(() => {
    pageWidth.value = innerWidth;
    pageHeight.value = innerHeight;
    stageWidth.value = stage().clientWidth;
    stageHeight.value = stage().clientHeight;
  });
}

function fit(): void {
  measure();
  const { width, height } = pixelSize();
  let changed = false;
  for (const canvas of stage().querySelectorAll('canvas')) {
    if (canvas.width === width && canvas.height === height) continue;
    Object.assign(canvas, { width, height });
    changed = true;
  }
  // A resized canvas is blank: draw before the browser paints, lest it flicker.
  if (changed && renderer.value?.running) renderer.value.render().catch(() => {});
}

/** Keeps the canvases as large as the stage in device pixels, or at a fixed size at the top left. */
export function followStageSize(size: number | null): void {
  fixedSize = size;
  if (size !== null) Object.assign(stage().style, { inset: '0 auto auto 0', width: `${size}px`, height: `${size}px` });
  measure();
  addEventListener('resize', measure);
  new ResizeObserver(fit).observe(stage());
  watchPixelRatio();
}

function watchPixelRatio(): void {
  const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
  const changed = (): void => {
    fit();
    watchPixelRatio();
  };
  query.addEventListener('change', changed, { once: true });
}
