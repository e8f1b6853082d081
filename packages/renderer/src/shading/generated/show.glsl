#version 300 es

precision highp float;
precision highp int;

struct Display {
    float exposure;
    float spare;
    vec2 filmSize;
};
struct ScreenPoint {
    vec4 position;
    vec2 uv;
};
layout(std140) uniform DisplayBlock { Display display; };

uniform highp sampler2D film;

smooth in vec2 _vs2fs_location0;
layout(location = 0) out vec4 _fs2p_location0;

vec3 mean(vec2 texel) {
    vec2 _e6 = display.filmSize;
    vec4 sum = texelFetch(film, ivec2(clamp(texel, vec2(0.0), (_e6 - vec2(1.0)))), 0);
    return (sum.xyz / vec3(max(sum.w, 1.0)));
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

void main() {
    ScreenPoint point = ScreenPoint(gl_FragCoord, _vs2fs_location0);
    vec2 _e4 = display.filmSize;
    vec2 at = ((point.uv * _e4) - vec2(0.5));
    vec2 corner = floor(at);
    vec2 f = (at - corner);
    if (all(greaterThan(abs((f - vec2(0.5))), vec2(0.499)))) {
        vec3 _e23 = shown(floor((at + vec2(0.5))));
        vec3 _e24 = srgb(_e23);
        _fs2p_location0 = vec4(_e24, 1.0);
        return;
    }
    vec3 _e27 = shown(corner);
    vec3 _e32 = shown((corner + vec2(1.0, 0.0)));
    vec3 upper = mix(_e27, _e32, f.x);
    vec3 _e39 = shown((corner + vec2(0.0, 1.0)));
    vec3 _e44 = shown((corner + vec2(1.0, 1.0)));
    vec3 lower = mix(_e39, _e44, f.x);
    vec3 _e49 = srgb(mix(upper, lower, f.y));
    _fs2p_location0 = vec4(_e49, 1.0);
    return;
}

