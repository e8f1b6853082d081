// Linked from display/display.wesl by `npm run shaders`. Do not edit.
@group(0) @binding(0) var<uniform> display: Display;

@group(0) @binding(1) var film: texture_2d<f32>;

struct ScreenPoint {
  @builtin(position) position: vec4f,
  // 0 … 1 from the top left corner, whichever way the target's rows run.
  @location(0) uv: vec2f,
}


@vertex fn screen(@builtin(vertex_index) i: u32) -> ScreenPoint {
  let p = vec2f(f32((i << 1u) & 2u), f32(i & 2u));
  return ScreenPoint(vec4f(p * 2.0 - 1.0, 0.0, 1.0), vec2f(p.x, 1.0 - p.y));
}

fn mean(texel: vec2f) -> vec3f {
  let sum = textureLoad(film, vec2i(clamp(texel, vec2f(0.0), display.filmSize - 1.0)), 0);
  return sum.rgb / max(sum.a, 1.0);
}

// The sRGB curve (IEC 61966-2-1) of values in 0 … 1 by roots in place of powers, which software rasterisers take long for. Fitted
// so that it is off by less than a quarter of an 8-bit step everywhere; display.test.ts checks it.
fn srgb(c: vec3f) -> vec3f {
  let r2 = sqrt(c);
  let r4 = sqrt(r2);
  let r8 = sqrt(r4);
  let curve = 0.662002687 * r2 + 0.684122060 * r4 - 0.323583601 * r8 - 0.0225411470 * c;
  return select(curve, 12.92 * c, c <= vec3f(0.0031308));
}

// Clipped before it is filtered, so that the edge of a bright light stays smooth.
fn shown(texel: vec2f) -> vec3f {
  return clamp(mean(texel) * display.exposure, vec3f(0.0), vec3f(1.0));
}

@fragment fn show(point: ScreenPoint) -> @location(0) vec4f {
  let at = point.uv * display.filmSize - 0.5;
  let corner = floor(at);
  let f = at - corner;
  // One film pixel for one canvas pixel: exactly that texel.
  if (all(abs(f - 0.5) > vec2f(0.499))) {
    return vec4f(srgb(shown(floor(at + 0.5))), 1.0);
  }
  let upper = mix(shown(corner), shown(corner + vec2f(1.0, 0.0)), f.x);
  let lower = mix(shown(corner + vec2f(0.0, 1.0)), shown(corner + vec2f(1.0, 1.0)), f.x);
  return vec4f(srgb(mix(upper, lower, f.y)), 1.0);
}

// The same with tone mapping. An entry of its own, since software rasterisers run both sides of every `if`: who clips does not pay
// for logarithms. Mapped before it is filtered too.
@fragment fn showMapped(point: ScreenPoint) -> @location(0) vec4f {
  let at = point.uv * display.filmSize - 0.5;
  let corner = floor(at);
  let f = at - corner;
  // One texel or four, in a loop, so that tone mapping is compiled once.
  let exact = all(abs(f - 0.5) > vec2f(0.499));
  let first = select(corner, floor(at + 0.5), exact);
  let taps = select(4u, 1u, exact);
  var sum = vec3f(0.0);
  var tap = 0u;
  loop {
    let step = vec2f(f32(tap & 1u), f32(tap >> 1u));
    let share = mix(1.0 - f, f, step);
    sum += select(share.x * share.y, 1.0, exact) * toneMap(mean(first + step) * display.exposure, display.toneMapping);
    tap++;
    if (tap >= taps) {
      break;
    }
  }
  return vec4f(srgb(sum), 1.0);
}

struct Display {
  // factor, 2^stops
  exposure: f32,
  // position in TONE_MAPPINGS
  toneMapping: u32,
  // pixels
  filmSize: vec2f,
}


fn toneMap(color: vec3f, kind: u32) -> vec3f {
  let c = clamp(color, vec3f(0.0), vec3f(brightest));
  var mapped = c;
  if (kind == 1u) {
    mapped = aces(c);
  }
  if (kind == 2u) {
    mapped = agx(c);
  }
  if (kind == 3u) {
    mapped = neutral(c);
  }
  return clamp(mapped, vec3f(0.0), vec3f(1.0));
}

// Brighter than this all of them give white; it keeps squares finite.
const brightest = 1e6;

fn aces(color: vec3f) -> vec3f {
  let v = rrtInput * (color / 0.6);
  return rrtOutput * ((v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081));
}

// Tone mapping: linear Rec.709 radiance, after exposure, to linear Rec.709 of a screen, 0 … 1. Numbered as in
// scene/tone-mappings.ts. tone-map.ts is the same in TypeScript and says where each comes from.
const rrtInput = mat3x3f(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);

const rrtOutput = mat3x3f(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);

fn agx(color: vec3f) -> vec3f {
  let stops = log2(max(agxInset * (rec709ToRec2020 * color), vec3f(1e-10)));
  let x = clamp((stops - agxLeast) / (agxMost - agxLeast), vec3f(0.0), vec3f(1.0));
  let x2 = x * x;
  let x4 = x2 * x2;
  let curve = 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
  return rec2020ToRec709 * pow(max(agxOutset * curve, vec3f(0.0)), vec3f(2.2));
}

const agxInset = mat3x3f(0.856627153315983, 0.137318972929847, 0.11189821299995, 0.0951212405381588, 0.761241990602591, 0.0767994186031903, 0.0482516061458583, 0.101439036467562, 0.811302368396859);

const rec709ToRec2020 = mat3x3f(0.6274, 0.0691, 0.0164, 0.3293, 0.9195, 0.0880, 0.0433, 0.0113, 0.8956);

const agxLeast = -12.47393;

const agxMost = 4.026069;

const rec2020ToRec709 = mat3x3f(1.6605, -0.1246, -0.0182, -0.5876, 1.1329, -0.1006, -0.0728, -0.0083, 1.1187);

const agxOutset = mat3x3f(1.1271005818144368, -0.1413297634984383, -0.14132976349843826, -0.11060664309660323, 1.157823702216272, -0.11060664309660294, -0.016493938717834573, -0.016493938717834257, 1.2519364065950405);

fn neutral(color: vec3f) -> vec3f {
  let x = min(color.r, min(color.g, color.b));
  let lifted = color - select(fresnel, x - x * x / (4.0 * fresnel), x <= 2.0 * fresnel);
  // At the start of the compression the formula is the identity, so that nothing below needs a branch.
  let peak = max(max(lifted.r, max(lifted.g, lifted.b)), compressionStart);
  let room = 1.0 - compressionStart;
  let newPeak = 1.0 - room * room / (peak + 1.0 - 2.0 * compressionStart);
  let kept = 1.0 / (desaturation * (peak - newPeak) + 1.0);
  return mix(vec3f(newPeak), lifted * (newPeak / peak), kept);
}

const fresnel = 0.04;

const compressionStart = 0.76;

const desaturation = 0.15;
