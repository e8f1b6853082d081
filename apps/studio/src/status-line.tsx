import type { FrameStats } from 'mirrorball';
import { dictionary } from './i18n.ts';
import { stats } from './state.ts';

/** Few digits, and always about as wide: 0.42, 4.2, 42, 420. */
export function figure(value: number): string {
  if (!Number.isFinite(value)) return '–';
  const digits = value === 0 || value >= 99.5 ? 0 : value >= 9.95 ? 1 : 2;
  return value.toFixed(digits);
}

/** The figures of the last frame. Not announced: it changes four times a second. */
export function StatusLine() {
  const t = dictionary.value;
  const now: FrameStats | null = stats.value;
  const items: readonly (readonly [string, string, string])[] = [
    ['fps', now ? String(Math.round(now.fps)) : '–', t.unitFps],
    ['ms', now ? figure(now.frameMs) : '–', t.unitMs],
    ['samples', now ? String(now.samples) : '–', t.unitSamples],
    ['mrays', now ? figure(now.mraysPerSecond) : '–', t.unitMrays],
  ];
  return (
    <section id="status" class="status" aria-label={t.status} aria-live="off">
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
