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

struct EmitterChoice {
    uint index;
    float probability;
    float total;
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
};
struct LightSample {
    vec3 direction;
    float distance_;
    vec3 radiance;
    float pdf;
    bool delta;
};
struct SphereView {
    vec3 toCenter;
    float distance_;
    float power;
    bool inside;
    float width;
};
struct ConeDirection {
    vec3 direction;
    float cosine;
    float sine2_;
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
struct EnvironmentLight {
    vec3 radiance;
    float pdf;
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
struct Corners {
    vec4 a;
    vec4 b;
    vec4 c;
    vec4 d;
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
struct Bounds {
    vec3 center;
    float radius;
};
struct FarLight {
    vec3 radiance;
    float pdf;
};
const uint directionAndPdf = 0u;
const uint radianceAndDistance = 1u;
const uint pdfOfSample = 2u;
const uint choice_1 = 4u;
const EnvironmentLight white = EnvironmentLight(vec3(1.0), 0.07957747);
const uint noShape = 4294967295u;

uniform highp sampler2D questions;

layout(std140) uniform FrameBlock { Frame frame; };

const bool hasManyLights = true;

const bool hasQuadLights = false;

const bool hasSuns = false;

const bool hasPointLights = false;

const bool hasSky = true;

uniform highp sampler2D sceneTable;

const bool hasSphereLights = true;

const bool hasBoxLights = false;

const bool hasEnvironment = false;

uniform highp sampler2D environment;

layout(location = 0) out vec4 _fs2p_location0;

float spotFalloff(Emitter e, vec3 toLight) {
    float share = clamp(((-(dot(toLight, e.u)) - e.radius) / (e.cosInner - e.radius)), 0.0, 1.0);
    return (share * share);
}

float estimatedIrradiance(Emitter e_1, vec3 point, vec3 normal_1) {
    float estimate = 0.0;
    const bool _e4 = hasQuadLights;
    bool isQuad = pick(_e4, (e_1.kind == 1.0), false);
    const bool _e10 = hasSuns;
    bool isFar = pick(_e10, (e_1.kind == 5.0), false);
    vec3 middle = (e_1.position + pick(isQuad, (0.5 * (e_1.u + e_1.v)), vec3(0.0)));
    vec3 toLight_1 = pick(isFar, -(e_1.u), (middle - point));
    float distance2_ = dot(toLight_1, toLight_1);
    float distance_5 = sqrt(distance2_);
    float grown = max((distance_5 + e_1.reach), 1e-15);
    float above = clamp(((dot(normal_1, toLight_1) + e_1.reach) / grown), 0.0, 1.0);
    float cosine = pick((dot(normal_1, normal_1) == 0.0), 1.0, above);
    float square = pick(isQuad, (distance2_ + (e_1.area / 3.1415927)), max(distance2_, (e_1.area / 12.566371)));
    estimate = ((e_1.power * cosine) / pick(isFar, 1.0, max(square, 1e-15)));
    const bool _e65 = hasQuadLights;
    if (_e65) {
        float height_1 = (-(dot(cross(e_1.u, e_1.v), toLight_1)) / max(e_1.area, 1e-30));
        float side = pick((e_1.oneSided == 1.0), max(height_1, 0.0), abs(height_1));
        float lampCosine = pick((side > 0.0), ((side + e_1.reach) / grown), 0.0);
        float _e89 = estimate;
        estimate = (_e89 * pick(isQuad, lampCosine, 1.0));
    }
    const bool _e94 = hasPointLights;
    if (_e94) {
        float _e95 = estimate;
        float _e100 = spotFalloff(e_1, (toLight_1 / vec3(max(distance_5, 1e-15))));
        estimate = (_e95 * pick((e_1.kind == 4.0), _e100, 1.0));
    }
    const bool _e108 = hasSky;
    if (_e108) {
        float _e109 = estimate;
        estimate = pick((e_1.kind == 6.0), e_1.power, _e109);
    }
    float _e115 = estimate;
    return _e115;
}

Emitter fetchEmitter(uint i) {
    vec4 t0_ = texelFetch(sceneTable, ivec2(uvec2(14u, i)), 0);
    vec4 t1_ = texelFetch(sceneTable, ivec2(uvec2(15u, i)), 0);
    vec4 t2_ = texelFetch(sceneTable, ivec2(uvec2(16u, i)), 0);
    vec4 t3_ = texelFetch(sceneTable, ivec2(uvec2(17u, i)), 0);
    vec4 t4_ = texelFetch(sceneTable, ivec2(uvec2(18u, i)), 0);
    return Emitter(t0_.xyz, t0_.w, t1_.xyz, t1_.w, t2_.xyz, t2_.w, t3_.xyz, t3_.w, t4_.x, t4_.y, t4_.z, t4_.w);
}

EmitterChoice chooseEmitter(vec3 point_1, vec3 normal_2, float u) {
    EmitterChoice choice = EmitterChoice(0u, 0.0, 0.0);
    float total = 0.0;
    uint chosen = 0u;
    float chosenWeight = 0.0;
    float rest = 0.0;
    uint i_1 = 0u;
    uint _e6 = frame.emitterCount;
    choice = EmitterChoice(0u, float(min(_e6, 1u)), 1.0);
    const bool _e14 = hasManyLights;
    if (_e14) {
        uint _e17 = frame.emitterCount;
        if ((_e17 > 1u)) {
            rest = u;
            while(true) {
                uint _e29 = i_1;
                Emitter _e30 = fetchEmitter(_e29);
                float _e31 = estimatedIrradiance(_e30, point_1, normal_2);
                float _e32 = total;
                total = (_e32 + _e31);
                float _e34 = total;
                float share_1 = (_e31 / max(_e34, 1e-37));
                float _e38 = rest;
                bool take = (_e38 < share_1);
                uint _e40 = chosen;
                uint _e41 = i_1;
                chosen = pick(take, _e41, _e40);
                float _e43 = chosenWeight;
                chosenWeight = pick(take, _e31, _e43);
                float _e45 = rest;
                float _e52 = rest;
                rest = pick(take, (_e52 / max(share_1, 1e-37)), ((_e45 - share_1) / max((1.0 - share_1), 1e-7)));
                uint _e58 = i_1;
                i_1 = (_e58 + 1u);
                uint _e60 = i_1;
                uint _e63 = frame.emitterCount;
                if ((_e60 >= _e63)) {
                    break;
                }
            }
            uint _e65 = chosen;
            float _e66 = chosenWeight;
            float _e67 = total;
            float _e71 = total;
            choice = EmitterChoice(_e65, (_e66 / max(_e67, 1e-37)), _e71);
        }
    }
    EmitterChoice _e73 = choice;
    return _e73;
}

float probabilityOf(Emitter e_2, vec3 point_2, vec3 normal_3, float total_1) {
    float probability = 0.0;
    uint _e6 = frame.emitterCount;
    probability = float(min(_e6, 1u));
    const bool _e12 = hasManyLights;
    if (_e12) {
        uint _e15 = frame.emitterCount;
        if ((_e15 > 1u)) {
            float _e18 = estimatedIrradiance(e_2, point_2, normal_3);
            probability = (_e18 / max(total_1, 1e-37));
        }
    }
    float _e22 = probability;
    return _e22;
}

SphereView viewSphere(Emitter e_3, vec3 point_3) {
    vec3 toCenter = (e_3.position - point_3);
    float d_1 = length(toCenter);
    float power = abs(((d_1 - e_3.radius) * (d_1 + e_3.radius)));
    bool inside = (d_1 <= e_3.radius);
    float sine_1 = min((e_3.radius / max(d_1, 1e-30)), 1.0);
    float cosine_1 = (sqrt(power) / max(d_1, 1e-30));
    return SphereView(toCenter, d_1, power, inside, pick(inside, 2.0, ((sine_1 * sine_1) / (1.0 + cosine_1))));
}

vec3 turnTo(vec3 axis, vec3 v) {
    float s_3 = pick((axis.z >= 0.0), 1.0, -1.0);
    float a_1 = (-1.0 / (s_3 + axis.z));
    float b_2 = ((axis.x * axis.y) * a_1);
    vec3 x_5 = vec3((1.0 + (((s_3 * axis.x) * axis.x) * a_1)), (s_3 * b_2), (-(s_3) * axis.x));
    vec3 y_3 = vec3(b_2, (s_3 + ((axis.y * axis.y) * a_1)), -(axis.y));
    return (((v.x * x_5) + (v.y * y_3)) + (v.z * axis));
}

ConeDirection sampleCone(vec3 axis_1, float width, vec2 u_1) {
    float oneMinusCosine = (u_1.x * width);
    float cosine_2 = (1.0 - oneMinusCosine);
    float sine2_ = (oneMinusCosine * (2.0 - oneMinusCosine));
    float sine_2 = sqrt(max(sine2_, 0.0));
    float phi = (6.2831855 * u_1.y);
    vec2 turn = vec2(cos(phi), sin(phi));
    vec3 _e23 = turnTo(axis_1, vec3(((sine_2 / length(turn)) * turn), cosine_2));
    return ConeDirection(_e23, cosine_2, sine2_);
}

float conePdf(float width_1) {
    return (1.0 / (6.2831855 * max(width_1, 1e-31)));
}

LightSample sampleSphere(Emitter e_4, vec3 point_4, vec2 u_2) {
    SphereView _e3 = viewSphere(e_4, point_4);
    vec3 axis_2 = pick((_e3.distance_ < 1e-30), vec3(0.0, 0.0, 1.0), (_e3.toCenter / vec3(max(_e3.distance_, 1e-30))));
    ConeDirection _e19 = sampleCone(axis_2, _e3.width, u_2);
    float along = (_e3.distance_ * _e19.cosine);
    float halfChord = sqrt(max(((e_4.radius * e_4.radius) - ((_e3.distance_ * _e3.distance_) * _e19.sine2_)), 0.0));
    float larger = (abs(along) + halfChord);
    bool takeLarger = pick(_e3.inside, (along > 0.0), false);
    float distance_6 = pick(takeLarger, larger, (_e3.power / max(larger, 1e-30)));
    float _e49 = conePdf(_e3.width);
    return LightSample(_e19.direction, distance_6, e_4.radiance, _e49, false);
}

float arctangent(float x) {
    float a_2 = abs(x);
    bool steep = (a_2 > 2.4142137);
    bool middle_1 = pick((a_2 > 0.41421357), !(steep), false);
    float r = pick(steep, (-1.0 / max(a_2, 1.0)), pick(middle_1, ((a_2 - 1.0) / (a_2 + 1.0)), a_2));
    float base = pick(steep, 1.5707964, pick(middle_1, 0.7853982, 0.0));
    float z = (r * r);
    float series = ((((((0.080537446 * z) - 0.13877685) * z) + 0.19977711) * z) - 0.3333295);
    return (sign(x) * (base + (((series * z) * r) + r)));
}

float stretch(float x_1, vec2 y, float h) {
    vec2 r_1 = sqrt(((vec2((x_1 * x_1)) + (y * y)) + vec2((h * h))));
    float _e16 = arctangent(((x_1 * y.y) / (h * r_1.y)));
    float _e22 = arctangent(((x_1 * y.x) / (h * r_1.x)));
    return (_e16 - _e22);
}

QuadView viewQuad(Emitter e_5, vec3 point_5) {
    vec3 corner = (e_5.position - point_5);
    vec2 lengths = vec2(length(e_5.u), length(e_5.v));
    vec3 axisX = (e_5.u / vec3(lengths.x));
    vec3 axisY = (e_5.v / vec3(lengths.y));
    vec3 normal_7 = normalize(cross(axisX, axisY));
    float signedHeight = dot(corner, normal_7);
    float least = (1e-7 * (lengths.x + lengths.y));
    float height_2 = max(abs(signedHeight), least);
    bool lit = pick((abs(signedHeight) > least), pick((e_5.oneSided == 0.0), true, (signedHeight < 0.0)), false);
    vec2 low = vec2(dot(corner, axisX), dot(corner, axisY));
    vec2 high = (low + lengths);
    vec2 y_4 = vec2(low.y, high.y);
    float _e44 = stretch(low.x, y_4, height_2);
    float _e46 = stretch(high.x, y_4, height_2);
    float solidAngle = (_e46 - _e44);
    bool rectangle = (abs(dot(axisX, axisY)) <= 1e-5);
    vec3 axisZ = (normal_7 * pick((signedHeight > 0.0), 1.0, -1.0));
    return QuadView(corner, axisX, axisY, axisZ, low, high, height_2, _e44, solidAngle, lit, pick(rectangle, (solidAngle > 0.01), false));
}

vec2 cosineAndSine(float x_2) {
    float h_1 = (0.5 * x_2);
    float z_1 = (h_1 * h_1);
    float sine_3 = (((((((-0.00019515296 * z_1) + 0.008332161) * z_1) - 0.16666655) * z_1) * h_1) + h_1);
    return vec2((1.0 - ((2.0 * sine_3) * sine_3)), ((2.0 * sine_3) * sqrt((1.0 - (sine_3 * sine_3)))));
}

vec3 sphericalRectangle(QuadView q, vec2 u_3) {
    float h_2 = q.height;
    vec2 y_5 = vec2(q.low.y, q.high.y);
    vec2 s_4 = (y_5 / sqrt(((y_5 * y_5) + vec2((h_2 * h_2)))));
    vec2 _e21 = cosineAndSine((0.5 * (q.start + (u_3.x * q.solidAngle))));
    vec2 across = (vec2((s_4.y - s_4.x), (s_4.y + s_4.x)) * _e21);
    float w = (((2.0 * _e21.x) * _e21.y) / max(length(across), 1e-15));
    float x_6 = clamp(((h_2 * w) * inversesqrt(max((1.0 - (w * w)), 1e-12))), q.low.x, q.high.x);
    float d2_ = ((x_6 * x_6) + (h_2 * h_2));
    vec2 ends = (y_5 * inversesqrt((vec2(d2_) + (y_5 * y_5))));
    float v_3 = mix(ends.x, ends.y, u_3.y);
    float atY = clamp(((v_3 * sqrt(d2_)) * inversesqrt(max((1.0 - (v_3 * v_3)), 1e-12))), y_5.x, y_5.y);
    return (((x_6 * q.axisX) + (atY * q.axisY)) + (h_2 * q.axisZ));
}

float areaPdf(float area, float height, float distance_) {
    float pdf_1 = (((distance_ / max(height, 1e-30)) * distance_) / max((area / distance_), 1e-30));
    return min(pdf_1, 1e30);
}

float pdfOfView(QuadView q_1, float area_1, float distance_1) {
    float _e4 = areaPdf(area_1, q_1.height, distance_1);
    float pdf_2 = pick(q_1.bySolidAngle, (1.0 / max(q_1.solidAngle, 0.01)), _e4);
    return pick(q_1.lit, pdf_2, 0.0);
}

LightSample sampleQuad(Emitter e_6, vec3 point_6, vec2 u_4) {
    QuadView _e3 = viewQuad(e_6, point_6);
    vec3 onArea = ((_e3.corner + (u_4.x * e_6.u)) + (u_4.y * e_6.v));
    vec3 _e13 = sphericalRectangle(_e3, u_4);
    vec3 toLight_2 = pick(_e3.bySolidAngle, _e13, onArea);
    float distance_7 = max(length(toLight_2), _e3.height);
    float _e23 = pdfOfView(_e3, e_6.area, distance_7);
    return LightSample((toLight_2 / vec3(distance_7)), distance_7, e_6.radiance, _e23, false);
}

Extent fetchExtent(uint i_2) {
    vec4 t0_1 = texelFetch(sceneTable, ivec2(uvec2(1u, i_2)), 0);
    vec4 t1_1 = texelFetch(sceneTable, ivec2(uvec2(2u, i_2)), 0);
    return Extent(t0_1.xyzw, t1_1.xyzw);
}

vec3 rotate(vec4 q_2, vec3 v_1) {
    vec3 t_2 = (2.0 * cross(q_2.xyz, v_1));
    return ((v_1 + (q_2.w * t_2)) + cross(q_2.xyz, t_2));
}

BoxView viewBox(Emitter e_7, vec3 point_7) {
    Extent _e4 = fetchExtent(uint(e_7.shape));
    vec4 rotation = _e4.a;
    vec3 _e8 = rotate(rotation, (point_7 - e_7.position));
    bvec3 seen = greaterThan(abs(_e8), e_7.u);
    vec3 faces = mix(vec3(0.0), ((4.0 * e_7.u.yzx) * e_7.u.zxy), seen);
    return BoxView(rotation, _e8, faces, ((faces.x + faces.y) + faces.z), !(any(seen)));
}

vec4 pointOnFaces(Emitter e_8, BoxView b, vec2 u_5) {
    float both = (b.faces.x + b.faces.y);
    float at_1 = (u_5.x * b.area);
    bool onX = (at_1 < b.faces.x);
    bool onY = pick(!(onX), (at_1 < both), false);
    float face = pick(onX, b.faces.x, pick(onY, b.faces.y, b.faces.z));
    float within = clamp(((at_1 - pick(onX, 0.0, pick(onY, b.faces.x, both))) / max(face, 1e-30)), 0.0, 1.0);
    vec3 axis_3 = vec3(pick(onX, 1.0, 0.0), pick(onY, 1.0, 0.0), pick(pick(onX, true, onY), 0.0, 1.0));
    vec3 p = vec3(pick((dot(axis_3, b.point) >= 0.0), 1.0, -1.0), ((2.0 * within) - 1.0), ((2.0 * u_5.y) - 1.0));
    vec3 toLight_3 = ((pick(onX, p.xyz, pick(onY, p.zxy, p.yzx)) * e_8.u) - b.point);
    return vec4(toLight_3, abs(dot(axis_3, toLight_3)));
}

vec3 safeReciprocal(vec3 d, vec3 origin) {
    vec3 tiny = mix(vec3(1e-18), vec3(-1e-18), greaterThan(origin, vec3(0.0)));
    return (vec3(1.0) / mix(d, tiny, lessThan(abs(d), vec3(1e-18))));
}

Slabs boxSlabs(vec3 origin_1, vec3 direction, vec3 halfSize) {
    vec3 _e3 = safeReciprocal(direction, origin_1);
    vec3 middle_2 = (-(origin_1) * _e3);
    vec3 reach = (halfSize * abs(_e3));
    vec3 enter = (middle_2 - reach);
    vec3 leave = (middle_2 + reach);
    return Slabs(enter, leave, max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}

vec3 rotateBack(vec4 q_3, vec3 v_2) {
    vec3 _e6 = rotate(vec4(-(q_3.xyz), q_3.w), v_2);
    return _e6;
}

LightSample sampleBox(Emitter e_9, vec3 point_8, vec2 u_6) {
    BoxView _e3 = viewBox(e_9, point_8);
    vec4 _e4 = pointOnFaces(e_9, _e3, u_6);
    ConeDirection _e10 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_6);
    vec3 outwards = _e10.direction;
    Slabs _e16 = boxSlabs(_e3.point, outwards, e_9.u);
    float distance_8 = pick(_e3.inside, max(_e16.far, 0.0), length(_e4.xyz));
    vec3 direction_16 = pick(_e3.inside, outwards, (_e4.xyz / vec3(max(distance_8, 1e-30))));
    float _e31 = areaPdf(_e3.area, _e4.w, distance_8);
    float _e33 = conePdf(2.0);
    float pdf_3 = pick(_e3.inside, _e33, _e31);
    vec3 _e37 = rotateBack(_e3.rotation, direction_16);
    return LightSample(_e37, distance_8, e_9.radiance, pdf_3, false);
}

LightSample samplePoint(Emitter e_10, vec3 point_9) {
    vec3 toLight_4 = (e_10.position - point_9);
    float distance_9 = length(toLight_4);
    float safe = max(distance_9, 1e-15);
    return LightSample((toLight_4 / vec3(safe)), distance_9, (e_10.radiance / vec3((safe * safe))), pick((distance_9 > 1e-15), 1.0, 0.0), true);
}

LightSample sampleSpot(Emitter e_11, vec3 point_10) {
    LightSample s = LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, false);
    LightSample _e2 = samplePoint(e_11, point_10);
    s = _e2;
    vec3 _e5 = s.direction;
    float _e6 = spotFalloff(e_11, _e5);
    vec3 _e8 = s.radiance;
    s.radiance = (_e8 * _e6);
    float _e12 = s.pdf;
    s.pdf = pick((_e6 > 0.0), _e12, 0.0);
    LightSample _e17 = s;
    return _e17;
}

LightSample sampleDirectional(Emitter e_12, vec2 u_7) {
    bool delta = (e_12.area == 0.0);
    ConeDirection _e10 = sampleCone(-(e_12.u), (e_12.area / 6.2831855), u_7);
    return LightSample(_e10.direction, 1e30, e_12.radiance, pick(delta, 1.0, (1.0 / max(e_12.area, 1e-31))), delta);
}

Parts splitProduct(vec2 u_8, uvec2 n) {
    uvec2 digits = uvec2((u_8 * 16777216.0));
    uvec2 low_1 = ((digits & uvec2(4095u)) * n);
    uvec2 high_1 = (((digits >> uvec2(12u)) * n) + (low_1 >> uvec2(12u)));
    return Parts((high_1 >> uvec2(12u)), vec2((((high_1 & uvec2(4095u)) << uvec2(12u)) | (low_1 & uvec2(4095u)))));
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

ChosenCell chooseCell(vec2 u_9) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size = uvec2(_e3);
    Parts _e9 = splitProduct(u_9, (size + uvec2(0u, 1u)));
    uint _e17 = mixBits((floatBitsToUint(u_9.x) ^ (floatBitsToUint(u_9.y) * 2654435761u)));
    uint hash = (_e17 >> 8u);
    float _e26 = frame.environmentSize.x;
    float fine = ((float(hash) * 5.9604645e-8) * _e26);
    float x_7 = min(((_e9.rest.x + fine) * 5.9604645e-8), 0.99999994);
    uint rows = ((size.y + 2u) / 2u);
    bool second = (_e9.whole.y >= rows);
    vec4 entries = texelFetch(environment, ivec2(uvec2(_e9.whole.x, ((_e9.whole.y + size.y) - pick(second, rows, 0u)))), 0);
    vec2 entry = pick(second, entries.zw, entries.xy);
    bool own = (x_7 < entry.x);
    uint other = uint(entry.y);
    uint otherRow = (other / size.x);
    uvec2 cell_1 = pick(own, _e9.whole, uvec2((other - (otherRow * size.x)), otherRow));
    float rest_1 = pick(own, (x_7 / max(entry.x, 1e-37)), ((x_7 - entry.x) / max((1.0 - entry.x), 1e-7)));
    return ChosenCell(cell_1, vec2(min(rest_1, 1.0), (_e9.rest.y * 5.9604645e-8)));
}

Corners environmentCorners(uvec2 cell) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_1 = uvec2(_e3);
    uint left = (pick((cell.x == 0u), size_1.x, cell.x) - 1u);
    uint right = pick((cell.x == size_1.x), 0u, cell.x);
    uint upper = (max(cell.y, 1u) - 1u);
    uint lower = min(cell.y, (size_1.y - 1u));
    vec4 above_1 = vec4(1.0, 1.0, 1.0, pick((cell.y == 0u), -1.0, 1.0));
    vec4 below = vec4(1.0, 1.0, 1.0, pick((cell.y == size_1.y), -1.0, 1.0));
    vec4 _e52 = texelFetch(environment, ivec2(uvec2(left, upper)), 0);
    vec4 _e57 = texelFetch(environment, ivec2(uvec2(right, upper)), 0);
    vec4 _e62 = texelFetch(environment, ivec2(uvec2(left, lower)), 0);
    vec4 _e67 = texelFetch(environment, ivec2(uvec2(right, lower)), 0);
    return Corners((above_1 * _e52), (above_1 * _e57), (below * _e62), (below * _e67));
}

float linearSample(float u_10, float a, float b_1) {
    vec2 ends_1 = (vec2(a, b_1) / vec2(max((a + b_1), 1e-37)));
    return min((u_10 / max((ends_1.x + sqrt(mix((ends_1.x * ends_1.x), (ends_1.y * ends_1.y), u_10))), 1e-9)), 1.0);
}

EnvironmentLight lightWithin(Corners k, vec2 at, float sine) {
    vec4 light_1 = mix(mix(k.a, k.b, at.x), mix(k.c, k.d, at.x), at.y);
    return EnvironmentLight(light_1.xyz, (max(light_1.w, 0.0) / sine));
}

EnvironmentSample sampleEnvironment(vec2 u_11) {
    vec2 size_2 = frame.environmentSize;
    ChosenCell _e4 = chooseCell(u_11);
    Corners _e6 = environmentCorners(_e4.cell);
    vec2 cell_2 = vec2(_e4.cell);
    bvec2 atPole = bvec2((cell_2.y == 0.0), (cell_2.y == size_2.y));
    float _e32 = linearSample(_e4.rest.y, max((_e6.a.w + _e6.b.w), 0.0), max((_e6.c.w + _e6.d.w), 0.0));
    float t_3 = ((_e32 * pick(any(atPole), 0.5, 1.0)) + pick(atPole.x, 0.5, 0.0));
    float _e55 = linearSample(_e4.rest.x, mix(_e6.a.w, _e6.c.w, t_3), mix(_e6.b.w, _e6.d.w, t_3));
    bool isLower = ((2.0 * cell_2.y) > size_2.y);
    float fromPole = pick(isLower, ((size_2.y - cell_2.y) + (0.5 - t_3)), (cell_2.y + (t_3 - 0.5)));
    vec2 _e76 = cosineAndSine((fromPole * (3.1415927 / size_2.y)));
    float _e85 = frame.environmentTurn;
    float halfTurns = (2.0 * (((cell_2.x + (_e55 - 0.5)) / size_2.x) - _e85));
    float nearest = floor((halfTurns + 0.5));
    bool back = (fract((0.5 * nearest)) > 0.0);
    vec2 _e100 = cosineAndSine(((halfTurns - nearest) * 3.1415927));
    vec2 phi_1 = (_e100 * pick(back, -1.0, 1.0));
    float sine_4 = max(_e76.y, 1e-9);
    vec3 direction_17 = vec3((sine_4 * phi_1.y), pick(isLower, -(_e76.x), _e76.x), (-(sine_4) * phi_1.x));
    EnvironmentLight _e119 = lightWithin(_e6, vec2(_e55, t_3), sine_4);
    return EnvironmentSample(direction_17, _e119);
}

vec3 sky(vec3 direction_1) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_1.y, 0.0));
}

LightSample sampleSky(vec2 u_12) {
    EnvironmentSample s_1 = EnvironmentSample(vec3(0.0), EnvironmentLight(vec3(0.0), 0.0));
    ConeDirection _e6 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_12);
    s_1 = EnvironmentSample(_e6.direction, white);
    const bool _e12 = hasEnvironment;
    if (_e12) {
        EnvironmentSample _e13 = sampleEnvironment(u_12);
        s_1 = _e13;
    }
    vec3 _e15 = s_1.direction;
    vec3 _e18 = s_1.light.radiance;
    vec3 _e20 = s_1.direction;
    vec3 _e21 = sky(_e20);
    float _e25 = s_1.light.pdf;
    return LightSample(_e15, 1e30, (_e18 * _e21), _e25, false);
}

LightSample sampleEmitter(Emitter e_13, vec3 point_11, vec2 u_13) {
    LightSample s_2 = LightSample(vec3(0.0, 1.0, 0.0), 1e30, vec3(0.0), 0.0, true);
    const bool _e15 = hasSphereLights;
    if (_e15) {
        if ((e_13.kind == 0.0)) {
            LightSample _e19 = sampleSphere(e_13, point_11, u_13);
            s_2 = _e19;
        }
    }
    const bool _e21 = hasQuadLights;
    if (_e21) {
        if ((e_13.kind == 1.0)) {
            LightSample _e25 = sampleQuad(e_13, point_11, u_13);
            s_2 = _e25;
        }
    }
    const bool _e27 = hasBoxLights;
    if (_e27) {
        if ((e_13.kind == 2.0)) {
            LightSample _e31 = sampleBox(e_13, point_11, u_13);
            s_2 = _e31;
        }
    }
    const bool _e33 = hasPointLights;
    if (_e33) {
        if ((e_13.kind == 3.0)) {
            LightSample _e37 = samplePoint(e_13, point_11);
            s_2 = _e37;
        }
    }
    const bool _e39 = hasPointLights;
    if (_e39) {
        if ((e_13.kind == 4.0)) {
            LightSample _e43 = sampleSpot(e_13, point_11);
            s_2 = _e43;
        }
    }
    const bool _e45 = hasSuns;
    if (_e45) {
        if ((e_13.kind == 5.0)) {
            LightSample _e49 = sampleDirectional(e_13, u_13);
            s_2 = _e49;
        }
    }
    const bool _e51 = hasSky;
    if (_e51) {
        if ((e_13.kind == 6.0)) {
            LightSample _e55 = sampleSky(u_13);
            s_2 = _e55;
        }
    }
    float _e58 = s_2.pdf;
    float _e60 = s_2.distance_;
    s_2.pdf = pick((_e60 <= (1e-5 * length(point_11))), 0.0, _e58);
    LightSample _e67 = s_2;
    return _e67;
}

Start onSurface(vec3 point_12, uint shape, bool seenFromInside) {
    return Start(point_12, pick(seenFromInside, noShape, shape), pick(seenFromInside, shape, noShape), (1e-5 * length(point_12)));
}

bool isSphere(uint i_3) {
    uint _e4 = frame.shapeEnds.x;
    return (i_3 < _e4);
}

float intersectSphere(vec3 origin_2, vec3 direction_2, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter_1 = (center - origin_2);
    float along_1 = dot(toCenter_1, direction_2);
    vec3 across_1 = (toCenter_1 - (along_1 * direction_2));
    float discriminant = ((radius * radius) - dot(across_1, across_1));
    float half_ = sqrt(max(discriminant, 0.0));
    float near = (along_1 - half_);
    float far_1 = (along_1 + half_);
    float t_4 = pick((near > tMin), near, far_1);
    return pick(startsInside, max(far_1, 0.0), pick(pick((discriminant >= 0.0), (t_4 > tMin), false), t_4, 1e30));
}

float hitSphere(uint i_4, Bounds bounds, Ray ray) {
    float _e13 = intersectSphere(ray.start.point, ray.direction, bounds.center, bounds.radius, ray.start.tMin, (i_4 == ray.start.inside));
    return pick((i_4 == ray.start.leaves), 1e30, _e13);
}

bool isBox(uint i_5) {
    uint _e4 = frame.shapeEnds.x;
    uint _e9 = frame.shapeEnds.y;
    return pick((i_5 >= _e4), (i_5 < _e9), false);
}

bool isTurned(vec4 q_4) {
    return any(notEqual(q_4.xyz, vec3(0.0)));
}

float intersectBox(vec3 origin_3, vec3 direction_3, vec3 halfSize_1, float tMin_1, bool startsInside_1) {
    Slabs _e5 = boxSlabs(origin_3, direction_3, halfSize_1);
    float t_5 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_5 > tMin_1), false), t_5, 1e30));
}

float hitBox(uint i_6, Bounds bounds_1, Ray ray_1) {
    vec3 origin_4 = vec3(0.0);
    vec3 direction_4 = vec3(0.0);
    Extent _e3 = fetchExtent(i_6);
    origin_4 = (ray_1.start.point - bounds_1.center);
    direction_4 = ray_1.direction;
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
    float _e28 = intersectBox(_e19, _e20, _e3.b.xyz, ray_1.start.tMin, (i_6 == ray_1.start.inside));
    return pick((i_6 == ray_1.start.leaves), 1e30, _e28);
}

bool isQuad0_(uint i_7) {
    uint _e4 = frame.shapeEnds.z;
    return (i_7 < _e4);
}

float intersectQuad(vec3 origin_5, vec3 direction_5, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_8 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_5, normal_8);
    vec3 toCenter_2 = (center_1 - origin_5);
    float t_6 = (dot(toCenter_2, normal_8) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_1 = ((t_6 * direction_5) - toCenter_2);
    bool within_1 = (max(abs(dot(p_1, reciprocalU)), abs(dot(p_1, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_6 > tMin_2), (t_6 < 1e30), false), within_1, false), t_6, 1e30);
}

float hitQuad(uint i_8, Bounds bounds_2, Ray ray_2) {
    Extent _e3 = fetchExtent(i_8);
    float _e14 = intersectQuad(ray_2.start.point, ray_2.direction, bounds_2.center, _e3.a.xyz, _e3.b.xyz, ray_2.start.tMin);
    return pick((i_8 == ray_2.start.leaves), 1e30, _e14);
}

float intersectPlane(vec3 origin_6, vec3 direction_6, vec3 normal_4, float offset, float tMin_3) {
    float speed_1 = dot(direction_6, normal_4);
    float t_7 = ((offset - dot(origin_6, normal_4)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_7 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_7, 0.0), 1e30);
}

float hitPlane(uint i_9, Bounds bounds_3, Ray ray_3) {
    float _e10 = intersectPlane(ray_3.start.point, ray_3.direction, bounds_3.center, bounds_3.radius, ray_3.start.tMin);
    return pick((i_9 == ray_3.start.leaves), 1e30, _e10);
}

float hitShape(uint i_10, Bounds bounds_4, Ray ray_4) {
    bool _e3 = isSphere(i_10);
    if (_e3) {
        float _e4 = hitSphere(i_10, bounds_4, ray_4);
        return _e4;
    }
    bool _e5 = isBox(i_10);
    if (_e5) {
        float _e6 = hitBox(i_10, bounds_4, ray_4);
        return _e6;
    }
    bool _e7 = isQuad0_(i_10);
    if (_e7) {
        float _e8 = hitQuad(i_10, bounds_4, ray_4);
        return _e8;
    }
    float _e9 = hitPlane(i_10, bounds_4, ray_4);
    return _e9;
}

Bounds fetchBounds(uint i_11) {
    vec4 t0_2 = texelFetch(sceneTable, ivec2(uvec2(0u, i_11)), 0);
    return Bounds(t0_2.xyz, t0_2.w);
}

bool isPlane(uint i_12) {
    uint _e4 = frame.shapeEnds.z;
    uint _e9 = frame.shapeEnds.w;
    return pick((i_12 >= _e4), (i_12 < _e9), false);
}

bool isFlat(uint i_13) {
    uint _e4 = frame.shapeEnds.y;
    return (i_13 >= _e4);
}

vec3 boxNormal(vec3 origin_7, vec3 direction_7, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_7, direction_7, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_8 = pick(entering, _e5.near, _e5.far);
    vec3 side_1 = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_7, vec3(0.0))));
    bool onX_1 = (crossed.x == t_8);
    bool onY_1 = pick(!(onX_1), (crossed.y == t_8), false);
    return (side_1 * mix(vec3(0.0), vec3(1.0), bvec3(onX_1, onY_1, !(pick(onX_1, true, onY_1)))));
}

vec3 outwardNormal(uint i_14, Ray ray_5, float t_1) {
    Bounds _e3 = fetchBounds(i_14);
    vec3 origin_8 = (ray_5.start.point - _e3.center);
    bool _e8 = isSphere(i_14);
    if (_e8) {
        return normalize((origin_8 + (t_1 * ray_5.direction)));
    }
    bool _e13 = isPlane(i_14);
    if (_e13) {
        return _e3.center;
    }
    Extent _e15 = fetchExtent(i_14);
    bool _e16 = isFlat(i_14);
    if (_e16) {
        return normalize(cross(_e15.a.xyz, _e15.b.xyz));
    }
    bool inside_1 = (i_14 == ray_5.start.inside);
    vec3 _e27 = rotate(_e15.a, origin_8);
    vec3 _e30 = rotate(_e15.a, ray_5.direction);
    vec3 _e35 = boxNormal(_e27, _e30, _e15.b.xyz, ray_5.start.tMin, inside_1);
    vec3 _e37 = rotateBack(_e15.a, _e35);
    return _e37;
}

bool isOnDisc(Emitter e_14, vec3 direction_8) {
    vec3 chord = (direction_8 + e_14.u);
    return ((3.1415927 * dot(chord, chord)) < e_14.area);
}

float directionalPdf(Emitter e_15, vec3 direction_9) {
    bool _e7 = isOnDisc(e_15, direction_9);
    return pick(_e7, (1.0 / max(e_15.area, 1e-31)), 0.0);
}

vec2 quadrantAngles(vec2 x_4, vec2 y_2) {
    vec2 low_2 = min(x_4, y_2);
    vec2 high_2 = max(x_4, y_2);
    bvec2 middle_3 = greaterThan(low_2, (0.41421357 * high_2));
    vec2 r_2 = (mix(low_2, (low_2 - high_2), middle_3) / max(mix(high_2, (low_2 + high_2), middle_3), vec2(1e-30)));
    vec2 z_2 = (r_2 * r_2);
    vec2 series_1 = ((((((0.080537446 * z_2) - vec2(0.13877685)) * z_2) + vec2(0.19977711)) * z_2) - vec2(0.3333295));
    vec2 angle = (mix(vec2(0.0), vec2(0.7853982), middle_3) + (((series_1 * z_2) * r_2) + r_2));
    return mix(angle, (vec2(1.5707964) - angle), greaterThan(y_2, x_4));
}

EnvironmentLight lookUpEnvironment(vec3 direction_10) {
    vec2 size_3 = frame.environmentSize;
    float sine_5 = max(length(direction_10.xz), 1e-9);
    vec2 _e15 = quadrantAngles(abs(vec2(direction_10.z, direction_10.y)), vec2(abs(direction_10.x), sine_5));
    float turn_1 = (pick((direction_10.z > 0.0), (3.1415927 - _e15.x), _e15.x) * pick((direction_10.x < 0.0), -1.0, 1.0));
    float _e35 = frame.environmentTurn;
    float column = ((fract(((turn_1 * 0.15915494) + _e35)) * size_3.x) + 0.5);
    float fromPole_1 = ((_e15.y * (size_3.y / 3.1415927)) + 0.5);
    float row = floor(fromPole_1);
    bool isLower_1 = (direction_10.y < 0.0);
    vec2 cell_3 = vec2(floor(column), pick(isLower_1, (size_3.y - row), row));
    float within_2 = (fromPole_1 - row);
    vec2 at_2 = vec2((column - cell_3.x), pick(isLower_1, (1.0 - within_2), within_2));
    Corners _e66 = environmentCorners(uvec2(cell_3));
    EnvironmentLight _e67 = lightWithin(_e66, at_2, sine_5);
    return _e67;
}

EnvironmentLight skyLight(vec3 direction_11) {
    EnvironmentLight light = white;
    const bool _e4 = hasEnvironment;
    if (_e4) {
        EnvironmentLight _e5 = lookUpEnvironment(direction_11);
        light = _e5;
    }
    vec3 _e7 = light.radiance;
    vec3 _e8 = sky(direction_11);
    float _e11 = light.pdf;
    return EnvironmentLight((_e7 * _e8), _e11);
}

FarLight farLight(Emitter e_16, vec3 direction_12) {
    FarLight far = FarLight(vec3(0.0), 0.0);
    const bool _e8 = hasSuns;
    if (_e8) {
        bool _e12 = isOnDisc(e_16, direction_12);
        bool seen_1 = pick((e_16.kind == 5.0), _e12, false);
        float _e18 = directionalPdf(e_16, direction_12);
        far = FarLight(pick(seen_1, e_16.radiance, vec3(0.0)), pick(seen_1, _e18, 0.0));
    }
    const bool _e23 = hasSky;
    if (_e23) {
        if ((e_16.kind == 6.0)) {
            EnvironmentLight _e27 = skyLight(direction_12);
            far = FarLight(_e27.radiance, _e27.pdf);
        }
    }
    FarLight _e31 = far;
    return _e31;
}

float spherePdf(Emitter e_17, vec3 point_13, vec3 direction_13) {
    SphereView _e3 = viewSphere(e_17, point_13);
    bool reached = pick(_e3.inside, true, (dot(direction_13, _e3.toCenter) > 0.0));
    float _e11 = conePdf(_e3.width);
    return pick(reached, _e11, 0.0);
}

float quadPdf(Emitter e_18, vec3 point_14, float distance_2) {
    QuadView _e3 = viewQuad(e_18, point_14);
    float _e5 = pdfOfView(_e3, e_18.area, distance_2);
    return _e5;
}

float boxPdf(Emitter e_19, vec3 point_15, vec3 direction_14, float distance_3, vec3 normal_5) {
    BoxView _e5 = viewBox(e_19, point_15);
    float _e10 = areaPdf(_e5.area, (distance_3 * abs(dot(direction_14, normal_5))), distance_3);
    float _e12 = conePdf(2.0);
    return pick(_e5.inside, _e12, _e10);
}

float shapePdf(Emitter e_20, vec3 point_16, vec3 direction_15, float distance_4, vec3 normal_6) {
    float pdf = 0.0;
    const bool _e8 = hasSphereLights;
    if (_e8) {
        if ((e_20.kind == 0.0)) {
            float _e12 = spherePdf(e_20, point_16, direction_15);
            pdf = _e12;
        }
    }
    const bool _e14 = hasQuadLights;
    if (_e14) {
        if ((e_20.kind == 1.0)) {
            float _e18 = quadPdf(e_20, point_16, distance_4);
            pdf = _e18;
        }
    }
    const bool _e20 = hasBoxLights;
    if (_e20) {
        if ((e_20.kind == 2.0)) {
            float _e24 = boxPdf(e_20, point_16, direction_15, distance_4, normal_6);
            pdf = _e24;
        }
    }
    float _e25 = pdf;
    return _e25;
}

void main() {
    vec4 fragment = gl_FragCoord;
    float t = 1e30;
    vec3 normal = vec3(0.0);
    uvec2 pixel = uvec2(fragment.xy);
    vec4 a_3 = texelFetch(questions, ivec2(uvec2((3u * pixel.x), pixel.y)), 0);
    vec4 b_3 = texelFetch(questions, ivec2(uvec2(((3u * pixel.x) + 1u), pixel.y)), 0);
    vec4 c = texelFetch(questions, ivec2(uvec2(((3u * pixel.x) + 2u), pixel.y)), 0);
    uint question = uint(b_3.w);
    uint index = uint(a_3.w);
    if ((question == choice_1)) {
        EmitterChoice _e40 = chooseEmitter(a_3.xyz, c.xyz, b_3.x);
        Emitter _e42 = fetchEmitter(_e40.index);
        float _e46 = probabilityOf(_e42, a_3.xyz, c.xyz, _e40.total);
        Emitter _e50 = fetchEmitter(index);
        float _e54 = probabilityOf(_e50, a_3.xyz, c.xyz, _e40.total);
        _fs2p_location0 = vec4(float(_e40.index), _e40.probability, _e46, _e54);
        return;
    }
    Emitter _e56 = fetchEmitter(index);
    LightSample _e59 = sampleEmitter(_e56, a_3.xyz, b_3.xy);
    if ((question == directionAndPdf)) {
        _fs2p_location0 = vec4(_e59.direction, _e59.pdf);
        return;
    }
    if ((question == radianceAndDistance)) {
        _fs2p_location0 = vec4(_e59.radiance, _e59.distance_);
        return;
    }
    vec3 direction_18 = pick((question == pdfOfSample), _e59.direction, c.xyz);
    if ((_e56.shape >= 0.0)) {
        uint shape_1 = uint(_e56.shape);
        Start _e88 = onSurface(a_3.xyz, noShape, false);
        Ray ray_6 = Ray(_e88, direction_18);
        Bounds _e90 = fetchBounds(shape_1);
        float _e91 = hitShape(shape_1, _e90, ray_6);
        t = _e91;
        float _e92 = t;
        vec3 _e95 = outwardNormal(shape_1, ray_6, min(_e92, 1e30));
        normal = _e95;
        float _e96 = t;
        if ((_e96 >= 1e30)) {
            _fs2p_location0 = vec4(0.0, 1e30, _e59.pdf, float(_e59.delta));
            return;
        }
    }
    FarLight _e105 = farLight(_e56, direction_18);
    float _e107 = t;
    vec3 _e108 = normal;
    float _e109 = shapePdf(_e56, a_3.xyz, direction_18, _e107, _e108);
    float _e112 = t;
    _fs2p_location0 = vec4((_e109 + _e105.pdf), _e112, length(_e105.radiance), float(_e59.delta));
    return;
}

