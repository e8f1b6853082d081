/** Lines of an MTL file that name textures, "map_Kd -s 2 2 1 wood.png": read, and as uses of textures. */
import { IMAGE_ENDINGS, type NormalTextureUse, type Texture } from '../../scene/textures.ts';
import { quote } from '../../scene-file/problem.ts';
import { filePattern } from '../../scene-file/values.ts';

export interface MtlTexture {
  /** From the folder of the file on, with "/" between folders. */
  readonly file: string;
  readonly scale: readonly [number, number];
  readonly offset: readonly [number, number];
  /** `-bm`: how strong bumps are. */
  readonly strength: number;
  /** `-clamp on`: the image is there once and not again and again. */
  readonly clamp: boolean;
  /** `-mm`: base + gain · the image's number counts. */
  readonly base: number;
  readonly gain: number;
  /** `-imfchan`: which of the image's channels a map of numbers is; l is how bright it is, m its alpha. */
  readonly channel?: ImageChannel;
  /** Options that would make a difference and are not known here. */
  readonly ignored: readonly string[];
}
export type ImageChannel = 'r' | 'g' | 'b' | 'l' | 'm';

/**
 * Diffuse, specular, emitted, exponent of the highlight, opacity; of the extension for physically based rendering roughness, metallic,
 * sheen, clear coat and its roughness; heights, and a normal map.
 */
export type TextureWord = (typeof TEXTURES)[number];
const TEXTURES = ['map_Kd', 'map_Ks', 'map_Ke', 'map_Ns', 'map_d', 'map_Pr', 'map_Pm', 'map_Ps', 'map_Pc', 'map_Pcr', 'bump', 'norm'] as const; // biome-ignore format: words
const ALIASES: Readonly<Record<string, TextureWord>> = { map_bump: 'bump', map_kn: 'norm', map_norm: 'norm' };
const SPELLED = new Map([...TEXTURES.map((word) => [word.toLowerCase(), word] as const), ...Object.entries(ALIASES)]);

/** Programs differ in capital letters. Null: no word for a texture. */
export const textureWord = (word: string): TextureWord | null => SPELLED.get(word.toLowerCase()) ?? null;

/** How many words follow an option; of those with numbers at most three, as many as there are. */
const WORDS: Readonly<Record<string, number>> = {
  '-blendu': 1, '-blendv': 1, '-bm': 1, '-boost': 1, '-cc': 1, '-clamp': 1, '-imfchan': 1, '-mm': 2, '-texres': 1, '-type': 1,
}; // biome-ignore format: table
const TRIPLES = ['-s', '-o', '-t'];
/** About smaller copies of the image, which there are none of, and what is told of kinds of maps. */
const HARMLESS = ['-blendu', '-blendv', '-boost', '-texres', '-type'];
const NUMBERS = ['-s', '-o', '-bm', '-mm'];
const CHANNELS: readonly string[] = ['r', 'g', 'b', 'l', 'm'];
const IMAGE = filePattern(IMAGE_ENDINGS);
/** As names of images may be. */
const LONGEST = 200;
/** Of factors and offsets. */
const MOST = 1e6;

/** What stands behind the word, for a file in `folder`; or why no image can be read by it, in a few words. */
export function readTexture(line: string, folder: string): MtlTexture | string {
  const { options, numbers, ignored, rest } = readOptions(optionsFirst(line));
  const file = plainPath(rest);
  if (!IMAGE.test(file)) return `${quote(rest.trim())} is no image of a kind that is read`;
  if (folder.length + file.length > LONGEST || !/^\S(?:.*\S)?$/.test(file))
    return 'its file has too long or strange a name';
  const pair = (option: string, otherwise: number): [number, number] => {
    const [u = otherwise, v = otherwise] = numbers.get(option) ?? [];
    return [u, v];
  };
  const [base, gain] = numbers.get('-mm') ?? [0, 1];
  const channel = options.get('-imfchan');
  const known = channel !== undefined && CHANNELS.includes(channel);
  return {
    file: folder + file,
    scale: pair('-s', 1),
    offset: pair('-o', 0),
    strength: numbers.get('-bm')?.[0] ?? 1,
    clamp: options.get('-clamp') === 'on',
    base: base!,
    gain: gain!,
    ...(known && { channel: channel as ImageChannel }),
    ignored: channel !== undefined && !known ? [...ignored, '-imfchan'] : ignored,
  };
}

/** Some programs write the options behind the name. */
function optionsFirst(line: string): string {
  const [, name, options] = OPTIONS_LAST.exec(line) ?? [];
  return name === undefined ? line : `${options} ${name}`;
}
const OPTIONS_LAST = new RegExp(`^([^-].*\\.(?:${IMAGE_ENDINGS.join('|')}))\\s+(-[a-z].*)$`, 'i');

/** The options in front of a name, those with numbers and others; a name may have spaces. */
function readOptions(line: string) {
  let rest = line;
  const take = (): string => {
    const word = /^\S+/.exec(rest)?.[0] ?? '';
    rest = rest.slice(word.length).trimStart();
    return word;
  };
  const numbers = new Map<string, number[]>();
  const options = new Map<string, string>();
  const ignored: string[] = [];
  for (let option = optionOf(rest); option !== null; option = optionOf(rest)) {
    take();
    const words: string[] = [];
    if (TRIPLES.includes(option)) while (words.length < 3 && /^[-+.\d][-+.\deE]*(\s|$)/.test(rest)) words.push(take());
    else for (let n = 0; n < WORDS[option]!; n++) words.push(take());
    const values = words.map(Number);
    if (NUMBERS.includes(option) && values.every((x) => Math.abs(x) <= MOST)) numbers.set(option, values);
    else if (option === '-clamp' || option === '-imfchan') options.set(option, words[0]!.toLowerCase());
    // "-t 0 0 0" and "-cc off" are what is so without them.
    else if (!HARMLESS.includes(option) && !values.every((x) => x === 0) && words[0] !== 'off') ignored.push(option);
  }
  return { numbers, options, ignored, rest };
}

function optionOf(rest: string): string | null {
  const word = /^\S+/.exec(rest)?.[0] ?? '';
  return Object.hasOwn(WORDS, word) || TRIPLES.includes(word) ? word : null;
}

/** Programs write the paths of the machine that they run on: of those the file's name is what can be found beside the model. */
export function plainPath(name: string): string {
  const slashes = name
    .trim()
    .replace(/^"(.*)"$/, '$1')
    .replace(/\\ /g, ' ') // as in a shell
    .replace(/\\/g, '/')
    .replace(/\/{2,}/g, '/')
    .replace(/^(\.\/)+/, '');
  return /^([A-Za-z]:|\/)/.test(slashes) ? slashes.slice(Math.max(slashes.lastIndexOf('/'), slashes.indexOf(':')) + 1) : slashes; // biome-ignore format: one choice
}

/** v counts from the bottom there, and from the top here. `texture`: its name. */
export function textureUse(texture: string, { scale: [su, sv], offset: [ou, ov] }: MtlTexture): NormalTextureUse {
  const isPlain = su === 1 && sv === 1 && ou === 0 && ov === 0;
  return { texture, ...(isPlain ? {} : { scale: [su, sv], offset: [ou, 1 - sv - ov] }) };
}

export const isPlacedAlike = (a: MtlTexture, b: MtlTexture): boolean =>
  a.clamp === b.clamp && [0, 1].every((k) => a.scale[k] === b.scale[k] && a.offset[k] === b.offset[k]);

export const CLAMPED: Pick<Texture, 'wrapU' | 'wrapV'> = { wrapU: 'clamp', wrapV: 'clamp' };
