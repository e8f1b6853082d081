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
    uint number;
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
const uint conductor = 2u;
const uint dielectric = 3u;
const uint instances = 2147483648u;

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

layout(location = 0) out vec4 _fs2p_location0;
layout(location = 1) out vec4 _fs2p_location1;

uint pcg(uint x) {
    uint s_6 = ((x * 747796405u) + 2891336453u);
    uint w_1 = (((s_6 >> ((s_6 >> 28u) + 4u)) ^ s_6) * 277803737u);
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
    uint y_5 = ((x_1 | (x_1 * 4u)) & 51u);
    return ((y_5 | (y_5 * 2u)) & 85u);
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
    uint _e19 = spread((pixel_1.x & 15u));
    uint _e23 = spread((pixel_1.y & 15u));
    uint place = (_e19 | (_e23 * 2u));
    uvec2 _e32 = reversed(uvec2((sampleIndex_1 & 65535u), (place * 256u)));
    uvec2 digits = pick(independent, uvec2(0u), _e32);
    uint _e38 = mixBits((_e15 ^ 1779033703u));
    return Sampler(_e15, _e38, digits.x, digits.y);
}

float filterAxis(float u) {
    float across = ((2.0 * u) - 1.0);
    float x_11 = (16.0 - (16.0 * sqrt((1.0 - abs(across)))));
    float piece = min(floor(x_11), 15.0);
    float t_2 = (x_11 - piece);
    vec4 c = frame.filterPieces[uint(piece)];
    float offset_2 = (c.x + (t_2 * (c.y + (t_2 * (c.z + (t_2 * c.w))))));
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
    uvec2 b_2 = (half_ ^ (half_ >> uvec2(16u)));
    uvec2 _e19 = scramble(uvec2(s.place), b_2);
    uvec2 own = (s.sample_ * ((_e19 >> uvec2(7u)) & uvec2(4294967294u)));
    uvec2 _e31 = scramble((uvec2(s.sample_) ^ own), _e7);
    uvec2 _e35 = reversed((_e31 & uvec2(65535u)));
    uvec2 _e39 = shiftOfPlace((_e19 & uvec2(255u)));
    return Groups(_e35, _e39, ((_e7 >> uvec2(16u)) | (_e7 * 65536u)), ((b_2 >> uvec2(16u)) | (b_2 * 65536u)));
}

void skipGroup(inout Sampler s_1) {
    uint _e3 = s_1.key;
    s_1.key = (_e3 + 1u);
    return;
}

vec2 toUnit(uvec2 scrambled) {
    uvec2 _e4 = reversedHigh((scrambled & uvec2(65535u)));
    vec2 digits_1 = (vec2(ivec2(_e4)) * 4.656613e-10);
    return (digits_1 + (vec2((scrambled & uvec2(4278190080u))) * 3.5527137e-15));
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
    vec2 p_7 = ((2.0 * u_2) - vec2(1.0));
    bool wide = (abs(p_7.x) > abs(p_7.y));
    float radius_1 = pick(wide, p_7.x, p_7.y);
    float ratio = (pick(wide, p_7.y, p_7.x) / pick((radius_1 == 0.0), 1.0, radius_1));
    float angle = pick(wide, (0.7853982 * ratio), (1.5707964 - (0.7853982 * ratio)));
    return (radius_1 * vec2(cos(angle), sin(angle)));
}

CameraRay rayThroughLens(vec2 filmPosition, vec2 lensPoint) {
    CameraRay ray = CameraRay(vec3(0.0), vec3(0.0));
    float _e7 = frame.width;
    float x_12 = (((2.0 * filmPosition.x) / _e7) - 1.0);
    float _e16 = frame.height;
    float y_6 = (1.0 - ((2.0 * filmPosition.y) / _e16));
    vec3 _e22 = frame.right;
    vec3 _e26 = frame.up;
    vec3 across_1 = ((x_12 * _e22) + (y_6 * _e26));
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
            float longitude = (3.1415927 * x_12);
            float latitude = (1.5707964 * y_6);
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

RayPair oneRay(vec3 origin, vec3 direction, uint number) {
    return RayPair(origin, noShape, noTriangle, 0.0, true, direction, false, direction, false, -1.0, noShape, number);
}

uint numberOfNext(Sampler s_3) {
    uint _e8 = mixBits((((s_3.key + 1u) ^ s_3.salt) ^ 2246822507u));
    uint _e15 = mixBits((_e8 + ((s_3.sample_ << 8u) | s_3.place)));
    return _e15;
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
    float far = (along + half_1);
    float t_3 = pick((near > tMin), near, far);
    return pick(startsInside, max(far, 0.0), pick(pick((discriminant >= 0.0), (t_3 > tMin), false), t_3, 1e30));
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
    vec4 _e2 = tableTexel(1u, i_3);
    vec4 _e4 = tableTexel(2u, i_3);
    return Extent(_e2.xyzw, _e4.xyzw);
}

vec3 rotate(vec4 q, vec3 v) {
    vec3 t_4 = (2.0 * cross(q.xyz, v));
    return ((v + (q.w * t_4)) + cross(q.xyz, t_4));
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
    float t_5 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_5 > tMin_1), false), t_5, 1e30));
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
    float t_6 = (dot(toCenter_1, normal_2) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_8 = ((t_6 * direction_4) - toCenter_1);
    bool within = (max(abs(dot(p_8, reciprocalU)), abs(dot(p_8, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_6 > tMin_2), (t_6 < 1e30), false), within, false), t_6, 1e30);
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
    float t_7 = ((offset_1 - dot(origin_6, normal)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset_1 > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_7 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset_1 == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_7, 0.0), 1e30);
}

PairHit meetPlane(PairHit found_4, RayPair p_4, uint i_6) {
    Bounds _e3 = fetchBounds(i_6);
    float _e9 = intersectPlane(p_4.point, p_4.direction, _e3.center, _e3.radius, p_4.tMin);
    float _e15 = intersectPlane(p_4.point, p_4.lightDirection, _e3.center, _e3.radius, p_4.tMin);
    PairHit _e17 = meet(found_4, p_4, i_6, vec2(_e9, _e15));
    return _e17;
}

PairHit tracePair(RayPair p_5) {
    PairHit found_5 = PairHit(1e30, 4294967295u, false, LeftTriangle(4294967295u, 0u), vec2(0.0));
    uint i_7 = 0u;
    uvec4 ends = frame.shapeEnds;
    const bool _e17 = hasSpheres;
    if (_e17) {
        uint _e18 = i_7;
        if ((_e18 < ends.x)) {
            while(true) {
                PairHit _e21 = found_5;
                uint _e22 = i_7;
                PairHit _e23 = meetSphere(_e21, p_5, _e22);
                found_5 = _e23;
                uint _e25 = i_7;
                i_7 = (_e25 + 1u);
                uint _e27 = i_7;
                if ((_e27 >= ends.x)) {
                    break;
                }
            }
        }
    }
    const bool _e31 = hasBoxes;
    if (_e31) {
        uint _e32 = i_7;
        if ((_e32 < ends.y)) {
            while(true) {
                PairHit _e35 = found_5;
                uint _e36 = i_7;
                PairHit _e37 = meetBox(_e35, p_5, _e36);
                found_5 = _e37;
                uint _e39 = i_7;
                i_7 = (_e39 + 1u);
                uint _e41 = i_7;
                if ((_e41 >= ends.y)) {
                    break;
                }
            }
        }
    }
    const bool _e45 = hasQuads;
    if (_e45) {
        uint _e46 = i_7;
        if ((_e46 < ends.z)) {
            while(true) {
                PairHit _e49 = found_5;
                uint _e50 = i_7;
                PairHit _e51 = meetQuad(_e49, p_5, _e50);
                found_5 = _e51;
                uint _e53 = i_7;
                i_7 = (_e53 + 1u);
                uint _e55 = i_7;
                if ((_e55 >= ends.z)) {
                    break;
                }
            }
        }
    }
    const bool _e59 = hasPlanes;
    if (_e59) {
        uint _e60 = i_7;
        if ((_e60 < ends.w)) {
            while(true) {
                PairHit _e63 = found_5;
                uint _e64 = i_7;
                PairHit _e65 = meetPlane(_e63, p_5, _e64);
                found_5 = _e65;
                uint _e67 = i_7;
                i_7 = (_e67 + 1u);
                uint _e69 = i_7;
                if ((_e69 >= ends.w)) {
                    break;
                }
            }
        }
    }
    PairHit _e72 = found_5;
    return _e72;
}

Sight look(uvec2 pixel_2) {
    Sampler s_4 = Sampler(0u, 0u, 0u, 0u);
    uint _e3 = frame.sampleIndex;
    uint _e6 = frame.seed;
    Sampler _e7 = startSampler(pixel_2, _e3, _e6);
    s_4 = _e7;
    vec2 _e12 = frame.jitter;
    vec2 _e14 = next2d(s_4);
    vec2 _e15 = filterOffset(_e14);
    vec2 filmPosition_2 = ((vec2(pixel_2) + _e12) + _e15);
    vec2 _e17 = next2d(s_4);
    CameraRay _e18 = cameraRay(filmPosition_2, _e17);
    Sampler _e21 = s_4;
    uint _e22 = numberOfNext(_e21);
    RayPair _e23 = oneRay(_e18.origin, _e18.direction, _e22);
    vec2 offCentre = ((filmPosition_2 - vec2(pixel_2)) - vec2(0.5));
    PairHit _e29 = tracePair(_e23);
    return Sight(_e23, _e29, (1.0 / (1.0 + dot(offCentre, offCentre))));
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
    float t_8 = pick(entering, _e5.near, _e5.far);
    vec3 side = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_6, vec3(0.0))));
    bool onX = (crossed.x == t_8);
    bool onY = pick(!(onX), (crossed.y == t_8), false);
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

vec3 normalAt(RayPair p_6, float t_1, uint i_11) {
    vec3 normal_1 = vec3(0.0);
    Bounds _e3 = fetchBounds(i_11);
    vec3 origin_8 = (p_6.point - _e3.center);
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
        bool inside = pick((i_11 == p_6.shape), p_6.inwards, false);
        vec3 _e28 = turned(_e22.a, origin_8);
        vec3 _e31 = turned(_e22.a, p_6.direction);
        vec3 _e35 = boxNormal(_e28, _e31, _e22.b.xyz, p_6.tMin, inside);
        vec3 _e36 = normal_1;
        vec3 _e38 = turnedBack(_e22.a, _e35);
        bool _e39 = isBox(i_11);
        normal_1 = pick(_e39, _e38, _e36);
    }
    const bool _e42 = hasSpheres;
    if (_e42) {
        vec3 outwards = (origin_8 + (t_1 * p_6.direction));
        vec3 _e46 = normal_1;
        bool _e53 = isSphere(i_11);
        normal_1 = pick(_e53, pick((dot(outwards, outwards) == 0.0), -(p_6.direction), outwards), _e46);
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

vec3 conductorFresnel(float cosine, vec3 eta, vec3 k) {
    float cosine2_ = (cosine * cosine);
    float sine2_ = (1.0 - cosine2_);
    vec3 difference = (((eta * eta) - (k * k)) - vec3(sine2_));
    vec3 a2PlusB2_ = sqrt(((difference * difference) + ((((4.0 * eta) * eta) * k) * k)));
    vec3 larger_1 = sqrt(((0.5 * (a2PlusB2_ + abs(difference))) + vec3(1e-20)));
    vec3 smaller_1 = ((eta * k) / larger_1);
    vec3 a_2 = mix(smaller_1, larger_1, greaterThan(difference, vec3(0.0)));
    vec3 b_3 = mix(larger_1, smaller_1, greaterThan(difference, vec3(0.0)));
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

vec3 albedoOf(Surface s_5, bool fromBack) {
    vec3 albedo = vec3(0.0);
    uint _e4 = kindOf(uint(s_5.code));
    albedo = s_5.baseColor;
    if ((_e4 == conductor)) {
        vec3 _e13 = conductorReflectance(s_5.baseColor, s_5.eta, s_5.k, 1.0);
        albedo = _e13;
    }
    if ((_e4 == dielectric)) {
        albedo = vec3(1.0);
    }
    vec3 _e18 = albedo;
    albedo = mix(_e18, vec3(1.0), s_5.reflectivity);
    bool dark = pick(((uint(s_5.code) & 16u) != 0u), fromBack, false);
    vec3 emission = pick(dark, vec3(0.0), s_5.emission);
    float brightest = max(max(emission.x, emission.y), max(emission.z, 1.0));
    vec3 _e41 = albedo;
    return clamp((_e41 + (emission / vec3(brightest))), vec3(0.0), vec3(1.0));
}

Material fetchMaterial(uint i_13) {
    vec4 _e2 = tableTexel(3u, i_13);
    vec4 _e4 = tableTexel(4u, i_13);
    return Material(_e2.xyz, _e2.w, _e4.x, _e4.y, _e4.z, _e4.w);
}

vec4 larger(vec4 a, vec4 b) {
    return intBitsToFloat(max(floatBitsToInt(a), floatBitsToInt(b)));
}

vec4 smaller(vec4 a_1, vec4 b_1) {
    return intBitsToFloat(min(floatBitsToInt(a_1), floatBitsToInt(b_1)));
}

void main() {
    vec4 fragment_1 = gl_FragCoord;
    Layers data = Layers(vec4(0.0), vec4(0.0));
    uvec2 texel = uvec2(fragment_1.xy);
    uvec2 _e5 = frame.origin;
    Sight _e7 = look((_e5 + texel));
    uint shape_1 = _e7.hit.shape;
    data = Layers(vec4(0.0), vec4(0.0, 0.0, 0.0, _e7.closeness));
    if ((shape_1 != noShape)) {
        Material _e30 = fetchMaterial(shape_1);
        data.first = vec4((_e7.rays.point + (_e7.hit.t * _e7.rays.direction)), _e30.id);
        SurfacePoint _e36 = surfaceAt(_e7.rays, _e7.hit, shape_1);
        data.second = vec4(_e36.geometric, _e7.closeness);
    }
    uint _e42 = frame.sampleIndex;
    if ((_e42 > 0u)) {
        vec4 _e47 = texelFetch(previousFirst, ivec2(texel), 0);
        vec4 _e50 = texelFetch(previousSecond, ivec2(texel), 0);
        Layers previous = Layers(_e47, _e50);
        if ((previous.second.w >= _e7.closeness)) {
            Layers _tmp_return = previous;
            _fs2p_location0 = _tmp_return.first;
            _fs2p_location1 = _tmp_return.second;
            return;
        }
    }
    Layers _e56 = data;
    _fs2p_location0 = _e56.first;
    _fs2p_location1 = _e56.second;
    return;
}

