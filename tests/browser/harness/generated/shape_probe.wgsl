// Linked from tests/shape-probe.wesl by `npm run shaders`. Do not edit.
@group(0) @binding(2) var rays: texture_2d<f32>;

// The rules of start, as rays.ts numbers them.
const fromEye = 0u;

const leavingIt = 1u;

const insideIt = 2u;

fn startOf(rule: u32, point: vec3f, shape: u32) -> Start {
  if (rule == fromEye) {
    return Start(point, noShape, noShape, 0.0);
  }
  if (rule == leavingIt) {
    return onSurface(point, shape, false);
  }
  if (rule == insideIt) {
    return onSurface(point, shape, true);
  }
  return onSurface(point, noShape, false);
}

@fragment fn shapeProbe(@builtin(position) fragment: vec4f) -> @location(0) vec4f {
  let pixel = vec2u(fragment.xy);
  let a = textureLoad(rays, vec2u(2u * pixel.x, pixel.y), 0);
  let b = textureLoad(rays, vec2u(2u * pixel.x + 1u, pixel.y), 0);
  let shape = u32(a.w);
  let ray = Ray(startOf(u32(b.w), a.xyz, shape), b.xyz);
  let t = hitShape(shape, fetchBounds(shape), ray);
  if (t >= miss) {
    return vec4f(miss, 0.0, 0.0, 0.0);
  }
  return vec4f(t, outwardNormal(shape, ray, t));
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


// A ray knows where it comes from, so that a surface is never met by its own ray again: no offset along the normal,
// nothing that depends on the size of the scene.
const noShape = 0xffffffffu;

// On `shape`, for rays to the side that it is seen from: the inside of a solid or not.
fn onSurface(point: vec3f, shape: u32, seenFromInside: bool) -> Start {
  return Start(point, select(shape, noShape, seenFromInside), select(noShape, shape, seenFromInside), relativeTMin * length(point));
}

// Float rounding of a point grows with its distance from the eye, where all positions are relative to.
const relativeTMin = 1e-5;

struct Ray {
  start: Start,
  direction: vec3f,
}


// The same for a shape of any kind.
fn hitShape(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  if (isSphere(i)) {
    return hitSphere(i, bounds, ray);
  }
  if (isBox(i)) {
    return hitBox(i, bounds, ray);
  }
  if (isQuad(i)) {
    return hitQuad(i, bounds, ray);
  }
  return hitPlane(i, bounds, ray);
}

fn fetchBounds(i: u32) -> Bounds {
  let t0 = tableTexel(0u, i);
  return Bounds(t0.xyz, t0.w);
}

const miss = 1e30;

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

fn isSphere(i: u32) -> bool {
  return i < frame.shapeEnds.x;
}

fn isBox(i: u32) -> bool {
  return (i >= frame.shapeEnds.x) & (i < frame.shapeEnds.y);
}

fn isQuad(i: u32) -> bool {
  return i < frame.shapeEnds.z;
}

fn hitPlane(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  let t = intersectPlane(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin);
  return select(t, miss, i == ray.start.leaves);
}

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

fn tableTexel(column: u32, row: u32) -> vec4f {
  return textureSampleLevel(sceneTable, nearest, vec2f((f32(i32(column)) + 0.5) / tableWidth, (f32(i32(row)) + 0.5) * frame.rowHeight), 0.0);
}

struct Extent {
  // box: rotation from world to box as a quaternion (x, y, z, w); quad: reciprocal of its u edge
  a: vec4f,
  // box: half its size; quad: reciprocal of its v edge
  b: vec4f,
}


@group(0) @binding(1) var sceneTable: texture_2d<f32>;

// How the scene table is read: table_texel.wesl; and, where `sampled`, geometry and texels. Its number is that of packed-scene/layout.ts, far from those of the inputs.
@group(0) @binding(15) var nearest: sampler;

// Written by `npm run shaders` from packed-scene/layout.ts. Do not edit.
// Texels in a row of the scene table.
const tableWidth = 20.0;

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
