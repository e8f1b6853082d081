/** `mirrorball info`: what is in a file. */
import { readFile } from 'node:fs/promises';
import { type FloatPicture, formatOf, ImageError } from 'mirrorball/picture-files';
import { type BadScene, lookAtAll, usage } from '../exit-codes.ts';
import { factLines } from '../fact-lines.ts';
import { meshFileFacts } from '../mesh-facts.ts';
import { readPart } from '../part-file.ts';
import { isPart } from '../picture-file.ts';
import { formatRanges } from '../sample-ranges.ts';
import { sceneFacts } from '../scene-facts.ts';
import { readScene } from '../scene-source.ts';
import { percent, type Terminal } from '../terminal.ts';

/** What is told about a file, by name. */
type Facts = Readonly<Record<string, unknown>>;

export const info = (files: readonly string[], terminal: Terminal): Promise<void> =>
  lookAtAll(files, async (file) => {
    const facts = await factsOf(file);
    if ('problems' in facts) return facts as unknown as BadScene;
    terminal.event('info', { file, ...facts });
    terminal.result(file);
    for (const line of factLines(facts)) terminal.result(`  ${line}`);
    return null;
  });

async function factsOf(file: string): Promise<Facts | BadScene> {
  if (isPart(file)) return partFacts(file);
  const isMesh = /\.(ply|obj|stl)$/i.test(file);
  if (!isMesh && !/\.(exr|png|pfm|npy|hdr)$/i.test(file)) {
    const source = await readScene(file);
    return 'problems' in source ? source : sceneFacts(source);
  }
  const bytes = await readFile(file).catch((error: Error) => {
    throw usage(`${file} cannot be read: ${error.message}`);
  });
  if (isMesh) return meshFileFacts(bytes, file);
  try {
    const format = formatOf(file);
    return { kind: `${format.name} picture`, ...pictureFacts(format.read(bytes)) };
  } catch (error) {
    if (error instanceof ImageError) throw usage(`${file}: ${error.message}`);
    throw error;
  }
}

function pictureFacts({ width, height, channels, texts = {} }: FloatPicture): Facts {
  const ranges = channels.map(({ name, data }) => {
    let [least, most, strange] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY, 0];
    for (const value of data) {
      if (!Number.isFinite(value)) strange++;
      else [least, most] = [Math.min(least, value), Math.max(most, value)];
    }
    return [name, { least, most, nonFinite: strange }] as const;
  });
  return { size: `${width} × ${height}`, channels: Object.fromEntries(ranges), ...texts };
}

async function partFacts(file: string): Promise<Facts> {
  const { identity, film, texts } = await readPart(file);
  const { scene, ...rest } = identity;
  const samples = formatRanges(film.ranges);
  return { kind: 'part file', title: texts.Title, samples, error: percent(film.error()), ...rest, scene };
}
