#version 300 es

precision highp float;
precision highp int;

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
    uint seenLightEnd;
    uint spare0_;
    uint spare1_;
    uvec4 panels[3];
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
struct SeenLight {
    float t;
    vec3 ball;
};
struct Light {
    vec3 center;
    float radius;
    vec3 ambient;
    float halo;
    vec3 diffuse;
    float power;
    vec3 specular;
    float visible;
};
struct Material {
    vec3 baseColor;
    float reflectivity;
    float specular;
    float exponent;
    float spare0_;
    float spare1_;
};
struct SurfacePoint {
    Start start;
    vec3 normal;
    vec3 view;
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
const uint noShape = 4294967295u;
const uint boxMissed = 0u;
const uint boxMet = 1u;
const uint boxHidesLight = 2u;

layout(std140) uniform FrameBlock { Frame frame; };

uniform highp sampler2D sceneTable;

uniform highp sampler2D previousFilm;

layout(location = 0) out vec4 _fs2p_location0;

Hit nearer(Hit hit, float t, uint shape) {
    return Hit(min(t, hit.t), ((t < hit.t) ? shape : hit.shape));
}

float intersectSphere(vec3 origin, vec3 direction, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter = (center - origin);
    float along = dot(toCenter, direction);
    vec3 across = (toCenter - (along * direction));
    float discriminant = ((radius * radius) - dot(across, across));
    float half_ = sqrt(max(discriminant, 0.0));
    float near = (along - half_);
    float far = (along + half_);
    float t_5 = ((near > tMin) ? near : far);
    return (startsInside ? max(far, 0.0) : (((discriminant >= 0.0) && (t_5 > tMin)) ? t_5 : 1e30));
}

float hitSphere(uint i, Bounds bounds, Ray ray) {
    float _e13 = intersectSphere(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin, (i == ray.start.inside));
    return ((i == ray.start.leaves) ? 1e30 : _e13);
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
    vec3 t_6 = (2.0 * cross(q_1.xyz, v));
    return ((v + (q_1.w * t_6)) + cross(q_1.xyz, t_6));
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
    float t_7 = ((_e5.near > tMin_1) ? _e5.near : _e5.far);
    return (startsInside_1 ? max(_e5.far, 0.0) : (((_e5.near <= _e5.far) && (t_7 > tMin_1)) ? t_7 : 1e30));
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
    return ((i_3 == ray_1.start.leaves) ? 1e30 : _e28);
}

float intersectQuad(vec3 origin_5, vec3 direction_4, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_2 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_4, normal_2);
    vec3 toCenter_1 = (center_1 - origin_5);
    float t_8 = (dot(toCenter_1, normal_2) / ((speed == 0.0) ? 1e-30 : speed));
    vec3 p_2 = ((t_8 * direction_4) - toCenter_1);
    bool within = (max(abs(dot(p_2, reciprocalU)), abs(dot(p_2, reciprocalV))) <= 0.500001);
    return ((((t_8 > tMin_2) && (t_8 < 1e30)) && within) ? t_8 : 1e30);
}

float hitQuad(uint i_4, Bounds bounds_2, Ray ray_2) {
    Extent _e3 = fetchExtent(i_4);
    float _e14 = intersectQuad(ray_2.start.point, ray_2.direction, bounds_2.center, _e3.a.xyz, _e3.b.xyz, ray_2.start.tMin);
    return ((i_4 == ray_2.start.leaves) ? 1e30 : _e14);
}

float intersectPlane(vec3 origin_6, vec3 direction_5, vec3 normal, float offset, float tMin_3) {
    float speed_1 = dot(direction_5, normal);
    float t_9 = ((offset - dot(origin_6, normal)) / ((speed_1 == 0.0) ? 1e-12 : speed_1));
    return (((t_9 > tMin_3) && (abs(speed_1) > 1e-12)) ? t_9 : 1e30);
}

float hitPlane(uint i_5, Bounds bounds_3, Ray ray_3) {
    float _e10 = intersectPlane(ray_3.start.point, ray_3.direction, bounds_3.center, bounds_3.radius, ray_3.start.tMin);
    return ((i_5 == ray_3.start.leaves) ? 1e30 : _e10);
}

Hit closestHit(Ray ray_4) {
    Hit hit_1 = Hit(1e30, 4294967295u);
    uint i_6 = 0u;
    uint i_7 = 0u;
    uint i_8 = 0u;
    uint i_9 = 0u;
    uvec4 ends = frame.shapeEnds;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e21 = i_6;
            i_6 = (_e21 + 1u);
        }
        loop_init = false;
        uint _e10 = i_6;
        if ((_e10 < ends.x)) {
        } else {
            break;
        }
        {
            Hit _e13 = hit_1;
            uint _e14 = i_6;
            uint _e15 = i_6;
            Bounds _e16 = fetchBounds(_e15);
            float _e17 = hitSphere(_e14, _e16, ray_4);
            uint _e18 = i_6;
            Hit _e19 = nearer(_e13, _e17, _e18);
            hit_1 = _e19;
        }
    }
    i_7 = ends.x;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e36 = i_7;
            i_7 = (_e36 + 1u);
        }
        loop_init_1 = false;
        uint _e25 = i_7;
        if ((_e25 < ends.y)) {
        } else {
            break;
        }
        {
            Hit _e28 = hit_1;
            uint _e29 = i_7;
            uint _e30 = i_7;
            Bounds _e31 = fetchBounds(_e30);
            float _e32 = hitBox(_e29, _e31, ray_4);
            uint _e33 = i_7;
            Hit _e34 = nearer(_e28, _e32, _e33);
            hit_1 = _e34;
        }
    }
    i_8 = ends.y;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e51 = i_8;
            i_8 = (_e51 + 1u);
        }
        loop_init_2 = false;
        uint _e40 = i_8;
        if ((_e40 < ends.z)) {
        } else {
            break;
        }
        {
            Hit _e43 = hit_1;
            uint _e44 = i_8;
            uint _e45 = i_8;
            Bounds _e46 = fetchBounds(_e45);
            float _e47 = hitQuad(_e44, _e46, ray_4);
            uint _e48 = i_8;
            Hit _e49 = nearer(_e43, _e47, _e48);
            hit_1 = _e49;
        }
    }
    i_9 = ends.z;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e66 = i_9;
            i_9 = (_e66 + 1u);
        }
        loop_init_3 = false;
        uint _e55 = i_9;
        if ((_e55 < ends.w)) {
        } else {
            break;
        }
        {
            Hit _e58 = hit_1;
            uint _e59 = i_9;
            uint _e60 = i_9;
            Bounds _e61 = fetchBounds(_e60);
            float _e62 = hitPlane(_e59, _e61, ray_4);
            uint _e63 = i_9;
            Hit _e64 = nearer(_e58, _e62, _e63);
            hit_1 = _e64;
        }
    }
    Hit _e68 = hit_1;
    return _e68;
}

Light fetchLight(uint i_10) {
    vec4 t0_2 = texelFetch(sceneTable, ivec2(uvec2(5u, i_10)), 0);
    vec4 t1_1 = texelFetch(sceneTable, ivec2(uvec2(6u, i_10)), 0);
    vec4 t2_ = texelFetch(sceneTable, ivec2(uvec2(7u, i_10)), 0);
    vec4 t3_ = texelFetch(sceneTable, ivec2(uvec2(8u, i_10)), 0);
    return Light(t0_2.xyz, t0_2.w, t1_1.xyz, t1_1.w, t2_.xyz, t2_.w, t3_.xyz, t3_.w);
}

SeenLight closestBall(Ray ray_5, float t_1) {
    SeenLight seen = SeenLight(0.0, vec3(0.0));
    uint i_11 = 0u;
    seen = SeenLight(t_1, vec3(0.0));
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            uint _e35 = i_11;
            i_11 = (_e35 + 1u);
        }
        loop_init_4 = false;
        uint _e8 = i_11;
        uint _e11 = frame.seenLightEnd;
        if ((_e8 < _e11)) {
        } else {
            break;
        }
        {
            uint _e13 = i_11;
            Light _e14 = fetchLight(_e13);
            if ((_e14.visible < 0.0)) {
                continue;
            }
            float _e26 = intersectSphere(ray_5.start.point, ray_5.direction, _e14.center, _e14.radius, ray_5.start.tMin, false);
            float _e28 = seen.t;
            if ((_e26 < _e28)) {
                seen = SeenLight(_e26, (_e14.visible * _e14.diffuse));
            }
        }
    }
    SeenLight _e37 = seen;
    return _e37;
}

vec3 halo(Ray ray_6, float t_2) {
    vec3 sum_1 = vec3(0.0);
    uint i_12 = 0u;
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            uint _e45 = i_12;
            i_12 = (_e45 + 1u);
        }
        loop_init_5 = false;
        uint _e7 = i_12;
        uint _e10 = frame.seenLightEnd;
        if ((_e7 < _e10)) {
        } else {
            break;
        }
        {
            uint _e12 = i_12;
            Light _e13 = fetchLight(_e12);
            if ((_e13.halo <= 0.0)) {
                continue;
            }
            vec3 toLight_1 = (_e13.center - ray_6.start.point);
            float along_1 = dot(toLight_1, ray_6.direction);
            vec3 across_1 = (toLight_1 - (along_1 * ray_6.direction));
            float b = max(length(across_1), _e13.radius);
            vec3 _e29 = sum_1;
            sum_1 = (_e29 + ((_e13.halo * _e13.diffuse) * ((atan(((min(t_2, 100000.0) - along_1) / b)) + atan((along_1 / b))) / b)));
        }
    }
    vec3 _e47 = sum_1;
    return _e47;
}

vec3 sky(vec3 direction_6) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_6.y, 0.0));
}

bool isSphere(uint i_13) {
    uint _e4 = frame.shapeEnds.x;
    return (i_13 < _e4);
}

bool isPlane(uint i_14) {
    uint _e4 = frame.shapeEnds.z;
    return (i_14 >= _e4);
}

bool isFlat(uint i_15) {
    uint _e4 = frame.shapeEnds.y;
    return (i_15 >= _e4);
}

vec3 boxNormal(vec3 origin_7, vec3 direction_7, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_7, direction_7, halfSize_2);
    bool entering = ((_e5.near > tMin_4) && !(startsInside_2));
    vec3 crossed = (entering ? _e5.enter : _e5.leave);
    float t_10 = (entering ? _e5.near : _e5.far);
    vec3 side = ((entering ? -1.0 : 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_7, vec3(0.0))));
    if ((crossed.x == t_10)) {
        return vec3(side.x, 0.0, 0.0);
    }
    if ((crossed.y == t_10)) {
        return vec3(0.0, side.y, 0.0);
    }
    return vec3(0.0, 0.0, side.z);
}

vec3 rotateBack(vec4 q_2, vec3 v_1) {
    vec3 _e6 = rotate(vec4(-(q_2.xyz), q_2.w), v_1);
    return _e6;
}

vec3 outwardNormal(uint i_16, Ray ray_7, float t_3) {
    Bounds _e3 = fetchBounds(i_16);
    vec3 origin_9 = (ray_7.start.point - _e3.center);
    bool _e8 = isSphere(i_16);
    if (_e8) {
        return normalize((origin_9 + (t_3 * ray_7.direction)));
    }
    bool _e13 = isPlane(i_16);
    if (_e13) {
        return _e3.center;
    }
    Extent _e15 = fetchExtent(i_16);
    bool _e16 = isFlat(i_16);
    if (_e16) {
        return normalize(cross(_e15.a.xyz, _e15.b.xyz));
    }
    bool inside = (i_16 == ray_7.start.inside);
    vec3 _e27 = rotate(_e15.a, origin_9);
    vec3 _e30 = rotate(_e15.a, ray_7.direction);
    vec3 _e35 = boxNormal(_e27, _e30, _e15.b.xyz, ray_7.start.tMin, inside);
    vec3 _e37 = rotateBack(_e15.a, _e35);
    return _e37;
}

Start onSurface(vec3 point, uint shape_1, bool seenFromInside) {
    return Start(point, (seenFromInside ? noShape : shape_1), (seenFromInside ? shape_1 : noShape), (1e-5 * length(point)));
}

Material fetchMaterial(uint i_17) {
    vec4 t0_3 = texelFetch(sceneTable, ivec2(uvec2(3u, i_17)), 0);
    vec4 t1_2 = texelFetch(sceneTable, ivec2(uvec2(4u, i_17)), 0);
    return Material(t0_3.xyz, t0_3.w, t1_2.x, t1_2.y, t1_2.z, t1_2.w);
}

uint pcg(uint x) {
    uint s_1 = ((x * 747796405u) + 2891336453u);
    uint w = (((s_1 >> ((s_1 >> 28u) + 4u)) ^ s_1) * 277803737u);
    return ((w >> 22u) ^ w);
}

float unitFloat(uint h) {
    return (float((h >> 8u)) * 5.9604645e-8);
}

LightSampler lightSampler(uint count, uint pixelHash, uint light, uint reflection) {
    uint _e8 = pcg(((pixelHash + (64u * light)) + reflection));
    float _e9 = unitFloat(_e8);
    uint _e10 = pcg(_e8);
    float _e11 = unitFloat(_e10);
    return LightSampler(count, vec2(_e9, _e11));
}

uint everySample(SampleGroup group) {
    return (4294967295u >> (32u - group.count));
}

float sampleReach(uint count_1) {
    if ((count_1 == 1u)) {
        return 0.0;
    }
    return ((count_1 == 9u) ? 0.70710677 : 1.0);
}

ShadowCone shadowCone(vec3 apex, vec3 center_2, float radius_1, uint count_2) {
    vec3 toLight_2 = (center_2 - apex);
    float distance_ = max(length(toLight_2), 1e-30);
    float _e8 = sampleReach(count_2);
    float reach_1 = (radius_1 * _e8);
    float sine = min((reach_1 / distance_), 1.0);
    float cosine = sqrt((1.0 - (sine * sine)));
    return ShadowCone(apex, (toLight_2 / vec3(distance_)), (distance_ - reach_1), (distance_ + reach_1), sine, cosine, ((cosine < 0.001) ? 1e30 : (sine / cosine)));
}

bool coneMissesBall(ShadowCone cone, BallPlace ball, float radius_2) {
    float beside = ((ball.across * cone.cosine) - (ball.along * cone.sine));
    float outside = max(max(beside, -(ball.along)), (ball.along - cone.end));
    return (outside > ((cone.tangent == 1e30) ? 1e30 : radius_2));
}

BallPlace placeBall(ShadowCone cone_1, vec3 center_3) {
    vec3 toBall = (center_3 - cone_1.apex);
    float along_2 = dot(toBall, cone_1.axis);
    return BallPlace(along_2, length((toBall - (along_2 * cone_1.axis))));
}

bool coneMeetsPlane(ShadowCone cone_2, vec3 normal_1, float offset_1) {
    float here = (dot(normal_1, cone_2.apex) - offset_1);
    float there = (here + ((dot(normal_1, cone_2.axis) * 0.5) * (cone_2.start + cone_2.end)));
    return (min((here * there), (abs(there) - (0.5 * (cone_2.end - cone_2.start)))) <= 0.0);
}

uint candidates(SampleGroup group_1, ShadowCone cone_3, uint base) {
    uint found = 0u;
    uint i_18 = 0u;
    uint i_19 = 0u;
    uint _e5 = frame.occluderEnd;
    uint end_1 = min(_e5, (base + 32u));
    uint _e12 = frame.shapeEnds.z;
    uint ballEnd = min(_e12, end_1);
    i_18 = base;
    bool loop_init_6 = true;
    while(true) {
        if (!loop_init_6) {
            uint _e34 = i_18;
            i_18 = (_e34 + 1u);
        }
        loop_init_6 = false;
        uint _e17 = i_18;
        if ((_e17 < ballEnd)) {
        } else {
            break;
        }
        {
            uint _e19 = i_18;
            Bounds _e20 = fetchBounds(_e19);
            uint _e21 = found;
            BallPlace _e25 = placeBall(cone_3, _e20.center);
            bool _e27 = coneMissesBall(cone_3, _e25, _e20.radius);
            uint _e29 = i_18;
            found = (_e21 | ((_e27 ? 0u : 1u) << (_e29 - base)));
        }
    }
    i_19 = max(base, ballEnd);
    bool loop_init_7 = true;
    while(true) {
        if (!loop_init_7) {
            uint _e54 = i_19;
            i_19 = (_e54 + 1u);
        }
        loop_init_7 = false;
        uint _e38 = i_19;
        if ((_e38 < end_1)) {
        } else {
            break;
        }
        {
            uint _e40 = i_19;
            Bounds _e41 = fetchBounds(_e40);
            uint _e42 = found;
            bool _e47 = coneMeetsPlane(cone_3, _e41.center, _e41.radius);
            uint _e49 = i_19;
            found = (_e42 | ((_e47 ? 1u : 0u) << (_e49 - base)));
        }
    }
    uint inside_1 = (group_1.start.inside - base);
    uint leaves = (group_1.start.leaves - base);
    uint _e62 = found;
    found = (_e62 | ((inside_1 < 32u) ? (1u << (inside_1 & 31u)) : 0u));
    uint _e72 = found;
    return (_e72 & ~(((leaves < 32u) ? (1u << (leaves & 31u)) : 0u)));
}

uint lowestBit(uint bits) {
    return ((floatBitsToUint(float((bits & (~(bits) + 1u)))) >> 23u) - 127u);
}

bool ballHidesLight(ShadowCone cone_4, BallPlace ball_1, float radius_3) {
    float covers = (((radius_3 * 0.9999) - (ball_1.across * cone_4.cosine)) - (ball_1.along * cone_4.sine));
    return (min(min(covers, (ball_1.along - radius_3)), ((cone_4.start - ball_1.along) - radius_3)) > 0.0);
}

vec3 samplePoint(LightSampler s, uint k) {
    if ((s.count == 1u)) {
        return vec3(0.0);
    }
    float i_24 = float(k);
    if ((s.count == 9u)) {
        float row = floor(((i_24 + 0.5) * 0.33333334));
        return vec3(((0.5 * (i_24 - (3.0 * row))) - 0.5), 0.0, ((0.5 * row) - 0.5));
    }
    float z = (1.0 - ((2.0 * (i_24 + s.shift.x)) / float(s.count)));
    float phi = (6.2831855 * fract(((i_24 * 0.618034) + s.shift.y)));
    float r = sqrt(max((1.0 - (z * z)), 0.0));
    return vec3((r * cos(phi)), (r * sin(phi)), z);
}

vec3 toSample(SampleGroup group_2, uint k_1) {
    vec3 _e7 = samplePoint(group_2.points, (group_2.first + k_1));
    return ((group_2.center + (group_2.radius * _e7)) - group_2.start.point);
}

uint behindSphere(SampleGroup group_3, uint i_20, Bounds bounds_4, ShadowCone cone_5) {
    uint bits_1 = 0u;
    uint k_2 = 0u;
    BallPlace _e5 = placeBall(cone_5, bounds_4.center);
    bool _e7 = ballHidesLight(cone_5, _e5, bounds_4.radius);
    bool hides = (_e7 && (i_20 != group_3.start.inside));
    uint _e13 = everySample(group_3);
    bits_1 = (hides ? _e13 : 0u);
    uint count_3 = (hides ? 0u : group_3.count);
    bool loop_init_8 = true;
    while(true) {
        if (!loop_init_8) {
            uint _e42 = k_2;
            k_2 = (_e42 + 1u);
        }
        loop_init_8 = false;
        uint _e21 = k_2;
        if ((_e21 < count_3)) {
        } else {
            break;
        }
        {
            uint _e23 = k_2;
            vec3 _e24 = toSample(group_3, _e23);
            float inverse_ = inversesqrt(dot(_e24, _e24));
            uint _e27 = bits_1;
            float _e33 = hitSphere(i_20, bounds_4, Ray(group_3.start, (_e24 * inverse_)));
            uint _e38 = k_2;
            bits_1 = (_e27 | ((((_e33 * inverse_) < 1.0) ? 1u : 0u) << _e38));
        }
    }
    uint _e44 = bits_1;
    return _e44;
}

uint behindFlat(SampleGroup group_4, uint i_21, Bounds bounds_5) {
    uint bits_2 = 0u;
    uint k_3 = 0u;
    float t_4 = 0.0;
    bool _e3 = isPlane(i_21);
    bool loop_init_9 = true;
    while(true) {
        if (!loop_init_9) {
            uint _e34 = k_3;
            k_3 = (_e34 + 1u);
        }
        loop_init_9 = false;
        uint _e8 = k_3;
        if ((_e8 < group_4.count)) {
        } else {
            break;
        }
        {
            uint _e11 = k_3;
            vec3 _e12 = toSample(group_4, _e11);
            float inverse_1 = inversesqrt(dot(_e12, _e12));
            Ray ray_9 = Ray(group_4.start, (_e12 * inverse_1));
            t_4 = 1e30;
            if (_e3) {
                float _e20 = hitPlane(i_21, bounds_5, ray_9);
                t_4 = _e20;
            } else {
                float _e21 = hitQuad(i_21, bounds_5, ray_9);
                t_4 = _e21;
            }
            uint _e22 = bits_2;
            uint _e25 = k_3;
            float _e27 = t_4;
            bits_2 = (_e22 | (((_e27 * inverse_1) < 1.0) ? (1u << _e25) : 0u));
        }
    }
    uint _e36 = bits_2;
    return _e36;
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
    bool hides_1 = ((through && apexOutside) && (_e48 > radius_4));
    return ((met || (cone_6.tangent == 1e30)) ? (hides_1 ? boxHidesLight : boxMet) : boxMissed);
}

uint behindBox(SampleGroup group_5, uint i_22, Bounds bounds_6, ShadowCone cone_7) {
    vec3 origin_8 = vec3(0.0);
    vec3 axis_1 = vec3(0.0);
    uint bits_3 = 0u;
    uint k_4 = 0u;
    vec3 direction_8 = vec3(0.0);
    Extent _e4 = fetchExtent(i_22);
    bool _e6 = isTurned(_e4.a);
    origin_8 = (group_5.start.point - bounds_6.center);
    axis_1 = cone_7.axis;
    vec3 _e15 = origin_8;
    vec3 _e16 = axis_1;
    float end_2 = (bounds_6.radius - dot(_e15, _e16));
    if (_e6) {
        vec3 _e20 = origin_8;
        vec3 _e21 = rotate(_e4.a, _e20);
        origin_8 = _e21;
        vec3 _e23 = axis_1;
        vec3 _e24 = rotate(_e4.a, _e23);
        axis_1 = _e24;
    }
    bool startsInside_3 = (i_22 == group_5.start.inside);
    vec3 _e28 = origin_8;
    vec3 _e29 = axis_1;
    uint _e32 = placeBox(cone_7, _e28, _e29, _e4.b.xyz, end_2);
    uint meets = (startsInside_3 ? boxMet : _e32);
    uint _e36 = everySample(group_5);
    bits_3 = ((meets == boxHidesLight) ? _e36 : 0u);
    uint count_4 = ((meets == boxMet) ? group_5.count : 0u);
    bool loop_init_10 = true;
    while(true) {
        if (!loop_init_10) {
            uint _e77 = k_4;
            k_4 = (_e77 + 1u);
        }
        loop_init_10 = false;
        uint _e48 = k_4;
        if ((_e48 < count_4)) {
        } else {
            break;
        }
        {
            uint _e50 = k_4;
            vec3 _e51 = toSample(group_5, _e50);
            float inverse_2 = inversesqrt(dot(_e51, _e51));
            direction_8 = (_e51 * inverse_2);
            if (_e6) {
                vec3 _e57 = direction_8;
                vec3 _e58 = rotate(_e4.a, _e57);
                direction_8 = _e58;
            }
            vec3 _e59 = origin_8;
            vec3 _e60 = direction_8;
            float _e65 = intersectBox(_e59, _e60, _e4.b.xyz, group_5.start.tMin, startsInside_3);
            uint _e66 = bits_3;
            uint _e73 = k_4;
            bits_3 = (_e66 | ((((_e65 * inverse_2) < 1.0) ? 1u : 0u) << _e73));
        }
    }
    uint _e79 = bits_3;
    return _e79;
}

uint hiddenSamples(SampleGroup group_6) {
    uint hidden = 0u;
    uint base_1 = 0u;
    uint rest = 0u;
    uint _e1 = everySample(group_6);
    ShadowCone _e8 = shadowCone(group_6.start.point, group_6.center, group_6.radius, group_6.points.count);
    bool loop_init_11 = true;
    while(true) {
        if (!loop_init_11) {
            uint _e49 = base_1;
            base_1 = (_e49 + 32u);
        }
        loop_init_11 = false;
        uint _e13 = base_1;
        uint _e16 = frame.occluderEnd;
        if ((_e13 < _e16)) {
        } else {
            break;
        }
        {
            uint _e18 = base_1;
            uint _e19 = candidates(group_6, _e8, _e18);
            rest = _e19;
            while(true) {
                uint _e21 = rest;
                if ((_e21 != 0u)) {
                } else {
                    break;
                }
                {
                    uint _e24 = base_1;
                    uint _e25 = rest;
                    uint _e26 = lowestBit(_e25);
                    uint i_25 = (_e24 + _e26);
                    Bounds _e28 = fetchBounds(i_25);
                    bool _e29 = isSphere(i_25);
                    if (_e29) {
                        uint _e30 = hidden;
                        uint _e31 = behindSphere(group_6, i_25, _e28, _e8);
                        hidden = (_e30 | _e31);
                    } else {
                        bool _e33 = isFlat(i_25);
                        if (_e33) {
                            uint _e34 = hidden;
                            uint _e35 = behindFlat(group_6, i_25, _e28);
                            hidden = (_e34 | _e35);
                        } else {
                            uint _e37 = hidden;
                            uint _e38 = behindBox(group_6, i_25, _e28, _e8);
                            hidden = (_e37 | _e38);
                        }
                    }
                    uint _e40 = rest;
                    uint _e41 = rest;
                    uint _e46 = hidden;
                    rest = ((_e46 == _e1) ? 0u : (_e40 & (_e41 - 1u)));
                }
            }
        }
    }
    uint _e52 = hidden;
    return _e52;
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

vec3 shade(SurfacePoint p_1, Material m_1, uint pixelHash_1, uint reflection_1, uint sampleCount) {
    vec3 color = vec3(0.0);
    uint i_23 = 0u;
    vec3 sum_2 = vec3(0.0);
    uint first = 0u;
    uint k_5 = 0u;
    bool loop_init_12 = true;
    while(true) {
        if (!loop_init_12) {
            uint _e78 = i_23;
            i_23 = (_e78 + 1u);
        }
        loop_init_12 = false;
        uint _e10 = i_23;
        uint _e13 = frame.lightCount;
        if ((_e10 < _e13)) {
        } else {
            break;
        }
        {
            uint _e15 = i_23;
            Light _e16 = fetchLight(_e15);
            vec3 _e17 = color;
            color = (_e17 + (_e16.ambient * m_1.baseColor));
            if ((dot(p_1.normal, (_e16.center - p_1.start.point)) <= -(_e16.radius))) {
                continue;
            }
            uint _e31 = i_23;
            LightSampler _e32 = lightSampler(sampleCount, pixelHash_1, _e31, reflection_1);
            sum_2 = vec3(0.0);
            first = 0u;
            bool loop_init_13 = true;
            while(true) {
                if (!loop_init_13) {
                    uint _e68 = first;
                    first = (_e68 + 32u);
                }
                loop_init_13 = false;
                uint _e38 = first;
                if ((_e38 < sampleCount)) {
                } else {
                    break;
                }
                {
                    uint _e40 = first;
                    uint count_5 = min((sampleCount - _e40), 32u);
                    uint _e47 = first;
                    SampleGroup group_7 = SampleGroup(p_1.start, _e16.center, _e16.radius, _e32, _e47, count_5);
                    uint _e49 = hiddenSamples(group_7);
                    k_5 = 0u;
                    bool loop_init_14 = true;
                    while(true) {
                        if (!loop_init_14) {
                            uint _e66 = k_5;
                            k_5 = (_e66 + 1u);
                        }
                        loop_init_14 = false;
                        uint _e52 = k_5;
                        if ((_e52 < count_5)) {
                        } else {
                            break;
                        }
                        {
                            uint _e54 = k_5;
                            if ((((_e49 >> _e54) & 1u) == 0u)) {
                                vec3 _e60 = sum_2;
                                uint _e61 = k_5;
                                vec3 _e62 = toSample(group_7, _e61);
                                vec3 _e63 = sampleLight(p_1, m_1, _e16, _e62);
                                sum_2 = (_e60 + _e63);
                            }
                        }
                    }
                }
            }
            vec3 _e71 = color;
            vec3 _e72 = sum_2;
            color = (_e71 + (_e72 / vec3(float(sampleCount))));
        }
    }
    vec3 _e80 = color;
    return _e80;
}

vec3 trace(Ray first_1, uint hash, uint maxReflections, uint lightSamples) {
    Ray ray_8 = Ray(Start(vec3(0.0), 0u, 0u, 0.0), vec3(0.0));
    float weight = 1.0;
    vec3 radiance = vec3(0.0);
    uint reflection_2 = 0u;
    bool local = false;
    ray_8 = first_1;
    bool loop_init_15 = true;
    while(true) {
        if (!loop_init_15) {
            uint _e99 = reflection_2;
            reflection_2 = (_e99 + 1u);
        }
        loop_init_15 = false;
        uint _e12 = reflection_2;
        if ((_e12 <= maxReflections)) {
        } else {
            break;
        }
        {
            Ray _e14 = ray_8;
            Hit _e15 = closestHit(_e14);
            Ray _e16 = ray_8;
            SeenLight _e18 = closestBall(_e16, _e15.t);
            vec3 _e19 = radiance;
            float _e20 = weight;
            Ray _e21 = ray_8;
            vec3 _e23 = halo(_e21, _e18.t);
            radiance = (_e19 + (_e20 * _e23));
            if ((_e18.t < _e15.t)) {
                vec3 _e29 = radiance;
                float _e30 = weight;
                radiance = (_e29 + (_e30 * _e18.ball));
                break;
            }
            if ((_e15.shape == noShape)) {
                vec3 _e37 = radiance;
                float _e38 = weight;
                vec3 _e40 = ray_8.direction;
                vec3 _e41 = sky(_e40);
                radiance = (_e37 + (_e38 * _e41));
                break;
            }
            vec3 _e46 = ray_8.start.point;
            vec3 _e49 = ray_8.direction;
            vec3 position = (_e46 + (_e15.t * _e49));
            Ray _e53 = ray_8;
            vec3 _e55 = outwardNormal(_e15.shape, _e53, _e15.t);
            vec3 _e57 = ray_8.direction;
            bool seenFromBack = (dot(_e55, _e57) > 0.0);
            vec3 normal_3 = (seenFromBack ? -(_e55) : _e55);
            if (seenFromBack) {
                bool _e67 = isFlat(_e15.shape);
                local = !(_e67);
            } else {
                local = false;
            }
            bool _e70 = local;
            Start _e71 = onSurface(position, _e15.shape, _e70);
            Material _e73 = fetchMaterial(_e15.shape);
            vec3 _e75 = ray_8.direction;
            SurfacePoint point_1 = SurfacePoint(_e71, normal_3, -(_e75));
            vec3 _e78 = radiance;
            float _e79 = weight;
            uint _e84 = reflection_2;
            vec3 _e85 = shade(point_1, _e73, hash, _e84, lightSamples);
            radiance = (_e78 + ((_e79 * (1.0 - _e73.reflectivity)) * _e85));
            float _e88 = weight;
            weight = (_e88 * _e73.reflectivity);
            float _e91 = weight;
            if ((_e91 < 0.00024414063)) {
                break;
            }
            vec3 _e95 = ray_8.direction;
            ray_8 = Ray(_e71, reflect(_e95, normal_3));
        }
    }
    vec3 _e101 = radiance;
    return _e101;
}

vec3 pinholeDirection(vec2 filmPoint) {
    float _e6 = frame.width;
    float x_1 = (((2.0 * filmPoint.x) / _e6) - 1.0);
    float _e15 = frame.height;
    float y = (1.0 - ((2.0 * filmPoint.y) / _e15));
    vec3 _e21 = frame.forward;
    vec3 _e24 = frame.right;
    vec3 _e29 = frame.up;
    return normalize(((_e21 + (x_1 * _e24)) + (y * _e29)));
}

uint pixelHash0_(uvec2 pixel, uint sampleIndex, uint seed) {
    uint _e5 = pcg(seed);
    uint _e7 = pcg((sampleIndex + _e5));
    uint _e9 = pcg((pixel.y + _e7));
    uint _e11 = pcg((pixel.x + _e9));
    return _e11;
}

Start atEye() {
    return Start(vec3(0.0), 4294967295u, 4294967295u, 0.0);
}

void main() {
    vec4 fragment = gl_FragCoord;
    vec4 sum = vec4(0.0);
    uvec2 pixel_1 = uvec2(fragment.xy);
    float column = (float(pixel_1.x) + 0.5);
    float _e12 = frame.dividers.x;
    float _e18 = frame.dividers.y;
    uvec4 panel = frame.panels[(uint((column >= _e12)) + uint((column >= _e18)))];
    vec2 _e28 = frame.jitter;
    vec3 _e30 = pinholeDirection((floor(fragment.xy) + _e28));
    uint _e33 = frame.sampleIndex;
    uint _e36 = frame.seed;
    uint _e37 = pixelHash0_(pixel_1, _e33, _e36);
    Start _e38 = atEye();
    vec3 _e42 = trace(Ray(_e38, _e30), _e37, panel.x, panel.y);
    uint _e48 = frame.sampleIndex;
    if ((_e48 > 0u)) {
        vec4 _e53 = texelFetch(previousFilm, ivec2(pixel_1), 0);
        sum = _e53;
    }
    vec4 _e54 = sum;
    _fs2p_location0 = (_e54 + vec4(_e42, 1.0));
    return;
}

