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
    uint lightTreeDepth;
    uint lampTables;
};
struct Group {
    uint index;
    uint shift;
    uint seedA;
    uint seedB;
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
struct MeshRays {
    vec3 origin;
    vec3 direction;
    vec3 lightDirection;
    float least;
    float most;
    float lightMost;
};
struct MeshHit {
    float t;
    uint instance;
    uint triangle;
    vec2 weights;
    bool blocked;
};
struct SlabRay {
    vec3 inverse_;
    vec3 offset;
    uvec3 near;
};
struct MeshRay {
    vec3 origin;
    uint axis;
    vec3 shear;
};
struct Instance {
    vec4 toMeshX;
    vec4 toMeshY;
    vec4 toMeshZ;
    uint nodes;
    uint triangles;
    uint vertices;
    uint row;
    uint vertexRows;
    uint vertexFlags;
    uint spare0_;
    uint spare1_;
};
struct Triangle {
    vec3 a;
    uint vertexA;
    vec3 b;
    uint vertexB;
    vec3 c;
    uint vertexC;
};
struct TriangleHit {
    float t;
    vec2 weights;
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
    float spare0_;
};
struct Normals {
    vec3 geometric;
    vec3 shading;
};
struct MeshNormals {
    vec3 geometric;
    vec3 shading;
};
struct Vertex {
    uint normal;
    uint tangent;
    vec2 uv;
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
struct FarLight {
    vec3 radiance;
    float pdf;
};
struct EnvironmentLight {
    vec3 radiance;
    float pdf;
};
struct Corners {
    vec4 a;
    vec4 b;
    vec4 c;
    vec4 d;
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
struct LampTriangle {
    float own;
    uint place;
    uint other;
    float density;
};
struct TreeChoice {
    uint emitter;
    float probability;
    float share;
    bool taken;
};
struct LightNode {
    vec4 x;
    vec4 y;
    vec4 z;
    vec4 reach;
    vec4 axisX;
    vec4 axisY;
    vec4 axisZ;
    vec4 cosWidth;
    vec4 cosEdge;
    vec4 bothSides;
    vec4 power;
    vec4 emitters;
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
struct ChosenTriangle {
    uint place;
    float density;
    vec2 u;
};
struct EnvironmentSample {
    vec3 direction;
    EnvironmentLight light;
};
struct ChosenCell {
    uvec2 cell;
    vec2 rest;
};
struct Parts {
    uvec2 whole;
    vec2 rest;
};
struct Outgoing {
    vec3 wo;
    float share;
    float ratio;
    float bound;
    float stretched;
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
const uint noShape = 4294967295u;
const uint noInstance = 4294967295u;
const LeftTriangle noTriangle = LeftTriangle(4294967295u, 0u);
const uint beginning = 4294967294u;
const uint leafBit = 2147483648u;
const uint nodeRows = 7u;
const uint childrenRow = 6u;
const uint leastToGreatest = 3u;
const uint leaving = 4294967295u;
const uint placeMask = 268435455u;
const uint instanceRows = 5u;
const uint triangleRows = 3u;
const uint countShift = 28u;
const uint dielectric = 3u;
const uint hasNormals = 1u;
const EnvironmentLight white = EnvironmentLight(vec3(1.0), 0.07957747);
const uint conductor = 2u;
const uint metallicRoughness = 1u;
const uint diffuse0_ = 0u;
const uint rouletteDepth = 5u;

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

const bool hasMeshes = false;

uniform highp usampler2D geometry;

uint stack[64] = uint[64](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);

const bool hasGlass = false;

const bool hasMeshLamps = false;

const bool hasManyLights = true;

const bool hasSuns = false;

const bool hasSky = true;

const bool hasEnvironment = false;

uniform highp sampler2D environment;

const bool hasSphereLights = true;

const bool hasQuadLights = false;

const bool hasBoxLights = false;

const bool hasPointLights = false;

const bool hasLightTree = false;

const bool hasConductors = false;

const bool hasMetallicRoughness = false;

const bool hasCompensation = false;

const bool hasMirrorLayers = true;

uniform highp sampler2D previousFilm;

uniform highp sampler2D previousSquares;

layout(location = 0) out vec4 _fs2p_location0;
layout(location = 1) out vec4 _fs2p_location1;

uint pcg(uint x) {
    uint s_17 = ((x * 747796405u) + 2891336453u);
    uint w_2 = (((s_17 >> ((s_17 >> 28u) + 4u)) ^ s_17) * 277803737u);
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
    uint y_8 = ((x_1 | (x_1 << 2u)) & 51u);
    return ((y_8 | (y_8 << 1u)) & 85u);
}

uint reverseHalves(uint x_2) {
    uint y = 0u;
    y = (((x_2 >> 1u) & 1431655765u) | ((x_2 & 1431655765u) << 1u));
    uint _e11 = y;
    uint _e16 = y;
    y = (((_e11 >> 2u) & 858993459u) | ((_e16 & 858993459u) << 2u));
    uint _e22 = y;
    uint _e27 = y;
    y = (((_e22 >> 4u) & 252645135u) | ((_e27 & 252645135u) << 4u));
    uint _e33 = y;
    uint _e38 = y;
    return (((_e33 >> 8u) & 16711935u) | ((_e38 & 16711935u) << 8u));
}

uint mixBits(uint x_3) {
    uint y_1 = 0u;
    y_1 = ((x_3 ^ (x_3 >> 16u)) * 569420461u);
    uint _e7 = y_1;
    uint _e8 = y_1;
    y_1 = ((_e7 ^ (_e8 >> 15u)) * 1935289751u);
    uint _e14 = y_1;
    uint _e15 = y_1;
    return (_e14 ^ (_e15 >> 15u));
}

Sampler startSampler(uvec2 pixel_1, uint sampleIndex_1, uint seed_1) {
    uint _e5 = frame.independent;
    bool independent = (_e5 != 0u);
    uint _e15 = pixelHash(pick(independent, pixel_1, (pixel_1 >> uvec2(4u))), pick(independent, sampleIndex_1, (sampleIndex_1 >> 16u)), seed_1);
    uint _e19 = spread0_((pixel_1.x & 15u));
    uint _e23 = spread0_((pixel_1.y & 15u));
    uint place_3 = (_e19 | (_e23 << 1u));
    uint _e32 = reverseHalves(((sampleIndex_1 & 65535u) | (place_3 << 24u)));
    uint used = pick(independent, 0u, _e32);
    uint _e37 = mixBits((_e15 ^ 1779033703u));
    return Sampler(_e15, _e37, (used & 65535u), (used >> 16u));
}

float filterAxis(float u) {
    float across = ((2.0 * u) - 1.0);
    float x_14 = (16.0 - (16.0 * sqrt((1.0 - abs(across)))));
    float piece = min(floor(x_14), 15.0);
    float t_5 = (x_14 - piece);
    vec4 c = frame.filterPieces[uint(piece)];
    float offset_3 = (c.x + (t_5 * (c.y + (t_5 * (c.z + (t_5 * c.w))))));
    return pick((across < 0.0), -(offset_3), offset_3);
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

uint scramble(uint x_4, uint seed_2) {
    uint y_2 = 0u;
    y_2 = (x_4 ^ (x_4 * 1025551850u));
    uint _e6 = y_2;
    y_2 = ((_e6 + seed_2) * ((seed_2 >> 16u) | 1u));
    uint _e13 = y_2;
    uint _e14 = y_2;
    y_2 = (_e13 ^ (_e14 * 89287766u));
    uint _e18 = y_2;
    uint _e19 = y_2;
    return (_e18 ^ (_e19 * 1403136100u));
}

uint pascal(uint x_5) {
    uint y_3 = 0u;
    y_3 = (x_5 ^ ((x_5 >> 1u) & 21845u));
    uint _e7 = y_3;
    uint _e8 = y_3;
    y_3 = (_e7 ^ ((_e8 >> 2u) & 13107u));
    uint _e14 = y_3;
    uint _e15 = y_3;
    y_3 = (_e14 ^ ((_e15 >> 4u) & 3855u));
    uint _e21 = y_3;
    uint _e22 = y_3;
    return (_e21 ^ ((_e22 >> 8u) & 255u));
}

uint timesW(uint x_6) {
    return (((x_6 ^ (x_6 << 1u)) & 43690u) | ((x_6 >> 1u) & 21845u));
}

float toUnit(uint reversed, uint scrambled) {
    return (float(int(((reversed << 8u) | (scrambled >> 24u)))) * 5.9604645e-8);
}

vec2 points2d(Group g) {
    uint _e5 = scramble((g.index ^ g.shift), g.seedA);
    uint _e8 = timesW(g.shift);
    uint _e10 = pascal((g.index ^ _e8));
    uint _e12 = scramble(_e10, g.seedB);
    uint _e18 = reverseHalves(((_e5 & 65535u) | (_e12 << 16u)));
    float _e21 = toUnit((_e18 & 65535u), _e5);
    float _e24 = toUnit((_e18 >> 16u), _e12);
    return vec2(_e21, _e24);
}

uint timesW2_(uint x_7) {
    return (((x_7 << 1u) & 43690u) | ((x_7 ^ (x_7 >> 1u)) & 21845u));
}

uint shiftOfPlace(uint x_8) {
    uint y_4 = 0u;
    uint _e5 = timesW(((x_8 >> 2u) & 51u));
    y_4 = (x_8 ^ _e5);
    uint _e8 = y_4;
    uint _e9 = y_4;
    uint _e14 = timesW2_(((_e9 >> 4u) & 15u));
    y_4 = (_e8 ^ _e14);
    uint _e16 = y_4;
    uint _e17 = timesW(_e16);
    uint _e18 = y_4;
    return (_e17 | (_e18 << 8u));
}

Group nextGroup(inout Sampler s) {
    uint _e3 = s.key;
    s.key = (_e3 + 1u);
    uint _e7 = s.key;
    uint _e8 = mixBits(_e7);
    uint _e10 = s.salt;
    uint half_ = ((_e8 ^ _e10) * 2654435761u);
    uint b_5 = (half_ ^ (half_ >> 16u));
    uint _e18 = s.place;
    uint _e19 = scramble(_e18, b_5);
    uint _e21 = s.sample_;
    uint own_1 = (_e21 * ((_e19 >> 7u) & 4294967294u));
    uint _e28 = s.sample_;
    uint _e30 = scramble((_e28 ^ own_1), _e8);
    uint _e33 = reverseHalves((_e30 & 65535u));
    uint _e36 = shiftOfPlace((_e19 & 255u));
    return Group(_e33, _e36, ((_e8 >> 16u) | (_e8 << 16u)), ((b_5 >> 16u) | (b_5 << 16u)));
}

vec2 next2d(inout Sampler s_1) {
    Group _e1 = nextGroup(s_1);
    vec2 _e2 = points2d(_e1);
    return _e2;
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
    float x_15 = (((2.0 * filmPosition.x) / _e7) - 1.0);
    float _e16 = frame.height;
    float y_9 = (1.0 - ((2.0 * filmPosition.y) / _e16));
    vec3 _e22 = frame.right;
    vec3 _e26 = frame.up;
    vec3 across_1 = ((x_15 * _e22) + (y_9 * _e26));
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
    uint _e77 = frame.projection;
    if (pick(_e74, (_e77 == 2u), false)) {
        float longitude = (3.1415927 * x_15);
        float latitude = (1.5707964 * y_9);
        vec3 _e88 = frame.right;
        vec3 _e93 = frame.forward;
        vec3 level_1 = ((sin(longitude) * _e88) + (cos(longitude) * _e93));
        vec3 _e103 = frame.up;
        ray = CameraRay(vec3(0.0), normalize(((cos(latitude) * level_1) + (sin(latitude) * _e103))));
    }
    CameraRay _e108 = ray;
    return _e108;
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

void skipGroup(inout Sampler s_2) {
    uint _e3 = s_2.key;
    s_2.key = (_e3 + 1u);
    return;
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

RayPair oneRay(vec3 origin, vec3 direction) {
    return RayPair(origin, noShape, noTriangle, 0.0, true, direction, false, direction, false, -1.0, noShape);
}

Path startPath(uvec2 pixel_2, uint sampleIndex_2) {
    Sampler s_4 = Sampler(0u, 0u, 0u, 0u);
    uint _e4 = frame.seed;
    Sampler _e5 = startSampler(pixel_2, sampleIndex_2, _e4);
    s_4 = _e5;
    vec2 _e11 = next2d(s_4);
    vec2 _e12 = filterOffset(_e11);
    vec2 filmPosition_2 = ((vec2(pixel_2) + vec2(0.5)) + _e12);
    vec2 _e14 = lensPoint_2(s_4);
    CameraRay _e15 = cameraRay(filmPosition_2, _e14);
    RayPair _e18 = oneRay(_e15.origin, _e15.direction);
    Sampler _e32 = s_4;
    return Path(_e18, vec3(0.0), true, vec3(1.0), 1u, vec3(0.0), 0.0, vec3(0.0), Odds(1.0, 0.0), _e32);
}

Bounds fetchBounds(uint i) {
    vec4 t0_ = texelFetch(sceneTable, ivec2(uvec2(0u, i)), 0);
    return Bounds(t0_.xyz, t0_.w);
}

float intersectSphere(vec3 origin_1, vec3 direction_1, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter = (center - origin_1);
    float along = dot(toCenter, direction_1);
    vec3 across_2 = (toCenter - (along * direction_1));
    float discriminant = ((radius * radius) - dot(across_2, across_2));
    float half_1 = sqrt(max(discriminant, 0.0));
    float near = (along - half_1);
    float far_3 = (along + half_1);
    float t_6 = pick((near > tMin), near, far_3);
    return pick(startsInside, max(far_3, 0.0), pick(pick((discriminant >= 0.0), (t_6 > tMin), false), t_6, 1e30));
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
    vec4 t0_1 = texelFetch(sceneTable, ivec2(uvec2(1u, i_3)), 0);
    vec4 t1_ = texelFetch(sceneTable, ivec2(uvec2(2u, i_3)), 0);
    return Extent(t0_1.xyzw, t1_.xyzw);
}

vec3 rotate(vec4 q, vec3 v) {
    vec3 t_7 = (2.0 * cross(q.xyz, v));
    return ((v + (q.w * t_7)) + cross(q.xyz, t_7));
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
    float t_8 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_8 > tMin_1), false), t_8, 1e30));
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
    vec3 normal_10 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_4, normal_10);
    vec3 toCenter_1 = (center_1 - origin_5);
    float t_9 = (dot(toCenter_1, normal_10) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_15 = ((t_9 * direction_4) - toCenter_1);
    bool within = (max(abs(dot(p_15, reciprocalU)), abs(dot(p_15, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_9 > tMin_2), (t_9 < 1e30), false), within, false), t_9, 1e30);
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
    float t_10 = ((offset_1 - dot(origin_6, normal)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset_1 > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_10 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset_1 == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_10, 0.0), 1e30);
}

PairHit meetPlane(PairHit found_4, RayPair p_5, uint i_6) {
    Bounds _e3 = fetchBounds(i_6);
    float _e9 = intersectPlane(p_5.point, p_5.direction, _e3.center, _e3.radius, p_5.tMin);
    float _e15 = intersectPlane(p_5.point, p_5.lightDirection, _e3.center, _e3.radius, p_5.tMin);
    PairHit _e17 = meet(found_4, p_5, i_6, vec2(_e9, _e15));
    return _e17;
}

uvec4 geometryRow(uint i_7) {
    uvec4 _e8 = texelFetch(geometry, ivec2(uvec2((i_7 & 2047u), (i_7 >> 11u))), 0);
    return _e8;
}

vec4 planes(uint row, float inverse_, float offset_2) {
    uvec4 _e3 = geometryRow(row);
    return ((uintBitsToFloat(_e3) * inverse_) + vec4(offset_2));
}

vec4 enterChildren(uint node, SlabRay r, uvec4 children, float t_1) {
    uvec3 far_4 = (uvec3(3u, 5u, 7u) - r.near);
    vec4 _e17 = planes((node + r.near.x), r.inverse_.x, r.offset.x);
    vec4 _e25 = planes((node + r.near.y), r.inverse_.y, r.offset.y);
    vec4 _e34 = planes((node + r.near.z), r.inverse_.z, r.offset.z);
    vec4 near4_ = max(max(_e17, _e25), max(_e34, vec4(0.0)));
    vec4 _e45 = planes((node + far_4.x), r.inverse_.x, r.offset.x);
    vec4 _e52 = planes((node + far_4.y), r.inverse_.y, r.offset.y);
    vec4 _e60 = planes((node + far_4.z), r.inverse_.z, r.offset.z);
    vec4 far4_ = min(min(_e45, _e52), _e60);
    vec4 entered = mix(vec4(1e30), near4_, lessThanEqual(near4_, min((far4_ * 1.000001), vec4(t_1))));
    return mix(vec4(1e30), entered, notEqual(children, uvec4(0u)));
}

Instance fetchInstance(uint row_1) {
    uvec4 _e3 = geometryRow((row_1 + 0u));
    uvec4 _e6 = geometryRow((row_1 + 1u));
    uvec4 _e9 = geometryRow((row_1 + 2u));
    uvec4 _e12 = geometryRow((row_1 + 3u));
    uvec4 _e15 = geometryRow((row_1 + 4u));
    return Instance(uintBitsToFloat(_e3.xyzw), uintBitsToFloat(_e6.xyzw), uintBitsToFloat(_e9.xyzw), _e12.x, _e12.y, _e12.z, _e12.w, _e15.x, _e15.y, _e15.z, _e15.w);
}

SlabRay slabRay(vec3 origin_7, vec3 direction_6) {
    vec3 inverse_1 = (vec3(1.0) / mix(direction_6, vec3(1e-18), lessThan(abs(direction_6), vec3(1e-18))));
    return SlabRay(inverse_1, (-(origin_7) * inverse_1), (uvec3(0u, 1u, 2u) + (leastToGreatest * uvec3(lessThan(direction_6, vec3(0.0))))));
}

vec3 turnedTo(uint axis, vec3 v_2) {
    return pick((axis == 0u), v_2.yzx, pick((axis == 1u), v_2.zxy, v_2));
}

MeshRay meshRay(vec3 origin_8, vec3 direction_7) {
    vec3 size = abs(direction_7);
    uint axis_3 = pick((size.z >= max(size.x, size.y)), 2u, pick((size.y > size.x), 1u, 0u));
    vec3 _e16 = turnedTo(axis_3, direction_7);
    return MeshRay(origin_8, axis_3, vec3((-(_e16.xy) / vec2(_e16.z)), (1.0 / _e16.z)));
}

float edge(vec2 a, vec2 b) {
    float p_16 = (a.x * b.y);
    float q_6 = (a.y * b.x);
    return ((a.x * b.y + -(q_6)) - (a.y * b.x + -(p_16)));
}

TriangleHit intersectTriangle(MeshRay ray_1, Triangle triangle) {
    vec3 _e6 = turnedTo(ray_1.axis, (triangle.a - ray_1.origin));
    vec3 _e11 = turnedTo(ray_1.axis, (triangle.b - ray_1.origin));
    vec3 _e16 = turnedTo(ray_1.axis, (triangle.c - ray_1.origin));
    vec2 pa = (_e6.xy + (_e6.z * ray_1.shear.xy));
    vec2 pb = (_e11.xy + (_e11.z * ray_1.shear.xy));
    vec2 pc = (_e16.xy + (_e16.z * ray_1.shear.xy));
    float _e35 = edge(pc, pb);
    float _e36 = edge(pa, pc);
    float _e37 = edge(pb, pa);
    float sum = ((_e35 + _e36) + _e37);
    bool within_1 = pick((min(min(_e35, _e36), _e37) >= 0.0), true, (max(max(_e35, _e36), _e37) <= 0.0));
    float inverse_2 = (1.0 / pick((sum == 0.0), 1.0, sum));
    float t_11 = ((ray_1.shear.z * (((_e35 * _e6.z) + (_e36 * _e11.z)) + (_e37 * _e16.z))) * inverse_2);
    return TriangleHit(pick(pick(within_1, (sum != 0.0), false), t_11, -1.0), (vec2(_e36, _e37) * inverse_2));
}

Triangle fetchTriangle(uint row_2) {
    uvec4 _e3 = geometryRow((row_2 + 0u));
    uvec4 _e6 = geometryRow((row_2 + 1u));
    uvec4 _e9 = geometryRow((row_2 + 2u));
    return Triangle(uintBitsToFloat(_e3.xyz), _e3.w, uintBitsToFloat(_e6.xyz), _e6.w, uintBitsToFloat(_e9.xyz), _e9.w);
}

MeshHit traverse(MeshRays rays, LeftTriangle left) {
    MeshHit found_5 = MeshHit(0.0, 0u, 0u, vec2(0.0), false);
    bool toLight = false;
    float most = 0.0;
    uint instance = noInstance;
    uint nodes = 0u;
    uint triangles = 0u;
    SlabRay slabs = SlabRay(vec3(0.0), vec3(0.0), uvec3(0u));
    MeshRay ray_2 = MeshRay(vec3(0.0), 0u, vec3(0.0));
    uint top = 0u;
    uint current = 0u;
    bool pops = false;
    vec3 o = vec3(0.0);
    vec3 d_1 = vec3(0.0);
    found_5 = MeshHit(rays.most, noInstance, 0u, vec2(0.0), false);
    toLight = !((rays.most > 0.0));
    bool _e17 = toLight;
    most = pick(_e17, rays.lightMost, rays.most);
    uint _e45 = frame.instanceCount;
    bool alone = (_e45 == 1u);
    uint first = pick(alone, leafBit, beginning);
    current = first;
    uint _e54 = frame.instanceCount;
    float _e57 = most;
    if (pick((_e54 == 0u), true, !((_e57 > 0.0)))) {
        MeshHit _e62 = found_5;
        return _e62;
    }
    while(true) {
        pops = false;
        uint _e65 = current;
        if (((_e65 & leafBit) == 0u)) {
            uint _e70 = nodes;
            uint _e71 = current;
            uint node_2 = (_e70 + (_e71 * nodeRows));
            uvec4 _e77 = geometryRow((node_2 + childrenRow));
            SlabRay _e78 = slabs;
            float _e79 = most;
            vec4 _e80 = enterChildren(node_2, _e78, _e77, _e79);
            bool a_2 = (_e80.x < _e80.z);
            bool b_6 = (_e80.y < _e80.w);
            vec2 t0_2 = pick(a_2, vec2(_e80.z, _e80.x), vec2(_e80.x, _e80.z));
            uvec2 r0_ = pick(a_2, uvec2(_e77.z, _e77.x), uvec2(_e77.x, _e77.z));
            vec2 t1_1 = pick(b_6, vec2(_e80.w, _e80.y), vec2(_e80.y, _e80.w));
            uvec2 r1_ = pick(b_6, uvec2(_e77.w, _e77.y), uvec2(_e77.y, _e77.w));
            bool c_1 = (t0_2.x < t1_1.x);
            bool d_2 = (t0_2.y < t1_1.y);
            vec2 ta = pick(c_1, vec2(t1_1.x, t0_2.x), vec2(t0_2.x, t1_1.x));
            uvec2 ra = pick(c_1, uvec2(r1_.x, r0_.x), uvec2(r0_.x, r1_.x));
            vec2 tb = pick(d_2, vec2(t1_1.y, t0_2.y), vec2(t0_2.y, t1_1.y));
            uvec2 rb = pick(d_2, uvec2(r1_.y, r0_.y), uvec2(r0_.y, r1_.y));
            bool e_25 = (ta.y < tb.x);
            vec2 tm = pick(e_25, vec2(tb.x, ta.y), vec2(ta.y, tb.x));
            uvec2 rm = pick(e_25, uvec2(rb.x, ra.y), uvec2(ra.y, rb.x));
            if ((ta.x < 1e30)) {
                uint _e170 = top;
                stack[_e170] = ra.x;
                uint _e174 = top;
                top = (_e174 + 1u);
            }
            if ((tm.x < 1e30)) {
                uint _e180 = top;
                stack[_e180] = rm.x;
                uint _e184 = top;
                top = (_e184 + 1u);
            }
            if ((tm.y < 1e30)) {
                uint _e190 = top;
                stack[_e190] = rm.y;
                uint _e194 = top;
                top = (_e194 + 1u);
            }
            pops = (tb.y >= 1e30);
            current = rb.y;
        } else {
            uint _e200 = instance;
            uint _e203 = current;
            if (pick((_e200 == noInstance), true, (_e203 >= beginning))) {
                uint _e207 = current;
                bool toWorld_1 = (_e207 >= beginning);
                uint _e210 = current;
                pops = (_e210 == leaving);
                uint _e213 = current;
                instance = pick(toWorld_1, noInstance, (_e213 & placeMask));
                o = rays.origin;
                bool _e222 = toLight;
                d_1 = pick(_e222, rays.lightDirection, rays.direction);
                nodes = 0u;
                if (!(toWorld_1)) {
                    uint _e229 = frame.instances;
                    uint _e230 = instance;
                    Instance _e234 = fetchInstance((_e229 + (_e230 * instanceRows)));
                    vec3 _e235 = o;
                    vec4 p_17 = vec4(_e235, 1.0);
                    o = vec3(dot(_e234.toMeshX, p_17), dot(_e234.toMeshY, p_17), dot(_e234.toMeshZ, p_17));
                    vec3 _e247 = d_1;
                    vec3 _e251 = d_1;
                    vec3 _e255 = d_1;
                    d_1 = vec3(dot(_e234.toMeshX.xyz, _e247), dot(_e234.toMeshY.xyz, _e251), dot(_e234.toMeshZ.xyz, _e255));
                    nodes = _e234.nodes;
                    triangles = _e234.triangles;
                    if (!(alone)) {
                        uint _e262 = top;
                        stack[_e262] = leaving;
                        uint _e266 = top;
                        top = (_e266 + 1u);
                    }
                }
                current = 0u;
                vec3 _e269 = o;
                vec3 _e270 = d_1;
                SlabRay _e271 = slabRay(_e269, _e270);
                slabs = _e271;
                vec3 _e272 = o;
                vec3 _e273 = d_1;
                MeshRay _e274 = meshRay(_e272, _e273);
                ray_2 = _e274;
            } else {
                uint _e275 = current;
                uint place_4 = (_e275 & placeMask);
                MeshRay _e278 = ray_2;
                uint _e279 = triangles;
                Triangle _e283 = fetchTriangle((_e279 + (place_4 * triangleRows)));
                TriangleHit _e284 = intersectTriangle(_e278, _e283);
                uint _e285 = instance;
                bool own_5 = pick((_e285 == left.instance), (place_4 == left.triangle), false);
                float _e295 = most;
                bool nearer_1 = pick(pick((_e284.t > rays.least), (_e284.t < _e295), false), !(own_5), false);
                uint _e300 = current;
                current = ((_e300 + 1u) - 268435456u);
                uint _e305 = current;
                pops = (((_e305 >> countShift) & 7u) == 0u);
                if (nearer_1) {
                    bool _e312 = toLight;
                    if (_e312) {
                        found_5.blocked = true;
                        break;
                    }
                    most = _e284.t;
                    uint _e317 = instance;
                    found_5 = MeshHit(_e284.t, _e317, place_4, _e284.weights, false);
                }
            }
        }
        bool _e321 = pops;
        if (_e321) {
            uint _e322 = top;
            if ((_e322 > 0u)) {
                uint _e326 = top;
                top = (_e326 - 1u);
                uint _e329 = top;
                uint _e331 = stack[_e329];
                current = _e331;
            } else {
                bool _e332 = toLight;
                if (pick(_e332, true, !((rays.lightMost > 0.0)))) {
                    break;
                }
                toLight = true;
                most = rays.lightMost;
                instance = noInstance;
                current = first;
            }
        }
    }
    MeshHit _e341 = found_5;
    return _e341;
}

uint rowOfInstance(uint instance_1) {
    uint _e3 = frame.instances;
    Instance _e7 = fetchInstance((_e3 + (instance_1 * instanceRows)));
    return _e7.row;
}

PairHit meetMeshes(PairHit found_6, RayPair p_6) {
    PairHit result = PairHit(0.0, 0u, false, LeftTriangle(0u, 0u), vec2(0.0));
    float most_1 = pick(p_6.goesOn, found_6.t, -1.0);
    float lightMost = pick(found_6.blocked, -1.0, p_6.lightDistance);
    MeshHit _e16 = traverse(MeshRays(p_6.point, p_6.direction, p_6.lightDirection, p_6.tMin, most_1, lightMost), p_6.left);
    result = PairHit(found_6.t, found_6.shape, pick(found_6.blocked, true, _e16.blocked), noTriangle, _e16.weights);
    if ((_e16.instance != noInstance)) {
        result.t = _e16.t;
        uint _e33 = rowOfInstance(_e16.instance);
        result.shape = _e33;
        result.triangle = LeftTriangle(_e16.instance, _e16.triangle);
    }
    PairHit _e38 = result;
    return _e38;
}

PairHit tracePair(RayPair p_7) {
    PairHit found_7 = PairHit(1e30, 4294967295u, false, LeftTriangle(4294967295u, 0u), vec2(0.0));
    uint i_8 = 0u;
    uvec4 ends = frame.shapeEnds;
    const bool _e17 = hasSpheres;
    uint _e18 = i_8;
    if (pick(_e17, (_e18 < ends.x), false)) {
        while(true) {
            PairHit _e22 = found_7;
            uint _e23 = i_8;
            PairHit _e24 = meetSphere(_e22, p_7, _e23);
            found_7 = _e24;
            uint _e26 = i_8;
            i_8 = (_e26 + 1u);
            uint _e28 = i_8;
            if ((_e28 >= ends.x)) {
                break;
            }
        }
    }
    const bool _e32 = hasBoxes;
    uint _e33 = i_8;
    if (pick(_e32, (_e33 < ends.y), false)) {
        while(true) {
            PairHit _e37 = found_7;
            uint _e38 = i_8;
            PairHit _e39 = meetBox(_e37, p_7, _e38);
            found_7 = _e39;
            uint _e41 = i_8;
            i_8 = (_e41 + 1u);
            uint _e43 = i_8;
            if ((_e43 >= ends.y)) {
                break;
            }
        }
    }
    const bool _e47 = hasQuads;
    uint _e48 = i_8;
    if (pick(_e47, (_e48 < ends.z), false)) {
        while(true) {
            PairHit _e52 = found_7;
            uint _e53 = i_8;
            PairHit _e54 = meetQuad(_e52, p_7, _e53);
            found_7 = _e54;
            uint _e56 = i_8;
            i_8 = (_e56 + 1u);
            uint _e58 = i_8;
            if ((_e58 >= ends.z)) {
                break;
            }
        }
    }
    const bool _e62 = hasPlanes;
    uint _e63 = i_8;
    if (pick(_e62, (_e63 < ends.w), false)) {
        while(true) {
            PairHit _e67 = found_7;
            uint _e68 = i_8;
            PairHit _e69 = meetPlane(_e67, p_7, _e68);
            found_7 = _e69;
            uint _e71 = i_8;
            i_8 = (_e71 + 1u);
            uint _e73 = i_8;
            if ((_e73 >= ends.w)) {
                break;
            }
        }
    }
    const bool _e77 = hasMeshes;
    if (_e77) {
        PairHit _e78 = found_7;
        PairHit _e79 = meetMeshes(_e78, p_7);
        found_7 = _e79;
    }
    PairHit _e80 = found_7;
    return _e80;
}

Surface fetchSurface(uint i_9) {
    vec4 t0_3 = texelFetch(sceneTable, ivec2(uvec2(9u, i_9)), 0);
    vec4 t1_2 = texelFetch(sceneTable, ivec2(uvec2(10u, i_9)), 0);
    vec4 t2_ = texelFetch(sceneTable, ivec2(uvec2(11u, i_9)), 0);
    vec4 t3_ = texelFetch(sceneTable, ivec2(uvec2(12u, i_9)), 0);
    vec4 t4_ = texelFetch(sceneTable, ivec2(uvec2(13u, i_9)), 0);
    return Surface(t0_3.xyz, t0_3.w, t1_2.xyz, t1_2.w, t2_.xyz, t2_.w, t3_.xyz, t3_.w, t4_.xyz, t4_.w);
}

uint kindOf(uint code) {
    return (code & 3u);
}

bool isDielectric(uint code_1) {
    const bool _e2 = hasGlass;
    uint _e3 = kindOf(code_1);
    return pick(_e2, (_e3 == dielectric), false);
}

bool isPlane(uint i_10) {
    uint _e4 = frame.shapeEnds.z;
    uint _e9 = frame.shapeEnds.w;
    return pick((i_10 >= _e4), (i_10 < _e9), false);
}

vec3 boxNormal(vec3 origin_9, vec3 direction_8, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_9, direction_8, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_12 = pick(entering, _e5.near, _e5.far);
    vec3 side = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_8, vec3(0.0))));
    bool onX = (crossed.x == t_12);
    bool onY = pick(!(onX), (crossed.y == t_12), false);
    return (side * mix(vec3(0.0), vec3(1.0), bvec3(onX, onY, !(pick(onX, true, onY)))));
}

vec3 turnedBack(vec4 q_2, vec3 v_3) {
    vec3 _e6 = turned(vec4(-(q_2.xyz), q_2.w), v_3);
    return _e6;
}

bool isBox(uint i_11) {
    uint _e4 = frame.shapeEnds.x;
    uint _e9 = frame.shapeEnds.y;
    return pick((i_11 >= _e4), (i_11 < _e9), false);
}

bool isSphere(uint i_12) {
    uint _e4 = frame.shapeEnds.x;
    return (i_12 < _e4);
}

vec3 normalAt(RayPair p_8, float t_2, uint i_13) {
    vec3 normal_1 = vec3(0.0);
    Bounds _e3 = fetchBounds(i_13);
    vec3 origin_10 = (p_8.point - _e3.center);
    normal_1 = _e3.center;
    const bool _e10 = hasQuads;
    if (_e10) {
        Extent _e11 = fetchExtent(i_13);
        vec3 _e17 = normal_1;
        bool _e18 = isPlane(i_13);
        normal_1 = pick(_e18, _e17, cross(_e11.a.xyz, _e11.b.xyz));
    }
    const bool _e21 = hasBoxes;
    if (_e21) {
        Extent _e22 = fetchExtent(i_13);
        bool inside = pick((i_13 == p_8.shape), p_8.inwards, false);
        vec3 _e28 = turned(_e22.a, origin_10);
        vec3 _e31 = turned(_e22.a, p_8.direction);
        vec3 _e35 = boxNormal(_e28, _e31, _e22.b.xyz, p_8.tMin, inside);
        vec3 _e36 = normal_1;
        vec3 _e38 = turnedBack(_e22.a, _e35);
        bool _e39 = isBox(i_13);
        normal_1 = pick(_e39, _e38, _e36);
    }
    const bool _e42 = hasSpheres;
    if (_e42) {
        vec3 _e43 = normal_1;
        bool _e47 = isSphere(i_13);
        normal_1 = pick(_e47, (origin_10 + (t_2 * p_8.direction)), _e43);
    }
    vec3 _e49 = normal_1;
    return normalize(_e49);
}

vec3 fromOctahedral(uint code_2) {
    vec2 p_18 = ((vec2(float((code_2 & 65535u)), float((code_2 >> 16u))) * 3.051851e-5) - vec2(1.0));
    float z_1 = ((1.0 - abs(p_18.x)) - abs(p_18.y));
    vec2 folded = ((vec2(1.0) - abs(p_18.yx)) * mix(vec2(1.0), vec2(-1.0), lessThan(p_18, vec2(0.0))));
    return normalize(vec3(pick((z_1 < 0.0), folded, p_18), z_1));
}

Vertex fetchVertex(uint row_3) {
    uvec4 _e3 = geometryRow((row_3 + 0u));
    return Vertex(_e3.x, _e3.y, uintBitsToFloat(_e3.zw));
}

vec3 blendedNormal(Instance i_14, Triangle t_3, vec2 weights) {
    Vertex _e8 = fetchVertex((i_14.vertices + (t_3.vertexA * i_14.vertexRows)));
    vec3 _e10 = fromOctahedral(_e8.normal);
    Vertex _e16 = fetchVertex((i_14.vertices + (t_3.vertexB * i_14.vertexRows)));
    vec3 _e18 = fromOctahedral(_e16.normal);
    Vertex _e24 = fetchVertex((i_14.vertices + (t_3.vertexC * i_14.vertexRows)));
    vec3 _e26 = fromOctahedral(_e24.normal);
    return (((((1.0 - weights.x) - weights.y) * _e10) + (weights.x * _e18)) + (weights.y * _e26));
}

MeshNormals meshNormals(uint instance_2, uint place, vec2 weights_1) {
    vec3 shading = vec3(0.0);
    uint _e5 = frame.instances;
    Instance _e9 = fetchInstance((_e5 + (instance_2 * instanceRows)));
    Triangle _e14 = fetchTriangle((_e9.triangles + (place * triangleRows)));
    vec3 normal_11 = cross((_e14.b - _e14.a), (_e14.c - _e14.a));
    vec3 geometric = normalize((mat3x3(_e9.toMeshX.xyz, _e9.toMeshY.xyz, _e9.toMeshZ.xyz) * normal_11));
    shading = geometric;
    if (((_e9.vertexFlags & hasNormals) != 0u)) {
        vec3 _e44 = blendedNormal(_e9, _e14, weights_1);
        vec3 smoothed = (mat3x3(_e9.toMeshX.xyz, _e9.toMeshY.xyz, _e9.toMeshZ.xyz) * _e44);
        float size_1 = dot(smoothed, smoothed);
        float side_1 = pick((dot(smoothed, geometric) < 0.0), -1.0, 1.0);
        shading = pick((size_1 > 0.0), (smoothed * (side_1 * inversesqrt(max(size_1, 1e-37)))), geometric);
    }
    vec3 _e61 = shading;
    return MeshNormals(geometric, _e61);
}

Normals normalsAt(RayPair rays_1, PairHit hit, uint shape, bool isGlass) {
    Normals normals = Normals(vec3(0.0), vec3(0.0));
    vec3 _e5 = normalAt(rays_1, hit.t, shape);
    normals = Normals(_e5, _e5);
    const bool _e9 = hasMeshes;
    if (pick(_e9, (hit.triangle.instance != noInstance), false)) {
        MeshNormals _e20 = meshNormals(hit.triangle.instance, hit.triangle.triangle, hit.weights);
        bool agree = ((dot(_e20.geometric, rays_1.direction) > 0.0) == (dot(_e20.shading, rays_1.direction) > 0.0));
        normals = Normals(_e20.geometric, pick(pick(isGlass, !(agree), false), _e20.geometric, _e20.shading));
    }
    Normals _e39 = normals;
    return _e39;
}

Basis basisAbout(vec3 n) {
    float side_2 = pick((n.z >= 0.0), 1.0, -1.0);
    float a_3 = (-1.0 / (side_2 + n.z));
    float b_7 = ((n.x * n.y) * a_3);
    return Basis(vec3((1.0 + (((side_2 * n.x) * n.x) * a_3)), (side_2 * b_7), (-(side_2) * n.x)), vec3(b_7, (side_2 + ((n.y * n.y) * a_3)), -(n.y)), n);
}

vec3 toLocal(Basis b_1, vec3 v_4) {
    return vec3(dot(v_4, b_1.tangent), dot(v_4, b_1.bitangent), dot(v_4, b_1.normal));
}

bool isThin(uint code_3) {
    const bool _e2 = hasGlass;
    return pick(_e2, ((code_3 & 7u) == 7u), false);
}

Emitter fetchEmitter(uint i_15) {
    vec4 t0_4 = texelFetch(sceneTable, ivec2(uvec2(14u, i_15)), 0);
    vec4 t1_3 = texelFetch(sceneTable, ivec2(uvec2(15u, i_15)), 0);
    vec4 t2_1 = texelFetch(sceneTable, ivec2(uvec2(16u, i_15)), 0);
    vec4 t3_1 = texelFetch(sceneTable, ivec2(uvec2(17u, i_15)), 0);
    vec4 t4_1 = texelFetch(sceneTable, ivec2(uvec2(18u, i_15)), 0);
    vec4 t5_ = texelFetch(sceneTable, ivec2(uvec2(19u, i_15)), 0);
    return Emitter(t0_4.xyz, t0_4.w, t1_3.xyz, t1_3.w, t2_1.xyz, t2_1.w, t3_1.xyz, t3_1.w, t4_1.x, t4_1.y, t4_1.z, t4_1.w, t5_.x, t5_.y, t5_.z, t5_.w);
}

int emitterOf(float code_4) {
    return ((int(code_4) >> 6u) - 1);
}

uint emitterOfTriangle(Emitter e, LeftTriangle t_4) {
    return (((t_4.instance - uint(e.instance)) * uint(e.cosInner)) + (t_4.triangle >> uint(e.radius)));
}

Emitter emitterAt(uint i_16, Emitter only) {
    Emitter emitter = Emitter(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    emitter = only;
    const bool _e4 = hasManyLights;
    if (_e4) {
        Emitter _e5 = fetchEmitter(i_16);
        emitter = _e5;
    }
    Emitter _e6 = emitter;
    return _e6;
}

bool isOnDisc(Emitter e_1, vec3 direction_9) {
    vec3 chord = (direction_9 + e_1.u);
    return ((3.1415927 * dot(chord, chord)) < e_1.area);
}

float directionalPdf(Emitter e_2, vec3 direction_10) {
    bool _e7 = isOnDisc(e_2, direction_10);
    return pick(_e7, (1.0 / max(e_2.area, 1e-31)), 0.0);
}

vec2 quadrantAngles(vec2 x_9, vec2 y_5) {
    vec2 low = min(x_9, y_5);
    vec2 high = max(x_9, y_5);
    bvec2 middle_1 = greaterThan(low, (0.41421357 * high));
    vec2 r_1 = (mix(low, (low - high), middle_1) / max(mix(high, (low + high), middle_1), vec2(1e-30)));
    vec2 z_2 = (r_1 * r_1);
    vec2 series = ((((((0.080537446 * z_2) - vec2(0.13877685)) * z_2) + vec2(0.19977711)) * z_2) - vec2(0.3333295));
    vec2 angle_1 = (mix(vec2(0.0), vec2(0.7853982), middle_1) + (((series * z_2) * r_1) + r_1));
    return mix(angle_1, (vec2(1.5707964) - angle_1), greaterThan(y_5, x_9));
}

EnvironmentLight lightWithin(Corners k, vec2 at, float sine) {
    vec4 light_1 = mix(mix(k.a, k.b, at.x), mix(k.c, k.d, at.x), at.y);
    return EnvironmentLight(light_1.xyz, (max(light_1.w, 0.0) / sine));
}

Corners environmentCorners(uvec2 cell) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_2 = uvec2(_e3);
    uint left_1 = (pick((cell.x == 0u), size_2.x, cell.x) - 1u);
    uint right = pick((cell.x == size_2.x), 0u, cell.x);
    uint upper = (max(cell.y, 1u) - 1u);
    uint lower = min(cell.y, (size_2.y - 1u));
    vec4 above = vec4(1.0, 1.0, 1.0, pick((cell.y == 0u), -1.0, 1.0));
    vec4 below = vec4(1.0, 1.0, 1.0, pick((cell.y == size_2.y), -1.0, 1.0));
    vec4 _e52 = texelFetch(environment, ivec2(uvec2(left_1, upper)), 0);
    vec4 _e57 = texelFetch(environment, ivec2(uvec2(right, upper)), 0);
    vec4 _e62 = texelFetch(environment, ivec2(uvec2(left_1, lower)), 0);
    vec4 _e67 = texelFetch(environment, ivec2(uvec2(right, lower)), 0);
    return Corners((above * _e52), (above * _e57), (below * _e62), (below * _e67));
}

EnvironmentLight lookUpEnvironment(vec3 direction_11) {
    vec2 size_3 = frame.environmentSize;
    float sine_1 = max(length(direction_11.xz), 1e-9);
    vec2 _e15 = quadrantAngles(abs(vec2(direction_11.z, direction_11.y)), vec2(abs(direction_11.x), sine_1));
    float turn = (pick((direction_11.z > 0.0), (3.1415927 - _e15.x), _e15.x) * pick((direction_11.x < 0.0), -1.0, 1.0));
    float _e35 = frame.environmentTurn;
    float column = ((fract(((turn * 0.15915494) + _e35)) * size_3.x) + 0.5);
    float fromPole = ((_e15.y * (size_3.y / 3.1415927)) + 0.5);
    float row_5 = floor(fromPole);
    bool isLower = (direction_11.y < 0.0);
    vec2 cell_1 = vec2(floor(column), pick(isLower, (size_3.y - row_5), row_5));
    float within_2 = (fromPole - row_5);
    vec2 at_1 = vec2((column - cell_1.x), pick(isLower, (1.0 - within_2), within_2));
    Corners _e66 = environmentCorners(uvec2(cell_1));
    EnvironmentLight _e67 = lightWithin(_e66, at_1, sine_1);
    return _e67;
}

vec3 sky(vec3 direction_12) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_12.y, 0.0));
}

EnvironmentLight skyLight(vec3 direction_13) {
    EnvironmentLight light = white;
    const bool _e4 = hasEnvironment;
    if (_e4) {
        EnvironmentLight _e5 = lookUpEnvironment(direction_13);
        light = _e5;
    }
    vec3 _e7 = light.radiance;
    vec3 _e8 = sky(direction_13);
    float _e11 = light.pdf;
    return EnvironmentLight((_e7 * _e8), _e11);
}

FarLight farLight(Emitter e_3, vec3 direction_14) {
    FarLight far = FarLight(vec3(0.0), 0.0);
    const bool _e8 = hasSuns;
    if (_e8) {
        bool _e12 = isOnDisc(e_3, direction_14);
        bool seen = pick((e_3.kind == 5.0), _e12, false);
        float _e18 = directionalPdf(e_3, direction_14);
        far = FarLight(pick(seen, e_3.radiance, vec3(0.0)), pick(seen, _e18, 0.0));
    }
    const bool _e23 = hasSky;
    if (pick(_e23, (e_3.kind == 6.0), false)) {
        EnvironmentLight _e28 = skyLight(direction_14);
        far = FarLight(_e28.radiance, _e28.pdf);
    }
    FarLight _e32 = far;
    return _e32;
}

SphereView viewSphere(Emitter e_4, vec3 point) {
    vec3 toCenter_2 = (e_4.position - point);
    float d_3 = length(toCenter_2);
    float power = abs(((d_3 - e_4.radius) * (d_3 + e_4.radius)));
    bool inside_1 = (d_3 <= e_4.radius);
    float sine_2 = min((e_4.radius / max(d_3, 1e-30)), 1.0);
    float cosine_11 = (sqrt(power) / max(d_3, 1e-30));
    return SphereView(toCenter_2, d_3, power, inside_1, pick(inside_1, 2.0, ((sine_2 * sine_2) / (1.0 + cosine_11))));
}

float conePdf(float width) {
    return (1.0 / (6.2831855 * max(width, 1e-31)));
}

float spherePdf(Emitter e_5, vec3 point_1, vec3 direction_15) {
    SphereView _e3 = viewSphere(e_5, point_1);
    bool reached = pick(_e3.inside, true, (dot(direction_15, _e3.toCenter) > 0.0));
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

float arctangent(float x_10) {
    float a_4 = abs(x_10);
    bool steep = (a_4 > 2.4142137);
    bool middle_2 = pick((a_4 > 0.41421357), !(steep), false);
    float r_2 = pick(steep, (-1.0 / max(a_4, 1.0)), pick(middle_2, ((a_4 - 1.0) / (a_4 + 1.0)), a_4));
    float base_1 = pick(steep, 1.5707964, pick(middle_2, 0.7853982, 0.0));
    float z_3 = (r_2 * r_2);
    float series_1 = ((((((0.080537446 * z_3) - 0.13877685) * z_3) + 0.19977711) * z_3) - 0.3333295);
    return (sign(x_10) * (base_1 + (((series_1 * z_3) * r_2) + r_2)));
}

float stretch(float x_11, vec2 y_6, float h) {
    vec2 r_3 = sqrt(((vec2((x_11 * x_11)) + (y_6 * y_6)) + vec2((h * h))));
    float _e16 = arctangent(((x_11 * y_6.y) / (h * r_3.y)));
    float _e22 = arctangent(((x_11 * y_6.x) / (h * r_3.x)));
    return (_e16 - _e22);
}

QuadView viewQuad(Emitter e_6, vec3 point_2) {
    vec3 corner = (e_6.position - point_2);
    vec2 lengths = vec2(length(e_6.u), length(e_6.v));
    vec3 axisX = (e_6.u / vec3(lengths.x));
    vec3 axisY = (e_6.v / vec3(lengths.y));
    vec3 normal_12 = normalize(cross(axisX, axisY));
    float signedHeight = dot(corner, normal_12);
    float least = (1e-7 * (lengths.x + lengths.y));
    float height_1 = max(abs(signedHeight), least);
    bool lit = pick((abs(signedHeight) > least), pick((e_6.oneSided == 0.0), true, (signedHeight < 0.0)), false);
    vec2 low_1 = vec2(dot(corner, axisX), dot(corner, axisY));
    vec2 high_1 = (low_1 + lengths);
    vec2 y_10 = vec2(low_1.y, high_1.y);
    float _e44 = stretch(low_1.x, y_10, height_1);
    float _e46 = stretch(high_1.x, y_10, height_1);
    float solidAngle = (_e46 - _e44);
    bool rectangle = (abs(dot(axisX, axisY)) <= 1e-5);
    vec3 axisZ = (normal_12 * pick((signedHeight > 0.0), 1.0, -1.0));
    return QuadView(corner, axisX, axisY, axisZ, low_1, high_1, height_1, _e44, solidAngle, lit, pick(rectangle, (solidAngle > 0.01), false));
}

float quadPdf(Emitter e_7, vec3 point_3, float distance_2) {
    QuadView _e3 = viewQuad(e_7, point_3);
    float _e5 = pdfOfView(_e3, e_7.area, distance_2);
    return _e5;
}

BoxView viewBox(Emitter e_8, vec3 point_4) {
    Extent _e4 = fetchExtent(uint(e_8.shape));
    vec4 rotation = _e4.a;
    vec3 _e8 = rotate(rotation, (point_4 - e_8.position));
    bvec3 seen_1 = greaterThan(abs(_e8), e_8.u);
    vec3 faces = mix(vec3(0.0), ((4.0 * e_8.u.yzx) * e_8.u.zxy), seen_1);
    return BoxView(rotation, _e8, faces, ((faces.x + faces.y) + faces.z), !(any(seen_1)));
}

float boxPdf(Emitter e_9, vec3 point_5, vec3 direction_16, float distance_3, vec3 normal_2) {
    BoxView _e5 = viewBox(e_9, point_5);
    float _e10 = areaPdf(_e5.area, (distance_3 * abs(dot(direction_16, normal_2))), distance_3);
    float _e12 = conePdf(2.0);
    return pick(_e5.inside, _e12, _e10);
}

LampTriangle fetchLampTriangle(uint row_4) {
    uvec4 _e3 = geometryRow((row_4 + 0u));
    return LampTriangle(uintBitsToFloat(_e3.x), _e3.y, _e3.z, uintBitsToFloat(_e3.w));
}

float meshPdf(Emitter e_10, vec3 direction_17, float distance_4, vec3 normal_3, uint place_1) {
    uint _e7 = frame.lampTables;
    uint row_6 = ((_e7 + uint(e_10.table)) + (place_1 & ((1u << uint(e_10.radius)) - 1u)));
    LampTriangle _e20 = fetchLampTriangle(row_6);
    float _e26 = areaPdf((e_10.area / _e20.density), (distance_4 * abs(dot(direction_17, normal_3))), distance_4);
    return _e26;
}

float shapePdf(Emitter e_11, vec3 point_6, vec3 direction_18, float distance_5, vec3 normal_4, uint place_2) {
    float pdf = 0.0;
    const bool _e9 = hasSphereLights;
    if (pick(_e9, (e_11.kind == 0.0), false)) {
        float _e14 = spherePdf(e_11, point_6, direction_18);
        pdf = _e14;
    }
    const bool _e16 = hasQuadLights;
    if (pick(_e16, (e_11.kind == 1.0), false)) {
        float _e21 = quadPdf(e_11, point_6, distance_5);
        pdf = _e21;
    }
    const bool _e23 = hasBoxLights;
    if (pick(_e23, (e_11.kind == 2.0), false)) {
        float _e28 = boxPdf(e_11, point_6, direction_18, distance_5, normal_4);
        pdf = _e28;
    }
    const bool _e30 = hasMeshLamps;
    if (pick(_e30, (e_11.kind == 7.0), false)) {
        float _e35 = meshPdf(e_11, direction_18, distance_5, normal_4, place_2);
        pdf = _e35;
    }
    float _e36 = pdf;
    return _e36;
}

float spotFalloff(Emitter e_12, vec3 toLight_1) {
    float share = clamp(((-(dot(toLight_1, e_12.u)) - e_12.radius) / (e_12.cosInner - e_12.radius)), 0.0, 1.0);
    return (share * share);
}

float estimatedIrradiance(Emitter e_13, vec3 point_7, vec3 normal_5) {
    float estimate = 0.0;
    const bool _e4 = hasQuadLights;
    bool isQuad = pick(_e4, (e_13.kind == 1.0), false);
    const bool _e10 = hasSuns;
    bool isFar = pick(_e10, (e_13.kind == 5.0), false);
    vec3 middle_3 = (e_13.position + pick(isQuad, (0.5 * (e_13.u + e_13.v)), vec3(0.0)));
    vec3 toLight_2 = pick(isFar, -(e_13.u), (middle_3 - point_7));
    float distance2_ = dot(toLight_2, toLight_2);
    float distance_6 = sqrt(distance2_);
    float grown = max((distance_6 + e_13.reach), 1e-15);
    float above_1 = clamp(((dot(normal_5, toLight_2) + e_13.reach) / grown), 0.0, 1.0);
    float cosine_12 = pick((dot(normal_5, normal_5) == 0.0), 1.0, above_1);
    float square = pick(isQuad, (distance2_ + (e_13.area / 3.1415927)), max(distance2_, (e_13.area / 12.566371)));
    estimate = ((e_13.power * cosine_12) / pick(isFar, 1.0, max(square, 1e-15)));
    const bool _e65 = hasQuadLights;
    if (_e65) {
        float height_2 = (-(dot(cross(e_13.u, e_13.v), toLight_2)) / max(e_13.area, 1e-30));
        float side_3 = pick((e_13.oneSided == 1.0), max(height_2, 0.0), abs(height_2));
        float lampCosine = pick((side_3 > 0.0), ((side_3 + e_13.reach) / grown), 0.0);
        float _e89 = estimate;
        estimate = (_e89 * pick(isQuad, lampCosine, 1.0));
    }
    const bool _e94 = hasMeshLamps;
    if (_e94) {
        float alike = length(e_13.v);
        float across_3 = -(dot(e_13.v, toLight_2));
        float side_4 = pick((e_13.oneSided == 1.0), max(across_3, 0.0), abs(across_3));
        float shown = ((0.25 * (1.0 - alike)) + ((side_4 + (alike * e_13.reach)) / grown));
        float sizeOfMesh = (distance2_ + ((e_13.area * (1.0 + (3.0 * alike))) / 12.566371));
        float _e125 = estimate;
        estimate = pick((e_13.kind == 7.0), (((e_13.power * cosine_12) * shown) / max(sizeOfMesh, 1e-15)), _e125);
    }
    const bool _e137 = hasPointLights;
    if (_e137) {
        float _e138 = estimate;
        float _e143 = spotFalloff(e_13, (toLight_2 / vec3(max(distance_6, 1e-15))));
        estimate = (_e138 * pick((e_13.kind == 4.0), _e143, 1.0));
    }
    const bool _e151 = hasSky;
    if (_e151) {
        float _e152 = estimate;
        estimate = pick((e_13.kind == 6.0), e_13.power, _e152);
    }
    float _e158 = estimate;
    return _e158;
}

LightNode fetchLightNode(uint i_17) {
    vec4 t0_5 = texelFetch(sceneTable, ivec2(uvec2(0u, i_17)), 0);
    vec4 t1_4 = texelFetch(sceneTable, ivec2(uvec2(1u, i_17)), 0);
    vec4 t2_2 = texelFetch(sceneTable, ivec2(uvec2(2u, i_17)), 0);
    vec4 t3_2 = texelFetch(sceneTable, ivec2(uvec2(3u, i_17)), 0);
    vec4 t4_2 = texelFetch(sceneTable, ivec2(uvec2(4u, i_17)), 0);
    vec4 t5_1 = texelFetch(sceneTable, ivec2(uvec2(5u, i_17)), 0);
    vec4 t6_ = texelFetch(sceneTable, ivec2(uvec2(6u, i_17)), 0);
    vec4 t7_ = texelFetch(sceneTable, ivec2(uvec2(7u, i_17)), 0);
    vec4 t8_ = texelFetch(sceneTable, ivec2(uvec2(8u, i_17)), 0);
    vec4 t9_ = texelFetch(sceneTable, ivec2(uvec2(9u, i_17)), 0);
    vec4 t10_ = texelFetch(sceneTable, ivec2(uvec2(10u, i_17)), 0);
    vec4 t11_ = texelFetch(sceneTable, ivec2(uvec2(11u, i_17)), 0);
    return LightNode(t0_5.xyzw, t1_4.xyzw, t2_2.xyzw, t3_2.xyzw, t4_2.xyzw, t5_1.xyzw, t6_.xyzw, t7_.xyzw, t8_.xyzw, t9_.xyzw, t10_.xyzw, t11_.xyzw);
}

vec4 sineOf(vec4 cosine) {
    return sqrt(max((vec4(1.0) - (cosine * cosine)), vec4(0.0)));
}

vec4 cosineLess(vec4 cosA, vec4 sinA, vec4 cosB, vec4 sinB) {
    return mix(((cosA * cosB) + (sinA * sinB)), vec4(1.0), greaterThan(cosA, cosB));
}

vec4 estimatesOfChildren(LightNode n_1, vec3 point_8, vec3 normal_6) {
    vec4 x_16 = (n_1.x - vec4(point_8.x));
    vec4 y_11 = (n_1.y - vec4(point_8.y));
    vec4 z_4 = (n_1.z - vec4(point_8.z));
    vec4 distance2_1 = (((x_16 * x_16) + (y_11 * y_11)) + (z_4 * z_4));
    vec4 inverse_3 = inversesqrt(max(distance2_1, vec4(1e-30)));
    bvec4 inside_2 = lessThanEqual(distance2_1, (n_1.reach * n_1.reach));
    vec4 sinB_1 = min((n_1.reach * inverse_3), vec4(1.0));
    vec4 _e33 = sineOf(sinB_1);
    vec4 cosB_1 = mix(_e33, vec4(-1.0), inside_2);
    vec4 along_1 = (-((((n_1.axisX * x_16) + (n_1.axisY * y_11)) + (n_1.axisZ * z_4))) * inverse_3);
    vec4 cosW = clamp(mix(along_1, abs(along_1), greaterThan(n_1.bothSides, vec4(0.5))), vec4(-1.0), vec4(1.0));
    vec4 _e58 = sineOf(cosW);
    vec4 _e60 = sineOf(n_1.cosWidth);
    vec4 _e62 = cosineLess(cosW, _e58, n_1.cosWidth, _e60);
    vec4 _e63 = sineOf(_e62);
    vec4 _e64 = cosineLess(_e62, _e63, cosB_1, sinB_1);
    vec4 cosOut = mix(_e64, vec4(1.0), inside_2);
    vec4 cosN = clamp(((((normal_6.x * x_16) + (normal_6.y * y_11)) + (normal_6.z * z_4)) * inverse_3), vec4(-1.0), vec4(1.0));
    bvec4 bothSides = bvec4pickpickpickpick(bvec4((dot(normal_6, normal_6) == 0.0)).x, true, inside_2.x, bvec4((dot(normal_6, normal_6) == 0.0)).y, true, inside_2.y, bvec4((dot(normal_6, normal_6) == 0.0)).z, true, inside_2.z, bvec4((dot(normal_6, normal_6) == 0.0)).w, true, inside_2.w);
    vec4 _e87 = sineOf(cosN);
    vec4 _e88 = cosineLess(cosN, _e87, cosB_1, sinB_1);
    vec4 cosIn = mix(max(_e88, vec4(0.0)), vec4(1.0), bothSides);
    vec4 estimate_1 = (((n_1.power * cosOut) * cosIn) / max(max(distance2_1, (n_1.reach * n_1.reach)), vec4(1e-15)));
    return mix(vec4(0.0), min(estimate_1, vec4(1e30)), greaterThan(cosOut, n_1.cosEdge));
}

float shareOfTree(float total, float far_1) {
    float share_1 = (0.25 + ((0.5 * total) / max((total + far_1), 1e-37)));
    return pick((total <= 0.0), 0.0, pick((far_1 <= 0.0), 1.0, share_1));
}

TreeChoice descend(vec3 point_9, vec3 normal_7, float u_4, int leaf, float far_2) {
    uint level = 0u;
    uint node_1 = 0u;
    float rest = 0.0;
    TreeChoice choice = TreeChoice(0u, 1.0, 0.0, true);
    uint _e7 = frame.lightTreeDepth;
    level = _e7;
    rest = u_4;
    while(true) {
        uint _e19 = level;
        level = (_e19 - 1u);
        uint _e23 = frame.lightTree;
        uint _e24 = node_1;
        LightNode _e26 = fetchLightNode((_e23 + _e24));
        vec4 _e27 = estimatesOfChildren(_e26, point_9, normal_7);
        float two = (_e27.x + _e27.y);
        float three = (two + _e27.z);
        float total_2 = (three + _e27.w);
        uint _e35 = node_1;
        if ((_e35 == 0u)) {
            float _e39 = shareOfTree(total_2, far_2);
            choice.share = _e39;
            float _e41 = rest;
            float _e43 = choice.share;
            choice.taken = (_e41 < _e43);
            float _e45 = rest;
            float _e47 = choice.share;
            rest = min((_e45 / max(_e47, 1e-37)), 0.99999994);
        }
        float _e53 = rest;
        float at_2 = (_e53 * total_2);
        uint byChance = ((uint((at_2 >= _e27.x)) + uint((at_2 >= two))) + uint((at_2 >= three)));
        uint _e68 = level;
        uint child = pick((leaf < 0), byChance, ((uint(max(leaf, 0)) >> (2u * _e68)) & 3u));
        bool low_2 = (child < 2u);
        bool odd = ((child & 1u) == 1u);
        float own_6 = pick(low_2, pick(odd, _e27.y, _e27.x), pick(odd, _e27.w, _e27.z));
        float before = pick(low_2, pick(odd, _e27.x, 0.0), pick(odd, three, two));
        float _e95 = choice.probability;
        choice.probability = (_e95 * (own_6 / max(total_2, 1e-37)));
        choice.emitter = uint(pick(low_2, pick(odd, _e26.emitters.y, _e26.emitters.x), pick(odd, _e26.emitters.w, _e26.emitters.z)));
        rest = clamp(((at_2 - before) / max(own_6, 1e-37)), 0.0, 0.99999994);
        uint _e121 = node_1;
        node_1 = (((4u * _e121) + 1u) + child);
        uint _e126 = level;
        if ((_e126 == 0u)) {
            break;
        }
    }
    TreeChoice _e129 = choice;
    return _e129;
}

float probabilityOf(Emitter e_14, vec3 point_10, vec3 normal_8, Odds odds) {
    float probability = 0.0;
    uint _e6 = frame.emitterCount;
    probability = float(min(_e6, 1u));
    const bool _e12 = hasManyLights;
    uint _e15 = frame.emitterCount;
    if (pick(_e12, (_e15 > 1u), false)) {
        float _e19 = estimatedIrradiance(e_14, point_10, normal_8);
        probability = (_e19 / max(odds.total, 1e-37));
        const bool _e25 = hasLightTree;
        uint _e28 = frame.lightTreeDepth;
        if (pick(_e25, (_e28 > 0u), false)) {
            TreeChoice _e38 = descend(point_10, normal_8, 0.0, int(max(e_14.leaf, 0.0)), odds.total);
            float _e39 = probability;
            probability = pick((e_14.leaf >= 0.0), (_e38.probability * _e38.share), (_e39 * (1.0 - odds.tree)));
        }
    }
    float _e51 = probability;
    return _e51;
}

float misWeight(float own, float other) {
    float ratio_5 = (other / own);
    return (1.0 / (1.0 + (ratio_5 * ratio_5)));
}

vec3 foundLight(Path p_9, PairHit hit_1, Surface s_5, vec3 outward, Emitter only_1) {
    vec3 found_8 = vec3(0.0);
    uint i_18 = 0u;
    bool escaped = (hit_1.shape == noShape);
    vec3 direction_19 = p_9.rays.direction;
    bool hidden = pick(((uint(s_5.code) & 16u) != 0u), (dot(outward, direction_19) > 0.0), false);
    int _e21 = emitterOf(s_5.code);
    found_8 = pick(pick(hidden, true, escaped), vec3(0.0), s_5.emission);
    bool weighed = pick(escaped, true, (_e21 >= 0));
    uint _e33 = frame.emitterCount;
    if (pick(weighed, (_e33 > 0u), false)) {
        vec3 emission = found_8;
        found_8 = vec3(0.0);
        i_18 = pick(escaped, 0u, uint(max(_e21, 0)));
        const bool _e47 = hasMeshLamps;
        if (pick(_e47, (hit_1.triangle.instance != noInstance), false)) {
            uint _e53 = i_18;
            uint _e54 = i_18;
            Emitter _e55 = emitterAt(_e54, only_1);
            uint _e57 = emitterOfTriangle(_e55, hit_1.triangle);
            i_18 = (_e53 + _e57);
        }
        while(true) {
            uint _e59 = i_18;
            Emitter _e60 = emitterAt(_e59, only_1);
            FarLight _e61 = farLight(_e60, direction_19);
            float _e67 = shapePdf(_e60, p_9.rays.point, direction_19, hit_1.t, outward, hit_1.triangle.triangle);
            float density = pick(escaped, _e61.pdf, _e67);
            float _e74 = probabilityOf(_e60, p_9.rays.point, p_9.litSide, p_9.odds);
            float pdf_3 = (density * _e74);
            vec3 radiance = pick(escaped, _e61.radiance, emission);
            vec3 _e78 = found_8;
            float _e80 = misWeight(p_9.pdf, pdf_3);
            found_8 = (_e78 + (radiance * pick((p_9.pdf <= 0.0), 1.0, _e80)));
            uint _e89 = i_18;
            i_18 = (_e89 + 1u);
            const bool _e92 = hasSky;
            const bool _e94 = hasSuns;
            uint _e99 = i_18;
            uint _e102 = frame.farEmitters;
            if (pick(pick(!(pick(_e92, true, _e94)), true, !(escaped)), true, (_e99 >= _e102))) {
                break;
            }
        }
    }
    vec3 _e105 = found_8;
    return _e105;
}

uint pascalW2_(uint x_12) {
    uint y_7 = 0u;
    uint _e5 = timesW2_(((x_12 >> 2u) & 13107u));
    y_7 = (x_12 ^ _e5);
    uint _e8 = y_7;
    uint _e9 = y_7;
    uint _e14 = timesW(((_e9 >> 4u) & 3855u));
    y_7 = (_e8 ^ _e14);
    uint _e16 = y_7;
    uint _e17 = y_7;
    uint _e22 = timesW2_(((_e17 >> 8u) & 255u));
    return (_e16 ^ _e22);
}

vec3 next3d(inout Sampler s_6) {
    Group _e1 = nextGroup(s_6);
    uint _e4 = timesW2_(_e1.shift);
    uint _e6 = pascalW2_((_e1.index ^ _e4));
    uint _e12 = scramble(_e6, (_e1.seedA ^ (_e1.seedB * 2654435761u)));
    vec2 _e13 = points2d(_e1);
    uint _e16 = reverseHalves((_e12 & 65535u));
    float _e17 = toUnit(_e16, _e12);
    return vec3(_e13, _e17);
}

EmitterChoice chooseEmitter(vec3 point_11, vec3 normal_9, float u_5) {
    EmitterChoice choice_1 = EmitterChoice(0u, 0.0, Odds(0.0, 0.0));
    float total_1 = 0.0;
    uint chosen = 0u;
    float chosenWeight = 0.0;
    float rest_1 = 0.0;
    uint i_19 = 0u;
    const bool _e4 = hasLightTree;
    uint _e7 = frame.lightTreeDepth;
    bool hasTree = pick(_e4, (_e7 > 0u), false);
    uint _e13 = frame.emitterCount;
    uint _e16 = frame.farEmitters;
    uint listed = pick(hasTree, _e16, _e13);
    uint _e21 = frame.emitterCount;
    choice_1 = EmitterChoice(0u, float(min(_e21, 1u)), Odds(1.0, 0.0));
    const bool _e31 = hasManyLights;
    uint _e34 = frame.emitterCount;
    if (pick(_e31, (_e34 > 1u), false)) {
        rest_1 = u_5;
        while(true) {
            uint _e47 = i_19;
            Emitter _e48 = fetchEmitter(_e47);
            float _e49 = estimatedIrradiance(_e48, point_11, normal_9);
            uint _e50 = i_19;
            float weight_1 = pick((_e50 < listed), _e49, 0.0);
            float _e54 = total_1;
            total_1 = (_e54 + weight_1);
            float _e56 = total_1;
            float share_2 = (weight_1 / max(_e56, 1e-37));
            float _e60 = rest_1;
            bool take = (_e60 < share_2);
            uint _e62 = chosen;
            uint _e63 = i_19;
            chosen = pick(take, _e63, _e62);
            float _e65 = chosenWeight;
            chosenWeight = pick(take, weight_1, _e65);
            float _e67 = rest_1;
            float _e74 = rest_1;
            rest_1 = pick(take, (_e74 / max(share_2, 1e-37)), ((_e67 - share_2) / max((1.0 - share_2), 1e-7)));
            uint _e80 = i_19;
            i_19 = (_e80 + 1u);
            uint _e82 = i_19;
            if ((_e82 >= listed)) {
                break;
            }
        }
        uint _e84 = chosen;
        float _e85 = chosenWeight;
        float _e86 = total_1;
        float _e90 = total_1;
        choice_1 = EmitterChoice(_e84, (_e85 / max(_e86, 1e-37)), Odds(_e90, 0.0));
        if (hasTree) {
            float _e94 = rest_1;
            float _e96 = total_1;
            TreeChoice _e97 = descend(point_11, normal_9, _e94, -1, _e96);
            choice_1.odds.tree = _e97.share;
            uint _e102 = chosen;
            choice_1.index = pick(_e97.taken, _e97.emitter, _e102);
            float _e108 = choice_1.probability;
            choice_1.probability = pick(_e97.taken, (_e97.probability * _e97.share), (_e108 * (1.0 - _e97.share)));
        }
    }
    EmitterChoice _e118 = choice_1;
    return _e118;
}

vec3 turnTo(vec3 axis_1, vec3 v_5) {
    float s_18 = pick((axis_1.z >= 0.0), 1.0, -1.0);
    float a_5 = (-1.0 / (s_18 + axis_1.z));
    float b_8 = ((axis_1.x * axis_1.y) * a_5);
    vec3 x_17 = vec3((1.0 + (((s_18 * axis_1.x) * axis_1.x) * a_5)), (s_18 * b_8), (-(s_18) * axis_1.x));
    vec3 y_12 = vec3(b_8, (s_18 + ((axis_1.y * axis_1.y) * a_5)), -(axis_1.y));
    return (((v_5.x * x_17) + (v_5.y * y_12)) + (v_5.z * axis_1));
}

ConeDirection sampleCone(vec3 axis_2, float width_1, vec2 u_6) {
    float oneMinusCosine = (u_6.x * width_1);
    float cosine_13 = (1.0 - oneMinusCosine);
    float sine2_ = (oneMinusCosine * (2.0 - oneMinusCosine));
    float sine_3 = sqrt(max(sine2_, 0.0));
    float phi = (6.2831855 * u_6.y);
    vec2 turn_1 = vec2(cos(phi), sin(phi));
    vec3 _e23 = turnTo(axis_2, vec3(((sine_3 / length(turn_1)) * turn_1), cosine_13));
    return ConeDirection(_e23, cosine_13, sine2_);
}

LightSample sampleSphere(Emitter e_15, vec3 point_12, vec2 u_7) {
    SphereView _e3 = viewSphere(e_15, point_12);
    vec3 axis_4 = pick((_e3.distance_ < 1e-30), vec3(0.0, 0.0, 1.0), (_e3.toCenter / vec3(max(_e3.distance_, 1e-30))));
    ConeDirection _e19 = sampleCone(axis_4, _e3.width, u_7);
    float along_2 = (_e3.distance_ * _e19.cosine);
    float halfChord = sqrt(max(((e_15.radius * e_15.radius) - ((_e3.distance_ * _e3.distance_) * _e19.sine2_)), 0.0));
    float larger = (abs(along_2) + halfChord);
    bool takeLarger = pick(_e3.inside, (along_2 > 0.0), false);
    float distance_7 = pick(takeLarger, larger, (_e3.power / max(larger, 1e-30)));
    float _e49 = conePdf(_e3.width);
    return LightSample(_e19.direction, distance_7, e_15.radiance, _e49, false);
}

vec2 cosineAndSine(float x_13) {
    float h_4 = (0.5 * x_13);
    float z_5 = (h_4 * h_4);
    float sine_4 = (((((((-0.00019515296 * z_5) + 0.008332161) * z_5) - 0.16666655) * z_5) * h_4) + h_4);
    return vec2((1.0 - ((2.0 * sine_4) * sine_4)), ((2.0 * sine_4) * sqrt((1.0 - (sine_4 * sine_4)))));
}

vec3 sphericalRectangle(QuadView q_4, vec2 u_8) {
    float h_5 = q_4.height;
    vec2 y_13 = vec2(q_4.low.y, q_4.high.y);
    vec2 s_19 = (y_13 / sqrt(((y_13 * y_13) + vec2((h_5 * h_5)))));
    vec2 _e21 = cosineAndSine((0.5 * (q_4.start + (u_8.x * q_4.solidAngle))));
    vec2 across_4 = (vec2((s_19.y - s_19.x), (s_19.y + s_19.x)) * _e21);
    float w_3 = (((2.0 * _e21.x) * _e21.y) / max(length(across_4), 1e-15));
    float x_18 = clamp(((h_5 * w_3) * inversesqrt(max((1.0 - (w_3 * w_3)), 1e-12))), q_4.low.x, q_4.high.x);
    float d2_ = ((x_18 * x_18) + (h_5 * h_5));
    vec2 ends_1 = (y_13 * inversesqrt((vec2(d2_) + (y_13 * y_13))));
    float v_9 = mix(ends_1.x, ends_1.y, u_8.y);
    float atY = clamp(((v_9 * sqrt(d2_)) * inversesqrt(max((1.0 - (v_9 * v_9)), 1e-12))), y_13.x, y_13.y);
    return (((x_18 * q_4.axisX) + (atY * q_4.axisY)) + (h_5 * q_4.axisZ));
}

LightSample sampleQuad(Emitter e_16, vec3 point_13, vec2 u_9) {
    QuadView _e3 = viewQuad(e_16, point_13);
    vec3 onArea = ((_e3.corner + (u_9.x * e_16.u)) + (u_9.y * e_16.v));
    vec3 _e13 = sphericalRectangle(_e3, u_9);
    vec3 toLight_3 = pick(_e3.bySolidAngle, _e13, onArea);
    float distance_8 = max(length(toLight_3), _e3.height);
    float _e23 = pdfOfView(_e3, e_16.area, distance_8);
    return LightSample((toLight_3 / vec3(distance_8)), distance_8, e_16.radiance, _e23, false);
}

vec4 pointOnFaces(Emitter e_17, BoxView b_2, vec2 u_10) {
    float both = (b_2.faces.x + b_2.faces.y);
    float at_3 = (u_10.x * b_2.area);
    bool onX_1 = (at_3 < b_2.faces.x);
    bool onY_1 = pick(!(onX_1), (at_3 < both), false);
    float face = pick(onX_1, b_2.faces.x, pick(onY_1, b_2.faces.y, b_2.faces.z));
    float within_3 = clamp(((at_3 - pick(onX_1, 0.0, pick(onY_1, b_2.faces.x, both))) / max(face, 1e-30)), 0.0, 1.0);
    vec3 axis_5 = vec3(pick(onX_1, 1.0, 0.0), pick(onY_1, 1.0, 0.0), pick(pick(onX_1, true, onY_1), 0.0, 1.0));
    vec3 p_19 = vec3(pick((dot(axis_5, b_2.point) >= 0.0), 1.0, -1.0), ((2.0 * within_3) - 1.0), ((2.0 * u_10.y) - 1.0));
    vec3 toLight_4 = ((pick(onX_1, p_19.xyz, pick(onY_1, p_19.zxy, p_19.yzx)) * e_17.u) - b_2.point);
    return vec4(toLight_4, abs(dot(axis_5, toLight_4)));
}

vec3 rotateBack(vec4 q_5, vec3 v_6) {
    vec3 _e6 = rotate(vec4(-(q_5.xyz), q_5.w), v_6);
    return _e6;
}

LightSample sampleBox(Emitter e_18, vec3 point_14, vec2 u_11) {
    BoxView _e3 = viewBox(e_18, point_14);
    vec4 _e4 = pointOnFaces(e_18, _e3, u_11);
    ConeDirection _e10 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_11);
    vec3 outwards = _e10.direction;
    Slabs _e16 = boxSlabs(_e3.point, outwards, e_18.u);
    float distance_9 = pick(_e3.inside, max(_e16.far, 0.0), length(_e4.xyz));
    vec3 direction_20 = pick(_e3.inside, outwards, (_e4.xyz / vec3(max(distance_9, 1e-30))));
    float _e31 = areaPdf(_e3.area, _e4.w, distance_9);
    float _e33 = conePdf(2.0);
    float pdf_4 = pick(_e3.inside, _e33, _e31);
    vec3 _e37 = rotateBack(_e3.rotation, direction_20);
    return LightSample(_e37, distance_9, e_18.radiance, pdf_4, false);
}

ChosenTriangle chooseTriangle(Emitter e_19, vec2 u_12) {
    uint _e4 = frame.lampTables;
    uint first_1 = (_e4 + uint(e_19.table));
    uint column_1 = min(uint((u_12.x * e_19.triangles)), (uint(e_19.triangles) - 1u));
    LampTriangle _e18 = fetchLampTriangle((first_1 + column_1));
    uint _e26 = mixBits((floatBitsToUint(u_12.x) ^ (floatBitsToUint(u_12.y) * 2654435761u)));
    uint hash = (_e26 >> 8u);
    float fine = (((float(hash) * 5.9604645e-8) * 5.9604645e-8) * e_19.triangles);
    float x_19 = clamp((((u_12.x * e_19.triangles) - float(column_1)) + fine), 0.0, 0.99999994);
    bool own_7 = (x_19 < _e18.own);
    float rest_2 = pick(own_7, (x_19 / max(_e18.own, 1e-37)), ((x_19 - _e18.own) / max((1.0 - _e18.own), 1e-7)));
    uint place_5 = pick(own_7, _e18.place, _e18.other);
    LampTriangle _e67 = fetchLampTriangle((((first_1 + column_1) + place_5) - _e18.place));
    float density_1 = _e67.density;
    return ChosenTriangle(place_5, density_1, vec2(min(rest_2, 1.0), u_12.y));
}

vec2 weightsOnTriangle(vec2 u_13) {
    float low_3 = (0.5 * min(u_13.x, u_13.y));
    float high_2 = (max(u_13.x, u_13.y) - low_3);
    return pick((u_13.x < u_13.y), vec2(low_3, high_2), vec2(high_2, low_3));
}

vec3 outOfMesh(Instance i_20, vec3 p_10) {
    vec3 q_7 = (p_10 - vec3(i_20.toMeshX.w, i_20.toMeshY.w, i_20.toMeshZ.w));
    vec3 x_20 = cross(i_20.toMeshY.xyz, i_20.toMeshZ.xyz);
    vec3 y_14 = cross(i_20.toMeshZ.xyz, i_20.toMeshX.xyz);
    vec3 z_6 = cross(i_20.toMeshX.xyz, i_20.toMeshY.xyz);
    return ((((q_7.x * x_20) + (q_7.y * y_14)) + (q_7.z * z_6)) / vec3(dot(i_20.toMeshX.xyz, x_20)));
}

LightSample sampleMesh(Emitter e_20, vec3 point_15, vec2 u_14) {
    ChosenTriangle _e3 = chooseTriangle(e_20, u_14);
    uint _e6 = frame.instances;
    Instance _e12 = fetchInstance((_e6 + (uint(e_20.instance) * instanceRows)));
    Triangle _e18 = fetchTriangle((_e12.triangles + (_e3.place * triangleRows)));
    vec2 _e20 = weightsOnTriangle(_e3.u);
    vec3 _e34 = outOfMesh(_e12, ((_e18.a + (_e20.x * (_e18.b - _e18.a))) + (_e20.y * (_e18.c - _e18.a))));
    vec3 toLight_5 = (_e34 - point_15);
    vec3 across_5 = (mat3x3(_e12.toMeshX.xyz, _e12.toMeshY.xyz, _e12.toMeshZ.xyz) * cross((_e18.b - _e18.a), (_e18.c - _e18.a)));
    float height_3 = (dot(across_5, toLight_5) * inversesqrt(max(dot(across_5, across_5), 1e-37)));
    float distance_10 = length(toLight_5);
    float _e62 = areaPdf((e_20.area / _e3.density), abs(height_3), distance_10);
    bool lit_1 = pick((height_3 < 0.0), true, pick((e_20.oneSided == 0.0), (height_3 > 0.0), false));
    float reached_1 = max((distance_10 - (1e-5 * (length(point_15) + distance_10))), 0.0);
    return LightSample((toLight_5 / vec3(max(distance_10, 1e-30))), reached_1, e_20.radiance, pick(lit_1, _e62, 0.0), false);
}

LightSample samplePoint(Emitter e_21, vec3 point_16) {
    vec3 toLight_6 = (e_21.position - point_16);
    float distance_11 = length(toLight_6);
    float safe = max(distance_11, 1e-15);
    return LightSample((toLight_6 / vec3(safe)), distance_11, (e_21.radiance / vec3((safe * safe))), pick((distance_11 > 1e-15), 1.0, 0.0), true);
}

LightSample sampleSpot(Emitter e_22, vec3 point_17) {
    LightSample s_7 = LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, false);
    LightSample _e2 = samplePoint(e_22, point_17);
    s_7 = _e2;
    vec3 _e5 = s_7.direction;
    float _e6 = spotFalloff(e_22, _e5);
    vec3 _e8 = s_7.radiance;
    s_7.radiance = (_e8 * _e6);
    float _e12 = s_7.pdf;
    s_7.pdf = pick((_e6 > 0.0), _e12, 0.0);
    LightSample _e17 = s_7;
    return _e17;
}

LightSample sampleDirectional(Emitter e_23, vec2 u_15) {
    bool delta = (e_23.area == 0.0);
    ConeDirection _e10 = sampleCone(-(e_23.u), (e_23.area / 6.2831855), u_15);
    return LightSample(_e10.direction, 1e30, e_23.radiance, pick(delta, 1.0, (1.0 / max(e_23.area, 1e-31))), delta);
}

Parts splitProduct(vec2 u_16, uvec2 n_2) {
    uvec2 digits = uvec2((u_16 * 16777216.0));
    uvec2 low_4 = ((digits & uvec2(4095u)) * n_2);
    uvec2 high_3 = (((digits >> uvec2(12u)) * n_2) + (low_4 >> uvec2(12u)));
    return Parts((high_3 >> uvec2(12u)), vec2((((high_3 & uvec2(4095u)) << uvec2(12u)) | (low_4 & uvec2(4095u)))));
}

ChosenCell chooseCell(vec2 u_17) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_4 = uvec2(_e3);
    Parts _e9 = splitProduct(u_17, (size_4 + uvec2(0u, 1u)));
    uint _e17 = mixBits((floatBitsToUint(u_17.x) ^ (floatBitsToUint(u_17.y) * 2654435761u)));
    uint hash_1 = (_e17 >> 8u);
    float _e26 = frame.environmentSize.x;
    float fine_1 = ((float(hash_1) * 5.9604645e-8) * _e26);
    float x_21 = min(((_e9.rest.x + fine_1) * 5.9604645e-8), 0.99999994);
    uint rows = ((size_4.y + 2u) / 2u);
    bool second = (_e9.whole.y >= rows);
    vec4 entries = texelFetch(environment, ivec2(uvec2(_e9.whole.x, ((_e9.whole.y + size_4.y) - pick(second, rows, 0u)))), 0);
    vec2 entry = pick(second, entries.zw, entries.xy);
    bool own_8 = (x_21 < entry.x);
    uint other_1 = uint(entry.y);
    uint otherRow = (other_1 / size_4.x);
    uvec2 cell_2 = pick(own_8, _e9.whole, uvec2((other_1 - (otherRow * size_4.x)), otherRow));
    float rest_3 = pick(own_8, (x_21 / max(entry.x, 1e-37)), ((x_21 - entry.x) / max((1.0 - entry.x), 1e-7)));
    return ChosenCell(cell_2, vec2(min(rest_3, 1.0), (_e9.rest.y * 5.9604645e-8)));
}

float linearSample(float u_18, float a_1, float b_3) {
    vec2 ends_2 = (vec2(a_1, b_3) / vec2(max((a_1 + b_3), 1e-37)));
    return min((u_18 / max((ends_2.x + sqrt(mix((ends_2.x * ends_2.x), (ends_2.y * ends_2.y), u_18))), 1e-9)), 1.0);
}

EnvironmentSample sampleEnvironment(vec2 u_19) {
    vec2 size_5 = frame.environmentSize;
    ChosenCell _e4 = chooseCell(u_19);
    Corners _e6 = environmentCorners(_e4.cell);
    vec2 cell_3 = vec2(_e4.cell);
    bvec2 atPole = bvec2((cell_3.y == 0.0), (cell_3.y == size_5.y));
    float _e32 = linearSample(_e4.rest.y, max((_e6.a.w + _e6.b.w), 0.0), max((_e6.c.w + _e6.d.w), 0.0));
    float t_13 = ((_e32 * pick(any(atPole), 0.5, 1.0)) + pick(atPole.x, 0.5, 0.0));
    float _e55 = linearSample(_e4.rest.x, mix(_e6.a.w, _e6.c.w, t_13), mix(_e6.b.w, _e6.d.w, t_13));
    bool isLower_1 = ((2.0 * cell_3.y) > size_5.y);
    float fromPole_1 = pick(isLower_1, ((size_5.y - cell_3.y) + (0.5 - t_13)), (cell_3.y + (t_13 - 0.5)));
    vec2 _e76 = cosineAndSine((fromPole_1 * (3.1415927 / size_5.y)));
    float _e85 = frame.environmentTurn;
    float halfTurns = (2.0 * (((cell_3.x + (_e55 - 0.5)) / size_5.x) - _e85));
    float nearest = floor((halfTurns + 0.5));
    bool back = (fract((0.5 * nearest)) > 0.0);
    vec2 _e100 = cosineAndSine(((halfTurns - nearest) * 3.1415927));
    vec2 phi_1 = (_e100 * pick(back, -1.0, 1.0));
    float sine_5 = max(_e76.y, 1e-9);
    vec3 direction_21 = vec3((sine_5 * phi_1.y), pick(isLower_1, -(_e76.x), _e76.x), (-(sine_5) * phi_1.x));
    EnvironmentLight _e119 = lightWithin(_e6, vec2(_e55, t_13), sine_5);
    return EnvironmentSample(direction_21, _e119);
}

LightSample sampleSky(vec2 u_20) {
    EnvironmentSample s_8 = EnvironmentSample(vec3(0.0), EnvironmentLight(vec3(0.0), 0.0));
    ConeDirection _e6 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_20);
    s_8 = EnvironmentSample(_e6.direction, white);
    const bool _e12 = hasEnvironment;
    if (_e12) {
        EnvironmentSample _e13 = sampleEnvironment(u_20);
        s_8 = _e13;
    }
    vec3 _e15 = s_8.direction;
    vec3 _e18 = s_8.light.radiance;
    vec3 _e20 = s_8.direction;
    vec3 _e21 = sky(_e20);
    float _e25 = s_8.light.pdf;
    return LightSample(_e15, 1e30, (_e18 * _e21), _e25, false);
}

LightSample sampleEmitter(Emitter e_24, vec3 point_18, vec2 u_21) {
    LightSample s_9 = LightSample(vec3(0.0, 1.0, 0.0), 1e30, vec3(0.0), 0.0, true);
    const bool _e15 = hasSphereLights;
    if (pick(_e15, (e_24.kind == 0.0), false)) {
        LightSample _e20 = sampleSphere(e_24, point_18, u_21);
        s_9 = _e20;
    }
    const bool _e22 = hasQuadLights;
    if (pick(_e22, (e_24.kind == 1.0), false)) {
        LightSample _e27 = sampleQuad(e_24, point_18, u_21);
        s_9 = _e27;
    }
    const bool _e29 = hasBoxLights;
    if (pick(_e29, (e_24.kind == 2.0), false)) {
        LightSample _e34 = sampleBox(e_24, point_18, u_21);
        s_9 = _e34;
    }
    const bool _e36 = hasMeshLamps;
    if (pick(_e36, (e_24.kind == 7.0), false)) {
        LightSample _e41 = sampleMesh(e_24, point_18, u_21);
        s_9 = _e41;
    }
    const bool _e43 = hasPointLights;
    if (pick(_e43, (e_24.kind == 3.0), false)) {
        LightSample _e48 = samplePoint(e_24, point_18);
        s_9 = _e48;
    }
    const bool _e50 = hasPointLights;
    if (pick(_e50, (e_24.kind == 4.0), false)) {
        LightSample _e55 = sampleSpot(e_24, point_18);
        s_9 = _e55;
    }
    const bool _e57 = hasSuns;
    if (pick(_e57, (e_24.kind == 5.0), false)) {
        LightSample _e62 = sampleDirectional(e_24, u_21);
        s_9 = _e62;
    }
    const bool _e64 = hasSky;
    if (pick(_e64, (e_24.kind == 6.0), false)) {
        LightSample _e69 = sampleSky(u_21);
        s_9 = _e69;
    }
    float _e72 = s_9.pdf;
    float _e74 = s_9.distance_;
    s_9.pdf = pick((_e74 <= (1e-5 * length(point_18))), 0.0, _e72);
    LightSample _e81 = s_9;
    return _e81;
}

bool isConductor(uint code_5) {
    const bool _e2 = hasConductors;
    uint _e3 = kindOf(code_5);
    return pick(_e2, (_e3 == conductor), false);
}

vec3 schlick(vec3 f0_, float cosine_1) {
    float m = max((1.0 - cosine_1), 0.0);
    float m2_ = (m * m);
    return (f0_ + ((vec3(1.0) - f0_) * ((m2_ * m2_) * m)));
}

vec3 metallicRoughnessF0_(vec3 baseColor, float metallic) {
    return mix(vec3(0.04), baseColor, metallic);
}

vec3 metallicRoughnessDiffuse(vec3 baseColor_1, float metallic_1, float cosine_2) {
    vec3 _e7 = schlick(vec3(0.04), cosine_2);
    return (((1.0 - metallic_1) * (1.0 - _e7.x)) * baseColor_1);
}

float specularShare(vec3 baseColor_2, float metallic_2, float cosine_3) {
    vec3 _e3 = metallicRoughnessF0_(baseColor_2, metallic_2);
    vec3 _e4 = schlick(_e3, cosine_3);
    float specular = dot(_e4, vec3(1.0));
    vec3 _e9 = metallicRoughnessDiffuse(baseColor_2, metallic_2, 1.0);
    float diffuse = dot(_e9, vec3(1.0));
    return (specular / max((specular + diffuse), 1e-20));
}

bool isMetallicRoughness(uint code_6) {
    const bool _e2 = hasMetallicRoughness;
    uint _e3 = kindOf(code_6);
    return pick(_e2, (_e3 == metallicRoughness), false);
}

float indexRatio(float eta, float z, bool thin) {
    return pick(pick((z < 0.0), !(thin), false), (1.0 / eta), eta);
}

float reflectionBound(vec3 wo, float alpha) {
    float s_20 = (1.0 + length(wo.xy));
    float s2_ = (s_20 * s_20);
    float a2_ = (alpha * alpha);
    return (((1.0 - a2_) * s2_) / (s2_ + ((a2_ * wo.z) * wo.z)));
}

float stretched(vec3 w_1, float alpha_1) {
    return sqrt(((w_1.z * w_1.z) + ((alpha_1 * alpha_1) * dot(w_1.xy, w_1.xy))));
}

Outgoing outgoing(Surface s_10, vec3 wo_1) {
    Outgoing o_1 = Outgoing(vec3(0.0), 0.0, 0.0, 0.0, 0.0);
    uint code_8 = uint(s_10.code);
    bool _e4 = isConductor(code_8);
    bool _e5 = isDielectric(code_8);
    o_1 = Outgoing(wo_1, pick(pick(_e4, true, _e5), 1.0, 0.0), 1.0, 1.0, 1.0);
    const bool _e16 = hasMetallicRoughness;
    if (_e16) {
        float _e19 = o_1.share;
        float _e23 = specularShare(s_10.baseColor, s_10.metallic, wo_1.z);
        bool _e24 = isMetallicRoughness(code_8);
        o_1.share = pick(_e24, _e23, _e19);
    }
    const bool _e27 = hasGlass;
    if (_e27) {
        bool _e32 = isThin(code_8);
        float _e33 = indexRatio(s_10.eta.x, wo_1.z, _e32);
        bool _e34 = isDielectric(code_8);
        o_1.ratio = pick(_e34, _e33, 1.0);
    }
    const bool _e38 = hasConductors;
    const bool _e40 = hasMetallicRoughness;
    const bool _e43 = hasGlass;
    if (pick(pick(_e38, true, _e40), true, _e43)) {
        float _e47 = reflectionBound(wo_1, s_10.alpha);
        bool _e48 = isDielectric(code_8);
        o_1.bound = pick(_e48, 1.0, _e47);
        float _e53 = stretched(wo_1, s_10.alpha);
        o_1.stretched = _e53;
    }
    Outgoing _e54 = o_1;
    return _e54;
}

float facetDensity(vec3 h_1, float alpha_2) {
    float slope = max(((dot(h_1.xy, h_1.xy) / (alpha_2 * alpha_2)) + (h_1.z * h_1.z)), 1.0);
    return (0.31830987 / (((alpha_2 * alpha_2) * slope) * slope));
}

vec3 conductorFresnel(float cosine_4, vec3 eta_1, vec3 k_1) {
    float cosine2_ = (cosine_4 * cosine_4);
    float sine2_1 = (1.0 - cosine2_);
    vec3 difference = (((eta_1 * eta_1) - (k_1 * k_1)) - vec3(sine2_1));
    vec3 a2PlusB2_ = sqrt(((difference * difference) + ((((4.0 * eta_1) * eta_1) * k_1) * k_1)));
    vec3 larger_1 = sqrt(((0.5 * (a2PlusB2_ + abs(difference))) + vec3(1e-20)));
    vec3 smaller = ((eta_1 * k_1) / larger_1);
    vec3 a_6 = mix(smaller, larger_1, greaterThan(difference, vec3(0.0)));
    vec3 b_9 = mix(larger_1, smaller, greaterThan(difference, vec3(0.0)));
    vec3 b2_ = ((b_9 * b_9) + vec3(1e-20));
    vec3 acrossFar = (a_6 + vec3(cosine_4));
    vec3 acrossNear = (a_6 - vec3(cosine_4));
    vec3 across_6 = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a_6 * cosine_4) + vec3(sine2_1));
    vec3 alongNear = ((a_6 * cosine_4) - vec3(sine2_1));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across_6) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor_3, vec3 eta_2, vec3 k_2, float cosine_5) {
    float constants = dot((eta_2 + k_2), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_5, eta_2, k_2);
    return pick((constants > 0.0), _e8, baseColor_3);
}

float dielectricFresnel(float cosine_6, float ratio) {
    float inside2_ = (((ratio - 1.0) * (ratio + 1.0)) + (cosine_6 * cosine_6));
    float inside_3 = sqrt(max(inside2_, 0.0));
    float across_7 = ((cosine_6 - inside_3) / (cosine_6 + inside_3));
    float along_3 = ((((ratio * ratio) * cosine_6) - inside_3) / (((ratio * ratio) * cosine_6) + inside_3));
    return pick((inside2_ > 0.0), (0.5 * ((across_7 * across_7) + (along_3 * along_3))), 1.0);
}

float glassReflectance(float cosine_7, float ratio_1, bool thin_1) {
    float _e3 = dielectricFresnel(cosine_7, ratio_1);
    return pick(thin_1, ((2.0 * _e3) / (1.0 + _e3)), _e3);
}

vec3 facetReflectance(Surface s_11, float cosine_8, float ratio_2) {
    vec3 reflectance = vec3(0.0);
    uint code_9 = uint(s_11.code);
    const bool _e9 = hasMetallicRoughness;
    if (_e9) {
        vec3 _e12 = metallicRoughnessF0_(s_11.baseColor, s_11.metallic);
        vec3 _e13 = schlick(_e12, cosine_8);
        reflectance = _e13;
    }
    const bool _e15 = hasConductors;
    if (_e15) {
        vec3 _e16 = reflectance;
        vec3 _e20 = conductorReflectance(s_11.baseColor, s_11.eta, s_11.k, cosine_8);
        bool _e21 = isConductor(code_9);
        reflectance = pick(_e21, _e20, _e16);
    }
    const bool _e24 = hasGlass;
    if (_e24) {
        vec3 _e25 = reflectance;
        bool _e26 = isThin(code_9);
        float _e27 = glassReflectance(cosine_8, ratio_2, _e26);
        bool _e29 = isDielectric(code_9);
        reflectance = pick(_e29, vec3(_e27), _e25);
    }
    vec3 _e31 = reflectance;
    return _e31;
}

float singleScatteringAlbedo(float cosine_9, float alpha_3) {
    float x_22 = (cosine_9 / (cosine_9 + alpha_3));
    vec4 byAlpha = (vec4(0.887807, 0.309386, -0.270728, 0.0252433) + (x_22 * (vec4(1.08526, -3.21434, -1.87718, 1.61195) + (x_22 * (vec4(-5.18071, 10.7648, 6.30913, -8.09265) + (x_22 * (vec4(7.80474, -12.743, -24.1046, 25.2536) + (x_22 * vec4(-3.60041, 4.60906, 23.1225, -22.9342)))))))));
    float a2_1 = (alpha_3 * alpha_3);
    return min(dot(byAlpha, vec4(1.0, alpha_3, a2_1, (a2_1 * alpha_3))), 1.0);
}

vec3 compensation(Surface s_12, float cosine_10) {
    uint code_10 = uint(s_12.code);
    bool _e8 = isDielectric(code_10);
    bool asked = pick(((code_10 & 8u) != 0u), !(_e8), false);
    float _e12 = singleScatteringAlbedo(cosine_10, s_12.alpha);
    vec3 _e17 = facetReflectance(s_12, 1.0, 1.0);
    return pick(asked, (vec3(1.0) + (_e17 * ((1.0 - _e12) / _e12))), vec3(1.0));
}

FacetLobe evaluateFacets(Surface s_13, Outgoing o_2, vec3 wi) {
    vec3 passes = vec3(0.0);
    vec3 wo_5 = o_2.wo;
    bool _e6 = isDielectric(uint(s_13.code));
    const bool _e8 = hasGlass;
    bool crossing = pick(_e8, ((wo_5.z < 0.0) != (wi.z < 0.0)), false);
    vec3 m_1 = (wo_5 + (wi * pick(crossing, o_2.ratio, 1.0)));
    float m2_1 = max(dot(m_1, m_1), 1e-20);
    vec3 h_6 = (m_1 * inversesqrt(m2_1));
    float oh = dot(wo_5, h_6);
    float ih = dot(wi, h_6);
    float zo = abs(wo_5.z);
    float zi = abs(wi.z);
    bool faces_1 = pick((((oh * h_6.z) * wo_5.z) >= 0.0), (((ih * h_6.z) * wi.z) >= 0.0), false);
    float _e52 = facetDensity(h_6, s_13.alpha);
    float spread = (pick(crossing, (abs((oh * ih)) / m2_1), 0.25) * pick(faces_1, (2.0 * _e52), 0.0));
    vec3 _e60 = facetReflectance(s_13, abs(oh), o_2.ratio);
    passes = pick(crossing, (vec3(1.0) - _e60), _e60);
    float _e69 = stretched(wi, s_13.alpha);
    float masked = (zi / max(((zi * o_2.stretched) + (zo * _e69)), 1e-20));
    float _e76 = passes.x;
    float chosen_1 = (pick(_e6, _e76, 1.0) * pick(crossing, (o_2.ratio * o_2.ratio), 1.0));
    const bool _e86 = hasCompensation;
    if (_e86) {
        vec3 _e87 = passes;
        vec3 _e88 = compensation(s_13, zo);
        passes = (_e87 * _e88);
    }
    vec3 _e90 = passes;
    return FacetLobe(((_e90 * spread) * masked), ((spread * chosen_1) / ((o_2.bound * zo) + o_2.stretched)), abs(oh));
}

bool isSmooth(uint code_7) {
    return ((code_7 & 32u) != 0u);
}

float mirrorShare(float reflectivity) {
    const bool _e2 = hasMirrorLayers;
    return pick(_e2, reflectivity, 0.0);
}

vec4 evaluateBsdf(Surface s_14, Outgoing o_3, vec3 wi_1) {
    vec4 value = vec4(0.0);
    bool dark = false;
    vec3 base = vec3(0.0);
    float lambert = (0.31830987 * max(wi_1.z, 0.0));
    value = (vec4(s_14.baseColor, 1.0) * lambert);
    dark = pick((o_3.wo.z < 0.0), true, (wi_1.z <= 0.0));
    const bool _e23 = hasConductors;
    const bool _e25 = hasMetallicRoughness;
    const bool _e28 = hasGlass;
    if (pick(pick(_e23, true, _e25), true, _e28)) {
        uint code_11 = uint(s_14.code);
        FacetLobe _e32 = evaluateFacets(s_14, o_3, wi_1);
        const bool _e37 = hasMetallicRoughness;
        if (_e37) {
            vec3 _e38 = base;
            vec3 _e42 = metallicRoughnessDiffuse(s_14.baseColor, s_14.metallic, _e32.cosine);
            bool _e43 = isMetallicRoughness(code_11);
            base = pick(_e43, _e42, _e38);
        }
        bool _e52 = isSmooth(code_11);
        vec4 rough = pick(_e52, vec4(0.0), vec4(_e32.value, (o_3.share * _e32.pdf)));
        vec3 _e54 = base;
        vec4 _e61 = value;
        uint _e62 = kindOf(code_11);
        value = pick((_e62 == diffuse0_), _e61, (rough + (vec4(_e54, (1.0 - o_3.share)) * lambert)));
        bool _e66 = dark;
        bool _e67 = isSmooth(code_11);
        bool _e68 = isDielectric(code_11);
        dark = pick(_e68, _e67, _e66);
    }
    float _e71 = mirrorShare(s_14.reflectivity);
    vec4 _e74 = value;
    bool _e78 = dark;
    return pick(_e78, vec4(0.0), ((1.0 - _e71) * _e74));
}

vec3 sampleCosine(vec2 u_22) {
    float radius_2 = sqrt(u_22.x);
    float phi_2 = ((6.2831855 * u_22.y) - 3.1415927);
    return normalize(vec3((radius_2 * cos(phi_2)), (radius_2 * sin(phi_2)), sqrt((1.0 - u_22.x))));
}

vec3 sampleVisibleNormal(vec3 wo_2, float alpha_4, float bound, vec2 u_23) {
    float _e8 = stretched(wo_2, alpha_4);
    vec3 w_4 = (vec3((alpha_4 * wo_2.xy), wo_2.z) / vec3(_e8));
    float phi_3 = ((6.2831855 * u_23.x) - 3.1415927);
    float drop = (u_23.y * (1.0 + (bound * w_4.z)));
    float sine_6 = sqrt(max((drop * (2.0 - drop)), 0.0));
    vec3 h_7 = (w_4 + vec3((sine_6 * cos(phi_3)), (sine_6 * sin(phi_3)), (1.0 - drop)));
    return normalize(vec3((alpha_4 * h_7.xy), max(h_7.z, 1e-7)));
}

vec3 sampleFacet(float alpha_5, bool isMirror, Outgoing o_4, vec2 u_24) {
    float side_5 = pick((o_4.wo.z < 0.0), -1.0, 1.0);
    vec3 _e16 = sampleVisibleNormal((o_4.wo * side_5), max(alpha_5, 0.001), o_4.bound, u_24);
    return (pick(isMirror, vec3(0.0, 0.0, 1.0), _e16) * side_5);
}

vec3 refracted(vec3 wo_3, vec3 h_2, float ratio_3) {
    float cosine_14 = dot(wo_3, h_2);
    float inside_4 = sqrt(max((((ratio_3 - 1.0) * (ratio_3 + 1.0)) + (cosine_14 * cosine_14)), 0.0));
    return ((((cosine_14 - inside_4) * h_2) - wo_3) / vec3(ratio_3));
}

vec3 mirrored(vec3 wo_4) {
    return vec3(-(wo_4.xy), wo_4.z);
}

BsdfSample sampleLobe(Surface s_15, Outgoing o_5, vec3 u_25) {
    BsdfSample drawn = BsdfSample(vec3(0.0), 0.0, vec3(0.0), false);
    vec3 wi_2 = vec3(0.0);
    float probability_1 = 0.0;
    vec3 weight = vec3(0.0);
    vec3 wo_6 = o_5.wo;
    float _e5 = mirrorShare(s_15.reflectivity);
    float base_2 = (1.0 - _e5);
    float choice_2 = ((u_25.z - _e5) / base_2);
    vec3 _e12 = sampleCosine(u_25.xy);
    drawn = BsdfSample(_e12, 1.0, vec3(1.0), false);
    const bool _e20 = hasConductors;
    const bool _e22 = hasMetallicRoughness;
    const bool _e25 = hasGlass;
    if (pick(pick(_e20, true, _e22), true, _e25)) {
        uint code_12 = uint(s_15.code);
        bool _e29 = isDielectric(code_12);
        bool _e30 = isSmooth(code_12);
        vec3 _e33 = sampleFacet(s_15.alpha, _e30, o_5, u_25.xy);
        float oh_1 = max(dot(wo_6, _e33), 0.0);
        vec3 _e38 = facetReflectance(s_15, oh_1, o_5.ratio);
        bool crossing_1 = pick(_e29, (choice_2 >= _e38.x), false);
        wi_2 = (((2.0 * oh_1) * _e33) - wo_6);
        probability_1 = (base_2 * o_5.share);
        weight = (_e38 / vec3(o_5.share));
        const bool _e55 = hasGlass;
        if (_e55) {
            bool _e56 = isThin(code_12);
            vec3 _e57 = wi_2;
            vec3 _e59 = refracted(wo_6, _e33, o_5.ratio);
            wi_2 = pick(crossing_1, pick(_e56, -(wo_6), _e59), _e57);
            float _e63 = probability_1;
            probability_1 = pick(_e29, (base_2 * pick(crossing_1, (1.0 - _e38.x), _e38.x)), _e63);
            vec3 _e71 = weight;
            weight = pick(_e29, vec3(pick(pick(crossing_1, !(_e56), false), (1.0 / (o_5.ratio * o_5.ratio)), 1.0)), _e71);
        }
        float _e88 = wi_2.z;
        bool lost = pick(!(_e30), (crossing_1 != ((wo_6.z < 0.0) != (_e88 < 0.0))), false);
        bool specular_1 = (choice_2 < o_5.share);
        vec3 _e98 = drawn.direction;
        vec3 _e99 = wi_2;
        drawn.direction = pick(specular_1, _e99, _e98);
        float _e103 = drawn.pdf;
        float _e104 = probability_1;
        drawn.pdf = pick(specular_1, pick(lost, 0.0, _e104), _e103);
        vec3 _e110 = drawn.weight;
        vec3 _e111 = weight;
        drawn.weight = pick(specular_1, _e111, _e110);
        drawn.delta = pick(specular_1, _e30, false);
    }
    const bool _e116 = hasMirrorLayers;
    if (_e116) {
        bool reflected = (u_25.z < _e5);
        vec3 _e121 = drawn.direction;
        vec3 _e122 = mirrored(wo_6);
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

BsdfSample completed(BsdfSample drawn_1, vec4 value_1) {
    float pdf_5 = pick((drawn_1.pdf <= 0.0), 0.0, value_1.w);
    vec3 weight_2 = pick((pdf_5 > 0.0), (value_1.xyz / vec3(max(pdf_5, 1e-30))), vec3(0.0));
    return BsdfSample(drawn_1.direction, pick(drawn_1.delta, drawn_1.pdf, pdf_5), pick(drawn_1.delta, drawn_1.weight, weight_2), drawn_1.delta);
}

vec3 toWorld(Basis b_4, vec3 v_7) {
    return (((v_7.x * b_4.tangent) + (v_7.y * b_4.bitangent)) + (v_7.z * b_4.normal));
}

float max3_(vec3 v_8) {
    return max(max(v_8.x, v_8.y), v_8.z);
}

float unitFloat(uint h_3) {
    return (float((h_3 >> 8u)) * 5.9604645e-8);
}

float nextHash(inout Sampler s_16) {
    uint _e3 = s_16.key;
    s_16.key = (_e3 + 1u);
    uint _e7 = s_16.key;
    uint _e9 = s_16.salt;
    uint _e11 = mixBits((_e7 ^ _e9));
    uint _e13 = s_16.sample_;
    uint _e17 = s_16.place;
    uint _e20 = mixBits((_e11 + ((_e13 << 8u) | _e17)));
    float _e21 = unitFloat(_e20);
    return _e21;
}

bool isFlat(uint i_21) {
    uint _e4 = frame.shapeEnds.y;
    return (i_21 >= _e4);
}

void meetSurface(inout Path p_11, PairHit hit_2) {
    RayPair rays_2 = p_11.rays;
    bool escaped_1 = (hit_2.shape == noShape);
    uint shape_1 = pick(escaped_1, 0u, hit_2.shape);
    Surface _e10 = fetchSurface(shape_1);
    bool _e13 = isDielectric(uint(_e10.code));
    vec3 point_19 = (rays_2.point + (hit_2.t * rays_2.direction));
    Normals _e19 = normalsAt(rays_2, hit_2, shape_1, _e13);
    vec3 outward_1 = _e19.shading;
    Basis _e29 = basisAbout(pick(pick((dot(outward_1, rays_2.direction) > 0.0), !(_e13), false), -(outward_1), outward_1));
    vec3 _e32 = toLocal(_e29, -(rays_2.direction));
    const bool _e34 = hasGlass;
    if (_e34) {
        bool _e37 = isThin(uint(_e10.code));
        bool inside_5 = pick(pick(pick(_e13, !(_e37), false), (_e32.z < 0.0), false), !(escaped_1), false);
        vec3 _e47 = p_11.throughput;
        p_11.throughput = (_e47 * exp((-(_e10.absorption) * pick(inside_5, hit_2.t, 0.0))));
    }
    Emitter _e57 = fetchEmitter(0u);
    vec3 _e59 = p_11.radiance;
    vec3 _e61 = p_11.throughput;
    Path _e62 = p_11;
    vec3 _e64 = foundLight(_e62, hit_2, _e10, _e19.geometric, _e57);
    p_11.radiance = (_e59 + (_e61 * _e64));
    vec3 litSide = pick(_e13, vec3(0.0), _e29.normal);
    vec3 _e72 = next3d(p_11.sampler_);
    vec3 _e74 = next3d(p_11.sampler_);
    EmitterChoice _e76 = chooseEmitter(point_19, litSide, _e72.z);
    Emitter _e78 = emitterAt(_e76.index, _e57);
    LightSample _e80 = sampleEmitter(_e78, point_19, _e72.xy);
    float lightPdf = (_e80.pdf * _e76.probability);
    Outgoing _e84 = outgoing(_e10, _e32);
    vec3 _e86 = toLocal(_e29, _e80.direction);
    vec4 _e87 = evaluateBsdf(_e10, _e84, _e86);
    bool alone_1 = pick(_e80.delta, true, pick((_e78.shape < 0.0), (_e80.distance_ < 1e30), false));
    float _e98 = misWeight(lightPdf, _e87.w);
    float lightWeight = (pick(alone_1, 1.0, _e98) / lightPdf);
    BsdfSample _e102 = sampleLobe(_e10, _e84, _e74);
    vec4 _e104 = evaluateBsdf(_e10, _e84, _e102.direction);
    BsdfSample _e105 = completed(_e102, _e104);
    vec3 _e107 = toWorld(_e29, _e105.direction);
    uint _e110 = p_11.depth;
    uint _e113 = frame.maxDepth;
    bool goesOn = pick(!(escaped_1), (_e110 != _e113), false);
    vec3 _e117 = p_11.throughput;
    vec3 contribution = (((_e117 * _e87.xyz) * _e80.radiance) * lightWeight);
    bool lit_2 = pick(pick(goesOn, (lightPdf > 0.0), false), any(greaterThan((_e87.xyz * _e80.radiance), vec3(0.0))), false);
    p_11.light = pick(lit_2, contribution, vec3(0.0));
    vec3 _e139 = p_11.throughput;
    vec3 throughput = (_e139 * _e105.weight);
    float _e142 = max3_(throughput);
    uint _e148 = p_11.depth;
    float survival = pick((_e148 < rouletteDepth), 1.0, min((_e142 / 0.33333334), 0.95));
    float _e158 = max3_(throughput);
    float _e163 = nextHash(p_11.sampler_);
    p_11.alive = pick(pick(pick(goesOn, (_e105.pdf > 0.0), false), (_e158 > 0.0), false), (_e163 < survival), false);
    p_11.throughput = (throughput / vec3(survival));
    uint _e171 = p_11.depth;
    p_11.depth = (_e171 + 1u);
    p_11.pdf = pick(_e105.delta, 0.0, _e105.pdf);
    p_11.litSide = litSide;
    p_11.odds = _e76.odds;
    bool _e181 = isFlat(shape_1);
    bool solid = !(_e181);
    uint lightShape = pick((_e78.shape >= 0.0), uint(max(_e78.shape, 0.0)), noShape);
    bool _e198 = p_11.alive;
    p_11.rays = RayPair(point_19, shape_1, hit_2.triangle, (1e-5 * length(point_19)), _e198, _e107, pick(solid, (dot(_e107, outward_1) < 0.0), false), _e80.direction, pick(solid, (dot(_e80.direction, outward_1) < 0.0), false), pick(lit_2, _e80.distance_, -1.0), lightShape);
    return;
}

void extendPath(inout Path p_12) {
    RayPair _e2 = p_12.rays;
    PairHit _e3 = tracePair(_e2);
    vec3 _e5 = p_12.radiance;
    vec3 _e7 = p_12.light;
    p_12.radiance = (_e5 + pick(_e3.blocked, vec3(0.0), _e7));
    p_12.rays.lightDistance = -1.0;
    bool _e17 = p_12.alive;
    if (_e17) {
        meetSurface(p_12, _e3);
        return;
    } else {
        return;
    }
}

bool isOver(Path p_13) {
    return pick(!(p_13.alive), (p_13.rays.lightDistance < 0.0), false);
}

void main() {
    vec4 fragment = gl_FragCoord;
    Path p = Path(RayPair(vec3(0.0), 0u, LeftTriangle(0u, 0u), 0.0, false, vec3(0.0), false, vec3(0.0), false, 0.0, 0u), vec3(0.0), false, vec3(0.0), 0u, vec3(0.0), 0.0, vec3(0.0), Odds(0.0, 0.0), Sampler(0u, 0u, 0u, 0u));
    Film film = Film(vec4(0.0), vec4(0.0));
    uvec2 pixel_3 = uvec2(fragment.xy);
    uint _e5 = frame.sampleIndex;
    Path _e6 = startPath(pixel_3, _e5);
    p = _e6;
    while(true) {
        extendPath(p);
        Path _e8 = p;
        bool _e9 = isOver(_e8);
        if (_e9) {
            break;
        }
    }
    uint _e18 = frame.sampleIndex;
    if ((_e18 > 0u)) {
        vec4 _e23 = texelFetch(previousFilm, ivec2(pixel_3), 0);
        vec4 _e26 = texelFetch(previousSquares, ivec2(pixel_3), 0);
        film = Film(_e23, _e26);
    }
    vec4 _e29 = film.sums;
    vec3 _e31 = p.radiance;
    vec4 _e36 = film.squares;
    vec3 _e38 = p.radiance;
    vec3 _e40 = p.radiance;
    Film _tmp_return = Film((_e29 + vec4(_e31, 1.0)), (_e36 + vec4((_e38 * _e40), 0.0)));
    _fs2p_location0 = _tmp_return.sums;
    _fs2p_location1 = _tmp_return.squares;
    return;
}

