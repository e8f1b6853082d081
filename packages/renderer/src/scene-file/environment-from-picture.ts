/** A picture file's content → the sky's map, averaged down where it is larger than maps may be. */
import { type FloatPicture, pickLayer } from '../export/float-picture.ts';
import { ImageError } from '../export/image-error.ts';
import { type EnvironmentMap, MOST_COLUMNS, MOST_RADIANCE, MOST_ROWS } from '../scene/environment.ts';

export interface ReadEnvironment {
  readonly map: EnvironmentMap;
  /** What was changed on the way, as sentences for people. */
  readonly notes: readonly string[];
}

/** Throws an ImageError for what is no radiance. */
export function environmentFromPicture(picture: FloatPicture): ReadEnvironment {
  const { width, height } = picture;
  const { data, negative } = radiances(picture);
  const notes: string[] = [];
  if (negative > 0) notes.push(`${negative} of its numbers are negative, which light is not; they count as 0.`);
  const whole = { width, height, data };
  const shrink = Math.max(width / MOST_COLUMNS, height / MOST_ROWS);
  if (shrink <= 1) return { map: whole, notes };
  const size = [width, height].map((side) => Math.max(Math.floor(side / shrink), 1)) as [number, number];
  notes.push(
    `It has ${width} × ${height} texels and is averaged to ${size[0]} × ${size[1]}, as ${MOST_COLUMNS} × ${MOST_ROWS} are the most that can be used.`,
  );
  return { map: averaged(whole, ...size), notes };
}

/** Red, green and blue of its own layer, or grey as all three. */
function radiances(picture: FloatPicture): { data: Float32Array; negative: number } {
  const { width, height, channels } = pickLayer(picture, '');
  const named = (name: string) => channels.find((channel) => channel.name === name)?.data;
  const grey = named('Y') ?? (channels.length === 1 ? channels[0]!.data : undefined);
  const colours = ['R', 'G', 'B'].map((name) => named(name) ?? grey);
  if (colours.some((channel) => channel === undefined)) {
    const names = picture.channels.map(({ name }) => name).slice(0, 8).join(' '); // biome-ignore format: short
    throw new ImageError('picture of a sky', `the channels ${names}`, 'R G B, or one channel');
  }
  const data = new Float32Array(width * height * 3);
  let negative = 0;
  colours.forEach((channel, c) => {
    for (let k = 0; k < channel!.length; k++) {
      const value = channel![k]!;
      if (!(Math.abs(value) <= MOST_RADIANCE)) throw strange(value, k % width, Math.floor(k / width));
      if (value < 0) negative++;
      data[3 * k + c] = Math.max(value, 0);
    }
  });
  return { data, negative };
}

const strange = (value: number, column: number, row: number) =>
  new ImageError('picture of a sky', `the value ${value} in column ${column} of row ${row}`, 'numbers from 0 to 1e12');

/** The share of each old row or column in the new ones: those that it overlaps, with how much `weight` of it lies there. */
function overlaps(from: number, to: number, weight: (start: number, end: number) => number) {
  return Array.from({ length: to }, (_, k) => {
    const [start, end] = [(k * from) / to, ((k + 1) * from) / to];
    const first = Math.floor(start);
    const parts: { readonly at: number; readonly share: number }[] = [];
    for (let at = first; at < Math.min(Math.ceil(end), from); at++)
      parts.push({ at, share: weight(Math.max(start, at), Math.min(end, at + 1)) });
    const total = parts.reduce((sum, { share }) => sum + share, 0);
    return parts.map(({ at, share }) => ({ at, share: share / total }));
  });
}

/** The mean over the solid angle of each new texel, so that the light stays the same. */
function averaged({ width, height, data }: EnvironmentMap, columns: number, rows: number): EnvironmentMap {
  const across = overlaps(width, columns, (start, end) => end - start);
  const angle = (row: number) => Math.cos((Math.PI * row) / height);
  const down = overlaps(height, rows, (start, end) => angle(start) - angle(end));
  const result = new Float32Array(columns * rows * 3);
  const line = new Float64Array(width * 3);
  down.forEach((parts, row) => {
    line.fill(0);
    for (const { at, share } of parts)
      for (let k = 0; k < line.length; k++) line[k] = line[k]! + share * data[at * width * 3 + k]!;
    across.forEach((cells, column) => {
      for (const { at, share } of cells)
        for (let c = 0; c < 3; c++) {
          const to = 3 * (row * columns + column) + c;
          result[to] = result[to]! + share * line[3 * at + c]!;
        }
    });
  });
  return { width: columns, height: rows, data: result };
}
