/** What is on show → files. Much code, which a page needs only when somebody saves: it comes with the first file. */
import type { Scene, ShownFilm } from 'mirrorball';
import { filmToSrgb, fromInterleaved, writeExr } from 'mirrorball/picture-files';
import { type ExportEntry, writeGlb, writeMitsuba, zipped } from 'mirrorball/scene-export';

export type SavedAs = 'png' | 'exr' | 'glb' | 'mitsuba';

/** What a file is made of. `film` is asked for by pictures only; they have no more than can be seen beside the panel. */
export interface OnShow {
  readonly scene: Scene;
  readonly time: number;
  readonly width: number;
  readonly height: number;
  readonly exposure: number;
  readonly toneMapping: Scene['render']['toneMapping'];
  film(): Promise<ShownFilm>;
}

export interface Written {
  /** Its ending, such as ".png". */
  readonly ending: string;
  readonly blob: Blob;
  /** What the format lacks. */
  readonly report: readonly ExportEntry[];
}

/** Rejects with an Error that says why, when the format cannot hold it at all. */
export async function written(as: SavedAs, name: string, shown: OnShow): Promise<Written> {
  switch (as) {
    case 'png':
      return { ending: '.png', blob: await png(await shown.film(), shown), report: [] };
    case 'exr':
      return { ending: '.exr', blob: new Blob([exr(await shown.film())]), report: [] };
    case 'glb': {
      const { files, report } = writeGlb(shown.scene, { name });
      return { ending: '.glb', blob: blobOf(files[`${name}.glb`]!), report };
    }
    case 'mitsuba': {
      const { time, width, height } = shown;
      const { files, report } = writeMitsuba(shown.scene, { name, time, width, height });
      return { ending: '.zip', blob: blobOf(zipped(files)), report };
    }
  }
}

const blobOf = (bytes: Uint8Array): Blob => new Blob([bytes as Uint8Array<ArrayBuffer>]);

/** As it is seen: with exposure, tone mapping and the curve of screens. */
async function png(film: ShownFilm, { exposure, toneMapping }: OnShow): Promise<Blob> {
  const canvas = new OffscreenCanvas(film.width, film.height);
  const picture = new ImageData(filmToSrgb(film.pixels, exposure, toneMapping), film.width, film.height);
  canvas.getContext('2d')!.putImageData(picture, 0, 0);
  return canvas.convertToBlob({ type: 'image/png' });
}

/** Linear light as it was traced, or the values of another view. */
const exr = ({ width, height, pixels }: ShownFilm): Uint8Array<ArrayBuffer> =>
  writeExr(fromInterleaved(width, height, ['R', 'G', 'B'], pixels, 4));
