/** Where a picture goes when nobody says so. */
import { basename } from 'node:path';

/** `model.glb` becomes `model.png` in the folder where one is; or, when that is taken, `model-2.png`: only what is named is replaced. */
export function defaultOutput(scene: string, isTaken: (file: string) => boolean): string {
  const name = basename(scene).replace(/(\.scene)?\.[^.]+$/i, '');
  const stem = name === '' || name === '-' ? 'scene' : name;
  for (let n = 1; ; n++) {
    const file = `${stem}${n > 1 ? `-${n}` : ''}.png`;
    if (!isTaken(file)) return file;
  }
}
