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
    uint relayRow;
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
struct Basis {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
};
struct Meeting {
    vec3 point;
    uint shape;
    Surface surface;
    bool isClear;
    vec3 geometric;
    vec3 outward;
    Basis basis;
    vec3 wo;
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
struct LightSample {
    vec3 direction;
    float distance_;
    vec3 radiance;
    float pdf;
    bool delta;
};
struct Lit {
    LightSample light;
    float pdf;
    float shape;
    Odds odds;
    vec3 u;
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
const uint conductor = 2u;
const uint diffuse0_ = 0u;
const bool hasMeshes = false;
const uint rouletteDepth = 5u;
const EnvironmentLight white0_ = EnvironmentLight(vec3(1.0), 0.07957747);
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

const bool hasConductors = false;

const bool hasMirrorLayers = true;

const bool hasCompensation = false;

const bool hasManyLights = true;

const bool hasSphereLights = true;

const bool hasQuadLights = false;

const bool hasBoxLights = false;

const bool hasSuns = false;

const bool hasPointLights = false;

const bool hasSky = true;

const bool hasEnvironment = false;

uniform highp sampler2D environment;

uniform highp sampler2D previousFilm;

uniform highp sampler2D previousSquares;

layout(location = 0) out vec4 _fs2p_location0;
layout(location = 1) out vec4 _fs2p_location1;

Path noPath() {
    Path p_1 = Path(RayPair(vec3(0.0), 0u, LeftTriangle(0u, 0u), 0.0, false, vec3(0.0), false, vec3(0.0), false, 0.0, 0u, 0u), vec3(0.0), vec3(0.0), false, 0u, vec3(0.0), 0.0, vec3(0.0), Odds(0.0, 0.0), Sampler(0u, 0u, 0u, 0u));
    p_1.rays.lightDirection = vec3(0.0, 1.0, 0.0);
    p_1.rays.lightDistance = -1.0;
    Path _e10 = p_1;
    return _e10;
}

uint pcg(uint x) {
    uint s_18 = ((x * 747796405u) + 2891336453u);
    uint w_2 = (((s_18 >> ((s_18 >> 28u) + 4u)) ^ s_18) * 277803737u);
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
    vec2 p_19 = ((2.0 * u_2) - vec2(1.0));
    bool wide = (abs(p_19.x) > abs(p_19.y));
    float radius_1 = pick(wide, p_19.x, p_19.y);
    float ratio_4 = (pick(wide, p_19.y, p_19.x) / pick((radius_1 == 0.0), 1.0, radius_1));
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

uint numberOfNext(Sampler s_4) {
    uint _e8 = mixBits((((s_4.key + 1u) ^ s_4.salt) ^ 2246822507u));
    uint _e15 = mixBits((_e8 + ((s_4.sample_ << 8u) | s_4.place)));
    return _e15;
}

void startPath(inout Path p_2, uvec2 pixel_2, uint sampleIndex_2) {
    uint _e6 = frame.seed;
    Sampler _e7 = startSampler(pixel_2, sampleIndex_2, _e6);
    p_2.sampler_ = _e7;
    vec2 _e13 = next2d(p_2.sampler_);
    vec2 _e14 = filterOffset(_e13);
    vec2 filmPosition_2 = ((vec2(pixel_2) + vec2(0.5)) + _e14);
    vec2 _e17 = lensPoint_2(p_2.sampler_);
    CameraRay _e18 = cameraRay(filmPosition_2, _e17);
    p_2.rays.point = _e18.origin;
    p_2.rays.shape = noShape;
    p_2.rays.left = noTriangle;
    p_2.rays.tMin = 0.0;
    p_2.rays.goesOn = true;
    p_2.rays.direction = _e18.direction;
    Sampler _e40 = p_2.sampler_;
    uint _e41 = numberOfNext(_e40);
    p_2.rays.number = _e41;
    p_2.light = vec3(0.0);
    p_2.throughput = vec3(1.0);
    p_2.depth = 1u;
    p_2.radiance = vec3(0.0);
    p_2.pdf = 0.0;
    return;
}

vec4 tableTexel(uint column, uint row) {
    vec4 _e5 = texelFetch(sceneTable, ivec2(uvec2(column, row)), 0);
    return _e5;
}

Bounds fetchBounds(uint i) {
    vec4 _e2 = tableTexel(0u, i);
    return Bounds(_e2.xyz, _e2.w);
}

float intersectSphere(vec3 origin, vec3 direction, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter = (center - origin);
    float along = dot(toCenter, direction);
    vec3 across_2 = (toCenter - (along * direction));
    float discriminant = ((radius * radius) - dot(across_2, across_2));
    float half_1 = sqrt(max(discriminant, 0.0));
    float near = (along - half_1);
    float far_2 = (along + half_1);
    float t_5 = pick((near > tMin), near, far_2);
    return pick(startsInside, max(far_2, 0.0), pick(pick((discriminant >= 0.0), (t_5 > tMin), false), t_5, 1e30));
}

PairHit meet(PairHit found, RayPair p_3, uint i_1, vec2 t) {
    bool own_2 = (i_1 == p_3.shape);
    float pathT = pick(pick(own_2, !(p_3.inwards), false), 1e30, t.x);
    float lightT = pick(pick(pick(own_2, !(p_3.lightInwards), false), true, (i_1 == p_3.lightShape)), 1e30, t.y);
    bool nearer = (pathT < found.t);
    return PairHit(pick(nearer, pathT, found.t), pick(nearer, i_1, found.shape), pick(found.blocked, true, (lightT < p_3.lightDistance)), noTriangle, vec2(0.0));
}

PairHit meetSphere(PairHit found_1, RayPair p_4, uint i_2) {
    Bounds _e3 = fetchBounds(i_2);
    bool own_3 = (i_2 == p_4.shape);
    float _e13 = intersectSphere(p_4.point, p_4.direction, _e3.center, _e3.radius, p_4.tMin, pick(own_3, p_4.inwards, false));
    float _e21 = intersectSphere(p_4.point, p_4.lightDirection, _e3.center, _e3.radius, p_4.tMin, pick(own_3, p_4.lightInwards, false));
    PairHit _e23 = meet(found_1, p_4, i_2, vec2(_e13, _e21));
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

vec3 safeReciprocal(vec3 d, vec3 origin_1) {
    vec3 tiny = mix(vec3(1e-18), vec3(-1e-18), greaterThan(origin_1, vec3(0.0)));
    return (vec3(1.0) / mix(d, tiny, lessThan(abs(d), vec3(1e-18))));
}

Slabs boxSlabs(vec3 origin_2, vec3 direction_1, vec3 halfSize) {
    vec3 _e3 = safeReciprocal(direction_1, origin_2);
    vec3 middle = (-(origin_2) * _e3);
    vec3 reach = (halfSize * abs(_e3));
    vec3 enter = (middle - reach);
    vec3 leave = (middle + reach);
    return Slabs(enter, leave, max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}

float intersectBox(vec3 origin_3, vec3 direction_2, vec3 halfSize_1, float tMin_1, bool startsInside_1) {
    Slabs _e5 = boxSlabs(origin_3, direction_2, halfSize_1);
    float t_7 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_7 > tMin_1), false), t_7, 1e30));
}

PairHit meetBox(PairHit found_2, RayPair p_5, uint i_4) {
    Bounds _e3 = fetchBounds(i_4);
    Extent _e4 = fetchExtent(i_4);
    bool own_4 = (i_4 == p_5.shape);
    vec3 _e11 = turned(_e4.a, (p_5.point - _e3.center));
    vec3 _e14 = turned(_e4.a, p_5.direction);
    float _e20 = intersectBox(_e11, _e14, _e4.b.xyz, p_5.tMin, pick(own_4, p_5.inwards, false));
    vec3 _e23 = turned(_e4.a, p_5.lightDirection);
    float _e29 = intersectBox(_e11, _e23, _e4.b.xyz, p_5.tMin, pick(own_4, p_5.lightInwards, false));
    PairHit _e31 = meet(found_2, p_5, i_4, vec2(_e20, _e29));
    return _e31;
}

float intersectQuad(vec3 origin_4, vec3 direction_3, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_9 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_3, normal_9);
    vec3 toCenter_1 = (center_1 - origin_4);
    float t_8 = (dot(toCenter_1, normal_9) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_20 = ((t_8 * direction_3) - toCenter_1);
    bool within = (max(abs(dot(p_20, reciprocalU)), abs(dot(p_20, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_8 > tMin_2), (t_8 < 1e30), false), within, false), t_8, 1e30);
}

PairHit meetQuad(PairHit found_3, RayPair p_6, uint i_5) {
    Bounds _e3 = fetchBounds(i_5);
    Extent _e4 = fetchExtent(i_5);
    float _e13 = intersectQuad(p_6.point, p_6.direction, _e3.center, _e4.a.xyz, _e4.b.xyz, p_6.tMin);
    float _e22 = intersectQuad(p_6.point, p_6.lightDirection, _e3.center, _e4.a.xyz, _e4.b.xyz, p_6.tMin);
    PairHit _e24 = meet(found_3, p_6, i_5, vec2(_e13, _e22));
    return _e24;
}

float intersectPlane(vec3 origin_5, vec3 direction_4, vec3 normal, float offset_1, float tMin_3) {
    float speed_1 = dot(direction_4, normal);
    float t_9 = ((offset_1 - dot(origin_5, normal)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset_1 > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_9 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset_1 == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_9, 0.0), 1e30);
}

PairHit meetPlane(PairHit found_4, RayPair p_7, uint i_6) {
    Bounds _e3 = fetchBounds(i_6);
    float _e9 = intersectPlane(p_7.point, p_7.direction, _e3.center, _e3.radius, p_7.tMin);
    float _e15 = intersectPlane(p_7.point, p_7.lightDirection, _e3.center, _e3.radius, p_7.tMin);
    PairHit _e17 = meet(found_4, p_7, i_6, vec2(_e9, _e15));
    return _e17;
}

PairHit tracePair(RayPair p_8) {
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
                PairHit _e23 = meetSphere(_e21, p_8, _e22);
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
                PairHit _e37 = meetBox(_e35, p_8, _e36);
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
                PairHit _e51 = meetQuad(_e49, p_8, _e50);
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
                PairHit _e65 = meetPlane(_e63, p_8, _e64);
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

vec3 boxNormal(vec3 origin_6, vec3 direction_5, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_6, direction_5, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_10 = pick(entering, _e5.near, _e5.far);
    vec3 side = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_5, vec3(0.0))));
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

vec3 normalAt(RayPair p_9, float t_1, uint i_11) {
    vec3 normal_1 = vec3(0.0);
    Bounds _e3 = fetchBounds(i_11);
    vec3 origin_7 = (p_9.point - _e3.center);
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
        bool inside = pick((i_11 == p_9.shape), p_9.inwards, false);
        vec3 _e28 = turned(_e22.a, origin_7);
        vec3 _e31 = turned(_e22.a, p_9.direction);
        vec3 _e35 = boxNormal(_e28, _e31, _e22.b.xyz, p_9.tMin, inside);
        vec3 _e36 = normal_1;
        vec3 _e38 = turnedBack(_e22.a, _e35);
        bool _e39 = isBox(i_11);
        normal_1 = pick(_e39, _e38, _e36);
    }
    const bool _e42 = hasSpheres;
    if (_e42) {
        vec3 outwards = (origin_7 + (t_1 * p_9.direction));
        vec3 _e46 = normal_1;
        bool _e53 = isSphere(i_11);
        normal_1 = pick(_e53, pick((dot(outwards, outwards) == 0.0), -(p_9.direction), outwards), _e46);
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

Meeting meetingAt(inout Path p_10, PairHit hit_1) {
    Surface surface_1 = Surface(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    Basis basis = Basis(vec3(0.0), vec3(0.0), vec3(0.0));
    RayPair rays_1 = p_10.rays;
    bool escaped = (hit_1.shape == noShape);
    uint shape_1 = pick(escaped, 0u, hit_1.shape);
    SurfacePoint _e10 = surfaceAt(rays_1, hit_1, shape_1);
    surface_1 = _e10.surface;
    float _e14 = surface_1.code;
    float _e18 = surface_1.eta.x;
    bool _e19 = letsThrough(uint(_e14), _e18);
    vec3 outward_1 = _e10.shading;
    vec3 normal_10 = pick(pick((dot(outward_1, rays_1.direction) > 0.0), !(_e19), false), -(outward_1), outward_1);
    Basis _e29 = basisAbout(normal_10);
    basis = _e29;
    Basis _e31 = basis;
    vec3 _e34 = toLocal(_e31, -(rays_1.direction));
    const bool _e36 = hasGlass;
    if (pick(_e36, true, hasTransmission)) {
        float _e40 = surface_1.code;
        bool _e42 = isThin(uint(_e40));
        bool inside_1 = pick(pick(pick(_e19, !(_e42), false), (_e34.z < 0.0), false), !(escaped), false);
        vec3 _e52 = p_10.throughput;
        vec3 _e54 = surface_1.absorption;
        p_10.throughput = (_e52 * exp((-(_e54) * pick(inside_1, hit_1.t, 0.0))));
    }
    Surface _e67 = surface_1;
    Basis _e69 = basis;
    return Meeting((rays_1.point + (hit_1.t * rays_1.direction)), shape_1, _e67, _e19, _e10.geometric, outward_1, _e69, _e34);
}

bool isConductor(uint code_6) {
    const bool _e2 = hasConductors;
    uint _e3 = kindOf(code_6);
    return pick(_e2, (_e3 == conductor), false);
}

vec3 schlick(vec3 f0_, float cosine) {
    float m_3 = max((1.0 - cosine), 0.0);
    float m2_ = (m_3 * m_3);
    return (f0_ + ((vec3(1.0) - f0_) * ((m2_ * m2_) * m_3)));
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
    float s_19 = (1.0 + length(wo.xy));
    float s2_ = (s_19 * s_19);
    float a2_ = (alpha * alpha);
    return (((1.0 - a2_) * s2_) / (s2_ + ((a2_ * wo.z) * wo.z)));
}

float stretched(vec3 w_1, float alpha_1) {
    return sqrt(((w_1.z * w_1.z) + ((alpha_1 * alpha_1) * dot(w_1.xy, w_1.xy))));
}

Outgoing outgoing(Surface s_5, vec3 wo_1, vec3 hero) {
    Outgoing o = Outgoing(vec3(0.0), 0.0, 0.0, 0.0, 0.0);
    uint code_10 = uint(s_5.code);
    bool _e5 = isConductor(code_10);
    bool _e6 = isDielectric(code_10);
    o = Outgoing(wo_1, pick(pick(_e5, true, _e6), 1.0, 0.0), 1.0, 1.0, 1.0);
    const bool _e17 = hasMetallicRoughness;
    if (_e17) {
        if (true) {
            float _e21 = o.share;
            float _e25 = specularShare(s_5.baseColor, s_5.metallic, wo_1.z);
            bool _e26 = isMetallicRoughness(code_10);
            o.share = pick(_e26, _e25, _e21);
        }
    }
    const bool _e29 = hasGlass;
    if (_e29) {
        bool _e34 = isThin(code_10);
        float _e35 = indexRatio(s_5.eta.x, wo_1.z, _e34);
        bool _e36 = isDielectric(code_10);
        o.ratio = pick(_e36, _e35, 1.0);
    }
    const bool _e40 = hasConductors;
    const bool _e42 = hasMetallicRoughness;
    const bool _e47 = hasGlass;
    if (pick(pick(_e40, true, pick(_e42, true, false)), true, _e47)) {
        float _e51 = reflectionBound(wo_1, s_5.alpha);
        bool _e52 = isDielectric(code_10);
        o.bound = pick(_e52, 1.0, _e51);
        float _e57 = stretched(wo_1, s_5.alpha);
        o.stretched = _e57;
    }
    Outgoing _e58 = o;
    return _e58;
}

float mirrorShare(float reflectivity) {
    const bool _e2 = hasMirrorLayers;
    return pick(_e2, reflectivity, 0.0);
}

vec3 sampleCosine(vec2 u_4) {
    float radius_2 = sqrt(u_4.x);
    float phi = ((6.2831855 * u_4.y) - 3.1415927);
    return normalize(vec3((radius_2 * cos(phi)), (radius_2 * sin(phi)), sqrt((1.0 - u_4.x))));
}

bool isSmooth(uint code_7) {
    return ((code_7 & 32u) != 0u);
}

vec3 sampleVisibleNormal(vec3 wo_2, float alpha_2, float bound, vec2 u_5) {
    float _e8 = stretched(wo_2, alpha_2);
    vec3 w_3 = (vec3((alpha_2 * wo_2.xy), wo_2.z) / vec3(_e8));
    float phi_1 = ((6.2831855 * u_5.x) - 3.1415927);
    float drop = (u_5.y * (1.0 + (bound * w_3.z)));
    float sine_1 = sqrt(max((drop * (2.0 - drop)), 0.0));
    vec3 h_4 = (w_3 + vec3((sine_1 * cos(phi_1)), (sine_1 * sin(phi_1)), (1.0 - drop)));
    return normalize(vec3((alpha_2 * h_4.xy), max(h_4.z, 1e-7)));
}

vec3 sampleFacet(float alpha_3, bool isMirror, Outgoing o_1, vec2 u_6) {
    float side_2 = pick((o_1.wo.z < 0.0), -1.0, 1.0);
    vec3 _e16 = sampleVisibleNormal((o_1.wo * side_2), max(alpha_3, 0.001), o_1.bound, u_6);
    return (pick(isMirror, vec3(0.0, 0.0, 1.0), _e16) * side_2);
}

vec3 conductorFresnel(float cosine_3, vec3 eta_2, vec3 k) {
    float cosine2_ = (cosine_3 * cosine_3);
    float sine2_ = (1.0 - cosine2_);
    vec3 difference = (((eta_2 * eta_2) - (k * k)) - vec3(sine2_));
    vec3 a2PlusB2_ = sqrt(((difference * difference) + ((((4.0 * eta_2) * eta_2) * k) * k)));
    vec3 larger = sqrt(((0.5 * (a2PlusB2_ + abs(difference))) + vec3(1e-20)));
    vec3 smaller = ((eta_2 * k) / larger);
    vec3 a_3 = mix(smaller, larger, greaterThan(difference, vec3(0.0)));
    vec3 b_7 = mix(larger, smaller, greaterThan(difference, vec3(0.0)));
    vec3 b2_ = ((b_7 * b_7) + vec3(1e-20));
    vec3 acrossFar = (a_3 + vec3(cosine_3));
    vec3 acrossNear = (a_3 - vec3(cosine_3));
    vec3 across_3 = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a_3 * cosine_3) + vec3(sine2_));
    vec3 alongNear = ((a_3 * cosine_3) - vec3(sine2_));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across_3) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor_3, vec3 eta_3, vec3 k_1, float cosine_4) {
    float constants = dot((eta_3 + k_1), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_4, eta_3, k_1);
    return pick((constants > 0.0), _e8, baseColor_3);
}

float dielectricFresnel(float cosine_5, float ratio) {
    float inside2_ = (((ratio - 1.0) * (ratio + 1.0)) + (cosine_5 * cosine_5));
    float inside_2 = sqrt(max(inside2_, 0.0));
    float across_4 = ((cosine_5 - inside_2) / (cosine_5 + inside_2));
    float along_1 = ((((ratio * ratio) * cosine_5) - inside_2) / (((ratio * ratio) * cosine_5) + inside_2));
    return pick((inside2_ > 0.0), (0.5 * ((across_4 * across_4) + (along_1 * along_1))), 1.0);
}

float glassReflectance(float cosine_6, float ratio_1, bool thin_1) {
    float _e3 = dielectricFresnel(cosine_6, ratio_1);
    return pick(thin_1, ((2.0 * _e3) / (1.0 + _e3)), _e3);
}

vec3 facetReflectance(Surface s_6, float cosine_7, float ratio_2) {
    vec3 reflectance = vec3(0.0);
    uint code_11 = uint(s_6.code);
    const bool _e9 = hasMetallicRoughness;
    if (_e9) {
        if (true) {
            vec3 _e13 = metallicRoughnessF0_(s_6.baseColor, s_6.metallic);
            vec3 _e14 = schlick(_e13, cosine_7);
            reflectance = _e14;
        }
    }
    const bool _e16 = hasConductors;
    if (_e16) {
        vec3 _e17 = reflectance;
        vec3 _e21 = conductorReflectance(s_6.baseColor, s_6.eta, s_6.k, cosine_7);
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

vec3 refracted(vec3 wo_3, vec3 h, float ratio_3) {
    float cosine_10 = dot(wo_3, h);
    float inside_3 = sqrt(max((((ratio_3 - 1.0) * (ratio_3 + 1.0)) + (cosine_10 * cosine_10)), 0.0));
    return ((((cosine_10 - inside_3) * h) - wo_3) / vec3(ratio_3));
}

vec3 mirrored(vec3 wo_4) {
    return vec3(-(wo_4.xy), wo_4.z);
}

BsdfSample sampleLobe(Surface s_7, Outgoing o_2, vec3 u_7) {
    BsdfSample drawn = BsdfSample(vec3(0.0), 0.0, vec3(0.0), false);
    vec3 wi = vec3(0.0);
    float probability = 0.0;
    vec3 weight = vec3(0.0);
    vec3 wo_5 = o_2.wo;
    float _e5 = mirrorShare(s_7.reflectivity);
    float base_1 = (1.0 - _e5);
    float choice_1 = ((u_7.z - _e5) / base_1);
    vec3 _e12 = sampleCosine(u_7.xy);
    drawn = BsdfSample(_e12, 1.0, vec3(1.0), false);
    const bool _e20 = hasConductors;
    const bool _e22 = hasMetallicRoughness;
    const bool _e27 = hasGlass;
    if (pick(pick(_e20, true, pick(_e22, true, false)), true, _e27)) {
        uint code_12 = uint(s_7.code);
        bool _e31 = isDielectric(code_12);
        bool _e32 = isSmooth(code_12);
        vec3 _e35 = sampleFacet(s_7.alpha, _e32, o_2, u_7.xy);
        float oh = max(dot(wo_5, _e35), 0.0);
        vec3 _e40 = facetReflectance(s_7, oh, o_2.ratio);
        bool crossing = pick(_e31, (choice_1 >= _e40.x), false);
        wi = (((2.0 * oh) * _e35) - wo_5);
        probability = (base_1 * o_2.share);
        weight = (_e40 / vec3(o_2.share));
        const bool _e57 = hasGlass;
        if (_e57) {
            bool _e58 = isThin(code_12);
            vec3 _e59 = wi;
            vec3 _e61 = refracted(wo_5, _e35, o_2.ratio);
            wi = pick(crossing, pick(_e58, -(wo_5), _e61), _e59);
            float _e65 = probability;
            probability = pick(_e31, (base_1 * pick(crossing, (1.0 - _e40.x), _e40.x)), _e65);
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
        float _e106 = probability;
        drawn.pdf = pick(specular_1, pick(lost, 0.0, _e106), _e105);
        vec3 _e112 = drawn.weight;
        vec3 _e113 = weight;
        drawn.weight = pick(specular_1, _e113, _e112);
        drawn.delta = pick(specular_1, _e32, false);
    }
    const bool _e118 = hasMirrorLayers;
    if (_e118) {
        bool reflected = (u_7.z < _e5);
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

float facetDensity(vec3 h_1, float alpha_4) {
    float slope = max(((dot(h_1.xy, h_1.xy) / (alpha_4 * alpha_4)) + (h_1.z * h_1.z)), 1.0);
    return (0.31830987 / (((alpha_4 * alpha_4) * slope) * slope));
}

bool hidesApart(uint code_8) {
    return ((code_8 & 64u) != 0u);
}

float singleScatteringAlbedo(float cosine_8, float alpha_5) {
    float x_18 = (cosine_8 / (cosine_8 + alpha_5));
    vec4 byAlpha = (vec4(0.887807, 0.309386, -0.270728, 0.0252433) + (x_18 * (vec4(1.08526, -3.21434, -1.87718, 1.61195) + (x_18 * (vec4(-5.18071, 10.7648, 6.30913, -8.09265) + (x_18 * (vec4(7.80474, -12.743, -24.1046, 25.2536) + (x_18 * vec4(-3.60041, 4.60906, 23.1225, -22.9342)))))))));
    float a2_1 = (alpha_5 * alpha_5);
    return min(dot(byAlpha, vec4(1.0, alpha_5, a2_1, (a2_1 * alpha_5))), 1.0);
}

vec3 compensation(Surface s_8, float cosine_9) {
    uint code_13 = uint(s_8.code);
    bool _e8 = isDielectric(code_13);
    bool asked = pick(((code_13 & 8u) != 0u), !(_e8), false);
    float _e12 = singleScatteringAlbedo(cosine_9, s_8.alpha);
    vec3 _e17 = facetReflectance(s_8, 1.0, 1.0);
    return pick(asked, (vec3(1.0) + (_e17 * ((1.0 - _e12) / _e12))), vec3(1.0));
}

FacetLobe evaluateFacets(Surface s_9, Outgoing o_3, vec3 wi_1) {
    vec3 passes = vec3(0.0);
    vec3 wo_6 = o_3.wo;
    bool _e6 = isDielectric(uint(s_9.code));
    const bool _e8 = hasGlass;
    bool crossing_1 = pick(_e8, ((wo_6.z < 0.0) != (wi_1.z < 0.0)), false);
    vec3 m_4 = (wo_6 + (wi_1 * pick(crossing_1, o_3.ratio, 1.0)));
    float m2_1 = max(dot(m_4, m_4), 1e-20);
    vec3 h_5 = (m_4 * inversesqrt(m2_1));
    float oh_1 = dot(wo_6, h_5);
    float ih = dot(wi_1, h_5);
    float zo = abs(wo_6.z);
    float zi = abs(wi_1.z);
    bool faces = pick(!(crossing_1), true, pick((((oh_1 * h_5.z) * wo_6.z) >= 0.0), (((ih * h_5.z) * wi_1.z) >= 0.0), false));
    float _e54 = facetDensity(h_5, s_9.alpha);
    float spread = (pick(crossing_1, (abs((oh_1 * ih)) / m2_1), 0.25) * pick(faces, (2.0 * _e54), 0.0));
    vec3 _e62 = facetReflectance(s_9, abs(oh_1), o_3.ratio);
    passes = pick(crossing_1, (vec3(1.0) - _e62), _e62);
    float _e69 = stretched(wi_1, s_9.alpha);
    float apart = ((0.5 * (zo + o_3.stretched)) * (zi + _e69));
    bool _e82 = hidesApart(uint(s_9.code));
    float masked = (zi / max(pick(_e82, apart, ((zi * o_3.stretched) + (zo * _e69))), 1e-20));
    float _e88 = passes.x;
    float chosen_1 = (pick(_e6, _e88, 1.0) * pick(crossing_1, (o_3.ratio * o_3.ratio), 1.0));
    const bool _e98 = hasCompensation;
    if (_e98) {
        vec3 _e99 = passes;
        vec3 _e100 = compensation(s_9, zo);
        passes = (_e99 * _e100);
    }
    vec3 _e102 = passes;
    return FacetLobe(((_e102 * spread) * masked), ((spread * chosen_1) / ((o_3.bound * zo) + o_3.stretched)), abs(oh_1));
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
    const bool _e30 = hasGlass;
    if (pick(pick(_e23, true, pick(_e25, true, false)), true, _e30)) {
        uint code_14 = uint(s_10.code);
        FacetLobe _e34 = evaluateFacets(s_10, o_4, wi_2);
        const bool _e39 = hasMetallicRoughness;
        if (_e39) {
            if (true) {
                vec3 _e41 = base;
                vec3 _e45 = metallicRoughnessDiffuse(s_10.baseColor, s_10.metallic, _e34.cosine);
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
    float _e74 = mirrorShare(s_10.reflectivity);
    vec4 _e77 = value;
    bool _e81 = dark;
    return pick(_e81, vec4(0.0), ((1.0 - _e74) * _e77));
}

BsdfSample completed(BsdfSample drawn_1, vec4 value_1) {
    float pdf_1 = pick((drawn_1.pdf <= 0.0), 0.0, value_1.w);
    vec3 weight_1 = pick((pdf_1 > 0.0), (value_1.xyz / vec3(max(pdf_1, 1e-30))), vec3(0.0));
    return BsdfSample(drawn_1.direction, pick(drawn_1.delta, drawn_1.pdf, pdf_1), pick(drawn_1.delta, drawn_1.weight, weight_1), drawn_1.delta);
}

Pair evaluatePair(Surface s_11, Outgoing o_5, vec3 toLight, BsdfSample drawn_2) {
    Pair pair = Pair(vec4(0.0), BsdfSample(vec3(0.0), 0.0, vec3(0.0), false));
    vec4 _e4 = evaluateBsdf(s_11, o_5, toLight);
    vec4 _e6 = evaluateBsdf(s_11, o_5, drawn_2.direction);
    BsdfSample _e7 = completed(drawn_2, _e6);
    pair = Pair(_e4, _e7);
    Pair _e10 = pair;
    return _e10;
}

bool crosses(vec3 geometric, vec3 a, vec3 b_1) {
    return ((dot(geometric, a) > 0.0) != (dot(geometric, b_1) > 0.0));
}

float misWeight(float own, float other) {
    float ratio_5 = (other / own);
    return (1.0 / (1.0 + (ratio_5 * ratio_5)));
}

vec3 toWorld(Basis b_2, vec3 v_4) {
    return (((v_4.x * b_2.tangent) + (v_4.y * b_2.bitangent)) + (v_4.z * b_2.normal));
}

float max3_(vec3 v_5) {
    return max(max(v_5.x, v_5.y), v_5.z);
}

float unitFloat(uint h_2) {
    return (float((h_2 >> 8u)) * 5.9604645e-8);
}

float nextHash(inout Sampler s_12) {
    uint _e3 = s_12.key;
    s_12.key = (_e3 + 1u);
    uint _e7 = s_12.key;
    uint _e9 = s_12.salt;
    uint _e11 = mixBits((_e7 ^ _e9));
    uint _e13 = s_12.sample_;
    uint _e17 = s_12.place;
    uint _e20 = mixBits((_e11 + ((_e13 * 256u) | _e17)));
    float _e21 = unitFloat(_e20);
    return _e21;
}

vec3 litSideOf(Meeting m) {
    return pick(m.isClear, vec3(0.0), m.basis.normal);
}

bool isFlat(uint i_13) {
    uint _e4 = frame.shapeEnds.y;
    return (i_13 >= _e4);
}

void scatter(inout Path p_11, PairHit hit_2, Meeting m_1, Lit lit) {
    vec3 hero_1 = vec3(1.0);
    RayPair rays_2 = p_11.rays;
    bool escaped_1 = (hit_2.shape == noShape);
    LightSample light_1 = lit.light;
    vec3 _e15 = hero_1;
    Outgoing _e16 = outgoing(m_1.surface, m_1.wo, _e15);
    BsdfSample _e19 = sampleLobe(m_1.surface, _e16, lit.u);
    vec3 _e23 = toLocal(m_1.basis, light_1.direction);
    Pair _e24 = evaluatePair(m_1.surface, _e16, _e23, _e19);
    bool opaque = pick(hasMeshes, !(m_1.isClear), false);
    bool _e33 = crosses(m_1.geometric, light_1.direction, -(rays_2.direction));
    bool lightLeaks = pick(opaque, _e33, false);
    vec4 toLight_3 = pick(lightLeaks, vec4(0.0), _e24.toLight);
    bool alone = pick(light_1.delta, true, pick((lit.shape < 0.0), (light_1.distance_ < 1e30), false));
    float _e50 = misWeight(lit.pdf, toLight_3.w);
    float lightWeight = (pick(alone, 1.0, _e50) / lit.pdf);
    BsdfSample bsdf = _e24.drawn;
    vec3 _e58 = toWorld(m_1.basis, bsdf.direction);
    bool _e62 = crosses(m_1.geometric, _e58, -(rays_2.direction));
    bool leaks = pick(opaque, _e62, false);
    uint _e66 = p_11.depth;
    uint _e69 = frame.maxDepth;
    bool goesOn = pick(!(escaped_1), (_e66 != _e69), false);
    vec3 _e73 = p_11.throughput;
    vec3 contribution = (((_e73 * toLight_3.xyz) * light_1.radiance) * lightWeight);
    bool isLit = pick(pick(goesOn, (lit.pdf > 0.0), false), any(greaterThan((toLight_3.xyz * light_1.radiance), vec3(0.0))), false);
    p_11.light = pick(isLit, contribution, vec3(0.0));
    vec3 _e96 = p_11.throughput;
    vec3 throughput = (_e96 * bsdf.weight);
    float _e99 = max3_(throughput);
    uint _e105 = p_11.depth;
    float survival = pick((_e105 < rouletteDepth), 1.0, min((_e99 / 0.33333334), 0.95));
    float _e116 = max3_(throughput);
    float _e121 = nextHash(p_11.sampler_);
    bool alive = pick(pick(pick(pick(goesOn, (bsdf.pdf > 0.0), false), !(leaks), false), (_e116 > 0.0), false), (_e121 < survival), false);
    uint _e126 = p_11.depth;
    p_11.depth = (_e126 + 1u);
    bool stays = pick(true, escaped_1, false);
    vec3 _e134 = p_11.throughput;
    p_11.throughput = pick(stays, _e134, (throughput / vec3(survival)));
    float _e142 = p_11.pdf;
    p_11.pdf = pick(stays, _e142, pick(bsdf.delta, 0.0, bsdf.pdf));
    vec3 _e145 = litSideOf(m_1);
    vec3 _e147 = p_11.litSide;
    p_11.litSide = pick(stays, _e147, _e145);
    float _e155 = p_11.odds.total;
    p_11.odds.total = pick(stays, _e155, lit.odds.total);
    float _e163 = p_11.odds.tree;
    p_11.odds.tree = pick(stays, _e163, lit.odds.tree);
    bool _e166 = isFlat(m_1.shape);
    bool solid = !(_e166);
    uint lightShape = pick((lit.shape >= 0.0), uint(max(lit.shape, 0.0)), noShape);
    Sampler _e205 = p_11.sampler_;
    uint _e206 = numberOfNext(_e205);
    p_11.rays = RayPair(pick(stays, rays_2.point, m_1.point), m_1.shape, hit_2.triangle, (1e-5 * length(m_1.point)), alive, pick(stays, rays_2.direction, _e58), pick(solid, (dot(_e58, m_1.outward) < 0.0), false), light_1.direction, pick(solid, (dot(light_1.direction, m_1.outward) < 0.0), false), pick(isLit, light_1.distance_, -1.0), lightShape, _e206);
    return;
}

Emitter fetchEmitter(uint i_14) {
    vec4 _e2 = tableTexel(14u, i_14);
    vec4 _e4 = tableTexel(15u, i_14);
    vec4 _e6 = tableTexel(16u, i_14);
    vec4 _e8 = tableTexel(17u, i_14);
    vec4 _e10 = tableTexel(18u, i_14);
    vec4 _e12 = tableTexel(19u, i_14);
    return Emitter(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.x, _e10.y, _e10.z, _e10.w, _e12.x, _e12.y, _e12.z, _e12.w);
}

int emitterOf(float code_9) {
    return ((int(code_9) >> 7u) - 1);
}

Emitter emitterAt(uint i_15, Emitter only) {
    Emitter emitter = Emitter(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    emitter = only;
    const bool _e4 = hasManyLights;
    if (_e4) {
        Emitter _e5 = fetchEmitter(i_15);
        emitter = _e5;
    }
    Emitter _e6 = emitter;
    return _e6;
}

SphereView viewSphere(Emitter e, vec3 point) {
    vec3 toCenter_2 = (e.position - point);
    float d_1 = length(toCenter_2);
    float power = abs(((d_1 - e.radius) * (d_1 + e.radius)));
    bool inside_4 = (d_1 <= e.radius);
    float sine_2 = min((e.radius / max(d_1, 1e-30)), 1.0);
    float cosine_11 = (sqrt(power) / max(d_1, 1e-30));
    return SphereView(toCenter_2, d_1, power, inside_4, pick(inside_4, 2.0, ((sine_2 * sine_2) / (1.0 + cosine_11))));
}

float conePdf(float width) {
    return (1.0 / (6.2831855 * max(width, 1e-31)));
}

float spherePdf(Emitter e_1, vec3 point_1, vec3 direction_6) {
    SphereView _e3 = viewSphere(e_1, point_1);
    bool reached = pick(_e3.inside, true, (dot(direction_6, _e3.toCenter) > 0.0));
    float _e11 = conePdf(_e3.width);
    return pick(reached, _e11, 0.0);
}

float areaPdf(float area, float height, float distance_) {
    float pdf_2 = (((distance_ / max(height, 1e-30)) * distance_) / max((area / distance_), 1e-30));
    return min(pdf_2, 1e30);
}

float pdfOfView(QuadView q_3, float area_1, float distance_1) {
    float _e4 = areaPdf(area_1, q_3.height, distance_1);
    float pdf_3 = pick(q_3.bySolidAngle, (1.0 / max(q_3.solidAngle, 0.01)), _e4);
    return pick(q_3.lit, pdf_3, 0.0);
}

float arctangent(float x_11) {
    float a_4 = abs(x_11);
    bool steep = (a_4 > 2.4142137);
    bool middle_1 = pick((a_4 > 0.41421357), !(steep), false);
    float r = pick(steep, (-1.0 / max(a_4, 1.0)), pick(middle_1, ((a_4 - 1.0) / (a_4 + 1.0)), a_4));
    float base_2 = pick(steep, 1.5707964, pick(middle_1, 0.7853982, 0.0));
    float z_1 = (r * r);
    float series = ((((((0.080537446 * z_1) - 0.13877685) * z_1) + 0.19977711) * z_1) - 0.3333295);
    return (sign(x_11) * (base_2 + (((series * z_1) * r) + r)));
}

float stretch(float x_12, vec2 y_5, float h_3) {
    vec2 r_1 = sqrt(((vec2((x_12 * x_12)) + (y_5 * y_5)) + vec2((h_3 * h_3))));
    float _e16 = arctangent(((x_12 * y_5.y) / (h_3 * r_1.y)));
    float _e22 = arctangent(((x_12 * y_5.x) / (h_3 * r_1.x)));
    return (_e16 - _e22);
}

QuadView viewQuad(Emitter e_2, vec3 point_2) {
    vec3 corner = (e_2.position - point_2);
    vec2 lengths = vec2(length(e_2.u), length(e_2.v));
    vec3 axisX = (e_2.u / vec3(lengths.x));
    vec3 axisY = (e_2.v / vec3(lengths.y));
    vec3 normal_11 = normalize(cross(axisX, axisY));
    float signedHeight = dot(corner, normal_11);
    float least = (1e-7 * (lengths.x + lengths.y));
    float height_1 = max(abs(signedHeight), least);
    bool lit_1 = pick((abs(signedHeight) > least), pick((e_2.oneSided == 0.0), true, (signedHeight < 0.0)), false);
    vec2 low_1 = vec2(dot(corner, axisX), dot(corner, axisY));
    vec2 high_1 = (low_1 + lengths);
    vec2 y_10 = vec2(low_1.y, high_1.y);
    float _e44 = stretch(low_1.x, y_10, height_1);
    float _e46 = stretch(high_1.x, y_10, height_1);
    float solidAngle = (_e46 - _e44);
    bool rectangle = (abs(dot(axisX, axisY)) <= 1e-5);
    vec3 axisZ = (normal_11 * pick((signedHeight > 0.0), 1.0, -1.0));
    return QuadView(corner, axisX, axisY, axisZ, low_1, high_1, height_1, _e44, solidAngle, lit_1, pick(rectangle, (solidAngle > 0.01), false));
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
    vec3 faces_1 = mix(vec3(0.0), ((4.0 * e_4.u.yzx) * e_4.u.zxy), seen);
    return BoxView(rotation, _e8, faces_1, ((faces_1.x + faces_1.y) + faces_1.z), !(any(seen)));
}

float boxPdf(Emitter e_5, vec3 point_5, vec3 direction_7, float distance_3, vec3 normal_2) {
    BoxView _e5 = viewBox(e_5, point_5);
    float _e10 = areaPdf(_e5.area, (distance_3 * abs(dot(direction_7, normal_2))), distance_3);
    float _e12 = conePdf(2.0);
    return pick(_e5.inside, _e12, _e10);
}

float shapePdf(Emitter e_6, vec3 point_6, vec3 direction_8, float distance_4, vec3 normal_3, uint place) {
    float pdf = 0.0;
    const bool _e9 = hasSphereLights;
    if (_e9) {
        if ((e_6.kind == 0.0)) {
            float _e13 = spherePdf(e_6, point_6, direction_8);
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
            float _e25 = boxPdf(e_6, point_6, direction_8, distance_4, normal_3);
            pdf = _e25;
        }
    }
    float _e26 = pdf;
    return _e26;
}

float cosineTowards(Emitter e_7, vec3 toLight_1, float grown, vec3 normal_4) {
    float above = clamp(((dot(normal_4, toLight_1) + e_7.reach) / grown), 0.0, 1.0);
    return pick((dot(normal_4, normal_4) == 0.0), 1.0, above);
}

float spotFalloff(Emitter e_8, vec3 toLight_2) {
    float share = clamp(((-(dot(toLight_2, e_8.u)) - e_8.radius) / (e_8.cosInner - e_8.radius)), 0.0, 1.0);
    return (share * share);
}

float estimatedIrradiance(Emitter e_9, vec3 point_7, vec3 normal_5) {
    float estimate = 0.0;
    const bool _e4 = hasQuadLights;
    bool isQuad = pick(_e4, (e_9.kind == 1.0), false);
    const bool _e10 = hasSuns;
    bool isFar = pick(_e10, (e_9.kind == 5.0), false);
    vec3 middle_2 = (e_9.position + pick(isQuad, (0.5 * (e_9.u + e_9.v)), vec3(0.0)));
    vec3 toLight_4 = pick(isFar, -(e_9.u), (middle_2 - point_7));
    float distance2_ = dot(toLight_4, toLight_4);
    float distance_5 = sqrt(distance2_);
    float grown_1 = max((distance_5 + e_9.reach), 1e-15);
    float _e35 = cosineTowards(e_9, toLight_4, grown_1, normal_5);
    float square = pick(isQuad, (distance2_ + (e_9.area / 3.1415927)), max(distance2_, (e_9.area / 12.566371)));
    estimate = ((e_9.power * _e35) / pick(isFar, 1.0, max(square, 1e-15)));
    const bool _e54 = hasQuadLights;
    if (_e54) {
        float height_2 = (-(dot(cross(e_9.u, e_9.v), toLight_4)) / max(e_9.area, 1e-30));
        float side_3 = pick((e_9.oneSided == 1.0), max(height_2, 0.0), abs(height_2));
        float lampCosine = pick((side_3 > 0.0), ((side_3 + e_9.reach) / grown_1), 0.0);
        float _e78 = estimate;
        estimate = (_e78 * pick(isQuad, lampCosine, 1.0));
    }
    const bool _e83 = hasPointLights;
    if (_e83) {
        float _e84 = estimate;
        float _e89 = spotFalloff(e_9, (toLight_4 / vec3(max(distance_5, 1e-15))));
        estimate = (_e84 * pick((e_9.kind == 4.0), _e89, 1.0));
    }
    const bool _e97 = hasSky;
    if (_e97) {
        float _e98 = estimate;
        estimate = pick((e_9.kind == 6.0), e_9.power, _e98);
    }
    float _e104 = estimate;
    return _e104;
}

float listedProbability(Emitter e_10, vec3 point_8, vec3 normal_6, Odds odds) {
    float probability_1 = 0.0;
    uint _e6 = frame.emitterCount;
    probability_1 = float(min(_e6, 1u));
    const bool _e12 = hasManyLights;
    if (_e12) {
        uint _e15 = frame.emitterCount;
        if ((_e15 > 1u)) {
            float _e18 = estimatedIrradiance(e_10, point_8, normal_6);
            probability_1 = (_e18 / max(odds.total, 1e-37));
        }
    }
    float _e23 = probability_1;
    return _e23;
}

vec3 metLight(Path p_12, PairHit hit_3, Surface s_13, vec3 outward, Emitter only_1) {
    vec3 found_6 = vec3(0.0);
    uint i_16 = 0u;
    float probability_2 = 0.0;
    vec3 direction_16 = p_12.rays.direction;
    bool hidden = pick(((uint(s_13.code) & 16u) != 0u), (dot(outward, direction_16) > 0.0), false);
    int _e18 = emitterOf(s_13.code);
    found_6 = pick(hidden, vec3(0.0), s_13.emission);
    uint _e28 = frame.emitterCount;
    if (pick((_e18 >= 0), (_e28 > 0u), false)) {
        i_16 = uint(max(_e18, 0));
        uint _e36 = i_16;
        Emitter _e37 = emitterAt(_e36, only_1);
        float _e43 = shapePdf(_e37, p_12.rays.point, direction_16, hit_3.t, outward, hit_3.triangle.triangle);
        float _e48 = listedProbability(_e37, p_12.rays.point, p_12.litSide, p_12.odds);
        probability_2 = _e48;
        vec3 _e50 = found_6;
        float _e52 = probability_2;
        float _e54 = misWeight(p_12.pdf, (_e43 * _e52));
        found_6 = (_e50 * pick((p_12.pdf <= 0.0), 1.0, _e54));
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

TwoPoints nextTwo3d(inout Sampler s_14) {
    Sampler _e1 = s_14;
    Groups _e2 = nextGroups(_e1);
    uint _e5 = s_14.key;
    s_14.key = (_e5 + 2u);
    vec2 _e8 = firstOf(_e2);
    vec2 _e9 = secondOf(_e2);
    vec2 _e10 = thirdOf(_e2);
    return TwoPoints(vec3(_e8.x, _e9.x, _e10.x), vec3(_e8.y, _e9.y, _e10.y));
}

EmitterChoice chooseEmitter(vec3 point_9, vec3 normal_7, float u_8) {
    bool hasTree = false;
    EmitterChoice choice = EmitterChoice(0u, 0.0, Odds(0.0, 0.0));
    float total = 0.0;
    uint chosen = 0u;
    float chosenWeight = 0.0;
    float rest = 0.0;
    uint i_17 = 0u;
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
            rest = u_8;
            while(true) {
                uint _e41 = i_17;
                Emitter _e42 = fetchEmitter(_e41);
                float _e43 = estimatedIrradiance(_e42, point_9, normal_7);
                uint _e44 = i_17;
                float weight_2 = pick((_e44 < listed), _e43, 0.0);
                float _e48 = total;
                total = (_e48 + weight_2);
                float _e50 = total;
                float share_1 = (weight_2 / max(_e50, 1e-37));
                float _e54 = rest;
                bool take = (_e54 < share_1);
                uint _e56 = chosen;
                uint _e57 = i_17;
                chosen = pick(take, _e57, _e56);
                float _e59 = chosenWeight;
                chosenWeight = pick(take, weight_2, _e59);
                float _e61 = rest;
                float _e68 = rest;
                rest = pick(take, (_e68 / max(share_1, 1e-37)), ((_e61 - share_1) / max((1.0 - share_1), 1e-7)));
                uint _e74 = i_17;
                i_17 = (_e74 + 1u);
                uint _e76 = i_17;
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

vec3 turnTo(vec3 axis, vec3 v_6) {
    float s_20 = pick((axis.z >= 0.0), 1.0, -1.0);
    float a_5 = (-1.0 / (s_20 + axis.z));
    float b_8 = ((axis.x * axis.y) * a_5);
    vec3 x_19 = vec3((1.0 + (((s_20 * axis.x) * axis.x) * a_5)), (s_20 * b_8), (-(s_20) * axis.x));
    vec3 y_11 = vec3(b_8, (s_20 + ((axis.y * axis.y) * a_5)), -(axis.y));
    return (((v_6.x * x_19) + (v_6.y * y_11)) + (v_6.z * axis));
}

ConeDirection sampleCone(vec3 axis_1, float width_1, vec2 u_9) {
    float oneMinusCosine = (u_9.x * width_1);
    float cosine_12 = (1.0 - oneMinusCosine);
    float sine2_1 = (oneMinusCosine * (2.0 - oneMinusCosine));
    float sine_3 = sqrt(max(sine2_1, 0.0));
    float phi_2 = (6.2831855 * u_9.y);
    vec2 turn = vec2(cos(phi_2), sin(phi_2));
    vec3 _e23 = turnTo(axis_1, vec3(((sine_3 / length(turn)) * turn), cosine_12));
    return ConeDirection(_e23, cosine_12, sine2_1);
}

LightSample sampleSphere(Emitter e_11, vec3 point_10, vec2 u_10) {
    SphereView _e3 = viewSphere(e_11, point_10);
    vec3 axis_2 = pick((_e3.distance_ < 1e-30), vec3(0.0, 0.0, 1.0), (_e3.toCenter / vec3(max(_e3.distance_, 1e-30))));
    ConeDirection _e19 = sampleCone(axis_2, _e3.width, u_10);
    float along_2 = (_e3.distance_ * _e19.cosine);
    float halfChord = sqrt(max(((e_11.radius * e_11.radius) - ((_e3.distance_ * _e3.distance_) * _e19.sine2_)), 0.0));
    float larger_1 = (abs(along_2) + halfChord);
    bool takeLarger = pick(_e3.inside, (along_2 > 0.0), false);
    float distance_6 = pick(takeLarger, larger_1, (_e3.power / max(larger_1, 1e-30)));
    float _e49 = conePdf(_e3.width);
    return LightSample(_e19.direction, distance_6, e_11.radiance, _e49, false);
}

vec2 cosineAndSine(float x_14) {
    float h_6 = (0.5 * x_14);
    float z_2 = (h_6 * h_6);
    float sine_4 = (((((((-0.00019515296 * z_2) + 0.008332161) * z_2) - 0.16666655) * z_2) * h_6) + h_6);
    return vec2((1.0 - ((2.0 * sine_4) * sine_4)), ((2.0 * sine_4) * sqrt((1.0 - (sine_4 * sine_4)))));
}

vec3 sphericalRectangle(QuadView q_4, vec2 u_11) {
    float h_7 = q_4.height;
    vec2 y_12 = vec2(q_4.low.y, q_4.high.y);
    vec2 s_21 = (y_12 / sqrt(((y_12 * y_12) + vec2((h_7 * h_7)))));
    vec2 _e21 = cosineAndSine((0.5 * (q_4.start + (u_11.x * q_4.solidAngle))));
    vec2 across_5 = (vec2((s_21.y - s_21.x), (s_21.y + s_21.x)) * _e21);
    float w_4 = (((2.0 * _e21.x) * _e21.y) / max(length(across_5), 1e-15));
    float x_20 = clamp(((h_7 * w_4) * inversesqrt(max((1.0 - (w_4 * w_4)), 1e-12))), q_4.low.x, q_4.high.x);
    float d2_ = ((x_20 * x_20) + (h_7 * h_7));
    vec2 ends_2 = (y_12 * inversesqrt((vec2(d2_) + (y_12 * y_12))));
    float v_8 = mix(ends_2.x, ends_2.y, u_11.y);
    float atY = clamp(((v_8 * sqrt(d2_)) * inversesqrt(max((1.0 - (v_8 * v_8)), 1e-12))), y_12.x, y_12.y);
    return (((x_20 * q_4.axisX) + (atY * q_4.axisY)) + (h_7 * q_4.axisZ));
}

LightSample sampleQuad(Emitter e_12, vec3 point_11, vec2 u_12) {
    QuadView _e3 = viewQuad(e_12, point_11);
    vec3 onArea = ((_e3.corner + (u_12.x * e_12.u)) + (u_12.y * e_12.v));
    vec3 _e13 = sphericalRectangle(_e3, u_12);
    vec3 toLight_5 = pick(_e3.bySolidAngle, _e13, onArea);
    float distance_7 = max(length(toLight_5), _e3.height);
    float _e23 = pdfOfView(_e3, e_12.area, distance_7);
    return LightSample((toLight_5 / vec3(distance_7)), distance_7, e_12.radiance, _e23, false);
}

vec4 pointOnFaces(Emitter e_13, BoxView b_3, vec2 u_13) {
    float both = (b_3.faces.x + b_3.faces.y);
    float at_1 = (u_13.x * b_3.area);
    bool onX_1 = (at_1 < b_3.faces.x);
    bool onY_1 = pick(!(onX_1), (at_1 < both), false);
    float face = pick(onX_1, b_3.faces.x, pick(onY_1, b_3.faces.y, b_3.faces.z));
    float within_1 = clamp(((at_1 - pick(onX_1, 0.0, pick(onY_1, b_3.faces.x, both))) / max(face, 1e-30)), 0.0, 1.0);
    vec3 axis_3 = vec3(pick(onX_1, 1.0, 0.0), pick(onY_1, 1.0, 0.0), pick(pick(onX_1, true, onY_1), 0.0, 1.0));
    vec3 p_21 = vec3(pick((dot(axis_3, b_3.point) >= 0.0), 1.0, -1.0), ((2.0 * within_1) - 1.0), ((2.0 * u_13.y) - 1.0));
    vec3 toLight_6 = ((pick(onX_1, p_21.xyz, pick(onY_1, p_21.zxy, p_21.yzx)) * e_13.u) - b_3.point);
    return vec4(toLight_6, abs(dot(axis_3, toLight_6)));
}

vec3 rotateBack(vec4 q_5, vec3 v_7) {
    vec3 _e6 = rotate(vec4(-(q_5.xyz), q_5.w), v_7);
    return _e6;
}

LightSample sampleBox(Emitter e_14, vec3 point_12, vec2 u_14) {
    BoxView _e3 = viewBox(e_14, point_12);
    vec4 _e4 = pointOnFaces(e_14, _e3, u_14);
    ConeDirection _e10 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_14);
    vec3 outwards_1 = _e10.direction;
    Slabs _e16 = boxSlabs(_e3.point, outwards_1, e_14.u);
    float distance_8 = pick(_e3.inside, max(_e16.far, 0.0), length(_e4.xyz));
    vec3 direction_17 = pick(_e3.inside, outwards_1, (_e4.xyz / vec3(max(distance_8, 1e-30))));
    float _e31 = areaPdf(_e3.area, _e4.w, distance_8);
    float _e33 = conePdf(2.0);
    float pdf_4 = pick(_e3.inside, _e33, _e31);
    vec3 _e37 = rotateBack(_e3.rotation, direction_17);
    return LightSample(_e37, distance_8, e_14.radiance, pdf_4, false);
}

LightSample samplePoint(Emitter e_15, vec3 point_13) {
    vec3 toLight_7 = (e_15.position - point_13);
    float distance_9 = length(toLight_7);
    float safe = max(distance_9, 1e-15);
    return LightSample((toLight_7 / vec3(safe)), distance_9, (e_15.radiance / vec3((safe * safe))), pick((distance_9 > 1e-15), 1.0, 0.0), true);
}

LightSample sampleSpot(Emitter e_16, vec3 point_14) {
    LightSample s_15 = LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, false);
    LightSample _e2 = samplePoint(e_16, point_14);
    s_15 = _e2;
    vec3 _e5 = s_15.direction;
    float _e6 = spotFalloff(e_16, _e5);
    vec3 _e8 = s_15.radiance;
    s_15.radiance = (_e8 * _e6);
    float _e12 = s_15.pdf;
    s_15.pdf = pick((_e6 > 0.0), _e12, 0.0);
    LightSample _e17 = s_15;
    return _e17;
}

LightSample sampleDirectional(Emitter e_17, vec2 u_15) {
    bool delta = (e_17.area == 0.0);
    ConeDirection _e10 = sampleCone(-(e_17.u), (e_17.area / 6.2831855), u_15);
    return LightSample(_e10.direction, 1e30, e_17.radiance, pick(delta, 1.0, (1.0 / max(e_17.area, 1e-31))), delta);
}

vec4 environmentTexel(uint column_1, uint row_1) {
    vec4 _e5 = texelFetch(environment, ivec2(uvec2(column_1, row_1)), 0);
    return _e5;
}

vec4 fetchEntries(Table t_2, uint pair_1) {
    float _e5 = frame.environmentSize.x;
    uint width_2 = uint(_e5);
    uint i_19 = (t_2.first + pair_1);
    uint row_2 = (i_19 / width_2);
    vec4 _e12 = environmentTexel((i_19 - (row_2 * width_2)), row_2);
    return _e12;
}

vec2 sharesBeyond(vec4 pair_2, uint digits, uint fine) {
    uvec2 further = (uvec2(pair_2.yw) & uvec2(4095u));
    return ((pair_2.xz - vec2(float(digits))) + ((vec2(further) - vec2(float(fine))) * 0.00024414063));
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

ChosenCell chooseCell(vec2 u_16) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size = uvec2(_e3);
    uvec2 digits_4 = uvec2((u_16 * 16777216.0));
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

float linearSample(float u_17, float a_1, float b_4) {
    vec2 ends_3 = (vec2(a_1, b_4) / vec2(max((a_1 + b_4), 1e-37)));
    return min((u_17 / max((ends_3.x + sqrt(mix((ends_3.x * ends_3.x), (ends_3.y * ends_3.y), u_17))), 1e-9)), 1.0);
}

EnvironmentLight lightWithin(Corners k_2, vec2 at, float sine) {
    vec4 light_2 = mix(mix(k_2.a, k_2.b, at.x), mix(k_2.c, k_2.d, at.x), at.y);
    return EnvironmentLight(light_2.xyz, (max(light_2.w, 0.0) / sine));
}

EnvironmentSample sampleEnvironment(vec2 u_18) {
    vec2 size_2 = frame.environmentSize;
    ChosenCell _e4 = chooseCell(u_18);
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
    vec2 phi_3 = (_e100 * pick(back, -1.0, 1.0));
    float sine_5 = max(_e76.y, 1e-9);
    vec3 direction_18 = vec3((sine_5 * phi_3.y), pick(isLower, -(_e76.x), _e76.x), (-(sine_5) * phi_3.x));
    EnvironmentLight _e119 = lightWithin(_e6, vec2(_e55, t_11), sine_5);
    return EnvironmentSample(direction_18, _e119);
}

vec3 sky(vec3 direction_9) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_9.y, 0.0));
}

LightSample sampleSky(vec2 u_19) {
    EnvironmentSample s_16 = EnvironmentSample(vec3(0.0), EnvironmentLight(vec3(0.0), 0.0));
    ConeDirection _e6 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_19);
    s_16 = EnvironmentSample(_e6.direction, white0_);
    const bool _e12 = hasEnvironment;
    if (_e12) {
        EnvironmentSample _e13 = sampleEnvironment(u_19);
        s_16 = _e13;
    }
    vec3 _e15 = s_16.direction;
    vec3 _e18 = s_16.light.radiance;
    vec3 _e20 = s_16.direction;
    vec3 _e21 = sky(_e20);
    float _e25 = s_16.light.pdf;
    return LightSample(_e15, 1e30, (_e18 * _e21), _e25, false);
}

LightSample sampleEmitter(Emitter e_18, vec3 point_15, vec2 u_20) {
    LightSample s_17 = LightSample(vec3(0.0, 1.0, 0.0), 1e30, vec3(0.0), 0.0, true);
    const bool _e15 = hasSphereLights;
    if (_e15) {
        if ((e_18.kind == 0.0)) {
            LightSample _e19 = sampleSphere(e_18, point_15, u_20);
            s_17 = _e19;
        }
    }
    const bool _e21 = hasQuadLights;
    if (_e21) {
        if ((e_18.kind == 1.0)) {
            LightSample _e25 = sampleQuad(e_18, point_15, u_20);
            s_17 = _e25;
        }
    }
    const bool _e27 = hasBoxLights;
    if (_e27) {
        if ((e_18.kind == 2.0)) {
            LightSample _e31 = sampleBox(e_18, point_15, u_20);
            s_17 = _e31;
        }
    }
    const bool _e33 = hasPointLights;
    if (_e33) {
        if ((e_18.kind == 3.0)) {
            LightSample _e37 = samplePoint(e_18, point_15);
            s_17 = _e37;
        }
    }
    const bool _e39 = hasPointLights;
    if (_e39) {
        if ((e_18.kind == 4.0)) {
            LightSample _e43 = sampleSpot(e_18, point_15);
            s_17 = _e43;
        }
    }
    const bool _e45 = hasSuns;
    if (_e45) {
        if ((e_18.kind == 5.0)) {
            LightSample _e49 = sampleDirectional(e_18, u_20);
            s_17 = _e49;
        }
    }
    const bool _e51 = hasSky;
    if (_e51) {
        if ((e_18.kind == 6.0)) {
            LightSample _e55 = sampleSky(u_20);
            s_17 = _e55;
        }
    }
    float _e58 = s_17.pdf;
    float _e60 = s_17.distance_;
    s_17.pdf = pick((_e60 <= (1e-5 * length(point_15))), 0.0, _e58);
    LightSample _e67 = s_17;
    return _e67;
}

Lit lightAt(inout Path p_13, PairHit hit_4, Meeting m_2) {
    Emitter _e4 = fetchEmitter(0u);
    Path _e5 = p_13;
    vec3 _e8 = metLight(_e5, hit_4, m_2.surface, m_2.geometric, _e4);
    vec3 _e10 = p_13.radiance;
    vec3 _e12 = p_13.throughput;
    p_13.radiance = (_e10 + (_e12 * pick((hit_4.shape == noShape), vec3(0.0), _e8)));
    TwoPoints _e22 = nextTwo3d(p_13.sampler_);
    vec3 _e24 = litSideOf(m_2);
    EmitterChoice _e27 = chooseEmitter(m_2.point, _e24, _e22.first.z);
    Emitter _e29 = emitterAt(_e27.index, _e4);
    LightSample _e33 = sampleEmitter(_e29, m_2.point, _e22.first.xy);
    return Lit(_e33, (_e33.pdf * _e27.probability), _e29.shape, _e27.odds, _e22.second);
}

void meetSurface(inout Path p_14, PairHit hit_5) {
    Meeting _e2 = meetingAt(p_14, hit_5);
    p_14.escaped = (hit_5.shape == noShape);
    Lit _e7 = lightAt(p_14, hit_5, _e2);
    scatter(p_14, hit_5, _e2, _e7);
    return;
}

void extendPath(inout Path p_15) {
    RayPair _e2 = p_15.rays;
    PairHit _e3 = tracePair(_e2);
    vec3 _e5 = p_15.radiance;
    vec3 _e7 = p_15.light;
    p_15.radiance = (_e5 + pick(_e3.blocked, vec3(0.0), _e7));
    p_15.rays.lightDistance = -1.0;
    bool _e18 = p_15.rays.goesOn;
    if (_e18) {
        meetSurface(p_15, _e3);
        return;
    } else {
        return;
    }
}

bool isOver(Path p_16) {
    return pick(!(p_16.rays.goesOn), (p_16.rays.lightDistance < 0.0), false);
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

EnvironmentLight lookUpEnvironment(vec3 direction_10) {
    vec2 size_3 = frame.environmentSize;
    float sine_6 = max(length(direction_10.xz), 1e-9);
    vec2 _e15 = quadrantAngles(abs(vec2(direction_10.z, direction_10.y)), vec2(abs(direction_10.x), sine_6));
    float turn_1 = (pick((direction_10.z > 0.0), (3.1415927 - _e15.x), _e15.x) * pick((direction_10.x < 0.0), -1.0, 1.0));
    float _e35 = frame.environmentTurn;
    float column_2 = ((fract(((turn_1 * 0.15915494) + _e35)) * size_3.x) + 0.5);
    float fromPole_1 = ((_e15.y * (size_3.y / 3.1415927)) + 0.5);
    float row_3 = floor(fromPole_1);
    bool isLower_1 = (direction_10.y < 0.0);
    vec2 cell_2 = vec2(floor(column_2), pick(isLower_1, (size_3.y - row_3), row_3));
    float within_2 = (fromPole_1 - row_3);
    vec2 at_2 = vec2((column_2 - cell_2.x), pick(isLower_1, (1.0 - within_2), within_2));
    Corners _e66 = environmentCorners(uvec2(cell_2));
    EnvironmentLight _e67 = lightWithin(_e66, at_2, sine_6);
    return _e67;
}

EnvironmentLight skyLight(vec3 direction_11) {
    EnvironmentLight light = white0_;
    const bool _e4 = hasEnvironment;
    if (_e4) {
        EnvironmentLight _e5 = lookUpEnvironment(direction_11);
        light = _e5;
    }
    vec3 _e7 = light.radiance;
    vec3 _e8 = sky(direction_11);
    float _e11 = light.pdf;
    return EnvironmentLight((_e7 * _e8), _e11);
}

FarLight skySeen(vec3 direction_12) {
    FarLight far = FarLight(vec3(0.0), 0.0);
    const bool _e7 = hasSky;
    if (_e7) {
        EnvironmentLight _e8 = skyLight(direction_12);
        far = FarLight(_e8.radiance, _e8.pdf);
    }
    FarLight _e12 = far;
    return _e12;
}

bool isOnDisc(Emitter e_19, vec3 direction_13) {
    vec3 chord = (direction_13 + e_19.u);
    return ((3.1415927 * dot(chord, chord)) < e_19.area);
}

float directionalPdf(Emitter e_20, vec3 direction_14) {
    bool _e7 = isOnDisc(e_20, direction_14);
    return pick(_e7, (1.0 / max(e_20.area, 1e-31)), 0.0);
}

FarLight farLight(Emitter e_21, vec3 direction_15, FarLight sky_1) {
    FarLight far_1 = FarLight(vec3(0.0), 0.0);
    const bool _e9 = hasSuns;
    if (_e9) {
        bool _e13 = isOnDisc(e_21, direction_15);
        bool seen_1 = pick((e_21.kind == 5.0), _e13, false);
        float _e19 = directionalPdf(e_21, direction_15);
        far_1 = FarLight(pick(seen_1, e_21.radiance, vec3(0.0)), pick(seen_1, _e19, 0.0));
    }
    const bool _e24 = hasSky;
    if (_e24) {
        if ((e_21.kind == 6.0)) {
            far_1 = sky_1;
        }
    }
    FarLight _e28 = far_1;
    return _e28;
}

float farProbability(Emitter e_22, vec3 normal_8, Odds odds_1) {
    float probability_3 = 0.0;
    float estimate_1 = 0.0;
    uint _e5 = frame.emitterCount;
    probability_3 = float(min(_e5, 1u));
    const bool _e11 = hasManyLights;
    if (_e11) {
        uint _e14 = frame.emitterCount;
        if ((_e14 > 1u)) {
            estimate_1 = e_22.power;
            const bool _e20 = hasSuns;
            if (_e20) {
                float grown_2 = max((sqrt(dot(e_22.u, e_22.u)) + e_22.reach), 1e-15);
                float _e29 = estimate_1;
                float _e32 = cosineTowards(e_22, -(e_22.u), grown_2, normal_8);
                estimate_1 = (_e29 * pick((e_22.kind == 5.0), _e32, 1.0));
            }
            float _e39 = estimate_1;
            probability_3 = min((_e39 / max(odds_1.total, 1e-37)), 1.0);
        }
    }
    float _e46 = probability_3;
    return _e46;
}

void addSkyAndSuns(inout Path p_17) {
    vec3 found_7 = vec3(0.0);
    uint i_18 = 0u;
    vec3 direction_19 = p_17.rays.direction;
    FarLight _e4 = skySeen(direction_19);
    while(true) {
        uint _e10 = i_18;
        Emitter _e11 = fetchEmitter(_e10);
        FarLight _e12 = farLight(_e11, direction_19, _e4);
        vec3 _e15 = p_17.litSide;
        Odds _e17 = p_17.odds;
        float _e18 = farProbability(_e11, _e15, _e17);
        float pdf_5 = (_e12.pdf * _e18);
        vec3 _e20 = found_7;
        float _e23 = p_17.pdf;
        float _e24 = misWeight(_e23, pdf_5);
        float _e26 = p_17.pdf;
        found_7 = (_e20 + (_e12.radiance * pick((_e26 <= 0.0), 1.0, _e24)));
        uint _e34 = i_18;
        i_18 = (_e34 + 1u);
        const bool _e37 = hasSuns;
        const bool _e40 = hasManyLights;
        if (pick(!(_e37), true, !(_e40))) {
            break;
        }
        uint _e43 = i_18;
        uint _e46 = frame.farEmitters;
        if ((_e43 >= _e46)) {
            break;
        }
    }
    vec3 _e49 = p_17.radiance;
    vec3 _e51 = p_17.throughput;
    vec3 _e52 = found_7;
    p_17.radiance = (_e49 + (_e51 * _e52));
    return;
}

void addFarLight(inout Path p_18) {
    const bool _e2 = hasSky;
    const bool _e4 = hasSuns;
    if (pick(_e2, true, _e4)) {
        bool _e7 = p_18.escaped;
        uint _e10 = frame.emitterCount;
        if (pick(_e7, (_e10 > 0u), false)) {
            addSkyAndSuns(p_18);
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
    Path p = Path(RayPair(vec3(0.0), 0u, LeftTriangle(0u, 0u), 0.0, false, vec3(0.0), false, vec3(0.0), false, 0.0, 0u, 0u), vec3(0.0), vec3(0.0), false, 0u, vec3(0.0), 0.0, vec3(0.0), Odds(0.0, 0.0), Sampler(0u, 0u, 0u, 0u));
    Film film = Film(vec4(0.0), vec4(0.0));
    uvec2 texel = uvec2(fragment.xy);
    Path _e3 = noPath();
    p = _e3;
    uvec2 _e7 = frame.origin;
    uint _e11 = frame.sampleIndex;
    startPath(p, (_e7 + texel), _e11);
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

