/** The error of a picture against its samples as inline SVG: both axes logarithmic, beside the slope −½ of independent samples. */
import type { Convergence } from './convergence.ts';

const WIDTH = 300;
const HEIGHT = 200;
const LEFT = 46;
const BOTTOM = 30;
const TOP = 8;
const RIGHT = 16;

const decades = (low: number, high: number): number[] =>
  Array.from({ length: Math.round(high - low) + 1 }, (_, n) => Math.round(low) + n);

/** 1 %, 0.1 % … from the exponent of ten. */
const percent = (exponent: number): string => `${Number((100 * 10 ** exponent).toPrecision(1))} %`;

export function chart({ steps, floor }: Convergence, title: string): string {
  const seen = steps.filter(({ error }) => error > 0);
  if (seen.length < 2) return '<p class="none">No noise: every sample is exact.</p>';
  const [first, last] = [seen[0]!, seen.at(-1)!];
  const errors = [...seen.map(({ error }) => error), last.error];
  const [low, high] = [Math.floor(Math.log10(Math.min(...errors))), Math.ceil(Math.log10(Math.max(...errors)))];
  const top = high === low ? high + 1 : high;
  const most = Math.log2(last.samples);
  const x = (samples: number) => LEFT + ((WIDTH - LEFT - RIGHT) * Math.log2(samples)) / most;
  const y = (error: number) => TOP + ((HEIGHT - TOP - BOTTOM) * (top - Math.log10(error))) / (top - low);
  const clipped = (error: number) => Math.min(Math.max(y(error), TOP), HEIGHT - BOTTOM);
  const line = (points: readonly (readonly [number, number])[]) =>
    points.map(([px, py]) => `${px.toFixed(1)},${py.toFixed(1)}`).join(' ');
  // Through the middle of the measured points, in logarithms.
  const offset = seen.reduce((s, { samples, error }) => s + Math.log(error * Math.sqrt(samples)), 0) / seen.length;
  const slope = [first.samples, last.samples].map((n) => [x(n), clipped(Math.exp(offset) / Math.sqrt(n))] as const);
  const grid = decades(low, top).map(
    (e) =>
      `<line class="grid" x1="${LEFT}" x2="${WIDTH - RIGHT}" y1="${y(10 ** e)}" y2="${y(10 ** e)}"/>` +
      `<text x="${LEFT - 5}" y="${y(10 ** e) + 4}" text-anchor="end">${percent(e)}</text>`,
  );
  const ticks = [0, 0.5, 1].map((share) => {
    const samples = 2 ** Math.round(most * share);
    return `<text x="${x(samples)}" y="${HEIGHT - 14}" text-anchor="middle">${samples}</text>`;
  });
  const noise =
    floor > 10 ** low
      ? `<line class="floor" x1="${LEFT}" x2="${WIDTH - RIGHT}" y1="${y(floor)}" y2="${y(floor)}"/>`
      : '';
  const dots = seen.map(
    ({ samples, error }) => `<circle cx="${x(samples).toFixed(1)}" cy="${y(error).toFixed(1)}" r="2.5"/>`,
  );
  return `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${title}: relative error against samples a pixel">
${grid.join('')}${ticks.join('')}<text x="${(LEFT + WIDTH) / 2}" y="${HEIGHT - 2}" text-anchor="middle">samples a pixel</text>
${noise}<polyline class="slope" points="${line(slope)}"/>
<polyline class="ours" points="${line(seen.map(({ samples, error }) => [x(samples), y(error)]))}"/>${dots.join('')}
</svg>`;
}
