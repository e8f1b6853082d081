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
struct Odds {
    float total;
    float tree;
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
struct EmitterChoice {
    uint index;
    float probability;
    Odds odds;
};
struct LightSample {
    vec3 direction;
    float distance_;
    vec3 radiance;
    float pdf;
    bool delta;
};
struct SphereView {
    vec3 toCenter;
    float distance_;
    float power;
    bool inside;
    float width;
};
struct ConeDirection {
    vec3 direction;
    float cosine;
    float sine2_;
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
struct ChosenTriangle {
    uint place;
    float density;
    vec2 u;
};
struct LampTriangle {
    float own;
    uint place;
    uint other;
    float density;
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
struct MaterialTextures {
    uint count;
    uint flags;
    float opacity;
    float cutoff;
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
struct Bounds {
    vec3 center;
    float radius;
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
struct Crossing {
    bool within;
    float sum;
    float depth;
    vec2 weights;
    bool front;
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
struct Start {
    vec3 point;
    uint leaves;
    uint inside;
    float tMin;
};
struct Ray {
    Start start;
    vec3 direction;
};
struct FarLight {
    vec3 radiance;
    float pdf;
};
const uint directionAndPdf = 0u;
const uint radianceAndDistance = 1u;
const uint pdfOfSample = 2u;
const uint choice_2 = 4u;
const uint instanceRows = 5u;
const uint triangleRows = 3u;
const uint vertexRows = 1u;
const uint hasOpacityTexture = 2u;
const uint materialTexturesRows = 1u;
const uint textureUseRows = 3u;
const uint isNearest = 4u;
const uint clampsU = 8u;
const uint mirrorsU = 16u;
const uint clampsV = 32u;
const uint mirrorsV = 64u;
const uint isColor = 2u;
const uint usesSecondSet = 1u;
const uint emissionSlot = 1u;
const uint coverRow = 2147483647u;
const EnvironmentLight white = EnvironmentLight(vec3(1.0), 0.07957747);
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
const uint leaving = 2415919102u;
const uint leastToGreatest = 3u;
const uint nodeRows = 7u;
const uint childrenRow = 6u;
const int notEntered = 1900671690;
const uint countShift = 28u;
const uint isOneSided = 2147483648u;
const uint hasNormals = 1u;
const uint hasTangents = 2u;

uniform highp sampler2D questions;

layout(std140) uniform FrameBlock { Frame frame; };

const bool hasManyLights = true;

const bool hasQuadLights = false;

const bool hasSuns = false;

const bool hasMeshLamps = false;

const bool hasPointLights = false;

const bool hasSky = true;

const bool hasLightTree = false;

uniform highp sampler2D sceneTable;

const bool hasSphereLights = true;

const bool hasBoxLights = false;

uniform highp usampler2D geometry;

const bool hasVariedLamps = false;

uniform highp usampler2D texels;

const bool hasOtherLookups = false;

const bool hasEnvironment = false;

uniform highp sampler2D environment;

const bool hasSpheres = true;

const bool hasBoxes = true;

const bool hasTurnedBoxes = true;

const bool hasQuads = false;

const bool hasPlanes = true;

const bool hasMeshes = false;

uint stack[64] = uint[64](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);

const bool hasCutouts = false;

const bool hasOneSided = false;

const bool hasTextures = false;

const bool hasVertexMore = false;

const bool hasNormalMaps = false;

layout(location = 0) out vec4 _fs2p_location0;

float cosineTowards(Emitter e, vec3 toLight, float grown, vec3 normal_1) {
    float above = clamp(((dot(normal_1, toLight) + e.reach) / grown), 0.0, 1.0);
    return pick((dot(normal_1, normal_1) == 0.0), 1.0, above);
}

float spotFalloff(Emitter e_1, vec3 toLight_1) {
    float share_1 = clamp(((-(dot(toLight_1, e_1.u)) - e_1.radius) / (e_1.cosInner - e_1.radius)), 0.0, 1.0);
    return (share_1 * share_1);
}

float estimatedIrradiance(Emitter e_2, vec3 point, vec3 normal_2) {
    float estimate = 0.0;
    const bool _e4 = hasQuadLights;
    bool isQuad = pick(_e4, (e_2.kind == 1.0), false);
    const bool _e10 = hasSuns;
    bool isFar = pick(_e10, (e_2.kind == 5.0), false);
    vec3 middle = (e_2.position + pick(isQuad, (0.5 * (e_2.u + e_2.v)), vec3(0.0)));
    vec3 toLight_3 = pick(isFar, -(e_2.u), (middle - point));
    float distance2_ = dot(toLight_3, toLight_3);
    float distance_6 = sqrt(distance2_);
    float grown_1 = max((distance_6 + e_2.reach), 1e-15);
    float _e35 = cosineTowards(e_2, toLight_3, grown_1, normal_2);
    float square = pick(isQuad, (distance2_ + (e_2.area / 3.1415927)), max(distance2_, (e_2.area / 12.566371)));
    estimate = ((e_2.power * _e35) / pick(isFar, 1.0, max(square, 1e-15)));
    const bool _e54 = hasQuadLights;
    if (_e54) {
        float height_1 = (-(dot(cross(e_2.u, e_2.v), toLight_3)) / max(e_2.area, 1e-30));
        float side = pick((e_2.oneSided == 1.0), max(height_1, 0.0), abs(height_1));
        float lampCosine = pick((side > 0.0), ((side + e_2.reach) / grown_1), 0.0);
        float _e78 = estimate;
        estimate = (_e78 * pick(isQuad, lampCosine, 1.0));
    }
    const bool _e83 = hasMeshLamps;
    if (_e83) {
        float alike = length(e_2.v);
        float across = -(dot(e_2.v, toLight_3));
        float side_1 = pick((e_2.oneSided == 1.0), max(across, 0.0), abs(across));
        float shown = ((0.25 * (1.0 - alike)) + ((side_1 + (alike * e_2.reach)) / grown_1));
        float sizeOfMesh = (distance2_ + ((e_2.area * (1.0 + (3.0 * alike))) / 12.566371));
        float _e114 = estimate;
        estimate = pick((e_2.kind == 7.0), (((e_2.power * _e35) * shown) / max(sizeOfMesh, 1e-15)), _e114);
    }
    const bool _e126 = hasPointLights;
    if (_e126) {
        float _e127 = estimate;
        float _e132 = spotFalloff(e_2, (toLight_3 / vec3(max(distance_6, 1e-15))));
        estimate = (_e127 * pick((e_2.kind == 4.0), _e132, 1.0));
    }
    const bool _e140 = hasSky;
    if (_e140) {
        float _e141 = estimate;
        estimate = pick((e_2.kind == 6.0), e_2.power, _e141);
    }
    float _e147 = estimate;
    return _e147;
}

float listedProbability(Emitter e_3, vec3 point_1, vec3 normal_3, Odds odds) {
    float probability = 0.0;
    uint _e6 = frame.emitterCount;
    probability = float(min(_e6, 1u));
    const bool _e12 = hasManyLights;
    if (_e12) {
        uint _e15 = frame.emitterCount;
        if ((_e15 > 1u)) {
            float _e18 = estimatedIrradiance(e_3, point_1, normal_3);
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

vec4 tableTexel(uint column, uint row) {
    vec4 _e5 = texelFetch(sceneTable, ivec2(uvec2(column, row)), 0);
    return _e5;
}

LightNode fetchLightNode(uint i) {
    vec4 _e2 = tableTexel(0u, i);
    vec4 _e4 = tableTexel(1u, i);
    vec4 _e6 = tableTexel(2u, i);
    vec4 _e8 = tableTexel(3u, i);
    vec4 _e10 = tableTexel(4u, i);
    vec4 _e12 = tableTexel(5u, i);
    vec4 _e14 = tableTexel(6u, i);
    vec4 _e16 = tableTexel(7u, i);
    vec4 _e18 = tableTexel(8u, i);
    vec4 _e20 = tableTexel(9u, i);
    vec4 _e22 = tableTexel(10u, i);
    vec4 _e24 = tableTexel(11u, i);
    return LightNode(_e2.xyzw, _e4.xyzw, _e6.xyzw, _e8.xyzw, _e10.xyzw, _e12.xyzw, _e14.xyzw, _e16.xyzw, _e18.xyzw, _e20.xyzw, _e22.xyzw, _e24.xyzw);
}

vec4 sineOf(vec4 cosine) {
    return sqrt(max((vec4(1.0) - (cosine * cosine)), vec4(0.0)));
}

vec4 cosineLess(vec4 cosA, vec4 sinA, vec4 cosB, vec4 sinB) {
    return mix(((cosA * cosB) + (sinA * sinB)), vec4(1.0), greaterThan(cosA, cosB));
}

vec4 estimatesOfChildren(LightNode n, vec3 point_2, vec3 normal_4) {
    vec4 x_8 = (n.x - vec4(point_2.x));
    vec4 y_3 = (n.y - vec4(point_2.y));
    vec4 z = (n.z - vec4(point_2.z));
    vec4 distance2_1 = (((x_8 * x_8) + (y_3 * y_3)) + (z * z));
    vec4 inverse_1 = inversesqrt(max(distance2_1, vec4(1e-30)));
    bvec4 inside = lessThanEqual(distance2_1, (n.reach * n.reach));
    vec4 sinB_1 = min((n.reach * inverse_1), vec4(1.0));
    vec4 _e33 = sineOf(sinB_1);
    vec4 cosB_1 = mix(_e33, vec4(-1.0), inside);
    vec4 along = (-((((n.axisX * x_8) + (n.axisY * y_3)) + (n.axisZ * z))) * inverse_1);
    vec4 cosW = clamp(mix(along, abs(along), greaterThan(n.bothSides, vec4(0.5))), vec4(-1.0), vec4(1.0));
    vec4 _e58 = sineOf(cosW);
    vec4 _e60 = sineOf(n.cosWidth);
    vec4 _e62 = cosineLess(cosW, _e58, n.cosWidth, _e60);
    vec4 _e63 = sineOf(_e62);
    vec4 _e64 = cosineLess(_e62, _e63, cosB_1, sinB_1);
    vec4 cosOut = mix(_e64, vec4(1.0), inside);
    vec4 cosN = clamp(((((normal_4.x * x_8) + (normal_4.y * y_3)) + (normal_4.z * z)) * inverse_1), vec4(-1.0), vec4(1.0));
    vec4 _e82 = sineOf(cosN);
    vec4 _e83 = cosineLess(cosN, _e82, cosB_1, sinB_1);
    vec4 above_1 = mix(max(_e83, vec4(0.0)), vec4(1.0), inside);
    vec4 cosIn = pick((dot(normal_4, normal_4) == 0.0), vec4(1.0), above_1);
    vec4 estimate_1 = (((n.power * cosOut) * cosIn) / max(max(distance2_1, (n.reach * n.reach)), vec4(1e-15)));
    return mix(vec4(0.0), min(estimate_1, vec4(1e30)), greaterThan(cosOut, n.cosEdge));
}

float shareOfTree(float total, float far) {
    float share_2 = (0.25 + ((0.5 * total) / max((total + far), 1e-37)));
    return pick((total <= 0.0), 0.0, pick((far <= 0.0), 1.0, share_2));
}

TreeChoice descend(vec3 point_3, vec3 normal_5, float u, int leaf, float far_1) {
    uint level = 0u;
    uint node = 0u;
    float rest = 0.0;
    TreeChoice choice = TreeChoice(0u, 1.0, 0.0, true);
    uint _e7 = frame.lightTreeDepth;
    level = _e7;
    rest = u;
    while(true) {
        uint _e19 = level;
        level = (_e19 - 1u);
        uint _e23 = frame.lightTree;
        uint _e24 = node;
        LightNode _e26 = fetchLightNode((_e23 + _e24));
        vec4 _e27 = estimatesOfChildren(_e26, point_3, normal_5);
        float two = (_e27.x + _e27.y);
        float three = (two + _e27.z);
        float total_2 = (three + _e27.w);
        uint _e35 = node;
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
        float at_1 = (_e53 * total_2);
        uint byChance = ((uint((at_1 >= _e27.x)) + uint((at_1 >= two))) + uint((at_1 >= three)));
        uint _e68 = level;
        uint child = pick((leaf < 0), byChance, ((uint(max(leaf, 0)) >> (2u * _e68)) & 3u));
        bool low_1 = (child < 2u);
        bool odd = ((child & 1u) == 1u);
        float own_1 = pick(low_1, pick(odd, _e27.y, _e27.x), pick(odd, _e27.w, _e27.z));
        float before = pick(low_1, pick(odd, _e27.x, 0.0), pick(odd, three, two));
        float _e95 = choice.probability;
        choice.probability = (_e95 * (own_1 / max(total_2, 1e-37)));
        choice.emitter = uint(pick(low_1, pick(odd, _e26.emitters.y, _e26.emitters.x), pick(odd, _e26.emitters.w, _e26.emitters.z)));
        rest = clamp(((at_1 - before) / max(own_1, 1e-37)), 0.0, 0.99999994);
        uint _e121 = node;
        node = (((4u * _e121) + 1u) + child);
        uint _e126 = level;
        if ((_e126 == 0u)) {
            break;
        }
    }
    TreeChoice _e129 = choice;
    return _e129;
}

float treeProbability(Emitter e_4, vec3 point_4, vec3 normal_6, Odds odds_1) {
    float probability_1 = 0.0;
    uint _e8 = frame.lightTreeDepth;
    if ((_e8 > 0u)) {
        TreeChoice _e17 = descend(point_4, normal_6, 0.0, int(max(e_4.leaf, 0.0)), odds_1.total);
        probability_1 = (_e17.probability * _e17.share);
    }
    float _e21 = probability_1;
    return _e21;
}

float probabilityOf(Emitter e_5, vec3 point_5, vec3 normal_7, Odds odds_2) {
    float _e4 = listedProbability(e_5, point_5, normal_7, odds_2);
    float _e5 = treeProbability(e_5, point_5, normal_7, odds_2);
    return pick((e_5.leaf >= 0.0), _e5, _e4);
}

Emitter fetchEmitter(uint i_1) {
    vec4 _e2 = tableTexel(14u, i_1);
    vec4 _e4 = tableTexel(15u, i_1);
    vec4 _e6 = tableTexel(16u, i_1);
    vec4 _e8 = tableTexel(17u, i_1);
    vec4 _e10 = tableTexel(18u, i_1);
    vec4 _e12 = tableTexel(19u, i_1);
    return Emitter(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.x, _e10.y, _e10.z, _e10.w, _e12.x, _e12.y, _e12.z, _e12.w);
}

EmitterChoice chooseEmitter(vec3 point_6, vec3 normal_8, float u_1) {
    bool hasTree = false;
    EmitterChoice choice_1 = EmitterChoice(0u, 0.0, Odds(0.0, 0.0));
    float total_1 = 0.0;
    uint chosen = 0u;
    float chosenWeight = 0.0;
    float rest_1 = 0.0;
    uint i_2 = 0u;
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
            rest_1 = u_1;
            while(true) {
                uint _e48 = i_2;
                Emitter _e49 = fetchEmitter(_e48);
                float _e50 = estimatedIrradiance(_e49, point_6, normal_8);
                uint _e51 = i_2;
                float weight = pick((_e51 < listed), _e50, 0.0);
                float _e55 = total_1;
                total_1 = (_e55 + weight);
                float _e57 = total_1;
                float share_3 = (weight / max(_e57, 1e-37));
                float _e61 = rest_1;
                bool take = (_e61 < share_3);
                uint _e63 = chosen;
                uint _e64 = i_2;
                chosen = pick(take, _e64, _e63);
                float _e66 = chosenWeight;
                chosenWeight = pick(take, weight, _e66);
                float _e68 = rest_1;
                float _e75 = rest_1;
                rest_1 = pick(take, (_e75 / max(share_3, 1e-37)), ((_e68 - share_3) / max((1.0 - share_3), 1e-7)));
                uint _e81 = i_2;
                i_2 = (_e81 + 1u);
                uint _e83 = i_2;
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
                    TreeChoice _e101 = descend(point_6, normal_8, _e98, -1, _e100);
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

SphereView viewSphere(Emitter e_6, vec3 point_7) {
    vec3 toCenter = (e_6.position - point_7);
    float d_2 = length(toCenter);
    float power = abs(((d_2 - e_6.radius) * (d_2 + e_6.radius)));
    bool inside_1 = (d_2 <= e_6.radius);
    float sine_1 = min((e_6.radius / max(d_2, 1e-30)), 1.0);
    float cosine_1 = (sqrt(power) / max(d_2, 1e-30));
    return SphereView(toCenter, d_2, power, inside_1, pick(inside_1, 2.0, ((sine_1 * sine_1) / (1.0 + cosine_1))));
}

vec3 turnTo(vec3 axis, vec3 v) {
    float s_3 = pick((axis.z >= 0.0), 1.0, -1.0);
    float a_4 = (-1.0 / (s_3 + axis.z));
    float b_5 = ((axis.x * axis.y) * a_4);
    vec3 x_9 = vec3((1.0 + (((s_3 * axis.x) * axis.x) * a_4)), (s_3 * b_5), (-(s_3) * axis.x));
    vec3 y_4 = vec3(b_5, (s_3 + ((axis.y * axis.y) * a_4)), -(axis.y));
    return (((v.x * x_9) + (v.y * y_4)) + (v.z * axis));
}

ConeDirection sampleCone(vec3 axis_1, float width, vec2 u_2) {
    float oneMinusCosine = (u_2.x * width);
    float cosine_2 = (1.0 - oneMinusCosine);
    float sine2_ = (oneMinusCosine * (2.0 - oneMinusCosine));
    float sine_2 = sqrt(max(sine2_, 0.0));
    float phi = (6.2831855 * u_2.y);
    vec2 turn = vec2(cos(phi), sin(phi));
    vec3 _e23 = turnTo(axis_1, vec3(((sine_2 / length(turn)) * turn), cosine_2));
    return ConeDirection(_e23, cosine_2, sine2_);
}

float conePdf(float width_1) {
    return (1.0 / (6.2831855 * max(width_1, 1e-31)));
}

LightSample sampleSphere(Emitter e_7, vec3 point_8, vec2 u_3) {
    SphereView _e3 = viewSphere(e_7, point_8);
    vec3 axis_3 = pick((_e3.distance_ < 1e-30), vec3(0.0, 0.0, 1.0), (_e3.toCenter / vec3(max(_e3.distance_, 1e-30))));
    ConeDirection _e19 = sampleCone(axis_3, _e3.width, u_3);
    float along_1 = (_e3.distance_ * _e19.cosine);
    float halfChord = sqrt(max(((e_7.radius * e_7.radius) - ((_e3.distance_ * _e3.distance_) * _e19.sine2_)), 0.0));
    float larger_1 = (abs(along_1) + halfChord);
    bool takeLarger = pick(_e3.inside, (along_1 > 0.0), false);
    float distance_7 = pick(takeLarger, larger_1, (_e3.power / max(larger_1, 1e-30)));
    float _e49 = conePdf(_e3.width);
    return LightSample(_e19.direction, distance_7, e_7.radiance, _e49, false);
}

float arctangent(float x) {
    float a_5 = abs(x);
    bool steep = (a_5 > 2.4142137);
    bool middle_1 = pick((a_5 > 0.41421357), !(steep), false);
    float r_1 = pick(steep, (-1.0 / max(a_5, 1.0)), pick(middle_1, ((a_5 - 1.0) / (a_5 + 1.0)), a_5));
    float base = pick(steep, 1.5707964, pick(middle_1, 0.7853982, 0.0));
    float z_1 = (r_1 * r_1);
    float series = ((((((0.080537446 * z_1) - 0.13877685) * z_1) + 0.19977711) * z_1) - 0.3333295);
    return (sign(x) * (base + (((series * z_1) * r_1) + r_1)));
}

float stretch(float x_1, vec2 y, float h) {
    vec2 r_2 = sqrt(((vec2((x_1 * x_1)) + (y * y)) + vec2((h * h))));
    float _e16 = arctangent(((x_1 * y.y) / (h * r_2.y)));
    float _e22 = arctangent(((x_1 * y.x) / (h * r_2.x)));
    return (_e16 - _e22);
}

QuadView viewQuad(Emitter e_8, vec3 point_9) {
    vec3 corner = (e_8.position - point_9);
    vec2 lengths = vec2(length(e_8.u), length(e_8.v));
    vec3 axisX = (e_8.u / vec3(lengths.x));
    vec3 axisY = (e_8.v / vec3(lengths.y));
    vec3 normal_13 = normalize(cross(axisX, axisY));
    float signedHeight = dot(corner, normal_13);
    float least = (1e-7 * (lengths.x + lengths.y));
    float height_2 = max(abs(signedHeight), least);
    bool lit = pick((abs(signedHeight) > least), pick((e_8.oneSided == 0.0), true, (signedHeight < 0.0)), false);
    vec2 low_2 = vec2(dot(corner, axisX), dot(corner, axisY));
    vec2 high_1 = (low_2 + lengths);
    vec2 y_5 = vec2(low_2.y, high_1.y);
    float _e44 = stretch(low_2.x, y_5, height_2);
    float _e46 = stretch(high_1.x, y_5, height_2);
    float solidAngle = (_e46 - _e44);
    bool rectangle = (abs(dot(axisX, axisY)) <= 1e-5);
    vec3 axisZ = (normal_13 * pick((signedHeight > 0.0), 1.0, -1.0));
    return QuadView(corner, axisX, axisY, axisZ, low_2, high_1, height_2, _e44, solidAngle, lit, pick(rectangle, (solidAngle > 0.01), false));
}

vec2 cosineAndSine(float x_2) {
    float h_2 = (0.5 * x_2);
    float z_2 = (h_2 * h_2);
    float sine_3 = (((((((-0.00019515296 * z_2) + 0.008332161) * z_2) - 0.16666655) * z_2) * h_2) + h_2);
    return vec2((1.0 - ((2.0 * sine_3) * sine_3)), ((2.0 * sine_3) * sqrt((1.0 - (sine_3 * sine_3)))));
}

vec3 sphericalRectangle(QuadView q, vec2 u_4) {
    float h_3 = q.height;
    vec2 y_6 = vec2(q.low.y, q.high.y);
    vec2 s_4 = (y_6 / sqrt(((y_6 * y_6) + vec2((h_3 * h_3)))));
    vec2 _e21 = cosineAndSine((0.5 * (q.start + (u_4.x * q.solidAngle))));
    vec2 across_1 = (vec2((s_4.y - s_4.x), (s_4.y + s_4.x)) * _e21);
    float w_2 = (((2.0 * _e21.x) * _e21.y) / max(length(across_1), 1e-15));
    float x_10 = clamp(((h_3 * w_2) * inversesqrt(max((1.0 - (w_2 * w_2)), 1e-12))), q.low.x, q.high.x);
    float d2_ = ((x_10 * x_10) + (h_3 * h_3));
    vec2 ends_1 = (y_6 * inversesqrt((vec2(d2_) + (y_6 * y_6))));
    float v_6 = mix(ends_1.x, ends_1.y, u_4.y);
    float atY = clamp(((v_6 * sqrt(d2_)) * inversesqrt(max((1.0 - (v_6 * v_6)), 1e-12))), y_6.x, y_6.y);
    return (((x_10 * q.axisX) + (atY * q.axisY)) + (h_3 * q.axisZ));
}

float areaPdf(float area, float height, float distance_) {
    float pdf_1 = (((distance_ / max(height, 1e-30)) * distance_) / max((area / distance_), 1e-30));
    return min(pdf_1, 1e30);
}

float pdfOfView(QuadView q_1, float area_1, float distance_1) {
    float _e4 = areaPdf(area_1, q_1.height, distance_1);
    float pdf_2 = pick(q_1.bySolidAngle, (1.0 / max(q_1.solidAngle, 0.01)), _e4);
    return pick(q_1.lit, pdf_2, 0.0);
}

LightSample sampleQuad(Emitter e_9, vec3 point_10, vec2 u_5) {
    QuadView _e3 = viewQuad(e_9, point_10);
    vec3 onArea = ((_e3.corner + (u_5.x * e_9.u)) + (u_5.y * e_9.v));
    vec3 _e13 = sphericalRectangle(_e3, u_5);
    vec3 toLight_4 = pick(_e3.bySolidAngle, _e13, onArea);
    float distance_8 = max(length(toLight_4), _e3.height);
    float _e23 = pdfOfView(_e3, e_9.area, distance_8);
    return LightSample((toLight_4 / vec3(distance_8)), distance_8, e_9.radiance, _e23, false);
}

Extent fetchExtent(uint i_3) {
    vec4 _e2 = tableTexel(1u, i_3);
    vec4 _e4 = tableTexel(2u, i_3);
    return Extent(_e2.xyzw, _e4.xyzw);
}

vec3 rotate(vec4 q_2, vec3 v_1) {
    vec3 t_8 = (2.0 * cross(q_2.xyz, v_1));
    return ((v_1 + (q_2.w * t_8)) + cross(q_2.xyz, t_8));
}

BoxView viewBox(Emitter e_10, vec3 point_11) {
    Extent _e4 = fetchExtent(uint(e_10.shape));
    vec4 rotation = _e4.a;
    vec3 _e8 = rotate(rotation, (point_11 - e_10.position));
    bvec3 seen = greaterThan(abs(_e8), e_10.u);
    vec3 faces = mix(vec3(0.0), ((4.0 * e_10.u.yzx) * e_10.u.zxy), seen);
    return BoxView(rotation, _e8, faces, ((faces.x + faces.y) + faces.z), !(any(seen)));
}

vec4 pointOnFaces(Emitter e_11, BoxView b, vec2 u_6) {
    float both = (b.faces.x + b.faces.y);
    float at_2 = (u_6.x * b.area);
    bool onX = (at_2 < b.faces.x);
    bool onY = pick(!(onX), (at_2 < both), false);
    float face = pick(onX, b.faces.x, pick(onY, b.faces.y, b.faces.z));
    float within = clamp(((at_2 - pick(onX, 0.0, pick(onY, b.faces.x, both))) / max(face, 1e-30)), 0.0, 1.0);
    vec3 axis_4 = vec3(pick(onX, 1.0, 0.0), pick(onY, 1.0, 0.0), pick(pick(onX, true, onY), 0.0, 1.0));
    vec3 p_9 = vec3(pick((dot(axis_4, b.point) >= 0.0), 1.0, -1.0), ((2.0 * within) - 1.0), ((2.0 * u_6.y) - 1.0));
    vec3 toLight_5 = ((pick(onX, p_9.xyz, pick(onY, p_9.zxy, p_9.yzx)) * e_11.u) - b.point);
    return vec4(toLight_5, abs(dot(axis_4, toLight_5)));
}

vec3 safeReciprocal(vec3 d, vec3 origin) {
    vec3 tiny = mix(vec3(1e-18), vec3(-1e-18), greaterThan(origin, vec3(0.0)));
    return (vec3(1.0) / mix(d, tiny, lessThan(abs(d), vec3(1e-18))));
}

Slabs boxSlabs(vec3 origin_1, vec3 direction, vec3 halfSize) {
    vec3 _e3 = safeReciprocal(direction, origin_1);
    vec3 middle_2 = (-(origin_1) * _e3);
    vec3 reach = (halfSize * abs(_e3));
    vec3 enter = (middle_2 - reach);
    vec3 leave = (middle_2 + reach);
    return Slabs(enter, leave, max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}

vec3 rotateBack(vec4 q_3, vec3 v_2) {
    vec3 _e6 = rotate(vec4(-(q_3.xyz), q_3.w), v_2);
    return _e6;
}

LightSample sampleBox(Emitter e_12, vec3 point_12, vec2 u_7) {
    BoxView _e3 = viewBox(e_12, point_12);
    vec4 _e4 = pointOnFaces(e_12, _e3, u_7);
    ConeDirection _e10 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_7);
    vec3 outwards = _e10.direction;
    Slabs _e16 = boxSlabs(_e3.point, outwards, e_12.u);
    float distance_9 = pick(_e3.inside, max(_e16.far, 0.0), length(_e4.xyz));
    vec3 direction_21 = pick(_e3.inside, outwards, (_e4.xyz / vec3(max(distance_9, 1e-30))));
    float _e31 = areaPdf(_e3.area, _e4.w, distance_9);
    float _e33 = conePdf(2.0);
    float pdf_3 = pick(_e3.inside, _e33, _e31);
    vec3 _e37 = rotateBack(_e3.rotation, direction_21);
    return LightSample(_e37, distance_9, e_12.radiance, pdf_3, false);
}

uvec4 geometryRow(uint i_4) {
    uvec4 _e14 = texelFetch(geometry, ivec2(int((i_4 & 2047u)), int((float(int((i_4 & 2147481600u))) / 2048.0))), 0);
    return _e14;
}

LampTriangle fetchLampTriangle(uint row_1) {
    uvec4 _e3 = geometryRow((row_1 + 0u));
    return LampTriangle(uintBitsToFloat(_e3.x), _e3.y, _e3.z, uintBitsToFloat(_e3.w));
}

uvec2 mixBits2_(uvec2 x_3) {
    uvec2 y_1 = uvec2(0u);
    y_1 = ((x_3 ^ (x_3 >> uvec2(16u))) * 569420461u);
    uvec2 _e8 = y_1;
    uvec2 _e9 = y_1;
    y_1 = ((_e8 ^ (_e9 >> uvec2(15u))) * 1935289751u);
    uvec2 _e16 = y_1;
    uvec2 _e17 = y_1;
    return (_e16 ^ (_e17 >> uvec2(15u)));
}

uint mixBits(uint x_4) {
    uvec2 _e2 = mixBits2_(uvec2(x_4));
    return _e2.x;
}

ChosenTriangle chooseTriangle(Emitter e_13, vec2 u_8) {
    uint _e4 = frame.lampTables;
    uint first = (_e4 + uint(e_13.table));
    uint column_2 = min(uint((u_8.x * e_13.triangles)), (uint(e_13.triangles) - 1u));
    LampTriangle _e18 = fetchLampTriangle((first + column_2));
    uint _e26 = mixBits((floatBitsToUint(u_8.x) ^ (floatBitsToUint(u_8.y) * 2654435761u)));
    uint hash = (_e26 >> 8u);
    float fine_2 = (((float(hash) * 5.9604645e-8) * 5.9604645e-8) * e_13.triangles);
    float x_11 = clamp((((u_8.x * e_13.triangles) - float(column_2)) + fine_2), 0.0, 0.99999994);
    bool own_2 = (x_11 < _e18.own);
    float rest_2 = pick(own_2, (x_11 / max(_e18.own, 1e-37)), ((x_11 - _e18.own) / max((1.0 - _e18.own), 1e-7)));
    uint place_4 = pick(own_2, _e18.place, _e18.other);
    LampTriangle _e67 = fetchLampTriangle((((first + column_2) + place_4) - _e18.place));
    float density = _e67.density;
    return ChosenTriangle(place_4, density, vec2(min(rest_2, 1.0), u_8.y));
}

Instance fetchInstance(uint row_2) {
    uvec4 _e3 = geometryRow((row_2 + 0u));
    uvec4 _e6 = geometryRow((row_2 + 1u));
    uvec4 _e9 = geometryRow((row_2 + 2u));
    uvec4 _e12 = geometryRow((row_2 + 3u));
    uvec4 _e15 = geometryRow((row_2 + 4u));
    return Instance(uintBitsToFloat(_e3.xyzw), uintBitsToFloat(_e6.xyzw), uintBitsToFloat(_e9.xyzw), _e12.x, _e12.y, _e12.z, _e12.w, _e15.x, _e15.y, _e15.z, _e15.w);
}

Triangle fetchTriangle(uint row_3) {
    uvec4 _e3 = geometryRow((row_3 + 0u));
    uvec4 _e6 = geometryRow((row_3 + 1u));
    uvec4 _e9 = geometryRow((row_3 + 2u));
    return Triangle(uintBitsToFloat(_e3.xyz), _e3.w, uintBitsToFloat(_e6.xyz), _e6.w, uintBitsToFloat(_e9.xyz), _e9.w);
}

vec2 weightsOnTriangle(vec2 u_9) {
    float low_3 = (0.5 * min(u_9.x, u_9.y));
    float high_2 = (max(u_9.x, u_9.y) - low_3);
    return pick((u_9.x < u_9.y), vec2(low_3, high_2), vec2(high_2, low_3));
}

vec3 outOfMesh(Instance i_5, vec3 p) {
    vec3 q_6 = (p - vec3(i_5.toMeshX.w, i_5.toMeshY.w, i_5.toMeshZ.w));
    vec3 x_12 = cross(i_5.toMeshY.xyz, i_5.toMeshZ.xyz);
    vec3 y_7 = cross(i_5.toMeshZ.xyz, i_5.toMeshX.xyz);
    vec3 z_3 = cross(i_5.toMeshX.xyz, i_5.toMeshY.xyz);
    return ((((q_6.x * x_12) + (q_6.y * y_7)) + (q_6.z * z_3)) / vec3(dot(i_5.toMeshX.xyz, x_12)));
}

Vertex fetchVertex(uint row_4) {
    uvec4 _e3 = geometryRow((row_4 + 0u));
    return Vertex(_e3.x, _e3.y, uintBitsToFloat(_e3.zw));
}

VertexMore fetchVertexMore(uint row_5) {
    uvec4 _e3 = geometryRow((row_5 + 0u));
    return VertexMore(_e3.x, _e3.y, uintBitsToFloat(_e3.zw));
}

vec2 pairOf(uint word) {
    return (vec2(float((word & 65535u)), float((word >> 16u))) / vec2(65535.0));
}

Cover coverAt(uvec3 rows, uint each, vec2 weights) {
    Cover c = Cover(vec4(0.0), 1.0);
    vec3 share_4 = vec3(((1.0 - weights.x) - weights.y), weights);
    if ((each != 0u)) {
        Vertex _e19 = fetchVertex(rows.x);
        Vertex _e24 = fetchVertex(rows.y);
        Vertex _e30 = fetchVertex(rows.z);
        c.uv = vec4((((share_4.x * _e19.uv) + (share_4.y * _e24.uv)) + (share_4.z * _e30.uv)), 0.0, 0.0);
    }
    if ((each > vertexRows)) {
        uvec3 more = (rows + uvec3(1u));
        VertexMore _e43 = fetchVertexMore(more.x);
        VertexMore _e45 = fetchVertexMore(more.y);
        VertexMore _e47 = fetchVertexMore(more.z);
        vec4 _e50 = c.uv;
        c.uv = vec4(_e50.xy, (((share_4.x * _e43.uv) + (share_4.y * _e45.uv)) + (share_4.z * _e47.uv)));
        vec2 _e66 = pairOf(_e43.blueAlpha);
        vec2 _e69 = pairOf(_e45.blueAlpha);
        vec2 _e72 = pairOf(_e47.blueAlpha);
        c.opacity = dot(share_4, vec3(_e66.y, _e69.y, _e72.y));
    }
    Cover _e76 = c;
    return _e76;
}

uvec4 texelRow(uint i_6) {
    uvec4 _e14 = texelFetch(texels, ivec2(int((i_6 & 2047u)), int((float(int((i_6 & 2147481600u))) / 2048.0))), 0);
    return _e14;
}

MaterialTextures fetchMaterialTextures(uint row_6) {
    uvec4 _e3 = texelRow((row_6 + 0u));
    return MaterialTextures(_e3.x, _e3.y, uintBitsToFloat(_e3.z), uintBitsToFloat(_e3.w));
}

TextureUse fetchTextureUse(uint row_7) {
    uvec4 _e3 = texelRow((row_7 + 0u));
    uvec4 _e6 = texelRow((row_7 + 1u));
    uvec4 _e9 = texelRow((row_7 + 2u));
    return TextureUse(uintBitsToFloat(_e3.xyz), _e3.w, uintBitsToFloat(_e6.xyz), _e6.w, _e9.x, _e9.y, _e9.z, uintBitsToFloat(_e9.w));
}

Neighbours neighbours(float x_5, uint size, bool clamps, bool mirrors, bool nearest) {
    float inside_2 = pick(clamps, clamp(x_5, 0.0, 1.0), pick(mirrors, (1.0 - abs(((2.0 * fract((0.5 * x_5))) - 1.0))), fract(x_5)));
    float at_3 = ((inside_2 * float(size)) - pick(nearest, 0.0, 0.5));
    float low_4 = floor(at_3);
    int last = (int(size) - 1);
    int first_1 = int(low_4);
    int second = (first_1 + 1);
    bool repeats = !(pick(clamps, true, mirrors));
    int before_1 = pick(repeats, last, 0);
    int after = pick(repeats, 0, last);
    return Neighbours(uint(pick((first_1 < 0), before_1, min(max(first_1, 0), last))), uint(pick((second > last), after, min(max(second, 0), last))), pick(nearest, 0.0, (at_3 - low_4)));
}

vec3 linearFromSrgb(vec3 c_1) {
    return mix(pow(((c_1 + vec3(0.055)) / vec3(1.055)), vec3(2.4)), (c_1 / vec3(12.92)), lessThanEqual(c_1, vec3(0.04045)));
}

vec4 decoded(uint texel, bool colored) {
    vec4 c_3 = (vec4(((uvec4(texel) >> uvec4(0u, 8u, 16u, 24u)) & uvec4(255u))) / vec4(255.0));
    vec3 _e18 = linearFromSrgb(c_3.xyz);
    return vec4(pick(colored, _e18, c_3.xyz), c_3.w);
}

uint texelAt(uint i_7) {
    uvec4 _e3 = texelRow((i_7 >> 2u));
    uvec2 pair_2 = pick(((i_7 & 2u) != 0u), _e3.zw, _e3.xy);
    return pick(((i_7 & 1u) != 0u), pair_2.y, pair_2.x);
}

vec4 lookUp(TextureUse t_1, vec2 uv) {
    vec3 place_5 = vec3(uv, 1.0);
    const bool _e7 = hasOtherLookups;
    uint flags = pick(_e7, t_1.flags, 0u);
    bool nearest_1 = ((flags & isNearest) != 0u);
    Neighbours _e24 = neighbours(dot(t_1.toU, place_5), t_1.width, ((flags & clampsU) != 0u), ((flags & mirrorsU) != 0u), nearest_1);
    Neighbours _e36 = neighbours(dot(t_1.toV, place_5), t_1.height, ((flags & clampsV) != 0u), ((flags & mirrorsV) != 0u), nearest_1);
    uint upper = (t_1.first + (_e36.first * t_1.width));
    uint lower = (t_1.first + (_e36.second * t_1.width));
    bool colored_1 = ((t_1.flags & isColor) != 0u);
    uint _e54 = texelAt((upper + _e24.first));
    vec4 _e55 = decoded(_e54, colored_1);
    uint _e58 = texelAt((upper + _e24.second));
    vec4 _e59 = decoded(_e58, colored_1);
    vec4 above_2 = mix(_e55, _e59, _e24.share);
    uint _e64 = texelAt((lower + _e24.first));
    vec4 _e65 = decoded(_e64, colored_1);
    uint _e68 = texelAt((lower + _e24.second));
    vec4 _e69 = decoded(_e68, colored_1);
    vec4 below = mix(_e65, _e69, _e24.share);
    return mix(above_2, below, _e36.share);
}

vec3 radianceShare(uint row_8, Cover c_2, bool missing) {
    vec3 share = vec3(1.0);
    float opacity = 0.0;
    uint i_8 = 0u;
    MaterialTextures _e3 = fetchMaterialTextures(row_8);
    bool hasFirst = ((_e3.flags & hasOpacityTexture) != 0u);
    uint wanted = min(_e3.count, pick(hasFirst, 2u, 1u));
    opacity = (_e3.opacity * c_2.opacity);
    if ((wanted > 0u)) {
        while(true) {
            uint _e27 = i_8;
            TextureUse _e31 = fetchTextureUse(((row_8 + materialTexturesRows) + (_e27 * textureUseRows)));
            vec4 _e42 = lookUp(_e31, pick(((_e31.flags & usesSecondSet) != 0u), c_2.uv.zw, c_2.uv.xy));
            vec3 _e43 = share;
            share = (_e43 * pick((_e31.slot == emissionSlot), _e42.xyz, vec3(1.0)));
            float _e52 = opacity;
            uint _e54 = i_8;
            opacity = (_e52 * pick(pick(hasFirst, (_e54 == 0u), false), _e42.w, 1.0));
            uint _e62 = i_8;
            i_8 = (_e62 + 1u);
            uint _e64 = i_8;
            if ((_e64 >= wanted)) {
                break;
            }
        }
    }
    float _e66 = opacity;
    float _e72 = opacity;
    float there = pick((_e3.cutoff < 0.0), _e72, pick((_e66 >= _e3.cutoff), 1.0, 0.0));
    vec3 _e77 = share;
    return (_e77 * pick(missing, there, 1.0));
}

Surface fetchSurface(uint i_9) {
    vec4 _e2 = tableTexel(9u, i_9);
    vec4 _e4 = tableTexel(10u, i_9);
    vec4 _e6 = tableTexel(11u, i_9);
    vec4 _e8 = tableTexel(12u, i_9);
    vec4 _e10 = tableTexel(13u, i_9);
    return Surface(_e2.xyz, _e2.w, _e4.xyz, _e4.w, _e6.xyz, _e6.w, _e8.xyz, _e8.w, _e10.xyz, _e10.w);
}

LightSample sampleMesh(Emitter e_14, vec3 point_13, vec2 u_10) {
    vec3 radiance = vec3(0.0);
    ChosenTriangle _e3 = chooseTriangle(e_14, u_10);
    uint _e6 = frame.instances;
    Instance _e12 = fetchInstance((_e6 + (uint(e_14.instance) * instanceRows)));
    Triangle _e18 = fetchTriangle((_e12.triangles + (_e3.place * triangleRows)));
    vec2 _e20 = weightsOnTriangle(_e3.u);
    vec3 _e34 = outOfMesh(_e12, ((_e18.a + (_e20.x * (_e18.b - _e18.a))) + (_e20.y * (_e18.c - _e18.a))));
    vec3 toLight_6 = (_e34 - point_13);
    vec3 across_2 = (mat3x3(_e12.toMeshX.xyz, _e12.toMeshY.xyz, _e12.toMeshZ.xyz) * cross((_e18.b - _e18.a), (_e18.c - _e18.a)));
    float height_3 = (dot(across_2, toLight_6) * inversesqrt(max(dot(across_2, across_2), 1e-37)));
    float distance_10 = length(toLight_6);
    float _e60 = areaPdf(e_14.area, abs(height_3), distance_10);
    float pdf_4 = (_e60 * _e3.density);
    bool lit_1 = pick((height_3 < 0.0), true, pick((e_14.oneSided == 0.0), (height_3 > 0.0), false));
    float reached = max((distance_10 - (1e-5 * (length(point_13) + distance_10))), 0.0);
    radiance = e_14.radiance;
    const bool _e82 = hasVariedLamps;
    if (_e82) {
        if ((e_14.u.y > 0.0)) {
            uvec3 rows_1 = (uvec3(_e12.vertices) + (uvec3(_e18.vertexA, _e18.vertexB, _e18.vertexC) * _e12.vertexRows));
            Cover _e97 = coverAt(rows_1, _e12.vertexRows, _e20);
            vec3 _e98 = radiance;
            Surface _e101 = fetchSurface(uint(e_14.shape));
            vec3 _e109 = radianceShare(uint(_e101.textures), _e97, ((_e12.cover & coverRow) != 0u));
            radiance = (_e98 * _e109);
        }
    }
    vec3 _e115 = radiance;
    return LightSample((toLight_6 / vec3(max(distance_10, 1e-30))), reached, _e115, pick(lit_1, pdf_4, 0.0), false);
}

LightSample samplePoint(Emitter e_15, vec3 point_14) {
    vec3 toLight_7 = (e_15.position - point_14);
    float distance_11 = length(toLight_7);
    float safe = max(distance_11, 1e-15);
    return LightSample((toLight_7 / vec3(safe)), distance_11, (e_15.radiance / vec3((safe * safe))), pick((distance_11 > 1e-15), 1.0, 0.0), true);
}

LightSample sampleSpot(Emitter e_16, vec3 point_15) {
    LightSample s = LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, false);
    LightSample _e2 = samplePoint(e_16, point_15);
    s = _e2;
    vec3 _e5 = s.direction;
    float _e6 = spotFalloff(e_16, _e5);
    vec3 _e8 = s.radiance;
    s.radiance = (_e8 * _e6);
    float _e12 = s.pdf;
    s.pdf = pick((_e6 > 0.0), _e12, 0.0);
    LightSample _e17 = s;
    return _e17;
}

LightSample sampleDirectional(Emitter e_17, vec2 u_11) {
    bool delta = (e_17.area == 0.0);
    ConeDirection _e10 = sampleCone(-(e_17.u), (e_17.area / 6.2831855), u_11);
    return LightSample(_e10.direction, 1e30, e_17.radiance, pick(delta, 1.0, (1.0 / max(e_17.area, 1e-31))), delta);
}

vec4 environmentTexel(uint column_1, uint row_9) {
    vec4 _e5 = texelFetch(environment, ivec2(uvec2(column_1, row_9)), 0);
    return _e5;
}

vec4 fetchEntries(Table t_2, uint pair) {
    float _e5 = frame.environmentSize.x;
    uint width_2 = uint(_e5);
    uint i_28 = (t_2.first + pair);
    uint row_11 = (i_28 / width_2);
    vec4 _e12 = environmentTexel((i_28 - (row_11 * width_2)), row_11);
    return _e12;
}

vec2 sharesBeyond(vec4 pair_1, uint digits, uint fine) {
    uvec2 further = (uvec2(pair_1.yw) & uvec2(4095u));
    return ((pair_1.xz - vec2(float(digits))) + ((vec2(further) - vec2(float(fine))) * 0.00024414063));
}

Choice chooseEntry(Table t_3, uint digits_1, uint fine_1) {
    uint low = 0u;
    uint high = 0u;
    vec2 ends = vec2(1.0);
    uint step_ = 0u;
    uint pairs = ((t_3.entries + 1u) / 2u);
    uint part = ((((digits_1 >> 12u) * t_3.entries) + (((digits_1 & 4095u) * t_3.entries) >> 12u)) >> 12u);
    vec4 _e23 = fetchEntries(t_3, (part / 2u));
    low = (uint(pick(((part & 1u) == 1u), _e23.w, _e23.y)) >> 12u);
    high = pairs;
    while(true) {
        uint _e41 = low;
        uint _e42 = step_;
        uint _e47 = low;
        uint _e48 = high;
        uint _e52 = high;
        uint next = pick((_e52 < pairs), ((_e47 + _e48) / 2u), min((_e41 + _e42), (pairs - 1u)));
        vec4 _e55 = fetchEntries(t_3, next);
        vec2 _e56 = sharesBeyond(_e55, digits_1, fine_1);
        bool found_8 = (_e56.y > 0.0);
        vec2 _e60 = ends;
        ends = pick(found_8, _e56, _e60);
        uint _e62 = high;
        high = pick(found_8, next, _e62);
        uint _e66 = low;
        low = pick(found_8, _e66, (next + 1u));
        uint _e69 = step_;
        step_ = ((2u * _e69) + 1u);
        uint _e73 = low;
        uint _e74 = high;
        if ((_e73 >= _e74)) {
            break;
        }
    }
    uint _e76 = high;
    uint pair_3 = min(_e76, (pairs - 1u));
    vec4 _e84 = fetchEntries(t_3, (max(pair_3, 1u) - 1u));
    vec2 _e85 = sharesBeyond(_e84, digits_1, fine_1);
    float before_2 = _e85.y;
    float none = -((float(digits_1) + (float(fine_1) * 0.00024414063)));
    float _e94 = ends.x;
    bool isFirst = (_e94 > 0.0);
    float _e98 = ends.x;
    float start = pick(isFirst, pick((pair_3 == 0u), none, before_2), _e98);
    float _e104 = ends.y;
    float _e106 = ends.x;
    float end = pick(isFirst, _e106, _e104);
    return Choice(min(((2u * pair_3) + pick(isFirst, 0u, 1u)), (t_3.entries - 1u)), clamp((-(start) / max((end - start), 1e-37)), 0.0, 1.0));
}

ChosenCell chooseCell(vec2 u_12) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_1 = uvec2(_e3);
    uvec2 digits_2 = uvec2((u_12 * 16777216.0));
    uint _e13 = mixBits((digits_2.x ^ (digits_2.y * 2654435761u)));
    uint columns = ((size_1.x + 1u) / 2u);
    uint tables = (size_1.x * size_1.y);
    Choice _e29 = chooseEntry(Table(tables, (size_1.y + 1u)), digits_2.y, (_e13 & 4095u));
    Choice _e44 = chooseEntry(Table(((tables + ((size_1.y + 2u) / 2u)) + (_e29.entry * columns)), size_1.x), digits_2.x, (_e13 >> 20u));
    return ChosenCell(uvec2(_e44.entry, _e29.entry), vec2(_e44.rest, _e29.rest));
}

Corners environmentCorners(uvec2 cell) {
    vec2 _e3 = frame.environmentSize;
    uvec2 size_2 = uvec2(_e3);
    uint left_1 = (pick((cell.x == 0u), size_2.x, cell.x) - 1u);
    uint right = pick((cell.x == size_2.x), 0u, cell.x);
    uint upper_1 = (max(cell.y, 1u) - 1u);
    uint lower_1 = min(cell.y, (size_2.y - 1u));
    vec4 above_3 = vec4(1.0, 1.0, 1.0, pick((cell.y == 0u), -1.0, 1.0));
    vec4 below_1 = vec4(1.0, 1.0, 1.0, pick((cell.y == size_2.y), -1.0, 1.0));
    vec4 _e49 = environmentTexel(left_1, upper_1);
    vec4 _e51 = environmentTexel(right, upper_1);
    vec4 _e53 = environmentTexel(left_1, lower_1);
    vec4 _e55 = environmentTexel(right, lower_1);
    return Corners((above_3 * _e49), (above_3 * _e51), (below_1 * _e53), (below_1 * _e55));
}

float linearSample(float u_13, float a, float b_1) {
    vec2 ends_2 = (vec2(a, b_1) / vec2(max((a + b_1), 1e-37)));
    return min((u_13 / max((ends_2.x + sqrt(mix((ends_2.x * ends_2.x), (ends_2.y * ends_2.y), u_13))), 1e-9)), 1.0);
}

EnvironmentLight lightWithin(Corners k, vec2 at, float sine) {
    vec4 light_1 = mix(mix(k.a, k.b, at.x), mix(k.c, k.d, at.x), at.y);
    return EnvironmentLight(light_1.xyz, (max(light_1.w, 0.0) / sine));
}

EnvironmentSample sampleEnvironment(vec2 u_14) {
    vec2 size_3 = frame.environmentSize;
    ChosenCell _e4 = chooseCell(u_14);
    Corners _e6 = environmentCorners(_e4.cell);
    vec2 cell_1 = vec2(_e4.cell);
    bvec2 atPole = bvec2((cell_1.y == 0.0), (cell_1.y == size_3.y));
    float _e32 = linearSample(_e4.rest.y, max((_e6.a.w + _e6.b.w), 0.0), max((_e6.c.w + _e6.d.w), 0.0));
    float t_9 = ((_e32 * pick(any(atPole), 0.5, 1.0)) + pick(atPole.x, 0.5, 0.0));
    float _e55 = linearSample(_e4.rest.x, mix(_e6.a.w, _e6.c.w, t_9), mix(_e6.b.w, _e6.d.w, t_9));
    bool isLower = ((2.0 * cell_1.y) > size_3.y);
    float fromPole = pick(isLower, ((size_3.y - cell_1.y) + (0.5 - t_9)), (cell_1.y + (t_9 - 0.5)));
    vec2 _e76 = cosineAndSine((fromPole * (3.1415927 / size_3.y)));
    float _e85 = frame.environmentTurn;
    float halfTurns = (2.0 * (((cell_1.x + (_e55 - 0.5)) / size_3.x) - _e85));
    float nearest_2 = floor((halfTurns + 0.5));
    bool back = (fract((0.5 * nearest_2)) > 0.0);
    vec2 _e100 = cosineAndSine(((halfTurns - nearest_2) * 3.1415927));
    vec2 phi_1 = (_e100 * pick(back, -1.0, 1.0));
    float sine_4 = max(_e76.y, 1e-9);
    vec3 direction_22 = vec3((sine_4 * phi_1.y), pick(isLower, -(_e76.x), _e76.x), (-(sine_4) * phi_1.x));
    EnvironmentLight _e119 = lightWithin(_e6, vec2(_e55, t_9), sine_4);
    return EnvironmentSample(direction_22, _e119);
}

vec3 sky(vec3 direction_1) {
    vec3 _e3 = frame.horizon;
    vec3 _e6 = frame.zenith;
    return mix(_e3, _e6, max(direction_1.y, 0.0));
}

LightSample sampleSky(vec2 u_15) {
    EnvironmentSample s_1 = EnvironmentSample(vec3(0.0), EnvironmentLight(vec3(0.0), 0.0));
    ConeDirection _e6 = sampleCone(vec3(0.0, 0.0, 1.0), 2.0, u_15);
    s_1 = EnvironmentSample(_e6.direction, white);
    const bool _e12 = hasEnvironment;
    if (_e12) {
        EnvironmentSample _e13 = sampleEnvironment(u_15);
        s_1 = _e13;
    }
    vec3 _e15 = s_1.direction;
    vec3 _e18 = s_1.light.radiance;
    vec3 _e20 = s_1.direction;
    vec3 _e21 = sky(_e20);
    float _e25 = s_1.light.pdf;
    return LightSample(_e15, 1e30, (_e18 * _e21), _e25, false);
}

LightSample sampleEmitter(Emitter e_18, vec3 point_16, vec2 u_16) {
    LightSample s_2 = LightSample(vec3(0.0, 1.0, 0.0), 1e30, vec3(0.0), 0.0, true);
    const bool _e15 = hasSphereLights;
    if (_e15) {
        if ((e_18.kind == 0.0)) {
            LightSample _e19 = sampleSphere(e_18, point_16, u_16);
            s_2 = _e19;
        }
    }
    const bool _e21 = hasQuadLights;
    if (_e21) {
        if ((e_18.kind == 1.0)) {
            LightSample _e25 = sampleQuad(e_18, point_16, u_16);
            s_2 = _e25;
        }
    }
    const bool _e27 = hasBoxLights;
    if (_e27) {
        if ((e_18.kind == 2.0)) {
            LightSample _e31 = sampleBox(e_18, point_16, u_16);
            s_2 = _e31;
        }
    }
    const bool _e33 = hasMeshLamps;
    if (_e33) {
        if ((e_18.kind == 7.0)) {
            LightSample _e37 = sampleMesh(e_18, point_16, u_16);
            s_2 = _e37;
        }
    }
    const bool _e39 = hasPointLights;
    if (_e39) {
        if ((e_18.kind == 3.0)) {
            LightSample _e43 = samplePoint(e_18, point_16);
            s_2 = _e43;
        }
    }
    const bool _e45 = hasPointLights;
    if (_e45) {
        if ((e_18.kind == 4.0)) {
            LightSample _e49 = sampleSpot(e_18, point_16);
            s_2 = _e49;
        }
    }
    const bool _e51 = hasSuns;
    if (_e51) {
        if ((e_18.kind == 5.0)) {
            LightSample _e55 = sampleDirectional(e_18, u_16);
            s_2 = _e55;
        }
    }
    const bool _e57 = hasSky;
    if (_e57) {
        if ((e_18.kind == 6.0)) {
            LightSample _e61 = sampleSky(u_16);
            s_2 = _e61;
        }
    }
    float _e64 = s_2.pdf;
    float _e66 = s_2.distance_;
    s_2.pdf = pick((_e66 <= (1e-5 * length(point_16))), 0.0, _e64);
    LightSample _e73 = s_2;
    return _e73;
}

Bounds fetchBounds(uint i_10) {
    vec4 _e2 = tableTexel(0u, i_10);
    return Bounds(_e2.xyz, _e2.w);
}

float intersectSphere(vec3 origin_2, vec3 direction_2, vec3 center, float radius, float tMin, bool startsInside) {
    vec3 toCenter_1 = (center - origin_2);
    float along_2 = dot(toCenter_1, direction_2);
    vec3 across_3 = (toCenter_1 - (along_2 * direction_2));
    float discriminant = ((radius * radius) - dot(across_3, across_3));
    float half_ = sqrt(max(discriminant, 0.0));
    float near = (along_2 - half_);
    float far_4 = (along_2 + half_);
    float t_10 = pick((near > tMin), near, far_4);
    return pick(startsInside, max(far_4, 0.0), pick(pick((discriminant >= 0.0), (t_10 > tMin), false), t_10, 1e30));
}

PairHit meet(PairHit found, RayPair p_1, uint i_11, vec2 t_4) {
    bool own_3 = (i_11 == p_1.shape);
    float pathT = pick(pick(own_3, !(p_1.inwards), false), 1e30, t_4.x);
    float lightT = pick(pick(pick(own_3, !(p_1.lightInwards), false), true, (i_11 == p_1.lightShape)), 1e30, t_4.y);
    bool nearer_1 = (pathT < found.t);
    return PairHit(pick(nearer_1, pathT, found.t), pick(nearer_1, i_11, found.shape), pick(found.blocked, true, (lightT < p_1.lightDistance)), noTriangle, vec2(0.0));
}

PairHit meetSphere(PairHit found_1, RayPair p_2, uint i_12) {
    Bounds _e3 = fetchBounds(i_12);
    bool own_4 = (i_12 == p_2.shape);
    float _e13 = intersectSphere(p_2.point, p_2.direction, _e3.center, _e3.radius, p_2.tMin, pick(own_4, p_2.inwards, false));
    float _e21 = intersectSphere(p_2.point, p_2.lightDirection, _e3.center, _e3.radius, p_2.tMin, pick(own_4, p_2.lightInwards, false));
    PairHit _e23 = meet(found_1, p_2, i_12, vec2(_e13, _e21));
    return _e23;
}

vec3 turned(vec4 q_4, vec3 v_3) {
    vec3 w = vec3(0.0);
    w = v_3;
    const bool _e4 = hasTurnedBoxes;
    if (_e4) {
        vec3 _e5 = rotate(q_4, v_3);
        w = _e5;
    }
    vec3 _e6 = w;
    return _e6;
}

float intersectBox(vec3 origin_3, vec3 direction_3, vec3 halfSize_1, float tMin_1, bool startsInside_1) {
    Slabs _e5 = boxSlabs(origin_3, direction_3, halfSize_1);
    float t_11 = pick((_e5.near > tMin_1), _e5.near, _e5.far);
    return pick(startsInside_1, max(_e5.far, 0.0), pick(pick((_e5.near <= _e5.far), (t_11 > tMin_1), false), t_11, 1e30));
}

PairHit meetBox(PairHit found_2, RayPair p_3, uint i_13) {
    Bounds _e3 = fetchBounds(i_13);
    Extent _e4 = fetchExtent(i_13);
    bool own_5 = (i_13 == p_3.shape);
    vec3 _e11 = turned(_e4.a, (p_3.point - _e3.center));
    vec3 _e14 = turned(_e4.a, p_3.direction);
    float _e20 = intersectBox(_e11, _e14, _e4.b.xyz, p_3.tMin, pick(own_5, p_3.inwards, false));
    vec3 _e23 = turned(_e4.a, p_3.lightDirection);
    float _e29 = intersectBox(_e11, _e23, _e4.b.xyz, p_3.tMin, pick(own_5, p_3.lightInwards, false));
    PairHit _e31 = meet(found_2, p_3, i_13, vec2(_e20, _e29));
    return _e31;
}

float intersectQuad(vec3 origin_4, vec3 direction_4, vec3 center_1, vec3 reciprocalU, vec3 reciprocalV, float tMin_2) {
    vec3 normal_14 = cross(reciprocalU, reciprocalV);
    float speed = dot(direction_4, normal_14);
    vec3 toCenter_2 = (center_1 - origin_4);
    float t_12 = (dot(toCenter_2, normal_14) / pick((speed == 0.0), 1e-30, speed));
    vec3 p_10 = ((t_12 * direction_4) - toCenter_2);
    bool within_1 = (max(abs(dot(p_10, reciprocalU)), abs(dot(p_10, reciprocalV))) <= 0.500001);
    return pick(pick(pick((t_12 > tMin_2), (t_12 < 1e30), false), within_1, false), t_12, 1e30);
}

PairHit meetQuad(PairHit found_3, RayPair p_4, uint i_14) {
    Bounds _e3 = fetchBounds(i_14);
    Extent _e4 = fetchExtent(i_14);
    float _e13 = intersectQuad(p_4.point, p_4.direction, _e3.center, _e4.a.xyz, _e4.b.xyz, p_4.tMin);
    float _e22 = intersectQuad(p_4.point, p_4.lightDirection, _e3.center, _e4.a.xyz, _e4.b.xyz, p_4.tMin);
    PairHit _e24 = meet(found_3, p_4, i_14, vec2(_e13, _e22));
    return _e24;
}

float intersectPlane(vec3 origin_5, vec3 direction_5, vec3 normal_9, float offset, float tMin_3) {
    float speed_1 = dot(direction_5, normal_9);
    float t_13 = ((offset - dot(origin_5, normal_9)) / pick((speed_1 == 0.0), 1e-12, speed_1));
    float speedAway = pick((offset > 0.0), speed_1, -(speed_1));
    bool eitherWay = pick((t_13 > tMin_3), (abs(speed_1) > 1e-12), false);
    uint _e30 = frame.planesCutView;
    return pick(pick(pick((offset == 0.0), true, (_e30 != 0u)), eitherWay, (speedAway > 1e-12)), max(t_13, 0.0), 1e30);
}

PairHit meetPlane(PairHit found_4, RayPair p_5, uint i_15) {
    Bounds _e3 = fetchBounds(i_15);
    float _e9 = intersectPlane(p_5.point, p_5.direction, _e3.center, _e3.radius, p_5.tMin);
    float _e15 = intersectPlane(p_5.point, p_5.lightDirection, _e3.center, _e3.radius, p_5.tMin);
    PairHit _e17 = meet(found_4, p_5, i_15, vec2(_e9, _e15));
    return _e17;
}

bool isAmongInstances(uint reference) {
    return pick(pick((reference >= instances), (reference < leaves), false), (reference != unread), false);
}

SlabRay slabRay(vec3 origin_6, vec3 direction_6) {
    vec3 inverse_2 = (vec3(1.0) / mix(direction_6, vec3(1e-18), lessThan(abs(direction_6), vec3(1e-18))));
    return SlabRay(inverse_2, (-(origin_6) * inverse_2), (uvec3(0u, 1u, 2u) + (leastToGreatest * uvec3(lessThan(direction_6, vec3(0.0))))));
}

vec3 turnedTo(uint axis_2, vec3 v_4) {
    return pick((axis_2 == 0u), v_4.yzx, pick((axis_2 == 1u), v_4.zxy, v_4));
}

MeshRay meshRay(vec3 origin_7, vec3 direction_7) {
    vec3 size_4 = abs(direction_7);
    uint axis_5 = pick((size_4.z >= max(size_4.x, size_4.y)), 2u, pick((size_4.y > size_4.x), 1u, 0u));
    vec3 _e16 = turnedTo(axis_5, direction_7);
    return MeshRay(origin_7, axis_5, vec3((-(_e16.xy) / vec2(_e16.z)), (1.0 / _e16.z)));
}

vec4 larger(vec4 a_1, vec4 b_2) {
    return intBitsToFloat(max(floatBitsToInt(a_1), floatBitsToInt(b_2)));
}

vec4 planes(uint row_10, float inverse_, float offset_1) {
    uvec4 _e3 = geometryRow(row_10);
    return ((uintBitsToFloat(_e3) * inverse_) + vec4(offset_1));
}

vec4 smaller(vec4 a_2, vec4 b_3) {
    return intBitsToFloat(min(floatBitsToInt(a_2), floatBitsToInt(b_3)));
}

vec4 enterChildren(uint node_1, SlabRay r, float t_5) {
    uvec3 far_5 = (uvec3(3u, 5u, 7u) - r.near);
    vec4 _e16 = planes((node_1 + r.near.x), r.inverse_.x, r.offset.x);
    vec4 _e24 = planes((node_1 + r.near.y), r.inverse_.y, r.offset.y);
    vec4 _e25 = larger(_e16, _e24);
    vec4 _e33 = planes((node_1 + r.near.z), r.inverse_.z, r.offset.z);
    vec4 _e36 = larger(_e33, vec4(0.0));
    vec4 _e37 = larger(_e25, _e36);
    vec4 _e44 = planes((node_1 + far_5.x), r.inverse_.x, r.offset.x);
    vec4 _e51 = planes((node_1 + far_5.y), r.inverse_.y, r.offset.y);
    vec4 _e52 = smaller(_e44, _e51);
    vec4 _e59 = planes((node_1 + far_5.z), r.inverse_.z, r.offset.z);
    vec4 _e60 = smaller(_e52, _e59);
    vec4 _e66 = smaller((_e60 * 1.000001), vec4(t_5));
    return mix(vec4(1e30), _e37, lessThanEqual(_e37, _e66));
}

float edge(vec2 a_3, vec2 b_4) {
    float p_11 = (a_3.x * b_4.y);
    float q_7 = (a_3.y * b_4.x);
    return ((a_3.x * b_4.y + -(q_7)) - (a_3.y * b_4.x + -(p_11)));
}

bool isWithin(float u_17, float v_5, float w_1) {
    return pick(pick(pick((u_17 >= 0.0), (v_5 >= 0.0), false), (w_1 >= 0.0), false), true, pick(pick((u_17 <= 0.0), (v_5 <= 0.0), false), (w_1 <= 0.0), false));
}

Crossing crossTriangle(MeshRay ray, Triangle triangle) {
    vec3 _e6 = turnedTo(ray.axis, (triangle.a - ray.origin));
    vec3 _e11 = turnedTo(ray.axis, (triangle.b - ray.origin));
    vec3 _e16 = turnedTo(ray.axis, (triangle.c - ray.origin));
    vec2 pa = (_e6.xy + (_e6.z * ray.shear.xy));
    vec2 pb = (_e11.xy + (_e11.z * ray.shear.xy));
    vec2 pc = (_e16.xy + (_e16.z * ray.shear.xy));
    float _e35 = edge(pc, pb);
    float _e36 = edge(pa, pc);
    float _e37 = edge(pb, pa);
    float sum = ((_e35 + _e36) + _e37);
    float side_2 = pick((sum < 0.0), -1.0, 1.0);
    bool _e45 = isWithin(_e35, _e36, _e37);
    float depth = ((ray.shear.z * side_2) * (((_e35 * _e6.z) + (_e36 * _e11.z)) + (_e37 * _e16.z)));
    return Crossing(pick(_e45, (sum != 0.0), false), (sum * side_2), depth, (vec2(_e36, _e37) * side_2), ((sum * ray.shear.z) > 0.0));
}

float unitFloat(uint h_1) {
    return (float((h_1 >> 8u)) * 5.9604645e-8);
}

uint pcg(uint x_6) {
    uint s_5 = ((x_6 * 747796405u) + 2891336453u);
    uint w_3 = (((s_5 >> ((s_5 >> 28u) + 4u)) ^ s_5) * 277803737u);
    return ((w_3 >> 22u) ^ w_3);
}

bool isThere(uint instance, uint place, vec2 weights_1, uint number) {
    float opacity_1 = 0.0;
    uint _e6 = frame.instances;
    Instance _e10 = fetchInstance((_e6 + (instance * instanceRows)));
    Triangle _e15 = fetchTriangle((_e10.triangles + (place * triangleRows)));
    uint row_12 = (_e10.cover & coverRow);
    MaterialTextures _e19 = fetchMaterialTextures(row_12);
    Cover _e30 = coverAt((uvec3(_e10.vertices) + (uvec3(_e15.vertexA, _e15.vertexB, _e15.vertexC) * _e10.vertexRows)), _e10.vertexRows, weights_1);
    opacity_1 = (_e19.opacity * _e30.opacity);
    if (((_e19.flags & hasOpacityTexture) != 0u)) {
        TextureUse _e42 = fetchTextureUse((row_12 + materialTexturesRows));
        float _e43 = opacity_1;
        vec4 _e54 = lookUp(_e42, pick(((_e42.flags & usesSecondSet) != 0u), _e30.uv.zw, _e30.uv.xy));
        opacity_1 = (_e43 * _e54.w);
    }
    uint _e57 = pcg(number);
    uint _e59 = pcg((instance + _e57));
    uint _e61 = pcg((place + _e59));
    float _e62 = unitFloat(_e61);
    float _e63 = opacity_1;
    float _e66 = opacity_1;
    return pick((_e19.cutoff < 0.0), (_e62 < _e66), (_e63 >= _e19.cutoff));
}

MeshHit traverse(MeshRays rays, LeftTriangle left) {
    MeshHit found_5 = MeshHit(0.0, 0u, 0u, vec2(0.0), false);
    bool toLight_2 = false;
    float most = 0.0;
    uint instance_1 = noInstance;
    uint nodes = 0u;
    uint triangles = 0u;
    uint cover = 0u;
    uint own = placeMask;
    SlabRay slabs = SlabRay(vec3(0.0), vec3(0.0), uvec3(0u));
    MeshRay ray_1 = MeshRay(vec3(0.0), 0u, vec3(0.0));
    MeshHit doubted = MeshHit(0.0, 0u, 0u, vec2(0.0), false);
    uint top = 1u;
    uint current = 0u;
    uint waiting = noLeaf0_;
    vec3 o = vec3(0.0);
    vec3 d_1 = vec3(0.0);
    bool nearer = false;
    found_5 = MeshHit(rays.most, noInstance, 0u, vec2(0.0), false);
    toLight_2 = !((rays.most > 0.0));
    bool _e17 = toLight_2;
    most = pick(_e17, rays.lightMost, rays.most);
    MeshHit _e45 = found_5;
    doubted = _e45;
    uint _e49 = frame.instanceCount;
    bool alone = (_e49 == 1u);
    uint first_2 = pick(alone, instances, beginning);
    uint _e57 = frame.instanceCount;
    float _e60 = most;
    if (pick((_e57 == 0u), true, !((_e60 > 0.0)))) {
        MeshHit _e65 = found_5;
        return _e65;
    }
    stack[0] = ending;
    current = first_2;
    while(true) {
        const bool _e75 = hasCutouts;
        uint _e77 = waiting;
        uint _e80 = current;
        bool _e81 = isAmongInstances(_e80);
        if (pick(!(_e75), true, pick((_e77 == noLeaf0_), _e81, false))) {
            uint _e84 = current;
            bool toWorld = (_e84 >= beginning);
            uint _e87 = current;
            instance_1 = pick(toWorld, noInstance, (_e87 & placeMask));
            o = rays.origin;
            bool _e96 = toLight_2;
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
            ray_1 = _e154;
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
                ivec4 t_14 = floatBitsToInt(_e184);
                bool a_6 = (t_14.x < t_14.z);
                bool b_6 = (t_14.y < t_14.w);
                uvec2 r0_ = pick(a_6, uvec2(_e181.z, _e181.x), uvec2(_e181.x, _e181.z));
                uvec2 r1_ = pick(b_6, uvec2(_e181.w, _e181.y), uvec2(_e181.y, _e181.w));
                int far0_ = max(t_14.x, t_14.z);
                int far1_ = max(t_14.y, t_14.w);
                int near0_ = min(t_14.x, t_14.z);
                int near1_ = min(t_14.y, t_14.w);
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
                uint place_6 = (_e302 & placeMask);
                uint _e305 = waiting;
                waiting = ((_e305 + 1u) - 268435456u);
                uint _e310 = waiting;
                uint _e312 = waiting;
                waiting = pick((_e312 < leaves), noLeaf0_, _e310);
                MeshRay _e316 = ray_1;
                uint _e317 = triangles;
                Triangle _e321 = fetchTriangle((_e317 + (place_6 * triangleRows)));
                Crossing _e322 = crossTriangle(_e316, _e321);
                float _e331 = most;
                uint _e336 = own;
                nearer = pick(pick(pick(_e322.within, (_e322.depth > (rays.least * _e322.sum)), false), (_e322.depth < (_e331 * _e322.sum)), false), (place_6 != _e336), false);
                const bool _e341 = hasOneSided;
                if (_e341) {
                    bool _e342 = nearer;
                    uint _e344 = cover;
                    nearer = pick(_e342, pick(_e322.front, true, ((_e344 & isOneSided) == 0u)), false);
                }
                float inverse_3 = (1.0 / _e322.sum);
                float t_15 = (_e322.depth * inverse_3);
                vec2 weights_3 = (_e322.weights * inverse_3);
                const bool _e359 = hasCutouts;
                if (_e359) {
                    bool _e360 = nearer;
                    uint _e361 = cover;
                    if (pick(_e360, ((_e361 & coverRow) != 0u), false)) {
                        uint _e367 = instance_1;
                        doubted = MeshHit(t_15, _e367, place_6, weights_3, false);
                        nearer = false;
                    }
                }
                bool _e371 = nearer;
                bool _e372 = toLight_2;
                bool blocks = pick(_e371, _e372, false);
                bool _e374 = nearer;
                bool _e375 = toLight_2;
                bool counts = pick(_e374, !(_e375), false);
                float _e378 = most;
                bool _e379 = nearer;
                most = pick(_e379, t_15, _e378);
                float _e383 = found_5.t;
                found_5.t = pick(counts, t_15, _e383);
                uint _e387 = found_5.instance;
                uint _e388 = instance_1;
                found_5.instance = pick(counts, _e388, _e387);
                uint _e392 = found_5.triangle;
                found_5.triangle = pick(counts, place_6, _e392);
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
                bool _e435 = toLight_2;
                bool _e438 = isThere(_e429, _e431, _e433, (rays.number + uint(_e435)));
                MeshHit instead = doubted;
                doubted.instance = noInstance;
                bool _e442 = toLight_2;
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
        bool _e454 = toLight_2;
        if (pick(ended, pick(_e454, true, !((rays.lightMost > 0.0))), false)) {
            break;
        }
        bool _e461 = toLight_2;
        toLight_2 = pick(_e461, true, ended);
        float _e463 = most;
        most = pick(ended, rays.lightMost, _e463);
        uint _e466 = top;
        top = pick(ended, 1u, _e466);
        uint _e469 = current;
        current = pick(ended, first_2, _e469);
    }
    MeshHit _e471 = found_5;
    return _e471;
}

uint rowOfInstance(uint instance_2) {
    uint _e3 = frame.instances;
    Instance _e7 = fetchInstance((_e3 + (instance_2 * instanceRows)));
    return _e7.row;
}

PairHit meetMeshes(PairHit found_6, RayPair p_6) {
    PairHit result = PairHit(0.0, 0u, false, LeftTriangle(0u, 0u), vec2(0.0));
    float most_1 = pick(p_6.goesOn, found_6.t, -1.0);
    float lightMost = pick(found_6.blocked, -1.0, p_6.lightDistance);
    MeshHit _e17 = traverse(MeshRays(p_6.point, p_6.direction, p_6.lightDirection, p_6.tMin, most_1, lightMost, p_6.number), p_6.left);
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

PairHit tracePair(RayPair p_7) {
    PairHit found_7 = PairHit(1e30, 4294967295u, false, LeftTriangle(4294967295u, 0u), vec2(0.0));
    uint i_16 = 0u;
    uvec4 ends_3 = frame.shapeEnds;
    const bool _e17 = hasSpheres;
    if (_e17) {
        uint _e18 = i_16;
        if ((_e18 < ends_3.x)) {
            while(true) {
                PairHit _e21 = found_7;
                uint _e22 = i_16;
                PairHit _e23 = meetSphere(_e21, p_7, _e22);
                found_7 = _e23;
                uint _e25 = i_16;
                i_16 = (_e25 + 1u);
                uint _e27 = i_16;
                if ((_e27 >= ends_3.x)) {
                    break;
                }
            }
        }
    }
    const bool _e31 = hasBoxes;
    if (_e31) {
        uint _e32 = i_16;
        if ((_e32 < ends_3.y)) {
            while(true) {
                PairHit _e35 = found_7;
                uint _e36 = i_16;
                PairHit _e37 = meetBox(_e35, p_7, _e36);
                found_7 = _e37;
                uint _e39 = i_16;
                i_16 = (_e39 + 1u);
                uint _e41 = i_16;
                if ((_e41 >= ends_3.y)) {
                    break;
                }
            }
        }
    }
    const bool _e45 = hasQuads;
    if (_e45) {
        uint _e46 = i_16;
        if ((_e46 < ends_3.z)) {
            while(true) {
                PairHit _e49 = found_7;
                uint _e50 = i_16;
                PairHit _e51 = meetQuad(_e49, p_7, _e50);
                found_7 = _e51;
                uint _e53 = i_16;
                i_16 = (_e53 + 1u);
                uint _e55 = i_16;
                if ((_e55 >= ends_3.z)) {
                    break;
                }
            }
        }
    }
    const bool _e59 = hasPlanes;
    if (_e59) {
        uint _e60 = i_16;
        if ((_e60 < ends_3.w)) {
            while(true) {
                PairHit _e63 = found_7;
                uint _e64 = i_16;
                PairHit _e65 = meetPlane(_e63, p_7, _e64);
                found_7 = _e65;
                uint _e67 = i_16;
                i_16 = (_e67 + 1u);
                uint _e69 = i_16;
                if ((_e69 >= ends_3.w)) {
                    break;
                }
            }
        }
    }
    const bool _e73 = hasMeshes;
    if (_e73) {
        PairHit _e74 = found_7;
        PairHit _e75 = meetMeshes(_e74, p_7);
        found_7 = _e75;
    }
    PairHit _e76 = found_7;
    return _e76;
}

RayPair oneRay(vec3 origin_8, vec3 direction_8, uint number_1) {
    return RayPair(origin_8, noShape, noTriangle, 0.0, true, direction_8, false, direction_8, false, -1.0, noShape, number_1);
}

vec3 fromOctahedral(uint code) {
    vec2 p_13 = ((vec2(float((code & 65535u)), float((code >> 16u))) * 3.051851e-5) - vec2(1.0));
    float z_4 = ((1.0 - abs(p_13.x)) - abs(p_13.y));
    vec2 folded = ((vec2(1.0) - abs(p_13.yx)) * mix(vec2(1.0), vec2(-1.0), lessThan(p_13, vec2(0.0))));
    return normalize(vec3(pick((z_4 < 0.0), folded, p_13), z_4));
}

MeshPoint meshPoint(uint instance_3, uint place_1, vec2 weights_2) {
    MeshPoint p_8 = MeshPoint(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec4(0.0), vec4(0.0));
    uint _e5 = frame.instances;
    Instance _e9 = fetchInstance((_e5 + (instance_3 * instanceRows)));
    Triangle _e14 = fetchTriangle((_e9.triangles + (place_1 * triangleRows)));
    mat3x3 turn_1 = mat3x3(_e9.toMeshX.xyz, _e9.toMeshY.xyz, _e9.toMeshZ.xyz);
    vec3 geometric = normalize((turn_1 * cross((_e14.b - _e14.a), (_e14.c - _e14.a))));
    p_8 = MeshPoint(geometric, geometric, vec3(0.0), vec3(0.0), geometric, vec4(0.0), vec4(1.0));
    if ((_e9.vertexRows != 0u)) {
        uvec3 rows_2 = (uvec3(_e9.vertices) + (uvec3(_e14.vertexA, _e14.vertexB, _e14.vertexC) * _e9.vertexRows));
        Vertex _e54 = fetchVertex(rows_2.x);
        Vertex _e56 = fetchVertex(rows_2.y);
        Vertex _e58 = fetchVertex(rows_2.z);
        vec3 share_5 = vec3(((1.0 - weights_2.x) - weights_2.y), weights_2);
        vec3 _e67 = fromOctahedral(_e54.normal);
        vec3 _e71 = fromOctahedral(_e56.normal);
        vec3 _e76 = fromOctahedral(_e58.normal);
        vec3 normal_15 = (((share_5.x * _e67) + (share_5.y * _e71)) + (share_5.z * _e76));
        vec3 smoothed = (turn_1 * normal_15);
        float size_5 = dot(smoothed, smoothed);
        float side_3 = pick((dot(smoothed, geometric) < 0.0), -1.0, 1.0);
        bool useful = pick(((_e9.vertexFlags & hasNormals) != 0u), (size_5 > 0.0), false);
        p_8.shading = pick(useful, (smoothed * (side_3 * inversesqrt(max(size_5, 1e-37)))), geometric);
        const bool _e103 = hasTextures;
        if (_e103) {
            p_8.uv = vec4((((share_5.x * _e54.uv) + (share_5.y * _e56.uv)) + (share_5.z * _e58.uv)), 0.0, 0.0);
            const bool _e120 = hasVertexMore;
            if (_e120) {
                if ((_e9.vertexRows > vertexRows)) {
                    VertexMore _e127 = fetchVertexMore((rows_2.x + vertexRows));
                    VertexMore _e131 = fetchVertexMore((rows_2.y + vertexRows));
                    VertexMore _e135 = fetchVertexMore((rows_2.z + vertexRows));
                    vec4 _e138 = p_8.uv;
                    p_8.uv = vec4(_e138.xy, (((share_5.x * _e127.uv) + (share_5.y * _e131.uv)) + (share_5.z * _e135.uv)));
                    vec2 _e154 = pairOf(_e127.redGreen);
                    vec2 _e158 = pairOf(_e131.redGreen);
                    vec2 _e163 = pairOf(_e135.redGreen);
                    vec2 redGreen = (((share_5.x * _e154) + (share_5.y * _e158)) + (share_5.z * _e163));
                    vec2 _e168 = pairOf(_e127.blueAlpha);
                    vec2 _e172 = pairOf(_e131.blueAlpha);
                    vec2 _e177 = pairOf(_e135.blueAlpha);
                    vec2 blueAlpha = (((share_5.x * _e168) + (share_5.y * _e172)) + (share_5.z * _e177));
                    p_8.color = clamp(vec4(redGreen, blueAlpha), vec4(0.0), vec4(1.0));
                }
            }
            const bool _e188 = hasNormalMaps;
            if (_e188) {
                if (pick(useful, ((_e9.vertexFlags & hasTangents) != 0u), false)) {
                    vec3 _e197 = fromOctahedral(_e54.tangent);
                    vec3 _e201 = fromOctahedral(_e56.tangent);
                    vec3 _e206 = fromOctahedral(_e58.tangent);
                    vec3 tangent = (((share_5.x * _e197) + (share_5.y * _e201)) + (share_5.z * _e206));
                    float hand = pick(((_e54.tangent & 65536u) != 0u), -1.0, 1.0);
                    p_8.normal = (smoothed * side_3);
                    p_8.tangent = ((turn_1 * tangent) * side_3);
                    p_8.bitangent = ((turn_1 * cross(normal_15, tangent)) * (hand * side_3));
                }
            }
        }
    }
    MeshPoint _e227 = p_8;
    return _e227;
}

uint emitterOfTriangle(Emitter e_19, LeftTriangle t_6) {
    return (((t_6.instance - uint(e_19.instance)) * uint(e_19.cosInner)) + (t_6.triangle >> uint(e_19.radius)));
}

float spherePdf(Emitter e_20, vec3 point_17, vec3 direction_9) {
    SphereView _e3 = viewSphere(e_20, point_17);
    bool reached_1 = pick(_e3.inside, true, (dot(direction_9, _e3.toCenter) > 0.0));
    float _e11 = conePdf(_e3.width);
    return pick(reached_1, _e11, 0.0);
}

float quadPdf(Emitter e_21, vec3 point_18, float distance_2) {
    QuadView _e3 = viewQuad(e_21, point_18);
    float _e5 = pdfOfView(_e3, e_21.area, distance_2);
    return _e5;
}

float boxPdf(Emitter e_22, vec3 point_19, vec3 direction_10, float distance_3, vec3 normal_10) {
    BoxView _e5 = viewBox(e_22, point_19);
    float _e10 = areaPdf(_e5.area, (distance_3 * abs(dot(direction_10, normal_10))), distance_3);
    float _e12 = conePdf(2.0);
    return pick(_e5.inside, _e12, _e10);
}

float meshPdf(Emitter e_23, vec3 direction_11, float distance_4, vec3 normal_11, uint place_2) {
    uint _e7 = frame.lampTables;
    uint row_13 = ((_e7 + uint(e_23.table)) + (place_2 & ((1u << uint(e_23.radius)) - 1u)));
    float _e23 = areaPdf(e_23.area, (distance_4 * abs(dot(direction_11, normal_11))), distance_4);
    LampTriangle _e24 = fetchLampTriangle(row_13);
    return (_e23 * _e24.density);
}

float shapePdf(Emitter e_24, vec3 point_20, vec3 direction_12, float distance_5, vec3 normal_12, uint place_3) {
    float pdf = 0.0;
    const bool _e9 = hasSphereLights;
    if (_e9) {
        if ((e_24.kind == 0.0)) {
            float _e13 = spherePdf(e_24, point_20, direction_12);
            pdf = _e13;
        }
    }
    const bool _e15 = hasQuadLights;
    if (_e15) {
        if ((e_24.kind == 1.0)) {
            float _e19 = quadPdf(e_24, point_20, distance_5);
            pdf = _e19;
        }
    }
    const bool _e21 = hasBoxLights;
    if (_e21) {
        if ((e_24.kind == 2.0)) {
            float _e25 = boxPdf(e_24, point_20, direction_12, distance_5, normal_12);
            pdf = _e25;
        }
    }
    const bool _e27 = hasMeshLamps;
    if (_e27) {
        if ((e_24.kind == 7.0)) {
            float _e31 = meshPdf(e_24, direction_12, distance_5, normal_12, place_3);
            pdf = _e31;
        }
    }
    float _e32 = pdf;
    return _e32;
}

Start onSurface(vec3 point_21, uint shape, bool seenFromInside) {
    return Start(point_21, pick(seenFromInside, noShape, shape), pick(seenFromInside, shape, noShape), (1e-5 * length(point_21)));
}

bool isSphere(uint i_17) {
    uint _e4 = frame.shapeEnds.x;
    return (i_17 < _e4);
}

float hitSphere(uint i_18, Bounds bounds, Ray ray_2) {
    float _e13 = intersectSphere(ray_2.start.point, ray_2.direction, bounds.center, bounds.radius, ray_2.start.tMin, (i_18 == ray_2.start.inside));
    return pick((i_18 == ray_2.start.leaves), 1e30, _e13);
}

bool isBox(uint i_19) {
    uint _e4 = frame.shapeEnds.x;
    uint _e9 = frame.shapeEnds.y;
    return pick((i_19 >= _e4), (i_19 < _e9), false);
}

bool isTurned(vec4 q_5) {
    return any(notEqual(q_5.xyz, vec3(0.0)));
}

float hitBox(uint i_20, Bounds bounds_1, Ray ray_3) {
    vec3 origin_9 = vec3(0.0);
    vec3 direction_13 = vec3(0.0);
    Extent _e3 = fetchExtent(i_20);
    origin_9 = (ray_3.start.point - bounds_1.center);
    direction_13 = ray_3.direction;
    bool _e12 = isTurned(_e3.a);
    if (_e12) {
        vec3 _e14 = origin_9;
        vec3 _e15 = rotate(_e3.a, _e14);
        origin_9 = _e15;
        vec3 _e17 = direction_13;
        vec3 _e18 = rotate(_e3.a, _e17);
        direction_13 = _e18;
    }
    vec3 _e19 = origin_9;
    vec3 _e20 = direction_13;
    float _e28 = intersectBox(_e19, _e20, _e3.b.xyz, ray_3.start.tMin, (i_20 == ray_3.start.inside));
    return pick((i_20 == ray_3.start.leaves), 1e30, _e28);
}

bool isQuad0_(uint i_21) {
    uint _e4 = frame.shapeEnds.z;
    return (i_21 < _e4);
}

float hitQuad(uint i_22, Bounds bounds_2, Ray ray_4) {
    Extent _e3 = fetchExtent(i_22);
    float _e14 = intersectQuad(ray_4.start.point, ray_4.direction, bounds_2.center, _e3.a.xyz, _e3.b.xyz, ray_4.start.tMin);
    return pick((i_22 == ray_4.start.leaves), 1e30, _e14);
}

float hitPlane(uint i_23, Bounds bounds_3, Ray ray_5) {
    float _e10 = intersectPlane(ray_5.start.point, ray_5.direction, bounds_3.center, bounds_3.radius, ray_5.start.tMin);
    return pick((i_23 == ray_5.start.leaves), 1e30, _e10);
}

float hitShape(uint i_24, Bounds bounds_4, Ray ray_6) {
    bool _e3 = isSphere(i_24);
    if (_e3) {
        float _e4 = hitSphere(i_24, bounds_4, ray_6);
        return _e4;
    }
    bool _e5 = isBox(i_24);
    if (_e5) {
        float _e6 = hitBox(i_24, bounds_4, ray_6);
        return _e6;
    }
    bool _e7 = isQuad0_(i_24);
    if (_e7) {
        float _e8 = hitQuad(i_24, bounds_4, ray_6);
        return _e8;
    }
    float _e9 = hitPlane(i_24, bounds_4, ray_6);
    return _e9;
}

bool isPlane(uint i_25) {
    uint _e4 = frame.shapeEnds.z;
    uint _e9 = frame.shapeEnds.w;
    return pick((i_25 >= _e4), (i_25 < _e9), false);
}

bool isFlat(uint i_26) {
    uint _e4 = frame.shapeEnds.y;
    return (i_26 >= _e4);
}

vec3 boxNormal(vec3 origin_10, vec3 direction_14, vec3 halfSize_2, float tMin_4, bool startsInside_2) {
    Slabs _e5 = boxSlabs(origin_10, direction_14, halfSize_2);
    bool entering = pick((_e5.near > tMin_4), !(startsInside_2), false);
    vec3 crossed = pick(entering, _e5.enter, _e5.leave);
    float t_16 = pick(entering, _e5.near, _e5.far);
    vec3 side_4 = (pick(entering, -1.0, 1.0) * mix(vec3(-1.0), vec3(1.0), greaterThan(direction_14, vec3(0.0))));
    bool onX_1 = (crossed.x == t_16);
    bool onY_1 = pick(!(onX_1), (crossed.y == t_16), false);
    return (side_4 * mix(vec3(0.0), vec3(1.0), bvec3(onX_1, onY_1, !(pick(onX_1, true, onY_1)))));
}

vec3 outwardNormal(uint i_27, Ray ray_7, float t_7) {
    Bounds _e3 = fetchBounds(i_27);
    vec3 origin_11 = (ray_7.start.point - _e3.center);
    bool _e8 = isSphere(i_27);
    if (_e8) {
        return normalize((origin_11 + (t_7 * ray_7.direction)));
    }
    bool _e13 = isPlane(i_27);
    if (_e13) {
        return _e3.center;
    }
    Extent _e15 = fetchExtent(i_27);
    bool _e16 = isFlat(i_27);
    if (_e16) {
        return normalize(cross(_e15.a.xyz, _e15.b.xyz));
    }
    bool inside_3 = (i_27 == ray_7.start.inside);
    vec3 _e27 = rotate(_e15.a, origin_11);
    vec3 _e30 = rotate(_e15.a, ray_7.direction);
    vec3 _e35 = boxNormal(_e27, _e30, _e15.b.xyz, ray_7.start.tMin, inside_3);
    vec3 _e37 = rotateBack(_e15.a, _e35);
    return _e37;
}

bool isOnDisc(Emitter e_25, vec3 direction_15) {
    vec3 chord = (direction_15 + e_25.u);
    return ((3.1415927 * dot(chord, chord)) < e_25.area);
}

float directionalPdf(Emitter e_26, vec3 direction_16) {
    bool _e7 = isOnDisc(e_26, direction_16);
    return pick(_e7, (1.0 / max(e_26.area, 1e-31)), 0.0);
}

FarLight farLight(Emitter e_27, vec3 direction_17, FarLight sky_1) {
    FarLight far_2 = FarLight(vec3(0.0), 0.0);
    const bool _e9 = hasSuns;
    if (_e9) {
        bool _e13 = isOnDisc(e_27, direction_17);
        bool seen_1 = pick((e_27.kind == 5.0), _e13, false);
        float _e19 = directionalPdf(e_27, direction_17);
        far_2 = FarLight(pick(seen_1, e_27.radiance, vec3(0.0)), pick(seen_1, _e19, 0.0));
    }
    const bool _e24 = hasSky;
    if (_e24) {
        if ((e_27.kind == 6.0)) {
            far_2 = sky_1;
        }
    }
    FarLight _e28 = far_2;
    return _e28;
}

vec2 quadrantAngles(vec2 x_7, vec2 y_2) {
    vec2 low_5 = min(x_7, y_2);
    vec2 high_3 = max(x_7, y_2);
    bvec2 middle_3 = greaterThan(low_5, (0.41421357 * high_3));
    vec2 r_3 = (mix(low_5, (low_5 - high_3), middle_3) / max(mix(high_3, (low_5 + high_3), middle_3), vec2(1e-30)));
    vec2 z_5 = (r_3 * r_3);
    vec2 series_1 = ((((((0.080537446 * z_5) - vec2(0.13877685)) * z_5) + vec2(0.19977711)) * z_5) - vec2(0.3333295));
    vec2 angle = (mix(vec2(0.0), vec2(0.7853982), middle_3) + (((series_1 * z_5) * r_3) + r_3));
    return mix(angle, (vec2(1.5707964) - angle), greaterThan(y_2, x_7));
}

EnvironmentLight lookUpEnvironment(vec3 direction_18) {
    vec2 size_6 = frame.environmentSize;
    float sine_5 = max(length(direction_18.xz), 1e-9);
    vec2 _e15 = quadrantAngles(abs(vec2(direction_18.z, direction_18.y)), vec2(abs(direction_18.x), sine_5));
    float turn_2 = (pick((direction_18.z > 0.0), (3.1415927 - _e15.x), _e15.x) * pick((direction_18.x < 0.0), -1.0, 1.0));
    float _e35 = frame.environmentTurn;
    float column_3 = ((fract(((turn_2 * 0.15915494) + _e35)) * size_6.x) + 0.5);
    float fromPole_1 = ((_e15.y * (size_6.y / 3.1415927)) + 0.5);
    float row_14 = floor(fromPole_1);
    bool isLower_1 = (direction_18.y < 0.0);
    vec2 cell_2 = vec2(floor(column_3), pick(isLower_1, (size_6.y - row_14), row_14));
    float within_2 = (fromPole_1 - row_14);
    vec2 at_4 = vec2((column_3 - cell_2.x), pick(isLower_1, (1.0 - within_2), within_2));
    Corners _e66 = environmentCorners(uvec2(cell_2));
    EnvironmentLight _e67 = lightWithin(_e66, at_4, sine_5);
    return _e67;
}

EnvironmentLight skyLight(vec3 direction_19) {
    EnvironmentLight light = white;
    const bool _e4 = hasEnvironment;
    if (_e4) {
        EnvironmentLight _e5 = lookUpEnvironment(direction_19);
        light = _e5;
    }
    vec3 _e7 = light.radiance;
    vec3 _e8 = sky(direction_19);
    float _e11 = light.pdf;
    return EnvironmentLight((_e7 * _e8), _e11);
}

FarLight skySeen(vec3 direction_20) {
    FarLight far_3 = FarLight(vec3(0.0), 0.0);
    const bool _e7 = hasSky;
    if (_e7) {
        EnvironmentLight _e8 = skyLight(direction_20);
        far_3 = FarLight(_e8.radiance, _e8.pdf);
    }
    FarLight _e12 = far_3;
    return _e12;
}

void main() {
    vec4 fragment = gl_FragCoord;
    float t = 1e30;
    vec3 normal = vec3(0.0);
    uvec2 pixel = uvec2(fragment.xy);
    vec4 a_7 = texelFetch(questions, ivec2(uvec2((3u * pixel.x), pixel.y)), 0);
    vec4 b_7 = texelFetch(questions, ivec2(uvec2(((3u * pixel.x) + 1u), pixel.y)), 0);
    vec4 c_4 = texelFetch(questions, ivec2(uvec2(((3u * pixel.x) + 2u), pixel.y)), 0);
    uint question = uint(b_7.w);
    uint index = uint(a_7.w);
    if ((question == choice_2)) {
        EmitterChoice _e40 = chooseEmitter(a_7.xyz, c_4.xyz, b_7.x);
        Emitter _e42 = fetchEmitter(_e40.index);
        float _e46 = probabilityOf(_e42, a_7.xyz, c_4.xyz, _e40.odds);
        Emitter _e50 = fetchEmitter(index);
        float _e54 = probabilityOf(_e50, a_7.xyz, c_4.xyz, _e40.odds);
        _fs2p_location0 = vec4(float(_e40.index), _e40.probability, _e46, _e54);
        return;
    }
    Emitter _e56 = fetchEmitter(index);
    LightSample _e59 = sampleEmitter(_e56, a_7.xyz, b_7.xy);
    if ((question == directionAndPdf)) {
        _fs2p_location0 = vec4(_e59.direction, _e59.pdf);
        return;
    }
    if ((question == radianceAndDistance)) {
        _fs2p_location0 = vec4(_e59.radiance, _e59.distance_);
        return;
    }
    vec3 direction_23 = pick((question == pdfOfSample), _e59.direction, c_4.xyz);
    if ((_e56.kind == 7.0)) {
        RayPair _e85 = oneRay(a_7.xyz, direction_23, 0u);
        PairHit _e86 = tracePair(_e85);
        if ((_e86.triangle.instance == noInstance)) {
            _fs2p_location0 = vec4(0.0, 1e30, _e59.pdf, float(_e59.delta));
            return;
        }
        MeshPoint _e102 = meshPoint(_e86.triangle.instance, _e86.triangle.triangle, _e86.weights);
        normal = _e102.geometric;
        uint _e105 = emitterOfTriangle(_e56, _e86.triangle);
        Emitter _e107 = fetchEmitter((index + _e105));
        vec3 _e110 = normal;
        float _e113 = shapePdf(_e107, a_7.xyz, direction_23, _e86.t, _e110, _e86.triangle.triangle);
        _fs2p_location0 = vec4(_e113, _e86.t, _e59.pdf, float(_e59.delta));
        return;
    }
    if ((_e56.shape >= 0.0)) {
        uint shape_1 = uint(_e56.shape);
        Start _e127 = onSurface(a_7.xyz, noShape, false);
        Ray ray_8 = Ray(_e127, direction_23);
        Bounds _e129 = fetchBounds(shape_1);
        float _e130 = hitShape(shape_1, _e129, ray_8);
        t = _e130;
        float _e131 = t;
        vec3 _e134 = outwardNormal(shape_1, ray_8, min(_e131, 1e30));
        normal = _e134;
        float _e135 = t;
        if ((_e135 >= 1e30)) {
            _fs2p_location0 = vec4(0.0, 1e30, _e59.pdf, float(_e59.delta));
            return;
        }
    }
    FarLight _e144 = skySeen(direction_23);
    FarLight _e145 = farLight(_e56, direction_23, _e144);
    float _e147 = t;
    vec3 _e148 = normal;
    float _e150 = shapePdf(_e56, a_7.xyz, direction_23, _e147, _e148, 0u);
    float _e153 = t;
    _fs2p_location0 = vec4((_e150 + _e145.pdf), _e153, length(_e145.radiance), float(_e59.delta));
    return;
}

