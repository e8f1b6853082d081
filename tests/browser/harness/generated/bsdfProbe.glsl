#version 300 es

precision highp float;
precision highp int;

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
    float emitter;
};
struct FacetLobe {
    vec3 value;
    float pdf;
    float cosine;
};
struct BsdfSample {
    vec3 direction;
    float pdf;
    vec3 weight;
    bool delta;
};
const uint evaluation = 0u;
const uint sampledDirection = 1u;
const uint dielectric = 3u;
const uint diffuse = 0u;
const uint metallicRoughness = 1u;
const uint conductor = 2u;

uniform highp sampler2D questions;

uniform highp sampler2D sceneTable;

layout(location = 0) out vec4 _fs2p_location0;

Surface fetchSurface(uint i) {
    vec4 t0_ = texelFetch(sceneTable, ivec2(uvec2(9u, i)), 0);
    vec4 t1_ = texelFetch(sceneTable, ivec2(uvec2(10u, i)), 0);
    vec4 t2_ = texelFetch(sceneTable, ivec2(uvec2(11u, i)), 0);
    vec4 t3_ = texelFetch(sceneTable, ivec2(uvec2(12u, i)), 0);
    vec4 t4_ = texelFetch(sceneTable, ivec2(uvec2(13u, i)), 0);
    return Surface(t0_.xyz, t0_.w, t1_.xyz, t1_.w, t2_.xyz, t2_.w, t3_.xyz, t3_.w, t4_.xyz, t4_.w);
}

uint kindOf(Surface s) {
    return (uint(s.code) & 3u);
}

bool isThin(Surface s_1) {
    return ((uint(s_1.code) & 7u) == 7u);
}

bool hasSmoothLobe(Surface s_2) {
    bool _e8 = isThin(s_2);
    bool clear = ((abs((s_2.eta.x - 1.0)) < 0.001) || _e8);
    uint _e13 = kindOf(s_2);
    return ((s_2.alpha < 0.001) || ((_e13 == dielectric) && clear));
}

vec3 schlick(vec3 f0_, float cosine) {
    float m = max((1.0 - cosine), 0.0);
    float m2_ = (m * m);
    return (f0_ + ((vec3(1.0) - f0_) * ((m2_ * m2_) * m)));
}

vec3 metallicRoughnessF0_(Surface s_3) {
    return mix(vec3(0.04), s_3.baseColor, s_3.metallic);
}

vec3 metallicRoughnessDiffuse(Surface s_4, float cosine_1) {
    vec3 _e7 = schlick(vec3(0.04), cosine_1);
    return (((1.0 - s_4.metallic) * (1.0 - _e7.x)) * s_4.baseColor);
}

float specularShare(Surface s_5, float cosine_2) {
    vec3 _e2 = metallicRoughnessF0_(s_5);
    vec3 _e3 = schlick(_e2, cosine_2);
    float specular = dot(_e3, vec3(1.0));
    vec3 _e8 = metallicRoughnessDiffuse(s_5, 1.0);
    float diffuse_1 = dot(_e8, vec3(1.0));
    return (specular / max((specular + diffuse_1), 1e-20));
}

float facetShare(Surface s_6, float cosine_3) {
    uint _e2 = kindOf(s_6);
    float _e8 = specularShare(s_6, cosine_3);
    return ((_e2 == metallicRoughness) ? _e8 : ((_e2 == diffuse) ? 0.0 : 1.0));
}

float indexRatio(Surface s_7, float z) {
    return ((z < 0.0) ? (1.0 / s_7.eta.x) : s_7.eta.x);
}

float stretched(vec3 w, float alpha) {
    return sqrt(((w.z * w.z) + ((alpha * alpha) * dot(w.xy, w.xy))));
}

float reflectionBound(vec3 wo, float alpha_1) {
    float s_16 = (1.0 + length(wo.xy));
    float s2_ = (s_16 * s_16);
    float a2_ = (alpha_1 * alpha_1);
    return (((1.0 - a2_) * s2_) / (s2_ + ((a2_ * wo.z) * wo.z)));
}

float facetDensity(vec3 h, float alpha_2) {
    float slope = max(((dot(h.xy, h.xy) / (alpha_2 * alpha_2)) + (h.z * h.z)), 1.0);
    return (0.31830987 / (((alpha_2 * alpha_2) * slope) * slope));
}

float dielectricFresnel(float cosine_4, float ratio) {
    float inside2_ = (((ratio - 1.0) * (ratio + 1.0)) + (cosine_4 * cosine_4));
    float inside = sqrt(max(inside2_, 0.0));
    float across = ((cosine_4 - inside) / (cosine_4 + inside));
    float along = ((((ratio * ratio) * cosine_4) - inside) / (((ratio * ratio) * cosine_4) + inside));
    return ((inside2_ > 0.0) ? (0.5 * ((across * across) + (along * along))) : 1.0);
}

float glassReflectance(float cosine_5, float ratio_1, bool thin) {
    float _e3 = dielectricFresnel(cosine_5, ratio_1);
    return (thin ? ((2.0 * _e3) / (1.0 + _e3)) : _e3);
}

vec3 conductorFresnel(float cosine_6, vec3 eta, vec3 k) {
    float cosine2_ = (cosine_6 * cosine_6);
    float sine2_ = (1.0 - cosine2_);
    vec3 difference = (((eta * eta) - (k * k)) - vec3(sine2_));
    vec3 a2PlusB2_ = sqrt(((difference * difference) + ((((4.0 * eta) * eta) * k) * k)));
    vec3 larger = sqrt(((0.5 * (a2PlusB2_ + abs(difference))) + vec3(1e-20)));
    vec3 a = mix(((eta * k) / larger), larger, greaterThan(difference, vec3(0.0)));
    vec3 across_1 = ((((a2PlusB2_ + vec3(cosine2_)) - ((2.0 * cosine_6) * a)) + vec3(1e-20)) / (((a2PlusB2_ + vec3(cosine2_)) + ((2.0 * cosine_6) * a)) + vec3(1e-20)));
    vec3 sum = ((cosine2_ * a2PlusB2_) + vec3((sine2_ * sine2_)));
    vec3 part = (((2.0 * cosine_6) * sine2_) * a);
    return ((0.5 * across_1) * (vec3(1.0) + (((sum - part) + vec3(1e-20)) / ((sum + part) + vec3(1e-20)))));
}

vec3 conductorReflectance(Surface s_8, float cosine_7) {
    float constants = dot((s_8.eta + s_8.k), vec3(1.0));
    vec3 _e11 = conductorFresnel(cosine_7, s_8.eta, s_8.k);
    return ((constants > 0.0) ? _e11 : s_8.baseColor);
}

vec3 facetReflectance(Surface s_9, float cosine_8, float ratio_2) {
    uint _e3 = kindOf(s_9);
    if ((_e3 == dielectric)) {
        bool _e6 = isThin(s_9);
        float _e7 = glassReflectance(cosine_8, ratio_2, _e6);
        return vec3(_e7);
    }
    if ((_e3 == conductor)) {
        vec3 _e11 = conductorReflectance(s_9, cosine_8);
        return _e11;
    }
    vec3 _e12 = metallicRoughnessF0_(s_9);
    vec3 _e13 = schlick(_e12, cosine_8);
    return _e13;
}

float singleScatteringAlbedo(float cosine_9, float alpha_3) {
    float x = (cosine_9 / (cosine_9 + alpha_3));
    vec4 byAlpha = (vec4(0.887807, 0.309386, -0.270728, 0.0252433) + (x * (vec4(1.08526, -3.21434, -1.87718, 1.61195) + (x * (vec4(-5.18071, 10.7648, 6.30913, -8.09265) + (x * (vec4(7.80474, -12.743, -24.1046, 25.2536) + (x * vec4(-3.60041, 4.60906, 23.1225, -22.9342)))))))));
    float a2_1 = (alpha_3 * alpha_3);
    return min(dot(byAlpha, vec4(1.0, alpha_3, a2_1, (a2_1 * alpha_3))), 1.0);
}

vec3 compensation(Surface s_10, float cosine_10) {
    uint _e2 = kindOf(s_10);
    bool asked = (((uint(s_10.code) & 8u) != 0u) && ((_e2 == conductor) || (_e2 == metallicRoughness)));
    if (!(asked)) {
        return vec3(1.0);
    }
    float _e19 = singleScatteringAlbedo(cosine_10, s_10.alpha);
    vec3 _e22 = facetReflectance(s_10, 1.0, 1.0);
    return (vec3(1.0) + (_e22 * ((1.0 - _e19) / _e19)));
}

FacetLobe evaluateFacets(Surface s_11, vec3 wo_1, vec3 wi) {
    bool crossing_1 = ((wo_1.z < 0.0) != (wi.z < 0.0));
    float _e11 = indexRatio(s_11, wo_1.z);
    vec3 m_1 = (wo_1 + (wi * (crossing_1 ? _e11 : 1.0)));
    float m2_1 = max(dot(m_1, m_1), 1e-20);
    vec3 h_2 = (m_1 * inversesqrt(m2_1));
    float oh = dot(wo_1, h_2);
    float ih = dot(wi, h_2);
    float zo = abs(wo_1.z);
    float zi = abs(wi.z);
    float _e28 = stretched(wo_1, s_11.alpha);
    float _e30 = stretched(wi, s_11.alpha);
    uint _e31 = kindOf(s_11);
    bool isGlass = (_e31 == dielectric);
    float _e35 = reflectionBound(wo_1, s_11.alpha);
    float bound_1 = (isGlass ? 1.0 : _e35);
    bool faces = ((((oh * h_2.z) * wo_1.z) >= 0.0) && (((ih * h_2.z) * wi.z) >= 0.0));
    float _e57 = facetDensity(h_2, s_11.alpha);
    float spread = ((crossing_1 ? (abs((oh * ih)) / m2_1) : 0.25) * (faces ? (2.0 * _e57) : 0.0));
    vec3 _e64 = facetReflectance(s_11, abs(oh), _e11);
    vec3 passes = (crossing_1 ? (vec3(1.0) - _e64) : _e64);
    float masked = (zi / max(((zi * _e28) + (zo * _e30)), 1e-20));
    float chosen = ((isGlass ? passes.x : 1.0) * (crossing_1 ? (_e11 * _e11) : 1.0));
    vec3 _e82 = compensation(s_11, zo);
    return FacetLobe((((passes * _e82) * spread) * masked), ((spread * chosen) / ((bound_1 * zo) + _e28)), abs(oh));
}

vec4 evaluateBsdf(Surface s_12, vec3 wo_2, vec3 wi_1) {
    vec4 value = vec4(0.0);
    vec3 albedo = vec3(0.0);
    uint _e3 = kindOf(s_12);
    bool opaque = (_e3 != dielectric);
    bool dark = (opaque && ((wo_2.z < 0.0) || (wi_1.z <= 0.0)));
    bool _e14 = hasSmoothLobe(s_12);
    if ((dark || (!(opaque) && _e14))) {
        return vec4(0.0);
    }
    float _e21 = facetShare(s_12, wo_2.z);
    albedo = s_12.baseColor;
    if ((_e3 != diffuse)) {
        FacetLobe _e29 = evaluateFacets(s_12, wo_2, wi_1);
        value = (_e14 ? vec4(0.0) : vec4(_e29.value, (_e21 * _e29.pdf)));
        vec3 _e40 = metallicRoughnessDiffuse(s_12, _e29.cosine);
        albedo = ((_e3 == metallicRoughness) ? _e40 : vec3(0.0));
    }
    vec4 _e44 = value;
    vec3 _e45 = albedo;
    value = (_e44 + (vec4(_e45, (1.0 - _e21)) * (0.31830987 * max(wi_1.z, 0.0))));
    vec4 _e59 = value;
    return ((1.0 - s_12.reflectivity) * _e59);
}

BsdfSample deltaSample(vec3 direction, float probability, vec3 weight) {
    return BsdfSample(direction, probability, weight, true);
}

vec3 mirrored(vec3 wo_3) {
    return vec3(-(wo_3.xy), wo_3.z);
}

vec3 sampleCosine(vec2 u) {
    float radius = sqrt(u.x);
    float phi = ((6.2831855 * u.y) - 3.1415927);
    return normalize(vec3((radius * cos(phi)), (radius * sin(phi)), sqrt((1.0 - u.x))));
}

vec3 sampleVisibleNormal(vec3 wo_4, float alpha_4, float bound, vec2 u_1) {
    float _e8 = stretched(wo_4, alpha_4);
    vec3 w_1 = (vec3((alpha_4 * wo_4.xy), wo_4.z) / vec3(_e8));
    float phi_1 = ((6.2831855 * u_1.x) - 3.1415927);
    float drop = (u_1.y * (1.0 + (bound * w_1.z)));
    float sine = sqrt(max((drop * (2.0 - drop)), 0.0));
    vec3 h_3 = (w_1 + vec3((sine * cos(phi_1)), (sine * sin(phi_1)), (1.0 - drop)));
    return normalize(vec3((alpha_4 * h_3.xy), max(h_3.z, 1e-7)));
}

vec3 sampleFacet(Surface s_13, vec3 wo_5, vec2 u_2) {
    float side = ((wo_5.z < 0.0) ? -1.0 : 1.0);
    vec3 up = (wo_5 * side);
    float _e11 = reflectionBound(up, s_13.alpha);
    uint _e12 = kindOf(s_13);
    float bound_2 = ((_e12 == dielectric) ? 1.0 : _e11);
    vec3 _e20 = sampleVisibleNormal(up, max(s_13.alpha, 0.001), bound_2, u_2);
    bool _e25 = hasSmoothLobe(s_13);
    return ((_e25 ? vec3(0.0, 0.0, 1.0) : _e20) * side);
}

vec3 refracted(vec3 wo_6, vec3 h_1, float ratio_3) {
    float cosine_11 = dot(wo_6, h_1);
    float inside_1 = sqrt(max((((ratio_3 - 1.0) * (ratio_3 + 1.0)) + (cosine_11 * cosine_11)), 0.0));
    return ((((cosine_11 - inside_1) * h_1) - wo_6) / vec3(ratio_3));
}

BsdfSample sampleBsdf(Surface s_14, vec3 wo_7, vec3 u_3) {
    vec3 wi_2 = vec3(0.0);
    bool crossing = false;
    if ((u_3.z < s_14.reflectivity)) {
        vec3 _e6 = mirrored(wo_7);
        BsdfSample _e10 = deltaSample(_e6, s_14.reflectivity, vec3(1.0));
        return _e10;
    }
    float base = (1.0 - s_14.reflectivity);
    float choice = ((u_3.z - s_14.reflectivity) / base);
    float _e19 = facetShare(s_14, wo_7.z);
    uint _e20 = kindOf(s_14);
    bool isGlass_1 = (_e20 == dielectric);
    bool specular_1 = (choice < _e19);
    vec3 _e25 = sampleCosine(u_3.xy);
    wi_2 = _e25;
    if (specular_1) {
        vec3 _e30 = sampleFacet(s_14, wo_7, u_3.xy);
        float oh_1 = max(dot(wo_7, _e30), 0.0);
        float _e35 = indexRatio(s_14, wo_7.z);
        vec3 _e36 = facetReflectance(s_14, oh_1, _e35);
        crossing = (isGlass_1 && (choice >= _e36.x));
        vec3 _e40 = refracted(wo_7, _e30, _e35);
        bool _e42 = isThin(s_14);
        vec3 through = (_e42 ? -(wo_7) : _e40);
        bool _e48 = crossing;
        wi_2 = (_e48 ? through : (((2.0 * oh_1) * _e30) - wo_7));
        bool _e50 = hasSmoothLobe(s_14);
        if (_e50) {
            bool _e54 = crossing;
            bool _e55 = isThin(s_14);
            float bent = ((_e54 && !(_e55)) ? (1.0 / (_e35 * _e35)) : 1.0);
            bool _e64 = crossing;
            float probability_1 = (base * (isGlass_1 ? (_e64 ? (1.0 - _e36.x) : _e36.x) : _e19));
            vec3 _e68 = wi_2;
            BsdfSample _e73 = deltaSample(_e68, probability_1, (isGlass_1 ? vec3(bent) : (_e36 / vec3(_e19))));
            return _e73;
        }
    }
    vec3 _e74 = wi_2;
    vec4 _e75 = evaluateBsdf(s_14, wo_7, _e74);
    float _e80 = wi_2.z;
    bool crosses = ((wo_7.z < 0.0) != (_e80 < 0.0));
    bool _e85 = crossing;
    float pdf = ((_e85 != crosses) ? 0.0 : _e75.w);
    vec3 _e89 = wi_2;
    return BsdfSample(_e89, pdf, ((pdf > 0.0) ? (_e75.xyz / vec3(max(pdf, 1e-30))) : vec3(0.0)), false);
}

bool isDelta(Surface s_15) {
    uint _e1 = kindOf(s_15);
    bool noDiffuse = ((_e1 >= conductor) || ((_e1 == metallicRoughness) && (s_15.metallic >= 1.0)));
    bool _e14 = hasSmoothLobe(s_15);
    return ((s_15.reflectivity >= 1.0) || (noDiffuse && _e14));
}

void main() {
    vec4 fragment = gl_FragCoord;
    uvec2 pixel = uvec2(fragment.xy);
    vec4 a_1 = texelFetch(questions, ivec2(uvec2((2u * pixel.x), pixel.y)), 0);
    vec4 b = texelFetch(questions, ivec2(uvec2(((2u * pixel.x) + 1u), pixel.y)), 0);
    Surface _e23 = fetchSurface(uint(a_1.w));
    uint asked_1 = uint(b.w);
    if ((asked_1 == evaluation)) {
        vec4 _e30 = evaluateBsdf(_e23, a_1.xyz, b.xyz);
        _fs2p_location0 = _e30;
        return;
    }
    BsdfSample _e33 = sampleBsdf(_e23, a_1.xyz, b.xyz);
    if ((asked_1 == sampledDirection)) {
        _fs2p_location0 = vec4(_e33.direction, _e33.pdf);
        return;
    }
    bool _e44 = isDelta(_e23);
    _fs2p_location0 = vec4(_e33.weight, ((_e33.delta ? 1.0 : 0.0) + (_e44 ? 2.0 : 0.0)));
    return;
}

