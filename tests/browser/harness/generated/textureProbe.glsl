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

struct TextureUse {
    vec3 toU;
    uint slot;
    vec3 toV;
    uint flags;
    uint first;
    uint width;
    uint height;
    float scale;
};
struct Neighbours {
    uint first;
    uint second;
    float share;
};
const uint isNearest = 4u;
const uint clampsU = 8u;
const uint mirrorsU = 16u;
const uint clampsV = 32u;
const uint mirrorsV = 64u;
const uint isColor = 2u;

uniform highp sampler2D questions;

const bool hasOtherLookups = false;

uniform highp usampler2D texels;

layout(location = 0) out vec4 _fs2p_location0;

Neighbours neighbours(float x, uint size, bool clamps, bool mirrors, bool nearest) {
    float inside = pick(clamps, clamp(x, 0.0, 1.0), pick(mirrors, (1.0 - abs(((2.0 * fract((0.5 * x))) - 1.0))), fract(x)));
    float at = ((inside * float(size)) - pick(nearest, 0.0, 0.5));
    float low = floor(at);
    int last = (int(size) - 1);
    int first = int(low);
    int second = (first + 1);
    bool repeats = !(pick(clamps, true, mirrors));
    int before = pick(repeats, last, 0);
    int after = pick(repeats, 0, last);
    return Neighbours(uint(pick((first < 0), before, min(max(first, 0), last))), uint(pick((second > last), after, min(max(second, 0), last))), pick(nearest, 0.0, (at - low)));
}

vec3 linearFromSrgb(vec3 c) {
    return mix(pow(((c + vec3(0.055)) / vec3(1.055)), vec3(2.4)), (c / vec3(12.92)), lessThanEqual(c, vec3(0.04045)));
}

vec4 decoded(uint texel, bool colored) {
    vec4 c_1 = (vec4(((uvec4(texel) >> uvec4(0u, 8u, 16u, 24u)) & uvec4(255u))) / vec4(255.0));
    vec3 _e18 = linearFromSrgb(c_1.xyz);
    return vec4(pick(colored, _e18, c_1.xyz), c_1.w);
}

uvec4 texelRow(uint i) {
    uvec4 _e14 = texelFetch(texels, ivec2(int((i & 2047u)), int((float(int((i & 2147481600u))) / 2048.0))), 0);
    return _e14;
}

uint texelAt(uint i_1) {
    uvec4 _e3 = texelRow((i_1 >> 2u));
    uvec2 pair = pick(((i_1 & 2u) != 0u), _e3.zw, _e3.xy);
    return pick(((i_1 & 1u) != 0u), pair.y, pair.x);
}

vec4 lookUp(TextureUse t, vec2 uv) {
    vec3 place = vec3(uv, 1.0);
    const bool _e7 = hasOtherLookups;
    uint flags = pick(_e7, t.flags, 0u);
    bool nearest_1 = ((flags & isNearest) != 0u);
    Neighbours _e24 = neighbours(dot(t.toU, place), t.width, ((flags & clampsU) != 0u), ((flags & mirrorsU) != 0u), nearest_1);
    Neighbours _e36 = neighbours(dot(t.toV, place), t.height, ((flags & clampsV) != 0u), ((flags & mirrorsV) != 0u), nearest_1);
    uint upper = (t.first + (_e36.first * t.width));
    uint lower = (t.first + (_e36.second * t.width));
    bool colored_1 = ((t.flags & isColor) != 0u);
    uint _e54 = texelAt((upper + _e24.first));
    vec4 _e55 = decoded(_e54, colored_1);
    uint _e58 = texelAt((upper + _e24.second));
    vec4 _e59 = decoded(_e58, colored_1);
    vec4 above = mix(_e55, _e59, _e24.share);
    uint _e64 = texelAt((lower + _e24.first));
    vec4 _e65 = decoded(_e64, colored_1);
    uint _e68 = texelAt((lower + _e24.second));
    vec4 _e69 = decoded(_e68, colored_1);
    vec4 below = mix(_e65, _e69, _e24.share);
    return mix(above, below, _e36.share);
}

TextureUse fetchTextureUse(uint row) {
    uvec4 _e3 = texelRow((row + 0u));
    uvec4 _e6 = texelRow((row + 1u));
    uvec4 _e9 = texelRow((row + 2u));
    return TextureUse(uintBitsToFloat(_e3.xyz), _e3.w, uintBitsToFloat(_e6.xyz), _e6.w, _e9.x, _e9.y, _e9.z, uintBitsToFloat(_e9.w));
}

void main() {
    vec4 fragment = gl_FragCoord;
    vec4 question = texelFetch(questions, ivec2(uvec2(fragment.xy)), 0);
    TextureUse _e8 = fetchTextureUse(uint(question.z));
    vec4 _e10 = lookUp(_e8, question.xy);
    _fs2p_location0 = _e10;
    return;
}

