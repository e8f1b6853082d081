// Linked from integrator/path/path_relay.wesl by `npm run shaders`. Do not edit.
// A path between two rounds.
@group(0) @binding(16) var path0: texture_2d<u32>;

@group(0) @binding(17) var path1: texture_2d<u32>;

@group(0) @binding(18) var path2: texture_2d<u32>;

@group(0) @binding(19) var path3: texture_2d<u32>;

@group(0) @binding(20) var path4: texture_2d<u32>;

@group(0) @binding(21) var path5: texture_2d<u32>;

@group(0) @binding(22) var path6: texture_2d<u32>;

@group(0) @binding(23) var path7: texture_2d<u32>;

struct PathWords {
  // Where its rays start: the point, and the shape that it lies on.
  @location(0) start: vec4u,
  // Of its own ray, and flags.
  @location(1) direction: vec4u,
  // Of the ray to a light, and how far away that is.
  @location(2) toLight: vec4u,
  // What the light brings, and the shape that it is.
  @location(3) light: vec4u,
  // And the density.
  @location(4) throughput: vec4u,
  // And the odds' total.
  @location(5) litSide: vec4u,
  // And the odds of the tree.
  @location(6) radiance: vec4u,
  // Instance and triangle that it lies on, key of the sampler.
  @location(7) numbers: vec4u,
}


// What its rays have met.
@group(0) @binding(24) var hit0: texture_2d<u32>;

@group(0) @binding(25) var hit1: texture_2d<u32>;

struct HitWords {
  // Distance, shape, instance, triangle.
  @location(0) met: vec4u,
  // Weights, and whether the light is hidden; or that the path is over.
  @location(1) more: vec4u,
}


// The light that was chosen, and all else that scattering needs: it draws into the path's textures and cannot read them.
@group(0) @binding(26) var choice0: texture_2d<u32>;

@group(0) @binding(27) var choice1: texture_2d<u32>;

@group(0) @binding(28) var choice2: texture_2d<u32>;

@group(0) @binding(29) var choice3: texture_2d<u32>;

@group(0) @binding(30) var choice4: texture_2d<u32>;

@group(0) @binding(31) var choice5: texture_2d<u32>;

@group(0) @binding(32) var choice6: texture_2d<u32>;

@group(0) @binding(33) var choice7: texture_2d<u32>;

struct ChoiceWords {
  // As a path's.
  @location(0) start: vec4u,
  @location(1) direction: vec4u,
  // To the light, and how far away it is; where the ray escaped, the side that is lit of the vertex before.
  @location(2) toLight: vec4u,
  // Radiance and density.
  @location(3) light: vec4u,
  @location(4) throughput: vec4u,
  // Numbers for scattering, and the key of the sampler.
  @location(5) u: vec4u,
  @location(6) radiance: vec4u,
  // Shape of the light, the odds' total, whether it is one without size.
  @location(7) numbers: vec4u,
}


const aliveFlag = 1u;

const inwardsFlag = 2u;

const lightInwardsFlag = 4u;

const escapedFlag = 8u;

const overFlag = 16u;

const depthShift = 8u;

// Of HitWords.more.z
const isHidden = 1u;

const isDone = 2u;

fn words(v: vec3f, w: u32) -> vec4u {
  return vec4u(bitcast<vec3u>(v), w);
}

fn wordsOf(v: vec3f, w: f32) -> vec4u {
  return bitcast<vec4u>(vec4f(v, w));
}

fn vectorOf(words: vec4u) -> vec3f {
  return bitcast<vec3f>(words.xyz);
}

fn flagsOf(p: Path) -> u32 {
  return select(0u, aliveFlag, p.rays.goesOn) | select(0u, inwardsFlag, p.rays.inwards) | select(0u, lightInwardsFlag, p.rays.lightInwards) | select(0u, escapedFlag, p.escaped) | select(0u, overFlag, isOver(p)) | (p.depth << depthShift);
}

// Of the picture: where the texel of a path belongs.
fn pixelOf(texel: vec2u) -> vec2u {
  return frame.origin + texel + vec2u(0u, frame.relayRow);
}

fn samplerAt(texel: vec2u, key: u32) -> Sampler {
  var s = startSampler(pixelOf(texel), frame.sampleIndex, frame.seed);
  s.key = key;
  return s;
}

fn written(p: Path) -> PathWords {
  let rays = p.rays;
  return PathWords(words(rays.point, rays.shape), words(rays.direction, flagsOf(p)), wordsOf(rays.lightDirection, rays.lightDistance), words(p.light, rays.lightShape), wordsOf(p.throughput, p.pdf), wordsOf(p.litSide, p.odds.total), wordsOf(p.radiance, p.odds.tree), vec4u(rays.left.instance, rays.left.triangle, p.sampler.key, 0u));
}

fn pathAt(texel: vec2u) -> Path {
  let start = textureLoad(path0, texel, 0);
  let direction = textureLoad(path1, texel, 0);
  let toLight = bitcast<vec4f>(textureLoad(path2, texel, 0));
  let light = textureLoad(path3, texel, 0);
  let throughput = bitcast<vec4f>(textureLoad(path4, texel, 0));
  let litSide = bitcast<vec4f>(textureLoad(path5, texel, 0));
  let radiance = bitcast<vec4f>(textureLoad(path6, texel, 0));
  let numbers = textureLoad(path7, texel, 0);
  let flags = direction.w;
  let point = vectorOf(start);
  let alive = (flags & aliveFlag) != 0u;
  let s = samplerAt(texel, numbers.z);
  let rays = RayPair(point, start.w, LeftTriangle(numbers.x, numbers.y), tMinAt(point, flags), alive, vectorOf(direction), (flags & inwardsFlag) != 0u, toLight.xyz, (flags & lightInwardsFlag) != 0u, toLight.w, light.w, numberOfNext(s));
  return Path(rays, vectorOf(light), throughput.xyz, (flags & escapedFlag) != 0u, flags >> depthShift, radiance.xyz, throughput.w, litSide.xyz, Odds(litSide.w, radiance.w), s);
}

// On the lens, where paths begin, it is 0.
fn tMinAt(point: vec3f, flags: u32) -> f32 {
  return select(relativeTMin * length(point), 0.0, (flags >> depthShift) == 1u);
}

fn hitAt(texel: vec2u) -> PairHit {
  let met = textureLoad(hit0, texel, 0);
  let more = textureLoad(hit1, texel, 0);
  return PairHit(bitcast<f32>(met.x), met.y, more.z == isHidden, LeftTriangle(met.z, met.w), bitcast<vec2f>(more.xy));
}

fn wasOver(texel: vec2u) -> bool {
  return textureLoad(hit1, texel, 0).z == isDone;
}

@fragment fn pathBegin(@builtin(position) fragment: vec4f) -> PathWords {
  var p = noPath();
  startPath(&p, pixelOf(vec2u(fragment.xy)), frame.sampleIndex);
  return written(p);
}

@fragment fn pathTrace(@builtin(position) fragment: vec4f) -> HitWords {
  let texel = vec2u(fragment.xy);
  var words = HitWords(vec4u(0u), vec4u(0u, 0u, isDone, 0u));
  if ((textureLoad(path1, texel, 0).w & overFlag) == 0u) {
    let hit = tracePair(pathAt(texel).rays);
    words = HitWords(vec4u(bitcast<u32>(hit.t), hit.shape, hit.triangle.instance, hit.triangle.triangle), vec4u(bitcast<vec2u>(hit.weights), select(0u, isHidden, hit.blocked), 0u));
  }
  return words;
}

@fragment fn pathLight(@builtin(position) fragment: vec4f) -> ChoiceWords {
  let texel = vec2u(fragment.xy);
  if (wasOver(texel)) {
    discard;
  }
  let hit = hitAt(texel);
  var p = pathAt(texel);
  p.radiance += select(p.light, vec3f(0.0), hit.blocked);
  p.escaped = p.escaped | (p.rays.goesOn & (hit.shape == noShape));
  p.rays.goesOn = p.rays.goesOn & !p.escaped;
  let start = words(p.rays.point, p.rays.shape);
  let direction = words(p.rays.direction, flagsOf(p));
  let throughput = wordsOf(p.throughput, p.pdf);
  var lit = Lit(LightSample(p.litSide, 0.0, vec3f(0.0), 0.0, false), 0.0, -1.0, p.odds, vec3f(0.0));
  if (p.rays.goesOn) {
    lit = lightAt(&p, hit, meetingAt(&p, hit));
  }
  return ChoiceWords(start, direction, wordsOf(lit.light.direction, lit.light.distance), wordsOf(lit.light.radiance, lit.pdf), throughput, words(lit.u, p.sampler.key), wordsOf(p.radiance, lit.odds.tree), vec4u(bitcast<u32>(lit.shape), bitcast<u32>(lit.odds.total), select(0u, 1u, lit.light.delta), 0u));
}

@fragment fn pathScatter(@builtin(position) fragment: vec4f) -> PathWords {
  let texel = vec2u(fragment.xy);
  if (wasOver(texel)) {
    discard;
  }
  let hit = hitAt(texel);
  let start = textureLoad(choice0, texel, 0);
  let direction = textureLoad(choice1, texel, 0);
  let toLight = bitcast<vec4f>(textureLoad(choice2, texel, 0));
  let light = bitcast<vec4f>(textureLoad(choice3, texel, 0));
  let throughput = bitcast<vec4f>(textureLoad(choice4, texel, 0));
  let u = textureLoad(choice5, texel, 0);
  let radiance = bitcast<vec4f>(textureLoad(choice6, texel, 0));
  let numbers = textureLoad(choice7, texel, 0);
  let flags = direction.w;
  let alive = (flags & aliveFlag) != 0u;
  let point = vectorOf(start);
  let odds = Odds(bitcast<f32>(numbers.y), radiance.w);
  let rays = RayPair(point, start.w, noTriangle, tMinAt(point, flags), alive, vectorOf(direction), (flags & inwardsFlag) != 0u, toLight.xyz, false, -1.0, noShape, 0u);
  var p = Path(rays, vec3f(0.0), throughput.xyz, (flags & escapedFlag) != 0u, flags >> depthShift, radiance.xyz, throughput.w, toLight.xyz, odds, samplerAt(texel, u.w));
  if (alive) {
    let sample = LightSample(toLight.xyz, toLight.w, light.xyz, light.w, numbers.z != 0u);
    scatter(&p, hit, meetingAt(&p, hit), Lit(sample, light.w, bitcast<f32>(numbers.x), odds, vectorOf(u)));
  }
  return written(p);
}

@fragment fn pathEnd(@builtin(position) fragment: vec4f) -> Film {
  let texel = vec2u(fragment.xy);
  var p = pathAt(texel - vec2u(0u, frame.relayRow));
  addFarLight(&p);
  var film = Film(vec4f(0.0), vec4f(0.0));
  if (frame.sampleIndex > 0u) {
    film = Film(textureLoad(previousFilm, texel, 0), textureLoad(previousSquares, texel, 0));
  }
  return Film(film.sums + vec4f(p.radiance, 1.0), film.squares + vec4f(p.radiance * p.radiance, 0.0));
}

// Whether there is a ray left to trace.
fn isOver(p: Path) -> bool {
  return !p.rays.goesOn & (p.rays.lightDistance < 0.0);
}

struct Path {
  rays: RayPair,
  // What the light ray brings to the pixel if nothing is in its way.
  light: vec3f,
  throughput: vec3f,
  // Whether its ray has met nothing: addFarLight.
  escaped: bool,
  depth: u32,
  radiance: vec3f,
  // Density of the present direction by the BSDF, per steradian; 0: only the BSDF could find it.
  pdf: f32,
  // For the probability with which light sampling at the last vertex would have chosen an emitter: the side that is lit, zero
  // where both are, and what the others' estimates were.
  litSide: vec3f,
  odds: Odds,
  sampler: Sampler,
}


struct RayPair {
  point: vec3f,
  // The shape that the point lies on. A ray that leaves it outwards (or a flat one) does not meet it at once; of one that goes
  // inwards only its far side counts.
  shape: u32,
  // Of a mesh: the triangle, which no ray that leaves it meets.
  left: LeftTriangle,
  // ray.wesl, Start.tMin
  tMin: f32,
  // Whether the path's ray is wanted.
  goesOn: bool,
  direction: vec3f,
  inwards: bool,
  lightDirection: vec3f,
  lightInwards: bool,
  // What is met farther away than this stands behind the light. Negative: there is no ray to a light.
  lightDistance: f32,
  // The shape that is the light, or noShape.
  lightShape: u32,
  // For what is there by chance: sampler.wesl, numberOfNext.
  number: u32,
}


// What `listedProbability` has to know of the point.
struct Odds {
  // The sum of the estimates of all emitters that are looked at one by one.
  total: f32,
  // Probability to take one out of the tree.
  tree: f32,
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


// A triangle of an instance: such as a ray starts on; it is flat, so that no ray meets it again.
struct LeftTriangle {
  instance: u32,
  triangle: u32,
}


@group(0) @binding(0) var<uniform> frame: Frame;

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


fn startSampler(pixel: vec2u, sampleIndex: u32, seed: u32) -> Sampler {
  // Independent numbers come about when each sample of each pixel has its own sequence, and only the first point of it is used.
  let independent = frame.independent != 0u;
  let hash = pixelHash(select(pixel >> vec2u(4u), pixel, independent), select(sampleIndex >> 16u, sampleIndex, independent), seed);
  let place = spread(pixel.x & 15u) | (spread(pixel.y & 15u) * 2u);
  let digits = select(reversed(vec2u(sampleIndex & 0xffffu, place * 256u)), vec2u(0u), independent);
  return Sampler(hash, mixBits(hash ^ 0x6a09e667u), digits.x, digits.y);
}

fn pixelHash(pixel: vec2u, sampleIndex: u32, seed: u32) -> u32 {
  return pcg(pixel.x + pcg(pixel.y + pcg(sampleIndex + pcg(seed))));
}

// Bits 0 to 3 of x to the even places.
fn spread(x: u32) -> u32 {
  let y = (x | (x * 4u)) & 0x33u;
  return (y | (y * 2u)) & 0x55u;
}

fn reversed(x: vec2u) -> vec2u {
  return reversedHigh(x) >> vec2u(15u);
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

// What the sampler does to the bits of its numbers. docs/sampler.md says why.
// A software rasteriser takes its lanes apart for a shift, so what can be a product is one here; GPUs make shifts of products with powers of 2.
// Sixteen bits in reverse order, times 2^15, below which there are zeros: what comes last of two neighbours, pairs, nibbles and bytes stays
// where it is, and what comes first goes past it. Only WebGL2 needs it: WGSL has reverseBits.
fn reversedHigh(x: vec2u) -> vec2u {
  var y = x + (x & vec2u(0x5555u)) * 3u;
  y += (y & vec2u(0x6666u)) * 15u;
  y += (y & vec2u(0x7878u)) * 255u;
  return y + (y & vec2u(0x7f80u)) * 65535u;
}

// A hash without the shift by a variable of pcg, which takes a software rasteriser longer than all the rest of it:
// C. Wellons, "Prospecting for Hash Functions", 2018, with the constants found by T. Ettinger.
fn mixBits2(x: vec2u) -> vec2u {
  var y = (x ^ (x >> vec2u(16u))) * 0x21f0aaadu;
  y = (y ^ (y >> vec2u(15u))) * 0x735a2d97u;
  return y ^ (y >> vec2u(15u));
}

// What is drawn next has a number, by which many others may be made that belong to it: hashed with whatever tells them apart.
fn numberOfNext(s: Sampler) -> u32 {
  return mixBits(mixBits((s.key + 1u) ^ s.salt ^ 0x85ebca6bu) + ((s.sample << 8u) | s.place));
}

// Float rounding of a point grows with its distance from the eye, where all positions are relative to.
const relativeTMin = 1e-5;

struct PairHit {
  // Where the path's ray ends: the distance, `miss` when there is nothing, and the shape.
  t: f32,
  shape: u32,
  // Whether the light is hidden.
  blocked: bool,
  // Of a mesh: which triangle, and how much its second and third vertex count.
  triangle: LeftTriangle,
  weights: vec2f,
}


// Over before it has begun.
fn noPath() -> Path {
  var p: Path;
  p.rays.lightDirection = vec3f(0.0, 1.0, 0.0);
  p.rays.lightDistance = -1.0;
  return p;
}

// In place of a path that is over. What its first step does not ask for stays as it was: Windows' shader compiler takes the longer for a
// loop the more values there are that one branch in it sets.
fn startPath(p: ptr<function, Path>, pixel: vec2u, sampleIndex: u32) {
  (*p).sampler = startSampler(pixel, sampleIndex, frame.seed);
  let filmPosition = vec2f(pixel) + 0.5 + filterOffset(next2d(&(*p).sampler));
  let camera = cameraRay(filmPosition, lensPoint(&(*p).sampler));
  (*p).rays.point = camera.origin;
  (*p).rays.shape = noShape;
  (*p).rays.left = noTriangle;
  (*p).rays.tMin = 0.0;
  (*p).rays.goesOn = true;
  (*p).rays.direction = camera.direction;
  (*p).rays.number = numberOfNext((*p).sampler);
  (*p).light = vec3f(0.0);
  (*p).throughput = vec3f(1.0);
  (*p).depth = 1u;
  (*p).radiance = vec3f(0.0);
  (*p).pdf = 0.0;
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

// `lens`: two random numbers in 0 … 1.
fn cameraRay(filmPosition: vec2f, lens: vec2f) -> CameraRay {
  var lensPoint = vec2f(0.0);
  if (hasLens) {
    lensPoint = concentricDisc(lens);
  }
  return rayThroughLens(filmPosition, lensPoint);
}

// The second draw of a sample, from whichever camera: what comes after it is the same.
fn lensPoint(s: ptr<function, Sampler>) -> vec2f {
  var u = vec2f(0.5);
  if (hasLens) {
    u = next2d(s);
  } else {
    skipGroup(s);
  }
  return u;
}

// A ray knows where it comes from, so that a surface is never met by its own ray again: no offset along the normal,
// nothing that depends on the size of the scene.
const noShape = 0xffffffffu;

const noTriangle = LeftTriangle(noInstance, 0u);

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

// Nested uniform scrambling of a number whose most significant digit is bit 0: each bit is flipped by a hash of the bits below.
// Laine & Karras, "Stratified Sampling for Stochastic Transparency", EGSR 2011, with the constants of N. Vegdahl, "Building a
// Better LK Hash", 2021; as Owen scrambling: Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020.
fn scramble(x: vec2u, seed: vec2u) -> vec2u {
  var y = x ^ (x * 0x3d20adeau);
  y = (y + seed) * ((seed >> vec2u(16u)) | vec2u(1u));
  y ^= y * 0x05526c56u;
  return y ^ (y * 0x53a22864u);
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

// Scrambled numbers in [0, 1): their first 16 digits, which lie in reverse order, and the 8 highest bits, which need none. Both ways are
// exact.
fn toUnit(scrambled: vec2u) -> vec2f {
  let digits = vec2f(vec2i(reversedHigh(scrambled & vec2u(0xffffu)))) * 4.656612873077392578125e-10;
  return digits + vec2f(scrambled & vec2u(0xff000000u)) * 3.552713678800501e-15;
}

// Second dimension of the Sobol sequence: Pascal's triangle modulo 2, which is a product of four sparse matrices.
fn pascal(x: vec2u) -> vec2u {
  var y = x ^ ((x >> vec2u(1u)) & vec2u(0x5555u));
  y ^= (y >> vec2u(2u)) & vec2u(0x3333u);
  y ^= (y >> vec2u(4u)) & vec2u(0x0f0fu);
  return y ^ ((y >> vec2u(8u)) & vec2u(0x00ffu));
}

// Cameras other than pinholes, filters other than the box.
override hasLens = false;

// The ray through a point of the film, in pixels, row 0 on top, and through a point of the lens, in units of its radius. From the
// middle of the lens it is the pinhole's to the last digit.
fn rayThroughLens(filmPosition: vec2f, lensPoint: vec2f) -> CameraRay {
  let x = 2.0 * filmPosition.x / frame.width - 1.0;
  let y = 1.0 - 2.0 * filmPosition.y / frame.height;
  let across = x * frame.right + y * frame.up;
  let orthographic = hasOtherProjections & (frame.projection == 1u);
  let ahead = select(frame.forward + across, frame.forward, orthographic);
  let lens = frame.aperture * (lensPoint.x * normalize(frame.right) + lensPoint.y * normalize(frame.up));
  // All rays of a film point meet where ahead, made as long as the focus is far, ends.
  var ray = CameraRay(select(lens, across + lens, orthographic), normalize(ahead - lens / frame.focusDistance));
  if (hasOtherProjections) {
    if (frame.projection == 2u) {
      let longitude = pi * x;
      let latitude = 0.5 * pi * y;
      let level = sin(longitude) * frame.right + cos(longitude) * frame.forward;
      // A GPU's sine may be off by 2^-11, and intersections rely on the length of 1.
      ray = CameraRay(vec3f(0.0), normalize(cos(latitude) * level + sin(latitude) * frame.up));
    }
  }
  return ray;
}

// From the unit square to the unit disc, without tearing it or changing the share of area (Shirley & Chiu, "A Low Distortion Map
// Between Disk and Square", 1997).
fn concentricDisc(u: vec2f) -> vec2f {
  let p = 2.0 * u - 1.0;
  let wide = abs(p.x) > abs(p.y);
  let radius = select(p.y, p.x, wide);
  // Where both are 0, so is the radius, and the angle does not matter.
  let ratio = select(p.x, p.y, wide) / select(radius, 1.0, radius == 0.0);
  let angle = select(0.5 * pi - 0.25 * pi * ratio, 0.25 * pi * ratio, wide);
  return radius * vec2f(cos(angle), sin(angle));
}

const pi = 3.14159265358979;

override hasOtherProjections = false;

struct CameraRay {
  origin: vec3f,
  direction: vec3f,
}


const noInstance = 0xffffffffu;

// Loops end with their condition: ARCHITECTURE.md, "No loop in a kernel that asks at its head".
fn tracePair(p: RayPair) -> PairHit {
  var found = PairHit(miss, noShape, false, noTriangle, vec2f(0.0));
  let ends = frame.shapeEnds;
  var i = 0u;
  if (hasSpheres) {
    if (i < ends.x) {
      loop {
        found = meetSphere(found, p, i);
        i++;
        if (i >= ends.x) {
          break;
        }
      }
    }
  }
  if (hasBoxes) {
    if (i < ends.y) {
      loop {
        found = meetBox(found, p, i);
        i++;
        if (i >= ends.y) {
          break;
        }
      }
    }
  }
  if (hasQuads) {
    if (i < ends.z) {
      loop {
        found = meetQuad(found, p, i);
        i++;
        if (i >= ends.z) {
          break;
        }
      }
    }
  }
  if (hasPlanes) {
    if (i < ends.w) {
      loop {
        found = meetPlane(found, p, i);
        i++;
        if (i >= ends.w) {
          break;
        }
      }
    }
  }
  if (hasMeshes) {
    found = meetMeshes(found, p);
  }
  return found;
}

const miss = 1e30;

// What a scene may ask of the path kernel. Whoever makes a program says what its scenes have (integrator/path/path-features.ts), and the
// compiler leaves the rest out: a software rasteriser runs both sides of every branch, Windows' shader compiler pays for every line,
// and a GPU for every register. On WebGL2 these become `const` in the GLSL. As they stand here they are what most scenes made of
// shapes and lights need: the program that a page compiles first.
// Kinds of shape, and boxes that do not lie along the axes.
override hasSpheres = true;

override hasBoxes = true;

override hasQuads = false;

override hasPlanes = true;

// Triangle meshes, and such with shading normals of their own.
override hasMeshes = false;

fn meetSphere(found: PairHit, p: RayPair, i: u32) -> PairHit {
  let b = fetchBounds(i);
  let own = i == p.shape;
  let t = intersectSphere(p.point, p.direction, b.center, b.radius, p.tMin, own & p.inwards);
  let lightT = intersectSphere(p.point, p.lightDirection, b.center, b.radius, p.tMin, own & p.lightInwards);
  return meet(found, p, i, vec2f(t, lightT));
}

fn fetchBounds(i: u32) -> Bounds {
  let t0 = tableTexel(0u, i);
  return Bounds(t0.xyz, t0.w);
}

fn intersectSphere(origin: vec3f, direction: vec3f, center: vec3f, radius: f32, tMin: f32, startsInside: bool) -> f32 {
  let toCenter = center - origin;
  let along = dot(toCenter, direction);
  let across = toCenter - along * direction;
  let discriminant = radius * radius - dot(across, across);
  let half = sqrt(max(discriminant, 0.0));
  let near = along - half;
  let far = along + half;
  let t = select(far, near, near > tMin);
  // From the surface itself the far side cannot be missed, whatever rounding says.
  return select(select(miss, t, (discriminant >= 0.0) & (t > tMin)), max(far, 0.0), startsInside);
}

// Distances of both rays, path then light, to shape i taken up into what was found so far.
fn meet(found: PairHit, p: RayPair, i: u32, t: vec2f) -> PairHit {
  let own = i == p.shape;
  let pathT = select(t.x, miss, own & !p.inwards);
  let lightT = select(t.y, miss, (own & !p.lightInwards) | (i == p.lightShape));
  let nearer = pathT < found.t;
  return PairHit(select(found.t, pathT, nearer), select(found.shape, i, nearer), found.blocked | (lightT < p.lightDistance), noTriangle, vec2f(0.0));
}

fn tableTexel(column: u32, row: u32) -> vec4f {
  return textureLoad(sceneTable, vec2u(column, row), 0);
}

struct Bounds {
  // centre of the bounding sphere, eye-relative; of a plane: its unit normal
  center: vec3f,
  // of the bounding sphere; of a plane: dot(normal, p) of its points
  radius: f32,
}


@group(0) @binding(1) var sceneTable: texture_2d<f32>;

fn meetBox(found: PairHit, p: RayPair, i: u32) -> PairHit {
  let b = fetchBounds(i);
  let e = fetchExtent(i);
  let own = i == p.shape;
  let origin = turned(e.a, p.point - b.center);
  let t = intersectBox(origin, turned(e.a, p.direction), e.b.xyz, p.tMin, own & p.inwards);
  let lightT = intersectBox(origin, turned(e.a, p.lightDirection), e.b.xyz, p.tMin, own & p.lightInwards);
  return meet(found, p, i, vec2f(t, lightT));
}

fn fetchExtent(i: u32) -> Extent {
  let t0 = tableTexel(1u, i);
  let t1 = tableTexel(2u, i);
  return Extent(t0.xyzw, t1.xyzw);
}

// The same where a pipeline may know that no box is turned.
fn turned(q: vec4f, v: vec3f) -> vec3f {
  var w = v;
  if (hasTurnedBoxes) {
    w = rotate(q, v);
  }
  return w;
}

fn intersectBox(origin: vec3f, direction: vec3f, halfSize: vec3f, tMin: f32, startsInside: bool) -> f32 {
  let s = boxSlabs(origin, direction, halfSize);
  let t = select(s.far, s.near, s.near > tMin);
  // From inside the far side cannot be missed, whatever rounding says of a start on an edge.
  return select(select(miss, t, (s.near <= s.far) & (t > tMin)), max(s.far, 0.0), startsInside);
}

struct Extent {
  // box: rotation from world to box as a quaternion (x, y, z, w); quad: reciprocal of its u edge
  a: vec4f,
  // box: half its size; quad: reciprocal of its v edge
  b: vec4f,
}


override hasTurnedBoxes = true;

// v turned by the unit quaternion q, and back.
fn rotate(q: vec4f, v: vec3f) -> vec3f {
  let t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

fn boxSlabs(origin: vec3f, direction: vec3f, halfSize: vec3f) -> Slabs {
  let inverse = safeReciprocal(direction, origin);
  let middle = -origin * inverse;
  let reach = halfSize * abs(inverse);
  let enter = middle - reach;
  let leave = middle + reach;
  return Slabs(enter, leave, max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}

fn safeReciprocal(d: vec3f, origin: vec3f) -> vec3f {
  let tiny = select(vec3f(1e-18), vec3f(-1e-18), origin > vec3f(0.0));
  return 1.0 / select(d, tiny, abs(d) < vec3f(1e-18));
}

// Where a ray enters and leaves the space between each pair of faces.
struct Slabs {
  enter: vec3f,
  leave: vec3f,
  // Where it enters and leaves the box, when near <= far.
  near: f32,
  far: f32,
}


fn meetQuad(found: PairHit, p: RayPair, i: u32) -> PairHit {
  let b = fetchBounds(i);
  let e = fetchExtent(i);
  let t = intersectQuad(p.point, p.direction, b.center, e.a.xyz, e.b.xyz, p.tMin);
  let lightT = intersectQuad(p.point, p.lightDirection, b.center, e.a.xyz, e.b.xyz, p.tMin);
  return meet(found, p, i, vec2f(t, lightT));
}

fn intersectQuad(origin: vec3f, direction: vec3f, center: vec3f, reciprocalU: vec3f, reciprocalV: vec3f, tMin: f32) -> f32 {
  let normal = cross(reciprocalU, reciprocalV);
  let speed = dot(direction, normal);
  let toCenter = center - origin;
  let t = dot(toCenter, normal) / select(speed, 1e-30, speed == 0.0);
  let p = t * direction - toCenter;
  let reach = 0.5 + quadOverlap;
  let within = max(abs(dot(p, reciprocalU)), abs(dot(p, reciprocalV))) <= reach;
  return select(miss, t, (t > tMin) & (t < miss) & within);
}

// Quads that share an edge overlap by this share of their size instead of leaving a gap for rays to leak through.
const quadOverlap = 1e-6;

fn meetPlane(found: PairHit, p: RayPair, i: u32) -> PairHit {
  let b = fetchBounds(i);
  let t = intersectPlane(p.point, p.direction, b.center, b.radius, p.tMin);
  let lightT = intersectPlane(p.point, p.lightDirection, b.center, b.radius, p.tMin);
  return meet(found, p, i, vec2f(t, lightT));
}

fn intersectPlane(origin: vec3f, direction: vec3f, normal: vec3f, offset: f32, tMin: f32) -> f32 {
  let speed = dot(direction, normal);
  let t = (offset - dot(origin, normal)) / select(speed, parallel, speed == 0.0);
  let speedAway = select(-speed, speed, offset > 0.0);
  let eitherWay = (t > tMin) & (abs(speed) > parallel);
  return select(miss, max(t, 0.0), select(speedAway > parallel, eitherWay, (offset == 0.0) | (frame.planesCutView != 0u)));
}

// Slower than this towards the plane a ray is parallel to it; squares of the farthest hits stay within range.
const parallel = 1e-12;

fn meetMeshes(found: PairHit, p: RayPair) -> PairHit {
  let most = select(-1.0, found.t, p.goesOn);
  let lightMost = select(p.lightDistance, -1.0, found.blocked);
  let hit = traverse(MeshRays(p.point, p.direction, p.lightDirection, p.tMin, most, lightMost, p.number), p.left);
  var result = PairHit(found.t, found.shape, found.blocked | hit.blocked, noTriangle, hit.weights);
  if (hit.instance != noInstance) {
    result.t = hit.t;
    result.shape = rowOfInstance(hit.instance);
    result.triangle = LeftTriangle(hit.instance, hit.triangle);
  }
  return result;
}

// The same where programs draw, for a software rasteriser, which goes through both sides of every `if` and skips only loops and, where no
// ray asks, fetches. So what happens among the instances stands outside of the loop over nodes and triangles, what a triangle changes is
// selected, and the stack is read once a turn: docs/bvh.md. The other one is made for GPUs.
fn traverse(rays: MeshRays, left: LeftTriangle) -> MeshHit {
  var found = MeshHit(rays.most, noInstance, 0u, vec2f(0.0), false);
  var toLight = !(rays.most > 0.0);
  var most = select(rays.most, rays.lightMost, toLight);
  var instance = noInstance;
  var nodes = 0u;
  var triangles = 0u;
  var cover = 0u;
  var own = placeMask;
  var slabs = SlabRay(vec3f(0.0), vec3f(0.0), vec3u(0u));
  var ray = MeshRay(vec3f(0.0), 0u, vec3f(0.0));
  var doubted = found;
  let alone = frame.instanceCount == 1u;
  let first = select(beginning, instances, alone);
  if ((frame.instanceCount == 0u) | !(most > 0.0)) {
    return found;
  }
  stack[0] = ending;
  var top = 1u;
  var current = first;
  var waiting = noLeaf;
  loop {
    if (!hasCutouts | ((waiting == noLeaf) & isAmongInstances(current))) {
      let toWorld = current >= beginning;
      instance = select(current & placeMask, noInstance, toWorld);
      var o = rays.origin;
      var d = select(rays.direction, rays.lightDirection, toLight);
      nodes = 0u;
      if (!toWorld) {
        let i = fetchInstance(frame.instances + instance * instanceRows);
        let p = vec4f(o, 1.0);
        o = vec3f(dot(i.toMeshX, p), dot(i.toMeshY, p), dot(i.toMeshZ, p));
        d = vec3f(dot(i.toMeshX.xyz, d), dot(i.toMeshY.xyz, d), dot(i.toMeshZ.xyz, d));
        nodes = i.nodes;
        triangles = i.triangles;
        cover = i.cover;
        own = select(placeMask, left.triangle, instance == left.instance);
        if (!alone) {
          stack[top] = leaving;
          top++;
        }
      }
      slabs = slabRay(o, d);
      ray = meshRay(o, d);
      current = select(0u, unread, current == leaving);
    }
    loop {
      if (current == unread) {
        top--;
        current = stack[top];
      }
      if (current < instances) {
        let node = nodes + current * nodeRows;
        let r = geometryRow(node + childrenRow);
        let t = bitcast<vec4i>(enterChildren(node, slabs, most));
        // Farthest first onto the stack: a sorting network of five exchanges.
        let a = t.x < t.z;
        let b = t.y < t.w;
        let r0 = select(vec2u(r.x, r.z), vec2u(r.z, r.x), a);
        let r1 = select(vec2u(r.y, r.w), vec2u(r.w, r.y), b);
        let far0 = max(t.x, t.z);
        let far1 = max(t.y, t.w);
        let near0 = min(t.x, t.z);
        let near1 = min(t.y, t.w);
        let ra = select(vec2u(r0.x, r1.x), vec2u(r1.x, r0.x), far0 < far1);
        let rb = select(vec2u(r0.y, r1.y), vec2u(r1.y, r0.y), near0 < near1);
        let far2 = min(far0, far1);
        let near2 = max(near0, near1);
        let rm = select(vec2u(ra.y, rb.x), vec2u(rb.x, ra.y), far2 < near2);
        // What lies above the top does not count.
        stack[top] = ra.x;
        top += select(0u, 1u, max(far0, far1) < notEntered);
        stack[top] = rm.x;
        top += select(0u, 1u, max(far2, near2) < notEntered);
        stack[top] = rm.y;
        top += select(0u, 1u, min(far2, near2) < notEntered);
        current = select(unread, rb.y, min(near0, near1) < notEntered);
      }
      let takes = (waiting == noLeaf) & (current >= leaves);
      waiting = select(waiting, current, takes);
      current = select(current, unread, takes);
      if (waiting != noLeaf) {
        let place = waiting & placeMask;
        waiting = waiting + 1u - (1u << countShift);
        waiting = select(waiting, noLeaf, waiting < leaves);
        let hit = crossTriangle(ray, fetchTriangle(triangles + place * triangleRows));
        var nearer = hit.within & (hit.depth > rays.least * hit.sum) & (hit.depth < most * hit.sum) & (place != own);
        if (hasOneSided) {
          nearer = nearer & (hit.front | ((cover & isOneSided) == 0u));
        }
        let inverse = 1.0 / hit.sum;
        let t = hit.depth * inverse;
        let weights = hit.weights * inverse;
        if (hasCutouts) {
          if (nearer & ((cover & coverRow) != 0u)) {
            doubted = MeshHit(t, instance, place, weights, false);
            nearer = false;
          }
        }
        let blocks = nearer & toLight;
        let counts = nearer & !toLight;
        most = select(most, t, nearer);
        found.t = select(found.t, t, counts);
        found.instance = select(found.instance, instance, counts);
        found.triangle = select(found.triangle, place, counts);
        found.weights = select(found.weights, weights, counts);
        found.blocked = found.blocked | blocks;
        waiting = select(waiting, noLeaf, blocks);
        current = select(current, ending, blocks);
      }
      if (((waiting == noLeaf) & isAmongInstances(current)) | (hasCutouts & (doubted.instance != noInstance))) {
        break;
      }
    }
    if (hasCutouts) {
      if (doubted.instance != noInstance) {
        let there = isThere(doubted.instance, doubted.triangle, doubted.weights, rays.number + u32(toLight));
        let instead = doubted;
        doubted.instance = noInstance;
        if (there & toLight) {
          found.blocked = true;
          break;
        }
        if (there) {
          most = instead.t;
          found = instead;
        }
      }
    }
    let ended = (current == ending) & (waiting == noLeaf);
    if (ended & (toLight | !(rays.lightMost > 0.0))) {
      break;
    }
    toLight = toLight | ended;
    most = select(most, rays.lightMost, ended);
    top = select(top, 1u, ended);
    current = select(current, first, ended);
  }
  return found;
}

struct MeshRays {
  origin: vec3f,
  direction: vec3f,
  lightDirection: vec3f,
  // What is nearer does not count.
  least: f32,
  // Nor what is farther; 0 or less: there is no such ray.
  most: f32,
  lightMost: f32,
  // For what is there by chance: sampler.wesl, numberOfNext.
  number: u32,
}


// Of the scene table.
fn rowOfInstance(instance: u32) -> u32 {
  return fetchInstance(frame.instances + instance * instanceRows).row;
}

fn fetchInstance(row: u32) -> Instance {
  let r0 = geometryRow(row + 0u);
  let r1 = geometryRow(row + 1u);
  let r2 = geometryRow(row + 2u);
  let r3 = geometryRow(row + 3u);
  let r4 = geometryRow(row + 4u);
  return Instance(bitcast<vec4f>(r0.xyzw), bitcast<vec4f>(r1.xyzw), bitcast<vec4f>(r2.xyzw), r3.x, r3.y, r3.z, r3.w, r4.x, r4.y, r4.z, r4.w);
}

const instanceRows = 5u;

fn geometryRow(i: u32) -> vec4u {
  return textureLoad(geometry, vec2i(i32(i & 2047u), i32(f32(i32(i & 0x7ffff800u)) / 2048.0)), 0);
}

struct Instance {
  // from eye-relative places to the space of its mesh: x is dot(xyz, p) + w
  toMeshX: vec4f,
  // y
  toMeshY: vec4f,
  // z
  toMeshZ: vec4f,
  // row of the root of its tree
  nodes: u32,
  // row of its first triangle
  triangles: u32,
  // of the scene table: what it is made of
  row: u32,
  // COVER: where it may not be there
  cover: u32,
  // row of its first vertex
  vertices: u32,
  // of each vertex: Vertex, and VertexMore where that is 2; 0: the mesh has places only
  vertexRows: u32,
  // what is in them: VERTEX_FLAGS
  vertexFlags: u32,
  // unused
  spare0: u32,
}


@group(0) @binding(5) var geometry: texture_2d<u32>;

struct MeshHit {
  t: f32,
  // noInstance: nothing met.
  instance: u32,
  triangle: u32,
  // Of the triangle's second and third vertex.
  weights: vec2f,
  // Whether something is in the light's way.
  blocked: bool,
}


const placeMask = 0x0fffffffu;

// What the slabs of boxes are worked out with.
struct SlabRay {
  inverse: vec3f,
  // -origin * inverse
  offset: vec3f,
  // From a node to the rows that hold the near planes.
  near: vec3u,
}


// A ray in the space of a mesh.
struct MeshRay {
  origin: vec3f,
  // The axis along which the direction is longest: 0, 1 or 2.
  axis: u32,
  // In the axes' order along, next, last becoming x, y, z: what of z to add to x and y, and 1 / the direction's z.
  shear: vec3f,
}


// Among the instances, on the stack: a ray begins, in the world; here it leaves an instance; it ends.
const beginning = 0x8ffffffdu;

// References: encode-wide-bvh.ts. Below `instances` those of nodes, from `leaves` on of leaves.
const instances = 0x80000000u;

// pack-geometry.ts refuses trees that need more. At the bottom lies `ending`.
var<private> stack: array<u32, 64>;

const ending = 0x8fffffffu;

// A leaf that is none.
const noLeaf = 0u;

override hasCutouts = false;

fn isAmongInstances(reference: u32) -> bool {
  return (reference >= instances) & (reference < leaves) & (reference != unread);
}

fn slabRay(origin: vec3f, direction: vec3f) -> SlabRay {
  let inverse = 1.0 / select(direction, vec3f(1e-18), abs(direction) < vec3f(1e-18));
  return SlabRay(inverse, -origin * inverse, vec3u(0u, 1u, 2u) + leastToGreatest * vec3u(direction < vec3f(0.0)));
}

fn meshRay(origin: vec3f, direction: vec3f) -> MeshRay {
  let size = abs(direction);
  let axis = select(select(0u, 1u, size.y > size.x), 2u, size.z >= max(size.x, size.y));
  let d = turnedTo(axis, direction);
  return MeshRay(origin, axis, vec3f(-d.xy / d.z, 1.0 / d.z));
}

// What comes next is on top of the stack.
const unread = 0x8ffffffcu;

const leaving = 0x8ffffffeu;

const leastToGreatest = 3u;

// The axis comes last.
fn turnedTo(axis: u32, v: vec3f) -> vec3f {
  return select(select(v, v.zxy, axis == 1u), v.yzx, axis == 0u);
}

const leaves = 0x90000000u;

// Rows of a node; from the rows of least to those of greatest places; and where the references are.
const nodeRows = 7u;

const childrenRow = 6u;

// Where the ray enters each child, 1e30 where it does not.
fn enterChildren(node: u32, r: SlabRay, t: f32) -> vec4f {
  // The row of the far planes is the other one of the two.
  let far = vec3u(leastToGreatest) + vec3u(0u, 2u, 4u) - r.near;
  let near4 = larger(larger(planes(node + r.near.x, r.inverse.x, r.offset.x), planes(node + r.near.y, r.inverse.y, r.offset.y)), larger(planes(node + r.near.z, r.inverse.z, r.offset.z), vec4f(0.0)));
  let far4 = smaller(smaller(planes(node + far.x, r.inverse.x, r.offset.x), planes(node + far.y, r.inverse.y, r.offset.y)), planes(node + far.z, r.inverse.z, r.offset.z));
  return select(vec4f(1e30), near4, near4 <= smaller(far4 * slabRounding, vec4f(t)));
}

// The bits of 1e30, the distance to a child that is not entered.
const notEntered = 0x7149f2cai;

fn larger(a: vec4f, b: vec4f) -> vec4f {
  return bitcast<vec4f>(max(bitcast<vec4i>(a), bitcast<vec4i>(b)));
}

fn planes(row: u32, inverse: f32, offset: f32) -> vec4f {
  return bitcast<vec4f>(geometryRow(row)) * inverse + offset;
}

fn smaller(a: vec4f, b: vec4f) -> vec4f {
  return bitcast<vec4f>(min(bitcast<vec4i>(a), bitcast<vec4i>(b)));
}

// Rounding of the distances to a box, relative; of the box itself the encoder takes care.
const slabRounding = 1.0 + 1e-6;

const countShift = 28u;

fn crossTriangle(ray: MeshRay, triangle: Triangle) -> Crossing {
  let a = turnedTo(ray.axis, triangle.a - ray.origin);
  let b = turnedTo(ray.axis, triangle.b - ray.origin);
  let c = turnedTo(ray.axis, triangle.c - ray.origin);
  let pa = a.xy + a.z * ray.shear.xy;
  let pb = b.xy + b.z * ray.shear.xy;
  let pc = c.xy + c.z * ray.shear.xy;
  let u = edge(pc, pb);
  let v = edge(pa, pc);
  let w = edge(pb, pa);
  let sum = u + v + w;
  let side = select(1.0, -1.0, sum < 0.0);
  let within = isWithin(u, v, w);
  let depth = ray.shear.z * side * (u * a.z + v * b.z + w * c.z);
  return Crossing(within & (sum != 0.0), sum * side, depth, vec2f(v, w) * side, sum * ray.shear.z > 0.0);
}

fn fetchTriangle(row: u32) -> Triangle {
  let r0 = geometryRow(row + 0u);
  let r1 = geometryRow(row + 1u);
  let r2 = geometryRow(row + 2u);
  return Triangle(bitcast<vec3f>(r0.xyz), r0.w, bitcast<vec3f>(r1.xyz), r1.w, bitcast<vec3f>(r2.xyz), r2.w);
}

const triangleRows = 3u;

// Triangles that are not there from behind, and such that are there where, or as often as, their opacity says.
override hasOneSided = false;

const isOneSided = 2147483648u;

const coverRow = 2147483647u;

fn edge(a: vec2f, b: vec2f) -> f32 {
  let p = a.x * b.y;
  let q = a.y * b.x;
  return fma(a.x, b.y, -q) - fma(a.y, b.x, -p);
}

fn isWithin(u: f32, v: f32, w: f32) -> bool {
  return ((u >= 0.0) & (v >= 0.0) & (w >= 0.0)) | ((u <= 0.0) & (v <= 0.0) & (w <= 0.0));
}

// Where the ray's line crosses the triangle's plane. Distance and weights are still to be divided by `sum`, which most triangles that a ray
// is tested against need not.
struct Crossing {
  within: bool,
  // Above 0 where `within`.
  sum: f32,
  depth: f32,
  // How much the second and third vertex count.
  weights: vec2f,
  // Whether it is met on the side from which its vertices go counter-clockwise.
  front: bool,
}


struct Triangle {
  // first vertex, in the space of its mesh
  a: vec3f,
  // its number among the vertices of the mesh
  vertexA: u32,
  // second vertex
  b: vec3f,
  // its number
  vertexB: u32,
  // third vertex
  c: vec3f,
  // its number
  vertexC: u32,
}


// `number`: of the ray.
fn isThere(instance: u32, place: u32, weights: vec2f, number: u32) -> bool {
  let i = fetchInstance(frame.instances + instance * instanceRows);
  let triangle = fetchTriangle(i.triangles + place * triangleRows);
  let row = i.cover & coverRow;
  let material = fetchMaterialTextures(row);
  let c = coverAt(i.vertices + vec3u(triangle.vertexA, triangle.vertexB, triangle.vertexC) * i.vertexRows, i.vertexRows, weights);
  var opacity = material.opacity * c.opacity;
  if ((material.flags & hasOpacityTexture) != 0u) {
    let t = fetchTextureUse(row + materialTexturesRows);
    opacity *= lookUp(t, select(c.uv.xy, c.uv.zw, (t.flags & usesSecondSet) != 0u)).a;
  }
  let chance = unitFloat(pcg(place + pcg(instance + pcg(number))));
  return select(opacity >= material.cutoff, chance < opacity, material.cutoff < 0.0);
}

fn fetchMaterialTextures(row: u32) -> MaterialTextures {
  let r0 = texelRow(row + 0u);
  return MaterialTextures(r0.x, r0.y, bitcast<f32>(r0.z), bitcast<f32>(r0.w));
}

// `rows`: of its three vertices, which are `each` rows long. `weights`: of the second and third.
fn coverAt(rows: vec3u, each: u32, weights: vec2f) -> Cover {
  let share = vec3f(1.0 - weights.x - weights.y, weights);
  var c = Cover(vec4f(0.0), 1.0);
  if (each != 0u) {
    c.uv = vec4f(share.x * fetchVertex(rows.x).uv + share.y * fetchVertex(rows.y).uv + share.z * fetchVertex(rows.z).uv, 0.0, 0.0);
  }
  if (each > vertexRows) {
    let more = rows + vertexRows;
    let a = fetchVertexMore(more.x);
    let b = fetchVertexMore(more.y);
    let d = fetchVertexMore(more.z);
    c.uv = vec4f(c.uv.xy, share.x * a.uv + share.y * b.uv + share.z * d.uv);
    c.opacity = dot(share, vec3f(pairOf(a.blueAlpha).y, pairOf(b.blueAlpha).y, pairOf(d.blueAlpha).y));
  }
  return c;
}

const hasOpacityTexture = 2u;

// Uniform in [0, 1) with 24 bits.
fn unitFloat(h: u32) -> f32 {
  return f32(h >> 8u) * 5.9604644775390625e-8;
}

fn fetchTextureUse(row: u32) -> TextureUse {
  let r0 = texelRow(row + 0u);
  let r1 = texelRow(row + 1u);
  let r2 = texelRow(row + 2u);
  return TextureUse(bitcast<vec3f>(r0.xyz), r0.w, bitcast<vec3f>(r1.xyz), r1.w, r2.x, r2.y, r2.z, bitcast<f32>(r2.w));
}

const materialTexturesRows = 1u;

// Linear red, green, blue and alpha of an image at these coordinates of the mesh.
fn lookUp(t: TextureUse, uv: vec2f) -> vec4f {
  let place = vec3f(uv, 1.0);
  let flags = select(0u, t.flags, hasOtherLookups);
  let nearest = (flags & isNearest) != 0u;
  let x = neighbours(dot(t.toU, place), t.width, (flags & clampsU) != 0u, (flags & mirrorsU) != 0u, nearest);
  let y = neighbours(dot(t.toV, place), t.height, (flags & clampsV) != 0u, (flags & mirrorsV) != 0u, nearest);
  let upper = t.first + y.first * t.width;
  let lower = t.first + y.second * t.width;
  let colored = (t.flags & isColor) != 0u;
  let above = mix(decoded(texelAt(upper + x.first), colored), decoded(texelAt(upper + x.second), colored), x.share);
  let below = mix(decoded(texelAt(lower + x.first), colored), decoded(texelAt(lower + x.second), colored), x.share);
  return mix(above, below, y.share);
}

const usesSecondSet = 1u;

fn texelRow(i: u32) -> vec4u {
  return textureLoad(texels, vec2i(i32(i & 2047u), i32(f32(i32(i & 0x7ffff800u)) / 2048.0)), 0);
}

struct TextureUse {
  // u in the image is dot(toU, (u, v, 1)) of the coordinates
  toU: vec3f,
  // what it is multiplied with: TEXTURE_SLOTS
  slot: u32,
  // likewise v
  toV: vec3f,
  // LOOKUP_FLAGS
  flags: u32,
  // texel of the image, of all texels
  first: u32,
  // of the image, texels
  width: u32,
  // of the image, texels
  height: u32,
  // of a normal map: factor on the first two components
  scale: f32,
}


@group(0) @binding(6) var texels: texture_2d<u32>;

override hasOtherLookups = false;

const isNearest = 4u;

fn neighbours(x: f32, size: u32, clamps: bool, mirrors: bool, nearest: bool) -> Neighbours {
  let inside = select(select(fract(x), 1.0 - abs(2.0 * fract(0.5 * x) - 1.0), mirrors), clamp(x, 0.0, 1.0), clamps);
  // Centres of texels lie halfway between whole numbers.
  let at = inside * f32(size) - select(0.5, 0.0, nearest);
  let low = floor(at);
  let last = i32(size) - 1;
  let first = i32(low);
  let second = first + 1;
  // What lies before the first texel and after the last: the other end, or, for a mirror as at an edge, the same once more.
  let repeats = !(clamps | mirrors);
  let before = select(0, last, repeats);
  let after = select(last, 0, repeats);
  return Neighbours(u32(select(clamp(first, 0, last), before, first < 0)), u32(select(clamp(second, 0, last), after, second > last)), select(at - low, 0.0, nearest));
}

const clampsU = 8u;

const mirrorsU = 16u;

const clampsV = 32u;

const mirrorsV = 64u;

const isColor = 2u;

fn decoded(texel: u32, colored: bool) -> vec4f {
  let c = vec4f((vec4u(texel) >> vec4u(0u, 8u, 16u, 24u)) & vec4u(255u)) / 255.0;
  return vec4f(select(c.rgb, linearFromSrgb(c.rgb), colored), c.a);
}

// Of four texels in a row the one wanted.
fn texelAt(i: u32) -> u32 {
  let row = texelRow(i >> 2u);
  let pair = select(row.xy, row.zw, (i & 2u) != 0u);
  return select(pair.x, pair.y, (i & 1u) != 0u);
}

// Along one side of an image: two neighbours, and how much the second counts.
struct Neighbours {
  first: u32,
  second: u32,
  share: f32,
}


// IEC 61966-2-1.
fn linearFromSrgb(c: vec3f) -> vec3f {
  return select(pow((c + 0.055) / 1.055, vec3f(2.4)), c / 12.92, c <= vec3f(0.04045));
}

struct MaterialTextures {
  // uses of textures: TextureUse, in the rows that follow
  count: u32,
  // MATERIAL_FLAGS
  flags: u32,
  // share of light that the surface takes part in
  opacity: f32,
  // opacity below which it is not there; negative: it is there as often as the opacity says
  cutoff: f32,
}


// What the vertices of a triangle say at a point of it: both sets of coordinates, and opacity.
struct Cover {
  uv: vec4f,
  opacity: f32,
}


const vertexRows = 1u;

fn fetchVertex(row: u32) -> Vertex {
  let r0 = geometryRow(row + 0u);
  return Vertex(r0.x, r0.y, bitcast<vec2f>(r0.zw));
}

struct Vertex {
  // shading normal, octahedral, 16 bits each
  normal: u32,
  // likewise; of the second number the lowest bit is 1 where the bitangent is -cross(normal, tangent)
  tangent: u32,
  // texture coordinates of set 0
  uv: vec2f,
}


fn fetchVertexMore(row: u32) -> VertexMore {
  let r0 = geometryRow(row + 0u);
  return VertexMore(r0.x, r0.y, bitcast<vec2f>(r0.zw));
}

// Two numbers of 16 bits.
fn pairOf(word: u32) -> vec2f {
  return vec2f(f32(word & 0xffffu), f32(word >> 16u)) / 65535.0;
}

struct VertexMore {
  // linear colour, 16 bits each
  redGreen: u32,
  // and opacity
  blueAlpha: u32,
  // texture coordinates of set 1
  uv: vec2f,
}


// A sample of the light at a point, and the numbers that decide how the path goes on from there.
struct Lit {
  light: LightSample,
  // Per solid angle, with the choice of the light.
  pdf: f32,
  // Emitter.shape
  shape: f32,
  odds: Odds,
  u: vec3f,
}


// What sampling a light gives: one direction, and how likely it was.
struct LightSample {
  // Unit, from the point to the light.
  direction: vec3f,
  // To where the light is met; `miss` for light from infinity.
  distance: f32,
  // Radiance; of a light without size what one gets of it: intensity / distance^2, or irradiance.
  radiance: vec3f,
  // Per solid angle, the choice of the light left out; 1 for lights without size; 0: no light from there.
  pdf: f32,
  // A light without size: no ray can meet it.
  delta: bool,
}


// Adds what the ray has found there by itself.
fn lightAt(p: ptr<function, Path>, hit: PairHit, m: Meeting) -> Lit {
  let only = fetchEmitter(0u);
  let found = metLight(*p, hit, m.surface, m.geometric, only);
  (*p).radiance += (*p).throughput * select(found, vec3f(0.0), hit.shape == noShape);
  let u = nextTwo3d(&(*p).sampler);
  let choice = chooseEmitter(m.point, litSideOf(m), u.first.z);
  let emitter = emitterAt(choice.index, only);
  let light = sampleEmitter(emitter, m.point, u.first.xy);
  return Lit(light, light.pdf * choice.probability, emitter.shape, choice.odds, u.second);
}

// What lay on the way there takes its share of the light.
fn meetingAt(p: ptr<function, Path>, hit: PairHit) -> Meeting {
  let rays = (*p).rays;
  let escaped = hit.shape == noShape;
  let shape = select(hit.shape, 0u, escaped);
  let met = surfaceAt(rays, hit, shape);
  var surface = met.surface;
  let isClear = letsThrough(u32(surface.code), surface.eta.x);
  let outward = met.shading;
  let normal = select(outward, -outward, (dot(outward, rays.direction) > 0.0) & !isClear);
  var basis = basisAbout(normal);
  if (hasGrain) {
    if (any(grainHere != vec3f(0.0))) {
      basis = basisAlong(normal, grainHere);
    }
  }
  let wo = toLocal(basis, -rays.direction);
  if (hasGlass | hasTransmission) {
    let inside = isClear & !isThin(u32(surface.code)) & (wo.z < 0.0) & !escaped;
    (*p).throughput *= exp(-surface.absorption * select(0.0, hit.t, inside));
  }
  if (hasCoatNormals) {
    let away = (dot(coatNormalHere, rays.direction) > 0.0) & !isClear;
    coatNormalHere = toLocal(basis, select(coatNormalHere, -coatNormalHere, away));
  }
  if (hasCoats) {
    surface.emission *= 1.0 - coatReflectance(layersHere.coat, coatCosine(1.0, wo));
  }
  return Meeting(rays.point + hit.t * rays.direction, shape, surface, isClear, met.geometric, outward, basis, wo);
}

fn fetchEmitter(i: u32) -> Emitter {
  let t0 = tableTexel(14u, i);
  let t1 = tableTexel(15u, i);
  let t2 = tableTexel(16u, i);
  let t3 = tableTexel(17u, i);
  let t4 = tableTexel(18u, i);
  let t5 = tableTexel(19u, i);
  return Emitter(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w, t4.x, t4.y, t4.z, t4.w, t5.x, t5.y, t5.z, t5.w);
}

// Light that the ray found by itself: of the surface that it met.
fn metLight(p: Path, hit: PairHit, s: Surface, outward: vec3f, only: Emitter) -> vec3f {
  let direction = p.rays.direction;
  let hidden = ((u32(s.code) & 16u) != 0u) & (dot(outward, direction) > 0.0);
  let own = emitterOf(s.code);
  var found = select(s.emission, vec3f(0.0), hidden);
  // A lamp beyond the number of emitters that light sampling knows counts whole.
  if ((own >= 0) & (frame.emitterCount > 0u)) {
    var i = u32(max(own, 0));
    if (hasMeshLamps) {
      if (hit.triangle.instance != noInstance) {
        i += emitterOfTriangle(emitterAt(i, only), hit.triangle);
      }
    }
    let met = emitterAt(i, only);
    let density = shapePdf(met, p.rays.point, direction, hit.t, outward, hit.triangle.triangle);
    var probability = listedProbability(met, p.rays.point, p.litSide, p.odds);
    if (hasLightTree) {
      if (met.leaf >= 0.0) {
        probability = treeProbability(met, p.rays.point, p.litSide, p.odds);
      }
    }
    found *= select(misWeight(p.pdf, density * probability), 1.0, p.pdf <= 0.0);
  }
  return found;
}

fn nextTwo3d(s: ptr<function, Sampler>) -> TwoPoints {
  let g = nextGroups(*s);
  (*s).key = (*s).key + 2u;
  let x = firstOf(g);
  let y = secondOf(g);
  let z = thirdOf(g);
  return TwoPoints(vec3f(x.x, y.x, z.x), vec3f(x.y, y.y, z.y));
}

// `normal` is that of the side that the point is seen from, or vec3f(0) where light comes through from both. One loop: weighted
// reservoir sampling (Chao 1982) with one random number: whatever of u decided is stretched to [0, 1) again.
fn chooseEmitter(point: vec3f, normal: vec3f, u: f32) -> EmitterChoice {
  var hasTree = false;
  if (hasLightTree) {
    hasTree = frame.lightTreeDepth > 0u;
  }
  let listed = select(frame.emitterCount, frame.farEmitters, hasTree);
  var choice = EmitterChoice(0u, f32(min(frame.emitterCount, 1u)), Odds(1.0, 0.0));
  if (hasManyLights) {
    if (frame.emitterCount > 1u) {
      var total = 0.0;
      var chosen = 0u;
      var chosenWeight = 0.0;
      var rest = u;
      var i = 0u;
      loop {
        let weight = select(0.0, estimatedIrradiance(fetchEmitter(i), point, normal), i < listed);
        total += weight;
        let share = weight / max(total, 1e-37);
        let take = rest < share;
        chosen = select(chosen, i, take);
        chosenWeight = select(chosenWeight, weight, take);
        rest = select((rest - share) / max(1.0 - share, 1e-7), rest / max(share, 1e-37), take);
        i++;
        if (i >= listed) {
          break;
        }
      }
      choice = EmitterChoice(chosen, chosenWeight / max(total, 1e-37), Odds(total, 0.0));
      if (hasLightTree) {
        if (hasTree) {
          let down = descend(point, normal, rest, noLeaf0, total);
          choice.odds.tree = down.share;
          choice.index = select(chosen, down.emitter, down.taken);
          choice.probability = select(choice.probability * (1.0 - down.share), down.probability * down.share, down.taken);
        }
      }
    }
  }
  return choice;
}

// Light that must come from this side to count: none is excluded where light goes through.
fn litSideOf(m: Meeting) -> vec3f {
  return select(m.basis.normal, vec3f(0.0), m.isClear);
}

// `only`: fetched before, when the program is for scenes with one.
fn emitterAt(i: u32, only: Emitter) -> Emitter {
  var emitter = only;
  if (hasManyLights) {
    emitter = fetchEmitter(i);
  }
  return emitter;
}

// A direction to the light and its density; pdf 0: no light from there. u in [0, 1)^2. What is nearer than any ray may hit is the
// lamp that the point itself lies on.
fn sampleEmitter(e: Emitter, point: vec3f, u: vec2f) -> LightSample {
  var s = LightSample(vec3f(0.0, 1.0, 0.0), miss, vec3f(0.0), 0.0, true);
  if (hasSphereLights) {
    if (e.kind == sphereKind) {
      s = sampleSphere(e, point, u);
    }
  }
  if (hasQuadLights) {
    if (e.kind == quadKind) {
      s = sampleQuad(e, point, u);
    }
  }
  if (hasBoxLights) {
    if (e.kind == boxKind) {
      s = sampleBox(e, point, u);
    }
  }
  if (hasMeshLamps) {
    if (e.kind == meshKind) {
      s = sampleMesh(e, point, u);
    }
  }
  if (hasPointLights) {
    if (e.kind == pointKind) {
      s = samplePoint(e, point);
    }
  }
  if (hasPointLights) {
    if (e.kind == spotKind) {
      s = sampleSpot(e, point);
    }
  }
  if (hasSuns) {
    if (e.kind == directionalKind) {
      s = sampleDirectional(e, u);
    }
  }
  if (hasSky) {
    if (e.kind == skyKind) {
      s = sampleSky(u);
    }
  }
  s.pdf = select(s.pdf, 0.0, s.distance <= relativeTMin * length(point));
  return s;
}

// Where the path's ray ends, as light sampling and scattering see it.
struct Meeting {
  point: vec3f,
  // 0 where the ray has met nothing.
  shape: u32,
  surface: Surface,
  isClear: bool,
  // Unit vectors in the world, out of solids or to the front of triangles.
  geometric: vec3f,
  outward: vec3f,
  // Along z the outward normal where light goes through; of all else the normal towards where the ray came from.
  basis: Basis,
  // To where the ray came from, in that frame.
  wo: vec3f,
}


struct Surface {
  // Lambert albedo; glTF base colour; constant Fresnel reflectance of a conductor without eta and k
  baseColor: vec3f,
  // kind (0 diffuse, 1 metallicRoughness, 2 conductor, 3 dielectric) + 4 thin + 8 energyCompensation + 16 one-sided lamp + 32 smooth + 64 separable masking + 128 times one more than the index of the emitter that this shape is, 0: none
  code: f32,
  // radiance sent out
  emission: vec3f,
  // share of the perfect mirror layer over the base
  reflectivity: f32,
  // conductor: index of refraction per channel; dielectric: the index in all three; metallicRoughness: in x the row of the table with its Layers, with a minus sign when light may go through; 0: there are none
  eta: vec3f,
  // GGX width, roughness^2; 0: smooth
  alpha: f32,
  // conductor: extinction coefficient per channel
  k: vec3f,
  // metallicRoughness: share of metal
  metallic: f32,
  // dielectric: Beer-Lambert coefficient, 1 / metre
  absorption: vec3f,
  // row of its MaterialTextures among the texels
  textures: f32,
}


// An orthonormal basis about a unit normal: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
struct Basis {
  tangent: vec3f,
  bitangent: vec3f,
  normal: vec3f,
}


struct Emitter {
  // eye-relative: centre of a sphere, box or mesh, corner of a quad, place of a point or spot light
  position: vec3f,
  // 0 sphere, 1 quad, 2 box, 3 point, 4 spot, 5 directional, 6 sky, 7 triangles of a mesh
  kind: f32,
  // edge of a quad; unit direction that a spot shines to or directional light travels; halfSize of a box; mesh: in x the cosine of the cone about v that holds all normals, in y 1 where its material says how much of the radiance there is at a point
  u: vec3f,
  // of a sphere; cosine of the outer angle of a spot; cosine of half the angular diameter of directional light; mesh: each 2^radius triangles of an instance are an emitter
  radius: f32,
  // other edge of a quad; mean of the normals of a mesh, weighted by area
  v: vec3f,
  // cosine of the inner angle of a spot; mesh: how many emitters an instance is, one after the other
  cosInner: f32,
  // radiance; of a point or spot: intensity; of directional light without angular size: irradiance
  radiance: vec3f,
  // of the surface that shines, m^2; of directional light: its solid angle, 0 without angular size
  area: f32,
  // row of the shape that rays meet; -1: none, only light sampling finds it
  shape: f32,
  // 1: a quad that shines to the side of u x v only, a mesh to the front of its triangles
  oneSided: f32,
  // for choosing among emitters: power / distance^2 estimates the irradiance in front of it
  power: f32,
  // radius of the bounding sphere; of directional light: sine of half the angular diameter
  reach: f32,
  // its place among the leaves of the light tree; -1: it is in none
  leaf: f32,
  // mesh: row of its first triangle among the tables of lamps
  table: f32,
  // mesh: how many
  triangles: f32,
  // mesh: of which instance
  instance: f32,
}


// Index of the emitter that a shape is, from -1 for none.
fn emitterOf(code: f32) -> i32 {
  return (i32(code) >> 7u) - 1;
}

// Meshes that shine, and so many lights that a tree chooses among them.
override hasMeshLamps = false;

// The density with which sampleEmitter gives that direction, for an emitter that is a shape. The ray met it `distance` away, with that
// outward normal; of a mesh, the triangle at that place.
fn shapePdf(e: Emitter, point: vec3f, direction: vec3f, distance: f32, normal: vec3f, place: u32) -> f32 {
  var pdf = 0.0;
  if (hasSphereLights) {
    if (e.kind == sphereKind) {
      pdf = spherePdf(e, point, direction);
    }
  }
  if (hasQuadLights) {
    if (e.kind == quadKind) {
      pdf = quadPdf(e, point, distance);
    }
  }
  if (hasBoxLights) {
    if (e.kind == boxKind) {
      pdf = boxPdf(e, point, direction, distance, normal);
    }
  }
  if (hasMeshLamps) {
    if (e.kind == meshKind) {
      pdf = meshPdf(e, direction, distance, normal, place);
    }
  }
  return pdf;
}

// With which chooseEmitter would have chosen this one there, which is not in the tree.
fn listedProbability(e: Emitter, point: vec3f, normal: vec3f, odds: Odds) -> f32 {
  var probability = f32(min(frame.emitterCount, 1u));
  if (hasManyLights) {
    if (frame.emitterCount > 1u) {
      probability = estimatedIrradiance(e, point, normal) / max(odds.total, 1e-37);
      if (hasLightTree) {
        probability *= 1.0 - odds.tree;
      }
    }
  }
  return probability;
}

override hasLightTree = false;

// Power heuristic, for one sample of each kind.
fn misWeight(own: f32, other: f32) -> f32 {
  let ratio = other / own;
  return 1.0 / (1.0 + ratio * ratio);
}

// The first emitter of a shape and the triangle of it that was met -> how many emitters further on that triangle is.
fn emitterOfTriangle(e: Emitter, t: LeftTriangle) -> u32 {
  return (t.instance - u32(e.instance)) * u32(e.cosInner) + (t.triangle >> u32(e.radius));
}

// The same of one that is in the tree.
fn treeProbability(e: Emitter, point: vec3f, normal: vec3f, odds: Odds) -> f32 {
  var probability = 0.0;
  if (frame.lightTreeDepth > 0u) {
    let down = descend(point, normal, 0.0, i32(max(e.leaf, 0.0)), odds.total);
    probability = down.probability * down.share;
  }
  return probability;
}

// `leaf`: the one that is asked for, or noLeaf: one is taken by u. `far`: the sum of the estimates of lights that are infinitely far.
fn descend(point: vec3f, normal: vec3f, u: f32, leaf: i32, far: f32) -> TreeChoice {
  var level = frame.lightTreeDepth;
  var node = 0u;
  var rest = u;
  var choice = TreeChoice(0u, 1.0, 0.0, true);
  loop {
    level--;
    let n = fetchLightNode(frame.lightTree + node);
    let w = estimatesOfChildren(n, point, normal);
    let two = w.x + w.y;
    let three = two + w.z;
    let total = three + w.w;
    if (node == 0u) {
      choice.share = shareOfTree(total, far);
      choice.taken = rest < choice.share;
      rest = min(rest / max(choice.share, 1e-37), 0.99999994);
    }
    let at = rest * total;
    let byChance = u32(at >= w.x) + u32(at >= two) + u32(at >= three);
    let child = select((u32(max(leaf, 0)) >> (2u * level)) & 3u, byChance, leaf < 0);
    let low = child < 2u;
    let odd = (child & 1u) == 1u;
    let own = select(select(w.z, w.w, odd), select(w.x, w.y, odd), low);
    let before = select(select(two, three, odd), select(0.0, w.x, odd), low);
    choice.probability *= own / max(total, 1e-37);
    choice.emitter = u32(select(select(n.emitters.z, n.emitters.w, odd), select(n.emitters.x, n.emitters.y, odd), low));
    rest = clamp((at - before) / max(own, 1e-37), 0.0, 0.99999994);
    node = 4u * node + 1u + child;
    if (level == 0u) {
      break;
    }
  }
  return choice;
}

struct TreeChoice {
  emitter: u32,
  // Of this emitter, once it is to be one of the tree.
  probability: f32,
  // Probability of the tree, beside the lights that are infinitely far, and whether chance takes it.
  share: f32,
  taken: bool,
}


fn fetchLightNode(i: u32) -> LightNode {
  let t0 = tableTexel(0u, i);
  let t1 = tableTexel(1u, i);
  let t2 = tableTexel(2u, i);
  let t3 = tableTexel(3u, i);
  let t4 = tableTexel(4u, i);
  let t5 = tableTexel(5u, i);
  let t6 = tableTexel(6u, i);
  let t7 = tableTexel(7u, i);
  let t8 = tableTexel(8u, i);
  let t9 = tableTexel(9u, i);
  let t10 = tableTexel(10u, i);
  let t11 = tableTexel(11u, i);
  return LightNode(t0.xyzw, t1.xyzw, t2.xyzw, t3.xyzw, t4.xyzw, t5.xyzw, t6.xyzw, t7.xyzw, t8.xyzw, t9.xyzw, t10.xyzw, t11.xyzw);
}

// An estimate of each child's irradiance at the point; 0 where it can be none. A normal of zero: light comes through from both sides.
fn estimatesOfChildren(n: LightNode, point: vec3f, normal: vec3f) -> vec4f {
  let x = n.x - point.x;
  let y = n.y - point.y;
  let z = n.z - point.z;
  let distance2 = x * x + y * y + z * z;
  let inverse = inverseSqrt(max(distance2, vec4f(1e-30)));
  let inside = distance2 <= n.reach * n.reach;
  // Half the angle that the sphere fills; all of it from inside.
  let sinB = min(n.reach * inverse, vec4f(1.0));
  let cosB = select(sineOf(sinB), vec4f(-1.0), inside);
  let along = -(n.axisX * x + n.axisY * y + n.axisZ * z) * inverse;
  let cosW = clamp(select(along, abs(along), n.bothSides > vec4f(0.5)), vec4f(-1.0), vec4f(1.0));
  let sinW = sineOf(cosW);
  let sinO = sineOf(n.cosWidth);
  let cosX = cosineLess(cosW, sinW, n.cosWidth, sinO);
  let cosOut = select(cosineLess(cosX, sineOf(cosX), cosB, sinB), vec4f(1.0), inside);
  let cosN = clamp((normal.x * x + normal.y * y + normal.z * z) * inverse, vec4f(-1.0), vec4f(1.0));
  let above = select(max(cosineLess(cosN, sineOf(cosN), cosB, sinB), vec4f(0.0)), vec4f(1.0), inside);
  let cosIn = select(above, vec4f(1.0), dot(normal, normal) == 0.0);
  let estimate = n.power * cosOut * cosIn / max(max(distance2, n.reach * n.reach), vec4f(1e-15));
  return select(vec4f(0.0), min(estimate, vec4f(1e30)), cosOut > n.cosEdge);
}

// The estimate for the whole tree is rough; so neither side gets less than a quarter where there are both.
fn shareOfTree(total: f32, far: f32) -> f32 {
  let share = 0.25 + 0.5 * total / max(total + far, 1e-37);
  return select(select(share, 1.0, far <= 0.0), 0.0, total <= 0.0);
}

struct LightNode {
  // of each child the centre of a sphere about its lights, eye-relative
  x: vec4f,
  // y
  y: vec4f,
  // z
  z: vec4f,
  // radius of the sphere
  reach: vec4f,
  // unit axis of the cone that holds all normals of the lights
  axisX: vec4f,
  // y
  axisY: vec4f,
  // z
  axisZ: vec4f,
  // cosine of that cone, from its axis
  cosWidth: vec4f,
  // cosine of the angle from a normal up to which there is light
  cosEdge: vec4f,
  // 1: also against the normals
  bothSides: vec4f,
  // sum of what Emitter has; 0: there is no such child
  power: vec4f,
  // in the lowest nodes: which emitter the child is
  emitters: vec4f,
}


fn sineOf(cosine: vec4f) -> vec4f {
  return sqrt(max(1.0 - cosine * cosine, vec4f(0.0)));
}

// cos(max(a - b, 0)), of angles from 0 to pi.
fn cosineLess(cosA: vec4f, sinA: vec4f, cosB: vec4f, sinB: vec4f) -> vec4f {
  return select(cosA * cosB + sinA * sinB, vec4f(1.0), cosA > cosB);
}

// Kinds of light, and more than one of them.
override hasSphereLights = true;

override hasQuadLights = false;

override hasBoxLights = false;

// packed-scene/pack-emitters.ts has the same numbers.
const sphereKind = 0.0;

// A ray can meet a sphere that rounding takes it to be outside of in its back; light sampling never goes there.
fn spherePdf(e: Emitter, point: vec3f, direction: vec3f) -> f32 {
  let view = viewSphere(e, point);
  let reached = view.inside | (dot(direction, view.toCenter) > 0.0);
  return select(0.0, conePdf(view.width), reached);
}

fn viewSphere(e: Emitter, point: vec3f) -> SphereView {
  let toCenter = e.position - point;
  let d = length(toCenter);
  let power = abs((d - e.radius) * (d + e.radius));
  let inside = d <= e.radius;
  let sine = min(e.radius / max(d, 1e-30), 1.0);
  let cosine = sqrt(power) / max(d, 1e-30);
  // 1 - cos = sin^2 / (1 + cos)
  return SphereView(toCenter, d, power, inside, select(sine * sine / (1.0 + cosine), 2.0, inside));
}

fn conePdf(width: f32) -> f32 {
  return 1.0 / (2.0 * pi0 * max(width, 1e-31));
}

struct SphereView {
  toCenter: vec3f,
  distance: f32,
  // |distance^2 - radius^2|
  power: f32,
  inside: bool,
  // 1 - cosine of the cone's half angle.
  width: f32,
}


const pi0 = 3.14159265359;

const quadKind = 1.0;

fn quadPdf(e: Emitter, point: vec3f, distance: f32) -> f32 {
  return pdfOfView(viewQuad(e, point), e.area, distance);
}

fn pdfOfView(q: QuadView, area: f32, distance: f32) -> f32 {
  let pdf = select(areaPdf(area, q.height, distance), 1.0 / max(q.solidAngle, smallSolidAngle), q.bySolidAngle);
  return select(0.0, pdf, q.lit);
}

fn viewQuad(e: Emitter, point: vec3f) -> QuadView {
  let corner = e.position - point;
  let lengths = vec2f(length(e.u), length(e.v));
  let axisX = e.u / lengths.x;
  let axisY = e.v / lengths.y;
  let normal = normalize(cross(axisX, axisY));
  let signedHeight = dot(corner, normal);
  // From the plane itself a quad is a line.
  let least = 1e-7 * (lengths.x + lengths.y);
  let height = max(abs(signedHeight), least);
  let lit = (abs(signedHeight) > least) & ((e.oneSided == 0.0) | (signedHeight < 0.0));
  let low = vec2f(dot(corner, axisX), dot(corner, axisY));
  let high = low + lengths;
  let y = vec2f(low.y, high.y);
  let start = stretch(low.x, y, height);
  let solidAngle = stretch(high.x, y, height) - start;
  let rectangle = abs(dot(axisX, axisY)) <= 1e-5;
  let axisZ = normal * select(-1.0, 1.0, signedHeight > 0.0);
  return QuadView(corner, axisX, axisY, axisZ, low, high, height, start, solidAngle, lit, rectangle & (solidAngle > smallSolidAngle));
}

// Density per solid angle of a point that is uniform on a flat face: distance^2 / (area cos), with cos = height / distance.
fn areaPdf(area: f32, height: f32, distance: f32) -> f32 {
  let pdf = (distance / max(height, 1e-30)) * distance / max(area / distance, 1e-30);
  return min(pdf, largestPdf);
}

// Rectangles that fill less than this, in steradians, are sampled by area.
const smallSolidAngle = 0.01;

struct QuadView {
  // From the point.
  corner: vec3f,
  // Unit, along u and v, and from the point to the plane.
  axisX: vec3f,
  axisY: vec3f,
  axisZ: vec3f,
  // The corner's coordinates and the edges' lengths.
  low: vec2f,
  high: vec2f,
  height: f32,
  // T(x0) and T(x1) - T(x0).
  start: f32,
  solidAngle: f32,
  // Shines at the point.
  lit: bool,
  bySolidAngle: bool,
}


// Above all real densities, so that what divides by one stays finite.
const largestPdf = 1e30;

// T(x)
fn stretch(x: f32, y: vec2f, h: f32) -> f32 {
  let r = sqrt(x * x + y * y + h * h);
  return arctangent(x * y.y / (h * r.y)) - arctangent(x * y.x / (h * r.x));
}

// Angles to a few units in the last place, by the polynomials of Moshier's Cephes (atanf, sinf). GPUs' own functions may be off by
// 1e-4, and solid angles are differences of such angles.
fn arctangent(x: f32) -> f32 {
  let a = abs(x);
  let steep = a > 2.414213562;
  let middle = (a > 0.4142135624) & !steep;
  let r = select(select(a, (a - 1.0) / (a + 1.0), middle), -1.0 / max(a, 1.0), steep);
  let base = select(select(0.0, 0.7853981634, middle), 1.570796327, steep);
  let z = r * r;
  let series = ((8.05374449538e-2 * z - 1.38776856032e-1) * z + 1.99777106478e-1) * z - 3.33329491539e-1;
  return sign(x) * (base + (series * z * r + r));
}

const boxKind = 2.0;

fn boxPdf(e: Emitter, point: vec3f, direction: vec3f, distance: f32, normal: vec3f) -> f32 {
  let b = viewBox(e, point);
  return select(areaPdf(b.area, distance * abs(dot(direction, normal)), distance), conePdf(2.0), b.inside);
}

fn viewBox(e: Emitter, point: vec3f) -> BoxView {
  let rotation = fetchExtent(u32(e.shape)).a;
  let p = rotate(rotation, point - e.position);
  let seen = abs(p) > e.u;
  let faces = select(vec3f(0.0), 4.0 * e.u.yzx * e.u.zxy, seen);
  return BoxView(rotation, p, faces, faces.x + faces.y + faces.z, !any(seen));
}

struct BoxView {
  // World to box.
  rotation: vec4f,
  // The point in the box's own axes.
  point: vec3f,
  // Area, per axis, of the face that is seen; at most one of the two.
  faces: vec3f,
  area: f32,
  inside: bool,
}


const meshKind = 7.0;

fn meshPdf(e: Emitter, direction: vec3f, distance: f32, normal: vec3f, place: u32) -> f32 {
  let row = frame.lampTables + u32(e.table) + (place & ((1u << u32(e.radius)) - 1u));
  return areaPdf(e.area, distance * abs(dot(direction, normal)), distance) * fetchLampTriangle(row).density;
}

fn fetchLampTriangle(row: u32) -> LampTriangle {
  let r0 = geometryRow(row + 0u);
  return LampTriangle(bitcast<f32>(r0.x), r0.y, r0.z, bitcast<f32>(r0.w));
}

struct LampTriangle {
  // alias table: probability to take this triangle and not the other one
  own: f32,
  // of this triangle, in the order of its mesh
  place: u32,
  // place of the other one
  other: u32,
  // how likely its points are: as a factor on 1 / area of the emitter
  density: f32,
}


override hasManyLights = true;

// `power` is the intensity towards the brightest side, so that power / distance^2 is an irradiance. Both cosines are taken with the
// light grown to its bounding sphere: 0 only where all of it lies below the horizon, and right from afar.
fn estimatedIrradiance(e: Emitter, point: vec3f, normal: vec3f) -> f32 {
  let isQuad = hasQuadLights & (e.kind == quadKind);
  let isFar = hasSuns & (e.kind == directionalKind);
  let middle = e.position + select(vec3f(0.0), 0.5 * (e.u + e.v), isQuad);
  let toLight = select(middle - point, -e.u, isFar);
  let distance2 = dot(toLight, toLight);
  let distance = sqrt(distance2);
  let grown = max(distance + e.reach, 1e-15);
  let cosine = cosineTowards(e, toLight, grown, normal);
  // On the axis of a disc the first is exact, outside of a sphere the second.
  let square = select(max(distance2, e.area / (4.0 * pi0)), distance2 + e.area / pi0, isQuad);
  var estimate = e.power * cosine / select(max(square, 1e-15), 1.0, isFar);
  if (hasQuadLights) {
    let height = -dot(cross(e.u, e.v), toLight) / max(e.area, 1e-30);
    let side = select(abs(height), max(height, 0.0), e.oneSided == 1.0);
    let lampCosine = select(0.0, (side + e.reach) / grown, side > 0.0);
    estimate *= select(1.0, lampCosine, isQuad);
  }
  if (hasMeshLamps) {
    // As much of the surface as looks the same way shines like a quad, the rest like a convex body.
    let alike = length(e.v);
    let across = -dot(e.v, toLight);
    let side = select(abs(across), max(across, 0.0), e.oneSided == 1.0);
    let shown = 0.25 * (1.0 - alike) + (side + alike * e.reach) / grown;
    let sizeOfMesh = distance2 + e.area * (1.0 + 3.0 * alike) / (4.0 * pi0);
    estimate = select(estimate, e.power * cosine * shown / max(sizeOfMesh, 1e-15), e.kind == meshKind);
  }
  if (hasPointLights) {
    estimate *= select(1.0, spotFalloff(e, toLight / max(distance, 1e-15)), e.kind == spotKind);
  }
  if (hasSky) {
    estimate = select(estimate, e.power, e.kind == skyKind);
  }
  return estimate;
}

override hasSuns = false;

const directionalKind = 5.0;

// The largest from the normal to where the light may be, grown to its bounding sphere; `grown`: how far its far end is.
fn cosineTowards(e: Emitter, toLight: vec3f, grown: f32, normal: vec3f) -> f32 {
  let above = clamp((dot(normal, toLight) + e.reach) / grown, 0.0, 1.0);
  return select(above, 1.0, dot(normal, normal) == 0.0);
}

override hasPointLights = false;

override hasSky = true;

// glTF's KHR_lights_punctual, "Inner and Outer Cone Angles": full within the inner cone, none outside of the outer.
fn spotFalloff(e: Emitter, toLight: vec3f) -> f32 {
  let share = clamp((-dot(toLight, e.u) - e.radius) / (e.cosInner - e.radius), 0.0, 1.0);
  return share * share;
}

const spotKind = 4.0;

const skyKind = 6.0;

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

struct EmitterChoice {
  index: u32,
  // 0: no light reaches the point.
  probability: f32,
  odds: Odds,
}


const noLeaf0 = -1;

fn sampleSphere(e: Emitter, point: vec3f, u: vec2f) -> LightSample {
  let view = viewSphere(e, point);
  let axis = select(view.toCenter / max(view.distance, 1e-30), vec3f(0.0, 0.0, 1.0), view.distance < 1e-30);
  let ray = sampleCone(axis, view.width, u);
  let along = view.distance * ray.cosine;
  let halfChord = sqrt(max(e.radius * e.radius - view.distance * view.distance * ray.sine2, 0.0));
  // The product of the ray's two distances to the sphere is the point's power (Euclid III.36): the smaller of them by division.
  let larger = abs(along) + halfChord;
  let takeLarger = view.inside & (along > 0.0);
  let distance = select(view.power / max(larger, 1e-30), larger, takeLarger);
  return LightSample(ray.direction, distance, e.radiance, conePdf(view.width), false);
}

fn sampleCone(axis: vec3f, width: f32, u: vec2f) -> ConeDirection {
  let oneMinusCosine = u.x * width;
  let cosine = 1.0 - oneMinusCosine;
  let sine2 = oneMinusCosine * (2.0 - oneMinusCosine);
  let sine = sqrt(max(sine2, 0.0));
  let phi = 2.0 * pi0 * u.y;
  // Some GPUs' sines are off by 1e-4; the direction keeps its length.
  let turn = vec2f(cos(phi), sin(phi));
  let direction = turnTo(axis, vec3f(sine / length(turn) * turn, cosine));
  return ConeDirection(direction, cosine, sine2);
}

// v with its z axis turned to the unit vector `axis`: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
fn turnTo(axis: vec3f, v: vec3f) -> vec3f {
  let s = select(-1.0, 1.0, axis.z >= 0.0);
  let a = -1.0 / (s + axis.z);
  let b = axis.x * axis.y * a;
  let x = vec3f(1.0 + s * axis.x * axis.x * a, s * b, -s * axis.x);
  let y = vec3f(b, s + axis.y * axis.y * a, -axis.y);
  return v.x * x + v.y * y + v.z * axis;
}

struct ConeDirection {
  direction: vec3f,
  cosine: f32,
  sine2: f32,
}


fn sampleQuad(e: Emitter, point: vec3f, u: vec2f) -> LightSample {
  let q = viewQuad(e, point);
  let onArea = q.corner + u.x * e.u + u.y * e.v;
  let toLight = select(onArea, sphericalRectangle(q, u), q.bySolidAngle);
  let distance = max(length(toLight), q.height);
  return LightSample(toLight / distance, distance, e.radiance, pdfOfView(q, e.area, distance), false);
}

// From the point to the rectangle, uniform in solid angle.
fn sphericalRectangle(q: QuadView, u: vec2f) -> vec3f {
  let h = q.height;
  let y = vec2f(q.low.y, q.high.y);
  let s = y / sqrt(y * y + h * h);
  let halfT = cosineAndSine(0.5 * (q.start + u.x * q.solidAngle));
  let across = vec2f(s.y - s.x, s.y + s.x) * halfT;
  let w = 2.0 * halfT.x * halfT.y / max(length(across), 1e-15);
  let x = clamp(h * w * inverseSqrt(max(1.0 - w * w, 1e-12)), q.low.x, q.high.x);
  // Along the line of this x the density is that of y / sqrt(x^2 + h^2 + y^2).
  let d2 = x * x + h * h;
  let ends = y * inverseSqrt(d2 + y * y);
  let v = mix(ends.x, ends.y, u.y);
  let atY = clamp(v * sqrt(d2) * inverseSqrt(max(1.0 - v * v, 1e-12)), y.x, y.y);
  return x * q.axisX + atY * q.axisY + h * q.axisZ;
}

// Cosine and sine of x, |x| <= pi / 2, from the sine of x / 2.
fn cosineAndSine(x: f32) -> vec2f {
  let h = 0.5 * x;
  let z = h * h;
  let sine = ((-1.9515295891e-4 * z + 8.3321608736e-3) * z - 1.6666654611e-1) * z * h + h;
  return vec2f(1.0 - 2.0 * sine * sine, 2.0 * sine * sqrt(1.0 - sine * sine));
}

fn sampleBox(e: Emitter, point: vec3f, u: vec2f) -> LightSample {
  let b = viewBox(e, point);
  let onFaces = pointOnFaces(e, b, u);
  let outwards = sampleCone(vec3f(0.0, 0.0, 1.0), 2.0, u).direction;
  let distance = select(length(onFaces.xyz), max(boxSlabs(b.point, outwards, e.u).far, 0.0), b.inside);
  let direction = select(onFaces.xyz / max(distance, 1e-30), outwards, b.inside);
  let pdf = select(areaPdf(b.area, onFaces.w, distance), conePdf(2.0), b.inside);
  return LightSample(rotateBack(b.rotation, direction), distance, e.radiance, pdf, false);
}

// From the point to a place on the faces that it sees, and its distance from the plane of that face.
fn pointOnFaces(e: Emitter, b: BoxView, u: vec2f) -> vec4f {
  let both = b.faces.x + b.faces.y;
  let at = u.x * b.area;
  let onX = at < b.faces.x;
  let onY = !onX & (at < both);
  let face = select(select(b.faces.z, b.faces.y, onY), b.faces.x, onX);
  // What is left of u.x within the face.
  let within = clamp((at - select(select(both, b.faces.x, onY), 0.0, onX)) / max(face, 1e-30), 0.0, 1.0);
  let axis = vec3f(select(0.0, 1.0, onX), select(0.0, 1.0, onY), select(1.0, 0.0, onX | onY));
  let p = vec3f(select(-1.0, 1.0, dot(axis, b.point) >= 0.0), 2.0 * within - 1.0, 2.0 * u.y - 1.0);
  let toLight = select(select(p.yzx, p.zxy, onY), p.xyz, onX) * e.u - b.point;
  return vec4f(toLight, abs(dot(axis, toLight)));
}

fn rotateBack(q: vec4f, v: vec3f) -> vec3f {
  return rotate(vec4f(-q.xyz, q.w), v);
}

fn sampleMesh(e: Emitter, point: vec3f, u: vec2f) -> LightSample {
  let chosen = chooseTriangle(e, u);
  let instance = fetchInstance(frame.instances + u32(e.instance) * instanceRows);
  let t = fetchTriangle(instance.triangles + chosen.place * triangleRows);
  let weights = weightsOnTriangle(chosen.u);
  let toLight = outOfMesh(instance, t.a + weights.x * (t.b - t.a) + weights.y * (t.c - t.a)) - point;
  let across = mat3x3f(instance.toMeshX.xyz, instance.toMeshY.xyz, instance.toMeshZ.xyz) * cross(t.b - t.a, t.c - t.a);
  let height = dot(across, toLight) * inverseSqrt(max(dot(across, across), 1e-37));
  let distance = length(toLight);
  let pdf = areaPdf(e.area, abs(height), distance) * chosen.density;
  let lit = (height < 0.0) | ((e.oneSided == 0.0) & (height > 0.0));
  // Up to the triangle itself, or to what meets it at an edge, nothing is in the way: ray.wesl, Start.tMin.
  let reached = max(distance - relativeTMin * (length(point) + distance), 0.0);
  var radiance = e.radiance;
  if (hasVariedLamps) {
    if (e.u.y > 0.0) {
      let rows = instance.vertices + vec3u(t.vertexA, t.vertexB, t.vertexC) * instance.vertexRows;
      let c = coverAt(rows, instance.vertexRows, weights);
      radiance *= radianceShare(u32(fetchSurface(u32(e.shape)).textures), c, (instance.cover & coverRow) != 0u);
    }
  }
  return LightSample(toLight / max(distance, 1e-30), reached, radiance, select(0.0, pdf, lit), false);
}

fn chooseTriangle(e: Emitter, u: vec2f) -> ChosenTriangle {
  let first = frame.lampTables + u32(e.table);
  let column = min(u32(u.x * e.triangles), u32(e.triangles) - 1u);
  let entry = fetchLampTriangle(first + column);
  // The digits that the choice of a column has used up are replaced by hashed ones.
  let hash = mixBits(bitcast<u32>(u.x) ^ (bitcast<u32>(u.y) * 0x9e3779b1u)) >> 8u;
  let fine = f32(hash) * 5.9604644775390625e-8 * 5.9604644775390625e-8 * e.triangles;
  let x = clamp(u.x * e.triangles - f32(column) + fine, 0.0, 0.99999994);
  let own = x < entry.own;
  let rest = select((x - entry.own) / max(1.0 - entry.own, 1e-7), x / max(entry.own, 1e-37), own);
  let place = select(entry.other, entry.place, own);
  let density = fetchLampTriangle(first + column + place - entry.place).density;
  return ChosenTriangle(place, density, vec2f(min(rest, 1.0), u.y));
}

// How much the second and third vertex count at a uniform point: Heitz, "A Low-Distortion Map Between Triangle and Square", 2019.
fn weightsOnTriangle(u: vec2f) -> vec2f {
  let low = 0.5 * min(u.x, u.y);
  let high = max(u.x, u.y) - low;
  return select(vec2f(high, low), vec2f(low, high), u.x < u.y);
}

// From the space of the mesh to the eye-relative world: the inverse of what the instance has, by Cramer's rule.
fn outOfMesh(i: Instance, p: vec3f) -> vec3f {
  let q = p - vec3f(i.toMeshX.w, i.toMeshY.w, i.toMeshZ.w);
  let x = cross(i.toMeshY.xyz, i.toMeshZ.xyz);
  let y = cross(i.toMeshZ.xyz, i.toMeshX.xyz);
  let z = cross(i.toMeshX.xyz, i.toMeshY.xyz);
  return (q.x * x + q.y * y + q.z * z) / dot(i.toMeshX.xyz, x);
}

// Such whose emission a texture varies, or that have holes.
override hasVariedLamps = false;

// Share of a lamp's radiance that there is at a point of it: by the texture of its emission, and, where `missing` says that it may not be there,
// as often as it is. `row`: of its MaterialTextures; the use whose alpha is opacity comes first, and that of the emission next to it.
fn radianceShare(row: u32, c: Cover, missing: bool) -> vec3f {
  let material = fetchMaterialTextures(row);
  let hasFirst = (material.flags & hasOpacityTexture) != 0u;
  let wanted = min(material.count, select(1u, 2u, hasFirst));
  var share = vec3f(1.0);
  var opacity = material.opacity * c.opacity;
  var i = 0u;
  if (wanted > 0u) {
    loop {
      let t = fetchTextureUse(row + materialTexturesRows + i * textureUseRows);
      let texel = lookUp(t, select(c.uv.xy, c.uv.zw, (t.flags & usesSecondSet) != 0u));
      share *= select(vec3f(1.0), texel.rgb, t.slot == emissionSlot);
      opacity *= select(1.0, texel.a, hasFirst & (i == 0u));
      i++;
      if (i >= wanted) {
        break;
      }
    }
  }
  let there = select(select(0.0, 1.0, opacity >= material.cutoff), opacity, material.cutoff < 0.0);
  return share * select(1.0, there, missing);
}

fn fetchSurface(i: u32) -> Surface {
  let t0 = tableTexel(9u, i);
  let t1 = tableTexel(10u, i);
  let t2 = tableTexel(11u, i);
  let t3 = tableTexel(12u, i);
  let t4 = tableTexel(13u, i);
  return Surface(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w, t4.xyz, t4.w);
}

const textureUseRows = 3u;

const emissionSlot = 1u;

struct ChosenTriangle {
  place: u32,
  density: f32,
  // Two random numbers that are left.
  u: vec2f,
}


const pointKind = 3.0;

fn samplePoint(e: Emitter, point: vec3f) -> LightSample {
  let toLight = e.position - point;
  let distance = length(toLight);
  let safe = max(distance, 1e-15);
  return LightSample(toLight / safe, distance, e.radiance / (safe * safe), select(0.0, 1.0, distance > 1e-15), true);
}

fn sampleSpot(e: Emitter, point: vec3f) -> LightSample {
  var s = samplePoint(e, point);
  let falloff = spotFalloff(e, s.direction);
  s.radiance *= falloff;
  s.pdf = select(0.0, s.pdf, falloff > 0.0);
  return s;
}

fn sampleDirectional(e: Emitter, u: vec2f) -> LightSample {
  let delta = e.area == 0.0;
  let ray = sampleCone(-e.u, e.area / (2.0 * pi0), u);
  return LightSample(ray.direction, miss, e.radiance, select(1.0 / max(e.area, 1e-31), 1.0, delta), delta);
}

fn sampleSky(u: vec2f) -> LightSample {
  var s = EnvironmentSample(sampleCone(vec3f(0.0, 0.0, 1.0), 2.0, u).direction, white);
  if (hasEnvironment) {
    s = sampleEnvironment(u);
  }
  return LightSample(s.direction, miss, s.light.radiance * sky(s.direction), s.light.pdf, false);
}

struct EnvironmentSample {
  direction: vec3f,
  light: EnvironmentLight,
}


// Without a map: white, uniform in all directions.
const white = EnvironmentLight(vec3f(1.0), 0.25 / pi0);

// A sky with a map.
override hasEnvironment = false;

fn sky(direction: vec3f) -> vec3f {
  return mix(frame.horizon, frame.zenith, max(direction.y, 0.0));
}

fn sampleEnvironment(u: vec2f) -> EnvironmentSample {
  let size = frame.environmentSize;
  let chosen = chooseCell(u);
  let k = environmentCorners(chosen.cell);
  let cell = vec2f(chosen.cell);
  let atPole = vec2<bool>(cell.y == 0.0, cell.y == size.y);
  let y = linearSample(chosen.rest.y, max(k.a.a + k.b.a, 0.0), max(k.c.a + k.d.a, 0.0));
  let t = y * select(1.0, 0.5, any(atPole)) + select(0.0, 0.5, atPole.x);
  let s = linearSample(chosen.rest.x, mix(k.a.a, k.c.a, t), mix(k.b.a, k.d.a, t));
  let isLower = 2.0 * cell.y > size.y;
  let fromPole = select(cell.y + (t - 0.5), size.y - cell.y + (0.5 - t), isLower);
  let theta = cosineAndSine(fromPole * (pi0 / size.y));
  let halfTurns = 2.0 * ((cell.x + (s - 0.5)) / size.x - frame.environmentTurn);
  let nearest = floor(halfTurns + 0.5);
  let back = fract(0.5 * nearest) > 0.0;
  let phi = cosineAndSine((halfTurns - nearest) * pi0) * select(1.0, -1.0, back);
  let sine = max(theta.y, 1e-9);
  let direction = vec3f(sine * phi.y, select(theta.x, -theta.x, isLower), -sine * phi.x);
  return EnvironmentSample(direction, lightWithin(k, vec2f(s, t), sine));
}

fn chooseCell(u: vec2f) -> ChosenCell {
  let size = vec2u(frame.environmentSize);
  let digits = vec2u(u * 16777216.0);
  // Further digits, hashed: shares in a table may be small.
  let hash = mixBits(digits.x ^ (digits.y * 0x9e3779b1u));
  let columns = (size.x + 1u) / 2u;
  let tables = size.x * size.y;
  let y = chooseEntry(Table(tables, size.y + 1u), digits.y, hash & 4095u);
  let x = chooseEntry(Table(tables + (size.y + 2u) / 2u + y.entry * columns, size.x), digits.x, hash >> 20u);
  return ChosenCell(vec2u(x.entry, y.entry), vec2f(x.rest, y.rest));
}

fn environmentCorners(cell: vec2u) -> Corners {
  let size = vec2u(frame.environmentSize);
  let left = select(cell.x, size.x, cell.x == 0u) - 1u;
  let right = select(cell.x, 0u, cell.x == size.x);
  let upper = max(cell.y, 1u) - 1u;
  let lower = min(cell.y, size.y - 1u);
  let above = vec4f(1.0, 1.0, 1.0, select(1.0, -1.0, cell.y == 0u));
  let below = vec4f(1.0, 1.0, 1.0, select(1.0, -1.0, cell.y == size.y));
  return Corners(above * environmentTexel(left, upper), above * environmentTexel(right, upper), below * environmentTexel(left, lower), below * environmentTexel(right, lower));
}

// Where in [0, 1] a number of a density that goes from a to b in a line lies.
fn linearSample(u: f32, a: f32, b: f32) -> f32 {
  let ends = vec2f(a, b) / max(a + b, 1e-37);
  return min(u / max(ends.x + sqrt(mix(ends.x * ends.x, ends.y * ends.y, u)), 1e-9), 1.0);
}

fn lightWithin(k: Corners, at: vec2f, sine: f32) -> EnvironmentLight {
  let light = mix(mix(k.a, k.b, at.x), mix(k.c, k.d, at.x), at.y);
  return EnvironmentLight(light.rgb, max(light.a, 0.0) / sine);
}

// The number is digits + fine / 4096, in steps of 2^-24. From the guide's pair of entries on in steps that double, until the share is
// beyond it; then by halves.
fn chooseEntry(t: Table, digits: u32, fine: u32) -> Choice {
  let pairs = (t.entries + 1u) / 2u;
  // digits n / 2^24 for n up to 4096: 32 bits do not hold the product.
  let part = ((digits >> 12u) * t.entries + (((digits & 4095u) * t.entries) >> 12u)) >> 12u;
  let guide = fetchEntries(t, part / 2u);
  var low = u32(select(guide.y, guide.w, (part & 1u) == 1u)) >> 12u;
  var high = pairs;
  var ends = vec2f(1.0);
  var step = 0u;
  loop {
    let next = select(min(low + step, pairs - 1u), (low + high) / 2u, high < pairs);
    let beyond = sharesBeyond(fetchEntries(t, next), digits, fine);
    let found = beyond.y > 0.0;
    ends = select(ends, beyond, found);
    high = select(high, next, found);
    low = select(next + 1u, low, found);
    step = 2u * step + 1u;
    if (low >= high) {
      break;
    }
  }
  let pair = min(high, pairs - 1u);
  let before = sharesBeyond(fetchEntries(t, max(pair, 1u) - 1u), digits, fine).y;
  let none = -(f32(digits) + f32(fine) * 0.000244140625);
  let isFirst = ends.x > 0.0;
  let start = select(ends.x, select(before, none, pair == 0u), isFirst);
  let end = select(ends.y, ends.x, isFirst);
  return Choice(min(2u * pair + select(1u, 0u, isFirst), t.entries - 1u), clamp(-start / max(end - start, 1e-37), 0.0, 1.0));
}

// packed-scene/inversion-table.ts says what is in a table: two entries a texel, from this texel on, row after row.
struct Table {
  first: u32,
  entries: u32,
}


// The cell, and where in it.
struct ChosenCell {
  cell: vec2u,
  rest: vec2f,
}


fn fetchEntries(t: Table, pair: u32) -> vec4f {
  let width = u32(frame.environmentSize.x);
  let i = t.first + pair;
  let row = i / width;
  return environmentTexel(i - row * width, row);
}

// The entry that was chosen, and where in its share the number lies, in [0, 1].
struct Choice {
  entry: u32,
  rest: f32,
}


// Shares up to and with two entries, less the number, in steps of 2^-24: exact near 0, and of the right sign anywhere.
fn sharesBeyond(pair: vec4f, digits: u32, fine: u32) -> vec2f {
  let further = vec2u(pair.yw) & vec2u(4095u);
  return (pair.xz - f32(digits)) + (vec2f(further) - f32(fine)) * 0.000244140625;
}

// As in table_texel.wesl.
fn environmentTexel(column: u32, row: u32) -> vec4f {
  return textureLoad(environment, vec2u(column, row), 0);
}

// Radiance from all around, and below it what samples it: packed-scene/pack-environment.ts.
@group(0) @binding(4) var environment: texture_2d<f32>;

// The texels at the corners of a cell. Cell (i, j) lies between the columns i - 1 and i, the rows j - 1 and j: j = 0 is the half cell at
// the upper pole, j = rows that at the lower.
struct Corners {
  a: vec4f,
  b: vec4f,
  c: vec4f,
  d: vec4f,
}


struct EnvironmentLight {
  radiance: vec3f,
  // Per solid angle.
  pdf: f32,
}


// In programs with layers it says those of the surface, and its grain, in layers/here.wesl; and the normal of its coat, in the world, in
// layers/clearcoat.wesl.
fn surfaceAt(rays: RayPair, hit: PairHit, shape: u32) -> SurfacePoint {
  let outward = normalAt(rays, hit.t, shape);
  var surface = fetchSurface(shape);
  if (hasLayers) {
    layersHere = layersOf(u32(surface.code), surface.eta.x);
  }
  if (hasCoatNormals) {
    coatNormalHere = outward;
  }
  var normals = Normals(outward, outward);
  var tangent = vec3f(0.0);
  var bitangent = vec3f(0.0);
  if (hasMeshes) {
    if (hit.triangle.instance != noInstance) {
      let m = meshPoint(hit.triangle.instance, hit.triangle.triangle, hit.weights);
      normals = Normals(m.geometric, m.shading);
      if (hasTextures) {
        let bumps = takeUpTextures(&surface, m.uv, m.color.rgb);
        tangent = m.tangent;
        bitangent = m.bitangent;
        if (hasNormalMaps) {
          if (any(bumps.base != vec3f(0.0, 0.0, 1.0))) {
            normals.shading = validNormal(m.geometric, rays.direction, bumps.base.x * m.tangent + bumps.base.y * m.bitangent + bumps.base.z * m.normal, m.shading);
          }
        }
        if (hasCoatNormals) {
          coatNormalHere = m.shading;
          if (any(bumps.coat != vec3f(0.0, 0.0, 1.0))) {
            coatNormalHere = validNormal(m.geometric, rays.direction, bumps.coat.x * m.tangent + bumps.coat.y * m.bitangent + bumps.coat.z * m.normal, m.shading);
          }
        }
      }
      let isClear = letsThrough(u32(surface.code), surface.eta.x);
      normals.shading = agreed(normals.geometric, normals.shading, rays.direction, isClear);
      if (hasCoatNormals) {
        coatNormalHere = agreed(normals.geometric, coatNormalHere, rays.direction, isClear);
      }
    }
  }
  if (hasGrain) {
    grainHere = vec3f(0.0);
    if (layersHere.anisotropy > 0.0) {
      grainHere = grainAt(normals.shading, tangent, bitangent, layersHere.grain);
    }
  }
  return SurfacePoint(surface, normals.geometric, normals.shading);
}

// Whether light may go through the surface. `eta`: Surface.eta.x, which says of metallicRoughness where its layers are.
fn letsThrough(code: u32, eta: f32) -> bool {
  return isDielectric(code) | (hasTransmission & isLayered(code) & (eta < 0.0));
}

fn basisAbout(n: vec3f) -> Basis {
  let side = select(-1.0, 1.0, n.z >= 0.0);
  let a = -1.0 / (side + n.z);
  let b = n.x * n.y * a;
  return Basis(vec3f(1.0 + side * n.x * n.x * a, side * b, -side * n.x), vec3f(b, side + n.y * n.y * a, -n.y), n);
}

override hasGrain = false;

fn toLocal(b: Basis, v: vec3f) -> vec3f {
  return vec3f(dot(v, b.tangent), dot(v, b.bitangent), dot(v, b.normal));
}

override hasGlass = false;

override hasTransmission = false;

// Clear coats that are bent by another normal map than their base, or by none where the base is.
override hasCoatNormals = false;

override hasCoats = false;

// Along the surface, where facets have a grain; else zero.
var<private> grainHere: vec3f;

// With x along a direction that lies about at right angles to the normal.
fn basisAlong(n: vec3f, x: vec3f) -> Basis {
  let tangent = normalize(x - dot(x, n) * n);
  return Basis(tangent, cross(n, tangent), n);
}

fn isThin(code: u32) -> bool {
  return hasGlass & ((code & 7u) == 7u);
}

// Its unit normal, a variable of the whole program as those of here.wesl: in the world until path.wesl has a frame for the base
// (bsdf.wesl), in that frame from then on. The same as the base's where one normal map bends both, or none.
var<private> coatNormalHere: vec3f;

// Share of the light that a coat of this weight sends back.
fn coatReflectance(coat: f32, cosine: f32) -> f32 {
  return coat * schlick(vec3f(coatF0), cosine).x;
}

var<private> layersHere: Layers;

// Between the coat's normal and a direction in that frame.
fn coatCosine(side: f32, w: vec3f) -> f32 {
  var z = w.z;
  if (hasCoatNormals) {
    z = dot(coatNormal(side), w);
  }
  return abs(z);
}

// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994; f90 = 1.
fn schlick(f0: vec3f, cosine: f32) -> vec3f {
  let m = max(1.0 - cosine, 0.0);
  let m2 = m * m;
  return f0 + (1.0 - f0) * (m2 * m2 * m);
}

const coatF0 = 0.04;

struct Layers {
  // factor on what facets of the dielectric reflect at normal incidence
  specularColor: vec3f,
  // share of what they reflect
  specularWeight: f32,
  // of the fibres on top; black: there are none
  sheenColor: vec3f,
  // alpha is its square
  sheenRoughness: f32,
  // factor on light that leaves diffusely on the other side
  beyondColor: vec3f,
  // share of the diffuse light that does
  beyond: f32,
  // cosine and sine of the angle from the tangent to the direction that highlights are drawn out in
  grain: vec2f,
  // how much they are; 0: not
  anisotropy: f32,
  // share of the diffuse body that is a refracting boundary instead
  transmission: f32,
  // share of the surface that has a clear coat
  coat: f32,
  // alpha is its square
  coatRoughness: f32,
  // index of the body
  ior: f32,
  // 1: the body is solid; 0: a thin wall
  solid: f32,
  // share of the surface that has a thin film
  film: f32,
  // its index
  filmIor: f32,
  // nanometres; where a texture says how thick: where it is 1
  filmThickness: f32,
  // its thickness where that texture is 0
  filmLeast: f32,
  // 20 / Abbe number
  dispersion: f32,
  // unused
  spare0: f32,
  // unused
  spare1: f32,
  // unused
  spare2: f32,
}


// `side` -1: as it is in the frame that is mirrored, where the coat of the other side of a thin wall is above.
fn coatNormal(side: f32) -> vec3f {
  return vec3f(side * coatNormalHere.xy, coatNormalHere.z);
}

// The geometric normal where the path's ray ends on a shape that is no mesh: unit length, out of solids.
fn normalAt(p: RayPair, t: f32, i: u32) -> vec3f {
  let b = fetchBounds(i);
  let origin = p.point - b.center;
  var normal = b.center;
  if (hasQuads) {
    let e = fetchExtent(i);
    normal = select(cross(e.a.xyz, e.b.xyz), normal, isPlane(i));
  }
  if (hasBoxes) {
    let e = fetchExtent(i);
    let inside = (i == p.shape) & p.inwards;
    let face = boxNormal(turned(e.a, origin), turned(e.a, p.direction), e.b.xyz, p.tMin, inside);
    normal = select(normal, turnedBack(e.a, face), isBox(i));
  }
  if (hasSpheres) {
    // From so far away that its hits are rounded to its centre, a sphere faces the ray.
    let outwards = origin + t * p.direction;
    normal = select(normal, select(outwards, -p.direction, dot(outwards, outwards) == 0.0), isSphere(i));
  }
  return normalize(normal);
}

// What glTF's extensions add to metallicRoughness: any of them, and those that take a program something of their own. Light that goes
// through is one, be it by facets or diffusely.
override hasLayers = false;

struct Normals {
  geometric: vec3f,
  shading: vec3f,
}


struct SurfacePoint {
  surface: Surface,
  // Unit vectors in the world, out of solids or to the front of triangles. Only meshes have two that differ.
  geometric: vec3f,
  shading: vec3f,
}


// Those of glTF's own material where there are none.
fn layersOf(code: u32, eta: f32) -> Layers {
  var l: Layers;
  l.specularColor = vec3f(1.0);
  l.specularWeight = 1.0;
  l.ior = 1.5;
  if (isLayered(code) & (eta != 0.0)) {
    l = fetchLayers(u32(abs(eta)));
  }
  return l;
}

// In a program with layers every metallicRoughness material has some, if only such as change nothing: its facets stand in the program once.
fn isLayered(code: u32) -> bool {
  return hasLayers & isMetallicRoughness(code);
}

fn fetchLayers(i: u32) -> Layers {
  let t0 = tableTexel(0u, i);
  let t1 = tableTexel(1u, i);
  let t2 = tableTexel(2u, i);
  let t3 = tableTexel(3u, i);
  let t4 = tableTexel(4u, i);
  let t5 = tableTexel(5u, i);
  let t6 = tableTexel(6u, i);
  return Layers(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xy, t3.z, t3.w, t4.x, t4.y, t4.z, t4.w, t5.x, t5.y, t5.z, t5.w, t6.x, t6.y, t6.z, t6.w);
}

fn isMetallicRoughness(code: u32) -> bool {
  return hasMetallicRoughness & (kindOf(code) == metallicRoughness);
}

override hasMetallicRoughness = false;

// These take Surface.code as an integer and not the struct: a compiler that copies structs at each call needs minutes.
fn kindOf(code: u32) -> u32 {
  return code & 3u;
}

const metallicRoughness = 1u;

// `weights`: of the triangle's second and third vertex.
fn meshPoint(instance: u32, place: u32, weights: vec2f) -> MeshPoint {
  let i = fetchInstance(frame.instances + instance * instanceRows);
  let triangle = fetchTriangle(i.triangles + place * triangleRows);
  // Normals go by the inverse transpose: its columns are the rows of the way into the mesh.
  let turn = mat3x3f(i.toMeshX.xyz, i.toMeshY.xyz, i.toMeshZ.xyz);
  let geometric = normalize(turn * cross(triangle.b - triangle.a, triangle.c - triangle.a));
  var p = MeshPoint(geometric, geometric, vec3f(0.0), vec3f(0.0), geometric, vec4f(0.0), vec4f(1.0));
  if (i.vertexRows != 0u) {
    let rows = i.vertices + vec3u(triangle.vertexA, triangle.vertexB, triangle.vertexC) * i.vertexRows;
    let a = fetchVertex(rows.x);
    let b = fetchVertex(rows.y);
    let c = fetchVertex(rows.z);
    let share = vec3f(1.0 - weights.x - weights.y, weights);
    // In the space of the mesh, and of any length, as MikkTSpace wants it.
    let normal = share.x * fromOctahedral(a.normal) + share.y * fromOctahedral(b.normal) + share.z * fromOctahedral(c.normal);
    let smoothed = turn * normal;
    let size = dot(smoothed, smoothed);
    let side = select(1.0, -1.0, dot(smoothed, geometric) < 0.0);
    // Normals that cancel out, between two that look opposite ways, are none.
    let useful = ((i.vertexFlags & hasNormals) != 0u) & (size > 0.0);
    p.shading = select(geometric, smoothed * (side * inverseSqrt(max(size, 1e-37))), useful);
    if (hasTextures) {
      p.uv = vec4f(share.x * a.uv + share.y * b.uv + share.z * c.uv, 0.0, 0.0);
      if (hasVertexMore) {
        if (i.vertexRows > vertexRows) {
          let moreA = fetchVertexMore(rows.x + vertexRows);
          let moreB = fetchVertexMore(rows.y + vertexRows);
          let moreC = fetchVertexMore(rows.z + vertexRows);
          p.uv = vec4f(p.uv.xy, share.x * moreA.uv + share.y * moreB.uv + share.z * moreC.uv);
          let redGreen = share.x * pairOf(moreA.redGreen) + share.y * pairOf(moreB.redGreen) + share.z * pairOf(moreC.redGreen);
          let blueAlpha = share.x * pairOf(moreA.blueAlpha) + share.y * pairOf(moreB.blueAlpha) + share.z * pairOf(moreC.blueAlpha);
          p.color = clamp(vec4f(redGreen, blueAlpha), vec4f(0.0), vec4f(1.0));
        }
      }
      if (hasNormalMaps) {
        if (useful & ((i.vertexFlags & hasTangents) != 0u)) {
          let tangent = share.x * fromOctahedral(a.tangent) + share.y * fromOctahedral(b.tangent) + share.z * fromOctahedral(c.tangent);
          // The vertices of a triangle have one hand: else they would not be shared.
          let hand = select(1.0, -1.0, (a.tangent & 0x10000u) != 0u);
          p.normal = smoothed * side;
          p.tangent = turn * tangent * side;
          p.bitangent = turn * cross(normal, tangent) * (hand * side);
        }
      }
    }
  }
  return p;
}

// Textures, and colours at the vertices of meshes.
override hasTextures = false;

// Where the two normals of a body that light goes through do not agree on which side a ray comes from, the geometric one is right.
fn agreed(geometric: vec3f, shading: vec3f, direction: vec3f, isClear: bool) -> vec3f {
  let agree = (dot(geometric, direction) > 0.0) == (dot(shading, direction) > 0.0);
  return select(shading, geometric, isClear & !agree);
}

// `uv`: both sets of coordinates.
fn takeUpTextures(s: ptr<function, Surface>, uv: vec4f, color: vec3f) -> Bumps {
  let row = u32((*s).textures);
  let material = fetchMaterialTextures(row);
  let unlit = (material.flags & isUnlit) != 0u;
  (*s).baseColor *= color;
  (*s).emission *= select(vec3f(1.0), color, unlit);
  var bumps = Bumps(vec3f(0.0, 0.0, 1.0), vec3f(0.0, 0.0, 1.0));
  var i = 0u;
  // One call for all textures: compilers write out each.
  if (material.count > 0u) {
    loop {
      let t = fetchTextureUse(row + materialTexturesRows + i * textureUseRows);
      var place = uv.xy;
      if (hasVertexMore) {
        place = select(uv.xy, uv.zw, (t.flags & usesSecondSet) != 0u);
      }
      let texel = lookUp(t, place);
      (*s).baseColor *= select(vec3f(1.0), texel.rgb, t.slot == baseColorSlot);
      (*s).emission *= select(vec3f(1.0), texel.rgb, t.slot == emissionSlot);
      let share = select(vec2f(1.0), texel.gb, t.slot == metallicRoughnessSlot);
      let rough = max((*s).alpha * share.x * share.x, leastAlpha);
      (*s).alpha = select(rough, (*s).alpha, isSmooth(u32((*s).code)));
      (*s).metallic *= share.y;
      let bump = (2.0 * texel.xyz - 1.0) * vec3f(t.scale, t.scale, 1.0);
      bumps.base = select(bumps.base, bump, t.slot == normalSlot);
      if (hasCoatNormals) {
        bumps.coat = select(bumps.coat, bump, t.slot == coatNormalSlot);
      }
      if (hasLayers) {
        takeUpLayer(t.slot, texel);
      }
      i++;
      if (i >= material.count) {
        break;
      }
    }
  }
  return bumps;
}

// Of textures: normal maps, or grain, which need frames of tangents; colours at vertices or a second set of coordinates, which lie side by
// side; and such that are not repeated and looked up linearly.
override hasNormalMaps = false;

// A map's normal of any length, to the side of `geometric`; `direction` of the ray that meets the surface. `otherwise`: where the map
// gives none.
fn validNormal(geometric: vec3f, direction: vec3f, mapped: vec3f, otherwise: vec3f) -> vec3f {
  let size = dot(mapped, mapped);
  let n = select(otherwise, mapped * inverseSqrt(max(size, 1e-37)), size > 0.0);
  let side = select(1.0, -1.0, dot(geometric, direction) > 0.0);
  return side * bent(side * geometric, -direction, side * n);
}

// Normals out of a normal map, bent to where they make sense.
//
// Seen at a grazing angle, a normal that a map has tilted may look away from the eye, or reflect the eye's ray into the surface: black
// spots, or light from behind. Cycles turns such a normal towards the geometric one, just as far as the mirrored ray needs to come out
// of the surface again (Blender, intern/cycles/kernel/closure/bsdf_util.h, `ensure_valid_specular_reflection`, L. Stockner): so do we.
// The surface is then another one for each direction of view, and reciprocal only where nothing had to be bent.
// All unit vectors; `n` on the side of `g` that `o`, towards the eye, is on.
fn bent(g: vec3f, o: vec3f, n: vec3f) -> vec3f {
  let oz = max(dot(o, g), 0.0);
  // The mirrored ray may be as flat as the one to the eye.
  let least = min(0.9 * oz, 0.01);
  let across = n - dot(n, g) * g;
  let x = across * inverseSqrt(max(dot(across, across), 1e-20));
  let ox = dot(o, x);
  // In the plane of g and n: which normal reflects o to the height `least`?
  let a = max(ox * ox + oz * oz, 1e-20);
  let b = 2.0 * (a + oz * least);
  let c = (least + oz) * (least + oz);
  let root = sqrt(max(b * b - 4.0 * a * c, 0.0));
  let z2 = clamp(0.25 * select(b - root, b + root, ox < 0.0) / a, 0.0, 1.0);
  let raised = sqrt(1.0 - z2) * x + sqrt(z2) * g;
  let reflected = 2.0 * dot(n, o) * n - o;
  return select(raised, n, dot(g, reflected) >= least);
}

const isUnlit = 1u;

// What the normal maps of base and coat say, in the frame of tangent, bitangent and normal; of any length.
struct Bumps {
  base: vec3f,
  coat: vec3f,
}


override hasVertexMore = false;

const baseColorSlot = 0u;

const metallicRoughnessSlot = 2u;

// The GGX microfacet distribution with Smith's masking, isotropic, seen from +z: Walter et al., "Microfacet Models for
// Refraction through Rough Surfaces", EGSR 2007; Heitz, "Understanding the Masking-Shadowing Function", JCGT 2014.
// Written so that nothing is divided by a cosine: grazing directions need no special case.
// Narrower highlights are a mirror's: packed-scene/surface-values.ts.
const leastAlpha = 1e-3;

// Whether what reflects or refracts does so like a mirror.
fn isSmooth(code: u32) -> bool {
  return (code & 32u) != 0u;
}

const normalSlot = 3u;

const coatNormalSlot = 16u;

fn takeUpLayer(slot: u32, texel: vec4f) {
  layersHere.specularWeight *= select(1.0, texel.a, slot == specularWeightSlot);
  layersHere.specularColor *= select(vec3f(1.0), texel.rgb, slot == specularColorSlot);
  if (hasTransmission) {
    layersHere.transmission *= select(1.0, texel.r, slot == transmissionSlot);
    layersHere.beyond *= select(1.0, texel.a, slot == beyondSlot);
    layersHere.beyondColor *= select(vec3f(1.0), texel.rgb, slot == beyondColorSlot);
  }
  if (hasCoats) {
    layersHere.coat *= select(1.0, texel.r, slot == coatSlot);
    layersHere.coatRoughness *= select(1.0, texel.g, slot == coatRoughnessSlot);
  }
  if (hasSheen) {
    layersHere.sheenColor *= select(vec3f(1.0), texel.rgb, slot == sheenColorSlot);
    layersHere.sheenRoughness *= select(1.0, texel.a, slot == sheenRoughnessSlot);
  }
  if (hasIridescence) {
    layersHere.film *= select(1.0, texel.r, slot == filmSlot);
    let thickness = mix(layersHere.filmLeast, layersHere.filmThickness, texel.g);
    layersHere.filmThickness = select(layersHere.filmThickness, thickness, slot == filmThicknessSlot);
  }
  if (hasGrain) {
    let isGrain = slot == anisotropySlot;
    layersHere.anisotropy *= select(1.0, texel.b, isGrain);
    // A direction in the frame of tangents, which the material's angle turns.
    let given = 2.0 * texel.rg - 1.0;
    let size = dot(given, given);
    let d = select(vec2f(1.0, 0.0), given * inverseSqrt(max(size, 1e-20)), size > 1e-6);
    let own = layersHere.grain;
    layersHere.grain = select(own, vec2f(own.x * d.x - own.y * d.y, own.y * d.x + own.x * d.y), isGrain);
  }
}

const specularWeightSlot = 4u;

const specularColorSlot = 5u;

override hasSheen = false;

override hasIridescence = false;

const transmissionSlot = 6u;

const beyondSlot = 7u;

const beyondColorSlot = 8u;

const coatSlot = 9u;

const coatRoughnessSlot = 10u;

const sheenColorSlot = 11u;

const sheenRoughnessSlot = 12u;

const filmSlot = 14u;

const filmThicknessSlot = 15u;

const anisotropySlot = 13u;

struct MeshPoint {
  // Unit vectors in the world, both to the side from which the triangle's vertices go counter-clockwise.
  geometric: vec3f,
  shading: vec3f,
  // For textures. The frame of normal maps in the world: their x, y and z times these three add up to a normal, of any length.
  tangent: vec3f,
  bitangent: vec3f,
  normal: vec3f,
  // Both sets of coordinates.
  uv: vec4f,
  // Linear, with opacity.
  color: vec4f,
}


// Unit vectors as two numbers of 16 bits: the octahedron unfolded onto a square (Meyer et al., "On Floating-Point Normal Vectors",
// EGSR 2010). packed-scene/octahedral.ts writes them.
fn fromOctahedral(code: u32) -> vec3f {
  let p = vec2f(f32(code & 0xffffu), f32(code >> 16u)) * (2.0 / 65534.0) - 1.0;
  let z = 1.0 - abs(p.x) - abs(p.y);
  let folded = (1.0 - abs(p.yx)) * select(vec2f(1.0), vec2f(-1.0), p < vec2f(0.0));
  return normalize(vec3f(select(p, folded, z < 0.0), z));
}

const hasNormals = 1u;

const hasTangents = 2u;

// In the world; `tangent` and `bitangent` of the mesh, of any length, or zero where it has none. `grain`: cosine and sine of the angle from
// the one towards the other. Never along the normal.
fn grainAt(normal: vec3f, tangent: vec3f, bitangent: vec3f, grain: vec2f) -> vec3f {
  let along = tangent - dot(tangent, normal) * normal;
  let size = dot(along, along);
  let own = size > 1e-12 * dot(tangent, tangent);
  let t = select(tangentAbout(normal), along * inverseSqrt(max(size, 1e-37)), own);
  let across = cross(normal, t);
  let hand = select(1.0, -1.0, own & (dot(across, bitangent) < 0.0));
  return grain.x * t + grain.y * hand * across;
}

// The direction along which anisotropic facets are rougher.
// Where a shape has no frame of tangents: that of growing longitude about the Y axis, as the tangent of a globe's texture coordinates; +X at
// its poles. `normal`: outwards.
fn tangentAbout(normal: vec3f) -> vec3f {
  let east = vec3f(normal.z, 0.0, -normal.x);
  let length2 = dot(east, east);
  return select(vec3f(1.0, 0.0, 0.0), east * inverseSqrt(max(length2, 1e-20)), length2 > 1e-12);
}

fn isPlane(i: u32) -> bool {
  return (i >= frame.shapeEnds.z) & (i < frame.shapeEnds.w);
}

// Outward normal where the ray meets the box: of the faces that it crosses there, not of those that the rounded point happens
// to be near, so that thin boxes have two sides. One axis only, on edges too.
fn boxNormal(origin: vec3f, direction: vec3f, halfSize: vec3f, tMin: f32, startsInside: bool) -> vec3f {
  let s = boxSlabs(origin, direction, halfSize);
  let entering = (s.near > tMin) & !startsInside;
  let crossed = select(s.leave, s.enter, entering);
  let t = select(s.far, s.near, entering);
  let side = select(1.0, -1.0, entering) * select(vec3f(-1.0), vec3f(1.0), direction > vec3f(0.0));
  let onX = crossed.x == t;
  let onY = !onX & (crossed.y == t);
  return side * select(vec3f(0.0), vec3f(1.0), vec3<bool>(onX, onY, !(onX | onY)));
}

fn turnedBack(q: vec4f, v: vec3f) -> vec3f {
  return turned(vec4f(-q.xyz, q.w), v);
}

fn isBox(i: u32) -> bool {
  return (i >= frame.shapeEnds.x) & (i < frame.shapeEnds.y);
}

fn isSphere(i: u32) -> bool {
  return i < frame.shapeEnds.x;
}

fn isDielectric(code: u32) -> bool {
  return hasGlass & (kindOf(code) == dielectric);
}

const dielectric = 3u;

fn scatter(p: ptr<function, Path>, hit: PairHit, m: Meeting, lit: Lit) {
  let rays = (*p).rays;
  let escaped = hit.shape == noShape;
  let light = lit.light;
  var hero = vec3f(1.0);
  if (hasTransmission) {
    if (m.isClear & (layersHere.dispersion > 0.0)) {
      hero = heroColor((*p).throughput, nextHash(&(*p).sampler));
    }
  }
  let o = outgoing(m.surface, m.wo, hero);
  let drawn = sampleLobe(m.surface, o, lit.u);
  let values = evaluatePair(m.surface, o, toLocal(m.basis, light.direction), drawn);
  // What is opaque lets no light through, even where a shading normal says that it comes from the front.
  let opaque = hasMeshes & !m.isClear;
  let lightLeaks = opaque & crosses(m.geometric, light.direction, -rays.direction);
  let toLight = select(values.toLight, vec4f(0.0), lightLeaks);
  // A light that rays cannot meet is found by light sampling only.
  let alone = light.delta | ((lit.shape < 0.0) & (light.distance < miss));
  let lightWeight = select(misWeight(lit.pdf, toLight.a), 1.0, alone) / lit.pdf;
  let bsdf = values.drawn;
  let direction = toWorld0(m.basis, bsdf.direction);
  let leaks = opaque & crosses(m.geometric, direction, -rays.direction);
  let goesOn = !escaped & ((*p).depth != frame.maxDepth);
  let contribution = (*p).throughput * toLight.rgb * light.radiance * lightWeight;
  let isLit = goesOn & (lit.pdf > 0.0) & any(toLight.rgb * light.radiance > vec3f(0.0));
  (*p).light = select(vec3f(0.0), contribution, isLit);
  let throughput = (*p).throughput * bsdf.weight;
  let survival = select(min(max3(throughput) / rouletteShare, 0.95), 1.0, (*p).depth < rouletteDepth);
  let alive = goesOn & (bsdf.pdf > 0.0) & !leaks & (max3(throughput) > 0.0) & (nextHash(&(*p).sampler) < survival);
  (*p).depth++;
  // A ray that escaped is still asked for.
  let stays = !hasMeshes & escaped;
  (*p).throughput = select(throughput / survival, (*p).throughput, stays);
  (*p).pdf = select(select(bsdf.pdf, 0.0, bsdf.delta), (*p).pdf, stays);
  (*p).litSide = select(litSideOf(m), (*p).litSide, stays);
  (*p).odds.total = select(lit.odds.total, (*p).odds.total, stays);
  (*p).odds.tree = select(lit.odds.tree, (*p).odds.tree, stays);
  let solid = !isFlat(m.shape);
  let lightShape = select(noShape, u32(max(lit.shape, 0.0)), lit.shape >= 0.0);
  (*p).rays = RayPair(select(m.point, rays.point, stays), m.shape, hit.triangle, relativeTMin * length(m.point), alive, select(direction, rays.direction, stays), solid & (dot(direction, m.outward) < 0.0), light.direction, solid & (dot(light.direction, m.outward) < 0.0), select(-1.0, light.distance, isLit), lightShape, numberOfNext((*p).sampler));
}

// The layers are those of layers/here.wesl. `hero`: layers/transmission.wesl; white where colours do not part.
fn outgoing(s: Surface, wo: vec3f, hero: vec3f) -> Outgoing {
  let code = u32(s.code);
  var o = Outgoing(wo, select(0.0, 1.0, isConductor(code) | isDielectric(code)), 1.0, 1.0, 1.0);
  if (hasLayers) {
    if (isLayered(code)) {
      meetLayers(s, wo, hero);
    }
  }
  if (hasMetallicRoughness) {
    if (!hasLayers) {
      o.share = select(o.share, specularShare(s.baseColor, s.metallic, wo.z), isMetallicRoughness(code));
    }
  }
  if (hasGlass) {
    o.ratio = select(1.0, indexRatio(s.eta.x, wo.z, isThin(code)), isDielectric(code));
  }
  if (hasConductors | (hasMetallicRoughness & !hasLayers) | hasGlass) {
    o.bound = select(reflectionBound(wo, s.alpha), 1.0, isDielectric(code));
    o.stretched = stretched(wo, s.alpha);
  }
  return o;
}

// A direction by one of the lobes. A sample of a delta lobe is complete; of any other the density and weight of all lobes together
// are still to be had from evaluatePair. u in [0, 1)^3: two for the direction, the third chooses the lobe.
fn sampleLobe(s: Surface, o: Outgoing, u: vec3f) -> BsdfSample {
  let wo = o.wo;
  let mirror = mirrorShare(s.reflectivity);
  let base = 1.0 - mirror;
  // What is left of u.z is uniform again, and once more below.
  let choice = (u.z - mirror) / base;
  var drawn = BsdfSample(sampleCosine(u.xy), 1.0, vec3f(1.0), false);
  if (hasConductors | (hasMetallicRoughness & !hasLayers) | hasGlass) {
    let code = u32(s.code);
    let isGlass = isDielectric(code);
    let delta = isSmooth(code);
    let h = sampleFacet(s.alpha, delta, o, u.xy);
    let oh = max(dot(wo, h), 0.0);
    let f = facetReflectance(s, oh, o.ratio);
    let crossing = isGlass & (choice >= f.x);
    var wi = 2.0 * oh * h - wo;
    var probability = base * o.share;
    var weight = f / o.share;
    if (hasGlass) {
      let thin = isThin(code);
      wi = select(wi, select(refracted(wo, h, o.ratio), -wo, thin), crossing);
      probability = select(probability, base * select(f.x, 1.0 - f.x, crossing), isGlass);
      weight = select(weight, vec3f(select(1.0, 1.0 / (o.ratio * o.ratio), crossing & !thin)), isGlass);
    }
    // A facet may send light to the wrong side: it is lost, as in single scattering.
    let lost = !delta & (crossing != ((wo.z < 0.0) != (wi.z < 0.0)));
    let specular = choice < o.share;
    drawn.direction = select(drawn.direction, wi, specular);
    drawn.pdf = select(drawn.pdf, select(probability, 0.0, lost), specular);
    drawn.weight = select(drawn.weight, weight, specular);
    drawn.delta = specular & delta;
  }
  if (hasLayers) {
    if (isLayered(u32(s.code))) {
      let layered = sampleLayered(s, vec3f(u.xy, choice));
      drawn = BsdfSample(layered.direction, base * layered.pdf, vec3f(0.0), layered.delta);
    }
  }
  if (hasMirrorLayers) {
    let reflected = u.z < mirror;
    drawn.direction = select(drawn.direction, mirrored(wo), reflected);
    drawn.pdf = select(drawn.pdf, mirror, reflected);
    drawn.weight = select(drawn.weight, vec3f(1.0), reflected);
    drawn.delta = drawn.delta | reflected;
  }
  return drawn;
}

// What there is to know of the direction to the light and of the one that sampleLobe gave.
fn evaluatePair(s: Surface, o: Outgoing, toLight: vec3f, drawn: BsdfSample) -> Pair {
  var pair = Pair(evaluateBsdf(s, o, toLight), completed(drawn, evaluateBsdf(s, o, drawn.direction)));
  if (hasLayers) {
    if (isLayered(u32(s.code))) {
      // Not by the mirror over everything, whose weight is known.
      let byMirror = drawn.delta & !any(drawn.weight > vec3f(0.0));
      let base = 1.0 - mirrorShare(s.reflectivity);
      let layered = evaluateLayers(s, toLight, drawn.direction, byMirror);
      pair.toLight = base * layered.toLight;
      let ofSample = completed(BsdfSample(drawn.direction, drawn.pdf, drawn.weight, drawn.delta & !byMirror), base * layered.toSample);
      pair.drawn = BsdfSample(ofSample.direction, ofSample.pdf, ofSample.weight, drawn.delta);
    }
  }
  return pair;
}

// Whether one of two directions away from a surface points into it and the other out of it.
fn crosses(geometric: vec3f, a: vec3f, b: vec3f) -> bool {
  return (dot(geometric, a) > 0.0) != (dot(geometric, b) > 0.0);
}

fn toWorld0(b: Basis, v: vec3f) -> vec3f {
  return v.x * b.tangent + v.y * b.bitangent + v.z * b.normal;
}

fn max3(v: vec3f) -> f32 {
  return max(max(v.x, v.y), v.z);
}

const rouletteShare = 1.0 / 3.0;

// From this depth on paths end by chance, if they bring less than this share of their light: sooner, and the paths that are left
// weigh so much that the noise costs more than the rays that were saved.
const rouletteDepth = 5u;

fn isFlat(i: u32) -> bool {
  return i >= frame.shapeEnds.y;
}

// One colour stands for all where colours go different ways. It is chosen as often as it carries light, and weighs the more the less often:
// so the mean is right, and a path of one colour keeps it.
fn heroColor(throughput: vec3f, u: f32) -> vec3f {
  let share = throughput / max(dot(throughput, vec3f(1.0)), 1e-30);
  let isRed = u < share.x;
  let isBlue = !isRed & (u >= share.x + share.y) & (share.z > 0.0);
  let chosen = select(select(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0), isBlue), vec3f(1.0, 0.0, 0.0), isRed);
  return chosen / max(dot(chosen, share), 1e-6);
}

// One more number of this sample, independent of all others: for choices that nothing is gained by stratifying.
fn nextHash(s: ptr<function, Sampler>) -> f32 {
  (*s).key = (*s).key + 1u;
  return unitFloat(mixBits(mixBits((*s).key ^ (*s).salt) + (((*s).sample * 256u) | (*s).place)));
}

// What follows from the direction that light leaves in, whichever it comes from.
struct Outgoing {
  wo: vec3f,
  // Probability of the lobe that reflects or refracts at facets; what is left samples the diffuse one.
  share: f32,
  // Of a dielectric: the index behind the boundary over that on wo's side.
  ratio: f32,
  // ggx.wesl, of wo.
  bound: f32,
  stretched: f32,
}


fn isConductor(code: u32) -> bool {
  return hasConductors & (kindOf(code) == conductor);
}

override hasConductors = false;

// Works out stackHere.
fn meetLayers(s: Surface, given: vec3f, hero: vec3f) {
  let side = select(1.0, -1.0, given.z < 0.0);
  let wo = vec3f(given.xy, given.z * side);
  let metallic = s.metallic;
  stackHere.wo = wo;
  stackHere.side = side;
  stackHere.hero = hero;
  stackHere.inside = false;
  stackHere.ratio = 1.0;
  stackHere.alpha = ellipticAlpha(s.alpha, layersHere.anisotropy);
  if (hasTransmission) {
    let isSolid = layersHere.solid > 0.0;
    let inside = isSolid & (side < 0.0);
    let index = dispersedIndex(layersHere.ior, layersHere.dispersion, hero);
    let flat = isSolid & (layersHere.transmission > 0.0) & (index - 1.0 < leastContrast);
    stackHere.inside = inside;
    stackHere.ratio = select(1.0, select(index, 1.0 / index, inside), isSolid);
    stackHere.alpha = select(stackHere.alpha, vec2f(0.0), flat);
  }
  stackHere.coat = 0.0;
  if (hasCoats) {
    stackHere.coat = select(coatReflectance(layersHere.coat, coatCosine(side, wo)), 0.0, stackHere.inside);
    stackHere.coatAlpha = layersHere.coatRoughness * layersHere.coatRoughness;
  }
  stackHere.sheenColor = 0.0;
  stackHere.sheen = 0.0;
  if (hasSheen) {
    stackHere.sheenColor = greatest(layersHere.sheenColor);
    if (stackHere.sheenColor > 0.0) {
      stackHere.sheen = select(sheenAlbedo(wo.z, layersHere.sheenRoughness), 0.0, stackHere.inside);
    }
  }
  let f0 = layersHere.specularWeight * dielectricF0();
  stackHere.more = vec3f(1.0);
  if (hasCompensation) {
    let albedo = singleScatteringAlbedo(wo.z, sqrt(stackHere.alpha.x * stackHere.alpha.y));
    let asked = ((u32(s.code) & 8u) != 0u) & (layersHere.transmission <= 0.0);
    stackHere.more = select(vec3f(1.0), 1.0 + mix(f0, s.baseColor, metallic) * ((1.0 - albedo) / albedo), asked);
  }

  // Lobes are chosen by about the light that they send to wo. The diffuse ones keep nearly all of theirs even when wo is grazing:
  // metallic_roughness.wesl. A film's colours vanish at some angles only.
  let bare = bareReflectance(s, wo.z);
  let met = mix(bare.dielectric, bare.metal, metallic);
  let enters = (1.0 - metallic) * (1.0 - greatest(bare.dielectric));
  let color = mean3(s.baseColor);
  let coat = stackHere.coat;
  let below = (1.0 - coat) * (1.0 - stackHere.sheenColor * min(stackHere.sheen, 1.0));
  let facets = below * (mean3(met) + 0.25 * layersHere.film + enters * layersHere.transmission * color);
  let fibres = (1.0 - coat) * stackHere.sheen * mean3(layersHere.sheenColor);
  let body = below * (1.0 - metallic) * (1.0 - greatest(f0)) * (1.0 - layersHere.transmission);
  let diffuse = body * (1.0 - layersHere.beyond) * color;
  let beyond = body * layersHere.beyond * mean3(layersHere.beyondColor);
  let all = max(coat + facets + fibres + diffuse + beyond, 1e-20);
  stackHere.ofCoat = coat / all;
  stackHere.ofFacets = facets / all;
  stackHere.ofSheen = fibres / all;
  stackHere.ofDiffuse = diffuse / all;
}

var<private> stackHere: Stack;

// KHR_materials_anisotropy: strength makes facets rougher along x. Across, a highlight is no narrower than 32-bit floats can hold.
fn ellipticAlpha(alpha: f32, strength: f32) -> vec2f {
  return select(vec2f(alpha), vec2f(mix(alpha, 1.0, strength * strength), max(alpha, leastAlpha)), strength > 0.0);
}

// KHR_materials_ior and KHR_materials_specular: what facets of the dielectric would reflect at normal incidence at full weight.
fn dielectricF0() -> vec3f {
  let contrast = (layersHere.ior - 1.0) / (layersHere.ior + 1.0);
  return min(contrast * contrast * layersHere.specularColor, vec3f(1.0));
}

override hasCompensation = false;

// Without a film.
fn bareReflectance(s: Surface, cosine: f32) -> Reflectance {
  let outer = outerCosine(cosine);
  var dielectric = layersHere.specularWeight * schlick(dielectricF0(), outer);
  if (hasTransmission) {
    dielectric = select(dielectric, vec3f(1.0), reflectsAll(cosine, stackHere.ratio));
  }
  return Reflectance(dielectric, schlick(s.baseColor, outer));
}

fn mean3(v: vec3f) -> f32 {
  return dot(v, vec3f(1.0 / 3.0));
}

// KHR_materials_transmission and KHR_materials_volume: light that goes through facets.
// KHR_materials_dispersion: the index that red, green or blue light meets; `hero` is the colour that the path goes on with, or white.
// Below the index of air no dispersion goes.
fn dispersedIndex(ior: f32, dispersion: f32, hero: vec3f) -> f32 {
  let side = select(0.0, 1.0, hero.z > 0.0) - select(0.0, 1.0, hero.x > 0.0);
  return max(ior + side * (ior - 1.0) * 0.025 * dispersion, 1.0);
}

// An index closer to 1 bends light by less than a rough boundary can be told from a smooth one in 32-bit floats.
const leastContrast = 1e-3;

fn greatest(v: vec3f) -> f32 {
  return max(max(v.x, v.y), v.z);
}

// E: share of light that white fibres send back to a direction of this cosine; of fine ones along the surface it is more than 1, a gap
// of the model. A fit, 0.005 off at most, or 0.5 % where E is above 1 (scripts/fits/sheen-albedo.ts), and that much is added: what lies
// below loses rather too much than too little.
fn sheenAlbedo(cosine: f32, roughness: f32) -> f32 {
  // -1 at a cosine of 1e-4 and at the least roughness, 1 at 1.
  let u = (sqrt(sqrt(clamp(cosine, 1e-4, 1.0))) - 0.1) / 0.45 - 1.0;
  let v = (sqrt(max(roughness, leastSheenRoughness)) - 0.264575) / 0.367712 - 1.0;
  let low = vec3f(0.746962, 0.0397496, 0.224802) + u * (vec3f(-0.448339, 0.3406, -0.509736) + u * (vec3f(-0.196284, 0.0161825, -0.50469) + u * (vec3f(0.0587112, 0.187983, 0.191769) + u * (vec3f(-0.182064, 0.425384, 0.971703) + u * (vec3f(0.0763965, -0.331055, 0.616069) + u * (vec3f(0.0893496, -0.409073, -0.445006) + u * vec3f(-0.0525425, 0.0277158, -0.421496)))))));
  let high = vec3f(-0.0321953, -0.190573, 0.0715297) + u * (vec3f(0.492365, -0.201291, -0.00570256) + u * (vec3f(0.833264, 0.765625, -1.06831) + u * (vec3f(-1.29238, 0.71056, 0.237437) + u * (vec3f(-2.81818, -0.673857, 2.17806) + u * (vec3f(0.500911, -0.777981, 0.0143213) + u * (vec3f(1.97956, 0.108218, -1.28939) + u * vec3f(0.324871, 0.21472, -0.194708)))))));
  let v2 = v * v;
  let root = dot(low + v2 * v * high, vec3f(1.0, v, v2));
  let albedo = root * root;
  return albedo + 0.005 * max(albedo, 1.0);
}

// KHR_materials_sheen: fibres that stand on the surface. Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017
// course notes: the distribution "Charlie", and a fit of the shadowing that was measured on it.
// Finer fibres shine in so thin a rim that 32-bit floats do not hold it; roughness, not alpha.
const leastSheenRoughness = 0.07;

// Share of light that comes back from wo when every facet reflects all, but light that meets a second facet is lost. A minimax
// fit of the integral, 0.4 % off at most for |cos| >= 0.04: polynomials in alpha and in cosine / (cosine + alpha), since the
// loss near the horizon is a function of that ratio alone as alpha goes to 0.
fn singleScatteringAlbedo(cosine: f32, alpha: f32) -> f32 {
  let x = cosine / (cosine + alpha);
  let byAlpha = vec4f(0.887807, 0.309386, -0.270728, 0.0252433) + x * (vec4f(1.08526, -3.21434, -1.87718, 1.61195) + x * (vec4f(-5.18071, 10.7648, 6.30913, -8.09265) + x * (vec4f(7.80474, -12.7430, -24.1046, 25.2536) + x * vec4f(-3.60041, 4.60906, 23.1225, -22.9342))));
  let a2 = alpha * alpha;
  return min(dot(byAlpha, vec4f(1.0, alpha, a2, a2 * alpha)), 1.0);
}

// What follows from the direction that light leaves in, whichever it comes from.
struct Stack {
  // Above the surface.
  wo: vec3f,
  // -1: wo was below.
  side: f32,
  // Colour that refracted light goes on with, times its weight: transmission.wesl.
  hero: vec3f,
  // Of a solid: the index beyond the boundary over that on wo's side; else 1.
  ratio: f32,
  // wo is inside a solid.
  inside: bool,
  // Factor on what facets of the base reflect: bsdf.wesl, compensation.
  more: vec3f,
  // Facets of the base; below leastAlpha they are a mirror.
  alpha: vec2f,
  coatAlpha: f32,
  // Share of the light towards wo that is the coat's.
  coat: f32,
  // Share of white light that fibres send to wo, and of the strongest colour of these.
  sheen: f32,
  sheenColor: f32,
  // Probabilities of the lobes: the coat's, the base's facets', the sheen's, the diffuse one's. What is left is the diffuse one's beyond.
  ofCoat: f32,
  ofFacets: f32,
  ofSheen: f32,
  ofDiffuse: f32,
  // Whether the facets that a sample was drawn by are the coat's.
  drawnByCoat: bool,
}


fn outerCosine(cosine: f32) -> f32 {
  var outer = cosine;
  if (hasTransmission) {
    outer = cosineInAir(cosine, stackHere.ratio);
  }
  return outer;
}

// What facets of the base reflect that are met at this cosine, where there is dielectric and where there is metal.
struct Reflectance {
  dielectric: vec3f,
  metal: vec3f,
}


// Total reflection, in a denser body only: along the surface of one that is not, rounding must not make a mirror of it.
fn reflectsAll(cosine: f32, ratio: f32) -> bool {
  return (ratio < 1.0) & (1.0 - cosine * cosine >= ratio * ratio);
}

// The cosine on the side of air at a facet that is met at `cosine`; 0 at total reflection. `ratio`: the index beyond over
// the one on this side. Schlick's formula wants this cosine (KHR_materials_volume, Refraction).
fn cosineInAir(cosine: f32, ratio: f32) -> f32 {
  let sine2 = (1.0 - cosine * cosine) / (ratio * ratio);
  return select(cosine, sqrt(max(1.0 - sine2, 0.0)), ratio < 1.0);
}

// How often to sample the GGX lobe: about its share of the light that comes back from wo. The diffuse part keeps nearly all of
// its light even when wo is grazing, since the half vector's cosine is not: counted by wo's own it would be sampled too seldom.
fn specularShare(baseColor: vec3f, metallic: f32, cosine: f32) -> f32 {
  let specular = dot(schlick(metallicRoughnessF0(baseColor, metallic), cosine), vec3f(1.0));
  let diffuse = dot(metallicRoughnessDiffuse(baseColor, metallic, 1.0), vec3f(1.0));
  return specular / max(specular + diffuse, 1e-20);
}

fn metallicRoughnessF0(baseColor: vec3f, metallic: f32) -> vec3f {
  return mix(vec3f(dielectricF00), baseColor, metallic);
}

// Albedo of the diffuse part for light that meets facets at this cosine.
fn metallicRoughnessDiffuse(baseColor: vec3f, metallic: f32, cosine: f32) -> vec3f {
  return (1.0 - metallic) * (1.0 - schlick(vec3f(dielectricF00), cosine).x) * baseColor;
}

const dielectricF00 = 0.04;

// Index behind the boundary over the index on the side of a direction with this z. A thin pane has air on both sides.
fn indexRatio(eta: f32, z: f32, thin: bool) -> f32 {
  return select(eta, 1.0 / eta, (z < 0.0) & !thin);
}

// Visible normals that reflect below the horizon need not be sampled: this is how much of the lower half of their cap is left.
// Eto and Tokuyoshi, "Bounded VNDF Sampling for Smith-GGX Reflections", SIGGRAPH Asia 2023, k of equation 5.
fn reflectionBound(wo: vec3f, alpha: f32) -> f32 {
  let s = 1.0 + length(wo.xy);
  let s2 = s * s;
  let a2 = alpha * alpha;
  return (1.0 - a2) * s2 / (s2 + a2 * wo.z * wo.z);
}

// Length of the direction after the stretch that makes the facets a hemisphere: Smith's Lambda is (stretched / |z| - 1) / 2.
fn stretched(w: vec3f, alpha: f32) -> f32 {
  return sqrt(w.z * w.z + alpha * alpha * dot(w.xy, w.xy));
}

const conductor = 2u;

// Share of the perfect mirror over the base.
fn mirrorShare(reflectivity: f32) -> f32 {
  return select(0.0, reflectivity, hasMirrorLayers);
}

struct BsdfSample {
  direction: vec3f,
  // Per solid angle, of all lobes together; of a delta lobe the probability with which it is chosen. 0: no direction.
  pdf: f32,
  // f |cos| / pdf
  weight: vec3f,
  delta: bool,
}


// Cosine-weighted direction about +z (Malley's method: points of the disk, raised). Its density is z / pi.
fn sampleCosine(u: vec2f) -> vec3f {
  let radius = sqrt(u.x);
  // From -pi on: beyond, drivers promise no accuracy of sine and cosine, and little within. Hence also the normalize.
  let phi = 6.28318530718 * u.y - 3.14159265359;
  return normalize(vec3f(radius * cos(phi), radius * sin(phi), sqrt(1.0 - u.x)));
}

// Kinds of material beside diffuse, and what may be laid over or set on top.
override hasMirrorLayers = true;

// A facet that wo sees, turned to wo's side.
fn sampleFacet(alpha: f32, isMirror: bool, o: Outgoing, u: vec2f) -> vec3f {
  let side = select(1.0, -1.0, o.wo.z < 0.0);
  let rough = sampleVisibleNormal(o.wo * side, max(alpha, leastAlpha), o.bound, u);
  return select(rough, vec3f(0.0, 0.0, 1.0), isMirror) * side;
}

// Share of light that a facet reflects, met at this cosine.
fn facetReflectance(s: Surface, cosine: f32, ratio: f32) -> vec3f {
  let code = u32(s.code);
  var reflectance = vec3f(0.0);
  if (hasMetallicRoughness) {
    if (!hasLayers) {
      reflectance = schlick(metallicRoughnessF0(s.baseColor, s.metallic), cosine);
    }
  }
  if (hasConductors) {
    reflectance = select(reflectance, conductorReflectance(s.baseColor, s.eta, s.k, cosine), isConductor(code));
  }
  if (hasGlass) {
    reflectance = select(reflectance, vec3f(glassReflectance(cosine, ratio, isThin(code))), isDielectric(code));
  }
  return reflectance;
}

// The direction beyond the boundary of what comes from wo; h is the normal on wo's side. Only asked when Fresnel is below 1.
fn refracted(wo: vec3f, h: vec3f, ratio: f32) -> vec3f {
  let cosine = dot(wo, h);
  let inside = sqrt(max((ratio - 1.0) * (ratio + 1.0) + cosine * cosine, 0.0));
  return ((cosine - inside) * h - wo) / ratio;
}

// A normal that wo (wo.z >= 0) sees, with density D(h) 2 dot(wo, h) / (bound wo.z + stretched(wo)). Dupuy and Benyoub,
// "Sampling Visible GGX Normals with Spherical Caps", HPG 2023: a cap of the sphere, shifted by wo; `bound` cuts it, 1 does not.
fn sampleVisibleNormal(wo: vec3f, alpha: f32, bound: f32, u: vec2f) -> vec3f {
  let w = vec3f(alpha * wo.xy, wo.z) / stretched(wo, alpha);
  let phi = 6.28318530718 * u.x - 3.14159265359;
  // 1 - z of the cap's point; kept so, since z near 1 would lose the digits of the sine.
  let drop = u.y * (1.0 + bound * w.z);
  let sine = sqrt(max(drop * (2.0 - drop), 0.0));
  let h = w + vec3f(sine * cos(phi), sine * sin(phi), 1.0 - drop);
  return normalize(vec3f(alpha * h.xy, max(h.z, 1e-7)));
}

// Without measured constants (eta and k black) the base colour comes back at every angle.
fn conductorReflectance(baseColor: vec3f, eta: vec3f, k: vec3f, cosine: f32) -> vec3f {
  let constants = dot(eta + k, vec3f(1.0));
  return select(baseColor, conductorFresnel(cosine, eta, k), constants > 0.0);
}

// Vacuum over metal, index eta + i k per channel (Born and Wolf, Principles of Optics, 14.2; a, b as in Lagarde's "Memo on
// Fresnel equations").
fn conductorFresnel(cosine: f32, eta: vec3f, k: vec3f) -> vec3f {
  let cosine2 = cosine * cosine;
  let sine2 = 1.0 - cosine2;
  let difference = eta * eta - k * k - sine2;
  let a2PlusB2 = sqrt(difference * difference + 4.0 * eta * eta * k * k);
  // a + i b is the root of difference + 2 i eta k; the smaller part from the larger, or its digits are lost.
  let larger = sqrt(0.5 * (a2PlusB2 + abs(difference)) + least0);
  let smaller = eta * k / larger;
  let a = select(smaller, larger, difference > vec3f(0.0));
  let b = select(larger, smaller, difference > vec3f(0.0));
  // Sums of squares, not multiplied out: rounding never takes them below 0. least: an index of 1 along the surface is no 0 / 0.
  let b2 = b * b + least0;
  let acrossFar = a + cosine;
  let acrossNear = a - cosine;
  let across = (acrossNear * acrossNear + b2) / (acrossFar * acrossFar + b2);
  let alongFar = a * cosine + sine2;
  let alongNear = a * cosine - sine2;
  let b2cosine2 = b2 * cosine2 + least0;
  return 0.5 * across * (1.0 + (alongNear * alongNear + b2cosine2) / (alongFar * alongFar + b2cosine2));
}

const least0 = 1e-20;

// A thin pane: light goes to and fro between its two faces, R + T R T + T R^3 T + ... = 2 R / (1 + R).
fn glassReflectance(cosine: f32, ratio: f32, thin: bool) -> f32 {
  let r = dielectricFresnel(cosine, ratio);
  return select(r, 2.0 * r / (1.0 + r), thin);
}

// How much of the light a smooth boundary reflects; unpolarised. `cosine` is that of the angle of incidence, 0 … 1.
// Both media transparent; `ratio` is the index of the far one over that of the near one. Total reflection gives 1.
fn dielectricFresnel(cosine: f32, ratio: f32) -> f32 {
  // ratio times the cosine of the refracted ray, squared; so that equal media reflect nothing at any angle
  let inside2 = (ratio - 1.0) * (ratio + 1.0) + cosine * cosine;
  let inside = sqrt(max(inside2, 0.0));
  let across = (cosine - inside) / (cosine + inside);
  let along = (ratio * ratio * cosine - inside) / (ratio * ratio * cosine + inside);
  return select(1.0, 0.5 * (across * across + along * along), inside2 > 0.0);
}

// A direction by one of the lobes; stackHere says by which facets. u in [0, 1)^3: two for the direction, the third chooses the lobe.
fn sampleLayered(s: Surface, u: vec3f) -> LayeredSample {
  let wo = stackHere.wo;
  let isSolid = isSolidHere();
  let isCoat = hasCoats & (u.z < stackHere.ofCoat);
  let isFacet = u.z < stackHere.ofCoat + stackHere.ofFacets;
  stackHere.drawnByCoat = isCoat;
  let alpha = select(stackHere.alpha, vec2f(stackHere.coatAlpha), isCoat);
  let isSmooth = max(alpha.x, alpha.y) < leastAlpha;
  let wide = max(alpha, vec2f(leastAlpha));
  var own = Basis(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0));
  if (hasCoatNormals) {
    if (isCoat) {
      own = basisAbout(coatNormal(stackHere.side));
    }
  }
  var ownWo = wo;
  if (hasCoatNormals) {
    ownWo = toLocal(own, wo);
  }
  let bound = select(ellipticBound(ownWo, wide), 1.0, isSolid & !isCoat);
  let rough = sampleEllipticNormal(ownWo, wide, bound, u.xy);
  var h = select(rough, vec3f(0.0, 0.0, 1.0), isSmooth);
  if (hasCoatNormals) {
    h = toWorld0(own, h);
  }
  let oh = max(dot(wo, h), 0.0);
  let reflected = 2.0 * oh * h - wo;
  var met = reflected;
  var crossing = false;
  if (hasTransmission) {
    // What is left of u.z is uniform again.
    let left = (u.z - stackHere.ofCoat) / max(stackHere.ofFacets, 1e-20);
    crossing = !isCoat & (left >= shareToward(s, bareReflectance(s, oh)));
    let beyond = select(vec3f(reflected.xy, -reflected.z), refracted(wo, h, stackHere.ratio), isSolid);
    met = select(reflected, beyond, crossing);
  }
  var lost = !isSmooth & (crossing != (met.z < 0.0));
  if (hasCoatNormals) {
    if (isCoat) {
      lost = (dot(own.normal, met) <= 0.0) | ((met.z < 0.0) & (s.eta.x < 0.0));
    }
  }
  var drawn = LayeredSample(met, select(1.0, 0.0, lost), isSmooth);
  if (!isFacet) {
    let next = u.z - stackHere.ofCoat - stackHere.ofFacets;
    let sine = sqrt(max(u.x * (2.0 - u.x), 0.0));
    let phi = 6.28318530718 * u.y - 3.14159265359;
    let even = vec3f(sine * cos(phi), sine * sin(phi), 1.0 - u.x);
    let matte = sampleCosine(u.xy);
    let below = vec3f(matte.xy, select(matte.z, -matte.z, hasTransmission & (next >= stackHere.ofSheen + stackHere.ofDiffuse)));
    drawn = LayeredSample(select(below, even, hasSheen & (next < stackHere.ofSheen)), 1.0, false);
  }
  drawn.direction.z *= stackHere.side;
  return drawn;
}

fn isSolidHere() -> bool {
  return hasTransmission & (layersHere.solid > 0.0);
}

// Eto and Tokuyoshi 2023, equation 6: the smaller width bounds both.
fn ellipticBound(wo: vec3f, alpha: vec2f) -> f32 {
  let s = 1.0 + length(wo.xy);
  let s2 = s * s;
  let least = min(alpha.x, alpha.y);
  let a2 = least * least;
  return (1.0 - a2) * s2 / (s2 + a2 * wo.z * wo.z);
}

// As sampleVisibleNormal.
fn sampleEllipticNormal(wo: vec3f, alpha: vec2f, bound: f32, u: vec2f) -> vec3f {
  let w = vec3f(alpha * wo.xy, wo.z) / ellipticStretched(wo, alpha);
  let phi = 6.28318530718 * u.x - 3.14159265359;
  let drop = u.y * (1.0 + bound * w.z);
  let sine = sqrt(max(drop * (2.0 - drop), 0.0));
  let h = w + vec3f(sine * cos(phi), sine * sin(phi), 1.0 - drop);
  return normalize(vec3f(alpha * h.xy, max(h.z, 1e-7)));
}

struct LayeredSample {
  direction: vec3f,
  // 0: the light is lost.
  pdf: f32,
  // By smooth facets.
  delta: bool,
}


// How often a sample takes the first, by what the facet would be without a film; a film's colours vanish at some angles, so that neither is
// left out because of it.
fn shareToward(s: Surface, bare: Reflectance) -> f32 {
  let p = partingOf(s, bare);
  let a = mean3(p.toward);
  let b = mean3(p.beyond);
  return select(1.0, mix(a / max(a + b, 1e-20), 0.5, 0.5 * layersHere.film), b > 0.0);
}

fn partingOf(s: Surface, r: Reflectance) -> Parting {
  let toward = mix(r.dielectric, r.metal, s.metallic);
  var parting = Parting(toward, vec3f(0.0));
  if (hasTransmission) {
    let enters = (1.0 - s.metallic) * (1.0 - greatest(r.dielectric));
    parting = Parting(toward * select(vec3f(1.0), stackHere.hero, stackHere.inside), enters * layersHere.transmission * s.baseColor * stackHere.hero);
  }
  return parting;
}

// What a facet of the base makes of light: towards wo's side, and beyond.
struct Parting {
  toward: vec3f,
  beyond: vec3f,
}


fn ellipticStretched(w: vec3f, alpha: vec2f) -> f32 {
  let scaled = alpha * w.xy;
  return sqrt(w.z * w.z + dot(scaled, scaled));
}

// The perfect mirror: a layer of constant share over any base, and the smooth limit of every microfacet surface.
fn mirrored(wo: vec3f) -> vec3f {
  return vec3f(-wo.xy, wo.z);
}

struct Pair {
  // As of evaluateBsdf.
  toLight: vec4f,
  // With the density and weight of all lobes together.
  drawn: BsdfSample,
}


// rgb: f |cos wi|; a: the density with which sampleLobe gives wi. Delta lobes give 0. Of what has no layers: evaluatePair.
fn evaluateBsdf(s: Surface, o: Outgoing, wi: vec3f) -> vec4f {
  let lambert = invPi * max(wi.z, 0.0);
  var value = vec4f(s.baseColor, 1.0) * lambert;
  var dark = (o.wo.z < 0.0) | (wi.z <= 0.0);
  if (hasConductors | (hasMetallicRoughness & !hasLayers) | hasGlass) {
    let code = u32(s.code);
    let facets = evaluateFacets(s, o, wi);
    var base = vec3f(0.0);
    if (hasMetallicRoughness) {
      if (!hasLayers) {
        base = select(base, metallicRoughnessDiffuse(s.baseColor, s.metallic, facets.cosine), isMetallicRoughness(code));
      }
    }
    let rough = select(vec4f(facets.value, o.share * facets.pdf), vec4f(0.0), isSmooth(code));
    value = select(rough + vec4f(base, 1.0 - o.share) * lambert, value, kindOf(code) == diffuse0);
    dark = select(dark, isSmooth(code), isDielectric(code));
  }
  return select((1.0 - mirrorShare(s.reflectivity)) * value, vec4f(0.0), dark);
}

// `value` is what evaluateBsdf says of the sample's direction.
fn completed(drawn: BsdfSample, value: vec4f) -> BsdfSample {
  let pdf = select(value.a, 0.0, drawn.pdf <= 0.0);
  let weight = select(vec3f(0.0), value.rgb / max(pdf, 1e-30), pdf > 0.0);
  return BsdfSample(drawn.direction, select(pdf, drawn.pdf, drawn.delta), select(weight, drawn.weight, drawn.delta), drawn.delta);
}

// Of each direction rgb: f |cos wi|; a: the density with which sampleLayered gives it. Of smooth facets that is 0; but where `byMirror` says that
// the sample was drawn by them, these alone count, and both are what is left when the density of their facets is taken out of them.
//
// One loop over both directions and, of each, the coat's facets and the base's: so that all stands in the program once, and in no loop within
// another. Its begin is known at run time only, or Windows' compiler would write its turns out.
fn evaluateLayers(s: Surface, toLight: vec3f, toSample: vec3f, byMirror: bool) -> LayeredPair {
  var pair = LayeredPair(vec4f(0.0), vec4f(0.0));
  var isLight = frame.emitterCount > 0u;
  var isFirst = true;
  var sum = vec4f(0.0);
  var intoBody = 0.0;
  loop {
    let given = select(toSample, toLight, isLight);
    let wi = vec3f(given.xy, given.z * stackHere.side);
    // Through a thin wall light goes as if it were reflected and then mirrored.
    let facing = vec3f(wi.xy, abs(wi.z));
    // Below the horizon there is light of what lets some through, and of coats with normals of their own.
    let crossing = (hasTransmission | hasCoatNormals) & (wi.z < 0.0);
    // The coat's facets come first where there is a coat, and where what reaches the body of a solid is not what the base's facets see that
    // light comes through. Else the base's show that too.
    let apart = (stackHere.coat > 0.0) | (isSolidHere() & (crossing | stackHere.inside) & (s.metallic < 1.0));
    let isCoat = (hasCoats | hasTransmission) & isFirst & apart;
    // A coat may be bent towards what lies below the base's horizon; where light goes through that is the other side.
    let coatEnds = crossing & !(hasCoatNormals & (s.eta.x >= 0.0));
    let bends = isSolidHere() & crossing & !isCoat;
    let facets = facetsTowards(select(facing, wi, bends | (isCoat & !coatEnds)), isCoat, bends);
    let ofMirror = byMirror & !isLight;
    let isMirror = ofMirror & (isCoat == stackHere.drawnByCoat);
    let value = select(select(facets.value, 0.0, ofMirror), 1.0, isMirror);
    let density = select(select(facets.density, 0.0, ofMirror), 1.0, isMirror);
    // What reaches the body by way of a coated surface, met halfway; from inside, and by a mirror, by the angle of the surface itself.
    let cosine = select(facets.cosine, stackHere.wo.z, (isCoat & stackHere.inside) | isMirror);
    let bare = bareReflectance(s, cosine);
    var r = bare;
    if (hasIridescence) {
      r = filmedReflectance(s, bare, cosine);
    }
    intoBody = select(intoBody, (1.0 - s.metallic) * (1.0 - greatest(r.dielectric)), isCoat | !apart);
    if (isCoat) {
      sum = select(vec4f(vec3f(stackHere.coat * value), stackHere.ofCoat * density), vec4f(0.0), coatEnds);
      isFirst = false;
    } else {
      let cover = coverTowards(wi, crossing);
      let p = partingOf(s, r);
      let lobe = cover.left * select(p.toward * select(stackHere.more, vec3f(1.0), isMirror), p.beyond, crossing);
      var chosen = stackHere.ofFacets;
      if (hasTransmission) {
        let share = shareToward(s, bare);
        chosen *= select(share, 1.0 - share, crossing) * select(1.0, stackHere.ratio * stackHere.ratio, bends);
      }
      sum += vec4f(lobe * value, chosen * density);
      let body = select((1.0 - layersHere.beyond) * s.baseColor, layersHere.beyond * layersHere.beyondColor, crossing);
      let matte = cover.left * intoBody * (1.0 - layersHere.transmission) * body;
      let even = cover.fibres + vec4f(matte, select(stackHere.ofDiffuse, ofBeyond(), crossing)) * (invPi * facing.z);
      sum += select(even, vec4f(0.0), ofMirror);
      sum = select(sum, vec4f(0.0), !crossing & (wi.z < 0.0));
      pair = LayeredPair(select(pair.toLight, sum, isLight), sum);
      if (!isLight) {
        break;
      }
      isLight = false;
      isFirst = true;
      sum = vec4f(0.0);
    }
  }
  return pair;
}

struct LayeredPair {
  toLight: vec4f,
  toSample: vec4f,
}


fn facetsTowards(wi: vec3f, isCoat: bool, bends: bool) -> Facets {
  let wo = stackHere.wo;
  let alpha = select(stackHere.alpha, vec2f(stackHere.coatAlpha), isCoat);
  let isRough = max(alpha.x, alpha.y) >= leastAlpha;
  let wide = max(alpha, vec2f(leastAlpha));
  let m = wo + wi * select(1.0, stackHere.ratio, bends);
  let m2 = max(dot(m, m), 1e-20);
  let h = m * inverseSqrt(m2);
  let oh = dot(wo, h);
  let ih = dot(wi, h);
  // The same three in the frame of the layer whose facets are meant.
  var ownWo = wo;
  var ownWi = wi;
  var ownH = h;
  if (hasCoatNormals) {
    if (isCoat) {
      let own = basisAbout(coatNormal(stackHere.side));
      ownWo = toLocal(own, wo);
      ownWi = toLocal(own, wi);
      ownH = toLocal(own, h);
    }
  }
  let faces = (oh * ownH.z >= 0.0) & (ih * ownH.z * ownWi.z >= 0.0) & (bends | (ownWi.z >= 0.0));
  let spread = select(0.25, abs(oh * ih) / m2, bends) * select(0.0, 2.0 * ellipticDensity(ownH, wide), faces & isRough);
  let ownStretched = ellipticStretched(ownWo, wide);
  let ownZi = abs(ownWi.z);
  let masked = ownZi / max(ownZi * ownStretched + ownWo.z * ellipticStretched(ownWi, wide), 1e-20);
  let bound = select(ellipticBound(ownWo, wide), 1.0, isSolidHere() & !isCoat);
  return Facets(spread * masked, spread / (bound * ownWo.z + ownStretched), min(abs(oh), 1.0));
}

fn filmedReflectance(s: Surface, bare: Reflectance, cosine: f32) -> Reflectance {
  var r = bare;
  if (layersHere.film > 0.0) {
    let outer = outerCosine(cosine);
    // Mostly one of the two.
    var isMetal = s.metallic >= 1.0;
    loop {
      let f0 = select(layersHere.specularWeight * dielectricF0(), s.baseColor, isMetal);
      let film = filmReflectance(f0, layersHere.filmIor, layersHere.filmThickness, outer);
      if (isMetal) {
        r.metal = mix(r.metal, film, layersHere.film);
      } else {
        r.dielectric = mix(r.dielectric, film, layersHere.film);
      }
      if (isMetal | (s.metallic <= 0.0)) {
        break;
      }
      isMetal = true;
    }
    if (hasTransmission) {
      r.dielectric = select(r.dielectric, vec3f(1.0), reflectsAll(cosine, stackHere.ratio));
    }
  }
  return r;
}

// The film's reflectance over a body that would reflect f0 without it. Kept within 0 … 1: the integral over three colours overshoots.
fn filmReflectance(f0: vec3f, filmIor: f32, thickness: f32, cosine: f32) -> vec3f {
  // The cosine within the film; above 0, as its index is at least 1.
  let sine2 = (1.0 - cosine * cosine) / (filmIor * filmIor);
  let within = sqrt(max(1.0 - sine2, 0.0));
  let first = (filmIor - 1.0) / (filmIor + 1.0);
  let r12 = schlick(vec3f(first * first), cosine).x;
  let t121 = 1.0 - r12;
  let body = indexOf(f0 + 1e-4);
  let second = (body - filmIor) / (body + filmIor);
  let r23 = schlick(second * second, within);
  let r123 = clamp(r12 * r23, vec3f(1e-5), vec3f(0.9999));
  let once = sqrt(r123);
  let rs = t121 * t121 * r23 / (1.0 - r123);
  // Half a turn at the lower side of the film's upper boundary, and another where the body's index is less than the film's.
  let shift = 0.5 + select(vec3f(0.0), vec3f(0.5), body < vec3f(filmIor));
  let difference = 2.0 * filmIor * thickness * within;
  var sum = r12 + rs;
  var amplitude = rs - t121;
  var order = 1.0;
  loop {
    amplitude *= once;
    sum += 2.0 * amplitude * sensitivity(order * difference, order * shift);
    order += 1.0;
    if (order > 2.5) {
      break;
    }
  }
  return clamp(sum, vec3f(0.0), vec3f(1.0));
}

// Index of a body that reflects f0 against air.
fn indexOf(f0: vec3f) -> vec3f {
  let root = sqrt(min(f0, vec3f(0.9999)));
  return (1.0 + root) / (1.0 - root);
}

// What is left of the interference of a path difference (nanometres) in linear red, green, blue: section 4, Gaussians in the frequency
// domain for x, y, z and the second lobe of x. `shift`: what the boundaries add to the phase, in turns.
fn sensitivity(difference: f32, shift: vec3f) -> vec3f {
  let phase = 6.28318530718e-9 * difference;
  let mean = vec4f(1.6810e6, 1.7953e6, 2.2084e6, 2.2399e6);
  let variance = vec4f(4.3278e9, 9.3046e9, 6.6121e9, 4.5282e9);
  // val sqrt(2 pi var) / 1.0685e-7 of the sample.
  let height = vec4f(0.846590, 1.000222, 1.001122, 0.153868);
  // Whole turns are left out: the cosine of a large angle has no digits.
  let turns = mean * (phase * 0.15915494309) + vec4f(shift, shift.x);
  let lobes = height * cos(6.28318530718 * (turns - round(turns))) * exp(-variance * (phase * phase));
  let x = lobes.x + lobes.w;
  // XYZ to linear sRGB
  return vec3f(3.2404542 * x - 1.5371385 * lobes.y - 0.4985314 * lobes.z, -0.9692660 * x + 1.8760108 * lobes.y + 0.0415560 * lobes.z, 0.0556434 * x - 0.2040259 * lobes.y + 1.0572252 * lobes.z);
}

fn coverTowards(wi: vec3f, crossing: bool) -> Cover0 {
  var cover = Cover0(1.0, vec4f(0.0));
  if (hasCoats) {
    let ofWi = coatReflectance(layersHere.coat, coatCosine(stackHere.side, wi));
    cover.left = 1.0 - select(stackHere.coat, ofWi, stackHere.inside & crossing);
  }
  if (hasSheen) {
    if (stackHere.sheenColor > 0.0) {
      let isOutside = !(layersHere.solid > 0.0) | (stackHere.inside == crossing);
      let most = max(stackHere.sheen, sheenAlbedo(abs(wi.z), layersHere.sheenRoughness));
      let white = (1.0 - stackHere.coat) * whiteSheen(stackHere.wo, wi, sheenAlpha(layersHere.sheenRoughness)) / max(most, 1.0);
      cover.fibres = select(vec4f(white * layersHere.sheenColor, stackHere.ofSheen * invTwoPi), vec4f(0.0), crossing | stackHere.inside);
      cover.left *= 1.0 - stackHere.sheenColor * min(select(stackHere.sheen, most, isOutside), 1.0);
    }
  }
  return cover;
}

fn ofBeyond() -> f32 {
  return max(1.0 - stackHere.ofCoat - stackHere.ofFacets - stackHere.ofSheen - stackHere.ofDiffuse, 0.0);
}

// Matte surfaces: radiance leaves alike to all sides (Lambert, Photometria, 1760).
const invPi = 0.31830988618;

// What of the light from wi is left by coat and sheen, and what the sheen adds, as evaluateLayers gives it. Light that crosses a solid's
// boundary meets both once, outside.
struct Cover0 {
  left: f32,
  fibres: vec4f,
}


// What the fibres send back, times the cosine of wi, for white ones. Both cosines are above 0.
fn whiteSheen(wo: vec3f, wi: vec3f, alpha: f32) -> f32 {
  let m = wo + wi;
  let m2 = max(dot(m, m), 1e-20);
  let sine2 = clamp(dot(m.xy, m.xy) / m2, 0.0, 1.0);
  let power = 0.5 / alpha;
  // (2 + 1/alpha) sin^(1/alpha) / 2 pi, and 1 / (4 zo zi (1 + Lambda + Lambda)), times zi
  let density = (2.0 + 2.0 * power) * 0.15915494309 * select(exp(power * log(max(sine2, 1e-20))), 0.0, sine2 < 1e-20);
  let zo = max(wo.z, 1e-6);
  return density / (4.0 * zo * (1.0 + sheenShadowing(wo.z, alpha) + sheenShadowing(wi.z, alpha)));
}

fn sheenAlpha(roughness: f32) -> f32 {
  let r = max(roughness, leastSheenRoughness);
  return r * r;
}

const invTwoPi = 0.15915494309;

// Lambda at this cosine; along the surface it is large and finite.
fn sheenShadowing(cosine: f32, alpha: f32) -> f32 {
  let x = clamp(cosine, 1e-6, 1.0);
  let isLow = x < 0.5;
  let l = shadowingExponent(select(max(1.0 - x, 1e-6), x, isLow), alpha);
  return exp(select(2.0 * shadowingExponent(0.5, alpha) - l, l, isLow));
}

// l(x) of equation 3, table 1.
fn shadowingExponent(x: f32, alpha: f32) -> f32 {
  let m = (1.0 - alpha) * (1.0 - alpha);
  let a = mix(21.5473, 25.3245, m);
  let b = mix(3.82987, 3.32435, m);
  let c = mix(0.19823, 0.16801, m);
  let d = mix(-1.97760, -1.27393, m);
  let e = mix(-4.32054, -4.85967, m);
  return a / (1.0 + b * pow(x, c)) + d * x + e;
}

fn ellipticDensity(h: vec3f, alpha: vec2f) -> f32 {
  let scaled = h.xy / alpha;
  let slope = max(dot(scaled, scaled) + h.z * h.z, 1.0);
  return 0.31830988618 / (alpha.x * alpha.y * slope * slope);
}

// Facets of coat or base between wo and a direction: f |cos| but for what they reflect, the density of samples by them, and the cosine that
// they are met at. Smooth ones have neither.
struct Facets {
  value: f32,
  density: f32,
  cosine: f32,
}


fn evaluateFacets(s: Surface, o: Outgoing, wi: vec3f) -> FacetLobe {
  let wo = o.wo;
  let isGlass = isDielectric(u32(s.code));
  let crossing = hasGlass & ((wo.z < 0.0) != (wi.z < 0.0));
  let m = wo + wi * select(1.0, o.ratio, crossing);
  let m2 = max(dot(m, m), 1e-20);
  let h = m * inverseSqrt(m2);
  let oh = dot(wo, h);
  let ih = dot(wi, h);
  let zo = abs(wo.z);
  let zi = abs(wi.z);
  // Facets do not turn their back on one direction while the surface does not. Those that reflect never do: along the surface only the
  // rounded lengths of wo and wi would say so.
  let faces = !crossing | ((oh * h.z * wo.z >= 0.0) & (ih * h.z * wi.z >= 0.0));
  let spread = select(0.25, abs(oh * ih) / m2, crossing) * select(0.0, 2.0 * facetDensity(h, s.alpha), faces);
  let f = facetReflectance(s, abs(oh), o.ratio);
  var passes = select(f, 1.0 - f, crossing);
  let incoming = stretched(wi, s.alpha);
  let apart = 0.5 * (zo + o.stretched) * (zi + incoming);
  let masked = zi / max(select(zi * o.stretched + zo * incoming, apart, hidesApart(u32(s.code))), 1e-20);
  let chosen = select(1.0, passes.x, isGlass) * select(1.0, o.ratio * o.ratio, crossing);
  if (hasCompensation) {
    passes *= compensation(s, zo);
  }
  return FacetLobe(passes * spread * masked, spread * chosen / (o.bound * zo + o.stretched), abs(oh));
}

// Kinds, as Surface.code numbers them.
const diffuse0 = 0u;

// D(h): facets around the half vector per area and solid angle.
fn facetDensity(h: vec3f, alpha: f32) -> f32 {
  // At least 1 for a unit vector; opposite directions along the surface have none.
  let slope = max(dot(h.xy, h.xy) / (alpha * alpha) + h.z * h.z, 1.0);
  return 0.31830988618 / (alpha * alpha * slope * slope);
}

// Whether facets are hidden from both directions as often as by chance: Walter et al. 2007, equation 23.
fn hidesApart(code: u32) -> bool {
  return (code & 64u) != 0u;
}

// The rough lobe: f |cos| and density. Reflection and transmission (Walter et al. 2007, equations 20 and 21) are one formula
// in m, the half vector before it gets length 1.
struct FacetLobe {
  value: vec3f,
  pdf: f32,
  // dot(wo, h)
  cosine: f32,
}


// Turquin, "Practical multiple scattering compensation for microfacet models", 2019, equation 16: what single scattering loses
// comes back in the same lobe, coloured once more by the reflectance at normal incidence.
fn compensation(s: Surface, cosine: f32) -> vec3f {
  let code = u32(s.code);
  let asked = ((code & 8u) != 0u) & !isDielectric(code);
  let albedo = singleScatteringAlbedo(cosine, s.alpha);
  return select(vec3f(1.0), 1.0 + facetReflectance(s, 1.0, 1.0) * ((1.0 - albedo) / albedo), asked);
}

// And of what is infinitely far, sky and suns: asked for once a path is over. In the loop over its vertices it would stand in the way of
// those that go on, and Windows' shader compiler takes the longer for a loop the more is in it.
fn addFarLight(p: ptr<function, Path>) {
  if (hasSky | hasSuns) {
    if ((*p).escaped & (frame.emitterCount > 0u)) {
      addSkyAndSuns(p);
    }
  }
}

struct Film {
  // RGB sums, and in alpha how many samples.
  @location(0) sums: vec4f,
  @location(1) squares: vec4f,
}


@group(0) @binding(2) var previousFilm: texture_2d<f32>;

@group(0) @binding(3) var previousSquares: texture_2d<f32>;

fn addSkyAndSuns(p: ptr<function, Path>) {
  let direction = (*p).rays.direction;
  let sky = skySeen(direction);
  var found = vec3f(0.0);
  var i = 0u;
  loop {
    let e = fetchEmitter(i);
    let far = farLight(e, direction, sky);
    let pdf = far.pdf * farProbability(e, (*p).litSide, (*p).odds);
    found += far.radiance * select(misWeight((*p).pdf, pdf), 1.0, (*p).pdf <= 0.0);
    i++;
    // Only one of them is the sky.
    if (!hasSuns | !hasManyLights) {
      break;
    }
    if (i >= frame.farEmitters) {
      break;
    }
  }
  (*p).radiance += (*p).throughput * found;
}

// Of the sky, whichever emitter it is.
fn skySeen(direction: vec3f) -> FarLight {
  var far = FarLight(vec3f(0.0), 0.0);
  if (hasSky) {
    let seen = skyLight(direction);
    far = FarLight(seen.radiance, seen.pdf);
  }
  return far;
}

// `sky`: skySeen in that direction.
fn farLight(e: Emitter, direction: vec3f, sky: FarLight) -> FarLight {
  var far = FarLight(vec3f(0.0), 0.0);
  if (hasSuns) {
    let seen = (e.kind == directionalKind) & isOnDisc(e, direction);
    far = FarLight(select(vec3f(0.0), e.radiance, seen), select(0.0, directionalPdf(e, direction), seen));
  }
  if (hasSky) {
    if (e.kind == skyKind) {
      far = sky;
    }
  }
  return far;
}

// The same of one that is infinitely far.
fn farProbability(e: Emitter, normal: vec3f, odds: Odds) -> f32 {
  var probability = f32(min(frame.emitterCount, 1u));
  if (hasManyLights) {
    if (frame.emitterCount > 1u) {
      var estimate = e.power;
      if (hasSuns) {
        let grown = max(sqrt(dot(e.u, e.u)) + e.reach, 1e-15);
        estimate *= select(1.0, cosineTowards(e, -e.u, grown, normal), e.kind == directionalKind);
      }
      // Where the sum of the estimates underflows it would be infinite, and that times no light no number.
      probability = min(estimate / max(odds.total, 1e-37), 1.0);
      if (hasLightTree) {
        probability *= 1.0 - odds.tree;
      }
    }
  }
  return probability;
}

// What a ray that meets no shape sees of this emitter, and the density with which sampleEmitter gives that direction. Suns are discs
// before the sky and add to it.
struct FarLight {
  radiance: vec3f,
  pdf: f32,
}


// Whether the disc is seen in that direction: by the chord, 1 - cos = |a - b|^2 / 2, as cosines round to 1 for small discs.
fn isOnDisc(e: Emitter, direction: vec3f) -> bool {
  let chord = direction + e.u;
  return pi0 * dot(chord, chord) < e.area;
}

fn directionalPdf(e: Emitter, direction: vec3f) -> f32 {
  return select(0.0, 1.0 / max(e.area, 1e-31), isOnDisc(e, direction));
}

// What a ray that escapes in this direction sees, and the density with which sampleSky gives it.
fn skyLight(direction: vec3f) -> EnvironmentLight {
  var light = white;
  if (hasEnvironment) {
    light = lookUpEnvironment(direction);
  }
  return EnvironmentLight(light.radiance * sky(direction), light.pdf);
}

fn lookUpEnvironment(direction: vec3f) -> EnvironmentLight {
  let size = frame.environmentSize;
  let sine = max(length(direction.xz), 1e-9);
  // Of the azimuth from the z axis, and of theta from the nearer pole, where it keeps its digits.
  let angles = quadrantAngles(abs(vec2f(direction.z, direction.y)), vec2f(abs(direction.x), sine));
  let turn = select(angles.x, pi0 - angles.x, direction.z > 0.0) * select(1.0, -1.0, direction.x < 0.0);
  let column = fract(turn * (0.5 / pi0) + frame.environmentTurn) * size.x + 0.5;
  let fromPole = angles.y * (size.y / pi0) + 0.5;
  let row = floor(fromPole);
  let isLower = direction.y < 0.0;
  let cell = vec2f(floor(column), select(row, size.y - row, isLower));
  let within = fromPole - row;
  let at = vec2f(column - cell.x, select(within, 1.0 - within, isLower));
  return lightWithin(environmentCorners(vec2u(cell)), at, sine);
}

// Angles of the two vectors (x, y) from the x axis, x and y >= 0, by the polynomial of Cephes' atanf, for all of the first quadrant.
fn quadrantAngles(x: vec2f, y: vec2f) -> vec2f {
  let low = min(x, y);
  let high = max(x, y);
  let middle = low > 0.4142135624 * high;
  let r = select(low, low - high, middle) / max(select(high, low + high, middle), vec2f(1e-30));
  let z = r * r;
  let series = ((8.05374449538e-2 * z - 1.38776856032e-1) * z + 1.99777106478e-1) * z - 3.33329491539e-1;
  let angle = select(vec2f(0.0), vec2f(0.7853981634), middle) + (series * z * r + r);
  return select(angle, 1.570796327 - angle, y > x);
}
