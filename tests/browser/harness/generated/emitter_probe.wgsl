// Linked from tests/emitter-probe.wesl by `npm run shaders`. Do not edit.
@group(0) @binding(2) var questions: texture_2d<f32>;

// The questions, as emitters/probe.ts numbers them.
const directionAndPdf = 0u;

const radianceAndDistance = 1u;

const pdfOfSample = 2u;

const choice = 4u;

@fragment fn emitterProbe(@builtin(position) fragment: vec4f) -> @location(0) vec4f {
  let pixel = vec2u(fragment.xy);
  let a = textureLoad(questions, vec2u(3u * pixel.x, pixel.y), 0);
  let b = textureLoad(questions, vec2u(3u * pixel.x + 1u, pixel.y), 0);
  let c = textureLoad(questions, vec2u(3u * pixel.x + 2u, pixel.y), 0);
  let question = u32(b.w);
  let index = u32(a.w);
  if (question == choice) {
    let chosen = chooseEmitter(a.xyz, c.xyz, b.x);
    let own = probabilityOf(fetchEmitter(chosen.index), a.xyz, c.xyz, chosen.total);
    return vec4f(f32(chosen.index), chosen.probability, own, probabilityOf(fetchEmitter(index), a.xyz, c.xyz, chosen.total));
  }
  let e = fetchEmitter(index);
  let s = sampleEmitter(e, a.xyz, b.xy);
  if (question == directionAndPdf) {
    return vec4f(s.direction, s.pdf);
  }
  if (question == radianceAndDistance) {
    return vec4f(s.radiance, s.distance);
  }
  // A ray in that direction, as the integrator casts it.
  let direction = select(c.xyz, s.direction, question == pdfOfSample);
  var t = miss;
  var normal = vec3f(0.0);
  if (e.shape >= 0.0) {
    let shape = u32(e.shape);
    let ray = Ray(onSurface(a.xyz, noShape, false), direction);
    t = hitShape(shape, fetchBounds(shape), ray);
    normal = outwardNormal(shape, ray, min(t, miss));
    if (t >= miss) {
      return vec4f(0.0, miss, s.pdf, f32(s.delta));
    }
  }
  let far = farLight(e, direction);
  return vec4f(shapePdf(e, a.xyz, direction, t, normal) + far.pdf, t, length(far.radiance), f32(s.delta));
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

const miss = 1e30;

fn farLight(e: Emitter, direction: vec3f) -> FarLight {
  var far = FarLight(vec3f(0.0), 0.0);
  if (hasSuns) {
    let seen = (e.kind == directionalKind) & isOnDisc(e, direction);
    far = FarLight(select(vec3f(0.0), e.radiance, seen), select(0.0, directionalPdf(e, direction), seen));
  }
  if (hasSky) {
    if (e.kind == skyKind) {
      let seen = skyLight(direction);
      far = FarLight(seen.radiance, seen.pdf);
    }
  }
  return far;
}

// The density with which sampleEmitter gives that direction, for an emitter that is a shape. The ray met it `distance` away, with that
// outward normal.
fn shapePdf(e: Emitter, point: vec3f, direction: vec3f, distance: f32, normal: vec3f) -> f32 {
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
  return pdf;
}

// `normal` is that of the side that the point is seen from, or vec3f(0) where light comes through from both. One loop: weighted
// reservoir sampling (Chao 1982) with one random number: whatever of u decided is stretched to [0, 1) again.
fn chooseEmitter(point: vec3f, normal: vec3f, u: f32) -> EmitterChoice {
  var choice = EmitterChoice(0u, f32(min(frame.emitterCount, 1u)), 1.0);
  if (hasManyLights) {
    if (frame.emitterCount > 1u) {
      var total = 0.0;
      var chosen = 0u;
      var chosenWeight = 0.0;
      var rest = u;
      var i = 0u;
      loop {
        let weight = estimatedIrradiance(fetchEmitter(i), point, normal);
        total += weight;
        let share = weight / max(total, 1e-37);
        let take = rest < share;
        chosen = select(chosen, i, take);
        chosenWeight = select(chosenWeight, weight, take);
        rest = select((rest - share) / max(1.0 - share, 1e-7), rest / max(share, 1e-37), take);
        i++;
        if (i >= frame.emitterCount) {
          break;
        }
      }
      choice = EmitterChoice(chosen, chosenWeight / max(total, 1e-37), total);
    }
  }
  return choice;
}

// With which chooseEmitter would have chosen this one there.
fn probabilityOf(e: Emitter, point: vec3f, normal: vec3f, total: f32) -> f32 {
  var probability = f32(min(frame.emitterCount, 1u));
  if (hasManyLights) {
    if (frame.emitterCount > 1u) {
      probability = estimatedIrradiance(e, point, normal) / max(total, 1e-37);
    }
  }
  return probability;
}

fn fetchEmitter(i: u32) -> Emitter {
  let t0 = textureLoad(sceneTable, vec2u(14u, i), 0);
  let t1 = textureLoad(sceneTable, vec2u(15u, i), 0);
  let t2 = textureLoad(sceneTable, vec2u(16u, i), 0);
  let t3 = textureLoad(sceneTable, vec2u(17u, i), 0);
  let t4 = textureLoad(sceneTable, vec2u(18u, i), 0);
  return Emitter(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w, t4.x, t4.y, t4.z, t4.w);
}

struct EmitterChoice {
  index: u32,
  // 0: no light reaches the point.
  probability: f32,
  // The sum of all estimates at the point, for `probabilityOf`.
  total: f32,
}


@group(0) @binding(0) var<uniform> frame: Frame;

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
  let above = clamp((dot(normal, toLight) + e.reach) / grown, 0.0, 1.0);
  let cosine = select(above, 1.0, dot(normal, normal) == 0.0);
  // On the axis of a disc the first is exact, outside of a sphere the second.
  let square = select(max(distance2, e.area / (4.0 * pi)), distance2 + e.area / pi, isQuad);
  var estimate = e.power * cosine / select(max(square, 1e-15), 1.0, isFar);
  if (hasQuadLights) {
    let height = -dot(cross(e.u, e.v), toLight) / max(e.area, 1e-30);
    let side = select(abs(height), max(height, 0.0), e.oneSided == 1.0);
    let lampCosine = select(0.0, (side + e.reach) / grown, side > 0.0);
    estimate *= select(1.0, lampCosine, isQuad);
  }
  if (hasPointLights) {
    estimate *= select(1.0, spotFalloff(e, toLight / max(distance, 1e-15)), e.kind == spotKind);
  }
  if (hasSky) {
    estimate = select(estimate, e.power, e.kind == skyKind);
  }
  return estimate;
}

override hasQuadLights = false;

const quadKind = 1.0;

override hasSuns = false;

const directionalKind = 5.0;

const pi = 3.14159265359;

override hasPointLights = false;

override hasSky = true;

struct Emitter {
  // eye-relative: centre of a sphere or box, corner of a quad, place of a point or spot light
  position: vec3f,
  // 0 sphere, 1 quad, 2 box, 3 point, 4 spot, 5 directional, 6 sky
  kind: f32,
  // edge of a quad; unit direction that a spot shines to or directional light travels; halfSize of a box
  u: vec3f,
  // of a sphere; cosine of the outer angle of a spot; cosine of half the angular diameter of directional light
  radius: f32,
  // other edge of a quad
  v: vec3f,
  // cosine of the inner angle of a spot
  cosInner: f32,
  // radiance; of a point or spot: intensity; of directional light without angular size: irradiance
  radiance: vec3f,
  // of the surface that shines, m^2; of directional light: its solid angle, 0 without angular size
  area: f32,
  // row of the shape that rays meet; -1: none, only light sampling finds it
  shape: f32,
  // 1: a quad that shines to the side of u x v only
  oneSided: f32,
  // for choosing among emitters: power / distance^2 estimates the irradiance in front of it
  power: f32,
  // radius of the bounding sphere; of directional light: sine of half the angular diameter
  reach: f32,
}


// glTF's KHR_lights_punctual, "Inner and Outer Cone Angles": full within the inner cone, none outside of the outer.
fn spotFalloff(e: Emitter, toLight: vec3f) -> f32 {
  let share = clamp((-dot(toLight, e.u) - e.radius) / (e.cosInner - e.radius), 0.0, 1.0);
  return share * share;
}

const spotKind = 4.0;

const skyKind = 6.0;

struct Frame {
  // camera r times half the width of what is seen: camera.wesl
  right: vec3f,
  // film pixels
  width: f32,
  // camera u times half the height of what is seen
  up: vec3f,
  // film pixels
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
  // film columns where the second and third panel begin
  dividers: vec2f,
  // index past the last sphere, box, quad and plane
  shapeEnds: vec4u,
  // index past the last shape that may stand between a light and a point
  occluderEnd: u32,
  // index past the last light that camera and mirrors see
  seenLightEnd: u32,
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
}


@group(0) @binding(1) var sceneTable: texture_2d<f32>;

struct Ray {
  start: Start,
  direction: vec3f,
}


// On `shape`, for rays to the side that it is seen from: the inside of a solid or not.
fn onSurface(point: vec3f, shape: u32, seenFromInside: bool) -> Start {
  return Start(point, select(shape, noShape, seenFromInside), select(noShape, shape, seenFromInside), relativeTMin * length(point));
}

// A ray knows where it comes from, so that a surface is never met by its own ray again: no offset along the normal,
// nothing that depends on the size of the scene.
const noShape = 0xffffffffu;

// The same for a shape of any kind.
fn hitShape(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  if (isSphere(i)) {
    return hitSphere(i, bounds, ray);
  }
  if (isBox(i)) {
    return hitBox(i, bounds, ray);
  }
  if (isQuad0(i)) {
    return hitQuad(i, bounds, ray);
  }
  return hitPlane(i, bounds, ray);
}

fn fetchBounds(i: u32) -> Bounds {
  let t0 = textureLoad(sceneTable, vec2u(0u, i), 0);
  return Bounds(t0.xyz, t0.w);
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


// Float rounding of a point grows with its distance from the eye, where all positions are relative to.
const relativeTMin = 1e-5;

fn isSphere(i: u32) -> bool {
  return i < frame.shapeEnds.x;
}

fn isBox(i: u32) -> bool {
  return (i >= frame.shapeEnds.x) & (i < frame.shapeEnds.y);
}

fn isQuad0(i: u32) -> bool {
  return i < frame.shapeEnds.z;
}

fn hitPlane(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  let t = intersectPlane(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin);
  return select(t, miss, i == ray.start.leaves);
}

// Written by `npm run shaders` from packed-scene/layout.ts. Do not edit.
struct Bounds {
  // centre of the bounding sphere, eye-relative; of a plane: its unit normal
  center: vec3f,
  // of the bounding sphere; of a plane: dot(normal, p) of its points
  radius: f32,
}


// Distances along the ray to shape i of that kind, or `miss`.
fn hitSphere(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  let t = intersectSphere(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin, i == ray.start.inside);
  return select(t, miss, i == ray.start.leaves);
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
  let t0 = textureLoad(sceneTable, vec2u(1u, i), 0);
  let t1 = textureLoad(sceneTable, vec2u(2u, i), 0);
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

fn isPlane(i: u32) -> bool {
  return (i >= frame.shapeEnds.z) & (i < frame.shapeEnds.w);
}

fn isFlat(i: u32) -> bool {
  return i >= frame.shapeEnds.y;
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


// Kinds of light, and more than one of them.
override hasSphereLights = true;

override hasBoxLights = false;

// packed-scene/pack-emitters.ts has the same numbers.
const sphereKind = 0.0;

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

fn sampleCone(axis: vec3f, width: f32, u: vec2f) -> ConeDirection {
  let oneMinusCosine = u.x * width;
  let cosine = 1.0 - oneMinusCosine;
  let sine2 = oneMinusCosine * (2.0 - oneMinusCosine);
  let sine = sqrt(max(sine2, 0.0));
  let phi = 2.0 * pi * u.y;
  // Some GPUs' sines are off by 1e-4; the direction keeps its length.
  let turn = vec2f(cos(phi), sin(phi));
  let direction = turnTo(axis, vec3f(sine / length(turn) * turn, cosine));
  return ConeDirection(direction, cosine, sine2);
}

fn conePdf(width: f32) -> f32 {
  return 1.0 / (2.0 * pi * max(width, 1e-31));
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

fn pdfOfView(q: QuadView, area: f32, distance: f32) -> f32 {
  let pdf = select(areaPdf(area, q.height, distance), 1.0 / max(q.solidAngle, smallSolidAngle), q.bySolidAngle);
  return select(0.0, pdf, q.lit);
}

// T(x)
fn stretch(x: f32, y: vec2f, h: f32) -> f32 {
  let r = sqrt(x * x + y * y + h * h);
  return arctangent(x * y.y / (h * r.y)) - arctangent(x * y.x / (h * r.x));
}

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


// Rectangles that fill less than this, in steradians, are sampled by area.
const smallSolidAngle = 0.01;

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

// Cosine and sine of x, |x| <= pi / 2, from the sine of x / 2.
fn cosineAndSine(x: f32) -> vec2f {
  let h = 0.5 * x;
  let z = h * h;
  let sine = ((-1.9515295891e-4 * z + 8.3321608736e-3) * z - 1.6666654611e-1) * z * h + h;
  return vec2f(1.0 - 2.0 * sine * sine, 2.0 * sine * sqrt(1.0 - sine * sine));
}

// Density per solid angle of a point that is uniform on a flat face: distance^2 / (area cos), with cos = height / distance.
fn areaPdf(area: f32, height: f32, distance: f32) -> f32 {
  let pdf = (distance / max(height, 1e-30)) * distance / max(area / distance, 1e-30);
  return min(pdf, largestPdf);
}

// Above all real densities, so that what divides by one stays finite.
const largestPdf = 1e30;

const boxKind = 2.0;

fn sampleBox(e: Emitter, point: vec3f, u: vec2f) -> LightSample {
  let b = viewBox(e, point);
  let onFaces = pointOnFaces(e, b, u);
  let outwards = sampleCone(vec3f(0.0, 0.0, 1.0), 2.0, u).direction;
  let distance = select(length(onFaces.xyz), max(boxSlabs(b.point, outwards, e.u).far, 0.0), b.inside);
  let direction = select(onFaces.xyz / max(distance, 1e-30), outwards, b.inside);
  let pdf = select(areaPdf(b.area, onFaces.w, distance), conePdf(2.0), b.inside);
  return LightSample(rotateBack(b.rotation, direction), distance, e.radiance, pdf, false);
}

fn viewBox(e: Emitter, point: vec3f) -> BoxView {
  let rotation = fetchExtent(u32(e.shape)).a;
  let p = rotate(rotation, point - e.position);
  let seen = abs(p) > e.u;
  let faces = select(vec3f(0.0), 4.0 * e.u.yzx * e.u.zxy, seen);
  return BoxView(rotation, p, faces, faces.x + faces.y + faces.z, !any(seen));
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
  let ray = sampleCone(-e.u, e.area / (2.0 * pi), u);
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
const white = EnvironmentLight(vec3f(1.0), 0.25 / pi);

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
  let theta = cosineAndSine(fromPole * (pi / size.y));
  let halfTurns = 2.0 * ((cell.x + (s - 0.5)) / size.x - frame.environmentTurn);
  let nearest = floor(halfTurns + 0.5);
  let back = fract(0.5 * nearest) > 0.0;
  let phi = cosineAndSine((halfTurns - nearest) * pi) * select(1.0, -1.0, back);
  let sine = max(theta.y, 1e-9);
  let direction = vec3f(sine * phi.y, select(theta.x, -theta.x, isLower), -sine * phi.x);
  return EnvironmentSample(direction, lightWithin(k, vec2f(s, t), sine));
}

fn chooseCell(u: vec2f) -> ChosenCell {
  let size = vec2u(frame.environmentSize);
  let place = splitProduct(u, size + vec2u(0u, 1u));
  // The digits that the choice of a column has used up are replaced by hashed ones: probabilities in the table may be small.
  let hash = mixBits(bitcast<u32>(u.x) ^ (bitcast<u32>(u.y) * 0x9e3779b1u)) >> 8u;
  let fine = f32(hash) * 5.9604644775390625e-8 * frame.environmentSize.x;
  let x = min((place.rest.x + fine) * 5.9604644775390625e-8, 0.99999994);
  // Two rows of cells share a row of texels.
  let rows = (size.y + 2u) / 2u;
  let second = place.whole.y >= rows;
  let entries = textureLoad(environment, vec2u(place.whole.x, place.whole.y + size.y - select(0u, rows, second)), 0);
  let entry = select(entries.xy, entries.zw, second);
  let own = x < entry.x;
  let other = u32(entry.y);
  let otherRow = other / size.x;
  let cell = select(vec2u(other - otherRow * size.x, otherRow), place.whole, own);
  let rest = select((x - entry.x) / max(1.0 - entry.x, 1e-7), x / max(entry.x, 1e-37), own);
  return ChosenCell(cell, vec2f(min(rest, 1.0), place.rest.y * 5.9604644775390625e-8));
}

fn environmentCorners(cell: vec2u) -> Corners {
  let size = vec2u(frame.environmentSize);
  let left = select(cell.x, size.x, cell.x == 0u) - 1u;
  let right = select(cell.x, 0u, cell.x == size.x);
  let upper = max(cell.y, 1u) - 1u;
  let lower = min(cell.y, size.y - 1u);
  let above = vec4f(1.0, 1.0, 1.0, select(1.0, -1.0, cell.y == 0u));
  let below = vec4f(1.0, 1.0, 1.0, select(1.0, -1.0, cell.y == size.y));
  return Corners(above * textureLoad(environment, vec2u(left, upper), 0), above * textureLoad(environment, vec2u(right, upper), 0), below * textureLoad(environment, vec2u(left, lower), 0), below * textureLoad(environment, vec2u(right, lower), 0));
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

fn splitProduct(u: vec2f, n: vec2u) -> Parts {
  let digits = vec2u(u * 16777216.0);
  let low = (digits & vec2u(4095u)) * n;
  let high = (digits >> vec2u(12u)) * n + (low >> vec2u(12u));
  return Parts(high >> vec2u(12u), vec2f(((high & vec2u(4095u)) << vec2u(12u)) | (low & vec2u(4095u))));
}

// A hash without the shift by a variable of pcg, which takes a software rasteriser longer than all the rest of it:
// C. Wellons, "Prospecting for Hash Functions", 2018, with the constants found by T. Ettinger.
fn mixBits(x: u32) -> u32 {
  var y = (x ^ (x >> 16u)) * 0x21f0aaadu;
  y = (y ^ (y >> 15u)) * 0x735a2d97u;
  return y ^ (y >> 15u);
}

// Radiance from all around, and below it what samples it: packed-scene/pack-environment.ts.
@group(0) @binding(4) var environment: texture_2d<f32>;

// The cell, and what is left of u, in [0, 1).
struct ChosenCell {
  cell: vec2u,
  rest: vec2f,
}


// u n for whole n up to 4096, without rounding: the whole part, and what is left of it in units of 2^-24.
struct Parts {
  whole: vec2u,
  rest: vec2f,
}


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


// What a ray that meets no shape sees of this emitter, and the density with which sampleEmitter gives that direction. Suns are discs
// before the sky and add to it.
struct FarLight {
  radiance: vec3f,
  pdf: f32,
}


// Whether the disc is seen in that direction: by the chord, 1 - cos = |a - b|^2 / 2, as cosines round to 1 for small discs.
fn isOnDisc(e: Emitter, direction: vec3f) -> bool {
  let chord = direction + e.u;
  return pi * dot(chord, chord) < e.area;
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
  let turn = select(angles.x, pi - angles.x, direction.z > 0.0) * select(1.0, -1.0, direction.x < 0.0);
  let column = fract(turn * (0.5 / pi) + frame.environmentTurn) * size.x + 0.5;
  let fromPole = angles.y * (size.y / pi) + 0.5;
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

// A ray can meet a sphere that rounding takes it to be outside of in its back; light sampling never goes there.
fn spherePdf(e: Emitter, point: vec3f, direction: vec3f) -> f32 {
  let view = viewSphere(e, point);
  let reached = view.inside | (dot(direction, view.toCenter) > 0.0);
  return select(0.0, conePdf(view.width), reached);
}

fn quadPdf(e: Emitter, point: vec3f, distance: f32) -> f32 {
  return pdfOfView(viewQuad(e, point), e.area, distance);
}

fn boxPdf(e: Emitter, point: vec3f, direction: vec3f, distance: f32, normal: vec3f) -> f32 {
  let b = viewBox(e, point);
  return select(areaPdf(b.area, distance * abs(dot(direction, normal)), distance), conePdf(2.0), b.inside);
}
