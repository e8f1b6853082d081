// Linked from bench/trace_rays.wesl by `npm run shaders`. Do not edit.
// Origin and direction of each.
@group(0) @binding(7) var<storage, read> rays: array<vec4f>;

// Distance and the triangle's place: 1e30 and 0xffffffff where it meets none.
@group(0) @binding(8) var<storage, read_write> hits: array<vec2f>;

// A thread traces several rays, as it does in a path; those beside it trace their neighbours.
const raysOfThread = 4u;

@compute @workgroup_size(64) fn traceRays(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) thread: u32) {
  let first = (group.y * groups.x + group.x) * 64u * raysOfThread + thread;
  for (var k = 0u; k < raysOfThread; k++) {
    let i = first + k * 64u;
    if (i >= arrayLength(&hits)) {
      return;
    }
    let direction = rays[2u * i + 1u].xyz;
    let hit = traverse(MeshRays(rays[2u * i].xyz, direction, direction, 0.0, 1e30, -1.0, 0u), LeftTriangle(noInstance, 0u));
    hits[i] = vec2f(hit.t, bitcast<f32>(select(hit.triangle, noInstance, hit.instance == noInstance)));
  }
}

fn traverse(rays: MeshRays, left: LeftTriangle) -> MeshHit {
  var found = MeshHit(rays.most, noInstance, 0u, vec2f(0.0), false);
  var toLight = !(rays.most > 0.0);
  // Of the present ray.
  var most = select(rays.most, rays.lightMost, toLight);
  var instance = noInstance;
  var nodes = 0u;
  var triangles = 0u;
  // Of the present instance: its cover, and which of its triangles no ray meets.
  var cover = 0u;
  var own = placeMask;
  var slabs = SlabRay(vec3f(0.0), vec3f(0.0), vec3u(0u));
  var ray = MeshRay(vec3f(0.0), 0u, vec3f(0.0));
  // A triangle that may not be there.
  var doubted = found;
  // The only instance needs no tree above it, and no way back.
  let alone = frame.instanceCount == 1u;
  let first = select(beginning, instances, alone);
  if ((frame.instanceCount == 0u) | !(most > 0.0)) {
    return found;
  }
  stack[0] = ending;
  var top = 1u;
  var current = first;
  // A leaf waits while the ray goes on to the next node, so that each turn has work for both.
  var waiting = noLeaf;
  // Once, and once more for each triangle that may not be there: it is looked at when all rays side by side have come as far.
  loop {
    loop {
      if (current < instances) {
        let node = nodes + current * nodeRows;
        let r = geometryRow(node + childrenRow);
        let t = enterChildren(node, slabs, most);
        // Farthest first onto the stack: a sorting network of five exchanges.
        let a = t.x < t.z;
        let b = t.y < t.w;
        let t0 = select(vec2f(t.x, t.z), vec2f(t.z, t.x), a);
        let r0 = select(vec2u(r.x, r.z), vec2u(r.z, r.x), a);
        let t1 = select(vec2f(t.y, t.w), vec2f(t.w, t.y), b);
        let r1 = select(vec2u(r.y, r.w), vec2u(r.w, r.y), b);
        let c = t0.x < t1.x;
        let d = t0.y < t1.y;
        let ta = select(vec2f(t0.x, t1.x), vec2f(t1.x, t0.x), c);
        let ra = select(vec2u(r0.x, r1.x), vec2u(r1.x, r0.x), c);
        let tb = select(vec2f(t0.y, t1.y), vec2f(t1.y, t0.y), d);
        let rb = select(vec2u(r0.y, r1.y), vec2u(r1.y, r0.y), d);
        let e = ta.y < tb.x;
        let tm = select(vec2f(ta.y, tb.x), vec2f(tb.x, ta.y), e);
        let rm = select(vec2u(ra.y, rb.x), vec2u(rb.x, ra.y), e);
        if (ta.x < 1e30) {
          stack[top] = ra.x;
          top++;
        }
        if (tm.x < 1e30) {
          stack[top] = rm.x;
          top++;
        }
        if (tm.y < 1e30) {
          stack[top] = rm.y;
          top++;
        }
        current = rb.y;
        if (tb.y >= 1e30) {
          top--;
          current = stack[top];
        }
      }
      if ((waiting == noLeaf) & (current >= leaves)) {
        waiting = current;
        top--;
        current = stack[top];
      }
      if (waiting != noLeaf) {
        // One triangle a turn, so that lanes with short leaves do not wait.
        let place = waiting & placeMask;
        waiting = waiting + 1u - (1u << countShift);
        waiting = select(waiting, noLeaf, waiting < leaves);
        let hit = crossTriangle(ray, fetchTriangle(triangles + place * triangleRows));
        var nearer = hit.within & (hit.depth > rays.least * hit.sum) & (hit.depth < most * hit.sum) & (place != own);
        if (hasOneSided) {
          nearer = nearer & (hit.front | ((cover & isOneSided) == 0u));
        }
        if (nearer) {
          let inverse = 1.0 / hit.sum;
          let met = MeshHit(hit.depth * inverse, instance, place, hit.weights * inverse, false);
          if (hasCutouts) {
            if ((cover & coverRow) != 0u) {
              doubted = met;
              break;
            }
          }
          if (toLight) {
            found.blocked = true;
            break;
          }
          most = met.t;
          found = met;
        }
      } else if (current >= instances) {
        if (current == ending) {
          if (toLight | !(rays.lightMost > 0.0)) {
            break;
          }
          toLight = true;
          most = rays.lightMost;
          top = 1u;
          current = first;
        }
        // Into an instance, or back into the world.
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
        // The root of either tree, or what else there is to do in the world.
        let goesOn = current == leaving;
        current = 0u;
        if (goesOn) {
          top--;
          current = stack[top];
        }
      }
    }
    if (!hasCutouts) {
      break;
    }
    if (doubted.instance == noInstance) {
      break;
    }
    let there = isThere(doubted.instance, doubted.triangle, doubted.weights, rays.number + u32(toLight));
    if (there & toLight) {
      found.blocked = true;
      break;
    }
    if (there) {
      most = doubted.t;
      found = doubted;
    }
    doubted.instance = noInstance;
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


// A triangle of an instance: such as a ray starts on; it is flat, so that no ray meets it again.
struct LeftTriangle {
  instance: u32,
  triangle: u32,
}


const noInstance = 0xffffffffu;

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


@group(0) @binding(0) var<uniform> frame: Frame;

// Among the instances, on the stack: a ray begins, in the world; here it leaves an instance; it ends.
const beginning = 0x8ffffffdu;

// References: encode-wide-bvh.ts. Below `instances` those of nodes, from `leaves` on of leaves.
const instances = 0x80000000u;

// pack-geometry.ts refuses trees that need more. At the bottom lies `ending`.
var<private> stack: array<u32, 64>;

const ending = 0x8fffffffu;

// A leaf that is none.
const noLeaf = 0u;

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

const leaves = 0x90000000u;

// Rows of a node; from the rows of least to those of greatest places; and where the references are.
const nodeRows = 7u;

fn geometryRow(i: u32) -> vec4u {
  return geometry[i];
}

const childrenRow = 6u;

// Where the ray enters each child, 1e30 where it does not.
fn enterChildren(node: u32, r: SlabRay, t: f32) -> vec4f {
  // The row of the far planes is the other one of the two.
  let far = vec3u(leastToGreatest) + vec3u(0u, 2u, 4u) - r.near;
  let near4 = larger(larger(planes(node + r.near.x, r.inverse.x, r.offset.x), planes(node + r.near.y, r.inverse.y, r.offset.y)), larger(planes(node + r.near.z, r.inverse.z, r.offset.z), vec4f(0.0)));
  let far4 = smaller(smaller(planes(node + far.x, r.inverse.x, r.offset.x), planes(node + far.y, r.inverse.y, r.offset.y)), planes(node + far.z, r.inverse.z, r.offset.z));
  return select(vec4f(1e30), near4, near4 <= smaller(far4 * slabRounding, vec4f(t)));
}

// Triangles and the trees over them: packed-scene/pack-geometry.ts. Read by geometryRow.
@group(0) @binding(5) var<storage, read> geometry: array<vec4u>;

const leastToGreatest = 3u;

// Of floats above 0 the order is that of their bits, and all below 0 are less; where WGSL's own `max` and `min` are asked for what may be
// no number, a software rasteriser looks for that, with some twenty operations. What comes out below 0 is not exact, and does not count.
fn larger(a: vec4f, b: vec4f) -> vec4f {
  return max(a, b);
}

fn planes(row: u32, inverse: f32, offset: f32) -> vec4f {
  return bitcast<vec4f>(geometryRow(row)) * inverse + offset;
}

fn smaller(a: vec4f, b: vec4f) -> vec4f {
  return min(a, b);
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

override hasCutouts = false;

const coverRow = 2147483647u;

// The axis comes last.
fn turnedTo(axis: u32, v: vec3f) -> vec3f {
  return select(select(v, v.zxy, axis == 1u), v.yzx, axis == 0u);
}

fn edge(a: vec2f, b: vec2f) -> f32 {
  let p = a.x * b.y;
  let q = a.y * b.x;
  return fma(a.x, b.y, -q) - fma(a.y, b.x, -p);
}

// No two of them on different sides. A software rasteriser has more to do for WGSL's `min` and `max` than for all these comparisons.
fn isWithin(u: f32, v: f32, w: f32) -> bool {
  return (min(min(u, v), w) >= 0.0) | (max(max(u, v), w) <= 0.0);
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

fn fetchInstance(row: u32) -> Instance {
  let r0 = geometryRow(row + 0u);
  let r1 = geometryRow(row + 1u);
  let r2 = geometryRow(row + 2u);
  let r3 = geometryRow(row + 3u);
  let r4 = geometryRow(row + 4u);
  return Instance(bitcast<vec4f>(r0.xyzw), bitcast<vec4f>(r1.xyzw), bitcast<vec4f>(r2.xyzw), r3.x, r3.y, r3.z, r3.w, r4.x, r4.y, r4.z, r4.w);
}

const instanceRows = 5u;

const leaving = 0x8ffffffeu;

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
  return texels[i];
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


// Images, and before them what materials use them for: packed-scene/pack-textures.ts. Read by texelRow.
@group(0) @binding(6) var<storage, read> texels: array<vec4u>;

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
