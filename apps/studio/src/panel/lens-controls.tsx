import { Slider } from '../controls/slider.tsx';
import { changeLens } from '../focus.ts';
import { dictionary } from '../i18n.ts';
import { integrator, isStill, lens } from '../state.ts';
import { figure } from '../status-line.tsx';

/** Sliders go in equal ratios: a lens of a millimetre matters to a toy, one of a metre to a valley. */
const SMALLEST_APERTURE = 0.001;
const LARGEST_APERTURE = 1;
const NEAREST = 0.1;
const FARTHEST = 1000;
const STEPS = 100;

/** A place on a slider, 0 … STEPS, for a length and back. */
const toPlace = (length: number, least: number, most: number): number =>
  (STEPS * Math.log(Math.min(Math.max(length, least), most) / least)) / Math.log(most / least);
const toLength = (place: number, least: number, most: number): number =>
  Number((least * (most / least) ** (place / STEPS)).toPrecision(3));

/** Place 0 is a pinhole. */
export const aperturePlace = (radius: number): number =>
  radius > 0 ? 1 + toPlace(radius, SMALLEST_APERTURE, LARGEST_APERTURE) : 0;
export const apertureAt = (place: number): number =>
  place > 0 ? toLength(place - 1, SMALLEST_APERTURE, LARGEST_APERTURE) : 0;

/** Of the path integrator's camera. */
export function LensControls() {
  const t = dictionary.value;
  const { aperture, focus, panorama } = lens.value;
  const unused = integrator.value === 'path' ? (isStill.value ? t.stillHasNoLens : null) : t.onlyPath;
  const idle = unused ?? (panorama ? t.noLensInPanorama : null);
  const change = (next: { aperture: number } | { focus: number }): void => {
    lens.value = { ...lens.peek(), ...next };
    changeLens('aperture' in next ? next : { focusDistance: next.focus });
  };
  return (
    <>
      <Slider
        id="aperture"
        label={t.aperture}
        min={0}
        max={STEPS + 1}
        step={1}
        value={aperturePlace(aperture)}
        text={t.metres(aperture > 0 ? String(Number(aperture.toPrecision(3))) : '0')}
        onInput={(place) => change({ aperture: apertureAt(place) })}
        idle={idle}
      />
      <Slider
        id="focus-distance"
        label={t.focusDistance}
        min={0}
        max={STEPS}
        step={1}
        value={toPlace(focus, NEAREST, FARTHEST)}
        text={t.metres(figure(focus))}
        onInput={(place) => change({ focus: toLength(place, NEAREST, FARTHEST) })}
        idle={idle ?? (aperture > 0 ? null : t.focusNeedsAperture)}
      />
      {!idle && aperture > 0 && <p class="idle">{t.focusByClick}</p>}
    </>
  );
}
