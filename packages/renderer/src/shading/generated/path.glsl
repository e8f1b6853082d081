#version 300 es

precision highp float;
precision highp int;

struct Basis {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
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
    float emitter;
};
struct Vertex {
    vec3 point;
    uint shape;
    vec3 outward;
    Basis basis;
    vec3 wo;
    Surface surface;
};
struct Origin {
    vec3 point;
    vec3 normal;
    float pdf;
    float total;
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
struct EnvironmentLight {
    vec3 radiance;
    float pdf;
};
struct Corners {
    vec4 a;
    vec4 b;
    vec4 c;
    vec4 d;
};
struct SphereView {
    vec3 toCenter;
    float distance_;
    float power;
    bool inside;
    float width;
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
struct EmitterChoice {
    uint index;
    float probability;
    float total;
};
struct LightSample {
    vec3 direction;
    float distance_;
    vec3 radiance;
    float pdf;
    bool delta;
};
struct ConeDirection {
    vec3 direction;
    float cosine;
    float sine2_;
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
struct FacetLobe {
    vec3 value;
    float pdf;
    float cosine;
};
struct Sampler {
    uint key;
    uint salt;
    uint sample_;
    uint place;
};
struct Group {
    uint index;
    uint shift;
    uint seedA;
    uint seedB;
};
struct BsdfSample {
    vec3 direction;
    float pdf;
    vec3 weight;
    bool delta;
};
struct Film {
    vec4 sums;
    vec4 squares;
};
struct CameraRay {
    vec3 origin;
    vec3 direction;
};
const uint rouletteDepth = 4u;
const uint dielectric = 3u;
const uint noShape = 4294967295u;
const uint diffuse = 0u;
const uint metallicRoughness = 1u;
const uint conductor = 2u;

uniform highp sampler2D sceneTable;

layout(std140) uniform FrameBlock { Frame frame; };

uniform highp sampler2D environment;

uniform highp sampler2D previousFilm;

uniform highp sampler2D previousSquares;

layout(location = 0) out vec4 _fs2p_location0;
layout(location = 1) out vec4 _fs2p_location1;

uint kindOf(Surface s_1) {
    return (uint(s_1.code) & 3u);
}

bool isDielectric(Surface s_2) {
    uint _e1 = kindOf(s_2);
    return (_e1 == dielectric);
}

Surface fetchSurface(uint i) {
    vec4 t0_ = texelFetch(sceneTable, ivec2(uvec2(9u, i)), 0);
    vec4 t1_ = texelFetch(sceneTable, ivec2(uvec2(10u, i)), 0);
    vec4 t2_ = texelFetch(sceneTable, ivec2(uvec2(11u, i)), 0);
    vec4 t3_ = texelFetch(sceneTable, ivec2(uvec2(12u, i)), 0);
    vec4 t4_ = texelFetch(sceneTable, ivec2(uvec2(13u, i)), 0);
    return Surface(t0_.xyz, t0_.w, t1_.xyz, t1_.w, t2_.xyz, t2_.w, t3_.xyz, t3_.w, t4_.xyz, t4_.w);
}

Bounds fetchBounds(uint i_1) {
    vec4 t0_1 = texelFetch(sceneTable, ivec2(uvec2(0u, i_1)), 0);
    return Bounds(t0_1.xyz, t0_1.w);
}

bool isSphere(uint i_2) {
    uint _e4 = frame.shapeEnds.x;
    return (i_2 < _e4);
}

bool isPlane(uint i_3) {
    uint _e4 = frame.shapeEnds.z;
    return (i_3 >= _e4);
}

Extent fetchExtent(uint i_4) {
    vec4 t0_2 = texelFetch(sceneTable, ivec2(uvec2(1u, i_4)), 0);
    vec4 t1_1 = texelFetch(sceneTable, ivec2(uvec2(2u, i_4)), 0);
    return Extent(t0_2.xyzw, t1_1.xyzw);
}

bool isFlat(uint i_5) {
    uint _e4 = frame.shapeEnds.y;
    return (i_5 >= _e4);
}

vec3 safeReciprocal(vec3 d, vec3 origin) {
    vec3 tiny = mix(vec3(1e-18), vec3(-1e-18), greaterThan(origin, vec3(0.0)));
    return (vec3(1.0) / mix(d, tiny, lessThan(abs(d), vec3(1e-18))));
}

Slabs boxSlabs(vec3 origin_1, vec3 direction, vec3 halfSize) {
    vec3 _e3 = safeReciprocal(direction, origin_1);
    vec3 middle = (-(origin_1) * _e3);
    vec3 reach = (halfSize * abs(_e3));
    vec3 enter = (middle - reach);
    vec3 leave = (middle + reach);
    return Slabs(enter, leave, max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}

vec3 boxNormal(vec3 origin_2, vec3 direction_1, vec3 halfSize_1, float tMin, bool startsInside) {
    Slabs _e5 = boxSlabs(origin_2, direction_1, halfSize_1);
    bool entering = ((_e5.near > tMin) && !(startsInside));
    vec3 crossed = (entering ? _e5.enter : _e5.leave);
    float t_2 = (entering ? _e5.near : _e5.far);
    vec3 side = ((entering ? -1.0 : 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_1, vec3(0.0))));
    if ((crossed.x == t_2)) {
        return vec3(side.x, 0.0, 0.0);
    }
    if ((crossed.y == t_2)) {
        return vec3(0.0, side.y, 0.0);
    }
    return vec3(0.0, 0.0, side.z);
}

vec3 rotate(vec4 q, vec3 v) {
    vec3 t_3 = (2.0 * cross(q.xyz, v));
    return ((v + (q.w * t_3)) + cross(q.xyz, t_3));
}

vec3 rotateBack(vec4 q_1, vec3 v_1) {
    vec3 _e6 = rotate(vec4(-(q_1.xyz), q_1.w), v_1);
    return _e6;
}

vec3 outwardNormal(uint i_6, Ray ray, float t) {
    Bounds _e3 = fetchBounds(i_6);
    vec3 origin_10 = (ray.start.point - _e3.center);
    bool _e8 = isSphere(i_6);
    if (_e8) {
        return normalize((origin_10 + (t * ray.direction)));
    }
    bool _e13 = isPlane(i_6);
    if (_e13) {
        return _e3.center;
    }
    Extent _e15 = fetchExtent(i_6);
    bool _e16 = isFlat(i_6);
    if (_e16) {
        return normalize(cross(_e15.a.xyz, _e15.b.xyz));
    }
    bool inside = (i_6 == ray.start.inside);
    vec3 _e27 = rotate(_e15.a, origin_10);
    vec3 _e30 = rotate(_e15.a, ray.direction);
    vec3 _e35 = boxNormal(_e27, _e30, _e15.b.xyz, ray.start.tMin, inside);
    vec3 _e37 = rotateBack(_e15.a, _e35);
    return _e37;
}

Basis basisAbout(vec3 n) {
    float side_1 = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a_1 = (-1.0 / (side_1 + n.z));
    float b_4 = ((n.x * n.y) * a_1);
    return Basis(vec3((1.0 + (((side_1 * n.x) * n.x) * a_1)), (side_1 * b_4), (-(side_1) * n.x)), vec3(b_4, (side_1 + ((n.y * n.y) * a_1)), -(n.y)), n);
}

vec3 toLocal(Basis b, vec3 v_2) {
    return vec3(dot(v_2, b.tangent), dot(v_2, b.bitangent), dot(v_2, b.normal));
}

Vertex vertexAt(Ray ray_1, Hit hit) {
    Surface _e3 = fetchSurface(hit.shape);
    vec3 _e6 = outwardNormal(hit.shape, ray_1, hit.t);
    bool _e11 = isDielectric(_e3);
    bool turned = ((dot(_e6, ray_1.direction) > 0.0) && !(_e11));
    Basis _e16 = basisAbout((turned ? -(_e6) : _e6));
    vec3 _e26 = toLocal(_e16, -(ray_1.direction));
    return Vertex((ray_1.start.point + (hit.t * ray_1.direction)), hit.shape, _e6, _e16, _e26, _e3);
}

Start onSurface(vec3 point, uint shape, bool seenFromInside) {
    return Start(point, (seenFromInside ? noShape : shape), (seenFromInside ? shape : noShape), (1e-5 * length(point)));
}

Ray rayFrom(Vertex v_3, vec3 direction_2) {
    bool inwards = (dot(direction_2, v_3.outward) < 0.0);
    bool _e9 = isFlat(v_3.shape);
    Start _e12 = onSurface(v_3.point, v_3.shape, (inwards && !(_e9)));
    return Ray(_e12, direction_2);
}

vec3 litSide(Vertex v_4) {
    bool _e6 = isDielectric(v_4.surface);
    return (_e6 ? vec3(0.0) : v_4.basis.normal);
}

float misWeight(float own, float other) {
    float ratio_4 = (other / own);
    return (1.0 / (1.0 + (ratio_4 * ratio_4)));
}

Emitter fetchEmitter(uint i_7) {
    vec4 t0_3 = texelFetch(sceneTable, ivec2(uvec2(14u, i_7)), 0);
    vec4 t1_2 = texelFetch(sceneTable, ivec2(uvec2(15u, i_7)), 0);
    vec4 t2_1 = texelFetch(sceneTable, ivec2(uvec2(16u, i_7)), 0);
    vec4 t3_1 = texelFetch(sceneTable, ivec2(uvec2(17u, i_7)), 0);
    vec4 t4_1 = texelFetch(sceneTable, ivec2(uvec2(18u, i_7)), 0);
    return Emitter(t0_3.xyz, t0_3.w, t1_2.xyz, t1_2.w, t2_1.xyz, t2_1.w, t3_1.xyz, t3_1.w, t4_1.x, t4_1.y, t4_1.z, t4_1.w);
}

vec2 quadrantAngles(vec2 x, vec2 y) {
    vec2 low = min(x, y);
    vec2 high = max(x, y);
    bvec2 middle_1 = greaterThan(low, (0.41421357 * high));
    vec2 r = (mix(low, (low - high), middle_1) / max(mix(high, (low + high), middle_1), vec2(1e-30)));
    vec2 z_1 = (r * r);
    vec2 series = ((((((0.080537446 * z_1) - vec2(0.13877685)) * z_1) + vec2(0.19977711)) * z_1) - vec2(0.3333295));
    vec2 angle = (mix(vec2(0.0), vec2(0.7853982), middle_1) + (((series * z_1) * r) + r));
    return mix(angle, (vec2(1.5707964) - angle), greaterThan(y, x));
}

EnvironmentLight lightWithin(Corners k, vec2 at, float sine) {
    vec4 light = mix(mix(k.a, k.b, at.x), mix(k.c, k.d, at.x), at.y);
    return EnvironmentLight(light.xyz, (max(light.w, 0.0) / sine));
}

Corners environmentCorners(uvec2 cell) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size = uvec2(_e3);
    uint left = (((cell.x == 0u) ? size.x : cell.x) - 1u);
    uint right = ((cell.x == size.x) ? 0u : cell.x);
    uint upper = (max(cell.y, 1u) - 1u);
    uint lower = min(cell.y, (size.y - 1u));
    vec4 above = vec4(1.0, 1.0, 1.0, ((cell.y == 0u) ? -1.0 : 1.0));
    vec4 below = vec4(1.0, 1.0, 1.0, ((cell.y == size.y) ? -1.0 : 1.0));
    vec4 _e52 = texelFetch(environment, ivec2(uvec2(left, upper)), 0);
    vec4 _e57 = texelFetch(environment, ivec2(uvec2(right, upper)), 0);
    vec4 _e62 = texelFetch(environment, ivec2(uvec2(left, lower)), 0);
    vec4 _e67 = texelFetch(environment, ivec2(uvec2(right, lower)), 0);
    return Corners((above * _e52), (above * _e57), (below * _e62), (below * _e67));
}

EnvironmentLight lookUpEnvironment(vec3 direction_3) {
    vec2 size_1 = frame.environmentSize;
    float sine_1 = max(length(direction_3.xz), 1e-9);
    vec2 _e15 = quadrantAngles(abs(vec2(direction_3.z, direction_3.y)), vec2(abs(direction_3.x), sine_1));
    float turn = (((direction_3.z > 0.0) ? (3.1415927 - _e15.x) : _e15.x) * ((direction_3.x < 0.0) ? -1.0 : 1.0));
    float _e35 = frame.environmentTurn;
    float column = ((fract(((turn * 0.15915494) + _e35)) * size_1.x) + 0.5);
    float fromPole = ((_e15.y * (size_1.y / 3.1415927)) + 0.5);
    float row = floor(fromPole);
    bool isLower = (direction_3.y < 0.0);
    vec2 cell_1 = vec2(floor(column), (isLower ? (size_1.y - row) : row));
    float within = (fromPole - row);
    vec2 at_1 = vec2((column - cell_1.x), (isLower ? (1.0 - within) : within));
    Corners _e66 = environmentCorners(uvec2(cell_1));
    EnvironmentLight _e67 = lightWithin(_e66, at_1, sine_1);
    return _e67;
}

vec3 sky(vec3 direction_4) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_4.y, 0.0));
}

EnvironmentLight skyLight(vec3 direction_5) {
    EnvironmentLight _e1 = lookUpEnvironment(direction_5);
    vec3 _e3 = sky(direction_5);
    return EnvironmentLight((_e1.radiance * _e3), _e1.pdf);
}

vec3 skyRadiance(vec3 direction_6) {
    EnvironmentLight _e1 = skyLight(direction_6);
    return _e1.radiance;
}

bool isOnDisc(Emitter e, vec3 direction_7) {
    vec3 chord = (direction_7 + e.u);
    return ((3.1415927 * dot(chord, chord)) < e.area);
}

vec3 radianceFromInfinity(Emitter e_1, vec3 direction_8) {
    if ((e_1.kind == 6.0)) {
        vec3 _e5 = skyRadiance(direction_8);
        return _e5;
    }
    bool _e9 = isOnDisc(e_1, direction_8);
    bool disc = ((e_1.kind == 5.0) && _e9);
    return (disc ? e_1.radiance : vec3(0.0));
}

SphereView viewSphere(Emitter e_2, vec3 point_1) {
    vec3 toCenter = (e_2.position - point_1);
    float d_1 = length(toCenter);
    float power = abs(((d_1 - e_2.radius) * (d_1 + e_2.radius)));
    bool inside_1 = (d_1 <= e_2.radius);
    float sine_2 = min((e_2.radius / max(d_1, 1e-30)), 1.0);
    float cosine_11 = (sqrt(power) / max(d_1, 1e-30));
    return SphereView(toCenter, d_1, power, inside_1, (inside_1 ? 2.0 : ((sine_2 * sine_2) / (1.0 + cosine_11))));
}

float conePdf(float width) {
    return (1.0 / (6.2831855 * max(width, 1e-31)));
}

float spherePdf(Emitter e_3, vec3 point_2, vec3 direction_9) {
    SphereView _e3 = viewSphere(e_3, point_2);
    bool reached = (_e3.inside || (dot(direction_9, _e3.toCenter) > 0.0));
    float _e11 = conePdf(_e3.width);
    return (reached ? _e11 : 0.0);
}

float areaPdf(float area, float height, float distance_) {
    float pdf = (((distance_ / max(height, 1e-30)) * distance_) / max((area / distance_), 1e-30));
    return min(pdf, 1e30);
}

float pdfOfView(QuadView q_2, float area_1, float distance_1) {
    float _e4 = areaPdf(area_1, q_2.height, distance_1);
    float pdf_1 = (q_2.bySolidAngle ? (1.0 / max(q_2.solidAngle, 0.01)) : _e4);
    return (q_2.lit ? pdf_1 : 0.0);
}

float arctangent(float x_1) {
    float a_2 = abs(x_1);
    bool steep = (a_2 > 2.4142137);
    bool middle_2 = ((a_2 > 0.41421357) && !(steep));
    float r_1 = (steep ? (-1.0 / max(a_2, 1.0)) : (middle_2 ? ((a_2 - 1.0) / (a_2 + 1.0)) : a_2));
    float base = (steep ? 1.5707964 : (middle_2 ? 0.7853982 : 0.0));
    float z_2 = (r_1 * r_1);
    float series_1 = ((((((0.080537446 * z_2) - 0.13877685) * z_2) + 0.19977711) * z_2) - 0.3333295);
    return (sign(x_1) * (base + (((series_1 * z_2) * r_1) + r_1)));
}

float stretch(float x_2, vec2 y_1, float h) {
    vec2 r_2 = sqrt(((vec2((x_2 * x_2)) + (y_1 * y_1)) + vec2((h * h))));
    float _e16 = arctangent(((x_2 * y_1.y) / (h * r_2.y)));
    float _e22 = arctangent(((x_2 * y_1.x) / (h * r_2.x)));
    return (_e16 - _e22);
}

QuadView viewQuad(Emitter e_4, vec3 point_3) {
    vec3 corner = (e_4.position - point_3);
    vec2 lengths = vec2(length(e_4.u), length(e_4.v));
    vec3 axisX = (e_4.u / vec3(lengths.x));
    vec3 axisY = (e_4.v / vec3(lengths.y));
    vec3 normal_6 = normalize(cross(axisX, axisY));
    float signedHeight = dot(corner, normal_6);
    float least = (1e-7 * (lengths.x + lengths.y));
    float height_1 = max(abs(signedHeight), least);
    bool lit = ((abs(signedHeight) > least) && ((e_4.oneSided == 0.0) || (signedHeight < 0.0)));
    vec2 low_1 = vec2(dot(corner, axisX), dot(corner, axisY));
    vec2 high_1 = (low_1 + lengths);
    vec2 y_8 = vec2(low_1.y, high_1.y);
    float _e44 = stretch(low_1.x, y_8, height_1);
    float _e46 = stretch(high_1.x, y_8, height_1);
    float solidAngle = (_e46 - _e44);
    bool rectangle = (abs(dot(axisX, axisY)) <= 1e-5);
    vec3 axisZ = (normal_6 * ((signedHeight > 0.0) ? 1.0 : -1.0));
    return QuadView(corner, axisX, axisY, axisZ, low_1, high_1, height_1, _e44, solidAngle, lit, (rectangle && (solidAngle > 0.01)));
}

float quadPdf(Emitter e_5, vec3 point_4, float distance_2) {
    QuadView _e3 = viewQuad(e_5, point_4);
    float _e5 = pdfOfView(_e3, e_5.area, distance_2);
    return _e5;
}

BoxView viewBox(Emitter e_6, vec3 point_5) {
    Extent _e4 = fetchExtent(uint(e_6.shape));
    vec4 rotation = _e4.a;
    vec3 _e8 = rotate(rotation, (point_5 - e_6.position));
    bvec3 seen = greaterThan(abs(_e8), e_6.u);
    vec3 faces = mix(vec3(0.0), ((4.0 * e_6.u.yzx) * e_6.u.zxy), seen);
    return BoxView(rotation, _e8, faces, ((faces.x + faces.y) + faces.z), !(any(seen)));
}

float boxPdf(Emitter e_7, vec3 point_6, vec3 direction_10, float distance_3, vec3 normal) {
    BoxView _e5 = viewBox(e_7, point_6);
    float _e10 = areaPdf(_e5.area, (distance_3 * abs(dot(direction_10, normal))), distance_3);
    float _e12 = conePdf(2.0);
    return (_e5.inside ? _e12 : _e10);
}

float directionalPdf(Emitter e_8, vec3 direction_11) {
    bool _e7 = isOnDisc(e_8, direction_11);
    return (_e7 ? (1.0 / max(e_8.area, 1e-31)) : 0.0);
}

float skyPdf(vec3 direction_12) {
    EnvironmentLight _e1 = skyLight(direction_12);
    return _e1.pdf;
}

float emitterPdf(Emitter e_9, vec3 point_7, vec3 direction_13, float distance_4, vec3 normal_1) {
    if ((e_9.kind == 0.0)) {
        float _e8 = spherePdf(e_9, point_7, direction_13);
        return _e8;
    }
    if ((e_9.kind == 1.0)) {
        float _e12 = quadPdf(e_9, point_7, distance_4);
        return _e12;
    }
    if ((e_9.kind == 2.0)) {
        float _e16 = boxPdf(e_9, point_7, direction_13, distance_4, normal_1);
        return _e16;
    }
    if ((e_9.kind == 5.0)) {
        float _e20 = directionalPdf(e_9, direction_13);
        return _e20;
    }
    if ((e_9.kind == 6.0)) {
        float _e24 = skyPdf(direction_13);
        return _e24;
    }
    return 0.0;
}

float spotFalloff(Emitter e_10, vec3 toLight) {
    float share = clamp(((-(dot(toLight, e_10.u)) - e_10.radius) / (e_10.cosInner - e_10.radius)), 0.0, 1.0);
    return (share * share);
}

float estimatedIrradiance(Emitter e_11, vec3 point_8, vec3 normal_2) {
    if ((e_11.kind == 6.0)) {
        return e_11.power;
    }
    bool isQuad = (e_11.kind == 1.0);
    bool isFar = (e_11.kind == 5.0);
    vec3 middle_3 = (e_11.position + (isQuad ? (0.5 * (e_11.u + e_11.v)) : vec3(0.0)));
    vec3 toLight_1 = (isFar ? -(e_11.u) : (middle_3 - point_8));
    float distance2_ = dot(toLight_1, toLight_1);
    float distance_6 = sqrt(distance2_);
    float grown = max((distance_6 + e_11.reach), 1e-15);
    float above_1 = clamp(((dot(normal_2, toLight_1) + e_11.reach) / grown), 0.0, 1.0);
    float cosine_12 = ((dot(normal_2, normal_2) == 0.0) ? 1.0 : above_1);
    float height_2 = (-(dot(cross(e_11.u, e_11.v), toLight_1)) / max(e_11.area, 1e-30));
    float side_2 = ((e_11.oneSided == 1.0) ? max(height_2, 0.0) : abs(height_2));
    float lampCosine = ((side_2 > 0.0) ? ((side_2 + e_11.reach) / grown) : 0.0);
    float _e74 = spotFalloff(e_11, (toLight_1 / vec3(max(distance_6, 1e-15))));
    float share_1 = ((e_11.kind == 4.0) ? _e74 : (isQuad ? lampCosine : 1.0));
    float square = (isQuad ? (distance2_ + (e_11.area / 3.1415927)) : max(distance2_, (e_11.area / 12.566371)));
    return (((e_11.power * cosine_12) * share_1) / (isFar ? 1.0 : max(square, 1e-15)));
}

float probabilityOf(Emitter e_12, vec3 point_9, vec3 normal_3, float total) {
    uint _e6 = frame.emitterCount;
    if ((_e6 <= 1u)) {
        uint _e11 = frame.emitterCount;
        return float(_e11);
    }
    float _e13 = estimatedIrradiance(e_12, point_9, normal_3);
    return (_e13 / max(total, 1e-37));
}

vec3 foundLight(Vertex v_5, Origin origin_3, Ray ray_2, Hit hit_1) {
    vec3 sum = vec3(0.0);
    uint i_8 = 0u;
    bool escaped = (hit_1.shape == noShape);
    bool hidden = (((uint(v_5.surface.code) & 16u) != 0u) && (dot(v_5.outward, ray_2.direction) > 0.0));
    vec3 emission = (hidden ? vec3(0.0) : v_5.surface.emission);
    if (((v_5.surface.emitter < 0.0) && !(escaped))) {
        return emission;
    }
    uint _e36 = frame.emitterCount;
    if ((_e36 == 0u)) {
        vec3 _e39 = sum;
        return _e39;
    }
    i_8 = (escaped ? 0u : uint(max(v_5.surface.emitter, 0.0)));
    uint _e48 = i_8;
    uint _e53 = frame.emitterCount;
    uint end = (escaped ? _e53 : (_e48 + 1u));
    while(true) {
        uint _e55 = i_8;
        Emitter _e56 = fetchEmitter(_e55);
        vec3 _e58 = radianceFromInfinity(_e56, ray_2.direction);
        vec3 radiance_1 = (escaped ? _e58 : emission);
        float _e64 = emitterPdf(_e56, origin_3.point, ray_2.direction, hit_1.t, v_5.outward);
        float _e68 = probabilityOf(_e56, origin_3.point, origin_3.normal, origin_3.total);
        float pdf_2 = (_e64 * _e68);
        vec3 _e70 = sum;
        float _e72 = misWeight(origin_3.pdf, pdf_2);
        sum = (_e70 + (radiance_1 * ((origin_3.pdf <= 0.0) ? 1.0 : _e72)));
        uint _e81 = i_8;
        i_8 = (_e81 + 1u);
        uint _e83 = i_8;
        if ((_e83 >= end)) {
            break;
        }
    }
    vec3 _e85 = sum;
    return _e85;
}

vec3 turnTo(vec3 axis, vec3 v_6) {
    float s_25 = ((axis.z >= 0.0) ? 1.0 : -1.0);
    float a_3 = (-1.0 / (s_25 + axis.z));
    float b_5 = ((axis.x * axis.y) * a_3);
    vec3 x_14 = vec3((1.0 + (((s_25 * axis.x) * axis.x) * a_3)), (s_25 * b_5), (-(s_25) * axis.x));
    vec3 y_9 = vec3(b_5, (s_25 + ((axis.y * axis.y) * a_3)), -(axis.y));
    return (((v_6.x * x_14) + (v_6.y * y_9)) + (v_6.z * axis));
}

ConeDirection sampleCone(vec3 axis_1, float width_1, vec2 u) {
    float oneMinusCosine = (u.x * width_1);
    float cosine_13 = (1.0 - oneMinusCosine);
    float sine2_ = (oneMinusCosine * (2.0 - oneMinusCosine));
    float sine_3 = sqrt(max(sine2_, 0.0));
    float phi = (6.2831855 * u.y);
    vec2 turn_1 = vec2(cos(phi), sin(phi));
    vec3 _e23 = turnTo(axis_1, vec3(((sine_3 / length(turn_1)) * turn_1), cosine_13));
    return ConeDirection(_e23, cosine_13, sine2_);
}

LightSample sampleSphere(Emitter e_13, vec3 point_10, vec2 u_1) {
    SphereView _e3 = viewSphere(e_13, point_10);
    vec3 axis_2 = ((_e3.distance_ < 1e-30) ? vec3(0.0, 0.0, 1.0) : (_e3.toCenter / vec3(max(_e3.distance_, 1e-30))));
    ConeDirection _e19 = sampleCone(axis_2, _e3.width, u_1);
    float along = (_e3.distance_ * _e19.cosine);
    float halfChord = sqrt(max(((e_13.radius * e_13.radius) - ((_e3.distance_ * _e3.distance_) * _e19.sine2_)), 0.0));
    float larger = (abs(along) + halfChord);
    bool takeLarger = (_e3.inside && (along > 0.0));
    float distance_7 = (takeLarger ? larger : (_e3.power / max(larger, 1e-30)));
    float _e49 = conePdf(_e3.width);
    return LightSample(_e19.direction, distance_7, e_13.radiance, _e49, false);
}

vec2 cosineAndSine(float x_3) {
    float h_3 = (0.5 * x_3);
    float z_3 = (h_3 * h_3);
    float sine_4 = (((((((-0.00019515296 * z_3) + 0.008332161) * z_3) - 0.16666655) * z_3) * h_3) + h_3);
    return vec2((1.0 - ((2.0 * sine_4) * sine_4)), ((2.0 * sine_4) * sqrt((1.0 - (sine_4 * sine_4)))));
}

vec3 sphericalRectangle(QuadView q_3, vec2 u_2) {
    float h_4 = q_3.height;
    vec2 y_10 = vec2(q_3.low.y, q_3.high.y);
    vec2 s_26 = (y_10 / sqrt(((y_10 * y_10) + vec2((h_4 * h_4)))));
    vec2 _e21 = cosineAndSine((0.5 * (q_3.start + (u_2.x * q_3.solidAngle))));
    vec2 across = (vec2((s_26.y - s_26.x), (s_26.y + s_26.x)) * _e21);
    float w_1 = (((2.0 * _e21.x) * _e21.y) / max(length(across), 1e-15));
    float x_15 = clamp(((h_4 * w_1) * inversesqrt(max((1.0 - (w_1 * w_1)), 1e-12))), q_3.low.x, q_3.high.x);
    float d2_ = ((x_15 * x_15) + (h_4 * h_4));
    vec2 ends = (y_10 * inversesqrt((vec2(d2_) + (y_10 * y_10))));
    float v_10 = mix(ends.x, ends.y, u_2.y);
    float atY = clamp(((v_10 * sqrt(d2_)) * inversesqrt(max((1.0 - (v_10 * v_10)), 1e-12))), y_10.x, y_10.y);
    return (((x_15 * q_3.axisX) + (atY * q_3.axisY)) + (h_4 * q_3.axisZ));
}

LightSample sampleQuad(Emitter e_14, vec3 point_11, vec2 u_3) {
    QuadView _e3 = viewQuad(e_14, point_11);
    vec3 onArea = ((_e3.corner + (u_3.x * e_14.u)) + (u_3.y * e_14.v));
    vec3 _e13 = sphericalRectangle(_e3, u_3);
    vec3 toLight_2 = (_e3.bySolidAngle ? _e13 : onArea);
    float distance_8 = max(length(toLight_2), _e3.height);
    float _e23 = pdfOfView(_e3, e_14.area, distance_8);
    return LightSample((toLight_2 / vec3(distance_8)), distance_8, e_14.radiance, _e23, false);
}

vec4 pointOnFaces(Emitter e_15, BoxView b_1, vec2 u_4) {
    float both = (b_1.faces.x + b_1.faces.y);
    float at_2 = (u_4.x * b_1.area);
    bool onX = (at_2 < b_1.faces.x);
    bool onY = (!(onX) && (at_2 < both));
    float face = (onX ? b_1.faces.x : (onY ? b_1.faces.y : b_1.faces.z));
    float within_1 = clamp(((at_2 - (onX ? 0.0 : (onY ? b_1.faces.x : both))) / max(face, 1e-30)), 0.0, 1.0);
    vec3 axis_3 = vec3((onX ? 1.0 : 0.0), (onY ? 1.0 : 0.0), ((onX || onY) ? 0.0 : 1.0));
    vec3 p = vec3(((dot(axis_3, b_1.point) >= 0.0) ? 1.0 : -1.0), ((2.0 * within_1) - 1.0), ((2.0 * u_4.y) - 1.0));
    vec3 toLight_3 = (((onX ? p.xyz : (onY ? p.zxy : p.yzx)) * e_15.u) - b_1.point);
    return vec4(toLight_3, abs(dot(axis_3, toLight_3)));
}

LightSample sampleBox(Emitter e_16, vec3 point_12, vec2 u_5) {
    BoxView _e3 = viewBox(e_16, point_12);
    vec4 _e4 = pointOnFaces(e_16, _e3, u_5);
    ConeDirection _e10 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_5);
    vec3 outwards = _e10.direction;
    Slabs _e16 = boxSlabs(_e3.point, outwards, e_16.u);
    float distance_9 = (_e3.inside ? max(_e16.far, 0.0) : length(_e4.xyz));
    vec3 direction_20 = (_e3.inside ? outwards : (_e4.xyz / vec3(max(distance_9, 1e-30))));
    float _e31 = areaPdf(_e3.area, _e4.w, distance_9);
    float _e33 = conePdf(2.0);
    float pdf_3 = (_e3.inside ? _e33 : _e31);
    vec3 _e37 = rotateBack(_e3.rotation, direction_20);
    return LightSample(_e37, distance_9, e_16.radiance, pdf_3, false);
}

LightSample samplePoint(Emitter e_17, vec3 point_13) {
    vec3 toLight_4 = (e_17.position - point_13);
    float distance_10 = length(toLight_4);
    float safe = max(distance_10, 1e-15);
    return LightSample((toLight_4 / vec3(safe)), distance_10, (e_17.radiance / vec3((safe * safe))), ((distance_10 > 1e-15) ? 1.0 : 0.0), true);
}

LightSample sampleSpot(Emitter e_18, vec3 point_14) {
    LightSample s_3 = LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, false);
    LightSample _e2 = samplePoint(e_18, point_14);
    s_3 = _e2;
    vec3 _e5 = s_3.direction;
    float _e6 = spotFalloff(e_18, _e5);
    vec3 _e8 = s_3.radiance;
    s_3.radiance = (_e8 * _e6);
    float _e12 = s_3.pdf;
    s_3.pdf = ((_e6 > 0.0) ? _e12 : 0.0);
    LightSample _e17 = s_3;
    return _e17;
}

LightSample sampleDirectional(Emitter e_19, vec2 u_6) {
    bool delta = (e_19.area == 0.0);
    ConeDirection _e10 = sampleCone(-(e_19.u), (e_19.area / 6.2831855), u_6);
    return LightSample(_e10.direction, 1e30, e_19.radiance, (delta ? 1.0 : (1.0 / max(e_19.area, 1e-31))), delta);
}

Parts splitProduct(vec2 u_7, uvec2 n_1) {
    uvec2 digits = uvec2((u_7 * 16777216.0));
    uvec2 low_2 = ((digits & uvec2(4095u)) * n_1);
    uvec2 high_2 = (((digits >> uvec2(12u)) * n_1) + (low_2 >> uvec2(12u)));
    return Parts((high_2 >> uvec2(12u)), vec2((((high_2 & uvec2(4095u)) << uvec2(12u)) | (low_2 & uvec2(4095u)))));
}

uint mixBits(uint x_4) {
    uint y_2 = 0u;
    y_2 = ((x_4 ^ (x_4 >> 16u)) * 569420461u);
    uint _e7 = y_2;
    uint _e8 = y_2;
    y_2 = ((_e7 ^ (_e8 >> 15u)) * 1935289751u);
    uint _e14 = y_2;
    uint _e15 = y_2;
    return (_e14 ^ (_e15 >> 15u));
}

ChosenCell chooseCell(vec2 u_8) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_2 = uvec2(_e3);
    Parts _e9 = splitProduct(u_8, (size_2 + uvec2(0u, 1u)));
    uint _e17 = mixBits((floatBitsToUint(u_8.x) ^ (floatBitsToUint(u_8.y) * 2654435761u)));
    uint hash = (_e17 >> 8u);
    float _e26 = frame.environmentSize.x;
    float fine = ((float(hash) * 5.9604645e-8) * _e26);
    float x_16 = min(((_e9.rest.x + fine) * 5.9604645e-8), 0.99999994);
    uint rows = ((size_2.y + 2u) / 2u);
    bool second = (_e9.whole.y >= rows);
    vec4 entries = texelFetch(environment, ivec2(uvec2(_e9.whole.x, ((_e9.whole.y + size_2.y) - (second ? rows : 0u)))), 0);
    vec2 entry = (second ? entries.zw : entries.xy);
    bool own_1 = (x_16 < entry.x);
    uint other_1 = uint(entry.y);
    uint otherRow = (other_1 / size_2.x);
    uvec2 cell_2 = (own_1 ? _e9.whole : uvec2((other_1 - (otherRow * size_2.x)), otherRow));
    float rest_1 = (own_1 ? (x_16 / max(entry.x, 1e-37)) : ((x_16 - entry.x) / max((1.0 - entry.x), 1e-7)));
    return ChosenCell(cell_2, vec2(min(rest_1, 1.0), (_e9.rest.y * 5.9604645e-8)));
}

float linearSample(float u_9, float a, float b_2) {
    vec2 ends_1 = (vec2(a, b_2) / vec2(max((a + b_2), 1e-37)));
    return min((u_9 / max((ends_1.x + sqrt(mix((ends_1.x * ends_1.x), (ends_1.y * ends_1.y), u_9))), 1e-9)), 1.0);
}

EnvironmentSample sampleEnvironment(vec2 u_10) {
    vec2 size_3 = frame.environmentSize;
    ChosenCell _e4 = chooseCell(u_10);
    Corners _e6 = environmentCorners(_e4.cell);
    vec2 cell_3 = vec2(_e4.cell);
    bvec2 atPole = bvec2((cell_3.y == 0.0), (cell_3.y == size_3.y));
    float _e32 = linearSample(_e4.rest.y, max((_e6.a.w + _e6.b.w), 0.0), max((_e6.c.w + _e6.d.w), 0.0));
    float t_4 = ((_e32 * (any(atPole) ? 0.5 : 1.0)) + (atPole.x ? 0.5 : 0.0));
    float _e55 = linearSample(_e4.rest.x, mix(_e6.a.w, _e6.c.w, t_4), mix(_e6.b.w, _e6.d.w, t_4));
    bool isLower_1 = ((2.0 * cell_3.y) > size_3.y);
    float fromPole_1 = (isLower_1 ? ((size_3.y - cell_3.y) + (0.5 - t_4)) : (cell_3.y + (t_4 - 0.5)));
    vec2 _e76 = cosineAndSine((fromPole_1 * (3.1415927 / size_3.y)));
    float _e85 = frame.environmentTurn;
    float halfTurns = (2.0 * (((cell_3.x + (_e55 - 0.5)) / size_3.x) - _e85));
    float nearest = floor((halfTurns + 0.5));
    bool back = (fract((0.5 * nearest)) > 0.0);
    vec2 _e100 = cosineAndSine(((halfTurns - nearest) * 3.1415927));
    vec2 phi_1 = (_e100 * (back ? -1.0 : 1.0));
    float sine_5 = max(_e76.y, 1e-9);
    vec3 direction_21 = vec3((sine_5 * phi_1.y), (isLower_1 ? -(_e76.x) : _e76.x), (-(sine_5) * phi_1.x));
    EnvironmentLight _e119 = lightWithin(_e6, vec2(_e55, t_4), sine_5);
    return EnvironmentSample(direction_21, _e119);
}

LightSample sampleSky(vec2 u_11) {
    EnvironmentSample _e1 = sampleEnvironment(u_11);
    vec3 _e6 = sky(_e1.direction);
    return LightSample(_e1.direction, 1e30, (_e1.light.radiance * _e6), _e1.light.pdf, false);
}

LightSample sampleKind(Emitter e_20, vec3 point_15, vec2 u_12) {
    if ((e_20.kind == 0.0)) {
        LightSample _e6 = sampleSphere(e_20, point_15, u_12);
        return _e6;
    }
    if ((e_20.kind == 1.0)) {
        LightSample _e10 = sampleQuad(e_20, point_15, u_12);
        return _e10;
    }
    if ((e_20.kind == 2.0)) {
        LightSample _e14 = sampleBox(e_20, point_15, u_12);
        return _e14;
    }
    if ((e_20.kind == 3.0)) {
        LightSample _e18 = samplePoint(e_20, point_15);
        return _e18;
    }
    if ((e_20.kind == 4.0)) {
        LightSample _e22 = sampleSpot(e_20, point_15);
        return _e22;
    }
    if ((e_20.kind == 5.0)) {
        LightSample _e26 = sampleDirectional(e_20, u_12);
        return _e26;
    }
    LightSample _e27 = sampleSky(u_12);
    return _e27;
}

LightSample sampleEmitter(Emitter e_21, vec3 point_16, vec2 u_13) {
    LightSample s_4 = LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, false);
    LightSample _e3 = sampleKind(e_21, point_16, u_13);
    s_4 = _e3;
    float _e7 = s_4.pdf;
    float _e9 = s_4.distance_;
    s_4.pdf = ((_e9 <= (1e-5 * length(point_16))) ? 0.0 : _e7);
    LightSample _e16 = s_4;
    return _e16;
}

bool isThin(Surface s_5) {
    return ((uint(s_5.code) & 7u) == 7u);
}

bool hasSmoothLobe(Surface s_6) {
    bool _e8 = isThin(s_6);
    bool clear = ((abs((s_6.eta.x - 1.0)) < 0.001) || _e8);
    uint _e13 = kindOf(s_6);
    return ((s_6.alpha < 0.001) || ((_e13 == dielectric) && clear));
}

vec3 schlick(vec3 f0_, float cosine) {
    float m = max((1.0 - cosine), 0.0);
    float m2_ = (m * m);
    return (f0_ + ((vec3(1.0) - f0_) * ((m2_ * m2_) * m)));
}

vec3 metallicRoughnessF0_(Surface s_7) {
    return mix(vec3(0.04), s_7.baseColor, s_7.metallic);
}

vec3 metallicRoughnessDiffuse(Surface s_8, float cosine_1) {
    vec3 _e7 = schlick(vec3(0.04), cosine_1);
    return (((1.0 - s_8.metallic) * (1.0 - _e7.x)) * s_8.baseColor);
}

float specularShare(Surface s_9, float cosine_2) {
    vec3 _e2 = metallicRoughnessF0_(s_9);
    vec3 _e3 = schlick(_e2, cosine_2);
    float specular = dot(_e3, vec3(1.0));
    vec3 _e8 = metallicRoughnessDiffuse(s_9, 1.0);
    float diffuse_1 = dot(_e8, vec3(1.0));
    return (specular / max((specular + diffuse_1), 1e-20));
}

float facetShare(Surface s_10, float cosine_3) {
    uint _e2 = kindOf(s_10);
    float _e8 = specularShare(s_10, cosine_3);
    return ((_e2 == metallicRoughness) ? _e8 : ((_e2 == diffuse) ? 0.0 : 1.0));
}

float indexRatio(Surface s_11, float z) {
    return ((z < 0.0) ? (1.0 / s_11.eta.x) : s_11.eta.x);
}

float stretched(vec3 w, float alpha) {
    return sqrt(((w.z * w.z) + ((alpha * alpha) * dot(w.xy, w.xy))));
}

float reflectionBound(vec3 wo, float alpha_1) {
    float s_27 = (1.0 + length(wo.xy));
    float s2_ = (s_27 * s_27);
    float a2_ = (alpha_1 * alpha_1);
    return (((1.0 - a2_) * s2_) / (s2_ + ((a2_ * wo.z) * wo.z)));
}

float facetDensity(vec3 h_1, float alpha_2) {
    float slope = max(((dot(h_1.xy, h_1.xy) / (alpha_2 * alpha_2)) + (h_1.z * h_1.z)), 1.0);
    return (0.31830987 / (((alpha_2 * alpha_2) * slope) * slope));
}

float dielectricFresnel(float cosine_4, float ratio) {
    float inside2_ = (((ratio - 1.0) * (ratio + 1.0)) + (cosine_4 * cosine_4));
    float inside_2 = sqrt(max(inside2_, 0.0));
    float across_1 = ((cosine_4 - inside_2) / (cosine_4 + inside_2));
    float along_1 = ((((ratio * ratio) * cosine_4) - inside_2) / (((ratio * ratio) * cosine_4) + inside_2));
    return ((inside2_ > 0.0) ? (0.5 * ((across_1 * across_1) + (along_1 * along_1))) : 1.0);
}

float glassReflectance(float cosine_5, float ratio_1, bool thin) {
    float _e3 = dielectricFresnel(cosine_5, ratio_1);
    return (thin ? ((2.0 * _e3) / (1.0 + _e3)) : _e3);
}

vec3 conductorFresnel(float cosine_6, vec3 eta, vec3 k_1) {
    float cosine2_ = (cosine_6 * cosine_6);
    float sine2_1 = (1.0 - cosine2_);
    vec3 difference = (((eta * eta) - (k_1 * k_1)) - vec3(sine2_1));
    vec3 a2PlusB2_ = sqrt(((difference * difference) + ((((4.0 * eta) * eta) * k_1) * k_1)));
    vec3 larger_1 = sqrt(((0.5 * (a2PlusB2_ + abs(difference))) + vec3(1e-20)));
    vec3 a_4 = mix(((eta * k_1) / larger_1), larger_1, greaterThan(difference, vec3(0.0)));
    vec3 across_2 = ((((a2PlusB2_ + vec3(cosine2_)) - ((2.0 * cosine_6) * a_4)) + vec3(1e-20)) / (((a2PlusB2_ + vec3(cosine2_)) + ((2.0 * cosine_6) * a_4)) + vec3(1e-20)));
    vec3 sum_1 = ((cosine2_ * a2PlusB2_) + vec3((sine2_1 * sine2_1)));
    vec3 part = (((2.0 * cosine_6) * sine2_1) * a_4);
    return ((0.5 * across_2) * (vec3(1.0) + (((sum_1 - part) + vec3(1e-20)) / ((sum_1 + part) + vec3(1e-20)))));
}

vec3 conductorReflectance(Surface s_12, float cosine_7) {
    float constants = dot((s_12.eta + s_12.k), vec3(1.0));
    vec3 _e11 = conductorFresnel(cosine_7, s_12.eta, s_12.k);
    return ((constants > 0.0) ? _e11 : s_12.baseColor);
}

vec3 facetReflectance(Surface s_13, float cosine_8, float ratio_2) {
    uint _e3 = kindOf(s_13);
    if ((_e3 == dielectric)) {
        bool _e6 = isThin(s_13);
        float _e7 = glassReflectance(cosine_8, ratio_2, _e6);
        return vec3(_e7);
    }
    if ((_e3 == conductor)) {
        vec3 _e11 = conductorReflectance(s_13, cosine_8);
        return _e11;
    }
    vec3 _e12 = metallicRoughnessF0_(s_13);
    vec3 _e13 = schlick(_e12, cosine_8);
    return _e13;
}

float singleScatteringAlbedo(float cosine_9, float alpha_3) {
    float x_17 = (cosine_9 / (cosine_9 + alpha_3));
    vec4 byAlpha = (vec4(0.887807, 0.309386, -0.270728, 0.0252433) + (x_17 * (vec4(1.08526, -3.21434, -1.87718, 1.61195) + (x_17 * (vec4(-5.18071, 10.7648, 6.30913, -8.09265) + (x_17 * (vec4(7.80474, -12.743, -24.1046, 25.2536) + (x_17 * vec4(-3.60041, 4.60906, 23.1225, -22.9342)))))))));
    float a2_1 = (alpha_3 * alpha_3);
    return min(dot(byAlpha, vec4(1.0, alpha_3, a2_1, (a2_1 * alpha_3))), 1.0);
}

vec3 compensation(Surface s_14, float cosine_10) {
    uint _e2 = kindOf(s_14);
    bool asked = (((uint(s_14.code) & 8u) != 0u) && ((_e2 == conductor) || (_e2 == metallicRoughness)));
    if (!(asked)) {
        return vec3(1.0);
    }
    float _e19 = singleScatteringAlbedo(cosine_10, s_14.alpha);
    vec3 _e22 = facetReflectance(s_14, 1.0, 1.0);
    return (vec3(1.0) + (_e22 * ((1.0 - _e19) / _e19)));
}

FacetLobe evaluateFacets(Surface s_15, vec3 wo_1, vec3 wi) {
    bool crossing_1 = ((wo_1.z < 0.0) != (wi.z < 0.0));
    float _e11 = indexRatio(s_15, wo_1.z);
    vec3 m_1 = (wo_1 + (wi * (crossing_1 ? _e11 : 1.0)));
    float m2_1 = max(dot(m_1, m_1), 1e-20);
    vec3 h_5 = (m_1 * inversesqrt(m2_1));
    float oh = dot(wo_1, h_5);
    float ih = dot(wi, h_5);
    float zo = abs(wo_1.z);
    float zi = abs(wi.z);
    float _e28 = stretched(wo_1, s_15.alpha);
    float _e30 = stretched(wi, s_15.alpha);
    uint _e31 = kindOf(s_15);
    bool isGlass = (_e31 == dielectric);
    float _e35 = reflectionBound(wo_1, s_15.alpha);
    float bound_1 = (isGlass ? 1.0 : _e35);
    bool faces_1 = ((((oh * h_5.z) * wo_1.z) >= 0.0) && (((ih * h_5.z) * wi.z) >= 0.0));
    float _e57 = facetDensity(h_5, s_15.alpha);
    float spread = ((crossing_1 ? (abs((oh * ih)) / m2_1) : 0.25) * (faces_1 ? (2.0 * _e57) : 0.0));
    vec3 _e64 = facetReflectance(s_15, abs(oh), _e11);
    vec3 passes = (crossing_1 ? (vec3(1.0) - _e64) : _e64);
    float masked = (zi / max(((zi * _e28) + (zo * _e30)), 1e-20));
    float chosen_1 = ((isGlass ? passes.x : 1.0) * (crossing_1 ? (_e11 * _e11) : 1.0));
    vec3 _e82 = compensation(s_15, zo);
    return FacetLobe((((passes * _e82) * spread) * masked), ((spread * chosen_1) / ((bound_1 * zo) + _e28)), abs(oh));
}

vec4 evaluateBsdf(Surface s_16, vec3 wo_2, vec3 wi_1) {
    vec4 value = vec4(0.0);
    vec3 albedo = vec3(0.0);
    uint _e3 = kindOf(s_16);
    bool opaque = (_e3 != dielectric);
    bool dark = (opaque && ((wo_2.z < 0.0) || (wi_1.z <= 0.0)));
    bool _e14 = hasSmoothLobe(s_16);
    if ((dark || (!(opaque) && _e14))) {
        return vec4(0.0);
    }
    float _e21 = facetShare(s_16, wo_2.z);
    albedo = s_16.baseColor;
    if ((_e3 != diffuse)) {
        FacetLobe _e29 = evaluateFacets(s_16, wo_2, wi_1);
        value = (_e14 ? vec4(0.0) : vec4(_e29.value, (_e21 * _e29.pdf)));
        vec3 _e40 = metallicRoughnessDiffuse(s_16, _e29.cosine);
        albedo = ((_e3 == metallicRoughness) ? _e40 : vec3(0.0));
    }
    vec4 _e44 = value;
    vec3 _e45 = albedo;
    value = (_e44 + (vec4(_e45, (1.0 - _e21)) * (0.31830987 * max(wi_1.z, 0.0))));
    vec4 _e59 = value;
    return ((1.0 - s_16.reflectivity) * _e59);
}

float intersectSphere(vec3 origin_4, vec3 direction_14, vec3 center, float radius, float tMin_1, bool startsInside_1) {
    vec3 toCenter_1 = (center - origin_4);
    float along_2 = dot(toCenter_1, direction_14);
    vec3 across_3 = (toCenter_1 - (along_2 * direction_14));
    float discriminant = ((radius * radius) - dot(across_3, across_3));
    float half_ = sqrt(max(discriminant, 0.0));
    float near = (along_2 - half_);
    float far = (along_2 + half_);
    float t_5 = ((near > tMin_1) ? near : far);
    return (startsInside_1 ? max(far, 0.0) : (((discriminant >= 0.0) && (t_5 > tMin_1)) ? t_5 : 1e30));
}

float hitSphere(uint i_9, Bounds bounds, Ray ray_3) {
    float _e13 = intersectSphere(ray_3.start.point, ray_3.direction, bounds.center, bounds.radius, ray_3.start.tMin, (i_9 == ray_3.start.inside));
    return ((i_9 == ray_3.start.leaves) ? 1e30 : _e13);
}

bool isTurned(vec4 q_4) {
    return any(notEqual(q_4.xyz, vec3(0.0)));
}

float intersectBox(vec3 origin_5, vec3 direction_15, vec3 halfSize_2, float tMin_2, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_5, direction_15, halfSize_2);
    float t_6 = ((_e5.near > tMin_2) ? _e5.near : _e5.far);
    return (startsInside_2 ? max(_e5.far, 0.0) : (((_e5.near <= _e5.far) && (t_6 > tMin_2)) ? t_6 : 1e30));
}

float hitBox(uint i_10, Bounds bounds_1, Ray ray_4) {
    vec3 origin_6 = vec3(0.0);
    vec3 direction_16 = vec3(0.0);
    Extent _e3 = fetchExtent(i_10);
    origin_6 = (ray_4.start.point - bounds_1.center);
    direction_16 = ray_4.direction;
    bool _e12 = isTurned(_e3.a);
    if (_e12) {
        vec3 _e14 = origin_6;
        vec3 _e15 = rotate(_e3.a, _e14);
        origin_6 = _e15;
        vec3 _e17 = direction_16;
        vec3 _e18 = rotate(_e3.a, _e17);
        direction_16 = _e18;
    }
    vec3 _e19 = origin_6;
    vec3 _e20 = direction_16;
    float _e28 = intersectBox(_e19, _e20, _e3.b.xyz, ray_4.start.tMin, (i_10 == ray_4.start.inside));
    return ((i_10 == ray_4.start.leaves) ? 1e30 : _e28);
}

float intersectQuad(vec3 origin_7, vec3 direction_17, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_3) {
    vec3 normal_7 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_17, normal_7);
    vec3 toCenter_2 = (center_1 - origin_7);
    float t_7 = (dot(toCenter_2, normal_7) / ((speed == 0.0) ? 1e-30 : speed));
    vec3 p_1 = ((t_7 * direction_17) - toCenter_2);
    bool within_2 = (max(abs(dot(p_1, reciprocalU)), abs(dot(p_1, reciprocalV))) <= 0.500001);
    return ((((t_7 > tMin_3) && (t_7 < 1e30)) && within_2) ? t_7 : 1e30);
}

float hitQuad(uint i_11, Bounds bounds_2, Ray ray_5) {
    Extent _e3 = fetchExtent(i_11);
    float _e14 = intersectQuad(ray_5.start.point, ray_5.direction, bounds_2.center, _e3.a.xyz, _e3.b.xyz, ray_5.start.tMin);
    return ((i_11 == ray_5.start.leaves) ? 1e30 : _e14);
}

float intersectPlane(vec3 origin_8, vec3 direction_18, vec3 normal_4, float offset, float tMin_4) {
    float speed_1 = dot(direction_18, normal_4);
    float t_8 = ((offset - dot(origin_8, normal_4)) / ((speed_1 == 0.0) ? 1e-12 : speed_1));
    float speedAway = ((offset > 0.0) ? speed_1 : -(speed_1));
    bool eitherWay = ((t_8 > tMin_4) && (abs(speed_1) > 1e-12));
    uint _e30 = frame.planesCutView;
    return ((((offset == 0.0) || (_e30 != 0u)) ? eitherWay : (speedAway > 1e-12)) ? max(t_8, 0.0) : 1e30);
}

float hitPlane(uint i_12, Bounds bounds_3, Ray ray_6) {
    float _e10 = intersectPlane(ray_6.start.point, ray_6.direction, bounds_3.center, bounds_3.radius, ray_6.start.tMin);
    return ((i_12 == ray_6.start.leaves) ? 1e30 : _e10);
}

bool occluded(Ray ray_7, float distance_5, uint except) {
    bool blocked = false;
    uint i_13 = 0u;
    uvec4 ends_2 = frame.shapeEnds;
    uint _e10 = i_13;
    if ((_e10 < ends_2.x)) {
        while(true) {
            bool _e13 = blocked;
            uint _e14 = i_13;
            uint _e15 = i_13;
            Bounds _e16 = fetchBounds(_e15);
            float _e17 = hitSphere(_e14, _e16, ray_7);
            uint _e19 = i_13;
            blocked = (_e13 || ((_e17 < distance_5) && (_e19 != except)));
            uint _e24 = i_13;
            i_13 = (_e24 + 1u);
            uint _e26 = i_13;
            if ((_e26 >= ends_2.x)) {
                break;
            }
        }
    }
    uint _e29 = i_13;
    if ((_e29 < ends_2.y)) {
        while(true) {
            bool _e32 = blocked;
            uint _e33 = i_13;
            uint _e34 = i_13;
            Bounds _e35 = fetchBounds(_e34);
            float _e36 = hitBox(_e33, _e35, ray_7);
            uint _e38 = i_13;
            blocked = (_e32 || ((_e36 < distance_5) && (_e38 != except)));
            uint _e43 = i_13;
            i_13 = (_e43 + 1u);
            uint _e45 = i_13;
            if ((_e45 >= ends_2.y)) {
                break;
            }
        }
    }
    uint _e48 = i_13;
    if ((_e48 < ends_2.z)) {
        while(true) {
            bool _e51 = blocked;
            uint _e52 = i_13;
            uint _e53 = i_13;
            Bounds _e54 = fetchBounds(_e53);
            float _e55 = hitQuad(_e52, _e54, ray_7);
            uint _e57 = i_13;
            blocked = (_e51 || ((_e55 < distance_5) && (_e57 != except)));
            uint _e62 = i_13;
            i_13 = (_e62 + 1u);
            uint _e64 = i_13;
            if ((_e64 >= ends_2.z)) {
                break;
            }
        }
    }
    uint _e67 = i_13;
    if ((_e67 < ends_2.w)) {
        while(true) {
            bool _e70 = blocked;
            uint _e71 = i_13;
            uint _e72 = i_13;
            Bounds _e73 = fetchBounds(_e72);
            float _e74 = hitPlane(_e71, _e73, ray_7);
            blocked = (_e70 || (_e74 < distance_5));
            uint _e78 = i_13;
            i_13 = (_e78 + 1u);
            uint _e80 = i_13;
            if ((_e80 >= ends_2.w)) {
                break;
            }
        }
    }
    bool _e83 = blocked;
    return _e83;
}

vec3 sampledLight(Vertex v_7, EmitterChoice choice, vec2 u_14) {
    if ((choice.probability <= 0.0)) {
        return vec3(0.0);
    }
    Emitter _e9 = fetchEmitter(choice.index);
    LightSample _e11 = sampleEmitter(_e9, v_7.point, u_14);
    if ((_e11.pdf <= 0.0)) {
        return vec3(0.0);
    }
    vec3 _e21 = toLocal(v_7.basis, _e11.direction);
    vec4 _e22 = evaluateBsdf(v_7.surface, v_7.wo, _e21);
    if (!(any(greaterThan((_e22.xyz * _e11.radiance), vec3(0.0))))) {
        return vec3(0.0);
    }
    uint shape_2 = ((_e9.shape >= 0.0) ? uint(max(_e9.shape, 0.0)) : noShape);
    Ray _e43 = rayFrom(v_7, _e11.direction);
    bool _e45 = occluded(_e43, _e11.distance_, shape_2);
    if (_e45) {
        return vec3(0.0);
    }
    float pdf_4 = (_e11.pdf * choice.probability);
    bool alone = (_e11.delta || ((_e9.shape < 0.0) && (_e11.distance_ < 1e30)));
    float _e64 = misWeight(pdf_4, _e22.w);
    return ((_e22.xyz * _e11.radiance) * ((alone ? 1.0 : _e64) / pdf_4));
}

float max3_(vec3 v_8) {
    return max(max(v_8.x, v_8.y), v_8.z);
}

Hit nearer(Hit hit_2, float t_1, uint shape_1) {
    return Hit(min(t_1, hit_2.t), ((t_1 < hit_2.t) ? shape_1 : hit_2.shape));
}

Hit closestHit(Ray ray_8) {
    Hit hit_3 = Hit(1e30, 4294967295u);
    uint i_14 = 0u;
    uvec4 ends_3 = frame.shapeEnds;
    uint _e10 = i_14;
    if ((_e10 < ends_3.x)) {
        while(true) {
            Hit _e13 = hit_3;
            uint _e14 = i_14;
            uint _e15 = i_14;
            Bounds _e16 = fetchBounds(_e15);
            float _e17 = hitSphere(_e14, _e16, ray_8);
            uint _e18 = i_14;
            Hit _e19 = nearer(_e13, _e17, _e18);
            hit_3 = _e19;
            uint _e21 = i_14;
            i_14 = (_e21 + 1u);
            uint _e23 = i_14;
            if ((_e23 >= ends_3.x)) {
                break;
            }
        }
    }
    uint _e26 = i_14;
    if ((_e26 < ends_3.y)) {
        while(true) {
            Hit _e29 = hit_3;
            uint _e30 = i_14;
            uint _e31 = i_14;
            Bounds _e32 = fetchBounds(_e31);
            float _e33 = hitBox(_e30, _e32, ray_8);
            uint _e34 = i_14;
            Hit _e35 = nearer(_e29, _e33, _e34);
            hit_3 = _e35;
            uint _e37 = i_14;
            i_14 = (_e37 + 1u);
            uint _e39 = i_14;
            if ((_e39 >= ends_3.y)) {
                break;
            }
        }
    }
    uint _e42 = i_14;
    if ((_e42 < ends_3.z)) {
        while(true) {
            Hit _e45 = hit_3;
            uint _e46 = i_14;
            uint _e47 = i_14;
            Bounds _e48 = fetchBounds(_e47);
            float _e49 = hitQuad(_e46, _e48, ray_8);
            uint _e50 = i_14;
            Hit _e51 = nearer(_e45, _e49, _e50);
            hit_3 = _e51;
            uint _e53 = i_14;
            i_14 = (_e53 + 1u);
            uint _e55 = i_14;
            if ((_e55 >= ends_3.z)) {
                break;
            }
        }
    }
    uint _e58 = i_14;
    if ((_e58 < ends_3.w)) {
        while(true) {
            Hit _e61 = hit_3;
            uint _e62 = i_14;
            uint _e63 = i_14;
            Bounds _e64 = fetchBounds(_e63);
            float _e65 = hitPlane(_e62, _e64, ray_8);
            uint _e66 = i_14;
            Hit _e67 = nearer(_e61, _e65, _e66);
            hit_3 = _e67;
            uint _e69 = i_14;
            i_14 = (_e69 + 1u);
            uint _e71 = i_14;
            if ((_e71 >= ends_3.w)) {
                break;
            }
        }
    }
    Hit _e74 = hit_3;
    return _e74;
}

EmitterChoice chooseEmitter(vec3 point_17, vec3 normal_5, float u_15) {
    float total_1 = 0.0;
    uint chosen = 0u;
    float chosenWeight = 0.0;
    float rest = 0.0;
    uint i_15 = 0u;
    uint _e5 = frame.emitterCount;
    if ((_e5 <= 1u)) {
        uint _e11 = frame.emitterCount;
        return EmitterChoice(0u, float(_e11), 1.0);
    }
    rest = u_15;
    while(true) {
        uint _e24 = i_15;
        Emitter _e25 = fetchEmitter(_e24);
        float _e26 = estimatedIrradiance(_e25, point_17, normal_5);
        float _e27 = total_1;
        total_1 = (_e27 + _e26);
        float _e29 = total_1;
        float share_2 = (_e26 / max(_e29, 1e-37));
        float _e33 = rest;
        bool take = (_e33 < share_2);
        uint _e35 = chosen;
        uint _e36 = i_15;
        chosen = (take ? _e36 : _e35);
        float _e38 = chosenWeight;
        chosenWeight = (take ? _e26 : _e38);
        float _e40 = rest;
        float _e47 = rest;
        rest = (take ? (_e47 / max(share_2, 1e-37)) : ((_e40 - share_2) / max((1.0 - share_2), 1e-7)));
        uint _e53 = i_15;
        i_15 = (_e53 + 1u);
        uint _e55 = i_15;
        uint _e58 = frame.emitterCount;
        if ((_e55 >= _e58)) {
            break;
        }
    }
    uint _e60 = chosen;
    float _e61 = chosenWeight;
    float _e62 = total_1;
    float _e66 = total_1;
    return EmitterChoice(_e60, (_e61 / max(_e62, 1e-37)), _e66);
}

uint scramble(uint x_5, uint seed) {
    uint y_3 = 0u;
    y_3 = (x_5 ^ (x_5 * 1025551850u));
    uint _e6 = y_3;
    y_3 = ((_e6 + seed) * ((seed >> 16u) | 1u));
    uint _e13 = y_3;
    uint _e14 = y_3;
    y_3 = (_e13 ^ (_e14 * 89287766u));
    uint _e18 = y_3;
    uint _e19 = y_3;
    return (_e18 ^ (_e19 * 1403136100u));
}

uint reverseHalves(uint x_6) {
    uint y_4 = 0u;
    y_4 = (((x_6 >> 1u) & 1431655765u) | ((x_6 & 1431655765u) << 1u));
    uint _e11 = y_4;
    uint _e16 = y_4;
    y_4 = (((_e11 >> 2u) & 858993459u) | ((_e16 & 858993459u) << 2u));
    uint _e22 = y_4;
    uint _e27 = y_4;
    y_4 = (((_e22 >> 4u) & 252645135u) | ((_e27 & 252645135u) << 4u));
    uint _e33 = y_4;
    uint _e38 = y_4;
    return (((_e33 >> 8u) & 16711935u) | ((_e38 & 16711935u) << 8u));
}

uint timesW(uint x_7) {
    return (((x_7 ^ (x_7 << 1u)) & 43690u) | ((x_7 >> 1u) & 21845u));
}

uint timesW2_(uint x_8) {
    return (((x_8 << 1u) & 43690u) | ((x_8 ^ (x_8 >> 1u)) & 21845u));
}

uint shiftOfPlace(uint x_9) {
    uint y_5 = 0u;
    uint _e5 = timesW(((x_9 >> 2u) & 51u));
    y_5 = (x_9 ^ _e5);
    uint _e8 = y_5;
    uint _e9 = y_5;
    uint _e14 = timesW2_(((_e9 >> 4u) & 15u));
    y_5 = (_e8 ^ _e14);
    uint _e16 = y_5;
    uint _e17 = timesW(_e16);
    uint _e18 = y_5;
    return (_e17 | (_e18 << 8u));
}

Group nextGroup(inout Sampler s_17) {
    uint _e3 = s_17.key;
    s_17.key = (_e3 + 1u);
    uint _e7 = s_17.key;
    uint _e8 = mixBits(_e7);
    uint _e10 = s_17.salt;
    uint half_1 = ((_e8 ^ _e10) * 2654435761u);
    uint b_6 = (half_1 ^ (half_1 >> 16u));
    uint _e18 = s_17.place;
    uint _e19 = scramble(_e18, b_6);
    uint _e21 = s_17.sample_;
    uint own_2 = (_e21 * ((_e19 >> 7u) & 4294967294u));
    uint _e28 = s_17.sample_;
    uint _e30 = scramble((_e28 ^ own_2), _e8);
    uint _e33 = reverseHalves((_e30 & 65535u));
    uint _e36 = shiftOfPlace((_e19 & 255u));
    return Group(_e33, _e36, ((_e8 >> 16u) | (_e8 << 16u)), ((b_6 >> 16u) | (b_6 << 16u)));
}

float toUnit(uint reversed, uint scrambled) {
    return (float(int(((reversed << 8u) | (scrambled >> 24u)))) * 5.9604645e-8);
}

float next1d(inout Sampler s_18) {
    Group _e1 = nextGroup(s_18);
    uint _e6 = scramble((_e1.index ^ _e1.shift), _e1.seedA);
    uint _e9 = reverseHalves((_e6 & 65535u));
    float _e10 = toUnit(_e9, _e6);
    return _e10;
}

uint pascal(uint x_10) {
    uint y_6 = 0u;
    y_6 = (x_10 ^ ((x_10 >> 1u) & 21845u));
    uint _e7 = y_6;
    uint _e8 = y_6;
    y_6 = (_e7 ^ ((_e8 >> 2u) & 13107u));
    uint _e14 = y_6;
    uint _e15 = y_6;
    y_6 = (_e14 ^ ((_e15 >> 4u) & 3855u));
    uint _e21 = y_6;
    uint _e22 = y_6;
    return (_e21 ^ ((_e22 >> 8u) & 255u));
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

vec2 next2d(inout Sampler s_19) {
    Group _e1 = nextGroup(s_19);
    vec2 _e2 = points2d(_e1);
    return _e2;
}

bool isDelta(Surface s_20) {
    uint _e1 = kindOf(s_20);
    bool noDiffuse = ((_e1 >= conductor) || ((_e1 == metallicRoughness) && (s_20.metallic >= 1.0)));
    bool _e14 = hasSmoothLobe(s_20);
    return ((s_20.reflectivity >= 1.0) || (noDiffuse && _e14));
}

BsdfSample deltaSample(vec3 direction_19, float probability, vec3 weight) {
    return BsdfSample(direction_19, probability, weight, true);
}

vec3 mirrored(vec3 wo_3) {
    return vec3(-(wo_3.xy), wo_3.z);
}

vec3 sampleCosine(vec2 u_16) {
    float radius_1 = sqrt(u_16.x);
    float phi_2 = ((6.2831855 * u_16.y) - 3.1415927);
    return normalize(vec3((radius_1 * cos(phi_2)), (radius_1 * sin(phi_2)), sqrt((1.0 - u_16.x))));
}

vec3 sampleVisibleNormal(vec3 wo_4, float alpha_4, float bound, vec2 u_17) {
    float _e8 = stretched(wo_4, alpha_4);
    vec3 w_2 = (vec3((alpha_4 * wo_4.xy), wo_4.z) / vec3(_e8));
    float phi_3 = ((6.2831855 * u_17.x) - 3.1415927);
    float drop = (u_17.y * (1.0 + (bound * w_2.z)));
    float sine_6 = sqrt(max((drop * (2.0 - drop)), 0.0));
    vec3 h_6 = (w_2 + vec3((sine_6 * cos(phi_3)), (sine_6 * sin(phi_3)), (1.0 - drop)));
    return normalize(vec3((alpha_4 * h_6.xy), max(h_6.z, 1e-7)));
}

vec3 sampleFacet(Surface s_21, vec3 wo_5, vec2 u_18) {
    float side_3 = ((wo_5.z < 0.0) ? -1.0 : 1.0);
    vec3 up = (wo_5 * side_3);
    float _e11 = reflectionBound(up, s_21.alpha);
    uint _e12 = kindOf(s_21);
    float bound_2 = ((_e12 == dielectric) ? 1.0 : _e11);
    vec3 _e20 = sampleVisibleNormal(up, max(s_21.alpha, 0.001), bound_2, u_18);
    bool _e25 = hasSmoothLobe(s_21);
    return ((_e25 ? vec3(0.0, 0.0, 1.0) : _e20) * side_3);
}

vec3 refracted(vec3 wo_6, vec3 h_2, float ratio_3) {
    float cosine_14 = dot(wo_6, h_2);
    float inside_3 = sqrt(max((((ratio_3 - 1.0) * (ratio_3 + 1.0)) + (cosine_14 * cosine_14)), 0.0));
    return ((((cosine_14 - inside_3) * h_2) - wo_6) / vec3(ratio_3));
}

BsdfSample sampleBsdf(Surface s_22, vec3 wo_7, vec3 u_19) {
    vec3 wi_2 = vec3(0.0);
    bool crossing = false;
    if ((u_19.z < s_22.reflectivity)) {
        vec3 _e6 = mirrored(wo_7);
        BsdfSample _e10 = deltaSample(_e6, s_22.reflectivity, vec3(1.0));
        return _e10;
    }
    float base_1 = (1.0 - s_22.reflectivity);
    float choice_1 = ((u_19.z - s_22.reflectivity) / base_1);
    float _e19 = facetShare(s_22, wo_7.z);
    uint _e20 = kindOf(s_22);
    bool isGlass_1 = (_e20 == dielectric);
    bool specular_1 = (choice_1 < _e19);
    vec3 _e25 = sampleCosine(u_19.xy);
    wi_2 = _e25;
    if (specular_1) {
        vec3 _e30 = sampleFacet(s_22, wo_7, u_19.xy);
        float oh_1 = max(dot(wo_7, _e30), 0.0);
        float _e35 = indexRatio(s_22, wo_7.z);
        vec3 _e36 = facetReflectance(s_22, oh_1, _e35);
        crossing = (isGlass_1 && (choice_1 >= _e36.x));
        vec3 _e40 = refracted(wo_7, _e30, _e35);
        bool _e42 = isThin(s_22);
        vec3 through = (_e42 ? -(wo_7) : _e40);
        bool _e48 = crossing;
        wi_2 = (_e48 ? through : (((2.0 * oh_1) * _e30) - wo_7));
        bool _e50 = hasSmoothLobe(s_22);
        if (_e50) {
            bool _e54 = crossing;
            bool _e55 = isThin(s_22);
            float bent = ((_e54 && !(_e55)) ? (1.0 / (_e35 * _e35)) : 1.0);
            bool _e64 = crossing;
            float probability_1 = (base_1 * (isGlass_1 ? (_e64 ? (1.0 - _e36.x) : _e36.x) : _e19));
            vec3 _e68 = wi_2;
            BsdfSample _e73 = deltaSample(_e68, probability_1, (isGlass_1 ? vec3(bent) : (_e36 / vec3(_e19))));
            return _e73;
        }
    }
    vec3 _e74 = wi_2;
    vec4 _e75 = evaluateBsdf(s_22, wo_7, _e74);
    float _e80 = wi_2.z;
    bool crosses = ((wo_7.z < 0.0) != (_e80 < 0.0));
    bool _e85 = crossing;
    float pdf_5 = ((_e85 != crosses) ? 0.0 : _e75.w);
    vec3 _e89 = wi_2;
    return BsdfSample(_e89, pdf_5, ((pdf_5 > 0.0) ? (_e75.xyz / vec3(max(pdf_5, 1e-30))) : vec3(0.0)), false);
}

uint pascalW2_(uint x_11) {
    uint y_7 = 0u;
    uint _e5 = timesW2_(((x_11 >> 2u) & 13107u));
    y_7 = (x_11 ^ _e5);
    uint _e8 = y_7;
    uint _e9 = y_7;
    uint _e14 = timesW(((_e9 >> 4u) & 3855u));
    y_7 = (_e8 ^ _e14);
    uint _e16 = y_7;
    uint _e17 = y_7;
    uint _e22 = timesW2_(((_e17 >> 8u) & 255u));
    return (_e16 ^ _e22);
}

vec3 next3d(inout Sampler s_23) {
    Group _e1 = nextGroup(s_23);
    uint _e4 = timesW2_(_e1.shift);
    uint _e6 = pascalW2_((_e1.index ^ _e4));
    uint _e12 = scramble(_e6, (_e1.seedA ^ (_e1.seedB * 2654435761u)));
    vec2 _e13 = points2d(_e1);
    uint _e16 = reverseHalves((_e12 & 65535u));
    float _e17 = toUnit(_e16, _e12);
    return vec3(_e13, _e17);
}

vec3 toWorld(Basis b_3, vec3 v_9) {
    return (((v_9.x * b_3.tangent) + (v_9.y * b_3.bitangent)) + (v_9.z * b_3.normal));
}

vec3 trace(Ray first, inout Sampler s_24) {
    Ray ray_9 = Ray(Start(vec3(0.0), 0u, 0u, 0.0), vec3(0.0));
    Origin origin_9 = Origin(vec3(0.0), vec3(0.0), 0.0, 1.0);
    vec3 throughput = vec3(1.0);
    vec3 radiance = vec3(0.0);
    uint depth = 1u;
    ray_9 = first;
    while(true) {
        Ray _e19 = ray_9;
        Hit _e20 = closestHit(_e19);
        bool escaped_1 = (_e20.shape == noShape);
        Ray _e24 = ray_9;
        Vertex _e30 = vertexAt(_e24, Hit(_e20.t, (escaped_1 ? 0u : _e20.shape)));
        bool _e32 = isDielectric(_e30.surface);
        bool _e34 = isThin(_e30.surface);
        bool inside_4 = ((_e32 && !(_e34)) && (_e30.wo.z < 0.0));
        vec3 _e42 = throughput;
        vec3 passed = (_e42 * exp((-(_e30.surface.absorption) * (inside_4 ? _e20.t : 0.0))));
        vec3 _e52 = throughput;
        throughput = ((inside_4 && !(escaped_1)) ? passed : _e52);
        vec3 _e56 = radiance;
        vec3 _e57 = throughput;
        Origin _e58 = origin_9;
        Ray _e59 = ray_9;
        vec3 _e60 = foundLight(_e30, _e58, _e59, _e20);
        radiance = (_e56 + (_e57 * _e60));
        uint _e63 = depth;
        uint _e66 = frame.maxDepth;
        if ((escaped_1 || (_e63 == _e66))) {
            break;
        }
        vec3 _e70 = litSide(_e30);
        float _e71 = next1d(s_24);
        EmitterChoice _e72 = chooseEmitter(_e30.point, _e70, _e71);
        vec2 _e73 = next2d(s_24);
        bool _e75 = isDelta(_e30.surface);
        if (!(_e75)) {
            vec3 _e77 = radiance;
            vec3 _e78 = throughput;
            vec3 _e79 = sampledLight(_e30, _e72, _e73);
            radiance = (_e77 + (_e78 * _e79));
        }
        vec3 _e84 = next3d(s_24);
        BsdfSample _e85 = sampleBsdf(_e30.surface, _e30.wo, _e84);
        vec3 _e86 = throughput;
        throughput = (_e86 * _e85.weight);
        vec3 _e91 = toWorld(_e30.basis, _e85.direction);
        vec3 _e93 = litSide(_e30);
        origin_9 = Origin(_e30.point, _e93, (_e85.delta ? 0.0 : _e85.pdf), _e72.total);
        Ray _e100 = rayFrom(_e30, _e91);
        ray_9 = _e100;
        vec3 _e101 = throughput;
        float _e102 = max3_(_e101);
        uint _e105 = depth;
        float survival = ((_e105 < rouletteDepth) ? 1.0 : min(_e102, 0.95));
        float _e110 = next1d(s_24);
        vec3 _e114 = throughput;
        float _e115 = max3_(_e114);
        if ((((_e85.pdf <= 0.0) || (_e115 <= 0.0)) || (_e110 >= survival))) {
            break;
        }
        vec3 _e121 = throughput;
        throughput = (_e121 / vec3(survival));
        uint _e125 = depth;
        depth = (_e125 + 1u);
    }
    vec3 _e127 = radiance;
    return _e127;
}

uint pcg(uint x_12) {
    uint s_28 = ((x_12 * 747796405u) + 2891336453u);
    uint w_3 = (((s_28 >> ((s_28 >> 28u) + 4u)) ^ s_28) * 277803737u);
    return ((w_3 >> 22u) ^ w_3);
}

uint pixelHash(uvec2 pixel, uint sampleIndex, uint seed_1) {
    uint _e5 = pcg(seed_1);
    uint _e7 = pcg((sampleIndex + _e5));
    uint _e9 = pcg((pixel.y + _e7));
    uint _e11 = pcg((pixel.x + _e9));
    return _e11;
}

uint spread0_(uint x_13) {
    uint y_11 = ((x_13 | (x_13 << 2u)) & 51u);
    return ((y_11 | (y_11 << 1u)) & 85u);
}

Sampler startSampler(uvec2 pixel_1, uint sampleIndex_1, uint seed_2) {
    uint _e5 = frame.independent;
    bool independent = (_e5 != 0u);
    uint _e15 = pixelHash((independent ? pixel_1 : (pixel_1 >> uvec2(4u))), (independent ? sampleIndex_1 : (sampleIndex_1 >> 16u)), seed_2);
    uint _e19 = spread0_((pixel_1.x & 15u));
    uint _e23 = spread0_((pixel_1.y & 15u));
    uint place = (_e19 | (_e23 << 1u));
    uint _e32 = reverseHalves(((sampleIndex_1 & 65535u) | (place << 24u)));
    uint used = (independent ? 0u : _e32);
    uint _e37 = mixBits((_e15 ^ 1779033703u));
    return Sampler(_e15, _e37, (used & 65535u), (used >> 16u));
}

float filterAxis(float u_20) {
    float across_4 = ((2.0 * u_20) - 1.0);
    float x_18 = (16.0 - (16.0 * sqrt((1.0 - abs(across_4)))));
    float piece = min(floor(x_18), 15.0);
    float t_9 = (x_18 - piece);
    vec4 c = frame.filterPieces[uint(piece)];
    float offset_1 = (c.x + (t_9 * (c.y + (t_9 * (c.z + (t_9 * c.w))))));
    return ((across_4 < 0.0) ? -(offset_1) : offset_1);
}

vec2 filterOffset(vec2 u_21) {
    float _e2 = filterAxis(u_21.x);
    float _e4 = filterAxis(u_21.y);
    return vec2(_e2, _e4);
}

CameraRay rayThroughLens(vec2 filmPosition, vec2 lensPoint) {
    CameraRay ray_10 = CameraRay(vec3(0.0), vec3(0.0));
    float _e7 = frame.width;
    float x_19 = (((2.0 * filmPosition.x) / _e7) - 1.0);
    float _e16 = frame.height;
    float y_12 = (1.0 - ((2.0 * filmPosition.y) / _e16));
    vec3 _e22 = frame.right;
    vec3 _e26 = frame.up;
    vec3 across_5 = ((x_19 * _e22) + (y_12 * _e26));
    uint _e31 = frame.projection;
    bool orthographic = (_e31 == 1u);
    vec3 _e36 = frame.forward;
    vec3 _e40 = frame.forward;
    vec3 ahead = (orthographic ? _e40 : (_e36 + across_5));
    float _e44 = frame.aperture;
    vec3 _e48 = frame.right;
    vec3 _e54 = frame.up;
    vec3 lens_1 = (_e44 * ((lensPoint.x * normalize(_e48)) + (lensPoint.y * normalize(_e54))));
    float _e63 = frame.focusDistance;
    ray_10 = CameraRay((orthographic ? (across_5 + lens_1) : lens_1), normalize((ahead - (lens_1 / vec3(_e63)))));
    uint _e72 = frame.projection;
    if ((_e72 == 2u)) {
        float longitude = (3.1415927 * x_19);
        float latitude = (1.5707964 * y_12);
        vec3 _e82 = frame.right;
        vec3 _e87 = frame.forward;
        vec3 level = ((sin(longitude) * _e82) + (cos(longitude) * _e87));
        vec3 _e97 = frame.up;
        ray_10 = CameraRay(vec3(0.0), normalize(((cos(latitude) * level) + (sin(latitude) * _e97))));
    }
    CameraRay _e102 = ray_10;
    return _e102;
}

vec2 concentricDisc(vec2 u_22) {
    vec2 p_2 = ((2.0 * u_22) - vec2(1.0));
    bool wide = (abs(p_2.x) > abs(p_2.y));
    float radius_2 = (wide ? p_2.x : p_2.y);
    float ratio_5 = ((wide ? p_2.y : p_2.x) / ((radius_2 == 0.0) ? 1.0 : radius_2));
    float angle_1 = (wide ? (0.7853982 * ratio_5) : (1.5707964 - (0.7853982 * ratio_5)));
    return (radius_2 * vec2(cos(angle_1), sin(angle_1)));
}

CameraRay cameraRay(vec2 filmPosition_1, vec2 lens) {
    vec2 _e2 = concentricDisc(lens);
    CameraRay _e3 = rayThroughLens(filmPosition_1, _e2);
    return _e3;
}

Start onCamera(vec3 point_18) {
    return Start(point_18, noShape, noShape, 0.0);
}

void main() {
    vec4 fragment = gl_FragCoord;
    Sampler s = Sampler(0u, 0u, 0u, 0u);
    Film film = Film(vec4(0.0), vec4(0.0));
    uvec2 pixel_2 = uvec2(fragment.xy);
    uint _e5 = frame.sampleIndex;
    uint _e8 = frame.seed;
    Sampler _e9 = startSampler(pixel_2, _e5, _e8);
    s = _e9;
    vec2 _e16 = next2d(s);
    vec2 _e17 = filterOffset(_e16);
    vec2 filmPosition_2 = ((floor(fragment.xy) + vec2(0.5)) + _e17);
    vec2 _e19 = next2d(s);
    CameraRay _e20 = cameraRay(filmPosition_2, _e19);
    Start _e22 = onCamera(_e20.origin);
    vec3 _e25 = trace(Ray(_e22, _e20.direction), s);
    uint _e34 = frame.sampleIndex;
    if ((_e34 > 0u)) {
        vec4 _e39 = texelFetch(previousFilm, ivec2(pixel_2), 0);
        vec4 _e42 = texelFetch(previousSquares, ivec2(pixel_2), 0);
        film = Film(_e39, _e42);
    }
    vec4 _e45 = film.sums;
    vec4 _e50 = film.squares;
    Film _tmp_return = Film((_e45 + vec4(_e25, 1.0)), (_e50 + vec4((_e25 * _e25), 0.0)));
    _fs2p_location0 = _tmp_return.sums;
    _fs2p_location1 = _tmp_return.squares;
    return;
}

