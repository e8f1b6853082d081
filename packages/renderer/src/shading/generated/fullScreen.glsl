#version 300 es

precision highp float;
precision highp int;


void main() {
    uint i = uint(gl_VertexID);
    gl_Position = vec4(((float(((i << 1u) & 2u)) * 2.0) - 1.0), ((float((i & 2u)) * 2.0) - 1.0), 0.0, 1.0);
    return;
}

