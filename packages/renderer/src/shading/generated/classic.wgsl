// Linked from integrator/classic/classic.wesl by `npm run shaders`. Do not edit.
// Below this share of the picture a mirror ray is not worth following.
const leastWeight = 0.000244140625;

fn trace(first: Ray, hash: u32, maxReflections: u32, lightSamples: u32) -> vec3f {
  var ray = first;
  var weight = 1.0;
  var radiance = vec3f(0.0);
  var reflection = 0u;
  loop {
    let hit = closestHit(ray, frame.ballCount);
    radiance += weight * halo(ray, hit.t);
    if (hit.shape >= frame.shapeEnds.w) {
      var seen = sky(ray.direction);
      if (hit.shape != noShape) {
        seen = ballRadiance(hit.shape);
      }
      radiance += weight * seen;
      break;
    }
    let position = ray.start.point + hit.t * ray.direction;
    let outward = outwardNormal(hit.shape, ray, hit.t);
    let seenFromBack = dot(outward, ray.direction) > 0.0;
    let normal = select(outward, -outward, seenFromBack);
    let start = onSurface(position, hit.shape, seenFromBack && !isFlat(hit.shape));
    let material = fetchMaterial(hit.shape);
    let point = SurfacePoint(start, normal, -ray.direction);
    radiance += weight * (1.0 - material.reflectivity) * shade(point, material, hash, reflection, lightSamples);
    weight *= material.reflectivity;
    ray = Ray(start, reflect(ray.direction, normal));
    reflection++;
    if ((reflection > maxReflections) | (weight < leastWeight)) {
      break;
    }
  }
  return radiance;
}

// Adds one film sample to what the film holds: RGB sums, and in alpha how many.
@fragment fn classic(@builtin(position) fragment: vec4f) -> @location(0) vec4f {
  let texel = vec2u(fragment.xy);
  let pixel = frame.origin + texel;
  let column = f32(pixel.x) + 0.5;
  let panel = frame.panels[u32(column >= frame.dividers.x) + u32(column >= frame.dividers.y)];
  // A pinhole whatever the lens: what is taught has no depth of field, and one sample a pixel could not show it.
  let camera = centralRay(vec2f(pixel) + frame.jitter);
  let hash = pixelHash0(pixel, frame.sampleIndex, frame.seed);
  let radiance = trace(Ray(onCamera(camera.origin), camera.direction), hash, panel.x, panel.y);
  var sum = vec4f(0.0);
  if (frame.sampleIndex > 0u) {
    sum = textureLoad(previousFilm, texel, 0);
  }
  return sum + vec4f(radiance, 1.0);
}

struct Ray {
  start: Start,
  direction: vec3f,
}


// Where a ray starts, whichever way it then goes.
struct Start {
  point: vec3f,
  // The shape left outwards (or a flat one): it cannot be met at once and is not tested.
  leaves: u32,
  // The solid that the ray starts inside of: only its far side counts.
  inside: u32,
  // Hits of other shapes nearer than this are rounding errors, such as a floor under the box that stands on it.
  tMin: f32,
}


// The first `ballCount` light balls come after the spheres, in the same loop: another one would take Windows' shader compiler longer.
// Loops end with their condition: ARCHITECTURE.md, "No loop in a kernel that asks at its head".
fn closestHit(ray: Ray, ballCount: u32) -> Hit {
  var hit = Hit(miss, noShape);
  let ends = frame.shapeEnds;
  let roundCount = ends.x + ballCount;
  if (roundCount > 0u) {
    var k = 0u;
    loop {
      let i = select(k, k - ends.x + ends.w, k >= ends.x);
      hit = nearer(hit, hitSphere(i, fetchBounds(i), ray), i);
      k++;
      if (k >= roundCount) {
        break;
      }
    }
  }
  var i = ends.x;
  if (i < ends.y) {
    loop {
      hit = nearer(hit, hitBox(i, fetchBounds(i), ray), i);
      i++;
      if (i >= ends.y) {
        break;
      }
    }
  }
  // What is flat shares a loop likewise, and is worked out as both: one loop less for Windows' compiler, a few per cent more in software.
  if (i < ends.w) {
    loop {
      let bounds = fetchBounds(i);
      hit = nearer(hit, select(hitQuad(i, bounds, ray), hitPlane(i, bounds, ray), i >= ends.z), i);
      i++;
      if (i >= ends.w) {
        break;
      }
    }
  }
  return hit;
}

@group(0) @binding(0) var<uniform> frame: Frame;

// Light that haze along the first t metres of the ray sends back: the falloff 1 / d^2, integrated.
fn halo(ray: Ray, t: f32) -> vec3f {
  var sum = vec3f(0.0);
  if (frame.ballCount == 0u) {
    return sum;
  }
  var i = 0u;
  loop {
    let ball = fetchBall(frame.shapeEnds.w + i);
    let toLight = ball.center - ray.start.point;
    let along = dot(toLight, ray.direction);
    let across = toLight - along * ray.direction;
    let b = max(length(across), ball.radius);
    sum += ball.halo * ball.diffuse * ((atan((min(t, haloEnd) - along) / b) + atan(along / b)) / b);
    i++;
    if (i >= frame.ballCount) {
      break;
    }
  }
  return sum;
}

// The geometric normal where the ray, t along, meets shape i: unit length, out of solids.
fn outwardNormal(i: u32, ray: Ray, t: f32) -> vec3f {
  let bounds = fetchBounds(i);
  let origin = ray.start.point - bounds.center;
  if (isSphere(i)) {
    return normalize(origin + t * ray.direction);
  }
  if (isPlane(i)) {
    return bounds.center;
  }
  let extent = fetchExtent(i);
  if (isFlat(i)) {
    return normalize(cross(extent.a.xyz, extent.b.xyz));
  }
  let inside = i == ray.start.inside;
  let normal = boxNormal(rotate(extent.a, origin), rotate(extent.a, ray.direction), extent.b.xyz, ray.start.tMin, inside);
  return rotateBack(extent.a, normal);
}

// On `shape`, for rays to the side that it is seen from: the inside of a solid or not.
fn onSurface(point: vec3f, shape: u32, seenFromInside: bool) -> Start {
  return Start(point, select(shape, noShape, seenFromInside), select(noShape, shape, seenFromInside), relativeTMin * length(point));
}

fn isFlat(i: u32) -> bool {
  return i >= frame.shapeEnds.y;
}

fn fetchMaterial(i: u32) -> Material {
  let t0 = tableTexel(3u, i);
  let t1 = tableTexel(4u, i);
  return Material(t0.xyz, t0.w, t1.x, t1.y, t1.z, t1.w);
}

struct SurfacePoint {
  start: Start,
  // Unit, towards the side that the ray came from.
  normal: vec3f,
  // Unit, back along the ray.
  view: vec3f,
}


// The mean over all sample points of a light is added up group by group, light after light, in one loop.
fn shade(p: SurfacePoint, m: Material, pixelHash: u32, reflection: u32, sampleCount: u32) -> vec3f {
  var color = vec3f(0.0);
  if (frame.lightCount == 0u) {
    return color;
  }
  var i = 0u;
  var first = 0u;
  loop {
    let light = fetchLight(i);
    if (first == 0u) {
      color += light.ambient * m.baseColor;
    }
    // Not wholly behind the surface.
    if (dot(p.normal, light.center - p.start.point) > -light.radius) {
      let samples = lightSampler(sampleCount, pixelHash, i, reflection);
      let group = SampleGroup(p.start, light.center, light.radius, samples, first, min(samples.count - first, 32u), firstTurn(samples, first));
      color += sampled(p, m, light, group) / f32(samples.count);
    }
    first += 32u;
    if (first >= sampleCount) {
      first = 0u;
      i++;
    }
    if (i >= frame.lightCount) {
      break;
    }
  }
  return color;
}

fn sky(direction: vec3f) -> vec3f {
  return mix(frame.horizon, frame.zenith, max(direction.y, 0.0));
}

// A ray knows where it comes from, so that a surface is never met by its own ray again: no offset along the normal,
// nothing that depends on the size of the scene.
const noShape = 0xffffffffu;

fn ballRadiance(row: u32) -> vec3f {
  let ball = fetchBall(row);
  return ball.radiance * ball.diffuse;
}

fn fetchBall(i: u32) -> Ball {
  let t0 = tableTexel(0u, i);
  let t1 = tableTexel(1u, i);
  let t2 = tableTexel(2u, i);
  return Ball(t0.xyz, t0.w, t1.xyz, t1.w, t2.x, t2.y, t2.z, t2.w);
}

fn tableTexel(column: u32, row: u32) -> vec4f {
  return textureSampleLevel(sceneTable, nearest, vec2f((f32(i32(column)) + 0.5) / tableWidth, (f32(i32(row)) + 0.5) * frame.rowHeight), 0.0);
}

struct Ball {
  // eye-relative
  center: vec3f,
  // of the ball
  radius: f32,
  // colour of the diffuse part
  diffuse: vec3f,
  // density of the haze times radiance times radius^2
  halo: f32,
  // of the ball
  radiance: f32,
  // unused
  spare0: f32,
  // unused
  spare1: f32,
  // unused
  spare2: f32,
}


@group(0) @binding(1) var sceneTable: texture_2d<f32>;

// How the scene table is read: table_texel.wesl; and, where `sampled`, geometry and texels. Its number is that of packed-scene/layout.ts, far from those of the inputs.
@group(0) @binding(15) var nearest: sampler;

// Written by `npm run shaders` from packed-scene/layout.ts. Do not edit.
// Texels in a row of the scene table.
const tableWidth = 20.0;

struct Hit {
  t: f32,
  // From shapeEnds.w on a light ball: its row; or noShape.
  shape: u32,
}


const miss = 1e30;

fn nearer(hit: Hit, t: f32, shape: u32) -> Hit {
  return Hit(min(t, hit.t), select(hit.shape, shape, t < hit.t));
}

// Distances along the ray to shape i of that kind, or `miss`.
fn hitSphere(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  let t = intersectSphere(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin, i == ray.start.inside);
  return select(t, miss, i == ray.start.leaves);
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

struct Bounds {
  // centre of the bounding sphere, eye-relative; of a plane: its unit normal
  center: vec3f,
  // of the bounding sphere; of a plane: dot(normal, p) of its points
  radius: f32,
}


fn hitBox(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  let extent = fetchExtent(i);
  var origin = ray.start.point - bounds.center;
  var direction = ray.direction;
  if (isTurned(extent.a)) {
    origin = rotate(extent.a, origin);
    direction = rotate(extent.a, direction);
  }
  let t = intersectBox(origin, direction, extent.b.xyz, ray.start.tMin, i == ray.start.inside);
  return select(t, miss, i == ray.start.leaves);
}

fn fetchExtent(i: u32) -> Extent {
  let t0 = tableTexel(1u, i);
  let t1 = tableTexel(2u, i);
  return Extent(t0.xyzw, t1.xyzw);
}

// Whether the rotation is one: its cosine alone, q.w, rounds to 1 below 0.03 degrees.
fn isTurned(q: vec4f) -> bool {
  return any(q.xyz != vec3f(0.0));
}

fn intersectBox(origin: vec3f, direction: vec3f, halfSize: vec3f, tMin: f32, startsInside: bool) -> f32 {
  let s = boxSlabs(origin, direction, halfSize);
  let t = select(s.far, s.near, s.near > tMin);
  // From inside the far side cannot be missed, whatever rounding says of a start on an edge.
  return select(select(miss, t, (s.near <= s.far) & (t > tMin)), max(s.far, 0.0), startsInside);
}

// v turned by the unit quaternion q, and back.
fn rotate(q: vec4f, v: vec3f) -> vec3f {
  let t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

struct Extent {
  // box: rotation from world to box as a quaternion (x, y, z, w); quad: reciprocal of its u edge
  a: vec4f,
  // box: half its size; quad: reciprocal of its v edge
  b: vec4f,
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


fn hitQuad(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  let extent = fetchExtent(i);
  let t = intersectQuad(ray.start.point, ray.direction, bounds.center, extent.a.xyz, extent.b.xyz, ray.start.tMin);
  return select(t, miss, i == ray.start.leaves);
}

fn hitPlane(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  let t = intersectPlane(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin);
  return select(t, miss, i == ray.start.leaves);
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

fn intersectPlane(origin: vec3f, direction: vec3f, normal: vec3f, offset: f32, tMin: f32) -> f32 {
  let speed = dot(direction, normal);
  let t = (offset - dot(origin, normal)) / select(speed, parallel, speed == 0.0);
  let speedAway = select(-speed, speed, offset > 0.0);
  let eitherWay = (t > tMin) & (abs(speed) > parallel);
  return select(miss, max(t, 0.0), select(speedAway > parallel, eitherWay, (offset == 0.0) | (frame.planesCutView != 0u)));
}

// Slower than this towards the plane a ray is parallel to it; squares of the farthest hits stay within range.
const parallel = 1e-12;

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


// Where a ray that meets nothing ends for the halo, metres.
const haloEnd = 1e5;

fn isSphere(i: u32) -> bool {
  return i < frame.shapeEnds.x;
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

fn rotateBack(q: vec4f, v: vec3f) -> vec3f {
  return rotate(vec4f(-q.xyz, q.w), v);
}

// Float rounding of a point grows with its distance from the eye, where all positions are relative to.
const relativeTMin = 1e-5;

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


fn fetchLight(i: u32) -> Light {
  let t0 = tableTexel(5u, i);
  let t1 = tableTexel(6u, i);
  let t2 = tableTexel(7u, i);
  let t3 = tableTexel(8u, i);
  return Light(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w);
}

fn lightSampler(count: u32, pixelHash: u32, light: u32, reflection: u32) -> LightSampler {
  let h = pcg(pixelHash + 128u * light + reflection);
  return LightSampler(count, vec2f(unitFloat(h), unitFloat(pcg(h))));
}

// The samples first … first + count − 1 of a light seen from one point, at most 32.
struct SampleGroup {
  start: Start,
  center: vec3f,
  radius: f32,
  points: LightSampler,
  first: u32,
  count: u32,
  // The turn of the first: see samplePoint.
  turn: vec2f,
}


// Point k + 1 of the lattice lies one golden angle further round than point k: a rotation in place of a cosine and a sine, which cost
// more than all else here, and without branches both kinds of points are computed.
fn firstTurn(s: LightSampler, k: u32) -> vec2f {
  let phi = 6.283185307 * fract(f32(k) * 0.61803398875 + s.shift.y);
  return vec2f(cos(phi), sin(phi));
}

// Diffuse and highlight of the group's sample points that are not hidden.
fn sampled(p: SurfacePoint, m: Material, light: Light, group: SampleGroup) -> vec3f {
  var sum = vec3f(0.0);
  let hidden = hiddenSamples(group);
  var turn = group.turn;
  var k = 0u;
  loop {
    if (((hidden >> k) & 1u) == 0u) {
      sum += sampleLight(p, m, light, toSample(group, k, turn));
    }
    turn = nextTurn(turn);
    k++;
    if (k >= group.count) {
      break;
    }
  }
  return sum;
}

// Random numbers as a pure function of what they are for. PCG-RXS-M-XS-32 as a hash: Jarzynski & Olano, "Hash Functions for
// GPU Rendering", JCGT 9(3), 2020.
fn pcg(x: u32) -> u32 {
  let s = x * 747796405u + 2891336453u;
  let w = ((s >> ((s >> 28u) + 4u)) ^ s) * 277803737u;
  return (w >> 22u) ^ w;
}

struct LightSampler {
  count: u32,
  // Turns the Fibonacci lattice, different for each pixel, film sample, reflection and light.
  shift: vec2f,
}


// Uniform in [0, 1) with 24 bits.
fn unitFloat(h: u32) -> f32 {
  return f32(h >> 8u) * 5.9604644775390625e-8;
}

// Bit k set: sample k of the group is hidden. One loop takes up the occluders by the 32 and goes through those that matter: nested, it
// would double what Windows' shader compiler needs.
fn hiddenSamples(group: SampleGroup) -> u32 {
  var hidden = 0u;
  if (frame.occluderEnd == 0u) {
    return hidden;
  }
  let all = everySample(group);
  let cone = shadowCone(group.start.point, group.center, group.radius, group.points.count);
  // Past the occluders taken up, and which of them are still to be looked at.
  var end = 0u;
  var rest = 0u;
  loop {
    if (rest == 0u) {
      rest = candidates(group, cone, end);
      end += 32u;
    }
    if (rest != 0u) {
      let i = end - 32u + lowestBit(rest);
      if (isSphere(i)) {
        hidden |= behindSphere(group, i, cone);
      } else {
        hidden |= behindFaces(group, i, cone);
      }
      rest &= rest - 1u;
    }
    if (((rest == 0u) & (end >= frame.occluderEnd)) | (hidden == all)) {
      break;
    }
  }
  return hidden;
}

struct Light {
  // eye-relative
  center: vec3f,
  // of the ball
  radius: f32,
  // added everywhere
  ambient: vec3f,
  // unused
  spare0: f32,
  // colour of the diffuse part
  diffuse: vec3f,
  // radiance times radius^2: w = power / distance^2
  power: f32,
  // colour of the highlight
  specular: vec3f,
  // unused
  spare1: f32,
}


fn nextTurn(turn: vec2f) -> vec2f {
  // Cosine and sine of 2 pi * 0.61803398875.
  let c = -0.7373688781;
  let s = -0.6754902942;
  return vec2f(turn.x * c - turn.y * s, turn.x * s + turn.y * c);
}

// Light of one unoccluded sample point, w included.
fn sampleLight(p: SurfacePoint, m: Material, light: Light, toLight: vec3f) -> vec3f {
  let distance2 = dot(toLight, toLight);
  let l = toLight * inverseSqrt(distance2);
  let cosine = dot(p.normal, l);
  if (cosine <= 0.0) {
    return vec3f(0.0);
  }
  var c = m.baseColor * light.diffuse * cosine;
  if (m.specular > 0.0) {
    c += m.specular * light.specular * pow(max(dot(p.normal, normalize(l + p.view)), 1e-10), m.exponent);
  }
  return c * (light.power / distance2);
}

// From the surface to sample k of the group, `turn` being its turn of the lattice.
fn toSample(group: SampleGroup, k: u32, turn: vec2f) -> vec3f {
  return group.center + group.radius * samplePoint(group.points, group.first + k, turn) - group.start.point;
}

// Point k relative to the centre, in radii.
fn samplePoint(s: LightSampler, k: u32, turn: vec2f) -> vec3f {
  let i = f32(k);
  let row = floor((i + 0.5) * 0.33333334);
  let fixed9 = vec3f(0.5 * (i - 3.0 * row) - 0.5, 0.0, 0.5 * row - 0.5);
  let z = 1.0 - 2.0 * (i + s.shift.x) / f32(s.count);
  let lattice = vec3f(sqrt(max(1.0 - z * z, 0.0)) * turn, z);
  return select(select(lattice, fixed9, s.count == 9u), vec3f(0.0), s.count == 1u);
}

// All bits of the group.
fn everySample(group: SampleGroup) -> u32 {
  return 0xffffffffu >> (32u - group.count);
}

fn shadowCone(apex: vec3f, center: vec3f, radius: f32, count: u32) -> ShadowCone {
  let toLight = center - apex;
  let distance = max(length(toLight), 1e-30);
  // Radius of the sphere around the light's centre that holds all sample points.
  let reach = radius * sampleReach(count);
  let sine = min(reach / distance, 1.0);
  let cosine = sqrt(1.0 - sine * sine);
  return ShadowCone(apex, toLight / distance, distance - reach, distance + reach, sine, cosine, select(sine / cosine, everywhere, cosine < 1e-3));
}

// Bit i − base set: the cone may meet occluder i, of the 32 from `base` on. No branches, so that it takes next to nothing.
fn candidates(group: SampleGroup, cone: ShadowCone, base: u32) -> u32 {
  let end = min(frame.occluderEnd, base + 32u);
  var found = 0u;
  var i = base;
  loop {
    let bounds = fetchBounds(i);
    let meetsPlane = coneMeetsPlane(cone, bounds.center, bounds.radius);
    let meetsBall = !coneMissesBall(cone, placeBall(cone, bounds.center), bounds.radius);
    found |= select(0u, 1u, select(meetsBall, meetsPlane, isPlane(i))) << (i - base);
    i++;
    if (i >= end) {
      break;
    }
  }
  // The solid that the rays start inside of counts always, whatever rounding says; what they leave, never.
  let inside = group.start.inside - base;
  let leaves = group.start.leaves - base;
  found |= select(0u, 1u << (inside & 31u), inside < 32u);
  return found & ~select(0u, 1u << (leaves & 31u), leaves < 32u);
}

struct ShadowCone {
  apex: vec3f,
  axis: vec3f,
  // How far along the axis sample points may lie, at least and at most.
  start: f32,
  end: f32,
  sine: f32,
  cosine: f32,
  tangent: f32,
}


// Whether a plane lies between the apex and some sample point.
fn coneMeetsPlane(cone: ShadowCone, normal: vec3f, offset: f32) -> bool {
  let here = dot(normal, cone.apex) - offset;
  let there = here + dot(normal, cone.axis) * 0.5 * (cone.start + cone.end);
  return min(here * there, abs(there) - 0.5 * (cone.end - cone.start)) <= 0.0;
}

// True only when no ray of the cone meets the ball. The distance from the cone's mantle is across · cos − along · sin. Maxima in place
// of conditions: software rasterisers and compilers both take them faster.
fn coneMissesBall(cone: ShadowCone, ball: BallPlace, radius: f32) -> bool {
  let beside = ball.across * cone.cosine - ball.along * cone.sine;
  let outside = max(max(beside, -ball.along), ball.along - cone.end);
  return outside > select(radius, everywhere, cone.tangent == everywhere);
}

fn placeBall(cone: ShadowCone, center: vec3f) -> BallPlace {
  let toBall = center - cone.apex;
  let along = dot(toBall, cone.axis);
  // Not by Pythagoras: the difference of two large squares hides small balls that are far away.
  return BallPlace(along, length(toBall - along * cone.axis));
}

// Farther than any scene. For a point among the sample points themselves, where there is no cone.
const everywhere = 1e30;

// Where a ball lies to the cone.
struct BallPlace {
  along: f32,
  across: f32,
}


// Index of the lowest set bit: the exponent of that power of two as a float. (WebGL2 has no instruction for it.)
fn lowestBit(bits: u32) -> u32 {
  return (bitcast<u32>(f32(bits & (~bits + 1u))) >> 23u) - 127u;
}

// Bit k set: sample k of the group is behind the sphere i, which the cone may meet.
fn behindSphere(group: SampleGroup, i: u32, cone: ShadowCone) -> u32 {
  let bounds = fetchBounds(i);
  let hides = ballHidesLight(cone, placeBall(cone, bounds.center), bounds.radius) & (i != group.start.inside);
  if (hides) {
    return everySample(group);
  }
  var bits = 0u;
  var turn = group.turn;
  var k = 0u;
  loop {
    let d = toSample(group, k, turn);
    turn = nextTurn(turn);
    let inverse = inverseSqrt(dot(d, d));
    bits |= select(0u, 1u, hitSphere(i, bounds, Ray(group.start, d * inverse)) * inverse < 1.0) << k;
    k++;
    if (k >= group.count) {
      break;
    }
  }
  return bits;
}

// True only when every ray of the cone goes through the ball on its way to the light. The margin covers rounding.
fn ballHidesLight(cone: ShadowCone, ball: BallPlace, radius: f32) -> bool {
  let covers = radius * 0.9999 - ball.across * cone.cosine - ball.along * cone.sine;
  return min(min(covers, ball.along - radius), cone.start - ball.along - radius) > 0.0;
}

// The same for a shape with faces: the space between three pairs of parallel planes. Those of a quad's third pair fall together; a
// plane is such a pair alone. As one kind they share one loop: loops are what Windows' shader compiler takes its time for.
fn behindFaces(group: SampleGroup, i: u32, cone: ShadowCone) -> u32 {
  let bounds = fetchBounds(i);
  let extent = fetchExtent(i);
  let fromCenter = group.start.point - bounds.center;
  let startsInside = i == group.start.inside;
  // The rows of the matrix that takes the world to a frame in which the faces lie across the axes.
  var x = rotateBack(extent.a, vec3f(1.0, 0.0, 0.0));
  var y = rotateBack(extent.a, vec3f(0.0, 1.0, 0.0));
  var z = rotateBack(extent.a, vec3f(0.0, 0.0, 1.0));
  var halfSize = extent.b.xyz;
  if (isFlat(i)) {
    x = extent.a.xyz;
    y = extent.b.xyz;
    z = normalize(cross(x, y));
    halfSize = vec3f(vec2f(0.5 + quadOverlap), 0.0);
  }
  var origin = vec3f(dot(x, fromCenter), dot(y, fromCenter), dot(z, fromCenter));
  var tMin = group.start.tMin;
  if (isPlane(i)) {
    // No edges: no ray has a direction along x or y, and every one lies between those faces.
    x = vec3f(0.0);
    y = vec3f(0.0);
    z = select(-bounds.center, bounds.center, bounds.radius > 0.0);
    halfSize = vec3f(1.0, 1.0, 0.0);
    origin = vec3f(0.0, 0.0, dot(z, group.start.point) - abs(bounds.radius));
    // z leads away from the eye. The start is on the eye's side whatever rounding says (plane.wesl).
    if ((bounds.radius != 0.0) & (frame.planesCutView == 0u)) {
      origin.z = min(origin.z, -parallel);
      tMin = 0.0;
    }
  }
  var meets = boxMet;
  if (!(startsInside | isFlat(i))) {
    let axis = vec3f(dot(x, cone.axis), dot(y, cone.axis), dot(z, cone.axis));
    meets = placeBox(cone, origin, axis, halfSize, bounds.radius - dot(fromCenter, cone.axis));
  }
  if (meets != boxMet) {
    return select(0u, everySample(group), meets == boxHidesLight);
  }
  var bits = 0u;
  var turn = group.turn;
  var k = 0u;
  loop {
    let d = toSample(group, k, turn);
    turn = nextTurn(turn);
    let inverse = inverseSqrt(dot(d, d));
    let toLight = d * inverse;
    let direction = vec3f(dot(x, toLight), dot(y, toLight), dot(z, toLight));
    let t = intersectBox(origin, direction, halfSize, tMin, startsInside);
    bits |= select(0u, 1u, t * inverse < 1.0) << k;
    k++;
    if (k >= group.count) {
      break;
    }
  }
  return bits;
}

const boxMet = 1u;

// `apex` and `axis` in the box's frame; `end`: how far along the axis the box may reach.
fn placeBox(cone: ShadowCone, apex: vec3f, axis: vec3f, halfSize: vec3f, end: f32) -> u32 {
  let radius = 1.0001 * min(end, cone.end) * cone.tangent;
  let inverse = safeReciprocal(axis, apex);
  let middle = -apex * inverse;
  let half = halfSize * abs(inverse);
  let margin = radius * abs(inverse);
  let low = middle - half;
  let high = middle + half;
  let grownNear = max3(low - margin);
  let grownFar = min3(high + margin);
  let met = min(min(grownFar - grownNear, grownFar), cone.end - grownNear) >= 0.0;
  let near = max3(low + margin);
  let through = min(min(min3(high - margin) - near, near), cone.start - near) > 0.0;
  let apexOutside = max3(abs(apex) - halfSize) > 0.0;
  let hides = through & apexOutside & (min3(halfSize) > radius);
  return select(boxMissed, select(boxMet, boxHidesLight, hides), met | (cone.tangent == everywhere));
}

fn max3(v: vec3f) -> f32 {
  return max(max(v.x, v.y), v.z);
}

fn min3(v: vec3f) -> f32 {
  return min(min(v.x, v.y), v.z);
}

// How a box about the origin lies to the cone, told by the cone's axis alone: against the box grown by the cone's radius where the
// box ends, every ray misses if the axis does; against the box shrunk by it, every ray goes through if the axis does.
const boxMissed = 0u;

const boxHidesLight = 2u;

// How far the points reach from the light's centre, in radii.
fn sampleReach(count: u32) -> f32 {
  if (count == 1u) {
    return 0.0;
  }
  return select(1.0, 0.70710678, count == 9u);
}

// The camera as a pinhole.
fn centralRay(filmPosition: vec2f) -> CameraRay {
  return rayThroughLens(filmPosition, vec2f(0.0));
}

fn pixelHash0(pixel: vec2u, sampleIndex: u32, seed: u32) -> u32 {
  return pcg(pixel.x + pcg(pixel.y + pcg(sampleIndex + pcg(seed))));
}

// On the camera: at the eye, which is the origin, or on the lens.
fn onCamera(point: vec3f) -> Start {
  return Start(point, noShape, noShape, 0.0);
}

@group(0) @binding(2) var previousFilm: texture_2d<f32>;

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

override hasOtherProjections = false;

struct CameraRay {
  origin: vec3f,
  direction: vec3f,
}


const pi = 3.14159265358979;
