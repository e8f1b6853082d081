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
    Layers layers;
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
    vec3 weight;
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
    float share;
};
struct Pair {
    vec4 toLight;
    vec4 toSample;
};
struct FacetLobe {
    vec3 value;
    float pdf;
    float cosine;
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
    uint seenLightEnd;
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

Stack stackHere = Stack(Layers(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), vec3(0.0), 0.0, vec3(0.0), 0.0, false, vec3(0.0), vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);

const bool hasCoatNormals = false;

const bool hasCompensation = false;

const bool hasIridescence = false;

const bool hasMirrorLayers = true;

layout(std140) uniform FrameBlock { Frame frame; };

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

bool isLayered(uint code_2, float eta) {
    const bool _e3 = hasLayers;
    bool _e4 = isMetallicRoughness(code_2);
    return pick(pick(_e3, _e4, false), (eta != 0.0), false);
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

Layers layersOf(uint code_3, float eta_1) {
    Layers l = Layers(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    const bool _e4 = hasLayers;
    if (_e4) {
        bool _e5 = isLayered(code_3, eta_1);
        if (_e5) {
            Layers _e8 = fetchLayers(uint(abs(eta_1)));
            l = _e8;
        }
    }
    Layers _e9 = l;
    return _e9;
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

float dispersedIndex(float ior, float dispersion, vec3 hero) {
    float side_2 = (pick((hero.z > 0.0), 1.0, 0.0) - pick((hero.x > 0.0), 1.0, 0.0));
    return max((ior + (((side_2 * (ior - 1.0)) * 0.025) * dispersion)), 1.0);
}

vec2 ellipticAlpha(float alpha, float strength) {
    return pick((strength > 0.0), vec2(mix(alpha, 1.0, (strength * strength)), max(alpha, 0.001)), vec2(alpha));
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

vec3 dielectricF0_(Layers l_1) {
    float contrast = ((l_1.ior - 1.0) / (l_1.ior + 1.0));
    return min(((contrast * contrast) * l_1.specularColor), vec3(1.0));
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

vec3 filmReflectance(vec3 f0_2, float filmIor, float thickness, float cosine_5) {
    vec3 sum = vec3(0.0);
    vec3 amplitude = vec3(0.0);
    float order = 1.0;
    float sine2_1 = ((1.0 - (cosine_5 * cosine_5)) / (filmIor * filmIor));
    float within = sqrt(max((1.0 - sine2_1), 0.0));
    float first = ((filmIor - 1.0) / (filmIor + 1.0));
    vec3 _e21 = schlick(vec3((first * first)), cosine_5);
    float r12_ = _e21.x;
    float t121_ = (1.0 - r12_);
    vec3 _e28 = indexOf((f0_2 + vec3(0.0001)));
    vec3 second = ((_e28 - vec3(filmIor)) / (_e28 + vec3(filmIor)));
    vec3 _e35 = schlick((second * second), within);
    vec3 r123_ = clamp((r12_ * _e35), vec3(1e-5), vec3(0.9999));
    vec3 once = sqrt(r123_);
    vec3 rs = (((t121_ * t121_) * _e35) / (vec3(1.0) - r123_));
    vec3 shift_1 = (vec3(0.5) + mix(vec3(0.0), vec3(0.5), lessThan(_e28, vec3(filmIor))));
    float difference_1 = (((2.0 * filmIor) * thickness) * within);
    sum = (vec3(r12_) + rs);
    amplitude = (rs - vec3(t121_));
    while(true) {
        vec3 _e71 = amplitude;
        amplitude = (_e71 * once);
        vec3 _e73 = sum;
        vec3 _e74 = amplitude;
        float _e77 = order;
        float _e79 = order;
        vec3 _e81 = sensitivity((_e77 * difference_1), (_e79 * shift_1));
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

bool reflectsAll(float cosine_6, float ratio_1) {
    return pick((ratio_1 < 1.0), ((1.0 - (cosine_6 * cosine_6)) >= (ratio_1 * ratio_1)), false);
}

vec4 baseReflectance(Surface s, Stack o, float cosine_7) {
    vec3 dielectric = vec3(0.0);
    vec3 metal = vec3(0.0);
    bool isMetal = false;
    Layers l_3 = o.layers;
    float _e5 = cosineInAir(cosine_7, o.ratio);
    vec3 _e6 = dielectricF0_(l_3);
    vec3 _e8 = schlick(_e6, _e5);
    dielectric = (l_3.specularWeight * _e8);
    vec3 _e12 = schlick(s.baseColor, _e5);
    metal = _e12;
    const bool _e15 = hasIridescence;
    if (_e15) {
        if ((l_3.film > 0.0)) {
            isMetal = (s.metallic >= 1.0);
            while(true) {
                bool _e26 = isMetal;
                vec3 _e30 = filmReflectance(pick(_e26, s.baseColor, (l_3.specularWeight * _e6)), l_3.filmIor, l_3.filmThickness, _e5);
                bool _e31 = isMetal;
                if (_e31) {
                    vec3 _e32 = metal;
                    metal = mix(_e32, _e30, l_3.film);
                } else {
                    vec3 _e35 = dielectric;
                    dielectric = mix(_e35, _e30, l_3.film);
                }
                bool _e38 = isMetal;
                if (pick(_e38, true, (s.metallic <= 0.0))) {
                    break;
                }
                isMetal = true;
            }
        }
    }
    vec3 _e44 = dielectric;
    bool _e48 = reflectsAll(cosine_7, o.ratio);
    dielectric = pick(_e48, vec3(1.0), _e44);
    vec3 _e50 = dielectric;
    vec3 _e51 = metal;
    vec3 _e57 = dielectric;
    float _e58 = greatest(_e57);
    return vec4(mix(_e50, _e51, s.metallic), ((1.0 - s.metallic) * (1.0 - _e58)));
}

float mean3_(vec3 v_1) {
    return dot(v_1, vec3(0.33333334));
}

Stack stackOf(Surface s_1, Layers l_2, vec3 given, vec3 hero_1) {
    float sheen = 0.0;
    vec3 more = vec3(1.0);
    Stack o_1 = Stack(Layers(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), vec3(0.0), 0.0, vec3(0.0), 0.0, false, vec3(0.0), vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    float side_3 = pick((given.z < 0.0), -1.0, 1.0);
    vec3 wo_8 = vec3(given.xy, (given.z * side_3));
    bool isSolid = (l_2.solid > 0.0);
    bool inside = pick(isSolid, (side_3 < 0.0), false);
    float _e22 = dispersedIndex(l_2.ior, l_2.dispersion, hero_1);
    float ratio_6 = pick(isSolid, pick(inside, (1.0 / _e22), _e22), 1.0);
    bool flat_ = pick(pick(isSolid, (l_2.transmission > 0.0), false), ((_e22 - 1.0) < 0.001), false);
    vec2 _e39 = ellipticAlpha(s_1.alpha, l_2.anisotropy);
    vec2 alpha_14 = pick(flat_, vec2(0.0), _e39);
    float coatAlpha = (l_2.coatRoughness * l_2.coatRoughness);
    float _e47 = coatCosine(side_3, wo_8);
    float _e48 = coatReflectance(l_2.coat, _e47);
    float coat_1 = pick(inside, 0.0, _e48);
    float _e52 = greatest(l_2.sheenColor);
    if ((_e52 > 0.0)) {
        float _e59 = sheenAlbedo(wo_8.z, l_2.sheenRoughness);
        sheen = pick(inside, 0.0, _e59);
    }
    vec3 _e63 = dielectricF0_(l_2);
    vec3 f0_3 = (l_2.specularWeight * _e63);
    const bool _e69 = hasCompensation;
    if (_e69) {
        float _e75 = singleScatteringAlbedo(wo_8.z, sqrt((alpha_14.x * alpha_14.y)));
        bool asked = pick(((uint(s_1.code) & 8u) != 0u), (l_2.transmission <= 0.0), false);
        vec3 _e86 = more;
        more = pick(asked, (vec3(1.0) + (mix(f0_3, s_1.baseColor, s_1.metallic) * ((1.0 - _e75) / _e75))), _e86);
    }
    vec3 _e98 = more;
    float _e99 = sheen;
    o_1 = Stack(l_2, wo_8, side_3, hero_1, ratio_6, inside, _e98, alpha_14, coatAlpha, coat_1, _e99, _e52, 0.0, 0.0, 0.0, 0.0);
    Stack _e106 = o_1;
    vec4 _e108 = baseReflectance(s_1, _e106, wo_8.z);
    float _e111 = sheen;
    float below = ((1.0 - coat_1) * (1.0 - (_e52 * min(_e111, 1.0))));
    float film = pick((l_2.film > 0.0), (0.25 * l_2.film), 0.0);
    float _e127 = mean3_(_e108.xyz);
    float _e133 = mean3_(s_1.baseColor);
    float facets = (below * ((_e127 + film) + ((_e108.w * l_2.transmission) * _e133)));
    float _e139 = sheen;
    float _e142 = mean3_(l_2.sheenColor);
    float fibres = (((1.0 - coat_1) * _e139) * _e142);
    float _e148 = greatest(f0_3);
    float body = (((below * (1.0 - s_1.metallic)) * (1.0 - _e148)) * (1.0 - l_2.transmission));
    float _e161 = mean3_(s_1.baseColor);
    float diffuse = ((body * (1.0 - l_2.beyond)) * _e161);
    float _e166 = mean3_(l_2.beyondColor);
    float beyond = ((body * l_2.beyond) * _e166);
    float all_ = max(((((coat_1 + facets) + fibres) + diffuse) + beyond), 1e-20);
    o_1.ofCoat = (coat_1 / all_);
    o_1.ofFacets = (facets / all_);
    o_1.ofSheen = (fibres / all_);
    o_1.ofDiffuse = (diffuse / all_);
    Stack _e182 = o_1;
    return _e182;
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

float indexRatio(float eta_2, float z_1, bool thin) {
    return pick(pick((z_1 < 0.0), !(thin), false), (1.0 / eta_2), eta_2);
}

bool isThin(uint code_6) {
    const bool _e2 = hasGlass;
    return pick(_e2, ((code_6 & 7u) == 7u), false);
}

float reflectionBound(vec3 wo, float alpha_2) {
    float s_12 = (1.0 + length(wo.xy));
    float s2_ = (s_12 * s_12);
    float a2_1 = (alpha_2 * alpha_2);
    return (((1.0 - a2_1) * s2_) / (s2_ + ((a2_1 * wo.z) * wo.z)));
}

float stretched(vec3 w_1, float alpha_3) {
    return sqrt(((w_1.z * w_1.z) + ((alpha_3 * alpha_3) * dot(w_1.xy, w_1.xy))));
}

Outgoing outgoing(Surface s_2, vec3 wo_1, vec3 hero_2) {
    Outgoing o_2 = Outgoing(vec3(0.0), 0.0, 0.0, 0.0, 0.0);
    uint code_9 = uint(s_2.code);
    bool _e5 = isConductor(code_9);
    bool _e6 = isDielectric(code_9);
    o_2 = Outgoing(wo_1, pick(pick(_e5, true, _e6), 1.0, 0.0), 1.0, 1.0, 1.0);
    const bool _e17 = hasLayers;
    if (_e17) {
        bool _e22 = isLayered(uint(s_2.code), s_2.eta.x);
        if (_e22) {
            Layers _e25 = layersHere;
            Stack _e26 = stackOf(s_2, _e25, wo_1, hero_2);
            stackHere = _e26;
        }
    }
    const bool _e28 = hasMetallicRoughness;
    if (_e28) {
        float _e31 = o_2.share;
        float _e35 = specularShare(s_2.baseColor, s_2.metallic, wo_1.z);
        bool _e36 = isMetallicRoughness(code_9);
        o_2.share = pick(_e36, _e35, _e31);
    }
    const bool _e39 = hasGlass;
    if (_e39) {
        bool _e44 = isThin(code_9);
        float _e45 = indexRatio(s_2.eta.x, wo_1.z, _e44);
        bool _e46 = isDielectric(code_9);
        o_2.ratio = pick(_e46, _e45, 1.0);
    }
    const bool _e50 = hasConductors;
    const bool _e52 = hasMetallicRoughness;
    const bool _e55 = hasGlass;
    if (pick(pick(_e50, true, _e52), true, _e55)) {
        float _e59 = reflectionBound(wo_1, s_2.alpha);
        bool _e60 = isDielectric(code_9);
        o_2.bound = pick(_e60, 1.0, _e59);
        float _e65 = stretched(wo_1, s_2.alpha);
        o_2.stretched = _e65;
    }
    Outgoing _e66 = o_2;
    return _e66;
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

vec3 sampleFacet(float alpha_5, bool isMirror, Outgoing o_3, vec2 u_2) {
    float side_4 = pick((o_3.wo.z < 0.0), -1.0, 1.0);
    vec3 _e16 = sampleVisibleNormal((o_3.wo * side_4), max(alpha_5, 0.001), o_3.bound, u_2);
    return (pick(isMirror, vec3(0.0, 0.0, 1.0), _e16) * side_4);
}

vec3 conductorFresnel(float cosine_10, vec3 eta_3, vec3 k) {
    float cosine2_ = (cosine_10 * cosine_10);
    float sine2_2 = (1.0 - cosine2_);
    vec3 difference_2 = (((eta_3 * eta_3) - (k * k)) - vec3(sine2_2));
    vec3 a2PlusB2_ = sqrt(((difference_2 * difference_2) + ((((4.0 * eta_3) * eta_3) * k) * k)));
    vec3 larger = sqrt(((0.5 * (a2PlusB2_ + abs(difference_2))) + vec3(1e-20)));
    vec3 smaller = ((eta_3 * k) / larger);
    vec3 a = mix(smaller, larger, greaterThan(difference_2, vec3(0.0)));
    vec3 b_2 = mix(larger, smaller, greaterThan(difference_2, vec3(0.0)));
    vec3 b2_ = ((b_2 * b_2) + vec3(1e-20));
    vec3 acrossFar = (a + vec3(cosine_10));
    vec3 acrossNear = (a - vec3(cosine_10));
    vec3 across = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a * cosine_10) + vec3(sine2_2));
    vec3 alongNear = ((a * cosine_10) - vec3(sine2_2));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor_3, vec3 eta_4, vec3 k_1, float cosine_11) {
    float constants = dot((eta_4 + k_1), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_11, eta_4, k_1);
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
        vec3 _e12 = metallicRoughnessF0_(s_3.baseColor, s_3.metallic);
        vec3 _e13 = schlick(_e12, cosine_14);
        reflectance = _e13;
    }
    const bool _e15 = hasConductors;
    if (_e15) {
        vec3 _e16 = reflectance;
        vec3 _e20 = conductorReflectance(s_3.baseColor, s_3.eta, s_3.k, cosine_14);
        bool _e21 = isConductor(code_10);
        reflectance = pick(_e21, _e20, _e16);
    }
    const bool _e24 = hasGlass;
    if (_e24) {
        vec3 _e25 = reflectance;
        bool _e26 = isThin(code_10);
        float _e27 = glassReflectance(cosine_14, ratio_4, _e26);
        bool _e29 = isDielectric(code_10);
        reflectance = pick(_e29, vec3(_e27), _e25);
    }
    vec3 _e31 = reflectance;
    return _e31;
}

vec3 refracted(vec3 wo_3, vec3 h, float ratio_5) {
    float cosine_17 = dot(wo_3, h);
    float inside_2 = sqrt(max((((ratio_5 - 1.0) * (ratio_5 + 1.0)) + (cosine_17 * cosine_17)), 0.0));
    return ((((cosine_17 - inside_2) * h) - wo_3) / vec3(ratio_5));
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
    float s_13 = (1.0 + length(wo_4.xy));
    float s2_1 = (s_13 * s_13);
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

Parting partingOf(Surface s_4, Stack o_4, vec4 reflectance_1) {
    vec3 toward = (reflectance_1.xyz * pick(o_4.inside, o_4.hero, vec3(1.0)));
    vec3 beyond_1 = (((reflectance_1.w * o_4.layers.transmission) * s_4.baseColor) * o_4.hero);
    float _e18 = mean3_(toward);
    float _e19 = mean3_(beyond_1);
    return Parting(toward, beyond_1, pick((_e19 > 0.0), (_e18 / max((_e18 + _e19), 1e-20)), 1.0));
}

float throughCover(Stack o_5, float zi, float coatZi, bool crossing) {
    float sheen_1 = 0.0;
    Layers l_4 = o_5.layers;
    bool isSolid_1 = (l_4.solid > 0.0);
    bool entersHere = pick(o_5.inside, crossing, false);
    float _e12 = coatReflectance(l_4.coat, coatZi);
    float coat_2 = pick(entersHere, _e12, o_5.coat);
    sheen_1 = o_5.sheen;
    if ((o_5.sheenColor > 0.0)) {
        bool isOutside = pick(!(isSolid_1), true, (o_5.inside == crossing));
        float _e23 = sheen_1;
        float _e25 = sheenAlbedo(zi, l_4.sheenRoughness);
        sheen_1 = max(_e23, pick(isOutside, _e25, 0.0));
    }
    float _e32 = sheen_1;
    return ((1.0 - coat_2) * (1.0 - (o_5.sheenColor * min(_e32, 1.0))));
}

LayeredSample sampleLayered(Surface s_5, Stack o_6, vec3 u_4) {
    Basis frame = Basis(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0));
    vec3 ownWo = vec3(0.0);
    vec3 h_1 = vec3(0.0);
    bool lost = false;
    LayeredSample drawn = LayeredSample(vec3(0.0), 0.0, vec3(0.0), false);
    vec3 wo_9 = o_6.wo;
    bool isSolid_2 = (o_6.layers.solid > 0.0);
    bool isCoat_1 = (u_4.z < o_6.ofCoat);
    bool isFacet = (u_4.z < (o_6.ofCoat + o_6.ofFacets));
    vec2 alpha_15 = pick(isCoat_1, vec2(o_6.coatAlpha), o_6.alpha);
    bool isSmooth_1 = (max(alpha_15.x, alpha_15.y) < 0.001);
    vec2 wide = max(alpha_15, vec2(0.001));
    const bool _e43 = hasCoatNormals;
    if (_e43) {
        if (isCoat_1) {
            vec3 _e45 = coatNormal(o_6.side);
            Basis _e46 = basisAbout(_e45);
            frame = _e46;
        }
    }
    ownWo = wo_9;
    const bool _e49 = hasCoatNormals;
    if (_e49) {
        Basis _e50 = frame;
        vec3 _e51 = toLocal(_e50, wo_9);
        ownWo = _e51;
    }
    vec3 _e52 = ownWo;
    float _e53 = ellipticBound(_e52, wide);
    float bound_2 = pick(pick(isSolid_2, !(isCoat_1), false), 1.0, _e53);
    vec3 _e58 = ownWo;
    vec3 _e60 = sampleEllipticNormal(_e58, wide, bound_2, u_4.xy);
    h_1 = pick(isSmooth_1, vec3(0.0, 0.0, 1.0), _e60);
    const bool _e68 = hasCoatNormals;
    if (_e68) {
        Basis _e69 = frame;
        vec3 _e70 = h_1;
        vec3 _e71 = toWorld(_e69, _e70);
        h_1 = _e71;
    }
    vec3 _e72 = h_1;
    float oh = max(dot(wo_9, _e72), 0.0);
    vec4 _e76 = baseReflectance(s_5, o_6, oh);
    Parting _e77 = partingOf(s_5, o_6, _e76);
    float left = ((u_4.z - o_6.ofCoat) / max(o_6.ofFacets, 1e-20));
    bool crossing_1 = pick(!(isCoat_1), (left >= _e77.share), false);
    vec3 _e91 = h_1;
    vec3 reflected = (((2.0 * oh) * _e91) - wo_9);
    vec3 _e98 = h_1;
    vec3 _e100 = refracted(wo_9, _e98, o_6.ratio);
    vec3 beyond_2 = pick(isSolid_2, _e100, vec3(reflected.xy, -(reflected.z)));
    vec3 met = pick(crossing_1, beyond_2, reflected);
    lost = pick(!(isSmooth_1), (crossing_1 != (met.z < 0.0)), false);
    const bool _e111 = hasCoatNormals;
    if (_e111) {
        if (isCoat_1) {
            vec3 _e113 = frame.normal;
            lost = pick((dot(_e113, met) <= 0.0), true, pick((met.z < 0.0), (s_5.eta.x < 0.0), false));
        }
    }
    float _e129 = coatCosine(o_6.side, met);
    float _e130 = throughCover(o_6, abs(met.z), _e129, crossing_1);
    vec3 weight_1 = (_e130 * pick(crossing_1, (_e77.beyond / vec3(max((((1.0 - _e77.share) * o_6.ratio) * o_6.ratio), 1e-20))), (_e77.toward / vec3(max(_e77.share, 1e-20)))));
    drawn = LayeredSample(met, pick(isCoat_1, o_6.ofCoat, (o_6.ofFacets * pick(crossing_1, (1.0 - _e77.share), _e77.share))), pick(isCoat_1, vec3((o_6.coat / max(o_6.ofCoat, 1e-20))), (weight_1 / vec3(max(o_6.ofFacets, 1e-20)))), isSmooth_1);
    float _e176 = drawn.pdf;
    bool _e177 = lost;
    drawn.pdf = pick(_e177, 0.0, _e176);
    if (!(isFacet)) {
        float next = ((u_4.z - o_6.ofCoat) - o_6.ofFacets);
        float sine_2 = sqrt(max((u_4.x * (2.0 - u_4.x)), 0.0));
        float phi_3 = ((6.2831855 * u_4.y) - 3.1415927);
        vec3 even = vec3((sine_2 * cos(phi_3)), (sine_2 * sin(phi_3)), (1.0 - u_4.x));
        vec3 _e208 = sampleCosine(u_4.xy);
        vec3 below_1 = vec3(_e208.xy, pick((next >= (o_6.ofSheen + o_6.ofDiffuse)), -(_e208.z), _e208.z));
        drawn = LayeredSample(pick((next < o_6.ofSheen), even, below_1), 1.0, vec3(1.0), false);
    }
    float _e229 = drawn.direction.z;
    drawn.direction.z = (_e229 * o_6.side);
    LayeredSample _e232 = drawn;
    return _e232;
}

vec3 mirrored(vec3 wo_6) {
    return vec3(-(wo_6.xy), wo_6.z);
}

BsdfSample sampleLobe(Surface s_6, Outgoing o_7, vec3 u_5) {
    BsdfSample drawn_1 = BsdfSample(vec3(0.0), 0.0, vec3(0.0), false);
    vec3 wi = vec3(0.0);
    float probability = 0.0;
    vec3 weight = vec3(0.0);
    vec3 wo_10 = o_7.wo;
    float _e5 = mirrorShare(s_6.reflectivity);
    float base_1 = (1.0 - _e5);
    float choice = ((u_5.z - _e5) / base_1);
    vec3 _e12 = sampleCosine(u_5.xy);
    drawn_1 = BsdfSample(_e12, 1.0, vec3(1.0), false);
    const bool _e20 = hasConductors;
    const bool _e22 = hasMetallicRoughness;
    const bool _e25 = hasGlass;
    if (pick(pick(_e20, true, _e22), true, _e25)) {
        uint code_11 = uint(s_6.code);
        bool _e29 = isDielectric(code_11);
        bool _e30 = isSmooth(code_11);
        vec3 _e33 = sampleFacet(s_6.alpha, _e30, o_7, u_5.xy);
        float oh_1 = max(dot(wo_10, _e33), 0.0);
        vec3 _e38 = facetReflectance(s_6, oh_1, o_7.ratio);
        bool crossing_2 = pick(_e29, (choice >= _e38.x), false);
        wi = (((2.0 * oh_1) * _e33) - wo_10);
        probability = (base_1 * o_7.share);
        weight = (_e38 / vec3(o_7.share));
        const bool _e55 = hasGlass;
        if (_e55) {
            bool _e56 = isThin(code_11);
            vec3 _e57 = wi;
            vec3 _e59 = refracted(wo_10, _e33, o_7.ratio);
            wi = pick(crossing_2, pick(_e56, -(wo_10), _e59), _e57);
            float _e63 = probability;
            probability = pick(_e29, (base_1 * pick(crossing_2, (1.0 - _e38.x), _e38.x)), _e63);
            vec3 _e71 = weight;
            weight = pick(_e29, vec3(pick(pick(crossing_2, !(_e56), false), (1.0 / (o_7.ratio * o_7.ratio)), 1.0)), _e71);
        }
        float _e88 = wi.z;
        bool lost_1 = pick(!(_e30), (crossing_2 != ((wo_10.z < 0.0) != (_e88 < 0.0))), false);
        bool specular_1 = (choice < o_7.share);
        vec3 _e98 = drawn_1.direction;
        vec3 _e99 = wi;
        drawn_1.direction = pick(specular_1, _e99, _e98);
        float _e103 = drawn_1.pdf;
        float _e104 = probability;
        drawn_1.pdf = pick(specular_1, pick(lost_1, 0.0, _e104), _e103);
        vec3 _e110 = drawn_1.weight;
        vec3 _e111 = weight;
        drawn_1.weight = pick(specular_1, _e111, _e110);
        drawn_1.delta = pick(specular_1, _e30, false);
    }
    const bool _e116 = hasLayers;
    if (_e116) {
        bool _e121 = isLayered(uint(s_6.code), s_6.eta.x);
        if (_e121) {
            Stack _e123 = stackHere;
            LayeredSample _e126 = sampleLayered(s_6, _e123, vec3(u_5.xy, choice));
            drawn_1 = BsdfSample(_e126.direction, (base_1 * _e126.pdf), _e126.weight, _e126.delta);
        }
    }
    const bool _e134 = hasMirrorLayers;
    if (_e134) {
        bool reflected_1 = (u_5.z < _e5);
        vec3 _e139 = drawn_1.direction;
        vec3 _e140 = mirrored(wo_10);
        drawn_1.direction = pick(reflected_1, _e140, _e139);
        float _e144 = drawn_1.pdf;
        drawn_1.pdf = pick(reflected_1, _e5, _e144);
        vec3 _e148 = drawn_1.weight;
        drawn_1.weight = pick(reflected_1, vec3(1.0), _e148);
        bool _e154 = drawn_1.delta;
        drawn_1.delta = pick(_e154, true, reflected_1);
    }
    BsdfSample _e156 = drawn_1;
    return _e156;
}

float facetDensity(vec3 h_2, float alpha_9) {
    float slope = max(((dot(h_2.xy, h_2.xy) / (alpha_9 * alpha_9)) + (h_2.z * h_2.z)), 1.0);
    return (0.31830987 / (((alpha_9 * alpha_9) * slope) * slope));
}

bool hidesApart(uint code_8) {
    return ((code_8 & 64u) != 0u);
}

vec3 compensation(Surface s_7, float cosine_15) {
    uint code_12 = uint(s_7.code);
    bool _e8 = isDielectric(code_12);
    bool asked_1 = pick(((code_12 & 8u) != 0u), !(_e8), false);
    float _e12 = singleScatteringAlbedo(cosine_15, s_7.alpha);
    vec3 _e17 = facetReflectance(s_7, 1.0, 1.0);
    return pick(asked_1, (vec3(1.0) + (_e17 * ((1.0 - _e12) / _e12))), vec3(1.0));
}

FacetLobe evaluateFacets(Surface s_8, Outgoing o_8, vec3 wi_1) {
    vec3 passes = vec3(0.0);
    vec3 wo_11 = o_8.wo;
    bool _e6 = isDielectric(uint(s_8.code));
    const bool _e8 = hasGlass;
    bool crossing_3 = pick(_e8, ((wo_11.z < 0.0) != (wi_1.z < 0.0)), false);
    vec3 m_1 = (wo_11 + (wi_1 * pick(crossing_3, o_8.ratio, 1.0)));
    float m2_1 = max(dot(m_1, m_1), 1e-20);
    vec3 h_6 = (m_1 * inversesqrt(m2_1));
    float oh_2 = dot(wo_11, h_6);
    float ih = dot(wi_1, h_6);
    float zo = abs(wo_11.z);
    float zi_1 = abs(wi_1.z);
    bool faces = pick(!(crossing_3), true, pick((((oh_2 * h_6.z) * wo_11.z) >= 0.0), (((ih * h_6.z) * wi_1.z) >= 0.0), false));
    float _e54 = facetDensity(h_6, s_8.alpha);
    float spread = (pick(crossing_3, (abs((oh_2 * ih)) / m2_1), 0.25) * pick(faces, (2.0 * _e54), 0.0));
    vec3 _e62 = facetReflectance(s_8, abs(oh_2), o_8.ratio);
    passes = pick(crossing_3, (vec3(1.0) - _e62), _e62);
    float _e69 = stretched(wi_1, s_8.alpha);
    float apart = ((0.5 * (zo + o_8.stretched)) * (zi_1 + _e69));
    bool _e82 = hidesApart(uint(s_8.code));
    float masked = (zi_1 / max(pick(_e82, apart, ((zi_1 * o_8.stretched) + (zo * _e69))), 1e-20));
    float _e88 = passes.x;
    float chosen_1 = (pick(_e6, _e88, 1.0) * pick(crossing_3, (o_8.ratio * o_8.ratio), 1.0));
    const bool _e98 = hasCompensation;
    if (_e98) {
        vec3 _e99 = passes;
        vec3 _e100 = compensation(s_8, zo);
        passes = (_e99 * _e100);
    }
    vec3 _e102 = passes;
    return FacetLobe(((_e102 * spread) * masked), ((spread * chosen_1) / ((o_8.bound * zo) + o_8.stretched)), abs(oh_2));
}

vec4 evaluateBsdf(Surface s_9, Outgoing o_9, vec3 wi_2) {
    vec4 value = vec4(0.0);
    bool dark = false;
    vec3 base = vec3(0.0);
    float lambert = (0.31830987 * max(wi_2.z, 0.0));
    value = (vec4(s_9.baseColor, 1.0) * lambert);
    dark = pick((o_9.wo.z < 0.0), true, (wi_2.z <= 0.0));
    const bool _e23 = hasConductors;
    const bool _e25 = hasMetallicRoughness;
    const bool _e28 = hasGlass;
    if (pick(pick(_e23, true, _e25), true, _e28)) {
        uint code_13 = uint(s_9.code);
        FacetLobe _e32 = evaluateFacets(s_9, o_9, wi_2);
        const bool _e37 = hasMetallicRoughness;
        if (_e37) {
            vec3 _e38 = base;
            vec3 _e42 = metallicRoughnessDiffuse(s_9.baseColor, s_9.metallic, _e32.cosine);
            bool _e43 = isMetallicRoughness(code_13);
            base = pick(_e43, _e42, _e38);
        }
        bool _e52 = isSmooth(code_13);
        vec4 rough = pick(_e52, vec4(0.0), vec4(_e32.value, (o_9.share * _e32.pdf)));
        vec3 _e54 = base;
        vec4 _e61 = value;
        uint _e62 = kindOf(code_13);
        value = pick((_e62 == diffuse0_), _e61, (rough + (vec4(_e54, (1.0 - o_9.share)) * lambert)));
        bool _e66 = dark;
        bool _e67 = isSmooth(code_13);
        bool _e68 = isDielectric(code_13);
        dark = pick(_e68, _e67, _e66);
    }
    float _e71 = mirrorShare(s_9.reflectivity);
    vec4 _e74 = value;
    bool _e78 = dark;
    return pick(_e78, vec4(0.0), ((1.0 - _e71) * _e74));
}

float ellipticDensity(vec3 h_3, vec2 alpha_10) {
    vec2 scaled_1 = (h_3.xy / alpha_10);
    float slope_1 = max((dot(scaled_1, scaled_1) + (h_3.z * h_3.z)), 1.0);
    return (0.31830987 / (((alpha_10.x * alpha_10.y) * slope_1) * slope_1));
}

float shadowingExponent(float x, float alpha_11) {
    float m_2 = ((1.0 - alpha_11) * (1.0 - alpha_11));
    float a_2 = mix(21.5473, 25.3245, m_2);
    float b_4 = mix(3.82987, 3.32435, m_2);
    float c = mix(0.19823, 0.16801, m_2);
    float d = mix(-1.9776, -1.27393, m_2);
    float e = mix(-4.32054, -4.85967, m_2);
    return (((a_2 / (1.0 + (b_4 * pow(x, c)))) + (d * x)) + e);
}

float sheenShadowing(float cosine_16, float alpha_12) {
    float x_3 = clamp(cosine_16, 1e-6, 1.0);
    bool isLow = (x_3 < 0.5);
    float _e12 = shadowingExponent(pick(isLow, x_3, max((1.0 - x_3), 1e-6)), alpha_12);
    float _e14 = shadowingExponent(0.5, alpha_12);
    return exp(pick(isLow, _e12, ((2.0 * _e14) - _e12)));
}

float whiteSheen(vec3 wo_7, vec3 wi_3, float alpha_13) {
    vec3 m_3 = (wo_7 + wi_3);
    float m2_2 = max(dot(m_3, m_3), 1e-20);
    float sine2_3 = clamp((dot(m_3.xy, m_3.xy) / m2_2), 0.0, 1.0);
    float power = (0.5 / alpha_13);
    float density = (((2.0 + (2.0 * power)) * 0.15915494) * pick((sine2_3 < 1e-20), 0.0, exp((power * log(max(sine2_3, 1e-20))))));
    float zo_1 = max(wo_7.z, 1e-6);
    float _e38 = sheenShadowing(wo_7.z, alpha_13);
    float _e42 = sheenShadowing(wi_3.z, alpha_13);
    return (density / ((4.0 * zo_1) * ((1.0 + _e38) + _e42)));
}

float sheenAlpha(float roughness_1) {
    float r = max(roughness_1, 0.07);
    return (r * r);
}

float ofBeyond(Stack o_10) {
    return max(((((1.0 - o_10.ofCoat) - o_10.ofFacets) - o_10.ofSheen) - o_10.ofDiffuse), 0.0);
}

vec4 evaluateLayered(Surface s_10, Stack o_11, vec3 given_1) {
    vec4 sum_1 = vec4(0.0);
    float intoBody = 0.0;
    bool isCoat = false;
    vec3 ownWo_1 = vec3(0.0);
    vec3 ownWi = vec3(0.0);
    vec3 ownH = vec3(0.0);
    vec3 lobe = vec3(0.0);
    float chosen = 0.0;
    Layers l_5 = o_11.layers;
    vec3 wo_12 = o_11.wo;
    vec3 wi_4 = vec3(given_1.xy, (given_1.z * o_11.side));
    bool crossing_4 = (wi_4.z < 0.0);
    vec3 facing = vec3(wi_4.xy, abs(wi_4.z));
    float zi_2 = facing.z;
    float _e19 = coatCosine(o_11.side, wi_4);
    float _e20 = throughCover(o_11, zi_2, _e19, crossing_4);
    isCoat = pick((o_11.coat > 0.0), true, (s_10.metallic < 1.0));
    const bool _e35 = hasCoatNormals;
    bool coatEnds = pick(crossing_4, !(pick(_e35, (s_10.eta.x >= 0.0), false)), false);
    while(true) {
        bool _e43 = isCoat;
        bool bends = pick(pick(crossing_4, !(_e43), false), (l_5.solid > 0.0), false);
        bool _e53 = isCoat;
        vec2 alpha_16 = pick(_e53, vec2(o_11.coatAlpha), o_11.alpha);
        bool isSmooth_2 = (max(alpha_16.x, alpha_16.y) < 0.001);
        vec2 wide_1 = max(alpha_16, vec2(0.001));
        bool _e63 = isCoat;
        vec3 met_1 = pick(pick(bends, true, pick(_e63, !(coatEnds), false)), wi_4, facing);
        vec3 m_4 = (wo_12 + (met_1 * pick(bends, o_11.ratio, 1.0)));
        float m2_3 = max(dot(m_4, m_4), 1e-20);
        vec3 h_7 = (m_4 * inversesqrt(m2_3));
        float oh_3 = dot(wo_12, h_7);
        float ih_1 = dot(met_1, h_7);
        ownWo_1 = wo_12;
        ownWi = met_1;
        ownH = h_7;
        const bool _e84 = hasCoatNormals;
        if (_e84) {
            bool _e85 = isCoat;
            if (_e85) {
                vec3 _e87 = coatNormal(o_11.side);
                Basis _e88 = basisAbout(_e87);
                vec3 _e89 = toLocal(_e88, wo_12);
                ownWo_1 = _e89;
                vec3 _e90 = toLocal(_e88, met_1);
                ownWi = _e90;
                vec3 _e91 = toLocal(_e88, h_7);
                ownH = _e91;
            }
        }
        float _e93 = ownH.z;
        float _e98 = ownH.z;
        float _e101 = ownWi.z;
        float _e107 = ownWi.z;
        bool faces_1 = pick(pick(((oh_3 * _e93) >= 0.0), (((ih_1 * _e98) * _e101) >= 0.0), false), pick(bends, true, (_e107 >= 0.0)), false);
        vec3 _e117 = ownH;
        float _e118 = ellipticDensity(_e117, wide_1);
        float spread_1 = (pick(bends, (abs((oh_3 * ih_1)) / m2_3), 0.25) * pick(pick(faces_1, !(isSmooth_2), false), (2.0 * _e118), 0.0));
        vec3 _e126 = ownWo_1;
        float _e127 = ellipticStretched(_e126, wide_1);
        float _e129 = ownWi.z;
        float ownZi = abs(_e129);
        float _e133 = ownWo_1.z;
        vec3 _e134 = ownWi;
        float _e135 = ellipticStretched(_e134, wide_1);
        float masked_1 = (ownZi / max(((ownZi * _e127) + (_e133 * _e135)), 1e-20));
        vec3 _e141 = ownWo_1;
        float _e142 = ellipticBound(_e141, wide_1);
        bool _e146 = isCoat;
        float bound_3 = pick(pick((l_5.solid > 0.0), !(_e146), false), 1.0, _e142);
        float _e152 = ownWo_1.z;
        float density_1 = (spread_1 / ((bound_3 * _e152) + _e127));
        bool _e160 = isCoat;
        vec4 _e164 = baseReflectance(s_10, o_11, pick(pick(_e160, o_11.inside, false), wo_12.z, min(abs(oh_3), 1.0)));
        Parting _e165 = partingOf(s_10, o_11, _e164);
        lobe = (_e20 * pick(crossing_4, _e165.beyond, (_e165.toward * o_11.more)));
        chosen = ((o_11.ofFacets * pick(crossing_4, (1.0 - _e165.share), _e165.share)) * pick(bends, (o_11.ratio * o_11.ratio), 1.0));
        bool _e187 = isCoat;
        if (_e187) {
            intoBody = _e164.w;
            lobe = vec3(pick(coatEnds, 0.0, o_11.coat));
            chosen = pick(coatEnds, 0.0, o_11.ofCoat);
        }
        vec4 _e196 = sum_1;
        vec3 _e197 = lobe;
        float _e200 = chosen;
        sum_1 = (_e196 + vec4((_e197 * (spread_1 * masked_1)), (_e200 * density_1)));
        bool _e204 = isCoat;
        if (!(_e204)) {
            break;
        }
        isCoat = false;
    }
    if (pick(pick((o_11.sheenColor > 0.0), !(crossing_4), false), !(o_11.inside), false)) {
        float _e217 = sheenAlbedo(zi_2, l_5.sheenRoughness);
        float most = max(max(o_11.sheen, _e217), 1.0);
        float _e225 = sheenAlpha(l_5.sheenRoughness);
        float _e226 = whiteSheen(wo_12, wi_4, _e225);
        float fibres_1 = (((1.0 - o_11.coat) * _e226) / most);
        vec4 _e229 = sum_1;
        sum_1 = (_e229 + vec4((fibres_1 * l_5.sheenColor), (o_11.ofSheen * 0.15915494)));
    }
    vec3 body_1 = pick(crossing_4, (l_5.beyond * l_5.beyondColor), ((1.0 - l_5.beyond) * s_10.baseColor));
    float _e246 = intoBody;
    vec3 matte = (((_e20 * _e246) * (1.0 - l_5.transmission)) * body_1);
    vec4 _e253 = sum_1;
    float _e255 = ofBeyond(o_11);
    return (_e253 + (vec4(matte, pick(crossing_4, _e255, o_11.ofDiffuse)) * (0.31830987 * zi_2)));
}

Pair evaluatePair(Surface s_11, Outgoing o_12, vec3 toLight, vec3 toSample) {
    Pair pair = Pair(vec4(0.0), vec4(0.0));
    bool isLight = false;
    vec4 _e4 = evaluateBsdf(s_11, o_12, toLight);
    vec4 _e5 = evaluateBsdf(s_11, o_12, toSample);
    pair = Pair(_e4, _e5);
    const bool _e9 = hasLayers;
    if (_e9) {
        bool _e14 = isLayered(uint(s_11.code), s_11.eta.x);
        if (_e14) {
            uint _e17 = frame.emitterCount;
            isLight = (_e17 > 0u);
            while(true) {
                float _e22 = mirrorShare(s_11.reflectivity);
                Stack _e26 = stackHere;
                bool _e27 = isLight;
                vec4 _e29 = evaluateLayered(s_11, _e26, pick(_e27, toLight, toSample));
                vec4 value_2 = ((1.0 - _e22) * _e29);
                bool _e31 = isLight;
                if (_e31) {
                    pair.toLight = value_2;
                } else {
                    pair.toSample = value_2;
                }
                bool _e34 = isLight;
                if (!(_e34)) {
                    break;
                }
                isLight = false;
            }
        }
    }
    Pair _e37 = pair;
    return _e37;
}

BsdfSample completed(BsdfSample drawn_2, vec4 value_1) {
    float pdf = pick((drawn_2.pdf <= 0.0), 0.0, value_1.w);
    vec3 weight_2 = pick((pdf > 0.0), (value_1.xyz / vec3(max(pdf, 1e-30))), vec3(0.0));
    return BsdfSample(drawn_2.direction, pick(drawn_2.delta, drawn_2.pdf, pdf), pick(drawn_2.delta, drawn_2.weight, weight_2), drawn_2.delta);
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
    Pair _e80 = evaluatePair(_e34, _e75, b_5.xyz, _e77.direction);
    if ((asked_2 == evaluation)) {
        _fs2p_location0 = _e80.toLight;
        return;
    }
    BsdfSample _e85 = completed(_e77, _e80.toSample);
    if ((asked_2 == sampledDirection)) {
        _fs2p_location0 = vec4(_e85.direction, _e85.pdf);
        return;
    }
    _fs2p_location0 = vec4(_e85.weight, pick(_e85.delta, 1.0, 0.0));
    return;
}

