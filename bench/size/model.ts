/** A large model with textures, made here as nobody commits such files: bumpy ground with a colour map and a normal map, one binary file. */
import { encode } from 'fast-png';

/** Squares along each side; two triangles each. */
export const GRID = [1050, 525] as const;
const TEXTURE = 2048;

/** Smooth hills with bumps down to a few squares, of height 1 at most; u and v: 0 … 1. */
function height(u: number, v: number): number {
  let sum = 0;
  for (let k = 0, scale = 3, share = 0.5; k < 6; k++, scale *= 2.3, share *= 0.45)
    sum += share * Math.sin(scale * (u * 6 + k) + Math.cos(scale * 3 * v)) * Math.cos(scale * 2.7 * v + k);
  return sum;
}

/** Places, normals, texture coordinates and indices of a sheet 10 × 5 wide. */
function sheet(columns: number, rows: number) {
  const count = (columns + 1) * (rows + 1);
  const positions = new Float32Array(3 * count);
  const normals = new Float32Array(3 * count);
  const uvs = new Float32Array(2 * count);
  const step = 1e-4;
  for (let j = 0, vertex = 0; j <= rows; j++)
    for (let i = 0; i <= columns; i++, vertex++) {
      const [u, v] = [i / columns, j / rows];
      const y = height(u, v);
      const slope = [(height(u + step, v) - y) / (10 * step), (height(u, v + step) - y) / (5 * step)] as const;
      const length = Math.hypot(slope[0], 1, slope[1]);
      positions.set([10 * u, y, 5 * v], 3 * vertex);
      normals.set([-slope[0] / length, 1 / length, -slope[1] / length], 3 * vertex);
      uvs.set([4 * u, 2 * v], 2 * vertex);
    }
  const indices = new Uint32Array(6 * columns * rows);
  for (let j = 0, at = 0; j < rows; j++)
    for (let i = 0; i < columns; i++, at += 6) {
      const a = j * (columns + 1) + i;
      const c = a + columns + 1;
      indices.set([a, c, a + 1, c, c + 1, a + 1], at);
    }
  return { positions, normals, uvs, indices };
}

/** A texture as PNG: RGB bytes of each texel's place. */
function picture(side: number, colorAt: (x: number, y: number) => readonly number[]): Uint8Array {
  const data = new Uint8Array(3 * side * side);
  for (let y = 0, at = 0; y < side; y++)
    for (let x = 0; x < side; x++, at += 3) data.set(colorAt(x / side, y / side), at);
  return encode({ width: side, height: side, channels: 3, depth: 8, data });
}

const wave = (x: number): number => 0.5 + 0.5 * Math.sin(2 * Math.PI * x);

/** Stripes and specks, so that the file is as large as those of photographs are. */
const colors = (x: number, y: number): number[] => {
  const speck =
    (Math.imul(Math.floor(x * TEXTURE) * 73856093, 19349663) ^ Math.imul(Math.floor(y * TEXTURE), 83492791)) >>> 24;
  const base = [wave(8 * x + wave(4 * y)), wave(5 * y + 0.3 * wave(9 * x)), wave(16 * (x + y))];
  return base.map((share) => Math.round(60 + 150 * share + speck / 8));
};

const bumps = (x: number, y: number): number[] => {
  const [a, b] = [0.3 * Math.cos(2 * Math.PI * 32 * x), 0.3 * Math.cos(2 * Math.PI * 24 * y)];
  const length = Math.hypot(a, b, 1);
  return [a / length, b / length, 1 / length].map((share) => Math.round(127.5 + 127.5 * share));
};

/** A GLB of 2 · columns · rows triangles. */
export function makeModel([columns, rows]: readonly [number, number] = GRID): Uint8Array {
  const { positions, normals, uvs, indices } = sheet(columns, rows);
  const pngs = [picture(TEXTURE, colors), picture(TEXTURE, bumps)];
  const chunks = [positions, normals, uvs, indices, ...pngs].map(
    ({ buffer, byteOffset, byteLength }) => new Uint8Array(buffer, byteOffset, byteLength),
  );
  let end = 0;
  const bufferViews = chunks.map(({ byteLength }) => {
    const view = { buffer: 0, byteOffset: end, byteLength };
    end += Math.ceil(byteLength / 4) * 4;
    return view;
  });
  const count = positions.length / 3;
  const floats = (bufferView: number, type: string, more = {}) => ({
    bufferView,
    componentType: 5126,
    count,
    type,
    ...more,
  });
  return glb(
    {
      asset: { version: '2.0' },
      scene: 0,
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0 }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, indices: 3, material: 0 }] }],
      materials: [
        {
          pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0, roughnessFactor: 0.6 },
          normalTexture: { index: 1 },
        },
      ],
      textures: [{ source: 0 }, { source: 1 }],
      images: [4, 5].map((bufferView) => ({ bufferView, mimeType: 'image/png' })),
      buffers: [{ byteLength: end }],
      bufferViews,
      accessors: [
        floats(0, 'VEC3', { min: [0, -2, 0], max: [10, 2, 5] }),
        floats(1, 'VEC3'),
        floats(2, 'VEC2'),
        { bufferView: 3, componentType: 5125, count: indices.length, type: 'SCALAR' },
      ],
    },
    chunks,
    end,
  );
}

/** The binary form of glTF: a head of 12 bytes, then JSON and numbers, each with its length and kind before it. */
function glb(json: object, chunks: readonly Uint8Array[], size: number): Uint8Array {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const textSize = Math.ceil(text.length / 4) * 4;
  const file = new Uint8Array(28 + textSize + size);
  const words = new DataView(file.buffer);
  for (const [i, word] of [0x46546c67, 2, file.length, textSize, 0x4e4f534a].entries())
    words.setUint32(4 * i, word, true);
  file.fill(32, 20, 20 + textSize).set(text, 20);
  words.setUint32(20 + textSize, size, true);
  words.setUint32(24 + textSize, 0x004e4942, true);
  let at = 28 + textSize;
  for (const chunk of chunks) {
    file.set(chunk, at);
    at += Math.ceil(chunk.length / 4) * 4;
  }
  return file;
}
