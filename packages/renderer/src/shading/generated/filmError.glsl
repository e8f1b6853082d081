#version 300 es

precision highp float;
precision highp int;

struct Display {
    float exposure;
    uint toneMapping;
    vec2 filmSize;
};
layout(std140) uniform DisplayBlock { Display display; };

uniform highp sampler2D film;

uniform highp sampler2D filmSquares;

layout(location = 0) out vec4 _fs2p_location0;

vec4 pixelError(ivec2 at) {
    vec4 sums = texelFetch(film, at, 0);
    float n = max(sums.w, 2.0);
    vec3 mean = (sums.xyz / vec3(n));
    vec4 _e12 = texelFetch(filmSquares, at, 0);
    vec3 variance = (max(((_e12.xyz / vec3(n)) - (mean * mean)), vec3(0.0)) / vec3((n - 1.0)));
    return vec4(dot(mean, vec3(0.33333334)), dot(variance, vec3(0.33333334)), 1.0, 0.0);
}

void main() {
    vec4 fragment = gl_FragCoord;
    vec4 sum = vec4(0.0);
    float y = 0.0;
    float x = 0.0;
    vec2 _e5 = display.filmSize;
    vec2 begin = floor(((floor(fragment.xy) * _e5) / vec2(64.0)));
    vec2 _e18 = display.filmSize;
    vec2 end = floor((((floor(fragment.xy) + vec2(1.0)) * _e18) / vec2(64.0)));
    vec2 stride = max(((end - begin) / vec2(4.0)), vec2(1.0));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            float _e59 = y;
            y = (_e59 + 1.0);
        }
        loop_init = false;
        float _e36 = y;
        if ((_e36 < 4.0)) {
        } else {
            break;
        }
        {
            x = 0.0;
            bool loop_init_1 = true;
            while(true) {
                if (!loop_init_1) {
                    float _e56 = x;
                    x = (_e56 + 1.0);
                }
                loop_init_1 = false;
                float _e41 = x;
                if ((_e41 < 4.0)) {
                } else {
                    break;
                }
                {
                    float _e44 = x;
                    float _e45 = y;
                    vec2 at_1 = (begin + floor((vec2(_e44, _e45) * stride)));
                    if (all(lessThan(at_1, end))) {
                        vec4 _e52 = sum;
                        vec4 _e54 = pixelError(ivec2(at_1));
                        sum = (_e52 + _e54);
                    }
                }
            }
        }
    }
    vec4 _e62 = sum;
    _fs2p_location0 = _e62;
    return;
}

