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

struct Layers {
    vec4 first;
    vec4 second;
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
struct PairHit {
    float t;
    uint shape;
    bool blocked;
    LeftTriangle triangle;
    vec2 weights;
};
struct Sight {
    RayPair rays;
    PairHit hit;
    float closeness;
};
struct Sampler {
    uint key;
    uint salt;
    uint sample_;
    uint place;
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
    uint interpolated;
    uint row;
};
struct Triangle {
    vec3 a;
    uint normalA;
    vec3 b;
    uint normalB;
    vec3 c;
    uint normalC;
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
    float layers;
};
struct Normals {
    vec3 geometric;
    vec3 shading;
};
struct MeshNormals {
    vec3 geometric;
    vec3 shading;
};
struct Material {
    vec3 baseColor;
    float reflectivity;
    float specular;
    float exponent;
    float id;
    float spare;
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
const uint instanceRows = 4u;
const uint triangleRows = 3u;
const uint countShift = 28u;
const uint dielectric = 3u;
const uint conductor = 2u;

uniform highp sampler2D previousFirst;

uniform highp sampler2D previousSecond;

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

const bool hasLayers = false;

layout(location = 0) out vec4 _fs2p_location0;
layout(location = 1) out vec4 _fs2p_location1;

uint pcg(uint x) {
    uint s_4 = ((x * 747796405u) + 2891336453u);
    uint w_1 = (((s_4 >> ((s_4 >> 28u) + 4u)) ^ s_4) * 277803737u);
    return ((w_1 >> 22u) ^ w_1);
}

uint pixelHash(uvec2 pixel, uint sampleIndex, uint seed) {
    uint _e5 = pcg(seed);
    uint _e7 = pcg((sampleIndex + _e5));
    uint _e9 = pcg((pixel.y + _e7));
    uint _e11 = pcg((pixel.x + _e9));
    return _e11;
}

uint spread(uint x_1) {
    uint y_5 = ((x_1 | (x_1 << 2u)) & 51u);
    return ((y_5 | (y_5 << 1u)) & 85u);
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
    uint _e19 = spread((pixel_1.x & 15u));
    uint _e23 = spread((pixel_1.y & 15u));
    uint place_1 = (_e19 | (_e23 << 1u));
    uint _e32 = reverseHalves(((sampleIndex_1 & 65535u) | (place_1 << 24u)));
    uint used = pick(independent, 0u, _e32);
    uint _e37 = mixBits((_e15 ^ 1779033703u));
    return Sampler(_e15, _e37, (used & 65535u), (used >> 16u));
}

float filterAxis(float u) {
    float across = ((2.0 * u) - 1.0);
    float x_9 = (16.0 - (16.0 * sqrt((1.0 - abs(across)))));
    float piece = min(floor(x_9), 15.0);
    float t_3 = (x_9 - piece);
    vec4 c = frame.filterPieces[uint(piece)];
    float offset_3 = (c.x + (t_3 * (c.y + (t_3 * (c.z + (t_3 * c.w))))));
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
    uint b_1 = (half_ ^ (half_ >> 16u));
    uint _e18 = s.place;
    uint _e19 = scramble(_e18, b_1);
    uint _e21 = s.sample_;
    uint own = (_e21 * ((_e19 >> 7u) & 4294967294u));
    uint _e28 = s.sample_;
    uint _e30 = scramble((_e28 ^ own), _e8);
    uint _e33 = reverseHalves((_e30 & 65535u));
    uint _e36 = shiftOfPlace((_e19 & 255u));
    return Group(_e33, _e36, ((_e8 >> 16u) | (_e8 << 16u)), ((b_1 >> 16u) | (b_1 << 16u)));
}

vec2 next2d(inout Sampler s_1) {
    Group _e1 = nextGroup(s_1);
    vec2 _e2 = points2d(_e1);
    return _e2;
}

vec2 concentricDisc(vec2 u_2) {
    vec2 p_8 = ((2.0 * u_2) - vec2(1.0));
    bool wide = (abs(p_8.x) > abs(p_8.y));
    float radius_1 = pick(wide, p_8.x, p_8.y);
    float ratio = (pick(wide, p_8.y, p_8.x) / pick((radius_1 == 0.0), 1.0, radius_1));
    float angle = pick(wide, (0.7853982 * ratio), (1.5707964 - (0.7853982 * ratio)));
    return (radius_1 * vec2(cos(angle), sin(angle)));
}

CameraRay rayThroughLens(vec2 filmPosition, vec2 lensPoint) {
    CameraRay ray = CameraRay(vec3(0.0), vec3(0.0));
    float _e7 = frame.width;
    float x_10 = (((2.0 * filmPosition.x) / _e7) - 1.0);
    float _e16 = frame.height;
    float y_6 = (1.0 - ((2.0 * filmPosition.y) / _e16));
    vec3 _e22 = frame.right;
    vec3 _e26 = frame.up;
    vec3 across_1 = ((x_10 * _e22) + (y_6 * _e26));
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
        float longitude = (3.1415927 * x_10);
        float latitude = (1.5707964 * y_6);
        vec3 _e88 = frame.right;
        vec3 _e93 = frame.forward;
        vec3 level = ((sin(longitude) * _e88) + (cos(longitude) * _e93));
        vec3 _e103 = frame.up;
        ray = CameraRay(vec3(0.0), normalize(((cos(latitude) * level) + (sin(latitude) * _e103))));
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

RayPair oneRay(vec3 origin, vec3 direction) {
    return RayPair(origin, noShape, noTriangle, 0.0, true, direction, false, direction, false, -1.0, noShape);
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
    float far = (along + half_1);
    float t_4 = pick((near > tMin), near, far);
    return pick(startsInside, max(far, 0.0), pick(pick((discriminant >= 0.0), (t_4 > tMin), false), t_4, 1e30));
}

PairHit meet(PairHit found, RayPair p, uint i_1, vec2 t) {
    bool own_1 = (i_1 == p.shape);
    float pathT = pick(pick(own_1, !(p.inwards), false), 1e30, t.x);
    float lightT = pick(pick(pick(own_1, !(p.lightInwards), false), true, (i_1 == p.lightShape)), 1e30, t.y);
    bool nearer = (pathT < found.t);
    return PairHit(pick(nearer, pathT, found.t), pick(nearer, i_1, found.shape), pick(found.blocked, true, (lightT < p.lightDistance)), noTriangle, vec2(0.0));
}

PairHit meetSphere(PairHit found_1, RayPair p_1, uint i_2) {
    Bounds _e3 = fetchBounds(i_2);
    bool own_2 = (i_2 == p_1.shape);
    float _e13 = intersectSphere(p_1.point, p_1.direction, _e3.center, _e3.radius, p_1.tMin, pick(own_2, p_1.inwards, false));
    float _e21 = intersectSphere(p_1.point, p_1.lightDirection, _e3.center, _e3.radius, p_1.tMin, pick(own_2, p_1.lightInwards, false));
    PairHit _e23 = meet(found_1, p_1, i_2, vec2(_e13, _e21));
    return _e23;
}

Extent fetchExtent(uint i_3) {
    vec4 t0_1 = texelFetch(sceneTable, ivec2(uvec2(1u, i_3)), 0);
    vec4 t1_ = texelFetch(sceneTable, ivec2(uvec2(2u, i_3)), 0);
    return Extent(t0_1.xyzw, t1_.xyzw);
}

vec3 rotate(vec4 q, vec3 v) {
    vec3 t_5 = (2.0 * cross(q.xyz, v));
    return ((v + (q.w * t_5)) + cross(q.xyz, t_5));
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
    float t_6 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_6 > tMin_1), false), t_6, 1e30));
}

PairHit meetBox(PairHit found_2, RayPair p_2, uint i_4) {
    Bounds _e3 = fetchBounds(i_4);
    Extent _e4 = fetchExtent(i_4);
    bool own_3 = (i_4 == p_2.shape);
    vec3 _e11 = turned(_e4.a, (p_2.point - _e3.center));
    vec3 _e14 = turned(_e4.a, p_2.direction);
    float _e20 = intersectBox(_e11, _e14, _e4.b.xyz, p_2.tMin, pick(own_3, p_2.inwards, false));
    vec3 _e23 = turned(_e4.a, p_2.lightDirection);
    float _e29 = intersectBox(_e11, _e23, _e4.b.xyz, p_2.tMin, pick(own_3, p_2.lightInwards, false));
    PairHit _e31 = meet(found_2, p_2, i_4, vec2(_e20, _e29));
    return _e31;
}

float intersectQuad(vec3 origin_5, vec3 direction_4, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_2 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_4, normal_2);
    vec3 toCenter_1 = (center_1 - origin_5);
    float t_7 = (dot(toCenter_1, normal_2) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_9 = ((t_7 * direction_4) - toCenter_1);
    bool within = (max(abs(dot(p_9, reciprocalU)), abs(dot(p_9, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_7 > tMin_2), (t_7 < 1e30), false), within, false), t_7, 1e30);
}

PairHit meetQuad(PairHit found_3, RayPair p_3, uint i_5) {
    Bounds _e3 = fetchBounds(i_5);
    Extent _e4 = fetchExtent(i_5);
    float _e13 = intersectQuad(p_3.point, p_3.direction, _e3.center, _e4.a.xyz, _e4.b.xyz, p_3.tMin);
    float _e22 = intersectQuad(p_3.point, p_3.lightDirection, _e3.center, _e4.a.xyz, _e4.b.xyz, p_3.tMin);
    PairHit _e24 = meet(found_3, p_3, i_5, vec2(_e13, _e22));
    return _e24;
}

float intersectPlane(vec3 origin_6, vec3 direction_5, vec3 normal, float offset_1, float tMin_3) {
    float speed_1 = dot(direction_5, normal);
    float t_8 = ((offset_1 - dot(origin_6, normal)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset_1 > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_8 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset_1 == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_8, 0.0), 1e30);
}

PairHit meetPlane(PairHit found_4, RayPair p_4, uint i_6) {
    Bounds _e3 = fetchBounds(i_6);
    float _e9 = intersectPlane(p_4.point, p_4.direction, _e3.center, _e3.radius, p_4.tMin);
    float _e15 = intersectPlane(p_4.point, p_4.lightDirection, _e3.center, _e3.radius, p_4.tMin);
    PairHit _e17 = meet(found_4, p_4, i_6, vec2(_e9, _e15));
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
    uvec3 far_1 = (uvec3(3u, 5u, 7u) - r.near);
    vec4 _e17 = planes((node + r.near.x), r.inverse_.x, r.offset.x);
    vec4 _e25 = planes((node + r.near.y), r.inverse_.y, r.offset.y);
    vec4 _e34 = planes((node + r.near.z), r.inverse_.z, r.offset.z);
    vec4 near4_ = max(max(_e17, _e25), max(_e34, vec4(0.0)));
    vec4 _e45 = planes((node + far_1.x), r.inverse_.x, r.offset.x);
    vec4 _e52 = planes((node + far_1.y), r.inverse_.y, r.offset.y);
    vec4 _e60 = planes((node + far_1.z), r.inverse_.z, r.offset.z);
    vec4 far4_ = min(min(_e45, _e52), _e60);
    vec4 entered = mix(vec4(1e30), near4_, lessThanEqual(near4_, min((far4_ * 1.000001), vec4(t_1))));
    return mix(vec4(1e30), entered, notEqual(children, uvec4(0u)));
}

Instance fetchInstance(uint row_1) {
    uvec4 _e3 = geometryRow((row_1 + 0u));
    uvec4 _e6 = geometryRow((row_1 + 1u));
    uvec4 _e9 = geometryRow((row_1 + 2u));
    uvec4 _e12 = geometryRow((row_1 + 3u));
    return Instance(uintBitsToFloat(_e3.xyzw), uintBitsToFloat(_e6.xyzw), uintBitsToFloat(_e9.xyzw), _e12.x, _e12.y, _e12.z, _e12.w);
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
    uint axis_1 = pick((size.z >= max(size.x, size.y)), 2u, pick((size.y > size.x), 1u, 0u));
    vec3 _e16 = turnedTo(axis_1, direction_7);
    return MeshRay(origin_8, axis_1, vec3((-(_e16.xy) / vec2(_e16.z)), (1.0 / _e16.z)));
}

float edge(vec2 a, vec2 b) {
    float p_10 = (a.x * b.y);
    float q_3 = (a.y * b.x);
    return ((a.x * b.y + -(q_3)) - (a.y * b.x + -(p_10)));
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
    float t_9 = ((ray_1.shear.z * (((_e35 * _e6.z) + (_e36 * _e11.z)) + (_e37 * _e16.z))) * inverse_2);
    return TriangleHit(pick(pick(within_1, (sum != 0.0), false), t_9, -1.0), (vec2(_e36, _e37) * inverse_2));
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
            uint node_1 = (_e70 + (_e71 * nodeRows));
            uvec4 _e77 = geometryRow((node_1 + childrenRow));
            SlabRay _e78 = slabs;
            float _e79 = most;
            vec4 _e80 = enterChildren(node_1, _e78, _e77, _e79);
            bool a_1 = (_e80.x < _e80.z);
            bool b_2 = (_e80.y < _e80.w);
            vec2 t0_2 = pick(a_1, vec2(_e80.z, _e80.x), vec2(_e80.x, _e80.z));
            uvec2 r0_ = pick(a_1, uvec2(_e77.z, _e77.x), uvec2(_e77.x, _e77.z));
            vec2 t1_1 = pick(b_2, vec2(_e80.w, _e80.y), vec2(_e80.y, _e80.w));
            uvec2 r1_ = pick(b_2, uvec2(_e77.w, _e77.y), uvec2(_e77.y, _e77.w));
            bool c_1 = (t0_2.x < t1_1.x);
            bool d_2 = (t0_2.y < t1_1.y);
            vec2 ta = pick(c_1, vec2(t1_1.x, t0_2.x), vec2(t0_2.x, t1_1.x));
            uvec2 ra = pick(c_1, uvec2(r1_.x, r0_.x), uvec2(r0_.x, r1_.x));
            vec2 tb = pick(d_2, vec2(t1_1.y, t0_2.y), vec2(t0_2.y, t1_1.y));
            uvec2 rb = pick(d_2, uvec2(r1_.y, r0_.y), uvec2(r0_.y, r1_.y));
            bool e = (ta.y < tb.x);
            vec2 tm = pick(e, vec2(tb.x, ta.y), vec2(ta.y, tb.x));
            uvec2 rm = pick(e, uvec2(rb.x, ra.y), uvec2(ra.y, rb.x));
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
                bool toWorld = (_e207 >= beginning);
                uint _e210 = current;
                pops = (_e210 == leaving);
                uint _e213 = current;
                instance = pick(toWorld, noInstance, (_e213 & placeMask));
                o = rays.origin;
                bool _e222 = toLight;
                d_1 = pick(_e222, rays.lightDirection, rays.direction);
                nodes = 0u;
                if (!(toWorld)) {
                    uint _e229 = frame.instances;
                    uint _e230 = instance;
                    Instance _e234 = fetchInstance((_e229 + (_e230 * instanceRows)));
                    vec3 _e235 = o;
                    vec4 p_11 = vec4(_e235, 1.0);
                    o = vec3(dot(_e234.toMeshX, p_11), dot(_e234.toMeshY, p_11), dot(_e234.toMeshZ, p_11));
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
                uint place_2 = (_e275 & placeMask);
                MeshRay _e278 = ray_2;
                uint _e279 = triangles;
                Triangle _e283 = fetchTriangle((_e279 + (place_2 * triangleRows)));
                TriangleHit _e284 = intersectTriangle(_e278, _e283);
                uint _e285 = instance;
                bool own_4 = pick((_e285 == left.instance), (place_2 == left.triangle), false);
                float _e295 = most;
                bool nearer_1 = pick(pick((_e284.t > rays.least), (_e284.t < _e295), false), !(own_4), false);
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
                    found_5 = MeshHit(_e284.t, _e317, place_2, _e284.weights, false);
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

PairHit meetMeshes(PairHit found_6, RayPair p_5) {
    PairHit result = PairHit(0.0, 0u, false, LeftTriangle(0u, 0u), vec2(0.0));
    float most_1 = pick(p_5.goesOn, found_6.t, -1.0);
    float lightMost = pick(found_6.blocked, -1.0, p_5.lightDistance);
    MeshHit _e16 = traverse(MeshRays(p_5.point, p_5.direction, p_5.lightDirection, p_5.tMin, most_1, lightMost), p_5.left);
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

PairHit tracePair(RayPair p_6) {
    PairHit found_7 = PairHit(1e30, 4294967295u, false, LeftTriangle(4294967295u, 0u), vec2(0.0));
    uint i_8 = 0u;
    uvec4 ends = frame.shapeEnds;
    const bool _e17 = hasSpheres;
    uint _e18 = i_8;
    if (pick(_e17, (_e18 < ends.x), false)) {
        while(true) {
            PairHit _e22 = found_7;
            uint _e23 = i_8;
            PairHit _e24 = meetSphere(_e22, p_6, _e23);
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
            PairHit _e39 = meetBox(_e37, p_6, _e38);
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
            PairHit _e54 = meetQuad(_e52, p_6, _e53);
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
            PairHit _e69 = meetPlane(_e67, p_6, _e68);
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
        PairHit _e79 = meetMeshes(_e78, p_6);
        found_7 = _e79;
    }
    PairHit _e80 = found_7;
    return _e80;
}

Sight look(vec2 fragment_2) {
    Sampler s_2 = Sampler(0u, 0u, 0u, 0u);
    uint _e4 = frame.sampleIndex;
    uint _e7 = frame.seed;
    Sampler _e8 = startSampler(uvec2(fragment_2), _e4, _e7);
    s_2 = _e8;
    vec2 _e13 = frame.jitter;
    vec2 _e15 = next2d(s_2);
    vec2 _e16 = filterOffset(_e15);
    vec2 filmPosition_2 = ((floor(fragment_2) + _e13) + _e16);
    vec2 _e18 = next2d(s_2);
    CameraRay _e19 = cameraRay(filmPosition_2, _e18);
    RayPair _e22 = oneRay(_e19.origin, _e19.direction);
    vec2 offCentre = ((filmPosition_2 - floor(fragment_2)) - vec2(0.5));
    PairHit _e28 = tracePair(_e22);
    return Sight(_e22, _e28, (1.0 / (1.0 + dot(offCentre, offCentre))));
}

Surface fetchSurface(uint i_9) {
    vec4 t0_3 = texelFetch(sceneTable, ivec2(uvec2(9u, i_9)), 0);
    vec4 t1_2 = texelFetch(sceneTable, ivec2(uvec2(10u, i_9)), 0);
    vec4 t2_ = texelFetch(sceneTable, ivec2(uvec2(11u, i_9)), 0);
    vec4 t3_ = texelFetch(sceneTable, ivec2(uvec2(12u, i_9)), 0);
    vec4 t4_ = texelFetch(sceneTable, ivec2(uvec2(13u, i_9)), 0);
    return Surface(t0_3.xyz, t0_3.w, t1_2.xyz, t1_2.w, t2_.xyz, t2_.w, t3_.xyz, t3_.w, t4_.xyz, t4_.w);
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
    float t_10 = pick(entering, _e5.near, _e5.far);
    vec3 side = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_8, vec3(0.0))));
    bool onX = (crossed.x == t_10);
    bool onY = pick(!(onX), (crossed.y == t_10), false);
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

vec3 normalAt(RayPair p_7, float t_2, uint i_13) {
    vec3 normal_1 = vec3(0.0);
    Bounds _e3 = fetchBounds(i_13);
    vec3 origin_10 = (p_7.point - _e3.center);
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
        bool inside = pick((i_13 == p_7.shape), p_7.inwards, false);
        vec3 _e28 = turned(_e22.a, origin_10);
        vec3 _e31 = turned(_e22.a, p_7.direction);
        vec3 _e35 = boxNormal(_e28, _e31, _e22.b.xyz, p_7.tMin, inside);
        vec3 _e36 = normal_1;
        vec3 _e38 = turnedBack(_e22.a, _e35);
        bool _e39 = isBox(i_13);
        normal_1 = pick(_e39, _e38, _e36);
    }
    const bool _e42 = hasSpheres;
    if (_e42) {
        vec3 _e43 = normal_1;
        bool _e47 = isSphere(i_13);
        normal_1 = pick(_e47, (origin_10 + (t_2 * p_7.direction)), _e43);
    }
    vec3 _e49 = normal_1;
    return normalize(_e49);
}

vec3 fromOctahedral(uint code) {
    vec2 p_12 = ((vec2(float((code & 65535u)), float((code >> 16u))) * 3.051851e-5) - vec2(1.0));
    float z = ((1.0 - abs(p_12.x)) - abs(p_12.y));
    vec2 folded = ((vec2(1.0) - abs(p_12.yx)) * mix(vec2(1.0), vec2(-1.0), lessThan(p_12, vec2(0.0))));
    return normalize(vec3(pick((z < 0.0), folded, p_12), z));
}

MeshNormals meshNormals(uint instance_2, uint place, vec2 weights) {
    uint _e5 = frame.instances;
    Instance _e9 = fetchInstance((_e5 + (instance_2 * instanceRows)));
    Triangle _e14 = fetchTriangle((_e9.triangles + (place * triangleRows)));
    vec3 normal_3 = cross((_e14.b - _e14.a), (_e14.c - _e14.a));
    vec3 geometric = normalize((mat3x3(_e9.toMeshX.xyz, _e9.toMeshY.xyz, _e9.toMeshZ.xyz) * normal_3));
    vec3 _e37 = fromOctahedral(_e14.normalA);
    vec3 _e41 = fromOctahedral(_e14.normalB);
    vec3 _e46 = fromOctahedral(_e14.normalC);
    vec3 blended = (((((1.0 - weights.x) - weights.y) * _e37) + (weights.x * _e41)) + (weights.y * _e46));
    vec3 smoothed = (mat3x3(_e9.toMeshX.xyz, _e9.toMeshY.xyz, _e9.toMeshZ.xyz) * blended);
    float size_1 = dot(smoothed, smoothed);
    float side_1 = pick((dot(smoothed, geometric) < 0.0), -1.0, 1.0);
    bool useful = pick((_e9.interpolated != 0u), (size_1 > 0.0), false);
    return MeshNormals(geometric, pick(useful, (smoothed * (side_1 * inversesqrt(max(size_1, 1e-37)))), geometric));
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

uint kindOf(uint code_1) {
    return (code_1 & 3u);
}

bool isDielectric(uint code_2) {
    const bool _e2 = hasGlass;
    uint _e3 = kindOf(code_2);
    return pick(_e2, (_e3 == dielectric), false);
}

bool letsThrough(uint code_3, float layers) {
    bool _e2 = isDielectric(code_3);
    const bool _e4 = hasLayers;
    return pick(_e2, true, pick(_e4, (layers < 0.0), false));
}

vec3 conductorFresnel(float cosine, vec3 eta, vec3 k) {
    float cosine2_ = (cosine * cosine);
    float sine2_ = (1.0 - cosine2_);
    vec3 difference = (((eta * eta) - (k * k)) - vec3(sine2_));
    vec3 a2PlusB2_ = sqrt(((difference * difference) + ((((4.0 * eta) * eta) * k) * k)));
    vec3 larger = sqrt(((0.5 * (a2PlusB2_ + abs(difference))) + vec3(1e-20)));
    vec3 smaller = ((eta * k) / larger);
    vec3 a_2 = mix(smaller, larger, greaterThan(difference, vec3(0.0)));
    vec3 b_3 = mix(larger, smaller, greaterThan(difference, vec3(0.0)));
    vec3 b2_ = ((b_3 * b_3) + vec3(1e-20));
    vec3 acrossFar = (a_2 + vec3(cosine));
    vec3 acrossNear = (a_2 - vec3(cosine));
    vec3 across_3 = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a_2 * cosine) + vec3(sine2_));
    vec3 alongNear = ((a_2 * cosine) - vec3(sine2_));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across_3) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor, vec3 eta_1, vec3 k_1, float cosine_1) {
    float constants = dot((eta_1 + k_1), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_1, eta_1, k_1);
    return pick((constants > 0.0), _e8, baseColor);
}

vec3 albedoOf(Surface s_3, bool fromBack) {
    vec3 albedo = vec3(0.0);
    uint _e4 = kindOf(uint(s_3.code));
    albedo = s_3.baseColor;
    if ((_e4 == conductor)) {
        vec3 _e13 = conductorReflectance(s_3.baseColor, s_3.eta, s_3.k, 1.0);
        albedo = _e13;
    }
    if ((_e4 == dielectric)) {
        albedo = vec3(1.0);
    }
    vec3 _e18 = albedo;
    albedo = mix(_e18, vec3(1.0), s_3.reflectivity);
    bool dark = pick(((uint(s_3.code) & 16u) != 0u), fromBack, false);
    vec3 emission = pick(dark, vec3(0.0), s_3.emission);
    float brightest = max(max(emission.x, emission.y), max(emission.z, 1.0));
    vec3 _e41 = albedo;
    return clamp((_e41 + (emission / vec3(brightest))), vec3(0.0), vec3(1.0));
}

Material fetchMaterial(uint i_14) {
    vec4 t0_4 = texelFetch(sceneTable, ivec2(uvec2(3u, i_14)), 0);
    vec4 t1_3 = texelFetch(sceneTable, ivec2(uvec2(4u, i_14)), 0);
    return Material(t0_4.xyz, t0_4.w, t1_3.x, t1_3.y, t1_3.z, t1_3.w);
}

void main() {
    vec4 fragment = gl_FragCoord;
    Layers sums = Layers(vec4(0.0), vec4(0.0));
    Sight _e2 = look(fragment.xy);
    uint _e11 = frame.sampleIndex;
    if ((_e11 > 0u)) {
        uvec2 pixel_2 = uvec2(fragment.xy);
        vec4 _e18 = texelFetch(previousFirst, ivec2(pixel_2), 0);
        vec4 _e21 = texelFetch(previousSecond, ivec2(pixel_2), 0);
        sums = Layers(_e18, _e21);
    }
    float _e25 = sums.first.w;
    sums.first.w = (_e25 + 1.0);
    uint shape_1 = _e2.hit.shape;
    if ((shape_1 != noShape)) {
        Surface _e32 = fetchSurface(shape_1);
        bool _e38 = letsThrough(uint(_e32.code), _e32.layers);
        Normals _e39 = normalsAt(_e2.rays, _e2.hit, shape_1, _e38);
        vec3 direction_9 = _e2.rays.direction;
        vec4 _e43 = sums.first;
        vec3 _e48 = albedoOf(_e32, (dot(_e39.geometric, direction_9) > 0.0));
        sums.first = (_e43 + vec4(_e48, 0.0));
        vec4 _e53 = sums.second;
        sums.second = (_e53 + vec4(pick((dot(_e39.shading, direction_9) > 0.0), -(_e39.shading), _e39.shading), 1.0));
    }
    Layers _e65 = sums;
    _fs2p_location0 = _e65.first;
    _fs2p_location1 = _e65.second;
    return;
}

