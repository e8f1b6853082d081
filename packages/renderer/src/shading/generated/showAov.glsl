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

struct AovView {
    uint kind;
    float scale;
    vec2 filmSize;
    vec3 forward;
    vec3 middle;
};
struct ScreenPoint {
    vec4 position;
    vec2 uv;
};
layout(std140) uniform AovViewBlock { AovView view; };

uniform highp sampler2D film;

uniform highp sampler2D numberColors;

smooth in vec2 _vs2fs_location0;
layout(location = 0) out vec4 _fs2p_location0;

float depthShade(vec3 place) {
    vec3 _e3 = view.forward;
    vec3 _e8 = view.forward;
    float depth = pick(all(equal(_e8, vec3(0.0))), length(place), dot(place, _e3));
    float _e16 = view.scale;
    float _e19 = view.scale;
    return (_e16 / (_e19 + max(depth, 0.0)));
}

vec3 placeColor(vec3 place_1) {
    vec3 _e3 = view.middle;
    float _e7 = view.scale;
    vec3 p = ((place_1 - _e3) / vec3(_e7));
    return (vec3(0.5) + ((0.5 * p) / (vec3(1.0) + abs(p))));
}

vec3 srgb(vec3 c) {
    vec3 r2_ = sqrt(c);
    vec3 r4_ = sqrt(r2_);
    vec3 r8_ = sqrt(r4_);
    vec3 curve = ((((0.6620027 * r2_) + (0.6841221 * r4_)) - (0.3235836 * r8_)) - (0.022541147 * c));
    return mix(curve, (12.92 * c), lessThanEqual(c, vec3(0.0031308)));
}

void main() {
    ScreenPoint point = ScreenPoint(gl_FragCoord, _vs2fs_location0);
    vec3 color = vec3(0.0);
    vec2 _e4 = view.filmSize;
    vec2 _e11 = view.filmSize;
    vec2 texel = clamp(floor((point.uv * _e4)), vec2(0.0), (_e11 - vec2(1.0)));
    vec4 value = texelFetch(film, ivec2(texel), 0);
    uint _e25 = view.kind;
    if ((_e25 == 0u)) {
        vec3 _e39 = srgb(clamp((value.xyz / vec3(max(value.w, 1.0))), vec3(0.0), vec3(1.0)));
        color = _e39;
    } else {
        uint _e42 = view.kind;
        if ((_e42 == 1u)) {
            float size = length(value.xyz);
            color = pick((size > 0.0), (vec3(0.5) + ((0.5 * value.xyz) / vec3(max(size, 1e-20)))), vec3(0.0));
        } else {
            if ((value.w > 0.0)) {
                uint _e67 = view.kind;
                if ((_e67 == 2u)) {
                    float _e71 = depthShade(value.xyz);
                    color = vec3(_e71);
                } else {
                    uint _e75 = view.kind;
                    if ((_e75 == 3u)) {
                        vec3 _e79 = placeColor(value.xyz);
                        color = _e79;
                    } else {
                        vec4 _e86 = texelFetch(numberColors, ivec2(int(value.w), 0), 0);
                        color = _e86.xyz;
                    }
                }
            }
        }
    }
    vec3 _e88 = color;
    _fs2p_location0 = vec4(_e88, 1.0);
    return;
}

