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
smooth out vec2 _vs2fs_location0;

vec3 srgb(vec3 c) {
    vec3 r2_ = sqrt(c);
    vec3 r4_ = sqrt(r2_);
    vec3 r8_ = sqrt(r4_);
    vec3 curve = ((((0.6620027 * r2_) + (0.6841221 * r4_)) - (0.3235836 * r8_)) - (0.022541147 * c));
    return mix(curve, (12.92 * c), lessThanEqual(c, vec3(0.0031308)));
}

void main() {
    uint i = uint(gl_VertexID);
    vec2 p = vec2(float(((i << 1u) & 2u)), float((i & 2u)));
    ScreenPoint _tmp_return = ScreenPoint(vec4(((p * 2.0) - vec2(1.0)), 0.0, 1.0), vec2(p.x, (1.0 - p.y)));
    gl_Position = _tmp_return.position;
    _vs2fs_location0 = _tmp_return.uv;
    return;
}

