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
  if (hasMeshes) {
    found = meetMeshes(found, p);
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
  let place = vec2f((f32(i32(i & 2047u)) + 0.5) / 2048.0, (f32(i32(i & 0x7ffff800u)) + 1024.0) * frame.geometryShare);
  return bitcast<vec4u>(textureSampleLevel(geometry, nearest, place, 0.0));
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


@group(0) @binding(5) var geometry: texture_2d<f32>;

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
  let place = vec2f((f32(i32(i & 2047u)) + 0.5) / 2048.0, (f32(i32(i & 0x7ffff800u)) + 1024.0) * frame.texelShare);
  return bitcast<vec4u>(textureSampleLevel(texels, nearest, place, 0.0));
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


@group(0) @binding(6) var texels: texture_2d<f32>;

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

// What glTF's extensions add to metallicRoughness: any of them, and those that take a program something of their own. Light that goes
// through is one, be it by facets or diffusely.
override hasLayers = false;

// Clear coats that are bent by another normal map than their base, or by none where the base is.
override hasCoatNormals = false;

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


var<private> layersHere: Layers0;

// Those of glTF's own material where there are none.
fn layersOf(code: u32, eta: f32) -> Layers0 {
  var l: Layers0;
  l.specularColor = vec3f(1.0);
  l.specularWeight = 1.0;
  l.ior = 1.5;
  if (isLayered(code) & (eta != 0.0)) {
    l = fetchLayers(u32(abs(eta)));
  }
  return l;
}

struct Layers0 {
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


// In a program with layers every metallicRoughness material has some, if only such as change nothing: its facets stand in the program once.
fn isLayered(code: u32) -> bool {
  return hasLayers & isMetallicRoughness(code);
}

fn fetchLayers(i: u32) -> Layers0 {
  let t0 = tableTexel(0u, i);
  let t1 = tableTexel(1u, i);
  let t2 = tableTexel(2u, i);
  let t3 = tableTexel(3u, i);
  let t4 = tableTexel(4u, i);
  let t5 = tableTexel(5u, i);
  let t6 = tableTexel(6u, i);
  return Layers0(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xy, t3.z, t3.w, t4.x, t4.y, t4.z, t4.w, t5.x, t5.y, t5.z, t5.w, t6.x, t6.y, t6.z, t6.w);
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

// Its unit normal, a variable of the whole program as those of here.wesl: in the world until path.wesl has a frame for the base
// (bsdf.wesl), in that frame from then on. The same as the base's where one normal map bends both, or none.
var<private> coatNormalHere: vec3f;

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

// Whether light may go through the surface. `eta`: Surface.eta.x, which says of metallicRoughness where its layers are.
fn letsThrough(code: u32, eta: f32) -> bool {
  return isDielectric(code) | (hasTransmission & isLayered(code) & (eta < 0.0));
}

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


const textureUseRows = 3u;

override hasVertexMore = false;

const baseColorSlot = 0u;

const emissionSlot = 1u;

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

override hasTransmission = false;

override hasCoats = false;

override hasSheen = false;

override hasIridescence = false;

override hasGrain = false;

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

fn isDielectric(code: u32) -> bool {
  return hasGlass & (kindOf(code) == dielectric);
}

override hasGlass = false;

const dielectric = 3u;

// Along the surface, where facets have a grain; else zero.
var<private> grainHere: vec3f;

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
