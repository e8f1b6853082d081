import type { FrameStats } from 'mirrorball';
import { type Dictionary, dictionary } from './i18n.ts';
import { integrator, shownView, stats } from './state.ts';

/** Few digits, and always about as wide: 0.42, 4.2, 42, 420. */
export function figure(value: number): string {
  if (!Number.isFinite(value)) return '–';
  const digits = value === 0 || value >= 99.5 ? 0 : value >= 9.95 ? 1 : 2;
  return value.toFixed(digits);
}

/** Whole frames a second; where there are few, tenths too. */
export const frequency = (fps: number): string => (fps === 0 || fps >= 9.95 ? fps.toFixed(0) : fps.toFixed(1));

/** Like a clock: 0:07, 12:05, 1:02:05. */
export function duration(seconds: number): string {
  const whole = Math.floor(seconds);
  const [h, m, s] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  const two = (n: number) => String(n).padStart(2, '0');
  return h > 0 ? `${h}:${two(m)}:${two(s)}` : `${m}:${two(s)}`;
}

/** How far a picture by paths has come. */
function progressOf(now: FrameStats | null, t: Dictionary): readonly (readonly [string, string, string])[] {
  const error = now?.relativeError ?? null;
  return [
    ['error', error === null ? '–' : t.percent(Number(figure(error * 100))), t.unitError],
    ['time', now ? duration(now.filmSeconds) : '–', t.unitTime],
  ];
}

/** The figures of the last frame. Not announced: it changes four times a second. */
export function StatusLine() {
  const t = dictionary.value;
  // Nothing has been drawn before there is a film.
  const now: FrameStats | null = stats.value?.filmWidth ? stats.value : null;
  const converges = integrator.value === 'path' && shownView.value === 'picture' && now?.backend !== 'cpu';
  const items: readonly (readonly [string, string, string])[] = [
    ['fps', now ? frequency(now.fps) : '–', t.unitFps],
    ['ms', now ? figure(now.frameMs) : '–', t.unitMs],
    ['samples', now ? String(now.samples) : '–', now?.samples === 1 ? t.unitSample : t.unitSamples],
    ...(converges ? progressOf(now, t) : []),
    // As many rays as the settings allow: paths that end early have fewer.
    ['mrays', now ? `≤ ${figure(now.mraysPerSecond)}` : '–', t.unitMrays],
  ];
  return (
    <section id="status" class={converges ? 'status converging' : 'status'} aria-label={t.status} aria-live="off">
      {items.map(([name, value, unit]) => (
        <span key={name} id={`status-${name}`}>
          <b>{value}</b> {unit}
        </span>
      ))}
      <span id="status-resolution">{now ? `${now.filmWidth} × ${now.filmHeight}` : '–'}</span>
      <span id="status-backend">{now ? t.backendNames[now.backend] : '–'}</span>
    </section>
  );
}
