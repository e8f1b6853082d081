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

struct CameraRay {
    vec3 origin;
    vec3 direction;
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
struct Material {
    vec3 baseColor;
    float reflectivity;
    float specular;
    float exponent;
    float id;
    float spare;
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
const uint noShape = 4294967295u;

layout(std140) uniform FrameBlock { Frame frame; };

const bool hasOtherProjections = false;

uniform highp sampler2D sceneTable;

layout(location = 0) out vec4 _fs2p_location0;

CameraRay rayThroughLens(vec2 filmPosition, vec2 lensPoint) {
    CameraRay ray_1 = CameraRay(vec3(0.0), vec3(0.0));
    float _e7 = frame.width;
    float x = (((2.0 * filmPosition.x) / _e7) - 1.0);
    float _e16 = frame.height;
    float y = (1.0 - ((2.0 * filmPosition.y) / _e16));
    vec3 _e22 = frame.right;
    vec3 _e26 = frame.up;
    vec3 across = ((x * _e22) + (y * _e26));
    const bool _e30 = hasOtherProjections;
    uint _e33 = frame.projection;
    bool orthographic = pick(_e30, (_e33 == 1u), false);
    vec3 _e39 = frame.forward;
    vec3 _e43 = frame.forward;
    vec3 ahead = pick(orthographic, _e43, (_e39 + across));
    float _e47 = frame.aperture;
    vec3 _e51 = frame.right;
    vec3 _e57 = frame.up;
    vec3 lens = (_e47 * ((lensPoint.x * normalize(_e51)) + (lensPoint.y * normalize(_e57))));
    float _e66 = frame.focusDistance;
    ray_1 = CameraRay(pick(orthographic, (across + lens), lens), normalize((ahead - (lens / vec3(_e66)))));
    const bool _e74 = hasOtherProjections;
    if (_e74) {
        uint _e77 = frame.projection;
        if ((_e77 == 2u)) {
            float longitude = (3.1415927 * x);
            float latitude = (1.5707964 * y);
            vec3 _e87 = frame.right;
            vec3 _e92 = frame.forward;
            vec3 level = ((sin(longitude) * _e87) + (cos(longitude) * _e92));
            vec3 _e102 = frame.up;
            ray_1 = CameraRay(vec3(0.0), normalize(((cos(latitude) * level) + (sin(latitude) * _e102))));
        }
    }
    CameraRay _e107 = ray_1;
    return _e107;
}

CameraRay centralRay(vec2 filmPosition_1) {
    CameraRay _e3 = rayThroughLens(filmPosition_1, vec2(0.0));
    return _e3;
}

Start onCamera(vec3 point) {
    return Start(point, noShape, noShape, 0.0);
}

vec3 sky(vec3 direction) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction.y, 0.0));
}

Hit nearer(Hit hit, float t, uint shape) {
    return Hit(min(t, hit.t), pick((t < hit.t), shape, hit.shape));
}

float intersectSphere(vec3 origin, vec3 direction_1, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter = (center - origin);
    float along = dot(toCenter, direction_1);
    vec3 across_1 = (toCenter - (along * direction_1));
    float discriminant = ((radius * radius) - dot(across_1, across_1));
    float half_ = sqrt(max(discriminant, 0.0));
    float near = (along - half_);
    float far = (along + half_);
    float t_2 = pick((near > tMin), near, far);
    return pick(startsInside, max(far, 0.0), pick(pick((discriminant >= 0.0), (t_2 > tMin), false), t_2, 1e30));
}

float hitSphere(uint i_1, Bounds bounds, Ray ray_2) {
    float _e13 = intersectSphere(ray_2.start.point, ray_2.direction, bounds.center, bounds.radius, ray_2.start.tMin, (i_1 == ray_2.start.inside));
    return pick((i_1 == ray_2.start.leaves), 1e30, _e13);
}

vec4 tableTexel(uint column, uint row) {
    vec4 _e5 = texelFetch(sceneTable, ivec2(uvec2(column, row)), 0);
    return _e5;
}

Bounds fetchBounds(uint i_2) {
    vec4 _e2 = tableTexel(0u, i_2);
    return Bounds(_e2.xyz, _e2.w);
}

Extent fetchExtent(uint i_3) {
    vec4 _e2 = tableTexel(1u, i_3);
    vec4 _e4 = tableTexel(2u, i_3);
    return Extent(_e2.xyzw, _e4.xyzw);
}

bool isTurned(vec4 q) {
    return any(notEqual(q.xyz, vec3(0.0)));
}

vec3 rotate(vec4 q_1, vec3 v) {
    vec3 t_3 = (2.0 * cross(q_1.xyz, v));
    return ((v + (q_1.w * t_3)) + cross(q_1.xyz, t_3));
}

vec3 safeReciprocal(vec3 d, vec3 origin_1) {
    vec3 tiny = mix(vec3(1e-18), vec3(-1e-18), greaterThan(origin_1, vec3(0.0)));
    return (vec3(1.0) / mix(d, tiny, lessThan(abs(d), vec3(1e-18))));
}

Slabs boxSlabs(vec3 origin_2, vec3 direction_2, vec3 halfSize) {
    vec3 _e3 = safeReciprocal(direction_2, origin_2);
    vec3 middle = (-(origin_2) * _e3);
    vec3 reach = (halfSize * abs(_e3));
    vec3 enter = (middle - reach);
    vec3 leave = (middle + reach);
    return Slabs(enter, leave, max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}

float intersectBox(vec3 origin_3, vec3 direction_3, vec3 halfSize_1, float tMin_1, bool startsInside_1) {
    Slabs _e5 = boxSlabs(origin_3, direction_3, halfSize_1);
    float t_4 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_4 > tMin_1), false), t_4, 1e30));
}

float hitBox(uint i_4, Bounds bounds_1, Ray ray_3) {
    vec3 origin_4 = vec3(0.0);
    vec3 direction_4 = vec3(0.0);
    Extent _e3 = fetchExtent(i_4);
    origin_4 = (ray_3.start.point - bounds_1.center);
    direction_4 = ray_3.direction;
    bool _e12 = isTurned(_e3.a);
    if (_e12) {
        vec3 _e14 = origin_4;
        vec3 _e15 = rotate(_e3.a, _e14);
        origin_4 = _e15;
        vec3 _e17 = direction_4;
        vec3 _e18 = rotate(_e3.a, _e17);
        direction_4 = _e18;
    }
    vec3 _e19 = origin_4;
    vec3 _e20 = direction_4;
    float _e28 = intersectBox(_e19, _e20, _e3.b.xyz, ray_3.start.tMin, (i_4 == ray_3.start.inside));
    return pick((i_4 == ray_3.start.leaves), 1e30, _e28);
}

float intersectQuad(vec3 origin_5, vec3 direction_5, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_2 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_5, normal_2);
    vec3 toCenter_1 = (center_1 - origin_5);
    float t_5 = (dot(toCenter_1, normal_2) / pick((speed == 0.0), 1e-30, speed));
    vec3 p = ((t_5 * direction_5) - toCenter_1);
    bool within = (max(abs(dot(p, reciprocalU)), abs(dot(p, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_5 > tMin_2), (t_5 < 1e30), false), within, false), t_5, 1e30);
}

float hitQuad(uint i_5, Bounds bounds_2, Ray ray_4) {
    Extent _e3 = fetchExtent(i_5);
    float _e14 = intersectQuad(ray_4.start.point, ray_4.direction, bounds_2.center, _e3.a.xyz, _e3.b.xyz, ray_4.start.tMin);
    return pick((i_5 == ray_4.start.leaves), 1e30, _e14);
}

float intersectPlane(vec3 origin_6, vec3 direction_6, vec3 normal_1, float offset, float tMin_3) {
    float speed_1 = dot(direction_6, normal_1);
    float t_6 = ((offset - dot(origin_6, normal_1)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_6 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_6, 0.0), 1e30);
}

float hitPlane(uint i_6, Bounds bounds_3, Ray ray_5) {
    float _e10 = intersectPlane(ray_5.start.point, ray_5.direction, bounds_3.center, bounds_3.radius, ray_5.start.tMin);
    return pick((i_6 == ray_5.start.leaves), 1e30, _e10);
}

Hit closestHit(Ray ray_6, uint ballCount) {
    Hit hit_1 = Hit(1e30, 4294967295u);
    uint k = 0u;
    uint i_7 = 0u;
    uvec4 ends = frame.shapeEnds;
    uint roundCount = (ends.x + ballCount);
    if ((roundCount > 0u)) {
        while(true) {
            uint _e15 = k;
            uint _e16 = k;
            uint _e21 = k;
            uint i_14 = pick((_e21 >= ends.x), ((_e16 - ends.x) + ends.w), _e15);
            Hit _e25 = hit_1;
            Bounds _e26 = fetchBounds(i_14);
            float _e27 = hitSphere(i_14, _e26, ray_6);
            Hit _e28 = nearer(_e25, _e27, i_14);
            hit_1 = _e28;
            uint _e30 = k;
            k = (_e30 + 1u);
            uint _e32 = k;
            if ((_e32 >= roundCount)) {
                break;
            }
        }
    }
    i_7 = ends.x;
    uint _e36 = i_7;
    if ((_e36 < ends.y)) {
        while(true) {
            Hit _e39 = hit_1;
            uint _e40 = i_7;
            uint _e41 = i_7;
            Bounds _e42 = fetchBounds(_e41);
            float _e43 = hitBox(_e40, _e42, ray_6);
            uint _e44 = i_7;
            Hit _e45 = nearer(_e39, _e43, _e44);
            hit_1 = _e45;
            uint _e47 = i_7;
            i_7 = (_e47 + 1u);
            uint _e49 = i_7;
            if ((_e49 >= ends.y)) {
                break;
            }
        }
    }
    uint _e52 = i_7;
    if ((_e52 < ends.w)) {
        while(true) {
            uint _e55 = i_7;
            Bounds _e56 = fetchBounds(_e55);
            Hit _e57 = hit_1;
            uint _e58 = i_7;
            float _e59 = hitQuad(_e58, _e56, ray_6);
            uint _e60 = i_7;
            float _e61 = hitPlane(_e60, _e56, ray_6);
            uint _e62 = i_7;
            uint _e66 = i_7;
            Hit _e67 = nearer(_e57, pick((_e62 >= ends.z), _e61, _e59), _e66);
            hit_1 = _e67;
            uint _e69 = i_7;
            i_7 = (_e69 + 1u);
            uint _e71 = i_7;
            if ((_e71 >= ends.w)) {
                break;
            }
        }
    }
    Hit _e74 = hit_1;
    return _e74;
}

bool isSphere(uint i_8) {
    uint _e4 = frame.shapeEnds.x;
    return (i_8 < _e4);
}

bool isPlane(uint i_9) {
    uint _e4 = frame.shapeEnds.z;
    uint _e9 = frame.shapeEnds.w;
    return pick((i_9 >= _e4), (i_9 < _e9), false);
}

bool isFlat(uint i_10) {
    uint _e4 = frame.shapeEnds.y;
    return (i_10 >= _e4);
}

vec3 boxNormal(vec3 origin_7, vec3 direction_7, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_7, direction_7, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_7 = pick(entering, _e5.near, _e5.far);
    vec3 side = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_7, vec3(0.0))));
    bool onX = (crossed.x == t_7);
    bool onY = pick(!(onX), (crossed.y == t_7), false);
    return (side * mix(vec3(0.0), vec3(1.0), bvec3(onX, onY, !(pick(onX, true, onY)))));
}

vec3 rotateBack(vec4 q_2, vec3 v_1) {
    vec3 _e6 = rotate(vec4(-(q_2.xyz), q_2.w), v_1);
    return _e6;
}

vec3 outwardNormal(uint i_11, Ray ray_7, float t_1) {
    Bounds _e3 = fetchBounds(i_11);
    vec3 origin_8 = (ray_7.start.point - _e3.center);
    bool _e8 = isSphere(i_11);
    if (_e8) {
        return normalize((origin_8 + (t_1 * ray_7.direction)));
    }
    bool _e13 = isPlane(i_11);
    if (_e13) {
        return _e3.center;
    }
    Extent _e15 = fetchExtent(i_11);
    bool _e16 = isFlat(i_11);
    if (_e16) {
        return normalize(cross(_e15.a.xyz, _e15.b.xyz));
    }
    bool inside = (i_11 == ray_7.start.inside);
    vec3 _e27 = rotate(_e15.a, origin_8);
    vec3 _e30 = rotate(_e15.a, ray_7.direction);
    vec3 _e35 = boxNormal(_e27, _e30, _e15.b.xyz, ray_7.start.tMin, inside);
    vec3 _e37 = rotateBack(_e15.a, _e35);
    return _e37;
}

Start onSurface(vec3 point_1, uint shape_1, bool seenFromInside) {
    return Start(point_1, pick(seenFromInside, noShape, shape_1), pick(seenFromInside, shape_1, noShape), (1e-5 * length(point_1)));
}

Material fetchMaterial(uint i_12) {
    vec4 _e2 = tableTexel(3u, i_12);
    vec4 _e4 = tableTexel(4u, i_12);
    return Material(_e2.xyz, _e2.w, _e4.x, _e4.y, _e4.z, _e4.w);
}

Light fetchLight(uint i_13) {
    vec4 _e2 = tableTexel(5u, i_13);
    vec4 _e4 = tableTexel(6u, i_13);
    vec4 _e6 = tableTexel(7u, i_13);
    vec4 _e8 = tableTexel(8u, i_13);
    return Light(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w);
}

void main() {
    vec4 fragment = gl_FragCoord;
    Ray ray = Ray(Start(vec3(0.0), 0u, 0u, 0.0), vec3(0.0));
    vec3 radiance = vec3(0.0);
    vec3 normal = vec3(0.0);
    vec3 color = vec3(0.0);
    vec3 contribution = vec3(0.0);
    float distance_ = 0.0;
    uint i = 0u;
    bool local = false;
    uvec2 _e3 = frame.origin;
    CameraRay _e7 = centralRay((vec2(_e3) + fragment.xy));
    Start _e9 = onCamera(_e7.origin);
    ray = Ray(_e9, _e7.direction);
    vec3 _e14 = ray.direction;
    vec3 _e15 = sky(_e14);
    radiance = _e15;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e123 = i;
            i = (_e123 + 1u);
        }
        loop_init = false;
        uint _e30 = i;
        uint _e33 = frame.lightCount;
        if ((_e30 <= _e33)) {
        } else {
            break;
        }
        {
            Ray _e35 = ray;
            Hit _e37 = closestHit(_e35, 0u);
            uint _e38 = i;
            if ((_e38 == 0u)) {
                if ((_e37.shape == noShape)) {
                    break;
                }
                vec3 _e46 = ray.start.point;
                vec3 _e49 = ray.direction;
                vec3 position = (_e46 + (_e37.t * _e49));
                Ray _e53 = ray;
                vec3 _e55 = outwardNormal(_e37.shape, _e53, _e37.t);
                vec3 _e57 = ray.direction;
                bool back = (dot(_e55, _e57) > 0.0);
                normal = pick(back, -(_e55), _e55);
                if (back) {
                    bool _e68 = isFlat(_e37.shape);
                    local = !(_e68);
                } else {
                    local = false;
                }
                bool _e71 = local;
                Start _e72 = onSurface(position, _e37.shape, _e71);
                ray.start = _e72;
                Material _e74 = fetchMaterial(_e37.shape);
                color = _e74.baseColor;
                radiance = vec3(0.0);
            } else {
                float _e79 = distance_;
                if ((_e37.t >= _e79)) {
                    vec3 _e81 = radiance;
                    vec3 _e82 = contribution;
                    radiance = (_e81 + _e82);
                }
            }
            uint _e84 = i;
            uint _e87 = frame.lightCount;
            if ((_e84 < _e87)) {
                uint _e89 = i;
                Light _e90 = fetchLight(_e89);
                vec3 _e91 = radiance;
                vec3 _e93 = color;
                radiance = (_e91 + (_e90.ambient * _e93));
                vec3 _e99 = ray.start.point;
                vec3 toLight = (_e90.center - _e99);
                distance_ = length(toLight);
                float _e103 = distance_;
                ray.direction = (toLight / vec3(_e103));
                vec3 _e106 = color;
                vec3 _e109 = normal;
                vec3 _e111 = ray.direction;
                float _e117 = distance_;
                float _e118 = distance_;
                contribution = ((_e106 * _e90.diffuse) * ((max(dot(_e109, _e111), 0.0) * _e90.power) / (_e117 * _e118)));
            }
        }
    }
    vec3 _e125 = radiance;
    _fs2p_location0 = vec4(_e125, 1.0);
    return;
}

