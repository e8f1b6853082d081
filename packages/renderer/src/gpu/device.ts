/**
 * The device seam: the few things that the renderer asks of a GPU. Everything above speaks this and reads limits; nobody asks
 * which interface it is on. A stage is a `Pass` that draws one full-screen triangle into a film or the canvas.
 */
import type { Backend } from '../renderer-types.ts';

/** A device that is missing, too small or gone. `limit`, `available` and `needed` are set when a limit is the reason. */
export class DeviceError extends Error {
  override readonly name = 'DeviceError';
  readonly limit: string | undefined;
  readonly available: number | undefined;
  readonly needed: number | undefined;
  constructor(message: string, limit?: { limit: string; available: number; needed: number }) {
    super(message);
    this.limit = limit?.limit;
    this.available = limit?.available;
    this.needed = limit?.needed;
  }
}

/**
 * The same work as a compute pass: after the bindings come the region (first row, columns and rows, as vec3u), the layers of the film
 * as storage textures and, as data that is written too, room for a row of each film sample.
 */
export interface ComputeSource {
  readonly wgsl: string;
  readonly entry: string;
  /** Another entry that comes after it, of workgroups of 8 × 8 pixels: adds the samples to the film. */
  readonly adding: string;
}

/**
 * What a pass reads. `nearest`: number of the binding of a sampler that takes the texel nearest to a point, when WGSL reads the texture
 * through one, or, in software, the data; GLSL has none of its own.
 */
export type PassBinding =
  | { readonly block: string }
  | { readonly texture: string; readonly nearest?: number }
  | { readonly data: string; readonly nearest?: number };

/** A shader program and what it reads, in both languages. Names of textures, blocks and data are those of the WGSL source. */
export interface PassSource {
  readonly label: string;
  /**
   * WGSL of the vertex and of the fragment entry; the same text when one module holds both. `sampled`: the fragment entry for devices
   * whose data are textures of floats that a sampler reads; needed if it reads data.
   */
  readonly wgsl: { readonly vertex: string; readonly fragment: string; readonly sampled?: string };
  readonly entries: { readonly vertex: string; readonly fragment: string };
  readonly glsl: { readonly vertex: string; readonly fragment: string };
  /** In the order of their binding numbers in group 0. */
  readonly bindings: readonly PassBinding[];
  readonly target: 'film' | 'canvas';
  /** What the switches (`override` in the WGSL) are in this program; those that the module does not have are ignored. */
  readonly switches?: Readonly<Record<string, boolean>>;
  /** Taken instead of drawing where the device has compute passes. */
  readonly compute?: ComputeSource | undefined;
  /** Layers of the film that it draws into, each by an output of its own; 1 when left out. */
  readonly layers?: number;
}

/** What one language needs of it. */
export type GlslSource = Pick<PassSource, 'label' | 'glsl' | 'bindings' | 'switches'>;

export interface Pass {
  readonly label: string;
  /** Whether one call may add many film samples: `frame.sampleCount`. */
  readonly addsMany: boolean;
}
export interface UniformBuffer {
  write(bytes: ArrayBuffer): void;
  destroy(): void;
}
/** A texture of RGBA float32 texels. */
export interface FloatTexture {
  readonly width: number;
  readonly height: number;
  /** Never there: so that a whole film, which has layers, is no texture to TypeScript. */
  readonly layers?: never;
  destroy(): void;
}
/** A texture that the CPU fills. */
export interface TableTexture extends FloatTexture {
  /** Replaces the first `rows` rows. */
  write(texels: Float32Array<ArrayBuffer>, rows: number): void;
}
/** Rows of four words that kernels read by number: a storage buffer, or a texture of DATA_COLUMNS columns. */
export interface DataBuffer {
  readonly rows: number;
  /** Replaces as many rows as the words fill, from this one on. */
  write(firstRow: number, words: Uint32Array<ArrayBuffer>): void;
  destroy(): void;
}
/** What passes draw into: one texture or several of the same size, to be read by passes one by one. */
export interface FilmTexture {
  readonly width: number;
  readonly height: number;
  readonly layers: readonly FloatTexture[];
  destroy(): void;
}
/** As shading/mesh/geometry_row.wesl and shading/texture/texel_row.wesl have it: every device has textures so wide. */
export const DATA_COLUMNS = 2048;
/** What one row is of such a texture, all of its lines together being 1. */
export const shareOfRow = ({ rows }: Pick<DataBuffer, 'rows'>): number =>
  1 / (Math.ceil(rows / DATA_COLUMNS) * DATA_COLUMNS);
/** Writes rows from `firstRow` on into such a texture: rectangles of it, and the words of each. */
export function writeLines(
  firstRow: number,
  words: Uint32Array<ArrayBuffer>,
  put: (x: number, y: number, width: number, height: number, words: Uint32Array<ArrayBuffer>) => void,
): void {
  const end = firstRow + words.length / 4;
  // What is left of the first line, whole lines, what begins the last one.
  for (let row = firstRow; row < end; ) {
    const [x, y] = [row % DATA_COLUMNS, Math.floor(row / DATA_COLUMNS)];
    const left = DATA_COLUMNS - x;
    const lines = x === 0 ? Math.floor((end - row) / DATA_COLUMNS) : 0;
    const count = lines > 0 ? lines * DATA_COLUMNS : Math.min(left, end - row);
    const part = words.subarray(4 * (row - firstRow), 4 * (row - firstRow + count));
    put(x, y, lines > 0 ? DATA_COLUMNS : count, Math.max(lines, 1), part);
    row += count;
  }
}
export type Resource = UniformBuffer | FloatTexture | DataBuffer;

/** The part of a film that is in use, from its first column and row, and which of its rows to draw now. */
export interface Region {
  readonly width: number;
  readonly height: number;
  readonly firstRow: number;
  readonly rowCount: number;
  /** For compute passes: film samples of each pixel, and pixels of a workgroup. */
  readonly samples?: number;
  readonly tile?: readonly [width: number, height: number];
}
/** A rectangle of pixels, (x, y) its top left corner. */
export interface FilmArea {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/**
 * Compute programs that work on data alone. `data`: in the order of their binding numbers in group 0, whether each is only read; after them
 * comes a vec4u: the two numbers of the step.
 */
export interface KernelSource {
  readonly label: string;
  readonly wgsl: string;
  readonly entries: readonly string[];
  /** Values of what the text leaves open. */
  readonly constants?: Readonly<Record<string, number>>;
  readonly data: readonly ('read' | 'write')[];
}
export interface Kernels {
  readonly label: string;
}
/** `groups` workgroups of one entry, which are told `first` and how many they are. They may stand in rows, with some too many in the last. */
export interface KernelStep {
  readonly entry: string;
  readonly first: number;
  readonly groups: number;
}
/** Steps, one after the other, with what they read and write. */
export interface Work {
  destroy(): void;
}
export interface Compute {
  /** Rows of the largest data. */
  readonly maxRows: number;
  /** Of a workgroup. */
  readonly maxThreads: number;
  /** Rejects with `DeviceError` when the driver refuses. */
  createKernels(source: KernelSource): Promise<Kernels>;
  /** Once for many runs. The data must outlive it. */
  prepare(kernels: Kernels, data: readonly DataBuffer[], steps: readonly KernelStep[]): Work;
  /** Done before anything is drawn or read next, with what the data hold then. Asked for twice until then, it is done once. */
  run(work: Work): void;
  read(data: DataBuffer, firstRow: number, rows: number): Promise<Uint32Array<ArrayBuffer>>;
}

/**
 * For a long program that is run as several: passes that keep words of each pixel for one another. They are drawn as all others are.
 */
export interface Relay {
  /** Whether it pays: where the driver's compiler takes seconds for a long program. */
  readonly pays: boolean;
  /** Rejects with `DeviceError` when the driver refuses. */
  createPass(source: GlslSource): Promise<Pass>;
  /** Layers of four words of 32 bits a texel. */
  createWords(width: number, height: number, layers: number): FilmTexture;
  /** Draws, and resolves when all so far is done: with whether this pass drew any pixel at all. */
  drawAsking(pass: Pass, target: FilmTexture, resources: readonly Resource[], region: Region): Promise<boolean>;
}

/** What exists on the device now, for leak tests, and how many programs were ever made. */
export interface DeviceCounts {
  buffers: number;
  textures: number;
  programsMade: number;
}

export interface Device {
  readonly backend: Exclude<Backend, 'cpu'>;
  /** What draws, in words. */
  readonly description: string;
  /** Largest width and height of a film, pixels. */
  readonly maxTextureSize: number;
  /** Samples that its films can sum up before rounding shows. */
  readonly maxFilmSamples: number;
  readonly counts: Readonly<DeviceCounts>;
  /** Null where there are no compute passes, or where they are no faster than the CPU. */
  readonly compute: Compute | null;
  /** Null where passes have no words of their own, or no use for them. */
  readonly relay: Relay | null;
  /** Compiles without blocking the page where the browser can. Rejects with `DeviceError` when the driver refuses. */
  createPass(source: PassSource): Promise<Pass>;
  /** Takes the canvas for good, if that was not needed to open the device: call it when everything needed compiles. */
  attach(): void;
  createUniforms(byteLength: number): UniformBuffer;
  createTable(width: number, height: number): TableTexture;
  /** Throws a `DeviceError` when there is no room for so many rows; `what` they hold, in the plural, is for its message. */
  checkData(rows: number, what: string): void;
  /** Throws as `checkData` does. */
  createData(rows: number, what: string): DataBuffer;
  createFilm(width: number, height: number, layers?: number): FilmTexture;
  /** Draws over the whole canvas, or a region of a film. Returns at once; see `finished`. */
  draw(pass: Pass, target: FilmTexture | 'canvas', resources: readonly Resource[], region?: Region): void;
  /** Resolves when all that was drawn so far is done, and not before an earlier call does. */
  finished(): Promise<void>;
  /** RGBA float32 of the first columns and rows of a layer, row 0 first. */
  read(layer: FloatTexture, width: number, height: number): Promise<Float32Array<ArrayBuffer>>;
  /** The other way: puts RGBA float32 texels into the first columns and rows of a layer of a film. */
  write(layer: FloatTexture, texels: Float32Array<ArrayBuffer>, width: number, height: number): void;
  /** Makes all layers of a film zero. */
  clear(film: FilmTexture): void;
  /** Resolves with the reason when the device is lost, not when it is destroyed on purpose. */
  readonly lost: Promise<string>;
  /** After a loss: a new device on the same canvas. Rejects with `DeviceError` when there is none. */
  reopen(): Promise<Device>;
  destroy(): void;
}

export function checkFilmSize(device: Device, width: number, height: number): void {
  const needed = Math.max(width, height);
  if (needed <= device.maxTextureSize) return;
  throw new DeviceError(
    `A film of ${width} × ${height} pixels was asked for; this device draws at most ${device.maxTextureSize} along a side.`,
    { limit: 'maxTextureSize', available: device.maxTextureSize, needed },
  );
}

/** Throws a `DeviceError` when the device has no textures of as many rows as a scene table needs. */
export function checkTableRows(device: Device, rows: number): void {
  if (rows <= device.maxTextureSize) return;
  throw new DeviceError(
    `The shapes, lights and layered materials of this scene need a table of ${rows} rows; this device has at most ${device.maxTextureSize} (maxTextureSize).`,
    { limit: 'maxTextureSize', available: device.maxTextureSize, needed: rows },
  );
}

/** `available` and `needed` bytes. */
export function noRoom(what: string, limit: string, available: number, needed: number): DeviceError {
  const mebibytes = (bytes: number) => `${(bytes / 2 ** 20).toFixed(1)} MiB`;
  return new DeviceError(
    `The ${what} of this scene need ${mebibytes(needed)}; this device has room for ${mebibytes(available)} (${limit}).`,
    { limit, available, needed },
  );
}
