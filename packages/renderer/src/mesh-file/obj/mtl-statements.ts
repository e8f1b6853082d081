/** The lines of an MTL file, the materials of an OBJ file: read, and nothing made of them yet. */
import { quote } from '../../scene-file/problem.ts';
import type { FileProblems } from '../file-problems.ts';
import { LineScanner } from '../line-scanner.ts';
import { type MtlTexture, readTexture, type TextureWord, textureWord } from './mtl-textures.ts';

export type Rgb = [red: number, green: number, blue: number];

/** What the file says of one material, as it says it. */
export interface MtlMaterial {
  readonly name: string;
  readonly colors: Map<ColorWord, Rgb>;
  readonly numbers: Map<NumberWord, number>;
  readonly textures: Map<TextureWord, MtlTexture>;
  /** Other words that stand there. */
  readonly others: Set<string>;
}

/** Diffuse, specular, ambient, emitted, and what a transparent body lets through. */
export type ColorWord = (typeof COLORS)[number];
const COLORS = ['Kd', 'Ks', 'Ka', 'Ke', 'Tf'] as const;
/**
 * Exponent of the highlight, index of refraction, opacity, 1 − opacity, kind of illumination; and of the extension for physically based
 * rendering roughness, metallic, sheen, clear coat and its roughness, anisotropy and its rotation (1: once around).
 */
export type NumberWord = (typeof NUMBERS)[number];
const NUMBERS = ['Ns', 'Ni', 'd', 'Tr', 'illum', 'Pr', 'Pm', 'Ps', 'Pc', 'Pcr', 'aniso', 'anisor'] as const;

const MOST_MATERIALS = 4096;
const MOST_OTHERS = 40;

/** `folder`: of the file, with a "/" at its end; names of textures count from there. */
export function readMtlStatements(bytes: Uint8Array, folder: string, problems: FileProblems): MtlMaterial[] {
  const scan = new LineScanner(bytes, { continues: true });
  const materials = new Map<string, MtlMaterial>();
  let current: MtlMaterial | null = null;
  while (scan.nextWord()) {
    const { line } = scan;
    const word = scan.word();
    if (word === 'newmtl') current = begin(scan.rest(), line, materials, problems);
    else if (current && !word.startsWith('#')) readStatement(word, line, scan, current, folder, problems);
    else if (!word.startsWith('#'))
      problems.add({ line }, `${quote(word)} before any material`, 'a line "newmtl" first');
    scan.endLine();
  }
  return [...materials.values()];
}

/** The last of two with the same name counts. One without a name is that of faces that name none. */
function begin(name: string, line: number, materials: Map<string, MtlMaterial>, problems: FileProblems): MtlMaterial {
  if (materials.size >= MOST_MATERIALS) problems.fail({ line }, 'one material more', `at most ${MOST_MATERIALS}`);
  const material: MtlMaterial = { name, colors: new Map(), numbers: new Map(), textures: new Map(), others: new Set() };
  materials.set(name, material);
  return material;
}

const isOneOf = <Word extends string>(words: readonly Word[], word: string): word is Word =>
  (words as readonly string[]).includes(word);

function readStatement(
  word: string,
  line: number,
  scan: LineScanner,
  { colors, numbers, textures, others }: MtlMaterial,
  folder: string,
  problems: FileProblems,
): void {
  const map = textureWord(word);
  if (isOneOf(COLORS, word)) {
    const color = readColor(word, line, scan, problems);
    if (color) colors.set(word, color);
    else others.add(word);
  } else if (isOneOf(NUMBERS, word)) {
    // "d -halo 0.5": opaque where it is seen edge on, which we do not know.
    if (scan.bytes[scan.at + 1] === 45 && word === 'd') others.add('d -halo');
    else numbers.set(word, readNumber(word, line, scan, problems));
  } else if (map) {
    const texture = readTexture(scan.rest(), folder);
    if (typeof texture !== 'string') textures.set(map, texture);
    else if (others.size < MOST_OTHERS) others.add(`${word} (${texture})`);
  } else if (others.size < MOST_OTHERS) others.add(/^[\w-]{1,40}$/.test(word) ? word : quote(word));
}

/** One number is all three. Null: a spectrum or another colour space, which we do not know. */
function readColor(word: string, line: number, scan: LineScanner, problems: FileProblems): Rgb | null {
  const { at } = scan;
  const first = scan.word();
  if (first === 'spectral' || first === 'xyz') return null;
  scan.at = at;
  const red = readNumber(word, line, scan, problems);
  if (!scan.more()) return [red, red, red];
  return [red, readNumber(word, line, scan, problems), readNumber(word, line, scan, problems)];
}

function readNumber(word: string, line: number, scan: LineScanner, problems: FileProblems): number {
  const { at } = scan;
  const x = scan.number();
  if (Number.isFinite(x)) return x;
  scan.at = at;
  problems.add({ line }, `${quote(scan.word())} as ${quote(word)}`, 'a number');
  return 0;
}
