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

struct Layers {
    vec4 first;
    vec4 second;
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
struct PairHit {
    float t;
    uint shape;
    bool blocked;
    LeftTriangle triangle;
    vec2 weights;
};
struct Sight {
    RayPair rays;
    PairHit hit;
    float closeness;
};
struct Sampler {
    uint key;
    uint salt;
    uint sample_;
    uint place;
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
struct SurfacePoint {
    Surface surface;
    vec3 geometric;
    vec3 shading;
};
struct Layers0_ {
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
struct Material {
    vec3 baseColor;
    float reflectivity;
    float specular;
    float exponent;
    float id;
    float spare;
};
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
const uint dielectric = 3u;
const uint conductor = 2u;

uniform highp sampler2D previousFirst;

uniform highp sampler2D previousSecond;

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

Layers0_ layersHere = Layers0_(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);

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

layout(location = 0) out vec4 _fs2p_location0;
layout(location = 1) out vec4 _fs2p_location1;

uint pcg(uint x) {
    uint s_7 = ((x * 747796405u) + 2891336453u);
    uint w_2 = (((s_7 >> ((s_7 >> 28u) + 4u)) ^ s_7) * 277803737u);
    return ((w_2 >> 22u) ^ w_2);
}

uint pixelHash(uvec2 pixel, uint sampleIndex, uint seed) {
    uint _e5 = pcg(seed);
    uint _e7 = pcg((sampleIndex + _e5));
    uint _e9 = pcg((pixel.y + _e7));
    uint _e11 = pcg((pixel.x + _e9));
    return _e11;
}

uint spread(uint x_1) {
    uint y_5 = ((x_1 | (x_1 * 4u)) & 51u);
    return ((y_5 | (y_5 * 2u)) & 85u);
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
    uint place_3 = (_e19 | (_e23 * 2u));
    uvec2 _e32 = reversed(uvec2((sampleIndex_1 & 65535u), (place_3 * 256u)));
    uvec2 digits = pick(independent, uvec2(0u), _e32);
    uint _e38 = mixBits((_e15 ^ 1779033703u));
    return Sampler(_e15, _e38, digits.x, digits.y);
}

float filterAxis(float u) {
    float across = ((2.0 * u) - 1.0);
    float x_12 = (16.0 - (16.0 * sqrt((1.0 - abs(across)))));
    float piece = min(floor(x_12), 15.0);
    float t_4 = (x_12 - piece);
    vec4 c_2 = frame.filterPieces[uint(piece)];
    float offset_3 = (c_2.x + (t_4 * (c_2.y + (t_4 * (c_2.z + (t_4 * c_2.w))))));
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
    uvec2 b_3 = (half_ ^ (half_ >> uvec2(16u)));
    uvec2 _e19 = scramble(uvec2(s.place), b_3);
    uvec2 own_1 = (s.sample_ * ((_e19 >> uvec2(7u)) & uvec2(4294967294u)));
    uvec2 _e31 = scramble((uvec2(s.sample_) ^ own_1), _e7);
    uvec2 _e35 = reversed((_e31 & uvec2(65535u)));
    uvec2 _e39 = shiftOfPlace((_e19 & uvec2(255u)));
    return Groups(_e35, _e39, ((_e7 >> uvec2(16u)) | (_e7 * 65536u)), ((b_3 >> uvec2(16u)) | (b_3 * 65536u)));
}

void skipGroup(inout Sampler s_1) {
    uint _e3 = s_1.key;
    s_1.key = (_e3 + 1u);
    return;
}

vec2 toUnit(uvec2 scrambled) {
    uvec2 _e4 = reversedHigh((scrambled & uvec2(65535u)));
    vec2 digits_1 = (vec2(ivec2(_e4)) * 4.656613e-10);
    return (digits_1 + (vec2((scrambled & uvec2(4278190080u))) * 3.5527137e-15));
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
    vec2 p_9 = ((2.0 * u_2) - vec2(1.0));
    bool wide = (abs(p_9.x) > abs(p_9.y));
    float radius_1 = pick(wide, p_9.x, p_9.y);
    float ratio = (pick(wide, p_9.y, p_9.x) / pick((radius_1 == 0.0), 1.0, radius_1));
    float angle = pick(wide, (0.7853982 * ratio), (1.5707964 - (0.7853982 * ratio)));
    return (radius_1 * vec2(cos(angle), sin(angle)));
}

CameraRay rayThroughLens(vec2 filmPosition, vec2 lensPoint) {
    CameraRay ray = CameraRay(vec3(0.0), vec3(0.0));
    float _e7 = frame.width;
    float x_13 = (((2.0 * filmPosition.x) / _e7) - 1.0);
    float _e16 = frame.height;
    float y_6 = (1.0 - ((2.0 * filmPosition.y) / _e16));
    vec3 _e22 = frame.right;
    vec3 _e26 = frame.up;
    vec3 across_1 = ((x_13 * _e22) + (y_6 * _e26));
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
            float longitude = (3.1415927 * x_13);
            float latitude = (1.5707964 * y_6);
            vec3 _e87 = frame.right;
            vec3 _e92 = frame.forward;
            vec3 level = ((sin(longitude) * _e87) + (cos(longitude) * _e92));
            vec3 _e102 = frame.up;
            ray = CameraRay(vec3(0.0), normalize(((cos(latitude) * level) + (sin(latitude) * _e102))));
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

RayPair oneRay(vec3 origin, vec3 direction, uint number) {
    return RayPair(origin, noShape, noTriangle, 0.0, true, direction, false, direction, false, -1.0, noShape, number);
}

uint numberOfNext(Sampler s_3) {
    uint _e8 = mixBits((((s_3.key + 1u) ^ s_3.salt) ^ 2246822507u));
    uint _e15 = mixBits((_e8 + ((s_3.sample_ << 8u) | s_3.place)));
    return _e15;
}

vec4 tableTexel(uint column, uint row) {
    vec4 _e5 = texelFetch(sceneTable, ivec2(uvec2(column, row)), 0);
    return _e5;
}

Bounds fetchBounds(uint i) {
    vec4 _e2 = tableTexel(0u, i);
    return Bounds(_e2.xyz, _e2.w);
}

float intersectSphere(vec3 origin_1, vec3 direction_1, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter = (center - origin_1);
    float along = dot(toCenter, direction_1);
    vec3 across_2 = (toCenter - (along * direction_1));
    float discriminant = ((radius * radius) - dot(across_2, across_2));
    float half_1 = sqrt(max(discriminant, 0.0));
    float near = (along - half_1);
    float far = (along + half_1);
    float t_5 = pick((near > tMin), near, far);
    return pick(startsInside, max(far, 0.0), pick(pick((discriminant >= 0.0), (t_5 > tMin), false), t_5, 1e30));
}

PairHit meet(PairHit found, RayPair p, uint i_1, vec2 t) {
    bool own_2 = (i_1 == p.shape);
    float pathT = pick(pick(own_2, !(p.inwards), false), 1e30, t.x);
    float lightT = pick(pick(pick(own_2, !(p.lightInwards), false), true, (i_1 == p.lightShape)), 1e30, t.y);
    bool nearer_1 = (pathT < found.t);
    return PairHit(pick(nearer_1, pathT, found.t), pick(nearer_1, i_1, found.shape), pick(found.blocked, true, (lightT < p.lightDistance)), noTriangle, vec2(0.0));
}

PairHit meetSphere(PairHit found_1, RayPair p_1, uint i_2) {
    Bounds _e3 = fetchBounds(i_2);
    bool own_3 = (i_2 == p_1.shape);
    float _e13 = intersectSphere(p_1.point, p_1.direction, _e3.center, _e3.radius, p_1.tMin, pick(own_3, p_1.inwards, false));
    float _e21 = intersectSphere(p_1.point, p_1.lightDirection, _e3.center, _e3.radius, p_1.tMin, pick(own_3, p_1.lightInwards, false));
    PairHit _e23 = meet(found_1, p_1, i_2, vec2(_e13, _e21));
    return _e23;
}

Extent fetchExtent(uint i_3) {
    vec4 _e2 = tableTexel(1u, i_3);
    vec4 _e4 = tableTexel(2u, i_3);
    return Extent(_e2.xyzw, _e4.xyzw);
}

vec3 rotate(vec4 q, vec3 v) {
    vec3 t_6 = (2.0 * cross(q.xyz, v));
    return ((v + (q.w * t_6)) + cross(q.xyz, t_6));
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

vec3 safeReciprocal(vec3 d, vec3 origin_2) {
    vec3 tiny = mix(vec3(1e-18), vec3(-1e-18), greaterThan(origin_2, vec3(0.0)));
    return (vec3(1.0) / mix(d, tiny, lessThan(abs(d), vec3(1e-18))));
}

Slabs boxSlabs(vec3 origin_3, vec3 direction_2, vec3 halfSize) {
    vec3 _e3 = safeReciprocal(direction_2, origin_3);
    vec3 middle = (-(origin_3) * _e3);
    vec3 reach = (halfSize * abs(_e3));
    vec3 enter = (middle - reach);
    vec3 leave = (middle + reach);
    return Slabs(enter, leave, max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}

float intersectBox(vec3 origin_4, vec3 direction_3, vec3 halfSize_1, float tMin_1, bool startsInside_1) {
    Slabs _e5 = boxSlabs(origin_4, direction_3, halfSize_1);
    float t_7 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_7 > tMin_1), false), t_7, 1e30));
}

PairHit meetBox(PairHit found_2, RayPair p_2, uint i_4) {
    Bounds _e3 = fetchBounds(i_4);
    Extent _e4 = fetchExtent(i_4);
    bool own_4 = (i_4 == p_2.shape);
    vec3 _e11 = turned(_e4.a, (p_2.point - _e3.center));
    vec3 _e14 = turned(_e4.a, p_2.direction);
    float _e20 = intersectBox(_e11, _e14, _e4.b.xyz, p_2.tMin, pick(own_4, p_2.inwards, false));
    vec3 _e23 = turned(_e4.a, p_2.lightDirection);
    float _e29 = intersectBox(_e11, _e23, _e4.b.xyz, p_2.tMin, pick(own_4, p_2.lightInwards, false));
    PairHit _e31 = meet(found_2, p_2, i_4, vec2(_e20, _e29));
    return _e31;
}

float intersectQuad(vec3 origin_5, vec3 direction_4, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_4 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_4, normal_4);
    vec3 toCenter_1 = (center_1 - origin_5);
    float t_8 = (dot(toCenter_1, normal_4) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_10 = ((t_8 * direction_4) - toCenter_1);
    bool within = (max(abs(dot(p_10, reciprocalU)), abs(dot(p_10, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_8 > tMin_2), (t_8 < 1e30), false), within, false), t_8, 1e30);
}

PairHit meetQuad(PairHit found_3, RayPair p_3, uint i_5) {
    Bounds _e3 = fetchBounds(i_5);
    Extent _e4 = fetchExtent(i_5);
    float _e13 = intersectQuad(p_3.point, p_3.direction, _e3.center, _e4.a.xyz, _e4.b.xyz, p_3.tMin);
    float _e22 = intersectQuad(p_3.point, p_3.lightDirection, _e3.center, _e4.a.xyz, _e4.b.xyz, p_3.tMin);
    PairHit _e24 = meet(found_3, p_3, i_5, vec2(_e13, _e22));
    return _e24;
}

float intersectPlane(vec3 origin_6, vec3 direction_5, vec3 normal, float offset_1, float tMin_3) {
    float speed_1 = dot(direction_5, normal);
    float t_9 = ((offset_1 - dot(origin_6, normal)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset_1 > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_9 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset_1 == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_9, 0.0), 1e30);
}

PairHit meetPlane(PairHit found_4, RayPair p_4, uint i_6) {
    Bounds _e3 = fetchBounds(i_6);
    float _e9 = intersectPlane(p_4.point, p_4.direction, _e3.center, _e3.radius, p_4.tMin);
    float _e15 = intersectPlane(p_4.point, p_4.lightDirection, _e3.center, _e3.radius, p_4.tMin);
    PairHit _e17 = meet(found_4, p_4, i_6, vec2(_e9, _e15));
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

SlabRay slabRay(vec3 origin_7, vec3 direction_6) {
    vec3 inverse_1 = (vec3(1.0) / mix(direction_6, vec3(1e-18), lessThan(abs(direction_6), vec3(1e-18))));
    return SlabRay(inverse_1, (-(origin_7) * inverse_1), (uvec3(0u, 1u, 2u) + (leastToGreatest * uvec3(lessThan(direction_6, vec3(0.0))))));
}

vec3 turnedTo(uint axis, vec3 v_2) {
    return pick((axis == 0u), v_2.yzx, pick((axis == 1u), v_2.zxy, v_2));
}

MeshRay meshRay(vec3 origin_8, vec3 direction_7) {
    vec3 size_1 = abs(direction_7);
    uint axis_1 = pick((size_1.z >= max(size_1.x, size_1.y)), 2u, pick((size_1.y > size_1.x), 1u, 0u));
    vec3 _e16 = turnedTo(axis_1, direction_7);
    return MeshRay(origin_8, axis_1, vec3((-(_e16.xy) / vec2(_e16.z)), (1.0 / _e16.z)));
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
    uvec3 far_1 = (uvec3(3u, 5u, 7u) - r.near);
    vec4 _e16 = planes((node + r.near.x), r.inverse_.x, r.offset.x);
    vec4 _e24 = planes((node + r.near.y), r.inverse_.y, r.offset.y);
    vec4 _e25 = larger(_e16, _e24);
    vec4 _e33 = planes((node + r.near.z), r.inverse_.z, r.offset.z);
    vec4 _e36 = larger(_e33, vec4(0.0));
    vec4 _e37 = larger(_e25, _e36);
    vec4 _e44 = planes((node + far_1.x), r.inverse_.x, r.offset.x);
    vec4 _e51 = planes((node + far_1.y), r.inverse_.y, r.offset.y);
    vec4 _e52 = smaller(_e44, _e51);
    vec4 _e59 = planes((node + far_1.z), r.inverse_.z, r.offset.z);
    vec4 _e60 = smaller(_e52, _e59);
    vec4 _e66 = smaller((_e60 * 1.000001), vec4(t_1));
    return mix(vec4(1e30), _e37, lessThanEqual(_e37, _e66));
}

float edge(vec2 a_2, vec2 b_2) {
    float p_11 = (a_2.x * b_2.y);
    float q_3 = (a_2.y * b_2.x);
    return ((a_2.x * b_2.y + -(q_3)) - (a_2.y * b_2.x + -(p_11)));
}

bool isWithin(float u_3, float v_3, float w_1) {
    return pick(pick(pick((u_3 >= 0.0), (v_3 >= 0.0), false), (w_1 >= 0.0), false), true, pick(pick((u_3 <= 0.0), (v_3 <= 0.0), false), (w_1 <= 0.0), false));
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
    float sum = ((_e35 + _e36) + _e37);
    float side = pick((sum < 0.0), -1.0, 1.0);
    bool _e45 = isWithin(_e35, _e36, _e37);
    float depth = ((ray_1.shear.z * side) * (((_e35 * _e6.z) + (_e36 * _e11.z)) + (_e37 * _e16.z)));
    return Crossing(pick(_e45, (sum != 0.0), false), (sum * side), depth, (vec2(_e36, _e37) * side), ((sum * ray_1.shear.z) > 0.0));
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
    vec3 share = vec3(((1.0 - weights.x) - weights.y), weights);
    if ((each != 0u)) {
        Vertex _e19 = fetchVertex(rows.x);
        Vertex _e24 = fetchVertex(rows.y);
        Vertex _e30 = fetchVertex(rows.z);
        c.uv = vec4((((share.x * _e19.uv) + (share.y * _e24.uv)) + (share.z * _e30.uv)), 0.0, 0.0);
    }
    if ((each > vertexRows)) {
        uvec3 more = (rows + uvec3(1u));
        VertexMore _e43 = fetchVertexMore(more.x);
        VertexMore _e45 = fetchVertexMore(more.y);
        VertexMore _e47 = fetchVertexMore(more.z);
        vec4 _e50 = c.uv;
        c.uv = vec4(_e50.xy, (((share.x * _e43.uv) + (share.y * _e45.uv)) + (share.z * _e47.uv)));
        vec2 _e66 = pairOf(_e43.blueAlpha);
        vec2 _e69 = pairOf(_e45.blueAlpha);
        vec2 _e72 = pairOf(_e47.blueAlpha);
        c.opacity = dot(share, vec3(_e66.y, _e69.y, _e72.y));
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

vec3 linearFromSrgb(vec3 c_1) {
    return mix(pow(((c_1 + vec3(0.055)) / vec3(1.055)), vec3(2.4)), (c_1 / vec3(12.92)), lessThanEqual(c_1, vec3(0.04045)));
}

vec4 decoded(uint texel, bool colored) {
    vec4 c_3 = (vec4(((uvec4(texel) >> uvec4(0u, 8u, 16u, 24u)) & uvec4(255u))) / vec4(255.0));
    vec3 _e18 = linearFromSrgb(c_3.xyz);
    return vec4(pick(colored, _e18, c_3.xyz), c_3.w);
}

uint texelAt(uint i_9) {
    uvec4 _e3 = texelRow((i_9 >> 2u));
    uvec2 pair = pick(((i_9 & 2u) != 0u), _e3.zw, _e3.xy);
    return pick(((i_9 & 1u) != 0u), pair.y, pair.x);
}

vec4 lookUp(TextureUse t_2, vec2 uv) {
    vec3 place_4 = vec3(uv, 1.0);
    const bool _e7 = hasOtherLookups;
    uint flags = pick(_e7, t_2.flags, 0u);
    bool nearest_1 = ((flags & isNearest) != 0u);
    Neighbours _e24 = neighbours(dot(t_2.toU, place_4), t_2.width, ((flags & clampsU) != 0u), ((flags & mirrorsU) != 0u), nearest_1);
    Neighbours _e36 = neighbours(dot(t_2.toV, place_4), t_2.height, ((flags & clampsV) != 0u), ((flags & mirrorsV) != 0u), nearest_1);
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

bool isThere(uint instance, uint place, vec2 weights_1, uint number_1) {
    float opacity = 0.0;
    uint _e6 = frame.instances;
    Instance _e10 = fetchInstance((_e6 + (instance * instanceRows)));
    Triangle _e15 = fetchTriangle((_e10.triangles + (place * triangleRows)));
    uint row_8 = (_e10.cover & coverRow);
    MaterialTextures _e19 = fetchMaterialTextures(row_8);
    Cover _e30 = coverAt((uvec3(_e10.vertices) + (uvec3(_e15.vertexA, _e15.vertexB, _e15.vertexC) * _e10.vertexRows)), _e10.vertexRows, weights_1);
    opacity = (_e19.opacity * _e30.opacity);
    if (((_e19.flags & hasOpacityTexture) != 0u)) {
        TextureUse _e42 = fetchTextureUse((row_8 + materialTexturesRows));
        float _e43 = opacity;
        vec4 _e54 = lookUp(_e42, pick(((_e42.flags & usesSecondSet) != 0u), _e30.uv.zw, _e30.uv.xy));
        opacity = (_e43 * _e54.w);
    }
    uint _e57 = pcg(number_1);
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
    uint waiting = noLeaf;
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
        if (pick(!(_e75), true, pick((_e77 == noLeaf), _e81, false))) {
            uint _e84 = current;
            bool toWorld = (_e84 >= beginning);
            uint _e87 = current;
            instance_1 = pick(toWorld, noInstance, (_e87 & placeMask));
            o = rays.origin;
            bool _e96 = toLight;
            d_1 = pick(_e96, rays.lightDirection, rays.direction);
            nodes = 0u;
            if (!(toWorld)) {
                uint _e103 = frame.instances;
                uint _e104 = instance_1;
                Instance _e108 = fetchInstance((_e103 + (_e104 * instanceRows)));
                vec3 _e109 = o;
                vec4 p_12 = vec4(_e109, 1.0);
                o = vec3(dot(_e108.toMeshX, p_12), dot(_e108.toMeshY, p_12), dot(_e108.toMeshZ, p_12));
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
                uint node_1 = (_e174 + (_e175 * nodeRows));
                uvec4 _e181 = geometryRow((node_1 + childrenRow));
                SlabRay _e182 = slabs;
                float _e183 = most;
                vec4 _e184 = enterChildren(node_1, _e182, _e183);
                ivec4 t_10 = floatBitsToInt(_e184);
                bool a_3 = (t_10.x < t_10.z);
                bool b_4 = (t_10.y < t_10.w);
                uvec2 r0_ = pick(a_3, uvec2(_e181.z, _e181.x), uvec2(_e181.x, _e181.z));
                uvec2 r1_ = pick(b_4, uvec2(_e181.w, _e181.y), uvec2(_e181.y, _e181.w));
                int far0_ = max(t_10.x, t_10.z);
                int far1_ = max(t_10.y, t_10.w);
                int near0_ = min(t_10.x, t_10.z);
                int near1_ = min(t_10.y, t_10.w);
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
            bool takes = pick((_e286 == noLeaf), (_e289 >= leaves), false);
            uint _e293 = waiting;
            uint _e294 = current;
            waiting = pick(takes, _e294, _e293);
            uint _e296 = current;
            current = pick(takes, unread, _e296);
            uint _e299 = waiting;
            if ((_e299 != noLeaf)) {
                uint _e302 = waiting;
                uint place_5 = (_e302 & placeMask);
                uint _e305 = waiting;
                waiting = ((_e305 + 1u) - 268435456u);
                uint _e310 = waiting;
                uint _e312 = waiting;
                waiting = pick((_e312 < leaves), noLeaf, _e310);
                MeshRay _e316 = ray_2;
                uint _e317 = triangles;
                Triangle _e321 = fetchTriangle((_e317 + (place_5 * triangleRows)));
                Crossing _e322 = crossTriangle(_e316, _e321);
                float _e331 = most;
                uint _e336 = own;
                nearer = pick(pick(pick(_e322.within, (_e322.depth > (rays.least * _e322.sum)), false), (_e322.depth < (_e331 * _e322.sum)), false), (place_5 != _e336), false);
                const bool _e341 = hasOneSided;
                if (_e341) {
                    bool _e342 = nearer;
                    uint _e344 = cover;
                    nearer = pick(_e342, pick(_e322.front, true, ((_e344 & isOneSided) == 0u)), false);
                }
                float inverse_2 = (1.0 / _e322.sum);
                float t_11 = (_e322.depth * inverse_2);
                vec2 weights_3 = (_e322.weights * inverse_2);
                const bool _e359 = hasCutouts;
                if (_e359) {
                    bool _e360 = nearer;
                    uint _e361 = cover;
                    if (pick(_e360, ((_e361 & coverRow) != 0u), false)) {
                        uint _e367 = instance_1;
                        doubted = MeshHit(t_11, _e367, place_5, weights_3, false);
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
                most = pick(_e379, t_11, _e378);
                float _e383 = found_5.t;
                found_5.t = pick(counts, t_11, _e383);
                uint _e387 = found_5.instance;
                uint _e388 = instance_1;
                found_5.instance = pick(counts, _e388, _e387);
                uint _e392 = found_5.triangle;
                found_5.triangle = pick(counts, place_5, _e392);
                vec2 _e396 = found_5.weights;
                found_5.weights = pick(counts, weights_3, _e396);
                bool _e400 = found_5.blocked;
                found_5.blocked = pick(_e400, true, blocks);
                uint _e402 = waiting;
                waiting = pick(blocks, noLeaf, _e402);
                uint _e405 = current;
                current = pick(blocks, ending, _e405);
            }
            uint _e408 = waiting;
            uint _e411 = current;
            bool _e412 = isAmongInstances(_e411);
            const bool _e415 = hasCutouts;
            uint _e417 = doubted.instance;
            if (pick(pick((_e408 == noLeaf), _e412, false), true, pick(_e415, (_e417 != noInstance), false))) {
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
        bool ended = pick((_e447 == ending), (_e450 == noLeaf), false);
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

PairHit meetMeshes(PairHit found_6, RayPair p_5) {
    PairHit result = PairHit(0.0, 0u, false, LeftTriangle(0u, 0u), vec2(0.0));
    float most_1 = pick(p_5.goesOn, found_6.t, -1.0);
    float lightMost = pick(found_6.blocked, -1.0, p_5.lightDistance);
    MeshHit _e17 = traverse(MeshRays(p_5.point, p_5.direction, p_5.lightDirection, p_5.tMin, most_1, lightMost, p_5.number), p_5.left);
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

PairHit tracePair(RayPair p_6) {
    PairHit found_7 = PairHit(1e30, 4294967295u, false, LeftTriangle(4294967295u, 0u), vec2(0.0));
    uint i_10 = 0u;
    uvec4 ends = frame.shapeEnds;
    const bool _e17 = hasSpheres;
    if (_e17) {
        uint _e18 = i_10;
        if ((_e18 < ends.x)) {
            while(true) {
                PairHit _e21 = found_7;
                uint _e22 = i_10;
                PairHit _e23 = meetSphere(_e21, p_6, _e22);
                found_7 = _e23;
                uint _e25 = i_10;
                i_10 = (_e25 + 1u);
                uint _e27 = i_10;
                if ((_e27 >= ends.x)) {
                    break;
                }
            }
        }
    }
    const bool _e31 = hasBoxes;
    if (_e31) {
        uint _e32 = i_10;
        if ((_e32 < ends.y)) {
            while(true) {
                PairHit _e35 = found_7;
                uint _e36 = i_10;
                PairHit _e37 = meetBox(_e35, p_6, _e36);
                found_7 = _e37;
                uint _e39 = i_10;
                i_10 = (_e39 + 1u);
                uint _e41 = i_10;
                if ((_e41 >= ends.y)) {
                    break;
                }
            }
        }
    }
    const bool _e45 = hasQuads;
    if (_e45) {
        uint _e46 = i_10;
        if ((_e46 < ends.z)) {
            while(true) {
                PairHit _e49 = found_7;
                uint _e50 = i_10;
                PairHit _e51 = meetQuad(_e49, p_6, _e50);
                found_7 = _e51;
                uint _e53 = i_10;
                i_10 = (_e53 + 1u);
                uint _e55 = i_10;
                if ((_e55 >= ends.z)) {
                    break;
                }
            }
        }
    }
    const bool _e59 = hasPlanes;
    if (_e59) {
        uint _e60 = i_10;
        if ((_e60 < ends.w)) {
            while(true) {
                PairHit _e63 = found_7;
                uint _e64 = i_10;
                PairHit _e65 = meetPlane(_e63, p_6, _e64);
                found_7 = _e65;
                uint _e67 = i_10;
                i_10 = (_e67 + 1u);
                uint _e69 = i_10;
                if ((_e69 >= ends.w)) {
                    break;
                }
            }
        }
    }
    const bool _e73 = hasMeshes;
    if (_e73) {
        PairHit _e74 = found_7;
        PairHit _e75 = meetMeshes(_e74, p_6);
        found_7 = _e75;
    }
    PairHit _e76 = found_7;
    return _e76;
}

Sight look(uvec2 pixel_2) {
    Sampler s_4 = Sampler(0u, 0u, 0u, 0u);
    uint _e3 = frame.sampleIndex;
    uint _e6 = frame.seed;
    Sampler _e7 = startSampler(pixel_2, _e3, _e6);
    s_4 = _e7;
    vec2 _e12 = frame.jitter;
    vec2 _e14 = next2d(s_4);
    vec2 _e15 = filterOffset(_e14);
    vec2 filmPosition_2 = ((vec2(pixel_2) + _e12) + _e15);
    vec2 _e17 = next2d(s_4);
    CameraRay _e18 = cameraRay(filmPosition_2, _e17);
    Sampler _e21 = s_4;
    uint _e22 = numberOfNext(_e21);
    RayPair _e23 = oneRay(_e18.origin, _e18.direction, _e22);
    vec2 offCentre = ((filmPosition_2 - vec2(pixel_2)) - vec2(0.5));
    PairHit _e29 = tracePair(_e23);
    return Sight(_e23, _e29, (1.0 / (1.0 + dot(offCentre, offCentre))));
}

bool isPlane(uint i_11) {
    uint _e4 = frame.shapeEnds.z;
    uint _e9 = frame.shapeEnds.w;
    return pick((i_11 >= _e4), (i_11 < _e9), false);
}

vec3 boxNormal(vec3 origin_9, vec3 direction_8, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_9, direction_8, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_12 = pick(entering, _e5.near, _e5.far);
    vec3 side_1 = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_8, vec3(0.0))));
    bool onX = (crossed.x == t_12);
    bool onY = pick(!(onX), (crossed.y == t_12), false);
    return (side_1 * mix(vec3(0.0), vec3(1.0), bvec3(onX, onY, !(pick(onX, true, onY)))));
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

vec3 normalAt(RayPair p_7, float t_3, uint i_14) {
    vec3 normal_1 = vec3(0.0);
    Bounds _e3 = fetchBounds(i_14);
    vec3 origin_10 = (p_7.point - _e3.center);
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
        bool inside_1 = pick((i_14 == p_7.shape), p_7.inwards, false);
        vec3 _e28 = turned(_e22.a, origin_10);
        vec3 _e31 = turned(_e22.a, p_7.direction);
        vec3 _e35 = boxNormal(_e28, _e31, _e22.b.xyz, p_7.tMin, inside_1);
        vec3 _e36 = normal_1;
        vec3 _e38 = turnedBack(_e22.a, _e35);
        bool _e39 = isBox(i_14);
        normal_1 = pick(_e39, _e38, _e36);
    }
    const bool _e42 = hasSpheres;
    if (_e42) {
        vec3 outwards = (origin_10 + (t_3 * p_7.direction));
        vec3 _e46 = normal_1;
        bool _e53 = isSphere(i_14);
        normal_1 = pick(_e53, pick((dot(outwards, outwards) == 0.0), -(p_7.direction), outwards), _e46);
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

Layers0_ fetchLayers(uint i_16) {
    vec4 _e2 = tableTexel(0u, i_16);
    vec4 _e4 = tableTexel(1u, i_16);
    vec4 _e6 = tableTexel(2u, i_16);
    vec4 _e8 = tableTexel(3u, i_16);
    vec4 _e10 = tableTexel(4u, i_16);
    vec4 _e12 = tableTexel(5u, i_16);
    vec4 _e14 = tableTexel(6u, i_16);
    return Layers0_(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xy, _e8.z, _e8.w, _e10.x, _e10.y, _e10.z, _e10.w, _e12.x, _e12.y, _e12.z, _e12.w, _e14.x, _e14.y, _e14.z, _e14.w);
}

Layers0_ layersOf(uint code_3, float eta) {
    Layers0_ l = Layers0_(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    l.specularColor = vec3(1.0);
    l.specularWeight = 1.0;
    l.ior = 1.5;
    bool _e10 = isLayered(code_3);
    if (pick(_e10, (eta != 0.0), false)) {
        Layers0_ _e16 = fetchLayers(uint(abs(eta)));
        l = _e16;
    }
    Layers0_ _e17 = l;
    return _e17;
}

vec3 fromOctahedral(uint code_4) {
    vec2 p_13 = ((vec2(float((code_4 & 65535u)), float((code_4 >> 16u))) * 3.051851e-5) - vec2(1.0));
    float z = ((1.0 - abs(p_13.x)) - abs(p_13.y));
    vec2 folded = ((vec2(1.0) - abs(p_13.yx)) * mix(vec2(1.0), vec2(-1.0), lessThan(p_13, vec2(0.0))));
    return normalize(vec3(pick((z < 0.0), folded, p_13), z));
}

MeshPoint meshPoint(uint instance_3, uint place_1, vec2 weights_2) {
    MeshPoint p_8 = MeshPoint(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec4(0.0), vec4(0.0));
    uint _e5 = frame.instances;
    Instance _e9 = fetchInstance((_e5 + (instance_3 * instanceRows)));
    Triangle _e14 = fetchTriangle((_e9.triangles + (place_1 * triangleRows)));
    mat3x3 turn = mat3x3(_e9.toMeshX.xyz, _e9.toMeshY.xyz, _e9.toMeshZ.xyz);
    vec3 geometric_2 = normalize((turn * cross((_e14.b - _e14.a), (_e14.c - _e14.a))));
    p_8 = MeshPoint(geometric_2, geometric_2, vec3(0.0), vec3(0.0), geometric_2, vec4(0.0), vec4(1.0));
    if ((_e9.vertexRows != 0u)) {
        uvec3 rows_1 = (uvec3(_e9.vertices) + (uvec3(_e14.vertexA, _e14.vertexB, _e14.vertexC) * _e9.vertexRows));
        Vertex _e54 = fetchVertex(rows_1.x);
        Vertex _e56 = fetchVertex(rows_1.y);
        Vertex _e58 = fetchVertex(rows_1.z);
        vec3 share_1 = vec3(((1.0 - weights_2.x) - weights_2.y), weights_2);
        vec3 _e67 = fromOctahedral(_e54.normal);
        vec3 _e71 = fromOctahedral(_e56.normal);
        vec3 _e76 = fromOctahedral(_e58.normal);
        vec3 normal_5 = (((share_1.x * _e67) + (share_1.y * _e71)) + (share_1.z * _e76));
        vec3 smoothed = (turn * normal_5);
        float size_2 = dot(smoothed, smoothed);
        float side_2 = pick((dot(smoothed, geometric_2) < 0.0), -1.0, 1.0);
        bool useful = pick(((_e9.vertexFlags & hasNormals) != 0u), (size_2 > 0.0), false);
        p_8.shading = pick(useful, (smoothed * (side_2 * inversesqrt(max(size_2, 1e-37)))), geometric_2);
        const bool _e103 = hasTextures;
        if (_e103) {
            p_8.uv = vec4((((share_1.x * _e54.uv) + (share_1.y * _e56.uv)) + (share_1.z * _e58.uv)), 0.0, 0.0);
            const bool _e120 = hasVertexMore;
            if (_e120) {
                if ((_e9.vertexRows > vertexRows)) {
                    VertexMore _e127 = fetchVertexMore((rows_1.x + vertexRows));
                    VertexMore _e131 = fetchVertexMore((rows_1.y + vertexRows));
                    VertexMore _e135 = fetchVertexMore((rows_1.z + vertexRows));
                    vec4 _e138 = p_8.uv;
                    p_8.uv = vec4(_e138.xy, (((share_1.x * _e127.uv) + (share_1.y * _e131.uv)) + (share_1.z * _e135.uv)));
                    vec2 _e154 = pairOf(_e127.redGreen);
                    vec2 _e158 = pairOf(_e131.redGreen);
                    vec2 _e163 = pairOf(_e135.redGreen);
                    vec2 redGreen = (((share_1.x * _e154) + (share_1.y * _e158)) + (share_1.z * _e163));
                    vec2 _e168 = pairOf(_e127.blueAlpha);
                    vec2 _e172 = pairOf(_e131.blueAlpha);
                    vec2 _e177 = pairOf(_e135.blueAlpha);
                    vec2 blueAlpha = (((share_1.x * _e168) + (share_1.y * _e172)) + (share_1.z * _e177));
                    p_8.color = clamp(vec4(redGreen, blueAlpha), vec4(0.0), vec4(1.0));
                }
            }
            const bool _e188 = hasNormalMaps;
            if (_e188) {
                if (pick(useful, ((_e9.vertexFlags & hasTangents) != 0u), false)) {
                    vec3 _e197 = fromOctahedral(_e54.tangent);
                    vec3 _e201 = fromOctahedral(_e56.tangent);
                    vec3 _e206 = fromOctahedral(_e58.tangent);
                    vec3 tangent_2 = (((share_1.x * _e197) + (share_1.y * _e201)) + (share_1.z * _e206));
                    float hand = pick(((_e54.tangent & 65536u) != 0u), -1.0, 1.0);
                    p_8.normal = (smoothed * side_2);
                    p_8.tangent = ((turn * tangent_2) * side_2);
                    p_8.bitangent = ((turn * cross(normal_5, tangent_2)) * (hand * side_2));
                }
            }
        }
    }
    MeshPoint _e227 = p_8;
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
        float thickness = mix(_e105, _e108, texel_1.y);
        float _e115 = layersHere.filmThickness;
        layersHere.filmThickness = pick((slot == filmThicknessSlot), thickness, _e115);
    }
    const bool _e120 = hasGrain;
    if (_e120) {
        bool isGrain = (slot == anisotropySlot);
        float _e125 = layersHere.anisotropy;
        layersHere.anisotropy = (_e125 * pick(isGrain, texel_1.z, 1.0));
        vec2 given = ((2.0 * texel_1.xy) - vec2(1.0));
        float size_3 = dot(given, given);
        vec2 d_2 = pick((size_3 > 1e-6), (given * inversesqrt(max(size_3, 1e-20))), vec2(1.0, 0.0));
        vec2 own_5 = layersHere.grain;
        layersHere.grain = pick(isGrain, vec2(((own_5.x * d_2.x) - (own_5.y * d_2.y)), ((own_5.y * d_2.x) + (own_5.x * d_2.y))), own_5);
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
    uint row_9 = uint(_e4);
    MaterialTextures _e6 = fetchMaterialTextures(row_9);
    bool unlit = ((_e6.flags & isUnlit) != 0u);
    vec3 _e13 = s_5.baseColor;
    s_5.baseColor = (_e13 * color);
    vec3 _e16 = s_5.emission;
    s_5.emission = (_e16 * pick(unlit, color, vec3(1.0)));
    if ((_e6.count > 0u)) {
        while(true) {
            uint _e38 = i_17;
            TextureUse _e42 = fetchTextureUse(((row_9 + materialTexturesRows) + (_e38 * textureUseRows)));
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
            vec2 share_2 = pick((_e42.slot == metallicRoughnessSlot), _e56.yz, vec2(1.0));
            float _e85 = s_5.alpha;
            float rough = max(((_e85 * share_2.x) * share_2.x), 0.001);
            float _e94 = s_5.alpha;
            float _e96 = s_5.code;
            bool _e98 = isSmooth(uint(_e96));
            s_5.alpha = pick(_e98, _e94, rough);
            float _e101 = s_5.metallic;
            s_5.metallic = (_e101 * share_2.y);
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
    vec3 x_14 = (across_3 * inversesqrt(max(dot(across_3, across_3), 1e-20)));
    float ox = dot(o_1, x_14);
    float a_4 = max(((ox * ox) + (oz * oz)), 1e-20);
    float b_5 = (2.0 * (a_4 + (oz * least)));
    float c_4 = ((least + oz) * (least + oz));
    float root = sqrt(max(((b_5 * b_5) - ((4.0 * a_4) * c_4)), 0.0));
    float z2_ = clamp(((0.25 * pick((ox < 0.0), (b_5 + root), (b_5 - root))) / a_4), 0.0, 1.0);
    vec3 raised = ((sqrt((1.0 - z2_)) * x_14) + (sqrt(z2_) * g_2));
    vec3 reflected = (((2.0 * dot(n, o_1)) * n) - o_1);
    return pick((dot(g_2, reflected) >= least), n, raised);
}

vec3 validNormal(vec3 geometric, vec3 direction_9, vec3 mapped, vec3 otherwise) {
    float size_4 = dot(mapped, mapped);
    vec3 n_1 = pick((size_4 > 0.0), (mapped * inversesqrt(max(size_4, 1e-37))), otherwise);
    float side_3 = pick((dot(geometric, direction_9) > 0.0), -1.0, 1.0);
    vec3 _e21 = bent((side_3 * geometric), -(direction_9), (side_3 * n_1));
    return (side_3 * _e21);
}

bool isDielectric(uint code_6) {
    const bool _e2 = hasGlass;
    uint _e3 = kindOf(code_6);
    return pick(_e2, (_e3 == dielectric), false);
}

bool letsThrough(uint code_7, float eta_1) {
    bool _e2 = isDielectric(code_7);
    const bool _e4 = hasTransmission;
    bool _e5 = isLayered(code_7);
    return pick(_e2, true, pick(pick(_e4, _e5, false), (eta_1 < 0.0), false));
}

vec3 agreed(vec3 geometric_1, vec3 shading, vec3 direction_10, bool isClear) {
    bool agree = ((dot(geometric_1, direction_10) > 0.0) == (dot(shading, direction_10) > 0.0));
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
    bool own_6 = (size_5 > (1e-12 * dot(tangent, tangent)));
    vec3 _e12 = tangentAbout(normal_3);
    vec3 t_13 = pick(own_6, (along_1 * inversesqrt(max(size_5, 1e-37))), _e12);
    vec3 across_4 = cross(normal_3, t_13);
    float hand_1 = pick(pick(own_6, (dot(across_4, bitangent) < 0.0), false), -1.0, 1.0);
    return ((grain.x * t_13) + ((grain.y * hand_1) * across_4));
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
        Layers0_ _e16 = layersOf(uint(_e11), _e15);
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

vec3 conductorFresnel(float cosine, vec3 eta_2, vec3 k) {
    float cosine2_ = (cosine * cosine);
    float sine2_ = (1.0 - cosine2_);
    vec3 difference = (((eta_2 * eta_2) - (k * k)) - vec3(sine2_));
    vec3 a2PlusB2_ = sqrt(((difference * difference) + ((((4.0 * eta_2) * eta_2) * k) * k)));
    vec3 larger_1 = sqrt(((0.5 * (a2PlusB2_ + abs(difference))) + vec3(1e-20)));
    vec3 smaller_1 = ((eta_2 * k) / larger_1);
    vec3 a_5 = mix(smaller_1, larger_1, greaterThan(difference, vec3(0.0)));
    vec3 b_6 = mix(larger_1, smaller_1, greaterThan(difference, vec3(0.0)));
    vec3 b2_ = ((b_6 * b_6) + vec3(1e-20));
    vec3 acrossFar = (a_5 + vec3(cosine));
    vec3 acrossNear = (a_5 - vec3(cosine));
    vec3 across_5 = (((acrossNear * acrossNear) + b2_) / ((acrossFar * acrossFar) + b2_));
    vec3 alongFar = ((a_5 * cosine) + vec3(sine2_));
    vec3 alongNear = ((a_5 * cosine) - vec3(sine2_));
    vec3 b2cosine2_ = ((b2_ * cosine2_) + vec3(1e-20));
    return ((0.5 * across_5) * (vec3(1.0) + (((alongNear * alongNear) + b2cosine2_) / ((alongFar * alongFar) + b2cosine2_))));
}

vec3 conductorReflectance(vec3 baseColor, vec3 eta_3, vec3 k_1, float cosine_1) {
    float constants = dot((eta_3 + k_1), vec3(1.0));
    vec3 _e8 = conductorFresnel(cosine_1, eta_3, k_1);
    return pick((constants > 0.0), _e8, baseColor);
}

vec3 albedoOf(Surface s_6, bool fromBack) {
    vec3 albedo = vec3(0.0);
    uint _e4 = kindOf(uint(s_6.code));
    albedo = s_6.baseColor;
    if ((_e4 == conductor)) {
        vec3 _e13 = conductorReflectance(s_6.baseColor, s_6.eta, s_6.k, 1.0);
        albedo = _e13;
    }
    if ((_e4 == dielectric)) {
        albedo = vec3(1.0);
    }
    vec3 _e18 = albedo;
    albedo = mix(_e18, vec3(1.0), s_6.reflectivity);
    bool dark = pick(((uint(s_6.code) & 16u) != 0u), fromBack, false);
    vec3 emission = pick(dark, vec3(0.0), s_6.emission);
    float brightest = max(max(emission.x, emission.y), max(emission.z, 1.0));
    vec3 _e41 = albedo;
    return clamp((_e41 + (emission / vec3(brightest))), vec3(0.0), vec3(1.0));
}

Material fetchMaterial(uint i_18) {
    vec4 _e2 = tableTexel(3u, i_18);
    vec4 _e4 = tableTexel(4u, i_18);
    return Material(_e2.xyz, _e2.w, _e4.x, _e4.y, _e4.z, _e4.w);
}

void main() {
    vec4 fragment = gl_FragCoord;
    Layers sums = Layers(vec4(0.0), vec4(0.0));
    uvec2 texel_2 = uvec2(fragment.xy);
    uvec2 _e5 = frame.origin;
    Sight _e7 = look((_e5 + texel_2));
    uint _e16 = frame.sampleIndex;
    if ((_e16 > 0u)) {
        vec4 _e21 = texelFetch(previousFirst, ivec2(texel_2), 0);
        vec4 _e24 = texelFetch(previousSecond, ivec2(texel_2), 0);
        sums = Layers(_e21, _e24);
    }
    float _e28 = sums.first.w;
    sums.first.w = (_e28 + 1.0);
    uint shape_1 = _e7.hit.shape;
    if ((shape_1 != noShape)) {
        SurfacePoint _e37 = surfaceAt(_e7.rays, _e7.hit, shape_1);
        vec3 direction_11 = _e7.rays.direction;
        vec4 _e41 = sums.first;
        vec3 _e47 = albedoOf(_e37.surface, (dot(_e37.geometric, direction_11) > 0.0));
        sums.first = (_e41 + vec4(_e47, 0.0));
        vec4 _e52 = sums.second;
        sums.second = (_e52 + vec4(pick((dot(_e37.shading, direction_11) > 0.0), -(_e37.shading), _e37.shading), 1.0));
    }
    Layers _e64 = sums;
    _fs2p_location0 = _e64.first;
    _fs2p_location1 = _e64.second;
    return;
}

