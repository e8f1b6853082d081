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
    uint farEmitters;
    uint lightTree;
    float rowHeight;
    float geometryShare;
    float texelShare;
    uint lightTreeDepth;
    uint lampTables;
    uvec2 origin;
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
layout(std140) uniform FrameBlock { Frame frame; };

const bool hasFilter = false;

layout(location = 0) out vec4 _fs2p_location0;

uint pcg(uint x) {
    uint s_5 = ((x * 747796405u) + 2891336453u);
    uint w = (((s_5 >> ((s_5 >> 28u) + 4u)) ^ s_5) * 277803737u);
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
    uint y_6 = ((x_1 | (x_1 * 4u)) & 51u);
    return ((y_6 | (y_6 * 2u)) & 85u);
}

uint reversedHigh(uint x_2) {
    uint y = 0u;
    y = (x_2 + ((x_2 & 21845u) * 3u));
    uint _e7 = y;
    uint _e8 = y;
    y = (_e7 + ((_e8 & 26214u) * 15u));
    uint _e14 = y;
    uint _e15 = y;
    y = (_e14 + ((_e15 & 30840u) * 255u));
    uint _e21 = y;
    uint _e22 = y;
    return (_e21 + ((_e22 & 32640u) * 65535u));
}

uint reversed(uint x_3) {
    uint _e1 = reversedHigh(x_3);
    return (_e1 >> 15u);
}

uint mixBits(uint x_4) {
    uint y_1 = 0u;
    y_1 = ((x_4 ^ (x_4 >> 16u)) * 569420461u);
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
    uint place = (_e19 | (_e23 * 2u));
    uint _e29 = reversed((sampleIndex_1 & 65535u));
    uint sample_ = pick(independent, 0u, _e29);
    uint _e34 = mixBits((_e15 ^ 1779033703u));
    uint _e37 = reversed((place * 256u));
    return Sampler(_e15, _e34, sample_, pick(independent, 0u, _e37));
}

float filterAxis(float u) {
    float across = ((2.0 * u) - 1.0);
    float x_11 = (16.0 - (16.0 * sqrt((1.0 - abs(across)))));
    float piece = min(floor(x_11), 15.0);
    float t = (x_11 - piece);
    vec4 c = frame.filterPieces[uint(piece)];
    float offset_1 = (c.x + (t * (c.y + (t * (c.z + (t * c.w))))));
    return pick((across < 0.0), -(offset_1), offset_1);
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

float toUnit(uint scrambled) {
    uint _e3 = reversedHigh((scrambled & 65535u));
    float digits = (float(int(_e3)) * 4.656613e-10);
    return (digits + (float((scrambled & 4278190080u)) * 3.5527137e-15));
}

uint scramble(uint x_5, uint seed_2) {
    uint y_2 = 0u;
    y_2 = (x_5 ^ (x_5 * 1025551850u));
    uint _e6 = y_2;
    y_2 = ((_e6 + seed_2) * ((seed_2 >> 16u) | 1u));
    uint _e13 = y_2;
    uint _e14 = y_2;
    y_2 = (_e13 ^ (_e14 * 89287766u));
    uint _e18 = y_2;
    uint _e19 = y_2;
    return (_e18 ^ (_e19 * 1403136100u));
}

uint pascal(uint x_6) {
    uint y_3 = 0u;
    y_3 = (x_6 ^ ((x_6 >> 1u) & 21845u));
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

uint timesW(uint x_7) {
    return (((x_7 ^ (x_7 * 2u)) & 43690u) | ((x_7 >> 1u) & 21845u));
}

vec2 points2d(Group g) {
    uint _e5 = scramble((g.index ^ g.shift), g.seedA);
    float _e6 = toUnit(_e5);
    uint _e9 = timesW(g.shift);
    uint _e11 = pascal((g.index ^ _e9));
    uint _e13 = scramble(_e11, g.seedB);
    float _e14 = toUnit(_e13);
    return vec2(_e6, _e14);
}

uint timesW2_(uint x_8) {
    return (((x_8 * 2u) & 43690u) | ((x_8 ^ (x_8 >> 1u)) & 21845u));
}

uint shiftOfPlace(uint x_9) {
    uint y_4 = 0u;
    uint _e5 = timesW(((x_9 >> 2u) & 51u));
    y_4 = (x_9 ^ _e5);
    uint _e8 = y_4;
    uint _e9 = y_4;
    uint _e14 = timesW2_(((_e9 >> 4u) & 15u));
    y_4 = (_e8 ^ _e14);
    uint _e16 = y_4;
    uint _e17 = timesW(_e16);
    uint _e18 = y_4;
    return (_e17 | (_e18 * 256u));
}

Group nextGroup(inout Sampler s_1) {
    uint _e3 = s_1.key;
    s_1.key = (_e3 + 1u);
    uint _e7 = s_1.key;
    uint _e8 = mixBits(_e7);
    uint _e10 = s_1.salt;
    uint half_ = ((_e8 ^ _e10) * 2654435761u);
    uint b = (half_ ^ (half_ >> 16u));
    uint _e18 = s_1.place;
    uint _e19 = scramble(_e18, b);
    uint _e21 = s_1.sample_;
    uint own = (_e21 * ((_e19 >> 7u) & 4294967294u));
    uint _e28 = s_1.sample_;
    uint _e30 = scramble((_e28 ^ own), _e8);
    uint _e33 = reversed((_e30 & 65535u));
    uint _e36 = shiftOfPlace((_e19 & 255u));
    return Group(_e33, _e36, ((_e8 >> 16u) | (_e8 * 65536u)), ((b >> 16u) | (b * 65536u)));
}

vec2 next2d(inout Sampler s_2) {
    Group _e1 = nextGroup(s_2);
    vec2 _e2 = points2d(_e1);
    return _e2;
}

float next1d(inout Sampler s_3) {
    Group _e1 = nextGroup(s_3);
    uint _e6 = scramble((_e1.index ^ _e1.shift), _e1.seedA);
    float _e7 = toUnit(_e6);
    return _e7;
}

uint pascalW2_(uint x_10) {
    uint y_5 = 0u;
    uint _e5 = timesW2_(((x_10 >> 2u) & 13107u));
    y_5 = (x_10 ^ _e5);
    uint _e8 = y_5;
    uint _e9 = y_5;
    uint _e14 = timesW(((_e9 >> 4u) & 3855u));
    y_5 = (_e8 ^ _e14);
    uint _e16 = y_5;
    uint _e17 = y_5;
    uint _e22 = timesW2_(((_e17 >> 8u) & 255u));
    return (_e16 ^ _e22);
}

vec3 next3d(inout Sampler s_4) {
    Group _e1 = nextGroup(s_4);
    uint _e4 = timesW2_(_e1.shift);
    uint _e6 = pascalW2_((_e1.index ^ _e4));
    uint _e12 = scramble(_e6, (_e1.seedA ^ (_e1.seedB * 2654435761u)));
    vec2 _e13 = points2d(_e1);
    float _e14 = toUnit(_e12);
    return vec3(_e13, _e14);
}

void main() {
    vec4 fragment = gl_FragCoord;
    Sampler s = Sampler(0u, 0u, 0u, 0u);
    uvec4 order = frame.panels[0];
    uint _e11 = frame.sampleIndex;
    uint _e14 = frame.seed;
    Sampler _e15 = startSampler((uvec2(fragment.xy) + order.zw), _e11, _e14);
    s = _e15;
    uint _e18 = s.key;
    s.key = (_e18 + order.x);
    if ((order.y == 0u)) {
        vec2 _e24 = next2d(s);
        vec2 _e25 = filterOffset(_e24);
        _fs2p_location0 = vec4(_e25, 0.0, 0.0);
        return;
    }
    if ((order.y == 1u)) {
        float _e32 = next1d(s);
        _fs2p_location0 = vec4(_e32, 0.0, 0.0, 0.0);
        return;
    }
    if ((order.y == 2u)) {
        vec2 _e40 = next2d(s);
        _fs2p_location0 = vec4(_e40, 0.0, 0.0);
        return;
    }
    vec3 _e44 = next3d(s);
    _fs2p_location0 = vec4(_e44, 0.0);
    return;
}

