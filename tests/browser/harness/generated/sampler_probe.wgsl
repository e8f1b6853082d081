// Linked from tests/sampler-probe.wesl by `npm run shaders`. Do not edit.
@fragment fn samplerProbe(@builtin(position) fragment: vec4f) -> @location(0) vec4f {
  let order = frame.panels[0];
  var s = startSampler(vec2u(fragment.xy) + order.zw, frame.sampleIndex, frame.seed);
  s.key += order.x;
  if (order.y == 0u) {
    return vec4f(filterOffset(next2d(&s)), 0.0, 0.0);
  }
  if (order.y == 1u) {
    return vec4f(next1d(&s), 0.0, 0.0, 0.0);
  }
  if (order.y == 2u) {
    return vec4f(next2d(&s), 0.0, 0.0);
  }
  return vec4f(nextTwo3d(&s).first, 0.0);
}

@group(0) @binding(0) var<uniform> frame: Frame;

fn startSampler(pixel: vec2u, sampleIndex: u32, seed: u32) -> Sampler {
  // Independent numbers come about when each sample of each pixel has its own sequence, and only the first point of it is used.
  let independent = frame.independent != 0u;
  let hash = pixelHash(select(pixel >> vec2u(4u), pixel, independent), select(sampleIndex >> 16u, sampleIndex, independent), seed);
  let place = spread(pixel.x & 15u) | (spread(pixel.y & 15u) * 2u);
  let digits = select(reversed(vec2u(sampleIndex & 0xffffu, place * 256u)), vec2u(0u), independent);
  return Sampler(hash, mixBits(hash ^ 0x6a09e667u), digits.x, digits.y);
}

fn nextTwo3d(s: ptr<function, Sampler>) -> TwoPoints {
  let g = nextGroups(*s);
  (*s).key = (*s).key + 2u;
  let x = firstOf(g);
  let y = secondOf(g);
  let z = thirdOf(g);
  return TwoPoints(vec3f(x.x, y.x, z.x), vec3f(x.y, y.y, z.y));
}

// From the centre of the pixel, in pixels.
fn filterOffset(u: vec2f) -> vec2f {
  var offset = u - 0.5;
  if (hasFilter) {
    offset = vec2f(filterAxis(u.x), filterAxis(u.y));
  }
  return offset;
}

fn next2d(s: ptr<function, Sampler>) -> vec2f {
  let g = nextGroups(*s);
  skipGroup(s);
  return vec2f(firstOf(g).x, secondOf(g).x);
}

override hasFilter = false;

// Inverse of the filter's distribution along one axis. Folded at the middle; the square root straightens the tail, where a filter that
// ends at 0 has an inverse of infinite slope. pack-filter.ts makes the pieces and bounds their error.
fn filterAxis(u: f32) -> f32 {
  let across = 2.0 * u - 1.0;
  let x = 16.0 - 16.0 * sqrt(1.0 - abs(across));
  let piece = min(floor(x), 15.0);
  let t = x - piece;
  let c = frame.filterPieces[u32(piece)];
  let offset = c.x + t * (c.y + t * (c.z + t * c.w));
  return select(offset, -offset, across < 0.0);
}

// The next one and the one after that, neither of them taken yet.
fn nextGroups(s: Sampler) -> Groups {
  let a = mixBits2(s.key + vec2u(1u, 2u));
  let half = (a ^ vec2u(s.salt)) * 0x9e3779b1u;
  let b = half ^ (half >> vec2u(16u));
  let place = scramble(vec2u(s.place), b);
  // A product with an even number reaches only bits above the lowest one that is set. So the flips that decide where a run of the first
  // 2^m samples goes are the tile's, and the union of such runs is a net; all other flips are the pixel's own, or else the errors that
  // come from two groups together would be the same all over the tile.
  let own = s.sample * ((place >> vec2u(7u)) & vec2u(0xfffffffeu));
  let index = reversed(scramble(vec2u(s.sample) ^ own, a) & vec2u(0xffffu));
  return Groups(index, shiftOfPlace(place & vec2u(0xffu)), (a >> vec2u(16u)) | (a * 65536u), (b >> vec2u(16u)) | (b * 65536u));
}

fn skipGroup(s: ptr<function, Sampler>) {
  (*s).key = (*s).key + 1u;
}

// The first number of either group, the second, and the third.
fn firstOf(g: Groups) -> vec2f {
  return toUnit(scramble(g.index ^ g.shift, g.seedA));
}

fn secondOf(g: Groups) -> vec2f {
  return toUnit(scramble(pascal(g.index ^ timesW(g.shift)), g.seedB));
}

struct Sampler {
  // Goes up by one with each group of dimensions.
  key: u32,
  salt: u32,
  // Last 16 bits of the sample index, reversed.
  sample: u32,
  // Where the pixel lies on the Morton curve of its tile of 16 x 16, 8 bits, reversed.
  place: u32,
}


// A hash without the shift by a variable of pcg, which takes a software rasteriser longer than all the rest of it:
// C. Wellons, "Prospecting for Hash Functions", 2018, with the constants found by T. Ettinger.
fn mixBits2(x: vec2u) -> vec2u {
  var y = (x ^ (x >> vec2u(16u))) * 0x21f0aaadu;
  y = (y ^ (y >> vec2u(15u))) * 0x735a2d97u;
  return y ^ (y >> vec2u(15u));
}

// Nested uniform scrambling of a number whose most significant digit is bit 0: each bit is flipped by a hash of the bits below.
// Laine & Karras, "Stratified Sampling for Stochastic Transparency", EGSR 2011, with the constants of N. Vegdahl, "Building a
// Better LK Hash", 2021; as Owen scrambling: Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020.
fn scramble(x: vec2u, seed: vec2u) -> vec2u {
  var y = x ^ (x * 0x3d20adeau);
  y = (y + seed) * ((seed >> vec2u(16u)) | vec2u(1u));
  y ^= y * 0x05526c56u;
  return y ^ (y * 0x53a22864u);
}

fn reversed(x: vec2u) -> vec2u {
  return reverseBits(x) >> vec2u(16u);
}

// Padded sequences, two side by side: what all dimensions of each have in common. In Windows' shader compiler one operation with two
// numbers takes half the time of two operations; all others make the same of both.
struct Groups {
  // Shuffled sample index.
  index: vec2u,
  // What sets this pixel apart from its neighbours.
  shift: vec2u,
  seedA: vec2u,
  seedB: vec2u,
}


// Pascal's triangle over the field of four, binomial(c, r) w^(c - r), of eight digits (pairs of bits), where the four in x are the
// last ones.
fn shiftOfPlace(x: vec2u) -> vec2u {
  var y = x ^ timesW((x >> vec2u(2u)) & vec2u(0x33u));
  y ^= timesW2((y >> vec2u(4u)) & vec2u(0x0fu));
  return timesW(y) | (y * 256u);
}

// Pairs of bits as elements of the field of four, times its generator: w (a w + b) = (a + b) w + a; and times w^2 = w + 1.
fn timesW(x: vec2u) -> vec2u {
  return ((x ^ (x * 2u)) & vec2u(0xaaaau)) | ((x >> vec2u(1u)) & vec2u(0x5555u));
}

fn timesW2(x: vec2u) -> vec2u {
  return ((x * 2u) & vec2u(0xaaaau)) | ((x ^ (x >> vec2u(1u))) & vec2u(0x5555u));
}

fn toUnit(scrambled: vec2u) -> vec2f {
  return vec2f(((reverseBits(scrambled) >> vec2u(8u)) & vec2u(0xffff00u)) | (scrambled >> vec2u(24u))) * 5.9604644775390625e-8;
}

// Second dimension of the Sobol sequence: Pascal's triangle modulo 2, which is a product of four sparse matrices.
fn pascal(x: vec2u) -> vec2u {
  var y = x ^ ((x >> vec2u(1u)) & vec2u(0x5555u));
  y ^= (y >> vec2u(2u)) & vec2u(0x3333u);
  y ^= (y >> vec2u(4u)) & vec2u(0x0f0fu);
  return y ^ ((y >> vec2u(8u)) & vec2u(0x00ffu));
}

fn next1d(s: ptr<function, Sampler>) -> f32 {
  let x = firstOf(nextGroups(*s));
  skipGroup(s);
  return x.x;
}

struct Frame {
  // camera r times half the width of what is seen: camera.wesl
  right: vec3f,
  // of the whole picture, pixels
  width: f32,
  // camera u times half the height of what is seen
  up: vec3f,
  // of the whole picture, pixels
  height: f32,
  // camera f
  forward: vec3f,
  // lights in use
  lightCount: u32,
  // sky colour at the horizon; in paths the map of the sky is multiplied by it
  horizon: vec3f,
  // film sample, from 0
  sampleIndex: u32,
  // sky colour overhead; likewise
  zenith: vec3f,
  // of the random numbers
  seed: u32,
  // position inside the pixel, 0 to 1
  jitter: vec2f,
  // columns of the picture where the second and third panel begin
  dividers: vec2f,
  // index past the last sphere, box, quad and plane
  shapeEnds: vec4u,
  // index past the last shape that may stand between a light and a point
  occluderEnd: u32,
  // balls of lights that camera and mirrors see; their rows come after those of the shapes
  ballCount: u32,
  // emitters of the path integrator
  emitterCount: u32,
  // path segments from the camera on; 0xffffffff: no limit
  maxDepth: u32,
  // per panel: max reflections, light samples, unused, unused
  panels: array<vec4u, 3>,
  // pixel filter: coefficients of cubic polynomials, from the centre of the pixel outwards
  filterPieces: array<vec4f, 16>,
  // 1: independent random numbers instead of the Sobol sequence
  independent: u32,
  // position in PROJECTIONS
  projection: u32,
  // radius of the lens, metres
  aperture: f32,
  // from the eye to the plane that is sharp, metres
  focusDistance: f32,
  // 1: rays of the camera start on both sides of a plane, so that planes have no side of the eye
  planesCutView: u32,
  // how far the map of the sky is turned about +Y, 0 to 1
  environmentTurn: f32,
  // columns and rows of the map of the sky
  environmentSize: vec2f,
  // film samples that this call adds, from sampleIndex on; 1 where passes draw
  sampleCount: u32,
  // row of the first instance of a mesh; the tree over them begins in row 0
  instances: u32,
  // threads that share the samples of a pixel
  shares: u32,
  // pixels of a workgroup
  tile: vec2u,
  // instances of meshes
  instanceCount: u32,
  // emitters that are infinitely far: they come first
  farEmitters: u32,
  // row of the root of the light tree
  lightTree: u32,
  // of the scene table, the whole table being 1
  rowHeight: f32,
  // what one row is of the texture of the geometry, all of it being 1: gpu/device.ts, shareOfRow
  geometryShare: f32,
  // of that of the texels
  texelShare: f32,
  // levels of it; 0: there is none, and all emitters are looked at
  lightTreeDepth: u32,
  // row of the geometry where the tables of lamps begin
  lampTables: u32,
  // column and row of the picture that the first texel of the film holds
  origin: vec2u,
  // row of the film whose paths lie in the first row of their textures: path_relay.wesl
  relayRow: u32,
}


fn pixelHash(pixel: vec2u, sampleIndex: u32, seed: u32) -> u32 {
  return pcg(pixel.x + pcg(pixel.y + pcg(sampleIndex + pcg(seed))));
}

// Bits 0 to 3 of x to the even places.
fn spread(x: u32) -> u32 {
  let y = (x | (x * 4u)) & 0x33u;
  return (y | (y * 2u)) & 0x55u;
}

fn mixBits(x: u32) -> u32 {
  return mixBits2(vec2u(x)).x;
}

// Random numbers as a pure function of what they are for. PCG-RXS-M-XS-32 as a hash: Jarzynski & Olano, "Hash Functions for
// GPU Rendering", JCGT 9(3), 2020.
fn pcg(x: u32) -> u32 {
  let s = x * 747796405u + 2891336453u;
  let w = ((s >> ((s >> 28u) + 4u)) ^ s) * 277803737u;
  return (w >> 22u) ^ w;
}

fn thirdOf(g: Groups) -> vec2f {
  return toUnit(scramble(pascalW2(g.index ^ timesW2(g.shift)), g.seedA ^ (g.seedB * 0x9e3779b1u)));
}

// Three numbers of each of the next two groups.
struct TwoPoints {
  first: vec3f,
  second: vec3f,
}


// The same with w^2 in place of w, of any eight digits.
fn pascalW2(x: vec2u) -> vec2u {
  var y = x ^ timesW2((x >> vec2u(2u)) & vec2u(0x3333u));
  y ^= timesW((y >> vec2u(4u)) & vec2u(0x0f0fu));
  return y ^ timesW2((y >> vec2u(8u)) & vec2u(0x00ffu));
}
