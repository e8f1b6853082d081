/** What is on show → files. */
import type { Scene, ShownFilm } from 'mirrorball';
import { filmToSrgb, fromInterleaved, writeExr } from 'mirrorball/picture-files';
import { type OnExportProgress, planGlb, planMitsuba, zippedPlan } from 'mirrorball/scene-export';
import type { SavingJob, Written } from './job.ts';

/** Rejects with an Error that says why, when the format cannot hold it at all. */
export async function written(job: SavingJob, onProgress?: OnExportProgress): Promise<Written> {
  switch (job.as) {
    case 'png':
      return { ending: '.png', blob: await png(job.film, job.exposure, job.toneMapping), report: [] };
    case 'exr':
      return { ending: '.exr', blob: blobOf([exr(job.film)]), report: [] };
    case 'glb': {
      const { name, scene } = job;
      const { files, report } = planGlb(scene, { name, onProgress });
      return { ending: '.glb', blob: blobOf(files.get(`${name}.glb`)!()), report };
    }
    case 'mitsuba': {
      const { name, scene, time, width, height } = job;
      const plan = planMitsuba(scene, { name, time, width, height });
      return { ending: '.zip', blob: blobOf(zippedPlan(plan, onProgress)), report: plan.report };
    }
  }
}

const blobOf = (pieces: readonly Uint8Array[]): Blob => new Blob([...pieces] as Uint8Array<ArrayBuffer>[]);

/** As it is seen: with exposure, tone mapping and the curve of screens. */
async function png(film: ShownFilm, exposure: number, toneMapping: Scene['render']['toneMapping']): Promise<Blob> {
  const canvas = new OffscreenCanvas(film.width, film.height);
  const picture = new ImageData(filmToSrgb(film.pixels, exposure, toneMapping), film.width, film.height);
  canvas.getContext('2d')!.putImageData(picture, 0, 0);
  return canvas.convertToBlob({ type: 'image/png' });
}

/** Linear light as it was traced, or the values of another view. */
const exr = ({ width, height, pixels }: ShownFilm): Uint8Array<ArrayBuffer> =>
  writeExr(fromInterleaved(width, height, ['R', 'G', 'B'], pixels, 4));
