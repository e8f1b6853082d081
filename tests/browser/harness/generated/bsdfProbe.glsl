#version 300 es

precision highp float;
precision highp int;

bool pick(bool which, bool yes, bool no) { return which ? yes : no; }
int pick(bool which, int yes, int no) { return which ? yes : no; }
uint pick(bool which, uint yes, uint no) { return which ? yes : no; }
float pick(bool which, float yes, float no) { return which ? yes : no; }
vec2 pick(bool which, vec2 yes, vec2 no) { return which ? yes : no; }
vec3 pick(bool which, vec3 yes, vec3 no) { return which ? yes : no; }
vec4 pick(bool which, vec4 yes, vec4 no) { return which ? yes : no; }
uvec2 pick(bool which, uvec2 yes, uvec2 no) { return which ? yes : no; }

struct Surface {
    vec3 baseColor;
    float code;
    vec3 emission;
    float reflectivity;
    vec3 eta;
    float alpha;
    vec3 k;
    float metallic;
    vec3 absorption;
    float textures;
};
struct Outgoing {
    vec3 wo;
    float share;
    float ratio;
    float bound;
    float stretched;
};
struct BsdfSample {
    vec3 direction;
    float pdf;
    vec3 weight;
    bool delta;
};
struct FacetLobe {
    vec3 value;
    float pdf;
    float cosine;
};
const uint evaluation = 0u;
const uint sampledDirection = 1u;
const uint conductor = 2u;
const uint dielectric = 3u;
const uint metallicRoughness = 1u;
const uint diffuse0_ = 0u;

uniform highp sampler2D questions;

uniform highp sampler2D sceneTable;

const bool hasConductors = false;

const bool hasGlass = false;

const bool hasMetallicRoughness = false;

const bool hasMirrorLayers = true;

const bool hasCompensation = false;

layout(location = 0) out vec4 _fs2p_location0;

Surface fetchSurface(uint i) {
    vec4 t0_ = texelFetch(sceneTable, ivec2(uvec2(9u, i)), 0);
    vec4 t1_ = texelFetch(sceneTable, ivec2(uvec2(10u, i)), 0);
    vec4 t2_ = texelFetch(sceneTable, ivec2(uvec2(11u, i)), 0);
    vec4 t3_ = texelFetch(sceneTable, ivec2(uvec2(12u, i)), 0);
    vec4 t4_ = texelFetch(sceneTable, ivec2(uvec2(13u, i)), 0);
    return Surface(t0_.xyz, t0_.w, t1_.xyz, t1_.w, t2_.xyz, t2_.w, t3_.xyz, t3_.w, t4_.xyz, t4_.w);
}

uint kindOf(uint code) {
    return (code & 3u);
}

bool isConductor(uint code_1) {
    const bool _e2 = hasConductors;
    uint _e3 = kindOf(code_1);
    return pick(_e2, (_e3 == conductor), false);
}

bool isDielectric(uint code_2) {
    const bool _e2 = hasGlass;
    uint _e3 = kindOf(code_2);
    return pick(_e2, (_e3 == dielectric), false);
}

vec3 schlick(vec3 f0_, float cosine) {
    float m = max((1.0 - cosine), 0.0);
    float m2_ = (m * m);
    return (f0_ + ((vec3(1.0) - f0_) * ((m2_ * m2_) * m)));
}

vec3 metallicRoughnessF0_(vec3 baseColor, float metallic) {
    return mix(vec3(0.04), baseColor, metallic);
}

vec3 metallicRoughnessDiffuse(vec3 baseColor_1, float metallic_1, float cosine_1) {
    vec3 _e7 = schlick(vec3(0.04), cosine_1);
    return (((1.0 - metallic_1) * (1.0 - _e7.x)) * baseColor_1);
}

float specularShare(vec3 baseColor_2, float metallic_2, float cosine_2) {
    vec3 _e3 = metallicRoughnessF0_(baseColor_2, metallic_2);
    vec3 _e4 = schlick(_e3, cosine_2);
    float specular = dot(_e4, vec3(1.0));
    vec3 _e9 = metallicRoughnessDiffuse(baseColor_2, metallic_2, 1.0);
    float diffuse = dot(_e9, vec3(1.0));
    return (specular / max((specular + diffuse), 1e-20));
}

bool isMetallicRoughness(uint code_3) {
    const bool _e2 = hasMetallicRoughness;
    uint _e3 = kindOf(code_3);
    return pick(_e2, (_e3 == metallicRoughness), false);
}

float indexRatio(float eta, float z, bool thin) {
    return pick(pick((z < 0.0), !(thin), false), (1.0 / eta), eta);
}

bool isThin(uint code_4) {
    const bool _e2 = hasGlass;
    return pick(_e2, ((code_4 & 7u) == 7u), false);
}

float reflectionBound(vec3 wo, float alpha) {
    float s_6 = (1.0 + length(wo.xy));
    float s2_ = (s_6 * s_6);
    float a2_ = (alpha * alpha);
    return (((1.0 - a2_) * s2_) / (s2_ + ((a2_ * wo.z) * wo.z)));
}

float stretched(vec3 w, float alpha_1) {
    return sqrt(((w.z * w.z) + ((alpha_1 * alpha_1) * dot(w.xy, w.xy))));
}

Outgoing outgoing(Surface s, vec3 wo_1) {
    Outgoing o = Outgoing(vec3(0.0), 0.0, 0.0, 0.0, 0.0);
    uint code_6 = uint(s.code);
    bool _e4 = isConductor(code_6);
    bool _e5 = isDielectric(code_6);
    o = Outgoing(wo_1, pick(pick(_e4, true, _e5), 1.0, 0.0), 1.0, 1.0, 1.0);
    const bool _e16 = hasMetallicRoughness;
    if (_e16) {
        float _e19 = o.share;
        float _e23 = specularShare(s.baseColor, s.metallic, wo_1.z);
        bool _e24 = isMetallicRoughness(code_6);
        o.share = pick(_e24, _e23, _e19);
    }
    const bool _e27 = hasGlass;
    if (_e27) {
        bool _e32 = isThin(code_6);
        float _e33 = indexRatio(s.eta.x, wo_1.z, _e32);
        bool _e34 = isDielectric(code_6);
        o.ratio = pick(_e34, _e33, 1.0);
    }
    const bool _e38 = hasConductors;
    const bool _e40 = hasMetallicRoughness;
    const bool _e43 = hasGlass;
    if (pick(pick(_e38, true, _e40), true, _e43)) {
        float _e47 = reflectionBound(wo_1, s.alpha);
        bool _e48 = isDielectric(code_6);
        o.bound = pick(_e48, 1.0, _e47);
        float _e53 = stretched(wo_1, s.alpha);
        o.stretched = _e53;
    }
    Outgoing _e54 = o;
    return _e54;
}

float mirrorShare(float reflectivity) {
    const bool _e2 = hasMirrorLayers;
    return pick(_e2, reflectivity, 0.0);
}

vec3 sampleCosine(vec2 u) {
    float radius = sqrt(u.x);
    float phi = ((6.2831855 * u.y) - 3.1415927);
    return normalize(vec3((radius * cos(phi)), (radius * sin(phi)), sqrt((1.0 - u.x))));
}

bool isSmooth(uint code_5) {
    return ((code_5 & 32u) != 0u);
}

vec3 sampleVisibleNormal(vec3 wo_2, float alpha_2, float bound, vec2 u_1) {
    float _e8 = stretched(wo_2, alpha_2);
    vec3 w_1 = (vec3((alpha_2 * wo_2.xy), wo_2.z) / vec3(_e8));
    float phi_1 = ((6.2831855 * u_1.x) - 3.1415927);
    float drop = (u_1.y * (1.0 + (bound * w_1.z)));
    float sine = sqrt(max((drop * (2.0 - drop)), 0.0));
    vec3 h_2 = (w_1 + vec3((sine * cos(phi_1)), (sine * sin(phi_1)), (1.0 - drop)));
    return normalize(vec3((alpha_2 * h_2.xy), max(h_2.z, 1e-7)));
}

vec3 sampleFacet(float alpha_3, bool isMirror, Outgoing o_1, vec2 u_2) {
    float side = pick((o_1.wo.z < 0.0), -1.0, 1.0);
    vec3 _e16 = sampleVisibleNormal((o_1.wo * side), max(alpha_3, 0.001), o_1.bound, u_2);
    return (pick(isMirror, vec3(0.0, 0.0, 1.0), _e16) * side);
}

vec3 conductorFresnel(float cosine_3, vec3 eta_1, vec3 k) {
    float cosine2_ = (cosine_3 * cosine_3);
    float sine2_ = (1.0 - cosine2_);
    vec3 difference = (((eta_1 * eta_1) - (k * k)) - vec3(sine2_));
    vec3 a2PlusB2_ = sqrt(((difference * difference) + ((((4.0 * eta_1) * eta_1) * k) * k)));
    vec3 larger = sqrt(((0.5 * (a2PlusB2_ + abs(difference))) + vec3(1e-20)));
    vec3 smaller = ((eta_1 * k) / larger);
    vec3 a = mix(smaller, larger, greaterThan(difference, vec3(0.0)));
    vec3 b = mix(larger, smaller, greaterThan(difference, vec3(0.0)));
    vec3 b2_ = ((b * b) + vec3(1e-20));
    vec3 acrossFar = (a + vec3(cosine_3));
    vec3 acrossNear = (a - vec3(cosine_3));
    vec3 across = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a * cosine_3) + vec3(sine2_));
    vec3 alongNear = ((a * cosine_3) - vec3(sine2_));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor_3, vec3 eta_2, vec3 k_1, float cosine_4) {
    float constants = dot((eta_2 + k_1), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_4, eta_2, k_1);
    return pick((constants > 0.0), _e8, baseColor_3);
}

float dielectricFresnel(float cosine_5, float ratio) {
    float inside2_ = (((ratio - 1.0) * (ratio + 1.0)) + (cosine_5 * cosine_5));
    float inside = sqrt(max(inside2_, 0.0));
    float across_1 = ((cosine_5 - inside) / (cosine_5 + inside));
    float along = ((((ratio * ratio) * cosine_5) - inside) / (((ratio * ratio) * cosine_5) + inside));
    return pick((inside2_ > 0.0), (0.5 * ((across_1 * across_1) + (along * along))), 1.0);
}

float glassReflectance(float cosine_6, float ratio_1, bool thin_1) {
    float _e3 = dielectricFresnel(cosine_6, ratio_1);
    return pick(thin_1, ((2.0 * _e3) / (1.0 + _e3)), _e3);
}

vec3 facetReflectance(Surface s_1, float cosine_7, float ratio_2) {
    vec3 reflectance = vec3(0.0);
    uint code_7 = uint(s_1.code);
    const bool _e9 = hasMetallicRoughness;
    if (_e9) {
        vec3 _e12 = metallicRoughnessF0_(s_1.baseColor, s_1.metallic);
        vec3 _e13 = schlick(_e12, cosine_7);
        reflectance = _e13;
    }
    const bool _e15 = hasConductors;
    if (_e15) {
        vec3 _e16 = reflectance;
        vec3 _e20 = conductorReflectance(s_1.baseColor, s_1.eta, s_1.k, cosine_7);
        bool _e21 = isConductor(code_7);
        reflectance = pick(_e21, _e20, _e16);
    }
    const bool _e24 = hasGlass;
    if (_e24) {
        vec3 _e25 = reflectance;
        bool _e26 = isThin(code_7);
        float _e27 = glassReflectance(cosine_7, ratio_2, _e26);
        bool _e29 = isDielectric(code_7);
        reflectance = pick(_e29, vec3(_e27), _e25);
    }
    vec3 _e31 = reflectance;
    return _e31;
}

vec3 refracted(vec3 wo_3, vec3 h, float ratio_3) {
    float cosine_10 = dot(wo_3, h);
    float inside_1 = sqrt(max((((ratio_3 - 1.0) * (ratio_3 + 1.0)) + (cosine_10 * cosine_10)), 0.0));
    return ((((cosine_10 - inside_1) * h) - wo_3) / vec3(ratio_3));
}

vec3 mirrored(vec3 wo_4) {
    return vec3(-(wo_4.xy), wo_4.z);
}

BsdfSample sampleLobe(Surface s_2, Outgoing o_2, vec3 u_3) {
    BsdfSample drawn = BsdfSample(vec3(0.0), 0.0, vec3(0.0), false);
    vec3 wi = vec3(0.0);
    float probability = 0.0;
    vec3 weight = vec3(0.0);
    vec3 wo_5 = o_2.wo;
    float _e5 = mirrorShare(s_2.reflectivity);
    float base_1 = (1.0 - _e5);
    float choice = ((u_3.z - _e5) / base_1);
    vec3 _e12 = sampleCosine(u_3.xy);
    drawn = BsdfSample(_e12, 1.0, vec3(1.0), false);
    const bool _e20 = hasConductors;
    const bool _e22 = hasMetallicRoughness;
    const bool _e25 = hasGlass;
    if (pick(pick(_e20, true, _e22), true, _e25)) {
        uint code_8 = uint(s_2.code);
        bool _e29 = isDielectric(code_8);
        bool _e30 = isSmooth(code_8);
        vec3 _e33 = sampleFacet(s_2.alpha, _e30, o_2, u_3.xy);
        float oh = max(dot(wo_5, _e33), 0.0);
        vec3 _e38 = facetReflectance(s_2, oh, o_2.ratio);
        bool crossing = pick(_e29, (choice >= _e38.x), false);
        wi = (((2.0 * oh) * _e33) - wo_5);
        probability = (base_1 * o_2.share);
        weight = (_e38 / vec3(o_2.share));
        const bool _e55 = hasGlass;
        if (_e55) {
            bool _e56 = isThin(code_8);
            vec3 _e57 = wi;
            vec3 _e59 = refracted(wo_5, _e33, o_2.ratio);
            wi = pick(crossing, pick(_e56, -(wo_5), _e59), _e57);
            float _e63 = probability;
            probability = pick(_e29, (base_1 * pick(crossing, (1.0 - _e38.x), _e38.x)), _e63);
            vec3 _e71 = weight;
            weight = pick(_e29, vec3(pick(pick(crossing, !(_e56), false), (1.0 / (o_2.ratio * o_2.ratio)), 1.0)), _e71);
        }
        float _e88 = wi.z;
        bool lost = pick(!(_e30), (crossing != ((wo_5.z < 0.0) != (_e88 < 0.0))), false);
        bool specular_1 = (choice < o_2.share);
        vec3 _e98 = drawn.direction;
        vec3 _e99 = wi;
        drawn.direction = pick(specular_1, _e99, _e98);
        float _e103 = drawn.pdf;
        float _e104 = probability;
        drawn.pdf = pick(specular_1, pick(lost, 0.0, _e104), _e103);
        vec3 _e110 = drawn.weight;
        vec3 _e111 = weight;
        drawn.weight = pick(specular_1, _e111, _e110);
        drawn.delta = pick(specular_1, _e30, false);
    }
    const bool _e116 = hasMirrorLayers;
    if (_e116) {
        bool reflected = (u_3.z < _e5);
        vec3 _e121 = drawn.direction;
        vec3 _e122 = mirrored(wo_5);
        drawn.direction = pick(reflected, _e122, _e121);
        float _e126 = drawn.pdf;
        drawn.pdf = pick(reflected, _e5, _e126);
        vec3 _e130 = drawn.weight;
        drawn.weight = pick(reflected, vec3(1.0), _e130);
        bool _e136 = drawn.delta;
        drawn.delta = pick(_e136, true, reflected);
    }
    BsdfSample _e138 = drawn;
    return _e138;
}

float facetDensity(vec3 h_1, float alpha_4) {
    float slope = max(((dot(h_1.xy, h_1.xy) / (alpha_4 * alpha_4)) + (h_1.z * h_1.z)), 1.0);
    return (0.31830987 / (((alpha_4 * alpha_4) * slope) * slope));
}

float singleScatteringAlbedo(float cosine_8, float alpha_5) {
    float x = (cosine_8 / (cosine_8 + alpha_5));
    vec4 byAlpha = (vec4(0.887807, 0.309386, -0.270728, 0.0252433) + (x * (vec4(1.08526, -3.21434, -1.87718, 1.61195) + (x * (vec4(-5.18071, 10.7648, 6.30913, -8.09265) + (x * (vec4(7.80474, -12.743, -24.1046, 25.2536) + (x * vec4(-3.60041, 4.60906, 23.1225, -22.9342)))))))));
    float a2_1 = (alpha_5 * alpha_5);
    return min(dot(byAlpha, vec4(1.0, alpha_5, a2_1, (a2_1 * alpha_5))), 1.0);
}

vec3 compensation(Surface s_3, float cosine_9) {
    uint code_9 = uint(s_3.code);
    bool _e8 = isDielectric(code_9);
    bool asked = pick(((code_9 & 8u) != 0u), !(_e8), false);
    float _e12 = singleScatteringAlbedo(cosine_9, s_3.alpha);
    vec3 _e17 = facetReflectance(s_3, 1.0, 1.0);
    return pick(asked, (vec3(1.0) + (_e17 * ((1.0 - _e12) / _e12))), vec3(1.0));
}

FacetLobe evaluateFacets(Surface s_4, Outgoing o_3, vec3 wi_1) {
    vec3 passes = vec3(0.0);
    vec3 wo_6 = o_3.wo;
    bool _e6 = isDielectric(uint(s_4.code));
    const bool _e8 = hasGlass;
    bool crossing_1 = pick(_e8, ((wo_6.z < 0.0) != (wi_1.z < 0.0)), false);
    vec3 m_1 = (wo_6 + (wi_1 * pick(crossing_1, o_3.ratio, 1.0)));
    float m2_1 = max(dot(m_1, m_1), 1e-20);
    vec3 h_3 = (m_1 * inversesqrt(m2_1));
    float oh_1 = dot(wo_6, h_3);
    float ih = dot(wi_1, h_3);
    float zo = abs(wo_6.z);
    float zi = abs(wi_1.z);
    bool faces = pick((((oh_1 * h_3.z) * wo_6.z) >= 0.0), (((ih * h_3.z) * wi_1.z) >= 0.0), false);
    float _e52 = facetDensity(h_3, s_4.alpha);
    float spread = (pick(crossing_1, (abs((oh_1 * ih)) / m2_1), 0.25) * pick(faces, (2.0 * _e52), 0.0));
    vec3 _e60 = facetReflectance(s_4, abs(oh_1), o_3.ratio);
    passes = pick(crossing_1, (vec3(1.0) - _e60), _e60);
    float _e69 = stretched(wi_1, s_4.alpha);
    float masked = (zi / max(((zi * o_3.stretched) + (zo * _e69)), 1e-20));
    float _e76 = passes.x;
    float chosen = (pick(_e6, _e76, 1.0) * pick(crossing_1, (o_3.ratio * o_3.ratio), 1.0));
    const bool _e86 = hasCompensation;
    if (_e86) {
        vec3 _e87 = passes;
        vec3 _e88 = compensation(s_4, zo);
        passes = (_e87 * _e88);
    }
    vec3 _e90 = passes;
    return FacetLobe(((_e90 * spread) * masked), ((spread * chosen) / ((o_3.bound * zo) + o_3.stretched)), abs(oh_1));
}

vec4 evaluateBsdf(Surface s_5, Outgoing o_4, vec3 wi_2) {
    vec4 value = vec4(0.0);
    bool dark = false;
    vec3 base = vec3(0.0);
    float lambert = (0.31830987 * max(wi_2.z, 0.0));
    value = (vec4(s_5.baseColor, 1.0) * lambert);
    dark = pick((o_4.wo.z < 0.0), true, (wi_2.z <= 0.0));
    const bool _e23 = hasConductors;
    const bool _e25 = hasMetallicRoughness;
    const bool _e28 = hasGlass;
    if (pick(pick(_e23, true, _e25), true, _e28)) {
        uint code_10 = uint(s_5.code);
        FacetLobe _e32 = evaluateFacets(s_5, o_4, wi_2);
        const bool _e37 = hasMetallicRoughness;
        if (_e37) {
            vec3 _e38 = base;
            vec3 _e42 = metallicRoughnessDiffuse(s_5.baseColor, s_5.metallic, _e32.cosine);
            bool _e43 = isMetallicRoughness(code_10);
            base = pick(_e43, _e42, _e38);
        }
        bool _e52 = isSmooth(code_10);
        vec4 rough = pick(_e52, vec4(0.0), vec4(_e32.value, (o_4.share * _e32.pdf)));
        vec3 _e54 = base;
        vec4 _e61 = value;
        uint _e62 = kindOf(code_10);
        value = pick((_e62 == diffuse0_), _e61, (rough + (vec4(_e54, (1.0 - o_4.share)) * lambert)));
        bool _e66 = dark;
        bool _e67 = isSmooth(code_10);
        bool _e68 = isDielectric(code_10);
        dark = pick(_e68, _e67, _e66);
    }
    float _e71 = mirrorShare(s_5.reflectivity);
    vec4 _e74 = value;
    bool _e78 = dark;
    return pick(_e78, vec4(0.0), ((1.0 - _e71) * _e74));
}

BsdfSample completed(BsdfSample drawn_1, vec4 value_1) {
    float pdf = pick((drawn_1.pdf <= 0.0), 0.0, value_1.w);
    vec3 weight_1 = pick((pdf > 0.0), (value_1.xyz / vec3(max(pdf, 1e-30))), vec3(0.0));
    return BsdfSample(drawn_1.direction, pick(drawn_1.delta, drawn_1.pdf, pdf), pick(drawn_1.delta, drawn_1.weight, weight_1), drawn_1.delta);
}

void main() {
    vec4 fragment = gl_FragCoord;
    uvec2 pixel = uvec2(fragment.xy);
    vec4 a_1 = texelFetch(questions, ivec2(uvec2((2u * pixel.x), pixel.y)), 0);
    vec4 b_1 = texelFetch(questions, ivec2(uvec2(((2u * pixel.x) + 1u), pixel.y)), 0);
    Surface _e23 = fetchSurface(uint(a_1.w));
    uint asked_1 = uint(b_1.w);
    Outgoing _e27 = outgoing(_e23, a_1.xyz);
    BsdfSample _e29 = sampleLobe(_e23, _e27, b_1.xyz);
    vec4 _e35 = evaluateBsdf(_e23, _e27, pick((asked_1 == evaluation), b_1.xyz, _e29.direction));
    if ((asked_1 == evaluation)) {
        _fs2p_location0 = _e35;
        return;
    }
    BsdfSample _e38 = completed(_e29, _e35);
    if ((asked_1 == sampledDirection)) {
        _fs2p_location0 = vec4(_e38.direction, _e38.pdf);
        return;
    }
    _fs2p_location0 = vec4(_e38.weight, pick(_e38.delta, 1.0, 0.0));
    return;
}

