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

vec3 srgb(vec3 linear) {
    vec3 c = clamp(linear, vec3(0.0), vec3(1.0));
    return mix(((1.055 * pow(max(c, vec3(0.0031308)), vec3(0.41666666))) - vec3(0.055)), (12.92 * c), lessThanEqual(c, vec3(0.0031308)));
}

void main() {
    uint i = uint(gl_VertexID);
    vec2 p = vec2(float(((i << 1u) & 2u)), float((i & 2u)));
    ScreenPoint _tmp_return = ScreenPoint(vec4(((p * 2.0) - vec2(1.0)), 0.0, 1.0), vec2(p.x, (1.0 - p.y)));
    gl_Position = _tmp_return.position;
    _vs2fs_location0 = _tmp_return.uv;
    return;
}

