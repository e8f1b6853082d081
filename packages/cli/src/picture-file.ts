/** Films as picture files, and pictures for comparing from any file that holds one. */
import { readFile } from 'node:fs/promises';
import { type FilmArea, linearToSrgb, srgbToLinear } from 'mirrorball/headless';
import {
  arrayAsPicture,
  type FloatPicture,
  formatOf,
  fromInterleaved,
  ImageError,
  type MeasuredPicture,
  pickLayer,
  readNpz,
} from 'mirrorball/picture-files';
import { aovChannels, aovFile, aovPicture, aovTexts, holdsLayers, mayBeHalf, type WithAovs } from './aov-pictures.ts';
import type { OutputOptions } from './arguments.ts';
import { CommandError, EXIT, usage } from './exit-codes.ts';
import { regionOf } from './film-identity.ts';
import { type Part, readPart, writePart } from './part-file.ts';
import { assembled } from './regions.ts';
import { renderText } from './render-text.ts';
import { writeAtomically } from './write-atomically.ts';

export const PART = '.part';
export const isPart = (path: string): boolean => path.toLowerCase().endsWith(PART);

/** Refuses names that end in nothing known, before any work. */
export function checkOutputName(path: string): void {
  if (isPart(path)) return;
  try {
    formatOf(path);
  } catch (error) {
    if (error instanceof ImageError) throw usage(`${path}: ${error.message} And ${PART}, to go on later.`);
    throw error;
  }
}

const COLOURS = ['R', 'G', 'B'];

/** A film with its AOVs, if any are wanted. */
export interface FilmToWrite {
  readonly part: Part;
  readonly aovs: WithAovs | null;
}

/** Writes the film in the format of the file's name; gives the files, the picture's first: more than one where AOVs need their own. */
export async function writeFilm(
  path: string,
  part: Part,
  options: OutputOptions,
  aovs: WithAovs | null = null,
): Promise<string[]> {
  if (!isPart(path)) return writePictures(path, [{ part, aovs }], regionOf(part.identity), options);
  await writePart(path, part);
  return [path];
}

/** The same of several films of one picture, each of other pixels, in one file that shows `area` of it. */
export async function writePictures(
  path: string,
  films: readonly FilmToWrite[],
  area: FilmArea,
  options: OutputOptions,
): Promise<string[]> {
  const [{ part, aovs }] = films as [FilmToWrite];
  const exposure = options.exposure ?? part.exposure;
  const parts = films.map((film) => film.part);
  const look = formatOf(path).forScreens ? { exposure } : null;
  const texts = { ...part.texts, Render: renderText(parts, area, look), ...(aovs && aovTexts(aovs)) };
  const together = (pictureOf: (film: FilmToWrite) => FloatPicture): FloatPicture => ({
    ...assembled(
      area,
      films.map((film) => ({ region: regionOf(film.part.identity), picture: pictureOf(film) })),
    ),
    texts,
  });
  if (!aovs || holdsLayers(path)) {
    await writePicture(path, together(withLayers), options, exposure);
    return [path];
  }
  const files = aovs.names.map((name) => ({ name, file: aovFile(path, name) }));
  for (const { name, file } of files)
    await writePicture(
      file,
      together((film) => aovPicture(name, film.part.film, film.aovs!)),
      options,
      // A share of light is no light: it has no exposure.
      name === 'albedo' ? 0 : exposure,
    );
  // Last, so that with it all are there.
  await writePicture(path, together(colours), options, exposure);
  return [path, ...files.map(({ file }) => file)];
}

function colours({ part: { film, identity } }: FilmToWrite): FloatPicture {
  const { width, height } = regionOf(identity);
  return fromInterleaved(width, height, COLOURS, film.mean());
}

function withLayers(film: FilmToWrite): FloatPicture {
  const picture = colours(film);
  const { part, aovs } = film;
  return aovs ? { ...picture, channels: [...picture.channels, ...aovChannels(part.film, aovs)] } : picture;
}

async function writePicture(
  path: string,
  picture: FloatPicture,
  options: OutputOptions,
  exposure: number,
): Promise<void> {
  const format = formatOf(path);
  const channels = format.forScreens
    ? picture.channels.map(({ name, data }) => ({ name, data: forScreen(data, exposure) }))
    : picture.channels;
  try {
    const bits = options.bits === '16' ? 16 : 8;
    const half = options.half === true ? mayBeHalf : false;
    await writeAtomically(path, [format.write({ ...picture, channels }, { half, bits })]);
  } catch (error) {
    if (error instanceof ImageError) throw new CommandError(EXIT.failed, `${path}: ${error.message}`);
    throw error;
  }
}

const forScreen = (values: Float32Array, exposure: number): Float32Array =>
  values.map((value) => linearToSrgb(Math.min(Math.max(value * 2 ** exposure, 0), 1)));

/** Linear colours of a picture, part file, or NPZ of mean, se and mask, with standard errors where they are known. */
export async function readMeasured(path: string): Promise<MeasuredPicture & { readonly mask?: ArrayLike<number> }> {
  if (isPart(path)) return measuredPart(await readPart(path));
  const bytes = await readFile(path).catch((error: Error) => {
    throw usage(`The picture ${path} cannot be read: ${error.message}`);
  });
  try {
    if (path.toLowerCase().endsWith('.npz')) return measuredArrays(bytes);
    const format = formatOf(path);
    const picture = pickLayer(format.read(bytes), '');
    return { mean: format.forScreens ? linear(picture) : picture };
  } catch (error) {
    if (error instanceof ImageError) throw usage(`${path}: ${error.message}`);
    throw error;
  }
}

function linear(picture: FloatPicture): FloatPicture {
  const channels = picture.channels.map(({ name, data }) => ({
    name,
    data: name === 'A' ? data : data.map(srgbToLinear),
  }));
  return { ...picture, channels };
}

function measuredPart({ film, identity }: Part): MeasuredPicture {
  const [, , width, height] = identity.region;
  const errors = film.standardErrors();
  const mean = fromInterleaved(width, height, COLOURS, film.mean());
  return errors ? { mean, standardError: fromInterleaved(width, height, COLOURS, errors) } : { mean };
}

function measuredArrays(bytes: Uint8Array): MeasuredPicture & { readonly mask?: ArrayLike<number> } {
  const arrays = readNpz(bytes);
  const picture = (name: string) => arrayAsPicture(arrays.read(name));
  return {
    mean: picture('mean'),
    ...(arrays.has('se') ? { standardError: picture('se') } : {}),
    ...(arrays.has('mask') ? { mask: Float32Array.from(arrays.read('mask').data, Number) } : {}),
  };
}
