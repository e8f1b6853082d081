// Linked from film/film_error.wesl by `npm run shaders`. Do not edit.
@group(0) @binding(0) var<uniform> display: Display;

@group(0) @binding(1) var film: texture_2d<f32>;

@group(0) @binding(2) var filmSquares: texture_2d<f32>;

// Cells along a side, and pixels of a cell along a side at most: film-error.ts has the first number too.
const cells = 64.0;

const pixels = 4.0;

@fragment fn filmError(@builtin(position) fragment: vec4f) -> @location(0) vec4f {
  let begin = floor(floor(fragment.xy) * display.filmSize / cells);
  let end = floor((floor(fragment.xy) + 1.0) * display.filmSize / cells);
  let stride = max((end - begin) / pixels, vec2f(1.0));
  var sum = vec4f(0.0);
  for (var y = 0.0; y < pixels; y += 1.0) {
    for (var x = 0.0; x < pixels; x += 1.0) {
      let at = begin + floor(vec2f(x, y) * stride);
      if (all(at < end)) {
        sum += pixelError(vec2i(at));
      }
    }
  }
  return sum;
}

fn pixelError(at: vec2i) -> vec4f {
  let sums = textureLoad(film, at, 0);
  let n = max(sums.a, 2.0);
  let mean = sums.rgb / n;
  let variance = max(textureLoad(filmSquares, at, 0).rgb / n - mean * mean, vec3f(0.0)) / (n - 1.0);
  return vec4f(dot(mean, vec3f(1.0 / 3.0)), dot(variance, vec3f(1.0 / 3.0)), 1.0, 0.0);
}

struct Display {
  // factor, 2^stops
  exposure: f32,
  // position in TONE_MAPPINGS
  toneMapping: u32,
  // pixels
  filmSize: vec2f,
}
