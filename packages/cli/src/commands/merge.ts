/** `mirrorball merge`: parts of one picture → the picture, or one part. */
import type { MergeOptions } from '../arguments.ts';
import { usage } from '../exit-codes.ts';
import { differences } from '../film-identity.ts';
import { type Part, readPart } from '../part-file.ts';
import { checkOutputName, writeFilm } from '../picture-file.ts';
import { formatRanges, missingFrom, overlap } from '../sample-ranges.ts';
import { percent, type Terminal } from '../terminal.ts';
import { checkWritable } from '../write-atomically.ts';

export async function merge(files: readonly string[], options: MergeOptions, terminal: Terminal): Promise<void> {
  checkOutputName(options.output);
  await checkWritable(options.output);
  const parts: { file: string; part: Part }[] = [];
  for (const file of files) parts.push({ file, part: await readPart(file) });
  // In the order of their samples, whatever the order of the names: sums of doubles depend on it in the last digit.
  parts.sort((a, b) => (a.part.film.ranges[0]?.first ?? 0) - (b.part.film.ranges[0]?.first ?? 0));
  const [first, ...others] = parts as [(typeof parts)[0], ...typeof parts];
  for (const { file, part } of others) {
    const differ = differences(part.identity, first.part.identity);
    if (differ.length > 0) throw usage(`${file} and ${first.file} are of different pictures: ${differ.join(', ')}.`);
    const twice = overlap(first.part.film.ranges, part.film.ranges);
    if (twice) throw usage(`${file} holds samples ${formatRanges([twice])}, which another part holds too.`);
    first.part.film.merge(part.film);
  }
  await writeFilm(options.output, first.part, options);
  const { film } = first.part;
  const { ranges, samples } = film;
  const error = film.error();
  terminal.event('done', { output: options.output, parts: files.length, samples, ranges, error });
  const gaps = missingFrom({ first: 0, last: ranges.at(-1)?.last ?? 0 }, ranges);
  if (gaps.length > 0) terminal.note(`Samples ${formatRanges(gaps)} are in no part.`);
  terminal.result(`${options.output}: ${samples} samples a pixel (${formatRanges(ranges)}), error ${percent(error)}`);
}
