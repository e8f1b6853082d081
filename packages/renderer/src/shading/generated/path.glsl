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

struct Film {
    vec4 sums;
    vec4 squares;
};
struct LeftTriangle {
    uint instance;
    uint triangle;
};
struct RayPair {
    vec3 point;
    uint shape;
    LeftTriangle left;
    float tMin;
    bool goesOn;
    vec3 direction;
    bool inwards;
    vec3 lightDirection;
    bool lightInwards;
    float lightDistance;
    uint lightShape;
    uint number;
};
struct Odds {
    float total;
    float tree;
};
struct Sampler {
    uint key;
    uint salt;
    uint sample_;
    uint place;
};
struct Path {
    RayPair rays;
    vec3 light;
    bool alive;
    vec3 throughput;
    bool escaped;
    uint depth;
    vec3 radiance;
    float pdf;
    vec3 litSide;
    Odds odds;
    Sampler sampler_;
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
};
struct Groups {
    uvec2 index;
    uvec2 shift;
    uvec2 seedA;
    uvec2 seedB;
};
struct CameraRay {
    vec3 origin;
    vec3 direction;
};
struct PairHit {
    float t;
    uint shape;
    bool blocked;
    LeftTriangle triangle;
    vec2 weights;
};
struct Bounds {
    vec3 center;
    float radius;
};
struct Extent {
    vec4 a;
    vec4 b;
};
struct Slabs {
    vec3 enter;
    vec3 leave;
    float near;
    float far;
};
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
struct SurfacePoint {
    Surface surface;
    vec3 geometric;
    vec3 shading;
};
struct Normals {
    vec3 geometric;
    vec3 shading;
};
struct Basis {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
};
struct Emitter {
    vec3 position;
    float kind;
    vec3 u;
    float radius;
    vec3 v;
    float cosInner;
    vec3 radiance;
    float area;
    float shape;
    float oneSided;
    float power;
    float reach;
    float leaf;
    float table;
    float triangles;
    float instance;
};
struct SphereView {
    vec3 toCenter;
    float distance_;
    float power;
    bool inside;
    float width;
};
struct QuadView {
    vec3 corner;
    vec3 axisX;
    vec3 axisY;
    vec3 axisZ;
    vec2 low;
    vec2 high;
    float height;
    float start;
    float solidAngle;
    bool lit;
    bool bySolidAngle;
};
struct BoxView {
    vec4 rotation;
    vec3 point;
    vec3 faces;
    float area;
    bool inside;
};
struct TwoPoints {
    vec3 first;
    vec3 second;
};
struct EmitterChoice {
    uint index;
    float probability;
    Odds odds;
};
struct LightSample {
    vec3 direction;
    float distance_;
    vec3 radiance;
    float pdf;
    bool delta;
};
struct ConeDirection {
    vec3 direction;
    float cosine;
    float sine2_;
};
struct EnvironmentLight {
    vec3 radiance;
    float pdf;
};
struct EnvironmentSample {
    vec3 direction;
    EnvironmentLight light;
};
struct ChosenCell {
    uvec2 cell;
    vec2 rest;
};
struct Table {
    uint first;
    uint entries;
};
struct Choice {
    uint entry;
    float rest;
};
struct Corners {
    vec4 a;
    vec4 b;
    vec4 c;
    vec4 d;
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
struct Pair {
    vec4 toLight;
    BsdfSample drawn;
};
struct FacetLobe {
    vec3 value;
    float pdf;
    float cosine;
};
struct FarLight {
    vec3 radiance;
    float pdf;
};
const uint noShape = 4294967295u;
const uint noInstance = 4294967295u;
const LeftTriangle noTriangle = LeftTriangle(4294967295u, 0u);
const uint dielectric = 3u;
const bool hasTransmission = false;
const bool hasLayers = false;
const uint metallicRoughness = 1u;
const EnvironmentLight white = EnvironmentLight(vec3(1.0), 0.07957747);
const uint conductor = 2u;
const uint diffuse0_ = 0u;
const bool hasMeshes = false;
const uint rouletteDepth = 5u;
const uint instances = 2147483648u;

layout(std140) uniform FrameBlock { Frame frame; };

const bool hasFilter = false;

const bool hasLens = false;

const bool hasOtherProjections = false;

const bool hasSpheres = true;

uniform highp sampler2D sceneTable;

const bool hasBoxes = true;

const bool hasTurnedBoxes = true;

const bool hasQuads = false;

const bool hasPlanes = true;

const bool hasGlass = false;

const bool hasMetallicRoughness = false;

const bool hasManyLights = true;

const bool hasSphereLights = true;

const bool hasQuadLights = false;

const bool hasBoxLights = false;

const bool hasSuns = false;

const bool hasPointLights = false;

const bool hasSky = true;

const bool hasEnvironment = false;

uniform highp sampler2D environment;

const bool hasConductors = false;

const bool hasMirrorLayers = true;

const bool hasCompensation = false;

uniform highp sampler2D previousFilm;

uniform highp sampler2D previousSquares;

layout(location = 0) out vec4 _fs2p_location0;
layout(location = 1) out vec4 _fs2p_location1;

uint pcg(uint x) {
    uint s_19 = ((x * 747796405u) + 2891336453u);
    uint w_2 = (((s_19 >> ((s_19 >> 28u) + 4u)) ^ s_19) * 277803737u);
    return ((w_2 >> 22u) ^ w_2);
}

uint pixelHash(uvec2 pixel, uint sampleIndex, uint seed) {
    uint _e5 = pcg(seed);
    uint _e7 = pcg((sampleIndex + _e5));
    uint _e9 = pcg((pixel.y + _e7));
    uint _e11 = pcg((pixel.x + _e9));
    return _e11;
}

uint spread0_(uint x_1) {
    uint y_8 = ((x_1 | (x_1 * 4u)) & 51u);
    return ((y_8 | (y_8 * 2u)) & 85u);
}

uvec2 reversedHigh(uvec2 x_2) {
    uvec2 y = uvec2(0u);
    y = (x_2 + ((x_2 & uvec2(21845u)) * 3u));
    uvec2 _e8 = y;
    uvec2 _e9 = y;
    y = (_e8 + ((_e9 & uvec2(26214u)) * 15u));
    uvec2 _e16 = y;
    uvec2 _e17 = y;
    y = (_e16 + ((_e17 & uvec2(30840u)) * 255u));
    uvec2 _e24 = y;
    uvec2 _e25 = y;
    return (_e24 + ((_e25 & uvec2(32640u)) * 65535u));
}

uvec2 reversed(uvec2 x_3) {
    uvec2 _e1 = reversedHigh(x_3);
    return (_e1 >> uvec2(15u));
}

uvec2 mixBits2_(uvec2 x_4) {
    uvec2 y_1 = uvec2(0u);
    y_1 = ((x_4 ^ (x_4 >> uvec2(16u))) * 569420461u);
    uvec2 _e8 = y_1;
    uvec2 _e9 = y_1;
    y_1 = ((_e8 ^ (_e9 >> uvec2(15u))) * 1935289751u);
    uvec2 _e16 = y_1;
    uvec2 _e17 = y_1;
    return (_e16 ^ (_e17 >> uvec2(15u)));
}

uint mixBits(uint x_5) {
    uvec2 _e2 = mixBits2_(uvec2(x_5));
    return _e2.x;
}

Sampler startSampler(uvec2 pixel_1, uint sampleIndex_1, uint seed_1) {
    uint _e5 = frame.independent;
    bool independent = (_e5 != 0u);
    uint _e15 = pixelHash(pick(independent, pixel_1, (pixel_1 >> uvec2(4u))), pick(independent, sampleIndex_1, (sampleIndex_1 >> 16u)), seed_1);
    uint _e19 = spread0_((pixel_1.x & 15u));
    uint _e23 = spread0_((pixel_1.y & 15u));
    uint place_1 = (_e19 | (_e23 * 2u));
    uvec2 _e32 = reversed(uvec2((sampleIndex_1 & 65535u), (place_1 * 256u)));
    uvec2 digits_2 = pick(independent, uvec2(0u), _e32);
    uint _e38 = mixBits((_e15 ^ 1779033703u));
    return Sampler(_e15, _e38, digits_2.x, digits_2.y);
}

float filterAxis(float u) {
    float across = ((2.0 * u) - 1.0);
    float x_16 = (16.0 - (16.0 * sqrt((1.0 - abs(across)))));
    float piece = min(floor(x_16), 15.0);
    float t_4 = (x_16 - piece);
    vec4 c = frame.filterPieces[uint(piece)];
    float offset_2 = (c.x + (t_4 * (c.y + (t_4 * (c.z + (t_4 * c.w))))));
    return pick((across < 0.0), -(offset_2), offset_2);
}

vec2 filterOffset(vec2 u_1) {
    vec2 offset = vec2(0.0);
    offset = (u_1 - vec2(0.5));
    const bool _e6 = hasFilter;
    if (_e6) {
        float _e8 = filterAxis(u_1.x);
        float _e10 = filterAxis(u_1.y);
        offset = vec2(_e8, _e10);
    }
    vec2 _e12 = offset;
    return _e12;
}

uvec2 scramble(uvec2 x_6, uvec2 seed_2) {
    uvec2 y_2 = uvec2(0u);
    y_2 = (x_6 ^ (x_6 * 1025551850u));
    uvec2 _e6 = y_2;
    y_2 = ((_e6 + seed_2) * ((seed_2 >> uvec2(16u)) | uvec2(1u)));
    uvec2 _e15 = y_2;
    uvec2 _e16 = y_2;
    y_2 = (_e15 ^ (_e16 * 89287766u));
    uvec2 _e20 = y_2;
    uvec2 _e21 = y_2;
    return (_e20 ^ (_e21 * 1403136100u));
}

uvec2 timesW(uvec2 x_7) {
    return (((x_7 ^ (x_7 * 2u)) & uvec2(43690u)) | ((x_7 >> uvec2(1u)) & uvec2(21845u)));
}

uvec2 timesW2_(uvec2 x_8) {
    return (((x_8 * 2u) & uvec2(43690u)) | ((x_8 ^ (x_8 >> uvec2(1u))) & uvec2(21845u)));
}

uvec2 shiftOfPlace(uvec2 x_9) {
    uvec2 y_3 = uvec2(0u);
    uvec2 _e7 = timesW(((x_9 >> uvec2(2u)) & uvec2(51u)));
    y_3 = (x_9 ^ _e7);
    uvec2 _e10 = y_3;
    uvec2 _e11 = y_3;
    uvec2 _e18 = timesW2_(((_e11 >> uvec2(4u)) & uvec2(15u)));
    y_3 = (_e10 ^ _e18);
    uvec2 _e20 = y_3;
    uvec2 _e21 = timesW(_e20);
    uvec2 _e22 = y_3;
    return (_e21 | (_e22 * 256u));
}

Groups nextGroups(Sampler s) {
    uvec2 _e7 = mixBits2_((uvec2(s.key) + uvec2(1u, 2u)));
    uvec2 half_ = ((_e7 ^ uvec2(s.salt)) * 2654435761u);
    uvec2 b_5 = (half_ ^ (half_ >> uvec2(16u)));
    uvec2 _e19 = scramble(uvec2(s.place), b_5);
    uvec2 own_1 = (s.sample_ * ((_e19 >> uvec2(7u)) & uvec2(4294967294u)));
    uvec2 _e31 = scramble((uvec2(s.sample_) ^ own_1), _e7);
    uvec2 _e35 = reversed((_e31 & uvec2(65535u)));
    uvec2 _e39 = shiftOfPlace((_e19 & uvec2(255u)));
    return Groups(_e35, _e39, ((_e7 >> uvec2(16u)) | (_e7 * 65536u)), ((b_5 >> uvec2(16u)) | (b_5 * 65536u)));
}

void skipGroup(inout Sampler s_1) {
    uint _e3 = s_1.key;
    s_1.key = (_e3 + 1u);
    return;
}

vec2 toUnit(uvec2 scrambled) {
    uvec2 _e4 = reversedHigh((scrambled & uvec2(65535u)));
    vec2 digits_3 = (vec2(ivec2(_e4)) * 4.656613e-10);
    return (digits_3 + (vec2((scrambled & uvec2(4278190080u))) * 3.5527137e-15));
}

vec2 firstOf(Groups g) {
    uvec2 _e5 = scramble((g.index ^ g.shift), g.seedA);
    vec2 _e6 = toUnit(_e5);
    return _e6;
}

uvec2 pascal(uvec2 x_10) {
    uvec2 y_4 = uvec2(0u);
    y_4 = (x_10 ^ ((x_10 >> uvec2(1u)) & uvec2(21845u)));
    uvec2 _e9 = y_4;
    uvec2 _e10 = y_4;
    y_4 = (_e9 ^ ((_e10 >> uvec2(2u)) & uvec2(13107u)));
    uvec2 _e18 = y_4;
    uvec2 _e19 = y_4;
    y_4 = (_e18 ^ ((_e19 >> uvec2(4u)) & uvec2(3855u)));
    uvec2 _e27 = y_4;
    uvec2 _e28 = y_4;
    return (_e27 ^ ((_e28 >> uvec2(8u)) & uvec2(255u)));
}

vec2 secondOf(Groups g_1) {
    uvec2 _e3 = timesW(g_1.shift);
    uvec2 _e5 = pascal((g_1.index ^ _e3));
    uvec2 _e7 = scramble(_e5, g_1.seedB);
    vec2 _e8 = toUnit(_e7);
    return _e8;
}

vec2 next2d(inout Sampler s_2) {
    Sampler _e1 = s_2;
    Groups _e2 = nextGroups(_e1);
    skipGroup(s_2);
    vec2 _e3 = firstOf(_e2);
    vec2 _e5 = secondOf(_e2);
    return vec2(_e3.x, _e5.x);
}

vec2 concentricDisc(vec2 u_2) {
    vec2 p_14 = ((2.0 * u_2) - vec2(1.0));
    bool wide = (abs(p_14.x) > abs(p_14.y));
    float radius_1 = pick(wide, p_14.x, p_14.y);
    float ratio_4 = (pick(wide, p_14.y, p_14.x) / pick((radius_1 == 0.0), 1.0, radius_1));
    float angle = pick(wide, (0.7853982 * ratio_4), (1.5707964 - (0.7853982 * ratio_4)));
    return (radius_1 * vec2(cos(angle), sin(angle)));
}

CameraRay rayThroughLens(vec2 filmPosition, vec2 lensPoint) {
    CameraRay ray = CameraRay(vec3(0.0), vec3(0.0));
    float _e7 = frame.width;
    float x_17 = (((2.0 * filmPosition.x) / _e7) - 1.0);
    float _e16 = frame.height;
    float y_9 = (1.0 - ((2.0 * filmPosition.y) / _e16));
    vec3 _e22 = frame.right;
    vec3 _e26 = frame.up;
    vec3 across_1 = ((x_17 * _e22) + (y_9 * _e26));
    const bool _e30 = hasOtherProjections;
    uint _e33 = frame.projection;
    bool orthographic = pick(_e30, (_e33 == 1u), false);
    vec3 _e39 = frame.forward;
    vec3 _e43 = frame.forward;
    vec3 ahead = pick(orthographic, _e43, (_e39 + across_1));
    float _e47 = frame.aperture;
    vec3 _e51 = frame.right;
    vec3 _e57 = frame.up;
    vec3 lens_1 = (_e47 * ((lensPoint.x * normalize(_e51)) + (lensPoint.y * normalize(_e57))));
    float _e66 = frame.focusDistance;
    ray = CameraRay(pick(orthographic, (across_1 + lens_1), lens_1), normalize((ahead - (lens_1 / vec3(_e66)))));
    const bool _e74 = hasOtherProjections;
    if (_e74) {
        uint _e77 = frame.projection;
        if ((_e77 == 2u)) {
            float longitude = (3.1415927 * x_17);
            float latitude = (1.5707964 * y_9);
            vec3 _e87 = frame.right;
            vec3 _e92 = frame.forward;
            vec3 level = ((sin(longitude) * _e87) + (cos(longitude) * _e92));
            vec3 _e102 = frame.up;
            ray = CameraRay(vec3(0.0), normalize(((cos(latitude) * level) + (sin(latitude) * _e102))));
        }
    }
    CameraRay _e107 = ray;
    return _e107;
}

CameraRay cameraRay(vec2 filmPosition_1, vec2 lens) {
    vec2 lensPoint_1 = vec2(0.0);
    const bool _e6 = hasLens;
    if (_e6) {
        vec2 _e7 = concentricDisc(lens);
        lensPoint_1 = _e7;
    }
    vec2 _e8 = lensPoint_1;
    CameraRay _e9 = rayThroughLens(filmPosition_1, _e8);
    return _e9;
}

vec2 lensPoint_2(inout Sampler s_3) {
    vec2 u_3 = vec2(0.5);
    const bool _e5 = hasLens;
    if (_e5) {
        vec2 _e6 = next2d(s_3);
        u_3 = _e6;
    } else {
        skipGroup(s_3);
    }
    vec2 _e7 = u_3;
    return _e7;
}

RayPair oneRay(vec3 origin, vec3 direction, uint number) {
    return RayPair(origin, noShape, noTriangle, 0.0, true, direction, false, direction, false, -1.0, noShape, number);
}

uint numberOfNext(Sampler s_4) {
    uint _e8 = mixBits((((s_4.key + 1u) ^ s_4.salt) ^ 2246822507u));
    uint _e15 = mixBits((_e8 + ((s_4.sample_ << 8u) | s_4.place)));
    return _e15;
}

Path startPath(uvec2 pixel_2, uint sampleIndex_2) {
    Sampler s_5 = Sampler(0u, 0u, 0u, 0u);
    uint _e4 = frame.seed;
    Sampler _e5 = startSampler(pixel_2, sampleIndex_2, _e4);
    s_5 = _e5;
    vec2 _e11 = next2d(s_5);
    vec2 _e12 = filterOffset(_e11);
    vec2 filmPosition_2 = ((vec2(pixel_2) + vec2(0.5)) + _e12);
    vec2 _e14 = lensPoint_2(s_5);
    CameraRay _e15 = cameraRay(filmPosition_2, _e14);
    Sampler _e18 = s_5;
    uint _e19 = numberOfNext(_e18);
    RayPair _e20 = oneRay(_e15.origin, _e15.direction, _e19);
    Sampler _e35 = s_5;
    return Path(_e20, vec3(0.0), true, vec3(1.0), false, 1u, vec3(0.0), 0.0, vec3(0.0), Odds(1.0, 0.0), _e35);
}

vec4 tableTexel(uint column, uint row) {
    vec4 _e5 = texelFetch(sceneTable, ivec2(uvec2(column, row)), 0);
    return _e5;
}

Bounds fetchBounds(uint i) {
    vec4 _e2 = tableTexel(0u, i);
    return Bounds(_e2.xyz, _e2.w);
}

float intersectSphere(vec3 origin_1, vec3 direction_1, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter = (center - origin_1);
    float along = dot(toCenter, direction_1);
    vec3 across_2 = (toCenter - (along * direction_1));
    float discriminant = ((radius * radius) - dot(across_2, across_2));
    float half_1 = sqrt(max(discriminant, 0.0));
    float near = (along - half_1);
    float far_2 = (along + half_1);
    float t_5 = pick((near > tMin), near, far_2);
    return pick(startsInside, max(far_2, 0.0), pick(pick((discriminant >= 0.0), (t_5 > tMin), false), t_5, 1e30));
}

PairHit meet(PairHit found, RayPair p_1, uint i_1, vec2 t) {
    bool own_2 = (i_1 == p_1.shape);
    float pathT = pick(pick(own_2, !(p_1.inwards), false), 1e30, t.x);
    float lightT = pick(pick(pick(own_2, !(p_1.lightInwards), false), true, (i_1 == p_1.lightShape)), 1e30, t.y);
    bool nearer = (pathT < found.t);
    return PairHit(pick(nearer, pathT, found.t), pick(nearer, i_1, found.shape), pick(found.blocked, true, (lightT < p_1.lightDistance)), noTriangle, vec2(0.0));
}

PairHit meetSphere(PairHit found_1, RayPair p_2, uint i_2) {
    Bounds _e3 = fetchBounds(i_2);
    bool own_3 = (i_2 == p_2.shape);
    float _e13 = intersectSphere(p_2.point, p_2.direction, _e3.center, _e3.radius, p_2.tMin, pick(own_3, p_2.inwards, false));
    float _e21 = intersectSphere(p_2.point, p_2.lightDirection, _e3.center, _e3.radius, p_2.tMin, pick(own_3, p_2.lightInwards, false));
    PairHit _e23 = meet(found_1, p_2, i_2, vec2(_e13, _e21));
    return _e23;
}

Extent fetchExtent(uint i_3) {
    vec4 _e2 = tableTexel(1u, i_3);
    vec4 _e4 = tableTexel(2u, i_3);
    return Extent(_e2.xyzw, _e4.xyzw);
}

vec3 rotate(vec4 q, vec3 v) {
    vec3 t_6 = (2.0 * cross(q.xyz, v));
    return ((v + (q.w * t_6)) + cross(q.xyz, t_6));
}

vec3 turned(vec4 q_1, vec3 v_1) {
    vec3 w = vec3(0.0);
    w = v_1;
    const bool _e4 = hasTurnedBoxes;
    if (_e4) {
        vec3 _e5 = rotate(q_1, v_1);
        w = _e5;
    }
    vec3 _e6 = w;
    return _e6;
}

vec3 safeReciprocal(vec3 d, vec3 origin_2) {
    vec3 tiny = mix(vec3(1e-18), vec3(-1e-18), greaterThan(origin_2, vec3(0.0)));
    return (vec3(1.0) / mix(d, tiny, lessThan(abs(d), vec3(1e-18))));
}

Slabs boxSlabs(vec3 origin_3, vec3 direction_2, vec3 halfSize) {
    vec3 _e3 = safeReciprocal(direction_2, origin_3);
    vec3 middle = (-(origin_3) * _e3);
    vec3 reach = (halfSize * abs(_e3));
    vec3 enter = (middle - reach);
    vec3 leave = (middle + reach);
    return Slabs(enter, leave, max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}

float intersectBox(vec3 origin_4, vec3 direction_3, vec3 halfSize_1, float tMin_1, bool startsInside_1) {
    Slabs _e5 = boxSlabs(origin_4, direction_3, halfSize_1);
    float t_7 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_7 > tMin_1), false), t_7, 1e30));
}

PairHit meetBox(PairHit found_2, RayPair p_3, uint i_4) {
    Bounds _e3 = fetchBounds(i_4);
    Extent _e4 = fetchExtent(i_4);
    bool own_4 = (i_4 == p_3.shape);
    vec3 _e11 = turned(_e4.a, (p_3.point - _e3.center));
    vec3 _e14 = turned(_e4.a, p_3.direction);
    float _e20 = intersectBox(_e11, _e14, _e4.b.xyz, p_3.tMin, pick(own_4, p_3.inwards, false));
    vec3 _e23 = turned(_e4.a, p_3.lightDirection);
    float _e29 = intersectBox(_e11, _e23, _e4.b.xyz, p_3.tMin, pick(own_4, p_3.lightInwards, false));
    PairHit _e31 = meet(found_2, p_3, i_4, vec2(_e20, _e29));
    return _e31;
}

float intersectQuad(vec3 origin_5, vec3 direction_4, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_7 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_4, normal_7);
    vec3 toCenter_1 = (center_1 - origin_5);
    float t_8 = (dot(toCenter_1, normal_7) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_15 = ((t_8 * direction_4) - toCenter_1);
    bool within = (max(abs(dot(p_15, reciprocalU)), abs(dot(p_15, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_8 > tMin_2), (t_8 < 1e30), false), within, false), t_8, 1e30);
}

PairHit meetQuad(PairHit found_3, RayPair p_4, uint i_5) {
    Bounds _e3 = fetchBounds(i_5);
    Extent _e4 = fetchExtent(i_5);
    float _e13 = intersectQuad(p_4.point, p_4.direction, _e3.center, _e4.a.xyz, _e4.b.xyz, p_4.tMin);
    float _e22 = intersectQuad(p_4.point, p_4.lightDirection, _e3.center, _e4.a.xyz, _e4.b.xyz, p_4.tMin);
    PairHit _e24 = meet(found_3, p_4, i_5, vec2(_e13, _e22));
    return _e24;
}

float intersectPlane(vec3 origin_6, vec3 direction_5, vec3 normal, float offset_1, float tMin_3) {
    float speed_1 = dot(direction_5, normal);
    float t_9 = ((offset_1 - dot(origin_6, normal)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset_1 > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_9 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset_1 == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_9, 0.0), 1e30);
}

PairHit meetPlane(PairHit found_4, RayPair p_5, uint i_6) {
    Bounds _e3 = fetchBounds(i_6);
    float _e9 = intersectPlane(p_5.point, p_5.direction, _e3.center, _e3.radius, p_5.tMin);
    float _e15 = intersectPlane(p_5.point, p_5.lightDirection, _e3.center, _e3.radius, p_5.tMin);
    PairHit _e17 = meet(found_4, p_5, i_6, vec2(_e9, _e15));
    return _e17;
}

PairHit tracePair(RayPair p_6) {
    PairHit found_5 = PairHit(1e30, 4294967295u, false, LeftTriangle(4294967295u, 0u), vec2(0.0));
    uint i_7 = 0u;
    uvec4 ends_1 = frame.shapeEnds;
    const bool _e17 = hasSpheres;
    if (_e17) {
        uint _e18 = i_7;
        if ((_e18 < ends_1.x)) {
            while(true) {
                PairHit _e21 = found_5;
                uint _e22 = i_7;
                PairHit _e23 = meetSphere(_e21, p_6, _e22);
                found_5 = _e23;
                uint _e25 = i_7;
                i_7 = (_e25 + 1u);
                uint _e27 = i_7;
                if ((_e27 >= ends_1.x)) {
                    break;
                }
            }
        }
    }
    const bool _e31 = hasBoxes;
    if (_e31) {
        uint _e32 = i_7;
        if ((_e32 < ends_1.y)) {
            while(true) {
                PairHit _e35 = found_5;
                uint _e36 = i_7;
                PairHit _e37 = meetBox(_e35, p_6, _e36);
                found_5 = _e37;
                uint _e39 = i_7;
                i_7 = (_e39 + 1u);
                uint _e41 = i_7;
                if ((_e41 >= ends_1.y)) {
                    break;
                }
            }
        }
    }
    const bool _e45 = hasQuads;
    if (_e45) {
        uint _e46 = i_7;
        if ((_e46 < ends_1.z)) {
            while(true) {
                PairHit _e49 = found_5;
                uint _e50 = i_7;
                PairHit _e51 = meetQuad(_e49, p_6, _e50);
                found_5 = _e51;
                uint _e53 = i_7;
                i_7 = (_e53 + 1u);
                uint _e55 = i_7;
                if ((_e55 >= ends_1.z)) {
                    break;
                }
            }
        }
    }
    const bool _e59 = hasPlanes;
    if (_e59) {
        uint _e60 = i_7;
        if ((_e60 < ends_1.w)) {
            while(true) {
                PairHit _e63 = found_5;
                uint _e64 = i_7;
                PairHit _e65 = meetPlane(_e63, p_6, _e64);
                found_5 = _e65;
                uint _e67 = i_7;
                i_7 = (_e67 + 1u);
                uint _e69 = i_7;
                if ((_e69 >= ends_1.w)) {
                    break;
                }
            }
        }
    }
    PairHit _e72 = found_5;
    return _e72;
}

bool isPlane(uint i_8) {
    uint _e4 = frame.shapeEnds.z;
    uint _e9 = frame.shapeEnds.w;
    return pick((i_8 >= _e4), (i_8 < _e9), false);
}

vec3 boxNormal(vec3 origin_7, vec3 direction_6, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_7, direction_6, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_10 = pick(entering, _e5.near, _e5.far);
    vec3 side = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_6, vec3(0.0))));
    bool onX = (crossed.x == t_10);
    bool onY = pick(!(onX), (crossed.y == t_10), false);
    return (side * mix(vec3(0.0), vec3(1.0), bvec3(onX, onY, !(pick(onX, true, onY)))));
}

vec3 turnedBack(vec4 q_2, vec3 v_2) {
    vec3 _e6 = turned(vec4(-(q_2.xyz), q_2.w), v_2);
    return _e6;
}

bool isBox(uint i_9) {
    uint _e4 = frame.shapeEnds.x;
    uint _e9 = frame.shapeEnds.y;
    return pick((i_9 >= _e4), (i_9 < _e9), false);
}

bool isSphere(uint i_10) {
    uint _e4 = frame.shapeEnds.x;
    return (i_10 < _e4);
}

vec3 normalAt(RayPair p_7, float t_1, uint i_11) {
    vec3 normal_1 = vec3(0.0);
    Bounds _e3 = fetchBounds(i_11);
    vec3 origin_8 = (p_7.point - _e3.center);
    normal_1 = _e3.center;
    const bool _e10 = hasQuads;
    if (_e10) {
        Extent _e11 = fetchExtent(i_11);
        vec3 _e17 = normal_1;
        bool _e18 = isPlane(i_11);
        normal_1 = pick(_e18, _e17, cross(_e11.a.xyz, _e11.b.xyz));
    }
    const bool _e21 = hasBoxes;
    if (_e21) {
        Extent _e22 = fetchExtent(i_11);
        bool inside = pick((i_11 == p_7.shape), p_7.inwards, false);
        vec3 _e28 = turned(_e22.a, origin_8);
        vec3 _e31 = turned(_e22.a, p_7.direction);
        vec3 _e35 = boxNormal(_e28, _e31, _e22.b.xyz, p_7.tMin, inside);
        vec3 _e36 = normal_1;
        vec3 _e38 = turnedBack(_e22.a, _e35);
        bool _e39 = isBox(i_11);
        normal_1 = pick(_e39, _e38, _e36);
    }
    const bool _e42 = hasSpheres;
    if (_e42) {
        vec3 outwards = (origin_8 + (t_1 * p_7.direction));
        vec3 _e46 = normal_1;
        bool _e53 = isSphere(i_11);
        normal_1 = pick(_e53, pick((dot(outwards, outwards) == 0.0), -(p_7.direction), outwards), _e46);
    }
    vec3 _e55 = normal_1;
    return normalize(_e55);
}

Surface fetchSurface(uint i_12) {
    vec4 _e2 = tableTexel(9u, i_12);
    vec4 _e4 = tableTexel(10u, i_12);
    vec4 _e6 = tableTexel(11u, i_12);
    vec4 _e8 = tableTexel(12u, i_12);
    vec4 _e10 = tableTexel(13u, i_12);
    return Surface(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.xyz, _e10.w);
}

SurfacePoint surfaceAt(RayPair rays, PairHit hit, uint shape) {
    Surface surface = Surface(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    Normals normals = Normals(vec3(0.0), vec3(0.0));
    vec3 tangent = vec3(0.0);
    vec3 bitangent = vec3(0.0);
    vec3 _e4 = normalAt(rays, hit.t, shape);
    Surface _e5 = fetchSurface(shape);
    surface = _e5;
    normals = Normals(_e4, _e4);
    Surface _e13 = surface;
    vec3 _e15 = normals.geometric;
    vec3 _e17 = normals.shading;
    return SurfacePoint(_e13, _e15, _e17);
}

uint kindOf(uint code) {
    return (code & 3u);
}

bool isDielectric(uint code_1) {
    const bool _e2 = hasGlass;
    uint _e3 = kindOf(code_1);
    return pick(_e2, (_e3 == dielectric), false);
}

bool isMetallicRoughness(uint code_2) {
    const bool _e2 = hasMetallicRoughness;
    uint _e3 = kindOf(code_2);
    return pick(_e2, (_e3 == metallicRoughness), false);
}

bool isLayered(uint code_3) {
    bool _e2 = isMetallicRoughness(code_3);
    return pick(hasLayers, _e2, false);
}

bool letsThrough(uint code_4, float eta) {
    bool _e2 = isDielectric(code_4);
    bool _e4 = isLayered(code_4);
    return pick(_e2, true, pick(pick(hasTransmission, _e4, false), (eta < 0.0), false));
}

Basis basisAbout(vec3 n) {
    float side_1 = pick((n.z >= 0.0), 1.0, -1.0);
    float a_2 = (-1.0 / (side_1 + n.z));
    float b_6 = ((n.x * n.y) * a_2);
    return Basis(vec3((1.0 + (((side_1 * n.x) * n.x) * a_2)), (side_1 * b_6), (-(side_1) * n.x)), vec3(b_6, (side_1 + ((n.y * n.y) * a_2)), -(n.y)), n);
}

vec3 toLocal(Basis b, vec3 v_3) {
    return vec3(dot(v_3, b.tangent), dot(v_3, b.bitangent), dot(v_3, b.normal));
}

bool isThin(uint code_5) {
    const bool _e2 = hasGlass;
    return pick(_e2, ((code_5 & 7u) == 7u), false);
}

Emitter fetchEmitter(uint i_13) {
    vec4 _e2 = tableTexel(14u, i_13);
    vec4 _e4 = tableTexel(15u, i_13);
    vec4 _e6 = tableTexel(16u, i_13);
    vec4 _e8 = tableTexel(17u, i_13);
    vec4 _e10 = tableTexel(18u, i_13);
    vec4 _e12 = tableTexel(19u, i_13);
    return Emitter(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.x, _e10.y, _e10.z, _e10.w, _e12.x, _e12.y, _e12.z, _e12.w);
}

int emitterOf(float code_6) {
    return ((int(code_6) >> 7u) - 1);
}

Emitter emitterAt(uint i_14, Emitter only) {
    Emitter emitter = Emitter(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    emitter = only;
    const bool _e4 = hasManyLights;
    if (_e4) {
        Emitter _e5 = fetchEmitter(i_14);
        emitter = _e5;
    }
    Emitter _e6 = emitter;
    return _e6;
}

SphereView viewSphere(Emitter e, vec3 point) {
    vec3 toCenter_2 = (e.position - point);
    float d_1 = length(toCenter_2);
    float power = abs(((d_1 - e.radius) * (d_1 + e.radius)));
    bool inside_1 = (d_1 <= e.radius);
    float sine_1 = min((e.radius / max(d_1, 1e-30)), 1.0);
    float cosine_10 = (sqrt(power) / max(d_1, 1e-30));
    return SphereView(toCenter_2, d_1, power, inside_1, pick(inside_1, 2.0, ((sine_1 * sine_1) / (1.0 + cosine_10))));
}

float conePdf(float width) {
    return (1.0 / (6.2831855 * max(width, 1e-31)));
}

float spherePdf(Emitter e_1, vec3 point_1, vec3 direction_7) {
    SphereView _e3 = viewSphere(e_1, point_1);
    bool reached = pick(_e3.inside, true, (dot(direction_7, _e3.toCenter) > 0.0));
    float _e11 = conePdf(_e3.width);
    return pick(reached, _e11, 0.0);
}

float areaPdf(float area, float height, float distance_) {
    float pdf_1 = (((distance_ / max(height, 1e-30)) * distance_) / max((area / distance_), 1e-30));
    return min(pdf_1, 1e30);
}

float pdfOfView(QuadView q_3, float area_1, float distance_1) {
    float _e4 = areaPdf(area_1, q_3.height, distance_1);
    float pdf_2 = pick(q_3.bySolidAngle, (1.0 / max(q_3.solidAngle, 0.01)), _e4);
    return pick(q_3.lit, pdf_2, 0.0);
}

float arctangent(float x_11) {
    float a_3 = abs(x_11);
    bool steep = (a_3 > 2.4142137);
    bool middle_1 = pick((a_3 > 0.41421357), !(steep), false);
    float r = pick(steep, (-1.0 / max(a_3, 1.0)), pick(middle_1, ((a_3 - 1.0) / (a_3 + 1.0)), a_3));
    float base_1 = pick(steep, 1.5707964, pick(middle_1, 0.7853982, 0.0));
    float z_1 = (r * r);
    float series = ((((((0.080537446 * z_1) - 0.13877685) * z_1) + 0.19977711) * z_1) - 0.3333295);
    return (sign(x_11) * (base_1 + (((series * z_1) * r) + r)));
}

float stretch(float x_12, vec2 y_5, float h) {
    vec2 r_1 = sqrt(((vec2((x_12 * x_12)) + (y_5 * y_5)) + vec2((h * h))));
    float _e16 = arctangent(((x_12 * y_5.y) / (h * r_1.y)));
    float _e22 = arctangent(((x_12 * y_5.x) / (h * r_1.x)));
    return (_e16 - _e22);
}

QuadView viewQuad(Emitter e_2, vec3 point_2) {
    vec3 corner = (e_2.position - point_2);
    vec2 lengths = vec2(length(e_2.u), length(e_2.v));
    vec3 axisX = (e_2.u / vec3(lengths.x));
    vec3 axisY = (e_2.v / vec3(lengths.y));
    vec3 normal_8 = normalize(cross(axisX, axisY));
    float signedHeight = dot(corner, normal_8);
    float least = (1e-7 * (lengths.x + lengths.y));
    float height_1 = max(abs(signedHeight), least);
    bool lit = pick((abs(signedHeight) > least), pick((e_2.oneSided == 0.0), true, (signedHeight < 0.0)), false);
    vec2 low_1 = vec2(dot(corner, axisX), dot(corner, axisY));
    vec2 high_1 = (low_1 + lengths);
    vec2 y_10 = vec2(low_1.y, high_1.y);
    float _e44 = stretch(low_1.x, y_10, height_1);
    float _e46 = stretch(high_1.x, y_10, height_1);
    float solidAngle = (_e46 - _e44);
    bool rectangle = (abs(dot(axisX, axisY)) <= 1e-5);
    vec3 axisZ = (normal_8 * pick((signedHeight > 0.0), 1.0, -1.0));
    return QuadView(corner, axisX, axisY, axisZ, low_1, high_1, height_1, _e44, solidAngle, lit, pick(rectangle, (solidAngle > 0.01), false));
}

float quadPdf(Emitter e_3, vec3 point_3, float distance_2) {
    QuadView _e3 = viewQuad(e_3, point_3);
    float _e5 = pdfOfView(_e3, e_3.area, distance_2);
    return _e5;
}

BoxView viewBox(Emitter e_4, vec3 point_4) {
    Extent _e4 = fetchExtent(uint(e_4.shape));
    vec4 rotation = _e4.a;
    vec3 _e8 = rotate(rotation, (point_4 - e_4.position));
    bvec3 seen = greaterThan(abs(_e8), e_4.u);
    vec3 faces = mix(vec3(0.0), ((4.0 * e_4.u.yzx) * e_4.u.zxy), seen);
    return BoxView(rotation, _e8, faces, ((faces.x + faces.y) + faces.z), !(any(seen)));
}

float boxPdf(Emitter e_5, vec3 point_5, vec3 direction_8, float distance_3, vec3 normal_2) {
    BoxView _e5 = viewBox(e_5, point_5);
    float _e10 = areaPdf(_e5.area, (distance_3 * abs(dot(direction_8, normal_2))), distance_3);
    float _e12 = conePdf(2.0);
    return pick(_e5.inside, _e12, _e10);
}

float shapePdf(Emitter e_6, vec3 point_6, vec3 direction_9, float distance_4, vec3 normal_3, uint place) {
    float pdf = 0.0;
    const bool _e9 = hasSphereLights;
    if (_e9) {
        if ((e_6.kind == 0.0)) {
            float _e13 = spherePdf(e_6, point_6, direction_9);
            pdf = _e13;
        }
    }
    const bool _e15 = hasQuadLights;
    if (_e15) {
        if ((e_6.kind == 1.0)) {
            float _e19 = quadPdf(e_6, point_6, distance_4);
            pdf = _e19;
        }
    }
    const bool _e21 = hasBoxLights;
    if (_e21) {
        if ((e_6.kind == 2.0)) {
            float _e25 = boxPdf(e_6, point_6, direction_9, distance_4, normal_3);
            pdf = _e25;
        }
    }
    float _e26 = pdf;
    return _e26;
}

float spotFalloff(Emitter e_7, vec3 toLight) {
    float share = clamp(((-(dot(toLight, e_7.u)) - e_7.radius) / (e_7.cosInner - e_7.radius)), 0.0, 1.0);
    return (share * share);
}

float estimatedIrradiance(Emitter e_8, vec3 point_7, vec3 normal_4) {
    float estimate = 0.0;
    const bool _e4 = hasQuadLights;
    bool isQuad = pick(_e4, (e_8.kind == 1.0), false);
    const bool _e10 = hasSuns;
    bool isFar = pick(_e10, (e_8.kind == 5.0), false);
    vec3 middle_2 = (e_8.position + pick(isQuad, (0.5 * (e_8.u + e_8.v)), vec3(0.0)));
    vec3 toLight_2 = pick(isFar, -(e_8.u), (middle_2 - point_7));
    float distance2_ = dot(toLight_2, toLight_2);
    float distance_5 = sqrt(distance2_);
    float grown = max((distance_5 + e_8.reach), 1e-15);
    float above = clamp(((dot(normal_4, toLight_2) + e_8.reach) / grown), 0.0, 1.0);
    float cosine_11 = pick((dot(normal_4, normal_4) == 0.0), 1.0, above);
    float square = pick(isQuad, (distance2_ + (e_8.area / 3.1415927)), max(distance2_, (e_8.area / 12.566371)));
    estimate = ((e_8.power * cosine_11) / pick(isFar, 1.0, max(square, 1e-15)));
    const bool _e65 = hasQuadLights;
    if (_e65) {
        float height_2 = (-(dot(cross(e_8.u, e_8.v), toLight_2)) / max(e_8.area, 1e-30));
        float side_2 = pick((e_8.oneSided == 1.0), max(height_2, 0.0), abs(height_2));
        float lampCosine = pick((side_2 > 0.0), ((side_2 + e_8.reach) / grown), 0.0);
        float _e89 = estimate;
        estimate = (_e89 * pick(isQuad, lampCosine, 1.0));
    }
    const bool _e94 = hasPointLights;
    if (_e94) {
        float _e95 = estimate;
        float _e100 = spotFalloff(e_8, (toLight_2 / vec3(max(distance_5, 1e-15))));
        estimate = (_e95 * pick((e_8.kind == 4.0), _e100, 1.0));
    }
    const bool _e108 = hasSky;
    if (_e108) {
        float _e109 = estimate;
        estimate = pick((e_8.kind == 6.0), e_8.power, _e109);
    }
    float _e115 = estimate;
    return _e115;
}

float listedProbability(Emitter e_9, vec3 point_8, vec3 normal_5, Odds odds) {
    float probability = 0.0;
    uint _e6 = frame.emitterCount;
    probability = float(min(_e6, 1u));
    const bool _e12 = hasManyLights;
    if (_e12) {
        uint _e15 = frame.emitterCount;
        if ((_e15 > 1u)) {
            float _e18 = estimatedIrradiance(e_9, point_8, normal_5);
            probability = (_e18 / max(odds.total, 1e-37));
        }
    }
    float _e23 = probability;
    return _e23;
}

float misWeight(float own, float other) {
    float ratio_5 = (other / own);
    return (1.0 / (1.0 + (ratio_5 * ratio_5)));
}

vec3 metLight(Path p_8, PairHit hit_1, Surface s_6, vec3 outward, Emitter only_1) {
    vec3 found_6 = vec3(0.0);
    uint i_15 = 0u;
    float probability_1 = 0.0;
    vec3 direction_17 = p_8.rays.direction;
    bool hidden = pick(((uint(s_6.code) & 16u) != 0u), (dot(outward, direction_17) > 0.0), false);
    int _e18 = emitterOf(s_6.code);
    found_6 = pick(hidden, vec3(0.0), s_6.emission);
    uint _e28 = frame.emitterCount;
    if (pick((_e18 >= 0), (_e28 > 0u), false)) {
        i_15 = uint(max(_e18, 0));
        uint _e36 = i_15;
        Emitter _e37 = emitterAt(_e36, only_1);
        float _e43 = shapePdf(_e37, p_8.rays.point, direction_17, hit_1.t, outward, hit_1.triangle.triangle);
        float _e48 = listedProbability(_e37, p_8.rays.point, p_8.litSide, p_8.odds);
        probability_1 = _e48;
        vec3 _e50 = found_6;
        float _e52 = probability_1;
        float _e54 = misWeight(p_8.pdf, (_e43 * _e52));
        found_6 = (_e50 * pick((p_8.pdf <= 0.0), 1.0, _e54));
    }
    vec3 _e61 = found_6;
    return _e61;
}

uvec2 pascalW2_(uvec2 x_13) {
    uvec2 y_6 = uvec2(0u);
    uvec2 _e7 = timesW2_(((x_13 >> uvec2(2u)) & uvec2(13107u)));
    y_6 = (x_13 ^ _e7);
    uvec2 _e10 = y_6;
    uvec2 _e11 = y_6;
    uvec2 _e18 = timesW(((_e11 >> uvec2(4u)) & uvec2(3855u)));
    y_6 = (_e10 ^ _e18);
    uvec2 _e20 = y_6;
    uvec2 _e21 = y_6;
    uvec2 _e28 = timesW2_(((_e21 >> uvec2(8u)) & uvec2(255u)));
    return (_e20 ^ _e28);
}

vec2 thirdOf(Groups g_2) {
    uvec2 _e3 = timesW2_(g_2.shift);
    uvec2 _e5 = pascalW2_((g_2.index ^ _e3));
    uvec2 _e11 = scramble(_e5, (g_2.seedA ^ (g_2.seedB * 2654435761u)));
    vec2 _e12 = toUnit(_e11);
    return _e12;
}

TwoPoints nextTwo3d(inout Sampler s_7) {
    Sampler _e1 = s_7;
    Groups _e2 = nextGroups(_e1);
    uint _e5 = s_7.key;
    s_7.key = (_e5 + 2u);
    vec2 _e8 = firstOf(_e2);
    vec2 _e9 = secondOf(_e2);
    vec2 _e10 = thirdOf(_e2);
    return TwoPoints(vec3(_e8.x, _e9.x, _e10.x), vec3(_e8.y, _e9.y, _e10.y));
}

EmitterChoice chooseEmitter(vec3 point_9, vec3 normal_6, float u_4) {
    bool hasTree = false;
    EmitterChoice choice = EmitterChoice(0u, 0.0, Odds(0.0, 0.0));
    float total = 0.0;
    uint chosen = 0u;
    float chosenWeight = 0.0;
    float rest = 0.0;
    uint i_16 = 0u;
    uint _e7 = frame.emitterCount;
    uint _e10 = frame.farEmitters;
    bool _e11 = hasTree;
    uint listed = pick(_e11, _e10, _e7);
    uint _e16 = frame.emitterCount;
    choice = EmitterChoice(0u, float(min(_e16, 1u)), Odds(1.0, 0.0));
    const bool _e26 = hasManyLights;
    if (_e26) {
        uint _e29 = frame.emitterCount;
        if ((_e29 > 1u)) {
            rest = u_4;
            while(true) {
                uint _e41 = i_16;
                Emitter _e42 = fetchEmitter(_e41);
                float _e43 = estimatedIrradiance(_e42, point_9, normal_6);
                uint _e44 = i_16;
                float weight_1 = pick((_e44 < listed), _e43, 0.0);
                float _e48 = total;
                total = (_e48 + weight_1);
                float _e50 = total;
                float share_1 = (weight_1 / max(_e50, 1e-37));
                float _e54 = rest;
                bool take = (_e54 < share_1);
                uint _e56 = chosen;
                uint _e57 = i_16;
                chosen = pick(take, _e57, _e56);
                float _e59 = chosenWeight;
                chosenWeight = pick(take, weight_1, _e59);
                float _e61 = rest;
                float _e68 = rest;
                rest = pick(take, (_e68 / max(share_1, 1e-37)), ((_e61 - share_1) / max((1.0 - share_1), 1e-7)));
                uint _e74 = i_16;
                i_16 = (_e74 + 1u);
                uint _e76 = i_16;
                if ((_e76 >= listed)) {
                    break;
                }
            }
            uint _e78 = chosen;
            float _e79 = chosenWeight;
            float _e80 = total;
            float _e84 = total;
            choice = EmitterChoice(_e78, (_e79 / max(_e80, 1e-37)), Odds(_e84, 0.0));
        }
    }
    EmitterChoice _e88 = choice;
    return _e88;
}

vec3 turnTo(vec3 axis, vec3 v_4) {
    float s_20 = pick((axis.z >= 0.0), 1.0, -1.0);
    float a_4 = (-1.0 / (s_20 + axis.z));
    float b_7 = ((axis.x * axis.y) * a_4);
    vec3 x_18 = vec3((1.0 + (((s_20 * axis.x) * axis.x) * a_4)), (s_20 * b_7), (-(s_20) * axis.x));
    vec3 y_11 = vec3(b_7, (s_20 + ((axis.y * axis.y) * a_4)), -(axis.y));
    return (((v_4.x * x_18) + (v_4.y * y_11)) + (v_4.z * axis));
}

ConeDirection sampleCone(vec3 axis_1, float width_1, vec2 u_5) {
    float oneMinusCosine = (u_5.x * width_1);
    float cosine_12 = (1.0 - oneMinusCosine);
    float sine2_ = (oneMinusCosine * (2.0 - oneMinusCosine));
    float sine_2 = sqrt(max(sine2_, 0.0));
    float phi = (6.2831855 * u_5.y);
    vec2 turn = vec2(cos(phi), sin(phi));
    vec3 _e23 = turnTo(axis_1, vec3(((sine_2 / length(turn)) * turn), cosine_12));
    return ConeDirection(_e23, cosine_12, sine2_);
}

LightSample sampleSphere(Emitter e_10, vec3 point_10, vec2 u_6) {
    SphereView _e3 = viewSphere(e_10, point_10);
    vec3 axis_2 = pick((_e3.distance_ < 1e-30), vec3(0.0, 0.0, 1.0), (_e3.toCenter / vec3(max(_e3.distance_, 1e-30))));
    ConeDirection _e19 = sampleCone(axis_2, _e3.width, u_6);
    float along_1 = (_e3.distance_ * _e19.cosine);
    float halfChord = sqrt(max(((e_10.radius * e_10.radius) - ((_e3.distance_ * _e3.distance_) * _e19.sine2_)), 0.0));
    float larger = (abs(along_1) + halfChord);
    bool takeLarger = pick(_e3.inside, (along_1 > 0.0), false);
    float distance_6 = pick(takeLarger, larger, (_e3.power / max(larger, 1e-30)));
    float _e49 = conePdf(_e3.width);
    return LightSample(_e19.direction, distance_6, e_10.radiance, _e49, false);
}

vec2 cosineAndSine(float x_14) {
    float h_4 = (0.5 * x_14);
    float z_2 = (h_4 * h_4);
    float sine_3 = (((((((-0.00019515296 * z_2) + 0.008332161) * z_2) - 0.16666655) * z_2) * h_4) + h_4);
    return vec2((1.0 - ((2.0 * sine_3) * sine_3)), ((2.0 * sine_3) * sqrt((1.0 - (sine_3 * sine_3)))));
}

vec3 sphericalRectangle(QuadView q_4, vec2 u_7) {
    float h_5 = q_4.height;
    vec2 y_12 = vec2(q_4.low.y, q_4.high.y);
    vec2 s_21 = (y_12 / sqrt(((y_12 * y_12) + vec2((h_5 * h_5)))));
    vec2 _e21 = cosineAndSine((0.5 * (q_4.start + (u_7.x * q_4.solidAngle))));
    vec2 across_3 = (vec2((s_21.y - s_21.x), (s_21.y + s_21.x)) * _e21);
    float w_3 = (((2.0 * _e21.x) * _e21.y) / max(length(across_3), 1e-15));
    float x_19 = clamp(((h_5 * w_3) * inversesqrt(max((1.0 - (w_3 * w_3)), 1e-12))), q_4.low.x, q_4.high.x);
    float d2_ = ((x_19 * x_19) + (h_5 * h_5));
    vec2 ends_2 = (y_12 * inversesqrt((vec2(d2_) + (y_12 * y_12))));
    float v_8 = mix(ends_2.x, ends_2.y, u_7.y);
    float atY = clamp(((v_8 * sqrt(d2_)) * inversesqrt(max((1.0 - (v_8 * v_8)), 1e-12))), y_12.x, y_12.y);
    return (((x_19 * q_4.axisX) + (atY * q_4.axisY)) + (h_5 * q_4.axisZ));
}

LightSample sampleQuad(Emitter e_11, vec3 point_11, vec2 u_8) {
    QuadView _e3 = viewQuad(e_11, point_11);
    vec3 onArea = ((_e3.corner + (u_8.x * e_11.u)) + (u_8.y * e_11.v));
    vec3 _e13 = sphericalRectangle(_e3, u_8);
    vec3 toLight_3 = pick(_e3.bySolidAngle, _e13, onArea);
    float distance_7 = max(length(toLight_3), _e3.height);
    float _e23 = pdfOfView(_e3, e_11.area, distance_7);
    return LightSample((toLight_3 / vec3(distance_7)), distance_7, e_11.radiance, _e23, false);
}

vec4 pointOnFaces(Emitter e_12, BoxView b_1, vec2 u_9) {
    float both = (b_1.faces.x + b_1.faces.y);
    float at_1 = (u_9.x * b_1.area);
    bool onX_1 = (at_1 < b_1.faces.x);
    bool onY_1 = pick(!(onX_1), (at_1 < both), false);
    float face = pick(onX_1, b_1.faces.x, pick(onY_1, b_1.faces.y, b_1.faces.z));
    float within_1 = clamp(((at_1 - pick(onX_1, 0.0, pick(onY_1, b_1.faces.x, both))) / max(face, 1e-30)), 0.0, 1.0);
    vec3 axis_3 = vec3(pick(onX_1, 1.0, 0.0), pick(onY_1, 1.0, 0.0), pick(pick(onX_1, true, onY_1), 0.0, 1.0));
    vec3 p_16 = vec3(pick((dot(axis_3, b_1.point) >= 0.0), 1.0, -1.0), ((2.0 * within_1) - 1.0), ((2.0 * u_9.y) - 1.0));
    vec3 toLight_4 = ((pick(onX_1, p_16.xyz, pick(onY_1, p_16.zxy, p_16.yzx)) * e_12.u) - b_1.point);
    return vec4(toLight_4, abs(dot(axis_3, toLight_4)));
}

vec3 rotateBack(vec4 q_5, vec3 v_5) {
    vec3 _e6 = rotate(vec4(-(q_5.xyz), q_5.w), v_5);
    return _e6;
}

LightSample sampleBox(Emitter e_13, vec3 point_12, vec2 u_10) {
    BoxView _e3 = viewBox(e_13, point_12);
    vec4 _e4 = pointOnFaces(e_13, _e3, u_10);
    ConeDirection _e10 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_10);
    vec3 outwards_1 = _e10.direction;
    Slabs _e16 = boxSlabs(_e3.point, outwards_1, e_13.u);
    float distance_8 = pick(_e3.inside, max(_e16.far, 0.0), length(_e4.xyz));
    vec3 direction_18 = pick(_e3.inside, outwards_1, (_e4.xyz / vec3(max(distance_8, 1e-30))));
    float _e31 = areaPdf(_e3.area, _e4.w, distance_8);
    float _e33 = conePdf(2.0);
    float pdf_3 = pick(_e3.inside, _e33, _e31);
    vec3 _e37 = rotateBack(_e3.rotation, direction_18);
    return LightSample(_e37, distance_8, e_13.radiance, pdf_3, false);
}

LightSample samplePoint(Emitter e_14, vec3 point_13) {
    vec3 toLight_5 = (e_14.position - point_13);
    float distance_9 = length(toLight_5);
    float safe = max(distance_9, 1e-15);
    return LightSample((toLight_5 / vec3(safe)), distance_9, (e_14.radiance / vec3((safe * safe))), pick((distance_9 > 1e-15), 1.0, 0.0), true);
}

LightSample sampleSpot(Emitter e_15, vec3 point_14) {
    LightSample s_8 = LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, false);
    LightSample _e2 = samplePoint(e_15, point_14);
    s_8 = _e2;
    vec3 _e5 = s_8.direction;
    float _e6 = spotFalloff(e_15, _e5);
    vec3 _e8 = s_8.radiance;
    s_8.radiance = (_e8 * _e6);
    float _e12 = s_8.pdf;
    s_8.pdf = pick((_e6 > 0.0), _e12, 0.0);
    LightSample _e17 = s_8;
    return _e17;
}

LightSample sampleDirectional(Emitter e_16, vec2 u_11) {
    bool delta = (e_16.area == 0.0);
    ConeDirection _e10 = sampleCone(-(e_16.u), (e_16.area / 6.2831855), u_11);
    return LightSample(_e10.direction, 1e30, e_16.radiance, pick(delta, 1.0, (1.0 / max(e_16.area, 1e-31))), delta);
}

vec4 environmentTexel(uint column_1, uint row_1) {
    vec4 _e5 = texelFetch(environment, ivec2(uvec2(column_1, row_1)), 0);
    return _e5;
}

vec4 fetchEntries(Table t_2, uint pair) {
    float _e5 = frame.environmentSize.x;
    uint width_2 = uint(_e5);
    uint i_19 = (t_2.first + pair);
    uint row_2 = (i_19 / width_2);
    vec4 _e12 = environmentTexel((i_19 - (row_2 * width_2)), row_2);
    return _e12;
}

vec2 sharesBeyond(vec4 pair_1, uint digits, uint fine) {
    uvec2 further = (uvec2(pair_1.yw) & uvec2(4095u));
    return ((pair_1.xz - vec2(float(digits))) + ((vec2(further) - vec2(float(fine))) * 0.00024414063));
}

Choice chooseEntry(Table t_3, uint digits_1, uint fine_1) {
    uint low = 0u;
    uint high = 0u;
    vec2 ends = vec2(1.0);
    uint step_ = 0u;
    uint pairs = ((t_3.entries + 1u) / 2u);
    uint part = ((((digits_1 >> 12u) * t_3.entries) + (((digits_1 & 4095u) * t_3.entries) >> 12u)) >> 12u);
    vec4 _e23 = fetchEntries(t_3, (part / 2u));
    low = (uint(pick(((part & 1u) == 1u), _e23.w, _e23.y)) >> 12u);
    high = pairs;
    while(true) {
        uint _e41 = low;
        uint _e42 = step_;
        uint _e47 = low;
        uint _e48 = high;
        uint _e52 = high;
        uint next = pick((_e52 < pairs), ((_e47 + _e48) / 2u), min((_e41 + _e42), (pairs - 1u)));
        vec4 _e55 = fetchEntries(t_3, next);
        vec2 _e56 = sharesBeyond(_e55, digits_1, fine_1);
        bool found_8 = (_e56.y > 0.0);
        vec2 _e60 = ends;
        ends = pick(found_8, _e56, _e60);
        uint _e62 = high;
        high = pick(found_8, next, _e62);
        uint _e66 = low;
        low = pick(found_8, _e66, (next + 1u));
        uint _e69 = step_;
        step_ = ((2u * _e69) + 1u);
        uint _e73 = low;
        uint _e74 = high;
        if ((_e73 >= _e74)) {
            break;
        }
    }
    uint _e76 = high;
    uint pair_3 = min(_e76, (pairs - 1u));
    vec4 _e84 = fetchEntries(t_3, (max(pair_3, 1u) - 1u));
    vec2 _e85 = sharesBeyond(_e84, digits_1, fine_1);
    float before = _e85.y;
    float none = -((float(digits_1) + (float(fine_1) * 0.00024414063)));
    float _e94 = ends.x;
    bool isFirst = (_e94 > 0.0);
    float _e98 = ends.x;
    float start = pick(isFirst, pick((pair_3 == 0u), none, before), _e98);
    float _e104 = ends.y;
    float _e106 = ends.x;
    float end = pick(isFirst, _e106, _e104);
    return Choice(min(((2u * pair_3) + pick(isFirst, 0u, 1u)), (t_3.entries - 1u)), clamp((-(start) / max((end - start), 1e-37)), 0.0, 1.0));
}

ChosenCell chooseCell(vec2 u_12) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size = uvec2(_e3);
    uvec2 digits_4 = uvec2((u_12 * 16777216.0));
    uint _e13 = mixBits((digits_4.x ^ (digits_4.y * 2654435761u)));
    uint columns = ((size.x + 1u) / 2u);
    uint tables = (size.x * size.y);
    Choice _e29 = chooseEntry(Table(tables, (size.y + 1u)), digits_4.y, (_e13 & 4095u));
    Choice _e44 = chooseEntry(Table(((tables + ((size.y + 2u) / 2u)) + (_e29.entry * columns)), size.x), digits_4.x, (_e13 >> 20u));
    return ChosenCell(uvec2(_e44.entry, _e29.entry), vec2(_e44.rest, _e29.rest));
}

Corners environmentCorners(uvec2 cell) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_1 = uvec2(_e3);
    uint left = (pick((cell.x == 0u), size_1.x, cell.x) - 1u);
    uint right = pick((cell.x == size_1.x), 0u, cell.x);
    uint upper = (max(cell.y, 1u) - 1u);
    uint lower = min(cell.y, (size_1.y - 1u));
    vec4 above_1 = vec4(1.0, 1.0, 1.0, pick((cell.y == 0u), -1.0, 1.0));
    vec4 below = vec4(1.0, 1.0, 1.0, pick((cell.y == size_1.y), -1.0, 1.0));
    vec4 _e49 = environmentTexel(left, upper);
    vec4 _e51 = environmentTexel(right, upper);
    vec4 _e53 = environmentTexel(left, lower);
    vec4 _e55 = environmentTexel(right, lower);
    return Corners((above_1 * _e49), (above_1 * _e51), (below * _e53), (below * _e55));
}

float linearSample(float u_13, float a, float b_2) {
    vec2 ends_3 = (vec2(a, b_2) / vec2(max((a + b_2), 1e-37)));
    return min((u_13 / max((ends_3.x + sqrt(mix((ends_3.x * ends_3.x), (ends_3.y * ends_3.y), u_13))), 1e-9)), 1.0);
}

EnvironmentLight lightWithin(Corners k, vec2 at, float sine) {
    vec4 light_1 = mix(mix(k.a, k.b, at.x), mix(k.c, k.d, at.x), at.y);
    return EnvironmentLight(light_1.xyz, (max(light_1.w, 0.0) / sine));
}

EnvironmentSample sampleEnvironment(vec2 u_14) {
    vec2 size_2 = frame.environmentSize;
    ChosenCell _e4 = chooseCell(u_14);
    Corners _e6 = environmentCorners(_e4.cell);
    vec2 cell_1 = vec2(_e4.cell);
    bvec2 atPole = bvec2((cell_1.y == 0.0), (cell_1.y == size_2.y));
    float _e32 = linearSample(_e4.rest.y, max((_e6.a.w + _e6.b.w), 0.0), max((_e6.c.w + _e6.d.w), 0.0));
    float t_11 = ((_e32 * pick(any(atPole), 0.5, 1.0)) + pick(atPole.x, 0.5, 0.0));
    float _e55 = linearSample(_e4.rest.x, mix(_e6.a.w, _e6.c.w, t_11), mix(_e6.b.w, _e6.d.w, t_11));
    bool isLower = ((2.0 * cell_1.y) > size_2.y);
    float fromPole = pick(isLower, ((size_2.y - cell_1.y) + (0.5 - t_11)), (cell_1.y + (t_11 - 0.5)));
    vec2 _e76 = cosineAndSine((fromPole * (3.1415927 / size_2.y)));
    float _e85 = frame.environmentTurn;
    float halfTurns = (2.0 * (((cell_1.x + (_e55 - 0.5)) / size_2.x) - _e85));
    float nearest = floor((halfTurns + 0.5));
    bool back = (fract((0.5 * nearest)) > 0.0);
    vec2 _e100 = cosineAndSine(((halfTurns - nearest) * 3.1415927));
    vec2 phi_1 = (_e100 * pick(back, -1.0, 1.0));
    float sine_4 = max(_e76.y, 1e-9);
    vec3 direction_19 = vec3((sine_4 * phi_1.y), pick(isLower, -(_e76.x), _e76.x), (-(sine_4) * phi_1.x));
    EnvironmentLight _e119 = lightWithin(_e6, vec2(_e55, t_11), sine_4);
    return EnvironmentSample(direction_19, _e119);
}

vec3 sky(vec3 direction_10) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_10.y, 0.0));
}

LightSample sampleSky(vec2 u_15) {
    EnvironmentSample s_9 = EnvironmentSample(vec3(0.0), EnvironmentLight(vec3(0.0), 0.0));
    ConeDirection _e6 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_15);
    s_9 = EnvironmentSample(_e6.direction, white);
    const bool _e12 = hasEnvironment;
    if (_e12) {
        EnvironmentSample _e13 = sampleEnvironment(u_15);
        s_9 = _e13;
    }
    vec3 _e15 = s_9.direction;
    vec3 _e18 = s_9.light.radiance;
    vec3 _e20 = s_9.direction;
    vec3 _e21 = sky(_e20);
    float _e25 = s_9.light.pdf;
    return LightSample(_e15, 1e30, (_e18 * _e21), _e25, false);
}

LightSample sampleEmitter(Emitter e_17, vec3 point_15, vec2 u_16) {
    LightSample s_10 = LightSample(vec3(0.0, 1.0, 0.0), 1e30, vec3(0.0), 0.0, true);
    const bool _e15 = hasSphereLights;
    if (_e15) {
        if ((e_17.kind == 0.0)) {
            LightSample _e19 = sampleSphere(e_17, point_15, u_16);
            s_10 = _e19;
        }
    }
    const bool _e21 = hasQuadLights;
    if (_e21) {
        if ((e_17.kind == 1.0)) {
            LightSample _e25 = sampleQuad(e_17, point_15, u_16);
            s_10 = _e25;
        }
    }
    const bool _e27 = hasBoxLights;
    if (_e27) {
        if ((e_17.kind == 2.0)) {
            LightSample _e31 = sampleBox(e_17, point_15, u_16);
            s_10 = _e31;
        }
    }
    const bool _e33 = hasPointLights;
    if (_e33) {
        if ((e_17.kind == 3.0)) {
            LightSample _e37 = samplePoint(e_17, point_15);
            s_10 = _e37;
        }
    }
    const bool _e39 = hasPointLights;
    if (_e39) {
        if ((e_17.kind == 4.0)) {
            LightSample _e43 = sampleSpot(e_17, point_15);
            s_10 = _e43;
        }
    }
    const bool _e45 = hasSuns;
    if (_e45) {
        if ((e_17.kind == 5.0)) {
            LightSample _e49 = sampleDirectional(e_17, u_16);
            s_10 = _e49;
        }
    }
    const bool _e51 = hasSky;
    if (_e51) {
        if ((e_17.kind == 6.0)) {
            LightSample _e55 = sampleSky(u_16);
            s_10 = _e55;
        }
    }
    float _e58 = s_10.pdf;
    float _e60 = s_10.distance_;
    s_10.pdf = pick((_e60 <= (1e-5 * length(point_15))), 0.0, _e58);
    LightSample _e67 = s_10;
    return _e67;
}

bool isConductor(uint code_7) {
    const bool _e2 = hasConductors;
    uint _e3 = kindOf(code_7);
    return pick(_e2, (_e3 == conductor), false);
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

float indexRatio(float eta_1, float z, bool thin) {
    return pick(pick((z < 0.0), !(thin), false), (1.0 / eta_1), eta_1);
}

float reflectionBound(vec3 wo, float alpha) {
    float s_22 = (1.0 + length(wo.xy));
    float s2_ = (s_22 * s_22);
    float a2_ = (alpha * alpha);
    return (((1.0 - a2_) * s2_) / (s2_ + ((a2_ * wo.z) * wo.z)));
}

float stretched(vec3 w_1, float alpha_1) {
    return sqrt(((w_1.z * w_1.z) + ((alpha_1 * alpha_1) * dot(w_1.xy, w_1.xy))));
}

Outgoing outgoing(Surface s_11, vec3 wo_1, vec3 hero) {
    Outgoing o = Outgoing(vec3(0.0), 0.0, 0.0, 0.0, 0.0);
    uint code_10 = uint(s_11.code);
    bool _e5 = isConductor(code_10);
    bool _e6 = isDielectric(code_10);
    o = Outgoing(wo_1, pick(pick(_e5, true, _e6), 1.0, 0.0), 1.0, 1.0, 1.0);
    const bool _e17 = hasMetallicRoughness;
    if (_e17) {
        if (true) {
            float _e21 = o.share;
            float _e25 = specularShare(s_11.baseColor, s_11.metallic, wo_1.z);
            bool _e26 = isMetallicRoughness(code_10);
            o.share = pick(_e26, _e25, _e21);
        }
    }
    const bool _e29 = hasGlass;
    if (_e29) {
        bool _e34 = isThin(code_10);
        float _e35 = indexRatio(s_11.eta.x, wo_1.z, _e34);
        bool _e36 = isDielectric(code_10);
        o.ratio = pick(_e36, _e35, 1.0);
    }
    const bool _e40 = hasConductors;
    const bool _e42 = hasMetallicRoughness;
    const bool _e47 = hasGlass;
    if (pick(pick(_e40, true, pick(_e42, true, false)), true, _e47)) {
        float _e51 = reflectionBound(wo_1, s_11.alpha);
        bool _e52 = isDielectric(code_10);
        o.bound = pick(_e52, 1.0, _e51);
        float _e57 = stretched(wo_1, s_11.alpha);
        o.stretched = _e57;
    }
    Outgoing _e58 = o;
    return _e58;
}

float mirrorShare(float reflectivity) {
    const bool _e2 = hasMirrorLayers;
    return pick(_e2, reflectivity, 0.0);
}

vec3 sampleCosine(vec2 u_17) {
    float radius_2 = sqrt(u_17.x);
    float phi_2 = ((6.2831855 * u_17.y) - 3.1415927);
    return normalize(vec3((radius_2 * cos(phi_2)), (radius_2 * sin(phi_2)), sqrt((1.0 - u_17.x))));
}

bool isSmooth(uint code_8) {
    return ((code_8 & 32u) != 0u);
}

vec3 sampleVisibleNormal(vec3 wo_2, float alpha_2, float bound, vec2 u_18) {
    float _e8 = stretched(wo_2, alpha_2);
    vec3 w_4 = (vec3((alpha_2 * wo_2.xy), wo_2.z) / vec3(_e8));
    float phi_3 = ((6.2831855 * u_18.x) - 3.1415927);
    float drop = (u_18.y * (1.0 + (bound * w_4.z)));
    float sine_5 = sqrt(max((drop * (2.0 - drop)), 0.0));
    vec3 h_6 = (w_4 + vec3((sine_5 * cos(phi_3)), (sine_5 * sin(phi_3)), (1.0 - drop)));
    return normalize(vec3((alpha_2 * h_6.xy), max(h_6.z, 1e-7)));
}

vec3 sampleFacet(float alpha_3, bool isMirror, Outgoing o_1, vec2 u_19) {
    float side_3 = pick((o_1.wo.z < 0.0), -1.0, 1.0);
    vec3 _e16 = sampleVisibleNormal((o_1.wo * side_3), max(alpha_3, 0.001), o_1.bound, u_19);
    return (pick(isMirror, vec3(0.0, 0.0, 1.0), _e16) * side_3);
}

vec3 conductorFresnel(float cosine_3, vec3 eta_2, vec3 k_1) {
    float cosine2_ = (cosine_3 * cosine_3);
    float sine2_1 = (1.0 - cosine2_);
    vec3 difference = (((eta_2 * eta_2) - (k_1 * k_1)) - vec3(sine2_1));
    vec3 a2PlusB2_ = sqrt(((difference * difference) + ((((4.0 * eta_2) * eta_2) * k_1) * k_1)));
    vec3 larger_1 = sqrt(((0.5 * (a2PlusB2_ + abs(difference))) + vec3(1e-20)));
    vec3 smaller = ((eta_2 * k_1) / larger_1);
    vec3 a_5 = mix(smaller, larger_1, greaterThan(difference, vec3(0.0)));
    vec3 b_8 = mix(larger_1, smaller, greaterThan(difference, vec3(0.0)));
    vec3 b2_ = ((b_8 * b_8) + vec3(1e-20));
    vec3 acrossFar = (a_5 + vec3(cosine_3));
    vec3 acrossNear = (a_5 - vec3(cosine_3));
    vec3 across_4 = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a_5 * cosine_3) + vec3(sine2_1));
    vec3 alongNear = ((a_5 * cosine_3) - vec3(sine2_1));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across_4) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor_3, vec3 eta_3, vec3 k_2, float cosine_4) {
    float constants = dot((eta_3 + k_2), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_4, eta_3, k_2);
    return pick((constants > 0.0), _e8, baseColor_3);
}

float dielectricFresnel(float cosine_5, float ratio) {
    float inside2_ = (((ratio - 1.0) * (ratio + 1.0)) + (cosine_5 * cosine_5));
    float inside_2 = sqrt(max(inside2_, 0.0));
    float across_5 = ((cosine_5 - inside_2) / (cosine_5 + inside_2));
    float along_2 = ((((ratio * ratio) * cosine_5) - inside_2) / (((ratio * ratio) * cosine_5) + inside_2));
    return pick((inside2_ > 0.0), (0.5 * ((across_5 * across_5) + (along_2 * along_2))), 1.0);
}

float glassReflectance(float cosine_6, float ratio_1, bool thin_1) {
    float _e3 = dielectricFresnel(cosine_6, ratio_1);
    return pick(thin_1, ((2.0 * _e3) / (1.0 + _e3)), _e3);
}

vec3 facetReflectance(Surface s_12, float cosine_7, float ratio_2) {
    vec3 reflectance = vec3(0.0);
    uint code_11 = uint(s_12.code);
    const bool _e9 = hasMetallicRoughness;
    if (_e9) {
        if (true) {
            vec3 _e13 = metallicRoughnessF0_(s_12.baseColor, s_12.metallic);
            vec3 _e14 = schlick(_e13, cosine_7);
            reflectance = _e14;
        }
    }
    const bool _e16 = hasConductors;
    if (_e16) {
        vec3 _e17 = reflectance;
        vec3 _e21 = conductorReflectance(s_12.baseColor, s_12.eta, s_12.k, cosine_7);
        bool _e22 = isConductor(code_11);
        reflectance = pick(_e22, _e21, _e17);
    }
    const bool _e25 = hasGlass;
    if (_e25) {
        vec3 _e26 = reflectance;
        bool _e27 = isThin(code_11);
        float _e28 = glassReflectance(cosine_7, ratio_2, _e27);
        bool _e30 = isDielectric(code_11);
        reflectance = pick(_e30, vec3(_e28), _e26);
    }
    vec3 _e32 = reflectance;
    return _e32;
}

vec3 refracted(vec3 wo_3, vec3 h_1, float ratio_3) {
    float cosine_13 = dot(wo_3, h_1);
    float inside_3 = sqrt(max((((ratio_3 - 1.0) * (ratio_3 + 1.0)) + (cosine_13 * cosine_13)), 0.0));
    return ((((cosine_13 - inside_3) * h_1) - wo_3) / vec3(ratio_3));
}

vec3 mirrored(vec3 wo_4) {
    return vec3(-(wo_4.xy), wo_4.z);
}

BsdfSample sampleLobe(Surface s_13, Outgoing o_2, vec3 u_20) {
    BsdfSample drawn = BsdfSample(vec3(0.0), 0.0, vec3(0.0), false);
    vec3 wi = vec3(0.0);
    float probability_2 = 0.0;
    vec3 weight = vec3(0.0);
    vec3 wo_5 = o_2.wo;
    float _e5 = mirrorShare(s_13.reflectivity);
    float base_2 = (1.0 - _e5);
    float choice_1 = ((u_20.z - _e5) / base_2);
    vec3 _e12 = sampleCosine(u_20.xy);
    drawn = BsdfSample(_e12, 1.0, vec3(1.0), false);
    const bool _e20 = hasConductors;
    const bool _e22 = hasMetallicRoughness;
    const bool _e27 = hasGlass;
    if (pick(pick(_e20, true, pick(_e22, true, false)), true, _e27)) {
        uint code_12 = uint(s_13.code);
        bool _e31 = isDielectric(code_12);
        bool _e32 = isSmooth(code_12);
        vec3 _e35 = sampleFacet(s_13.alpha, _e32, o_2, u_20.xy);
        float oh = max(dot(wo_5, _e35), 0.0);
        vec3 _e40 = facetReflectance(s_13, oh, o_2.ratio);
        bool crossing = pick(_e31, (choice_1 >= _e40.x), false);
        wi = (((2.0 * oh) * _e35) - wo_5);
        probability_2 = (base_2 * o_2.share);
        weight = (_e40 / vec3(o_2.share));
        const bool _e57 = hasGlass;
        if (_e57) {
            bool _e58 = isThin(code_12);
            vec3 _e59 = wi;
            vec3 _e61 = refracted(wo_5, _e35, o_2.ratio);
            wi = pick(crossing, pick(_e58, -(wo_5), _e61), _e59);
            float _e65 = probability_2;
            probability_2 = pick(_e31, (base_2 * pick(crossing, (1.0 - _e40.x), _e40.x)), _e65);
            vec3 _e73 = weight;
            weight = pick(_e31, vec3(pick(pick(crossing, !(_e58), false), (1.0 / (o_2.ratio * o_2.ratio)), 1.0)), _e73);
        }
        float _e90 = wi.z;
        bool lost = pick(!(_e32), (crossing != ((wo_5.z < 0.0) != (_e90 < 0.0))), false);
        bool specular_1 = (choice_1 < o_2.share);
        vec3 _e100 = drawn.direction;
        vec3 _e101 = wi;
        drawn.direction = pick(specular_1, _e101, _e100);
        float _e105 = drawn.pdf;
        float _e106 = probability_2;
        drawn.pdf = pick(specular_1, pick(lost, 0.0, _e106), _e105);
        vec3 _e112 = drawn.weight;
        vec3 _e113 = weight;
        drawn.weight = pick(specular_1, _e113, _e112);
        drawn.delta = pick(specular_1, _e32, false);
    }
    const bool _e118 = hasMirrorLayers;
    if (_e118) {
        bool reflected = (u_20.z < _e5);
        vec3 _e123 = drawn.direction;
        vec3 _e124 = mirrored(wo_5);
        drawn.direction = pick(reflected, _e124, _e123);
        float _e128 = drawn.pdf;
        drawn.pdf = pick(reflected, _e5, _e128);
        vec3 _e132 = drawn.weight;
        drawn.weight = pick(reflected, vec3(1.0), _e132);
        bool _e138 = drawn.delta;
        drawn.delta = pick(_e138, true, reflected);
    }
    BsdfSample _e140 = drawn;
    return _e140;
}

float facetDensity(vec3 h_2, float alpha_4) {
    float slope = max(((dot(h_2.xy, h_2.xy) / (alpha_4 * alpha_4)) + (h_2.z * h_2.z)), 1.0);
    return (0.31830987 / (((alpha_4 * alpha_4) * slope) * slope));
}

bool hidesApart(uint code_9) {
    return ((code_9 & 64u) != 0u);
}

float singleScatteringAlbedo(float cosine_8, float alpha_5) {
    float x_20 = (cosine_8 / (cosine_8 + alpha_5));
    vec4 byAlpha = (vec4(0.887807, 0.309386, -0.270728, 0.0252433) + (x_20 * (vec4(1.08526, -3.21434, -1.87718, 1.61195) + (x_20 * (vec4(-5.18071, 10.7648, 6.30913, -8.09265) + (x_20 * (vec4(7.80474, -12.743, -24.1046, 25.2536) + (x_20 * vec4(-3.60041, 4.60906, 23.1225, -22.9342)))))))));
    float a2_1 = (alpha_5 * alpha_5);
    return min(dot(byAlpha, vec4(1.0, alpha_5, a2_1, (a2_1 * alpha_5))), 1.0);
}

vec3 compensation(Surface s_14, float cosine_9) {
    uint code_13 = uint(s_14.code);
    bool _e8 = isDielectric(code_13);
    bool asked = pick(((code_13 & 8u) != 0u), !(_e8), false);
    float _e12 = singleScatteringAlbedo(cosine_9, s_14.alpha);
    vec3 _e17 = facetReflectance(s_14, 1.0, 1.0);
    return pick(asked, (vec3(1.0) + (_e17 * ((1.0 - _e12) / _e12))), vec3(1.0));
}

FacetLobe evaluateFacets(Surface s_15, Outgoing o_3, vec3 wi_1) {
    vec3 passes = vec3(0.0);
    vec3 wo_6 = o_3.wo;
    bool _e6 = isDielectric(uint(s_15.code));
    const bool _e8 = hasGlass;
    bool crossing_1 = pick(_e8, ((wo_6.z < 0.0) != (wi_1.z < 0.0)), false);
    vec3 m_1 = (wo_6 + (wi_1 * pick(crossing_1, o_3.ratio, 1.0)));
    float m2_1 = max(dot(m_1, m_1), 1e-20);
    vec3 h_7 = (m_1 * inversesqrt(m2_1));
    float oh_1 = dot(wo_6, h_7);
    float ih = dot(wi_1, h_7);
    float zo = abs(wo_6.z);
    float zi = abs(wi_1.z);
    bool faces_1 = pick(!(crossing_1), true, pick((((oh_1 * h_7.z) * wo_6.z) >= 0.0), (((ih * h_7.z) * wi_1.z) >= 0.0), false));
    float _e54 = facetDensity(h_7, s_15.alpha);
    float spread = (pick(crossing_1, (abs((oh_1 * ih)) / m2_1), 0.25) * pick(faces_1, (2.0 * _e54), 0.0));
    vec3 _e62 = facetReflectance(s_15, abs(oh_1), o_3.ratio);
    passes = pick(crossing_1, (vec3(1.0) - _e62), _e62);
    float _e69 = stretched(wi_1, s_15.alpha);
    float apart = ((0.5 * (zo + o_3.stretched)) * (zi + _e69));
    bool _e82 = hidesApart(uint(s_15.code));
    float masked = (zi / max(pick(_e82, apart, ((zi * o_3.stretched) + (zo * _e69))), 1e-20));
    float _e88 = passes.x;
    float chosen_1 = (pick(_e6, _e88, 1.0) * pick(crossing_1, (o_3.ratio * o_3.ratio), 1.0));
    const bool _e98 = hasCompensation;
    if (_e98) {
        vec3 _e99 = passes;
        vec3 _e100 = compensation(s_15, zo);
        passes = (_e99 * _e100);
    }
    vec3 _e102 = passes;
    return FacetLobe(((_e102 * spread) * masked), ((spread * chosen_1) / ((o_3.bound * zo) + o_3.stretched)), abs(oh_1));
}

vec4 evaluateBsdf(Surface s_16, Outgoing o_4, vec3 wi_2) {
    vec4 value = vec4(0.0);
    bool dark = false;
    vec3 base = vec3(0.0);
    float lambert = (0.31830987 * max(wi_2.z, 0.0));
    value = (vec4(s_16.baseColor, 1.0) * lambert);
    dark = pick((o_4.wo.z < 0.0), true, (wi_2.z <= 0.0));
    const bool _e23 = hasConductors;
    const bool _e25 = hasMetallicRoughness;
    const bool _e30 = hasGlass;
    if (pick(pick(_e23, true, pick(_e25, true, false)), true, _e30)) {
        uint code_14 = uint(s_16.code);
        FacetLobe _e34 = evaluateFacets(s_16, o_4, wi_2);
        const bool _e39 = hasMetallicRoughness;
        if (_e39) {
            if (true) {
                vec3 _e41 = base;
                vec3 _e45 = metallicRoughnessDiffuse(s_16.baseColor, s_16.metallic, _e34.cosine);
                bool _e46 = isMetallicRoughness(code_14);
                base = pick(_e46, _e45, _e41);
            }
        }
        bool _e55 = isSmooth(code_14);
        vec4 rough = pick(_e55, vec4(0.0), vec4(_e34.value, (o_4.share * _e34.pdf)));
        vec3 _e57 = base;
        vec4 _e64 = value;
        uint _e65 = kindOf(code_14);
        value = pick((_e65 == diffuse0_), _e64, (rough + (vec4(_e57, (1.0 - o_4.share)) * lambert)));
        bool _e69 = dark;
        bool _e70 = isSmooth(code_14);
        bool _e71 = isDielectric(code_14);
        dark = pick(_e71, _e70, _e69);
    }
    float _e74 = mirrorShare(s_16.reflectivity);
    vec4 _e77 = value;
    bool _e81 = dark;
    return pick(_e81, vec4(0.0), ((1.0 - _e74) * _e77));
}

BsdfSample completed(BsdfSample drawn_1, vec4 value_1) {
    float pdf_4 = pick((drawn_1.pdf <= 0.0), 0.0, value_1.w);
    vec3 weight_2 = pick((pdf_4 > 0.0), (value_1.xyz / vec3(max(pdf_4, 1e-30))), vec3(0.0));
    return BsdfSample(drawn_1.direction, pick(drawn_1.delta, drawn_1.pdf, pdf_4), pick(drawn_1.delta, drawn_1.weight, weight_2), drawn_1.delta);
}

Pair evaluatePair(Surface s_17, Outgoing o_5, vec3 toLight_1, BsdfSample drawn_2) {
    Pair pair_2 = Pair(vec4(0.0), BsdfSample(vec3(0.0), 0.0, vec3(0.0), false));
    vec4 _e4 = evaluateBsdf(s_17, o_5, toLight_1);
    vec4 _e6 = evaluateBsdf(s_17, o_5, drawn_2.direction);
    BsdfSample _e7 = completed(drawn_2, _e6);
    pair_2 = Pair(_e4, _e7);
    Pair _e10 = pair_2;
    return _e10;
}

bool crosses(vec3 geometric, vec3 a_1, vec3 b_3) {
    return ((dot(geometric, a_1) > 0.0) != (dot(geometric, b_3) > 0.0));
}

vec3 toWorld(Basis b_4, vec3 v_6) {
    return (((v_6.x * b_4.tangent) + (v_6.y * b_4.bitangent)) + (v_6.z * b_4.normal));
}

float max3_(vec3 v_7) {
    return max(max(v_7.x, v_7.y), v_7.z);
}

float unitFloat(uint h_3) {
    return (float((h_3 >> 8u)) * 5.9604645e-8);
}

float nextHash(inout Sampler s_18) {
    uint _e3 = s_18.key;
    s_18.key = (_e3 + 1u);
    uint _e7 = s_18.key;
    uint _e9 = s_18.salt;
    uint _e11 = mixBits((_e7 ^ _e9));
    uint _e13 = s_18.sample_;
    uint _e17 = s_18.place;
    uint _e20 = mixBits((_e11 + ((_e13 * 256u) | _e17)));
    float _e21 = unitFloat(_e20);
    return _e21;
}

bool isFlat(uint i_17) {
    uint _e4 = frame.shapeEnds.y;
    return (i_17 >= _e4);
}

void meetSurface(inout Path p_9, PairHit hit_2) {
    Surface surface_1 = Surface(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    Basis basis = Basis(vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 hero_1 = vec3(1.0);
    RayPair rays_1 = p_9.rays;
    bool escaped = (hit_2.shape == noShape);
    uint shape_1 = pick(escaped, 0u, hit_2.shape);
    SurfacePoint _e10 = surfaceAt(rays_1, hit_2, shape_1);
    surface_1 = _e10.surface;
    float _e14 = surface_1.code;
    float _e18 = surface_1.eta.x;
    bool _e19 = letsThrough(uint(_e14), _e18);
    vec3 point_16 = (rays_1.point + (hit_2.t * rays_1.direction));
    vec3 outward_1 = _e10.shading;
    vec3 normal_9 = pick(pick((dot(outward_1, rays_1.direction) > 0.0), !(_e19), false), -(outward_1), outward_1);
    Basis _e34 = basisAbout(normal_9);
    basis = _e34;
    Basis _e36 = basis;
    vec3 _e39 = toLocal(_e36, -(rays_1.direction));
    const bool _e41 = hasGlass;
    if (pick(_e41, true, hasTransmission)) {
        float _e45 = surface_1.code;
        bool _e47 = isThin(uint(_e45));
        bool inside_4 = pick(pick(pick(_e19, !(_e47), false), (_e39.z < 0.0), false), !(escaped), false);
        vec3 _e57 = p_9.throughput;
        vec3 _e59 = surface_1.absorption;
        p_9.throughput = (_e57 * exp((-(_e59) * pick(inside_4, hit_2.t, 0.0))));
    }
    Emitter _e68 = fetchEmitter(0u);
    p_9.escaped = escaped;
    Path _e70 = p_9;
    Surface _e71 = surface_1;
    vec3 _e73 = metLight(_e70, hit_2, _e71, _e10.geometric, _e68);
    vec3 _e75 = p_9.radiance;
    vec3 _e77 = p_9.throughput;
    p_9.radiance = (_e75 + (_e77 * pick(escaped, vec3(0.0), _e73)));
    vec3 litSide = pick(_e19, vec3(0.0), normal_9);
    TwoPoints _e87 = nextTwo3d(p_9.sampler_);
    EmitterChoice _e90 = chooseEmitter(point_16, litSide, _e87.first.z);
    Emitter _e92 = emitterAt(_e90.index, _e68);
    LightSample _e95 = sampleEmitter(_e92, point_16, _e87.first.xy);
    float lightPdf = (_e95.pdf * _e90.probability);
    Surface _e102 = surface_1;
    vec3 _e103 = hero_1;
    Outgoing _e104 = outgoing(_e102, _e39, _e103);
    Surface _e105 = surface_1;
    BsdfSample _e107 = sampleLobe(_e105, _e104, _e87.second);
    Surface _e108 = surface_1;
    Basis _e109 = basis;
    vec3 _e111 = toLocal(_e109, _e95.direction);
    Pair _e112 = evaluatePair(_e108, _e104, _e111, _e107);
    bool opaque = pick(hasMeshes, !(_e19), false);
    bool _e120 = crosses(_e10.geometric, _e95.direction, -(rays_1.direction));
    bool lightLeaks = pick(opaque, _e120, false);
    vec4 toLight_6 = pick(lightLeaks, vec4(0.0), _e112.toLight);
    bool alone = pick(_e95.delta, true, pick((_e92.shape < 0.0), (_e95.distance_ < 1e30), false));
    float _e136 = misWeight(lightPdf, toLight_6.w);
    float lightWeight = (pick(alone, 1.0, _e136) / lightPdf);
    BsdfSample bsdf = _e112.drawn;
    Basis _e141 = basis;
    vec3 _e143 = toWorld(_e141, bsdf.direction);
    bool _e147 = crosses(_e10.geometric, _e143, -(rays_1.direction));
    bool leaks = pick(opaque, _e147, false);
    uint _e151 = p_9.depth;
    uint _e154 = frame.maxDepth;
    bool goesOn = pick(!(escaped), (_e151 != _e154), false);
    vec3 _e158 = p_9.throughput;
    vec3 contribution = (((_e158 * toLight_6.xyz) * _e95.radiance) * lightWeight);
    bool lit_1 = pick(pick(goesOn, (lightPdf > 0.0), false), any(greaterThan((toLight_6.xyz * _e95.radiance), vec3(0.0))), false);
    p_9.light = pick(lit_1, contribution, vec3(0.0));
    vec3 _e180 = p_9.throughput;
    vec3 throughput = (_e180 * bsdf.weight);
    float _e183 = max3_(throughput);
    uint _e189 = p_9.depth;
    float survival = pick((_e189 < rouletteDepth), 1.0, min((_e183 / 0.33333334), 0.95));
    float _e201 = max3_(throughput);
    float _e206 = nextHash(p_9.sampler_);
    p_9.alive = pick(pick(pick(pick(goesOn, (bsdf.pdf > 0.0), false), !(leaks), false), (_e201 > 0.0), false), (_e206 < survival), false);
    uint _e211 = p_9.depth;
    p_9.depth = (_e211 + 1u);
    bool stays = pick(true, escaped, false);
    vec3 _e219 = p_9.throughput;
    p_9.throughput = pick(stays, _e219, (throughput / vec3(survival)));
    float _e227 = p_9.pdf;
    p_9.pdf = pick(stays, _e227, pick(bsdf.delta, 0.0, bsdf.pdf));
    vec3 _e231 = p_9.litSide;
    p_9.litSide = pick(stays, _e231, litSide);
    float _e239 = p_9.odds.total;
    p_9.odds.total = pick(stays, _e239, _e90.odds.total);
    float _e247 = p_9.odds.tree;
    p_9.odds.tree = pick(stays, _e247, _e90.odds.tree);
    bool _e249 = isFlat(shape_1);
    bool solid = !(_e249);
    uint lightShape = pick((_e92.shape >= 0.0), uint(max(_e92.shape, 0.0)), noShape);
    bool _e268 = p_9.alive;
    Sampler _e285 = p_9.sampler_;
    uint _e286 = numberOfNext(_e285);
    p_9.rays = RayPair(pick(stays, rays_1.point, point_16), shape_1, hit_2.triangle, (1e-5 * length(point_16)), _e268, pick(stays, rays_1.direction, _e143), pick(solid, (dot(_e143, outward_1) < 0.0), false), _e95.direction, pick(solid, (dot(_e95.direction, outward_1) < 0.0), false), pick(lit_1, _e95.distance_, -1.0), lightShape, _e286);
    return;
}

void extendPath(inout Path p_10) {
    RayPair _e2 = p_10.rays;
    PairHit _e3 = tracePair(_e2);
    vec3 _e5 = p_10.radiance;
    vec3 _e7 = p_10.light;
    p_10.radiance = (_e5 + pick(_e3.blocked, vec3(0.0), _e7));
    p_10.rays.lightDistance = -1.0;
    bool _e17 = p_10.alive;
    if (_e17) {
        meetSurface(p_10, _e3);
        return;
    } else {
        return;
    }
}

bool isOver(Path p_11) {
    return pick(!(p_11.alive), (p_11.rays.lightDistance < 0.0), false);
}

vec2 quadrantAngles(vec2 x_15, vec2 y_7) {
    vec2 low_2 = min(x_15, y_7);
    vec2 high_2 = max(x_15, y_7);
    bvec2 middle_3 = greaterThan(low_2, (0.41421357 * high_2));
    vec2 r_2 = (mix(low_2, (low_2 - high_2), middle_3) / max(mix(high_2, (low_2 + high_2), middle_3), vec2(1e-30)));
    vec2 z_3 = (r_2 * r_2);
    vec2 series_1 = ((((((0.080537446 * z_3) - vec2(0.13877685)) * z_3) + vec2(0.19977711)) * z_3) - vec2(0.3333295));
    vec2 angle_1 = (mix(vec2(0.0), vec2(0.7853982), middle_3) + (((series_1 * z_3) * r_2) + r_2));
    return mix(angle_1, (vec2(1.5707964) - angle_1), greaterThan(y_7, x_15));
}

EnvironmentLight lookUpEnvironment(vec3 direction_11) {
    vec2 size_3 = frame.environmentSize;
    float sine_6 = max(length(direction_11.xz), 1e-9);
    vec2 _e15 = quadrantAngles(abs(vec2(direction_11.z, direction_11.y)), vec2(abs(direction_11.x), sine_6));
    float turn_1 = (pick((direction_11.z > 0.0), (3.1415927 - _e15.x), _e15.x) * pick((direction_11.x < 0.0), -1.0, 1.0));
    float _e35 = frame.environmentTurn;
    float column_2 = ((fract(((turn_1 * 0.15915494) + _e35)) * size_3.x) + 0.5);
    float fromPole_1 = ((_e15.y * (size_3.y / 3.1415927)) + 0.5);
    float row_3 = floor(fromPole_1);
    bool isLower_1 = (direction_11.y < 0.0);
    vec2 cell_2 = vec2(floor(column_2), pick(isLower_1, (size_3.y - row_3), row_3));
    float within_2 = (fromPole_1 - row_3);
    vec2 at_2 = vec2((column_2 - cell_2.x), pick(isLower_1, (1.0 - within_2), within_2));
    Corners _e66 = environmentCorners(uvec2(cell_2));
    EnvironmentLight _e67 = lightWithin(_e66, at_2, sine_6);
    return _e67;
}

EnvironmentLight skyLight(vec3 direction_12) {
    EnvironmentLight light = white;
    const bool _e4 = hasEnvironment;
    if (_e4) {
        EnvironmentLight _e5 = lookUpEnvironment(direction_12);
        light = _e5;
    }
    vec3 _e7 = light.radiance;
    vec3 _e8 = sky(direction_12);
    float _e11 = light.pdf;
    return EnvironmentLight((_e7 * _e8), _e11);
}

FarLight skySeen(vec3 direction_13) {
    FarLight far = FarLight(vec3(0.0), 0.0);
    const bool _e7 = hasSky;
    if (_e7) {
        EnvironmentLight _e8 = skyLight(direction_13);
        far = FarLight(_e8.radiance, _e8.pdf);
    }
    FarLight _e12 = far;
    return _e12;
}

bool isOnDisc(Emitter e_18, vec3 direction_14) {
    vec3 chord = (direction_14 + e_18.u);
    return ((3.1415927 * dot(chord, chord)) < e_18.area);
}

float directionalPdf(Emitter e_19, vec3 direction_15) {
    bool _e7 = isOnDisc(e_19, direction_15);
    return pick(_e7, (1.0 / max(e_19.area, 1e-31)), 0.0);
}

FarLight farLight(Emitter e_20, vec3 direction_16, FarLight sky_1) {
    FarLight far_1 = FarLight(vec3(0.0), 0.0);
    const bool _e9 = hasSuns;
    if (_e9) {
        bool _e13 = isOnDisc(e_20, direction_16);
        bool seen_1 = pick((e_20.kind == 5.0), _e13, false);
        float _e19 = directionalPdf(e_20, direction_16);
        far_1 = FarLight(pick(seen_1, e_20.radiance, vec3(0.0)), pick(seen_1, _e19, 0.0));
    }
    const bool _e24 = hasSky;
    if (_e24) {
        if ((e_20.kind == 6.0)) {
            far_1 = sky_1;
        }
    }
    FarLight _e28 = far_1;
    return _e28;
}

void addSkyAndSuns(inout Path p_12) {
    vec3 found_7 = vec3(0.0);
    uint i_18 = 0u;
    vec3 direction_20 = p_12.rays.direction;
    FarLight _e4 = skySeen(direction_20);
    while(true) {
        uint _e10 = i_18;
        Emitter _e11 = fetchEmitter(_e10);
        FarLight _e12 = farLight(_e11, direction_20, _e4);
        vec3 _e16 = p_12.rays.point;
        vec3 _e18 = p_12.litSide;
        Odds _e20 = p_12.odds;
        float _e21 = listedProbability(_e11, _e16, _e18, _e20);
        float pdf_5 = (_e12.pdf * _e21);
        vec3 _e23 = found_7;
        float _e26 = p_12.pdf;
        float _e27 = misWeight(_e26, pdf_5);
        float _e29 = p_12.pdf;
        found_7 = (_e23 + (_e12.radiance * pick((_e29 <= 0.0), 1.0, _e27)));
        uint _e37 = i_18;
        i_18 = (_e37 + 1u);
        const bool _e40 = hasManyLights;
        if (!(_e40)) {
            break;
        }
        uint _e42 = i_18;
        uint _e45 = frame.farEmitters;
        if ((_e42 >= _e45)) {
            break;
        }
    }
    vec3 _e48 = p_12.radiance;
    vec3 _e50 = p_12.throughput;
    vec3 _e51 = found_7;
    p_12.radiance = (_e48 + (_e50 * _e51));
    return;
}

void addFarLight(inout Path p_13) {
    const bool _e2 = hasSky;
    const bool _e4 = hasSuns;
    if (pick(_e2, true, _e4)) {
        bool _e7 = p_13.escaped;
        uint _e10 = frame.emitterCount;
        if (pick(_e7, (_e10 > 0u), false)) {
            addSkyAndSuns(p_13);
            return;
        } else {
            return;
        }
    } else {
        return;
    }
}

void main() {
    vec4 fragment = gl_FragCoord;
    Path p = Path(RayPair(vec3(0.0), 0u, LeftTriangle(0u, 0u), 0.0, false, vec3(0.0), false, vec3(0.0), false, 0.0, 0u, 0u), vec3(0.0), false, vec3(0.0), false, 0u, vec3(0.0), 0.0, vec3(0.0), Odds(0.0, 0.0), Sampler(0u, 0u, 0u, 0u));
    Film film = Film(vec4(0.0), vec4(0.0));
    uvec2 texel = uvec2(fragment.xy);
    uvec2 _e5 = frame.origin;
    uint _e9 = frame.sampleIndex;
    Path _e10 = startPath((_e5 + texel), _e9);
    p = _e10;
    while(true) {
        extendPath(p);
        Path _e12 = p;
        bool _e13 = isOver(_e12);
        if (_e13) {
            break;
        }
    }
    addFarLight(p);
    uint _e22 = frame.sampleIndex;
    if ((_e22 > 0u)) {
        vec4 _e27 = texelFetch(previousFilm, ivec2(texel), 0);
        vec4 _e30 = texelFetch(previousSquares, ivec2(texel), 0);
        film = Film(_e27, _e30);
    }
    vec4 _e33 = film.sums;
    vec3 _e35 = p.radiance;
    vec4 _e40 = film.squares;
    vec3 _e42 = p.radiance;
    vec3 _e44 = p.radiance;
    Film _tmp_return = Film((_e33 + vec4(_e35, 1.0)), (_e40 + vec4((_e42 * _e44), 0.0)));
    _fs2p_location0 = _tmp_return.sums;
    _fs2p_location1 = _tmp_return.squares;
    return;
}

