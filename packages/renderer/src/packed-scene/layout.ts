/**
 * The one definition of what lies where on the GPU. `npm run shaders` writes the WGSL structs and fetch functions from it
 * (`shading/layout.wesl`, `shading/scene_table.wesl`), and `write-struct.ts` places numbers by it; no byte offset is written
 * by hand anywhere.
 *
 * The scene lies in a table of RGBA float texels, a texture that both GPU interfaces read alike: row i holds shape i, its
 * material, light i and emitter i; below lie the tree over lights and the layers of the materials that have some. (Uniform blocks were
 * tried: Windows' shader compiler takes twice as long over large ones.)
 * What belongs to the frame lies in small uniform blocks. Triangles and the trees over them lie in rows of four words, the geometry:
 * a storage buffer or a texture, whichever the device has.
 *
 * Positions are relative to the camera's eye: subtracted in double precision while packing, so that a small scene far
 * from the origin keeps its precision on a GPU that has only 32-bit floats.
 */
export const PANELS = 3;
/** Pieces of the curve that makes random numbers into places under the pixel filter: see pack-filter.ts. */
export const FILTER_PIECES = 16;

export type FieldType = 'f32' | 'u32' | 'vec2u' | 'vec2f' | 'vec3f' | 'vec4f' | 'vec4u' | FieldArray;
export interface FieldArray {
  readonly array: 'vec4f' | 'vec4u';
  readonly length: number;
}
type Fields = Readonly<Record<string, { type: FieldType; doc: string }>>;

const field = (type: FieldType, doc: string) => ({ type, doc });

export const STRUCTS = {
  Bounds: {
    center: field('vec3f', 'centre of the bounding sphere, eye-relative; of a plane: its unit normal'),
    radius: field('f32', 'of the bounding sphere; of a plane: dot(normal, p) of its points'),
  },
  Extent: {
    a: field('vec4f', 'box: rotation from world to box as a quaternion (x, y, z, w); quad: reciprocal of its u edge'),
    b: field('vec4f', 'box: half its size; quad: reciprocal of its v edge'),
  },
  Material: {
    baseColor: field('vec3f', 'share of light that comes back'),
    reflectivity: field('f32', 'weight of the mirror ray'),
    specular: field('f32', 'strength of the highlight'),
    exponent: field('f32', 'Blinn-Phong exponent, 2 / roughness^4 - 2'),
    id: field('f32', 'number of the shape in the order of the scene file, from 1'),
    spare: field('f32', 'unused'),
  },
  Light: {
    center: field('vec3f', 'eye-relative'),
    radius: field('f32', 'of the ball'),
    ambient: field('vec3f', 'added everywhere'),
    spare0: field('f32', 'unused'),
    diffuse: field('vec3f', 'colour of the diffuse part'),
    power: field('f32', 'radiance times radius^2: w = power / distance^2'),
    specular: field('vec3f', 'colour of the highlight'),
    spare1: field('f32', 'unused'),
  },
  /** A light as the classic integrator's camera and mirrors see it. Begins as Bounds do, so that rays meet it as a sphere. */
  Ball: {
    center: field('vec3f', 'eye-relative'),
    radius: field('f32', 'of the ball'),
    diffuse: field('vec3f', 'colour of the diffuse part'),
    halo: field('f32', 'density of the haze times radiance times radius^2'),
    radiance: field('f32', 'of the ball'),
    spare0: field('f32', 'unused'),
    spare1: field('f32', 'unused'),
    spare2: field('f32', 'unused'),
  },
  Surface: {
    baseColor: field(
      'vec3f',
      'Lambert albedo; glTF base colour; constant Fresnel reflectance of a conductor without eta and k',
    ),
    code: field(
      'f32',
      'kind (0 diffuse, 1 metallicRoughness, 2 conductor, 3 dielectric) + 4 thin + 8 energyCompensation + 16 one-sided lamp + 32 smooth + 64 separable masking + 128 times one more than the index of the emitter that this shape is, 0: none',
    ),
    emission: field('vec3f', 'radiance sent out'),
    reflectivity: field('f32', 'share of the perfect mirror layer over the base'),
    eta: field(
      'vec3f',
      'conductor: index of refraction per channel; dielectric: the index in all three; metallicRoughness: in x the row of the table with its Layers, with a minus sign when light may go through; 0: there are none',
    ),
    alpha: field('f32', 'GGX width, roughness^2; 0: smooth'),
    k: field('vec3f', 'conductor: extinction coefficient per channel'),
    metallic: field('f32', 'metallicRoughness: share of metal'),
    absorption: field('vec3f', 'dielectric: Beer-Lambert coefficient, 1 / metre'),
    textures: field('f32', 'row of its MaterialTextures among the texels'),
  },
  Layers: {
    specularColor: field('vec3f', 'factor on what facets of the dielectric reflect at normal incidence'),
    specularWeight: field('f32', 'share of what they reflect'),
    sheenColor: field('vec3f', 'of the fibres on top; black: there are none'),
    sheenRoughness: field('f32', 'alpha is its square'),
    beyondColor: field('vec3f', 'factor on light that leaves diffusely on the other side'),
    beyond: field('f32', 'share of the diffuse light that does'),
    grain: field(
      'vec2f',
      'cosine and sine of the angle from the tangent to the direction that highlights are drawn out in',
    ),
    anisotropy: field('f32', 'how much they are; 0: not'),
    transmission: field('f32', 'share of the diffuse body that is a refracting boundary instead'),
    coat: field('f32', 'share of the surface that has a clear coat'),
    coatRoughness: field('f32', 'alpha is its square'),
    ior: field('f32', 'index of the body'),
    solid: field('f32', '1: the body is solid; 0: a thin wall'),
    film: field('f32', 'share of the surface that has a thin film'),
    filmIor: field('f32', 'its index'),
    filmThickness: field('f32', 'nanometres; where a texture says how thick: where it is 1'),
    filmLeast: field('f32', 'its thickness where that texture is 0'),
    dispersion: field('f32', '20 / Abbe number'),
    spare0: field('f32', 'unused'),
    spare1: field('f32', 'unused'),
    spare2: field('f32', 'unused'),
  },
  Emitter: {
    position: field(
      'vec3f',
      'eye-relative: centre of a sphere, box or mesh, corner of a quad, place of a point or spot light',
    ),
    kind: field('f32', '0 sphere, 1 quad, 2 box, 3 point, 4 spot, 5 directional, 6 sky, 7 triangles of a mesh'),
    u: field(
      'vec3f',
      'edge of a quad; unit direction that a spot shines to or directional light travels; halfSize of a box; mesh: in x the cosine of the cone about v that holds all normals, in y 1 where its material says how much of the radiance there is at a point',
    ),
    radius: field(
      'f32',
      'of a sphere; cosine of the outer angle of a spot; cosine of half the angular diameter of directional light; mesh: each 2^radius triangles of an instance are an emitter',
    ),
    v: field('vec3f', 'other edge of a quad; mean of the normals of a mesh, weighted by area'),
    cosInner: field(
      'f32',
      'cosine of the inner angle of a spot; mesh: how many emitters an instance is, one after the other',
    ),
    radiance: field(
      'vec3f',
      'radiance; of a point or spot: intensity; of directional light without angular size: irradiance',
    ),
    area: field(
      'f32',
      'of the surface that shines, m^2; of directional light: its solid angle, 0 without angular size',
    ),
    shape: field('f32', 'row of the shape that rays meet; -1: none, only light sampling finds it'),
    oneSided: field('f32', '1: a quad that shines to the side of u x v only, a mesh to the front of its triangles'),
    power: field('f32', 'for choosing among emitters: power / distance^2 estimates the irradiance in front of it'),
    reach: field('f32', 'radius of the bounding sphere; of directional light: sine of half the angular diameter'),
    leaf: field('f32', 'its place among the leaves of the light tree; -1: it is in none'),
    table: field('f32', 'mesh: row of its first triangle among the tables of lamps'),
    triangles: field('f32', 'mesh: how many'),
    instance: field('f32', 'mesh: of which instance'),
  },
  /** Rows of their own in the scene table: of four children side by side. light-tree.ts. */
  LightNode: {
    x: field('vec4f', 'of each child the centre of a sphere about its lights, eye-relative'),
    y: field('vec4f', 'y'),
    z: field('vec4f', 'z'),
    reach: field('vec4f', 'radius of the sphere'),
    axisX: field('vec4f', 'unit axis of the cone that holds all normals of the lights'),
    axisY: field('vec4f', 'y'),
    axisZ: field('vec4f', 'z'),
    cosWidth: field('vec4f', 'cosine of that cone, from its axis'),
    cosEdge: field('vec4f', 'cosine of the angle from a normal up to which there is light'),
    bothSides: field('vec4f', '1: also against the normals'),
    power: field('vec4f', 'sum of what Emitter has; 0: there is no such child'),
    emitters: field('vec4f', 'in the lowest nodes: which emitter the child is'),
  },
  // The geometry's: pack-geometry.ts.
  WideNode: {
    minX: field('vec4f', 'of each of up to four children the box: least x'),
    minY: field('vec4f', 'least y'),
    minZ: field('vec4f', 'least z'),
    maxX: field('vec4f', 'greatest x'),
    maxY: field('vec4f', 'greatest y'),
    maxZ: field('vec4f', 'greatest z'),
    children: field('vec4u', 'references: encode-wide-bvh.ts; 0: there is none'),
  },
  Triangle: {
    a: field('vec3f', 'first vertex, in the space of its mesh'),
    vertexA: field('u32', 'its number among the vertices of the mesh'),
    b: field('vec3f', 'second vertex'),
    vertexB: field('u32', 'its number'),
    c: field('vec3f', 'third vertex'),
    vertexC: field('u32', 'its number'),
  },
  Vertex: {
    normal: field('u32', 'shading normal, octahedral, 16 bits each'),
    tangent: field(
      'u32',
      'likewise; of the second number the lowest bit is 1 where the bitangent is -cross(normal, tangent)',
    ),
    uv: field('vec2f', 'texture coordinates of set 0'),
  },
  VertexMore: {
    redGreen: field('u32', 'linear colour, 16 bits each'),
    blueAlpha: field('u32', 'and opacity'),
    uv: field('vec2f', 'texture coordinates of set 1'),
  },
  Instance: {
    toMeshX: field('vec4f', 'from eye-relative places to the space of its mesh: x is dot(xyz, p) + w'),
    toMeshY: field('vec4f', 'y'),
    toMeshZ: field('vec4f', 'z'),
    nodes: field('u32', 'row of the root of its tree'),
    triangles: field('u32', 'row of its first triangle'),
    row: field('u32', 'of the scene table: what it is made of'),
    cover: field('u32', 'COVER: where it may not be there'),
    vertices: field('u32', 'row of its first vertex'),
    vertexRows: field('u32', 'of each vertex: Vertex, and VertexMore where that is 2; 0: the mesh has places only'),
    vertexFlags: field('u32', 'what is in them: VERTEX_FLAGS'),
    spare0: field('u32', 'unused'),
  },
  // The texels': pack-textures.ts.
  MaterialTextures: {
    count: field('u32', 'uses of textures: TextureUse, in the rows that follow'),
    flags: field('u32', 'MATERIAL_FLAGS'),
    opacity: field('f32', 'share of light that the surface takes part in'),
    cutoff: field('f32', 'opacity below which it is not there; negative: it is there as often as the opacity says'),
  },
  TextureUse: {
    toU: field('vec3f', 'u in the image is dot(toU, (u, v, 1)) of the coordinates'),
    slot: field('u32', 'what it is multiplied with: TEXTURE_SLOTS'),
    toV: field('vec3f', 'likewise v'),
    flags: field('u32', 'LOOKUP_FLAGS'),
    first: field('u32', 'texel of the image, of all texels'),
    width: field('u32', 'of the image, texels'),
    height: field('u32', 'of the image, texels'),
    scale: field('f32', 'of a normal map: factor on the first two components'),
  },
  LampTriangle: {
    own: field('f32', 'alias table: probability to take this triangle and not the other one'),
    place: field('u32', 'of this triangle, in the order of its mesh'),
    other: field('u32', 'place of the other one'),
    density: field('f32', 'how likely its points are: as a factor on 1 / area of the emitter'),
  },
  Frame: {
    right: field('vec3f', 'camera r times half the width of what is seen: camera.wesl'),
    width: field('f32', 'of the whole picture, pixels'),
    up: field('vec3f', 'camera u times half the height of what is seen'),
    height: field('f32', 'of the whole picture, pixels'),
    forward: field('vec3f', 'camera f'),
    lightCount: field('u32', 'lights in use'),
    horizon: field('vec3f', 'sky colour at the horizon; in paths the map of the sky is multiplied by it'),
    sampleIndex: field('u32', 'film sample, from 0'),
    zenith: field('vec3f', 'sky colour overhead; likewise'),
    seed: field('u32', 'of the random numbers'),
    jitter: field('vec2f', 'position inside the pixel, 0 to 1'),
    dividers: field('vec2f', 'columns of the picture where the second and third panel begin'),
    shapeEnds: field('vec4u', 'index past the last sphere, box, quad and plane'),
    occluderEnd: field('u32', 'index past the last shape that may stand between a light and a point'),
    ballCount: field('u32', 'balls of lights that camera and mirrors see; their rows come after those of the shapes'),
    emitterCount: field('u32', 'emitters of the path integrator'),
    maxDepth: field('u32', 'path segments from the camera on; 0xffffffff: no limit'),
    panels: field({ array: 'vec4u', length: PANELS }, 'per panel: max reflections, light samples, unused, unused'),
    filterPieces: field(
      { array: 'vec4f', length: FILTER_PIECES },
      'pixel filter: coefficients of cubic polynomials, from the centre of the pixel outwards',
    ),
    independent: field('u32', '1: independent random numbers instead of the Sobol sequence'),
    projection: field('u32', 'position in PROJECTIONS'),
    aperture: field('f32', 'radius of the lens, metres'),
    focusDistance: field('f32', 'from the eye to the plane that is sharp, metres'),
    planesCutView: field(
      'u32',
      '1: rays of the camera start on both sides of a plane, so that planes have no side of the eye',
    ),
    environmentTurn: field('f32', 'how far the map of the sky is turned about +Y, 0 to 1'),
    environmentSize: field('vec2f', 'columns and rows of the map of the sky'),
    sampleCount: field('u32', 'film samples that this call adds, from sampleIndex on; 1 where passes draw'),
    instances: field('u32', 'row of the first instance of a mesh; the tree over them begins in row 0'),
    shares: field('u32', 'threads that share the samples of a pixel'),
    tile: field('vec2u', 'pixels of a workgroup'),
    instanceCount: field('u32', 'instances of meshes'),
    farEmitters: field('u32', 'emitters that are infinitely far: they come first'),
    lightTree: field('u32', 'row of the root of the light tree'),
    rowHeight: field('f32', 'of the scene table, the whole table being 1'),
    geometryShare: field(
      'f32',
      'what one row is of the texture of the geometry, all of it being 1: gpu/device.ts, shareOfRow',
    ),
    texelShare: field('f32', 'of that of the texels'),
    lightTreeDepth: field('u32', 'levels of it; 0: there is none, and all emitters are looked at'),
    lampTables: field('u32', 'row of the geometry where the tables of lamps begin'),
    origin: field('vec2u', 'column and row of the picture that the first texel of the film holds'),
    relayRow: field('u32', 'row of the film whose paths lie in the first row of their textures: path_relay.wesl'),
  },
  Display: {
    exposure: field('f32', 'factor, 2^stops'),
    toneMapping: field('u32', 'position in TONE_MAPPINGS'),
    filmSize: field('vec2f', 'pixels'),
  },
  AovView: {
    kind: field('u32', '0 colour, 1 normal, 2 depth, 3 place, 4 number'),
    scale: field('f32', 'a typical distance, metres'),
    filmSize: field('vec2f', 'pixels'),
    forward: field('vec3f', 'camera f; zero: distances instead of depths'),
    middle: field('vec3f', 'from the eye to what is looked at'),
  },
} as const satisfies Record<string, Fields>;
export type StructName = keyof typeof STRUCTS;
export type FieldName<S extends StructName> = keyof (typeof STRUCTS)[S] & string;

const SCALARS = {
  f32: [4, 4],
  u32: [4, 4],
  vec2u: [8, 8],
  vec2f: [8, 8],
  vec3f: [12, 16],
  vec4f: [16, 16],
  vec4u: [16, 16],
} as const;
const roundUp = (n: number, to: number) => Math.ceil(n / to) * to;

/** Size and alignment in bytes by WGSL's rules for the uniform address space. */
function extent(type: FieldType): { size: number; align: number } {
  if (typeof type === 'string') return { size: SCALARS[type][0], align: SCALARS[type][1] };
  return { size: 16 * type.length, align: 16 };
}

function place(name: StructName): { offsets: Record<string, number>; size: number } {
  let at = 0;
  const offsets: Record<string, number> = {};
  for (const [key, { type }] of Object.entries(STRUCTS[name] as Fields)) {
    const { size, align } = extent(type);
    at = roundUp(at, align);
    offsets[key] = at;
    at += size;
  }
  return { offsets, size: roundUp(at, 16) };
}

const placed = new Map<StructName, { offsets: Record<string, number>; size: number }>();
function placement(name: StructName) {
  let p = placed.get(name);
  if (!p) placed.set(name, (p = place(name)));
  return p;
}

export function structSize(name: StructName): number {
  return placement(name).size;
}
/** Bytes from the start of the struct to the field. */
export function fieldOffset<S extends StructName>(name: S, field: FieldName<S>): number {
  return placement(name).offsets[field]!;
}

/** Words in a row of the geometry, and of the texels. */
export const GEOMETRY_ROW = 4;
/** Rows of a struct in either. */
export const geometryRows = (name: DataStruct): number => structSize(name) / 16;
const GEOMETRY_STRUCTS = ['WideNode', 'Triangle', 'Instance', 'Vertex', 'VertexMore', 'LampTriangle'] as const;

/**
 * In `Instance.cover`: a bit for triangles that are not there from behind, and in the other bits the row of the MaterialTextures that say
 * with which opacity the surface is there; 0: it is there everywhere.
 */
export const COVER = { isOneSided: 2 ** 31, coverRow: 2 ** 31 - 1 } as const;
/** Bits of `Instance.vertexFlags`. A vertex without normals or tangents has zeros there, one without colours white. */
export const VERTEX_FLAGS = { hasNormals: 1, hasTangents: 2 } as const;

const TEXEL_STRUCTS = ['MaterialTextures', 'TextureUse'] as const;
export type DataStruct = (typeof GEOMETRY_STRUCTS)[number] | (typeof TEXEL_STRUCTS)[number];
/** Texels of an image, 8 bits for each of red, green, blue and alpha from the lowest on, in a row of the data that holds them. */
export const TEXELS_OF_ROW = 4;
/** What a use of a texture changes, and by which channels: scene/material-layers.ts. */
export const TEXTURE_SLOTS = {
  baseColorSlot: 0,
  emissionSlot: 1,
  metallicRoughnessSlot: 2,
  normalSlot: 3,
  specularWeightSlot: 4,
  specularColorSlot: 5,
  transmissionSlot: 6,
  beyondSlot: 7,
  beyondColorSlot: 8,
  coatSlot: 9,
  coatRoughnessSlot: 10,
  sheenColorSlot: 11,
  sheenRoughnessSlot: 12,
  anisotropySlot: 13,
  filmSlot: 14,
  filmThicknessSlot: 15,
  coatNormalSlot: 16,
} as const;
/** Bits of `TextureUse.flags`. Without one of the wrap bits the image repeats. */
export const LOOKUP_FLAGS = {
  usesSecondSet: 1,
  isColor: 2,
  isNearest: 4,
  clampsU: 8,
  mirrorsU: 16,
  clampsV: 32,
  mirrorsV: 64,
} as const;
/**
 * Bits of `MaterialTextures.flags`: unlit surfaces have no colour but their light's, which the colours at vertices multiply; the first use
 * is of an image whose alpha is opacity.
 */
export const MATERIAL_FLAGS = { isUnlit: 1, hasOpacityTexture: 2 } as const;

/** Which structs share a row of the scene table, in this order from the left. */
const TABLE_STRUCTS = ['Bounds', 'Extent', 'Material', 'Light', 'Surface', 'Emitter'] as const;
/** Structs that have rows of the scene table for themselves, after those. */
const WHOLE_ROWS = ['Ball', 'LightNode', 'Layers'] as const;
export type TableStruct = (typeof TABLE_STRUCTS)[number] | (typeof WHOLE_ROWS)[number];

/** Texels (of 16 bytes) left of the struct in its row. */
export function tableColumn(name: TableStruct): number {
  let column = 0;
  if ((WHOLE_ROWS as readonly string[]).includes(name)) return column;
  for (const s of TABLE_STRUCTS) {
    if (s === name) break;
    column += structSize(s) / 16;
  }
  return column;
}
/** Texels in a row of the scene table. */
export const TABLE_WIDTH = TABLE_STRUCTS.reduce((sum, s) => sum + structSize(s) / 16, 0);

/** Number of the binding of `nearest`, the sampler through which WGSL reads the scene table: shading/table_texel.wesl. */
export const NEAREST_BINDING = 15;
/** How passes are told of the scene table. */
export const SCENE_TABLE = { texture: 'sceneTable', nearest: NEAREST_BINDING } as const;
/** The same sampler, where software reads them. */
export const GEOMETRY = { data: 'geometry', nearest: NEAREST_BINDING } as const;
export const TEXELS = { data: 'texels', nearest: NEAREST_BINDING } as const;

const FETCHED = [...TABLE_STRUCTS, ...WHOLE_ROWS];

const GENERATED = '// Written by `npm run shaders` from packed-scene/layout.ts. Do not edit.\n';

/** The structs as WGSL source, the content of `shading/layout.wesl`. */
export function structsWgsl(): string {
  const typeName = (t: FieldType) => (typeof t === 'string' ? t : `array<${t.array}, ${t.length}>`);
  const one = ([name, fields]: [string, Fields]) => {
    const lines = Object.entries(fields).map(([key, f]) => `  // ${f.doc}\n  ${key}: ${typeName(f.type)},`);
    return `struct ${name} {\n${lines.join('\n')}\n}\n`;
  };
  return `${GENERATED}\n// Texels in a row of the scene table.\nconst tableWidth = ${TABLE_WIDTH}.0;\n\n${Object.entries(
    STRUCTS,
  )
    .map(([k, v]) => one([k, v as Fields]))
    .join('\n')}`;
}

function fetchFunction(name: TableStruct): string {
  const texels = structSize(name) / 16;
  const loads = Array.from({ length: texels }, (_, t) => `  let t${t} = tableTexel(${tableColumn(name) + t}u, i);`);
  const parts = Object.entries(STRUCTS[name] as Fields).map(([key, { type }]) => {
    const offset = placement(name).offsets[key]!;
    const first = (offset % 16) / 4;
    return `t${Math.floor(offset / 16)}.${'xyzw'.slice(first, first + extent(type).size / 4)}`;
  });
  return `fn fetch${name}(i: u32) -> ${name} {\n${loads.join('\n')}\n  return ${name}(${parts.join(', ')});\n}\n`;
}

/** Fetched by the number of the row that it begins in. */
function fetchRowsFunction(name: DataStruct, fetchRow: string): string {
  const loads = Array.from({ length: geometryRows(name) }, (_, t) => `  let r${t} = ${fetchRow}(row + ${t}u);`);
  const parts = Object.entries(STRUCTS[name] as Fields).map(([key, { type }]) => {
    const offset = placement(name).offsets[key]!;
    const { size } = extent(type);
    const words = `r${Math.floor(offset / 16)}.${'xyzw'.slice((offset % 16) / 4, (offset % 16) / 4 + size / 4)}`;
    return type === 'u32' || type === 'vec4u' ? words : `bitcast<${type}>(${words})`;
  });
  return `fn fetch${name}(row: u32) -> ${name} {\n${loads.join('\n')}\n  return ${name}(${parts.join(', ')});\n}\n`;
}

/** The functions that read the geometry, the content of `shading/mesh/geometry_table.wesl`. */
export function fetchGeometryWgsl(): string {
  const imports = `import package::shading::mesh::geometry_row::geometryRow;\nimport package::shading::layout::{${GEOMETRY_STRUCTS.join(', ')}};\n`;
  const row = (field: FieldName<'WideNode'>) => fieldOffset('WideNode', field) / 16;
  const constants = [
    '// Rows of a node; from the rows of least to those of greatest places; and where the references are.',
    `const nodeRows = ${geometryRows('WideNode')}u;`,
    `const leastToGreatest = ${row('maxX') - row('minX')}u;`,
    `const childrenRow = ${row('children')}u;`,
    `const triangleRows = ${geometryRows('Triangle')}u;`,
    `const instanceRows = ${geometryRows('Instance')}u;`,
    `const vertexRows = ${geometryRows('Vertex')}u;`,
    ...Object.entries({ ...COVER, ...VERTEX_FLAGS }).map(([name, bit]) => `const ${name} = ${bit}u;`),
  ];
  const fetched = ['Triangle', 'Instance', 'Vertex', 'VertexMore', 'LampTriangle'] as const;
  const functions = fetched.map((name) => fetchRowsFunction(name, 'geometryRow'));
  return `${GENERATED}${imports}\n${constants.join('\n')}\n\n${functions.join('\n')}`;
}

/** The functions that read how textures are used, the content of `shading/texture/texture_table.wesl`. */
export function fetchTexturesWgsl(): string {
  const imports = `import package::shading::texture::texel_row::texelRow;\nimport package::shading::layout::{${TEXEL_STRUCTS.join(', ')}};\n`;
  const constants = [
    `const materialTexturesRows = ${geometryRows('MaterialTextures')}u;`,
    `const textureUseRows = ${geometryRows('TextureUse')}u;`,
    ...Object.entries({ ...TEXTURE_SLOTS, ...LOOKUP_FLAGS, ...MATERIAL_FLAGS }).map(
      ([name, number]) => `const ${name} = ${number}u;`,
    ),
  ];
  const functions = TEXEL_STRUCTS.map((name) => fetchRowsFunction(name, 'texelRow'));
  return `${GENERATED}${imports}\n${constants.join('\n')}\n\n${functions.join('\n')}`;
}

/** The functions that read the scene table, the content of `shading/scene_table.wesl`. */
export function fetchWgsl(): string {
  const imports = `import package::shading::table_texel::tableTexel;\nimport package::shading::layout::{${FETCHED.join(', ')}};\n`;
  return `${GENERATED}${imports}\n${FETCHED.map(fetchFunction).join('\n')}`;
}
