// Linked from integrator/aov/aov.wesl by `npm run shaders`. Do not edit.
@group(0) @binding(2) var previousFirst: texture_2d<f32>;

@group(0) @binding(3) var previousSecond: texture_2d<f32>;

struct Layers {
  @location(0) first: vec4f,
  @location(1) second: vec4f,
}


struct Sight {
  rays: RayPair,
  hit: PairHit,
  // 1 in the middle of the pixel, less farther away, never 0.
  closeness: f32,
}


// As in path.wesl. The classic integrator's rays come out of it too: aov.ts gives it frames with a jitter, no filter and no lens.
fn look(pixel: vec2u) -> Sight {
  var s = startSampler(pixel, frame.sampleIndex, frame.seed);
  let filmPosition = vec2f(pixel) + frame.jitter + filterOffset(next2d(&s));
  let camera = cameraRay(filmPosition, next2d(&s));
  let rays = oneRay(camera.origin, camera.direction, numberOfNext(s));
  let offCentre = filmPosition - vec2f(pixel) - 0.5;
  return Sight(rays, tracePair(rays), 1.0 / (1.0 + dot(offCentre, offCentre)));
}

// Means over the samples, which denoisers want as smooth as the picture: albedo and samples; shading normal and hits.
@fragment fn aovFeatures(@builtin(position) fragment: vec4f) -> Layers {
  let texel = vec2u(fragment.xy);
  let sight = look(frame.origin + texel);
  var sums = Layers(vec4f(0.0), vec4f(0.0));
  if (frame.sampleIndex > 0u) {
    sums = Layers(textureLoad(previousFirst, texel, 0), textureLoad(previousSecond, texel, 0));
  }
  sums.first.a += 1.0;
  let shape = sight.hit.shape;
  if (shape != noShape) {
    let met = surfaceAt(sight.rays, sight.hit, shape);
    let direction = sight.rays.direction;
    sums.first += vec4f(albedoOf(met.surface, dot(met.geometric, direction) > 0.0), 0.0);
    sums.second += vec4f(select(met.shading, -met.shading, dot(met.shading, direction) > 0.0), 1.0);
  }
  return sums;
}

// Of the one sample nearest to the middle of the pixel, since numbers and places cannot be averaged: place, relative to the eye, and
// the shape's number; geometric normal and how close to the middle the sample is.
@fragment fn aovData(@builtin(position) fragment: vec4f) -> Layers {
  let texel = vec2u(fragment.xy);
  let sight = look(frame.origin + texel);
  let shape = sight.hit.shape;
  var data = Layers(vec4f(0.0), vec4f(0.0, 0.0, 0.0, sight.closeness));
  if (shape != noShape) {
    data.first = vec4f(sight.rays.point + sight.hit.t * sight.rays.direction, fetchMaterial(shape).id);
    data.second = vec4f(surfaceAt(sight.rays, sight.hit, shape).geometric, sight.closeness);
  }
  if (frame.sampleIndex > 0u) {
    let previous = Layers(textureLoad(previousFirst, texel, 0), textureLoad(previousSecond, texel, 0));
    // Of two alike the first one stays.
    if (previous.second.a >= sight.closeness) {
      return previous;
    }
  }
  return data;
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


// A triangle of an instance: such as a ray starts on; it is flat, so that no ray meets it again.
struct LeftTriangle {
  instance: u32,
  triangle: u32,
}


fn startSampler(pixel: vec2u, sampleIndex: u32, seed: u32) -> Sampler {
  // Independent numbers come about when each sample of each pixel has its own sequence, and only the first point of it is used.
  let independent = frame.independent != 0u;
  let hash = pixelHash(select(pixel >> vec2u(4u), pixel, independent), select(sampleIndex >> 16u, sampleIndex, independent), seed);
  let place = spread(pixel.x & 15u) | (spread(pixel.y & 15u) * 2u);
  let digits = select(reversed(vec2u(sampleIndex & 0xffffu, place * 256u)), vec2u(0u), independent);
  return Sampler(hash, mixBits(hash ^ 0x6a09e667u), digits.x, digits.y);
}

@group(0) @binding(0) var<uniform> frame: Frame;

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

// A ray that starts on no shape, without one to a light.
fn oneRay(origin: vec3f, direction: vec3f, number: u32) -> RayPair {
  return RayPair(origin, noShape, noTriangle, 0.0, true, direction, false, direction, false, -1.0, noShape, number);
}

// What is drawn next has a number, by which many others may be made that belong to it: hashed with whatever tells them apart.
fn numberOfNext(s: Sampler) -> u32 {
  return mixBits(mixBits((s.key + 1u) ^ s.salt ^ 0x85ebca6bu) + ((s.sample << 8u) | s.place));
}

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
  
  return found;
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
  return reverseBits(x) >> vec2u(16u);
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

// A hash without the shift by a variable of pcg, which takes a software rasteriser longer than all the rest of it:
// C. Wellons, "Prospecting for Hash Functions", 2018, with the constants found by T. Ettinger.
fn mixBits2(x: vec2u) -> vec2u {
  var y = (x ^ (x >> vec2u(16u))) * 0x21f0aaadu;
  y = (y ^ (y >> vec2u(15u))) * 0x735a2d97u;
  return y ^ (y >> vec2u(15u));
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


// A ray knows where it comes from, so that a surface is never met by its own ray again: no offset along the normal,
// nothing that depends on the size of the scene.
const noShape = 0xffffffffu;

const noTriangle = LeftTriangle(noInstance, 0u);

const noInstance = 0xffffffffu;

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
  return textureSampleLevel(sceneTable, nearest, vec2f((f32(i32(column)) + 0.5) / tableWidth, (f32(i32(row)) + 0.5) * frame.rowHeight), 0.0);
}

struct Bounds {
  // centre of the bounding sphere, eye-relative; of a plane: its unit normal
  center: vec3f,
  // of the bounding sphere; of a plane: dot(normal, p) of its points
  radius: f32,
}


@group(0) @binding(1) var sceneTable: texture_2d<f32>;

// How the scene table is read: table_texel.wesl; and, where `sampled`, geometry and texels. Its number is that of packed-scene/layout.ts, far from those of the inputs.
@group(0) @binding(15) var nearest: sampler;

// Written by `npm run shaders` from packed-scene/layout.ts. Do not edit.
// Texels in a row of the scene table.
const tableWidth = 20.0;

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


// Triangles and the trees over them: packed-scene/pack-geometry.ts. Read by geometryRow.
@group(0) @binding(5) var<storage, read> geometry: array<vec4u>;

// References: encode-wide-bvh.ts. Below `instances` those of nodes, from `leaves` on of leaves.
const instances = 0x80000000u;

// Of floats above 0 the order is that of their bits, and all below 0 are less; where WGSL's own `max` and `min` are asked for what may be
// no number, a software rasteriser looks for that, with some twenty operations. What comes out below 0 is not exact, and does not count.
fn larger(a: vec4f, b: vec4f) -> vec4f {
  return max(a, b);
}

fn smaller(a: vec4f, b: vec4f) -> vec4f {
  return min(a, b);
}


// Images, and before them what materials use them for: packed-scene/pack-textures.ts. Read by texelRow.
@group(0) @binding(6) var<storage, read> texels: array<vec4u>;


// In programs with layers it says those of the surface, and its grain, in layers/here.wesl; and the normal of its coat, in the world, in
// layers/clearcoat.wesl.
fn surfaceAt(rays: RayPair, hit: PairHit, shape: u32) -> SurfacePoint {
  let outward = normalAt(rays, hit.t, shape);
  var surface = fetchSurface(shape);
  
  
  var normals = Normals(outward, outward);
  var tangent = vec3f(0.0);
  var bitangent = vec3f(0.0);
  
  
  return SurfacePoint(surface, normals.geometric, normals.shading);
}

// One-sided lamps have a dark back.
fn albedoOf(s: Surface, fromBack: bool) -> vec3f {
  let kind = kindOf(u32(s.code));
  var albedo = s.baseColor;
  if (kind == conductor) {
    albedo = conductorReflectance(s.baseColor, s.eta, s.k, 1.0);
  }
  if (kind == dielectric) {
    albedo = vec3f(1.0);
  }
  albedo = mix(albedo, vec3f(1.0), s.reflectivity);
  let dark = ((u32(s.code) & 16u) != 0u) & fromBack;
  let emission = select(s.emission, vec3f(0.0), dark);
  let brightest = max(max(emission.x, emission.y), max(emission.z, 1.0));
  return clamp(albedo + emission / brightest, vec3f(0.0), vec3f(1.0));
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

fn fetchSurface(i: u32) -> Surface {
  let t0 = tableTexel(9u, i);
  let t1 = tableTexel(10u, i);
  let t2 = tableTexel(11u, i);
  let t3 = tableTexel(12u, i);
  let t4 = tableTexel(13u, i);
  return Surface(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w, t4.xyz, t4.w);
}

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

// These take Surface.code as an integer and not the struct: a compiler that copies structs at each call needs minutes.
fn kindOf(code: u32) -> u32 {
  return code & 3u;
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

const dielectric = 3u;

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

const conductor = 2u;

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

fn fetchMaterial(i: u32) -> Material {
  let t0 = tableTexel(3u, i);
  let t1 = tableTexel(4u, i);
  return Material(t0.xyz, t0.w, t1.x, t1.y, t1.z, t1.w);
}

struct Material {
  // share of light that comes back
  baseColor: vec3f,
  // weight of the mirror ray
  reflectivity: f32,
  // strength of the highlight
  specular: f32,
  // Blinn-Phong exponent, 2 / roughness^4 - 2
  exponent: f32,
  // number of the shape in the order of the scene file, from 1
  id: f32,
  // unused
  spare: f32,
}
