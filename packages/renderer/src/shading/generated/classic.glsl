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
    uint spare0_;
    uint spare1_;
    uint spare2_;
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
struct ShadowCone {
    vec3 apex;
    vec3 axis;
    float length_;
    float reach;
    float sine;
    float cosine2_;
};
const uint noShape = 4294967295u;

layout(std140) uniform FrameBlock { Frame frame; };

uniform highp sampler2D sceneTable;

uniform highp sampler2D previousFilm;

layout(location = 0) out vec4 _fs2p_location0;

uint shapeCount() {
    uint _e3 = frame.shapeEnds.w;
    return _e3;
}

bool isSphere(uint i) {
    uint _e4 = frame.shapeEnds.x;
    return (i < _e4);
}

float intersectSphere(vec3 origin, vec3 direction, vec3 center, float radius, float tMin, bool startsInside) {
    bool local = false;
    vec3 toCenter = (center - origin);
    float along = dot(toCenter, direction);
    vec3 across = (toCenter - (along * direction));
    float discriminant = ((radius * radius) - dot(across, across));
    if ((discriminant < 0.0)) {
        return 1e30;
    }
    float half_ = sqrt(discriminant);
    float near_1 = (along - half_);
    float far_1 = (along + half_);
    if ((near_1 > tMin)) {
        local = !(startsInside);
    } else {
        local = false;
    }
    bool _e24 = local;
    if (_e24) {
        return near_1;
    }
    return ((far_1 > tMin) ? far_1 : 1e30);
}

bool isPlane(uint i_1) {
    uint _e4 = frame.shapeEnds.z;
    return (i_1 >= _e4);
}

float intersectPlane(vec3 origin_1, vec3 direction_1, vec3 normal, float offset, float tMin_1) {
    float speed = dot(direction_1, normal);
    if ((speed == 0.0)) {
        return 1e30;
    }
    float t_2 = ((offset - dot(origin_1, normal)) / speed);
    return ((t_2 > tMin_1) ? t_2 : 1e30);
}

Extent fetchExtent(uint i_2) {
    vec4 t0_ = texelFetch(sceneTable, ivec2(uvec2(1u, i_2)), 0);
    vec4 t1_ = texelFetch(sceneTable, ivec2(uvec2(2u, i_2)), 0);
    return Extent(t0_.xyzw, t1_.xyzw);
}

bool isFlat(uint i_3) {
    uint _e4 = frame.shapeEnds.y;
    return (i_3 >= _e4);
}

float intersectQuad(vec3 origin_2, vec3 direction_2, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    bool local_1 = false;
    bool local_2 = false;
    vec3 normal_1 = cross(reciprocalU, reciprocalV);
    float speed_1 = dot(direction_2, normal_1);
    if ((speed_1 == 0.0)) {
        return 1e30;
    }
    vec3 toCenter_1 = (center_1 - origin_2);
    float t_3 = (dot(toCenter_1, normal_1) / speed_1);
    vec3 p_2 = ((t_3 * direction_2) - toCenter_1);
    if ((abs(dot(p_2, reciprocalU)) <= 0.500001)) {
        local_1 = (abs(dot(p_2, reciprocalV)) <= 0.500001);
    } else {
        local_1 = false;
    }
    bool within = local_1;
    if ((t_3 > tMin_2)) {
        local_2 = within;
    } else {
        local_2 = false;
    }
    bool _e31 = local_2;
    return (_e31 ? t_3 : 1e30);
}

vec3 rotate(vec4 q, vec3 v) {
    vec3 t_4 = (2.0 * cross(q.xyz, v));
    return ((v + (q.w * t_4)) + cross(q.xyz, t_4));
}

vec3 safeReciprocal(vec3 d) {
    return (vec3(1.0) / mix(d, vec3(1e-18), lessThan(abs(d), vec3(1e-18))));
}

float intersectBox(vec3 origin_3, vec3 direction_3, vec3 halfSize, float tMin_3, bool startsInside_1) {
    bool local_3 = false;
    vec3 _e5 = safeReciprocal(direction_3);
    vec3 middle = (-(origin_3) * _e5);
    vec3 reach = (halfSize * abs(_e5));
    vec3 enter = (middle - reach);
    vec3 leave = (middle + reach);
    float near_2 = max(max(enter.x, enter.y), enter.z);
    float far_2 = min(min(leave.x, leave.y), leave.z);
    if ((near_2 > far_2)) {
        return 1e30;
    }
    if ((near_2 > tMin_3)) {
        local_3 = !(startsInside_1);
    } else {
        local_3 = false;
    }
    bool _e29 = local_3;
    if (_e29) {
        return near_2;
    }
    return ((far_2 > tMin_3) ? far_2 : 1e30);
}

float intersectShape(uint i_4, Bounds bounds, Ray ray) {
    vec3 origin_4 = vec3(0.0);
    vec3 direction_4 = vec3(0.0);
    if ((i_4 == ray.start.leaves)) {
        return 1e30;
    }
    bool startsInside_2 = (i_4 == ray.start.inside);
    bool _e10 = isSphere(i_4);
    if (_e10) {
        float _e18 = intersectSphere(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin, startsInside_2);
        return _e18;
    }
    bool _e19 = isPlane(i_4);
    if (_e19) {
        float _e27 = intersectPlane(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin);
        return _e27;
    }
    Extent _e28 = fetchExtent(i_4);
    bool _e29 = isFlat(i_4);
    if (_e29) {
        float _e40 = intersectQuad(ray.start.point, ray.direction, bounds.center, _e28.a.xyz, _e28.b.xyz, ray.start.tMin);
        return _e40;
    }
    origin_4 = (ray.start.point - bounds.center);
    direction_4 = ray.direction;
    if ((_e28.a.w != 1.0)) {
        vec3 _e53 = origin_4;
        vec3 _e54 = rotate(_e28.a, _e53);
        origin_4 = _e54;
        vec3 _e56 = direction_4;
        vec3 _e57 = rotate(_e28.a, _e56);
        direction_4 = _e57;
    }
    vec3 _e58 = origin_4;
    vec3 _e59 = direction_4;
    float _e64 = intersectBox(_e58, _e59, _e28.b.xyz, ray.start.tMin, startsInside_2);
    return _e64;
}

Bounds fetchBounds(uint i_5) {
    vec4 t0_1 = texelFetch(sceneTable, ivec2(uvec2(0u, i_5)), 0);
    return Bounds(t0_1.xyz, t0_1.w);
}

Hit closestHit(Ray ray_1) {
    Hit hit = Hit(1e30, 4294967295u);
    uint i_6 = 0u;
    uint _e5 = shapeCount();
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e20 = i_6;
            i_6 = (_e20 + 1u);
        }
        loop_init = false;
        uint _e8 = i_6;
        if ((_e8 < _e5)) {
        } else {
            break;
        }
        {
            uint _e10 = i_6;
            uint _e11 = i_6;
            Bounds _e12 = fetchBounds(_e11);
            float _e13 = intersectShape(_e10, _e12, ray_1);
            float _e15 = hit.t;
            if ((_e13 < _e15)) {
                uint _e17 = i_6;
                hit = Hit(_e13, _e17);
            }
        }
    }
    Hit _e22 = hit;
    return _e22;
}

Light fetchLight(uint i_7) {
    vec4 t0_2 = texelFetch(sceneTable, ivec2(uvec2(5u, i_7)), 0);
    vec4 t1_1 = texelFetch(sceneTable, ivec2(uvec2(6u, i_7)), 0);
    vec4 t2_ = texelFetch(sceneTable, ivec2(uvec2(7u, i_7)), 0);
    vec4 t3_ = texelFetch(sceneTable, ivec2(uvec2(8u, i_7)), 0);
    return Light(t0_2.xyz, t0_2.w, t1_1.xyz, t1_1.w, t2_.xyz, t2_.w, t3_.xyz, t3_.w);
}

SeenLight closestBall(Ray ray_2, float t) {
    SeenLight seen = SeenLight(0.0, vec3(0.0));
    uint i_8 = 0u;
    seen = SeenLight(t, vec3(0.0));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e35 = i_8;
            i_8 = (_e35 + 1u);
        }
        loop_init_1 = false;
        uint _e8 = i_8;
        uint _e11 = frame.lightCount;
        if ((_e8 < _e11)) {
        } else {
            break;
        }
        {
            uint _e13 = i_8;
            Light _e14 = fetchLight(_e13);
            if ((_e14.visible < 0.0)) {
                continue;
            }
            float _e26 = intersectSphere(ray_2.start.point, ray_2.direction, _e14.center, _e14.radius, ray_2.start.tMin, false);
            float _e28 = seen.t;
            if ((_e26 < _e28)) {
                seen = SeenLight(_e26, (_e14.visible * _e14.diffuse));
            }
        }
    }
    SeenLight _e37 = seen;
    return _e37;
}

vec3 halo(Ray ray_3, float t_1) {
    vec3 sum_1 = vec3(0.0);
    uint i_9 = 0u;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e45 = i_9;
            i_9 = (_e45 + 1u);
        }
        loop_init_2 = false;
        uint _e7 = i_9;
        uint _e10 = frame.lightCount;
        if ((_e7 < _e10)) {
        } else {
            break;
        }
        {
            uint _e12 = i_9;
            Light _e13 = fetchLight(_e12);
            if ((_e13.halo <= 0.0)) {
                continue;
            }
            vec3 toLight = (_e13.center - ray_3.start.point);
            float along_1 = dot(toLight, ray_3.direction);
            vec3 across_1 = (toLight - (along_1 * ray_3.direction));
            float b = max(length(across_1), _e13.radius);
            vec3 _e29 = sum_1;
            sum_1 = (_e29 + ((_e13.halo * _e13.diffuse) * ((atan(((min(t_1, 100000.0) - along_1) / b)) + atan((along_1 / b))) / b)));
        }
    }
    vec3 _e47 = sum_1;
    return _e47;
}

vec3 sky(vec3 direction_5) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_5.y, 0.0));
}

vec3 rotateBack(vec4 q_1, vec3 v_1) {
    vec3 _e6 = rotate(vec4(-(q_1.xyz), q_1.w), v_1);
    return _e6;
}

vec3 boxNormal(vec3 point, vec3 halfSize_1) {
    bool local_4 = false;
    vec3 gap = abs((abs(point) - halfSize_1));
    if ((gap.x <= gap.y)) {
        local_4 = (gap.x <= gap.z);
    } else {
        local_4 = false;
    }
    bool _e14 = local_4;
    if (_e14) {
        return vec3(((point.x > 0.0) ? 1.0 : -1.0), 0.0, 0.0);
    }
    if ((gap.y <= gap.z)) {
        return vec3(0.0, ((point.y > 0.0) ? 1.0 : -1.0), 0.0);
    }
    return vec3(0.0, 0.0, ((point.z > 0.0) ? 1.0 : -1.0));
}

vec3 outwardNormal(uint i_10, vec3 point_1) {
    Bounds _e2 = fetchBounds(i_10);
    bool _e3 = isSphere(i_10);
    if (_e3) {
        return normalize((point_1 - _e2.center));
    }
    bool _e7 = isPlane(i_10);
    if (_e7) {
        return _e2.center;
    }
    Extent _e9 = fetchExtent(i_10);
    bool _e10 = isFlat(i_10);
    if (_e10) {
        return normalize(cross(_e9.a.xyz, _e9.b.xyz));
    }
    vec3 _e21 = rotate(_e9.a, (point_1 - _e2.center));
    vec3 _e24 = boxNormal(_e21, _e9.b.xyz);
    vec3 _e25 = rotateBack(_e9.a, _e24);
    return _e25;
}

Start onSurface(vec3 point_2, uint shape, bool seenFromInside) {
    return Start(point_2, (seenFromInside ? noShape : shape), (seenFromInside ? shape : noShape), (1e-5 * length(point_2)));
}

Material fetchMaterial(uint i_11) {
    vec4 t0_3 = texelFetch(sceneTable, ivec2(uvec2(3u, i_11)), 0);
    vec4 t1_2 = texelFetch(sceneTable, ivec2(uvec2(4u, i_11)), 0);
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

float sampleReach(uint count_1) {
    if ((count_1 == 1u)) {
        return 0.0;
    }
    return ((count_1 == 9u) ? 0.70710677 : 1.0);
}

ShadowCone shadowCone(vec3 apex, Light light_1, uint count_2) {
    vec3 toLight_1 = (light_1.center - apex);
    float distance_ = max(length(toLight_1), 1e-30);
    float _e9 = sampleReach(count_2);
    float reach_1 = (light_1.radius * _e9);
    float sine = min((reach_1 / distance_), 1.0);
    return ShadowCone(apex, (toLight_1 / vec3(distance_)), distance_, reach_1, sine, (1.0 - (sine * sine)));
}

bool isBox(uint i_12) {
    bool local_5 = false;
    uint _e4 = frame.shapeEnds.x;
    if ((i_12 >= _e4)) {
        uint _e11 = frame.shapeEnds.y;
        local_5 = (i_12 < _e11);
    } else {
        local_5 = false;
    }
    bool _e14 = local_5;
    return _e14;
}

bool mayOcclude(uint i_13, Bounds bounds_1, ShadowCone cone) {
    bool local_6 = false;
    bool local_7 = false;
    bool local_8 = false;
    bool local_9 = false;
    bool local_10 = false;
    vec3 near = vec3(0.0);
    vec3 far = vec3(0.0);
    bool local_11 = false;
    bool _e3 = isPlane(i_13);
    if (_e3) {
        float here = (dot(bounds_1.center, cone.apex) - bounds_1.radius);
        float there = (here + (dot(bounds_1.center, cone.axis) * cone.length_));
        if (!(((here * there) <= 0.0))) {
            local_6 = (abs(there) <= cone.reach);
        } else {
            local_6 = true;
        }
        bool _e25 = local_6;
        return _e25;
    }
    vec3 toShape = (bounds_1.center - cone.apex);
    float along_2 = dot(toShape, cone.axis);
    float perpendicular2_ = (dot(toShape, toShape) - (along_2 * along_2));
    float limit = (bounds_1.radius + (along_2 * cone.sine));
    if (!((limit < 0.0))) {
        local_7 = ((perpendicular2_ * cone.cosine2_) > (limit * limit));
    } else {
        local_7 = true;
    }
    bool outside = local_7;
    if (!((along_2 < -(bounds_1.radius)))) {
        local_8 = (along_2 > ((cone.length_ + cone.reach) + bounds_1.radius));
    } else {
        local_8 = true;
    }
    bool behind = local_8;
    if (outside) {
        local_9 = (cone.sine < 1.0);
    } else {
        local_9 = false;
    }
    bool _e69 = local_9;
    if (!(_e69)) {
        local_10 = behind;
    } else {
        local_10 = true;
    }
    bool _e74 = local_10;
    if (_e74) {
        return false;
    }
    bool _e76 = isBox(i_13);
    if (!(_e76)) {
        return true;
    }
    Extent _e79 = fetchExtent(i_13);
    near = -(toShape);
    vec3 _e82 = near;
    far = (_e82 + (cone.axis * cone.length_));
    if ((_e79.a.w != 1.0)) {
        vec3 _e93 = near;
        vec3 _e94 = rotate(_e79.a, _e93);
        near = _e94;
        vec3 _e96 = far;
        vec3 _e97 = rotate(_e79.a, _e96);
        far = _e97;
    }
    vec3 _e98 = near;
    vec3 _e99 = far;
    vec3 low = min(_e98, (_e99 - vec3(cone.reach)));
    vec3 _e104 = near;
    vec3 _e105 = far;
    vec3 high = max(_e104, (_e105 + vec3(cone.reach)));
    if (all(lessThanEqual(low, _e79.b.xyz))) {
        local_11 = all(greaterThanEqual(high, -(_e79.b.xyz)));
    } else {
        local_11 = false;
    }
    bool _e122 = local_11;
    return _e122;
}

vec3 samplePoint(LightSampler s, uint k) {
    if ((s.count == 1u)) {
        return vec3(0.0);
    }
    float i_16 = float(k);
    if ((s.count == 9u)) {
        float row = floor(((i_16 + 0.5) / 3.0));
        return vec3(((0.5 * (i_16 - (3.0 * row))) - 0.5), 0.0, ((0.5 * row) - 0.5));
    }
    float z = (1.0 - ((2.0 * (i_16 + s.shift.x)) / float(s.count)));
    float phi = (6.2831855 * fract(((i_16 * 0.618034) + s.shift.y)));
    float r = sqrt(max((1.0 - (z * z)), 0.0));
    return vec3((r * cos(phi)), (r * sin(phi)), z);
}

uint hiddenSamples(Start start, Light light_2, LightSampler samples, uint first, uint count_3) {
    uint hidden = 0u;
    uint i_14 = 0u;
    bool local_12 = false;
    uint k_1 = 0u;
    ShadowCone _e7 = shadowCone(start.point, light_2, samples.count);
    uint allHidden = (4294967295u >> (32u - count_3));
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e72 = i_14;
            i_14 = (_e72 + 1u);
        }
        loop_init_3 = false;
        uint _e16 = i_14;
        uint _e19 = frame.occluderEnd;
        if ((_e16 < _e19)) {
        } else {
            break;
        }
        {
            uint _e21 = i_14;
            Bounds _e22 = fetchBounds(_e21);
            uint _e23 = i_14;
            if (!((_e23 == start.leaves))) {
                uint _e29 = i_14;
                bool _e30 = mayOcclude(_e29, _e22, _e7);
                local_12 = !(_e30);
            } else {
                local_12 = true;
            }
            bool _e33 = local_12;
            if (_e33) {
                continue;
            }
            k_1 = 0u;
            bool loop_init_4 = true;
            while(true) {
                if (!loop_init_4) {
                    uint _e67 = k_1;
                    k_1 = (_e67 + 1u);
                }
                loop_init_4 = false;
                uint _e36 = k_1;
                if ((_e36 < count_3)) {
                } else {
                    break;
                }
                {
                    uint _e38 = hidden;
                    uint _e39 = k_1;
                    if ((((_e38 >> _e39) & 1u) == 1u)) {
                        continue;
                    }
                    uint _e47 = k_1;
                    vec3 _e49 = samplePoint(samples, (first + _e47));
                    vec3 toSample_1 = ((light_2.center + (light_2.radius * _e49)) - start.point);
                    float distance_1 = length(toSample_1);
                    uint _e55 = i_14;
                    float _e59 = intersectShape(_e55, _e22, Ray(start, (toSample_1 / vec3(distance_1))));
                    if ((_e59 < distance_1)) {
                        uint _e61 = hidden;
                        uint _e63 = k_1;
                        hidden = (_e61 | (1u << _e63));
                    }
                }
            }
            uint _e69 = hidden;
            if ((_e69 == allHidden)) {
                break;
            }
        }
    }
    uint _e74 = hidden;
    return _e74;
}

vec3 sampleLight(SurfacePoint p, Material m, Light light_3, vec3 toSample) {
    vec3 c = vec3(0.0);
    float distance2_ = dot(toSample, toSample);
    vec3 l = (toSample * inversesqrt(distance2_));
    float cosine = dot(p.normal, l);
    if ((cosine <= 0.0)) {
        return vec3(0.0);
    }
    c = ((m.baseColor * light_3.diffuse) * cosine);
    if ((m.specular > 0.0)) {
        vec3 _e21 = c;
        c = (_e21 + ((m.specular * light_3.specular) * pow(max(dot(p.normal, normalize((l + p.view))), 1e-10), m.exponent)));
    }
    vec3 _e36 = c;
    return (_e36 * (light_3.power / distance2_));
}

vec3 shade(SurfacePoint p_1, Material m_1, uint pixelHash_1, uint reflection_1, uint sampleCount) {
    vec3 color = vec3(0.0);
    uint i_15 = 0u;
    vec3 sum_2 = vec3(0.0);
    uint first_1 = 0u;
    uint k_2 = 0u;
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            uint _e84 = i_15;
            i_15 = (_e84 + 1u);
        }
        loop_init_5 = false;
        uint _e10 = i_15;
        uint _e13 = frame.lightCount;
        if ((_e10 < _e13)) {
        } else {
            break;
        }
        {
            uint _e15 = i_15;
            Light _e16 = fetchLight(_e15);
            vec3 _e17 = color;
            color = (_e17 + (_e16.ambient * m_1.baseColor));
            if ((dot(p_1.normal, (_e16.center - p_1.start.point)) <= -(_e16.radius))) {
                continue;
            }
            uint _e31 = i_15;
            LightSampler _e32 = lightSampler(sampleCount, pixelHash_1, _e31, reflection_1);
            sum_2 = vec3(0.0);
            first_1 = 0u;
            bool loop_init_6 = true;
            while(true) {
                if (!loop_init_6) {
                    uint _e74 = first_1;
                    first_1 = (_e74 + 32u);
                }
                loop_init_6 = false;
                uint _e38 = first_1;
                if ((_e38 < sampleCount)) {
                } else {
                    break;
                }
                {
                    uint _e40 = first_1;
                    uint count_4 = min((sampleCount - _e40), 32u);
                    uint _e45 = first_1;
                    uint _e46 = hiddenSamples(p_1.start, _e16, _e32, _e45, count_4);
                    k_2 = 0u;
                    bool loop_init_7 = true;
                    while(true) {
                        if (!loop_init_7) {
                            uint _e72 = k_2;
                            k_2 = (_e72 + 1u);
                        }
                        loop_init_7 = false;
                        uint _e49 = k_2;
                        if ((_e49 < count_4)) {
                        } else {
                            break;
                        }
                        {
                            uint _e51 = k_2;
                            if ((((_e46 >> _e51) & 1u) == 1u)) {
                                continue;
                            }
                            vec3 _e57 = sum_2;
                            uint _e60 = first_1;
                            uint _e61 = k_2;
                            vec3 _e63 = samplePoint(_e32, (_e60 + _e61));
                            vec3 _e69 = sampleLight(p_1, m_1, _e16, ((_e16.center + (_e16.radius * _e63)) - p_1.start.point));
                            sum_2 = (_e57 + _e69);
                        }
                    }
                }
            }
            vec3 _e77 = color;
            vec3 _e78 = sum_2;
            color = (_e77 + (_e78 / vec3(float(sampleCount))));
        }
    }
    vec3 _e86 = color;
    return _e86;
}

vec3 trace(Ray first_2, uint hash, uint maxReflections, uint lightSamples) {
    Ray ray_4 = Ray(Start(vec3(0.0), 0u, 0u, 0.0), vec3(0.0));
    float weight = 1.0;
    vec3 radiance = vec3(0.0);
    uint reflection_2 = 0u;
    bool local_13 = false;
    ray_4 = first_2;
    bool loop_init_8 = true;
    while(true) {
        if (!loop_init_8) {
            uint _e97 = reflection_2;
            reflection_2 = (_e97 + 1u);
        }
        loop_init_8 = false;
        uint _e12 = reflection_2;
        if ((_e12 <= maxReflections)) {
        } else {
            break;
        }
        {
            Ray _e14 = ray_4;
            Hit _e15 = closestHit(_e14);
            Ray _e16 = ray_4;
            SeenLight _e18 = closestBall(_e16, _e15.t);
            vec3 _e19 = radiance;
            float _e20 = weight;
            Ray _e21 = ray_4;
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
                vec3 _e40 = ray_4.direction;
                vec3 _e41 = sky(_e40);
                radiance = (_e37 + (_e38 * _e41));
                break;
            }
            vec3 _e46 = ray_4.start.point;
            vec3 _e49 = ray_4.direction;
            vec3 position = (_e46 + (_e15.t * _e49));
            vec3 _e53 = outwardNormal(_e15.shape, position);
            vec3 _e55 = ray_4.direction;
            bool seenFromBack = (dot(_e53, _e55) > 0.0);
            vec3 normal_2 = (seenFromBack ? -(_e53) : _e53);
            if (seenFromBack) {
                bool _e65 = isFlat(_e15.shape);
                local_13 = !(_e65);
            } else {
                local_13 = false;
            }
            bool _e68 = local_13;
            Start _e69 = onSurface(position, _e15.shape, _e68);
            Material _e71 = fetchMaterial(_e15.shape);
            vec3 _e73 = ray_4.direction;
            SurfacePoint point_3 = SurfacePoint(_e69, normal_2, -(_e73));
            vec3 _e76 = radiance;
            float _e77 = weight;
            uint _e82 = reflection_2;
            vec3 _e83 = shade(point_3, _e71, hash, _e82, lightSamples);
            radiance = (_e76 + ((_e77 * (1.0 - _e71.reflectivity)) * _e83));
            float _e86 = weight;
            weight = (_e86 * _e71.reflectivity);
            float _e89 = weight;
            if ((_e89 < 0.00024414063)) {
                break;
            }
            vec3 _e93 = ray_4.direction;
            ray_4 = Ray(_e69, reflect(_e93, normal_2));
        }
    }
    vec3 _e99 = radiance;
    return _e99;
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

