// Linked from tests/bsdf-probe.wesl by `npm run shaders`. Do not edit.
@group(0) @binding(2) var questions: texture_2d<f32>;

// What can be asked, as questions.ts numbers it.
const evaluation = 0u;

const sampledDirection = 1u;

@fragment fn bsdfProbe(@builtin(position) fragment: vec4f) -> @location(0) vec4f {
  let pixel = vec2u(fragment.xy);
  let a = textureLoad(questions, vec2u(3u * pixel.x, pixel.y), 0);
  let b = textureLoad(questions, vec2u(3u * pixel.x + 1u, pixel.y), 0);
  let n = textureLoad(questions, vec2u(3u * pixel.x + 2u, pixel.y), 0).xyz;
  let surface = fetchSurface(u32(a.w));
  let asked = u32(b.w) % 3u;
  let color = u32(b.w) / 3u;
  let hero = select(3.0 * vec3f(vec3u(color) == vec3u(1u, 2u, 3u)), vec3f(1.0), color == 0u);
  layersHere = layersOf(u32(surface.code), surface.eta.x);
  // Like the base's it looks to where wo is.
  coatNormalHere = select(n, -n, (dot(n, a.xyz) < 0.0) != (a.z < 0.0));
  let o = outgoing(surface, a.xyz, hero);
  let drawn = sampleLobe(surface, o, b.xyz);
  // The other direction is to a light in path.wesl.
  let values = evaluatePair(surface, o, b.xyz, drawn);
  if (asked == evaluation) {
    return values.toLight;
  }
  let taken = values.drawn;
  if (asked == sampledDirection) {
    return vec4f(taken.direction, taken.pdf);
  }
  // Weight, and in alpha 1 for a delta lobe.
  return vec4f(taken.weight, select(0.0, 1.0, taken.delta));
}

fn fetchSurface(i: u32) -> Surface {
  let t0 = tableTexel(9u, i);
  let t1 = tableTexel(10u, i);
  let t2 = tableTexel(11u, i);
  let t3 = tableTexel(12u, i);
  let t4 = tableTexel(13u, i);
  return Surface(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w, t4.xyz, t4.w);
}

var<private> layersHere: Layers;

// Those of glTF's own material where there are none.
fn layersOf(code: u32, eta: f32) -> Layers {
  var l: Layers;
  l.specularColor = vec3f(1.0);
  l.specularWeight = 1.0;
  l.ior = 1.5;
  if (isLayered(code) & (eta != 0.0)) {
    l = fetchLayers(u32(abs(eta)));
  }
  return l;
}

// Its unit normal, a variable of the whole program as those of here.wesl: in the world until path.wesl has a frame for the base
// (bsdf.wesl), in that frame from then on. The same as the base's where one normal map bends both, or none.
var<private> coatNormalHere: vec3f;

// The layers are those of layers/here.wesl. `hero`: layers/transmission.wesl; white where colours do not part.
fn outgoing(s: Surface, wo: vec3f, hero: vec3f) -> Outgoing {
  let code = u32(s.code);
  var o = Outgoing(wo, select(0.0, 1.0, isConductor(code) | isDielectric(code)), 1.0, 1.0, 1.0);
  if (hasLayers) {
    if (isLayered(code)) {
      meetLayers(s, wo, hero);
    }
  }
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
  if (hasLayers) {
    if (isLayered(u32(s.code))) {
      let layered = sampleLayered(s, vec3f(u.xy, choice));
      drawn = BsdfSample(layered.direction, base * layered.pdf, vec3f(0.0), layered.delta);
    }
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
  if (hasLayers) {
    if (isLayered(u32(s.code))) {
      // Not by the mirror over everything, whose weight is known.
      let byMirror = drawn.delta & !any(drawn.weight > vec3f(0.0));
      let base = 1.0 - mirrorShare(s.reflectivity);
      let layered = evaluateLayers(s, toLight, drawn.direction, byMirror);
      pair.toLight = base * layered.toLight;
      let ofSample = completed(BsdfSample(drawn.direction, drawn.pdf, drawn.weight, drawn.delta & !byMirror), base * layered.toSample);
      pair.drawn = BsdfSample(ofSample.direction, ofSample.pdf, ofSample.weight, drawn.delta);
    }
  }
  return pair;
}

fn tableTexel(column: u32, row: u32) -> vec4f {
  return textureSampleLevel(sceneTable, nearest, vec2f((f32(i32(column)) + 0.5) / tableWidth, (f32(i32(row)) + 0.5) * frame.rowHeight), 0.0);
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


struct Layers {
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

fn fetchLayers(i: u32) -> Layers {
  let t0 = tableTexel(0u, i);
  let t1 = tableTexel(1u, i);
  let t2 = tableTexel(2u, i);
  let t3 = tableTexel(3u, i);
  let t4 = tableTexel(4u, i);
  let t5 = tableTexel(5u, i);
  let t6 = tableTexel(6u, i);
  return Layers(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xy, t3.z, t3.w, t4.x, t4.y, t4.z, t4.w, t5.x, t5.y, t5.z, t5.w, t6.x, t6.y, t6.z, t6.w);
}

// What glTF's extensions add to metallicRoughness: any of them, and those that take a program something of their own. Light that goes
// through is one, be it by facets or diffusely.
override hasLayers = false;

fn isMetallicRoughness(code: u32) -> bool {
  return hasMetallicRoughness & (kindOf(code) == metallicRoughness);
}

override hasMetallicRoughness = false;

// These take Surface.code as an integer and not the struct: a compiler that copies structs at each call needs minutes.
fn kindOf(code: u32) -> u32 {
  return code & 3u;
}

const metallicRoughness = 1u;

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

fn isDielectric(code: u32) -> bool {
  return hasGlass & (kindOf(code) == dielectric0);
}

override hasGlass = false;

override hasConductors = false;

// Works out stackHere.
fn meetLayers(s: Surface, given: vec3f, hero: vec3f) {
  let side = select(1.0, -1.0, given.z < 0.0);
  let wo = vec3f(given.xy, given.z * side);
  let metallic = s.metallic;
  stackHere.wo = wo;
  stackHere.side = side;
  stackHere.hero = hero;
  stackHere.inside = false;
  stackHere.ratio = 1.0;
  stackHere.alpha = ellipticAlpha(s.alpha, layersHere.anisotropy);
  if (hasTransmission) {
    let isSolid = layersHere.solid > 0.0;
    let inside = isSolid & (side < 0.0);
    let index = dispersedIndex(layersHere.ior, layersHere.dispersion, hero);
    let flat = isSolid & (layersHere.transmission > 0.0) & (index - 1.0 < leastContrast);
    stackHere.inside = inside;
    stackHere.ratio = select(1.0, select(index, 1.0 / index, inside), isSolid);
    stackHere.alpha = select(stackHere.alpha, vec2f(0.0), flat);
  }
  stackHere.coat = 0.0;
  if (hasCoats) {
    stackHere.coat = select(coatReflectance(layersHere.coat, coatCosine(side, wo)), 0.0, stackHere.inside);
    stackHere.coatAlpha = layersHere.coatRoughness * layersHere.coatRoughness;
  }
  stackHere.sheenColor = 0.0;
  stackHere.sheen = 0.0;
  if (hasSheen) {
    stackHere.sheenColor = greatest(layersHere.sheenColor);
    if (stackHere.sheenColor > 0.0) {
      stackHere.sheen = select(sheenAlbedo(wo.z, layersHere.sheenRoughness), 0.0, stackHere.inside);
    }
  }
  let f0 = layersHere.specularWeight * dielectricF0();
  stackHere.more = vec3f(1.0);
  if (hasCompensation) {
    let albedo = singleScatteringAlbedo(wo.z, sqrt(stackHere.alpha.x * stackHere.alpha.y));
    let asked = ((u32(s.code) & 8u) != 0u) & (layersHere.transmission <= 0.0);
    stackHere.more = select(vec3f(1.0), 1.0 + mix(f0, s.baseColor, metallic) * ((1.0 - albedo) / albedo), asked);
  }

  // Lobes are chosen by about the light that they send to wo. The diffuse ones keep nearly all of theirs even when wo is grazing:
  // metallic_roughness.wesl. A film's colours vanish at some angles only.
  let bare = bareReflectance(s, wo.z);
  let met = mix(bare.dielectric, bare.metal, metallic);
  let enters = (1.0 - metallic) * (1.0 - greatest(bare.dielectric));
  let color = mean3(s.baseColor);
  let coat = stackHere.coat;
  let below = (1.0 - coat) * (1.0 - stackHere.sheenColor * min(stackHere.sheen, 1.0));
  let facets = below * (mean3(met) + 0.25 * layersHere.film + enters * layersHere.transmission * color);
  let fibres = (1.0 - coat) * stackHere.sheen * mean3(layersHere.sheenColor);
  let body = below * (1.0 - metallic) * (1.0 - greatest(f0)) * (1.0 - layersHere.transmission);
  let diffuse = body * (1.0 - layersHere.beyond) * color;
  let beyond = body * layersHere.beyond * mean3(layersHere.beyondColor);
  let all = max(coat + facets + fibres + diffuse + beyond, 1e-20);
  stackHere.ofCoat = coat / all;
  stackHere.ofFacets = facets / all;
  stackHere.ofSheen = fibres / all;
  stackHere.ofDiffuse = diffuse / all;
}

var<private> stackHere: Stack;

// KHR_materials_anisotropy: strength makes facets rougher along x. Across, a highlight is no narrower than 32-bit floats can hold.
fn ellipticAlpha(alpha: f32, strength: f32) -> vec2f {
  return select(vec2f(alpha), vec2f(mix(alpha, 1.0, strength * strength), max(alpha, leastAlpha)), strength > 0.0);
}

override hasTransmission = false;

override hasCoats = false;

override hasSheen = false;

// KHR_materials_ior and KHR_materials_specular: what facets of the dielectric would reflect at normal incidence at full weight.
fn dielectricF0() -> vec3f {
  let contrast = (layersHere.ior - 1.0) / (layersHere.ior + 1.0);
  return min(contrast * contrast * layersHere.specularColor, vec3f(1.0));
}

override hasCompensation = false;

// Without a film.
fn bareReflectance(s: Surface, cosine: f32) -> Reflectance {
  let outer = outerCosine(cosine);
  var dielectric = layersHere.specularWeight * schlick(dielectricF0(), outer);
  if (hasTransmission) {
    dielectric = select(dielectric, vec3f(1.0), reflectsAll(cosine, stackHere.ratio));
  }
  return Reflectance(dielectric, schlick(s.baseColor, outer));
}

fn mean3(v: vec3f) -> f32 {
  return dot(v, vec3f(1.0 / 3.0));
}

// KHR_materials_transmission and KHR_materials_volume: light that goes through facets.
// KHR_materials_dispersion: the index that red, green or blue light meets; `hero` is the colour that the path goes on with, or white.
// Below the index of air no dispersion goes.
fn dispersedIndex(ior: f32, dispersion: f32, hero: vec3f) -> f32 {
  let side = select(0.0, 1.0, hero.z > 0.0) - select(0.0, 1.0, hero.x > 0.0);
  return max(ior + side * (ior - 1.0) * 0.025 * dispersion, 1.0);
}

// An index closer to 1 bends light by less than a rough boundary can be told from a smooth one in 32-bit floats.
const leastContrast = 1e-3;

// Share of the light that a coat of this weight sends back.
fn coatReflectance(coat: f32, cosine: f32) -> f32 {
  return coat * schlick(vec3f(coatF0), cosine).x;
}

// Between the coat's normal and a direction in that frame.
fn coatCosine(side: f32, w: vec3f) -> f32 {
  var z = w.z;
  if (hasCoatNormals) {
    z = dot(coatNormal(side), w);
  }
  return abs(z);
}

// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994; f90 = 1.
fn schlick(f0: vec3f, cosine: f32) -> vec3f {
  let m = max(1.0 - cosine, 0.0);
  let m2 = m * m;
  return f0 + (1.0 - f0) * (m2 * m2 * m);
}

const coatF0 = 0.04;

// Clear coats that are bent by another normal map than their base, or by none where the base is.
override hasCoatNormals = false;

// `side` -1: as it is in the frame that is mirrored, where the coat of the other side of a thin wall is above.
fn coatNormal(side: f32) -> vec3f {
  return vec3f(side * coatNormalHere.xy, coatNormalHere.z);
}

fn greatest(v: vec3f) -> f32 {
  return max(max(v.x, v.y), v.z);
}

// E: share of light that white fibres send back to a direction of this cosine; of fine ones along the surface it is more than 1, a gap
// of the model. A fit, 0.005 off at most, or 0.5 % where E is above 1 (scripts/fits/sheen-albedo.ts), and that much is added: what lies
// below loses rather too much than too little.
fn sheenAlbedo(cosine: f32, roughness: f32) -> f32 {
  // -1 at a cosine of 1e-4 and at the least roughness, 1 at 1.
  let u = (sqrt(sqrt(clamp(cosine, 1e-4, 1.0))) - 0.1) / 0.45 - 1.0;
  let v = (sqrt(max(roughness, leastSheenRoughness)) - 0.264575) / 0.367712 - 1.0;
  let low = vec3f(0.746962, 0.0397496, 0.224802) + u * (vec3f(-0.448339, 0.3406, -0.509736) + u * (vec3f(-0.196284, 0.0161825, -0.50469) + u * (vec3f(0.0587112, 0.187983, 0.191769) + u * (vec3f(-0.182064, 0.425384, 0.971703) + u * (vec3f(0.0763965, -0.331055, 0.616069) + u * (vec3f(0.0893496, -0.409073, -0.445006) + u * vec3f(-0.0525425, 0.0277158, -0.421496)))))));
  let high = vec3f(-0.0321953, -0.190573, 0.0715297) + u * (vec3f(0.492365, -0.201291, -0.00570256) + u * (vec3f(0.833264, 0.765625, -1.06831) + u * (vec3f(-1.29238, 0.71056, 0.237437) + u * (vec3f(-2.81818, -0.673857, 2.17806) + u * (vec3f(0.500911, -0.777981, 0.0143213) + u * (vec3f(1.97956, 0.108218, -1.28939) + u * vec3f(0.324871, 0.21472, -0.194708)))))));
  let v2 = v * v;
  let root = dot(low + v2 * v * high, vec3f(1.0, v, v2));
  let albedo = root * root;
  return albedo + 0.005 * max(albedo, 1.0);
}

// KHR_materials_sheen: fibres that stand on the surface. Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017
// course notes: the distribution "Charlie", and a fit of the shadowing that was measured on it.
// Finer fibres shine in so thin a rim that 32-bit floats do not hold it; roughness, not alpha.
const leastSheenRoughness = 0.07;

// Share of light that comes back from wo when every facet reflects all, but light that meets a second facet is lost. A minimax
// fit of the integral, 0.4 % off at most for |cos| >= 0.04: polynomials in alpha and in cosine / (cosine + alpha), since the
// loss near the horizon is a function of that ratio alone as alpha goes to 0.
fn singleScatteringAlbedo(cosine: f32, alpha: f32) -> f32 {
  let x = cosine / (cosine + alpha);
  let byAlpha = vec4f(0.887807, 0.309386, -0.270728, 0.0252433) + x * (vec4f(1.08526, -3.21434, -1.87718, 1.61195) + x * (vec4f(-5.18071, 10.7648, 6.30913, -8.09265) + x * (vec4f(7.80474, -12.7430, -24.1046, 25.2536) + x * vec4f(-3.60041, 4.60906, 23.1225, -22.9342))));
  let a2 = alpha * alpha;
  return min(dot(byAlpha, vec4f(1.0, alpha, a2, a2 * alpha)), 1.0);
}

// What follows from the direction that light leaves in, whichever it comes from.
struct Stack {
  // Above the surface.
  wo: vec3f,
  // -1: wo was below.
  side: f32,
  // Colour that refracted light goes on with, times its weight: transmission.wesl.
  hero: vec3f,
  // Of a solid: the index beyond the boundary over that on wo's side; else 1.
  ratio: f32,
  // wo is inside a solid.
  inside: bool,
  // Factor on what facets of the base reflect: bsdf.wesl, compensation.
  more: vec3f,
  // Facets of the base; below leastAlpha they are a mirror.
  alpha: vec2f,
  coatAlpha: f32,
  // Share of the light towards wo that is the coat's.
  coat: f32,
  // Share of white light that fibres send to wo, and of the strongest colour of these.
  sheen: f32,
  sheenColor: f32,
  // Probabilities of the lobes: the coat's, the base's facets', the sheen's, the diffuse one's. What is left is the diffuse one's beyond.
  ofCoat: f32,
  ofFacets: f32,
  ofSheen: f32,
  ofDiffuse: f32,
  // Whether the facets that a sample was drawn by are the coat's.
  drawnByCoat: bool,
}


// The GGX microfacet distribution with Smith's masking, isotropic, seen from +z: Walter et al., "Microfacet Models for
// Refraction through Rough Surfaces", EGSR 2007; Heitz, "Understanding the Masking-Shadowing Function", JCGT 2014.
// Written so that nothing is divided by a cosine: grazing directions need no special case.
// Narrower highlights are a mirror's: packed-scene/surface-values.ts.
const leastAlpha = 1e-3;

fn outerCosine(cosine: f32) -> f32 {
  var outer = cosine;
  if (hasTransmission) {
    outer = cosineInAir(cosine, stackHere.ratio);
  }
  return outer;
}

// What facets of the base reflect that are met at this cosine, where there is dielectric and where there is metal.
struct Reflectance {
  dielectric: vec3f,
  metal: vec3f,
}


// Total reflection, in a denser body only: along the surface of one that is not, rounding must not make a mirror of it.
fn reflectsAll(cosine: f32, ratio: f32) -> bool {
  return (ratio < 1.0) & (1.0 - cosine * cosine >= ratio * ratio);
}

// The cosine on the side of air at a facet that is met at `cosine`; 0 at total reflection. `ratio`: the index beyond over
// the one on this side. Schlick's formula wants this cosine (KHR_materials_volume, Refraction).
fn cosineInAir(cosine: f32, ratio: f32) -> f32 {
  let sine2 = (1.0 - cosine * cosine) / (ratio * ratio);
  return select(cosine, sqrt(max(1.0 - sine2, 0.0)), ratio < 1.0);
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

fn isThin(code: u32) -> bool {
  return hasGlass & ((code & 7u) == 7u);
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

const dielectric0 = 3u;

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

// Whether what reflects or refracts does so like a mirror.
fn isSmooth(code: u32) -> bool {
  return (code & 32u) != 0u;
}

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
  let larger = sqrt(0.5 * (a2PlusB2 + abs(difference)) + least);
  let smaller = eta * k / larger;
  let a = select(smaller, larger, difference > vec3f(0.0));
  let b = select(larger, smaller, difference > vec3f(0.0));
  // Sums of squares, not multiplied out: rounding never takes them below 0. least: an index of 1 along the surface is no 0 / 0.
  let b2 = b * b + least;
  let acrossFar = a + cosine;
  let acrossNear = a - cosine;
  let across = (acrossNear * acrossNear + b2) / (acrossFar * acrossFar + b2);
  let alongFar = a * cosine + sine2;
  let alongNear = a * cosine - sine2;
  let b2cosine2 = b2 * cosine2 + least;
  return 0.5 * across * (1.0 + (alongNear * alongNear + b2cosine2) / (alongFar * alongFar + b2cosine2));
}

const least = 1e-20;

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

// A direction by one of the lobes; stackHere says by which facets. u in [0, 1)^3: two for the direction, the third chooses the lobe.
fn sampleLayered(s: Surface, u: vec3f) -> LayeredSample {
  let wo = stackHere.wo;
  let isSolid = isSolidHere();
  let isCoat = hasCoats & (u.z < stackHere.ofCoat);
  let isFacet = u.z < stackHere.ofCoat + stackHere.ofFacets;
  stackHere.drawnByCoat = isCoat;
  let alpha = select(stackHere.alpha, vec2f(stackHere.coatAlpha), isCoat);
  let isSmooth = max(alpha.x, alpha.y) < leastAlpha;
  let wide = max(alpha, vec2f(leastAlpha));
  var own = Basis(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0));
  if (hasCoatNormals) {
    if (isCoat) {
      own = basisAbout(coatNormal(stackHere.side));
    }
  }
  var ownWo = wo;
  if (hasCoatNormals) {
    ownWo = toLocal(own, wo);
  }
  let bound = select(ellipticBound(ownWo, wide), 1.0, isSolid & !isCoat);
  let rough = sampleEllipticNormal(ownWo, wide, bound, u.xy);
  var h = select(rough, vec3f(0.0, 0.0, 1.0), isSmooth);
  if (hasCoatNormals) {
    h = toWorld(own, h);
  }
  let oh = max(dot(wo, h), 0.0);
  let reflected = 2.0 * oh * h - wo;
  var met = reflected;
  var crossing = false;
  if (hasTransmission) {
    // What is left of u.z is uniform again.
    let left = (u.z - stackHere.ofCoat) / max(stackHere.ofFacets, 1e-20);
    crossing = !isCoat & (left >= shareToward(s, bareReflectance(s, oh)));
    let beyond = select(vec3f(reflected.xy, -reflected.z), refracted(wo, h, stackHere.ratio), isSolid);
    met = select(reflected, beyond, crossing);
  }
  var lost = !isSmooth & (crossing != (met.z < 0.0));
  if (hasCoatNormals) {
    if (isCoat) {
      lost = (dot(own.normal, met) <= 0.0) | ((met.z < 0.0) & (s.eta.x < 0.0));
    }
  }
  var drawn = LayeredSample(met, select(1.0, 0.0, lost), isSmooth);
  if (!isFacet) {
    let next = u.z - stackHere.ofCoat - stackHere.ofFacets;
    let sine = sqrt(max(u.x * (2.0 - u.x), 0.0));
    let phi = 6.28318530718 * u.y - 3.14159265359;
    let even = vec3f(sine * cos(phi), sine * sin(phi), 1.0 - u.x);
    let matte = sampleCosine(u.xy);
    let below = vec3f(matte.xy, select(matte.z, -matte.z, hasTransmission & (next >= stackHere.ofSheen + stackHere.ofDiffuse)));
    drawn = LayeredSample(select(below, even, hasSheen & (next < stackHere.ofSheen)), 1.0, false);
  }
  drawn.direction.z *= stackHere.side;
  return drawn;
}

fn isSolidHere() -> bool {
  return hasTransmission & (layersHere.solid > 0.0);
}

// An orthonormal basis about a unit normal: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
struct Basis {
  tangent: vec3f,
  bitangent: vec3f,
  normal: vec3f,
}


// Eto and Tokuyoshi 2023, equation 6: the smaller width bounds both.
fn ellipticBound(wo: vec3f, alpha: vec2f) -> f32 {
  let s = 1.0 + length(wo.xy);
  let s2 = s * s;
  let least = min(alpha.x, alpha.y);
  let a2 = least * least;
  return (1.0 - a2) * s2 / (s2 + a2 * wo.z * wo.z);
}

// As sampleVisibleNormal.
fn sampleEllipticNormal(wo: vec3f, alpha: vec2f, bound: f32, u: vec2f) -> vec3f {
  let w = vec3f(alpha * wo.xy, wo.z) / ellipticStretched(wo, alpha);
  let phi = 6.28318530718 * u.x - 3.14159265359;
  let drop = u.y * (1.0 + bound * w.z);
  let sine = sqrt(max(drop * (2.0 - drop), 0.0));
  let h = w + vec3f(sine * cos(phi), sine * sin(phi), 1.0 - drop);
  return normalize(vec3f(alpha * h.xy, max(h.z, 1e-7)));
}

struct LayeredSample {
  direction: vec3f,
  // 0: the light is lost.
  pdf: f32,
  // By smooth facets.
  delta: bool,
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

fn toWorld(b: Basis, v: vec3f) -> vec3f {
  return v.x * b.tangent + v.y * b.bitangent + v.z * b.normal;
}

// How often a sample takes the first, by what the facet would be without a film; a film's colours vanish at some angles, so that neither is
// left out because of it.
fn shareToward(s: Surface, bare: Reflectance) -> f32 {
  let p = partingOf(s, bare);
  let a = mean3(p.toward);
  let b = mean3(p.beyond);
  return select(1.0, mix(a / max(a + b, 1e-20), 0.5, 0.5 * layersHere.film), b > 0.0);
}

fn partingOf(s: Surface, r: Reflectance) -> Parting {
  let toward = mix(r.dielectric, r.metal, s.metallic);
  var parting = Parting(toward, vec3f(0.0));
  if (hasTransmission) {
    let enters = (1.0 - s.metallic) * (1.0 - greatest(r.dielectric));
    parting = Parting(toward * select(vec3f(1.0), stackHere.hero, stackHere.inside), enters * layersHere.transmission * s.baseColor * stackHere.hero);
  }
  return parting;
}

// What a facet of the base makes of light: towards wo's side, and beyond.
struct Parting {
  toward: vec3f,
  beyond: vec3f,
}


fn ellipticStretched(w: vec3f, alpha: vec2f) -> f32 {
  let scaled = alpha * w.xy;
  return sqrt(w.z * w.z + dot(scaled, scaled));
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

// Of each direction rgb: f |cos wi|; a: the density with which sampleLayered gives it. Of smooth facets that is 0; but where `byMirror` says that
// the sample was drawn by them, these alone count, and both are what is left when the density of their facets is taken out of them.
//
// One loop over both directions and, of each, the coat's facets and the base's: so that all stands in the program once, and in no loop within
// another. Its begin is known at run time only, or Windows' compiler would write its turns out.
fn evaluateLayers(s: Surface, toLight: vec3f, toSample: vec3f, byMirror: bool) -> LayeredPair {
  var pair = LayeredPair(vec4f(0.0), vec4f(0.0));
  var isLight = frame.emitterCount > 0u;
  var isFirst = true;
  var sum = vec4f(0.0);
  var intoBody = 0.0;
  loop {
    let given = select(toSample, toLight, isLight);
    let wi = vec3f(given.xy, given.z * stackHere.side);
    // Through a thin wall light goes as if it were reflected and then mirrored.
    let facing = vec3f(wi.xy, abs(wi.z));
    // Below the horizon there is light of what lets some through, and of coats with normals of their own.
    let crossing = (hasTransmission | hasCoatNormals) & (wi.z < 0.0);
    // The coat's facets come first where there is a coat, and where what reaches the body of a solid is not what the base's facets see that
    // light comes through. Else the base's show that too.
    let apart = (stackHere.coat > 0.0) | (isSolidHere() & (crossing | stackHere.inside) & (s.metallic < 1.0));
    let isCoat = (hasCoats | hasTransmission) & isFirst & apart;
    // A coat may be bent towards what lies below the base's horizon; where light goes through that is the other side.
    let coatEnds = crossing & !(hasCoatNormals & (s.eta.x >= 0.0));
    let bends = isSolidHere() & crossing & !isCoat;
    let facets = facetsTowards(select(facing, wi, bends | (isCoat & !coatEnds)), isCoat, bends);
    let ofMirror = byMirror & !isLight;
    let isMirror = ofMirror & (isCoat == stackHere.drawnByCoat);
    let value = select(select(facets.value, 0.0, ofMirror), 1.0, isMirror);
    let density = select(select(facets.density, 0.0, ofMirror), 1.0, isMirror);
    // What reaches the body by way of a coated surface, met halfway; from inside, and by a mirror, by the angle of the surface itself.
    let cosine = select(facets.cosine, stackHere.wo.z, (isCoat & stackHere.inside) | isMirror);
    let bare = bareReflectance(s, cosine);
    var r = bare;
    if (hasIridescence) {
      r = filmedReflectance(s, bare, cosine);
    }
    intoBody = select(intoBody, (1.0 - s.metallic) * (1.0 - greatest(r.dielectric)), isCoat | !apart);
    if (isCoat) {
      sum = select(vec4f(vec3f(stackHere.coat * value), stackHere.ofCoat * density), vec4f(0.0), coatEnds);
      isFirst = false;
    } else {
      let cover = coverTowards(wi, crossing);
      let p = partingOf(s, r);
      let lobe = cover.left * select(p.toward * select(stackHere.more, vec3f(1.0), isMirror), p.beyond, crossing);
      var chosen = stackHere.ofFacets;
      if (hasTransmission) {
        let share = shareToward(s, bare);
        chosen *= select(share, 1.0 - share, crossing) * select(1.0, stackHere.ratio * stackHere.ratio, bends);
      }
      sum += vec4f(lobe * value, chosen * density);
      let body = select((1.0 - layersHere.beyond) * s.baseColor, layersHere.beyond * layersHere.beyondColor, crossing);
      let matte = cover.left * intoBody * (1.0 - layersHere.transmission) * body;
      let even = cover.fibres + vec4f(matte, select(stackHere.ofDiffuse, ofBeyond(), crossing)) * (invPi * facing.z);
      sum += select(even, vec4f(0.0), ofMirror);
      sum = select(sum, vec4f(0.0), !crossing & (wi.z < 0.0));
      pair = LayeredPair(select(pair.toLight, sum, isLight), sum);
      if (!isLight) {
        break;
      }
      isLight = false;
      isFirst = true;
      sum = vec4f(0.0);
    }
  }
  return pair;
}

struct LayeredPair {
  toLight: vec4f,
  toSample: vec4f,
}


fn facetsTowards(wi: vec3f, isCoat: bool, bends: bool) -> Facets {
  let wo = stackHere.wo;
  let alpha = select(stackHere.alpha, vec2f(stackHere.coatAlpha), isCoat);
  let isRough = max(alpha.x, alpha.y) >= leastAlpha;
  let wide = max(alpha, vec2f(leastAlpha));
  let m = wo + wi * select(1.0, stackHere.ratio, bends);
  let m2 = max(dot(m, m), 1e-20);
  let h = m * inverseSqrt(m2);
  let oh = dot(wo, h);
  let ih = dot(wi, h);
  // The same three in the frame of the layer whose facets are meant.
  var ownWo = wo;
  var ownWi = wi;
  var ownH = h;
  if (hasCoatNormals) {
    if (isCoat) {
      let own = basisAbout(coatNormal(stackHere.side));
      ownWo = toLocal(own, wo);
      ownWi = toLocal(own, wi);
      ownH = toLocal(own, h);
    }
  }
  let faces = (oh * ownH.z >= 0.0) & (ih * ownH.z * ownWi.z >= 0.0) & (bends | (ownWi.z >= 0.0));
  let spread = select(0.25, abs(oh * ih) / m2, bends) * select(0.0, 2.0 * ellipticDensity(ownH, wide), faces & isRough);
  let ownStretched = ellipticStretched(ownWo, wide);
  let ownZi = abs(ownWi.z);
  let masked = ownZi / max(ownZi * ownStretched + ownWo.z * ellipticStretched(ownWi, wide), 1e-20);
  let bound = select(ellipticBound(ownWo, wide), 1.0, isSolidHere() & !isCoat);
  return Facets(spread * masked, spread / (bound * ownWo.z + ownStretched), min(abs(oh), 1.0));
}

override hasIridescence = false;

fn filmedReflectance(s: Surface, bare: Reflectance, cosine: f32) -> Reflectance {
  var r = bare;
  if (layersHere.film > 0.0) {
    let outer = outerCosine(cosine);
    // Mostly one of the two.
    var isMetal = s.metallic >= 1.0;
    loop {
      let f0 = select(layersHere.specularWeight * dielectricF0(), s.baseColor, isMetal);
      let film = filmReflectance(f0, layersHere.filmIor, layersHere.filmThickness, outer);
      if (isMetal) {
        r.metal = mix(r.metal, film, layersHere.film);
      } else {
        r.dielectric = mix(r.dielectric, film, layersHere.film);
      }
      if (isMetal | (s.metallic <= 0.0)) {
        break;
      }
      isMetal = true;
    }
    if (hasTransmission) {
      r.dielectric = select(r.dielectric, vec3f(1.0), reflectsAll(cosine, stackHere.ratio));
    }
  }
  return r;
}

// The film's reflectance over a body that would reflect f0 without it. Kept within 0 … 1: the integral over three colours overshoots.
fn filmReflectance(f0: vec3f, filmIor: f32, thickness: f32, cosine: f32) -> vec3f {
  // The cosine within the film; above 0, as its index is at least 1.
  let sine2 = (1.0 - cosine * cosine) / (filmIor * filmIor);
  let within = sqrt(max(1.0 - sine2, 0.0));
  let first = (filmIor - 1.0) / (filmIor + 1.0);
  let r12 = schlick(vec3f(first * first), cosine).x;
  let t121 = 1.0 - r12;
  let body = indexOf(f0 + 1e-4);
  let second = (body - filmIor) / (body + filmIor);
  let r23 = schlick(second * second, within);
  let r123 = clamp(r12 * r23, vec3f(1e-5), vec3f(0.9999));
  let once = sqrt(r123);
  let rs = t121 * t121 * r23 / (1.0 - r123);
  // Half a turn at the lower side of the film's upper boundary, and another where the body's index is less than the film's.
  let shift = 0.5 + select(vec3f(0.0), vec3f(0.5), body < vec3f(filmIor));
  let difference = 2.0 * filmIor * thickness * within;
  var sum = r12 + rs;
  var amplitude = rs - t121;
  var order = 1.0;
  loop {
    amplitude *= once;
    sum += 2.0 * amplitude * sensitivity(order * difference, order * shift);
    order += 1.0;
    if (order > 2.5) {
      break;
    }
  }
  return clamp(sum, vec3f(0.0), vec3f(1.0));
}

// Index of a body that reflects f0 against air.
fn indexOf(f0: vec3f) -> vec3f {
  let root = sqrt(min(f0, vec3f(0.9999)));
  return (1.0 + root) / (1.0 - root);
}

// What is left of the interference of a path difference (nanometres) in linear red, green, blue: section 4, Gaussians in the frequency
// domain for x, y, z and the second lobe of x. `shift`: what the boundaries add to the phase, in turns.
fn sensitivity(difference: f32, shift: vec3f) -> vec3f {
  let phase = 6.28318530718e-9 * difference;
  let mean = vec4f(1.6810e6, 1.7953e6, 2.2084e6, 2.2399e6);
  let variance = vec4f(4.3278e9, 9.3046e9, 6.6121e9, 4.5282e9);
  // val sqrt(2 pi var) / 1.0685e-7 of the sample.
  let height = vec4f(0.846590, 1.000222, 1.001122, 0.153868);
  // Whole turns are left out: the cosine of a large angle has no digits.
  let turns = mean * (phase * 0.15915494309) + vec4f(shift, shift.x);
  let lobes = height * cos(6.28318530718 * (turns - round(turns))) * exp(-variance * (phase * phase));
  let x = lobes.x + lobes.w;
  // XYZ to linear sRGB
  return vec3f(3.2404542 * x - 1.5371385 * lobes.y - 0.4985314 * lobes.z, -0.9692660 * x + 1.8760108 * lobes.y + 0.0415560 * lobes.z, 0.0556434 * x - 0.2040259 * lobes.y + 1.0572252 * lobes.z);
}

fn coverTowards(wi: vec3f, crossing: bool) -> Cover {
  var cover = Cover(1.0, vec4f(0.0));
  if (hasCoats) {
    let ofWi = coatReflectance(layersHere.coat, coatCosine(stackHere.side, wi));
    cover.left = 1.0 - select(stackHere.coat, ofWi, stackHere.inside & crossing);
  }
  if (hasSheen) {
    if (stackHere.sheenColor > 0.0) {
      let isOutside = !(layersHere.solid > 0.0) | (stackHere.inside == crossing);
      let most = max(stackHere.sheen, sheenAlbedo(abs(wi.z), layersHere.sheenRoughness));
      let white = (1.0 - stackHere.coat) * whiteSheen(stackHere.wo, wi, sheenAlpha(layersHere.sheenRoughness)) / max(most, 1.0);
      cover.fibres = select(vec4f(white * layersHere.sheenColor, stackHere.ofSheen * invTwoPi), vec4f(0.0), crossing | stackHere.inside);
      cover.left *= 1.0 - stackHere.sheenColor * min(select(stackHere.sheen, most, isOutside), 1.0);
    }
  }
  return cover;
}

fn ofBeyond() -> f32 {
  return max(1.0 - stackHere.ofCoat - stackHere.ofFacets - stackHere.ofSheen - stackHere.ofDiffuse, 0.0);
}

// Matte surfaces: radiance leaves alike to all sides (Lambert, Photometria, 1760).
const invPi = 0.31830988618;

// What of the light from wi is left by coat and sheen, and what the sheen adds, as evaluateLayers gives it. Light that crosses a solid's
// boundary meets both once, outside.
struct Cover {
  left: f32,
  fibres: vec4f,
}


// What the fibres send back, times the cosine of wi, for white ones. Both cosines are above 0.
fn whiteSheen(wo: vec3f, wi: vec3f, alpha: f32) -> f32 {
  let m = wo + wi;
  let m2 = max(dot(m, m), 1e-20);
  let sine2 = clamp(dot(m.xy, m.xy) / m2, 0.0, 1.0);
  let power = 0.5 / alpha;
  // (2 + 1/alpha) sin^(1/alpha) / 2 pi, and 1 / (4 zo zi (1 + Lambda + Lambda)), times zi
  let density = (2.0 + 2.0 * power) * 0.15915494309 * select(exp(power * log(max(sine2, 1e-20))), 0.0, sine2 < 1e-20);
  let zo = max(wo.z, 1e-6);
  return density / (4.0 * zo * (1.0 + sheenShadowing(wo.z, alpha) + sheenShadowing(wi.z, alpha)));
}

fn sheenAlpha(roughness: f32) -> f32 {
  let r = max(roughness, leastSheenRoughness);
  return r * r;
}

const invTwoPi = 0.15915494309;

// Lambda at this cosine; along the surface it is large and finite.
fn sheenShadowing(cosine: f32, alpha: f32) -> f32 {
  let x = clamp(cosine, 1e-6, 1.0);
  let isLow = x < 0.5;
  let l = shadowingExponent(select(max(1.0 - x, 1e-6), x, isLow), alpha);
  return exp(select(2.0 * shadowingExponent(0.5, alpha) - l, l, isLow));
}

// l(x) of equation 3, table 1.
fn shadowingExponent(x: f32, alpha: f32) -> f32 {
  let m = (1.0 - alpha) * (1.0 - alpha);
  let a = mix(21.5473, 25.3245, m);
  let b = mix(3.82987, 3.32435, m);
  let c = mix(0.19823, 0.16801, m);
  let d = mix(-1.97760, -1.27393, m);
  let e = mix(-4.32054, -4.85967, m);
  return a / (1.0 + b * pow(x, c)) + d * x + e;
}

fn ellipticDensity(h: vec3f, alpha: vec2f) -> f32 {
  let scaled = h.xy / alpha;
  let slope = max(dot(scaled, scaled) + h.z * h.z, 1.0);
  return 0.31830988618 / (alpha.x * alpha.y * slope * slope);
}

// Facets of coat or base between wo and a direction: f |cos| but for what they reflect, the density of samples by them, and the cosine that
// they are met at. Smooth ones have neither.
struct Facets {
  value: f32,
  density: f32,
  cosine: f32,
}


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
