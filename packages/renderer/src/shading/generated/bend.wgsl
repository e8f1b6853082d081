// Linked from shading/mesh/bend.wesl by `npm run shaders`. Do not edit.
// References: encode-wide-bvh.ts. From `leaves` on those of leaves.
const leaves = 0x80000000u;

const countShift = 28u;

const placeMask = 0x0fffffffu;

// Of a workgroup that does all there is to do of a mesh: as many as the device allows, for all wait until the last is done.
override manyThreads = 256u;

// What a workgroup is to do. Those too many, which fill up the last row, get nothing.
fn shareOf(group: vec3u, groups: vec3u) -> Share {
  let i = group.x + group.y * groups.x;
  var share = fetchShare(dispatched.x + min(i, dispatched.y - 1u) * shareWords);
  share.end = select(0u, share.end, i < dispatched.y);
  return share;
}

fn restFloat(at: u32) -> f32 {
  return bitcast<f32>(plan[at]);
}

fn restVector(at: u32) -> vec3f {
  return vec3f(restFloat(at), restFloat(at + 1u), restFloat(at + 2u));
}

fn poseVector(row: u32) -> vec4f {
  return bitcast<vec4f>(poses[row]);
}

// A vertex: its place, normal and tangent.
struct Bent {
  place: vec3f,
  normal: vec3f,
  tangent: vec3f,
}


// With its morph targets added.
fn morphed(mesh: BentMesh, vertex: u32) -> Bent {
  var bent = Bent(restVector(mesh.positions + 3u * vertex), vec3f(0.0), vec3f(0.0));
  if (mesh.normals != none) {
    bent.normal = restVector(mesh.normals + 3u * vertex);
  }
  if (mesh.tangents != none) {
    bent.tangent = restVector(mesh.tangents + 4u * vertex);
  }
  let count = fetchBentPose(mesh.pose).targets;
  for (var k = 0u; k < count; k++) {
    let pairs = poses[mesh.pose + 1u + k / 2u];
    let pair = select(pairs.xy, pairs.zw, (k & 1u) == 1u);
    let deltas = mesh.targets + 3u * pair.x;
    let weight = bitcast<f32>(pair.y);
    if (plan[deltas] != none) {
      bent.place += weight * restVector(plan[deltas] + 3u * vertex);
    }
    if (plan[deltas + 1u] != none) {
      bent.normal += weight * restVector(plan[deltas + 1u] + 3u * vertex);
    }
    if (plan[deltas + 2u] != none) {
      bent.tangent += weight * restVector(plan[deltas + 2u] + 3u * vertex);
    }
  }
  return bent;
}

// Rows of a matrix: x is dot(x, (p, 1)).
struct Rows {
  x: vec4f,
  y: vec4f,
  z: vec4f,
}


fn jointRows(mesh: BentMesh, joint: u32) -> Rows {
  let row = mesh.matrices + 3u * joint;
  return Rows(poseVector(row), poseVector(row + 1u), poseVector(row + 2u));
}

fn addRows(mix: Rows, m: Rows, weight: f32) -> Rows {
  // What weighs nothing may be no number.
  let counts = weight != 0.0;
  let none = vec4f(0.0);
  return Rows(mix.x + select(none, weight * m.x, counts), mix.y + select(none, weight * m.y, counts), mix.z + select(none, weight * m.z, counts));
}

// The mix of the joints' matrices, four at a time: loads that do not wait for one another are under way together.
fn mixOf(mesh: BentMesh, vertex: u32) -> Rows {
  var mix = Rows(vec4f(0.0), vec4f(0.0), vec4f(0.0));
  let first = vertex * mesh.influences;
  for (var k = first; k < first + mesh.influences; k += 4u) {
    let at = mesh.weights + k;
    let weights = vec4f(restFloat(at), restFloat(at + 1u), restFloat(at + 2u), restFloat(at + 3u));
    let ab = plan[mesh.joints + k / 2u];
    let cd = plan[mesh.joints + k / 2u + 1u];
    let a = jointRows(mesh, ab & 0xffffu);
    let b = jointRows(mesh, ab >> 16u);
    let c = jointRows(mesh, cd & 0xffffu);
    let d = jointRows(mesh, cd >> 16u);
    mix = addRows(addRows(addRows(addRows(mix, a, weights.x), b, weights.y), c, weights.z), d, weights.w);
  }
  return mix;
}

fn directionBy(m: Rows, d: vec3f) -> vec3f {
  return vec3f(dot(m.x.xyz, d), dot(m.y.xyz, d), dot(m.z.xyz, d));
}

// Normals go by the cofactors, and outward ones stay so in a mirror. The mix may be as small as numbers get, so it is scaled first.
fn normalBy(m: Rows, n: vec3f) -> vec3f {
  let most = max(max(abs(m.x.xyz), abs(m.y.xyz)), abs(m.z.xyz));
  let size = max(max(most.x, most.y), max(most.z, 1e-37));
  let a = m.x.xyz / size;
  let b = m.y.xyz / size;
  let c = m.z.xyz / size;
  let across = cross(b, c);
  let turned = vec3f(dot(across, n), dot(cross(c, a), n), dot(cross(a, b), n));
  return select(turned, -turned, dot(a, across) < 0.0);
}

// As octahedral.wesl reads it and packed-scene/octahedral.ts has it; of any length.
fn toOctahedral(v: vec3f) -> u32 {
  let size = abs(v.x) + abs(v.y) + abs(v.z);
  let p = select(vec2f(0.0), v.xy / max(size, 1e-37), size > 0.0);
  let folded = (1.0 - abs(p.yx)) * select(vec2f(1.0), vec2f(-1.0), v.xy < vec2f(0.0));
  let code = vec2u(floor(select(p, folded, v.z < 0.0) * 32767.0 + 32767.5));
  return code.x | (code.y << 16u);
}

const leftHanded = 0x10000u;

fn writeVertex(mesh: BentMesh, vertex: u32, bent: Bent) {
  let at = mesh.places + 3u * vertex;
  places[at] = bent.place.x;
  places[at + 1u] = bent.place.y;
  places[at + 2u] = bent.place.z;
  let row = mesh.vertices + vertex * mesh.vertexWords;
  if (mesh.normals != none) {
    geometry[row + normalWord] = toOctahedral(bent.normal);
  }
  if (mesh.tangents != none) {
    let hand = select(0u, leftHanded, restFloat(mesh.tangents + 4u * vertex + 3u) < 0.0);
    geometry[row + tangentWord] = (toOctahedral(bent.tangent) & ~leftHanded) | hand;
  }
}

fn bendVertex(mesh: BentMesh, vertex: u32) {
  var bent = morphed(mesh, vertex);
  if (mesh.influences > 0u) {
    let mix = mixOf(mesh, vertex);
    let uneven = fetchBentPose(mesh.pose).isUneven != 0u;
    let p = vec4f(bent.place, 1.0);
    bent.place = vec3f(dot(mix.x, p), dot(mix.y, p), dot(mix.z, p));
    if (uneven) {
      bent.normal = normalBy(mix, bent.normal);
    } else {
      bent.normal = directionBy(mix, bent.normal);
    }
    bent.tangent = directionBy(mix, bent.tangent);
  }
  writeVertex(mesh, vertex, bent);
}

@compute @workgroup_size(64) fn bendVertices(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) thread: u32) {
  let share = shareOf(group, groups);
  let vertex = share.first + thread;
  if (vertex < share.end) {
    bendVertex(fetchBentMesh(share.mesh), vertex);
  }
}

struct Box {
  least: vec3f,
  greatest: vec3f,
}


const nothing = 1e30;

// `slot`: of which node the word, and which of its children.
fn slotWord(mesh: BentMesh, slot: u32) -> u32 {
  return mesh.nodes + (slot >> 2u) * nodeWords + (slot & 3u);
}

fn readBox(at: u32) -> Box {
  return Box(vec3f(bitcast<f32>(geometry[at + leastWord]), bitcast<f32>(geometry[at + leastWord + 4u]), bitcast<f32>(geometry[at + leastWord + 8u])), vec3f(bitcast<f32>(geometry[at + greatestWord]), bitcast<f32>(geometry[at + greatestWord + 4u]), bitcast<f32>(geometry[at + greatestWord + 8u])));
}

fn writeBox(at: u32, box: Box) {
  geometry[at + leastWord] = bitcast<u32>(box.least.x);
  geometry[at + leastWord + 4u] = bitcast<u32>(box.least.y);
  geometry[at + leastWord + 8u] = bitcast<u32>(box.least.z);
  geometry[at + greatestWord] = bitcast<u32>(box.greatest.x);
  geometry[at + greatestWord + 4u] = bitcast<u32>(box.greatest.y);
  geometry[at + greatestWord + 8u] = bitcast<u32>(box.greatest.z);
}

// The box about all children of a node. Where there is no child stands a box that ends before it begins.
fn boxOfNode(node: u32) -> Box {
  var box = readBox(node);
  for (var k = 1u; k < 4u; k++) {
    let child = readBox(node + k);
    box = Box(min(box.least, child.least), max(box.greatest, child.greatest));
  }
  return box;
}

fn placeOf(mesh: BentMesh, number: u32) -> vec3f {
  let at = mesh.places + 3u * number;
  return vec3f(places[at], places[at + 1u], places[at + 2u]);
}

fn writeCorner(at: u32, p: vec3f) {
  geometry[at] = bitcast<u32>(p.x);
  geometry[at + 1u] = bitcast<u32>(p.y);
  geometry[at + 2u] = bitcast<u32>(p.z);
}

// A child of a node: of which slot, and the reference there.
fn childAt(mesh: BentMesh, i: u32) -> vec2u {
  let at = mesh.children + 2u * i;
  return vec2u(plan[at], plan[at + 1u]);
}

// The corners of a leaf's triangles, and the box about them. All that is loaded of a triangle comes before what is written.
fn fitLeaf(mesh: BentMesh, leaf: vec2u) {
  let first = mesh.triangles + (leaf.y & placeMask) * triangleWords;
  let end = first + ((leaf.y >> countShift) & 7u) * triangleWords;
  var box = Box(vec3f(nothing), vec3f(-nothing));
  for (var at = first; at < end; at += triangleWords) {
    let numbers = vec3u(geometry[at + numberWord], geometry[at + cornerWords + numberWord], geometry[at + 2u * cornerWords + numberWord]);
    let a = placeOf(mesh, numbers.x);
    let b = placeOf(mesh, numbers.y);
    let c = placeOf(mesh, numbers.z);
    writeCorner(at, a);
    writeCorner(at + cornerWords, b);
    writeCorner(at + 2u * cornerWords, c);
    box = Box(min(box.least, min(min(a, b), c)), max(box.greatest, max(max(a, b), c)));
  }
  let padding = bitcast<f32>(fetchBentPose(mesh.pose).padding);
  writeBox(slotWord(mesh, leaf.x), Box(box.least - padding, box.greatest + padding));
}

@compute @workgroup_size(64) fn fitLeaves(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) thread: u32) {
  let share = shareOf(group, groups);
  let i = share.first + thread;
  if (i >= share.end) {
    return;
  }
  let mesh = fetchBentMesh(share.mesh);
  fitLeaf(mesh, childAt(mesh, i));
}

// A child that is a node. What lies in it is padded already.
fn fitInner(mesh: BentMesh, child: vec2u) {
  writeBox(slotWord(mesh, child.x), boxOfNode(mesh.nodes + child.y * nodeWords));
}

// One level, by as many workgroups as it takes.
@compute @workgroup_size(64) fn fitLevel(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) thread: u32) {
  let share = shareOf(group, groups);
  let i = share.first + thread;
  if (i >= share.end) {
    return;
  }
  let mesh = fetchBentMesh(share.mesh);
  fitInner(mesh, childAt(mesh, i));
}

// Levels up to but not including `end`, by one workgroup, which alone has to wait in between. What does not depend on the level below is
// loaded before.
fn fitLevelsOf(mesh: BentMesh, first: u32, end: u32, thread: u32) {
  var begin = plan[mesh.levels + first];
  var last = plan[mesh.levels + first + 1u];
  var child = childAt(mesh, begin + thread);
  for (var level = first; level < end; level++) {
    let nextLast = plan[mesh.levels + level + 2u];
    let next = childAt(mesh, last + thread);
    if (begin + thread < last) {
      fitInner(mesh, child);
    }
    for (var i = begin + thread + manyThreads; i < last; i += manyThreads) {
      fitInner(mesh, childAt(mesh, i));
    }
    begin = last;
    last = nextLast;
    child = next;
    storageBarrier();
  }
}

// All levels from one on up to the root, which have few nodes each.
@compute @workgroup_size(manyThreads) fn fitLevels(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) thread: u32) {
  let share = shareOf(group, groups);
  fitLevelsOf(fetchBentMesh(share.mesh), share.first, share.end, thread);
}

// All of a small mesh.
@compute @workgroup_size(manyThreads) fn bendMesh(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) thread: u32) {
  let share = shareOf(group, groups);
  let mesh = fetchBentMesh(share.mesh);
  let vertices = select(0u, mesh.count, share.end > 0u);
  for (var vertex = share.first + thread; vertex < vertices; vertex += manyThreads) {
    bendVertex(mesh, vertex);
  }
  storageBarrier();
  let ends = select(0u, plan[mesh.levels + 1u], share.end > 0u);
  for (var i = thread; i < ends; i += manyThreads) {
    fitLeaf(mesh, childAt(mesh, i));
  }
  storageBarrier();
  // One more than there are levels, so that a share is never empty.
  fitLevelsOf(mesh, 1u, max(share.end, 1u) - 1u, thread);
}

// What bvh.ts takes for the cost of a node, 1, and of a triangle.
const triangleCost = 1.25;

var<workgroup> sums: array<f32, manyThreads>;

// Half the surface without the padding: packed-scene/tree-cost.ts.
fn halfArea(box: Box, padding: f32) -> f32 {
  let d = max(box.greatest - box.least - 2.5 * padding, vec3f(0.0));
  return d.x * (d.y + d.z) + d.y * d.z;
}

// What the tree costs by the surface area heuristic.
@compute @workgroup_size(manyThreads) fn weighTree(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) thread: u32) {
  let share = shareOf(group, groups);
  let mesh = fetchBentMesh(share.mesh);
  let padding = bitcast<f32>(fetchBentPose(mesh.pose).padding);
  var sum = 0.0;
  for (var slot = thread; slot < mesh.slots; slot += manyThreads) {
    let at = slotWord(mesh, slot);
    let reference = geometry[at + childrenWord];
    let inLeaf = f32((reference >> countShift) & 7u) * triangleCost;
    sum += halfArea(readBox(at), padding) * select(1.0, inLeaf, reference >= leaves);
  }
  sums[thread] = sum;
  workgroupBarrier();
  for (var half = manyThreads / 2u; half > 0u; half /= 2u) {
    if (thread < half) {
      sums[thread] += sums[thread + half];
    }
    workgroupBarrier();
  }
  if ((thread == 0u) & (share.end > 0u)) {
    let all = halfArea(boxOfNode(mesh.nodes), padding);
    places[mesh.cost] = select(0.0, sums[0] / all, sums[0] > 0.0);
  }
}

fn fetchShare(at: u32) -> Share {
  return Share(plan[at + 0u], plan[at + 1u], plan[at + 2u]);
}

// What the workgroups of this dispatch do: the word of the first one's share, and how many there are.
@group(0) @binding(4) var<uniform> dispatched: vec4u;

const shareWords = 4u;

struct Share {
  // word of the record
  mesh: u32,
  // vertex, child or level where it begins
  first: u32,
  // and before which it ends
  end: u32,
}


// packed-scene/bent-layout.ts has what the plan and the poses hold. Rows of poses are loaded whole: a vertex wants a dozen.
@group(0) @binding(1) var<storage, read> plan: array<u32>;

@group(0) @binding(2) var<storage, read> poses: array<vec4u>;

const none = 4294967295u;

fn fetchBentPose(at: u32) -> BentPose {
  return BentPose(poses[at].x, poses[at].y, poses[at].z, poses[at].w);
}

struct BentMesh {
  // of its vertices
  count: u32,
  // word of the plan: x, y, z of each vertex at rest
  positions: u32,
  // likewise; NONE: the mesh has none
  normals: u32,
  // x, y, z and handedness; NONE: the mesh has none
  tangents: u32,
  // joints of a vertex; 0: none moves it
  influences: u32,
  // word of the plan: numbers of joints, two in a word, those of a vertex side by side: four or eight
  joints: u32,
  // word of the plan: as many floats
  weights: u32,
  // word of the plan: for each morph target where its positions, normals and tangents begin, or NONE; all have x, y, z
  targets: u32,
  // row of the poses: BENT_POSE
  pose: u32,
  // row of the poses: three rows a joint, as the matrix has them
  matrices: u32,
  // word of the places: x, y, z of each vertex as it is bent
  places: u32,
  // word of the geometry: the root of the tree
  nodes: u32,
  // word of the geometry: the first triangle
  triangles: u32,
  // word of the geometry: the first vertex
  vertices: u32,
  // of each vertex
  vertexWords: u32,
  // children of all nodes, four each
  slots: u32,
  // word of the plan: two words each, its slot and the reference there: leaves first, then level by level
  children: u32,
  // word of the plan: where each level begins among `children`, and the last one ends
  levels: u32,
  // word of the places: what the tree costs, once it has been weighed
  cost: u32,
}


struct BentPose {
  // float: what boxes grow by
  padding: u32,
  // 1: a joint stretches or mirrors, and normals go by cofactors
  isUneven: u32,
  // morph targets that count
  targets: u32,
  // 0
  none: u32,
}


// Of the bent vertices.
@group(0) @binding(3) var<storage, read_write> places: array<f32>;

// What the kernels of bend.wesl read and write. What is written is words, so that no write touches a neighbour's.
// Nodes, triangles and vertices of all meshes, as paths read them.
@group(0) @binding(0) var<storage, read_write> geometry: array<u32>;

const normalWord = 0u;

const tangentWord = 1u;

fn fetchBentMesh(at: u32) -> BentMesh {
  return BentMesh(plan[at + 0u], plan[at + 1u], plan[at + 2u], plan[at + 3u], plan[at + 4u], plan[at + 5u], plan[at + 6u], plan[at + 7u], plan[at + 8u], plan[at + 9u], plan[at + 10u], plan[at + 11u], plan[at + 12u], plan[at + 13u], plan[at + 14u], plan[at + 15u], plan[at + 16u], plan[at + 17u], plan[at + 18u]);
}

const nodeWords = 28u;

const leastWord = 0u;

const greatestWord = 12u;

const triangleWords = 12u;

const numberWord = 3u;

const cornerWords = 4u;

const childrenWord = 24u;
