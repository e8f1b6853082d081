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

struct Display {
  // factor, 2^stops
  exposure: f32,
  // unused
  spare: f32,
  // pixels
  filmSize: vec2f,
}
