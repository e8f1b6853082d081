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
struct Bounds {
    vec3 center;
    float radius;
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
const uint fromEye = 0u;
const uint leavingIt = 1u;
const uint insideIt = 2u;
const uint noShape = 4294967295u;

uniform highp sampler2D rays;

layout(std140) uniform FrameBlock { Frame frame; };

uniform highp sampler2D sceneTable;

layout(location = 0) out vec4 _fs2p_location0;

Start onSurface(vec3 point, uint shape, bool seenFromInside) {
    return Start(point, pick(seenFromInside, noShape, shape), pick(seenFromInside, shape, noShape), (1e-5 * length(point)));
}

Start startOf(uint rule, vec3 point_1, uint shape_1) {
    if ((rule == fromEye)) {
        return Start(point_1, noShape, noShape, 0.0);
    }
    if ((rule == leavingIt)) {
        Start _e12 = onSurface(point_1, shape_1, false);
        return _e12;
    }
    if ((rule == insideIt)) {
        Start _e16 = onSurface(point_1, shape_1, true);
        return _e16;
    }
    Start _e19 = onSurface(point_1, noShape, false);
    return _e19;
}

bool isSphere(uint i) {
    uint _e4 = frame.shapeEnds.x;
    return (i < _e4);
}

float intersectSphere(vec3 origin, vec3 direction, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter = (center - origin);
    float along = dot(toCenter, direction);
    vec3 across = (toCenter - (along * direction));
    float discriminant = ((radius * radius) - dot(across, across));
    float half_ = sqrt(max(discriminant, 0.0));
    float near = (along - half_);
    float far = (along + half_);
    float t_1 = pick((near > tMin), near, far);
    return pick(startsInside, max(far, 0.0), pick(pick((discriminant >= 0.0), (t_1 > tMin), false), t_1, 1e30));
}

float hitSphere(uint i_1, Bounds bounds, Ray ray) {
    float _e13 = intersectSphere(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin, (i_1 == ray.start.inside));
    return pick((i_1 == ray.start.leaves), 1e30, _e13);
}

bool isBox(uint i_2) {
    uint _e4 = frame.shapeEnds.x;
    uint _e9 = frame.shapeEnds.y;
    return pick((i_2 >= _e4), (i_2 < _e9), false);
}

vec4 tableTexel(uint column, uint row) {
    vec4 _e5 = texelFetch(sceneTable, ivec2(uvec2(column, row)), 0);
    return _e5;
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
    vec3 t_2 = (2.0 * cross(q_1.xyz, v));
    return ((v + (q_1.w * t_2)) + cross(q_1.xyz, t_2));
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
    float t_3 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_3 > tMin_1), false), t_3, 1e30));
}

float hitBox(uint i_4, Bounds bounds_1, Ray ray_1) {
    vec3 origin_4 = vec3(0.0);
    vec3 direction_3 = vec3(0.0);
    Extent _e3 = fetchExtent(i_4);
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
    float _e28 = intersectBox(_e19, _e20, _e3.b.xyz, ray_1.start.tMin, (i_4 == ray_1.start.inside));
    return pick((i_4 == ray_1.start.leaves), 1e30, _e28);
}

bool isQuad(uint i_5) {
    uint _e4 = frame.shapeEnds.z;
    return (i_5 < _e4);
}

float intersectQuad(vec3 origin_5, vec3 direction_4, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_1 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_4, normal_1);
    vec3 toCenter_1 = (center_1 - origin_5);
    float t_4 = (dot(toCenter_1, normal_1) / pick((speed == 0.0), 1e-30, speed));
    vec3 p = ((t_4 * direction_4) - toCenter_1);
    bool within = (max(abs(dot(p, reciprocalU)), abs(dot(p, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_4 > tMin_2), (t_4 < 1e30), false), within, false), t_4, 1e30);
}

float hitQuad(uint i_6, Bounds bounds_2, Ray ray_2) {
    Extent _e3 = fetchExtent(i_6);
    float _e14 = intersectQuad(ray_2.start.point, ray_2.direction, bounds_2.center, _e3.a.xyz, _e3.b.xyz, ray_2.start.tMin);
    return pick((i_6 == ray_2.start.leaves), 1e30, _e14);
}

float intersectPlane(vec3 origin_6, vec3 direction_5, vec3 normal, float offset, float tMin_3) {
    float speed_1 = dot(direction_5, normal);
    float t_5 = ((offset - dot(origin_6, normal)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_5 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_5, 0.0), 1e30);
}

float hitPlane(uint i_7, Bounds bounds_3, Ray ray_3) {
    float _e10 = intersectPlane(ray_3.start.point, ray_3.direction, bounds_3.center, bounds_3.radius, ray_3.start.tMin);
    return pick((i_7 == ray_3.start.leaves), 1e30, _e10);
}

float hitShape(uint i_8, Bounds bounds_4, Ray ray_4) {
    bool _e3 = isSphere(i_8);
    if (_e3) {
        float _e4 = hitSphere(i_8, bounds_4, ray_4);
        return _e4;
    }
    bool _e5 = isBox(i_8);
    if (_e5) {
        float _e6 = hitBox(i_8, bounds_4, ray_4);
        return _e6;
    }
    bool _e7 = isQuad(i_8);
    if (_e7) {
        float _e8 = hitQuad(i_8, bounds_4, ray_4);
        return _e8;
    }
    float _e9 = hitPlane(i_8, bounds_4, ray_4);
    return _e9;
}

Bounds fetchBounds(uint i_9) {
    vec4 _e2 = tableTexel(0u, i_9);
    return Bounds(_e2.xyz, _e2.w);
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

vec3 boxNormal(vec3 origin_7, vec3 direction_6, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_7, direction_6, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_6 = pick(entering, _e5.near, _e5.far);
    vec3 side = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_6, vec3(0.0))));
    bool onX = (crossed.x == t_6);
    bool onY = pick(!(onX), (crossed.y == t_6), false);
    return (side * mix(vec3(0.0), vec3(1.0), bvec3(onX, onY, !(pick(onX, true, onY)))));
}

vec3 rotateBack(vec4 q_2, vec3 v_1) {
    vec3 _e6 = rotate(vec4(-(q_2.xyz), q_2.w), v_1);
    return _e6;
}

vec3 outwardNormal(uint i_12, Ray ray_5, float t) {
    Bounds _e3 = fetchBounds(i_12);
    vec3 origin_8 = (ray_5.start.point - _e3.center);
    bool _e8 = isSphere(i_12);
    if (_e8) {
        return normalize((origin_8 + (t * ray_5.direction)));
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
    bool inside = (i_12 == ray_5.start.inside);
    vec3 _e27 = rotate(_e15.a, origin_8);
    vec3 _e30 = rotate(_e15.a, ray_5.direction);
    vec3 _e35 = boxNormal(_e27, _e30, _e15.b.xyz, ray_5.start.tMin, inside);
    vec3 _e37 = rotateBack(_e15.a, _e35);
    return _e37;
}

void main() {
    vec4 fragment = gl_FragCoord;
    uvec2 pixel = uvec2(fragment.xy);
    vec4 a = texelFetch(rays, ivec2(uvec2((2u * pixel.x), pixel.y)), 0);
    vec4 b = texelFetch(rays, ivec2(uvec2(((2u * pixel.x) + 1u), pixel.y)), 0);
    uint shape_2 = uint(a.w);
    Start _e26 = startOf(uint(b.w), a.xyz, shape_2);
    Ray ray_6 = Ray(_e26, b.xyz);
    Bounds _e29 = fetchBounds(shape_2);
    float _e30 = hitShape(shape_2, _e29, ray_6);
    if ((_e30 >= 1e30)) {
        _fs2p_location0 = vec4(1e30, 0.0, 0.0, 0.0);
        return;
    }
    vec3 _e38 = outwardNormal(shape_2, ray_6, _e30);
    _fs2p_location0 = vec4(_e30, _e38);
    return;
}

