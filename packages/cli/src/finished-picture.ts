/**
 * Whether --resume finds a picture done. A picture file holds no sums, so that it cannot go on as a part file does; it is kept when it is
 * the wanted one, and what is another or a lesser one is refused rather than replaced or passed for it.
 */
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { AOVS, type AovName } from 'mirrorball/headless';
import { type FloatPicture, formatOf, ImageError } from 'mirrorball/picture-files';
import { aovFile, holdsLayers } from './aov-pictures.ts';
import { usage } from './exit-codes.ts';
import { differences, type FilmIdentity } from './film-identity.ts';
import { type RenderFacts, readRenderText } from './render-text.ts';
import type { FilmGoal } from './run-film.ts';
import { formatRanges, missingFrom } from './sample-ranges.ts';

export interface WantedPicture {
  readonly identity: FilmIdentity;
  readonly goal: FilmGoal;
  /** Stops; of formats for screens. */
  readonly exposure: number;
  readonly aov?: readonly AovName[];
}

/** A sentence for people: the picture there is the wanted one, as far as its file says. Throws a usage error for any other. */
export async function checkFinished(path: string, wanted: WantedPicture): Promise<string> {
  const refuse = (why: string) =>
    usage(`${path} ${why}. It stays as it is; without --resume a new picture replaces it.`);
  const bytes = await readFile(path).catch((error: Error) => {
    throw usage(`The picture ${path} cannot be read: ${error.message}`);
  });
  const format = formatOf(path);
  let picture: FloatPicture;
  try {
    picture = format.read(bytes);
  } catch (error) {
    if (error instanceof ImageError) throw refuse(`is there and cannot be read: ${error.message.replace(/\.$/, '')}`);
    throw error;
  }
  const without = wanted.aov?.filter((name) => !hasAov(path, picture, name)) ?? [];
  const facts = format.texts ? readRenderText(picture.texts?.Render) : null;
  const why = facts ? whyNot(facts, wanted) : whyNotOfSize(picture, wanted, format.texts);
  if (why) throw refuse(why);
  if (without.length > 0) throw refuse(`is there already, but without the AOVs ${without.join(', ')}`);
  return facts
    ? `${path} is there already.`
    : `${path} is there already; ${format.name} does not say of which scene, settings and samples.`;
}

const hasAov = (path: string, { channels }: FloatPicture, name: AovName): boolean =>
  holdsLayers(path)
    ? channels.some((channel) => channel.name.startsWith(`${AOVS[name].layer}.`) || channel.name === AOVS[name].layer)
    : existsSync(aovFile(path, name));

function whyNotOfSize({ width, height }: FloatPicture, { identity }: WantedPicture, hasTexts: boolean): string | null {
  if (hasTexts) return 'does not say what it was rendered from';
  const [, , w, h] = identity.region;
  return width === w && height === h
    ? null
    : `belongs to another picture: it has ${width} × ${height} pixels instead of ${w} × ${h}`;
}

/** Null: it is the wanted picture, with at least the wanted samples. */
export function whyNot({ identity, look, ranges, whole, error }: RenderFacts, wanted: WantedPicture): string | null {
  const differ = differences(identity, wanted.identity);
  if (look && look.exposure !== wanted.exposure) differ.push(`exposure ${look.exposure} instead of ${wanted.exposure}`);
  if (differ.length > 0) return `belongs to another picture: it has ${differ.join(', ')}`;
  if (!whole) return 'is not whole: some of its pixels are in no part';
  const { goal } = wanted;
  const lacking = ranges.find((held) => missingFrom(goal.wanted, held).length > 0);
  if (!lacking || goal.untilTime !== undefined) return null;
  if (goal.untilError !== undefined)
    return error !== null && error <= goal.untilError
      ? null
      : `has the error ${error ?? '(not known)'}, which is not below ${goal.untilError}`;
  return `has only the samples ${formatRanges(lacking)} of ${formatRanges([goal.wanted])}, and a finished picture cannot go on`;
}
