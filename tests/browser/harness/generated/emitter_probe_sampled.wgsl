// Linked from tests/emitter-probe.wesl by `npm run shaders`. Do not edit.
@group(0) @binding(2) var questions: texture_2d<f32>;

// The questions, as emitters/probe.ts numbers them.
const directionAndPdf = 0u;

const radianceAndDistance = 1u;

const pdfOfSample = 2u;

const choice = 4u;

fn probabilityOf(e: Emitter, point: vec3f, normal: vec3f, odds: Odds) -> f32 {
  return select(listedProbability(e, point, normal, odds), treeProbability(e, point, normal, odds), e.leaf >= 0.0);
}

@fragment fn emitterProbe(@builtin(position) fragment: vec4f) -> @location(0) vec4f {
  let pixel = vec2u(fragment.xy);
  let a = textureLoad(questions, vec2u(3u * pixel.x, pixel.y), 0);
  let b = textureLoad(questions, vec2u(3u * pixel.x + 1u, pixel.y), 0);
  let c = textureLoad(questions, vec2u(3u * pixel.x + 2u, pixel.y), 0);
  let question = u32(b.w);
  let index = u32(a.w);
  if (question == choice) {
    let chosen = chooseEmitter(a.xyz, c.xyz, b.x);
    let own = probabilityOf(fetchEmitter(chosen.index), a.xyz, c.xyz, chosen.odds);
    return vec4f(f32(chosen.index), chosen.probability, own, probabilityOf(fetchEmitter(index), a.xyz, c.xyz, chosen.odds));
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
  if (e.kind == meshKind) {
    let hit = tracePair(oneRay(a.xyz, direction, 0u));
    if (hit.triangle.instance == noInstance) {
      return vec4f(0.0, miss, s.pdf, f32(s.delta));
    }
    normal = meshPoint(hit.triangle.instance, hit.triangle.triangle, hit.weights).geometric;
    let met = fetchEmitter(index + emitterOfTriangle(e, hit.triangle));
    return vec4f(shapePdf(met, a.xyz, direction, hit.t, normal, hit.triangle.triangle), hit.t, s.pdf, f32(s.delta));
  }
  if (e.shape >= 0.0) {
    let shape = u32(e.shape);
    let ray = Ray(onSurface(a.xyz, noShape, false), direction);
    t = hitShape(shape, fetchBounds(shape), ray);
    normal = outwardNormal(shape, ray, min(t, miss));
    if (t >= miss) {
      return vec4f(0.0, miss, s.pdf, f32(s.delta));
    }
  }
  let far = farLight(e, direction, skySeen(direction));
  return vec4f(shapePdf(e, a.xyz, direction, t, normal, 0u) + far.pdf, t, length(far.radiance), f32(s.delta));
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

// The same of one that is in the tree.
fn treeProbability(e: Emitter, point: vec3f, normal: vec3f, odds: Odds) -> f32 {
  var probability = 0.0;
  if (frame.lightTreeDepth > 0u) {
    let down = descend(point, normal, 0.0, i32(max(e.leaf, 0.0)), odds.total);
    probability = down.probability * down.share;
  }
  return probability;
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


// What `listedProbability` has to know of the point.
struct Odds {
  // The sum of the estimates of all emitters that are looked at one by one.
  total: f32,
  // Probability to take one out of the tree.
  tree: f32,
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
  let cosine = cosineTowards(e, toLight, grown, normal);
  // On the axis of a disc the first is exact, outside of a sphere the second.
  let square = select(max(distance2, e.area / (4.0 * pi)), distance2 + e.area / pi, isQuad);
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
    let sizeOfMesh = distance2 + e.area * (1.0 + 3.0 * alike) / (4.0 * pi);
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

override hasLightTree = false;

override hasQuadLights = false;

const quadKind = 1.0;

override hasSuns = false;

const directionalKind = 5.0;

// The largest from the normal to where the light may be, grown to its bounding sphere; `grown`: how far its far end is.
fn cosineTowards(e: Emitter, toLight: vec3f, grown: f32, normal: vec3f) -> f32 {
  let above = clamp((dot(normal, toLight) + e.reach) / grown, 0.0, 1.0);
  return select(above, 1.0, dot(normal, normal) == 0.0);
}

const pi = 3.14159265359;

// Meshes that shine, and so many lights that a tree chooses among them.
override hasMeshLamps = false;

override hasPointLights = false;

override hasSky = true;

const meshKind = 7.0;

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

fn tableTexel(column: u32, row: u32) -> vec4f {
  return textureSampleLevel(sceneTable, nearest, vec2f((f32(i32(column)) + 0.5) / tableWidth, (f32(i32(row)) + 0.5) * frame.rowHeight), 0.0);
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


@group(0) @binding(1) var sceneTable: texture_2d<f32>;

// How the scene table is read: table_texel.wesl; and, where `sampled`, geometry and texels. Its number is that of packed-scene/layout.ts, far from those of the inputs.
@group(0) @binding(15) var nearest: sampler;

// Written by `npm run shaders` from packed-scene/layout.ts. Do not edit.
// Texels in a row of the scene table.
const tableWidth = 20.0;

fn sineOf(cosine: vec4f) -> vec4f {
  return sqrt(max(1.0 - cosine * cosine, vec4f(0.0)));
}

// cos(max(a - b, 0)), of angles from 0 to pi.
fn cosineLess(cosA: vec4f, sinA: vec4f, cosB: vec4f, sinB: vec4f) -> vec4f {
  return select(cosA * cosB + sinA * sinB, vec4f(1.0), cosA > cosB);
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

const miss = 1e30;

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

// Of the sky, whichever emitter it is.
fn skySeen(direction: vec3f) -> FarLight {
  var far = FarLight(vec3f(0.0), 0.0);
  if (hasSky) {
    let seen = skyLight(direction);
    far = FarLight(seen.radiance, seen.pdf);
  }
  return far;
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
          let down = descend(point, normal, rest, noLeaf, total);
          choice.odds.tree = down.share;
          choice.index = select(chosen, down.emitter, down.taken);
          choice.probability = select(choice.probability * (1.0 - down.share), down.probability * down.share, down.taken);
        }
      }
    }
  }
  return choice;
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

struct EmitterChoice {
  index: u32,
  // 0: no light reaches the point.
  probability: f32,
  odds: Odds,
}


const noLeaf = -1;

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

// A ray that starts on no shape, without one to a light.
fn oneRay(origin: vec3f, direction: vec3f, number: u32) -> RayPair {
  return RayPair(origin, noShape, noTriangle, 0.0, true, direction, false, direction, false, -1.0, noShape, number);
}

const noInstance = 0xffffffffu;

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

// The first emitter of a shape and the triangle of it that was met -> how many emitters further on that triangle is.
fn emitterOfTriangle(e: Emitter, t: LeftTriangle) -> u32 {
  return (t.instance - u32(e.instance)) * u32(e.cosInner) + (t.triangle >> u32(e.radius));
}

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


// A ray knows where it comes from, so that a surface is never met by its own ray again: no offset along the normal,
// nothing that depends on the size of the scene.
const noShape = 0xffffffffu;

const noTriangle = LeftTriangle(noInstance, 0u);

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


// A triangle of an instance: such as a ray starts on; it is flat, so that no ray meets it again.
struct LeftTriangle {
  instance: u32,
  triangle: u32,
}


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

struct Bounds {
  // centre of the bounding sphere, eye-relative; of a plane: its unit normal
  center: vec3f,
  // of the bounding sphere; of a plane: dot(normal, p) of its points
  radius: f32,
}


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
  var waiting = noLeaf0;
  loop {
    if (!hasCutouts | ((waiting == noLeaf0) & isAmongInstances(current))) {
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
      let takes = (waiting == noLeaf0) & (current >= leaves);
      waiting = select(waiting, current, takes);
      current = select(current, unread, takes);
      if (waiting != noLeaf0) {
        let place = waiting & placeMask;
        waiting = waiting + 1u - (1u << countShift);
        waiting = select(waiting, noLeaf0, waiting < leaves);
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
        waiting = select(waiting, noLeaf0, blocks);
        current = select(current, ending, blocks);
      }
      if (((waiting == noLeaf0) & isAmongInstances(current)) | (hasCutouts & (doubted.instance != noInstance))) {
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
    let ended = (current == ending) & (waiting == noLeaf0);
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
const noLeaf0 = 0u;

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

// Random numbers as a pure function of what they are for. PCG-RXS-M-XS-32 as a hash: Jarzynski & Olano, "Hash Functions for
// GPU Rendering", JCGT 9(3), 2020.
fn pcg(x: u32) -> u32 {
  let s = x * 747796405u + 2891336453u;
  let w = ((s >> ((s >> 28u) + 4u)) ^ s) * 277803737u;
  return (w >> 22u) ^ w;
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

// Textures, and colours at the vertices of meshes.
override hasTextures = false;

override hasVertexMore = false;

// Of textures: normal maps, or grain, which need frames of tangents; colours at vertices or a second set of coordinates, which lie side by
// side; and such that are not repeated and looked up linearly.
override hasNormalMaps = false;

const hasTangents = 2u;

// Kinds of light, and more than one of them.
override hasSphereLights = true;

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


struct Ray {
  start: Start,
  direction: vec3f,
}


// On `shape`, for rays to the side that it is seen from: the inside of a solid or not.
fn onSurface(point: vec3f, shape: u32, seenFromInside: bool) -> Start {
  return Start(point, select(shape, noShape, seenFromInside), select(noShape, shape, seenFromInside), relativeTMin * length(point));
}

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

// Distances along the ray to shape i of that kind, or `miss`.
fn hitSphere(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  let t = intersectSphere(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin, i == ray.start.inside);
  return select(t, miss, i == ray.start.leaves);
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

fn hitQuad(i: u32, bounds: Bounds, ray: Ray) -> f32 {
  let extent = fetchExtent(i);
  let t = intersectQuad(ray.start.point, ray.direction, bounds.center, extent.a.xyz, extent.b.xyz, ray.start.tMin);
  return select(t, miss, i == ray.start.leaves);
}

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
  let phi = 2.0 * pi * u.y;
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


fn mixBits(x: u32) -> u32 {
  return mixBits2(vec2u(x)).x;
}

struct ChosenTriangle {
  place: u32,
  density: f32,
  // Two random numbers that are left.
  u: vec2f,
}


// A hash without the shift by a variable of pcg, which takes a software rasteriser longer than all the rest of it:
// C. Wellons, "Prospecting for Hash Functions", 2018, with the constants found by T. Ettinger.
fn mixBits2(x: vec2u) -> vec2u {
  var y = (x ^ (x >> vec2u(16u))) * 0x21f0aaadu;
  y = (y ^ (y >> vec2u(15u))) * 0x735a2d97u;
  return y ^ (y >> vec2u(15u));
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

fn environmentTexel(column: u32, row: u32) -> vec4f {
  let place = vec2f(f32(i32(column)), f32(i32(row))) + 0.5;
  return textureSampleLevel(environment, nearest, place / vec2f(textureDimensions(environment)), 0.0);
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
