// Linked from tests/bsdf-probe.wesl by `npm run shaders`. Do not edit.
@group(0) @binding(2) var questions: texture_2d<f32>;

// What can be asked, as questions.ts numbers it.
const evaluation = 0u;

const sampledDirection = 1u;

@fragment fn bsdfProbe(@builtin(position) fragment: vec4f) -> @location(0) vec4f {
  let pixel = vec2u(fragment.xy);
  let a = textureLoad(questions, vec2u(2u * pixel.x, pixel.y), 0);
  let b = textureLoad(questions, vec2u(2u * pixel.x + 1u, pixel.y), 0);
  let surface = fetchSurface(u32(a.w));
  let asked = u32(b.w);
  let o = outgoing(surface, a.xyz);
  let drawn = sampleLobe(surface, o, b.xyz);
  let value = evaluateBsdf(surface, o, select(drawn.direction, b.xyz, asked == evaluation));
  if (asked == evaluation) {
    return value;
  }
  let taken = completed(drawn, value);
  if (asked == sampledDirection) {
    return vec4f(taken.direction, taken.pdf);
  }
  // Weight, and in alpha 1 for a delta lobe.
  return vec4f(taken.weight, select(0.0, 1.0, taken.delta));
}

fn fetchSurface(i: u32) -> Surface {
  let t0 = textureLoad(sceneTable, vec2u(9u, i), 0);
  let t1 = textureLoad(sceneTable, vec2u(10u, i), 0);
  let t2 = textureLoad(sceneTable, vec2u(11u, i), 0);
  let t3 = textureLoad(sceneTable, vec2u(12u, i), 0);
  let t4 = textureLoad(sceneTable, vec2u(13u, i), 0);
  return Surface(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w, t4.xyz, t4.w);
}

fn outgoing(s: Surface, wo: vec3f) -> Outgoing {
  let code = u32(s.code);
  var o = Outgoing(wo, select(0.0, 1.0, isConductor(code) | isDielectric(code)), 1.0, 1.0, 1.0);
  if (hasMetallicRoughness) {
    o.share = select(o.share, specularShare(s.baseColor, s.metallic, wo.z), isMetallicRoughness(code));
  }
  if (hasGlass) {
    o.ratio = select(1.0, indexRatio(s.eta.x, wo.z, isThin(code)), isDielectric(code));
  }
  if (hasConductors | hasMetallicRoughness | hasGlass) {
    o.bound = select(reflectionBound(wo, s.alpha), 1.0, isDielectric(code));
    o.stretched = stretched(wo, s.alpha);
  }
  return o;
}

// A direction by one of the lobes. A sample of a delta lobe is complete; of any other the density and weight of all lobes together
// are still to be had from evaluateBsdf: `completed`. u in [0, 1)^3: two for the direction, the third chooses the lobe.
fn sampleLobe(s: Surface, o: Outgoing, u: vec3f) -> BsdfSample {
  let wo = o.wo;
  let mirror = mirrorShare(s.reflectivity);
  let base = 1.0 - mirror;
  // What is left of u.z is uniform again, and once more below.
  let choice = (u.z - mirror) / base;
  var drawn = BsdfSample(sampleCosine(u.xy), 1.0, vec3f(1.0), false);
  if (hasConductors | hasMetallicRoughness | hasGlass) {
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

// rgb: f |cos wi|; a: the density with which sampleLobe gives wi. Delta lobes give 0.
fn evaluateBsdf(s: Surface, o: Outgoing, wi: vec3f) -> vec4f {
  let lambert = invPi * max(wi.z, 0.0);
  var value = vec4f(s.baseColor, 1.0) * lambert;
  var dark = (o.wo.z < 0.0) | (wi.z <= 0.0);
  if (hasConductors | hasMetallicRoughness | hasGlass) {
    let code = u32(s.code);
    let facets = evaluateFacets(s, o, wi);
    var base = vec3f(0.0);
    if (hasMetallicRoughness) {
      base = select(base, metallicRoughnessDiffuse(s.baseColor, s.metallic, facets.cosine), isMetallicRoughness(code));
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

@group(0) @binding(1) var sceneTable: texture_2d<f32>;

struct Surface {
  // Lambert albedo; glTF base colour; constant Fresnel reflectance of a conductor without eta and k
  baseColor: vec3f,
  // kind (0 diffuse, 1 metallicRoughness, 2 conductor, 3 dielectric) + 4 thin + 8 energyCompensation + 16 one-sided lamp + 32 smooth + 64 times one more than the index of the emitter that this shape is, 0: none
  code: f32,
  // radiance sent out
  emission: vec3f,
  // share of the perfect mirror layer over the base
  reflectivity: f32,
  // conductor: index of refraction per channel; dielectric: the index in all three
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
  return hasGlass & (kindOf(code) == dielectric);
}

override hasMetallicRoughness = false;

override hasGlass = false;

override hasConductors = false;

// How often to sample the GGX lobe: about its share of the light that comes back from wo. The diffuse part keeps nearly all of
// its light even when wo is grazing, since the half vector's cosine is not: counted by wo's own it would be sampled too seldom.
fn specularShare(baseColor: vec3f, metallic: f32, cosine: f32) -> f32 {
  let specular = dot(schlick(metallicRoughnessF0(baseColor, metallic), cosine), vec3f(1.0));
  let diffuse = dot(metallicRoughnessDiffuse(baseColor, metallic, 1.0), vec3f(1.0));
  return specular / max(specular + diffuse, 1e-20);
}

fn isMetallicRoughness(code: u32) -> bool {
  return hasMetallicRoughness & (kindOf(code) == metallicRoughness);
}

// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994; f90 = 1.
fn schlick(f0: vec3f, cosine: f32) -> vec3f {
  let m = max(1.0 - cosine, 0.0);
  let m2 = m * m;
  return f0 + (1.0 - f0) * (m2 * m2 * m);
}

fn metallicRoughnessF0(baseColor: vec3f, metallic: f32) -> vec3f {
  return mix(vec3f(dielectricF0), baseColor, metallic);
}

// Albedo of the diffuse part for light that meets facets at this cosine.
fn metallicRoughnessDiffuse(baseColor: vec3f, metallic: f32, cosine: f32) -> vec3f {
  return (1.0 - metallic) * (1.0 - schlick(vec3f(dielectricF0), cosine).x) * baseColor;
}

const dielectricF0 = 0.04;

// These take Surface.code as an integer and not the struct: a compiler that copies structs at each call needs minutes.
fn kindOf(code: u32) -> u32 {
  return code & 3u;
}

const metallicRoughness = 1u;

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

const dielectric = 3u;

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
    reflectance = schlick(metallicRoughnessF0(s.baseColor, s.metallic), cosine);
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

// The GGX microfacet distribution with Smith's masking, isotropic, seen from +z: Walter et al., "Microfacet Models for
// Refraction through Rough Surfaces", EGSR 2007; Heitz, "Understanding the Masking-Shadowing Function", JCGT 2014.
// Written so that nothing is divided by a cosine: grazing directions need no special case.
// Narrower highlights are a mirror's: packed-scene/surface-values.ts.
const leastAlpha = 1e-3;

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

// The perfect mirror: a layer of constant share over any base, and the smooth limit of every microfacet surface.
fn mirrored(wo: vec3f) -> vec3f {
  return vec3f(-wo.xy, wo.z);
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
  // Facets do not turn their back on one direction while the surface does not.
  let faces = (oh * h.z * wo.z >= 0.0) & (ih * h.z * wi.z >= 0.0);
  let spread = select(0.25, abs(oh * ih) / m2, crossing) * select(0.0, 2.0 * facetDensity(h, s.alpha), faces);
  let f = facetReflectance(s, abs(oh), o.ratio);
  var passes = select(f, 1.0 - f, crossing);
  let masked = zi / max(zi * o.stretched + zo * stretched(wi, s.alpha), 1e-20);
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

override hasCompensation = false;

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

// Share of light that comes back from wo when every facet reflects all, but light that meets a second facet is lost. A minimax
// fit of the integral, 0.4 % off at most for |cos| >= 0.04: polynomials in alpha and in cosine / (cosine + alpha), since the
// loss near the horizon is a function of that ratio alone as alpha goes to 0.
fn singleScatteringAlbedo(cosine: f32, alpha: f32) -> f32 {
  let x = cosine / (cosine + alpha);
  let byAlpha = vec4f(0.887807, 0.309386, -0.270728, 0.0252433) + x * (vec4f(1.08526, -3.21434, -1.87718, 1.61195) + x * (vec4f(-5.18071, 10.7648, 6.30913, -8.09265) + x * (vec4f(7.80474, -12.7430, -24.1046, 25.2536) + x * vec4f(-3.60041, 4.60906, 23.1225, -22.9342))));
  let a2 = alpha * alpha;
  return min(dot(byAlpha, vec4f(1.0, alpha, a2, a2 * alpha)), 1.0);
}
