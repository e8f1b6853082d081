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

struct PathWords {
    uvec4 start;
    uvec4 direction;
    uvec4 toLight;
    uvec4 light;
    uvec4 throughput;
    uvec4 litSide;
    uvec4 radiance;
    uvec4 numbers;
};
struct HitWords {
    uvec4 met;
    uvec4 more;
};
struct ChoiceWords {
    uvec4 start;
    uvec4 direction;
    uvec4 toLight;
    uvec4 light;
    uvec4 throughput;
    uvec4 u;
    uvec4 radiance;
    uvec4 numbers;
};
struct LeftTriangle {
    uint instance;
    uint triangle;
};
struct RayPair {
    vec3 point;
    uint shape;
    LeftTriangle left;
    float tMin;
    bool goesOn;
    vec3 direction;
    bool inwards;
    vec3 lightDirection;
    bool lightInwards;
    float lightDistance;
    uint lightShape;
    uint number;
};
struct Odds {
    float total;
    float tree;
};
struct Sampler {
    uint key;
    uint salt;
    uint sample_;
    uint place;
};
struct Path {
    RayPair rays;
    vec3 light;
    vec3 throughput;
    bool escaped;
    uint depth;
    vec3 radiance;
    float pdf;
    vec3 litSide;
    Odds odds;
    Sampler sampler_;
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
    uint ballCount;
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
    uint relayRow;
};
struct PairHit {
    float t;
    uint shape;
    bool blocked;
    LeftTriangle triangle;
    vec2 weights;
};
struct Groups {
    uvec2 index;
    uvec2 shift;
    uvec2 seedA;
    uvec2 seedB;
};
struct CameraRay {
    vec3 origin;
    vec3 direction;
};
struct Bounds {
    vec3 center;
    float radius;
};
struct Extent {
    vec4 a;
    vec4 b;
};
struct Slabs {
    vec3 enter;
    vec3 leave;
    float near;
    float far;
};
struct MeshRays {
    vec3 origin;
    vec3 direction;
    vec3 lightDirection;
    float least;
    float most;
    float lightMost;
    uint number;
};
struct MeshHit {
    float t;
    uint instance;
    uint triangle;
    vec2 weights;
    bool blocked;
};
struct SlabRay {
    vec3 inverse_;
    vec3 offset;
    uvec3 near;
};
struct MeshRay {
    vec3 origin;
    uint axis;
    vec3 shear;
};
struct Instance {
    vec4 toMeshX;
    vec4 toMeshY;
    vec4 toMeshZ;
    uint nodes;
    uint triangles;
    uint row;
    uint cover;
    uint vertices;
    uint vertexRows;
    uint vertexFlags;
    uint spare0_;
};
struct Triangle {
    vec3 a;
    uint vertexA;
    vec3 b;
    uint vertexB;
    vec3 c;
    uint vertexC;
};
struct Crossing {
    bool within;
    float sum;
    float depth;
    vec2 weights;
    bool front;
};
struct MaterialTextures {
    uint count;
    uint flags;
    float opacity;
    float cutoff;
};
struct Cover {
    vec4 uv;
    float opacity;
};
struct Vertex {
    uint normal;
    uint tangent;
    vec2 uv;
};
struct VertexMore {
    uint redGreen;
    uint blueAlpha;
    vec2 uv;
};
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
struct LightSample {
    vec3 direction;
    float distance_;
    vec3 radiance;
    float pdf;
    bool delta;
};
struct Lit {
    LightSample light;
    float pdf;
    float shape;
    Odds odds;
    vec3 u;
};
struct Surface {
    vec3 baseColor;
    float code;
    vec3 emission;
    float reflectivity;
    vec3 eta;
    float alpha;
    vec3 k;
    float metallic;
    vec3 absorption;
    float textures;
};
struct Basis {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
};
struct Meeting {
    vec3 point;
    uint shape;
    Surface surface;
    bool isClear;
    vec3 geometric;
    vec3 outward;
    Basis basis;
    vec3 wo;
};
struct Emitter {
    vec3 position;
    float kind;
    vec3 u;
    float radius;
    vec3 v;
    float cosInner;
    vec3 radiance;
    float area;
    float shape;
    float oneSided;
    float power;
    float reach;
    float leaf;
    float table;
    float triangles;
    float instance;
};
struct SphereView {
    vec3 toCenter;
    float distance_;
    float power;
    bool inside;
    float width;
};
struct QuadView {
    vec3 corner;
    vec3 axisX;
    vec3 axisY;
    vec3 axisZ;
    vec2 low;
    vec2 high;
    float height;
    float start;
    float solidAngle;
    bool lit;
    bool bySolidAngle;
};
struct BoxView {
    vec4 rotation;
    vec3 point;
    vec3 faces;
    float area;
    bool inside;
};
struct LampTriangle {
    float own;
    uint place;
    uint other;
    float density;
};
struct TreeChoice {
    uint emitter;
    float probability;
    float share;
    bool taken;
};
struct LightNode {
    vec4 x;
    vec4 y;
    vec4 z;
    vec4 reach;
    vec4 axisX;
    vec4 axisY;
    vec4 axisZ;
    vec4 cosWidth;
    vec4 cosEdge;
    vec4 bothSides;
    vec4 power;
    vec4 emitters;
};
struct TwoPoints {
    vec3 first;
    vec3 second;
};
struct EmitterChoice {
    uint index;
    float probability;
    Odds odds;
};
struct ConeDirection {
    vec3 direction;
    float cosine;
    float sine2_;
};
struct ChosenTriangle {
    uint place;
    float density;
    vec2 u;
};
struct EnvironmentLight {
    vec3 radiance;
    float pdf;
};
struct EnvironmentSample {
    vec3 direction;
    EnvironmentLight light;
};
struct ChosenCell {
    uvec2 cell;
    vec2 rest;
};
struct Table {
    uint first;
    uint entries;
};
struct Choice {
    uint entry;
    float rest;
};
struct Corners {
    vec4 a;
    vec4 b;
    vec4 c;
    vec4 d;
};
struct SurfacePoint {
    Surface surface;
    vec3 geometric;
    vec3 shading;
};
struct Layers {
    vec3 specularColor;
    float specularWeight;
    vec3 sheenColor;
    float sheenRoughness;
    vec3 beyondColor;
    float beyond;
    vec2 grain;
    float anisotropy;
    float transmission;
    float coat;
    float coatRoughness;
    float ior;
    float solid;
    float film;
    float filmIor;
    float filmThickness;
    float filmLeast;
    float dispersion;
    float spare0_;
    float spare1_;
    float spare2_;
};
struct Normals {
    vec3 geometric;
    vec3 shading;
};
struct MeshPoint {
    vec3 geometric;
    vec3 shading;
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
    vec4 uv;
    vec4 color;
};
struct Bumps {
    vec3 base;
    vec3 coat;
};
struct Outgoing {
    vec3 wo;
    float share;
    float ratio;
    float bound;
    float stretched;
};
struct Stack {
    vec3 wo;
    float side;
    vec3 hero;
    float ratio;
    bool inside;
    vec3 more;
    vec2 alpha;
    float coatAlpha;
    float coat;
    float sheen;
    float sheenColor;
    float ofCoat;
    float ofFacets;
    float ofSheen;
    float ofDiffuse;
    bool drawnByCoat;
};
struct Reflectance {
    vec3 dielectric;
    vec3 metal;
};
struct BsdfSample {
    vec3 direction;
    float pdf;
    vec3 weight;
    bool delta;
};
struct LayeredSample {
    vec3 direction;
    float pdf;
    bool delta;
};
struct Parting {
    vec3 toward;
    vec3 beyond;
};
struct Pair {
    vec4 toLight;
    BsdfSample drawn;
};
struct FacetLobe {
    vec3 value;
    float pdf;
    float cosine;
};
struct LayeredPair {
    vec4 toLight;
    vec4 toSample;
};
struct Facets {
    float value;
    float density;
    float cosine;
};
struct Cover0_ {
    float left;
    vec4 fibres;
};
struct Film {
    vec4 sums;
    vec4 squares;
};
struct FarLight {
    vec3 radiance;
    float pdf;
};
const uint aliveFlag = 1u;
const uint inwardsFlag = 2u;
const uint lightInwardsFlag = 4u;
const uint escapedFlag = 8u;
const uint overFlag = 16u;
const uint depthShift = 8u;
const uint isHidden = 1u;
const uint isDone = 2u;
const uint noShape = 4294967295u;
const uint noInstance = 4294967295u;
const LeftTriangle noTriangle = LeftTriangle(4294967295u, 0u);
const uint placeMask = 268435455u;
const uint beginning = 2415919101u;
const uint instances = 2147483648u;
const uint ending = 2415919103u;
const uint noLeaf = 0u;
const uint leaves = 2415919104u;
const uint unread = 2415919100u;
const uint instanceRows = 5u;
const uint leaving = 2415919102u;
const uint leastToGreatest = 3u;
const uint nodeRows = 7u;
const uint childrenRow = 6u;
const int notEntered = 1900671690;
const uint countShift = 28u;
const uint triangleRows = 3u;
const uint isOneSided = 2147483648u;
const uint coverRow = 2147483647u;
const uint vertexRows = 1u;
const uint hasOpacityTexture = 2u;
const uint materialTexturesRows = 1u;
const uint isNearest = 4u;
const uint clampsU = 8u;
const uint mirrorsU = 16u;
const uint clampsV = 32u;
const uint mirrorsV = 64u;
const uint isColor = 2u;
const uint usesSecondSet = 1u;
const uint textureUseRows = 3u;
const uint emissionSlot = 1u;
const EnvironmentLight white = EnvironmentLight(vec3(1.0), 0.07957747);
const uint metallicRoughness = 1u;
const uint hasNormals = 1u;
const uint hasTangents = 2u;
const uint isUnlit = 1u;
const uint baseColorSlot = 0u;
const uint metallicRoughnessSlot = 2u;
const uint normalSlot = 3u;
const uint coatNormalSlot = 16u;
const uint specularWeightSlot = 4u;
const uint specularColorSlot = 5u;
const uint transmissionSlot = 6u;
const uint beyondSlot = 7u;
const uint beyondColorSlot = 8u;
const uint coatSlot = 9u;
const uint coatRoughnessSlot = 10u;
const uint sheenColorSlot = 11u;
const uint sheenRoughnessSlot = 12u;
const uint filmSlot = 14u;
const uint filmThicknessSlot = 15u;
const uint anisotropySlot = 13u;
const uint dielectric_1 = 3u;
const uint conductor = 2u;
const uint diffuse0_ = 0u;
const uint rouletteDepth = 5u;

uniform highp usampler2D path0;

uniform highp usampler2D path1;

uniform highp usampler2D path2;

uniform highp usampler2D path3;

uniform highp usampler2D path4;

uniform highp usampler2D path5;

uniform highp usampler2D path6;

uniform highp usampler2D path7;

layout(std140) uniform FrameBlock { Frame frame; };

uniform highp sampler2D sceneTable;

const bool hasManyLights = true;

const bool hasSuns = false;

const bool hasSky = true;

const bool hasLightTree = false;

const bool hasEnvironment = false;

uniform highp sampler2D environment;

uniform highp sampler2D previousFilm;

uniform highp sampler2D previousSquares;

layout(location = 0) out vec4 _fs2p_location0;
layout(location = 1) out vec4 _fs2p_location1;

uvec4 words_1(vec3 v, uint w) {
    return uvec4(floatBitsToUint(v), w);
}

uvec4 wordsOf(vec3 v_1, float w_1) {
    return floatBitsToUint(vec4(v_1, w_1));
}

vec3 vectorOf(uvec4 words_2) {
    return uintBitsToFloat(words_2.xyz);
}

bool isOver(Path p_4) {
    return pick(!(p_4.rays.goesOn), (p_4.rays.lightDistance < 0.0), false);
}

uint flagsOf(Path p_5) {
    bool _e25 = isOver(p_5);
    return (((((pick(p_5.rays.goesOn, aliveFlag, 0u) | pick(p_5.rays.inwards, inwardsFlag, 0u)) | pick(p_5.rays.lightInwards, lightInwardsFlag, 0u)) | pick(p_5.escaped, escapedFlag, 0u)) | pick(_e25, overFlag, 0u)) | (p_5.depth << depthShift));
}

uvec2 pixelOf(uvec2 texel) {
    uvec2 _e3 = frame.origin;
    uint _e8 = frame.relayRow;
    return ((_e3 + texel) + uvec2(0u, _e8));
}

uint pcg(uint x) {
    uint s_27 = ((x * 747796405u) + 2891336453u);
    uint w_7 = (((s_27 >> ((s_27 >> 28u) + 4u)) ^ s_27) * 277803737u);
    return ((w_7 >> 22u) ^ w_7);
}

uint pixelHash(uvec2 pixel, uint sampleIndex, uint seed) {
    uint _e5 = pcg(seed);
    uint _e7 = pcg((sampleIndex + _e5));
    uint _e9 = pcg((pixel.y + _e7));
    uint _e11 = pcg((pixel.x + _e9));
    return _e11;
}

uint spread(uint x_1) {
    uint y_8 = ((x_1 | (x_1 * 4u)) & 51u);
    return ((y_8 | (y_8 * 2u)) & 85u);
}

uvec2 reversedHigh(uvec2 x_2) {
    uvec2 y = uvec2(0u);
    y = (x_2 + ((x_2 & uvec2(21845u)) * 3u));
    uvec2 _e8 = y;
    uvec2 _e9 = y;
    y = (_e8 + ((_e9 & uvec2(26214u)) * 15u));
    uvec2 _e16 = y;
    uvec2 _e17 = y;
    y = (_e16 + ((_e17 & uvec2(30840u)) * 255u));
    uvec2 _e24 = y;
    uvec2 _e25 = y;
    return (_e24 + ((_e25 & uvec2(32640u)) * 65535u));
}

uvec2 reversed(uvec2 x_3) {
    uvec2 _e1 = reversedHigh(x_3);
    return (_e1 >> uvec2(15u));
}

uvec2 mixBits2_(uvec2 x_4) {
    uvec2 y_1 = uvec2(0u);
    y_1 = ((x_4 ^ (x_4 >> uvec2(16u))) * 569420461u);
    uvec2 _e8 = y_1;
    uvec2 _e9 = y_1;
    y_1 = ((_e8 ^ (_e9 >> uvec2(15u))) * 1935289751u);
    uvec2 _e16 = y_1;
    uvec2 _e17 = y_1;
    return (_e16 ^ (_e17 >> uvec2(15u)));
}

uint mixBits(uint x_5) {
    uvec2 _e2 = mixBits2_(uvec2(x_5));
    return _e2.x;
}

Sampler startSampler(uvec2 pixel_1, uint sampleIndex_1, uint seed_1) {
    uint _e5 = frame.independent;
    bool independent = (_e5 != 0u);
    uint _e15 = pixelHash(pick(independent, pixel_1, (pixel_1 >> uvec2(4u))), pick(independent, sampleIndex_1, (sampleIndex_1 >> 16u)), seed_1);
    uint _e19 = spread((pixel_1.x & 15u));
    uint _e23 = spread((pixel_1.y & 15u));
    uint place_5 = (_e19 | (_e23 * 2u));
    uvec2 _e32 = reversed(uvec2((sampleIndex_1 & 65535u), (place_5 * 256u)));
    uvec2 digits_2 = pick(independent, uvec2(0u), _e32);
    uint _e38 = mixBits((_e15 ^ 1779033703u));
    return Sampler(_e15, _e38, digits_2.x, digits_2.y);
}

Sampler samplerAt(uvec2 texel_1, uint key) {
    Sampler s = Sampler(0u, 0u, 0u, 0u);
    uvec2 _e2 = pixelOf(texel_1);
    uint _e5 = frame.sampleIndex;
    uint _e8 = frame.seed;
    Sampler _e9 = startSampler(_e2, _e5, _e8);
    s = _e9;
    s.key = key;
    Sampler _e12 = s;
    return _e12;
}

PathWords written(Path p_6) {
    RayPair rays_2 = p_6.rays;
    uvec4 _e4 = words_1(rays_2.point, rays_2.shape);
    uint _e6 = flagsOf(p_6);
    uvec4 _e7 = words_1(rays_2.direction, _e6);
    uvec4 _e10 = wordsOf(rays_2.lightDirection, rays_2.lightDistance);
    uvec4 _e13 = words_1(p_6.light, rays_2.lightShape);
    uvec4 _e16 = wordsOf(p_6.throughput, p_6.pdf);
    uvec4 _e20 = wordsOf(p_6.litSide, p_6.odds.total);
    uvec4 _e24 = wordsOf(p_6.radiance, p_6.odds.tree);
    return PathWords(_e4, _e7, _e10, _e13, _e16, _e20, _e24, uvec4(rays_2.left.instance, rays_2.left.triangle, p_6.sampler_.key, 0u));
}

float tMinAt(vec3 point, uint flags) {
    return pick(((flags >> depthShift) == 1u), 0.0, (1e-5 * length(point)));
}

uint numberOfNext(Sampler s_1) {
    uint _e8 = mixBits((((s_1.key + 1u) ^ s_1.salt) ^ 2246822507u));
    uint _e15 = mixBits((_e8 + ((s_1.sample_ << 8u) | s_1.place)));
    return _e15;
}

Path pathAt(uvec2 texel_2) {
    uvec4 start = texelFetch(path0, ivec2(texel_2), 0);
    uvec4 direction_21 = texelFetch(path1, ivec2(texel_2), 0);
    uvec4 _e9 = texelFetch(path2, ivec2(texel_2), 0);
    vec4 toLight_5 = uintBitsToFloat(_e9);
    uvec4 light_1 = texelFetch(path3, ivec2(texel_2), 0);
    uvec4 _e16 = texelFetch(path4, ivec2(texel_2), 0);
    vec4 throughput_1 = uintBitsToFloat(_e16);
    uvec4 _e20 = texelFetch(path5, ivec2(texel_2), 0);
    vec4 litSide = uintBitsToFloat(_e20);
    uvec4 _e24 = texelFetch(path6, ivec2(texel_2), 0);
    vec4 radiance_1 = uintBitsToFloat(_e24);
    uvec4 numbers = texelFetch(path7, ivec2(texel_2), 0);
    uint flags_1 = direction_21.w;
    vec3 _e30 = vectorOf(start);
    bool alive = ((flags_1 & aliveFlag) != 0u);
    Sampler _e36 = samplerAt(texel_2, numbers.z);
    float _e41 = tMinAt(_e30, flags_1);
    vec3 _e42 = vectorOf(direction_21);
    uint _e54 = numberOfNext(_e36);
    RayPair rays_3 = RayPair(_e30, start.w, LeftTriangle(numbers.x, numbers.y), _e41, alive, _e42, ((flags_1 & inwardsFlag) != 0u), toLight_5.xyz, ((flags_1 & lightInwardsFlag) != 0u), toLight_5.w, light_1.w, _e54);
    vec3 _e56 = vectorOf(light_1);
    return Path(rays_3, _e56, throughput_1.xyz, ((flags_1 & escapedFlag) != 0u), (flags_1 >> depthShift), radiance_1.xyz, throughput_1.w, litSide.xyz, Odds(litSide.w, radiance_1.w), _e36);
}

Path noPath() {
    Path p_7 = Path(RayPair(vec3(0.0), 0u, LeftTriangle(0u, 0u), 0.0, false, vec3(0.0), false, vec3(0.0), false, 0.0, 0u, 0u), vec3(0.0), vec3(0.0), false, 0u, vec3(0.0), 0.0, vec3(0.0), Odds(0.0, 0.0), Sampler(0u, 0u, 0u, 0u));
    p_7.rays.lightDirection = vec3(0.0, 1.0, 0.0);
    p_7.rays.lightDistance = -1.0;
    Path _e10 = p_7;
    return _e10;
}

float filterAxis(float u) {
    float across = ((2.0 * u) - 1.0);
    float x_19 = (16.0 - (16.0 * sqrt((1.0 - abs(across)))));
    float piece = min(floor(x_19), 15.0);
    float t_7 = (x_19 - piece);
    vec4 c_3 = frame.filterPieces[uint(piece)];
    float offset_3 = (c_3.x + (t_7 * (c_3.y + (t_7 * (c_3.z + (t_7 * c_3.w))))));
    return pick((across < 0.0), -(offset_3), offset_3);
}

uvec2 scramble(uvec2 x_6, uvec2 seed_2) {
    uvec2 y_2 = uvec2(0u);
    y_2 = (x_6 ^ (x_6 * 1025551850u));
    uvec2 _e6 = y_2;
    y_2 = ((_e6 + seed_2) * ((seed_2 >> uvec2(16u)) | uvec2(1u)));
    uvec2 _e15 = y_2;
    uvec2 _e16 = y_2;
    y_2 = (_e15 ^ (_e16 * 89287766u));
    uvec2 _e20 = y_2;
    uvec2 _e21 = y_2;
    return (_e20 ^ (_e21 * 1403136100u));
}

uvec2 timesW(uvec2 x_7) {
    return (((x_7 ^ (x_7 * 2u)) & uvec2(43690u)) | ((x_7 >> uvec2(1u)) & uvec2(21845u)));
}

uvec2 timesW2_(uvec2 x_8) {
    return (((x_8 * 2u) & uvec2(43690u)) | ((x_8 ^ (x_8 >> uvec2(1u))) & uvec2(21845u)));
}

uvec2 shiftOfPlace(uvec2 x_9) {
    uvec2 y_3 = uvec2(0u);
    uvec2 _e7 = timesW(((x_9 >> uvec2(2u)) & uvec2(51u)));
    y_3 = (x_9 ^ _e7);
    uvec2 _e10 = y_3;
    uvec2 _e11 = y_3;
    uvec2 _e18 = timesW2_(((_e11 >> uvec2(4u)) & uvec2(15u)));
    y_3 = (_e10 ^ _e18);
    uvec2 _e20 = y_3;
    uvec2 _e21 = timesW(_e20);
    uvec2 _e22 = y_3;
    return (_e21 | (_e22 * 256u));
}

Groups nextGroups(Sampler s_2) {
    uvec2 _e7 = mixBits2_((uvec2(s_2.key) + uvec2(1u, 2u)));
    uvec2 half_ = ((_e7 ^ uvec2(s_2.salt)) * 2654435761u);
    uvec2 b_8 = (half_ ^ (half_ >> uvec2(16u)));
    uvec2 _e19 = scramble(uvec2(s_2.place), b_8);
    uvec2 own_3 = (s_2.sample_ * ((_e19 >> uvec2(7u)) & uvec2(4294967294u)));
    uvec2 _e31 = scramble((uvec2(s_2.sample_) ^ own_3), _e7);
    uvec2 _e35 = reversed((_e31 & uvec2(65535u)));
    uvec2 _e39 = shiftOfPlace((_e19 & uvec2(255u)));
    return Groups(_e35, _e39, ((_e7 >> uvec2(16u)) | (_e7 * 65536u)), ((b_8 >> uvec2(16u)) | (b_8 * 65536u)));
}

void skipGroup(inout Sampler s_3) {
    uint _e3 = s_3.key;
    s_3.key = (_e3 + 1u);
    return;
}

vec2 toUnit(uvec2 scrambled) {
    uvec2 _e4 = reversedHigh((scrambled & uvec2(65535u)));
    vec2 digits_3 = (vec2(ivec2(_e4)) * 4.656613e-10);
    return (digits_3 + (vec2((scrambled & uvec2(4278190080u))) * 3.5527137e-15));
}

vec2 firstOf(Groups g) {
    uvec2 _e5 = scramble((g.index ^ g.shift), g.seedA);
    vec2 _e6 = toUnit(_e5);
    return _e6;
}

uvec2 pascal(uvec2 x_10) {
    uvec2 y_4 = uvec2(0u);
    y_4 = (x_10 ^ ((x_10 >> uvec2(1u)) & uvec2(21845u)));
    uvec2 _e9 = y_4;
    uvec2 _e10 = y_4;
    y_4 = (_e9 ^ ((_e10 >> uvec2(2u)) & uvec2(13107u)));
    uvec2 _e18 = y_4;
    uvec2 _e19 = y_4;
    y_4 = (_e18 ^ ((_e19 >> uvec2(4u)) & uvec2(3855u)));
    uvec2 _e27 = y_4;
    uvec2 _e28 = y_4;
    return (_e27 ^ ((_e28 >> uvec2(8u)) & uvec2(255u)));
}

vec2 secondOf(Groups g_1) {
    uvec2 _e3 = timesW(g_1.shift);
    uvec2 _e5 = pascal((g_1.index ^ _e3));
    uvec2 _e7 = scramble(_e5, g_1.seedB);
    vec2 _e8 = toUnit(_e7);
    return _e8;
}

vec2 next2d(inout Sampler s_4) {
    Sampler _e1 = s_4;
    Groups _e2 = nextGroups(_e1);
    skipGroup(s_4);
    vec2 _e3 = firstOf(_e2);
    vec2 _e5 = secondOf(_e2);
    return vec2(_e3.x, _e5.x);
}

vec2 concentricDisc(vec2 u_2) {
    vec2 p_25 = ((2.0 * u_2) - vec2(1.0));
    bool wide = (abs(p_25.x) > abs(p_25.y));
    float radius_1 = pick(wide, p_25.x, p_25.y);
    float ratio_6 = (pick(wide, p_25.y, p_25.x) / pick((radius_1 == 0.0), 1.0, radius_1));
    float angle = pick(wide, (0.7853982 * ratio_6), (1.5707964 - (0.7853982 * ratio_6)));
    return (radius_1 * vec2(cos(angle), sin(angle)));
}

vec4 tableTexel(uint column, uint row) {
    vec4 _e5 = texelFetch(sceneTable, ivec2(uvec2(column, row)), 0);
    return _e5;
}

Bounds fetchBounds(uint i) {
    vec4 _e2 = tableTexel(0u, i);
    return Bounds(_e2.xyz, _e2.w);
}

float intersectSphere(vec3 origin, vec3 direction, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter = (center - origin);
    float along = dot(toCenter, direction);
    vec3 across_1 = (toCenter - (along * direction));
    float discriminant = ((radius * radius) - dot(across_1, across_1));
    float half_1 = sqrt(max(discriminant, 0.0));
    float near = (along - half_1);
    float far_4 = (along + half_1);
    float t_8 = pick((near > tMin), near, far_4);
    return pick(startsInside, max(far_4, 0.0), pick(pick((discriminant >= 0.0), (t_8 > tMin), false), t_8, 1e30));
}

PairHit meet(PairHit found, RayPair p_9, uint i_1, vec2 t) {
    bool own_4 = (i_1 == p_9.shape);
    float pathT = pick(pick(own_4, !(p_9.inwards), false), 1e30, t.x);
    float lightT = pick(pick(pick(own_4, !(p_9.lightInwards), false), true, (i_1 == p_9.lightShape)), 1e30, t.y);
    bool nearer_1 = (pathT < found.t);
    return PairHit(pick(nearer_1, pathT, found.t), pick(nearer_1, i_1, found.shape), pick(found.blocked, true, (lightT < p_9.lightDistance)), noTriangle, vec2(0.0));
}

PairHit meetSphere(PairHit found_1, RayPair p_10, uint i_2) {
    Bounds _e3 = fetchBounds(i_2);
    bool own_5 = (i_2 == p_10.shape);
    float _e13 = intersectSphere(p_10.point, p_10.direction, _e3.center, _e3.radius, p_10.tMin, pick(own_5, p_10.inwards, false));
    float _e21 = intersectSphere(p_10.point, p_10.lightDirection, _e3.center, _e3.radius, p_10.tMin, pick(own_5, p_10.lightInwards, false));
    PairHit _e23 = meet(found_1, p_10, i_2, vec2(_e13, _e21));
    return _e23;
}

Extent fetchExtent(uint i_3) {
    vec4 _e2 = tableTexel(1u, i_3);
    vec4 _e4 = tableTexel(2u, i_3);
    return Extent(_e2.xyzw, _e4.xyzw);
}

vec3 rotate(vec4 q, vec3 v_2) {
    vec3 t_9 = (2.0 * cross(q.xyz, v_2));
    return ((v_2 + (q.w * t_9)) + cross(q.xyz, t_9));
}

vec3 safeReciprocal(vec3 d, vec3 origin_1) {
    vec3 tiny = mix(vec3(1e-18), vec3(-1e-18), greaterThan(origin_1, vec3(0.0)));
    return (vec3(1.0) / mix(d, tiny, lessThan(abs(d), vec3(1e-18))));
}

Slabs boxSlabs(vec3 origin_2, vec3 direction_1, vec3 halfSize) {
    vec3 _e3 = safeReciprocal(direction_1, origin_2);
    vec3 middle = (-(origin_2) * _e3);
    vec3 reach = (halfSize * abs(_e3));
    vec3 enter = (middle - reach);
    vec3 leave = (middle + reach);
    return Slabs(enter, leave, max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}

float intersectBox(vec3 origin_3, vec3 direction_2, vec3 halfSize_1, float tMin_1, bool startsInside_1) {
    Slabs _e5 = boxSlabs(origin_3, direction_2, halfSize_1);
    float t_10 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_10 > tMin_1), false), t_10, 1e30));
}

float intersectQuad(vec3 origin_4, vec3 direction_3, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_15 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_3, normal_15);
    vec3 toCenter_1 = (center_1 - origin_4);
    float t_11 = (dot(toCenter_1, normal_15) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_26 = ((t_11 * direction_3) - toCenter_1);
    bool within = (max(abs(dot(p_26, reciprocalU)), abs(dot(p_26, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_11 > tMin_2), (t_11 < 1e30), false), within, false), t_11, 1e30);
}

PairHit meetQuad(PairHit found_3, RayPair p_12, uint i_5) {
    Bounds _e3 = fetchBounds(i_5);
    Extent _e4 = fetchExtent(i_5);
    float _e13 = intersectQuad(p_12.point, p_12.direction, _e3.center, _e4.a.xyz, _e4.b.xyz, p_12.tMin);
    float _e22 = intersectQuad(p_12.point, p_12.lightDirection, _e3.center, _e4.a.xyz, _e4.b.xyz, p_12.tMin);
    PairHit _e24 = meet(found_3, p_12, i_5, vec2(_e13, _e22));
    return _e24;
}

float intersectPlane(vec3 origin_5, vec3 direction_4, vec3 normal, float offset_1, float tMin_3) {
    float speed_1 = dot(direction_4, normal);
    float t_12 = ((offset_1 - dot(origin_5, normal)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset_1 > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_12 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset_1 == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_12, 0.0), 1e30);
}

PairHit meetPlane(PairHit found_4, RayPair p_13, uint i_6) {
    Bounds _e3 = fetchBounds(i_6);
    float _e9 = intersectPlane(p_13.point, p_13.direction, _e3.center, _e3.radius, p_13.tMin);
    float _e15 = intersectPlane(p_13.point, p_13.lightDirection, _e3.center, _e3.radius, p_13.tMin);
    PairHit _e17 = meet(found_4, p_13, i_6, vec2(_e9, _e15));
    return _e17;
}

bool isAmongInstances(uint reference) {
    return pick(pick((reference >= instances), (reference < leaves), false), (reference != unread), false);
}

SlabRay slabRay(vec3 origin_6, vec3 direction_5) {
    vec3 inverse_1 = (vec3(1.0) / mix(direction_5, vec3(1e-18), lessThan(abs(direction_5), vec3(1e-18))));
    return SlabRay(inverse_1, (-(origin_6) * inverse_1), (uvec3(0u, 1u, 2u) + (leastToGreatest * uvec3(lessThan(direction_5, vec3(0.0))))));
}

vec3 turnedTo(uint axis, vec3 v_4) {
    return pick((axis == 0u), v_4.yzx, pick((axis == 1u), v_4.zxy, v_4));
}

MeshRay meshRay(vec3 origin_7, vec3 direction_6) {
    vec3 size_1 = abs(direction_6);
    uint axis_3 = pick((size_1.z >= max(size_1.x, size_1.y)), 2u, pick((size_1.y > size_1.x), 1u, 0u));
    vec3 _e16 = turnedTo(axis_3, direction_6);
    return MeshRay(origin_7, axis_3, vec3((-(_e16.xy) / vec2(_e16.z)), (1.0 / _e16.z)));
}

vec4 larger(vec4 a, vec4 b) {
    return intBitsToFloat(max(floatBitsToInt(a), floatBitsToInt(b)));
}

vec4 smaller(vec4 a_1, vec4 b_1) {
    return intBitsToFloat(min(floatBitsToInt(a_1), floatBitsToInt(b_1)));
}

float edge(vec2 a_2, vec2 b_2) {
    float p_27 = (a_2.x * b_2.y);
    float q_6 = (a_2.y * b_2.x);
    return ((a_2.x * b_2.y + -(q_6)) - (a_2.y * b_2.x + -(p_27)));
}

bool isWithin(float u_4, float v_5, float w_3) {
    return pick(pick(pick((u_4 >= 0.0), (v_5 >= 0.0), false), (w_3 >= 0.0), false), true, pick(pick((u_4 <= 0.0), (v_5 <= 0.0), false), (w_3 <= 0.0), false));
}

Crossing crossTriangle(MeshRay ray_1, Triangle triangle) {
    vec3 _e6 = turnedTo(ray_1.axis, (triangle.a - ray_1.origin));
    vec3 _e11 = turnedTo(ray_1.axis, (triangle.b - ray_1.origin));
    vec3 _e16 = turnedTo(ray_1.axis, (triangle.c - ray_1.origin));
    vec2 pa = (_e6.xy + (_e6.z * ray_1.shear.xy));
    vec2 pb = (_e11.xy + (_e11.z * ray_1.shear.xy));
    vec2 pc = (_e16.xy + (_e16.z * ray_1.shear.xy));
    float _e35 = edge(pc, pb);
    float _e36 = edge(pa, pc);
    float _e37 = edge(pb, pa);
    float sum_2 = ((_e35 + _e36) + _e37);
    float side_2 = pick((sum_2 < 0.0), -1.0, 1.0);
    bool _e45 = isWithin(_e35, _e36, _e37);
    float depth = ((ray_1.shear.z * side_2) * (((_e35 * _e6.z) + (_e36 * _e11.z)) + (_e37 * _e16.z)));
    return Crossing(pick(_e45, (sum_2 != 0.0), false), (sum_2 * side_2), depth, (vec2(_e36, _e37) * side_2), ((sum_2 * ray_1.shear.z) > 0.0));
}

vec2 pairOf(uint word) {
    return (vec2(float((word & 65535u)), float((word >> 16u))) / vec2(65535.0));
}

Neighbours neighbours(float x_11, uint size, bool clamps, bool mirrors, bool nearest) {
    float inside = pick(clamps, clamp(x_11, 0.0, 1.0), pick(mirrors, (1.0 - abs(((2.0 * fract((0.5 * x_11))) - 1.0))), fract(x_11)));
    float at_1 = ((inside * float(size)) - pick(nearest, 0.0, 0.5));
    float low_1 = floor(at_1);
    int last = (int(size) - 1);
    int first = int(low_1);
    int second = (first + 1);
    bool repeats = !(pick(clamps, true, mirrors));
    int before = pick(repeats, last, 0);
    int after = pick(repeats, 0, last);
    return Neighbours(uint(pick((first < 0), before, min(max(first, 0), last))), uint(pick((second > last), after, min(max(second, 0), last))), pick(nearest, 0.0, (at_1 - low_1)));
}

vec3 linearFromSrgb(vec3 c_1) {
    return mix(pow(((c_1 + vec3(0.055)) / vec3(1.055)), vec3(2.4)), (c_1 / vec3(12.92)), lessThanEqual(c_1, vec3(0.04045)));
}

vec4 decoded(uint texel_5, bool colored) {
    vec4 c_4 = (vec4(((uvec4(texel_5) >> uvec4(0u, 8u, 16u, 24u)) & uvec4(255u))) / vec4(255.0));
    vec3 _e18 = linearFromSrgb(c_4.xyz);
    return vec4(pick(colored, _e18, c_4.xyz), c_4.w);
}

float unitFloat(uint h) {
    return (float((h >> 8u)) * 5.9604645e-8);
}

Emitter fetchEmitter(uint i_11) {
    vec4 _e2 = tableTexel(14u, i_11);
    vec4 _e4 = tableTexel(15u, i_11);
    vec4 _e6 = tableTexel(16u, i_11);
    vec4 _e8 = tableTexel(17u, i_11);
    vec4 _e10 = tableTexel(18u, i_11);
    vec4 _e12 = tableTexel(19u, i_11);
    return Emitter(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.x, _e10.y, _e10.z, _e10.w, _e12.x, _e12.y, _e12.z, _e12.w);
}

int emitterOf(float code) {
    return ((int(code) >> 7u) - 1);
}

uint emitterOfTriangle(Emitter e, LeftTriangle t_3) {
    return (((t_3.instance - uint(e.instance)) * uint(e.cosInner)) + (t_3.triangle >> uint(e.radius)));
}

Emitter emitterAt(uint i_12, Emitter only) {
    Emitter emitter = Emitter(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    emitter = only;
    const bool _e4 = hasManyLights;
    if (_e4) {
        Emitter _e5 = fetchEmitter(i_12);
        emitter = _e5;
    }
    Emitter _e6 = emitter;
    return _e6;
}

SphereView viewSphere(Emitter e_1, vec3 point_1) {
    vec3 toCenter_2 = (e_1.position - point_1);
    float d_2 = length(toCenter_2);
    float power = abs(((d_2 - e_1.radius) * (d_2 + e_1.radius)));
    bool inside_1 = (d_2 <= e_1.radius);
    float sine_1 = min((e_1.radius / max(d_2, 1e-30)), 1.0);
    float cosine_20 = (sqrt(power) / max(d_2, 1e-30));
    return SphereView(toCenter_2, d_2, power, inside_1, pick(inside_1, 2.0, ((sine_1 * sine_1) / (1.0 + cosine_20))));
}

float conePdf(float width) {
    return (1.0 / (6.2831855 * max(width, 1e-31)));
}

float spherePdf(Emitter e_2, vec3 point_2, vec3 direction_7) {
    SphereView _e3 = viewSphere(e_2, point_2);
    bool reached = pick(_e3.inside, true, (dot(direction_7, _e3.toCenter) > 0.0));
    float _e11 = conePdf(_e3.width);
    return pick(reached, _e11, 0.0);
}

float areaPdf(float area, float height, float distance_) {
    float pdf_1 = (((distance_ / max(height, 1e-30)) * distance_) / max((area / distance_), 1e-30));
    return min(pdf_1, 1e30);
}

float pdfOfView(QuadView q_2, float area_1, float distance_1) {
    float _e4 = areaPdf(area_1, q_2.height, distance_1);
    float pdf_2 = pick(q_2.bySolidAngle, (1.0 / max(q_2.solidAngle, 0.01)), _e4);
    return pick(q_2.lit, pdf_2, 0.0);
}

float arctangent(float x_12) {
    float a_5 = abs(x_12);
    bool steep = (a_5 > 2.4142137);
    bool middle_1 = pick((a_5 > 0.41421357), !(steep), false);
    float r_4 = pick(steep, (-1.0 / max(a_5, 1.0)), pick(middle_1, ((a_5 - 1.0) / (a_5 + 1.0)), a_5));
    float base_1 = pick(steep, 1.5707964, pick(middle_1, 0.7853982, 0.0));
    float z_2 = (r_4 * r_4);
    float series = ((((((0.080537446 * z_2) - 0.13877685) * z_2) + 0.19977711) * z_2) - 0.3333295);
    return (sign(x_12) * (base_1 + (((series * z_2) * r_4) + r_4)));
}

float stretch(float x_13, vec2 y_5, float h_1) {
    vec2 r_5 = sqrt(((vec2((x_13 * x_13)) + (y_5 * y_5)) + vec2((h_1 * h_1))));
    float _e16 = arctangent(((x_13 * y_5.y) / (h_1 * r_5.y)));
    float _e22 = arctangent(((x_13 * y_5.x) / (h_1 * r_5.x)));
    return (_e16 - _e22);
}

QuadView viewQuad(Emitter e_3, vec3 point_3) {
    vec3 corner = (e_3.position - point_3);
    vec2 lengths = vec2(length(e_3.u), length(e_3.v));
    vec3 axisX = (e_3.u / vec3(lengths.x));
    vec3 axisY = (e_3.v / vec3(lengths.y));
    vec3 normal_16 = normalize(cross(axisX, axisY));
    float signedHeight = dot(corner, normal_16);
    float least = (1e-7 * (lengths.x + lengths.y));
    float height_1 = max(abs(signedHeight), least);
    bool lit_2 = pick((abs(signedHeight) > least), pick((e_3.oneSided == 0.0), true, (signedHeight < 0.0)), false);
    vec2 low_2 = vec2(dot(corner, axisX), dot(corner, axisY));
    vec2 high_1 = (low_2 + lengths);
    vec2 y_9 = vec2(low_2.y, high_1.y);
    float _e44 = stretch(low_2.x, y_9, height_1);
    float _e46 = stretch(high_1.x, y_9, height_1);
    float solidAngle = (_e46 - _e44);
    bool rectangle = (abs(dot(axisX, axisY)) <= 1e-5);
    vec3 axisZ = (normal_16 * pick((signedHeight > 0.0), 1.0, -1.0));
    return QuadView(corner, axisX, axisY, axisZ, low_2, high_1, height_1, _e44, solidAngle, lit_2, pick(rectangle, (solidAngle > 0.01), false));
}

float quadPdf(Emitter e_4, vec3 point_4, float distance_2) {
    QuadView _e3 = viewQuad(e_4, point_4);
    float _e5 = pdfOfView(_e3, e_4.area, distance_2);
    return _e5;
}

BoxView viewBox(Emitter e_5, vec3 point_5) {
    Extent _e4 = fetchExtent(uint(e_5.shape));
    vec4 rotation = _e4.a;
    vec3 _e8 = rotate(rotation, (point_5 - e_5.position));
    bvec3 seen = greaterThan(abs(_e8), e_5.u);
    vec3 faces = mix(vec3(0.0), ((4.0 * e_5.u.yzx) * e_5.u.zxy), seen);
    return BoxView(rotation, _e8, faces, ((faces.x + faces.y) + faces.z), !(any(seen)));
}

float boxPdf(Emitter e_6, vec3 point_6, vec3 direction_8, float distance_3, vec3 normal_1) {
    BoxView _e5 = viewBox(e_6, point_6);
    float _e10 = areaPdf(_e5.area, (distance_3 * abs(dot(direction_8, normal_1))), distance_3);
    float _e12 = conePdf(2.0);
    return pick(_e5.inside, _e12, _e10);
}

float cosineTowards(Emitter e_9, vec3 toLight_1, float grown, vec3 normal_4) {
    float above = clamp(((dot(normal_4, toLight_1) + e_9.reach) / grown), 0.0, 1.0);
    return pick((dot(normal_4, normal_4) == 0.0), 1.0, above);
}

float spotFalloff(Emitter e_10, vec3 toLight_2) {
    float share_1 = clamp(((-(dot(toLight_2, e_10.u)) - e_10.radius) / (e_10.cosInner - e_10.radius)), 0.0, 1.0);
    return (share_1 * share_1);
}

LightNode fetchLightNode(uint i_13) {
    vec4 _e2 = tableTexel(0u, i_13);
    vec4 _e4 = tableTexel(1u, i_13);
    vec4 _e6 = tableTexel(2u, i_13);
    vec4 _e8 = tableTexel(3u, i_13);
    vec4 _e10 = tableTexel(4u, i_13);
    vec4 _e12 = tableTexel(5u, i_13);
    vec4 _e14 = tableTexel(6u, i_13);
    vec4 _e16 = tableTexel(7u, i_13);
    vec4 _e18 = tableTexel(8u, i_13);
    vec4 _e20 = tableTexel(9u, i_13);
    vec4 _e22 = tableTexel(10u, i_13);
    vec4 _e24 = tableTexel(11u, i_13);
    return LightNode(_e2.xyzw, _e4.xyzw, _e6.xyzw, _e8.xyzw, _e10.xyzw, _e12.xyzw, _e14.xyzw, _e16.xyzw, _e18.xyzw, _e20.xyzw, _e22.xyzw, _e24.xyzw);
}

vec4 sineOf(vec4 cosine) {
    return sqrt(max((vec4(1.0) - (cosine * cosine)), vec4(0.0)));
}

vec4 cosineLess(vec4 cosA, vec4 sinA, vec4 cosB, vec4 sinB) {
    return mix(((cosA * cosB) + (sinA * sinB)), vec4(1.0), greaterThan(cosA, cosB));
}

vec4 estimatesOfChildren(LightNode n, vec3 point_10, vec3 normal_7) {
    vec4 x_20 = (n.x - vec4(point_10.x));
    vec4 y_10 = (n.y - vec4(point_10.y));
    vec4 z_3 = (n.z - vec4(point_10.z));
    vec4 distance2_ = (((x_20 * x_20) + (y_10 * y_10)) + (z_3 * z_3));
    vec4 inverse_2 = inversesqrt(max(distance2_, vec4(1e-30)));
    bvec4 inside_2 = lessThanEqual(distance2_, (n.reach * n.reach));
    vec4 sinB_1 = min((n.reach * inverse_2), vec4(1.0));
    vec4 _e33 = sineOf(sinB_1);
    vec4 cosB_1 = mix(_e33, vec4(-1.0), inside_2);
    vec4 along_1 = (-((((n.axisX * x_20) + (n.axisY * y_10)) + (n.axisZ * z_3))) * inverse_2);
    vec4 cosW = clamp(mix(along_1, abs(along_1), greaterThan(n.bothSides, vec4(0.5))), vec4(-1.0), vec4(1.0));
    vec4 _e58 = sineOf(cosW);
    vec4 _e60 = sineOf(n.cosWidth);
    vec4 _e62 = cosineLess(cosW, _e58, n.cosWidth, _e60);
    vec4 _e63 = sineOf(_e62);
    vec4 _e64 = cosineLess(_e62, _e63, cosB_1, sinB_1);
    vec4 cosOut = mix(_e64, vec4(1.0), inside_2);
    vec4 cosN = clamp(((((normal_7.x * x_20) + (normal_7.y * y_10)) + (normal_7.z * z_3)) * inverse_2), vec4(-1.0), vec4(1.0));
    vec4 _e82 = sineOf(cosN);
    vec4 _e83 = cosineLess(cosN, _e82, cosB_1, sinB_1);
    vec4 above_1 = mix(max(_e83, vec4(0.0)), vec4(1.0), inside_2);
    vec4 cosIn = pick((dot(normal_7, normal_7) == 0.0), vec4(1.0), above_1);
    vec4 estimate_2 = (((n.power * cosOut) * cosIn) / max(max(distance2_, (n.reach * n.reach)), vec4(1e-15)));
    return mix(vec4(0.0), min(estimate_2, vec4(1e30)), greaterThan(cosOut, n.cosEdge));
}

float shareOfTree(float total, float far) {
    float share_2 = (0.25 + ((0.5 * total) / max((total + far), 1e-37)));
    return pick((total <= 0.0), 0.0, pick((far <= 0.0), 1.0, share_2));
}

TreeChoice descend(vec3 point_11, vec3 normal_8, float u_5, int leaf, float far_1) {
    uint level = 0u;
    uint node_1 = 0u;
    float rest = 0.0;
    TreeChoice choice = TreeChoice(0u, 1.0, 0.0, true);
    uint _e7 = frame.lightTreeDepth;
    level = _e7;
    rest = u_5;
    while(true) {
        uint _e19 = level;
        level = (_e19 - 1u);
        uint _e23 = frame.lightTree;
        uint _e24 = node_1;
        LightNode _e26 = fetchLightNode((_e23 + _e24));
        vec4 _e27 = estimatesOfChildren(_e26, point_11, normal_8);
        float two = (_e27.x + _e27.y);
        float three = (two + _e27.z);
        float total_2 = (three + _e27.w);
        uint _e35 = node_1;
        if ((_e35 == 0u)) {
            float _e39 = shareOfTree(total_2, far_1);
            choice.share = _e39;
            float _e41 = rest;
            float _e43 = choice.share;
            choice.taken = (_e41 < _e43);
            float _e45 = rest;
            float _e47 = choice.share;
            rest = min((_e45 / max(_e47, 1e-37)), 0.99999994);
        }
        float _e53 = rest;
        float at_2 = (_e53 * total_2);
        uint byChance = ((uint((at_2 >= _e27.x)) + uint((at_2 >= two))) + uint((at_2 >= three)));
        uint _e68 = level;
        uint child = pick((leaf < 0), byChance, ((uint(max(leaf, 0)) >> (2u * _e68)) & 3u));
        bool low_3 = (child < 2u);
        bool odd = ((child & 1u) == 1u);
        float own_6 = pick(low_3, pick(odd, _e27.y, _e27.x), pick(odd, _e27.w, _e27.z));
        float before_1 = pick(low_3, pick(odd, _e27.x, 0.0), pick(odd, three, two));
        float _e95 = choice.probability;
        choice.probability = (_e95 * (own_6 / max(total_2, 1e-37)));
        choice.emitter = uint(pick(low_3, pick(odd, _e26.emitters.y, _e26.emitters.x), pick(odd, _e26.emitters.w, _e26.emitters.z)));
        rest = clamp(((at_2 - before_1) / max(own_6, 1e-37)), 0.0, 0.99999994);
        uint _e121 = node_1;
        node_1 = (((4u * _e121) + 1u) + child);
        uint _e126 = level;
        if ((_e126 == 0u)) {
            break;
        }
    }
    TreeChoice _e129 = choice;
    return _e129;
}

float treeProbability(Emitter e_13, vec3 point_12, vec3 normal_9, Odds odds_1) {
    float probability_1 = 0.0;
    uint _e8 = frame.lightTreeDepth;
    if ((_e8 > 0u)) {
        TreeChoice _e17 = descend(point_12, normal_9, 0.0, int(max(e_13.leaf, 0.0)), odds_1.total);
        probability_1 = (_e17.probability * _e17.share);
    }
    float _e21 = probability_1;
    return _e21;
}

float misWeight(float own_1, float other) {
    float ratio_7 = (other / own_1);
    return (1.0 / (1.0 + (ratio_7 * ratio_7)));
}

uvec2 pascalW2_(uvec2 x_14) {
    uvec2 y_6 = uvec2(0u);
    uvec2 _e7 = timesW2_(((x_14 >> uvec2(2u)) & uvec2(13107u)));
    y_6 = (x_14 ^ _e7);
    uvec2 _e10 = y_6;
    uvec2 _e11 = y_6;
    uvec2 _e18 = timesW(((_e11 >> uvec2(4u)) & uvec2(3855u)));
    y_6 = (_e10 ^ _e18);
    uvec2 _e20 = y_6;
    uvec2 _e21 = y_6;
    uvec2 _e28 = timesW2_(((_e21 >> uvec2(8u)) & uvec2(255u)));
    return (_e20 ^ _e28);
}

vec2 thirdOf(Groups g_2) {
    uvec2 _e3 = timesW2_(g_2.shift);
    uvec2 _e5 = pascalW2_((g_2.index ^ _e3));
    uvec2 _e11 = scramble(_e5, (g_2.seedA ^ (g_2.seedB * 2654435761u)));
    vec2 _e12 = toUnit(_e11);
    return _e12;
}

TwoPoints nextTwo3d(inout Sampler s_7) {
    Sampler _e1 = s_7;
    Groups _e2 = nextGroups(_e1);
    uint _e5 = s_7.key;
    s_7.key = (_e5 + 2u);
    vec2 _e8 = firstOf(_e2);
    vec2 _e9 = secondOf(_e2);
    vec2 _e10 = thirdOf(_e2);
    return TwoPoints(vec3(_e8.x, _e9.x, _e10.x), vec3(_e8.y, _e9.y, _e10.y));
}

vec3 litSideOf(Meeting m) {
    return pick(m.isClear, vec3(0.0), m.basis.normal);
}

vec3 turnTo(vec3 axis_1, vec3 v_6) {
    float s_28 = pick((axis_1.z >= 0.0), 1.0, -1.0);
    float a_6 = (-1.0 / (s_28 + axis_1.z));
    float b_9 = ((axis_1.x * axis_1.y) * a_6);
    vec3 x_21 = vec3((1.0 + (((s_28 * axis_1.x) * axis_1.x) * a_6)), (s_28 * b_9), (-(s_28) * axis_1.x));
    vec3 y_11 = vec3(b_9, (s_28 + ((axis_1.y * axis_1.y) * a_6)), -(axis_1.y));
    return (((v_6.x * x_21) + (v_6.y * y_11)) + (v_6.z * axis_1));
}

ConeDirection sampleCone(vec3 axis_2, float width_1, vec2 u_7) {
    float oneMinusCosine = (u_7.x * width_1);
    float cosine_21 = (1.0 - oneMinusCosine);
    float sine2_ = (oneMinusCosine * (2.0 - oneMinusCosine));
    float sine_2 = sqrt(max(sine2_, 0.0));
    float phi = (6.2831855 * u_7.y);
    vec2 turn = vec2(cos(phi), sin(phi));
    vec3 _e23 = turnTo(axis_2, vec3(((sine_2 / length(turn)) * turn), cosine_21));
    return ConeDirection(_e23, cosine_21, sine2_);
}

LightSample sampleSphere(Emitter e_14, vec3 point_14, vec2 u_8) {
    SphereView _e3 = viewSphere(e_14, point_14);
    vec3 axis_4 = pick((_e3.distance_ < 1e-30), vec3(0.0, 0.0, 1.0), (_e3.toCenter / vec3(max(_e3.distance_, 1e-30))));
    ConeDirection _e19 = sampleCone(axis_4, _e3.width, u_8);
    float along_2 = (_e3.distance_ * _e19.cosine);
    float halfChord = sqrt(max(((e_14.radius * e_14.radius) - ((_e3.distance_ * _e3.distance_) * _e19.sine2_)), 0.0));
    float larger_1 = (abs(along_2) + halfChord);
    bool takeLarger = pick(_e3.inside, (along_2 > 0.0), false);
    float distance_6 = pick(takeLarger, larger_1, (_e3.power / max(larger_1, 1e-30)));
    float _e49 = conePdf(_e3.width);
    return LightSample(_e19.direction, distance_6, e_14.radiance, _e49, false);
}

vec2 cosineAndSine(float x_15) {
    float h_6 = (0.5 * x_15);
    float z_4 = (h_6 * h_6);
    float sine_3 = (((((((-0.00019515296 * z_4) + 0.008332161) * z_4) - 0.16666655) * z_4) * h_6) + h_6);
    return vec2((1.0 - ((2.0 * sine_3) * sine_3)), ((2.0 * sine_3) * sqrt((1.0 - (sine_3 * sine_3)))));
}

vec3 sphericalRectangle(QuadView q_3, vec2 u_9) {
    float h_7 = q_3.height;
    vec2 y_12 = vec2(q_3.low.y, q_3.high.y);
    vec2 s_29 = (y_12 / sqrt(((y_12 * y_12) + vec2((h_7 * h_7)))));
    vec2 _e21 = cosineAndSine((0.5 * (q_3.start + (u_9.x * q_3.solidAngle))));
    vec2 across_2 = (vec2((s_29.y - s_29.x), (s_29.y + s_29.x)) * _e21);
    float w_8 = (((2.0 * _e21.x) * _e21.y) / max(length(across_2), 1e-15));
    float x_22 = clamp(((h_7 * w_8) * inversesqrt(max((1.0 - (w_8 * w_8)), 1e-12))), q_3.low.x, q_3.high.x);
    float d2_ = ((x_22 * x_22) + (h_7 * h_7));
    vec2 ends_1 = (y_12 * inversesqrt((vec2(d2_) + (y_12 * y_12))));
    float v_14 = mix(ends_1.x, ends_1.y, u_9.y);
    float atY = clamp(((v_14 * sqrt(d2_)) * inversesqrt(max((1.0 - (v_14 * v_14)), 1e-12))), y_12.x, y_12.y);
    return (((x_22 * q_3.axisX) + (atY * q_3.axisY)) + (h_7 * q_3.axisZ));
}

LightSample sampleQuad(Emitter e_15, vec3 point_15, vec2 u_10) {
    QuadView _e3 = viewQuad(e_15, point_15);
    vec3 onArea = ((_e3.corner + (u_10.x * e_15.u)) + (u_10.y * e_15.v));
    vec3 _e13 = sphericalRectangle(_e3, u_10);
    vec3 toLight_6 = pick(_e3.bySolidAngle, _e13, onArea);
    float distance_7 = max(length(toLight_6), _e3.height);
    float _e23 = pdfOfView(_e3, e_15.area, distance_7);
    return LightSample((toLight_6 / vec3(distance_7)), distance_7, e_15.radiance, _e23, false);
}

vec4 pointOnFaces(Emitter e_16, BoxView b_3, vec2 u_11) {
    float both = (b_3.faces.x + b_3.faces.y);
    float at_3 = (u_11.x * b_3.area);
    bool onX = (at_3 < b_3.faces.x);
    bool onY = pick(!(onX), (at_3 < both), false);
    float face = pick(onX, b_3.faces.x, pick(onY, b_3.faces.y, b_3.faces.z));
    float within_1 = clamp(((at_3 - pick(onX, 0.0, pick(onY, b_3.faces.x, both))) / max(face, 1e-30)), 0.0, 1.0);
    vec3 axis_5 = vec3(pick(onX, 1.0, 0.0), pick(onY, 1.0, 0.0), pick(pick(onX, true, onY), 0.0, 1.0));
    vec3 p_28 = vec3(pick((dot(axis_5, b_3.point) >= 0.0), 1.0, -1.0), ((2.0 * within_1) - 1.0), ((2.0 * u_11.y) - 1.0));
    vec3 toLight_7 = ((pick(onX, p_28.xyz, pick(onY, p_28.zxy, p_28.yzx)) * e_16.u) - b_3.point);
    return vec4(toLight_7, abs(dot(axis_5, toLight_7)));
}

vec3 rotateBack(vec4 q_4, vec3 v_7) {
    vec3 _e6 = rotate(vec4(-(q_4.xyz), q_4.w), v_7);
    return _e6;
}

LightSample sampleBox(Emitter e_17, vec3 point_16, vec2 u_12) {
    BoxView _e3 = viewBox(e_17, point_16);
    vec4 _e4 = pointOnFaces(e_17, _e3, u_12);
    ConeDirection _e10 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_12);
    vec3 outwards = _e10.direction;
    Slabs _e16 = boxSlabs(_e3.point, outwards, e_17.u);
    float distance_8 = pick(_e3.inside, max(_e16.far, 0.0), length(_e4.xyz));
    vec3 direction_22 = pick(_e3.inside, outwards, (_e4.xyz / vec3(max(distance_8, 1e-30))));
    float _e31 = areaPdf(_e3.area, _e4.w, distance_8);
    float _e33 = conePdf(2.0);
    float pdf_3 = pick(_e3.inside, _e33, _e31);
    vec3 _e37 = rotateBack(_e3.rotation, direction_22);
    return LightSample(_e37, distance_8, e_17.radiance, pdf_3, false);
}

vec2 weightsOnTriangle(vec2 u_14) {
    float low_4 = (0.5 * min(u_14.x, u_14.y));
    float high_2 = (max(u_14.x, u_14.y) - low_4);
    return pick((u_14.x < u_14.y), vec2(low_4, high_2), vec2(high_2, low_4));
}

vec3 outOfMesh(Instance i_16, vec3 p_17) {
    vec3 q_7 = (p_17 - vec3(i_16.toMeshX.w, i_16.toMeshY.w, i_16.toMeshZ.w));
    vec3 x_23 = cross(i_16.toMeshY.xyz, i_16.toMeshZ.xyz);
    vec3 y_13 = cross(i_16.toMeshZ.xyz, i_16.toMeshX.xyz);
    vec3 z_5 = cross(i_16.toMeshX.xyz, i_16.toMeshY.xyz);
    return ((((q_7.x * x_23) + (q_7.y * y_13)) + (q_7.z * z_5)) / vec3(dot(i_16.toMeshX.xyz, x_23)));
}

Surface fetchSurface(uint i_18) {
    vec4 _e2 = tableTexel(9u, i_18);
    vec4 _e4 = tableTexel(10u, i_18);
    vec4 _e6 = tableTexel(11u, i_18);
    vec4 _e8 = tableTexel(12u, i_18);
    vec4 _e10 = tableTexel(13u, i_18);
    return Surface(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.xyz, _e10.w);
}

LightSample samplePoint(Emitter e_20, vec3 point_18) {
    vec3 toLight_8 = (e_20.position - point_18);
    float distance_9 = length(toLight_8);
    float safe = max(distance_9, 1e-15);
    return LightSample((toLight_8 / vec3(safe)), distance_9, (e_20.radiance / vec3((safe * safe))), pick((distance_9 > 1e-15), 1.0, 0.0), true);
}

LightSample sampleSpot(Emitter e_21, vec3 point_19) {
    LightSample s_8 = LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, false);
    LightSample _e2 = samplePoint(e_21, point_19);
    s_8 = _e2;
    vec3 _e5 = s_8.direction;
    float _e6 = spotFalloff(e_21, _e5);
    vec3 _e8 = s_8.radiance;
    s_8.radiance = (_e8 * _e6);
    float _e12 = s_8.pdf;
    s_8.pdf = pick((_e6 > 0.0), _e12, 0.0);
    LightSample _e17 = s_8;
    return _e17;
}

LightSample sampleDirectional(Emitter e_22, vec2 u_16) {
    bool delta = (e_22.area == 0.0);
    ConeDirection _e10 = sampleCone(-(e_22.u), (e_22.area / 6.2831855), u_16);
    return LightSample(_e10.direction, 1e30, e_22.radiance, pick(delta, 1.0, (1.0 / max(e_22.area, 1e-31))), delta);
}

vec4 environmentTexel(uint column_1, uint row_10) {
    vec4 _e5 = texelFetch(environment, ivec2(uvec2(column_1, row_10)), 0);
    return _e5;
}

vec4 fetchEntries(Table t_4, uint pair) {
    float _e5 = frame.environmentSize.x;
    uint width_2 = uint(_e5);
    uint i_27 = (t_4.first + pair);
    uint row_11 = (i_27 / width_2);
    vec4 _e12 = environmentTexel((i_27 - (row_11 * width_2)), row_11);
    return _e12;
}

vec2 sharesBeyond(vec4 pair_1, uint digits, uint fine) {
    uvec2 further = (uvec2(pair_1.yw) & uvec2(4095u));
    return ((pair_1.xz - vec2(float(digits))) + ((vec2(further) - vec2(float(fine))) * 0.00024414063));
}

Choice chooseEntry(Table t_5, uint digits_1, uint fine_1) {
    uint low = 0u;
    uint high = 0u;
    vec2 ends = vec2(1.0);
    uint step_ = 0u;
    uint pairs = ((t_5.entries + 1u) / 2u);
    uint part = ((((digits_1 >> 12u) * t_5.entries) + (((digits_1 & 4095u) * t_5.entries) >> 12u)) >> 12u);
    vec4 _e23 = fetchEntries(t_5, (part / 2u));
    low = (uint(pick(((part & 1u) == 1u), _e23.w, _e23.y)) >> 12u);
    high = pairs;
    while(true) {
        uint _e41 = low;
        uint _e42 = step_;
        uint _e47 = low;
        uint _e48 = high;
        uint _e52 = high;
        uint next = pick((_e52 < pairs), ((_e47 + _e48) / 2u), min((_e41 + _e42), (pairs - 1u)));
        vec4 _e55 = fetchEntries(t_5, next);
        vec2 _e56 = sharesBeyond(_e55, digits_1, fine_1);
        bool found_10 = (_e56.y > 0.0);
        vec2 _e60 = ends;
        ends = pick(found_10, _e56, _e60);
        uint _e62 = high;
        high = pick(found_10, next, _e62);
        uint _e66 = low;
        low = pick(found_10, _e66, (next + 1u));
        uint _e69 = step_;
        step_ = ((2u * _e69) + 1u);
        uint _e73 = low;
        uint _e74 = high;
        if ((_e73 >= _e74)) {
            break;
        }
    }
    uint _e76 = high;
    uint pair_4 = min(_e76, (pairs - 1u));
    vec4 _e84 = fetchEntries(t_5, (max(pair_4, 1u) - 1u));
    vec2 _e85 = sharesBeyond(_e84, digits_1, fine_1);
    float before_2 = _e85.y;
    float none = -((float(digits_1) + (float(fine_1) * 0.00024414063)));
    float _e94 = ends.x;
    bool isFirst_1 = (_e94 > 0.0);
    float _e98 = ends.x;
    float start_1 = pick(isFirst_1, pick((pair_4 == 0u), none, before_2), _e98);
    float _e104 = ends.y;
    float _e106 = ends.x;
    float end = pick(isFirst_1, _e106, _e104);
    return Choice(min(((2u * pair_4) + pick(isFirst_1, 0u, 1u)), (t_5.entries - 1u)), clamp((-(start_1) / max((end - start_1), 1e-37)), 0.0, 1.0));
}

ChosenCell chooseCell(vec2 u_17) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_2 = uvec2(_e3);
    uvec2 digits_4 = uvec2((u_17 * 16777216.0));
    uint _e13 = mixBits((digits_4.x ^ (digits_4.y * 2654435761u)));
    uint columns = ((size_2.x + 1u) / 2u);
    uint tables = (size_2.x * size_2.y);
    Choice _e29 = chooseEntry(Table(tables, (size_2.y + 1u)), digits_4.y, (_e13 & 4095u));
    Choice _e44 = chooseEntry(Table(((tables + ((size_2.y + 2u) / 2u)) + (_e29.entry * columns)), size_2.x), digits_4.x, (_e13 >> 20u));
    return ChosenCell(uvec2(_e44.entry, _e29.entry), vec2(_e44.rest, _e29.rest));
}

Corners environmentCorners(uvec2 cell) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_3 = uvec2(_e3);
    uint left_1 = (pick((cell.x == 0u), size_3.x, cell.x) - 1u);
    uint right = pick((cell.x == size_3.x), 0u, cell.x);
    uint upper = (max(cell.y, 1u) - 1u);
    uint lower = min(cell.y, (size_3.y - 1u));
    vec4 above_2 = vec4(1.0, 1.0, 1.0, pick((cell.y == 0u), -1.0, 1.0));
    vec4 below = vec4(1.0, 1.0, 1.0, pick((cell.y == size_3.y), -1.0, 1.0));
    vec4 _e49 = environmentTexel(left_1, upper);
    vec4 _e51 = environmentTexel(right, upper);
    vec4 _e53 = environmentTexel(left_1, lower);
    vec4 _e55 = environmentTexel(right, lower);
    return Corners((above_2 * _e49), (above_2 * _e51), (below * _e53), (below * _e55));
}

float linearSample(float u_18, float a_3, float b_4) {
    vec2 ends_2 = (vec2(a_3, b_4) / vec2(max((a_3 + b_4), 1e-37)));
    return min((u_18 / max((ends_2.x + sqrt(mix((ends_2.x * ends_2.x), (ends_2.y * ends_2.y), u_18))), 1e-9)), 1.0);
}

EnvironmentLight lightWithin(Corners k, vec2 at, float sine) {
    vec4 light_2 = mix(mix(k.a, k.b, at.x), mix(k.c, k.d, at.x), at.y);
    return EnvironmentLight(light_2.xyz, (max(light_2.w, 0.0) / sine));
}

EnvironmentSample sampleEnvironment(vec2 u_19) {
    vec2 size_4 = frame.environmentSize;
    ChosenCell _e4 = chooseCell(u_19);
    Corners _e6 = environmentCorners(_e4.cell);
    vec2 cell_1 = vec2(_e4.cell);
    bvec2 atPole = bvec2((cell_1.y == 0.0), (cell_1.y == size_4.y));
    float _e32 = linearSample(_e4.rest.y, max((_e6.a.w + _e6.b.w), 0.0), max((_e6.c.w + _e6.d.w), 0.0));
    float t_13 = ((_e32 * pick(any(atPole), 0.5, 1.0)) + pick(atPole.x, 0.5, 0.0));
    float _e55 = linearSample(_e4.rest.x, mix(_e6.a.w, _e6.c.w, t_13), mix(_e6.b.w, _e6.d.w, t_13));
    bool isLower = ((2.0 * cell_1.y) > size_4.y);
    float fromPole = pick(isLower, ((size_4.y - cell_1.y) + (0.5 - t_13)), (cell_1.y + (t_13 - 0.5)));
    vec2 _e76 = cosineAndSine((fromPole * (3.1415927 / size_4.y)));
    float _e85 = frame.environmentTurn;
    float halfTurns = (2.0 * (((cell_1.x + (_e55 - 0.5)) / size_4.x) - _e85));
    float nearest_1 = floor((halfTurns + 0.5));
    bool back = (fract((0.5 * nearest_1)) > 0.0);
    vec2 _e100 = cosineAndSine(((halfTurns - nearest_1) * 3.1415927));
    vec2 phi_1 = (_e100 * pick(back, -1.0, 1.0));
    float sine_4 = max(_e76.y, 1e-9);
    vec3 direction_23 = vec3((sine_4 * phi_1.y), pick(isLower, -(_e76.x), _e76.x), (-(sine_4) * phi_1.x));
    EnvironmentLight _e119 = lightWithin(_e6, vec2(_e55, t_13), sine_4);
    return EnvironmentSample(direction_23, _e119);
}

vec3 sky(vec3 direction_11) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_11.y, 0.0));
}

LightSample sampleSky(vec2 u_20) {
    EnvironmentSample s_9 = EnvironmentSample(vec3(0.0), EnvironmentLight(vec3(0.0), 0.0));
    ConeDirection _e6 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_20);
    s_9 = EnvironmentSample(_e6.direction, white);
    const bool _e12 = hasEnvironment;
    if (_e12) {
        EnvironmentSample _e13 = sampleEnvironment(u_20);
        s_9 = _e13;
    }
    vec3 _e15 = s_9.direction;
    vec3 _e18 = s_9.light.radiance;
    vec3 _e20 = s_9.direction;
    vec3 _e21 = sky(_e20);
    float _e25 = s_9.light.pdf;
    return LightSample(_e15, 1e30, (_e18 * _e21), _e25, false);
}

bool isPlane(uint i_19) {
    uint _e4 = frame.shapeEnds.z;
    uint _e9 = frame.shapeEnds.w;
    return pick((i_19 >= _e4), (i_19 < _e9), false);
}

vec3 boxNormal(vec3 origin_8, vec3 direction_12, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_8, direction_12, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_14 = pick(entering, _e5.near, _e5.far);
    vec3 side_3 = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_12, vec3(0.0))));
    bool onX_1 = (crossed.x == t_14);
    bool onY_1 = pick(!(onX_1), (crossed.y == t_14), false);
    return (side_3 * mix(vec3(0.0), vec3(1.0), bvec3(onX_1, onY_1, !(pick(onX_1, true, onY_1)))));
}

bool isBox(uint i_20) {
    uint _e4 = frame.shapeEnds.x;
    uint _e9 = frame.shapeEnds.y;
    return pick((i_20 >= _e4), (i_20 < _e9), false);
}

bool isSphere(uint i_21) {
    uint _e4 = frame.shapeEnds.x;
    return (i_21 < _e4);
}

uint kindOf(uint code_1) {
    return (code_1 & 3u);
}

Layers fetchLayers(uint i_23) {
    vec4 _e2 = tableTexel(0u, i_23);
    vec4 _e4 = tableTexel(1u, i_23);
    vec4 _e6 = tableTexel(2u, i_23);
    vec4 _e8 = tableTexel(3u, i_23);
    vec4 _e10 = tableTexel(4u, i_23);
    vec4 _e12 = tableTexel(5u, i_23);
    vec4 _e14 = tableTexel(6u, i_23);
    return Layers(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xy, _e8.z, _e8.w, _e10.x, _e10.y, _e10.z, _e10.w, _e12.x, _e12.y, _e12.z, _e12.w, _e14.x, _e14.y, _e14.z, _e14.w);
}

vec3 fromOctahedral(uint code_5) {
    vec2 p_29 = ((vec2(float((code_5 & 65535u)), float((code_5 >> 16u))) * 3.051851e-5) - vec2(1.0));
    float z_6 = ((1.0 - abs(p_29.x)) - abs(p_29.y));
    vec2 folded = ((vec2(1.0) - abs(p_29.yx)) * mix(vec2(1.0), vec2(-1.0), lessThan(p_29, vec2(0.0))));
    return normalize(vec3(pick((z_6 < 0.0), folded, p_29), z_6));
}

bool isSmooth(uint code_6) {
    return ((code_6 & 32u) != 0u);
}

vec3 bent(vec3 g_3, vec3 o_1, vec3 n_1) {
    float oz = max(dot(o_1, g_3), 0.0);
    float least_1 = min((0.9 * oz), 0.01);
    vec3 across_3 = (n_1 - (dot(n_1, g_3) * g_3));
    vec3 x_24 = (across_3 * inversesqrt(max(dot(across_3, across_3), 1e-20)));
    float ox = dot(o_1, x_24);
    float a_7 = max(((ox * ox) + (oz * oz)), 1e-20);
    float b_10 = (2.0 * (a_7 + (oz * least_1)));
    float c_5 = ((least_1 + oz) * (least_1 + oz));
    float root = sqrt(max(((b_10 * b_10) - ((4.0 * a_7) * c_5)), 0.0));
    float z2_ = clamp(((0.25 * pick((ox < 0.0), (b_10 + root), (b_10 - root))) / a_7), 0.0, 1.0);
    vec3 raised = ((sqrt((1.0 - z2_)) * x_24) + (sqrt(z2_) * g_3));
    vec3 reflected = (((2.0 * dot(n_1, o_1)) * n_1) - o_1);
    return pick((dot(g_3, reflected) >= least_1), n_1, raised);
}

vec3 validNormal(vec3 geometric, vec3 direction_13, vec3 mapped, vec3 otherwise) {
    float size_5 = dot(mapped, mapped);
    vec3 n_4 = pick((size_5 > 0.0), (mapped * inversesqrt(max(size_5, 1e-37))), otherwise);
    float side_4 = pick((dot(geometric, direction_13) > 0.0), -1.0, 1.0);
    vec3 _e21 = bent((side_4 * geometric), -(direction_13), (side_4 * n_4));
    return (side_4 * _e21);
}

vec3 agreed(vec3 geometric_1, vec3 shading, vec3 direction_14, bool isClear) {
    bool agree = ((dot(geometric_1, direction_14) > 0.0) == (dot(shading, direction_14) > 0.0));
    return pick(pick(isClear, !(agree), false), geometric_1, shading);
}

vec3 tangentAbout(vec3 normal_12) {
    vec3 east = vec3(normal_12.z, 0.0, -(normal_12.x));
    float length2_ = dot(east, east);
    return pick((length2_ > 1e-12), (east * inversesqrt(max(length2_, 1e-20))), vec3(1.0, 0.0, 0.0));
}

vec3 grainAt(vec3 normal_13, vec3 tangent, vec3 bitangent, vec2 grain) {
    vec3 along_3 = (tangent - (dot(tangent, normal_13) * normal_13));
    float size_6 = dot(along_3, along_3);
    bool own_7 = (size_6 > (1e-12 * dot(tangent, tangent)));
    vec3 _e12 = tangentAbout(normal_13);
    vec3 t_15 = pick(own_7, (along_3 * inversesqrt(max(size_6, 1e-37))), _e12);
    vec3 across_4 = cross(normal_13, t_15);
    float hand = pick(pick(own_7, (dot(across_4, bitangent) < 0.0), false), -1.0, 1.0);
    return ((grain.x * t_15) + ((grain.y * hand) * across_4));
}

Basis basisAbout(vec3 n_2) {
    float side_5 = pick((n_2.z >= 0.0), 1.0, -1.0);
    float a_8 = (-1.0 / (side_5 + n_2.z));
    float b_11 = ((n_2.x * n_2.y) * a_8);
    return Basis(vec3((1.0 + (((side_5 * n_2.x) * n_2.x) * a_8)), (side_5 * b_11), (-(side_5) * n_2.x)), vec3(b_11, (side_5 + ((n_2.y * n_2.y) * a_8)), -(n_2.y)), n_2);
}

Basis basisAlong(vec3 n_3, vec3 x_16) {
    vec3 tangent_2 = normalize((x_16 - (dot(x_16, n_3) * n_3)));
    return Basis(tangent_2, cross(n_3, tangent_2), n_3);
}

vec3 toLocal(Basis b_5, vec3 v_9) {
    return vec3(dot(v_9, b_5.tangent), dot(v_9, b_5.bitangent), dot(v_9, b_5.normal));
}

vec3 schlick(vec3 f0_, float cosine_1) {
    float m_3 = max((1.0 - cosine_1), 0.0);
    float m2_ = (m_3 * m_3);
    return (f0_ + ((vec3(1.0) - f0_) * ((m2_ * m2_) * m_3)));
}

float coatReflectance(float coat, float cosine_2) {
    vec3 _e4 = schlick(vec3(0.04), cosine_2);
    return (coat * _e4.x);
}

vec3 heroColor(vec3 throughput, float u_22) {
    vec3 share_3 = (throughput / vec3(max(dot(throughput, vec3(1.0)), 1e-30)));
    bool isRed = (u_22 < share_3.x);
    bool isBlue = pick(pick(!(isRed), (u_22 >= (share_3.x + share_3.y)), false), (share_3.z > 0.0), false);
    vec3 chosen_2 = pick(isRed, vec3(1.0, 0.0, 0.0), pick(isBlue, vec3(0.0, 0.0, 1.0), vec3(0.0, 1.0, 0.0)));
    return (chosen_2 / vec3(max(dot(chosen_2, share_3), 1e-6)));
}

float nextHash(inout Sampler s_12) {
    uint _e3 = s_12.key;
    s_12.key = (_e3 + 1u);
    uint _e7 = s_12.key;
    uint _e9 = s_12.salt;
    uint _e11 = mixBits((_e7 ^ _e9));
    uint _e13 = s_12.sample_;
    uint _e17 = s_12.place;
    uint _e20 = mixBits((_e11 + ((_e13 * 256u) | _e17)));
    float _e21 = unitFloat(_e20);
    return _e21;
}

vec2 ellipticAlpha(float alpha, float strength) {
    return pick((strength > 0.0), vec2(mix(alpha, 1.0, (strength * strength)), max(alpha, 0.001)), vec2(alpha));
}

float dispersedIndex(float ior, float dispersion, vec3 hero) {
    float side_6 = (pick((hero.z > 0.0), 1.0, 0.0) - pick((hero.x > 0.0), 1.0, 0.0));
    return max((ior + (((side_6 * (ior - 1.0)) * 0.025) * dispersion)), 1.0);
}

float greatest(vec3 v_10) {
    return max(max(v_10.x, v_10.y), v_10.z);
}

float sheenAlbedo(float cosine_3, float roughness) {
    float u_29 = (((sqrt(sqrt(clamp(cosine_3, 0.0001, 1.0))) - 0.1) / 0.45) - 1.0);
    float v_15 = (((sqrt(max(roughness, 0.07)) - 0.264575) / 0.367712) - 1.0);
    vec3 low_5 = (vec3(0.746962, 0.0397496, 0.224802) + (u_29 * (vec3(-0.448339, 0.3406, -0.509736) + (u_29 * (vec3(-0.196284, 0.0161825, -0.50469) + (u_29 * (vec3(0.0587112, 0.187983, 0.191769) + (u_29 * (vec3(-0.182064, 0.425384, 0.971703) + (u_29 * (vec3(0.0763965, -0.331055, 0.616069) + (u_29 * (vec3(0.0893496, -0.409073, -0.445006) + (u_29 * vec3(-0.0525425, 0.0277158, -0.421496)))))))))))))));
    vec3 high_3 = (vec3(-0.0321953, -0.190573, 0.0715297) + (u_29 * (vec3(0.492365, -0.201291, -0.00570256) + (u_29 * (vec3(0.833264, 0.765625, -1.06831) + (u_29 * (vec3(-1.29238, 0.71056, 0.237437) + (u_29 * (vec3(-2.81818, -0.673857, 2.17806) + (u_29 * (vec3(0.500911, -0.777981, 0.0143213) + (u_29 * (vec3(1.97956, 0.108218, -1.28939) + (u_29 * vec3(0.324871, 0.21472, -0.194708)))))))))))))));
    float v2_ = (v_15 * v_15);
    float root_1 = dot((low_5 + ((v2_ * v_15) * high_3)), vec3(1.0, v_15, v2_));
    float albedo = (root_1 * root_1);
    return (albedo + (0.005 * max(albedo, 1.0)));
}

float singleScatteringAlbedo(float cosine_4, float alpha_1) {
    float x_25 = (cosine_4 / (cosine_4 + alpha_1));
    vec4 byAlpha = (vec4(0.887807, 0.309386, -0.270728, 0.0252433) + (x_25 * (vec4(1.08526, -3.21434, -1.87718, 1.61195) + (x_25 * (vec4(-5.18071, 10.7648, 6.30913, -8.09265) + (x_25 * (vec4(7.80474, -12.743, -24.1046, 25.2536) + (x_25 * vec4(-3.60041, 4.60906, 23.1225, -22.9342)))))))));
    float a2_ = (alpha_1 * alpha_1);
    return min(dot(byAlpha, vec4(1.0, alpha_1, a2_, (a2_ * alpha_1))), 1.0);
}

float cosineInAir(float cosine_5, float ratio) {
    float sine2_1 = ((1.0 - (cosine_5 * cosine_5)) / (ratio * ratio));
    return pick((ratio < 1.0), sqrt(max((1.0 - sine2_1), 0.0)), cosine_5);
}

bool reflectsAll(float cosine_7, float ratio_1) {
    return pick((ratio_1 < 1.0), ((1.0 - (cosine_7 * cosine_7)) >= (ratio_1 * ratio_1)), false);
}

float mean3_(vec3 v_11) {
    return dot(v_11, vec3(0.33333334));
}

vec3 metallicRoughnessF0_(vec3 baseColor, float metallic) {
    return mix(vec3(0.04), baseColor, metallic);
}

vec3 metallicRoughnessDiffuse(vec3 baseColor_1, float metallic_1, float cosine_9) {
    vec3 _e7 = schlick(vec3(0.04), cosine_9);
    return (((1.0 - metallic_1) * (1.0 - _e7.x)) * baseColor_1);
}

float specularShare(vec3 baseColor_2, float metallic_2, float cosine_10) {
    vec3 _e3 = metallicRoughnessF0_(baseColor_2, metallic_2);
    vec3 _e4 = schlick(_e3, cosine_10);
    float specular = dot(_e4, vec3(1.0));
    vec3 _e9 = metallicRoughnessDiffuse(baseColor_2, metallic_2, 1.0);
    float diffuse = dot(_e9, vec3(1.0));
    return (specular / max((specular + diffuse), 1e-20));
}

float indexRatio(float eta_2, float z_1, bool thin) {
    return pick(pick((z_1 < 0.0), !(thin), false), (1.0 / eta_2), eta_2);
}

float reflectionBound(vec3 wo, float alpha_2) {
    float s_30 = (1.0 + length(wo.xy));
    float s2_ = (s_30 * s_30);
    float a2_1 = (alpha_2 * alpha_2);
    return (((1.0 - a2_1) * s2_) / (s2_ + ((a2_1 * wo.z) * wo.z)));
}

float stretched(vec3 w_5, float alpha_3) {
    return sqrt(((w_5.z * w_5.z) + ((alpha_3 * alpha_3) * dot(w_5.xy, w_5.xy))));
}

vec3 sampleCosine(vec2 u_23) {
    float radius_2 = sqrt(u_23.x);
    float phi_2 = ((6.2831855 * u_23.y) - 3.1415927);
    return normalize(vec3((radius_2 * cos(phi_2)), (radius_2 * sin(phi_2)), sqrt((1.0 - u_23.x))));
}

vec3 sampleVisibleNormal(vec3 wo_2, float alpha_4, float bound, vec2 u_24) {
    float _e8 = stretched(wo_2, alpha_4);
    vec3 w_9 = (vec3((alpha_4 * wo_2.xy), wo_2.z) / vec3(_e8));
    float phi_3 = ((6.2831855 * u_24.x) - 3.1415927);
    float drop = (u_24.y * (1.0 + (bound * w_9.z)));
    float sine_5 = sqrt(max((drop * (2.0 - drop)), 0.0));
    vec3 h_8 = (w_9 + vec3((sine_5 * cos(phi_3)), (sine_5 * sin(phi_3)), (1.0 - drop)));
    return normalize(vec3((alpha_4 * h_8.xy), max(h_8.z, 1e-7)));
}

vec3 sampleFacet(float alpha_5, bool isMirror, Outgoing o_3, vec2 u_25) {
    float side_7 = pick((o_3.wo.z < 0.0), -1.0, 1.0);
    vec3 _e16 = sampleVisibleNormal((o_3.wo * side_7), max(alpha_5, 0.001), o_3.bound, u_25);
    return (pick(isMirror, vec3(0.0, 0.0, 1.0), _e16) * side_7);
}

vec3 conductorFresnel(float cosine_11, vec3 eta_3, vec3 k_1) {
    float cosine2_ = (cosine_11 * cosine_11);
    float sine2_2 = (1.0 - cosine2_);
    vec3 difference_1 = (((eta_3 * eta_3) - (k_1 * k_1)) - vec3(sine2_2));
    vec3 a2PlusB2_ = sqrt(((difference_1 * difference_1) + ((((4.0 * eta_3) * eta_3) * k_1) * k_1)));
    vec3 larger_2 = sqrt(((0.5 * (a2PlusB2_ + abs(difference_1))) + vec3(1e-20)));
    vec3 smaller_1 = ((eta_3 * k_1) / larger_2);
    vec3 a_9 = mix(smaller_1, larger_2, greaterThan(difference_1, vec3(0.0)));
    vec3 b_12 = mix(larger_2, smaller_1, greaterThan(difference_1, vec3(0.0)));
    vec3 b2_ = ((b_12 * b_12) + vec3(1e-20));
    vec3 acrossFar = (a_9 + vec3(cosine_11));
    vec3 acrossNear = (a_9 - vec3(cosine_11));
    vec3 across_5 = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a_9 * cosine_11) + vec3(sine2_2));
    vec3 alongNear = ((a_9 * cosine_11) - vec3(sine2_2));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across_5) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor_3, vec3 eta_4, vec3 k_2, float cosine_12) {
    float constants = dot((eta_4 + k_2), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_12, eta_4, k_2);
    return pick((constants > 0.0), _e8, baseColor_3);
}

float dielectricFresnel(float cosine_13, float ratio_2) {
    float inside2_ = (((ratio_2 - 1.0) * (ratio_2 + 1.0)) + (cosine_13 * cosine_13));
    float inside_3 = sqrt(max(inside2_, 0.0));
    float across_6 = ((cosine_13 - inside_3) / (cosine_13 + inside_3));
    float along_4 = ((((ratio_2 * ratio_2) * cosine_13) - inside_3) / (((ratio_2 * ratio_2) * cosine_13) + inside_3));
    return pick((inside2_ > 0.0), (0.5 * ((across_6 * across_6) + (along_4 * along_4))), 1.0);
}

float glassReflectance(float cosine_14, float ratio_3, bool thin_1) {
    float _e3 = dielectricFresnel(cosine_14, ratio_3);
    return pick(thin_1, ((2.0 * _e3) / (1.0 + _e3)), _e3);
}

vec3 refracted(vec3 wo_3, vec3 h_2, float ratio_5) {
    float cosine_22 = dot(wo_3, h_2);
    float inside_4 = sqrt(max((((ratio_5 - 1.0) * (ratio_5 + 1.0)) + (cosine_22 * cosine_22)), 0.0));
    return ((((cosine_22 - inside_4) * h_2) - wo_3) / vec3(ratio_5));
}

float ellipticBound(vec3 wo_4, vec2 alpha_6) {
    float s_31 = (1.0 + length(wo_4.xy));
    float s2_1 = (s_31 * s_31);
    float least_2 = min(alpha_6.x, alpha_6.y);
    float a2_2 = (least_2 * least_2);
    return (((1.0 - a2_2) * s2_1) / (s2_1 + ((a2_2 * wo_4.z) * wo_4.z)));
}

float ellipticStretched(vec3 w_6, vec2 alpha_7) {
    vec2 scaled = (alpha_7 * w_6.xy);
    return sqrt(((w_6.z * w_6.z) + dot(scaled, scaled)));
}

vec3 sampleEllipticNormal(vec3 wo_5, vec2 alpha_8, float bound_1, vec2 u_26) {
    float _e8 = ellipticStretched(wo_5, alpha_8);
    vec3 w_10 = (vec3((alpha_8 * wo_5.xy), wo_5.z) / vec3(_e8));
    float phi_4 = ((6.2831855 * u_26.x) - 3.1415927);
    float drop_1 = (u_26.y * (1.0 + (bound_1 * w_10.z)));
    float sine_6 = sqrt(max((drop_1 * (2.0 - drop_1)), 0.0));
    vec3 h_9 = (w_10 + vec3((sine_6 * cos(phi_4)), (sine_6 * sin(phi_4)), (1.0 - drop_1)));
    return normalize(vec3((alpha_8 * h_9.xy), max(h_9.z, 1e-7)));
}

vec3 toWorld0_(Basis b_6, vec3 v_12) {
    return (((v_12.x * b_6.tangent) + (v_12.y * b_6.bitangent)) + (v_12.z * b_6.normal));
}

vec3 mirrored(vec3 wo_6) {
    return vec3(-(wo_6.xy), wo_6.z);
}

float facetDensity(vec3 h_4, float alpha_9) {
    float slope = max(((dot(h_4.xy, h_4.xy) / (alpha_9 * alpha_9)) + (h_4.z * h_4.z)), 1.0);
    return (0.31830987 / (((alpha_9 * alpha_9) * slope) * slope));
}

bool hidesApart(uint code_11) {
    return ((code_11 & 64u) != 0u);
}

BsdfSample completed(BsdfSample drawn_2, vec4 value_1) {
    float pdf_4 = pick((drawn_2.pdf <= 0.0), 0.0, value_1.w);
    vec3 weight_1 = pick((pdf_4 > 0.0), (value_1.xyz / vec3(max(pdf_4, 1e-30))), vec3(0.0));
    return BsdfSample(drawn_2.direction, pick(drawn_2.delta, drawn_2.pdf, pdf_4), pick(drawn_2.delta, drawn_2.weight, weight_1), drawn_2.delta);
}

float ellipticDensity(vec3 h_5, vec2 alpha_10) {
    vec2 scaled_1 = (h_5.xy / alpha_10);
    float slope_1 = max((dot(scaled_1, scaled_1) + (h_5.z * h_5.z)), 1.0);
    return (0.31830987 / (((alpha_10.x * alpha_10.y) * slope_1) * slope_1));
}

vec3 indexOf(vec3 f0_1) {
    vec3 root_2 = sqrt(min(f0_1, vec3(0.9999)));
    return ((vec3(1.0) + root_2) / (vec3(1.0) - root_2));
}

vec3 sensitivity(float difference, vec3 shift) {
    float phase = (6.2831855e-9 * difference);
    vec4 mean = vec4(1681000.0, 1795300.0, 2208400.0, 2239900.0);
    vec4 variance = vec4(4327800000.0, 9304600000.0, 6612100000.0, 4528200000.0);
    vec4 height_2 = vec4(0.84659, 1.000222, 1.001122, 0.153868);
    vec4 turns = ((mean * (phase * 0.15915494)) + vec4(shift, shift.x));
    vec4 lobes = ((height_2 * cos((6.2831855 * (turns - roundEven(turns))))) * exp((-(variance) * (phase * phase))));
    float x_26 = (lobes.x + lobes.w);
    return vec3((((3.2404542 * x_26) - (1.5371385 * lobes.y)) - (0.4985314 * lobes.z)), (((-0.969266 * x_26) + (1.8760108 * lobes.y)) + (0.041556 * lobes.z)), (((0.0556434 * x_26) - (0.2040259 * lobes.y)) + (1.0572252 * lobes.z)));
}

vec3 filmReflectance(vec3 f0_2, float filmIor, float thickness, float cosine_17) {
    vec3 sum = vec3(0.0);
    vec3 amplitude = vec3(0.0);
    float order = 1.0;
    float sine2_3 = ((1.0 - (cosine_17 * cosine_17)) / (filmIor * filmIor));
    float within_2 = sqrt(max((1.0 - sine2_3), 0.0));
    float first_1 = ((filmIor - 1.0) / (filmIor + 1.0));
    vec3 _e21 = schlick(vec3((first_1 * first_1)), cosine_17);
    float r12_ = _e21.x;
    float t121_ = (1.0 - r12_);
    vec3 _e28 = indexOf((f0_2 + vec3(0.0001)));
    vec3 second_1 = ((_e28 - vec3(filmIor)) / (_e28 + vec3(filmIor)));
    vec3 _e35 = schlick((second_1 * second_1), within_2);
    vec3 r123_ = clamp((r12_ * _e35), vec3(1e-5), vec3(0.9999));
    vec3 once = sqrt(r123_);
    vec3 rs = (((t121_ * t121_) * _e35) / (vec3(1.0) - r123_));
    vec3 shift_1 = (vec3(0.5) + mix(vec3(0.0), vec3(0.5), lessThan(_e28, vec3(filmIor))));
    float difference_2 = (((2.0 * filmIor) * thickness) * within_2);
    sum = (vec3(r12_) + rs);
    amplitude = (rs - vec3(t121_));
    while(true) {
        vec3 _e71 = amplitude;
        amplitude = (_e71 * once);
        vec3 _e73 = sum;
        vec3 _e74 = amplitude;
        float _e77 = order;
        float _e79 = order;
        vec3 _e81 = sensitivity((_e77 * difference_2), (_e79 * shift_1));
        sum = (_e73 + ((2.0 * _e74) * _e81));
        float _e84 = order;
        order = (_e84 + 1.0);
        float _e87 = order;
        if ((_e87 > 2.5)) {
            break;
        }
    }
    vec3 _e90 = sum;
    return clamp(_e90, vec3(0.0), vec3(1.0));
}

float shadowingExponent(float x_17, float alpha_11) {
    float m_4 = ((1.0 - alpha_11) * (1.0 - alpha_11));
    float a_10 = mix(21.5473, 25.3245, m_4);
    float b_13 = mix(3.82987, 3.32435, m_4);
    float c_6 = mix(0.19823, 0.16801, m_4);
    float d_3 = mix(-1.9776, -1.27393, m_4);
    float e_28 = mix(-4.32054, -4.85967, m_4);
    return (((a_10 / (1.0 + (b_13 * pow(x_17, c_6)))) + (d_3 * x_17)) + e_28);
}

float sheenShadowing(float cosine_19, float alpha_12) {
    float x_27 = clamp(cosine_19, 1e-6, 1.0);
    bool isLow = (x_27 < 0.5);
    float _e12 = shadowingExponent(pick(isLow, x_27, max((1.0 - x_27), 1e-6)), alpha_12);
    float _e14 = shadowingExponent(0.5, alpha_12);
    return exp(pick(isLow, _e12, ((2.0 * _e14) - _e12)));
}

float whiteSheen(vec3 wo_7, vec3 wi_4, float alpha_13) {
    vec3 m_5 = (wo_7 + wi_4);
    float m2_1 = max(dot(m_5, m_5), 1e-20);
    float sine2_4 = clamp((dot(m_5.xy, m_5.xy) / m2_1), 0.0, 1.0);
    float power_1 = (0.5 / alpha_13);
    float density = (((2.0 + (2.0 * power_1)) * 0.15915494) * pick((sine2_4 < 1e-20), 0.0, exp((power_1 * log(max(sine2_4, 1e-20))))));
    float zo = max(wo_7.z, 1e-6);
    float _e38 = sheenShadowing(wo_7.z, alpha_13);
    float _e42 = sheenShadowing(wi_4.z, alpha_13);
    return (density / ((4.0 * zo) * ((1.0 + _e38) + _e42)));
}

float sheenAlpha(float roughness_1) {
    float r_6 = max(roughness_1, 0.07);
    return (r_6 * r_6);
}

bool crosses(vec3 geometric_2, vec3 a_4, vec3 b_7) {
    return ((dot(geometric_2, a_4) > 0.0) != (dot(geometric_2, b_7) > 0.0));
}

float max3_(vec3 v_13) {
    return max(max(v_13.x, v_13.y), v_13.z);
}

bool isFlat(uint i_25) {
    uint _e4 = frame.shapeEnds.y;
    return (i_25 >= _e4);
}

vec2 quadrantAngles(vec2 x_18, vec2 y_7) {
    vec2 low_6 = min(x_18, y_7);
    vec2 high_4 = max(x_18, y_7);
    bvec2 middle_2 = greaterThan(low_6, (0.41421357 * high_4));
    vec2 r_7 = (mix(low_6, (low_6 - high_4), middle_2) / max(mix(high_4, (low_6 + high_4), middle_2), vec2(1e-30)));
    vec2 z_7 = (r_7 * r_7);
    vec2 series_1 = ((((((0.080537446 * z_7) - vec2(0.13877685)) * z_7) + vec2(0.19977711)) * z_7) - vec2(0.3333295));
    vec2 angle_1 = (mix(vec2(0.0), vec2(0.7853982), middle_2) + (((series_1 * z_7) * r_7) + r_7));
    return mix(angle_1, (vec2(1.5707964) - angle_1), greaterThan(y_7, x_18));
}

EnvironmentLight lookUpEnvironment(vec3 direction_15) {
    vec2 size_7 = frame.environmentSize;
    float sine_7 = max(length(direction_15.xz), 1e-9);
    vec2 _e15 = quadrantAngles(abs(vec2(direction_15.z, direction_15.y)), vec2(abs(direction_15.x), sine_7));
    float turn_1 = (pick((direction_15.z > 0.0), (3.1415927 - _e15.x), _e15.x) * pick((direction_15.x < 0.0), -1.0, 1.0));
    float _e35 = frame.environmentTurn;
    float column_2 = ((fract(((turn_1 * 0.15915494) + _e35)) * size_7.x) + 0.5);
    float fromPole_1 = ((_e15.y * (size_7.y / 3.1415927)) + 0.5);
    float row_12 = floor(fromPole_1);
    bool isLower_1 = (direction_15.y < 0.0);
    vec2 cell_2 = vec2(floor(column_2), pick(isLower_1, (size_7.y - row_12), row_12));
    float within_3 = (fromPole_1 - row_12);
    vec2 at_4 = vec2((column_2 - cell_2.x), pick(isLower_1, (1.0 - within_3), within_3));
    Corners _e66 = environmentCorners(uvec2(cell_2));
    EnvironmentLight _e67 = lightWithin(_e66, at_4, sine_7);
    return _e67;
}

EnvironmentLight skyLight(vec3 direction_16) {
    EnvironmentLight light = white;
    const bool _e4 = hasEnvironment;
    if (_e4) {
        EnvironmentLight _e5 = lookUpEnvironment(direction_16);
        light = _e5;
    }
    vec3 _e7 = light.radiance;
    vec3 _e8 = sky(direction_16);
    float _e11 = light.pdf;
    return EnvironmentLight((_e7 * _e8), _e11);
}

FarLight skySeen(vec3 direction_17) {
    FarLight far_2 = FarLight(vec3(0.0), 0.0);
    const bool _e7 = hasSky;
    if (_e7) {
        EnvironmentLight _e8 = skyLight(direction_17);
        far_2 = FarLight(_e8.radiance, _e8.pdf);
    }
    FarLight _e12 = far_2;
    return _e12;
}

bool isOnDisc(Emitter e_24, vec3 direction_18) {
    vec3 chord = (direction_18 + e_24.u);
    return ((3.1415927 * dot(chord, chord)) < e_24.area);
}

float directionalPdf(Emitter e_25, vec3 direction_19) {
    bool _e7 = isOnDisc(e_25, direction_19);
    return pick(_e7, (1.0 / max(e_25.area, 1e-31)), 0.0);
}

FarLight farLight(Emitter e_26, vec3 direction_20, FarLight sky_1) {
    FarLight far_3 = FarLight(vec3(0.0), 0.0);
    const bool _e9 = hasSuns;
    if (_e9) {
        bool _e13 = isOnDisc(e_26, direction_20);
        bool seen_1 = pick((e_26.kind == 5.0), _e13, false);
        float _e19 = directionalPdf(e_26, direction_20);
        far_3 = FarLight(pick(seen_1, e_26.radiance, vec3(0.0)), pick(seen_1, _e19, 0.0));
    }
    const bool _e24 = hasSky;
    if (_e24) {
        if ((e_26.kind == 6.0)) {
            far_3 = sky_1;
        }
    }
    FarLight _e28 = far_3;
    return _e28;
}

float farProbability(Emitter e_27, vec3 normal_14, Odds odds_2) {
    float probability_4 = 0.0;
    float estimate_1 = 0.0;
    uint _e5 = frame.emitterCount;
    probability_4 = float(min(_e5, 1u));
    const bool _e11 = hasManyLights;
    if (_e11) {
        uint _e14 = frame.emitterCount;
        if ((_e14 > 1u)) {
            estimate_1 = e_27.power;
            const bool _e20 = hasSuns;
            if (_e20) {
                float grown_1 = max((sqrt(dot(e_27.u, e_27.u)) + e_27.reach), 1e-15);
                float _e29 = estimate_1;
                float _e32 = cosineTowards(e_27, -(e_27.u), grown_1, normal_14);
                estimate_1 = (_e29 * pick((e_27.kind == 5.0), _e32, 1.0));
            }
            float _e39 = estimate_1;
            probability_4 = min((_e39 / max(odds_2.total, 1e-37)), 1.0);
            const bool _e47 = hasLightTree;
            if (_e47) {
                float _e48 = probability_4;
                probability_4 = (_e48 * (1.0 - odds_2.tree));
            }
        }
    }
    float _e53 = probability_4;
    return _e53;
}

void addSkyAndSuns(inout Path p_23) {
    vec3 found_9 = vec3(0.0);
    uint i_26 = 0u;
    vec3 direction_24 = p_23.rays.direction;
    FarLight _e4 = skySeen(direction_24);
    while(true) {
        uint _e10 = i_26;
        Emitter _e11 = fetchEmitter(_e10);
        FarLight _e12 = farLight(_e11, direction_24, _e4);
        vec3 _e15 = p_23.litSide;
        Odds _e17 = p_23.odds;
        float _e18 = farProbability(_e11, _e15, _e17);
        float pdf_5 = (_e12.pdf * _e18);
        vec3 _e20 = found_9;
        float _e23 = p_23.pdf;
        float _e24 = misWeight(_e23, pdf_5);
        float _e26 = p_23.pdf;
        found_9 = (_e20 + (_e12.radiance * pick((_e26 <= 0.0), 1.0, _e24)));
        uint _e34 = i_26;
        i_26 = (_e34 + 1u);
        const bool _e37 = hasSuns;
        const bool _e40 = hasManyLights;
        if (pick(!(_e37), true, !(_e40))) {
            break;
        }
        uint _e43 = i_26;
        uint _e46 = frame.farEmitters;
        if ((_e43 >= _e46)) {
            break;
        }
    }
    vec3 _e49 = p_23.radiance;
    vec3 _e51 = p_23.throughput;
    vec3 _e52 = found_9;
    p_23.radiance = (_e49 + (_e51 * _e52));
    return;
}

void addFarLight(inout Path p_24) {
    const bool _e2 = hasSky;
    const bool _e4 = hasSuns;
    if (pick(_e2, true, _e4)) {
        bool _e7 = p_24.escaped;
        uint _e10 = frame.emitterCount;
        if (pick(_e7, (_e10 > 0u), false)) {
            addSkyAndSuns(p_24);
            return;
        } else {
            return;
        }
    } else {
        return;
    }
}

void main() {
    vec4 fragment_4 = gl_FragCoord;
    Path p_3 = Path(RayPair(vec3(0.0), 0u, LeftTriangle(0u, 0u), 0.0, false, vec3(0.0), false, vec3(0.0), false, 0.0, 0u, 0u), vec3(0.0), vec3(0.0), false, 0u, vec3(0.0), 0.0, vec3(0.0), Odds(0.0, 0.0), Sampler(0u, 0u, 0u, 0u));
    Film film = Film(vec4(0.0), vec4(0.0));
    uvec2 texel_7 = uvec2(fragment_4.xy);
    uint _e6 = frame.relayRow;
    Path _e9 = pathAt((texel_7 - uvec2(0u, _e6)));
    p_3 = _e9;
    addFarLight(p_3);
    uint _e19 = frame.sampleIndex;
    if ((_e19 > 0u)) {
        vec4 _e24 = texelFetch(previousFilm, ivec2(texel_7), 0);
        vec4 _e27 = texelFetch(previousSquares, ivec2(texel_7), 0);
        film = Film(_e24, _e27);
    }
    vec4 _e30 = film.sums;
    vec3 _e32 = p_3.radiance;
    vec4 _e37 = film.squares;
    vec3 _e39 = p_3.radiance;
    vec3 _e41 = p_3.radiance;
    Film _tmp_return = Film((_e30 + vec4(_e32, 1.0)), (_e37 + vec4((_e39 * _e41), 0.0)));
    _fs2p_location0 = _tmp_return.sums;
    _fs2p_location1 = _tmp_return.squares;
    return;
}

