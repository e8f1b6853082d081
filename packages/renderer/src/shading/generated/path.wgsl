// Linked from integrator/path/path_entries.wesl by `npm run shaders`. Do not edit.
struct Film {
  // RGB sums, and in alpha how many samples.
  @location(0) sums: vec4f,
  @location(1) squares: vec4f,
}


@fragment fn path(@builtin(position) fragment: vec4f) -> Film {
  let texel = vec2u(fragment.xy);
  var p = noPath();
  startPath(&p, frame.origin + texel, frame.sampleIndex);
  loop {
    extendPath(&p);
    if (isOver(p)) {
      break;
    }
  }
  addFarLight(&p);
  var film = Film(vec4f(0.0), vec4f(0.0));
  if (frame.sampleIndex > 0u) {
    film = Film(textureLoad(previousFilm, texel, 0), textureLoad(previousSquares, texel, 0));
  }
  return Film(film.sums + vec4f(p.radiance, 1.0), film.squares + vec4f(p.radiance * p.radiance, 0.0));
}

// A thread takes up its next sample as soon as a path is over, so that no lane waits for the longest path beside it. The samples of a
// pixel are dealt out to several threads of one workgroup. What they bring is summed up by another pass, `addHanded`: in groups, the
// threads' shares of each in a fixed order, and then group after group to the film. So the film is the same however many groups there are.
// First row, columns and rows of the part of the film that is traced.
@group(0) @binding(7) var<uniform> region: vec3u;

@group(0) @binding(8) var film: texture_storage_2d<rgba32float, write>;

@group(0) @binding(9) var filmSquares: texture_storage_2d<rgba32float, write>;

// Every sample of the region, those of a pixel side by side. Sums in the loop over paths, or after it, would take Windows' shader
// compiler (FXC) a fifth longer, and a GPU too.
@group(0) @binding(10) var<storage, read_write> handed: array<vec4f>;

// Where the first sample of all lies, or would, for a place in the region.
fn handedAt(inRegion: vec2u) -> u32 {
  return (inRegion.y * region.y + inRegion.x) * frame.sampleCount - frame.sampleIndex;
}

// A workgroup of 128 threads is a tile of pixels times the threads that share a pixel's samples. Those lie side by side, since their rays
// are alike. How many of each there are depends on how many samples there are to share: packed-scene/workgroup.ts.
@compute @workgroup_size(128) fn pathCompute(@builtin(workgroup_id) tileIndex: vec3u, @builtin(local_invocation_index) thread: u32) {
  let shares = frame.shares;
  let tile = frame.tile;
  let place = thread / shares;
  let inRegion = tileIndex.xy * tile + vec2u(place % tile.x, place / tile.x);
  let pixel = frame.origin + vec2u(inRegion.x, region.x + inRegion.y);
  let inside = all(inRegion < region.yz);
  let end = frame.sampleIndex + select(0u, frame.sampleCount, inside);
  let first = handedAt(inRegion);
  var index = frame.sampleIndex + thread % shares;
  // A path starts at one place only, or it would stand in the program twice.
  var p = noPath();
  loop {
    if (isOver(p)) {
      if (index >= end) {
        break;
      }
      startPath(&p, pixel, index);
    }
    extendPath(&p);
    if (isOver(p)) {
      addFarLight(&p);
      handed[first + index] = vec4f(p.radiance, 0.0);
      index += shares;
    }
  }
}

// Samples of a group, which begins at a multiple of it.
const group = 32u;

// Of each group, the samples of a thread of pathCompute one after the other, and then those sums.
@compute @workgroup_size(8, 8) fn addHanded(@builtin(global_invocation_id) inRegion: vec3u) {
  if (any(inRegion.xy >= region.yz)) {
    return;
  }
  let texel = vec2u(inRegion.x, region.x + inRegion.y);
  let first = handedAt(inRegion.xy);
  let shares = frame.shares;
  let end = frame.sampleIndex + frame.sampleCount;
  var sum = vec4f(0.0);
  var square = vec4f(0.0);
  if (frame.sampleIndex > 0u) {
    sum = textureLoad(previousFilm, texel, 0);
    square = textureLoad(previousSquares, texel, 0);
  }
  var begin = frame.sampleIndex;
  while (begin < end) {
    let groupEnd = min((begin / group + 1u) * group, end);
    var groupSum = vec3f(0.0);
    var groupSquare = vec3f(0.0);
    for (var share = 0u; share < shares; share++) {
      var ownSum = vec3f(0.0);
      var ownSquare = vec3f(0.0);
      for (var i = begin + (share + frame.sampleIndex - begin) % shares; i < groupEnd; i += shares) {
        let radiance = handed[first + i].xyz;
        ownSum += radiance;
        ownSquare += radiance * radiance;
      }
      groupSum += ownSum;
      groupSquare += ownSquare;
    }
    sum += vec4f(groupSum, 0.0);
    square += vec4f(groupSquare, 0.0);
    begin = groupEnd;
  }
  textureStore(film, texel, sum + vec4f(vec3f(0.0), f32(frame.sampleCount)));
  textureStore(filmSquares, texel, square);
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

@group(0) @binding(0) var<uniform> frame: Frame;

// And of what is infinitely far, sky and suns: asked for once a path is over. In the loop over its vertices it would stand in the way of
// those that go on, and Windows' shader compiler takes the longer for a loop the more is in it.
fn addFarLight(p: ptr<function, Path>) {
  if (hasSky | hasSuns) {
    if ((*p).escaped & (frame.emitterCount > 0u)) {
      addSkyAndSuns(p);
    }
  }
}

// The rays traced, and what they met taken up; the next two rays are ready, if any.
fn extendPath(p: ptr<function, Path>) {
  let hit = tracePair((*p).rays);
  (*p).radiance += select((*p).light, vec3f(0.0), hit.blocked);
  (*p).rays.lightDistance = -1.0;
  if ((*p).rays.goesOn) {
    meetSurface(p, hit);
  }
}

// Whether there is a ray left to trace.
fn isOver(p: Path) -> bool {
  return !p.rays.goesOn & (p.rays.lightDistance < 0.0);
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


fn meetSurface(p: ptr<function, Path>, hit: PairHit) {
  let m = meetingAt(p, hit);
  (*p).escaped = hit.shape == noShape;
  // Among meshes many paths end in the sky, side by side. A branch would cost other scenes more than it saves.
  
  scatter(p, hit, m, lightAt(p, hit, m));
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
  
  let wo = toLocal(basis, -rays.direction);
  if (hasGlass | hasTransmission) {
    let inside = isClear & !isThin(u32(surface.code)) & (wo.z < 0.0) & !escaped;
    (*p).throughput *= exp(-surface.absorption * select(0.0, hit.t, inside));
  }
  
  
  return Meeting(rays.point + hit.t * rays.direction, shape, surface, isClear, met.geometric, outward, basis, wo);
}

// A ray knows where it comes from, so that a surface is never met by its own ray again: no offset along the normal,
// nothing that depends on the size of the scene.
const noShape = 0xffffffffu;

// Triangle meshes, and such with shading normals of their own.
const hasMeshes = false;

fn scatter(p: ptr<function, Path>, hit: PairHit, m: Meeting, lit: Lit) {
  let rays = (*p).rays;
  let escaped = hit.shape == noShape;
  let light = lit.light;
  var hero = vec3f(1.0);
  
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
  let direction = toWorld(m.basis, bsdf.direction);
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

fn toLocal(b: Basis, v: vec3f) -> vec3f {
  return vec3f(dot(v, b.tangent), dot(v, b.bitangent), dot(v, b.normal));
}

override hasGlass = false;

const hasTransmission = false;

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

// An orthonormal basis about a unit normal: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
struct Basis {
  tangent: vec3f,
  bitangent: vec3f,
  normal: vec3f,
}


fn isThin(code: u32) -> bool {
  return hasGlass & ((code & 7u) == 7u);
}

// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994; f90 = 1.
fn schlick(f0: vec3f, cosine: f32) -> vec3f {
  let m = max(1.0 - cosine, 0.0);
  let m2 = m * m;
  return f0 + (1.0 - f0) * (m2 * m2 * m);
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
const hasLayers = false;

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

// In a program with layers every metallicRoughness material has some, if only such as change nothing: its facets stand in the program once.
fn isLayered(code: u32) -> bool {
  return hasLayers & isMetallicRoughness(code);
}

fn tableTexel(column: u32, row: u32) -> vec4f {
  return textureSampleLevel(sceneTable, nearest, vec2f((f32(i32(column)) + 0.5) / tableWidth, (f32(i32(row)) + 0.5) * frame.rowHeight), 0.0);
}

@group(0) @binding(1) var sceneTable: texture_2d<f32>;

// How the scene table is read: table_texel.wesl; and, where `sampled`, geometry and texels. Its number is that of packed-scene/layout.ts, far from those of the inputs.
@group(0) @binding(15) var nearest: sampler;

// Written by `npm run shaders` from packed-scene/layout.ts. Do not edit.
// Texels in a row of the scene table.
const tableWidth = 20.0;

fn isMetallicRoughness(code: u32) -> bool {
  return hasMetallicRoughness & (kindOf(code) == metallicRoughness);
}

override hasMetallicRoughness = false;

// These take Surface.code as an integer and not the struct: a compiler that copies structs at each call needs minutes.
fn kindOf(code: u32) -> u32 {
  return code & 3u;
}

const metallicRoughness = 1u;

const noInstance = 0xffffffffu;


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

// The GGX microfacet distribution with Smith's masking, isotropic, seen from +z: Walter et al., "Microfacet Models for
// Refraction through Rough Surfaces", EGSR 2007; Heitz, "Understanding the Masking-Shadowing Function", JCGT 2014.
// Written so that nothing is divided by a cosine: grazing directions need no special case.
// Narrower highlights are a mirror's: packed-scene/surface-values.ts.
const leastAlpha = 1e-3;

// Whether what reflects or refracts does so like a mirror.
fn isSmooth(code: u32) -> bool {
  return (code & 32u) != 0u;
}


// Images, and before them what materials use them for: packed-scene/pack-textures.ts. Read by texelRow.
@group(0) @binding(6) var<storage, read> texels: array<vec4u>;


// Triangles and the trees over them: packed-scene/pack-geometry.ts. Read by geometryRow.
@group(0) @binding(5) var<storage, read> geometry: array<vec4u>;

fn fetchBounds(i: u32) -> Bounds {
  let t0 = tableTexel(0u, i);
  return Bounds(t0.xyz, t0.w);
}

override hasQuads = false;

override hasBoxes = true;

// What a scene may ask of the path kernel. Whoever makes a program says what its scenes have (integrator/path/path-features.ts), and the
// compiler leaves the rest out: a software rasteriser runs both sides of every branch, Windows' shader compiler pays for every line,
// and a GPU for every register. On WebGL2 these become `const` in the GLSL. As they stand here they are what most scenes made of
// shapes and lights need: the program that a page compiles first.
// Kinds of shape, and boxes that do not lie along the axes.
override hasSpheres = true;

fn fetchExtent(i: u32) -> Extent {
  let t0 = tableTexel(1u, i);
  let t1 = tableTexel(2u, i);
  return Extent(t0.xyzw, t1.xyzw);
}

fn isPlane(i: u32) -> bool {
  return (i >= frame.shapeEnds.z) & (i < frame.shapeEnds.w);
}

struct Extent {
  // box: rotation from world to box as a quaternion (x, y, z, w); quad: reciprocal of its u edge
  a: vec4f,
  // box: half its size; quad: reciprocal of its v edge
  b: vec4f,
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

// The same where a pipeline may know that no box is turned.
fn turned(q: vec4f, v: vec3f) -> vec3f {
  var w = v;
  if (hasTurnedBoxes) {
    w = rotate(q, v);
  }
  return w;
}

fn turnedBack(q: vec4f, v: vec3f) -> vec3f {
  return turned(vec4f(-q.xyz, q.w), v);
}

fn isBox(i: u32) -> bool {
  return (i >= frame.shapeEnds.x) & (i < frame.shapeEnds.y);
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


override hasTurnedBoxes = true;

// v turned by the unit quaternion q, and back.
fn rotate(q: vec4f, v: vec3f) -> vec3f {
  let t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

fn isSphere(i: u32) -> bool {
  return i < frame.shapeEnds.x;
}

struct Bounds {
  // centre of the bounding sphere, eye-relative; of a plane: its unit normal
  center: vec3f,
  // of the bounding sphere; of a plane: dot(normal, p) of its points
  radius: f32,
}


fn isDielectric(code: u32) -> bool {
  return hasGlass & (kindOf(code) == dielectric);
}

const dielectric = 3u;

// The layers are those of layers/here.wesl. `hero`: layers/transmission.wesl; white where colours do not part.
fn outgoing(s: Surface, wo: vec3f, hero: vec3f) -> Outgoing {
  let code = u32(s.code);
  var o = Outgoing(wo, select(0.0, 1.0, isConductor(code) | isDielectric(code)), 1.0, 1.0, 1.0);
  
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
  
  return pair;
}

// Whether one of two directions away from a surface points into it and the other out of it.
fn crosses(geometric: vec3f, a: vec3f, b: vec3f) -> bool {
  return (dot(geometric, a) > 0.0) != (dot(geometric, b) > 0.0);
}

const miss = 1e30;

// Power heuristic, for one sample of each kind.
fn misWeight(own: f32, other: f32) -> f32 {
  let ratio = other / own;
  return 1.0 / (1.0 + ratio * ratio);
}

fn toWorld(b: Basis, v: vec3f) -> vec3f {
  return v.x * b.tangent + v.y * b.bitangent + v.z * b.normal;
}

fn max3(v: vec3f) -> f32 {
  return max(max(v.x, v.y), v.z);
}

const rouletteShare = 1.0 / 3.0;

// From this depth on paths end by chance, if they bring less than this share of their light: sooner, and the paths that are left
// weigh so much that the noise costs more than the rays that were saved.
const rouletteDepth = 5u;

// Light that must come from this side to count: none is excluded where light goes through.
fn litSideOf(m: Meeting) -> vec3f {
  return select(m.basis.normal, vec3f(0.0), m.isClear);
}

fn isFlat(i: u32) -> bool {
  return i >= frame.shapeEnds.y;
}

// Float rounding of a point grows with its distance from the eye, where all positions are relative to.
const relativeTMin = 1e-5;

// What is drawn next has a number, by which many others may be made that belong to it: hashed with whatever tells them apart.
fn numberOfNext(s: Sampler) -> u32 {
  return mixBits(mixBits((s.key + 1u) ^ s.salt ^ 0x85ebca6bu) + ((s.sample << 8u) | s.place));
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

// One more number of this sample, independent of all others: for choices that nothing is gained by stratifying.
fn nextHash(s: ptr<function, Sampler>) -> f32 {
  (*s).key = (*s).key + 1u;
  return unitFloat(mixBits(mixBits((*s).key ^ (*s).salt) + (((*s).sample * 256u) | (*s).place)));
}

// Uniform in [0, 1) with 24 bits.
fn unitFloat(h: u32) -> f32 {
  return f32(h >> 8u) * 5.9604644775390625e-8;
}

fn mixBits(x: u32) -> u32 {
  return mixBits2(vec2u(x)).x;
}

// A hash without the shift by a variable of pcg, which takes a software rasteriser longer than all the rest of it:
// C. Wellons, "Prospecting for Hash Functions", 2018, with the constants found by T. Ettinger.
fn mixBits2(x: vec2u) -> vec2u {
  var y = (x ^ (x >> vec2u(16u))) * 0x21f0aaadu;
  y = (y ^ (y >> vec2u(15u))) * 0x735a2d97u;
  return y ^ (y >> vec2u(15u));
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

override hasCompensation = false;

// Share of light that comes back from wo when every facet reflects all, but light that meets a second facet is lost. A minimax
// fit of the integral, 0.4 % off at most for |cos| >= 0.04: polynomials in alpha and in cosine / (cosine + alpha), since the
// loss near the horizon is a function of that ratio alone as alpha goes to 0.
fn singleScatteringAlbedo(cosine: f32, alpha: f32) -> f32 {
  let x = cosine / (cosine + alpha);
  let byAlpha = vec4f(0.887807, 0.309386, -0.270728, 0.0252433) + x * (vec4f(1.08526, -3.21434, -1.87718, 1.61195) + x * (vec4f(-5.18071, 10.7648, 6.30913, -8.09265) + x * (vec4f(7.80474, -12.7430, -24.1046, 25.2536) + x * vec4f(-3.60041, 4.60906, 23.1225, -22.9342))));
  let a2 = alpha * alpha;
  return min(dot(byAlpha, vec4f(1.0, alpha, a2, a2 * alpha)), 1.0);
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

// Matte surfaces: radiance leaves alike to all sides (Lambert, Photometria, 1760).
const invPi = 0.31830988618;


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
    
    let met = emitterAt(i, only);
    let density = shapePdf(met, p.rays.point, direction, hit.t, outward, hit.triangle.triangle);
    var probability = listedProbability(met, p.rays.point, p.litSide, p.odds);
    
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
      
    }
  }
  return choice;
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
  
  return pdf;
}

// With which chooseEmitter would have chosen this one there, which is not in the tree.
fn listedProbability(e: Emitter, point: vec3f, normal: vec3f, odds: Odds) -> f32 {
  var probability = f32(min(frame.emitterCount, 1u));
  if (hasManyLights) {
    if (frame.emitterCount > 1u) {
      probability = estimatedIrradiance(e, point, normal) / max(odds.total, 1e-37);
      
    }
  }
  return probability;
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


const pi = 3.14159265359;

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

// The first number of either group, the second, and the third.
fn firstOf(g: Groups) -> vec2f {
  return toUnit(scramble(g.index ^ g.shift, g.seedA));
}

fn secondOf(g: Groups) -> vec2f {
  return toUnit(scramble(pascal(g.index ^ timesW(g.shift)), g.seedB));
}

fn thirdOf(g: Groups) -> vec2f {
  return toUnit(scramble(pascalW2(g.index ^ timesW2(g.shift)), g.seedA ^ (g.seedB * 0x9e3779b1u)));
}

// Three numbers of each of the next two groups.
struct TwoPoints {
  first: vec3f,
  second: vec3f,
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

fn rotateBack(q: vec4f, v: vec3f) -> vec3f {
  return rotate(vec4f(-q.xyz, q.w), v);
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
  var s = EnvironmentSample(sampleCone(vec3f(0.0, 0.0, 1.0), 2.0, u).direction, white0);
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
const white0 = EnvironmentLight(vec3f(1.0), 0.25 / pi);

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


const noTriangle = LeftTriangle(noInstance, 0u);

override hasPlanes = true;

fn meetSphere(found: PairHit, p: RayPair, i: u32) -> PairHit {
  let b = fetchBounds(i);
  let own = i == p.shape;
  let t = intersectSphere(p.point, p.direction, b.center, b.radius, p.tMin, own & p.inwards);
  let lightT = intersectSphere(p.point, p.lightDirection, b.center, b.radius, p.tMin, own & p.lightInwards);
  return meet(found, p, i, vec2f(t, lightT));
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

fn meetBox(found: PairHit, p: RayPair, i: u32) -> PairHit {
  let b = fetchBounds(i);
  let e = fetchExtent(i);
  let own = i == p.shape;
  let origin = turned(e.a, p.point - b.center);
  let t = intersectBox(origin, turned(e.a, p.direction), e.b.xyz, p.tMin, own & p.inwards);
  let lightT = intersectBox(origin, turned(e.a, p.lightDirection), e.b.xyz, p.tMin, own & p.lightInwards);
  return meet(found, p, i, vec2f(t, lightT));
}

fn intersectBox(origin: vec3f, direction: vec3f, halfSize: vec3f, tMin: f32, startsInside: bool) -> f32 {
  let s = boxSlabs(origin, direction, halfSize);
  let t = select(s.far, s.near, s.near > tMin);
  // From inside the far side cannot be missed, whatever rounding says of a start on an edge.
  return select(select(miss, t, (s.near <= s.far) & (t > tMin)), max(s.far, 0.0), startsInside);
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

// References: encode-wide-bvh.ts. Below `instances` those of nodes, from `leaves` on of leaves.
const instances = 0x80000000u;

// Random numbers as a pure function of what they are for. PCG-RXS-M-XS-32 as a hash: Jarzynski & Olano, "Hash Functions for
// GPU Rendering", JCGT 9(3), 2020.
fn pcg(x: u32) -> u32 {
  let s = x * 747796405u + 2891336453u;
  let w = ((s >> ((s >> 28u) + 4u)) ^ s) * 277803737u;
  return (w >> 22u) ^ w;
}

@group(0) @binding(2) var previousFilm: texture_2d<f32>;

@group(0) @binding(3) var previousSquares: texture_2d<f32>;

fn startSampler(pixel: vec2u, sampleIndex: u32, seed: u32) -> Sampler {
  // Independent numbers come about when each sample of each pixel has its own sequence, and only the first point of it is used.
  let independent = frame.independent != 0u;
  let hash = pixelHash(select(pixel >> vec2u(4u), pixel, independent), select(sampleIndex >> 16u, sampleIndex, independent), seed);
  let place = spread0(pixel.x & 15u) | (spread0(pixel.y & 15u) * 2u);
  let digits = select(reversed(vec2u(sampleIndex & 0xffffu, place * 256u)), vec2u(0u), independent);
  return Sampler(hash, mixBits(hash ^ 0x6a09e667u), digits.x, digits.y);
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

fn pixelHash(pixel: vec2u, sampleIndex: u32, seed: u32) -> u32 {
  return pcg(pixel.x + pcg(pixel.y + pcg(sampleIndex + pcg(seed))));
}

// Bits 0 to 3 of x to the even places.
fn spread0(x: u32) -> u32 {
  let y = (x | (x * 4u)) & 0x33u;
  return (y | (y * 2u)) & 0x55u;
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

fn skipGroup(s: ptr<function, Sampler>) {
  (*s).key = (*s).key + 1u;
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
      let longitude = pi0 * x;
      let latitude = 0.5 * pi0 * y;
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
  let angle = select(0.5 * pi0 - 0.25 * pi0 * ratio, 0.25 * pi0 * ratio, wide);
  return radius * vec2f(cos(angle), sin(angle));
}

const pi0 = 3.14159265358979;

override hasOtherProjections = false;

struct CameraRay {
  origin: vec3f,
  direction: vec3f,
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
  return pi * dot(chord, chord) < e.area;
}

fn directionalPdf(e: Emitter, direction: vec3f) -> f32 {
  return select(0.0, 1.0 / max(e.area, 1e-31), isOnDisc(e, direction));
}

// What a ray that escapes in this direction sees, and the density with which sampleSky gives it.
fn skyLight(direction: vec3f) -> EnvironmentLight {
  var light = white0;
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
