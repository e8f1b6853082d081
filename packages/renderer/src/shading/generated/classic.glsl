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
struct Ball {
    vec3 center;
    float radius;
    vec3 diffuse;
    float halo;
    float radiance;
    float spare0_;
    float spare1_;
    float spare2_;
};
struct Material {
    vec3 baseColor;
    float reflectivity;
    float specular;
    float exponent;
    float id;
    float spare;
};
struct SurfacePoint {
    Start start;
    vec3 normal;
    vec3 view;
};
struct Light {
    vec3 center;
    float radius;
    vec3 ambient;
    float spare0_;
    vec3 diffuse;
    float power;
    vec3 specular;
    float spare1_;
};
struct LightSampler {
    uint count;
    vec2 shift;
};
struct SampleGroup {
    Start start;
    vec3 center;
    float radius;
    LightSampler points;
    uint first;
    uint count;
    vec2 turn;
};
struct ShadowCone {
    vec3 apex;
    vec3 axis;
    float start;
    float end;
    float sine;
    float cosine;
    float tangent;
};
struct BallPlace {
    float along;
    float across;
};
struct CameraRay {
    vec3 origin;
    vec3 direction;
};
const uint noShape = 4294967295u;
const uint boxMet = 1u;
const uint boxMissed = 0u;
const uint boxHidesLight = 2u;

layout(std140) uniform FrameBlock { Frame frame; };

uniform highp sampler2D sceneTable;

const bool hasOtherProjections = false;

uniform highp sampler2D previousFilm;

layout(location = 0) out vec4 _fs2p_location0;

Hit nearer(Hit hit, float t, uint shape) {
    return Hit(min(t, hit.t), pick((t < hit.t), shape, hit.shape));
}

float intersectSphere(vec3 origin, vec3 direction, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter = (center - origin);
    float along = dot(toCenter, direction);
    vec3 across = (toCenter - (along * direction));
    float discriminant = ((radius * radius) - dot(across, across));
    float half_ = sqrt(max(discriminant, 0.0));
    float near = (along - half_);
    float far = (along + half_);
    float t_3 = pick((near > tMin), near, far);
    return pick(startsInside, max(far, 0.0), pick(pick((discriminant >= 0.0), (t_3 > tMin), false), t_3, 1e30));
}

float hitSphere(uint i, Bounds bounds, Ray ray) {
    float _e13 = intersectSphere(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin, (i == ray.start.inside));
    return pick((i == ray.start.leaves), 1e30, _e13);
}

vec4 tableTexel(uint column, uint row) {
    vec4 _e5 = texelFetch(sceneTable, ivec2(uvec2(column, row)), 0);
    return _e5;
}

Bounds fetchBounds(uint i_1) {
    vec4 _e2 = tableTexel(0u, i_1);
    return Bounds(_e2.xyz, _e2.w);
}

Extent fetchExtent(uint i_2) {
    vec4 _e2 = tableTexel(1u, i_2);
    vec4 _e4 = tableTexel(2u, i_2);
    return Extent(_e2.xyzw, _e4.xyzw);
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

float hitBox(uint i_3, Bounds bounds_1, Ray ray_1) {
    vec3 origin_4 = vec3(0.0);
    vec3 direction_3 = vec3(0.0);
    Extent _e3 = fetchExtent(i_3);
    origin_4 = (ray_1.start.point - bounds_1.center);
    direction_3 = ray_1.direction;
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
    float _e28 = intersectBox(_e19, _e20, _e3.b.xyz, ray_1.start.tMin, (i_3 == ray_1.start.inside));
    return pick((i_3 == ray_1.start.leaves), 1e30, _e28);
}

float intersectQuad(vec3 origin_5, vec3 direction_4, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_2 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_4, normal_2);
    vec3 toCenter_1 = (center_1 - origin_5);
    float t_6 = (dot(toCenter_1, normal_2) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_3 = ((t_6 * direction_4) - toCenter_1);
    bool within = (max(abs(dot(p_3, reciprocalU)), abs(dot(p_3, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_6 > tMin_2), (t_6 < 1e30), false), within, false), t_6, 1e30);
}

float hitQuad(uint i_4, Bounds bounds_2, Ray ray_2) {
    Extent _e3 = fetchExtent(i_4);
    float _e14 = intersectQuad(ray_2.start.point, ray_2.direction, bounds_2.center, _e3.a.xyz, _e3.b.xyz, ray_2.start.tMin);
    return pick((i_4 == ray_2.start.leaves), 1e30, _e14);
}

float intersectPlane(vec3 origin_6, vec3 direction_5, vec3 normal, float offset, float tMin_3) {
    float speed_1 = dot(direction_5, normal);
    float t_7 = ((offset - dot(origin_6, normal)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_7 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_7, 0.0), 1e30);
}

float hitPlane(uint i_5, Bounds bounds_3, Ray ray_3) {
    float _e10 = intersectPlane(ray_3.start.point, ray_3.direction, bounds_3.center, bounds_3.radius, ray_3.start.tMin);
    return pick((i_5 == ray_3.start.leaves), 1e30, _e10);
}

Hit closestHit(Ray ray_4, uint ballCount) {
    Hit hit_1 = Hit(1e30, 4294967295u);
    uint k = 0u;
    uint i_6 = 0u;
    uvec4 ends = frame.shapeEnds;
    uint roundCount = (ends.x + ballCount);
    if ((roundCount > 0u)) {
        while(true) {
            uint _e15 = k;
            uint _e16 = k;
            uint _e21 = k;
            uint i_19 = pick((_e21 >= ends.x), ((_e16 - ends.x) + ends.w), _e15);
            Hit _e25 = hit_1;
            Bounds _e26 = fetchBounds(i_19);
            float _e27 = hitSphere(i_19, _e26, ray_4);
            Hit _e28 = nearer(_e25, _e27, i_19);
            hit_1 = _e28;
            uint _e30 = k;
            k = (_e30 + 1u);
            uint _e32 = k;
            if ((_e32 >= roundCount)) {
                break;
            }
        }
    }
    i_6 = ends.x;
    uint _e36 = i_6;
    if ((_e36 < ends.y)) {
        while(true) {
            Hit _e39 = hit_1;
            uint _e40 = i_6;
            uint _e41 = i_6;
            Bounds _e42 = fetchBounds(_e41);
            float _e43 = hitBox(_e40, _e42, ray_4);
            uint _e44 = i_6;
            Hit _e45 = nearer(_e39, _e43, _e44);
            hit_1 = _e45;
            uint _e47 = i_6;
            i_6 = (_e47 + 1u);
            uint _e49 = i_6;
            if ((_e49 >= ends.y)) {
                break;
            }
        }
    }
    uint _e52 = i_6;
    if ((_e52 < ends.w)) {
        while(true) {
            uint _e55 = i_6;
            Bounds _e56 = fetchBounds(_e55);
            Hit _e57 = hit_1;
            uint _e58 = i_6;
            float _e59 = hitQuad(_e58, _e56, ray_4);
            uint _e60 = i_6;
            float _e61 = hitPlane(_e60, _e56, ray_4);
            uint _e62 = i_6;
            uint _e66 = i_6;
            Hit _e67 = nearer(_e57, pick((_e62 >= ends.z), _e61, _e59), _e66);
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

Ball fetchBall(uint i_7) {
    vec4 _e2 = tableTexel(0u, i_7);
    vec4 _e4 = tableTexel(1u, i_7);
    vec4 _e6 = tableTexel(2u, i_7);
    return Ball(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.x, _e6.y, _e6.z, _e6.w);
}

vec3 halo(Ray ray_5, float t_1) {
    vec3 sum_1 = vec3(0.0);
    uint i_8 = 0u;
    uint _e7 = frame.ballCount;
    if ((_e7 == 0u)) {
        vec3 _e10 = sum_1;
        return _e10;
    }
    while(true) {
        uint _e16 = frame.shapeEnds.w;
        uint _e17 = i_8;
        Ball _e19 = fetchBall((_e16 + _e17));
        vec3 toLight_1 = (_e19.center - ray_5.start.point);
        float along_1 = dot(toLight_1, ray_5.direction);
        vec3 across_1 = (toLight_1 - (along_1 * ray_5.direction));
        float b = max(length(across_1), _e19.radius);
        vec3 _e32 = sum_1;
        sum_1 = (_e32 + ((_e19.halo * _e19.diffuse) * ((atan(((min(t_1, 100000.0) - along_1) / b)) + atan((along_1 / b))) / b)));
        uint _e48 = i_8;
        i_8 = (_e48 + 1u);
        uint _e50 = i_8;
        uint _e53 = frame.ballCount;
        if ((_e50 >= _e53)) {
            break;
        }
    }
    vec3 _e55 = sum_1;
    return _e55;
}

vec3 sky(vec3 direction_6) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_6.y, 0.0));
}

vec3 ballRadiance(uint row_1) {
    Ball _e1 = fetchBall(row_1);
    return (_e1.radiance * _e1.diffuse);
}

bool isSphere(uint i_9) {
    uint _e4 = frame.shapeEnds.x;
    return (i_9 < _e4);
}

bool isPlane(uint i_10) {
    uint _e4 = frame.shapeEnds.z;
    uint _e9 = frame.shapeEnds.w;
    return pick((i_10 >= _e4), (i_10 < _e9), false);
}

bool isFlat(uint i_11) {
    uint _e4 = frame.shapeEnds.y;
    return (i_11 >= _e4);
}

vec3 boxNormal(vec3 origin_7, vec3 direction_7, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_7, direction_7, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_8 = pick(entering, _e5.near, _e5.far);
    vec3 side = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_7, vec3(0.0))));
    bool onX = (crossed.x == t_8);
    bool onY = pick(!(onX), (crossed.y == t_8), false);
    return (side * mix(vec3(0.0), vec3(1.0), bvec3(onX, onY, !(pick(onX, true, onY)))));
}

vec3 rotateBack(vec4 q_2, vec3 v_1) {
    vec3 _e6 = rotate(vec4(-(q_2.xyz), q_2.w), v_1);
    return _e6;
}

vec3 outwardNormal(uint i_12, Ray ray_6, float t_2) {
    Bounds _e3 = fetchBounds(i_12);
    vec3 origin_9 = (ray_6.start.point - _e3.center);
    bool _e8 = isSphere(i_12);
    if (_e8) {
        return normalize((origin_9 + (t_2 * ray_6.direction)));
    }
    bool _e13 = isPlane(i_12);
    if (_e13) {
        return _e3.center;
    }
    Extent _e15 = fetchExtent(i_12);
    bool _e16 = isFlat(i_12);
    if (_e16) {
        return normalize(cross(_e15.a.xyz, _e15.b.xyz));
    }
    bool inside = (i_12 == ray_6.start.inside);
    vec3 _e27 = rotate(_e15.a, origin_9);
    vec3 _e30 = rotate(_e15.a, ray_6.direction);
    vec3 _e35 = boxNormal(_e27, _e30, _e15.b.xyz, ray_6.start.tMin, inside);
    vec3 _e37 = rotateBack(_e15.a, _e35);
    return _e37;
}

Start onSurface(vec3 point, uint shape_1, bool seenFromInside) {
    return Start(point, pick(seenFromInside, noShape, shape_1), pick(seenFromInside, shape_1, noShape), (1e-5 * length(point)));
}

Material fetchMaterial(uint i_13) {
    vec4 _e2 = tableTexel(3u, i_13);
    vec4 _e4 = tableTexel(4u, i_13);
    return Material(_e2.xyz, _e2.w, _e4.x, _e4.y, _e4.z, _e4.w);
}

Light fetchLight(uint i_14) {
    vec4 _e2 = tableTexel(5u, i_14);
    vec4 _e4 = tableTexel(6u, i_14);
    vec4 _e6 = tableTexel(7u, i_14);
    vec4 _e8 = tableTexel(8u, i_14);
    return Light(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w);
}

uint pcg(uint x) {
    uint s_2 = ((x * 747796405u) + 2891336453u);
    uint w = (((s_2 >> ((s_2 >> 28u) + 4u)) ^ s_2) * 277803737u);
    return ((w >> 22u) ^ w);
}

float unitFloat(uint h) {
    return (float((h >> 8u)) * 5.9604645e-8);
}

LightSampler lightSampler(uint count, uint pixelHash, uint light, uint reflection) {
    uint _e8 = pcg(((pixelHash + (128u * light)) + reflection));
    float _e9 = unitFloat(_e8);
    uint _e10 = pcg(_e8);
    float _e11 = unitFloat(_e10);
    return LightSampler(count, vec2(_e9, _e11));
}

vec2 firstTurn(LightSampler s, uint k_1) {
    float phi = (6.2831855 * fract(((float(k_1) * 0.618034) + s.shift.y)));
    return vec2(cos(phi), sin(phi));
}

uint everySample(SampleGroup group) {
    return (4294967295u >> (32u - group.count));
}

float sampleReach(uint count_1) {
    if ((count_1 == 1u)) {
        return 0.0;
    }
    return pick((count_1 == 9u), 0.70710677, 1.0);
}

ShadowCone shadowCone(vec3 apex, vec3 center_2, float radius_1, uint count_2) {
    vec3 toLight_2 = (center_2 - apex);
    float distance_ = max(length(toLight_2), 1e-30);
    float _e8 = sampleReach(count_2);
    float reach_1 = (radius_1 * _e8);
    float sine = min((reach_1 / distance_), 1.0);
    float cosine = sqrt((1.0 - (sine * sine)));
    return ShadowCone(apex, (toLight_2 / vec3(distance_)), (distance_ - reach_1), (distance_ + reach_1), sine, cosine, pick((cosine < 0.001), 1e30, (sine / cosine)));
}

bool coneMeetsPlane(ShadowCone cone, vec3 normal_1, float offset_1) {
    float here = (dot(normal_1, cone.apex) - offset_1);
    float there = (here + ((dot(normal_1, cone.axis) * 0.5) * (cone.start + cone.end)));
    return (min((here * there), (abs(there) - (0.5 * (cone.end - cone.start)))) <= 0.0);
}

bool coneMissesBall(ShadowCone cone_1, BallPlace ball, float radius_2) {
    float beside = ((ball.across * cone_1.cosine) - (ball.along * cone_1.sine));
    float outside = max(max(beside, -(ball.along)), (ball.along - cone_1.end));
    return (outside > pick((cone_1.tangent == 1e30), 1e30, radius_2));
}

BallPlace placeBall(ShadowCone cone_2, vec3 center_3) {
    vec3 toBall = (center_3 - cone_2.apex);
    float along_2 = dot(toBall, cone_2.axis);
    return BallPlace(along_2, length((toBall - (along_2 * cone_2.axis))));
}

uint candidates(SampleGroup group_1, ShadowCone cone_3, uint base) {
    uint found = 0u;
    uint i_15 = 0u;
    uint _e5 = frame.occluderEnd;
    uint end_2 = min(_e5, (base + 32u));
    i_15 = base;
    while(true) {
        uint _e12 = i_15;
        Bounds _e13 = fetchBounds(_e12);
        bool _e16 = coneMeetsPlane(cone_3, _e13.center, _e13.radius);
        BallPlace _e18 = placeBall(cone_3, _e13.center);
        bool _e20 = coneMissesBall(cone_3, _e18, _e13.radius);
        bool meetsBall = !(_e20);
        uint _e22 = found;
        uint _e25 = i_15;
        bool _e26 = isPlane(_e25);
        uint _e29 = i_15;
        found = (_e22 | (pick(pick(_e26, _e16, meetsBall), 1u, 0u) << (_e29 - base)));
        uint _e34 = i_15;
        i_15 = (_e34 + 1u);
        uint _e36 = i_15;
        if ((_e36 >= end_2)) {
            break;
        }
    }
    uint inside_1 = (group_1.start.inside - base);
    uint leaves = (group_1.start.leaves - base);
    uint _e44 = found;
    found = (_e44 | pick((inside_1 < 32u), (1u << (inside_1 & 31u)), 0u));
    uint _e54 = found;
    return (_e54 & ~(pick((leaves < 32u), (1u << (leaves & 31u)), 0u)));
}

uint lowestBit(uint bits) {
    return ((floatBitsToUint(float((bits & (~(bits) + 1u)))) >> 23u) - 127u);
}

bool ballHidesLight(ShadowCone cone_4, BallPlace ball_1, float radius_3) {
    float covers = (((radius_3 * 0.9999) - (ball_1.across * cone_4.cosine)) - (ball_1.along * cone_4.sine));
    return (min(min(covers, (ball_1.along - radius_3)), ((cone_4.start - ball_1.along) - radius_3)) > 0.0);
}

vec3 samplePoint(LightSampler s_1, uint k_2, vec2 turn) {
    float i_20 = float(k_2);
    float row_2 = floor(((i_20 + 0.5) * 0.33333334));
    vec3 fixed9_ = vec3(((0.5 * (i_20 - (3.0 * row_2))) - 0.5), 0.0, ((0.5 * row_2) - 0.5));
    float z_1 = (1.0 - ((2.0 * (i_20 + s_1.shift.x)) / float(s_1.count)));
    vec3 lattice = vec3((sqrt(max((1.0 - (z_1 * z_1)), 0.0)) * turn), z_1);
    return pick((s_1.count == 1u), vec3(0.0), pick((s_1.count == 9u), fixed9_, lattice));
}

vec3 toSample(SampleGroup group_2, uint k_3, vec2 turn_1) {
    vec3 _e8 = samplePoint(group_2.points, (group_2.first + k_3), turn_1);
    return ((group_2.center + (group_2.radius * _e8)) - group_2.start.point);
}

vec2 nextTurn(vec2 turn_2) {
    return vec2(((turn_2.x * -0.7373689) - (turn_2.y * -0.6754903)), ((turn_2.x * -0.6754903) + (turn_2.y * -0.7373689)));
}

uint behindSphere(SampleGroup group_3, uint i_16, ShadowCone cone_5) {
    uint bits_1 = 0u;
    vec2 turn_3 = vec2(0.0);
    uint k_4 = 0u;
    Bounds _e3 = fetchBounds(i_16);
    BallPlace _e5 = placeBall(cone_5, _e3.center);
    bool _e7 = ballHidesLight(cone_5, _e5, _e3.radius);
    bool hides = pick(_e7, (i_16 != group_3.start.inside), false);
    if (hides) {
        uint _e12 = everySample(group_3);
        return _e12;
    }
    turn_3 = group_3.turn;
    while(true) {
        uint _e19 = k_4;
        vec2 _e20 = turn_3;
        vec3 _e21 = toSample(group_3, _e19, _e20);
        vec2 _e22 = turn_3;
        vec2 _e23 = nextTurn(_e22);
        turn_3 = _e23;
        float inverse_ = inversesqrt(dot(_e21, _e21));
        uint _e26 = bits_1;
        float _e32 = hitSphere(i_16, _e3, Ray(group_3.start, (_e21 * inverse_)));
        uint _e37 = k_4;
        bits_1 = (_e26 | (pick(((_e32 * inverse_) < 1.0), 1u, 0u) << _e37));
        uint _e41 = k_4;
        k_4 = (_e41 + 1u);
        uint _e43 = k_4;
        if ((_e43 >= group_3.count)) {
            break;
        }
    }
    uint _e46 = bits_1;
    return _e46;
}

float max3_(vec3 v_2) {
    return max(max(v_2.x, v_2.y), v_2.z);
}

float min3_(vec3 v_3) {
    return min(min(v_3.x, v_3.y), v_3.z);
}

uint placeBox(ShadowCone cone_6, vec3 apex_1, vec3 axis, vec3 halfSize_3, float end) {
    float radius_4 = ((1.0001 * min(end, cone_6.end)) * cone_6.tangent);
    vec3 _e11 = safeReciprocal(axis, apex_1);
    vec3 middle_1 = (-(apex_1) * _e11);
    vec3 half_1 = (halfSize_3 * abs(_e11));
    vec3 margin = (radius_4 * abs(_e11));
    vec3 low = (middle_1 - half_1);
    vec3 high = (middle_1 + half_1);
    float _e21 = max3_((low - margin));
    float _e23 = min3_((high + margin));
    bool met = (min(min((_e23 - _e21), _e23), (cone_6.end - _e21)) >= 0.0);
    float _e32 = max3_((low + margin));
    float _e34 = min3_((high - margin));
    bool through = (min(min((_e34 - _e32), _e32), (cone_6.start - _e32)) > 0.0);
    float _e44 = max3_((abs(apex_1) - halfSize_3));
    bool apexOutside = (_e44 > 0.0);
    float _e48 = min3_(halfSize_3);
    bool hides_1 = pick(pick(through, apexOutside, false), (_e48 > radius_4), false);
    return pick(pick(met, true, (cone_6.tangent == 1e30)), pick(hides_1, boxHidesLight, boxMet), boxMissed);
}

uint behindFaces(SampleGroup group_4, uint i_17, ShadowCone cone_7) {
    vec3 x_1 = vec3(0.0);
    vec3 y = vec3(0.0);
    vec3 z = vec3(0.0);
    vec3 halfSize_4 = vec3(0.0);
    vec3 origin_8 = vec3(0.0);
    float tMin_5 = 0.0;
    uint meets = boxMet;
    uint bits_2 = 0u;
    vec2 turn_4 = vec2(0.0);
    uint k_5 = 0u;
    Bounds _e3 = fetchBounds(i_17);
    Extent _e4 = fetchExtent(i_17);
    vec3 fromCenter = (group_4.start.point - _e3.center);
    bool startsInside_3 = (i_17 == group_4.start.inside);
    vec3 _e17 = rotateBack(_e4.a, vec3(1.0, 0.0, 0.0));
    x_1 = _e17;
    vec3 _e24 = rotateBack(_e4.a, vec3(0.0, 1.0, 0.0));
    y = _e24;
    vec3 _e31 = rotateBack(_e4.a, vec3(0.0, 0.0, 1.0));
    z = _e31;
    halfSize_4 = _e4.b.xyz;
    bool _e36 = isFlat(i_17);
    if (_e36) {
        x_1 = _e4.a.xyz;
        y = _e4.b.xyz;
        vec3 _e41 = x_1;
        vec3 _e42 = y;
        z = normalize(cross(_e41, _e42));
        halfSize_4 = vec3(vec2(0.500001), 0.0);
    }
    vec3 _e49 = x_1;
    vec3 _e51 = y;
    vec3 _e53 = z;
    origin_8 = vec3(dot(_e49, fromCenter), dot(_e51, fromCenter), dot(_e53, fromCenter));
    tMin_5 = group_4.start.tMin;
    bool _e60 = isPlane(i_17);
    if (_e60) {
        x_1 = vec3(0.0);
        y = vec3(0.0);
        z = pick((_e3.radius > 0.0), _e3.center, -(_e3.center));
        halfSize_4 = vec3(1.0, 1.0, 0.0);
        vec3 _e76 = z;
        origin_8 = vec3(0.0, 0.0, (dot(_e76, group_4.start.point) - abs(_e3.radius)));
        uint _e91 = frame.planesCutView;
        if (pick((_e3.radius != 0.0), (_e91 == 0u), false)) {
            float _e97 = origin_8.z;
            origin_8.z = min(_e97, -1e-12);
            tMin_5 = 0.0;
        }
    }
    bool _e103 = isFlat(i_17);
    if (!(pick(startsInside_3, true, _e103))) {
        vec3 _e106 = x_1;
        vec3 _e109 = y;
        vec3 _e112 = z;
        vec3 axis_1 = vec3(dot(_e106, cone_7.axis), dot(_e109, cone_7.axis), dot(_e112, cone_7.axis));
        vec3 _e116 = origin_8;
        vec3 _e117 = halfSize_4;
        uint _e122 = placeBox(cone_7, _e116, axis_1, _e117, (_e3.radius - dot(fromCenter, cone_7.axis)));
        meets = _e122;
    }
    uint _e123 = meets;
    if ((_e123 != boxMet)) {
        uint _e127 = everySample(group_4);
        uint _e128 = meets;
        return pick((_e128 == boxHidesLight), _e127, 0u);
    }
    turn_4 = group_4.turn;
    while(true) {
        uint _e138 = k_5;
        vec2 _e139 = turn_4;
        vec3 _e140 = toSample(group_4, _e138, _e139);
        vec2 _e141 = turn_4;
        vec2 _e142 = nextTurn(_e141);
        turn_4 = _e142;
        float inverse_1 = inversesqrt(dot(_e140, _e140));
        vec3 toLight_3 = (_e140 * inverse_1);
        vec3 _e146 = x_1;
        vec3 _e148 = y;
        vec3 _e150 = z;
        vec3 direction_8 = vec3(dot(_e146, toLight_3), dot(_e148, toLight_3), dot(_e150, toLight_3));
        vec3 _e153 = origin_8;
        vec3 _e154 = halfSize_4;
        float _e155 = tMin_5;
        float _e156 = intersectBox(_e153, direction_8, _e154, _e155, startsInside_3);
        uint _e157 = bits_2;
        uint _e164 = k_5;
        bits_2 = (_e157 | (pick(((_e156 * inverse_1) < 1.0), 1u, 0u) << _e164));
        uint _e168 = k_5;
        k_5 = (_e168 + 1u);
        uint _e170 = k_5;
        if ((_e170 >= group_4.count)) {
            break;
        }
    }
    uint _e173 = bits_2;
    return _e173;
}

uint hiddenSamples(SampleGroup group_5) {
    uint hidden = 0u;
    uint end_1 = 0u;
    uint rest = 0u;
    uint _e5 = frame.occluderEnd;
    if ((_e5 == 0u)) {
        uint _e8 = hidden;
        return _e8;
    }
    uint _e9 = everySample(group_5);
    ShadowCone _e16 = shadowCone(group_5.start.point, group_5.center, group_5.radius, group_5.points.count);
    while(true) {
        uint _e21 = rest;
        if ((_e21 == 0u)) {
            uint _e24 = end_1;
            uint _e25 = candidates(group_5, _e16, _e24);
            rest = _e25;
            uint _e26 = end_1;
            end_1 = (_e26 + 32u);
        }
        uint _e29 = rest;
        if ((_e29 != 0u)) {
            uint _e32 = end_1;
            uint _e35 = rest;
            uint _e36 = lowestBit(_e35);
            uint i_21 = ((_e32 - 32u) + _e36);
            bool _e38 = isSphere(i_21);
            if (_e38) {
                uint _e39 = hidden;
                uint _e40 = behindSphere(group_5, i_21, _e16);
                hidden = (_e39 | _e40);
            } else {
                uint _e42 = hidden;
                uint _e43 = behindFaces(group_5, i_21, _e16);
                hidden = (_e42 | _e43);
            }
            uint _e45 = rest;
            uint _e46 = rest;
            rest = (_e45 & (_e46 - 1u));
        }
        uint _e50 = rest;
        uint _e53 = end_1;
        uint _e56 = frame.occluderEnd;
        uint _e59 = hidden;
        if (pick(pick((_e50 == 0u), (_e53 >= _e56), false), true, (_e59 == _e9))) {
            break;
        }
    }
    uint _e62 = hidden;
    return _e62;
}

vec3 sampleLight(SurfacePoint p, Material m, Light light_1, vec3 toLight) {
    vec3 c = vec3(0.0);
    float distance2_ = dot(toLight, toLight);
    vec3 l = (toLight * inversesqrt(distance2_));
    float cosine_1 = dot(p.normal, l);
    if ((cosine_1 <= 0.0)) {
        return vec3(0.0);
    }
    c = ((m.baseColor * light_1.diffuse) * cosine_1);
    if ((m.specular > 0.0)) {
        vec3 _e21 = c;
        c = (_e21 + ((m.specular * light_1.specular) * pow(max(dot(p.normal, normalize((l + p.view))), 1e-10), m.exponent)));
    }
    vec3 _e36 = c;
    return (_e36 * (light_1.power / distance2_));
}

vec3 sampled(SurfacePoint p_1, Material m_1, Light light_2, SampleGroup group_6) {
    vec3 sum_2 = vec3(0.0);
    vec2 turn_5 = vec2(0.0);
    uint k_6 = 0u;
    uint _e7 = hiddenSamples(group_6);
    turn_5 = group_6.turn;
    while(true) {
        uint _e12 = k_6;
        if ((((_e7 >> _e12) & 1u) == 0u)) {
            vec3 _e18 = sum_2;
            uint _e19 = k_6;
            vec2 _e20 = turn_5;
            vec3 _e21 = toSample(group_6, _e19, _e20);
            vec3 _e22 = sampleLight(p_1, m_1, light_2, _e21);
            sum_2 = (_e18 + _e22);
        }
        vec2 _e24 = turn_5;
        vec2 _e25 = nextTurn(_e24);
        turn_5 = _e25;
        uint _e27 = k_6;
        k_6 = (_e27 + 1u);
        uint _e29 = k_6;
        if ((_e29 >= group_6.count)) {
            break;
        }
    }
    vec3 _e32 = sum_2;
    return _e32;
}

vec3 shade(SurfacePoint p_2, Material m_2, uint pixelHash_1, uint reflection_1, uint sampleCount) {
    vec3 color = vec3(0.0);
    uint i_18 = 0u;
    uint first = 0u;
    uint _e10 = frame.lightCount;
    if ((_e10 == 0u)) {
        vec3 _e13 = color;
        return _e13;
    }
    while(true) {
        uint _e18 = i_18;
        Light _e19 = fetchLight(_e18);
        uint _e20 = first;
        if ((_e20 == 0u)) {
            vec3 _e23 = color;
            color = (_e23 + (_e19.ambient * m_2.baseColor));
        }
        if ((dot(p_2.normal, (_e19.center - p_2.start.point)) > -(_e19.radius))) {
            uint _e37 = i_18;
            LightSampler _e38 = lightSampler(sampleCount, pixelHash_1, _e37, reflection_1);
            uint _e42 = first;
            uint _e44 = first;
            uint _e48 = first;
            vec2 _e49 = firstTurn(_e38, _e48);
            SampleGroup group_7 = SampleGroup(p_2.start, _e19.center, _e19.radius, _e38, _e42, min((_e38.count - _e44), 32u), _e49);
            vec3 _e51 = color;
            vec3 _e52 = sampled(p_2, m_2, _e19, group_7);
            color = (_e51 + (_e52 / vec3(float(_e38.count))));
        }
        uint _e58 = first;
        first = (_e58 + 32u);
        uint _e61 = first;
        if ((_e61 >= sampleCount)) {
            first = 0u;
            uint _e65 = i_18;
            i_18 = (_e65 + 1u);
        }
        uint _e67 = i_18;
        uint _e70 = frame.lightCount;
        if ((_e67 >= _e70)) {
            break;
        }
    }
    vec3 _e72 = color;
    return _e72;
}

vec3 trace(Ray first_1, uint hash, uint maxReflections, uint lightSamples) {
    Ray ray_7 = Ray(Start(vec3(0.0), 0u, 0u, 0.0), vec3(0.0));
    float weight = 1.0;
    vec3 radiance = vec3(0.0);
    uint reflection_2 = 0u;
    vec3 seen = vec3(0.0);
    bool local = false;
    ray_7 = first_1;
    while(true) {
        Ray _e12 = ray_7;
        uint _e15 = frame.ballCount;
        Hit _e16 = closestHit(_e12, _e15);
        vec3 _e17 = radiance;
        float _e18 = weight;
        Ray _e19 = ray_7;
        vec3 _e21 = halo(_e19, _e16.t);
        radiance = (_e17 + (_e18 * _e21));
        uint _e28 = frame.shapeEnds.w;
        if ((_e16.shape >= _e28)) {
            vec3 _e31 = ray_7.direction;
            vec3 _e32 = sky(_e31);
            seen = _e32;
            if ((_e16.shape != noShape)) {
                vec3 _e38 = ballRadiance(_e16.shape);
                seen = _e38;
            }
            vec3 _e39 = radiance;
            float _e40 = weight;
            vec3 _e41 = seen;
            radiance = (_e39 + (_e40 * _e41));
            break;
        }
        vec3 _e46 = ray_7.start.point;
        vec3 _e49 = ray_7.direction;
        vec3 position = (_e46 + (_e16.t * _e49));
        Ray _e53 = ray_7;
        vec3 _e55 = outwardNormal(_e16.shape, _e53, _e16.t);
        vec3 _e57 = ray_7.direction;
        bool seenFromBack = (dot(_e55, _e57) > 0.0);
        vec3 normal_3 = pick(seenFromBack, -(_e55), _e55);
        if (seenFromBack) {
            bool _e67 = isFlat(_e16.shape);
            local = !(_e67);
        } else {
            local = false;
        }
        bool _e70 = local;
        Start _e71 = onSurface(position, _e16.shape, _e70);
        Material _e73 = fetchMaterial(_e16.shape);
        vec3 _e75 = ray_7.direction;
        SurfacePoint point_2 = SurfacePoint(_e71, normal_3, -(_e75));
        vec3 _e78 = radiance;
        float _e79 = weight;
        uint _e84 = reflection_2;
        vec3 _e85 = shade(point_2, _e73, hash, _e84, lightSamples);
        radiance = (_e78 + ((_e79 * (1.0 - _e73.reflectivity)) * _e85));
        float _e88 = weight;
        weight = (_e88 * _e73.reflectivity);
        vec3 _e92 = ray_7.direction;
        ray_7 = Ray(_e71, reflect(_e92, normal_3));
        uint _e96 = reflection_2;
        reflection_2 = (_e96 + 1u);
        uint _e98 = reflection_2;
        float _e100 = weight;
        if (pick((_e98 > maxReflections), true, (_e100 < 0.00024414063))) {
            break;
        }
    }
    vec3 _e104 = radiance;
    return _e104;
}

CameraRay rayThroughLens(vec2 filmPosition, vec2 lensPoint) {
    CameraRay ray_8 = CameraRay(vec3(0.0), vec3(0.0));
    float _e7 = frame.width;
    float x_2 = (((2.0 * filmPosition.x) / _e7) - 1.0);
    float _e16 = frame.height;
    float y_1 = (1.0 - ((2.0 * filmPosition.y) / _e16));
    vec3 _e22 = frame.right;
    vec3 _e26 = frame.up;
    vec3 across_2 = ((x_2 * _e22) + (y_1 * _e26));
    const bool _e30 = hasOtherProjections;
    uint _e33 = frame.projection;
    bool orthographic = pick(_e30, (_e33 == 1u), false);
    vec3 _e39 = frame.forward;
    vec3 _e43 = frame.forward;
    vec3 ahead = pick(orthographic, _e43, (_e39 + across_2));
    float _e47 = frame.aperture;
    vec3 _e51 = frame.right;
    vec3 _e57 = frame.up;
    vec3 lens = (_e47 * ((lensPoint.x * normalize(_e51)) + (lensPoint.y * normalize(_e57))));
    float _e66 = frame.focusDistance;
    ray_8 = CameraRay(pick(orthographic, (across_2 + lens), lens), normalize((ahead - (lens / vec3(_e66)))));
    const bool _e74 = hasOtherProjections;
    if (_e74) {
        uint _e77 = frame.projection;
        if ((_e77 == 2u)) {
            float longitude = (3.1415927 * x_2);
            float latitude = (1.5707964 * y_1);
            vec3 _e87 = frame.right;
            vec3 _e92 = frame.forward;
            vec3 level = ((sin(longitude) * _e87) + (cos(longitude) * _e92));
            vec3 _e102 = frame.up;
            ray_8 = CameraRay(vec3(0.0), normalize(((cos(latitude) * level) + (sin(latitude) * _e102))));
        }
    }
    CameraRay _e107 = ray_8;
    return _e107;
}

CameraRay centralRay(vec2 filmPosition_1) {
    CameraRay _e3 = rayThroughLens(filmPosition_1, vec2(0.0));
    return _e3;
}

uint pixelHash0_(uvec2 pixel, uint sampleIndex, uint seed) {
    uint _e5 = pcg(seed);
    uint _e7 = pcg((sampleIndex + _e5));
    uint _e9 = pcg((pixel.y + _e7));
    uint _e11 = pcg((pixel.x + _e9));
    return _e11;
}

Start onCamera(vec3 point_1) {
    return Start(point_1, noShape, noShape, 0.0);
}

void main() {
    vec4 fragment = gl_FragCoord;
    vec4 sum = vec4(0.0);
    uvec2 texel = uvec2(fragment.xy);
    uvec2 _e5 = frame.origin;
    uvec2 pixel_1 = (_e5 + texel);
    float column_1 = (float(pixel_1.x) + 0.5);
    float _e16 = frame.dividers.x;
    float _e22 = frame.dividers.y;
    uvec4 panel = frame.panels[(uint((column_1 >= _e16)) + uint((column_1 >= _e22)))];
    vec2 _e31 = frame.jitter;
    CameraRay _e33 = centralRay((vec2(pixel_1) + _e31));
    uint _e36 = frame.sampleIndex;
    uint _e39 = frame.seed;
    uint _e40 = pixelHash0_(pixel_1, _e36, _e39);
    Start _e42 = onCamera(_e33.origin);
    vec3 _e47 = trace(Ray(_e42, _e33.direction), _e40, panel.x, panel.y);
    uint _e53 = frame.sampleIndex;
    if ((_e53 > 0u)) {
        vec4 _e58 = texelFetch(previousFilm, ivec2(texel), 0);
        sum = _e58;
    }
    vec4 _e59 = sum;
    _fs2p_location0 = (_e59 + vec4(_e47, 1.0));
    return;
}

