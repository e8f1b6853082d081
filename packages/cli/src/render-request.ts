/** What options mean together: which pixels, which samples, which settings. Pure. */
import { DeviceError, type FilmArea, type FilmSettings, HEADLESS_INTEGRATORS } from 'mirrorball/headless';
import type { Scene } from 'mirrorball/scene';
import type { RenderOptions } from './arguments.ts';
import { usage } from './exit-codes.ts';
import { formatRegion } from './regions.ts';
import type { SampleRange } from './sample-ranges.ts';

/** Samples a pixel when nothing is said, and at most when a run ends by its error or time. */
const SAMPLES = 64;
const SAMPLES_UNTIL = 2 ** 20;

/** The part of the picture that is wanted, which must lie in it. */
export function areaOf({ size, region, pixel }: Pick<RenderOptions, 'size' | 'region' | 'pixel'>): FilmArea {
  if (region && pixel) throw usage('--region and --pixel cannot both be given.');
  const area = pixel ? { ...pixel, width: 1, height: 1 } : (region ?? { x: 0, y: 0, ...size });
  const [right, bottom] = [area.x + area.width, area.y + area.height];
  if (right <= size.width && bottom <= size.height) return area;
  const what = pixel ? `The pixel ${area.x},${area.y}` : `The region ${formatRegion(area)}`;
  const isBeside = area.x >= size.width || area.y >= size.height;
  const reach = `reaches outside, to ${right},${bottom}:`;
  throw usage(
    `${what} ${isBeside ? 'lies outside:' : reach} the picture has ${size.width} × ${size.height} pixels (--size).`,
  );
}

/** What to do about a film that is larger than the device can hold; nothing about other errors. */
export const inParts = (error: unknown): string =>
  error instanceof DeviceError && error.limit === 'maxTextureSize'
    ? ' Render it part by part with --region, and `merge` the parts.'
    : '';

export function wantedOf(options: Pick<RenderOptions, 'spp' | 'samples' | 'untilError' | 'untilTime'>): SampleRange {
  const { spp, samples, untilError, untilTime } = options;
  if (spp !== undefined && samples)
    throw usage('--spp and --samples cannot both be given: --samples 0-63 is --spp 64.');
  if (samples) return samples;
  const most = untilError === undefined && untilTime === undefined ? SAMPLES : SAMPLES_UNTIL;
  return { first: 0, last: (spp ?? most) - 1 };
}

/** The scene's own settings where none are given; what an integrator would ignore is refused. */
export function settingsOf({ render }: Scene, options: RenderOptions): FilmSettings {
  const integrator = options.integrator ?? render.integrator;
  if (!HEADLESS_INTEGRATORS.includes(integrator))
    throw usage(`The integrator "${integrator}" is not in this version; there is ${HEADLESS_INTEGRATORS.join(', ')}.`);
  if (integrator === 'path' && options.backend === 'cpu')
    throw usage(
      `The backend "cpu" traces the classic integrator only${options.integrator ? '' : ', and this scene asks for paths'}. ` +
        'Say --integrator classic, or another --backend.',
    );
  const strange = integrator === 'classic' ? (['maxDepth'] as const) : (['maxReflections', 'lightSamples'] as const);
  for (const key of strange) {
    if (options[key] === undefined) continue;
    const flag = key.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
    throw usage(`--${flag} means nothing to the integrator "${integrator}".`);
  }
  const { maxDepth = render.maxDepth, maxReflections = render.maxReflections } = options;
  const { lightSamples = render.lightSamples, seed } = options;
  return { integrator, maxDepth, maxReflections, lightSamples, seed };
}
