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
struct Start {
    vec3 point;
    uint leaves;
    uint inside;
    float tMin;
};
struct Ray {
    Start start;
    vec3 direction;
};
struct Hit {
    float t;
    uint shape;
};
struct Sight {
    Ray ray;
    Hit hit;
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
struct Material {
    vec3 baseColor;
    float reflectivity;
    float specular;
    float exponent;
    float id;
    float spare;
};
const uint noShape = 4294967295u;
const uint conductor = 2u;
const uint dielectric = 3u;

uniform highp sampler2D previousFirst;

uniform highp sampler2D previousSecond;

layout(std140) uniform FrameBlock { Frame frame; };

const bool hasFilter = false;

const bool hasLens = false;

const bool hasOtherProjections = false;

uniform highp sampler2D sceneTable;

layout(location = 0) out vec4 _fs2p_location0;
layout(location = 1) out vec4 _fs2p_location1;

uint pcg(uint x) {
    uint s_4 = ((x * 747796405u) + 2891336453u);
    uint w = (((s_4 >> ((s_4 >> 28u) + 4u)) ^ s_4) * 277803737u);
    return ((w >> 22u) ^ w);
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
    uint place = (_e19 | (_e23 << 1u));
    uint _e32 = reverseHalves(((sampleIndex_1 & 65535u) | (place << 24u)));
    uint used = pick(independent, 0u, _e32);
    uint _e37 = mixBits((_e15 ^ 1779033703u));
    return Sampler(_e15, _e37, (used & 65535u), (used >> 16u));
}

float filterAxis(float u) {
    float across = ((2.0 * u) - 1.0);
    float x_9 = (16.0 - (16.0 * sqrt((1.0 - abs(across)))));
    float piece = min(floor(x_9), 15.0);
    float t_2 = (x_9 - piece);
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
    uint b = (half_ ^ (half_ >> 16u));
    uint _e18 = s.place;
    uint _e19 = scramble(_e18, b);
    uint _e21 = s.sample_;
    uint own = (_e21 * ((_e19 >> 7u) & 4294967294u));
    uint _e28 = s.sample_;
    uint _e30 = scramble((_e28 ^ own), _e8);
    uint _e33 = reverseHalves((_e30 & 65535u));
    uint _e36 = shiftOfPlace((_e19 & 255u));
    return Group(_e33, _e36, ((_e8 >> 16u) | (_e8 << 16u)), ((b >> 16u) | (b << 16u)));
}

vec2 next2d(inout Sampler s_1) {
    Group _e1 = nextGroup(s_1);
    vec2 _e2 = points2d(_e1);
    return _e2;
}

vec2 concentricDisc(vec2 u_2) {
    vec2 p = ((2.0 * u_2) - vec2(1.0));
    bool wide = (abs(p.x) > abs(p.y));
    float radius_1 = pick(wide, p.x, p.y);
    float ratio = (pick(wide, p.y, p.x) / pick((radius_1 == 0.0), 1.0, radius_1));
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

Start onCamera(vec3 point) {
    return Start(point, noShape, noShape, 0.0);
}

Hit nearer(Hit hit, float t, uint shape) {
    return Hit(min(t, hit.t), pick((t < hit.t), shape, hit.shape));
}

float intersectSphere(vec3 origin, vec3 direction, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter = (center - origin);
    float along = dot(toCenter, direction);
    vec3 across_2 = (toCenter - (along * direction));
    float discriminant = ((radius * radius) - dot(across_2, across_2));
    float half_1 = sqrt(max(discriminant, 0.0));
    float near = (along - half_1);
    float far = (along + half_1);
    float t_3 = pick((near > tMin), near, far);
    return pick(startsInside, max(far, 0.0), pick(pick((discriminant >= 0.0), (t_3 > tMin), false), t_3, 1e30));
}

float hitSphere(uint i, Bounds bounds, Ray ray_1) {
    float _e13 = intersectSphere(ray_1.start.point, ray_1.direction, bounds.center, bounds.radius, ray_1.start.tMin, (i == ray_1.start.inside));
    return pick((i == ray_1.start.leaves), 1e30, _e13);
}

Bounds fetchBounds(uint i_1) {
    vec4 t0_ = texelFetch(sceneTable, ivec2(uvec2(0u, i_1)), 0);
    return Bounds(t0_.xyz, t0_.w);
}

Extent fetchExtent(uint i_2) {
    vec4 t0_1 = texelFetch(sceneTable, ivec2(uvec2(1u, i_2)), 0);
    vec4 t1_ = texelFetch(sceneTable, ivec2(uvec2(2u, i_2)), 0);
    return Extent(t0_1.xyzw, t1_.xyzw);
}

bool isTurned(vec4 q) {
    return any(notEqual(q.xyz, vec3(0.0)));
}

vec3 rotate(vec4 q_1, vec3 v) {
    vec3 t_4 = (2.0 * cross(q_1.xyz, v));
    return ((v + (q_1.w * t_4)) + cross(q_1.xyz, t_4));
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
    float t_5 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_5 > tMin_1), false), t_5, 1e30));
}

float hitBox(uint i_3, Bounds bounds_1, Ray ray_2) {
    vec3 origin_4 = vec3(0.0);
    vec3 direction_3 = vec3(0.0);
    Extent _e3 = fetchExtent(i_3);
    origin_4 = (ray_2.start.point - bounds_1.center);
    direction_3 = ray_2.direction;
    bool _e12 = isTurned(_e3.a);
    if (_e12) {
        vec3 _e14 = origin_4;
        vec3 _e15 = rotate(_e3.a, _e14);
        origin_4 = _e15;
        vec3 _e17 = direction_3;
        vec3 _e18 = rotate(_e3.a, _e17);
        direction_3 = _e18;
    }
    vec3 _e19 = origin_4;
    vec3 _e20 = direction_3;
    float _e28 = intersectBox(_e19, _e20, _e3.b.xyz, ray_2.start.tMin, (i_3 == ray_2.start.inside));
    return pick((i_3 == ray_2.start.leaves), 1e30, _e28);
}

float intersectQuad(vec3 origin_5, vec3 direction_4, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_1 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_4, normal_1);
    vec3 toCenter_1 = (center_1 - origin_5);
    float t_6 = (dot(toCenter_1, normal_1) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_1 = ((t_6 * direction_4) - toCenter_1);
    bool within = (max(abs(dot(p_1, reciprocalU)), abs(dot(p_1, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_6 > tMin_2), (t_6 < 1e30), false), within, false), t_6, 1e30);
}

float hitQuad(uint i_4, Bounds bounds_2, Ray ray_3) {
    Extent _e3 = fetchExtent(i_4);
    float _e14 = intersectQuad(ray_3.start.point, ray_3.direction, bounds_2.center, _e3.a.xyz, _e3.b.xyz, ray_3.start.tMin);
    return pick((i_4 == ray_3.start.leaves), 1e30, _e14);
}

float intersectPlane(vec3 origin_6, vec3 direction_5, vec3 normal, float offset_1, float tMin_3) {
    float speed_1 = dot(direction_5, normal);
    float t_7 = ((offset_1 - dot(origin_6, normal)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset_1 > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_7 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset_1 == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_7, 0.0), 1e30);
}

float hitPlane(uint i_5, Bounds bounds_3, Ray ray_4) {
    float _e10 = intersectPlane(ray_4.start.point, ray_4.direction, bounds_3.center, bounds_3.radius, ray_4.start.tMin);
    return pick((i_5 == ray_4.start.leaves), 1e30, _e10);
}

Hit closestHit(Ray ray_5) {
    Hit hit_1 = Hit(1e30, 4294967295u);
    uint i_6 = 0u;
    uvec4 ends = frame.shapeEnds;
    uint _e10 = i_6;
    if ((_e10 < ends.x)) {
        while(true) {
            Hit _e13 = hit_1;
            uint _e14 = i_6;
            uint _e15 = i_6;
            Bounds _e16 = fetchBounds(_e15);
            float _e17 = hitSphere(_e14, _e16, ray_5);
            uint _e18 = i_6;
            Hit _e19 = nearer(_e13, _e17, _e18);
            hit_1 = _e19;
            uint _e21 = i_6;
            i_6 = (_e21 + 1u);
            uint _e23 = i_6;
            if ((_e23 >= ends.x)) {
                break;
            }
        }
    }
    uint _e26 = i_6;
    if ((_e26 < ends.y)) {
        while(true) {
            Hit _e29 = hit_1;
            uint _e30 = i_6;
            uint _e31 = i_6;
            Bounds _e32 = fetchBounds(_e31);
            float _e33 = hitBox(_e30, _e32, ray_5);
            uint _e34 = i_6;
            Hit _e35 = nearer(_e29, _e33, _e34);
            hit_1 = _e35;
            uint _e37 = i_6;
            i_6 = (_e37 + 1u);
            uint _e39 = i_6;
            if ((_e39 >= ends.y)) {
                break;
            }
        }
    }
    uint _e42 = i_6;
    if ((_e42 < ends.z)) {
        while(true) {
            Hit _e45 = hit_1;
            uint _e46 = i_6;
            uint _e47 = i_6;
            Bounds _e48 = fetchBounds(_e47);
            float _e49 = hitQuad(_e46, _e48, ray_5);
            uint _e50 = i_6;
            Hit _e51 = nearer(_e45, _e49, _e50);
            hit_1 = _e51;
            uint _e53 = i_6;
            i_6 = (_e53 + 1u);
            uint _e55 = i_6;
            if ((_e55 >= ends.z)) {
                break;
            }
        }
    }
    uint _e58 = i_6;
    if ((_e58 < ends.w)) {
        while(true) {
            Hit _e61 = hit_1;
            uint _e62 = i_6;
            uint _e63 = i_6;
            Bounds _e64 = fetchBounds(_e63);
            float _e65 = hitPlane(_e62, _e64, ray_5);
            uint _e66 = i_6;
            Hit _e67 = nearer(_e61, _e65, _e66);
            hit_1 = _e67;
            uint _e69 = i_6;
            i_6 = (_e69 + 1u);
            uint _e71 = i_6;
            if ((_e71 >= ends.w)) {
                break;
            }
        }
    }
    Hit _e74 = hit_1;
    return _e74;
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
    Start _e21 = onCamera(_e19.origin);
    Ray ray_7 = Ray(_e21, _e19.direction);
    vec2 offCentre = ((filmPosition_2 - floor(fragment_2)) - vec2(0.5));
    Hit _e29 = closestHit(ray_7);
    return Sight(ray_7, _e29, (1.0 / (1.0 + dot(offCentre, offCentre))));
}

bool isSphere(uint i_7) {
    uint _e4 = frame.shapeEnds.x;
    return (i_7 < _e4);
}

bool isPlane(uint i_8) {
    uint _e4 = frame.shapeEnds.z;
    return (i_8 >= _e4);
}

bool isFlat(uint i_9) {
    uint _e4 = frame.shapeEnds.y;
    return (i_9 >= _e4);
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

vec3 rotateBack(vec4 q_2, vec3 v_1) {
    vec3 _e6 = rotate(vec4(-(q_2.xyz), q_2.w), v_1);
    return _e6;
}

vec3 outwardNormal(uint i_10, Ray ray_6, float t_1) {
    Bounds _e3 = fetchBounds(i_10);
    vec3 origin_8 = (ray_6.start.point - _e3.center);
    bool _e8 = isSphere(i_10);
    if (_e8) {
        return normalize((origin_8 + (t_1 * ray_6.direction)));
    }
    bool _e13 = isPlane(i_10);
    if (_e13) {
        return _e3.center;
    }
    Extent _e15 = fetchExtent(i_10);
    bool _e16 = isFlat(i_10);
    if (_e16) {
        return normalize(cross(_e15.a.xyz, _e15.b.xyz));
    }
    bool inside = (i_10 == ray_6.start.inside);
    vec3 _e27 = rotate(_e15.a, origin_8);
    vec3 _e30 = rotate(_e15.a, ray_6.direction);
    vec3 _e35 = boxNormal(_e27, _e30, _e15.b.xyz, ray_6.start.tMin, inside);
    vec3 _e37 = rotateBack(_e15.a, _e35);
    return _e37;
}

uint kindOf(uint code) {
    return (code & 3u);
}

vec3 conductorFresnel(float cosine, vec3 eta, vec3 k) {
    float cosine2_ = (cosine * cosine);
    float sine2_ = (1.0 - cosine2_);
    vec3 difference = (((eta * eta) - (k * k)) - vec3(sine2_));
    vec3 a2PlusB2_ = sqrt(((difference * difference) + ((((4.0 * eta) * eta) * k) * k)));
    vec3 larger = sqrt(((0.5 * (a2PlusB2_ + abs(difference))) + vec3(1e-20)));
    vec3 smaller = ((eta * k) / larger);
    vec3 a = mix(smaller, larger, greaterThan(difference, vec3(0.0)));
    vec3 b_1 = mix(larger, smaller, greaterThan(difference, vec3(0.0)));
    vec3 b2_ = ((b_1 * b_1) + vec3(1e-20));
    vec3 acrossFar = (a + vec3(cosine));
    vec3 acrossNear = (a - vec3(cosine));
    vec3 across_3 = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a * cosine) + vec3(sine2_));
    vec3 alongNear = ((a * cosine) - vec3(sine2_));
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

Surface fetchSurface(uint i_11) {
    vec4 t0_2 = texelFetch(sceneTable, ivec2(uvec2(9u, i_11)), 0);
    vec4 t1_1 = texelFetch(sceneTable, ivec2(uvec2(10u, i_11)), 0);
    vec4 t2_ = texelFetch(sceneTable, ivec2(uvec2(11u, i_11)), 0);
    vec4 t3_ = texelFetch(sceneTable, ivec2(uvec2(12u, i_11)), 0);
    vec4 t4_ = texelFetch(sceneTable, ivec2(uvec2(13u, i_11)), 0);
    return Surface(t0_2.xyz, t0_2.w, t1_1.xyz, t1_1.w, t2_.xyz, t2_.w, t3_.xyz, t3_.w, t4_.xyz, t4_.w);
}

Material fetchMaterial(uint i_12) {
    vec4 t0_3 = texelFetch(sceneTable, ivec2(uvec2(3u, i_12)), 0);
    vec4 t1_2 = texelFetch(sceneTable, ivec2(uvec2(4u, i_12)), 0);
    return Material(t0_3.xyz, t0_3.w, t1_2.x, t1_2.y, t1_2.z, t1_2.w);
}

void main() {
    vec4 fragment_1 = gl_FragCoord;
    Layers data = Layers(vec4(0.0), vec4(0.0));
    Sight _e2 = look(fragment_1.xy);
    uint shape_1 = _e2.hit.shape;
    data = Layers(vec4(0.0), vec4(0.0, 0.0, 0.0, _e2.closeness));
    if ((shape_1 != noShape)) {
        Material _e26 = fetchMaterial(shape_1);
        data.first = vec4((_e2.ray.start.point + (_e2.hit.t * _e2.ray.direction)), _e26.id);
        vec3 _e33 = outwardNormal(shape_1, _e2.ray, _e2.hit.t);
        data.second = vec4(_e33, _e2.closeness);
    }
    uint _e38 = frame.sampleIndex;
    if ((_e38 > 0u)) {
        uvec2 pixel_2 = uvec2(fragment_1.xy);
        vec4 _e45 = texelFetch(previousFirst, ivec2(pixel_2), 0);
        vec4 _e48 = texelFetch(previousSecond, ivec2(pixel_2), 0);
        Layers previous = Layers(_e45, _e48);
        if ((previous.second.w >= _e2.closeness)) {
            Layers _tmp_return = previous;
            _fs2p_location0 = _tmp_return.first;
            _fs2p_location1 = _tmp_return.second;
            return;
        }
    }
    Layers _e54 = data;
    _fs2p_location0 = _e54.first;
    _fs2p_location1 = _e54.second;
    return;
}

