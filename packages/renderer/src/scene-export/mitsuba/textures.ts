/** Textures as Mitsuba's bitmaps: each image a PNG file beside the scene, its opacity another, which few programs read out of a first. */
import { encode } from 'fast-png';
import type { Scene } from '../../scene/scene.ts';
import type { ImagePixels, TextureUse } from '../../scene/textures.ts';
import type { PlannedFiles } from '../export-plan.ts';
import type { ExportReport } from '../export-report.ts';
import { boolean, type Element, plugin, string, toUv } from './xml.ts';

/** What of an image is meant: colours, which are sRGB, numbers as they stand, or its opacity. */
export type Meaning = 'color' | 'numbers' | 'opacity';

export class TextureWriter {
  readonly #scene: Scene;
  readonly #name: string;
  readonly #files: PlannedFiles;
  readonly #report: ExportReport;
  /** Names of files, by what is in them. */
  readonly #written = new Map<string, string>();

  constructor(scene: Scene, name: string, files: PlannedFiles, report: ExportReport) {
    this.#scene = scene;
    this.#name = name;
    this.#files = files;
    this.#report = report;
  }

  /** `name`: what the plugin around calls it. */
  bitmap(name: string, use: TextureUse, meaning: Meaning): Element {
    const { image, wrapU = 'repeat', wrapV = 'repeat', filter = 'linear' } = this.#scene.textures![use.texture]!;
    if (wrapU !== wrapV)
      this.#report.add('changed', 'A texture goes on beyond its edges along v as along u there.', `texture "${use.texture}"`); // biome-ignore format: one sentence
    const { offset = [0, 0], rotation = 0, scale = [1, 1] } = use;
    const [c, s] = [Math.cos((rotation * Math.PI) / 180), Math.sin((rotation * Math.PI) / 180)];
    const moves = use.offset !== undefined || use.rotation !== undefined || use.scale !== undefined;
    return plugin('texture', 'bitmap', [
      string('filename', this.#file(image, meaning)),
      boolean('raw', meaning !== 'color'),
      // Else colours are rounded to 16 bits.
      string('format', 'variant'),
      string('wrap_mode', wrapU),
      string('filter_type', filter === 'nearest' ? 'nearest' : 'bilinear'),
      ...(moves ? [toUv([c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1]])] : []),
    ], { name }); // biome-ignore format: one list
  }

  #file(image: string, meaning: Meaning): string {
    const channels = meaning === 'opacity' ? 1 : 3;
    const known = this.#written.get(`${channels} ${image}`);
    if (known !== undefined) return known;
    const data = this.#scene.images![image]?.data;
    if (data === undefined) throw new TypeError(`The image "${image}" has not been loaded.`);
    const safe = image.replace(/[^\p{L}\p{N}]+/gu, '-').slice(0, 60);
    const file = `${this.#name}.${this.#written.size} ${safe}${channels === 1 ? ' opacity' : ''}.png`.replace(
      / /g,
      '-',
    );
    this.#files.set(file, () => [pngOf(data, channels)]);
    this.#written.set(`${channels} ${image}`, file);
    return file;
  }
}

/** Red, green and blue, or the alpha alone. */
function pngOf({ width, height, rgba }: ImagePixels, channels: 1 | 3): Uint8Array {
  const data = new Uint8Array(width * height * channels);
  for (let i = 0; i < data.length; i++)
    data[i] = channels === 1 ? rgba[4 * i + 3]! : rgba[4 * Math.floor(i / 3) + (i % 3)]!;
  return encode({ width, height, channels, depth: 8, data });
}
