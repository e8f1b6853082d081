// Linked from display/aov_view.wesl by `npm run shaders`. Do not edit.
@group(0) @binding(0) var<uniform> view: AovView;

@group(0) @binding(1) var film: texture_2d<f32>;

// A colour for each number.
@group(0) @binding(2) var numberColors: texture_2d<f32>;

// Half grey at the typical distance, white at the eye, black at infinity: no film has to be searched for its nearest and farthest.
fn depthShade(place: vec3f) -> f32 {
  let depth = select(dot(place, view.forward), length(place), all(view.forward == vec3f(0.0)));
  return view.scale / (view.scale + max(depth, 0.0));
}

// Grey at the target; red, green and blue along the world's axes, to the ends of the world.
fn placeColor(place: vec3f) -> vec3f {
  let p = (place - view.middle) / view.scale;
  return 0.5 + 0.5 * p / (1.0 + abs(p));
}

@fragment fn showAov(point: ScreenPoint) -> @location(0) vec4f {
  let texel = clamp(floor(point.uv * view.filmSize), vec2f(0.0), view.filmSize - 1.0);
  let value = textureLoad(film, vec2i(texel), 0);
  var color = vec3f(0.0);
  if (view.kind == 0u) {
    color = srgb(clamp(value.rgb / max(value.a, 1.0), vec3f(0.0), vec3f(1.0)));
  } else if (view.kind == 1u) {
    let size = length(value.xyz);
    color = select(vec3f(0.0), 0.5 + 0.5 * value.xyz / max(size, 1e-20), size > 0.0);
  } else if (value.a > 0.0) {
    if (view.kind == 2u) {
      color = vec3f(depthShade(value.xyz));
    } else if (view.kind == 3u) {
      color = placeColor(value.xyz);
    } else {
      color = textureLoad(numberColors, vec2i(i32(value.a), 0), 0).rgb;
    }
  }
  return vec4f(color, 1.0);
}

struct AovView {
  // 0 colour, 1 normal, 2 depth, 3 place, 4 number
  kind: u32,
  // a typical distance, metres
  scale: f32,
  // pixels
  filmSize: vec2f,
  // camera f; zero: distances instead of depths
  forward: vec3f,
  // from the eye to what is looked at
  middle: vec3f,
}


struct ScreenPoint {
  @builtin(position) position: vec4f,
  // 0 … 1 from the top left corner, whichever way the target's rows run.
  @location(0) uv: vec2f,
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
