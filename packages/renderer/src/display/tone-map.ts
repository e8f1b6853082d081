/**
 * Tone mapping: linear Rec.709 radiance, after exposure, → linear Rec.709 of a screen, 0 … 1, before the sRGB curve. The same as
 * tone_map.wesl, for stills and files. Each is the form that other programs have under this name, so that pictures match theirs.
 */
import type { Color, ToneMapping } from '../scene/scene.ts';

type Matrix = readonly [Color, Color, Color];
/** Rows of the matrix times the colour. */
const times = (rows: Matrix, [r, g, b]: Color): Color => {
  const row = (m: Color) => m[0] * r + m[1] * g + m[2] * b;
  return [row(rows[0]), row(rows[1]), row(rows[2])];
};
const each = ([r, g, b]: Color, f: (value: number) => number): Color => [f(r), f(g), f(b)];
const clamp = (value: number, least: number, most: number): number => Math.min(Math.max(value, least), most);

const RRT_INPUT: Matrix = [
  [0.59719, 0.35458, 0.04823],
  [0.076, 0.90834, 0.01566],
  [0.0284, 0.13383, 0.83777],
];
const RRT_OUTPUT: Matrix = [
  [1.60475, -0.53108, -0.07367],
  [-0.10208, 1.10813, -0.00605],
  [-0.00327, -0.07276, 1.07602],
];

/**
 * Stephen Hill's fit of ACES 1.0's RRT and ODT (MJP's BakingLab, ACES.hlsl). The division by 0.6 is no part of ACES: three.js has
 * it, since the fit alone is darker than a bright room asks for (its issue 19621). It is kept because "ACES" in a browser has come
 * to mean three.js's, and because it takes middle grey, 0.18, to 0.21 instead of to 0.11: choosing ACES does not darken a scene.
 */
function aces(color: Color): Color {
  const fit = (v: number) => (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.432951) + 0.238081);
  const scaled = each(color, (v) => v / 0.6);
  return times(RRT_OUTPUT, each(times(RRT_INPUT, scaled), fit));
}

// ITU-R BT.2407, to the digits printed there and in its inverse.
const REC709_TO_REC2020: Matrix = [
  [0.6274, 0.3293, 0.0433],
  [0.0691, 0.9195, 0.0113],
  [0.0164, 0.088, 0.8956],
];
const REC2020_TO_REC709: Matrix = [
  [1.6605, -0.5876, -0.0728],
  [-0.1246, 1.1329, -0.0083],
  [-0.0182, -0.1006, 1.1187],
];
const AGX_INSET: Matrix = [
  [0.856627153315983, 0.0951212405381588, 0.0482516061458583],
  [0.137318972929847, 0.761241990602591, 0.101439036467562],
  [0.11189821299995, 0.0767994186031903, 0.811302368396859],
];
const AGX_OUTSET: Matrix = [
  [1.1271005818144368, -0.11060664309660323, -0.016493938717834573],
  [-0.1413297634984383, 1.157823702216272, -0.016493938717834257],
  [-0.14132976349843826, -0.11060664309660294, 1.2519364065950405],
];
/** Stops of linear light that the curve spans: −10 … 6.5 about 0.18. */
const AGX_STOPS = [-12.47393, 4.026069] as const;

/** Benjamin Wrensch's polynomial for the sigmoid, which is Troy Sobotka's. */
export const agxCurve = (x: number): number =>
  15.5 * x ** 6 - 40.14 * x ** 5 + 31.96 * x ** 4 - 6.868 * x ** 3 + 0.4298 * x ** 2 + 0.1191 * x - 0.00232;

/**
 * AgX by Troy Sobotka, base look: Blender's "AgX" with the look "None", in its Rec.2020 form with the numbers that Filament and
 * three.js have. The result of the curve is a screen's value to the power 1 / 2.2.
 */
function agx(color: Color): Color {
  const [least, most] = AGX_STOPS;
  const encode = (v: number) => clamp((Math.log2(Math.max(v, 1e-10)) - least) / (most - least), 0, 1);
  const inset = times(AGX_INSET, times(REC709_TO_REC2020, color));
  const outset = times(
    AGX_OUTSET,
    each(inset, (v) => agxCurve(encode(v))),
  );
  return times(
    REC2020_TO_REC709,
    each(outset, (v) => Math.max(v, 0) ** 2.2),
  );
}

const FRESNEL = 0.04;
const COMPRESSION_START = 0.8 - FRESNEL;
const DESATURATION = 0.15;

/**
 * Khronos PBR Neutral, by the equations of its specification: base colours up to 0.8 come out as they went in, less the 0.04 that
 * a clear coat adds to them under even light; only what is brighter is compressed, on its way to white.
 */
function neutral(color: Color): Color {
  const x = Math.min(...color);
  const f = x <= 2 * FRESNEL ? x - x ** 2 / (4 * FRESNEL) : FRESNEL;
  const lifted = each(color, (v) => v - f);
  const peak = Math.max(...lifted);
  if (peak <= COMPRESSION_START) return lifted;
  const newPeak = 1 - (1 - COMPRESSION_START) ** 2 / (peak + 1 - 2 * COMPRESSION_START);
  const kept = 1 / (DESATURATION * (peak - newPeak) + 1);
  return each(lifted, (v) => v * (newPeak / peak) * kept + newPeak * (1 - kept));
}

const OPERATORS: { readonly [Kind in ToneMapping]: (color: Color) => Color } = {
  none: (color) => color,
  aces,
  agx,
  neutral,
};
/** Brighter than this all of them give white. */
const BRIGHTEST = 1e6;

/** All of 0 … 1 afterwards. */
export function toneMap(color: Color, kind: ToneMapping): Color {
  const bounded = each(color, (v) => clamp(v, 0, BRIGHTEST));
  return each(OPERATORS[kind](bounded), (v) => clamp(v, 0, 1));
}
