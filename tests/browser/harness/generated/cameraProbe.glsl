#version 300 es

precision highp float;
precision highp int;

struct CameraRay {
    vec3 origin;
    vec3 direction;
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
layout(std140) uniform FrameBlock { Frame frame; };

layout(location = 0) out vec4 _fs2p_location0;

CameraRay rayThroughLens(vec2 filmPosition, vec2 lensPoint) {
    CameraRay ray = CameraRay(vec3(0.0), vec3(0.0));
    float _e7 = frame.width;
    float x = (((2.0 * filmPosition.x) / _e7) - 1.0);
    float _e16 = frame.height;
    float y = (1.0 - ((2.0 * filmPosition.y) / _e16));
    vec3 _e22 = frame.right;
    vec3 _e26 = frame.up;
    vec3 across = ((x * _e22) + (y * _e26));
    uint _e31 = frame.projection;
    bool orthographic = (_e31 == 1u);
    vec3 _e36 = frame.forward;
    vec3 _e40 = frame.forward;
    vec3 ahead = (orthographic ? _e40 : (_e36 + across));
    float _e44 = frame.aperture;
    vec3 _e48 = frame.right;
    vec3 _e54 = frame.up;
    vec3 lens_1 = (_e44 * ((lensPoint.x * normalize(_e48)) + (lensPoint.y * normalize(_e54))));
    float _e63 = frame.focusDistance;
    ray = CameraRay((orthographic ? (across + lens_1) : lens_1), normalize((ahead - (lens_1 / vec3(_e63)))));
    uint _e72 = frame.projection;
    if ((_e72 == 2u)) {
        float longitude = (3.1415927 * x);
        float latitude = (1.5707964 * y);
        vec3 _e82 = frame.right;
        vec3 _e87 = frame.forward;
        vec3 level = ((sin(longitude) * _e82) + (cos(longitude) * _e87));
        vec3 _e97 = frame.up;
        ray = CameraRay(vec3(0.0), normalize(((cos(latitude) * level) + (sin(latitude) * _e97))));
    }
    CameraRay _e102 = ray;
    return _e102;
}

vec2 concentricDisc(vec2 u) {
    vec2 p = ((2.0 * u) - vec2(1.0));
    bool wide = (abs(p.x) > abs(p.y));
    float radius = (wide ? p.x : p.y);
    float ratio = ((wide ? p.y : p.x) / ((radius == 0.0) ? 1.0 : radius));
    float angle = (wide ? (0.7853982 * ratio) : (1.5707964 - (0.7853982 * ratio)));
    return (radius * vec2(cos(angle), sin(angle)));
}

CameraRay cameraRay(vec2 filmPosition_1, vec2 lens) {
    vec2 _e2 = concentricDisc(lens);
    CameraRay _e3 = rayThroughLens(filmPosition_1, _e2);
    return _e3;
}

void main() {
    vec4 fragment = gl_FragCoord;
    vec2 block = floor((fragment.xy / vec2(16.0)));
    CameraRay _e16 = cameraRay(((block + vec2(0.5)) * 16.0), ((fragment.xy / vec2(16.0)) - block));
    uint _e21 = frame.sampleIndex;
    _fs2p_location0 = vec4(((_e21 == 0u) ? _e16.origin : _e16.direction), 0.0);
    return;
}

