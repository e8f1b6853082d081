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
struct Layers {
    vec3 specularColor;
    float specularWeight;
    vec3 sheenColor;
    float sheenRoughness;
    vec3 beyondColor;
    float beyond;
    vec2 grain;
    float anisotropy;
    float transmission;
    float coat;
    float coatRoughness;
    float ior;
    float solid;
    float film;
    float filmIor;
    float filmThickness;
    float filmLeast;
    float dispersion;
    float spare0_;
    float spare1_;
    float spare2_;
};
struct Outgoing {
    vec3 wo;
    float share;
    float ratio;
    float bound;
    float stretched;
};
struct Stack {
    vec3 wo;
    float side;
    vec3 hero;
    float ratio;
    bool inside;
    vec3 more;
    vec2 alpha;
    float coatAlpha;
    float coat;
    float sheen;
    float sheenColor;
    float ofCoat;
    float ofFacets;
    float ofSheen;
    float ofDiffuse;
    bool drawnByCoat;
};
struct Reflectance {
    vec3 dielectric;
    vec3 metal;
};
struct BsdfSample {
    vec3 direction;
    float pdf;
    vec3 weight;
    bool delta;
};
struct LayeredSample {
    vec3 direction;
    float pdf;
    bool delta;
};
struct Basis {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
};
struct Parting {
    vec3 toward;
    vec3 beyond;
};
struct Pair {
    vec4 toLight;
    BsdfSample drawn;
};
struct FacetLobe {
    vec3 value;
    float pdf;
    float cosine;
};
struct LayeredPair {
    vec4 toLight;
    vec4 toSample;
};
struct Frame {
    vec3 right;
    float width;
    vec3 up;
    float height;
    vec3 forward;
    uint lightCount;
    vec3 horizon;
    uint sampleIndex;
    vec3 zenith;
    uint seed;
    vec2 jitter;
    vec2 dividers;
    uvec4 shapeEnds;
    uint occluderEnd;
    uint ballCount;
    uint emitterCount;
    uint maxDepth;
    uvec4 panels[3];
    vec4 filterPieces[16];
    uint independent;
    uint projection;
    float aperture;
    float focusDistance;
    uint planesCutView;
    float environmentTurn;
    vec2 environmentSize;
    uint sampleCount;
    uint instances;
    uint shares;
    uvec2 tile;
    uint instanceCount;
    uint farEmitters;
    uint lightTree;
    float rowHeight;
    float geometryShare;
    float texelShare;
    uint lightTreeDepth;
    uint lampTables;
    uvec2 origin;
    uint relayRow;
};
struct Facets {
    float value;
    float density;
    float cosine;
};
struct Cover {
    float left;
    vec4 fibres;
};
const uint evaluation = 0u;
const uint sampledDirection = 1u;
const uint metallicRoughness = 1u;
const uint conductor = 2u;
const uint dielectric0_ = 3u;
const uint diffuse0_ = 0u;

uniform highp sampler2D questions;

uniform highp sampler2D sceneTable;

Layers layersHere = Layers(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);

const bool hasLayers = false;

const bool hasMetallicRoughness = false;

vec3 coatNormalHere = vec3(0.0);

const bool hasConductors = false;

const bool hasGlass = false;

Stack stackHere = Stack(vec3(0.0), 0.0, vec3(0.0), 0.0, false, vec3(0.0), vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);

const bool hasTransmission = false;

const bool hasCoats = false;

const bool hasCoatNormals = false;

const bool hasSheen = false;

const bool hasCompensation = false;

const bool hasMirrorLayers = true;

layout(std140) uniform FrameBlock { Frame frame; };

const bool hasIridescence = false;

layout(location = 0) out vec4 _fs2p_location0;

vec4 tableTexel(uint column, uint row) {
    vec4 _e5 = texelFetch(sceneTable, ivec2(uvec2(column, row)), 0);
    return _e5;
}

Surface fetchSurface(uint i) {
    vec4 _e2 = tableTexel(9u, i);
    vec4 _e4 = tableTexel(10u, i);
    vec4 _e6 = tableTexel(11u, i);
    vec4 _e8 = tableTexel(12u, i);
    vec4 _e10 = tableTexel(13u, i);
    return Surface(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.xyz, _e10.w);
}

uint kindOf(uint code) {
    return (code & 3u);
}

bool isMetallicRoughness(uint code_1) {
    const bool _e2 = hasMetallicRoughness;
    uint _e3 = kindOf(code_1);
    return pick(_e2, (_e3 == metallicRoughness), false);
}

bool isLayered(uint code_2) {
    const bool _e2 = hasLayers;
    bool _e3 = isMetallicRoughness(code_2);
    return pick(_e2, _e3, false);
}

Layers fetchLayers(uint i_1) {
    vec4 _e2 = tableTexel(0u, i_1);
    vec4 _e4 = tableTexel(1u, i_1);
    vec4 _e6 = tableTexel(2u, i_1);
    vec4 _e8 = tableTexel(3u, i_1);
    vec4 _e10 = tableTexel(4u, i_1);
    vec4 _e12 = tableTexel(5u, i_1);
    vec4 _e14 = tableTexel(6u, i_1);
    return Layers(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xy, _e8.z, _e8.w, _e10.x, _e10.y, _e10.z, _e10.w, _e12.x, _e12.y, _e12.z, _e12.w, _e14.x, _e14.y, _e14.z, _e14.w);
}

Layers layersOf(uint code_3, float eta) {
    Layers l = Layers(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    l.specularColor = vec3(1.0);
    l.specularWeight = 1.0;
    l.ior = 1.5;
    bool _e10 = isLayered(code_3);
    if (pick(_e10, (eta != 0.0), false)) {
        Layers _e16 = fetchLayers(uint(abs(eta)));
        l = _e16;
    }
    Layers _e17 = l;
    return _e17;
}

bool isConductor(uint code_4) {
    const bool _e2 = hasConductors;
    uint _e3 = kindOf(code_4);
    return pick(_e2, (_e3 == conductor), false);
}

bool isDielectric(uint code_5) {
    const bool _e2 = hasGlass;
    uint _e3 = kindOf(code_5);
    return pick(_e2, (_e3 == dielectric0_), false);
}

vec2 ellipticAlpha(float alpha, float strength) {
    return pick((strength > 0.0), vec2(mix(alpha, 1.0, (strength * strength)), max(alpha, 0.001)), vec2(alpha));
}

float dispersedIndex(float ior, float dispersion, vec3 hero) {
    float side_2 = (pick((hero.z > 0.0), 1.0, 0.0) - pick((hero.x > 0.0), 1.0, 0.0));
    return max((ior + (((side_2 * (ior - 1.0)) * 0.025) * dispersion)), 1.0);
}

vec3 schlick(vec3 f0_, float cosine) {
    float m = max((1.0 - cosine), 0.0);
    float m2_ = (m * m);
    return (f0_ + ((vec3(1.0) - f0_) * ((m2_ * m2_) * m)));
}

float coatReflectance(float coat, float cosine_1) {
    vec3 _e4 = schlick(vec3(0.04), cosine_1);
    return (coat * _e4.x);
}

vec3 coatNormal(float side) {
    vec3 _e2 = coatNormalHere;
    float _e7 = coatNormalHere.z;
    return vec3((side * _e2.xy), _e7);
}

float coatCosine(float side_1, vec3 w) {
    float z = 0.0;
    z = w.z;
    const bool _e5 = hasCoatNormals;
    if (_e5) {
        vec3 _e6 = coatNormal(side_1);
        z = dot(_e6, w);
    }
    float _e8 = z;
    return abs(_e8);
}

float greatest(vec3 v) {
    return max(max(v.x, v.y), v.z);
}

float sheenAlbedo(float cosine_2, float roughness) {
    float u_6 = (((sqrt(sqrt(clamp(cosine_2, 0.0001, 1.0))) - 0.1) / 0.45) - 1.0);
    float v_4 = (((sqrt(max(roughness, 0.07)) - 0.264575) / 0.367712) - 1.0);
    vec3 low = (vec3(0.746962, 0.0397496, 0.224802) + (u_6 * (vec3(-0.448339, 0.3406, -0.509736) + (u_6 * (vec3(-0.196284, 0.0161825, -0.50469) + (u_6 * (vec3(0.0587112, 0.187983, 0.191769) + (u_6 * (vec3(-0.182064, 0.425384, 0.971703) + (u_6 * (vec3(0.0763965, -0.331055, 0.616069) + (u_6 * (vec3(0.0893496, -0.409073, -0.445006) + (u_6 * vec3(-0.0525425, 0.0277158, -0.421496)))))))))))))));
    vec3 high = (vec3(-0.0321953, -0.190573, 0.0715297) + (u_6 * (vec3(0.492365, -0.201291, -0.00570256) + (u_6 * (vec3(0.833264, 0.765625, -1.06831) + (u_6 * (vec3(-1.29238, 0.71056, 0.237437) + (u_6 * (vec3(-2.81818, -0.673857, 2.17806) + (u_6 * (vec3(0.500911, -0.777981, 0.0143213) + (u_6 * (vec3(1.97956, 0.108218, -1.28939) + (u_6 * vec3(0.324871, 0.21472, -0.194708)))))))))))))));
    float v2_ = (v_4 * v_4);
    float root = dot((low + ((v2_ * v_4) * high)), vec3(1.0, v_4, v2_));
    float albedo = (root * root);
    return (albedo + (0.005 * max(albedo, 1.0)));
}

vec3 dielectricF0_() {
    float _e2 = layersHere.ior;
    float _e7 = layersHere.ior;
    float contrast = ((_e2 - 1.0) / (_e7 + 1.0));
    vec3 _e14 = layersHere.specularColor;
    return min(((contrast * contrast) * _e14), vec3(1.0));
}

float singleScatteringAlbedo(float cosine_3, float alpha_1) {
    float x_1 = (cosine_3 / (cosine_3 + alpha_1));
    vec4 byAlpha = (vec4(0.887807, 0.309386, -0.270728, 0.0252433) + (x_1 * (vec4(1.08526, -3.21434, -1.87718, 1.61195) + (x_1 * (vec4(-5.18071, 10.7648, 6.30913, -8.09265) + (x_1 * (vec4(7.80474, -12.743, -24.1046, 25.2536) + (x_1 * vec4(-3.60041, 4.60906, 23.1225, -22.9342)))))))));
    float a2_ = (alpha_1 * alpha_1);
    return min(dot(byAlpha, vec4(1.0, alpha_1, a2_, (a2_ * alpha_1))), 1.0);
}

float cosineInAir(float cosine_4, float ratio) {
    float sine2_ = ((1.0 - (cosine_4 * cosine_4)) / (ratio * ratio));
    return pick((ratio < 1.0), sqrt(max((1.0 - sine2_), 0.0)), cosine_4);
}

float outerCosine(float cosine_5) {
    float outer = 0.0;
    outer = cosine_5;
    const bool _e3 = hasTransmission;
    if (_e3) {
        float _e6 = stackHere.ratio;
        float _e7 = cosineInAir(cosine_5, _e6);
        outer = _e7;
    }
    float _e8 = outer;
    return _e8;
}

bool reflectsAll(float cosine_6, float ratio_1) {
    return pick((ratio_1 < 1.0), ((1.0 - (cosine_6 * cosine_6)) >= (ratio_1 * ratio_1)), false);
}

Reflectance bareReflectance(Surface s, float cosine_7) {
    vec3 dielectric = vec3(0.0);
    float _e2 = outerCosine(cosine_7);
    float _e5 = layersHere.specularWeight;
    vec3 _e6 = dielectricF0_();
    vec3 _e7 = schlick(_e6, _e2);
    dielectric = (_e5 * _e7);
    const bool _e11 = hasTransmission;
    if (_e11) {
        vec3 _e12 = dielectric;
        float _e17 = stackHere.ratio;
        bool _e18 = reflectsAll(cosine_7, _e17);
        dielectric = pick(_e18, vec3(1.0), _e12);
    }
    vec3 _e20 = dielectric;
    vec3 _e22 = schlick(s.baseColor, _e2);
    return Reflectance(_e20, _e22);
}

float mean3_(vec3 v_1) {
    return dot(v_1, vec3(0.33333334));
}

void meetLayers(Surface s_1, vec3 given, vec3 hero_1) {
    float side_3 = pick((given.z < 0.0), -1.0, 1.0);
    vec3 wo_8 = vec3(given.xy, (given.z * side_3));
    float metallic_3 = s_1.metallic;
    stackHere.wo = wo_8;
    stackHere.side = side_3;
    stackHere.hero = hero_1;
    stackHere.inside = false;
    stackHere.ratio = 1.0;
    float _e31 = layersHere.anisotropy;
    vec2 _e32 = ellipticAlpha(s_1.alpha, _e31);
    stackHere.alpha = _e32;
    const bool _e34 = hasTransmission;
    if (_e34) {
        float _e37 = layersHere.solid;
        bool isSolid = (_e37 > 0.0);
        bool inside = pick(isSolid, (side_3 < 0.0), false);
        float _e45 = layersHere.ior;
        float _e48 = layersHere.dispersion;
        float _e49 = dispersedIndex(_e45, _e48, hero_1);
        float _e52 = layersHere.transmission;
        bool flat_ = pick(pick(isSolid, (_e52 > 0.0), false), ((_e49 - 1.0) < 0.001), false);
        stackHere.inside = inside;
        stackHere.ratio = pick(isSolid, pick(inside, (1.0 / _e49), _e49), 1.0);
        vec2 _e74 = stackHere.alpha;
        stackHere.alpha = pick(flat_, vec2(0.0), _e74);
    }
    stackHere.coat = 0.0;
    const bool _e82 = hasCoats;
    if (_e82) {
        float _e87 = layersHere.coat;
        float _e88 = coatCosine(side_3, wo_8);
        float _e89 = coatReflectance(_e87, _e88);
        bool _e92 = stackHere.inside;
        stackHere.coat = pick(_e92, 0.0, _e89);
        float _e99 = layersHere.coatRoughness;
        float _e102 = layersHere.coatRoughness;
        stackHere.coatAlpha = (_e99 * _e102);
    }
    stackHere.sheenColor = 0.0;
    stackHere.sheen = 0.0;
    const bool _e111 = hasSheen;
    if (_e111) {
        vec3 _e116 = layersHere.sheenColor;
        float _e117 = greatest(_e116);
        stackHere.sheenColor = _e117;
        float _e120 = stackHere.sheenColor;
        if ((_e120 > 0.0)) {
            float _e128 = layersHere.sheenRoughness;
            float _e129 = sheenAlbedo(wo_8.z, _e128);
            bool _e132 = stackHere.inside;
            stackHere.sheen = pick(_e132, 0.0, _e129);
        }
    }
    float _e137 = layersHere.specularWeight;
    vec3 _e138 = dielectricF0_();
    vec3 f0_3 = (_e137 * _e138);
    stackHere.more = vec3(1.0);
    const bool _e145 = hasCompensation;
    if (_e145) {
        float _e150 = stackHere.alpha.x;
        float _e154 = stackHere.alpha.y;
        float _e157 = singleScatteringAlbedo(wo_8.z, sqrt((_e150 * _e154)));
        float _e166 = layersHere.transmission;
        bool asked = pick(((uint(s_1.code) & 8u) != 0u), (_e166 <= 0.0), false);
        stackHere.more = pick(asked, (vec3(1.0) + (mix(f0_3, s_1.baseColor, metallic_3) * ((1.0 - _e157) / _e157))), vec3(1.0));
    }
    Reflectance _e185 = bareReflectance(s_1, wo_8.z);
    vec3 met_1 = mix(_e185.dielectric, _e185.metal, metallic_3);
    float _e192 = greatest(_e185.dielectric);
    float enters = ((1.0 - metallic_3) * (1.0 - _e192));
    float _e197 = mean3_(s_1.baseColor);
    float coat_1 = stackHere.coat;
    float _e205 = stackHere.sheenColor;
    float _e208 = stackHere.sheen;
    float below = ((1.0 - coat_1) * (1.0 - (_e205 * min(_e208, 1.0))));
    float _e215 = mean3_(met_1);
    float _e218 = layersHere.film;
    float _e224 = layersHere.transmission;
    float facets = (below * ((_e215 + (0.25 * _e218)) + ((enters * _e224) * _e197)));
    float _e233 = stackHere.sheen;
    vec3 _e237 = layersHere.sheenColor;
    float _e238 = mean3_(_e237);
    float fibres = (((1.0 - coat_1) * _e233) * _e238);
    float _e243 = greatest(f0_3);
    float _e249 = layersHere.transmission;
    float body = (((below * (1.0 - metallic_3)) * (1.0 - _e243)) * (1.0 - _e249));
    float _e255 = layersHere.beyond;
    float diffuse = ((body * (1.0 - _e255)) * _e197);
    float _e262 = layersHere.beyond;
    vec3 _e266 = layersHere.beyondColor;
    float _e267 = mean3_(_e266);
    float beyond = ((body * _e262) * _e267);
    float all_ = max(((((coat_1 + facets) + fibres) + diffuse) + beyond), 1e-20);
    stackHere.ofCoat = (coat_1 / all_);
    stackHere.ofFacets = (facets / all_);
    stackHere.ofSheen = (fibres / all_);
    stackHere.ofDiffuse = (diffuse / all_);
    return;
}

vec3 metallicRoughnessF0_(vec3 baseColor, float metallic) {
    return mix(vec3(0.04), baseColor, metallic);
}

vec3 metallicRoughnessDiffuse(vec3 baseColor_1, float metallic_1, float cosine_8) {
    vec3 _e7 = schlick(vec3(0.04), cosine_8);
    return (((1.0 - metallic_1) * (1.0 - _e7.x)) * baseColor_1);
}

float specularShare(vec3 baseColor_2, float metallic_2, float cosine_9) {
    vec3 _e3 = metallicRoughnessF0_(baseColor_2, metallic_2);
    vec3 _e4 = schlick(_e3, cosine_9);
    float specular = dot(_e4, vec3(1.0));
    vec3 _e9 = metallicRoughnessDiffuse(baseColor_2, metallic_2, 1.0);
    float diffuse_1 = dot(_e9, vec3(1.0));
    return (specular / max((specular + diffuse_1), 1e-20));
}

float indexRatio(float eta_1, float z_1, bool thin) {
    return pick(pick((z_1 < 0.0), !(thin), false), (1.0 / eta_1), eta_1);
}

bool isThin(uint code_6) {
    const bool _e2 = hasGlass;
    return pick(_e2, ((code_6 & 7u) == 7u), false);
}

float reflectionBound(vec3 wo, float alpha_2) {
    float s_14 = (1.0 + length(wo.xy));
    float s2_ = (s_14 * s_14);
    float a2_1 = (alpha_2 * alpha_2);
    return (((1.0 - a2_1) * s2_) / (s2_ + ((a2_1 * wo.z) * wo.z)));
}

float stretched(vec3 w_1, float alpha_3) {
    return sqrt(((w_1.z * w_1.z) + ((alpha_3 * alpha_3) * dot(w_1.xy, w_1.xy))));
}

Outgoing outgoing(Surface s_2, vec3 wo_1, vec3 hero_2) {
    Outgoing o = Outgoing(vec3(0.0), 0.0, 0.0, 0.0, 0.0);
    uint code_9 = uint(s_2.code);
    bool _e5 = isConductor(code_9);
    bool _e6 = isDielectric(code_9);
    o = Outgoing(wo_1, pick(pick(_e5, true, _e6), 1.0, 0.0), 1.0, 1.0, 1.0);
    const bool _e17 = hasLayers;
    if (_e17) {
        bool _e18 = isLayered(code_9);
        if (_e18) {
            meetLayers(s_2, wo_1, hero_2);
        }
    }
    const bool _e20 = hasMetallicRoughness;
    if (_e20) {
        const bool _e22 = hasLayers;
        if (!(_e22)) {
            float _e26 = o.share;
            float _e30 = specularShare(s_2.baseColor, s_2.metallic, wo_1.z);
            bool _e31 = isMetallicRoughness(code_9);
            o.share = pick(_e31, _e30, _e26);
        }
    }
    const bool _e34 = hasGlass;
    if (_e34) {
        bool _e39 = isThin(code_9);
        float _e40 = indexRatio(s_2.eta.x, wo_1.z, _e39);
        bool _e41 = isDielectric(code_9);
        o.ratio = pick(_e41, _e40, 1.0);
    }
    const bool _e45 = hasConductors;
    const bool _e47 = hasMetallicRoughness;
    const bool _e49 = hasLayers;
    const bool _e54 = hasGlass;
    if (pick(pick(_e45, true, pick(_e47, !(_e49), false)), true, _e54)) {
        float _e58 = reflectionBound(wo_1, s_2.alpha);
        bool _e59 = isDielectric(code_9);
        o.bound = pick(_e59, 1.0, _e58);
        float _e64 = stretched(wo_1, s_2.alpha);
        o.stretched = _e64;
    }
    Outgoing _e65 = o;
    return _e65;
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

bool isSmooth(uint code_7) {
    return ((code_7 & 32u) != 0u);
}

vec3 sampleVisibleNormal(vec3 wo_2, float alpha_4, float bound, vec2 u_1) {
    float _e8 = stretched(wo_2, alpha_4);
    vec3 w_3 = (vec3((alpha_4 * wo_2.xy), wo_2.z) / vec3(_e8));
    float phi_1 = ((6.2831855 * u_1.x) - 3.1415927);
    float drop = (u_1.y * (1.0 + (bound * w_3.z)));
    float sine = sqrt(max((drop * (2.0 - drop)), 0.0));
    vec3 h_4 = (w_3 + vec3((sine * cos(phi_1)), (sine * sin(phi_1)), (1.0 - drop)));
    return normalize(vec3((alpha_4 * h_4.xy), max(h_4.z, 1e-7)));
}

vec3 sampleFacet(float alpha_5, bool isMirror, Outgoing o_1, vec2 u_2) {
    float side_4 = pick((o_1.wo.z < 0.0), -1.0, 1.0);
    vec3 _e16 = sampleVisibleNormal((o_1.wo * side_4), max(alpha_5, 0.001), o_1.bound, u_2);
    return (pick(isMirror, vec3(0.0, 0.0, 1.0), _e16) * side_4);
}

vec3 conductorFresnel(float cosine_10, vec3 eta_2, vec3 k) {
    float cosine2_ = (cosine_10 * cosine_10);
    float sine2_1 = (1.0 - cosine2_);
    vec3 difference_1 = (((eta_2 * eta_2) - (k * k)) - vec3(sine2_1));
    vec3 a2PlusB2_ = sqrt(((difference_1 * difference_1) + ((((4.0 * eta_2) * eta_2) * k) * k)));
    vec3 larger = sqrt(((0.5 * (a2PlusB2_ + abs(difference_1))) + vec3(1e-20)));
    vec3 smaller = ((eta_2 * k) / larger);
    vec3 a = mix(smaller, larger, greaterThan(difference_1, vec3(0.0)));
    vec3 b_2 = mix(larger, smaller, greaterThan(difference_1, vec3(0.0)));
    vec3 b2_ = ((b_2 * b_2) + vec3(1e-20));
    vec3 acrossFar = (a + vec3(cosine_10));
    vec3 acrossNear = (a - vec3(cosine_10));
    vec3 across = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a * cosine_10) + vec3(sine2_1));
    vec3 alongNear = ((a * cosine_10) - vec3(sine2_1));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor_3, vec3 eta_3, vec3 k_1, float cosine_11) {
    float constants = dot((eta_3 + k_1), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_11, eta_3, k_1);
    return pick((constants > 0.0), _e8, baseColor_3);
}

float dielectricFresnel(float cosine_12, float ratio_2) {
    float inside2_ = (((ratio_2 - 1.0) * (ratio_2 + 1.0)) + (cosine_12 * cosine_12));
    float inside_1 = sqrt(max(inside2_, 0.0));
    float across_1 = ((cosine_12 - inside_1) / (cosine_12 + inside_1));
    float along = ((((ratio_2 * ratio_2) * cosine_12) - inside_1) / (((ratio_2 * ratio_2) * cosine_12) + inside_1));
    return pick((inside2_ > 0.0), (0.5 * ((across_1 * across_1) + (along * along))), 1.0);
}

float glassReflectance(float cosine_13, float ratio_3, bool thin_1) {
    float _e3 = dielectricFresnel(cosine_13, ratio_3);
    return pick(thin_1, ((2.0 * _e3) / (1.0 + _e3)), _e3);
}

vec3 facetReflectance(Surface s_3, float cosine_14, float ratio_4) {
    vec3 reflectance = vec3(0.0);
    uint code_10 = uint(s_3.code);
    const bool _e9 = hasMetallicRoughness;
    if (_e9) {
        const bool _e11 = hasLayers;
        if (!(_e11)) {
            vec3 _e15 = metallicRoughnessF0_(s_3.baseColor, s_3.metallic);
            vec3 _e16 = schlick(_e15, cosine_14);
            reflectance = _e16;
        }
    }
    const bool _e18 = hasConductors;
    if (_e18) {
        vec3 _e19 = reflectance;
        vec3 _e23 = conductorReflectance(s_3.baseColor, s_3.eta, s_3.k, cosine_14);
        bool _e24 = isConductor(code_10);
        reflectance = pick(_e24, _e23, _e19);
    }
    const bool _e27 = hasGlass;
    if (_e27) {
        vec3 _e28 = reflectance;
        bool _e29 = isThin(code_10);
        float _e30 = glassReflectance(cosine_14, ratio_4, _e29);
        bool _e32 = isDielectric(code_10);
        reflectance = pick(_e32, vec3(_e30), _e28);
    }
    vec3 _e34 = reflectance;
    return _e34;
}

vec3 refracted(vec3 wo_3, vec3 h, float ratio_5) {
    float cosine_19 = dot(wo_3, h);
    float inside_2 = sqrt(max((((ratio_5 - 1.0) * (ratio_5 + 1.0)) + (cosine_19 * cosine_19)), 0.0));
    return ((((cosine_19 - inside_2) * h) - wo_3) / vec3(ratio_5));
}

bool isSolidHere() {
    const bool _e1 = hasTransmission;
    float _e4 = layersHere.solid;
    return pick(_e1, (_e4 > 0.0), false);
}

Basis basisAbout(vec3 n) {
    float side_5 = pick((n.z >= 0.0), 1.0, -1.0);
    float a_1 = (-1.0 / (side_5 + n.z));
    float b_3 = ((n.x * n.y) * a_1);
    return Basis(vec3((1.0 + (((side_5 * n.x) * n.x) * a_1)), (side_5 * b_3), (-(side_5) * n.x)), vec3(b_3, (side_5 + ((n.y * n.y) * a_1)), -(n.y)), n);
}

vec3 toLocal(Basis b, vec3 v_2) {
    return vec3(dot(v_2, b.tangent), dot(v_2, b.bitangent), dot(v_2, b.normal));
}

float ellipticBound(vec3 wo_4, vec2 alpha_6) {
    float s_15 = (1.0 + length(wo_4.xy));
    float s2_1 = (s_15 * s_15);
    float least = min(alpha_6.x, alpha_6.y);
    float a2_2 = (least * least);
    return (((1.0 - a2_2) * s2_1) / (s2_1 + ((a2_2 * wo_4.z) * wo_4.z)));
}

float ellipticStretched(vec3 w_2, vec2 alpha_7) {
    vec2 scaled = (alpha_7 * w_2.xy);
    return sqrt(((w_2.z * w_2.z) + dot(scaled, scaled)));
}

vec3 sampleEllipticNormal(vec3 wo_5, vec2 alpha_8, float bound_1, vec2 u_3) {
    float _e8 = ellipticStretched(wo_5, alpha_8);
    vec3 w_4 = (vec3((alpha_8 * wo_5.xy), wo_5.z) / vec3(_e8));
    float phi_2 = ((6.2831855 * u_3.x) - 3.1415927);
    float drop_1 = (u_3.y * (1.0 + (bound_1 * w_4.z)));
    float sine_1 = sqrt(max((drop_1 * (2.0 - drop_1)), 0.0));
    vec3 h_5 = (w_4 + vec3((sine_1 * cos(phi_2)), (sine_1 * sin(phi_2)), (1.0 - drop_1)));
    return normalize(vec3((alpha_8 * h_5.xy), max(h_5.z, 1e-7)));
}

vec3 toWorld(Basis b_1, vec3 v_3) {
    return (((v_3.x * b_1.tangent) + (v_3.y * b_1.bitangent)) + (v_3.z * b_1.normal));
}

Parting partingOf(Surface s_4, Reflectance r) {
    Parting parting = Parting(vec3(0.0), vec3(0.0));
    vec3 toward = mix(r.dielectric, r.metal, s_4.metallic);
    parting = Parting(toward, vec3(0.0));
    const bool _e11 = hasTransmission;
    if (_e11) {
        float _e16 = greatest(r.dielectric);
        float enters_1 = ((1.0 - s_4.metallic) * (1.0 - _e16));
        vec3 _e24 = stackHere.hero;
        bool _e27 = stackHere.inside;
        float _e32 = layersHere.transmission;
        vec3 _e38 = stackHere.hero;
        parting = Parting((toward * pick(_e27, _e24, vec3(1.0))), (((enters_1 * _e32) * s_4.baseColor) * _e38));
    }
    Parting _e41 = parting;
    return _e41;
}

float shareToward(Surface s_5, Reflectance bare) {
    Parting _e2 = partingOf(s_5, bare);
    float _e4 = mean3_(_e2.toward);
    float _e6 = mean3_(_e2.beyond);
    float _e13 = layersHere.film;
    return pick((_e6 > 0.0), mix((_e4 / max((_e4 + _e6), 1e-20)), 0.5, (0.5 * _e13)), 1.0);
}

LayeredSample sampleLayered(Surface s_6, vec3 u_4) {
    Basis own = Basis(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0));
    vec3 ownWo = vec3(0.0);
    vec3 h_1 = vec3(0.0);
    vec3 met = vec3(0.0);
    bool crossing = false;
    bool lost = false;
    LayeredSample drawn = LayeredSample(vec3(0.0), 0.0, false);
    vec3 wo_9 = stackHere.wo;
    bool _e5 = isSolidHere();
    const bool _e7 = hasCoats;
    float _e11 = stackHere.ofCoat;
    bool isCoat_1 = pick(_e7, (u_4.z < _e11), false);
    float _e17 = stackHere.ofCoat;
    float _e20 = stackHere.ofFacets;
    bool isFacet = (u_4.z < (_e17 + _e20));
    stackHere.drawnByCoat = isCoat_1;
    vec2 _e27 = stackHere.alpha;
    float _e30 = stackHere.coatAlpha;
    vec2 alpha_14 = pick(isCoat_1, vec2(_e30), _e27);
    bool isSmooth_1 = (max(alpha_14.x, alpha_14.y) < 0.001);
    vec2 wide = max(alpha_14, vec2(0.001));
    const bool _e56 = hasCoatNormals;
    if (_e56) {
        if (isCoat_1) {
            float _e59 = stackHere.side;
            vec3 _e60 = coatNormal(_e59);
            Basis _e61 = basisAbout(_e60);
            own = _e61;
        }
    }
    ownWo = wo_9;
    const bool _e64 = hasCoatNormals;
    if (_e64) {
        Basis _e65 = own;
        vec3 _e66 = toLocal(_e65, wo_9);
        ownWo = _e66;
    }
    vec3 _e67 = ownWo;
    float _e68 = ellipticBound(_e67, wide);
    float bound_2 = pick(pick(_e5, !(isCoat_1), false), 1.0, _e68);
    vec3 _e73 = ownWo;
    vec3 _e75 = sampleEllipticNormal(_e73, wide, bound_2, u_4.xy);
    h_1 = pick(isSmooth_1, vec3(0.0, 0.0, 1.0), _e75);
    const bool _e83 = hasCoatNormals;
    if (_e83) {
        Basis _e84 = own;
        vec3 _e85 = h_1;
        vec3 _e86 = toWorld(_e84, _e85);
        h_1 = _e86;
    }
    vec3 _e87 = h_1;
    float oh = max(dot(wo_9, _e87), 0.0);
    vec3 _e93 = h_1;
    vec3 reflected = (((2.0 * oh) * _e93) - wo_9);
    met = reflected;
    const bool _e100 = hasTransmission;
    if (_e100) {
        float _e104 = stackHere.ofCoat;
        float _e108 = stackHere.ofFacets;
        float left = ((u_4.z - _e104) / max(_e108, 1e-20));
        Reflectance _e113 = bareReflectance(s_6, oh);
        float _e114 = shareToward(s_6, _e113);
        crossing = pick(!(isCoat_1), (left >= _e114), false);
        vec3 _e121 = h_1;
        float _e124 = stackHere.ratio;
        vec3 _e125 = refracted(wo_9, _e121, _e124);
        vec3 beyond_1 = pick(_e5, _e125, vec3(reflected.xy, -(reflected.z)));
        bool _e127 = crossing;
        met = pick(_e127, beyond_1, reflected);
    }
    bool _e130 = crossing;
    float _e132 = met.z;
    lost = pick(!(isSmooth_1), (_e130 != (_e132 < 0.0)), false);
    const bool _e139 = hasCoatNormals;
    if (_e139) {
        if (isCoat_1) {
            vec3 _e141 = own.normal;
            vec3 _e142 = met;
            float _e147 = met.z;
            lost = pick((dot(_e141, _e142) <= 0.0), true, pick((_e147 < 0.0), (s_6.eta.x < 0.0), false));
        }
    }
    vec3 _e156 = met;
    bool _e157 = lost;
    drawn = LayeredSample(_e156, pick(_e157, 0.0, 1.0), isSmooth_1);
    if (!(isFacet)) {
        float _e167 = stackHere.ofCoat;
        float _e171 = stackHere.ofFacets;
        float next = ((u_4.z - _e167) - _e171);
        float sine_2 = sqrt(max((u_4.x * (2.0 - u_4.x)), 0.0));
        float phi_3 = ((6.2831855 * u_4.y) - 3.1415927);
        vec3 even = vec3((sine_2 * cos(phi_3)), (sine_2 * sin(phi_3)), (1.0 - u_4.x));
        vec3 _e195 = sampleCosine(u_4.xy);
        const bool _e201 = hasTransmission;
        float _e204 = stackHere.ofSheen;
        float _e207 = stackHere.ofDiffuse;
        vec3 below_1 = vec3(_e195.xy, pick(pick(_e201, (next >= (_e204 + _e207)), false), -(_e195.z), _e195.z));
        const bool _e214 = hasSheen;
        float _e217 = stackHere.ofSheen;
        drawn = LayeredSample(pick(pick(_e214, (next < _e217), false), even, below_1), 1.0, false);
    }
    float _e226 = drawn.direction.z;
    float _e229 = stackHere.side;
    drawn.direction.z = (_e226 * _e229);
    LayeredSample _e231 = drawn;
    return _e231;
}

vec3 mirrored(vec3 wo_6) {
    return vec3(-(wo_6.xy), wo_6.z);
}

BsdfSample sampleLobe(Surface s_7, Outgoing o_2, vec3 u_5) {
    BsdfSample drawn_1 = BsdfSample(vec3(0.0), 0.0, vec3(0.0), false);
    vec3 wi = vec3(0.0);
    float probability = 0.0;
    vec3 weight = vec3(0.0);
    vec3 wo_10 = o_2.wo;
    float _e5 = mirrorShare(s_7.reflectivity);
    float base_1 = (1.0 - _e5);
    float choice = ((u_5.z - _e5) / base_1);
    vec3 _e12 = sampleCosine(u_5.xy);
    drawn_1 = BsdfSample(_e12, 1.0, vec3(1.0), false);
    const bool _e20 = hasConductors;
    const bool _e22 = hasMetallicRoughness;
    const bool _e24 = hasLayers;
    const bool _e29 = hasGlass;
    if (pick(pick(_e20, true, pick(_e22, !(_e24), false)), true, _e29)) {
        uint code_11 = uint(s_7.code);
        bool _e33 = isDielectric(code_11);
        bool _e34 = isSmooth(code_11);
        vec3 _e37 = sampleFacet(s_7.alpha, _e34, o_2, u_5.xy);
        float oh_1 = max(dot(wo_10, _e37), 0.0);
        vec3 _e42 = facetReflectance(s_7, oh_1, o_2.ratio);
        bool crossing_2 = pick(_e33, (choice >= _e42.x), false);
        wi = (((2.0 * oh_1) * _e37) - wo_10);
        probability = (base_1 * o_2.share);
        weight = (_e42 / vec3(o_2.share));
        const bool _e59 = hasGlass;
        if (_e59) {
            bool _e60 = isThin(code_11);
            vec3 _e61 = wi;
            vec3 _e63 = refracted(wo_10, _e37, o_2.ratio);
            wi = pick(crossing_2, pick(_e60, -(wo_10), _e63), _e61);
            float _e67 = probability;
            probability = pick(_e33, (base_1 * pick(crossing_2, (1.0 - _e42.x), _e42.x)), _e67);
            vec3 _e75 = weight;
            weight = pick(_e33, vec3(pick(pick(crossing_2, !(_e60), false), (1.0 / (o_2.ratio * o_2.ratio)), 1.0)), _e75);
        }
        float _e92 = wi.z;
        bool lost_1 = pick(!(_e34), (crossing_2 != ((wo_10.z < 0.0) != (_e92 < 0.0))), false);
        bool specular_1 = (choice < o_2.share);
        vec3 _e102 = drawn_1.direction;
        vec3 _e103 = wi;
        drawn_1.direction = pick(specular_1, _e103, _e102);
        float _e107 = drawn_1.pdf;
        float _e108 = probability;
        drawn_1.pdf = pick(specular_1, pick(lost_1, 0.0, _e108), _e107);
        vec3 _e114 = drawn_1.weight;
        vec3 _e115 = weight;
        drawn_1.weight = pick(specular_1, _e115, _e114);
        drawn_1.delta = pick(specular_1, _e34, false);
    }
    const bool _e120 = hasLayers;
    if (_e120) {
        bool _e123 = isLayered(uint(s_7.code));
        if (_e123) {
            LayeredSample _e126 = sampleLayered(s_7, vec3(u_5.xy, choice));
            drawn_1 = BsdfSample(_e126.direction, (base_1 * _e126.pdf), vec3(0.0), _e126.delta);
        }
    }
    const bool _e135 = hasMirrorLayers;
    if (_e135) {
        bool reflected_1 = (u_5.z < _e5);
        vec3 _e140 = drawn_1.direction;
        vec3 _e141 = mirrored(wo_10);
        drawn_1.direction = pick(reflected_1, _e141, _e140);
        float _e145 = drawn_1.pdf;
        drawn_1.pdf = pick(reflected_1, _e5, _e145);
        vec3 _e149 = drawn_1.weight;
        drawn_1.weight = pick(reflected_1, vec3(1.0), _e149);
        bool _e155 = drawn_1.delta;
        drawn_1.delta = pick(_e155, true, reflected_1);
    }
    BsdfSample _e157 = drawn_1;
    return _e157;
}

float facetDensity(vec3 h_2, float alpha_9) {
    float slope = max(((dot(h_2.xy, h_2.xy) / (alpha_9 * alpha_9)) + (h_2.z * h_2.z)), 1.0);
    return (0.31830987 / (((alpha_9 * alpha_9) * slope) * slope));
}

bool hidesApart(uint code_8) {
    return ((code_8 & 64u) != 0u);
}

vec3 compensation(Surface s_8, float cosine_15) {
    uint code_12 = uint(s_8.code);
    bool _e8 = isDielectric(code_12);
    bool asked_1 = pick(((code_12 & 8u) != 0u), !(_e8), false);
    float _e12 = singleScatteringAlbedo(cosine_15, s_8.alpha);
    vec3 _e17 = facetReflectance(s_8, 1.0, 1.0);
    return pick(asked_1, (vec3(1.0) + (_e17 * ((1.0 - _e12) / _e12))), vec3(1.0));
}

FacetLobe evaluateFacets(Surface s_9, Outgoing o_3, vec3 wi_1) {
    vec3 passes = vec3(0.0);
    vec3 wo_11 = o_3.wo;
    bool _e6 = isDielectric(uint(s_9.code));
    const bool _e8 = hasGlass;
    bool crossing_3 = pick(_e8, ((wo_11.z < 0.0) != (wi_1.z < 0.0)), false);
    vec3 m_1 = (wo_11 + (wi_1 * pick(crossing_3, o_3.ratio, 1.0)));
    float m2_1 = max(dot(m_1, m_1), 1e-20);
    vec3 h_6 = (m_1 * inversesqrt(m2_1));
    float oh_2 = dot(wo_11, h_6);
    float ih = dot(wi_1, h_6);
    float zo = abs(wo_11.z);
    float zi = abs(wi_1.z);
    bool faces = pick(!(crossing_3), true, pick((((oh_2 * h_6.z) * wo_11.z) >= 0.0), (((ih * h_6.z) * wi_1.z) >= 0.0), false));
    float _e54 = facetDensity(h_6, s_9.alpha);
    float spread = (pick(crossing_3, (abs((oh_2 * ih)) / m2_1), 0.25) * pick(faces, (2.0 * _e54), 0.0));
    vec3 _e62 = facetReflectance(s_9, abs(oh_2), o_3.ratio);
    passes = pick(crossing_3, (vec3(1.0) - _e62), _e62);
    float _e69 = stretched(wi_1, s_9.alpha);
    float apart = ((0.5 * (zo + o_3.stretched)) * (zi + _e69));
    bool _e82 = hidesApart(uint(s_9.code));
    float masked = (zi / max(pick(_e82, apart, ((zi * o_3.stretched) + (zo * _e69))), 1e-20));
    float _e88 = passes.x;
    float chosen_1 = (pick(_e6, _e88, 1.0) * pick(crossing_3, (o_3.ratio * o_3.ratio), 1.0));
    const bool _e98 = hasCompensation;
    if (_e98) {
        vec3 _e99 = passes;
        vec3 _e100 = compensation(s_9, zo);
        passes = (_e99 * _e100);
    }
    vec3 _e102 = passes;
    return FacetLobe(((_e102 * spread) * masked), ((spread * chosen_1) / ((o_3.bound * zo) + o_3.stretched)), abs(oh_2));
}

vec4 evaluateBsdf(Surface s_10, Outgoing o_4, vec3 wi_2) {
    vec4 value = vec4(0.0);
    bool dark = false;
    vec3 base = vec3(0.0);
    float lambert = (0.31830987 * max(wi_2.z, 0.0));
    value = (vec4(s_10.baseColor, 1.0) * lambert);
    dark = pick((o_4.wo.z < 0.0), true, (wi_2.z <= 0.0));
    const bool _e23 = hasConductors;
    const bool _e25 = hasMetallicRoughness;
    const bool _e27 = hasLayers;
    const bool _e32 = hasGlass;
    if (pick(pick(_e23, true, pick(_e25, !(_e27), false)), true, _e32)) {
        uint code_13 = uint(s_10.code);
        FacetLobe _e36 = evaluateFacets(s_10, o_4, wi_2);
        const bool _e41 = hasMetallicRoughness;
        if (_e41) {
            const bool _e43 = hasLayers;
            if (!(_e43)) {
                vec3 _e45 = base;
                vec3 _e49 = metallicRoughnessDiffuse(s_10.baseColor, s_10.metallic, _e36.cosine);
                bool _e50 = isMetallicRoughness(code_13);
                base = pick(_e50, _e49, _e45);
            }
        }
        bool _e59 = isSmooth(code_13);
        vec4 rough = pick(_e59, vec4(0.0), vec4(_e36.value, (o_4.share * _e36.pdf)));
        vec3 _e61 = base;
        vec4 _e68 = value;
        uint _e69 = kindOf(code_13);
        value = pick((_e69 == diffuse0_), _e68, (rough + (vec4(_e61, (1.0 - o_4.share)) * lambert)));
        bool _e73 = dark;
        bool _e74 = isSmooth(code_13);
        bool _e75 = isDielectric(code_13);
        dark = pick(_e75, _e74, _e73);
    }
    float _e78 = mirrorShare(s_10.reflectivity);
    vec4 _e81 = value;
    bool _e85 = dark;
    return pick(_e85, vec4(0.0), ((1.0 - _e78) * _e81));
}

BsdfSample completed(BsdfSample drawn_2, vec4 value_1) {
    float pdf = pick((drawn_2.pdf <= 0.0), 0.0, value_1.w);
    vec3 weight_1 = pick((pdf > 0.0), (value_1.xyz / vec3(max(pdf, 1e-30))), vec3(0.0));
    return BsdfSample(drawn_2.direction, pick(drawn_2.delta, drawn_2.pdf, pdf), pick(drawn_2.delta, drawn_2.weight, weight_1), drawn_2.delta);
}

float ellipticDensity(vec3 h_3, vec2 alpha_10) {
    vec2 scaled_1 = (h_3.xy / alpha_10);
    float slope_1 = max((dot(scaled_1, scaled_1) + (h_3.z * h_3.z)), 1.0);
    return (0.31830987 / (((alpha_10.x * alpha_10.y) * slope_1) * slope_1));
}

Facets facetsTowards(vec3 wi_3, bool isCoat, bool bends) {
    vec3 ownWo_1 = vec3(0.0);
    vec3 ownWi = vec3(0.0);
    vec3 ownH = vec3(0.0);
    vec3 wo_12 = stackHere.wo;
    vec2 _e8 = stackHere.alpha;
    float _e11 = stackHere.coatAlpha;
    vec2 alpha_15 = pick(isCoat, vec2(_e11), _e8);
    bool isRough = (max(alpha_15.x, alpha_15.y) >= 0.001);
    vec2 wide_1 = max(alpha_15, vec2(0.001));
    float _e24 = stackHere.ratio;
    vec3 m_2 = (wo_12 + (wi_3 * pick(bends, _e24, 1.0)));
    float m2_2 = max(dot(m_2, m_2), 1e-20);
    vec3 h_7 = (m_2 * inversesqrt(m2_2));
    float oh_3 = dot(wo_12, h_7);
    float ih_1 = dot(wi_3, h_7);
    ownWo_1 = wo_12;
    ownWi = wi_3;
    ownH = h_7;
    const bool _e40 = hasCoatNormals;
    if (_e40) {
        if (isCoat) {
            float _e43 = stackHere.side;
            vec3 _e44 = coatNormal(_e43);
            Basis _e45 = basisAbout(_e44);
            vec3 _e46 = toLocal(_e45, wo_12);
            ownWo_1 = _e46;
            vec3 _e47 = toLocal(_e45, wi_3);
            ownWi = _e47;
            vec3 _e48 = toLocal(_e45, h_7);
            ownH = _e48;
        }
    }
    float _e50 = ownH.z;
    float _e55 = ownH.z;
    float _e58 = ownWi.z;
    float _e64 = ownWi.z;
    bool faces_1 = pick(pick(((oh_3 * _e50) >= 0.0), (((ih_1 * _e55) * _e58) >= 0.0), false), pick(bends, true, (_e64 >= 0.0)), false);
    vec3 _e74 = ownH;
    float _e75 = ellipticDensity(_e74, wide_1);
    float spread_1 = (pick(bends, (abs((oh_3 * ih_1)) / m2_2), 0.25) * pick(pick(faces_1, isRough, false), (2.0 * _e75), 0.0));
    vec3 _e82 = ownWo_1;
    float _e83 = ellipticStretched(_e82, wide_1);
    float _e85 = ownWi.z;
    float ownZi = abs(_e85);
    float _e89 = ownWo_1.z;
    vec3 _e90 = ownWi;
    float _e91 = ellipticStretched(_e90, wide_1);
    float masked_1 = (ownZi / max(((ownZi * _e83) + (_e89 * _e91)), 1e-20));
    vec3 _e97 = ownWo_1;
    float _e98 = ellipticBound(_e97, wide_1);
    bool _e99 = isSolidHere();
    float bound_3 = pick(pick(_e99, !(isCoat), false), 1.0, _e98);
    float _e106 = ownWo_1.z;
    return Facets((spread_1 * masked_1), (spread_1 / ((bound_3 * _e106) + _e83)), min(abs(oh_3), 1.0));
}

vec3 indexOf(vec3 f0_1) {
    vec3 root_1 = sqrt(min(f0_1, vec3(0.9999)));
    return ((vec3(1.0) + root_1) / (vec3(1.0) - root_1));
}

vec3 sensitivity(float difference, vec3 shift) {
    float phase = (6.2831855e-9 * difference);
    vec4 mean = vec4(1681000.0, 1795300.0, 2208400.0, 2239900.0);
    vec4 variance = vec4(4327800000.0, 9304600000.0, 6612100000.0, 4528200000.0);
    vec4 height = vec4(0.84659, 1.000222, 1.001122, 0.153868);
    vec4 turns = ((mean * (phase * 0.15915494)) + vec4(shift, shift.x));
    vec4 lobes = ((height * cos((6.2831855 * (turns - roundEven(turns))))) * exp((-(variance) * (phase * phase))));
    float x_2 = (lobes.x + lobes.w);
    return vec3((((3.2404542 * x_2) - (1.5371385 * lobes.y)) - (0.4985314 * lobes.z)), (((-0.969266 * x_2) + (1.8760108 * lobes.y)) + (0.041556 * lobes.z)), (((0.0556434 * x_2) - (0.2040259 * lobes.y)) + (1.0572252 * lobes.z)));
}

vec3 filmReflectance(vec3 f0_2, float filmIor, float thickness, float cosine_16) {
    vec3 sum = vec3(0.0);
    vec3 amplitude = vec3(0.0);
    float order = 1.0;
    float sine2_2 = ((1.0 - (cosine_16 * cosine_16)) / (filmIor * filmIor));
    float within = sqrt(max((1.0 - sine2_2), 0.0));
    float first = ((filmIor - 1.0) / (filmIor + 1.0));
    vec3 _e21 = schlick(vec3((first * first)), cosine_16);
    float r12_ = _e21.x;
    float t121_ = (1.0 - r12_);
    vec3 _e28 = indexOf((f0_2 + vec3(0.0001)));
    vec3 second = ((_e28 - vec3(filmIor)) / (_e28 + vec3(filmIor)));
    vec3 _e35 = schlick((second * second), within);
    vec3 r123_ = clamp((r12_ * _e35), vec3(1e-5), vec3(0.9999));
    vec3 once = sqrt(r123_);
    vec3 rs = (((t121_ * t121_) * _e35) / (vec3(1.0) - r123_));
    vec3 shift_1 = (vec3(0.5) + mix(vec3(0.0), vec3(0.5), lessThan(_e28, vec3(filmIor))));
    float difference_2 = (((2.0 * filmIor) * thickness) * within);
    sum = (vec3(r12_) + rs);
    amplitude = (rs - vec3(t121_));
    while(true) {
        vec3 _e71 = amplitude;
        amplitude = (_e71 * once);
        vec3 _e73 = sum;
        vec3 _e74 = amplitude;
        float _e77 = order;
        float _e79 = order;
        vec3 _e81 = sensitivity((_e77 * difference_2), (_e79 * shift_1));
        sum = (_e73 + ((2.0 * _e74) * _e81));
        float _e84 = order;
        order = (_e84 + 1.0);
        float _e87 = order;
        if ((_e87 > 2.5)) {
            break;
        }
    }
    vec3 _e90 = sum;
    return clamp(_e90, vec3(0.0), vec3(1.0));
}

Reflectance filmedReflectance(Surface s_11, Reflectance bare_1, float cosine_17) {
    Reflectance r_1 = Reflectance(vec3(0.0), vec3(0.0));
    bool isMetal = false;
    r_1 = bare_1;
    float _e6 = layersHere.film;
    if ((_e6 > 0.0)) {
        float _e9 = outerCosine(cosine_17);
        isMetal = (s_11.metallic >= 1.0);
        while(true) {
            float _e16 = layersHere.specularWeight;
            vec3 _e17 = dielectricF0_();
            bool _e20 = isMetal;
            vec3 f0_4 = pick(_e20, s_11.baseColor, (_e16 * _e17));
            float _e24 = layersHere.filmIor;
            float _e27 = layersHere.filmThickness;
            vec3 _e28 = filmReflectance(f0_4, _e24, _e27, _e9);
            bool _e29 = isMetal;
            if (_e29) {
                vec3 _e32 = r_1.metal;
                float _e35 = layersHere.film;
                r_1.metal = mix(_e32, _e28, _e35);
            } else {
                vec3 _e39 = r_1.dielectric;
                float _e42 = layersHere.film;
                r_1.dielectric = mix(_e39, _e28, _e42);
            }
            bool _e44 = isMetal;
            if (pick(_e44, true, (s_11.metallic <= 0.0))) {
                break;
            }
            isMetal = true;
        }
        const bool _e51 = hasTransmission;
        if (_e51) {
            vec3 _e54 = r_1.dielectric;
            float _e59 = stackHere.ratio;
            bool _e60 = reflectsAll(cosine_17, _e59);
            r_1.dielectric = pick(_e60, vec3(1.0), _e54);
        }
    }
    Reflectance _e62 = r_1;
    return _e62;
}

float shadowingExponent(float x, float alpha_11) {
    float m_3 = ((1.0 - alpha_11) * (1.0 - alpha_11));
    float a_2 = mix(21.5473, 25.3245, m_3);
    float b_4 = mix(3.82987, 3.32435, m_3);
    float c = mix(0.19823, 0.16801, m_3);
    float d = mix(-1.9776, -1.27393, m_3);
    float e = mix(-4.32054, -4.85967, m_3);
    return (((a_2 / (1.0 + (b_4 * pow(x, c)))) + (d * x)) + e);
}

float sheenShadowing(float cosine_18, float alpha_12) {
    float x_3 = clamp(cosine_18, 1e-6, 1.0);
    bool isLow = (x_3 < 0.5);
    float _e12 = shadowingExponent(pick(isLow, x_3, max((1.0 - x_3), 1e-6)), alpha_12);
    float _e14 = shadowingExponent(0.5, alpha_12);
    return exp(pick(isLow, _e12, ((2.0 * _e14) - _e12)));
}

float whiteSheen(vec3 wo_7, vec3 wi_4, float alpha_13) {
    vec3 m_4 = (wo_7 + wi_4);
    float m2_3 = max(dot(m_4, m_4), 1e-20);
    float sine2_3 = clamp((dot(m_4.xy, m_4.xy) / m2_3), 0.0, 1.0);
    float power = (0.5 / alpha_13);
    float density = (((2.0 + (2.0 * power)) * 0.15915494) * pick((sine2_3 < 1e-20), 0.0, exp((power * log(max(sine2_3, 1e-20))))));
    float zo_1 = max(wo_7.z, 1e-6);
    float _e38 = sheenShadowing(wo_7.z, alpha_13);
    float _e42 = sheenShadowing(wi_4.z, alpha_13);
    return (density / ((4.0 * zo_1) * ((1.0 + _e38) + _e42)));
}

float sheenAlpha(float roughness_1) {
    float r_3 = max(roughness_1, 0.07);
    return (r_3 * r_3);
}

Cover coverTowards(vec3 wi_5, bool crossing_1) {
    Cover cover = Cover(1.0, vec4(0.0));
    const bool _e8 = hasCoats;
    if (_e8) {
        float _e11 = layersHere.coat;
        float _e14 = stackHere.side;
        float _e15 = coatCosine(_e14, wi_5);
        float _e16 = coatReflectance(_e11, _e15);
        float _e20 = stackHere.coat;
        bool _e23 = stackHere.inside;
        cover.left = (1.0 - pick(pick(_e23, crossing_1, false), _e16, _e20));
    }
    const bool _e29 = hasSheen;
    if (_e29) {
        float _e32 = stackHere.sheenColor;
        if ((_e32 > 0.0)) {
            float _e37 = layersHere.solid;
            bool _e43 = stackHere.inside;
            bool isOutside = pick(!((_e37 > 0.0)), true, (_e43 == crossing_1));
            float _e48 = stackHere.sheen;
            float _e53 = layersHere.sheenRoughness;
            float _e54 = sheenAlbedo(abs(wi_5.z), _e53);
            float most = max(_e48, _e54);
            float _e58 = stackHere.coat;
            vec3 _e63 = stackHere.wo;
            float _e66 = layersHere.sheenRoughness;
            float _e67 = sheenAlpha(_e66);
            float _e68 = whiteSheen(_e63, wi_5, _e67);
            float white = (((1.0 - _e58) * _e68) / max(most, 1.0));
            vec3 _e76 = layersHere.sheenColor;
            float _e80 = stackHere.ofSheen;
            bool _e88 = stackHere.inside;
            cover.fibres = pick(pick(crossing_1, true, _e88), vec4(0.0), vec4((white * _e76), (_e80 * 0.15915494)));
            float _e92 = cover.left;
            float _e95 = stackHere.sheenColor;
            float _e98 = stackHere.sheen;
            cover.left = (_e92 * (1.0 - (_e95 * min(pick(isOutside, most, _e98), 1.0))));
        }
    }
    Cover _e106 = cover;
    return _e106;
}

float ofBeyond() {
    float _e2 = stackHere.ofCoat;
    float _e7 = stackHere.ofFacets;
    float _e11 = stackHere.ofSheen;
    float _e15 = stackHere.ofDiffuse;
    return max(((((1.0 - _e2) - _e7) - _e11) - _e15), 0.0);
}

LayeredPair evaluateLayers(Surface s_12, vec3 toLight, vec3 toSample, bool byMirror) {
    LayeredPair pair = LayeredPair(vec4(0.0), vec4(0.0));
    bool isLight = false;
    bool isFirst = true;
    vec4 sum_1 = vec4(0.0);
    float intoBody = 0.0;
    Reflectance r_2 = Reflectance(vec3(0.0), vec3(0.0));
    float chosen = 0.0;
    uint _e12 = frame.emitterCount;
    isLight = (_e12 > 0u);
    while(true) {
        bool _e23 = isLight;
        vec3 given_1 = pick(_e23, toLight, toSample);
        float _e29 = stackHere.side;
        vec3 wi_6 = vec3(given_1.xy, (given_1.z * _e29));
        vec3 facing = vec3(wi_6.xy, abs(wi_6.z));
        const bool _e37 = hasTransmission;
        const bool _e39 = hasCoatNormals;
        bool crossing_4 = pick(pick(_e37, true, _e39), (wi_6.z < 0.0), false);
        float _e47 = stackHere.coat;
        bool _e50 = isSolidHere();
        bool _e53 = stackHere.inside;
        bool apart_1 = pick((_e47 > 0.0), true, pick(pick(_e50, pick(crossing_4, true, _e53), false), (s_12.metallic < 1.0), false));
        const bool _e62 = hasCoats;
        const bool _e64 = hasTransmission;
        bool _e66 = isFirst;
        bool isCoat_2 = pick(pick(pick(_e62, true, _e64), _e66, false), apart_1, false);
        const bool _e70 = hasCoatNormals;
        bool coatEnds = pick(crossing_4, !(pick(_e70, (s_12.eta.x >= 0.0), false)), false);
        bool _e78 = isSolidHere();
        bool bends_1 = pick(pick(_e78, crossing_4, false), !(isCoat_2), false);
        Facets _e86 = facetsTowards(pick(pick(bends_1, true, pick(isCoat_2, !(coatEnds), false)), wi_6, facing), isCoat_2, bends_1);
        bool _e87 = isLight;
        bool ofMirror = pick(byMirror, !(_e87), false);
        bool _e92 = stackHere.drawnByCoat;
        bool isMirror_1 = pick(ofMirror, (isCoat_2 == _e92), false);
        float value_2 = pick(isMirror_1, 1.0, pick(ofMirror, 0.0, _e86.value));
        float density_1 = pick(isMirror_1, 1.0, pick(ofMirror, 0.0, _e86.density));
        float _e109 = stackHere.wo.z;
        bool _e112 = stackHere.inside;
        float cosine_20 = pick(pick(pick(isCoat_2, _e112, false), true, isMirror_1), _e109, _e86.cosine);
        Reflectance _e116 = bareReflectance(s_12, cosine_20);
        r_2 = _e116;
        const bool _e119 = hasIridescence;
        if (_e119) {
            Reflectance _e120 = filmedReflectance(s_12, _e116, cosine_20);
            r_2 = _e120;
        }
        float _e121 = intoBody;
        vec3 _e126 = r_2.dielectric;
        float _e127 = greatest(_e126);
        intoBody = pick(pick(isCoat_2, true, !(apart_1)), ((1.0 - s_12.metallic) * (1.0 - _e127)), _e121);
        if (isCoat_2) {
            float _e136 = stackHere.coat;
            float _e141 = stackHere.ofCoat;
            sum_1 = pick(coatEnds, vec4(0.0), vec4(vec3((_e136 * value_2)), (_e141 * density_1)));
            isFirst = false;
        } else {
            Cover _e148 = coverTowards(wi_6, crossing_4);
            Reflectance _e149 = r_2;
            Parting _e150 = partingOf(s_12, _e149);
            vec3 _e155 = stackHere.more;
            vec3 lobe = (_e148.left * pick(crossing_4, _e150.beyond, (_e150.toward * pick(isMirror_1, vec3(1.0), _e155))));
            float _e165 = stackHere.ofFacets;
            chosen = _e165;
            const bool _e168 = hasTransmission;
            if (_e168) {
                float _e169 = shareToward(s_12, _e116);
                float _e170 = chosen;
                float _e176 = stackHere.ratio;
                float _e179 = stackHere.ratio;
                chosen = (_e170 * (pick(crossing_4, (1.0 - _e169), _e169) * pick(bends_1, (_e176 * _e179), 1.0)));
            }
            vec4 _e185 = sum_1;
            float _e187 = chosen;
            sum_1 = (_e185 + vec4((lobe * value_2), (_e187 * density_1)));
            float _e193 = layersHere.beyond;
            float _e200 = layersHere.beyond;
            vec3 _e203 = layersHere.beyondColor;
            vec3 body_1 = pick(crossing_4, (_e200 * _e203), ((1.0 - _e193) * s_12.baseColor));
            float _e207 = intoBody;
            float _e211 = layersHere.transmission;
            vec3 matte = (((_e148.left * _e207) * (1.0 - _e211)) * body_1);
            float _e219 = stackHere.ofDiffuse;
            float _e220 = ofBeyond();
            vec4 even_1 = (_e148.fibres + (vec4(matte, pick(crossing_4, _e220, _e219)) * (0.31830987 * facing.z)));
            vec4 _e228 = sum_1;
            sum_1 = (_e228 + pick(ofMirror, vec4(0.0), even_1));
            vec4 _e233 = sum_1;
            sum_1 = pick(pick(!(crossing_4), (wi_6.z < 0.0), false), vec4(0.0), _e233);
            vec4 _e243 = pair.toLight;
            vec4 _e244 = sum_1;
            bool _e245 = isLight;
            vec4 _e247 = sum_1;
            pair = LayeredPair(pick(_e245, _e244, _e243), _e247);
            bool _e249 = isLight;
            if (!(_e249)) {
                break;
            }
            isLight = false;
            isFirst = true;
            sum_1 = vec4(0.0);
        }
    }
    LayeredPair _e255 = pair;
    return _e255;
}

Pair evaluatePair(Surface s_13, Outgoing o_5, vec3 toLight_1, BsdfSample drawn_3) {
    Pair pair_1 = Pair(vec4(0.0), BsdfSample(vec3(0.0), 0.0, vec3(0.0), false));
    vec4 _e4 = evaluateBsdf(s_13, o_5, toLight_1);
    vec4 _e6 = evaluateBsdf(s_13, o_5, drawn_3.direction);
    BsdfSample _e7 = completed(drawn_3, _e6);
    pair_1 = Pair(_e4, _e7);
    const bool _e11 = hasLayers;
    if (_e11) {
        bool _e14 = isLayered(uint(s_13.code));
        if (_e14) {
            bool byMirror_1 = pick(drawn_3.delta, !(any(greaterThan(drawn_3.weight, vec3(0.0)))), false);
            float _e24 = mirrorShare(s_13.reflectivity);
            float base_2 = (1.0 - _e24);
            LayeredPair _e28 = evaluateLayers(s_13, toLight_1, drawn_3.direction, byMirror_1);
            pair_1.toLight = (base_2 * _e28.toLight);
            BsdfSample _e41 = completed(BsdfSample(drawn_3.direction, drawn_3.pdf, drawn_3.weight, pick(drawn_3.delta, !(byMirror_1), false)), (base_2 * _e28.toSample));
            pair_1.drawn = BsdfSample(_e41.direction, _e41.pdf, _e41.weight, drawn_3.delta);
        }
    }
    Pair _e48 = pair_1;
    return _e48;
}

void main() {
    vec4 fragment = gl_FragCoord;
    uvec2 pixel = uvec2(fragment.xy);
    vec4 a_3 = texelFetch(questions, ivec2(uvec2((3u * pixel.x), pixel.y)), 0);
    vec4 b_5 = texelFetch(questions, ivec2(uvec2(((3u * pixel.x) + 1u), pixel.y)), 0);
    vec4 _e30 = texelFetch(questions, ivec2(uvec2(((3u * pixel.x) + 2u), pixel.y)), 0);
    vec3 n_1 = _e30.xyz;
    Surface _e34 = fetchSurface(uint(a_3.w));
    uint asked_2 = (uint(b_5.w) % 3u);
    uint color = (uint(b_5.w) / 3u);
    vec3 hero_3 = pick((color == 0u), vec3(1.0), (3.0 * vec3(equal(uvec3(color), uvec3(1u, 2u, 3u)))));
    Layers _e62 = layersOf(uint(_e34.code), _e34.eta.x);
    layersHere = _e62;
    coatNormalHere = pick(((dot(n_1, a_3.xyz) < 0.0) != (a_3.z < 0.0)), -(n_1), n_1);
    Outgoing _e75 = outgoing(_e34, a_3.xyz, hero_3);
    BsdfSample _e77 = sampleLobe(_e34, _e75, b_5.xyz);
    Pair _e79 = evaluatePair(_e34, _e75, b_5.xyz, _e77);
    if ((asked_2 == evaluation)) {
        _fs2p_location0 = _e79.toLight;
        return;
    }
    BsdfSample taken = _e79.drawn;
    if ((asked_2 == sampledDirection)) {
        _fs2p_location0 = vec4(taken.direction, taken.pdf);
        return;
    }
    _fs2p_location0 = vec4(taken.weight, pick(taken.delta, 1.0, 0.0));
    return;
}

