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
    float spare0_;
    float spare1_;
    float spare2_;
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
const uint directionAndPdf = 0u;
const uint radianceAndDistance = 1u;
const uint pdfOfSample = 2u;
const uint pdfOfDirection = 3u;
const uint choice_1 = 4u;
const uint noShape = 4294967295u;

uniform highp sampler2D questions;

layout(std140) uniform FrameBlock { Frame frame; };

const bool hasManyLights = true;

const bool hasQuadLights = true;

const bool hasSuns = true;

const bool hasPointLights = true;

const bool hasSky = true;

uniform highp sampler2D sceneTable;

const bool hasSphereLights = true;

const bool hasBoxLights = true;

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
    uint _e17 = frame.emitterCount;
    if (pick(_e14, (_e17 > 1u), false)) {
        rest = u;
        while(true) {
            uint _e30 = i_1;
            Emitter _e31 = fetchEmitter(_e30);
            float _e32 = estimatedIrradiance(_e31, point_1, normal_2);
            float _e33 = total;
            total = (_e33 + _e32);
            float _e35 = total;
            float share_1 = (_e32 / max(_e35, 1e-37));
            float _e39 = rest;
            bool take = (_e39 < share_1);
            uint _e41 = chosen;
            uint _e42 = i_1;
            chosen = pick(take, _e42, _e41);
            float _e44 = chosenWeight;
            chosenWeight = pick(take, _e32, _e44);
            float _e46 = rest;
            float _e53 = rest;
            rest = pick(take, (_e53 / max(share_1, 1e-37)), ((_e46 - share_1) / max((1.0 - share_1), 1e-7)));
            uint _e59 = i_1;
            i_1 = (_e59 + 1u);
            uint _e61 = i_1;
            uint _e64 = frame.emitterCount;
            if ((_e61 >= _e64)) {
                break;
            }
        }
        uint _e66 = chosen;
        float _e67 = chosenWeight;
        float _e68 = total;
        float _e72 = total;
        choice = EmitterChoice(_e66, (_e67 / max(_e68, 1e-37)), _e72);
    }
    EmitterChoice _e74 = choice;
    return _e74;
}

float probabilityOf(Emitter e_2, vec3 point_2, vec3 normal_3, float total_1) {
    float probability = 0.0;
    uint _e6 = frame.emitterCount;
    probability = float(min(_e6, 1u));
    const bool _e12 = hasManyLights;
    uint _e15 = frame.emitterCount;
    if (pick(_e12, (_e15 > 1u), false)) {
        float _e19 = estimatedIrradiance(e_2, point_2, normal_3);
        probability = (_e19 / max(total_1, 1e-37));
    }
    float _e23 = probability;
    return _e23;
}

SphereView viewSphere(Emitter e_3, vec3 point_3) {
    vec3 toCenter = (e_3.position - point_3);
    float d_1 = length(toCenter);
    float power = abs(((d_1 - e_3.radius) * (d_1 + e_3.radius)));
    bool inside = (d_1 <= e_3.radius);
    float sine = min((e_3.radius / max(d_1, 1e-30)), 1.0);
    float cosine_1 = (sqrt(power) / max(d_1, 1e-30));
    return SphereView(toCenter, d_1, power, inside, pick(inside, 2.0, ((sine * sine) / (1.0 + cosine_1))));
}

vec3 turnTo(vec3 axis, vec3 v) {
    float s_2 = pick((axis.z >= 0.0), 1.0, -1.0);
    float a = (-1.0 / (s_2 + axis.z));
    float b_1 = ((axis.x * axis.y) * a);
    vec3 x_3 = vec3((1.0 + (((s_2 * axis.x) * axis.x) * a)), (s_2 * b_1), (-(s_2) * axis.x));
    vec3 y_1 = vec3(b_1, (s_2 + ((axis.y * axis.y) * a)), -(axis.y));
    return (((v.x * x_3) + (v.y * y_1)) + (v.z * axis));
}

ConeDirection sampleCone(vec3 axis_1, float width, vec2 u_1) {
    float oneMinusCosine = (u_1.x * width);
    float cosine_2 = (1.0 - oneMinusCosine);
    float sine2_ = (oneMinusCosine * (2.0 - oneMinusCosine));
    float sine_1 = sqrt(max(sine2_, 0.0));
    float phi = (6.2831855 * u_1.y);
    vec2 turn = vec2(cos(phi), sin(phi));
    vec3 _e23 = turnTo(axis_1, vec3(((sine_1 / length(turn)) * turn), cosine_2));
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
    float a_1 = abs(x);
    bool steep = (a_1 > 2.4142137);
    bool middle_1 = pick((a_1 > 0.41421357), !(steep), false);
    float r = pick(steep, (-1.0 / max(a_1, 1.0)), pick(middle_1, ((a_1 - 1.0) / (a_1 + 1.0)), a_1));
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
    vec2 y_2 = vec2(low.y, high.y);
    float _e44 = stretch(low.x, y_2, height_2);
    float _e46 = stretch(high.x, y_2, height_2);
    float solidAngle = (_e46 - _e44);
    bool rectangle = (abs(dot(axisX, axisY)) <= 1e-5);
    vec3 axisZ = (normal_7 * pick((signedHeight > 0.0), 1.0, -1.0));
    return QuadView(corner, axisX, axisY, axisZ, low, high, height_2, _e44, solidAngle, lit, pick(rectangle, (solidAngle > 0.01), false));
}

vec2 cosineAndSine(float x_2) {
    float h_1 = (0.5 * x_2);
    float z_1 = (h_1 * h_1);
    float sine_2 = (((((((-0.00019515296 * z_1) + 0.008332161) * z_1) - 0.16666655) * z_1) * h_1) + h_1);
    return vec2((1.0 - ((2.0 * sine_2) * sine_2)), ((2.0 * sine_2) * sqrt((1.0 - (sine_2 * sine_2)))));
}

vec3 sphericalRectangle(QuadView q, vec2 u_3) {
    float h_2 = q.height;
    vec2 y_3 = vec2(q.low.y, q.high.y);
    vec2 s_3 = (y_3 / sqrt(((y_3 * y_3) + vec2((h_2 * h_2)))));
    vec2 _e21 = cosineAndSine((0.5 * (q.start + (u_3.x * q.solidAngle))));
    vec2 across = (vec2((s_3.y - s_3.x), (s_3.y + s_3.x)) * _e21);
    float w = (((2.0 * _e21.x) * _e21.y) / max(length(across), 1e-15));
    float x_4 = clamp(((h_2 * w) * inversesqrt(max((1.0 - (w * w)), 1e-12))), q.low.x, q.high.x);
    float d2_ = ((x_4 * x_4) + (h_2 * h_2));
    vec2 ends = (y_3 * inversesqrt((vec2(d2_) + (y_3 * y_3))));
    float v_3 = mix(ends.x, ends.y, u_3.y);
    float atY = clamp(((v_3 * sqrt(d2_)) * inversesqrt(max((1.0 - (v_3 * v_3)), 1e-12))), y_3.x, y_3.y);
    return (((x_4 * q.axisX) + (atY * q.axisY)) + (h_2 * q.axisZ));
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
    float at = (u_5.x * b.area);
    bool onX = (at < b.faces.x);
    bool onY = pick(!(onX), (at < both), false);
    float face = pick(onX, b.faces.x, pick(onY, b.faces.y, b.faces.z));
    float within = clamp(((at - pick(onX, 0.0, pick(onY, b.faces.x, both))) / max(face, 1e-30)), 0.0, 1.0);
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
    vec3 direction_15 = pick(_e3.inside, outwards, (_e4.xyz / vec3(max(distance_8, 1e-30))));
    float _e31 = areaPdf(_e3.area, _e4.w, distance_8);
    float _e33 = conePdf(2.0);
    float pdf_3 = pick(_e3.inside, _e33, _e31);
    vec3 _e37 = rotateBack(_e3.rotation, direction_15);
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

vec3 sky(vec3 direction_1) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_1.y, 0.0));
}

float skyPdf(vec3 direction_2) {
    return 0.07957747;
}

LightSample sampleSky(vec2 u_8) {
    ConeDirection _e6 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_8);
    vec3 direction_16 = _e6.direction;
    vec3 _e8 = sky(direction_16);
    float _e9 = skyPdf(direction_16);
    return LightSample(direction_16, 1e30, _e8, _e9, false);
}

LightSample sampleEmitter(Emitter e_13, vec3 point_11, vec2 u_9) {
    LightSample s_1 = LightSample(vec3(0.0, 1.0, 0.0), 1e30, vec3(0.0), 0.0, true);
    const bool _e15 = hasSphereLights;
    if (pick(_e15, (e_13.kind == 0.0), false)) {
        LightSample _e20 = sampleSphere(e_13, point_11, u_9);
        s_1 = _e20;
    }
    const bool _e22 = hasQuadLights;
    if (pick(_e22, (e_13.kind == 1.0), false)) {
        LightSample _e27 = sampleQuad(e_13, point_11, u_9);
        s_1 = _e27;
    }
    const bool _e29 = hasBoxLights;
    if (pick(_e29, (e_13.kind == 2.0), false)) {
        LightSample _e34 = sampleBox(e_13, point_11, u_9);
        s_1 = _e34;
    }
    const bool _e36 = hasPointLights;
    if (pick(_e36, (e_13.kind == 3.0), false)) {
        LightSample _e41 = samplePoint(e_13, point_11);
        s_1 = _e41;
    }
    const bool _e43 = hasPointLights;
    if (pick(_e43, (e_13.kind == 4.0), false)) {
        LightSample _e48 = sampleSpot(e_13, point_11);
        s_1 = _e48;
    }
    const bool _e50 = hasSuns;
    if (pick(_e50, (e_13.kind == 5.0), false)) {
        LightSample _e55 = sampleDirectional(e_13, u_9);
        s_1 = _e55;
    }
    const bool _e57 = hasSky;
    if (pick(_e57, (e_13.kind == 6.0), false)) {
        LightSample _e62 = sampleSky(u_9);
        s_1 = _e62;
    }
    float _e65 = s_1.pdf;
    float _e67 = s_1.distance_;
    s_1.pdf = pick((_e67 <= (1e-5 * length(point_11))), 0.0, _e65);
    LightSample _e74 = s_1;
    return _e74;
}

Start onSurface(vec3 point_12, uint shape, bool seenFromInside) {
    return Start(point_12, pick(seenFromInside, noShape, shape), pick(seenFromInside, shape, noShape), (1e-5 * length(point_12)));
}

bool isSphere(uint i_3) {
    uint _e4 = frame.shapeEnds.x;
    return (i_3 < _e4);
}

float intersectSphere(vec3 origin_2, vec3 direction_3, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter_1 = (center - origin_2);
    float along_1 = dot(toCenter_1, direction_3);
    vec3 across_1 = (toCenter_1 - (along_1 * direction_3));
    float discriminant = ((radius * radius) - dot(across_1, across_1));
    float half_ = sqrt(max(discriminant, 0.0));
    float near = (along_1 - half_);
    float far = (along_1 + half_);
    float t_3 = pick((near > tMin), near, far);
    return pick(startsInside, max(far, 0.0), pick(pick((discriminant >= 0.0), (t_3 > tMin), false), t_3, 1e30));
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

float intersectBox(vec3 origin_3, vec3 direction_4, vec3 halfSize_1, float tMin_1, bool startsInside_1) {
    Slabs _e5 = boxSlabs(origin_3, direction_4, halfSize_1);
    float t_4 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_4 > tMin_1), false), t_4, 1e30));
}

float hitBox(uint i_6, Bounds bounds_1, Ray ray_1) {
    vec3 origin_4 = vec3(0.0);
    vec3 direction_5 = vec3(0.0);
    Extent _e3 = fetchExtent(i_6);
    origin_4 = (ray_1.start.point - bounds_1.center);
    direction_5 = ray_1.direction;
    bool _e12 = isTurned(_e3.a);
    if (_e12) {
        vec3 _e14 = origin_4;
        vec3 _e15 = rotate(_e3.a, _e14);
        origin_4 = _e15;
        vec3 _e17 = direction_5;
        vec3 _e18 = rotate(_e3.a, _e17);
        direction_5 = _e18;
    }
    vec3 _e19 = origin_4;
    vec3 _e20 = direction_5;
    float _e28 = intersectBox(_e19, _e20, _e3.b.xyz, ray_1.start.tMin, (i_6 == ray_1.start.inside));
    return pick((i_6 == ray_1.start.leaves), 1e30, _e28);
}

bool isQuad0_(uint i_7) {
    uint _e4 = frame.shapeEnds.z;
    return (i_7 < _e4);
}

float intersectQuad(vec3 origin_5, vec3 direction_6, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_8 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_6, normal_8);
    vec3 toCenter_2 = (center_1 - origin_5);
    float t_5 = (dot(toCenter_2, normal_8) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_1 = ((t_5 * direction_6) - toCenter_2);
    bool within_1 = (max(abs(dot(p_1, reciprocalU)), abs(dot(p_1, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_5 > tMin_2), (t_5 < 1e30), false), within_1, false), t_5, 1e30);
}

float hitQuad(uint i_8, Bounds bounds_2, Ray ray_2) {
    Extent _e3 = fetchExtent(i_8);
    float _e14 = intersectQuad(ray_2.start.point, ray_2.direction, bounds_2.center, _e3.a.xyz, _e3.b.xyz, ray_2.start.tMin);
    return pick((i_8 == ray_2.start.leaves), 1e30, _e14);
}

float intersectPlane(vec3 origin_6, vec3 direction_7, vec3 normal_4, float offset, float tMin_3) {
    float speed_1 = dot(direction_7, normal_4);
    float t_6 = ((offset - dot(origin_6, normal_4)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_6 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_6, 0.0), 1e30);
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
    return (i_12 >= _e4);
}

bool isFlat(uint i_13) {
    uint _e4 = frame.shapeEnds.y;
    return (i_13 >= _e4);
}

vec3 boxNormal(vec3 origin_7, vec3 direction_8, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_7, direction_8, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_7 = pick(entering, _e5.near, _e5.far);
    vec3 side_1 = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_8, vec3(0.0))));
    bool onX_1 = (crossed.x == t_7);
    bool onY_1 = pick(!(onX_1), (crossed.y == t_7), false);
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

float spherePdf(Emitter e_14, vec3 point_13, vec3 direction_9) {
    SphereView _e3 = viewSphere(e_14, point_13);
    bool reached = pick(_e3.inside, true, (dot(direction_9, _e3.toCenter) > 0.0));
    float _e11 = conePdf(_e3.width);
    return pick(reached, _e11, 0.0);
}

float quadPdf(Emitter e_15, vec3 point_14, float distance_2) {
    QuadView _e3 = viewQuad(e_15, point_14);
    float _e5 = pdfOfView(_e3, e_15.area, distance_2);
    return _e5;
}

float boxPdf(Emitter e_16, vec3 point_15, vec3 direction_10, float distance_3, vec3 normal_5) {
    BoxView _e5 = viewBox(e_16, point_15);
    float _e10 = areaPdf(_e5.area, (distance_3 * abs(dot(direction_10, normal_5))), distance_3);
    float _e12 = conePdf(2.0);
    return pick(_e5.inside, _e12, _e10);
}

bool isOnDisc(Emitter e_17, vec3 direction_11) {
    vec3 chord = (direction_11 + e_17.u);
    return ((3.1415927 * dot(chord, chord)) < e_17.area);
}

float directionalPdf(Emitter e_18, vec3 direction_12) {
    bool _e7 = isOnDisc(e_18, direction_12);
    return pick(_e7, (1.0 / max(e_18.area, 1e-31)), 0.0);
}

float emitterPdf(Emitter e_19, vec3 point_16, vec3 direction_13, float distance_4, vec3 normal_6) {
    float pdf = 0.0;
    const bool _e8 = hasSphereLights;
    if (pick(_e8, (e_19.kind == 0.0), false)) {
        float _e13 = spherePdf(e_19, point_16, direction_13);
        pdf = _e13;
    }
    const bool _e15 = hasQuadLights;
    if (pick(_e15, (e_19.kind == 1.0), false)) {
        float _e20 = quadPdf(e_19, point_16, distance_4);
        pdf = _e20;
    }
    const bool _e22 = hasBoxLights;
    if (pick(_e22, (e_19.kind == 2.0), false)) {
        float _e27 = boxPdf(e_19, point_16, direction_13, distance_4, normal_6);
        pdf = _e27;
    }
    const bool _e29 = hasSuns;
    if (pick(_e29, (e_19.kind == 5.0), false)) {
        float _e34 = directionalPdf(e_19, direction_13);
        pdf = _e34;
    }
    const bool _e36 = hasSky;
    if (pick(_e36, (e_19.kind == 6.0), false)) {
        float _e41 = skyPdf(direction_13);
        pdf = _e41;
    }
    float _e42 = pdf;
    return _e42;
}

vec3 radianceFromInfinity(Emitter e_20, vec3 direction_14) {
    vec3 radiance = vec3(0.0);
    const bool _e6 = hasSky;
    if (_e6) {
        vec3 _e7 = radiance;
        vec3 _e8 = sky(direction_14);
        radiance = pick((e_20.kind == 6.0), _e8, _e7);
    }
    const bool _e14 = hasSuns;
    if (_e14) {
        vec3 _e15 = radiance;
        bool _e20 = isOnDisc(e_20, direction_14);
        radiance = pick(pick((e_20.kind == 5.0), _e20, false), e_20.radiance, _e15);
    }
    vec3 _e23 = radiance;
    return _e23;
}

void main() {
    vec4 fragment = gl_FragCoord;
    float t = 1e30;
    vec3 normal = vec3(0.0);
    uvec2 pixel = uvec2(fragment.xy);
    vec4 a_2 = texelFetch(questions, ivec2(uvec2((3u * pixel.x), pixel.y)), 0);
    vec4 b_2 = texelFetch(questions, ivec2(uvec2(((3u * pixel.x) + 1u), pixel.y)), 0);
    vec4 c = texelFetch(questions, ivec2(uvec2(((3u * pixel.x) + 2u), pixel.y)), 0);
    uint question = uint(b_2.w);
    uint index = uint(a_2.w);
    if ((question == choice_1)) {
        EmitterChoice _e40 = chooseEmitter(a_2.xyz, c.xyz, b_2.x);
        Emitter _e42 = fetchEmitter(_e40.index);
        float _e46 = probabilityOf(_e42, a_2.xyz, c.xyz, _e40.total);
        Emitter _e50 = fetchEmitter(index);
        float _e54 = probabilityOf(_e50, a_2.xyz, c.xyz, _e40.total);
        _fs2p_location0 = vec4(float(_e40.index), _e40.probability, _e46, _e54);
        return;
    }
    Emitter _e56 = fetchEmitter(index);
    LightSample _e59 = sampleEmitter(_e56, a_2.xyz, b_2.xy);
    if ((question == directionAndPdf)) {
        _fs2p_location0 = vec4(_e59.direction, _e59.pdf);
        return;
    }
    if ((question == radianceAndDistance)) {
        _fs2p_location0 = vec4(_e59.radiance, _e59.distance_);
        return;
    }
    vec3 direction_17 = pick((question == pdfOfSample), _e59.direction, c.xyz);
    if ((_e56.shape >= 0.0)) {
        uint shape_1 = uint(_e56.shape);
        Start _e88 = onSurface(a_2.xyz, noShape, false);
        Ray ray_6 = Ray(_e88, direction_17);
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
    float _e106 = t;
    vec3 _e107 = normal;
    float _e108 = emitterPdf(_e56, a_2.xyz, direction_17, _e106, _e107);
    float _e109 = t;
    vec3 _e110 = radianceFromInfinity(_e56, direction_17);
    _fs2p_location0 = vec4(_e108, _e109, length(_e110), float(_e59.delta));
    return;
}

