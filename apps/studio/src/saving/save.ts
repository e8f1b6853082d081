/** Saving what is on show. */
import { signal } from '@preact/signals';
import type { Renderer, Scene, ShownFilm } from 'mirrorball';
import { readyToReport, sceneName } from '../i18n.ts';
import { dismiss, notify, reasonOf } from '../notices.ts';
import { exposure, openShares, playing, renderer, shown, toneMapping, viewMoved } from '../state.ts';
import { loadWritten } from './load-written.ts';
import type { OnShow, SavedAs } from './written.ts';

/** What is being saved. */
export const saving = signal<SavedAs | null>(null);

/** A picture of what moves gets so many samples, as far as there is time, milliseconds. */
const SAMPLES = 16;
const PATIENCE_MS = 2000;

export async function save(as: SavedAs): Promise<void> {
  const current = renderer.peek();
  const now = shown.peek();
  if (saving.peek() !== null || !current?.scene || !now) return;
  saving.value = as;
  dismiss('save');
  try {
    const { written } = await loadWritten();
    const name = fileName(now.fileName ?? sceneName(now.id, now.scene.name));
    const { ending, blob, report } = await written(as, name, onShow(current, current.scene));
    await readyToReport();
    download(`${name}${ending}`, blob);
    if (report.length > 0) notify('save', (t) => t.saved(`${name}${ending}`, report));
  } catch (error) {
    notify('save', (t) => t.notSaved(reasonOf(error)));
  } finally {
    saving.value = null;
  }
}

function onShow(current: Renderer, scene: Scene): OnShow {
  const { time, camera, canvas } = current;
  const [across, down] = openShares.peek();
  return {
    // A view that was moved belongs to no node.
    scene: viewMoved.peek() ? { ...scene, camera } : scene,
    time,
    width: Math.max(Math.round(canvas.width * across), 1),
    height: Math.max(Math.round(canvas.height * down), 1),
    exposure: exposure.peek(),
    toneMapping: toneMapping.peek(),
    film: async () => uncovered(await filmOf(current), across, down),
  };
}

/** Of all pixels: what plays rests for as long as that takes. */
async function filmOf(current: Renderer): Promise<ShownFilm> {
  if (current.backend === 'cpu') return current.readFilm();
  const played = playing.peek();
  playing.value = false;
  try {
    const end = performance.now() + PATIENCE_MS;
    do await current.render();
    while (current.stats.samples < SAMPLES && performance.now() < end);
    return await current.readFilm();
  } finally {
    playing.value = played;
  }
}

/** The part of it that is seen beside the panel, in whose middle the scene stands. */
export function uncovered(film: ShownFilm, across: number, down: number): ShownFilm {
  const width = Math.max(Math.round(film.width * across), 1);
  const height = Math.max(Math.round(film.height * down), 1);
  if (width === film.width && height === film.height) return film;
  const pixels = new Float32Array(width * height * 4);
  for (let y = 0; y < height; y++)
    pixels.set(film.pixels.subarray(y * film.width * 4, (y * film.width + width) * 4), y * width * 4);
  return { ...film, width, height, pixels };
}

/** Of a file without its ending, and without what no system takes in a name. */
export const fileName = (name: string): string =>
  name
    .replace(/\.[^.]{1,8}$/, '')
    // biome-ignore lint/suspicious/noControlCharactersInRegex: they are what must not be there
    .replace(/[\u0000-\u001f\u007f<>:"/\\|?*]+/g, ' ')
    .replace(/^[. ]+|[. ]+$/g, '')
    .slice(0, 100) || 'mirrorball';

function download(name: string, blob: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // Safari begins to read only some time after the click.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
