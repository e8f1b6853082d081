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

struct Film {
    vec4 sums;
    vec4 squares;
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
struct PairHit {
    float t;
    uint shape;
    bool blocked;
    LeftTriangle triangle;
    vec2 weights;
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
struct Cover0_ {
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
struct Cover {
    float left;
    vec4 fibres;
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
struct FarLight {
    vec3 radiance;
    float pdf;
};
const uint noShape = 4294967295u;
const uint noInstance = 4294967295u;
const LeftTriangle noTriangle = LeftTriangle(4294967295u, 0u);
const uint placeMask = 268435455u;
const uint beginning = 2415919101u;
const uint instances = 2147483648u;
const uint ending = 2415919103u;
const uint noLeaf0_ = 0u;
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
const uint metallicRoughness = 1u;
const uint hasNormals = 1u;
const uint hasTangents = 2u;
const uint isUnlit = 1u;
const uint textureUseRows = 3u;
const uint baseColorSlot = 0u;
const uint emissionSlot = 1u;
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
const EnvironmentLight white0_ = EnvironmentLight(vec3(1.0), 0.07957747);

layout(std140) uniform FrameBlock { Frame frame; };

const bool hasFilter = false;

const bool hasLens = false;

const bool hasOtherProjections = false;

const bool hasSpheres = true;

uniform highp sampler2D sceneTable;

const bool hasBoxes = true;

const bool hasTurnedBoxes = true;

const bool hasQuads = false;

const bool hasPlanes = true;

const bool hasMeshes = false;

uint stack[64] = uint[64](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);

const bool hasCutouts = false;

uniform highp usampler2D geometry;

const bool hasOneSided = false;

uniform highp usampler2D texels;

const bool hasOtherLookups = false;

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

const bool hasConductors = false;

Stack stackHere = Stack(vec3(0.0), 0.0, vec3(0.0), 0.0, false, vec3(0.0), vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);

const bool hasCompensation = false;

const bool hasMirrorLayers = true;

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

uniform highp sampler2D previousFilm;

uniform highp sampler2D previousSquares;

layout(location = 0) out vec4 _fs2p_location0;
layout(location = 1) out vec4 _fs2p_location1;

Path noPath() {
    Path p_1 = Path(RayPair(vec3(0.0), 0u, LeftTriangle(0u, 0u), 0.0, false, vec3(0.0), false, vec3(0.0), false, 0.0, 0u, 0u), vec3(0.0), vec3(0.0), false, 0u, vec3(0.0), 0.0, vec3(0.0), Odds(0.0, 0.0), Sampler(0u, 0u, 0u, 0u));
    p_1.rays.lightDirection = vec3(0.0, 1.0, 0.0);
    p_1.rays.lightDistance = -1.0;
    Path _e10 = p_1;
    return _e10;
}

uint pcg(uint x) {
    uint s_26 = ((x * 747796405u) + 2891336453u);
    uint w_5 = (((s_26 >> ((s_26 >> 28u) + 4u)) ^ s_26) * 277803737u);
    return ((w_5 >> 22u) ^ w_5);
}

uint pixelHash(uvec2 pixel, uint sampleIndex, uint seed) {
    uint _e5 = pcg(seed);
    uint _e7 = pcg((sampleIndex + _e5));
    uint _e9 = pcg((pixel.y + _e7));
    uint _e11 = pcg((pixel.x + _e9));
    return _e11;
}

uint spread0_(uint x_1) {
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
    uint _e19 = spread0_((pixel_1.x & 15u));
    uint _e23 = spread0_((pixel_1.y & 15u));
    uint place_5 = (_e19 | (_e23 * 2u));
    uvec2 _e32 = reversed(uvec2((sampleIndex_1 & 65535u), (place_5 * 256u)));
    uvec2 digits_2 = pick(independent, uvec2(0u), _e32);
    uint _e38 = mixBits((_e15 ^ 1779033703u));
    return Sampler(_e15, _e38, digits_2.x, digits_2.y);
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

vec2 filterOffset(vec2 u_1) {
    vec2 offset = vec2(0.0);
    offset = (u_1 - vec2(0.5));
    const bool _e6 = hasFilter;
    if (_e6) {
        float _e8 = filterAxis(u_1.x);
        float _e10 = filterAxis(u_1.y);
        offset = vec2(_e8, _e10);
    }
    vec2 _e12 = offset;
    return _e12;
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

Groups nextGroups(Sampler s) {
    uvec2 _e7 = mixBits2_((uvec2(s.key) + uvec2(1u, 2u)));
    uvec2 half_ = ((_e7 ^ uvec2(s.salt)) * 2654435761u);
    uvec2 b_8 = (half_ ^ (half_ >> uvec2(16u)));
    uvec2 _e19 = scramble(uvec2(s.place), b_8);
    uvec2 own_3 = (s.sample_ * ((_e19 >> uvec2(7u)) & uvec2(4294967294u)));
    uvec2 _e31 = scramble((uvec2(s.sample_) ^ own_3), _e7);
    uvec2 _e35 = reversed((_e31 & uvec2(65535u)));
    uvec2 _e39 = shiftOfPlace((_e19 & uvec2(255u)));
    return Groups(_e35, _e39, ((_e7 >> uvec2(16u)) | (_e7 * 65536u)), ((b_8 >> uvec2(16u)) | (b_8 * 65536u)));
}

void skipGroup(inout Sampler s_1) {
    uint _e3 = s_1.key;
    s_1.key = (_e3 + 1u);
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

vec2 next2d(inout Sampler s_2) {
    Sampler _e1 = s_2;
    Groups _e2 = nextGroups(_e1);
    skipGroup(s_2);
    vec2 _e3 = firstOf(_e2);
    vec2 _e5 = secondOf(_e2);
    return vec2(_e3.x, _e5.x);
}

vec2 concentricDisc(vec2 u_2) {
    vec2 p_22 = ((2.0 * u_2) - vec2(1.0));
    bool wide = (abs(p_22.x) > abs(p_22.y));
    float radius_1 = pick(wide, p_22.x, p_22.y);
    float ratio_6 = (pick(wide, p_22.y, p_22.x) / pick((radius_1 == 0.0), 1.0, radius_1));
    float angle = pick(wide, (0.7853982 * ratio_6), (1.5707964 - (0.7853982 * ratio_6)));
    return (radius_1 * vec2(cos(angle), sin(angle)));
}

CameraRay rayThroughLens(vec2 filmPosition, vec2 lensPoint) {
    CameraRay ray = CameraRay(vec3(0.0), vec3(0.0));
    float _e7 = frame.width;
    float x_20 = (((2.0 * filmPosition.x) / _e7) - 1.0);
    float _e16 = frame.height;
    float y_9 = (1.0 - ((2.0 * filmPosition.y) / _e16));
    vec3 _e22 = frame.right;
    vec3 _e26 = frame.up;
    vec3 across_1 = ((x_20 * _e22) + (y_9 * _e26));
    const bool _e30 = hasOtherProjections;
    uint _e33 = frame.projection;
    bool orthographic = pick(_e30, (_e33 == 1u), false);
    vec3 _e39 = frame.forward;
    vec3 _e43 = frame.forward;
    vec3 ahead = pick(orthographic, _e43, (_e39 + across_1));
    float _e47 = frame.aperture;
    vec3 _e51 = frame.right;
    vec3 _e57 = frame.up;
    vec3 lens_1 = (_e47 * ((lensPoint.x * normalize(_e51)) + (lensPoint.y * normalize(_e57))));
    float _e66 = frame.focusDistance;
    ray = CameraRay(pick(orthographic, (across_1 + lens_1), lens_1), normalize((ahead - (lens_1 / vec3(_e66)))));
    const bool _e74 = hasOtherProjections;
    if (_e74) {
        uint _e77 = frame.projection;
        if ((_e77 == 2u)) {
            float longitude = (3.1415927 * x_20);
            float latitude = (1.5707964 * y_9);
            vec3 _e87 = frame.right;
            vec3 _e92 = frame.forward;
            vec3 level_1 = ((sin(longitude) * _e87) + (cos(longitude) * _e92));
            vec3 _e102 = frame.up;
            ray = CameraRay(vec3(0.0), normalize(((cos(latitude) * level_1) + (sin(latitude) * _e102))));
        }
    }
    CameraRay _e107 = ray;
    return _e107;
}

CameraRay cameraRay(vec2 filmPosition_1, vec2 lens) {
    vec2 lensPoint_1 = vec2(0.0);
    const bool _e6 = hasLens;
    if (_e6) {
        vec2 _e7 = concentricDisc(lens);
        lensPoint_1 = _e7;
    }
    vec2 _e8 = lensPoint_1;
    CameraRay _e9 = rayThroughLens(filmPosition_1, _e8);
    return _e9;
}

vec2 lensPoint_2(inout Sampler s_3) {
    vec2 u_3 = vec2(0.5);
    const bool _e5 = hasLens;
    if (_e5) {
        vec2 _e6 = next2d(s_3);
        u_3 = _e6;
    } else {
        skipGroup(s_3);
    }
    vec2 _e7 = u_3;
    return _e7;
}

uint numberOfNext(Sampler s_4) {
    uint _e8 = mixBits((((s_4.key + 1u) ^ s_4.salt) ^ 2246822507u));
    uint _e15 = mixBits((_e8 + ((s_4.sample_ << 8u) | s_4.place)));
    return _e15;
}

void startPath(inout Path p_2, uvec2 pixel_2, uint sampleIndex_2) {
    uint _e6 = frame.seed;
    Sampler _e7 = startSampler(pixel_2, sampleIndex_2, _e6);
    p_2.sampler_ = _e7;
    vec2 _e13 = next2d(p_2.sampler_);
    vec2 _e14 = filterOffset(_e13);
    vec2 filmPosition_2 = ((vec2(pixel_2) + vec2(0.5)) + _e14);
    vec2 _e17 = lensPoint_2(p_2.sampler_);
    CameraRay _e18 = cameraRay(filmPosition_2, _e17);
    p_2.rays.point = _e18.origin;
    p_2.rays.shape = noShape;
    p_2.rays.left = noTriangle;
    p_2.rays.tMin = 0.0;
    p_2.rays.goesOn = true;
    p_2.rays.direction = _e18.direction;
    Sampler _e40 = p_2.sampler_;
    uint _e41 = numberOfNext(_e40);
    p_2.rays.number = _e41;
    p_2.light = vec3(0.0);
    p_2.throughput = vec3(1.0);
    p_2.depth = 1u;
    p_2.radiance = vec3(0.0);
    p_2.pdf = 0.0;
    return;
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
    vec3 across_2 = (toCenter - (along * direction));
    float discriminant = ((radius * radius) - dot(across_2, across_2));
    float half_1 = sqrt(max(discriminant, 0.0));
    float near = (along - half_1);
    float far_4 = (along + half_1);
    float t_8 = pick((near > tMin), near, far_4);
    return pick(startsInside, max(far_4, 0.0), pick(pick((discriminant >= 0.0), (t_8 > tMin), false), t_8, 1e30));
}

PairHit meet(PairHit found, RayPair p_3, uint i_1, vec2 t) {
    bool own_4 = (i_1 == p_3.shape);
    float pathT = pick(pick(own_4, !(p_3.inwards), false), 1e30, t.x);
    float lightT = pick(pick(pick(own_4, !(p_3.lightInwards), false), true, (i_1 == p_3.lightShape)), 1e30, t.y);
    bool nearer_1 = (pathT < found.t);
    return PairHit(pick(nearer_1, pathT, found.t), pick(nearer_1, i_1, found.shape), pick(found.blocked, true, (lightT < p_3.lightDistance)), noTriangle, vec2(0.0));
}

PairHit meetSphere(PairHit found_1, RayPair p_4, uint i_2) {
    Bounds _e3 = fetchBounds(i_2);
    bool own_5 = (i_2 == p_4.shape);
    float _e13 = intersectSphere(p_4.point, p_4.direction, _e3.center, _e3.radius, p_4.tMin, pick(own_5, p_4.inwards, false));
    float _e21 = intersectSphere(p_4.point, p_4.lightDirection, _e3.center, _e3.radius, p_4.tMin, pick(own_5, p_4.lightInwards, false));
    PairHit _e23 = meet(found_1, p_4, i_2, vec2(_e13, _e21));
    return _e23;
}

Extent fetchExtent(uint i_3) {
    vec4 _e2 = tableTexel(1u, i_3);
    vec4 _e4 = tableTexel(2u, i_3);
    return Extent(_e2.xyzw, _e4.xyzw);
}

vec3 rotate(vec4 q, vec3 v) {
    vec3 t_9 = (2.0 * cross(q.xyz, v));
    return ((v + (q.w * t_9)) + cross(q.xyz, t_9));
}

vec3 turned(vec4 q_1, vec3 v_1) {
    vec3 w = vec3(0.0);
    w = v_1;
    const bool _e4 = hasTurnedBoxes;
    if (_e4) {
        vec3 _e5 = rotate(q_1, v_1);
        w = _e5;
    }
    vec3 _e6 = w;
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

PairHit meetBox(PairHit found_2, RayPair p_5, uint i_4) {
    Bounds _e3 = fetchBounds(i_4);
    Extent _e4 = fetchExtent(i_4);
    bool own_6 = (i_4 == p_5.shape);
    vec3 _e11 = turned(_e4.a, (p_5.point - _e3.center));
    vec3 _e14 = turned(_e4.a, p_5.direction);
    float _e20 = intersectBox(_e11, _e14, _e4.b.xyz, p_5.tMin, pick(own_6, p_5.inwards, false));
    vec3 _e23 = turned(_e4.a, p_5.lightDirection);
    float _e29 = intersectBox(_e11, _e23, _e4.b.xyz, p_5.tMin, pick(own_6, p_5.lightInwards, false));
    PairHit _e31 = meet(found_2, p_5, i_4, vec2(_e20, _e29));
    return _e31;
}

float intersectQuad(vec3 origin_4, vec3 direction_3, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_15 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_3, normal_15);
    vec3 toCenter_1 = (center_1 - origin_4);
    float t_11 = (dot(toCenter_1, normal_15) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_23 = ((t_11 * direction_3) - toCenter_1);
    bool within = (max(abs(dot(p_23, reciprocalU)), abs(dot(p_23, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_11 > tMin_2), (t_11 < 1e30), false), within, false), t_11, 1e30);
}

PairHit meetQuad(PairHit found_3, RayPair p_6, uint i_5) {
    Bounds _e3 = fetchBounds(i_5);
    Extent _e4 = fetchExtent(i_5);
    float _e13 = intersectQuad(p_6.point, p_6.direction, _e3.center, _e4.a.xyz, _e4.b.xyz, p_6.tMin);
    float _e22 = intersectQuad(p_6.point, p_6.lightDirection, _e3.center, _e4.a.xyz, _e4.b.xyz, p_6.tMin);
    PairHit _e24 = meet(found_3, p_6, i_5, vec2(_e13, _e22));
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

PairHit meetPlane(PairHit found_4, RayPair p_7, uint i_6) {
    Bounds _e3 = fetchBounds(i_6);
    float _e9 = intersectPlane(p_7.point, p_7.direction, _e3.center, _e3.radius, p_7.tMin);
    float _e15 = intersectPlane(p_7.point, p_7.lightDirection, _e3.center, _e3.radius, p_7.tMin);
    PairHit _e17 = meet(found_4, p_7, i_6, vec2(_e9, _e15));
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

vec3 turnedTo(uint axis, vec3 v_2) {
    return pick((axis == 0u), v_2.yzx, pick((axis == 1u), v_2.zxy, v_2));
}

MeshRay meshRay(vec3 origin_7, vec3 direction_6) {
    vec3 size_1 = abs(direction_6);
    uint axis_3 = pick((size_1.z >= max(size_1.x, size_1.y)), 2u, pick((size_1.y > size_1.x), 1u, 0u));
    vec3 _e16 = turnedTo(axis_3, direction_6);
    return MeshRay(origin_7, axis_3, vec3((-(_e16.xy) / vec2(_e16.z)), (1.0 / _e16.z)));
}

vec4 larger0_(vec4 a, vec4 b) {
    return intBitsToFloat(max(floatBitsToInt(a), floatBitsToInt(b)));
}

vec4 planes(uint row_2, float inverse_, float offset_2) {
    uvec4 _e3 = geometryRow(row_2);
    return ((uintBitsToFloat(_e3) * inverse_) + vec4(offset_2));
}

vec4 smaller0_(vec4 a_1, vec4 b_1) {
    return intBitsToFloat(min(floatBitsToInt(a_1), floatBitsToInt(b_1)));
}

vec4 enterChildren(uint node, SlabRay r, float t_1) {
    uvec3 far_5 = (uvec3(3u, 5u, 7u) - r.near);
    vec4 _e16 = planes((node + r.near.x), r.inverse_.x, r.offset.x);
    vec4 _e24 = planes((node + r.near.y), r.inverse_.y, r.offset.y);
    vec4 _e25 = larger0_(_e16, _e24);
    vec4 _e33 = planes((node + r.near.z), r.inverse_.z, r.offset.z);
    vec4 _e36 = larger0_(_e33, vec4(0.0));
    vec4 _e37 = larger0_(_e25, _e36);
    vec4 _e44 = planes((node + far_5.x), r.inverse_.x, r.offset.x);
    vec4 _e51 = planes((node + far_5.y), r.inverse_.y, r.offset.y);
    vec4 _e52 = smaller0_(_e44, _e51);
    vec4 _e59 = planes((node + far_5.z), r.inverse_.z, r.offset.z);
    vec4 _e60 = smaller0_(_e52, _e59);
    vec4 _e66 = smaller0_((_e60 * 1.000001), vec4(t_1));
    return mix(vec4(1e30), _e37, lessThanEqual(_e37, _e66));
}

float edge(vec2 a_2, vec2 b_2) {
    float p_24 = (a_2.x * b_2.y);
    float q_6 = (a_2.y * b_2.x);
    return ((a_2.x * b_2.y + -(q_6)) - (a_2.y * b_2.x + -(p_24)));
}

bool isWithin(float u_4, float v_3, float w_1) {
    return pick(pick(pick((u_4 >= 0.0), (v_3 >= 0.0), false), (w_1 >= 0.0), false), true, pick(pick((u_4 <= 0.0), (v_3 <= 0.0), false), (w_1 <= 0.0), false));
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

Cover0_ coverAt(uvec3 rows, uint each, vec2 weights) {
    Cover0_ c = Cover0_(vec4(0.0), 1.0);
    vec3 share_1 = vec3(((1.0 - weights.x) - weights.y), weights);
    if ((each != 0u)) {
        Vertex _e19 = fetchVertex(rows.x);
        Vertex _e24 = fetchVertex(rows.y);
        Vertex _e30 = fetchVertex(rows.z);
        c.uv = vec4((((share_1.x * _e19.uv) + (share_1.y * _e24.uv)) + (share_1.z * _e30.uv)), 0.0, 0.0);
    }
    if ((each > vertexRows)) {
        uvec3 more = (rows + uvec3(1u));
        VertexMore _e43 = fetchVertexMore(more.x);
        VertexMore _e45 = fetchVertexMore(more.y);
        VertexMore _e47 = fetchVertexMore(more.z);
        vec4 _e50 = c.uv;
        c.uv = vec4(_e50.xy, (((share_1.x * _e43.uv) + (share_1.y * _e45.uv)) + (share_1.z * _e47.uv)));
        vec2 _e66 = pairOf(_e43.blueAlpha);
        vec2 _e69 = pairOf(_e45.blueAlpha);
        vec2 _e72 = pairOf(_e47.blueAlpha);
        c.opacity = dot(share_1, vec3(_e66.y, _e69.y, _e72.y));
    }
    Cover0_ _e76 = c;
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

vec4 decoded(uint texel, bool colored) {
    vec4 c_4 = (vec4(((uvec4(texel) >> uvec4(0u, 8u, 16u, 24u)) & uvec4(255u))) / vec4(255.0));
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
    uint flags = pick(_e7, t_2.flags, 0u);
    bool nearest_1 = ((flags & isNearest) != 0u);
    Neighbours _e24 = neighbours(dot(t_2.toU, place_6), t_2.width, ((flags & clampsU) != 0u), ((flags & mirrorsU) != 0u), nearest_1);
    Neighbours _e36 = neighbours(dot(t_2.toV, place_6), t_2.height, ((flags & clampsV) != 0u), ((flags & mirrorsV) != 0u), nearest_1);
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
    Cover0_ _e30 = coverAt((uvec3(_e10.vertices) + (uvec3(_e15.vertexA, _e15.vertexB, _e15.vertexC) * _e10.vertexRows)), _e10.vertexRows, weights_1);
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

MeshHit traverse(MeshRays rays, LeftTriangle left) {
    MeshHit found_5 = MeshHit(0.0, 0u, 0u, vec2(0.0), false);
    bool toLight = false;
    float most = 0.0;
    uint instance_1 = noInstance;
    uint nodes = 0u;
    uint triangles = 0u;
    uint cover = 0u;
    uint own = placeMask;
    SlabRay slabs = SlabRay(vec3(0.0), vec3(0.0), uvec3(0u));
    MeshRay ray_2 = MeshRay(vec3(0.0), 0u, vec3(0.0));
    MeshHit doubted = MeshHit(0.0, 0u, 0u, vec2(0.0), false);
    uint top = 1u;
    uint current = 0u;
    uint waiting = noLeaf0_;
    vec3 o = vec3(0.0);
    vec3 d_1 = vec3(0.0);
    bool nearer = false;
    found_5 = MeshHit(rays.most, noInstance, 0u, vec2(0.0), false);
    toLight = !((rays.most > 0.0));
    bool _e17 = toLight;
    most = pick(_e17, rays.lightMost, rays.most);
    MeshHit _e45 = found_5;
    doubted = _e45;
    uint _e49 = frame.instanceCount;
    bool alone = (_e49 == 1u);
    uint first_1 = pick(alone, instances, beginning);
    uint _e57 = frame.instanceCount;
    float _e60 = most;
    if (pick((_e57 == 0u), true, !((_e60 > 0.0)))) {
        MeshHit _e65 = found_5;
        return _e65;
    }
    stack[0] = ending;
    current = first_1;
    while(true) {
        const bool _e75 = hasCutouts;
        uint _e77 = waiting;
        uint _e80 = current;
        bool _e81 = isAmongInstances(_e80);
        if (pick(!(_e75), true, pick((_e77 == noLeaf0_), _e81, false))) {
            uint _e84 = current;
            bool toWorld_1 = (_e84 >= beginning);
            uint _e87 = current;
            instance_1 = pick(toWorld_1, noInstance, (_e87 & placeMask));
            o = rays.origin;
            bool _e96 = toLight;
            d_1 = pick(_e96, rays.lightDirection, rays.direction);
            nodes = 0u;
            if (!(toWorld_1)) {
                uint _e103 = frame.instances;
                uint _e104 = instance_1;
                Instance _e108 = fetchInstance((_e103 + (_e104 * instanceRows)));
                vec3 _e109 = o;
                vec4 p_25 = vec4(_e109, 1.0);
                o = vec3(dot(_e108.toMeshX, p_25), dot(_e108.toMeshY, p_25), dot(_e108.toMeshZ, p_25));
                vec3 _e121 = d_1;
                vec3 _e125 = d_1;
                vec3 _e129 = d_1;
                d_1 = vec3(dot(_e108.toMeshX.xyz, _e121), dot(_e108.toMeshY.xyz, _e125), dot(_e108.toMeshZ.xyz, _e129));
                nodes = _e108.nodes;
                triangles = _e108.triangles;
                cover = _e108.cover;
                uint _e137 = instance_1;
                own = pick((_e137 == left.instance), left.triangle, placeMask);
                if (!(alone)) {
                    uint _e143 = top;
                    stack[_e143] = leaving;
                    uint _e147 = top;
                    top = (_e147 + 1u);
                }
            }
            vec3 _e149 = o;
            vec3 _e150 = d_1;
            SlabRay _e151 = slabRay(_e149, _e150);
            slabs = _e151;
            vec3 _e152 = o;
            vec3 _e153 = d_1;
            MeshRay _e154 = meshRay(_e152, _e153);
            ray_2 = _e154;
            uint _e157 = current;
            current = pick((_e157 == leaving), unread, 0u);
        }
        while(true) {
            uint _e161 = current;
            if ((_e161 == unread)) {
                uint _e165 = top;
                top = (_e165 - 1u);
                uint _e168 = top;
                uint _e170 = stack[_e168];
                current = _e170;
            }
            uint _e171 = current;
            if ((_e171 < instances)) {
                uint _e174 = nodes;
                uint _e175 = current;
                uint node_2 = (_e174 + (_e175 * nodeRows));
                uvec4 _e181 = geometryRow((node_2 + childrenRow));
                SlabRay _e182 = slabs;
                float _e183 = most;
                vec4 _e184 = enterChildren(node_2, _e182, _e183);
                ivec4 t_13 = floatBitsToInt(_e184);
                bool a_5 = (t_13.x < t_13.z);
                bool b_9 = (t_13.y < t_13.w);
                uvec2 r0_ = pick(a_5, uvec2(_e181.z, _e181.x), uvec2(_e181.x, _e181.z));
                uvec2 r1_ = pick(b_9, uvec2(_e181.w, _e181.y), uvec2(_e181.y, _e181.w));
                int far0_ = max(t_13.x, t_13.z);
                int far1_ = max(t_13.y, t_13.w);
                int near0_ = min(t_13.x, t_13.z);
                int near1_ = min(t_13.y, t_13.w);
                uvec2 ra = pick((far0_ < far1_), uvec2(r1_.x, r0_.x), uvec2(r0_.x, r1_.x));
                uvec2 rb = pick((near0_ < near1_), uvec2(r1_.y, r0_.y), uvec2(r0_.y, r1_.y));
                int far2_ = min(far0_, far1_);
                int near2_ = max(near0_, near1_);
                uvec2 rm = pick((far2_ < near2_), uvec2(rb.x, ra.y), uvec2(ra.y, rb.x));
                uint _e245 = top;
                stack[_e245] = ra.x;
                uint _e248 = top;
                top = (_e248 + pick((max(far0_, far1_) < notEntered), 1u, 0u));
                uint _e257 = top;
                stack[_e257] = rm.x;
                uint _e260 = top;
                top = (_e260 + pick((max(far2_, near2_) < notEntered), 1u, 0u));
                uint _e269 = top;
                stack[_e269] = rm.y;
                uint _e272 = top;
                top = (_e272 + pick((min(far2_, near2_) < notEntered), 1u, 0u));
                current = pick((min(near0_, near1_) < notEntered), rb.y, unread);
            }
            uint _e286 = waiting;
            uint _e289 = current;
            bool takes = pick((_e286 == noLeaf0_), (_e289 >= leaves), false);
            uint _e293 = waiting;
            uint _e294 = current;
            waiting = pick(takes, _e294, _e293);
            uint _e296 = current;
            current = pick(takes, unread, _e296);
            uint _e299 = waiting;
            if ((_e299 != noLeaf0_)) {
                uint _e302 = waiting;
                uint place_7 = (_e302 & placeMask);
                uint _e305 = waiting;
                waiting = ((_e305 + 1u) - 268435456u);
                uint _e310 = waiting;
                uint _e312 = waiting;
                waiting = pick((_e312 < leaves), noLeaf0_, _e310);
                MeshRay _e316 = ray_2;
                uint _e317 = triangles;
                Triangle _e321 = fetchTriangle((_e317 + (place_7 * triangleRows)));
                Crossing _e322 = crossTriangle(_e316, _e321);
                float _e331 = most;
                uint _e336 = own;
                nearer = pick(pick(pick(_e322.within, (_e322.depth > (rays.least * _e322.sum)), false), (_e322.depth < (_e331 * _e322.sum)), false), (place_7 != _e336), false);
                const bool _e341 = hasOneSided;
                if (_e341) {
                    bool _e342 = nearer;
                    uint _e344 = cover;
                    nearer = pick(_e342, pick(_e322.front, true, ((_e344 & isOneSided) == 0u)), false);
                }
                float inverse_2 = (1.0 / _e322.sum);
                float t_14 = (_e322.depth * inverse_2);
                vec2 weights_3 = (_e322.weights * inverse_2);
                const bool _e359 = hasCutouts;
                if (_e359) {
                    bool _e360 = nearer;
                    uint _e361 = cover;
                    if (pick(_e360, ((_e361 & coverRow) != 0u), false)) {
                        uint _e367 = instance_1;
                        doubted = MeshHit(t_14, _e367, place_7, weights_3, false);
                        nearer = false;
                    }
                }
                bool _e371 = nearer;
                bool _e372 = toLight;
                bool blocks = pick(_e371, _e372, false);
                bool _e374 = nearer;
                bool _e375 = toLight;
                bool counts = pick(_e374, !(_e375), false);
                float _e378 = most;
                bool _e379 = nearer;
                most = pick(_e379, t_14, _e378);
                float _e383 = found_5.t;
                found_5.t = pick(counts, t_14, _e383);
                uint _e387 = found_5.instance;
                uint _e388 = instance_1;
                found_5.instance = pick(counts, _e388, _e387);
                uint _e392 = found_5.triangle;
                found_5.triangle = pick(counts, place_7, _e392);
                vec2 _e396 = found_5.weights;
                found_5.weights = pick(counts, weights_3, _e396);
                bool _e400 = found_5.blocked;
                found_5.blocked = pick(_e400, true, blocks);
                uint _e402 = waiting;
                waiting = pick(blocks, noLeaf0_, _e402);
                uint _e405 = current;
                current = pick(blocks, ending, _e405);
            }
            uint _e408 = waiting;
            uint _e411 = current;
            bool _e412 = isAmongInstances(_e411);
            const bool _e415 = hasCutouts;
            uint _e417 = doubted.instance;
            if (pick(pick((_e408 == noLeaf0_), _e412, false), true, pick(_e415, (_e417 != noInstance), false))) {
                break;
            }
        }
        const bool _e423 = hasCutouts;
        if (_e423) {
            uint _e425 = doubted.instance;
            if ((_e425 != noInstance)) {
                uint _e429 = doubted.instance;
                uint _e431 = doubted.triangle;
                vec2 _e433 = doubted.weights;
                bool _e435 = toLight;
                bool _e438 = isThere(_e429, _e431, _e433, (rays.number + uint(_e435)));
                MeshHit instead = doubted;
                doubted.instance = noInstance;
                bool _e442 = toLight;
                if (pick(_e438, _e442, false)) {
                    found_5.blocked = true;
                    break;
                }
                if (_e438) {
                    most = instead.t;
                    found_5 = instead;
                }
            }
        }
        uint _e447 = current;
        uint _e450 = waiting;
        bool ended = pick((_e447 == ending), (_e450 == noLeaf0_), false);
        bool _e454 = toLight;
        if (pick(ended, pick(_e454, true, !((rays.lightMost > 0.0))), false)) {
            break;
        }
        bool _e461 = toLight;
        toLight = pick(_e461, true, ended);
        float _e463 = most;
        most = pick(ended, rays.lightMost, _e463);
        uint _e466 = top;
        top = pick(ended, 1u, _e466);
        uint _e469 = current;
        current = pick(ended, first_1, _e469);
    }
    MeshHit _e471 = found_5;
    return _e471;
}

uint rowOfInstance(uint instance_2) {
    uint _e3 = frame.instances;
    Instance _e7 = fetchInstance((_e3 + (instance_2 * instanceRows)));
    return _e7.row;
}

PairHit meetMeshes(PairHit found_6, RayPair p_8) {
    PairHit result = PairHit(0.0, 0u, false, LeftTriangle(0u, 0u), vec2(0.0));
    float most_1 = pick(p_8.goesOn, found_6.t, -1.0);
    float lightMost = pick(found_6.blocked, -1.0, p_8.lightDistance);
    MeshHit _e17 = traverse(MeshRays(p_8.point, p_8.direction, p_8.lightDirection, p_8.tMin, most_1, lightMost, p_8.number), p_8.left);
    result = PairHit(found_6.t, found_6.shape, pick(found_6.blocked, true, _e17.blocked), noTriangle, _e17.weights);
    if ((_e17.instance != noInstance)) {
        result.t = _e17.t;
        uint _e34 = rowOfInstance(_e17.instance);
        result.shape = _e34;
        result.triangle = LeftTriangle(_e17.instance, _e17.triangle);
    }
    PairHit _e39 = result;
    return _e39;
}

PairHit tracePair(RayPair p_9) {
    PairHit found_7 = PairHit(1e30, 4294967295u, false, LeftTriangle(4294967295u, 0u), vec2(0.0));
    uint i_10 = 0u;
    uvec4 ends_1 = frame.shapeEnds;
    const bool _e17 = hasSpheres;
    if (_e17) {
        uint _e18 = i_10;
        if ((_e18 < ends_1.x)) {
            while(true) {
                PairHit _e21 = found_7;
                uint _e22 = i_10;
                PairHit _e23 = meetSphere(_e21, p_9, _e22);
                found_7 = _e23;
                uint _e25 = i_10;
                i_10 = (_e25 + 1u);
                uint _e27 = i_10;
                if ((_e27 >= ends_1.x)) {
                    break;
                }
            }
        }
    }
    const bool _e31 = hasBoxes;
    if (_e31) {
        uint _e32 = i_10;
        if ((_e32 < ends_1.y)) {
            while(true) {
                PairHit _e35 = found_7;
                uint _e36 = i_10;
                PairHit _e37 = meetBox(_e35, p_9, _e36);
                found_7 = _e37;
                uint _e39 = i_10;
                i_10 = (_e39 + 1u);
                uint _e41 = i_10;
                if ((_e41 >= ends_1.y)) {
                    break;
                }
            }
        }
    }
    const bool _e45 = hasQuads;
    if (_e45) {
        uint _e46 = i_10;
        if ((_e46 < ends_1.z)) {
            while(true) {
                PairHit _e49 = found_7;
                uint _e50 = i_10;
                PairHit _e51 = meetQuad(_e49, p_9, _e50);
                found_7 = _e51;
                uint _e53 = i_10;
                i_10 = (_e53 + 1u);
                uint _e55 = i_10;
                if ((_e55 >= ends_1.z)) {
                    break;
                }
            }
        }
    }
    const bool _e59 = hasPlanes;
    if (_e59) {
        uint _e60 = i_10;
        if ((_e60 < ends_1.w)) {
            while(true) {
                PairHit _e63 = found_7;
                uint _e64 = i_10;
                PairHit _e65 = meetPlane(_e63, p_9, _e64);
                found_7 = _e65;
                uint _e67 = i_10;
                i_10 = (_e67 + 1u);
                uint _e69 = i_10;
                if ((_e69 >= ends_1.w)) {
                    break;
                }
            }
        }
    }
    const bool _e73 = hasMeshes;
    if (_e73) {
        PairHit _e74 = found_7;
        PairHit _e75 = meetMeshes(_e74, p_9);
        found_7 = _e75;
    }
    PairHit _e76 = found_7;
    return _e76;
}

bool isPlane(uint i_11) {
    uint _e4 = frame.shapeEnds.z;
    uint _e9 = frame.shapeEnds.w;
    return pick((i_11 >= _e4), (i_11 < _e9), false);
}

vec3 boxNormal(vec3 origin_8, vec3 direction_7, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_8, direction_7, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_15 = pick(entering, _e5.near, _e5.far);
    vec3 side_3 = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_7, vec3(0.0))));
    bool onX = (crossed.x == t_15);
    bool onY = pick(!(onX), (crossed.y == t_15), false);
    return (side_3 * mix(vec3(0.0), vec3(1.0), bvec3(onX, onY, !(pick(onX, true, onY)))));
}

vec3 turnedBack(vec4 q_2, vec3 v_4) {
    vec3 _e6 = turned(vec4(-(q_2.xyz), q_2.w), v_4);
    return _e6;
}

bool isBox(uint i_12) {
    uint _e4 = frame.shapeEnds.x;
    uint _e9 = frame.shapeEnds.y;
    return pick((i_12 >= _e4), (i_12 < _e9), false);
}

bool isSphere(uint i_13) {
    uint _e4 = frame.shapeEnds.x;
    return (i_13 < _e4);
}

vec3 normalAt(RayPair p_10, float t_3, uint i_14) {
    vec3 normal_1 = vec3(0.0);
    Bounds _e3 = fetchBounds(i_14);
    vec3 origin_9 = (p_10.point - _e3.center);
    normal_1 = _e3.center;
    const bool _e10 = hasQuads;
    if (_e10) {
        Extent _e11 = fetchExtent(i_14);
        vec3 _e17 = normal_1;
        bool _e18 = isPlane(i_14);
        normal_1 = pick(_e18, _e17, cross(_e11.a.xyz, _e11.b.xyz));
    }
    const bool _e21 = hasBoxes;
    if (_e21) {
        Extent _e22 = fetchExtent(i_14);
        bool inside_1 = pick((i_14 == p_10.shape), p_10.inwards, false);
        vec3 _e28 = turned(_e22.a, origin_9);
        vec3 _e31 = turned(_e22.a, p_10.direction);
        vec3 _e35 = boxNormal(_e28, _e31, _e22.b.xyz, p_10.tMin, inside_1);
        vec3 _e36 = normal_1;
        vec3 _e38 = turnedBack(_e22.a, _e35);
        bool _e39 = isBox(i_14);
        normal_1 = pick(_e39, _e38, _e36);
    }
    const bool _e42 = hasSpheres;
    if (_e42) {
        vec3 outwards = (origin_9 + (t_3 * p_10.direction));
        vec3 _e46 = normal_1;
        bool _e53 = isSphere(i_14);
        normal_1 = pick(_e53, pick((dot(outwards, outwards) == 0.0), -(p_10.direction), outwards), _e46);
    }
    vec3 _e55 = normal_1;
    return normalize(_e55);
}

Surface fetchSurface(uint i_15) {
    vec4 _e2 = tableTexel(9u, i_15);
    vec4 _e4 = tableTexel(10u, i_15);
    vec4 _e6 = tableTexel(11u, i_15);
    vec4 _e8 = tableTexel(12u, i_15);
    vec4 _e10 = tableTexel(13u, i_15);
    return Surface(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.xyz, _e10.w);
}

uint kindOf(uint code) {
    return (code & 3u);
}

bool isMetallicRoughness(uint code_1) {
    const bool _e2 = hasMetallicRoughness;
    uint _e3 = kindOf(code_1);
    return pick(_e2, (_e3 == metallicRoughness), false);
}

bool isLayered(uint code_2) {
    const bool _e2 = hasLayers;
    bool _e3 = isMetallicRoughness(code_2);
    return pick(_e2, _e3, false);
}

Layers fetchLayers(uint i_16) {
    vec4 _e2 = tableTexel(0u, i_16);
    vec4 _e4 = tableTexel(1u, i_16);
    vec4 _e6 = tableTexel(2u, i_16);
    vec4 _e8 = tableTexel(3u, i_16);
    vec4 _e10 = tableTexel(4u, i_16);
    vec4 _e12 = tableTexel(5u, i_16);
    vec4 _e14 = tableTexel(6u, i_16);
    return Layers(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xy, _e8.z, _e8.w, _e10.x, _e10.y, _e10.z, _e10.w, _e12.x, _e12.y, _e12.z, _e12.w, _e14.x, _e14.y, _e14.z, _e14.w);
}

Layers layersOf(uint code_3, float eta) {
    Layers l = Layers(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    l.specularColor = vec3(1.0);
    l.specularWeight = 1.0;
    l.ior = 1.5;
    bool _e10 = isLayered(code_3);
    if (pick(_e10, (eta != 0.0), false)) {
        Layers _e16 = fetchLayers(uint(abs(eta)));
        l = _e16;
    }
    Layers _e17 = l;
    return _e17;
}

vec3 fromOctahedral(uint code_4) {
    vec2 p_26 = ((vec2(float((code_4 & 65535u)), float((code_4 >> 16u))) * 3.051851e-5) - vec2(1.0));
    float z_2 = ((1.0 - abs(p_26.x)) - abs(p_26.y));
    vec2 folded = ((vec2(1.0) - abs(p_26.yx)) * mix(vec2(1.0), vec2(-1.0), lessThan(p_26, vec2(0.0))));
    return normalize(vec3(pick((z_2 < 0.0), folded, p_26), z_2));
}

MeshPoint meshPoint(uint instance_3, uint place_1, vec2 weights_2) {
    MeshPoint p_11 = MeshPoint(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec4(0.0), vec4(0.0));
    uint _e5 = frame.instances;
    Instance _e9 = fetchInstance((_e5 + (instance_3 * instanceRows)));
    Triangle _e14 = fetchTriangle((_e9.triangles + (place_1 * triangleRows)));
    mat3x3 turn = mat3x3(_e9.toMeshX.xyz, _e9.toMeshY.xyz, _e9.toMeshZ.xyz);
    vec3 geometric_3 = normalize((turn * cross((_e14.b - _e14.a), (_e14.c - _e14.a))));
    p_11 = MeshPoint(geometric_3, geometric_3, vec3(0.0), vec3(0.0), geometric_3, vec4(0.0), vec4(1.0));
    if ((_e9.vertexRows != 0u)) {
        uvec3 rows_1 = (uvec3(_e9.vertices) + (uvec3(_e14.vertexA, _e14.vertexB, _e14.vertexC) * _e9.vertexRows));
        Vertex _e54 = fetchVertex(rows_1.x);
        Vertex _e56 = fetchVertex(rows_1.y);
        Vertex _e58 = fetchVertex(rows_1.z);
        vec3 share_2 = vec3(((1.0 - weights_2.x) - weights_2.y), weights_2);
        vec3 _e67 = fromOctahedral(_e54.normal);
        vec3 _e71 = fromOctahedral(_e56.normal);
        vec3 _e76 = fromOctahedral(_e58.normal);
        vec3 normal_16 = (((share_2.x * _e67) + (share_2.y * _e71)) + (share_2.z * _e76));
        vec3 smoothed = (turn * normal_16);
        float size_2 = dot(smoothed, smoothed);
        float side_4 = pick((dot(smoothed, geometric_3) < 0.0), -1.0, 1.0);
        bool useful = pick(((_e9.vertexFlags & hasNormals) != 0u), (size_2 > 0.0), false);
        p_11.shading = pick(useful, (smoothed * (side_4 * inversesqrt(max(size_2, 1e-37)))), geometric_3);
        const bool _e103 = hasTextures;
        if (_e103) {
            p_11.uv = vec4((((share_2.x * _e54.uv) + (share_2.y * _e56.uv)) + (share_2.z * _e58.uv)), 0.0, 0.0);
            const bool _e120 = hasVertexMore;
            if (_e120) {
                if ((_e9.vertexRows > vertexRows)) {
                    VertexMore _e127 = fetchVertexMore((rows_1.x + vertexRows));
                    VertexMore _e131 = fetchVertexMore((rows_1.y + vertexRows));
                    VertexMore _e135 = fetchVertexMore((rows_1.z + vertexRows));
                    vec4 _e138 = p_11.uv;
                    p_11.uv = vec4(_e138.xy, (((share_2.x * _e127.uv) + (share_2.y * _e131.uv)) + (share_2.z * _e135.uv)));
                    vec2 _e154 = pairOf(_e127.redGreen);
                    vec2 _e158 = pairOf(_e131.redGreen);
                    vec2 _e163 = pairOf(_e135.redGreen);
                    vec2 redGreen = (((share_2.x * _e154) + (share_2.y * _e158)) + (share_2.z * _e163));
                    vec2 _e168 = pairOf(_e127.blueAlpha);
                    vec2 _e172 = pairOf(_e131.blueAlpha);
                    vec2 _e177 = pairOf(_e135.blueAlpha);
                    vec2 blueAlpha = (((share_2.x * _e168) + (share_2.y * _e172)) + (share_2.z * _e177));
                    p_11.color = clamp(vec4(redGreen, blueAlpha), vec4(0.0), vec4(1.0));
                }
            }
            const bool _e188 = hasNormalMaps;
            if (_e188) {
                if (pick(useful, ((_e9.vertexFlags & hasTangents) != 0u), false)) {
                    vec3 _e197 = fromOctahedral(_e54.tangent);
                    vec3 _e201 = fromOctahedral(_e56.tangent);
                    vec3 _e206 = fromOctahedral(_e58.tangent);
                    vec3 tangent_2 = (((share_2.x * _e197) + (share_2.y * _e201)) + (share_2.z * _e206));
                    float hand = pick(((_e54.tangent & 65536u) != 0u), -1.0, 1.0);
                    p_11.normal = (smoothed * side_4);
                    p_11.tangent = ((turn * tangent_2) * side_4);
                    p_11.bitangent = ((turn * cross(normal_16, tangent_2)) * (hand * side_4));
                }
            }
        }
    }
    MeshPoint _e227 = p_11;
    return _e227;
}

bool isSmooth(uint code_5) {
    return ((code_5 & 32u) != 0u);
}

void takeUpLayer(uint slot, vec4 texel_1) {
    float _e4 = layersHere.specularWeight;
    layersHere.specularWeight = (_e4 * pick((slot == specularWeightSlot), texel_1.w, 1.0));
    vec3 _e13 = layersHere.specularColor;
    layersHere.specularColor = (_e13 * pick((slot == specularColorSlot), texel_1.xyz, vec3(1.0)));
    const bool _e22 = hasTransmission;
    if (_e22) {
        float _e25 = layersHere.transmission;
        layersHere.transmission = (_e25 * pick((slot == transmissionSlot), texel_1.x, 1.0));
        float _e34 = layersHere.beyond;
        layersHere.beyond = (_e34 * pick((slot == beyondSlot), texel_1.w, 1.0));
        vec3 _e43 = layersHere.beyondColor;
        layersHere.beyondColor = (_e43 * pick((slot == beyondColorSlot), texel_1.xyz, vec3(1.0)));
    }
    const bool _e52 = hasCoats;
    if (_e52) {
        float _e55 = layersHere.coat;
        layersHere.coat = (_e55 * pick((slot == coatSlot), texel_1.x, 1.0));
        float _e64 = layersHere.coatRoughness;
        layersHere.coatRoughness = (_e64 * pick((slot == coatRoughnessSlot), texel_1.y, 1.0));
    }
    const bool _e72 = hasSheen;
    if (_e72) {
        vec3 _e75 = layersHere.sheenColor;
        layersHere.sheenColor = (_e75 * pick((slot == sheenColorSlot), texel_1.xyz, vec3(1.0)));
        float _e85 = layersHere.sheenRoughness;
        layersHere.sheenRoughness = (_e85 * pick((slot == sheenRoughnessSlot), texel_1.w, 1.0));
    }
    const bool _e93 = hasIridescence;
    if (_e93) {
        float _e96 = layersHere.film;
        layersHere.film = (_e96 * pick((slot == filmSlot), texel_1.x, 1.0));
        float _e105 = layersHere.filmLeast;
        float _e108 = layersHere.filmThickness;
        float thickness_1 = mix(_e105, _e108, texel_1.y);
        float _e115 = layersHere.filmThickness;
        layersHere.filmThickness = pick((slot == filmThicknessSlot), thickness_1, _e115);
    }
    const bool _e120 = hasGrain;
    if (_e120) {
        bool isGrain = (slot == anisotropySlot);
        float _e125 = layersHere.anisotropy;
        layersHere.anisotropy = (_e125 * pick(isGrain, texel_1.z, 1.0));
        vec2 given_1 = ((2.0 * texel_1.xy) - vec2(1.0));
        float size_3 = dot(given_1, given_1);
        vec2 d_2 = pick((size_3 > 1e-6), (given_1 * inversesqrt(max(size_3, 1e-20))), vec2(1.0, 0.0));
        vec2 own_7 = layersHere.grain;
        layersHere.grain = pick(isGrain, vec2(((own_7.x * d_2.x) - (own_7.y * d_2.y)), ((own_7.y * d_2.x) + (own_7.x * d_2.y))), own_7);
        return;
    } else {
        return;
    }
}

Bumps takeUpTextures(inout Surface s_5, vec4 uv_1, vec3 color) {
    Bumps bumps = Bumps(vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, 1.0));
    uint i_17 = 0u;
    vec2 place_2 = vec2(0.0);
    float _e4 = s_5.textures;
    uint row_12 = uint(_e4);
    MaterialTextures _e6 = fetchMaterialTextures(row_12);
    bool unlit = ((_e6.flags & isUnlit) != 0u);
    vec3 _e13 = s_5.baseColor;
    s_5.baseColor = (_e13 * color);
    vec3 _e16 = s_5.emission;
    s_5.emission = (_e16 * pick(unlit, color, vec3(1.0)));
    if ((_e6.count > 0u)) {
        while(true) {
            uint _e38 = i_17;
            TextureUse _e42 = fetchTextureUse(((row_12 + materialTexturesRows) + (_e38 * textureUseRows)));
            place_2 = uv_1.xy;
            const bool _e46 = hasVertexMore;
            if (_e46) {
                place_2 = pick(((_e42.flags & usesSecondSet) != 0u), uv_1.zw, uv_1.xy);
            }
            vec2 _e55 = place_2;
            vec4 _e56 = lookUp(_e42, _e55);
            vec3 _e58 = s_5.baseColor;
            s_5.baseColor = (_e58 * pick((_e42.slot == baseColorSlot), _e56.xyz, vec3(1.0)));
            vec3 _e68 = s_5.emission;
            s_5.emission = (_e68 * pick((_e42.slot == emissionSlot), _e56.xyz, vec3(1.0)));
            vec2 share_3 = pick((_e42.slot == metallicRoughnessSlot), _e56.yz, vec2(1.0));
            float _e85 = s_5.alpha;
            float rough = max(((_e85 * share_3.x) * share_3.x), 0.001);
            float _e94 = s_5.alpha;
            float _e96 = s_5.code;
            bool _e98 = isSmooth(uint(_e96));
            s_5.alpha = pick(_e98, _e94, rough);
            float _e101 = s_5.metallic;
            s_5.metallic = (_e101 * share_3.y);
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
            uint _e135 = i_17;
            i_17 = (_e135 + 1u);
            uint _e137 = i_17;
            if ((_e137 >= _e6.count)) {
                break;
            }
        }
    }
    Bumps _e140 = bumps;
    return _e140;
}

vec3 bent(vec3 g_2, vec3 o_1, vec3 n) {
    float oz = max(dot(o_1, g_2), 0.0);
    float least = min((0.9 * oz), 0.01);
    vec3 across_3 = (n - (dot(n, g_2) * g_2));
    vec3 x_21 = (across_3 * inversesqrt(max(dot(across_3, across_3), 1e-20)));
    float ox = dot(o_1, x_21);
    float a_6 = max(((ox * ox) + (oz * oz)), 1e-20);
    float b_10 = (2.0 * (a_6 + (oz * least)));
    float c_5 = ((least + oz) * (least + oz));
    float root = sqrt(max(((b_10 * b_10) - ((4.0 * a_6) * c_5)), 0.0));
    float z2_ = clamp(((0.25 * pick((ox < 0.0), (b_10 + root), (b_10 - root))) / a_6), 0.0, 1.0);
    vec3 raised = ((sqrt((1.0 - z2_)) * x_21) + (sqrt(z2_) * g_2));
    vec3 reflected = (((2.0 * dot(n, o_1)) * n) - o_1);
    return pick((dot(g_2, reflected) >= least), n, raised);
}

vec3 validNormal(vec3 geometric, vec3 direction_8, vec3 mapped, vec3 otherwise) {
    float size_4 = dot(mapped, mapped);
    vec3 n_4 = pick((size_4 > 0.0), (mapped * inversesqrt(max(size_4, 1e-37))), otherwise);
    float side_5 = pick((dot(geometric, direction_8) > 0.0), -1.0, 1.0);
    vec3 _e21 = bent((side_5 * geometric), -(direction_8), (side_5 * n_4));
    return (side_5 * _e21);
}

bool isDielectric(uint code_6) {
    const bool _e2 = hasGlass;
    uint _e3 = kindOf(code_6);
    return pick(_e2, (_e3 == dielectric_1), false);
}

bool letsThrough(uint code_7, float eta_1) {
    bool _e2 = isDielectric(code_7);
    const bool _e4 = hasTransmission;
    bool _e5 = isLayered(code_7);
    return pick(_e2, true, pick(pick(_e4, _e5, false), (eta_1 < 0.0), false));
}

vec3 agreed(vec3 geometric_1, vec3 shading, vec3 direction_9, bool isClear) {
    bool agree = ((dot(geometric_1, direction_9) > 0.0) == (dot(shading, direction_9) > 0.0));
    return pick(pick(isClear, !(agree), false), geometric_1, shading);
}

vec3 tangentAbout(vec3 normal_2) {
    vec3 east = vec3(normal_2.z, 0.0, -(normal_2.x));
    float length2_ = dot(east, east);
    return pick((length2_ > 1e-12), (east * inversesqrt(max(length2_, 1e-20))), vec3(1.0, 0.0, 0.0));
}

vec3 grainAt(vec3 normal_3, vec3 tangent, vec3 bitangent, vec2 grain) {
    vec3 along_1 = (tangent - (dot(tangent, normal_3) * normal_3));
    float size_5 = dot(along_1, along_1);
    bool own_8 = (size_5 > (1e-12 * dot(tangent, tangent)));
    vec3 _e12 = tangentAbout(normal_3);
    vec3 t_16 = pick(own_8, (along_1 * inversesqrt(max(size_5, 1e-37))), _e12);
    vec3 across_4 = cross(normal_3, t_16);
    float hand_1 = pick(pick(own_8, (dot(across_4, bitangent) < 0.0), false), -1.0, 1.0);
    return ((grain.x * t_16) + ((grain.y * hand_1) * across_4));
}

SurfacePoint surfaceAt(RayPair rays_1, PairHit hit, uint shape) {
    Surface surface = Surface(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    Normals normals = Normals(vec3(0.0), vec3(0.0));
    vec3 tangent_1 = vec3(0.0);
    vec3 bitangent_1 = vec3(0.0);
    vec3 _e4 = normalAt(rays_1, hit.t, shape);
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
        if ((hit.triangle.instance != noInstance)) {
            MeshPoint _e39 = meshPoint(hit.triangle.instance, hit.triangle.triangle, hit.weights);
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

Basis basisAbout(vec3 n_1) {
    float side_6 = pick((n_1.z >= 0.0), 1.0, -1.0);
    float a_7 = (-1.0 / (side_6 + n_1.z));
    float b_11 = ((n_1.x * n_1.y) * a_7);
    return Basis(vec3((1.0 + (((side_6 * n_1.x) * n_1.x) * a_7)), (side_6 * b_11), (-(side_6) * n_1.x)), vec3(b_11, (side_6 + ((n_1.y * n_1.y) * a_7)), -(n_1.y)), n_1);
}

Basis basisAlong(vec3 n_2, vec3 x_12) {
    vec3 tangent_3 = normalize((x_12 - (dot(x_12, n_2) * n_2)));
    return Basis(tangent_3, cross(n_2, tangent_3), n_2);
}

vec3 toLocal(Basis b_3, vec3 v_5) {
    return vec3(dot(v_5, b_3.tangent), dot(v_5, b_3.bitangent), dot(v_5, b_3.normal));
}

bool isThin(uint code_8) {
    const bool _e2 = hasGlass;
    return pick(_e2, ((code_8 & 7u) == 7u), false);
}

vec3 schlick(vec3 f0_, float cosine) {
    float m_3 = max((1.0 - cosine), 0.0);
    float m2_ = (m_3 * m_3);
    return (f0_ + ((vec3(1.0) - f0_) * ((m2_ * m2_) * m_3)));
}

float coatReflectance(float coat, float cosine_1) {
    vec3 _e4 = schlick(vec3(0.04), cosine_1);
    return (coat * _e4.x);
}

vec3 coatNormal(float side) {
    vec3 _e2 = coatNormalHere;
    float _e7 = coatNormalHere.z;
    return vec3((side * _e2.xy), _e7);
}

float coatCosine(float side_1, vec3 w_2) {
    float z = 0.0;
    z = w_2.z;
    const bool _e5 = hasCoatNormals;
    if (_e5) {
        vec3 _e6 = coatNormal(side_1);
        z = dot(_e6, w_2);
    }
    float _e8 = z;
    return abs(_e8);
}

Meeting meetingAt(inout Path p_12, PairHit hit_1) {
    Surface surface_1 = Surface(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    Basis basis = Basis(vec3(0.0), vec3(0.0), vec3(0.0));
    RayPair rays_2 = p_12.rays;
    bool escaped = (hit_1.shape == noShape);
    uint shape_1 = pick(escaped, 0u, hit_1.shape);
    SurfacePoint _e10 = surfaceAt(rays_2, hit_1, shape_1);
    surface_1 = _e10.surface;
    float _e14 = surface_1.code;
    float _e18 = surface_1.eta.x;
    bool _e19 = letsThrough(uint(_e14), _e18);
    vec3 outward_1 = _e10.shading;
    vec3 normal_17 = pick(pick((dot(outward_1, rays_2.direction) > 0.0), !(_e19), false), -(outward_1), outward_1);
    Basis _e29 = basisAbout(normal_17);
    basis = _e29;
    const bool _e32 = hasGrain;
    if (_e32) {
        vec3 _e34 = grainHere;
        if (any(notEqual(_e34, vec3(0.0)))) {
            vec3 _e40 = grainHere;
            Basis _e41 = basisAlong(normal_17, _e40);
            basis = _e41;
        }
    }
    Basis _e42 = basis;
    vec3 _e45 = toLocal(_e42, -(rays_2.direction));
    const bool _e47 = hasGlass;
    const bool _e49 = hasTransmission;
    if (pick(_e47, true, _e49)) {
        float _e52 = surface_1.code;
        bool _e54 = isThin(uint(_e52));
        bool inside_2 = pick(pick(pick(_e19, !(_e54), false), (_e45.z < 0.0), false), !(escaped), false);
        vec3 _e64 = p_12.throughput;
        vec3 _e66 = surface_1.absorption;
        p_12.throughput = (_e64 * exp((-(_e66) * pick(inside_2, hit_1.t, 0.0))));
    }
    const bool _e75 = hasCoatNormals;
    if (_e75) {
        vec3 _e77 = coatNormalHere;
        bool away = pick((dot(_e77, rays_2.direction) > 0.0), !(_e19), false);
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
    return Meeting((rays_2.point + (hit_1.t * rays_2.direction)), shape_1, _e111, _e19, _e10.geometric, outward_1, _e113, _e45);
}

vec3 heroColor(vec3 throughput, float u_5) {
    vec3 share_4 = (throughput / vec3(max(dot(throughput, vec3(1.0)), 1e-30)));
    bool isRed = (u_5 < share_4.x);
    bool isBlue = pick(pick(!(isRed), (u_5 >= (share_4.x + share_4.y)), false), (share_4.z > 0.0), false);
    vec3 chosen_2 = pick(isRed, vec3(1.0, 0.0, 0.0), pick(isBlue, vec3(0.0, 0.0, 1.0), vec3(0.0, 1.0, 0.0)));
    return (chosen_2 / vec3(max(dot(chosen_2, share_4), 1e-6)));
}

float nextHash(inout Sampler s_6) {
    uint _e3 = s_6.key;
    s_6.key = (_e3 + 1u);
    uint _e7 = s_6.key;
    uint _e9 = s_6.salt;
    uint _e11 = mixBits((_e7 ^ _e9));
    uint _e13 = s_6.sample_;
    uint _e17 = s_6.place;
    uint _e20 = mixBits((_e11 + ((_e13 * 256u) | _e17)));
    float _e21 = unitFloat(_e20);
    return _e21;
}

bool isConductor(uint code_9) {
    const bool _e2 = hasConductors;
    uint _e3 = kindOf(code_9);
    return pick(_e2, (_e3 == conductor), false);
}

vec2 ellipticAlpha(float alpha, float strength) {
    return pick((strength > 0.0), vec2(mix(alpha, 1.0, (strength * strength)), max(alpha, 0.001)), vec2(alpha));
}

float dispersedIndex(float ior, float dispersion, vec3 hero) {
    float side_7 = (pick((hero.z > 0.0), 1.0, 0.0) - pick((hero.x > 0.0), 1.0, 0.0));
    return max((ior + (((side_7 * (ior - 1.0)) * 0.025) * dispersion)), 1.0);
}

float greatest(vec3 v_6) {
    return max(max(v_6.x, v_6.y), v_6.z);
}

float sheenAlbedo(float cosine_2, float roughness) {
    float u_29 = (((sqrt(sqrt(clamp(cosine_2, 0.0001, 1.0))) - 0.1) / 0.45) - 1.0);
    float v_12 = (((sqrt(max(roughness, 0.07)) - 0.264575) / 0.367712) - 1.0);
    vec3 low_2 = (vec3(0.746962, 0.0397496, 0.224802) + (u_29 * (vec3(-0.448339, 0.3406, -0.509736) + (u_29 * (vec3(-0.196284, 0.0161825, -0.50469) + (u_29 * (vec3(0.0587112, 0.187983, 0.191769) + (u_29 * (vec3(-0.182064, 0.425384, 0.971703) + (u_29 * (vec3(0.0763965, -0.331055, 0.616069) + (u_29 * (vec3(0.0893496, -0.409073, -0.445006) + (u_29 * vec3(-0.0525425, 0.0277158, -0.421496)))))))))))))));
    vec3 high_1 = (vec3(-0.0321953, -0.190573, 0.0715297) + (u_29 * (vec3(0.492365, -0.201291, -0.00570256) + (u_29 * (vec3(0.833264, 0.765625, -1.06831) + (u_29 * (vec3(-1.29238, 0.71056, 0.237437) + (u_29 * (vec3(-2.81818, -0.673857, 2.17806) + (u_29 * (vec3(0.500911, -0.777981, 0.0143213) + (u_29 * (vec3(1.97956, 0.108218, -1.28939) + (u_29 * vec3(0.324871, 0.21472, -0.194708)))))))))))))));
    float v2_ = (v_12 * v_12);
    float root_1 = dot((low_2 + ((v2_ * v_12) * high_1)), vec3(1.0, v_12, v2_));
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

float singleScatteringAlbedo(float cosine_3, float alpha_1) {
    float x_22 = (cosine_3 / (cosine_3 + alpha_1));
    vec4 byAlpha = (vec4(0.887807, 0.309386, -0.270728, 0.0252433) + (x_22 * (vec4(1.08526, -3.21434, -1.87718, 1.61195) + (x_22 * (vec4(-5.18071, 10.7648, 6.30913, -8.09265) + (x_22 * (vec4(7.80474, -12.743, -24.1046, 25.2536) + (x_22 * vec4(-3.60041, 4.60906, 23.1225, -22.9342)))))))));
    float a2_ = (alpha_1 * alpha_1);
    return min(dot(byAlpha, vec4(1.0, alpha_1, a2_, (a2_ * alpha_1))), 1.0);
}

float cosineInAir(float cosine_4, float ratio) {
    float sine2_ = ((1.0 - (cosine_4 * cosine_4)) / (ratio * ratio));
    return pick((ratio < 1.0), sqrt(max((1.0 - sine2_), 0.0)), cosine_4);
}

float outerCosine(float cosine_5) {
    float outer = 0.0;
    outer = cosine_5;
    const bool _e3 = hasTransmission;
    if (_e3) {
        float _e6 = stackHere.ratio;
        float _e7 = cosineInAir(cosine_5, _e6);
        outer = _e7;
    }
    float _e8 = outer;
    return _e8;
}

bool reflectsAll(float cosine_6, float ratio_1) {
    return pick((ratio_1 < 1.0), ((1.0 - (cosine_6 * cosine_6)) >= (ratio_1 * ratio_1)), false);
}

Reflectance bareReflectance(Surface s_7, float cosine_7) {
    vec3 dielectric = vec3(0.0);
    float _e2 = outerCosine(cosine_7);
    float _e5 = layersHere.specularWeight;
    vec3 _e6 = dielectricF0_();
    vec3 _e7 = schlick(_e6, _e2);
    dielectric = (_e5 * _e7);
    const bool _e11 = hasTransmission;
    if (_e11) {
        vec3 _e12 = dielectric;
        float _e17 = stackHere.ratio;
        bool _e18 = reflectsAll(cosine_7, _e17);
        dielectric = pick(_e18, vec3(1.0), _e12);
    }
    vec3 _e20 = dielectric;
    vec3 _e22 = schlick(s_7.baseColor, _e2);
    return Reflectance(_e20, _e22);
}

float mean3_(vec3 v_7) {
    return dot(v_7, vec3(0.33333334));
}

void meetLayers(Surface s_8, vec3 given, vec3 hero_1) {
    float side_8 = pick((given.z < 0.0), -1.0, 1.0);
    vec3 wo_8 = vec3(given.xy, (given.z * side_8));
    float metallic_3 = s_8.metallic;
    stackHere.wo = wo_8;
    stackHere.side = side_8;
    stackHere.hero = hero_1;
    stackHere.inside = false;
    stackHere.ratio = 1.0;
    float _e31 = layersHere.anisotropy;
    vec2 _e32 = ellipticAlpha(s_8.alpha, _e31);
    stackHere.alpha = _e32;
    const bool _e34 = hasTransmission;
    if (_e34) {
        float _e37 = layersHere.solid;
        bool isSolid = (_e37 > 0.0);
        bool inside_3 = pick(isSolid, (side_8 < 0.0), false);
        float _e45 = layersHere.ior;
        float _e48 = layersHere.dispersion;
        float _e49 = dispersedIndex(_e45, _e48, hero_1);
        float _e52 = layersHere.transmission;
        bool flat_ = pick(pick(isSolid, (_e52 > 0.0), false), ((_e49 - 1.0) < 0.001), false);
        stackHere.inside = inside_3;
        stackHere.ratio = pick(isSolid, pick(inside_3, (1.0 / _e49), _e49), 1.0);
        vec2 _e74 = stackHere.alpha;
        stackHere.alpha = pick(flat_, vec2(0.0), _e74);
    }
    stackHere.coat = 0.0;
    const bool _e82 = hasCoats;
    if (_e82) {
        float _e87 = layersHere.coat;
        float _e88 = coatCosine(side_8, wo_8);
        float _e89 = coatReflectance(_e87, _e88);
        bool _e92 = stackHere.inside;
        stackHere.coat = pick(_e92, 0.0, _e89);
        float _e99 = layersHere.coatRoughness;
        float _e102 = layersHere.coatRoughness;
        stackHere.coatAlpha = (_e99 * _e102);
    }
    stackHere.sheenColor = 0.0;
    stackHere.sheen = 0.0;
    const bool _e111 = hasSheen;
    if (_e111) {
        vec3 _e116 = layersHere.sheenColor;
        float _e117 = greatest(_e116);
        stackHere.sheenColor = _e117;
        float _e120 = stackHere.sheenColor;
        if ((_e120 > 0.0)) {
            float _e128 = layersHere.sheenRoughness;
            float _e129 = sheenAlbedo(wo_8.z, _e128);
            bool _e132 = stackHere.inside;
            stackHere.sheen = pick(_e132, 0.0, _e129);
        }
    }
    float _e137 = layersHere.specularWeight;
    vec3 _e138 = dielectricF0_();
    vec3 f0_3 = (_e137 * _e138);
    stackHere.more = vec3(1.0);
    const bool _e145 = hasCompensation;
    if (_e145) {
        float _e150 = stackHere.alpha.x;
        float _e154 = stackHere.alpha.y;
        float _e157 = singleScatteringAlbedo(wo_8.z, sqrt((_e150 * _e154)));
        float _e166 = layersHere.transmission;
        bool asked = pick(((uint(s_8.code) & 8u) != 0u), (_e166 <= 0.0), false);
        stackHere.more = pick(asked, (vec3(1.0) + (mix(f0_3, s_8.baseColor, metallic_3) * ((1.0 - _e157) / _e157))), vec3(1.0));
    }
    Reflectance _e185 = bareReflectance(s_8, wo_8.z);
    vec3 met_1 = mix(_e185.dielectric, _e185.metal, metallic_3);
    float _e192 = greatest(_e185.dielectric);
    float enters = ((1.0 - metallic_3) * (1.0 - _e192));
    float _e197 = mean3_(s_8.baseColor);
    float coat_1 = stackHere.coat;
    float _e205 = stackHere.sheenColor;
    float _e208 = stackHere.sheen;
    float below_1 = ((1.0 - coat_1) * (1.0 - (_e205 * min(_e208, 1.0))));
    float _e215 = mean3_(met_1);
    float _e218 = layersHere.film;
    float _e224 = layersHere.transmission;
    float facets = (below_1 * ((_e215 + (0.25 * _e218)) + ((enters * _e224) * _e197)));
    float _e233 = stackHere.sheen;
    vec3 _e237 = layersHere.sheenColor;
    float _e238 = mean3_(_e237);
    float fibres = (((1.0 - coat_1) * _e233) * _e238);
    float _e243 = greatest(f0_3);
    float _e249 = layersHere.transmission;
    float body = (((below_1 * (1.0 - metallic_3)) * (1.0 - _e243)) * (1.0 - _e249));
    float _e255 = layersHere.beyond;
    float diffuse = ((body * (1.0 - _e255)) * _e197);
    float _e262 = layersHere.beyond;
    vec3 _e266 = layersHere.beyondColor;
    float _e267 = mean3_(_e266);
    float beyond = ((body * _e262) * _e267);
    float all_ = max(((((coat_1 + facets) + fibres) + diffuse) + beyond), 1e-20);
    stackHere.ofCoat = (coat_1 / all_);
    stackHere.ofFacets = (facets / all_);
    stackHere.ofSheen = (fibres / all_);
    stackHere.ofDiffuse = (diffuse / all_);
    return;
}

vec3 metallicRoughnessF0_(vec3 baseColor, float metallic) {
    return mix(vec3(0.04), baseColor, metallic);
}

vec3 metallicRoughnessDiffuse(vec3 baseColor_1, float metallic_1, float cosine_8) {
    vec3 _e7 = schlick(vec3(0.04), cosine_8);
    return (((1.0 - metallic_1) * (1.0 - _e7.x)) * baseColor_1);
}

float specularShare(vec3 baseColor_2, float metallic_2, float cosine_9) {
    vec3 _e3 = metallicRoughnessF0_(baseColor_2, metallic_2);
    vec3 _e4 = schlick(_e3, cosine_9);
    float specular = dot(_e4, vec3(1.0));
    vec3 _e9 = metallicRoughnessDiffuse(baseColor_2, metallic_2, 1.0);
    float diffuse_1 = dot(_e9, vec3(1.0));
    return (specular / max((specular + diffuse_1), 1e-20));
}

float indexRatio(float eta_2, float z_1, bool thin) {
    return pick(pick((z_1 < 0.0), !(thin), false), (1.0 / eta_2), eta_2);
}

float reflectionBound(vec3 wo, float alpha_2) {
    float s_27 = (1.0 + length(wo.xy));
    float s2_ = (s_27 * s_27);
    float a2_1 = (alpha_2 * alpha_2);
    return (((1.0 - a2_1) * s2_) / (s2_ + ((a2_1 * wo.z) * wo.z)));
}

float stretched(vec3 w_3, float alpha_3) {
    return sqrt(((w_3.z * w_3.z) + ((alpha_3 * alpha_3) * dot(w_3.xy, w_3.xy))));
}

Outgoing outgoing(Surface s_9, vec3 wo_1, vec3 hero_2) {
    Outgoing o_2 = Outgoing(vec3(0.0), 0.0, 0.0, 0.0, 0.0);
    uint code_12 = uint(s_9.code);
    bool _e5 = isConductor(code_12);
    bool _e6 = isDielectric(code_12);
    o_2 = Outgoing(wo_1, pick(pick(_e5, true, _e6), 1.0, 0.0), 1.0, 1.0, 1.0);
    const bool _e17 = hasLayers;
    if (_e17) {
        bool _e18 = isLayered(code_12);
        if (_e18) {
            meetLayers(s_9, wo_1, hero_2);
        }
    }
    const bool _e20 = hasMetallicRoughness;
    if (_e20) {
        const bool _e22 = hasLayers;
        if (!(_e22)) {
            float _e26 = o_2.share;
            float _e30 = specularShare(s_9.baseColor, s_9.metallic, wo_1.z);
            bool _e31 = isMetallicRoughness(code_12);
            o_2.share = pick(_e31, _e30, _e26);
        }
    }
    const bool _e34 = hasGlass;
    if (_e34) {
        bool _e39 = isThin(code_12);
        float _e40 = indexRatio(s_9.eta.x, wo_1.z, _e39);
        bool _e41 = isDielectric(code_12);
        o_2.ratio = pick(_e41, _e40, 1.0);
    }
    const bool _e45 = hasConductors;
    const bool _e47 = hasMetallicRoughness;
    const bool _e49 = hasLayers;
    const bool _e54 = hasGlass;
    if (pick(pick(_e45, true, pick(_e47, !(_e49), false)), true, _e54)) {
        float _e58 = reflectionBound(wo_1, s_9.alpha);
        bool _e59 = isDielectric(code_12);
        o_2.bound = pick(_e59, 1.0, _e58);
        float _e64 = stretched(wo_1, s_9.alpha);
        o_2.stretched = _e64;
    }
    Outgoing _e65 = o_2;
    return _e65;
}

float mirrorShare(float reflectivity) {
    const bool _e2 = hasMirrorLayers;
    return pick(_e2, reflectivity, 0.0);
}

vec3 sampleCosine(vec2 u_6) {
    float radius_2 = sqrt(u_6.x);
    float phi = ((6.2831855 * u_6.y) - 3.1415927);
    return normalize(vec3((radius_2 * cos(phi)), (radius_2 * sin(phi)), sqrt((1.0 - u_6.x))));
}

vec3 sampleVisibleNormal(vec3 wo_2, float alpha_4, float bound, vec2 u_7) {
    float _e8 = stretched(wo_2, alpha_4);
    vec3 w_6 = (vec3((alpha_4 * wo_2.xy), wo_2.z) / vec3(_e8));
    float phi_1 = ((6.2831855 * u_7.x) - 3.1415927);
    float drop = (u_7.y * (1.0 + (bound * w_6.z)));
    float sine_1 = sqrt(max((drop * (2.0 - drop)), 0.0));
    vec3 h_6 = (w_6 + vec3((sine_1 * cos(phi_1)), (sine_1 * sin(phi_1)), (1.0 - drop)));
    return normalize(vec3((alpha_4 * h_6.xy), max(h_6.z, 1e-7)));
}

vec3 sampleFacet(float alpha_5, bool isMirror, Outgoing o_3, vec2 u_8) {
    float side_9 = pick((o_3.wo.z < 0.0), -1.0, 1.0);
    vec3 _e16 = sampleVisibleNormal((o_3.wo * side_9), max(alpha_5, 0.001), o_3.bound, u_8);
    return (pick(isMirror, vec3(0.0, 0.0, 1.0), _e16) * side_9);
}

vec3 conductorFresnel(float cosine_10, vec3 eta_3, vec3 k) {
    float cosine2_ = (cosine_10 * cosine_10);
    float sine2_1 = (1.0 - cosine2_);
    vec3 difference_1 = (((eta_3 * eta_3) - (k * k)) - vec3(sine2_1));
    vec3 a2PlusB2_ = sqrt(((difference_1 * difference_1) + ((((4.0 * eta_3) * eta_3) * k) * k)));
    vec3 larger = sqrt(((0.5 * (a2PlusB2_ + abs(difference_1))) + vec3(1e-20)));
    vec3 smaller = ((eta_3 * k) / larger);
    vec3 a_8 = mix(smaller, larger, greaterThan(difference_1, vec3(0.0)));
    vec3 b_12 = mix(larger, smaller, greaterThan(difference_1, vec3(0.0)));
    vec3 b2_ = ((b_12 * b_12) + vec3(1e-20));
    vec3 acrossFar = (a_8 + vec3(cosine_10));
    vec3 acrossNear = (a_8 - vec3(cosine_10));
    vec3 across_5 = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a_8 * cosine_10) + vec3(sine2_1));
    vec3 alongNear = ((a_8 * cosine_10) - vec3(sine2_1));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across_5) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor_3, vec3 eta_4, vec3 k_1, float cosine_11) {
    float constants = dot((eta_4 + k_1), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_11, eta_4, k_1);
    return pick((constants > 0.0), _e8, baseColor_3);
}

float dielectricFresnel(float cosine_12, float ratio_2) {
    float inside2_ = (((ratio_2 - 1.0) * (ratio_2 + 1.0)) + (cosine_12 * cosine_12));
    float inside_4 = sqrt(max(inside2_, 0.0));
    float across_6 = ((cosine_12 - inside_4) / (cosine_12 + inside_4));
    float along_2 = ((((ratio_2 * ratio_2) * cosine_12) - inside_4) / (((ratio_2 * ratio_2) * cosine_12) + inside_4));
    return pick((inside2_ > 0.0), (0.5 * ((across_6 * across_6) + (along_2 * along_2))), 1.0);
}

float glassReflectance(float cosine_13, float ratio_3, bool thin_1) {
    float _e3 = dielectricFresnel(cosine_13, ratio_3);
    return pick(thin_1, ((2.0 * _e3) / (1.0 + _e3)), _e3);
}

vec3 facetReflectance(Surface s_10, float cosine_14, float ratio_4) {
    vec3 reflectance = vec3(0.0);
    uint code_13 = uint(s_10.code);
    const bool _e9 = hasMetallicRoughness;
    if (_e9) {
        const bool _e11 = hasLayers;
        if (!(_e11)) {
            vec3 _e15 = metallicRoughnessF0_(s_10.baseColor, s_10.metallic);
            vec3 _e16 = schlick(_e15, cosine_14);
            reflectance = _e16;
        }
    }
    const bool _e18 = hasConductors;
    if (_e18) {
        vec3 _e19 = reflectance;
        vec3 _e23 = conductorReflectance(s_10.baseColor, s_10.eta, s_10.k, cosine_14);
        bool _e24 = isConductor(code_13);
        reflectance = pick(_e24, _e23, _e19);
    }
    const bool _e27 = hasGlass;
    if (_e27) {
        vec3 _e28 = reflectance;
        bool _e29 = isThin(code_13);
        float _e30 = glassReflectance(cosine_14, ratio_4, _e29);
        bool _e32 = isDielectric(code_13);
        reflectance = pick(_e32, vec3(_e30), _e28);
    }
    vec3 _e34 = reflectance;
    return _e34;
}

vec3 refracted(vec3 wo_3, vec3 h_1, float ratio_5) {
    float cosine_20 = dot(wo_3, h_1);
    float inside_5 = sqrt(max((((ratio_5 - 1.0) * (ratio_5 + 1.0)) + (cosine_20 * cosine_20)), 0.0));
    return ((((cosine_20 - inside_5) * h_1) - wo_3) / vec3(ratio_5));
}

bool isSolidHere() {
    const bool _e1 = hasTransmission;
    float _e4 = layersHere.solid;
    return pick(_e1, (_e4 > 0.0), false);
}

float ellipticBound(vec3 wo_4, vec2 alpha_6) {
    float s_28 = (1.0 + length(wo_4.xy));
    float s2_1 = (s_28 * s_28);
    float least_1 = min(alpha_6.x, alpha_6.y);
    float a2_2 = (least_1 * least_1);
    return (((1.0 - a2_2) * s2_1) / (s2_1 + ((a2_2 * wo_4.z) * wo_4.z)));
}

float ellipticStretched(vec3 w_4, vec2 alpha_7) {
    vec2 scaled = (alpha_7 * w_4.xy);
    return sqrt(((w_4.z * w_4.z) + dot(scaled, scaled)));
}

vec3 sampleEllipticNormal(vec3 wo_5, vec2 alpha_8, float bound_1, vec2 u_9) {
    float _e8 = ellipticStretched(wo_5, alpha_8);
    vec3 w_7 = (vec3((alpha_8 * wo_5.xy), wo_5.z) / vec3(_e8));
    float phi_2 = ((6.2831855 * u_9.x) - 3.1415927);
    float drop_1 = (u_9.y * (1.0 + (bound_1 * w_7.z)));
    float sine_2 = sqrt(max((drop_1 * (2.0 - drop_1)), 0.0));
    vec3 h_7 = (w_7 + vec3((sine_2 * cos(phi_2)), (sine_2 * sin(phi_2)), (1.0 - drop_1)));
    return normalize(vec3((alpha_8 * h_7.xy), max(h_7.z, 1e-7)));
}

vec3 toWorld(Basis b_4, vec3 v_8) {
    return (((v_8.x * b_4.tangent) + (v_8.y * b_4.bitangent)) + (v_8.z * b_4.normal));
}

Parting partingOf(Surface s_11, Reflectance r_1) {
    Parting parting = Parting(vec3(0.0), vec3(0.0));
    vec3 toward = mix(r_1.dielectric, r_1.metal, s_11.metallic);
    parting = Parting(toward, vec3(0.0));
    const bool _e11 = hasTransmission;
    if (_e11) {
        float _e16 = greatest(r_1.dielectric);
        float enters_1 = ((1.0 - s_11.metallic) * (1.0 - _e16));
        vec3 _e24 = stackHere.hero;
        bool _e27 = stackHere.inside;
        float _e32 = layersHere.transmission;
        vec3 _e38 = stackHere.hero;
        parting = Parting((toward * pick(_e27, _e24, vec3(1.0))), (((enters_1 * _e32) * s_11.baseColor) * _e38));
    }
    Parting _e41 = parting;
    return _e41;
}

float shareToward(Surface s_12, Reflectance bare) {
    Parting _e2 = partingOf(s_12, bare);
    float _e4 = mean3_(_e2.toward);
    float _e6 = mean3_(_e2.beyond);
    float _e13 = layersHere.film;
    return pick((_e6 > 0.0), mix((_e4 / max((_e4 + _e6), 1e-20)), 0.5, (0.5 * _e13)), 1.0);
}

LayeredSample sampleLayered(Surface s_13, vec3 u_10) {
    Basis own_1 = Basis(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0));
    vec3 ownWo = vec3(0.0);
    vec3 h_2 = vec3(0.0);
    vec3 met = vec3(0.0);
    bool crossing = false;
    bool lost = false;
    LayeredSample drawn = LayeredSample(vec3(0.0), 0.0, false);
    vec3 wo_9 = stackHere.wo;
    bool _e5 = isSolidHere();
    const bool _e7 = hasCoats;
    float _e11 = stackHere.ofCoat;
    bool isCoat_1 = pick(_e7, (u_10.z < _e11), false);
    float _e17 = stackHere.ofCoat;
    float _e20 = stackHere.ofFacets;
    bool isFacet = (u_10.z < (_e17 + _e20));
    stackHere.drawnByCoat = isCoat_1;
    vec2 _e27 = stackHere.alpha;
    float _e30 = stackHere.coatAlpha;
    vec2 alpha_14 = pick(isCoat_1, vec2(_e30), _e27);
    bool isSmooth_1 = (max(alpha_14.x, alpha_14.y) < 0.001);
    vec2 wide_1 = max(alpha_14, vec2(0.001));
    const bool _e56 = hasCoatNormals;
    if (_e56) {
        if (isCoat_1) {
            float _e59 = stackHere.side;
            vec3 _e60 = coatNormal(_e59);
            Basis _e61 = basisAbout(_e60);
            own_1 = _e61;
        }
    }
    ownWo = wo_9;
    const bool _e64 = hasCoatNormals;
    if (_e64) {
        Basis _e65 = own_1;
        vec3 _e66 = toLocal(_e65, wo_9);
        ownWo = _e66;
    }
    vec3 _e67 = ownWo;
    float _e68 = ellipticBound(_e67, wide_1);
    float bound_2 = pick(pick(_e5, !(isCoat_1), false), 1.0, _e68);
    vec3 _e73 = ownWo;
    vec3 _e75 = sampleEllipticNormal(_e73, wide_1, bound_2, u_10.xy);
    h_2 = pick(isSmooth_1, vec3(0.0, 0.0, 1.0), _e75);
    const bool _e83 = hasCoatNormals;
    if (_e83) {
        Basis _e84 = own_1;
        vec3 _e85 = h_2;
        vec3 _e86 = toWorld(_e84, _e85);
        h_2 = _e86;
    }
    vec3 _e87 = h_2;
    float oh = max(dot(wo_9, _e87), 0.0);
    vec3 _e93 = h_2;
    vec3 reflected_1 = (((2.0 * oh) * _e93) - wo_9);
    met = reflected_1;
    const bool _e100 = hasTransmission;
    if (_e100) {
        float _e104 = stackHere.ofCoat;
        float _e108 = stackHere.ofFacets;
        float left_1 = ((u_10.z - _e104) / max(_e108, 1e-20));
        Reflectance _e113 = bareReflectance(s_13, oh);
        float _e114 = shareToward(s_13, _e113);
        crossing = pick(!(isCoat_1), (left_1 >= _e114), false);
        vec3 _e121 = h_2;
        float _e124 = stackHere.ratio;
        vec3 _e125 = refracted(wo_9, _e121, _e124);
        vec3 beyond_1 = pick(_e5, _e125, vec3(reflected_1.xy, -(reflected_1.z)));
        bool _e127 = crossing;
        met = pick(_e127, beyond_1, reflected_1);
    }
    bool _e130 = crossing;
    float _e132 = met.z;
    lost = pick(!(isSmooth_1), (_e130 != (_e132 < 0.0)), false);
    const bool _e139 = hasCoatNormals;
    if (_e139) {
        if (isCoat_1) {
            vec3 _e141 = own_1.normal;
            vec3 _e142 = met;
            float _e147 = met.z;
            lost = pick((dot(_e141, _e142) <= 0.0), true, pick((_e147 < 0.0), (s_13.eta.x < 0.0), false));
        }
    }
    vec3 _e156 = met;
    bool _e157 = lost;
    drawn = LayeredSample(_e156, pick(_e157, 0.0, 1.0), isSmooth_1);
    if (!(isFacet)) {
        float _e167 = stackHere.ofCoat;
        float _e171 = stackHere.ofFacets;
        float next = ((u_10.z - _e167) - _e171);
        float sine_3 = sqrt(max((u_10.x * (2.0 - u_10.x)), 0.0));
        float phi_3 = ((6.2831855 * u_10.y) - 3.1415927);
        vec3 even = vec3((sine_3 * cos(phi_3)), (sine_3 * sin(phi_3)), (1.0 - u_10.x));
        vec3 _e195 = sampleCosine(u_10.xy);
        const bool _e201 = hasTransmission;
        float _e204 = stackHere.ofSheen;
        float _e207 = stackHere.ofDiffuse;
        vec3 below_2 = vec3(_e195.xy, pick(pick(_e201, (next >= (_e204 + _e207)), false), -(_e195.z), _e195.z));
        const bool _e214 = hasSheen;
        float _e217 = stackHere.ofSheen;
        drawn = LayeredSample(pick(pick(_e214, (next < _e217), false), even, below_2), 1.0, false);
    }
    float _e226 = drawn.direction.z;
    float _e229 = stackHere.side;
    drawn.direction.z = (_e226 * _e229);
    LayeredSample _e231 = drawn;
    return _e231;
}

vec3 mirrored(vec3 wo_6) {
    return vec3(-(wo_6.xy), wo_6.z);
}

BsdfSample sampleLobe(Surface s_14, Outgoing o_4, vec3 u_11) {
    BsdfSample drawn_1 = BsdfSample(vec3(0.0), 0.0, vec3(0.0), false);
    vec3 wi = vec3(0.0);
    float probability = 0.0;
    vec3 weight = vec3(0.0);
    vec3 wo_10 = o_4.wo;
    float _e5 = mirrorShare(s_14.reflectivity);
    float base_1 = (1.0 - _e5);
    float choice_2 = ((u_11.z - _e5) / base_1);
    vec3 _e12 = sampleCosine(u_11.xy);
    drawn_1 = BsdfSample(_e12, 1.0, vec3(1.0), false);
    const bool _e20 = hasConductors;
    const bool _e22 = hasMetallicRoughness;
    const bool _e24 = hasLayers;
    const bool _e29 = hasGlass;
    if (pick(pick(_e20, true, pick(_e22, !(_e24), false)), true, _e29)) {
        uint code_14 = uint(s_14.code);
        bool _e33 = isDielectric(code_14);
        bool _e34 = isSmooth(code_14);
        vec3 _e37 = sampleFacet(s_14.alpha, _e34, o_4, u_11.xy);
        float oh_1 = max(dot(wo_10, _e37), 0.0);
        vec3 _e42 = facetReflectance(s_14, oh_1, o_4.ratio);
        bool crossing_2 = pick(_e33, (choice_2 >= _e42.x), false);
        wi = (((2.0 * oh_1) * _e37) - wo_10);
        probability = (base_1 * o_4.share);
        weight = (_e42 / vec3(o_4.share));
        const bool _e59 = hasGlass;
        if (_e59) {
            bool _e60 = isThin(code_14);
            vec3 _e61 = wi;
            vec3 _e63 = refracted(wo_10, _e37, o_4.ratio);
            wi = pick(crossing_2, pick(_e60, -(wo_10), _e63), _e61);
            float _e67 = probability;
            probability = pick(_e33, (base_1 * pick(crossing_2, (1.0 - _e42.x), _e42.x)), _e67);
            vec3 _e75 = weight;
            weight = pick(_e33, vec3(pick(pick(crossing_2, !(_e60), false), (1.0 / (o_4.ratio * o_4.ratio)), 1.0)), _e75);
        }
        float _e92 = wi.z;
        bool lost_1 = pick(!(_e34), (crossing_2 != ((wo_10.z < 0.0) != (_e92 < 0.0))), false);
        bool specular_1 = (choice_2 < o_4.share);
        vec3 _e102 = drawn_1.direction;
        vec3 _e103 = wi;
        drawn_1.direction = pick(specular_1, _e103, _e102);
        float _e107 = drawn_1.pdf;
        float _e108 = probability;
        drawn_1.pdf = pick(specular_1, pick(lost_1, 0.0, _e108), _e107);
        vec3 _e114 = drawn_1.weight;
        vec3 _e115 = weight;
        drawn_1.weight = pick(specular_1, _e115, _e114);
        drawn_1.delta = pick(specular_1, _e34, false);
    }
    const bool _e120 = hasLayers;
    if (_e120) {
        bool _e123 = isLayered(uint(s_14.code));
        if (_e123) {
            LayeredSample _e126 = sampleLayered(s_14, vec3(u_11.xy, choice_2));
            drawn_1 = BsdfSample(_e126.direction, (base_1 * _e126.pdf), vec3(0.0), _e126.delta);
        }
    }
    const bool _e135 = hasMirrorLayers;
    if (_e135) {
        bool reflected_2 = (u_11.z < _e5);
        vec3 _e140 = drawn_1.direction;
        vec3 _e141 = mirrored(wo_10);
        drawn_1.direction = pick(reflected_2, _e141, _e140);
        float _e145 = drawn_1.pdf;
        drawn_1.pdf = pick(reflected_2, _e5, _e145);
        vec3 _e149 = drawn_1.weight;
        drawn_1.weight = pick(reflected_2, vec3(1.0), _e149);
        bool _e155 = drawn_1.delta;
        drawn_1.delta = pick(_e155, true, reflected_2);
    }
    BsdfSample _e157 = drawn_1;
    return _e157;
}

float facetDensity(vec3 h_3, float alpha_9) {
    float slope = max(((dot(h_3.xy, h_3.xy) / (alpha_9 * alpha_9)) + (h_3.z * h_3.z)), 1.0);
    return (0.31830987 / (((alpha_9 * alpha_9) * slope) * slope));
}

bool hidesApart(uint code_10) {
    return ((code_10 & 64u) != 0u);
}

vec3 compensation(Surface s_15, float cosine_15) {
    uint code_15 = uint(s_15.code);
    bool _e8 = isDielectric(code_15);
    bool asked_1 = pick(((code_15 & 8u) != 0u), !(_e8), false);
    float _e12 = singleScatteringAlbedo(cosine_15, s_15.alpha);
    vec3 _e17 = facetReflectance(s_15, 1.0, 1.0);
    return pick(asked_1, (vec3(1.0) + (_e17 * ((1.0 - _e12) / _e12))), vec3(1.0));
}

FacetLobe evaluateFacets(Surface s_16, Outgoing o_5, vec3 wi_1) {
    vec3 passes = vec3(0.0);
    vec3 wo_11 = o_5.wo;
    bool _e6 = isDielectric(uint(s_16.code));
    const bool _e8 = hasGlass;
    bool crossing_3 = pick(_e8, ((wo_11.z < 0.0) != (wi_1.z < 0.0)), false);
    vec3 m_4 = (wo_11 + (wi_1 * pick(crossing_3, o_5.ratio, 1.0)));
    float m2_1 = max(dot(m_4, m_4), 1e-20);
    vec3 h_8 = (m_4 * inversesqrt(m2_1));
    float oh_2 = dot(wo_11, h_8);
    float ih = dot(wi_1, h_8);
    float zo = abs(wo_11.z);
    float zi = abs(wi_1.z);
    bool faces = pick(!(crossing_3), true, pick((((oh_2 * h_8.z) * wo_11.z) >= 0.0), (((ih * h_8.z) * wi_1.z) >= 0.0), false));
    float _e54 = facetDensity(h_8, s_16.alpha);
    float spread = (pick(crossing_3, (abs((oh_2 * ih)) / m2_1), 0.25) * pick(faces, (2.0 * _e54), 0.0));
    vec3 _e62 = facetReflectance(s_16, abs(oh_2), o_5.ratio);
    passes = pick(crossing_3, (vec3(1.0) - _e62), _e62);
    float _e69 = stretched(wi_1, s_16.alpha);
    float apart = ((0.5 * (zo + o_5.stretched)) * (zi + _e69));
    bool _e82 = hidesApart(uint(s_16.code));
    float masked = (zi / max(pick(_e82, apart, ((zi * o_5.stretched) + (zo * _e69))), 1e-20));
    float _e88 = passes.x;
    float chosen_3 = (pick(_e6, _e88, 1.0) * pick(crossing_3, (o_5.ratio * o_5.ratio), 1.0));
    const bool _e98 = hasCompensation;
    if (_e98) {
        vec3 _e99 = passes;
        vec3 _e100 = compensation(s_16, zo);
        passes = (_e99 * _e100);
    }
    vec3 _e102 = passes;
    return FacetLobe(((_e102 * spread) * masked), ((spread * chosen_3) / ((o_5.bound * zo) + o_5.stretched)), abs(oh_2));
}

vec4 evaluateBsdf(Surface s_17, Outgoing o_6, vec3 wi_2) {
    vec4 value = vec4(0.0);
    bool dark = false;
    vec3 base = vec3(0.0);
    float lambert = (0.31830987 * max(wi_2.z, 0.0));
    value = (vec4(s_17.baseColor, 1.0) * lambert);
    dark = pick((o_6.wo.z < 0.0), true, (wi_2.z <= 0.0));
    const bool _e23 = hasConductors;
    const bool _e25 = hasMetallicRoughness;
    const bool _e27 = hasLayers;
    const bool _e32 = hasGlass;
    if (pick(pick(_e23, true, pick(_e25, !(_e27), false)), true, _e32)) {
        uint code_16 = uint(s_17.code);
        FacetLobe _e36 = evaluateFacets(s_17, o_6, wi_2);
        const bool _e41 = hasMetallicRoughness;
        if (_e41) {
            const bool _e43 = hasLayers;
            if (!(_e43)) {
                vec3 _e45 = base;
                vec3 _e49 = metallicRoughnessDiffuse(s_17.baseColor, s_17.metallic, _e36.cosine);
                bool _e50 = isMetallicRoughness(code_16);
                base = pick(_e50, _e49, _e45);
            }
        }
        bool _e59 = isSmooth(code_16);
        vec4 rough_1 = pick(_e59, vec4(0.0), vec4(_e36.value, (o_6.share * _e36.pdf)));
        vec3 _e61 = base;
        vec4 _e68 = value;
        uint _e69 = kindOf(code_16);
        value = pick((_e69 == diffuse0_), _e68, (rough_1 + (vec4(_e61, (1.0 - o_6.share)) * lambert)));
        bool _e73 = dark;
        bool _e74 = isSmooth(code_16);
        bool _e75 = isDielectric(code_16);
        dark = pick(_e75, _e74, _e73);
    }
    float _e78 = mirrorShare(s_17.reflectivity);
    vec4 _e81 = value;
    bool _e85 = dark;
    return pick(_e85, vec4(0.0), ((1.0 - _e78) * _e81));
}

BsdfSample completed(BsdfSample drawn_2, vec4 value_1) {
    float pdf_1 = pick((drawn_2.pdf <= 0.0), 0.0, value_1.w);
    vec3 weight_1 = pick((pdf_1 > 0.0), (value_1.xyz / vec3(max(pdf_1, 1e-30))), vec3(0.0));
    return BsdfSample(drawn_2.direction, pick(drawn_2.delta, drawn_2.pdf, pdf_1), pick(drawn_2.delta, drawn_2.weight, weight_1), drawn_2.delta);
}

float ellipticDensity(vec3 h_4, vec2 alpha_10) {
    vec2 scaled_1 = (h_4.xy / alpha_10);
    float slope_1 = max((dot(scaled_1, scaled_1) + (h_4.z * h_4.z)), 1.0);
    return (0.31830987 / (((alpha_10.x * alpha_10.y) * slope_1) * slope_1));
}

Facets facetsTowards(vec3 wi_3, bool isCoat, bool bends) {
    vec3 ownWo_1 = vec3(0.0);
    vec3 ownWi = vec3(0.0);
    vec3 ownH = vec3(0.0);
    vec3 wo_12 = stackHere.wo;
    vec2 _e8 = stackHere.alpha;
    float _e11 = stackHere.coatAlpha;
    vec2 alpha_15 = pick(isCoat, vec2(_e11), _e8);
    bool isRough = (max(alpha_15.x, alpha_15.y) >= 0.001);
    vec2 wide_2 = max(alpha_15, vec2(0.001));
    float _e24 = stackHere.ratio;
    vec3 m_5 = (wo_12 + (wi_3 * pick(bends, _e24, 1.0)));
    float m2_2 = max(dot(m_5, m_5), 1e-20);
    vec3 h_9 = (m_5 * inversesqrt(m2_2));
    float oh_3 = dot(wo_12, h_9);
    float ih_1 = dot(wi_3, h_9);
    ownWo_1 = wo_12;
    ownWi = wi_3;
    ownH = h_9;
    const bool _e40 = hasCoatNormals;
    if (_e40) {
        if (isCoat) {
            float _e43 = stackHere.side;
            vec3 _e44 = coatNormal(_e43);
            Basis _e45 = basisAbout(_e44);
            vec3 _e46 = toLocal(_e45, wo_12);
            ownWo_1 = _e46;
            vec3 _e47 = toLocal(_e45, wi_3);
            ownWi = _e47;
            vec3 _e48 = toLocal(_e45, h_9);
            ownH = _e48;
        }
    }
    float _e50 = ownH.z;
    float _e55 = ownH.z;
    float _e58 = ownWi.z;
    float _e64 = ownWi.z;
    bool faces_1 = pick(pick(((oh_3 * _e50) >= 0.0), (((ih_1 * _e55) * _e58) >= 0.0), false), pick(bends, true, (_e64 >= 0.0)), false);
    vec3 _e74 = ownH;
    float _e75 = ellipticDensity(_e74, wide_2);
    float spread_1 = (pick(bends, (abs((oh_3 * ih_1)) / m2_2), 0.25) * pick(pick(faces_1, isRough, false), (2.0 * _e75), 0.0));
    vec3 _e82 = ownWo_1;
    float _e83 = ellipticStretched(_e82, wide_2);
    float _e85 = ownWi.z;
    float ownZi = abs(_e85);
    float _e89 = ownWo_1.z;
    vec3 _e90 = ownWi;
    float _e91 = ellipticStretched(_e90, wide_2);
    float masked_1 = (ownZi / max(((ownZi * _e83) + (_e89 * _e91)), 1e-20));
    vec3 _e97 = ownWo_1;
    float _e98 = ellipticBound(_e97, wide_2);
    bool _e99 = isSolidHere();
    float bound_3 = pick(pick(_e99, !(isCoat), false), 1.0, _e98);
    float _e106 = ownWo_1.z;
    return Facets((spread_1 * masked_1), (spread_1 / ((bound_3 * _e106) + _e83)), min(abs(oh_3), 1.0));
}

vec3 indexOf(vec3 f0_1) {
    vec3 root_2 = sqrt(min(f0_1, vec3(0.9999)));
    return ((vec3(1.0) + root_2) / (vec3(1.0) - root_2));
}

vec3 sensitivity(float difference, vec3 shift) {
    float phase = (6.2831855e-9 * difference);
    vec4 mean = vec4(1681000.0, 1795300.0, 2208400.0, 2239900.0);
    vec4 variance = vec4(4327800000.0, 9304600000.0, 6612100000.0, 4528200000.0);
    vec4 height_1 = vec4(0.84659, 1.000222, 1.001122, 0.153868);
    vec4 turns = ((mean * (phase * 0.15915494)) + vec4(shift, shift.x));
    vec4 lobes = ((height_1 * cos((6.2831855 * (turns - roundEven(turns))))) * exp((-(variance) * (phase * phase))));
    float x_23 = (lobes.x + lobes.w);
    return vec3((((3.2404542 * x_23) - (1.5371385 * lobes.y)) - (0.4985314 * lobes.z)), (((-0.969266 * x_23) + (1.8760108 * lobes.y)) + (0.041556 * lobes.z)), (((0.0556434 * x_23) - (0.2040259 * lobes.y)) + (1.0572252 * lobes.z)));
}

vec3 filmReflectance(vec3 f0_2, float filmIor, float thickness, float cosine_16) {
    vec3 sum = vec3(0.0);
    vec3 amplitude = vec3(0.0);
    float order = 1.0;
    float sine2_2 = ((1.0 - (cosine_16 * cosine_16)) / (filmIor * filmIor));
    float within_1 = sqrt(max((1.0 - sine2_2), 0.0));
    float first_2 = ((filmIor - 1.0) / (filmIor + 1.0));
    vec3 _e21 = schlick(vec3((first_2 * first_2)), cosine_16);
    float r12_ = _e21.x;
    float t121_ = (1.0 - r12_);
    vec3 _e28 = indexOf((f0_2 + vec3(0.0001)));
    vec3 second_1 = ((_e28 - vec3(filmIor)) / (_e28 + vec3(filmIor)));
    vec3 _e35 = schlick((second_1 * second_1), within_1);
    vec3 r123_ = clamp((r12_ * _e35), vec3(1e-5), vec3(0.9999));
    vec3 once = sqrt(r123_);
    vec3 rs = (((t121_ * t121_) * _e35) / (vec3(1.0) - r123_));
    vec3 shift_1 = (vec3(0.5) + mix(vec3(0.0), vec3(0.5), lessThan(_e28, vec3(filmIor))));
    float difference_2 = (((2.0 * filmIor) * thickness) * within_1);
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

Reflectance filmedReflectance(Surface s_18, Reflectance bare_1, float cosine_17) {
    Reflectance r_2 = Reflectance(vec3(0.0), vec3(0.0));
    bool isMetal = false;
    r_2 = bare_1;
    float _e6 = layersHere.film;
    if ((_e6 > 0.0)) {
        float _e9 = outerCosine(cosine_17);
        isMetal = (s_18.metallic >= 1.0);
        while(true) {
            float _e16 = layersHere.specularWeight;
            vec3 _e17 = dielectricF0_();
            bool _e20 = isMetal;
            vec3 f0_4 = pick(_e20, s_18.baseColor, (_e16 * _e17));
            float _e24 = layersHere.filmIor;
            float _e27 = layersHere.filmThickness;
            vec3 _e28 = filmReflectance(f0_4, _e24, _e27, _e9);
            bool _e29 = isMetal;
            if (_e29) {
                vec3 _e32 = r_2.metal;
                float _e35 = layersHere.film;
                r_2.metal = mix(_e32, _e28, _e35);
            } else {
                vec3 _e39 = r_2.dielectric;
                float _e42 = layersHere.film;
                r_2.dielectric = mix(_e39, _e28, _e42);
            }
            bool _e44 = isMetal;
            if (pick(_e44, true, (s_18.metallic <= 0.0))) {
                break;
            }
            isMetal = true;
        }
        const bool _e51 = hasTransmission;
        if (_e51) {
            vec3 _e54 = r_2.dielectric;
            float _e59 = stackHere.ratio;
            bool _e60 = reflectsAll(cosine_17, _e59);
            r_2.dielectric = pick(_e60, vec3(1.0), _e54);
        }
    }
    Reflectance _e62 = r_2;
    return _e62;
}

float shadowingExponent(float x_13, float alpha_11) {
    float m_6 = ((1.0 - alpha_11) * (1.0 - alpha_11));
    float a_9 = mix(21.5473, 25.3245, m_6);
    float b_13 = mix(3.82987, 3.32435, m_6);
    float c_6 = mix(0.19823, 0.16801, m_6);
    float d_3 = mix(-1.9776, -1.27393, m_6);
    float e_28 = mix(-4.32054, -4.85967, m_6);
    return (((a_9 / (1.0 + (b_13 * pow(x_13, c_6)))) + (d_3 * x_13)) + e_28);
}

float sheenShadowing(float cosine_18, float alpha_12) {
    float x_24 = clamp(cosine_18, 1e-6, 1.0);
    bool isLow = (x_24 < 0.5);
    float _e12 = shadowingExponent(pick(isLow, x_24, max((1.0 - x_24), 1e-6)), alpha_12);
    float _e14 = shadowingExponent(0.5, alpha_12);
    return exp(pick(isLow, _e12, ((2.0 * _e14) - _e12)));
}

float whiteSheen(vec3 wo_7, vec3 wi_4, float alpha_13) {
    vec3 m_7 = (wo_7 + wi_4);
    float m2_3 = max(dot(m_7, m_7), 1e-20);
    float sine2_3 = clamp((dot(m_7.xy, m_7.xy) / m2_3), 0.0, 1.0);
    float power = (0.5 / alpha_13);
    float density = (((2.0 + (2.0 * power)) * 0.15915494) * pick((sine2_3 < 1e-20), 0.0, exp((power * log(max(sine2_3, 1e-20))))));
    float zo_1 = max(wo_7.z, 1e-6);
    float _e38 = sheenShadowing(wo_7.z, alpha_13);
    float _e42 = sheenShadowing(wi_4.z, alpha_13);
    return (density / ((4.0 * zo_1) * ((1.0 + _e38) + _e42)));
}

float sheenAlpha(float roughness_1) {
    float r_4 = max(roughness_1, 0.07);
    return (r_4 * r_4);
}

Cover coverTowards(vec3 wi_5, bool crossing_1) {
    Cover cover_1 = Cover(1.0, vec4(0.0));
    const bool _e8 = hasCoats;
    if (_e8) {
        float _e11 = layersHere.coat;
        float _e14 = stackHere.side;
        float _e15 = coatCosine(_e14, wi_5);
        float _e16 = coatReflectance(_e11, _e15);
        float _e20 = stackHere.coat;
        bool _e23 = stackHere.inside;
        cover_1.left = (1.0 - pick(pick(_e23, crossing_1, false), _e16, _e20));
    }
    const bool _e29 = hasSheen;
    if (_e29) {
        float _e32 = stackHere.sheenColor;
        if ((_e32 > 0.0)) {
            float _e37 = layersHere.solid;
            bool _e43 = stackHere.inside;
            bool isOutside = pick(!((_e37 > 0.0)), true, (_e43 == crossing_1));
            float _e48 = stackHere.sheen;
            float _e53 = layersHere.sheenRoughness;
            float _e54 = sheenAlbedo(abs(wi_5.z), _e53);
            float most_2 = max(_e48, _e54);
            float _e58 = stackHere.coat;
            vec3 _e63 = stackHere.wo;
            float _e66 = layersHere.sheenRoughness;
            float _e67 = sheenAlpha(_e66);
            float _e68 = whiteSheen(_e63, wi_5, _e67);
            float white = (((1.0 - _e58) * _e68) / max(most_2, 1.0));
            vec3 _e76 = layersHere.sheenColor;
            float _e80 = stackHere.ofSheen;
            bool _e88 = stackHere.inside;
            cover_1.fibres = pick(pick(crossing_1, true, _e88), vec4(0.0), vec4((white * _e76), (_e80 * 0.15915494)));
            float _e92 = cover_1.left;
            float _e95 = stackHere.sheenColor;
            float _e98 = stackHere.sheen;
            cover_1.left = (_e92 * (1.0 - (_e95 * min(pick(isOutside, most_2, _e98), 1.0))));
        }
    }
    Cover _e106 = cover_1;
    return _e106;
}

float ofBeyond() {
    float _e2 = stackHere.ofCoat;
    float _e7 = stackHere.ofFacets;
    float _e11 = stackHere.ofSheen;
    float _e15 = stackHere.ofDiffuse;
    return max(((((1.0 - _e2) - _e7) - _e11) - _e15), 0.0);
}

LayeredPair evaluateLayers(Surface s_19, vec3 toLight_1, vec3 toSample, bool byMirror) {
    LayeredPair pair = LayeredPair(vec4(0.0), vec4(0.0));
    bool isLight = false;
    bool isFirst = true;
    vec4 sum_1 = vec4(0.0);
    float intoBody = 0.0;
    Reflectance r_3 = Reflectance(vec3(0.0), vec3(0.0));
    float chosen = 0.0;
    uint _e12 = frame.emitterCount;
    isLight = (_e12 > 0u);
    while(true) {
        bool _e23 = isLight;
        vec3 given_2 = pick(_e23, toLight_1, toSample);
        float _e29 = stackHere.side;
        vec3 wi_6 = vec3(given_2.xy, (given_2.z * _e29));
        vec3 facing = vec3(wi_6.xy, abs(wi_6.z));
        const bool _e37 = hasTransmission;
        const bool _e39 = hasCoatNormals;
        bool crossing_4 = pick(pick(_e37, true, _e39), (wi_6.z < 0.0), false);
        float _e47 = stackHere.coat;
        bool _e50 = isSolidHere();
        bool _e53 = stackHere.inside;
        bool apart_1 = pick((_e47 > 0.0), true, pick(pick(_e50, pick(crossing_4, true, _e53), false), (s_19.metallic < 1.0), false));
        const bool _e62 = hasCoats;
        const bool _e64 = hasTransmission;
        bool _e66 = isFirst;
        bool isCoat_2 = pick(pick(pick(_e62, true, _e64), _e66, false), apart_1, false);
        const bool _e70 = hasCoatNormals;
        bool coatEnds = pick(crossing_4, !(pick(_e70, (s_19.eta.x >= 0.0), false)), false);
        bool _e78 = isSolidHere();
        bool bends_1 = pick(pick(_e78, crossing_4, false), !(isCoat_2), false);
        Facets _e86 = facetsTowards(pick(pick(bends_1, true, pick(isCoat_2, !(coatEnds), false)), wi_6, facing), isCoat_2, bends_1);
        bool _e87 = isLight;
        bool ofMirror = pick(byMirror, !(_e87), false);
        bool _e92 = stackHere.drawnByCoat;
        bool isMirror_1 = pick(ofMirror, (isCoat_2 == _e92), false);
        float value_2 = pick(isMirror_1, 1.0, pick(ofMirror, 0.0, _e86.value));
        float density_1 = pick(isMirror_1, 1.0, pick(ofMirror, 0.0, _e86.density));
        float _e109 = stackHere.wo.z;
        bool _e112 = stackHere.inside;
        float cosine_21 = pick(pick(pick(isCoat_2, _e112, false), true, isMirror_1), _e109, _e86.cosine);
        Reflectance _e116 = bareReflectance(s_19, cosine_21);
        r_3 = _e116;
        const bool _e119 = hasIridescence;
        if (_e119) {
            Reflectance _e120 = filmedReflectance(s_19, _e116, cosine_21);
            r_3 = _e120;
        }
        float _e121 = intoBody;
        vec3 _e126 = r_3.dielectric;
        float _e127 = greatest(_e126);
        intoBody = pick(pick(isCoat_2, true, !(apart_1)), ((1.0 - s_19.metallic) * (1.0 - _e127)), _e121);
        if (isCoat_2) {
            float _e136 = stackHere.coat;
            float _e141 = stackHere.ofCoat;
            sum_1 = pick(coatEnds, vec4(0.0), vec4(vec3((_e136 * value_2)), (_e141 * density_1)));
            isFirst = false;
        } else {
            Cover _e148 = coverTowards(wi_6, crossing_4);
            Reflectance _e149 = r_3;
            Parting _e150 = partingOf(s_19, _e149);
            vec3 _e155 = stackHere.more;
            vec3 lobe = (_e148.left * pick(crossing_4, _e150.beyond, (_e150.toward * pick(isMirror_1, vec3(1.0), _e155))));
            float _e165 = stackHere.ofFacets;
            chosen = _e165;
            const bool _e168 = hasTransmission;
            if (_e168) {
                float _e169 = shareToward(s_19, _e116);
                float _e170 = chosen;
                float _e176 = stackHere.ratio;
                float _e179 = stackHere.ratio;
                chosen = (_e170 * (pick(crossing_4, (1.0 - _e169), _e169) * pick(bends_1, (_e176 * _e179), 1.0)));
            }
            vec4 _e185 = sum_1;
            float _e187 = chosen;
            sum_1 = (_e185 + vec4((lobe * value_2), (_e187 * density_1)));
            float _e193 = layersHere.beyond;
            float _e200 = layersHere.beyond;
            vec3 _e203 = layersHere.beyondColor;
            vec3 body_1 = pick(crossing_4, (_e200 * _e203), ((1.0 - _e193) * s_19.baseColor));
            float _e207 = intoBody;
            float _e211 = layersHere.transmission;
            vec3 matte = (((_e148.left * _e207) * (1.0 - _e211)) * body_1);
            float _e219 = stackHere.ofDiffuse;
            float _e220 = ofBeyond();
            vec4 even_1 = (_e148.fibres + (vec4(matte, pick(crossing_4, _e220, _e219)) * (0.31830987 * facing.z)));
            vec4 _e228 = sum_1;
            sum_1 = (_e228 + pick(ofMirror, vec4(0.0), even_1));
            vec4 _e233 = sum_1;
            sum_1 = pick(pick(!(crossing_4), (wi_6.z < 0.0), false), vec4(0.0), _e233);
            vec4 _e243 = pair.toLight;
            vec4 _e244 = sum_1;
            bool _e245 = isLight;
            vec4 _e247 = sum_1;
            pair = LayeredPair(pick(_e245, _e244, _e243), _e247);
            bool _e249 = isLight;
            if (!(_e249)) {
                break;
            }
            isLight = false;
            isFirst = true;
            sum_1 = vec4(0.0);
        }
    }
    LayeredPair _e255 = pair;
    return _e255;
}

Pair evaluatePair(Surface s_20, Outgoing o_7, vec3 toLight_2, BsdfSample drawn_3) {
    Pair pair_1 = Pair(vec4(0.0), BsdfSample(vec3(0.0), 0.0, vec3(0.0), false));
    vec4 _e4 = evaluateBsdf(s_20, o_7, toLight_2);
    vec4 _e6 = evaluateBsdf(s_20, o_7, drawn_3.direction);
    BsdfSample _e7 = completed(drawn_3, _e6);
    pair_1 = Pair(_e4, _e7);
    const bool _e11 = hasLayers;
    if (_e11) {
        bool _e14 = isLayered(uint(s_20.code));
        if (_e14) {
            bool byMirror_1 = pick(drawn_3.delta, !(any(greaterThan(drawn_3.weight, vec3(0.0)))), false);
            float _e24 = mirrorShare(s_20.reflectivity);
            float base_2 = (1.0 - _e24);
            LayeredPair _e28 = evaluateLayers(s_20, toLight_2, drawn_3.direction, byMirror_1);
            pair_1.toLight = (base_2 * _e28.toLight);
            BsdfSample _e41 = completed(BsdfSample(drawn_3.direction, drawn_3.pdf, drawn_3.weight, pick(drawn_3.delta, !(byMirror_1), false)), (base_2 * _e28.toSample));
            pair_1.drawn = BsdfSample(_e41.direction, _e41.pdf, _e41.weight, drawn_3.delta);
        }
    }
    Pair _e48 = pair_1;
    return _e48;
}

bool crosses(vec3 geometric_2, vec3 a_3, vec3 b_5) {
    return ((dot(geometric_2, a_3) > 0.0) != (dot(geometric_2, b_5) > 0.0));
}

float misWeight(float own_2, float other) {
    float ratio_7 = (other / own_2);
    return (1.0 / (1.0 + (ratio_7 * ratio_7)));
}

float max3_(vec3 v_9) {
    return max(max(v_9.x, v_9.y), v_9.z);
}

vec3 litSideOf(Meeting m) {
    return pick(m.isClear, vec3(0.0), m.basis.normal);
}

bool isFlat(uint i_18) {
    uint _e4 = frame.shapeEnds.y;
    return (i_18 >= _e4);
}

void scatter(inout Path p_13, PairHit hit_2, Meeting m_1, Lit lit) {
    vec3 hero_3 = vec3(1.0);
    RayPair rays_3 = p_13.rays;
    bool escaped_1 = (hit_2.shape == noShape);
    LightSample light_1 = lit.light;
    const bool _e14 = hasTransmission;
    if (_e14) {
        float _e18 = layersHere.dispersion;
        if (pick(m_1.isClear, (_e18 > 0.0), false)) {
            vec3 _e23 = p_13.throughput;
            float _e25 = nextHash(p_13.sampler_);
            vec3 _e26 = heroColor(_e23, _e25);
            hero_3 = _e26;
        }
    }
    vec3 _e29 = hero_3;
    Outgoing _e30 = outgoing(m_1.surface, m_1.wo, _e29);
    BsdfSample _e33 = sampleLobe(m_1.surface, _e30, lit.u);
    vec3 _e37 = toLocal(m_1.basis, light_1.direction);
    Pair _e38 = evaluatePair(m_1.surface, _e30, _e37, _e33);
    const bool _e40 = hasMeshes;
    bool opaque = pick(_e40, !(m_1.isClear), false);
    bool _e48 = crosses(m_1.geometric, light_1.direction, -(rays_3.direction));
    bool lightLeaks = pick(opaque, _e48, false);
    vec4 toLight_5 = pick(lightLeaks, vec4(0.0), _e38.toLight);
    bool alone_1 = pick(light_1.delta, true, pick((lit.shape < 0.0), (light_1.distance_ < 1e30), false));
    float _e65 = misWeight(lit.pdf, toLight_5.w);
    float lightWeight = (pick(alone_1, 1.0, _e65) / lit.pdf);
    BsdfSample bsdf = _e38.drawn;
    vec3 _e73 = toWorld(m_1.basis, bsdf.direction);
    bool _e77 = crosses(m_1.geometric, _e73, -(rays_3.direction));
    bool leaks = pick(opaque, _e77, false);
    uint _e81 = p_13.depth;
    uint _e84 = frame.maxDepth;
    bool goesOn = pick(!(escaped_1), (_e81 != _e84), false);
    vec3 _e88 = p_13.throughput;
    vec3 contribution = (((_e88 * toLight_5.xyz) * light_1.radiance) * lightWeight);
    bool isLit = pick(pick(goesOn, (lit.pdf > 0.0), false), any(greaterThan((toLight_5.xyz * light_1.radiance), vec3(0.0))), false);
    p_13.light = pick(isLit, contribution, vec3(0.0));
    vec3 _e111 = p_13.throughput;
    vec3 throughput_1 = (_e111 * bsdf.weight);
    float _e114 = max3_(throughput_1);
    uint _e120 = p_13.depth;
    float survival = pick((_e120 < rouletteDepth), 1.0, min((_e114 / 0.33333334), 0.95));
    float _e131 = max3_(throughput_1);
    float _e136 = nextHash(p_13.sampler_);
    bool alive = pick(pick(pick(pick(goesOn, (bsdf.pdf > 0.0), false), !(leaks), false), (_e131 > 0.0), false), (_e136 < survival), false);
    uint _e141 = p_13.depth;
    p_13.depth = (_e141 + 1u);
    const bool _e144 = hasMeshes;
    bool stays = pick(!(_e144), escaped_1, false);
    vec3 _e151 = p_13.throughput;
    p_13.throughput = pick(stays, _e151, (throughput_1 / vec3(survival)));
    float _e159 = p_13.pdf;
    p_13.pdf = pick(stays, _e159, pick(bsdf.delta, 0.0, bsdf.pdf));
    vec3 _e162 = litSideOf(m_1);
    vec3 _e164 = p_13.litSide;
    p_13.litSide = pick(stays, _e164, _e162);
    float _e172 = p_13.odds.total;
    p_13.odds.total = pick(stays, _e172, lit.odds.total);
    float _e180 = p_13.odds.tree;
    p_13.odds.tree = pick(stays, _e180, lit.odds.tree);
    bool _e183 = isFlat(m_1.shape);
    bool solid = !(_e183);
    uint lightShape = pick((lit.shape >= 0.0), uint(max(lit.shape, 0.0)), noShape);
    Sampler _e222 = p_13.sampler_;
    uint _e223 = numberOfNext(_e222);
    p_13.rays = RayPair(pick(stays, rays_3.point, m_1.point), m_1.shape, hit_2.triangle, (1e-5 * length(m_1.point)), alive, pick(stays, rays_3.direction, _e73), pick(solid, (dot(_e73, m_1.outward) < 0.0), false), light_1.direction, pick(solid, (dot(light_1.direction, m_1.outward) < 0.0), false), pick(isLit, light_1.distance_, -1.0), lightShape, _e223);
    return;
}

Emitter fetchEmitter(uint i_19) {
    vec4 _e2 = tableTexel(14u, i_19);
    vec4 _e4 = tableTexel(15u, i_19);
    vec4 _e6 = tableTexel(16u, i_19);
    vec4 _e8 = tableTexel(17u, i_19);
    vec4 _e10 = tableTexel(18u, i_19);
    vec4 _e12 = tableTexel(19u, i_19);
    return Emitter(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.x, _e10.y, _e10.z, _e10.w, _e12.x, _e12.y, _e12.z, _e12.w);
}

int emitterOf(float code_11) {
    return ((int(code_11) >> 7u) - 1);
}

uint emitterOfTriangle(Emitter e, LeftTriangle t_4) {
    return (((t_4.instance - uint(e.instance)) * uint(e.cosInner)) + (t_4.triangle >> uint(e.radius)));
}

Emitter emitterAt(uint i_20, Emitter only) {
    Emitter emitter = Emitter(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    emitter = only;
    const bool _e4 = hasManyLights;
    if (_e4) {
        Emitter _e5 = fetchEmitter(i_20);
        emitter = _e5;
    }
    Emitter _e6 = emitter;
    return _e6;
}

SphereView viewSphere(Emitter e_1, vec3 point) {
    vec3 toCenter_2 = (e_1.position - point);
    float d_4 = length(toCenter_2);
    float power_1 = abs(((d_4 - e_1.radius) * (d_4 + e_1.radius)));
    bool inside_6 = (d_4 <= e_1.radius);
    float sine_4 = min((e_1.radius / max(d_4, 1e-30)), 1.0);
    float cosine_22 = (sqrt(power_1) / max(d_4, 1e-30));
    return SphereView(toCenter_2, d_4, power_1, inside_6, pick(inside_6, 2.0, ((sine_4 * sine_4) / (1.0 + cosine_22))));
}

float conePdf(float width) {
    return (1.0 / (6.2831855 * max(width, 1e-31)));
}

float spherePdf(Emitter e_2, vec3 point_1, vec3 direction_10) {
    SphereView _e3 = viewSphere(e_2, point_1);
    bool reached = pick(_e3.inside, true, (dot(direction_10, _e3.toCenter) > 0.0));
    float _e11 = conePdf(_e3.width);
    return pick(reached, _e11, 0.0);
}

float areaPdf(float area, float height, float distance_) {
    float pdf_2 = (((distance_ / max(height, 1e-30)) * distance_) / max((area / distance_), 1e-30));
    return min(pdf_2, 1e30);
}

float pdfOfView(QuadView q_3, float area_1, float distance_1) {
    float _e4 = areaPdf(area_1, q_3.height, distance_1);
    float pdf_3 = pick(q_3.bySolidAngle, (1.0 / max(q_3.solidAngle, 0.01)), _e4);
    return pick(q_3.lit, pdf_3, 0.0);
}

float arctangent(float x_14) {
    float a_10 = abs(x_14);
    bool steep = (a_10 > 2.4142137);
    bool middle_1 = pick((a_10 > 0.41421357), !(steep), false);
    float r_5 = pick(steep, (-1.0 / max(a_10, 1.0)), pick(middle_1, ((a_10 - 1.0) / (a_10 + 1.0)), a_10));
    float base_3 = pick(steep, 1.5707964, pick(middle_1, 0.7853982, 0.0));
    float z_3 = (r_5 * r_5);
    float series = ((((((0.080537446 * z_3) - 0.13877685) * z_3) + 0.19977711) * z_3) - 0.3333295);
    return (sign(x_14) * (base_3 + (((series * z_3) * r_5) + r_5)));
}

float stretch(float x_15, vec2 y_5, float h_5) {
    vec2 r_6 = sqrt(((vec2((x_15 * x_15)) + (y_5 * y_5)) + vec2((h_5 * h_5))));
    float _e16 = arctangent(((x_15 * y_5.y) / (h_5 * r_6.y)));
    float _e22 = arctangent(((x_15 * y_5.x) / (h_5 * r_6.x)));
    return (_e16 - _e22);
}

QuadView viewQuad(Emitter e_3, vec3 point_2) {
    vec3 corner = (e_3.position - point_2);
    vec2 lengths = vec2(length(e_3.u), length(e_3.v));
    vec3 axisX = (e_3.u / vec3(lengths.x));
    vec3 axisY = (e_3.v / vec3(lengths.y));
    vec3 normal_18 = normalize(cross(axisX, axisY));
    float signedHeight = dot(corner, normal_18);
    float least_2 = (1e-7 * (lengths.x + lengths.y));
    float height_2 = max(abs(signedHeight), least_2);
    bool lit_1 = pick((abs(signedHeight) > least_2), pick((e_3.oneSided == 0.0), true, (signedHeight < 0.0)), false);
    vec2 low_3 = vec2(dot(corner, axisX), dot(corner, axisY));
    vec2 high_2 = (low_3 + lengths);
    vec2 y_10 = vec2(low_3.y, high_2.y);
    float _e44 = stretch(low_3.x, y_10, height_2);
    float _e46 = stretch(high_2.x, y_10, height_2);
    float solidAngle = (_e46 - _e44);
    bool rectangle = (abs(dot(axisX, axisY)) <= 1e-5);
    vec3 axisZ = (normal_18 * pick((signedHeight > 0.0), 1.0, -1.0));
    return QuadView(corner, axisX, axisY, axisZ, low_3, high_2, height_2, _e44, solidAngle, lit_1, pick(rectangle, (solidAngle > 0.01), false));
}

float quadPdf(Emitter e_4, vec3 point_3, float distance_2) {
    QuadView _e3 = viewQuad(e_4, point_3);
    float _e5 = pdfOfView(_e3, e_4.area, distance_2);
    return _e5;
}

BoxView viewBox(Emitter e_5, vec3 point_4) {
    Extent _e4 = fetchExtent(uint(e_5.shape));
    vec4 rotation = _e4.a;
    vec3 _e8 = rotate(rotation, (point_4 - e_5.position));
    bvec3 seen = greaterThan(abs(_e8), e_5.u);
    vec3 faces_2 = mix(vec3(0.0), ((4.0 * e_5.u.yzx) * e_5.u.zxy), seen);
    return BoxView(rotation, _e8, faces_2, ((faces_2.x + faces_2.y) + faces_2.z), !(any(seen)));
}

float boxPdf(Emitter e_6, vec3 point_5, vec3 direction_11, float distance_3, vec3 normal_4) {
    BoxView _e5 = viewBox(e_6, point_5);
    float _e10 = areaPdf(_e5.area, (distance_3 * abs(dot(direction_11, normal_4))), distance_3);
    float _e12 = conePdf(2.0);
    return pick(_e5.inside, _e12, _e10);
}

LampTriangle fetchLampTriangle(uint row_8) {
    uvec4 _e3 = geometryRow((row_8 + 0u));
    return LampTriangle(uintBitsToFloat(_e3.x), _e3.y, _e3.z, uintBitsToFloat(_e3.w));
}

float meshPdf(Emitter e_7, vec3 direction_12, float distance_4, vec3 normal_5, uint place_3) {
    uint _e7 = frame.lampTables;
    uint row_13 = ((_e7 + uint(e_7.table)) + (place_3 & ((1u << uint(e_7.radius)) - 1u)));
    float _e23 = areaPdf(e_7.area, (distance_4 * abs(dot(direction_12, normal_5))), distance_4);
    LampTriangle _e24 = fetchLampTriangle(row_13);
    return (_e23 * _e24.density);
}

float shapePdf(Emitter e_8, vec3 point_6, vec3 direction_13, float distance_5, vec3 normal_6, uint place_4) {
    float pdf = 0.0;
    const bool _e9 = hasSphereLights;
    if (_e9) {
        if ((e_8.kind == 0.0)) {
            float _e13 = spherePdf(e_8, point_6, direction_13);
            pdf = _e13;
        }
    }
    const bool _e15 = hasQuadLights;
    if (_e15) {
        if ((e_8.kind == 1.0)) {
            float _e19 = quadPdf(e_8, point_6, distance_5);
            pdf = _e19;
        }
    }
    const bool _e21 = hasBoxLights;
    if (_e21) {
        if ((e_8.kind == 2.0)) {
            float _e25 = boxPdf(e_8, point_6, direction_13, distance_5, normal_6);
            pdf = _e25;
        }
    }
    const bool _e27 = hasMeshLamps;
    if (_e27) {
        if ((e_8.kind == 7.0)) {
            float _e31 = meshPdf(e_8, direction_13, distance_5, normal_6, place_4);
            pdf = _e31;
        }
    }
    float _e32 = pdf;
    return _e32;
}

float cosineTowards(Emitter e_9, vec3 toLight_3, float grown, vec3 normal_7) {
    float above_1 = clamp(((dot(normal_7, toLight_3) + e_9.reach) / grown), 0.0, 1.0);
    return pick((dot(normal_7, normal_7) == 0.0), 1.0, above_1);
}

float spotFalloff(Emitter e_10, vec3 toLight_4) {
    float share_5 = clamp(((-(dot(toLight_4, e_10.u)) - e_10.radius) / (e_10.cosInner - e_10.radius)), 0.0, 1.0);
    return (share_5 * share_5);
}

float estimatedIrradiance(Emitter e_11, vec3 point_7, vec3 normal_8) {
    float estimate = 0.0;
    const bool _e4 = hasQuadLights;
    bool isQuad = pick(_e4, (e_11.kind == 1.0), false);
    const bool _e10 = hasSuns;
    bool isFar = pick(_e10, (e_11.kind == 5.0), false);
    vec3 middle_2 = (e_11.position + pick(isQuad, (0.5 * (e_11.u + e_11.v)), vec3(0.0)));
    vec3 toLight_6 = pick(isFar, -(e_11.u), (middle_2 - point_7));
    float distance2_ = dot(toLight_6, toLight_6);
    float distance_6 = sqrt(distance2_);
    float grown_1 = max((distance_6 + e_11.reach), 1e-15);
    float _e35 = cosineTowards(e_11, toLight_6, grown_1, normal_8);
    float square = pick(isQuad, (distance2_ + (e_11.area / 3.1415927)), max(distance2_, (e_11.area / 12.566371)));
    estimate = ((e_11.power * _e35) / pick(isFar, 1.0, max(square, 1e-15)));
    const bool _e54 = hasQuadLights;
    if (_e54) {
        float height_3 = (-(dot(cross(e_11.u, e_11.v), toLight_6)) / max(e_11.area, 1e-30));
        float side_10 = pick((e_11.oneSided == 1.0), max(height_3, 0.0), abs(height_3));
        float lampCosine = pick((side_10 > 0.0), ((side_10 + e_11.reach) / grown_1), 0.0);
        float _e78 = estimate;
        estimate = (_e78 * pick(isQuad, lampCosine, 1.0));
    }
    const bool _e83 = hasMeshLamps;
    if (_e83) {
        float alike = length(e_11.v);
        float across_7 = -(dot(e_11.v, toLight_6));
        float side_11 = pick((e_11.oneSided == 1.0), max(across_7, 0.0), abs(across_7));
        float shown = ((0.25 * (1.0 - alike)) + ((side_11 + (alike * e_11.reach)) / grown_1));
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

float listedProbability(Emitter e_12, vec3 point_8, vec3 normal_9, Odds odds) {
    float probability_1 = 0.0;
    uint _e6 = frame.emitterCount;
    probability_1 = float(min(_e6, 1u));
    const bool _e12 = hasManyLights;
    if (_e12) {
        uint _e15 = frame.emitterCount;
        if ((_e15 > 1u)) {
            float _e18 = estimatedIrradiance(e_12, point_8, normal_9);
            probability_1 = (_e18 / max(odds.total, 1e-37));
            const bool _e24 = hasLightTree;
            if (_e24) {
                float _e25 = probability_1;
                probability_1 = (_e25 * (1.0 - odds.tree));
            }
        }
    }
    float _e30 = probability_1;
    return _e30;
}

LightNode fetchLightNode(uint i_21) {
    vec4 _e2 = tableTexel(0u, i_21);
    vec4 _e4 = tableTexel(1u, i_21);
    vec4 _e6 = tableTexel(2u, i_21);
    vec4 _e8 = tableTexel(3u, i_21);
    vec4 _e10 = tableTexel(4u, i_21);
    vec4 _e12 = tableTexel(5u, i_21);
    vec4 _e14 = tableTexel(6u, i_21);
    vec4 _e16 = tableTexel(7u, i_21);
    vec4 _e18 = tableTexel(8u, i_21);
    vec4 _e20 = tableTexel(9u, i_21);
    vec4 _e22 = tableTexel(10u, i_21);
    vec4 _e24 = tableTexel(11u, i_21);
    return LightNode(_e2.xyzw, _e4.xyzw, _e6.xyzw, _e8.xyzw, _e10.xyzw, _e12.xyzw, _e14.xyzw, _e16.xyzw, _e18.xyzw, _e20.xyzw, _e22.xyzw, _e24.xyzw);
}

vec4 sineOf(vec4 cosine_19) {
    return sqrt(max((vec4(1.0) - (cosine_19 * cosine_19)), vec4(0.0)));
}

vec4 cosineLess(vec4 cosA, vec4 sinA, vec4 cosB, vec4 sinB) {
    return mix(((cosA * cosB) + (sinA * sinB)), vec4(1.0), greaterThan(cosA, cosB));
}

vec4 estimatesOfChildren(LightNode n_3, vec3 point_9, vec3 normal_10) {
    vec4 x_25 = (n_3.x - vec4(point_9.x));
    vec4 y_11 = (n_3.y - vec4(point_9.y));
    vec4 z_4 = (n_3.z - vec4(point_9.z));
    vec4 distance2_1 = (((x_25 * x_25) + (y_11 * y_11)) + (z_4 * z_4));
    vec4 inverse_3 = inversesqrt(max(distance2_1, vec4(1e-30)));
    bvec4 inside_7 = lessThanEqual(distance2_1, (n_3.reach * n_3.reach));
    vec4 sinB_1 = min((n_3.reach * inverse_3), vec4(1.0));
    vec4 _e33 = sineOf(sinB_1);
    vec4 cosB_1 = mix(_e33, vec4(-1.0), inside_7);
    vec4 along_3 = (-((((n_3.axisX * x_25) + (n_3.axisY * y_11)) + (n_3.axisZ * z_4))) * inverse_3);
    vec4 cosW = clamp(mix(along_3, abs(along_3), greaterThan(n_3.bothSides, vec4(0.5))), vec4(-1.0), vec4(1.0));
    vec4 _e58 = sineOf(cosW);
    vec4 _e60 = sineOf(n_3.cosWidth);
    vec4 _e62 = cosineLess(cosW, _e58, n_3.cosWidth, _e60);
    vec4 _e63 = sineOf(_e62);
    vec4 _e64 = cosineLess(_e62, _e63, cosB_1, sinB_1);
    vec4 cosOut = mix(_e64, vec4(1.0), inside_7);
    vec4 cosN = clamp(((((normal_10.x * x_25) + (normal_10.y * y_11)) + (normal_10.z * z_4)) * inverse_3), vec4(-1.0), vec4(1.0));
    vec4 _e82 = sineOf(cosN);
    vec4 _e83 = cosineLess(cosN, _e82, cosB_1, sinB_1);
    vec4 above_2 = mix(max(_e83, vec4(0.0)), vec4(1.0), inside_7);
    vec4 cosIn = pick((dot(normal_10, normal_10) == 0.0), vec4(1.0), above_2);
    vec4 estimate_2 = (((n_3.power * cosOut) * cosIn) / max(max(distance2_1, (n_3.reach * n_3.reach)), vec4(1e-15)));
    return mix(vec4(0.0), min(estimate_2, vec4(1e30)), greaterThan(cosOut, n_3.cosEdge));
}

float shareOfTree(float total, float far) {
    float share_6 = (0.25 + ((0.5 * total) / max((total + far), 1e-37)));
    return pick((total <= 0.0), 0.0, pick((far <= 0.0), 1.0, share_6));
}

TreeChoice descend(vec3 point_10, vec3 normal_11, float u_12, int leaf, float far_1) {
    uint level = 0u;
    uint node_1 = 0u;
    float rest = 0.0;
    TreeChoice choice = TreeChoice(0u, 1.0, 0.0, true);
    uint _e7 = frame.lightTreeDepth;
    level = _e7;
    rest = u_12;
    while(true) {
        uint _e19 = level;
        level = (_e19 - 1u);
        uint _e23 = frame.lightTree;
        uint _e24 = node_1;
        LightNode _e26 = fetchLightNode((_e23 + _e24));
        vec4 _e27 = estimatesOfChildren(_e26, point_10, normal_11);
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
        bool low_4 = (child < 2u);
        bool odd = ((child & 1u) == 1u);
        float own_9 = pick(low_4, pick(odd, _e27.y, _e27.x), pick(odd, _e27.w, _e27.z));
        float before_1 = pick(low_4, pick(odd, _e27.x, 0.0), pick(odd, three, two));
        float _e95 = choice.probability;
        choice.probability = (_e95 * (own_9 / max(total_2, 1e-37)));
        choice.emitter = uint(pick(low_4, pick(odd, _e26.emitters.y, _e26.emitters.x), pick(odd, _e26.emitters.w, _e26.emitters.z)));
        rest = clamp(((at_2 - before_1) / max(own_9, 1e-37)), 0.0, 0.99999994);
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

float treeProbability(Emitter e_13, vec3 point_11, vec3 normal_12, Odds odds_1) {
    float probability_2 = 0.0;
    uint _e8 = frame.lightTreeDepth;
    if ((_e8 > 0u)) {
        TreeChoice _e17 = descend(point_11, normal_12, 0.0, int(max(e_13.leaf, 0.0)), odds_1.total);
        probability_2 = (_e17.probability * _e17.share);
    }
    float _e21 = probability_2;
    return _e21;
}

vec3 metLight(Path p_14, PairHit hit_3, Surface s_21, vec3 outward, Emitter only_1) {
    vec3 found_8 = vec3(0.0);
    uint i_22 = 0u;
    float probability_3 = 0.0;
    vec3 direction_21 = p_14.rays.direction;
    bool hidden = pick(((uint(s_21.code) & 16u) != 0u), (dot(outward, direction_21) > 0.0), false);
    int _e18 = emitterOf(s_21.code);
    found_8 = pick(hidden, vec3(0.0), s_21.emission);
    uint _e28 = frame.emitterCount;
    if (pick((_e18 >= 0), (_e28 > 0u), false)) {
        i_22 = uint(max(_e18, 0));
        const bool _e37 = hasMeshLamps;
        if (_e37) {
            if ((hit_3.triangle.instance != noInstance)) {
                uint _e42 = i_22;
                uint _e43 = i_22;
                Emitter _e44 = emitterAt(_e43, only_1);
                uint _e46 = emitterOfTriangle(_e44, hit_3.triangle);
                i_22 = (_e42 + _e46);
            }
        }
        uint _e48 = i_22;
        Emitter _e49 = emitterAt(_e48, only_1);
        float _e55 = shapePdf(_e49, p_14.rays.point, direction_21, hit_3.t, outward, hit_3.triangle.triangle);
        float _e60 = listedProbability(_e49, p_14.rays.point, p_14.litSide, p_14.odds);
        probability_3 = _e60;
        const bool _e63 = hasLightTree;
        if (_e63) {
            if ((_e49.leaf >= 0.0)) {
                float _e71 = treeProbability(_e49, p_14.rays.point, p_14.litSide, p_14.odds);
                probability_3 = _e71;
            }
        }
        vec3 _e72 = found_8;
        float _e74 = probability_3;
        float _e76 = misWeight(p_14.pdf, (_e55 * _e74));
        found_8 = (_e72 * pick((p_14.pdf <= 0.0), 1.0, _e76));
    }
    vec3 _e83 = found_8;
    return _e83;
}

uvec2 pascalW2_(uvec2 x_16) {
    uvec2 y_6 = uvec2(0u);
    uvec2 _e7 = timesW2_(((x_16 >> uvec2(2u)) & uvec2(13107u)));
    y_6 = (x_16 ^ _e7);
    uvec2 _e10 = y_6;
    uvec2 _e11 = y_6;
    uvec2 _e18 = timesW(((_e11 >> uvec2(4u)) & uvec2(3855u)));
    y_6 = (_e10 ^ _e18);
    uvec2 _e20 = y_6;
    uvec2 _e21 = y_6;
    uvec2 _e28 = timesW2_(((_e21 >> uvec2(8u)) & uvec2(255u)));
    return (_e20 ^ _e28);
}

vec2 thirdOf(Groups g_3) {
    uvec2 _e3 = timesW2_(g_3.shift);
    uvec2 _e5 = pascalW2_((g_3.index ^ _e3));
    uvec2 _e11 = scramble(_e5, (g_3.seedA ^ (g_3.seedB * 2654435761u)));
    vec2 _e12 = toUnit(_e11);
    return _e12;
}

TwoPoints nextTwo3d(inout Sampler s_22) {
    Sampler _e1 = s_22;
    Groups _e2 = nextGroups(_e1);
    uint _e5 = s_22.key;
    s_22.key = (_e5 + 2u);
    vec2 _e8 = firstOf(_e2);
    vec2 _e9 = secondOf(_e2);
    vec2 _e10 = thirdOf(_e2);
    return TwoPoints(vec3(_e8.x, _e9.x, _e10.x), vec3(_e8.y, _e9.y, _e10.y));
}

EmitterChoice chooseEmitter(vec3 point_12, vec3 normal_13, float u_13) {
    bool hasTree = false;
    EmitterChoice choice_1 = EmitterChoice(0u, 0.0, Odds(0.0, 0.0));
    float total_1 = 0.0;
    uint chosen_1 = 0u;
    float chosenWeight = 0.0;
    float rest_1 = 0.0;
    uint i_23 = 0u;
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
            rest_1 = u_13;
            while(true) {
                uint _e48 = i_23;
                Emitter _e49 = fetchEmitter(_e48);
                float _e50 = estimatedIrradiance(_e49, point_12, normal_13);
                uint _e51 = i_23;
                float weight_2 = pick((_e51 < listed), _e50, 0.0);
                float _e55 = total_1;
                total_1 = (_e55 + weight_2);
                float _e57 = total_1;
                float share_7 = (weight_2 / max(_e57, 1e-37));
                float _e61 = rest_1;
                bool take = (_e61 < share_7);
                uint _e63 = chosen_1;
                uint _e64 = i_23;
                chosen_1 = pick(take, _e64, _e63);
                float _e66 = chosenWeight;
                chosenWeight = pick(take, weight_2, _e66);
                float _e68 = rest_1;
                float _e75 = rest_1;
                rest_1 = pick(take, (_e75 / max(share_7, 1e-37)), ((_e68 - share_7) / max((1.0 - share_7), 1e-7)));
                uint _e81 = i_23;
                i_23 = (_e81 + 1u);
                uint _e83 = i_23;
                if ((_e83 >= listed)) {
                    break;
                }
            }
            uint _e85 = chosen_1;
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
                    TreeChoice _e101 = descend(point_12, normal_13, _e98, -1, _e100);
                    choice_1.odds.tree = _e101.share;
                    uint _e106 = chosen_1;
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

vec3 turnTo(vec3 axis_1, vec3 v_10) {
    float s_29 = pick((axis_1.z >= 0.0), 1.0, -1.0);
    float a_11 = (-1.0 / (s_29 + axis_1.z));
    float b_14 = ((axis_1.x * axis_1.y) * a_11);
    vec3 x_26 = vec3((1.0 + (((s_29 * axis_1.x) * axis_1.x) * a_11)), (s_29 * b_14), (-(s_29) * axis_1.x));
    vec3 y_12 = vec3(b_14, (s_29 + ((axis_1.y * axis_1.y) * a_11)), -(axis_1.y));
    return (((v_10.x * x_26) + (v_10.y * y_12)) + (v_10.z * axis_1));
}

ConeDirection sampleCone(vec3 axis_2, float width_1, vec2 u_14) {
    float oneMinusCosine = (u_14.x * width_1);
    float cosine_23 = (1.0 - oneMinusCosine);
    float sine2_4 = (oneMinusCosine * (2.0 - oneMinusCosine));
    float sine_5 = sqrt(max(sine2_4, 0.0));
    float phi_4 = (6.2831855 * u_14.y);
    vec2 turn_1 = vec2(cos(phi_4), sin(phi_4));
    vec3 _e23 = turnTo(axis_2, vec3(((sine_5 / length(turn_1)) * turn_1), cosine_23));
    return ConeDirection(_e23, cosine_23, sine2_4);
}

LightSample sampleSphere(Emitter e_14, vec3 point_13, vec2 u_15) {
    SphereView _e3 = viewSphere(e_14, point_13);
    vec3 axis_4 = pick((_e3.distance_ < 1e-30), vec3(0.0, 0.0, 1.0), (_e3.toCenter / vec3(max(_e3.distance_, 1e-30))));
    ConeDirection _e19 = sampleCone(axis_4, _e3.width, u_15);
    float along_4 = (_e3.distance_ * _e19.cosine);
    float halfChord = sqrt(max(((e_14.radius * e_14.radius) - ((_e3.distance_ * _e3.distance_) * _e19.sine2_)), 0.0));
    float larger_1 = (abs(along_4) + halfChord);
    bool takeLarger = pick(_e3.inside, (along_4 > 0.0), false);
    float distance_7 = pick(takeLarger, larger_1, (_e3.power / max(larger_1, 1e-30)));
    float _e49 = conePdf(_e3.width);
    return LightSample(_e19.direction, distance_7, e_14.radiance, _e49, false);
}

vec2 cosineAndSine(float x_17) {
    float h_10 = (0.5 * x_17);
    float z_5 = (h_10 * h_10);
    float sine_6 = (((((((-0.00019515296 * z_5) + 0.008332161) * z_5) - 0.16666655) * z_5) * h_10) + h_10);
    return vec2((1.0 - ((2.0 * sine_6) * sine_6)), ((2.0 * sine_6) * sqrt((1.0 - (sine_6 * sine_6)))));
}

vec3 sphericalRectangle(QuadView q_4, vec2 u_16) {
    float h_11 = q_4.height;
    vec2 y_13 = vec2(q_4.low.y, q_4.high.y);
    vec2 s_30 = (y_13 / sqrt(((y_13 * y_13) + vec2((h_11 * h_11)))));
    vec2 _e21 = cosineAndSine((0.5 * (q_4.start + (u_16.x * q_4.solidAngle))));
    vec2 across_8 = (vec2((s_30.y - s_30.x), (s_30.y + s_30.x)) * _e21);
    float w_8 = (((2.0 * _e21.x) * _e21.y) / max(length(across_8), 1e-15));
    float x_27 = clamp(((h_11 * w_8) * inversesqrt(max((1.0 - (w_8 * w_8)), 1e-12))), q_4.low.x, q_4.high.x);
    float d2_ = ((x_27 * x_27) + (h_11 * h_11));
    vec2 ends_2 = (y_13 * inversesqrt((vec2(d2_) + (y_13 * y_13))));
    float v_13 = mix(ends_2.x, ends_2.y, u_16.y);
    float atY = clamp(((v_13 * sqrt(d2_)) * inversesqrt(max((1.0 - (v_13 * v_13)), 1e-12))), y_13.x, y_13.y);
    return (((x_27 * q_4.axisX) + (atY * q_4.axisY)) + (h_11 * q_4.axisZ));
}

LightSample sampleQuad(Emitter e_15, vec3 point_14, vec2 u_17) {
    QuadView _e3 = viewQuad(e_15, point_14);
    vec3 onArea = ((_e3.corner + (u_17.x * e_15.u)) + (u_17.y * e_15.v));
    vec3 _e13 = sphericalRectangle(_e3, u_17);
    vec3 toLight_7 = pick(_e3.bySolidAngle, _e13, onArea);
    float distance_8 = max(length(toLight_7), _e3.height);
    float _e23 = pdfOfView(_e3, e_15.area, distance_8);
    return LightSample((toLight_7 / vec3(distance_8)), distance_8, e_15.radiance, _e23, false);
}

vec4 pointOnFaces(Emitter e_16, BoxView b_6, vec2 u_18) {
    float both = (b_6.faces.x + b_6.faces.y);
    float at_3 = (u_18.x * b_6.area);
    bool onX_1 = (at_3 < b_6.faces.x);
    bool onY_1 = pick(!(onX_1), (at_3 < both), false);
    float face = pick(onX_1, b_6.faces.x, pick(onY_1, b_6.faces.y, b_6.faces.z));
    float within_2 = clamp(((at_3 - pick(onX_1, 0.0, pick(onY_1, b_6.faces.x, both))) / max(face, 1e-30)), 0.0, 1.0);
    vec3 axis_5 = vec3(pick(onX_1, 1.0, 0.0), pick(onY_1, 1.0, 0.0), pick(pick(onX_1, true, onY_1), 0.0, 1.0));
    vec3 p_27 = vec3(pick((dot(axis_5, b_6.point) >= 0.0), 1.0, -1.0), ((2.0 * within_2) - 1.0), ((2.0 * u_18.y) - 1.0));
    vec3 toLight_8 = ((pick(onX_1, p_27.xyz, pick(onY_1, p_27.zxy, p_27.yzx)) * e_16.u) - b_6.point);
    return vec4(toLight_8, abs(dot(axis_5, toLight_8)));
}

vec3 rotateBack(vec4 q_5, vec3 v_11) {
    vec3 _e6 = rotate(vec4(-(q_5.xyz), q_5.w), v_11);
    return _e6;
}

LightSample sampleBox(Emitter e_17, vec3 point_15, vec2 u_19) {
    BoxView _e3 = viewBox(e_17, point_15);
    vec4 _e4 = pointOnFaces(e_17, _e3, u_19);
    ConeDirection _e10 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_19);
    vec3 outwards_1 = _e10.direction;
    Slabs _e16 = boxSlabs(_e3.point, outwards_1, e_17.u);
    float distance_9 = pick(_e3.inside, max(_e16.far, 0.0), length(_e4.xyz));
    vec3 direction_22 = pick(_e3.inside, outwards_1, (_e4.xyz / vec3(max(distance_9, 1e-30))));
    float _e31 = areaPdf(_e3.area, _e4.w, distance_9);
    float _e33 = conePdf(2.0);
    float pdf_4 = pick(_e3.inside, _e33, _e31);
    vec3 _e37 = rotateBack(_e3.rotation, direction_22);
    return LightSample(_e37, distance_9, e_17.radiance, pdf_4, false);
}

ChosenTriangle chooseTriangle(Emitter e_18, vec2 u_20) {
    uint _e4 = frame.lampTables;
    uint first_3 = (_e4 + uint(e_18.table));
    uint column_2 = min(uint((u_20.x * e_18.triangles)), (uint(e_18.triangles) - 1u));
    LampTriangle _e18 = fetchLampTriangle((first_3 + column_2));
    uint _e26 = mixBits((floatBitsToUint(u_20.x) ^ (floatBitsToUint(u_20.y) * 2654435761u)));
    uint hash = (_e26 >> 8u);
    float fine_2 = (((float(hash) * 5.9604645e-8) * 5.9604645e-8) * e_18.triangles);
    float x_28 = clamp((((u_20.x * e_18.triangles) - float(column_2)) + fine_2), 0.0, 0.99999994);
    bool own_10 = (x_28 < _e18.own);
    float rest_2 = pick(own_10, (x_28 / max(_e18.own, 1e-37)), ((x_28 - _e18.own) / max((1.0 - _e18.own), 1e-7)));
    uint place_8 = pick(own_10, _e18.place, _e18.other);
    LampTriangle _e67 = fetchLampTriangle((((first_3 + column_2) + place_8) - _e18.place));
    float density_2 = _e67.density;
    return ChosenTriangle(place_8, density_2, vec2(min(rest_2, 1.0), u_20.y));
}

vec2 weightsOnTriangle(vec2 u_21) {
    float low_5 = (0.5 * min(u_21.x, u_21.y));
    float high_3 = (max(u_21.x, u_21.y) - low_5);
    return pick((u_21.x < u_21.y), vec2(low_5, high_3), vec2(high_3, low_5));
}

vec3 outOfMesh(Instance i_24, vec3 p_15) {
    vec3 q_7 = (p_15 - vec3(i_24.toMeshX.w, i_24.toMeshY.w, i_24.toMeshZ.w));
    vec3 x_29 = cross(i_24.toMeshY.xyz, i_24.toMeshZ.xyz);
    vec3 y_14 = cross(i_24.toMeshZ.xyz, i_24.toMeshX.xyz);
    vec3 z_6 = cross(i_24.toMeshX.xyz, i_24.toMeshY.xyz);
    return ((((q_7.x * x_29) + (q_7.y * y_14)) + (q_7.z * z_6)) / vec3(dot(i_24.toMeshX.xyz, x_29)));
}

vec3 radianceShare(uint row_9, Cover0_ c_2, bool missing) {
    vec3 share = vec3(1.0);
    float opacity_1 = 0.0;
    uint i_25 = 0u;
    MaterialTextures _e3 = fetchMaterialTextures(row_9);
    bool hasFirst = ((_e3.flags & hasOpacityTexture) != 0u);
    uint wanted = min(_e3.count, pick(hasFirst, 2u, 1u));
    opacity_1 = (_e3.opacity * c_2.opacity);
    if ((wanted > 0u)) {
        while(true) {
            uint _e27 = i_25;
            TextureUse _e31 = fetchTextureUse(((row_9 + materialTexturesRows) + (_e27 * textureUseRows)));
            vec4 _e42 = lookUp(_e31, pick(((_e31.flags & usesSecondSet) != 0u), c_2.uv.zw, c_2.uv.xy));
            vec3 _e43 = share;
            share = (_e43 * pick((_e31.slot == emissionSlot), _e42.xyz, vec3(1.0)));
            float _e52 = opacity_1;
            uint _e54 = i_25;
            opacity_1 = (_e52 * pick(pick(hasFirst, (_e54 == 0u), false), _e42.w, 1.0));
            uint _e62 = i_25;
            i_25 = (_e62 + 1u);
            uint _e64 = i_25;
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

LightSample sampleMesh(Emitter e_19, vec3 point_16, vec2 u_22) {
    vec3 radiance = vec3(0.0);
    ChosenTriangle _e3 = chooseTriangle(e_19, u_22);
    uint _e6 = frame.instances;
    Instance _e12 = fetchInstance((_e6 + (uint(e_19.instance) * instanceRows)));
    Triangle _e18 = fetchTriangle((_e12.triangles + (_e3.place * triangleRows)));
    vec2 _e20 = weightsOnTriangle(_e3.u);
    vec3 _e34 = outOfMesh(_e12, ((_e18.a + (_e20.x * (_e18.b - _e18.a))) + (_e20.y * (_e18.c - _e18.a))));
    vec3 toLight_9 = (_e34 - point_16);
    vec3 across_9 = (mat3x3(_e12.toMeshX.xyz, _e12.toMeshY.xyz, _e12.toMeshZ.xyz) * cross((_e18.b - _e18.a), (_e18.c - _e18.a)));
    float height_4 = (dot(across_9, toLight_9) * inversesqrt(max(dot(across_9, across_9), 1e-37)));
    float distance_10 = length(toLight_9);
    float _e60 = areaPdf(e_19.area, abs(height_4), distance_10);
    float pdf_5 = (_e60 * _e3.density);
    bool lit_2 = pick((height_4 < 0.0), true, pick((e_19.oneSided == 0.0), (height_4 > 0.0), false));
    float reached_1 = max((distance_10 - (1e-5 * (length(point_16) + distance_10))), 0.0);
    radiance = e_19.radiance;
    const bool _e82 = hasVariedLamps;
    if (_e82) {
        if ((e_19.u.y > 0.0)) {
            uvec3 rows_2 = (uvec3(_e12.vertices) + (uvec3(_e18.vertexA, _e18.vertexB, _e18.vertexC) * _e12.vertexRows));
            Cover0_ _e97 = coverAt(rows_2, _e12.vertexRows, _e20);
            vec3 _e98 = radiance;
            Surface _e101 = fetchSurface(uint(e_19.shape));
            vec3 _e109 = radianceShare(uint(_e101.textures), _e97, ((_e12.cover & coverRow) != 0u));
            radiance = (_e98 * _e109);
        }
    }
    vec3 _e115 = radiance;
    return LightSample((toLight_9 / vec3(max(distance_10, 1e-30))), reached_1, _e115, pick(lit_2, pdf_5, 0.0), false);
}

LightSample samplePoint(Emitter e_20, vec3 point_17) {
    vec3 toLight_10 = (e_20.position - point_17);
    float distance_11 = length(toLight_10);
    float safe = max(distance_11, 1e-15);
    return LightSample((toLight_10 / vec3(safe)), distance_11, (e_20.radiance / vec3((safe * safe))), pick((distance_11 > 1e-15), 1.0, 0.0), true);
}

LightSample sampleSpot(Emitter e_21, vec3 point_18) {
    LightSample s_23 = LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, false);
    LightSample _e2 = samplePoint(e_21, point_18);
    s_23 = _e2;
    vec3 _e5 = s_23.direction;
    float _e6 = spotFalloff(e_21, _e5);
    vec3 _e8 = s_23.radiance;
    s_23.radiance = (_e8 * _e6);
    float _e12 = s_23.pdf;
    s_23.pdf = pick((_e6 > 0.0), _e12, 0.0);
    LightSample _e17 = s_23;
    return _e17;
}

LightSample sampleDirectional(Emitter e_22, vec2 u_23) {
    bool delta = (e_22.area == 0.0);
    ConeDirection _e10 = sampleCone(-(e_22.u), (e_22.area / 6.2831855), u_23);
    return LightSample(_e10.direction, 1e30, e_22.radiance, pick(delta, 1.0, (1.0 / max(e_22.area, 1e-31))), delta);
}

vec4 environmentTexel(uint column_1, uint row_10) {
    vec4 _e5 = texelFetch(environment, ivec2(uvec2(column_1, row_10)), 0);
    return _e5;
}

vec4 fetchEntries(Table t_5, uint pair_2) {
    float _e5 = frame.environmentSize.x;
    uint width_2 = uint(_e5);
    uint i_27 = (t_5.first + pair_2);
    uint row_14 = (i_27 / width_2);
    vec4 _e12 = environmentTexel((i_27 - (row_14 * width_2)), row_14);
    return _e12;
}

vec2 sharesBeyond(vec4 pair_3, uint digits, uint fine) {
    uvec2 further = (uvec2(pair_3.yw) & uvec2(4095u));
    return ((pair_3.xz - vec2(float(digits))) + ((vec2(further) - vec2(float(fine))) * 0.00024414063));
}

Choice chooseEntry(Table t_6, uint digits_1, uint fine_1) {
    uint low = 0u;
    uint high = 0u;
    vec2 ends = vec2(1.0);
    uint step_ = 0u;
    uint pairs = ((t_6.entries + 1u) / 2u);
    uint part = ((((digits_1 >> 12u) * t_6.entries) + (((digits_1 & 4095u) * t_6.entries) >> 12u)) >> 12u);
    vec4 _e23 = fetchEntries(t_6, (part / 2u));
    low = (uint(pick(((part & 1u) == 1u), _e23.w, _e23.y)) >> 12u);
    high = pairs;
    while(true) {
        uint _e41 = low;
        uint _e42 = step_;
        uint _e47 = low;
        uint _e48 = high;
        uint _e52 = high;
        uint next_1 = pick((_e52 < pairs), ((_e47 + _e48) / 2u), min((_e41 + _e42), (pairs - 1u)));
        vec4 _e55 = fetchEntries(t_6, next_1);
        vec2 _e56 = sharesBeyond(_e55, digits_1, fine_1);
        bool found_10 = (_e56.y > 0.0);
        vec2 _e60 = ends;
        ends = pick(found_10, _e56, _e60);
        uint _e62 = high;
        high = pick(found_10, next_1, _e62);
        uint _e66 = low;
        low = pick(found_10, _e66, (next_1 + 1u));
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
    vec4 _e84 = fetchEntries(t_6, (max(pair_5, 1u) - 1u));
    vec2 _e85 = sharesBeyond(_e84, digits_1, fine_1);
    float before_2 = _e85.y;
    float none = -((float(digits_1) + (float(fine_1) * 0.00024414063)));
    float _e94 = ends.x;
    bool isFirst_1 = (_e94 > 0.0);
    float _e98 = ends.x;
    float start = pick(isFirst_1, pick((pair_5 == 0u), none, before_2), _e98);
    float _e104 = ends.y;
    float _e106 = ends.x;
    float end = pick(isFirst_1, _e106, _e104);
    return Choice(min(((2u * pair_5) + pick(isFirst_1, 0u, 1u)), (t_6.entries - 1u)), clamp((-(start) / max((end - start), 1e-37)), 0.0, 1.0));
}

ChosenCell chooseCell(vec2 u_24) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_6 = uvec2(_e3);
    uvec2 digits_4 = uvec2((u_24 * 16777216.0));
    uint _e13 = mixBits((digits_4.x ^ (digits_4.y * 2654435761u)));
    uint columns = ((size_6.x + 1u) / 2u);
    uint tables = (size_6.x * size_6.y);
    Choice _e29 = chooseEntry(Table(tables, (size_6.y + 1u)), digits_4.y, (_e13 & 4095u));
    Choice _e44 = chooseEntry(Table(((tables + ((size_6.y + 2u) / 2u)) + (_e29.entry * columns)), size_6.x), digits_4.x, (_e13 >> 20u));
    return ChosenCell(uvec2(_e44.entry, _e29.entry), vec2(_e44.rest, _e29.rest));
}

Corners environmentCorners(uvec2 cell) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_7 = uvec2(_e3);
    uint left_2 = (pick((cell.x == 0u), size_7.x, cell.x) - 1u);
    uint right = pick((cell.x == size_7.x), 0u, cell.x);
    uint upper_1 = (max(cell.y, 1u) - 1u);
    uint lower_1 = min(cell.y, (size_7.y - 1u));
    vec4 above_3 = vec4(1.0, 1.0, 1.0, pick((cell.y == 0u), -1.0, 1.0));
    vec4 below_3 = vec4(1.0, 1.0, 1.0, pick((cell.y == size_7.y), -1.0, 1.0));
    vec4 _e49 = environmentTexel(left_2, upper_1);
    vec4 _e51 = environmentTexel(right, upper_1);
    vec4 _e53 = environmentTexel(left_2, lower_1);
    vec4 _e55 = environmentTexel(right, lower_1);
    return Corners((above_3 * _e49), (above_3 * _e51), (below_3 * _e53), (below_3 * _e55));
}

float linearSample(float u_25, float a_4, float b_7) {
    vec2 ends_3 = (vec2(a_4, b_7) / vec2(max((a_4 + b_7), 1e-37)));
    return min((u_25 / max((ends_3.x + sqrt(mix((ends_3.x * ends_3.x), (ends_3.y * ends_3.y), u_25))), 1e-9)), 1.0);
}

EnvironmentLight lightWithin(Corners k_2, vec2 at, float sine) {
    vec4 light_2 = mix(mix(k_2.a, k_2.b, at.x), mix(k_2.c, k_2.d, at.x), at.y);
    return EnvironmentLight(light_2.xyz, (max(light_2.w, 0.0) / sine));
}

EnvironmentSample sampleEnvironment(vec2 u_26) {
    vec2 size_8 = frame.environmentSize;
    ChosenCell _e4 = chooseCell(u_26);
    Corners _e6 = environmentCorners(_e4.cell);
    vec2 cell_1 = vec2(_e4.cell);
    bvec2 atPole = bvec2((cell_1.y == 0.0), (cell_1.y == size_8.y));
    float _e32 = linearSample(_e4.rest.y, max((_e6.a.w + _e6.b.w), 0.0), max((_e6.c.w + _e6.d.w), 0.0));
    float t_17 = ((_e32 * pick(any(atPole), 0.5, 1.0)) + pick(atPole.x, 0.5, 0.0));
    float _e55 = linearSample(_e4.rest.x, mix(_e6.a.w, _e6.c.w, t_17), mix(_e6.b.w, _e6.d.w, t_17));
    bool isLower = ((2.0 * cell_1.y) > size_8.y);
    float fromPole = pick(isLower, ((size_8.y - cell_1.y) + (0.5 - t_17)), (cell_1.y + (t_17 - 0.5)));
    vec2 _e76 = cosineAndSine((fromPole * (3.1415927 / size_8.y)));
    float _e85 = frame.environmentTurn;
    float halfTurns = (2.0 * (((cell_1.x + (_e55 - 0.5)) / size_8.x) - _e85));
    float nearest_2 = floor((halfTurns + 0.5));
    bool back = (fract((0.5 * nearest_2)) > 0.0);
    vec2 _e100 = cosineAndSine(((halfTurns - nearest_2) * 3.1415927));
    vec2 phi_5 = (_e100 * pick(back, -1.0, 1.0));
    float sine_7 = max(_e76.y, 1e-9);
    vec3 direction_23 = vec3((sine_7 * phi_5.y), pick(isLower, -(_e76.x), _e76.x), (-(sine_7) * phi_5.x));
    EnvironmentLight _e119 = lightWithin(_e6, vec2(_e55, t_17), sine_7);
    return EnvironmentSample(direction_23, _e119);
}

vec3 sky(vec3 direction_14) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_14.y, 0.0));
}

LightSample sampleSky(vec2 u_27) {
    EnvironmentSample s_24 = EnvironmentSample(vec3(0.0), EnvironmentLight(vec3(0.0), 0.0));
    ConeDirection _e6 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_27);
    s_24 = EnvironmentSample(_e6.direction, white0_);
    const bool _e12 = hasEnvironment;
    if (_e12) {
        EnvironmentSample _e13 = sampleEnvironment(u_27);
        s_24 = _e13;
    }
    vec3 _e15 = s_24.direction;
    vec3 _e18 = s_24.light.radiance;
    vec3 _e20 = s_24.direction;
    vec3 _e21 = sky(_e20);
    float _e25 = s_24.light.pdf;
    return LightSample(_e15, 1e30, (_e18 * _e21), _e25, false);
}

LightSample sampleEmitter(Emitter e_23, vec3 point_19, vec2 u_28) {
    LightSample s_25 = LightSample(vec3(0.0, 1.0, 0.0), 1e30, vec3(0.0), 0.0, true);
    const bool _e15 = hasSphereLights;
    if (_e15) {
        if ((e_23.kind == 0.0)) {
            LightSample _e19 = sampleSphere(e_23, point_19, u_28);
            s_25 = _e19;
        }
    }
    const bool _e21 = hasQuadLights;
    if (_e21) {
        if ((e_23.kind == 1.0)) {
            LightSample _e25 = sampleQuad(e_23, point_19, u_28);
            s_25 = _e25;
        }
    }
    const bool _e27 = hasBoxLights;
    if (_e27) {
        if ((e_23.kind == 2.0)) {
            LightSample _e31 = sampleBox(e_23, point_19, u_28);
            s_25 = _e31;
        }
    }
    const bool _e33 = hasMeshLamps;
    if (_e33) {
        if ((e_23.kind == 7.0)) {
            LightSample _e37 = sampleMesh(e_23, point_19, u_28);
            s_25 = _e37;
        }
    }
    const bool _e39 = hasPointLights;
    if (_e39) {
        if ((e_23.kind == 3.0)) {
            LightSample _e43 = samplePoint(e_23, point_19);
            s_25 = _e43;
        }
    }
    const bool _e45 = hasPointLights;
    if (_e45) {
        if ((e_23.kind == 4.0)) {
            LightSample _e49 = sampleSpot(e_23, point_19);
            s_25 = _e49;
        }
    }
    const bool _e51 = hasSuns;
    if (_e51) {
        if ((e_23.kind == 5.0)) {
            LightSample _e55 = sampleDirectional(e_23, u_28);
            s_25 = _e55;
        }
    }
    const bool _e57 = hasSky;
    if (_e57) {
        if ((e_23.kind == 6.0)) {
            LightSample _e61 = sampleSky(u_28);
            s_25 = _e61;
        }
    }
    float _e64 = s_25.pdf;
    float _e66 = s_25.distance_;
    s_25.pdf = pick((_e66 <= (1e-5 * length(point_19))), 0.0, _e64);
    LightSample _e73 = s_25;
    return _e73;
}

Lit lightAt(inout Path p_16, PairHit hit_4, Meeting m_2) {
    Emitter _e4 = fetchEmitter(0u);
    Path _e5 = p_16;
    vec3 _e8 = metLight(_e5, hit_4, m_2.surface, m_2.geometric, _e4);
    vec3 _e10 = p_16.radiance;
    vec3 _e12 = p_16.throughput;
    p_16.radiance = (_e10 + (_e12 * pick((hit_4.shape == noShape), vec3(0.0), _e8)));
    TwoPoints _e22 = nextTwo3d(p_16.sampler_);
    vec3 _e24 = litSideOf(m_2);
    EmitterChoice _e27 = chooseEmitter(m_2.point, _e24, _e22.first.z);
    Emitter _e29 = emitterAt(_e27.index, _e4);
    LightSample _e33 = sampleEmitter(_e29, m_2.point, _e22.first.xy);
    return Lit(_e33, (_e33.pdf * _e27.probability), _e29.shape, _e27.odds, _e22.second);
}

void meetSurface(inout Path p_17, PairHit hit_5) {
    Meeting _e2 = meetingAt(p_17, hit_5);
    p_17.escaped = (hit_5.shape == noShape);
    const bool _e8 = hasMeshes;
    if (_e8) {
        bool _e10 = p_17.escaped;
        if (_e10) {
            p_17.rays.goesOn = false;
            return;
        }
    }
    Lit _e14 = lightAt(p_17, hit_5, _e2);
    scatter(p_17, hit_5, _e2, _e14);
    return;
}

void extendPath(inout Path p_18) {
    RayPair _e2 = p_18.rays;
    PairHit _e3 = tracePair(_e2);
    vec3 _e5 = p_18.radiance;
    vec3 _e7 = p_18.light;
    p_18.radiance = (_e5 + pick(_e3.blocked, vec3(0.0), _e7));
    p_18.rays.lightDistance = -1.0;
    bool _e18 = p_18.rays.goesOn;
    if (_e18) {
        meetSurface(p_18, _e3);
        return;
    } else {
        return;
    }
}

bool isOver(Path p_19) {
    return pick(!(p_19.rays.goesOn), (p_19.rays.lightDistance < 0.0), false);
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
    float sine_8 = max(length(direction_15.xz), 1e-9);
    vec2 _e15 = quadrantAngles(abs(vec2(direction_15.z, direction_15.y)), vec2(abs(direction_15.x), sine_8));
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
    EnvironmentLight _e67 = lightWithin(_e66, at_4, sine_8);
    return _e67;
}

EnvironmentLight skyLight(vec3 direction_16) {
    EnvironmentLight light = white0_;
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

void addSkyAndSuns(inout Path p_20) {
    vec3 found_9 = vec3(0.0);
    uint i_26 = 0u;
    vec3 direction_24 = p_20.rays.direction;
    FarLight _e4 = skySeen(direction_24);
    while(true) {
        uint _e10 = i_26;
        Emitter _e11 = fetchEmitter(_e10);
        FarLight _e12 = farLight(_e11, direction_24, _e4);
        vec3 _e15 = p_20.litSide;
        Odds _e17 = p_20.odds;
        float _e18 = farProbability(_e11, _e15, _e17);
        float pdf_6 = (_e12.pdf * _e18);
        vec3 _e20 = found_9;
        float _e23 = p_20.pdf;
        float _e24 = misWeight(_e23, pdf_6);
        float _e26 = p_20.pdf;
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
    vec3 _e49 = p_20.radiance;
    vec3 _e51 = p_20.throughput;
    vec3 _e52 = found_9;
    p_20.radiance = (_e49 + (_e51 * _e52));
    return;
}

void addFarLight(inout Path p_21) {
    const bool _e2 = hasSky;
    const bool _e4 = hasSuns;
    if (pick(_e2, true, _e4)) {
        bool _e7 = p_21.escaped;
        uint _e10 = frame.emitterCount;
        if (pick(_e7, (_e10 > 0u), false)) {
            addSkyAndSuns(p_21);
            return;
        } else {
            return;
        }
    } else {
        return;
    }
}

void main() {
    vec4 fragment = gl_FragCoord;
    Path p = Path(RayPair(vec3(0.0), 0u, LeftTriangle(0u, 0u), 0.0, false, vec3(0.0), false, vec3(0.0), false, 0.0, 0u, 0u), vec3(0.0), vec3(0.0), false, 0u, vec3(0.0), 0.0, vec3(0.0), Odds(0.0, 0.0), Sampler(0u, 0u, 0u, 0u));
    Film film = Film(vec4(0.0), vec4(0.0));
    uvec2 texel_2 = uvec2(fragment.xy);
    Path _e3 = noPath();
    p = _e3;
    uvec2 _e7 = frame.origin;
    uint _e11 = frame.sampleIndex;
    startPath(p, (_e7 + texel_2), _e11);
    while(true) {
        extendPath(p);
        Path _e12 = p;
        bool _e13 = isOver(_e12);
        if (_e13) {
            break;
        }
    }
    addFarLight(p);
    uint _e22 = frame.sampleIndex;
    if ((_e22 > 0u)) {
        vec4 _e27 = texelFetch(previousFilm, ivec2(texel_2), 0);
        vec4 _e30 = texelFetch(previousSquares, ivec2(texel_2), 0);
        film = Film(_e27, _e30);
    }
    vec4 _e33 = film.sums;
    vec3 _e35 = p.radiance;
    vec4 _e40 = film.squares;
    vec3 _e42 = p.radiance;
    vec3 _e44 = p.radiance;
    Film _tmp_return = Film((_e33 + vec4(_e35, 1.0)), (_e40 + vec4((_e42 * _e44), 0.0)));
    _fs2p_location0 = _tmp_return.sums;
    _fs2p_location1 = _tmp_return.squares;
    return;
}

