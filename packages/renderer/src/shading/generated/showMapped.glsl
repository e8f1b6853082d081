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

struct Display {
    float exposure;
    uint toneMapping;
    vec2 filmSize;
};
struct ScreenPoint {
    vec4 position;
    vec2 uv;
};
const mat3x3 rrtInput = mat3x3(vec3(0.59719, 0.076, 0.0284), vec3(0.35458, 0.90834, 0.13383), vec3(0.04823, 0.01566, 0.83777));
const mat3x3 rrtOutput = mat3x3(vec3(1.60475, -0.10208, -0.00327), vec3(-0.53108, 1.10813, -0.07276), vec3(-0.07367, -0.00605, 1.07602));
const mat3x3 agxInset = mat3x3(vec3(0.85662717, 0.13731897, 0.11189821), vec3(0.09512124, 0.761242, 0.076799415), vec3(0.048251607, 0.10143904, 0.81130236));
const mat3x3 rec709ToRec2020_ = mat3x3(vec3(0.6274, 0.0691, 0.0164), vec3(0.3293, 0.9195, 0.088), vec3(0.0433, 0.0113, 0.8956));
const mat3x3 rec2020ToRec709_ = mat3x3(vec3(1.6605, -0.1246, -0.0182), vec3(-0.5876, 1.1329, -0.1006), vec3(-0.0728, -0.0083, 1.1187));
const mat3x3 agxOutset = mat3x3(vec3(1.1271006, -0.14132977, -0.14132977), vec3(-0.11060664, 1.1578237, -0.11060664), vec3(-0.016493939, -0.016493939, 1.2519364));

layout(std140) uniform DisplayBlock { Display display; };

uniform highp sampler2D film;

smooth in vec2 _vs2fs_location0;
layout(location = 0) out vec4 _fs2p_location0;

vec3 mean(vec2 texel) {
    vec2 _e6 = display.filmSize;
    vec4 sum_1 = texelFetch(film, ivec2(clamp(texel, vec2(0.0), (_e6 - vec2(1.0)))), 0);
    return (sum_1.xyz / vec3(max(sum_1.w, 1.0)));
}

vec3 srgb(vec3 c) {
    vec3 r2_ = sqrt(c);
    vec3 r4_ = sqrt(r2_);
    vec3 r8_ = sqrt(r4_);
    vec3 curve = ((((0.6620027 * r2_) + (0.6841221 * r4_)) - (0.3235836 * r8_)) - (0.022541147 * c));
    return mix(curve, (12.92 * c), lessThanEqual(c, vec3(0.0031308)));
}

vec3 shown(vec2 texel_1) {
    vec3 _e1 = mean(texel_1);
    float _e4 = display.exposure;
    return clamp((_e1 * _e4), vec3(0.0), vec3(1.0));
}

vec3 aces(vec3 color) {
    vec3 v = (rrtInput * (color / vec3(0.6)));
    return (rrtOutput * (((v * (v + vec3(0.0245786))) - vec3(9.0537e-5)) / ((v * ((0.983729 * v) + vec3(0.432951))) + vec3(0.238081))));
}

vec3 agx(vec3 color_1) {
    vec3 stops = log2(max((agxInset * (rec709ToRec2020_ * color_1)), vec3(1e-10)));
    vec3 x = clamp(((stops - vec3(-12.47393)) / vec3(16.499998)), vec3(0.0), vec3(1.0));
    vec3 x2_ = (x * x);
    vec3 x4_ = (x2_ * x2_);
    vec3 curve_1 = ((((((((15.5 * x4_) * x2_) - ((40.14 * x4_) * x)) + (31.96 * x4_)) - ((6.868 * x2_) * x)) + (0.4298 * x2_)) + (0.1191 * x)) - vec3(0.00232));
    return (rec2020ToRec709_ * pow(max((agxOutset * curve_1), vec3(0.0)), vec3(2.2)));
}

vec3 neutral(vec3 color_2) {
    float x_1 = min(color_2.x, min(color_2.y, color_2.z));
    vec3 lifted = (color_2 - vec3(pick((x_1 <= 0.08), (x_1 - ((x_1 * x_1) / 0.16)), 0.04)));
    float peak = max(max(lifted.x, max(lifted.y, lifted.z)), 0.76);
    float newPeak = (1.0 - ((0.24 * 0.24) / ((peak + 1.0) - 1.52)));
    float kept = (1.0 / ((0.15 * (peak - newPeak)) + 1.0));
    return mix(vec3(newPeak), (lifted * (newPeak / peak)), kept);
}

vec3 toneMap(vec3 color_3, uint kind) {
    vec3 mapped = vec3(0.0);
    vec3 c_1 = clamp(color_3, vec3(0.0), vec3(1000000.0));
    mapped = c_1;
    if ((kind == 1u)) {
        vec3 _e10 = aces(c_1);
        mapped = _e10;
    }
    if ((kind == 2u)) {
        vec3 _e13 = agx(c_1);
        mapped = _e13;
    }
    if ((kind == 3u)) {
        vec3 _e16 = neutral(c_1);
        mapped = _e16;
    }
    vec3 _e17 = mapped;
    return clamp(_e17, vec3(0.0), vec3(1.0));
}

void main() {
    ScreenPoint point_1 = ScreenPoint(gl_FragCoord, _vs2fs_location0);
    vec3 sum = vec3(0.0);
    uint tap = 0u;
    vec2 _e4 = display.filmSize;
    vec2 at = ((point_1.uv * _e4) - vec2(0.5));
    vec2 corner = floor(at);
    vec2 f = (at - corner);
    bool exact = all(greaterThan(abs((f - vec2(0.5))), vec2(0.499)));
    vec2 first = pick(exact, floor((at + vec2(0.5))), corner);
    uint taps = pick(exact, 1u, 4u);
    while(true) {
        uint _e32 = tap;
        uint _e36 = tap;
        vec2 step_ = vec2(float((_e32 & 1u)), float((_e36 >> 1u)));
        vec2 share = mix((vec2(1.0) - f), f, step_);
        vec3 _e45 = sum;
        vec3 _e52 = mean((first + step_));
        float _e55 = display.exposure;
        uint _e59 = display.toneMapping;
        vec3 _e60 = toneMap((_e52 * _e55), _e59);
        sum = (_e45 + (pick(exact, 1.0, (share.x * share.y)) * _e60));
        uint _e64 = tap;
        tap = (_e64 + 1u);
        uint _e66 = tap;
        if ((_e66 >= taps)) {
            break;
        }
    }
    vec3 _e68 = sum;
    vec3 _e69 = srgb(_e68);
    _fs2p_location0 = vec4(_e69, 1.0);
    return;
}

