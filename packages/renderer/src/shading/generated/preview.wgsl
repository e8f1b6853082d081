// Linked from integrator/classic/preview.wesl by `npm run shaders`. Do not edit.
@fragment fn preview(@builtin(position) fragment: vec4f) -> @location(0) vec4f {
  let camera = centralRay(vec2f(frame.origin) + fragment.xy);
  var ray = Ray(onCamera(camera.origin), camera.direction);
  var radiance = sky(ray.direction);
  var normal = vec3f(0.0);
  var color = vec3f(0.0);
  // Of the light that the ray goes to; nothing yet for the camera ray.
  var contribution = vec3f(0.0);
  var distance = 0.0;
  for (var i = 0u; i <= frame.lightCount; i++) {
    let hit = closestHit(ray, 0u);
    if (i == 0u) {
      if (hit.shape == noShape) {
        break;
      }
      let position = ray.start.point + hit.t * ray.direction;
      let outward = outwardNormal(hit.shape, ray, hit.t);
      let back = dot(outward, ray.direction) > 0.0;
      normal = select(outward, -outward, back);
      ray.start = onSurface(position, hit.shape, back && !isFlat(hit.shape));
      let material = fetchMaterial(hit.shape);
      color = material.baseColor;
      radiance = vec3f(0.0);
    } else if (hit.t >= distance) {
      radiance += contribution;
    }
    if (i < frame.lightCount) {
      let light = fetchLight(i);
      radiance += light.ambient * color;
      let toLight = light.center - ray.start.point;
      distance = length(toLight);
      ray.direction = toLight / distance;
      contribution = color * light.diffuse * (max(dot(normal, ray.direction), 0.0) * light.power / (distance * distance));
    }
  }
  return vec4f(radiance, 1.0);
}

// The camera as a pinhole.
fn centralRay(filmPosition: vec2f) -> CameraRay {
  return rayThroughLens(filmPosition, vec2f(0.0));
}

@group(0) @binding(0) var<uniform> frame: Frame;

struct Ray {
  start: Start,
  direction: vec3f,
}


// On the camera: at the eye, which is the origin, or on the lens.
fn onCamera(point: vec3f) -> Start {
  return Start(point, noShape, noShape, 0.0);
}

fn sky(direction: vec3f) -> vec3f {
  return mix(frame.horizon, frame.zenith, max(direction.y, 0.0));
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

// A ray knows where it comes from, so that a surface is never met by its own ray again: no offset along the normal,
// nothing that depends on the size of the scene.
const noShape = 0xffffffffu;

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

fn fetchBounds(i: u32) -> Bounds {
  let t0 = tableTexel(0u, i);
  return Bounds(t0.xyz, t0.w);
}

fn isSphere(i: u32) -> bool {
  return i < frame.shapeEnds.x;
}

fn isPlane(i: u32) -> bool {
  return (i >= frame.shapeEnds.z) & (i < frame.shapeEnds.w);
}

fn fetchExtent(i: u32) -> Extent {
  let t0 = tableTexel(1u, i);
  let t1 = tableTexel(2u, i);
  return Extent(t0.xyzw, t1.xyzw);
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

// v turned by the unit quaternion q, and back.
fn rotate(q: vec4f, v: vec3f) -> vec3f {
  let t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

fn rotateBack(q: vec4f, v: vec3f) -> vec3f {
  return rotate(vec4f(-q.xyz, q.w), v);
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
