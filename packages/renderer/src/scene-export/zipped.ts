import { zipSync } from 'fflate';

/** The files in one archive, for whoever can save only one. */
export const zipped = (files: Readonly<Record<string, Uint8Array>>): Uint8Array<ArrayBuffer> =>
  zipSync({ ...files }, { level: 6 }) as Uint8Array<ArrayBuffer>;
