/** Saving what is on show. */
import { signal } from '@preact/signals';
import type { Renderer, Scene, ShownFilm } from 'mirrorball';
import { readyToReport, sceneName } from '../i18n.ts';
import { dismiss, notify, reasonOf } from '../notices.ts';
import { exposure, openShares, playing, renderer, shown, toneMapping, viewMoved } from '../state.ts';
import type { SavedAs, SavingJob } from './job.ts';
import { loadWritten } from './load-written.ts';

/** Share of what is being saved that is done; null when nothing is. */
export const saving = signal<number | null>(null);
let current: AbortController | null = null;

export const cancelSaving = (): void => current?.abort();

/** A picture of what moves gets so many samples, as far as there is time, milliseconds. */
const SAMPLES = 16;
const PATIENCE_MS = 2000;

export async function save(as: SavedAs): Promise<void> {
  const drawing = renderer.peek();
  const now = shown.peek();
  if (saving.peek() !== null || !drawing?.scene || !now) return;
  saving.value = 0;
  current = new AbortController();
  const { signal } = current;
  dismiss('save');
  try {
    const { writeInWorker } = await loadWritten();
    const name = fileName(now.fileName ?? sceneName(now.id, now.scene.name));
    const job = await jobFor(
      as,
      name,
      drawing,
      as === 'glb' ? keepingOwnLook(drawing.scene, now.original) : drawing.scene,
    );
    const { ending, blob, report } = await writeInWorker(job, (share) => (saving.value = share), signal);
    await readyToReport();
    download(`${name}${ending}`, blob);
    if (report.length > 0) notify('save', (t) => t.saved(`${name}${ending}`, report));
  } catch (error) {
    if (!signal.aborted) notify('save', (t) => t.notSaved(reasonOf(error)));
  } finally {
    saving.value = null;
  }
}

async function jobFor(as: SavedAs, name: string, drawing: Renderer, scene: Scene): Promise<SavingJob> {
  const { time, camera, canvas } = drawing;
  const [across, down] = openShares.peek();
  if (as === 'png' || as === 'exr') {
    const film = uncovered(await filmOf(drawing), across, down);
    return { as, film, exposure: exposure.peek(), toneMapping: toneMapping.peek() };
  }
  const width = Math.max(Math.round(canvas.width * across), 1);
  const height = Math.max(Math.round(canvas.height * down), 1);
  // A view that was moved belongs to no node.
  return { as, name, scene: viewMoved.peek() ? { ...scene, camera } : scene, time, width, height };
}

/**
 * A model is saved with the materials that are on show. Those of the file, which a variant has replaced, stay in it as one more variant,
 * and also where another variant says nothing.
 */
export function keepingOwnLook(scene: Scene, original: Scene): Scene {
  const replaced = Object.entries(original.shapes).filter(([id, { material }]) => {
    const now = scene.shapes[id]?.material;
    return now !== undefined && now !== material;
  });
  if (replaced.length === 0) return scene;
  const own = Object.fromEntries(replaced.map(([id, { material }]) => [id, material]));
  const variants = Object.entries(scene.variants ?? {}).map(([name, one]) => [name, { ...own, ...one }] as const);
  let name = 'Original';
  while (variants.some(([other]) => other === name)) name += '*';
  return { ...scene, variants: Object.fromEntries([...variants, [name, own]]) as NonNullable<Scene['variants']> };
}

/** Of all pixels: what plays rests for as long as that takes. */
async function filmOf(drawing: Renderer): Promise<ShownFilm> {
  if (drawing.backend === 'cpu') return drawing.readFilm();
  const played = playing.peek();
  playing.value = false;
  try {
    const end = performance.now() + PATIENCE_MS;
    do await drawing.render();
    while (drawing.stats.samples < SAMPLES && performance.now() < end);
    return await drawing.readFilm();
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
