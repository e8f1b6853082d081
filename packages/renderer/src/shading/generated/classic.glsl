#version 300 es

precision highp float;
precision highp int;

struct Ray {
    vec3 origin;
    vec3 direction;
    uint leaves;
    uint inside;
    float tMin;
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
    uvec4 panels[3];
};
struct Shape {
    vec3 center;
    float radius;
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
    vec3 position;
    vec3 normal;
    vec3 outward;
    vec3 view;
    uint shape;
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
    float cosine;
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

bool isFlat(uint i_1) {
    uint _e4 = frame.shapeEnds.y;
    return (i_1 >= _e4);
}

bool isPlane(uint i_2) {
    bool local_1 = false;
    uint _e4 = frame.shapeEnds.y;
    if ((i_2 >= _e4)) {
        uint _e11 = frame.shapeEnds.z;
        local_1 = (i_2 < _e11);
    } else {
        local_1 = false;
    }
    bool _e14 = local_1;
    return _e14;
}

float intersectPlane(vec3 origin_1, vec3 direction_1, vec3 normal, float offset, float tMin_1) {
    float speed = dot(direction_1, normal);
    if ((speed == 0.0)) {
        return 1e30;
    }
    float t_2 = ((offset - dot(origin_1, normal)) / speed);
    return ((t_2 > tMin_1) ? t_2 : 1e30);
}

float intersectQuad(vec3 origin_2, vec3 direction_2, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    bool local_2 = false;
    bool local_3 = false;
    vec3 normal_1 = cross(reciprocalU, reciprocalV);
    float speed_1 = dot(direction_2, normal_1);
    if ((speed_1 == 0.0)) {
        return 1e30;
    }
    vec3 toCenter_1 = (center_1 - origin_2);
    float t_3 = (dot(toCenter_1, normal_1) / speed_1);
    vec3 p_2 = ((t_3 * direction_2) - toCenter_1);
    if ((abs(dot(p_2, reciprocalU)) <= 0.500001)) {
        local_2 = (abs(dot(p_2, reciprocalV)) <= 0.500001);
    } else {
        local_2 = false;
    }
    bool within = local_2;
    if ((t_3 > tMin_2)) {
        local_3 = within;
    } else {
        local_3 = false;
    }
    bool _e31 = local_3;
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
    bool local_4 = false;
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
        local_4 = !(startsInside_1);
    } else {
        local_4 = false;
    }
    bool _e29 = local_4;
    if (_e29) {
        return near_2;
    }
    return ((far_2 > tMin_3) ? far_2 : 1e30);
}

float intersectShape(uint i_3, Shape shape, Ray ray) {
    vec3 origin_4 = vec3(0.0);
    vec3 direction_4 = vec3(0.0);
    if ((i_3 == ray.leaves)) {
        return 1e30;
    }
    bool startsInside_2 = (i_3 == ray.inside);
    bool _e8 = isSphere(i_3);
    if (_e8) {
        float _e14 = intersectSphere(ray.origin, ray.direction, shape.center, shape.radius, ray.tMin, startsInside_2);
        return _e14;
    }
    bool _e15 = isFlat(i_3);
    if (_e15) {
        bool _e16 = isPlane(i_3);
        if (_e16) {
            float _e22 = intersectPlane(ray.origin, ray.direction, shape.center, shape.radius, ray.tMin);
            return _e22;
        }
        float _e31 = intersectQuad(ray.origin, ray.direction, shape.center, shape.a.xyz, shape.b.xyz, ray.tMin);
        return _e31;
    }
    origin_4 = (ray.origin - shape.center);
    direction_4 = ray.direction;
    if ((shape.a.w != 1.0)) {
        vec3 _e43 = origin_4;
        vec3 _e44 = rotate(shape.a, _e43);
        origin_4 = _e44;
        vec3 _e46 = direction_4;
        vec3 _e47 = rotate(shape.a, _e46);
        direction_4 = _e47;
    }
    vec3 _e48 = origin_4;
    vec3 _e49 = direction_4;
    float _e53 = intersectBox(_e48, _e49, shape.b.xyz, ray.tMin, startsInside_2);
    return _e53;
}

Shape fetchShape(uint i_4) {
    vec4 t0_ = texelFetch(sceneTable, ivec2(uvec2(0u, i_4)), 0);
    vec4 t1_ = texelFetch(sceneTable, ivec2(uvec2(1u, i_4)), 0);
    vec4 t2_ = texelFetch(sceneTable, ivec2(uvec2(2u, i_4)), 0);
    return Shape(t0_.xyz, t0_.w, t1_.xyzw, t2_.xyzw);
}

Hit closestHit(Ray ray_1) {
    Hit hit = Hit(1e30, 4294967295u);
    uint i_5 = 0u;
    uint _e5 = shapeCount();
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e20 = i_5;
            i_5 = (_e20 + 1u);
        }
        loop_init = false;
        uint _e8 = i_5;
        if ((_e8 < _e5)) {
        } else {
            break;
        }
        {
            uint _e10 = i_5;
            uint _e11 = i_5;
            Shape _e12 = fetchShape(_e11);
            float _e13 = intersectShape(_e10, _e12, ray_1);
            float _e15 = hit.t;
            if ((_e13 < _e15)) {
                uint _e17 = i_5;
                hit = Hit(_e13, _e17);
            }
        }
    }
    Hit _e22 = hit;
    return _e22;
}

Light fetchLight(uint i_6) {
    vec4 t0_1 = texelFetch(sceneTable, ivec2(uvec2(5u, i_6)), 0);
    vec4 t1_1 = texelFetch(sceneTable, ivec2(uvec2(6u, i_6)), 0);
    vec4 t2_1 = texelFetch(sceneTable, ivec2(uvec2(7u, i_6)), 0);
    vec4 t3_ = texelFetch(sceneTable, ivec2(uvec2(8u, i_6)), 0);
    return Light(t0_1.xyz, t0_1.w, t1_1.xyz, t1_1.w, t2_1.xyz, t2_1.w, t3_.xyz, t3_.w);
}

SeenLight closestBall(Ray ray_2, float t) {
    SeenLight seen = SeenLight(0.0, vec3(0.0));
    uint i_7 = 0u;
    seen = SeenLight(t, vec3(0.0));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e33 = i_7;
            i_7 = (_e33 + 1u);
        }
        loop_init_1 = false;
        uint _e8 = i_7;
        uint _e11 = frame.lightCount;
        if ((_e8 < _e11)) {
        } else {
            break;
        }
        {
            uint _e13 = i_7;
            Light _e14 = fetchLight(_e13);
            if ((_e14.visible < 0.0)) {
                continue;
            }
            float _e24 = intersectSphere(ray_2.origin, ray_2.direction, _e14.center, _e14.radius, ray_2.tMin, false);
            float _e26 = seen.t;
            if ((_e24 < _e26)) {
                seen = SeenLight(_e24, (_e14.visible * _e14.diffuse));
            }
        }
    }
    SeenLight _e35 = seen;
    return _e35;
}

vec3 halo(Ray ray_3, float t_1) {
    vec3 sum_1 = vec3(0.0);
    uint i_8 = 0u;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e44 = i_8;
            i_8 = (_e44 + 1u);
        }
        loop_init_2 = false;
        uint _e7 = i_8;
        uint _e10 = frame.lightCount;
        if ((_e7 < _e10)) {
        } else {
            break;
        }
        {
            uint _e12 = i_8;
            Light _e13 = fetchLight(_e12);
            if ((_e13.halo <= 0.0)) {
                continue;
            }
            vec3 toLight = (_e13.center - ray_3.origin);
            float along_1 = dot(toLight, ray_3.direction);
            vec3 across_1 = (toLight - (along_1 * ray_3.direction));
            float b = max(length(across_1), _e13.radius);
            vec3 _e28 = sum_1;
            sum_1 = (_e28 + ((_e13.halo * _e13.diffuse) * ((atan(((min(t_1, 100000.0) - along_1) / b)) + atan((along_1 / b))) / b)));
        }
    }
    vec3 _e46 = sum_1;
    return _e46;
}

vec3 sky(vec3 direction_5) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_5.y, 0.0));
}

Material fetchMaterial(uint i_9) {
    vec4 t0_2 = texelFetch(sceneTable, ivec2(uvec2(3u, i_9)), 0);
    vec4 t1_2 = texelFetch(sceneTable, ivec2(uvec2(4u, i_9)), 0);
    return Material(t0_2.xyz, t0_2.w, t1_2.x, t1_2.y, t1_2.z, t1_2.w);
}

vec3 rotateBack(vec4 q_1, vec3 v_1) {
    vec3 _e6 = rotate(vec4(-(q_1.xyz), q_1.w), v_1);
    return _e6;
}

vec3 boxNormal(vec3 point, vec3 halfSize_1) {
    bool local_5 = false;
    vec3 gap = abs((abs(point) - halfSize_1));
    if ((gap.x <= gap.y)) {
        local_5 = (gap.x <= gap.z);
    } else {
        local_5 = false;
    }
    bool _e14 = local_5;
    if (_e14) {
        return vec3(((point.x > 0.0) ? 1.0 : -1.0), 0.0, 0.0);
    }
    if ((gap.y <= gap.z)) {
        return vec3(0.0, ((point.y > 0.0) ? 1.0 : -1.0), 0.0);
    }
    return vec3(0.0, 0.0, ((point.z > 0.0) ? 1.0 : -1.0));
}

vec3 outwardNormal(uint i_10, Shape shape_1, vec3 point_1) {
    bool _e3 = isSphere(i_10);
    if (_e3) {
        return normalize((point_1 - shape_1.center));
    }
    bool _e7 = isFlat(i_10);
    if (_e7) {
        bool _e8 = isPlane(i_10);
        if (_e8) {
            return shape_1.center;
        }
        return normalize(cross(shape_1.a.xyz, shape_1.b.xyz));
    }
    vec3 _e20 = rotate(shape_1.a, (point_1 - shape_1.center));
    vec3 _e23 = boxNormal(_e20, shape_1.b.xyz);
    vec3 _e24 = rotateBack(shape_1.a, _e23);
    return _e24;
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
    float distance_ = length(toLight_1);
    float _e7 = sampleReach(count_2);
    float reach_1 = (light_1.radius * _e7);
    float sine = min((reach_1 / max(distance_, 1e-30)), 1.0);
    return ShadowCone(apex, (toLight_1 / vec3(max(distance_, 1e-30))), distance_, reach_1, sine, sqrt((1.0 - (sine * sine))));
}

bool isBox(uint i_11) {
    bool local_6 = false;
    uint _e4 = frame.shapeEnds.x;
    if ((i_11 >= _e4)) {
        uint _e11 = frame.shapeEnds.y;
        local_6 = (i_11 < _e11);
    } else {
        local_6 = false;
    }
    bool _e14 = local_6;
    return _e14;
}

bool mayOcclude(uint i_12, Shape shape_2, ShadowCone cone) {
    bool local_7 = false;
    bool local_8 = false;
    bool local_9 = false;
    bool local_10 = false;
    bool local_11 = false;
    vec3 near = vec3(0.0);
    vec3 far = vec3(0.0);
    bool local_12 = false;
    bool _e3 = isPlane(i_12);
    if (_e3) {
        float here = (dot(shape_2.center, cone.apex) - shape_2.radius);
        float there = (here + (dot(shape_2.center, cone.axis) * cone.length_));
        if (!(((here * there) <= 0.0))) {
            local_7 = (abs(there) <= cone.reach);
        } else {
            local_7 = true;
        }
        bool _e25 = local_7;
        return _e25;
    }
    vec3 toShape = (shape_2.center - cone.apex);
    float along_2 = dot(toShape, cone.axis);
    float perpendicular2_ = (dot(toShape, toShape) - (along_2 * along_2));
    float limit = (shape_2.radius + (along_2 * cone.sine));
    if (!((limit < 0.0))) {
        local_8 = (((perpendicular2_ * cone.cosine) * cone.cosine) > (limit * limit));
    } else {
        local_8 = true;
    }
    bool outside = local_8;
    if (!((along_2 < -(shape_2.radius)))) {
        local_9 = (along_2 > ((cone.length_ + cone.reach) + shape_2.radius));
    } else {
        local_9 = true;
    }
    bool behind = local_9;
    if (outside) {
        local_10 = (cone.sine < 1.0);
    } else {
        local_10 = false;
    }
    bool _e71 = local_10;
    if (!(_e71)) {
        local_11 = behind;
    } else {
        local_11 = true;
    }
    bool _e76 = local_11;
    if (_e76) {
        return false;
    }
    bool _e78 = isBox(i_12);
    if (!(_e78)) {
        return true;
    }
    near = -(toShape);
    vec3 _e83 = near;
    far = (_e83 + (cone.axis * cone.length_));
    if ((shape_2.a.w != 1.0)) {
        vec3 _e94 = near;
        vec3 _e95 = rotate(shape_2.a, _e94);
        near = _e95;
        vec3 _e97 = far;
        vec3 _e98 = rotate(shape_2.a, _e97);
        far = _e98;
    }
    vec3 _e99 = near;
    vec3 _e100 = far;
    vec3 low = min(_e99, (_e100 - vec3(cone.reach)));
    vec3 _e105 = near;
    vec3 _e106 = far;
    vec3 high = max(_e105, (_e106 + vec3(cone.reach)));
    if (all(lessThanEqual(low, shape_2.b.xyz))) {
        local_12 = all(greaterThanEqual(high, -(shape_2.b.xyz)));
    } else {
        local_12 = false;
    }
    bool _e123 = local_12;
    return _e123;
}

vec3 samplePoint(LightSampler s, uint k) {
    if ((s.count == 1u)) {
        return vec3(0.0);
    }
    float i_15 = float(k);
    if ((s.count == 9u)) {
        float row = floor(((i_15 + 0.5) / 3.0));
        return vec3(((0.5 * (i_15 - (3.0 * row))) - 0.5), 0.0, ((0.5 * row) - 0.5));
    }
    float z = (1.0 - ((2.0 * (i_15 + s.shift.x)) / float(s.count)));
    float phi = (6.2831855 * fract(((i_15 * 0.618034) + s.shift.y)));
    float r = sqrt(max((1.0 - (z * z)), 0.0));
    return vec3((r * cos(phi)), (r * sin(phi)), z);
}

Ray rayFrom(vec3 point_2, vec3 direction_6, uint shape_3, bool isFlat_1, vec3 outward) {
    bool local_13 = false;
    if (!(isFlat_1)) {
        local_13 = (dot(direction_6, outward) > 0.0);
    } else {
        local_13 = true;
    }
    bool leaving = local_13;
    return Ray(point_2, direction_6, (leaving ? shape_3 : noShape), (leaving ? noShape : shape_3), (1e-5 * length(point_2)));
}

uint hiddenSamples(vec3 point_3, uint source, vec3 outward_1, Light light_2, LightSampler samples, uint first, uint count_3) {
    uint hidden = 0u;
    uint i_13 = 0u;
    uint k_1 = 0u;
    ShadowCone _e8 = shadowCone(point_3, light_2, samples.count);
    uint allHidden = (4294967295u >> (32u - count_3));
    bool _e13 = isFlat(source);
    uint _e14 = shapeCount();
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e63 = i_13;
            i_13 = (_e63 + 1u);
        }
        loop_init_3 = false;
        uint _e19 = i_13;
        if ((_e19 < _e14)) {
        } else {
            break;
        }
        {
            uint _e21 = i_13;
            Shape _e22 = fetchShape(_e21);
            uint _e23 = i_13;
            bool _e24 = mayOcclude(_e23, _e22, _e8);
            if (!(_e24)) {
                continue;
            }
            k_1 = 0u;
            bool loop_init_4 = true;
            while(true) {
                if (!loop_init_4) {
                    uint _e58 = k_1;
                    k_1 = (_e58 + 1u);
                }
                loop_init_4 = false;
                uint _e28 = k_1;
                if ((_e28 < count_3)) {
                } else {
                    break;
                }
                {
                    uint _e30 = hidden;
                    uint _e31 = k_1;
                    if ((((_e30 >> _e31) & 1u) == 1u)) {
                        continue;
                    }
                    uint _e39 = k_1;
                    vec3 _e41 = samplePoint(samples, (first + _e39));
                    vec3 toSample_1 = ((light_2.center + (light_2.radius * _e41)) - point_3);
                    float distance_1 = length(toSample_1);
                    Ray _e48 = rayFrom(point_3, (toSample_1 / vec3(distance_1)), source, _e13, outward_1);
                    uint _e49 = i_13;
                    float _e50 = intersectShape(_e49, _e22, _e48);
                    if ((_e50 < distance_1)) {
                        uint _e52 = hidden;
                        uint _e54 = k_1;
                        hidden = (_e52 | (1u << _e54));
                    }
                }
            }
            uint _e60 = hidden;
            if ((_e60 == allHidden)) {
                break;
            }
        }
    }
    uint _e65 = hidden;
    return _e65;
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
    uint i_14 = 0u;
    vec3 sum_2 = vec3(0.0);
    uint first_1 = 0u;
    uint k_2 = 0u;
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            uint _e75 = i_14;
            i_14 = (_e75 + 1u);
        }
        loop_init_5 = false;
        uint _e10 = i_14;
        uint _e13 = frame.lightCount;
        if ((_e10 < _e13)) {
        } else {
            break;
        }
        {
            uint _e15 = i_14;
            Light _e16 = fetchLight(_e15);
            uint _e17 = i_14;
            LightSampler _e18 = lightSampler(sampleCount, pixelHash_1, _e17, reflection_1);
            sum_2 = vec3(0.0);
            first_1 = 0u;
            bool loop_init_6 = true;
            while(true) {
                if (!loop_init_6) {
                    uint _e61 = first_1;
                    first_1 = (_e61 + 32u);
                }
                loop_init_6 = false;
                uint _e24 = first_1;
                if ((_e24 < sampleCount)) {
                } else {
                    break;
                }
                {
                    uint _e26 = first_1;
                    uint count_4 = min((sampleCount - _e26), 32u);
                    uint _e33 = first_1;
                    uint _e34 = hiddenSamples(p_1.position, p_1.shape, p_1.outward, _e16, _e18, _e33, count_4);
                    k_2 = 0u;
                    bool loop_init_7 = true;
                    while(true) {
                        if (!loop_init_7) {
                            uint _e59 = k_2;
                            k_2 = (_e59 + 1u);
                        }
                        loop_init_7 = false;
                        uint _e37 = k_2;
                        if ((_e37 < count_4)) {
                        } else {
                            break;
                        }
                        {
                            uint _e39 = k_2;
                            if ((((_e34 >> _e39) & 1u) == 1u)) {
                                continue;
                            }
                            vec3 _e45 = sum_2;
                            uint _e48 = first_1;
                            uint _e49 = k_2;
                            vec3 _e51 = samplePoint(_e18, (_e48 + _e49));
                            vec3 _e56 = sampleLight(p_1, m_1, _e16, ((_e16.center + (_e16.radius * _e51)) - p_1.position));
                            sum_2 = (_e45 + _e56);
                        }
                    }
                }
            }
            vec3 _e64 = color;
            vec3 _e68 = sum_2;
            color = (_e64 + ((_e16.ambient * m_1.baseColor) + (_e68 / vec3(float(sampleCount)))));
        }
    }
    vec3 _e77 = color;
    return _e77;
}

vec3 trace(Ray first_2, uint hash, uint maxReflections, uint lightSamples) {
    Ray ray_4 = Ray(vec3(0.0), vec3(0.0), 0u, 0u, 0.0);
    float weight = 1.0;
    vec3 radiance = vec3(0.0);
    uint reflection_2 = 0u;
    ray_4 = first_2;
    bool loop_init_8 = true;
    while(true) {
        if (!loop_init_8) {
            uint _e93 = reflection_2;
            reflection_2 = (_e93 + 1u);
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
            Shape _e45 = fetchShape(_e15.shape);
            Material _e47 = fetchMaterial(_e15.shape);
            vec3 _e49 = ray_4.origin;
            vec3 _e52 = ray_4.direction;
            vec3 position = (_e49 + (_e15.t * _e52));
            vec3 _e56 = outwardNormal(_e15.shape, _e45, position);
            vec3 _e59 = ray_4.direction;
            vec3 normal_2 = ((dot(_e56, _e59) > 0.0) ? -(_e56) : _e56);
            vec3 _e65 = ray_4.direction;
            SurfacePoint point_4 = SurfacePoint(position, normal_2, _e56, -(_e65), _e15.shape);
            vec3 _e69 = radiance;
            float _e70 = weight;
            uint _e75 = reflection_2;
            vec3 _e76 = shade(point_4, _e47, hash, _e75, lightSamples);
            radiance = (_e69 + ((_e70 * (1.0 - _e47.reflectivity)) * _e76));
            float _e79 = weight;
            weight = (_e79 * _e47.reflectivity);
            float _e82 = weight;
            if ((_e82 < 0.00024414063)) {
                break;
            }
            vec3 _e86 = ray_4.direction;
            bool _e90 = isFlat(_e15.shape);
            Ray _e91 = rayFrom(position, reflect(_e86, normal_2), _e15.shape, _e90, _e56);
            ray_4 = _e91;
        }
    }
    vec3 _e95 = radiance;
    return _e95;
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

Ray cameraRay(vec3 direction_7) {
    return Ray(vec3(0.0), direction_7, noShape, noShape, 0.0);
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
    Ray _e38 = cameraRay(_e30);
    vec3 _e41 = trace(_e38, _e37, panel.x, panel.y);
    uint _e47 = frame.sampleIndex;
    if ((_e47 > 0u)) {
        vec4 _e52 = texelFetch(previousFilm, ivec2(pixel_1), 0);
        sum = _e52;
    }
    vec4 _e53 = sum;
    _fs2p_location0 = (_e53 + vec4(_e41, 1.0));
    return;
}

