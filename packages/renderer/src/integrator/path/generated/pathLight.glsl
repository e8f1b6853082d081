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

uniform highp usampler2D hit0;

uniform highp usampler2D hit1;

layout(std140) uniform FrameBlock { Frame frame; };

const bool hasSpheres = true;

uniform highp sampler2D sceneTable;

const bool hasBoxes = true;

const bool hasTurnedBoxes = true;

const bool hasQuads = false;

const bool hasMeshes = false;

uniform highp usampler2D geometry;

uniform highp usampler2D texels;

const bool hasOtherLookups = false;

const bool hasMeshLamps = false;

const bool hasManyLights = true;

const bool hasSphereLights = true;

const bool hasQuadLights = false;

const bool hasBoxLights = false;

const bool hasSuns = false;

const bool hasPointLights = false;

const bool hasSky = true;

const bool hasLightTree = false;

const bool hasVariedLamps = false;

const bool hasEnvironment = false;

uniform highp sampler2D environment;

const bool hasLayers = false;

Layers layersHere = Layers(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);

const bool hasMetallicRoughness = false;

const bool hasCoatNormals = false;

vec3 coatNormalHere = vec3(0.0);

const bool hasTextures = false;

const bool hasVertexMore = false;

const bool hasNormalMaps = false;

const bool hasTransmission = false;

const bool hasCoats = false;

const bool hasSheen = false;

const bool hasIridescence = false;

const bool hasGrain = false;

const bool hasGlass = false;

vec3 grainHere = vec3(0.0);

layout(location = 0) out uvec4 _fs2p_location0;
layout(location = 1) out uvec4 _fs2p_location1;
layout(location = 2) out uvec4 _fs2p_location2;
layout(location = 3) out uvec4 _fs2p_location3;
layout(location = 4) out uvec4 _fs2p_location4;
layout(location = 5) out uvec4 _fs2p_location5;
layout(location = 6) out uvec4 _fs2p_location6;
layout(location = 7) out uvec4 _fs2p_location7;

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

PairHit hitAt(uvec2 texel_3) {
    uvec4 met_1 = texelFetch(hit0, ivec2(texel_3), 0);
    uvec4 more = texelFetch(hit1, ivec2(texel_3), 0);
    return PairHit(uintBitsToFloat(met_1.x), met_1.y, (more.z == isHidden), LeftTriangle(met_1.z, met_1.w), uintBitsToFloat(more.xy));
}

bool wasOver(uvec2 texel_4) {
    uvec4 _e3 = texelFetch(hit1, ivec2(texel_4), 0);
    return (_e3.z == isDone);
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

vec3 turned(vec4 q_1, vec3 v_3) {
    vec3 w_2 = vec3(0.0);
    w_2 = v_3;
    const bool _e4 = hasTurnedBoxes;
    if (_e4) {
        vec3 _e5 = rotate(q_1, v_3);
        w_2 = _e5;
    }
    vec3 _e6 = w_2;
    return _e6;
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

PairHit meetBox(PairHit found_2, RayPair p_11, uint i_4) {
    Bounds _e3 = fetchBounds(i_4);
    Extent _e4 = fetchExtent(i_4);
    bool own_6 = (i_4 == p_11.shape);
    vec3 _e11 = turned(_e4.a, (p_11.point - _e3.center));
    vec3 _e14 = turned(_e4.a, p_11.direction);
    float _e20 = intersectBox(_e11, _e14, _e4.b.xyz, p_11.tMin, pick(own_6, p_11.inwards, false));
    vec3 _e23 = turned(_e4.a, p_11.lightDirection);
    float _e29 = intersectBox(_e11, _e23, _e4.b.xyz, p_11.tMin, pick(own_6, p_11.lightInwards, false));
    PairHit _e31 = meet(found_2, p_11, i_4, vec2(_e20, _e29));
    return _e31;
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

uvec4 geometryRow(uint i_7) {
    uvec4 _e14 = texelFetch(geometry, ivec2(int((i_7 & 2047u)), int((float(int((i_7 & 2147481600u))) / 2048.0))), 0);
    return _e14;
}

Instance fetchInstance(uint row_1) {
    uvec4 _e3 = geometryRow((row_1 + 0u));
    uvec4 _e6 = geometryRow((row_1 + 1u));
    uvec4 _e9 = geometryRow((row_1 + 2u));
    uvec4 _e12 = geometryRow((row_1 + 3u));
    uvec4 _e15 = geometryRow((row_1 + 4u));
    return Instance(uintBitsToFloat(_e3.xyzw), uintBitsToFloat(_e6.xyzw), uintBitsToFloat(_e9.xyzw), _e12.x, _e12.y, _e12.z, _e12.w, _e15.x, _e15.y, _e15.z, _e15.w);
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

vec4 planes(uint row_2, float inverse_, float offset_2) {
    uvec4 _e3 = geometryRow(row_2);
    return ((uintBitsToFloat(_e3) * inverse_) + vec4(offset_2));
}

vec4 smaller(vec4 a_1, vec4 b_1) {
    return intBitsToFloat(min(floatBitsToInt(a_1), floatBitsToInt(b_1)));
}

vec4 enterChildren(uint node, SlabRay r, float t_1) {
    uvec3 far_5 = (uvec3(3u, 5u, 7u) - r.near);
    vec4 _e16 = planes((node + r.near.x), r.inverse_.x, r.offset.x);
    vec4 _e24 = planes((node + r.near.y), r.inverse_.y, r.offset.y);
    vec4 _e25 = larger(_e16, _e24);
    vec4 _e33 = planes((node + r.near.z), r.inverse_.z, r.offset.z);
    vec4 _e36 = larger(_e33, vec4(0.0));
    vec4 _e37 = larger(_e25, _e36);
    vec4 _e44 = planes((node + far_5.x), r.inverse_.x, r.offset.x);
    vec4 _e51 = planes((node + far_5.y), r.inverse_.y, r.offset.y);
    vec4 _e52 = smaller(_e44, _e51);
    vec4 _e59 = planes((node + far_5.z), r.inverse_.z, r.offset.z);
    vec4 _e60 = smaller(_e52, _e59);
    vec4 _e66 = smaller((_e60 * 1.000001), vec4(t_1));
    return mix(vec4(1e30), _e37, lessThanEqual(_e37, _e66));
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

Triangle fetchTriangle(uint row_3) {
    uvec4 _e3 = geometryRow((row_3 + 0u));
    uvec4 _e6 = geometryRow((row_3 + 1u));
    uvec4 _e9 = geometryRow((row_3 + 2u));
    return Triangle(uintBitsToFloat(_e3.xyz), _e3.w, uintBitsToFloat(_e6.xyz), _e6.w, uintBitsToFloat(_e9.xyz), _e9.w);
}

uvec4 texelRow(uint i_8) {
    uvec4 _e14 = texelFetch(texels, ivec2(int((i_8 & 2047u)), int((float(int((i_8 & 2147481600u))) / 2048.0))), 0);
    return _e14;
}

MaterialTextures fetchMaterialTextures(uint row_4) {
    uvec4 _e3 = texelRow((row_4 + 0u));
    return MaterialTextures(_e3.x, _e3.y, uintBitsToFloat(_e3.z), uintBitsToFloat(_e3.w));
}

Vertex fetchVertex(uint row_5) {
    uvec4 _e3 = geometryRow((row_5 + 0u));
    return Vertex(_e3.x, _e3.y, uintBitsToFloat(_e3.zw));
}

VertexMore fetchVertexMore(uint row_6) {
    uvec4 _e3 = geometryRow((row_6 + 0u));
    return VertexMore(_e3.x, _e3.y, uintBitsToFloat(_e3.zw));
}

vec2 pairOf(uint word) {
    return (vec2(float((word & 65535u)), float((word >> 16u))) / vec2(65535.0));
}

Cover coverAt(uvec3 rows, uint each, vec2 weights) {
    Cover c = Cover(vec4(0.0), 1.0);
    vec3 share_1 = vec3(((1.0 - weights.x) - weights.y), weights);
    if ((each != 0u)) {
        Vertex _e19 = fetchVertex(rows.x);
        Vertex _e24 = fetchVertex(rows.y);
        Vertex _e30 = fetchVertex(rows.z);
        c.uv = vec4((((share_1.x * _e19.uv) + (share_1.y * _e24.uv)) + (share_1.z * _e30.uv)), 0.0, 0.0);
    }
    if ((each > vertexRows)) {
        uvec3 more_1 = (rows + uvec3(1u));
        VertexMore _e43 = fetchVertexMore(more_1.x);
        VertexMore _e45 = fetchVertexMore(more_1.y);
        VertexMore _e47 = fetchVertexMore(more_1.z);
        vec4 _e50 = c.uv;
        c.uv = vec4(_e50.xy, (((share_1.x * _e43.uv) + (share_1.y * _e45.uv)) + (share_1.z * _e47.uv)));
        vec2 _e66 = pairOf(_e43.blueAlpha);
        vec2 _e69 = pairOf(_e45.blueAlpha);
        vec2 _e72 = pairOf(_e47.blueAlpha);
        c.opacity = dot(share_1, vec3(_e66.y, _e69.y, _e72.y));
    }
    Cover _e76 = c;
    return _e76;
}

TextureUse fetchTextureUse(uint row_7) {
    uvec4 _e3 = texelRow((row_7 + 0u));
    uvec4 _e6 = texelRow((row_7 + 1u));
    uvec4 _e9 = texelRow((row_7 + 2u));
    return TextureUse(uintBitsToFloat(_e3.xyz), _e3.w, uintBitsToFloat(_e6.xyz), _e6.w, _e9.x, _e9.y, _e9.z, uintBitsToFloat(_e9.w));
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

uint texelAt(uint i_9) {
    uvec4 _e3 = texelRow((i_9 >> 2u));
    uvec2 pair_4 = pick(((i_9 & 2u) != 0u), _e3.zw, _e3.xy);
    return pick(((i_9 & 1u) != 0u), pair_4.y, pair_4.x);
}

vec4 lookUp(TextureUse t_2, vec2 uv) {
    vec3 place_6 = vec3(uv, 1.0);
    const bool _e7 = hasOtherLookups;
    uint flags_2 = pick(_e7, t_2.flags, 0u);
    bool nearest_1 = ((flags_2 & isNearest) != 0u);
    Neighbours _e24 = neighbours(dot(t_2.toU, place_6), t_2.width, ((flags_2 & clampsU) != 0u), ((flags_2 & mirrorsU) != 0u), nearest_1);
    Neighbours _e36 = neighbours(dot(t_2.toV, place_6), t_2.height, ((flags_2 & clampsV) != 0u), ((flags_2 & mirrorsV) != 0u), nearest_1);
    uint upper = (t_2.first + (_e36.first * t_2.width));
    uint lower = (t_2.first + (_e36.second * t_2.width));
    bool colored_1 = ((t_2.flags & isColor) != 0u);
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

float unitFloat(uint h) {
    return (float((h >> 8u)) * 5.9604645e-8);
}

bool isThere(uint instance, uint place, vec2 weights_1, uint number) {
    float opacity = 0.0;
    uint _e6 = frame.instances;
    Instance _e10 = fetchInstance((_e6 + (instance * instanceRows)));
    Triangle _e15 = fetchTriangle((_e10.triangles + (place * triangleRows)));
    uint row_11 = (_e10.cover & coverRow);
    MaterialTextures _e19 = fetchMaterialTextures(row_11);
    Cover _e30 = coverAt((uvec3(_e10.vertices) + (uvec3(_e15.vertexA, _e15.vertexB, _e15.vertexC) * _e10.vertexRows)), _e10.vertexRows, weights_1);
    opacity = (_e19.opacity * _e30.opacity);
    if (((_e19.flags & hasOpacityTexture) != 0u)) {
        TextureUse _e42 = fetchTextureUse((row_11 + materialTexturesRows));
        float _e43 = opacity;
        vec4 _e54 = lookUp(_e42, pick(((_e42.flags & usesSecondSet) != 0u), _e30.uv.zw, _e30.uv.xy));
        opacity = (_e43 * _e54.w);
    }
    uint _e57 = pcg(number);
    uint _e59 = pcg((instance + _e57));
    uint _e61 = pcg((place + _e59));
    float _e62 = unitFloat(_e61);
    float _e63 = opacity;
    float _e66 = opacity;
    return pick((_e19.cutoff < 0.0), (_e62 < _e66), (_e63 >= _e19.cutoff));
}

uint rowOfInstance(uint instance_2) {
    uint _e3 = frame.instances;
    Instance _e7 = fetchInstance((_e3 + (instance_2 * instanceRows)));
    return _e7.row;
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

LampTriangle fetchLampTriangle(uint row_8) {
    uvec4 _e3 = geometryRow((row_8 + 0u));
    return LampTriangle(uintBitsToFloat(_e3.x), _e3.y, _e3.z, uintBitsToFloat(_e3.w));
}

float meshPdf(Emitter e_7, vec3 direction_9, float distance_4, vec3 normal_2, uint place_1) {
    uint _e7 = frame.lampTables;
    uint row_12 = ((_e7 + uint(e_7.table)) + (place_1 & ((1u << uint(e_7.radius)) - 1u)));
    float _e23 = areaPdf(e_7.area, (distance_4 * abs(dot(direction_9, normal_2))), distance_4);
    LampTriangle _e24 = fetchLampTriangle(row_12);
    return (_e23 * _e24.density);
}

float shapePdf(Emitter e_8, vec3 point_7, vec3 direction_10, float distance_5, vec3 normal_3, uint place_2) {
    float pdf = 0.0;
    const bool _e9 = hasSphereLights;
    if (_e9) {
        if ((e_8.kind == 0.0)) {
            float _e13 = spherePdf(e_8, point_7, direction_10);
            pdf = _e13;
        }
    }
    const bool _e15 = hasQuadLights;
    if (_e15) {
        if ((e_8.kind == 1.0)) {
            float _e19 = quadPdf(e_8, point_7, distance_5);
            pdf = _e19;
        }
    }
    const bool _e21 = hasBoxLights;
    if (_e21) {
        if ((e_8.kind == 2.0)) {
            float _e25 = boxPdf(e_8, point_7, direction_10, distance_5, normal_3);
            pdf = _e25;
        }
    }
    const bool _e27 = hasMeshLamps;
    if (_e27) {
        if ((e_8.kind == 7.0)) {
            float _e31 = meshPdf(e_8, direction_10, distance_5, normal_3, place_2);
            pdf = _e31;
        }
    }
    float _e32 = pdf;
    return _e32;
}

float cosineTowards(Emitter e_9, vec3 toLight_1, float grown, vec3 normal_4) {
    float above_1 = clamp(((dot(normal_4, toLight_1) + e_9.reach) / grown), 0.0, 1.0);
    return pick((dot(normal_4, normal_4) == 0.0), 1.0, above_1);
}

float spotFalloff(Emitter e_10, vec3 toLight_2) {
    float share_2 = clamp(((-(dot(toLight_2, e_10.u)) - e_10.radius) / (e_10.cosInner - e_10.radius)), 0.0, 1.0);
    return (share_2 * share_2);
}

float estimatedIrradiance(Emitter e_11, vec3 point_8, vec3 normal_5) {
    float estimate = 0.0;
    const bool _e4 = hasQuadLights;
    bool isQuad = pick(_e4, (e_11.kind == 1.0), false);
    const bool _e10 = hasSuns;
    bool isFar = pick(_e10, (e_11.kind == 5.0), false);
    vec3 middle_2 = (e_11.position + pick(isQuad, (0.5 * (e_11.u + e_11.v)), vec3(0.0)));
    vec3 toLight_6 = pick(isFar, -(e_11.u), (middle_2 - point_8));
    float distance2_ = dot(toLight_6, toLight_6);
    float distance_6 = sqrt(distance2_);
    float grown_1 = max((distance_6 + e_11.reach), 1e-15);
    float _e35 = cosineTowards(e_11, toLight_6, grown_1, normal_5);
    float square = pick(isQuad, (distance2_ + (e_11.area / 3.1415927)), max(distance2_, (e_11.area / 12.566371)));
    estimate = ((e_11.power * _e35) / pick(isFar, 1.0, max(square, 1e-15)));
    const bool _e54 = hasQuadLights;
    if (_e54) {
        float height_2 = (-(dot(cross(e_11.u, e_11.v), toLight_6)) / max(e_11.area, 1e-30));
        float side_3 = pick((e_11.oneSided == 1.0), max(height_2, 0.0), abs(height_2));
        float lampCosine = pick((side_3 > 0.0), ((side_3 + e_11.reach) / grown_1), 0.0);
        float _e78 = estimate;
        estimate = (_e78 * pick(isQuad, lampCosine, 1.0));
    }
    const bool _e83 = hasMeshLamps;
    if (_e83) {
        float alike = length(e_11.v);
        float across_2 = -(dot(e_11.v, toLight_6));
        float side_4 = pick((e_11.oneSided == 1.0), max(across_2, 0.0), abs(across_2));
        float shown = ((0.25 * (1.0 - alike)) + ((side_4 + (alike * e_11.reach)) / grown_1));
        float sizeOfMesh = (distance2_ + ((e_11.area * (1.0 + (3.0 * alike))) / 12.566371));
        float _e114 = estimate;
        estimate = pick((e_11.kind == 7.0), (((e_11.power * _e35) * shown) / max(sizeOfMesh, 1e-15)), _e114);
    }
    const bool _e126 = hasPointLights;
    if (_e126) {
        float _e127 = estimate;
        float _e132 = spotFalloff(e_11, (toLight_6 / vec3(max(distance_6, 1e-15))));
        estimate = (_e127 * pick((e_11.kind == 4.0), _e132, 1.0));
    }
    const bool _e140 = hasSky;
    if (_e140) {
        float _e141 = estimate;
        estimate = pick((e_11.kind == 6.0), e_11.power, _e141);
    }
    float _e147 = estimate;
    return _e147;
}

float listedProbability(Emitter e_12, vec3 point_9, vec3 normal_6, Odds odds) {
    float probability = 0.0;
    uint _e6 = frame.emitterCount;
    probability = float(min(_e6, 1u));
    const bool _e12 = hasManyLights;
    if (_e12) {
        uint _e15 = frame.emitterCount;
        if ((_e15 > 1u)) {
            float _e18 = estimatedIrradiance(e_12, point_9, normal_6);
            probability = (_e18 / max(odds.total, 1e-37));
            const bool _e24 = hasLightTree;
            if (_e24) {
                float _e25 = probability;
                probability = (_e25 * (1.0 - odds.tree));
            }
        }
    }
    float _e30 = probability;
    return _e30;
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
    vec4 distance2_1 = (((x_20 * x_20) + (y_10 * y_10)) + (z_3 * z_3));
    vec4 inverse_2 = inversesqrt(max(distance2_1, vec4(1e-30)));
    bvec4 inside_2 = lessThanEqual(distance2_1, (n.reach * n.reach));
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
    vec4 above_2 = mix(max(_e83, vec4(0.0)), vec4(1.0), inside_2);
    vec4 cosIn = pick((dot(normal_7, normal_7) == 0.0), vec4(1.0), above_2);
    vec4 estimate_2 = (((n.power * cosOut) * cosIn) / max(max(distance2_1, (n.reach * n.reach)), vec4(1e-15)));
    return mix(vec4(0.0), min(estimate_2, vec4(1e30)), greaterThan(cosOut, n.cosEdge));
}

float shareOfTree(float total, float far) {
    float share_3 = (0.25 + ((0.5 * total) / max((total + far), 1e-37)));
    return pick((total <= 0.0), 0.0, pick((far <= 0.0), 1.0, share_3));
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
        float own_7 = pick(low_3, pick(odd, _e27.y, _e27.x), pick(odd, _e27.w, _e27.z));
        float before_1 = pick(low_3, pick(odd, _e27.x, 0.0), pick(odd, three, two));
        float _e95 = choice.probability;
        choice.probability = (_e95 * (own_7 / max(total_2, 1e-37)));
        choice.emitter = uint(pick(low_3, pick(odd, _e26.emitters.y, _e26.emitters.x), pick(odd, _e26.emitters.w, _e26.emitters.z)));
        rest = clamp(((at_2 - before_1) / max(own_7, 1e-37)), 0.0, 0.99999994);
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

vec3 metLight(Path p_16, PairHit hit, Surface s_6, vec3 outward, Emitter only_1) {
    vec3 found_8 = vec3(0.0);
    uint i_14 = 0u;
    float probability_2 = 0.0;
    vec3 direction_22 = p_16.rays.direction;
    bool hidden = pick(((uint(s_6.code) & 16u) != 0u), (dot(outward, direction_22) > 0.0), false);
    int _e18 = emitterOf(s_6.code);
    found_8 = pick(hidden, vec3(0.0), s_6.emission);
    uint _e28 = frame.emitterCount;
    if (pick((_e18 >= 0), (_e28 > 0u), false)) {
        i_14 = uint(max(_e18, 0));
        const bool _e37 = hasMeshLamps;
        if (_e37) {
            if ((hit.triangle.instance != noInstance)) {
                uint _e42 = i_14;
                uint _e43 = i_14;
                Emitter _e44 = emitterAt(_e43, only_1);
                uint _e46 = emitterOfTriangle(_e44, hit.triangle);
                i_14 = (_e42 + _e46);
            }
        }
        uint _e48 = i_14;
        Emitter _e49 = emitterAt(_e48, only_1);
        float _e55 = shapePdf(_e49, p_16.rays.point, direction_22, hit.t, outward, hit.triangle.triangle);
        float _e60 = listedProbability(_e49, p_16.rays.point, p_16.litSide, p_16.odds);
        probability_2 = _e60;
        const bool _e63 = hasLightTree;
        if (_e63) {
            if ((_e49.leaf >= 0.0)) {
                float _e71 = treeProbability(_e49, p_16.rays.point, p_16.litSide, p_16.odds);
                probability_2 = _e71;
            }
        }
        vec3 _e72 = found_8;
        float _e74 = probability_2;
        float _e76 = misWeight(p_16.pdf, (_e55 * _e74));
        found_8 = (_e72 * pick((p_16.pdf <= 0.0), 1.0, _e76));
    }
    vec3 _e83 = found_8;
    return _e83;
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

EmitterChoice chooseEmitter(vec3 point_13, vec3 normal_10, float u_6) {
    bool hasTree = false;
    EmitterChoice choice_1 = EmitterChoice(0u, 0.0, Odds(0.0, 0.0));
    float total_1 = 0.0;
    uint chosen = 0u;
    float chosenWeight = 0.0;
    float rest_1 = 0.0;
    uint i_15 = 0u;
    const bool _e6 = hasLightTree;
    if (_e6) {
        uint _e9 = frame.lightTreeDepth;
        hasTree = (_e9 > 0u);
    }
    uint _e14 = frame.emitterCount;
    uint _e17 = frame.farEmitters;
    bool _e18 = hasTree;
    uint listed = pick(_e18, _e17, _e14);
    uint _e23 = frame.emitterCount;
    choice_1 = EmitterChoice(0u, float(min(_e23, 1u)), Odds(1.0, 0.0));
    const bool _e33 = hasManyLights;
    if (_e33) {
        uint _e36 = frame.emitterCount;
        if ((_e36 > 1u)) {
            rest_1 = u_6;
            while(true) {
                uint _e48 = i_15;
                Emitter _e49 = fetchEmitter(_e48);
                float _e50 = estimatedIrradiance(_e49, point_13, normal_10);
                uint _e51 = i_15;
                float weight_1 = pick((_e51 < listed), _e50, 0.0);
                float _e55 = total_1;
                total_1 = (_e55 + weight_1);
                float _e57 = total_1;
                float share_4 = (weight_1 / max(_e57, 1e-37));
                float _e61 = rest_1;
                bool take = (_e61 < share_4);
                uint _e63 = chosen;
                uint _e64 = i_15;
                chosen = pick(take, _e64, _e63);
                float _e66 = chosenWeight;
                chosenWeight = pick(take, weight_1, _e66);
                float _e68 = rest_1;
                float _e75 = rest_1;
                rest_1 = pick(take, (_e75 / max(share_4, 1e-37)), ((_e68 - share_4) / max((1.0 - share_4), 1e-7)));
                uint _e81 = i_15;
                i_15 = (_e81 + 1u);
                uint _e83 = i_15;
                if ((_e83 >= listed)) {
                    break;
                }
            }
            uint _e85 = chosen;
            float _e86 = chosenWeight;
            float _e87 = total_1;
            float _e91 = total_1;
            choice_1 = EmitterChoice(_e85, (_e86 / max(_e87, 1e-37)), Odds(_e91, 0.0));
            const bool _e96 = hasLightTree;
            if (_e96) {
                bool _e97 = hasTree;
                if (_e97) {
                    float _e98 = rest_1;
                    float _e100 = total_1;
                    TreeChoice _e101 = descend(point_13, normal_10, _e98, -1, _e100);
                    choice_1.odds.tree = _e101.share;
                    uint _e106 = chosen;
                    choice_1.index = pick(_e101.taken, _e101.emitter, _e106);
                    float _e112 = choice_1.probability;
                    choice_1.probability = pick(_e101.taken, (_e101.probability * _e101.share), (_e112 * (1.0 - _e101.share)));
                }
            }
        }
    }
    EmitterChoice _e122 = choice_1;
    return _e122;
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
    float distance_7 = pick(takeLarger, larger_1, (_e3.power / max(larger_1, 1e-30)));
    float _e49 = conePdf(_e3.width);
    return LightSample(_e19.direction, distance_7, e_14.radiance, _e49, false);
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
    vec2 across_3 = (vec2((s_29.y - s_29.x), (s_29.y + s_29.x)) * _e21);
    float w_8 = (((2.0 * _e21.x) * _e21.y) / max(length(across_3), 1e-15));
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
    vec3 toLight_7 = pick(_e3.bySolidAngle, _e13, onArea);
    float distance_8 = max(length(toLight_7), _e3.height);
    float _e23 = pdfOfView(_e3, e_15.area, distance_8);
    return LightSample((toLight_7 / vec3(distance_8)), distance_8, e_15.radiance, _e23, false);
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
    vec3 toLight_8 = ((pick(onX, p_28.xyz, pick(onY, p_28.zxy, p_28.yzx)) * e_16.u) - b_3.point);
    return vec4(toLight_8, abs(dot(axis_5, toLight_8)));
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
    float distance_9 = pick(_e3.inside, max(_e16.far, 0.0), length(_e4.xyz));
    vec3 direction_23 = pick(_e3.inside, outwards, (_e4.xyz / vec3(max(distance_9, 1e-30))));
    float _e31 = areaPdf(_e3.area, _e4.w, distance_9);
    float _e33 = conePdf(2.0);
    float pdf_3 = pick(_e3.inside, _e33, _e31);
    vec3 _e37 = rotateBack(_e3.rotation, direction_23);
    return LightSample(_e37, distance_9, e_17.radiance, pdf_3, false);
}

ChosenTriangle chooseTriangle(Emitter e_18, vec2 u_13) {
    uint _e4 = frame.lampTables;
    uint first_1 = (_e4 + uint(e_18.table));
    uint column_2 = min(uint((u_13.x * e_18.triangles)), (uint(e_18.triangles) - 1u));
    LampTriangle _e18 = fetchLampTriangle((first_1 + column_2));
    uint _e26 = mixBits((floatBitsToUint(u_13.x) ^ (floatBitsToUint(u_13.y) * 2654435761u)));
    uint hash = (_e26 >> 8u);
    float fine_2 = (((float(hash) * 5.9604645e-8) * 5.9604645e-8) * e_18.triangles);
    float x_23 = clamp((((u_13.x * e_18.triangles) - float(column_2)) + fine_2), 0.0, 0.99999994);
    bool own_8 = (x_23 < _e18.own);
    float rest_2 = pick(own_8, (x_23 / max(_e18.own, 1e-37)), ((x_23 - _e18.own) / max((1.0 - _e18.own), 1e-7)));
    uint place_7 = pick(own_8, _e18.place, _e18.other);
    LampTriangle _e67 = fetchLampTriangle((((first_1 + column_2) + place_7) - _e18.place));
    float density = _e67.density;
    return ChosenTriangle(place_7, density, vec2(min(rest_2, 1.0), u_13.y));
}

vec2 weightsOnTriangle(vec2 u_14) {
    float low_4 = (0.5 * min(u_14.x, u_14.y));
    float high_2 = (max(u_14.x, u_14.y) - low_4);
    return pick((u_14.x < u_14.y), vec2(low_4, high_2), vec2(high_2, low_4));
}

vec3 outOfMesh(Instance i_16, vec3 p_17) {
    vec3 q_7 = (p_17 - vec3(i_16.toMeshX.w, i_16.toMeshY.w, i_16.toMeshZ.w));
    vec3 x_24 = cross(i_16.toMeshY.xyz, i_16.toMeshZ.xyz);
    vec3 y_13 = cross(i_16.toMeshZ.xyz, i_16.toMeshX.xyz);
    vec3 z_5 = cross(i_16.toMeshX.xyz, i_16.toMeshY.xyz);
    return ((((q_7.x * x_24) + (q_7.y * y_13)) + (q_7.z * z_5)) / vec3(dot(i_16.toMeshX.xyz, x_24)));
}

vec3 radianceShare(uint row_9, Cover c_2, bool missing) {
    vec3 share = vec3(1.0);
    float opacity_1 = 0.0;
    uint i_17 = 0u;
    MaterialTextures _e3 = fetchMaterialTextures(row_9);
    bool hasFirst = ((_e3.flags & hasOpacityTexture) != 0u);
    uint wanted = min(_e3.count, pick(hasFirst, 2u, 1u));
    opacity_1 = (_e3.opacity * c_2.opacity);
    if ((wanted > 0u)) {
        while(true) {
            uint _e27 = i_17;
            TextureUse _e31 = fetchTextureUse(((row_9 + materialTexturesRows) + (_e27 * textureUseRows)));
            vec4 _e42 = lookUp(_e31, pick(((_e31.flags & usesSecondSet) != 0u), c_2.uv.zw, c_2.uv.xy));
            vec3 _e43 = share;
            share = (_e43 * pick((_e31.slot == emissionSlot), _e42.xyz, vec3(1.0)));
            float _e52 = opacity_1;
            uint _e54 = i_17;
            opacity_1 = (_e52 * pick(pick(hasFirst, (_e54 == 0u), false), _e42.w, 1.0));
            uint _e62 = i_17;
            i_17 = (_e62 + 1u);
            uint _e64 = i_17;
            if ((_e64 >= wanted)) {
                break;
            }
        }
    }
    float _e66 = opacity_1;
    float _e72 = opacity_1;
    float there = pick((_e3.cutoff < 0.0), _e72, pick((_e66 >= _e3.cutoff), 1.0, 0.0));
    vec3 _e77 = share;
    return (_e77 * pick(missing, there, 1.0));
}

Surface fetchSurface(uint i_18) {
    vec4 _e2 = tableTexel(9u, i_18);
    vec4 _e4 = tableTexel(10u, i_18);
    vec4 _e6 = tableTexel(11u, i_18);
    vec4 _e8 = tableTexel(12u, i_18);
    vec4 _e10 = tableTexel(13u, i_18);
    return Surface(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.xyz, _e10.w);
}

LightSample sampleMesh(Emitter e_19, vec3 point_17, vec2 u_15) {
    vec3 radiance = vec3(0.0);
    ChosenTriangle _e3 = chooseTriangle(e_19, u_15);
    uint _e6 = frame.instances;
    Instance _e12 = fetchInstance((_e6 + (uint(e_19.instance) * instanceRows)));
    Triangle _e18 = fetchTriangle((_e12.triangles + (_e3.place * triangleRows)));
    vec2 _e20 = weightsOnTriangle(_e3.u);
    vec3 _e34 = outOfMesh(_e12, ((_e18.a + (_e20.x * (_e18.b - _e18.a))) + (_e20.y * (_e18.c - _e18.a))));
    vec3 toLight_9 = (_e34 - point_17);
    vec3 across_4 = (mat3x3(_e12.toMeshX.xyz, _e12.toMeshY.xyz, _e12.toMeshZ.xyz) * cross((_e18.b - _e18.a), (_e18.c - _e18.a)));
    float height_3 = (dot(across_4, toLight_9) * inversesqrt(max(dot(across_4, across_4), 1e-37)));
    float distance_10 = length(toLight_9);
    float _e60 = areaPdf(e_19.area, abs(height_3), distance_10);
    float pdf_4 = (_e60 * _e3.density);
    bool lit_3 = pick((height_3 < 0.0), true, pick((e_19.oneSided == 0.0), (height_3 > 0.0), false));
    float reached_1 = max((distance_10 - (1e-5 * (length(point_17) + distance_10))), 0.0);
    radiance = e_19.radiance;
    const bool _e82 = hasVariedLamps;
    if (_e82) {
        if ((e_19.u.y > 0.0)) {
            uvec3 rows_1 = (uvec3(_e12.vertices) + (uvec3(_e18.vertexA, _e18.vertexB, _e18.vertexC) * _e12.vertexRows));
            Cover _e97 = coverAt(rows_1, _e12.vertexRows, _e20);
            vec3 _e98 = radiance;
            Surface _e101 = fetchSurface(uint(e_19.shape));
            vec3 _e109 = radianceShare(uint(_e101.textures), _e97, ((_e12.cover & coverRow) != 0u));
            radiance = (_e98 * _e109);
        }
    }
    vec3 _e115 = radiance;
    return LightSample((toLight_9 / vec3(max(distance_10, 1e-30))), reached_1, _e115, pick(lit_3, pdf_4, 0.0), false);
}

LightSample samplePoint(Emitter e_20, vec3 point_18) {
    vec3 toLight_10 = (e_20.position - point_18);
    float distance_11 = length(toLight_10);
    float safe = max(distance_11, 1e-15);
    return LightSample((toLight_10 / vec3(safe)), distance_11, (e_20.radiance / vec3((safe * safe))), pick((distance_11 > 1e-15), 1.0, 0.0), true);
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
    uint row_13 = (i_27 / width_2);
    vec4 _e12 = environmentTexel((i_27 - (row_13 * width_2)), row_13);
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
    uint pair_5 = min(_e76, (pairs - 1u));
    vec4 _e84 = fetchEntries(t_5, (max(pair_5, 1u) - 1u));
    vec2 _e85 = sharesBeyond(_e84, digits_1, fine_1);
    float before_2 = _e85.y;
    float none = -((float(digits_1) + (float(fine_1) * 0.00024414063)));
    float _e94 = ends.x;
    bool isFirst_1 = (_e94 > 0.0);
    float _e98 = ends.x;
    float start_1 = pick(isFirst_1, pick((pair_5 == 0u), none, before_2), _e98);
    float _e104 = ends.y;
    float _e106 = ends.x;
    float end = pick(isFirst_1, _e106, _e104);
    return Choice(min(((2u * pair_5) + pick(isFirst_1, 0u, 1u)), (t_5.entries - 1u)), clamp((-(start_1) / max((end - start_1), 1e-37)), 0.0, 1.0));
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
    uint upper_1 = (max(cell.y, 1u) - 1u);
    uint lower_1 = min(cell.y, (size_3.y - 1u));
    vec4 above_3 = vec4(1.0, 1.0, 1.0, pick((cell.y == 0u), -1.0, 1.0));
    vec4 below_1 = vec4(1.0, 1.0, 1.0, pick((cell.y == size_3.y), -1.0, 1.0));
    vec4 _e49 = environmentTexel(left_1, upper_1);
    vec4 _e51 = environmentTexel(right, upper_1);
    vec4 _e53 = environmentTexel(left_1, lower_1);
    vec4 _e55 = environmentTexel(right, lower_1);
    return Corners((above_3 * _e49), (above_3 * _e51), (below_1 * _e53), (below_1 * _e55));
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
    float nearest_2 = floor((halfTurns + 0.5));
    bool back = (fract((0.5 * nearest_2)) > 0.0);
    vec2 _e100 = cosineAndSine(((halfTurns - nearest_2) * 3.1415927));
    vec2 phi_1 = (_e100 * pick(back, -1.0, 1.0));
    float sine_4 = max(_e76.y, 1e-9);
    vec3 direction_24 = vec3((sine_4 * phi_1.y), pick(isLower, -(_e76.x), _e76.x), (-(sine_4) * phi_1.x));
    EnvironmentLight _e119 = lightWithin(_e6, vec2(_e55, t_13), sine_4);
    return EnvironmentSample(direction_24, _e119);
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

LightSample sampleEmitter(Emitter e_23, vec3 point_20, vec2 u_21) {
    LightSample s_10 = LightSample(vec3(0.0, 1.0, 0.0), 1e30, vec3(0.0), 0.0, true);
    const bool _e15 = hasSphereLights;
    if (_e15) {
        if ((e_23.kind == 0.0)) {
            LightSample _e19 = sampleSphere(e_23, point_20, u_21);
            s_10 = _e19;
        }
    }
    const bool _e21 = hasQuadLights;
    if (_e21) {
        if ((e_23.kind == 1.0)) {
            LightSample _e25 = sampleQuad(e_23, point_20, u_21);
            s_10 = _e25;
        }
    }
    const bool _e27 = hasBoxLights;
    if (_e27) {
        if ((e_23.kind == 2.0)) {
            LightSample _e31 = sampleBox(e_23, point_20, u_21);
            s_10 = _e31;
        }
    }
    const bool _e33 = hasMeshLamps;
    if (_e33) {
        if ((e_23.kind == 7.0)) {
            LightSample _e37 = sampleMesh(e_23, point_20, u_21);
            s_10 = _e37;
        }
    }
    const bool _e39 = hasPointLights;
    if (_e39) {
        if ((e_23.kind == 3.0)) {
            LightSample _e43 = samplePoint(e_23, point_20);
            s_10 = _e43;
        }
    }
    const bool _e45 = hasPointLights;
    if (_e45) {
        if ((e_23.kind == 4.0)) {
            LightSample _e49 = sampleSpot(e_23, point_20);
            s_10 = _e49;
        }
    }
    const bool _e51 = hasSuns;
    if (_e51) {
        if ((e_23.kind == 5.0)) {
            LightSample _e55 = sampleDirectional(e_23, u_21);
            s_10 = _e55;
        }
    }
    const bool _e57 = hasSky;
    if (_e57) {
        if ((e_23.kind == 6.0)) {
            LightSample _e61 = sampleSky(u_21);
            s_10 = _e61;
        }
    }
    float _e64 = s_10.pdf;
    float _e66 = s_10.distance_;
    s_10.pdf = pick((_e66 <= (1e-5 * length(point_20))), 0.0, _e64);
    LightSample _e73 = s_10;
    return _e73;
}

Lit lightAt(inout Path p_18, PairHit hit_1, Meeting m_1) {
    Emitter _e4 = fetchEmitter(0u);
    Path _e5 = p_18;
    vec3 _e8 = metLight(_e5, hit_1, m_1.surface, m_1.geometric, _e4);
    vec3 _e10 = p_18.radiance;
    vec3 _e12 = p_18.throughput;
    p_18.radiance = (_e10 + (_e12 * pick((hit_1.shape == noShape), vec3(0.0), _e8)));
    TwoPoints _e22 = nextTwo3d(p_18.sampler_);
    vec3 _e24 = litSideOf(m_1);
    EmitterChoice _e27 = chooseEmitter(m_1.point, _e24, _e22.first.z);
    Emitter _e29 = emitterAt(_e27.index, _e4);
    LightSample _e33 = sampleEmitter(_e29, m_1.point, _e22.first.xy);
    return Lit(_e33, (_e33.pdf * _e27.probability), _e29.shape, _e27.odds, _e22.second);
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
    vec3 side_5 = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_12, vec3(0.0))));
    bool onX_1 = (crossed.x == t_14);
    bool onY_1 = pick(!(onX_1), (crossed.y == t_14), false);
    return (side_5 * mix(vec3(0.0), vec3(1.0), bvec3(onX_1, onY_1, !(pick(onX_1, true, onY_1)))));
}

vec3 turnedBack(vec4 q_5, vec3 v_8) {
    vec3 _e6 = turned(vec4(-(q_5.xyz), q_5.w), v_8);
    return _e6;
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

vec3 normalAt(RayPair p_19, float t_6, uint i_22) {
    vec3 normal_11 = vec3(0.0);
    Bounds _e3 = fetchBounds(i_22);
    vec3 origin_9 = (p_19.point - _e3.center);
    normal_11 = _e3.center;
    const bool _e10 = hasQuads;
    if (_e10) {
        Extent _e11 = fetchExtent(i_22);
        vec3 _e17 = normal_11;
        bool _e18 = isPlane(i_22);
        normal_11 = pick(_e18, _e17, cross(_e11.a.xyz, _e11.b.xyz));
    }
    const bool _e21 = hasBoxes;
    if (_e21) {
        Extent _e22 = fetchExtent(i_22);
        bool inside_3 = pick((i_22 == p_19.shape), p_19.inwards, false);
        vec3 _e28 = turned(_e22.a, origin_9);
        vec3 _e31 = turned(_e22.a, p_19.direction);
        vec3 _e35 = boxNormal(_e28, _e31, _e22.b.xyz, p_19.tMin, inside_3);
        vec3 _e36 = normal_11;
        vec3 _e38 = turnedBack(_e22.a, _e35);
        bool _e39 = isBox(i_22);
        normal_11 = pick(_e39, _e38, _e36);
    }
    const bool _e42 = hasSpheres;
    if (_e42) {
        vec3 outwards_1 = (origin_9 + (t_6 * p_19.direction));
        vec3 _e46 = normal_11;
        bool _e53 = isSphere(i_22);
        normal_11 = pick(_e53, pick((dot(outwards_1, outwards_1) == 0.0), -(p_19.direction), outwards_1), _e46);
    }
    vec3 _e55 = normal_11;
    return normalize(_e55);
}

uint kindOf(uint code_1) {
    return (code_1 & 3u);
}

bool isMetallicRoughness(uint code_2) {
    const bool _e2 = hasMetallicRoughness;
    uint _e3 = kindOf(code_2);
    return pick(_e2, (_e3 == metallicRoughness), false);
}

bool isLayered(uint code_3) {
    const bool _e2 = hasLayers;
    bool _e3 = isMetallicRoughness(code_3);
    return pick(_e2, _e3, false);
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

Layers layersOf(uint code_4, float eta) {
    Layers l = Layers(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    l.specularColor = vec3(1.0);
    l.specularWeight = 1.0;
    l.ior = 1.5;
    bool _e10 = isLayered(code_4);
    if (pick(_e10, (eta != 0.0), false)) {
        Layers _e16 = fetchLayers(uint(abs(eta)));
        l = _e16;
    }
    Layers _e17 = l;
    return _e17;
}

vec3 fromOctahedral(uint code_5) {
    vec2 p_29 = ((vec2(float((code_5 & 65535u)), float((code_5 >> 16u))) * 3.051851e-5) - vec2(1.0));
    float z_6 = ((1.0 - abs(p_29.x)) - abs(p_29.y));
    vec2 folded = ((vec2(1.0) - abs(p_29.yx)) * mix(vec2(1.0), vec2(-1.0), lessThan(p_29, vec2(0.0))));
    return normalize(vec3(pick((z_6 < 0.0), folded, p_29), z_6));
}

MeshPoint meshPoint(uint instance_3, uint place_3, vec2 weights_2) {
    MeshPoint p_20 = MeshPoint(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec4(0.0), vec4(0.0));
    uint _e5 = frame.instances;
    Instance _e9 = fetchInstance((_e5 + (instance_3 * instanceRows)));
    Triangle _e14 = fetchTriangle((_e9.triangles + (place_3 * triangleRows)));
    mat3x3 turn_1 = mat3x3(_e9.toMeshX.xyz, _e9.toMeshY.xyz, _e9.toMeshZ.xyz);
    vec3 geometric_3 = normalize((turn_1 * cross((_e14.b - _e14.a), (_e14.c - _e14.a))));
    p_20 = MeshPoint(geometric_3, geometric_3, vec3(0.0), vec3(0.0), geometric_3, vec4(0.0), vec4(1.0));
    if ((_e9.vertexRows != 0u)) {
        uvec3 rows_2 = (uvec3(_e9.vertices) + (uvec3(_e14.vertexA, _e14.vertexB, _e14.vertexC) * _e9.vertexRows));
        Vertex _e54 = fetchVertex(rows_2.x);
        Vertex _e56 = fetchVertex(rows_2.y);
        Vertex _e58 = fetchVertex(rows_2.z);
        vec3 share_5 = vec3(((1.0 - weights_2.x) - weights_2.y), weights_2);
        vec3 _e67 = fromOctahedral(_e54.normal);
        vec3 _e71 = fromOctahedral(_e56.normal);
        vec3 _e76 = fromOctahedral(_e58.normal);
        vec3 normal_17 = (((share_5.x * _e67) + (share_5.y * _e71)) + (share_5.z * _e76));
        vec3 smoothed = (turn_1 * normal_17);
        float size_5 = dot(smoothed, smoothed);
        float side_6 = pick((dot(smoothed, geometric_3) < 0.0), -1.0, 1.0);
        bool useful = pick(((_e9.vertexFlags & hasNormals) != 0u), (size_5 > 0.0), false);
        p_20.shading = pick(useful, (smoothed * (side_6 * inversesqrt(max(size_5, 1e-37)))), geometric_3);
        const bool _e103 = hasTextures;
        if (_e103) {
            p_20.uv = vec4((((share_5.x * _e54.uv) + (share_5.y * _e56.uv)) + (share_5.z * _e58.uv)), 0.0, 0.0);
            const bool _e120 = hasVertexMore;
            if (_e120) {
                if ((_e9.vertexRows > vertexRows)) {
                    VertexMore _e127 = fetchVertexMore((rows_2.x + vertexRows));
                    VertexMore _e131 = fetchVertexMore((rows_2.y + vertexRows));
                    VertexMore _e135 = fetchVertexMore((rows_2.z + vertexRows));
                    vec4 _e138 = p_20.uv;
                    p_20.uv = vec4(_e138.xy, (((share_5.x * _e127.uv) + (share_5.y * _e131.uv)) + (share_5.z * _e135.uv)));
                    vec2 _e154 = pairOf(_e127.redGreen);
                    vec2 _e158 = pairOf(_e131.redGreen);
                    vec2 _e163 = pairOf(_e135.redGreen);
                    vec2 redGreen = (((share_5.x * _e154) + (share_5.y * _e158)) + (share_5.z * _e163));
                    vec2 _e168 = pairOf(_e127.blueAlpha);
                    vec2 _e172 = pairOf(_e131.blueAlpha);
                    vec2 _e177 = pairOf(_e135.blueAlpha);
                    vec2 blueAlpha = (((share_5.x * _e168) + (share_5.y * _e172)) + (share_5.z * _e177));
                    p_20.color = clamp(vec4(redGreen, blueAlpha), vec4(0.0), vec4(1.0));
                }
            }
            const bool _e188 = hasNormalMaps;
            if (_e188) {
                if (pick(useful, ((_e9.vertexFlags & hasTangents) != 0u), false)) {
                    vec3 _e197 = fromOctahedral(_e54.tangent);
                    vec3 _e201 = fromOctahedral(_e56.tangent);
                    vec3 _e206 = fromOctahedral(_e58.tangent);
                    vec3 tangent_2 = (((share_5.x * _e197) + (share_5.y * _e201)) + (share_5.z * _e206));
                    float hand = pick(((_e54.tangent & 65536u) != 0u), -1.0, 1.0);
                    p_20.normal = (smoothed * side_6);
                    p_20.tangent = ((turn_1 * tangent_2) * side_6);
                    p_20.bitangent = ((turn_1 * cross(normal_17, tangent_2)) * (hand * side_6));
                }
            }
        }
    }
    MeshPoint _e227 = p_20;
    return _e227;
}

bool isSmooth(uint code_6) {
    return ((code_6 & 32u) != 0u);
}

void takeUpLayer(uint slot, vec4 texel_6) {
    float _e4 = layersHere.specularWeight;
    layersHere.specularWeight = (_e4 * pick((slot == specularWeightSlot), texel_6.w, 1.0));
    vec3 _e13 = layersHere.specularColor;
    layersHere.specularColor = (_e13 * pick((slot == specularColorSlot), texel_6.xyz, vec3(1.0)));
    const bool _e22 = hasTransmission;
    if (_e22) {
        float _e25 = layersHere.transmission;
        layersHere.transmission = (_e25 * pick((slot == transmissionSlot), texel_6.x, 1.0));
        float _e34 = layersHere.beyond;
        layersHere.beyond = (_e34 * pick((slot == beyondSlot), texel_6.w, 1.0));
        vec3 _e43 = layersHere.beyondColor;
        layersHere.beyondColor = (_e43 * pick((slot == beyondColorSlot), texel_6.xyz, vec3(1.0)));
    }
    const bool _e52 = hasCoats;
    if (_e52) {
        float _e55 = layersHere.coat;
        layersHere.coat = (_e55 * pick((slot == coatSlot), texel_6.x, 1.0));
        float _e64 = layersHere.coatRoughness;
        layersHere.coatRoughness = (_e64 * pick((slot == coatRoughnessSlot), texel_6.y, 1.0));
    }
    const bool _e72 = hasSheen;
    if (_e72) {
        vec3 _e75 = layersHere.sheenColor;
        layersHere.sheenColor = (_e75 * pick((slot == sheenColorSlot), texel_6.xyz, vec3(1.0)));
        float _e85 = layersHere.sheenRoughness;
        layersHere.sheenRoughness = (_e85 * pick((slot == sheenRoughnessSlot), texel_6.w, 1.0));
    }
    const bool _e93 = hasIridescence;
    if (_e93) {
        float _e96 = layersHere.film;
        layersHere.film = (_e96 * pick((slot == filmSlot), texel_6.x, 1.0));
        float _e105 = layersHere.filmLeast;
        float _e108 = layersHere.filmThickness;
        float thickness_1 = mix(_e105, _e108, texel_6.y);
        float _e115 = layersHere.filmThickness;
        layersHere.filmThickness = pick((slot == filmThicknessSlot), thickness_1, _e115);
    }
    const bool _e120 = hasGrain;
    if (_e120) {
        bool isGrain = (slot == anisotropySlot);
        float _e125 = layersHere.anisotropy;
        layersHere.anisotropy = (_e125 * pick(isGrain, texel_6.z, 1.0));
        vec2 given_1 = ((2.0 * texel_6.xy) - vec2(1.0));
        float size_6 = dot(given_1, given_1);
        vec2 d_3 = pick((size_6 > 1e-6), (given_1 * inversesqrt(max(size_6, 1e-20))), vec2(1.0, 0.0));
        vec2 own_9 = layersHere.grain;
        layersHere.grain = pick(isGrain, vec2(((own_9.x * d_3.x) - (own_9.y * d_3.y)), ((own_9.y * d_3.x) + (own_9.x * d_3.y))), own_9);
        return;
    } else {
        return;
    }
}

Bumps takeUpTextures(inout Surface s_11, vec4 uv_1, vec3 color) {
    Bumps bumps = Bumps(vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, 1.0));
    uint i_24 = 0u;
    vec2 place_4 = vec2(0.0);
    float _e4 = s_11.textures;
    uint row_14 = uint(_e4);
    MaterialTextures _e6 = fetchMaterialTextures(row_14);
    bool unlit = ((_e6.flags & isUnlit) != 0u);
    vec3 _e13 = s_11.baseColor;
    s_11.baseColor = (_e13 * color);
    vec3 _e16 = s_11.emission;
    s_11.emission = (_e16 * pick(unlit, color, vec3(1.0)));
    if ((_e6.count > 0u)) {
        while(true) {
            uint _e38 = i_24;
            TextureUse _e42 = fetchTextureUse(((row_14 + materialTexturesRows) + (_e38 * textureUseRows)));
            place_4 = uv_1.xy;
            const bool _e46 = hasVertexMore;
            if (_e46) {
                place_4 = pick(((_e42.flags & usesSecondSet) != 0u), uv_1.zw, uv_1.xy);
            }
            vec2 _e55 = place_4;
            vec4 _e56 = lookUp(_e42, _e55);
            vec3 _e58 = s_11.baseColor;
            s_11.baseColor = (_e58 * pick((_e42.slot == baseColorSlot), _e56.xyz, vec3(1.0)));
            vec3 _e68 = s_11.emission;
            s_11.emission = (_e68 * pick((_e42.slot == emissionSlot), _e56.xyz, vec3(1.0)));
            vec2 share_6 = pick((_e42.slot == metallicRoughnessSlot), _e56.yz, vec2(1.0));
            float _e85 = s_11.alpha;
            float rough = max(((_e85 * share_6.x) * share_6.x), 0.001);
            float _e94 = s_11.alpha;
            float _e96 = s_11.code;
            bool _e98 = isSmooth(uint(_e96));
            s_11.alpha = pick(_e98, _e94, rough);
            float _e101 = s_11.metallic;
            s_11.metallic = (_e101 * share_6.y);
            vec3 bump = (((2.0 * _e56.xyz) - vec3(1.0)) * vec3(_e42.scale, _e42.scale, 1.0));
            vec3 _e117 = bumps.base;
            bumps.base = pick((_e42.slot == normalSlot), bump, _e117);
            const bool _e123 = hasCoatNormals;
            if (_e123) {
                vec3 _e126 = bumps.coat;
                bumps.coat = pick((_e42.slot == coatNormalSlot), bump, _e126);
            }
            const bool _e132 = hasLayers;
            if (_e132) {
                takeUpLayer(_e42.slot, _e56);
            }
            uint _e135 = i_24;
            i_24 = (_e135 + 1u);
            uint _e137 = i_24;
            if ((_e137 >= _e6.count)) {
                break;
            }
        }
    }
    Bumps _e140 = bumps;
    return _e140;
}

vec3 bent(vec3 g_3, vec3 o_1, vec3 n_1) {
    float oz = max(dot(o_1, g_3), 0.0);
    float least_1 = min((0.9 * oz), 0.01);
    vec3 across_5 = (n_1 - (dot(n_1, g_3) * g_3));
    vec3 x_25 = (across_5 * inversesqrt(max(dot(across_5, across_5), 1e-20)));
    float ox = dot(o_1, x_25);
    float a_7 = max(((ox * ox) + (oz * oz)), 1e-20);
    float b_10 = (2.0 * (a_7 + (oz * least_1)));
    float c_5 = ((least_1 + oz) * (least_1 + oz));
    float root = sqrt(max(((b_10 * b_10) - ((4.0 * a_7) * c_5)), 0.0));
    float z2_ = clamp(((0.25 * pick((ox < 0.0), (b_10 + root), (b_10 - root))) / a_7), 0.0, 1.0);
    vec3 raised = ((sqrt((1.0 - z2_)) * x_25) + (sqrt(z2_) * g_3));
    vec3 reflected = (((2.0 * dot(n_1, o_1)) * n_1) - o_1);
    return pick((dot(g_3, reflected) >= least_1), n_1, raised);
}

vec3 validNormal(vec3 geometric, vec3 direction_13, vec3 mapped, vec3 otherwise) {
    float size_7 = dot(mapped, mapped);
    vec3 n_4 = pick((size_7 > 0.0), (mapped * inversesqrt(max(size_7, 1e-37))), otherwise);
    float side_7 = pick((dot(geometric, direction_13) > 0.0), -1.0, 1.0);
    vec3 _e21 = bent((side_7 * geometric), -(direction_13), (side_7 * n_4));
    return (side_7 * _e21);
}

bool isDielectric(uint code_7) {
    const bool _e2 = hasGlass;
    uint _e3 = kindOf(code_7);
    return pick(_e2, (_e3 == dielectric_1), false);
}

bool letsThrough(uint code_8, float eta_1) {
    bool _e2 = isDielectric(code_8);
    const bool _e4 = hasTransmission;
    bool _e5 = isLayered(code_8);
    return pick(_e2, true, pick(pick(_e4, _e5, false), (eta_1 < 0.0), false));
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
    float size_8 = dot(along_3, along_3);
    bool own_10 = (size_8 > (1e-12 * dot(tangent, tangent)));
    vec3 _e12 = tangentAbout(normal_13);
    vec3 t_15 = pick(own_10, (along_3 * inversesqrt(max(size_8, 1e-37))), _e12);
    vec3 across_6 = cross(normal_13, t_15);
    float hand_1 = pick(pick(own_10, (dot(across_6, bitangent) < 0.0), false), -1.0, 1.0);
    return ((grain.x * t_15) + ((grain.y * hand_1) * across_6));
}

SurfacePoint surfaceAt(RayPair rays_1, PairHit hit_2, uint shape) {
    Surface surface = Surface(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    Normals normals = Normals(vec3(0.0), vec3(0.0));
    vec3 tangent_1 = vec3(0.0);
    vec3 bitangent_1 = vec3(0.0);
    vec3 _e4 = normalAt(rays_1, hit_2.t, shape);
    Surface _e5 = fetchSurface(shape);
    surface = _e5;
    const bool _e8 = hasLayers;
    if (_e8) {
        float _e11 = surface.code;
        float _e15 = surface.eta.x;
        Layers _e16 = layersOf(uint(_e11), _e15);
        layersHere = _e16;
    }
    const bool _e18 = hasCoatNormals;
    if (_e18) {
        coatNormalHere = _e4;
    }
    normals = Normals(_e4, _e4);
    const bool _e29 = hasMeshes;
    if (_e29) {
        if ((hit_2.triangle.instance != noInstance)) {
            MeshPoint _e39 = meshPoint(hit_2.triangle.instance, hit_2.triangle.triangle, hit_2.weights);
            normals = Normals(_e39.geometric, _e39.shading);
            const bool _e44 = hasTextures;
            if (_e44) {
                Bumps _e48 = takeUpTextures(surface, _e39.uv, _e39.color.xyz);
                tangent_1 = _e39.tangent;
                bitangent_1 = _e39.bitangent;
                const bool _e52 = hasNormalMaps;
                if (_e52) {
                    if (any(notEqual(_e48.base, vec3(0.0, 0.0, 1.0)))) {
                        vec3 _e78 = validNormal(_e39.geometric, rays_1.direction, (((_e48.base.x * _e39.tangent) + (_e48.base.y * _e39.bitangent)) + (_e48.base.z * _e39.normal)), _e39.shading);
                        normals.shading = _e78;
                    }
                }
                const bool _e80 = hasCoatNormals;
                if (_e80) {
                    coatNormalHere = _e39.shading;
                    if (any(notEqual(_e48.coat, vec3(0.0, 0.0, 1.0)))) {
                        vec3 _e108 = validNormal(_e39.geometric, rays_1.direction, (((_e48.coat.x * _e39.tangent) + (_e48.coat.y * _e39.bitangent)) + (_e48.coat.z * _e39.normal)), _e39.shading);
                        coatNormalHere = _e108;
                    }
                }
            }
            float _e110 = surface.code;
            float _e114 = surface.eta.x;
            bool _e115 = letsThrough(uint(_e110), _e114);
            vec3 _e118 = normals.geometric;
            vec3 _e120 = normals.shading;
            vec3 _e122 = agreed(_e118, _e120, rays_1.direction, _e115);
            normals.shading = _e122;
            const bool _e124 = hasCoatNormals;
            if (_e124) {
                vec3 _e127 = normals.geometric;
                vec3 _e129 = coatNormalHere;
                vec3 _e131 = agreed(_e127, _e129, rays_1.direction, _e115);
                coatNormalHere = _e131;
            }
        }
    }
    const bool _e133 = hasGrain;
    if (_e133) {
        grainHere = vec3(0.0);
        float _e139 = layersHere.anisotropy;
        if ((_e139 > 0.0)) {
            vec3 _e144 = normals.shading;
            vec3 _e145 = tangent_1;
            vec3 _e146 = bitangent_1;
            vec2 _e149 = layersHere.grain;
            vec3 _e150 = grainAt(_e144, _e145, _e146, _e149);
            grainHere = _e150;
        }
    }
    Surface _e151 = surface;
    vec3 _e153 = normals.geometric;
    vec3 _e155 = normals.shading;
    return SurfacePoint(_e151, _e153, _e155);
}

Basis basisAbout(vec3 n_2) {
    float side_8 = pick((n_2.z >= 0.0), 1.0, -1.0);
    float a_8 = (-1.0 / (side_8 + n_2.z));
    float b_11 = ((n_2.x * n_2.y) * a_8);
    return Basis(vec3((1.0 + (((side_8 * n_2.x) * n_2.x) * a_8)), (side_8 * b_11), (-(side_8) * n_2.x)), vec3(b_11, (side_8 + ((n_2.y * n_2.y) * a_8)), -(n_2.y)), n_2);
}

Basis basisAlong(vec3 n_3, vec3 x_16) {
    vec3 tangent_3 = normalize((x_16 - (dot(x_16, n_3) * n_3)));
    return Basis(tangent_3, cross(n_3, tangent_3), n_3);
}

vec3 toLocal(Basis b_5, vec3 v_9) {
    return vec3(dot(v_9, b_5.tangent), dot(v_9, b_5.bitangent), dot(v_9, b_5.normal));
}

bool isThin(uint code_9) {
    const bool _e2 = hasGlass;
    return pick(_e2, ((code_9 & 7u) == 7u), false);
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

vec3 coatNormal(float side) {
    vec3 _e2 = coatNormalHere;
    float _e7 = coatNormalHere.z;
    return vec3((side * _e2.xy), _e7);
}

float coatCosine(float side_1, vec3 w_4) {
    float z = 0.0;
    z = w_4.z;
    const bool _e5 = hasCoatNormals;
    if (_e5) {
        vec3 _e6 = coatNormal(side_1);
        z = dot(_e6, w_4);
    }
    float _e8 = z;
    return abs(_e8);
}

Meeting meetingAt(inout Path p_21, PairHit hit_3) {
    Surface surface_1 = Surface(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    Basis basis = Basis(vec3(0.0), vec3(0.0), vec3(0.0));
    RayPair rays_4 = p_21.rays;
    bool escaped = (hit_3.shape == noShape);
    uint shape_1 = pick(escaped, 0u, hit_3.shape);
    SurfacePoint _e10 = surfaceAt(rays_4, hit_3, shape_1);
    surface_1 = _e10.surface;
    float _e14 = surface_1.code;
    float _e18 = surface_1.eta.x;
    bool _e19 = letsThrough(uint(_e14), _e18);
    vec3 outward_1 = _e10.shading;
    vec3 normal_18 = pick(pick((dot(outward_1, rays_4.direction) > 0.0), !(_e19), false), -(outward_1), outward_1);
    Basis _e29 = basisAbout(normal_18);
    basis = _e29;
    const bool _e32 = hasGrain;
    if (_e32) {
        vec3 _e34 = grainHere;
        if (any(notEqual(_e34, vec3(0.0)))) {
            vec3 _e40 = grainHere;
            Basis _e41 = basisAlong(normal_18, _e40);
            basis = _e41;
        }
    }
    Basis _e42 = basis;
    vec3 _e45 = toLocal(_e42, -(rays_4.direction));
    const bool _e47 = hasGlass;
    const bool _e49 = hasTransmission;
    if (pick(_e47, true, _e49)) {
        float _e52 = surface_1.code;
        bool _e54 = isThin(uint(_e52));
        bool inside_4 = pick(pick(pick(_e19, !(_e54), false), (_e45.z < 0.0), false), !(escaped), false);
        vec3 _e64 = p_21.throughput;
        vec3 _e66 = surface_1.absorption;
        p_21.throughput = (_e64 * exp((-(_e66) * pick(inside_4, hit_3.t, 0.0))));
    }
    const bool _e75 = hasCoatNormals;
    if (_e75) {
        vec3 _e77 = coatNormalHere;
        bool away = pick((dot(_e77, rays_4.direction) > 0.0), !(_e19), false);
        Basis _e85 = basis;
        vec3 _e87 = coatNormalHere;
        vec3 _e89 = coatNormalHere;
        vec3 _e92 = toLocal(_e85, pick(away, -(_e89), _e87));
        coatNormalHere = _e92;
    }
    const bool _e94 = hasCoats;
    if (_e94) {
        vec3 _e96 = surface_1.emission;
        float _e99 = layersHere.coat;
        float _e101 = coatCosine(1.0, _e45);
        float _e102 = coatReflectance(_e99, _e101);
        surface_1.emission = (_e96 * (1.0 - _e102));
    }
    Surface _e111 = surface_1;
    Basis _e113 = basis;
    return Meeting((rays_4.point + (hit_3.t * rays_4.direction)), shape_1, _e111, _e19, _e10.geometric, outward_1, _e113, _e45);
}

vec3 heroColor(vec3 throughput, float u_22) {
    vec3 share_7 = (throughput / vec3(max(dot(throughput, vec3(1.0)), 1e-30)));
    bool isRed = (u_22 < share_7.x);
    bool isBlue = pick(pick(!(isRed), (u_22 >= (share_7.x + share_7.y)), false), (share_7.z > 0.0), false);
    vec3 chosen_2 = pick(isRed, vec3(1.0, 0.0, 0.0), pick(isBlue, vec3(0.0, 0.0, 1.0), vec3(0.0, 1.0, 0.0)));
    return (chosen_2 / vec3(max(dot(chosen_2, share_7), 1e-6)));
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
    float side_9 = (pick((hero.z > 0.0), 1.0, 0.0) - pick((hero.x > 0.0), 1.0, 0.0));
    return max((ior + (((side_9 * (ior - 1.0)) * 0.025) * dispersion)), 1.0);
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

vec3 dielectricF0_() {
    float _e2 = layersHere.ior;
    float _e7 = layersHere.ior;
    float contrast = ((_e2 - 1.0) / (_e7 + 1.0));
    vec3 _e14 = layersHere.specularColor;
    return min(((contrast * contrast) * _e14), vec3(1.0));
}

float singleScatteringAlbedo(float cosine_4, float alpha_1) {
    float x_26 = (cosine_4 / (cosine_4 + alpha_1));
    vec4 byAlpha = (vec4(0.887807, 0.309386, -0.270728, 0.0252433) + (x_26 * (vec4(1.08526, -3.21434, -1.87718, 1.61195) + (x_26 * (vec4(-5.18071, 10.7648, 6.30913, -8.09265) + (x_26 * (vec4(7.80474, -12.743, -24.1046, 25.2536) + (x_26 * vec4(-3.60041, 4.60906, 23.1225, -22.9342)))))))));
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
    float side_10 = pick((o_3.wo.z < 0.0), -1.0, 1.0);
    vec3 _e16 = sampleVisibleNormal((o_3.wo * side_10), max(alpha_5, 0.001), o_3.bound, u_25);
    return (pick(isMirror, vec3(0.0, 0.0, 1.0), _e16) * side_10);
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
    vec3 across_7 = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a_9 * cosine_11) + vec3(sine2_2));
    vec3 alongNear = ((a_9 * cosine_11) - vec3(sine2_2));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across_7) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor_3, vec3 eta_4, vec3 k_2, float cosine_12) {
    float constants = dot((eta_4 + k_2), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_12, eta_4, k_2);
    return pick((constants > 0.0), _e8, baseColor_3);
}

float dielectricFresnel(float cosine_13, float ratio_2) {
    float inside2_ = (((ratio_2 - 1.0) * (ratio_2 + 1.0)) + (cosine_13 * cosine_13));
    float inside_5 = sqrt(max(inside2_, 0.0));
    float across_8 = ((cosine_13 - inside_5) / (cosine_13 + inside_5));
    float along_4 = ((((ratio_2 * ratio_2) * cosine_13) - inside_5) / (((ratio_2 * ratio_2) * cosine_13) + inside_5));
    return pick((inside2_ > 0.0), (0.5 * ((across_8 * across_8) + (along_4 * along_4))), 1.0);
}

float glassReflectance(float cosine_14, float ratio_3, bool thin_1) {
    float _e3 = dielectricFresnel(cosine_14, ratio_3);
    return pick(thin_1, ((2.0 * _e3) / (1.0 + _e3)), _e3);
}

vec3 refracted(vec3 wo_3, vec3 h_2, float ratio_5) {
    float cosine_22 = dot(wo_3, h_2);
    float inside_6 = sqrt(max((((ratio_5 - 1.0) * (ratio_5 + 1.0)) + (cosine_22 * cosine_22)), 0.0));
    return ((((cosine_22 - inside_6) * h_2) - wo_3) / vec3(ratio_5));
}

bool isSolidHere() {
    const bool _e1 = hasTransmission;
    float _e4 = layersHere.solid;
    return pick(_e1, (_e4 > 0.0), false);
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
    float pdf_5 = pick((drawn_2.pdf <= 0.0), 0.0, value_1.w);
    vec3 weight_2 = pick((pdf_5 > 0.0), (value_1.xyz / vec3(max(pdf_5, 1e-30))), vec3(0.0));
    return BsdfSample(drawn_2.direction, pick(drawn_2.delta, drawn_2.pdf, pdf_5), pick(drawn_2.delta, drawn_2.weight, weight_2), drawn_2.delta);
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
    vec4 height_4 = vec4(0.84659, 1.000222, 1.001122, 0.153868);
    vec4 turns = ((mean * (phase * 0.15915494)) + vec4(shift, shift.x));
    vec4 lobes = ((height_4 * cos((6.2831855 * (turns - roundEven(turns))))) * exp((-(variance) * (phase * phase))));
    float x_27 = (lobes.x + lobes.w);
    return vec3((((3.2404542 * x_27) - (1.5371385 * lobes.y)) - (0.4985314 * lobes.z)), (((-0.969266 * x_27) + (1.8760108 * lobes.y)) + (0.041556 * lobes.z)), (((0.0556434 * x_27) - (0.2040259 * lobes.y)) + (1.0572252 * lobes.z)));
}

vec3 filmReflectance(vec3 f0_2, float filmIor, float thickness, float cosine_17) {
    vec3 sum = vec3(0.0);
    vec3 amplitude = vec3(0.0);
    float order = 1.0;
    float sine2_3 = ((1.0 - (cosine_17 * cosine_17)) / (filmIor * filmIor));
    float within_2 = sqrt(max((1.0 - sine2_3), 0.0));
    float first_2 = ((filmIor - 1.0) / (filmIor + 1.0));
    vec3 _e21 = schlick(vec3((first_2 * first_2)), cosine_17);
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
    float d_4 = mix(-1.9776, -1.27393, m_4);
    float e_28 = mix(-4.32054, -4.85967, m_4);
    return (((a_10 / (1.0 + (b_13 * pow(x_17, c_6)))) + (d_4 * x_17)) + e_28);
}

float sheenShadowing(float cosine_19, float alpha_12) {
    float x_28 = clamp(cosine_19, 1e-6, 1.0);
    bool isLow = (x_28 < 0.5);
    float _e12 = shadowingExponent(pick(isLow, x_28, max((1.0 - x_28), 1e-6)), alpha_12);
    float _e14 = shadowingExponent(0.5, alpha_12);
    return exp(pick(isLow, _e12, ((2.0 * _e14) - _e12)));
}

float whiteSheen(vec3 wo_7, vec3 wi_4, float alpha_13) {
    vec3 m_5 = (wo_7 + wi_4);
    float m2_1 = max(dot(m_5, m_5), 1e-20);
    float sine2_4 = clamp((dot(m_5.xy, m_5.xy) / m2_1), 0.0, 1.0);
    float power_1 = (0.5 / alpha_13);
    float density_1 = (((2.0 + (2.0 * power_1)) * 0.15915494) * pick((sine2_4 < 1e-20), 0.0, exp((power_1 * log(max(sine2_4, 1e-20))))));
    float zo = max(wo_7.z, 1e-6);
    float _e38 = sheenShadowing(wo_7.z, alpha_13);
    float _e42 = sheenShadowing(wi_4.z, alpha_13);
    return (density_1 / ((4.0 * zo) * ((1.0 + _e38) + _e42)));
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
    bvec2 middle_3 = greaterThan(low_6, (0.41421357 * high_4));
    vec2 r_7 = (mix(low_6, (low_6 - high_4), middle_3) / max(mix(high_4, (low_6 + high_4), middle_3), vec2(1e-30)));
    vec2 z_7 = (r_7 * r_7);
    vec2 series_1 = ((((((0.080537446 * z_7) - vec2(0.13877685)) * z_7) + vec2(0.19977711)) * z_7) - vec2(0.3333295));
    vec2 angle_1 = (mix(vec2(0.0), vec2(0.7853982), middle_3) + (((series_1 * z_7) * r_7) + r_7));
    return mix(angle_1, (vec2(1.5707964) - angle_1), greaterThan(y_7, x_18));
}

EnvironmentLight lookUpEnvironment(vec3 direction_15) {
    vec2 size_9 = frame.environmentSize;
    float sine_7 = max(length(direction_15.xz), 1e-9);
    vec2 _e15 = quadrantAngles(abs(vec2(direction_15.z, direction_15.y)), vec2(abs(direction_15.x), sine_7));
    float turn_2 = (pick((direction_15.z > 0.0), (3.1415927 - _e15.x), _e15.x) * pick((direction_15.x < 0.0), -1.0, 1.0));
    float _e35 = frame.environmentTurn;
    float column_3 = ((fract(((turn_2 * 0.15915494) + _e35)) * size_9.x) + 0.5);
    float fromPole_1 = ((_e15.y * (size_9.y / 3.1415927)) + 0.5);
    float row_15 = floor(fromPole_1);
    bool isLower_1 = (direction_15.y < 0.0);
    vec2 cell_2 = vec2(floor(column_3), pick(isLower_1, (size_9.y - row_15), row_15));
    float within_3 = (fromPole_1 - row_15);
    vec2 at_4 = vec2((column_3 - cell_2.x), pick(isLower_1, (1.0 - within_3), within_3));
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
                float grown_2 = max((sqrt(dot(e_27.u, e_27.u)) + e_27.reach), 1e-15);
                float _e29 = estimate_1;
                float _e32 = cosineTowards(e_27, -(e_27.u), grown_2, normal_14);
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
    vec3 direction_25 = p_23.rays.direction;
    FarLight _e4 = skySeen(direction_25);
    while(true) {
        uint _e10 = i_26;
        Emitter _e11 = fetchEmitter(_e10);
        FarLight _e12 = farLight(_e11, direction_25, _e4);
        vec3 _e15 = p_23.litSide;
        Odds _e17 = p_23.odds;
        float _e18 = farProbability(_e11, _e15, _e17);
        float pdf_6 = (_e12.pdf * _e18);
        vec3 _e20 = found_9;
        float _e23 = p_23.pdf;
        float _e24 = misWeight(_e23, pdf_6);
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
    vec4 fragment_2 = gl_FragCoord;
    Path p_1 = Path(RayPair(vec3(0.0), 0u, LeftTriangle(0u, 0u), 0.0, false, vec3(0.0), false, vec3(0.0), false, 0.0, 0u, 0u), vec3(0.0), vec3(0.0), false, 0u, vec3(0.0), 0.0, vec3(0.0), Odds(0.0, 0.0), Sampler(0u, 0u, 0u, 0u));
    Lit lit = Lit(LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, false), 0.0, 0.0, Odds(0.0, 0.0), vec3(0.0));
    uvec2 texel_7 = uvec2(fragment_2.xy);
    bool _e3 = wasOver(texel_7);
    if (_e3) {
        discard;
    }
    PairHit _e4 = hitAt(texel_7);
    Path _e5 = pathAt(texel_7);
    p_1 = _e5;
    vec3 _e8 = p_1.radiance;
    vec3 _e10 = p_1.light;
    p_1.radiance = (_e8 + pick(_e4.blocked, vec3(0.0), _e10));
    bool _e18 = p_1.escaped;
    bool _e21 = p_1.rays.goesOn;
    p_1.escaped = pick(_e18, true, pick(_e21, (_e4.shape == noShape), false));
    bool _e31 = p_1.rays.goesOn;
    bool _e33 = p_1.escaped;
    p_1.rays.goesOn = pick(_e31, !(_e33), false);
    vec3 _e38 = p_1.rays.point;
    uint _e41 = p_1.rays.shape;
    uvec4 _e42 = words_1(_e38, _e41);
    vec3 _e45 = p_1.rays.direction;
    Path _e46 = p_1;
    uint _e47 = flagsOf(_e46);
    uvec4 _e48 = words_1(_e45, _e47);
    vec3 _e50 = p_1.throughput;
    float _e52 = p_1.pdf;
    uvec4 _e53 = wordsOf(_e50, _e52);
    vec3 _e55 = p_1.litSide;
    Odds _e63 = p_1.odds;
    lit = Lit(LightSample(_e55, 0.0, vec3(0.0), 0.0, false), 0.0, -1.0, _e63, vec3(0.0));
    bool _e72 = p_1.rays.goesOn;
    if (_e72) {
        Meeting _e73 = meetingAt(p_1, _e4);
        Lit _e74 = lightAt(p_1, _e4, _e73);
        lit = _e74;
    }
    vec3 _e77 = lit.light.direction;
    float _e80 = lit.light.distance_;
    uvec4 _e81 = wordsOf(_e77, _e80);
    vec3 _e84 = lit.light.radiance;
    float _e86 = lit.pdf;
    uvec4 _e87 = wordsOf(_e84, _e86);
    vec3 _e89 = lit.u;
    uint _e92 = p_1.sampler_.key;
    uvec4 _e93 = words_1(_e89, _e92);
    vec3 _e95 = p_1.radiance;
    float _e98 = lit.odds.tree;
    uvec4 _e99 = wordsOf(_e95, _e98);
    float _e101 = lit.shape;
    float _e105 = lit.odds.total;
    bool _e111 = lit.light.delta;
    ChoiceWords _tmp_return = ChoiceWords(_e42, _e48, _e81, _e87, _e53, _e93, _e99, uvec4(floatBitsToUint(_e101), floatBitsToUint(_e105), pick(_e111, 1u, 0u), 0u));
    _fs2p_location0 = _tmp_return.start;
    _fs2p_location1 = _tmp_return.direction;
    _fs2p_location2 = _tmp_return.toLight;
    _fs2p_location3 = _tmp_return.light;
    _fs2p_location4 = _tmp_return.throughput;
    _fs2p_location5 = _tmp_return.u;
    _fs2p_location6 = _tmp_return.radiance;
    _fs2p_location7 = _tmp_return.numbers;
    return;
}

