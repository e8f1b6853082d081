// Linked from tests/texture-probe.wesl by `npm run shaders`. Do not edit.
@group(0) @binding(1) var questions: texture_2d<f32>;

@fragment fn textureProbe(@builtin(position) fragment: vec4f) -> @location(0) vec4f {
  let question = textureLoad(questions, vec2u(fragment.xy), 0);
  return lookUp(fetchTextureUse(u32(question.z)), question.xy);
}

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

fn fetchTextureUse(row: u32) -> TextureUse {
  let r0 = texelRow(row + 0u);
  let r1 = texelRow(row + 1u);
  let r2 = texelRow(row + 2u);
  return TextureUse(bitcast<vec3f>(r0.xyz), r0.w, bitcast<vec3f>(r1.xyz), r1.w, r2.x, r2.y, r2.z, bitcast<f32>(r2.w));
}

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

fn texelRow(i: u32) -> vec4u {
  let place = vec2f((f32(i32(i & 2047u)) + 0.5) / 2048.0, (f32(i32(i & 0x7ffff800u)) + 1024.0) * frame.texelShare);
  return bitcast<vec4u>(textureSampleLevel(texels, nearest0, place, 0.0));
}

@group(0) @binding(0) var<uniform> frame: Frame;

@group(0) @binding(6) var texels: texture_2d<f32>;

// How the scene table is read: table_texel.wesl; and, where `sampled`, geometry and texels. Its number is that of packed-scene/layout.ts, far from those of the inputs.
@group(0) @binding(15) var nearest0: sampler;

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
