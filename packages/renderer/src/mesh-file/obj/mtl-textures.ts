/** Lines of an MTL file that name textures, "map_Kd -s 2 2 1 wood.png": read, and as uses of textures. */
import { IMAGE_ENDINGS, type NormalTextureUse } from '../../scene/textures.ts';
import { filePattern } from '../../scene-file/values.ts';

export interface MtlTexture {
  /** From the folder of the file on, with "/" between folders. */
  readonly file: string;
  readonly scale: readonly [number, number];
  readonly offset: readonly [number, number];
  /** `-bm`: how strong a normal map is. */
  readonly strength: number;
  /** Options that would make a difference and are not known here. */
  readonly ignored: readonly string[];
}

/** Diffuse, emitted, opacity, and a normal map. */
export type TextureWord = (typeof TEXTURES)[number];
export const TEXTURES = ['map_Kd', 'map_Ke', 'map_d', 'norm'] as const;

/** How many words follow an option; of those with numbers at most three, as many as there are. */
const WORDS: Readonly<Record<string, number>> = {
  '-blendu': 1, '-blendv': 1, '-bm': 1, '-boost': 1, '-cc': 1, '-clamp': 1, '-imfchan': 1, '-mm': 2, '-texres': 1, '-type': 1,
}; // biome-ignore format: table
const NUMBERS = ['-s', '-o', '-t'];
/** About smaller copies of the image, which there are none of, and what is told of kinds of maps. */
const HARMLESS = ['-blendu', '-blendv', '-boost', '-texres', '-type'];
const IMAGE = filePattern(IMAGE_ENDINGS);
const LONGEST = 900;

/** What stands behind the word. Null: no name of a file with an image that can be read. */
export function readTexture(line: string): MtlTexture | null {
  let rest = line;
  const take = (): string => {
    const word = /^\S+/.exec(rest)?.[0] ?? '';
    rest = rest.slice(word.length).trimStart();
    return word;
  };
  const numbers = new Map<string, number[]>();
  const ignored: string[] = [];
  for (let option = optionOf(rest); option !== null; option = optionOf(rest)) {
    take();
    const values: number[] = [];
    if (NUMBERS.includes(option))
      while (values.length < 3 && /^[-+.\d][-+.\deE]*(\s|$)/.test(rest)) values.push(Number(take()));
    else for (let n = 0; n < WORDS[option]!; n++) values.push(Number(take()));
    const isUsed = option === '-s' || option === '-o' || option === '-bm';
    if (isUsed && values.every(Number.isFinite)) numbers.set(option, values);
    else if (!HARMLESS.includes(option)) ignored.push(option);
  }
  const file = plainPath(rest);
  if (file === null) return null;
  const pair = (option: string, otherwise: number): [number, number] => {
    const [u = otherwise, v = otherwise] = numbers.get(option) ?? [];
    return [u, v];
  };
  return { file, scale: pair('-s', 1), offset: pair('-o', 0), strength: numbers.get('-bm')?.[0] ?? 1, ignored };
}

function optionOf(rest: string): string | null {
  const word = /^\S+/.exec(rest)?.[0] ?? '';
  return Object.hasOwn(WORDS, word) || NUMBERS.includes(word) ? word : null;
}

/** Programs write the paths of the machine that they run on: of those the file's name is what can be found beside the model. */
function plainPath(name: string): string | null {
  const slashes = name
    .trim()
    .replace(/\\/g, '/')
    .replace(/^(\.\/)+/, '');
  const path = /^([A-Za-z]:)?\//.test(slashes) ? slashes.slice(slashes.lastIndexOf('/') + 1) : slashes;
  return path.length <= LONGEST && IMAGE.test(path) ? path : null;
}

/** v counts from the bottom there, and from the top here. */
export function textureUse(folder: string, { file, scale: [su, sv], offset: [ou, ov] }: MtlTexture): NormalTextureUse {
  const isPlain = su === 1 && sv === 1 && ou === 0 && ov === 0;
  return { texture: folder + file, ...(isPlain ? {} : { scale: [su, sv], offset: [ou, 1 - sv - ov] }) };
}
