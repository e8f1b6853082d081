import { Zip, ZipDeflate, ZipPassThrough } from 'fflate';
import { type ExportPlan, joined, type OnExportProgress } from './export-plan.ts';

/** Packed already: another time would cost time and win nothing. */
const PACKED = /\.(png|exr|glb)$/;
/** So many bytes are packed between two words about how far it is. */
const SLICE = 2 ** 20;

/** The files in one archive, for whoever can save only one. */
export const zipped = (files: Readonly<Record<string, Uint8Array>>): Uint8Array<ArrayBuffer> =>
  joined(zippedPlan({ files: new Map(Object.entries(files).map(([name, bytes]) => [name, () => [bytes]])) }));

/** The same, each file made and packed by itself; in pieces. */
export function zippedPlan({ files }: Pick<ExportPlan, 'files'>, onProgress?: OnExportProgress): Uint8Array[] {
  const pieces: Uint8Array[] = [];
  const zip = new Zip((error, piece) => {
    if (error) throw error;
    pieces.push(piece);
  });
  let done = 0;
  for (const [name, make] of files) {
    const entry = PACKED.test(name) ? new ZipPassThrough(name) : new ZipDeflate(name, { level: 6 });
    zip.add(entry);
    const content = make();
    const length = content.reduce((sum, bytes) => sum + bytes.length, 0);
    let packed = 0;
    for (const bytes of content)
      for (let at = 0; at < bytes.length; at += SLICE) {
        // What is packed as it stands must not be the scene's own memory.
        entry.push(bytes.slice(at, at + SLICE));
        packed += Math.min(SLICE, bytes.length - at);
        onProgress?.((done + packed / length) / files.size);
      }
    entry.push(new Uint8Array(), true);
    done++;
  }
  zip.end();
  return pieces;
}
